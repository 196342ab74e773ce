"""Newton's method on the start and the dwell times of a cycle, at many points at once.

The compiled engine does it where it is built; the same on NumPy serves elsewhere.
"""

from __future__ import annotations

import os
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.engine_layout import layout_of
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    INVALID,
    MOST_ITERATIONS,
    NEGATIVE,
    SINGULAR,
    STALLED,
    TOLERANCE,
)
from nonsmooth.runtime.shooting.shooting_map import (
    Cycle,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = [
    "LEAST",
    "Found",
    "fitting_start",
    "message_of",
    "sizes",
    "solve_cycle",
    "solve_in_python",
]

# the compiled solver's numbers
LEAST = 1e-10  # relative singular value below which equations are dependent
MOST_RESIDUAL = 1e-9  # in units of the terms that cancel
_ANGLES = 48  # of a forcing, tried for a start
SHORTEST = 1e-6  # in units of the period: a dwell time on its way to zero

_MESSAGES = {
    CONVERGED: "converged",
    STALLED: "not converged: give a guess nearer to the orbit",
    INVALID: "not finite: a parameter is outside its domain or the guess is far from any orbit",
    NEGATIVE: "a dwell time goes to zero: near the guess no motion has this itinerary;"
    " leave that phase out, or change the parameters",
    SINGULAR: "singular: one of a family of orbits, as there is where a first integral is kept;"
    " give its period",
}
_TIMED = {
    STALLED: "not converged: near the guess there may be no orbit of this period; give none, or"
    " a guess nearer to the orbit",
    SINGULAR: "singular: the period does not single an orbit out here; change a parameter",
}


class Found(NamedTuple):
    """What a solver gives at n points.

    Attributes
    ----------
    dwell : array (n, p)
    starts : array (n, p, N)
        State at the start of each phase.
    maps : array (n, N, N)
        Derivative of the start behind one period by the start.
    residual : array (n,)
    iterations, status : array (n,) of int32
    """

    dwell: np.ndarray
    starts: np.ndarray
    maps: np.ndarray
    residual: np.ndarray
    iterations: np.ndarray
    status: np.ndarray


def solve_cycle(
    cycle: Cycle,
    flat: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray | None,
    period: np.ndarray,
) -> Found:
    """Solve at many points, compiled where that is possible.

    Parameters
    ----------
    cycle : Cycle
    flat : array (n, size)
        Numbers of each point, as `numbers_at` gives them.
    dwell : array (n, p)
        Guess.
    start : array (n, N), optional
        Guess; without one the start that fits the dwell times best is taken.
    period : array (n,)
        Sum of the dwell times, or NaN where that is free.
    """
    engine = _compiled()
    try:
        layout = layout_of(cycle.structure)
    except InputError:  # larger than the engine takes
        engine = None
    if engine is None or len(cycle.structure.forcing) > 1:
        return solve_in_python(cycle, flat, dwell, start, period)
    if start is None and cycle.structure.forcing:
        with np.errstate(all="ignore"):
            start = fitting_start(cycle, flat, dwell)
    count, size = len(flat), len(cycle.structure.states)
    found = Found(
        np.array(dwell, dtype=float, order="C"),
        np.full((count, len(cycle), size), np.nan),
        np.full((count, size, size), np.nan),
        np.full(count, np.nan),
        np.zeros(count, dtype=np.int32),
        np.full(count, INVALID, dtype=np.int32),
    )
    if start is not None:
        found.starts[:, 0] = start
    flat = np.ascontiguousarray(flat, dtype=float)
    period = np.ascontiguousarray(period, dtype=float)
    engine.compose(layout, cycle.packed, period, flat, *found, start is not None)
    return found


def message_of(status: int, *, timed: bool = False) -> str:
    """What a status means and suggests, where the period was given or not."""
    return _TIMED.get(status, _MESSAGES[status]) if timed else _MESSAGES[status]


def _compiled() -> ModuleType | None:
    """The engine, unless it was not built or NONSMOOTH_BACKEND asks for NumPy."""
    if os.environ.get("NONSMOOTH_BACKEND") == "numpy":
        return None
    try:
        return import_module("nonsmooth.runtime._engine")
    except ImportError:  # without a compiler
        return None


def solve_in_python(
    cycle: Cycle,
    flat: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray | None,
    period: np.ndarray,
) -> Found:
    """Solve as `solve_cycle` does, on NumPy."""
    dwell = np.array(dwell, dtype=float)
    count, size = len(flat), len(cycle.structure.states)
    taken = np.zeros(count, dtype=np.int32)
    status = np.full(count, STALLED, dtype=np.int32)
    least = np.ones(count)
    with np.errstate(all="ignore"):
        if start is None:
            start = fitting_start(cycle, flat, dwell)
        state = np.array(start, dtype=float)
        running = np.arange(count)
        for _ in range(MOST_ITERATIONS):
            if not len(running):
                break
            numbers = numbers_in(cycle.structure, flat[running])
            now = shoot(cycle, numbers, dwell[running], state[running], np)
            taken[running] += 1
            size_of = sizes(now, dwell[running])
            matrix, right = linearised_closure(now, dwell[running], size_of, period[running])
            matrix, right = with_forcing(cycle, numbers, now, size_of, matrix, right, FLOATS)
            step, least[running] = _least_squares(matrix, right)
            step = step * size_of
            change = now.rates[..., size].T + np.einsum("pnk,nk->np", now.rates[..., :size], step)
            here, total = dwell[running], dwell[running].sum(axis=-1)
            relative = np.concatenate([step / size_of, change / total[:, None]], axis=-1)
            bound = np.where(change < 0, 0.75, 3.0) * here / np.abs(change)
            fraction = np.minimum(1.0, bound.min(axis=-1))
            state[running] += fraction[:, None] * step
            dwell[running] += fraction[:, None] * change
            done = (fraction == 1) & (np.abs(relative) <= TOLERANCE).all(axis=-1)
            status[running[done]] = CONVERGED
            lost = ~np.isfinite(relative).all(axis=-1)
            status[running[lost]] = INVALID
            running = running[~(done | lost)]
        last = shoot(cycle, numbers_in(cycle.structure, flat), dwell, state, np)
        size_of = sizes(last, dwell)
        residual, missed = _residuals(cycle, flat, last, size_of, dwell.T)
        total = dwell.sum(axis=-1)
        status[~np.isfinite(residual)] = INVALID
        status[(status == CONVERGED) & ~(missed <= MOST_RESIDUAL)] = STALLED
        status[(status == CONVERGED) & ~(least > LEAST)] = SINGULAR
        status[(status == STALLED) & (dwell.min(axis=-1) < SHORTEST * total)] = NEGATIVE
    starts = np.moveaxis(last.starts[:-1], 0, 1)
    return Found(dwell, starts, last.variational[..., :size], residual, taken, status)


def sizes(now: Shooting, dwell: Any) -> Any:
    """Size of each state along a passage (..., N): its unit of measure."""
    waits = np.moveaxis(np.asarray(dwell), -1, 0)[..., None]
    found = np.concatenate([np.abs(now.starts), np.abs(now.ends), np.abs(now.velocities * waits)])
    largest = found.max(axis=0)
    return np.where(largest == 0, 1, largest)


def fitting_start(cycle: Cycle, flat: np.ndarray, dwell: np.ndarray) -> np.ndarray:
    """The start that fits given dwell times best: closure and switching are linear in it.

    A forcing has some angle at the start: of several that are tried the one that fits best.
    """
    size = len(cycle.structure.states)
    numbers = numbers_in(cycle.structure, flat)
    # differences of affine functions are their coefficients
    passages = [
        shoot(cycle, numbers, dwell, np.broadcast_to(start, (len(flat), size)), np)
        for start in (np.zeros(size), *np.eye(size))
    ]
    missed = [
        np.concatenate([np.moveaxis(p.residual, 0, -1), p.starts[0] - p.starts[-1]], axis=-1)
        for p in passages
    ]
    matrix = np.stack([m - missed[0] for m in missed[1:]], axis=-1)
    forcing = cycle.structure.forcing
    if forcing:
        rates = np.stack([np.moveaxis(p.speeds, 0, -1) for p in passages], axis=-1)
        rates[..., 1:] -= rates[..., :1]
        turns = np.abs(numbers.fields[:, 0][:, [s for _, s in forcing], [c for c, _ in forcing]])
        return _fitting_forced(matrix, -missed[0], rates, forcing, turns)
    # in no units: equations in those of their largest term, unknowns of their coefficients
    unit = np.concatenate([np.zeros((len(cycle), size)), np.eye(size)])
    rows = (np.abs(matrix - unit) + unit).max(axis=-1, keepdims=True)
    matrix = matrix / np.where(rows > 0, rows, 1)
    columns = np.abs(matrix).max(axis=-2)
    columns = np.where(columns > 0, columns, 1)
    right = -missed[0] / np.where(rows > 0, rows, 1)[..., 0]
    start, _ = _least_squares(matrix / columns[..., None, :], right)
    return start / columns


def _fitting_forced(
    matrix: np.ndarray, right: np.ndarray, rates: np.ndarray, forcing: Any, turns: np.ndarray
) -> np.ndarray:
    """Best start over the times since all forcings were at c = 1, s = 0.

    Of two that fit equally well, such as mirror images, the one that reaches its boundaries
    from inside: there their `rates`, affine in the start, are positive.
    """
    count, _, size = matrix.shape
    known = [state for pair in forcing for state in pair]
    free = [k for k in range(size) if k not in known]
    best, least = np.full((count, size), np.nan), np.full(count, np.inf)
    for part in np.arange(_ANGLES) / _ANGLES:
        start = np.zeros((count, size))
        for place, (cosine, sine) in enumerate(forcing):
            angle = 2 * np.pi * part * turns[:, place] / turns.min(axis=1)
            start[:, cosine], start[:, sine] = np.cos(angle), np.sin(angle)
        rest = right - np.einsum("nij,nj->ni", matrix, start)
        scale = np.abs(matrix[..., free]).max(axis=(-2, -1), keepdims=True)
        found, _ = _least_squares(matrix[..., free] / scale, rest / scale[..., 0])
        start[:, free] = found
        missed = np.einsum("nij,nj->ni", matrix, start) - right
        reached = np.einsum("npj,nj->np", rates[..., 1:], start) + rates[..., 0]
        error = np.abs(missed).max(axis=-1) * np.where((reached > 0).all(axis=-1), 1, 1e3)
        better = error < least
        best[better], least[better] = start[better], error[better]
    return best


def _least_squares(matrix: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shortest solutions in the sense of least squares, and the smallest singular values.

    The latter in units of the largest; NaN where something is not finite.
    """
    count, _, size = matrix.shape
    solution, least = np.full((count, size), np.nan), np.full(count, np.nan)
    sound = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1)
    if sound.any():
        left, values, rest = np.linalg.svd(matrix[sound], full_matrices=False)
        kept = values > LEAST * values[:, :1]
        inverse = np.where(kept, 1 / np.where(kept, values, 1), 0)
        parts = inverse * np.einsum("nij,ni->nj", left, right[sound])
        solution[sound] = np.einsum("nji,nj->ni", rest, parts)
        least[sound] = np.nan_to_num(values[:, -1] / values[:, 0])
    return solution, least


def _residuals(
    cycle: Cycle, flat: np.ndarray, now: Shooting, size_of: np.ndarray, waits: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Largest absolute value of closure and switching, and in units of what cancels."""
    rows = np.moveaxis(numbers_in(cycle.structure, flat).rows[:, list(cycle.rows)], 1, 0)
    reach = np.maximum(np.abs(now.ends), np.abs(now.velocities * waits[..., None]))
    terms = (np.abs(rows[..., :-1]) * reach).sum(axis=-1) + np.abs(rows[..., -1])
    gaps = np.abs(now.residual)
    closure = np.abs(now.starts[-1] - now.starts[0])
    absolute = np.maximum(gaps.max(axis=0), closure.max(axis=-1))
    relative = np.where(terms > 0, gaps / terms, 0).max(axis=0)
    return absolute, np.maximum(relative, (closure / size_of).max(axis=-1))
