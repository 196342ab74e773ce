"""Orbits of a branch by the tables of their system, at all of its parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["SystemAt", "composed_family"]

SystemAt = Callable[[float], tuple[dict[str, Value], Value | None]]


def composed_family(
    branch: Branch, place: int, beside: Mapping[str, Any] | None = None
) -> tuple[Orbit, SystemAt]:
    """The orbit at a point of a branch by the tables of its system, and a `SystemAt`.

    The `SystemAt` gives the physical parameters, and the period if it is given, at other values
    of the branch's parameter. Parameters that the orbit leaves open take the values in
    `beside`, or are chosen once for the whole branch. Raises `InputError` if the branch's
    parameter is none of the system's, or if the system does not take its values.
    """
    orbit, name = branch.orbit_at(place), branch.parameter
    problem = orbit.problem
    if name not in (PERIOD, *(table.name for table in problem.parameters)):
        raise InputError(f"{name} is no parameter of {problem.name}: follow one that is")
    orbit = replace(orbit, opened={**orbit.opened, **chosen_parameters(orbit, beside)})

    def system_at(value: float) -> tuple[dict[str, Value], Value | None]:
        moved = replace(orbit, given={**orbit.given, name: as_value(value)})
        return problem.physical(moved, beside).values, problem.period(moved)

    return problem.by_tables(orbit, beside), system_at
