"""The sections of a document on derivatives, transitions, stability and admissibility."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.declaration.transition import Condition
from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.notation import enumeration
from nonsmooth.derive.document.template import compose, sentence
from nonsmooth.derive.document.view import Cycle, Passing, View, is_unit
from nonsmooth.derive.equations.energy import is_conservative
from nonsmooth.derive.symbols import Symbol, derivative, parts_of_derivative

# LaTeX of what a phase makes of a perturbation on the boundaries, and of a saltation matrix
_LOCAL_MAP = r"""
[resets: @reset_{@index} ]\left(I - \frac{@field_{@index} @normal_{@index}}{@normal_{@index}
@field_{@index}}\right) \Phi^{(@phase)}
"""
_SALTATION = r"""
[resets: @reset_{@at} | I] + \left(@field_{@at}^{+} - [resets: @reset_{@at} ]@field_{@at}\right)
\frac{@normal_{@at}}{@normal_{@at} @field_{@at}}
"""

_LETTERS = {"reset": "R", "field": "f", "normal": "n"}
_LARGEST = 3  # map of which the entries are written out


def derivative_section(view: View) -> list[Block]:
    """Blocks on the Jacobian, the local maps of the Poincaré map and saltation matrices."""
    return compose(
        view,
        """
        ## The Jacobian of the equations

        @jacobian

        ## The Poincaré map

        @maps

        ## Saltation and monodromy matrices

        @saltation
        """,
        jacobian=_half_jacobian(view) if view.reversible else _chain_rule(view),
        maps=_local_maps(view),
        saltation=_saltation(view),
    )


def _half_jacobian(view: View) -> list[Block]:
    """Paragraph on the derivatives of conditions halfway through phases."""
    symbol, latex = view.notation.symbol, view.notation.latex
    coordinates = view.equations.chain.start.coordinates
    dwell = [u for u in view.equations.unknowns if u not in coordinates]
    return compose(
        view,
        """
        The equations are linear in @coordinates[dwell: , whose columns of the Jacobian hold the
        coefficients. The column of a dwell time holds half the derivative by time of what vanishes
        halfway through its phase. [rates: The last phase enters it too, since the period is given:
        @rates.] | : their Jacobian is the matrix of the coefficients $@coefficient_{ij}$.]
        """,
        coordinates=coordinates,
        dwell=dwell,
        rates=[
            rf"$\partial_{{{symbol(u)}}} {symbol(link.dwell)} = {latex(rate)}$"
            for link in view.links
            for u in dwell
            if link.dwell not in dwell and (rate := sp.diff(link.duration, u)) != 0
        ],
        coefficient=view.notation.letter_for("coefficient"),
    )


def _chain_rule(view: View) -> list[Block]:
    """Blocks on the derivatives of the chain of states by the unknowns."""
    equations, links = view.equations, view.links
    zeros = [k for k, link in enumerate(links, start=1) if link.duration == 0]
    return compose(
        view,
        r"""
        Let $U_{k}$ be the derivatives of $@state^{(k)}$ by the unknowns, $f_{k}$ the vector field
        at the end of phase $k$, $\Phi^{(k)}$ its flow over its dwell time, $n_{k}$ the gradient of
        the boundary on which it ends, $\varepsilon_{k}$ the [derived: row of the derivatives of its
        dwell time by the unknowns | unit row of its dwell time among the unknowns][single:
         ($\varepsilon_{@single} = 0$)][resets: , and $R_{k}$ the matrix of the reset behind it].
        The chain rule gives
        $$
        U_{0} &= \left(E \quad 0\right),
        U_{k} &= \Phi^{(k)} [resets: R_{k-1} ]U_{k-1}
            + f_{k} \varepsilon_{k},
        $$
        $E$ being the derivative of $@state^{(0)}$ by the section's coordinates [resets: and $R_{0}$
        the unit matrix]. The rows of the Jacobian of the equations are $n_{k} U_{k}$ for the
        switching conditions and the section's rows of $[last: R_{@count} ]U_{@count} - U_{0}$ for
        the closure. [equations.chain.forcing: Those of the conditions on the forcing are their
        derivatives as they stand.] [swapped: A derivative by @swapped is that of the boundary's
        function itself, since the flows do not contain it.]
        """,
        derived=any(link.duration != link.dwell for link in links),
        single=zeros[0] if len(zeros) == 1 else None,
        last=not is_unit(links[-1]),
        swapped=[u for u in equations.unknowns if str(u) in view.itinerary.solved_for],
    )


def _local_maps(view: View) -> list[Block]:
    """Blocks on the Jacobian of the Poincaré map as a product of local maps."""
    notation, links, chain = view.notation, view.links, view.equations.chain
    fields: dict[str, sp.Matrix] = {}
    rates: list[Line] = []
    for k, link in enumerate(links, start=1):
        fields |= {f"n_{{{k}}}": link.normal, f"f_{{{k}}}": link.velocity}
        if not is_unit(link):
            fields[f"R_{{{k}}}"] = link.reset
        line = notation.relation(Symbol("rate", k), (link.normal * link.velocity)[0])
        rates.append(replace(line, left=f"{line.left} = n_{{{k}}} f_{{{k}}}"))
    return compose(
        view,
        r"""
        On the boundaries the dwell times follow the perturbation[itinerary.period: , also
        where the period $@itinerary.period.symbol$ is given for the orbit: a perturbed
        motion returns when it does]. Each phase carries a perturbation along and projects it along
        the vector field onto its boundary[reversible: . With $\Phi^{(k)}$ the flow of phase $k$
        over its dwell time, $f_{k}$ the vector field at its end [resets: , | and] $n_{k}$ the
        gradient of the boundary on which it ends [resets: and $R_{k}$ the matrix of the reset
        behind it], | , and] the Jacobian of the Poincaré map is [many links: the product of the
        local maps | that of the local map]@cited(map),
        $$
        J &= @letter^{+} [many links: \left(@product @local\right) | @local] @letter,
        $$
        [equations.chain.forcing: for the coordinates @map_coordinates, of which $L$ holds the
        derivatives of the start and $L^{+}$ takes the changes: the amplitude of the forcing does
        not change, and its cosine and sine move with its phase alone, | where $E^{+}$ takes the
        section's coordinates @equations.chain.section.coordinates of a state, and[reversible:  $E$
        is the derivative by them of a state on the section, | @partial]]
        $$
        [equations.chain.forcing: L &= @directions,
        L^{+} &= @returning | [reversible: @state &= @equations.chain.section.state.]]
        $$
        [equations.chain.forcing: and, at the ends of the phases@partial | [reversible: At the ends
        of the phases@partial]]

        $$
        @fields
        $$
        A boundary is crossed transversally, and the local map is smooth there, only where its rate
        $n_{k} f_{k}$ does not vanish:
        $$
        @rates
        $$
        @entries
        """,
        letter="L" if chain.forcing else "E",
        local=sentence(view, _LOCAL_MAP, index=view.phase, **_LETTERS),
        partial=", $R_{k}$ being $I$ where it is not given,"
        if view.resets and any(map(is_unit, links))
        else "",
        directions=chain.forcing and notation.latex(chain.directions),
        returning=chain.forcing and notation.latex(chain.returning(sp.eye(chain.end.rows))),
        fields=fields,
        rates=rates,
        entries=_entries(view),
    )


def _entries(view: View) -> list[Block]:
    """Blocks with the entries of a small map, in the order in which they are computed."""
    equations, notation = view.equations, view.notation
    names = equations.chain.coordinates
    if equations.chain.forcing or not 0 < len(names) <= _LARGEST:
        return []
    stages, matrix = equations.map_program
    first, *others = names
    every = [a for stage in stages for a in stage.assignments]
    columns = {q: {s: e for s, e in every if parts_of_derivative(s)[1] == q} for q in names}
    blocks = compose(
        view,
        r"""
        Written out, $|_{\Phi}$ marking what the flow carries along, and $|_{\Sigma}$ what arrives
        on the boundary and passes the transition, this is
        $$
        @entries
        $$
        with, phase by phase, the derivatives by $@first$
        $$
        @lines
        $$
        """,
        entries=[
            notation.relation(f"J_{{{i + 1}{j + 1}}}" if others else "J", matrix[i, j], tidy=False)
            for i in range(len(names))
            for j in range(len(names))
        ],
        first=first,
        lines=columns[first],
    )
    for q in others:
        blocks += compose(
            view,
            """
            Those by $@name$ follow in the same way[new: , but for | .]
            $$
            @new
            $$
            """,
            name=q,
            new={
                s: e
                for s, e in columns[q].items()
                if columns[first].get(_turned(s, q, first)) != _turned(e, q, first)
            },
        )
    return blocks


def _turned(expression: sp.Expr, coordinate: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    """The expression with derivatives by another coordinate in place of those by one."""
    known = {s: parts_of_derivative(s) for s in expression.free_symbols}
    return expression.xreplace(
        {s: derivative(inner, other) for s, (inner, by) in known.items() if by == coordinate}
    )


def _saltation(view: View) -> list[Block]:
    """Blocks on saltation matrices, the monodromy matrix, and their relation to J."""
    forcing = view.equations.chain.forcing
    # multipliers 1 of every orbit: of time, and of a forcing's invariants
    neutral = 2 * len(forcing.places) if forcing else 1
    orbit = enumerate(zip(view.links, view.saltations, strict=True), start=1)
    matrices = {
        f"S_{{{k}}}": f"R_{{{k}}}" if matrix == link.reset and not is_unit(link) else matrix
        for k, (link, matrix) in orbit
    }
    return compose(
        view,
        r"""
        Compared at equal times, a perturbation passes a transition otherwise: the perturbed motion
        reaches the boundary earlier or later, and in between only one of the two has changed its
        vector field. To first order the perturbation behind the transition is that in front of it
        times the saltation matrix
        $$
        S_{k} &= @saltation
            = [resets: R_{k} ]\left(I - \frac{f_{k} n_{k}}{n_{k} f_{k}}\right)
            + f_{k}^{+}\, \frac{n_{k}}{n_{k} f_{k}},
        $$
        with the vector field $f_{k}^{+}$ behind the transition. At the orbit [jumps: | $f_{k}^{+} =
        [resets: R_{k} ]f_{k}$, hence]
        $$
        @matrices
        $$
        [many links: The product over a period is the monodromy matrix | Over a period this makes
        the monodromy matrix]
        $$
        \mathcal{M} &= @product S_{@phase} \Phi^{(@phase)},\qquad
            \mathcal{M} f_{0}^{+} = f_{0}^{+},\qquad
            \operatorname{tr} \mathcal{M} = @neutral + \operatorname{tr} J,
        $$
        $f_{0}^{+}$ being the vector field at the start. By the second form of $S_{k}$,
        $\mathcal{M}$ is the product of the local maps plus a matrix whose columns are multiples of
        $f_{0}^{+}$, a vector that the local maps take to zero. So beside the multiplier 1 of
        $f_{0}^{+}$, and zeros, $\mathcal{M}$ has the multipliers of $J$[equations.chain.forcing: ,
        and the multiplier 1 of what no motion changes: the amplitudes of the forcing [phases: and
        the differences of phase]].
        """,
        saltation=sentence(view, _SALTATION, at="k", **_LETTERS),
        jumps=any(m != k.reset for k, m in zip(view.links, view.saltations, strict=True)),
        matrices=matrices,
        neutral=neutral,
        phases=neutral > 2,
    )


def passing_section(cycle: Cycle) -> list[Block]:
    """Blocks with the gradient, fields, reset and saltation matrix of each transition."""
    return compose(
        cycle,
        r"""
        Transition $j$ [distinct: ends phase $j$; it has | has] the gradient $@normal_{j}$ and the
        constant $@constant_{j}$ of its boundary, the vector field $@field_{j}$ of the configuration
        in front of it and $@field_{j}^{+}$ of that behind it[resets: , the matrix $@reset_{j}$ and
        the constant $@jump_{j}$ of its reset (the unit matrix and zero where they are not given)].
        All are written in the state in front of the transition. A perturbed motion reaches the
        boundary earlier or later; to first order its perturbation behind the transition is that in
        front of it times the saltation matrix
        $$
        @letters.saltation_{j} &= @matrix.
        \tag{@label(The transitions 1)}
        $$
        The boundary is crossed transversally, and the matrix is defined, only where the rate
        $@normal_{j} @field_{j}$ is positive.

        @transitions
        """,
        matrix=sentence(cycle, _SALTATION, at="j"),
        transitions=[
            block
            for place, passing in enumerate(cycle.passings, start=1)
            for block in _passing(cycle, place, passing)
        ],
    )


def _passing(cycle: Cycle, place: int, passing: Passing) -> list[Block]:
    """Blocks on one transition."""
    letters = cycle.notation.letters
    field = f"{letters.field}_{{{place}}}"
    matrices = {field: passing.before, f"{field}^{{+}}": passing.behind}
    if passing.resets:
        matrices[f"{letters.reset}_{{{place}}}"] = passing.reset
    if not passing.jump.is_zero_matrix:
        matrices[f"{letters.jump}_{{{place}}}"] = passing.jump
    return compose(
        cycle,
        r"""
        Transition @place, from *@passing.transition.source* by *@passing.boundary* to
        *@passing.transition.target* [distinct: | (behind phase[many phases: s] @phases)]:
        $$
        @normal_{@place} &= @passing.normal
        @constant_{@place} &= @passing.constant
        @matrices
        @normal_{@place} @field_{@place} &= @passing.rate
        @saltation
        $$
        """,
        place=place,
        passing=passing,
        phases=list(map(str, passing.phases)),
        matrices=matrices,
        saltation={f"{letters.saltation}_{{{place}}}": passing.saltation},
    )


def stability_section(cycle: Cycle) -> list[Block]:
    """Blocks with the Poincaré map's Jacobian and the monodromy matrix as products."""
    return compose(
        cycle,
        r"""
        On the section at the start, the dwell times follow a perturbation of the start: each phase
        carries it along and projects it along the vector field onto the boundary. [distinct: | At
        phase $k$ the field $@field_{@index}$ and the matrix $@letters.saltation_{@index}$ are those
        at $@state^{(k)}$.] The Jacobian of the Poincaré map is the product of these local maps, and
        over equal times the monodromy matrix is that of flows and saltation matrices,
        $$
        @jacobian &= @embedding^{+} [product: \left(@product @local\right) | @local] @embedding,
        \mathcal{M} &= @product @letters.saltation_{@index} \Phi^{(@phase)}.
        \tag{@label(Stability 1)}
        $$
        $\mathcal{M}$ takes the vector field at the start, $@matrix @state^{(0)} + @offset$ of the
        first phase, to itself. Beside this multiplier 1, and zeros, it has the multipliers of
        $@jacobian$, and $\operatorname{tr} \mathcal{M} = 1 + \operatorname{tr} @jacobian$. The
        orbit is stable where every multiplier that is not trivial lies inside the unit circle.
        [harmonics: #Trivial of those of $@jacobian$ [many trivial: are | is] 1 and trivial: the
        forcing keeps the amplitude[many trivial: s and phases] of the start. | [conservative: One
        more is 1 and trivial, since the energy is kept along the orbit.]] [directions:
        #Directions.cols more [many directions.cols: are | is] 1 and trivial, since nothing depends
        on a shift: $@jacobian @embedding^{+} @letters.directions = @embedding^{+}
        @letters.directions$.]
        """,
        local=sentence(cycle, _LOCAL_MAP),
        trivial=2 * len(cycle.harmonics) - 1,
        conservative=is_conservative(cycle.itinerary),
    )


