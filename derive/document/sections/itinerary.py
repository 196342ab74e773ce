"""The section of a document on an itinerary: phases, dwell times, start, unknowns."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.document.blocks import Block, Table
from nonsmooth.derive.document.cycle import Cycle
from nonsmooth.derive.document.sections.template import compose, math, transposed, zeros
from nonsmooth.derive.document.view import Described, View
from nonsmooth.derive.document.wording import Naming, count, number
from nonsmooth.derive.equations.section import passages_of

_PHASES = """
The orbit has @phases to a period. [many steps: Each phase stays in one configuration for its dwell
time and ends on one boundary. | It stays in one configuration for its dwell time and ends on one
boundary, from which the transition leads back to the start.] [repeated: Behind [many passings: them
there are @transitions; | all of them is the same transition;] $j(k)$ is the number of the one
behind phase $k$.]

@table
"""


def itinerary_section(view: View) -> list[Block]:
    """Blocks on the phases, given dwell times, the section at the start and the unknowns."""
    return [
        *compose(
            view,
            _PHASES,
            phases=count(len(view.links), "phase"),
            steps=view.links,
            repeated=False,
            passings=(),
            table=_phase_table(view),
        ),
        *_source_letters(view),
        *_dwell_times(view),
        *_start(view),
    ]


def phase_section(cycle: Cycle) -> list[Block]:
    """Blocks on the phases, the start and the unknowns of an itinerary without equations."""
    itinerary, phases = cycle.itinerary, cycle.itinerary.phases
    solved = [p.symbol for p in cycle.system.parameters if p.name in itinerary.solved_for]
    numbers = [f"${cycle.number(index)}$" for index in range(1, cycle.count + 1)]
    return [
        *compose(
            cycle,
            f"""{_PHASES}
[itinerary.period: The period $@itinerary.period.symbol$ is given; the last dwell time is what the
others leave of it.]

