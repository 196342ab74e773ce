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

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import bordered, cancel, factor
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import derived_time, name_functions
from nonsmooth.derive.equations.program import Equation, Stage, Stages, filled
from nonsmooth.derive.equations.section import Section, is_zero, map_of, passages_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol


def half_phases(
    itinerary: Itinerary, flows: Mapping[str, Flow], start: Section
) -> tuple[Stages, tuple[Equation, ...]]:
    """Stages, and conditions halfway through each phase with those that remain at its ends.

    The stages compute the flows' functions halfway; the conditions, as equations (meaning,
    expression), are affine in the coordinates of the start. DerivationError refuses a map that
    does not reverse some configuration.
    """
    jump, shift = reversor_of(itinerary)
    fixed, _ = sp.Matrix.hstack(jump - sp.eye(jump.rows), shift).rref()
    stages: list[Stage] = []
    equations: list[Equation] = []
    starts = phase_starts(itinerary, start)
    for passage, state in zip(passages_of(itinerary), starts, strict=True):
        flow, dwell = flows[passage.configuration.name], passage.dwell
        _check_reversible(itinerary, flow)
        half = halfway(dwell)
        naming, functions = name_functions(flow, half, half)
        stages += [
            derived_time(dwell, passage.duration),
            Stage(f"half of {dwell}", ((half, dwell / 2),)),
            naming,
        ]
        middle = flow.end(functions, state)
        for row in range(fixed.rows):
            normal, constant = fixed[row, :-1], fixed[row, -1]
            if normal.is_zero_matrix:
                continue
            names = [str(s) for s, n in zip(passage.states, normal, strict=True) if n != 0]
            what = f"{names[0]} vanishes" if len(names) == 1 and not constant else "R y = y"
            condition = _by_function((normal * middle)[0] + constant, functions)
            equations.append((f"{what} halfway through {flow.configuration}", condition))
    equations += [(m, e) for m, e in end_conditions(itinerary, start) if e != 0]
    return filled(stages), tuple(equations)


def required_values(itinerary: Itinerary, start: Section) -> dict[sp.Symbol, sp.Expr]:
    """Values by parameter without which no orbit is its own reversal."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for _, multiple in _multiples(itinerary, start):
        values = sp.solve(multiple) if len(multiple.free_symbols) == 1 else []
        if len(values) == 1 and values[0].is_number:
            found[multiple.free_symbols.pop()] = values[0]
    return found


def vanishing_coordinates(itinerary: Itinerary, start: Section) -> tuple[sp.Symbol, ...]:
    """Coordinates of the start that the closure of the orbit makes zero."""
    found = (q for q, multiple in _multiples(itinerary, start) if multiple.is_number)
    return tuple(dict.fromkeys(found))


def _multiples(itinerary: Itinerary, start: Section) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """Coordinate and factor of each condition at the ends of phases that is such a product."""
    for _, condition in end_conditions(itinerary, start):
        for coordinate in start.coordinates:
            multiple = sp.diff(condition, coordinate)
            if multiple != 0 and sp.expand(condition - multiple * coordinate) == 0:
                yield coordinate, multiple


def halfway(dwell: sp.Symbol) -> sp.Symbol:
    """Symbol of half a dwell time."""
    return Symbol("half", dwell, positive=True)


def _by_function(expression: sp.Expr, functions: Sequence[sp.Expr]) -> sp.Expr:
    """A sum over the functions of time, with factored coefficients."""
    moving = [f for f in functions if f.is_Symbol]
    collected = sp.collect(sp.expand(expression), moving, evaluate=False)
    return sp.Add(*(f * factor(cancel(c)) for f, c in collected.items()))


def phase_starts(itinerary: Itinerary, start: Section) -> list[sp.Matrix]:
    """State (N x 1) at the start of each phase, whose end is the image of its start."""
    jump, shift = reversor_of(itinerary)
    states = [sp.Matrix(start.state)]
    for passage in passages_of(itinerary)[:-1]:
        states.append(passage.behind(jump * states[-1] + shift))
    return states


def phase_ends(itinerary: Itinerary, start: Section) -> list[sp.Matrix]:
    """State (N x 1) at the end of each phase, the image of its start."""
    jump, shift = reversor_of(itinerary)
    return [jump * state + shift for state in phase_starts(itinerary, start)]


def end_conditions(itinerary: Itinerary, start: Section) -> list[Equation]:
    """Exit conditions and closure of the reflected states, in the coordinates of the start."""
    passages, ends = passages_of(itinerary), phase_ends(itinerary, start)
    conditions = [(p.meaning, p.value(end)) for p, end in zip(passages, ends, strict=True)]
    image = passages[-1].behind(ends[-1])
    for coordinate, place in zip(start.coordinates, start.places, strict=True):
        conditions.append((f"{coordinate} returns", image[place] - coordinate))
    return [(meaning, factor(sp.expand(condition))) for meaning, condition in conditions]


def reversor_of(itinerary: Itinerary) -> tuple[sp.Matrix, sp.Matrix]:
    """Matrix and shift of an itinerary's reversor ``y -> R y + r``.

    DerivationError refuses one that is no involution.
    """
    reversor = map_of(itinerary.reversor, itinerary.presented_system)
    if not is_zero(reversor**2 - sp.eye(reversor.rows)):
        raise DerivationError(f"itinerary {itinerary.name!r}: its reversor is no involution")
    return reversor[:-1, :-1], reversor[:-1, -1]


def _check_reversible(itinerary: Itinerary, flow: Flow) -> None:
    reversor, field = bordered(*reversor_of(itinerary)), bordered(*flow.field, 0)
    if not is_zero(reversor * field * reversor + field):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: configuration {flow.configuration!r} is not"
            " reversed by the map that is declared as its reversor"
        )
