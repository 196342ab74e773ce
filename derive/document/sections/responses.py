"""Flows of damped and forced motions: each coordinate as a sum of impulse responses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.parameter import Parameter, is_positive
from nonsmooth.derive.document.blocks import Block, Formula, Line
from nonsmooth.derive.document.notation.arrange import polynomial_pieces
from nonsmooth.derive.document.notation.letters import Factors, Letters
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.wording import Naming, letters_of
from nonsmooth.derive.document.sections.motions import motion_blocks, steady_blocks
from nonsmooth.derive.document.sections.template import compose, relation, with_signs
from nonsmooth.derive.document.views.motions import Displacements
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow
from nonsmooth.derive.symbols import Symbol

__all__ = ["response_flows"]

_CONSTANT = sp.Tuple(sp.Integer(0))
_REGIMES = (
    (-1, "sin", "<", "underdamped"),
    (0, "", "=", "critically damped"),
    (1, "sinh", ">", "overdamped"),
)


def response_flows(
    naming: Naming, flows: Sequence[Flow], spectrum: Mapping[sp.Symbol, sp.Expr]
) -> tuple[list[Block], dict[str, int]]:
    """Blocks on flows in impulse responses, and the number of each configuration's flow.

    `spectrum` has the expression of each of its symbols.
    """
    alike: dict[tuple[object, ...], list[Flow]] = {}
    for flow in flows:
        alike.setdefault((flow.basis, flow.matrices, flow.offsets), []).append(flow)
    letters = letters_of(naming, (*naming.system.states, *naming.notation.constants))
    displacements = _displacements(naming, letters, spectrum)
    motions: list[Block] = []
    numbers: dict[str, int] = {}
    for number, sharing in enumerate(alike.values(), start=1):
        numbers |= {f.configuration: number for f in sharing}
        listed = naming.flow_of([f.configuration for f in sharing])
        motions += motion_blocks(naming, letters, sharing[0], displacements, number, listed)
    shared = [
        (", ".join(f"*{f.configuration}*" for f in sharing), sharing[0])
        for sharing in alike.values()
    ]
    steady = steady_blocks(naming, letters, shared)
    shown = "".join(line.latex for b in motions if isinstance(b, Formula) for line in b.lines)
    used = {
        s
        for f, s in displacements.symbols.items()
        if rf"{letters.displacement}_{{{naming.notation.responses.number(f)}}}" in shown
    }
    return [*_definitions(naming, letters, displacements, used), *motions, *steady], numbers


def _displacements(
    naming: Naming, letters: Letters, spectrum: Mapping[sp.Symbol, sp.Expr]
) -> Displacements:
    """Symbols of the responses to displacements, one for each damped factor."""
    factors = naming.notation.responses.factors
    return Displacements(
        {
            f: Symbol(
                "written",
                f"{letters.displacement}{number}_displacement",
                rf"{letters.displacement}_{{{number}}}\left(t\right)",
            )
            for number, f in enumerate(factors, start=1)
            if len(f) == 2 and f[1] != 0
        },
        spectrum,
    )


def _definitions(
    naming: Naming, letters: Letters, displacements: Displacements, used: set[sp.Basic]
) -> list[Block]:
    """Blocks that define the impulse responses by their factors and in closed form.

    `used` are the responses to displacements that the motions contain.
    """
    notation, responses = naming.notation, naming.notation.responses
    factors = list(responses.factors)
    if any(_CONSTANT in product for product in responses.products):
        factors.insert(0, _CONSTANT)
    variable = letters.eigenvalue
    single = [p[0] for p in responses.products if len(p) == 1]
    several = [p for p in responses.products if len(p) > 1]
    shown = [f for f, symbol in displacements.symbols.items() if symbol in used]
    # of a root that both have, whatever the parameters, there are no partial fractions
    pairs = [p for p in several if len(p) == 2 and max(map(len, p)) <= 2 and _resultant(*p) != 0]
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
        $@h_{k}$; of more factors likewise]. At the time 0 they vanish with all derivatives but the
        last before their order, which is 1. They have no singularity where roots of the factors
        meet: in resonance, at critical damping or without stiffness they take the limit of the
        formulas below[high: ; a factor of higher degree than two has none, and its response
        follows from its roots, which are found numerically].

        @single

        [shown: An impulse starts $@h_{j}$ with the velocity 1; released at a distance of 1 from
        rest, the same oscillation is $@g_{j}$,]
        $$
        @shown
        $$
        @pairs
        """,
        polynomials=[
            relation(
                naming,
                rf"{responses.polynomial}_{{{responses.number(factor)}}}({variable})",
                polynomial_pieces(notation, [sp.Integer(1), *reversed(factor)], variable),
            )
            for factor in factors
        ],
        h=responses.letter,
        chi=responses.polynomial,
        s=variable,
        g=letters.displacement,
        several=several,
        high=any(len(factor) > 2 for factor in factors),
        single=[Formula(_single(naming, letters, f)) for f in single if len(f) <= 2],
        shown=[line for f in shown for line in _displacement(naming, letters, f)],
        pairs=[Formula(_pair(naming, p, displacements.spectrum)) for p in pairs],
    )


