"""Declared orbits that are composed, at many points: by tables, or by compiled kernels.

One orbit is composed from its system's tables. At many points kernels of its own equations take
their place, where these can be compiled: from the same reference orbit they find the same, under
the same names.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.model.completion import check_names
from nonsmooth.runtime.model.kernel_records import OrbitKernels, ParameterTable, SavedTable
from nonsmooth.runtime.model.kernels import kernels_of_many
from nonsmooth.runtime.model.parameter_batches import (
    parameter_array,
    parameter_points,
)
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.orbits.kernel_many import KernelPoints, solve_kernels_many
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Columns, Orbits, changed, reshaped
from nonsmooth.runtime.orbits.table_many import TableBatch, section_of, solve_itineraries
from nonsmooth.runtime.orbits.table_solve import solve_declared, unknowns_of
from nonsmooth.runtime.shooting.multipliers import margins
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape
from nonsmooth.runtime.shooting.table_newton import sizes

__all__ = [
    "DeclaredKernels",
    "OrbitPoints",
    "declared_kernels",
    "points_of",
    "solve_declared_many",
]

_SAME = 1e-7  # difference of one orbit by kernels and by tables, in units of max(1, |x|)


@dataclass(frozen=True, eq=False)
class TablePoints:
    """An orbit without kernels at many points; see `KernelPoints`."""

    kernels: OrbitKernels
    reference: Orbit  # at the reference point
    chunk: ClassVar[int] = 1 << 11
    bounded: ClassVar[tuple[str, ...]] = ()  # no parameter is open

    @classmethod
    def of(cls, kernels: OrbitKernels) -> TablePoints:
        """Return the orbit, solved at its reference point.

        `InputError` is raised for an orbit that declares no reference, that has none there,
        that is periodic up to a shift only, or that is declared by a part and a symmetry.
        """
        _check(kernels, ", from which a chart could start")
        try:
            reference = solve_declared(kernels, {})
        except NoConvergence as problem:
            raise InputError(f"at its reference, where a chart starts: {problem}") from None
        if len(reference.tables.translations):
            raise InputError(
                f"{kernels.name} is periodic up to a shift, which one point at a time knows"
            )
        return cls(kernels, reference)

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

    @cached_property
    def limits(self) -> list[str]:
        """See `KernelPoints`: every boundary of every phase."""
        return [
            f"phase {place + 1} {structure.configurations[c]}: {shape.name}"
            for structure in (self._cycle.structure,)
            for place, c in enumerate(self._cycle.configurations)
            for shape in structure.boundaries[c]
        ]

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """See `KernelPoints`: the usual start is the reference's."""
        system, declared = self.kernels.system, self.kernels.table.get("period")
        points, _ = parameter_points(system, {p.name: values[p.name] for p in system.parameters})
        given = np.full(len(points), np.nan) if declared is None else values[declared["name"]]
        names, count, size = self.unknowns, len(self._cycle), len(points)
        if start is None:
            start = np.broadcast_to(self._own_start, (size, len(names)))
        dwell = np.where(start[:, :count] > 0, start[:, :count], np.nan)
        found = self._batch.solve(points, dwell, start[:, count:], given, limits=True)
        margin = np.full(size, np.nan)
        if not self._cycle.one_sided:
            timed = not np.isnan(given).all()
            margin = margins(found.maps, found.trace, self._section[1], family=timed)
        return {
            "status": found.status.astype(int),
            "limit": found.limit,
            "admissible": found.limit == NEITHER,
            "trace": found.trace,
            "margin": margin,
            "period": found.dwell.sum(axis=-1),
            **dict(zip(names, found.unknowns, strict=True)),
        }

    def starts_of(self, columns: Columns) -> np.ndarray:
        """See `KernelPoints`: dwell times and start."""
        return np.stack([columns[name] for name in self.unknowns], axis=-1)

    @cached_property
    def usual(self) -> np.ndarray:
        """See `KernelPoints`."""
        dwell = self.reference.dwell_times
        return np.concatenate([0 * dwell, sizes(self.reference.tables.shooting, dwell)])

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """See `KernelPoints`: the limits are known already."""
        return columns["limit"]

    @cached_property
    def _cycle(self) -> ItineraryShape:
        phases = [(c, boundary) for c, boundary, _ in self.kernels.table["phases"]]
        return itinerary_shape(structure_of(self.kernels.system), phases)

    @cached_property
    def _section(self) -> tuple[int, int, int]:
        """The section that `section_of` finds at the reference, wherever a point is computed."""
        point = np.array([[float(value) for value in self.reference.parameters.values()]])
        dwell, start = self.reference.dwell_times[None], self.reference.states[:1]
        return section_of(self._cycle, self.kernels.system, point, dwell, start)

    @cached_property
    def _own_start(self) -> np.ndarray:
        return np.concatenate([self.reference.dwell_times, self.reference.states[0]])

    @cached_property
    def _batch(self) -> TableBatch:
        return TableBatch(self.kernels.system, self._cycle, self._section[0])


