"""Declared orbits that are composed, at many parameter points: by compiled kernels or by tables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.parameter_batches import check_arrays
from nonsmooth.runtime.orbits.declared_kernels import declared_kernels
from nonsmooth.runtime.orbits.declared_solve import solve_declared
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Orbits, changed
from nonsmooth.runtime.orbits.table_many import solve_itineraries

__all__ = ["solve_declared_many"]


def solve_declared_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool,
    threads: int | None,
    chunk: int,
) -> Orbits:
    """Find a composed orbit at many points, each from the reference orbit.

    Compiled kernels of its own equations do it where they can be had. The tables of its
    system do where they cannot; and where, with dwell times among what is searched for,
    the kernels find no motion. The arrays of the result have the shape to which the
    parameters broadcast; absent parameters take the reference point's values. The kernels
    solve `chunk` points at a time. `InputError` is raised for wrong names or shapes, for
    an orbit that declares no reference, and for one that is declared by a part and a
    symmetry.
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

        def filled(array: np.ndarray, values: np.ndarray) -> np.ndarray:
            both = np.array(array)
            both[rest] = values
            return both

        found = changed(filled, found, _by_tables(known, part, **options))
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
        admissibility=admissibility,
        threads=threads,
    )
    names = known.problem.unknown_names
    unknowns = dict(zip(names, composed.unknowns.values(), strict=True))
    return replace(composed, problem=known.problem, unknowns=unknowns)
