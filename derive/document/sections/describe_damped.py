"""The closed form of one damped coordinate, with the cases of its discriminant."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.parameter import Parameter, is_positive
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.letters import Letters
from nonsmooth.derive.document.notation.wording import Naming

__all__ = ["DampedCoordinate", "damped_blocks", "damped_coordinate"]

_RELATIONS = {-1: "< 0", 0: "= 0", 1: "> 0"}


@dataclass(frozen=True)
class DampedCoordinate:
    """The motion ``x'' + 2 decay x' + square x = square centre`` of one coordinate.

    Attributes
    ----------
    decay : expression
        Half the coefficient of the velocity.
    square : expression
        Coefficient of the position; not zero.
    centre : expression
        Position of rest.
    """

    decay: sp.Expr
    square: sp.Expr
    centre: sp.Expr

    @property
    def discriminant(self) -> sp.Expr:
        """Positive where the motion is overdamped."""
        return sp.expand(sp.cancel(self.decay**2 - self.square))

    def cases(self, parameters: Sequence[Parameter]) -> tuple[int, ...]:
        """Signs that the discriminant may have on the domain of the parameters."""
        found = self.discriminant
        if found.is_number:
            return (int(sp.sign(found)),)
        if is_positive(found, parameters):
            return (1,)
        return (-1,) if is_positive(-found, parameters) else (-1, 0, 1)


def damped_coordinate(
    field: tuple[sp.Matrix, sp.Matrix], parameters: Iterable[Parameter]
) -> DampedCoordinate | None:
    """The one coordinate of a field y' = A y + b of two states; None if it is not of that kind."""
    matrix, offset = field
    if matrix.shape != (2, 2) or list(matrix.row(0)) != [0, 1] or offset[0] != 0:
        return None
    square, decay = sp.cancel(-matrix[1, 0]), sp.cancel(-matrix[1, 1] / 2)
    known = list(parameters)
    if decay == 0 or not (is_positive(square, known) or is_positive(-square, known)):
        return None
    return DampedCoordinate(decay, square, sp.factor(sp.cancel(offset[1] / square)))


def damped_blocks(naming: Naming, letters: Letters, motion: DampedCoordinate) -> list[Block]:
    """Position and velocity as functions of time, and the functions in each case."""
    notation, parameters = naming.notation, naming.system.parameters
    x, v = (notation.symbol(s) for s in naming.system.states)
    start, sine = sp.symbols("start sine", real=True)
    written = notation.with_names({start: f"{x}(0)", sine: r"\operatorname{S}(t)"})
    rest = "" if motion.centre == 0 else f"{notation.latex(motion.centre)} + "
    first, *others = written.pieces(start - motion.centre)
    distance = " ".join([first, *others])
    distance = rf"\left({distance}\right)" if others else distance
    sign, damped = written.term(motion.decay * sine)
    oscillation = rf"\operatorname{{C}}(t) {'-' if sign < 0 else '+'} {damped}"
    solution = (
        rf"{rest}{notation.latex(sp.exp(-motion.decay * sp.Symbol('t')))} \biggl(",
        rf"{distance} \left({oscillation}\right)",
        rf"+ {v}(0) \operatorname{{S}}(t)\biggr),\qquad",
        rf"{v}(t) = {x}'(t),",
    )
    chosen = motion.cases(parameters)
    *relation, last = notation.pieces(motion.discriminant)
    known = f" {_RELATIONS[chosen[0]]}" if len(chosen) == 1 else ""
    lines = [
        Line(letters.discriminant, "=", (*relation, f"{last}{known},"), None, motion.discriminant),
        *(_case(letters.discriminant, sign, named=len(chosen) > 1) for sign in chosen),
    ]
    end = lines[-1]
    lines[-1] = Line(end.left, end.relation, (*end.pieces[:-1], f"{end.pieces[-1]}."))
    return [
        Paragraph("As it has one coordinate alone, its motion is, in closed form,"),
        Formula((Line(f"{x}(t)", "=", solution),)),
        Paragraph("with the discriminant and its functions"),
        Formula(tuple(lines)),
    ]


def _case(discriminant: str, sign: int, *, named: bool) -> Line:
    """Functions C and S where the discriminant has a sign."""
    condition = rf"\quad\text{{if }} {discriminant} {_RELATIONS[sign]}" if named else ""
    root = rf"\sqrt{{{'-' if sign < 0 else ''}{discriminant}}}"
    cosine, sine = (r"\cos", r"\sin") if sign < 0 else (r"\cosh", r"\sinh")
    angle = rf"\left({root}\,t\right)"
    left, right = (
        (rf"{cosine}{angle}", rf"\frac{{{sine}{angle}}}{{{root}}}") if sign else ("1", "t")
    )
    pieces = (rf"{left},\qquad", rf"\operatorname{{S}}(t) = {right}{condition}")
    return Line(r"\operatorname{C}(t)", "=", pieces)
