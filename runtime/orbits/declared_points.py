"""A declared orbit at the points of a chart, by compiled kernels of its own equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nonsmooth.runtime.model.kernels import ParameterTable
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.orbits.declared_kernels import DeclaredKernels
from nonsmooth.runtime.orbits.kernel_points import KernelPoints
from nonsmooth.runtime.orbits.orbit_arrays import Columns
from nonsmooth.runtime.orbits.table_points import TablePoints

__all__ = ["DeclaredPoints"]


@dataclass(frozen=True, eq=False)
class DeclaredPoints:
    """A composed orbit at many points, by kernels that stand in for it; see `OrbitPoints`."""

    own: DeclaredKernels
    points: KernelPoints  # the same orbit in the names of the kernels
    composed: TablePoints  # asked where the kernels are not `alone` and find no motion

    @classmethod
    def of(cls, own: DeclaredKernels, composed: TablePoints) -> DeclaredPoints:
        """Return the orbit, all of whose parameters have values."""
        unused = {p.name for p in own.kernels.other_parameters}
        names = [name for name in own.kernels.tables if name not in unused]
        return cls(own, KernelPoints.of(own.kernels, names), composed)

    @property
    def chunk(self) -> int:
        """See `OrbitPoints`."""
        return self.points.chunk if self.own.alone else self.composed.chunk

    @property
    def parameters(self) -> list[ParameterTable]:
        """See `OrbitPoints`."""
        return self.composed.parameters

    @property
    def unknowns(self) -> tuple[str, ...]:
        """See `OrbitPoints`: dwell times, then the start."""
        return self.composed.unknowns

    @property
    def bounded(self) -> tuple[str, ...]:
        """See `OrbitPoints`: no parameter is open."""
        return ()

    @property
    def limits(self) -> list[str]:
        """See `OrbitPoints`."""
        return self.points.limits if self.own.alone else self.composed.limits

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """See `OrbitPoints`."""
        kernels = self.own.kernels
        near = start
        if start is not None and not self.own.alone:
            near = start[:, self._reduced]
        found = self.points.solve(values, near)
        unknowns = {name: found[name] for name in kernels.unknowns}
        points = {name: values[name] for name in kernels.parameter_names}
        columns = {**found, **self.own.unknowns(points, unknowns)}
        if self.own.alone:
            return columns
        rest = np.flatnonzero(~columns["admissible"])
        columns["limit"] = np.full(len(columns["status"]), NEITHER)
        if len(rest):
            part = {name: column[rest] for name, column in values.items()}
            others = self.composed.solve(part, None if start is None else start[rest])
            for name, column in others.items():
                columns[name][rest] = column
        return columns

    def starts_of(self, columns: Columns) -> np.ndarray:
        """See `OrbitPoints`: reduced unknowns, or what the tables start from."""
        return (self.points if self.own.alone else self.composed).starts_of(columns)

    @property
    def usual(self) -> np.ndarray:
        """See `OrbitPoints`."""
        return (self.points if self.own.alone else self.composed).usual

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """See `OrbitPoints`."""
        return (self.points if self.own.alone else self.composed).limits_of(values, columns)

    @cached_property
    def _reduced(self) -> list[int]:
        """Indices of the kernels' reduced unknowns among all unknowns."""
        return [self.unknowns.index(name) for name in self.own.kernels.reduced]