def _displacement(naming: Naming, letters: Letters, factor: sp.Tuple) -> tuple[Line, ...]:
    """Lines for the response to a displacement, by that to an impulse and in closed form.

    The closed form is that of an oscillation, if the factor may oscillate.
    """
    notation, number = naming.notation, naming.notation.responses.number(factor)
    shown = ExponentialDifference(1, TIME, factor)
    impulse = ExponentialDifference(0, TIME, factor)
    sign, rate = notation.factor(factor[1])
    left = rf"{letters.displacement}_{{{number}}}\left(t\right)"
    pieces = (notation.latex(shown), f"{'-' if sign < 0 else '+'} {rate} {notation.latex(impulse)}")
    lines = (Line(left, "=", pieces),)
    oscillation = _oscillation(naming, letters, factor)
    if -1 not in oscillation.conditions:
        return lines
    below = oscillation.below(notation, -1)
    sign, decay = notation.factor(oscillation.decay)
    decay = "" if decay == "1" else rf"{decay}\,"
    turning = rf"\cos\left({below}\,t\right) {'-' if sign < 0 else '+'}"
    text = rf"{turning} {decay}\frac{{\sin\left({below}\,t\right)}}{{{below}}}"
    whole = rf"{oscillation.front}\left({text}\right){oscillation.conditions[-1]}"
    return (*lines, Line(left, "=", (whole,)))


def _single(naming: Naming, letters: Letters, factor: sp.Tuple) -> tuple[Line, ...]:
    """Lines for the response of one factor: an exponential, or each regime of an oscillation."""
    notation = naming.notation
    left = notation.responses.latex(0, (factor,), "t")
    if len(factor) == 1:
        function = sp.exp(-factor[0] * TIME)
        return (Line(left, "=", (notation.latex(function),), None, function),)
    oscillation = _oscillation(naming, letters, factor)
    lines = []
    if oscillation.root.startswith(letters.damped):
        inside = " ".join(notation.pieces(sp.expand(-oscillation.discriminant)))
        lines.append(Line(oscillation.root, "=", (rf"\sqrt{{|{inside}|}}",)))
    for sign, name, _, regime in oscillation.regimes:
        below = oscillation.below(notation, sign)
        text = rf"\frac{{\{name}\left({below}\,t\right)}}{{{below}}}" if sign else "t"
        text = rf"\{name} t" if sign and below == "1" else text
        condition = oscillation.conditions[sign]
        condition += rf"\text{{ ({regime})}}" if condition else ""
        pieces = (f"{oscillation.front}{text}{condition}",)
        lines.append(Line(left, "=", pieces))
    return tuple(lines)


