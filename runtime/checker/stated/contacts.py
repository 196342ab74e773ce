"""Transitions of a contact law, derived again from what the law is told.

Coulomb's law for contacts that the mass matrix couples. All that reaches a boundary and what it
is coupled to at rest is decided in steps: what has reached the limit of its force has its kinetic
limit, the rest its static one; accelerations minimise |a - a_free|^2 / 2 + sum L |w a|. The
optimum is told by signs: a reaction that keeps w a = 0 is within its limit, what slips accelerates
against its force. What slips gets its kinetic limit in the next step, until nothing new slips.
"""

from itertools import chain
from typing import Any

from nonsmooth.runtime.checker.stated.exact import Elimination, demand
from nonsmooth.runtime.core.rational_functions import pivot

_REGIMES = {True: ("slip", "stick", "overshoot"), False: ("free", "contact")}


class ContactLaw:
    """A contact law as a certificate states it; `row` and `number` read its entries."""

    def __init__(self, told: dict[str, Any], row: Any, number: Any, exactly: Elimination) -> None:
        self.contacts, self.exactly = told["contacts"], exactly
        self.names = [contact["name"] for contact in self.contacts]
        self.limits = [
            {key: row(contact[key]) for key in ("static", "kinetic", "slipping", "overshooting")}
            for contact in self.contacts
        ]
        self.coupling = [[number(entry) for entry in each] for each in told["coupling"]]
        self.free = {name: [*map(row, rows)] for name, rows in told["free"].items()}
        self.arrivals, self.reaching = told["arrivals"], told["limits"]
        self.configurations = told["configurations"]
        turned = [list(column) for column in zip(*self.coupling, strict=True)]
        pairs = zip(chain(*self.coupling), chain(*turned), strict=True)
        symmetric = not any(x - y for x, y in pairs)
        demand(symmetric and len(turned) == len(self.names), "no coupling of contacts")

    @property
    def rows(self) -> list[Any]:
        """All affine functions of the state that the law states."""
        limits = [row for own in self.limits for row in own.values()]
        return [*limits, *chain.from_iterable(self.free.values())]

    def check(self, entry: dict[str, Any], conditions: list[tuple[Any, str, bool]]) -> int:
        """Demand that a transition is one of the law; return its number of earlier conditions.

        `entry` is the transition as the file states it; `conditions` are its triples (row,
        configuration, sign). The returned number counts the first conditions, those of steps
        before the last. `Failure` is raised if the law lets another thing happen.
        """
        before, behind = (self.configurations[entry[key]] for key in ("source", "target"))
        moved = {(self.arrivals | self.reaching).get(name, -1) for name in entry["boundaries"]}
        demand(-1 not in moved and moved, "a boundary is no contact's")
        demand(before["others"] == behind["others"], "another part switches")
        resting = self._resting(before, moved)
        kinetic = {self.reaching[name] for name in entry["boundaries"] if name in self.reaching}
        expected: list[tuple[Any, bool]] = []
        early = 0
        for place, step in enumerate(entry["steps"]):
            regimes = step["regimes"]
            same = step["kinetic"] == [self.names[i] for i in sorted(kinetic)]
            demand(same, "a step has other kinetic limits")
            for i, regime in enumerate(regimes):
                allowed = _REGIMES[self.contacts[i]["friction"]]
                allowed = allowed if i in resting else (before["regimes"][i],)
                demand(regime in allowed, "a contact does what the event does not let it do")
            early = len(expected)
            expected += self._signs(before["others"], resting, kinetic, regimes)
            slips = {i for i in resting if regimes[i] in ("slip", "overshoot")}
            last = place == len(entry["steps"]) - 1
            demand(last == (slips <= kinetic), "a step too few, or too many")
            kinetic |= slips
            demand(not last or regimes == behind["regimes"], "the steps lead elsewhere")
        demand(len(expected) == len(conditions), "a law's condition is missing")
        for (row, along, holds), (own, positive) in zip(conditions, expected, strict=True):
            alike = not any(x - y for x, y in zip(row, own, strict=True))
            right = alike and along == entry["target"] and holds == positive
            demand(right, "a condition is not that of the law")
        return early

    def _resting(self, before: dict[str, Any], moved: set[int]) -> list[int]:
        """Return the contacts to decide: those that moved and those at rest coupled to them."""
        still = {i for i, regime in enumerate(before["regimes"]) if regime in ("stick", "contact")}
        still |= set(before["idle"])
        found = set(moved)
        grown = True
        while grown:
            near = {i for i in still - found if any(self.coupling[i][j] for j in found)}
            found, grown = found | near, bool(near)
        return sorted(found)

    def _signs(
        self, others: str, resting: list[int], kinetic: set[int], regimes: list[str]
    ) -> list[tuple[Any, bool]]:
        """Return the rows of a step's conditions, each with whether it has to be positive."""
        zero = tuple(0 * x for x in self.free[others][0])
        forces = [zero] * len(regimes)
        for i, regime in enumerate(regimes):
            own = self.limits[i]
            full = i not in resting or i in kinetic
            if regime == "slip":
                forces[i] = own["slipping"] if full else own["static"]
            elif regime == "overshoot":
                forces[i] = own["overshooting"] if full else tuple(-x for x in own["static"])
        held = [i for i in resting if regimes[i] in ("stick", "contact")]
        sliding, rubbing = forces, [i for i in held if self.contacts[i]["friction"]]
        forces = self._balanced(others, held, sliding)
        found: list[tuple[Any, bool]] = []
        for i in resting:
            force, limit = forces[i], self.limits[i]["kinetic" if i in kinetic else "static"]
            if i in held and self.contacts[i]["friction"]:
                found.append((tuple(f - x for f, x in zip(force, limit, strict=True)), False))
                found.append((tuple(-f - x for f, x in zip(force, limit, strict=True)), False))
            elif i in held:
                found.append((force, False))
            elif self.contacts[i]["friction"] or not self._bound(i, held):
                sign = 1 if regimes[i] == "overshoot" else -1
                bearing = forces
                if self._bound(i, held):  # it slides where it would if the stops let go
                    bearing = self._balanced(others, rubbing, sliding)
                found.append((tuple(sign * x for x in self._moves(others, i, bearing)), True))
        return found

    def _balanced(self, others: str, held: list[int], forces: list[Any]) -> list[Any]:
        """Return the forces, with those at held contacts that cancel the accelerations there."""
        right = {i: [-x for x in self._moves(others, i, forces)] for i in held}
        found = list(forces)
        for i, solved in zip(held, self._solved(held, right), strict=True):
            found[i] = solved
        return found

    def _solved(self, held: list[int], right: dict[int, list[Any]]) -> list[Any]:
        """Return the forces along the held directions that give the accelerations `right`."""
        lines = [(*(self.coupling[i][j] for j in held), *right[i]) for i in held]
        found: list[Any] = [None] * len(held)
        for solved in self.exactly.echelon(lines):
            place = pivot(solved)
            demand(place < len(held), "directions that hold depend on each other")
            found[place] = solved[len(held) :]
        return found

    def _bound(self, i: int, held: list[int]) -> bool:
        """Return whether the held contacts leave a contact's direction no acceleration."""
        answers = self._solved(held, {j: [self.coupling[j][i]] for j in held})
        left = self.coupling[i][i]
        for j, (answer,) in zip(held, answers, strict=True):
            left = left - self.coupling[i][j] * answer
        return not left

    def _moves(self, others: str, i: int, forces: list[Any]) -> list[Any]:
        """Return the acceleration along a contact's direction that these forces give, as a row."""
        total = list(self.free[others][i])
        for factor, force in zip(self.coupling[i], forces, strict=True):
            if factor:
                total = [t + factor * x for t, x in zip(total, force, strict=True)]
        return total
