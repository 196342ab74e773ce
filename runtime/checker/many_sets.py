"""Many sets of states through the phases of a system, whatever ways their states go.

A set goes every way that one of its states may go: what comes to a boundary is cut from it, and
so is what meets a condition. What is cut may be a little more than that, so all arrivals are in
the boxes that are found, and the boxes may be wider. Where it is not stated what follows the set
is lost.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, ctx, fmpq

from nonsmooth.runtime.checker.exact import Elimination, demand, leading, product, reduced
from nonsmooth.runtime.checker.exits import ExitFunction, PhaseExits, negative, rounded
from nonsmooth.runtime.checker.sets import matrix_of
from nonsmooth.runtime.checker.switching import StatedSection, SwitchingSystem, echelon_behind
from nonsmooth.runtime.core.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import Floats, ManySets, Rounded, joined_sets, within

__all__ = ["Arrivals", "ManyMotions"]

_BITS = 80
_TOGETHER = 1024  # parts
_RADIANS = 0.125  # of the fastest motion in a window


class Arrivals(NamedTuple):
    """Boxes (L, d) of the section's coordinates, of which set each is, and which sets are lost."""

    origin: Any
    low: Floats
    high: Floats
    lost: Any


class _Known(NamedTuple):
    """What is known of states where a phase begins.

    Some functions are exactly zero; the boundaries `below` are not positive, with their first
    derivative that is not exactly zero; the forcing came back so many times.
    """

    configuration: str
    facts: tuple[Any, ...]
    below: frozenset[str]
    turns: int


class _Parts(NamedTuple):
    """Parts of sets, and behind how many transitions."""

    states: ManySets
    origin: Any
    passed: Any

    def some(self, which: Any) -> "_Parts":
        return _Parts(self.states[which], self.origin[which], self.passed[which])

    def changed(self, states: ManySets, which: Any) -> "_Parts":
        """States that some of them have become."""
        return _Parts(states, self.origin[which], self.passed[which])

    def where(self, row: Rounded) -> "_Parts":
        """What a function is not negative for."""
        states, alive = self.states.cut(row)
        return self.changed(states[alive], alive)


class _Departure(NamedTuple):
    """Parts that leave a phase by boundaries, or by none where the forcing comes back.

    What is exactly zero there, functions that are not negative, and whether they were beyond
    before.
    """

    parts: _Parts
    names: frozenset[str]
    facts: Any
    rising: tuple[Any, ...]
    beyond: bool


