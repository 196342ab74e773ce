"""Guaranteed maxima of affine functions of the state along any linear motion.

A phase is y' = A y + b from a state at its start, and a boundary function along it is
g(t) = n y(t) + c. The phase is cut into steps that are short against A; the rate y' grows by
e^(|A| h) at most over a step h, in a norm with weights that balance A, and so a bound on g''''
holds all through it. The compiled search does the same.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple, Self

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.guaranteed_maxima import LONGEST_PHASE, CurveSamples, Maximum, largest

__all__ = ["AlongMotion", "LinearMotion"]

_STEP = 0.6  # |A| h of a step
_DEGREE = 16  # of Taylor's polynomial over a step: the rest is below 0.6^17/17! of the whole
_SWEEPS = 3  # of balancing


class _Steps(NamedTuple):
    """States and rates (k + 1, n) at the ends of k steps, and |y| of the largest state."""

    width: float
    states: np.ndarray
    rates: np.ndarray
    size: float


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """A motion y' = A y + b over a time."""

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
        if not (self.duration >= 0 and self.duration * self.norm <= LONGEST_PHASE):
            raise InputError(f"the duration {self.duration} is not within 0 and 1e5 / |A|")
        count = 1 + int(self.duration * self.norm / _STEP)
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
    """A boundary function g = n y + c along a linear motion; see `BoundaryCurve`."""

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

        x are the `weights`; T is the duration, nondimensional.
        """
        motion = self.motion
        size = float(abs(self.normal) @ motion.weights) * motion.steps.size + abs(self.constant)
        return 2.0**-47 * size * (1 + motion.norm * duration)

    def rises(self, noise: float) -> bool:
        """Whether g rises at 0 beyond the error of its slope, where g itself errs by noise."""
        motion = self.motion
        parts = abs(motion.field) @ np.append(abs(motion.start), 1.0)
        size = float(abs(self.normal) @ parts)
        return bool(self.normal @ motion.rate(motion.start) > 2.0**-47 * size + motion.norm * noise)

    def maximum(self, duration: float, floor: float = -math.inf) -> Maximum:
        """The guaranteed maximum of g over the motion's duration, or the floor.

        That is max(floor, max g) and the time where it is attained; where g stays at or below the
        floor, the floor and NaN. A floor of -inf asks for the global maximum. No value of g
        exceeds it by more than ``rounding(duration)``; the duration is that of the motion. An
        `InputError` refuses a floor of NaN, and a motion that has no guarantee.

        Examples
        --------
        >>> motion = LinearMotion(np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]), np.eye(2)[1], 3.0)
        >>> round(AlongMotion(motion, np.eye(2)[0], 0.5).maximum(3.0).value, 12)
        1.5
        """
        if math.isnan(floor):
            raise InputError("the floor must be a number, not NaN")
        motion, steps = self.motion, self.motion.steps
        matrix = motion.field[:, :-1]
        bend = float(abs(self.normal @ matrix @ matrix @ matrix) @ motion.weights)
        sizes = (abs(steps.rates[:-1]) / motion.weights).max(axis=1)
        time = np.linspace(0.0, motion.duration, len(steps.states))
        return largest(
            CurveSamples(
                steps.states @ self.normal + self.constant, time, steps.rates @ self.normal
            ),
            math.exp(_STEP) * bend * sizes * steps.width**4 / 144,
            self._jet,
            self.rounding(duration) / 4,
            floor,
        )

    def _jet(self, cell: int) -> Callable[[float], tuple[float, float, float]]:
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
