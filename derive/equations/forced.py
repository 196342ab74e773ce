"""Reduction of a forced orbit: all but the forcing's own equations is linear in its start.

The period is that of the forcing, which makes the last dwell time explicit. Given the others,
switching and closure are affine in the coordinates of the start, those of the forcing among
them. They are solved for all coordinates but one, a velocity where there is one, and what is
left is that the forcing's amplitude is one: of an orbit of one phase a quadratic equation, whose
coefficients depend on the parameters alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.affine import affine_conditions
from nonsmooth.derive.equations.chain import Chain, derived_time
from nonsmooth.derive.equations.elimination import eliminate_coordinates
from nonsmooth.derive.equations.forcing import PERIODS
from nonsmooth.derive.equations.reduction import Elimination, Reduction
from nonsmooth.derive.equations.section import smallest_section
from nonsmooth.derive.flows.modal import Spectrum

__all__ = ["reduce_forced"]


def reduce_forced(
    itinerary: Itinerary,
    system: System,
    chain: Chain,
    known: Mapping[sp.Symbol, sp.Expr],
    spectrum: Spectrum,
) -> Reduction:
    """The reduction of a forced orbit; see the module's description."""
    forcing, start = chain.forcing, chain.start
    assert forcing is not None
    *others, last = (link.dwell for link in chain.links)
    complete = derived_time(last, forcing.period - sp.Add(*others))
    stages, equations = affine_conditions(itinerary, system, chain)
    parameters = [p.symbol for p in system.parameters]
    order = sorted(start.coordinates, key=_preference(system, chain))
    return eliminate_coordinates(
        [complete, *stages],
        equations,
        order,
        others,
        {*parameters, *spectrum.symbols},
        known,
        smallest_section(itinerary, system)[1].dimension - len(forcing.states) + 1,
        forcing.conditions(start.state),
        [Elimination(last, PERIODS)],
    )


def _preference(system: System, chain: Chain) -> Callable[[sp.Symbol], int]:
    """Key by which coordinates are sorted: velocities, other states, those of a forcing last."""
    matrix, offset = chain.links[0].flow.field
    rates = matrix * sp.Matrix(system.states) + offset
    forced: Sequence[int] = chain.forcing.states if chain.forcing else ()
    velocities = {system.states.index(rate) for rate in rates if rate in system.states}
    places = dict(zip(chain.start.coordinates, chain.start.places, strict=True))

    def rank(coordinate: sp.Symbol) -> int:
        place = places[coordinate]
        return 2 if place in forced else 0 if place in velocities else 1

    return rank
