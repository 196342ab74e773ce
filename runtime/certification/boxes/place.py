"""Places of tiles: a box of parameters, halved again and again."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

__all__ = ["Interval", "Place"]

Interval = tuple[Fraction, Fraction]


class Place(NamedTuple):
    """Where a tile is: along each axis the k-th of 2^level equal parts of the box."""

    steps: tuple[tuple[int, int], ...]

    def interval(self, axis: int, box: Sequence[Interval]) -> Interval:
        """The tile along one axis."""
        step, level = self.steps[axis]
        lower, upper = box[axis]
        width = (upper - lower) / 2**level
        return lower + step * width, lower + (step + 1) * width

    @property
    def share(self) -> Fraction:
        """Of the box's area."""
        return Fraction(1, 2 ** sum(level for _, level in self.steps))

    def halves(self, axis: int) -> tuple[Place, Place]:
        """The two halves along an axis."""
        step, level = self.steps[axis]

        def half(number: int) -> Place:
            steps = list(self.steps)
            steps[axis] = (2 * step + number, level + 1)
            return Place(tuple(steps))

        return half(0), half(1)
