"""Guaranteed maxima of functions of time over windows: quasi-polynomials, linear motions.

On a cell a function g lies below its cubic Hermite interpolant by its values and slopes at both
ends, plus M h^4/144 of the middle Bernstein polynomial where |g''''| <= M (`upper_bounds`). Cells
whose bound exceeds the largest value that is known are split, so nothing hides between two samples.

A function along a phase is a `QuasiPolynomial` where the modes of its configuration are known.
Kernels of damped and forced orbits give the motion's field alone: it is one `AlongMotion` there.
The compiled search of kernels takes such cells too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.first_crossing import first_crossing
from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT

__all__ = [
    "AlongMotion",
    "Cells",
    "CurveSamples",
    "LinearMotion",
    "Maximum",
    "falling_zeros",
    "largest",
    "maximum",
    "upper_bounds",
]

_CELL = 0.6  # radians of the fastest motion, or |A| h of a step
_ROUNDING = 2.0**-47  # of a sum, relative to its absolute values
_DEGREE = 16  # of Taylor's polynomial over a step: the rest is below 0.6^17/17! of the whole
_SWEEPS = 3  # of balancing
_POLISHING = 60  # steps of Newton's method, or of bisection where it leaves its bracket

_Jet = Callable[[float], tuple[float, float, float]]  # value, slope and curvature at a time


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
    jets: Callable[[int], _Jet]  # for a cell, the function at times inside it


def largest(cells: Cells, slack: float, floor: float) -> Maximum:
    """The maximum of a function over all cells, or the floor where it does not exceed that.

    Cells are split until a bound on the function over each is at most `slack` above the maximum;
    after far too many splits that bound, which is safe but not attained, becomes the maximum. The
    time is NaN where the floor is the value.
    """
    grid, excess, jets = cells
    count = len(excess)
    best = max(
        Maximum(floor, math.nan),
        Maximum(*(float(part[np.argmax(grid.value)]) for part in grid[:2])),
        key=itemgetter(0),
    )
    upper = upper_bounds(
        CurveSamples(*(part[:-1] for part in grid)),
        CurveSamples(*(part[1:] for part in grid)),
        excess,
    )
    splits = 0
    for cell in np.flatnonzero(upper > best.value + slack)[::-1].tolist():
        jet = jets(cell)
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


def maximum(
    function: QuasiPolynomial | AlongMotion, duration: float, floor: float = -math.inf
) -> Maximum:
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
    if isinstance(function, AlongMotion):
        return largest(function.cells(), function.rounding(duration) / 4, floor)
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
    return largest(cells, error / 4, -math.inf)


def _cells(function: QuasiPolynomial, first: float, last: float) -> tuple[Cells, float]:
    """A quasi-polynomial on cells between two times, and the error of its values."""
    count = 1 + int(function.fastest * (last - first) / _CELL)
    times, width = np.linspace(first, last, count + 1), (last - first) / count
    values, slopes, _, errors = np.array([function.jet(t) for t in times.tolist()]).T
    bends = np.array([function.bound(4, t, width) for t in times[:-1].tolist()])
    if not np.isfinite([values.sum(), slopes.sum(), errors.sum(), bends.sum()]).all():
        raise OverflowError
    samples = CurveSamples(values, times, slopes)
    cells = Cells(samples, bends * width**4 / 144, lambda _: lambda t: function.jet(t)[:3])
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


class _Steps(NamedTuple):
    """States and rates (k + 1, n) at the ends of k steps, and |y| of the largest state."""

    width: float
    states: np.ndarray
    rates: np.ndarray
    size: float


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """A motion y' = A y + b over a time, cut into steps that are short against A.

    The rate y' grows by e^(|A| h) at most over a step h, in a norm with weights that balance A: so
    a bound on its derivatives holds all through the step.
    """

    field: np.ndarray  # A and b, (n, n + 1)
    start: np.ndarray  # (n,)
    duration: float  # nondimensional

    @cached_property
    def weights(self) -> np.ndarray:
        """Weights x of the norm |y| = max |y_i|/x_i, by Osborne's balancing (1960).

        What drives and is not driven, or the reverse, is balanced against the duration.
        """
        sizes = abs(self.field[:, :-1])
        least = 1 / self.duration if self.duration > 0 else 1.0
        x = np.ones(len(sizes))
        with np.errstate(all="ignore"):
            for _ in range(_SWEEPS):
                for i in range(len(x)):
                    row = (sizes[i] @ x - sizes[i, i] * x[i]) / x[i]
                    column = (sizes[:, i] @ (1 / x) - sizes[i, i] / x[i]) * x[i]
                    x[i] *= math.sqrt((max(row, 0.0) + least) / (max(column, 0.0) + least))
        return x

    @cached_property
    def norm(self) -> float:
        """Norm of A that the norm of y induces."""
        with np.errstate(all="ignore"):
            return float((abs(self.field[:, :-1]) @ self.weights / self.weights).max())

    @cached_property
    def steps(self) -> _Steps:
        """The motion in steps that are short against A.

        An `InputError` refuses a motion that is longer than 1e5 / |A|, has a negative duration,
        or overflows.
        """
        if not (self.duration >= 0 and self.duration * self.norm <= LONGEST_WAIT):
            raise InputError(f"the duration {self.duration} is not within 0 and 1e5 / |A|")
        count = 1 + int(self.duration * self.norm / _CELL)
        width = self.duration / count
        one = np.eye(len(self.start))
        total = one
        for k in range(_DEGREE, 1, -1):
            total = one + (width / k) * self.field[:, :-1] @ total
        states = np.empty((count + 1, len(one)))
        states[0] = self.start
        with np.errstate(all="ignore"):
            for k in range(count):
                states[k + 1] = states[k] + width * total @ self.rate(states[k])
            size = float((abs(states) / self.weights).max())
        if not size < 1e290:
            raise InputError("the motion overflows")
        rates = states @ self.field[:, :-1].T + self.field[:, -1]
        return _Steps(width, states, rates, size)

    def rate(self, state: np.ndarray) -> np.ndarray:
        """The rate y' (n,) at a state (n,)."""
        return np.asarray(self.field[:, :-1] @ state + self.field[:, -1])


