"""Periodic orbits by the tables of their system: any itinerary, composed at run time."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.boundary_sets import mask_of, mask_type
from nonsmooth.runtime.model.completion import SystemPoint, system_parameters
from nonsmooth.runtime.model.engine_run import Run, Status
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernels import ParameterTable, SystemKernels
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    piecewise,
    piecewise_at,
    piecewise_in,
)
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import Admissibility
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.directions import Directions, table_directions
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit
from nonsmooth.runtime.orbits.refine import refine_tables
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.shooting.closure_conditions import closing, closure_equations
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.newton import CONVERGED, LEAST, SINGULAR
from nonsmooth.runtime.shooting.section_map import assess, saltations
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import Symmetry
from nonsmooth.runtime.shooting.table_newton import message_of, sizes
from nonsmooth.runtime.shooting.translations import (
    gauges_of,
    translations_of,
    up_to_shift,
)
from nonsmooth.runtime.shooting.variational import Shooting
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["TableEvaluation", "TableProblem", "labelled", "labelled_as", "motion_along", "orbit_of"]


@dataclass(frozen=True)
class TableProblem:
    """Orbits of an itinerary by the tables of its system; see `KernelProblem`."""

    system: SystemKernels
    # of the whole period; boundaries that are reached together are joined, "a+b"
    itinerary: tuple[tuple[str, str], ...]
    # what closes the first part of the orbit, where it is solved for by that part
    symmetry: Symmetry | None = field(default=None, compare=False)
    label: str | None = None  # "FILE.py:ORBIT" and the like, where the orbit is a declared one
    # of the unknowns: dwell times, then start; empty for the usual ones
    names: tuple[str, ...] = ()

    kernels: ClassVar[None] = None  # the equations are composed from the tables
    has_trajectory: ClassVar[bool] = True
    period_name: ClassVar[str] = PERIOD
    required: ClassVar[Mapping[str, str]] = MappingProxyType({})  # all parameters are given

    @property
    def name(self) -> str:
        """Label of the orbit, or its system and how many phases it has."""
        return self.label or cycle_label(self.system.name, len(self.itinerary))

    @property
    def state_names(self) -> tuple[str, ...]:
        """See `KernelProblem`."""
        return tuple(self.system.table["states"])

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """See `KernelProblem`."""
        return self.system.parameters

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """See `KernelProblem`."""
        return {table.name: table for table in self.parameters}

    @cached_property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the dwell times, then of the start's coordinates: x10 for the state x1."""
        if self.names:
            return self.names
        states, parameters = self.state_names, [p.name for p in self.parameters]
        dwell = dwell_names(len(self.itinerary), {*states, *parameters})
        return (*dwell, *start_names(states, {*dwell, *parameters}))

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Names of the dwell times: tau1, tau2, ... where none were declared."""
        return self.unknown_names[: len(self.itinerary)]

    @property
    def start_names(self) -> tuple[str, ...]:
        """See `KernelProblem`."""
        return self.unknown_names[len(self.itinerary) :]

    @property
    def forcing(self) -> tuple[tuple[int, int], ...]:
        """See `KernelProblem`."""
        return structure_of(self.system).forcing

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """See `KernelProblem`."""
        return [values[name] for name in self.dwell_time_names]

    def followers(self, names: Iterable[str]) -> Collection[str]:
        """See `KernelProblem`: all parameters are given."""
        return ()

    def period(self, orbit: Orbit) -> Value | None:
        """See `KernelProblem`."""
        return orbit.given_period

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """See `KernelProblem`: nothing is left open."""
        return system_parameters(self.system, {p.name: values[p.name] for p in self.parameters})

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """See `KernelProblem`: nothing is left open."""
        return SystemPoint(orbit.parameters, ())

    def system_start(self, orbit: Orbit, values: Mapping[str, Value]) -> list[Any]:
        """See `KernelProblem`."""
        return list(orbit.states[0].tolist())

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """See `KernelProblem`: the orbit itself."""
        return orbit

    def message(self, status: int, *, timed: bool) -> str:
        """See `KernelProblem`."""
        return message_of(status, timed=timed)

    def evaluation(self, orbit: Orbit) -> TableEvaluation:
        """See `KernelProblem`."""
        return TableEvaluation(self, orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """See `KernelProblem`."""
        point = piecewise_at(self.system, parameters)
        configuration = point.structure.configuration(self.itinerary[phase][0])
        times = np.asarray(since, dtype=float)
        starts = np.broadcast_to(np.asarray(start, dtype=float), (times.size, len(start)))
        states = flow_states(point, configuration, times.ravel(), starts)
        return states.reshape(*times.shape, len(start))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """See `KernelProblem`: with mpmath, in whichever arithmetic is asked for."""
        return refine_tables(orbit, digits)


def orbit_of(
    problem: TableProblem,
    parameters: Mapping[str, Value],
    period: Value | None,
    dwell_times: np.ndarray,
    states: np.ndarray,
    residual: Any,
    digits: int,
    iterations: int,
    status: int,
) -> Orbit:
    """Return the record of an orbit from dwell times (p,) and states (p, N) where phases begin.

    All physical parameters are given; the period is None where it was not. `residual` is
    that of the closure, `digits` are those that are true, `iterations` those of Newton's
    method.
    """
    unknowns = [*dwell_times.tolist(), *states[0].tolist()]
    given = dict(parameters) if period is None else {**parameters, PERIOD: period}
    return Orbit(
        problem,
        given,
        dict(zip(problem.unknown_names, unknowns, strict=True)),
        {},
        residual,
        digits,
        iterations,
        status,
        states,
    )


def labelled_as(orbit: Orbit, known: Orbit) -> Orbit:
    """Return an orbit with the label and the names of unknowns of another one by tables."""
    assert isinstance(known.problem, TableProblem)
    return labelled(orbit, known.problem.label, known.problem.names)


def labelled(orbit: Orbit, label: str | None, names: Sequence[str]) -> Orbit:
    """Return the orbit with the label and the names of unknowns that a declaration gives it.

    The names are those of the dwell times, then of the start's coordinates.
    """
    assert isinstance(orbit.problem, TableProblem)
    problem = replace(orbit.problem, label=label, names=tuple(names))
    unknowns = dict(zip(problem.unknown_names, orbit.unknowns.values(), strict=True))
    return replace(orbit, problem=problem, unknowns=unknowns)


@dataclass(frozen=True, eq=False)
class TableEvaluation:
    """The quantities that the tables give at an orbit; see `KernelEvaluation`."""

    problem: TableProblem
    orbit: Orbit

    @property
    def tables(self) -> TableEvaluation:
        """Itself: it is by the tables of the system."""
        return self

    @property
    def states(self) -> np.ndarray:
        """See `KernelEvaluation`."""
        assert self.orbit.starts is not None
        return self.orbit.starts

    @cached_property
    def cycle(self) -> ItineraryShape:
        """The itinerary looked up in the system."""
        return itinerary_shape(self.piecewise.structure, self.problem.itinerary)

    @cached_property
    def piecewise(self) -> PiecewiseLinear:
        """The system at these parameters, in the orbit's arithmetic."""
        system, parameters = self.problem.system, self.orbit.parameters
        if self.orbit.precise:
            return piecewise_in(system, parameters, self.orbit.arithmetic)
        return piecewise(system, parameters)

    @cached_property
    def translations(self) -> np.ndarray:
        """Directions (m, N) along which the system does not change; m = 0 is the rule."""
        return translations_of(self.piecewise)

    @property
    def shift(self) -> dict[str, Any]:
        """See `KernelEvaluation`."""
        return dict(zip(self.problem.state_names, self.moved.tolist(), strict=True))

    @property
    def free_states(self) -> tuple[str, ...]:
        """See `KernelEvaluation`."""
        names = self.problem.state_names
        return tuple(names[k] for k in np.flatnonzero(self.translations.any(axis=0)))

    @property
    def border(self) -> tuple[str, str]:
        """See `KernelEvaluation`."""
        for place, transition in enumerate(self.cycle.transitions):
            if len(transition.boundaries) > 1:
                names = self.problem.itinerary[place][1].replace("+", " and ")
                return "that of this itinerary", f"{names} are reached together"
        return "", ""

    def directions(self, by: Sequence[str]) -> Directions:
        """See `KernelEvaluation`."""
        return table_directions(self, by)

    def along(self, found: OrbitDerivatives) -> tuple[OrbitMotionDerivatives, None]:
        """See `KernelEvaluation`."""
        return OrbitMotionDerivatives(self.orbit, found.by, found.directions), None

    @property
    def moved(self) -> np.ndarray:
        """How far one period moves each state (N,): zero but along translations."""
        return np.asarray(
            self.shooting.starts[-1][gauges_of(self.translations)] @ self.translations
        )

    @property
    def states_up_to_shift(self) -> np.ndarray:
        """The states (p, N), each moved back along the translations to where the orbit starts."""
        return up_to_shift(self.states, self.translations)

    @cached_property
    def shooting(self) -> Shooting:
        """One passage of the cycle and its linearisation."""
        numbers, lib = self._numbers, self._functions
        return shoot(self.cycle, numbers, self.orbit.dwell_times, self.states[0], lib)

    @cached_property
    def family(self) -> bool:
        """Whether the orbit is one of a family: 1 is a multiplier, to double precision.

        `InputError` is raised if there is no orbit.
        """
        self._check_found()
        lib = self.orbit.arithmetic if self.orbit.precise else FLOATS
        part, numbers, now, dwell = self._part
        matrix, _ = closure_equations(part, numbers, now, dwell, sizes(now, dwell), lib=lib)
        values = np.linalg.svd(matrix.astype(float), compute_uv=False)
        return bool(values[-1] <= LEAST * values[0])

    @cached_property
    def stability(self) -> Stability:
        """See `KernelEvaluation`."""
        self._check_found()
        found = self._assessed(self._closed(None))
        return replace(found, verdict="undecided") if self.cycle.one_sided else found

    @cached_property
    def part_stability(self) -> Stability:
        """Multipliers over the part that the symmetry closes; `InputError` if there is none."""
        self._check_found()
        if self.problem.symmetry is None:
            raise InputError("the orbit was not composed from a part and a symmetry")
        return self._assessed(self._part)

    @property
    def poincare_jacobian(self) -> np.ndarray:
        """See `KernelEvaluation`."""
        return np.asarray(self.shooting.variational[:, :-1])

    @property
    def saltations(self) -> np.ndarray:
        """See `KernelEvaluation`."""
        return np.asarray(saltations(self.cycle, self._numbers, self.shooting))

    @property
    def monodromy(self) -> np.ndarray:
        """See `KernelEvaluation`."""
        matrix = np.eye(self.states.shape[1], dtype=self.states.dtype)
        for flow, jump in zip(self.shooting.flows, self.saltations, strict=True):
            matrix = jump @ flow[:, :-1] @ matrix
        return np.asarray(matrix)

    @cached_property
    def admissibility(self) -> Admissibility:
        """See `KernelEvaluation`."""
        self._check_found()
        system = piecewise(self.problem.system, self.orbit.parameters)
        cycle = self.cycle.at(system.structure)
        dwell, start = self.orbit.dwell_times.astype(float), self.states[0].astype(float)
        now = shoot(cycle, numbers_in(system), dwell, start, np)
        return assess_cycle(cycle, system, now, dwell)

    def trajectory(self, periods: int) -> Trajectory:
        """See `KernelEvaluation`."""
        self._check_found()
        return motion_along(
            piecewise(self.problem.system, self.orbit.parameters),
            self.cycle,
            self.orbit.dwell_times.astype(float),
            self.states.astype(float),
            self.shooting.ends.astype(float),
            self.moved.astype(float),
            periods,
        )

    @cached_property
    def _part(self) -> tuple[ItineraryShape, Numbers, Shooting, np.ndarray]:
        """The part that the symmetry closes: cycle, numbers, passage and dwell times."""
        return self._closed(self.problem.symmetry)

    def _closed(
        self, symmetry: Symmetry | None
    ) -> tuple[ItineraryShape, Numbers, Shooting, np.ndarray]:
        system, part, _ = closing(self.piecewise, self.cycle, symmetry)
        numbers, dwell = numbers_in(system), self.orbit.dwell_times[: len(part)]
        now = shoot(part, numbers, dwell, self.states[0], self._functions)
        return part, numbers, now, dwell

    def _assessed(self, closed: tuple[ItineraryShape, Numbers, Shooting, np.ndarray]) -> Stability:
        return assess(*closed, self.translations, self.family, self._functions, self._error)

    @property
    def _error(self) -> Any:
        """Error of the multipliers."""
        if self.orbit.precise:
            return self.orbit.arithmetic.mp.mpf(10) ** -(self.orbit.digits + GUARD - 5)
        return 1e-13

    @property
    def _numbers(self) -> Numbers:
        return numbers_in(self.piecewise)

    @property
    def _functions(self) -> Any:
        return self.orbit.arithmetic.mp if self.orbit.precise else np

    def _check_found(self) -> None:
        if self.orbit.status not in (CONVERGED, SINGULAR):
            raise InputError(f"there is no orbit: {self.orbit.message}")


