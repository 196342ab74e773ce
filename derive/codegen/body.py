"""Bodies of emitted functions: stages with common subexpressions eliminated, once, here."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Set
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

import sympy as sp

from nonsmooth.derive.codegen.naming import free_name
from nonsmooth.derive.declaration.real_numbers import (
    map_numbers,
    nearest_double,
    number_text,
)
from nonsmooth.derive.equations.program import Array, Kernel, Stage, required
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import meaning_of

_Translation = Callable[[sp.Expr], sp.Expr]


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

    def sort_key(self, order: str | None = None) -> tuple[Any, ...]:
        """What SymPy orders it by: its text, where it would take the class for all constants."""
        return self.class_key(), (1, (self.text,)), sp.S.One.sort_key(), sp.S.One


@dataclass(frozen=True)
class Line:
    """One assignment; the first one of a stage has the stage's title."""

    symbol: sp.Symbol
    expression: sp.Expr
    title: str | None = None


@dataclass(frozen=True)
class Body:
    """What a kernel takes, its lines in order of evaluation, and what it gives.

    All symbols have different names, which are free in Python and in C. An output needs the lines
    up to its place in `ends`, and no later ones.
    """

    arguments: tuple[Array, ...]
    lines: tuple[Line, ...]
    outputs: tuple[Array, ...]
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
        return (*(line.expression for line in self.lines), *_results(self.outputs))


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
    # of the orders that were tried, the last entries of an argument first gives least operations
    inputs = [s for argument in kernel.arguments for s in reversed(argument.entries)]
    symbols = [*inputs, *(s for s, _ in _assignments(kernel))]
    prepared = _translated(kernel, _prepared)
    _check(prepared, {*symbols})
    places = {s: _renamed(s, f"s{i:06}") for i, s in enumerate(symbols)}
    body = _eliminated(_translated(prepared, lambda e: e.xreplace(places)))
    names = _names(kernel, symbols)
    written = {places[symbol]: _renamed(symbol, name) for symbol, name in names.items()}
    taken = {*names.values()}
    fresh = (s for s in sp.numbered_symbols("t", real=True) if s.name not in taken)
    written |= {line.symbol: next(fresh) for line in body.lines if line.symbol not in written}

    def named(expression: sp.Expr) -> sp.Expr:
        return expression.xreplace(written)

    return Body(
        _of_arrays(body.arguments, named),
        tuple(Line(named(x.symbol), named(x.expression), x.title) for x in body.lines),
        _of_arrays(body.outputs, named),
        body.ends,
    )


def _names(kernel: Kernel, symbols: Iterable[sp.Symbol]) -> dict[sp.Symbol, str]:
    """Different names of all symbols of a kernel, none of which is that of an array.

    That of an argument without a shape has the argument's name. Symbols of a declaration keep
    theirs, unless no kernel can have them; those of the derivation give way.
    """
    arrays = {*(a.name for a in kernel.arguments), *(o.name for o in kernel.outputs)}
    names = {a.entries[0]: a.name for a in kernel.arguments if not a.shape}
    taken = set(arrays)
    for symbol in sorted(
        (s for s in symbols if s not in names),
        key=lambda s: (meaning_of(s) != "", free_name(s.name, arrays) != s.name),
    ):
        names[symbol] = free_name(symbol.name, taken)
        taken.add(names[symbol])
    return names


def _renamed(symbol: sp.Symbol, name: str) -> sp.Symbol:
    return sp.Symbol(name, **symbol.assumptions0)


def _assignments(kernel: Kernel) -> list[tuple[sp.Symbol, sp.Expr]]:
    return [assignment for stage in kernel.stages for assignment in stage.assignments]


def _results(outputs: Iterable[Array]) -> list[sp.Expr]:
    return [e for output in outputs for e in output.entries]


