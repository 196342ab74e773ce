"""The section of a document on a reversible orbit's equations, solved for its start."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import Naming, count, enumeration, in_one_line
from nonsmooth.derive.document.sections.describe_reduction import numbered_rest
from nonsmooth.derive.document.views.explicit_start import explicit_start
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.elimination import entry
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.symbols import Symbol

__all__ = ["solution_section"]


def solution_section(view: View) -> list[Block]:
    """Blocks on the conditions halfway, solved for the start, and the remaining equations."""
    naming, reduction = view.naming, view.equations.reduction
    coordinates = view.equations.chain.start.coordinates
    alone = _alone(view)
    blocks: list[Block] = []
    if alone:
        blocks.append(
            Paragraph(
                f"Given the dwell times, the equations are linear in {naming.list(coordinates)},"
                f" and are solved for {'it' if len(coordinates) == 1 else 'them'}."
            )
        )
    blocks += [*alone, *_together(view)]
    if reduction.equations:
        blocks += [Paragraph(_left(view)), *numbered_rest(view)]
    else:
        blocks += _explicit(view)
    return blocks


def _left(view: View) -> str:
    """Text that introduces the remaining equations, and says if one was cleared of its pole."""
    naming, reduction = view.naming, view.equations.reduction
    one = len(reduction.equations) == 1
    text = f"There {'remains' if one else 'remain'} {count(len(reduction.equations), 'equation')}"
    text += f" for the dwell time{'' if one else 's'} {naming.list(reduction.unknowns)}"
    poles = {d for d, _ in reduction.determinants}
    if one and poles & reduction.equations[0][1].free_symbols:
        (label,) = view.labels_of(reduction.equations[0][0])
        letter = naming.notation.symbol(next(iter(poles)))
        text += (
            f": {label} times ${letter}$, which has no pole where ${letter}$ vanishes. A zero at"
            f" which ${letter}$ vanishes too may belong to no orbit"
        )
    return f"{text}:"


def _stage(view: View, title: str) -> Stage | None:
    return next((s for s in view.equations.reduction.stages if s.title.startswith(title)), None)


def _alone(view: View) -> list[Block]:
    """Blocks on coordinates that a single equation gives, with a constant coefficient."""
    naming, blocks = view.naming, list[Block]()
    for elimination in view.equations.reduction.eliminations:
        symbol = elimination.unknown
        stage = _stage(view, f"{symbol}: ")
        if stage is None:
            continue
        meaning = elimination.rule.removeprefix("linear in: ")
        ((_, expression),) = stage.assignments
        where = enumeration(view.labels_of(meaning))
        written = view.written.get(symbol)
        blocks += [
            Paragraph(f"Equation {where}{' then' if blocks else ''} gives"),
            Formula((naming.equal(symbol, expression, written=written),)),
        ]
    return blocks


def _together(view: View) -> list[Block]:
    """Blocks on coordinates that several equations give together, by Cramer's rule."""
    naming, reduction = view.naming, view.equations.reduction
    if not reduction.determinants:
        return []
    coefficients = _stage(view, "coefficients of the linear equations")
    right = _stage(view, "right-hand sides of the linear equations")
    ((determinant, _),) = reduction.determinants
    together = [e for e in reduction.eliminations if _stage(view, f"{e.unknown}: ") is None]
    unknowns = [e.unknown for e in together]
    meanings = together[0].rule.removeprefix("linear in: ").split("; ")
    labels = [label for m in meanings for label in view.labels_of(m)]
    many = len(labels) > 1
    alone = len(unknowns) < view.equations.chain.start.dimension
    given = "" if alone else f"Given the dwell time{'' if len(view.links) == 1 else 's'}, "
    equations = f"quations {enumeration(labels)} are" if many else f"quation {labels[0]} is"
    equations = f"{given}e{equations}" if given else f"E{equations}{' then' if alone else ''}"
    blocks: list[Block] = [Paragraph(f"{equations} linear in {naming.list(unknowns)},")]
    entries = [] if coefficients is None else coefficients.assignments
    sums = [] if right is None else right.assignments
    table = tuple(naming.equal(s, e, written=view.written.get(s)) for s, e in entries)
    column = tuple(naming.sum(s, e, view.written.get(s)) for s, e in sums)
    if len(table) == len(unknowns) ** 2 and len(column) == len(unknowns):
        blocks += [Formula((_system(naming, unknowns),)), Paragraph("with"), Formula(table)]
        blocks += [Paragraph("and"), Formula(column)]
    elif table or column:  # an entry that is one function of time has no name
        blocks = [Paragraph(f"{equations} linear in {naming.list(unknowns)}, with")]
        blocks.append(Formula((*table, *column)))
    titles = ("determinant of the linear", "numerators of", f"{', '.join(map(str, unknowns))} by")
    solved = [s for title in titles if (s := _stage(view, title)) is not None]
    *factors, starts = [[naming.equal(s, e) for s, e in stage.assignments] for stage in solved]
    lines = [*(line for stage in factors for line in stage), in_one_line(starts)]
    blocks += [Paragraph("By Cramer's rule" if many else "Hence"), Formula(tuple(lines))]
    if reduction.equations:
        blocks.append(
            Paragraph(
                f"Where ${naming.notation.symbol(determinant)}$ vanishes the start is not"
                " determined: there is no such orbit, or a whole family of them."
            )
        )
    return blocks


