"""Names as LaTeX, and letters that no symbol has.

A name of a declaration is letters and digits: Greek names become Greek letters, digits an index,
the second of two letters joins the index (``us1`` is u_{s1}, ``ta`` is t_a, ``z10`` is z_{10}).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, fields

import sympy as sp

from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import Flow

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
    " upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
GREEK = _GREEK_NAMES.split()
_WORDS = {"gap": r"\Delta", "mean": r"\mu", "spread": r"\delta"}
_NAME = re.compile(r"([A-Za-z]+?)(\d*)((?:_\w+)?)")
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


def grouped_by(expression: sp.Expr, symbols: Iterable[sp.Symbol]) -> dict[sp.Expr, sp.Expr]:
    """Coefficient of each monomial in the symbols; the sum has to be expanded."""
    collected: dict[sp.Expr, sp.Expr] = {}
    symbols = list(symbols)
    for term in sp.Add.make_args(expression):
        coefficient, monomial = term.as_independent(*symbols, as_Add=False)
        collected[monomial] = collected.get(monomial, sp.Integer(0)) + coefficient
    return {m: c for m, c in collected.items() if c != 0}


def identifier(name: str) -> str:
    """LaTeX of a plain name."""
    match = _NAME.fullmatch(name)
    if name.isdigit():
        return name
    if match is None:
        return rf"\mathrm{{{name}}}".replace("_", r"\_")
    stem, digits, rest = match.groups()
    index = digits
    if stem in GREEK:
        base = f"\\{stem}"
    elif stem in _WORDS:
        base = _WORDS[stem]
    elif len(stem) <= 2:
        base, index = stem[0], stem[1:] + digits
    else:
        base = rf"\mathrm{{{stem}}}"
    extra = [f"\\{part}" if part in GREEK else part for part in rest.split("_") if part]
    index = ",".join(filter(None, (index, *extra)))
    return f"{base}_{{{index}}}" if index else base
