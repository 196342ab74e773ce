"""Where many sets of states leave one configuration, for the check of sets that divide.

Time is divided in windows. A boundary's function is bounded over each window, for all states of
a set: windows in which it may rise through zero follow each other in spans. All states on the
way in a span are cut with the boundary, from inside, and with the other side of none.
"""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from flint import arb_mat

from nonsmooth.runtime.checker.state_sets.sets import row_of
from nonsmooth.runtime.checker.stated.exact import Elimination
from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import Floats, ManySets, Rounded, joined_sets, product

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
        grows = product(spread, np.abs(self.flow.rate.middle).T).max(axis=1, initial=1e-300)
        bends = np.abs(product(states.centre, self.flow.curve.middle.T)).max(axis=1, initial=1e-300)
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


def rounded(row: Sequence[Any]) -> Rounded:
    """Return an exact affine function of the state as a rounded row (1, N + 2) over (y, t, 1)."""
    return Rounded.of(row_of(row))


def negative(row: Rounded) -> Rounded:
    """Return the function with the other sign."""
    return Rounded(-row.middle, row.radius)
