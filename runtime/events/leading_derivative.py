"""The first derivative of an affine function that is not zero, in any arithmetic.

What a function does behind an instant is told by the first of its derivatives along a field
that is not zero there. How a sign is told belongs to the arithmetic: doubles and mpmath compare
with a bound on their error (`Located`), balls with zero, exact rows with what is known to be
zero of the state.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import accumulate, islice, repeat
from operator import matmul, mul
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

import numpy as np

from nonsmooth.runtime.model.quasi_polynomials import UNIT

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "Leading",
    "Located",
    "Undecided",
    "Vector",
    "derivatives",
    "dot",
    "leading",
    "leading_signs",
    "square",
]

R = TypeVar("R")
Vector = Sequence[Any] | np.ndarray


class Undecided(Exception):
    """An arithmetic cannot tell a sign.

    Attributes
    ----------
    reason : str
    at : arb or None
        When in the phase; None at its start.
    digits : bool
        More digits may help.
    """

    def __init__(self, reason: str, at: arb | None = None, *, digits: bool = True) -> None:
        super().__init__(reason)
        self.reason, self.at, self.digits = reason, at, digits


class Leading(NamedTuple, Generic[R]):
    """The first derivative that is not zero.

    Attributes
    ----------
    order : int
    sign : int
        What the arithmetic said of it: 1 or -1, or 1 where it is only known not to be zero.
    derivative : R
        As it was given.
    """

    order: int
    sign: int
    derivative: R


def leading(
    functions: Iterable[R], sign: Callable[[int, R], int], first: int = 0
) -> Leading[R] | None:
    """Find the first derivative that is not zero; None where all are.

    Parameters
    ----------
    functions : iterable
        The derivatives from order 0 on, as rows or as values; no more are made than needed.
    sign : callable
        Sign of a derivative, from its order and itself: 0 where it is zero. It raises
        `Undecided` where it cannot tell.
    first : int
        Derivatives of lower order are known to be zero.

    Examples
    --------
    >>> leading([0.0, -2.0, 5.0], lambda order, value: (value > 0) - (value < 0))
    Leading(order=1, sign=-1, derivative=-2.0)
    """
    for order, function in enumerate(functions):
        if order >= first and (found := sign(order, function)):
            return Leading(order, found, function)
    return None


def derivatives(
    row: R, field: Any, count: int, product: Callable[[R, Any], R] = matmul
) -> Iterator[R]:
    """Give an affine function and its derivatives along a field, order by order.

    Parameters
    ----------
    row : row (..., N + 1)
        Of the function of (y, 1).
    field : matrix (..., N + 1, N + 1)
        Acts on (y, 1); see `square`.
    count : int
        How many. Where N + 1 of them are zero, so are all others.
    product : callable
        A row times the field.
    """
    return islice(accumulate(repeat(field), product, initial=row), count)


def square(field: np.ndarray) -> np.ndarray:
    """Append the rate of 1, which is 0, to a field (..., N, N + 1).

    Parameters
    ----------
    field : array (..., N, N + 1)

    Returns
    -------
    array (..., N + 1, N + 1)
    """
    below = np.zeros_like(field[..., :1, :])
    return np.concatenate([field, below], axis=-2)


def dot(row: Iterable[Any], vector: Iterable[Any]) -> Any:
    """Sum of products.

    Parameters
    ----------
    row, vector : iterable of number

    Returns
    -------
    number
    """
    return sum(map(mul, row, vector))


class Located(NamedTuple):
    """A state at an event, extended by 1, and how well it is known, in floats or mpmath.

    Attributes
    ----------
    state : sequence of N + 1 numbers
    sizes : sequence of N + 1 numbers
        Sums of absolute values behind each coordinate.
    moved : sequence of N + 1 numbers
        Its change within the error of the time along the field that led there.
    error : number
        Of the time.
    unit : number
        Rounding of a sum of products, beside its sum of absolute values.
    """

    state: Vector
    sizes: Vector
    moved: Vector
    error: Any
    unit: Any = UNIT

    def leading(
        self, rows: Sequence[Sequence[Any]], bounds: Sequence[Sequence[Any]], first: int = 0
    ) -> Leading[Sequence[Any]] | None:
        """Find the first derivative that is not zero beyond its error.

        Parameters
        ----------
        rows : sequence of rows
            The function and its derivatives along a field: one more than is judged.
        bounds : sequence of rows
            Sums of absolute values behind their entries.
        first : int

        Returns
        -------
        Leading or None
        """

        def sign(order: int, row: Sequence[Any]) -> int:
            value = dot(row, self.state)
            # the time errs: the state may have moved on along either field
            ahead = self.error * abs(dot(rows[order + 1], self.state))
            drift = max(ahead, abs(dot(row, self.moved)))
            if abs(value) > self.unit * dot(bounds[order], self.sizes) + drift:
                return 1 if value > 0 else -1
            return 0

        return leading(rows[:-1], sign, first)

    def signs(self, rows: np.ndarray, bounds: np.ndarray, field: np.ndarray) -> np.ndarray:
        """Signs (k,) of the leading derivatives of functions (k, N + 1) along a field, 0 for none.

        As `leading`, for functions that no table holds: one product for all of them.

        Parameters
        ----------
        rows : array (k, N + 1)
        bounds : array (k, N + 1)
            Sums of absolute values behind the entries of the rows.
        field : array (N, N + 1)

        Returns
        -------
        array (k,) of int
        """
        matrix = square(field)

        def judged() -> Iterator[tuple[np.ndarray, np.ndarray]]:
            count = len(self.state)
            every = derivatives(rows, matrix, count + 1)
            behind, row = derivatives(bounds, abs(matrix), count), next(every)
            for following, bound in zip(every, behind, strict=True):
                ahead = self.error * abs(following @ self.state)
                drift = np.maximum(ahead, abs(row @ self.moved))
                yield row @ self.state, self.unit * (bound @ self.sizes) + drift
                row = following

        return leading_signs(judged())


def leading_signs(judged: Iterable[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Signs of the leading derivatives of many functions or states at once, 0 for none.

    The form of `leading` for arrays: state by state the starts of a sweep take 60 times as long.

    Parameters
    ----------
    judged : iterable of (array, array)
        Values and their errors, from order 0 on.

    Returns
    -------
    array of int
        -1, 0 or 1, of the shape of the values.
    """
    signs: np.ndarray | None = None
    for values, errors in judged:
        here = (values > errors).astype(int) - (values < -errors)
        signs = here if signs is None else np.where(signs, signs, here)
        if signs.all():
            break
    assert signs is not None
    return signs
