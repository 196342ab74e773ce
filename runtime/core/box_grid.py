"""Grids of boxes, exact in binary: which of them a box meets, and whether given ones cover it.

In a `DividedGrid` some boxes are divided into boxes of half the sides, and so on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import ceil, floor, frexp, prod

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats, ManySets

_LARGEST = 10**8  # boxes
_EXPONENT = 900  # of 2, of a side: what is near to none and to infinity has other roundings
_FARTHEST = 2**52  # sides from 0: doubles and machine integers hold all places exactly


@dataclass(frozen=True)
class BoxGrid:
    """A grid of boxes k h <= x <= (k + 1) h, with h a power of 2 for each coordinate."""

    exponents: tuple[int, ...]  # exponents of 2 of the sides h
    first: tuple[int, ...]  # number k of the first box along each coordinate
    counts: tuple[int, ...]  # number of boxes along each coordinate

    def __post_init__(self) -> None:
        if not len(self.exponents) == len(self.first) == len(self.counts) > 0:
            raise InputError("a grid states its sides, first boxes and counts by coordinates")
        if any(abs(e) > _EXPONENT for e in self.exponents):
            raise InputError(f"a side of a box is from 2^-{_EXPONENT} to 2^{_EXPONENT}")
        if min(self.counts) < 1 or prod(self.counts) > _LARGEST:
            raise InputError(f"a grid has 1 to {_LARGEST} boxes: take longer sides")
        self.check_levels(0)

    def check_levels(self, levels: int) -> None:
        """Raise `InputError` unless doubles hold all coordinates after so many halvings."""
        ends = (*self.first, *(f + n for f, n in zip(self.first, self.counts, strict=True)))
        if max(map(abs, ends)) << levels > _FARTHEST:
            raise InputError("so far from 0 boxes have longer sides: take longer ones")

    @staticmethod
    def over(low: Sequence[float], high: Sequence[float], exponents: Sequence[int]) -> BoxGrid:
        """The smallest grid with the sides 2^exponents that covers a box, all arrays (d,).

        An `InputError` refuses too many boxes, and coordinates that doubles do not hold.
        """
        units = [Fraction(2) ** e for e in exponents]
        first = [floor(Fraction(x) / unit) for x, unit in zip(low, units, strict=True)]
        last = [ceil(Fraction(x) / unit) for x, unit in zip(high, units, strict=True)]
        counts = (max(end - begin, 1) for begin, end in zip(first, last, strict=True))
        return BoxGrid(tuple(exponents), tuple(first), tuple(counts))

    @staticmethod
    def around(low: Floats, high: Floats, sides: Floats, most: int = _LARGEST) -> BoxGrid:
        """The grid that covers a box, with the largest powers of 2 up to `sides` as its sides.

        The ends of the box and `sides` are arrays (d,). An `InputError` refuses more boxes than
        `most`, and coordinates that doubles do not hold.
        """
        lengths = sides.tolist()
        told = f"boxes of the sides {', '.join(f'{side:g}' for side in lengths)}"
        if not (np.isfinite([low, high, sides]).all() and min(lengths) > 0):
            raise InputError(f"{told}: not all ends and sides are finite and positive")
        try:
            grid = BoxGrid.over(low.tolist(), high.tolist(), [frexp(x)[1] - 1 for x in lengths])
        except InputError as problem:
            raise InputError(f"{told}: {problem}") from None
        if len(grid) > most:
            raise InputError(f"{told}: {len(grid)} are more than {most}, take longer ones")
        return grid

    def __len__(self) -> int:
        return prod(self.counts)

    @cached_property
    def sides(self) -> Floats:
        """Lengths (d,) of the sides."""
        found: Floats = 2.0 ** np.array(self.exponents)
        return found

    def bounds(self, numbers: NDArray[np.int_]) -> tuple[Floats, Floats]:
        """Least and largest coordinates (B, d) of the boxes with these numbers (B,), exactly.

        Numbers count the boxes in C order.
        """
        places = np.stack(np.unravel_index(numbers, self.counts), axis=1) + np.array(self.first)
        return places * self.sides, (places + 1) * self.sides

    def sets(self, numbers: NDArray[np.int_]) -> ManySets:
        """The boxes with these numbers (B,) as sets in R^(d + 1)."""
        return ManySets.of_boxes(*self.bounds(numbers))

    def met(
        self, low: Floats, high: Floats
    ) -> tuple[NDArray[np.int_], NDArray[np.int_], NDArray[np.bool_]]:
        """Ranges of the boxes of the grid that given boxes meet, along each coordinate.

        The given boxes go from `low` to `high`, (B, d) each. The results are the first place
        and the one behind the last, (B, d) each, and flags (B,) of the given boxes that lie
        all inside the grid.
        """
        size, first, counts = self.sides, np.array(self.first), np.array(self.counts)
        least, most = np.floor(low / size) - first, np.floor(high / size) + 1 - first
        inside = ((least >= 0) & (most <= counts)).all(axis=1)
        # in integers only where they fit; what is no number may be anywhere
        begin, end = np.clip(np.nan_to_num(least), 0, counts), np.clip(most, 0, counts)
        end = np.where(np.isnan(end), counts, end)
        return begin.astype(int), end.astype(int), inside

    def numbers_met(
        self, low: Floats, high: Floats
    ) -> tuple[NDArray[np.int_], NDArray[np.int_], NDArray[np.bool_]]:
        """All P pairs of a given box and a box of the grid that it meets.

        The given boxes go from `low` to `high`, (B, d) each. The results are the place of the
        given box and the number of the box of the grid, (P,) each, and flags (B,) of the given
        boxes that lie all inside the grid.
        """
        begin, end, inside = self.met(low, high)
        spans = np.maximum(end - begin, 0)
        each = spans.prod(axis=1)
        owner = np.repeat(np.arange(len(low)), each)
        left = np.arange(len(owner)) - np.repeat(np.cumsum(each) - each, each)
        number = np.zeros(len(owner), dtype=int)
        scale = 1
        for k in reversed(range(len(self.counts))):
            width = spans[owner, k]
            number += scale * (begin[owner, k] + left % np.maximum(width, 1))
            left = left // np.maximum(width, 1)
            scale *= self.counts[k]
        return owner, number, inside

    def sums(self, good: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Cumulative sums of flags (len(self),), with one more place along each coordinate.

        The entry of a place is the number of flagged boxes below it along all coordinates.
        """
        found = good.reshape(self.counts).astype(np.int64)
        for axis in range(len(self.counts)):
            found = np.cumsum(found, axis=axis)
        return np.pad(found, [(1, 0)] * len(self.counts))

    def covered(self, sums: NDArray[np.int64], low: Floats, high: Floats) -> NDArray[np.bool_]:
        """Flags (B,) of the boxes that lie in the union of chosen boxes of the grid.

        The boxes go from `low` to `high`, (B, d) each. The array `sums` is what the method of
        that name gives for the flags of the chosen ones.
        """
        begin, end, inside = self.met(low, high)
        total = np.zeros(len(low), dtype=np.int64)
        for lower in product((False, True), repeat=len(self.counts)):
            places = zip(begin.T, end.T, lower, strict=True)
            total += (-1) ** sum(lower) * sums[tuple(b if own else e for b, e, own in places)]
        covered: NDArray[np.bool_] = inside & (total == np.maximum(end - begin, 0).prod(axis=1))
        return covered


