"""One-contact solutions for any stiffness in contact: a route of its own.

It takes nothing from the derivation or the kernels. In modal coordinates a velocity that
vanishes halfway through a phase is linear in the start (1, y, u, w); the four conditions of
both phases have a solution where their determinant with the right-hand side vanishes. All
its zeros in 0 < tau < T are found on a grid and refined.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

__all__ = ["ContactOrbit", "contact_orbits"]

_GRID, _SAMPLES = 4000, 4001
_ROUNDING = 1e-9


@dataclass(frozen=True)
class ContactOrbit:
    """A solution of the half-phase conditions, and the reason why it is no motion, if any."""

    tau: float  # duration of the contact
    y: float  # second position at the beginning of the contact
    u: float  # first velocity there
    w: float  # second velocity there
    failure: str  # empty if the solution is a motion

    @property
    def admissible(self) -> bool:
        """Whether the solution is a motion."""
        return not self.failure


def contact_orbits(data: Mapping[str, float], last_entry: float) -> tuple[ContactOrbit, ...]:
    """All one-contact solutions with a given entry K1[2, 2] of the contact stiffness.

    `data` has m1, m2, k1, k2, k3 and the period T, in the same consistent units as the
    entry. The solutions are ordered by the duration of contact.
    """
    from scipy.optimize import brentq

    k1, k3, period = data["k1"], data["k3"], data["T"]
    mass = np.array([data["m1"], data["m2"]])
    free = _ModalMotion(mass, np.array([[k1, -k1], [-k1, k1 + data["k2"]]]), np.zeros(2))
    stiffness = np.array([[k1 + k3, -k1], [-k1, last_entry]])
    contact = _ModalMotion(mass, stiffness, np.linalg.solve(stiffness, [k3, 0.0]))

    def conditions(tau: float) -> np.ndarray:
        """Matrix (4, 4) on (y, u, w, 1) of the velocities that have to vanish.

        They are those halfway through contact, then those halfway through free motion.
        """
        reflected = np.diag([1.0, 1.0, -1.0, -1.0])
        upper = contact.velocity_rows(tau / 2)
        lower = free.velocity_rows((period - tau) / 2)
        lower = np.column_stack([lower[:, :4] @ reflected, lower[:, 4]])
        rows = np.vstack([upper, lower])
        return np.column_stack([rows[:, 1:4], rows[:, 0] + rows[:, 4]])

    def determinant(tau: float) -> float:
        return float(np.linalg.det(conditions(tau)))

    grid = np.linspace(0, period, _GRID + 2)[1:-1]
    values = np.array([determinant(tau) for tau in grid])
    found = []
    for k in np.flatnonzero(values[1:] * values[:-1] < 0):
        tau = float(brentq(determinant, grid[k], grid[k + 1], xtol=1e-14))
        rows = conditions(tau)
        y, u, w = np.linalg.lstsq(rows[:, :3], -rows[:, 3], rcond=None)[0]
        start = np.array([1.0, y, u, w])
        failure = _failure(contact, free, start, tau, period)
        found.append(ContactOrbit(tau, float(y), float(u), float(w), failure))
    return tuple(found)


class _ModalMotion:
    """Solution of ``x'' = -M^-1 K (x - d)`` by modes."""

    def __init__(self, mass: np.ndarray, stiffness: np.ndarray, centre: np.ndarray) -> None:
        root = np.sqrt(mass)
        squares, vectors = np.linalg.eigh(stiffness / np.outer(root, root))
        self.frequencies = np.sqrt(squares)
        self.shapes = vectors / root[:, None]
        self.inverse = vectors.T * root
        self.centre = centre

    def _mix(self, factors: np.ndarray) -> np.ndarray:
        return np.asarray((self.shapes * factors) @ self.inverse)

    def velocity_rows(self, time: float) -> np.ndarray:
        """Rows (2, 5) that give the velocities after a time, on the start and a constant."""
        w = self.frequencies
        by_position, by_velocity = self._mix(-w * np.sin(w * time)), self._mix(np.cos(w * time))
        return np.column_stack([by_position, by_velocity, -by_position @ self.centre])

    def positions(self, times: np.ndarray, start: np.ndarray) -> np.ndarray:
        """Positions (n,) of the first mass at times (n,)."""
        phases = np.outer(times, self.frequencies)
        shifted, rates = self.inverse @ (start[:2] - self.centre), self.inverse @ start[2:]
        modes = shifted * np.cos(phases) + rates / self.frequencies * np.sin(phases)
        return np.asarray(modes @ self.shapes[0] + self.centre[0])


def _failure(
    contact: _ModalMotion, free: _ModalMotion, start: np.ndarray, tau: float, period: float
) -> str:
    during = contact.positions(np.linspace(0, tau, _SAMPLES), start)
    if during.min() < 1 - _ROUNDING:
        return f"$x_1$ falls to {during.min():.4g} in contact"
    reflected = start * [1, 1, -1, -1]
    outside = free.positions(np.linspace(0, period - tau, _SAMPLES), reflected)
    if outside.max() > 1 + _ROUNDING:
        return f"$x_1$ rises to {outside.max():.4g} in free motion"
    return ""
