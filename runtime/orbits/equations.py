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

    A point x (v,) holds all unknowns and what may be given in their place, by `names`;
    arrays of points are (k, v). Numbers are nondimensional, or in the units of the
    declaration.
    """

    names: tuple[str, ...]
    values: np.ndarray  # (v,), the orbit's
    unknowns: tuple[str, ...]  # names (n,) of what the orbit was solved for
    # (p,), of the phases that take time, of the part that the symmetry closes
    dwell_names: tuple[str, ...]
    phases: tuple[tuple[str, str], ...]  # configuration and boundary of these phases
    order: int  # so many parts, images of each other by a symmetry, make up one period
    conservative: bool  # whether orbits come in families that a first integral parametrises

    @property
    def sizes(self) -> np.ndarray:
        """Typical sizes (n,) of the unknowns, as units of measure."""

    def linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Return left-hand sides (m,), m >= n, at a point, and their Jacobian (m, n + 1).

        The columns are derivatives by the unknowns, then by the number at `place` among
        `names`.
        """

    def dwell(self, x: np.ndarray) -> np.ndarray:
        """Return the dwell times (k, p) at points (k, v): affine in them, in the unit of time."""

    def unevenness(self, x: np.ndarray) -> list[np.ndarray]:
        """Return how far the state behind a part differs from the start (N,), at a point.

        There is one array for each of the parts that the itinerary repeats, in units of the
        states' sizes; the list is empty where no part is repeated. Where the difference is
        zero the branch meets that of the part, and comes back with the parts exchanged.
        """

    def waves(self, x: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Return groups of points with the boundary functions of each of their phases.

        A group is given by the places (int) of its points among the points (k, v).
        """

    def conditions(self, x: np.ndarray) -> np.ndarray:
        """Return numbers (k, c) that keep their sign while transitions lead where they do."""

    @property
    def condition_places(self) -> Sequence[int]:
        """The phase at whose end each of these conditions is asked."""

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Return the number (k, p) of the transition that each phase takes; -1 where it takes none.

        `conditions` (k, c) are those of the method of that name.
        """

    def multipliers(self, x: np.ndarray) -> np.ndarray:
        """Return the complex multipliers (k, r) over one part that may differ from zero.

        Trivial ones are left out.
        """

    def traces(self, x: np.ndarray) -> np.ndarray:
        """Return traces (k,) of the Poincare map of the whole period."""

    def admissible(self, x: np.ndarray) -> np.ndarray:
        """Return whether each of the points (k, v) is a motion of the real system."""

    def orbit_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Orbit:
        """Return the orbit at a point (v,) as a record.

        `given` has the parameters, and the period where it is given.
        """

    def motion_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Motion | Trajectory:
        """Return the motion at a point (v,); a phase that vanishes there takes no time.

        It is a Trajectory where tables answer. `given` has the parameters, and the period if
        given.
        """


def equations_of(orbit: Orbit) -> OrbitEquations:
    """Return the equations near an orbit: those of its kernels where they are the faster ones.

    Kernels of damped and forced motions are faster only where they are compiled: a
    compilation takes seconds, and the tables of a system follow a branch in less.
    """
    kernels = orbit.problem.kernels
    if kernels is None:
        return TableEquations(orbit)
    if not kernels.trigonometric:
        return TableEquations(orbit.problem.by_tables(orbit))
    return KernelEquations(orbit)
