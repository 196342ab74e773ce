"""What every picture of one motion needs: points, labels, times in configurations, levels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.naming import Units, shown_name, symbol, units_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise_at
from nonsmooth.runtime.model.structure import Structure, structure_of
from nonsmooth.runtime.orbits.motion import orbit_motion
from nonsmooth.runtime.present.pictures.drawing import chosen_masses, tex_number
from nonsmooth.runtime.simulation.phase_functions import fastest

if TYPE_CHECKING:
    from nonsmooth.runtime.model.kernels import SystemKernels
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.simulation.trajectory import Trajectory

MANY = 150  # transitions, or oscillations, that cannot be told apart any more
BINS = 500
_STEP = 0.1  # radians of the fastest oscillation between two points
_MOST_POINTS = 1_000_000
_LARGEST = 1e150  # state: sums of squares are doubles, and so are the ends of axes


Levels = Mapping[int, list[tuple[float, str]]]


@dataclass(frozen=True, eq=False)
class View:
    """A motion with its sampled points, as all its pictures need it.

    Each transition has two points: before and behind it.
    """

    name: str  # above the picture
    structure: Structure
    names: tuple[str, ...]  # of the states
    units: Units  # that the system declares
    masses: tuple[int, ...]  # that are drawn, from 0
    times: np.ndarray  # (n,)
    states: np.ndarray  # (n, N)
    breaks: np.ndarray  # (k + 1,): where each phase begins, and where the last one ends
    configurations: np.ndarray  # (k,): of the phases, as indices
    # values of a state, by its index, at which there is a boundary, each with the symbol of the
    # parameter that it equals, or an empty text
    levels: Levels
    dense: bool  # whether there are more oscillations than can be told apart
    orbit: Orbit | None = None  # whose motion it is; start and end are not marked then
    composed: bool = False  # whether the picture is one part of several

    @property
    def portraits(self) -> int:
        """Number of phase portraits in a new figure; an orbit with kernels has a single one."""
        return 1 if self.orbit is not None and self.orbit.problem.derived else len(self.masses)

    @property
    def coordinates(self) -> tuple[tuple[int, int], ...]:
        """Indices of position and velocity of every mass; see `coordinates_of`."""
        return coordinates_of(self.structure)

    @property
    def oscillates(self) -> bool:
        """Whether the states are positions and velocities, not those of a first-order system."""
        return bool(self.structure.coordinates)

    @property
    def end(self) -> float:
        """Time at which the motion ends; 1 if it takes no time."""
        return float(self.breaks[-1]) or 1.0

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
        return self.names[self.coordinates[mass][which]]

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

    def levels_of(self, drawn: Iterable[tuple[int, str]]) -> dict[float, str]:
        """Values, with labels, of boundaries that depend on one of the drawn states alone."""
        found = dict[float, list[str]]()
        for state, label in drawn:
            for level, name in self.levels.get(state, ()):
                text = f"${name}$" if name else f"{label} = ${tex_number(level)}$"
                found.setdefault(level, []).append(text)
        return {level: "\n".join(dict.fromkeys(texts)) for level, texts in found.items()}

    @property
    def present(self) -> list[int]:
        """Configurations in the order in which they first occur.

        Of a motion that is no orbit these are the ones that last for some time.
        """
        lasting = np.diff(self.breaks) > 0
        if self.orbit is not None or not lasting.any():
            lasting[:] = True
        return list(dict.fromkeys(self.configurations[lasting].tolist()))

    @property
    def title(self) -> str:
        """Title of the picture; empty if it is one part of several."""
        return "" if self.composed else self.name

    @property
    def many(self) -> bool:
        """Whether there are more transitions than can be told apart."""
        return len(self.configurations) > MANY + 1

    def bars(self, configuration: int) -> list[tuple[float, float]]:
        """Begin and length of each phase in a configuration, in the system's unit of time."""
        lengths = np.diff(self.breaks)
        here = (self.configurations == configuration) & (lengths > 0)
        return list(zip(self.breaks[:-1][here], lengths[here], strict=True))

    def shares(self) -> tuple[np.ndarray, np.ndarray]:
        """Edges (n + 1,) of bins, and the share of time (n, present) in each configuration.

        The edges are in the system's unit of time. The configurations are those of `present`.
        """
        edges = np.linspace(0, self.end, BINS + 1)
        spent = np.diff(self.breaks)[:, None] * (self.configurations[:, None] == self.present)
        until = np.concatenate([np.zeros((1, len(self.present))), np.cumsum(spent, axis=0)])
        columns = [np.diff(np.interp(edges, self.breaks, column)) for column in until.T]
        return edges, np.stack(columns, axis=-1) / np.diff(edges)[:, None]


def coordinates_of(structure: Structure) -> tuple[tuple[int, int], ...]:
    """Indices of position and velocity of every mass.

    States without a velocity are paired with their neighbours.
    """
    if structure.coordinates:
        return structure.coordinates
    forced = structure.forced
    free = [place for place in range(len(structure.states)) if place not in forced]
    return tuple(pairwise(free)) or ((free[0], free[0]),)


