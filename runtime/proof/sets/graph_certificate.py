"""What is proved by a graph of boxes: where motions return to, and what they do not leave."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import IN_FILES, Follows, Integers, Several, Told, encode
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.proof.certificate import Decided
from nonsmooth.runtime.proof.sets.box_graphs import BoxGraph
from nonsmooth.runtime.proof.sets.runs import Flags, Numbers, check_size
from nonsmooth.runtime.proof.sets.sections import SectionRecord

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


@dataclass(frozen=True, eq=False)
class Component:
    """A strong component of the graph that has a cycle: a vertex of the Morse graph."""

    boxes: Integers = field(repr=False)  # numbers of its boxes
    low: tuple[float, ...]  # lower bounds of its coordinates
    high: tuple[float, ...]  # upper bounds of its coordinates
    attracting: bool  # a trapping region by itself: every image of its boxes lies in it
    leaves: bool  # a walk from it leads outside of the region or to a box of unknown image


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class RegionCertificate(SectionRecord):
    """A rigorous outer approximation of a section's map on a region, at one parameter point.

    P is the map from a section to its next return: over periods of the forcing, or from one
    passage of a transition to the next. The region is a grid of boxes. For each box of known
    image the edges lead to boxes that contain P of all of its states, but for what leaves the
    region, which is said. A trapping region is a union of boxes of which all images stay in it:
    every motion that starts there has all its later returns there.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All of the system, exactly.
    configuration : str
        In which states on the section are.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    graph : BoxGraph
        Boxes and edges.
    widest : tuple of float
        Sets that are wider along a state than this were divided on the way.
    most, longest : int
        Parts of one box, and transitions until it returns, at most.
    bits : int
        Precision of the exact part of the proof.
    declaration : dict
        The system, as functions of its parameters, as in the file.
    """

    graph: Annotated[BoxGraph, IN_FILES, Several(GraphEntries, entries_of, graph_of)] = field(
        repr=False
    )
    widest: tuple[float, ...]
    most: int
    longest: int
    bits: int

    @Told
    def components(self) -> tuple[Component, ...]:
        """Where motions that stay in the region accumulate, the attracting ones first."""
        graph, found = self.graph, []
        for own in graph.components:
            low, high = graph.grid.bounds(own)
            found.append(
                Component(
                    boxes=own,
                    low=tuple(low.min(axis=0).tolist()),
                    high=tuple(high.max(axis=0).tolist()),
                    attracting=graph.stays(own),
                    leaves=bool((graph.ahead(own) & (graph.outside | graph.unknown)).any()),
                )
            )
        return tuple(found)

    @Told
    def arrows(self) -> tuple[tuple[int, int], ...]:
        """The Morse graph: from which component motions may come to which.

        Without those that follow from others.
        """
        return tuple(self.graph.arrows())

    @Follows
    def claim(self) -> Decided:
        """Whether there is an attracting component."""
        return "proved" if self.proved else "undecided"

    @Told
    def claims(self) -> dict[str, str]:
        """Verdict on "region": whether there is an attracting component."""
        return {"region": self.claim}

    @Told
    def statement(self) -> str:
        """What is proved, in words."""
        graph = self.graph
        count, few = len(self.components), sum(own.attracting for own in self.components)
        known = f"the images of {int((~graph.unknown).sum())} of {len(graph.grid)} boxes are known"
        stays = f"all returns of a motion from {len(self.trapping)} trapping boxes are in these"
        parts = "component" if count == 1 else "components"
        return (
            f"{known}; {stays}; among known boxes motions recur in {count} {parts} alone,"
            f" {few} of them attracting"
        )

    @property
    def proved(self) -> bool:
        """Whether a trapping region with a cycle is proved: there is an attracting component."""
        return any(own.attracting for own in self.components)

    @Told
    def region(self) -> dict[str, tuple[float, float]]:
        """Bounds of the coordinates in the region, exactly."""
        grid = self.graph.grid.grid
        low, high = grid.bounds(np.array([0, len(grid) - 1]))
        ends = zip(low[0].tolist(), high[1].tolist(), strict=True)
        return dict(zip(self.coordinates, ends, strict=True))

    @Told
    def trapping(self) -> Integers:
        """Boxes of the largest trapping region."""
        return np.flatnonzero(self.graph.trapping)

    @Told
    def unknown(self) -> Integers:
        """Boxes whose image is not known."""
        return np.flatnonzero(self.graph.unknown)

    @property
    def outside(self) -> NDArray[np.int_]:
        """Boxes of which a part of the image may be outside of the region."""
        return np.flatnonzero(self.graph.outside)

    def box_of(self, point: Sequence[float]) -> int:
        """The number of the box that contains a point of the section.

        Parameters
        ----------
        point : sequence (d,)
            The coordinates.

        Returns
        -------
        int

        Raises
        ------
        InputError
            If it is not in the region.
        """
        place = np.array([[float(x) for x in point]])
        if place.shape[1] != len(self.coordinates) or not np.isfinite(place).all():
            raise InputError(f"{point!r} is no point of ({', '.join(self.coordinates)})")
        _, number, inside = self.graph.grid.numbers_met(place, place)
        if not inside[0]:
            raise InputError(f"{point!r} is not in the region")
        return int(number[0])

    def component_of(self, point: Sequence[float]) -> Component | None:
        """The component that contains a point of the section.

        Parameters
        ----------
        point : sequence (d,)
            The coordinates.

        Returns
        -------
        Component or None
            None if its box is on no cycle.

        Raises
        ------
        InputError
            If it is not in the region.
        """
        box = self.box_of(point)
        return next((own for own in self.components if box in own.boxes), None)

    def targets(self, box: int) -> NDArray[np.int_]:
        """Boxes of the region that the image of a box may meet.

        Parameters
        ----------
        box : int

        Returns
        -------
        array of int
        """
        found: NDArray[np.int_] = self.graph.targets[self.graph.sources == box]
        return found

    def to_json(self) -> dict[str, Any]:
        """Give what is proved as JSON, without the edges.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        graph = self.graph
        return {
            **super().to_json(),
            "counts": list(graph.grid.grid.counts),
            "boxes": len(graph.grid),
            "levels": len(graph.grid.divided) - 1,
            "smallest": graph.grid.finest.tolist(),
            "edges": len(graph.sources),
            "outside": len(self.outside),
        }

    def plot(self, axes: Any = None) -> Any:
        """Draw the boxes of the components, the trapping region, and the Morse graph.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw the boxes, without the Morse graph; a figure of its own by default.

        Returns
        -------
        matplotlib Figure or Axes
            The figure, or the Axes that were given.

        Raises
        ------
        InputError
            If the section has more than two coordinates.
        MissingExtra
            Without matplotlib: ``pip install "nonsmooth[plot]"``.
        """
        return registered("draw_graph")(self, axes)
