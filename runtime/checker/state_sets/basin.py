"""Basins: a core that is contracted, boxes of a section that lead to it, and tiles of starts.

P^k maps the core into itself and shortens distances there, in the norm of the core: so it has one
fixed point in it, to which all of the core tends (S. Banach, 1922). All states of a box of the
section of the rank r come to the core or to boxes of smaller ranks, and so to the core in at most r
steps; those of attracted tiles come to boxes of the section that have a rank.
"""

from collections.abc import Callable
from contextlib import closing
from heapq import heappop, heappush
from itertools import count as numbers_from
from math import inf
from typing import Any

import numpy as np
from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.state_sets.graph import listed, stated_grid
from nonsmooth.runtime.checker.state_sets.many_sets import ManyMotions, in_batches
from nonsmooth.runtime.checker.state_sets.one_way import Parallelepiped, SectionMap, divided
from nonsmooth.runtime.checker.state_sets.sets import TooWide
from nonsmooth.runtime.checker.state_sets.switching import StatedSection
from nonsmooth.runtime.checker.stated.exact import Entries, demand, exact
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file
from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.float_sets import Floats, ManySets, Rounded
from nonsmooth.runtime.core.parallel import in_processes

_BITS = 80
_MOST, _FINEST = 2000, fmpq(1, 2**10)  # parts of the core, and of their sides
_BATCH = 8192
_LONGEST = 24  # transitions on one way
_FAR = 1e308  # numbers that are finite
_MORE = 8  # times the parts of one set that the file states


def attracted_boxes(
    question: Entries, grid: BoxGrid, progress: Callable[[], object] = lambda: None
) -> Any:
    """Return the rank of each box of a section, or -1: in so many steps it comes to the core.

    `question` has the entries of a file that state section and core; that the core is contracted is
    not looked at.
    """
    core, motions = _inward(question, grid), _motions(question)
    ranks = np.where(_in_core(core, *grid.bounds(np.arange(len(grid)))), 0, -1)
    parts = []
    for numbers in in_batches(np.arange(len(grid)), _BATCH):
        progress()
        found = motions.arrivals(grid.sets(numbers))
        parts.append(found._replace(origin=numbers[found.origin]))
    origin, low, high, lost = (np.concatenate(x) for x in list(zip(*parts, strict=True))[:4])
    inner = _in_core(core, low, high)
    seen = np.isin(np.arange(len(grid)), origin) & ~lost
    for rank in numbers_from(1):
        known = inner | grid.covered(grid.sums(ranks >= 0), low, high)
        new = (ranks < 0) & seen
        new[origin[~known]] = False
        if not new.any():
            return ranks
        ranks[new] = rank
    raise AssertionError


class AttractedTiles:
    """Tiles of all states, and whether all motions from them come to boxes that have a rank.

    `question` has the entries of a file that state section, ranks and tiles; sets may have `more`
    times as many portions as it states.
    """

    def __init__(self, question: Entries, more: int = 1) -> None:
        self._motions = _motions(question, more)
        demand(not self._motions.forced, "tiles of other states")
        self._grid = stated_grid(question["grid"], len(self._motions.free))
        self._tiles = stated_grid(question["tiles"], len(self._motions.system.states))
        self._sums = self._grid.sums(listed(question["ranks"], len(self._grid)) >= 0)
        self._whole = [name for name, rows in self._motions.system.held.items() if not rows]
        demand(self._whole, "no configuration in which all states are free")

    def _known(self, _: Any, low: Floats, high: Floats) -> Any:
        return self._grid.covered(self._sums, low, high)

    def _starts(self, numbers: Any) -> ManySets:
        boxes = self._tiles.sets(numbers)
        return ManySets(*(np.insert(x, x.shape[1] - 1, 0.0, axis=1) for x in vars(boxes).values()))

    def each(self, numbers: Any) -> Any:
        """Return of which tiles, by numbers (B,), this is shown of each as a whole: bools (B,)."""
        good = np.ones(len(numbers), dtype=bool)
        for name in self._whole:
            left = np.flatnonzero(good)
            found = self._motions.leaves(self._starts(numbers[left]), name, (), self._known)
            good[left[found.lost]] = False
        return good

    def all(self, numbers: Any) -> bool:
        """Return whether it is shown of all these tiles, in parts if need be."""
        starts = self._starts(numbers)
        return all(self._motions.lead(starts, name, (), self._known) for name in self._whole)


