"""The section of a document on an orbit that a reversor maps to itself."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import count, enumeration, number
from nonsmooth.derive.document.sections.describe_itinerary import start_line, transposed
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.symmetry import end_conditions, phase_starts, reversor_of

__all__ = ["REVERSOR", "symmetry_section"]

REVERSOR = r"\mathcal{R}"


def symmetry_section(view: View) -> list[Block]:
    """Blocks on the reversor, the states at the ends of the phases, and the closure."""
    return [*_reversor(view), *_ends(view), *_closure(view)]


def _reversor(view: View) -> list[Block]:
    """Blocks on the map, and why halves of phases are enough."""
    naming, itinerary = view.naming, view.equations.itinerary
    notation, state = naming.notation, naming.state
    images = ",\\quad ".join(
        rf"{notation.symbol(s)} \mapsto {notation.latex(notation.tidy(e))}"
        for s, e in itinerary.reversor.items()
    )
    kept = [s for s in naming.system.states if s not in itinerary.reversor]
    keeps = f" keeps {naming.list(kept)}. It" if kept else ""
    backwards = (
        ", the motion read backwards,"
        if set(itinerary.reversor) == set(naming.system.states[len(naming.positions) :])
        and all(e == -s for s, e in itinerary.reversor.items())
        else ""
    )
    cited = naming.cited("symmetry")
    return [
        Paragraph(f"The map{cited}{',' if cited else ''}"),
        Formula((Line("", "", (rf"{REVERSOR}:\quad {images}",)),)),
        Paragraph(
            f"{keeps.strip()} is a reversor of every configuration of the orbit, its own inverse:"
            f" with ${state}(t)$ also ${REVERSOR}\\,{state}(-t)${backwards} is a motion. It fixes"
            f" the states with {_fixed(view)}. A phase ends at the image of its start,"
            f" ${state}(\\tau) = {REVERSOR}\\,{state}(0)$, exactly if it passes such a state"
            " halfway. The orbit is sought among those whose phases all do so. The conditions"
            " halfway replace those at the ends, which would contain each of them twice and make"
            " the equations singular."
        ),
    ]


def _fixed(view: View) -> str:
    """Text of the conditions under which a state is its own image."""
    jump, shift = reversor_of(view.equations.itinerary)
    fixed, _ = sp.Matrix.hstack(jump - sp.eye(jump.rows), shift).rref()
    column = sp.Matrix([*view.naming.system.states, 1])
    notation = view.naming.notation
    rows = [(fixed[i, :] * column)[0] for i in range(fixed.rows)]
    return enumeration([f"${notation.latex(notation.tidy(row))} = 0$" for row in rows if row != 0])


def _ends(view: View) -> list[Block]:
    """Blocks with the states at the ends of the phases, which follow without a flow."""
    itinerary, system, start = view.undecided
    naming, state = view.naming, view.naming.state
    jump, shift = reversor_of(itinerary)
    columns: list[tuple[str, sp.Matrix]] = []
    begin = f"{state}^{{(0)}}"
    for index, before in enumerate(phase_starts(itinerary, start), start=1):
        end = jump * before + shift
        left = f"{state}^{{({index})}}"
        columns.append((rf"{left} = {REVERSOR}\,{begin}", end))
        after = itinerary.transition_after(system, index - 1).reset_of(end, system.states)
        begin = left if after == end else f"{state}^{{({index})+}}"
        if after != end:
            columns.append((begin, after))
    ends = [","] * (len(columns) - 1) + ["."]
    lines = tuple(
        Line(left, "=", (transposed(naming, column) + mark,), None, sp.ImmutableMatrix(column))
        for (left, column), mark in zip(columns, ends, strict=True)
    )
    plus = " (a plus marks what is behind a reset)" if any("+}" in x.left for x in lines) else ""
    return [
        Paragraph(
            f"The states at the ends of the phases{plus} then follow from the start without any"
            " flow,"
        ),
        Formula(lines),
    ]


def _closure(view: View) -> list[Block]:
    """Blocks on what remains of the exit conditions and of the closure."""
    naming, equations = view.naming, view.equations
    notation = naming.notation
    itinerary, _, start = view.undecided
    left = [(m, e) for m, e in end_conditions(itinerary, start) if e != 0]
    decided = {*equations.vanishing, *equations.required}
    deciding = [e for _, e in left if e.free_symbols & decided]
    staying = [(m, e) for m, e in left if not e.free_symbols & decided]
    blocks: list[Block] = []
    if not left:
        return [
            Paragraph(
                "There the exit conditions and the closure hold for every start: nothing but the"
                " conditions halfway is left."
            )
        ]
    total = len(itinerary.phases) + start.dimension
    text = (
        f"Of the exit conditions and the closure, {number(total)} in all,"
        f" {number(total - len(left))} hold there for every start."
    )
    if staying:
        where = enumeration([label for m, _ in staying for label in view.labels_of(m)])
        what = enumeration([naming.prose(m) for m, _ in staying])
        text += f" That {what} is left, and stays among the equations, as {where}."
    blocks.append(Paragraph(text + (" The closure leaves" if deciding else "")))
    if deciding:
        lines = [Line("", "", (f"{_multiple(view, e)} = 0,",), None, e) for e in deciding]
        blocks.append(Formula(tuple(lines)))
        values = [f"${notation.symbol(q)} = 0$" for q in equations.vanishing]
        text = f"so that {enumeration(values)}" if values else "so that"
        required = [
            f"${notation.symbol(p)} = {notation.latex(v)}$" for p, v in equations.required.items()
        ]
        if required:
            text += ", and" if values else ""
            text += f" {enumeration(required)}, {_otherwise(view, deciding)}"
        blocks += [
            Paragraph(
                f"{text}. Without that there is no such orbit, so it is inserted from here on:"
            ),
            Formula((start_line(naming, equations.chain.start.state),)),
            Paragraph(
                f"with {count(equations.chain.start.dimension, 'coordinate')},"
                f" {naming.list(equations.chain.start.coordinates)}."
            ),
        ]
    return blocks


def _multiple(view: View, condition: sp.Expr) -> str:
    """LaTeX of a multiple of a coordinate, with the factor in front."""
    notation = view.naming.notation
    _, _, start = view.undecided
    coordinate = next((q for q in start.coordinates if q in condition.free_symbols), None)
    factor = sp.expand(sp.diff(condition, coordinate)) if coordinate else condition
    if coordinate is None or not factor.is_Add:
        return notation.latex(condition)
    return rf"\left({notation.latex(factor)}\right) {notation.symbol(coordinate)}"


def _otherwise(view: View, conditions: list[sp.Expr]) -> str:
    """Text that says why a coordinate is not zero in place of a required value."""
    _, _, start = view.undecided
    naming, required = view.naming, set(view.equations.required)
    beside = [
        q for q in start.coordinates if any({q} | required <= e.free_symbols for e in conditions)
    ]
    rates = [
        (link.normal * link.flow.velocity(end))[0]
        for link, end in zip(view.links, view.images, strict=True)
    ]
    grazing = [q for q in beside if any(r.subs(q, 0) == 0 for r in rates)]
    symbols = naming.list(beside)
    if beside and grazing == beside:
        return f"since with {symbols} zero the boundary would only be grazed"
    return f"unless {symbols} is zero"
