"""Straight-line programs: named stages of assignments, and their derivatives.

Equations are never expanded. They are a list of stages, each assigning expressions of
earlier symbols to new ones; derivatives follow by the chain rule, stage by stage.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import prod
from typing import Any, NamedTuple

import sympy as sp

from nonsmooth.derive.symbols import Symbol, Symbols, Values, derivative

Equation = tuple[str, sp.Expr]  # its meaning, and what vanishes


@dataclass(frozen=True)
class Stage:
    """Assignments that are made together, under a title."""

    title: str
    assignments: tuple[tuple[sp.Symbol, sp.Expr], ...]


Stages = tuple[Stage, ...]  # one after the other, each in terms of those before


class Program(NamedTuple):
    """Expressions of symbols that stages assign, one after the other."""

    stages: Stages
    expressions: Any  # one expression, a matrix or a list of them


@dataclass(frozen=True)
class Array:
    """An array that a kernel or a C function takes or gives.

    Entries are row by row; arrays of functions of many points have none. Of an argument `since`
    is the place of the first output that needs it, of an output of a C function its own place.
    """

    name: str
    shape: tuple[int, ...] = ()
    entries: tuple[Any, ...] = ()  # symbols of an argument, expressions of an output
    since: int = 0
    ctype: str = "double"

    @classmethod
    def of(cls, name: str, value: sp.Expr | sp.Matrix | Iterable[sp.Expr]) -> Array:
        """The scalar of an expression, the table of a matrix, or the vector of several."""
        if isinstance(value, sp.MatrixBase):  # immutable ones are expressions, too
            return cls(name, value.shape, tuple(value))
        if isinstance(value, sp.Expr):
            return cls(name, (), (value,))
        entries = tuple(value)
        return cls(name, (len(entries),), entries)

    @property
    def size(self) -> int:
        """Number of entries."""
        return prod(self.shape)


@dataclass(frozen=True)
class Kernel:
    """One function to emit: input arrays, output arrays, and the stages between them.

    Who calls it may want the first outputs alone.
    """

    name: str
    title: str
    arguments: tuple[Array, ...]
    outputs: tuple[Array, ...]
    stages: Stages

    @classmethod
    def of(
        cls,
        name: str,
        title: str,
        arguments: Iterable[Array],
        outputs: Mapping[str, Any],
        stages: Sequence[Stage] = (),
    ) -> Kernel:
        """The kernel of what its outputs have in them, with those stages that they need."""
        given = tuple(Array.of(*output) for output in outputs.items())
        wanted = [e for output in given for e in output.entries]
        return cls(name, title, tuple(arguments), given, prune(stages, wanted))


def assign(
    title: str, symbols: Iterable[sp.Symbol], expressions: Iterable[sp.Expr]
) -> tuple[Stage, list[sp.Expr]]:
    """A stage that assigns expressions to symbols, and what stands in their place from then on.

    A number or a symbol needs no other and is passed on as it is.
    """
    assignments, values = [], []
    for symbol, expression in zip(symbols, expressions, strict=True):
        expression = sp.sympify(expression)
        if expression.is_Atom:
            values.append(expression)
        else:
            assignments.append((symbol, expression))
            values.append(symbol)
    return Stage(title, tuple(assignments)), values


def assign_matrix(
    title: str, symbols: Iterable[sp.Symbol], matrix: sp.Matrix
) -> tuple[Stage, sp.Matrix]:
    """As `assign`, for the entries of a matrix row by row."""
    step, values = assign(title, symbols, matrix)
    return step, sp.Matrix(*matrix.shape, values)


def name_parts(
    solved: sp.Symbol, parts: Sequence[sp.Expr], others: Symbols
) -> tuple[Stage, list[sp.Expr]]:
    """Stage and names of the constant and the rates of a solution that is affine in others."""
    names = [Symbol("constant", solved), *(Symbol("times", solved, q) for q in others)]
    return assign(f"parts of {solved}", names, parts)


def affine_sum(parts: Sequence[sp.Expr], others: Symbols) -> sp.Expr:
    """The first part, and one of the other parts times each of the others."""
    return sp.Add(*(p * q for p, q in zip(parts, (1, *others), strict=True)))


def coefficients_of(equations: Sequence[Equation], unknowns: Symbols) -> sp.Matrix:
    """Matrix (n x (k + 1)) of equations affine in k unknowns: their coefficients, the constant."""
    zero = dict.fromkeys(unknowns, 0)
    rows = ([*(sp.diff(e, q) for q in unknowns), e.subs(zero)] for _, e in equations)
    return sp.Matrix(len(equations), len(unknowns) + 1, [entry for row in rows for entry in row])


def differentiate(
    stages: Sequence[Stage],
    seeds: Mapping[sp.Symbol, Values],
    rates: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr] | None = None,
) -> tuple[Stages, dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]]:
    """Total derivatives of every assigned symbol.

    `seeds` has, for each symbol by which they are taken, the derivatives of the inputs that move
    with it.
    `rates` has derivatives, by symbol and direction, that are known in a shorter form, such
    as a vector field. The first result are stages that assign the derivatives, to be placed
    after the given ones; the second has, for each direction, the derivative (a number or a
    symbol) of each symbol that moves.
    """
    derivatives = {direction: dict(moving) for direction, moving in seeds.items()}
    assigned = {symbol for stage in stages for symbol, _ in stage.assignments}
    result = []
    for stage in stages:
        for direction, moving in derivatives.items():
            assignments: list[tuple[sp.Symbol, sp.Expr]] = []
            for symbol, expression in stage.assignments:
                name = derivative(symbol, direction)
                if name in assigned:  # the stages already hold this first derivative
                    moving[symbol] = name
                    continue
                if rates and (symbol, direction) in rates:
                    rate = rates[symbol, direction]
                else:
                    factor, inner = _outer_derivative(symbol, expression)
                    rate = factor * derivative_of(inner, moving)
                if rate == 0:
                    continue
                step, (value,) = assign("", [name], [rate])
                assignments += step.assignments
                moving[symbol] = value
            if assignments:
                result.append(Stage(f"d/d{direction} of: {stage.title}", tuple(assignments)))
    return tuple(result), derivatives


def jacobian(
    stages: Sequence[Stage],
    expressions: Sequence[sp.Expr],
    seeds: Mapping[sp.Symbol, Values],
    rates: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr] | None = None,
) -> Program:
    """Stages and total derivatives of expressions, with a column for each direction."""
    more, moving = differentiate(stages, seeds, rates)
    entries = [derivative_of(e, moving[by]) for e in expressions for by in seeds]
    return Program(more, sp.Matrix(len(expressions), len(seeds), entries))


def gradient(
    stages: Sequence[Stage], expression: sp.Expr, inputs: Symbols
) -> tuple[Stages, list[sp.Expr]]:
    """Derivatives of one expression by all inputs, backwards through the stages.

    Reverse accumulation (Linnainmaa 1970): its length does not grow with the number of inputs.
    The stages that come first assign the derivatives by the symbols of the given stages, to be
    placed after these.
    """
    terms: dict[sp.Symbol, list[sp.Expr]] = {}

    def add(factor: sp.Expr, value: sp.Expr) -> None:
        for symbol in sorted(value.free_symbols, key=str):
            terms.setdefault(symbol, []).append(factor * partial_derivative(value, symbol))

    add(sp.Integer(1), sp.sympify(expression))
    result = []
    for stage in reversed(stages):
        assignments: list[tuple[sp.Symbol, sp.Expr]] = []
        for symbol, value in reversed(stage.assignments):
            total = sp.Add(*terms.pop(symbol, []))
            if total == 0:
                continue
            step, (slope,) = assign("", [Symbol("slope", symbol)], [total])
            assignments += step.assignments
            factor, inner = _outer_derivative(symbol, value)
            add(slope * factor, inner)
        if assignments:
            result.append(Stage(f"back through: {stage.title}", tuple(assignments)))
    return tuple(result), [sp.Add(*terms.get(symbol, [])) for symbol in inputs]


def _outer_derivative(symbol: sp.Symbol, expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Factor and inner expression of the derivative of a symbol that is assigned an expression.

    Roots and absolute values are in the factor as the symbol itself.
    """
    if expression.is_Pow and expression.exp == sp.Rational(1, 2):
        return 1 / (2 * symbol), expression.base
    if isinstance(expression, sp.Abs):
        return expression.args[0] / symbol, expression.args[0]
    return sp.Integer(1), expression


