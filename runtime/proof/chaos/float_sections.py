"""The map of a section in double precision, for many states at once."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.model.boundary_sets import mask_of
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import MapSection, Way, ways_of
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.simulate import simulate_many

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
        lift = np.array([[int(x.p) / int(x.q) for x in row] for row in section.lift])
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