def check_basin(
    content: Entries,
    workers: int = 1,
    progress: Callable[[int, int], object] = lambda done, count: None,
) -> None:
    """Prove a basin's certificate again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape. The tiles are followed in
    `workers` processes; `progress` is called with the tiles proved so far and their count.
    """
    check_file(content, "nonsmooth basin certificate")
    check_bits(content)
    if content["claim"] != "proved":
        told = ("core", "grid", "tiles", "ranks", "verdicts", "itinerary", "states", "box")
        demand(not any(content[name] for name in (*told, "declaration")), "numbers of no claim")
        demand(content["contraction"] == "1" and not content["iterates"], "numbers of no claim")
        return
    demand(not content["reason"], "a reason why it is not proved")
    demand(content["core"] is not None, "there is no core")
    widest = content["widest"]
    demand(0 < widest < float("inf") and 0 < content["most"] <= 10**5, "no limits of sets")
    grid = stated_grid(content["grid"], len(content["coordinates"]))
    ranks, attracted = listed(content["ranks"], len(grid)), _attracted(content)
    demand(ranks.min() >= -1 and ranks.max() < len(grid), "no such ranks")
    with ctx.workprec(_BITS):
        told = exact(content["contraction"])
        demand(0 < told < 1, "the core is not contracted")
        contraction(content, told, 2 * _MOST)
        _check_ranks(content, grid, ranks)
    if len(attracted):
        _check_tiles(content, attracted, workers, progress)


def contraction(question: Entries, limit: Any = 1, most: int = _MOST) -> Any:
    """Return an upper bound of the factor by which P^k contracts the core, mapped into itself.

    `question` has the entries of a file that state system, section, core and `itinerary`.
    `Failure` is raised where the factor is not shown to be less than the `limit` in `most` parts.
    Parts of what was farthest from being shown come first: what fails does so soon.
    """
    mapped = SectionMap(question)
    own, way = Parallelepiped(question["core"], len(mapped.free)), question["itinerary"]
    mapped.check_way(way)
    largest, looked, boxes = arb(0), 0, [(-inf, 0, 0, own.whole)]
    while boxes:
        *_, box = heappop(boxes)
        looked += 1
        demand(looked <= most, "the core is not shown to be contracted")
        try:
            seen = mapped.image(own, box, way, sloped=True).through(own.inward)
        except TooWide:
            shortened, far = False, inf
        else:
            columns = [tangent.hull.entries() for tangent in seen.tangents]
            sums = [sum((abs(x) for x in row), arb(0)) for row in zip(*columns, strict=True)]
            inside = all(abs(x) < 1 for x in seen.hull.entries())
            shortened = inside and all(total < arb(limit) for total in sums)
            never = any(total > arb(limit) for total in sums)
            demand(not never, "the core is not contracted")
            far = max(float(total.upper()) for total in sums)
        if shortened:
            largest = max([largest, *(total.upper() for total in sums)])
            continue
        k = max(range(len(box)), key=lambda place: box[place][1] - box[place][0])
        wide = box[k][1] - box[k][0] > _FINEST
        demand(wide, "the core is not shown to be contracted")
        for place, part in enumerate(reversed(divided(box, k))):
            heappush(boxes, (-far, -looked, place, part))
    return largest