@dataclass(frozen=True, eq=False)
class DeclaredKernels:
    """A composed orbit at many points, by kernels in place of tables; see `KernelPoints`."""

    composed: OrbitKernels  # the orbit as it is composed
    kernels: OrbitKernels  # of its own equations, with the composed orbit's reference
    reference: Orbit  # the composed orbit at its reference point
    bounded: ClassVar[tuple[str, ...]] = ()  # no parameter is open

    @property
    def alone(self) -> bool:
        """Whether the kernels alone decide: they search for nothing but the start of the orbit.

        Where dwell times are searched for, too, Newton's method may end at a root that is no
        motion, such as one without a phase; there the tables look for another one.
        """
        return not {*self.kernels.reduced} & {*self.kernels.timed}

    @cached_property
    def _points(self) -> KernelPoints:
        """The same orbit in the names of the kernels."""
        unused = {p.name for p in self.kernels.other_parameters}
        names = [name for name in self.kernels.tables if name not in unused]
        return KernelPoints.of(self.kernels, names)

    @cached_property
    def _tables(self) -> TablePoints:
        """The tables, which are asked where the kernels are not `alone` and find no motion."""
        return TablePoints(self.composed, self.reference)

    @property
    def _deciding(self) -> KernelPoints | TablePoints:
        """Who has the last word."""
        return self._points if self.alone else self._tables

    @property
    def chunk(self) -> int:
        """See `KernelPoints`."""
        return self._deciding.chunk

    @property
    def parameters(self) -> list[ParameterTable]:
        """See `KernelPoints`."""
        return self._tables.parameters

    @property
    def unknowns(self) -> tuple[str, ...]:
        """See `KernelPoints`: dwell times, then the start."""
        return self._tables.unknowns

    @property
    def limits(self) -> list[str]:
        """See `KernelPoints`."""
        return self._deciding.limits

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """See `KernelPoints`."""
        near = start
        if start is not None and not self.alone:
            near = start[:, [self.unknowns.index(name) for name in self.kernels.reduced]]
        found = self._points.solve(values, near)
        columns = {**found, **self._named(values, found)}
        if self.alone:
            return columns
        rest = np.flatnonzero(~columns["admissible"])
        columns["limit"] = np.full(len(columns["status"]), NEITHER)
        if len(rest):
            part = {name: column[rest] for name, column in values.items()}
            others = self._tables.solve(part, None if start is None else start[rest])
            for name, column in others.items():
                columns[name][rest] = column
        return columns

    def starts_of(self, columns: Columns) -> np.ndarray:
        """See `KernelPoints`: reduced unknowns, or what the tables start from."""
        return self._deciding.starts_of(columns)

    @property
    def usual(self) -> np.ndarray:
        """See `KernelPoints`."""
        return self._deciding.usual

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """See `KernelPoints`."""
        return self._deciding.limits_of(values, columns)

    def solve_many(
        self,
        parameters: Mapping[str, Any],
        *,
        admissibility: bool,
        threads: int | None,
        chunk: int,
    ) -> Orbits:
        """Find orbits at many points, as the tables of the system would.

        All parameters of the system are given as arrays that broadcast; the problem of the
        result is the composed orbit's. `InputError` is raised for wrong names or arrays.
        """
        check_names(self.composed.system, parameters)
        own = self.kernels.tables.keys() - {p.name for p in self.kernels.other_parameters}
        taken = {name: value for name, value in parameters.items() if name in own}
        if len(taken) < len(parameters):  # the others only have domains
            points, shape = parameter_points(self.composed.system, parameters)
            sound = np.isfinite(points).all(axis=1)
            first = self.kernels.parameter_names[0]
            place = [p.name for p in self.composed.system.parameters].index(first)
            taken[first] = np.where(sound, points[:, place], np.nan).reshape(shape)
        found = solve_kernels_many(
            self.kernels, taken, admissibility=admissibility, threads=threads, chunk=chunk
        )
        shape = found.status.shape
        flat = changed(np.ravel, found)
        values = {n: np.broadcast_to(found.parameters[n], shape).ravel()
                  for n in self.kernels.parameter_names}  # fmt: skip
        named = self._named(values, flat.unknowns)
        orbits = replace(
            flat,
            problem=self.reference.problem,
            parameters={name: parameter_array(name, value) for name, value in parameters.items()},
            unknowns=named,
            bounds={} if admissibility else None,
            starts=self._starts(values, flat.unknowns, named),
        )
        return reshaped(orbits, shape)

    def _named(self, parameters: Mapping[str, np.ndarray], unknowns: Columns) -> Columns:
        """Return dwell times and start (n,) of orbits, by the names and in the order of `unknowns`.

        Parameters and unknowns (n,) are, beside others, those of the kernels' equations,
        NaN where there is no orbit.
        """
        kernels, names = self.kernels, self.unknowns
        unknowns = {name: unknowns[name] for name in kernels.unknowns}
        times = kernels.durations({**parameters, **unknowns})
        start = names[len(times) :]
        known = {**unknowns, **times}
        if not known.keys() >= {*start}:
            states = self._states(parameters, unknowns)[:, 0]
            known = {**dict(zip(start, states.T, strict=True)), **known}
        return {name: known[name] for name in names}

    def _starts(self, parameters: Columns, unknowns: Columns, named: Columns) -> np.ndarray:
        """Return the state (n, p, N) at the start of each phase."""
        count = len(self.kernels.dwell_times)
        if count > 1:
            return self._states(parameters, unknowns)[:, :count]
        return np.stack([*named.values()][count:], axis=-1)[:, None]

    def _states(self, parameters: Mapping[str, np.ndarray], unknowns: Columns) -> np.ndarray:
        """Return the states (n, p + 1, N) where phases begin; NaN where there is no orbit."""
        kernels = self.kernels
        points = np.stack([parameters[name] for name in kernels.parameter_names], axis=-1)
        solved = np.stack([unknowns[name] for name in kernels.unknowns], axis=-1)
        spectrum, _ = kernels.spectrum(points)
        with np.errstate(all="ignore"):  # of points without an orbit
            found = np.asarray(kernels.evaluate("states", at=(points, spectrum, solved)))
        found[np.isnan(solved).any(axis=-1)] = np.nan
        return found