def derivative_of(expression: sp.Expr, moving: Values) -> sp.Expr:
    """Derivative of an expression whose symbols have the given derivatives."""
    return sp.Add(
        *(
            partial_derivative(expression, symbol) * moving[symbol]
            for symbol in sorted(expression.free_symbols, key=str)
            if symbol in moving
        )
    )


@lru_cache(maxsize=1 << 15)  # stages share terms, and each is asked for in many directions
def partial_derivative(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """Derivative of an expression by a symbol, in the form that SymPy gives it.

    SymPy asks of each part whether its derivative is zero, which takes most of its time.
    """
    if expression.is_Atom:
        return sp.Integer(expression == symbol)
    if expression.is_Add:
        return sp.Add(*(partial_derivative(term, symbol) for term in expression.args))
    if expression.is_Mul:
        factors = expression.args
        slopes = [partial_derivative(factor, symbol) for factor in factors]
        return sp.Add(
            *(
                sp.Mul(*factors[:i], slope, *factors[i + 1 :])
                for i, slope in enumerate(slopes)
                if slope != 0
            )
        )
    if expression.is_Pow and expression.exp.is_number:
        base, exponent = expression.args
        return expression * (partial_derivative(base, symbol) * exponent / base)
    return sp.diff(expression, symbol)


def prune(stages: Sequence[Stage], wanted: Iterable[sp.Expr]) -> Stages:
    """The stages, without assignments that the wanted expressions do not need."""
    needed = required([a for stage in stages for a in stage.assignments], wanted)
    kept = (Stage(s.title, tuple(a for a in s.assignments if a[0] in needed)) for s in stages)
    return filled(kept)


def required(
    assignments: Sequence[tuple[sp.Symbol, sp.Expr]], wanted: Iterable[sp.Expr]
) -> set[sp.Symbol]:
    """Symbols on which expressions depend, directly or through assignments."""
    found: set[sp.Symbol] = set().union(*(sp.sympify(e).free_symbols for e in wanted))
    for symbol, expression in reversed(assignments):
        if symbol in found:
            found |= expression.free_symbols
    return found


def merged(first: Sequence[Stage], second: Sequence[Stage]) -> Stages:
    """Both lists of stages, without assigning a symbol twice."""
    known = {symbol for stage in first for symbol, _ in stage.assignments}
    rest = [
        Stage(s.title, tuple((x, e) for x, e in s.assignments if x not in known)) for s in second
    ]
    return (*first, *filled(rest))


def filled(stages: Iterable[Stage]) -> Stages:
    """Those of the stages that assign something."""
    return tuple(stage for stage in stages if stage.assignments)


def evaluate(
    stages: Sequence[Stage],
    expressions: Iterable[sp.Expr],
    values: Values,
    digits: int | None = None,
) -> list[sp.Expr]:
    """Expressions with every stage inserted, for reading and tests, as it is not fast.

    With `digits` every stage whose inputs are known becomes numbers of so many digits.
    """
    known = dict(values)

    def value(expression: sp.Expr) -> sp.Expr:
        found = sp.sympify(expression).xreplace(known)
        return found if digits is None else found.evalf(digits)

    for stage in stages:
        for symbol, expression in stage.assignments:
            known[symbol] = value(expression)
    return [value(e) for e in expressions]
