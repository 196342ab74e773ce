"""The section of a document on the map of a whole turn and the start that follows from it."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import Naming, count, enumeration
from nonsmooth.derive.document.sections.describe_itinerary import transposed
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.period_map import PeriodMap
from nonsmooth.derive.symbols import meaning_of

__all__ = ["TITLE", "period_map_section"]

_N = r"\tilde N"
TITLE = "The map of a period"


def period_map_section(view: View) -> list[Block]:
    """Blocks on N in blocks, the start that it gives, and the equations that it leaves."""
    turn = view.equations.period_map
    return [
        *_map(view, turn),
        *_entries(view, turn),
        *_start(view, turn),
        *_rest(view, turn),
    ]


def _map(view: View, turn: PeriodMap) -> list[Block]:
    """Blocks on the product of the flows, in blocks, and on periodicity (A.1)."""
    naming, state = view.naming, view.naming.state
    first, second = _vectors(naming)
    shift = "" if turn.offset.is_zero_matrix else " + c"
    kind = "an affine" if shift else "a linear"
    groups = [sp.Matrix([turn.start[i] for i in p]) for p in (turn.sought, turn.known)]
    start = tuple(
        Line(vector, "=", (transposed(naming, group),), None, _shown(group))
        for vector, group in zip((first, second), groups, strict=True)
    )
    one, two = (f" + c_{{{i}}}" if shift else "" for i in (1, 2))
    blocks = rf"\begin{{matrix}}{_N}_{{1}} & {_N}_{{2}}\\{_N}_{{3}} & {_N}_{{4}}\end{{matrix}}"
    dropped = [
        link.dwell
        for k, link in enumerate(view.links)
        if k not in turn.resets and link.reset != sp.eye(link.reset.rows)
    ]
    left_out = " A reset that only states that its boundary is reached is left out."
    return [
        Paragraph(
            "The equations can be taken in another order, that of the Appendix of Pascal (2011)."
            f" Given the dwell times a whole turn is {kind} map of the start. Of its entries"
            f" ${first}$ is sought, and ${second}$ is what the section knows:"
        ),
        Formula(start),
        Paragraph(f"The map has four blocks.{left_out if dropped else ''}"),
        Formula(
            (
                Line(rf"{state}^{{({len(view.links)})}}", "=", (f"{_N} {state}^{{(0)}}{shift},",)),
                Line(_N, "=", (_product(view, turn), rf"= \left({blocks}\right)")),
            )
        ),
        Paragraph(f"Periodicity reads{naming.cited('turn')}:"),
        Formula(
            (
                Line("", "", (rf"({_N}_{{1}} - I) {first} + {_N}_{{2}} {second}{one} = 0,",)),
                Line("", "", (rf"{_N}_{{3}} {first} + ({_N}_{{4}} - I) {second}{two} = 0.",)),
            )
        ),
    ]


def _product(view: View, turn: PeriodMap) -> str:
    """LaTeX of the product of flows and resets, the first phase on the right."""
    factors = []
    for k, link in enumerate(view.links):
        if link.duration != 0:
            dwell = view.naming.notation.symbol(link.dwell)
            factors.append(rf"\Phi_{{{view.numbers[link.flow.configuration]}}}({dwell})")
        if k in turn.resets:
            factors.append(f"R_{{{k + 1}}}")
    return r" \, ".join(reversed(factors))


def _entries(view: View, turn: PeriodMap) -> list[Block]:
    """Blocks on the entries of N, phase after phase."""
    naming = view.naming
    named = {rf"{_N}_{{{i}}}": block for i, block in enumerate(turn.blocks, start=1)}
    if not turn.offset.is_zero_matrix:
        named |= {
            f"c_{{{i}}}": turn.offset.extract(list(places), [0])
            for i, places in enumerate((turn.sought, turn.known), start=1)
        }
    shown = [
        Line(name, "=", (naming.notation.latex(block),), None, _shown(block))
        for name, block in named.items()
    ]
    blocks: list[Block] = [
        Paragraph(
            "Its entries are the derivatives of the state behind the last phase by the start, at"
            " given dwell times. Each phase carries them as it carries the state; one that is a"
            " number, a dwell time or the same as another has no line of its own."
        )
    ]
    for stage in turn.map_stages:
        lines = [
            naming.equal(symbol, expression)
            for symbol, expression in stage.assignments
            if symbol not in naming.notation.functions
        ]
        if lines:
            title = naming.prose(stage.title)
            blocks += [Paragraph(f"{title[:1].upper()}{title[1:]}:"), Formula(tuple(lines))]
    return [*blocks, Paragraph("So the blocks are"), Formula(tuple(shown))]


def _start(view: View, turn: PeriodMap) -> list[Block]:
    """Blocks on the start (A.3), with the numerators of Cramer's rule inserted."""
    naming, (first, second) = view.naming, _vectors(view.naming)
    sought = [turn.start[place] for place in turn.sought]
    inserted = {
        symbol: expression
        for stage in turn.start_stages
        for symbol, expression in stage.assignments
        if meaning_of(symbol) == "numerator"
    }
    lines = [
        naming.equal(symbol, expression.xreplace(inserted))
        for stage in turn.start_stages
        for symbol, expression in stage.assignments
        if symbol not in inserted
    ]
    text = f"The first condition is linear in {naming.list(sought)} and gives the start"
    formula = rf"-({_N}_{{1}} - I)^{{-1}} {_N}_{{2}} {second}"
    blocks: list[Block] = [Paragraph(f"{text}:")]
    if _separate(turn):
        blocks = [
            Paragraph(f"{text}{naming.cited('linear start')}:"),
            Formula((Line(first, "=", (f"{formula},",)),)),
            Paragraph("which is, entry by entry,"),
        ]
    return [*blocks, Formula(tuple(lines))]