@dataclass(frozen=True)
class AlongMotion:
    """A boundary function g = n y + c along a linear motion.

    Examples
    --------
    >>> motion = LinearMotion(np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]), np.eye(2)[1], 3.0)
    >>> round(maximum(AlongMotion(motion, np.eye(2)[0], 0.5), 3.0).value, 12)
    1.5
    """

    motion: LinearMotion
    normal: np.ndarray  # n, (n,)
    constant: float  # c

    @property
    def fastest(self) -> float:
        """The norm of A."""
        return self.motion.norm

    def __call__(self, t: float) -> float:
        """Return g(t) for a time within the motion's."""
        steps = self.motion.steps
        cell = min(int(t / steps.width), len(steps.states) - 2) if steps.width > 0 else 0
        return self._jet(cell)(t)[0]

    def raised(self, by: float) -> AlongMotion:
        """The function g plus a constant."""
        return replace(self, constant=self.constant + by)

    def rounding(self, duration: float) -> float:
        """The rounding error 32 eps (|c| + |n| x |y|)(1 + |A| T) of g over [0, T].

        x are the `weights`.
        """
        motion = self.motion
        size = float(abs(self.normal) @ motion.weights) * motion.steps.size + abs(self.constant)
        return _ROUNDING * size * (1 + motion.norm * duration)

    def rises(self, noise: float) -> bool:
        """Whether g rises at 0 beyond the error of its slope, where g itself errs by noise."""
        motion = self.motion
        parts = abs(motion.field) @ np.append(abs(motion.start), 1.0)
        size = float(abs(self.normal) @ parts)
        return bool(
            self.normal @ motion.rate(motion.start) > _ROUNDING * size + motion.norm * noise
        )

    def cells(self) -> Cells:
        """The function g on the steps of the motion."""
        motion, steps = self.motion, self.motion.steps
        matrix = motion.field[:, :-1]
        bend = float(abs(self.normal @ matrix @ matrix @ matrix) @ motion.weights)
        sizes = (abs(steps.rates[:-1]) / motion.weights).max(axis=1)
        time = np.linspace(0.0, motion.duration, len(steps.states))
        return Cells(
            CurveSamples(
                steps.states @ self.normal + self.constant, time, steps.rates @ self.normal
            ),
            math.exp(_CELL) * bend * sizes * steps.width**4 / 144,
            self._jet,
        )

    def _jet(self, cell: int) -> _Jet:
        """The function from a time within a step to g, g' and g'', by Taylor's polynomial."""
        steps, matrix = self.motion.steps, self.motion.field[:, :-1]
        coefficients = [float(self.normal @ steps.states[cell]) + self.constant]
        now = steps.rates[cell]
        for k in range(1, _DEGREE + 1):
            coefficients.append(float(self.normal @ now) / k)
            now = matrix @ now / k
        origin = self.motion.duration * cell / (len(steps.states) - 1)

        def jet(time: float) -> tuple[float, float, float]:
            value = slope = curvature = 0.0
            for coefficient in reversed(coefficients):
                curvature = curvature * (time - origin) + 2 * slope
                slope = slope * (time - origin) + value
                value = value * (time - origin) + coefficient
            return value, slope, curvature

        return jet
