"""Expressions as LaTeX, in the order of terms and factors that a person would choose."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter

from nonsmooth.derive.declaration.algebra import remembered
from nonsmooth.derive.document.blocks import width
from nonsmooth.derive.document.symbols import Symbols, grouped_by, is_written
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.symbols import meaning_of

# a symbol with indices, to which a power may be put
_LETTER = re.compile(r"\\?[A-Za-z]+(?:\{[A-Za-z]+\})?(?:_\{[^ ]*\})?")
# place of functions among the factors of a product
_FUNCTIONS = 5


@dataclass(eq=False)
class Notation(Symbols, LatexPrinter):
    """LaTeX of the symbols and expressions of one document."""

    WIDEST = 34.0

    def __post_init__(self) -> None:
        LatexPrinter.__init__(self, {"mat_str": "matrix", "mat_delim": "("})

    def symbol(self, symbol: sp.Symbol) -> str:
        """LaTeX of a symbol, or of the value of a function of time that it stands for."""
        if symbol in self.functions:
            return self.latex(self.functions[symbol])
        return super().symbol(symbol)

    def latex(self, expression: Any) -> str:
        """LaTeX of an expression or a matrix; that of a 1 x 1 matrix is that of its entry."""
        if getattr(expression, "shape", None) == (1, 1):
            expression = expression[0]
        return str(self.doprint(expression))

    def _print_Symbol(self, symbol: sp.Symbol, style: str = "plain") -> str:
        return self.symbol(symbol)

    def _print_Add(self, expression: sp.Add, order: Any = None) -> str:
        return self.sum(expression)

    def _print_Mul(self, expression: sp.Mul) -> str:
        return self.sum(expression)

    def _print_Pow(self, expression: sp.Pow) -> str:
        if expression.exp.is_Rational and expression.exp.is_negative:
            return self._print_Mul(expression)
        if expression.exp == sp.Rational(1, 2):
            return rf"\sqrt{{{self.radicand(expression.base)}}}"
        base = self.functions.get(expression.base, expression.base)
        if base.is_Symbol and not _LETTER.fullmatch(self._print(base)):
            return rf"\left({self._print(base)}\right)^{{{self._print(expression.exp)}}}"
        if base != expression.base:
            return str(self._print(base**expression.exp))
        return str(super()._print_Pow(expression))

    def _print(self, expression: Any, **settings: Any) -> str:
        # SymPy's number knows its own letter, which a parameter may have
        return r"\mathrm{e}" if expression is sp.E else str(super()._print(expression, **settings))

    def _print_ExpBase(self, expression: sp.Expr, exp: str | None = None) -> str:
        power = rf"\mathrm{{e}}^{{{self._print(expression.exp)}}}"
        return power if exp is None else rf"\left({power}\right)^{{{exp}}}"

    def _print_cos(self, expression: sp.Expr, exp: str | None = None) -> str:
        # without brackets around a product of symbols
        argument = expression.args[0]
        number, rest = argument.as_coeff_Mul()
        plain = rest == 1 or all(map(self.is_letter, sp.Mul.make_args(rest)))
        head = rf"\{type(expression).__name__}" + (f"^{{{exp}}}" if exp else "")
        if plain and number.is_Rational and number.q > 1:
            return f"{head}({self._print(number.p * rest)}/{number.q})"
        text = self._print(argument)
        return f"{head} {text}" if plain else rf"{head}\left({text}\right)"

    _print_sin = _print_cos

    def _print_Angle(self, expression: sp.Expr) -> str:
        sine, cosine = (self._print(a) for a in expression.args)
        return rf"\operatorname{{arg}}\left({cosine} + \mathrm{{i}} {sine}\right)"

    def _print_ExponentialDifference(self, expression: sp.Expr, exp: str | None = None) -> str:
        order, time, *factors = expression.args
        text = self.responses.latex(int(order), tuple(factors), self._print(time))
        return text if exp is None else rf"\left({text}\right)^{{{exp}}}"

    def radicand(self, base: sp.Expr) -> str:
        """LaTeX of what stands below a root: one fraction, unless its terms have denominators."""
        if not base.is_Add:
            return str(self._print(base))
        if any(sp.fraction(a)[1].free_symbols for a in base.args):
            number, rest = sp.factor_terms(base).as_coeff_Mul()
            inner = self.sum(rest)
            return inner if number == 1 else rf"{self._print(number)} \left({inner}\right)"
        return str(self._print(sp.together(base)))

    def is_letter(self, factor: sp.Expr) -> bool:
        """Whether a factor is written as one letter, with indices and labels."""
        letter = self._print(factor).partition("^{(")[0] if factor.is_Symbol else ""
        return _LETTER.fullmatch(letter) is not None

    @remembered
    def ordered(self, expression: sp.Expr) -> tuple[sp.Expr, ...]:
        """Terms of a sum in the order of reading."""
        number, rest = expression.as_coeff_Mul()
        if number == -1 and rest.is_Add:
            # a minus sign in front of a sum that stands alone goes to its terms
            expression = -rest
        terms = list(sp.Add.make_args(expression))
        negative = {a: self.term(a)[0] < 0 for a in terms}
        ranks = {a: self.rank(a) for a in terms}
        terms.sort(key=lambda a: (*ranks[a][:2], negative[a], ranks[a][2:]))
        leading = sp.Mul.make_args(terms[0])
        if negative[terms[0]] and (len(terms) == 2 or not any(f.is_Add for f in leading)):
            # a short sum begins with a positive term if it has one
            first = next((a for a in terms if not negative[a]), terms[0])
            terms.remove(first)
            terms.insert(0, first)
        return tuple(terms)

    def by_function(self, expression: sp.Expr) -> tuple[sp.Expr, ...]:
        """Terms of a sum: each function of time once, times its coefficient, then the rest."""
        expression = sp.expand(self.plain(expression))
        known = list(self.functions)
        functions = sorted(
            (s for s in expression.free_symbols if self.is_function(s)),
            key=lambda s: (self.is_sine(s), known.index(s) if s in known else -1, str(s)),
        )
        collected = grouped_by(expression, functions)
        order = {f: i for i, f in enumerate(functions)}
        inner = {a for s in functions if s in known for a in self.functions[s].free_symbols}
        # functions with one coefficient, but for frequencies, share it
        shared: dict[sp.Expr, sp.Expr] = {}
        terms: list[sp.Expr] = []
        for function in sorted(collected, key=lambda f: (order.get(f, len(order)), str(f))):
            coefficient = self.tidy(collected[function])
            moving = coefficient.free_symbols - inner
            frequency, core = coefficient.as_independent(*moving, as_Add=False)
            if function == 1 or not moving:
                terms.append(coefficient * function)
            else:
                core, frequency = (-core, -frequency) if -core in shared else (core, frequency)
                shared[core] = shared.get(core, sp.Integer(0)) + frequency * function
        return (*(sp.Mul(core, total) for core, total in shared.items()), *terms)

    def is_sine(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol stands for a sine."""
        return isinstance(self.functions.get(symbol), sp.sin) or meaning_of(symbol) == "sine"

    def sum(self, expression: sp.Expr) -> str:
        """LaTeX of a sum in the order of reading."""
        return " ".join(with_signs(map(self.term, self.ordered(expression))))

    def pieces(self, expression: sp.Expr) -> tuple[str, ...]:
        """LaTeX of a sum, cut in front of every sign at which a line may break."""
        return self.signed(self.ordered(sp.sympify(expression)))

    def signed(self, terms: Iterable[sp.Expr]) -> tuple[str, ...]:
        """LaTeX of the terms of a sum in the given order, each with its sign; wide ones are cut."""
        terms, found = list(terms), list[str]()
        for term, text in zip(terms, with_signs(map(self.term, terms)), strict=True):
            found += self.cut(term, text, leading=not found)
        return tuple(found)

    def cut(self, term: sp.Expr, text: str, *, leading: bool) -> tuple[str, ...]:
        """LaTeX of a term of a sum, cut inside its own sums if its `text` is too wide.

        A `leading` term, the first of the sum, has no plus sign.
        """
        sums = [f for f in sp.Mul.make_args(term) if f.is_Add]
        if width(text) <= self.WIDEST or not sums:
            return (text,)
        inner = max(sums, key=lambda s: len(s.args))
        others = [f for f in sp.Mul.make_args(term) if f is not inner]
        behind = [f for f in others if self.order_of(f)[0] >= _FUNCTIONS]
        sign, outer = self.factor(sp.Mul(*(f for f in others if f not in behind)))
        head = "- " if sign < 0 else "" if leading else "+ "
        head += rf"{'' if outer == '1' else outer} \biggl("
        first, *rest = self.pieces(inner)
        # a line may break behind an opening bracket where there is no room for both
        found = [f"{head}{first}"] if width(head + first) <= self.WIDEST else [head, first]
        found += rest
        found[-1] += rf"\biggr) {self.product(behind, alone=False)}".rstrip()
        return tuple(found)

    @remembered
    def rank(self, term: sp.Expr) -> tuple[int, int, int, str]:
        """Sort key of a term in a sum: states in order, other unknowns, constants."""
        symbols = term.free_symbols
        places = [place for s in symbols if (place := self.place(s)) is not None]
        if places:
            return 0, min(places), 0, str(term)
        if any(s not in self.constants for s in symbols):
            return 1, 0, int(not term.is_Symbol), str(term)
        return 2, min((self.constants.index(s) + 1 for s in symbols), default=0), 0, str(term)

    def factor(self, expression: sp.Expr) -> tuple[int, str]:
        """Sign of an expression, and LaTeX to which other factors may be put."""
        return self.term(expression, alone=False)

    def term(self, term: sp.Expr, *, alone: bool = True) -> tuple[int, str]:
        """Sign and LaTeX of a product; a sum that is `alone` behind a plus sign has no brackets."""
        return self._term(term, alone)

    @remembered
    def _term(self, term: sp.Expr, alone: bool) -> tuple[int, str]:
        """Sign and LaTeX of a product, its sums turned so that numbers in them are positive."""
        number, rest = term.as_coeff_Mul()
        sign = -1 if number.is_negative else 1
        factors = list(sp.Mul.make_args(rest))
        roots = [f for f in factors if f.is_Pow and abs(f.exp) == sp.Rational(1, 2)]
        above, below = [abs(number).p, abs(number).q] if number.is_Rational else [abs(number), 1]
        above, below = [sp.sympify(above)], [sp.sympify(below)]
        for factor in (f for f in factors if f not in roots):
            base, exponent = factor.as_base_exp()
            if base.is_Add and exponent.is_Integer and exponent % 2 and self.looks_negative(base):
                base, sign = -base, -sign
            if exponent.is_Rational and exponent < 0:
                below.append(base**-exponent)
            else:
                above.append(base**exponent)
        if roots:
            radicand = sp.Mul(*(f.base ** (2 * f.exp) for f in roots))
            radicand = radicand if len(roots) == 1 else sp.together(radicand)
            above.append(sp.Pow(radicand, sp.Rational(1, 2), evaluate=False))
        if sign < 0:
            turned = next((i for i, f in enumerate(above) if self.turnable(f)), None)
            if turned is not None:
                above[turned], sign = -above[turned], 1
        above = [f for f in above if f != 1]
        below = [f for f in below if f != 1]
        if not below:
            return sign, self.product(above, alone=alone and sign > 0) or "1"
        outside = [f for f in above if isinstance(f, Angle) or _is_root_of_fraction(f)]
        sums = [f for f in above if f.is_Add]
        beside_function = any(self.order_of(f)[0] >= _FUNCTIONS for f in above)
        nested = any(r"\frac" in self._print(f) for f in sums)
        constant = set().union(*(f.free_symbols for f in sums)) <= set(self.constants)
        over_sum = constant and any(f.is_Add for f in below)
        if nested or (len(above) > len(sums) and not beside_function and not over_sum):
            outside += sums
        inside = [f for f in above if f not in outside]
        text = rf"\frac{{{self.product(inside) or '1'}}}{{{self.product(below)}}}"
        return sign, " ".join(filter(None, (text, self.product(outside, alone=False))))

    def looks_negative(self, expression: sp.Add) -> bool:
        """Whether a sum reads better turned: its number, or every term of it, is negative."""
        number = expression.as_coeff_Add()[0]
        if number != 0:
            return bool(number.is_negative)
        return all(self.term(a)[0] < 0 for a in expression.args)

    def turnable(self, factor: sp.Expr) -> bool:
        """Whether a sum can take up a minus sign in front of it."""
        if not factor.is_Add or factor.as_coeff_Add()[0] != 0:
            return False
        if any(map(is_written, factor.free_symbols)):
            return False
        return any(self.term(a)[0] < 0 for a in factor.args)

    def product(self, factors: Sequence[sp.Expr], *, alone: bool = True) -> str:
        """LaTeX of factors side by side: constants, states, sums, and functions last."""
        ordered = sorted(factors, key=self.order_of)
        if alone and len(ordered) == 1:
            return str(self._print(ordered[0]))
        texts = [rf"\left({self._print(f)}\right)" if f.is_Add else self._print(f) for f in ordered]
        # digits side by side would be one number
        return " ".join(
            rf"\cdot {text}" if place and text[0].isdigit() else text
            for place, text in enumerate(texts)
        )

    @remembered
    def order_of(self, factor: sp.Expr) -> tuple[int, str]:
        """Sort key of a factor in a product."""
        base = factor.as_base_exp()[0]
        if base.is_number and not isinstance(base, sp.cos | sp.sin):
            return 0, str(factor)
        if base.is_Add:
            moving = any(map(self.is_function, base.free_symbols))
            return 3, f"{int(moving)} {factor}"
        if isinstance(base, sp.cos | sp.sin) or self.is_function(base):
            # without brackets of its own it ends a product
            bracketed = isinstance(self.functions.get(base), ExponentialDifference)
            return _FUNCTIONS + (0 if bracketed else 1), str(factor)
        bracketed = is_written(base) and self._print(base).endswith(r"\right)")
        if base.is_Function or base == sp.E or bracketed:
            return _FUNCTIONS, str(factor)
        if meaning_of(base) == "derivative":
            return 4, str(factor)
        if base in self.constants:
            return 1, str(factor)
        return 2, str(factor)


def with_signs(terms: Iterable[tuple[int, str]]) -> tuple[str, ...]:
    """Pieces of a sum of terms, each given by its sign and its LaTeX without it."""
    return tuple(
        f"- {text}" if sign < 0 else f"+ {text}" if place else text
        for place, (sign, text) in enumerate(terms)
    )


def _is_root_of_fraction(factor: sp.Expr) -> bool:
    return bool(
        factor.is_Pow and factor.exp == sp.Rational(1, 2) and sp.fraction(factor.base)[1] != 1
    )
