"""The energy of an orbit's configurations: a first integral, if every transition keeps it."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System

__all__ = ["energy_of", "is_conservative"]


def energy_of(dynamics: Dynamics, states: tuple[sp.Symbol, ...]) -> sp.Expr | None:
    """Energy, up to a constant, of an undamped motion with symmetric matrices; else None."""
    if not isinstance(dynamics, SecondOrder) or dynamics.held:
        return None
    if (
        not (_symmetric(dynamics.mass) and _symmetric(dynamics.stiffness))
        or not dynamics.damping.is_zero_matrix
    ):
        return None
    size = dynamics.mass.rows
    x, v = sp.Matrix(states[:size]), sp.Matrix(states[size:])
    kinetic, elastic = v.T * dynamics.mass * v, x.T * dynamics.stiffness * x
    return (kinetic[0] + elastic[0]) / 2 - (dynamics.load.T * x)[0]


def _symmetric(matrix: sp.Matrix) -> bool:
    return bool((matrix - matrix.T).applyfunc(cancel).is_zero_matrix)


def is_conservative(itinerary: Itinerary, system: System) -> bool:
    """Whether energy is a first integral along the phases and transitions of an itinerary.

    At a transition the energies before and behind may differ by a constant, as each is
    defined up to one.
    """
    states = system.states
    energies = [
        energy_of(system.configuration(p.configuration).dynamics, states) for p in itinerary.phases
    ]
    for index, phase in enumerate(itinerary.phases):
        before, behind = energies[index], energies[(index + 1) % len(energies)]
        if before is None or behind is None:
            return False
        boundary = system.configuration(phase.configuration).boundary(phase.boundary).function
        fixed = next(s for s in states if sp.diff(boundary, s) != 0)
        on_boundary = {fixed: sp.solve(boundary, fixed)[0]}
        image = itinerary.transition_after(system, index).reset_of(sp.Matrix(states), states)
        after = behind.subs(dict(zip(states, image, strict=True)), simultaneous=True)
        change = cancel(sp.expand((after - before).subs(on_boundary)))
        if change.free_symbols & set(states):
            return False
    return True
