"""Equations that are affine in the start's coordinates, solved for them.

The conditions of a reversible or of a forced orbit are affine in the coordinates of its start,
given the dwell times. Coordinates whose coefficient holds no function of time go first; the
rest follow from a square part of the equations, by Cramer's rule where they are few. What
remains are equations for the dwell times, and for those coordinates that other equations, of
higher degree, are left to determine.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Reference
from nonsmooth.derive.declaration.parameter import exact
from nonsmooth.derive.equations.program import Stage, assign, evaluate, prune
from nonsmooth.derive.equations.reduction import Elimination, Reduction
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import Spectrum
from nonsmooth.derive.symbols import Symbol

__all__ = ["LinearSolution", "eliminate_coordinates", "entry", "reference_values", "solve_linear"]

_Equation = tuple[str, sp.Expr]

MOST_BY_CRAMER = 3
_SOUND = sp.Rational(1, 1000)  # of a determinant, in units of its bound


def eliminate_coordinates(
    stages: Sequence[Stage],
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    dwell_times: Sequence[sp.Symbol],
    constants: set[sp.Symbol],
    choose: Mapping[sp.Symbol, sp.Expr],
    rank: int,
    polynomials: Sequence[_Equation] = (),
    known: Sequence[Elimination] = (),
) -> Reduction:
    """The reduction to the dwell times of equations that are affine in the start.

    `equations` and `polynomials` are (meaning, expression) and together as many as the
    coordinates and dwell times. The former are affine in the coordinates; the latter may
    have any degree, and for each of them one coordinate stays unknown: the first ones, if
    the others are well determined. `stages` compute functions of the dwell times over the
    `constants`, which are parameters and spectrum, and `known` lists what they make
    explicit already. `choose` has numbers of a known point: there the square part of the
    equations with the best determinant is solved, or the first part if the point is not
    known whole. `rank` bounds the number of multipliers that differ from zero.
    DerivationError says that the equations do not determine the coordinates.
    """
    left, open_ones = list(equations), list(coordinates)
    solved: list[Stage] = []
    eliminations: list[Elimination] = []
    while (pivot := _constant_pivot(left, open_ones, constants, len(polynomials))) is not None:
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
    block = LinearSolution((), {}, sp.Integer(1), ())
    kept: tuple[sp.Symbol, ...] = tuple(open_ones[: len(polynomials)])
    if len(open_ones) > len(polynomials):
        rows, kept = _part(left, open_ones, len(polynomials), stages, choose)
        open_ones = [q for q in open_ones if q not in kept]
        together = [left[i] for i in rows]
        left = [e for i, e in enumerate(left) if i not in rows]
        block = solve_linear(together, open_ones, kept, stages, choose)
        solved += reversed(block.stages)
        rule = "linear in: " + "; ".join(meaning for meaning, _ in together)
        eliminations += [Elimination(q, rule) for q in open_ones]
    every = (*stages, *reversed(solved))
    left += polynomials
    roots: tuple[sp.Expr, ...] = ()
    if len(left) == 1:
        written = {x: e for stage in solved for x, e in stage.assignments if x in coordinates}
        left = [_cleared(left[0], {q: written[q] for q in written if q not in open_ones}, block)]
        roots = _roots(left[0], kept)
    unknowns = (*dwell_times, *kept)
    names = [*dict.fromkeys((*coordinates, *dwell_times, *(e.unknown for e in known)))]
    wanted = [*(e for _, e in left), *roots, *coordinates, *(e.unknown for e in known)]
    wanted += [determinant for determinant, _ in block.determinants]
    return Reduction(
        rotation=0,
        rank=rank,
        unknowns=unknowns,
        equations=tuple(left),
        stages=prune(every, wanted),
        values={name: name for name in names},
        eliminations=(*known, *eliminations),
        rates={},
        start=None,
        image=None,
        determinants=block.determinants,
        roots=roots,
    )


def reference_values(
    reference: Reference | None, spectrum: Spectrum, parameters: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """Numbers of parameters, spectrum and unknowns at the reference point of an orbit."""
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
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    constants: set[sp.Symbol],
    kept: int,
) -> tuple[_Equation, sp.Symbol] | None:
    """An equation and a coordinate that has a nonzero constant coefficient in it, if any.

    The first `kept` coordinates are left alone.
    """
    for equation in equations:
        for coordinate in coordinates[kept:]:
            slope = sp.diff(equation[1], coordinate)
            if slope.free_symbols <= constants and slope.is_nonzero:
                return equation, coordinate
    return None


def _part(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    kept: int,
    stages: Sequence[Stage],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> tuple[tuple[int, ...], tuple[sp.Symbol, ...]]:
    """Indices of the equations to be solved, and the coordinates that stay unknown."""
    table = sp.Matrix([[sp.diff(e, q) for q in coordinates] for _, e in equations])
    flat = evaluate(stages, table, choose, digits=30)
    numbers = sp.Matrix(*table.shape, flat)
    known = all(n.is_number for n in numbers)
    best: tuple[sp.Expr, tuple[int, ...], tuple[sp.Symbol, ...]] | None = None
    for names in combinations(coordinates, kept):
        columns = [i for i, q in enumerate(coordinates) if q not in names]
        for rows in combinations(range(len(equations)), len(columns)):
            part = (numbers if known else table).extract(list(rows), columns)
            determinant = part.det(method="berkowitz")
            if determinant == 0:
                continue
            if not known:
                return rows, names
            size = abs(determinant) / sp.prod([part.row(i).norm() for i in range(part.rows)])
            if best is None or size > best[0]:
                best = (size, rows, names)
        if best is not None and best[0] > _SOUND:
            break
    if best is None:
        raise DerivationError("the equations do not determine the start, given the dwell times")
    return best[1:]


def _cleared(
    equation: _Equation, solutions: Mapping[sp.Symbol, sp.Expr], block: LinearSolution
) -> _Equation:
    """The only remaining equation, cleared of its pole.

    It is multiplied by a power of the determinant of the solved equations. If it is affine,
    it then is the determinant of all equations, and an entire function of the dwell time.
    """
    meaning, condition = equation
    for coordinate, solution in solutions.items():
        condition = condition.subs(coordinate, solution)
    numerators = block.numerators
    if not numerators:
        return equation
    zero = dict.fromkeys(numerators, 0)
    inside = sp.Poly(condition, *numerators)
    terms = []
    for powers in reversed(inside.monoms()):
        orders = list(zip(numerators, powers, strict=True))
        slope = sp.diff(condition, *((q, k) for q, k in orders if k)) if any(powers) else condition
        coefficient = slope.subs(zero) / sp.prod([sp.factorial(k) for k in powers])
        factors = [numerators[q] ** k for q, k in orders]
        scale = block.determinant ** (inside.total_degree() - sum(powers))
        terms.append(coefficient * scale * sp.Mul(*factors))
    return meaning, sp.Add(*terms)


def _roots(equation: _Equation, unknowns: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...]:
    """Both roots of a quadratic equation for the only unknown; none for another equation."""
    if len(unknowns) != 1:
        return ()
    (unknown,) = unknowns
    polynomial = sp.Poly(sp.expand(equation[1]), unknown)
    if polynomial.degree() != 2:
        return ()
    a, b, c = polynomial.all_coeffs()
    half = b / 2
    root = sp.sqrt(half**2 - a * c)
    return tuple((sign * root - half) / a for sign in (1, -1))


def _squared_sizes(stages: Sequence[Stage]) -> dict[sp.Symbol, sp.Expr]:
    """Bounds of the squared functions of time; that of a sine is small for a small angle."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in (a for stage in stages for a in stage.assignments):
        if isinstance(expression, sp.cos):
            found[symbol] = sp.Integer(1)
        elif isinstance(expression, sp.sin):
            squared = expression.args[0] ** 2
            found[symbol] = 2 * squared / (1 + squared)
        elif isinstance(expression, ExponentialDifference):
            found[symbol] = symbol**2
    return found