[vanishing: Here @vanishing: boundaries are reached at one instant, a border collision, for which
@solved [many itinerary.vanishing: have | has] to be found.]
""",
            phases=count(cycle.count, "phase"),
            steps=phases,
            repeated=not cycle.distinct,
            transitions=count(len(cycle.passings), "different transition"),
            table=_phase_table(cycle, () if cycle.distinct else numbers),
            vanishing=zeros(cycle.naming, map(dwell_symbol, itinerary.vanishing)),
            solved=solved,
        ),
        *_source_letters(cycle),
        *_section(cycle),
        *_unknowns(cycle, solved),
    ]


def _state_column(naming: Naming) -> str:
    """LaTeX of all states in a column, written as a transposed row."""
    states = ", ".join(map(naming.notation.symbol, naming.system.states))
    return rf"\left({states}\right)^{{\mathsf{{T}}}}"


def _phase_table(shown: Described, transitions: Sequence[str] = ()) -> Table:
    """Table of the phases, each with its boundary, or else its transition, in the last column."""
    rows = []
    naming = shown.naming
    for index, passage in enumerate(passages_of(shown.itinerary), start=1):
        dwell, name = naming.notation.symbol(passage.dwell), passage.configuration.name
        function = passage.value(sp.Matrix(passage.states))
        rows.append(
            (
                str(index),
                f"*{name}*",
                f"${dwell}$",
                rf"$\Phi_{{{shown.numbers[name]}}}({dwell})$",
                f"*{passage.boundary}*",
                transitions[index - 1] if transitions else math(naming, function, " = 0"),
            )
        )
    last = "Transition" if transitions else "Where"
    return Table(("Phase", "Configuration", "Dwell time", "Flow", "Left by", last), tuple(rows))


def _source_letters(shown: Described) -> list[Block]:
    """Paragraph on the letters of the source for flows, states and the section."""
    source = shown.naming.source
    if source is None:
        return []
    flows = source.flows.items()
    names = [rf"$\Phi_{{{shown.numbers[name]}}}$ is ${letter}$" for name, letter in flows]
    state = shown.naming.state
    names += [f"${state}^{{({k})}}$ is ${name}$" for k, name in enumerate(source.states)]
    names += [f"the section is ${source.section}$"] if source.section else []
    return compose(shown, "[names: In @source.name @names.]", names=names)


def _dwell_times(view: View) -> list[Block]:
    """Blocks on a given period and the dwell time that follows, and on vanishing dwell times."""
    equations, phases = view.equations, view.itinerary.phases
    period = view.itinerary.period
    vanishing = [i for i, link in enumerate(view.links) if link.duration == 0]
    dwell = [view.links[i].dwell for i in vanishing]
    reached = [phases[j].boundary for i in vanishing for j in (i - 1, i)]
    swapped = [s for s in equations.unknowns if str(s) in view.itinerary.solved_for]
    derived = (
        []
        if period is None
        else [
            view.naming.equal(link.dwell, link.duration)
            for link in view.links
            if link.duration not in (link.dwell, 0)
        ]
    )
    return compose(
        view,
        """
        [period: The period $@period.symbol$ [derived: is given; the last dwell time is what the
        others leave of it, | , which is the dwell time, is given.]]
        $$
        @derived
        $$
        [dwell: Here @zero: the orbit is a border collision. It reaches @boundaries at one instant
        and stays in @names for no time. That is one condition more than an orbit with @positive has
        to meet, and determines the parameter[many swapped: s] @swapped, unknown in place of @dwell.
        A perturbation for which @dwell would come out negative takes the boundaries in another
        order and follows another itinerary: all derivatives below are one-sided, for @positive.]
        """,
        period=period,
        derived=derived,
        dwell=dwell,
        zero=zeros(view.naming, dwell),
        positive=zeros(view.naming, dwell, " > 0"),
        boundaries=[f"*{b}*" for b in dict.fromkeys(reached)],
        names=[f"*{phases[i].configuration}*" for i in vanishing],
        swapped=swapped,
    )


def _start(view: View) -> list[Block]:
    """Blocks on the set on which the start lies, the unknowns and the parameters."""
    equations, (_, _, start) = view.equations, view.undecided
    dwell = [u for u in equations.unknowns if u in {link.dwell for link in view.links}]
    return compose(
        view,
        r"""
        $@state^{(k)}$ is the state $@column$ behind phase $k$, and $@state^{(0)}$ the start.
        [inside: It lies on the section that the end of the last phase enforces@cited, | The end of
        the last phase enforces a section of dimension @dimension. The start is written in more
        coordinates, and what the section requires of them is among the equations,]
        $$
        @state^{(0)} &= @start.state,
        $$
        with @coordinates, @start.coordinates. [equations.vanishing: The closure will require @zero,
        which leaves @unknowns, @left [dwell: and @dwell]. | [dwell: With the dwell time[many dwell:
        s] @dwell [swapped: and the parameter @swapped] this makes @unknowns.]] The parameters of
        the equations are @equations.parameters. [equations.open_parameters:
        @equations.open_parameters [many equations.open_parameters: do not enter them; they decide |
        does not enter them; it decides] on admissibility alone.]
        """,
        column=_state_column(view.naming),
        inside=start.dimension == equations.chain.section.dimension,
        cited=view.naming.cited("start"),
        dimension=number(equations.chain.section.dimension),
        start=start,
        coordinates=count(start.dimension, "coordinate"),
        zero=zeros(view.naming, equations.vanishing),
        unknowns=count(len(equations.unknowns), "unknown"),
        left=[q for q in start.coordinates if q not in equations.vanishing],
        dwell=dwell,
        swapped=[u for u in equations.unknowns if u not in (*start.coordinates, *dwell)],
    )


def _section(cycle: Cycle) -> list[Block]:
    """Blocks on what maps an orbit to others, and on the set on which its start lies."""
    naming, start = cycle.naming, cycle.start
    return compose(
        cycle,
        r"""
        [reversor: The orbit is sought among those that the reversor @reversor maps to themselves,
        each phase being its own time reversal.]

        $@state^{(k)}$ is the state $@column$ at the end of phase $k$[resets: , in front of the
        transition, $@state^{(k)+}$ behind it,] and $@state^{(0)}$ the start. What the end of the
        last phase enforces, carried through its transition, leaves the start [start.dimension:
        @many, | no freedom,]
        $$
        [start.dimension: @state^{(0)} &= @embedding @letters.coordinates[shifted:  + @base]
            = @start.state
        @letters.coordinates &= @names. | @state^{(0)} &= @written.]
        $$
        [directions: Nothing depends on where along $@letters.directions = @directions$ the motion
        takes place: with a motion $@state(t)$ every $@state(t) + @letters.directions @shift$ is
        one. The orbit returns up to such a shift $@shift$, and @chosen of the start, changed by it,
        may be chosen.]
        """,
        reversor=[
            rf"${naming.notation.symbol(s)} \mapsto {naming.notation.latex(e)}$"
            for s, e in cycle.itinerary.reversor.items()
        ],
        column=_state_column(naming),
        many=count(start.dimension, "coordinate"),
        shifted=not start.constant.is_zero_matrix,
        names=transposed(naming, sp.Matrix(start.coordinates)) if start.dimension else "",
        written=transposed(naming, start.state),
        chosen=count(cycle.directions.cols, "coordinate"),
    )


def _unknowns(cycle: Cycle, solved: Sequence[sp.Symbol]) -> list[Block]:
    """Paragraph that counts the unknowns and names the given parameters."""
    itinerary = cycle.itinerary
    dwell = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    dwell = dwell if itinerary.period is None else dwell[:-1]
    left = cycle.start.dimension - cycle.directions.cols
    parts = {
        count(len(dwell), "dwell time"): dwell,
        f"{count(left, 'coordinate')} of the start": left,
        f"the shift ${cycle.letters.shift}$": cycle.directions.cols,
        f"the parameter{'s' if len(solved) > 1 else ''} {cycle.naming.list(solved)}": solved,
    }
    return compose(
        cycle,
        """
        The unknowns are @parts, @total in all. [given: Given are the parameters @given.]
        """,
        parts=[text for text, some in parts.items() if some],
        total=number(len(dwell) + cycle.start.dimension + len(itinerary.solved_for)),
        given=[p.symbol for p in cycle.system.parameters if p.name not in itinerary.solved_for],
    )
