"""Whether a proved orbit is a motion of the real system, for all times of all its phases.

No boundary of a phase's configuration is reached before the phase ends, the one that ends it
is reached from inside, nothing else is reached then, and of the transitions that are declared
for it the first whose conditions hold is the itinerary's. The full cycle is looked at: no
symmetry is taken for granted.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.certification.chain import Chain, Passage
from nonsmooth.runtime.certification.known import Known, first_sign, value_of
from nonsmooth.runtime.certification.tables import Tables, balls
from nonsmooth.runtime.certification.waves import Crossed, Ends, Waves
from nonsmooth.runtime.composition.passage import Cycle
from nonsmooth.runtime.validation.enclosures import Undecided
from nonsmooth.runtime.validation.facts import Row, product

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["Judgement", "Margin", "judge"]


class Margin(NamedTuple):
    """How clearly a boundary is respected.

    Attributes
    ----------
    phase : int
    configuration, boundary : str
    quantity : {"distance", "departure", "speed"}
        The boundary function stays below minus that; its first derivative that is not zero
        at the start is below minus that; the boundary is reached with at least that speed.
    least : arb
        Positive, exact.
    """

    phase: int
    configuration: str
    boundary: str
    quantity: str
    least: arb


class Judgement(NamedTuple):
    """Verdict "proved", "refuted" or "undecided", the reason where it is not proved, margins."""

    verdict: str
    reason: str
    margins: tuple[Margin, ...]


class _Refuted(Exception):
    pass


def judge(
    tables: Tables, cycle: Cycle, known: Known, chain: Chain, now: Passage, dwell: Sequence[arb]
) -> Judgement:
    """Judge an orbit whose start and dwell times are enclosed, at the working precision.

    Parameters
    ----------
    now : Passage
        Over the enclosures.
    dwell : sequence of arb
    """
    margins: list[Margin] = []
    undecided = ""
    for place in range(len(cycle)):
        phase = _Phase(tables, cycle, known, chain, now, dwell[place], place)
        name = f"phase {place}, {phase.name}"
        try:
            margins += phase.judged()
        except _Refuted as found:
            return Judgement("refuted", f"{name}: {found}", ())
        except Undecided as trouble:
            undecided = undecided or f"{name}: {trouble.reason}"
    if undecided:
        return Judgement("undecided", undecided, ())
    return Judgement("proved", "", tuple(margins))


class _Phase:
    """One phase of an orbit."""

    def __init__(
        self,
        tables: Tables,
        cycle: Cycle,
        known: Known,
        chain: Chain,
        now: Passage,
        dwell: arb,
        place: int,
    ) -> None:
        self.tables, self.cycle, self.place, self.dwell = tables, cycle, place, dwell
        self.configuration = cycle.configurations[place]
        self.name = cycle.structure.configurations[self.configuration]
        self.field = tables.fields[self.configuration]
        self.begin, self.lasting, self.end = (
            part[place] for part in (known.starts, known.lasting, known.ends)
        )
        self.chain, self.now = chain, now
        self.start = self.begin.tighten(_state(now.starts[place]))
        self.behind = self.end.tighten(_state(now.ends[place]))

    def judged(self) -> list[Margin]:
        """Margins of all boundaries; raises where one is crossed or cannot be decided."""
        if not self.dwell > 0:
            if self.dwell < 0:
                raise _Refuted("its dwell time is negative")
            raise Undecided("its dwell time cannot be told from 0")
        structure = self.cycle.structure
        for held in structure.constraints[self.configuration]:
            self._holds(held)
        found: list[Margin] = []
        waves = None
        reached = self.cycle.transitions[self.place].boundaries
        for index, boundary in enumerate(structure.boundaries[self.configuration]):
            row = self.tables.rows[boundary.row]
            told = boundary.name
            try:
                order, sign, value = first_sign(row, self.field, self.begin, self.start)
            except Undecided as trouble:
                raise Undecided(f"{told} where it begins: {trouble.reason}") from None
            if sign > 0:
                raise _Refuted(f"{told} is passed where it begins")
            last = index in reached
            if last:
                found.append(self._margin(told, "speed", self._speed(row, told)))
            if sign and order:
                found.append(self._margin(told, "departure", -value))
            if not any(self.lasting.reduce(product(row, self.field))):
                if sign and not order:
                    found.append(self._margin(told, "distance", -value))
                continue
            waves = waves or Waves(
                self.chain.fields[self.place], self.now.starts[self.place], self.dwell
            )
            least = self._distance(waves, row, Ends(order, last), told)
            if least is not None:
                found.append(self._margin(told, "distance", least))
        self._follows()
        return found

    def _margin(self, boundary: str, quantity: str, least: Any) -> Margin:
        from flint import arb

        return Margin(self.place, self.name, boundary, quantity, arb(least).lower())

    def _holds(self, row: int) -> None:
        """What a configuration holds is so exactly: by facts, never by balls."""
        value = value_of(self.tables.rows[row], self.begin, self.start)
        if value == 0:
            return
        if value > 0 or value < 0:
            raise _Refuted("what it holds does not hold where it begins")
        raise Undecided("whether what it holds holds where it begins", digits=False)

    def _speed(self, row: Row, told: str) -> arb:
        """Speed at which a boundary is reached that is exactly zero at the end."""
        value = value_of(row, self.end, self.behind)
        if value > 0 or value < 0:
            raise _Refuted(f"{told} is not reached where it ends")
        exactly = value == 0  # a ball may be neither this nor different from it
        if not exactly:
            raise Undecided(f"whether {told} is reached where it ends", digits=False)
        speed: arb = value_of(product(row, self.field), self.end, self.behind)
        if speed > 0:
            return speed
        if speed < 0:
            raise _Refuted(f"{told} is reached from outside")
        raise Undecided(f"{told} may be reached tangentially")

    def _distance(self, waves: Waves, row: Row, ends: Ends, told: str) -> arb | None:
        """Prove that a boundary is not reached inside the phase; by how much, if anything."""
        function = waves.function(balls([row]))
        try:
            if not (ends.order or ends.last):
                least = (-waves.largest(function) / 2).mid()
                if least > 0:
                    try:
                        waves.stays_negative([p + least for p in function], ends)
                        return least
                    except (Crossed, Undecided):
                        pass  # a smaller distance may do
            waves.stays_negative(function, ends)
        except Crossed as found:
            raise _Refuted(
                f"{told} is crossed before it ends, {found.time.str(6, radius=False)} after its"
                " start"
            ) from None
        except Undecided as trouble:
            raise Undecided(f"{told}: {trouble.reason}") from None
        return None

    def _follows(self) -> None:
        """Prove that the itinerary's transition is the first whose conditions hold."""
        wanted = self.cycle.transitions[self.place]
        own = {
            self.cycle.structure.boundaries[self.configuration][b].row for b in wanted.boundaries
        }
        for transition in self.cycle.structure.transitions[self.configuration]:
            if transition.boundaries != wanted.boundaries:
                continue
            holds = self._conditions(transition.conditions, own)
            target = self.cycle.structure.configurations[transition.target]
            if holds is None:
                raise Undecided(f"whether {target} follows")
            if holds and transition is not wanted:
                raise _Refuted(f"{target} follows, or another transition to it")
            if transition is wanted:
                if not holds:
                    raise _Refuted(f"{target} does not follow: its conditions do not hold")
                return

    def _conditions(
        self, conditions: Sequence[tuple[int, int, bool]], own: set[int]
    ) -> bool | None:
        unknown = False
        for row, along, expected in conditions:
            try:
                _, sign, _ = first_sign(
                    self.tables.rows[row],
                    self.tables.fields[along],
                    self.end,
                    self.behind,
                    int(row in own),
                )
            except Undecided:
                unknown = True
                continue
            if (sign > 0) != expected:
                return False
        return None if unknown else True


def _state(column: arb_mat) -> list[arb]:
    """Coordinates of a state, without the last entry 1."""
    entries: list[arb] = column.entries()
    return entries[:-1]
