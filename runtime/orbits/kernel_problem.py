"""Periodic orbits whose equations have emitted kernels."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import SystemPoint, complete_system, followers
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import (
    NEITHER,
    Admissibility,
    assess_admissibility,
    kernel_limits,
)
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.directions import Directions, kernel_directions
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.refine import refine_kernels
from nonsmooth.runtime.orbits.stability import assess_stability
from nonsmooth.runtime.orbits.table_problem import TableEvaluation, TableProblem
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
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
from nonsmooth.runtime.shooting.table_newton import fitting_start

if TYPE_CHECKING:
    from nonsmooth.runtime.shooting.symmetry import Symmetry
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["STATUS", "Evaluation", "KernelProblem", "OrbitProblem", "chosen_parameters"]

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
    """The periodic orbits of one itinerary of a system, by the kernels of its own equations.

    It holds the kernels it was made with: nothing is loaded again, whatever becomes of the
    file that declared them.
    """

    kernels: OrbitKernels
    symmetry: Symmetry | None = None

    # whether an orbit determines all parameters of its system, and so a trajectory
    has_trajectory: ClassVar[bool] = False
    # places of cosine and sine of each forcing among the states that are shown
    forcing: ClassVar[tuple[tuple[int, int], ...]] = ()

    @property
    def name(self) -> str:
        """``system/orbit``, or ``FILE.py:orbit`` and the like."""
        return self.kernels.name

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return self.kernels.system

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configuration and boundary of each phase of a period."""
        return tuple((configuration, boundary) for configuration, boundary, _ in self._phases)

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states, in the coordinates of the equations."""
        return tuple(self.kernels.table["states"])

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Name of each phase's dwell time."""
        return self.kernels.dwell_times

    @property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the unknowns; one may be given, and a parameter solved for in its place."""
        return self.kernels.unknowns

    @property
    def start_names(self) -> tuple[str, ...]:
        """Name of each of the system's states at the start."""
        taken = {*self.dwell_time_names, *(table.name for table in self.system.parameters)}
        return start_names(structure_of(self.system).states, taken)

    @property
    def period_name(self) -> str | None:
        """Name of the period where it may be given; None where the equations determine it."""
        return self.kernels.period_name

    @property
    def parameters(self) -> tuple[ParameterTable, ...]:
        """The parameters of the equations, with names, meanings and domains."""
        return self.kernels.parameters

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """All that may be given, by name: the equations' parameters and what they follow from."""
        return self.kernels.tables

    @property
    def required(self) -> Mapping[str, str]:
        """Values that parameters must have for such an orbit to exist, as text."""
        return self.kernels.required

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """Return the dwell time of each phase, from parameters and unknowns in any arithmetic.

        They are in the unit of time.
        """
        return list(self.kernels.durations(values).values())

    def followers(self, names: Iterable[str]) -> Collection[str]:
        """Return the parameters that follow from these: e1 = ur1 - us1 from ur1 and us1."""
        return followers(self.kernels, names)

    def period(self, orbit: Orbit) -> Value | None:
        """Return what the dwell times have to sum up to; None where the equations determine it."""
        given = orbit.given.get(self.period_name or "")
        if given is None and self.kernels.table["conservative"]:
            return as_value(float(orbit.period))
        return given

    def system_values(self, values: Mapping[str, Value]) -> dict[str, Value]:
        """Return all parameters of the system, from the equations' and what these leave open.

        `InputError` is raised if they are not values that the system takes.
        """
        return complete_system(self.kernels, values).values

    def physical(
        self, orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
    ) -> SystemPoint:
        """Return all parameters of the system at an orbit, with names of those that were chosen.

        Parameters that the orbit leaves open are chosen, unless they are given in `beside`;
        what is chosen suits all orbits that are near, too, as far as they are admissible.
        `model.completion` says how. `InputError` is raised for a name that is no parameter, or
        values that the system does not take.
        """
        kernels = self.kernels
        known = {
            name: as_value(number)
            for name, number in {**orbit.unknowns, **orbit.given, **orbit.opened}.items()
            if name in kernels.tables
        }
        for name, value in (beside or {}).items():
            if name not in kernels.tables and name not in orbit.given:
                raise unknown_name("parameter", name, kernels.tables)
            if name not in known and name not in followers(kernels, known):
                known[name] = as_value(value)
        return complete_system(kernels, known, _open_bounds([orbit, *near]))

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
        """Return the same orbit by the tables of its system, at all parameters of `physical`.

        Phases that take no time are left out. `InputError` is raised if Newton's method finds
        no orbit by the tables.
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
        """Return what a status means and suggests, where the period was given (`timed`) or not."""
        return STATUS[status]

    def evaluation(self, orbit: Orbit) -> KernelEvaluation:
        """Return what the equations tell at an orbit of this problem."""
        return KernelEvaluation(orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """Return states (..., N) at times (...) since a phase's start, from the state (N,) there.

        `parameters` (q,) are in their order; times are in the unit of time.
        """
        spectrum, _ = self.kernels.spectrum(parameters)
        arrays = (parameters, spectrum, since, start)
        return np.asarray(self.kernels.flow(self._phases[phase][0], *arrays))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """Return a converged orbit to so many true decimal digits.

        The arithmetic is ``flint`` or ``mpmath``. `NoConvergence` is raised if Newton's
        method leaves the orbit.
        """
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
    """The quantities that the kernels give at one orbit, in its arithmetic."""

    orbit: Orbit

    @property
    def tables(self) -> TableEvaluation:
        """Nothing: `InputError` is always raised, as kernels answer."""
        raise InputError(f"{self.orbit.name} was solved with kernels, not with its system's tables")

    @cached_property
    def states(self) -> np.ndarray:
        """State (p, N) at the start of each phase, behind the transition before it."""
        return self._array("states")[:-1]

    @cached_property
    def stability(self) -> Stability:
        """Multipliers, trace and verdict."""
        return assess_stability(self.orbit)

    @property
    def part_stability(self) -> Stability:
        """Nothing: `InputError` is always raised, as there is no part."""
        raise InputError("the orbit was not composed from a part and a symmetry")

    @cached_property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system."""
        return assess_admissibility(self.orbit)

    @cached_property
    def saltations(self) -> np.ndarray:
        """Saltation matrix (p, N, N) of each transition."""
        size = len(self.orbit.state_names)
        return self._array("saltations").reshape(-1, size, size)

    @cached_property
    def monodromy(self) -> np.ndarray:
        """Product (N, N) of flows and saltation matrices over a period."""
        return self._array("monodromy")

    @cached_property
    def poincare_jacobian(self) -> np.ndarray:
        """Derivative of the Poincare map, in coordinates of the section or in all."""
        return self._array("poincare_jacobian")

    @property
    def shift(self) -> dict[str, Any]:
        """Zero: an orbit with kernels comes back to where it was."""
        zero = self.orbit.arithmetic.mp.zero if self.orbit.precise else 0.0
        return dict.fromkeys(self.orbit.state_names, zero)

    @property
    def free_states(self) -> tuple[str, ...]:
        """States that a translation of the system moves."""
        return ()

    @property
    def border(self) -> tuple[str, str]:
        """The side on which the orbit has derivatives, and why; both are mostly empty."""
        side = self.stability.one_sided
        return side, "a border collision, a phase takes no time" if side else ""

    def along(self, found: OrbitDerivatives) -> tuple[OrbitMotionDerivatives, np.ndarray]:
        """Return the orbit by tables as it moves with parameters, and their rates (parameters, q).

        The rates are by what was given. A sum such as e1 = ur1 - us1 is changed by the one of
        its parameters that is not open. Of a border collision, phases that take no time are
        left out: what is given and solved for keeps the collision, so that both boundaries go
        on to be reached together. `InputError` is raised where the equations leave open how the
        parameters move, or the orbit by tables has no derivatives.
        """
        orbit = self.orbit
        kernels = orbit.kernels
        tables = orbit.problem.by_tables(orbit)
        if orbit.precise:
            tables = tables.problem.refined(tables, orbit.digits, "mpmath")
        moving: dict[str, np.ndarray] = {}
        opened = {table.name for table in kernels.open_parameters}
        physical = {table.name for table in kernels.system.parameters}
        unit = dict(zip(found.by, np.eye(len(found.by), dtype=int), strict=True))
        solved = [name for name in found.unknowns if name in kernels.combined or name in physical]
        for name in dict.fromkeys((*kernels.parameter_names, *solved)):
            rate = unit.get(name, found.unknowns.get(name))
            if rate is None:
                continue
            if name in kernels.combined:
                terms = kernels.combined[name]
                (target,) = [n for n in terms if n not in opened][:1] or [next(iter(terms))]
                moving[target] = rate * terms[target]  # factors are 1 and -1
            elif name in physical:
                moving[name] = rate
            elif name == kernels.period_name and tables.given_period is not None:
                moving[PERIOD] = rate
            else:
                raise InputError(f"{orbit.name}: how its motion changes with {name} is left open")
        by = tuple(moving)
        directions = tables.evaluation.directions(by)
        rates = np.array([moving[name] for name in by]).reshape(len(by), len(found.by))
        return OrbitMotionDerivatives(tables, by, directions), rates

    def directions(self, by: Sequence[str]) -> Directions:
        """Return how the orbit moves with each of some numbers that were given.

        `InputError` says why where there is no derivative.
        """
        return kernel_directions(self.orbit, by)

    def trajectory(self, periods: int) -> Trajectory:
        """Return the motion along the orbit over some periods, by the system's tables.

        `InputError` is raised where the equations leave physical parameters open.
        """
        problem = self.orbit.problem
        if problem.physical(self.orbit).chosen:
            raise InputError(
                f"{self.orbit.name} does not determine all physical parameters: ask its motion()"
            )
        return problem.by_tables(self.orbit).trajectory(periods)

    def _array(self, kernel: str) -> np.ndarray:
        found = self.orbit.evaluate(kernel)
        return np.array(found, dtype=object) if self.orbit.precise else np.asarray(found)


