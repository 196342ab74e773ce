"""Equations that are affine in the start's coordinates, solved for them.

The conditions of a reversible or of a forced orbit are affine in the coordinates of its start,
given the dwell times. Coordinates whose coefficient holds no function of time go first; the
rest follow from a square part of the equations, by Cramer's rule where they are few. What
remains are equations for the dwell times, and for those coordinates that other equations, of
higher degree, are left to determine.

Of a forced orbit these are the forcing's own: the period, that of the forcing, makes the last dwell
time explicit, all coordinates but one follow, and what is left is that the forcing's amplitude is
one. For an orbit of one phase that is a quadratic equation over the parameters.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from nonsmooth.derive.equations.chain import Chain, affine_conditions, derived_time
from nonsmooth.derive.equations.forcing import PERIODS
from nonsmooth.derive.equations.program import (
    Equation,
    Stage,
    Stages,
    affine_sum,
    assign,
    coefficients_of,
    evaluate,
    filled,
    name_parts,
    prune,
)
from nonsmooth.derive.equations.reduction import Elimination, Reduction
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.symbols import Symbol, Symbols, Values

MOST_BY_CRAMER = 3
_SOUND = sp.Rational(1, 1000)  # of a determinant, in units of its bound


def eliminate_coordinates(
    stages: Sequence[Stage],
    equations: Sequence[Equation],
    coordinates: Symbols,
    dwell_times: Symbols,
    constants: set[sp.Symbol],
    choose: Values,
    rank: int,
    polynomials: Sequence[Equation] = (),
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
    block = None
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
        if block is not None:
            alone = {q: written[q] for q in written if q not in open_ones}
            left = [_cleared(left[0], alone, block)]
        roots = _roots(left[0], kept)
    names = [*dict.fromkeys((*coordinates, *dwell_times, *(e.unknown for e in known)))]
    determinants = (block.determinant,) if block else ()
    wanted = [*(e for _, e in left), *roots, *names, *(d for d, _ in determinants)]
    return Reduction(
        rank,
        (*dwell_times, *kept),
        tuple(left),
        prune(every, wanted),
        {name: name for name in names},
        (*known, *eliminations),
        determinants=determinants,
        roots=roots,
    )


def reduce_forced(
    chain: Chain,
    constants: set[sp.Symbol],
    choose: Values,
    rank: int,
) -> Reduction:
    """The reduction of a forced orbit, in which velocities are eliminated last.

    The arguments are those of :func:`eliminate_coordinates`.
    """
    forcing, start, link = chain.forcing, chain.start, chain.links[0]
    assert forcing is not None
    *others, last = (link.dwell for link in chain.links)
    complete = derived_time(last, forcing.period - sp.Add(*others))
    stages, equations = affine_conditions(chain)
    rates = link.flow.velocity(sp.Matrix(link.states))
    velocities = {link.states.index(rate) for rate in rates if rate in link.states}
    # those that may stay unknown come first: velocities, other states, those of the forcing
    order = sorted(
        zip(start.coordinates, start.places, strict=True),
        key=lambda q: 2 if q[1] in forcing.states else 0 if q[1] in velocities else 1,
    )
    return eliminate_coordinates(
        [complete, *stages],
        equations,
        [coordinate for coordinate, _ in order],
        others,
        constants,
        choose,
        rank - len(forcing.states) + 1,
        forcing.conditions(start.state),
        [Elimination(last, PERIODS)],
    )


def _constant_pivot(
    equations: Sequence[Equation],
    coordinates: Symbols,
    constants: set[sp.Symbol],
    kept: int,
) -> tuple[Equation, sp.Symbol] | None:
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
    equations: Sequence[Equation],
    coordinates: Symbols,
    kept: int,
    stages: Sequence[Stage],
    choose: Values,
) -> tuple[tuple[int, ...], tuple[sp.Symbol, ...]]:
    """Indices of the equations to be solved, and the coordinates that stay unknown."""
    table = coefficients_of(equations, coordinates)[:, :-1]
    numbers = sp.Matrix(*table.shape, evaluate(stages, table, choose, digits=30))
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


def _cleared(equation: Equation, solutions: Values, block: LinearSolution) -> Equation:
    """The only remaining equation, cleared of its pole.

    It is multiplied by a power of the determinant of the solved equations. If it is affine,
    it then is the determinant of all equations, and an entire function of the dwell time.
    """
    meaning, condition = equation
    for coordinate, solution in solutions.items():
        condition = condition.subs(coordinate, solution)
    numerators = block.numerators
    zero = dict.fromkeys(numerators, 0)
    inside = sp.Poly(condition, *numerators)
    terms = []
    for powers in reversed(inside.monoms()):
        orders = list(zip(numerators, powers, strict=True))
        slope = sp.diff(condition, *((q, k) for q, k in orders if k)) if any(powers) else condition
        coefficient = slope.subs(zero) / sp.Mul(*map(sp.factorial, powers))
        factors = [numerators[q] ** k for q, k in orders]
        scale = block.divisor ** (inside.total_degree() - sum(powers))
        terms.append(coefficient * scale * sp.Mul(*factors))
    return meaning, sp.Add(*terms)


def _roots(equation: Equation, unknowns: Symbols) -> tuple[sp.Expr, ...]:
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


def _squared_bound(coefficient: sp.Expr, sizes: Values) -> sp.Expr:
    """Sum of the squared bounds of the terms of a coefficient.

    The coefficient's own value is no scale: where its terms cancel only rounding is left.
    """
    terms = sp.collect(sp.expand(coefficient), list(sizes), evaluate=False)
    return sp.Add(*(sp.factor(c) ** 2 * sizes.get(f, f**2) for f, c in terms.items()))


@dataclass(frozen=True)
class LinearSolution:
    """Linear equations, solved in terms of the unknowns that are kept."""

    stages: Stages
    numerators: Values  # of each coordinate, affine in what is kept
    divisor: sp.Expr  # what the numerators are divided by
    determinant: tuple[sp.Symbol, sp.Expr]  # with its bound


def solve_linear(
    equations: Sequence[Equation],
    coordinates: Symbols,
    kept: Symbols,
    stages: Sequence[Stage],
    choose: Values,
) -> LinearSolution:
    """As many equations as coordinates, affine in these and in what is kept, solved for them.

    `stages` compute the coefficients. `choose` has numbers of a known point: there the pivots of
    an elimination are the best, where the coordinates are too many for Cramer's rule.
    """
    entries = coefficients_of(equations, (*coordinates, *kept))
    size, sizes = len(coordinates), _squared_sizes(stages)
    squares = entries[:, :size].applyfunc(lambda e: _squared_bound(e, sizes))
    bound = sp.sqrt(sp.Mul(*(sp.Add(*squares[i, :]) for i in range(size))))
    naming, table, names = _named(entries, size, kept)
    determinant = Symbol("determinant")
    if size <= MOST_BY_CRAMER:
        more, numerators = _cramer(table, coordinates, kept, determinant)
        divisor: sp.Expr = determinant
    else:
        known = evaluate([*stages, *naming], table, choose, digits=30)
        numbers = sp.Matrix(*table.shape, known)
        if not all(number.is_number for number in numbers):
            raise DerivationError(
                f"the start solves {size} linear equations, and no reference tells in which order"
            )
        more, numerators = _successively(table, numbers, names, coordinates, kept, determinant)
        divisor = sp.Integer(1)
    used = filled((*naming, *more))
    return LinearSolution(used, numerators, divisor, (determinant, bound))


def entry(row: int, column: int, size: int) -> Symbol:
    """Symbol of a matrix entry; its indices are set apart if they have several digits."""
    return Symbol("coefficient", f"{row + 1}{'_' if size > 9 else ''}{column + 1}")


def _sides(symbol: Symbol, kept: Iterable[sp.Symbol]) -> list[Symbol]:
    """A symbol that is affine in what is kept: its constant, and the coefficient of each."""
    return [symbol, *(Symbol("times", symbol, q) for q in kept)]


def _named(
    entries: sp.Matrix, size: int, kept: Symbols
) -> tuple[list[Stage], sp.Matrix, list[list[Symbol]]]:
    """Stages, table and names of linear equations: their matrix, then right-hand sides.

    The first right-hand side is that of the constants, then there is one for each unknown
    that is kept.
    """
    names = [
        [*(entry(i, j, size) for j in range(size)), *_sides(Symbol("right", i + 1), kept)]
        for i in range(size)
    ]
    table = sp.Matrix.hstack(entries[:, :size], -entries[:, -1], -entries[:, size:-1])
    stages = []
    for columns, title in (
        (range(size), "coefficients of the linear equations"),
        *(([k], "right-hand sides of the linear equations") for k in range(size, table.cols)),
    ):
        cells = [(i, j) for i in range(size) for j in columns]
        stages.append(_named_cells(title, table, cells, [names[i][j] for i, j in cells]))
    return stages, table, names


def _named_cells(
    title: str, table: sp.Matrix, cells: Sequence[tuple[int, int]], names: Sequence[Symbol]
) -> Stage:
    """A stage that assigns cells of a table to names, which stand in the table from then on."""
    step, values = assign(title, names, [table[cell] for cell in cells])
    for cell, value in zip(cells, values, strict=True):
        table[cell] = value
    return step


def _cramer(
    table: sp.Matrix,
    coordinates: Symbols,
    kept: Symbols,
    determinant: sp.Symbol,
) -> tuple[list[Stage], dict[sp.Symbol, sp.Expr]]:
    """Stages and numerators of linear equations solved by Cramer's rule."""
    size = len(coordinates)
    matrix = table[:, :size]
    title = "determinant of the linear equations"
    stages = [Stage(title, ((determinant, sp.expand(matrix.det())),))]
    parts: list[list[sp.Expr]] = []
    sides = [_sides(Symbol("numerator", j + 1), kept) for j in range(size)]
    for k, names in enumerate(zip(*sides, strict=True), start=size):
        replaced = (
            sp.Matrix.hstack(matrix[:, :j], table[:, k], matrix[:, j + 1 :]) for j in range(size)
        )
        determinants = [sp.expand(m.det()) for m in replaced]
        minors, values = assign("numerators of Cramer's rule", names, determinants)
        stages.append(minors)
        parts.append(values)
    columns = zip(*parts, strict=True)
    numerators = {q: affine_sum(p, kept) for q, p in zip(coordinates, columns, strict=True)}
    title = f"{', '.join(map(str, coordinates))} by Cramer's rule"
    stages.append(Stage(title, tuple((q, n / determinant) for q, n in numerators.items())))
    return stages, numerators


