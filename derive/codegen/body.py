"""Bodies of emitted functions: stages with common subexpressions eliminated, once, here."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import sympy as sp

from nonsmooth.derive.codegen.naming import RESERVED
from nonsmooth.derive.declaration.real_numbers import (
    map_numbers,
    nearest_double,
    number_text,
)
from nonsmooth.derive.equations.program import Kernel, Stage, prune
from nonsmooth.derive.errors import DerivationError

__all__ = ["Body", "Constant", "Line", "body_of", "needed", "split"]


class Constant(sp.AtomicExpr):
    """An irrational number of a kernel as one number without parts.

    `number` is the SymPy expression, `text` the same in the grammar of parameter values,
    and `double` the nearest double.
    """

    is_real = True
    number: sp.Expr
    text: str
    double: float

    def __new__(cls, number: sp.Expr) -> Constant:
        """Make the constant of a closed number."""
        made: Constant = super().__new__(cls)
        made.number = number
        made.text, made.double = number_text(number), nearest_double(number)
        return made

    def _eval_evalf(self, prec: int) -> sp.Expr:
        return self.number._eval_evalf(prec)

    def _hashable_content(self) -> tuple[str, ...]:
        return (self.text,)


@dataclass(frozen=True)
class Line:
    """One assignment; the first one of a stage has the stage's title."""

    symbol: sp.Symbol
    expression: sp.Expr
    title: str | None = None


@dataclass(frozen=True)
class Body:
    """The lines of a kernel in order of evaluation, and the expressions of its outputs.

    An output needs the lines up to its place in `ends`, and no later ones.
    """

    lines: tuple[Line, ...]
    outputs: tuple[tuple[sp.Expr, ...], ...]
    ends: tuple[int, ...]

    @property
    def parts(self) -> tuple[tuple[Line, ...], ...]:
        """The lines that each output needs beside those of the outputs before it."""
        begins = (0, *self.ends)
        return tuple(self.lines[a:b] for a, b in zip(begins, self.ends, strict=False))

    @cached_property
    def used(self) -> frozenset[sp.Symbol]:
        """Symbols that lines or outputs contain."""
        return frozenset().union(*(e.free_symbols for e in self._expressions))

    @cached_property
    def operations(self) -> int:
        """Number of arithmetic operations and function calls."""
        return sum(map(_operations, self._expressions))

    @property
    def _expressions(self) -> tuple[sp.Expr, ...]:
        outputs = (e for output in self.outputs for e in output)
        return (*(line.expression for line in self.lines), *outputs)


@lru_cache(maxsize=1 << 14)
def _operations(expression: sp.Expr) -> int:
    return int(sp.count_ops(expression))


@lru_cache(maxsize=1 << 14)  # kernels of one orbit share most of their expressions
def _prepared(expression: sp.Expr) -> sp.Expr:
    """The expression with its irrational numbers as constants."""
    found: sp.Expr = map_numbers(expression, Constant)
    return found


@lru_cache(maxsize=256)  # Python and C are printed from one body
def body_of(kernel: Kernel) -> Body:
    """The body of a kernel, its common subexpressions eliminated.

    The symbols of the stages stay; each common term is assigned right before its first use.
    SymPy sorts by name: meanwhile every symbol has a name that only tells its place.
    """
    prepared = _translated(kernel, _prepared)
    taken = _checked_names(prepared)
    # of the orders that were tried, the last entries of an argument first gives least operations
    inputs = tuple(s for argument in kernel.arguments for s in reversed(argument.symbols))
    places = _places([*inputs, *(s for s, _ in _assignments(kernel))])
    body = _eliminated(_translated(prepared, lambda e: e.xreplace(places)))
    return _named(body, places, taken)


def _places(symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Symbol]:
    """A symbol in place of each, such that SymPy sorts them as they are given."""
    return {s: sp.Symbol(f"s{i:06}", **s.assumptions0) for i, s in enumerate(symbols)}


def _named(body: Body, places: Mapping[sp.Symbol, sp.Symbol], taken: set[str]) -> Body:
    """The body with the symbols again that have places, and numbered ones for all others."""
    names = {place: symbol for symbol, place in places.items()}
    fresh = (s for s in sp.numbered_symbols("t", real=True) if s.name not in taken)
    names |= {line.symbol: next(fresh) for line in body.lines if line.symbol not in names}
    return Body(
        tuple(Line(names[x.symbol], x.expression.xreplace(names), x.title) for x in body.lines),
        tuple(tuple(e.xreplace(names) for e in output) for output in body.outputs),
        body.ends,
    )


def _assignments(kernel: Kernel) -> list[tuple[sp.Symbol, sp.Expr]]:
    return [assignment for stage in kernel.stages for assignment in stage.assignments]


def _results(kernel: Kernel) -> list[sp.Expr]:
    return [e for output in kernel.outputs for e in output.expressions]


def _translated(kernel: Kernel, translate: Callable[[sp.Expr], sp.Expr]) -> Kernel:
    """A kernel with the translation of every symbol that it assigns, and of every expression."""
    stages = (
        Stage(s.title, tuple((translate(x), translate(e)) for x, e in s.assignments))
        for s in kernel.stages
    )
    outputs = (replace(o, expressions=tuple(map(translate, o.expressions))) for o in kernel.outputs)
    return replace(kernel, stages=tuple(stages), outputs=tuple(outputs))


