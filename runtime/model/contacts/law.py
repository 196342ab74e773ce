"""The law of a system's coupled contacts: what it is told, by indices of rows and resets."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

__all__ = ["HOLDING", "ContactEvent", "ContactRows", "Law", "Regimes", "law_of"]

HOLDING = ("stick", "contact")
Regimes = tuple[str, ...]


class ContactRows(NamedTuple):
    """A contact: its name, whether it is one of friction, and the rows of its functions."""

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
        """Rows of its functions."""
        return (
            self.relative, self.gap, self.static, self.kinetic, self.slipping, self.overshooting,
        )  # fmt: skip

    @property
    def regimes(self) -> Regimes:
        """What it may do at rest."""
        return ("slip", "stick", "overshoot") if self.friction else ("free", "contact")


class ContactEvent(NamedTuple):
    """Boundaries that are reached together, as the law sees them.

    Attributes
    ----------
    resting : tuple of int
        Contacts that are decided: those at rest that the event concerns.
    reached : frozenset of int
        Those of them that have reached the limit of their force.
    regimes : tuple of str
        Of all contacts before the event.
    others : str
        Regimes of the other parts behind it,
    own : str
        and their boundaries among those that are reached.
    """

    resting: tuple[int, ...]
    reached: frozenset[int]
    regimes: Regimes
    others: str
    own: str


@dataclass(frozen=True, eq=False)
class Law:
    """The contacts and what is known of them; see `nonsmooth.derive.declaration.contact_law`.

    Attributes
    ----------
    contacts : tuple of ContactRows
    coupling : m x m rows, whose constants are the entries
    couples : m x m bools
        Whether an entry is not zero whatever the parameters.
    configurations : tuple of str
    regimes : for each configuration a regime of each contact
    others : for each configuration the regimes of the other parts
    free : mapping of the others' regimes to m rows
    arrivals, limits : mapping of boundary to contact
    switches : mapping of the others' regimes to mapping of their boundaries to regimes behind
    idle : for each configuration the contacts that slide in name only
    resets : mapping of target ("": nothing begins to hold) to mapping of boundaries to reset
    """

    contacts: tuple[ContactRows, ...]
    coupling: tuple[tuple[int, ...], ...]
    couples: tuple[tuple[bool, ...], ...]
    configurations: tuple[str, ...]
    regimes: tuple[Regimes, ...]
    others: tuple[str, ...]
    free: Mapping[str, tuple[int, ...]]
    arrivals: Mapping[str, int]
    limits: Mapping[str, int]
    switches: Mapping[str, Mapping[str, str]]
    idle: tuple[tuple[int, ...], ...]
    resets: Mapping[str, Mapping[str, int]]

    @cached_property
    def _places(self) -> dict[tuple[str, Regimes], int]:
        both = zip(self.others, self.regimes, strict=True)
        return {key: place for place, key in enumerate(both)}

    def configuration(self, regimes: Regimes, others: str) -> int | None:
        """The configuration of these regimes; None if they do not go together.

        Parameters
        ----------
        regimes : tuple of str
            Of each contact.
        others : str
            Regimes of the other parts.

        Returns
        -------
        int or None
            Its index.
        """
        return self._places.get((others, regimes))

    def idling(self, event: ContactEvent, regimes: Regimes) -> tuple[int, ...]:
        """Contacts of an event that slide in name only among these regimes.

        Parameters
        ----------
        event : ContactEvent
        regimes : tuple of str
            Of each contact.

        Returns
        -------
        tuple of int
            Indices of contacts.
        """
        found = self.configuration(regimes, event.others)
        return () if found is None else self.idle[found]

    def untouched(self, event: ContactEvent, regimes: Regimes) -> tuple[int, ...]:
        """Stops of an event that are free because friction holds their directions at rest.

        Parameters
        ----------
        event : ContactEvent
        regimes : tuple of str
            Of each contact.

        Returns
        -------
        tuple of int
            Indices of contacts.
        """
        return tuple(
            i
            for i in event.resting
            if regimes[i] == "free"
            and self.configuration((*regimes[:i], "contact", *regimes[i + 1 :]), event.others)
            is None
        )

    def beginning(self, configuration: int, resting: Iterable[int]) -> ContactEvent:
        """A start at rest, as an event: nothing has reached its limit.

        Parameters
        ----------
        configuration : int
        resting : iterable of int
            Contacts at rest.
        """
        regimes, others = self.regimes[configuration], self.others[configuration]
        return ContactEvent(tuple(resting), frozenset(), regimes, others, "")

    def event(self, source: int, boundaries: Iterable[str]) -> ContactEvent | None:
        """What an event concerns; None where it is none of contacts, or is not declared.

        Parameters
        ----------
        source : int
            The configuration in which the boundaries are reached.
        boundaries : iterable of str
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
        """Whether a configuration may follow: nothing changes but what the event concerns.

        Parameters
        ----------
        event : ContactEvent
        target : int
            A configuration.
        """
        pairs = zip(event.regimes, self.regimes[target], strict=True)
        kept = all(a == b for i, (a, b) in enumerate(pairs) if i not in event.resting)
        return kept and self.others[target] == event.others

    def reset(self, event: ContactEvent, target: int) -> int:
        """The reset on the way to a target: what begins to hold is put in its place.

        Parameters
        ----------
        event : ContactEvent
        target : int
            A configuration.

        Returns
        -------
        int
            Its index among the system's resets.
        """
        pairs = zip(event.regimes, self.regimes[target], strict=True)
        begins = any(after in HOLDING and after != before for before, after in pairs)
        return self.resets[self.configurations[target] if begins else ""][event.own]


def law_of(table: Mapping[str, Any], configurations: Sequence[str]) -> Law | None:
    """The law in a system's table; None where each contact is decided by itself.

    Parameters
    ----------
    table : mapping of str to object
        Of a system, as it is emitted.
    configurations : sequence of str
        Of that system, in its order.
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
