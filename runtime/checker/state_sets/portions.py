"""Portions of many sets, what is known of them where a phase begins, and how they leave it.

Time is divided in windows. A boundary's function is bounded over each window, for all states of
a set: windows in which it may rise through zero follow each other in spans. All states on the
way in a span are cut with the boundary, from inside, and with the other side of none.
"""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, fmpq

from nonsmooth.runtime.checker.state_sets.sets import row_of
from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import Elimination, Numbers, leading, product, reduced
from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import Floats, ManySets, Rounded, joined_sets
from nonsmooth.runtime.core.float_sets import product as float_product

_WINDOWS = 16  # looked at together
_LONGEST = 1536  # windows
_SLACK = 0.5  # of the size of a set: by so much what is on the way in a piece may be larger
_PIECE = 64.0  # windows at most
_AT_ONCE = 8192  # pieces
_CORRECTIONS = 3  # of the times of a piece
_MARGIN = 2.0**-40  # of times


class ExitFunction(NamedTuple):
    """A function that is zero where states leave a phase by some boundaries."""

    names: frozenset[str]
    row: Any  # (1, N + 2), over (y, t, 1)
    order: int  # of the first derivative that is not exactly zero at the start
    facts: Any  # reduced rows that are exactly zero where the function is
    rate: Any  # its rate there


class Exit(NamedTuple):
    """Sets that leave by some functions, as parts of given sets."""

    states: ManySets
    origin: Any  # number of the given set that each is a part of
    by: tuple[int, ...]  # numbers of the functions


