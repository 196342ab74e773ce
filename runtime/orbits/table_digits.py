"""How many digits rounding leaves of orbits that are composed from tables."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.orbits.orbit import DOUBLE
from nonsmooth.runtime.shooting.closure_conditions import closure_equations
from nonsmooth.runtime.shooting.newton import CONVERGED, SHORTEST, judged
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, numbers_in, shoot
from nonsmooth.runtime.shooting.table_newton import TableSolution, sizes
from nonsmooth.runtime.shooting.translations import up_to_shift
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["digits_of"]

_EPSILON = float(np.finfo(float).eps)
_TERM = 8.0  # roundings of one term of a flow
_TURNED = 1.0  # radians of the fastest mode in which rounding of exponents adds another one
_MOST_ERROR = 1e-4  # by a bound that is a hundred times the error, or more
_NO_DIGIT = 0.1
_WIDE = 1e4  # between a flow's rates, or in radians: nearer together rounding loses few digits


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
    with np.errstate(all="ignore"):  # of what is not finite there are no digits
        if not every:
            short = found.dwell.min(axis=-1) < SHORTEST * found.dwell.sum(axis=-1)
            looked &= short | _far_apart(cycle, flat, found.dwell)
        places = np.flatnonzero(looked)
        if len(places):
            dwell, start = found.dwell[places], found.starts[places, 0]
            at = flat[places], dwell, start, period[places], directions[places]
            errors, of_dwell = _errors(cycle, *at)
            status[places] = judged(dwell, of_dwell, errors, _NO_DIGIT if every else _MOST_ERROR)
            known = np.floor(-np.log10(np.maximum(errors, 1e-300)))
            digits[places] = np.where(np.isfinite(known), np.clip(known, 0, DOUBLE), 0)
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
    now = shoot(cycle, numbers, dwell, start, np)
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
    inverse = np.abs(np.linalg.pinv(matrix[sound], rcond=0.0))
    by_state = (inverse * missed[sound, None, :]).sum(axis=-1) * size_of[sound]
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
