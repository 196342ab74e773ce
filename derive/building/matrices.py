"""Matrices that are given: of a chain of masses, and arrays of doubles as exact fractions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.parameter import exact
from nonsmooth.derive.errors import DeclarationError

__all__ = ["chain_matrices", "is_array", "square", "values_of_doubles"]

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
    ends = {
        (row, place): sign
        for row in range(len(links))
        for place, sign in ((row + left, -1), (row + left + 1, 1))
        if 0 <= place < count
    }
    stretches = sp.Matrix.from_dok(len(links), count, ends)
    return stretches.T * sp.diag(*map(exact, links)) * stretches


def is_array(given: Any) -> bool:
    """Whether a value is a NumPy array or SciPy sparse matrix of numbers, not of expressions."""
    return hasattr(given, "dtype") and hasattr(given, "shape") and given.dtype.kind != "O"


def values_of_doubles(given: Any, what: str) -> list[sp.Rational]:
    """The exact rational values of a one-dimensional array of doubles."""
    if len(given.shape) != 1:
        raise DeclarationError(f"{what} is no row of numbers: its shape is {given.shape}")
    return list(_fractions(given, what))


def square(given: Any, what: str, size: int, resolved: Any = exact) -> sp.Matrix:
    """A matrix of the given size, each entry passed through `resolved`."""
    if is_array(given):
        matrix = _matrix_of_doubles(given, what)
    else:
        try:
            matrix = given.as_mutable() if isinstance(given, sp.MatrixBase) else sp.Matrix(given)
        except (TypeError, ValueError):
            raise DeclarationError(f"{what} is no matrix: {given!r}") from None
    if matrix.shape != (size, size):
        raise DeclarationError(
            f"{what} is {matrix.rows} x {matrix.cols}, not {size} x {size} as there are coordinates"
        )
    return matrix.applyfunc(resolved)


def _matrix_of_doubles(given: Any, what: str) -> sp.Matrix:
    """A matrix of the exact rational values of a two-dimensional array of doubles."""
    if len(given.shape) != 2:
        raise DeclarationError(f"{what} is no matrix: its shape is {given.shape}")
    if hasattr(given, "tocoo"):
        entries = given.tocoo(copy=True)
        entries.sum_duplicates()
        rows, columns, values = entries.row, entries.col, entries.data
    else:
        rows, columns = given.nonzero()
        values = given[rows, columns]
    places = zip(rows.tolist(), columns.tolist(), strict=True)
    entries = dict(zip(places, _fractions(values, what), strict=True))
    return sp.Matrix.from_dok(*given.shape, entries)


def _fractions(values: Any, what: str) -> Iterable[sp.Rational]:
    if values.dtype.kind not in "biuf":
        raise DeclarationError(f"{what} holds what is no real number")
    try:
        return [sp.Rational(*value.as_integer_ratio()) for value in values.tolist()]
    except (OverflowError, ValueError):
        raise DeclarationError(f"{what} holds an entry that is not finite") from None
