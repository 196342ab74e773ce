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
    """Entries for a grid of boxes."""

    exponents: tuple[int, ...]
    first: tuple[int, ...]
    counts: tuple[int, ...]


def grid_of(entries: GridEntries) -> BoxGrid:
    """The grid that a file states.

    `InputError` is raised if it has no boxes or too many, or numbers that doubles do not
    hold.
    """
    return BoxGrid(entries.exponents, entries.first, entries.counts)


def grid_entries(grid: BoxGrid) -> GridEntries:
    """Entries for a grid of boxes."""
    return GridEntries(exponents=grid.exponents, first=grid.first, counts=grid.counts)


def runs(values: NDArray[Any]) -> Runs:
    """Runs of an array (B,) of integers or booleans: each value, and how often it follows."""
    if not values.size:
        return ()
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    lengths = np.diff(np.r_[starts, values.size])
    return tuple((int(values[k]), int(n)) for k, n in zip(starts, lengths, strict=True))


def listed(told: Sequence[tuple[int, int]], size: int) -> NDArray[np.int_]:
    """The array (size,) of integers that `runs` made; `InputError` for another number of boxes."""
    if size > _MOST or any(n < 1 for _, n in told) or sum(n for _, n in told) != size:
        raise InputError("a grid has another number of boxes than is told of")
    return np.repeat([x for x, _ in told] or [0], [n for _, n in told] or [0])
