"""What is asked of a periodic orbit, and how the tables of its system answer.

Any itinerary is composed from tables at run time. Where an orbit has kernels of its own equations,
`kernel_problem` answers in their place; who asks does not know which of the two it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.boundary_sets import mask_of, mask_type
from nonsmooth.runtime.model.completion import SystemPoint, Terms
from nonsmooth.runtime.model.engine_run import Run, Status
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    piecewise,
    piecewise_at,
    piecewise_in,
)
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import Admissibility, assess_cycle
from nonsmooth.runtime.orbits.directions import Directions, table_directions
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit
from nonsmooth.runtime.orbits.refine import refine_tables
from nonsmooth.runtime.shooting.closure_conditions import closing, closure_equations
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.newton import CONVERGED, LEAST, SINGULAR, message_of
from nonsmooth.runtime.shooting.section_map import assess, saltations
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import Symmetry
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import (
    gauges_of,
    translations_of,
    up_to_shift,
)
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives


@dataclass(frozen=True)
class OrbitProblem:
    """The periodic orbits of one itinerary of a system.

    It holds the tables and kernels that it was made with: nothing is loaded again, whatever
    becomes of the file that declared them.
    """

    system: SystemKernels
    # of the whole period; boundaries that are reached together are joined, "a+b"
    itinerary: tuple[tuple[str, str], ...]
    # what closes the first part of the orbit, where it is solved for by that part
    symmetry: Symmetry | None = field(default=None, compare=False)
    label: str | None = None  # "FILE.py:ORBIT" and the like, where the orbit is a declared one
    # of the unknowns: dwell times, then start; empty for the usual ones
    names: tuple[str, ...] = ()
    # of equations of its own; None where they are composed from the tables
    kernels: OrbitKernels | None = None

    @property
    def derived(self) -> bool:
        """Whether kernels of its own equations answer."""
        return self.kernels is not None

    @property
    def name(self) -> str:
        """``system/orbit``, ``FILE.py:orbit`` and the like, or the system and how many phases."""
        return self.label or cycle_label(self.system.name, len(self.itinerary))

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states, in the coordinates of the equations."""
        return tuple((self.kernels or self.system).table["states"])

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """The parameters of the equations, with names, meanings and domains."""
        return (self.kernels or self.system).parameters

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """All that may be given, by name: the equations' parameters and what they follow from."""
        return {table.name: table for table in self.parameters}

    @property
    def required(self) -> Mapping[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""
        return {}

    @cached_property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the unknowns.

        Composed orbits have dwell times, then the start's coordinates: x10 for the state x1. Of
        others one may be given, and a parameter solved for in its place.
        """
        if self.names or self.derived:
            return self.names
        states, parameters = self.state_names, [p.name for p in self.parameters]
        dwell = dwell_names(len(self.itinerary), {*states, *parameters})
        return (*dwell, *start_names(states, {*dwell, *parameters}))

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Name of each phase's dwell time: tau1, tau2, ... where none were declared."""
        return self.unknown_names[: len(self.itinerary)]

    @property
    def start_names(self) -> tuple[str, ...]:
        """Name of each of the system's states at the start."""
        return self.unknown_names[len(self.itinerary) :]

    @property
    def period_name(self) -> str | None:
        """Name of the period where it may be given; None where the equations determine it."""
        return PERIOD

    @property
    def forcing(self) -> tuple[tuple[int, int], ...]:
        """Places of cosine and sine of each forcing among the states that are shown."""
        return structure_of(self.system).forcing

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """Return the dwell time of each phase, from parameters and unknowns in any arithmetic.

        They are in the unit of time.
        """
        return [values[name] for name in self.dwell_time_names]

    def followers(self, names: Iterable[str]) -> Mapping[str, Terms]:
        """Return the parameters that follow from these: e1 = ur1 - us1 from ur1 and us1.

        Each has the factors of the parameters that it is the sum of.
        """
        return {}

    def left_open(self, orbit: Orbit) -> Sequence[str]:
        """Return the parameters on which admissibility depends and that have no value."""
        return ()

    def period(self, orbit: Orbit) -> Value | None:
        """Return what the dwell times have to sum up to; None where the equations determine it."""
        return orbit.given_period

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """Return all parameters of the system, from the equations' and what these leave open.

        `InputError` is raised if they are not values that the system takes.
        """
        return system_parameters(self.system, {p.name: values[p.name] for p in self.parameters})

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """Return all parameters of the system at an orbit, with names of those that were chosen.

        Parameters that the orbit leaves open are chosen, unless they are given in `beside`;
        what is chosen suits all orbits that are near, too, as far as they are admissible.
        `model.completion` says how. `InputError` is raised for a name that is no parameter, or
        values that the system does not take.
        """
        return SystemPoint(orbit.parameters, ())

    def system_start(self, orbit: Orbit, values: Mapping[str, Value]) -> list[Any]:
        """Return the start (N): the orbit's, or the best fit of dwell times in other states."""
        return list(orbit.states[0].tolist())

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """Return the same orbit by the tables of its system, at all parameters of `physical`.

        Phases that take no time are left out. `InputError` is raised if Newton's method finds
        no orbit by the tables.
        """
        return orbit

    def message(self, status: int, *, timed: bool) -> str:
        """Return what a status means and suggests, where the period was given (`timed`) or not."""
        return message_of(status, derived=self.derived, timed=timed)

    def evaluation(self, orbit: Orbit) -> Evaluation:
        """Return what the equations tell at an orbit of this problem."""
        return Evaluation(orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """Return states (..., N) at times (...) since a phase's start, from the state (N,) there.

        `parameters` (q,) are in their order; times are in the unit of time.
        """
        point = piecewise_at(self.system, parameters)
        configuration = point.structure.configuration(self.itinerary[phase][0])
        times = np.asarray(since, dtype=float)
        starts = np.broadcast_to(np.asarray(start, dtype=float), (times.size, len(start)))
        states = flow_states(point, configuration, times.ravel(), starts)
        return states.reshape(*times.shape, len(start))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """Return a converged orbit to so many true decimal digits.

        The arithmetic is ``flint`` or ``mpmath``; tables take mpmath, whichever is asked for.
        `NoConvergence` is raised if Newton's method leaves the orbit.
        """
        return refine_tables(orbit, digits)


def orbit_of(
    problem: OrbitProblem,
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
    return labelled(orbit, known.problem.label, known.problem.names)


def labelled(orbit: Orbit, label: str | None, names: Sequence[str]) -> Orbit:
    """Return the orbit with the label and the names of unknowns that a declaration gives it.

    The names are those of the dwell times, then of the start's coordinates.
    """
    problem = replace(orbit.problem, label=label, names=tuple(names))
    unknowns = dict(zip(problem.unknown_names, orbit.unknowns.values(), strict=True))
    return replace(orbit, problem=problem, unknowns=unknowns)


@dataclass(frozen=True, eq=False)
class Evaluation:
    """The quantities that the tables give at an orbit, in its arithmetic."""

    orbit: Orbit
    orbits: ClassVar[tuple[int, ...]] = (CONVERGED, SINGULAR)  # statuses: one of a family is one

    @property
    def tables(self) -> Evaluation:
        """What the tables tell, which is this; `InputError` if kernels answer."""
        return self

    @property
    def states(self) -> np.ndarray:
        """State (p, N) at the start of each phase, behind the transition before it."""
        assert self.orbit.starts is not None
        return self.orbit.starts

    @cached_property
    def cycle(self) -> ItineraryShape:
        """The itinerary looked up in the system."""
        return itinerary_shape(self.piecewise.structure, self.orbit.itinerary)

    @cached_property
    def piecewise(self) -> PiecewiseLinear:
        """The system at these parameters, in the orbit's arithmetic."""
        asked = self.orbit.system, self.orbit.parameters
        return (
            piecewise_in(*asked, self.orbit.arithmetic) if self.orbit.precise else piecewise(*asked)
        )

    @cached_property
    def translations(self) -> np.ndarray:
        """Directions (m, N) along which the system does not change; m = 0 is the rule."""
        return translations_of(self.piecewise)

    @cached_property
    def in_doubles(self) -> PiecewiseLinear:
        """The system at these parameters, in double precision."""
        if self.orbit.precise:
            return piecewise(self.orbit.system, self.orbit.parameters)
        return self.piecewise

    @property
    def shift(self) -> dict[str, Any]:
        """By how much a period moves each state: zero but along translations."""
        return dict(zip(self.orbit.state_names, self.moved.tolist(), strict=True))

    @property
    def free_states(self) -> tuple[str, ...]:
        """States that a translation of the system moves."""
        names = self.orbit.state_names
        return tuple(names[k] for k in np.flatnonzero(self.translations.any(axis=0)))

    @property
    def border(self) -> tuple[str, str]:
        """The side on which the orbit has derivatives, and why; both are mostly empty."""
        for place, transition in enumerate(self.cycle.transitions):
            if len(transition.boundaries) > 1:
                names = self.orbit.itinerary[place][1].replace("+", " and ")
                return "that of this itinerary", f"{names} are reached together"
        return "", ""

    def directions(self, by: Sequence[str]) -> Directions:
        """Return how the orbit moves with each of some numbers that were given.

        `InputError` says why where there is no derivative.
        """
        return table_directions(self, by, dict(zip(by, np.eye(len(by), dtype=int), strict=True)))

    def along(self, found: OrbitDerivatives) -> OrbitMotionDerivatives:
        """Return the orbit by tables as it moves with what its derivatives are by."""
        return OrbitMotionDerivatives(self.orbit, found.directions)

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
        """Multipliers, trace and verdict; `InputError` if there is no orbit."""
        self._check_found()
        found = self._assessed(self._closed(None))
        return replace(found, verdict="undecided") if self.cycle.one_sided else found

    @cached_property
    def part_stability(self) -> Stability:
        """Multipliers over the part that the symmetry closes; `InputError` if there is none."""
        self._check_found()
        if self.orbit.symmetry is None:
            raise InputError("the orbit was not composed from a part and a symmetry")
        return self._assessed(self._part)

    @property
    def poincare_jacobian(self) -> np.ndarray:
        """Derivative of the Poincare map, in coordinates of the section or in all."""
        return np.asarray(self.shooting.variational[:, :-1])

    @property
    def saltations(self) -> np.ndarray:
        """Saltation matrix (p, N, N) of each transition."""
        return np.asarray(saltations(self.cycle, self._numbers, self.shooting))

    @property
    def monodromy(self) -> np.ndarray:
        """Product (N, N) of flows and saltation matrices over a period."""
        matrix = np.eye(self.states.shape[1], dtype=self.states.dtype)
        for flow, jump in zip(self.shooting.flows, self.saltations, strict=True):
            matrix = jump @ flow[:, :-1] @ matrix
        return np.asarray(matrix)

    @cached_property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system."""
        self._check_found()
        dwell, start = self.orbit.dwell_times.astype(float), self.states[0].astype(float)
        return assess_cycle(self.cycle, self.in_doubles, dwell, start)

    def trajectory(self, periods: int) -> Trajectory:
        """Return the motion along the orbit over some periods, by the system's tables.

        `InputError` is raised where the equations leave physical parameters open.
        """
        self._check_found()
        return motion_along(
            self.in_doubles,
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
        return self._closed(self.orbit.symmetry)

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
        if self.orbit.status not in self.orbits:
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
    count = 0 if cycle.uninterrupted else periods
    masks = [mask_of(t.boundaries) for t in cycle.transitions]
    moved = np.repeat(np.arange(count), len(dwell))[:, None] * shift
    behind = np.tile(np.concatenate([starts[1:], starts[:1] + shift]), (count, 1)) + moved
    times = np.cumsum(np.tile(dwell, count))
    following = np.tile(np.roll(cycle.configurations, -1), count)
    run = Run(
        np.concatenate([[0.0], times]),
        np.concatenate([cycle.configurations[:1], following]).astype(np.int32),
        np.concatenate([starts[:1], np.tile(ends, (count, 1)) + moved]),
        np.concatenate([starts[:1], behind]),
        np.array([0, *masks * count], dtype=mask_type(cycle.structure)),
        (),
        Status.TRANSITIONS if count else Status.UNTIL,
        float(times[-1] if count else periods * dwell.sum()),
    )
    return Trajectory(system, run)
