"""Averages of Taylor models over all numbers that are smaller than their variable.

A model of e and f encloses a function at every point of the square [-1, 1]^2. Its average over
f = s e, with s in [-1, 1] and a weight that is not negative, is a function of e alone and is
enclosed by that of its polynomial: the balls of even powers of f are averaged as they are; of
odd powers the middle falls out by symmetry, the radius stays.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.core.taylor_models import Space, TaylorModel, space_of

__all__ = ["at_both_ends", "averaged", "bent_mean", "lifted", "mean"]

Weight = Callable[[int], Fraction]


def at_both_ends(power: int) -> Fraction:
    """The average of the values at s = 1 and s = -1.

    Parameters
    ----------
    power : int
        Of s.

    Returns
    -------
    Fraction
        The average of abs(s)**power.
    """
    return Fraction(1)


def mean(power: int) -> Fraction:
    """The mean over s in [-1, 1].

    Parameters
    ----------
    power : int
        Of s.

    Returns
    -------
    Fraction
        The average of abs(s)**power.
    """
    return Fraction(1, power + 1)


def bent_mean(power: int) -> Fraction:
    """The mean over s in [-1, 1] of the function times (1 - s^2) / 2.

    Parameters
    ----------
    power : int
        Of s.

    Returns
    -------
    Fraction
        The average of abs(s)**power times that.
    """
    return Fraction(1, (power + 1) * (power + 3))


def lifted(number: Any, space: Space) -> Any:
    """The same model of e in a space of e and f, on which it does not depend.

    Parameters
    ----------
    number : TaylorModel, arb or a matrix of them
    space : Space
        Of two variables and the same order.

    Returns
    -------
    TaylorModel, arb or a matrix of them
        Balls stay what they are.
    """
    if not isinstance(number, TaylorModel):
        return number
    parts: list[Any] = [None] * len(space.exponents)
    for power, part in enumerate(number.parts):
        parts[space.exponents.index((power, 0))] = part
    return TaylorModel(space, tuple(parts))


def averaged(number: Any, weight: Weight) -> Any:
    """The average of a model of e and f over f = s e.

    Parameters
    ----------
    number : TaylorModel, arb or a matrix of them
        Balls depend on no variable.
    weight : function of an int
        The average of an absolute power of s.

    Returns
    -------
    TaylorModel, arb or a matrix of them
        Of e alone.
    """
    from flint import arb

    def share(power: int) -> arb:
        found = weight(power)
        return arb(found.numerator) / found.denominator

    if not isinstance(number, TaylorModel):
        return number * share(0)
    space = space_of(1, number.space.order)
    parts: list[Any] = [None] * len(space.exponents)
    for part, (own, power) in zip(number.parts, number.space.exponents, strict=True):
        if part is None:
            continue
        term = (part - part.mid() if power % 2 else part) * share(power)
        place = own + power
        parts[place] = term if parts[place] is None else parts[place] + term
    return TaylorModel(space, tuple(parts))
