"""An affine function of the state along a segment of time: a polynomial and what it leaves out.

Windows of the segment are bounded by value and slope in their middle and the curvature over
them, whether the first crossing is looked for or a sign is to be proved.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flint import arb, arb_poly

__all__ = ["Expansion", "Window"]


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
