"""In which order the tiles of a box of starts are looked at."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid

__all__ = ["next_tiles"]

_SEED = 20
_SAMPLED = 64  # of so many tiles one is looked at, wherever it is, before the best are
_BLOCK = 4  # tiles along each coordinate
_AT_ONCE = 4  # of so many tiles of a block one is taken at most, until the share is known anew
_AROUND = 4.0  # tiles: what the blocks around one count in its share


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
