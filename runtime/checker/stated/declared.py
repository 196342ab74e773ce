"""What a certificate declares, read exactly, and what follows from it without any rounding.

Of each configuration the affine field y' = A y + b, the rows n y + c of its boundaries (negative
inside) and of what vanishes in it; of each transition its conditions and its affine reset. States
carry a last entry 1, so that every affine map is one matrix and every affine function one row.
"""

from collections.abc import Mapping
from functools import cached_property
from math import factorial
from typing import Any, NamedTuple

from flint import fmpq

from nonsmooth.runtime.checker.stated.contacts import ContactLaw
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    Failure,
    Numbers,
    agree,
    demand,
    form_between,
    free_places,
    is_integer,
    leading,
    number_of,
    product,
    products,
    reduced,
    spanned,
    unit_rows,
)
from nonsmooth.runtime.core.rational_functions import RationalFunction, pivot

_FORCING_PHASE = "forcing-phase"  # ends the one phase of a motion that reaches no boundary


def _has_balls(entry: Any) -> bool:
    """Return whether any number of a declaration is stated as a ball."""
    if isinstance(entry, str):
        return False
    if isinstance(entry, dict):
        ball = entry.keys() == {"mid", "rad"} and isinstance(entry["mid"], str)
        return ball or any(map(_has_balls, entry.values()))
    return isinstance(entry, list) and any(map(_has_balls, entry))


class Transition(NamedTuple):
    """A declared transition from a configuration and boundaries to another, with affine reset."""

    begins: tuple[str, ...]  # source configuration, then its boundaries
    # row, configuration along which it is differentiated, whether it has to be positive
    conditions: list[tuple[Any, str, bool]]
    reset: Any  # (N + 1, N + 1)
    target: str
    order: int = 0  # of those in which stops may act that are reached together; 0 is in all
    early: int | None = None  # conditions of a law's steps before the last; None: it is listed


class Way(NamedTuple):
    """A transition that may follow the end of a phase."""

    # leading row, None where zero, and whether it has to be positive
    conditions: list[tuple[Any, bool]]
    wanted: bool  # whether it is the itinerary's, or does the same where stops act in many orders
    alike: bool  # whether it leads to the same configuration and the same states
    decided: bool  # whether a law's earlier steps are decided by their functions, not derivatives


class Step(NamedTuple):
    """A phase of the itinerary: its field, the row that ends it, and the transition behind it."""

    name: str  # configuration
    field: Any  # (N + 1, N + 1)
    exit: Any  # row of the first boundary that ends it
    taken: Transition
    target: str
    reset: Any  # the transition's; in the last phase projected along the translations


class StatedBoundary(NamedTuple):
    """A boundary's function in a phase, with its leading derivatives at both ends.

    Rows are reduced by what is known to be zero where they are taken.
    """

    name: str
    row: Any
    ends_it: bool  # whether it ends the phase
    order: int  # of the first derivative that is not zero where the phase begins
    begins: Any  # row of that derivative, None where the function is zero all along
    follows: int  # order of the next derivative that is not zero there
    still: bool  # whether the rate is zero all along
    end: Any  # the function where the phase ends
    speed: Any  # the function's rate where the phase ends


class StatedPhase(NamedTuple):
    """All that has to hold in a phase."""

    held: list[Any]  # rows that vanish where it begins
    watched: list[StatedBoundary]
    # of each order in which stops may act, what may follow; first come first
    orders: list[list[Way]]
    lawful: bool  # whether a contradiction leaves it open, as with a law or several orders
    decided: bool  # whether a law's steps are decided and its reset moves nothing


