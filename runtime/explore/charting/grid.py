"""A grid of parameter points, how it is cut into chunks, and its anchors.

Anchors are the points of a coarse lattice in the whole grid, ends included. Points between
them start from the orbits found there; since the lattice knows nothing of chunks, these are
the same whatever the chunks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError

_CELLS = {1: 128, 2: 32, 3: 12}  # between anchors along each axis, by the number of axes
_FEWEST_CELLS = 6
LATTICE = f"cells along an axis: {_CELLS[1]}, {_CELLS[2]}, {_CELLS[3]}, {_FEWEST_CELLS}"


Axes = Mapping[str, np.ndarray]
"""Values of each swept name, which increase strictly, in the order of the dimensions."""


def axis_of(name: str, values: Any) -> np.ndarray:
    """Given values (n,) of an axis, which have to be finite and to increase strictly."""
    try:
        found = np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"the values of {name} are no row of numbers") from None
    row = found.ndim == 1 and found.size and np.isfinite(found).all()
    if not row or np.ma.is_masked(values):
        raise InputError(f"the values of {name} are no row of finite numbers")
    if not (np.diff(found) > 0).all():
        raise InputError(f"the values of {name} do not increase strictly")
    found.flags.writeable = False
    return found


@dataclass(frozen=True, eq=False)
class Block:
    """A chunk of a grid, the points next to it, and their places between the anchors."""

    names: tuple[str, ...]  # of the axes
    # values along each axis, with one more point on either side where the grid goes on
    points: tuple[np.ndarray, ...]
    inner: tuple[slice, ...]  # of the points that belong to the chunk itself
    cells: tuple[np.ndarray, ...]  # number of the anchor at or before each point, along each axis
    # position of each point between that anchor (0) and the next one (1)
    fractions: tuple[np.ndarray, ...]

    @property
    def values(self) -> dict[str, np.ndarray]:
        """Values of the axes in the chunk: arrays that broadcast to its shape."""
        inner = zip(self.points, self.inner, strict=True)
        return dict(zip(self.names, np.ix_(*(row[here] for row, here in inner)), strict=True))

    @property
    def wide_values(self) -> dict[str, np.ndarray]:
        """Values of the axes in the chunk and next to it: arrays that broadcast to one shape."""
        return dict(zip(self.names, np.ix_(*self.points), strict=True))


@dataclass(frozen=True, eq=False)
class Grid:
    """All combinations of the values of some axes, in chunks."""

    axes: Axes
    chunk: tuple[int, ...]  # points of a chunk along each axis; the last chunks may be shorter

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the axes."""
        return tuple(self.axes)

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each axis."""
        return tuple(map(len, self.axes.values()))

    @property
    def chunk_counts(self) -> tuple[int, ...]:
        """Chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunk, strict=True))

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return prod(self.chunk_counts)

    def place(self, number: int) -> tuple[int, ...]:
        """Place of a chunk along each axis, from its number."""
        return tuple(int(i) for i in np.unravel_index(number, self.chunk_counts))

    def region(self, number: int) -> tuple[slice, ...]:
        """Slices of the points of a chunk along each axis, from its number."""
        return tuple(
            slice(i * c, min((i + 1) * c, n))
            for i, c, n in zip(self.place(number), self.chunk, self.shape, strict=True)
        )

    @property
    def anchors(self) -> tuple[np.ndarray, ...]:
        """Places of the anchors along each axis: evenly spaced but for the last one."""
        cells = _CELLS.get(sum(count > 1 for count in self.shape), _FEWEST_CELLS)
        found = []
        for count in self.shape:
            step = max(1, -(-(count - 1) // cells))
            found.append(np.append(np.arange(0, count - 1, step), count - 1))
        return tuple(found)

    @property
    def anchor_values(self) -> dict[str, np.ndarray]:
        """Values of the axes at the anchors: arrays that broadcast to the lattice's shape."""
        rows = (row[places] for row, places in zip(self.axes.values(), self.anchors, strict=True))
        return dict(zip(self.names, np.ix_(*rows), strict=True))

    def block(self, number: int) -> Block:
        """A chunk, from its number, with the points next to it."""
        points, inner, cells, fractions = [], [], [], []
        region = self.region(number)
        for axis, here, anchors in zip(self.axes.values(), region, self.anchors, strict=True):
            start, stop = max(here.start - 1, 0), min(here.stop + 1, len(axis))
            last = max(len(anchors) - 2, 0)
            cell = np.clip(np.searchsorted(anchors, np.arange(start, stop), "right") - 1, 0, last)
            lower = axis[anchors[cell]]
            upper = axis[anchors[np.minimum(cell + 1, len(anchors) - 1)]]
            row = axis[start:stop]
            width = np.where(upper > lower, upper - lower, 1.0)
            points.append(row)
            inner.append(slice(here.start - start, here.stop - start))
            cells.append(cell)
            fractions.append((row - lower) / width)
        return Block(self.names, tuple(points), tuple(inner), tuple(cells), tuple(fractions))


def chunk_shape(counts: Sequence[int], points: int) -> tuple[int, ...]:
    """Shape of a chunk with at most `points` points and sides as equal as the counts allow.

    `counts` are the points of the grid along each axis.
    """
    shape, left = [0] * len(counts), points
    order = sorted(range(len(counts)), key=lambda k: counts[k])
    for done, place in enumerate(order):
        side = int(left ** (1 / (len(counts) - done)) + 1e-9)
        shape[place] = max(1, min(counts[place], side))
        left //= shape[place]
    return tuple(shape)