def declared_kernels(orbit: OrbitKernels, key: str | None = None) -> DeclaredKernels | None:
    """Return the kernels that find a composed orbit at many points; None where tables have to.

    The first call waits until they are derived and compiled. None is returned where there
    is no compiler, where formulas are long, and where the kernels find another orbit at
    the reference point. `key` is that of `kernels_of_many`. `NoConvergence` is raised if
    there is no orbit at the reference point.
    """
    own = kernels_of_many(orbit, key)
    return None if own is None else _from_reference(orbit, own)


@cache
def _from_reference(orbit: OrbitKernels, own: OrbitKernels) -> DeclaredKernels | None:
    """Return kernels that begin where the composed orbit begins; None if they do not find it."""
    known = solve_declared(orbit, {})
    guess = {name: repr(float(known.unknowns[name])) for name in own.unknowns}
    reference = {**own.table["reference"], "guess": guess}
    table = SavedTable(own.name, own.address, {**own.table, "reference": reference})
    kernels = replace(own, saved=table)
    found = solve_kernels(kernels, throw=False)
    same = all(
        abs(found.unknowns[name] - value) <= _SAME * max(1, abs(value))
        for name, value in known.unknowns.items()
        if name in own.unknowns
    )
    return DeclaredKernels(orbit, kernels, known) if same else None


