"""The elements as parts: local regimes, their forces, and the boundaries between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary
from nonsmooth.derive.symbols import Values

# functions of the state that are not positive in a regime, and those that vanish in it
Conditions = tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]


@dataclass(frozen=True)
class Exit:
    """A boundary of a regime, with the regime behind it and the reset of the state."""

    boundary: Boundary
    target: str
    reset: Values = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class SwitchPart:
    """A part whose regimes follow each other independently of the other parts."""

    name: str
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
    # what must not be negative, by the words for it: expressions of the parameters
    needed: Mapping[str, sp.Expr] = field(default_factory=dict)
    sign: ClassVar[int] = 1
    speed: ClassVar[sp.Expr] = sp.S.Zero

    @property
    def regimes(self) -> tuple[str, ...]:
        """All regimes."""
        return tuple(self.exits)

    def push(self, regime: str) -> sp.Expr | None:
        """Force on the oscillator along the direction; None in a regime without one."""
        return self.pushes.get(regime)

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
        return tuple(exit_.boundary.name for exit_ in self.exits[regime])

    def conditions(self, regime: str) -> Conditions:
        """What tells that a state belongs to a regime."""
        vanishing = (self.constraints[regime],) if regime in self.constraints else ()
        return tuple(exit_.boundary.function for exit_ in self.exits[regime]), vanishing


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
    holding: ClassVar[str] = "stick"
    outcomes: ClassVar[tuple[str, ...]] = ("slip", "stick", "overshoot")
    kind: ClassVar[str] = "friction"
    sign: ClassVar[int] = 1

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

    def push(self, regime: str) -> sp.Expr | None:
        """Kinetic force on the oscillator along the direction; None in a regime without one."""
        kinetic, slope = self.kinetic * self.load, self.falling * self.relative
        return {"slip": kinetic + slope, "overshoot": slope - kinetic}.get(regime)

    def slides(self, regime: str) -> int:
        """Sign of the relative velocity in a regime; 0 where it sticks or is lifted."""
        return {"slip": -1, "overshoot": 1}.get(regime.removeprefix("exhausted-"), 0)

    def losses(self, regime: str) -> tuple[Boundary, ...]:
        """Boundaries at which the force of a contact that does not stick ends or returns."""
        if regime == "stick":
            return ()
        if regime == "lifted":
            return (Boundary(f"{self.name}-lands", self.load),) if self.lifts else ()
        if self.exhausts and regime in self.outcomes:  # at or before the load is lost
            return self._exhaustion(regime)
        lifts = (Boundary(f"{self.name}-lifts", -self.load),) if self.lifts else ()
        return (*self._exhaustion(regime), *lifts)

    def _exhaustion(self, regime: str) -> tuple[Boundary, ...]:
        """The boundary at which the kinetic force vanishes, or returns."""
        if not (self.exhausts and self.slides(regime)):
            return ()
        functions = self.sliding(self.relative, self.load)
        if regime in self.outcomes:
            return (Boundary(f"{self.name}-exhausts", functions[f"exhausted-{regime}"]),)
        return (Boundary(f"{self.name}-recovers", -functions[regime]),)

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries at which a relative velocity or a limit of force is reached."""
        if regime == "stick":
            return (f"{self.name}-breaks-forward", f"{self.name}-breaks-backward")
        return (f"{self.name}-reaches-belt",) if regime in self.outcomes else ()

    def conditions(self, regime: str) -> Conditions:
        """What tells that a state belongs to a regime."""
        if regime == "lifted":
            return tuple(boundary.function for boundary in self.losses(regime)), ()
        pressed = (-self.load,) if self.lifts else ()
        if regime == "stick":
            return pressed, (self.relative,)
        exhaustion = (boundary.function for boundary in self._exhaustion(regime))
        return (-self.slides(regime) * self.relative, *pressed, *exhaustion), ()

    @property
    def needed(self) -> dict[str, sp.Expr]:
        """What must not be negative, by the words for it."""
        found = {
            "kinetic friction": self.kinetic,
            "static friction less the kinetic": self.static - self.kinetic,
        }
        if self.exhausts:
            found["the slope of falling friction"] = self.falling
        if not self.loses_load:
            found["the normal load"] = self.load
        return found


@dataclass(frozen=True, eq=False)
class StopPart:
    """A rigid stop; its direction points into the stop."""

    name: str
    direction: sp.Matrix  # 1 x n
    gap: sp.Expr  # position along the direction, less that of the stop: negative in front of it
    approach: sp.Expr  # velocity along the direction
    restitution: sp.Expr
    sign: int  # 1 or -1: that of the direction relative to the declared one
    needed: Mapping[str, sp.Expr]  # what must not be negative, by the words for it
    speed: ClassVar[sp.Expr] = sp.S.Zero  # velocity of the direction in contact
    regimes: ClassVar[tuple[str, ...]] = ("free", "contact")
    holding: ClassVar[str] = "contact"
    outcomes: ClassVar[tuple[str, ...]] = ("free", "contact")
    kind: ClassVar[str] = "stop"

    def push(self, regime: str) -> sp.Expr | None:
        """None, as a stop pushes by its reaction alone."""
        return None

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
        return (f"{self.name}-{'reaches' if regime == 'free' else 'leaves'}-stop",)

    def conditions(self, regime: str) -> Conditions:
        """What tells that a state belongs to a regime."""
        return ((self.gap,), ()) if regime == "free" else ((), (self.gap, self.approach))


Holder = FrictionPart | StopPart
Part = SwitchPart | Holder
