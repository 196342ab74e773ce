"""Matrices of a chain of masses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.parameter import exact
from nonsmooth.derive.errors import DeclarationError

__all__ = ["chain_matrices"]

_MORE_LINKS = {"none": -1, "left": 0, "right": 0, "both": 1}


def chain_matrices(
    masses: Sequence[Any],
    springs: Sequence[Any],
    dampers: Sequence[Any] | None = None,
    fixed: str = "left",
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Mass, stiffness and damping matrix of masses in a row, joined by springs and dampers.

    Parameters
    ----------
    masses : n values
    springs, dampers : n values, n + 1 with both ends fixed, n - 1 with none
        From left to right; each damper beside its spring, all zero when omitted.
    fixed : {"left", "right", "both", "none"}
        Which ends are tied to the ground, by the first and the last spring.

    Returns
    -------
    mass, stiffness, damping : n x n matrices

    Raises
    ------
    DeclarationError
        For an unknown end, or a wrong number of springs or dampers.

    Examples
    --------
    >>> chain_matrices([1, 2], [3, 4])[1]
    Matrix([
    [ 7, -4],
    [-4,  4]])
    """
    if fixed not in _MORE_LINKS:
        raise DeclarationError(f"fixed is {fixed!r}, not one of {', '.join(_MORE_LINKS)}")
    count = len(masses)
    links = count + _MORE_LINKS[fixed]
    if count == 0:
        raise DeclarationError("a chain needs a mass")
    if dampers is None:
        dampers = [0] * links
    for what, values in (("springs", springs), ("dampers", dampers)):
        if len(values) != links:
            raise DeclarationError(
                f"a chain of {count} masses, fixed {fixed!r}, has {links} {what}, not {len(values)}"
            )
    left = -1 if fixed in ("left", "both") else 0
    mass = sp.diag(*map(exact, masses))
    return mass, _joined(springs, count, left), _joined(dampers, count, left)


def _joined(links: Sequence[Any], count: int, left: int) -> sp.Matrix:
    """Matrix (count x count) of a chain of links, each of which acts between two neighbours.

    The first link joins the masses `left` and `left` + 1; one out of range is the ground.
    """
    total: dict[tuple[int, int], sp.Expr] = {}
    for place, link in enumerate(map(exact, links), start=left):
        ends = [(j, sign) for j, sign in ((place, -1), (place + 1, 1)) if 0 <= j < count]
        for i, first in ends:
            for j, second in ends:
                total[i, j] = total.get((i, j), sp.S.Zero) + first * second * link
    return sp.Matrix.from_dok(count, count, total)
