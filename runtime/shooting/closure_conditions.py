"""How a cycle closes: its numbers, that it returns, and what its forcings ask, in arrays."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, Shooting
from nonsmooth.runtime.shooting.translations import directions_of, projection_along

if TYPE_CHECKING:
    from nonsmooth.runtime.shooting.symmetry import Symmetry

_MOST_TURNS = 24  # of the first forcing, until all meet again


def closing(
    system: PiecewiseLinear, cycle: ItineraryShape, symmetry: Symmetry | None
) -> tuple[PiecewiseLinear, ItineraryShape, np.ndarray]:
    """The part of a whole cycle that closes, in a system with the numbers of `closed_cycle`.

    Last come the directions (m, N) of translations.
    """
    fields, rows, resets = (part[None] for part in system.numbers)
    part, closed, directions = closed_cycle(cycle, Numbers(fields, rows, resets), symmetry)
    if part is not cycle:
        system = replace(system, structure=part.structure, resets=closed.resets[0])
    return system, part, directions[0]


def closed_cycle(
    cycle: ItineraryShape, numbers: Numbers, symmetry: Symmetry | None = None
) -> tuple[ItineraryShape, Numbers, np.ndarray]:
    """The part of a whole cycle that closes, its numbers (n, ...), and directions (n, m, N).

    The directions are those of the system's translations. Where a symmetry or translations close
    the orbit the numbers have one more reset: the part's last one, followed by the symmetry and by
    the projection along the translations. Without either, cycle and numbers stay as they are.
    """
    structure, (points, *_, size, _) = cycle.structure, numbers.fields.shape
    arrays = zip(numbers.fields, numbers.rows, numbers.resets, strict=True)
    found = (directions_of(structure, *each) for each in arrays)
    first = next(found, np.empty((0, size)))
    if not points or (symmetry is None and not len(first)):
        return cycle, numbers, np.empty((points, 0, size))
    directions = np.array([first, *found])
    matrices = np.array([projection_along(each) for each in directions])
    if symmetry is not None:
        matrices = matrices @ symmetry.matrix
    count = len(cycle) if symmetry is None else len(cycle) // symmetry.order
    added = matrices @ numbers.resets[:, cycle.transitions[count - 1].reset]
    resets = np.concatenate([numbers.resets, added[:, None]], axis=1)
    return _closed_shape(cycle, count), numbers._replace(resets=resets), directions


def _closed_shape(cycle: ItineraryShape, count: int) -> ItineraryShape:
    """The first `count` phases of a cycle, where the last one ends with an added reset."""
    structure = _with_one_reset_more(cycle.structure)
    last = cycle.transitions[count - 1]
    turned = replace(last, reset=structure.resets - 1, target=cycle.configurations[0])
    transitions = (*cycle.transitions[: count - 1], turned)
    return replace(cycle.phases(range(count)), structure=structure, transitions=transitions)


@lru_cache(maxsize=1024)  # what is kept for a structure serves again
def _with_one_reset_more(structure: Structure) -> Structure:
    return replace(structure, resets=structure.resets + 1)


def closure_equations(
    cycle: ItineraryShape,
    numbers: Numbers,
    now: Shooting,
    dwell: Any,
    size_of: Any,
    period: Any = None,
    *,
    start: Any = None,
    lib: Any = FLOATS,
) -> tuple[Any, Any]:
    """Matrix (..., m, N) and right-hand side (..., m) of the linearised closure conditions.

    The unknown is the change of the start in units of the states' sizes (..., N) from `sizes`;
    `now` belongs to the present start and dwell times (..., p). If a period (...) is given, the
    sum of the dwell times is one more equation; at a point whose period is NaN it is 0 = 0. What
    forcings ask follows; it is of `start` (..., N), that of `now` if None. Times are in the
    system's unit, and `lib` provides `angle`.
    """
    size = now.starts.shape[-1]
    matrix = np.eye(size, dtype=int) - now.variational[..., :size]
    matrix = matrix * size_of[..., None, :] / size_of[..., :, None]
    right = (now.starts[-1] - now.starts[0] + now.variational[..., size]) / size_of
    rows, rests = [], []
    if not (period is None or (now.starts.dtype != object and np.isnan(period).all())):
        total, rates = dwell.sum(axis=-1), now.rates.sum(axis=0)
        row = rates[..., :size] * size_of / np.asarray(total)[..., None]
        rest = np.asarray((period - total - rates[..., size]) / total)
        if now.starts.dtype != object:
            free = np.isnan(period)
            row, rest = np.where(free[..., None], 0.0, row), np.where(free, 0.0, rest)
        rows.append(row)
        rests.append(rest)
    start = now.starts[0] if start is None else start
    for row, rest in _of_forcing(cycle, numbers, start, lib):
        rows.append(row * size_of)
        rests.append(rest)
    if not rows:
        return matrix, right
    return (
        np.concatenate([matrix, np.stack(rows, axis=-2)], axis=-2),
        np.concatenate([right, np.stack(rests, axis=-1)], axis=-1),
    )


def _of_forcing(
    cycle: ItineraryShape, numbers: Numbers, start: Any, lib: Any
) -> Iterator[tuple[Any, Any]]:
    """Yield a row (..., N) by the start and a right-hand side (...) for each forcing's equation.

    A forcing c, s has the amplitude 1, and several have begun together at some time at c = 1: each
    gives an equation for its amplitude, and each but the first one for its phase.
    """
    first: Any = None
    angle_of = np.frompyfunc(lib.angle, 2, 1) if start.dtype == object else lib.angle
    for cosine, sine in cycle.structure.forcing:
        c, s = start[..., cosine], start[..., sine]
        row = np.zeros_like(start)
        row[..., cosine], row[..., sine] = c, s
        yield row, (1 - c * c - s * s) / 2
        if len(cycle.structure.forcing) == 1:
            break
        speed = numbers.fields[..., 0, sine, cosine]
        turn = np.zeros_like(start)
        turn[..., cosine], turn[..., sine] = -s, c
        angle = angle_of(s, c)
        if first is None:
            first = speed, angle, turn
            continue
        ratio = speed / first[0]
        difference = _phase_difference(angle, first[1], ratio, angle_of)
        yield turn - np.asarray(ratio)[..., None] * first[2], -difference


def _phase_difference(angle: Any, first: Any, ratio: Any, angle_of: Any) -> Any:
    """Difference of an angle from the ratio times the first one, up to full turns of both."""
    turn = 2 * angle_of(0 * first, 0 * first - 1)  # 2 pi
    best: Any = None
    for turns in range(_MOST_TURNS):
        difference = angle - ratio * (first + turns * turn)
        nearest = difference - turn * np.round(real_parts(difference / turn).astype(float))
        if best is None:
            best = nearest
        else:
            best = np.where(abs(nearest) < abs(best) * (1 - 1e-9), nearest, best)
    return best
