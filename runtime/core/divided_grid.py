"""Boxes of several sizes: those of a grid, some divided into boxes of half the sides, and so on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.float_sets import Floats, ManySets

__all__ = ["DividedGrid"]

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