def _system(naming: Naming, unknowns: list[sp.Symbol]) -> Line:
    """Line with the linear equations in the letters of their coefficients."""
    notation, size = naming.notation, len(unknowns)
    if size == 1:
        left = f"{notation.symbol(entry(0, 0, 1))}\\, {notation.symbol(unknowns[0])}"
        return Line(left, "=", (f"{notation.symbol(Symbol('right', 1))},",))
    table = sp.Matrix(size, size, lambda i, j: entry(i, j, size))
    right = sp.Matrix([Symbol("right", i + 1) for i in range(size)])
    left = f"{notation.latex(table)} {notation.latex(sp.Matrix(unknowns))}"
    return Line(left, "=", (f"{notation.latex(right)},",))


def _explicit(view: View) -> list[Block]:
    """Blocks with the start written out, where nothing remains to be solved."""
    naming, period = view.naming, view.equations.itinerary.period
    blocks: list[Block] = [Paragraph("Nothing remains to be solved: the orbit is explicit.")]
    found = explicit_start(view)
    if found is None:
        return blocks
    of = f"({naming.notation.symbol(period.symbol)})" if period else ""
    lines = [found.determinant, *found.coordinates]
    shown = tuple(
        Line(f"{line.left}{of}", "=", line.pieces, line.subject, line.shows) for line in lines
    )
    blocks += [
        Paragraph(f"Written out{found.because}, it is"),
        Formula(shown),
        *_begins_inside(view, of),
    ]
    if period:
        d, t = shown[0].left, naming.notation.symbol(period.symbol)
        blocks.append(
            Paragraph(
                f"The zeros of ${d}$ are the singular periods: at such a ${t}$ there is no orbit of"
                " this kind, or, where the numerators vanish with it, a family of them."
            )
        )
    return blocks


def _begins_inside(view: View, of: str) -> list[Block]:
    """Paragraph on which side of its own boundary an orbit of one phase has to begin."""
    if len(view.links) > 1:
        return []
    (link,), start = view.links, view.equations.chain.start.state
    (phase,) = view.equations.itinerary.phases
    boundary = view.naming.system.configuration(phase.configuration).boundary(phase.boundary)
    row, constant = view.naming.system.gradient(boundary.function)
    rate = sp.expand((row * link.flow.velocity(start))[0])
    if sp.expand((row * start)[0] + constant) != 0 or not rate.is_Symbol:
        return []
    symbol = view.naming.notation.symbol(rate)
    return [
        Paragraph(
            f"The phase begins on its own boundary, and leads inside only where ${symbol}{of} < 0$:"
            " elsewhere this is no motion of the system."
        )
    ]
