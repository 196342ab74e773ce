"""A graph of boxes in a file: its edges, and what follows from them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.proof.graphs.box_graphs import BoxGraph
from nonsmooth.runtime.proof.sets.runs import Flags, Numbers, check_size

__all__ = ["GraphEntries", "entries_of", "graph_of", "stated_graph"]

_MOST = 10**8  # edges


@dataclass(frozen=True, kw_only=True)
class GraphEntries:
    """Entries for a graph of boxes.

    The divided cells of each level of the grid, and the properties of each box, are runs. Each
    entry of `edges` leads from one box to boxes with successive numbers: the box, the first of
    these, and their count. Components have numbers; boxes on no cycle have -1.
    """

    grid: BoxGrid
    divided: tuple[Flags, ...]
    edges: tuple[tuple[int, int, int], ...]
    outside: Flags
    unknown: Flags
    trapping: Flags
    components: Numbers
    ranks: Numbers


def entries_of(graph: BoxGraph) -> GraphEntries:
    """Entries for a graph of boxes."""
    return GraphEntries(
        grid=graph.grid.grid,
        divided=graph.grid.divided,
        edges=_edges(graph),
        outside=graph.outside,
        unknown=graph.unknown,
        trapping=graph.trapping,
        components=graph.labels,
        ranks=graph.ranks,
    )


def graph_of(entries: GraphEntries) -> BoxGraph:
    """The graph that entries describe.

    `InputError` is raised if the grid has another number of boxes than the entries list, if an
    edge leads to a box that does not exist, or if an entry does not follow from the edges.
    """
    graph = stated_graph(entries)
    told, given = encode(entries), encode(entries_of(graph))
    for name, entry in told.items():
        if entry != given[name]:
            raise InputError(f"{name!r} is not what the other entries give")
    return graph


def stated_graph(entries: GraphEntries) -> BoxGraph:
    """The graph of the edges that entries list, whatever they say of it."""
    grid = _divided(entries)
    for flags in (entries.outside, entries.unknown):
        check_size(flags, len(grid))
    sources, targets = _listed_edges(entries.edges, len(grid))
    return BoxGraph(grid, sources, targets, entries.outside, entries.unknown)


def _divided(entries: GraphEntries) -> DividedGrid:
    """The grid with its levels of division."""
    size = len(entries.grid)
    for level in entries.divided:
        check_size(level, size)
        size = int(level.sum()) * 2 ** len(entries.grid.counts)
    if not entries.divided or size:
        raise InputError("a grid has another number of boxes than is told of")
    return DividedGrid(entries.grid, entries.divided)


def _edges(graph: BoxGraph) -> tuple[tuple[int, int, int], ...]:
    """The edges in order, with those to successive boxes joined: box, first target, count."""
    order = np.lexsort((graph.targets, graph.sources))
    source, target = graph.sources[order], graph.targets[order]
    if not len(source):
        return ()
    breaks = (np.diff(source) != 0) | (np.diff(target) != 1)
    begin = np.flatnonzero(np.r_[True, breaks])
    count = np.diff(np.r_[begin, len(source)])
    rows = np.stack([source[begin], target[begin], count], axis=1).tolist()
    return tuple((s, t, n) for s, t, n in rows)


def _listed_edges(
    told: Sequence[tuple[int, int, int]], size: int
) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Sources and targets of all edges, from those that were joined."""
    source, first, count = np.array(told or np.zeros((0, 3), dtype=int)).T
    fits = (source >= 0) & (source < size) & (first >= 0) & (count > 0) & (first + count <= size)
    if not fits.all() or count.sum() > _MOST:
        raise InputError("an edge leads to no box")
    place = np.arange(int(count.sum())) - np.repeat(np.cumsum(count) - count, count)
    return np.repeat(source, count), np.repeat(first, count) + place
