"""Flows of damped and forced motions: each coordinate as a sum of impulse responses."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.parameter import Parameter, is_positive
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.characteristic import polynomial_pieces
from nonsmooth.derive.document.notation.letters import letters_of
from nonsmooth.derive.document.notation.responses import Factors
from nonsmooth.derive.document.notation.wording import Naming
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow

__all__ = ["response_flows"]

_CONSTANT = sp.Tuple(sp.Integer(0))


def response_flows(naming: Naming, flows: Sequence[Flow]) -> tuple[list[Block], dict[str, int]]:
    """Flows in impulse responses, coordinate by coordinate, and the number of each.

    Parameters
    ----------
    naming : Naming
    flows : sequence of Flow
    """
    alike: dict[tuple[object, ...], list[Flow]] = {}
    for flow in flows:
        alike.setdefault((flow.basis, flow.matrices, flow.offsets), []).append(flow)
    blocks = _definitions(naming)
    numbers: dict[str, int] = {}
    for number, sharing in enumerate(alike.values(), start=1):
        numbers |= {f.configuration: number for f in sharing}
        listed = ", ".join(f"*{f.configuration}*" for f in sharing)
        blocks += [
            Paragraph(rf"$\Phi_{{{number}}}$, of {listed}: each coordinate by itself,"),
            _motion(naming, sharing[0]),
        ]
    return blocks, numbers


def _definitions(naming: Naming) -> list[Block]:
    """What the impulse responses are: by their factors, and in closed form.

    Parameters
    ----------
    naming : Naming
        Its notation numbers the factors.
    """
    notation, responses = naming.notation, naming.notation.responses
    letters = letters_of(naming, (*naming.system.states, *notation.constants))
    h, chi, s = responses.letter, responses.polynomial, letters.eigenvalue
    factors = list(responses.factors)
    if any(_CONSTANT in product for product in responses.products):
        factors.insert(0, _CONSTANT)
    definitions = []
    for factor in factors:
        pieces = polynomial_pieces(notation, [sp.Integer(1), *reversed(factor)], s)
        left = rf"{chi}_{{{responses.number(factor)}}}({s})"
        definitions.append(Line(left, "=", pieces))
    single = [p for p in responses.products if len(p) == 1]
    several = [p for p in responses.products if len(p) > 1]
    text = (
        "The motion is written in impulse responses. With the factors of the"
        " characteristic polynomials"
    )
    means = (
        rf"the response ${h}_{{j}}$ is the inverse Laplace transform of"
        rf" $1/{chi}_{{j}}({s})$"
    )
    if several:
        means += (
            rf" and ${h}_{{jk}}$, that of $1/({chi}_{{j}}({s})\,{chi}_{{k}}({s}))$, is the"
            rf" convolution of ${h}_{{j}}$ and ${h}_{{k}}$; of more factors likewise"
        )
    means += (
        ". At the time 0 they vanish with all derivatives but the last before their order, which"
        " is 1. They have no singularity where roots of the factors meet: in resonance, at critical"
        " damping or without stiffness they take the limit of the formulas below"
    )
    blocks: list[Block] = [Paragraph(text), Formula(tuple(definitions)), Paragraph(f"{means}.")]
    for product in (*single, *several):
        blocks += _closed_form(naming, product)
    return blocks


def _closed_form(naming: Naming, product: Factors) -> list[Block]:
    """Formulas of one response, case by case."""
    if len(product) == 1 and len(product[0]) <= 2:
        return [Formula(_single(naming, product))]
    if len(product) == 2 and product[0] != product[1] and max(map(len, product)) <= 2:
        return [Formula(_pair(naming, product))]
    return []


def _single(naming: Naming, product: Factors) -> tuple[Line, ...]:
    """Response of one factor: an exponential, or a damped oscillation in its regimes."""
    notation, parameters = naming.notation, naming.system.parameters
    (factor,) = product
    left = notation.responses.latex(0, product, "t")
    if len(factor) == 1:
        function = sp.exp(-factor[0] * TIME)
        return (Line(left, "=", (notation.latex(function),), None, function),)
    square, rate = factor
    decay = rate / 2
    discriminant = sp.factor_terms(sp.expand(decay**2 - square))
    envelope = sp.exp(-decay * TIME) if decay != 0 else sp.Integer(1)
    lines = []
    for sign, name, regime in (
        (-1, "sin", "underdamped"),
        (0, "", "critically damped"),
        (1, "sinh", "overdamped"),
    ):
        if not _possible(sign, discriminant, parameters):
            continue
        front = "" if envelope == 1 else rf"{notation.latex(envelope)}\,"
        root = notation.latex(sp.sqrt(sp.expand(sign * discriminant))) if sign else ""
        text = rf"\frac{{\{name}\left({root}\,t\right)}}{{{root}}}" if sign else "t"
        relation = {-1: "<", 0: "=", 1: ">"}[sign]
        known = discriminant.is_number
        condition = "" if known else rf"\quad\text{{if }} {notation.latex(decay**2)} {relation}"
        condition += "" if known else rf" {notation.latex(square)}\text{{ ({regime})}}"
        lines.append(Line(left, "=", (rf"{front}{text}{condition}",)))
    return tuple(lines)


def _possible(sign: int, value: sp.Expr, parameters: Sequence[Parameter]) -> bool:
    """Whether a value may have a sign on the domain of the parameters."""
    if value.is_number:
        return bool(sp.sign(value) == sign)
    shown = (is_positive(value, parameters), is_positive(-value, parameters))
    return not any(shown) or (sign == 1 and shown[0]) or (sign == -1 and shown[1])


def _pair(naming: Naming, product: Factors) -> tuple[Line, ...]:
    """Response of two factors in partial fractions, where they have no root in common."""
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
    terms: list[str] = []
    for factor, found in zip(product, numerators, strict=True):
        for k, n in reversed(list(enumerate(found))):
            coefficient = sp.factor_terms(sp.cancel(values[n]))
            if coefficient == 0:
                continue
            function = _response_text(naming, k, factor)
            sign, text = notation.factor(coefficient)
            text = function if text == "1" else rf"{text}\,{function}"
            terms.append(f"- {text}" if sign < 0 else f"+ {text}" if terms else text)
    left = notation.responses.latex(0, product, "t")
    below = notation.latex(resultant)
    outer = rf"\frac{{1}}{{{below}}} \biggl({terms[0]}"
    pieces = [outer, *terms[1:]]
    pieces[-1] += r"\biggr)"
    if not resultant.is_number:
        pieces.append(rf"\quad\text{{if }} {below} \neq 0")
    return (Line(left, "=", tuple(pieces)),)


def _resultant(one: sp.Tuple, other: sp.Tuple) -> sp.Expr:
    """Product of the differences of their roots, as it is usually written."""
    if len(one) == len(other) == 2:
        (a, b), (c, d) = one, other
        return (a - c) ** 2 + sp.factor((a * d - b * c) * (d - b))
    s = sp.Dummy("s")
    polynomials = (s ** len(f) + sum(c * s**k for k, c in enumerate(f)) for f in (one, other))
    return sp.factor(sp.resultant(*polynomials, s))


def _response_text(naming: Naming, order: int, factor: sp.Tuple) -> str:
    """A response of one factor: a constant or trigonometric one is written as such."""
    notation = naming.notation
    function = ExponentialDifference(order, TIME, factor)
    if function == 1:
        return "1"
    if len(factor) == 2 and factor[1] == 0 and is_positive(factor[0], naming.system.parameters):
        omega = sp.sqrt(factor[0])
        trigonometric = sp.cos(omega * TIME) if order else sp.sin(omega * TIME) / omega
        return notation.latex(trigonometric)
    return notation.responses.latex(order, (factor,), "t")


def _motion(naming: Naming, flow: Flow) -> Formula:
    """Each state after a time, from the states at the start."""
    notation, states = naming.notation, naming.system.states
    matrix, offset = flow.matrix(), flow.offset()
    field, _ = flow.field
    starts = [sp.Symbol(f"{s}_start", real=True) for s in states]
    written = notation.with_names(
        {b: f"{notation.symbol(s)}(0)" for b, s in zip(starts, states, strict=True)}
    )
    lines = []
    for i, state in enumerate(states):
        rate = [j for j in range(len(states)) if field[j, i] == 1 and _only(field.row(j), i)]
        left = f"{notation.symbol(state)}(t)"
        if rate and rate[0] < i and flow.field[1][rate[0]] == 0:
            right = (f"{notation.symbol(states[rate[0]])}'(t)",)
            lines.append(Line(left, "=", right))
            continue
        total = sp.Add(
            *(
                sp.factor_terms(sp.expand(e)) * s
                for e, s in zip(matrix.row(i), starts, strict=True)
            ),
            sp.factor_terms(sp.expand(offset[i])),
        )
        lines.append(Line(left, "=", written.pieces(total)))
    return Formula(tuple(lines))


def _only(row: sp.Matrix, place: int) -> bool:
    return all(e == 0 for j, e in enumerate(row) if j != place)
