"""The section of a document on the reduction of an orbit's equations."""

from __future__ import annotations

from itertools import groupby

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.notation.wording import Naming, count
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.explicit import LINEAR, RETURN
from nonsmooth.derive.equations.reduction import Elimination
from nonsmooth.derive.symbols import Symbol, inside, meaning_of

__all__ = ["numbered_rest", "reduction_section"]

_FIRST_RETURN = (
    r"A switching condition with one frequency and no drift has the form"
    r" $a \cos\theta + b \sin\theta + c = 0$. That it rises through zero fixes the cosine and the"
    r" sine of the angle $\theta = \omega\tau$; with $\operatorname{arg}$ in $[0, 2\pi)$ the dwell"
    r" time is that of the first return."
)


def reduction_section(view: View) -> list[Block]:
    """Blocks on what is eliminated along the chain, by which rule, and what remains."""
    equations, naming = view.equations, view.naming
    notation, reduction = naming.notation, equations.reduction
    if reduction.equations == equations.equations and not reduction.eliminations:
        return [Paragraph("Nothing is eliminated: Newton's method works on the equations above.")]
    turned = equations.itinerary.rotated(reduction.rotation)
    phase = turned.phases[0]
    left = count(len(reduction.unknowns), "unknown")
    if reduction.unknowns:
        left += f", {naming.list(reduction.unknowns)}"
    blocks: list[Block] = [
        Paragraph(
            "Whatever is linear or explicit is eliminated. The chain is followed from the phase"
            f" with the smallest section, *{phase.configuration}* (phase {reduction.rotation + 1}),"
            f" and each switching condition is used as far as it goes, which leaves {left}."
        )
    ]
    if reduction.eliminations:
        together = groupby(reduction.eliminations, lambda e: e.rule)
        rows = [
            (", ".join(f"${notation.symbol(e.unknown)}$" for e in found), naming.prose(rule))
            for rule, found in together
        ]
        blocks.append(Table(("Eliminated", "Rule"), tuple(rows), wrapped=1))
    if any(e.rule == RETURN for e in reduction.eliminations):
        blocks.append(Paragraph(_FIRST_RETURN))
    blocks += _beyond(view)
    blocks += _parts(view)
    blocks += _stages(view)
    if reduction.equations:
        blocks.append(
            Paragraph(f"The reduced system has {count(len(reduction.equations), 'equation')}:")
        )
        blocks += numbered_rest(view)
        blocks += _both_roots(view)
    else:
        blocks.append(Paragraph("Nothing remains to be solved: the orbit is explicit."))
    others = [(s, e) for s, e in reduction.values.items() if s != e and s in equations.unknowns]
    if others:
        blocks.append(Paragraph("The unknowns that do not appear among the stages are"))
        blocks.append(Formula(tuple(naming.equal(s, e) for s, e in others)))
    return blocks


def _both_roots(view: View) -> list[Block]:
    """Blocks with the roots of a quadratic reduced equation; none for another one."""
    reduction, naming = view.reduction, view.naming
    if not reduction.roots:
        return []
    (unknown,), ((_, equation),) = reduction.unknowns, reduction.equations
    a, b, c = sp.Poly(sp.expand(equation), unknown).all_coeffs()
    half, radicand = sp.factor_terms(-b / 2), difference_of_squares((b / 2) ** 2 - a * c)
    latex = naming.notation.latex
    above = rf"{latex(half)} \pm \sqrt{{{latex(radicand)}}}"
    value = rf"\frac{{{above}}}{{{latex(a)}}}."
    return [
        Paragraph(
            "It is quadratic, so that the orbit is explicit: there are two of them where the"
            " radicand is positive, which meet in a fold where it vanishes, and none where it is"
            " negative. Which of the two is a motion of the system, admissibility decides:"
        ),
        Formula((Line(naming.notation.symbol(unknown), "=", (value,)),)),
    ]


