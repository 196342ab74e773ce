"""Newton's method on the start and the dwell times of an itinerary, at many points at once.

Digits are counted by what rounding moves in the linearised equations.

The compiled engine does it where it is built; the same on NumPy serves elsewhere.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.exponentials.matrices import inverses
from nonsmooth.runtime.model.engine_layout import layout_of
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.shooting.closure_conditions import closure_equations
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    DETERMINED,
    GOING,
    INVALID,
    LEAST,
    NEGATIVE,
    SHORTEST,
    SINGULAR,
    STALLED,
    TOLERANCE,
    damping,
    iterate,
    judged,
    sure_digits,
)
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    flows_along,
    numbers_in,
    shoot,
    shoot_along,
    shoot_many,
)
from nonsmooth.runtime.shooting.translations import up_to_shift

# the compiled solver's numbers
MOST_RESIDUAL = 1e-9  # in units of the terms that cancel
_ANGLES = 48  # of a forcing, tried for a start
_EPSILON = float(np.finfo(float).eps)
_TERM = 8.0  # roundings of one term of a flow
_TURNED = 1.0  # radians of the fastest mode in which rounding of exponents adds another one
_MOST_ERROR = 1e-4  # by a bound that is a hundred times the error, or more
_WIDE = 1e4  # between a flow's rates, or in radians: nearer together rounding loses few digits
NOTHING = 1e-18  # of the largest state: rounding of rounding is smaller


class TableSolution(NamedTuple):
    """The result of a solver at n points."""

    dwell: np.ndarray  # (n, p)
    starts: np.ndarray  # (n, p, N), state at the start of each phase
    maps: np.ndarray  # (n, N, N), derivative of the start behind one period by the start
    residual: np.ndarray  # (n,)
    iterations: np.ndarray  # (n,) of int32
    status: np.ndarray  # (n,) of int32


def unsolved(dwell: np.ndarray, size: int, width: int) -> TableSolution:
    """Nothing found at n points, with dwell times (n, p), N = `size` and maps of a `width`."""
    count, phases = dwell.shape
    return TableSolution(
        dwell,
        np.full((count, phases, size), np.nan),
        np.full((count, width, width), np.nan),
        np.full(count, np.nan),
        np.zeros(count, dtype=np.int32),
        np.full(count, INVALID, dtype=np.int32),
    )


def solve_shape(
    cycle: ItineraryShape,
    flat: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray | None,
    period: np.ndarray,
) -> TableSolution:
    """Solve the equations of a cycle at n points, compiled if that is possible.

    `flat` (n, size) has the numbers of each point, as `numbers_at` gives them. `dwell` (n, p) and
    `start` (n, N) are guesses, in the system's units; without a start the one that fits the dwell
    times best is taken. `period` (n,) is the sum of the dwell times, or NaN where it is free.
    """
    engine = compiled_engine()
    if engine is None or len(cycle.structure.forcing) > 1:
        return solve_in_python(cycle, flat, dwell, start, period)
    if start is None and cycle.structure.forcing:
        with np.errstate(all="ignore"):
            start = fitting_start(cycle, flat, dwell)
    size = len(cycle.structure.states)
    found = unsolved(np.array(dwell, dtype=float, order="C"), size, size)
    if start is not None:
        found.starts[:, 0] = start
    flat = np.ascontiguousarray(flat, dtype=float)
    period = np.ascontiguousarray(period, dtype=float)
    engine.compose(
        layout_of(cycle.structure), cycle.packed, period, flat, *found, start is not None
    )
    return found


def solve_in_python(
    cycle: ItineraryShape,
    flat: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray | None,
    period: np.ndarray,
) -> TableSolution:
    """Solve as `solve_shape` does, on NumPy."""
    dwell = np.array(dwell, dtype=float)
    count, size = len(flat), len(cycle.structure.states)
    least = np.ones(count)

    def advance(running: np.ndarray) -> np.ndarray:
        numbers, here = numbers_in(cycle.structure, flat[running]), dwell[running]
        now = shoot(cycle, numbers, here, state[running], np)
        size_of = sizes(now, here)
        matrix, right = closure_equations(cycle, numbers, now, here, size_of, period[running])
        step, least[running] = _least_squares(matrix, right)
        step = step * size_of
        change = now.rates[..., size].T + np.einsum("pnk,nk->np", now.rates[..., :size], step)
        total = here.sum(axis=-1, keepdims=True)
        relative = np.concatenate([step / size_of, change / total], axis=-1)
        fraction = damping(here, change, growth=3.0)
        state[running] += fraction[:, None] * step
        dwell[running] += fraction[:, None] * change
        done = (fraction == 1) & (np.abs(relative) <= TOLERANCE).all(axis=-1)
        lost = ~np.isfinite(relative).all(axis=-1)
        return np.where(lost, INVALID, np.where(done, CONVERGED, GOING))

    with np.errstate(all="ignore"):
        state = np.array(fitting_start(cycle, flat, dwell) if start is None else start, float)
        taken, status = iterate(count, advance)
        last = shoot(cycle, numbers_in(cycle.structure, flat), dwell, state, np)
        size_of = sizes(last, dwell)
        residual, missed = _residuals(cycle, flat, last, size_of, dwell.T)
        total = dwell.sum(axis=-1)
        status[~np.isfinite(residual)] = INVALID
        status[(status == CONVERGED) & ~(missed <= MOST_RESIDUAL)] = STALLED
        status[(status == CONVERGED) & ~(least > LEAST)] = SINGULAR
        status[(status == STALLED) & (dwell.min(axis=-1) < SHORTEST * total)] = NEGATIVE
    starts = np.moveaxis(last.starts[:-1], 0, 1)
    return TableSolution(dwell, starts, last.variational[..., :size], residual, taken, status)


def sizes(now: Shooting, dwell: Any) -> Any:
    """Size (..., N) of each state along a passage, used as its unit, from dwell times (..., p).

    A state that decays to zero by itself has no size of its own: none is smaller than `NOTHING`
    times the largest, and all are 1 if all states are zero.
    """
    waits = np.moveaxis(np.asarray(dwell), -1, 0)[..., None]
    found = np.concatenate([np.abs(now.starts), np.abs(now.ends), np.abs(now.velocities * waits)])
    own = found.max(axis=0)
    largest = own.max(axis=-1, keepdims=True)
    return np.where(largest == 0, 1, np.maximum(own, NOTHING * largest))


def _residuals(
    cycle: ItineraryShape, flat: np.ndarray, now: Shooting, size_of: np.ndarray, waits: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Largest error of closure and switching, absolute and relative to the terms that cancel."""
    rows = np.moveaxis(numbers_in(cycle.structure, flat).rows[:, list(cycle.rows)], 1, 0)
    reach = np.maximum(np.abs(now.ends), np.abs(now.velocities * waits[..., None]))
    terms = (np.abs(rows[..., :-1]) * reach).sum(axis=-1) + np.abs(rows[..., -1])
    gaps = np.abs(now.residual)
    closure = np.abs(now.starts[-1] - now.starts[0])
    absolute = np.maximum(gaps.max(axis=0), closure.max(axis=-1))
    relative = np.where(terms > 0, gaps / terms, 0).max(axis=0)
    return absolute, np.maximum(relative, (closure / size_of).max(axis=-1))


