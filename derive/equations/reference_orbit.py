"""The orbit that an itinerary's reference guesses, in numbers."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import sympy as sp

from nonsmooth.derive.equations.elimination import reference_values
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import evaluate

__all__ = ["ReferenceOrbit", "reference_orbit"]

_DIGITS = 30
_STEPS = 12


@dataclass(frozen=True)
class ReferenceOrbit:
    """An orbit in numbers of 30 digits."""

    unknowns: tuple[sp.Expr, ...]
    period: sp.Expr
    map: sp.Matrix  # Jacobian of the Poincare map
    multipliers: tuple[sp.Expr, ...]  # its eigenvalues, the largest first


def reference_orbit(equations: EquationSystem) -> ReferenceOrbit | None:
    """Solve an orbit's equations by Newton's method from its reference.

    None says that there is no reference, that it leaves something open, or that the method
    does not converge.
    """
    itinerary, unknowns = equations.itinerary, equations.unknowns
    parameters = [p.symbol for p in equations.system.parameters]
    known = reference_values(itinerary.reference, equations.spectrum, parameters)
    guess = itinerary.reference.guess if itinerary.reference else {}
    known |= {u: sp.Float(guess[str(u)], _DIGITS) for u in unknowns if str(u) in guess}
    if not {*unknowns, *equations.parameters} <= set(known):
        return None
    derivatives = equations.jacobian_program
    stages = (*equations.stages, *derivatives.stages)
    with mpmath.workdps(_DIGITS):
        for _ in range(_STEPS):
            flat = evaluate(stages, [*equations.residual, *derivatives.expressions], known, _DIGITS)
            if not all(number.is_real for number in flat):
                return None
            numbers = [mpmath.mpf(number) for number in flat]
            residual, size = mpmath.matrix(numbers[: len(unknowns)]), len(unknowns)
            rows = [numbers[i : i + size] for i in range(size, len(numbers), size)]
            try:
                step = mpmath.lu_solve(mpmath.matrix(rows), residual)
            except ZeroDivisionError:
                return None
            known |= {
                u: known[u] - sp.Float(s, _DIGITS) for u, s in zip(unknowns, step, strict=True)
            }
            if mpmath.norm(step) < mpmath.mpf(10) ** (-_DIGITS // 2):
                return _reference_orbit(equations, known)
    return None


def _reference_orbit(equations: EquationSystem, known: dict[sp.Symbol, sp.Expr]) -> ReferenceOrbit:
    """The numbers of an orbit from those of its unknowns."""
    program, period = equations.map_program, sum(link.duration for link in equations.chain.links)
    stages = (*equations.chain.stages, *program.stages)
    total, *entries = evaluate(stages, [period, *program.expressions], known, _DIGITS)
    matrix = sp.ImmutableMatrix(*program.expressions.shape, entries)
    found, _ = mpmath.eig(mpmath.matrix(matrix.tolist())) if entries else ((), None)
    multipliers = sorted(found, key=lambda m: (-abs(m), -mpmath.im(m)))
    return ReferenceOrbit(
        tuple(known[u] for u in equations.unknowns),
        total,
        matrix,
        tuple(sp.sympify(m) for m in multipliers),
    )
