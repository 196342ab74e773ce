"""Closure conditions that make a cycle's equations square and nonsingular, as proofs need them.

`nonsmooth.runtime.shooting.closure_conditions` has more equations than unknowns, for least
squares; a root of those cannot be shown to be the only one, so here each condition that
follows from others is left out, for a reason that is proved.

An autonomous dissipative cycle closes by its state. Of a conservative one the period is
given, and one coordinate's closure is dropped: it follows from the energy. A forced one is a
function of time: the forcing's states are cos(w t) and sin(w t) at an unknown time, and a
whole number of the forcing's periods passes.

Where nothing depends on some direction, a rotor's angle, a cycle closes up to a shift along it:
behind the last reset the state is projected onto those that are zero in one coordinate.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.proof.exact_tables import Matrix, Tables, rational_of
from nonsmooth.runtime.proof.motion.exact_rows import Row, product
from nonsmooth.runtime.proof.symplectic_form import SymplecticForm
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.translations import deciding_rows, projection_along, taken_resets

__all__ = [
    "ClosureConditions",
    "exact_translations",
    "forcing_speeds",
    "projected",
]

_LARGEST_DENOMINATOR = 10**6  # of a direction


@dataclass(frozen=True)
class ClosureConditions:
    """How a cycle closes: by its state, by a given period and the energy, or by the forcing."""

    kind: str  # "state", "period" or "forcing"
    # for "period" the sum of the dwell times; over a box of parameters an exact function
    period: Any = None
    dropped: int = -1  # coordinate whose closure follows from the energy; -1 for none
    form: SymplecticForm | None = None
    speeds: tuple[Any, ...] = ()  # angular frequencies of the forcings, exact
    turns: int = 0  # turns of the first forcing in one period
    # numbers of the cosine and sine states of each forcing
    pairs: tuple[tuple[int, int], ...] = field(default=())
    # directions along which nothing changes, in echelon form; the cycle closes up to these
    translations: tuple[Row, ...] = ()
    # functions that are zero where the orbit begins, because it closes
    vanishing: tuple[Row, ...] = ()

    @property
    def timed(self) -> bool:
        """Whether the orbit is a function of time, so that its map is the one at fixed times."""
        return self.kind == "forcing"

    @property
    def forced(self) -> tuple[int, ...]:
        """The cosine and sine states of all forcings."""
        return tuple(state for pair in self.pairs for state in pair)

    @property
    def stability(self) -> str:
        """The stability that is claimed: "stable", or "neutral" for a conservative orbit."""
        return "stable" if self.form is None else "neutral"


def exact_translations(
    tables: Tables, structure: Structure, near: Sequence[Sequence[float]]
) -> tuple[Row, ...]:
    """Return the exact directions (each N) along which a system does not change.

    `near` are these directions in double precision, as `translations_of` gives them. If one of
    them cannot be shown exactly, none is returned.
    """
    if not len(near) or not tables.exact:
        return ()
    fractions = [[Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in d] for d in near]
    found = tuple(tuple(map(rational_of, direction)) for direction in fractions)
    rows = [row[:-1] for field in tables.fields for row in field[:-1]]
    rows += [tables.rows[k][:-1] for k in deciding_rows(structure)]
    for k in taken_resets(structure):
        for i, row in enumerate(tables.resets[k][:-1]):
            rows.append(tuple(x - int(i == j) for j, x in enumerate(row[:-1])))
    columns = tuple(zip(*found, strict=True))
    return () if any(any(product(row, columns)) for row in rows) else found


def _projection(translations: Sequence[Row], size: int) -> Matrix:
    """Return the matrix on (y, 1) that makes the first coordinates of translations zero.

    It is (N + 1, N + 1) and exact, as `nonsmooth.runtime.shooting.translations.projection_along`.
    """
    found = np.eye(size + 1, dtype=object)
    if len(translations):
        found[:-1, :-1] = projection_along(np.array(translations, dtype=object))
    return tuple(map(tuple, found))


def projected(reset: Matrix, translations: Sequence[Row]) -> Matrix:
    """Return a reset followed by the projection along translations: (N + 1, N + 1), exact.

    Without translations that is the reset itself.
    """
    if not translations:
        return reset
    return tuple(product(row, reset) for row in _projection(translations, len(reset) - 1))


def forcing_speeds(tables: Tables, cycle: ItineraryShape) -> tuple[Any, ...] | str:
    """Return the exact angular frequencies of the forcings, or the reason as a text.

    They have to be the same in every phase, and no transition may reset a forcing.
    """
    found: list[Any] = []
    for cosine, sine in cycle.structure.forcing:
        speed = tables.fields[cycle.configurations[0]][sine][cosine]
        for configuration in cycle.configurations:
            rows = tables.fields[configuration]
            for state, other, rate in ((cosine, sine, -speed), (sine, cosine, speed)):
                wanted = [rate if k == other else 0 for k in range(len(rows))]
                if list(rows[state]) != wanted:
                    return "a forcing does not turn evenly"
        for transition in cycle.transitions:
            reset = tables.resets[transition.reset]
            for state in (cosine, sine):
                if list(reset[state]) != [int(k == state) for k in range(len(reset))]:
                    return "a transition resets a forcing"
        found.append(speed)
    return tuple(found)
