"""Periodic orbits whose equations have emitted kernels: what these answer in place of tables.

The multipliers are those that `shooting.section_map` gives without kernels (Secs. 4, 5). Both stay:
the trace of the kernels keeps the digits of a reciprocal pair, in any precision, without an
eigenvalue.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import SystemPoint, Terms, complete_system, followers
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import (
    NEITHER,
    Admissibility,
    assess_admissibility,
    kernel_limits,
    trigonometric_rows,
)
from nonsmooth.runtime.orbits.directions import Directions, kernel_directions, table_directions
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import DOUBLE, GUARD, PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import Evaluation, OrbitProblem
from nonsmooth.runtime.orbits.refine import refine_kernels
from nonsmooth.runtime.orbits.table_solve import fitted_start, solve_itinerary
from nonsmooth.runtime.shooting.kernel_newton import frequency_spread
from nonsmooth.runtime.shooting.multipliers import (
    Multiplier,
    Stability,
    eigenvalues_of,
    modulus,
    stability_of,
)
from nonsmooth.runtime.shooting.newton import CONVERGED, LEAST, NEGATIVE
from nonsmooth.runtime.shooting.section_map import reciprocal

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.simulation.trajectory import Trajectory

_WIDE = 50.0  # ratio of frequencies beyond which doubles lose digits of the Poincare map


@lru_cache(maxsize=64)
def kernel_problem(kernels: OrbitKernels) -> KernelProblem:
    """Return the periodic orbits of kernels."""
    phases = tuple(
        (configuration, boundary) for configuration, boundary, _ in kernels.table["phases"]
    )
    return KernelProblem(
        kernels.system, phases, label=kernels.name, names=kernels.unknowns, kernels=kernels
    )


@dataclass(frozen=True)
class KernelProblem(OrbitProblem):
    """The periodic orbits of one itinerary of a system, by the kernels of its own equations."""

    kernels: OrbitKernels = field(kw_only=True)

    @property
    def all_parameters(self) -> Mapping[str, ParameterTable]:
        """See `OrbitProblem`."""
        return self.kernels.tables

    @property
    def required(self) -> Mapping[str, str]:
        """See `OrbitProblem`."""
        return self.kernels.required

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        return self.kernels.dwell_times

    @property
    def start_names(self) -> tuple[str, ...]:
        """See `OrbitProblem`."""
        taken = {*self.dwell_time_names, *(table.name for table in self.system.parameters)}
        return start_names(structure_of(self.system).states, taken)

    @property
    def period_name(self) -> str | None:
        """See `OrbitProblem`."""
        return self.kernels.period_name

    @property
    def forcing(self) -> tuple[tuple[int, int], ...]:
        """See `OrbitProblem`: none is shown."""
        return ()

    def dwell_times(self, values: Mapping[str, Any]) -> list[Any]:
        """See `OrbitProblem`."""
        return list(self.kernels.durations(values).values())

    def followers(self, names: Iterable[str]) -> Mapping[str, Terms]:
        """See `OrbitProblem`."""
        return followers(self.kernels, names)

    def left_open(self, orbit: Orbit) -> Sequence[str]:
        """See `OrbitProblem`."""
        return [p.name for p in self.kernels.open_parameters if p.name not in orbit.opened]

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
        """See `OrbitProblem`."""
        if self._in_system_states:
            return list(orbit.states[0].tolist())
        point, dwell = piecewise(self.system, values), orbit.dwell_times.astype(float)
        return [*fitted_start(point, self.itinerary, dwell.tolist())]

    def by_tables(self, orbit: Orbit, beside: Mapping[str, Any] | None = None) -> Orbit:
        """See `OrbitProblem`."""
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

    def evaluation(self, orbit: Orbit) -> KernelEvaluation:
        """See `OrbitProblem`."""
        return KernelEvaluation(orbit)

    def flow(self, parameters: np.ndarray, phase: int, since: np.ndarray, start: Any) -> np.ndarray:
        """See `OrbitProblem`."""
        spectrum, _ = self.kernels.spectrum(parameters)
        arrays = (parameters, spectrum, since, start)
        return np.asarray(self.kernels.flow(self.itinerary[phase][0], *arrays))

    def refined(self, orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
        """See `OrbitProblem`."""
        return refine_kernels(orbit, digits, arithmetic)

    @property
    def _in_system_states(self) -> bool:
        """Whether the kernels' coordinates are the system's states, not those of a presentation."""
        own: bool = self.kernels.table["states"] == self.system.table["states"]
        return own


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
class KernelEvaluation(Evaluation):
    """The quantities that the kernels give at one orbit, in its arithmetic."""

    orbits: ClassVar[tuple[int, ...]] = (CONVERGED,)

    @property
    def tables(self) -> Evaluation:
        """Nothing: `InputError` is always raised, as kernels answer."""
        raise InputError(f"{self.orbit.name} was solved with kernels, not with its system's tables")

    @cached_property
    def states(self) -> np.ndarray:
        """See `Evaluation`."""
        return self._array("states")[:-1]

    @cached_property
    def stability(self) -> Stability:
        """See `Evaluation`."""
        self._check_found()
        return assess_stability(self.orbit)

    @cached_property
    def admissibility(self) -> Admissibility:
        """See `Evaluation`."""
        if self.orbit.status != NEGATIVE:  # which is a verdict
            self._check_found()
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
        """See `Evaluation`."""
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

    def along(self, found: OrbitDerivatives) -> OrbitMotionDerivatives:
        """See `Evaluation`.

        A sum such as e1 = ur1 - us1 is changed by the one of
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
        directions = table_directions(tables.evaluation, found.by, moving)
        return OrbitMotionDerivatives(tables, directions)

    def directions(self, by: Sequence[str]) -> Directions:
        """See `Evaluation`."""
        return kernel_directions(self.orbit, by)

    def trajectory(self, periods: int) -> Trajectory:
        """See `Evaluation`."""
        problem = self.orbit.problem
        if problem.physical(self.orbit).chosen:
            raise InputError(
                f"{self.orbit.name} does not determine all physical parameters: ask its motion()"
            )
        return problem.by_tables(self.orbit).trajectory(periods)

    def _array(self, kernel: str) -> np.ndarray:
        found = self.orbit.evaluate(kernel)
        return np.array(found, dtype=object) if self.orbit.precise else np.asarray(found)


