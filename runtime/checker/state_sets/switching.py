"""The system of a file whose sets may divide: configurations, and all transitions that are stated.

What the file does not state is not known: who comes to a boundary, to boundaries that are reached
together, or to a configuration of which nothing is stated is lost.
"""

from collections.abc import Mapping
from math import factorial
from typing import Any, NamedTuple

from nonsmooth.runtime.checker.stated.declared import StatedTables, Transition
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    demand,
    exact,
    fixed,
    unit_rows,
)
from nonsmooth.runtime.checker.stated.parameters import values_of


class SwitchingSystem(StatedTables):
    """The system of a file whose sets may divide, in exact rows.

    `boundaries` has the rows of each configuration by name (negative inside), and `held` the rows
    that vanish in it. `orders` leads from a source and its boundaries to lists of transitions,
    first come first: one list for each order in which stops that are reached together may act.
    All numbers are rational. A declaration with a contact law is refused unless it may be `lawful`.
    """

    def __init__(
        self, declared: Entries, parameters: Mapping[str, str], *, lawful: bool = False
    ) -> None:
        steps = any("steps" in entry for entry in declared["transitions"])
        told = lawful or ("law" not in declared and not steps)
        demand(told, "sets with a contact law are not checked")
        values, stated, constants = values_of(dict(parameters), (), declared.get("constants", []))
        demand(not constants, "a parameter is not rational")
        super().__init__(declared, values, stated)
        demand(self.bound, "the declaration is not over the parameters that are named")
        demand(self.rational, "the declaration is not rational")
        demand(len({*self.states}) == self.size, "two states have one name")
        self.boundaries = {name: rows for name, (rows, _) in self.configurations.items()}
        self.held = {name: held for name, (_, held) in self.configurations.items()}
        taken: dict[tuple[str, frozenset[str]], list[Transition]] = {}
        for way in self.transitions:
            source, *reached = way.begins
            demand(len({*reached}) == len(reached), "a boundary is named twice")
            taken.setdefault((source, frozenset(reached)), []).append(way)
        self.orders = {key: _in_orders(ways) for key, ways in taken.items()}

    def speed(self) -> Any:
        """Return the angular frequency of the one forcing, which every motion keeps.

        `Failure` is raised if it is not even, or if a transition changes its phase.
        """
        demand(len(self.forcing) == 1, "not one forcing")
        ((c, s),) = self.forcing
        demand(c != s and {c, s} <= {*range(self.size)}, "no such forcing")
        unit = unit_rows(self.size + 1)
        speeds = {field[s][c] for field in self.fields.values()}
        demand(len(speeds) == 1, "an uneven forcing")
        (speed,) = speeds
        demand(speed, "the forcing stands still")
        for field in self.fields.values():
            even = [*field[c]] == [-speed * x for x in unit[s]]
            demand(even and [*field[s]] == [speed * x for x in unit[c]], "an uneven forcing")
        for way in self.transitions:
            demand(all(way.reset[k] == unit[k] for k in (c, s)), "a reset forcing")
        return abs(speed)


class StatedSection(NamedTuple):
    """The states of a configuration at a phase of the forcing, or behind a transition."""

    configuration: str
    phase: tuple[str, ...] = ()  # cosine and sine of the phase, where there is a forcing
    source: str = ""  # configuration before the transition
    boundary: str = ""  # the transition's; several that are reached together are joined by +

    @staticmethod
    def of(content: Entries) -> "StatedSection":
        """Return the section that a file states."""
        source, boundary = content["source"], content["boundary"]
        return StatedSection(content["configuration"], tuple(content["phase"]), source, boundary)

    @property
    def boundaries(self) -> frozenset[str]:
        """The boundaries that the transition follows."""
        return frozenset(self.boundary.split("+"))

    def facts(self, system: SwitchingSystem, exactly: Elimination) -> tuple[Any, list[Any]]:
        """Return reduced rows that are zero on the section, and those zero at the forcing's phase.

        `Failure` is raised if there is no such section.
        """
        here = self.configuration
        demand(here in system.fields, "the section's configuration is not declared")
        if not system.forcing:
            demand(not self.phase, "a phase of no forcing")
            orders = system.orders.get((self.source, self.boundaries), [])
            ways = [way.reset for own in orders for way in own if way.target == here]
            rows = system.boundaries.get(self.source, {})
            demand(ways and self.boundaries <= rows.keys(), "no such transition")
            reached = [rows[name] for name in sorted(self.boundaries)]
            before = exactly.echelon([*system.held[self.source], *reached])
            found = [exactly.behind(before, reset) for reset in ways]
            demand(all(own == found[0] for own in found), "a section of two kinds")
            forced = []
        else:
            demand(not self.source and not self.boundary, "a section of two kinds")
            demand(len(self.phase) == 2, "not one forcing")
            system.speed()
            phase = [*map(exact, self.phase)]
            demand(phase[0] ** 2 + phase[1] ** 2 == 1, "the phase is no point of the circle")
            forced = fixed(system.size, zip(system.forcing[0], phase, strict=True))
            found = [exactly.echelon([*forced, *system.held[here]])]
        demand(all(any(row[:-1]) for row in found[0]), "the section is empty")
        return found[0], forced


def _in_orders(ways: list[Transition]) -> list[list[Transition]]:
    """Return transitions as one list for each order; 0 belongs to all of them.

    Stops that are reached together act in all orders: where some are not stated nothing is.
    """
    numbers = sorted({way.order for way in ways if way.order})
    full = len(numbers) in (factorial(n) for n in range(2, len(numbers) + 2))
    if numbers and not (full and numbers == [*range(1, len(numbers) + 1)]):
        return [[]]
    return [[way for way in ways if way.order in (0, number)] for number in numbers or [0]]
