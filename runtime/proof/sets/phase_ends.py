"""Where sets of one configuration leave it: many at once, each at every boundary that it may reach.

Along a phase the functions of the boundaries are enclosed over windows of time. From the first
window in which some state may reach one, up to one behind which all have, the set's flow pipe is
cut with each boundary that is reached (flow pipes: A. Girard, Reachability of uncertain linear
systems using zonotopes, HSCC 2005).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.float_flows import FloatFlow, Windows
from nonsmooth.runtime.core.float_sets import Floats, ManySets, Rounded
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row

if TYPE_CHECKING:
    from flint import arb_mat

__all__ = ["CLOCK", "EndedSets", "PhaseEnds", "WatchedFunction"]

CLOCK = -1  # stands for the boundary at which the forcing has the section's phase
_CHUNK = 16  # windows at once
_LONGEST = 1500  # windows of one phase
_LOOSE = 0.5  # part of a set's size by which a pipe may be larger, if it can be shorter
_PIPE = 64.0  # windows of a pipe, at most
_REFINED = 3  # steps of Newton's method for the times of a pipe


@dataclass(frozen=True)
class WatchedFunction:
    """A function of (y, t, 1) whose zero ends a phase."""

    boundaries: tuple[int, ...]  # those that have this function
    row: arb_mat  # (1, N + 2)
    leading: arb_mat  # (1, N + 2): its first derivative that is not exactly zero at the start
    order: int  # of that derivative
    facts: Invariants  # what is exactly true where the function is zero
    rate: Row  # its derivative there, exact


class EndedSets(NamedTuple):
    """Parts of sets that reach some boundaries at the end of a phase, and what is true there."""

    states: ManySets
    origin: NDArray[np.int_]  # number of the given set that each is a part of
    boundaries: tuple[int, ...]
    facts: Invariants
    rising: tuple[Row, ...]  # functions that are not negative there


class PhaseEnds:
    """The ends of a phase in one configuration, for states of which the same is exactly known.

    `finest` is the part of a window of time that flow pipes are not divided beyond.
    """

    def __init__(
        self, flow: FloatFlow, functions: Sequence[WatchedFunction], finest: float
    ) -> None:
        from flint import arb, arb_mat

        self.flow, self.functions, self.finest = flow, tuple(functions), finest
        self._rows = arb_mat([f.row.entries() for f in functions] or [[arb(0)] * flow.size])
        self._single = [(Rounded.of(f.row), Rounded.of(f.row * flow.field)) for f in self.functions]
        self._windows: dict[int, Windows] = {}

    def _over(self, chunk: int) -> Windows:
        if chunk not in self._windows:
            numbers = range(chunk * _CHUNK, (chunk + 1) * _CHUNK)
            self._windows[chunk] = self.flow.windows(self._rows, numbers)
        return self._windows[chunk]

    def ends(self, states: ManySets) -> tuple[list[EndedSets], NDArray[np.bool_]]:
        """Return all ways in which the phase may end, and a mask (B,) of sets that are not decided.

        At the start, for each function and all states, the first derivative that is not exactly
        zero has to be at most zero.
        """
        count, wanted = len(states), len(self.functions)
        lost = np.zeros(count, dtype=bool)
        if not wanted:
            return [], ~lost
        first = np.full((count, wanted), -1)
        last = np.full((count, wanted), -1)
        left = np.arange(count)
        chunk = 0
        while len(left):
            if chunk * _CHUNK >= _LONGEST:
                lost[left] = True
                break
            may, passed = self._reached(states[left], chunk)
            over: NDArray[np.bool_] = np.any(passed, axis=2)  # (b, k)
            seen: NDArray[np.bool_] = (
                np.cumsum(over, axis=1) - over == 0
            )  # up to the first window that ends it
            may &= seen[:, :, None]
            numbers = chunk * _CHUNK + np.arange(_CHUNK)
            some: NDArray[np.bool_] = np.any(may, axis=1)
            begins = numbers[np.argmax(may, axis=1)]
            ends = numbers[_CHUNK - 1 - np.argmax(may[:, ::-1], axis=1)]
            own = first[left]
            first[left] = np.where(some & (own < 0), begins, own)
            last[left] = np.where(some, ends, last[left])
            left = left[~np.any(over, axis=1)]
            chunk += 1
        found = [
            end for place in range(wanted) for end in self._pipes(states, place, first, last, lost)
        ]
        return found, lost

    def _reached(self, states: ManySets, chunk: int) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return for sets, windows and functions (B, k, j) what may be reached, and what is passed.

        A zero may be reached if the bounds over the window do not exclude that for all states of
        the set; it is passed if all states are beyond it.
        """
        shape = len(states), _CHUNK, len(self.functions)
        bounds = [x.reshape(shape) for x in self._over(chunk).bounds(states)]
        if not chunk:
            self._at_start(states, bounds)
        top, slow, fast, least, most = bounds
        order = np.array([f.order for f in self.functions])
        starts = np.zeros(shape, dtype=bool)
        if not chunk:
            starts[:, 0, :] = order > 0
        # what is zero where a window begins belongs to the one before
        inside = (top < 0) | (fast <= 0) | ((slow > 0) & (most < 0) & ~starts)
        return ~inside, (least > 0) & ~starts

    def _at_start(self, states: ManySets, bounds: Sequence[Floats]) -> None:
        """Replace in the first window the bounds of functions that are zero where it begins.

        They become the bounds of these functions' derivatives.
        """
        from flint import arb_mat

        late = [k for k, f in enumerate(self.functions) if f.order]
        if not late:
            return
        rows = []
        for k in late:
            row = self.functions[k].row
            for _ in range(self.functions[k].order):
                row = row * self.flow.field
            rows.append(row.entries())
        found = self.flow.windows(arb_mat(rows), range(1)).bounds(states)
        for own, new in zip(bounds, found, strict=True):
            own[:, 0, late] = new

    def _pipes(
        self,
        states: ManySets,
        place: int,
        first: NDArray[np.int_],
        last: NDArray[np.int_],
        lost: NDArray[np.bool_],
    ) -> Iterator[EndedSets]:
        """Yield where states reach one boundary, alone or together with another one."""
        tiles = np.flatnonzero(~lost & (first[:, place] >= 0))
        if not len(tiles):
            return
        step = self.flow.step
        begin, end = first[tiles, place] * step, (last[tiles, place] + 1) * step
        begin, end, some = self._shorter(states[tiles], place, begin, end)
        tiles, begin, end = tiles[some], begin[some], end[some]
        if not len(tiles):
            return
        length = self._pipe_length(states[tiles])
        pieces = np.ceil((end - begin) / length).astype(int).clip(1)
        origin = np.repeat(tiles, pieces)
        number = np.arange(len(origin)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        each = np.repeat((end - begin) / pieces, pieces)
        starts = np.repeat(begin, pieces) + number * each
        stops = np.where(
            number + 1 < np.repeat(pieces, pieces), starts + each, np.repeat(end, pieces)
        )
        stops = np.nextafter(stops, np.inf)
        starts, stops, some = self._shorter(states[origin], place, starts, stops)
        origin, starts, stops = origin[some], starts[some], stops[some]
        if not len(origin):
            return
        found, alive = self._cut(states[origin], place, starts, stops)
        found, origin = found[alive], origin[alive]
        if not len(found):
            return
        function = self.functions[place]
        yield EndedSets(found, origin, function.boundaries, function.facts, (function.rate,))
        for other in range(place + 1, len(self.functions)):
            yield from self._together(found, origin, place, other, lost)

    def _together(
        self,
        found: ManySets,
        origin: NDArray[np.int_],
        place: int,
        other: int,
        lost: NDArray[np.bool_],
    ) -> Iterator[EndedSets]:
        """Yield the states that reach two boundaries together.

        Sets whose states may reach three together are lost.
        """
        one, two = self.functions[place], self.functions[other]
        if CLOCK in (*one.boundaries, *two.boundaries):
            return
        both, alive = found.cut(self._single[other][0], zero=True)
        facts = Invariants.of([*one.facts.rows, *two.facts.rows])
        if not alive.any() or not facts.consistent:
            return
        both, origin = both[alive], origin[alive]
        for third in range(other + 1, len(self.functions)):
            if CLOCK in self.functions[third].boundaries:
                continue
            more = Invariants.of([*facts.rows, *self.functions[third].facts.rows])
            if more.consistent:
                lost[origin[both.cut(self._single[third][0], zero=True)[1]]] = True
        boundaries = *one.boundaries, *two.boundaries
        yield EndedSets(both, origin, boundaries, facts, (one.rate, two.rate))

    def _pipe_length(self, states: ManySets) -> Floats:
        """Return the times in which flow pipes become little wider than the sets are."""
        spread = states.spread
        field, curve = np.abs(self.flow.rate.middle), self.flow.curve.middle
        size = spread.max(axis=1)
        grows = (spread @ field.T).max(axis=1)
        bends = np.abs(states.centre @ curve.T).max(axis=1) + 1e-300
        half = (np.sqrt(grows**2 + 4 * _LOOSE * bends * size) - grows) / bends
        found: Floats = np.clip(2 * half, self.finest * self.flow.step, _PIPE * self.flow.step)
        return found

    def _shorter(
        self, states: ManySets, place: int, begin: Floats, end: Floats
    ) -> tuple[Floats, Floats, NDArray[np.bool_]]:
        """Return times between which a boundary is reached, and a mask that is False if it is not.

        They are shortened by Newton's method.
        """
        row, rate = self._single[place]
        alive = np.ones(len(states), dtype=bool)
        for _ in range(_REFINED):
            moved, whole = self.flow.between(states, begin, end)
            slow, fast = (x[:, 0] for x in whole.ranges(rate))
            low, high = (x[:, 0] for x in moved.ranges(row))
            middle, spare = (begin + end) / 2, 2.0**-40 * (1 + end)
            rises = slow > 0
            safe, quick = np.where(rises, slow, 1.0), np.where(rises, fast, 1.0)
            early = np.minimum(-high / safe, -high / quick)
            late = np.maximum(-low / safe, -low / quick)
            after = np.where(rises, np.maximum(begin, middle + early - spare), begin)
            before = np.where(rises, np.minimum(end, middle + late + spare), end)
            alive &= ~(after > before)
            before = np.maximum(after, before)
            shorter = (before - after) < 0.8 * (end - begin)
            begin, end = after, before
            if not shorter.any():
                break
        return begin, end, alive

    def _cut(
        self, states: ManySets, place: int, begin: Floats, end: Floats
    ) -> tuple[ManySets, NDArray[np.bool_]]:
        """Return the states of pipes on a boundary that reach it from inside and pass no other."""
        row, rate = self._single[place]
        _, whole = self.flow.between(states, begin, end)
        found, alive = whole.cut(row, zero=True)
        found, some = found.cut(rate)
        alive &= some
        for other, (function, _) in enumerate(self._single):
            if other != place:
                found, some = found.cut(Rounded(-function.middle, function.radius))
                alive &= some
        return found, alive
