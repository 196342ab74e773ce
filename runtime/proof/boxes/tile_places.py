"""Places of tiles: a box of parameters, halved again and again."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

Interval = tuple[Fraction, Fraction]
Point = tuple[Fraction, Fraction]  # of a plane


class Place(NamedTuple):
    """The place of a tile: along each axis, the k-th of 2^level equal parts of the box."""

    steps: tuple[tuple[int, int], ...]  # k and level of each axis

    def interval(self, axis: int, box: Sequence[Interval]) -> Interval:
        """Lower and upper end of the tile along one axis; `box` has the ends of each parameter."""
        step, level = self.steps[axis]
        lower, upper = box[axis]
        width = (upper - lower) / 2**level
        return lower + step * width, lower + (step + 1) * width

    @property
    def share(self) -> Fraction:
        """The tile's share of the box's area."""
        return Fraction(1, 2 ** sum(level for _, level in self.steps))

    @property
    def shares(self) -> tuple[Interval, ...]:
        """The tile's ends along each axis, in shares of the box from 0 to 1."""
        return tuple((Fraction(k, 2**level), Fraction(k + 1, 2**level)) for k, level in self.steps)

    def inside(self, point: Point) -> Point:
        """A point of a plane, given in shares of the box, counted from -1 to 1 over the tile."""
        sides = zip(point, self.shares, strict=True)
        x, y = ((2 * at - low - high) / (high - low) for at, (low, high) in sides)
        return x, y

    def middle(self, box: Sequence[Interval]) -> tuple[Fraction, ...]:
        """The value of each parameter in the middle of the tile; `box` has their ends."""
        ends = (self.interval(axis, box) for axis in range(len(self.steps)))
        return tuple((low + high) / 2 for low, high in ends)

    def holds(self, point: Sequence[Fraction], box: Sequence[Interval]) -> bool:
        """Whether the tile, with its edges, contains a point given by a value of each parameter."""
        ends = (self.interval(axis, box) for axis in range(len(self.steps)))
        return all(low <= x <= high for x, (low, high) in zip(point, ends, strict=True))

    def touches(self, other: Place) -> bool:
        """Whether two tiles of a box have a point in common, be it an edge or a corner."""
        for (step, level), (its_step, its_level) in zip(self.steps, other.steps, strict=True):
            finest = max(level, its_level)
            low, its_low = step << (finest - level), its_step << (finest - its_level)
            high, its_high = low + (1 << (finest - level)), its_low + (1 << (finest - its_level))
            if high < its_low or its_high < low:
                return False
        return True

    def shared(
        self, other: Place, box: Sequence[Interval], share: Fraction = Fraction(1, 2)
    ) -> tuple[Fraction, ...]:
        """A common point of two tiles that touch, as a value of each parameter.

        `share` is how far it is from the lower ends of what they share to the upper ones.
        """
        point = []
        for axis in range(len(self.steps)):
            mine, others = self.interval(axis, box), other.interval(axis, box)
            low, high = max(mine[0], others[0]), min(mine[1], others[1])
            point.append(low + share * (high - low))
        return tuple(point)

    def halves(self, axis: int) -> tuple[Place, Place]:
        """The lower and the upper half of the tile along an axis."""
        step, level = self.steps[axis]

        def half(number: int) -> Place:
            steps = list(self.steps)
            steps[axis] = (2 * step + number, level + 1)
            return Place(tuple(steps))

        return half(0), half(1)
