"""Derivatives of the orbits of one itinerary at many parameter points."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.threads import in_parallel
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.directions import solve_linear
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.table_directions_many import table_directions_many
from nonsmooth.runtime.shooting.multiplier_derivatives import (
    MapDerivatives,
    many_multiplier_derivatives,
)
from nonsmooth.runtime.shooting.section_map import mechanical_states
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape

__all__ = ["derivatives_of_many"]

_POINTS, _COLUMNS = 1 << 9, 1 << 15  # that one thread takes at a time, by tables and kernels
_ZERO = 1e-12  # of the largest multiplier: one that is zero but for rounding
_OF_MAPS = ("determinant", "spectral_radius")  # where multipliers are asked for

_Found = dict[str, dict[str, np.ndarray]]


def derivatives_of_many(
    orbits: Orbits, by: Sequence[str] | str, threads: int | None = None
) -> _Found:
    """Return derivatives of unknowns, period and trace at many points; see `Orbits.derivatives`.

    They are arrays (...) by quantity and parameter, NaN where there is no orbit or no
    derivative. `threads` None takes as many as processors. `InputError` is raised for an
    unknown parameter, and where boundaries are reached together.
    """
    names = (by,) if isinstance(by, str) else tuple(by)
    known = [table.name for table in orbits.problem.parameters]
    for name in names:
        if name not in known:
            raise unknown_name("parameter", name, known)
    shape, kernels = orbits.status.shape, orbits.problem.kernels
    sound = np.flatnonzero(orbits.converged.ravel())
    every: slice | np.ndarray = slice(None) if len(sound) == orbits.status.size else sound
    points, unknowns = (
        np.stack([np.broadcast_to(a, shape).ravel()[every] for a in arrays]).astype(float).T
        for arrays in ([orbits.parameters[n] for n in known], list(orbits.unknowns.values()))
    )
    places = [known.index(name) for name in names]
    if kernels is None:
        rates = _by_tables(orbits, points, unknowns, places, threads)
    else:
        rates = _by_kernels(kernels, points, unknowns, places, threads)
    quantities = (*orbits.unknowns, "trace", "period", *_OF_MAPS)[: len(rates)]
    if every is sound:
        filled = np.full((*rates.shape[:2], orbits.status.size), np.nan)
        filled[..., sound] = rates
        rates = filled
    return {
        quantity: {name: rate.reshape(shape) for name, rate in zip(names, moved, strict=True)}
        for quantity, moved in zip(quantities, rates, strict=True)
    }


def _by_kernels(
    kernels: OrbitKernels,
    points: np.ndarray,
    unknowns: np.ndarray,
    places: list[int],
    threads: int | None,
) -> np.ndarray:
    """Return rates (n + 2, q, k), by compiled code if the kernels are compiled."""
    if kernels.table["vanishing"]:
        raise InputError(f"{kernels.name} is a border collision: its derivatives are one-sided")
    (count, size), width = unknowns.shape, points.shape[1]
    found = np.empty((size + 2, width, count))
    unit = np.eye(width)[:, :, None]

    def work(begin: int) -> None:
        part = slice(begin, begin + _COLUMNS)
        moved = found[..., part]
        at = np.moveaxis(moved[:-1], -1, 0)
        if kernels.directions is None:
            _on_numpy(kernels, points[part], unknowns[part], at)
        else:
            with np.errstate(all="ignore"):
                kernels.directions(points[part], unknowns[part], out=at)
        columns = dict(zip(kernels.parameter_names, unit, strict=True))
        columns |= dict(zip(kernels.unknowns, moved[:-2], strict=True))
        moved[-1] = reduce(np.add, kernels.durations(columns).values())

    in_parallel(work, range(0, count, _COLUMNS), threads)
    return found if places == [*range(width)] else found[:, places]


def _on_numpy(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, found: np.ndarray
) -> None:
    """Fill in derivatives (k, n + 1, p) of the unknowns and of the trace by all parameters."""
    spectrum, moved = kernels.spectrum(points)
    with np.errstate(all="ignore"):
        at = (points, spectrum, unknowns, moved)
        jacobian, changes = kernels.evaluate("jacobian", "parameter_jacobian", at=at)
        gradient = kernels.evaluate("trace_gradient", at=at)
    size = unknowns.shape[1]
    found[:, :size], _ = solve_linear(jacobian, -changes, np.zeros(points.shape))
    found[:, size] = gradient[:, size:]
    found[:, size] += np.einsum("kn,knq->kq", gradient[:, :size], found[:, :size])


def _by_tables(
    orbits: Orbits,
    points: np.ndarray,
    unknowns: np.ndarray,
    places: list[int],
    threads: int | None,
) -> np.ndarray:
    """Return rates (n + 2, q, k), with two rows more where there are multipliers."""
    problem = orbits.problem
    cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
    if cycle.one_sided:
        raise InputError(
            f"{orbits.name}: boundaries are reached together: derivatives are one-sided"
        )
    count, (amount, size) = len(cycle), unknowns.shape
    maps = orbits.multipliers is not None
    found = np.empty((size + 2 + maps * len(_OF_MAPS), len(places), amount))
    driven = mechanical_states(cycle)
    rank = _rank(orbits) if maps else 0

    def work(begin: int) -> None:
        part = slice(begin, begin + _POINTS)
        moved = table_directions_many(
            problem.system, cycle, points[part],
            unknowns[part, :count], unknowns[part, count:], places,
            timed=orbits.timed, maps=maps,
        )  # fmt: skip
        found[:count, :, part] = moved.dwell.T
        found[count:size, :, part] = moved.start.T
        found[size, :, part] = moved.trace.T
        found[size + 1, :, part] = moved.dwell.sum(axis=-1).T
        if maps:
            trivial = int(orbits.timed and driven is None)
            section = MapDerivatives(moved.maps, moved.rates, rank - moved.shifts, trivial)
            for row, rates in enumerate(many_multiplier_derivatives(section), size + 2):
                found[row, :, part] = rates.T

    in_parallel(work, range(0, amount, _POINTS), threads)
    return found


def _rank(orbits: Orbits) -> int:
    """Return how many multipliers are not zero at all points."""
    assert orbits.multipliers is not None
    sizes = abs(orbits.multipliers[orbits.converged])
    apart = sizes > _ZERO * sizes.max(axis=1, initial=0.0, keepdims=True)
    return int(apart.sum(axis=1).max(initial=0))
