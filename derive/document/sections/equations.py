"""The sections of a document on an itinerary, its chain of states, its symmetry, its equations."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.template import compose, sentence
from nonsmooth.derive.document.view import Cycle, OfItinerary, View
from nonsmooth.derive.equations.energy import is_conservative
from nonsmooth.derive.equations.section import passages_of
from nonsmooth.derive.equations.symmetry import end_conditions, phase_ends, reversor_of
from nonsmooth.derive.symbols import Symbol


def itinerary_section(view: View) -> list[Block]:
    """Blocks on the phases, given dwell times, the section at the start and the unknowns."""
    return [
        *_phases(view),
        *_source_letters(view),
        *_dwell_times(view),
        *_start(view),
    ]


def phase_section(cycle: Cycle) -> list[Block]:
    """Blocks on the phases, the start and the unknowns of an itinerary without equations."""
    itinerary = cycle.itinerary
    solved = [p.symbol for p in cycle.system.parameters if p.name in itinerary.solved_for]
    return [
        *_phases(cycle),
        *compose(
            cycle,
            """
            [itinerary.period: The period $@itinerary.period.symbol$ is given; the last dwell time
            is what the others leave of it.]

            [vanishing: Here $@vanishing = 0$: boundaries are reached at one instant, a border
            collision, for which @solved [many vanishing: have | has] to be found.]
            """,
            vanishing=list(map(dwell_symbol, itinerary.vanishing)),
            solved=solved,
        ),
        *_source_letters(cycle),
        *_section(cycle),
        *_unknowns(cycle, solved),
    ]


def _phases(shown: OfItinerary) -> list[Block]:
    """Blocks on the phases; the table tells which transitions they end by if some are repeated."""
    notation = shown.notation
    repeated = shown if isinstance(shown, Cycle) and not shown.distinct else None
    rows = []
    for index, passage in enumerate(passages_of(shown.itinerary), start=1):
        dwell, name = notation.symbol(passage.dwell), passage.configuration.name
        function = passage.value(sp.Matrix(passage.states))
        rows.append(
            (
                str(index),
                f"*{name}*",
                f"${dwell}$",
                rf"$\Phi_{{{notation.flow_number(name)}}}({dwell})$",
                f"*{passage.boundary}*",
                f"${repeated.number(index)}$" if repeated else notation.math(function, " = 0"),
            )
        )
    return compose(
        shown,
        """
        The orbit has #count phase(s) to a period. [many count: Each phase stays in one
        configuration for its dwell time and ends on one boundary. | It stays in one configuration
        for its dwell time and ends on one boundary, from which the transition leads back to the
        start.] [repeated: Behind [many passings: them there are #passings different transition(s);
        | all of them is the same transition;] $j(k)$ is the number of the one behind phase $k$.]

        | Phase | Configuration | Dwell time | Flow | Left by | [repeated: Transition | Where] |
        @rows
        """,
        repeated=repeated,
        passings=repeated.passings if repeated else (),
        rows=rows,
    )


def _source_letters(shown: OfItinerary) -> list[Block]:
    """Paragraph on the letters of the source for flows, states and the section."""
    notation, source = shown.notation, shown.notation.source
    if source is None:
        return []
    flows = source.flows.items()
    names = [rf"$\Phi_{{{notation.flow_number(name)}}}$ is ${letter}$" for name, letter in flows]
    names += [f"${notation.state}^{{({k})}}$ is ${name}$" for k, name in enumerate(source.states)]
    names += [f"the section is ${source.section}$"] if source.section else []
    return compose(shown, "[names: In @source.name @names.]", names=names)


def _dwell_times(view: View) -> list[Block]:
    """Blocks on a given period and the dwell time that follows, and on vanishing dwell times."""
    phases, links = view.itinerary.phases, view.links
    vanishing = [i for i, link in enumerate(links) if link.duration == 0]
    reached = [phases[j].boundary for i in vanishing for j in (i - 1, i)]
    derived = {k.dwell: k.duration for k in links if k.duration not in (k.dwell, 0)}
    return compose(
        view,
        """
        [itinerary.period: The period $@itinerary.period.symbol$ [derived: is given; the last dwell
        time is what the others leave of it, | , which is the dwell time, is given.]]
        $$
        @derived
        $$
        [dwell: Here $@dwell = 0$: the orbit is a border collision. It reaches *@boundaries* at one
        instant and stays in *@names* for no time. That is one condition more than an orbit with
        $@dwell > 0$ has to meet, and determines the parameter[many swapped: s] @swapped, unknown in
        place of @dwell. A perturbation for which @dwell would come out negative takes the
        boundaries in another order and follows another itinerary: all derivatives below are
        one-sided, for $@dwell > 0$.]
        """,
        derived=derived if view.itinerary.period else {},
        dwell=[links[i].dwell for i in vanishing],
        boundaries=list(dict.fromkeys(reached)),
        names=[phases[i].configuration for i in vanishing],
        swapped=[s for s in view.equations.unknowns if str(s) in view.itinerary.solved_for],
    )


def _start(view: View) -> list[Block]:
    """Blocks on the set on which the start lies, the unknowns and the parameters."""
    equations, (_, _, start) = view.equations, view.undecided
    dwell = [u for u in equations.unknowns if u in {link.dwell for link in view.links}]
    return compose(
        view,
        r"""
        $@state^{(k)}$ is the state $\left(@column\right)^{\mathsf{T}}$ behind phase $k$, and
        $@state^{(0)}$ the start. [inside: It lies on the section that the end of the last phase
        enforces@cited(start), | The end of the last phase enforces a section of dimension
        #dimension. The start is written in more coordinates, and what the section requires of them
        is among the equations,]
        $$
        @state^{(0)} &= @start.state,
        $$
        with #start.coordinates coordinate(s), @start.coordinates. [equations.vanishing: The closure
        will require $@equations.vanishing = 0$, which leaves #equations.unknowns unknown(s), @left
        [dwell: and @dwell]. | [dwell: With the dwell time[many dwell: s] @dwell [swapped: and the
        parameter @swapped] this makes #equations.unknowns unknown(s).]] The parameters of the
        equations are @equations.parameters. [equations.open_parameters: @equations.open_parameters
        [many equations.open_parameters: do not enter them; they decide | does not enter them; it
        decides] on admissibility alone.]
        """,
        inside=start.dimension == equations.chain.section.dimension,
        dimension=equations.chain.section.dimension,
        start=start,
        left=[q for q in start.coordinates if q not in equations.vanishing],
        dwell=dwell,
        swapped=[u for u in equations.unknowns if u not in (*start.coordinates, *dwell)],
    )


def _section(cycle: Cycle) -> list[Block]:
    """Blocks on what maps an orbit to others, and on the set on which its start lies."""
    notation, start = cycle.notation, cycle.start
    return compose(
        cycle,
        r"""
        [reversor: The orbit is sought among those that the reversor @reversor maps to themselves,
        each phase being its own time reversal.]

        $@state^{(k)}$ is the state $\left(@column\right)^{\mathsf{T}}$ at the end of phase
        $k$[resets: , in front of the transition, $@state^{(k)+}$ behind it,] and $@state^{(0)}$ the
        start. What the end of the last phase enforces, carried through its transition, leaves the
        start [start.dimension: #start.dimension coordinate(s), | no freedom,]
        $$
        [start.dimension: @state^{(0)} &= @embedding @letters.coordinates[shifted:  + @base]
            = @start.state
        @letters.coordinates &= @names. | @state^{(0)} &= @written.]
        $$
        [directions: Nothing depends on where along $@letters.directions = @directions$ the motion
        takes place: with a motion $@state(t)$ every $@state(t) + @letters.directions @shift$ is
        one. The orbit returns up to such a shift $@shift$, and #directions.cols coordinate(s) of
        the start, changed by it, may be chosen.]
        """,
        reversor=[
            rf"${notation.symbol(s)} \mapsto {notation.latex(e)}$"
            for s, e in cycle.itinerary.reversor.items()
        ],
        shifted=not start.constant.is_zero_matrix,
        names=notation.text(sp.Matrix(start.coordinates)) if start.dimension else "",
        written=notation.text(start.state),
    )


def _unknowns(cycle: Cycle, solved: Sequence[sp.Symbol]) -> list[Block]:
    """Paragraph that counts the unknowns and names the given parameters."""
    itinerary, moved = cycle.itinerary, cycle.directions.cols
    dwell = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    dwell = dwell if itinerary.period is None else dwell[:-1]
    left = cycle.start.dimension - moved
    texts = {
        "#dwell dwell time(s)": dwell,
        "#left coordinate(s) of the start": left,
        "the shift $@shift$": moved,
        "the parameter[many solved: s] @solved": solved,
    }
    values = {"dwell": dwell, "left": left, "solved": solved}
    return compose(
        cycle,
        """
        The unknowns are @parts, #total in all. [given: Given are the parameters @given.]
        """,
        parts=[sentence(cycle, text, **values) for text, some in texts.items() if some],
        total=len(dwell) + cycle.start.dimension + len(itinerary.solved_for),
        given=[p.symbol for p in cycle.system.parameters if p.name not in itinerary.solved_for],
    )


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
            f"{view.notation.state}^{{({k})}}" for k in range(len(view.links) + 1)
        ),
    )
    for index, link in enumerate(view.links, start=1):
        reset = link.transition.reset
        blocks += compose(
            view,
            r"""
            Phase @index, *@link.configuration.name* [link.duration: for $@link.dwell$ with
            $\Phi_{@flow}(@link.dwell)$ | for no time]@cited(phase @index):
            $$
            @lines
            $$
            [rules: The transition to *@link.transition.target* @rules@cited(reset @index).]
            """,
            index=index,
            link=link,
            flow=view.notation.flow_number(link.configuration.name),
            lines=_lines(view, index),
            rules=[_rule(view, s, reset[s]) for s in view.notation.system.states if s in reset],
        )
    return blocks


def _lines(view: View, index: int) -> dict[sp.Symbol, sp.Expr]:
    """The state at the end of one phase, state by state."""
    assigned = dict(a for s in view.equations.chain.stages for a in s.assignments)
    states = zip(view.notation.system.states, view.links[index - 1].after, strict=True)
    named = {Symbol("state", symbol, index): value for symbol, value in states}
    # a state that does not move is what it was, not once more how that came about
    return {s: assigned[s] if value == s else value for s, value in named.items()}


def _rule(view: View, symbol: sp.Symbol, expression: sp.Expr) -> str:
    """Text that says what a reset does to one state."""
    return sentence(
        view,
        "[moving: takes $@symbol$ to $@expression$ | sets $@symbol = @expression$]",
        moving=expression.free_symbols & set(view.notation.system.states),
        symbol=symbol,
        expression=expression,
    )


def equation_section(view: View) -> list[Block]:
    """Blocks with the numbered equations: switching conditions and closure."""
    equations, coordinates = view.equations, view.equations.chain.start.coordinates
    closed = {meaning for meaning, _ in equations.equations}
    return compose(
        view,
        """
        [reversible: The conditions halfway through the phase[many links: s] [kept: , and what the
        ends leave,] make #equations.equations equation(s) for #unknowns unknown(s), @unknowns. Each
        is written function by function of half the dwell time: | The switching condition of each
        phase and the closure of each of the start's own coordinates [dropped:
        [equations.chain.forcing: , with the amplitude of the forcing and whole periods of it in
        place of the closure of its cosine and sine, | but @dropped, which the energy makes return
        if all others do,]] make #equations.equations equation(s) for #unknowns unknown(s):]

        @formulas
        """,
        kept=any("halfway" not in meaning for meaning in closed),
        unknowns=equations.unknowns,
        dropped=[q for q in coordinates if f"{q} returns" not in closed],
        formulas=view.numbered("The equations", equations.equations),
    )


def cycle_equations(cycle: Cycle) -> list[Block]:
    """Blocks on the chain of states, the switching conditions and the closure."""
    return compose(
        cycle,
        r"""
        Let $\Phi^{(@phase)}$ be the flow of phase $@phase$ over its dwell time and
        $@forcing^{(@phase)}$ the part of it that does not depend on the state, zero in a
        configuration that rests at the origin. [resets: The transition behind it takes $@state$ to
        $@reset_{@index} @state + @jump_{@index}$. | The state is continuous at every transition.]
        From the start, the [many count: states follow @all | state follows],
        $$
        @state^{(@phase)} &= \Phi^{(@phase)} @state^{@before} + @forcing^{(@phase)}[resets: ,\qquad
            @state^{(@phase)+} = @reset_{@index} @state^{(@phase)} + @jump_{@index}[several: ,\qquad
            @state^{(0)+} = @state^{(0)}]].
        \tag{@label(The equations 1)}
        $$
        Each phase ends on its boundary, the function of which is $@normal_{@index} @state +
        @constant_{@index}$:
        $$
        @normal_{@index} @state^{(@phase)} + @constant_{@index} = 0
        \tag{@label(The equations 2)} @all
        $$
        [start.dimension: and the orbit closes [directions: up to the shift]. With $@embedding^{+}$,
        which takes the coordinates $@letters.coordinates$ of a state on the section, | The end of
        the last phase closes the orbit of itself.]
        $$
        [start.dimension: @embedding^{+} @returned - @letters.coordinates = 0
        \tag{@label(The equations 3)}]
        $$
        [start.dimension: These are #total equation(s). The other coordinates return with these, by
        what the last phase enforces. [conservative: The energy is kept along the orbit, so that one
        of the equations follows from the others: the orbit is one of a family, and its period may
        be given.]]
        """,
        several=cycle.count > 1,
        before=f"(k-1){'+' if cycle.resets else ''}" if cycle.count > 1 else "(0)",
        returned=sentence(
            cycle, r"[directions: \left(@end - @letters.directions @shift\right) | @end]"
        ),
        all={1: "", 2: "for $k = 1, 2$"}.get(cycle.count, rf"for $k = 1, \ldots, {cycle.count}$"),
        total=cycle.count + cycle.start.dimension,
        conservative=is_conservative(cycle.itinerary),
    )


def symmetry_section(view: View) -> list[Block]:
    """Blocks on the reversor, the states at the ends of the phases, and the closure."""
    notation, reversor = view.notation, view.itinerary.reversor
    states = notation.system.states
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
        backwards,] is a motion. It fixes the states with $@fixed = 0$. A phase ends at the image of
        its start, $@state(\tau) = \mathcal{R}\,@state(0)$, exactly if it passes such a state
        halfway. The orbit is sought among those whose phases all do so. The conditions halfway
        replace those at the ends, which would contain each of them twice and make the equations
        singular.

        The states at the ends of the phases [plus: (a plus marks what is behind a reset)] then
        follow from the start without any flow,
        $$
        @ends
        $$
        @closure
        """,
        cited=notation.cited("symmetry"),
        images=",\\quad ".join(
            rf"{notation.symbol(s)} \mapsto {notation.text(e)}" for s, e in reversor.items()
        ),
        kept=[s for s in states if s not in reversor],
        backwards=set(reversor) == set(states[len(notation.positions) :])
        and all(e == -s for s, e in reversor.items()),
        fixed=_fixed(view),
        plus=any("+}" in line.left for line in ends),
        ends=ends,
        closure=_closure(view),
    )


def _fixed(view: View) -> list[sp.Expr]:
    """What is zero where a state is its own image."""
    jump, shift = reversor_of(view.itinerary)
    fixed, _ = sp.Matrix.hstack(jump - sp.eye(jump.rows), shift).rref()
    return [row for row in fixed * sp.Matrix([*view.notation.system.states, 1]) if row != 0]


def _ends(view: View) -> list[Line]:
    """Lines with the states at the ends of the phases, which follow without a flow."""
    itinerary, _, start = view.undecided
    notation, state = view.notation, view.notation.state
    lines: list[Line] = []
    begin = f"{state}^{{(0)}}"
    passages = zip(passages_of(itinerary), phase_ends(itinerary, start), strict=True)
    for index, (passage, end) in enumerate(passages, start=1):
        left = f"{state}^{{({index})}}"
        lines.append(notation.relation(rf"{left} = \mathcal{{R}}\,{begin}", end, ","))
        after = passage.behind(end)
        begin = left if after == end else f"{state}^{{({index})+}}"
        if after != end:
            lines.append(notation.relation(begin, after, ","))
    return [*lines[:-1], lines[-1].ended(".")]


def _closure(view: View) -> list[Block]:
    """Blocks on what remains of the exit conditions and of the closure."""
    notation, equations, required = view.notation, view.equations, view.equations.required
    itinerary, _, start = view.undecided
    left = [(m, e) for m, e in end_conditions(itinerary, start) if e != 0]
    decided = {*equations.vanishing, *required}
    deciding = [e for _, e in left if e.free_symbols & decided]
    staying = [m for m, e in left if not e.free_symbols & decided]
    total = len(itinerary.phases) + start.dimension
    # coordinates that would be zero in place of a required value
    beside = [
        q for q in start.coordinates if any({q} | set(required) <= e.free_symbols for e in deciding)
    ]
    rates = [
        (link.normal * link.flow.velocity(end))[0]
        for link, end in zip(view.links, view.images, strict=True)
    ]
    return compose(
        view,
        r"""
        [left: Of the exit conditions and the closure, #total in all, #holding hold there for every
        start. [staying: That @staying is left, and stays among the equations, as @labels.]
        [deciding: The closure leaves] | There the exit conditions and the closure hold for every
        start: nothing but the conditions halfway is left.]
        $$
        @deciding
        $$
        [deciding: so that [equations.vanishing: $@equations.vanishing = 0$][required:
        [equations.vanishing: , and] $@required$, [grazed: since with @beside zero the boundary
        would only be grazed | unless @beside is zero]]. Without that there is no such orbit, so it
        is inserted from here on:]
        $$
        [deciding: @state^{(0)} &= @equations.chain.start.state,]
        $$
        [deciding: with #coordinates coordinate(s), @coordinates.]
        """,
        left=left,
        total=total,
        holding=total - len(left),
        staying=list(map(notation.prose, staying)),
        labels=[label for m in staying for label in view.labels_of(m)],
        deciding=[
            Line("", "", (f"{notation.latex(sp.factor(e))} = 0,",), None, e) for e in deciding
        ],
        required=required,
        beside=beside,
        grazed=beside and all(any(r.subs(q, 0) == 0 for r in rates) for q in beside),
        coordinates=equations.chain.start.coordinates,
    )
