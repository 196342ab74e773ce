"""What is known exactly of a state: affine functions that are zero, and rows of rationals.

A velocity set to the belt's by a reset, a boundary that was just reached and a coordinate at
rest on a stop are invariants; balls alone could never tell them from nearly so.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["Invariants", "Row", "evaluate", "left_kernel", "product"]

Row = tuple["fmpq", ...]  # n y + c: n, then c


@dataclass(frozen=True)
class Invariants:
    """Affine functions of a state that are exactly zero: independent rows, reduced.

    Attributes
    ----------
    rows : tuple of Row
        In reduced echelon form.
    pivots : tuple of int
        The coordinate that each row gives in terms of the others.
    """

    rows: tuple[Row, ...]
    pivots: tuple[int, ...]

    @staticmethod
    def of(rows: Sequence[Sequence[Any]]) -> Invariants:
        """Invariants from rows that need not be independent.

        Parameters
        ----------
        rows : sequence of rows of fmpq, each of length N + 1
            Functions that are zero.

        Returns
        -------
        Invariants
            The same facts, independent.
        """
        if not rows:
            return Invariants((), ())
        reduced = [row for row in _echelon(rows) if any(row)]
        return Invariants(
            tuple(reduced),
            tuple(next(j for j, entry in enumerate(row) if entry) for row in reduced),
        )

    @property
    def consistent(self) -> bool:
        """Whether any state meets them."""
        return not self.rows or self.pivots[-1] < len(self.rows[-1]) - 1

    def reduce(self, row: Sequence[Any]) -> Row:
        """The same function of the state without the coordinates that are known by others.

        Parameters
        ----------
        row : sequence, length N + 1
            An affine function, acting on (y, 1).

        Returns
        -------
        Row, length N + 1
            Zero where the facts make the function zero.
        """
        found = list(row)
        for fact, pivot in zip(self.rows, self.pivots, strict=True):
            if factor := found[pivot]:
                found = [x - factor * y for x, y in zip(found, fact, strict=True)]
        return tuple(found)

    def lasting(self, field: Sequence[Row]) -> Invariants:
        """Those that stay true along a field: the largest part that it maps into itself.

        Parameters
        ----------
        field : sequence of Row, (N + 1, N + 1)
            Acts on (y, 1).

        Returns
        -------
        Invariants
            True for all times, if these are true at one.
        """
        invariants = self
        while invariants.rows:
            rates = [invariants.reduce(product(row, field)) for row in invariants.rows]
            kept = [product(c, invariants.rows) for c in left_kernel(rates)]
            if len(kept) == len(invariants.rows):
                break
            invariants = Invariants.of(kept)
        return invariants

    def reset(self, reset: Sequence[Row]) -> Invariants:
        """What is true behind a reset of a state for which these are.

        Parameters
        ----------
        reset : sequence of Row, (N + 1, N + 1)
            Acts on (y, 1).

        Returns
        -------
        Invariants
            Of the state behind it.
        """
        return Invariants.of(left_kernel([self.reduce(row) for row in reset]))

    def agree(self, first: Sequence[Sequence[Any]], second: Sequence[Sequence[Any]]) -> bool:
        """Whether two resets take every state for which these are true to one state.

        Parameters
        ----------
        first : sequence of Row, (N + 1, N + 1)
            A reset.
        second : sequence of Row, (N + 1, N + 1)
            Another reset.

        Returns
        -------
        bool
            Exactly.
        """
        return not any(
            any(self.reduce([x - y for x, y in zip(*rows, strict=True)]))
            for rows in zip(first, second, strict=True)
        )

    def tighten(self, state: Sequence[arb]) -> list[arb]:
        """Balls around the coordinates, smaller where a fact gives one by the others.

        Parameters
        ----------
        state : sequence of arb, length N
            Enclosure of the state, in the system's units.

        Returns
        -------
        list of arb, length N
            In the system's units.
        """
        found = list(state)
        for row, pivot in zip(self.rows, self.pivots, strict=True):
            given = evaluate(tuple(-x if j != pivot else 0 for j, x in enumerate(row)), state)
            if given.rad() <= found[pivot].rad():
                found[pivot] = given
        return found


def _echelon(rows: Sequence[Sequence[Any]]) -> list[Row]:
    from flint import fmpq, fmpq_mat

    flat = [entry for row in rows for entry in row]
    if not all(isinstance(entry, int | fmpq) for entry in flat):
        return _eliminated(rows)
    reduced, rank = fmpq_mat(len(rows), len(rows[0]), flat).rref()
    return [tuple(row) for row in reduced.tolist()[:rank]]


def _eliminated(rows: Sequence[Sequence[Any]]) -> list[Row]:
    """The same in any field."""
    from flint import fmpq

    left = [[fmpq(x) if isinstance(x, int) else x for x in row] for row in rows]
    found: list[list[Any]] = []
    for column in range(len(rows[0])):
        place = next((k for k, row in enumerate(left) if row[column]), None)
        if place is None:
            continue
        taken = left.pop(place)
        unit = 1 / taken[column]
        taken = [x * unit if x else x for x in taken]
        for row in (*left, *found):
            if factor := row[column]:
                row[:] = [x - factor * y if y else x for x, y in zip(row, taken, strict=True)]
        found.append(taken)
    return [tuple(row) for row in found]


def left_kernel(matrix: Sequence[Sequence[Any]]) -> list[Row]:
    """Rows c with c M = 0.

    Parameters
    ----------
    matrix : sequence of rows
        Exact entries, at least one row.

    Returns
    -------
    list of Row
        A basis.
    """
    size, width = len(matrix), len(matrix[0])
    joined = [[*row, *(int(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    return [row[width:] for row in _echelon(joined) if not any(row[:width])]


def product(row: Sequence[Any], matrix: Sequence[Sequence[Any]]) -> Row:
    """A row times a matrix: with a field, the row of the derivative.

    Parameters
    ----------
    row : sequence, length n
        Exact entries.
    matrix : sequence of rows, (n, m)
        Exact entries.

    Returns
    -------
    Row, length m
        Exactly.
    """
    columns: Iterable[tuple[Any, ...]] = zip(*matrix, strict=True)
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), 0 * column[0])
        for column in columns
    )


def evaluate(row: Sequence[Any], state: Sequence[Any]) -> Any:
    """An affine function of a state, in its arithmetic.

    Parameters
    ----------
    row : sequence, length N + 1
        An affine function, acting on (y, 1).
    state : sequence, length N
        Balls or Taylor models, in the system's units.

    Returns
    -------
    arb or TaylorModel
        In the function's units.
    """
    from flint import arb

    total = row[-1] + arb(0)
    for x, y in zip(row, state, strict=False):
        if x:
            total += y * x
    return total
