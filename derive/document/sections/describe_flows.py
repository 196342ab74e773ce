"""Flows of configurations as sums of functions of time times constant matrices."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.layout import width
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.wording import Naming, enumeration
from nonsmooth.derive.document.views.centres import Centres, centre_of
from nonsmooth.derive.flows.modal import Flow

__all__ = ["flow_blocks"]

_Terms = list[tuple[sp.Expr, sp.Matrix]]

# em beyond which a matrix is not written inside a sum
_WIDE = 24.0


def flow_blocks(
    naming: Naming, flows: Sequence[Flow], centres: Centres | None = None
) -> tuple[list[Block], dict[str, int]]:
    """Blocks on flows in closed form, and the number of each configuration's flow.

    Flows with equal matrices share a number and are shown once.
    """
    notation, state, in_blocks = naming.notation, naming.state, naming.second_order
    distinct: list[Flow] = []
    numbers: dict[str, int] = {}
    for flow in flows:
        same = (f for f in distinct if (f.basis, f.matrices) == (flow.basis, flow.matrices))
        known = next(same, None)
        if known is None:
            distinct.append(flow)
            known = flow
        numbers[flow.configuration] = distinct.index(known) + 1
    blocks = _centres(notation, state, flows, numbers, centres)
    functions = [g for f in distinct for g in f.basis]
    if in_blocks:
        blocks.append(
            Paragraph(
                r"The flows are written by blocks of positions and velocities,"
                r" $\Phi^{11}$ and $\Phi^{12}$ for the positions, $\Phi^{21}$ and $\Phi^{22}$ for"
                r" the velocities; $I$ is the unit matrix."
                + (
                    " The matrices at the cosines are the projectors on the modes."
                    if any(g.has(sp.cos) for g in functions)
                    else ""
                )
            )
        )
    names: dict[sp.Matrix, str] = {}
    for number, flow in enumerate(distinct, start=1):
        sharing = [c for c, n in numbers.items() if n == number]
        blocks.append(Paragraph(rf"$\Phi_{{{number}}}$, {naming.flow_of(sharing)}:"))
        blocks += _flow(notation, flow, number, in_blocks, names)
    return blocks, numbers


def _centres(
    notation: Notation,
    state: str,
    flows: Sequence[Flow],
    numbers: dict[str, int],
    named: Centres | None,
) -> list[Block]:
    """Blocks that show how each configuration maps a state: about a centre, or with an offset."""
    centred: list[tuple[Flow, sp.Matrix]] = []
    drifting: list[Flow] = []
    for flow in flows:
        centre = centre_of(flow)
        if centre is None:
            drifting.append(flow)
        elif not centre.is_zero_matrix:
            centred.append((flow, centre))
    shifted = rf"${state}(t) = d + \Phi(t)\,({state}(0) - d)$"
    blocks: list[Block] = []
    if centred and named and named.columns:
        rows = [
            rf"$d = {notation.latex(named.columns[f.configuration].T)}^{{\mathsf{{T}}}}$"
            f" in *{f.configuration}*"
            for f, _ in centred
        ]
        away = [f.configuration for f in (*(f for f, _ in centred), *drifting)]
        others = [f"*{f.configuration}*" for f in flows if f.configuration not in away]
        origin = f" and the origin in {enumeration(others)}" if others else ""
        blocks += [
            Paragraph(
                f"Inside a configuration with the centre $d$, {shifted}. The centre is"
                f" {enumeration(rows)}{origin}, with"
            ),
            Formula(
                tuple(
                    Line(notation.symbol(s), "=", notation.pieces(sp.factor(e)), s, e)
                    for s, e in named.values.items()
                )
            ),
        ]
    elif centred:
        blocks.append(
            Paragraph(
                f"Inside a configuration with the centre $d$, {shifted}; the centres that differ"
                " from the origin are"
            )
        )
        lines = []
        for flow, centre in centred:
            column = notation.latex(centre.T.applyfunc(notation.tidy))
            left = rf"d_{{\text{{{flow.configuration}}}}}"
            lines.append(Line(left, "=", (rf"{column}^{{\mathsf{{T}}}}",)))
        blocks.append(Formula(tuple(lines)))
    elif not drifting:
        where = (
            "the centre is at the origin"
            if len(flows) == 1
            else "every one of the configurations has its centre at the origin"
        )
        blocks.append(
            Paragraph(rf"In these coordinates {where}, so that ${state}(t) = \Phi(t)\,{state}(0)$.")
        )
    for flow in drifting:
        pieces = [rf"\Phi_{{{numbers[flow.configuration]}}}(t)\,{state}(0)"]
        for function, offset in zip(flow.basis, flow.offsets, strict=True):
            if not offset.is_zero_matrix:
                scalar = "" if function == 1 else rf"{notation.latex(function)}\,"
                column = notation.latex(offset.applyfunc(notation.tidy))
                pieces.append(f"+ {scalar}{column}")
        blocks.append(Paragraph(f"*{flow.configuration}* has no centre; there"))
        blocks.append(Formula((Line(f"{state}(t)", "=", tuple(pieces)),)))
    return blocks


def _flow(
    notation: Notation, flow: Flow, number: int, in_blocks: bool, names: dict[sp.Matrix, str]
) -> list[Block]:
    """Blocks on one flow; constant matrices that occur more than once get a name."""
    size = flow.matrices[0].rows
    half = size // 2 if in_blocks else size
    parts: dict[str, tuple[_Terms, sp.Matrix]] = {}
    known = dict.fromkeys(names)
    for i in range(size // half):
        for j in range(size // half):
            place = (slice(i * half, (i + 1) * half), slice(j * half, (j + 1) * half))
            terms = [
                (function, sp.ImmutableMatrix(matrix[place]))
                for function, matrix in zip(flow.basis, flow.matrices, strict=True)
            ]
            head = rf"\Phi_{{{number}}}" + (f"^{{{i + 1}{j + 1}}}" if in_blocks else "") + "(t)"
            parts[head] = (_collected(terms, known), sp.ImmutableMatrix(flow.matrix()[place]))
    # equal blocks make one line
    heads: dict[tuple[tuple[sp.Expr, sp.Matrix], ...], list[str]] = {}
    for head, (found, _) in parts.items():
        heads.setdefault(tuple(found), []).append(head)
    blocks = _definitions(notation, [m for found in heads for _, m in found], names)
    lines = [
        Line(" = ".join(equal), "=", _pieces(notation, found, names), None, parts[equal[0]][1])
        for found, equal in heads.items()
    ]
    return [*blocks, Formula(tuple(lines))]


def _definitions(
    notation: Notation, occurring: Sequence[sp.Matrix], names: dict[sp.Matrix, str]
) -> list[Block]:
    """Blocks that define names for the matrices that occur more than once or are wide.

    A wide matrix is written as a product of two others where that is possible, otherwise
    entry by entry.
    """
    ordinary = [m for m in occurring if m.rows > 1 and m != sp.eye(m.rows)]
    wide = [m for m in ordinary if width(notation.latex(m)) > _WIDE]
    narrow: list[sp.Matrix] = []
    large: list[sp.Matrix] = []

    def name(matrix: sp.Matrix) -> str:
        if matrix not in names:
            number = sum(" " not in n for n in names.values()) + 1
            names[matrix] = f"P_{{{number}}}"
            (large if matrix in wide else narrow).append(matrix)
        return names[matrix]

    for matrix in dict.fromkeys(m for m in ordinary if ordinary.count(m) > 1):
        name(matrix)
    for matrix in dict.fromkeys(m for m in wide if m not in names):
        pair = _factors(matrix, list(dict.fromkeys(m for m in ordinary if m != matrix)))
        if pair:
            names[matrix] = " ".join([name(pair[0]), name(pair[1])])
        else:
            name(matrix)
    blocks: list[Block] = []
    if narrow:
        texts = [f"{names[m]} = {notation.latex(m)}" for m in narrow]
        pieces = (*(rf"{text},\qquad" for text in texts[:-1]), texts[-1])
        blocks.append(Formula((Line("", "", pieces),)))
    for matrix in large:
        lines = [
            Line(
                rf"\left({names[matrix]}\right)_{{{i + 1}{j + 1}}}",
                "=",
                notation.pieces(matrix[i, j]),
                None,
                matrix[i, j],
            )
            for i in range(matrix.rows)
            for j in range(matrix.cols)
        ]
        blocks.append(Formula(tuple(lines)))
    return blocks


def _factors(
    matrix: sp.Matrix, candidates: Sequence[sp.Matrix]
) -> tuple[sp.Matrix, sp.Matrix] | None:
    """Two candidates whose product is the matrix; None if there are none."""
    for left in candidates:
        for right in candidates:
            if (left * right - matrix).applyfunc(sp.expand).is_zero_matrix:
                return left, right
    return None


def _collected(terms: _Terms, known: dict[sp.Matrix, None]) -> _Terms:
    """Terms of a sum with common factors taken out of the matrices, and equal ones joined.

    A matrix takes the sign with which it is known already.
    """
    found: dict[sp.Matrix, sp.Expr] = {}
    for function, matrix in terms:
        if matrix.is_zero_matrix:
            continue
        factor, rest = _common_factor(matrix)
        if -rest in known:
            factor, rest = -factor, -rest
        known[rest] = None
        found[rest] = found.get(rest, sp.Integer(0)) + factor * function
    return [(scalar, matrix) for matrix, scalar in found.items()]


def _common_factor(matrix: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """Factor that all entries share, and the matrix without it, its first number positive."""
    entries = [e for e in matrix if e != 0]
    common = [f for f in sp.Mul.make_args(entries[0]) if not f.is_Add]
    for entry in entries[1:]:
        factors = sp.Mul.make_args(entry)
        common = [f for f in common if f in factors and f != -1]
    factor = sp.Mul(*common)
    rest = sp.ImmutableMatrix(matrix / factor).applyfunc(sp.expand)
    first = next(e for e in rest if e != 0)
    negative = (first.is_number and first < 0) or (
        all(e.could_extract_minus_sign() for e in rest if e != 0 and not e.is_Add)
        and not any(e.is_Add for e in rest)
    )
    return (-factor, -rest) if negative else (factor, rest)


def _pieces(
    notation: Notation, terms: Sequence[tuple[sp.Expr, sp.Matrix]], names: dict[sp.Matrix, str]
) -> tuple[str, ...]:
    found: list[str] = []
    for scalar, matrix in terms:
        if matrix.rows == 1:
            scalar, text = scalar * matrix[0], ""
        else:
            text = (
                "I" if matrix == sp.eye(matrix.rows) else names.get(matrix, notation.latex(matrix))
            )
        sign, factor = notation.factor(scalar) if text else notation.term(scalar)
        if text:
            text = text if factor == "1" else rf"{factor}\,{text}"
        found.append(f"{'- ' if sign < 0 else '+ ' if found else ''}{text or factor}")
    return tuple(found) or ("0",)