def _translated(kernel: Kernel, translate: _Translation) -> Kernel:
    """A kernel with the translation of every symbol and every expression."""
    stages = (
        Stage(s.title, tuple((translate(x), translate(e)) for x, e in s.assignments))
        for s in kernel.stages
    )
    return replace(
        kernel,
        arguments=_of_arrays(kernel.arguments, translate),
        outputs=_of_arrays(kernel.outputs, translate),
        stages=tuple(stages),
    )


def _of_arrays(arrays: Iterable[Array], translate: _Translation) -> tuple[Array, ...]:
    return tuple(replace(a, entries=tuple(map(translate, a.entries))) for a in arrays)


def _eliminated(kernel: Kernel) -> Body:
    """The body of a kernel whose names are such that their order may decide."""
    symbols = [s for s, _ in _assignments(kernel)]
    right = [e for _, e in _assignments(kernel)]
    # a flat list: SymPy loses common subexpressions of nested ones
    common, reduced = sp.cse(
        [*right, *_results(kernel.outputs)],
        symbols=sp.numbered_symbols("t", real=True),
        order="none",
        list=True,
    )
    negatives = {s: e for s, e in common if (-e).is_Symbol}
    definitions = {s: e.xreplace(negatives) for s, e in common if s not in negatives}
    reduced = [e.xreplace(negatives) for e in reduced]
    renamed: dict[sp.Symbol, sp.Symbol] = {}
    told: dict[sp.Symbol, sp.Symbol] = {}
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
            if value.is_Symbol:  # it is known already, a common term from now on by this name
                renamed[symbol] = value
                if value in definitions:
                    told.setdefault(value, symbol)
            else:
                lines.append(Line(symbol, value))

    def titled(begin: int, title: str) -> None:
        if len(lines) > begin:
            lines[begin] = Line(lines[begin].symbol, lines[begin].expression, title)

    count = len(symbols)
    places = {symbol: place for place, symbol in enumerate(symbols)}
    left, outputs, ends = set(places), [], []
    for output in kernel.outputs:
        size = len(output.entries)
        expressions = reduced[count : count + size]
        count += size
        wanted = required(_assignments(kernel), output.entries)
        for stage in kernel.stages:
            begin = len(lines)
            for symbol, _ in stage.assignments:
                if symbol in wanted & left:
                    name(symbol, reduced[places[symbol]])
            titled(begin, stage.title)
        left -= wanted
        begin = len(lines)
        outputs.append(replace(output, entries=tuple(map(require, expressions))))
        titled(begin, output.name)
        ends.append(len(lines))

    def final(expression: sp.Expr) -> sp.Expr:
        return expression.xreplace(told)

    return Body(
        kernel.arguments,
        tuple(Line(final(x.symbol), final(x.expression), x.title) for x in lines),
        _of_arrays(outputs, final),
        tuple(ends),
    )


def _check(kernel: Kernel, defined: Set[sp.Symbol]) -> None:
    """Refuse, by DerivationError, a symbol without a value and a number that no kernel can hold."""
    for expression in (*(e for _, e in _assignments(kernel)), *_results(kernel.outputs)):
        unknown = sorted(expression.free_symbols - defined, key=str)
        if unknown:
            raise DerivationError(f"kernel {kernel.name!r}: {unknown[0]} has no value")
        if atoms := _not_held(expression):
            raise DerivationError(f"kernel {kernel.name!r}: no kernel holds {min(atoms, key=str)}")


@lru_cache(maxsize=1 << 14)
def _not_held(expression: sp.Expr) -> frozenset[sp.Expr]:
    """Symbolic constants in an expression that no kernel can evaluate, such as infinity."""
    constants = sp.NumberSymbol, sp.core.numbers.ImaginaryUnit, sp.zoo, sp.nan, sp.oo, -sp.oo
    return frozenset(expression.atoms(*constants))


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


def _by_number(symbol: sp.Symbol) -> tuple[int, str]:
    digits = symbol.name[1:]
    return (int(digits) if digits.isdigit() else -1, symbol.name)
