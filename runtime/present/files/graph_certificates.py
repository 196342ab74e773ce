"""Certificates of graphs of boxes in files."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import DividedGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.present.files.grid_entries import (
    GridEntries,
    Runs,
    grid_entries,
    grid_of,
    listed,
    runs,
)
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.graphs.box_graphs import BoxGraph
from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate

__all__ = ["GRAPH", "graph_entries", "graph_of", "load_graph_certificate", "save_graph"]

_MOST = 10**8  # edges


@dataclass(frozen=True, kw_only=True)
class GraphEntries:
    """Entries of the file of a graph of boxes.

    The divided cells of each level of the grid, and the properties of each box, are runs: a
    value, and how many times it follows. Each entry of `edges` leads from one box to boxes
    with successive numbers: the box, the first of these, and their count. Components have
    numbers; boxes on no cycle have -1.
    """

    system: str
    tables: SavedSystem | None
    parameters: Mapping[str, Value]
    claim: Literal["proved", "undecided"]
    configuration: str
    phase: tuple[Exact, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    grid: GridEntries
    divided: tuple[Runs, ...]
    edges: tuple[tuple[int, int, int], ...]
    outside: Runs
    unknown: Runs
    trapping: Runs
    components: Runs
    ranks: Runs
    widest: tuple[float, ...]
    most: int
    longest: int
    bits: int
    declaration: Mapping[str, Any]


GRAPH = FileFormat(
    name="nonsmooth graph certificate",
    what="certificate of a graph of boxes",
    entries=GraphEntries,
    version=VERSION,
)


def save_graph(found: GraphCertificate, path: str | os.PathLike[str]) -> None:
    """Write a graph's certificate to a file, which is replaced only when the new one is complete.

    `InputError` is raised if the file cannot be written.
    """
    GRAPH.write(path, graph_entries(found))


def graph_entries(found: GraphCertificate) -> GraphEntries:
    """Entries of the file of a graph of boxes."""
    name, _, saved = named(known_system(found.system, None))
    graph = found.graph
    texts = ("configuration", "phase", "source", "boundary", "coordinates")
    numbers = ("widest", "most", "longest", "bits")
    return GraphEntries(
        system=name,
        tables=saved,
        parameters=dict(found.parameters),
        claim="proved" if found.proved else "undecided",
        grid=grid_entries(graph.grid.grid),
        divided=tuple(map(runs, graph.grid.divided)),
        edges=_edges(graph),
        outside=runs(graph.outside),
        unknown=runs(graph.unknown),
        trapping=runs(graph.trapping),
        components=runs(graph.labels),
        ranks=runs(graph.ranks),
        declaration=dict(found.declaration),
        **{key: getattr(found, key) for key in (*texts, *numbers)},
    )


def graph_of(entries: GraphEntries) -> GraphCertificate:
    """The graph's certificate that a file's entries describe.

    What follows from the edges is computed, not read. `InputError` is raised if the grid
    has another number of boxes than the entries list, or if an edge leads to a box that
    does not exist.
    """
    own = {**vars(entries)}
    system_in(entries.system, own.pop("tables"))
    for name in ("claim", "grid", "divided", "edges", "trapping", "components", "ranks"):
        own.pop(name)
    grid = _divided(entries)
    size = len(grid)
    sources, targets = _listed_edges(entries.edges, size)
    outside, unknown = (listed(own.pop(name), size) != 0 for name in ("outside", "unknown"))
    return GraphCertificate(graph=BoxGraph(grid, sources, targets, outside, unknown), **own)


def _divided(entries: GraphEntries) -> DividedGrid:
    """The grid with its levels of division."""
    whole = grid_of(entries.grid)
    size, levels = len(whole), []
    for told in entries.divided:
        levels.append(listed(told, size) != 0)
        size = int(levels[-1].sum()) * 2 ** len(whole.counts)
    if not levels or size:
        raise InputError("a grid has another number of boxes than is told of")
    return DividedGrid(whole, tuple(levels))


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


load_graph_certificate = GRAPH.reader(graph_of)
