"""Systems that do not change along some direction of their states, as a rotor along its angle."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.system import System

__all__ = ["moves_freely"]


def moves_freely(system: System) -> bool:
    """Whether y + s d is a motion when y is, for some direction d, whatever the parameters.

    No field, boundary, constraint or condition depends on s, and resets carry it along. It is
    decided at one point of the parameters, with numbers that fulfil no relation by accident.
    """
    states = sp.Matrix(system.states)
    functions = [b.function for c in system.configurations for b in c.boundaries]
    functions += [row for c in system.configurations for row in c.constraints]
    functions += [c.function for t in system.transitions for c in t.conditions]
    matrices = [c.dynamics.field(system.states)[0] for c in system.configurations]
    matrices += [system.gradient(function)[0] for function in functions]
    for transition in system.transitions:
        moved = transition.reset_of(states, system.states)
        matrices.append(moved.jacobian(states) - sp.eye(len(states)))
    symbols = sorted({s for m in matrices for s in m.free_symbols}, key=str)
    values = {s: sp.Rational(sp.prime(40 + 3 * k), 97 + k) for k, s in enumerate(symbols)}
    numbers = sp.Matrix.vstack(*(m.subs(values) for m in matrices))
    return bool(DomainMatrix.from_Matrix(numbers).to_field().rank() < len(states))
