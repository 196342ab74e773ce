"""The elements as parts: local regimes, their forces, and the boundaries between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary

__all__ = [
    "Exit",
    "FrictionPart",
    "Part",
    "StopPart",
    "SwitchPart",
    "exit_of",
]


@dataclass(frozen=True)
class Exit:
    """A boundary of a regime, the regime behind it, and the reset on the way."""

    boundary: Boundary
    target: str
    reset: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class SwitchPart:
    """A part whose regimes follow each other whatever the other parts do.

    Attributes
    ----------
    name : str
    regimes : tuple of str
    forces : mapping of regime to n x 1 matrix
        Generalized forces, affine in the state.
    exits : mapping of regime to exits
    direction : 1 x n matrix, or None
        Where it acts, if it acts in one direction,
    pushes : mapping of regime to expression
        and its force there.
    kind : str
        What the record of that force is called: NAME-KIND.
    rates : mapping of regime to (state, rate)
        How a state of its own moves.
    constraints : mapping of regime to expression
        Functions that vanish in it.
    """

    name: str
    regimes: tuple[str, ...]
    forces: Mapping[str, sp.Matrix]
    exits: Mapping[str, tuple[Exit, ...]]
    direction: sp.Matrix | None = None
    pushes: Mapping[str, sp.Expr] = field(default_factory=dict)
    kind: str = ""
    rates: Mapping[str, tuple[sp.Symbol, sp.Expr]] = field(default_factory=dict)
    constraints: Mapping[str, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class FrictionPart:
    """Dry friction along a direction: it slips, sticks, overshoots, is exhausted, or lifted.

    Attributes
    ----------
    name : str
    direction : 1 x n matrix
    speed : expression
        Velocity of the belt, which the direction keeps while it sticks.
    relative : expression
        Velocity relative to the belt.
    kinetic, static : expressions
        Coefficients of friction.
    falling : expression
        Slope by which the kinetic force falls with the relative velocity.
    load : expression
        Normal load, affine in the state.
    lifts : bool
        Whether the load may vanish where the contact is pressed.
    bearer : index of a part, or None
        The soft stop whose push is the load.
    exhausts : bool
        Whether the kinetic force may fall to zero under a positive load.
    """

    name: str
    direction: sp.Matrix
    speed: sp.Expr
    relative: sp.Expr
    kinetic: sp.Expr
    static: sp.Expr
    falling: sp.Expr
    load: sp.Expr
    lifts: bool
    bearer: int | None
    exhausts: bool
    holding: str = "stick"
    outcomes: tuple[str, ...] = ("slip", "stick", "overshoot")

    @property
    def regimes(self) -> tuple[str, ...]:
        """All regimes; those at rest decide among the first three."""
        exhausted = ("exhausted-slip", "exhausted-overshoot") if self.exhausts else ()
        return (*self.outcomes, *exhausted, *(("lifted",) if self.loses_load else ()))

    @property
    def loses_load(self) -> bool:
        """Whether there are states without a normal load."""
        return self.lifts or self.bearer is not None

    @property
    def limit(self) -> sp.Expr:
        """What it can hold."""
        return self.static * self.load

    def sliding(self, relative: sp.Expr, load: sp.Expr) -> dict[str, sp.Expr]:
        """Regimes of a contact that slides under a load, each with what is positive in it.

        The first whose function is positive is the regime; the contact is at rest if none is.
        """
        kinetic, slope = self.kinetic * load, self.falling * relative
        exhausted = {"exhausted-slip": -kinetic - slope, "exhausted-overshoot": slope - kinetic}
        return (exhausted if self.exhausts else {}) | {"slip": -relative, "overshoot": relative}

    def force(self, regime: str) -> sp.Expr | None:
        """Kinetic force on the oscillator along the direction; None where there is none."""
        kinetic, slope = self.kinetic * self.load, self.falling * self.relative
        return {"slip": kinetic + slope, "overshoot": slope - kinetic}.get(regime)

    def slides(self, regime: str) -> int:
        """Sign of the relative velocity in a regime; 0 where it sticks or is lifted."""
        side = regime.removeprefix("exhausted-")
        return -1 if side == "slip" else 1 if side == "overshoot" else 0

    def losses(self, regime: str) -> tuple[Boundary, ...]:
        """Where the force of a contact that does not stick ends or returns."""
        name, lifts = self.name, Boundary(f"{self.name}-lifts", -self.load)
        if regime == "lifted":
            return (Boundary(f"{name}-lands", self.load),) if self.lifts else ()
        if regime.startswith("exhausted"):
            short = self.sliding(self.relative, self.load)[regime]
            recovers = Boundary(f"{name}-recovers", -short)
            return (recovers, lifts) if self.lifts else (recovers,)
        if self.exhausts:  # at or before the load is lost
            short = self.sliding(self.relative, self.load)[f"exhausted-{regime}"]
            return (Boundary(f"{name}-exhausts", short),)
        return (lifts,) if self.lifts else ()

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries at which a relative velocity or a limit is reached."""
        if regime == "stick":
            return (f"{self.name}-breaks-forward", f"{self.name}-breaks-backward")
        return (f"{self.name}-reaches-belt",)


@dataclass(frozen=True, eq=False)
class StopPart:
    """A rigid stop; the direction points into it.

    Attributes
    ----------
    name : str
    direction : 1 x n matrix
    gap : expression
        Position along the direction, less that of the stop: negative in front of it.
    approach : expression
        Velocity along the direction.
    restitution : expression
    sign : 1 or -1
        Of the direction, seen from the declared one.
    speed : expression
        Zero: velocity that the direction keeps in contact.
    """

    name: str
    direction: sp.Matrix
    gap: sp.Expr
    approach: sp.Expr
    restitution: sp.Expr
    sign: int
    speed: sp.Expr = sp.S.Zero
    regimes: tuple[str, ...] = ("free", "contact")
    holding: str = "contact"
    outcomes: tuple[str, ...] = ("free", "contact")

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
        return (f"{self.name}-{'reaches' if regime == 'free' else 'leaves'}-stop",)


Part = SwitchPart | FrictionPart | StopPart


def exit_of(part: SwitchPart, regime: str, boundary: str) -> Exit:
    """The exit of a regime through a boundary."""
    return next(e for e in part.exits[regime] if e.boundary.name == boundary)
