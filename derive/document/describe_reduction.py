"""The sections of a document on the reduction of an orbit's equations and its trace."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.wording import Naming, count, enumeration, numbered
from nonsmooth.derive.equations import EquationSystem
from nonsmooth.derive.explicit import LINEAR, RETURN
from nonsmooth.derive.program import Stage
from nonsmooth.derive.reduction import Elimination

__all__ = ["reduction_section", "trace_section"]

_FIRST_RETURN = (
    r"A switching condition with one frequency and no drift has the form"
    r" $a \cos\theta + b \sin\theta + c = 0$. That it rises through zero fixes the cosine and the"
    r" sine of the angle $\theta = \omega\tau$; with $\operatorname{arg}$ in $[0, 2\pi)$ the dwell"
    r" time is that of the first return."
)


def reduction_section(naming: Naming, equations: EquationSystem) -> list[Block]:
    """Tell what is eliminated, by which rule, and the equations that remain."""
    notation, reduction = naming.notation, equations.reduction
    turned = equations.itinerary.rotated(reduction.rotation)
    phase = turned.phases[0]
    left = count(len(reduction.unknowns), "unknown")
    if reduction.unknowns:
        left += f", {naming.list(reduction.unknowns)}"
    lead = (
        "The equations are linear in the coordinates of the start, given the dwell times. They"
        f" are solved for them, which leaves {left}."
        if equations.itinerary.reversor
        else "Whatever is linear or explicit is eliminated. The chain is followed from the phase"
        f" with the smallest section, *{phase.configuration}* (phase {reduction.rotation + 1}),"
        f" and each switching condition is used as far as it goes, which leaves {left}."
    )
    blocks: list[Block] = [Paragraph(lead)]
    if reduction.eliminations:
        rows = [
            (f"${notation.symbol(e.unknown)}$", naming.prose(e.rule))
            for e in reduction.eliminations
        ]
        blocks.append(Table(("Eliminated", "Rule"), tuple(rows)))
    shown = {a for s in equations.chain.stages for a in s.assignments}
    functions = naming.notation.functions
    titles: list[tuple[str, list[tuple[sp.Symbol, sp.Expr]]]] = []
    for stage in reduction.stages:
        kept = [a for a in stage.assignments if a[0] not in functions]
        if titles and titles[-1][0] == stage.title:
            titles[-1][1].extend(kept)
        elif kept:
            titles.append((stage.title, kept))
    if any(e.rule == RETURN for e in reduction.eliminations):
        blocks.append(Paragraph(_FIRST_RETURN))
    rules = {f"{e.unknown}: {e.rule}": e for e in reduction.eliminations}
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
    if reduction.determinants:
        symbols = naming.list(d for d, _ in reduction.determinants)
        blocks.append(
            Paragraph(
                f"Where {symbols} vanishes the start is not determined: there is no such orbit, or"
                " a whole family of them."
            )
        )
    if reduction.equations:
        blocks.append(
            Paragraph(f"The reduced system has {count(len(reduction.equations), 'equation')}:")
        )
        blocks += numbered(naming, reduction.equations, "R")
    else:
        blocks.append(Paragraph("Nothing remains to be solved: the orbit is explicit."))
    others = [(s, e) for s, e in reduction.values.items() if s != e and s in equations.unknowns]
    if others:
        blocks.append(Paragraph("The unknowns that do not appear among the stages are"))
        blocks.append(Formula(tuple(naming.equal(s, e) for s, e in others)))
    return blocks


def _sentence(naming: Naming, elimination: Elimination) -> str:
    """Lead to the assignment by which an unknown was eliminated."""
    symbol = f"${naming.notation.symbol(elimination.unknown)}$"
    if elimination.rule == LINEAR:
        return f"The switching condition is linear in {symbol}"
    if elimination.rule == RETURN:
        return f"Hence {symbol}, the first return"
    boundary = elimination.rule.removeprefix("linear in ").removeprefix("in: ")
    return f"The condition of {naming.prose(boundary)} is linear in {symbol}"


def trace_section(naming: Naming, equations: EquationSystem) -> list[Block]:
    """Give the trace: as the slope of the map in one variable, where the rank is one."""
    reduction = equations.reduction
    if reduction.start is None or reduction.image is None:
        return [
            Paragraph("The trace is the sum of the diagonal of $J$, computed by the local maps.")
        ]
    first, *others = reduction.unknowns
    x, symbol = naming.notation.symbol(first), naming.notation.symbol
    start, image = symbol(reduction.start), reduction.image
    stages, trace = equations.trace
    blocks: list[Block] = [
        Paragraph(
            "The section at the start of the reduction has one coordinate,"
            f" $q = {start}$. The Poincaré map therefore has rank one: its only multiplier that"
            " can differ from zero is the slope of the map in one variable"
        ),
        Formula(
            (
                Line("q", "=", (start,)),
                Line("Q", "=", naming.notation.pieces(naming.notation.tidy(image)), None, image),
            )
        ),
    ]
    if others:
        followers = "follows" if len(others) == 1 else "follow"
        blocks.append(
            Paragraph(
                f"Both are functions of ${x}$, since {naming.list(others)} {followers} from"
                f" {enumeration([f'(R{i + 1})' for i in range(len(others))])}, here $F = 0$."
                " By implicit differentiation, with"
                rf" $y = {', '.join(symbol(o) for o in others)}$,"
            )
        )
        numerator = (
            rf"\partial_{{{x}}} Q - \partial_{{y}} Q\, \left(\partial_{{y}} F\right)^{{-1}}"
            rf" \partial_{{{x}}} F"
        )
    else:
        blocks.append(Paragraph(f"Both are functions of ${x}$, so that"))
        numerator = rf"\partial_{{{x}}} Q"
    general = rf"\frac{{{numerator}}}{{\partial_{{{x}}} q}}"
    blocks += [
        Formula(
            (
                Line(
                    r"\operatorname{tr} J = \frac{\mathrm{d} Q}{\mathrm{d} q}",
                    "=",
                    (f"{general}.",),
                ),
            )
        ),
        Paragraph("In the symbols of the stages this reads"),
        Formula(
            (
                Line(
                    r"\operatorname{tr} J",
                    "=",
                    naming.notation.pieces(naming.notation.tidy(trace)),
                    None,
                    trace,
                ),
            ),
            label="T",
        ),
    ]
    base = {s for stage in reduction.stages for s, _ in stage.assignments}
    return [
        *blocks,
        *_derivatives(naming, stages, base, [str(u) for u in reduction.unknowns]),
        Paragraph(
            r"The orbit is stable, for perturbations that keep its itinerary, if"
            r" $|\operatorname{tr} J| < 1$."
        ),
    ]


def _derivatives(
    naming: Naming, stages: Sequence[Stage], base: set[sp.Symbol], directions: Sequence[str]
) -> list[Block]:
    """Show the derivatives along the stages, direction by direction, and what is left."""
    named = {e: s for s, e in naming.notation.functions.items()}
    inlined: dict[sp.Symbol, sp.Expr] = {}
    groups: dict[str, list[tuple[sp.Symbol, sp.Expr]]] = {d: [] for d in (*directions, "")}
    for stage in stages:
        for symbol, expression in stage.assignments:
            if symbol in base:
                continue
            inner, _, direction = str(symbol).rpartition("_by_")
            if inner in {str(f) for f in naming.notation.functions}:
                # the derivative of a cosine needs no symbol on paper
                inlined[symbol] = expression.xreplace(named)
                continue
            group = direction if direction in groups else ""
            groups[group].append((symbol, expression.xreplace(inlined)))
    blocks: list[Block] = []
    for direction, assignments in groups.items():
        if not assignments:
            continue
        by = naming.notation.symbol(direction) if direction else ""
        others = [d for d in directions if d != direction]
        fixed = naming.list([sp.Symbol(d) for d in others])
        text = rf"The derivatives by ${by}$" + (f" at fixed {fixed}" if others else "")
        blocks.append(Paragraph(f"{text if direction else 'Further'}, stage by stage:"))
        blocks.append(Formula(tuple(naming.equal(s, e) for s, e in assignments)))
    return blocks
