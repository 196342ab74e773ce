"""Closure conditions of a cycle in arrays: that it returns, and what its forcings ask."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["linearised_closure", "with_forcing"]

_MOST_TURNS = 24  # of the first forcing, until all meet again


def linearised_closure(
    now: Shooting, dwell: Any, size_of: Any, period: Any = None
) -> tuple[Any, Any]:
    """Matrix (..., m, N) and right-hand side (..., m) of the linearised closure conditions.

    The unknown is the change of the start in units of the states' sizes (..., N) from `sizes`;
    `now` belongs to the present start and dwell times (..., p). If a period (...) is given, the
    sum of the dwell times is one more equation, m = N + 1; at a point whose period is NaN it is
    0 = 0. Times are in the system's unit.
    """
    size = now.starts.shape[-1]
    matrix = np.eye(size, dtype=int) - now.variational[..., :size]
    matrix = matrix * size_of[..., None, :] / size_of[..., :, None]
    right = (now.starts[-1] - now.starts[0] + now.variational[..., size]) / size_of
    if period is None or (now.starts.dtype != object and np.isnan(period).all()):
        return matrix, right
    total = dwell.sum(axis=-1)
    rates = now.rates.sum(axis=0)
    row = rates[..., :size] * size_of / np.asarray(total)[..., None]
    rest = np.asarray((period - total - rates[..., size]) / total)
    if now.starts.dtype != object:
        free = np.isnan(period)
        row, rest = np.where(free[..., None], 0.0, row), np.where(free, 0.0, rest)
    return (
        np.concatenate([matrix, row[..., None, :]], axis=-2),
        np.concatenate([right, rest[..., None]], axis=-1),
    )


def with_forcing(
    cycle: ItineraryShape,
    numbers: Numbers,
    now: Shooting,
    size_of: Any,
    matrix: Any,
    right: Any,
    lib: Any,
) -> tuple[Any, Any]:
    """The linear equations (..., m, N) and (..., m) with k equations for the forcing added.

    A forcing c, s has the amplitude 1, and several have begun together at some time at c = 1: each
    gives an equation for its amplitude, and each but the first one for its phase. `now` belongs to
    the present start, `size_of` (..., N) is as `sizes` gives it, and `lib` provides `angle`.
    Without a forcing k is 0.
    """
    rows, rests = [], []
    start = now.starts[0]
    first: Any = None
    angle_of = np.frompyfunc(lib.angle, 2, 1) if start.dtype == object else lib.angle
    for cosine, sine in cycle.structure.forcing:
        c, s = start[..., cosine], start[..., sine]
        row = np.zeros_like(start)
        row[..., cosine], row[..., sine] = c, s
        rows.append(row * size_of)
        rests.append((1 - c * c - s * s) / 2)
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
        rows.append((turn - np.asarray(ratio)[..., None] * first[2]) * size_of)
        rests.append(-_phase_difference(angle, first[1], ratio, angle_of))
    if not rows:
        return matrix, right
    return (
        np.concatenate([matrix, np.stack(rows, axis=-2)], axis=-2),
        np.concatenate([right, np.stack(rests, axis=-1)], axis=-1),
    )


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
