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
    """The first derivative of an affine function along a field that is not known to be zero.

    Attributes
    ----------
    order : int
        Those below it are zero.
    row : Row
        Its value at a state.
    """

    order: int
    row: Row


class Watched(NamedTuple):
    """A boundary of a phase.

    Attributes
    ----------
    name : str
    row : Row
    begins : Derivative or None
        Where the phase begins; None if it stays exactly zero.
    follows : int
        The order of the first derivative there, beyond that one, that is not known to be zero.
    still : bool
        Whether the function does not change along the phase.
    reached : bool
        Whether it ends the phase.
    ends, speed : Row
        Value and rate where the phase ends.
    """

    name: str
    row: Row
    begins: Derivative | None
    follows: int
    still: bool
    reached: bool
    ends: Row
    speed: Row


class Condition(NamedTuple):
    """A condition of a transition: the sign of a derivative behind the end; None is no sign."""

    behind: Derivative | None
    expected: bool


class Follower(NamedTuple):
    """A transition that is declared for what is reached where a phase ends.

    Attributes
    ----------
    target : str
    wanted : bool
        Whether it is the itinerary's, or the same there where stops act in several orders.
    conditions : tuple of Condition
    doubt : str
        What stays open where it follows and is not wanted, or the reverse; empty where that
        refutes the itinerary: by a law of contacts other steps may lead to the same target,
        and what orders of impacts do not agree on is left open.
    """

    target: str
    wanted: bool
    conditions: tuple[Condition, ...]
    doubt: str = ""


class Plan(NamedTuple):
    """A phase, and what may follow it.

    Attributes
    ----------
    place : int
    configuration : str
    starts, ends : Invariants
    held : tuple of Row
        What the configuration holds, as far as it is not known to be zero.
    watched : tuple of Watched
    orders : tuple of tuple of Follower
        For each order in which stops may act that are reached together, what may follow, up to
        the last that is wanted; one where they need no order, none where nothing is reached.
    """

    place: int
    configuration: str
    starts: Invariants
    ends: Invariants
    held: tuple[Row, ...]
    watched: tuple[Watched, ...]
    orders: tuple[tuple[Follower, ...], ...]

    def at(self, number: Callable[[Any], Any]) -> Plan:
        """The same with numbers in place of exact entries, but for exact zeros.

        Parameters
        ----------
        number : callable
            Maps exact entries to numbers: balls or Taylor models.

        Returns
        -------
        Plan
            With rows of numbers.
        """

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
    """What has to be shown, for each phase of a cycle of a system whose numbers are exact.

    Parameters
    ----------
    tables : Tables
        Exact.
    cycle : ItineraryShape
        The itinerary, with its system's structure.
    invariants : CycleInvariants
        What vanishes where the phases begin and end.

    Returns
    -------
    tuple of Plan
        One for each phase.
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
    """What may follow in an order in which stops act, 0 where there is but one."""
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
    """Steps of the law before the last are decided by their own functions, or not at all."""
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
    """Whether a reset leaves the state alone for which the invariants hold."""
    size = len(reset)
    return invariants.agree(reset, [[int(j == k) for j in range(size)] for k in range(size)])


def _first(row: Row, field: Matrix, invariants: Invariants, order: int = 0) -> Derivative | None:
    """The first derivative from an order on that is not known to be zero."""
    functions = map(invariants.reduce, derivatives(row, field, len(row), product))
    found = leading(functions, lambda _, reduced: any(reduced), order)
    return None if found is None else Derivative(found.order, found.derivative)
