"""The sections of a document that concern an orbit: from the itinerary to the trace."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.wording import Naming, count, enumeration, numbered
from nonsmooth.derive.equations import EquationSystem
from nonsmooth.derive.symmetry import halfway
from nonsmooth.derive.system import TIME

__all__ = [
    "chain_section",
    "derivative_section",
    "equation_section",
    "functions_of",
    "itinerary_section",
    "symmetry_section",
]


def functions_of(equations: EquationSystem) -> dict[sp.Symbol, sp.Expr]:
    """Symbols that stand for values of functions of time, and those values."""
    found = {
        value: function.subs(TIME, link.dwell)
        for link in equations.chain.links
        for function, value in zip(link.flow.basis, link.functions, strict=True)
        if value.is_Symbol and value != link.dwell
    }
    if equations.itinerary.reversor:
        assigned = dict(a for stage in equations.stages for a in stage.assignments)
        halves = {halfway(link.dwell): link.dwell / 2 for link in equations.chain.links}
        halved = {s: e.subs(halves) for s, e in assigned.items() if set(halves) & e.free_symbols}
        found |= halves | halved
    return found


def itinerary_section(
    naming: Naming, equations: EquationSystem, numbers: Mapping[str, int]
) -> list[Block]:
    """Phases, the section at the start, and the unknowns."""
    notation, system, itinerary = naming.notation, naming.system, equations.itinerary
    rows = []
    for index, (phase, link) in enumerate(
        zip(itinerary.phases, equations.chain.links, strict=True), start=1
    ):
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        dwell = notation.symbol(link.dwell)
        rows.append(
            (
                str(index),
                f"*{phase.configuration}*",
                f"${dwell}$",
                rf"$\Phi_{{{numbers[phase.configuration]}}}({dwell})$",
                f"*{phase.boundary}*",
                f"${notation.latex(notation.tidy(boundary.function))} = 0$",
            )
        )
    chain, state = equations.chain, naming.state
    start = chain.start
    names = rf"\left({', '.join(notation.symbol(s) for s in system.states)}\right)"
    shown = notation.latex(start.state.T.applyfunc(notation.tidy))
    dwell_times = [u for u in equations.unknowns if u in {link.dwell for link in chain.links}]
    swapped = equations.unknowns[start.dimension + len(dwell_times) :]
    opened = (
        f" {naming.list(equations.open_parameters)} do not enter them; they decide on"
        " admissibility alone."
        if equations.open_parameters
        else ""
    )
    derived = [
        f"${notation.symbol(link.dwell)} = {notation.latex(link.duration)}$"
        for link in chain.links
        if link.duration not in (link.dwell, 0)
    ]
    at_once = [link.dwell for link in chain.links if link.duration == 0]
    remarks = []
    if itinerary.period is not None:
        period = notation.symbol(itinerary.period.symbol)
        remarks.append(f" The period ${period}$ is given{', hence ' if derived else ''}")
        remarks[-1] += f"{enumeration(derived)}."
    if at_once:
        zero = enumeration([f"${notation.symbol(dwell)} = 0$" for dwell in at_once])
        remarks.append(
            f" Here {zero}: two boundaries are reached at one instant (border collision), which"
            f" determines {naming.list(swapped)}. Derivatives of the Poincaré map are one-sided,"
            f" those for {naming.list(at_once)} from above."
        )
    unknown = f"{count(start.dimension, 'coordinate')}, {naming.list(start.coordinates)}."
    if dwell_times:
        unknown += f" With the dwell time{'' if len(dwell_times) == 1 else 's'}"
        unknown += f" {naming.list(dwell_times)}"
        unknown += f" and {naming.list(swapped)}" if swapped else ""
        unknown += f" this makes {count(len(equations.unknowns), 'unknown')}."
    return [
        Paragraph(
            f"The orbit has {count(len(rows), 'phase')} to a period. Each phase stays in one"
            f" configuration for its dwell time and ends on one boundary.{''.join(remarks)}"
        ),
        Table(("Phase", "Configuration", "Dwell time", "Flow", "Left by", "Where"), tuple(rows)),
        Paragraph(
            f"${state}^{{(k)}}$ is the state ${names}^{{\\mathsf{{T}}}}$ behind phase $k$. The"
            " start lies on the section that the end of the last phase enforces,"
        ),
        Formula(
            (
                Line(
                    f"{state}^{{(0)}}",
                    "=",
                    (rf"{shown}^{{\mathsf{{T}}}},",),
                    None,
                    start.state,
                ),
            )
        ),
        Paragraph(
            f"with {unknown} The parameters of the equations are"
            f" {naming.list(equations.parameters)}.{opened}"
        ),
    ]


def chain_section(
    naming: Naming, equations: EquationSystem, numbers: Mapping[str, int]
) -> list[Block]:
    """Follow the states behind the phases, one by one."""
    state, system, itinerary = naming.state, naming.system, equations.itinerary
    count = len(equations.chain.links)
    arrows = r" \;\to\; ".join(f"{state}^{{({k})}}" for k in range(count + 1))
    assigned = dict(a for s in equations.chain.stages for a in s.assignments)
    blocks: list[Block] = [
        Paragraph(f"The flows carry the start through the phases, ${arrows}$."),
    ]
    for index, (phase, link) in enumerate(
        zip(itinerary.phases, equations.chain.links, strict=True), start=1
    ):
        dwell = naming.notation.symbol(link.dwell)
        flow = rf"\Phi_{{{numbers[phase.configuration]}}}({dwell})"
        blocks.append(
            Paragraph(f"Phase {index}, *{phase.configuration}* for ${dwell}$ with ${flow}$:")
        )
        lines = []
        for symbol, value in zip(system.states, link.after, strict=True):
            named = sp.Symbol(f"{symbol}_{index}", real=True)
            lines.append(naming.equal(named, assigned.get(value, value)))
        blocks.append(Formula(tuple(lines)))
        transition = itinerary.transition_after(system, index - 1)
        reset = tuple(naming.equal(s, e) for s, e in transition.reset.items())
        if reset:
            rules = enumeration([f"${line.latex}$" for line in reset])
            blocks.append(Paragraph(f"The transition to *{transition.target}* sets {rules}."))
    return blocks


def symmetry_section(naming: Naming, equations: EquationSystem) -> list[Block]:
    """State the reversor, and what the closure of a reversible orbit leaves."""
    notation, state = naming.notation, naming.state
    turned = [naming.equal(s, e) for s, e in equations.itinerary.reversor.items()]
    kept = [s for s in naming.system.states if s not in equations.itinerary.reversor]
    images = enumeration([rf"$R\,{line.latex}$" for line in turned])
    blocks: list[Block] = [
        Paragraph(
            f"The map $R$ with {images} that keeps {naming.list(kept)} is a reversor of every"
            f" configuration of the orbit: with ${state}(t)$ also $R\\,{state}(-t)$ is a motion."
            f" A phase that is on the set of its fixed points, $R\\,{state} = {state}$, halfway"
            f" through, ends at the image of its start, ${state}(\\tau) = R\\,{state}(0)$. The"
            " conditions halfway replace the closure, which would contain each of them twice."
        )
    ]
    lines = [f"${notation.symbol(q)} = 0$" for q in equations.vanishing]
    lines += [f"${notation.symbol(p)} = {sp.latex(v)}$" for p, v in equations.required.items()]
    if lines:
        blocks.append(
            Paragraph(
                f"What the transitions leave of the closure requires {enumeration(lines)}:"
                " without that there is no such orbit. Both are inserted."
                if len(lines) > 1
                else f"What the transitions leave of the closure requires {lines[0]}."
            )
        )
    return blocks


def equation_section(naming: Naming, equations: EquationSystem) -> list[Block]:
    """Number the switching and periodicity equations."""
    counted = (
        f" {count(len(equations.equations), 'equation')} for"
        f" {count(len(equations.unknowns), 'unknown')}:"
    )
    if equations.itinerary.reversor:
        lead = "The conditions halfway through the phases, and those on the start, make" + counted
    else:
        lead = (
            "The switching condition of each phase and the closure of each of the start's own"
            f" coordinates make{counted}"
        )
    return [Paragraph(lead), *numbered(naming, equations.equations, "")]


def derivative_section(
    naming: Naming, equations: EquationSystem, numbers: Mapping[str, int]
) -> list[Block]:
    """Chain rule for the Jacobian, local maps of the Poincare map."""
    state, notation, links = naming.state, naming.notation, equations.chain.links
    resets = any(link.reset != sp.eye(link.reset.rows) for link in links)
    jump = "R_{k-1} " if resets else ""
    blocks: list[Block] = [
        Paragraph(
            f"Let $S_{{k}}$ be the derivatives of ${state}^{{(k)}}$ by the unknowns, $f_{{k}}$ the"
            " vector field at the end of phase $k$, $\\Phi^{(k)}$ its flow over its dwell time,"
            " $n_{k}$ the gradient of the boundary on which it ends, $e_{k}$ the unit vector of its"
            " dwell time among the unknowns"
            + (", and $R_{k}$ the matrix of the reset behind it" if resets else "")
            + ". The chain rule gives"
        ),
        Formula(
            (
                Line("S_{0}", "=", (r"\left(E \quad 0\right),",)),
                Line(
                    "S_{k}",
                    "=",
                    (rf"\Phi^{{(k)}} {jump}S_{{k-1}} + f_{{k}}\, e_{{k}}^{{\mathsf{{T}}}},",),
                ),
            )
        ),
        Paragraph(
            f"$E$ being the derivative of ${state}^{{(0)}}$ by the section's coordinates and"
            + (" $R_{0}$ the unit matrix." if resets else ".")
            + " The rows of the Jacobian of the equations are $n_{k} S_{k}$ for the switching"
            " conditions and the section's rows of"
            f" ${'R_{p} ' if resets else ''}S_{{p}} - S_{{0}}$ for the closure,"
            f" $p = {len(links)}$."
        ),
        Paragraph(
            "On the boundaries the dwell times follow the perturbation. Each phase projects it"
            " along the vector field onto its boundary, and the Jacobian of the Poincaré map is"
            " the product of the local maps,"
        ),
        Formula(
            (
                Line(
                    "J",
                    "=",
                    (
                        rf"E^{{+}} \left(\prod_{{k=p}}^{{1}} {'R_{k} ' if resets else ''}"
                        r"\left(I - \frac{f_{k} n_{k}}{n_{k} f_{k}}\right) \Phi^{(k)}\right) E,",
                    ),
                ),
            )
        ),
        Paragraph(
            "where $E^{+}$ takes the section's coordinates of a state, and, $R_{k}$ being $I$ where"
            " it is not given,"
            if resets
            else "where $E^{+}$ takes the section's coordinates of a state, and"
        ),
    ]
    lines = []
    for index, link in enumerate(links, start=1):
        normal = notation.latex(link.normal)
        field = notation.latex(link.velocity.T.applyfunc(notation.tidy))
        pieces = [rf"{normal},\qquad", rf"f_{{{index}}} = {field}^{{\mathsf{{T}}}}"]
        if link.reset != sp.eye(link.reset.rows):
            pieces[-1] += r",\qquad"
            pieces.append(f"R_{{{index}}} = {_reset(naming, link.reset)}")
        lines.append(Line(f"n_{{{index}}}", "=", tuple(pieces)))
    blocks.append(Formula(tuple(lines)))
    rates = [
        Line(
            f"n_{{{k}}} f_{{{k}}}",
            "=",
            notation.pieces(notation.tidy((link.normal * link.velocity)[0])),
            None,
            (link.normal * link.velocity)[0],
        )
        for k, link in enumerate(links, start=1)
    ]
    blocks += [
        Paragraph(
            "The boundaries are crossed transversally, and the equations are nonsingular there,"
            " only where none of these rates vanishes:"
        ),
        Formula(tuple(rates)),
    ]
    return blocks


def _reset(naming: Naming, matrix: sp.Matrix) -> str:
    if matrix.is_diagonal():
        entries = ", ".join(naming.notation.latex(e) for e in matrix.diagonal())
        return rf"\operatorname{{diag}}({entries})"
    return naming.notation.latex(matrix)
