"""What is exactly true of an orbit where its phases begin and end: affine functions that vanish.

Nothing is taken for granted where the cycle begins: what the first passage leaves is true
behind it, and, the orbit being periodic, in front of the next one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from nonsmooth.runtime.proof.closure import projected
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.proof.motion.exact_rows import Facts, Row
from nonsmooth.runtime.shooting.shooting_map import Cycle

__all__ = ["Known", "known_of"]


class Known(NamedTuple):
    """Facts of each phase: at its start, those that last, and at its end."""

    starts: tuple[Facts, ...]
    lasting: tuple[Facts, ...]
    ends: tuple[Facts, ...]


def known_of(
    tables: Tables,
    cycle: Cycle,
    translations: Sequence[Row] = (),
    vanishing: Sequence[Row] = (),
) -> Known:
    """Facts of a cycle that closes up to translations, of a system whose numbers are exact.

    What vanishes where it begins by `vanishing_along` is true of the orbit alone.
    """
    resets = [tables.resets[t.reset] for t in cycle.transitions]
    resets[-1] = projected(resets[-1], translations)
    facts = Facts.of(vanishing)
    while True:
        found: list[tuple[Facts, Facts, Facts]] = []
        begin = facts
        for place, configuration in enumerate(cycle.configurations):
            lasting = facts.lasting(tables.fields[configuration])
            end = Facts.of([*lasting.rows, tables.rows[cycle.rows[place]]])
            found.append((facts, lasting, end))
            facts = end.reset(resets[place])
        if len(facts.rows) == len(begin.rows):
            starts, lastings, ends = zip(*found, strict=True)
            return Known(starts, lastings, ends)
