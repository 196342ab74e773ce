"""What is exactly true of an orbit where its phases begin and end: affine functions that vanish.

Nothing is taken for granted where the cycle begins: what the first passage leaves is true
behind it, and, the orbit being periodic, in front of the next one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from nonsmooth.runtime.proof.exact_closure import projected
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["CycleInvariants", "invariants_of"]


class CycleInvariants(NamedTuple):
    """The invariants of each phase: at its start, those that last along it, and at its end."""

    starts: tuple[Invariants, ...]
    lasting: tuple[Invariants, ...]
    ends: tuple[Invariants, ...]


def invariants_of(
    tables: Tables,
    cycle: ItineraryShape,
    translations: Sequence[Row] = (),
    vanishing: Sequence[Row] = (),
) -> CycleInvariants:
    """Return the invariants of a cycle of a system with exact numbers, phase by phase.

    The cycle closes up to `translations`, directions along which the system does not change. What
    `vanishing` adds where the cycle begins holds for the orbit alone, not for motions nearby.
    """
    resets = [tables.resets[t.reset] for t in cycle.transitions]
    resets[-1] = projected(resets[-1], translations)
    invariants = Invariants.of(vanishing)
    while True:
        found: list[tuple[Invariants, Invariants, Invariants]] = []
        begin = invariants
        for place, configuration in enumerate(cycle.configurations):
            lasting = invariants.lasting(tables.fields[configuration])
            end = Invariants.of([*lasting.rows, tables.rows[cycle.rows[place]]])
            found.append((invariants, lasting, end))
            invariants = end.reset(resets[place])
        if len(invariants.rows) == len(begin.rows):
            starts, lastings, ends = zip(*found, strict=True)
            return CycleInvariants(starts, lastings, ends)
