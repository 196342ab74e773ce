"""Declared orbits that are composed, at many parameter points: by compiled kernels or by tables."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.parameter_batches import check_arrays, parameter_points
from nonsmooth.runtime.model.piecewise import piecewise_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.declared_kernels import declared_kernels
from nonsmooth.runtime.orbits.declared_solve import solve_declared
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.orbits.table_many import solve_itineraries
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape, numbers_in, shoot

__all__ = ["solve_declared_many", "with_admissibility"]


def solve_declared_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool,
    threads: int | None,
    chunk: int,
) -> Orbits:
    """Find a composed orbit at many points, each from the reference orbit.

    Compiled kernels of its own equations do it where they can be had. The tables of its system
    do where they cannot; and where, with dwell times among what is searched for, the kernels
    find no motion.

    Parameters
    ----------
    kernels : OrbitKernels
        Of an orbit that is not `derived`.
    parameters : mapping of str to array
        Absent ones take the reference point's values.
    admissibility : bool
        By tables it is decided point by point in Python, about a millisecond for each.
    threads : int or None
    chunk : int
        Points that the kernels solve at a time.

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
    values = {**reference["parameters"], **parameters}
    check_arrays(kernels.system, values)  # kernels are not compiled for a slip of the pen
    own = declared_kernels(kernels)
    known = solve_declared(kernels, {}) if own is None else own.reference
    options: Any = {"admissibility": admissibility, "threads": threads}
    if own is None:
        return _by_tables(known, values, **options)
    if own.alone:
        return own.solve(values, chunk=chunk, **options)
    found = own.solve(values, admissibility=True, threads=threads, chunk=chunk)
    assert found.admissible is not None
    rest = ~found.admissible
    if rest.any():
        given = found.parameters.items()
        part = {name: np.broadcast_to(array, rest.shape)[rest] for name, array in given}
        found = _filled(found, rest, _by_tables(known, part, **options))
    return found if admissibility else replace(found, admissible=None, bounds=None)


def _by_tables(
    known: Orbit, values: Mapping[str, Any], *, admissibility: bool, threads: int | None
) -> Orbits:
    """Compose an orbit at many points from the reference orbit, under its names."""
    composed = solve_itineraries(
        known.problem.system,
        known.itinerary,
        values,
        known.dwell_times,
        known.states[0],
        threads=threads,
    )
    names = known.problem.unknown_names
    unknowns = dict(zip(names, composed.unknowns.values(), strict=True))
    found = replace(composed, problem=known.problem, unknowns=unknowns)
    return with_admissibility(values, found) if admissibility else found


def _filled(found: Orbits, rest: np.ndarray, others: Orbits) -> Orbits:
    """Put other orbits in place at some points (...)."""

    def filled(array: np.ndarray, values: np.ndarray) -> np.ndarray:
        both = np.array(array)
        both[rest] = values
        return both

    assert found.starts is not None
    assert others.starts is not None
    allowed = found.admissible
    if allowed is not None and others.admissible is not None:
        allowed = filled(allowed, others.admissible)
    return replace(
        found,
        unknowns={name: filled(row, others.unknowns[name]) for name, row in found.unknowns.items()},
        trace=filled(found.trace, others.trace),
        period=filled(found.period, others.period),
        residual=filled(found.residual, others.residual),
        iterations=filled(found.iterations, others.iterations),
        status=filled(found.status, others.status),
        admissible=allowed,
        starts=filled(found.starts, others.starts),
    )


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
    dwell = found.dwell_times.reshape(len(points), found.dwell_times.shape[-1])
    assert found.starts is not None
    starts = found.starts[..., 0, :].reshape(len(points), found.starts.shape[-1])
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
