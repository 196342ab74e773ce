"""Grids of boxes as files state them, and numbers that they state of each box."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.checker.exact import Failure, demand
from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.divided_grid import DividedGrid
from nonsmooth.runtime.core.errors import InputError

__all__ = ["listed", "stated_divided_grid", "stated_grid"]

_LARGEST = 10**8  # boxes of a grid, and of all its levels
_LEVELS = 40
_NUMBERS = 2**40  # of boxes


def stated_grid(entries: Any, size: int) -> BoxGrid:
    """A grid of boxes of some coordinates.

    Parameters
    ----------
    entries : dict or None
        Of a file.
    size : int
        How many coordinates.

    Raises
    ------
    Failure
        If there is no such grid.
    """
    demand(entries is not None, "there is no grid")
    exponents, first, counts = (tuple(entries[x]) for x in ("exponents", "first", "counts"))
    demand(size > 0 and all(len(x) == size for x in (exponents, first, counts)), "no such grid")
    try:
        return BoxGrid(exponents, first, counts)
    except InputError as problem:
        raise Failure(f"no such grid: {problem}") from None


def stated_divided_grid(entries: Any, levels: Sequence[Any], size: int) -> DividedGrid:
    """A grid of which some boxes are divided, in levels.

    Parameters
    ----------
    entries : dict
        Of a file: the grid.
    levels : sequence of runs
        Which cells of each level are divided.
    size : int
        How many coordinates.

    Raises
    ------
    Failure
        If there is no such grid.
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
    """The numbers of all boxes, of runs of them.

    Parameters
    ----------
    runs : sequence of (int, int)
    size : int
        How many boxes there are.

    Returns
    -------
    array of int (size,)

    Raises
    ------
    Failure
        If there are more or fewer.
    """
    fits = all(n > 0 for _, n in runs) and sum(n for _, n in runs) == size <= _LARGEST
    demand(fits, "another number of boxes than the grid has")
    demand(all(abs(x) < _NUMBERS for x, _ in runs), "no such numbers")
    return np.repeat([x for x, _ in runs] or [0], [n for _, n in runs] or [0])
