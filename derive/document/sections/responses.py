"""Flows of damped and forced motions: each coordinate as a sum of impulse responses."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.parameter import sign_of
from nonsmooth.derive.document.blocks import Block, Formula, Line
from nonsmooth.derive.document.printer import Notation, with_signs
from nonsmooth.derive.document.sections.template import compose, relation, summed
from nonsmooth.derive.document.symbols import CONSTANT, Factors, Letters
from nonsmooth.derive.document.wording import Naming, alike, letters_of
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


def response_flows(
    naming: Naming, flows: Mapping[str, Flow]
) -> tuple[list[Block], dict[int, list[str]]]:
    """Blocks on flows in impulse responses, and by number the configurations of each."""
    shared = alike({name: (f.basis, f.matrices, f.offsets) for name, f in flows.items()})
    letters = letters_of(naming, (*naming.system.states, *naming.notation.constants))
    blocks = _definitions(naming, letters)
    for number, names in shared.items():
        blocks += compose(
            naming,
            r"""
            $\Phi_{@number}$, @listed: each coordinate by itself,
            $$
            @lines
            $$
            """,
            number=number,
            listed=naming.flow_of(names),
            lines=_motion(naming, flows[names[0]]),
        )
    return blocks + _steady_blocks(naming, letters, flows, shared.values()), shared


def _definitions(naming: Naming, letters: Letters) -> list[Block]:
    """Blocks that define the impulse responses by their factors, and those of single ones."""
    notation, responses = naming.notation, naming.notation.responses
    factors = list(responses.factors)
    if any(CONSTANT in product for product in responses.products):
        factors.insert(0, CONSTANT)
    variable = letters.eigenvalue
    single = [p[0] for p in responses.products if len(p) == 1]
    return compose(
        naming,
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
        polynomials=[
            relation(
                naming,
                rf"{responses.polynomial}_{{{responses.number(factor)}}}({variable})",
                _polynomial_pieces(notation, [sp.Integer(1), *reversed(factor)], variable),
            )
            for factor in factors
        ],
        h=responses.letter,
        chi=responses.polynomial,
        s=variable,
        several=any(len(p) > 1 for p in responses.products),
        high=any(len(factor) > 2 for factor in factors),
        single=[Formula(_single(naming, letters, f)) for f in single if len(f) <= 2],
    )


def _polynomial_pieces(
    notation: Notation, coefficients: Sequence[sp.Expr], variable: str
) -> tuple[str, ...]:
    """LaTeX of the terms of a monic polynomial, the highest power first."""
    degree = len(coefficients) - 1
    pieces: list[tuple[int, str]] = []
    for place, coefficient in enumerate(coefficients):
        if coefficient == 0:
            continue
        power = degree - place
        raised = variable if power == 1 else f"{variable}^{{{power}}}" if power else ""
        sign, text = notation.factor(coefficient) if power else notation.term(coefficient)
        if text == "1" and power:
            text = ""
        pieces.append((sign, " ".join(filter(None, (text, raised)))))
    return with_signs(pieces)


def _single(naming: Naming, letters: Letters, factor: sp.Tuple) -> tuple[Line, ...]:
    """Lines for the response of one factor: an exponential, or each regime of an oscillation."""
    notation = naming.notation
    left = notation.responses.latex(0, (factor,), "t")
    if len(factor) == 1:
        function = sp.exp(-factor[0] * TIME)
        return (Line(left, "=", (notation.latex(function),), None, function),)
    square, rate = factor
    decay = rate / 2
    discriminant = sp.factor_terms(sp.expand(decay**2 - square))
    shown = sign_of(discriminant, naming.system.parameters)
    regimes = [r for r in _REGIMES if shown in (None, r[0])]
    front = rf"{notation.latex(sp.exp(-decay * TIME))}\," if decay != 0 else ""
    lines, below = [], ""
    if len(regimes) > 1:
        below = rf"{letters.damped}_{{{notation.responses.number(factor)}}}"
        inside = " ".join(notation.pieces(sp.expand(-discriminant)))
        lines.append(Line(below, "=", (rf"\sqrt{{|{inside}|}}",)))
    # without denominators
    scale = sp.fraction(sp.together(decay**2))[1]
    one, other = (notation.latex(sp.expand(scale * e)) for e in (decay**2, square))
    for sign, name, sides, regime in regimes:
        frequency = below or notation.latex(sp.sqrt(sp.expand(sign * discriminant)))
        text = rf"\frac{{\{name}\left({frequency}\,t\right)}}{{{frequency}}}" if sign else "t"
        text = rf"\{name} t" if sign and frequency == "1" else text
        case = rf"\quad\text{{if }} {one} {sides} {other}\text{{ ({regime})}}" if below else ""
        lines.append(Line(left, "=", (f"{front}{text}{case}",)))
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


def _motion(naming: Naming, flow: Flow) -> list[Line]:
    """Lines for each state after a time, by the states at the time 0."""
    notation, states = naming.notation, naming.system.states
    matrix, offset = flow.matrix(), flow.offset()
    starts = [Symbol("written", f"{s}_start", f"{notation.symbol(s)}(0)") for s in states]
    rates = {velocity: place for place, velocity in _positions(flow).items()}
    lines = []
    for i, state in enumerate(states):
        pieces: tuple[str, ...]
        if i in rates:
            pieces = (f"{notation.symbol(states[rates[i]])}'(t)",)
        else:
            entries = zip([*matrix.row(i), offset[i]], [*starts, sp.Integer(1)], strict=True)
            pieces = summed(notation, [sp.factor_terms(sp.expand(e)) * s for e, s in entries])
        lines.append(Line(f"{notation.symbol(state)}(t)", "=", pieces))
    return lines


def _steady_blocks(
    naming: Naming, letters: Letters, flows: Mapping[str, Flow], shared: Iterable[Sequence[str]]
) -> list[Block]:
    """Blocks on steady responses to one harmonic forcing: amplitudes and lags.

    Each list of `shared` names configurations with one flow.
    """
    system, notation = naming.system, naming.notation
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
            lines.append(relation(naming, left, _steady_pieces(naming, letters, terms)))
            known |= {factor for product in terms for factor in product}
        if lines:
            responses.setdefault(tuple(lines), []).extend(f"*{name}*" for name in names)
    return compose(
        naming,
        """
        [known: Let $@phase(t)$ be the phase of the forcing, @pair its cosine and sine. In the
        steady response each factor $@notation.responses.polynomial_{j}$ multiplies the amplitude by
        $@amplitude_{j}$ and lags behind by $@lag_{j}$,]
        $$
        @transfers
        $$
        [known: and what is left of a motion is a free one, from the differences at the start. The
        steady responses are]

        @responses
        """,
        known=known,
        pair=(cosine, sine),
        transfers=[
            line
            for factor in sorted(known, key=notation.responses.number)
            for line in _transfer(naming, letters, factor, frequency)
        ],
        responses=[
            block
            for lines, sharing in responses.items()
            for block in compose(
                naming, "@names:\n$$\n@lines\n$$", names=", ".join(sharing), lines=lines
            )
        ],
        **vars(letters),
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


def _transfer(naming: Naming, letters: Letters, factor: sp.Tuple, frequency: sp.Expr) -> list[Line]:
    """Lines with the amplitude and the lag of a factor at the forcing's frequency."""
    notation, number = naming.notation, naming.notation.responses.number(factor)
    powers = [c * (-1) ** (k // 2) * frequency**k for k, c in enumerate((*factor, sp.Integer(1)))]
    text, imaginary = notation.latex(sp.Add(*powers[::2])), sp.Add(*powers[1::2])
    if imaginary != 0:
        sign, size = notation.factor(imaginary)
        text += rf" {'-' if sign < 0 else '+'} {size} \mathrm{{i}}"
    gain = rf"\frac{{1}}{{\left|{text}\right|}}"
    return [
        Line(rf"{letters.amplitude}_{{{number}}}", "=", (gain,)),
        Line(rf"{letters.lag}_{{{number}}}", "=", (rf"\operatorname{{arg}}\left({text}\right)",)),
    ]


def _steady_pieces(
    naming: Naming, letters: Letters, terms: Mapping[Factors, tuple[sp.Expr, sp.Expr]]
) -> tuple[str, ...]:
    """LaTeX of the harmonic terms of a steady response."""
    notation = naming.notation
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
