"""Periodic orbits whose equations have emitted kernels."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import SystemPoint, complete_system, followers
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import Admissibility, assess_admissibility
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.directions import Directions
from nonsmooth.runtime.orbits.kernel_directions import along_tables, kernel_directions
from nonsmooth.runtime.orbits.kernel_values import evaluate
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.physical_parameters import physical_parameters
from nonsmooth.runtime.orbits.refine import refine_kernels
from nonsmooth.runtime.orbits.stability import assess_stability
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.fitting_start import fitting_start
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.newton import (
    BEYOND,
    CONVERGED,
    INVALID,
    NEGATIVE,
    OUTSIDE,
    SINGULAR,
    STALLED,
    UNSURE,
)
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.table_problem import TableEvaluation
    from nonsmooth.runtime.shooting.symmetry import Symmetry
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["STATUS", "KernelProblem"]

STATUS = {
    CONVERGED: "converged",
    STALLED: "not converged: give a guess nearer to the orbit, or none and let it be searched",
    INVALID: "not finite: a parameter is outside its domain or the guess is far from any orbit",
    NEGATIVE: "a dwell time is not positive, or is zero within its error: no motion has this"
    " itinerary here; change the parameters or search without a guess",
    OUTSIDE: "a parameter that was solved for is outside its domain: no such system exists;"
    " change what is given",
    SINGULAR: "singular: at these parameters (a resonance) the equations do not determine an"
    " orbit; there is none, or a whole family: change a parameter",
    UNSURE: BEYOND,
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
    def unknown_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        return self.kernels.unknowns

    @property
    def has_trajectory(self) -> bool:
        """See `OrbitProblem`."""
        return False

    @property
    def start_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        taken = {*self.dwell_time_names, *(table.name for table in self.system.parameters)}
        return start_names(structure_of(self.system).states, taken)

    @property
    def forcing(self) -> tuple[tuple[int, int], ...]:
        """Empty: what the kernels solve for is shown as it is."""
        return ()

    @property
    def period_name(self) -> str | None:
        """See `OrbitProblem`: of a conservative orbit."""
        return self.kernels.period_name

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """See `OrbitProblem`."""
        return self.kernels.parameters

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """See `OrbitProblem`."""
        return self.kernels.tables

    @property
    def required(self) -> Mapping[str, str]:
        """See `OrbitProblem`."""
        return self.kernels.required

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """See `OrbitProblem`."""
        return list(self.kernels.durations(values).values())

    def followers(self, names: Iterable[str]) -> Collection[str]:
        """See `OrbitProblem`."""
        return followers(self.kernels, names)

    def period(self, orbit: Orbit) -> Value | None:
        """See `OrbitProblem`."""
        given = orbit.given.get(self.period_name or "")
        if given is None and self.kernels.table["conservative"]:
            return as_value(float(orbit.period))
        return given

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """See `OrbitProblem`."""
        return complete_system(self.kernels, values).values

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """See `OrbitProblem`."""
        return physical_parameters(orbit, beside, near)

    def system_start(self, orbit: Orbit, values: Mapping[str, Value]) -> list[Any]:
        """Return the start (N): the orbit's, or the best fit of dwell times in other states."""
        if self._in_system_states:
            return list(orbit.states[0].tolist())
        point = piecewise(self.system, values)
        cycle = itinerary_shape(point.structure, self.itinerary)
        numbers = numbers_of(point)[None]
        with np.errstate(all="ignore"):
            found = fitting_start(cycle, numbers, orbit.dwell_times.astype(float)[None])
        return list(found[0].tolist())

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """Return the orbit by the tables of its system, without phases that take no time.

        See `OrbitProblem`.
        """
        values, dwell = self.physical(orbit, beside).values, orbit.dwell_times.astype(float)
        every = not orbit.evaluation.border[0]
        lasting = [place for place, wait in enumerate(dwell.tolist()) if every or wait > 0]
        first = orbit.states[lasting[0]]
        start = first.astype(float).tolist() if self._in_system_states else None
        found = solve_itinerary(
            self.system,
            values,
            _joined(self.itinerary, lasting),
            dwell[lasting].tolist(),
            start,
            period=self.period(orbit),
        )
        if not found.converged:
            raise InputError(f"{self.name}: {found.message}")
        return found

    def message(self, status: int, *, timed: bool) -> str:
        """See `OrbitProblem`."""
        return STATUS[status]

    def evaluation(self, orbit: Orbit) -> KernelEvaluation:
        """See `OrbitProblem`."""
        return KernelEvaluation(orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """See `OrbitProblem`."""
        spectrum, _ = self.kernels.spectrum(parameters)
        arrays = (parameters, spectrum, since, start)
        return np.asarray(self.kernels.flow(self._phases[phase][0], *arrays))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """See `OrbitProblem`."""
        return refine_kernels(orbit, digits, arithmetic)

    @property
    def _in_system_states(self) -> bool:
        """Whether the kernels' coordinates are the system's states, not those of a presentation."""
        own: bool = self.kernels.table["states"] == self.system.table["states"]
        return own

    @property
    def _phases(self) -> list[tuple[str, str, str]]:
        phases: list[tuple[str, str, str]] = self.kernels.table["phases"]
        return phases


def _joined(
    itinerary: tuple[tuple[str, str], ...], lasting: Sequence[int]
) -> tuple[tuple[str, str], ...]:
    """Return the phases that take time, each with all boundaries reached at its end.

    Boundaries that end the vanishing phases behind a phase are joined to its boundary.
    """
    ends: list[list[str]] = []
    turned = np.roll(np.arange(len(itinerary)), -int(lasting[0])).tolist()
    for place in turned:
        if place in lasting:
            ends.append([])
        ends[-1] += itinerary[place][1].split("+")
    names = ["+".join(sorted(reached)) for reached in ends]
    return tuple((itinerary[p][0], name) for p, name in zip(lasting, names, strict=True))


@dataclass(frozen=True, eq=False)
class KernelEvaluation:
    """The quantities that the kernels give at an orbit; see `Evaluation`."""

    orbit: Orbit

    @property
    def tables(self) -> TableEvaluation:
        """Nothing: `InputError` is always raised, as kernels answer."""
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
        """Nothing: `InputError` is always raised, as there is no part."""
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

    @property
    def border(self) -> tuple[str, str]:
        """See `Evaluation`."""
        side = self.stability.one_sided
        return side, "a border collision, a phase takes no time" if side else ""

    def along(self, found: OrbitDerivatives) -> tuple[OrbitMotionDerivatives, np.ndarray]:
        """See `Evaluation`."""
        return along_tables(self.orbit, found)

    def directions(self, by: Sequence[str]) -> Directions:
        """See `Evaluation`."""
        return kernel_directions(self.orbit, by)

    def trajectory(self, periods: int) -> Trajectory:
        """Return the motion by the system's tables; see `Evaluation`.

        `InputError` is raised where the equations leave physical parameters open.
        """
        problem = self.orbit.problem
        if problem.physical(self.orbit).chosen:
            raise InputError(
                f"{self.orbit.name} does not determine all physical parameters: ask its motion()"
            )
        return problem.by_tables(self.orbit).trajectory(periods)

    def _array(self, kernel: str) -> np.ndarray:
        found = evaluate(self.orbit, kernel)
        return np.array(found, dtype=object) if self.orbit.precise else np.asarray(found)
