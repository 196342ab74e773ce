"""Guaranteed extremes of affine functions of the state along a motion.

On a panel of width h a function lies within M h^4/384 of its cubic Hermite interpolant by values
and slopes at both ends, where |f''''| <= M, and that lies between the least and the largest of its
coefficients in Bernstein form. So the slope of a function has no zero on a panel where these have
one sign, and at most one where those of the curvature have; other panels are halved. An extreme
is at the end of a panel, or it is a local one on a panel whose bound exceeds all ends: no peak
hides.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.guaranteed_maxima import falling_zeros
from nonsmooth.runtime.model.flows import functions_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import derivative_matrix, function_bounds
from nonsmooth.runtime.simulation.phase_functions import Panels, Phases, panels

__all__ = ["Extreme", "LocalMaximum", "boundary_rows", "extremes", "local_maxima"]

_ANGLE = 0.6  # radians of the fastest oscillation in a panel
_HALVINGS = 40  # then a slope that touches zero is none that crosses it
_ROUNDING = 2.0**-50
_ORDERS = 7  # derivatives from that of order 0


class Extreme(NamedTuple):
    """An extreme value and a time at which it is attained."""

    value: float
    time: float


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
        LocalMaximum(owner, function, time, value)
        for found in panels(system, phases, rows, _ANGLE)
        for function in range(rows.shape[1])
        for owner, time, value in zip(
            *(part.tolist() for part in _maxima_on(system, found, function)), strict=True
        )
    ]


def boundary_rows(system: PiecewiseLinear) -> np.ndarray:
    """Boundary functions (configurations, K, N + 1); zero behind those of a configuration."""
    boundaries = system.structure.boundaries
    width = max(map(len, boundaries), default=0)
    found = np.zeros((len(boundaries), width, system.rows.shape[1]))
    for configuration, shapes in enumerate(boundaries):
        found[configuration, : len(shapes)] = system.rows[[shape.row for shape in shapes]]
    return found


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
        _raise_on(system, phases, signed[found.configuration], found, best, times)
    every = [
        Extreme(value, time) for value, time in zip(best.tolist(), times.tolist(), strict=True)
    ]
    return [Extreme(0.0 - value, time) for value, time in every[:count]], every[count:]


def _raise_on(
    system: PiecewiseLinear,
    phases: Phases,
    row: np.ndarray,
    found: Panels,
    best: np.ndarray,
    times: np.ndarray,
) -> None:
    """Raise the best values, and their times, to the maxima of all functions on some panels."""
    derivative = derivative_matrix(
        system.structure.shapes[found.configuration], system.exponents[found.configuration]
    ).T
    tower = [found.weights]
    for _ in range(4):
        tower.append(derivative @ tower[-1])
    functions = [functions_of(system, found.configuration, t) for t in (found.left, found.right)]
    left, right = (
        np.stack([np.einsum("nf,nfk->nk", phi, weights) for weights in tower[:2]])
        for phi in functions
    )
    sizes = _sizes(system, found)
    slack = _ROUNDING * (np.einsum("nf,nfk->nk", sizes, abs(tower[0])) + abs(found.constants))
    fourth = np.einsum("nf,nfk->nk", sizes, abs(tower[4]))
    begins = phases.begins[found.phases]
    left[0] += found.constants
    right[0] += found.constants
    # times are sums: the state in front of a transition is known better than its time
    right[0][found.last] = phases.ends[found.phases[found.last]] @ row[:, :-1].T + row[:, -1]
    _, upper = _range(left, right, (found.right - found.left)[:, None], fourth)
    for k in range(len(best)):
        for side, at in ((left, found.left), (right, found.right)):
            _raise(best, times, k, side[0][:, k], begins + at)
        kept = np.flatnonzero(upper[:, k] > best[k] + slack[:, k])
        if kept.size:
            owners, since, values = _maxima_on(system, found.at(kept), k)
            if values.size:
                _raise(best, times, k, values, phases.begins[owners] + since)


def _raise(best: np.ndarray, times: np.ndarray, k: int, values: np.ndarray, at: np.ndarray) -> None:
    top = int(np.argmax(values))
    if values[top] > best[k]:
        best[k], times[k] = values[top], at[top]


def _sizes(system: PiecewiseLinear, found: Panels) -> np.ndarray:
    """Bounds (n, functions) of the absolute values of the functions of time on panels."""
    shapes = system.structure.shapes[found.configuration]
    exponents = system.exponents[found.configuration]
    bounds = function_bounds(shapes, exponents, found.left, found.right)
    return np.stack(np.broadcast_arrays(*bounds), axis=-1)


def _maxima_on(
    system: PiecewiseLinear, found: Panels, function: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Local maxima of one function on panels: phases, times since their start, and values."""
    configuration = found.configuration
    shapes, exponents = system.structure.shapes[configuration], system.exponents[configuration]
    derivative = derivative_matrix(shapes, exponents)
    tower = [found.weights[..., function]]
    for _ in range(_ORDERS - 1):
        tower.append(tower[-1] @ derivative)
    factors = np.array(tower)
    sizes = np.einsum("nf,onf->on", _sizes(system, found), abs(factors))
    # where a function is constant or has one slope, rounding alone gives it maxima
    moving = np.flatnonzero(sizes[1] > 0)
    whole = _Slopes(factors, sizes)
    places, begins, ends = _brackets(system, configuration, whole, moving, found.left, found.right)
    kept = factors[1:3, places]

    def rates(times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        functions = functions_of(system, configuration, times)
        slope, curvature = np.einsum("nf,onf->on", functions, kept)
        return slope, curvature

    times = falling_zeros(rates, begins, ends)
    functions = functions_of(system, configuration, times)
    values = (functions * factors[0, places]).sum(axis=1) + found.constants[function]
    return found.phases[places], times, values


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
    """Bounds (n, ...) of functions on panels, from values and slopes (2, n, ...) at their ends."""
    (f, slope), (g, slope_end) = left, right
    controls = np.array([f, f + width * slope / 3, g - width * slope_end / 3, g])
    missed = fourth * width**4 / 384
    return controls.min(axis=0) - missed, controls.max(axis=0) + missed