def _eliminated(kernel: Kernel) -> Body:
    """The body of a kernel whose names are such that their order may decide."""
    symbols = [s for s, _ in _assignments(kernel)]
    right = [e for _, e in _assignments(kernel)]
    # a flat list: SymPy loses common subexpressions of nested ones
    common, reduced = sp.cse(
        [*right, *_results(kernel)],
        symbols=sp.numbered_symbols("t", real=True),
        order="none",
        list=True,
    )
    negatives = {s: e for s, e in common if (-e).is_Symbol}
    definitions = {s: e.xreplace(negatives) for s, e in common if s not in negatives}
    reduced = [e.xreplace(negatives) for e in reduced]
    renamed: dict[sp.Symbol, sp.Symbol] = {}
    lines: list[Line] = []
    done: set[sp.Symbol] = set()

    def require(expression: sp.Expr) -> sp.Expr:
        for symbol in sorted(expression.free_symbols, key=_by_number):
            if symbol in definitions and symbol not in done:
                definition = require(definitions[symbol])
                done.add(symbol)
                lines.append(Line(symbol, definition))
        return expression.xreplace(renamed)

    def name(symbol: sp.Symbol, expression: sp.Expr) -> None:
        if expression in definitions and expression not in done:
            # the common term gets the stage's own name instead of a second one
            definition = require(definitions[expression])
            done.add(expression)
            renamed[expression] = symbol
            lines.append(Line(symbol, definition))
        else:
            value = require(expression)
            lines.append(Line(symbol, value))

    def titled(begin: int, title: str) -> None:
        if len(lines) > begin:
            lines[begin] = Line(lines[begin].symbol, lines[begin].expression, title)

    count = len(symbols)
    places = {symbol: place for place, symbol in enumerate(symbols)}
    left, outputs, ends = set(places), [], []
    for output in kernel.outputs:
        size = len(output.expressions)
        expressions = reduced[count : count + size]
        count += size
        wanted = {
            s for stage in prune(kernel.stages, output.expressions) for s, _ in stage.assignments
        }
        for stage in kernel.stages:
            begin = len(lines)
            for symbol, _ in stage.assignments:
                if symbol in wanted & left:
                    name(symbol, reduced[places[symbol]])
            titled(begin, stage.title)
        left -= wanted
        begin = len(lines)
        outputs.append(tuple(require(e) for e in expressions))
        titled(begin, output.name)
        ends.append(len(lines))
    return Body(tuple(lines), tuple(outputs), tuple(ends))


def _checked_names(kernel: Kernel) -> set[str]:
    """Names of the symbols of a kernel.

    DerivationError refuses a symbol without a value, a name with two meanings, and a number
    that no kernel can hold.
    """
    assignments = _assignments(kernel)
    expressions = [*(e for _, e in assignments), *_results(kernel)]
    defined = {*(s for a in kernel.arguments for s in a.symbols), *(s for s, _ in assignments)}
    # an argument without a shape may bear the name of its symbol
    arrays = {a.name for a in kernel.arguments if a.shape or a.name != a.symbols[0].name}
    arrays |= {o.name for o in kernel.outputs}
    owners: dict[str, sp.Symbol] = {}
    for symbol in sorted(defined, key=str):
        name = symbol.name
        if owners.setdefault(name, symbol) != symbol or name in arrays | RESERVED:
            raise DerivationError(f"kernel {kernel.name!r}: the name {name!r} is taken; rename it")
    for expression in expressions:
        unknown = sorted(expression.free_symbols - defined, key=str)
        if unknown:
            raise DerivationError(f"kernel {kernel.name!r}: {unknown[0]} has no value")
        if atoms := _not_held(expression):
            raise DerivationError(f"kernel {kernel.name!r}: no kernel holds {min(atoms, key=str)}")
    return set(owners)


@lru_cache(maxsize=1 << 14)
def _not_held(expression: sp.Expr) -> frozenset[sp.Expr]:
    """Symbolic constants in an expression that no kernel can evaluate, such as infinity."""
    symbolic = expression.atoms(sp.NumberSymbol, sp.core.numbers.ImaginaryUnit)
    return frozenset(symbolic | expression.atoms(sp.zoo, sp.nan, sp.oo, -sp.oo))


def split(body: Body, inputs: set[sp.Symbol]) -> tuple[tuple[Line, ...], tuple[Line, ...]]:
    """Lines that depend on the given inputs alone, and the rest, both in order."""
    known = set(inputs)
    fixed, moving = [], []
    for line in body.lines:
        if line.expression.free_symbols <= known:
            known.add(line.symbol)
            fixed.append(line)
        else:
            moving.append(line)
    return tuple(fixed), tuple(moving)


def needed(lines: Sequence[Line], expressions: Iterable[sp.Expr]) -> tuple[Line, ...]:
    """Those lines on which the expressions depend, in order."""
    wanted: set[sp.Symbol] = set().union(*(e.free_symbols for e in expressions))
    kept = []
    for line in reversed(lines):
        if line.symbol in wanted:
            wanted |= line.expression.free_symbols
            kept.append(line)
    return tuple(reversed(kept))


def _by_number(symbol: sp.Symbol) -> tuple[int, str]:
    digits = symbol.name[1:]
    return (int(digits) if digits.isdigit() else -1, symbol.name)
