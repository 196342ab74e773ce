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
    """What is found of an orbit at many points (n,), each by itself."""

    @property
    def chunk(self) -> int:
        """Points that take tenths of a second."""

    @property
    def parameters(self) -> list[ParameterTable]:
        """Parameters that have to have a value."""

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns."""

    @property
    def bounded(self) -> tuple[str, ...]:
        """Open parameters, of which it is told what they have to exceed."""

    @property
    def limits(self) -> list[str]:
        """What the numbers of `limits_of` stand for, from 0."""

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """Find orbits from starts (n, m), or from the solver's own.

        Columns (n,): status, admissible, trace, margin, period, and by name the unknowns and
        ``least_`` of what is bounded.

        Parameters
        ----------
        values : mapping of str to array (n,)
            What is fixed or swept.
        start : array (n, m) or None
            As `starts_of` gives it.

        Returns
        -------
        dict of str to array (n,)
        """

    def starts_of(self, columns: Columns) -> np.ndarray:
        """Starts (n, m) from which the same orbits are found again.

        Parameters
        ----------
        columns : dict of str to array (n,)
            As `solve` gives them.

        Returns
        -------
        array (n, m)
        """

    @property
    def usual(self) -> np.ndarray:
        """Sizes (m,) at the reference orbit of what starts are made of; 0 of dwell times."""

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """Which limit of admissibility fails first, by its number; or NEITHER, NO_ORBIT, UNTOLD.

        Parameters
        ----------
        values : mapping of str to array (n,)
            What is fixed or swept.
        columns : dict of str to array (n,)
            As `solve` gives them.

        Returns
        -------
        array (n,) of int
        """


@cache
def points_of(
    kernels: OrbitKernels, given: tuple[str, ...], own: DeclaredKernels | None = None
) -> OrbitPoints:
    """An orbit at many points, where what is fixed or swept has these names.

    Parameters
    ----------
    kernels : OrbitKernels
    given : tuple of str
        Names.
    own : DeclaredKernels, optional
        Compiled kernels that stand in for the tables of an orbit that is composed.

    Raises
    ------
    InputError
        For a name that fixes nothing, several that fix one parameter twice, or an orbit of
        which many points at once cannot be found.
    """
    if kernels.derived:
        return KernelPoints.of(kernels, given)
    composed = TablePoints.of(kernels)
    return composed if own is None else DeclaredPoints.of(own, composed)
