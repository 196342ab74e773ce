"""The sections of a document on the chain of an orbit's states, its symmetry and its equations."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.cycle import Cycle
from nonsmooth.derive.document.sections.template import (
    compose,
    ended,
    math,
    relation,
    sentence,
    zeros,
)
from nonsmooth.derive.document.view import View
from nonsmooth.derive.document.wording import count, number
from nonsmooth.derive.equations.energy import is_conservative
from nonsmooth.derive.equations.section import passages_of
from nonsmooth.derive.equations.symmetry import end_conditions, phase_ends, reversor_of
from nonsmooth.derive.symbols import Symbol


def chain_section(view: View) -> list[Block]:
    """Blocks on the states behind the phases, one phase after the other."""
    blocks = compose(
        view,
        r"""
        The flows carry the start through the phases, $@arrows$. [reversible: The conditions halfway
        do without whole phases; the chain is what the Poincaré map is made of, and at the orbit it
        gives the images under $\mathcal{R}$ found above.]
        """,
        arrows=r" \;\to\; ".join(
            f"{view.naming.state}^{{({k})}}" for k in range(len(view.links) + 1)
        ),
    )
    for index, link in enumerate(view.links, start=1):
        blocks += compose(
            view,
            r"""
            Phase @index, *@link.configuration.name* [link.duration: for
            $@link.dwell$ with $\Phi_{@flow}(@link.dwell)$ | for no time]@cited:
            $$
            @lines
            $$
            [rules: The transition to *@link.transition.target* @rules@reset.]
            """,
            index=index,
            link=link,
            flow=view.numbers[link.configuration.name],
            cited=view.naming.cited(f"phase {index}"),
            lines=_lines(view, index),
            rules=[_rule(view, s, e) for s, e in link.transition.reset.items()],
            reset=view.naming.cited(f"reset {index}"),
        )
    return blocks


def _lines(view: View, index: int) -> list[Line]:
    """Lines for the state at the end of one phase, state by state."""
    link, naming = view.links[index - 1], view.naming
    assigned = dict(a for s in view.equations.chain.stages for a in s.assignments)
    states = zip(naming.system.states, link.after, strict=True)
    named = {Symbol("state", symbol, index): value for symbol, value in states}
    # a state that does not move is what it was, not once more how that came about
    return [naming.equal(s, assigned[s] if value == s else value) for s, value in named.items()]


def _rule(view: View, symbol: sp.Symbol, expression: sp.Expr) -> str:
    """Text that says what a reset does to one state."""
    left, right = math(view.naming, symbol), math(view.naming, expression)
    moving = expression.free_symbols & set(view.naming.system.states)
    return f"takes {left} to {right}" if moving else f"sets {left[:-1]} = {right[1:]}"


def equation_section(view: View) -> list[Block]:
    """Blocks with the numbered equations: switching conditions and closure."""
    equations, coordinates = view.equations, view.equations.chain.start.coordinates
    closed = {meaning for meaning, _ in equations.equations}
    return compose(
        view,
        """
        [reversible: The conditions halfway through the phase[many links: s] [kept: , and what the
        ends leave,] make @number for @unknowns, @equations.unknowns. Each is written function by
        function of half the dwell time: | The switching condition of each phase and the closure of
        each of the start's own coordinates [dropped: [equations.chain.forcing: , with the amplitude
        of the forcing and whole periods of it in place of the closure of its cosine and sine, |
        but @dropped, which the energy makes return if all others do,]] make @number for @unknowns:]

        @formulas
        """,
        kept=any("halfway" not in meaning for meaning in closed),
        number=count(len(equations.equations), "equation"),
        unknowns=count(len(equations.unknowns), "unknown"),
        dropped=[q for q in coordinates if f"{q} returns" not in closed],
        formulas=view.numbered("The equations", equations.equations),
    )


def cycle_equations(cycle: Cycle) -> list[Block]:
    """Blocks on the chain of states, the switching conditions and the closure."""
    several = cycle.count > 1
    return compose(
        cycle,
        r"""
        Let $\Phi^{(@phase)}$ be the flow of phase $@phase$ over its dwell time and
        $@forcing^{(@phase)}$ the part of it that does not depend on the state, zero in a
        configuration that rests at the origin. [resets: The transition behind it takes $@state$ to
        $@reset_{@index} @state + @jump_{@index}$. | The state is continuous at every transition.]
        From the start, the [several: states follow @all | state follows],
        $$
        @state^{(@phase)} &= \Phi^{(@phase)} @state^{@before} + @forcing^{(@phase)}[resets: ,\qquad
            @state^{(@phase)+} = @reset_{@index} @state^{(@phase)} + @jump_{@index}[several: ,\qquad
            @state^{(0)+} = @state^{(0)}]].
        \tag{@first}
        $$
        Each phase ends on its boundary, the function of which is $@normal_{@index} @state +
        @constant_{@index}$:
        $$
        @normal_{@index} @state^{(@phase)} + @constant_{@index} = 0
        \tag{@second} @all
        $$
        [start.dimension: and the orbit closes [directions: up to the shift]. With $@embedding^{+}$,
        which takes the coordinates $@letters.coordinates$ of a state on the section, | The end of
        the last phase closes the orbit of itself.]
        $$
        [start.dimension: @embedding^{+} @returned - @letters.coordinates = 0
        \tag{@third}]
        $$
        [start.dimension: These are @total. The other coordinates return with these, by what the
        last phase enforces. [conservative: The energy is kept along the orbit, so that one of the
        equations follows from the others: the orbit is one of a family, and its period may be
        given.]]
        """,
        several=several,
        all=_all_phases(cycle),
        before=f"(k-1){'+' if cycle.resets else ''}" if several else "(0)",
        returned=sentence(
            cycle,
            r"[directions: \left(@ends - @letters.directions @shift\right) | @ends]",
            ends=cycle_end(cycle),
        ),
        total=count(cycle.count + cycle.start.dimension, "equation"),
        conservative=is_conservative(cycle.itinerary),
        first=cycle.label("The equations"),
        second=cycle.label("The equations", 1),
        third=cycle.label("The equations", 2),
    )


def cycle_end(cycle: Cycle) -> str:
    """LaTeX of the state behind the last transition."""
    return f"{cycle.naming.state}^{{({cycle.count}){'+' if cycle.resets else ''}}}"


def _all_phases(cycle: Cycle) -> str:
    """Text on the values of the index of a phase."""
    if cycle.count == 1:
        return ""
    return "for $k = 1, 2$" if cycle.count == 2 else rf"for $k = 1, \ldots, {cycle.count}$"


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
    itinerary, _, start = view.undecided
    naming, state = view.naming, view.naming.state
    lines: list[Line] = []
    begin = f"{state}^{{(0)}}"
    passages = zip(passages_of(itinerary), phase_ends(itinerary, start), strict=True)
    for index, (passage, end) in enumerate(passages, start=1):
        left = f"{state}^{{({index})}}"
        lines.append(relation(naming, rf"{left} = \mathcal{{R}}\,{begin}", end, ","))
        after = passage.behind(end)
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
