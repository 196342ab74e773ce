"""Flows of damped and forced motions: each coordinate as a sum of impulse responses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from nonsmooth.derive.declaration.parameter import sign_of
from nonsmooth.derive.document.blocks import Block, Formula, Line
from nonsmooth.derive.document.notation import Notation
from nonsmooth.derive.document.printer import with_signs
from nonsmooth.derive.document.symbols import CONSTANT, Factors
from nonsmooth.derive.document.template import compose
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow
from nonsmooth.derive.symbols import Symbol

_REGIMES = (
    (-1, "sin", "<", "underdamped"),
    (0, "", "=", "critically damped"),
    (1, "sinh", ">", "overdamped"),
)
# of a steady response, by product of factors: coefficients of the cosine and of the sine
_Harmonics = dict[Factors, tuple[sp.Expr, sp.Expr]]


def response_flows(notation: Notation) -> list[Block]:
    """Blocks on flows in impulse responses, and on their steady responses."""
    flows = notation.flows
    shared = [names for names in notation.sharing.values() if names[0] in flows]
    blocks = _definitions(notation)
    for number, names in enumerate(shared, start=1):
        blocks += compose(
            notation,
            r"""
            @listed: each coordinate by itself,
            $$
            @lines
            $$
            """,
            listed=notation.flow_of(number),
            lines=_motion(notation, flows[names[0]]),
        )
    return blocks + _steady_blocks(notation, shared)


def _definitions(notation: Notation) -> list[Block]:
    """Blocks that define the impulse responses by their factors, and those of single ones."""
    responses, variable = notation.responses, notation.letters.eigenvalue
    factors = list(responses.factors)
    if any(CONSTANT in product for product in responses.products):
        factors.insert(0, CONSTANT)
    single = [p[0] for p in responses.products if len(p) == 1]
    return compose(
        notation,
        r"""
        The motion is written in impulse responses. With the factors of the characteristic
        polynomials
        $$
        @polynomials
        $$
        the response $@h_{j}$ is the inverse Laplace transform of $1/@chi_{j}(@s)$ [several: and
        $@h_{jk}$, that of $1/(@chi_{j}(@s)\,@chi_{k}(@s))$, is the convolution of $@h_{j}$ and
        $@h_{k}$; of more factors likewise. Where the roots of all factors differ, partial fractions
        give it as a sum of exponentials]. At the time 0 they vanish with all derivatives but the
        last before their order, which is 1. They have no singularity where roots of the factors
        meet: in resonance, at critical damping or without stiffness they take the limit[high: . A
        response of a factor of higher degree than two follows from its roots, which are found
        numerically].

        @single
        """,
        polynomials={
            rf"{responses.polynomial}_{{{responses.number(factor)}}}({variable})": (
                _polynomial_pieces(notation, factor)
            )
            for factor in factors
        },
        h=responses.letter,
        chi=responses.polynomial,
        s=variable,
        several=any(len(p) > 1 for p in responses.products),
        high=any(len(factor) > 2 for factor in factors),
        single=[Formula(_single(notation, f)) for f in single if len(f) <= 2],
    )


def _polynomial_pieces(notation: Notation, factor: sp.Tuple) -> tuple[str, ...]:
    """LaTeX of the terms of a monic polynomial, the highest power first."""
    variable = notation.letters.eigenvalue
    pieces: list[tuple[int, str]] = []
    for power, coefficient in reversed([*enumerate((*factor, sp.Integer(1)))]):
        if coefficient == 0:
            continue
        raised = variable if power == 1 else f"{variable}^{{{power}}}" if power else ""
        sign, text = notation.factor(coefficient) if power else notation.term(coefficient)
        pieces.append((sign, f"{'' if text == '1' and power else text} {raised}".strip()))
    return with_signs(pieces)


def _single(notation: Notation, factor: sp.Tuple) -> tuple[Line, ...]:
    """Lines for the response of one factor: an exponential, or each regime of an oscillation."""
    left = notation.responses.latex(0, (factor,), "t")
    if len(factor) == 1:
        return (notation.relation(left, sp.exp(-factor[0] * TIME)),)
    square, rate = factor
    decay = rate / 2
    discriminant = sp.factor_terms(sp.expand(decay**2 - square))
    shown = sign_of(discriminant, notation.system.parameters)
    regimes = [r for r in _REGIMES if shown in (None, r[0])]
    front = rf"{notation.latex(sp.exp(-decay * TIME))}\," if decay != 0 else ""
    lines, below = [], ""
    if len(regimes) > 1:
        below = rf"{notation.letters.damped}_{{{notation.responses.number(factor)}}}"
        inside = " ".join(notation.pieces(sp.expand(-discriminant)))
        lines.append(notation.relation(below, rf"\sqrt{{|{inside}|}}"))
    # without denominators
    scale = sp.fraction(sp.together(decay**2))[1]
    one, other = (notation.latex(sp.expand(scale * e)) for e in (decay**2, square))
    for sign, name, sides, regime in regimes:
        frequency = below or notation.latex(sp.sqrt(sp.expand(sign * discriminant)))
        text = rf"\frac{{\{name}\left({frequency}\,t\right)}}{{{frequency}}}" if sign else "t"
        text = rf"\{name} t" if sign and frequency == "1" else text
        case = rf"\quad\text{{if }} {one} {sides} {other}\text{{ ({regime})}}" if below else ""
        lines.append(notation.relation(left, f"{front}{text}{case}"))
    return tuple(lines)


def _positions(flow: Flow) -> dict[int, int]:
    """Index of the velocity by the index of its position: x' is the state v alone."""
    matrix, offset = flow.field
    found = {}
    for i in range(matrix.rows):
        entries = [j for j in range(matrix.rows) if matrix[i, j] != 0]
        if len(entries) == 1 and entries[0] > i and matrix[i, entries[0]] == 1 and offset[i] == 0:
            found[i] = entries[0]
    return found


