"""An orbit at many points by the tables of its system: solved, judged, its limits named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.model.parameter_batches import parameter_points
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.orbits.declared_solve import solve_declared, unknowns_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Columns
from nonsmooth.runtime.orbits.table_batch import TableBatch
from nonsmooth.runtime.orbits.table_many import section_of
from nonsmooth.runtime.shooting.multipliers import ROUNDING, family_margins
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape
from nonsmooth.runtime.shooting.table_newton import sizes

__all__ = ["TablePoints"]


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
        system, declared = self.kernels.system, self.kernels.table.get("period")
        points, _ = parameter_points(system, {p.name: values[p.name] for p in system.parameters})
        given = np.full(len(points), np.nan) if declared is None else values[declared["name"]]
        names, count, size = self.unknowns, len(self._cycle), len(points)
        if start is None:
            start = np.broadcast_to(self._own_start, (size, len(names)))
        dwell = np.where(start[:, :count] > 0, start[:, :count], np.nan)
        found = self._batch.solve(points, dwell, start[:, count:], given, limits=True)
        there = found.converged
        columns = {name: np.full(size, np.nan) for name in ("trace", "margin", "period", *names)}
        columns["status"], columns["limit"] = found.status.astype(int), found.limit
        columns["admissible"] = found.limit == NEITHER
        maps, timed = found.maps[there], not np.isnan(given).all()
        trace = np.trace(maps, axis1=-2, axis2=-1)
        columns["trace"][there] = trace
        columns["margin"][there] = self._margins(maps, trace, timed=timed)
        columns["period"][there] = found.dwell[there].sum(axis=-1)
        numbers = np.concatenate([found.dwell[there], found.starts[there, 0]], axis=-1)
        for name, column in zip(names, numbers.T, strict=True):
            columns[name][there] = column
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

    def _margins(self, maps: np.ndarray, trace: np.ndarray, *, timed: bool) -> np.ndarray:
        """Return margins (n,) of orbits with these maps (n, m, m), whose period may be given."""
        if self._cycle.one_sided or not len(maps):
            return np.full(len(maps), np.nan)
        values = np.linalg.eigvals(maps)
        if timed:
            margin = family_margins(values, trace, self._section[1])
        else:
            margin = 1 - np.abs(values).max(axis=-1)
        return np.where(np.abs(margin) <= ROUNDING, 0.0, margin)
