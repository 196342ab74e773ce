"""The equations of an orbit at many points near it, whoever answers: its kernels, or tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

import numpy as np

from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.orbits.kernel_equations import KernelEquations
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_equations import TableEquations
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["OrbitEquations", "equations_of"]


class OrbitEquations(Protocol):
    """The equations of one itinerary near an orbit of it.

    A point x (v,) holds all unknowns and what may be given in their place, by `names`; arrays
    of points are (k, v). Nondimensional, or in the units of the declaration.

    Attributes
    ----------
    names : tuple of str (v,)
    values : array (v,)
        The orbit's own numbers.
    unknowns : tuple of str (n,)
        Those that the orbit was solved for.
    dwell_names : tuple of str (p,)
        Of the phases that take time, of the part that the symmetry closes.
    phases : tuple of (configuration, boundary)
        Those phases.
    order : int
        As many parts, images of each other by a symmetry, make up one period.
    conservative : bool
        Whether orbits come in families that a first integral parametrises.
    """

    names: tuple[str, ...]
    values: np.ndarray
    unknowns: tuple[str, ...]
    dwell_names: tuple[str, ...]
    phases: tuple[tuple[str, str], ...]
    order: int
    conservative: bool

    @property
    def sizes(self) -> np.ndarray:
        """Units of measure (n,) of the unknowns."""

    def linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,), m >= n, at a point, and their Jacobian (m, n + 1).

        By the unknowns, and by the number at a further place of the point.

        Parameters
        ----------
        x : array (v,)
        place : int
            Index into `names`.

        Returns
        -------
        tuple of array (m,), array (m, n + 1)
        """

    def dwell(self, x: np.ndarray) -> np.ndarray:
        """Dwell times (k, p): affine in the points.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        array (k, p)
            In the unit of time.
        """

    def unevenness(self, x: np.ndarray) -> list[np.ndarray]:
        """By how much the state behind a part differs from the start, at a point.

        For each of the parts that the itinerary repeats. Where it is zero the branch meets that
        of the part, and comes back with the parts exchanged.

        Parameters
        ----------
        x : array (v,)

        Returns
        -------
        list of array (N,)
            In units of the states' sizes; empty where no part is repeated.
        """

    def waves(self, x: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Boundary functions of each phase, for groups of points whose places are given.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        list of (array of int, list of PhaseWaves)
            Places of the points of a group, and their phases.
        """

    def conditions(self, x: np.ndarray) -> np.ndarray:
        """Numbers (k, c) that keep their sign while transitions lead where they do.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        array (k, c)
        """

    @property
    def condition_places(self) -> Sequence[int]:
        """Phase whose end each of these conditions belongs to."""

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Which of its transitions each phase (k, p) takes, from these numbers.

        Parameters
        ----------
        conditions : array (k, c)
            As `conditions` gives them.

        Returns
        -------
        array (k, p) of int
            -1 where a phase takes none.
        """

    def multipliers(self, x: np.ndarray) -> np.ndarray:
        """Multipliers (k, r) over one part that may differ from zero, without trivial ones.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        array (k, r) of complex
        """

    def traces(self, x: np.ndarray) -> np.ndarray:
        """Traces (k,) of the Poincare map of the whole period.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        array (k,)
        """

    def admissible(self, x: np.ndarray) -> np.ndarray:
        """Whether the points (k,) are motions of the real system.

        Parameters
        ----------
        x : array (k, v)

        Returns
        -------
        array (k,) of bool
        """

    def orbit_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Orbit:
        """The orbit at a point as a record, with what is given there.

        Parameters
        ----------
        x : array (v,)
        given : mapping of str to Value
            Parameters, and the period where it is given.
        """

    def motion_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Motion | Trajectory:
        """The motion at a point; a phase that vanishes there takes no time.

        Parameters
        ----------
        x : array (v,)
        given : mapping of str to Value
            Parameters, and the period where it is given.

        Returns
        -------
        Motion or Trajectory
            A Trajectory where tables answer.
        """


def equations_of(orbit: Orbit) -> OrbitEquations:
    """The equations near an orbit, by its own kernels where these are the faster ones.

    Kernels of damped and forced motions are so where they are compiled alone: a compilation takes
    seconds, the tables of a system follow a branch in less.
    """
    kernels = orbit.problem.kernels
    if kernels is None:
        return TableEquations(orbit)
    if not kernels.trigonometric:
        return TableEquations(orbit.problem.by_tables(orbit))
    return KernelEquations(orbit)
