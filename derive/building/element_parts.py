"""Elements made into parts: their names resolved, and what they are told checked."""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatch

import sympy as sp

from nonsmooth.derive.building.elements import (
    ELEMENTS,
    Element,
    Friction,
    Regions,
    RigidStop,
    Slider,
    SoftStop,
    Terms,
)
from nonsmooth.derive.building.frame import Frame
from nonsmooth.derive.building.parts import Exit, FrictionPart, Part, StopPart, SwitchPart
from nonsmooth.derive.declaration.configuration import Boundary
from nonsmooth.derive.declaration.parameter import is_rational
from nonsmooth.derive.errors import DeclarationError


@singledispatch
def part_of(element: Element, frame: Frame, elements: Sequence[Element]) -> Part:
    """The part of an element; each class of elements registers the function that makes it.

    `elements` are all of the oscillator, because one may bear the normal load of another.
    DeclarationError refuses names and functions that do not fit, and an element whose class
    is not registered.
    """
    raise DeclarationError(f"{element!r} is no element of an oscillator")


@singledispatch
def states_of(element: Element) -> tuple[sp.Symbol, ...]:
    """The states that an element adds to those of the oscillator: none, unless registered."""
    return ()


@states_of.register
def _slider_states(slider: Slider) -> tuple[sp.Symbol, ...]:
    return (sp.Symbol(f"s_{slider.name.replace('-', '_')}", real=True),)


def constraints_of(frame: Frame, parts: Sequence[Part]) -> tuple[sp.Expr, ...]:
    """Expressions of the parameters that must not be negative but may be so on their domains.

    DeclarationError refuses one that is negative on the whole domain, that is no rational
    function, or that depends on the state.
    """
    found = dict[sp.Expr, None]()
    for part in parts:
        for what, value in part.needed.items():
            where, value = f"element {part.name!r}: {what}", sp.expand(value)
            if value.free_symbols & set(frame.states):
                raise DeclarationError(f"{where} depends on the state")
            sign = frame.sign(value)
            if sign == -1:
                raise DeclarationError(f"{where} is negative: {value}")
            if sign is None and not value.is_nonnegative:
                if not is_rational(value):
                    raise DeclarationError(
                        f"{where} is {value}, of unknown sign: make it a parameter of its own"
                    )
                found[value] = None
    return tuple(found)


def _into(element: RigidStop | SoftStop, frame: Frame) -> tuple[int, sp.Matrix, sp.Expr, sp.Expr]:
    """Sign and row (1 x n) of the direction into a stop, penetration, and its rate."""
    sign = 1 if element.side == "upper" else -1
    row = sign * frame.row(element.coordinate, f"element {element.name!r}")
    gap = frame.position(row) - sign * frame.expression(element.at)
    return sign, row, gap, frame.velocity(row)


@part_of.register
def _rigid_stop(element: RigidStop, frame: Frame, elements: Sequence[Element]) -> StopPart:
    sign, row, gap, approach = _into(element, frame)
    restitution, needed = frame.expression(element.restitution), {}
    if all(p.symbol != restitution or p.upper > 1 for p in frame.parameters):
        needed = {"restitution": restitution, "what restitution leaves of 1": 1 - restitution}
    return StopPart(element.name, row, gap, approach, restitution, sign, needed)


def _push(element: SoftStop, frame: Frame) -> sp.Expr:
    """Force of a soft stop in contact, positive against the direction into it."""
    _, _, gap, approach = _into(element, frame)
    return frame.expression(element.stiffness) * gap + frame.expression(element.damping) * approach


@part_of.register
def _soft_stop(element: SoftStop, frame: Frame, elements: Sequence[Element]) -> SwitchPart:
    sign, row, gap, _ = _into(element, frame)
    name, push = element.name, _push(element, frame)
    stiffness, damping = map(frame.expression, (element.stiffness, element.damping))
    reaches = Exit(Boundary(f"{name}-reaches-stop", gap), "contact")
    exits: dict[str, tuple[Exit, ...]] = {"free": (reaches,)}
    if element.released == "gap":
        exits["contact"] = (Exit(Boundary(f"{name}-leaves-stop", -gap), "free"),)
    else:
        if frame.sign(damping) not in (1, -1):
            raise DeclarationError(
                f"element {name!r}: its damping {damping} may be zero, and its force then vanishes"
                " as the gap opens: make it a parameter whose domain leaves out 0, or take"
                " released='gap'"
            )
        exits["contact"] = (Exit(Boundary(f"{name}-leaves-stop", -push), "released"),)
        exits["released"] = (
            Exit(Boundary(f"{name}-opens", -gap), "free"),
            Exit(Boundary(f"{name}-meets-again", push), "contact"),
        )
    return SwitchPart(
        name,
        {"contact": -push * row.T},
        exits,
        sign * row,
        {"contact": -sign * push},
        "stop",
        needed={"stiffness": stiffness, "damping": damping},
    )


@part_of.register
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
    """Normal load of a contact, whether it may vanish, and the index of what bears it.

    The load of a contact that a soft stop bears is the push of that stop; whether it may
    vanish concerns the time in which the stop is in contact. The index is None without such
    a stop.
    """
    where, normal = f"element {element.name!r}", element.normal
    if isinstance(normal, (str, *ELEMENTS)):
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


@part_of.register
def _slider(element: Slider, frame: Frame, elements: Sequence[Element]) -> SwitchPart:
    row = frame.row(element.coordinate, f"element {element.name!r}")
    stiffness, limit = map(frame.expression, (element.stiffness, element.limit))
    (state,), position, velocity = states_of(element), frame.position(row), frame.velocity(row)
    spring, name = stiffness * (position - state), element.name
    turns = f"{name}-turns"
    return SwitchPart(
        name,
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
        {"stiffness": stiffness, "limit": limit},
    )


@part_of.register
def _regions(element: Regions, frame: Frame, elements: Sequence[Element]) -> SwitchPart:
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
        {"below": forces(element.below, "below"), "above": forces(element.above, "above")},
        {
            "below": (Exit(Boundary(f"{element.name}-rises", function), "above"),),
            "above": (Exit(Boundary(f"{element.name}-falls", -function), "below"),),
        },
    )
