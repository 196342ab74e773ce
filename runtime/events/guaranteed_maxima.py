"""Guaranteed maxima of functions of time over windows: trigonometric sums, linear motions.

On a cell a function g lies below its cubic Hermite interpolant by its values and slopes at both
ends, plus M h^4/144 of the middle Bernstein polynomial where |g''''| <= M (`upper_bounds`). Cells
whose bound exceeds the largest value that is known are split, so nothing hides between two samples.

Derived kernels ask for these maxima, of functions along phases: where nothing is damped or forced
that is a `TrigonometricSum`, else one `AlongMotion` of the states. The compiled search does the
same.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from operator import itemgetter
from typing import Any, NamedTuple, Self

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT

__all__ = [
    "AlongMotion",
    "BoundaryCurve",
    "Cells",
    "CurveSamples",
    "LinearMotion",
    "Maximum",
    "TrigonometricSum",
    "falling_zeros",
    "largest",
    "largest_between",
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


class BoundaryCurve(ABC):
    """A boundary function along a phase, which begins at the time 0; times are nondimensional."""

    @property
    @abstractmethod
    def fastest(self) -> float:
        """Bound on its frequency."""

    @abstractmethod
    def __call__(self, t: float) -> float:
        """Value at a time."""

    @abstractmethod
    def raised(self, by: float) -> Self:
        """The function plus a constant."""

    @abstractmethod
    def rounding(self, duration: float) -> float:
        """Rounding error of its values and maxima over [0, duration]."""

    @abstractmethod
    def rises(self, noise: float) -> bool:
        """Whether it rises at 0 beyond the error of its slope, where it itself errs by noise."""

    @abstractmethod
    def cells(self, duration: float) -> Cells:
        """The function on cells of [0, duration].

        `InputError` refuses a duration that is negative or longer than 1e5 / `fastest`, and a
        function that overflows.
        """

    def maximum(self, duration: float, floor: float = -math.inf) -> Maximum:
        """The guaranteed maximum over [0, duration], or the floor.

        That is max(floor, max g) and the time where it is attained; where g stays at or below the
        floor, the floor and NaN. A floor of -inf asks for the global maximum. No value of g
        exceeds it by more than ``rounding(duration)``. `InputError` refuses a floor of NaN, and
        what `cells` refuses.

        Examples
        --------
        >>> TrigonometricSum(0.0, 0.0, (1.0,), (0.0,), (2.0,)).maximum(4.0)
        Maximum(value=1.0, time=0.0)
        """
        if math.isnan(floor):
            raise InputError("the floor must be a number, not NaN")
        return largest(self.cells(duration), self.rounding(duration) / 4, floor)


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


def largest_between(function: QuasiPolynomial, first: float, last: float) -> Maximum:
    """The guaranteed maximum of a quasi-polynomial between two times."""
    count = 1 + int(function.fastest * (last - first) / _CELL)
    times, width = np.linspace(first, last, count + 1), (last - first) / count
    values, slopes, _, errors = np.array([function.jet(t) for t in times.tolist()]).T
    bends = np.array([function.bound(4, t, width) for t in times[:-1].tolist()])
    cells = Cells(
        CurveSamples(values, times, slopes),
        bends * width**4 / 144,
        lambda _: lambda t: function.jet(t)[:3],
    )
    return largest(cells, float(errors.max()) / 4, -math.inf)


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


@dataclass(frozen=True)
class TrigonometricSum(BoundaryCurve):
    """A boundary function a0 + a1 t + sum_j [c_j cos(w_j t) + s_j sin(w_j t)].

    Closed bounds on its derivatives hold at all times. An `InputError` refuses tuples that differ
    in length, numbers that are not finite and negative frequencies.
    """

    constant: float  # a0
    slope: float  # a1
    cosine: tuple[float, ...]  # amplitudes c_j, (n,)
    sine: tuple[float, ...]  # amplitudes s_j, (n,)
    frequency: tuple[float, ...]  # angular frequencies w_j >= 0, (n,)

    def __post_init__(self) -> None:
        if not len(self.cosine) == len(self.sine) == len(self.frequency):
            raise InputError("cosine, sine and frequency must have equal lengths")
        numbers = (self.constant, self.slope, *self.cosine, *self.sine, *self.frequency)
        if not all(map(math.isfinite, numbers)) or min(self.frequency, default=0.0) < 0:
            raise InputError("the coefficients must be finite, the frequencies also not negative")

    def __call__(self, t: Any) -> Any:
        """Return g(t) for a time or an array of times of any shape."""
        cos, sin = (np.cos, np.sin) if isinstance(t, np.ndarray) else (math.cos, math.sin)
        value = self.constant + self.slope * t
        for c, s, w in self.terms():
            value = value + (c * cos(w * t) + s * sin(w * t))
        return value

    def derivative(self) -> TrigonometricSum:
        """Return g' as a sum of the same kind."""
        cosine = tuple(s * w for _, s, w in self.terms())
        sine = tuple(-c * w for c, _, w in self.terms())
        return TrigonometricSum(self.slope, 0.0, cosine, sine, self.frequency)

    def raised(self, by: float) -> Self:
        """The function g plus a constant."""
        return replace(self, constant=self.constant + by)

    def rounding(self, duration: float) -> float:
        """The rounding error 32 eps (|a0| + |a1| T + sum (|c| + |s|)(1 + w T)) of g over [0, T].

        Each product may underflow too.
        """
        waves = sum((abs(c) + abs(s)) * (1 + w * duration) for c, s, w in self.terms())
        relative = _ROUNDING * (abs(self.constant) + abs(self.slope) * duration + waves)
        return relative + (1 + 2 * len(self.frequency)) * math.ulp(0.0)

    def rises(self, noise: float) -> bool:
        """Whether g rises at 0 beyond the error of its slope, where g itself errs by noise."""
        slope = self.slope + sum(s * w for _, s, w in self.terms())
        size = abs(self.slope) + sum((abs(c) + abs(s)) * w for c, s, w in self.terms())
        return slope > _ROUNDING * size + self.fastest * noise

    @property
    def fastest(self) -> float:
        """Largest angular frequency."""
        return max(self.frequency, default=0.0)

    def cells(self, duration: float) -> Cells:
        """The function g on cells of 0.6 radians of the largest frequency, or less."""
        phase = duration * self.fastest
        if not (duration >= 0 and phase <= LONGEST_WAIT and self.rounding(duration) < 1e290):
            raise InputError(
                f"the duration {duration} is not within 0 and 1e5 / max w, or g overflows"
            )
        count = 1 + int(phase / _CELL)
        width = duration / count
        excess = sum((abs(c) + abs(s)) * (w * width) ** 4 for c, s, w in self.terms()) / 144
        slope = self.derivative()
        curvature = slope.derivative()
        time = np.linspace(0.0, duration, count + 1)
        return Cells(
            CurveSamples(self(time), time, slope(time)),
            np.full(count, excess),
            lambda _: lambda t: (self(t), slope(t), curvature(t)),
        )

    def terms(self) -> Iterator[tuple[float, float, float]]:
        """Amplitudes and frequency (c_j, s_j, w_j) of each term."""
        return zip(self.cosine, self.sine, self.frequency, strict=True)


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
class AlongMotion(BoundaryCurve):
    """A boundary function g = n y + c along a linear motion.

    Examples
    --------
    >>> motion = LinearMotion(np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]), np.eye(2)[1], 3.0)
    >>> round(AlongMotion(motion, np.eye(2)[0], 0.5).maximum(3.0).value, 12)
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

    def raised(self, by: float) -> Self:
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

    def cells(self, duration: float) -> Cells:
        """The function g on the steps of the motion, whose duration is the one that is meant."""
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
