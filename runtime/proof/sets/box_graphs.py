"""Directed graphs of boxes: strong components, their order, and sets that nothing leaves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.checker.state_sets.graph import Edges, edges_of
from nonsmooth.runtime.checker.state_sets.many_sets import Arrivals
from nonsmooth.runtime.core.box_grid import DividedGrid

Numbers = NDArray[np.int_]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class BoxGraph:
    """Boxes, each with those that its image meets."""

    grid: DividedGrid
    sources: Numbers  # (E,): numbers of boxes whose image may meet the target
    targets: Numbers  # (E,)
    outside: Flags  # (B,): a part of the image may be outside of the grid
    unknown: Flags  # (B,): the image is not known; such boxes have no edges

    @staticmethod
    def unseen(grid: DividedGrid) -> BoxGraph:
        """The graph of which no image is known."""
        none, size = np.zeros(0, dtype=int), len(grid)
        return BoxGraph(grid, none, none, np.zeros(size, dtype=bool), np.ones(size, dtype=bool))

    @property
    def found(self) -> Edges:
        """The edges, as the checker takes them."""
        return Edges(self.sources, self.targets, self.outside, self.unknown)

    def seen(self, numbers: Numbers, arrivals: Arrivals) -> BoxGraph:
        """The graph with the images of boxes (B,) of which none was known."""
        outside, unknown = self.outside.copy(), self.unknown.copy()
        new = edges_of(self.grid, numbers, arrivals)
        outside[numbers], unknown[numbers] = new.outside, new.unknown
        sources = np.concatenate([self.sources, new.source])
        targets = np.concatenate([self.targets, new.target])
        return BoxGraph(self.grid, sources, targets, outside, unknown)

    def halved(self, chosen: Flags) -> tuple[BoxGraph, Numbers]:
        """The graph with the chosen boxes (B,) divided, and the numbers of boxes without images.

        These are the halves, and the boxes whose images may meet a divided one.
        """
        grid, origin = self.grid.halved(chosen)
        stale = chosen.copy()
        stale[self.sources[chosen[self.targets]]] = True
        place = np.zeros(len(self.grid), dtype=int)
        place[origin] = np.arange(len(origin))
        kept = ~stale[self.sources]
        graph = BoxGraph(
            grid,
            place[self.sources[kept]],
            place[self.targets[kept]],
            (self.outside & ~stale)[origin],
            (self.unknown | stale)[origin],
        )
        return graph, np.flatnonzero(stale[origin])

    def _matrix(self, sources: Numbers, targets: Numbers, size: int) -> Any:
        from scipy.sparse import csr_array

        return csr_array((np.ones(len(sources), dtype=np.int8), (sources, targets)), (size, size))

    @cached_property
    def edges(self) -> Any:
        """The edges as a sparse matrix (B, B)."""
        return self._matrix(self.sources, self.targets, len(self.grid))

    @cached_property
    def coarse(self) -> Flags:
        """The boxes (B,) that are worth dividing: their halves may have sharper images.

        Those on cycles, those of which a part of the image alone may be outside, and those of
        unknown image to which an edge leads.
        """
        recurrent, met = (np.zeros(len(self.grid), dtype=bool) for _ in range(2))
        recurrent[np.concatenate([self.targets[:0], *self.components])] = True
        met[self.targets] = True
        leaving = self.outside.copy()
        leaving[np.setdiff1d(np.flatnonzero(leaving), self.sources)] = False
        found: Flags = recurrent | leaving | (self.unknown & met)
        return found

    @cached_property
    def _strong(self) -> Numbers:
        """The number of each box's strong component (B,), with a cycle or alone."""
        from scipy.sparse.csgraph import connected_components

        found: Numbers = connected_components(self.edges, connection="strong")[1]
        return found.astype(int)

    @cached_property
    def ranks(self) -> Numbers:
        """How many other strong components the longest walk from each box enters (B,)."""
        label, size = self._strong, int(self._strong.max()) + 1
        apart = label[self.sources] != label[self.targets]
        pairs = np.unique(label[self.targets[apart]] * size + label[self.sources[apart]])
        later, earlier = np.divmod(pairs, size)
        begins = np.searchsorted(later, np.arange(size + 1))
        left, rank = np.bincount(earlier, minlength=size), np.zeros(size, dtype=int)
        last, level = np.flatnonzero(left == 0), 0
        while len(last):
            rank[last] = level
            counts = begins[last + 1] - begins[last]
            shift = np.repeat(begins[last] - np.cumsum(counts) + counts, counts)
            met, times = np.unique(earlier[np.arange(len(shift)) + shift], return_counts=True)
            left[met] -= times
            last, level = met[left[met] == 0], level + 1
        return rank[label]

    @cached_property
    def components(self) -> tuple[Numbers, ...]:
        """Strong components with a cycle: boxes that lie on one together.

        First those that no edge leaves, then the others, the largest first.
        """
        label = self._strong
        inner = label[self.sources] == label[self.targets]
        recurrent = np.unique(label[self.sources[inner]])
        order = np.argsort(label, kind="stable")
        begins = np.searchsorted(label[order], np.append(recurrent, recurrent + 1))
        ends = zip(*np.split(begins, 2), strict=True)
        found = [np.sort(order[first:last]) for first, last in ends]
        return tuple(sorted(found, key=lambda own: (not self.stays(own), -len(own), int(own[0]))))

    @cached_property
    def labels(self) -> Numbers:
        """The place among the components of each box's one (B,), -1 for boxes on no cycle."""
        found = np.full(len(self.grid), -1)
        for number, own in enumerate(self.components):
            found[own] = number
        return found

    def stays(self, boxes: Numbers) -> bool:
        """Whether no edge leads from the boxes to others, outside, or to an unknown image."""
        own = np.zeros(len(self.grid), dtype=bool)
        own[boxes] = True
        left = self.outside | self.unknown
        return bool(own[self.targets[own[self.sources]]].all() and not left[boxes].any())

    def ahead(self, first: Numbers) -> Flags:
        """The boxes (B,) to which walks lead from some of `first`, with these."""
        return self._led_to(self.sources, self.targets, first)

    def behind(self, last: Numbers) -> Flags:
        """The boxes (B,) from which walks lead to some of `last`, with these."""
        return self._led_to(self.targets, self.sources, last)

    def _led_to(self, sources: Numbers, targets: Numbers, first: Numbers) -> Flags:
        from scipy.sparse.csgraph import breadth_first_order

        size = len(self.grid)  # one more vertex leads to the first ones
        begins = np.concatenate([sources, np.full(len(first), size)])
        matrix = self._matrix(begins, np.concatenate([targets, first]), size + 1)
        order = breadth_first_order(matrix, size, return_predecessors=False)
        found = np.zeros(size + 1, dtype=bool)
        found[order] = True
        return found[:size]

    @cached_property
    def trapping(self) -> Flags:
        """The largest trapping region (B,): no walk from it leads outside or to an unknown image.

        A box without an image is in it only where an image leads to it.
        """
        good = ~self.behind(np.flatnonzero(self.outside | self.unknown))
        used = np.zeros(len(self.grid), dtype=bool)
        used[self.sources] = True
        used[self.targets[good[self.sources]]] = True
        found: Flags = good & used
        return found

    @cached_property
    def reaches(self) -> Flags:
        """Whether walks lead from one component to another: (C, C), False on the diagonal."""
        count = len(self.components)
        found = np.zeros((count, count), dtype=bool)
        for k, own in enumerate(self.components):
            ahead = self.ahead(own[:1])
            found[k] = [bool(ahead[other[0]]) for other in self.components]
        np.fill_diagonal(found, False)
        return found

    def arrows(self) -> Iterator[tuple[int, int]]:
        """Yield the edges of the Morse graph: pairs of components without a third one between."""
        reaches = self.reaches
        count = reaches.astype(np.int64)
        direct = reaches & ~((count @ count) > 0)
        yield from ((int(i), int(j)) for i, j in np.argwhere(direct))
