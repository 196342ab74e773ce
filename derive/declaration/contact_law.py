"""Coulomb's law for contacts that the mass matrix couples: what it is told, as data.

Contacts that reach a boundary are decided together with those at rest. With L the kinetic limit
of those that have reached the limit of their force, and the static one of the others, the
accelerations minimise ``|a - a_free|^2 / 2 + sum L |w a|`` in the norm of the mass matrix, stops
letting nothing through. All that slip there get their kinetic limit, until none is added. What is
at its limit, or slips without acceleration, is decided by the first derivative that is not zero.
A contact whose direction stops hold bears what it can before they are pressed. The law says
nothing of systems in which stops alone hold one whose belt's velocity may or may not be zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.parameter import exact

__all__ = ["ContactLaw", "LawContact"]


@dataclass(frozen=True)
class LawContact:
    """A contact of a law: friction, or a rigid stop.

    Attributes
    ----------
    name : str
    friction : bool
        A stop pushes only; it has no limits.
    relative : expression
        Velocity along its direction, relative to the belt.
    gap : expression
        Position along the direction of a stop, less that of the stop; zero of friction.
    static, kinetic : expressions
        The most that friction holds, and what it holds once it has slipped.
    slipping, overshooting : expressions
        Kinetic forces on the oscillator along the direction.
    """

    name: str
    friction: bool
    relative: sp.Expr
    gap: sp.Expr = sp.S.Zero
    static: sp.Expr = sp.S.Zero
    kinetic: sp.Expr = sp.S.Zero
    slipping: sp.Expr = sp.S.Zero
    overshooting: sp.Expr = sp.S.Zero

    @property
    def functions(self) -> tuple[sp.Expr, ...]:
        """The affine functions, in their order."""
        return (
            self.relative, self.gap, self.static, self.kinetic, self.slipping, self.overshooting,
        )  # fmt: skip


@dataclass(frozen=True)
class ContactLaw:
    """The contacts of a system that the mass matrix couples, and what is known of them.

    Attributes
    ----------
    contacts : tuple of LawContact
    coupling : m x m matrix
        Accelerations along the directions by unit forces along them.
    regimes : mapping of configuration to a regime of each contact
        `slip`, `stick` and `overshoot` of friction, `free` and `contact` of stops; another
        regime exerts no force and is not decided here.
    others : mapping of configuration to str
        The regimes of all other parts, joined.
    free : mapping of the others' regimes to m expressions
        Accelerations along the directions, less those of the contacts' forces.
    arrivals : mapping of boundary to contact
        Boundaries at which a contact comes to rest, or a stop would have to pull.
    limits : mapping of boundary to contact
        Those at which a contact has reached the limit of its force.
    switches : mapping of the others' regimes to mapping of boundaries to others' regimes
        What other parts do at boundaries of theirs, joined by "+", that are reached together
        with contacts'.
    idle : mapping of configuration to contacts
        Those that slide in name only: others that hold keep them at rest.
    resets : mapping of target to mapping of the others' boundaries to resets
        What begins to hold is put exactly in its place; the target "" is where nothing does.
    """

    contacts: tuple[LawContact, ...]
    coupling: sp.ImmutableMatrix
    regimes: Mapping[str, tuple[str, ...]]
    others: Mapping[str, str]
    free: Mapping[str, tuple[sp.Expr, ...]]
    arrivals: dict[str, int]
    limits: dict[str, int]
    switches: Mapping[str, Mapping[str, str]]
    idle: Mapping[str, tuple[int, ...]]
    resets: Mapping[str, Mapping[str, Mapping[sp.Symbol, sp.Expr]]]

    def __post_init__(self) -> None:
        object.__setattr__(self, "coupling", sp.ImmutableMatrix(self.coupling))
        free = {others: tuple(map(exact, found)) for others, found in self.free.items()}
        object.__setattr__(self, "free", free)

    def decides(self, boundaries: frozenset[str]) -> bool:
        """Whether one of these boundaries, reached together, is a contact's."""
        return any(b in self.arrivals or b in self.limits for b in boundaries)

    def reset(
        self, source: str, boundaries: frozenset[str], target: str
    ) -> Mapping[sp.Symbol, sp.Expr] | None:
        """Reset on the way to a target; None where the boundaries do not lead there."""
        own = "+".join(sorted(b for b in boundaries if b not in self.arrivals | self.limits))
        others = self.switches[self.others[source]].get(own) if own else self.others[source]
        moved = {(self.arrivals | self.limits)[b] for b in boundaries - set(own.split("+"))}
        before, after = self.regimes[source], self.regimes[target]
        resting = {i for i, regime in enumerate(before) if regime in ("stick", "contact")}
        changed = {i for i in range(len(before)) if before[i] != after[i]}
        if others != self.others[target] or not changed <= resting | moved | {*self.idle[source]}:
            return None
        begins = any(after[i] in ("stick", "contact") for i in changed)
        return self.resets[target if begins else ""][own]
