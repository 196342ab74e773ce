"""How the symbols of the derivation are written in LaTeX.

A name of a declaration is letters and digits: Greek names become Greek letters, digits an index,
the second of two letters joins the index (``us1`` is u_{s1}, ``ta`` is t_a, ``z10`` is z_{10}).
A symbol of the derivation is written by what it means, as the table says.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property

import sympy as sp

from nonsmooth.derive.declaration import algebra
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol, inside, meaning_of

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
    " upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = _GREEK_NAMES.split()
_WORDS = {"gap": r"\Delta", "mean": r"\mu", "spread": r"\delta"}
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
    "coefficient": ("a", r"\alpha", r"\mathsf{a}"),
    "right": ("b", r"\beta", r"\mathsf{b}"),
    "determinant": ("D", r"\Delta", r"\mathsf{D}"),
    "numerator": ("N", r"\mathsf{N}"),
    "factor": (r"\gamma", r"\varrho", r"\mathsf{c}"),
    "rate": ("s", "g", r"\mathsf{s}"),
}
_NAME = re.compile(r"([A-Za-z]+?)(\d*)((?:_\w+)?)")
_LETTER = re.compile(r"\\?[A-Za-z]+(?:\{[^{}]*\})?")
# meanings of what a state is along an orbit, and of its derivatives
_OF_STATES = ("state", "reset", "derivative", "carried", "on boundary")
_WORD = r"[A-Za-z]\w*"
_SUM = rf"{_WORD}(?:\s*[-+*/]\s*{_WORD})*"
_EXPRESSION = re.compile(rf"(?<![-\w])(?:{_SUM}|\({_SUM}\))(?:\s*[-+*/]\s*(?:{_WORD}|\({_SUM}\)))*")

Factors = tuple[sp.Tuple, ...]

# the factor s, whose response is constant
CONSTANT = sp.Tuple(sp.Integer(0))

_PAIRS = (("h", r"\chi"), ("g", "p"), (r"\mathsf{h}", r"\mathsf{p}"))


@dataclass(frozen=True)
class Responses:
    """Numbers of characteristic factors, and letters that nothing else has."""

    # in the order of their numbers, from 1; the factor s of a constant has the number 0
    factors: Factors = ()
    # products of factors whose responses occur, short ones first
    products: tuple[Factors, ...] = ()
    letter: str = "h"  # LaTeX of the response
    polynomial: str = r"\chi"  # LaTeX of the factor

    def number(self, factor: sp.Tuple) -> int:
        """Number of a factor."""
        return 0 if factor == CONSTANT else self.factors.index(factor) + 1

    def label(self, factors: Factors) -> str:
        """Numbers of the factors of a product, written as an index."""
        numbers = sorted(map(self.number, factors))
        return ("," if max(numbers) > 9 else "").join(map(str, numbers))

    def latex(self, order: int, factors: Factors, time: str) -> str:
        """LaTeX of a response, or of its derivative of some order, at a time."""
        primes = "'" * order if order < 4 else f"^{{({order})}}"
        return rf"{self.letter}_{{{self.label(factors)}}}{primes}\left({time}\right)"


def is_response(flow: Flow) -> bool:
    """Whether a flow is written in impulse responses."""
    return any(function.has(ExponentialDifference) for function in flow.basis)


def responses_of(flows: Iterable[Flow], taken: Iterable[str]) -> Responses:
    """Numbers of the characteristic factors of flows, and letters for their responses.

    `taken` is the LaTeX of all symbols, whose letters are avoided.
    """
    known = {head(text) for text in taken}
    letter, polynomial = next((p for p in _PAIRS if not known & {*p}), _PAIRS[-1])
    products: dict[Factors, None] = {}
    for flow in flows:
        for function in flow.basis:
            for found in function.atoms(ExponentialDifference):
                products[tuple(found.args[2:])] = None
    ordered = sorted(products, key=lambda p: (len(p), sp.default_sort_key(sp.Tuple(*p))))
    factors = dict.fromkeys(f for product in ordered for f in product if f != CONSTANT)
    return Responses(tuple(factors), tuple(ordered), letter, polynomial)


@dataclass(frozen=True)
class Letters:
    """LaTeX of a letter for each meaning; what a reader expects stands first among its choices.

    The last choice is free in practice.
    """

    matrix: str = r"A \mathsf{A}"  # A of the vector field y' = A y + b
    offset: str = r"b \beta \mathsf{b}"  # b of the vector field
    augmented: str = r"B \mathsf{B}"  # matrix A with the column b
    eigenvalue: str = r"\lambda s z \mathsf{s}"  # of the augmented matrix
    centre: str = r"\mu \nu \mathsf{s}"  # of a cluster of eigenvalues
    projector: str = r"P \Pi \mathsf{P}"  # of a cluster of eigenvalues
    forcing: str = r"\varphi \mathsf{h}"  # part of the flow that does not depend on the state
    reset: str = r"R \mathsf{R}"  # matrix of a reset
    jump: str = r"r \varrho \mathsf{r}"  # constant of a reset
    normal: str = r"n \nu \mathsf{n}"  # gradient of a boundary
    constant: str = r"c \gamma \mathsf{c}"  # of a boundary
    field: str = r"f g \mathsf{f}"  # vector field in front of a transition
    saltation: str = r"S \mathsf{S}"  # saltation matrix of a transition
    passage: str = r"N W \mathsf{N}"  # matrix of one passage of an itinerary at given dwell times
    remainder: str = r"m w \mathsf{m}"  # constant of one passage
    embedding: str = r"E \mathsf{E}"  # E of the section E q + p at the start
    base: str = r"p a \mathsf{p}"  # p of the section
    coordinates: str = r"q \xi \mathsf{q}"  # q of the section
    jacobian: str = r"J \mathsf{J}"  # of the Poincaré map
    directions: str = r"L \mathsf{L}"  # directions of the state that nothing depends on
    shift: str = r"\sigma \mathsf{z}"  # how far an orbit moves along them
    damped: str = r"\nu \Omega \mathsf{w}"  # damped frequency
    phase: str = r"\theta \vartheta \mathsf{t}"  # of a forcing
    amplitude: str = r"H G \mathsf{H}"  # of the response to a forcing
    lag: str = r"\phi \psi \mathsf{l}"  # of the response behind the forcing


def free_letters(taken: Iterable[str]) -> Letters:
    """Letters different from those that are taken and from each other."""
    used = {*taken}
    chosen: dict[str, str] = {}
    for meaning in fields(Letters):
        chosen[meaning.name] = free(str(meaning.default).split(), used)
        used.add(chosen[meaning.name])
    return Letters(**chosen)


def free(choices: Sequence[str], taken: Collection[str]) -> str:
    """The first letter that is not taken, or else the last one."""
    return next((choice for choice in choices if choice not in taken), choices[-1])


def head(latex: str) -> str:
    """Letter of a symbol without its indices."""
    return latex.partition("_")[0].partition("^")[0]


@dataclass(eq=False)
class Symbols:
    """The symbols of one document."""

    states: tuple[sp.Symbol, ...]
    constants: tuple[sp.Symbol, ...]  # parameters and the spectrum
    # symbols for values of functions of time, or for half a dwell time, and what they are
    functions: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    unknowns: tuple[sp.Symbol, ...] = ()
    # coordinates of the start, and the index of the state of each
    start: Mapping[sp.Symbol, int] = field(default_factory=dict)
    projectors: tuple[sp.Symbol, ...] = ()  # symbols of the spectrum that are entries of projectors
    # mark of a state behind a phase, ``(2)`` or ``(2)+``, by its dwell time
    behind: Mapping[sp.Symbol, str] = field(default_factory=dict)
    flows: tuple[Flow, ...] = ()  # those whose impulse responses have numbers

    def symbol(self, symbol: sp.Symbol) -> str:
        """LaTeX of a symbol."""
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
                return f"{self.letter(parts[0])}_{{{parts[1]}}}"
            case meaning if meaning in _WRITTEN:
                return re.sub(
                    "<(\\w+)>",
                    lambda m: parts[int(m[1])] if m[1].isdigit() else self.letter(m[1]),
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

    def matrix(self, letter: str) -> str:
        """Letter of a matrix, upright where the user has named something so."""
        return free((letter, rf"\mathsf{{{letter}}}"), self.declared)

    def prose(self, text: str) -> str:
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

    @algebra.remembered
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
        for monomial, factor in grouped_by(expression, moving).items():
            states = filter(self.is_state, monomial.free_symbols)
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
        indexed = re.fullmatch(rf"[A-Za-z]{{1,2}}\d+|(?:{'|'.join(_GREEK)})\d*", word)
        return identifier(word) if indexed else ""

    @cached_property
    def _known(self) -> dict[str, sp.Symbol]:
        return {str(s): s for s in (*self.unknowns, *self.constants, *self.states)}

    def letter(self, meaning: str) -> str:
        """Letter of linear equations, characteristic factors or rates."""
        return free(_LETTERS[meaning], {head(identifier(name)) for name in self._known})

    @cached_property
    def responses(self) -> Responses:
        """Numbers of the factors of impulse responses."""
        return responses_of(self.flows, map(self.symbol, self._known.values()))


def grouped_by(expression: sp.Expr, symbols: Iterable[sp.Symbol]) -> dict[sp.Expr, sp.Expr]:
    """Coefficient of each monomial in the symbols; the sum has to be expanded."""
    collected: dict[sp.Expr, sp.Expr] = {}
    symbols = list(symbols)
    for term in sp.Add.make_args(expression):
        coefficient, monomial = term.as_independent(*symbols, as_Add=False)
        collected[monomial] = collected.get(monomial, sp.Integer(0)) + coefficient
    return {m: c for m, c in collected.items() if c != 0}


def is_written(symbol: sp.Basic) -> bool:
    """Whether a symbol is one that the document itself introduces."""
    return meaning_of(symbol) == "written"


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
