"""The check of a basin: a core that is contracted, and boxes of starts that lead to it.

P^k maps the core into itself and shortens distances there, in the norm of the core: so it has one
fixed point in it, to which all of the core tends. A box of the section of the rank r is shown to
come to the core or to boxes of smaller ranks, and so to the core in at most r steps. Tiles are
shown to come to boxes of the section that have a rank.
"""

from collections.abc import Callable
from contextlib import closing
from typing import Any

import numpy as np
from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.chaos import Box, SectionMotions, SectionPart
from nonsmooth.runtime.checker.exact import check_sum, demand, exact
from nonsmooth.runtime.checker.grids import listed, stated_grid
from nonsmooth.runtime.checker.many_sets import ManyMotions
from nonsmooth.runtime.checker.sets import TooWide
from nonsmooth.runtime.checker.shape import BASIN, check_bits, check_shape
from nonsmooth.runtime.checker.switching import StatedSection
from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.float_sets import ManySets, Rounded
from nonsmooth.runtime.core.parallel import in_processes

__all__ = ["check_basin"]

_BITS = 80
_MOST, _FINEST = 4000, fmpq(1, 2**10)  # parts of the core, and of their sides
_BATCH = 8192
_LONGEST = 24  # transitions on one way
_FAR = 1e308  # numbers that are finite
_MORE = 8  # times the parts of one set that the file states


def check_basin(
    content: dict[str, Any],
    workers: int = 1,
    progress: Callable[[int, int], object] = lambda done, count: None,
) -> None:
    """Prove a basin's certificate again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape. The tiles are followed in
    `workers` processes; `progress` is called with the tiles proved so far and their count.
    """
    check_shape(content, BASIN)
    check_sum(content)
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
        core = _check_core(content)
        _check_ranks(content, _motions(content), core, grid, ranks)
    _check_tiles(content, attracted, workers, progress)


def _check_core(content: dict[str, Any]) -> Rounded:
    """Prove that the core is mapped into itself and contracted; return its coordinates' matrix."""
    declared, core = content["declaration"], {**content["core"], "name": "core"}
    alone = [entry for entry in declared["transitions"] if len(entry["boundaries"]) == 1]
    motions = SectionMotions(
        {
            **content,
            "declaration": {**declared, "transitions": alone},
            "h_sets": [core],
            "coverings": [],
            "itineraries": {"core": content["itinerary"]},
        },
        _MOST,
    )
    part, told = SectionPart(motions, "core"), exact(content["contraction"])
    demand(0 < told < 1, "the core is not contracted")
    boxes: list[Box] = [((fmpq(-1), fmpq(1)),) * len(motions.free)]
    while boxes:
        box = boxes.pop()
        try:
            if _contracted(part, box, told):
                continue
        except TooWide:
            pass
        k = max(range(len(box)), key=lambda place: box[place][1] - box[place][0])
        low, high = box[k]
        demand(high - low > _FINEST, "the core is not shown to be contracted")
        for half in ((low, (low + high) / 2), ((low + high) / 2, high)):
            boxes.append((*box[:k], half, *box[k + 1 :]))
    return Rounded.of(motions.sets["core"].inward)


def _contracted(part: SectionPart, box: Box, told: Any) -> bool:
    """Return whether a part of the core is mapped into it by a contraction.

    All sums of absolute derivatives along a row have to be less than the stated contraction.
    """
    seen = part.seen("core", part.image(box))
    if not all(abs(x) < 1 for x in seen.hull.entries()):
        return False
    columns = [tangent.hull.entries() for tangent in seen.tangents]
    sums = [sum((abs(x) for x in row), arb(0)) for row in zip(*columns, strict=True)]
    return all(bool(total < arb(told)) for total in sums)


def _check_ranks(
    content: dict[str, Any], motions: ManyMotions, core: Rounded, grid: BoxGrid, ranks: Any
) -> None:
    """Prove that every ranked box of the section leads to the core or to boxes of lower rank."""
    named = [motions.system.states[k] for k in motions.free]
    demand(content["coordinates"] == named, "the coordinates are not those of the section")

    def in_core(low: Any, high: Any) -> Any:
        if not len(low):
            return np.zeros(0, dtype=bool)
        least, most = ManySets.of_boxes(low, high).ranges(core)
        return np.all((least > -1) & (most < 1), axis=1)

    inner = np.flatnonzero(ranks == 0)
    for begin in range(0, len(inner), _BATCH):
        some = grid.bounds(inner[begin : begin + _BATCH])
        demand(in_core(*some).all(), "a box of the rank 0 is not in the core")
    for rank in np.unique(ranks[ranks > 0]):  # the file may leave many out
        sums = grid.sums((ranks >= 0) & (ranks < rank))

        def known(origin: Any, low: Any, high: Any, sums: Any = sums) -> Any:
            return in_core(low, high) | grid.covered(sums, low, high)

        left = np.flatnonzero(ranks == rank)
        for begin in range(0, len(left), _BATCH):
            starts = grid.sets(left[begin : begin + _BATCH])
            lifted = starts.mapped(motions.lift(motions.facts, timed=False))
            good = motions.lead(lifted, motions.section.configuration, motions.facts, known)
            demand(good, f"a box of the rank {rank} may lead elsewhere")


def _attracted(content: dict[str, Any]) -> Any:
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
    content: dict[str, Any], good: Any, workers: int, progress: Callable[[int, int], object]
) -> None:
    """Prove that all motions from the attracted tiles come to boxes with a rank."""
    size = max(1, min(_BATCH, -(-len(good) // workers)))
    batches = (good[begin : begin + size] for begin in range(0, len(good), size))
    given, done = {**content, "verdicts": []}, 0
    with closing(in_processes(_begin_tiles, given, batches, workers)) as found:
        for numbers, led in found:
            demand(led, "a tile may lead elsewhere")
            done += len(numbers)
            progress(done, len(good))


def _begin_tiles(content: dict[str, Any]) -> Callable[[Any], bool]:
    """Return a test whether all motions from tiles, by their numbers, come to ranked boxes."""
    with ctx.workprec(_BITS):
        motions = _motions(content)
    demand(not motions.forced, "tiles of other states")
    grid = stated_grid(content["grid"], len(motions.free))
    tiles = stated_grid(content["tiles"], len(motions.system.states))
    sums = grid.sums(listed(content["ranks"], len(grid)) >= 0)
    whole = [name for name, rows in motions.system.held.items() if not rows]
    demand(whole, "no configuration in which all states are free")

    def lead(numbers: Any) -> bool:
        boxes = tiles.sets(numbers)
        parts = (np.insert(x, x.shape[1] - 1, 0.0, axis=1) for x in vars(boxes).values())
        starts = ManySets(*parts)
        with ctx.workprec(_BITS):
            return all(
                motions.lead(starts, name, (), lambda _, *box: grid.covered(sums, *box))
                for name in whole
            )

    return lead


def _motions(content: dict[str, Any]) -> ManyMotions:
    """Return the first-arrival map of sets of states to the section that the file states."""
    section = StatedSection(
        content["configuration"], tuple(content["phase"]), content["source"], content["boundary"]
    )
    declared = content["declaration"]
    scales = [1.0] * len(declared["states"])
    most = _MORE * content["most"]
    return ManyMotions(
        declared, content["parameters"], section, scales, content["widest"], most, _LONGEST
    )
