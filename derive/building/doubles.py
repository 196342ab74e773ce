"""NumPy arrays and SciPy sparse matrices as the binary fractions that they hold."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from nonsmooth.derive.errors import DeclarationError

__all__ = ["is_array", "matrix_of_doubles", "values_of_doubles"]


def is_array(given: Any) -> bool:
    """Whether a value is a NumPy array or SciPy sparse matrix of numbers, not of expressions."""
    return hasattr(given, "dtype") and hasattr(given, "shape") and given.dtype.kind != "O"


def matrix_of_doubles(given: Any, what: str) -> sp.Matrix:
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


def values_of_doubles(given: Any, what: str) -> list[sp.Rational]:
    """The exact rational values of a one-dimensional array of doubles."""
    if len(given.shape) != 1:
        raise DeclarationError(f"{what} is no row of numbers: its shape is {given.shape}")
    return list(_fractions(given, what))


def _fractions(values: Any, what: str) -> Iterable[sp.Rational]:
    if values.dtype.kind not in "biuf":
        raise DeclarationError(f"{what} holds what is no real number")
    try:
        return [sp.Rational(*value.as_integer_ratio()) for value in values.tolist()]
    except (OverflowError, ValueError):
        raise DeclarationError(f"{what} holds an entry that is not finite") from None
