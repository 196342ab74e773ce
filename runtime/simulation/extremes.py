"""Guaranteed extremes of affine functions of the state along a motion: none is missed.

The largest value is found as in `guaranteed_maxima`, for many panels at once: those whose bound
exceeds the largest value that is known are split at the zero of the slope until none is left.

All local maxima are where slopes fall through zero. On a panel of width h a function lies within
M h^4/384 of its cubic Hermite interpolant, where |f''''| <= M, and that lies between the least
and the largest of its coefficients in Bernstein form. So the slope has no zero on a panel where
these have one sign, and at most one where those of the curvature have; other panels are halved.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.guaranteed_maxima import CurveSamples, falling_zeros, upper_bounds
from nonsmooth.runtime.model.flows import functions_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import derivative_matrix, function_bounds
from nonsmooth.runtime.simulation.phase_functions import Panels, Phases, panels

__all__ = ["Extreme", "LocalMaximum", "extremes", "local_maxima"]

_ANGLE = 0.6  # radians of the fastest oscillation in a panel
_ROUNDS = 200  # of splitting; a few are enough
_HALVINGS = 40  # then a slope that touches zero is none that crosses it
_ORDERS = 7  # derivatives from that of order 0, of a function whose local maxima are sought
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
    tower, sizes = _tower(system, found, found.weights, 5)
    ends = [functions_of(system, found.configuration, t) for t in (found.left, found.right)]
    (g, slope), (g_end, slope_end) = (
        [np.einsum("nf,nfk->nk", phi, weights) for weights in tower[:2]] for phi in ends
    )
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


def _tower(
    system: PiecewiseLinear, found: Panels, weights: np.ndarray, orders: int
) -> tuple[list[np.ndarray], np.ndarray]:
    """Weights (n, functions, ...) of derivatives from order 0 on, and bounds (n, functions).

    The bounds are those of the absolute values of the functions of time on panels.
    """
    shapes = system.structure.shapes[found.configuration]
    exponents = system.exponents[found.configuration]
    turned = derivative_matrix(shapes, exponents).T
    tower = [weights]
    for _ in range(orders - 1):
        tower.append(turned @ tower[-1])
    bounds = function_bounds(shapes, exponents, found.left, found.right)
    return tower, np.stack(np.broadcast_arrays(*bounds), axis=-1)


class LocalMaximum(NamedTuple):
    """A local maximum inside a phase."""

    phase: int
    function: int  # number of the function
    since: float  # time since the beginning of the phase
    value: float


class _Slopes(NamedTuple):
    """One function on n panels: factors (7, n, functions) of its derivatives, and their bounds."""

    factors: np.ndarray
    sizes: np.ndarray

    def at(self, places: np.ndarray) -> _Slopes:
        return _Slopes(self.factors[:, places], self.sizes[:, places])


def local_maxima(system: PiecewiseLinear, phases: Phases, rows: np.ndarray) -> list[LocalMaximum]:
    """All local maxima inside phases of K affine functions of the state.

    `rows` (configurations, K, N + 1) are the functions ``n y + c``: n, then c.
    """
    return [
        maximum
        for found in panels(system, phases, rows, _ANGLE)
        for function in range(rows.shape[1])
        for maximum in _on_panels(system, found, function)
    ]


def _on_panels(system: PiecewiseLinear, found: Panels, function: int) -> Iterator[LocalMaximum]:
    """Local maxima of one function on panels."""
    configuration = found.configuration
    tower, bounds = _tower(system, found, found.weights[..., [function]], _ORDERS)
    factors = np.array(tower)[..., 0]
    sizes = np.einsum("nf,onf->on", bounds, abs(factors))
    # where a function is constant or has one slope, rounding alone gives it maxima
    moving = np.flatnonzero(sizes[1] > 0)
    whole = _Slopes(factors, sizes)
    low, high = found.left, found.right
    places, begins, ends = _brackets(system, configuration, whole, moving, low, high)
    kept = factors[:, places]

    def rates(times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        functions = functions_of(system, configuration, times)
        slope, curvature = np.einsum("nf,onf->on", functions, kept[1:3])
        return slope, curvature

    times = falling_zeros(rates, begins, ends)
    functions = functions_of(system, configuration, times)
    values = (functions * kept[0]).sum(axis=1) + found.constants[function]
    owners = found.phases[places]
    for owner, time, value in zip(owners.tolist(), times.tolist(), values.tolist(), strict=True):
        yield LocalMaximum(owner, function, time, value)


def _brackets(
    system: PiecewiseLinear,
    configuration: int,
    whole: _Slopes,
    places: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Panels on which the slope falls through zero once, and intervals that contain the zero."""
    left, right = low[places], high[places]
    kept: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for turn in range(_HALVINGS + 1):
        if not places.size:
            break
        here, width = whole.at(places), right - left
        ends = [
            np.einsum("nf,onf->on", functions_of(system, configuration, t), here.factors[1:4])
            for t in (left, right)
        ]
        least, most = _range(ends[0][:2], ends[1][:2], width, here.sizes[5])
        slack = _ROUNDING * here.sizes[1]
        flat = (most <= slack) & (least >= -slack)
        crossing = ~flat & (least <= slack) & (most >= -slack)
        bent = _range(ends[0][1:], ends[1][1:], width, here.sizes[6])
        slack = _ROUNDING * here.sizes[2]
        single = (bent[1] < -slack) | (bent[0] > slack) | (turn == _HALVINGS)
        falls = crossing & single & (ends[0][0] > 0) & (ends[1][0] <= 0)
        kept.append((places[falls], left[falls], right[falls]))
        rest = crossing & ~single
        places, left, right = places[rest], left[rest], right[rest]
        middle = (left + right) / 2
        places = np.concatenate([places, places])
        left, right = np.concatenate([left, middle]), np.concatenate([middle, right])
    if not kept:
        return places, left, right
    first, second, third = (np.concatenate(part) for part in zip(*kept, strict=True))
    return first, second, third


def _range(
    left: np.ndarray, right: np.ndarray, width: np.ndarray, fourth: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Bounds (n,) of a function on panels, from values and slopes (2, n) at their ends."""
    (f, slope), (g, slope_end) = left, right
    controls = np.array([f, f + width * slope / 3, g - width * slope_end / 3, g])
    missed = fourth * width**4 / 384
    return controls.min(axis=0) - missed, controls.max(axis=0) + missed