class ManyMotions:
    """Where sets of states come to a section first.

    Parameters
    ----------
    declared : dict
        The declaration of a file.
    parameters : mapping of str to str
        That the file names.
    section : StatedSection
    scales : sequence of float, length N
        Of the states.
    widest : float, optional
        Sets that are wider, in these units, are halved where a phase begins.
    most : int, optional
        Parts of one set.
    longest : int, optional
        Transitions on one way.

    Attributes
    ----------
    facts : list of row
        What is exactly zero on the section.
    free : list of int
        The states that are its coordinates.

    Raises
    ------
    Failure
        If there is no such section, or the declaration is of another kind.
    """

    def __init__(
        self,
        declared: dict[str, Any],
        parameters: Mapping[str, str],
        section: StatedSection,
        scales: Sequence[float],
        widest: float = np.inf,
        most: int = 400,
        longest: int = 40,
    ) -> None:
        self.system, self.section = SwitchingSystem(declared, parameters), section
        self.scales, self.widest = np.array(scales, dtype=float), widest
        self.most, self.longest = most, longest
        self.exactly = Elimination()
        self.facts, self.forced = section.facts(self.system, self.exactly)
        self.free = _without_pivots(self.facts, self.system.size)
        self._flows: dict[str, FloatFlow] = {}
        self._phases: dict[_Known, _Phase] = {}

    def arrivals(self, starts: ManySets) -> Arrivals:
        """Of states on the section.

        Parameters
        ----------
        starts : ManySets
            Of its coordinates and 1.

        Returns
        -------
        Arrivals
        """
        with ctx.workprec(_BITS):
            lifted = starts.mapped(self.lift(self.facts, timed=False))
        return self.leaves(lifted, self.section.configuration, self.facts)

    def leaves(self, starts: ManySets, configuration: str, facts: Sequence[Any]) -> Arrivals:
        """Boxes that contain the first arrival of every state of every set.

        Parameters
        ----------
        starts : ManySets
            Of (y, 0, 1); those of their states are meant that no boundary lies behind.
        configuration : str
            In which they are.
        facts : sequence of row
            What is exactly zero for them; of a forcing also that it has the section's phase.

        Returns
        -------
        Arrivals

        Raises
        ------
        Failure
            If the configuration is not declared, or a forcing has another phase.
        """
        demand(configuration in self.system.fields, "a configuration is not declared")
        known = tuple(self.exactly.echelon(facts))
        here = all(not any(reduced(row, known)) for row in self.forced)
        demand(here, "the forcing has another phase")
        rows = self.system.boundaries[configuration]
        inside = frozenset(name for name, row in rows.items() if any(reduced(row, known)))
        work = _Work(len(starts), self.most)
        each = np.arange(len(starts))
        work.add(_Known(configuration, known, inside, 0), _Parts(starts, each, np.zeros_like(each)))
        found = [(each[:0], *np.zeros((2, 0, len(self.free))))]
        with ctx.workprec(_BITS):
            while (taken := work.take()) is not None:
                for own in self._followed(*taken, work):
                    low, high = own.states.hull
                    found.append((own.origin, low[:, self.free], high[:, self.free]))
        origin, low, high = (np.concatenate(x) for x in zip(*found, strict=True))
        kept = ~work.lost[origin]
        return Arrivals(origin[kept], low[kept], high[kept], work.lost)

    def _followed(self, known: _Known, parts: _Parts, work: "_Work") -> Iterator[_Parts]:
        """Parts through one phase: those on the section are given, the others are left to do."""
        work.lose(parts.origin[parts.passed >= self.longest])
        parts = self._narrow(parts.some(~work.lost[parts.origin]), work)
        if not len(parts.origin):
            return
        if known not in self._phases:
            self._phases[known] = _Phase(self, known)
        for end in self._phases[known].departures(parts, work):
            for behind, own, on_section in self._behind(known, end, work):
                if not on_section or end.beyond:
                    work.add(behind, own)
                elif all(not any(reduced(row, behind.facts)) for row in self.facts):
                    yield own
                else:
                    work.lose(own.origin)

    def _narrow(self, parts: _Parts, work: "_Work") -> _Parts:
        while True:
            spans = np.abs(parts.states.sides[:, : self.system.size]) / self.scales[:, None]
            wide = spans.sum(axis=2).max(axis=1, initial=0.0) > self.widest
            if not wide.any():
                return parts
            longest = spans[wide].max(axis=1).argmax(axis=1)
            halves = parts.changed(
                parts.states[wide].halves(longest), np.tile(wide.nonzero()[0], 2)
            )
            work.count(halves.origin[: len(longest)])
            parts = _joined([parts.some(~wide), halves])
            parts = parts.some(~work.lost[parts.origin])

    def _behind(
        self, known: _Known, end: _Departure, work: "_Work"
    ) -> Iterator[tuple[_Known, _Parts, bool]]:
        """What states become behind an end of a phase; whether they are on the section."""
        here, size = known.configuration, self.system.size
        rows = self.system.boundaries[here].items()
        inside = [reduced(row, end.facts) for name, row in rows if name not in end.names]
        signs = frozenset(map(_direction, (*inside, *map(_opposite, end.rising))))
        if not end.names:
            stays = [tuple(fmpq(int(i == j)) for j in range(size + 1)) for i in range(size + 1)]
            ways = iter([(stays, here, end.parts, signs)])
        else:
            listed = self.system.transitions.get((here, end.names), [])
            ways = self._chosen(listed, end, signs, work)
        section = self.section
        for reset, target, parts, now in ways:
            if target not in self.system.fields:
                work.lose(parts.origin)
                continue
            facts = echelon_behind(self.exactly, end.facts, reset)
            if not all(any(row[:-1]) for row in facts):
                continue  # there are no such states
            matrix = Rounded.of(matrix_of(reset, runs=False))
            box = self._box(parts.states, now).mapped(matrix).hull
            states = parts.states.mapped(matrix).fewer_sides(
                self._places(facts), self.lift(facts, bool(self.forced)), box
            )
            below = frozenset(
                name
                for name, row in self.system.boundaries[target].items()
                if self._stays_below(row, target, facts, reset, end.facts, now)
            )
            turns = known.turns + (not end.names)
            if self.forced:
                arrived = not end.names and target == section.configuration
            else:
                way = here, end.names, target
                arrived = way == (section.source, frozenset({section.boundary}), target)
                arrived &= target == section.configuration
            own = _Parts(states, parts.origin, parts.passed + 1)
            yield _Known(target, tuple(facts), below, turns), own, arrived

    def _chosen(
        self, listed: list[Any], end: _Departure, signs: frozenset[Any], work: "_Work"
    ) -> Iterator[tuple[Any, str, _Parts, frozenset[Any]]]:
        """Resets and targets: the first transition follows whose conditions hold."""
        left = [(0, 0, end.parts, signs)]
        while left:
            number, place, parts, now = left.pop()
            if not len(parts.origin):
                continue
            if number == len(listed):
                work.lose(parts.origin)
                continue
            conditions, reset, target = listed[number]
            if place == len(conditions):
                yield reset, target, parts, now
                continue
            row, along, holds = conditions[place]
            _, first = leading(row, self.system.fields[along], end.facts, 0)
            sides = [(False, parts, now)]
            if first is not None:
                function = rounded(first)
                up, down = parts.where(function), parts.where(negative(function))
                sides = [
                    (True, up, now | {_direction(_opposite(first))}),
                    (False, down, now | {_direction(first)}),
                ]
            for positive, own, then in sides:
                following = (number, place + 1) if positive == holds else (number + 1, 0)
                left.append((*following, own, then))

    def _box(self, states: ManySets, signs: frozenset[Any]) -> ManySets:
        """Boxes around states for which functions are not positive."""
        low, high = states.hull
        for row in signs:
            if any(row[:-1]):
                low, high = within((low, high), rounded(row))
        for k in (k for pair in self.system.forcing if self.forced for k in pair):
            low[:, k], high[:, k] = np.maximum(low[:, k], -1.0), np.minimum(high[:, k], 1.0)
        boxes = ManySets.of_boxes(low[:, :-1], high[:, :-1])
        return boxes

    def _stays_below(
        self, row: Any, target: str, facts: Any, reset: Any, before: Any, signs: frozenset[Any]
    ) -> bool:
        """Whether a boundary's first derivative behind a reset is known not to be positive.

        As a function of the states before it is one of those whose sign is known.
        """
        _, first = leading(row, self.system.fields[target], facts, 0)
        if first is None:
            return False
        pulled = reduced(product(first, reset), before)
        return bool(pulled[-1] <= 0) if not any(pulled[:-1]) else _direction(pulled) in signs

    # what exact facts leave free

    def _places(self, facts: Any) -> list[int]:
        free = _without_pivots(facts, self.system.size)
        return [*free, self.system.size] if self.forced else free

    def lift(self, facts: Any, timed: bool) -> Rounded:
        """(y, t, 1) of states by the coordinates that facts leave free, and 1.

        Parameters
        ----------
        facts : rows
            Reduced.
        timed : bool
            Whether the time is one of these coordinates, the last one; else it is 0.

        Returns
        -------
        Rounded (N + 2, d + 1)
        """
        size = self.system.size
        places = [*_without_pivots(facts, size), *([size] if timed else [])]
        found = arb_mat(size + 2, len(places) + 1)
        for column, k in enumerate(places):
            found[k, column] = arb(1)
        for row in facts:
            pivot = next(k for k, x in enumerate(row) if x)
            for column, k in enumerate(places):
                found[pivot, column] = arb(0 if k == size else -row[k])
            found[pivot, len(places)] = arb(-row[size])
        found[size + 1, len(places)] = arb(1)
        return Rounded.of(found)

    def flow(self, configuration: str) -> FloatFlow:
        """The flow of a configuration.

        Parameters
        ----------
        configuration : str

        Returns
        -------
        FloatFlow
        """
        if configuration not in self._flows:
            matrix = matrix_of(self.system.fields[configuration], runs=True)
            rates = [abs(complex(x)) for x in arb_mat(matrix.mid()).eig(algorithm="approx")]
            fastest = max(*rates, 2.0**-6)
            step = 2.0 ** np.floor(np.log2(_RADIANS / fastest))
            self._flows[configuration] = FloatFlow(matrix, float(step))
        return self._flows[configuration]


