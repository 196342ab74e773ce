"""The sections of a document on the chain of an orbit's states and on its equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import count, enumeration
from nonsmooth.derive.document.sections.describe_symmetry import REVERSOR
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.chain import Link
from nonsmooth.derive.symbols import Symbol

__all__ = ["chain_section", "equation_section"]


def chain_section(view: View) -> list[Block]:
    """Blocks on the states behind the phases, one phase after the other."""
    equations, naming = view.equations, view.naming
    state, itinerary = naming.state, equations.itinerary
    arrows = r" \;\to\; ".join(f"{state}^{{({k})}}" for k in range(len(view.links) + 1))
    assigned = dict(a for s in equations.chain.stages for a in s.assignments)
    lead = f"The flows carry the start through the phases, ${arrows}$."
    if view.reversible:
        lead += (
            " The conditions halfway do without whole phases; the chain is what the Poincaré map"
            f" is made of, and at the orbit it gives the images under ${REVERSOR}$ found above."
        )
    blocks: list[Block] = [Paragraph(lead)]
    for index, (phase, link) in enumerate(zip(itinerary.phases, view.links, strict=True), start=1):
        dwell = naming.notation.symbol(link.dwell)
        flow = rf"\Phi_{{{view.numbers[phase.configuration]}}}({dwell})"
        how = "for no time" if link.duration == 0 else f"for ${dwell}$ with ${flow}$"
        cited = naming.cited(f"phase {index}")
        blocks.append(Paragraph(f"Phase {index}, *{phase.configuration}* {how}{cited}:"))
        blocks.append(Formula(tuple(_lines(view, index, assigned))))
        transition = itinerary.transition_after(naming.system, index - 1)
        if transition.reset:
            rules = [_rule(view, s, e) for s, e in transition.reset.items()]
            target = f"The transition to *{transition.target}*"
            cited = naming.cited(f"reset {index}")
            blocks.append(Paragraph(f"{target} {enumeration(rules)}{cited}."))
    return blocks


def _lines(view: View, index: int, assigned: dict[sp.Symbol, sp.Expr]) -> list[Line]:
    """Lines for the state at the end of one phase, state by state."""
    link, naming = view.links[index - 1], view.naming
    lines = []
    for row, (symbol, value) in enumerate(zip(naming.system.states, link.after, strict=True)):
        named = Symbol("state", symbol, index)
        # a state that does not move is what it was, not once more how that came about
        line = naming.equal(named, assigned[named] if value == named else value)
        if view.reversible or link.flow.configuration in view.centres.columns:
            line = replace(line, pieces=_about_centre(view, link, row))
        lines.append(line)
    return lines


def _about_centre(view: View, link: Link, row: int) -> tuple[str, ...]:
    """LaTeX of a coordinate as a sum over the distances of all states from their centre."""
    notation, states = view.naming.notation, view.naming.system.states
    centre = view.centres.columns.get(link.flow.configuration, sp.zeros(len(states), 1))
    distances = [Symbol("state", s, 0) for s in states]
    total = notation.tidy((link.transfer[row, :] * sp.Matrix(distances))[0])
    inserted = {d: b - c for d, b, c in zip(distances, link.before, centre, strict=True)}
    terms = sorted(
        sp.Add.make_args(total),
        key=lambda t: min(distances.index(d) for d in distances if d in t.free_symbols),
    )
    pieces = [notation.symbol(centre[row])] if centre[row] != 0 else []
    for term in (t.xreplace(inserted) for t in terms):
        if term == 0:
            continue
        first, *rest = notation.pieces(term)
        sign = "+ " if pieces and not first.startswith("-") else ""
        pieces += [f"{sign}{first}", *rest]
    return tuple(pieces)


def _rule(view: View, symbol: sp.Symbol, expression: sp.Expr) -> str:
    """Text that says what a reset does to one state."""
    notation = view.naming.notation
    left, right = notation.symbol(symbol), notation.latex(notation.tidy(expression))
    if expression.free_symbols & set(view.naming.system.states):
        return f"takes ${left}$ to ${right}$"
    return f"sets ${left} = {right}$"


def equation_section(view: View) -> list[Block]:
    """Blocks with the numbered equations: switching conditions and closure."""
    equations = view.equations
    counted = (
        f" {count(len(equations.equations), 'equation')} for"
        f" {count(len(equations.unknowns), 'unknown')}"
    )
    if view.reversible:
        kept = any("halfway" not in meaning for meaning, _ in equations.equations)
        lead = f"The conditions halfway through the phase{'' if len(view.links) == 1 else 's'}"
        lead += f", and what the ends leave, make{counted}" if kept else f" make{counted}"
        lead += (
            f", {view.naming.list(equations.unknowns)}. Each is written function by function of"
            " half the dwell time:"
        )
    else:
        coordinates = equations.chain.start.coordinates
        closed = {meaning for meaning, _ in equations.equations}
        dropped = [q for q in coordinates if f"{q} returns" not in closed]
        lead = (
            "The switching condition of each phase and the closure of each of the start's own"
            f" coordinates{_except(view, dropped)} make{counted}:"
        )
    formulas = view.numbered("The equations", equations.equations, view.conditions)
    return [Paragraph(lead), *formulas]


def _except(view: View, dropped: Sequence[sp.Symbol]) -> str:
    """Text on the coordinates without a closure, as they return if the others do."""
    if not dropped:
        return ""
    if view.equations.chain.forcing:
        return (
            ", with the amplitude of the forcing and whole periods of it in place of the closure"
            " of its cosine and sine,"
        )
    names = view.naming.list(dropped)
    return f" but {names}, which the energy makes return if all others do,"
