"""The energy of an orbit's configurations: a first integral, if every transition keeps it.

A closure then follows from the others, and is left out of the equations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import Chain
from nonsmooth.derive.equations.program import Equation
from nonsmooth.derive.equations.section import passages_of
from nonsmooth.derive.errors import DerivationError

__all__ = ["energy_of", "is_conservative", "without_redundant"]


def energy_of(dynamics: Dynamics, states: tuple[sp.Symbol, ...]) -> sp.Expr | None:
    """Energy, up to a constant, of an undamped motion with symmetric matrices; else None."""
    if not isinstance(dynamics, SecondOrder) or dynamics.held:
        return None
    symmetric = dynamics.mass.is_symmetric() and dynamics.stiffness.is_symmetric()
    if not (symmetric and dynamics.damping.is_zero_matrix):
        return None
    size = dynamics.mass.rows
    x, v = sp.Matrix(states[:size]), sp.Matrix(states[size:])
    kinetic, elastic = v.T * dynamics.mass * v, x.T * dynamics.stiffness * x
    return (kinetic[0] + elastic[0]) / 2 - (dynamics.load.T * x)[0]


def is_conservative(itinerary: Itinerary) -> bool:
    """Whether energy is a first integral along the phases and transitions of an itinerary.

    At a transition the energies before and behind may differ by a constant, as each is
    defined up to one.
    """
    passages, states = passages_of(itinerary), itinerary.presented_system.states
    energies = [energy_of(passage.configuration.dynamics, states) for passage in passages]
    for index, passage in enumerate(passages, start=-len(passages)):
        before, behind = energies[index], energies[index + 1]
        if before is None or behind is None:
            return False
        boundary = passage.value(sp.Matrix(states))
        fixed = next(s for s in states if sp.diff(boundary, s) != 0)
        on_boundary = {fixed: sp.solve(boundary, fixed)[0]}
        image = passage.behind(sp.Matrix(states))
        after = behind.subs(dict(zip(states, image, strict=True)), simultaneous=True)
        change = cancel(sp.expand((after - before).subs(on_boundary)))
        if change.free_symbols & set(states):
            return False
    return True


def without_redundant(
    itinerary: Itinerary,
    chain: Chain,
    equations: Sequence[Equation],
    known: Mapping[sp.Symbol, sp.Expr],
) -> tuple[Equation, ...]:
    """The equations without the closure that the first integral E makes redundant.

    It is the closure of the coordinate q with the largest |dE/dq| at the known point: the
    others would leave q undetermined to first order.
    """
    first = chain.links[0]
    energy = energy_of(first.configuration.dynamics, first.states)
    assert energy is not None  # it is a first integral
    at_start = energy.subs(dict(zip(first.states, chain.start.state, strict=True)))
    slopes = [abs(sp.diff(at_start, q).subs(known)) for q in chain.start.coordinates]
    if not all(slope.is_number for slope in slopes):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: a conservative orbit of given period needs a"
            " reference with values of all its parameters and unknowns"
        )
    dropped = len(chain.links) + slopes.index(max(slopes))
    return (*equations[:dropped], *equations[dropped + 1 :])
