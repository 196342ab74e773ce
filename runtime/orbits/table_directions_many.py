"""How orbits by tables move with parameters, at many points: compiled, or the same on NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.table_derivatives import TableRates, table_rates
from nonsmooth.runtime.orbits.directions import CONSISTENT
from nonsmooth.runtime.orbits.table_directions import (
    closed_along,
    passed,
    relative_changes,
    section_along,
)
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.derivatives import cycle_maps
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.section_map import mechanical_states
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers
from nonsmooth.runtime.shooting.symmetric_orbit import closed_shape
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import (
    deciding_rows,
    directions_of,
    projection_along,
    taken_resets,
)

__all__ = ["ManyDirections", "solve_linear_many", "table_directions_many"]

_SAME = 1e-9  # of terms that cancel


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
    engine = compiled_engine()
    numbers = Numbers(*tables_at(system, points))
    shifts = _shifts(cycle, numbers) if len(points) else 0
    if engine is not None and len(cycle.structure.forcing) < 2:
        rates = table_rates(system, points, places)
        closed = _closed(cycle, numbers, rates) if shifts else _Closed(cycle, numbers, rates)
        if closed is not None:
            found = _compiled(engine, closed, dwell, start, len(places), timed, maps)
            return found._replace(shifts=shifts)
    found = _in_python(system, cycle, points, dwell, start, places, timed=timed, maps=maps)
    return found._replace(shifts=shifts)


def _shifts(cycle: ItineraryShape, numbers: Numbers) -> int:
    """Return along how many directions the system does not change, judged at the first point."""
    fields, rows, resets = (part[0] for part in (numbers.fields, numbers.rows, numbers.resets))
    return len(directions_of(cycle.structure, fields, rows, resets))


class _Closed(NamedTuple):
    """A cycle that closes up to translations, with its numbers, their rates, and projections."""

    cycle: ItineraryShape
    numbers: Numbers
    rates: TableRates
    projections: np.ndarray | None = None


def _closed(cycle: ItineraryShape, numbers: Numbers, rates: TableRates) -> _Closed | None:
    """Return a cycle closed up to translations, at k points.

    None is returned where the directions of the translations change with a parameter.
    """
    structure, (count, _, size, width) = cycle.structure, numbers.fields.shape
    arrays = zip(numbers.fields, numbers.rows, numbers.resets, strict=True)
    along = np.array([directions_of(structure, *each) for each in arrays])
    if _turn(cycle, numbers, rates, along):
        return None
    projections = np.array([projection_along(directions) for directions in along])
    place = cycle.transitions[-1].reset
    added = (projections @ numbers.resets[:, place])[:, None]
    ends = np.cumsum([part[0].size for part in numbers[:3]])
    first = ends[1] + place * size * width
    there = np.flatnonzero((rates.entries >= first) & (rates.entries < first + size * width))
    moving = np.unique(rates.directions[there])
    changes = np.zeros((count, len(moving), size * width))
    rows = np.searchsorted(moving, rates.directions[there])
    changes[:, rows, rates.entries[there] - first] = rates.values[:, there]
    changes = projections[:, None] @ changes.reshape(count, -1, size, width)
    driven = mechanical_states(cycle)
    kept = slice(None) if driven is None else driven
    return _Closed(
        closed_shape(cycle, len(cycle)),
        numbers._replace(resets=np.concatenate([numbers.resets, added], axis=1)),
        TableRates(
            np.concatenate([rates.directions, np.repeat(moving, size * width)]),
            np.concatenate(
                [rates.entries, np.tile(ends[2] + np.arange(size * width), len(moving))]
            ),
            np.concatenate([rates.values, changes.reshape(count, -1)], axis=1),
        ),
        projections[:, kept][:, :, kept],
    )


def _turn(cycle: ItineraryShape, numbers: Numbers, rates: TableRates, along: np.ndarray) -> bool:
    """Return whether directions (k, m, N) of translations change with one of the parameters."""
    structure, size = cycle.structure, along.shape[2]
    lines, columns = np.divmod(rates.entries, size + 1)
    ends = np.cumsum([part[0].size // (size + 1) for part in numbers[:3]])
    decides = np.full(ends[2], False)
    decides[: ends[0]] = True
    decides[ends[0] + np.array(deciding_rows(structure), dtype=int)] = True
    for reset in taken_resets(structure):
        decides[ends[1] + reset * size + np.arange(size)] = True
    there = np.flatnonzero((columns < size) & decides[lines])
    groups, place = np.unique(rates.directions[there] * ends[2] + lines[there], return_inverse=True)
    terms = np.moveaxis(rates.values[:, None, there] * along[:, :, columns[there]], -1, 0)
    sums, scales = (np.zeros((len(groups), *along.shape[:2])) for _ in range(2))
    np.add.at(sums, place.ravel(), terms)
    np.add.at(scales, place.ravel(), abs(terms))
    return bool((abs(sums) > _SAME * scales).any())


def _compiled(
    engine: ModuleType,
    closed: _Closed,
    dwell: np.ndarray,
    start: np.ndarray,
    directions: int,
    timed: bool,
    maps: bool,
) -> ManyDirections:
    cycle, numbers, rates, projections = closed
    (points, size), count = start.shape, len(cycle)
    shape = (points if maps else 0, size, size)
    found = ManyDirections(
        np.empty((points, directions, count)),
        np.empty((points, directions, size)),
        np.empty((points, directions)),
        np.empty(shape),
        np.empty((shape[0], directions, size, size)),
    )
    engine.move(
        points, count, size, directions, rates.values.shape[1], timed,
        *_moving(cycle, numbers, rates, directions),
        cycle.packed[3 * count :],
        np.ascontiguousarray(dwell), np.ascontiguousarray(start), *cycle_maps(cycle, numbers),
        rates.values, *found[:5],
    )  # fmt: skip
    if not maps:
        return found
    moved = found.maps, found.rates
    driven = mechanical_states(cycle)
    if driven is not None:
        moved = moved[0][..., driven, :][..., driven], moved[1][..., driven, :][..., driven]
    if projections is not None:
        moved = projections @ moved[0], projections[:, None] @ moved[1]
    return found._replace(maps=moved[0], rates=moved[1])


def _moving(
    cycle: ItineraryShape, numbers: Numbers, rates: TableRates, directions: int
) -> tuple[np.ndarray, ...]:
    """Return where the engine finds the entries that change.

    The first array says where those of each phase and direction begin; the others are
    their places in the maps of the phase, and in the rates of a point.
    """
    count = len(cycle)
    sizes_of = [part[0, 0].size for part in numbers[:3]]
    befores = np.cumsum([0, *(part[0].size for part in numbers[:3])])
    phases, entries, which = [], [], []
    for phase, maps in enumerate(cycle.packed[: 3 * count].reshape(3, count).T):
        inside = 0
        for place, size, before in zip(maps, sizes_of, befores, strict=False):
            begin = before + place * size
            there = np.flatnonzero((rates.entries >= begin) & (rates.entries < begin + size))
            phases.append(np.full(len(there), phase))
            entries.append(rates.entries[there] - begin + inside)
            which.append(there)
            inside += size
    phase_of, entry_of, rate_of = map(np.concatenate, (phases, entries, which))
    pair_of = phase_of * directions + rates.directions[rate_of]
    order = np.argsort(pair_of, kind="stable")
    starts = np.searchsorted(pair_of[order], np.arange(count * directions + 1))
    return tuple(part.astype(np.int32) for part in (starts, entry_of[order], rate_of[order]))


def _in_python(
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
    """Return derivatives of orbits by complex steps, where each point stands q times."""
    (k, size), q = start.shape, len(places)
    steps = np.tile(np.eye(points.shape[1])[list(places)], (k, 1))
    every = stepped(np.repeat(points, q, axis=0), steps, None)
    numbers = Numbers(*tables_at(system, every))
    cycle, closed = closed_along(cycle, numbers)
    times, states = (np.repeat(part, q, axis=0) for part in (dwell, start))
    with np.errstate(all="ignore"):
        now = passed(cycle, closed, times + 0j, states + 0j, None)
        parts = (real_parts(part) for part in (now.starts, now.ends, now.velocities))
        plain = dict(zip(("starts", "ends", "velocities"), parts, strict=True))
        size_of = sizes(now._replace(**plain), times)
        still = now._replace(starts=np.broadcast_to(states, now.starts.shape))
        usual = np.array([_relative_changes(closed, size_of, point, q) for point in range(k)])

        def solved(period: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
            sides = linearised_closure(now, times + 0j, size_of, period)
            matrix, right = with_forcing(cycle, closed, still, size_of, *sides, FLOATS)
            sides_of = imaginary_parts(right, None).reshape(k, q, -1)
            plain_matrix = real_parts(matrix).reshape(k, q, -1, size)[:, 0]
            return solve_linear_many(plain_matrix, np.moveaxis(sides_of, 1, 2), usual)

        changes, singular = solved(None)
        if timed and singular.any():
            given, _ = solved(times.sum(axis=-1) + 0j)
            changes[singular] = given[singular]
        starts = np.moveaxis(changes, 1, 2).reshape(k * q, size) * size_of
        rates = np.moveaxis(now.rates, 0, 1)
        waits = (real_parts(rates[..., :size]) @ starts[..., None])[..., 0]
        waits = waits + imaginary_parts(rates[..., size], None)
        moved = stepped(times, waits, None), stepped(states, starts, None)
        along = section_along(cycle, closed, passed(cycle, closed, *moved, None))
    along = along.reshape(k, q, *along.shape[1:])
    changed = imaginary_parts(along, None)
    return ManyDirections(
        waits.reshape(k, q, -1),
        starts.reshape(k, q, size),
        np.trace(changed, axis1=-2, axis2=-1),
        real_parts(along[: k if maps else 0, 0]),
        changed[: k if maps else 0],
    )


def _relative_changes(numbers: Numbers, size_of: np.ndarray, point: int, q: int) -> np.ndarray:
    """Return the largest relative changes (q,) of the numbers of one point, which stand q times."""
    own = slice(point * q, (point + 1) * q)
    fields, rows, resets = (part[own] for part in numbers[:3])
    one = numbers._replace(fields=fields, rows=rows, resets=resets)
    return relative_changes(one, size_of[point * q], None)


def solve_linear_many(
    matrix: np.ndarray, right: np.ndarray, usual: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return solutions (k, n, q) of linear equations at many points, and where they are singular.

    The matrices are (k, m, n), with m > n for equations that follow from others; `right`
    is (k, m, q). `usual` (k, q) is the relative change of what the equations are made of:
    a change that is tiny beside it is rounding. Solutions are NaN where equations are
    singular or contradict each other; the bools are (k,).
    """
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
    terms = (abs(matrix[there]) @ abs(found[there]) + abs(right[there])).max(axis=1)
    wrong = missed > CONSISTENT * np.maximum(terms, usual[there])
    kept = found[there]
    kept[np.broadcast_to(wrong[:, None, :], kept.shape)] = np.nan
    found[there] = kept
    return found, singular
