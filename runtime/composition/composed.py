"""Periodic orbits of any itinerary of a system, composed from its flows at run time.

No kernels are generated for the itinerary: the numbers of the system's configurations,
boundaries and transitions are enough. Coordinates are physical, positions before velocities.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.admissible import Admissibility
from nonsmooth.runtime.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.composition.admissible import assess_cycle
from nonsmooth.runtime.composition.batch import ComposedOrbits, compose_many
from nonsmooth.runtime.composition.newton import (
    LEAST,
    Found,
    equations,
    message_of,
    sizes,
    solve_cycle,
    with_forcing,
)
from nonsmooth.runtime.composition.passage import (
    Cycle,
    Numbers,
    Passage,
    cycle_of,
    guesses,
    numbers_in,
    pass_through,
)
from nonsmooth.runtime.composition.precise import refine_cycle
from nonsmooth.runtime.composition.stability import ComposedStability, assess, saltations
from nonsmooth.runtime.declared import DeclaredSystem
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.newton import CONVERGED, SINGULAR
from nonsmooth.runtime.orbit import DOUBLE, GUARD
from nonsmooth.runtime.refine import MOST_DIGITS
from nonsmooth.runtime.simulation.engine_layout import numbers_of
from nonsmooth.runtime.simulation.piecewise import PiecewiseLinear, piecewise, piecewise_in
from nonsmooth.runtime.simulation.simulate import checked_count, simulate
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.values import Value, as_value

__all__ = ["ComposedOrbit", "ComposedOrbits", "compose", "compose_many"]


@dataclass(frozen=True, eq=False)
class ComposedOrbit:
    """A periodic orbit of an itinerary, or what the solver reached when it found none.

    Attributes
    ----------
    system : str
    itinerary : tuple of (configuration, boundary)
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
        With mpmath numbers the error of each x is at most 10^-digits max(1, |x|).
    iterations : int
    status : int
        A number of `nonsmooth.runtime.newton`: 0 converged.
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
    def passage(self) -> Passage:
        """One passage of the cycle and its linearisation."""
        numbers, lib = self._numbers, self._functions
        return pass_through(self.cycle, numbers, self.dwell_times, self.states[0], lib)

    @cached_property
    def family(self) -> bool:
        """Whether the orbit is one of a family: 1 is a multiplier, to double precision.

        Raises
        ------
        InputError
            If there is no orbit.
        """
        self._check_found()
        dwell, lib = self.dwell_times, self.arithmetic if self.precise else FLOATS
        size_of = sizes(self.passage, dwell)
        found = equations(self.passage, dwell, size_of)
        matrix, _ = with_forcing(self.cycle, self._numbers, self.passage, size_of, *found, lib)
        values = np.linalg.svd(matrix.astype(float), compute_uv=False)
        return bool(values[-1] <= LEAST * values[0])

    @cached_property
    def stability(self) -> ComposedStability:
        """Multipliers, trace and verdict.

        Raises
        ------
        InputError
            If there is no orbit.
        """
        self._check_found()
        error = 1e-13
        if self.precise:
            error = self.arithmetic.mp.mpf(10) ** -(self.digits + GUARD - 5)
        arrays = (self.cycle, self._numbers, self.passage, self.dwell_times)
        return assess(*arrays, self.family, self._functions, error)

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
        return np.asarray(self.passage.matrix[:, :-1])

    @property
    def saltations(self) -> np.ndarray:
        """Saltation matrix of each transition (p, N, N)."""
        return np.asarray(saltations(self.cycle, self._numbers, self.passage))

    @property
    def monodromy(self) -> np.ndarray:
        """Product (N, N) of flows and saltation matrices over a period.

        It maps the vector field at the start to itself.
        """
        matrix = np.eye(self.states.shape[1], dtype=self.states.dtype)
        for flow, jump in zip(self.passage.flows, self.saltations, strict=True):
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
        now = pass_through(cycle, numbers_in(system), dwell, start, np)
        return assess_cycle(cycle, system, now, dwell)

    def trajectory(self, periods: int = 1) -> Trajectory:
        """The motion along the orbit, simulated from its start: to draw, observe and save.

        Raises
        ------
        InputError
            If there is no orbit, or for a count that is no positive integer.
        """
        self._check_found()
        start = [float(x) for x in self.states[0]]
        count = len(self.itinerary) * checked_count("periods", periods, 1)
        first = self.itinerary[0][0]
        return simulate(self.kernels, self.parameters, start, first, transitions=count)

    @property
    def _numbers(self) -> Numbers:
        return numbers_in(self.piecewise)

    @property
    def _functions(self) -> Any:
        return self.arithmetic.mp if self.precise else np

    def _check_found(self) -> None:
        if self.status not in (CONVERGED, SINGULAR):
            raise InputError(f"there is no orbit: {self.message}")


