"""One orbit at many points of a chart, whoever answers: its kernels, or tables."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Protocol

import numpy as np

from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.orbits.declared_kernels import DeclaredKernels
from nonsmooth.runtime.orbits.declared_points import DeclaredPoints
from nonsmooth.runtime.orbits.kernel_points import KernelPoints
from nonsmooth.runtime.orbits.orbit_arrays import Columns
from nonsmooth.runtime.orbits.table_points import TablePoints

__all__ = ["OrbitPoints", "points_of"]


class OrbitPoints(Protocol):
    """One orbit at many points (n,), solved for at each by itself."""

    @property
    def chunk(self) -> int:
        """Number of points that take tenths of a second."""

    @property
    def parameters(self) -> list[ParameterTable]:
        """Parameters that have to have a value."""

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns."""

    @property
    def bounded(self) -> tuple[str, ...]:
        """Open parameters of which a lower bound is computed."""

    @property
    def limits(self) -> list[str]:
        """Meanings of the numbers of `limits_of`, from 0."""

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """Return orbits from starts (n, m), or from the solver's usual ones, as columns (n,).

        `values` (n,) has what is fixed or swept; starts are those of `starts_of`. Columns are
        status, admissible, trace, margin, period, and by name the unknowns and ``least_`` of
        what is bounded.
        """

    def starts_of(self, columns: Columns) -> np.ndarray:
        """Return starts (n, m) that lead to the same orbits again, from the columns of `solve`."""

    @property
    def usual(self) -> np.ndarray:
        """Sizes (m,) at the reference orbit of what starts are made of; 0 for dwell times."""

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """Return which limit of admissibility fails first (n,), by its number in `limits`.

        It is NEITHER where none fails, NO_ORBIT or UNTOLD. `values` (n,) has what is fixed or
        swept, `columns` are those of `solve`.
        """


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
    composed = TablePoints.of(kernels)
    return composed if own is None else DeclaredPoints.of(own, composed)
