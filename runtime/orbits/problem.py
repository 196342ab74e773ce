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
        """``system/orbit``, ``FILE.py:orbit``, or the system and its number of phases."""

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
        """The symmetry that closes the orbit's first part, if it is solved for by that part."""

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states, in the coordinates of the equations."""

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Name of each phase's dwell time."""

    @property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the unknowns; one may be given, and a parameter solved for in its place."""

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
        """Name of the period where it may be given; None where the equations determine it."""

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """The parameters of the equations, with names, meanings and domains."""

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """All that may be given, by name: the equations' parameters and what they follow from."""

    @property
    def required(self) -> Mapping[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """Return the dwell time of each phase, from parameters and unknowns in any arithmetic.

        They are in the unit of time.
        """

    def followers(self, names: Iterable[str]) -> Collection[str]:
        """Return the parameters that follow from these: e1 = ur1 - us1 from ur1 and us1."""

    def period(self, orbit: Orbit) -> Value | None:
        """Return what the dwell times have to sum up to; None where the equations determine it."""

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """Return all parameters of the system, from the equations' and what these leave open.

        `InputError` is raised if they are not values that the system takes.
        """

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """Return all parameters of the system at an orbit, with names of those that were chosen.

        Parameters that the orbit leaves open are chosen, unless they are given in `beside`;
        what is chosen suits all orbits that are near, too. `model.completion` says how.
        `InputError` is raised as for `system_values`.
        """

    def system_start(self, orbit: Orbit, values: Mapping[str, Value]) -> list[Any]:
        """Return the approximate start (N,) in the system's coordinates, at all its parameters."""

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """Return the same orbit by the tables of its system, at all parameters of `physical`.

        `InputError` is raised if Newton's method finds no orbit by the tables.
        """

    def message(self, status: int, *, timed: bool) -> str:
        """Return what a status means and suggests, where the period was given (`timed`) or not."""

    def evaluation(self, orbit: Orbit) -> Evaluation:
        """Return what the equations tell at an orbit of this problem."""

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """Return states (..., N) at times (...) since a phase's start, from the state (N,) there.

        `parameters` (q,) are in their order; times are in the unit of time.
        """

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """Return a converged orbit to so many true decimal digits.

        The arithmetic is ``flint`` or ``mpmath``. `NoConvergence` is raised if Newton's
        method leaves the orbit.
        """


class Evaluation(Protocol):
    """The quantities that the equations give at one orbit, in its arithmetic."""

    @property
    def tables(self) -> TableEvaluation:
        """The evaluation by the tables of the system; InputError where kernels answer."""

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
        """How far one period moves each state: zero but along translations."""

    @property
    def free_states(self) -> tuple[str, ...]:
        """States that a translation of the system moves."""

    @property
    def border(self) -> tuple[str, str]:
        """The side on which the orbit has derivatives, and why; both are mostly empty."""

    def directions(self, by: Sequence[str]) -> Directions:
        """Return how the orbit moves with each of some numbers that were given.

        `InputError` says why where there is no derivative.
        """

    def along(self, found: OrbitDerivatives) -> tuple[OrbitMotionDerivatives, np.ndarray | None]:
        """Return the orbit by tables as it moves with parameters, and their rates (parameters, q).

        The rates are by what was given; None where the parameters are what was given.
        `InputError` is raised where the equations leave open how the parameters move.
        """

    def trajectory(self, periods: int) -> Trajectory:
        """Return the motion along the orbit over some periods, with all physical parameters.

        `InputError` is raised if the orbit does not determine them.
        """