def fitting_start(cycle: ItineraryShape, flat: np.ndarray, dwell: np.ndarray) -> np.ndarray:
    """The start (n, N) that fits given dwell times (n, p) best, by least squares.

    Closure and switching conditions are linear in the start. A forcing has some angle at the
    start: several are tried, and the best fit is kept. `flat` (n, size) has the numbers of each
    point, as `numbers_at` gives them; times are in the system's unit.
    """
    size = len(cycle.structure.states)
    numbers = numbers_in(cycle.structure, flat)
    # differences of affine functions are their coefficients
    flows = flows_along(cycle, numbers, dwell, np)
    passages = [
        shoot_along(cycle, numbers, flows, np.broadcast_to(start, (len(flat), size)))
        for start in (np.zeros(size), *np.eye(size))
    ]
    missed, *others = (
        np.concatenate([np.moveaxis(p.residual, 0, -1), p.starts[0] - p.starts[-1]], axis=-1)
        for p in passages
    )
    matrix = np.stack([other - missed for other in others], axis=-1)
    forcing = cycle.structure.forcing
    if forcing:
        rates = np.stack([np.moveaxis(p.speeds, 0, -1) for p in passages], axis=-1)
        rates[..., 1:] -= rates[..., :1]
        turns = np.abs(numbers.fields[:, 0][:, [s for _, s in forcing], [c for c, _ in forcing]])
        return _fitting_forced(matrix, -missed, rates, forcing, turns)
    # in no units: equations in those of their largest term, unknowns of their coefficients
    unit = np.concatenate([np.zeros((len(cycle), size)), np.eye(size)])
    rows = (np.abs(matrix - unit) + unit).max(axis=-1, keepdims=True)
    matrix = matrix / np.where(rows > 0, rows, 1)
    columns = np.abs(matrix).max(axis=-2)
    columns = np.where(columns > 0, columns, 1)
    right = -missed / np.where(rows > 0, rows, 1)[..., 0]
    start, _ = _least_squares(matrix / columns[..., None, :], right)
    return start / columns


