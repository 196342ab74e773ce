"""What is asked: from what a user gives to a box and the equations that are searched."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import complete
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of, load_orbit
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.table_solve import unknowns_of, with_routes
from nonsmooth.runtime.proof.counting.dwell_box import Side, sides_of
from nonsmooth.runtime.proof.counting.problems import (
    Question,
    ReducedQuestion,
    dwell_question,
)
from nonsmooth.runtime.proof.counting.reduced_equations import ReducedProblem, reducible
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    physical_values,
)
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape

__all__ = ["Asked", "asked_of"]


@dataclass(frozen=True, eq=False)
class Asked:
    """A box, the question about it, and the names for both."""

    label: str
    system: str
    parameters: Mapping[str, Value]
    itinerary: tuple[tuple[str, str], ...]
    sides: tuple[Side, ...]
    question: Question


def asked_of(
    orbit: Any,
    parameters: Mapping[str, object],
    box: Mapping[str, Any],
    itinerary: Sequence[tuple[str, str]] | None,
    period: object,
    largest: float,
    bits: int,
) -> Asked:
    """The question that `certify_all` is asked, with its box.

    `parameters` are physical ones, or those of the named orbit. `box` has bounds of the dwell
    times, as for `sides_of`; without an itinerary that of the named orbit is taken. `period` (the
    sum of the dwell times) and `largest` (size of a coordinate) are in the system's units, and
    `bits` is the working precision. `InputError` for names or values that do not fit, or orbits
    that are not counted.
    """
    if itinerary is not None:
        kernels = kernels_of(orbit)
        kernels = with_routes(kernels, itinerary)
        cycle = itinerary_shape(structure_of(kernels), itinerary)
        taken = {*cycle.structure.states, *(p.name for p in kernels.parameters)}
        values = system_parameters(kernels, parameters)
        names = dwell_names(len(cycle), taken)
        start = start_names(cycle.structure.states, {*names, *values})
        own = _period(period)
        return _of_cycle(None, kernels, values, cycle, names, start, box, own, largest, bits)
    named = load_orbit(orbit)
    if named.table.get("symmetry"):
        raise InputError(
            f"{named.name} is declared by a symmetry: give its whole itinerary instead"
        )
    phases = [(configuration, boundary) for configuration, boundary, _ in named.table["phases"]]
    cycle = itinerary_shape(structure_of(named.system), phases)
    if named.derived:
        return _derived(orbit, named, cycle, parameters, box, period, largest, bits)
    reference = named.table["reference"] or {"parameters": {}}
    given = {**reference["parameters"], **parameters}
    declared = named.table.get("period")
    if declared is not None:
        own = given.pop(declared["name"], None)
        period = own if period is None else period
    values = system_parameters(named.system, given)
    names = unknowns_of(named)
    dwell, start, own = names[: len(cycle)], names[len(cycle) :], _period(period)
    return _of_cycle(named.name, named.system, values, cycle, dwell, start, box, own, largest, bits)


def _derived(
    orbit: Any,
    kernels: OrbitKernels,
    cycle: ItineraryShape,
    parameters: Mapping[str, object],
    box: Mapping[str, Any],
    period: object,
    largest: float,
    bits: int,
) -> Asked:
    if kernels.table["vanishing"] or kernels.solved_for:
        raise InputError(
            f"{kernels.name} is a border collision, with {', '.join(kernels.solved_for)} among"
            " its unknowns: its orbits cannot be counted"
        )
    if period is not None:
        raise InputError(f"{kernels.name} takes its period, if any, among its parameters")
    point = complete(kernels, parameters)
    given = {**point.values, **point.opened}
    if reducible(kernels):
        sides = sides_of(kernels.dwell_times, kernels.reduced, box)
        bounds = {side.name: side.floats for side in sides}
        domain = [bounds[name] for name in kernels.reduced]
        problem = ReducedProblem(kernels, list(point.values.values()), domain)
        question = ReducedQuestion(kernels, orbit, point, (problem,))
        return Asked(kernels.name, kernels.system.name, given, cycle.itinerary, sides, question)
    left = [p.name for p in kernels.open_parameters if p.name not in point.opened]
    if left:
        raise InputError(
            f"{kernels.name}: {', '.join(left)} left open, and needed to count its orbits"
        )
    try:  # those that are chosen play no part in this orbit
        values = physical_values(kernels, given)
    except NotCovered as reason:
        raise InputError(f"{kernels.name}: {reason}") from None
    own, names = point.values.get(kernels.period_name or ""), kernels.dwell_times
    start = start_names(cycle.structure.states, {*names, *values})
    return _of_cycle(
        kernels.name, kernels.system, values, cycle, names, start, box, own, largest, bits
    )


def _of_cycle(
    label: str | None,
    kernels: SystemKernels,
    values: Mapping[str, Value],
    cycle: ItineraryShape,
    names: tuple[str, ...],
    start: tuple[str, ...],
    box: Mapping[str, Any],
    period: Value | None,
    largest: float,
    bits: int,
) -> Asked:
    sides = sides_of(names, names, box)
    question = dwell_question(label, kernels, values, cycle, sides, start, period, largest, bits)
    told = label or cycle_label(kernels.name, len(cycle))
    return Asked(told, kernels.name, values, cycle.itinerary, sides, question)


def _period(period: object) -> Value | None:
    if period is None:
        return None
    value = as_value(period)
    if not 0 < float(value) < math.inf:
        raise InputError(f"period = {value} is not positive and finite")
    return value
