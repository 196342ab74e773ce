"""Images of sets that divide, many at once: each state of a set goes to one of its leaves.

Where states of a set do not all go the same way, the set goes every way that one of them may go:
at a boundary that some reach first, and behind it at each condition that is not decided for all.
The leaves contain all images, and they may contain more, so they prove where motions lead and
not where they do not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations
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
from nonsmooth.runtime.proof.sets.phase_ends import CLOCK, EndedSets, PhaseEnds, WatchedFunction
from nonsmooth.runtime.proof.sets.sections import MapSection

if TYPE_CHECKING:
    from flint import arb_mat

__all__ = ["BranchingMap", "Leaves"]

_AT_ONCE = 4096  # sets
_STEP = 0.125  # of the time in which the fastest motion goes half a radian


class Leaves(NamedTuple):
    """Where parts of sets come to on a section.

    Attributes
    ----------
    origin : array of int (L,)
        Of which set each is a part.
    low, high : array (L, d)
        Bounds of the section's coordinates.
    lost : array of bool (B,)
        Sets of which not all leaves are known.
    """

    origin: NDArray[np.int_]
    low: Floats
    high: Floats
    lost: NDArray[np.bool_]


class _StartKind(NamedTuple):
    """What is true of parts where their phase begins.

    The functions of the boundaries in `under` are not positive, with their first derivative that
    is not exactly zero; `clock` counts passages of the forcing's phase.
    """

    configuration: int
    facts: Invariants
    under: frozenset[int]
    clock: int


class _SetParts(NamedTuple):
    """Parts of one kind: of which set, and behind how many transitions."""

    states: ManySets
    origin: NDArray[np.int_]
    depth: NDArray[np.int_]

    def chosen(self, mask: Any) -> _SetParts:
        return _SetParts(self.states[mask], self.origin[mask], self.depth[mask])

    def of(self, states: ManySets, origin: Any) -> _SetParts:
        """Parts of these parts."""
        return _SetParts(states, self.origin[origin], self.depth[origin])


@dataclass
class BranchingMap:
    """The map from sets of states to a section, whatever ways the states go.

    Attributes
    ----------
    system : EnclosedSystem
    section : MapSection
    scales : array (N,)
        Of the states.
    widest : float
        Sets that are wider, in units of the scales, are divided on the way.
    most : int
        Parts of one set, at most.
    longest : int
        Transitions on one way, at most.
    finest : float
        Part of a window of time into which flow pipes are divided where they touch boundaries.
        Small sets take 1/8; large ones become more parts by it, and hardly narrower.
    passages : set of PassedTransition
        All transitions that some set has passed.
    """

    system: EnclosedSystem
    section: MapSection
    scales: Floats
    widest: float = np.inf
    most: int = 400
    longest: int = 40
    finest: float = 0.125
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
        self._phases: dict[_StartKind, _StartedPhase] = {}

    def leaves(self, starts: ManySets) -> Leaves:
        """Boxes that contain where each state of each set comes to the section first.

        Parameters
        ----------
        starts : ManySets
            In coordinates of the section and 1.

        Returns
        -------
        Leaves
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
        """The same for states anywhere.

        Parameters
        ----------
        starts : ManySets
            Of (y, t, 1), inside of the boundaries of a configuration or on the section.
        configuration : int
        facts : Invariants
            What is exactly true of the states.
        wanted : callable, optional
            Of bounds (L, d) each, whether leaves are where they should be: sets with others are
            lost, and not followed further.

        Returns
        -------
        Leaves
        """
        rows = [self.system.exact.rows[s.row] for s in self._shapes(configuration)]
        inside = frozenset(b for b, row in enumerate(rows) if any(facts.reduce(row)))
        work = _PartsLeft(len(starts), self.most)
        none = np.zeros(len(starts), dtype=int)
        work.add(
            _StartKind(configuration, facts, inside, 0),
            _SetParts(starts, np.arange(len(starts)), none),
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

    def _divided(self, parts: _SetParts, work: _PartsLeft) -> _SetParts:
        """Those that are wide in two, as often as it takes."""
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

    def _is_leaf(
        self, kind: _StartKind, forced: PassedTransition | None, before: _StartKind
    ) -> bool:
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

    def _inside(self, kind: _StartKind, parts: _SetParts, work: _PartsLeft) -> _SetParts:
        """Of leaves what no boundary lies behind: states beyond one leave their phase at once."""
        for b, shape in enumerate(self._shapes(kind.configuration)):
            row = self.system.exact.rows[shape.row]
            if b in kind.under or not any(kind.facts.reduce(row)):
                continue
            if any(self.section.facts.reduce(row)):
                function = _rounded(row)
                work.add(kind, _kept(parts, function))
                parts = _kept(parts, _negative(function))
        return parts

    # along a phase and behind it

    def _behind_phase(
        self, kind: _StartKind, parts: _SetParts, work: _PartsLeft
    ) -> Iterator[tuple[_StartKind, _SetParts, PassedTransition | None]]:
        phase = self._phases.get(kind)
        if phase is None:
            phase = self._phases[kind] = _StartedPhase(self, kind)
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
        self, kind: _StartKind, end: EndedSets, parts: _SetParts, work: _PartsLeft
    ) -> Iterator[tuple[_StartKind, _SetParts, PassedTransition]]:
        """The ways in which states go on behind what they reach."""
        here, reached = kind.configuration, frozenset(end.boundaries)
        exact = self.system.exact
        inside = [exact.rows[s.row] for b, s in enumerate(self._shapes(here)) if b not in reached]
        known = frozenset(
            _direction(end.facts.reduce(row)) for row in (*inside, *map(_opposite, end.rising))
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
            next_kind = _StartKind(target, facts, below, kind.clock)
            yield next_kind, _SetParts(states, own.origin, own.depth + 1), passage

    def _reset_box(
        self, states: ManySets, under: frozenset[Row], reset: int
    ) -> tuple[Floats, Floats]:
        """Boxes behind a reset, of states for which functions are not positive."""
        box = states.hull
        for row in under:
            if any(row[:-1]):
                box = within(box, _rounded(row))
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
        """Whether the first derivative that is not zero behind a reset is known not to be positive.

        So it is where, as a function of the state before, it is one of those.
        """
        exact = self.system.exact
        row, order = _leading(exact.rows[number], exact.fields[target], facts)
        if order < 0:
            return False
        pulled = before.reduce(product(row, exact.resets[reset]))
        if not any(pulled[:-1]):
            return pulled[-1] <= 0
        return _direction(pulled) in known

    def _shapes(self, configuration: int) -> Sequence[BoundaryShape]:
        return self.system.structure.boundaries[configuration]

    def _followed(
        self,
        here: int,
        reached: frozenset[int],
        facts: Invariants,
        parts: _SetParts,
        known: frozenset[Row],
        work: _PartsLeft,
    ) -> Iterator[tuple[int, int, _SetParts, Invariants, frozenset[Row]]]:
        """Targets and resets that may follow, with the parts for which they may.

        And with what is exactly true of these, and functions that are known not to be positive.
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
        parts: _SetParts,
        known: frozenset[Row],
        work: _PartsLeft,
    ) -> Iterator[tuple[int, int, _SetParts, Invariants, frozenset[Row]]]:
        """What may follow of the transitions from the first on, from one of its conditions on.

        Where a function would have a sign that it is known not to have it is exactly zero, and
        its next derivative decides.
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
        row, order = _leading(
            self.system.exact.rows[number], self.system.exact.fields[along], facts
        )
        if order < 0:
            ways = [(parts, False, known)]
        else:
            ways = []
            for positive, towards in ((True, row), (False, _opposite(row))):
                if _direction(towards) not in known:
                    part = _kept(parts, _rounded(towards))
                    ways.append((part, positive, known | {_direction(_opposite(towards))}))
                    continue
                exactly = Invariants.of([*facts.rows, row])
                if exactly.consistent:
                    states, alive = parts.states.cut(_rounded(row), zero=True)
                    part = parts.chosen(alive)._replace(states=states[alive])
                    still = frozenset(_direction(exactly.reduce(own)) for own in known)
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
        """All coordinates of states for which facts are true, by those that are left free.

        Parameters
        ----------
        facts : Invariants
        timed : bool
            Whether the time is one of them; else it is 0.

        Returns
        -------
        Rounded
            (y, t, 1) from (free coordinates, t, 1) or, without time, (free coordinates, 1).
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


class _PartsLeft:
    """Parts that are to be followed, by their kinds."""

    def __init__(self, count: int, most: int) -> None:
        self.most = most
        self.lost = np.zeros(count, dtype=bool)
        self._seen = np.zeros(count, dtype=int)
        self._left: dict[_StartKind, list[_SetParts]] = {}

    def add(self, kind: _StartKind, parts: _SetParts) -> None:
        self.count(parts.origin)
        self._left.setdefault(kind, []).append(parts)

    def count(self, origin: NDArray[np.int_]) -> None:
        """Count parts of sets; those with too many are lost."""
        np.add.at(self._seen, origin, 1)
        self.lost |= self._seen > self.most

    def lose(self, origin: NDArray[np.int_]) -> None:
        self.lost[origin] = True

    def take(self) -> tuple[_StartKind, _SetParts] | None:
        """The most parts of one kind, as many as are followed at once."""
        if not self._left:
            return None
        kind = max(self._left, key=lambda own: sum(len(p.origin) for p in self._left[own]))
        listed = self._left.pop(kind)
        parts = _SetParts(
            joined_sets([part.states for part in listed]),
            np.concatenate([part.origin for part in listed]),
            np.concatenate([part.depth for part in listed]),
        )
        parts = parts.chosen(~self.lost[parts.origin])
        if len(parts.origin) > _AT_ONCE:
            self._left[kind] = [parts.chosen(slice(_AT_ONCE, None))]
            parts = parts.chosen(slice(0, _AT_ONCE))
        return kind, parts


class _StartedPhase:
    """The phase that begins with states of one kind."""

    def __init__(self, mapped: BranchingMap, kind: _StartKind) -> None:
        self.kind = kind
        system, here = mapped.system, kind.configuration
        exact, structure = system.exact, system.structure
        lasting = kind.facts.lasting(exact.fields[here])
        self.stuck = False  # beyond a boundary all along
        self.functions: list[WatchedFunction] = []
        self.under: list[bool] = []
        self.still: list[bool] = []
        self.starts: list[Row] = []
        together: dict[Any, tuple[list[int], Row]] = {}
        for b, boundary in enumerate(structure.boundaries[here]):
            row = exact.rows[boundary.row]
            reduced = lasting.reduce(row)
            if not any(reduced[:-1]):
                self.stuck = self.stuck or reduced[-1] > 0
                continue
            size = next(abs(x) for x in reduced if x)
            together.setdefault(tuple(x / size for x in reduced), ([], row))[0].append(b)
        for own, row in together.values():
            leading, order = _leading(row, exact.fields[here], kind.facts)
            if order < 0:
                continue
            self.under.append(any(b in kind.under for b in own))
            self.still.append(not any(lasting.reduce(product(row, exact.fields[here]))))
            facts = Invariants.of([*lasting.rows, row])
            rate = facts.reduce(product(row, exact.fields[here]))
            self.functions.append(
                WatchedFunction(tuple(own), _timed(row), _timed(leading), order, facts, rate)
            )
            self.starts.append(leading)
        if mapped.section.phase is not None:
            section, (c, s) = mapped.section, structure.forcing[0]
            pivots = section.facts.pivots
            forced = [section.facts.rows[pivots.index(k)] for k in (c, s)]
            clock = _clock(section.period(system) * (kind.clock + 1), len(structure.states))
            facts = Invariants.of([*lasting.rows, *forced])
            self.functions.append(WatchedFunction((CLOCK,), clock, clock, 0, facts, ()))
            # states that reach a boundary just then are both on the section and beyond it
            self.under.append(True)
            self.still.append(False)
        self.begins = [Rounded.of(f.leading) for f in self.functions]
        # a function that does not change ends no phase that it does not end at once
        moving = [f for f, still in zip(self.functions, self.still, strict=True) if not still]
        self.phase = PhaseEnds(mapped._flows[here], moving, mapped.finest)

    def ends(self, parts: _SetParts, work: _PartsLeft) -> Iterator[EndedSets]:
        """The ways in which it may end; origins are numbers of the parts."""
        if self.stuck:
            work.lose(parts.origin)
            return
        states, origin = parts.states, np.arange(len(parts.origin))
        values = [tuple(x[:, 0] for x in states.ranges(row)) for row in self.begins]
        passed = [
            k
            for k, ((_, high), under) in enumerate(zip(values, self.under, strict=True))
            if not under and not (high < 0).all()
        ]
        if passed:
            yield from self._passed_at_start(parts, values, passed, work)
        for k, row in enumerate(self.begins):
            states, alive = states.cut(_negative(row))
            sure = values[k][0][origin] > 0
            states, origin = states[alive & ~sure], origin[alive & ~sure]
        if not len(origin):
            return
        found, lost = self.phase.ends(states)
        work.lose(parts.origin[origin[lost]])
        for end in found:
            yield end._replace(origin=origin[end.origin])

    def _passed_at_start(
        self, parts: _SetParts, values: Sequence[Any], passed: Sequence[int], work: _PartsLeft
    ) -> Iterator[EndedSets]:
        """States beyond boundaries at the start of the phase, which they leave at once."""
        touched = [
            k
            for k, (_, high) in enumerate(values)
            if k not in passed and not (high < 0).all() and self.functions[k].boundaries != (CLOCK,)
        ]
        every = [*passed, *touched]
        for count in range(1, len(every) + 1):
            for chosen in combinations(every, count):
                if chosen[0] not in passed:
                    continue
                states, origin = parts.states, np.arange(len(parts.origin))
                for k in every:
                    row = self.begins[k] if k in chosen else _negative(self.begins[k])
                    states, alive = states.cut(row)
                    if k not in chosen:
                        alive &= ~(values[k][0][origin] > 0)
                    else:
                        alive &= ~(values[k][1][origin] < 0)
                    states, origin = states[alive], origin[alive]
                if not len(origin):
                    continue
                if count > 2:
                    work.lose(parts.origin[origin])
                    continue
                boundaries = tuple(b for k in chosen for b in self.functions[k].boundaries)
                rising = tuple(self.starts[k] for k in chosen)
                yield EndedSets(states, origin, boundaries, self.kind.facts, rising)


def _kept(parts: _SetParts, row: Rounded) -> _SetParts:
    """The parts of parts for which a function is not negative."""
    states, alive = parts.states.cut(row)
    return parts.chosen(alive)._replace(states=states[alive])


def _leading(row: Row, along: Sequence[Row], facts: Invariants) -> tuple[Row, int]:
    """The first derivative that is not exactly zero, and its order; -1 if all are."""
    for order in range(len(row) + 1):
        reduced = facts.reduce(row)
        if any(reduced):
            return reduced, order
        row = product(row, along)
    return row, -1


def _opposite(row: Row) -> Row:
    return tuple(-x for x in row)


def _direction(row: Row) -> Row:
    """A row up to a positive factor."""
    size = next((abs(x) for x in row if x), 1)
    return tuple(x / size for x in row)


def _clock(time: Any, size: int) -> arb_mat:
    """The time since another one, as a row."""
    from flint import arb, arb_mat

    return arb_mat([[*(arb(0),) * size, arb(1), -time]])


def _timed(row: Sequence[Any]) -> arb_mat:
    from flint import arb, arb_mat

    return arb_mat([[*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])]])


def _rounded(row: Sequence[Any]) -> Rounded:
    return Rounded.of(_timed(row))


def _negative(row: Rounded) -> Rounded:
    return Rounded(-row.middle, row.radius)
