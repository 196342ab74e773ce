"""The record of a composed orbit and everything that can be asked of it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise, piecewise_in
from nonsmooth.runtime.orbits.admissible import Admissibility
from nonsmooth.runtime.orbits.composed_admissible import assess_cycle
from nonsmooth.runtime.orbits.composed_motion import motion_along
from nonsmooth.runtime.orbits.composed_refine import refine_cycle
from nonsmooth.runtime.orbits.orbit import DOUBLE, GUARD
from nonsmooth.runtime.orbits.refine import MOST_DIGITS
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.cycle_newton import (
    LEAST,
    message_of,
    sizes,
)
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR
from nonsmooth.runtime.shooting.section_map import ComposedStability, assess, saltations
from nonsmooth.runtime.shooting.shooting_map import (
    Cycle,
    Numbers,
    cycle_of,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import Symmetry, closing, part_of, whole_orbit
from nonsmooth.runtime.shooting.translations import (
    gauges_of,
    translations_of,
    up_to_shift,
)
from nonsmooth.runtime.shooting.variational import Shooting
from nonsmooth.runtime.simulation.simulate import checked_count
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["ComposedOrbit"]


@dataclass(frozen=True, eq=False)
class ComposedOrbit:
    """A periodic orbit of an itinerary, or what the solver reached when it found none.

    Attributes
    ----------
    system : str
    itinerary : tuple of (configuration, boundary)
        Of the whole period; boundaries that are reached together are joined, ``"a+b"``.
    parameters : dict of str to Value
        As given, exactly.
    dwell_times : array (p,)
        Floats, or mpmath numbers where more digits were asked for.
    states : array (p, N)
        State at the start of each phase, behind the transition before it.
    given_period : Value or None
        What the dwell times had to sum up to.
    residual : number
        Largest absolute value that closure or a switching condition misses.
    digits : int
        Error of each x is at most 10^-digits max(1, |x|).
    iterations : int
    status : int
        A number of `nonsmooth.runtime.shooting.newton`: 0 converged.
    symmetry : Symmetry or None
        What closes the first part of the orbit, where it was solved for by that part.
    label : str or None
        ``FILE.py:ORBIT`` and the like, where the orbit is a declared one.
    names : tuple of str
        Of the unknowns: dwell times, then start; empty for the usual ones.
    """

    system: str
    itinerary: tuple[tuple[str, str], ...]
    parameters: Mapping[str, Value]
    dwell_times: np.ndarray
    states: np.ndarray
    given_period: Value | None
    residual: Any
    digits: int
    iterations: int
    status: int
    kernels: SystemKernels = field(repr=False)
    symmetry: Symmetry | None = None
    label: str | None = None
    names: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Name of the orbit, or of its system and how many phases it has."""
        return self.label or cycle_label(self.system, len(self.itinerary))

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Names of the dwell times: tau1, tau2, ... where none were declared."""
        count = len(self.itinerary)
        return self.names[:count] or dwell_names(count, {*self.state_names, *self.parameters})

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states."""
        return tuple(self.kernels.table["states"])

    @property
    def unknowns(self) -> dict[str, Any]:
        """Dwell times by name, then the state at the start: x1 is called x10."""
        dwell = self.dwell_time_names
        names = self.names or (*dwell, *start_names(self.state_names, {*dwell, *self.parameters}))
        return dict(zip(names, [*self.dwell_times, *self.states[0]], strict=True))

    @property
    def given(self) -> dict[str, Value]:
        """What was given, exactly: parameters, and the period if it was."""
        period = {} if self.given_period is None else {"period": self.given_period}
        return {**self.parameters, **period}

    @property
    def opened(self) -> dict[str, Value]:
        """Parameters that only admissibility depends on: none, all of them are given."""
        return {}

    @property
    def converged(self) -> bool:
        """Whether this is an orbit, and determined by its equations."""
        return self.status == CONVERGED

    @property
    def message(self) -> str:
        """What the status means and suggests."""
        return message_of(self.status, timed=self.given_period is not None)

    @property
    def precise(self) -> bool:
        """Whether the numbers are mpmath's."""
        return self.dwell_times.dtype == object

    @property
    def period(self) -> Any:
        """Sum of the dwell times."""
        return self.dwell_times.sum() if self.precise else float(self.dwell_times.sum())

    @cached_property
    def arithmetic(self) -> Mpmath:
        """Mpmath at the orbit's digits and some guard digits."""
        return Mpmath(max(self.digits, DOUBLE) + GUARD)

    @cached_property
    def cycle(self) -> Cycle:
        """The itinerary looked up in the system."""
        return cycle_of(self.piecewise.structure, self.itinerary)

    @cached_property
    def piecewise(self) -> PiecewiseLinear:
        """The system at these parameters, in the orbit's arithmetic."""
        if self.precise:
            return piecewise_in(self.kernels, self.parameters, self.arithmetic)
        return piecewise(self.kernels, self.parameters)

    @cached_property
    def translations(self) -> np.ndarray:
        """Directions (m, N) along which the system does not change; m = 0 is the rule."""
        return translations_of(self.piecewise)

    @property
    def shift(self) -> dict[str, Any]:
        """By how much each state is moved behind one period: zero but along translations."""
        moved = self.shooting.starts[-1][gauges_of(self.translations)] @ self.translations
        return dict(zip(self.state_names, moved.tolist(), strict=True))

    def translates(self, state: str) -> bool:
        """Whether a translation moves this state."""
        return bool(self.translations[:, self.state_names.index(state)].any())

    @property
    def states_up_to_shift(self) -> np.ndarray:
        """The states (p, N), each moved along the translations to where the orbit starts."""
        return up_to_shift(self.states, self.translations)

    @cached_property
    def shooting(self) -> Shooting:
        """One passage of the cycle and its linearisation."""
        numbers, lib = self._numbers, self._functions
        return shoot(self.cycle, numbers, self.dwell_times, self.states[0], lib)

    @cached_property
    def family(self) -> bool:
        """Whether the orbit is one of a family: 1 is a multiplier, to double precision.

        Raises
        ------
        InputError
            If there is no orbit.
        """
        self._check_found()
        lib = self.arithmetic if self.precise else FLOATS
        part, numbers, now, dwell = self._part
        size_of = sizes(now, dwell)
        found = linearised_closure(now, dwell, size_of)
        matrix, _ = with_forcing(part, numbers, now, size_of, *found, lib)
        values = np.linalg.svd(matrix.astype(float), compute_uv=False)
        return bool(values[-1] <= LEAST * values[0])

    @cached_property
    def stability(self) -> ComposedStability:
        """Multipliers, trace and verdict.

        Where boundaries are reached together the multipliers are those of motions that go on
        doing so, and the verdict is "undecided".

        Raises
        ------
        InputError
            If there is no orbit.
        """
        self._check_found()
        found = self._assessed(self._closed(None))
        return replace(found, verdict="undecided") if self.cycle.one_sided else found

    @cached_property
    def part_stability(self) -> ComposedStability:
        """Multipliers of the map over one part, followed by the symmetry that closes it.

        The orbit's are their powers, squares where the symmetry is of order two; at -1 a pair
        of orbits without the symmetry branches off.

        Raises
        ------
        InputError
            If there is no orbit, or it was not solved for by a part.
        """
        self._check_found()
        if self.symmetry is None:
            raise InputError("the orbit was not composed from a part and a symmetry")
        return self._assessed(self._part)

    @property
    def multipliers(self) -> np.ndarray:
        """Multipliers of the map on the section where the orbit starts (complex, or mpmath's)."""
        found = self.stability.multipliers
        if self.precise:
            mpc = self.arithmetic.mp.mpc
            return np.array([mpc(m.real, m.imaginary) for m in found], dtype=object)
        return np.array([complex(m.real, m.imaginary) for m in found], dtype=complex)

    @property
    def trace(self) -> Any:
        """Trace of the Poincare map's Jacobian."""
        return self.stability.trace

    @property
    def poincare_jacobian(self) -> np.ndarray:
        """Derivative (N, N) of the state behind one period by the start.

        Both times are those of the transition: it maps onto the tangent space of the section,
        and has a multiplier zero for each dimension that the section lacks.
        """
        return np.asarray(self.shooting.variational[:, :-1])

    @property
    def saltations(self) -> np.ndarray:
        """Saltation matrix of each transition (p, N, N)."""
        return np.asarray(saltations(self.cycle, self._numbers, self.shooting))

    @property
    def monodromy(self) -> np.ndarray:
        """Product (N, N) of flows and saltation matrices over a period.

        It maps the vector field at the start to itself.
        """
        matrix = np.eye(self.states.shape[1], dtype=self.states.dtype)
        for flow, jump in zip(self.shooting.flows, self.saltations, strict=True):
            matrix = jump @ flow[:, :-1] @ matrix
        return np.asarray(matrix)

    @cached_property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system; in double precision.

        Raises
        ------
        InputError
            If there is no orbit, or a phase lasts too long for a guarantee.
        """
        self._check_found()
        system = piecewise(self.kernels, self.parameters)
        cycle = self.cycle.at(system.structure)
        dwell, start = self.dwell_times.astype(float), self.states[0].astype(float)
        now = shoot(cycle, numbers_in(system), dwell, start, np)
        return assess_cycle(cycle, system, now, dwell)

    def trajectory(self, periods: int = 1) -> Trajectory:
        """The motion along the orbit, phase by phase as it was solved for.

        An unstable orbit is not left, as it would be by a simulation from its start.

        Raises
        ------
        InputError
            If there is no orbit, or for a count that is no positive integer.
        """
        self._check_found()
        return motion_along(
            piecewise(self.kernels, self.parameters),
            self.cycle,
            self.dwell_times.astype(float),
            self.states.astype(float),
            self.shooting.ends.astype(float),
            np.array([float(x) for x in self.shift.values()]),
            checked_count("periods", periods, 1),
        )

    def refined(self, digits: int) -> ComposedOrbit:
        """The same orbit to true decimal digits, with mpmath numbers.

        Raises
        ------
        InputError
            For digits outside 1 ... 100000, an orbit that has not converged, or a symmetry
            that holds in double precision only.
        NoConvergence
            If Newton's method leaves the orbit, as it does where the equations are singular.
        """
        if (
            isinstance(digits, bool)
            or not isinstance(digits, int)
            or not 1 <= digits <= MOST_DIGITS
        ):
            raise InputError(f"digits = {digits} is not an integer from 1 to {MOST_DIGITS}")
        if not self.converged:
            raise InputError(f"{self.name} cannot be refined: {self.message}")
        symmetry, period = self.symmetry, self.given_period
        precise = refine_cycle(
            self.kernels,
            self.cycle,
            dict(self.parameters),
            self._part[-1].astype(float),
            self.states[0].astype(float),
            period if symmetry is None or period is None else part_of(period, symmetry.order),
            digits,
            symmetry,
        )
        lib = Mpmath(digits + GUARD)
        with lib.working(digits + GUARD):
            system = piecewise_in(self.kernels, self.parameters, lib)
            cycle = self.cycle.at(system.structure)
            part = precise.dwell, precise.states
            dwell, states = whole_orbit(system, cycle, symmetry, *part, lib.mp)
        return replace(
            self,
            dwell_times=dwell,
            states=states,
            residual=precise.residual,
            digits=digits,
            iterations=self.iterations + precise.iterations,
        )

    def to_json(self) -> dict[str, Any]:
        """The orbit as JSON: numbers as decimal strings with all their digits."""
        told: dict[str, Any] = registered("composed_json")(self)
        return told

    def plot(self, kind: str = "time", axes: Any = None, **options: Any) -> Any:
        """Draw the orbit; see `nonsmooth.runtime.present.pictures.composed.plot_composed`."""
        return registered("plot_composed")(self, kind, axes, **options)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the orbit to a file with every digit; `nonsmooth.load` reads it."""
        registered("save_composed")(self, path)

    def _repr_html_(self) -> str:
        text: str = registered("orbit_html")(self)
        return text

    def _repr_latex_(self) -> str:
        text: str = registered("orbit_latex")(self)
        return text

    @cached_property
    def _part(self) -> tuple[Cycle, Numbers, Shooting, np.ndarray]:
        """The part that the symmetry closes: cycle, numbers, passage and dwell times."""
        return self._closed(self.symmetry)

    def _closed(self, symmetry: Symmetry | None) -> tuple[Cycle, Numbers, Shooting, np.ndarray]:
        system, part = closing(self.piecewise, self.cycle, symmetry)
        numbers, dwell = numbers_in(system), self.dwell_times[: len(part)]
        now = shoot(part, numbers, dwell, self.states[0], self._functions)
        return part, numbers, now, dwell

    def _assessed(self, closed: tuple[Cycle, Numbers, Shooting, np.ndarray]) -> ComposedStability:
        return assess(*closed, self.translations, self.family, self._functions, self._error)

    @property
    def _error(self) -> Any:
        """Error of the multipliers."""
        if self.precise:
            return self.arithmetic.mp.mpf(10) ** -(self.digits + GUARD - 5)
        return 1e-13

    @property
    def _numbers(self) -> Numbers:
        return numbers_in(self.piecewise)

    @property
    def _functions(self) -> Any:
        return self.arithmetic.mp if self.precise else np

    def _check_found(self) -> None:
        if self.status not in (CONVERGED, SINGULAR):
            raise InputError(f"there is no orbit: {self.message}")