def orbit_view(
    orbit: Orbit,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> View:
    """The motion along a converged orbit, with at least about so many points in each period.

    Positions and time are those of the orbit's equations. The masses count from 0, and None
    stands for all; `InputError` is raised if there is no such mass.
    """
    if not orbit.problem.derived:
        points = points_per_period
        if isinstance(points, int) and not isinstance(points, bool):
            points *= periods
        return trajectory_view(orbit.trajectory(periods), masses, points, orbit)
    motion = orbit_motion(orbit)
    samples = motion.sample(points_per_period, periods)
    structure = structure_of(orbit.system)
    # sums one by one, as those of the samples
    begins = np.cumsum([0.0, *[motion.period] * (periods - 1)])[:, None] + motion.breaks[:-1]
    places = [structure.configuration(name) for name in motion.configurations]
    return View(
        shown_name(orbit.name),
        structure,
        motion.names,
        units_of(orbit.system),
        chosen_masses(masses, len(structure.coordinates), orbit.name),
        samples.times,
        samples.states,
        np.append(begins.ravel(), samples.times[-1]),
        np.tile(places, periods),
        _levels_of_equations(orbit, motion.names),
        dense=False,
        orbit=orbit,
    )


def trajectory_view(
    trajectory: Trajectory,
    masses: Iterable[int] | None = None,
    points: int = 2000,
    orbit: Orbit | None = None,
) -> View:
    """A motion with points as dense as a picture needs them, at least about `points`.

    The masses count from 0, and None stands for all; `orbit` is the one that the motion runs
    along. `InputError` is raised if there is no such mass, or if the motion is not finite or
    beyond what axes hold.
    """
    structure, run, count = trajectory.structure, trajectory.run, trajectory.transitions
    name = trajectory.name if orbit is None else orbit.name
    chosen = chosen_masses(masses, len(coordinates_of(structure)), name)
    if not (math.isfinite(trajectory.end) and np.isfinite(trajectory.states).all()):
        raise InputError("the motion is not finite")
    present = np.unique(run.configurations).tolist()
    angle = trajectory.end * max(fastest(trajectory.system, c) for c in present)
    needed = min(_MOST_POINTS, math.ceil(angle / _STEP))
    wanted = max(points, needed) if isinstance(points, int | np.integer) and points > 0 else points
    times, states = trajectory.sample(wanted)
    largest = max(trajectory.end, float(np.abs(states).max(initial=0)))
    if not largest <= _LARGEST:
        raise InputError(
            f"the motion has numbers of {largest:.3g}, beyond {_LARGEST:g}: no picture"
        )
    kernels = structure.kernels if orbit is None else orbit.system
    counted = "" if orbit else f", {count:,} transition{'' if count == 1 else 's'}"
    return View(
        shown_name(name) + counted,
        structure,
        trajectory.names,
        units_of(kernels or trajectory.name),
        chosen,
        times,
        states,
        np.append(run.times, trajectory.end),
        run.configurations,
        _levels_of_rows(trajectory.system, kernels),
        dense=count > MANY or angle > 2 * math.pi * MANY,
        orbit=orbit,
    )


def _levels_of_equations(orbit: Orbit, names: tuple[str, ...]) -> Levels:
    """The levels of `View.levels` that the table of an orbit's equations has."""
    found: dict[int, list[tuple[float, str]]] = {}
    for name, text in orbit.kernels.table["levels"].items():
        known = text in orbit.values
        level = float(orbit.values[text]) if known else float(parse(text))
        found[names.index(name)] = [(level, symbol(text) if known else "")]
    return found


def _levels_of_rows(system: PiecewiseLinear, kernels: SystemKernels | None) -> Levels:
    """The levels of `View.levels` of a system's boundaries."""
    found: dict[int, list[tuple[float, str]]] = {}
    for row in sorted({b.row for shapes in system.structure.boundaries for b in shapes}):
        used = np.flatnonzero(system.rows[row, :-1]).tolist()
        if len(used) == 1:
            level = _level(system, row, used[0])
            found.setdefault(used[0], []).append((level, _parameter(system, kernels, row, used[0])))
    return found


def _level(system: PiecewiseLinear, row: int, state: int) -> float:
    return float(0.0 - system.rows[row, -1] / system.rows[row, state])


def _parameter(system: PiecewiseLinear, kernels: SystemKernels | None, row: int, state: int) -> str:
    """Symbol of the parameter that a level equals, with a minus if it is the negative.

    The level has to follow the parameter when that changes; the text is empty if none fits.
    """
    if kernels is None:
        return ""
    level = _level(system, row, state)
    numbers = {name: float(value) for name, value in system.parameters.items()}
    for name, number in numbers.items():
        if abs(number) == abs(level) != 0:
            moved = {**numbers, name: number * 1.0078125}
            point = np.array(list(moved.values()))
            ratio = level / number
            if _level(piecewise_at(kernels, point), row, state) == ratio * moved[name]:
                return ("-" if ratio < 0 else "") + symbol(name)
    return ""