class StatedTables:
    """The configurations and transitions that a file declares, in exact numbers.

    `values` has all parameters that the file names; entries of the declaration are
    functions of them. `constants` are the irrational numbers of the declaration, in its
    order. A declaration that takes roots has numbers for entries and names no parameters.
    """

    def __init__(
        self, declared: Entries, values: Mapping[str, Any], constants: Numbers = ()
    ) -> None:
        names, self.poles, self.exactly = declared["parameters"], list[Any](), Elimination()
        self.rational = not _has_balls(declared)
        self.bound = sorted(names) == sorted(values)
        demand(self.bound or not names, "the declaration is not over the parameters that are named")
        self.variables = [*(values[name] for name in names), *constants]
        self.states, self.size = declared["states"], len(declared["states"])
        self.forcing = declared["forcing"]
        told = [k for pair in self.forcing for k in pair]
        demand({*told} <= {*range(self.size)} and len({*told}) == len(told), "no such forcing")
        zero = (fmpq(0),) * self.size
        self.configurations, self.fields = {}, {}
        for name, entry in declared["configurations"].items():
            self.fields[name] = [*self.rows(entry["field"]), (*zero, fmpq(0))]
            rows = {boundary: self.row(row) for boundary, row in entry["boundaries"].items()}
            demand(_FORCING_PHASE not in rows, "a boundary with the name of a forcing's phase")
            self.configurations[name] = rows, [*map(self.row, entry["held"])]
        self.transitions = [
            Transition(
                (entry["source"], *sorted(entry["boundaries"])),
                [(self.row(row), along, holds) for row, along, holds in entry["conditions"]],
                [*self.rows(entry["reset"]), (*zero, fmpq(1))],
                entry["target"],
                entry.get("order", 0),
            )
            for entry in declared["transitions"]
        ]
        along = {other for way in self.transitions for _, other, _ in way.conditions}
        demand(along <= self.fields.keys(), "a condition is along no declared configuration")
        self.lawful: list[Any] = []  # rows of the contact law
        if "law" in declared and self.rational:
            self._lawful(declared)

    def _lawful(self, declared: Entries) -> None:
        """Demand that all transitions with steps are those of the stated contact law."""
        try:
            law = ContactLaw(declared["law"], self.row, self.number, self.exactly)
            self.lawful = law.rows
            for place, entry in enumerate(declared["transitions"]):
                if "steps" in entry:
                    own = self.transitions[place]
                    self.transitions[place] = own._replace(early=law.check(entry, own.conditions))
        except (KeyError, IndexError, TypeError, ValueError) as problem:
            raise Failure(f"the contact law is malformed: {problem!r}") from None

    def number(self, entry: Any) -> Any:
        """Return a file's entry as a fraction, ball, or rational function of the parameters."""
        found = number_of(entry, self.variables)
        if isinstance(found, RationalFunction) and not found.below.is_one():
            self.poles.append(found)
        return found

    def row(self, entries: list[Any]) -> tuple[Any, ...]:
        """Return an affine function of the state as a row (N + 1) that acts on (y, 1)."""
        demand(len(entries) == self.size + 1, "a row of another size")
        return tuple(map(self.number, entries))

    def rows(self, entries: list[Any]) -> list[Any]:
        """Return N rows (N + 1), one for each state."""
        demand(len(entries) == self.size, "a matrix of another size")
        return [*map(self.row, entries)]