def admissibility_section(cycle: Cycle) -> list[Block]:
    """Blocks on admissibility: no boundary is crossed inside a phase.

    A table has the conditions under which each transition is the one that applies.
    """
    itinerary, single = cycle.itinerary, cycle.count == 1
    names = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    dwell = [cycle.notation.symbol(dwell_symbol(name)) for name in names]
    positive = [f"{symbol} > 0" for symbol in dwell]
    return compose(
        cycle,
        r"""
        A solution is a motion of the system if its dwell times are positive, no boundary of a
        phase's configuration is crossed before the phase ends, and each boundary is crossed
        outwards: with the boundary functions $g$ of the configuration of phase $@phase$ and
        $@state(t)$ the motion in it,
        $$
        @positive,\qquad
            g\left(@state(t)\right) < 0 \text{ for } 0 < t < @time,\qquad
            @normal_{@index} @field_{@index} > 0,
        \tag{@label(Admissibility 1)}
        $$
        [single: | $\tau^{(k)}$ being the dwell time of phase $k$.] Where a maximum of $g$ inside a
        phase is zero the orbit grazes, and its itinerary is about to change.

        [conditions: At a transition the first applies whose conditions hold: those of the
        transition itself have to hold, and those of each that is declared before it must not. Where
        a function vanishes, the first of its derivatives along the flow of the named configuration
        that does not vanish decides. | The transitions have no further conditions.]

        | Transition | Required | Along | @conditions
        """,
        positive=r",\; ".join(
            positive if len(positive) <= 3 else [positive[0], r"\ldots", positive[-1]]
        ),
        time=dwell[0] if single else r"\tau^{(k)}",
        single=single,
        conditions=[
            row
            for place, passing in enumerate(cycle.passings, start=1)
            for row in _conditions(cycle, place, passing)
        ],
    )


def _conditions(cycle: Cycle, place: int, passing: Passing) -> list[tuple[str, ...]]:
    """Rows of a table with the conditions that decide for a transition."""
    transition = passing.transition
    required = [_required(cycle, (c,), holds=True) for c in transition.conditions]
    event = transition.source, transition.boundaries
    same = [t for t in cycle.system.transitions if (t.source, t.boundaries) == event]
    # those that are declared before it
    for other in same[: same.index(transition)]:
        distinct = tuple(c for c in other.conditions if c not in transition.conditions)
        if distinct:
            required.append(_required(cycle, distinct, holds=False))
    return [
        ("" if row else f"${place}$", *texts) for row, texts in enumerate(dict.fromkeys(required))
    ]


def _required(cycle: Cycle, conditions: tuple[Condition, ...], *, holds: bool) -> tuple[str, str]:
    """Text of conditions that all have to hold, or of which one must not, and along what."""
    texts = [
        f"{'not ' if c.holds != holds else ''}{cycle.notation.math(c.function, ' > 0')}"
        for c in conditions
    ]
    along = enumeration(list(dict.fromkeys(f"*{c.along}*" for c in conditions)))
    return " or ".join(texts), along
