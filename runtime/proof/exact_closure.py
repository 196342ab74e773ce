"""How a cycle closes: what is proposed of it, for the checker to verify.

An autonomous dissipative cycle closes by its state. Of a conservative one the period is
given, and one coordinate's closure is dropped: it follows from the energy. A forced one is a
function of time: the forcing's states are cos(w t) and sin(w t) at an unknown time, and a
whole number of the forcing's periods passes.

Where nothing depends on some direction, a rotor's angle, a cycle closes up to a shift along it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.proof.exact_tables import Row, Tables, rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered, Subject
from nonsmooth.runtime.proof.symplectic_form import SymplecticForm, symplectic_form
from nonsmooth.runtime.shooting.translations import translations_of

__all__ = ["ClosureConditions", "closing_of"]

_LARGEST_DENOMINATOR = 10**6  # of a direction
_NEARLY = 1 - 1e-9  # of the largest: as large


@dataclass(frozen=True)
class ClosureConditions:
    """How a cycle closes: by its state, by a given period and the energy, or by the forcing."""

    kind: str  # "state", "period" or "forcing"
    dropped: int = -1  # coordinate whose closure follows from the energy; -1 for none
    form: SymplecticForm | None = None
    turns: int = 0  # turns of the first forcing in one period
    # directions along which nothing changes, in echelon form; the cycle closes up to these
    translations: tuple[Row, ...] = ()

    @property
    def stability(self) -> str:
        """The stability that is claimed: "stable", or "neutral" for a conservative orbit."""
        return "stable" if self.form is None else "neutral"


def closing_of(subject: Subject, tables: Tables, at: Sequence[Any] = ()) -> ClosureConditions:
    """Return how the subject's cycle closes: by the forcing, by the state, or by period and energy.

    `at` holds the values at the orbit of what the tables are functions of. `NotCovered` is raised
    if the cycle closes in another way, or if its numbers are not rational where they have to be.
    """
    cycle, near = subject.cycle, partial(tables.near, values=at)
    shifts = tuple(
        tuple(rational_of(Fraction(x).limit_denominator(_LARGEST_DENOMINATOR)) for x in direction)
        for direction in translations_of(piecewise(subject.kernels, subject.values)).tolist()
    )
    if cycle.structure.forcing:
        cosine, sine = cycle.structure.forcing[0]
        speed = near(tables.fields[cycle.configurations[0]][sine][cosine])
        total = float(sum(float(t) for t in subject.dwell))
        turns = max(1, round(speed * total / (2 * math.pi)))
        return ClosureConditions("forcing", turns=turns, translations=shifts)
    if shifts and subject.period is not None:
        raise NotCovered("it is periodic up to a shift, and of a family that a period singles out")
    if subject.period is None:
        return ClosureConditions("state", translations=shifts)
    if not tables.exact:
        raise NotCovered("the parameters of a conservative system have to be rational")
    form = symplectic_form(tables, cycle)
    if form is None:
        raise NotCovered("no energy was found that the cycle keeps, so its period cannot be given")
    energy = form.energies[cycle.configurations[0]]
    start = [float(x) for x in subject.start]
    slopes = [
        sum(near(x) * y for x, y in zip(row[:-1], start, strict=True)) + near(row[-1])
        for row in energy[:-1]
    ]
    if not all(map(math.isfinite, slopes)):
        raise NotCovered("the slopes of its energy are not finite where it starts")
    # the first of those that are as large but for rounding, in whatever arithmetic it is
    least = _NEARLY * max(abs(slope) for slope in slopes)
    largest = next(i for i, slope in enumerate(slopes) if abs(slope) >= least)
    return ClosureConditions("period", dropped=largest, form=form)
