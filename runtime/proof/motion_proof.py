"""What a validated simulation gives: enclosures of numbers, and what is proved of a motion."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.values import Value, as_value, flint_precision

if TYPE_CHECKING:
    from flint import arb


@dataclass(frozen=True, eq=False)
class Enclosure:
    """A real number between two others.

    Attributes
    ----------
    ball : flint.arb
    bits : int
        Precision at which it was computed.

    Examples
    --------
    >>> from flint import arb
    >>> third = Enclosure(arb(1) / 3, 53)
    >>> third.mid[:8], float(third.rad) < 1e-15, third.contains("1/3")
    ('3.333333', True, True)
    """

    ball: arb
    bits: int

    @property
    def mid(self) -> str:
        """Middle, in decimal: the number differs from it by at most `rad`."""
        return self._decimals()[0]

    @property
    def rad(self) -> str:
        """Radius, in decimal, rounded up."""
        return self._decimals()[1]

    def to_json(self) -> dict[str, str]:
        """Give both decimal texts.

        Returns
        -------
        dict of str to str
            "mid" and "rad".
        """
        return {"mid": self.mid, "rad": self.rad}

    @property
    def lower(self) -> float:
        """A double below the number."""
        return _outward(self.ball.lower(), -math.inf)

    @property
    def upper(self) -> float:
        """A double above the number."""
        return _outward(self.ball.upper(), math.inf)

    def __float__(self) -> float:
        return float(self.ball.mid())

    def __str__(self) -> str:
        """Give the digits that are certain, and the radius."""
        return str(self.ball.str(max(5, int(self.bits * 0.302))))

    def contains(self, number: object) -> bool:
        """Whether a number lies inside; text and fractions exactly, floats too.

        Parameters
        ----------
        number : arb, str, Fraction, int or float
            Not rounded.

        Returns
        -------
        bool
            True if that is certain.
        """
        from flint import arb

        if isinstance(number, arb):
            return bool(self.ball.contains(number))
        with flint_precision(2 * self.bits + 64):
            return bool(self.ball.contains(exactly(number, "a number")))

    def _decimals(self) -> tuple[str, str]:
        digits = max(5, int(self.bits * 0.302))
        middle, radius, exponent = map(int, self.ball.mid_rad_10exp(digits))
        return f"{_scientific(middle, exponent)}", f"{_scientific(radius, exponent)}"


def _scientific(integer: int, exponent: int) -> str:
    digits = str(abs(integer))
    sign, tail = "-" * (integer < 0), digits[1:]
    return f"{sign}{digits[0]}{'.' * bool(tail)}{tail}e{exponent + len(tail):+d}"


def _outward(end: arb, towards: float) -> float:
    return float(np.nextafter(float(end.mid()), towards))


@dataclass(frozen=True, eq=False, repr=False)
class Proof(Shown):
    """What is proved of one motion.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
    configurations : tuple of str
        The start's, and the one behind each proved transition.
    sets : tuple of tuple of str
        Boundaries reached at each transition: one entry fewer.
    times : tuple of Enclosure
        0, and the time of each transition.
    states : tuple of tuple of Enclosure
        The start, and the state behind each transition.
    decided : bool
        All that was asked for is proved: so many transitions, or that no further one
        follows.
    reason : str or None
        Why there are fewer transitions; None if there are not.
    instant : Enclosure or None
        When the motion cannot be decided; before it everything is proved.
    bits : int
        The precision that was needed.
    """

    system: str
    parameters: dict[str, Value]
    configurations: tuple[str, ...]
    sets: tuple[tuple[str, ...], ...]
    times: tuple[Enclosure, ...]
    states: tuple[tuple[Enclosure, ...], ...]
    decided: bool
    reason: str | None
    instant: Enclosure | None
    bits: int

    @property
    def phase(self) -> int:
        """The last phase, counted from 0: the one that cannot be decided, if any."""
        return len(self.configurations) - 1

    @property
    def transitions(self) -> int:
        """How many transitions are proved."""
        return len(self.sets)


def exactly(number: object, name: str) -> Any:
    """Return the rational number that a text, fraction or float stands for, without rounding.

    Any other number is refused; `name` is that of the number in the message.
    """
    from flint import fmpq

    if isinstance(number, float) and math.isfinite(number):
        number = Fraction(float(number))
    exact = as_value(number).exact
    if exact is None:
        raise InputError(f"{name} = {number} is not rational")
    return fmpq(exact.numerator, exact.denominator)