# what is asked of a periodic orbit, whoever answers: emitted kernels, or its system's tables
OrbitProblem = KernelProblem | TableProblem
Evaluation = KernelEvaluation | TableEvaluation


def chosen_parameters(
    orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
) -> dict[str, Value]:
    """Return the values of the parameters that are chosen; see `KernelProblem.physical`.

    The dict is empty where nothing is left open.
    """
    point = orbit.problem.physical(orbit, beside, near)
    return {name: point.values[name] for name in point.chosen}


def _open_bounds(orbits: Iterable[Orbit]) -> dict[str, float]:
    """Return what open parameters have to exceed for all orbits that may be admissible.

    The orbits have kernels. The bounds are by the parameters' names, in their units;
    there are none where no orbit is admissible.
    """
    found: dict[str, float] = {}
    for orbit in orbits:
        kernels = orbit.kernels
        if not kernels.open_parameters:
            continue
        point = np.array([[float(orbit.values[name]) for name in kernels.parameter_names]])
        unknowns = np.array([[float(orbit.values[name]) for name in kernels.unknowns]])
        limit, bounds = kernel_limits(kernels, point, unknowns)
        for table, bound in zip(kernels.open_parameters, bounds[0].tolist(), strict=True):
            if limit[0] == NEITHER:
                found[table.name] = max(bound, found.get(table.name, 0.0))
    return found
