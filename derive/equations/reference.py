"""The reference of an orbit in numbers: what it knows, the start that it leaves out, the orbit.

Given the dwell times, switching and closure are linear in the start: the least squares of all of
them are a guess. The phase of a forcing is sought on a grid; where several fit, the orbit that
crosses its boundaries from inside is taken. From a complete guess Newton's method finds the orbit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import mpmath
import numpy as np
import sympy as sp

from nonsmooth.derive.declaration.fields import exact
from nonsmooth.derive.declaration.itinerary import Itinerary, Reference
from nonsmooth.derive.equations.chain import Chain, affine_conditions
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import coefficients_of, evaluate
from nonsmooth.derive.flows.modal import Spectrum
from nonsmooth.derive.symbols import Values

_PHASES = 360  # at which a forcing is tried
_GUESSED = 6  # digits of a guess
_DIGITS = 30
_STEPS = 12


def reference_values(
    reference: Reference | None, spectrum: Spectrum, parameters: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """Numbers of parameters, spectrum and unknowns at the reference point of an orbit."""
    if reference is None:
        return {}
    texts = {**reference.parameters, **reference.guess}  # of parameters that are solved for, too
    known = {s: exact(texts[str(s)]) for s in parameters if str(s) in texts}
    for symbol, expression in spectrum.entries:
        known[symbol] = expression.xreplace(known).evalf(_DIGITS)
    kinds: tuple[dict[str, bool], ...] = ({"positive": True}, {"real": True})
    return known | {
        sp.Symbol(name, **kind): sp.Float(text, _DIGITS)
        for name, text in reference.guess.items()
        for kind in kinds  # of dwell times, and of coordinates
    }


def with_guess(itinerary: Itinerary, chain: Chain, known: Values) -> Itinerary:
    """The itinerary, its reference completed by a guess of the start's coordinates.

    It is returned unchanged if the reference's data do not suffice. `known` has numbers of
    parameters, spectrum and dwell times at the reference.
    """
    reference, coordinates = itinerary.reference, chain.start.coordinates
    if reference is None or all(str(q) in reference.guess for q in coordinates):
        return itinerary
    stages, equations = affine_conditions(chain)
    entries = coefficients_of(equations, coordinates)
    numbers = evaluate(stages, entries, known, digits=15)
    if not all(number.is_number for number in numbers):
        return itinerary
    table = np.array(numbers, dtype=float).reshape(entries.shape)
    starts = [dict(zip(coordinates, map(sp.Float, s), strict=True)) for s in _starts(chain, table)]
    if not starts:
        return itinerary
    rates = [(link.normal * link.velocity)[0] for link in chain.links]
    found = min(
        starts,  # the first of those that cross the fewest boundaries from outside
        key=lambda start: sum(
            bool(rate < 0) for rate in evaluate(chain.stages, rates, {**known, **start}, digits=15)
        ),
    )
    guess = {str(q): str(sp.Float(x, _GUESSED)) for q, x in found.items()}
    completed = Reference(reference.parameters, {**guess, **reference.guess})
    return replace(itinerary, reference=completed)


def _starts(chain: Chain, table: np.ndarray) -> list[np.ndarray]:
    """Starts that fit equations best, the best first; a row has coefficients and the constant.

    Of a forced orbit there is one for each phase of the forcing at which the misfit has a
    local minimum.
    """
    matrix, right = table[:, :-1], -table[:, -1:]
    forcing, places = chain.forcing, chain.start.places
    starts = np.zeros((_PHASES if forcing else 1, len(places)))
    angles = 2 * np.pi * np.arange(_PHASES) / _PHASES
    for multiple, (c, s) in zip(forcing.multiples, forcing.places, strict=True) if forcing else ():
        starts[:, places.index(c)] = np.cos(multiple * angles)
        starts[:, places.index(s)] = np.sin(multiple * angles)
    free = [places.index(place) for _, place in chain.closing]
    right = right - matrix @ starts.T
    fitted, _, rank, _ = np.linalg.lstsq(matrix[:, free], right, rcond=None)
    if rank < len(free):
        return []
    starts[:, free] = fitted.T
    misses = ((matrix[:, free] @ fitted - right) ** 2).sum(axis=0)
    least = (misses <= np.roll(misses, 1)) & (misses <= np.roll(misses, -1))
    return [starts[k] for k in np.argsort(misses, kind="stable") if least[k]]


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
    unknowns, known = equations.unknowns, dict(equations.known)
    if not {*unknowns, *equations.parameters} <= set(known):
        return None
    derivatives = equations.jacobian_program
    stages = (*equations.stages, *derivatives.stages)
    size = len(unknowns)
    with mpmath.workdps(_DIGITS):
        for _ in range(_STEPS):
            flat = evaluate(stages, [*equations.residual, *derivatives.expressions], known, _DIGITS)
            if not all(number.is_real for number in flat):
                return None
            table = mpmath.matrix([flat[i : i + size] for i in range(0, len(flat), size)])
            try:
                step = mpmath.lu_solve(table[1:, :], table[0, :].T)
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
