"""The section of a document on derivatives: Jacobian, Poincaré map, saltation, monodromy."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.sections.template import (
    by_entries,
    compose,
    relation,
    sentence,
)
from nonsmooth.derive.document.view import View
from nonsmooth.derive.document.wording import Naming
from nonsmooth.derive.equations.chain import Link
from nonsmooth.derive.symbols import Symbol, derivative, parts_of_derivative

# LaTeX of what a phase makes of a perturbation on the boundaries, and of a saltation matrix
LOCAL_MAP = r"""
[resets: @reset_{@index} ]\left(I - \frac{@field_{@index} @normal_{@index}}{@normal_{@index}
@field_{@index}}\right) \Phi^{(@phase)}
"""
SALTATION = r"""
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
    symbol, latex = view.naming.notation.symbol, view.naming.notation.latex
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
        coefficient=view.naming.notation.letter("coefficient"),
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
        switching conditions and the section's rows of $[last: R_{@phases} ]U_{@phases} - U_{0}$ for
        the closure. [equations.chain.forcing: Those of the conditions on the forcing are their
        derivatives as they stand.] [swapped: A derivative by @swapped is that of the boundary's
        function itself, since the flows do not contain it.]
        """,
        derived=any(link.duration != link.dwell for link in links),
        single=zeros[0] if len(zeros) == 1 else None,
        resets=_resets(view),
        last=not _is_unit(links[-1]),
        phases=len(links),
        swapped=[u for u in equations.unknowns if str(u) in view.itinerary.solved_for],
    )


def _local_maps(view: View) -> list[Block]:
    """Blocks on the Jacobian of the Poincaré map as a product of local maps."""
    naming, links, chain = view.naming, view.links, view.equations.chain
    resets = _resets(view)
    rates = [
        replace(
            relation(naming, f"{naming.notation.symbol(rate)} = n_{{{k}}} f_{{{k}}}", value),
            subject=rate,
        )
        for k, link in enumerate(links, start=1)
        for rate, value in [(Symbol("rate", k), (link.normal * link.velocity)[0])]
    ]
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
        local maps | that of the local map]@cited,
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
        resets=resets,
        cited=naming.cited("map"),
        letter="L" if chain.forcing else "E",
        local=sentence(view, LOCAL_MAP, resets=resets, index=view.phase, **_LETTERS),
        partial=", $R_{k}$ being $I$ where it is not given,"
        if resets and any(map(_is_unit, links))
        else "",
        directions=chain.forcing and naming.notation.latex(chain.directions),
        returning=chain.forcing and naming.notation.latex(chain.returning(sp.eye(chain.end.rows))),
        fields=_fields(naming, links),
        rates=rates,
        entries=_entries(view),
    )


def _entries(view: View) -> list[Block]:
    """Blocks with the entries of a small map, in the order in which they are computed."""
    equations, naming = view.equations, view.naming
    names = equations.chain.coordinates
    if equations.chain.forcing or not 0 < len(names) <= _LARGEST:
        return []
    stages, matrix = equations.map_program
    first, *others = names
    every = [a for stage in stages for a in stage.assignments]
    columns = {q: [a for a in every if parts_of_derivative(a[0])[1] == q] for q in names}
    shown = set(columns[first])
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
            Line(
                f"J_{{{i + 1}{j + 1}}}" if others else "J",
                "=",
                naming.notation.pieces(matrix[i, j]),
                None,
                matrix[i, j],
            )
            for i in range(len(names))
            for j in range(len(names))
        ],
        first=naming.notation.symbol(first),
        lines=[naming.equal(s, e) for s, e in columns[first]],
    )
    for q in others:
        new = [
            (s, e)
            for s, e in columns[q]
            if (_turned(s, q, first), _turned(e, q, first)) not in shown
        ]
        blocks += compose(
            view,
            """
            Those by $@name$ follow in the same way[new: , but for | .]
            $$
            @new
            $$
            """,
            name=naming.notation.symbol(q),
            new=[naming.equal(s, e) for s, e in new],
        )
    return blocks


def _turned(expression: sp.Expr, coordinate: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    """The expression with derivatives by another coordinate in place of those by one."""
    known = {s: parts_of_derivative(s) for s in expression.free_symbols}
    return expression.xreplace(
        {s: derivative(inner, other) for s, (inner, by) in known.items() if by == coordinate}
    )


def _fields(naming: Naming, links: tuple[Link, ...]) -> list[Line]:
    """Lines with the gradients, vector fields and resets at the ends of the phases."""
    lines: list[Line] = []
    for index, link in enumerate(links, start=1):
        lines.append(relation(naming, f"n_{{{index}}}", link.normal))
        lines += by_entries(naming, f"f_{{{index}}}", link.velocity)
        if not _is_unit(link):
            lines.append(relation(naming, f"R_{{{index}}}", link.reset))
    return lines


def _saltation(view: View) -> list[Block]:
    """Blocks on saltation matrices, the monodromy matrix, and their relation to J."""
    forcing = view.equations.chain.forcing
    # multipliers 1 of every orbit: of time, and of a forcing's invariants
    neutral = 2 * len(forcing.places) if forcing else 1
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
        saltation=sentence(view, SALTATION, at="k", resets=_resets(view), **_LETTERS),
        resets=_resets(view),
        jumps=any(m != k.reset for k, m in zip(view.links, view.saltations, strict=True)),
        matrices=_saltation_matrices(view),
        neutral=neutral,
        phases=neutral > 2,
    )


def _saltation_matrices(view: View) -> list[Line]:
    """Lines with the saltation matrices at the orbit."""
    lines: list[Line] = []
    for k, (link, matrix) in enumerate(zip(view.links, view.saltations, strict=True), start=1):
        if matrix == link.reset and not _is_unit(link):
            lines.append(relation(view.naming, f"S_{{{k}}}", f"R_{{{k}}}"))
        else:
            lines += by_entries(view.naming, f"S_{{{k}}}", matrix)
    return lines


def _is_unit(link: Link) -> bool:
    return bool(link.reset == sp.eye(link.reset.rows))


def _resets(view: View) -> bool:
    return not all(map(_is_unit, view.links))
