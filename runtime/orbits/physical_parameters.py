"""All parameters of the system of an orbit; those that the orbit leaves open are chosen."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import SystemPoint, complete_system, followers
from nonsmooth.runtime.orbits.admissible import admissible_points
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["chosen_parameters", "open_bounds", "physical_parameters"]


def physical_parameters(
    orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
) -> SystemPoint:
    """Return all parameters of the system of an orbit with kernels; see `OrbitProblem.physical`.

    Those that the orbit leaves open are chosen, unless `beside` gives them; the choice
    also suits the orbits `near`, as far as they are admissible. `InputError` is raised
    for a name that is no parameter, or values that the system does not take.
    """
    kernels = orbit.kernels
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
    return complete_system(kernels, known, open_bounds([orbit, *near]))


def chosen_parameters(
    orbit: Orbit, beside: Mapping[str, Any] | None = None, near: Iterable[Orbit] = ()
) -> dict[str, Value]:
    """Return the values of the parameters that are chosen; see `OrbitProblem.physical`.

    The dict is empty where nothing is left open.
    """
    point = orbit.problem.physical(orbit, beside, near)
    return {name: point.values[name] for name in point.chosen}


def open_bounds(orbits: Iterable[Orbit]) -> dict[str, float]:
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
        allowed, bounds = admissible_points(kernels, point, unknowns)
        for table, bound in zip(kernels.open_parameters, bounds[0].tolist(), strict=True):
            if allowed[0]:
                found[table.name] = max(bound, found.get(table.name, 0.0))
    return found
