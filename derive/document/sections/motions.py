"""Motions of damped and forced configurations in their impulse responses, and steady responses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.layout import LINE_WIDTH, width
from nonsmooth.derive.document.notation.letters import Factors, Letters
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.wording import Naming
from nonsmooth.derive.document.sections.template import (
    beside,
    compose,
    relation,
    summed,
    with_signs,
)
from nonsmooth.derive.document.views.motions import (
    Displacements,
    Modes,
    modes_of,
    positions_of,
    steady_of,
)
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol

__all__ = ["motion_blocks", "steady_blocks"]


def motion_blocks(
    naming: Naming,
    letters: Letters,
    flow: Flow,
    displacements: Displacements,
    number: int,
    listed: str,
) -> list[Block]:
    """Blocks on the state after a time in one flow, in modal form where that is short.

    Otherwise the states are written one by one. `number` is that of the flow, and `listed`
    names the configurations that have it.
    """
    notation = naming.notation
    modes = modes_of(flow, displacements)
    lines = _motion(naming, flow, displacements)
    vector = _vector(naming)
    matrices: dict[str, str] = {}
    if modes is not None and vector is not None:
        matrices = {
            rf"{letters.projector}_{{{number},{k}}}": notation.latex(matrix)
            for k, matrix in enumerate(modes.matrices, start=1)
        }
    shown = [f"{name} = {matrix}" for name, matrix in matrices.items()]
    if modes is None or vector is None or max(map(width, shown)) > LINE_WIDTH:
        return compose(
            naming,
            r"""
            $\Phi_{@number}$, @listed: each coordinate by itself,
            $$
            @lines
            $$
            """,
            number=number,
            listed=listed,
            lines=list(lines.values()),
        )
    return compose(
        naming,
        r"""
        $\Phi_{@number}$, @listed: in modal form, with $@vector = \left(@column\right)^{\mathsf{T}}$
        and a matrix for each mode,
        $$
        @matrices
        $$
        $$
        @lines
        $$
        """,
        number=number,
        listed=listed,
        vector=vector,
        column=", ".join(notation.symbol(naming.system.states[i]) for i in modes.positions),
        matrices=Line("", "", beside(shown)),
        lines=[
            _modal_line(naming, modes, list(matrices), vector),
            *(line for i, line in lines.items() if i not in modes.positions),
        ],
    )


def _starts(naming: Naming) -> list[sp.Symbol]:
    """Symbols of the states at the time 0."""
    written = naming.notation.symbol
    return [Symbol("written", f"{s}_start", f"{written(s)}(0)") for s in naming.system.states]


def _vector(naming: Naming) -> str | None:
    """Letter of the vector of positions that no symbol has; None if there is none."""
    notation, system = naming.notation, naming.system
    taken = {notation.symbol(s) for s in (*system.states, *notation.constants, *notation.unknowns)}
    return next((x for x in ("x", "q", r"\mathsf{x}") if x not in taken), None)


def _modal_line(naming: Naming, modes: Modes, names: Sequence[str], vector: str) -> Line:
    """Line that shows the positions as a sum over the modes."""
    written, starts = naming.notation, _starts(naming)
    pieces: list[tuple[int, str]] = []
    separator = r"\, "
    for name, (displaced, pushed) in zip(names, modes.matrices.values(), strict=True):
        inner = [
            (sign, f"{'' if text == '1' else text + separator}{start}")
            for function, start in ((displaced, f"{vector}(0)"), (pushed, f"{vector}'(0)"))
            for term in sp.Add.make_args(function)
            if term != 0
            for sign, text in [written.factor(term)]
        ]
        pieces.append((1, rf"{name} \left({' '.join(with_signs(inner))}\right)"))
    for column, beside_start in modes.columns.items():
        total = sp.Add(*(f * (starts[i] if i >= 0 else 1) for i, f in beside_start.items()))
        common, whole = _common(column)
        sign, text = written.factor(sp.factor_terms(common * total))
        pieces.append((sign, rf"{text} {written.latex(whole.T)}^{{\mathsf{{T}}}}"))
    return Line(f"{vector}(t)", "=", with_signs(pieces))


def _common(column: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """Factor that all entries of a column share, and the column without it."""
    entries = [e for e in column if e != 0]
    shared = set(sp.Mul.make_args(entries[0]))
    for entry in entries[1:]:
        shared &= set(sp.Mul.make_args(entry))
    factor = sp.Mul(*shared)
    return factor, sp.ImmutableMatrix(column / factor)


def _motion(naming: Naming, flow: Flow, displacements: Displacements) -> dict[int, Line]:
    """Lines, by index of the state, for each state after a time."""
    notation, states = naming.notation, naming.system.states
    matrix, offset = flow.matrix(), flow.offset()
    starts = _starts(naming)
    rates = {velocity: place for place, velocity in positions_of(flow).items()}
    lines = {}
    for i, state in enumerate(states):
        left = f"{notation.symbol(state)}(t)"
        if i in rates:
            lines[i] = Line(left, "=", (f"{notation.symbol(states[rates[i]])}'(t)",))
            continue
        terms = [
            sp.factor_terms(displacements.insert(entry)) * start
            for entry, start in zip(matrix.row(i), starts, strict=True)
        ]
        terms.append(sp.factor_terms(sp.expand(offset[i])))
        lines[i] = Line(left, "=", summed(notation, terms))
    return lines


def steady_blocks(
    naming: Naming, letters: Letters, flows: Sequence[tuple[str, Flow]]
) -> list[Block]:
    """Blocks on steady responses to one harmonic forcing: amplitudes and lags.

    Each of the `flows` comes with the names of the configurations that have it.
    """
    system, notation = naming.system, naming.notation
    if len(system.forcing) != 1:
        return []
    ((cosine, sine),) = system.forcing
    places = system.states.index(cosine), system.states.index(sine)
    found = [(listed, steady_of(flow, *places)) for listed, flow in flows]
    known = [(listed, steady) for listed, steady in found if steady]
    if not known:
        return []
    transfers = {f: steady.transfer(f) for _, steady in known for f in steady.factors}
    alike: dict[tuple[Line, ...], list[str]] = {}
    for listed, steady in known:
        lines = tuple(
            relation(
                naming,
                f"{_steady_symbol(notation, system.states[place])}(t)",
                _steady_pieces(naming, letters, terms, transfers),
            )
            for place, terms in steady.terms.items()
        )
        alike.setdefault(lines, []).append(listed)
    return compose(
        naming,
        """
        Let $@phase(t)$ be the phase of the forcing, @pair its cosine and sine. In the steady
        response each factor $@notation.responses.polynomial_{j}$ multiplies the amplitude by
        $@amplitude_{j}$ [lagging: and lags behind by $@lag_{j}$ | , unbounded in resonance],
        $$
        @transfers
        $$
        and what is left of a motion is a free one, from the differences at the start. The steady
        responses are

        @responses
        """,
        pair=(cosine, sine),
        lagging=any(imaginary != 0 for _, imaginary in transfers.values()),
        transfers=_transfers(naming, letters, transfers),
        responses=[
            block
            for lines, sharing in alike.items()
            for block in (Paragraph(f"{', '.join(sharing)}:"), Formula(lines))
        ],
        **vars(letters),
    )


def _transfers(
    naming: Naming, letters: Letters, transfers: Mapping[sp.Tuple, tuple[sp.Expr, sp.Expr]]
) -> list[Line]:
    """Lines with the amplitude and lag of each factor at the forcing's frequency."""
    notation = naming.notation
    lines = []
    for factor in sorted(transfers, key=notation.responses.number):
        real, imaginary = transfers[factor]
        number = notation.responses.number(factor)
        size = notation.latex(real**2 + imaginary**2 if imaginary != 0 else real)
        size = rf"\sqrt{{{size}}}" if imaginary != 0 else size
        left = rf"{letters.amplitude}_{{{number}}}"
        whole = notation.latex(1 / real) if imaginary == 0 and real.is_number else None
        lines.append(Line(left, "=", (whole or rf"\frac{{1}}{{{size}}}",)))
        if imaginary != 0:
            sign, text = notation.factor(imaginary)
            inside = rf"{notation.latex(real)} {'-' if sign < 0 else '+'} {text} \mathrm{{i}}"
            angle = rf"\operatorname{{arg}}\left({inside}\right)"
            lines.append(Line(rf"{letters.lag}_{{{number}}}", "=", (angle,)))
    return lines


