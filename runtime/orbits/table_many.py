"""The orbits of one itinerary at many parameter points: compiled, in threads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import eigenvalues
from nonsmooth.runtime.core.parallel import in_parallel
from nonsmooth.runtime.core.values import real_array
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import NO_ORBIT, first_limits
from nonsmooth.runtime.orbits.orbit import Orbit, Orbits, reshaped
from nonsmooth.runtime.orbits.problem import OrbitProblem
from nonsmooth.runtime.orbits.table_solve import unknowns_of, with_routes
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle
from nonsmooth.runtime.shooting.multipliers import margins as margins_of
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.section_map import (
    local_maps,
    mechanical_states,
    section_dimension,
    smallest_section,
    stroboscopic_maps,
)
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    finite_at,
    guesses,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.table_newton import (
    TableSolution,
    digits_of,
    sizes,
    solve_shape,
    unsolved,
)
from nonsmooth.runtime.shooting.translations import (
    gauges_of,
    projection_along,
    translations_of,
)

Arrays = Mapping[str, np.ndarray]  # by name
CHUNK = 1 << 11  # points that one thread takes at a time; an eighth where there are several


def solve_itineraries(
    system: SystemKernels,
    itinerary: Sequence[tuple[str, str]],
    parameters: Mapping[str, Any],
    dwell_times: Any,
    start: Any = None,
    period: Any = None,
    *,
    multipliers: bool = False,
    admissibility: bool = False,
    threads: int | None = None,
) -> Orbits:
    """Find the periodic orbit of an itinerary at many parameter points.

    Parameters are all physical ones, as arrays (...) that broadcast. Guesses of dwell
    times (..., p) and of the start (..., N), and the period (...), which the dwell times
    have to sum up to, are one for all points or one for each; there may be many guesses
    for one point. All arrays of the result have the shape (...) to which these broadcast,
    NaN where there is no orbit. No parameter is open for admissibility. `threads` None
    takes as many as processors. `InputError` is raised as by `solve_itinerary`, and for
    arrays that do not broadcast; a parameter outside its domain gives its point the
    status of a number that is not finite.
    """
    kernels = with_routes(system, itinerary)
    structure = structure_of(kernels)
    cycle = itinerary_shape(structure, itinerary)
    size = len(structure.states)
    points, given = parameter_points(kernels, parameters)
    shape = _common(given, dwell_times, start)
    width = points.shape[1]
    points = np.broadcast_to(points.reshape(*given, width), (*shape, width))
    points = points.reshape(int(np.prod(shape)), width)
    guess = _spread("the guess of the dwell times", dwell_times, len(cycle), shape, positive=True)
    begin_at = None
    if start is not None:
        begin_at = _spread("the guess of the start", start, size, shape)
    lengths = np.full(len(guess), np.nan)
    if period is not None:
        lengths = _spread("period", np.asarray(period)[..., None], 1, shape, positive=True)[:, 0]
    batch = TableBatch.at(OrbitProblem(kernels, cycle.itinerary), points, guess, begin_at)
    options: Any = {"limits": admissibility, "multipliers": multipliers, "margins": multipliers}
    found = batch.solve(points, guess, begin_at, lengths, threads=threads, **options)
    return _in_shape(found, parameters, shape)


def _in_shape(found: Orbits, parameters: Mapping[str, Any], shape: tuple[int, ...]) -> Orbits:
    """Return orbits at points (n,) in a shape (...), with parameters as they were given."""
    arrays = {name: real_array(f"parameter {name}", value) for name, value in parameters.items()}
    return reshaped(replace(found, parameters=arrays), shape)


def _translates(kernels: SystemKernels, points: np.ndarray) -> bool:
    """Return whether the system does not change along some direction, at the first sound point."""
    for place in np.flatnonzero(np.isfinite(points).all(axis=1))[:CHUNK]:
        with suppress(InputError):  # of a point whose flows double precision does not tell
            return bool(len(translations_of(piecewise_at(kernels, points[place]))))
    return False


def _common(shape: tuple[int, ...], dwell: Any, start: Any) -> tuple[int, ...]:
    """Return the shape of the points, to which parameters and guesses broadcast."""
    leads = [np.shape(guess)[:-1] for guess in (dwell, start) if guess is not None]
    try:
        return np.broadcast_shapes(shape, *leads)
    except ValueError:
        return shape  # which guess does not fit is told when it is spread


def _spread(
    name: str, given: Any, size: int, shape: tuple[int, ...], *, positive: bool = False
) -> np.ndarray:
    """Return a guess for each point (n, size)."""
    array = guesses(name, given, size, positive=positive)
    try:
        return np.broadcast_to(array, (*shape, size)).reshape(-1, size)
    except ValueError:
        raise InputError(f"{name}: {array.shape} does not broadcast to {shape}") from None


@np.errstate(all="ignore")  # of points without an orbit
def section_of(
    cycle: ItineraryShape,
    kernels: SystemKernels,
    points: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray | None,
    *,
    moving: bool = False,
) -> tuple[int, int, int]:
    """Return the phase from which orbits are composed, and how many multipliers may not be zero.

    The third number is how many multipliers there are, without those of a forcing. The phase
    is the one that starts on the smallest section, or the first one of forced orbits and of
    orbits that close up to translations (`moving`). All are a matter of structure: one point
    tells them.
    """
    driven = mechanical_states(cycle)
    if driven is not None:
        return 0, len(driven), len(driven)
    size = len(cycle.structure.states)
    if moving:
        return 0, size, size
    for place in range(min(len(dwell), CHUNK)):
        part = slice(place, place + 1)
        (group,) = numbers_at(kernels, points[part], cycle.configurations)
        flat, here = group.flat, cycle.at(group.structure)
        if not finite_at(here, flat).all():
            continue
        at = None if start is None else start[part]
        found = solve_shape(here, flat, dwell[part], at, np.full(1, np.nan))
        single = numbers_in(group.structure, flat[0])
        now = shoot(here, single, found.dwell[0], found.starts[0, 0], np)
        maps = local_maps(here, single, now)
        if not all(np.isfinite(matrix).all() for matrix in maps):
            continue
        size_of = sizes(now, found.dwell[0])
        first, rank = smallest_section(maps, size_of)
        return first, rank, max(rank, section_dimension(cycle, single, size_of, np))
    return 0, size - 1, size - 1


@dataclass(frozen=True, eq=False)
class TableBatch:
    """An itinerary of a system, to be solved at many points."""

    problem: OrbitProblem
    cycle: ItineraryShape
    section: tuple[int, int, int]  # as `section_of` finds it
    translates: bool  # whether orbits close up to translations of the system

    @classmethod
    def at(
        cls, problem: OrbitProblem, points: np.ndarray, dwell: np.ndarray, start: np.ndarray | None
    ) -> TableBatch:
        """Return an itinerary, whose section the first of some points and guesses tells."""
        system = problem.system
        cycle = itinerary_shape(structure_of(system), problem.itinerary)
        moving = _translates(system, points)
        section = section_of(cycle, system, points, dwell, start, moving=moving)
        return cls(problem, cycle, section, moving)

    @property
    def limits(self) -> tuple[str, ...]:
        """Meanings of the numbers of `Orbits.limit`: every boundary of every phase."""
        structure = self.cycle.structure
        return tuple(
            f"phase {place + 1} {structure.configurations[c]}: {shape.name}"
            for place, c in enumerate(self.cycle.configurations)
            for shape in structure.boundaries[c]
        )

    def solve(
        self,
        points: np.ndarray,
        dwell: np.ndarray,
        start: np.ndarray | None,
        period: np.ndarray,
        *,
        limits: bool,
        multipliers: bool = False,
        margins: bool = False,
        threads: int | None = 1,
    ) -> Orbits:
        """Return the orbits at n points from one guess each, without their parameters.

        `points` is (n, parameters), guesses are `dwell` (n, p) and `start` (n, N), or None for
        the start that fits the dwell times best; `period` (n,) is NaN where it is free.
        `limits`, `multipliers` and `margins` say what else is told. `threads` None takes as
        many as processors.
        """
        cycle, system, (count, phases) = self.cycle, self.problem.system, dwell.shape
        size, driven = len(cycle.structure.states), mechanical_states(cycle)
        width = size if driven is None else len(driven)
        found = unsolved(np.full((count, phases), np.nan), size, width)
        margin, limit = np.full(count, np.nan), np.full(count, NO_ORBIT)
        sound = np.isfinite(np.concatenate([points, dwell], axis=1)).all(axis=1)
        if start is not None:
            sound &= np.isfinite(start).all(axis=1)

        step = CHUNK if threads == 1 else max(CHUNK // 8, 1)

        def work(begin: int) -> None:
            for group in numbers_at(system, points[begin : begin + step], cycle.configurations):
                rows, flat = begin + group.places, group.flat
                if not (kept := sound[rows]).all():
                    rows, flat = rows[kept], flat[kept]
                if not len(rows):
                    continue
                here, guess = cycle.at(group.structure), None if start is None else start[rows]
                solved, own = self._solved(here, flat, dwell[rows], guess, period[rows], margins)
                margin[rows] = own
                for array, values in zip(found, solved, strict=True):
                    array[rows] = values
                if limits:
                    there = solved.status == CONVERGED
                    waits = np.where(there[:, None], solved.dwell, np.nan)
                    told = first_limits(system, here, points[rows], flat, waits, solved.starts)
                    limit[rows] = np.where(there, told, NO_ORBIT)

        in_parallel(work, range(0, count, step), threads)
        for array in (*found[:4], margin):
            array[found.status != CONVERGED] = np.nan
        _, rank, dimension = self.section
        values = None
        if multipliers:
            values = eigenvalues(found.maps)[:, :dimension]
            values[:, rank:] *= 0  # NaN stays NaN
        unknowns = np.concatenate([found.dwell, found.starts[:, 0]], axis=1).T
        return Orbits(
            self.problem,
            {},
            dict(zip(self.problem.unknown_names, unknowns, strict=True)),
            np.asarray(np.trace(found.maps, axis1=-2, axis2=-1)),
            found.dwell.sum(axis=-1),
            found.residual,
            found.iterations,
            found.status,
            limit=limit if limits else None,
            limits=self.limits if limits else (),
            bounds={} if limits else None,
            multipliers=values,
            margin=margin if margins else None,
            starts=found.starts,
            timed=not np.isnan(period).all(),
        )

    def _solved(
        self,
        cycle: ItineraryShape,
        flat: np.ndarray,
        dwell: np.ndarray,
        start: np.ndarray | None,
        period: np.ndarray,
        margins: bool,
    ) -> tuple[TableSolution, np.ndarray]:
        """Return the orbits at points whose numbers `flat` have the same modes, and their margins.

        Maps are those of the section at the first phase, or stroboscopic; margins are NaN where
        they are not asked for.
        """
        closed, directions = cycle, np.empty((len(flat), 0, len(cycle.structure.states)))
        if self.translates:
            numbers = numbers_in(cycle.structure, flat)
            place = sum(part[0].size for part in numbers[:3])
            closed, numbers, directions = closed_cycle(cycle, numbers)
            added = numbers.resets[:, cycle.structure.resets :].reshape(len(flat), -1)
            flat = np.concatenate([flat[:, :place], added, flat[:, place:]], axis=1)
        turned, first = closed.rotated(self.section[0]), self.section[0]
        if start is not None and first:
            numbers = numbers_in(closed.structure, flat)
            start = shoot(closed, numbers, dwell, start, np).starts[first]
        solved = solve_shape(turned, flat, np.roll(dwell, -first, axis=1), start, period)
        _, status = digits_of(turned, flat, solved, period, directions, every=False)
        maps, driven = solved.maps, mechanical_states(cycle)
        if driven is not None:
            field = numbers_in(closed.structure, flat).fields[:, cycle.configurations[0]]
            maps = stroboscopic_maps(closed, field, solved.starts[:, 0], maps, driven)
            directions = directions[..., driven]
        margin = np.full(len(flat), np.nan)
        if margins and not cycle.one_sided:
            family = driven is None and not np.isnan(period).all()
            trace = np.trace(maps, axis1=-2, axis2=-1)
            margin = margins_of(maps, trace, self.section[1], family=family)
        orbits = solved._replace(
            dwell=np.roll(solved.dwell, first, axis=1),
            starts=np.roll(solved.starts, first, axis=1),
            maps=_with_translations(maps, directions) if self.translates else maps,
            status=status,
        )
        return orbits, margin


def _with_translations(maps: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return maps (n, k, k) up to translations with the multipliers 1 that these have."""
    found = maps.copy()
    for map_, along in zip(found, directions, strict=True):
        if len(along):
            map_[:] = projection_along(along) @ map_
            map_[:, gauges_of(along)] += along.T
    return found


