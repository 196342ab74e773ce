"""Systems that do not change along some direction of their states, as a rotor along its angle."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.declaration.system import System

__all__ = ["moves_freely", "translations"]


def translations(system: System) -> sp.Matrix:
    """Directions of the state along which nothing changes, as columns (N x k).

    Most systems have none. See `moves_freely`.
    """
    size = len(system.states)
    columns = _dependences(system).nullspace(simplify=True) if moves_freely(system) else []
    return sp.ImmutableMatrix.hstack(sp.zeros(size, 0), *columns)


def moves_freely(system: System) -> bool:
    """Whether y + s d is a motion when y is, for some direction d and all parameters.

    No field, boundary, constraint or condition depends on s, and resets carry it along. It
    is decided at one point of the parameters, with numbers that fulfil no relation by
    accident.
    """
    matrix = _dependences(system)
    symbols = sorted(matrix.free_symbols, key=str)
    values = {s: sp.Rational(sp.prime(40 + 3 * k), 97 + k) for k, s in enumerate(symbols)}
    numbers = DomainMatrix.from_Matrix(matrix.xreplace(values)).to_field()
    return bool(numbers.rank() < len(system.states))


def _dependences(system: System) -> sp.Matrix:
    """Rows (k, N) orthogonal to every direction along which nothing depends on the state."""
    functions = [b.function for c in system.configurations for b in c.boundaries]
    functions += [row for c in system.configurations for row in c.constraints]
    functions += [c.function for t in system.transitions for c in t.conditions]
    functions += [image - state for t in system.transitions for state, image in t.reset.items()]
    gradients = [system.gradient(function)[0] for function in dict.fromkeys(functions)]
    fields = [c.dynamics.field(system.states)[0] for c in system.configurations]
    rows = [tuple(row) for matrix in (*fields, *gradients) for row in matrix.tolist()]
    return sp.Matrix(list(dict.fromkeys(rows)))
