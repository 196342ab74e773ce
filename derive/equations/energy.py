"""The energy of an orbit's configurations: a first integral, if every transition keeps it.

A closure then follows from the others, and is left out of the equations. Where transitions keep
volume too, the multipliers of two coordinates' orbits are 1, mu and 1/mu.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import Chain
from nonsmooth.derive.equations.program import Equation
from nonsmooth.derive.equations.section import Passage, passages_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import Values


@lru_cache(maxsize=64)
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
    energies = []
    for passage in passages:
        energy = energy_of(passage.configuration.dynamics, states)
        if energy is None:
            return False
        energies.append(energy)
    for index, passage in enumerate(passages, start=-len(passages)):
        before, behind = energies[index], energies[index + 1]
        image = passage.behind(sp.Matrix(states))
        after = behind.subs(dict(zip(states, image, strict=True)), simultaneous=True)
        change = cancel(sp.expand((after - before).subs(on_boundary(passage))))
        if change.free_symbols & set(states):
            return False
    return True


def keeps_volume(itinerary: Itinerary) -> bool:
    """Whether every transition keeps the volume of the states, as undamped flows do.

    The determinant of a saltation matrix S = R + (f+ - R f-) n / (n f-) is
    det R (n R^-1 f+) / (n f-), by the lemma on determinants of a matrix plus one of rank one.
    """
    passages = passages_of(itinerary)
    for passage, following in zip(passages, [*passages[1:], passages[0]], strict=True):
        factor = cancel(passage.reset.det())
        if factor == 0:
            return False
        state, jump = sp.Matrix([*passage.states, 1]), passage.landing
        before = (passage.row * passage.field * state)[0]
        behind = (passage.row * jump.inv() * following.field * jump * state)[0]
        change = sp.expand(factor * behind - before)
        if cancel(sp.expand(change.subs(on_boundary(passage)))) != 0:
            return False
    return True


def on_boundary(passage: Passage) -> dict[sp.Symbol, sp.Expr]:
    """A state by the others, where the boundary that ends a phase is reached."""
    boundary = passage.value(sp.Matrix(passage.states))
    fixed = next(s for s in passage.states if sp.diff(boundary, s) != 0)
    return {fixed: sp.solve(boundary, fixed)[0]}


def without_redundant(
    itinerary: Itinerary,
    chain: Chain,
    equations: Sequence[Equation],
    known: Values,
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
