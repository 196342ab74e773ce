"""A grid of parameter points, how it is cut into chunks, and its anchors.

Anchors are the points of a coarse lattice in the whole grid, ends included. Points between
them start from the orbits found there; since the lattice knows nothing of chunks, these are
the same whatever the chunks.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError

__all__ = ["LATTICE", "Axis", "Block", "Grid", "axis_of", "chunk_shape", "linear_axis"]

BLOCK = 1 << 16  # coordinates that are made or stored at a time
_CELLS = {1: 128, 2: 32, 3: 12}  # between anchors along each axis, by the number of axes
_FEWEST_CELLS = 6
LATTICE = f"cells along an axis: {_CELLS[1]}, {_CELLS[2]}, {_CELLS[3]}, {_FEWEST_CELLS}"


@dataclass(frozen=True, eq=False)
class Axis:
    """Values of one parameter: given, or evenly spaced and made when they are asked for.

    Attributes
    ----------
    name : str
    count : int
    first, last : float
    values : array (count,) or None
        None for even spacing, as `numpy.linspace` does it.
    """

    name: str
    count: int
    first: float
    last: float
    values: np.ndarray | None = None

    def part(self, begin: int, end: int) -> np.ndarray:
        """Values from one place up to another.

        Parameters
        ----------
        begin : int
            The first place.
        end : int
            One behind the last place.

        Returns
        -------
        array (n,)
        """
        if self.values is not None:
            return self.values[begin:end]
        if self.count == 1:
            return np.array([self.first])[begin:end]
        step = (self.last - self.first) / (self.count - 1)
        found = np.arange(begin, end) * step + self.first
        if end == self.count and len(found):
            found[-1] = self.last
        return found

    def blocks(self) -> Iterator[tuple[int, np.ndarray]]:
        """All values, so many at a time, each with the place where they begin.

        Yields
        ------
        int, array (n,)
            Where a part begins, and its values.
        """
        for begin in range(0, self.count, BLOCK):
            yield begin, self.part(begin, min(begin + BLOCK, self.count))

    def fingerprint(self) -> str:
        """A hash of the values.

        Returns
        -------
        str
            SHA-256 in hexadecimal digits.
        """
        found = hashlib.sha256()
        for _, part in self.blocks():
            found.update(part.astype("<f8").tobytes())
        return found.hexdigest()


def linear_axis(name: str, first: float, last: float, count: int) -> Axis:
    """Evenly spaced values that are never held all at once.

    Parameters
    ----------
    name : str
        Of the parameter.
    first : float
        In the unit of the parameter.
    last : float
        Larger than `first` where there are several.
    count : int
        Number of values.

    Raises
    ------
    InputError
        If there are none, or if they do not increase.
    """
    if count < 1:
        raise InputError(f"{name}: {count} values are none")
    if not np.isfinite([first, last]).all() or (count > 1 and not first < last):
        raise InputError(f"{name}: {first!r} to {last!r} is no interval")
    if count > 1 and first + (last - first) / (count - 1) == first:
        raise InputError(f"{name}: {count} values from {first!r} to {last!r} are not distinct")
    return Axis(name, count, float(first), float(last))


def axis_of(name: str, values: Any) -> Axis:
    """An axis of given values.

    Parameters
    ----------
    name : str
        Of the parameter.
    values : array (n,) or Axis
        In the unit of the parameter, increasing.

    Raises
    ------
    InputError
        If they are no row of finite numbers, or do not increase strictly.
    """
    if isinstance(values, Axis):
        return values
    try:
        found = np.array(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"the values of {name} are no row of numbers") from None
    if found.ndim != 1 or not found.size or not np.isfinite(found).all():
        raise InputError(f"the values of {name} are no row of finite numbers")
    if not (np.diff(found) > 0).all():
        raise InputError(f"the values of {name} do not increase strictly")
    found.flags.writeable = False
    return Axis(name, found.size, float(found[0]), float(found[-1]), found)


@dataclass(frozen=True, eq=False)
class Block:
    """A chunk of a grid, the points next to it, and where they are between the anchors.

    Attributes
    ----------
    names : tuple of str
        Of the axes.
    points : tuple of array
        Values along each axis, of one more point on either side where the grid goes on.
    margins : tuple of (bool, bool)
        Whether there is one more, before and behind.
    cells : tuple of array of int
        Number of the anchor along each axis at or before each point.
    fractions : tuple of array
        Of the way from there to the next one.
    """

    names: tuple[str, ...]
    points: tuple[np.ndarray, ...]
    margins: tuple[tuple[bool, bool], ...]
    cells: tuple[np.ndarray, ...]
    fractions: tuple[np.ndarray, ...]

    @property
    def values(self) -> dict[str, np.ndarray]:
        """Values of the axes in the chunk: arrays that broadcast to its shape."""
        inner = zip(self.points, self.inner, strict=True)
        return dict(zip(self.names, np.ix_(*(row[here] for row, here in inner)), strict=True))

    @property
    def wide_values(self) -> dict[str, np.ndarray]:
        """The same for all points."""
        return dict(zip(self.names, np.ix_(*self.points), strict=True))

    @property
    def inner(self) -> tuple[slice, ...]:
        """Which of the points are those of the chunk."""
        return tuple(
            slice(int(before), len(row) - int(behind))
            for row, (before, behind) in zip(self.points, self.margins, strict=True)
        )


@dataclass(frozen=True, eq=False)
class Grid:
    """All combinations of the values of some axes, in chunks.

    Attributes
    ----------
    axes : tuple of Axis
    chunk : tuple of int
        Points of a chunk along each axis; the last ones may be shorter.
    """

    axes: tuple[Axis, ...]
    chunk: tuple[int, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the axes."""
        return tuple(axis.name for axis in self.axes)

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each axis."""
        return tuple(axis.count for axis in self.axes)

    @property
    def points(self) -> int:
        """Number of points."""
        return prod(self.shape)

    @property
    def chunk_counts(self) -> tuple[int, ...]:
        """Chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunk, strict=True))

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return prod(self.chunk_counts)

    def place(self, number: int) -> tuple[int, ...]:
        """Place of a chunk along each axis.

        Parameters
        ----------
        number : int
            Of the chunk.
        """
        return tuple(int(i) for i in np.unravel_index(number, self.chunk_counts))

    def region(self, number: int) -> tuple[slice, ...]:
        """Points of a chunk.

        Parameters
        ----------
        number : int
            Of the chunk.

        Returns
        -------
        tuple of slice
            One for each axis.
        """
        return tuple(
            slice(i * c, min((i + 1) * c, n))
            for i, c, n in zip(self.place(number), self.chunk, self.shape, strict=True)
        )

    @property
    def anchors(self) -> tuple[np.ndarray, ...]:
        """Places of the anchors along each axis: evenly spaced but for the last one."""
        dimensions = sum(axis.count > 1 for axis in self.axes)
        cells = _CELLS.get(dimensions, _FEWEST_CELLS)
        found = []
        for axis in self.axes:
            step = max(1, -(-(axis.count - 1) // cells))
            number = -(-(axis.count - 1) // step) + 1
            found.append(np.minimum(np.arange(number) * step, axis.count - 1))
        return tuple(found)

    @property
    def anchor_values(self) -> dict[str, np.ndarray]:
        """Values of the axes at the anchors: arrays that broadcast to the lattice's shape."""
        rows = [_values_at(axis, row) for axis, row in zip(self.axes, self.anchors, strict=True)]
        return dict(zip(self.names, np.ix_(*rows), strict=True))

    def block(self, number: int) -> Block:
        """A chunk with the points next to it.

        Parameters
        ----------
        number : int
            Of the chunk.
        """
        points, margins, cells, fractions = [], [], [], []
        region = self.region(number)
        for axis, here, anchors in zip(self.axes, region, self.anchors, strict=True):
            start, stop = max(here.start - 1, 0), min(here.stop + 1, axis.count)
            last = max(len(anchors) - 2, 0)
            cell = np.clip(np.searchsorted(anchors, np.arange(start, stop), "right") - 1, 0, last)
            lower = _values_at(axis, anchors[cell])
            upper = _values_at(axis, anchors[np.minimum(cell + 1, len(anchors) - 1)])
            row = axis.part(start, stop)
            width = np.where(upper > lower, upper - lower, 1.0)
            points.append(row)
            margins.append((start < here.start, stop > here.stop))
            cells.append(cell)
            fractions.append((row - lower) / width)
        return Block(self.names, tuple(points), tuple(margins), tuple(cells), tuple(fractions))

    def corner(self) -> Grid:
        """One corner as a grid of its own.

        Returns
        -------
        Grid
            One point: the first value of each axis.
        """
        axes = tuple(linear_axis(axis.name, axis.first, axis.first, 1) for axis in self.axes)
        return Grid(axes, (1,) * len(axes))


def _values_at(axis: Axis, places: np.ndarray) -> np.ndarray:
    """Values of an axis at some places, each as any part of the axis has it."""
    distinct, which = np.unique(places, return_inverse=True)
    return np.concatenate([axis.part(int(k), int(k) + 1) for k in distinct])[which]


def chunk_shape(counts: Sequence[int], points: int) -> tuple[int, ...]:
    """About as many points along each axis as along the others, and no more than so many.

    Parameters
    ----------
    counts : sequence of int
        Points along each axis.
    points : int
        The most points of a chunk.

    Returns
    -------
    tuple of int
        Points of a chunk along each axis.
    """
    shape, left = [0] * len(counts), points
    order = sorted(range(len(counts)), key=lambda k: counts[k])
    for done, place in enumerate(order):
        side = int(left ** (1 / (len(counts) - done)) + 1e-9)
        shape[place] = max(1, min(counts[place], side))
        left //= shape[place]
    return tuple(shape)
