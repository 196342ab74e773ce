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
    """An affine function of the state along one segment of time.

    Time is counted by u from -1 to 1 over the segment, derivatives are those by u.

    Parameters
    ----------
    start, half : arb
        Of the segment: its start, and half of its length. Exact.
    polynomial : arb_poly
    error : function of the order of a derivative, optional
        A ball around what the polynomial's derivative leaves out; nothing where its last
        coefficient is a ball that holds that.
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
        """A derivative at a place in [-1, 1], or over a ball of places.

        Parameters
        ----------
        order : int
            Of the derivative by the place; 0 for the function.
        u : arb
            The place, nondimensional.

        Returns
        -------
        arb
            An enclosure, with the error of the expansion.
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
        """The function over a ball of places.

        Parameters
        ----------
        places : arb
            In [-1, 1], nondimensional.

        Returns
        -------
        Window
            The part of the function there.
        """
        return Window(self, places)

    def time(self, u: arb) -> arb:
        """Time at a place.

        Parameters
        ----------
        u : arb
            The place in [-1, 1].

        Returns
        -------
        arb
            From the start of the phase, in the system's units.
        """
        return self.start + self.half * (1 + u)

    def raised(self, height: arb) -> Expansion:
        """The function and a constant.

        Parameters
        ----------
        height : arb
            The constant, in the function's units.

        Returns
        -------
        Expansion
            On the same segment, with the same error.
        """
        return Expansion(self.start, self.half, self._derivatives[0] + height, self._error)


class Window:
    """A function over a ball of places.

    Attributes
    ----------
    middle : arb
        Exact.
    rate : arb
        Its derivative there.
    curve : arb
        Its second derivative over the window.
    """

    __slots__ = ("_away", "_function", "curve", "middle", "rate")

    def __init__(self, function: Expansion, places: arb) -> None:
        self._function, self.middle = function, places.mid()
        self._away = places - self.middle
        self.curve, self.rate = function.at(2, places), function.at(1, self.middle)

    @property
    def value(self) -> arb:
        """The function in the middle."""
        return self._function.at(0, self.middle)

    @property
    def rates(self) -> arb:
        """Its derivative over the window."""
        return self.rate + self.curve * self._away

    @property
    def values(self) -> arb:
        """The function over the window."""
        from flint import arb

        square = arb(0).union(self._away.abs_upper() ** 2 / 2)
        return self.value + self.rate * self._away + self.curve * square
