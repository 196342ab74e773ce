"""What is known exactly of a state: affine functions that are zero, and rows of rationals.

A velocity set to the belt's by a reset, a boundary that was just reached and a coordinate at
rest on a stop are invariants; balls alone could never tell them from nearly so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.checker.stated.exact import Elimination, reduced

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["Invariants", "Row", "evaluate"]

Row = tuple["fmpq", ...]  # n y + c: n, then c


@dataclass(frozen=True)
class Invariants:
    """Affine functions of a state that are exactly zero, as independent rows."""

    rows: tuple[Row, ...]  # in reduced echelon form

    @staticmethod
    def of(rows: Sequence[Sequence[Any]]) -> Invariants:
        """Return the invariants that rows (N + 1) state, which need not be independent."""
        return Invariants(tuple(Elimination().echelon(rows)))

    @cached_property
    def pivots(self) -> tuple[int, ...]:
        """The coordinate that each row gives in terms of the others."""
        return tuple(next(j for j, entry in enumerate(row) if entry) for row in self.rows)

    @property
    def consistent(self) -> bool:
        """Whether there are states that meet them."""
        return not self.rows or self.pivots[-1] < len(self.rows[-1]) - 1

    def reduce(self, row: Sequence[Any]) -> Row:
        """Return the same function of the state without the pivot coordinates, (N + 1).

        The row is zero where the invariants make the function zero.
        """
        return tuple(reduced(row, self.rows))

    def lasting(self, field: Sequence[Row]) -> Invariants:
        """Return the invariants that stay true along a field (N + 1, N + 1).

        They are the largest part that the field maps into itself.
        """
        return Invariants(tuple(Elimination().lasting(self.rows, field)))

    def reset(self, reset: Sequence[Row]) -> Invariants:
        """Return the invariants behind a reset (N + 1, N + 1) of a state for which these hold."""
        return Invariants.of(Elimination().left_kernel([self.reduce(row) for row in reset]))

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


def evaluate(row: Sequence[Any], state: Sequence[Any]) -> Any:
    """Return an affine function (N + 1) of a state (N) in balls or Taylor models."""
    from flint import arb

    total = row[-1] + arb(0)
    for x, y in zip(row, state, strict=False):
        if x:
            total += y * x
    return total
