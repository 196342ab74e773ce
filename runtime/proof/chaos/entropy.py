"""The spectral radius of a graph, bounded from below without rounding.

For a matrix A of integers that are not negative, irreducible, and a vector v of positive ones

    min over i of (A v)_i / v_i <= spectral radius

(L. Collatz, 1942; H. Wielandt, 1950). The vector is found in double precision; the bound is a
rational number.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import ROUND_DOWN, Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from flint import arb

__all__ = ["growth", "logarithm_below"]

_SCALE = 10**6  # of the vector's entries
_ROUNDS = 200
_DIGITS = 6  # of a logarithm


def growth(
    size: int, edges: Iterable[tuple[int, int]]
) -> tuple[Fraction, tuple[int, ...], tuple[int, ...]]:
    """A lower bound of the spectral radius of a graph, with vertices and weights that prove it.

    The vertices are of one strongly connected part, and their weights are positive. The bound is
    0 where there is no cycle.

    Examples
    --------
    >>> growth(2, [(0, 0), (0, 1), (1, 0), (1, 1)])
    (Fraction(2, 1), (0, 1), (1, 1))
    """
    matrix = np.zeros((size, size), dtype=int)
    for i, j in edges:
        matrix[i, j] = 1
    best: tuple[Fraction, tuple[int, ...], tuple[int, ...]] = (Fraction(0), (), ())
    for part in _strong_components(matrix):
        block = matrix[np.ix_(part, part)]
        if not block.any():
            continue
        found, weights = _bound(block)
        if found > best[0]:
            best = (found, tuple(part), weights)
    return best


def logarithm_below(bound: Fraction, iterates: int) -> str:
    """The logarithm of a growth above 1, for each iterate, rounded down, as a decimal text."""
    from flint import arb, fmpq

    exact: arb = arb(fmpq(bound.numerator, bound.denominator)).log() / iterates
    below = Decimal(exact.lower().str(30, radius=False)) * (1 - Decimal(10) ** -20)
    return str(below.quantize(Decimal(10) ** (below.adjusted() + 1 - _DIGITS), ROUND_DOWN))


def _strong_components(matrix: np.ndarray) -> list[list[int]]:
    """The strongly connected parts of a graph, each in order.

    The matrix (n, n) is not zero where there is an edge.
    """
    size = len(matrix)
    reach = (matrix != 0) | np.eye(size, dtype=bool)
    for k in range(size):
        reach |= np.outer(reach[:, k], reach[k])
    both = reach & reach.T
    return [np.flatnonzero(row).tolist() for k, row in enumerate(both) if np.argmax(row) == k]


def _bound(block: np.ndarray) -> tuple[Fraction, tuple[int, ...]]:
    """The bound of Collatz and Wielandt for an irreducible matrix, and its vector near Perron's."""
    vector = np.ones(len(block))
    for _ in range(_ROUNDS):
        vector = (block + np.eye(len(block))) @ vector
        vector /= vector.max()
    found = (Fraction(0), tuple[int, ...]())
    for scale in (1, 10, 1000, _SCALE):
        weights = [max(1, round(scale * x)) for x in vector.tolist()]
        bound = min(_quotients(block.tolist(), weights))
        if bound > found[0]:
            found = (bound, tuple(weights))
    return found


def _quotients(rows: Sequence[Sequence[int]], weights: Sequence[int]) -> Iterable[Fraction]:
    for row, weight in zip(rows, weights, strict=True):
        yield Fraction(sum(a * w for a, w in zip(row, weights, strict=True)), weight)