def difference_of_squares(expression: sp.Expr) -> sp.Expr:
    """A polynomial as p g^2 - q^2 with one of its symbols g, if it has that form."""
    expanded = sp.expand(expression)
    for symbol in sorted(expanded.free_symbols, key=str):
        coefficients = sp.Poly(expanded, symbol).as_dict()
        if set(coefficients) != {(0,), (2,)}:
            continue
        number, factors = sp.factor_list(-coefficients[(0,)])
        if sp.sqrt(number).is_rational and all(power % 2 == 0 for _, power in factors):
            root = sp.Mul(sp.sqrt(number), *(base ** (power // 2) for base, power in factors))
            return sp.factor_terms(coefficients[(2,)]) * symbol**2 - root**2
    return expanded


def _beyond(view: View) -> list[Block]:
    """Paragraphs on states behind the last phase, if the stages name them."""
    state, phases = view.naming.state, len(view.links)
    assigned = {s for stage in view.equations.reduction.stages for s, _ in stage.assignments}
    found = [
        k
        for k in range(phases + 1, 2 * phases)
        if assigned & {Symbol("state", s, k) for s in view.naming.system.states}
    ]
    return [
        Paragraph(
            f"Behind the last phase the count goes on: ${state}^{{({k})}}$ is the state behind"
            f" phase {k - phases} of the next period."
        )
        for k in found
    ]


def _parts(view: View) -> list[Block]:
    """Blocks on the meaning of bars, indices and numbers in brackets in the stages."""
    naming, reduction = view.naming, view.equations.reduction
    notation = naming.notation
    assigned = [s for stage in reduction.stages for s, _ in stage.assignments]
    meanings = set(map(meaning_of, assigned))
    blocks: list[Block] = []
    parts = [s for s in assigned if meaning_of(s) == "part"]
    of_start = next((s for s in reversed(parts) if s.parts[1] != 1), None)
    if of_start:
        blocks.append(
            Paragraph(
                f"Given the dwell times, the states ${naming.state}^{{(k)}}$ are affine in the"
                " coordinates of the start. A bar marks their value where these coordinates are"
                f" zero, and a coordinate as the last index, as in ${notation.symbol(of_start)}$,"
                " its coefficient."
            )
        )
    if not any(meaning_of(inside(s, "times", "without")) == "right" for s in assigned):
        return blocks
    rule = reduction.eliminations[-1].rule
    columns = [e.unknown for e in reduction.eliminations if e.rule == rule]
    kept = [u for u in reduction.unknowns if u in view.equations.chain.start.coordinates]
    matrix, right = notation.letter("coefficient"), notation.letter("right")
    left = [rf"{matrix}_{{ij}}\, {notation.symbol(q)}" for q in columns]
    left = [t.replace("ij", f"i{j}") for j, t in enumerate(left, start=1)]
    side = [f"{right}_{{i}}"]
    side += [f"{right}_{{i,{notation.symbol(q)}}} {notation.symbol(q)}" for q in kept]
    many = f"The {count(len(columns), 'linear equation')} for {naming.list(columns)}"
    blocks += [
        Paragraph(f"{many} {'is' if len(columns) == 1 else 'are'}, in the order of the table,"),
        Formula((Line(" + ".join(left), "=", (" + ".join(side),)),)),
        Paragraph(
            "An entry that is a number, or one function or symbol, is not listed below, but"
            " stands where it is used."
            + (
                " A number in square brackets counts the steps of elimination."
                if "without" in meanings
                else ""
            )
        ),
    ]
    return blocks


def numbered_rest(view: View) -> list[Formula]:
    """The equations of the reduced system as numbered formulas."""
    written = [expression for _, expression in view.reduction.equations]
    return view.numbered("The reduction", view.equations.reduction.equations, written)


def _stages(view: View) -> list[Block]:
    """Blocks with the stages of the reduction, each under its title."""
    naming, reduction = view.naming, view.equations.reduction
    shown = {a for s in view.equations.chain.stages for a in s.assignments}
    titles: list[tuple[str, list[tuple[sp.Symbol, sp.Expr]]]] = []
    for stage in reduction.stages:
        kept = [a for a in stage.assignments if a[0] not in naming.notation.functions]
        if titles and titles[-1][0] == stage.title:
            titles[-1][1].extend(kept)
        elif kept:
            titles.append((stage.title, kept))
    rules = {f"{e.unknown}: {e.rule}": e for e in reduction.eliminations}
    blocks: list[Block] = []
    for title, assignments in titles:
        known = rules.get(title)
        text = _sentence(naming, known) if known else naming.prose(title)
        text = text[:1].upper() + text[1:]
        if all(a in shown for a in assignments):
            symbols = naming.list(s for s, _ in assignments)
            blocks.append(Paragraph(f"{text}: {symbols} as in the chain of states."))
            continue
        blocks.append(Paragraph(f"{text}:"))
        blocks.append(Formula(tuple(naming.equal(s, e) for s, e in assignments)))
    return blocks


def _sentence(naming: Naming, elimination: Elimination) -> str:
    """Text that introduces the assignment by which an unknown was eliminated."""
    symbol = f"${naming.notation.symbol(elimination.unknown)}$"
    if elimination.rule == LINEAR:
        return f"The switching condition is linear in {symbol}"
    if elimination.rule == RETURN:
        return f"Hence {symbol}, the first return"
    boundary = elimination.rule.removeprefix("linear in ")
    return f"The condition of {naming.prose(boundary)} is linear in {symbol}"
