"""What has to be shown of a cycle for it to be a motion, phase by phase.

Exact arithmetic tells which functions are zero; the signs of the others are left to balls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.model.contacts.stages import signs
from nonsmooth.runtime.model.structure import Structure, TransitionShape
from nonsmooth.runtime.proof.exact_tables import Matrix, Tables
from nonsmooth.runtime.proof.invariants import CycleInvariants
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["Condition", "Derivative", "Follower", "Plan", "Watched", "plan_of"]


class Derivative(NamedTuple):
    """The first derivative of an affine function along a field that is not known to be zero."""

    order: int  # all derivatives of lower order are zero
    row: Row  # affine function of the state that gives its value


class Watched(NamedTuple):
    """A boundary of a phase's configuration, as the judgement of the phase needs it."""

    name: str
    row: Row
    begins: Derivative | None  # at the phase's start; None if the function stays exactly zero
    # order of the next derivative there, beyond `begins`, that is not known to be zero
    follows: int
    still: bool  # whether the function is constant along the phase
    reached: bool  # whether the boundary ends the phase
    ends: Row  # value at the phase's end
    speed: Row  # rate at the phase's end


class Condition(NamedTuple):
    """A condition of a transition: the sign of a derivative just behind the phase's end."""

    behind: Derivative | None  # None if the function stays zero: then it has no sign
    expected: bool  # whether it has to be positive


class Follower(NamedTuple):
    """A transition that is declared for the boundaries that are reached where a phase ends.

    `wanted` says that it is the itinerary's transition, or, where stops act in several orders, one
    that does the same there. `doubt` says what stays open where an unwanted one follows or a
    wanted one does not: by a law of contacts other steps may lead to the same target, and the
    orders of impacts need not agree. If it is empty, that refutes the itinerary.
    """

    target: str
    wanted: bool
    conditions: tuple[Condition, ...]
    doubt: str = ""


class Plan(NamedTuple):
    """What has to be proved of one phase of a cycle, and the transitions that may follow it."""

    place: int
    configuration: str
    starts: Invariants
    ends: Invariants
    held: tuple[Row, ...]  # what the configuration holds, as far as it is not known to be zero
    watched: tuple[Watched, ...]
    # for each order in which stops that are reached together may act, the transitions that may
    # follow, up to the last wanted one; a single order where none is needed, none where nothing is
    # reached
    orders: tuple[tuple[Follower, ...], ...]

    def at(self, number: Callable[[Any], Any]) -> Plan:
        """Return the plan with `number` applied to its exact entries; exact zeros stay 0."""

        def numbers(row: Row) -> Any:
            return tuple(number(x) if x else 0 for x in row)

        def derivative(found: Derivative | None) -> Derivative | None:
            return found and Derivative(found.order, numbers(found.row))

        def invariants(found: Invariants) -> Invariants:
            return Invariants(tuple(map(numbers, found.rows)), found.pivots)

        return self._replace(
            starts=invariants(self.starts),
            ends=invariants(self.ends),
            held=tuple(map(numbers, self.held)),
            watched=tuple(
                w._replace(
                    row=numbers(w.row),
                    begins=derivative(w.begins),
                    ends=numbers(w.ends),
                    speed=numbers(w.speed),
                )
                for w in self.watched
            ),
            orders=tuple(
                tuple(
                    f._replace(
                        conditions=tuple(
                            Condition(derivative(c), holds) for c, holds in f.conditions
                        )
                    )
                    for f in followers
                )
                for followers in self.orders
            ),
        )


_ZERO: Any = (0,)
_OPEN = Derivative(0, _ZERO)  # of no sign that could be told


def plan_of(tables: Tables, cycle: ItineraryShape, invariants: CycleInvariants) -> tuple[Plan, ...]:
    """Return for each phase of a cycle what has to be proved of it, from exact tables.

    `invariants` are the functions that vanish where the phases begin and end.
    """
    return tuple(_plan(tables, cycle, invariants, place) for place in range(len(cycle)))


