"""The elements as parts: local regimes, their forces, and the boundaries between them."""

from __future__ import annotations

from collections.abc import Mapping
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
    """Dry friction along a direction: it slips, sticks, or overshoots.

    Attributes
    ----------
    name : str
    direction : 1 x n matrix
    speed : expression
        Velocity of the belt, which the direction keeps while it sticks.
    relative : expression
        Velocity relative to the belt.
    slipping, overshooting : expressions
        Kinetic forces on the oscillator along the direction.
    limit : expression
        What it can hold.
    """

    name: str
    direction: sp.Matrix
    speed: sp.Expr
    relative: sp.Expr
    slipping: sp.Expr
    overshooting: sp.Expr
    limit: sp.Expr
    regimes: tuple[str, ...] = ("slip", "stick", "overshoot")
    holding: str = "stick"

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
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

    def names(self, regime: str) -> tuple[str, ...]:
        """Names of the boundaries of a regime."""
        return (f"{self.name}-{'reaches' if regime == 'free' else 'leaves'}-stop",)


Part = SwitchPart | FrictionPart | StopPart


def part_of(element: Element, frame: Frame) -> Part:
    """The part of an element; DeclarationError for names or functions that do not fit."""
    match element:
        case RigidStop():
            return _rigid_stop(element, frame)
        case SoftStop():
            return _soft_stop(element, frame)
        case Friction():
            return _friction(element, frame)
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


def _soft_stop(element: SoftStop, frame: Frame) -> SwitchPart:
    sign, row, gap, approach = _into(element, frame)
    stiffness, damping = frame.expression(element.stiffness), frame.expression(element.damping)
    name, push = element.name, stiffness * gap + damping * approach
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


def _friction(element: Friction, frame: Frame) -> FrictionPart:
    where = f"element {element.name!r}"
    row = frame.row(element.coordinate, where)
    speed = frame.expression(element.velocity)
    if speed.free_symbols & set(frame.states):
        raise DeclarationError(f"{where}: the velocity of the belt depends on the state")
    relative = frame.velocity(row) - speed
    normal, falling = frame.expression(element.normal), frame.expression(element.falling)
    kinetic = frame.affine(frame.expression(element.kinetic) * normal, where)
    limit = frame.affine(frame.expression(element.static) * normal, where)
    return FrictionPart(
        element.name,
        row,
        speed,
        relative,
        kinetic + falling * relative,
        -kinetic + falling * relative,
        limit,
    )


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
