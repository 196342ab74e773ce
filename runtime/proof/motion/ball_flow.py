"""The flow of an exact affine field in balls: matrix exponentials and Taylor expansions.

A field y' = A y + b acts on (y, 1) as one matrix B. Nothing but B enters, so damping,
forcing, drift, defective and clustered eigenvalues are all one case. Time is cut into
segments about as long as a radian of the fastest motion. An affine function of the state is
on each of them a polynomial and a remainder, which the minimal polynomial of B bounds: with

    B^m = a_0 I + ... + a_(m-1) B^(m-1)

the derivatives d_k of any affine function obey d_(k+m) = sum of a_i d_(k+i), whatever the
units of the states.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, cached_property, lru_cache
from math import factorial
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from flint import arb, arb_mat, arb_poly

__all__ = ["AffineFlow", "Expansion", "Window"]

_GROWTH = 4  # how much faster than those before them later derivatives may grow, at most
_KEPT = 64  # segments whose exponentials are kept for the next phase


class AffineFlow:
    """The flow of one configuration, at the working precision at which it is made.

    The field B is square and exact and acts on (y, 1). The rows are exact affine functions of the
    state: n y + c as n and c.
    """

    def __init__(
        self, field: Sequence[Sequence[Any]], rows: Sequence[Sequence[Any]], bits: int
    ) -> None:
        from flint import arb, arb_mat, fmpq_mat

        self.field = fmpq_mat([list(row) for row in field])
        self.matrix = arb_mat(self.field)
        self.bits = bits
        self._unit = self._half()
        self.half = arb(self._unit)
        self.terms = self._terms()
        self.flow = lru_cache(2 * _KEPT)(self._flow)
        self._far = lru_cache(_KEPT)(self._far_flow)
        self._error_factor = cache(self._error)
        self.rows = [arb_mat([[arb(entry) for entry in row]]) for row in rows]
        self._taylor: dict[int, tuple[arb_mat, arb_mat]] = {}

    @cached_property
    def minimal(self) -> list[Any]:
        """Coefficients of the minimal polynomial of B, the last of them 1."""
        found = self.field.minpoly().coeffs()
        return [entry / found[-1] for entry in found]

    @cached_property
    def drifts(self) -> bool:
        """Whether the motion is a polynomial of time."""
        return not any(self.minimal[:-1])

    def advance(self, state: Sequence[arb], time: arb) -> list[arb]:
        """Return the state (N) after an exact time."""
        found: list[arb] = ((self.matrix * time).exp() * _column(state)).entries()
        return found[:-1]

    def crossing(
        self, row: int, state: Sequence[arb], times: arb, slope: arb
    ) -> tuple[arb, list[arb]]:
        """Return the time at which an affine function, by its number, is zero, and the state then.

        The function has one zero in the ball `times`; its derivative over it, `slope`, is not zero.
        The state is bounded together with the time: a change of the start moves both, and what the
        boundary holds fixed does not grow wider.
        """
        from flint import arb

        middle = times.mid()
        flow = (self.matrix * middle).exp()
        start = _column(state)
        centre = start.mid()
        spread = start - centre
        level = self.rows[row] * flow
        about = (level * centre)[0, 0]
        time = times.intersection(middle - (about + (level * spread)[0, 0]) / slope)
        late = arb(0, abs(times - middle).upper())
        end = flow * centre
        rates = self.matrix * ((self.matrix * late).exp() * (end + flow * spread))
        shares = rates / slope
        reached = end - shares * about + (flow - shares * level) * spread
        entries: list[arb] = reached.entries()
        return time, entries[:-1]

    def segment(self, number: int) -> tuple[arb, arb]:
        """Return the start and half the length of a segment, counted from 0.

        All segments have one length, but where the motion only drifts each is twice as long as the
        one before.
        """
        from flint import arb

        if self.drifts:
            size = arb(2) ** number
            return 2 * self.half * (size - 1), self.half * size
        return 2 * self.half * number, self.half

    def expansion(self, row: int, number: int, state: Sequence[arb]) -> Expansion:
        """Return the expansion of an affine function, by its number, along a segment.

        Segments are counted from 0, and `state` (N) is the one at time 0.
        """
        from flint import arb, arb_poly

        start, half = self.segment(number)
        rows, beyond = self._derivatives(row, half)
        middle = self.flow(number) * _column(state)
        remainder = arb(0)
        for entry in (beyond * middle).entries():
            remainder = remainder.max(abs(entry).upper())

        def error(order: int) -> arb:
            return arb(0, (remainder * self._error_factor(order)).upper())

        return Expansion(start, half, arb_poly((rows * middle).entries()), error)

    def _flow(self, number: int) -> arb_mat:
        """Return the flow from the start of the phase to the middle of a segment."""
        start, half = self.segment(number)
        if self.drifts or number < _KEPT:
            return (self.matrix * (start + half)).exp()
        far, near = divmod(number, _KEPT)
        return self._far(far) * self.flow(near)

    def _far_flow(self, count: int) -> arb_mat:
        """Return the flow over `count` times as many segments as are kept."""
        return (self.matrix * (self.half * (2 * _KEPT * count))).exp()

    def _error(self, order: int) -> arb:
        """Return the remainder of a derivative in units of the bound of the derivatives beyond."""
        from flint import arb

        first = self.terms - order
        whole = factorial(self.terms) // factorial(first)
        return whole / (1 - arb(_GROWTH) / (first + 1))

    def _derivatives(self, row: int, half: arb) -> tuple[arb_mat, arb_mat]:
        """Return rows that give a function's Taylor coefficients, and rows that bound the rest."""
        from flint import arb_mat

        if row in self._taylor:
            return self._taylor[row]
        matrix, last = self.matrix * half, self.rows[row]
        found = [last.entries()]
        for k in range(1, self.terms + self._degree):
            last = last * matrix
            if k <= self.terms:
                last = last / k
            found.append(last.entries())
        split = arb_mat(found[: self.terms]), arb_mat(found[self.terms :])
        if not self.drifts:  # segments are all alike
            self._taylor[row] = split
        return split

    @property
    def _degree(self) -> int:
        return len(self.minimal) - 1

    def _scaled(self, half: Any) -> list[Any]:
        """Return the minimal polynomial for derivatives by the place u on a segment."""
        return [a * half ** (self._degree - i) for i, a in enumerate(self.minimal)]

    def _half(self) -> Any:
        """Return half of a segment: the largest power of 2 with slowly growing derivatives."""
        from flint import fmpq

        def little(half: Any) -> bool:
            return bool(sum(map(abs, self._scaled(half)[:-1])) <= _GROWTH)

        half = fmpq(1)
        if not self.drifts:
            while not little(half):
                half /= 2
            while little(2 * half):
                half *= 2
        return half

    def _terms(self) -> int:
        """Return how many Taylor terms make the remainder about as small as rounding."""
        roots = np.roots([float(a) for a in reversed(self._scaled(self._unit))])
        radius = max(float(np.abs(roots).max()), 0.25)
        terms, size = 1, 1.0
        while terms < self._degree + _GROWTH + 2 or (size > 2.0**-self.bits and not self.drifts):
            terms += 1
            size *= radius / terms
        return terms


