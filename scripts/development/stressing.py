"""Sums of t^k e^(st) cos(wt) and t^k e^(st) sin(wt): where they are proved not to exceed zero.

Independent of the engines' own searches: cells of dense samples in NumPy, and balls where
NumPy cannot tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

EPS = float(np.finfo(float).eps)

Shape = tuple[tuple[int, bool], ...]  # of each mode the number of powers, and whether it oscillates


@dataclass(frozen=True)
class Sums:
    """Many sums of one shape, as functions of time."""

    shape: Shape
    exponents: np.ndarray  # (count, modes, 2): rate and frequency
    values: np.ndarray  # (count, functions): coefficients, in the order of the engine's functions

    def take(self, places: np.ndarray) -> Sums:
        """The sums at some places."""
        return Sums(self.shape, self.exponents[places], self.values[places])

    @property
    def fastest(self) -> np.ndarray:
        """Largest absolute value (count,) of an exponent of each sum."""
        return np.asarray(np.hypot(*np.moveaxis(self.exponents, 2, 0)).max(axis=1))

    def derivative(self) -> Sums:
        """The derivatives of the sums by time."""
        result, first = np.zeros_like(self.values), 0
        for m, (length, oscillates) in enumerate(self.shape):
            rate, frequency = self.exponents[:, m].T
            step = 1 + oscillates
            for k in range(length):
                f = first + k * step
                for part in range(step):
                    result[:, f + part] = rate * self.values[:, f + part]
                    if k + 1 < length:
                        result[:, f + part] += (k + 1) * self.values[:, f + part + step]
                if oscillates:
                    result[:, f] += frequency * self.values[:, f + 1]
                    result[:, f + 1] -= frequency * self.values[:, f]
            first += length * step
        return Sums(self.shape, self.exponents, result)

    def at(self, times: np.ndarray) -> np.ndarray:
        """Values (count, ...) at times (count, ...)."""
        total, first = np.zeros(times.shape), 0
        wide = (slice(None), *[None] * (times.ndim - 1))
        for m, (length, oscillates) in enumerate(self.shape):
            rate, frequency = self.exponents[:, m].T
            wave = np.exp(rate[wide] * times)
            angle = frequency[wide] * times if oscillates else None
            cosine = wave if angle is None else wave * np.cos(angle)
            sine = None if angle is None else wave * np.sin(angle)
            for _ in range(length):
                total += self.values[:, first][wide] * cosine
                first += 1
                if sine is not None:
                    total += self.values[:, first][wide] * sine
                    first += 1
                    sine = sine * times
                cosine = cosine * times
        return total

    def bound(self, low: np.ndarray, high: np.ndarray) -> np.ndarray:
        """Bounds of the sums' absolute values between two times each."""
        total, first = np.zeros(high.shape), 0
        wide = (slice(None), *[None] * (high.ndim - 1))
        for m, (length, oscillates) in enumerate(self.shape):
            rate = self.exponents[:, m, 0][wide]
            growth = np.exp(np.where(rate > 0, rate * high, rate * low))
            for k in range(length):
                size = np.abs(self.values[:, first])
                if oscillates:
                    size = np.hypot(size, self.values[:, first + 1])
                total += size[wide] * growth * high**k
                first += 1 + oscillates
        return total


def undecided(
    sums: Sums, ends: np.ndarray, allowed: np.ndarray, samples: int, rounds: int = 5
) -> np.ndarray:
    """Cells (n, 3) of index, begin and end in which sums may exceed what is allowed.

    Everywhere else between 0 and `ends` they do not: quartic Bernstein bounds of dense
    cells.
    """
    slope = sums.derivative()
    fourth = slope.derivative().derivative().derivative()
    index = np.repeat(np.arange(len(ends)), samples)
    cells = np.arange(samples) / samples
    low = (ends[:, None] * cells).ravel()
    high = (ends[:, None] * (cells + 1.0 / samples)).ravel()
    for _ in range(rounds):
        part, rate, top = sums.take(index), slope.take(index), fourth.take(index)
        h = high - low
        left, right = part.at(low), part.at(high)
        rise, fall = rate.at(low) * h, rate.at(high) * h
        middle = (left + right) / 2 + (rise - fall) / 6 + top.bound(low, high) * h**4 / 144
        largest = np.max([left, left + rise / 4, middle, right - fall / 4, right], axis=0)
        error = (8 + part.fastest * high) * EPS * part.bound(low, high)
        open_ = ~(largest + np.minimum(error, 0.5 * allowed[index]) <= allowed[index])
        index, low, high, h = index[open_], low[open_], high[open_], h[open_]
        pieces = 8
        offset = np.arange(pieces) / pieces
        index = np.repeat(index, pieces)
        begin = (low[:, None] + h[:, None] * offset).ravel()
        end = (low[:, None] + h[:, None] * (offset + 1 / pieces)).ravel()
        low, high = begin, end
        if not len(index):
            break
    return np.stack([index, low, high], axis=1)


class Ball:
    """One sum in ball arithmetic, its doubles taken as exact."""

    def __init__(
        self, shape: Shape, exponents: np.ndarray, values: Sequence[Any] | np.ndarray
    ) -> None:
        from flint import arb

        self.shape = shape
        self.exponents = [(arb(float(s)), arb(float(w))) for s, w in exponents]
        self.values = [x if isinstance(x, arb) else arb(float(x)) for x in values]

    def derivative(self) -> Ball:
        """The derivative."""
        result = Ball(self.shape, np.zeros((0, 2)), [0.0] * len(self.values))
        result.exponents, first = self.exponents, 0
        for (length, oscillates), (rate, frequency) in zip(self.shape, self.exponents, strict=True):
            step = 1 + oscillates
            for k in range(length):
                f = first + k * step
                for part in range(step):
                    total = rate * self.values[f + part]
                    if k + 1 < length:
                        total += (k + 1) * self.values[f + part + step]
                    if oscillates:
                        turned = frequency * self.values[f + 1 - part]
                        total += -turned if part else turned
                    result.values[f + part] = total
            first += length * step
        return result

    def at(self, time: Any) -> Any:
        """Value at a ball of times."""
        total, place = 0 * time, 0
        for (length, oscillates), (rate, frequency) in zip(self.shape, self.exponents, strict=True):
            growth = (rate * time).exp()
            angle = frequency * time
            cosine, sine = (angle.cos(), angle.sin()) if oscillates else (1, 0)
            for k in range(length):
                power = growth * time**k
                total += self.values[place] * power * cosine
                place += 1
                if oscillates:
                    total += self.values[place] * power * sine
                    place += 1
        return total


def first_excess(ball: Ball, low: float, high: float, allowed: float) -> float | None:
    """A time in [low, high] at which a sum exceeds `allowed`; None is a proof that none does.

    RuntimeError says that neither is decided.
    """
    from flint import arb

    slope = ball.derivative()
    curve = slope.derivative()
    waiting = [(low, high)]
    for _ in range(100_000):
        if not waiting:
            return None
        a, b = waiting.pop()
        half = (arb(b) - arb(a)) / 2
        middle, step = arb(a) + half, arb(0, half.upper())
        value = ball.at(middle)
        whole = value + slope.at(middle) * step
        whole += curve.at(middle + step) * arb(0, (half * half / 2).upper())
        if whole <= allowed:
            continue
        if value > allowed:
            return float(middle.mid())
        centre = 0.5 * (a + b)
        if not a < centre < b:
            raise RuntimeError("balls cannot tell")
        waiting += [(centre, b), (a, centre)]
    raise RuntimeError("balls cannot tell")