class _Phase:
    """The phase of one configuration, with what is known where it begins."""

    def __init__(self, motions: ManyMotions, known: _Known) -> None:
        system, exactly, here = motions.system, motions.exactly, known.configuration
        self.known, field = known, system.fields[here]
        lasting = exactly.lasting([*known.facts], field)
        self.outside = False  # all along
        alike: dict[Any, tuple[list[str], Any]] = {}
        for name, row in system.boundaries[here].items():
            own = reduced(row, lasting)
            if any(own[:-1]):
                alike.setdefault(_direction(own), ([], row))[0].append(name)
            else:
                self.outside = self.outside or own[-1] > 0
        functions, self.first, self.below = [], [], []
        for names, row in alike.values():
            order, first = leading(row, field, known.facts, 0)
            if first is None:
                continue
            facts = exactly.echelon([*lasting, row])
            rate = reduced(product(row, field), facts)
            timed = arb_mat([[*map(arb, row[:-1]), arb(0), arb(row[-1])]])
            functions.append(ExitFunction(frozenset(names), timed, order, facts, rate))
            self.first.append(first)
            self.below.append(bool(known.below.intersection(names)))
        self.begins = [rounded(first) for first in self.first]
        if motions.forced:
            after = 2 * arb.pi() * (known.turns + 1) / arb(system.speed())
            clock = arb_mat([[*(arb(0) for _ in range(system.size)), arb(1), -after]])
            facts = exactly.echelon([*lasting, *motions.forced])
            functions.append(ExitFunction(frozenset(), clock, 0, facts, None))

        self.functions = functions
        self.exits = PhaseExits(motions.flow(here), functions) if functions else None

    def departures(self, parts: _Parts, work: "_Work") -> Iterator[_Departure]:
        """All ways out of the phase."""
        if self.outside or self.exits is None:
            work.lose(parts.origin)
            return
        yield from self._at_once(parts, work)
        for row in self.begins:
            parts = parts.where(negative(row))
        if not len(parts.origin):
            return
        found, lost = self.exits.leave(parts.states)
        work.lose(parts.origin[lost])
        for states, origin, by in found:
            functions = [self.functions[k] for k in by]
            names = frozenset().union(*(own.names for own in functions))
            facts = self.exits.common(by)
            rising = tuple(own.rate for own in functions if own.names)
            yield _Departure(parts.changed(states, origin), names, facts, rising, False)

    def _at_once(self, parts: _Parts, work: "_Work") -> Iterator[_Departure]:
        """States that are beyond boundaries already, or go there."""
        highest = [parts.states.ranges(row)[1][:, 0] for row in self.begins]
        may = [k for k, high in enumerate(highest) if (high >= 0).any()]
        for chosen in (x for n in (1, 2, 3) for x in combinations(may, n)):
            if all(self.below[k] for k in chosen):
                continue
            own = parts
            for k in may:
                own = own.where(self.begins[k] if k in chosen else negative(self.begins[k]))
            if len(chosen) == 3:
                work.lose(own.origin)
            elif len(own.origin):
                names = frozenset().union(*(self.functions[k].names for k in chosen))
                rising = tuple(self.first[k] for k in chosen)
                yield _Departure(own, names, list(self.known.facts), rising, True)


