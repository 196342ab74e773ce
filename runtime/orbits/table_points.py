"""An orbit at many points by the tables of its system: solved, judged, its limits named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.model.parameter_batches import parameter_points
from nonsmooth.runtime.model.piecewise import numbers_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import NEITHER, NO_ORBIT
from nonsmooth.runtime.orbits.declared_solve import solve_declared, unknowns_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Columns
from nonsmooth.runtime.orbits.table_digits import without_digits
from nonsmooth.runtime.orbits.table_limits import first_limits
from nonsmooth.runtime.shooting.multipliers import ROUNDING
from nonsmooth.runtime.shooting.newton import CONVERGED, INVALID, LEAST
from nonsmooth.runtime.shooting.section_map import (
    local_maps,
    mechanical_states,
    smallest_section,
    stroboscopic_maps,
)
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    finite_at,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.table_newton import sizes, solve_shape

__all__ = ["TablePoints"]


class _Group(NamedTuple):
    """Points whose flows have the same modes, and their numbers."""

    places: np.ndarray
    points: np.ndarray
    cycle: ItineraryShape
    flat: np.ndarray
    period: np.ndarray


class _Solved(NamedTuple):
    """Orbits (n, ...), with maps of the section from which they are composed."""

    dwell: np.ndarray
    starts: np.ndarray
    maps: np.ndarray
    status: np.ndarray
    limit: np.ndarray


@dataclass(frozen=True, eq=False)
class TablePoints:
    """An orbit without kernels at many points; see `OrbitPoints`."""

    kernels: OrbitKernels
    reference: Orbit  # at the reference point
    chunk: ClassVar[int] = 1 << 11

    @classmethod
    def of(cls, kernels: OrbitKernels) -> TablePoints:
        """Return the orbit, solved at its reference point.

        `InputError` is raised for an orbit that declares no reference, that has none there,
        that is periodic up to a shift only, or that is declared by a part and a symmetry.
        """
        if kernels.table["reference"] is None:
            raise InputError(
                f"{kernels.name} declares no reference, from which a chart could start"
            )
        if kernels.table.get("symmetry"):
            raise InputError(
                f"{kernels.name} is declared by a part and a symmetry,"
                " which one point at a time knows"
            )
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
        """See `OrbitPoints`."""
        period = self.kernels.table.get("period")
        own = [ParameterTable(**period)] if period else []
        return [*self.kernels.system.parameters, *own]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """See `OrbitPoints`: dwell times, then the start."""
        return unknowns_of(self.kernels)

    @property
    def bounded(self) -> tuple[str, ...]:
        """See `OrbitPoints`: no parameter is open."""
        return ()

    @cached_property
    def limits(self) -> list[str]:
        """See `OrbitPoints`: every boundary of every phase."""
        return [
            f"phase {place + 1} {structure.configurations[c]}: {shape.name}"
            for structure in (self._cycle.structure,)
            for place, c in enumerate(self._cycle.configurations)
            for shape in structure.boundaries[c]
        ]

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """See `OrbitPoints`: the usual start is the reference's."""
        count, names = len(next(iter(values.values()))), self.unknowns
        columns = {
            "status": np.full(count, INVALID, dtype=int),
            "limit": np.full(count, NO_ORBIT, dtype=int),
            **{name: np.full(count, np.nan) for name in ("trace", "margin", "period", *names)},
        }
        own = np.broadcast_to(self._own_start, (count, len(names)))
        for group in self._groups(values):
            found = self._tried(group, (own if start is None else start)[group.places])
            here = found.status == CONVERGED
            at = group.places[here]
            columns["status"][group.places] = found.status
            columns["limit"][at] = found.limit[here]
            columns["trace"][at], columns["margin"][at] = self._stability(group, found, here)
            columns["period"][at] = found.dwell[here].sum(axis=-1)
            numbers = np.concatenate([found.dwell[here], found.starts[here, 0]], axis=-1)
            for name, column in zip(names, numbers.T, strict=True):
                columns[name][at] = column
        columns["admissible"] = columns["limit"] == NEITHER
        return columns

    def starts_of(self, columns: Columns) -> np.ndarray:
        """See `OrbitPoints`: dwell times and start."""
        return np.stack([columns[name] for name in self.unknowns], axis=-1)

    @cached_property
    def usual(self) -> np.ndarray:
        """See `OrbitPoints`."""
        dwell = self.reference.dwell_times
        return np.concatenate([0 * dwell, sizes(self.reference.tables.shooting, dwell)])

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """See `OrbitPoints`: the limits are known already."""
        return columns["limit"]

    @cached_property
    def _cycle(self) -> ItineraryShape:
        phases = [(c, boundary) for c, boundary, _ in self.kernels.table["phases"]]
        return itinerary_shape(structure_of(self.kernels.system), phases)

    @cached_property
    def _section(self) -> tuple[int, int]:
        """The phase from which orbits are composed, and how many multipliers are not zero.

        They are the reference's, and so the same wherever a point is computed.
        """
        driven = mechanical_states(self._cycle)
        if driven is not None:
            return 0, len(driven)
        reference = self.reference
        numbers, now = numbers_in(reference.tables.piecewise), reference.tables.shooting
        maps = local_maps(reference.tables.cycle, numbers, now)
        return smallest_section(maps, sizes(now, reference.dwell_times))

    @cached_property
    def _own_start(self) -> np.ndarray:
        return np.concatenate([self.reference.dwell_times, self.reference.states[0]])

    def _groups(self, values: Mapping[str, np.ndarray]) -> list[_Group]:
        system, declared = self.kernels.system, self.kernels.table.get("period")
        points, _ = parameter_points(system, {p.name: values[p.name] for p in system.parameters})
        period = np.full(len(points), np.nan) if declared is None else values[declared["name"]]
        return [
            _Group(
                g.places, points[g.places], self._cycle.at(g.structure), g.flat, period[g.places]
            )
            for g in numbers_at(system, points, self._cycle.configurations)
        ]

    def _tried(self, group: _Group, start: np.ndarray) -> _Solved:
        """Return the orbits from one start each; NaN where there is none."""
        cycle, count, (first, _) = group.cycle, len(group.cycle), self._section
        size = start.shape[-1] - count
        sound = np.isfinite(start).all(axis=-1) & (start[:, :count] > 0).all(axis=-1)
        sound &= finite_at(cycle, group.flat) & np.isfinite(group.points).all(axis=-1)
        rows = np.flatnonzero(sound)
        solved = _Solved(
            np.full((len(start), count), np.nan),
            np.full((len(start), count, size), np.nan),
            np.full((len(start), size, size), np.nan),
            np.full(len(start), INVALID, dtype=int),
            np.full(len(start), NO_ORBIT, dtype=int),
        )
        if not len(rows):
            return solved
        dwell, state, flat = start[rows, :count], start[rows, count:], group.flat[rows]
        with np.errstate(all="ignore"):
            if first:
                numbers = numbers_in(cycle.structure, flat)
                state = shoot(cycle, numbers, dwell, state, np).starts[first]
            guess = np.roll(dwell, -first, axis=1)
            turned, period = cycle.rotated(first), group.period[rows]
            found = solve_shape(turned, flat, guess, state, period)
        solved.dwell[rows] = np.roll(found.dwell, first, axis=1)
        solved.starts[rows] = np.roll(found.starts, first, axis=1)
        solved.maps[rows] = found.maps
        solved.status[rows] = without_digits(turned, flat, found, period)
        there = np.flatnonzero(solved.status == CONVERGED)
        solved.limit[there] = first_limits(
            self.kernels.system,
            cycle,
            group.points[there],
            group.flat[there],
            solved.dwell[there],
            solved.starts[there],
        )
        return solved

    def _stability(
        self, group: _Group, found: _Solved, here: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return traces of the Poincare map and margins of the converged orbits."""
        maps, cycle, (_, rank) = found.maps[here], group.cycle, self._section
        if not len(maps):
            return np.empty(0), np.empty(0)
        driven = mechanical_states(cycle)
        if driven is not None:
            fields = numbers_in(cycle.structure, group.flat[here]).fields[
                :, cycle.configurations[0]
            ]
            maps = stroboscopic_maps(cycle, fields, found.starts[here, 0], maps, driven)
        trace = np.trace(maps, axis1=-2, axis2=-1)
        values = np.linalg.eigvals(maps)
        if cycle.one_sided:
            return trace, np.full(len(maps), np.nan)
        if np.isnan(group.period).all():
            margin = 1 - np.abs(values).max(axis=-1)
        else:
            margin = _family_margins(values, trace, rank)
        return trace, np.where(np.abs(margin) <= ROUNDING, 0.0, margin)


def _family_margins(values: np.ndarray, trace: np.ndarray, rank: int) -> np.ndarray:
    """Return margins of orbits one of whose multipliers (n, k) is 1; 0 where neutral."""
    order = np.argsort(-np.abs(values), axis=-1, kind="stable")
    values = np.take_along_axis(values, order, axis=-1)
    trivial = np.argmin(np.abs(values - 1), axis=-1)[:, None]
    rest = np.abs(values)
    np.put_along_axis(rest, trivial, 0.0, axis=-1)
    margin = 1 - rest.max(axis=-1)
    margin[np.abs(margin) <= np.sqrt(LEAST)] = 0  # a neutral one may be a defective one
    if rank != 3:
        return np.asarray(margin)
    # of a reciprocal pair beside the 1 the sum keeps the digits
    pair = np.abs(values[:, :3].prod(axis=-1) - 1) < np.sqrt(LEAST)
    half = np.abs(trace - 1) / 2
    root = np.sqrt(np.maximum((half - 1) * (half + 1), 0))
    return np.where(pair, np.where(half <= 1, 0.0, 1 - (half + root)), margin)
