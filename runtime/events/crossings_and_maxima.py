"""Where a quasi-polynomial first vanishes, and its maximum, with guarantees.

No step jumps over a crossing. A start at zero is judged by the first derivative that is nonzero
beyond its error, and left by its Taylor series; a maximum within rounding of zero is touched, not
crossed.

On a cell a function g lies below its cubic Hermite interpolant by its values and slopes at both
ends, plus M h^4/144 of the middle Bernstein polynomial where |g''''| <= M (`_upper_bound`). Cells
whose bound exceeds the largest value that is known are split, so nothing hides between two samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import islice, pairwise
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.leading_derivative import UNIT, leading
from nonsmooth.runtime.events.quasi_polynomials import TINY, Jet, QuasiPolynomial
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, ORDERS

_INVERSE_FACTORIALS = tuple(1 / math.factorial(k) for k in range(ORDERS + 2))
_MOST_STEPS = 2_000_000  # a window of LONGEST_WAIT takes some of them for each radian
_CHECKED_EVERY = 16  # steps between two attempts to prove that nothing can follow
_POLISHING = 60  # steps of Newton's method, or of bisection where it leaves its bracket
_CELL = 0.6  # radians of the fastest motion


class Series:
    """Taylor series of g at 0, a root of given order: errors stay relative to g.

    The derivatives of order below `order` are zero. `values` and `sizes` are the derivatives
    at 0 from order 0 on, and the size that rounds in each. The series serves for one radian
    of `fastest`. Times are in the system's unit.
    """

    def __init__(
        self, order: int, values: Sequence[float], sizes: Sequence[float], fastest: float
    ) -> None:
        self.order, self.lead = order, values[order]
        self.radius = 1.0 / fastest if fastest else math.inf
        count = len(values)
        scaled = [v * f for v, f in zip(values, _INVERSE_FACTORIALS, strict=False)]
        self._value = [*scaled[:order:-1], scaled[order]]
        first = [k * scaled[k] for k in range(max(order, 1), count)]
        self._slope = first[::-1]
        self._curvature = [k * (k - 1) * scaled[k] for k in range(max(order, 2), count)][::-1]
        # A quarter of what judges a start still covers these few roundings, and a leading
        # derivative just above the whole of it can leave the boundary.
        self._error = [UNIT / 4 * s * f for s, f in zip(sizes, _INVERSE_FACTORIALS, strict=False)][
            : order - 1 if order else None : -1
        ]

    @classmethod
    def of(cls, function: QuasiPolynomial, order: int) -> Series:
        """The series of a function from its own derivatives."""
        values, errors = zip(*islice(function.taylor(), ORDERS), strict=True)
        return cls(order, values, [error / UNIT for error in errors], function.fastest)

    def bend(self, t: float) -> float:
        """Bound on |g''| over [0, t] with t >= 0: small near a root of high order."""
        total = 0.0
        for c in self._curvature:
            total = total * t + abs(c)
        return total * float(t ** max(self.order - 2, 0)) * (1 + 2.0**-20)

    def jet(self, t: float) -> Jet:
        """Values of g, g' and g'' at t >= 0, and the error of g."""
        value = slope = curvature = error = 0.0
        for c in self._value:
            value = value * t + c
        for c in self._slope:
            slope = slope * t + c
        for c in self._curvature:
            curvature = curvature * t + c
        for c in self._error:
            error = error * t + c
        order = self.order
        power = t**order
        if order:
            slope *= t ** (order - 1)
        curvature *= t ** max(order - 2, 0)
        return value * power, slope, curvature, error * power + TINY


class Start(NamedTuple):
    """How g starts: its sign just after 0."""

    sign: int  # 0 where g stays zero
    series: Series | None  # where g becomes negative from zero; else None
    beyond: bool = False  # whether g is positive at 0 already

    @classmethod
    def of(cls, function: QuasiPolynomial) -> Start:
        """Judge g by its first derivative that is nonzero beyond its error."""
        enough = sum(2 * (part.end - part.first) for part in function.parts)

        def sign(_: int, found: tuple[float, float]) -> int:
            value, error = found
            return 0 if not abs(value) > error else 1 if value > 0 else -1

        found = leading(islice(function.taylor(), enough), sign)
        if found is None:
            return cls(0, None)
        if found.sign > 0:
            return cls(1, None, found.order == 0)
        return cls(-1, Series.of(function, found.order) if found.order else None)


