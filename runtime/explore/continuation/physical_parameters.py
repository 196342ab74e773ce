"""Orbits with kernels as composed ones: at all physical parameters of their system."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.admissible import admissible_points
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["SystemAt", "composed_family"]

SystemAt = Callable[[float], tuple[dict[str, Value], Value | None]]


def composed_family(
    branch: Branch, place: int, chosen: Mapping[str, Any] | None = None
) -> tuple[Orbit, SystemAt]:
    """The composed orbit at a point of a branch.

    And what gives the physical parameters, and the period if it is given, at other values of
    the branch's parameter. Parameters that the orbit does not determine are chosen.

    Raises
    ------
    InputError
        If the parameter is none of the system's, or the orbit does not determine all of them.
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
    own = _physical_parameters(base, chosen)
    opened = {**base.opened, **{p.name: own[p.name] for p in kernels.open_parameters}}

    def derived_at(value: float) -> tuple[dict[str, Value], Value | None]:
        moved = replace(base, given={**base.given, name: as_value(value)}, opened=opened)
        period = as_value(float(moved.period)) if conservative else None
        return _physical_parameters(moved, chosen), period

    here, period = derived_at(float(base.values[name]))
    phases = [tuple(phase[:2]) for phase in kernels.table["phases"]]
    dwell = base.dwell_times.astype(float).tolist()
    found = solve_itinerary(kernels.system, here, phases, dwell, period=period)
    if not found.converged:
        raise InputError(f"{base.name}: {found.message}")
    return found, derived_at


def _physical_parameters(orbit: Orbit, chosen: Mapping[str, Any] | None) -> dict[str, Value]:
    """All parameters of the system of an orbit that has kernels.

    Those that it leaves open and that were not given are as large as admissibility needs, and
    one more.

    Raises
    ------
    InputError
        Where the orbit does not determine all of them.
    """
    kernels = orbit.kernels
    point = np.array([[float(orbit.values[name]) for name in kernels.parameter_names]])
    unknowns = np.array([[float(orbit.values[name]) for name in kernels.unknowns]])
    _, bounds = admissible_points(kernels, point, unknowns)
    least = {
        table.name: max(0.0, float(np.nan_to_num(bound))) + 1
        for table, bound in zip(kernels.open_parameters, bounds[0], strict=True)
    }
    known: dict[str, Any] = {**least, **kernels.required, **orbit.unknowns}
    known |= {**orbit.given, **orbit.opened}
    for name, terms in kernels.combined.items():
        missing = [term for term in terms if term not in known]
        if name in known and len(missing) == 1:
            rest = sum(f * float(as_value(known[t])) for t, f in terms.items() if t in known)
            known[missing[0]] = (float(as_value(known[name])) - rest) / terms[missing[0]]
    names = [p.name for p in kernels.system.parameters]
    for name, value in (chosen or {}).items():
        if name not in names and name not in known:
            raise unknown_name("parameter", name, names)
        known.setdefault(name, as_value(value))
    if undetermined := [name for name in names if name not in known]:
        raise InputError(
            f"{orbit.name} does not determine {', '.join(undetermined)}: give them too, or compose"
            " it from its itinerary at all physical parameters, and follow that"
        )
    return {name: as_value(known[name]) for name in names}
