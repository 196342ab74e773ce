"""Guaranteed extremes of affine functions of the state along a motion.

It is the search of `guaranteed_maxima` for many panels at once: those whose bound exceeds the
largest value that is known are split at the zero of the slope until none is left.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.guaranteed_maxima import CurveSamples, upper_bounds
from nonsmooth.runtime.model.flows import functions_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import derivative_matrix, function_bounds
from nonsmooth.runtime.simulation.phase_functions import Panels, Phases, panels

__all__ = ["Extreme", "extremes"]

_ANGLE = 0.6  # radians of the fastest oscillation in a panel
_ROUNDS = 200  # of splitting; a few are enough
_ROUNDING = 2.0**-50


class Extreme(NamedTuple):
    """An extreme value and a time at which it is attained."""

    value: float
    time: float


class _WaitingPanels(NamedTuple):
    """One function g on n panels that are still to be split.

    The weights (n, functions) are those of the functions of time in g, g' and g''.
    """

    configuration: int
    weights: tuple[np.ndarray, np.ndarray, np.ndarray]
    constants: np.ndarray  # (n,) added to the sum for g
    begins: np.ndarray  # (n,) times at which the phases begin
    bounds: np.ndarray  # (n,) of the fourth derivative, divided by 144
    slack: np.ndarray  # (n,) rounding errors of g


def extremes(
    system: PiecewiseLinear, phases: Phases, rows: np.ndarray
) -> tuple[list[Extreme], list[Extreme]]:
    """Minima and maxima (K,) of affine functions over all phases.

    The functions `rows` (configurations, K, N + 1) are ``n y + c``: n, then c. The values
    are attained, and no other one exceeds them by more than rounding.
    """
    count = rows.shape[1]
    signed = np.concatenate([-rows, rows], axis=1)
    best = np.full(2 * count, -np.inf)
    times = np.full(2 * count, np.nan)
    for found in panels(system, phases, signed, _ANGLE):
        _search(system, phases, signed, found, best, times)
    every = [
        Extreme(value, time) for value, time in zip(best.tolist(), times.tolist(), strict=True)
    ]
    return [Extreme(0.0 - value, time) for value, time in every[:count]], every[count:]


def _search(
    system: PiecewiseLinear,
    phases: Phases,
    signed: np.ndarray,
    found: Panels,
    best: np.ndarray,
    times: np.ndarray,
) -> None:
    """Raise the best values, and their times, to the maxima of all functions on some panels."""
    turned = _derivative(system, found.configuration).T
    tower = [found.weights]
    for _ in range(4):
        tower.append(turned @ tower[-1])
    ends = [functions_of(system, found.configuration, t) for t in (found.left, found.right)]
    (g, slope), (g_end, slope_end) = (
        [np.einsum("nf,nfk->nk", phi, weights) for weights in tower[:2]] for phi in ends
    )
    sizes = _sizes(system, found)
    slack = _ROUNDING * (np.einsum("nf,nfk->nk", sizes, abs(tower[0])) + abs(found.constants))
    fourth = np.einsum("nf,nfk->nk", sizes, abs(tower[4])) / 144
    begins = phases.begins[found.phases]
    g += found.constants
    g_end += found.constants
    # times are sums: the state in front of a transition is known better than its time
    row = signed[found.configuration]
    g_end[found.last] = phases.ends[found.phases[found.last]] @ row[:, :-1].T + row[:, -1]
    for values, at in ((g, found.left), (g_end, found.right)):
        top = np.argmax(values, axis=0)
        _raise(best, times, np.arange(len(best)), values[top, range(len(best))], (begins + at)[top])
    left, right = found.left[:, None], found.right[:, None]
    samples = CurveSamples(g, left, slope), CurveSamples(g_end, right, slope_end)
    upper = upper_bounds(*samples, fourth * (right - left) ** 4)
    for k in range(len(best)):
        kept = np.flatnonzero(upper[:, k] > best[k] + slack[:, k])
        if kept.size:
            waiting = _WaitingPanels(
                found.configuration,
                (tower[0][kept, :, k], tower[1][kept, :, k], tower[2][kept, :, k]),
                np.full(kept.size, found.constants[k]),
                begins[kept],
                fourth[kept, k],
                slack[kept, k],
            )
            sides = [np.array([value[kept, k], time[kept, 0], rate[kept, k]])
                     for value, time, rate in samples]  # fmt: skip
            _split(system, waiting, sides[0], sides[1], k, best, times)


def _split(
    system: PiecewiseLinear,
    search: _WaitingPanels,
    left: np.ndarray,
    right: np.ndarray,
    k: int,
    best: np.ndarray,
    times: np.ndarray,
) -> None:
    """Split panels until none can hold a value of function `k` above its best one.

    `left` and `right` (3, n) are the value, the time and the slope at the ends of the
    panels.
    """
    for turn in range(_ROUNDS):
        middle = (left[1] + right[1]) / 2
        if turn % 2 == 0:
            peaks = (left[2] > 0) & (right[2] < 0)
            for _ in range(8):
                slope, curvature = (_sum(system, search, order, middle) for order in (1, 2))
                with np.errstate(divide="ignore", invalid="ignore"):
                    newton = np.nan_to_num(middle - slope / curvature, nan=0.0)
                middle = np.where(peaks, np.clip(newton, left[1], right[1]), middle)
        value = _sum(system, search, 0, middle) + search.constants
        split = np.array([value, middle, _sum(system, search, 1, middle)])
        top = int(np.argmax(value))
        _raise(best, times, np.array([k]), value[[top]], (search.begins + middle)[[top]])
        left, right = np.hstack([left, split]), np.hstack([split, right])
        excess = np.tile(search.bounds, 2) * (right[1] - left[1]) ** 4
        upper = upper_bounds(CurveSamples(*left), CurveSamples(*right), excess)
        places = np.flatnonzero(upper > best[k] + np.tile(search.slack, 2))
        if not places.size:
            return
        left, right = left[:, places], right[:, places]
        half = places % len(search.begins)
        search = _WaitingPanels(
            search.configuration,
            (search.weights[0][half], search.weights[1][half], search.weights[2][half]),
            search.constants[half],
            search.begins[half],
            search.bounds[half],
            search.slack[half],
        )


def _raise(
    best: np.ndarray, times: np.ndarray, which: np.ndarray, values: np.ndarray, at: np.ndarray
) -> None:
    better = values > best[which]
    best[which[better]], times[which[better]] = values[better], at[better]


def _sum(
    system: PiecewiseLinear, search: _WaitingPanels, order: int, times: np.ndarray
) -> np.ndarray:
    functions = functions_of(system, search.configuration, times)
    return np.asarray((functions * search.weights[order]).sum(axis=1))


def _derivative(system: PiecewiseLinear, configuration: int) -> np.ndarray:
    """Matrix (functions, functions) that gives the derivatives of the functions of time."""
    shapes = system.structure.shapes[configuration]
    return derivative_matrix(shapes, system.exponents[configuration])


def _sizes(system: PiecewiseLinear, found: Panels) -> np.ndarray:
    """Bounds (n, functions) of the absolute values of the functions of time on panels."""
    shapes = system.structure.shapes[found.configuration]
    exponents = system.exponents[found.configuration]
    bounds = function_bounds(shapes, exponents, found.left, found.right)
    return np.stack(np.broadcast_arrays(*bounds), axis=-1)
