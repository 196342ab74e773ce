"""The spectral radius of a graph, bounded from below without rounding, as the checker bounds it."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import ROUND_DOWN, Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.checker.state_sets.chaos import radius_above

if TYPE_CHECKING:
    from flint import arb

__all__ = ["growth", "logarithm_below"]

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
    from flint import arb, fmpq

    exact: arb = arb(fmpq(bound.numerator, bound.denominator)).log() / iterates
    below = Decimal(exact.lower().str(30, radius=False)) * (1 - Decimal(10) ** -20)
    return str(below.quantize(Decimal(10) ** (below.adjusted() + 1 - _DIGITS), ROUND_DOWN))
