"""Whether a saved map is of the system that it names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from nonsmooth.runtime.certification.boxes.dependence import PERIOD, entries_over
from nonsmooth.runtime.certification.checker import Failure
from nonsmooth.runtime.certification.comparing import NOT_HERE, named_system
from nonsmooth.runtime.certification.contacts import kernels_with
from nonsmooth.runtime.certification.statement import declaration_json, entry
from nonsmooth.runtime.certification.subject import NotCovered, period_name, physical_values
from nonsmooth.runtime.certification.tables import tables_over
from nonsmooth.runtime.composition.passage import cycle_of
from nonsmooth.runtime.kernels import SystemKernels, load_orbit
from nonsmooth.runtime.saved import given_value
from nonsmooth.runtime.simulation.piecewise import system_parameters
from nonsmooth.runtime.simulation.structure import structure_of
from nonsmooth.runtime.values import Value

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
    kernels = named_system(content, folder)
    if kernels is None:
        return NOT_HERE.format(content["system"])
    box = {n: (Fraction(low), Fraction(high)) for n, (low, high) in content["box"].items()}
    try:
        constants, numbers = entries_over(box, _numbers(content, kernels, folder))
    except NotCovered as problem:
        raise Failure(str(problem)) from None
    if [value.text for value in constants] != content["constants"]:
        raise Failure("the constants are not the irrational parameters")
    period = numbers.pop(PERIOD, None)
    kernels = kernels_with(kernels, content["declaration"])
    cycle = cycle_of(structure_of(kernels), [(c, b) for c, b in content["itinerary"]])
    if declaration_json(tables_over(kernels, [*numbers.values()]), cycle) != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} over the box")
    if period is not None and entry(period) != content["closing"]["period"]:
        raise Failure("the period is not the one that is given")
    return None


def _numbers(
    content: Mapping[str, Any], kernels: SystemKernels, folder: Path
) -> Callable[[Mapping[str, Value]], dict[str, Value]]:
    """Parameters of the system, in order, and the period at a point of the box."""
    given = {name: given_value(name, text) for name, text in content["parameters"].items()}
    names = [table.name for table in kernels.parameters]
    timed = content["closing"]["kind"] == "period"
    own = "period"
    orbit = None
    if any(name not in given for name in names) or (timed and own not in given):
        orbit = load_orbit(content["orbit"], folder)
        own = period_name(orbit) or own

    def numbers(point: Mapping[str, Value]) -> dict[str, Value]:
        told = {**given, **point}
        if orbit is not None:
            values = physical_values(orbit, told)
        else:
            values = system_parameters(kernels, {name: told[name] for name in names})
        return {**values, PERIOD: told[own]} if timed else values

    return numbers