def _motion(notation: Notation, flow: Flow) -> list[Line]:
    """Lines for each state after a time, by the states at the time 0."""
    states = notation.system.states
    starts = [Symbol("written", f"{s}_start", f"{notation.symbol(s)}(0)") for s in states]
    rates = {velocity: place for place, velocity in _positions(flow).items()}
    augmented = sp.Matrix.hstack(flow.matrix(), flow.offset())
    lines = []
    for i, state in enumerate(states):
        pieces: list[str] = []
        if i in rates:
            pieces = [f"{notation.symbol(states[rates[i]])}'(t)"]
        else:
            for entry, start in zip(augmented.row(i), (*starts, 1), strict=True):
                if entry != 0:
                    first, *rest = notation.pieces(sp.factor_terms(sp.expand(entry)) * start)
                    plus = "+ " if pieces and not first.startswith("-") else ""
                    pieces += [f"{plus}{first}", *rest]
        lines.append(notation.relation(f"{notation.symbol(state)}(t)", tuple(pieces) or "0"))
    return lines


def _steady_blocks(notation: Notation, shared: Iterable[Sequence[str]]) -> list[Block]:
    """Blocks on steady responses to one harmonic forcing: amplitudes and lags.

    Each list of `shared` names configurations with one flow.
    """
    system, flows = notation.system, notation.flows
    if len(system.forcing) != 1:
        return []
    ((cosine, sine),) = system.forcing
    places = system.states.index(cosine), system.states.index(sine)
    frequency = next(iter(flows.values())).field[0][places[::-1]]
    responses: dict[tuple[Line, ...], list[str]] = {}
    known: set[sp.Tuple] = set()
    for names in shared:
        lines = []
        for place, terms in _steady(flows[names[0]], *places).items():
            text = notation.symbol(system.states[place])
            left = f"{text[:-1]},p}}(t)" if "_{" in text else f"{text}_{{p}}(t)"
            lines.append(notation.relation(left, _steady_pieces(notation, terms)))
            known |= {factor for product in terms for factor in product}
        if lines:
            responses.setdefault(tuple(lines), []).extend(f"*{name}*" for name in names)
    transfers: dict[str, str] = {}
    for factor in sorted(known, key=notation.responses.number):
        transfers |= _transfer(notation, factor, frequency)
    return compose(
        notation,
        """
        [known: Let $@phase(t)$ be the phase of the forcing, @pair its cosine and sine. In the
        steady response each factor $@responses.polynomial_{j}$ multiplies the amplitude by
        $@amplitude_{j}$ and lags behind by $@lag_{j}$,]
        $$
        @transfers
        $$
        [known: and what is left of a motion is a free one, from the differences at the start. The
        steady responses are]

        @steady
        """,
        known=known,
        pair=(cosine, sine),
        transfers=transfers,
        steady=[
            block
            for lines, sharing in responses.items()
            for block in compose(
                notation, "@names:\n$$\n@lines\n$$", names=", ".join(sharing), lines=lines
            )
        ],
    )