def motion_along(
    system: PiecewiseLinear,
    cycle: ItineraryShape,
    dwell: np.ndarray,
    starts: np.ndarray,
    ends: np.ndarray,
    shift: np.ndarray,
    periods: int,
) -> Trajectory:
    """Return the motion through phases one after the other, from time 0 on, some periods long.

    All is in double precision: `dwell` (p,), states `starts` and `ends` (p, N) of the
    phases, and the shift (N,) by which a period moves the state. One phase without a
    transition is not cut.
    """
    if cycle.uninterrupted:
        run = Run(
            np.zeros(1),
            np.array(cycle.configurations[:1], dtype=np.int32),
            starts[:1],
            starts[:1],
            np.zeros(1, dtype=mask_type(cycle.structure)),
            (),
            Status.UNTIL,
            float(periods * dwell.sum()),
        )
        return Trajectory(system, run)
    masks = [mask_of(t.boundaries) for t in cycle.transitions]
    moved = np.repeat(np.arange(periods), len(dwell))[:, None] * shift
    behind = np.tile(np.concatenate([starts[1:], starts[:1] + shift]), (periods, 1)) + moved
    times = np.cumsum(np.tile(dwell, periods))
    following = np.tile(np.roll(cycle.configurations, -1), periods)
    run = Run(
        np.concatenate([[0.0], times]),
        np.concatenate([cycle.configurations[:1], following]).astype(np.int32),
        np.concatenate([starts[:1], np.tile(ends, (periods, 1)) + moved]),
        np.concatenate([starts[:1], behind]),
        np.array([0, *masks * periods], dtype=mask_type(cycle.structure)),
        (),
        Status.TRANSITIONS,
        float(times[-1]),
    )
    return Trajectory(system, run)
