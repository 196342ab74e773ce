"""Frequency responses of two masses with a unilateral spring, with NumPy and SciPy alone.

The oscillator is example 03 of NLvib: a chain of two unit masses and springs, the second one tied
to a wall, dampers of 0.03, a force 0.1 cos(Omega t) on the second mass, and behind a gap of 1 a
spring of stiffness 100 beside the first. Harmonic balance with alternating frequency and time
domains (Krack and Gross, 2019) and shooting with `solve_ivp` are followed by pseudo-arclength.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.integrate import solve_ivp

MASS = np.eye(2)
STIFFNESS = np.array([[1.0, -1.0], [-1.0, 2.0]])
DAMPING = 0.03 * STIFFNESS
FORCE, SPRING, GAP = 0.1, 100.0, 1.0


@dataclass(frozen=True)
class HarmonicBalance:
    """Fourier coefficients of a periodic motion as unknowns.

    They are the constants of both masses, then cosines and sines of each harmonic, and
    Omega at last.
    """

    harmonics: int  # number of harmonics that are kept
    samples: int  # instants of a period at which the spring's force is evaluated

    @cached_property
    def series(self) -> np.ndarray:
        """Values of the base functions at the samples."""
        return self._base(2 * np.pi * np.arange(self.samples) / self.samples)

    @cached_property
    def projection(self) -> np.ndarray:
        """Matrix that gives the coefficients of a function from its values at the samples."""
        weights = np.full(2 * self.harmonics + 1, 2 / self.samples)
        weights[0] /= 2
        return weights[:, None] * self.series.T

    def _base(self, phases: np.ndarray) -> np.ndarray:
        angles = np.outer(phases, np.arange(1, self.harmonics + 1))
        waves = np.stack([np.cos(angles), np.sin(angles)], axis=2).reshape(len(phases), -1)
        return np.hstack([np.ones((len(phases), 1)), waves])

    def start(self, motion: np.ndarray, omega: float) -> np.ndarray:
        """Unknowns of a motion (2, samples) that is given over a period."""
        return np.append((self.projection @ motion.T).ravel(), omega)

    def motion(self, unknowns: np.ndarray, phases: np.ndarray) -> np.ndarray:
        """Positions (2, phases) of a solution."""
        return (self._base(phases) @ unknowns[:-1].reshape(-1, 2)).T

    def residual(self, unknowns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Balance of each harmonic, and its derivatives by the unknowns and Omega."""
        omega, coefficients = unknowns[-1], unknowns[:-1].reshape(-1, 2)
        count = len(coefficients)
        linear, slope = np.zeros((2, 2 * count, 2 * count))
        linear[:2, :2] = STIFFNESS
        for k in range(1, self.harmonics + 1):
            here = slice(4 * k - 2, 4 * k + 2)
            turn = k * omega * DAMPING
            still = STIFFNESS - (k * omega) ** 2 * MASS
            linear[here, here] = np.block([[still, turn], [-turn, still]])
            still, turn = -2 * k**2 * omega * MASS, k * DAMPING
            slope[here, here] = np.block([[still, turn], [-turn, still]])
        deeper = self.series @ coefficients[:, 0] - GAP
        pushed = np.flatnonzero(deeper > 0)  # few samples: the others have no force
        residual = linear @ unknowns[:-1]
        residual[::2] += SPRING * self.projection[:, pushed] @ deeper[pushed]
        residual[3] -= FORCE
        by_omega = slope @ unknowns[:-1]
        linear[::2, ::2] += SPRING * self.projection[:, pushed] @ self.series[pushed]
        return residual, np.column_stack([linear, by_omega])


