"""Images of sets that divide: each state of a set goes to one of the leaves.

Where states of a set do not all go the same way, the set goes every way that one of them may go.
Along a phase its functions are enclosed over windows of time. From the first window in which
some state may reach a boundary, up to one behind which all have, the set's flow pipe is cut with
each boundary that is reached: a branch. States that may miss it go on. Behind a boundary a
condition that is not decided cuts the set in two. The leaves contain all images, and they may
contain more, so they prove where motions lead and not where they do not (flow pipes: A. Girard,
Reachability of uncertain linear systems using zonotopes, HSCC 2005).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.proof.motion.validate import BallJudge, transition_behind
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet, affine_set, with_time
from nonsmooth.runtime.proof.sets.images import PassedTransition
from nonsmooth.runtime.proof.sets.parts import (
    fewer_sides,
    halves,
    hull,
    kept,
    united,
    values_over,
    within,
)
from nonsmooth.runtime.proof.sets.sections import MapSection

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["BranchingMap", "Leaf"]

_DEEPEST = 5  # halvings of a window of time
_PIPE = 256  # of the shortest windows in one branch, at most
_LOOSE = 0.5  # part of a set's size by which a pipe may be larger, if it can be shorter
_RISING = 2  # windows by which a pipe may be longer where functions rise: narrow sets need no more
_LONGEST = 1500  # windows of one phase
_SPARE = 2.0**-40  # of a time, for its rounding
_CLOCK = -1  # stands for the boundary at which the forcing has the section's phase


class Leaf(NamedTuple):
    """Where a part of a set comes to, and through which transitions.

    Attributes
    ----------
    states : AffineSet
        On the section: contains the images of all states that come this way.
    passages : tuple of PassedTransition
    """

    states: AffineSet
    passages: tuple[PassedTransition, ...]


class _StatesOnTheWay(NamedTuple):
    """States of one configuration.

    `under` are functions, by number, that are not positive; `clock` counts passages of the
    forcing's phase.
    """

    states: AffineSet
    configuration: int
    facts: Invariants
    under: frozenset[int]
    passages: tuple[PassedTransition, ...]
    clock: int


class _End(NamedTuple):
    """States that reach boundaries of their configuration, also inside a box (N + 2, 1)."""

    states: AffineSet
    box: arb_mat
    boundaries: tuple[int, ...]
    facts: Invariants


class _Watched(NamedTuple):
    """A boundary that may be reached: also exactly together with others of the same function."""

    boundaries: tuple[int, ...]
    row: Row
    order: int  # of the first derivative that is not zero at the start
    touching: bool  # whether that derivative may be zero too


class BranchingMap:
    """The map from sets of states to a section, whatever ways the states go.

    Parameters
    ----------
    system : EnclosedSystem
    section : MapSection
    widest : float
        Sets that are wider, in units of the scales, are divided on the way.
    scales : sequence of float, length N
        Of the states.
    most : int
        Sets on the way of one, at most.
    longest : int
        Transitions on one way, at most.
    """

    def __init__(
        self,
        system: EnclosedSystem,
        section: MapSection,
        widest: float,
        scales: Sequence[float],
        most: int = 400,
        longest: int = 40,
    ) -> None:
        self.system, self.section = system, section
        self.widest, self.scales, self.most, self.longest = widest, tuple(scales), most, longest
        exact, count = system.exact, len(system.structure.configurations)
        self._fields = [with_time(exact.fields[c], 1) for c in range(count)]
        self._resets = [with_time(reset, 0) for reset in exact.resets]
        self._timed = section.phase is not None
        self._rates = lru_cache(50_000)(self._find_rates)
        self._function = lru_cache(None)(self._find_function)
        self._flow = lru_cache(20_000)(self._find_flow)
        self._lasting = lru_cache(1000)(self._find_lasting)

    def leaves(self, start: AffineSet, configuration: int, facts: Invariants) -> list[Leaf]:
        """Sets on the section that contain where each state of a set comes to it first.

        Parameters
        ----------
        start : AffineSet
            Of a configuration, inside its boundaries, or on the section.
        configuration : int
        facts : Invariants
            What is exactly true of the states.

        Returns
        -------
        list of Leaf

        Raises
        ------
        Undecided
            If balls do not tell where some of the states go, or the ways are too many.
        """
        found: list[Leaf] = []
        inside = {shape.row for shape in self.system.structure.boundaries[configuration]}
        left = [_StatesOnTheWay(start, configuration, facts, frozenset(inside), (), 0)]
        looked = 0
        while left:
            part = left.pop()
            looked += 1
            if looked + len(left) > self.most:
                raise Undecided(f"the set has more than {self.most} parts", digits=False)
            if len(part.passages) >= self.longest:
                raise Undecided(f"there are more than {self.longest} transitions", digits=False)
            if self._wide(part.states):
                both = halves(part.states, self.scales)
                left += [part._replace(states=half) for half in both]
                continue
            behind = [
                (next_part, end.boundaries == (_CLOCK,))
                for end in self._ends(part)
                for next_part in self._behind(part, end)
            ]
            for next_part, forced in self._merged(behind):
                leaf = self._leaf(next_part, forced)
                if leaf is None:
                    left.append(next_part)
                else:
                    found.append(leaf)
        return found

    def _merged(
        self, parts: Sequence[tuple[_StatesOnTheWay, bool]]
    ) -> list[tuple[_StatesOnTheWay, bool]]:
        """The same states in fewer sets: boxes about two that went one way and nearly fill it."""
        found: list[tuple[_StatesOnTheWay, bool]] = []
        for part, forced in parts:
            for k, (other, also) in enumerate(found):
                if also != forced or part[1:] != other[1:]:
                    continue
                both = united(part.states, other.states, part.facts, self._timed, self.scales)
                if both is not None:
                    found[k] = part._replace(states=both), forced
                    break
            else:
                found.append((part, forced))
        return found

    def _wide(self, states: AffineSet) -> bool:
        from flint import arb

        return any(
            sum((abs(x) for x in row[1:]), arb(0)) > self.widest * scale
            for row, scale in zip(states.columns.tolist(), self.scales, strict=False)
        )

    def _leaf(self, part: _StatesOnTheWay, forced: bool) -> Leaf | None:
        """A leaf if the section is reached."""
        section, last = self.section, part.passages[-1] if part.passages else None
        if section.phase is not None:
            if not forced or part.configuration != section.configuration:
                return None
        elif last is None or (last.source, frozenset(last.boundaries), last.target) != (
            section.source,
            section.boundaries,
            section.configuration,
        ):
            return None
        if not all(not any(part.facts.reduce(row)) for row in section.facts.rows):
            return None
        return Leaf(part.states, part.passages)

    # along a phase

    def _ends(self, part: _StatesOnTheWay) -> Iterator[_End]:
        """The ways in which a phase may end."""
        here, states = part.configuration, part.states
        lasting = self._lasting(part.facts, here)
        watched: list[_Watched] = []
        passed: list[tuple[tuple[int, ...], arb_mat, bool]] = []
        for boundaries, row in self._functions(part, lasting):
            reduced, order = self._start(part, row)
            if order < 0:
                continue
            function = _timed(reduced)
            (value,) = values_over(function, states).entries()
            shapes = self.system.structure.boundaries[here]
            under = not order and any(shapes[b].row in part.under for b in boundaries)
            if under and value > 0:
                return
            if under and not value <= 0:
                inside = kept(states, -function)
                if inside is None:
                    return
                states = inside
            elif not value < 0:
                passed.append((boundaries, function, bool(value > 0)))
            watched.append(_Watched(boundaries, row, order, not value < 0))
        if passed:
            surely = any(sure for *_, sure in passed)
            touched = [
                (w.boundaries, _timed(self._start(part, w.row)[0]), False)
                for w in watched
                if w.touching and all(w.boundaries != own for own, *_ in passed)
            ]
            yield from _passed_at_start(part._replace(states=states), passed, touched)
            for _, function, _ in passed:
                inside = None if surely else kept(states, -function)
                if inside is None:
                    return
                states = inside
        yield from self._march(part._replace(states=states), lasting, watched)

    def _functions(
        self, part: _StatesOnTheWay, lasting: Invariants
    ) -> list[tuple[tuple[int, ...], Row]]:
        """Functions of the boundaries that are not constant, each with those that have it."""
        exact, here = self.system.exact, part.configuration
        together: dict[Any, tuple[list[int], Row]] = {}
        for b, boundary in enumerate(self.system.structure.boundaries[here]):
            row = exact.rows[boundary.row]
            reduced = lasting.reduce(row)
            if not any(reduced[:-1]):
                if reduced[-1] > 0:
                    raise Undecided(f"{boundary.name} is passed all along", digits=False)
                continue
            size = next(abs(x) for x in reduced if x)
            together.setdefault(tuple(x / size for x in reduced), ([], row))[0].append(b)
        return [(tuple(own), row) for own, row in together.values()]

    def _start(self, part: _StatesOnTheWay, row: Row) -> tuple[Row, int]:
        """The first derivative that is not exactly zero at the start, and its order; -1: none."""
        field = self.system.exact.fields[part.configuration]
        for order in range(len(row) + 1):
            reduced = part.facts.reduce(row)
            if any(reduced):
                return reduced, order
            row = product(row, field)
        return row, -1

    def _march(
        self, part: _StatesOnTheWay, lasting: Invariants, watched: Sequence[_Watched]
    ) -> Iterator[_End]:
        """Along the phase, window by window."""
        here, states = part.configuration, part.states
        step = float(self.system.flows[here].half)  # a power of 2, as all times are
        depth, index, looked = 0, 0, 0
        first, pipe = None, 0  # where a pipe begins, in the shortest windows, and how many
        most = self._pipe_length(here, states, step / 2**_DEEPEST)
        reached: list[_Watched] = []
        clock = self._timed
        while True:
            looked += 1
            if looked > _LONGEST:
                raise Undecided("a phase does not end", digits=False)
            if first is not None and depth < _DEEPEST:
                index, depth = index << (_DEEPEST - depth), _DEEPEST
            window = step / 2 ** (depth + 1), index  # half of its length, and its number
            may, all_passed, rising = [], False, True
            for boundary in watched:
                inside, passed, rises = self._over(here, boundary, states, window)
                if not inside:
                    may.append(boundary)
                    rising = rising and rises
                all_passed = all_passed or passed
            ticks = clock and self._ticks(part, states, window)
            if not may and not ticks and first is None:
                depth, index = _next(depth, index)
                continue
            if depth < _DEEPEST:
                depth, index = depth + 1, 2 * index
                continue
            if first is None:
                first, pipe, reached = index, 0, []
            reached += [boundary for boundary in may if boundary not in reached]
            pipe += 1
            all_passed = all_passed or ticks == 2
            index += 1
            # what rises is reached in a part of the pipe alone, however long the pipe is
            longest = most + _RISING if rising else most
            if (may or ticks == 1) and not all_passed and pipe < longest:
                continue
            ends = 2 * window[0] * first, 2 * window[0] * index
            yield from self._pipe(part._replace(states=states), lasting, reached, ends, clock)
            if all_passed:
                return
            flow = self._flow(here, ends[1])
            rows = [_timed(boundary.row) * flow for boundary in reached]
            if clock and ticks:
                rows.append(self._tick_row(part) * flow)
            for row in rows:
                left = kept(states, -row)
                if left is None:
                    return
                states = left
            first = None
            depth, index = _next(depth, index - 1)

    def _pipe_length(self, here: int, states: AffineSet, window: float) -> int:
        """In how many windows a flow pipe becomes little wider than the set is."""
        field, box = self._fields[here], hull(states)
        rates = field * (box - box.mid())
        curves = field * field * box
        sizes = [
            [
                float(x.abs_upper() if k else x.rad()) / scale
                for x, scale in zip(e, self.scales, strict=False)
            ]
            for k, e in enumerate((box.entries(), rates.entries(), curves.entries()))
        ]
        room = _LOOSE * max(sizes[0])
        count = 1
        while count < _PIPE:
            half = window * count  # of twice as many
            wide = (half * a + half * half / 2 * b for a, b in zip(*sizes[1:], strict=True))
            if max(wide) > room:
                break
            count *= 2
        return count

    def _over(
        self, here: int, boundary: _Watched, states: AffineSet, window: tuple[float, int]
    ) -> tuple[bool, bool, bool]:
        """Whether a boundary is not reached in a window, all are beyond it behind, and it rises."""
        half, index = window
        order = 0 if index else boundary.order
        rates, around, bulge = self._rates(here, boundary.boundaries[0], half, index, order)
        value, rate, curve = values_over(rates, states).entries()
        over = value + around * rate + bulge * curve
        at_end = value + half * rate + half * half / 2 * curve
        slope = rate + around * curve
        if over < 0 or slope <= 0:  # what is zero where a window begins belongs to the one before
            return True, False, False
        rises = slope > 0
        inside = bool(rises and at_end < 0 and (index or not order))
        return inside, bool(order == 0 and at_end > 0), bool(rises)

    def _find_rates(
        self, here: int, boundary: int, half: float, index: int, order: int
    ) -> tuple[arb_mat, arb, arb]:
        """Rows for a function, its rate and its curvature over a window; the times t, t^2/2."""
        from flint import arb, arb_mat

        field, around = self._fields[here], arb(0, half)
        flow = self._flow(here, half * (2 * index + 1))
        own = self._function(here, boundary)
        for _ in range(order):
            own = own * field
        over = (field * around).exp()
        rows = [own * flow, own * field * flow, own * field * field * over * flow]
        return arb_mat([x.entries() for x in rows]), around, (around * around / 2).union(arb(0))

    def _find_function(self, here: int, boundary: int) -> arb_mat:
        shape = self.system.structure.boundaries[here][boundary]
        return _timed(self.system.exact.rows[shape.row])

    def _find_flow(self, here: int, time: float) -> arb_mat:
        from flint import arb

        return (self._fields[here] * arb(time)).exp()

    def _find_lasting(self, facts: Invariants, here: int) -> Invariants:
        return facts.lasting(self.system.exact.fields[here])

    def _tick_row(self, part: _StatesOnTheWay) -> arb_mat:
        """The time since the forcing has come back as often as it will, as a row."""
        from flint import arb

        whole = (part.clock + 1) * self.section.period(self.system)
        size = part.states.columns.nrows()
        return _row([*(arb(0),) * (size - 2), arb(1), -whole])

    def _ticks(self, part: _StatesOnTheWay, states: AffineSet, window: tuple[float, int]) -> int:
        """Whether the forcing comes back in a window: 0 no, 1 for some states, 2 by its end."""
        half, index = window
        (time,) = values_over(self._tick_row(part), states).entries()
        if time + 2 * half * (index + 1) < 0:
            return 0
        return 2 if time + 2 * half * (index + 1) > 0 else 1

    def _pipe(
        self,
        part: _StatesOnTheWay,
        lasting: Invariants,
        reached: Sequence[_Watched],
        ends: tuple[float, float],
        clock: bool,
    ) -> Iterator[_End]:
        """Where states reach boundaries between two times."""
        here = part.configuration
        rows = {boundary.boundaries: _timed(boundary.row) for boundary in reached}
        exact = {boundary.boundaries: boundary.row for boundary in reached}
        tick = self._tick_row(part) if clock else None
        for own, row in rows.items():
            between = self._between(here, part.states, row, ends)
            if between is None:
                continue
            whole = self._flowed(here, part.states, *between)
            states, box = kept(whole, row, zero=True), hull(whole)
            states = states and kept(states, row * self._fields[here])
            for other, more in rows.items():
                if other != own:
                    states = states and kept(states, -more)
            if tick is not None:
                states = states and kept(states, -tick)
            if not states:
                continue
            yield _End(states, box, own, Invariants.of([*lasting.rows, exact[own]]))
            for other, more in rows.items():
                if other > own:
                    both = kept(states, more, zero=True)
                    for third, last in rows.items():
                        if both and third > other and kept(both, last, zero=True):
                            raise Undecided("three boundaries may be reached together")
                    if both is not None:
                        facts = Invariants.of([*lasting.rows, exact[own], exact[other]])
                        if facts.consistent:
                            yield _End(both, box, (*own, *other), facts)
        between = None if tick is None else self._between(here, part.states, tick, ends)
        if tick is not None and between is not None:
            whole = self._flowed(here, part.states, *between)
            states, box = kept(whole, tick, zero=True), hull(whole)
            for more in rows.values():
                states = states and kept(states, -more)
            if states:
                forced = self._forcing_facts()
                yield _End(states, box, (_CLOCK,), Invariants.of([*lasting.rows, *forced]))

    def _between(
        self, here: int, states: AffineSet, row: arb_mat, ends: tuple[float, float]
    ) -> tuple[float, float] | None:
        """Times between two others at which a function may be zero, by Newton's method."""
        from flint import arb

        begin, end = ends
        for _ in range(2):
            half, field = (end - begin) / 2, self._fields[here]
            flow = self._flow(here, begin + half)
            rates = row * field * (field * arb(0, half)).exp() * flow
            (slope,) = values_over(rates, states).entries()
            if not (slope > 0 or slope < 0):
                break
            (value,) = values_over(row * flow, states).entries()
            late = -value / slope
            first, last = (begin + half + float(x) for x in (late.lower(), late.upper()))
            spare = _SPARE * (abs(first) + abs(last) + half)
            first, last = max(begin, first - spare), min(end, last + spare)
            if first > last:
                return None
            shorter = last - first < 0.8 * (end - begin)
            begin, end = first, last
            if not shorter:
                break
        return begin, end

    def _forcing_facts(self) -> list[Row]:
        c, s = self.system.structure.forcing[0]
        return [self.section.facts.rows[self.section.facts.pivots.index(k)] for k in (c, s)]

    def _flowed(self, here: int, states: AffineSet, begin: float, end: float) -> AffineSet:
        """All states between two times: the time is a further side."""
        from flint import arb, arb_mat

        field, half = self._fields[here], (end - begin) / 2
        moved = states.mapped(self._flow(here, begin + half))
        size = moved.columns.nrows()
        centre = arb_mat([[row[0]] for row in moved.columns.tolist()])
        box = hull(moved)
        rates, around = field * centre, arb(0, half)
        over = (field * around).exp()
        loose = (field * (box - centre)) * around
        loose += field * field * over * box * (around * around / 2)
        wide = [x.abs_upper() for x in loose.entries()]
        added = [k for k in range(size) if not wide[k].is_zero()]
        columns = [
            [*own, rates[k, 0] * half, *(wide[k] if k == place else arb(0) for place in added)]
            for k, own in enumerate(moved.columns.tolist())
        ]
        return affine_set(arb_mat(columns), moved.rest)

    # behind a boundary

    def _behind(self, part: _StatesOnTheWay, end: _End) -> Iterator[_StatesOnTheWay]:
        """The ways in which states go on behind what they reach."""
        here = part.configuration
        if end.boundaries == (_CLOCK,):
            states = fewer_sides(end.states, end.facts, self._timed, end.box)
            yield part._replace(
                states=states, facts=end.facts, under=frozenset(), clock=part.clock + 1
            )
            return
        structure, exact = self.system.structure, self.system.exact
        reached = frozenset(end.boundaries)
        shapes = structure.boundaries[here]
        inside = frozenset(shape.row for b, shape in enumerate(shapes) if b not in reached)
        for target, reset, states, less in self._followed(here, reached, end):
            under = less | inside
            facts = end.facts.reset(exact.resets[reset])
            if not facts.consistent:
                continue
            matrix = self._resets[reset]
            box = matrix * end.box
            for row in sorted(inside):
                box = within(box, exact.rows[row]) if self._kept_by(row, reset) else box
            moved = fewer_sides(states.mapped(matrix), facts, self._timed, box)
            kept_rows = {r for r in under if self._kept_by(r, reset)}
            passage = PassedTransition(here, tuple(sorted(reached)), target)
            watched = {shape.row for shape in structure.boundaries[target]}
            yield _StatesOnTheWay(
                moved,
                target,
                facts,
                frozenset(kept_rows & watched),
                (*part.passages, passage),
                part.clock,
            )

    def _kept_by(self, row: int, reset: int) -> bool:
        exact = self.system.exact
        return product(exact.rows[row], exact.resets[reset]) == tuple(exact.rows[row])

    def _followed(
        self, here: int, reached: frozenset[int], end: _End
    ) -> Iterator[tuple[int, int, AffineSet, frozenset[int]]]:
        """Targets and resets that may follow, with the states for which they may."""
        structure = self.system.structure
        listed = [t for t in structure.listed(here, reached) if t.path is None]
        if len(structure.orders(here, reached)) > 1 or not listed:
            facts, box = end.facts, hull(end.states).entries()
            judge = BallJudge(self.system, here, facts, facts.tighten(box[:-2]))
            target, reset = transition_behind(self.system, here, tuple(sorted(reached)), judge)
            yield target, reset, end.states, frozenset()
            return
        yield from self._tried(listed, 0, end.facts, end.states, frozenset())

    def _tried(
        self,
        listed: Sequence[TransitionShape],
        place: int,
        facts: Invariants,
        states: AffineSet,
        under: frozenset[int],
    ) -> Iterator[tuple[int, int, AffineSet, frozenset[int]]]:
        """What may follow of the transitions from the first on, from one of its conditions on."""
        from flint import arb

        if not listed:
            raise Undecided("no transition may follow", digits=False)
        shape = listed[0]
        if place == len(shape.conditions):
            yield shape.target, shape.reset, states, under
            return
        number, along, holds = shape.conditions[place]
        reduced, order = self._leading(number, along, facts)
        if order < 0:
            positive, value = None, arb(-1)
        else:
            positive = _timed(reduced)
            (value,) = values_over(positive, states).entries()
        above: AffineSet | None = states
        below: AffineSet | None = states
        if positive is not None and not (value > 0 or value < 0):
            above, below = kept(states, positive), kept(states, -positive)
        elif value > 0:
            below = None
        else:
            above = None
        less = under | {number} if not order else under
        for part, met, now in ((above, holds, under), (below, not holds, less)):
            if part is None:
                continue
            if met:
                yield from self._tried(listed, place + 1, facts, part, now)
            else:
                yield from self._tried(listed[1:], 0, facts, part, now)

    def _leading(self, number: int, along: int, facts: Invariants) -> tuple[Row, int]:
        row = self.system.exact.rows[number]
        field = self.system.exact.fields[along]
        for order in range(len(row) + 1):
            reduced = facts.reduce(row)
            if any(reduced):
                return reduced, order
            row = product(row, field)
        return row, -1


