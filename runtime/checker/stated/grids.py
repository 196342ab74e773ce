"""Grids of boxes as files state them, and numbers that they state of each box."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.checker.stated.exact import Failure, demand
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError

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
