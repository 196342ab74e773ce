"""What is asked: from what a user gives to the system, the itinerary and the box of a census."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from nonsmooth.runtime.checker.counting.census import Counting
from nonsmooth.runtime.checker.stated.exact import product, reduced
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import complete, complete_system
from nonsmooth.runtime.model.kernels import OrbitKernels, kernels_of, load_orbit
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.problem import OrbitProblem
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.orbits.table_solve import unknowns_of, with_routes
from nonsmooth.runtime.proof.certificate import GUARD
from nonsmooth.runtime.proof.exact_closure import symplectic_form
from nonsmooth.runtime.proof.exact_tables import exact_tables
from nonsmooth.runtime.proof.refusals import as_read
from nonsmooth.runtime.proof.statement import system_declaration
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.translations import translations_of

__all__ = ["Asked", "asked_of", "box_of"]

SHORTEST = "1e-6"
_HUNDREDTHS = 100


@dataclass(frozen=True, eq=False)
class Asked:
    """An itinerary of a system at one parameter point, and the names for both."""

    problem: OrbitProblem
    values: Mapping[str, Value]  # all parameters of the system
    chosen: tuple[str, ...]  # those that the orbit leaves open
    period: Value | None  # the sum of the dwell times, where it is given
    largest: str  # largest size of a coordinate
    bits: int

    def entries(self) -> dict[str, Any]:
        """What the file of a census states of the question, ready for JSON."""
        problem, timed = self.problem, self.period is not None
        cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
        tables = exact_tables(problem.system, self.values, self.bits + GUARD)
        label = problem.name
        if len(translations_of(piecewise(problem.system, self.values))):
            raise InputError(
                f"{label} does not depend on where it is: its orbits are periodic up to a shift,"
                " and not counted"
            )
        if cycle.structure.forcing:
            if timed:
                raise InputError("the period of a forced orbit is the forcing's, and not given")
            if not tables.exact:
                raise InputError(
                    "to count the orbits of a forced system its numbers have to be exact"
                )
        elif not timed and tables.exact and symplectic_form(tables, cycle) is not None:
            raise InputError(
                f"{label} keeps its energy: its orbits come in families, and only with a given"
                " period can they be counted"
            )
        return {
            "orbit": label,
            "system": problem.system.name,
            "parameters": {name: value.text for name, value in self.values.items()},
            "chosen": list(self.chosen),
            "itinerary": [list(phase) for phase in problem.itinerary],
            "given_period": "" if self.period is None else self.period.text,
            "largest": self.largest,
            "bits": self.bits,
            "declaration": as_read(
                system_declaration(
                    problem.system, cycle, tables, problem.start_names, problem.dwell_time_names,
                    timed=timed,
                )
            ),
        }  # fmt: skip


def asked_of(
    orbit: Any,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]] | None,
    period: object,
    largest: float,
    bits: int,
) -> Asked:
    """Return what `certify_all` is asked, but for its box.

    `parameters` are physical ones, or those of the named orbit; without an itinerary that of the
    named orbit is taken. `InputError` is raised for names or values that do not fit, or orbits that
    are not counted.
    """
    size = f"{largest:g}"
    if itinerary is not None:
        kernels = with_routes(kernels_of(orbit), itinerary)
        values = system_parameters(kernels, parameters)
        problem = OrbitProblem(kernels, tuple((c, b) for c, b in itinerary))
        itinerary_shape(structure_of(kernels), problem.itinerary)
        return Asked(problem, values, (), _period(period), size, bits)
    named = load_orbit(orbit)
    if named.table.get("symmetry"):
        raise InputError(
            f"{named.name} is declared by a symmetry: give its whole itinerary instead"
        )
    phases = tuple(
        (configuration, boundary) for configuration, boundary, _ in named.table["phases"]
    )
    if named.derived:
        if period is not None:
            raise InputError(f"{named.name} takes its period, if any, among its parameters")
        return _derived(orbit, named, parameters, phases, size, bits)
    reference = named.table["reference"] or {"parameters": {}}
    given = {**reference["parameters"], **parameters}
    declared = named.table.get("period")
    if declared is not None:
        own = given.pop(declared["name"], None)
        period = own if period is None else period
    values = system_parameters(named.system, given)
    problem = OrbitProblem(named.system, phases, label=named.name, names=tuple(unknowns_of(named)))
    return Asked(problem, values, (), _period(period), size, bits)


def _derived(
    orbit: Any,
    kernels: OrbitKernels,
    parameters: Mapping[str, object],
    phases: tuple[tuple[str, str], ...],
    largest: str,
    bits: int,
) -> Asked:
    if kernels.table["vanishing"] or kernels.solved_for:
        raise InputError(
            f"{kernels.name} is a border collision, with {', '.join(kernels.solved_for)} among"
            " its unknowns: its orbits cannot be counted"
        )
    point = complete(kernels, parameters)
    given = {**point.values, **point.opened}
    if all(table.name in point.opened for table in kernels.open_parameters):
        found = complete_system(kernels, given)
    else:  # large enough for the orbit next to the reference, if there is one
        near = solve(orbit, parameters, throw=False)
        found = near.problem.physical(near) if near.converged else complete_system(kernels, given)
    values, dwell = found.values, kernels.dwell_times
    start = start_names(kernels.system.table["states"], {*dwell, *values})
    problem = OrbitProblem(kernels.system, phases, label=kernels.name, names=(*dwell, *start))
    period = point.values.get(kernels.period_name or "")
    return Asked(problem, values, found.chosen, period, largest, bits)


def _period(period: object) -> Value | None:
    if period is None:
        return None
    value = as_value(period)
    if not 0 < float(value) < math.inf:
        raise InputError(f"period = {value} is not positive and finite")
    return value


def box_of(counting: Counting, box: Mapping[str, Any]) -> list[str]:
    """Return the sides of a box as inequalities, one for each dwell time.

    `box` gives an upper bound, or both; the lower one is 1e-6 by default. Dwell times that follow
    only have to be positive, and one without bounds that ends where a periodic function of it is
    zero is at most its period. `InputError` is raised for unknown names, bounds that are missing or
    not in order.
    """
    names = counting.declared.dwell
    for name in box:
        if name not in names:
            raise unknown_name("dwell time", str(name), list(names))
    found, missing = [], []
    for place, name in enumerate(names):
        if name in box:
            found.append(_side(name, box[name]))
        elif name in counting.follow:
            found.append(f"0 < {name}")
        elif (period := _period_of(counting, place)) is not None:
            upper = math.floor(_HUNDREDTHS * period + 1) / _HUNDREDTHS
            found.append(f"{SHORTEST} <= {name} <= {upper}")
        else:
            missing.append(name)
    if missing:
        wanted = ", ".join(missing)
        raise InputError(f"the box has no bounds of {wanted}, as in {missing[0]}=0:10")
    return found


def _side(name: str, bounds: Any) -> str:
    if isinstance(bounds, Sequence) and not isinstance(bounds, str):
        if len(bounds) != 2:
            raise InputError(f"{name}: {len(bounds)} bounds are given, not two")
        first, last = bounds
    else:
        first, last = SHORTEST, bounds
    try:
        lower, upper = as_value(first), as_value(last)
    except InputError as problem:
        raise InputError(f"{name}: {problem}") from None
    if not 0 <= float(lower) < float(upper):
        raise InputError(f"{name}: {lower} and {upper} are not bounds of a dwell time, in order")
    return f"{lower} {'<' if lower.exact == 0 else '<='} {name} <= {upper}"


def _period_of(counting: Counting, place: int) -> float | None:
    """Return the period of a phase's boundary function; None where it is not known to have one.

    If its first derivative g solves g'' = -w^2 g, the function is periodic: it is first zero within
    one period, if ever.
    """
    declared = counting.declared
    if not declared.rational:
        return None
    _, kept, _ = declared.known[place]
    step, rates = declared.steps[place], []
    row = step.exit
    for _ in range(3):
        row = reduced(product(row, step.field), kept)
        rates.append(row)
    first, _, third = rates
    pivot = next((k for k, x in enumerate(first) if x), None)
    if pivot is None:
        return None
    ratio = third[pivot] / first[pivot]
    if any(x != ratio * y for x, y in zip(third, first, strict=True)):
        return None
    square = -float(counting.number(ratio).mid())
    return 2 * math.pi / math.sqrt(square) if square > 0 else None
