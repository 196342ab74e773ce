"""The sections of a document that concern an orbit: from the itinerary to the trace."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from nonsmooth.derive.chain import Chain
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.wording import Naming, count, enumeration, numbered
from nonsmooth.derive.equations import EquationSystem
from nonsmooth.derive.system import TIME

__all__ = [
    "chain_section",
    "derivative_section",
    "equation_section",
    "functions_of",
    "itinerary_section",
]


def functions_of(chain: Chain) -> dict[sp.Symbol, sp.Expr]:
    """Symbols of the chain that stand for values of functions of time, and those values."""
    return {
        value: function.subs(TIME, link.dwell)
        for link in chain.links
        for function, value in zip(link.flow.basis, link.functions, strict=True)
        if value.is_Symbol and value != link.dwell
    }


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
    section, state = equations.chain.section, naming.state
    names = rf"\left({', '.join(notation.symbol(s) for s in system.states)}\right)"
    start = notation.latex(section.start.T.applyfunc(notation.tidy))
    dwell_times = equations.unknowns[section.dimension :]
    opened = (
        f" {naming.list(equations.open_parameters)} do not enter them; they decide on"
        " admissibility alone."
        if equations.open_parameters
        else ""
    )
    return [
        Paragraph(
            f"The orbit has {count(len(rows), 'phase')} to a period. Each phase stays in one"
            " configuration for its dwell time and ends on one boundary:"
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
                    (rf"{start}^{{\mathsf{{T}}}},",),
                    None,
                    section.start,
                ),
            )
        ),
        Paragraph(
            f"with {count(section.dimension, 'coordinate')}, {naming.list(section.coordinates)}."
            f" With the dwell time{'' if len(dwell_times) == 1 else 's'}"
            f" {naming.list(dwell_times)} this makes"
            f" {count(len(equations.unknowns), 'unknown')}. The parameters of the equations are"
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


def equation_section(naming: Naming, equations: EquationSystem) -> list[Block]:
    """Number the switching and periodicity equations."""
    lead = Paragraph(
        "The switching condition of each phase and the closure of each of the section's own"
        f" coordinates make {count(len(equations.equations), 'equation')} for"
        f" {count(len(equations.unknowns), 'unknown')}:"
    )
    return [lead, *numbered(naming, equations.equations, "")]


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
