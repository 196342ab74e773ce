"""What is asked of a periodic orbit, whoever answers: emitted kernels, or its system's tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.symmetry import Symmetry

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.admissible import Admissibility
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
    def parameters(self) -> tuple[ParameterTable, ...]:
        """Names, meanings and domains of the parameters of the equations."""

    @property
    def required(self) -> Mapping[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """Dwell time of each phase, from parameters and unknowns."""

    def message(self, status: int, *, timed: bool) -> str:
        """What a status means and suggests, where the period was given or not."""

    def evaluation(self, orbit: Orbit) -> Evaluation:
        """What the equations tell at an orbit of this problem."""

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """States (..., N) at times (...) since a phase's start; parameters in their order."""

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """The same orbit to true decimal digits."""


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

    def trajectory(self, periods: int) -> Trajectory:
        """The motion along the orbit, with all physical parameters."""
