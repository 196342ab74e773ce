"""A grid of parameter points, and how it is cut into chunks."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.errors import InputError

__all__ = ["Axis", "Grid", "axis_of", "chunk_shape", "linear_axis"]

BLOCK = 1 << 16  # coordinates that are made or stored at a time


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
        """Values from one place up to another."""
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
        """All values, so many at a time, each with the place where they begin."""
        for begin in range(0, self.count, BLOCK):
            yield begin, self.part(begin, min(begin + BLOCK, self.count))

    def fingerprint(self) -> str:
        """A hash of the values."""
        found = hashlib.sha256()
        for _, part in self.blocks():
            found.update(part.astype("<f8").tobytes())
        return found.hexdigest()


def linear_axis(name: str, first: float, last: float, count: int) -> Axis:
    """Evenly spaced values that are never held all at once.

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
        return int(np.prod(self.shape, dtype=np.int64))

    @property
    def chunk_counts(self) -> tuple[int, ...]:
        """Chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunk, strict=True))

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return int(np.prod(self.chunk_counts, dtype=np.int64))

    def place(self, number: int) -> tuple[int, ...]:
        """Place of a chunk along each axis."""
        return tuple(int(i) for i in np.unravel_index(number, self.chunk_counts))

    def region(self, number: int) -> tuple[slice, ...]:
        """Points of a chunk."""
        return tuple(
            slice(i * c, min((i + 1) * c, n))
            for i, c, n in zip(self.place(number), self.chunk, self.shape, strict=True)
        )

    def values(self, number: int) -> dict[str, np.ndarray]:
        """Values of the axes in a chunk: arrays that broadcast to its shape."""
        parts = [
            axis.part(here.start, here.stop)
            for axis, here in zip(self.axes, self.region(number), strict=True)
        ]
        return dict(zip(self.names, np.ix_(*parts), strict=True))

    def first_point(self) -> Mapping[str, np.ndarray]:
        """Values at one corner, as those of a chunk of one point."""
        ones = (1,) * len(self.axes)
        return {axis.name: np.full(ones, axis.first) for axis in self.axes}


def chunk_shape(counts: Sequence[int], points: int) -> tuple[int, ...]:
    """About as many points along each axis as along the others, and no more than so many."""
    shape, left = [0] * len(counts), points
    order = sorted(range(len(counts)), key=lambda k: counts[k])
    for done, place in enumerate(order):
        side = int(left ** (1 / (len(counts) - done)) + 1e-9)
        shape[place] = max(1, min(counts[place], side))
        left //= shape[place]
    return tuple(shape)
