"""The section of a document with the numbers of the orbit that its reference guesses."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.parameter import exact
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import enumeration, in_one_line
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.reference import ReferenceOrbit

__all__ = ["reference_section"]

_DIGITS = 12
_LARGEST = 3  # map that is shown as a matrix
_ZERO = sp.Float("1e-20")


def reference_section(view: View, orbit: ReferenceOrbit) -> list[Block]:
    """Blocks on the reference's parameters, the unknowns, the period and the multipliers."""
    equations, naming = view.equations, view.naming
    notation, reference = naming.notation, equations.itinerary.reference
    assert reference is not None  # the orbit is solved from it
    texts = {p: reference.parameters[str(p)] for p in equations.parameters}
    # decimals stay as they are declared
    values = [x if x[-1].isdigit() else notation.latex(exact(x)) for x in texts.values()]
    given = enumeration(
        [f"${notation.symbol(p)} = {x}$" for p, x in zip(texts, values, strict=True)]
    )
    cited = naming.cited("reference")
    unknowns = [
        Line(notation.symbol(u), "=", (_number(value),))
        for u, value in zip(equations.unknowns, orbit.unknowns, strict=True)
    ]
    matrix, size = orbit.map, orbit.map.rows
    lines = [
        Line(r"\text{period}", "=", (_number(orbit.period),)),
        Line(r"\operatorname{tr} J", "=", (_number(matrix.trace()),)),
    ]
    if 1 < size <= _LARGEST:
        body = r"\\".join(" & ".join(map(_number, matrix.row(i))) for i in range(size))
        shown = rf"\left(\begin{{matrix}}{body}\end{{matrix}}\right)"
        lines.append(Line("J", "=", (shown,)))
    blocks: list[Block] = [
        Paragraph(f"With {given}{cited}{',' if cited else ''} the equations have the solution"),
        Formula((in_one_line(unknowns),)),
        Paragraph("It has"),
        Formula(tuple(lines)),
    ]
    if size:
        shown = enumeration([f"${_number(m)}$" for m in orbit.multipliers])
        one = size == 1
        blocks.append(Paragraph(f"and the multiplier{'' if one else 's'} {shown}."))
    return blocks


def _number(value: sp.Expr) -> str:
    """LaTeX of a number, rounded; what is zero up to its rounding is zero."""
    real, imaginary = (
        sp.latex(part.evalf(_DIGITS)) if abs(part) > _ZERO else "" for part in value.as_real_imag()
    )
    if not imaginary:
        return real or "0"
    sign = "-" if imaginary.startswith("-") else "+" if real else ""
    return rf"{real} {sign} {imaginary.lstrip('-')}\,\mathrm{{i}}".strip()