@dataclass(frozen=True)
class _Oscillation:
    """A factor of degree two in the form in which it is written."""

    decay: sp.Expr  # half the coefficient of lambda
    discriminant: sp.Expr  # square of the decay less the constant
    regimes: tuple[tuple[int, str, str, str], ...]  # those of `_REGIMES` that the parameters allow
    root: str  # LaTeX of the damped frequency's letter, empty if there is one regime
    front: str  # LaTeX of the envelope
    conditions: Mapping[int, str]  # by sign of the discriminant: LaTeX of when the regime applies

    def below(self, notation: Notation, sign: int) -> str:
        """LaTeX of the frequency in the regime of the given sign."""
        return self.root or notation.latex(sp.sqrt(sp.expand(sign * self.discriminant)))


def _oscillation(naming: Naming, letters: Letters, factor: sp.Tuple) -> _Oscillation:
    notation, parameters = naming.notation, naming.system.parameters
    square, rate = factor
    decay = rate / 2
    discriminant = sp.factor_terms(sp.expand(decay**2 - square))
    regimes = tuple(r for r in _REGIMES if _possible(r[0], discriminant, parameters))
    several = len(regimes) > 1
    # without denominators
    scale = sp.fraction(sp.together(decay**2))[1]
    left, right = (notation.latex(sp.expand(scale * e)) for e in (decay**2, square))
    conditions = {
        sign: rf"\quad\text{{if }} {left} {relation} {right}" if several else ""
        for sign, _, relation, _ in regimes
    }
    root = rf"{letters.damped}_{{{notation.responses.number(factor)}}}" if several else ""
    front = rf"{notation.latex(sp.exp(-decay * TIME))}\," if decay != 0 else ""
    return _Oscillation(decay, discriminant, regimes, root, front, conditions)


def _possible(sign: int, value: sp.Expr, parameters: Sequence[Parameter]) -> bool:
    """Whether a value may have a sign on the domain of the parameters."""
    if value.is_number:
        return bool(sp.sign(value) == sign)
    shown = (is_positive(value, parameters), is_positive(-value, parameters))
    return not any(shown) or (sign == 1 and shown[0]) or (sign == -1 and shown[1])


def _pair(
    naming: Naming, product: Factors, spectrum: Mapping[sp.Symbol, sp.Expr]
) -> tuple[Line, ...]:
    """Lines for the response of two factors in partial fractions.

    They hold where the factors have no root in common; the limit in resonance is added.
    """
    notation = naming.notation
    s = sp.Dummy("s")
    polynomials = [s ** len(f) + sum(c * s**k for k, c in enumerate(f)) for f in product]
    resultant = _resultant(*product)
    # A q + B p = R with deg A < deg p, deg B < deg q
    numerators = [sp.symbols(f"n{i}_:{len(f)}") for i, f in enumerate(product)]
    unknowns = [n for found in numerators for n in found]
    first, second = (sum(n * s**k for k, n in enumerate(found)) for found in numerators)
    identity = sp.Poly(first * polynomials[1] + second * polynomials[0] - sp.expand(resultant), s)
    (solution,) = sp.linsolve(identity.all_coeffs(), unknowns)
    values = dict(zip(unknowns, map(sp.factor, solution), strict=True))
    resultant, values = _shortened(resultant, values)
    found: list[tuple[int, str]] = []
    for factor, numerator in zip(product, numerators, strict=True):
        for k, n in reversed(list(enumerate(numerator))):
            coefficient = sp.factor_terms(sp.radsimp(sp.cancel(values[n])))
            if coefficient == 0:
                continue
            function = _response_text(naming, k, factor)
            sign, text = (notation.term if function == "1" else notation.factor)(coefficient)
            if function != "1":
                text = function if text == "1" else rf"{text}\,{function}"
            found.append((sign, text))
    terms = with_signs(found)
    left = notation.responses.latex(0, product, "t")
    below = notation.latex(resultant)
    if resultant == 1:
        return (Line(left, "=", terms),)
    sign, text = notation.factor(1 / resultant)
    front = f"- {text}" if sign < 0 else text
    pieces = [rf"{front} \biggl({terms[0]}", *terms[1:]]
    pieces[-1] += r"\biggr)"
    if _never_zero(resultant, naming, spectrum):
        return (Line(left, "=", tuple(pieces)),)
    lines = [Line(left, "=", (*pieces, rf"\quad\text{{if }} {below} \neq 0"))]
    if all(len(f) == 2 and f[1] == 0 for f in product):
        square = product[1][0]
        omega = sp.sqrt(square)
        limit = (sp.sin(omega * TIME) / omega - TIME * sp.cos(omega * TIME)) / (2 * square)
        resonance = rf"\quad\text{{if }} {below} = 0\text{{ (resonance)}}"
        lines.append(Line(left, "=", (*notation.pieces(limit), resonance)))
    return tuple(lines)


