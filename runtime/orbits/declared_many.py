"""Declared orbits without kernels at many parameter points."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.parameter_batches import parameter_points
from nonsmooth.runtime.model.piecewise import piecewise_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.declared_solve import solve_declared, unknowns_of
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.orbits.table_many import solve_itineraries
from nonsmooth.runtime.orbits.table_problem import TableProblem
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape, numbers_in, shoot

__all__ = ["solve_declared_many", "with_admissibility"]


def solve_declared_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool = True,
    threads: int | None = None,
) -> Orbits:
    """Compose an orbit at many points, each from the reference orbit.

    Parameters
    ----------
    kernels : OrbitKernels
        Of an orbit that is not `derived`.
    parameters : mapping of str to array
        Absent ones take the reference point's values.
    admissibility : bool
        Decided point by point in Python, about a millisecond for each.
    threads : int, optional

    Returns
    -------
    Orbits
        Arrays in the shape to which the parameters broadcast.

    Raises
    ------
    InputError
        For wrong names or shapes, an orbit that declares no reference, or one that is
        declared by a part and a symmetry.
    """
    reference = kernels.table["reference"]
    if reference is None:
        raise InputError(
            f"{kernels.name} declares no reference: give its system, the itinerary and a guess"
        )
    if kernels.table.get("symmetry"):
        raise InputError(
            f"{kernels.name} is declared by a part and a symmetry, which one point at a time knows"
        )
    known = solve_declared(kernels, {})
    values = {**reference["parameters"], **parameters}
    phases = [(configuration, boundary) for configuration, boundary, _ in kernels.table["phases"]]
    found = solve_itineraries(
        kernels.system,
        phases,
        values,
        known.dwell_times,
        known.states[0],
        threads=threads,
    )
    names = unknowns_of(kernels)
    problem = found.problem
    assert isinstance(problem, TableProblem)
    found = replace(
        found,
        problem=replace(problem, label=kernels.name, names=names),
        parameters={name: np.asarray(value, dtype=float) for name, value in parameters.items()},
        unknowns=dict(zip(names, found.unknowns.values(), strict=True)),
    )
    return with_admissibility(values, found) if admissibility else found


def with_admissibility(values: Mapping[str, Any], found: Orbits) -> Orbits:
    """Decide point by point whether orbits are motions of the system; no parameter is open.

    Parameters
    ----------
    values : mapping of str to array
        All physical parameters; they broadcast against each other.
    found : Orbits
        Orbits by tables.

    Returns
    -------
    Orbits
        The same with `admissible`: False also where a phase is longer than the guarantee of the
        search reaches.
    """
    system, shape = found.problem.system, found.status.shape
    points, given = parameter_points(system, values)
    width = points.shape[1]
    points = np.broadcast_to(points.reshape(*given, width), (*shape, width)).reshape(-1, width)
    dwell = found.dwell_times.reshape(len(points), -1)
    assert found.starts is not None
    starts = found.starts[..., 0, :].reshape(len(points), -1)
    allowed = np.zeros(len(points), dtype=bool)
    cycle = itinerary_shape(structure_of(system), found.itinerary)
    for place in np.flatnonzero(found.converged.ravel()).tolist():
        here = piecewise_at(system, points[place], cycle.configurations)
        cycle = cycle.at(here.structure)
        now = shoot(cycle, numbers_in(here), dwell[place], starts[place], np)
        if (dwell[place] > 0).all():
            with suppress(InputError):  # of one point among many
                allowed[place] = assess_cycle(cycle, here, now, dwell[place]).verdict is True
    return replace(found, admissible=allowed.reshape(shape), bounds={})
