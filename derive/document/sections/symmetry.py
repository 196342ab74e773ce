"""The section of a document on an orbit that a reversor maps to itself."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.sections.template import compose, ended, math, relation, zeros
from nonsmooth.derive.document.view import View
from nonsmooth.derive.document.wording import count, number
from nonsmooth.derive.equations.symmetry import end_conditions, phase_starts, reversor_of

__all__ = ["symmetry_section"]


def symmetry_section(view: View) -> list[Block]:
    """Blocks on the reversor, the states at the ends of the phases, and the closure."""
    naming, reversor = view.naming, view.itinerary.reversor
    notation, states = naming.notation, naming.system.states
    ends = _ends(view)
    return compose(
        view,
        r"""
        The map[cited: @cited,]
        $$
        \mathcal{R}:\quad @images
        $$
        [kept: keeps @kept. It is | is] a reversor of every configuration of the orbit, its own
        inverse: with $@state(t)$ also $\mathcal{R}\,@state(-t)$[backwards: , the motion read
        backwards,] is a motion. It fixes the states with @fixed. A phase ends at the image of its
        start, $@state(\tau) = \mathcal{R}\,@state(0)$, exactly if it passes such a state halfway.
        The orbit is sought among those whose phases all do so. The conditions halfway replace those
        at the ends, which would contain each of them twice and make the equations singular.

        The states at the ends of the phases [plus: (a plus marks what is behind a reset)] then
        follow from the start without any flow,
        $$
        @ends
        $$
        @closure
        """,
        cited=naming.cited("symmetry"),
        images=",\\quad ".join(
            rf"{notation.symbol(s)} \mapsto {notation.latex(notation.tidy(e))}"
            for s, e in reversor.items()
        ),
        kept=[s for s in states if s not in reversor],
        backwards=set(reversor) == set(states[len(naming.positions) :])
        and all(e == -s for s, e in reversor.items()),
        fixed=_fixed(view),
        plus=any("+}" in line.left for line in ends),
        ends=ends,
        closure=_closure(view),
    )


def _fixed(view: View) -> list[str]:
    """Conditions under which a state is its own image."""
    jump, shift = reversor_of(view.itinerary)
    fixed, _ = sp.Matrix.hstack(jump - sp.eye(jump.rows), shift).rref()
    rows = fixed * sp.Matrix([*view.naming.system.states, 1])
    return [math(view.naming, row, " = 0") for row in rows if row != 0]


def _ends(view: View) -> list[Line]:
    """Lines with the states at the ends of the phases, which follow without a flow."""
    itinerary, system, start = view.undecided
    naming, state = view.naming, view.naming.state
    jump, shift = reversor_of(itinerary)
    lines: list[Line] = []
    begin = f"{state}^{{(0)}}"
    for index, before in enumerate(phase_starts(itinerary, start), start=1):
        end = jump * before + shift
        left = f"{state}^{{({index})}}"
        lines.append(relation(naming, rf"{left} = \mathcal{{R}}\,{begin}", end, ","))
        after = itinerary.transition_after(system, index - 1).reset_of(end, system.states)
        begin = left if after == end else f"{state}^{{({index})+}}"
        if after != end:
            lines.append(relation(naming, begin, after, ","))
    return [*lines[:-1], ended(lines[-1], ".")]


def _closure(view: View) -> list[Block]:
    """Blocks on what remains of the exit conditions and of the closure."""
    naming, equations = view.naming, view.equations
    notation, required = naming.notation, equations.required
    itinerary, _, start = view.undecided
    left = [(m, e) for m, e in end_conditions(itinerary, start) if e != 0]
    decided = {*equations.vanishing, *required}
    deciding = [e for _, e in left if e.free_symbols & decided]
    staying = [m for m, e in left if not e.free_symbols & decided]
    total = len(itinerary.phases) + start.dimension
    beside, grazed = _otherwise(view, deciding)
    return compose(
        view,
        r"""
        [left: Of the exit conditions and the closure, @total in all, @holding hold there for every
        start. [staying: That @staying is left, and stays among the equations, as @labels.]
        [deciding: The closure leaves] | There the exit conditions and the closure hold for every
        start: nothing but the conditions halfway is left.]
        $$
        @deciding
        $$
        [deciding: so that [equations.vanishing: @zeros][equations.required:
        [equations.vanishing: , and] @values, [grazed: since with @beside zero the boundary would
        only be grazed | unless @beside is zero]]. Without that there is no such orbit, so it is
        inserted from here on:]
        $$
        [deciding: @state^{(0)} &= @equations.chain.start.state,]
        $$
        [deciding: with @coordinates, @equations.chain.start.coordinates.]
        """,
        left=left,
        total=number(total),
        holding=number(total - len(left)),
        staying=[naming.prose(m) for m in staying],
        labels=[label for m in staying for label in view.labels_of(m)],
        deciding=[
            Line("", "", (f"{notation.latex(sp.factor(e))} = 0,",), None, e) for e in deciding
        ],
        zeros=zeros(naming, equations.vanishing),
        values=[f"${notation.symbol(p)} = {notation.latex(v)}$" for p, v in required.items()],
        grazed=grazed,
        beside=beside,
        coordinates=count(equations.chain.start.dimension, "coordinate"),
    )


def _otherwise(view: View, conditions: Sequence[sp.Expr]) -> tuple[list[sp.Symbol], bool]:
    """Coordinates that would be zero in place of a required value.

    The second value tells whether the boundary would then only be grazed.
    """
    _, _, start = view.undecided
    required = set(view.equations.required)
    beside = [
        q for q in start.coordinates if any({q} | required <= e.free_symbols for e in conditions)
    ]
    rates = [
        (link.normal * link.flow.velocity(end))[0]
        for link, end in zip(view.links, view.images, strict=True)
    ]
    grazed = all(any(r.subs(q, 0) == 0 for r in rates) for q in beside)
    return beside, bool(beside) and grazed
