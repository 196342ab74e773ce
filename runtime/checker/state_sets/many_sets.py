"""Many sets of states through the phases of a system, whatever ways their states go.

A set goes every way that one of its states may go: what comes to a boundary is cut from it, and
so is what meets a condition. What is cut may be a little more than that, so all arrivals are in
the boxes that are found, and the boxes may be wider. Where it is not stated what follows the set
is lost.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.state_sets.portions import (
    Departure,
    DividingPhase,
    KnownStart,
    Portions,
    Remaining,
    direction,
    joined_portions,
    negative,
    opposite,
    rounded,
)
from nonsmooth.runtime.checker.state_sets.sets import matrix_of
from nonsmooth.runtime.checker.state_sets.switching import (
    StatedSection,
    SwitchingSystem,
)
from nonsmooth.runtime.checker.stated.declared import Transition
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    demand,
    free_places,
    leading,
    product,
    reduced,
    spanned,
    unit_rows,
)
from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import LONGEST, Floats, ManySets, Rounded, within

_ABOUT_ZERO = 2.0**-30  # a time
_HALVINGS = 16  # of a set that is lost or comes elsewhere too, as a whole
_SHARE = 4  # of the portions of a set those that sets have on average, at most
_HALVES = 1024  # of several sets, besides two of each
_RADIANS = 0.125  # of the fastest motion in a window


# numbers (L,) of sets and boxes (L, d): whether parts of these sets may come to these boxes
Known = Callable[[Any, Floats, Floats], Any]


def in_batches(numbers: Any, size: int) -> Iterator[Any]:
    """Yield parts of an array, each of at most so many entries, in order."""
    for begin in range(0, len(numbers), size):
        yield numbers[begin : begin + size]


class Arrivals(NamedTuple):
    """Boxes that contain the first arrivals of sets at a section."""

    origin: Any  # (L,) number of the set of each box
    low: Floats  # (L, d) lower ends, in the section's coordinates
    high: Floats  # (L, d)
    lost: Any  # whether nothing is known of each set
    portions: int = 0  # how many were followed


class ManyMotions:
    """The first arrivals of sets of states at a section, of a declaration in a file.

    Sets wider than `widest`, in units of `scales` (N), are halved where a phase begins. A
    set may have at most `most` portions and pass at most `longest` transitions; sets on
    their way are divided down to the share `finest` of a window of time. Flows have `bits`
    before they are rounded to doubles. `facts` are the reduced rows that are zero on the
    section, `free` the states that are its coordinates.
    `Failure` is raised if there is no such section or the declaration is of another kind.
    """

    def __init__(
        self,
        declared: Entries,
        parameters: Mapping[str, str],
        section: StatedSection,
        scales: Sequence[float],
        widest: float = np.inf,
        most: int = 400,
        longest: int = 40,
        finest: float = 1.0,
        bits: int = 80,
    ) -> None:
        self.system, self.section = SwitchingSystem(declared, parameters), section
        few = self.system.size + 2 <= LONGEST
        demand(few, f"sets are carried with up to {LONGEST - 2} states")
        self.scales, self.widest = np.array(scales, dtype=float), widest
        self.most, self.longest, self.finest, self.bits = most, longest, finest, bits
        self.exactly = Elimination()
        self.facts, self.forced = section.facts(self.system, self.exactly)
        self.free = free_places(self.facts, self.system.size)
        self._flows: dict[str, FloatFlow] = {}
        self._phases: dict[KnownStart, DividingPhase] = {}

    def arrivals(self, starts: ManySets) -> Arrivals:
        """Return the first arrivals of sets on the section, given as sets of (coordinates, 1)."""
        return self.leaves(*self.on_section(starts))

    def on_section(self, starts: ManySets) -> tuple[ManySets, str, Sequence[Any]]:
        """Return what `leaves` takes, for sets of (coordinates, 1) of the section."""
        with ctx.workprec(self.bits):
            lifted = starts.mapped(self.lift(self.facts, timed=False))
        return lifted, self.section.configuration, self.facts

    @np.errstate(all="ignore")  # sets without bounds are lost
    def leaves(
        self,
        starts: ManySets,
        configuration: str,
        facts: Sequence[Any],
        known: Known | None = None,
        whole: float = np.inf,
    ) -> Arrivals:
        """Return boxes that contain the first arrival of every state of every set.

        The sets are of (y, 0, 1) in one configuration; only their states beyond no boundary
        count. `facts` are rows that are exactly zero for them; with a forcing these imply the
        section's phase. A set that may come to a box that is not `known` is lost, and not
        followed further. All sets are lost if they have more than `whole` portions together.
        `Failure` is raised if the configuration is not declared or the forcing has another
        phase.
        """
        demand(configuration in self.system.fields, "a configuration is not declared")
        times = np.abs(np.array(starts.hull)[:, :, self.system.size])
        demand((times < _ABOUT_ZERO).all(), "a start at another time")
        true = tuple(self.exactly.echelon(facts))
        here = all(not any(reduced(row, true)) for row in self.forced)
        demand(here, "the forcing has another phase")
        rows = self.system.boundaries[configuration]
        inside = frozenset(name for name, row in rows.items() if any(reduced(row, true)))
        remaining = Remaining(len(starts), self.most, whole)
        each = np.arange(len(starts))
        remaining.add(
            KnownStart(configuration, true, inside, 0), Portions(starts, each, np.zeros_like(each))
        )
        found = [(each[:0], *np.zeros((2, 0, len(self.free))))]
        with ctx.workprec(self.bits):
            while (taken := remaining.take()) is not None:
                for own in self._followed(*taken, remaining):
                    low, high = (ends[:, self.free] for ends in own.states.hull)
                    if known is not None:
                        remaining.lose(own.origin[~known(own.origin, low, high)])
                    found.append((own.origin, low, high))
        origin, low, high = (np.concatenate(x) for x in zip(*found, strict=True))
        kept = ~remaining.lost[origin]
        return Arrivals(origin[kept], low[kept], high[kept], remaining.lost, remaining.portions)

    def lead(
        self,
        starts: ManySets,
        configuration: str,
        facts: Sequence[Any],
        known: Known,
    ) -> bool:
        """Return whether all states of all sets come to known places, in parts if need be.

        `known` takes numbers (L,) of sets and boxes (L, d), and says whether parts of these
        sets may come to these boxes. The other arguments are those of `leaves`. On average
        over the sets at most a quarter of the portions that one set may have is followed,
        halves included: so the work is bounded by the number of sets, whatever the answer is.
        """
        origin, most = np.arange(len(starts)), 2 * len(starts) + _HALVES
        left = self.most * (len(starts) / _SHARE + 1)
        for _ in range(_HALVINGS + 1):

            def own(numbers: Any, low: Floats, high: Floats, origin: Any = origin) -> Any:
                return known(origin[numbers], low, high)

            found = self.leaves(starts, configuration, facts, own, left)
            left -= found.portions
            bad = found.lost
            if not bad.any():
                return True
            starts, origin = starts[bad], np.tile(origin[bad], 2)
            if 2 * len(starts) > min(most, left):
                return False
            starts = starts.halves(np.argmax(np.abs(starts.sides).max(axis=1), axis=1))
        return False

    def _followed(
        self, known: KnownStart, portions: Portions, remaining: Remaining
    ) -> Iterator[Portions]:
        """Yield the portions that one phase leads to the section; add others to the remaining."""
        remaining.lose(portions.origin[(portions.passed >= self.longest) | portions.astray])
        portions = self._narrow(portions.some(~remaining.lost[portions.origin]), remaining)
        if not len(portions.origin):
            return
        if known not in self._phases:
            flow = self.flow(known.configuration)
            self._phases[known] = DividingPhase(self.system, flow, known, self.forced, self.finest)
        for end in self._phases[known].departures(portions, remaining):
            for behind, own, on_section in self._behind(known, end, remaining):
                if not on_section or end.at_once:
                    remaining.add(behind, own)
                elif all(not any(reduced(row, behind.facts)) for row in self.facts):
                    yield self._inside(behind, own, remaining)
                else:
                    remaining.lose(own.origin)

    def _inside(self, known: KnownStart, own: Portions, remaining: Remaining) -> Portions:
        """Return those arrivals that are beyond no boundary; the others go on at once."""
        for name, row in self.system.boundaries[known.configuration].items():
            if name in known.below or not any(reduced(row, known.facts)):
                continue
            if any(reduced(row, self.facts)):
                function = rounded(row)
                remaining.add(known, own.where(function))
                own = own.where(negative(function))
        return own

    def _narrow(self, portions: Portions, remaining: Remaining) -> Portions:
        while True:
            spans = np.abs(portions.states.sides[:, : self.system.size]) / self.scales[:, None]
            wide = spans.sum(axis=2).max(axis=1, initial=0.0) > self.widest
            if not wide.any():
                return portions
            longest = spans[wide].max(axis=1).argmax(axis=1)
            halves = portions.changed(
                portions.states[wide].halves(longest), np.tile(wide.nonzero()[0], 2)
            )
            remaining.count(halves.origin[: len(longest)])
            portions = joined_portions([portions.some(~wide), halves])
            portions = portions.some(~remaining.lost[portions.origin])

    def _behind(
        self, known: KnownStart, end: Departure, remaining: Remaining
    ) -> Iterator[tuple[KnownStart, Portions, bool]]:
        """Yield what is known behind an end of a phase, its portions, and if they have arrived.

        Those have arrived that are on the section.
        """
        here, size = known.configuration, self.system.size
        astray = end.portions.astray
        remaining.lose(end.portions.origin[astray])
        end = end._replace(portions=end.portions.some(~astray))
        rows = self.system.boundaries[here].items()
        inside = [row for name, row in rows if name not in end.names]
        inside += map(opposite, end.rising)
        signs = frozenset(direction(reduced(row, end.facts)) for row in inside)
        if not end.names:
            ways = iter([(unit_rows(size + 1), here, end.portions, end.facts, signs)])
        else:
            orders = self.system.orders.get((here, end.names), [[]])
            ways = chain.from_iterable(self._chosen(x, end, signs, remaining) for x in orders)
        section = self.section
        for reset, target, portions, before, now in ways:
            if target not in self.system.fields:
                remaining.lose(portions.origin)
                continue
            facts = self.exactly.behind(before, reset)
            if not all(any(row[:-1]) for row in facts):
                continue  # there are no such states
            matrix = Rounded.of(matrix_of(reset, runs=False))
            box = self._box(portions.states, now).mapped(matrix).hull
            states = portions.states.mapped(matrix).fewer_sides(
                self._places(facts), self.lift(facts, bool(self.forced)), box
            )
            below = frozenset(
                name
                for name, row in self.system.boundaries[target].items()
                if self._stays_below(row, target, facts, reset, before, now)
            )
            turns = known.turns + (not end.names)
            if self.forced:
                arrived = not end.names and target == section.configuration
            else:
                way = here, end.names, target
                arrived = way == (section.source, section.boundaries, section.configuration)
            own = Portions(states, portions.origin, portions.passed + 1)
            yield KnownStart(target, tuple(facts), below, turns), own, arrived

    def _chosen(
        self, listed: list[Transition], end: Departure, signs: frozenset[Any], remaining: Remaining
    ) -> Iterator[tuple[Any, str, Portions, Any, frozenset[Any]]]:
        """Yield resets and targets of the first transitions whose conditions hold.

        With each come its portions, the rows that are exactly zero for them, and functions
        that are not positive. A function that is never on one side of zero is zero for those
        portions that are there.
        """
        left = [(0, 0, end.portions, list(end.facts), signs)]
        while left:
            number, place, portions, facts, now = left.pop()
            if not len(portions.origin):
                continue
            if number == len(listed):
                remaining.lose(portions.origin)
                continue
            way = listed[number]
            if place == len(way.conditions):
                yield way.reset, way.target, portions, facts, now
                continue
            row, along, holds = way.conditions[place]
            _, first = leading(row, self.system.fields[along], facts, 0)
            after = {True: (number, place + 1), False: (number + 1, 0)}
            if first is None:  # it is zero, and not positive
                left.append((*after[not holds], portions, facts, now))
                continue
            for positive, side in ((True, first), (False, opposite(first))):
                own = portions.where(rounded(side))
                if direction(side) not in now:
                    then = now | {direction(opposite(side))}
                    left.append((*after[positive == holds], own, facts, then))
                    continue
                zero = self.exactly.echelon([*facts, first])
                if all(any(own[:-1]) for own in zero):
                    own = own.where(negative(rounded(side)))
                    still = frozenset(direction(reduced(other, zero)) for other in now)
                    left.append((number, place, own, zero, still))

    def _box(self, states: ManySets, signs: frozenset[Any]) -> ManySets:
        """Return boxes around the states of sets for which these functions are not positive."""
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
        """Return whether a boundary's first derivative behind a reset is known not to be positive.

        As a function of the states before the reset, it has to be one whose sign is known.
        """
        _, first = leading(row, self.system.fields[target], facts, 0)
        if first is None:
            return False
        pulled = reduced(product(first, reset), before)
        return bool(pulled[-1] <= 0) if not any(pulled[:-1]) else direction(pulled) in signs

    # what exact facts leave free

    def _places(self, facts: Any) -> list[int]:
        free = free_places(facts, self.system.size)
        return [*free, self.system.size] if self.forced else free

    def lift(self, facts: Any, timed: bool) -> Rounded:
        """Return the map (N + 2, d + 1) to (y, t, 1) from free coordinates and 1.

        Free coordinates are those that the facts, reduced rows, do not determine. If `timed`,
        time is the last of these coordinates; else it is 0.
        """
        rows = [[*row[:-1], *[0] * timed, row[-1]] for row in spanned(facts, self.system.size)]
        *still, last = unit_rows(len(rows[0]))
        rows += [still[-1] if timed else [0] * len(last), last]
        return Rounded.of(arb_mat([[*map(arb, row)] for row in rows]))

    def flow(self, configuration: str) -> FloatFlow:
        """Return the flow of a configuration."""
        if configuration not in self._flows:
            matrix = matrix_of(self.system.fields[configuration], runs=True)
            rates = [float(abs(x)) for x in arb_mat(matrix.mid()).eig(algorithm="approx")]
            _, exponent = math.frexp(_RADIANS / max(*rates, 2.0**-6))
            self._flows[configuration] = FloatFlow(matrix, 2.0 ** (exponent - 1))
        return self._flows[configuration]
