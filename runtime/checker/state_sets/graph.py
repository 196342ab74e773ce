"""Graphs of boxes of a section: where their images lie, and what follows from the edges.

Of each box whose image is known, every state that returns to the section comes to one of the boxes
to which edges lead from it, or leaves the region where that is stated. Then no edge leaves the
boxes that are stated to be trapping, and an edge that leads to no box of the same component leads
to a smaller rank: so returns that stay among boxes of known image are in the boxes of one component
from some return on.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.checker.state_sets.many_sets import Arrivals, ManyMotions, in_batches
from nonsmooth.runtime.checker.state_sets.switching import StatedSection
from nonsmooth.runtime.checker.stated.exact import Entries, Failure, demand
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats

_LARGEST = 10**8  # boxes of a grid, and of all its levels
_LEVELS = 40
_NUMBERS = 2**40  # of boxes


def stated_grid(entries: Any, size: int) -> BoxGrid:
    """Return the grid in `size` coordinates that a file states; `Failure` if it is none."""
    demand(entries is not None, "there is no grid")
    exponents, first, counts = (tuple(entries[x]) for x in ("exponents", "first", "counts"))
    demand(size > 0 and all(len(x) == size for x in (exponents, first, counts)), "no such grid")
    try:
        return BoxGrid(exponents, first, counts)
    except InputError as problem:
        raise Failure(f"no such grid: {problem}") from None


def stated_divided_grid(entries: Any, levels: Sequence[Any], size: int) -> DividedGrid:
    """Return a grid in `size` coordinates of which some boxes are divided, level by level.

    `entries` states the grid, `levels` which cells of each level are divided, as runs.
    """
    whole = stated_grid(entries, size)
    demand(0 < len(levels) <= _LEVELS, "no such levels of a grid")
    cells, every, divided = len(whole), 0, []
    for runs in levels:
        every += cells
        demand(every <= _LARGEST, "no such levels of a grid")
        told = listed(runs, cells)
        demand(np.isin(told, (0, 1)).all(), "a box is divided or not")
        divided.append(told == 1)
        cells = int(told.sum()) * 2**size
    demand(not cells, "no such levels of a grid")
    try:
        return DividedGrid(whole, tuple(divided))
    except InputError as problem:
        raise Failure(f"no such levels of a grid: {problem}") from None


def listed(runs: Sequence[Any], size: int) -> Any:
    """Return the number of each box, an int array (size,), from runs (number, count).

    `Failure` is raised if the runs cover more or fewer boxes.
    """
    fits = all(n > 0 for _, n in runs) and sum(n for _, n in runs) == size <= _LARGEST
    demand(fits, "another number of boxes than the grid has")
    demand(all(abs(x) < _NUMBERS for x, _ in runs), "no such numbers")
    return np.repeat([x for x, _ in runs] or [0], [n for _, n in runs] or [0])


_FEWEST_BITS, _MOST_BITS = 64, 4096
_BATCH = 1024
_MORE = 8  # times the parts of one set that the file states
_FINEST = 0.125  # parts of windows of time: boxes have to come to narrow places
_MOST = 10**8  # edges
_FAR = 4.0  # boxes beyond the region: further is not looked at


class Edges(NamedTuple):
    """Where the images of some boxes lie."""

    source: Any  # (E,): numbers of boxes
    target: Any  # (E,): boxes that their images may meet
    outside: Any  # (B,): whether a part of an image may be outside of the grid
    unknown: Any  # (B,): whether an image is not known; such boxes have no edges


def map_of_boxes(question: Entries, more: int = 1) -> ManyMotions:
    """Return the map of sets to the next return to the section that a file of a graph states.

    Sets may have `more` times as many portions as the file states. `Failure` is raised if there is
    no such section, or if the declaration is of another kind.
    """
    widest, most, longest = (question[name] for name in ("widest", "most", "longest"))
    limits = all(0 < x < float("inf") for x in widest) and 0 < most <= 10**6
    demand(limits and 0 < longest <= 10**4, "no limits of sets")
    demand(len(widest) == len(question["declaration"]["states"]), "no limits of sets")
    demand(_FEWEST_BITS <= question["bits"] <= _MOST_BITS, "no precision of flows")
    return ManyMotions(
        question["declaration"], question["parameters"], StatedSection.of(question), widest,
        1.0, more * most, longest, _FINEST, question["bits"],
    )  # fmt: skip


def edges_of(grid: DividedGrid, numbers: Any, found: Arrivals) -> Edges:
    """Return the edges from boxes (B,) to all that their images may meet.

    Sets of the arrivals have the numbers of places in `numbers`.
    """
    lost, (low, high) = found.lost.copy(), (found.low, found.high)
    lost[found.origin[~(np.isfinite(low) & np.isfinite(high)).all(axis=1)]] = True
    kept = ~lost[found.origin]
    origin = found.origin[kept]
    place, target, inside = _met(grid, low[kept], high[kept])
    # every pair once
    pairs = np.unique(numbers[origin[place]] * len(grid) + target)
    outside = np.zeros(len(numbers), dtype=bool)
    outside[origin[~inside]] = True
    return Edges(*np.divmod(pairs, len(grid)), outside, lost)


def stays(edges: Edges, trapping: Any, component: Any, ranks: Any) -> bool:
    """Return whether a component is stayed in: no edge leads from it to elsewhere.

    `Failure` is raised unless no edge leaves the boxes that are `trapping` (B,) and `ranks` (B,)
    fall along all edges but those within a `component` (B,), a number or -1, of which each box has
    one from it and one to it.
    """
    source, target = edges.source, edges.target
    leaves = edges.outside | edges.unknown
    closed = trapping[target[trapping[source]]].all()
    demand(closed and not (trapping & leaves).any(), "a trapping region is left")
    own, other = component[source], component[target]
    within = (own == other) & (own >= 0)
    demand((within | (ranks[target] < ranks[source])).all(), "an edge ascends")
    members = component >= 0
    for side in (source, target):
        met = np.zeros(len(members), dtype=bool)
        met[side[within]] = True
        demand((met | ~members).all(), "a box is not of its component")
    left = np.unique(np.concatenate([own[~within], component[leaves]]))
    return len(np.setdiff1d(component[members], left)) > 0


def check_graph(content: Entries) -> None:
    """Prove a graph of boxes again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth region certificate")
    check_bits(content)
    demand(content["declaration"], "claims about no declaration")
    motions = map_of_boxes(content, _MORE)
    named = [motions.system.states[k] for k in motions.free]
    demand(content["coordinates"] == named, "the coordinates are not those of the section")
    grid = stated_divided_grid(content["grid"], content["divided"], len(named))
    edges = _stated_edges(content, grid)
    numbers = (listed(content[name], len(grid)) for name in ("components", "ranks"))
    proved = stays(edges, _flags(content["trapping"], grid), *numbers)
    demand((content["claim"] == "proved") == proved, "the verdict is another one")
    _check_images(motions, grid, edges)


