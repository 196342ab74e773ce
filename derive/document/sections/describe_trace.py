"""The section of a document on the trace of the Poincaré map and on stability."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import Naming, count, enumeration, number
from nonsmooth.derive.document.views.monodromy import (
    FACTOR,
    MonodromyTrace,
    keeps_volume,
    monodromy_trace,
)
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.symbols import parts_of_derivative

__all__ = ["trace_section"]

_TRACE = r"\operatorname{tr} J"
_MONODROMY = r"\operatorname{tr} \mathcal{M}"


def trace_section(view: View) -> list[Block]:
    """Blocks on the trace, in closed form where the rank is one, and on stability."""
    reduction = view.equations.reduction
    if reduction.rank == 0:
        return [
            Paragraph(
                "The orbit passes through a section that is a point. No perturbation passes it:"
                rf" $J = 0$, ${_TRACE} = 0$, and the orbit is stable for perturbations that keep"
                " its itinerary."
            )
        ]
    if view.equations.conservative:
        return _conservative(view)
    if reduction.start is not None and reduction.image is not None:
        return [*_slope(view), _rank_one(view)]
    if reduction.rank == 1:
        return [*_sum(view), _rank_one(view)]
    return [*_sum(view), *_full_rank(view)]


def _rank_one(view: View) -> Paragraph:
    return Paragraph(
        "The orbit is stable, for perturbations that keep its itinerary, if"
        rf" $|{_TRACE}| < 1${view.naming.cited('trace')}.{_one_sided(view)}"
    )


def _one_sided(view: View) -> str:
    """Text on the perturbations for which the derivatives of a border collision hold."""
    at_once = [link.dwell for link in view.links if link.duration == 0]
    if not at_once:
        return ""
    sides = enumeration([f"${view.naming.notation.symbol(d)} > 0$" for d in at_once])
    return (
        f" The itinerary is kept where {sides} on the perturbed motion; on the other side of the"
        " collision another map holds, and this trace says nothing about it."
    )


def _sum(view: View) -> list[Block]:
    """Blocks on the trace as a sum of diagonal entries, and the number of multipliers."""
    equations = view.equations
    rank, size = equations.reduction.rank, len(equations.chain.coordinates)
    diagonal = [rf"J_{{{i}{i}}}" for i in range(1, size + 1)]
    text = (
        f"$J$ is a matrix of {number(size)} rows, for the coordinates {view.map_coordinates}. "
        if size > 1
        else f"$J$ is a number, for the coordinate {view.map_coordinates}. "
    )
    if rank < size:
        itinerary = equations.itinerary
        phase = itinerary.phases[equations.reduction.rotation % len(itinerary.phases)]
        text += (
            f"The orbit passes through a section of dimension {number(rank)}, at the start of"
            f" *{phase.configuration}*, so that at most {count(rank, 'multiplier')}"
            f" {'differs' if rank == 1 else 'differ'} from zero. "
        )
    text += "The trace of $J$ is computed by the local maps,"
    terms = tuple(d if i == 0 else f"+ {d}" for i, d in enumerate(diagonal))
    pieces = (*terms[:-1], f"{terms[-1]}.")
    return [Paragraph(text), Formula((Line(_TRACE, "=", pieces),))]


def _full_rank(view: View) -> list[Block]:
    """Blocks on the stability of a map whose trace alone does not decide."""
    if len(view.equations.chain.coordinates) == 2:
        return [
            Paragraph(
                rf"Two multipliers can differ from zero, and $|{_TRACE}| < 1$ does not decide. Both"
                " lie inside the unit circle, and the orbit is stable for perturbations that keep"
                " its itinerary, exactly where"
            ),
            Formula(
                (
                    Line(
                        "",
                        "",
                        (rf"|{_TRACE}| < 1 + \det J,\qquad", r"\det J < 1."),
                    ),
                )
            ),
        ]
    return [
        Paragraph(
            rf"$|{_TRACE}| < 1$ does not decide: the orbit is stable, for perturbations that keep"
            " its itinerary, where all multipliers, the eigenvalues of $J$, lie inside the unit"
            " circle."
        )
    ]


def _conservative(view: View) -> list[Block]:
    """Blocks on the trivial multiplier, and on the pair that the monodromy's trace gives."""
    size = len(view.naming.system.states)
    blocks: list[Block] = []
    found = monodromy_trace(view)
    if size != 4 or not keeps_volume(view):
        return [
            *_sum(view),
            Paragraph(
                "One multiplier is the trivial 1 of the energy. The orbit is neutral where all"
                " others lie on the unit circle, and unstable where one lies outside."
            ),
        ]
    blocks.append(
        Paragraph(
            r"The flows keep volumes of the state space, and $\det S_{k} = 1$: hence"
            r" $\det \mathcal{M} = 1$. Two eigenvalues of $\mathcal{M}$ are 1, so that the other"
            r" two are $\mu$ and $1/\mu$. They are the nontrivial multipliers, and follow from"
        )
    )
    blocks.append(
        Formula(
            (
                Line(
                    r"\mu + \frac{1}{\mu}",
                    "=",
                    (rf"{_TRACE} - 1", rf"= {_MONODROMY} - 2,"),
                ),
                Line(
                    r"\mu",
                    "=",
                    (
                        r"\frac{s}{2} \pm \sqrt{\frac{s^{2}}{4} - 1},\qquad",
                        rf"s = {_MONODROMY} - 2.",
                    ),
                ),
            ),
        )
    )
    if found is not None:
        blocks += _written_out(view, found)
    blocks.append(
        Paragraph(
            rf"Where $|{_MONODROMY} - 2| < 2$ the pair lies on the unit circle and the orbit is"
            rf" neutral. Where $|{_MONODROMY} - 2| > 2$ it is real, one of the two lies outside,"
            " and the orbit is unstable. It is the trace that decides: on the circle $|\\mu| = 1$"
            " leaves nothing to compare, and the double eigenvalue 1, which has one eigenvector"
            r" only, costs the eigenvalues of $\mathcal{M}$ half their digits."
        )
    )
    return blocks