class _Work:
    """Parts that are to be followed, by what is known of them; and which sets are lost."""

    def __init__(self, count: int, most: int) -> None:
        self.lost = np.zeros(count, dtype=bool)
        self._most, self._counted = most, np.zeros(count, dtype=int)
        self._left: dict[_Known, _Parts] = {}

    def add(self, known: _Known, parts: _Parts) -> None:
        self.count(parts.origin)
        have = self._left.get(known)
        self._left[known] = parts if have is None else _joined([have, parts])

    def count(self, origin: Any) -> None:
        np.add.at(self._counted, origin, 1)
        self.lost |= self._counted > self._most

    def lose(self, origin: Any) -> None:
        self.lost[origin] = True

    def take(self) -> tuple[_Known, _Parts] | None:
        """The most parts of which the same is known."""
        if not self._left:
            return None
        known = max(self._left, key=lambda own: len(self._left[own].origin))
        parts = self._left.pop(known)
        parts = parts.some(~self.lost[parts.origin])
        if len(parts.origin) > _TOGETHER:
            self._left[known] = parts.some(slice(_TOGETHER, None))
        return known, parts.some(slice(_TOGETHER))


def _joined(several: list[_Parts]) -> _Parts:
    origin = np.concatenate([own.origin for own in several])
    passed = np.concatenate([own.passed for own in several])
    return _Parts(joined_sets([own.states for own in several]), origin, passed)


def _without_pivots(facts: Any, size: int) -> list[int]:
    pivots = {next(k for k, x in enumerate(row) if x) for row in facts}
    return [k for k in range(size) if k not in pivots]


def _direction(row: Any) -> tuple[Any, ...]:
    """A function up to a positive factor."""
    size = next((abs(x) for x in row if x), fmpq(1))
    return tuple(x / size for x in row)


def _opposite(row: Any) -> tuple[Any, ...]:
    return tuple(-x for x in row)