def _flags(runs: Any, grid: DividedGrid) -> Any:
    told = listed(runs, len(grid))
    demand(np.isin(told, (0, 1)).all(), "a box is so or not")
    return told == 1


def listed_edges(rows: Sequence[Sequence[int]], size: int) -> tuple[Any, Any]:
    """Return sources and targets of all edges, from rows: a box, the first target, their count.

    `Failure` is raised if one leads from or to none of so many boxes.
    """
    source, first, count = np.array(rows or np.zeros((0, 3), dtype=int)).T
    fits = (source >= 0) & (source < size) & (first >= 0) & (count > 0)
    fits &= (first < size) & (count <= size - first)
    demand(fits.all() and count.sum() <= _MOST, "an edge leads to no box")
    source = np.repeat(source, count)
    begins = np.repeat(np.cumsum(count) - count, count)
    return source, np.repeat(first, count) + np.arange(len(source)) - begins


def _stated_edges(content: Entries, grid: DividedGrid) -> Edges:
    """Return the edges of a file, in order."""
    outside, unknown = (_flags(content[name], grid) for name in ("outside", "unknown"))
    source, target = listed_edges(content["edges"], len(grid))
    lost = unknown[source].any() or (unknown & outside).any()
    demand(not lost, "an edge of an unknown image")
    demand((np.diff(source * len(grid) + target) > 0).all(), "edges are not in order")
    return Edges(source, target, outside, unknown)


def _check_images(motions: ManyMotions, grid: DividedGrid, edges: Edges) -> None:
    """Demand that the images of all boxes not stated as unknown lie where the edges lead."""
    seen = np.zeros(len(grid), dtype=bool)
    keys = np.append(edges.source * len(grid) + edges.target, len(grid) ** 2)  # the last of no edge
    for numbers in in_batches(np.flatnonzero(~edges.unknown), _BATCH):

        def known(origin: Any, low: Floats, high: Floats, numbers: Any = numbers) -> Any:
            box, (place, target, inside) = numbers[origin], _met(grid, low, high)
            seen[box] = True
            pairs = box[place] * len(grid) + target
            missing = keys[np.searchsorted(keys, pairs)] != pairs
            good = (inside | edges.outside[box]) & ~np.isnan(low + high).any(axis=1)
            good[place[missing]] = False
            return good

        led = motions.lead(*motions.on_section(grid.sets(numbers)), known)
        demand(led, "the image of a box is not shown to lie where its edges lead")
    demand(seen[edges.source].all(), "an edge leads from a box that has no image")


def _met(grid: DividedGrid, low: Floats, high: Floats) -> tuple[Any, Any, Any]:
    """Return what `numbers_met` of the grid does, of boxes far outside of it too."""
    whole = grid.grid
    first, counts = np.array(whole.first), np.array(whole.counts)
    least, most = (first - _FAR) * whole.sides, (first + counts + _FAR) * whole.sides
    return grid.numbers_met(np.clip(low, least, most), np.clip(high, least, most))
