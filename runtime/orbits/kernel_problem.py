"""Periodic orbits whose equations have emitted kernels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.orbits.admissible import Admissibility, assess_admissibility
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.refine import refine_kernels
from nonsmooth.runtime.orbits.sensitivity import evaluate
from nonsmooth.runtime.orbits.stability import assess_stability
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    INVALID,
    NEGATIVE,
    OUTSIDE,
    SINGULAR,
    STALLED,
)

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.table_problem import TableEvaluation
    from nonsmooth.runtime.shooting.symmetry import Symmetry
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["STATUS", "KernelProblem"]

STATUS = {
    CONVERGED: "converged",
    STALLED: "not converged: give a guess nearer to the orbit, or none and let it be searched",
    INVALID: "not finite: a parameter is outside its domain or the guess is far from any orbit",
    NEGATIVE: "a dwell time is not positive: no motion has this itinerary here;"
    " change the parameters or search without a guess",
    OUTSIDE: "a parameter that was solved for is outside its domain: no such system exists;"
    " change what is given",
    SINGULAR: "singular: at these parameters (a resonance) the equations do not determine an"
    " orbit; there is none, or a whole family: change a parameter",
}


@dataclass(frozen=True)
class KernelProblem:
    """Orbits of an itinerary by the kernels of its own equations; see `OrbitProblem`."""

    kernels: OrbitKernels
    symmetry: Symmetry | None = None

    @property
    def name(self) -> str:
        """``system/orbit``, or ``FILE.py:orbit`` and the like."""
        return self.kernels.name

    @property
    def system(self) -> SystemKernels:
        """See `OrbitProblem`."""
        return self.kernels.system

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """See `OrbitProblem`."""
        return tuple((configuration, boundary) for configuration, boundary, _ in self._phases)

    @property
    def state_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        return tuple(self.kernels.table["states"])

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        return self.kernels.dwell_times

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """See `OrbitProblem`."""
        return self.kernels.parameters

    @property
    def required(self) -> Mapping[str, str]:
        """See `OrbitProblem`."""
        return self.kernels.required

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """See `OrbitProblem`."""
        return list(self.kernels.durations(values).values())

    def message(self, status: int, *, timed: bool) -> str:
        """See `OrbitProblem`."""
        return STATUS[status]

    def evaluation(self, orbit: Orbit) -> KernelEvaluation:
        """See `OrbitProblem`."""
        return KernelEvaluation(orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """See `OrbitProblem`."""
        kernel = f"flow_{self._phases[phase][0].replace('-', '_')}"
        spectrum, _ = self.kernels.spectrum(parameters)
        return np.asarray(self.kernels.evaluate(kernel, parameters, spectrum, since, start))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """See `OrbitProblem`."""
        return refine_kernels(orbit, digits, arithmetic)

    @property
    def _phases(self) -> list[tuple[str, str, str]]:
        phases: list[tuple[str, str, str]] = self.kernels.table["phases"]
        return phases


@dataclass(frozen=True, eq=False)
class KernelEvaluation:
    """What the kernels tell at an orbit; see `Evaluation`."""

    orbit: Orbit

    @property
    def tables(self) -> TableEvaluation:
        """See `Evaluation`."""
        raise InputError(f"{self.orbit.name} was solved with kernels, not with its system's tables")

    @cached_property
    def states(self) -> np.ndarray:
        """See `Evaluation`."""
        return self._array("states")[:-1]

    @cached_property
    def stability(self) -> Stability:
        """See `Evaluation`."""
        return assess_stability(self.orbit)

    @property
    def part_stability(self) -> Stability:
        """See `Evaluation`."""
        raise InputError("the orbit was not composed from a part and a symmetry")

    @cached_property
    def admissibility(self) -> Admissibility:
        """See `Evaluation`."""
        return assess_admissibility(self.orbit)

    @cached_property
    def saltations(self) -> np.ndarray:
        """See `Evaluation`."""
        size = len(self.orbit.state_names)
        return self._array("saltations").reshape(-1, size, size)

    @cached_property
    def monodromy(self) -> np.ndarray:
        """See `Evaluation`."""
        return self._array("monodromy")

    @cached_property
    def poincare_jacobian(self) -> np.ndarray:
        """See `Evaluation`."""
        return self._array("poincare_jacobian")

    @property
    def shift(self) -> dict[str, Any]:
        """Zero: an orbit with kernels comes back to where it was."""
        zero = self.orbit.arithmetic.mp.zero if self.orbit.precise else 0.0
        return dict.fromkeys(self.orbit.state_names, zero)

    @property
    def free_states(self) -> tuple[str, ...]:
        """See `Evaluation`."""
        return ()

    def trajectory(self, periods: int) -> Trajectory:
        """None, where the equations leave physical parameters open."""
        raise InputError(
            f"{self.orbit.name} does not determine all physical parameters: ask its motion()"
        )

    def _array(self, kernel: str) -> np.ndarray:
        found = evaluate(self.orbit, kernel)
        return np.array(found, dtype=object) if self.orbit.precise else np.asarray(found)
