"""What is asked of a periodic orbit, whoever answers: emitted kernels, or its system's tables."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import SystemPoint
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.symmetry import Symmetry

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.admissible import Admissibility
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.directions import Directions
    from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.orbits.table_problem import TableEvaluation
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Evaluation", "OrbitProblem"]


class OrbitProblem(Protocol):
    """The periodic orbits of one itinerary of a system.

    It holds the kernels or tables it was made with: nothing is loaded again, whatever becomes
    of the file that declared them.
    """

    @property
    def name(self) -> str:
        """``system/orbit``, ``FILE.py:orbit``, or the system and how many phases there are."""

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""

    @property
    def kernels(self) -> OrbitKernels | None:
        """Kernels of the orbit's own equations, where they were derived."""

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configuration and boundary of each phase of a period."""

    @property
    def symmetry(self) -> Symmetry | None:
        """What closes the first part of the orbit, where it is solved for by that part."""

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states, in the coordinates of the equations."""

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Name of each phase's dwell time."""

    @property
    def unknown_names(self) -> tuple[str, ...]:
        """What is solved for, unless it is given and a parameter is solved for in its place."""

    @property
    def has_trajectory(self) -> bool:
        """Whether an orbit determines all parameters of its system, and so a trajectory."""

    @property
    def start_names(self) -> tuple[str, ...]:
        """Name of each of the system's states at the start."""

    @property
    def forcing(self) -> tuple[tuple[int, int], ...]:
        """Places of the cosine and the sine of each forcing among the states."""

    @property
    def period_name(self) -> str | None:
        """What the period is called where it is given; None where the equations determine it."""

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """Names, meanings and domains of the parameters of the equations."""

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """All that may be given, by name: those of the equations, and what they follow from."""

    @property
    def required(self) -> Mapping[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """Dwell time of each phase, from parameters and unknowns.

        Parameters
        ----------
        values : mapping of str to number
            Parameters and unknowns, in any arithmetic.

        Returns
        -------
        list of number
            One for each phase, in the unit of time.
        """

    def followers(self, names: Iterable[str]) -> Collection[str]:
        """Parameters that follow from those of these names: e1 = ur1 - us1 from ur1 and us1."""

    def period(self, orbit: Orbit) -> Value | None:
        """What the dwell times have to sum up to; None where the equations determine it.

        Returns
        -------
        Value or None
            In the unit of time.
        """

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """All parameters of the system, from those of the equations and what they leave open.

        Parameters
        ----------
        values : mapping of str to Value
            Parameters of the equations, and those that they leave open.

        Raises
        ------
        InputError
            If they are not values that the system takes.
        """

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """All parameters of the system at an orbit; those that it leaves open are chosen.

        Values that are given beside it are not chosen, and what is chosen suits all orbits
        that are near; `model.completion` says how. InputError as for `system_values`.

        Parameters
        ----------
        orbit : Orbit
        beside : mapping of str to number or None
            Values of parameters that the orbit leaves open.
        near : iterable of Orbit
            Others that what is chosen has to suit.

        Returns
        -------
        SystemPoint
            Values of all parameters, and the names of those that were chosen.

        Raises
        ------
        InputError
            As for `system_values`.
        """

    def system_start(self, orbit: Orbit, values: Mapping[str, Value]) -> list[Any]:
        """State (N,) at the start in the system's coordinates, about; at all its parameters.

        Parameters
        ----------
        orbit : Orbit
        values : mapping of str to Value
            Of all parameters of the system.

        Returns
        -------
        list of number
            N states.
        """

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """The same orbit by the tables of its system, at all of its parameters; see `physical`.

        Parameters
        ----------
        orbit : Orbit
        beside : mapping of str to number or None
            Values of parameters that the orbit leaves open.

        Raises
        ------
        InputError
            If Newton's method finds no orbit by the tables.
        """

    def message(self, status: int, *, timed: bool) -> str:
        """What a status means and suggests, where the period was given or not.

        Parameters
        ----------
        status : int
        timed : bool
            Whether the period was given.
        """

    def evaluation(self, orbit: Orbit) -> Evaluation:
        """What the equations tell at an orbit of this problem."""

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """States (..., N) at times (...) since a phase's start; parameters in their order.

        Parameters
        ----------
        parameters : array (q,)
        phase : int
            Index of the phase.
        since : array (...)
            In the unit of time.
        start : array (N,)
            State at the start of the phase.

        Returns
        -------
        array (..., N)
        """

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """The same orbit to true decimal digits.

        Parameters
        ----------
        orbit : Orbit
            Converged.
        digits : int
        arithmetic : str
            ``flint`` or ``mpmath``.

        Raises
        ------
        NoConvergence
            If Newton's method leaves the orbit.
        """


class Evaluation(Protocol):
    """What the equations tell at one orbit, in its own arithmetic."""

    @property
    def tables(self) -> TableEvaluation:
        """What the tables of the system tell; InputError where kernels answer."""

    @property
    def states(self) -> np.ndarray:
        """State (p, N) at the start of each phase, behind the transition before it."""

    @property
    def stability(self) -> Stability:
        """Multipliers, trace and verdict."""

    @property
    def part_stability(self) -> Stability:
        """Multipliers over the part that the symmetry closes."""

    @property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system."""

    @property
    def saltations(self) -> np.ndarray:
        """Saltation matrix (p, N, N) of each transition."""

    @property
    def monodromy(self) -> np.ndarray:
        """Product (N, N) of flows and saltation matrices over a period."""

    @property
    def poincare_jacobian(self) -> np.ndarray:
        """Derivative of the Poincare map, in coordinates of the section or in all."""

    @property
    def shift(self) -> dict[str, Any]:
        """By how much each state is moved behind one period: zero but along translations."""

    @property
    def free_states(self) -> tuple[str, ...]:
        """States that a translation of the system moves."""

    @property
    def border(self) -> tuple[str, str]:
        """On which side the orbit has derivatives, and what happens there; both empty mostly."""

    def directions(self, by: Sequence[str]) -> Directions:
        """How the orbit moves with each of some numbers that were given.

        Raises
        ------
        InputError
            Where there is no derivative; the message says why.
        """

    def along(self, found: OrbitDerivatives) -> tuple[OrbitMotionDerivatives, np.ndarray | None]:
        """The orbit by tables as it moves with parameters, and their rates by what was given.

        Parameters
        ----------
        found : OrbitDerivatives
            Of this orbit.

        Returns
        -------
        motion : OrbitMotionDerivatives
        rates : array (parameters, q) or None
            None where they are what was given.

        Raises
        ------
        InputError
            Where the equations leave open how the parameters move.
        """

    def trajectory(self, periods: int) -> Trajectory:
        """The motion along the orbit, with all physical parameters.

        Raises
        ------
        InputError
            If the orbit does not determine all physical parameters.
        """