def chosen_parameters(
    orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
) -> dict[str, Value]:
    """Return the values of the parameters that are chosen; see `OrbitProblem.physical`.

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
        limit, bounds = kernel_limits(kernels, *orbit.kernel_point)
        for table, bound in zip(kernels.open_parameters, bounds[0].tolist(), strict=True):
            if limit[0] == NEITHER:
                found[table.name] = max(bound, found.get(table.name, 0.0))
    return found


def assess_stability(orbit: Orbit) -> Stability:
    """Return the multipliers of an orbit with kernels and the verdict, to the orbit's digits.

    Where frequencies are so far apart that the map in doubles has fewer digits than the
    orbit, both are computed with more. The verdict is "undecided" where more digits
    cannot be had.
    """
    kernels = orbit.kernels
    spectrum, _ = kernels.spectrum([float(orbit.values[name]) for name in kernels.parameter_names])
    if orbit.precise or not frequency_spread(kernels, spectrum) > _WIDE:
        return _assessed(orbit)
    try:
        found = _assessed(refine_kernels(orbit, DOUBLE, "flint"))
    except NoConvergence:
        return replace(_assessed(orbit), verdict="undecided")
    multipliers = tuple(
        Multiplier(float(m.real), float(m.imaginary), m.trivial) for m in found.multipliers
    )
    trace, margin = float(found.trace), float(found.margin)
    return replace(found, multipliers=multipliers, trace=trace, margin=margin)


def _assessed(orbit: Orbit) -> Stability:
    table, precise = orbit.kernels.table, orbit.precise
    lib: Any = orbit.arithmetic.mp if precise else np
    trace = orbit.evaluate("trace") if precise else float(orbit.evaluate("trace"))
    rank, family = table["rank"], bool(table["conservative"])

    def eigenvalues() -> list[Multiplier]:
        if rank == 1:
            return [Multiplier(trace, lib.zero if precise else 0.0, trivial=family)]
        found = eigenvalues_of(orbit.poincare_jacobian, lib) if rank else []
        return sorted(found, key=lambda m: -float(modulus(m, lib)))[:rank]

    # what is carried beyond the digits asked for decides too
    ten = lib.mpf(10) if precise else 10.0
    error = ten ** -(orbit.digits + (GUARD - 5 if precise else -2))
    return stability_of(
        trace,
        rank,
        len(table["section"]),
        eigenvalues,
        family=family,
        pair=rank != 1 and has_reciprocal_pair(orbit),
        errors=(error, error),
        defective=lib.sqrt(error) if precise else math.sqrt(LEAST),
        grazes=_grazes(orbit, error),
        lib=lib,
        one_sided=" and ".join(f"{name} > 0" for name in table["vanishing"]),
    )


def _grazes(orbit: Orbit, error: Any) -> bool:
    """Return whether a phase may reach its exit boundary tangentially, where no map has a slope."""
    rates = _exit_rates if orbit.kernels.trigonometric else _exit_rates_of_fields
    return any(abs(rate) <= error * size for rate, size in rates(orbit))


def _exit_rates(orbit: Orbit) -> Iterator[tuple[Any, Any]]:
    """Yield the rate of the boundary that ends each phase, there, and the size of its terms."""
    kernels, lib = orbit.kernels, orbit.arithmetic.mp if orbit.precise else np
    found = (np.array(a, dtype=object) for a in orbit.evaluate("coefficients", "frequencies"))
    for boundary, row, frequencies in trigonometric_rows(kernels, *found):
        if boundary.name != orbit.itinerary[boundary.phase][1]:
            continue
        dwell, (_, rate, *waves), size = orbit.dwell_times[boundary.phase], row, abs(row[1])
        cosines, sines = waves[: len(frequencies)], waves[len(frequencies) :]
        for cosine, sine, w in zip(cosines, sines, frequencies, strict=True):
            rate += w * (sine * lib.cos(w * dwell) - cosine * lib.sin(w * dwell))
            size += w * (abs(sine) + abs(cosine))
        yield rate, size


def _exit_rates_of_fields(orbit: Orbit) -> Iterator[tuple[Any, Any]]:
    """Yield these rates along damped and forced motions: n (A y + b) at the end y of a phase."""
    kernels = orbit.kernels
    found = orbit.evaluate("fields", "ends", "boundaries")
    fields, ends, rows = (np.array(a, dtype=object) for a in found)
    fields = fields.reshape(len(ends), -1, fields.shape[-1])
    for boundary, row in zip(kernels.boundaries, rows, strict=True):
        phase = boundary.phase
        if boundary.name == orbit.itinerary[phase][1]:
            terms = row[:-1, None] * fields[phase] * np.append(ends[phase], 1)
            yield terms.sum(), abs(terms).sum()


def has_reciprocal_pair(orbit: Orbit) -> bool:
    """Return whether an orbit with kernels has multipliers 1, mu and 1/mu.

    The derivation tells it of transitions that keep volume. Others keep it along orbits that are
    their own time reversal, which the determinant of the map tells.
    """
    table = orbit.kernels.table
    if table["reciprocal_pair"] or not table["conservative"] or len(table["section"]) != 3:
        return bool(table["reciprocal_pair"])
    lib = orbit.arithmetic.mp if orbit.precise else np
    return reciprocal(orbit.poincare_jacobian, table["rank"], lib)