def _written_out(view: View, found: MonodromyTrace) -> list[Block]:
    """Blocks with the monodromy's trace as a sum over functions of the dwell times."""
    notation, names = view.naming.notation, found.names
    factors = [
        Line(
            notation.symbol(s),
            "=",
            notation.signed(sorted(sp.Add.make_args(e), key=_degree)),
            None,
            e,
        )
        for s, e in names.items()
        if s == FACTOR
    ]
    pieces: list[str] = []
    for term in found.terms:
        first, *rest = notation.pieces(term)
        sign = "+ " if pieces and not first.startswith("-") else ""
        pieces += [f"{sign}{first}", *rest]
    trace = sp.Add(*found.terms).xreplace(names)
    blocks: list[Block] = [Paragraph("Written out, with the switching conditions inserted,")]
    blocks.append(
        Formula(
            (Line(_MONODROMY, "=", tuple(pieces), None, trace), *factors), view.label("The trace")
        )
    )
    return blocks


def _degree(term: sp.Expr) -> tuple[int, str]:
    return len(term.free_symbols), str(term)


def _slope(view: View) -> list[Block]:
    """Blocks on the trace as the slope of the map in one variable."""
    naming, reduction = view.naming, view.equations.reduction
    notation, symbol, image = naming.notation, naming.notation.symbol, reduction.image
    first, *others = reduction.unknowns
    x, start = symbol(first), symbol(reduction.start)
    stages, trace = view.equations.trace_program
    blocks: list[Block] = [
        Paragraph(
            "The section at the start of the reduction has one coordinate,"
            f" $q = {start}$. The Poincaré map therefore has rank one: its only multiplier that"
            " can differ from zero is the slope of the map in one variable"
        ),
        Formula(
            (
                Line("q", "=", (start,)),
                Line("Q", "=", notation.pieces(notation.tidy(image)), None, image),
            )
        ),
    ]
    if others:
        followers = "follows" if len(others) == 1 else "follow"
        where = enumeration([f"({view.label('The reduction', i)})" for i in range(len(others))])
        blocks.append(
            Paragraph(
                f"Both are functions of ${x}$, since {naming.list(others)} {followers} from"
                f" {where}, here $F = 0$. By implicit differentiation, with"
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
    head = rf"{_TRACE} = \frac{{\mathrm{{d}} Q}}{{\mathrm{{d}} q}}"
    shown = notation.pieces(notation.tidy(trace))
    base = {s for stage in reduction.stages for s, _ in stage.assignments}
    return [
        *blocks,
        Formula((Line(head, "=", (f"{general}.",)),)),
        Paragraph("In the symbols of the stages this reads"),
        Formula((Line(_TRACE, "=", shown, None, trace),), label=view.label("The trace")),
        *_derivatives(naming, stages, base, reduction.unknowns),
    ]


def _derivatives(
    naming: Naming, stages: Sequence[Stage], base: set[sp.Symbol], directions: Sequence[sp.Symbol]
) -> list[Block]:
    """Blocks with the derivatives along the stages, direction by direction."""
    named = {e: s for s, e in naming.notation.functions.items()}
    inlined: dict[sp.Symbol, sp.Expr] = {}
    groups: dict[sp.Symbol | None, list[tuple[sp.Symbol, sp.Expr]]]
    groups = {d: [] for d in (*directions, None)}
    for stage in stages:
        for symbol, expression in stage.assignments:
            if symbol in base:
                continue
            inner, direction = parts_of_derivative(symbol)
            if inner in naming.notation.functions:
                # the derivative of a cosine needs no symbol on paper
                inlined[symbol] = expression.xreplace(named)
                continue
            group = direction if direction in groups else None
            groups[group].append((symbol, expression.xreplace(inlined)))
    blocks: list[Block] = []
    for direction, assignments in groups.items():
        if not assignments:
            continue
        by = naming.notation.symbol(direction) if direction else ""
        others = [d for d in directions if d != direction]
        fixed = naming.list(others)
        text = rf"The derivatives by ${by}$" + (f" at fixed {fixed}" if others else "")
        blocks.append(Paragraph(f"{text if direction else 'Further'}, stage by stage:"))
        blocks.append(Formula(tuple(naming.equal(s, e) for s, e in assignments)))
    return blocks
