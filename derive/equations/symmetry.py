"""Orbits that a reversor maps to themselves: conditions halfway through each phase.

A reversor R, affine with R R = 1, turns a motion y(t) into the motion R y(-t). A phase that
passes through the set of fixed points of R halfway is its own reversal: it ends at the
image of its start. The chain Z0 -> R Z0 -> reset -> ... then needs no flow over whole
phases, and contains each condition once, where Z(tau) = R Z0 contains it twice.

What is left of the exit conditions and of the closure are conditions on the start alone.
Most hold identically; one that is a multiple of a coordinate makes it zero, one that is a
multiple of a coordinate by an expression in a single parameter requires a value of it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import derived_time, name_functions
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.section import Section, reset_matrix
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol

__all__ = [
    "HalfPhases",
    "end_conditions",
    "half_phases",
    "halfway",
    "phase_starts",
    "required_values",
    "reversor_of",
    "vanishing_coordinates",
]


@dataclass(frozen=True)
class HalfPhases:
    """Equations of an orbit that its reversor maps to itself."""

    stages: tuple[Stage, ...]  # values of the flows' functions halfway through the phases
    # (meaning, expression), affine in the coordinates of the start
    equations: tuple[tuple[str, sp.Expr], ...]


def half_phases(
    itinerary: Itinerary, system: System, flows: Mapping[str, Flow], start: Section
) -> HalfPhases:
    """Conditions halfway through each phase, and those that remain at the ends of phases.

    DerivationError refuses a map that does not reverse some configuration.
    """
    jump, shift = reversor_of(itinerary, system)
    fixed, _ = sp.Matrix.hstack(jump - sp.eye(jump.rows), shift).rref()
    stages: list[Stage] = []
    equations: list[tuple[str, sp.Expr]] = []
    for index, (phase, state) in enumerate(
        zip(itinerary.phases, phase_starts(itinerary, system, start), strict=True)
    ):
        flow, dwell = flows[phase.configuration], dwell_symbol(phase.dwell_time)
        _check_reversible(itinerary, flow, jump, shift)
        half = halfway(dwell)
        naming, functions = name_functions(flow, half)
        stages += [
            derived_time(dwell, itinerary.duration(index)),
            Stage(f"half of {dwell}", ((half, dwell / 2),)),
            naming,
        ]
        middle = flow.matrix(functions) * state + flow.offset(functions)
        for row in range(fixed.rows):
            normal, constant = fixed[row, :-1], fixed[row, -1]
            if normal.is_zero_matrix:
                continue
            names = [str(s) for s, n in zip(system.states, normal, strict=True) if n != 0]
            what = f"{names[0]} vanishes" if len(names) == 1 and not constant else "R y = y"
            condition = _by_function((normal * middle)[0] + constant, functions)
            equations.append((f"{what} halfway through {phase.configuration}", condition))
    ends = end_conditions(itinerary, system, start)
    equations += [(meaning, condition) for meaning, condition in ends if condition != 0]
    return HalfPhases(tuple(s for s in stages if s.assignments), tuple(equations))


def required_values(
    itinerary: Itinerary, system: System, start: Section
) -> dict[sp.Symbol, sp.Expr]:
    """Values by parameter without which no orbit is its own reversal."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for _, condition in end_conditions(itinerary, system, start):
        coordinate, factor = _multiple(condition, start.coordinates)
        if coordinate is not None and len(factor.free_symbols) == 1:
            (parameter,) = factor.free_symbols
            values = sp.solve(factor, parameter)
            if len(values) == 1 and values[0].is_number:
                found[parameter] = values[0]
    return found


def vanishing_coordinates(
    itinerary: Itinerary, system: System, start: Section
) -> tuple[sp.Symbol, ...]:
    """Coordinates of the start that the closure of the orbit makes zero."""
    found = []
    for _, condition in end_conditions(itinerary, system, start):
        coordinate, factor = _multiple(condition, start.coordinates)
        if coordinate is not None and factor.is_number:
            found.append(coordinate)
    return tuple(dict.fromkeys(found))


def halfway(dwell: sp.Symbol) -> sp.Symbol:
    """Symbol of half a dwell time."""
    return Symbol("half", dwell, positive=True)


def _by_function(expression: sp.Expr, functions: Sequence[sp.Expr]) -> sp.Expr:
    """A sum over the functions of time, with factored coefficients."""
    moving = [f for f in functions if f.is_Symbol]
    collected = sp.collect(sp.expand(expression), moving, evaluate=False)
    return sp.Add(*(f * factor(cancel(c)) for f, c in collected.items()))


def phase_starts(itinerary: Itinerary, system: System, start: Section) -> list[sp.Matrix]:
    """State (N x 1) at the start of each phase, whose end is the image of its start."""
    jump, shift = reversor_of(itinerary, system)
    states = [sp.Matrix(start.state)]
    for index in range(len(itinerary.phases) - 1):
        transition = itinerary.transition_after(system, index)
        states.append(transition.reset_of(jump * states[-1] + shift, system.states))
    return states


def end_conditions(
    itinerary: Itinerary, system: System, start: Section
) -> list[tuple[str, sp.Expr]]:
    """Exit conditions and closure of the reflected states, in the coordinates of the start."""
    jump, shift = reversor_of(itinerary, system)
    ends = [jump * state + shift for state in phase_starts(itinerary, system, start)]
    conditions = []
    for phase, end in zip(itinerary.phases, ends, strict=True):
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        row, constant = system.gradient(boundary.function)
        conditions.append(
            (f"{phase.boundary} ends {phase.configuration}", (row * end)[0] + constant)
        )
    image = itinerary.transition_after(system, -1).reset_of(ends[-1], system.states)
    for coordinate, place in zip(start.coordinates, start.places, strict=True):
        conditions.append((f"{coordinate} returns", image[place] - coordinate))
    return [(meaning, factor(sp.expand(condition))) for meaning, condition in conditions]


def _multiple(
    condition: sp.Expr, coordinates: Sequence[sp.Symbol]
) -> tuple[sp.Symbol | None, sp.Expr]:
    """The coordinate of which a condition is a multiple, and the factor.

    If there is none, None and the condition itself.
    """
    for coordinate in coordinates:
        factor = sp.diff(condition, coordinate)
        if factor != 0 and sp.expand(condition - factor * coordinate) == 0:
            return coordinate, factor
    return None, condition


def reversor_of(itinerary: Itinerary, system: System) -> tuple[sp.Matrix, sp.Matrix]:
    """Matrix and shift of an itinerary's reversor ``y -> R y + r``.

    DerivationError refuses one that is no involution.
    """
    jump, shift = reset_matrix(itinerary.reversor.items(), system.states)
    again = sp.Matrix.hstack(jump * jump - sp.eye(jump.rows), jump * shift + shift)
    if not again.applyfunc(sp.expand).is_zero_matrix:
        raise DerivationError(f"itinerary {itinerary.name!r}: its reversor is no involution")
    return jump, shift


def _check_reversible(itinerary: Itinerary, flow: Flow, jump: sp.Matrix, shift: sp.Matrix) -> None:
    matrix, offset = flow.field
    turned = sp.Matrix.hstack(
        jump * matrix * jump + matrix, jump * (matrix * shift + offset) + offset
    )
    if not turned.applyfunc(cancel).is_zero_matrix:
        raise DerivationError(
            f"itinerary {itinerary.name!r}: configuration {flow.configuration!r} is not"
            " reversed by the map that is declared as its reversor"
        )