def _squared_bound(coefficient: sp.Expr, sizes: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Sum of the squared bounds of the terms of a coefficient.

    The coefficient's own value is no scale: where its terms cancel only rounding is left.
    """
    terms = sp.collect(sp.expand(coefficient), list(sizes), evaluate=False)
    return sp.Add(*(sp.factor(c) ** 2 * sizes.get(f, f**2) for f, c in terms.items()))


@dataclass(frozen=True)
class LinearSolution:
    """Linear equations, solved in terms of the unknowns that are kept."""

    stages: tuple[Stage, ...]
    numerators: Mapping[sp.Symbol, sp.Expr]  # of each coordinate, affine in what is kept
    determinant: sp.Expr  # what the numerators are divided by
    determinants: tuple[tuple[sp.Expr, sp.Expr], ...]  # (determinant, bound)


def solve_linear(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    kept: Sequence[sp.Symbol],
    stages: Sequence[Stage],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> LinearSolution:
    """As many equations as coordinates, affine in these and in what is kept, solved for them.

    `stages` compute the coefficients. `choose` has numbers of a known point: there the pivots of
    an elimination are the best, where the coordinates are too many for Cramer's rule.
    """
    solve = _cramer if len(coordinates) <= MOST_BY_CRAMER else _successively
    return solve(equations, coordinates, kept, stages, choose)


def _bound(
    equations: Sequence[_Equation], coordinates: Sequence[sp.Symbol], stages: Sequence[Stage]
) -> sp.Expr:
    """Hadamard's bound of the determinant of linear equations."""
    sizes = _squared_sizes(stages)
    rows = ([_squared_bound(sp.diff(e, q), sizes) for q in coordinates] for _, e in equations)
    return sp.sqrt(sp.prod([sp.Add(*row) for row in rows], sp.Integer(1)))


def entry(row: int, column: int, size: int) -> Symbol:
    """Symbol of a matrix entry; its indices are set apart if they have several digits."""
    return Symbol("coefficient", f"{row + 1}{'_' if size > 9 else ''}{column + 1}")


def _sides(symbol: Symbol, kept: Iterable[sp.Symbol]) -> list[Symbol]:
    """A symbol that is affine in what is kept: its constant, and the coefficient of each."""
    return [symbol, *(Symbol("times", symbol, q) for q in kept)]


def _tables(
    equations: Sequence[_Equation], coordinates: Sequence[sp.Symbol], kept: Sequence[sp.Symbol]
) -> tuple[list[Stage], sp.Matrix, list[sp.Matrix]]:
    """Stages, matrix and right-hand sides of linear equations, their entries named.

    The first right-hand side is that of the constants, then there is one for each unknown
    that is kept.
    """
    size = len(coordinates)
    zero = dict.fromkeys((*coordinates, *kept), 0)
    naming, values = assign(
        "coefficients of the linear equations",
        [entry(i, j, size) for i in range(size) for j in range(size)],
        [sp.diff(e, q) for _, e in equations for q in coordinates],
    )
    stages, columns = [naming], []
    sides = [_sides(Symbol("right", i + 1), kept) for i in range(size)]
    for names, unknown in zip(zip(*sides, strict=True), (None, *kept), strict=True):
        parts = [e.subs(zero) if unknown is None else sp.diff(e, unknown) for _, e in equations]
        other, right = assign(
            "right-hand sides of the linear equations",
            names,
            [-part for part in parts],
        )
        stages.append(other)
        columns.append(sp.Matrix(right))
    return stages, sp.Matrix(size, size, values), columns


def _cramer(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    kept: Sequence[sp.Symbol],
    stages: Sequence[Stage],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> LinearSolution:
    """Linear equations solved by Cramer's rule."""
    naming, matrix, columns = _tables(equations, coordinates, kept)
    determinant = Symbol("determinant")
    naming.append(
        Stage("determinant of the linear equations", ((determinant, sp.expand(matrix.det())),))
    )
    numerators = dict.fromkeys(coordinates, sp.Integer(0))
    sides = [_sides(Symbol("numerator", j + 1), kept) for j in range(len(coordinates))]
    for place, (unknown, column) in enumerate(zip((None, *kept), columns, strict=True)):
        replaced = [matrix.copy() for _ in coordinates]
        for j, numerator in enumerate(replaced):
            numerator[:, j] = column
        minors, values = assign(
            "numerators of Cramer's rule",
            [side[place] for side in sides],
            [sp.expand(m.det()) for m in replaced],
        )
        naming.append(minors)
        for q, value in zip(coordinates, values, strict=True):
            numerators[q] += value * (sp.Integer(1) if unknown is None else unknown)
    title = f"{', '.join(map(str, coordinates))} by Cramer's rule"
    naming.append(Stage(title, tuple((q, numerators[q] / determinant) for q in coordinates)))
    found = tuple(s for s in naming if s.assignments)
    bound = _bound(equations, coordinates, stages)
    return LinearSolution(found, numerators, determinant, ((determinant, bound),))


def _successively(
    equations: Sequence[_Equation],
    coordinates: Sequence[sp.Symbol],
    kept: Sequence[sp.Symbol],
    stages: Sequence[Stage],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> LinearSolution:
    """Linear equations solved by elimination, with the pivots that are best at a known point."""
    naming, matrix, columns = _tables(equations, coordinates, kept)
    size, width = len(coordinates), len(coordinates) + len(columns)
    table = sp.Matrix.hstack(matrix, *columns)
    flat = evaluate([*stages, *naming], table, choose, digits=30)
    numbers = sp.Matrix(*table.shape, flat)
    if not all(n.is_number for n in numbers):
        raise DerivationError(
            f"the start solves {size} linear equations, and no reference tells in which order"
        )
    rows, places = list(range(size)), list(range(size))
    entries = [
        [*(entry(k, m, size) for m in places), *_sides(Symbol("right", k + 1), kept)] for k in rows
    ]
    pivots: list[sp.Expr] = []
    order: list[tuple[int, int]] = []
    while rows:
        i, j = max(((i, j) for i in rows for j in places), key=lambda ij: abs(numbers[ij]))
        rows.remove(i)
        places.remove(j)
        order.append((i, j))
        pivots.append(table[i, j])
        names, values = [], []
        cells = [(k, m) for k in rows for m in (*places, *range(size, width))]
        for k, m in cells:
            numbers[k, m] -= numbers[k, j] * numbers[i, m] / numbers[i, j]
            names.append(Symbol("without", entries[k][m], len(order)))
            values.append(table[k, m] - table[k, j] * table[i, m] / table[i, j])
        step, found = assign(f"without {coordinates[j]}", names, values)
        for cell, value in zip(cells, found, strict=True):
            table[cell] = value
        naming.append(step)
    numerators: dict[sp.Symbol, sp.Expr] = {}
    known: dict[int, list[sp.Expr]] = {}
    for i, j in reversed(order):
        parts = [
            (table[i, m] - sum(table[i, n] * known[n][m - size] for n in known)) / table[i, j]
            for m in range(size, width)
        ]
        solved = coordinates[j]
        names = [Symbol("constant", solved), *(Symbol("times", solved, q) for q in kept)]
        step, known[j] = assign(f"parts of {solved}", names, parts)
        naming.append(step)
        constant, *rates = known[j]
        numerators[solved] = constant + sum(
            (r * q for r, q in zip(rates, kept, strict=True)), sp.Integer(0)
        )
    naming.append(Stage("the start", tuple((q, numerators[q]) for q in coordinates)))
    determinant = Symbol("determinant")
    naming.append(Stage("determinant of the linear equations", ((determinant, sp.Mul(*pivots)),)))
    found_stages = tuple(s for s in naming if s.assignments)
    bound = _bound(equations, coordinates, stages)
    return LinearSolution(found_stages, numerators, sp.Integer(1), ((determinant, bound),))
