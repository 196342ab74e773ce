"""Guaranteed maxima of functions of time over windows.

On a cell a function g lies below its cubic Hermite interpolant by its values and slopes at both
ends, plus M h^4/144 of the middle Bernstein polynomial where |g''''| <= M (`upper_bounds`). Cells
whose bound exceeds the largest value that is known are split, so nothing hides between two samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.first_crossing import first_crossing
from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT

__all__ = [
    "Cells",
    "CurveSamples",
    "Maximum",
    "falling_zeros",
    "largest",
    "maximum",
    "upper_bounds",
]

_CELL = 0.6  # radians of the fastest motion
_POLISHING = 60  # steps of Newton's method, or of bisection where it leaves its bracket


class Maximum(NamedTuple):
    """The maximum of a boundary function and the time at which it is attained."""

    value: float
    time: float


class CurveSamples(NamedTuple):
    """Values, times and slopes of a function, numbers or arrays."""

    value: Any
    time: Any
    slope: Any


class Cells(NamedTuple):
    """A function on k cells of equal width h."""

    grid: CurveSamples  # at their k + 1 ends
    excess: np.ndarray  # (k,), M h^4/144 with M a bound on the fourth derivative inside the cell
    jet: Callable[[float], tuple[float, float, float]]  # value, slope and curvature at a time


def largest(cells: Cells, slack: float) -> Maximum:
    """The maximum of a function over all cells.

    Cells are split until a bound on the function over each is at most `slack` above the maximum;
    after far too many splits that bound, which is safe but not attained, becomes the maximum.
    """
    grid, excess, jet = cells
    count = len(excess)
    best = Maximum(*(float(part[np.argmax(grid.value)]) for part in grid[:2]))
    upper = upper_bounds(
        CurveSamples(*(part[:-1] for part in grid)),
        CurveSamples(*(part[1:] for part in grid)),
        excess,
    )
    splits = 0
    for cell in np.flatnonzero(upper > best.value + slack)[::-1].tolist():
        left, right = (CurveSamples(*(float(part[i]) for part in grid)) for i in (cell, cell + 1))
        full, waiting = right.time - left.time, [(left, right, False)]
        while waiting:
            left, right, polished = waiting.pop()
            bend = float(excess[cell]) * ((right.time - left.time) / full) ** 4
            most = upper_bounds(left, right, bend)
            if most <= best.value + slack:
                continue
            middle = 0.5 * (left.time + right.time)
            if splits == 8192 * count:  # far more than any function needs
                best = Maximum(float(most), middle)  # not attained, but safe
                continue
            # At a maximum both halves go at once; every second split bisects, lest Newton fail.
            polished = not polished and left.slope > 0 > right.slope
            for _ in range(8 if polished else 0):
                _, slope, curvature = jet(middle)
                middle = min(max(middle - slope / (curvature or math.inf), left.time), right.time)
            value, slope, _ = jet(middle)
            split = CurveSamples(value, middle, slope)
            best = max(best, Maximum(value, middle), key=itemgetter(0))
            waiting += [(split, right, polished), (left, split, polished)]
            splits += 1
    return best


def maximum(function: QuasiPolynomial, duration: float, floor: float = -math.inf) -> Maximum:
    """The guaranteed maximum of a boundary function over [0, duration], or the floor.

    It comes with the time where it is attained; where g does not rise above the floor it is the
    floor, with NaN. A floor of -inf asks for the global maximum. No value of g exceeds it by more
    than twice ``function.rounding(duration)``. `InputError` refuses a floor of NaN, a duration
    that is negative or longer than 1e5 / ``function.fastest``, and a function that overflows.

    Examples
    --------
    >>> from nonsmooth.runtime.events.quasi_polynomials import plain_functions
    >>> wave = QuasiPolynomial(plain_functions([0j, 2j], [1, 1]), (0j, 1 + 0j), (0.0, 1.0))
    >>> maximum(wave, 4.0)
    Maximum(value=1.0, time=0.0)
    """
    if math.isnan(floor):
        raise InputError("the floor must be a number, not NaN")
    if not (duration >= 0 and duration * function.fastest <= LONGEST_WAIT):
        raise InputError(f"the duration {duration} is not within 0 and 1e5 / max |lambda|")
    try:
        first: float | None = 0.0
        if floor > -math.inf:
            first = first_crossing(function.raised(-floor), duration).time
        if first is None:
            return Maximum(floor, math.nan)
        cells, error = _cells(function, first, duration)
    except OverflowError:
        raise InputError("the function overflows") from None
    return largest(cells, error / 4)


def _cells(function: QuasiPolynomial, first: float, last: float) -> tuple[Cells, float]:
    """A quasi-polynomial on cells between two times, and the error of its values."""
    count = 1 + int(function.fastest * (last - first) / _CELL)
    times, width = np.linspace(first, last, count + 1), (last - first) / count
    values, slopes, _, errors = np.array([function.jet(t) for t in times.tolist()]).T
    bends = np.array([function.bound(4, t, width) for t in times[:-1].tolist()])
    if not np.isfinite([values.sum(), slopes.sum(), errors.sum(), bends.sum()]).all():
        raise OverflowError
    samples = CurveSamples(values, times, slopes)
    cells = Cells(samples, bends * width**4 / 144, lambda t: function.jet(t)[:3])
    return cells, float(errors.max())


def upper_bounds(left: CurveSamples, right: CurveSamples, excess: Any) -> Any:
    """Upper bounds of g on cells, by its cubic Hermite interpolant in Bernstein form.

    It errs by at most M h^4/24 u^2 (1-u)^2 where |g''''| <= M: that is M h^4/144, the excess,
    times the middle Bernstein polynomial of degree 4.
    """
    width = right.time - left.time
    middle = 0.5 * (left.value + right.value) + width * (left.slope - right.slope) / 6 + excess
    first, last = left.value + 0.25 * width * left.slope, right.value - 0.25 * width * right.slope
    return np.maximum.reduce([left.value, first, middle, last, right.value])


def falling_zeros(
    rates: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]], low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    """Zeros (n,) of slopes that fall through zero between times, by Newton's method and bisection.

    `rates` gives slopes and curvatures (n,) at times (n,).
    """
    times = (low + high) / 2
    for _ in range(_POLISHING):
        slope, curvature = rates(times)
        low, high = np.where(slope > 0, times, low), np.where(slope > 0, high, times)
        with np.errstate(all="ignore"):
            newton = times - slope / curvature
        inside = (newton >= low) & (newton <= high)
        following = np.where(inside, newton, (low + high) / 2)
        settled = np.abs(following - times) <= 2 * np.spacing(np.abs(times))
        times = following
        if settled.all():
            break
    return np.asarray(times)