def _plan(tables: Tables, cycle: ItineraryShape, invariants: CycleInvariants, place: int) -> Plan:
    structure = cycle.structure
    configuration = cycle.configurations[place]
    wanted = cycle.transitions[place]
    field = tables.fields[configuration]
    starts, lasting, ends = (part[place] for part in invariants)
    boundaries = structure.boundaries[configuration]
    watched = []
    for index, boundary in enumerate(boundaries):
        row = tables.rows[boundary.row]
        rate = product(row, field)
        begins = _first(row, field, starts)
        after = 1 if begins is None else begins.order + 1
        behind = _first(row, field, starts, after)
        watched.append(
            Watched(
                boundary.name,
                row,
                begins,
                after if behind is None else behind.order,
                not any(lasting.reduce(rate)),
                index in wanted.boundaries,
                ends.reduce(row),
                ends.reduce(rate),
            )
        )
    held = (starts.reduce(tables.rows[row]) for row in structure.constraints[configuration])
    return Plan(
        place,
        structure.configurations[configuration],
        starts,
        ends,
        tuple(row for row in held if any(row)),
        tuple(watched),
        tuple(
            _followers(tables, cycle, place, order, ends)
            for order in structure.orders(configuration, wanted.boundaries)
            if wanted.boundaries  # a motion that reaches nothing goes on
        ),
    )


def _followers(
    tables: Tables, cycle: ItineraryShape, place: int, order: int, ends: Invariants
) -> tuple[Follower, ...]:
    """Return the transitions that may follow for one order of acting; 0 is the only order."""
    structure, wanted = cycle.structure, cycle.transitions[place]
    configuration = cycle.configurations[place]
    boundaries = structure.boundaries[configuration]
    own = {boundaries[index].row for index in wanted.boundaries}
    names = [boundaries[index].name for index in sorted(wanted.boundaries)]
    doubt = f"the orders in which {' and '.join(names)} act need not agree" if order else ""
    found = []
    for transition in structure.listed(configuration, wanted.boundaries):
        if transition.order not in (0, order):
            continue
        conditions = tuple(
            Condition(_first(tables.rows[row], tables.fields[along], ends, int(row in own)), holds)
            for row, along, holds in transition.conditions
        )
        target = structure.configurations[transition.target]
        open_ = doubt
        if transition.path is not None:
            open_ = doubt or f"by which steps of the contact law {target} follows"
            conditions = _decided(structure, configuration, names, transition, conditions)
            if not _puts_nothing(tables.resets[transition.reset], ends):
                conditions += (Condition(_OPEN, True),)
        alike = transition.target == wanted.target and ends.agree(
            tables.resets[transition.reset], tables.resets[wanted.reset]
        )
        found.append(Follower(target, alike if order else transition is wanted, conditions, open_))
        if transition is wanted and not order:
            break
    last = max((k for k, f in enumerate(found, 1) if f.wanted), default=len(found))
    return tuple(found[:last])


def _decided(
    structure: Structure,
    source: int,
    boundaries: Sequence[str],
    transition: TransitionShape,
    conditions: tuple[Condition, ...],
) -> tuple[Condition, ...]:
    """Return a law transition's conditions, left open where only a derivative could decide them.

    That concerns the stages of the contact law before the last: they are decided by the values of
    their functions at the phase's end, not by the derivatives.
    """
    law, path = structure.law, transition.path
    assert law is not None
    assert path is not None
    event = law.event(source, boundaries)
    assert event is not None
    early = sum(len(signs(law, event, stage)) for stage in path[:-1])
    return tuple(
        Condition(_OPEN, expected)
        if k < early and (behind is None or behind.order)
        else Condition(behind, expected)
        for k, (behind, expected) in enumerate(conditions)
    )


def _puts_nothing(reset: Matrix, invariants: Invariants) -> bool:
    """Whether a reset is the identity on all states for which the invariants hold."""
    size = len(reset)
    return invariants.agree(reset, [[int(j == k) for j in range(size)] for k in range(size)])


def _first(row: Row, field: Matrix, invariants: Invariants, order: int = 0) -> Derivative | None:
    """Return the first derivative, from order `order` on, that is not known to be zero."""
    functions = map(invariants.reduce, derivatives(row, field, len(row), product))
    found = leading(functions, lambda _, reduced: any(reduced), order)
    return None if found is None else Derivative(found.order, found.derivative)