OrbitPoints = KernelPoints | TablePoints | DeclaredKernels


@cache
def points_of(
    kernels: OrbitKernels, given: tuple[str, ...], own: DeclaredKernels | None = None
) -> OrbitPoints:
    """Return an orbit at many points, where what is fixed or swept has the names `given`.

    `own` are compiled kernels that stand in for the tables of a composed orbit.
    `InputError` is raised for a name that fixes nothing, several that fix one parameter
    twice, or an orbit that cannot be found at many points at once.
    """
    if kernels.derived:
        return KernelPoints.of(kernels, given)
    return TablePoints.of(kernels) if own is None else own


def solve_declared_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool,
    threads: int | None,
    chunk: int,
) -> Orbits:
    """Find a composed orbit at many points, each from the reference orbit.

    Compiled kernels of its own equations do it where they can be had. The tables of its
    system do where they cannot; and where, with dwell times among what is searched for,
    the kernels find no motion. The arrays of the result have the shape to which the
    parameters broadcast; absent parameters take the reference point's values. The kernels
    solve `chunk` points at a time. `InputError` is raised for wrong names or shapes, for
    an orbit that declares no reference, and for one that is declared by a part and a
    symmetry.
    """
    _check(kernels, ": give its system, the itinerary and a guess")
    values = {**kernels.table["reference"]["parameters"], **parameters}
    parameter_points(kernels.system, values)  # kernels are not compiled for a slip of the pen
    own = declared_kernels(kernels)
    options: Any = {"admissibility": admissibility, "threads": threads}
    if own is None:
        return _by_tables(solve_declared(kernels, {}), values, **options)
    if own.alone:
        return own.solve_many(values, chunk=chunk, **options)
    found = own.solve_many(values, admissibility=True, threads=threads, chunk=chunk)
    assert found.admissible is not None
    rest = ~found.admissible
    if rest.any():
        given = found.parameters.items()
        part = {name: np.broadcast_to(array, rest.shape)[rest] for name, array in given}

        def filled(array: np.ndarray, values: np.ndarray) -> np.ndarray:
            both = np.array(array)
            both[rest] = values
            return both

        found = changed(filled, found, _by_tables(own.reference, part, **options))
    return found if admissibility else replace(found, admissible=None, bounds=None)


def _by_tables(
    known: Orbit, values: Mapping[str, Any], *, admissibility: bool, threads: int | None
) -> Orbits:
    """Compose an orbit at many points from the reference orbit, under its names."""
    composed = solve_itineraries(
        known.problem.system,
        known.itinerary,
        values,
        known.dwell_times,
        known.states[0],
        admissibility=admissibility,
        threads=threads,
    )
    names = known.problem.unknown_names
    unknowns = dict(zip(names, composed.unknowns.values(), strict=True))
    return replace(composed, problem=known.problem, unknowns=unknowns)


def _check(kernels: OrbitKernels, remedy: str) -> None:
    """Refuse an orbit that is not found at many points; `remedy` is for one with no reference."""
    if kernels.table["reference"] is None:
        raise InputError(f"{kernels.name} declares no reference{remedy}")
    if kernels.table.get("symmetry"):
        raise InputError(
            f"{kernels.name} is declared by a part and a symmetry, which one point at a time knows"
        )
