"""Closure conditions of a cycle in arrays: that it returns, and what its forcings ask.

A forcing is two states c, s that turn by themselves: their closure holds for whatever amplitude
they have, and for no other period than its own. Newton's method on the start alone takes both
conditions and those of the amplitude in the sense of least squares; a branch needs as many
conditions as unknowns.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.shooting.shooting_map import Cycle, Numbers
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["linearised_closure", "square_closure", "with_forcing"]

_MOST_TURNS = 24  # of the first forcing, until all meet again


def square_closure(now: Shooting, changes: Any, forcing: Sequence[tuple[int, int]]) -> Any:
    """As many closure conditions as states: residual (N,) and Jacobian (N, n).

    The amplitude of a forcing is 1; that it turns by whole turns is one condition, not two.

    Parameters
    ----------
    now : Shooting
        In columns, of dwell times that are unknowns.
    changes : array (N, n)
        Of the start.
    forcing : sequence of (int, int)
        States of the forcings.
    """
    start, state, linear = now.starts[0][:, 0], now.starts[-1][:, 0], now.variational
    residual, jacobian = state - start, linear - changes
    for c, s in forcing:
        residual[c] = start[c] ** 2 + start[s] ** 2 - 1
        jacobian[c] = 2 * (start.real[c] * changes[c] + start.real[s] * changes[s])
        residual[s] = start[c] * state[s] - start[s] * state[c]
        jacobian[s] = start.real[c] * linear[s] - start.real[s] * linear[c]
        jacobian[s] += state.real[s] * changes[c] - state.real[c] * changes[s]
    return residual, jacobian


def linearised_closure(
    now: Shooting, dwell: Any, size_of: Any, period: Any = None
) -> tuple[Any, Any]:
    """Closure, linearised, in units of the states' sizes: matrix and right-hand side.

    Where any period is given the sum of the dwell times is one equation more; at a point
    whose period is NaN that is 0 = 0.
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
    cycle: Cycle, numbers: Numbers, now: Shooting, size_of: Any, matrix: Any, right: Any, lib: Any
) -> tuple[Any, Any]:
    """Linear equations, and those of the forcing: its amplitudes, and its phases at one time.

    A forcing c, s has the amplitude 1, and several have begun together at some time at c = 1.
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
    """How far an angle is from the ratio times the first one, over turns of both."""
    turn = 2 * angle_of(0 * first, 0 * first - 1)  # 2 pi
    best: Any = None
    for turns in range(_MOST_TURNS):
        difference = angle - ratio * (first + turns * turn)
        nearest = difference - turn * np.round(np.asarray(difference / turn, dtype=float))
        if best is None:
            best = nearest
        else:
            best = np.where(np.abs(nearest) < np.abs(best) * (1 - 1e-9), nearest, best)
    return best