def _steady_symbol(notation: Notation, state: sp.Symbol) -> str:
    """LaTeX of a coordinate with the index of a steady response."""
    text = notation.symbol(state)
    return f"{text[:-1]},p}}" if "_{" in text else f"{text}_{{p}}"


def _steady_pieces(
    naming: Naming,
    letters: Letters,
    terms: Sequence[tuple[Factors, sp.Expr, sp.Expr]],
    transfers: Mapping[sp.Tuple, tuple[sp.Expr, sp.Expr]],
) -> tuple[str, ...]:
    """LaTeX of the harmonic terms of a steady response."""
    notation = naming.notation
    pieces: list[tuple[int, str]] = []
    for product, cosine, sine in terms:
        gain = " ".join(rf"{letters.amplitude}_{{{notation.responses.number(f)}}}" for f in product)
        lags = "".join(
            rf" - {letters.lag}_{{{notation.responses.number(f)}}}"
            for f in product
            if transfers[f][1] != 0
        )
        for coefficient, name in ((cosine, "cos"), (sine, "sin")):
            if coefficient != 0:
                sign, text = notation.factor(sp.factor_terms(coefficient))
                text = "" if text == "1" else f"{text} "
                angle = rf"\{name}\left({letters.phase}(t){lags}\right)"
                pieces.append((sign, f"{text}{gain} {angle}"))
    return with_signs(pieces)
