"""The system of a file whose sets may divide: configurations, and all transitions that are stated.

What the file does not state is not known: who comes to a boundary, to boundaries that are reached
together, or to a configuration of which nothing is stated is lost.
"""

from collections.abc import Mapping
from math import factorial
from typing import Any, NamedTuple

from flint import fmpq

from nonsmooth.runtime.checker.exact import Elimination, demand, exact, number_of, reduced
from nonsmooth.runtime.checker.parameters import values_of

__all__ = ["StatedSection", "SwitchingSystem", "echelon_behind"]


class SwitchingSystem:
    """The system of a file whose sets may divide, in exact rows.

    `fields` has an (N + 1, N + 1) field for each configuration, `boundaries` its rows by
    name (negative inside), and `held` the rows that vanish in it. `transitions` leads
    from a source and its boundaries to lists of (conditions, reset, target), first come
    first: one list for each order in which stops that are reached together may act.
    `forcing` has the places of each cosine and sine. The declaration has no contact law,
    and all its numbers are rational.
    """

    def __init__(self, declared: dict[str, Any], parameters: Mapping[str, str]) -> None:
        demand("law" not in declared, "sets with a contact law are not checked")
        values, stated, constants = values_of(dict(parameters), (), declared.get("constants", []))
        demand(not constants, "a parameter is not rational")
        names = declared["parameters"]
        bound = sorted(names) == sorted(values)
        demand(bound, "the declaration is not over the parameters that are named")
        self._variables = [*(values[name] for name in names), *stated]
        self.states, self.size = declared["states"], len(declared["states"])
        demand(len({*self.states}) == self.size, "two states have one name")
        last = (fmpq(0),) * self.size
        self.fields, self.boundaries, self.held = {}, {}, {}
        for name, entry in declared["configurations"].items():
            self.fields[name] = [*self._rows(entry["field"]), (*last, fmpq(0))]
            self.boundaries[name] = {b: self._row(r) for b, r in entry["boundaries"].items()}
            self.held[name] = [*map(self._row, entry["held"])]
        taken: dict[tuple[str, frozenset[str]], list[Any]] = {}
        for entry in declared["transitions"]:
            demand("steps" not in entry, "a transition of another kind")
            conditions = [(self._row(r), along, holds) for r, along, holds in entry["conditions"]]
            told = all(along in self.fields for _, along, _ in conditions)
            demand(told, "a configuration is missing")
            key = entry["source"], frozenset(entry["boundaries"])
            demand(len(key[1]) == len(entry["boundaries"]), "a boundary is named twice")
            reset = [*self._rows(entry["reset"]), (*last, fmpq(1))]
            way = conditions, reset, entry["target"]
            taken.setdefault(key, []).append((entry.get("order", 0), way))
        self.transitions = {key: _in_orders(ways) for key, ways in taken.items()}
        self.forcing = [tuple(pair) for pair in declared["forcing"]]

    def _row(self, entries: list[Any]) -> tuple[Any, ...]:
        demand(len(entries) == self.size + 1, "a row of another size")
        found = tuple(number_of(entry, self._variables) for entry in entries)
        demand(all(isinstance(x, fmpq) for x in found), "the declaration is not rational")
        return found

    def _rows(self, entries: list[Any]) -> list[Any]:
        demand(len(entries) == self.size, "a matrix of another size")
        return [*map(self._row, entries)]

    def speed(self) -> Any:
        """Return the angular frequency of the one forcing, which every motion keeps.

        `Failure` is raised if it is not even, or if a transition changes its phase.
        """
        demand(len(self.forcing) == 1, "not one forcing")
        ((c, s),) = self.forcing
        demand(c != s and {c, s} <= {*range(self.size)}, "no such forcing")
        unit = [[fmpq(int(j == k)) for j in range(self.size + 1)] for k in range(self.size)]
        speeds = {field[s][c] for field in self.fields.values()}
        demand(len(speeds) == 1, "an uneven forcing")
        (speed,) = speeds
        demand(speed, "the forcing stands still")
        for field in self.fields.values():
            even = [*field[c]] == [-speed * x for x in unit[s]]
            demand(even and [*field[s]] == [speed * x for x in unit[c]], "an uneven forcing")
        for _, reset, _ in (
            way for orders in self.transitions.values() for ways in orders for way in ways
        ):
            demand(all([*reset[k]] == unit[k] for k in (c, s)), "a reset forcing")
        return abs(speed)


class StatedSection(NamedTuple):
    """The states of a configuration at a phase of the forcing, or behind a transition."""

    configuration: str
    phase: tuple[str, ...] = ()  # cosine and sine of the phase, where there is a forcing
    source: str = ""  # configuration before the transition
    boundary: str = ""  # the transition's; several that are reached together are joined by +

    @staticmethod
    def of(content: Mapping[str, Any]) -> "StatedSection":
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
            orders = system.transitions.get((self.source, self.boundaries), [])
            ways = [reset for own in orders for _, reset, target in own if target == here]
            rows = system.boundaries.get(self.source, {})
            demand(ways and self.boundaries <= rows.keys(), "no such transition")
            reached = [rows[name] for name in sorted(self.boundaries)]
            before = exactly.echelon([*system.held[self.source], *reached])
            found = [echelon_behind(exactly, before, reset) for reset in ways]
            demand(all(own == found[0] for own in found), "a section of two kinds")
            forced = []
        else:
            demand(not self.source and not self.boundary, "a section of two kinds")
            demand(len(self.phase) == 2, "not one forcing")
            system.speed()
            phase = [*map(exact, self.phase)]
            demand(phase[0] ** 2 + phase[1] ** 2 == 1, "the phase is no point of the circle")
            forced = [
                (*(fmpq(int(j == k)) for j in range(system.size)), -x)
                for k, x in zip(system.forcing[0], phase, strict=True)
            ]
            found = [exactly.echelon([*forced, *system.held[here]])]
        demand(all(any(row[:-1]) for row in found[0]), "the section is empty")
        return found[0], forced


def _in_orders(ways: list[tuple[int, Any]]) -> list[list[Any]]:
    """Return the ways (order, way) as one list for each order; 0 belongs to all of them.

    Stops that are reached together act in all orders: where some are not stated nothing is.
    """
    numbers = sorted({number for number, _ in ways if number})
    full = len(numbers) in (factorial(n) for n in range(2, len(numbers) + 2))
    if numbers and not (full and numbers == [*range(1, len(numbers) + 1)]):
        return [[]]
    return [[way for order, way in ways if order in (0, number)] for number in numbers or [0]]


def echelon_behind(exactly: Elimination, facts: Any, reset: Any) -> list[Any]:
    """Return reduced rows that are exactly zero behind a reset, from those before it."""
    return exactly.echelon(exactly.left_kernel([reduced(row, facts) for row in reset]))
