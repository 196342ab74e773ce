"""Derivatives of the orbits of one itinerary at many parameter points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.directions import CONSISTENT
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.table_directions import closed_along, passed, section_along
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.shooting_map import Numbers, itinerary_shape
from nonsmooth.runtime.shooting.table_newton import sizes

__all__ = ["derivatives_of_many"]

_FLOWS = 4096  # that are in memory at a time

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
    rates, _ = _solved(jacobian, -changes[..., places])
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
    """Rates (k, n + 2, q), by complex steps on NumPy."""
    problem = orbits.problem
    cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
    if cycle.one_sided:
        raise InputError(
            f"{orbits.name}: boundaries are reached together: derivatives are one-sided"
        )
    found = np.full((len(points), unknowns.shape[1] + 2, len(places)), np.nan)
    several = max(1, _FLOWS // (max(1, len(places)) * len(cycle)))
    for begin in range(0, len(points), several):
        part = slice(begin, begin + several)
        found[part] = _part(orbits, cycle, points[part], unknowns[part], places)
    return found


def _part(
    orbits: Orbits, cycle: Any, points: np.ndarray, unknowns: np.ndarray, places: list[int]
) -> np.ndarray:
    """Rates (k, n + 2, q) of some points, of which each stands q times."""
    k, q, count = len(points), len(places), len(cycle)
    steps = np.tile(np.eye(points.shape[1])[places], (k, 1))
    every = stepped(np.repeat(points, q, axis=0), steps, None)
    numbers = Numbers(*tables_at(orbits.problem.system, every))
    cycle, closed = closed_along(cycle, numbers)
    real = np.repeat(unknowns, q, axis=0)
    dwell, start = real[:, :count], real[:, count:]
    size = start.shape[1]
    with np.errstate(all="ignore"):
        now = passed(cycle, closed, dwell + 0j, start + 0j, None)
        parts = (real_parts(part) for part in (now.starts, now.ends, now.velocities))
        plain = dict(zip(("starts", "ends", "velocities"), parts, strict=True))
        size_of = sizes(now._replace(**plain), dwell)
        still = now._replace(starts=np.broadcast_to(start, now.starts.shape))

        def solved(period: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
            sides = linearised_closure(now, dwell + 0j, size_of, period)
            matrix, right = with_forcing(cycle, closed, still, size_of, *sides, FLOATS)
            sides_of = imaginary_parts(right, None).reshape(k, q, -1)
            plain_matrix = real_parts(matrix).reshape(k, q, -1, size)[:, 0]
            return _solved(plain_matrix, np.moveaxis(sides_of, 1, 2))

        changes, singular = solved(None)
        if orbits.timed and singular.any():
            timed, _ = solved(dwell.sum(axis=-1) + 0j)
            changes[singular] = timed[singular]
        starts = np.moveaxis(changes, 1, 2).reshape(k * q, size) * size_of
        rates = np.moveaxis(now.rates, 0, 1)
        waits = (real_parts(rates[..., :size]) @ starts[..., None])[..., 0]
        waits = waits + imaginary_parts(rates[..., size], None)
        moved = stepped(dwell, waits, None), stepped(start, starts, None)
        maps = section_along(cycle, closed, passed(cycle, closed, *moved, None))
        trace = imaginary_parts(np.trace(maps, axis1=-2, axis2=-1), None)
    whole = np.concatenate([waits, starts, waits.sum(axis=-1)[:, None], trace[:, None]], axis=1)
    return np.moveaxis(whole.reshape(k, q, -1), 1, 2)


def _solved(matrix: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Solutions (k, n, q) of systems (k, m, n), NaN where there is none; which are singular."""
    found = np.full((len(matrix), matrix.shape[2], right.shape[2]), np.nan)
    singular = np.full(len(matrix), True)
    sound = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(right).all(axis=(1, 2))
    there = np.flatnonzero(sound)
    square = matrix[there]
    sides = right[there]
    if matrix.shape[1] != matrix.shape[2]:
        orthogonal, square = np.linalg.qr(square)
        sides = np.swapaxes(orthogonal, 1, 2) @ sides
    try:
        inverse = np.linalg.inv(square)
    except np.linalg.LinAlgError:  # some matrix is singular to the last bit
        inverse = np.linalg.pinv(square, rcond=LEAST)
        square = np.where(np.linalg.matrix_rank(square)[:, None, None] < square.shape[1], 0, square)
    norms = np.linalg.norm(square, axis=(1, 2)) * np.linalg.norm(inverse, axis=(1, 2))
    regular = np.isfinite(norms) & (norms > 0) & (norms * LEAST < 1)
    singular[there] = ~regular
    there = there[regular]
    found[there] = inverse[regular] @ sides[regular]
    missed = abs(matrix[there] @ found[there] - right[there]).max(axis=1)
    wrong = missed > CONSISTENT * np.maximum(1.0, abs(right[there]).max(axis=1))
    kept = found[there]
    kept[np.broadcast_to(wrong[:, None, :], kept.shape)] = np.nan
    found[there] = kept
    return found, singular