def _shortened(
    below: sp.Expr, above: dict[sp.Symbol, sp.Expr]
) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Denominator and numerators without the factors that they all share."""
    whole = below
    numerator = sp.fraction(sp.together(below))[0]
    plain = numerator.free_symbols and numerator.is_polynomial()
    _, factors = sp.factor_list(numerator) if plain else (numerator, [])
    for factor, power in factors:
        for _ in range(power):
            divided = {n: sp.cancel(e / factor) for n, e in above.items()}
            if any(sp.fraction(e)[1].has(*factor.free_symbols) for e in divided.values()):
                break
            below, above = sp.factor(sp.cancel(below / factor)), divided
    contents = [sp.sympify(e).as_content_primitive()[0] for e in above.values()]
    common = sp.gcd_list([below, *contents]) if below.is_Integer else sp.Integer(1)
    if common.is_Integer:
        below, above = below / common, {n: e / common for n, e in above.items()}
    below = below if below == whole else sp.expand(below)
    number = below.as_coeff_Add()[0]
    if number < 0 or (number == 0 and below.could_extract_minus_sign()):
        below, above = -below, {n: -e for n, e in above.items()}
    return below, above


def _never_zero(expression: sp.Expr, naming: Naming, spectrum: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Whether an expression is shown not to vanish for any parameters."""
    parameters, expression = naming.system.parameters, expression.xreplace(spectrum)
    if is_positive(expression, parameters) or is_positive(-expression, parameters):
        return True
    terms = sp.Add.make_args(expression)
    squares = [
        number > 0 and all(f.as_base_exp()[1] == 2 for f in sp.Mul.make_args(rest))
        for number, rest in (t.as_coeff_Mul() for t in terms)
    ]
    positive = [is_positive(t, parameters) for t in terms]
    return any(positive) and all(a or b for a, b in zip(squares, positive, strict=True))


def _resultant(one: sp.Tuple, other: sp.Tuple) -> sp.Expr:
    """Resultant of two factors: the product of all differences of their roots."""
    if len(one) == len(other) == 2:
        (a, b), (c, d) = one, other
        return (a - c) ** 2 + sp.factor((a * d - b * c) * (d - b))
    s = sp.Dummy("s")
    polynomials = (s ** len(f) + sum(c * s**k for k, c in enumerate(f)) for f in (one, other))
    return sp.factor(sp.resultant(*polynomials, s))


def _response_text(naming: Naming, order: int, factor: sp.Tuple) -> str:
    """LaTeX of the response of one factor, or a derivative of it.

    A constant or trigonometric one is written as such.
    """
    notation = naming.notation
    function = ExponentialDifference(order, TIME, factor)
    if function == 1:
        return "1"
    if len(factor) == 2 and factor[1] == 0 and is_positive(factor[0], naming.system.parameters):
        omega = sp.sqrt(factor[0])
        trigonometric = sp.cos(omega * TIME) if order else sp.sin(omega * TIME) / omega
        return notation.latex(trigonometric)
    return notation.responses.latex(order, (factor,), "t")
