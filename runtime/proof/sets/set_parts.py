"""Parts of sets that are on their way, by what is known of them where a phase begins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.float_sets import ManySets, Rounded, joined_sets
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product

if TYPE_CHECKING:
    from flint import arb_mat

__all__ = [
    "PartsLeft",
    "SetParts",
    "StartKind",
    "clock_row",
    "direction",
    "first_moving",
    "kept",
    "negative",
    "opposite",
    "rounded_row",
    "timed_row",
]

_AT_ONCE = 4096  # sets


class StartKind(NamedTuple):
    """What is known of parts of sets where their phase begins."""

    configuration: int
    facts: Invariants
    # boundaries for which the first derivative that is not exactly zero is at most zero
    under: frozenset[int]
    clock: int  # how often the forcing's phase was passed


class SetParts(NamedTuple):
    """Parts of sets of one kind."""

    states: ManySets
    origin: NDArray[np.int_]  # number of the set that each is a part of
    depth: NDArray[np.int_]  # number of transitions that each has passed

    def chosen(self, mask: Any) -> SetParts:
        """Return the parts that a mask, indices or a slice select."""
        return SetParts(self.states[mask], self.origin[mask], self.depth[mask])

    def of(self, states: ManySets, origin: Any) -> SetParts:
        """Return new parts with these states, pieces of the parts with the numbers in `origin`."""
        return SetParts(states, self.origin[origin], self.depth[origin])


class PartsLeft:
    """The parts of `count` sets that are still to be followed, by kind.

    A set with more than `most` parts is lost.
    """

    def __init__(self, count: int, most: int) -> None:
        self.most = most
        self.lost = np.zeros(count, dtype=bool)
        self._seen = np.zeros(count, dtype=int)
        self._left: dict[StartKind, list[SetParts]] = {}

    def add(self, kind: StartKind, parts: SetParts) -> None:
        """Add parts of one kind."""
        self.count(parts.origin)
        self._left.setdefault(kind, []).append(parts)

    def count(self, origin: NDArray[np.int_]) -> None:
        """Count one more part for each set in `origin`; those with too many are lost."""
        np.add.at(self._seen, origin, 1)
        self.lost |= self._seen > self.most

    def lose(self, origin: NDArray[np.int_]) -> None:
        """Mark sets as lost."""
        self.lost[origin] = True

    def take(self) -> tuple[StartKind, SetParts] | None:
        """Take out parts of the kind with the most, or return None if none are left.

        They are at most as many as are followed at once.
        """
        if not self._left:
            return None
        kind = max(self._left, key=lambda own: sum(len(p.origin) for p in self._left[own]))
        listed = self._left.pop(kind)
        parts = SetParts(
            joined_sets([part.states for part in listed]),
            np.concatenate([part.origin for part in listed]),
            np.concatenate([part.depth for part in listed]),
        )
        parts = parts.chosen(~self.lost[parts.origin])
        if len(parts.origin) > _AT_ONCE:
            self._left[kind] = [parts.chosen(slice(_AT_ONCE, None))]
            parts = parts.chosen(slice(0, _AT_ONCE))
        return kind, parts


def kept(parts: SetParts, row: Rounded) -> SetParts:
    """Return the pieces of parts on which a function (1, n) is not negative."""
    states, alive = parts.states.cut(row)
    return parts.chosen(alive)._replace(states=states[alive])


def first_moving(row: Row, along: Sequence[Row], facts: Invariants) -> tuple[Row, int]:
    """Return the first derivative along a field that is not exactly zero, and its order.

    The order is -1 if all derivatives are zero for states for which the facts hold.
    """
    for order in range(len(row) + 1):
        reduced = facts.reduce(row)
        if any(reduced):
            return reduced, order
        row = product(row, along)
    return row, -1


def opposite(row: Row) -> Row:
    """Return a function with the opposite sign."""
    return tuple(-x for x in row)


def direction(row: Row) -> Row:
    """Return a function divided by a positive factor, the same for all its positive multiples."""
    size = next((abs(x) for x in row if x), 1)
    return tuple(x / size for x in row)


def clock_row(time: Any, size: int) -> arb_mat:
    """Return the row (1, size + 2) of the time since a given time, for (y, t, 1)."""
    from flint import arb, arb_mat

    return arb_mat([[*(arb(0),) * size, arb(1), -time]])


def timed_row(row: Sequence[Any]) -> arb_mat:
    """Return a function (N + 1) of (y, 1) as a row (1, N + 2) for (y, t, 1)."""
    from flint import arb, arb_mat

    return arb_mat([[*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])]])


def rounded_row(row: Sequence[Any]) -> Rounded:
    """Return a function (N + 1) of (y, 1) as a row (1, N + 2) for (y, t, 1) in doubles."""
    return Rounded.of(timed_row(row))


def negative(row: Rounded) -> Rounded:
    """Return functions with the opposite sign."""
    return Rounded(-row.middle, row.radius)