def _check_ranks(content: Entries, grid: BoxGrid, ranks: Any) -> None:
    """Prove that every ranked box of the section leads to the core or to boxes of lower rank."""
    core, motions = _inward(content, grid), _motions(content, _MORE)
    for inner in in_batches(np.flatnonzero(ranks == 0), _BATCH):
        held = _in_core(core, *grid.bounds(inner)).all()
        demand(held, "a box of the rank 0 is not in the core")
    for rank in np.unique(ranks[ranks > 0]):  # the file may leave many out
        sums = grid.sums((ranks >= 0) & (ranks < rank))
        for numbers in in_batches(np.flatnonzero(ranks == rank), _BATCH):
            seen = np.zeros(len(numbers), dtype=bool)

            def known(origin: Any, low: Any, high: Any, sums: Any = sums, seen: Any = seen) -> Any:
                seen[origin] = True
                return _in_core(core, low, high) | grid.covered(sums, low, high)

            led = motions.lead(*motions.on_section(grid.sets(numbers)), known)
            demand(led, f"a box of the rank {rank} may lead elsewhere")
            demand(seen.all(), f"a box of the rank {rank} has no image")


def _attracted(content: Entries) -> Any:
    """Return the numbers of the tiles that are stated to be attracted.

    The tiles have to cover the stated box, and their rows at its ends have to meet it.
    """
    if content["tiles"] is None:
        told = (content[name] for name in ("verdicts", "states", "box"))
        demand(not any(told), "verdicts of no tiles")
        return np.zeros(0, dtype=int)
    states = content["declaration"]["states"]
    demand(content["states"] == states and not content["phase"], "tiles of other states")
    tiles = stated_grid(content["tiles"], len(states))
    demand(list(content["box"]) == states, "the box is not one of the states")
    ends = [content["box"][name] for name in states]
    demand(all(-_FAR < low < high < _FAR for low, high in ends), "the box is none")
    for exponent, first, count, (low, high) in zip(
        tiles.exponents, tiles.first, tiles.counts, ends, strict=True
    ):
        from_first, to_last = (
            fmpq(*x.as_integer_ratio()) / fmpq(2) ** exponent for x in (low, high)
        )
        met = first <= from_first < first + 1 and first + count - 1 < to_last <= first + count
        demand(met, "tiles of another box")
    verdicts = listed(content["verdicts"], len(tiles))
    demand(verdicts.min() >= 0 and verdicts.max() <= 2, "no such verdicts")
    return np.flatnonzero(verdicts == 2)


def _check_tiles(
    content: Entries, good: Any, workers: int, progress: Callable[[int, int], object]
) -> None:
    """Prove that all motions from the attracted tiles come to boxes with a rank."""
    size = max(1, min(_BATCH, -(-len(good) // workers)))
    batches = in_batches(good, size)
    given, done = {**content, "verdicts": []}, 0
    with closing(in_processes(_begin_tiles, given, batches, workers)) as found:
        for numbers, led in found:
            demand(led, "a tile may lead elsewhere")
            done += len(numbers)
            progress(done, len(good))


def _begin_tiles(content: Entries) -> Callable[[Any], bool]:
    """Return a test whether all motions from tiles, by their numbers, come to ranked boxes."""
    return AttractedTiles(content, _MORE).all


def _inward(question: Entries, grid: BoxGrid) -> Rounded:
    """Return the matrix from (coordinates, 1) of the section to the core's coordinates."""
    return Rounded.of(Parallelepiped(question["core"], len(grid.counts)).inward)


def _motions(question: Entries, more: int = 1) -> ManyMotions:
    """Return the first-arrival map of sets of states to the section that a file states."""
    declared = question["declaration"]
    scales = [1.0] * len(declared["states"])
    return ManyMotions(
        declared, question["parameters"], StatedSection.of(question), scales, question["widest"],
        more * question["most"], _LONGEST,
    )  # fmt: skip


def _in_core(core: Rounded, low: Floats, high: Floats) -> Any:
    """Return which boxes (B, d) of the section lie inside of the core."""
    if not len(low):
        return np.zeros(0, dtype=bool)
    least, most = ManySets.of_boxes(low, high).ranges(core)
    return np.all((least > -1) & (most < 1), axis=1)
