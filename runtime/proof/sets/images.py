"""Images of sets of states on a section, and the transitions on the way, proved in balls.

From set to set each phase ends by the first boundary that any of its states reaches, the same
for all of them and transversally, and the transition behind it is the one that follows for all.
So the map is analytic on the set. Where balls cannot tell, the set has to be divided.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row
from nonsmooth.runtime.proof.motion.first_crossing import first_crossing
from nonsmooth.runtime.proof.motion.validate import BallJudge, transition_behind
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet, with_time
from nonsmooth.runtime.proof.sets.sections import MapSection

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["PassedTransition", "SectionMap", "SetImage"]

_MOST = 400  # transitions of one image


class PassedTransition(NamedTuple):
    """A transition that a motion passes, by configurations and boundaries."""

    source: int
    boundaries: tuple[int, ...]
    target: int


class SetImage(NamedTuple):
    """The image of a set of states on the section, with the transitions on the way."""

    states: AffineSet
    passages: tuple[PassedTransition, ...]


class SectionMap:
    """An iterate of the map from a section to itself, applied to sets of states."""

    def __init__(self, system: EnclosedSystem, section: MapSection, iterates: int) -> None:
        self.system, self.section, self.iterates = system, section, iterates
        exact, count = system.exact, len(system.structure.configurations)
        self._fields = [with_time(exact.fields[c], 1) for c in range(count)]
        self._resets = [with_time(reset, 0) for reset in exact.resets]

    def image(self, start: AffineSet) -> SetImage:
        """Return the image of a set of states on the section.

        `Undecided` is raised if its states do not all go the same way, or balls do not tell which.
        """
        if self.section.phase is not None:
            return self._after_periods(start)
        return self._after_returns(start)

    def _after_periods(self, start: AffineSet) -> SetImage:
        from flint import arb

        section, size = self.section, start.columns.nrows()
        whole = self.iterates * section.period(self.system)
        clock = _row([*(arb(0),) * (size - 2), arb(1), -whole])
        here, facts, states = section.configuration, section.facts, start
        passages: list[PassedTransition] = []
        while True:
            left = whole - states.ranges[-2]
            lasting = facts.lasting(self.system.exact.fields[here])
            found = self._next(here, facts, lasting, states, left.upper())
            if found is None or found[0] > left:
                if here != section.configuration:
                    raise Undecided("the configuration is another one", digits=False)
                end = Invariants.of([*lasting.rows, *self._forcing_facts()])
                if not all(not any(end.reduce(row)) for row in section.facts.rows):
                    raise Undecided("the state is not on the section", digits=False)
                return SetImage(states.reach(self._fields[here], clock, left), tuple(passages))
            if not found[0] < left:
                raise Undecided("a boundary is reached when the forcing has the section's phase")
            here, facts, states = self._through(here, facts, lasting, states, found, passages)

    def _forcing_facts(self) -> list[Row]:
        c, s = self.system.structure.forcing[0]
        return [self.section.facts.rows[self.section.facts.pivots.index(k)] for k in (c, s)]

    def _after_returns(self, start: AffineSet) -> SetImage:
        section = self.section
        here, facts, states = section.configuration, section.facts, start
        passages: list[PassedTransition] = []
        left = self.iterates
        while True:
            lasting = facts.lasting(self.system.exact.fields[here])
            found = self._next(here, facts, lasting, states, None)
            if found is None:
                raise Undecided("the section is not reached again", digits=False)
            here, facts, states = self._through(here, facts, lasting, states, found, passages)
            last = passages[-1]
            if (last.source, frozenset(last.boundaries), last.target) == (
                section.source,
                section.boundaries,
                section.configuration,
            ):
                left -= 1
                if not left:
                    if not all(not any(facts.reduce(row)) for row in section.facts.rows):
                        raise Undecided("the state is not on the section", digits=False)
                    return SetImage(states, tuple(passages))

    def _next(
        self,
        here: int,
        facts: Invariants,
        lasting: Invariants,
        states: AffineSet,
        until: arb | None,
    ) -> tuple[arb, tuple[int, ...]] | None:
        hull = facts.tighten(states.ranges[:-2])
        found = first_crossing(self.system, here, facts, lasting, hull, until)
        return None if found is None else (found.time, found.boundaries)

    def _through(
        self,
        here: int,
        facts: Invariants,
        lasting: Invariants,
        states: AffineSet,
        found: tuple[arb, tuple[int, ...]],
        passages: list[PassedTransition],
    ) -> tuple[int, Invariants, AffineSet]:
        """Return configuration, facts and states behind the transition at the end of a phase."""
        system, (dwell, reached) = self.system, found
        if len(passages) >= _MOST:
            raise Undecided(f"there are more than {_MOST} transitions", digits=False)
        exact = system.exact
        if len(reached) > 1:
            raise Undecided("boundaries are reached together", digits=False)
        if not dwell.is_zero():
            rows = [exact.rows[system.structure.boundaries[here][b].row] for b in reached]
            states = states.reach(self._fields[here], _timed(rows[0]), dwell)
            facts = Invariants.of([*lasting.rows, *rows])
        elif not passages:
            raise Undecided("the set is beyond a boundary", digits=False)
        hull = facts.tighten(states.ranges[:-2])
        judge = BallJudge(system, here, facts, hull)
        target, reset = transition_behind(system, here, reached, judge)
        passages.append(PassedTransition(here, reached, target))
        return target, facts.reset(exact.resets[reset]), states.mapped(self._resets[reset])


def _timed(row: Sequence[Any]) -> arb_mat:
    from flint import arb

    return _row([*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])])


def _row(entries: Sequence[arb]) -> arb_mat:
    from flint import arb_mat

    return arb_mat([list(entries)])