def _fitting_forced(
    matrix: np.ndarray, right: np.ndarray, rates: np.ndarray, forcing: Any, turns: np.ndarray
) -> np.ndarray:
    """The best start over the time that has passed since all forcings were at c = 1, s = 0.

    Of two that fit equally well, such as mirror images, the one that reaches its boundaries
    from inside is taken: there their `rates`, affine in the start, are positive.
    """
    count, _, size = matrix.shape
    known = [state for pair in forcing for state in pair]
    free = [k for k in range(size) if k not in known]
    part = np.arange(_ANGLES)[:, None] / _ANGLES
    start = np.zeros((_ANGLES, count, size))
    for place, (cosine, sine) in enumerate(forcing):
        angle = 2 * np.pi * part * turns[:, place] / turns.min(axis=1)
        start[..., cosine], start[..., sine] = np.cos(angle), np.sin(angle)
    rest = right - np.einsum("nij,anj->ani", matrix, start)
    scale = np.abs(matrix[..., free]).max(axis=(-2, -1), keepdims=True)
    start[..., free], _ = _least_squares(matrix[..., free] / scale, rest / scale[..., 0])
    missed = np.einsum("nij,anj->ani", matrix, start) - right
    reached = np.einsum("npj,anj->anp", rates[..., 1:], start) + rates[..., 0]
    error = np.abs(missed).max(axis=-1) * np.where((reached > 0).all(axis=-1), 1, 1e3)
    error = np.where(np.isfinite(error), error, np.inf)
    best: np.ndarray = start[error.argmin(axis=0), np.arange(count)]
    best[np.isinf(error.min(axis=0))] = np.nan
    return best


