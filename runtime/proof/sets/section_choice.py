"""Sections of a motion in double precision: which to take, and their map, of many states."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.model.boundary_sets import mask_of
from nonsmooth.runtime.model.engine_run import Run, Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.proof.sets.sections import (
    MapSection,
    Way,
    angle_of,
    forcing_section,
    phases,
    sections_behind,
    ways_of,
)
from nonsmooth.runtime.proof.statement import ExactSystem, floats_of
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.simulate import follow, simulate_many
from nonsmooth.runtime.simulation.trajectory import Trajectory

_KEPT = 48  # transitions among which the next passage is looked for
_MOST = 512  # transitions in one iterate
_ROUNDING = 1e-12  # of a boundary's function
_STEP = 1e-6  # of a derivative, in units of the coordinates' ranges


class Mapped(NamedTuple):
    """Images of coordinates under the map of a section, in double precision."""

    points: np.ndarray  # (n, d)
    ways: np.ndarray  # (n,): numbers of the sequences of transitions, -1 where there is no image


class FloatSection:
    """The map from a section to itself, in double precision.

    `system` is that of the kernels at one parameter point.
    """

    def __init__(self, kernels: SystemKernels, system: ExactSystem, section: MapSection) -> None:
        self._kernels, self.section = kernels, section
        self._parameters = {name: float(value) for name, value in system.values.items()}
        self._period = 0.0 if section.phase is None else float(section.period(system))
        lift = floats_of(section.lift)
        self._lift, self._shift = lift[:, :-1], lift[:, -1]
        (rows,) = tables_at(kernels, np.array([[*self._parameters.values()]]))[1]
        shapes = structure_of(kernels).boundaries[section.configuration]
        self._rows = rows[[shape.row for shape in shapes]]

    def states(self, points: np.ndarray) -> np.ndarray:
        """States (n, N) of coordinates (n, d)."""
        return np.asarray(points @ self._lift.T + self._shift)

    def map(self, points: np.ndarray) -> Mapped:
        """Images of coordinates (n, d); NaN and -1 where a motion does not return."""
        section, free = self.section, list(self.section.free)
        images = np.full(points.shape, np.nan)
        ways = np.full(len(points), -1, dtype=np.int64)
        sound = np.flatnonzero(np.isfinite(points).all(axis=1))
        if not sound.size:
            return Mapped(images, ways)
        starts = self.states(points[sound])
        values = starts @ self._rows[:, :-1].T + self._rows[:, -1]
        sizes = np.abs(starts) @ np.abs(self._rows[:, :-1]).T + np.abs(self._rows[:, -1])
        inside = (values <= _ROUNDING * sizes).all(axis=1)
        starts, sound = starts[inside], sound[inside]
        if not sound.size:
            return Mapped(images, ways)
        if section.phase is not None:
            ends = self._follow(starts, until=self._period, transitions=_MOST, keep=_KEPT)
            good = (ends.status == Status.UNTIL) & (ends.configurations == section.configuration)
            images[sound[good]] = ends.states[good][:, free]
            ways[sound[good]] = _ways(ends)[good]
            return Mapped(images, ways)
        ends = self._follow(starts, transitions=_KEPT, keep=_KEPT + 1)
        before, behind = ends.last_configurations[:, :-1], ends.last_configurations[:, 1:]
        passed = (before == section.source) & (behind == section.configuration)
        passed &= ends.last_sets[:, 1:] == mask_of(section.boundaries)
        good = passed.any(axis=1)
        place = 1 + np.argmax(passed, axis=1)
        rows = np.flatnonzero(good)
        images[sound[good]] = ends.last_states[rows, place[good]][:, free]
        ways[sound[good]] = _ways(ends, place)[good]
        return Mapped(images, ways)

    def way(self, point: np.ndarray, iterates: int) -> list[Way]:
        """The transitions from a point (d,) to its image under a power of the map, if any."""
        section, starts = self.section, self.states(point[None])
        most = _MOST * iterates
        ends: dict[str, Any] = {"transitions": most, "keep": most + 1}
        if section.phase is not None:
            ends["until"] = iterates * self._period
        found = self._follow(starts, **ends)
        places, sets = found.last_configurations[0], found.last_sets[0]
        known = np.flatnonzero(places >= 0)
        ways = [way for way in ways_of(places[known], sets[known]) if way[1]]
        if section.phase is not None:
            return ways
        back = section.source, section.boundaries, section.configuration
        passed = [k for k, way in enumerate(ways, 1) if way == back][:iterates]
        return ways[: passed[-1]] if len(passed) == iterates else []

    def jacobians(self, points: np.ndarray, sizes: np.ndarray) -> tuple[Mapped, np.ndarray]:
        """Images of coordinates (n, d), and derivatives (n, d, d) by central differences.

        `sizes` (d,) are the ranges of the coordinates.
        """
        count, size = points.shape
        steps = np.eye(size) * (_STEP * sizes)
        near = np.concatenate([points[None], points + steps[:, None], points - steps[:, None]])
        images, ways = self.map(near.reshape(-1, size))
        images, ways = images.reshape(-1, count, size), ways.reshape(-1, count)
        slopes = (images[1 : 1 + size] - images[1 + size :]) / (2 * _STEP * sizes[:, None, None])
        slopes[:, (ways != ways[0]).any(axis=0)] = np.nan
        return Mapped(images[0], ways[0]), slopes.transpose(1, 2, 0)

    def _follow(self, starts: np.ndarray, **ends: Any) -> Trajectories:
        places = np.full(len(starts), self.section.configuration, dtype=np.int32)
        return simulate_many(self._kernels, self._parameters, starts, places, **ends)


def _ways(ends: Trajectories, last: np.ndarray | None = None) -> np.ndarray:
    """Numbers that distinguish sequences of transitions, up to a last one of those kept."""
    kept = ends.last_configurations.shape[1]
    counted = ends.last_configurations >= 0
    if last is not None:
        counted &= np.arange(kept) <= last[:, None]
    entries = np.where(counted, 8191 * (ends.last_configurations + 1) + ends.last_sets, 0)
    found = np.zeros(len(entries), dtype=np.uint64)
    for column in entries.T.astype(np.uint64):
        found = np.where(column > 0, (found * np.uint64(1_000_003) + column), found)
    return (found >> np.uint64(2)).astype(np.int64)


def check_one_forcing(system: ExactSystem, what: str) -> None:
    """Refuse a system with several forcings; `what` needs one at most."""
    if len(system.structure.forcing) > 1:
        raise InputError(f"{system.structure.name} has several forcings: {what} needs one")


class MetSection(NamedTuple):
    """A section, coordinates (d,) of a point of the orbit on it, and returns in one period."""

    section: MapSection
    point: Floats
    iterates: int


def section_of(system: ExactSystem, motion: Trajectory, period: float) -> MetSection:
    """The section with the fewest coordinates, or the forcing's phase far from boundaries.

    The motion is of the orbit, over one period at least.
    """
    if system.structure.forcing:
        return _met_at_a_phase(system, motion, period)
    found = [*_met_behind(system, motion)]
    if not found:
        raise InputError("the orbit passes no listed transition behind which a state is free")
    return min(found, key=lambda met: (len(met.point), met.iterates))


def _forcing(system: ExactSystem, motion: Trajectory) -> tuple[float, float, float]:
    """Speed and period of the forcing, and its angle where a motion starts."""
    c, s = system.structure.forcing[0]
    speed = float(motion.system.fields[0, s, c])
    start = np.arctan2(motion.states[0, s], motion.states[0, c])
    return speed, 2 * np.pi / abs(speed), start


def _met_at_a_phase(system: ExactSystem, motion: Trajectory, period: float) -> MetSection:
    structure, (speed, turn, first) = system.structure, _forcing(system, motion)
    found = []
    for phase in phases(_PHASES):
        # by rounding a turn may be longer than the motion
        time = np.array([min(((angle_of(phase) - first) / speed) % turn, motion.end)])
        state, name = motion(time)[0], str(motion.configuration(time)[0])
        configuration = structure.configuration(name)
        rows = motion.system.rows[[b.row for b in structure.boundaries[configuration]]]
        near = (rows[:, :-1] @ state + rows[:, -1]).max(initial=-np.inf)
        found.append((near, phase, configuration, state))
    _, phase, configuration, state = min(found, key=lambda entry: entry[0])
    section = forcing_section(system, configuration, phase)
    return MetSection(section, state[list(section.free)], max(1, round(period / turn)))


def _met_behind(system: ExactSystem, motion: Trajectory) -> Iterator[MetSection]:
    ways = ways_of(motion.run.configurations, motion.run.sets)
    sections = sections_behind(system, ways)
    for k, way in enumerate(ways):
        if section := sections.get(way):
            yield MetSection(section, motion.states[k + 1][list(section.free)], ways.count(way))


_PHASES = 16
_PERIODS, _TRANSIENT = 7000, 150
_TRANSITIONS = 6000
_FEWEST = 60  # points on a section
_TRIED = 4  # sections


class Sampled(NamedTuple):
    """A section, points (n, d) of a motion on it, and ranges (d,) of its coordinates on the way."""

    section: MapSection
    points: np.ndarray
    ranges: np.ndarray


def sampled_sections(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    """Yield sections that a long motion visits, the most promising ones first.

    With a forcing these are phases at which the motion is mostly in one configuration and far
    from boundaries, else transitions with few coordinates that are often passed. `motion` gives
    the start, and the system in double precision.
    """
    if system.structure.forcing:
        yield from _forced(system, motion)
    else:
        yield from _passed(system, motion)


def _forced(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    numbers, structure = motion.system, system.structure
    speed, period, start = _forcing(system, motion)
    end = (_PERIODS + 1) * period
    run = follow(numbers, motion.states[0], int(motion.run.configurations[0]), end)
    long = Trajectory(numbers, run)
    if not long.end >= end * (1 - 1e-9):
        return
    found = []
    for phase in phases(_PHASES):
        first = ((angle_of(phase) - start) / speed) % period
        times = first + period * np.arange(_TRANSIENT, _PERIODS)
        states, where = long(times), np.array(long.configuration(times))
        names, counts = np.unique(where, return_counts=True)
        name = str(names[np.argmax(counts)])
        configuration = structure.configuration(name)
        states = states[where == name]
        section = forcing_section(system, configuration, phase)
        if len(states) < _FEWEST or not section.free:  # at rest at a stop it is one point
            continue
        rows = numbers.rows[[b.row for b in structure.boundaries[configuration]]]
        values = states @ rows[:, :-1].T + rows[:, -1]
        spread = values.std(axis=0)
        near = (values.max(axis=0)[spread > 0] / spread[spread > 0]).max(initial=-np.inf)
        found.append((-counts.max() / counts.sum(), near, _sampled(section, states, run)))
    found.sort(key=lambda entry: entry[:2])
    yield from (sampled for *_, sampled in found[:_TRIED])


def _passed(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    start, first = motion.states[0], int(motion.run.configurations[0])
    run = follow(motion.system, start, first, transitions=_TRANSITIONS)
    half = len(run.times) // 2
    ways = ways_of(run.configurations[half - 1 :], run.sets[half - 1 :])
    counts = {way: count for way, count in Counter(ways).items() if count >= _FEWEST}
    sections = sections_behind(system, [*counts])
    found = sorted(
        sections,
        key=lambda way: (len(sections[way].free), -counts[way], way[0], way[2], min(way[1])),
    )
    for way in found[:_TRIED]:
        places = [e for e, other in enumerate(ways, half) if other == way]
        yield _sampled(sections[way], run.states[places], run)


def _sampled(section: MapSection, states: np.ndarray, run: Run) -> Sampled:
    """The free coordinates of states (n, N) on a section, with their ranges along the motion."""
    free = list(section.free)
    on_the_way = np.concatenate([states, run.states])[:, free]
    return Sampled(section, states[:, free], np.ptp(on_the_way, axis=0))
