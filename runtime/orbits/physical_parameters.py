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
    """All parameters of the system of an orbit with kernels; see `OrbitProblem.physical`.

    Parameters
    ----------
    orbit : Orbit
    beside : mapping of str to str, number or Value, optional
        Values of parameters that the orbit leaves open.
    near : iterable of Orbit
        Others that what is chosen has to suit, as far as they are admissible.

    Returns
    -------
    SystemPoint
        Values of all parameters, and the names of those that were chosen.

    Raises
    ------
    InputError
        For a name that is no parameter, or values that the system does not take.
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
    """Values of those that are chosen; see `OrbitProblem.physical`.

    Parameters
    ----------
    orbit : Orbit
    beside : mapping of str to number or None
        Values of parameters that the orbit leaves open.
    near : iterable of Orbit
        Others that what is chosen has to suit.

    Returns
    -------
    dict of str to Value
        Empty where nothing is left open.

    Raises
    ------
    InputError
        As for `OrbitProblem.physical`.
    """
    point = orbit.problem.physical(orbit, beside, near)
    return {name: point.values[name] for name in point.chosen}


def open_bounds(orbits: Iterable[Orbit]) -> dict[str, float]:
    """What the open parameters have to exceed for all of the orbits that may be admissible.

    Parameters
    ----------
    orbits : iterable of Orbit
        With kernels.

    Returns
    -------
    dict of str to float
        Bounds by the parameters' names, in their units; empty where no orbit is admissible.
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
