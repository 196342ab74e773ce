"""The flow of a linear field in double precision with bounds, at many times at once."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.float_sets import (
    ROUNDING,
    Floats,
    ManySets,
    Rounded,
    product,
    upward,
)

if TYPE_CHECKING:
    from flint import arb_mat

_TERMS = 16  # of Taylor's polynomial over a step


class Windows:
    """Linear functions over windows of time, as functions of the states at the start.

    In a window of length h, a function is value + s rate + s^2/2 curve at the time s after
    its middle, |s| <= h/2. `value`, `rate` and `curve` are `Rounded` (w j, n): the j
    functions in the first of w windows, then those in the next.
    """

    def __init__(self, value: Rounded, rate: Rounded, curve: Rounded, step: float) -> None:
        self.value, self.rate, self.curve, self.step = value, rate, curve, step

    def bounds(self, states: ManySets) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """Bounds (B, w j) of each function in each window, for B sets of states.

        They are the largest value in the window; the least and the largest rate; the least and
        the largest value at its end.
        """
        half = self.step / 2
        low, high = states.ranges(self.value)
        slow, fast = states.ranges(self.rate)
        bent, rising = states.ranges(self.curve)
        top = high + half * np.maximum(np.abs(slow), np.abs(fast))
        top = top + half * half / 2 * np.maximum(rising, 0.0)
        size = np.maximum(np.abs(bent), np.abs(rising))
        first = low + half * slow + half * half / 2 * bent
        last = high + half * fast + half * half / 2 * rising
        spare = ROUNDING * (np.abs(low) + np.abs(high) + np.abs(slow) + np.abs(fast) + size)
        return (
            top + spare,
            slow - half * size - spare,
            fast + half * size + spare,
            first - spare,
            last + spare,
        )


class FloatFlow:
    """The flow of z' = A z with A of balls, (n, n); the step of time is a power of 2."""

    def __init__(self, field: arb_mat, step: float) -> None:
        from flint import arb, arb_mat

        self.field, self.step = field, step
        size = field.nrows()
        self.size = size
        self.rate, self.curve = Rounded.of(field), Rounded.of(field * field)
        terms, term = [], arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
        for k in range(1, _TERMS + 1):
            terms.append(term)
            term = term * field / k
        self._terms = [Rounded.of(x) for x in terms]
        self._sizes = arb_mat([[abs(x) for x in row] for row in field.tolist()])
        around = arb(step)
        rest = (self._sizes * around).exp()
        power = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
        for k in range(1, _TERMS + 1):
            rest = rest - power
            power = power * self._sizes * around / k
        self._rest = Rounded.of(rest)
        self.at_step = cache(self._at_step)
        self._third = cache(self._third_over)

    def _at_step(self, number: int) -> Rounded:
        from flint import arb

        return Rounded.of((self.field * (arb(self.step) * number)).exp())

    def _third_over(self, exponent: int) -> Floats:
        """Bounds (n, n) of |A|^3 exp(|A| t) for |t| <= 2^exponent."""
        from flint import arb

        matrix = self._sizes**3 * (self._sizes * arb(2.0**exponent)).exp()
        bound = Rounded.of(matrix)
        found: Floats = upward(np.abs(bound.middle) + bound.radius)
        return found

    def windows(self, rows: arb_mat, numbers: range) -> Windows:
        """Linear functions with the rows (j, n) over the windows with these numbers.

        The window number k is from k to k + 1 steps.
        """
        from flint import arb

        values: list[Rounded] = []
        rates: list[Rounded] = []
        curves: list[Rounded] = []
        over = (self.field * arb(0, self.step / 2)).exp()
        rate = rows * self.field
        curve = rate * self.field * over
        for number in numbers:
            flow = (self.field * (arb(self.step) * (2 * number + 1) / 2)).exp()
            for found, row in ((values, rows), (rates, rate), (curves, curve)):
                found.append(Rounded.of(row * flow))

        def stacked(parts: list[Rounded]) -> Rounded:
            return Rounded(*(np.concatenate(x) for x in zip(*parts, strict=True)))

        return Windows(stacked(values), stacked(rates), stacked(curves), self.step)

    def at(self, times: Floats) -> Rounded:
        """Enclosures (B, n, n) of the flow at times (B,), which are not negative."""
        numbers = np.rint(times / self.step)
        left = times - numbers * self.step  # exact: the step is a power of 2
        powers = np.cumprod(
            np.concatenate([np.ones((len(left), 1)), np.repeat(left[:, None], _TERMS - 1, 1)], 1), 1
        )
        flat = [
            np.stack([x.reshape(-1) for x in parts]) for parts in zip(*self._terms, strict=True)
        ]
        size = np.abs(powers)
        middle = product(powers, flat[0])
        radius = product(size, flat[1] + ROUNDING * np.abs(flat[0]))
        radius = upward(radius + (np.abs(self._rest.middle) + self._rest.radius).reshape(-1))
        shape = (len(times), self.size, self.size)
        steps, place = np.unique(numbers, return_inverse=True)
        grid = [self.at_step(int(k)) for k in steps] or [self.at_step(0)]  # of no times too
        start = Rounded(*(np.stack(x)[place] for x in zip(*grid, strict=True)))
        return Rounded(middle.reshape(shape), radius.reshape(shape)) @ start

    def between(self, states: ManySets, begin: Floats, end: Floats) -> tuple[ManySets, ManySets]:
        """The states at the middle of two times, and all states between the times, (B,) each.

        The time is a further side of the sets of all states.
        """
        middle = (begin + end) / 2
        half = upward(np.maximum(end - middle, middle - begin))
        moved = states.mapped(self.at(middle))
        spread, centre = moved.spread, moved.centre
        rate, rate_off = _bounded_product(self.rate, centre)
        curve, curve_off = _bounded_product(self.curve, centre)
        first = _sizes(self.rate, spread)
        second = _sizes(self.curve, spread)
        exponents, place = np.unique(
            np.where(half > 0, np.frexp(half)[1], -60), return_inverse=True
        )
        bounds = np.stack([self._third(int(k)) for k in exponents] or [self._third(-60)])[place]
        third = product(bounds, upward(np.abs(centre) + spread)[:, :, None])
        h = half[:, None]
        squared = h * h
        loose = h * (rate_off + first) + squared / 2 * (second + curve_off)
        loose = loose + squared / 4 * np.abs(curve) + squared * h / 6 * third[:, :, 0]
        shift = squared / 4 * curve
        rounded = ROUNDING * (np.abs(centre) + np.abs(shift) + h * np.abs(rate))
        sides = np.concatenate([moved.sides, (h * rate)[:, :, None]], axis=2)
        box = upward(moved.box + loose + rounded)
        return moved, ManySets(centre + shift, sides, box)


def _bounded_product(matrix: Rounded, vectors: Floats) -> tuple[Floats, Floats]:
    """Products of a matrix and vectors (B, n), and bounds of their errors."""
    unsure = matrix.radius + ROUNDING * np.abs(matrix.middle)
    return product(vectors, matrix.middle.T), upward(product(np.abs(vectors), unsure.T))


def _sizes(matrix: Rounded, sizes: Floats) -> Floats:
    found: Floats = upward(product(sizes, (np.abs(matrix.middle) + matrix.radius).T))
    return found
