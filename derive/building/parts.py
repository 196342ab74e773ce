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
    """A boundary of a regime, with the regime behind it and the reset of the state."""

    boundary: Boundary
    target: str
    reset: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class SwitchPart:
    """A part whose regimes follow each other independently of the other parts."""

    name: str
    regimes: tuple[str, ...]
    forces: Mapping[str, sp.Matrix]  # by regime, n x 1: generalized forces, affine in the state
    exits: Mapping[str, tuple[Exit, ...]]
    direction: sp.Matrix | None = None  # 1 x n, for a part that acts in one direction
    # by regime: force along the direction
    pushes: Mapping[str, sp.Expr] = field(default_factory=dict)
    kind: str = ""  # the record of that force is called NAME-KIND
    # by regime: a state of its own and its derivative by time
    rates: Mapping[str, tuple[sp.Symbol, sp.Expr]] = field(default_factory=dict)
    # by regime: a function of the state that vanishes
    constraints: Mapping[str, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class FrictionPart:
    """Dry friction along a direction: it slips, sticks, overshoots, is exhausted, or lifted."""

    name: str
    direction: sp.Matrix  # 1 x n
    speed: sp.Expr  # velocity of the belt, which the direction keeps while it sticks
    relative: sp.Expr  # velocity relative to the belt
    kinetic: sp.Expr  # coefficient of friction
    static: sp.Expr  # coefficient of friction
    falling: sp.Expr  # slope by which the kinetic force falls with the relative velocity
    load: sp.Expr  # normal load, affine in the state
    lifts: bool  # whether the load may vanish where the contact is pressed
    bearer: int | None  # index of the soft stop whose push is the load
    exhausts: bool  # whether the kinetic force may fall to zero under a positive load
    holding: str = "stick"
    outcomes: tuple[str, ...] = ("slip", "stick", "overshoot")

    @property
    def regimes(self) -> tuple[str, ...]:
        """All regimes; a contact at rest takes one of the first three."""
        exhausted = ("exhausted-slip", "exhausted-overshoot") if self.exhausts else ()
        return (*self.outcomes, *exhausted, *(("lifted",) if self.loses_load else ()))

    @property
    def loses_load(self) -> bool:
        """Whether the normal load vanishes in some states."""
        return self.lifts or self.bearer is not None

    @property
    def limit(self) -> sp.Expr:
        """Largest force that the contact holds while it sticks."""
        return self.static * self.load

    def sliding(self, relative: sp.Expr, load: sp.Expr) -> dict[str, sp.Expr]:
        """Regimes in which a contact slides under a load, each with a function of the state.

        The first regime whose function is positive applies; the contact is at rest if none is.
        """
        kinetic, slope = self.kinetic * load, self.falling * relative
        exhausted = {"exhausted-slip": -kinetic - slope, "exhausted-overshoot": slope - kinetic}
        return (exhausted if self.exhausts else {}) | {"slip": -relative, "overshoot": relative}

    def force(self, regime: str) -> sp.Expr | None:
        """Kinetic force on the oscillator along the direction; None in a regime without one."""
        kinetic, slope = self.kinetic * self.load, self.falling * self.relative
        return {"slip": kinetic + slope, "overshoot": slope - kinetic}.get(regime)

    def slides(self, regime: str) -> int:
        """Sign of the relative velocity in a regime; 0 where it sticks or is lifted."""
        side = regime.removeprefix("exhausted-")
        return -1 if side == "slip" else 1 if side == "overshoot" else 0

    def losses(self, regime: str) -> tuple[Boundary, ...]:
        """Boundaries at which the force of a contact that does not stick ends or returns."""
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
        """Names of the boundaries at which a relative velocity or a limit of force is reached."""
        if regime == "stick":
            return (f"{self.name}-breaks-forward", f"{self.name}-breaks-backward")
        return (f"{self.name}-reaches-belt",)


@dataclass(frozen=True, eq=False)
class StopPart:
    """A rigid stop; its direction points into the stop."""

    name: str
    direction: sp.Matrix  # 1 x n
    gap: sp.Expr  # position along the direction, less that of the stop: negative in front of it
    approach: sp.Expr  # velocity along the direction
    restitution: sp.Expr
    sign: int  # 1 or -1: that of the direction relative to the declared one
    speed: sp.Expr = sp.S.Zero  # velocity of the direction in contact
    regimes: tuple[str, ...] = ("free", "contact")
    holding: str = "contact"
    outcomes: tuple[str, ...] = ("free", "contact")

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
        return (f"{self.name}-{'reaches' if regime == 'free' else 'leaves'}-stop",)


Part = SwitchPart | FrictionPart | StopPart


def exit_of(part: SwitchPart, regime: str, boundary: str) -> Exit:
    """The exit of a part's regime through the boundary of that name."""
    return next(e for e in part.exits[regime] if e.boundary.name == boundary)