def _steady(flow: Flow, cosine: int, sine: int) -> dict[int, _Harmonics]:
    """Steady response of each coordinate; none if one has none of this simple form."""
    matrix, frequency = flow.matrix(), flow.field[0][sine, cosine]
    forcing = sp.Tuple(frequency**2, sp.Integer(0))
    found = {}
    for place in _positions(flow):
        harmonics: _Harmonics = {}
        for term in sp.Add.make_args(sp.expand(matrix[place, cosine])):
            coefficient, function = term.as_independent(TIME, as_Add=False)
            if term == 0:
                continue
            if not isinstance(function, ExponentialDifference):
                return {}
            order, _, *factors = function.args
            if factors.count(forcing) != 1 or order > 1 or CONSTANT in factors:
                return {}
            product = tuple(f for f in factors if f != forcing)
            along, across = harmonics.get(product, (sp.Integer(0), sp.Integer(0)))
            # the cosine's answer is h', that of the sine w h
            if order:
                harmonics[product] = along + coefficient, across
            else:
                harmonics[product] = along, across + sp.cancel(coefficient / frequency)
        if harmonics:
            found[place] = harmonics
    return found


def _transfer(notation: Notation, factor: sp.Tuple, frequency: sp.Expr) -> dict[str, str]:
    """LaTeX of the amplitude and the lag of a factor at the forcing's frequency."""
    letters, number = notation.letters, notation.responses.number(factor)
    powers = [c * (-1) ** (k // 2) * frequency**k for k, c in enumerate((*factor, sp.Integer(1)))]
    text, imaginary = notation.latex(sp.Add(*powers[::2])), sp.Add(*powers[1::2])
    if imaginary != 0:
        sign, size = notation.factor(imaginary)
        text += rf" {'-' if sign < 0 else '+'} {size} \mathrm{{i}}"
    gain, lag = rf"\frac{{1}}{{\left|{text}\right|}}", rf"\operatorname{{arg}}\left({text}\right)"
    return {f"{letters.amplitude}_{{{number}}}": gain, f"{letters.lag}_{{{number}}}": lag}


def _steady_pieces(notation: Notation, terms: _Harmonics) -> tuple[str, ...]:
    """LaTeX of the harmonic terms of a steady response."""
    letters = notation.letters
    pieces: list[tuple[int, str]] = []
    for product, coefficients in terms.items():
        numbers = list(map(notation.responses.number, product))
        gain = " ".join(rf"{letters.amplitude}_{{{n}}}" for n in numbers)
        lags = "".join(rf" - {letters.lag}_{{{n}}}" for n in numbers)
        for coefficient, name in zip(coefficients, ("cos", "sin"), strict=True):
            if coefficient != 0:
                sign, text = notation.factor(sp.factor_terms(coefficient))
                text = "" if text == "1" else f"{text} "
                pieces.append((sign, rf"{text}{gain} \{name}\left({letters.phase}(t){lags}\right)"))
    return with_signs(pieces)
