"""Whether a saved map is of the system that it names."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from nonsmooth.runtime.certification.checker import Failure
from nonsmooth.runtime.certification.quotients import Quotient, symbols
from nonsmooth.runtime.certification.statement import declaration_json, entry, rational
from nonsmooth.runtime.certification.subject import NotCovered, period_name, physical_values
from nonsmooth.runtime.certification.tables import tables_over
from nonsmooth.runtime.composition.passage import cycle_of
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import SystemKernels, load_orbit, load_system
from nonsmooth.runtime.saved import given_value
from nonsmooth.runtime.simulation.piecewise import system_parameters
from nonsmooth.runtime.simulation.structure import structure_of
from nonsmooth.runtime.values import Value, as_value

__all__ = ["compare_box"]


def compare_box(content: Mapping[str, Any], folder: Path) -> str | None:
    """Compare a map's declaration with that of the system over the box that is named.

    Returns
    -------
    str or None
        What could not be compared: the system is not there.

    Raises
    ------
    Failure
        If they differ.
    """
    if not content["declaration"]:
        return None
    try:
        kernels = load_system(content["system"], folder)
    except InputError:
        return f"{content['system']} is not here: its declaration is as the file says"
    box = {n: (Fraction(low), Fraction(high)) for n, (low, high) in content["box"].items()}
    values = _values(content, kernels, box, folder)
    constants = list(dict.fromkeys(v for v in values.values() if isinstance(v, Value)))
    if [value.text for value in constants] != content["constants"]:
        raise Failure("the constants are not the irrational parameters")
    variables = symbols([*box, *(f"constant{k}" for k in range(len(constants)))])
    numbers = {n: _entry(value, box, constants, variables) for n, value in values.items()}
    period = numbers.pop("", None)
    cycle = cycle_of(structure_of(kernels), [(c, b) for c, b in content["itinerary"]])
    if declaration_json(tables_over(kernels, [*numbers.values()]), cycle) != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} over the box")
    if period is not None and entry(period) != content["closing"]["period"]:
        raise Failure("the period is not the one that is given")
    return None


def _values(
    content: Mapping[str, Any],
    kernels: SystemKernels,
    box: Mapping[str, tuple[Fraction, Fraction]],
    folder: Path,
) -> dict[str, Any]:
    """Parameters of the system in order, and "", the period, where the map has one.

    An irrational number is a Value, any other a constant and its slopes by the box's
    parameters: those of the system are sums of the given ones.
    """
    given = {name: given_value(name, text) for name, text in content["parameters"].items()}
    names = [table.name for table in kernels.parameters]
    timed = content["closing"]["kind"] == "period"
    own = "period"
    if any(name not in given for name in names) or (timed and own not in given):
        orbit = load_orbit(content["orbit"], folder)
        own = period_name(orbit) or own

        def physical(point: Mapping[str, Value]) -> dict[str, Value]:
            try:
                return physical_values(orbit, point)
            except NotCovered as problem:
                raise Failure(str(problem)) from None
    else:

        def physical(point: Mapping[str, Value]) -> dict[str, Value]:
            return system_parameters(kernels, {name: point[name] for name in names})

    def told(point: Mapping[str, Fraction]) -> dict[str, Value]:
        values = {**given, **{name: as_value(x) for name, x in point.items()}}
        return {**physical(values), **({"": values[own]} if timed else {})}

    lower = {name: ends[0] for name, ends in box.items()}
    moved = {name: told({**lower, name: ends[1]}) for name, ends in box.items()}
    found: dict[str, Any] = {}
    for name, value in told(lower).items():
        if value.exact is None:
            found[name] = value
            continue
        slopes = {}
        for axis, (low, high) in box.items():
            there = moved[axis][name].exact
            if there is None:
                raise Failure(f"{name} is not rational over the box")
            slopes[axis] = (there - value.exact) / (high - low)
        found[name] = value.exact - sum(lower[n] * s for n, s in slopes.items()), slopes
    return found


def _entry(
    value: Any,
    box: Mapping[str, tuple[Fraction, Fraction]],
    constants: list[Value],
    variables: list[Quotient],
) -> Any:
    """A number in the variables of the declaration, which are the box's and the constants."""
    if isinstance(value, Value):
        return variables[len(box) + constants.index(value)]
    constant, slopes = value
    terms = [
        variable * rational(str(slopes[name]))
        for name, variable in zip(box, variables, strict=False)
        if slopes[name]
    ]
    return sum(terms, rational(str(constant)))
