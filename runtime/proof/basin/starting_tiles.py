"""Tiles of a box of starts: in which order they are looked at, and which are proved attracted."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.sets.branching import BranchingMap
from nonsmooth.runtime.proof.sets.sections import MapSection
from nonsmooth.runtime.proof.sets.told_question import ToldQuestion

__all__ = ["BITS", "begin_tiles", "branching_map", "next_tiles"]

BITS = 64  # of flows, before they are rounded to doubles
_LONGEST = 16  # transitions from a tile to the section
_SEED = 20
_SAMPLED = 64  # of so many tiles one is looked at, wherever it is, before the best are
_BLOCK = 4  # tiles along each coordinate
_AT_ONCE = 4  # of so many tiles of a block one is taken at most, until the share is known anew
_AROUND = 4.0  # tiles: what the blocks around one count in its share


def branching_map(
    system: EnclosedSystem, section: MapSection, widest: float, most: int
) -> BranchingMap:
    """The map from sets of states to the section of a basin.

    Sets wider than `widest` are divided on the way, into at most `most` parts of one set.
    """
    scales = np.ones(len(system.structure.states))
    return BranchingMap(system, section, scales, widest, most, _LONGEST, 1.0)


def begin_tiles(
    question: ToldQuestion[BasinCertificate],
) -> Callable[[NDArray[np.int_]], NDArray[np.bool_]]:
    """A function that tells which tiles are proved to send every motion to boxes that are known.

    It takes numbers of tiles (B,) and gives bools (B,).
    """
    known = question.known
    grid, tiles = known.grid, known.tiles
    assert grid is not None
    assert tiles is not None
    system, section = question.taken_up(BITS)
    with flint_precision(BITS):
        mapped = branching_map(system, section, known.widest, known.most)
    sums = grid.sums(known.ranks >= 0)
    free = [c for c, held in enumerate(system.structure.constraints) if not held]
    nothing = Invariants((), ())

    def attracted(numbers: NDArray[np.int_]) -> NDArray[np.bool_]:
        states = _timed(tiles.sets(numbers))
        good = np.ones(len(numbers), dtype=bool)
        with flint_precision(BITS):
            for configuration in free:
                left = np.flatnonzero(good)
                leaves = mapped.leaves_of(
                    states[left], configuration, nothing, lambda *box: grid.covered(sums, *box)
                )
                good[left[leaves.lost]] = False
        return good

    return attracted


def _timed(boxes: ManySets) -> ManySets:
    """States (y, 1) at the time 0: (y, 0, 1)."""
    parts = (np.insert(x, x.shape[1] - 1, 0.0, axis=1) for x in vars(boxes).values())
    return ManySets(*parts)


def next_tiles(
    tiles: BoxGrid, looked: NDArray[np.bool_], attracted: NDArray[np.bool_], count: int
) -> NDArray[np.int_]:
    """Numbers of at most `count` tiles to look at next.

    First they are a random sample, then tiles where most have been attracted so far. Of blocks of
    tiles the share that is attracted is estimated from those of the block and of the blocks
    around it. The order decides how soon much is proved, and nothing else. `looked` and
    `attracted` have a bool for each tile.
    """
    from scipy.ndimage import uniform_filter

    left = np.flatnonzero(~looked)
    random = np.random.default_rng([_SEED, len(left)])
    sampled = len(tiles) // _SAMPLED - int(looked.sum())
    if sampled > 0:
        return random.permutation(left)[: min(count, sampled)]
    blocks = tuple(-(-n // _BLOCK) for n in tiles.counts)
    places = np.stack(np.unravel_index(np.arange(len(tiles)), tiles.counts)) // _BLOCK
    block = np.ravel_multi_index(tuple(places), blocks)
    size = int(np.prod(blocks))
    seen, good = (
        np.bincount(block, weights=flags, minlength=size).reshape(blocks)
        for flags in (looked, attracted)
    )
    wide_seen, wide_good = (uniform_filter(x, 3, mode="constant") for x in (seen, good))
    around = wide_good / np.maximum(wide_seen, 1e-9)
    share = ((good + _AROUND * around) / (seen + _AROUND)).reshape(-1)
    own = block[left]
    order = np.lexsort((random.random(len(left)), own, -share[own]))
    ranked = own[order]
    begins = np.flatnonzero(np.r_[True, ranked[1:] != ranked[:-1]])
    place = np.arange(len(ranked)) - np.repeat(begins, np.diff(np.r_[begins, len(ranked)]))
    taken = order[place < max(1, _BLOCK ** len(blocks) // _AT_ONCE)]
    chosen: NDArray[np.int_] = left[taken[:count]]
    return chosen
