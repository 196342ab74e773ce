"""Portions of many sets, what is known of them where a phase begins, and how they leave it."""

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, fmpq

from nonsmooth.runtime.checker.state_sets.exits import ExitFunction, PhaseExits, negative, rounded
from nonsmooth.runtime.checker.state_sets.sets import row_of
from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import Elimination, leading, product, reduced
from nonsmooth.runtime.core.exponentials.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import ManySets, Rounded, joined_sets

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
