"""Directed graphs of boxes: strong components, their order, and sets that nothing leaves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.proof.sets.branching import Leaves

__all__ = ["BoxGraph"]

Numbers = NDArray[np.int_]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class BoxGraph:
    """Boxes, each with those that its image meets.

    Attributes
    ----------
    grid : BoxGrid
    sources, targets : array of int (E,)
        Numbers of boxes: the image of a source may meet the target.
    outside : array of bool (B,)
        Whether a part of the image may be outside of the grid.
    unknown : array of bool (B,)
        Whether the image is not known; such boxes have no edges.
    """

    grid: BoxGrid
    sources: Numbers
    targets: Numbers
    outside: Flags
    unknown: Flags

    @staticmethod
    def of_leaves(grid: BoxGrid, found: Iterable[tuple[int, Leaves]]) -> BoxGraph:
        """The graph of images.

        Parameters
        ----------
        grid : BoxGrid
        found : iterable of (int, Leaves)
            Of successive boxes, each time with the number of the first one.

        Returns
        -------
        BoxGraph
        """
        outside, unknown = np.zeros(len(grid), dtype=bool), np.zeros(len(grid), dtype=bool)
        edges = [np.zeros((2, 0), dtype=int)]
        for first, leaves in found:
            lost = leaves.lost.copy()
            lost[
                leaves.origin[~(np.isfinite(leaves.low) & np.isfinite(leaves.high)).all(axis=1)]
            ] = True
            kept = ~lost[leaves.origin]
            origin = leaves.origin[kept]
            owner, number, inside = grid.numbers_met(
                _near(grid, leaves.low[kept]), _near(grid, leaves.high[kept])
            )
            unknown[first : first + len(lost)] = lost
            outside[first + origin[~inside]] = True
            edges.append(np.unique(np.stack([first + origin[owner], number]), axis=1))
        sources, targets = np.concatenate(edges, axis=1)
        return BoxGraph(grid, sources, targets, outside, unknown)

    def _matrix(self, sources: Numbers, targets: Numbers, size: int) -> Any:
        from scipy.sparse import csr_array

        return csr_array((np.ones(len(sources), dtype=np.int8), (sources, targets)), (size, size))

    @cached_property
    def edges(self) -> Any:
        """The edges as a sparse matrix (B, B)."""
        return self._matrix(self.sources, self.targets, len(self.grid))

    @cached_property
    def components(self) -> tuple[Numbers, ...]:
        """Strong components with a cycle: boxes that lie on one together, the largest first."""
        from scipy.sparse.csgraph import connected_components

        _, label = connected_components(self.edges, connection="strong")
        inner = label[self.sources] == label[self.targets]
        recurrent = np.unique(label[self.sources[inner]])
        found = [np.flatnonzero(label == own) for own in recurrent]
        return tuple(sorted(found, key=lambda own: (-len(own), int(own[0]))))

    def ahead(self, first: Numbers) -> Flags:
        """Boxes to which walks lead from some of these, with these.

        Parameters
        ----------
        first : array of int

        Returns
        -------
        array of bool (B,)
        """
        return self._led_to(self.sources, self.targets, first)

    def behind(self, last: Numbers) -> Flags:
        """Boxes from which walks lead to some of these, with these.

        Parameters
        ----------
        last : array of int

        Returns
        -------
        array of bool (B,)
        """
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
        """The largest trapping region: no walk from it leads outside or to an unknown image.

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
        """The Morse graph: pairs of components with no third one between them.

        Yields
        ------
        tuple of (int, int)
        """
        reaches = self.reaches
        count = reaches.astype(np.int64)
        direct = reaches & ~((count @ count) > 0)
        yield from ((int(i), int(j)) for i, j in np.argwhere(direct))


def _near(grid: BoxGrid, places: Floats) -> Floats:
    """Places, those far outside of a grid no further than some boxes."""
    first, counts = np.array(grid.first), np.array(grid.counts)
    return np.clip(places, (first - 4.0) * grid.sides, (first + counts + 4.0) * grid.sides)
