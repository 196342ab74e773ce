"""Equations that are affine in the start's coordinates, solved for them.

The conditions of a reversible orbit are affine in the coordinates of its start, given the
dwell times. Coordinates whose coefficient holds no function of time go first; the rest
follow from a square part of the equations by Cramer's rule. What remains are equations for
the dwell times alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Reference
from nonsmooth.derive.declaration.parameter import exact
from nonsmooth.derive.equations.program import Stage, assign, evaluate, prune
from nonsmooth.derive.equations.reduction import Elimination, Reduction
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Spectrum

__all__ = ["eliminate_coordinates", "reference_values"]

_Equation = tuple[str, sp.Expr]


def eliminate_coordinates(
    stages: Sequence[Stage],
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    dwell_times: Sequence[sp.Symbol],
    constants: set[sp.Symbol],
    choose: Mapping[sp.Symbol, sp.Expr],
    rank: int,
) -> Reduction:
    """Reduce equations that are affine in the coordinates to the dwell times.

    Parameters
    ----------
    stages : sequence of Stage
        Functions of the dwell times, over parameters and spectrum.
    equations : sequence of (meaning, expression)
        As many as coordinates and dwell times together.
    coordinates, dwell_times : sequences of symbols
    constants : set of symbols
        Parameters and spectrum.
    choose : mapping of symbol to number
        A known point: of the square parts of the equations that with the best determinant
        there is solved. Where it is not known whole, the first is.
    rank : int
        Dimension of the smallest section of the orbit.

    Raises
    ------
    DerivationError
        If the equations do not determine the coordinates.
    """
    left, open_ones = list(equations), list(coordinates)
    solved: list[Stage] = []
    eliminations: list[Elimination] = []
    while (pivot := _constant_pivot(left, open_ones, constants)) is not None:
        equation, coordinate = pivot
        meaning, condition = equation
        slope = sp.diff(condition, coordinate)
        solution = sp.expand(coordinate - condition / slope)
        left.remove(equation)
        left = [(m, sp.expand(e.subs(coordinate, solution))) for m, e in left]
        open_ones.remove(coordinate)
        rule = f"linear in: {meaning}"
        eliminations.append(Elimination(coordinate, rule))
        solved.append(Stage(f"{coordinate}: {rule}", ((coordinate, solution),)))
    determinants: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    if open_ones:
        rows = _rows(left, open_ones, stages, choose)
        together = [left[i] for i in rows]
        left = [e for i, e in enumerate(left) if i not in rows]
        block, numerators, determinants = _cramer(together, open_ones, _squared_sizes(stages))
        solved += reversed(block)
        if len(left) == 1:
            left = [_cleared(left[0], dict(zip(open_ones, numerators, strict=True)), determinants)]
        rule = "linear in: " + "; ".join(meaning for meaning, _ in together)
        eliminations += [Elimination(q, rule) for q in open_ones]
    every = (*stages, *reversed(solved))
    names = [*coordinates, *dwell_times]
    wanted = [*(e for _, e in left), *coordinates]
    return Reduction(
        rotation=0,
        rank=rank,
        unknowns=tuple(dwell_times),
        equations=tuple(left),
        stages=prune(every, wanted),
        values={name: name for name in names},
        eliminations=tuple(eliminations),
        rates={},
        start=None,
        image=None,
        determinants=determinants,
    )


def reference_values(
    reference: Reference | None, spectrum: Spectrum, parameters: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """Numbers of parameters, spectrum and unknowns at a known point of an orbit."""
    if reference is None:
        return {}
    texts = reference.parameters
    known = {s: exact(texts[str(s)]) for s in parameters if str(s) in texts}
    for symbol, expression in spectrum.entries:
        known[symbol] = expression.xreplace(known).evalf(30)
    kinds: tuple[dict[str, bool], ...] = ({"positive": True}, {"real": True})
    return known | {
        sp.Symbol(name, **kind): sp.Float(text)
        for name, text in reference.guess.items()
        for kind in kinds  # of dwell times, and of coordinates
    }


def _constant_pivot(
    equations: Sequence[_Equation], coordinates: Sequence[sp.Symbol], constants: set[sp.Symbol]
) -> tuple[_Equation, sp.Symbol] | None:
    """An equation and a coordinate whose coefficient there is a nonzero constant."""
    for equation in equations:
        for coordinate in coordinates:
            slope = sp.diff(equation[1], coordinate)
            if slope.free_symbols <= constants and slope.is_nonzero:
                return equation, coordinate
    return None


def _rows(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    stages: Sequence[Stage],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> tuple[int, ...]:
    """Which of the equations are solved for the coordinates."""
    table = [[sp.diff(e, q) for q in coordinates] for _, e in equations]
    flat = evaluate(stages, [c for row in table for c in row], choose)
    numbers = sp.Matrix(len(table), len(coordinates), [sp.sympify(c).evalf(30) for c in flat])
    chosen = all(n.is_number for n in numbers)
    best: tuple[sp.Expr, tuple[int, ...]] | None = None
    for rows in combinations(range(len(equations)), len(coordinates)):
        if sp.Matrix([table[i] for i in rows]).det() == 0:
            continue
        if not chosen:
            return rows
        part = numbers.extract(list(rows), list(range(len(coordinates))))
        size = abs(part.det()) / sp.prod([part.row(i).norm() for i in range(part.rows)])
        if best is None or size > best[0]:
            best = (size, rows)
    if best is None:
        raise DerivationError("the equations do not determine the start, given the dwell times")
    return best[1]


def _cleared(
    equation: _Equation,
    numerators: Mapping[sp.Symbol, sp.Expr],
    determinants: Sequence[tuple[sp.Expr, sp.Expr]],
) -> _Equation:
    """The only equation left, times the determinant, which would be a pole of it.

    It is the determinant of all the equations, and entire in the dwell time.
    """
    meaning, condition = equation
    ((determinant, _),) = determinants
    constant = condition.subs(dict.fromkeys(numerators, 0))
    terms = (sp.diff(condition, q) * numerator for q, numerator in numerators.items())
    return meaning, sp.Add(constant * determinant, *terms)


def _squared_sizes(stages: Sequence[Stage]) -> dict[sp.Symbol, sp.Expr]:
    """Squares of what the functions of time are at most: the sine of a small angle is small."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in (a for stage in stages for a in stage.assignments):
        if isinstance(expression, sp.cos):
            found[symbol] = sp.Integer(1)
        elif isinstance(expression, sp.sin):
            squared = expression.args[0] ** 2
            found[symbol] = 2 * squared / (1 + squared)
    return found


