"""What is proved by a graph of boxes: where motions return to, and what they do not leave.

Directed graphs of boxes have strong components, their order, and sets that nothing leaves. What is
said of each box of a grid is in files as runs of one number, and how often it follows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.checker.state_sets.graph import Edges, edges_of, listed_edges
from nonsmooth.runtime.checker.state_sets.many_sets import Arrivals
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import IN_FILES, Follows, Integers, Several, Told, by, encode
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.proof.certificate import Decided
from nonsmooth.runtime.proof.sets.sections import SectionRecord, refused_as_input

_MOST = 10**8  # boxes of a grid


def _runs(values: NDArray[Any]) -> list[tuple[int, int]]:
    """Runs of an array (B,) of integers or booleans."""
    if not values.size:
        return []
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    lengths = np.diff(np.r_[starts, values.size])
    return [(int(values[k]), int(n)) for k, n in zip(starts, lengths, strict=True)]


def _numbers(told: Sequence[tuple[int, int]]) -> NDArray[np.int_]:
    """The array of which `told` are the runs; `InputError` if it is too long."""
    if any(n < 1 for _, n in told) or sum(n for _, n in told) > _MOST:
        raise InputError("it is of no number of boxes, or of too many")
    return np.repeat(np.array([x for x, _ in told], dtype=int), [n for _, n in told])


_RUN = tuple[tuple[int, int], ...]
Numbers = Annotated[NDArray[np.int_], by(_RUN, _runs, _numbers)]
Flags = Annotated[NDArray[np.bool_], by(_RUN, _runs, lambda told: _numbers(told) != 0)]


def check_size(values: NDArray[Any], size: int) -> None:
    """Raise `InputError` if an array is not of so many boxes."""
    if len(values) != size:
        raise InputError("a grid has another number of boxes than is told of")


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

    def _marked(self, boxes: Numbers) -> Flags:
        found = np.zeros(len(self.grid), dtype=bool)
        found[boxes] = True
        return found

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
        recurrent = self._marked(np.concatenate([self.targets[:0], *self.components]))
        leaving = self.outside.copy()
        leaving[np.setdiff1d(np.flatnonzero(leaving), self.sources)] = False
        found: Flags = recurrent | leaving | (self.unknown & self._marked(self.targets))
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
        own = self._marked(boxes)
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
        used = self._marked(self.sources)
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
    with refused_as_input():
        sources, targets = listed_edges(entries.edges, len(grid))
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
    def outside(self) -> Numbers:
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

    def targets(self, box: int) -> Numbers:
        """Boxes of the region that the image of a box may meet.

        Parameters
        ----------
        box : int

        Returns
        -------
        array of int
        """
        found: Numbers = self.graph.targets[self.graph.sources == box]
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
