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
    "projection",
]

_LARGEST_DENOMINATOR = 10**6  # of a direction


@dataclass(frozen=True)
class ClosureConditions:
    """How a cycle closes.

    Attributes
    ----------
    kind : {"state", "period", "forcing"}
    period : Value, fmpq, RationalFunction or None
        What the dwell times sum up to, for "period": over a box of parameters exactly.
    dropped : int
        The coordinate whose closure follows from the energy; -1 for none.
    form : SymplecticForm or None
    speeds : tuple of fmpq or RationalFunction
        Angular frequencies of the forcings.
    turns : int
        How often the first forcing turns in one period.
    pairs : tuple of (int, int)
        States of the forcings.
    translations : tuple of Row
        Directions along which nothing changes, in echelon form; the cycle closes up to these.
    vanishing : tuple of Row
        Functions that are zero where the orbit begins, because it closes.
    """

    kind: str
    period: Any = None
    dropped: int = -1
    form: SymplecticForm | None = None
    speeds: tuple[Any, ...] = ()
    turns: int = 0
    pairs: tuple[tuple[int, int], ...] = field(default=())
    translations: tuple[Row, ...] = ()
    vanishing: tuple[Row, ...] = ()

    @property
    def timed(self) -> bool:
        """Whether the orbit is a function of time: the map is that at fixed times."""
        return self.kind == "forcing"

    @property
    def forced(self) -> tuple[int, ...]:
        """The states of all forcings."""
        return tuple(state for pair in self.pairs for state in pair)

    @property
    def stability(self) -> str:
        """What is claimed of the multipliers: "stable", or "neutral" of a conservative one."""
        return "stable" if self.form is None else "neutral"


def exact_translations(
    tables: Tables, structure: Structure, near: Sequence[Sequence[float]]
) -> tuple[Row, ...]:
    """Directions along which a system does not change, exactly: none, unless all of them are.

    Parameters
    ----------
    tables : Tables
        Of the system.
    structure : Structure
        Of the system.
    near : sequence of sequences of float
        What `translations_of` gives in double precision.

    Returns
    -------
    tuple of Row, each of length N
        Empty if one of them cannot be shown exactly.
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


def projection(translations: Sequence[Row], size: int) -> Matrix:
    """Matrix (N + 1, N + 1), on (y, 1), after which the translations' first coordinates are zero.

    Exact, as `nonsmooth.runtime.shooting.translations.projection_along`.

    Parameters
    ----------
    translations : sequence of Row
        Directions along which the system does not change.
    size : int
        The number N of states.

    Returns
    -------
    Matrix (N + 1, N + 1)
        With exact entries.
    """
    found = np.eye(size + 1, dtype=object)
    if len(translations):
        found[:-1, :-1] = projection_along(np.array(translations, dtype=object))
    return tuple(map(tuple, found))


def projected(reset: Matrix, translations: Sequence[Row]) -> Matrix:
    """A reset, and then the projection along translations.

    Parameters
    ----------
    reset : Matrix (N + 1, N + 1)
        With exact entries.
    translations : sequence of Row
        Directions along which the system does not change.

    Returns
    -------
    Matrix (N + 1, N + 1)
        The reset itself without translations.
    """
    if not translations:
        return reset
    return tuple(product(row, reset) for row in projection(translations, len(reset) - 1))


def forcing_speeds(tables: Tables, cycle: ItineraryShape) -> tuple[Any, ...] | str:
    """Frequencies of the forcings, exactly the same in every phase; or why there are none.

    Parameters
    ----------
    tables : Tables
        Of the system.
    cycle : ItineraryShape
        The itinerary, with its system's structure.

    Returns
    -------
    tuple or str
        Exact, in the system's units; or the reason as a text.
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