def _squared_bound(coefficient: sp.Expr, sizes: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Sum of the squares of what the terms of a coefficient are at most.

    Its own size says nothing: where all its terms vanish together only rounding is left.
    """
    terms = sp.collect(sp.expand(coefficient), list(sizes), evaluate=False)
    return sp.Add(*(sp.factor(c) ** 2 * sizes.get(f, f**2) for f, c in terms.items()))


def _cramer(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    sizes: Mapping[sp.Symbol, sp.Expr],
) -> tuple[list[Stage], list[sp.Expr], tuple[tuple[sp.Expr, sp.Expr], ...]]:
    """Stages that solve linear equations, the numerators, and the determinant with a bound."""
    size = len(coordinates)
    zero = dict.fromkeys(coordinates, 0)
    naming, values = assign(
        "coefficients of the linear equations",
        [f"coefficient{i + 1}{j + 1}" for i in range(size) for j in range(size)],
        [sp.diff(e, q) for _, e in equations for q in coordinates],
    )
    matrix = sp.Matrix(size, size, values)
    other, right = assign(
        "right-hand sides of the linear equations",
        [f"right{i + 1}" for i in range(size)],
        [-e.subs(zero) for _, e in equations],
    )
    column = sp.Matrix(right)
    determinant = sp.Symbol("determinant", real=True)
    replaced = [matrix.copy() for _ in coordinates]
    for j, numerator in enumerate(replaced):
        numerator[:, j] = column
    minors, numerators = assign(
        "numerators of Cramer's rule",
        [f"numerator{j + 1}" for j in range(size)],
        [sp.expand(m.det()) for m in replaced],
    )
    rows = ([_squared_bound(sp.diff(e, q), sizes) for q in coordinates] for _, e in equations)
    bound = sp.prod([sp.Add(*row) for row in rows], sp.Integer(1))
    stages = [
        naming,
        other,
        Stage("determinant of the linear equations", ((determinant, sp.expand(matrix.det())),)),
        minors,
        Stage(
            f"{', '.join(map(str, coordinates))} by Cramer's rule",
            tuple((q, n / determinant) for q, n in zip(coordinates, numerators, strict=True)),
        ),
    ]
    return [s for s in stages if s.assignments], numerators, ((determinant, sp.sqrt(bound)),)
