"""What is exactly true of an orbit where its phases begin and end: affine functions that vanish.

Nothing is taken for granted where the cycle begins: what the first passage leaves is true
behind it, and, the orbit being periodic, in front of the next one.
"""

from __future__ import annotations

from typing import NamedTuple

from nonsmooth.runtime.certification.tables import Tables
from nonsmooth.runtime.composition.passage import Cycle
from nonsmooth.runtime.validation.facts import Facts

__all__ = ["Known", "known_of"]


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
