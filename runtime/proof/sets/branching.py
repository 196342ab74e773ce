"""Images of sets that divide, many at once: each state of a set goes to one of its leaves.

Where states of a set do not all go the same way, the set goes every way that one of them may go:
at a boundary that some reach first, and behind it at each condition that is not decided for all.
The leaves contain all images, and they may contain more, so they prove where motions lead and
not where they do not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import (
    LONGEST,
    Floats,
    ManySets,
    Rounded,
    joined_sets,
    within,
)
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.model.structure import BoundaryShape, TransitionShape
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.proof.motion.validate import BallJudge, transition_behind
from nonsmooth.runtime.proof.sets.affine_sets import with_time
from nonsmooth.runtime.proof.sets.images import PassedTransition
from nonsmooth.runtime.proof.sets.phase_ends import CLOCK, EndedSets
from nonsmooth.runtime.proof.sets.sections import MapSection
from nonsmooth.runtime.proof.sets.set_parts import (
    PartsLeft,
    SetParts,
    StartKind,
    direction,
    first_moving,
    kept,
    negative,
    opposite,
    rounded_row,
)
from nonsmooth.runtime.proof.sets.started_phase import StartedPhase

if TYPE_CHECKING:
    pass

__all__ = ["BranchingMap", "Leaves"]

_STEP = 0.125  # of the time in which the fastest motion goes half a radian


class Leaves(NamedTuple):
    """The parts of the images of B sets on a section: L boxes in its d coordinates."""

    origin: NDArray[np.int_]  # (L,): number of the set that each is a part of
    low: Floats  # (L, d): lower bounds of the section's coordinates
    high: Floats  # (L, d): upper bounds
    lost: NDArray[np.bool_]  # (B,): sets of which not all leaves are known


@dataclass
class BranchingMap:
    """The map from sets of states to a section, along all ways that their states may go."""

    system: EnclosedSystem
    section: MapSection
    scales: Floats  # sizes of the states (N,)
    widest: float = np.inf  # sets that are wider, in units of the scales, are divided on the way
    most: int = 400  # largest number of parts of one set
    longest: int = 40  # largest number of transitions on one way
    # part of a window of time into which flow pipes are divided where they touch boundaries: small
    # sets take 1/8; large ones become more parts by it, and hardly narrower
    finest: float = 0.125
    # all transitions that some set has passed
    passages: set[PassedTransition] = field(default_factory=set)

    def __post_init__(self) -> None:
        exact, structure = self.system.exact, self.system.structure
        count, states = len(structure.configurations), len(structure.states)
        if states + 2 > LONGEST:
            raise InputError(
                f"{structure.name} has {states} states: sets are carried with up to {LONGEST - 2}"
            )
        self._fields = [with_time(exact.fields[c], 1) for c in range(count)]
        self._flows = [
            FloatFlow(own, float(flow.half) * _STEP)
            for own, flow in zip(self._fields, self.system.flows, strict=True)
        ]
        self._resets = [Rounded.of(with_time(reset, 0)) for reset in exact.resets]
        self._timed = self.section.phase is not None
        self._phases: dict[StartKind, StartedPhase] = {}

    def leaves(self, starts: ManySets) -> Leaves:
        """Return boxes that contain where each state of each set first comes to the section.

        The sets are in the section's coordinates and 1.
        """
        facts = self.section.facts
        return self.leaves_of(starts.mapped(self.lift(facts)), self.section.configuration, facts)

    def leaves_of(
        self,
        starts: ManySets,
        configuration: int,
        facts: Invariants,
        wanted: Callable[[Floats, Floats], NDArray[np.bool_]] | None = None,
    ) -> Leaves:
        """Return the leaves of sets of states (y, t, 1) anywhere in a configuration.

        The states are inside the boundaries or on the section, and `facts` hold exactly for them.
        `wanted` says, by bounds (L, d) of leaves, which of these are where they should be: sets
        with other leaves are lost, and not followed further.
        """
        rows = [self.system.exact.rows[s.row] for s in self._shapes(configuration)]
        inside = frozenset(b for b, row in enumerate(rows) if any(facts.reduce(row)))
        work = PartsLeft(len(starts), self.most)
        none = np.zeros(len(starts), dtype=int)
        work.add(
            StartKind(configuration, facts, inside, 0),
            SetParts(starts, np.arange(len(starts)), none),
        )
        found: list[tuple[Any, Floats, Floats]] = []
        while (taken := work.take()) is not None:
            kind, parts = taken
            if (far := parts.depth >= self.longest).any():
                work.lose(parts.origin[far])
                parts = parts.chosen(~far)
            parts = self._divided(parts, work)
            if not len(parts.origin):
                continue
            for next_kind, next_parts, forced in self._behind_phase(kind, parts, work):
                if self._is_leaf(next_kind, forced, kind):
                    leaf = next_parts
                    if forced is not None:
                        leaf = self._inside(next_kind, next_parts, work)
                    low, high = (x[:, list(self.section.free)] for x in leaf.states.hull)
                    if wanted is not None:
                        work.lose(leaf.origin[~wanted(low, high)])
                    found.append((leaf.origin, low, high))
                else:
                    work.add(next_kind, next_parts)
        size = len(self.section.free)
        origin, low, high = (
            (np.concatenate(x) for x in zip(*found, strict=True))
            if found
            else (np.zeros(0, dtype=int), np.zeros((0, size)), np.zeros((0, size)))
        )
        known = ~work.lost[origin]
        return Leaves(origin[known], low[known], high[known], work.lost)

    def _divided(self, parts: SetParts, work: PartsLeft) -> SetParts:
        """Return the parts with those that are too wide halved, as often as it takes."""
        if not np.isfinite(self.widest):
            return parts
        while True:
            count = len(self.scales)
            lengths = np.abs(parts.states.sides[:, :count, :]) / self.scales[None, :, None]
            wide = lengths.sum(axis=2).max(axis=1) > self.widest
            if not wide.any():
                return parts
            side = np.argmax(lengths[wide].max(axis=1), axis=1)
            halves = parts.states[wide].halves(side)
            again = np.tile(np.flatnonzero(wide), 2)
            origin = np.concatenate([np.flatnonzero(~wide), again])
            states = joined_sets([parts.states[~wide], halves])
            parts = parts.of(states, origin)
            work.count(parts.origin[-len(again) // 2 :])
            parts = parts.chosen(~work.lost[parts.origin])

    def _is_leaf(self, kind: StartKind, forced: PassedTransition | None, before: StartKind) -> bool:
        section = self.section
        if section.phase is not None:
            if forced is not None or kind.configuration != section.configuration:
                return False
        elif forced is None or (forced.source, frozenset(forced.boundaries), forced.target) != (
            section.source,
            section.boundaries,
            section.configuration,
        ):
            return False
        return all(not any(kind.facts.reduce(row)) for row in section.facts.rows)

    def _inside(self, kind: StartKind, parts: SetParts, work: PartsLeft) -> SetParts:
        """Return the part of leaves inside all boundaries.

        States beyond one leave their phase at once: that part is followed further.
        """
        for b, shape in enumerate(self._shapes(kind.configuration)):
            row = self.system.exact.rows[shape.row]
            if b in kind.under or not any(kind.facts.reduce(row)):
                continue
            if any(self.section.facts.reduce(row)):
                function = rounded_row(row)
                work.add(kind, kept(parts, function))
                parts = kept(parts, negative(function))
        return parts

    # along a phase and behind it

    def _behind_phase(
        self, kind: StartKind, parts: SetParts, work: PartsLeft
    ) -> Iterator[tuple[StartKind, SetParts, PassedTransition | None]]:
        phase = self._phases.get(kind)
        if phase is None:
            flow = self._flows[kind.configuration]
            phase = StartedPhase(self.system, self.section, flow, self.finest, kind)
            self._phases[kind] = phase
        for end in phase.ends(parts, work):
            own = parts.of(end.states, end.origin)
            if end.boundaries == (CLOCK,):
                states = own.states.fewer_sides(
                    self._free(end.facts), self.lift(end.facts, self._timed)
                )
                next_kind = kind._replace(facts=end.facts, under=frozenset(), clock=kind.clock + 1)
                yield next_kind, own._replace(states=states), None
                continue
            yield from self._passed(kind, end, own, work)

    def _passed(
        self, kind: StartKind, end: EndedSets, parts: SetParts, work: PartsLeft
    ) -> Iterator[tuple[StartKind, SetParts, PassedTransition]]:
        """Yield the parts behind the transitions that may follow what their states reach."""
        here, reached = kind.configuration, frozenset(end.boundaries)
        exact = self.system.exact
        inside = [exact.rows[s.row] for b, s in enumerate(self._shapes(here)) if b not in reached]
        known = frozenset(
            direction(end.facts.reduce(row)) for row in (*inside, *map(opposite, end.rising))
        )
        for target, reset, own, before, under in self._followed(
            here, reached, end.facts, parts, known, work
        ):
            facts = before.reset(exact.resets[reset])
            if not facts.consistent:
                continue
            states = own.states.mapped(self._resets[reset])
            box = self._reset_box(own.states, under, reset)
            states = states.fewer_sides(self._free(facts), self.lift(facts, self._timed), box)
            passage = PassedTransition(here, tuple(sorted(reached)), target)
            self.passages.add(passage)
            below = frozenset(
                b
                for b, shape in enumerate(self._shapes(target))
                if self._below(target, shape.row, facts, reset, before, under)
            )
            next_kind = StartKind(target, facts, below, kind.clock)
            yield next_kind, SetParts(states, own.origin, own.depth + 1), passage

    def _reset_box(
        self, states: ManySets, under: frozenset[Row], reset: int
    ) -> tuple[Floats, Floats]:
        """Return boxes around images under a reset.

        Of the states before it only those count at which the functions in `under` are at most zero.
        States of forcings lie in [-1, 1].
        """
        box = states.hull
        for row in under:
            if any(row[:-1]):
                box = within(box, rounded_row(row))
        for k in (k for pair in self.system.structure.forcing for k in pair):
            box[0][:, k], box[1][:, k] = np.maximum(box[0][:, k], -1), np.minimum(box[1][:, k], 1)
        low, high = box
        middle = (low + high) / 2
        half = np.maximum(high - middle, middle - low)[:, :, None] * np.eye(low.shape[1])
        return ManySets(middle, half, np.zeros_like(middle)).mapped(self._resets[reset]).hull

    def _below(
        self,
        target: int,
        number: int,
        facts: Invariants,
        reset: int,
        before: Invariants,
        known: frozenset[Row],
    ) -> bool:
        """Whether a function's first nonzero derivative behind a reset is known to be at most zero.

        It is so where it is, as a function of the state before the reset, one of those known.
        """
        exact = self.system.exact
        row, order = first_moving(exact.rows[number], exact.fields[target], facts)
        if order < 0:
            return False
        pulled = before.reduce(product(row, exact.resets[reset]))
        if not any(pulled[:-1]):
            return pulled[-1] <= 0
        return direction(pulled) in known

    def _shapes(self, configuration: int) -> Sequence[BoundaryShape]:
        return self.system.structure.boundaries[configuration]

    def _followed(
        self,
        here: int,
        reached: frozenset[int],
        facts: Invariants,
        parts: SetParts,
        known: frozenset[Row],
        work: PartsLeft,
    ) -> Iterator[tuple[int, int, SetParts, Invariants, frozenset[Row]]]:
        """Yield each target and reset that may follow, with the parts of sets for which it may.

        What is exactly true of the parts comes with them, and functions known to be at most zero.
        """
        structure = self.system.structure
        listed = [t for t in structure.listed(here, reached) if t.path is None]
        if len(structure.orders(here, reached)) == 1 and listed:
            yield from self._tried(listed, 0, facts, parts, known, work)
            return
        for k in range(len(parts.origin)):
            one = parts.chosen([k])
            try:
                target, reset = self._judged(here, reached, facts, one.states)
            except Undecided:
                work.lose(one.origin)
                continue
            yield target, reset, one, facts, known

    def _judged(
        self, here: int, reached: frozenset[int], facts: Invariants, states: ManySets
    ) -> tuple[int, int]:
        from flint import arb

        low, high = states.hull
        size = len(self.system.structure.states)
        balls = [arb(a).union(arb(b)) for a, b in zip(low[0, :size], high[0, :size], strict=True)]
        judge = BallJudge(self.system, here, facts, facts.tighten(balls))
        return transition_behind(self.system, here, tuple(sorted(reached)), judge)

    def _tried(
        self,
        listed: Sequence[TransitionShape],
        place: int,
        facts: Invariants,
        parts: SetParts,
        known: frozenset[Row],
        work: PartsLeft,
    ) -> Iterator[tuple[int, int, SetParts, Invariants, frozenset[Row]]]:
        """Yield what may follow by the listed transitions, from a condition of the first one on.

        Where a function would need a sign that it is known not to have, it is exactly zero, and its
        next derivative decides.
        """
        if not len(parts.origin):
            return
        if not listed:
            work.lose(parts.origin)
            return
        shape = listed[0]
        if place == len(shape.conditions):
            yield shape.target, shape.reset, parts, facts, known
            return
        number, along, holds = shape.conditions[place]
        row, order = first_moving(
            self.system.exact.rows[number], self.system.exact.fields[along], facts
        )
        if order < 0:
            ways = [(parts, False, known)]
        else:
            ways = []
            for positive, towards in ((True, row), (False, opposite(row))):
                if direction(towards) not in known:
                    part = kept(parts, rounded_row(towards))
                    ways.append((part, positive, known | {direction(opposite(towards))}))
                    continue
                exactly = Invariants.of([*facts.rows, row])
                if exactly.consistent:
                    states, alive = parts.states.cut(rounded_row(row), zero=True)
                    part = parts.chosen(alive)._replace(states=states[alive])
                    still = frozenset(direction(exactly.reduce(own)) for own in known)
                    yield from self._tried(listed, place, exactly, part, still, work)
        for part, positive, now in ways:
            if positive == holds:
                yield from self._tried(listed, place + 1, facts, part, now, work)
            else:
                yield from self._tried(listed[1:], 0, facts, part, now, work)

    # what the states of some facts are

    def _free(self, facts: Invariants) -> list[int]:
        size = len(self.system.structure.states)
        free = [k for k in range(size) if k not in facts.pivots]
        return [*free, size] if self._timed else free

    def lift(self, facts: Invariants, timed: bool = False) -> Rounded:
        """Return the map to all coordinates (y, t, 1) from those that the facts leave free.

        It acts on the free coordinates, t and 1. If not `timed`, t is left out and becomes 0.
        """
        from flint import arb, arb_mat

        size = len(self.system.structure.states)
        free = [k for k in range(size) if k not in facts.pivots]
        given = dict(zip(facts.pivots, facts.rows, strict=True))
        count = len(free) + timed
        found = arb_mat(size + 2, count + 1)
        for k in range(size):
            if k in given:
                for i, j in enumerate(free):
                    found[k, i] = arb(-given[k][j])
                found[k, count] = arb(-given[k][size])
            else:
                found[k, free.index(k)] = arb(1)
        if timed:
            found[size, len(free)] = arb(1)
        found[size + 1, count] = arb(1)
        return Rounded.of(found)
