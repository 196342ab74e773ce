"""Sets with a direction that is stretched: parallelepipeds on a section.

An h-set is N = {c + A x, |x_i| <= 1} (P. Zgliczynski and M. Gidea, Covering relations for
multidimensional dynamical systems, J. Differential Equations 202, 2004), here with the first
of its coordinates unstable and the others stable. What follows from which of them cover which is
the growth of a graph, bounded from below without rounding, as the checker bounds it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import ROUND_DOWN, Decimal
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from flint import arb, fmpq

from nonsmooth.runtime.checker.state_sets.chaos import radius_above
from nonsmooth.runtime.core.json_codec import Exact

if TYPE_CHECKING:
    from nonsmooth.runtime.checker.state_sets.sets import StateSet

_SHORT = 10**6  # denominator of a bound, at most
_DIGITS = 6  # of a logarithm


def growth(size: int, edges: Iterable[tuple[int, int]]) -> tuple[Fraction, tuple[int, ...]]:
    """A lower bound of the spectral radius of a graph, with the vertices of its part that has it.

    The part is strongly connected. The bound is 0 where there is no cycle.

    Examples
    --------
    >>> growth(2, [(0, 0), (0, 1), (1, 0), (1, 1)])
    (Fraction(2, 1), (0, 1))
    """
    from scipy.sparse.csgraph import connected_components

    matrix = np.zeros((size, size), dtype=int)
    for i, j in edges:
        matrix[i, j] = 1
    _, labels = connected_components(matrix, connection="strong")
    best: tuple[Fraction, tuple[int, ...]] = (Fraction(0), ())
    for label in dict.fromkeys(labels.tolist()):
        part = np.flatnonzero(labels == label).tolist()
        targets = {i: [j for j in part if matrix[i, j]] for i in part}
        if any(targets.values()):
            bound = Fraction(int(radius_above(targets) * _SHORT), _SHORT)
            best = max(best, (bound, tuple(part)), key=lambda found: found[0])
    return best


def logarithm_below(bound: Fraction, iterates: int) -> str:
    """The logarithm of a growth above 1, for each iterate, rounded down, as a decimal text."""
    exact: arb = arb(fmpq(bound.numerator, bound.denominator)).log() / iterates
    below = Decimal(exact.lower().str(30, radius=False)) * (1 - Decimal(10) ** -20)
    return str(below.quantize(Decimal(10) ** (below.adjusted() + 1 - _DIGITS), ROUND_DOWN))


@dataclass(frozen=True)
class HSet:
    """A parallelepiped on a section: decimal texts or fractions, exactly."""

    name: str
    centre: tuple[Exact, ...]  # in the coordinates of the section
    # each in the coordinates of the section: the first one is stretched
    sides: tuple[tuple[Exact, ...], ...]

    @cached_property
    def near(self) -> tuple[np.ndarray, np.ndarray]:
        """Approximate centre (d,) and sides as columns (d, d)."""
        sides = [[float(Fraction(x)) for x in side] for side in self.sides]
        return np.array([float(Fraction(x)) for x in self.centre]), np.array(sides).T

    @property
    def corners(self) -> np.ndarray:
        """Approximate corners (2^d, d), those of two coordinates around their parallelogram."""
        centre, sides = self.near
        signs = np.array(np.meshgrid(*[[-1.0, 1.0]] * len(centre), indexing="ij"))
        signs = signs.reshape(len(centre), -1).T
        if len(centre) == 2:
            signs = signs[[0, 1, 3, 2]]
        return np.asarray(centre + signs @ sides.T)


def grid_in_cube(size: int, line: int, across: int) -> np.ndarray:
    """Points (n, size) of [-1, 1]^size: `line` along the first axis, `across` along each other."""
    axes = [np.linspace(-1, 1, line), *[np.linspace(-1, 1, across)] * (size - 1)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, size)


def decimal_set(name: str, centre: Sequence[float], sides: np.ndarray, digits: int = 7) -> HSet:
    """An h-set with decimal numbers near one in double precision.

    `centre` is (d,), `sides` (d, d) as columns. Each side has so many digits relative to its
    length, the centre relative to the shortest side. Lengths are measured in units of the
    coordinates' extents.
    """
    extents = np.abs(sides).max(axis=1)
    lengths = np.linalg.norm(sides / extents[:, None], axis=0)
    return HSet(
        name,
        tuple(
            _text(x, lengths.min() * unit, digits) for x, unit in zip(centre, extents, strict=True)
        ),
        tuple(
            tuple(_text(x, length * unit, digits) for x, unit in zip(side, extents, strict=True))
            for side, length in zip(sides.T, lengths, strict=True)
        ),
    )


def _text(x: float, unit: float, digits: int) -> str:
    """A decimal text that is right to so many digits of a unit."""
    places = digits - 1 - int(np.floor(np.log10(unit)))
    return f"{x:.{max(places, 0)}f}"


def outline(image: StateSet) -> tuple[tuple[float, ...], ...]:
    """Corners of what contains an image, for pictures; none of more than two coordinates."""
    both = zip(image.centre.tolist(), image.sides.tolist(), strict=True)
    columns = [[float(x.mid()) for x in (*middle, *own)] for middle, own in both][:-1]
    spread = [float(abs(x).upper()) for x in image.box.entries()[:-1]]
    if len(columns) == 1:
        (own,) = columns
        reach = sum(map(abs, own[1:])) + spread[0]
        return ((own[0] - reach,), (own[0] + reach,))
    if len(columns) > 2:
        return ()
    centre, *sides = np.array(columns).T
    sides.sort(key=lambda side: -float(np.linalg.norm(side)))
    around = np.abs(sides[2:]).sum(axis=0) + np.array(spread)
    every = np.array([*sides[:2], [around[0], 0.0], [0.0, around[1]]])
    every[(every[:, 1] < 0) | ((every[:, 1] == 0) & (every[:, 0] < 0))] *= -1
    every = every[np.argsort(np.arctan2(every[:, 1], every[:, 0]))]
    steps = 2 * np.concatenate([np.zeros((1, 2)), every, -every[:-1]])
    corners = centre - every.sum(axis=0) + np.cumsum(steps, axis=0)
    return tuple((float(x), float(y)) for x, y in corners)
