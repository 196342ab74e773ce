"""Orbits with kernels as composed ones: at all physical parameters of their system."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.physical_parameters import chosen_parameters, physical_parameters
from nonsmooth.runtime.orbits.table_solve import solve_itinerary

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["SystemAt", "composed_family"]

SystemAt = Callable[[float], tuple[dict[str, Value], Value | None]]


def composed_family(
    branch: Branch, place: int, beside: Mapping[str, Any] | None = None
) -> tuple[Orbit, SystemAt]:
    """The composed orbit at a point of a branch.

    And what gives the physical parameters, and the period if it is given, at other values of
    the branch's parameter. Parameters that the orbit leaves open take the values that are given
    beside it, or are chosen, once for all of the branch.

    Raises
    ------
    InputError
        If the parameter is none of the system's, or the system does not take its values.
    """
    orbit = branch.orbit_at(place)
    name = branch.parameter
    if orbit.problem.kernels is None:
        parameters, given = dict(orbit.parameters), orbit.given_period

        def composed_at(value: float) -> tuple[dict[str, Value], Value | None]:
            if name in parameters:
                return {**parameters, name: as_value(value)}, given
            return parameters, as_value(value)

        return orbit, composed_at
    kernels, base = orbit.kernels, orbit
    if name not in kernels.parameter_names:
        raise InputError(f"{name} is no parameter of {kernels.name}: follow one that is")
    conservative = bool(kernels.table["conservative"])
    opened = {**base.opened, **chosen_parameters(base, beside)}

    def derived_at(value: float) -> tuple[dict[str, Value], Value | None]:
        moved = replace(base, given={**base.given, name: as_value(value)}, opened=opened)
        period = as_value(float(moved.period)) if conservative else None
        return physical_parameters(moved, beside).values, period

    here, period = derived_at(float(base.values[name]))
    phases = [tuple(phase[:2]) for phase in kernels.table["phases"]]
    dwell = base.dwell_times.astype(float).tolist()
    found = solve_itinerary(kernels.system, here, phases, dwell, period=period)
    if not found.converged:
        raise InputError(f"{base.name}: {found.message}")
    return found, derived_at