@dataclass(frozen=True)
class Shooting:
    """The state at the phase 0 of the force as unknowns, integrated by `solve_ivp`.

    They are positions and velocities (by the phase), then Omega.
    """

    tolerance: float  # relative; the absolute one is a hundredth of it

    def motion(self, unknowns: np.ndarray, phases: np.ndarray) -> np.ndarray:
        """Positions (2, phases) of a solution; phases ascend."""
        found = solve_ivp(
            _field,
            (0.0, 2 * np.pi),
            unknowns[:4],
            "DOP853",
            phases,
            args=(unknowns[-1],),
            rtol=self.tolerance,
            atol=self.tolerance / 100,
        )
        return np.asarray(found.y[:2])

    def residual(self, unknowns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """State after a period less that before it, and derivatives by the unknowns and Omega."""
        begin = np.hstack([unknowns[:4, None], np.eye(4, 5)])
        found = solve_ivp(
            _variational,
            (0.0, 2 * np.pi),
            begin.ravel(),
            "DOP853",
            args=(unknowns[-1],),
            rtol=self.tolerance,
            atol=self.tolerance / 100,
        )
        end = found.y[:, -1].reshape(4, 6)
        return end[:, 0] - unknowns[:4], end[:, 1:] - np.eye(4, 5)

    def multipliers(self, jacobian: np.ndarray) -> np.ndarray:
        """Floquet multipliers, from the Jacobian of `residual`."""
        return np.linalg.eigvals(jacobian[:, :4] + np.eye(4))


def _field(phase: float, state: np.ndarray, omega: float) -> np.ndarray:
    force = -STIFFNESS @ state[:2] - omega * DAMPING @ state[2:]
    force[0] -= SPRING * max(state[0] - GAP, 0.0)
    force[1] += FORCE * np.cos(phase)
    return np.concatenate([state[2:], force / omega**2])


def _variational(phase: float, flat: np.ndarray, omega: float) -> np.ndarray:
    columns = flat.reshape(4, 6)
    state, rate = columns[:, 0], _field(phase, columns[:, 0], omega)
    stiffness = STIFFNESS.copy()
    stiffness[0, 0] += SPRING * (state[0] > GAP)
    changes = np.empty((4, 6))
    changes[:, 0] = rate
    changes[:2, 1:] = columns[2:, 1:]
    changes[2:, 1:] = -(stiffness @ columns[:2, 1:] + omega * DAMPING @ columns[2:, 1:])
    changes[2:, 1:] /= omega**2
    changes[2:, 5] -= (2 * rate[2:] + DAMPING @ state[2:] / omega) / omega
    return changes.ravel()


def follow_both_ways(
    problem: HarmonicBalance | Shooting,
    start: np.ndarray,
    interval: tuple[float, float],
    step: float,
    inside: Callable[[np.ndarray], bool],
) -> np.ndarray:
    """Unknowns (points, n) along the branch through a start, from one end to the other.

    `start` (n,) is near a solution and is corrected at its Omega. The length of the
    interval of Omega is the unit of arclength, and the size of the unknowns is theirs;
    `step` is the largest step, and `inside` says whether a solution still belongs to the
    branch. RuntimeError says that there is no solution near the start.
    """
    fixed = np.zeros(len(start))
    fixed[-1] = 1.0
    first = _corrected(problem, start, fixed)
    if first is None:
        raise RuntimeError("no solution near the start")
    units = np.full(len(start), float(np.linalg.norm(first[:-1])))
    units[-1] = interval[1] - interval[0]
    ways = [list(_follow(problem, first, units, interval, step, inside, s)) for s in (-1, 1)]
    return np.array([*reversed(ways[0]), first, *ways[1]])


def _follow(
    problem: HarmonicBalance | Shooting,
    first: np.ndarray,
    units: np.ndarray,
    interval: tuple[float, float],
    largest: float,
    inside: Callable[[np.ndarray], bool],
    sign: int,
) -> Iterator[np.ndarray]:
    before = np.zeros(len(first))
    before[-1] = sign
    here, step = first, largest
    while True:
        _, jacobian = problem.residual(here)
        bordered = np.vstack([jacobian * units, before])
        tangent = np.linalg.solve(bordered, np.eye(len(here))[-1])
        tangent /= np.linalg.norm(tangent)
        while True:
            found = _corrected(problem, here + step * units * tangent, tangent / units)
            if found is not None and np.linalg.norm((found - here) / units) < 2 * step:
                break
            step /= 2
            if step < 1e-7 * largest:
                return
        if not interval[0] <= found[-1] <= interval[1] or not inside(found):
            return
        yield found
        here, before, step = found, tangent, min(largest, 1.5 * step)


def _corrected(
    problem: HarmonicBalance | Shooting, guess: np.ndarray, normal: np.ndarray
) -> np.ndarray | None:
    """The solution in the hyperplane through a guess, by Newton's method."""
    found = guess
    for _ in range(8):
        residual, jacobian = problem.residual(found)
        bordered = np.vstack([jacobian, normal])
        change = np.linalg.solve(bordered, np.append(-residual, normal @ (guess - found)))
        found = found + change
        if np.abs(change).max() < 1e-9 * max(1.0, np.abs(found).max()):
            return found
    return None
