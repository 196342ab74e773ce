"""Motions of damped and forced configurations in their impulse responses, and steady responses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.layout import LINE_WIDTH, width
from nonsmooth.derive.document.notation.letters import Factors, Letters
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.wording import Naming
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
    head = rf"$\Phi_{{{number}}}$, {listed}:"
    modes = modes_of(flow, displacements)
    lines = _motion(naming, flow, displacements)
    vector = _vector(naming)
    coordinates: list[Block] = [
        Paragraph(f"{head} each coordinate by itself,"),
        Formula(tuple(lines.values())),
    ]
    if modes is None or vector is None:
        return coordinates
    names = [rf"{letters.projector}_{{{number},{k}}}" for k in range(1, len(modes.matrices) + 1)]
    column = ", ".join(naming.notation.symbol(naming.system.states[i]) for i in modes.positions)
    matrices = [
        f"{name} = {naming.notation.latex(matrix)}"
        for name, matrix in zip(names, modes.matrices, strict=True)
    ]
    if max(map(width, matrices)) > LINE_WIDTH:
        return coordinates
    pieces = (*(rf"{text},\qquad" for text in matrices[:-1]), matrices[-1])
    others = [line for i, line in lines.items() if i not in modes.positions]
    return [
        Paragraph(
            rf"{head} in modal form, with ${vector} ="
            rf" \left({column}\right)^{{\mathsf{{T}}}}$ and a matrix for each mode,"
        ),
        Formula((Line("", "", pieces),)),
        Formula((_modal_line(naming, modes, names, vector), *others)),
    ]


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
    pieces: list[str] = []
    for name, (displaced, pushed) in zip(names, modes.matrices.values(), strict=True):
        inner: list[str] = []
        for function, start in ((displaced, f"{vector}(0)"), (pushed, f"{vector}'(0)")):
            for term in sp.Add.make_args(function):
                if term != 0:
                    sign, text = written.factor(term)
                    text = "" if text == "1" else f"{text}\\, "
                    inner.append(f"{'-' if sign < 0 else '+' if inner else ''} {text}{start}")
        pieces.append(rf"{'+ ' if pieces else ''}{name} \left({' '.join(inner).strip()}\right)")
    for column, beside in modes.columns.items():
        total = sp.Add(*(f * (starts[place] if place >= 0 else 1) for place, f in beside.items()))
        common, whole = _common(column)
        sign, text = written.factor(sp.factor_terms(common * total))
        shown = rf"{written.latex(whole.T)}^{{\mathsf{{T}}}}"
        pieces.append(f"{'-' if sign < 0 else '+'} {text} {shown}")
    return Line(f"{vector}(t)", "=", tuple(pieces))


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
        pieces: list[str] = []
        for term in terms:
            if term == 0:
                continue
            first, *rest = notation.pieces(term)
            pieces += [f"+ {first}" if pieces and not first.startswith("-") else first, *rest]
        lines[i] = Line(left, "=", tuple(pieces) or ("0",))
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
    h, lag, phase = letters.amplitude, letters.lag, letters.phase
    transfers = {f: steady.transfer(f) for _, steady in known for f in steady.factors}
    damped = any(imaginary != 0 for _, imaginary in transfers.values())
    text = (
        f"Let ${phase}(t)$ be the phase of the forcing, {naming.list((cosine, sine))} its cosine"
        f" and sine. In the steady response each factor ${notation.responses.polynomial}_{{j}}$"
        f" multiplies the amplitude by ${h}_{{j}}$"
        + (f" and lags behind by ${lag}_{{j}}$," if damped else ", unbounded in resonance,")
    )
    blocks: list[Block] = [Paragraph(text), Formula(tuple(_transfers(naming, letters, transfers)))]
    blocks.append(
        Paragraph(
            "and what is left of a motion is a free one, from the differences at the start."
            " The steady responses are"
        )
    )
    alike: dict[tuple[Line, ...], list[str]] = {}
    for listed, steady in known:
        lines = tuple(
            Line(
                f"{_steady_symbol(notation, system.states[place])}(t)",
                "=",
                _steady_pieces(naming, letters, terms, transfers),
            )
            for place, terms in steady.terms.items()
        )
        alike.setdefault(lines, []).append(listed)
    for lines, sharing in alike.items():
        blocks += [Paragraph(f"{', '.join(sharing)}:"), Formula(lines)]
    return blocks


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
    notation, pieces = naming.notation, list[str]()
    for product, cosine, sine in terms:
        numbers = [notation.responses.number(f) for f in product]
        gain = " ".join(rf"{letters.amplitude}_{{{n}}}" for n in numbers)
        lags = "".join(
            rf" - {letters.lag}_{{{n}}}"
            for n, f in zip(numbers, product, strict=True)
            if transfers[f][1] != 0
        )
        for coefficient, name in ((cosine, "cos"), (sine, "sin")):
            if coefficient == 0:
                continue
            sign, text = notation.factor(sp.factor_terms(coefficient))
            text = "" if text == "1" else f"{text} "
            angle = rf"\{name}\left({letters.phase}(t){lags}\right)"
            head = "- " if sign < 0 else "+ " if pieces else ""
            pieces.append(f"{head}{text}{gain} {angle}")
    return tuple(pieces)