def _least_squares(matrix: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shortest least-squares solutions (..., n, k), and the smallest singular values (n,).

    Matrices are (n, m, k), right-hand sides (..., n, m). Singular values are relative to the
    largest. Both are NaN where something is not finite.
    """
    count, _, size = matrix.shape
    solution, least = np.full((*right.shape[:-1], size), np.nan), np.full(count, np.nan)
    sound = np.isfinite(right).all(axis=-1).reshape(-1, count).all(axis=0)
    sound &= np.isfinite(matrix).all(axis=(-2, -1))
    if sound.any():
        left, values, rest = np.linalg.svd(matrix[sound], full_matrices=False)
        kept = values > LEAST * values[:, :1]
        inverse = np.where(kept, 1 / np.where(kept, values, 1), 0)
        parts = inverse * np.einsum("nij,...ni->...nj", left, right[..., sound, :])
        solution[..., sound, :] = np.einsum("nji,...nj->...ni", rest, parts)
        least[sound] = np.nan_to_num(values[:, -1] / values[:, 0])
    return solution, least


def digits_of(
    cycle: ItineraryShape,
    flat: np.ndarray,
    found: TableSolution,
    period: np.ndarray,
    directions: np.ndarray,
    *,
    every: bool = True,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the decimal digits (n,) of orbits in double precision, and their status (n,).

    There are 0 digits where there is no orbit. The status is `UNSURE` in place of
    `CONVERGED` where no digit is sure, and `NEGATIVE` where a dwell time is zero within
    its error. The cycle closes up to translations or by a symmetry; `flat` (n, size) are
    its numbers as `numbers_at` gives them; `period` (n,) is the sum of the dwell times in
    the unit of time, NaN where free; `directions` (n, m, N) are those of translations.

    Unless `every` orbit is looked at, those are that have rates far apart, turn many times in a
    phase, or have a short phase; of these four digits have to be sure.
    """
    digits, status = np.zeros(len(flat), dtype=int), found.status.copy()
    looked = status == CONVERGED
    with np.errstate(all="ignore"):
        if not every:
            short = found.dwell.min(axis=-1) < SHORTEST * found.dwell.sum(axis=-1)
            looked &= short | _far_apart(cycle, flat, found.dwell)
        places = np.flatnonzero(looked)
        if len(places):
            dwell, start = found.dwell[places], found.starts[places, 0]
            at = flat[places], dwell, start, period[places], directions[places]
            errors, of_dwell = _errors(cycle, *at)
            status[places] = judged(dwell, of_dwell, errors, DETERMINED if every else _MOST_ERROR)
            digits[places] = [sure_digits(error) for error in errors.tolist()]
    return digits, status


def _far_apart(cycle: ItineraryShape, flat: np.ndarray, dwell: np.ndarray) -> np.ndarray:
    exponents = numbers_in(cycle.structure, flat).exponents
    speeds = [np.hypot(*np.moveaxis(exponents[c], -1, 0)) for c in {*cycle.configurations}]
    every = np.concatenate(speeds, axis=-1)
    fastest = every.max(axis=-1)
    slowest = np.where(every > 0, every, np.inf).min(axis=-1)
    turned = fastest * dwell.max(axis=-1)
    return np.asarray(~((fastest < _WIDE * slowest) & (turned < _WIDE)))


def _errors(
    cycle: ItineraryShape,
    flat: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray,
    period: np.ndarray,
    directions: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Return errors of orbits (n,) in units of max(1, |x|), and of their dwell times (n, p) alone.

    What closure and switching miss, and rounding, move the start by as much as the
    inverse of the linearised equations lets them, and the dwell times with it.
    """
    numbers = numbers_in(cycle.structure, flat)
    now = shoot_many(cycle, numbers, dwell, start)
    size_of = sizes(_without_drift(now, directions), dwell)
    matrix, right = closure_equations(cycle, numbers, now, dwell, size_of, period)
    errors, of_dwell = np.full(len(flat), math.inf), np.full(dwell.shape, math.inf)
    sound = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1)
    missed = np.abs(right)
    phases = zip(cycle.configurations, dwell.T, now.starts, strict=False)
    rounding = np.array([_rounding(cycle, numbers, *phase) for phase in phases])
    rounding = rounding + _TERM * _EPSILON * size_of
    rows = np.abs(np.moveaxis(numbers.rows[:, list(cycle.rows), :-1], 1, 0))
    gaps = (np.abs(now.residual) + (rows * rounding).sum(axis=-1)) / np.abs(now.speeds)
    moved = rounding + np.abs(now.velocities) * gaps[..., None]
    missed[:, : size_of.shape[-1]] += (moved / size_of).sum(axis=0)
    square = matrix.shape[-1] == matrix.shape[-2]
    inverse = inverses(matrix[sound]) if square else np.linalg.pinv(matrix[sound], rcond=0.0)
    by_state = (np.abs(inverse) * missed[sound, None, :]).sum(axis=-1) * size_of[sound]
    by_start = (np.abs(now.rates[:, sound, :-1]) * by_state).sum(axis=-1) + gaps[:, sound]
    own = by_state / np.maximum(1, np.abs(start[sound]))
    waits = by_start / np.maximum(1, dwell[sound]).T
    errors[sound] = np.maximum(own.max(axis=-1), waits.max(axis=0))
    of_dwell[sound] = by_start.T
    return errors, of_dwell


def _rounding(
    cycle: ItineraryShape, numbers: Numbers, configuration: int, time: Any, start: np.ndarray
) -> np.ndarray:
    """Return the rounding of the state (n, N) at a phase's end, by the terms of its sum."""
    shapes, exponents = cycle.structure.shapes[configuration], numbers.exponents[configuration]
    functions = np.abs(np.stack(functions_at(shapes, exponents, time), axis=-1))
    speeds = np.hypot(exponents[..., 0], exponents[..., 1])
    turned = speeds.max(axis=-1) * time / _TURNED  # eigenvalues are known as well as the largest
    flows, extended = numbers.flows[configuration], np.abs(start)
    if isinstance(flows, FactoredFlows):
        sizes = flows.sizes(np.concatenate([extended, np.ones((len(start), 1))], axis=1))
    else:
        flows = np.abs(flows)
        sizes = (flows[..., :-1] @ extended[:, None, :, None])[..., 0] + flows[..., -1]
    terms = (functions[:, None] @ sizes)[:, 0]
    return np.asarray((_TERM + turned[:, None]) * _EPSILON * terms)


def _without_drift(now: Shooting, directions: np.ndarray) -> Shooting:
    """Return states up to translations: how far an orbit drifts says nothing of its size."""
    if not directions.shape[1]:
        return now
    starts, ends, fields = (
        np.stack([up_to_shift(part[:, k], d) for k, d in enumerate(directions)], axis=1)
        for part in (now.starts, now.ends, now.velocities)
    )
    return now._replace(starts=starts, ends=ends, velocities=fields)