class Crossing(NamedTuple):
    """The first crossing of a window of time."""

    time: float | None  # None if there is none
    error: float = 0.0  # bound on the error of the time
    # time and depth of maxima within rounding of zero that were passed by
    touched: tuple[tuple[float, float], ...] = ()
    never: bool = False  # whether there is none after the window either


def first_crossing(
    function: QuasiPolynomial,
    window: float,
    *,
    reached: bool = False,
    start: Start | None = None,
) -> Crossing:
    """The first time in [0, window] at which g rises to zero.

    No step passes the first zero of g0 + g0' s + M s^2/2, where g'' <= M over the step, so
    none jumps a crossing. A start at zero is judged by its first derivative beyond its error;
    `start` is such a judgement made elsewhere. If `reached` is True, a maximum within rounding
    of zero counts. The window is in the system's unit of time, and at most LONGEST_WAIT /
    max |lambda|, which is inf for polynomials. Raises `InputError` for a negative or longer
    window, and OverflowError where g is not finite, or no step gets on.

    Examples
    --------
    >>> from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial, plain_functions
    >>> line = QuasiPolynomial(plain_functions([0j], [2]), (-1 + 0j, 1 + 0j), (1.0, 1.0))
    >>> first_crossing(line, 3.0).time
    1.0
    """
    fastest = function.fastest
    if not (window >= 0 and (not fastest or window <= LONGEST_WAIT / fastest * (1 + 1e-12))):
        raise InputError(f"the window {window} is not within 0 and {LONGEST_WAIT:g} / max |lambda|")
    start = start or Start.of(function)
    if start.sign >= 0:
        return Crossing(0.0) if start.sign > 0 else Crossing(None, never=True)
    return _Search(function, window, start.series, reached).run()


def _root(value: float, slope: float, curvature: float) -> float:
    """Smallest positive zero of value + slope s + curvature s^2/2, value < 0; inf if none."""
    if curvature <= 0:
        return -value / slope if slope > 0 else math.inf
    root = math.hypot(slope, math.sqrt(2 * curvature) * math.sqrt(-value))
    return -2 * value / (slope + root) if slope > 0 else (root - slope) / curvature