class StatedSystem(StatedTables):
    """The system, itinerary and closing of a certificate, in exact numbers."""

    def __init__(
        self, content: Entries, values: Mapping[str, Any], constants: Numbers = ()
    ) -> None:
        declared, self.closing = content["declaration"], content["closing"]
        super().__init__(declared, values, constants)
        self.start, self.dwell = declared["start"], [p["dwell_time"] for p in declared["phases"]]
        self._check_names(declared["states"])
        self.itinerary = declared["phases"]
        phases = [[p["configuration"], "+".join(p["boundaries"])] for p in self.itinerary]
        demand(content["itinerary"] == phases, "the itinerary is not that of the declaration")
        self.steps = []
        names = [phase["configuration"] for phase in self.itinerary]
        for phase, target in zip(self.itinerary, [*names[1:], *names[:1]], strict=True):
            number, name = phase["transition"], phase["configuration"]
            demand(name in self.fields, "a configuration of the itinerary is not declared")
            if phase["boundaries"] == [_FORCING_PHASE]:
                demand(len(self.itinerary) == 1, "a forcing's phase beside others")
                self.steps.append(self._whole_turn(name))
                continue
            ends, stated = phase["boundaries"], self.configurations[name][0].keys()
            demand(ends and {*ends} <= stated, "a phase ends at none of its boundaries")
            demand(len({*ends}) == len(ends), "a phase ends twice at a boundary")
            demand(0 <= number < len(self.transitions), "there is no such transition")
            taken = self.transitions[number]
            ways = (name, *sorted(phase["boundaries"])), target
            leads = ways == (taken.begins, taken.target)
            demand(leads, "a transition does not lead from phase to phase")
            row = self.configurations[name][0][phase["boundaries"][0]]
            self.steps.append(Step(name, self.fields[name], row, taken, target, taken.reset))
        self.forced = [k for pair in self.forcing for k in pair]
        self.free = [k for k in range(self.size) if k not in self.forced]
        self.translations = [
            tuple(map(self.number, row)) for row in self.closing.get("translations", [])
        ]
        for direction in self.translations:
            self._close_along(direction)
        self.alone = all(len(phase["boundaries"]) == 1 for phase in self.itinerary)
        # what vanishes along the orbit alone says nothing of motions beside it
        beside = self.alone and "vanishing" in self.closing
        demand(not beside, "functions that vanish though boundaries are reached one by one")
        self.omega: list[Any] = []
        timed = self.closing["kind"] == "period"
        demand(not timed or self.closing["period"] in values, "no period is given")
        self.period = values[self.closing["period"]] if timed else None

    @property
    def unknowns(self) -> list[str]:
        """Names of the unknowns: free states at the start, the forcing's time, dwell times."""
        time = ["forcing time"] if self.forcing else []
        return [*(self.start[k] for k in self.free), *time, *self.dwell]

    @property
    def stability(self) -> str:
        """The stability that can be claimed: "neutral" if the period is given, else "stable"."""
        return "neutral" if self.closing["kind"] == "period" else "stable"

    @property
    def dropped(self) -> int:
        """The coordinate whose closure follows from the energy; -1 for none."""
        return int(self.closing.get("dropped", -1))

    def _check_names(self, states: list[str]) -> None:
        """Demand distinct names at the start: x1's is x1 or x10, or one of no other state."""
        demand(len(self.start) == len(states), "every state has a name at the start")
        demand(len({*states}) == len(states), "two states have one name")
        named = [*self.start, *self.dwell, "period", "trace"]
        demand(len({*named}) == len(named), "two unknowns have one name")
        for place, name in enumerate(self.start):
            others = [other for k, other in enumerate(states) if k != place]
            free = all(name not in (other, f"{other}0") for other in others)
            demand(free or name == f"{states[place]}0", f"{name} is that of another state")

    def _whole_turn(self, name: str) -> Step:
        """Return a phase that ends where the first forcing begins anew, with no reset."""
        demand(bool(self.forcing), "without a forcing there is no phase of it")
        sine = self.forcing[0][1]
        identity = unit_rows(self.size + 1)
        staying = Transition((name, _FORCING_PHASE), [], identity, name)
        return Step(name, self.fields[name], identity[sine], staying, name, identity)

    def closes(self) -> dict[str, Any]:
        """Prove that the cycle closes in what is no equation; return each configuration's energy.

        With a forcing, its states are shown to return after whole turns. Where the period is
        given, the energies are matrices (N + 1, N + 1) over (y, 1), and a symplectic form is
        shown to be kept; else there are none. The field is f = Omega^-1 grad E with E = y'H
        y/2, so each phase keeps E and Omega. At a boundary the reset keeps E, and Omega on
        its tangents: the monodromy is symplectic. `Failure` is raised if what the file states
        of the closing is not so.
        """
        kind = self.closing["kind"]
        demand((kind == "forcing") == bool(self.forcing), "a forcing is left out")
        demand(kind == "state" or self.rational, "the declaration is not exact")
        if kind == "forcing":
            self._returns()
        if kind != "period":
            return {}
        demand(self.dropped in self.free, "an open coordinate")
        self.omega = omega = [tuple(map(self.number, row)) for row in self.closing["form"]]
        demand(len(omega) == self.size, "no symplectic form")
        demand(omega == [tuple(-x for x in column) for column in zip(*omega, strict=True)],
               "no symplectic form")  # fmt: skip
        visited = {step.name for step in self.steps}
        demand(self.closing["constants"].keys() == visited, "energies of other configurations")
        energies = {}
        for step in self.steps:
            upper = products(omega, step.field[:-1])
            last = self.number(self.closing["constants"][step.name])
            energy = [*upper, (*(row[-1] for row in upper), last)]
            symmetric = energy == list(zip(*energy, strict=True))
            demand(symmetric, "a field is not the energy's")
            energies[step.name] = energy
        for step in self.steps:
            linear = [row[:-1] for row in step.reset[:-1]]
            for kept, before, reset, normal in (
                (energies[step.target], energies[step.name], step.reset, step.exit),
                (omega, omega, linear, step.exit[:-1]),
            ):
                on = self.exactly.left_kernel([[x] for x in normal])
                moved = products(on, list(zip(*reset, strict=True)))
                same = form_between(kept, moved) == form_between(before, on)
                demand(same, "a reset keeps neither energy nor form")
        return energies

    def _close_along(self, direction: tuple[Any, ...]) -> None:
        """Close the cycle up to a translation of all that is declared: y + s d is a motion if y is.

        Behind the last phase the state is moved along it until the direction's first
        coordinate is zero.
        """
        rows = [*self.lawful, *(row for field in self.fields.values() for row in field)]
        for boundaries, held in self.configurations.values():
            rows += [*boundaries.values(), *held]
        for transition in self.transitions:
            rows += [row for row, _, _ in transition.conditions]
            rows += [
                tuple(x - int(i == j) for j, x in enumerate(row))
                for i, row in enumerate(transition.reset)
            ]
        along = [[x] for x in (*direction, fmpq(0))]
        demand(len(direction) == self.size and self.rational and any(direction),
               "no direction to close along")  # fmt: skip
        demand(not any(product(row, along)[0] for row in rows), "no translation of the system")
        gauge = pivot(direction)  # zero where the cycle begins
        others = sum(1 for other in self.translations if other[gauge])
        demand(others == 1, "directions that are not independent")
        last = self.steps[-1]
        share = [x / direction[gauge] for x in last.reset[gauge]]
        reset = [
            tuple(x - d * y for x, y in zip(row, share, strict=True))
            for row, d in zip(last.reset, (*direction, fmpq(0)), strict=True)
        ]
        self.steps[-1] = last._replace(reset=reset)

    def _returns(self) -> None:
        (c0, s0), turns = self.forcing[0], self.closing["turns"]
        first = self.steps[0].field
        for c, s in self.forcing:
            w = first[s][c]
            demand(is_integer(w * turns / first[s0][c0]), "a forcing does not return")
            for k, other, rate in ((c, s, -w), (s, c, w)):
                turns_as = [rate if j == other else 0 for j in range(self.size + 1)]
                keep = [int(j == k) for j in range(self.size + 1)]
                even = all(list(step.field[k]) == turns_as for step in self.steps)
                demand(even, "an uneven forcing")
                demand(all(list(step.reset[k]) == keep for step in self.steps), "a reset forcing")

    @cached_property
    def known(self) -> list[tuple[Any, Any, Any]]:
        """Reduced facts of each phase: where it begins, those that last, and where it ends."""
        return self._from([])

    def _from(self, facts: list[Any]) -> list[tuple[Any, Any, Any]]:
        """Return the facts of each phase, given some that are true where the cycle begins."""
        found: list[tuple[Any, Any, Any]] = []
        count = -1
        while len(facts) > count:  # till nothing is added
            found, count = [], len(facts)
            for step in self.steps:
                kept = self.exactly.lasting(facts, step.field)
                end = self.exactly.echelon([*kept, step.exit])
                found.append((facts, kept, end))
                facts = self.exactly.behind(end, step.reset)
        return found

    def phases(self, vanishing: list[Any]) -> list[StatedPhase]:
        """Return what has to hold in each phase of an orbit along which some functions vanish.

        `vanishing` holds rows (N + 1) that are zero where the orbit begins. `Failure` is
        raised if the declaration is not exact.
        """
        demand(self.rational, "the declaration is not exact")
        facts = self._from(vanishing) if vanishing else self.known
        return [self._phase(place, *each) for place, each in enumerate(facts)]

    @cached_property
    def section(self) -> tuple[int, list[int], list[Any]]:
        """The smallest section: its phase, n free coordinates, and changes (N + 1, n) by them.

        Facts fix the other coordinates. Forced orbits are compared at fixed times, where only
        facts that last hold for changes.
        """
        found, unit = [], unit_rows(self.size)
        forced = [unit[k] for k in self.forced]
        for place in range(len(self.steps) if self.rational else 1):
            facts = self.known[place][1 if self.forcing else 0] if self.rational else []
            gauges = [pivot(direction) for direction in self.translations if not place]
            still = [unit[k] for k in gauges]
            rows = self.exactly.echelon([*forced, *still, *(row[:-1] for row in facts)])
            changes = [(*row, fmpq(0)) for row in rows]
            basis = [row[:-1] for row in spanned(changes, self.size)]
            free = free_places(rows, self.size)
            found.append((place, free, [*basis, [fmpq(0)] * len(free)]))
        return min(found, key=lambda entry: len(entry[1]))

    def _phase(self, place: int, begin: Any, kept: Any, end: Any) -> StatedPhase:
        step = self.steps[place]
        boundaries, held = self.configurations[step.name]
        ending = self.itinerary[place]["boundaries"]
        watched = []
        for name, row in boundaries.items():
            order, begins = leading(row, step.field, begin, 0)
            rate = product(row, step.field)
            still = not any(reduced(rate, kept))
            follows, behind = leading(row, step.field, begin, order + 1)
            begun = order, begins, order + 1 if behind is None else follows
            ends = reduced(row, end), reduced(rate, end)
            watched.append(StatedBoundary(name, row, name in ending, *begun, still, *ends))
        own = [boundaries[name] for name in ending if name != _FORCING_PHASE]
        listed = [t for t in self.transitions if t.begins == step.taken.begins]
        numbers = sorted({t.order for t in listed if t.order})
        if numbers:  # so many stops act in so many orders
            full = any(len(numbers) == factorial(n) for n in range(2, len(ending) + 1))
            demand(full and numbers == [*range(1, len(numbers) + 1)], "an order is missing")
        orders = [self._ways(step.taken, listed, number, own, end) for number in numbers or (0,)]
        if ending == [_FORCING_PHASE]:
            orders = [[Way([], True, True, True)]]
        decided = all(way.decided for ways in orders for way in ways)
        if step.taken.early is not None:  # what begins to hold is in its place already
            decided &= agree(step.taken.reset, unit_rows(self.size + 1), end)
        lawful = bool(numbers) or any(t.early is not None for t in listed)
        return StatedPhase([reduced(row, begin) for row in held], watched, orders, lawful, decided)

    def _ways(
        self, taken: Transition, listed: list[Transition], number: int, own: list[Any], end: Any
    ) -> list[Way]:
        """Return what may follow if stops act in one order, as far as the taken transition.

        Behind that only those that lead where it leads. Of several orders, all ways are returned;
        each has to lead where the taken transition leads.
        """
        found, passed = list[Way](), False
        for other in listed:
            if other.order not in (0, number):
                continue
            behind = [
                (*leading(row, self.fields[along], end, int(row in own)), holds)
                for row, along, holds in other.conditions
            ]
            alike = other.target == taken.target and agree(other.reset, taken.reset, end)
            decided = all(not k and row is not None for k, row, _ in behind[: other.early or 0])
            conditions = [(row, holds) for _, row, holds in behind]
            if alike or not passed:
                wanted = alike if number else other is taken
                found.append(Way(conditions, wanted, alike, decided))
            passed = passed or (other is taken and not number)
        return found