def _successively(
    table: sp.Matrix,
    numbers: sp.Matrix,
    entries: list[list[Symbol]],
    coordinates: Symbols,
    kept: Symbols,
    determinant: sp.Symbol,
) -> tuple[list[Stage], dict[sp.Symbol, sp.Expr]]:
    """Stages and solutions of linear equations by elimination, with the pivots best for numbers."""
    size, stages = len(coordinates), []
    rows, places = list(range(size)), list(range(size))
    order: list[tuple[int, int]] = []
    while rows:
        i, j = max(((i, j) for i in rows for j in places), key=lambda ij: abs(numbers[ij]))
        rows.remove(i)
        places.remove(j)
        order.append((i, j))
        cells = [(k, m) for k in rows for m in (*places, *range(size, table.cols))]
        for each in (numbers, table):
            for k, m in cells:
                each[k, m] -= each[k, j] * each[i, m] / each[i, j]
        names = [Symbol("without", entries[k][m], len(order)) for k, m in cells]
        stages.append(_named_cells(f"without {coordinates[j]}", table, cells, names))
    known: dict[int, list[sp.Expr]] = {}
    for i, j in reversed(order):
        parts = [
            (table[i, m] - sum(table[i, n] * known[n][m - size] for n in known)) / table[i, j]
            for m in range(size, table.cols)
        ]
        step, known[j] = name_parts(coordinates[j], parts, kept)
        stages.append(step)
    solutions = {coordinates[j]: affine_sum(known[j], kept) for j in known}
    stages.append(Stage("the start", tuple((q, solutions[q]) for q in coordinates)))
    product = sp.Mul(*(table[pivot] for pivot in order))
    stages.append(Stage("determinant of the linear equations", ((determinant, product),)))
    return stages, solutions