class _Search:
    """One search; its state is the time up to which g is known not to cross."""

    def __init__(
        self, function: QuasiPolynomial, window: float, series: Series | None, reached: bool
    ) -> None:
        self.function, self.series, self.reached = function, series, reached
        self.radius = series.radius if series else -1.0
        last = function.last_root()
        self.end, self.whole = min(window, last * 1.01), window > last * 1.01
        self.touched: list[tuple[float, float]] = []
        # a start that is left so slowly that g stays within its error is no touch
        self.before, self.left = 0.0, series is None
        self.top: tuple[float, float] | None = None

    def jet(self, t: float) -> Jet:
        if self.series is not None and t <= self.radius:
            found = self.series.jet(t)
        else:
            found = self.function.jet(t)
        if not math.isfinite(sum(found)):
            raise OverflowError(f"a boundary function is not finite at {t}")
        return found

    def none(self, never: bool) -> Crossing:
        return Crossing(None, touched=tuple(self.touched), never=never)

    def found(self, time: float, error: float) -> Crossing:
        if time > self.end:
            return self.none(False)
        return Crossing(time, error + 4 * math.ulp(time), tuple(self.touched))

    def leave(self, widest: float) -> float:
        """The time halfway to where the next derivative could first undo the leading one."""
        series = self.series
        if series is None:
            return 0.0
        length = min(widest, series.radius)
        bound = self.function.bound(series.order + 1, 0.0, length if length < math.inf else 0.0)
        if bound == 0:
            return length
        return min(0.5 * (series.order + 1) * -series.lead / bound, length)

    def run(self) -> Crossing:
        function, end = self.function, self.end
        widest = math.inf
        if function.uniform is None:
            widest = 1 / function.fastest if function.fastest else max(end / 4, 1e-300)
        length = widest
        t = min(self.leave(widest), end)
        for count in range(_MOST_STEPS):
            value, slope, curvature, error = self.jet(t)
            if count % _CHECKED_EVERY == 0 and function.ceiling(t) < -2 * error:
                return self.none(True)
            second = function.bound(2, t, length)
            third = function.bound(3, t, length)
            if value < -error:
                self.before = t
                self.left = self.left or value < -function.rounding(t)
                if self.top is not None:
                    depth, time = self.top
                    if self.reached:
                        return self.found(time, self._time_error(time))
                    self.touched.append((time, depth))
                    self.top = None
            elif value > 2 * error:
                return self._bisected(self.before, t)
            elif self.left and (self.top is None or value > self.top[0]):
                self.top = (value, t)
            if slope > 0:
                near = abs(value) + 2 * error
                step = 2 * near / slope
                bend = min(second, abs(curvature) + UNIT * second + third * step)
                # Kantorovich's condition: a root is certain, and Newton stays with it
                if step <= length and 2 * bend * near <= slope * slope:
                    return self._polished(t)
            if t >= end:
                return self.none(self.whole)
            if slope > 0 > curvature:
                passed = self._over_the_maximum(t, slope, curvature, second, third, length)
                if isinstance(passed, Crossing):
                    return passed
                if passed is not None:
                    t = passed
                    continue
            low = min(value, -error)
            step = min(_root(low, slope, second), length)
            wider = min(4 * step, length)
            local = curvature + UNIT * second + (third * wider if third else 0.0)
            if local < second:
                step = max(step, min(wider, _root(low, slope, local)))
            if step < 0.5 * t < 0.5 * self.radius and self.series is not None:
                wider = min(t, self.radius - t, length)
                step = max(step, min(wider, _root(low, slope, self.series.bend(t + wider))))
            t = min(t + max(step, 4 * math.ulp(t)), end)
            if t == math.inf:
                return self.none(True)
            if widest < math.inf:
                length = min(widest, 4 * max(step, math.ulp(t)))
        raise OverflowError(
            "no step gets on: a boundary function's numbers are too large, or small"
        )

    def _over_the_maximum(
        self, t: float, slope: float, bend: float, second: float, third: float, length: float
    ) -> Crossing | float | None:
        """The crossing before a maximum ahead of t, or a time beyond it that is safe to go to.

        None where g is not certainly concave up to a maximum ahead.
        """
        fall = -bend - UNIT * second
        reach = min(length, self.end - t, 0.5 * fall / third if third else math.inf)
        if fall <= 0 or 2 * slope >= fall * reach:
            return None
        low, high, time = t, t + reach, t
        for _ in range(100):
            value, rise, curvature, error = self.jet(time)
            if value > 2 * error:
                return self._bisected(t, time)
            low, high = (time, high) if rise > 0 else (low, time)
            newton = time - rise / curvature if curvature < 0 else low
            following = newton if low < newton < high else 0.5 * (low + high)
            if abs(following - time) <= 2 * math.ulp(time) or high - low <= 2 * math.ulp(high):
                break
            time = following
        if value >= -error and (self.top is None or value > self.top[0]):
            self.top = (value, time)
        if reach == math.inf:  # a parabola
            reach = 2 * (time - t) + math.sqrt(4 * error / fall)
        return t + reach

    def _time_error(self, time: float) -> float:
        """Error of the time of a maximum."""
        curvature = abs(self.jet(time)[2])
        error = self.function.derivative().rounding(time)
        return error / curvature if curvature > 0 else 0.0

    def _polished(self, t: float) -> Crossing:
        for _ in range(100):  # the distance to nearly a double root is halved each time
            value, slope, _, error = self.jet(t)
            if slope <= 0:
                break
            step = value / slope
            t = max(t - step, 0.0)
            if abs(step) <= math.ulp(t):
                break
        return self.found(t, error / slope if slope > 0 else 0.0)

    def _bisected(self, low: float, high: float) -> Crossing:
        widest = high - low
        while high - low > 2 * math.ulp(high):
            middle = 0.5 * (low + high)
            if self.jet(middle)[0] < 0:
                low = middle
            else:
                high = middle
        _, slope, _, error = self.jet(high)
        return self.found(high, min(widest, error / slope if slope > 0 else widest))


class Maximum(NamedTuple):
    """The maximum of a boundary function and the time at which it is attained."""

    value: float
    time: float


class _Sample(NamedTuple):
    value: float
    time: float
    slope: float


def _largest(function: QuasiPolynomial, times: Sequence[float]) -> Maximum:
    """The maximum of a function over cells whose ends are some times, in ascending order.

    Cells are split until a bound on the function over each is at most a quarter of its error above
    the maximum; after far too many splits that bound, which is safe but
    not attained, becomes the maximum. Raises OverflowError where the function is not finite.
    """
    jets = [function.jet(time) for time in times]
    slack = max(error for *_, error in jets) / 4
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
        return _largest(function, np.linspace(first, duration, count + 1).tolist())
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
