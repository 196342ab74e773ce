"""The section of a document on the map of a whole turn and the start that follows from it."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.sections.template import compose, relation
from nonsmooth.derive.document.view import View
from nonsmooth.derive.document.wording import count
from nonsmooth.derive.equations.period_map import PeriodMap
from nonsmooth.derive.symbols import meaning_of

PERIOD_MAP = "The map of a period"

_N = r"\tilde N"


def period_map_section(view: View) -> list[Block]:
    """Blocks on N in blocks, the start that it gives, and the equations that it leaves."""
    naming, turn = view.naming, view.equations.period_map
    sought, known = ([turn.start[i] for i in p] for p in (turn.sought, turn.known))
    # positions and velocities where masses stick
    letter = naming.letter if naming.second_order else naming.state.lower()
    assigned = [a for stage in turn.start_stages for a in stage.assignments]
    numerators = {s: e for s, e in assigned if meaning_of(s) == "numerator"}
    # what the section knows does not depend on what is sought, and no offset occurs
    symbols = set().union(*(entry.free_symbols for entry in known))
    linear = turn.offset.is_zero_matrix is True
    separate = linear and not set(sought) & symbols
    labels = [f"({view.label('The equations', k)})" for k in range(len(view.links))]
    left = [label for k, label in enumerate(labels) if k not in turn.contained]
    square = turn.compatibility and separate and len(known) == len(sought)
    return compose(
        view,
        r"""
        The equations can be taken in another order, that of the Appendix of Pascal (2011). Given
        the dwell times a whole turn is [linear: a linear | an affine] map of the start. Of its
        entries $@first$ is sought, and $@second$ is what the section knows:
        $$
        @groups
        $$
        The map has four blocks. [dropped: A reset that only states that its boundary is reached is
        left out.]
        $$
        @state^{(@phases)} &= \tilde N @state^{(0)}[linear: |  + c],
        \tilde N &= @product
            = \left(\begin{matrix}@rows\end{matrix}\right)
        $$
        Periodicity reads@turn:
        $$
        (\tilde N_{1} - I) @first + \tilde N_{2} @second[linear: |  + c_{1}] = 0,
        \tilde N_{3} @first + (\tilde N_{4} - I) @second[linear: |  + c_{2}] = 0.
        $$
        Its entries are the derivatives of the state behind the last phase by the start, at given
        dwell times. Each phase carries them as it carries the state; one that is a number, a dwell
        time or the same as another has no line of its own.

        @stages

        So the blocks are
        $$
        @blocks
        $$
        The first condition is linear in @sought and gives the start[separate: @cited]:
        $$
        [separate: @first &= -(\tilde N_{1} - I)^{-1} \tilde N_{2} @second,]
        $$
        [separate: which is, entry by entry,]
        $$
        @start
        $$
        [compatibility: With this start the second becomes the compatibility condition[many
        compatibility: s] on the dwell times. It contains equation[many contained: s] @contained,
        from which the section knows $@second$:]

        @compatibility

        [square: Where $\tilde N_{3}$ is nonsingular these read@compatible:]
        $$
        [square: \tilde M @second &= 0,
        \tilde M &= (\tilde N_{1} - I)^{-1} \tilde N_{2} - \tilde N_{3}^{-1} (\tilde N_{4} - I).]
        $$
        [equal: Since the entries of $@second$ are equal, the rows of $\tilde M$ then sum to zero.]

        [left: With @left, for the same start, there | There] are @together for @unknowns.
        """,
        rows=r"\tilde N_{1} & \tilde N_{2}\\\tilde N_{3} & \tilde N_{4}",
        linear=linear,
        first=f"{letter}_{{0}}",
        second=f"{letter}_{{0}}'",
        groups=[
            relation(naming, left, _shown(sp.Matrix(group)))
            for left, group in ((f"{letter}_{{0}}", sought), (f"{letter}_{{0}}'", known))
        ],
        dropped=any(
            k not in turn.resets and link.reset != sp.eye(link.reset.rows)
            for k, link in enumerate(view.links)
        ),
        phases=len(view.links),
        product=_product(view, turn),
        turn=naming.cited("turn"),
        stages=_stages(view, turn),
        blocks=_blocks(view, turn),
        sought=sought,
        separate=separate,
        cited=naming.cited("linear start"),
        start=[naming.equal(s, e.xreplace(numerators)) for s, e in assigned if s not in numerators],
        compatibility=view.numbered(PERIOD_MAP, turn.compatibility),
        contained=[labels[k] for k in turn.contained],
        square=square,
        compatible=naming.cited("compatibility"),
        equal=square and len(set(known)) == 1,
        left=left,
        together=count(len(turn.compatibility) + len(left), "equation"),
        unknowns=turn.unknowns,
    )


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


def _stages(view: View, turn: PeriodMap) -> list[Block]:
    """Blocks on the entries of N, phase after phase."""
    naming = view.naming
    blocks: list[Block] = []
    for stage in turn.map_stages:
        title = naming.prose(stage.title)
        lines = [
            naming.equal(s, e) for s, e in stage.assignments if s not in naming.notation.functions
        ]
        blocks += compose(
            view,
            "[lines: @title:]\n$$\n@lines\n$$",
            title=f"{title[:1].upper()}{title[1:]}",
            lines=lines,
        )
    return blocks


def _blocks(view: View, turn: PeriodMap) -> list[Line]:
    """Lines with the blocks of N and of its offset."""
    named = {rf"{_N}_{{{i}}}": block for i, block in enumerate(turn.blocks, start=1)}
    if not turn.offset.is_zero_matrix:
        named |= {
            f"c_{{{i}}}": turn.offset.extract(list(places), [0])
            for i, places in enumerate((turn.sought, turn.known), start=1)
        }
    latex = view.naming.notation.latex
    return [Line(name, "=", (latex(m),), None, _shown(m)) for name, m in named.items()]


def _shown(block: sp.Matrix) -> sp.Basic:
    """A matrix as a line shows it: a single entry is written alone."""
    return block[0] if len(block) == 1 else sp.ImmutableMatrix(block)
