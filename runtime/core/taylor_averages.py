"""Averages of Taylor models over all numbers that are smaller than their variable.

A model of e and f encloses a function at every point of the square [-1, 1]^2. Its average over
f = s e, with s in [-1, 1] and a weight that is not negative, is a function of e alone and is
enclosed by that of its polynomial: the balls of even powers of f are averaged as they are; of
odd powers the middle falls out by symmetry, the radius stays.
"""

from __future__ import annotations

from math import prod
from typing import Any

from nonsmooth.runtime.core.taylor_models import Space, TaylorModel, space_of

__all__ = ["AT_BOTH_ENDS", "BENT_MEAN", "MEAN", "averaged", "lifted"]


Weight = tuple[int, ...]  # the average of abs(s)**p is one over the product of p + these
AT_BOTH_ENDS: Weight = ()  # of the values at s = 1 and s = -1
MEAN: Weight = (1,)  # over s in [-1, 1]
BENT_MEAN: Weight = (1, 3)  # of the function times (1 - s^2) / 2


def lifted(number: Any, space: Space) -> Any:
    """A model of e, or a matrix, as one of e and f that does not depend on f.

    The space has two variables and the same order. Balls stay what they are.
    """
    if not isinstance(number, TaylorModel):
        return number
    parts: list[Any] = [None] * len(space.exponents)
    for power, part in enumerate(number.parts):
        parts[space.exponents.index((power, 0))] = part
    return TaylorModel(space, tuple(parts))


def averaged(number: Any, weight: Weight) -> Any:
    """The weighted average of a model of e and f over f = s e, a model of e alone.

    The model may be a matrix; a ball depends on no variable. The weight is one of those of
    this module.
    """
    from flint import arb

    def share(power: int) -> arb:
        return arb(1) / prod(power + term for term in weight)

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
