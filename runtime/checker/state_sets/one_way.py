"""Sets of states that all go one way: where they enter, what follows, and where they lie.

A power of a section's map is stated by its transitions, and shown of each set: on the way each
phase ends by the boundary that is stated, the same for all states of a set and transversally, and
no other boundary is reached before. So the map is analytic on the set.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

from flint import arb, arb_mat, fmpq, fmpq_mat

from nonsmooth.runtime.checker.state_sets.sets import (
    CarryingPhase,
    StateSet,
    TooWide,
    matrix_of,
    row_of,
)
from nonsmooth.runtime.checker.state_sets.switching import (
    StatedSection,
    SwitchingSystem,
)
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    Failure,
    agree,
    demand,
    exact,
    free_places,
    leading,
    products,
    reduced,
    spanned,
    unit_rows,
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
            alike = other.entry.here == taken.entry.here
            alike = alike and agree(taken.reset, other.reset, facts)
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
                    decided &= agree(way.reset, unit_rows(len(way.reset)), facts)
                behind = owner.exactly.behind(facts, way.reset)
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


Box = tuple[tuple[Any, Any], ...]  # ends of coordinates from -1 to 1, exact
Way = Sequence[Sequence[str]]  # source, boundary and target of each transition


class Parallelepiped:
    """A set {c + A x, |x_i| <= 1} in the coordinates of a section, with exact centre and sides.

    `entry` has these as texts. The matrix `inward` leads from (coordinates, 1) to x.
    """

    def __init__(self, entry: Entries, size: int) -> None:
        self.centre, sides = [*map(exact, entry["centre"])], entry["sides"]
        fits = len(self.centre) == len(sides) == size and all(len(x) == size for x in sides)
        demand(fits, "a set has a centre and as many sides as coordinates")
        self.sides = [[*map(exact, side)] for side in sides]
        matrix = fmpq_mat(self.sides).transpose()
        demand(matrix.det() != 0, "the sides of a set are not independent")
        inverse = matrix.inv()
        shift = (inverse * fmpq_mat([[-x] for x in self.centre])).tolist()
        inward = [[*own, *last] for own, last in zip(inverse.tolist(), shift, strict=True)]
        self.inward = arb_mat(fmpq_mat(inward))

    @property
    def whole(self) -> Box:
        """All of the set."""
        return ((fmpq(-1), fmpq(1)),) * len(self.centre)

    def seen(self, image: StateSet) -> list[Any]:
        """Return balls around the set's coordinates of an image, a set of (coordinates, 1)."""
        found: list[Any] = image.through(self.inward).hull.entries()
        return found

    def apart(self, other: "Parallelepiped") -> bool:
        """Return whether another set is shown to have no point in common with this one."""
        size = len(other.centre)
        rows = [[*other.centre, fmpq(1)], *([*side, fmpq(0)] for side in other.sides)]
        columns = arb_mat(fmpq_mat(rows).transpose()).tolist()
        centre, sides = ([r[:1] for r in columns], [r[1:] for r in columns])
        seen = StateSet.of(arb_mat(centre), arb_mat(sides), arb_mat(size + 1, 1))
        return any(x > 1 or x < -1 for x in self.seen(seen))

    def lengths(self, box: Box) -> list[float]:
        """Return approximate lengths of the sides of a part of the set."""
        return [
            float(b - a) / 2 * sum(abs(float(x.p) / float(x.q)) for x in own)
            for (a, b), own in zip(box, self.sides, strict=True)
        ]


def divided(box: Box, k: int, place: Any = None) -> list[Box]:
    """Return two parts of a box, divided across a coordinate: in the middle if not at a place."""
    low, high = box[k]
    middle = (low + high) / 2 if place is None else place
    return [(*box[:k], part, *box[k + 1 :]) for part in ((middle, high), (low, middle))]


