"""The section of a document on an itinerary's transitions, Poincaré map and multipliers."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.layout import LINE_WIDTH, width
from nonsmooth.derive.document.notation.wording import enumeration, number
from nonsmooth.derive.document.sections.describe_itinerary import transposed
from nonsmooth.derive.document.views.cycle import Cycle, Passing
from nonsmooth.derive.equations.energy import is_conservative

__all__ = ["passing_section", "stability_section"]


def passing_section(cycle: Cycle) -> list[Block]:
    """Blocks with the gradient, fields, reset and saltation matrix of each transition."""
    letters = cycle.letters
    f, n, r, s = letters.field, letters.normal, letters.reset, letters.saltation
    jump, carried = (f"{r}_{{j}}", f"{r}_{{j}} {f}_{{j}}") if cycle.resets else ("I", f"{f}_{{j}}")
    factor = rf"\frac{{{n}_{{j}}}}{{{n}_{{j}} {f}_{{j}}}}"
    what = f"the gradient ${n}_{{j}}$ and the constant ${letters.constant}_{{j}}$ of its boundary"
    what += (
        f", the vector field ${f}_{{j}}$ of the configuration in front of it and"
        f" ${f}_{{j}}^{{+}}$ of that behind it"
    )
    if cycle.resets:
        what += f", the matrix ${r}_{{j}}$ and the constant ${letters.jump}_{{j}}$ of its reset"
        what += " (the unit matrix and zero where they are not given)"
    fields = [field for p in cycle.passings for field in (p.before, p.behind)]
    written = all(width(transposed(cycle.naming, field)) + 4 <= LINE_WIDTH for field in fields)
    text = (
        f"Transition $j$ {'ends phase $j$; it ' if cycle.distinct else ''}has {what}. All are"
        " written in the state in front of the transition. A perturbed motion reaches the boundary"
        " earlier or later; to first order its perturbation behind the transition is that in front"
        " of it times the saltation matrix"
    )
    return [
        Paragraph(text),
        Formula(
            (
                Line(
                    f"{s}_{{j}}",
                    "=",
                    (rf"{jump} + \left({f}_{{j}}^{{+}} - {carried}\right) {factor}.",),
                ),
            ),
            label=cycle.label("The transitions"),
        ),
        Paragraph(
            "The boundary is crossed transversally, and the matrix is defined, only where the rate"
            f" ${n}_{{j}} {f}_{{j}}$ is positive."
        ),
        *(
            block
            for place, passing in enumerate(cycle.passings, start=1)
            for block in _passing(cycle, place, passing, written=written)
        ),
    ]


def _passing(cycle: Cycle, place: int, passing: Passing, *, written: bool) -> list[Block]:
    """Blocks on one transition, with its vector fields `written` out or their difference."""
    naming, letters = cycle.naming, cycle.letters
    notation, transition = naming.notation, passing.transition
    places = enumeration([str(k) for k in passing.phases])
    where = f" (behind phase{'s' if len(passing.phases) > 1 else ''} {places})"
    title = (
        f"Transition {place}, from *{transition.source}* by *{passing.boundary.name}* to"
        f" *{transition.target}*{'' if cycle.distinct else where}:"
    )
    j = f"_{{{place}}}"
    n, f = f"{letters.normal}{j}", f"{letters.field}{j}"
    normal = rf"{notation.latex(passing.normal)},\qquad"
    constant = f"{letters.constant}{j} = {notation.latex(notation.tidy(passing.constant))}"
    rate = Line(f"{n} {f}", "=", notation.pieces(notation.tidy(passing.rate)), None, passing.rate)
    lines = [
        Line(n, "=", (normal, constant)),
    ]
    lines += (_fields if written else _difference)(cycle, place, passing)
    if passing.resets:
        lines += _reset(cycle, place, passing)
    lines.append(rate)
    saltation = passing.saltation(naming.system.states)
    text = _matrix(cycle, saltation)
    if width(text) + 4 <= LINE_WIDTH:
        lines.append(Line(f"{letters.saltation}{j}", "=", (text,), None, saltation))
    return [Paragraph(title), Formula(tuple(lines))]


def _fields(cycle: Cycle, place: int, passing: Passing) -> list[Line]:
    """Lines for the vector fields on both sides of a transition."""
    left = f"{cycle.letters.field}_{{{place}}}"
    return [
        Line(name, "=", (transposed(cycle.naming, column),), None, column)
        for name, column in ((left, passing.before), (f"{left}^{{+}}", passing.behind))
    ]


def _difference(cycle: Cycle, place: int, passing: Passing) -> list[Line]:
    """Lines for the difference of the vector fields on both sides, at the boundary."""
    naming, letters = cycle.naming, cycle.letters
    f, behind = f"{letters.field}_{{{place}}}", f"{letters.field}_{{{place}}}^{{+}}"
    carried = f"{letters.reset}_{{{place}}} {f}" if passing.resets else f
    difference = passing.difference(naming.system.states)
    if difference.is_zero_matrix:
        return [Line(behind, "=", (carried,))]
    text = transposed(naming, difference)
    left = f"{behind} - {carried}"
    if width(left) + width(text) + 2 <= LINE_WIDTH:
        return [Line(left, "=", (text,), None, difference)]
    return [
        Line(
            rf"\left({left}\right)_{{{i}}}",
            "=",
            naming.notation.pieces(naming.notation.tidy(entry)),
            None,
            entry,
        )
        for i, entry in enumerate(difference, start=1)
        if entry != 0
    ]


def _reset(cycle: Cycle, place: int, passing: Passing) -> list[Line]:
    letters = cycle.letters
    matrix = _matrix(cycle, passing.reset)
    left, pieces = f"{letters.reset}_{{{place}}}", [matrix]
    if not passing.jump.is_zero_matrix:
        pieces = [
            rf"{matrix},\qquad",
            f"{letters.jump}_{{{place}}} = {transposed(cycle.naming, passing.jump)}",
        ]
    return [Line(left, "=", tuple(pieces))]


def _matrix(cycle: Cycle, matrix: sp.Matrix) -> str:
    notation = cycle.naming.notation
    if matrix == sp.eye(matrix.rows):
        return "I"
    if matrix.is_diagonal():
        entries = ", ".join(notation.latex(e) for e in matrix.diagonal())
        return rf"\operatorname{{diag}}\left({entries}\right)"
    return notation.latex(matrix)


def stability_section(cycle: Cycle) -> list[Block]:
    """Blocks with the Poincaré map's Jacobian and the monodromy matrix as products."""
    letters, k, phase = cycle.letters, cycle.index, cycle.phase
    f, n, e = letters.field, letters.normal, letters.embedding
    state = cycle.naming.state
    jump = rf"{letters.reset}_{{{k}}} " if cycle.resets else ""
    local = (
        rf"{jump}\left(I - \frac{{{f}_{{{k}}} {n}_{{{k}}}}}{{{n}_{{{k}}} {f}_{{{k}}}}}\right)"
        rf" \Phi^{{({phase})}}"
    )
    inner = rf"\left({cycle.product}{local}\right)" if cycle.product else local
    monodromy = rf"{cycle.product}{letters.saltation}_{{{k}}} \Phi^{{({phase})}}"
    blocks: list[Block] = [
        Paragraph(
            "On the section at the start, the dwell times follow a perturbation of the start: each"
            " phase carries it along and projects it along the vector field onto the boundary."
            f"{_taken(cycle)} The"
            " Jacobian of the Poincaré map is the product of these local maps, and over equal"
            " times the monodromy matrix is that of flows and saltation matrices,"
        ),
        Formula(
            (
                Line(
                    letters.jacobian,
                    "=",
                    (rf"{e}^{{+}} {inner} {e},",),
                ),
                Line(r"\mathcal{M}", "=", (f"{monodromy}.",)),
            ),
            label=cycle.label("Stability"),
        ),
        Paragraph(
            rf"$\mathcal{{M}}$ takes the vector field at the start, ${letters.matrix}"
            rf" {state}^{{(0)}} + {letters.offset}$ of the first phase, to itself. Beside this"
            rf" multiplier 1, and zeros, it has the multipliers of ${letters.jacobian}$, and"
            rf" $\operatorname{{tr}} \mathcal{{M}} = 1 + \operatorname{{tr}} {letters.jacobian}$."
            " The orbit is stable where every multiplier that is not trivial lies inside the unit"
            f" circle.{_trivial(cycle)}{_unmoved(cycle)}"
        ),
    ]
    return blocks


