"""Grids of boxes in files, and what is said of each box: runs of one number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError

__all__ = ["GridEntries", "Runs", "grid_entries", "grid_of", "listed", "runs"]

Runs = tuple[tuple[int, int], ...]

_MOST = 10**8  # boxes of a grid


@dataclass(frozen=True, kw_only=True)
class GridEntries:
    """What a file states of a grid of boxes."""

    exponents: tuple[int, ...]
    first: tuple[int, ...]
    counts: tuple[int, ...]


def grid_of(entries: GridEntries) -> BoxGrid:
    """The grid that a file states.

    Raises
    ------
    InputError
        If it has too many boxes, or none, or doubles do not hold them.
    """
    return BoxGrid(entries.exponents, entries.first, entries.counts)


def grid_entries(grid: BoxGrid) -> GridEntries:
    """What a file states of a grid."""
    return GridEntries(exponents=grid.exponents, first=grid.first, counts=grid.counts)


def runs(values: NDArray[Any]) -> Runs:
    """Numbers, each with how often it follows.

    Parameters
    ----------
    values : array of int or bool (B,)

    Returns
    -------
    tuple of (int, int)
    """
    if not values.size:
        return ()
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    lengths = np.diff(np.r_[starts, values.size])
    return tuple((int(values[k]), int(n)) for k, n in zip(starts, lengths, strict=True))


def listed(told: Sequence[tuple[int, int]], size: int) -> NDArray[np.int_]:
    """The numbers of all boxes.

    Parameters
    ----------
    told : sequence of (int, int)
        As `runs` gives them.
    size : int
        How many boxes there are.

    Returns
    -------
    array of int (size,)

    Raises
    ------
    InputError
        If there are more or fewer.
    """
    if size > _MOST or any(n < 1 for _, n in told) or sum(n for _, n in told) != size:
        raise InputError("a grid has another number of boxes than is told of")
    return np.repeat([x for x, _ in told] or [0], [n for _, n in told] or [0])