def compose(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    guess_dwell_times: Sequence[float],
    guess_state: Sequence[float] | None = None,
    digits: int = DOUBLE,
    period: object = None,
) -> ComposedOrbit:
    """Find the periodic orbit of an itinerary near a guess.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters of the system.
    itinerary : sequence of (configuration, boundary)
        Cyclic: the last phase leads back to the first.
    guess_dwell_times : sequence of float
        One for each phase.
    guess_state : sequence of float, optional
        At the start of the first phase; without it the one that fits the dwell times best.
    digits : int
        True decimal digits; above 15 with mpmath.
    period : str, number or Value, optional
        What the dwell times have to sum up to: it singles out one of a family of orbits, as
        there is where energy is kept.

    Returns
    -------
    ComposedOrbit
        Its `status` says whether it is one.

    Raises
    ------
    InputError
        For wrong names, values or numbers of guesses, or an itinerary that the system does not
        allow.
    NoConvergence
        If the orbit in double precision cannot be refined.

    Examples
    --------
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> phases = [
    ...     ("stick-stick", "first-breaks-forward"),
    ...     ("slip-stick", "second-breaks-forward"),
    ...     ("slip-slip", "first-reaches-belt"),
    ...     ("stick-slip", "second-reaches-belt"),
    ... ]
    >>> orbit = compose("dry-friction", data, phases, [1, 2, 1.5, 3.3])
    >>> orbit.stability.verdict, orbit.admissibility.verdict
    ('stable', True)
    """
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MOST_DIGITS:
        raise InputError(f"digits = {digits} is not an integer from 1 to {MOST_DIGITS}")
    kernels = kernels_of(system)
    point = piecewise(kernels, parameters)
    cycle = cycle_of(point.structure, itinerary)
    dwell = guesses("guess_dwell_times", guess_dwell_times, len(cycle), positive=True)
    start = None
    if guess_state is not None:
        start = guesses("guess_state", guess_state, len(point.structure.states))
        start = start.reshape(1, -1)
    wanted = None if period is None else as_value(period)
    length = np.nan if wanted is None else float(wanted)
    if wanted is not None and not 0 < length < np.inf:
        raise InputError(f"period = {wanted} is not positive and finite")
    found = solve_cycle(
        cycle, numbers_of(point)[None], dwell.reshape(1, -1), start, np.array([length])
    )
    orbit = _record(kernels, cycle, point, found, wanted)
    if digits <= DOUBLE or not orbit.converged:
        return orbit
    precise = refine_cycle(
        kernels, cycle, point.parameters, orbit.dwell_times, orbit.states[0], wanted, digits
    )
    return ComposedOrbit(
        orbit.system,
        orbit.itinerary,
        orbit.parameters,
        precise.dwell,
        precise.states,
        wanted,
        precise.residual,
        digits,
        orbit.iterations + precise.iterations,
        orbit.status,
        kernels,
    )


def _record(
    kernels: SystemKernels, cycle: Cycle, point: PiecewiseLinear, found: Found, period: Value | None
) -> ComposedOrbit:
    return ComposedOrbit(
        kernels.name,
        cycle.itinerary,
        point.parameters,
        found.dwell[0],
        found.starts[0],
        period,
        float(found.residual[0]),
        DOUBLE,
        int(found.iterations[0]),
        int(found.status[0]),
        kernels,
    )
