"""Where sets of states enter a configuration, and where a transition leads them: all one way."""

from functools import cached_property
from typing import Any, NamedTuple

from nonsmooth.runtime.checker.state_sets.sets import (
    CarryingPhase,
    StateSet,
    TooWide,
    matrix_of,
    row_of,
)
from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem, echelon_behind
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Failure,
    demand,
    leading,
    reduced,
)


class Unlisted(Failure):
    """No transition follows of those that are stated."""


class CarryingSystem:
    """A system along whose phases sets are carried."""

    def __init__(self, system: SwitchingSystem) -> None:
        self.system, self.exactly = system, Elimination()
        fields, rows = system.fields, system.boundaries
        self.phases = {name: CarryingPhase(fields[name], rows[name]) for name in fields}


class _FollowingWay(NamedTuple):
    """A transition that may follow."""

    conditions: list[tuple[Any, bool]]  # row over (states, time, 1), None where zero; if positive
    reset: Any  # exact
    matrix: Any  # the reset over (states, time, 1)
    entry: "Entry"  # where it leads
    lawful: bool  # whether a contact law decides it
    decided: bool  # whether the law's earlier steps are, and its reset moves nothing


class Entry:
    """Where sets enter a configuration, and what is exactly true of them there."""

    def __init__(self, owner: CarryingSystem, here: str, facts: Any) -> None:
        self._owner, self.here, self.facts = owner, here, facts
        self._behind: dict[tuple[frozenset[str], bool], tuple[Any, list[list[_FollowingWay]]]] = {}

    @cached_property
    def lasting(self) -> Any:
        """The reduced rows that stay zero along the phase."""
        owner = self._owner
        return owner.exactly.lasting(self.facts, owner.system.fields[self.here])

    @cached_property
    def _begins(self) -> list[tuple[str, int, Any]]:
        """Each boundary that is not zero all along, with the first derivative that is not zero."""
        phase, found = self._owner.phases[self.here], []
        for name, row in phase.rows.items():
            order, begins = leading(row, phase.exact, self.facts, 0)
            if begins is not None:
                found.append((name, order, row_of(begins)))
        return found

    def watched(self, states: StateSet) -> dict[str, int]:
        """Return the boundaries that are not zero all along, with the order of a derivative.

        It is that of the first derivative at the start that is not exactly zero, which has to be
        negative, else `TooWide` is raised.
        """
        if self.passed(states):
            raise TooWide
        return {name: order for name, order, _ in self._begins}

    def passed(self, states: StateSet) -> frozenset[str]:
        """Return the boundaries that the states are beyond, or about to pass.

        `TooWide` is raised if that is not known.
        """
        found, hull = set(), states.hull
        for name, order, begins in self._begins:
            value = (begins * hull)[0, 0]
            if value > 0:
                found.add(name)
            elif not value < 0:
                raise TooWide(
                    f"whether {name} is passed at the start of the phase: its derivative of order"
                    f" {order} is {value.str(3)}"
                )
        return frozenset(found)

    def behind(
        self, reached: frozenset[str], states: StateSet, *, at_once: bool = False
    ) -> tuple[StateSet, "Entry"]:
        """Return the states behind the transition that follows boundaries, and where it leads.

        The boundaries are reached together or, if `at_once`, are those that the phase begins beyond
        or is about to pass. Where stops may act in several orders, all have to agree. `TooWide` is
        raised if it is not known what follows, `Unlisted` if nothing that is stated does.
        """
        if (reached, at_once) not in self._behind:
            self._behind[reached, at_once] = self._transitions(reached, at_once)
        facts, orders = self._behind[reached, at_once]
        taken, *others = (_following(ways, states.hull, reached) for ways in orders)
        for other in others:
            pairs = zip(taken.reset, other.reset, strict=True)
            apart = [tuple(x - y for x, y in zip(*rows, strict=True)) for rows in pairs]
            alike = other.entry.here == taken.entry.here
            alike = alike and not any(any(reduced(row, facts)) for row in apart)
            told = " and ".join(sorted(reached))
            demand(alike, f"the orders in which {told} act need not agree")
        return states.through(taken.matrix), taken.entry

    def _transitions(
        self, reached: frozenset[str], at_once: bool
    ) -> tuple[Any, list[list[_FollowingWay]]]:
        """Return what is true at boundaries, and the ways behind them in each order."""
        owner, phase = self._owner, self._owner.phases[self.here]
        rows = [] if at_once else [phase.rows[name] for name in sorted(reached)]
        facts = owner.exactly.echelon([*self.lasting, *rows]) if rows else self.facts
        orders: list[list[_FollowingWay]] = []
        for listed in owner.system.orders.get((self.here, reached), [[]]):
            ways = []
            for way in listed:
                signs, decided = [], True
                for k, (row, along, holds) in enumerate(way.conditions):
                    field = owner.system.fields[along]
                    order, first = leading(row, field, facts, int(row in rows))
                    signs.append((None if first is None else row_of(first), holds))
                    decided &= k >= (way.early or 0) or (not order and first is not None)
                if way.early is not None:
                    for k, row in enumerate(way.reset):
                        moved = tuple(x - int(j == k) for j, x in enumerate(row))
                        decided &= not any(reduced(moved, facts))
                behind = echelon_behind(owner.exactly, facts, way.reset)
                leads = matrix_of(way.reset, runs=False), Entry(owner, way.target, behind)
                ways.append(_FollowingWay(signs, way.reset, *leads, way.early is not None, decided))
            orders.append(ways)
        return facts, orders


def _following(ways: list[_FollowingWay], hull: Any, reached: frozenset[str]) -> _FollowingWay:
    """Return the first way whose conditions hold for all states of a set."""
    told = " with ".join(sorted(reached))
    for way in ways:
        held = [_holds(row, holds, hull) for row, holds in way.conditions]
        if False in held:
            continue
        if None in held or not way.decided:
            law = f"what the contact law says at {told}"
            raise TooWide(law if way.lawful else f"at {told}, whether {way.entry.here} follows")
        return way
    raise Unlisted(f"no transition is declared for {told}")


def _holds(row: Any, positive: bool, hull: Any) -> bool | None:
    """Return whether a function has the sign that is asked for; None if that is not known."""
    if row is None:
        return not positive
    value = (row * hull)[0, 0]
    return bool(value > 0) == positive if value > 0 or value < 0 else None
