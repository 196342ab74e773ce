"""The first derivative of an affine function that is not zero, in any arithmetic.

What a function does behind an instant is told by the first of its derivatives along a field
that is not zero there. Doubles tell a sign by a bound on their error (`Located`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import accumulate, islice, repeat
from operator import mul
from typing import Any, NamedTuple, TypeVar

import numpy as np

UNIT = 2.0**-48  # 16 eps, the rounding of a sum of products by that of absolute values

R = TypeVar("R")
Vector = Sequence[Any] | np.ndarray


class Leading(NamedTuple):
    """The first derivative that is not zero."""

    order: int
    sign: int  # 1 or -1 as the arithmetic told it, or 1 where it is only known not to be zero


def leading(
    functions: Iterable[R], sign: Callable[[int, R], int], first: int = 0
) -> Leading | None:
    """The first derivative that is not zero; None where all are.

    `functions` are the derivatives from order 0 on, as rows or as values; no more are made
    than needed. `sign` gives the sign of a derivative from its order and itself, 0 where it
    is zero. Derivatives of order below `first` are known to be zero.

    Examples
    --------
    >>> leading([0.0, -2.0, 5.0], lambda order, value: (value > 0) - (value < 0))
    Leading(order=1, sign=-1)
    """
    for order, function in enumerate(functions):
        if order >= first and (found := sign(order, function)):
            return Leading(order, found)
    return None


def derivatives(row: np.ndarray, field: np.ndarray, count: int) -> Iterator[np.ndarray]:
    """An affine function and its derivatives along a field, `count` rows order by order.

    The row (..., N + 1) and the field (N, N + 1), or one for each row (..., N, N + 1), act on
    (y, 1). Where the first N + 1 are zero, so are all others.
    """
    return islice(accumulate(repeat(field), _rate, initial=row), count)


def _rate(row: np.ndarray, field: np.ndarray) -> np.ndarray:
    return np.asarray(np.einsum("...i,...ij->...j", row[..., :-1], field))


def dot(row: Iterable[Any], vector: Iterable[Any]) -> Any:
    """Sum of the products of the entries of two vectors."""
    return sum(map(mul, row, vector))


Row = tuple[float, ...]


def rows_of(array: np.ndarray) -> list[Row]:
    """Rows of an array (n, m) as tuples of Python numbers."""
    return [tuple(row) for row in array.tolist()]


def orders(row: np.ndarray, field: np.ndarray, count: int) -> tuple[list[Row], list[Row]]:
    """Derivatives of an affine function along a field, order by order, and their sizes.

    The row is (N + 1,), the field (N, N + 1). Both results are `count` rows of N + 1 numbers,
    those of the function first; sizes are sums of absolute values.
    """
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite judges no start
        values = list(derivatives(row, field, count))
        bounds = list(derivatives(abs(row), abs(field), count))
    return rows_of(np.array(values)), rows_of(np.array(bounds))


class Located(NamedTuple):
    """A state at an event, extended by 1, and how well it is known."""

    state: Vector  # N + 1 numbers
    sizes: Vector  # N + 1 sums of absolute values behind the coordinates
    # change of the state within the error of the time, along the field that led there
    moved: Vector
    error: float  # of the time

    def leading(
        self, rows: Sequence[Sequence[Any]], bounds: Sequence[Sequence[Any]], first: int = 0
    ) -> Leading | None:
        """The first derivative that is not zero beyond its error; None if there is none.

        `rows` are the function and its derivatives along a field, one more than is judged;
        `bounds` are the sums of absolute values behind their entries. Derivatives of order below
        `first` are known to be zero.
        """

        def sign(order: int, row: Sequence[Any]) -> int:
            value = dot(row, self.state)
            # the time errs: the state may have moved on along either field
            ahead = self.error * abs(dot(rows[order + 1], self.state))
            drift = max(ahead, abs(dot(row, self.moved)))
            if abs(value) > UNIT * dot(bounds[order], self.sizes) + drift:
                return 1 if value > 0 else -1
            return 0

        return leading(rows[:-1], sign, first)

    def signs(self, rows: np.ndarray, bounds: np.ndarray, field: np.ndarray) -> np.ndarray:
        """Signs (k,) of the leading derivatives of functions (k, N + 1) along a field, 0 for none.

        `bounds` (k, N + 1) are the sums of absolute values behind the entries of the rows; the
        field is (N, N + 1). It is `leading` for functions that no table holds, with one product
        for all of them.
        """

        def judged() -> Iterator[tuple[np.ndarray, np.ndarray]]:
            count = len(self.state)
            every = derivatives(rows, field, count + 1)
            behind, row = derivatives(bounds, abs(field), count), next(every)
            for following, bound in zip(every, behind, strict=True):
                ahead = self.error * abs(following @ self.state)
                drift = np.maximum(ahead, abs(row @ self.moved))
                yield row @ self.state, UNIT * (bound @ self.sizes) + drift
                row = following

        return leading_signs(judged())


def leading_signs(judged: Iterable[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Signs of the leading derivatives of many functions or states at once, 0 for none.

    `judged` gives values and their errors, from order 0 on; the signs have their shape. It is
    `leading` for arrays: state by state the starts of a sweep take 60 times as long.
    """
    signs: np.ndarray | None = None
    for values, errors in judged:
        here = (values > errors).astype(int) - (values < -errors)
        signs = here if signs is None else np.where(signs, signs, here)
        if signs.all():
            break
    assert signs is not None
    return signs
