"""Symbols and expressions as LaTeX, in the order of terms and factors that a person would choose.

A symbol of the derivation is written by what it means, as the table says.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter

from nonsmooth.derive.declaration.algebra import cancel, factor, factor_terms, remembered
from nonsmooth.derive.document.blocks import width
from nonsmooth.derive.document.symbols import (
    GREEK,
    Responses,
    free,
    grouped_by,
    head,
    identifier,
    responses_of,
)
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol, inside, meaning_of

# LaTeX by meaning: a number is a part of the symbol, a word a letter that is free
_WRITTEN = {
    "state": "<0>^{(<1>)}",
    "reset": "<0>^{(<1>)+}",
    "derivative": r"\partial_{<1>} <0>",
    "carried": r"<0>|_{\Phi}",
    "on boundary": r"<0>|_{\Sigma}",
    "delay": "<0>",
    "cosine part": "a_{<0>}",
    "sine part": "b_{<0>}",
    "constant part": "c_{<0>}",
    "amplitude": "A_{<0>}",
    "rate": "<rate>_{<0>}",
    "cosine": r"\cos \theta_{<0>}",
    "sine": r"\sin \theta_{<0>}",
    "divisor": "<coefficient>_{<0>}",
    "coefficient": "<coefficient>_{<0>}",
    "right": "<right>_{<0>}",
    "determinant": "<determinant>",
    "numerator": "<numerator>_{<0>}",
    "without": "<0>^{[<1>]}",
    "equation": "F_{<0>}",
    "offset": "c_{<0>,<1><2>}",
}
# the first that the declaration leaves free
_LETTERS = {
    "coefficient": r"a \alpha \mathsf{a}",
    "right": r"b \beta \mathsf{b}",
    "determinant": r"D \Delta \mathsf{D}",
    "numerator": r"N \mathsf{N}",
    "factor": r"\gamma \varrho \mathsf{c}",
    "rate": r"s g \mathsf{s}",
}
# meanings of what a state is along an orbit, and of its derivatives
_OF_STATES = ("state", "reset", "derivative", "carried", "on boundary")
_WORD = r"[A-Za-z]\w*"
_SUM = rf"{_WORD}(?:\s*[-+*/]\s*{_WORD})*"
_EXPRESSION = re.compile(rf"(?<![-\w])(?:{_SUM}|\({_SUM}\))(?:\s*[-+*/]\s*(?:{_WORD}|\({_SUM}\)))*")
_HEAD = re.compile(r"\\?[A-Za-z]+(?:\{[^{}]*\})?")
# a symbol with indices, to which a power may be put
_LETTER = re.compile(r"\\?[A-Za-z]+(?:\{[A-Za-z]+\})?(?:_\{[^ ]*\})?")
# place of functions among the factors of a product
_FUNCTIONS = 5


@dataclass(eq=False)
class Printer(LatexPrinter):
    """LaTeX of the symbols and expressions of one document."""

    states: tuple[sp.Symbol, ...]
    constants: tuple[sp.Symbol, ...]  # parameters and the spectrum
    # symbols for values of functions of time, or for half a dwell time, and what they are
    functions: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    unknowns: tuple[sp.Symbol, ...] = ()
    # coordinates of the start, and the index of the state of each
    start: Mapping[sp.Symbol, int] = field(default_factory=dict)
    # mark of a state behind a phase, ``(2)`` or ``(2)+``, by its dwell time
    behind: Mapping[sp.Symbol, str] = field(default_factory=dict)
    # by configuration; their impulse responses have numbers
    flows: Mapping[str, Flow] = field(default_factory=dict)

    WIDEST = 34.0

    def __post_init__(self) -> None:
        LatexPrinter.__init__(self, {"mat_str": "matrix", "mat_delim": "("})

    def symbol(self, symbol: sp.Symbol) -> str:
        """LaTeX of a symbol, or of the value of a function of time that it stands for."""
        if symbol in self.functions:
            return self.latex(self.functions[symbol])
        if not isinstance(symbol, Symbol):
            return identifier(symbol.name)
        parts = [self._part(part) for part in symbol.parts]
        match symbol.meaning:
            case "written":
                return str(symbol.parts[1])
            case "constant":
                return _barred(parts[0])
            case "times":
                return _indexed(*parts)
            case "part":
                place, coordinate, dwell = symbol.parts
                state = f"{self.symbol(self.states[place])}^{{{self.behind[dwell]}}}"
                return _barred(state) if coordinate == 1 else _indexed(state, parts[1])
            case "spectrum" if parts[0] in _LETTERS:
                return f"{self.letter_for(parts[0])}_{{{parts[1]}}}"
            case meaning if meaning in _WRITTEN:
                return re.sub(
                    "<(\\w+)>",
                    lambda m: parts[int(m[1])] if m[1].isdigit() else self.letter_for(m[1]),
                    _WRITTEN[meaning],
                )
        latex = identifier(symbol.name)
        if latex in self.declared:  # the user's letter stays
            return latex.replace(head(latex), rf"\hat{{{head(latex)}}}", 1)
        return latex

    @cached_property
    def declared(self) -> frozenset[str]:
        """LaTeX of the symbols that the user has named."""
        every = (*self.states, *self.constants, *self.unknowns)
        return frozenset(identifier(s.name) for s in every if not isinstance(s, Symbol))

    def matrix_letter(self, letter: str) -> str:
        """Letter of a matrix, upright where the user has named something so."""
        return free((letter, rf"\mathsf{{{letter}}}"), self.declared)

    def with_formulas(self, text: str) -> str:
        """Text in which the names of symbols, and arithmetic with them, are set as formulas."""

        def formula(match: re.Match[str]) -> str:
            found = match[0]
            named = {word: self._named(word) for word in re.findall(_WORD, found)}
            if all(named.values()):
                return f"${re.sub(_WORD, lambda m: named[m[0]], found)}$"
            return re.sub(_WORD, lambda m: f"${named[m[0]]}$" if named[m[0]] else m[0], found)

        return _EXPRESSION.sub(formula, text)

    def plain(self, expression: sp.Expr) -> sp.Expr:
        """An expression with powers of time, and halves of dwell times, written out."""
        return sp.sympify(expression).xreplace(
            {s: e for s, e in self.functions.items() if not e.is_Function}
        )

    @remembered
    def tidy(self, expression: sp.Expr) -> sp.Expr:
        """An expression ordered for reading: state by state, with constants factored."""
        expression = self.plain(expression)
        if expression.has(sp.Function) or expression.is_Atom:
            return expression
        if any(p.exp == sp.Rational(1, 2) and p.base.is_Add for p in expression.atoms(sp.Pow)):
            return expression
        expression = sp.expand(expression)
        moving = expression.free_symbols - set(self.constants)
        grouped: dict[sp.Expr, dict[sp.Expr, sp.Expr]] = {}
        for monomial, part in grouped_by(expression, moving).items():
            states = filter(self.is_state, monomial.free_symbols)
            rest, state = monomial.as_independent(*states, as_Add=False)
            inner = grouped.setdefault(state, {})
            inner[rest] = inner.get(rest, sp.Integer(0)) + factor(cancel(part))
        sums: dict[sp.Expr, sp.Expr] = {}
        for state, inner in grouped.items():
            shared = factor_terms(sp.Add(*(r * f for r, f in inner.items())))
            if shared in (1, -1):
                sums[shared] = sums.get(shared, sp.Integer(0)) + state
            else:
                add_product(sums, shared, state)
        parts = [f * s if f.is_number else sp.Mul(f, s) for f, s in sums.items()]
        return factor_terms(sp.Add(*parts)) if len(parts) > 1 else sp.Add(*parts)

    def place(self, symbol: sp.Symbol) -> int | None:
        """Index of the state that a symbol is, at the start, behind a phase, or differentiated."""
        state = inside(symbol, *_OF_STATES)
        return self.start.get(symbol, self.states.index(state) if state in self.states else None)

    def is_state(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol is a state in this sense."""
        return self.place(symbol) is not None

    def is_function(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol stands for a value of a function, and needs no brackets behind it."""
        known = self.functions.get(symbol)
        return (known is not None and known.is_Function) or meaning_of(symbol) in ("cosine", "sine")

    def _part(self, part: object) -> str:
        """LaTeX of a part of a symbol."""
        return self.symbol(part) if isinstance(part, sp.Symbol) else str(part).replace("_", ",")

    def _named(self, word: str) -> str:
        """LaTeX of a name in a text; empty for another word."""
        if word in self._known and (len(word) > 1 or word.isupper()):
            return self.symbol(self._known[word])
        indexed = re.fullmatch(rf"[A-Za-z]{{1,2}}\d+|(?:{'|'.join(GREEK)})\d*", word)
        return identifier(word) if indexed else ""

    @cached_property
    def _known(self) -> dict[str, sp.Symbol]:
        return {str(s): s for s in (*self.unknowns, *self.constants, *self.states)}

    def letter_for(self, meaning: str) -> str:
        """Letter of linear equations, characteristic factors or rates."""
        return free(_LETTERS[meaning].split(), {head(identifier(name)) for name in self._known})

    @cached_property
    def responses(self) -> Responses:
        """Numbers of the factors of impulse responses."""
        return responses_of(self.flows.values(), map(self.symbol, self._known.values()))

    def latex(self, expression: Any) -> str:
        """LaTeX of an expression or a matrix; that of a 1 x 1 matrix is that of its entry."""
        if getattr(expression, "shape", None) == (1, 1):
            expression = expression[0]
        return str(self.doprint(expression))

    def _print_Symbol(self, symbol: sp.Symbol, style: str = "plain") -> str:
        return self.symbol(symbol)

    def _print_Add(self, expression: sp.Expr, order: Any = None) -> str:
        return self.sum(expression)

    _print_Mul = _print_Add

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
                add_product(shared, core, frequency * function)
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
        return self._term(expression, False)

    def term(self, term: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of a product; a sum behind a plus sign has no brackets."""
        return self._term(term, True)

    @remembered
    def _term(self, term: sp.Expr, alone: bool) -> tuple[int, str]:
        """Sign and LaTeX of a product, its sums turned so that numbers in them are positive.

        A sum that is `alone` behind a plus sign has no brackets.
        """
        number, rest = term.as_coeff_Mul()
        sign = -1 if number.is_negative else 1
        factors = list(sp.Mul.make_args(rest))
        roots = [f for f in factors if f.is_Pow and abs(f.exp) == sp.Rational(1, 2)]
        above, below = [abs(number).p, abs(number).q] if number.is_Rational else [abs(number), 1]
        above, below = [sp.sympify(above)], [sp.sympify(below)]
        for part in (f for f in factors if f not in roots):
            base, exponent = part.as_base_exp()
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
        if any(meaning_of(symbol) == "written" for symbol in factor.free_symbols):
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
        bracketed = meaning_of(base) == "written" and self._print(base).endswith(r"\right)")
        if base.is_Function or base == sp.E or bracketed:
            return _FUNCTIONS, str(factor)
        if meaning_of(base) == "derivative":
            return 4, str(factor)
        if base in self.constants:
            return 1, str(factor)
        return 2, str(factor)


def add_product(groups: dict[sp.Expr, sp.Expr], factor: sp.Expr, term: sp.Expr) -> None:
    """Add factor times term to a sum of products, in which factors differ by more than a sign."""
    key, term = (-factor, -term) if -factor in groups else (factor, term)
    groups[key] = groups.get(key, sp.Integer(0)) + term


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


def _indexed(latex: str, index: str) -> str:
    """LaTeX of a symbol with one more index."""
    head, raised, above = latex.partition("^")
    head = f"{head[:-1]},{index}}}" if "_{" in head else f"{head}_{{{index}}}"
    return f"{head}{raised}{above}"


def _barred(latex: str) -> str:
    """LaTeX of a symbol with a bar over its letter."""
    return _HEAD.sub(lambda letter: rf"\bar{{{letter[0]}}}", latex, count=1)
