"""What is exactly true of an orbit where its phases begin and end: affine functions that vanish.

Nothing is taken for granted where the cycle begins: what the first passage leaves is true
behind it, and, the orbit being periodic, in front of the next one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.certification.tables import Matrix, Tables
from nonsmooth.runtime.composition.passage import Cycle
from nonsmooth.runtime.validation.enclosures import Undecided
from nonsmooth.runtime.validation.facts import Facts, Row, evaluate, product

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Known", "first_sign", "known_of", "value_of"]


class Known(NamedTuple):
    """Facts of each phase: at its start, those that last, and at its end."""

    starts: tuple[Facts, ...]
    lasting: tuple[Facts, ...]
    ends: tuple[Facts, ...]


def known_of(tables: Tables, cycle: Cycle) -> Known:
    """Facts of a cycle of a system whose numbers are exact."""
    facts = Facts((), ())
    while True:
        found: list[tuple[Facts, Facts, Facts]] = []
        begin = facts
        for place, configuration in enumerate(cycle.configurations):
            lasting = facts.lasting(tables.fields[configuration])
            end = Facts.of([*lasting.rows, tables.rows[cycle.rows[place]]])
            found.append((facts, lasting, end))
            facts = end.reset(tables.resets[cycle.transitions[place].reset])
        if len(facts.rows) == len(begin.rows):
            starts, lastings, ends = zip(*found, strict=True)
            return Known(starts, lastings, ends)


def value_of(row: Row, facts: Facts, state: Sequence[arb]) -> Any:
    """An affine function of a state: exact if the facts give it, else a ball."""
    reduced = facts.reduce(row)
    return evaluate(reduced, state) if any(reduced[:-1]) else reduced[-1]


def first_sign(
    row: Row, field: Matrix, facts: Facts, state: Sequence[arb], order: int = 0
) -> tuple[int, int, Any]:
    """Order, sign and value of the first derivative along a field that is not exactly zero.

    Orders below `order` are passed over; sign 0 if all derivatives vanish.

    Raises
    ------
    Undecided
        If a ball contains zero.
    """
    for k in range(len(row) + 1):
        if k >= order:
            value = value_of(row, facts, state)
            if value > 0 or value < 0:
                return k, 1 if value > 0 else -1, value
            if not value == 0:  # of balls neither this nor its contrary need hold
                raise Undecided(f"its derivative of order {k} cannot be told from 0")
        row = product(row, field)
    return 0, 0, row[-1]
