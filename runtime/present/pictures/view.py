"""What every picture of one motion needs: points, labels, times in configurations."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, symbol
from nonsmooth.runtime.model.units import Units, units_of
from nonsmooth.runtime.simulation.phase_functions import fastest

if TYPE_CHECKING:
    from nonsmooth.runtime.model.kernels import SystemKernels
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["BINS", "MANY", "View", "coordinates_of", "view_of"]

MANY = 150  # transitions, or oscillations, that cannot be told apart any more
BINS = 500
_STEP = 0.1  # radians of the fastest oscillation between two points
_MOST_POINTS = 1_000_000
_LARGEST = 1e150  # state: sums of squares are doubles, and so are the ends of axes


@dataclass(frozen=True, eq=False)
class View:
    """What every picture of one motion needs: its points, each transition twice.

    Attributes
    ----------
    trajectory : Trajectory
    times, states : array (n,), (n, N)
    masses : tuple of int
        Which are drawn.
    orbit : Orbit or None
        Whose motion it is, without start and end.
    name : str
        Instead of the system's and the number of transitions.
    composed : bool
        Whether the picture is a part of several.
    """

    trajectory: Trajectory
    times: np.ndarray
    states: np.ndarray
    masses: tuple[int, ...]
    orbit: Orbit | None = None
    name: str = ""
    composed: bool = False

    @property
    def kernels(self) -> SystemKernels | None:
        """Those of the system, where they are known."""
        return self.trajectory.system.structure.kernels if self.orbit is None else self.orbit.system

    @property
    def units(self) -> Units:
        """Those that the system declares."""
        return units_of(self.kernels or self.trajectory.name)

    @property
    def portraits(self) -> int:
        """How many phase portraits a new figure has."""
        return len(self.masses)

    @property
    def coordinates(self) -> tuple[tuple[int, int], ...]:
        """Position and velocity of every mass, as states; neighbours where there are none."""
        return coordinates_of(self.trajectory)

    @property
    def oscillates(self) -> bool:
        """Whether there are positions and velocities, and not states of the first order."""
        return bool(self.trajectory.structure.coordinates)

    @property
    def end(self) -> float:
        """Time at which the motion ends; 1 if that is its start."""
        return self.trajectory.end or 1.0

    @property
    def positions(self) -> list[str]:
        """Labels of the positions that are drawn."""
        return [f"${symbol(self._name(mass, 0))}$" for mass in self.masses]

    @property
    def velocities(self) -> list[str]:
        """Labels of the velocities that are drawn: derivatives of the positions."""
        if not self.oscillates:
            return [f"${symbol(self._name(mass, 1))}$" for mass in self.masses]
        return [f"${symbol(self._name(mass, 0))}'$" for mass in self.masses]

    def _name(self, mass: int, which: int) -> str:
        return self.trajectory.names[self.coordinates[mass][which]]

    def drawn(self, *, moving: bool) -> list[tuple[int, str]]:
        """States that are drawn as positions, or as velocities, with their labels.

        Several positions, of a mass and a slider, may have one velocity.

        Parameters
        ----------
        moving : bool
            Whether velocities are drawn; else positions.

        Returns
        -------
        list of (int, str)
        """
        labels = self.velocities if moving else self.positions
        states = [self.coordinates[mass][moving] for mass in self.masses]
        return list(zip(states, labels, strict=True))

    def noun(self, *, moving: bool) -> str:
        """What these states are.

        Parameters
        ----------
        moving : bool
            Whether velocities are drawn; else positions.

        Returns
        -------
        {"position", "velocity", "state"}
        """
        return "state" if not self.oscillates else "velocity" if moving else "position"

    @property
    def present(self) -> list[int]:
        """Configurations in the order in which they first occur for some time."""
        run = self.trajectory.run
        lasting = np.diff(run.times, append=self.trajectory.end) > 0
        found = run.configurations[lasting] if lasting.any() else run.configurations
        return list(dict.fromkeys(found.tolist()))

    @property
    def title(self) -> str:
        """What the picture shows; empty in one part of several."""
        count = self.trajectory.transitions
        plural = "" if count == 1 else "s"
        text = self.name or f"{shown_name(self.trajectory.name)}, {count:,} transition{plural}"
        return "" if self.composed else text

    @property
    def many(self) -> bool:
        """Whether there are more transitions than can be told apart."""
        return self.trajectory.transitions > MANY

    @property
    def dense(self) -> bool:
        """Whether there are more oscillations than can be told apart."""
        return self.many or _angle(self.trajectory) > 2 * math.pi * MANY

    def bars(self, configuration: int) -> list[tuple[float, float]]:
        """Begin and length of each phase in a configuration.

        Parameters
        ----------
        configuration : int
            Its number.

        Returns
        -------
        list of (float, float)
            Times in the system's units.
        """
        run = self.trajectory.run
        ends = np.append(run.times[1:], self.trajectory.end)
        here = (run.configurations == configuration) & (ends > run.times)
        return list(zip(run.times[here], (ends - run.times)[here], strict=True))

    def shares(self) -> tuple[np.ndarray, np.ndarray]:
        """Edges (n + 1,) of bins, and the share of each spent in the present ones (n, present).

        Returns
        -------
        tuple of (array, array)
            Edges in the system's unit of time, and nondimensional shares.
        """
        run = self.trajectory.run
        breaks = np.append(run.times, self.trajectory.end)
        edges = np.linspace(0, self.end, BINS + 1)
        spent = np.diff(breaks)[:, None] * (run.configurations[:, None] == self.present)
        until = np.concatenate([np.zeros((1, len(self.present))), np.cumsum(spent, axis=0)])
        columns = [np.diff(np.interp(edges, breaks, column)) for column in until.T]
        return edges, np.stack(columns, axis=-1) / np.diff(edges)[:, None]


def coordinates_of(trajectory: Trajectory) -> tuple[tuple[int, int], ...]:
    """Position and velocity of every mass; neighbouring states where there is no velocity.

    Parameters
    ----------
    trajectory : Trajectory
        The motion.

    Returns
    -------
    tuple of (int, int)
        Numbers of the two states, for each mass.
    """
    structure = trajectory.structure
    if structure.coordinates:
        return structure.coordinates
    forced = {state for pair in structure.forcing for state in pair}
    free = [place for place in range(len(trajectory.names)) if place not in forced]
    return tuple(pairwise(free)) or ((free[0], free[0]),)


def view_of(
    trajectory: Trajectory,
    masses: tuple[int, ...],
    points: int,
    orbit: Orbit | None = None,
    name: str = "",
) -> View:
    """Points of a motion as dense as a picture needs them.

    Parameters
    ----------
    trajectory : Trajectory
        The motion.
    masses : tuple of int
        Numbers of the masses that are drawn, from 0.
    points : int
        About how many there are at least.
    orbit : Orbit, optional
        The orbit that the motion runs along.
    name : str, optional
        Shown above the picture.

    Returns
    -------
    View
        With the sampled states.

    Raises
    ------
    InputError
        If the motion is not finite, or beyond what axes hold.
    """
    if not (math.isfinite(trajectory.end) and np.isfinite(trajectory.states).all()):
        raise InputError("the motion is not finite")
    needed = min(_MOST_POINTS, math.ceil(_angle(trajectory) / _STEP))
    wanted = max(points, needed) if isinstance(points, int | np.integer) and points > 0 else points
    times, states = trajectory.sample(wanted)
    largest = max(trajectory.end, float(np.abs(states).max(initial=0)))
    if not largest <= _LARGEST:
        raise InputError(
            f"the motion has numbers of {largest:.3g}, beyond {_LARGEST:g}: no picture"
        )
    return View(trajectory, times, states, masses, orbit, name)


def _angle(trajectory: Trajectory) -> float:
    """Radians of the fastest oscillation that occurs."""
    present = np.unique(trajectory.run.configurations).tolist()
    return trajectory.end * max(fastest(trajectory.system, c) for c in present)
