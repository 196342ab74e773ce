"""Switching and closure in the coordinates of the start: affine, given the dwell times."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import Chain, name_functions
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.reduction import affine_in

__all__ = ["affine_conditions"]

_Equation = tuple[str, sp.Expr]


def affine_conditions(
    itinerary: Itinerary, system: System, chain: Chain
) -> tuple[list[Stage], list[_Equation]]:
    """Stages, and the switching conditions and closures as equations (meaning, expression).

    They are affine in the coordinates of the start, with coefficients that are functions of
    the dwell times. The closure of a forcing is left out.
    """
    start, forced = chain.start, chain.forcing.states if chain.forcing else ()
    stages: list[Stage] = []
    equations: list[_Equation] = []
    state = start.state
    for index, (phase, link) in enumerate(zip(itinerary.phases, chain.links, strict=True)):
        naming, functions = name_functions(link.flow, link.dwell)
        after = link.flow.matrix(functions) * state + link.flow.offset(functions)
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        row, constant = system.gradient(boundary.function)
        condition = sp.expand((row * after)[0] + constant)
        equations.append((f"{phase.boundary} ends {phase.configuration}", condition))
        state = itinerary.transition_after(system, index).reset_of(after, system.states)
        stages.append(naming)
        if link is not chain.links[-1]:
            step, state = affine_in(start.coordinates, state.applyfunc(sp.expand), link.dwell)
            stages.append(step)
    for coordinate, place in zip(start.coordinates, start.places, strict=True):
        if place not in forced:
            equations.append((f"{coordinate} returns", sp.expand(state[place] - coordinate)))
    return [s for s in stages if s.assignments], equations
