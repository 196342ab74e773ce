"""The harmonic forcings of an orbit: its period is theirs, and their phase is an unknown.

A forcing is a pair of states c' = -w s, s' = w c on the circle c^2 + s^2 = 1. Over whole
periods it comes back whatever else moves, so that its closure says only how long the orbit is,

    tau1 + ... + taup = 2 pi k / w,

with a whole number k, and its start is known but for the phase. Several forcings come back
together where their frequencies are whole multiples of one; they have begun together, at c = 1,
so that one phase is that of all.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.fields import exact
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.errors import DerivationError

PERIODS = "the orbit takes whole periods of the forcing"


@dataclass(frozen=True)
class Forcing:
    """The forcings of an orbit, all of them harmonics of one frequency."""

    frequency: sp.Expr  # the greatest of which every forcing's frequency is a whole multiple
    multiples: tuple[int, ...]  # those multiples
    # indices of the cosine and the sine of each forcing among the states
    places: tuple[tuple[int, int], ...]
    turns: int  # periods of `frequency` in one period of the orbit

    @property
    def period(self) -> sp.Expr:
        """Period of the orbit."""
        return 2 * sp.pi * self.turns / self.frequency

    @property
    def states(self) -> tuple[int, ...]:
        """Indices of all cosines and sines."""
        return tuple(place for pair in self.places for place in pair)

    def conditions(self, start: sp.Matrix) -> tuple[tuple[str, sp.Expr], ...]:
        """Equations (meaning, expression) of a start (N x 1) on the circles of the forcings.

        They are the amplitudes, then the phases with respect to the first forcing.
        """
        found = []
        (c, s), *_ = pairs = [(start[i], start[j]) for i, j in self.places]
        number = "" if len(pairs) == 1 else " 1"
        found.append((f"amplitude of forcing{number} is one", c**2 + s**2 - 1))
        for place, (other_c, other_s) in enumerate(pairs[1:], start=1):
            common = sp.igcd(self.multiples[0], self.multiples[place])
            up, own = self.multiples[place] // common, self.multiples[0] // common
            began = f"forcing {place + 1} began with forcing 1"
            wanted = sp.expand((c + sp.I * s) ** up)
            if own == 1:
                found.append((f"{began}: cosine", other_c - sp.re(wanted)))
                found.append((f"{began}: sine", other_s - sp.im(wanted)))
            else:
                found.append(
                    (f"amplitude of forcing {place + 1} is one", other_c**2 + other_s**2 - 1)
                )
                turned = sp.expand((other_c + sp.I * other_s) ** own * sp.conjugate(wanted))
                found.append((began, sp.im(turned)))
        return tuple(found)

    def along_phase(self, start: sp.Matrix) -> sp.Matrix:
        """Derivative (N x 1) of a state by the common phase of the forcings."""
        moved = sp.zeros(start.rows, 1)
        for multiple, (c, s) in zip(self.multiples, self.places, strict=True):
            moved[c], moved[s] = -multiple * start[s], multiple * start[c]
        return moved

    def phase_of(self, end: sp.Matrix, moved: sp.Matrix) -> sp.Matrix:
        """Changes (1 x d) of the common phase for changes (N x d) of the end state (N x 1)."""
        c, s = self.places[0]
        return (end[c] * moved[s, :] - end[s] * moved[c, :]) / self.multiples[0]


def forcing_of(itinerary: Itinerary, free: Collection[int]) -> Forcing | None:
    """The forcings of an orbit and how many of their periods it takes; None without any.

    That number is the nearest to the dwell times of the itinerary's reference. DerivationError
    says that the forcings have no common period, that no reference gives the number, or that a
    forcing is not among the states that are `free` at the start.
    """
    system = itinerary.presented_system
    if not system.forcing:
        return None
    where = f"itinerary {itinerary.name!r}"
    places = tuple((system.states.index(c), system.states.index(s)) for c, s in system.forcing)
    matrix, _ = system.configurations[0].dynamics.field(system.states)
    frequencies = [matrix[s, c] for c, s in places]
    ratios = [sp.cancel(w / frequencies[0]) for w in frequencies]
    if not all(ratio.is_Rational and ratio != 0 for ratio in ratios):
        raise DerivationError(f"{where}: its forcings have no common period")
    whole = sp.ilcm(1, *(ratio.q for ratio in ratios))
    multiples = [int(ratio * whole) for ratio in ratios]
    common = sp.igcd(0, *multiples)
    frequency = frequencies[0] * common / whole
    if itinerary.period is not None:
        raise DerivationError(f"{where}: its period is given, and that of its forcing too")
    turns = _turns(itinerary, frequency)
    if not turns:
        raise DerivationError(f"{where}: no reference tells how many periods of its forcing it has")
    forcing = Forcing(frequency, tuple(m // common for m in multiples), places, turns)
    if not {*forcing.states} <= {*free}:
        raise DerivationError(f"{where}: its section ties the forcing")
    return forcing


def _turns(itinerary: Itinerary, frequency: sp.Expr) -> int:
    """Number of periods of a frequency in the reference's dwell times; 0 if it is not known."""
    reference = itinerary.reference
    if reference is None:
        return 0
    texts = reference.parameters
    symbols = [p.symbol for p in itinerary.presented_system.parameters]
    known = {s: exact(texts[str(s)]) for s in symbols if str(s) in texts}
    names = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    if not {*names} <= {*reference.guess}:
        return 0
    total = sp.Add(*(exact(reference.guess[name]) for name in names))
    turned = frequency.xreplace(known) * total / (2 * sp.pi)
    return int(sp.floor(turned + sp.Rational(1, 2))) if turned.is_number else 0
