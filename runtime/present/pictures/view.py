"""What every picture of one motion needs: points, labels, times in configurations."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import Units, shown_name, symbol, units_of
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
    """A motion with its sampled points, as all its pictures need it.

    Each transition has two points: before and behind it.
    """

    trajectory: Trajectory
    times: np.ndarray  # (n,)
    states: np.ndarray  # (n, N)
    masses: tuple[int, ...]  # that are drawn, from 0
    orbit: Orbit | None = None  # whose motion it is; start and end are not marked then
    name: str = ""  # in the title, instead of the system's and the number of transitions
    composed: bool = False  # whether the picture is one part of several

    @property
    def kernels(self) -> SystemKernels | None:
        """Kernels of the system if they are known."""
        return self.trajectory.system.structure.kernels if self.orbit is None else self.orbit.system

    @property
    def units(self) -> Units:
        """Units that the system declares."""
        return units_of(self.kernels or self.trajectory.name)

    @property
    def portraits(self) -> int:
        """Number of phase portraits in a new figure."""
        return len(self.masses)

    @property
    def coordinates(self) -> tuple[tuple[int, int], ...]:
        """Indices of position and velocity of every mass; see `coordinates_of`."""
        return coordinates_of(self.trajectory)

    @property
    def oscillates(self) -> bool:
        """Whether the states are positions and velocities, not those of a first-order system."""
        return bool(self.trajectory.structure.coordinates)

    @property
    def end(self) -> float:
        """Time at which the motion ends; 1 if it takes no time."""
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
        """Indices and labels of the states drawn as positions, or as velocities if `moving`.

        Several positions, as those of a mass and a slider, may have one velocity.
        """
        labels = self.velocities if moving else self.positions
        states = [self.coordinates[mass][moving] for mass in self.masses]
        return list(zip(states, labels, strict=True))

    def noun(self, *, moving: bool) -> str:
        """The kind of the states drawn as positions, or as velocities if `moving`.

        It is "position", "velocity" or "state".
        """
        return "state" if not self.oscillates else "velocity" if moving else "position"

    @property
    def present(self) -> list[int]:
        """Configurations that last for some time, in the order in which they first occur."""
        run = self.trajectory.run
        lasting = np.diff(run.times, append=self.trajectory.end) > 0
        found = run.configurations[lasting] if lasting.any() else run.configurations
        return list(dict.fromkeys(found.tolist()))

    @property
    def title(self) -> str:
        """Title of the picture; empty if it is one part of several."""
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
        """Begin and length of each phase in a configuration, in the system's unit of time."""
        run = self.trajectory.run
        ends = np.append(run.times[1:], self.trajectory.end)
        here = (run.configurations == configuration) & (ends > run.times)
        return list(zip(run.times[here], (ends - run.times)[here], strict=True))

    def shares(self) -> tuple[np.ndarray, np.ndarray]:
        """Edges (n + 1,) of bins, and the share of time (n, present) in each configuration.

        The edges are in the system's unit of time. The configurations are those of `present`.
        """
        run = self.trajectory.run
        breaks = np.append(run.times, self.trajectory.end)
        edges = np.linspace(0, self.end, BINS + 1)
        spent = np.diff(breaks)[:, None] * (run.configurations[:, None] == self.present)
        until = np.concatenate([np.zeros((1, len(self.present))), np.cumsum(spent, axis=0)])
        columns = [np.diff(np.interp(edges, breaks, column)) for column in until.T]
        return edges, np.stack(columns, axis=-1) / np.diff(edges)[:, None]


def coordinates_of(trajectory: Trajectory) -> tuple[tuple[int, int], ...]:
    """Indices of position and velocity of every mass.

    States without a velocity are paired with their neighbours.
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
    """A motion with points as dense as a picture needs them, at least about `points`.

    The masses count from 0; `orbit` is the one that the motion runs along, and `name` is
    shown above the picture. `InputError` is raised if the motion is not finite, or beyond
    what axes hold.
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
    """Radians of the fastest oscillation that occurs in the motion."""
    present = np.unique(trajectory.run.configurations).tolist()
    return trajectory.end * max(fastest(trajectory.system, c) for c in present)
