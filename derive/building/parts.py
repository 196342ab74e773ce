"""The elements as parts: local regimes, their forces, and the boundaries between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from nonsmooth.derive.building.elements import (
    Element,
    Friction,
    Regions,
    RigidStop,
    Slider,
    SoftStop,
    Terms,
)
from nonsmooth.derive.building.frame import Frame
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.system import Boundary

__all__ = [
    "Exit",
    "FrictionPart",
    "Part",
    "StopPart",
    "SwitchPart",
    "exit_of",
    "part_of",
    "slider_state",
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


def part_of(element: Element, frame: Frame, elements: Sequence[Element]) -> Part:
    """The part of an element; DeclarationError for names or functions that do not fit.

    `elements` are all of the oscillator: one may bear the normal load of another.
    """
    match element:
        case RigidStop():
            return _rigid_stop(element, frame)
        case SoftStop():
            return _soft_stop(element, frame)
        case Friction():
            return _friction(element, frame, elements)
        case Slider():
            return _slider(element, frame)
        case Regions():
            return _regions(element, frame)


def slider_state(slider: Slider) -> sp.Symbol:
    """Symbol of a slider's position."""
    return sp.Symbol(f"s_{slider.name.replace('-', '_')}", real=True)


def _into(element: RigidStop | SoftStop, frame: Frame) -> tuple[int, sp.Matrix, sp.Expr, sp.Expr]:
    """Sign and row of the direction into a stop, penetration and its rate."""
    sign = 1 if element.side == "upper" else -1
    row = sign * frame.row(element.coordinate, f"element {element.name!r}")
    gap = frame.position(row) - sign * frame.expression(element.at)
    return sign, row, gap, frame.velocity(row)


def _rigid_stop(element: RigidStop, frame: Frame) -> StopPart:
    sign, row, gap, approach = _into(element, frame)
    restitution = frame.expression(element.restitution)
    return StopPart(element.name, row, gap, approach, restitution, sign)


def _push(element: SoftStop, frame: Frame) -> sp.Expr:
    """Force of a soft stop in contact, against the direction into it."""
    _, _, gap, approach = _into(element, frame)
    return frame.expression(element.stiffness) * gap + frame.expression(element.damping) * approach


def _soft_stop(element: SoftStop, frame: Frame) -> SwitchPart:
    sign, row, gap, _ = _into(element, frame)
    name, push = element.name, _push(element, frame)
    reaches = Exit(Boundary(f"{name}-reaches-stop", gap), "contact")
    exits: dict[str, tuple[Exit, ...]] = {"free": (reaches,)}
    if element.released == "gap":
        exits["contact"] = (Exit(Boundary(f"{name}-leaves-stop", -gap), "free"),)
    else:
        exits["contact"] = (Exit(Boundary(f"{name}-leaves-stop", -push), "released"),)
        exits["released"] = (
            Exit(Boundary(f"{name}-opens", -gap), "free"),
            Exit(Boundary(f"{name}-meets-again", push), "contact"),
        )
    return SwitchPart(
        name,
        tuple(exits),
        {"contact": -push * row.T},
        exits,
        sign * row,
        {"contact": -sign * push},
        "stop",
    )


def _friction(element: Friction, frame: Frame, elements: Sequence[Element]) -> FrictionPart:
    where = f"element {element.name!r}"
    row = frame.row(element.coordinate, where)
    given = (element.velocity, element.kinetic, element.static, element.falling)
    speed, kinetic, static, falling = map(frame.expression, given)
    for what, value in (
        ("the velocity of the belt", speed),
        ("kinetic friction", kinetic),
        ("static friction", static),
        ("the slope of falling friction", falling),
    ):
        if value.free_symbols & set(frame.states):
            raise DeclarationError(
                f"{where}: {what} depends on the state, as the normal load alone may"
            )
    load, lifts, bearer = _load(element, frame, elements)
    exhausts = not (falling.is_nonpositive or frame.sign(falling) == -1)
    if exhausts and kinetic == 0:
        raise DeclarationError(f"{where}: kinetic friction is zero, it cannot fall")
    return FrictionPart(
        element.name,
        row,
        speed,
        frame.velocity(row) - speed,
        kinetic,
        static,
        falling,
        load,
        lifts,
        bearer,
        exhausts,
    )


