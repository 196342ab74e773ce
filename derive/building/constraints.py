"""What the laws of the elements need of the parameters, where their domains leave it open."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import singledispatch

import sympy as sp

from nonsmooth.derive.building.elements import Element, Friction, RigidStop, Slider, SoftStop
from nonsmooth.derive.building.frame import Frame
from nonsmooth.derive.building.parts import FrictionPart, Part
from nonsmooth.derive.declaration.parameter import is_rational
from nonsmooth.derive.errors import DeclarationError

__all__ = ["constraints_of", "needed_of"]


def constraints_of(
    frame: Frame, elements: Sequence[Element], parts: Sequence[Part]
) -> tuple[sp.Expr, ...]:
    """Expressions of the parameters that must not be negative but may be so on their domains.

    DeclarationError refuses one that is negative on the whole domain, that is no rational
    function, or that depends on the state.
    """
    found = dict[sp.Expr, None]()
    for element, part in zip(elements, parts, strict=True):
        for what, value in needed_of(element, part, frame):
            value = sp.expand(value)
            if value.free_symbols & set(frame.states):
                raise DeclarationError(f"element {element.name!r}: {what} depends on the state")
            sign = frame.sign(value)
            if sign == -1:
                raise DeclarationError(f"element {element.name!r}: {what} is negative: {value}")
            if sign is None and not value.is_nonnegative:
                if not is_rational(value):
                    raise DeclarationError(
                        f"element {element.name!r}: {what} is {value}, of unknown sign: make it a"
                        " parameter of its own"
                    )
                found[value] = None
    return tuple(found)


@singledispatch
def needed_of(element: Element, part: Part, frame: Frame) -> Iterable[tuple[str, sp.Expr]]:
    """Quantities of an element that must not be negative: name and expression of each.

    There are none unless a function is registered for the element's class.
    """
    return ()


@needed_of.register
def _friction(element: Friction, part: FrictionPart, frame: Frame) -> Iterator[tuple[str, sp.Expr]]:
    yield "kinetic friction", part.kinetic
    yield "static friction less the kinetic", part.static - part.kinetic
    if part.exhausts:
        yield "the slope of falling friction", part.falling
    if not part.loses_load:
        yield "the normal load", part.load


@needed_of.register
def _soft_stop(element: SoftStop, part: Part, frame: Frame) -> Iterator[tuple[str, sp.Expr]]:
    yield "stiffness", frame.expression(element.stiffness)
    yield "damping", frame.expression(element.damping)


@needed_of.register
def _slider(element: Slider, part: Part, frame: Frame) -> Iterator[tuple[str, sp.Expr]]:
    yield "stiffness", frame.expression(element.stiffness)
    yield "limit", frame.expression(element.limit)


@needed_of.register
def _rigid_stop(element: RigidStop, part: Part, frame: Frame) -> Iterator[tuple[str, sp.Expr]]:
    restitution = frame.expression(element.restitution)
    if all(p.symbol != restitution or p.upper > 1 for p in frame.parameters):
        yield "restitution", restitution
        yield "what restitution leaves of 1", 1 - restitution