class SectionMap(CarryingSystem):
    """The power `iterates` of the map of a section, along ways that are stated.

    `content` has the entries of a file that state the system and the section. `Failure` is raised
    if they state no such section, or a system of another kind.
    """

    def __init__(self, content: Entries) -> None:
        self.section, self.iterates = StatedSection.of(content), content["iterates"]
        demand(self.iterates > 0, "no iterate of the map")
        super().__init__(SwitchingSystem(content["declaration"], content["parameters"]))
        self.facts, self.forced = self.section.facts(self.system, self.exactly)
        self.free = free_places(self.facts, self.system.size)
        named = [self.system.states[k] for k in self.free]
        told = [*content["coordinates"]] == named
        demand(told, "the coordinates are not those of the section")
        demand(self.free, "the section is one point")

    @cached_property
    def _speed(self) -> Any:
        return self.system.speed()

    @cached_property
    def _start(self) -> Entry:
        return Entry(self, self.section.configuration, self.facts)

    def check_way(self, way: Way) -> None:
        """Demand that a way leads from the section to itself, by declared transitions."""
        section = self.section
        here, passed, last = section.configuration, 0, ("", "", "")
        back = section.source, section.boundary, section.configuration
        for source, boundary, target in way:
            demand(source == here, "a way does not lead from configuration to configuration")
            stated = (source, frozenset({boundary})) in self.system.orders
            demand(stated, "no such transition")
            known = boundary in self.system.boundaries.get(source, {})
            demand(known, f"{source} has no boundary {boundary}")
            demand(target in self.system.fields, "a configuration is not declared")
            here, last = target, (source, boundary, target)
            passed += last == back
        if not self.forced:
            demand(
                passed == self.iterates and last == back, "a way does not lead back to the section"
            )
        demand(here == section.configuration, "a way does not lead back to the section")

    def image(self, own: Parallelepiped, box: Box, way: Way, *, sloped: bool = False) -> StateSet:
        """Return (coordinates, 1) of the image of a part; `TooWide` if it is not shown.

        `sloped` asks for derivatives along the sides of the set. `Failure` is raised if states of
        the part do not go that way.
        """
        entry, states = self._start, self._part(own, box, sloped)
        for source, boundary, target in way:
            phase = self.phases[source]
            row = row_of(phase.rows[boundary])
            arrived, before, after = phase.arrive(states, row, phase.guess(states.centre, boundary))
            watched = entry.watched(states)
            if boundary not in watched:
                raise Failure(f"{boundary} is zero all along {source}")
            phase.clear(states, before, {boundary: watched.pop(boundary)}, boundary)
            phase.clear(states, after, watched)
            states, entry = entry.behind(frozenset({boundary}), arrived)
            demand(entry.here == target, "another transition follows than the file states")
        facts = entry.facts
        if self.forced:
            states, facts = self._to_phase(entry, states)
        demand(all(not any(reduced(row, facts)) for row in self.facts), "off the section")
        return self._coordinates(states)

    def _part(self, own: Parallelepiped, box: Box, sloped: bool) -> StateSet:
        """Return the set of (states, time 0, 1) of a part, with tangents along the set's sides."""
        middles = [(a + b) / 2 for a, b in box]
        points = [
            [x + sum((m * side[k] for m, side in zip(middles, own.sides, strict=True)), fmpq(0))]
            + [(b - a) / 2 * side[k] for (a, b), side in zip(box, own.sides, strict=True)]
            for k, x in enumerate(own.centre)
        ]
        states = self._lifted([[*row] for row in zip(*points, strict=True)])
        none, zero = arb_mat(self.system.size + 2, 1), [fmpq(0)] * len(self.free)
        centre, sides = ([row[:1] for row in states], [row[1:] for row in states])
        tangents = []
        for side in own.sides if sloped else ():
            change = [[row[1]] for row in self._lifted([zero, side])]
            straight = arb_mat(self.system.size + 2, 0)
            tangents.append(StateSet.of(arb_mat(change), straight, none))
        return StateSet.of(arb_mat(centre), arb_mat(sides), none, tuple(tangents))

    def _lifted(self, columns: list[list[Any]]) -> list[list[Any]]:
        """Return columns of (states, time 0, 1): the first of a point, the others of directions."""
        none = [fmpq(0)] * len(columns)
        first = [fmpq(1), *none[1:]]
        matrix = [*zip(*columns, strict=True), first]
        rows = [*products(spanned(self.facts, self.system.size), matrix), none, first]
        found: list[list[Any]] = arb_mat(fmpq_mat(rows)).tolist()
        return found

    def _coordinates(self, states: StateSet) -> StateSet:
        places = [*self.free, self.system.size + 1]
        parts = (states.centre, states.sides, states.box)
        centre, sides, box = (arb_mat([part.tolist()[k] for k in places]) for part in parts)
        return StateSet(centre, sides, box, tuple(map(self._coordinates, states.tangents)))

    def _to_phase(self, entry: Entry, states: StateSet) -> tuple[StateSet, Any]:
        """Carry states on to where the forcing returns; no boundary may be reached on the way."""
        phase, size = self.phases[entry.here], self.system.size
        whole = self.iterates * 2 * arb.pi() / arb(self._speed)
        clock = arb_mat([[*(arb(0) for _ in range(size)), arb(1), -whole]])
        left = whole - states.centre[size, 0]
        if not left > 0:
            raise TooWide
        arrived, _, after = phase.arrive(states, clock, float(left.mid()))
        phase.clear(states, after, entry.watched(states))
        return arrived, self.exactly.echelon([*entry.lasting, *self.forced])
