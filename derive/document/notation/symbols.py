"""Notation: how symbols and expressions of the derivation are written in LaTeX.

A name of a declaration is letters and digits: Greek names become Greek letters, digits an index,
the second of two letters joins the index (``us1`` is u_{s1}, ``ta`` is t_a, ``z10`` is z_{10}).
A symbol of the derivation is written by what it means: values of a flow's functions as what they
are, cos(omega_1 tau_1), and all others as `Notation.symbol` says.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration import algebra
from nonsmooth.derive.document.notation.printer import Printer
from nonsmooth.derive.document.notation.responses import Responses, responses_of
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol, inside, meaning_of

__all__ = ["Notation", "identifier"]

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
    " upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = tuple(_GREEK_NAMES.split())
_WORDS = {"gap": r"\Delta", "mean": r"\mu", "spread": r"\delta"}
# of linear equations, characteristic factors and rates: the first that the declaration leaves free
_LINEAR = {
    "coefficient": ("a", r"\alpha", r"\mathsf{a}"),
    "right": ("b", r"\beta", r"\mathsf{b}"),
    "determinant": ("D", r"\Delta", r"\mathsf{D}"),
    "numerator": ("N", r"\mathsf{N}"),
    "factor": (r"\gamma", r"\varrho", r"\mathsf{c}"),
    "rate": ("s", "g", r"\mathsf{s}"),
}
_RETURN = {"cosine part": "a", "sine part": "b", "constant part": "c", "amplitude": "A"}
_NAME = re.compile(r"([A-Za-z]+?)(\d*)((?:_\w+)?)")
_LETTER = re.compile(r"\\?[A-Za-z]+(?:\{[^{}]*\})?")
# meanings of what a state is along an orbit, and of its derivatives
_OF_STATES = ("state", "reset", "derivative", "carried", "on boundary")
_WORD = r"[A-Za-z]\w*"
_SUM = rf"{_WORD}(?:\s*[-+*/]\s*{_WORD})*"
_EXPRESSION = re.compile(rf"(?<![-\w])(?:{_SUM}|\({_SUM}\))(?:\s*[-+*/]\s*(?:{_WORD}|\({_SUM}\)))*")


@dataclass(frozen=True)
class Notation:
    """LaTeX of the symbols and expressions of one document."""

    states: tuple[sp.Symbol, ...]
    constants: tuple[sp.Symbol, ...]  # parameters and the spectrum
    # symbols for values of functions of time, or for half a dwell time, and what they are
    functions: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    unknowns: tuple[sp.Symbol, ...] = ()
    # coordinates of the start, and the index of the state of each
    start: Mapping[sp.Symbol, int] = field(default_factory=dict)
    projectors: tuple[sp.Symbol, ...] = ()  # symbols of the spectrum that are entries of projectors
    # numbers of the factors of impulse responses
    responses: Responses = field(default_factory=Responses)
    # mark of a state behind a phase, ``(2)`` or ``(2)+``, by its dwell time
    behind: Mapping[sp.Symbol, str] = field(default_factory=dict)

    def with_responses(self, flows: Iterable[Flow]) -> Notation:
        """The same notation, with numbers for the factors of the flows' impulse responses."""
        symbols = (*self.states, *self.constants, *self.unknowns)
        return replace(self, responses=responses_of(flows, map(self.symbol, symbols)))

    def symbol(self, symbol: sp.Symbol) -> str:
        """LaTeX of a symbol."""
        if symbol in self.functions:
            return self.latex(self.functions[symbol])
        if not isinstance(symbol, Symbol):
            return identifier(symbol.name)
        parts = symbol.parts
        first = self.symbol(parts[0]) if parts and isinstance(parts[0], sp.Symbol) else ""
        match symbol.meaning:
            case "written":
                return str(parts[1])
            case "derivative":
                return rf"\partial_{{{self.symbol(parts[1])}}} {first}"
            case "state":
                return f"{first}^{{({parts[1]})}}"
            case "reset":
                return f"{first}^{{({parts[1]})+}}"
            case "on boundary":
                return rf"{first}|_{{\Sigma}}"
            case "carried":
                return rf"{first}|_{{\Phi}}"
            case "delay":
                return first
            case "without":
                return f"{first}^{{[{parts[1]}]}}"
            case "times":
                return _indexed(first, self.symbol(parts[1]))
            case "constant":
                return _barred(first)
            case "divisor":
                return f"{self.letter('coefficient')}_{{{first}}}"
            case "part":
                place, coordinate, dwell = parts
                state = f"{self.symbol(self.states[place])}^{{{self.behind[dwell]}}}"
                bare = coordinate == 1
                return _barred(state) if bare else _indexed(state, self.symbol(coordinate))
            case "cosine" | "sine":
                return rf"\{symbol.meaning[:3]} \theta_{{{first}}}"
            case "offset":
                return identifier(symbol.name)
            case "equation":
                return f"F_{{{parts[0]}}}"
            case meaning if meaning in _RETURN:
                return f"{_RETURN[meaning]}_{{{first}}}"
            case "rate":
                return f"{self.letter('rate')}_{{{first or parts[0]}}}"
            case "spectrum" if parts[0] not in _LINEAR:
                return identifier(symbol.name)
            case "spectrum":
                return f"{self.letter(parts[0])}_{{{parts[1]}}}"
            case "coefficient" | "right" | "numerator":
                index = str(parts[0]).replace("_", ",")
                return f"{self.letter(symbol.meaning)}_{{{index}}}"
            case "determinant":
                return self.letter("determinant")
        return identifier(symbol.name)

    def latex(self, expression: Any) -> str:
        """LaTeX of an expression or a matrix; that of a 1 x 1 matrix is that of its entry."""
        if getattr(expression, "shape", None) == (1, 1):
            expression = expression[0]
        return str(self._printer.doprint(expression))

    def pieces(self, expression: sp.Expr) -> tuple[str, ...]:
        """LaTeX of a sum, cut in front of every sign at which a line may break."""
        return self._printer.pieces(sp.sympify(expression))

    def cut(self, term: sp.Expr, text: str, *, leading: bool) -> tuple[str, ...]:
        """LaTeX of a term of a sum, with its sign, cut where it is too wide for a line."""
        return self._printer.cut(term, text, leading=leading)

    def prose(self, text: str) -> str:
        """Text in which the names of symbols, and arithmetic with them, are set as formulas."""

        def formula(match: re.Match[str]) -> str:
            found = match[0]
            words = re.findall(_WORD, found)
            if not all(self._is_name(w) for w in words):
                return found if len(words) == 1 else re.sub(_WORD, single, found)
            return f"${re.sub(_WORD, lambda m: self._named(m[0]), found)}$"

        def single(match: re.Match[str]) -> str:
            return f"${self._named(match[0])}$" if self._is_name(match[0]) else match[0]

        return _EXPRESSION.sub(formula, text)

    def plain(self, expression: sp.Expr) -> sp.Expr:
        """An expression with powers of time, and halves of dwell times, written out."""
        return sp.sympify(expression).xreplace(
            {s: e for s, e in self.functions.items() if not e.is_Function}
        )

    def tidy(self, expression: sp.Expr) -> sp.Expr:
        """An expression ordered for reading: state by state, with constants factored."""
        expression = self.plain(expression)
        if expression.has(sp.Function) or expression.is_Atom:
            return expression
        if any(p.exp == sp.Rational(1, 2) and p.base.is_Add for p in expression.atoms(sp.Pow)):
            return expression
        collected: dict[sp.Expr, sp.Expr] = {}
        for term in sp.Add.make_args(sp.expand(expression)):
            moving = sorted(term.free_symbols - set(self.constants), key=str)
            factor, monomial = term.as_independent(*moving, as_Add=False)
            collected[monomial] = collected.get(monomial, sp.Integer(0)) + factor
        grouped: dict[sp.Expr, dict[sp.Expr, sp.Expr]] = {}
        for monomial, factor in collected.items():
            states = sorted((s for s in monomial.free_symbols if self.is_state(s)), key=str)
            rest, state = monomial.as_independent(*states, as_Add=False)
            inner = grouped.setdefault(state, {})
            inner[rest] = inner.get(rest, sp.Integer(0)) + algebra.factor(algebra.cancel(factor))
        sums: dict[sp.Expr, sp.Expr] = {}
        for state, inner in grouped.items():
            factor = sp.factor_terms(sp.Add(*(r * f for r, f in inner.items())))
            # states with one factor up to its sign share it
            opposite = next((f for f in sums if f == -factor), None)
            if factor == 1 or factor == -1 or (factor not in sums and opposite is None):
                key, sign = factor, 1
            else:
                key, sign = (factor, 1) if opposite is None else (opposite, -1)
            sums[key] = sums.get(key, sp.Integer(0)) + sign * state
        parts = [f * s if f.is_number else sp.Mul(f, s) for f, s in sums.items()]
        return sp.factor_terms(sp.Add(*parts)) if len(parts) > 1 else sp.Add(*parts)

    def is_state(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol is a state, also at the start or behind a phase, or its derivative."""
        return symbol in self.start or inside(symbol, *_OF_STATES) in self.states

    def place(self, symbol: sp.Symbol) -> int:
        """Index of the state to which a symbol belongs."""
        if symbol in self.start:
            return self.start[symbol]
        return self.states.index(inside(symbol, *_OF_STATES))

    def is_function(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol stands for a value of a function, and needs no brackets behind it."""
        known = self.functions.get(symbol)
        return (known is not None and known.is_Function) or meaning_of(symbol) in ("cosine", "sine")

    def letter(self, meaning: str) -> str:
        """Letter of linear equations, characteristic factors and rates."""
        return self._linear[meaning]

    def term(self, term: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of a term of a sum."""
        return self._printer.term(term)

    def factor(self, factor: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of a factor; a sum is set in brackets."""
        return self._printer.factor(factor)

    def _is_name(self, word: str) -> bool:
        known = word in self._known and (len(word) > 1 or word.isupper())
        indexed = re.fullmatch(rf"[A-Za-z]{{1,2}}\d+|(?:{'|'.join(_GREEK)})\d*", word)
        return known or indexed is not None

    def _named(self, word: str) -> str:
        """LaTeX of a name in a text."""
        return self.symbol(self._known[word]) if word in self._known else identifier(word)

    @cached_property
    def _known(self) -> dict[str, sp.Symbol]:
        return {str(s): s for s in (*self.unknowns, *self.constants, *self.states)}

    @cached_property
    def _linear(self) -> dict[str, str]:
        """Letters for linear equations, characteristic factors and rates, by a name's stem."""
        taken = {identifier(name).partition("_")[0] for name in self._known}
        return {
            role: next((c for c in choices if c not in taken), choices[-1])
            for role, choices in _LINEAR.items()
        }

    @cached_property
    def _printer(self) -> Printer:
        return Printer(self)


def _indexed(latex: str, index: str) -> str:
    """LaTeX of a symbol with one more index."""
    head, raised, above = latex.partition("^")
    head = f"{head[:-1]},{index}}}" if "_{" in head else f"{head}_{{{index}}}"
    return f"{head}{raised}{above}"


def _barred(latex: str) -> str:
    """LaTeX of a symbol with a bar over its letter."""
    return _LETTER.sub(lambda letter: rf"\bar{{{letter[0]}}}", latex, count=1)


def identifier(name: str) -> str:
    """LaTeX of a plain name."""
    match = _NAME.fullmatch(name)
    if name.isdigit():
        return name
    if match is None:
        return rf"\mathrm{{{name}}}".replace("_", r"\_")
    stem, digits, rest = match.groups()
    index = digits
    if stem in _GREEK:
        base = f"\\{stem}"
    elif stem in _WORDS:
        base = _WORDS[stem]
    elif len(stem) <= 2:
        base, index = stem[0], stem[1:] + digits
    else:
        base = rf"\mathrm{{{stem}}}"
    extra = [f"\\{part}" if part in _GREEK else part for part in rest.split("_") if part]
    index = ",".join(filter(None, (index, *extra)))
    return f"{base}_{{{index}}}" if index else base
