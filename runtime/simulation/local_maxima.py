"""All local maxima of affine functions of the state inside phases, none of them missed.

On a panel of width h a function lies within M h^4/384 of its cubic Hermite interpolant by values
and slopes at both ends, where |f''''| <= M, and that lies between the least and the largest of its
coefficients in Bernstein form. So the slope of a function has no zero on a panel where these have
one sign, and at most one where those of the curvature have; other panels are halved.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.flows import functions_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import derivative_matrix, function_bounds
from nonsmooth.runtime.simulation.phase_functions import Panels, Phases, panels

__all__ = ["LocalMaximum", "boundary_rows", "local_maxima"]

_ANGLE = 0.6  # radians of the fastest oscillation in a panel
_HALVINGS = 40  # then a slope that touches zero is none that crosses it
_POLISHING = 60  # steps of Newton's method, or of bisection where it leaves its bracket
_ROUNDING = 2.0**-50
_ORDERS = 7  # derivatives from that of order 0


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


def boundary_rows(system: PiecewiseLinear) -> np.ndarray:
    """Boundary functions (configurations, K, N + 1); zero behind those of a configuration."""
    boundaries = system.structure.boundaries
    width = max(map(len, boundaries), default=0)
    found = np.zeros((len(boundaries), width, system.rows.shape[1]))
    for configuration, shapes in enumerate(boundaries):
        found[configuration, : len(shapes)] = system.rows[[shape.row for shape in shapes]]
    return found


def _on_panels(system: PiecewiseLinear, found: Panels, function: int) -> Iterator[LocalMaximum]:
    """Local maxima of one function on panels."""
    configuration = found.configuration
    shapes, exponents = system.structure.shapes[configuration], system.exponents[configuration]
    derivative = derivative_matrix(shapes, exponents)
    tower = [found.weights[..., function]]
    for _ in range(_ORDERS - 1):
        tower.append(tower[-1] @ derivative)
    factors = np.array(tower)
    bounds = function_bounds(shapes, exponents, found.left, found.right)
    sizes = np.einsum("nf,onf->on", np.stack(np.broadcast_arrays(*bounds), axis=-1), abs(factors))
    # where a function is constant or has one slope, rounding alone gives it maxima
    moving = np.flatnonzero(sizes[1] > 0)
    whole = _Slopes(factors, sizes)
    low, high = found.left, found.right
    places, begins, ends = _brackets(system, configuration, whole, moving, low, high)
    times = _zeros(system, configuration, whole.at(places), begins, ends)
    functions = functions_of(system, configuration, times)
    values = (functions * factors[0, places]).sum(axis=1) + found.constants[function]
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


def _zeros(
    system: PiecewiseLinear,
    configuration: int,
    here: _Slopes,
    low: np.ndarray,
    high: np.ndarray,
) -> np.ndarray:
    """Zeros (n,) of slopes that fall through zero in intervals."""
    times = (low + high) / 2
    for _ in range(_POLISHING):
        functions = functions_of(system, configuration, times)
        slope, bend = np.einsum("nf,onf->on", functions, here.factors[1:3])
        low, high = np.where(slope > 0, times, low), np.where(slope > 0, high, times)
        with np.errstate(all="ignore"):
            newton = times - slope / bend
        inside = (newton >= low) & (newton <= high)
        following = np.where(inside, newton, (low + high) / 2)
        settled = np.abs(following - times) <= 2 * np.spacing(np.abs(times))
        times = following
        if settled.all():
            break
    return np.asarray(times)
