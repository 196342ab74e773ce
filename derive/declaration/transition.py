"""What happens where a configuration is left: transitions, or a law that takes their place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from nonsmooth.derive.declaration.fields import declared, exact, set_fields
from nonsmooth.derive.symbols import Values


@declared
class Condition:
    """Demand that the first nonzero among g and its derivatives is positive, along one flow.

    Parameters
    ----------
    function : expression
        The function g, affine in the state.
    along : str
        Configuration whose flow gives the derivatives that decide where g vanishes.
    holds : bool
        False demands the contrary.
    """

    function: sp.Expr
    along: str
    holds: bool = True


@declared
class Transition:
    """What happens when `source` is left through a set of boundaries at one instant.

    Parameters
    ----------
    source, target : str
        Configurations before and after.
    boundaries : set of str
        Boundaries of `source` reached together; one alone in the ordinary case.
    conditions : tuple of Condition
        All must hold. Of several transitions for one set the first that applies is taken.
    reset : mapping of state symbol to expression
        Affine reset of the state; states that are not named stay.
    order : int
        Stops that are reached together may act in several orders. Transitions of each have a
        number of its own; the first that apply have to lead to one state, or what follows is
        ambiguous. Those of number 0 belong to all.
    """

    source: str
    boundaries: frozenset[str]
    target: str
    conditions: tuple[Condition, ...] = ()
    reset: Values = field(default_factory=dict)
    order: int = 0

    def reset_of(self, state: sp.Matrix, states: Sequence[sp.Symbol]) -> sp.Matrix:
        """Apply the reset to a state.

        Parameters
        ----------
        state : column (N,)
            Expressions of the state before the transition.
        states : sequence of symbols (N,)
            States of the system, in order.

        Returns
        -------
        column (N,)
            State behind it.
        """
        before = dict(zip(states, state, strict=True))
        rules = dict(self.reset.items())
        return sp.Matrix([rules.get(s, s).subs(before, simultaneous=True) for s in states])


@dataclass(frozen=True)
class LawContact:
    """A contact on which a law decides: friction, or a rigid stop."""

    name: str
    friction: bool  # False for a stop, which only pushes and has no limits
    relative: sp.Expr  # velocity along its direction, relative to the belt
    # position along a stop's direction, less that of the stop; zero of friction
    gap: sp.Expr = sp.S.Zero
    static: sp.Expr = sp.S.Zero  # largest force that friction holds
    kinetic: sp.Expr = sp.S.Zero  # force of friction once it has slipped
    slipping: sp.Expr = sp.S.Zero  # kinetic force on the oscillator along the direction
    overshooting: sp.Expr = sp.S.Zero  # kinetic force in the other sense of sliding


@dataclass(frozen=True)
class ContactLaw:
    """Coulomb's law for contacts that the mass matrix couples: what it is told, as data.

    Contacts that reach a boundary are decided together with those at rest. With L the kinetic
    limit of those that have reached the limit of their force, and the static one of the others,
    the accelerations minimise ``|a - a_free|^2 / 2 + sum L |w a|`` in the norm of the mass matrix,
    stops letting nothing through. All that slip there get their kinetic limit, until none is
    added. What is at its limit, or slips without acceleration, is decided by the first derivative
    that is not zero. A contact whose direction stops hold bears what it can before they are
    pressed. The law says nothing of systems in which stops alone hold one whose belt's velocity
    may or may not be zero.

    Regimes are `slip`, `stick` and `overshoot` of friction, `free` and `contact` of stops;
    in another regime a contact exerts no force, and the law does not decide on it. The
    regimes of all other parts are joined to one text.
    """

    contacts: tuple[LawContact, ...]
    # m x m: accelerations along the directions by unit forces along them
    coupling: sp.ImmutableMatrix
    regimes: Mapping[str, tuple[str, ...]]  # by configuration: a regime of each contact
    others: Mapping[str, str]  # by configuration: regimes of the other parts
    # by the others' regimes: accelerations along the directions without the contacts' forces
    free: Mapping[str, tuple[sp.Expr, ...]]
    # contact by boundary at which it comes to rest, or a stop would have to pull
    arrivals: dict[str, int]
    limits: dict[str, int]  # contact by boundary at which it has reached the limit of its force
    # by the others' regimes and boundaries of theirs, joined by "+": the others' next regimes
    switches: Mapping[str, Mapping[str, str]]
    # by configuration: contacts whose sliding is nominal, as other parts hold them at rest
    idle: Mapping[str, tuple[int, ...]]
    # by target and the others' boundaries: what begins to hold is set; target "" if nothing does
    resets: Mapping[str, Mapping[str, Values]]

    def __post_init__(self) -> None:
        free = {others: tuple(map(exact, found)) for others, found in self.free.items()}
        set_fields(self, coupling=sp.ImmutableMatrix(self.coupling), free=free)

    def decides(self, boundaries: frozenset[str]) -> bool:
        """Whether one of the boundaries, which are reached together, belongs to a contact."""
        return any(b in self.arrivals or b in self.limits for b in boundaries)

    def reset(self, source: str, boundaries: frozenset[str], target: str) -> Values | None:
        """Reset on the way to a target; None if the boundaries do not lead there."""
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