def _rest(view: View, turn: PeriodMap) -> list[Block]:
    """Blocks on the compatibility conditions (A.2) and on the switching conditions left."""
    naming = view.naming
    (_, second), unknowns = _vectors(naming), naming.list(turn.unknowns)
    labels = [f"({view.label('The equations', k)})" for k in range(len(view.links))]
    contained = [labels[k] for k in turn.contained]
    left = [label for k, label in enumerate(labels) if k not in turn.contained]
    conditions = "the compatibility condition" + ("s" if len(turn.compatibility) > 1 else "")
    blocks: list[Block] = []
    if turn.compatibility:
        blocks = [
            Paragraph(
                f"With this start the second becomes {conditions} on the dwell times. It contains"
                f" equation{'s' if len(contained) > 1 else ''} {enumeration(contained)}, from"
                f" which the section knows ${second}$:"
            ),
            *view.numbered(TITLE, turn.compatibility, [e for _, e in turn.compatibility]),
        ]
    if turn.compatibility and _separate(turn) and len(turn.known) == len(turn.sought):
        matrix = rf"({_N}_{{1}} - I)^{{-1}} {_N}_{{2}} - {_N}_{{3}}^{{-1}} ({_N}_{{4}} - I)"
        blocks += [
            Paragraph(
                rf"Where ${_N}_{{3}}$ is nonsingular these read{naming.cited('compatibility')}:"
            ),
            Formula(
                (
                    Line(rf"\tilde M {second}", "=", ("0,",)),
                    Line(r"\tilde M", "=", (f"{matrix}.",)),
                )
            ),
        ]
        if len({turn.start[place] for place in turn.known}) == 1:
            blocks.append(
                Paragraph(
                    f"Since the entries of ${second}$ are equal, the rows of $\\tilde M$ then sum"
                    " to zero."
                )
            )
    together = count(len(turn.compatibility) + len(left), "equation")
    with_left = f"With {enumeration(left)}, for the same start, there" if left else "There"
    return [*blocks, Paragraph(f"{with_left} are {together} for {unknowns}.")]


def _shown(block: sp.Matrix) -> sp.Basic:
    """A matrix as a line shows it: a single entry is written alone."""
    return block[0] if len(block) == 1 else sp.ImmutableMatrix(block)


def _separate(turn: PeriodMap) -> bool:
    """Whether what the section knows does not depend on what is sought, and no offset occurs."""
    sought = {turn.start[place] for place in turn.sought}
    known = set().union(*(turn.start[place].free_symbols for place in turn.known))
    return not sought & known and turn.offset.is_zero_matrix is True


def _vectors(naming: Naming) -> tuple[str, str]:
    """LaTeX of the entries of the start that are sought, and of those that the section knows.

    They are positions and velocities where masses stick.
    """
    letter = naming.letter if naming.second_order else naming.state.lower()
    return f"{letter}_{{0}}", f"{letter}_{{0}}'"
