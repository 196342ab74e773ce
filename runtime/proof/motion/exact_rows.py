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
    """Affine functions of a state that are exactly zero, as independent rows."""

    rows: tuple[Row, ...]  # in reduced echelon form
    pivots: tuple[int, ...]  # the coordinate that each row gives in terms of the others

    @staticmethod
    def of(rows: Sequence[Sequence[Any]]) -> Invariants:
        """Return the invariants that rows (N + 1) state, which need not be independent."""
        if not rows:
            return Invariants((), ())
        reduced = [row for row in _echelon(rows) if any(row)]
        return Invariants(
            tuple(reduced),
            tuple(next(j for j, entry in enumerate(row) if entry) for row in reduced),
        )

    @property
    def consistent(self) -> bool:
        """Whether there are states that meet them."""
        return not self.rows or self.pivots[-1] < len(self.rows[-1]) - 1

    def reduce(self, row: Sequence[Any]) -> Row:
        """Return the same function of the state without the pivot coordinates, (N + 1).

        The row is zero where the invariants make the function zero.
        """
        found = list(row)
        for fact, pivot in zip(self.rows, self.pivots, strict=True):
            if factor := found[pivot]:
                found = [x - factor * y for x, y in zip(found, fact, strict=True)]
        return tuple(found)

    def lasting(self, field: Sequence[Row]) -> Invariants:
        """Return the invariants that stay true along a field (N + 1, N + 1).

        They are the largest part that the field maps into itself.
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
        """Return the invariants behind a reset (N + 1, N + 1) of a state for which these hold."""
        return Invariants.of(left_kernel([self.reduce(row) for row in reset]))

    def agree(self, first: Sequence[Sequence[Any]], second: Sequence[Sequence[Any]]) -> bool:
        """Whether two resets (N + 1, N + 1) agree on all states for which these hold."""
        return not any(
            any(self.reduce([x - y for x, y in zip(*rows, strict=True)]))
            for rows in zip(first, second, strict=True)
        )

    def tighten(self, state: Sequence[arb]) -> list[arb]:
        """Return balls around the N coordinates, smaller where an invariant gives one."""
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
    """Return the reduced echelon form of rows with entries in any field."""
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
    """Return a basis of the rows c with c M = 0, for an exact matrix with at least one row."""
    size, width = len(matrix), len(matrix[0])
    joined = [[*row, *(int(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    return [row[width:] for row in _echelon(joined) if not any(row[:width])]


def product(row: Sequence[Any], matrix: Sequence[Sequence[Any]]) -> Row:
    """Return the exact product (m) of a row (n) and a matrix (n, m).

    With a field it is the row of the function's derivative.
    """
    columns: Iterable[tuple[Any, ...]] = zip(*matrix, strict=True)
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), 0 * column[0])
        for column in columns
    )


def evaluate(row: Sequence[Any], state: Sequence[Any]) -> Any:
    """Return an affine function (N + 1) of a state (N) in balls or Taylor models."""
    from flint import arb

    total = row[-1] + arb(0)
    for x, y in zip(row, state, strict=False):
        if x:
            total += y * x
    return total