@dataclass(frozen=True, eq=False)
class TablePoints:
    """A composed orbit at many points, from its system's tables; see `KernelPoints`."""

    kernels: OrbitKernels  # the orbit as it is composed
    reference: Orbit  # at the reference point
    bounded: ClassVar[tuple[str, ...]] = ()  # no parameter is open

    @property
    def chunk(self) -> int:
        """See `KernelPoints`."""
        return CHUNK

    @property
    def parameters(self) -> list[ParameterTable]:
        """See `KernelPoints`."""
        period = self.kernels.table.get("period")
        own = [ParameterTable(**period)] if period else []
        return [*self.kernels.system.parameters, *own]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """See `KernelPoints`: dwell times, then the start."""
        return unknowns_of(self.kernels)

    @property
    def start_names(self) -> tuple[str, ...]:
        """See `KernelPoints`."""
        return self.unknowns

    @property
    def limits(self) -> tuple[str, ...]:
        """See `KernelPoints`."""
        return self._batch.limits

    @property
    def usual(self) -> np.ndarray:
        """See `KernelPoints`."""
        dwell = self.reference.dwell_times
        return np.concatenate([0 * dwell, sizes(self.reference.tables.shooting, dwell)])

    def solve(
        self,
        values: Arrays,
        start: np.ndarray | None = None,
        *,
        admissibility: bool = True,
        margins: bool = False,
        threads: int | None = 1,
        chunk: int = CHUNK,
    ) -> Orbits:
        """See `KernelPoints`; starts (n, p + N) are the reference where none are given."""
        declared, count = self.kernels.table.get("period"), len(self.reference.itinerary)
        system = self.kernels.system
        points, shape = parameter_points(
            system, {p.name: values[p.name] for p in system.parameters}
        )
        size = len(points)
        given = np.full(size, np.nan) if declared is None else values[declared["name"]]
        if start is None:
            first = np.concatenate([self.reference.dwell_times, self.reference.states[0]])
            start = np.broadcast_to(first, (size, len(first)))
        found = self._batch.solve(
            points,
            np.where(start[:, :count] > 0, start[:, :count], np.nan),
            start[:, count:],
            given,
            limits=admissibility,
            margins=margins,
            threads=threads,
        )
        return _in_shape(found, values, shape)

    @cached_property
    def _batch(self) -> TableBatch:
        """The itinerary with the section at the reference, wherever a point is computed."""
        known = self.reference
        point = np.array([[float(value) for value in known.parameters.values()]])
        return TableBatch.at(known.problem, point, known.dwell_times[None], known.states[:1])