def _passed_at_start(
    part: _StatesOnTheWay,
    passed: Sequence[tuple[tuple[int, ...], arb_mat, bool]],
    touched: Sequence[tuple[tuple[int, ...], arb_mat, bool]],
) -> Iterator[_End]:
    """The sets of boundaries beyond which states may be at the start of a phase.

    Those of `touched` are at most reached.
    """
    every = [*passed, *touched]
    for count in range(1, len(every) + 1):
        for chosen in combinations(range(len(every)), count):
            left: AffineSet | None = part.states
            for k, (_, function, sure) in enumerate(every):
                if k in chosen:
                    left = left and kept(left, function)
                elif sure:
                    left = None
                elif k < len(passed):
                    left = left and kept(left, -function)
            if left is None or chosen[0] >= len(passed):
                continue
            if count > 2:
                raise Undecided("three boundaries may be passed at the start of a phase")
            boundaries = tuple(b for k in chosen for b in every[k][0])
            yield _End(left, hull(part.states), boundaries, part.facts)


def _next(depth: int, index: int) -> tuple[int, int]:
    """The next window, as long as the binary digits of its place allow."""
    index += 1
    while depth and index % 2 == 0:
        index, depth = index // 2, depth - 1
    return depth, index


def _timed(row: Sequence[Any]) -> arb_mat:
    from flint import arb

    return _row([*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])])


def _row(entries: Sequence[arb]) -> arb_mat:
    from flint import arb_mat

    return arb_mat([list(entries)])
