"""Derivatives of the orbits of one itinerary at many parameter points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.threads import in_parallel
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.table_directions_many import (
    solve_linear_many,
    table_directions_many,
)
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape

__all__ = ["derivatives_of_many"]

_POINTS = 512  # that one thread takes at a time

_Found = dict[str, dict[str, np.ndarray]]


def derivatives_of_many(orbits: Orbits, by: Sequence[str] | str) -> _Found:
    """Derivatives of unknowns, period and trace at many points.

    Parameters
    ----------
    orbits : Orbits
    by : sequence of str, or str
        Names of parameters.

    Returns
    -------
    dict of str to dict of str to array (...)
        Of each quantity by each parameter; NaN where there is no orbit or no derivative.

    Raises
    ------
    InputError
        For an unknown parameter, and where boundaries are reached together.
    """
    names = (by,) if isinstance(by, str) else tuple(by)
    known = [table.name for table in orbits.problem.parameters]
    for name in names:
        if name not in known:
            raise unknown_name("parameter", name, known)
    shape, kernels = orbits.status.shape, orbits.problem.kernels
    sound = np.flatnonzero(orbits.converged.ravel())
    points = np.stack(
        [np.broadcast_to(orbits.parameters[n], shape).ravel()[sound] for n in known], axis=-1
    ).astype(float)
    unknowns = np.stack([row.ravel()[sound] for row in orbits.unknowns.values()], axis=-1)
    places = [known.index(name) for name in names]
    if kernels is None:
        rates = _by_tables(orbits, points, unknowns, places)
    else:
        rates = _by_kernels(kernels, points, unknowns, places)
    quantities = (*orbits.unknowns, "period", "trace")
    found: _Found = {quantity: {} for quantity in quantities}
    for column, quantity in enumerate(quantities):
        for place, name in enumerate(names):
            filled = np.full(orbits.status.size, np.nan)
            filled[sound] = rates[:, column, place]
            found[quantity][name] = filled.reshape(shape)
    return found


def _by_kernels(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, places: list[int]
) -> np.ndarray:
    """Rates (k, n + 2, q), compiled where the kernels are."""
    if kernels.table["vanishing"]:
        raise InputError(f"{kernels.name} is a border collision: its derivatives are one-sided")
    spectrum, moved = kernels.spectrum(points)
    with np.errstate(all="ignore"):
        jacobian = np.asarray(kernels.evaluate("jacobian", points, spectrum, unknowns))
        changes = np.asarray(
            kernels.evaluate("parameter_jacobian", points, spectrum, moved, unknowns)
        )
        gradient = np.asarray(kernels.evaluate("trace_gradient", points, spectrum, moved, unknowns))
    rates, _ = solve_linear_many(jacobian, -changes[..., places])
    count = unknowns.shape[1]
    unit = np.eye(len(kernels.parameter_names))[:, places]
    whole = np.concatenate([rates, np.broadcast_to(unit, (len(points), *unit.shape))], axis=1)
    names = (*kernels.unknowns, *kernels.parameter_names)
    columns = {name: whole[:, place] for place, name in enumerate(names)}
    waits = sum(np.asarray(wait) for wait in kernels.durations(columns).values())
    trace = np.einsum("kn,knq->kq", gradient, whole)
    return np.concatenate([whole[:, :count], np.asarray(waits)[:, None], trace[:, None]], axis=1)


def _by_tables(
    orbits: Orbits, points: np.ndarray, unknowns: np.ndarray, places: list[int]
) -> np.ndarray:
    """Rates (k, n + 2, q), with the cycle that was looked up."""
    problem = orbits.problem
    cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
    if cycle.one_sided:
        raise InputError(
            f"{orbits.name}: boundaries are reached together: derivatives are one-sided"
        )
    count = len(cycle)
    found = np.full((len(points), unknowns.shape[1] + 2, len(places)), np.nan)

    def work(begin: int) -> None:
        part = slice(begin, begin + _POINTS)
        dwell, start = unknowns[part, :count], unknowns[part, count:]
        moved = table_directions_many(
            problem.system, cycle, points[part], dwell, start, places,
            timed=orbits.timed, maps=False,
        )  # fmt: skip
        into = np.moveaxis(found[part], 1, 2)
        into[..., :count] = moved.dwell
        into[..., count:-2] = moved.start
        into[..., -2] = moved.dwell.sum(axis=-1)
        into[..., -1] = moved.trace

    in_parallel(work, range(0, len(points), _POINTS), None)
    return found