class PhaseExits:
    """The ways out of a configuration, along its flow, by the functions that end its phases.

    Pieces of time shorter than `finest`, a share of a window, are not divided further.
    """

    def __init__(self, flow: FloatFlow, functions: Sequence[ExitFunction], finest: float) -> None:
        self.flow, self.functions, self.finest = flow, functions, finest
        self._rows = arb_mat([own.row.entries() for own in functions])
        self._values = [Rounded.of(own.row) for own in functions]
        self._rates = [Rounded.of(own.row * flow.field) for own in functions]
        self._late = [k for k, own in enumerate(functions) if own.order]
        self._bounded: dict[int, Any] = {}

    def common(self, by: Sequence[int]) -> list[Any]:
        """Return reduced rows that are exactly zero where all functions of these numbers are."""
        return Elimination().echelon([row for k in by for row in self.functions[k].facts])

    def _apart(self, *by: int) -> bool:
        """Return whether some functions are never zero together."""
        return not all(any(row[:-1]) for row in self.common(by))

    def leave(self, states: ManySets) -> tuple[list[Exit], Any]:
        """Return all ways out, and of which sets (B,) they are not known.

        In the given states no function is positive, nor its first derivative that is not
        exactly zero.
        """
        spans, lost = self._spans(states)
        found: list[Exit] = []
        for number, (origin, first, last) in enumerate(spans):
            known = ~lost[origin]
            origin, first, last = origin[known], first[known], last[known]
            if len(origin):
                step = self.flow.step
                one = self._through(number, states, origin, first * step, (last + 1) * step)
                found.append(one)
                found.extend(self._with_another(one, number, lost))
        return found, lost

    def _spans(self, states: ManySets) -> tuple[list[Any], Any]:
        """Return each function's spans (sets, first and last windows), and which sets are lost."""
        count = len(self.functions)
        lost, left, begin = np.zeros(len(states), dtype=bool), np.arange(len(states)), 0
        opened: list[Any] = []
        while len(left):
            if begin >= _LONGEST:
                lost[left] = True
                break
            opens, gone = self._bounds(states[left], begin)
            some = gone.any(axis=2)
            opens &= (some.cumsum(axis=1) - some == 0)[:, :, None]
            own, window, function = np.nonzero(opens)
            opened.append(np.stack([function, left[own], window + begin]))
            left = left[~some.any(axis=1)]
            begin += _WINDOWS
        every = np.concatenate([np.zeros((3, 0), dtype=int), *opened], axis=1)
        every = every[:, np.lexsort(every[::-1])]
        spans = []
        for number in range(count):
            origin, window = every[1:, every[0] == number]
            breaks = (np.diff(origin) != 0) | (np.diff(window) != 1)
            ends = np.flatnonzero(np.append(breaks, np.ones(min(len(origin), 1), dtype=bool)))
            starts = np.append(0, ends[:-1] + 1)[: len(ends)]
            spans.append((origin[starts], window[starts], window[ends]))
        return spans, lost

    def _bounds(self, states: ManySets, begin: int) -> tuple[Any, Any]:
        """Return bool arrays (set, window, function): may rise through zero; positive at end."""
        shape = len(states), _WINDOWS, len(self.functions)
        if begin not in self._bounded:
            numbers = range(begin, begin + _WINDOWS)
            self._bounded[begin] = self.flow.windows(self._rows, numbers)
        bounds = [x.reshape(shape) for x in self._bounded[begin].bounds(states)]
        if not begin and self._late:
            # a function that is zero at the start is below as long as its derivative is
            if -1 not in self._bounded:
                rows = [self.functions[k] for k in self._late]
                behind = [(f.row * self.flow.field**f.order).entries() for f in rows]
                self._bounded[-1] = self.flow.windows(arb_mat(behind), range(1))
            for own, new in zip(bounds, self._bounded[-1].bounds(states), strict=True):
                own[:, 0, self._late] = new
        top, slow, fast, least, most = bounds
        below = (top < 0) | (fast <= 0) | ((slow > 0) & (most < 0))
        gone = least > 0
        if not begin:
            gone[:, 0, self._late] = False
        return ~below, gone

    def _through(
        self, number: int, states: ManySets, origin: Any, begin: Floats, end: Floats
    ) -> Exit:
        """Return the states that reach a function's zero between some times."""
        begin, end, some = self._corrected(number, states[origin], begin, end)
        origin, begin, end = origin[some], begin[some], end[some]
        count = np.ceil((end - begin) / self._length(states[origin])).clip(1).astype(int)
        whole = np.repeat(np.arange(len(origin)), count)
        place = np.arange(len(whole)) - np.repeat(np.cumsum(count) - count, count)
        edges = [
            np.where(
                k < count[whole], begin[whole] + k * ((end - begin) / count)[whole], end[whole]
            )
            for k in (place, place + 1)
        ]
        found = [
            self._pieces(number, states, origin[whole[few]], *(x[few] for x in edges))
            for few in np.array_split(np.arange(len(whole)), len(whole) // _AT_ONCE + 1)
        ]
        sets = joined_sets([one.states for one in found])
        return Exit(sets, np.concatenate([one.origin for one in found]), (number,))

    def _pieces(
        self, number: int, states: ManySets, origin: Any, first: Floats, last: Floats
    ) -> Exit:
        """Return the states that reach the zero in one piece of time of each set.

        The time within the piece is a side of each set.
        """
        first, last, some = self._corrected(number, states[origin], first, last)
        origin, first, last = origin[some], first[some], last[some]
        _, found = self.flow.between(states[origin], first, last)
        found, alive = found.cut(self._values[number], zero=True)
        cuts = [self._rates[number]]
        cuts += [negative(row) for k, row in enumerate(self._values) if k != number]
        for row in cuts:
            found, some = found.cut(row)
            alive &= some
        return Exit(found[alive], origin[alive], (number,))

    def _length(self, states: ManySets) -> Floats:
        """Return times (B,) in which the states on the way spread little beyond the states."""
        spread = states.spread
        size = _SLACK * spread.max(axis=1, initial=0.0)
        grows = float_product(spread, np.abs(self.flow.rate.middle).T).max(axis=1, initial=1e-300)
        bends = np.abs(float_product(states.centre, self.flow.curve.middle.T)).max(
            axis=1, initial=1e-300
        )
        longest = np.minimum(size / grows, np.sqrt(2 * size / bends))
        found: Floats = np.clip(longest, self.finest * self.flow.step, _PIECE * self.flow.step)
        return found

    def _corrected(
        self, number: int, states: ManySets, begin: Floats, end: Floats
    ) -> tuple[Floats, Floats, Any]:
        """Return narrower times where a function rises for all states, and if it has a zero."""
        some = np.ones(len(begin), dtype=bool)
        for _ in range(_CORRECTIONS):
            if not len(begin):
                break
            middle = (begin + end) / 2
            moved, way = self.flow.between(states, begin, end)
            low, high = (x[:, 0] for x in moved.ranges(self._values[number]))
            slow, fast = (x[:, 0] for x in way.ranges(self._rates[number]))
            rises = slow > 0
            ways = np.stack([np.where(rises, x, 1.0) for x in (slow, fast)])
            margin = _MARGIN * (1 + end)
            earliest = middle + (-high / ways).min(axis=0) - margin
            latest = middle + (-low / ways).max(axis=0) + margin
            earliest = np.where(rises & (earliest > begin), earliest, begin)
            latest = np.where(rises & (latest < end), latest, end)
            some &= ~(earliest > latest)
            latest = np.maximum(earliest, latest)
            useful = latest - earliest < 0.75 * (end - begin)
            begin, end = earliest, latest
            if not useful.any():
                break
        return begin, end, some

    def _with_another(self, one: Exit, number: int, lost: Any) -> Iterator[Exit]:
        """Yield exits by a second boundary at once; sets that may reach a third are lost."""
        others = [k for k, own in enumerate(self.functions) if own.names]
        if number not in others or not len(one.origin):
            return
        for other in (k for k in others if k > number and not self._apart(number, k)):
            both, alive = one.states.cut(self._values[other], zero=True)
            both, some = both.cut(self._rates[other])
            alive &= some
            both, origin = both[alive], one.origin[alive]
            for third in others:
                if third in (number, other) or self._apart(number, other, third):
                    continue
                lost[origin[both.cut(self._values[third], zero=True)[1]]] = True
            if len(origin):
                yield Exit(both, origin, (number, other))


def rounded(row: Numbers) -> Rounded:
    """Return an exact affine function of the state as a rounded row (1, N + 2) over (y, t, 1)."""
    return Rounded.of(row_of(row))


def negative(row: Rounded) -> Rounded:
    """Return the function with the other sign."""
    return Rounded(-row.middle, row.radius)


_TOGETHER = 1024  # portions
_FAR = 2.0**300  # where doubles may soon end


class KnownStart(NamedTuple):
    """What is known of states where a phase begins."""

    configuration: str
    facts: tuple[Any, ...]  # rows that are exactly zero
    # boundaries that are not positive, nor their first derivative that is not exactly zero
    below: frozenset[str]
    turns: int  # how often the forcing came back


class Portions(NamedTuple):
    """Portions of sets."""

    states: ManySets
    origin: Any  # number of the set of each
    passed: Any  # how many transitions each has passed

    @property
    def astray(self) -> Any:
        """Mask of the portions that have no bounds, or nearly none."""
        low, high = self.states.hull
        return ~((low > -_FAR) & (high < _FAR)).all(axis=1)

    def some(self, which: Any) -> "Portions":
        """Return some of the portions, by mask or indices."""
        return Portions(self.states[which], self.origin[which], self.passed[which])

    def changed(self, states: ManySets, which: Any) -> "Portions":
        """Return portions with other states, which those at `which` have become."""
        return Portions(states, self.origin[which], self.passed[which])

    def where(self, row: Rounded) -> "Portions":
        """Return the parts of the portions on which a function (1, n) is not negative."""
        states, alive = self.states.cut(row)
        return self.changed(states[alive], alive)


class Departure(NamedTuple):
    """Portions that leave a phase by boundaries, or where the forcing comes back."""

    portions: Portions
    names: frozenset[str]  # boundaries; none where the forcing comes back
    facts: Any  # rows that are exactly zero there
    rising: tuple[Any, ...]  # functions that are not negative there
    at_once: bool  # whether the phase begins there or beyond


class DividingPhase:
    """The phase of one configuration, from states of which the same is known.

    `forced` has the rows that are zero where the forcing has the section's phase; it is
    empty without a forcing. `finest` is that of `PhaseExits`.
    """

    def __init__(
        self,
        system: SwitchingSystem,
        flow: FloatFlow,
        known: KnownStart,
        forced: Sequence[Any],
        finest: float,
    ) -> None:
        exactly, field = Elimination(), system.fields[known.configuration]
        self.known, lasting = known, exactly.lasting([*known.facts], field)
        self.outside = False  # all along
        alike: dict[Any, tuple[list[str], Any]] = {}
        for name, row in system.boundaries[known.configuration].items():
            own = reduced(row, lasting)
            if any(own[:-1]):
                alike.setdefault(direction(own), ([], row))[0].append(name)
            else:
                self.outside = self.outside or own[-1] > 0
        self.functions: list[ExitFunction] = []
        self.first, self.below = [], []
        self.changing: list[ExitFunction] = []  # the others leave nothing but where it begins
        for names, row in alike.values():
            order, first = leading(row, field, known.facts, 0)
            if first is None:
                continue
            facts = exactly.echelon([*lasting, row])
            rate = reduced(product(row, field), facts)
            self.functions.append(ExitFunction(frozenset(names), row_of(row), order, facts, rate))
            if any(reduced(product(row, field), lasting)):
                self.changing.append(self.functions[-1])
            self.first.append(first)
            self.below.append(bool(known.below.intersection(names)))
        self.begins = [rounded(first) for first in self.first]
        if forced:
            after = 2 * arb.pi() * (known.turns + 1) / arb(system.speed())
            clock = arb_mat([[*(arb(0) for _ in range(system.size)), arb(1), -after]])
            facts = exactly.echelon([*lasting, *forced])
            self.changing.append(ExitFunction(frozenset(), clock, 0, facts, None))
        self.exits = PhaseExits(flow, self.changing, finest) if self.changing else None

    def departures(self, portions: Portions, remaining: "Remaining") -> Iterator[Departure]:
        """Yield all ways out of the phase; sets of which they are not known are lost."""
        if self.outside:
            remaining.lose(portions.origin)
            return
        yield from self._at_once(portions, remaining)
        for row in self.begins:
            portions = portions.where(negative(row))
        if not len(portions.origin):
            return
        if self.exits is None:
            remaining.lose(portions.origin)
            return
        found, lost = self.exits.leave(portions.states)
        remaining.lose(portions.origin[lost])
        for states, origin, by in found:
            functions = [self.changing[k] for k in by]
            names = frozenset[str]().union(*(own.names for own in functions))
            rising = tuple(own.rate for own in functions if own.names)
            own = portions.changed(states, origin)
            yield Departure(own, names, self.exits.common(by), rising, False)

    def _at_once(self, portions: Portions, remaining: "Remaining") -> Iterator[Departure]:
        """Yield states that are beyond boundaries where the phase begins, or go beyond at once.

        Sets with states beyond three boundaries at once are lost.
        """
        highest = [portions.states.ranges(row)[1][:, 0] for row in self.begins]
        may = [k for k, high in enumerate(highest) if not (high < 0).all()]
        for chosen in (x for n in (1, 2, 3) for x in combinations(may, n)):
            if all(self.below[k] for k in chosen):
                continue
            own = portions
            for k in chosen:
                own = own.where(self.begins[k])
            if len(chosen) == 3:
                remaining.lose(own.origin)
                continue
            for k in may:
                own = own if k in chosen else own.where(negative(self.begins[k]))
            if len(own.origin):
                names = frozenset[str]().union(*(self.functions[k].names for k in chosen))
                rising = tuple(self.first[k] for k in chosen)
                yield Departure(own, names, list(self.known.facts), rising, True)


class Remaining:
    """Portions still to be followed, and the sets that are lost.

    A set may have `most` portions, and all sets together may have `whole`.
    """

    def __init__(self, count: int, most: int, whole: float = np.inf) -> None:
        self.lost, self.portions = np.zeros(count, dtype=bool), 0
        self._most, self._whole, self._counted = most, whole, np.zeros(count, dtype=int)
        self._left: dict[KnownStart, list[Portions]] = {}

    def add(self, known: KnownStart, portions: Portions) -> None:
        """Add portions to be followed."""
        self.count(portions.origin)
        self._left.setdefault(known, []).append(portions)

    def count(self, origin: Any) -> None:
        """Count portions by their sets; sets with too many are lost, all if there are too many."""
        np.add.at(self._counted, origin, 1)
        self.portions += len(origin)
        self.lost |= (self._counted > self._most) | (self.portions > self._whole)

    def lose(self, origin: Any) -> None:
        """Mark sets as lost."""
        self.lost[origin] = True

    def take(self) -> tuple[KnownStart, Portions] | None:
        """Take the most portions of which the same is known; None if there are none left."""
        if not self._left:
            return None
        known = max(self._left, key=lambda own: sum(len(x.origin) for x in self._left[own]))
        portions = joined_portions(self._left.pop(known))
        portions = portions.some(~self.lost[portions.origin])
        if len(portions.origin) > _TOGETHER:
            self._left[known] = [portions.some(slice(_TOGETHER, None))]
        return known, portions.some(slice(_TOGETHER))


def joined_portions(several: list[Portions]) -> Portions:
    """Return the portions of several lists as one."""
    origin = np.concatenate([own.origin for own in several])
    passed = np.concatenate([own.passed for own in several])
    return Portions(joined_sets([own.states for own in several]), origin, passed)


def direction(row: Any) -> tuple[Any, ...]:
    """Return an exact function up to a positive factor.

    Its first entry that is not zero becomes 1 or -1.
    """
    size = next((abs(x) for x in row if x), fmpq(1))
    return tuple(x / size for x in row)


def opposite(row: Any) -> tuple[Any, ...]:
    """Return an exact function with the other sign."""
    return tuple(-x for x in row)
