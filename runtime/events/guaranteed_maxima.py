"""Guaranteed maxima of functions of time over windows.

On a cell a function g lies below its cubic Hermite interpolant by its values and slopes at both
ends, plus M h^4/144 of the middle Bernstein polynomial where |g''''| <= M (`_upper_bound`). Cells
whose bound exceeds the largest value that is known are split, so nothing hides between two samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.first_crossing import first_crossing
from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT

__all__ = [
    "Maximum",
    "falling_zeros",
    "largest",
    "maximum",
]

_CELL = 0.6  # radians of the fastest motion
_POLISHING = 60  # steps of Newton's method, or of bisection where it leaves its bracket


class Maximum(NamedTuple):
    """The maximum of a boundary function and the time at which it is attained."""

    value: float
    time: float


class _Sample(NamedTuple):
    value: float
    time: float
    slope: float


def largest(
    function: QuasiPolynomial, times: Sequence[float], slack: float | None = None
) -> Maximum:
    """The maximum of a function over cells whose ends are some times, in ascending order.

    Cells are split until a bound on the function over each is at most `slack` above the maximum, a
    quarter of its error if it is not told; after far too many splits that bound, which is safe but
    not attained, becomes the maximum. Raises OverflowError where the function is not finite.
    """
    jets = [function.jet(time) for time in times]
    slack = max(error for *_, error in jets) / 4 if slack is None else slack
    samples = [_Sample(jet[0], time, jet[1]) for time, jet in zip(times, jets, strict=True)]
    best, splits = Maximum(*max(samples, key=itemgetter(0))[:2]), 0
    waiting = [(*ends, False) for ends in pairwise(samples)]
    while waiting:
        left, right, polished = waiting.pop()
        most = _upper_bound(function, left, right)
        if most <= best.value + slack:
            continue
        if not math.isfinite(most):
            raise OverflowError
        middle = 0.5 * (left.time + right.time)
        if splits == 8192 * len(times):  # far more than any function needs
            best = Maximum(most, middle)  # not attained, but safe
            continue
        # At a maximum both halves go at once; every second split bisects, lest Newton fail.
        polished = not polished and left.slope > 0 > right.slope
        for _ in range(8 if polished else 0):
            _, slope, curvature, _ = function.jet(middle)
            middle = min(max(middle - slope / (curvature or math.inf), left.time), right.time)
        value, slope, *_ = function.jet(middle)
        split = _Sample(value, middle, slope)
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
        count = 1 + int(function.fastest * (duration - first) / _CELL)
        return largest(function, np.linspace(first, duration, count + 1).tolist())
    except OverflowError:
        raise InputError("the function overflows") from None


def _upper_bound(function: QuasiPolynomial, left: _Sample, right: _Sample) -> float:
    """Upper bound of g on a cell, by its cubic Hermite interpolant in Bernstein form.

    It errs by at most M h^4/24 u^2 (1-u)^2 where |g''''| <= M: that is M h^4/144, the excess,
    times the middle Bernstein polynomial of degree 4.
    """
    width = right.time - left.time
    excess = function.bound(4, left.time, width) * width**4 / 144
    middle = 0.5 * (left.value + right.value) + width * (left.slope - right.slope) / 6 + excess
    first, last = left.value + 0.25 * width * left.slope, right.value - 0.25 * width * right.slope
    return max(left.value, first, middle, last, right.value)


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
