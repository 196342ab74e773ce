"""What a reference leaves out of an orbit's start, from its dwell times.

Given the dwell times, switching and closure are linear in the start: the least squares of all of
them are a guess. The phase of a forcing is sought on a grid; where several fit, the orbit that
crosses its boundaries from inside is taken.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import mpmath
import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary, Reference
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.affine import affine_conditions
from nonsmooth.derive.equations.chain import Chain
from nonsmooth.derive.equations.program import evaluate

__all__ = ["with_guess"]

_PHASES = 360  # at which a forcing is tried
_DIGITS = 6


def with_guess(
    itinerary: Itinerary, system: System, chain: Chain, known: Mapping[sp.Symbol, sp.Expr]
) -> Itinerary:
    """The itinerary, its reference completed by a guess of the start's coordinates.

    It is returned unchanged if the reference's data do not suffice. `known` has numbers of
    parameters, spectrum and dwell times at the reference.
    """
    reference, coordinates = itinerary.reference, chain.start.coordinates
    if reference is None or all(str(q) in reference.guess for q in coordinates):
        return itinerary
    stages, equations = affine_conditions(itinerary, system, chain)
    zero = dict.fromkeys(coordinates, 0)
    rows = [[sp.diff(e, q) for q in coordinates] + [-e.subs(zero)] for _, e in equations]
    flat = evaluate(stages, [e for row in rows for e in row], known, digits=15)
    if not all(number.is_number for number in flat):
        return itinerary
    width = len(coordinates) + 1
    numbers = [float(number) for number in flat]
    table = mpmath.matrix([numbers[i : i + width] for i in range(0, len(numbers), width)])
    starts = _starts(chain, table)
    found = min(starts, key=lambda start: _leaving(chain, known, start)) if starts else None
    if found is None:
        return itinerary
    guess = {str(q): str(sp.Float(x, _DIGITS)) for q, x in zip(coordinates, found, strict=True)}
    completed = Reference(reference.parameters, {**guess, **reference.guess})
    return replace(itinerary, reference=completed)


def _starts(chain: Chain, table: mpmath.matrix) -> list[list[float]]:
    """Starts that fit the linear equations best, the best first.

    Of a forced orbit there is one for each phase of the forcing at which the misfit has a
    local minimum.
    """
    size = table.cols - 1
    forcing, places = chain.forcing, chain.start.places
    if forcing is None:
        return [solution] if (solution := _least(table[:, :size], table[:, size])) else []
    free = [i for i, place in enumerate(places) if place not in forcing.states]
    turning = [(places.index(c), places.index(s)) for c, s in forcing.places]
    found = []
    for step in range(_PHASES):
        angle = 2 * mpmath.pi * step / _PHASES
        start = [0.0] * size
        for multiple, (c, s) in zip(forcing.multiples, turning, strict=True):
            start[c], start[s] = (float(f(multiple * angle)) for f in (mpmath.cos, mpmath.sin))
        found.append(start)
    columns = [i for pair in turning for i in pair]
    matrix = mpmath.matrix([[table[i, j] for j in free] for i in range(table.rows)])
    solvers = _projection(matrix)
    if solvers is None:
        return []
    inverse, rest = solvers
    misses = []
    for start in found:
        right = [
            float(table[i, size]) - sum(float(table[i, j]) * start[j] for j in columns)
            for i in range(table.rows)
        ]
        for j, row in zip(free, inverse, strict=True):
            start[j] = sum(a * b for a, b in zip(row, right, strict=True))
        misses.append(sum(sum(a * b for a, b in zip(row, right, strict=True)) ** 2 for row in rest))
    order = [k for k in range(_PHASES) if misses[k] <= min(misses[k - 1], misses[k + 1 - _PHASES])]
    return [found[k] for k in sorted(order, key=lambda k: misses[k])]


def _projection(
    matrix: mpmath.matrix,
) -> tuple[list[list[float]], list[list[float]]] | None:
    """Matrices that give the least-squares solution and the residual; None if it is singular."""
    identity = mpmath.eye(matrix.rows)
    if not matrix.cols:
        return [], _floats(identity)
    try:
        inverse = mpmath.inverse(matrix.T * matrix) * matrix.T
    except ZeroDivisionError:
        return None
    return _floats(inverse), _floats(identity - matrix * inverse)


def _floats(matrix: mpmath.matrix) -> list[list[float]]:
    return [[float(e) for e in row] for row in matrix.tolist()]


def _least(matrix: mpmath.matrix, right: mpmath.matrix) -> list[float] | None:
    try:
        return [float(x) for x in mpmath.lu_solve(matrix, right)]
    except ZeroDivisionError:
        return None


def _leaving(chain: Chain, known: Mapping[sp.Symbol, sp.Expr], start: Sequence[float]) -> int:
    """Number of boundaries that an orbit from the start crosses from outside."""
    values = {**known, **dict(zip(chain.start.coordinates, map(sp.Float, start), strict=True))}
    rates = [(link.normal * link.velocity)[0] for link in chain.links]
    return sum(bool(rate < 0) for rate in evaluate(chain.stages, rates, values, digits=15))