def _load(
    element: Friction, frame: Frame, elements: Sequence[Element]
) -> tuple[sp.Expr, bool, int | None]:
    """Normal load of a contact, whether it may vanish while it is pressed, and what bears it."""
    where, normal = f"element {element.name!r}", element.normal
    if isinstance(normal, str | RigidStop | SoftStop | Slider | Friction | Regions):
        name = normal if isinstance(normal, str) else normal.name
        bearer = next((i for i, e in enumerate(elements) if e.name == name), None)
        stop = None if bearer is None else elements[bearer]
        if isinstance(stop, RigidStop):
            raise DeclarationError(
                f"{where}: the reaction of the rigid stop {name!r} is no normal load, its impacts"
                " would be impulses of friction: use a SoftStop"
            )
        if not isinstance(stop, SoftStop) or normal not in (name, stop):
            known = ", ".join(e.name for e in elements if isinstance(e, SoftStop)) or "none"
            raise DeclarationError(
                f"{where}: its normal load {name!r} is no soft stop of the oscillator"
                f" (known: {known})"
            )
        damped = frame.expression(stop.damping) != 0
        return _push(stop, frame), damped and stop.released == "gap", bearer
    load = frame.affine(normal, where)
    if load.free_symbols & set(frame.states):
        return load, True, None
    if frame.sign(load) in (0, -1):
        raise DeclarationError(f"{where}: its normal load {load} is not positive")
    return load, False, None


def _slider(element: Slider, frame: Frame) -> SwitchPart:
    row = frame.row(element.coordinate, f"element {element.name!r}")
    stiffness, limit = frame.expression(element.stiffness), frame.expression(element.limit)
    state, velocity = slider_state(element), frame.velocity(row)
    position = frame.position(row)
    spring, name = stiffness * (position - state), element.name
    turns = f"{name}-turns"
    return SwitchPart(
        name,
        ("stuck", "forward", "backward"),
        {"stuck": -spring * row.T, "forward": -limit * row.T, "backward": limit * row.T},
        {
            "stuck": (
                Exit(
                    Boundary(f"{name}-slides-forward", spring - limit),
                    "forward",
                    {state: position - limit / stiffness},
                ),
                Exit(
                    Boundary(f"{name}-slides-backward", -spring - limit),
                    "backward",
                    {state: position + limit / stiffness},
                ),
            ),
            "forward": (Exit(Boundary(turns, -velocity), "stuck"),),
            "backward": (Exit(Boundary(turns, velocity), "stuck"),),
        },
        row,
        {"stuck": -spring, "forward": -limit, "backward": limit},
        "slider",
        {"forward": (state, velocity), "backward": (state, velocity)},
        {"forward": spring - limit, "backward": spring + limit},
    )


def _regions(element: Regions, frame: Frame) -> SwitchPart:
    where = f"element {element.name!r}"
    function = frame.affine(element.function, where)
    if not function.free_symbols & set(frame.states):
        raise DeclarationError(f"{where}: {function} does not depend on the state")

    def forces(terms: Terms, side: str) -> sp.Matrix:
        what = f"{where}, {side}"
        positions, velocities = sp.Matrix(frame.positions), sp.Matrix(frame.velocities)
        return (
            frame.column(terms.load, f"{what}: load")
            - frame.matrix(terms.stiffness, f"{what}: stiffness") * positions
            - frame.matrix(terms.damping, f"{what}: damping") * velocities
        )

    return SwitchPart(
        element.name,
        ("below", "above"),
        {"below": forces(element.below, "below"), "above": forces(element.above, "above")},
        {
            "below": (Exit(Boundary(f"{element.name}-rises", function), "above"),),
            "above": (Exit(Boundary(f"{element.name}-falls", -function), "below"),),
        },
    )


def exit_of(part: SwitchPart, regime: str, boundary: str) -> Exit:
    """The exit of a regime through a boundary."""
    return next(e for e in part.exits[regime] if e.boundary.name == boundary)