def _taken(cycle: Cycle) -> str:
    """Text on the states at which the matrices of a repeated transition are evaluated."""
    if cycle.distinct:
        return ""
    letters, k = cycle.letters, cycle.index
    return (
        f" At phase $k$ the field ${letters.field}_{{{k}}}$ and the matrix"
        f" ${letters.saltation}_{{{k}}}$ are those at ${cycle.naming.state}^{{(k)}}$."
    )


def _unmoved(cycle: Cycle) -> str:
    """Text on multipliers that are 1 because nothing depends on a shift."""
    many = cycle.directions.cols
    if not many:
        return ""
    letters = cycle.letters
    along = f"{letters.embedding}^{{+}} {letters.directions}"
    more = f"{number(many).capitalize()} more {'is' if many == 1 else 'are'} 1 and trivial"
    return f" {more}, since nothing depends on a shift: ${letters.jacobian} {along} = {along}$."


def _trivial(cycle: Cycle) -> str:
    """Text on multipliers that are 1 because of a forcing or a conserved energy."""
    found = 2 * len(cycle.harmonics) - 1
    if found > 0:
        one = found == 1
        return (
            f" {number(found).capitalize()} of those of ${cycle.letters.jacobian}$"
            f" {'is' if one else 'are'} 1 and trivial: the forcing keeps the amplitude"
            f"{'' if one else 's and phases'} of the start."
        )
    if is_conservative(cycle.itinerary):
        return " One more is 1 and trivial, since the energy is kept along the orbit."
    return ""
