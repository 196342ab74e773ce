"""Equations of motion as they are written: in matrices, or row by row where those are wide."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.dynamics import FirstOrder, SecondOrder
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.layout import LINE_WIDTH, width
from nonsmooth.derive.document.notation.wording import Naming

__all__ = ["MatrixLetters", "field_formula", "matrices_of", "motion_of"]

# of matrices, by the attribute of the motion that they are
MatrixLetters = dict[tuple[str, sp.Matrix], str]

# em that relations side by side leave between them
_BETWEEN = 2.0


def matrices_of(
    motions: Sequence[SecondOrder], naming: Naming, damped: bool
) -> tuple[Formula, MatrixLetters]:
    """Formula of M, C and K, and their letters, numbered where configurations differ in them."""
    shown: MatrixLetters = {}
    pieces: list[str] = []
    attributes = [("M", "mass"), *([("C", "damping")] if damped else []), ("K", "stiffness")]
    for letter, attribute in attributes:
        different = list(dict.fromkeys(getattr(d, attribute) for d in motions))
        for index, matrix in enumerate(different, start=1):
            name = letter if len(different) == 1 else f"{letter}_{{{index}}}"
            shown[attribute, matrix] = name
            pieces += _shown(naming, name, matrix)
    pieces = [*(rf"{piece},\qquad" for piece in pieces[:-1]), f"{pieces[-1]}."]
    return Formula((Line("", "", tuple(pieces)),)), shown


def _shown(naming: Naming, name: str, matrix: sp.Matrix) -> list[str]:
    """LaTeX of a matrix, or of its nonzero entries if it is too wide for a line."""
    text = f"{name} = {naming.notation.latex(matrix)}"
    if width(text) <= LINE_WIDTH:
        return [text]
    size = matrix.rows
    entries = [(i, j) for i in range(size) for j in range(size) if matrix[i, j] != 0]
    comma = "," if size > 9 else ""
    return [
        rf"{name}^{{{i + 1}{comma}{j + 1}}} = {naming.notation.latex(matrix[i, j])}"
        for i, j in entries
    ]


def motion_of(configuration: Configuration, naming: Naming, letters: MatrixLetters) -> list[Block]:
    """Blocks with the equations of motion, in the letters of the matrices if given."""
    notation, dynamics, states = naming.notation, configuration.dynamics, naming.system.states
    matrix, offset = dynamics.field(states)
    matrix, offset = matrix.applyfunc(cancel), offset.applyfunc(cancel)
    if isinstance(dynamics, FirstOrder):
        return _first_order(naming, matrix, offset)
    x, size = naming.letter, dynamics.mass.rows
    if size == 1:
        rate = _accelerations(naming, dynamics, matrix, offset)
        return [rate if dynamics.held else _single(naming, dynamics)]
    if letters:
        left = f"{letters['mass', dynamics.mass]} {x}''"
        if not dynamics.damping.is_zero_matrix:
            left += f" + {letters['damping', dynamics.damping]} {x}'"
        load = dynamics.load
        right = "0" if load.is_zero_matrix else notation.latex(load.applyfunc(notation.tidy))
        left += f" + {letters['stiffness', dynamics.stiffness]} {x}"
        return [Formula((Line(left, "=", (right,)),))]
    stiffness, damping = -matrix[size:, :size], -matrix[size:, size:]
    left = f"{x}''"
    if not damping.is_zero_matrix:
        left += f" + {notation.latex(damping)} {x}'"
    if not stiffness.is_zero_matrix:
        left += f" + {notation.latex(stiffness)} {x}"
    load = offset[size:, :]
    right = "0" if load.is_zero_matrix else notation.latex(load.applyfunc(notation.tidy))
    held = [
        rf"{notation.symbol(states[i])}' = {notation.latex(v)}"
        for i, v in sorted(dynamics.held_at(states).items())
    ]
    right = r",\quad ".join([right, *held])
    if width(left) + width(right) > LINE_WIDTH:
        return [_accelerations(naming, dynamics, matrix, offset)]
    return [Formula((Line(left, "=", (right,)),))]


def _single(naming: Naming, dynamics: SecondOrder) -> Formula:
    """Equation of motion of a single coordinate, with mass, damping and stiffness."""
    notation = naming.notation
    x = notation.symbol(naming.system.states[0])
    found: list[str] = []
    for matrix, primes in (
        (dynamics.mass, "''"),
        (dynamics.damping, "'"),
        (dynamics.stiffness, ""),
    ):
        coefficient = matrix[0]
        if coefficient == 0:
            continue
        sign, text = notation.factor(coefficient)
        term = f"{'' if text == '1' else f'{text} '}{x}{primes}"
        found.append(f"- {term}" if sign < 0 else f"+ {term}" if found else term)
    load = dynamics.load[0]
    right = notation.pieces(notation.tidy(load))
    return Formula((Line(" ".join(found), "=", right, None, load),))


def _accelerations(
    naming: Naming, dynamics: SecondOrder, matrix: sp.Matrix, offset: sp.Matrix
) -> Formula:
    """Formula of the accelerations, one line for each coordinate."""
    notation, states, size = naming.notation, naming.system.states, dynamics.mass.rows
    held = dynamics.held_at(states)
    lines = []
    for i in range(size):
        x = notation.symbol(states[i])
        row = (matrix[size + i, :] * sp.Matrix(states))[0] + offset[size + i]
        left, right = (f"{x}'", held[i]) if i in held else (f"{x}''", row)
        lines.append(Line(left, "=", notation.pieces(notation.tidy(right)), None, right))
    return Formula(tuple(lines))


def _first_order(naming: Naming, matrix: sp.Matrix, offset: sp.Matrix) -> list[Block]:
    """Blocks with the equations state by state, then in matrices if those are narrow."""
    blocks: list[Block] = [field_formula(naming, matrix, offset)]
    pieces = [f"{naming.notation.latex(matrix)} {naming.state}"]
    if not offset.is_zero_matrix:
        pieces.append(f"+ {naming.notation.latex(offset)}")
    if matrix.rows > 1 and sum(map(width, (naming.state, *pieces))) <= LINE_WIDTH - 4:
        line = Line(f"{naming.state}'", "=", tuple(pieces))
        blocks += [Paragraph("or, in matrices,"), Formula((line,))]
    return blocks


def field_formula(naming: Naming, matrix: sp.Matrix, offset: sp.Matrix) -> Formula:
    """Formula of the states' derivatives by time, short ones side by side."""
    notation, states = naming.notation, naming.system.states
    lines: list[Line] = []
    used = 0.0
    for symbol, right in zip(states, matrix * sp.Matrix(states) + offset, strict=True):
        left = f"{notation.symbol(symbol)}'"
        line = Line(left, "=", notation.pieces(notation.tidy(right)), None, right)
        needed = width(line.latex)
        if lines and used + needed + _BETWEEN <= LINE_WIDTH:
            before = lines.pop()
            parts = (*(before.parts or (before,)), line)
            pieces = (*before.pieces[:-1], rf"{before.pieces[-1]},\qquad", line.latex)
            lines.append(Line(before.left, "=", pieces, parts=parts))
            used += needed + _BETWEEN
        else:
            lines.append(line)
            used = needed
    return Formula(tuple(lines))