def _column(state: Sequence[arb]) -> arb_mat:
    from flint import arb, arb_mat

    return arb_mat([[x] for x in (*state, arb(1))])


class Expansion:
    """An affine function of the state along a segment of time, as a polynomial and an error.

    The place u runs from -1 to 1 over the segment, and derivatives are those by u. The segment is
    given by its start and half of its length, both exact. `error` gives a ball around what a
    derivative of the polynomial leaves out, by the derivative's order. Without it nothing is left
    out: then the last coefficient is a ball that holds the remainder.
    """

    def __init__(
        self,
        start: arb,
        half: arb,
        polynomial: arb_poly,
        error: Callable[[int], arb] | None = None,
    ) -> None:
        self.start, self.half = start, half
        self._derivatives = [polynomial]
        self._error = error
        self._errors: list[arb] = []

    def at(self, order: int, u: arb) -> arb:
        """Return an enclosure of a derivative at a place or over a ball of places.

        The derivative of order 0 is the function itself.
        """
        while len(self._derivatives) <= order:
            self._derivatives.append(self._derivatives[-1].derivative())
        value: arb = self._derivatives[order](u)
        if self._error is None:
            return value
        while len(self._errors) <= order:
            self._errors.append(self._error(len(self._errors)))
        return value + self._errors[order]

    def over(self, places: arb) -> Window:
        """Return the function over a ball of places in [-1, 1]."""
        return Window(self, places)

    def time(self, u: arb) -> arb:
        """Return the time at a place, from the start of the phase."""
        return self.start + self.half * (1 + u)


class Window:
    """A function over a ball of places, bounded by value and slope in the middle and its curvature.

    `middle` is exact, `rate` is the derivative there, and `curve` is the second derivative over the
    window.
    """

    __slots__ = ("_away", "_function", "curve", "middle", "rate")

    def __init__(self, function: Expansion, places: arb) -> None:
        self._function, self.middle = function, places.mid()
        self._away = places - self.middle
        self.curve, self.rate = function.at(2, places), function.at(1, self.middle)

    @property
    def value(self) -> arb:
        """The function in the middle of the window."""
        return self._function.at(0, self.middle)

    @property
    def rates(self) -> arb:
        """The derivative over the window."""
        return self.rate + self.curve * self._away

    @property
    def values(self) -> arb:
        """The function over the window."""
        from flint import arb

        square = arb(0).union(self._away.abs_upper() ** 2 / 2)
        return self.value + self.rate * self._away + self.curve * square
