"""Notation: how symbols and expressions of the derivation are written in LaTeX.

One general rule, no table per orbit:

* a name is letters and digits: Greek names become Greek letters, digits an index, the second
  of two letters joins the index (``us1`` is u_{s1}, ``ta`` is t_a, ``z10`` is z_{10});
* ``z1_3`` is a state behind phase 3, z_1^{(3)}, and ``z1_3_reset`` behind its transition;
* ``z1_3_by_tau`` is its partial derivative, ``carried_z1_3_by_z10`` that by the start which the
  flow carries along, ``z1_3_on_boundary_by_z10`` and ``delay_tau_by_z10`` those on the boundary;
* what is affine in q has the coefficient ``right1_times_q`` of it, with q as an index, and
  ``x0_constant`` where q is zero, with a bar; of a state behind a phase these are
  ``part2_of_q_tau`` and ``part2_of_1_tau``, its place first, and last the phase's dwell time;
* ``coefficient12_without3`` is an entry of linear equations after three steps of elimination;
* values of a flow's functions are written as what they are, cos(omega_1 tau_1);
* ``amplitude_tau2`` and its like belong to the dwell time that they name.
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

__all__ = ["Notation"]

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
    " upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = tuple(_GREEK_NAMES.split())
_WORDS = {
    "gap": r"\Delta",
    "mean": r"\mu",
    "spread": r"\delta",
    "equation": "F",
}
# of linear equations, characteristic factors and rates: the first that the declaration leaves free
_LINEAR = {
    "coefficient": ("a", r"\alpha", r"\mathsf{a}"),
    "right": ("b", r"\beta", r"\mathsf{b}"),
    "determinant": ("D", r"\Delta", r"\mathsf{D}"),
    "numerator": ("N", r"\mathsf{N}"),
    "factor": (r"\gamma", r"\varrho", r"\mathsf{c}"),
    "rate": ("s", "g", r"\mathsf{s}"),
}
_PARTS = {"cosine_part": "a", "sine_part": "b", "constant_part": "c", "amplitude": "A"}
_NAME = re.compile(r"([A-Za-z]+?)(\d*)((?:_\w+)?)")
_TURNED = re.compile(r"(cos|sin)_(\w+)_return")
_LETTER = re.compile(r"\\?[A-Za-z]+(?:\{[^{}]*\})?")
_PART = re.compile(r"part(\d+)_of_")
_REDUCED = re.compile(r"(\w+)_without(\d+)")
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
    # LaTeX of symbols that the document itself introduces
    names: Mapping[sp.Symbol, str] = field(default_factory=dict)
    # numbers of the factors of impulse responses
    responses: Responses = field(default_factory=Responses)
    # mark of a state behind a phase, ``(2)`` or ``(2)+``, by the name of its dwell time
    behind: Mapping[str, str] = field(default_factory=dict)

    def with_names(self, names: Mapping[sp.Symbol, str]) -> Notation:
        """The same notation with more symbols that the document introduces."""
        return replace(self, names={**self.names, **names})

    def with_responses(self, flows: Iterable[Flow]) -> Notation:
        """The same notation, with numbers for the factors of the flows' impulse responses."""
        symbols = (*self.states, *self.constants, *self.unknowns)
        return replace(self, responses=responses_of(flows, map(self.symbol, symbols)))

    def symbol(self, name: sp.Symbol | str) -> str:
        """LaTeX of a symbol."""
        if isinstance(name, sp.Symbol) and name in self.names:
            return self.names[name]
        text = str(name)
        inner, by, variable = text.rpartition("_by_")
        if by:
            return rf"\partial_{{{self.symbol(variable)}}} {self.symbol(inner)}"
        passing = text.removesuffix("_on_boundary")
        if passing != text:
            return rf"{self.symbol(passing)}|_{{\Sigma}}"
        if text.startswith("carried_"):
            return rf"{self.symbol(text.removeprefix('carried_'))}|_{{\Phi}}"
        if text.startswith("delay_"):
            return self.symbol(text.removeprefix("delay_"))
        reduced = _REDUCED.fullmatch(text)
        if reduced:
            return f"{self.symbol(reduced[1])}^{{[{reduced[2]}]}}"
        inner, times, variable = text.rpartition("_times_")
        if times:
            return _indexed(self.symbol(inner), self.symbol(variable))
        part = self._part(text)
        if part:
            return part
        if text.endswith("_constant"):
            return _barred(self.symbol(text.removesuffix("_constant")))
        if text.endswith("_slope"):
            return f"{self._linear['coefficient']}_{{{self.symbol(text.removesuffix('_slope'))}}}"
        if text in self._functions:
            return self.latex(self._functions[text])
        state = self._state_at(text)
        if state:
            base, index, mark = state
            return f"{_identifier(base)}^{{({index}){mark}}}"
        turned = _TURNED.fullmatch(text)
        if turned:
            return rf"\{turned[1]} \theta_{{{_identifier(turned[2])}}}"
        for part, letter in (*_PARTS.items(), ("rate", self._linear["rate"])):
            if text.startswith(f"{part}_"):
                return f"{letter}_{{{_identifier(text.removeprefix(f'{part}_'))}}}"
        linear = _NAME.fullmatch(text)
        if linear and linear[1] in _LINEAR:
            return _identifier(text).replace(rf"\mathrm{{{linear[1]}}}", self._linear[linear[1]], 1)
        return _identifier(text)

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
            return f"${re.sub(_WORD, lambda m: self.symbol(m[0]), found)}$"

        def single(match: re.Match[str]) -> str:
            return f"${self.symbol(match[0])}$" if self._is_name(match[0]) else match[0]

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
            factor = algebra.factor_terms(sp.Add(*(r * f for r, f in inner.items())))
            # states with one factor up to its sign share it
            opposite = next((f for f in sums if f == -factor), None)
            if factor == 1 or factor == -1 or (factor not in sums and opposite is None):
                key, sign = factor, 1
            else:
                key, sign = (factor, 1) if opposite is None else (opposite, -1)
            sums[key] = sums.get(key, sp.Integer(0)) + sign * state
        parts = [f * s if f.is_number else sp.Mul(f, s) for f, s in sums.items()]
        return algebra.factor_terms(sp.Add(*parts)) if len(parts) > 1 else sp.Add(*parts)

    def is_state(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol is a state, also at the start or behind a phase, or its derivative."""
        name = _moving(symbol)
        return symbol in (*self.states, *self.start) or self._state_at(name) is not None

    def place(self, symbol: sp.Symbol) -> int:
        """Index of the state to which a symbol belongs."""
        if symbol in self.start:
            return self.start[symbol]
        name = _moving(symbol)
        state = self._state_at(name)
        return self._state_names.index(state[0] if state else name)

    def is_function(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol stands for a value of a function, and needs no brackets behind it."""
        known = self.functions.get(symbol)
        return (known is not None and known.is_Function) or _TURNED.fullmatch(
            str(symbol)
        ) is not None

    def term(self, term: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of a term of a sum."""
        return self._printer.term(term)

    def factor(self, factor: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of a factor; a sum is set in brackets."""
        return self._printer.factor(factor)

    def _state_at(self, name: str) -> tuple[str, str, str] | None:
        match = re.fullmatch(r"(\w+?)_(\d+)(_reset)?", name)
        if match is None or match[1] not in self._state_names:
            return None
        return match[1], match[2], "+" if match[3] else ""

    def _part(self, text: str) -> str | None:
        """LaTeX of a coefficient of a state that is affine in the start; None for other names."""
        match = _PART.match(text)
        if match is None:
            return None
        for dwell, mark in self.behind.items():
            variable = text[match.end() :].removesuffix(f"_{dwell}")
            if text == f"{match[0]}{variable}_{dwell}":
                state = f"{_identifier(self._state_names[int(match[1])])}^{{{mark}}}"
                return _barred(state) if variable == "1" else _indexed(state, self.symbol(variable))
        return None

    def _is_name(self, word: str) -> bool:
        known = word in self._known and (len(word) > 1 or word.isupper())
        indexed = re.fullmatch(rf"[A-Za-z]{{1,2}}\d+|(?:{'|'.join(_GREEK)})\d*", word)
        return known or indexed is not None or self._state_at(word) is not None

    @cached_property
    def _state_names(self) -> tuple[str, ...]:
        return tuple(str(s) for s in self.states)

    @cached_property
    def _functions(self) -> dict[str, sp.Expr]:
        return {str(s): e for s, e in self.functions.items()}

    @cached_property
    def _known(self) -> frozenset[str]:
        return frozenset(str(s) for s in (*self.states, *self.constants, *self.unknowns))

    @cached_property
    def _linear(self) -> dict[str, str]:
        """Letters for linear equations, characteristic factors and rates, by a name's stem."""
        taken = {_identifier(name).partition("_")[0] for name in self._known}
        return {
            role: next((c for c in choices if c not in taken), choices[-1])
            for role, choices in _LINEAR.items()
        }

    @cached_property
    def _printer(self) -> Printer:
        return Printer(self)


def _moving(symbol: sp.Symbol) -> str:
    """Name of the state of which a symbol is a derivative, or of the symbol itself."""
    name = str(symbol).partition("_by_")[0]
    return name.removeprefix("carried_").removesuffix("_on_boundary")


def _indexed(latex: str, index: str) -> str:
    """LaTeX of a symbol with one more index."""
    head, raised, above = latex.partition("^")
    head = f"{head[:-1]},{index}}}" if "_{" in head else f"{head}_{{{index}}}"
    return f"{head}{raised}{above}"


def _barred(latex: str) -> str:
    """LaTeX of a symbol with a bar over its letter."""
    return _LETTER.sub(lambda letter: rf"\bar{{{letter[0]}}}", latex, count=1)


def _identifier(name: str) -> str:
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
