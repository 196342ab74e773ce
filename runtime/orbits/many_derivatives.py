"""Derivatives of the orbits of one itinerary at many parameter points."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from itertools import accumulate, chain
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.core.errors import InputError, chosen_names
from nonsmooth.runtime.core.parallel import in_parallel
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, compiled_engine
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.directions import moved_cycles, section_along, solve_linear
from nonsmooth.runtime.orbits.orbit import Orbits
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle
from nonsmooth.runtime.shooting.multipliers import (
    MapDerivatives,
    many_multiplier_derivatives,
)
from nonsmooth.runtime.shooting.section_map import mechanical_states
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    cycle_maps,
    itinerary_shape,
    stepped_tables,
)
from nonsmooth.runtime.shooting.translations import projection_along

_POINTS, _COLUMNS = 1 << 9, 1 << 15  # that one thread takes at a time, by tables and kernels
_ZERO = 1e-12  # of the largest multiplier: one that is zero but for rounding
_OF_MAPS = ("determinant", "spectral_radius")  # where multipliers are asked for

_Found = dict[str, dict[str, np.ndarray]]


class TableRates(NamedTuple):
    """The entries of the tables that some parameters change, at k points."""

    directions: np.ndarray  # (m,) of int, index of the parameter
    entries: np.ndarray  # (m,) of int, index of the entry, through fields, rows and resets
    values: np.ndarray  # (k, m), derivative of the entry by the parameter

    def beside(self, added: np.ndarray, numbers: Numbers) -> TableRates:
        """Return these and those (k, q, size) of the last reset, which was added to the numbers."""
        points, parameters, size = added.shape
        last = sum(part[0].size for part in numbers[:3]) - size + np.arange(size)
        return TableRates(
            np.concatenate([self.directions, np.repeat(np.arange(parameters), size)]),
            np.concatenate([self.entries, np.tile(last, parameters)]),
            np.concatenate([self.values, added.reshape(points, -1)], axis=1),
        )


def table_rates(kernels: SystemKernels, points: np.ndarray, places: Sequence[int]) -> TableRates:
    """Nonzero derivatives of fields, rows and resets by some parameters, at points (k, p).

    Points are in the system's order, and `places` are the parameters' indices there. One
    parameter after the other becomes complex, and so do the entries that depend on it.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> found = table_rates(kernels, np.array([[1.0, 2.0, 1.0, 5.0, 0.5]]), [4])
    >>> found.values  # the restitution stands in one reset
    array([[-1.]])
    """
    columns = list(np.array(points.T, dtype=float, order="C"))
    directions, entries, values = [], [], [np.empty((0, len(points)))]
    for direction, place in enumerate(places):
        moved = [stepped(x, 1, None) if k == place else x
                 for k, x in enumerate(columns)]  # fmt: skip
        first = 0
        for kernel in ("fields", "rows", "resets"):
            with np.errstate(all="ignore"):  # who takes them looks whether they are finite
                found = list(chain.from_iterable(kernels.source(kernel)(moved, lib=FLOATS)))
            for entry, value in enumerate(found):
                if np.iscomplexobj(value):
                    directions.append(direction)
                    entries.append(first + entry)
                    values.append(imaginary_parts(value, None)[None])
            first += len(found)
    return TableRates(
        np.array(directions, dtype=int),
        np.array(entries, dtype=int),
        np.ascontiguousarray(np.concatenate(values).T),
    )


class ManyDirections(NamedTuple):
    """Derivatives of k orbits by q parameters; NaN where there are none."""

    dwell: np.ndarray  # (k, q, p), of each phase
    start: np.ndarray  # (k, q, N)
    trace: np.ndarray  # (k, q), of the map on the section at the start, or the stroboscopic one
    maps: np.ndarray  # (k, m, m), that map; empty where it is not asked for, like `rates`
    rates: np.ndarray  # (k, q, m, m), of the map
    shifts: int = 0  # number of translations; their multipliers 1 are zeros of the map


def table_directions_many(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray,
    places: Sequence[int],
    *,
    timed: bool,
    maps: bool,
) -> ManyDirections:
    """Return derivatives of orbits of one cycle by the parameters at q places.

    `points` (k, parameters), `dwell` (k, p) and `start` (k, N) are in the system's order
    and units. With `timed` the period was given, and that of one of a family stays what
    it is. With `maps` the maps are given, too.
    """
    (k, size), q, count = start.shape, len(places), len(cycle)
    engine, steps = compiled_engine(), np.eye(points.shape[1])[list(places)]
    if engine is None or len(cycle.structure.forcing) > 1:
        numbers = stepped_tables(system, points, steps, None)
        period = np.repeat(dwell.sum(axis=-1), q) + 0j if timed else None
        moved = moved_cycles(cycle, numbers, dwell, start, None, period)
        with np.errstate(all="ignore"):
            whole = section_along(moved)
        whole = whole.reshape(k, q, *whole.shape[1:])
        changed = imaginary_parts(whole, None)
        return ManyDirections(
            moved.waits.reshape(k, q, -1),
            moved.starts.reshape(k, q, size),
            np.trace(changed, axis1=-2, axis2=-1),
            real_parts(whole[: k if maps else 0, 0]),
            changed[: k if maps else 0],
            moved.directions.shape[1],
        )
    rates = table_rates(system, points, places)
    closed, numbers, along = closed_cycle(cycle, Numbers(*tables_at(system, points)))
    if along.shape[1]:  # the directions of translations may turn, and with them the last reset
        _, turned, along = closed_cycle(cycle, stepped_tables(system, points, steps, None))
        rates = rates.beside(imaginary_parts(turned.resets[:, -1], None).reshape(k, q, -1), numbers)
    shape = (k if maps else 0, size, size)
    found = ManyDirections(
        np.empty((k, q, count)),
        np.empty((k, q, size)),
        np.empty((k, q)),
        np.empty(shape),
        np.empty((shape[0], q, size, size)),
        along.shape[1],
    )
    engine.move(
        k, count, size, q, rates.values.shape[1], timed,
        *_moving(closed, numbers, rates, q), closed.packed[3 * count :],
        np.ascontiguousarray(dwell), np.ascontiguousarray(start), *cycle_maps(closed, numbers),
        rates.values, *found[:5],
    )  # fmt: skip
    driven = mechanical_states(cycle)
    if driven is None or not maps:
        return found
    own, changed = (part[..., driven, :][..., driven] for part in found[3:5])
    if along.shape[1]:
        projections = np.array([projection_along(each) for each in along])
        projections = projections.reshape(k, q, size, size)[..., driven, :][..., driven]
        whole = projections @ stepped(own[:, None], changed, None)
        own, changed = real_parts(whole[:, 0]), imaginary_parts(whole, None)
    return found._replace(maps=own, rates=changed)


def _moving(
    cycle: ItineraryShape, numbers: Numbers, rates: TableRates, directions: int
) -> tuple[np.ndarray, ...]:
    """Return where the engine finds the entries that change.

    The first array says where those of each phase and direction begin; the others are
    their places in the maps of the phase, and in the rates of a point.
    """
    count = len(cycle)
    befores = accumulate((part[0].size for part in numbers[:2]), initial=0)
    entries = [
        before + places[:, None] * part[0, 0].size + np.arange(part[0, 0].size)
        for places, part, before in zip(
            cycle.packed[: 3 * count].reshape(3, count), numbers[:3], befores, strict=True
        )
    ]
    same = np.concatenate(entries, axis=1)[..., None] == rates.entries
    phase_of, entry_of, rate_of = np.nonzero(same)
    pair_of = phase_of * directions + rates.directions[rate_of]
    order = np.argsort(pair_of, kind="stable")
    starts = np.searchsorted(pair_of[order], np.arange(count * directions + 1))
    return tuple(part.astype(np.int32) for part in (starts, entry_of[order], rate_of[order]))


def derivatives_of_many(
    orbits: Orbits, by: Sequence[str] | str, threads: int | None = None
) -> _Found:
    """Return derivatives of unknowns, period and trace at many points; see `Orbits.derivatives`.

    They are arrays (...) by quantity and parameter, NaN where there is no orbit or no
    derivative. `threads` None takes as many as processors. `InputError` is raised for an
    unknown parameter, and where boundaries are reached together.
    """
    known = [table.name for table in orbits.problem.parameters]
    names = chosen_names("parameter", by, known)
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
