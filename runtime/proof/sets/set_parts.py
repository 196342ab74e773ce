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
    """What is true of parts where their phase begins.

    The functions of the boundaries in `under` are not positive, with their first derivative that
    is not exactly zero; `clock` counts passages of the forcing's phase.
    """

    configuration: int
    facts: Invariants
    under: frozenset[int]
    clock: int


class SetParts(NamedTuple):
    """Parts of one kind: of which set, and behind how many transitions."""

    states: ManySets
    origin: NDArray[np.int_]
    depth: NDArray[np.int_]

    def chosen(self, mask: Any) -> SetParts:
        """Some of them.

        Parameters
        ----------
        mask : array of bool or int, or slice
        """
        return SetParts(self.states[mask], self.origin[mask], self.depth[mask])

    def of(self, states: ManySets, origin: Any) -> SetParts:
        """Parts of these parts.

        Parameters
        ----------
        states : ManySets
        origin : array of int
            Of which of these each is a part.
        """
        return SetParts(states, self.origin[origin], self.depth[origin])


class PartsLeft:
    """Parts that are to be followed, by their kinds.

    Parameters
    ----------
    count : int
        Of sets.
    most : int
        Parts of one set; one with more is lost.
    """

    def __init__(self, count: int, most: int) -> None:
        self.most = most
        self.lost = np.zeros(count, dtype=bool)
        self._seen = np.zeros(count, dtype=int)
        self._left: dict[StartKind, list[SetParts]] = {}

    def add(self, kind: StartKind, parts: SetParts) -> None:
        """Follow some more."""
        self.count(parts.origin)
        self._left.setdefault(kind, []).append(parts)

    def count(self, origin: NDArray[np.int_]) -> None:
        """Count parts of sets; those with too many are lost.

        Parameters
        ----------
        origin : array of int
        """
        np.add.at(self._seen, origin, 1)
        self.lost |= self._seen > self.most

    def lose(self, origin: NDArray[np.int_]) -> None:
        """Some sets are lost.

        Parameters
        ----------
        origin : array of int
        """
        self.lost[origin] = True

    def take(self) -> tuple[StartKind, SetParts] | None:
        """The most parts of one kind, as many as are followed at once.

        Returns
        -------
        tuple of (StartKind, SetParts) or None
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
    """The parts of parts for which a function is not negative.

    Parameters
    ----------
    parts : SetParts
    row : Rounded (1, n)
    """
    states, alive = parts.states.cut(row)
    return parts.chosen(alive)._replace(states=states[alive])


def first_moving(row: Row, along: Sequence[Row], facts: Invariants) -> tuple[Row, int]:
    """The first derivative that is not exactly zero, and its order; -1 if all are.

    Parameters
    ----------
    row : Row
        A function.
    along : sequence of Row
        The field.
    facts : Invariants
        What is exactly true.

    Returns
    -------
    tuple of (Row, int)
    """
    for order in range(len(row) + 1):
        reduced = facts.reduce(row)
        if any(reduced):
            return reduced, order
        row = product(row, along)
    return row, -1


def opposite(row: Row) -> Row:
    """A function with the other sign."""
    return tuple(-x for x in row)


def direction(row: Row) -> Row:
    """A function up to a positive factor."""
    size = next((abs(x) for x in row if x), 1)
    return tuple(x / size for x in row)


def clock_row(time: Any, size: int) -> arb_mat:
    """The time since another one, as a row.

    Parameters
    ----------
    time : arb
    size : int
        Of the states.

    Returns
    -------
    arb_mat (1, size + 2)
    """
    from flint import arb, arb_mat

    return arb_mat([[*(arb(0),) * size, arb(1), -time]])


def timed_row(row: Sequence[Any]) -> arb_mat:
    """A function of (y, 1) as one of (y, t, 1).

    Parameters
    ----------
    row : sequence (N + 1,)

    Returns
    -------
    arb_mat (1, N + 2)
    """
    from flint import arb, arb_mat

    return arb_mat([[*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])]])


def rounded_row(row: Sequence[Any]) -> Rounded:
    """The same in doubles.

    Parameters
    ----------
    row : sequence (N + 1,)

    Returns
    -------
    Rounded (1, N + 2)
    """
    return Rounded.of(timed_row(row))


def negative(row: Rounded) -> Rounded:
    """Functions with the other sign."""
    return Rounded(-row.middle, row.radius)