Numbers = NDArray[np.int_]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class DividedGrid:
    """Boxes of several sizes, with disjoint interiors, that cover the region of a grid.

    The cells of the first level are the boxes of the grid; those of each further level are
    the 2^d halves of the divided cells of the level before, in their order. The cells that
    are not divided are the boxes, numbered from the first level on.
    """

    grid: BoxGrid
    divided: tuple[Flags, ...]  # for each level, flags of the divided cells; none in the last level

    def __post_init__(self) -> None:
        self.grid.check_levels(len(self.divided) - 1)

    @staticmethod
    def of(grid: BoxGrid) -> DividedGrid:
        """The boxes of a grid, none of them divided."""
        return DividedGrid(grid, (np.zeros(len(grid), dtype=bool),))

    def __len__(self) -> int:
        return int(self._first[-1])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, DividedGrid):
            return NotImplemented
        same = self.grid == other.grid and len(self.divided) == len(other.divided)
        pairs = zip(self.divided, other.divided, strict=False)
        return same and all(np.array_equal(one, two) for one, two in pairs)

    __hash__ = None  # type: ignore[assignment]  # arrays have no hash

    @cached_property
    def _first(self) -> Numbers:
        """Number of the first box of each level, and behind these the number of all boxes."""
        return np.cumsum([0, *(int((~own).sum()) for own in self.divided)])

    @cached_property
    def _halves(self) -> Numbers:
        """Places (2^d, d) of the halves of a cell, 0 or 1 along each coordinate."""
        count = len(self.grid.counts)
        return np.stack(np.unravel_index(np.arange(2**count), (2,) * count), axis=1)

    @cached_property
    def _places(self) -> tuple[Numbers, ...]:
        """Places (C, d) of the cells of each level, in units of the sides of that level."""
        counts = self.grid.counts
        cells = np.stack(np.unravel_index(np.arange(len(self.grid)), counts), axis=1)
        found = [cells + np.array(self.grid.first)]
        for divided in self.divided[:-1]:
            halves = 2 * found[-1][divided][:, None, :] + self._halves
            found.append(halves.reshape(-1, len(counts)))
        return tuple(found)

    @cached_property
    def _number(self) -> tuple[Numbers, ...]:
        """For each cell the number of its box, or -1 minus its place among the divided cells."""
        found = []
        for first, divided in zip(self._first[:-1], self.divided, strict=True):
            box = first + np.cumsum(~divided) - 1
            found.append(np.where(divided, -1 * np.cumsum(divided), box))
        return tuple(found)

    @cached_property
    def _levels(self) -> Numbers:
        """Level of each box."""
        return np.repeat(np.arange(len(self.divided)), np.diff(self._first))

    @cached_property
    def _ends(self) -> tuple[Floats, Floats]:
        """Least and largest coordinates (B, d) of all boxes."""
        kept = zip(self._places, self.divided, strict=True)
        places = np.concatenate([own[~divided] for own, divided in kept])
        sides = self.grid.sides * 0.5 ** self._levels[:, None]
        return places * sides, (places + 1) * sides

    @property
    def finest(self) -> Floats:
        """Sides (d,) of the smallest boxes."""
        found: Floats = self.grid.sides * 0.5 ** (len(self.divided) - 1)
        return found

    def bounds(self, numbers: Numbers) -> tuple[Floats, Floats]:
        """Least and largest coordinates (B, d) of the boxes with these numbers (B,), exactly."""
        low, high = self._ends
        return low[numbers], high[numbers]

    def sets(self, numbers: Numbers) -> ManySets:
        """The boxes with these numbers (B,) as sets in R^(d + 1)."""
        return ManySets.of_boxes(*self.bounds(numbers))

    def numbers_met(self, low: Floats, high: Floats) -> tuple[Numbers, Numbers, Flags]:
        """All P pairs of a given box and a box of this grid that it meets.

        The given boxes go from `low` to `high`, (B, d) each. The results are the place of the
        given box and the number of the box of this grid, (P,) each, and flags (B,) of the given
        boxes that lie all inside the region.
        """
        owner, cell, inside = self.grid.numbers_met(low, high)
        found = []
        for level, (divided, numbers) in enumerate(zip(self.divided, self._number, strict=True)):
            box = ~divided[cell]
            found.append((owner[box], numbers[cell[box]]))
            if level + 1 == len(self.divided):
                break
            owner = np.repeat(owner[~box], len(self._halves))
            first = (-1 - numbers[cell[~box]]) * len(self._halves)
            cell = (first[:, None] + np.arange(len(self._halves))).reshape(-1)
            size = self.grid.sides * 0.5 ** (level + 1)
            place = self._places[level + 1][cell]
            met = np.floor(low / size)[owner] <= place
            met &= place <= np.floor(high / size)[owner]
            kept = met.all(axis=1)
            owner, cell = owner[kept], cell[kept]
        pairs = [np.concatenate(part) for part in zip(*found, strict=True)]
        return pairs[0], pairs[1], inside

    def halved(self, chosen: Flags) -> tuple[DividedGrid, Numbers]:
        """The grid with flagged boxes (len(self),) divided, and the old box of each new one.

        The array holds for each new box the number of the old box that it is or is a part of.
        """
        count, level = len(self._halves), 0
        # of the cells of a level: which of the old ones each is, if any, and of which box it is
        old, owner = np.arange(len(self.grid)), np.full(len(self.grid), -1)
        divided, origin = [], []
        while len(old):
            kept = old >= 0
            number = np.full(len(old), -1)
            before = np.zeros(len(old), dtype=bool)
            if level < len(self.divided):
                number[kept] = self._number[level][old[kept]]
                before[kept] = self.divided[level][old[kept]]
            owner = np.where(kept & ~before, number, owner)
            now = before | (kept & chosen[owner])
            divided.append(now)
            origin.append(owner[~now])
            halves = (-1 - number[now])[:, None] * count + np.arange(count)
            old = np.where(before[now][:, None], halves, -1).reshape(-1)
            owner = np.repeat(np.where(before, -1, owner)[now], count)
            level += 1
        return DividedGrid(self.grid, tuple(divided)), np.concatenate(origin)
