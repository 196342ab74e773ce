"""The law of a system's coupled contacts: what it is told, by indices of rows and resets."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

HOLDING = ("stick", "contact")
Regimes = tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class ContactRows:
    """A contact: its name, whether it has friction, and the rows of its functions."""

    name: str
    friction: bool
    relative: int
    gap: int
    static: int
    kinetic: int
    slipping: int
    overshooting: int

    @property
    def rows(self) -> tuple[int, ...]:
        """The rows of the contact's functions."""
        return (
            self.relative, self.gap, self.static, self.kinetic, self.slipping, self.overshooting,
        )  # fmt: skip

    @property
    def regimes(self) -> Regimes:
        """The regimes that the contact may have at rest."""
        return ("slip", "stick", "overshoot") if self.friction else ("free", "contact")


class ContactEvent(NamedTuple):
    """Boundaries that are reached at one instant, as the contact law sees them."""

    # contacts at rest that the event concerns, about which the law decides
    resting: tuple[int, ...]
    reached: frozenset[int]  # those of them whose force has reached its limit
    regimes: Regimes  # of all contacts before the event
    others: str  # regimes of the other parts behind the event
    own: str  # boundaries of the other parts among those reached, joined by "+"


@dataclass(frozen=True, eq=False)
class Law:
    """The law that decides about coupled contacts.

    See `nonsmooth.derive.declaration.transition.ContactLaw`. Here m is the number of contacts.
    Tuples run over the configurations or over the contacts.
    """

    contacts: tuple[ContactRows, ...]
    # m x m rows, whose constants are the entries of the coupling matrix
    coupling: tuple[tuple[int, ...], ...]
    couples: tuple[tuple[bool, ...], ...]  # m x m, whether an entry is not identically zero
    configurations: tuple[str, ...]  # names
    regimes: tuple[Regimes, ...]  # for each configuration the regime of each contact
    others: tuple[str, ...]  # for each configuration the regimes of the other parts
    # for the others' regimes m rows, the accelerations without contact forces
    free: Mapping[str, tuple[int, ...]]
    arrivals: Mapping[str, int]  # contact of each boundary at which one comes to rest
    limits: Mapping[str, int]  # contact of each boundary at which a force reaches its limit
    # for the others' regimes and their boundaries the others' regimes behind
    switches: Mapping[str, Mapping[str, str]]
    # for each configuration the contacts that slide in name only: others keep them at rest
    idle: tuple[tuple[int, ...], ...]
    # by target ("" if no contact begins to hold) and boundaries of other parts
    resets: Mapping[str, Mapping[str, int]]

    @cached_property
    def _places(self) -> dict[tuple[str, Regimes], int]:
        both = zip(self.others, self.regimes, strict=True)
        return {key: place for place, key in enumerate(both)}

    def configuration(self, regimes: Regimes, others: str) -> int | None:
        """Index of the configuration with these regimes; None if no configuration has them.

        `regimes` has one of each contact, `others` those of the other parts.
        """
        return self._places.get((others, regimes))

    def idling(self, event: ContactEvent, regimes: Regimes) -> tuple[int, ...]:
        """Contacts that slide in name only in the configuration that an event and regimes give.

        `regimes` has one of each contact; the other parts have those of the event.
        """
        found = self.configuration(regimes, event.others)
        return () if found is None else self.idle[found]

    def untouched(self, event: ContactEvent, regimes: Regimes) -> tuple[int, ...]:
        """Stops of an event that are free because friction holds their directions at rest.

        `regimes` has one of each contact.
        """
        return tuple(
            i
            for i in event.resting
            if regimes[i] == "free"
            and self.configuration((*regimes[:i], "contact", *regimes[i + 1 :]), event.others)
            is None
        )

    def beginning(self, configuration: int, resting: Iterable[int]) -> ContactEvent:
        """The event of a start at rest, at which no force has reached its limit."""
        regimes, others = self.regimes[configuration], self.others[configuration]
        return ContactEvent(tuple(resting), frozenset(), regimes, others, "")

    def event(self, source: int, boundaries: Iterable[str]) -> ContactEvent | None:
        """The event of boundaries that are reached together in the configuration `source`.

        It concerns the contacts that come to rest or reach their limit, and all contacts at rest
        that are coupled with these, directly or through others. None if no contact is among them,
        or if no switch is declared for the boundaries of the other parts.
        """
        boundaries = frozenset(boundaries)
        reached = frozenset(self.limits[b] for b in boundaries if b in self.limits)
        moved = reached | {self.arrivals[b] for b in boundaries if b in self.arrivals}
        if not moved:
            return None
        own = "+".join(sorted(boundaries - self.limits.keys() - self.arrivals.keys()))
        others = self.switches[self.others[source]].get(own) if own else self.others[source]
        if others is None:
            return None
        regimes = self.regimes[source]
        holding = {i for i, regime in enumerate(regimes) if regime in HOLDING}
        concerned, left = set(moved), (holding | {*self.idle[source]}) - moved
        while near := {i for i in left if any(self.couples[i][j] for j in concerned)}:
            concerned, left = concerned | near, left - near
        return ContactEvent(tuple(sorted(concerned)), reached, regimes, others, own)

    def leads(self, event: ContactEvent, target: int) -> bool:
        """Whether a configuration may follow: only what the event concerns changes."""
        pairs = zip(event.regimes, self.regimes[target], strict=True)
        kept = all(a == b for i, (a, b) in enumerate(pairs) if i not in event.resting)
        return kept and self.others[target] == event.others

    def reset(self, event: ContactEvent, target: int) -> int:
        """Index of the system's reset from an event to a target.

        It differs where a contact begins to hold: the reset puts it exactly in its place.
        """
        pairs = zip(event.regimes, self.regimes[target], strict=True)
        begins = any(after in HOLDING and after != before for before, after in pairs)
        return self.resets[self.configurations[target] if begins else ""][event.own]


def law_of(table: Mapping[str, Any], configurations: Sequence[str]) -> Law | None:
    """The law in a system's emitted table; None if each contact is decided by itself.

    `configurations` are those of the system, in its order.
    """
    found = table.get("law")
    if found is None:
        return None
    return Law(
        tuple(ContactRows(**entry) for entry in found["contacts"]),
        tuple(map(tuple, found["coupling"])),
        tuple(map(tuple, found["couples"])),
        tuple(configurations),
        tuple(tuple(found["regimes"][name]) for name in configurations),
        tuple(found["others"][name] for name in configurations),
        {others: tuple(rows) for others, rows in found["free"].items()},
        found["arrivals"],
        found["limits"],
        found["switches"],
        tuple(tuple(found["idle"][name]) for name in configurations),
        found["resets"],
    )
