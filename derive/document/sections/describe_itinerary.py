"""The section of a document on an orbit's itinerary: phases, dwell times, start, unknowns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Phase, dwell_symbol
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.notation.wording import Naming, count, enumeration, number
from nonsmooth.derive.document.views.view import View

__all__ = ["itinerary_section", "source_letters", "start_line", "transposed"]


def itinerary_section(view: View) -> list[Block]:
    """Blocks on the phases, given dwell times, the section at the start and the unknowns."""
    return [
        *_phases(view),
        *source_letters(view.naming, view.numbers),
        *_dwell_times(view),
        *_start(view),
        *_unknowns(view),
    ]


def start_line(naming: Naming, state: sp.Matrix) -> Line:
    """Line that shows the start in terms of its coordinates."""
    shown = transposed(naming, state)
    return Line(f"{naming.state}^{{(0)}}", "=", (f"{shown},",), None, sp.ImmutableMatrix(state))


def transposed(naming: Naming, column: sp.Matrix) -> str:
    """LaTeX of a column, written as a transposed row; a single entry is written alone."""
    notation = naming.notation
    if column.rows == 1:
        return notation.latex(notation.tidy(column[0]))
    return rf"{notation.latex(column.T.applyfunc(notation.tidy))}^{{\mathsf{{T}}}}"


def phase_sentence(many: int) -> str:
    """Sentences on how many phases an orbit has, and what a phase is."""
    return f"The orbit has {count(many, 'phase')} to a period. " + (
        "It stays in one configuration for its dwell time and ends on one boundary, from which"
        " the transition leads back to the start."
        if many == 1
        else "Each phase stays in one configuration for its dwell time and ends on one boundary."
    )


def boundary_at(naming: Naming, phase: Phase) -> str:
    """Formula for the boundary at which a phase is left."""
    boundary = naming.system.configuration(phase.configuration).boundary(phase.boundary)
    return f"${naming.notation.latex(naming.notation.tidy(boundary.function))} = 0$"


def phase_table(
    naming: Naming,
    numbers: Mapping[str, int],
    phases: Sequence[Phase],
    last: str,
    entries: Sequence[str],
) -> Table:
    """Table of the phases, with a last column of the given heading and entries."""
    rows = []
    for index, (phase, entry) in enumerate(zip(phases, entries, strict=True), start=1):
        dwell = naming.notation.symbol(dwell_symbol(phase.dwell_time))
        rows.append(
            (
                str(index),
                f"*{phase.configuration}*",
                f"${dwell}$",
                rf"$\Phi_{{{numbers[phase.configuration]}}}({dwell})$",
                f"*{phase.boundary}*",
                entry,
            )
        )
    return Table(("Phase", "Configuration", "Dwell time", "Flow", "Left by", last), tuple(rows))


def source_letters(naming: Naming, numbers: Mapping[str, int]) -> list[Block]:
    """Paragraph on the letters of the source for flows, states and the section."""
    source = naming.source
    if source is None or not (source.flows or source.states or source.section):
        return []
    parts = [rf"$\Phi_{{{numbers[name]}}}$ is ${letter}$" for name, letter in source.flows.items()]
    parts += [f"${naming.state}^{{({k})}}$ is ${name}$" for k, name in enumerate(source.states)]
    parts += [f"the section is ${source.section}$"] if source.section else []
    return [Paragraph(f"In {source.name} {enumeration(parts)}.")]


def _phases(view: View) -> list[Block]:
    naming, phases = view.naming, view.equations.itinerary.phases
    places = [boundary_at(naming, phase) for phase in phases]
    return [
        Paragraph(phase_sentence(len(phases))),
        phase_table(naming, view.numbers, phases, "Where", places),
    ]


def _dwell_times(view: View) -> list[Block]:
    """Blocks on a given period and the dwell time that follows, and on vanishing dwell times."""
    naming, itinerary = view.naming, view.equations.itinerary
    notation = naming.notation
    blocks: list[Block] = []
    derived = [link for link in view.links if link.duration not in (link.dwell, 0)]
    if itinerary.period is not None:
        period = f"${notation.symbol(itinerary.period.symbol)}$"
        if not derived:
            blocks.append(Paragraph(f"The period {period}, which is the dwell time, is given."))
        for link in derived:
            blocks += [
                Paragraph(
                    f"The period {period} is given; the last dwell time is what the others leave"
                    " of it,"
                ),
                Formula((naming.equal(link.dwell, link.duration),)),
            ]
    at_once = [link.dwell for link in view.links if link.duration == 0]
    if at_once:
        where = _positive(naming, at_once)
        swapped = [s for s in view.equations.unknowns if str(s) in itinerary.solved_for]
        zero = enumeration([f"${notation.symbol(dwell)} = 0$" for dwell in at_once])
        names = enumeration([f"*{itinerary.phases[i].configuration}*" for i in _vanishing(view)])
        plural = "s" if len(swapped) > 1 else ""
        blocks.append(
            Paragraph(
                f"Here {zero}: the orbit is a border collision. It reaches {_collision(view)} at"
                f" one instant and stays in {names} for no time. That is one condition more than"
                f" an orbit with {where} has to meet, and determines the"
                f" parameter{plural} {naming.list(swapped)}, unknown in place of"
                f" {naming.list(at_once)}. A perturbation for which {naming.list(at_once)} would"
                " come out negative takes the boundaries in another order and follows another"
                f" itinerary: all derivatives below are one-sided, for {where}."
            )
        )
    return blocks


def _vanishing(view: View) -> list[int]:
    return [i for i, link in enumerate(view.links) if link.duration == 0]


def _positive(naming: Naming, dwell_times: list[sp.Symbol]) -> str:
    return enumeration([f"${naming.notation.symbol(dwell)} > 0$" for dwell in dwell_times])


def _collision(view: View) -> str:
    """Names of the boundaries that are reached together before and by each vanishing phase."""
    phases = view.equations.itinerary.phases
    reached = [phases[j].boundary for i in _vanishing(view) for j in (i - 1, i)]
    return enumeration([f"*{b}*" for b in dict.fromkeys(reached)])


def _start(view: View) -> list[Block]:
    """Blocks on the set on which the start lies."""
    naming, equations = view.naming, view.equations
    notation, state = naming.notation, naming.state
    names = rf"\left({', '.join(notation.symbol(s) for s in naming.system.states)}\right)"
    intro = (
        f"${state}^{{(k)}}$ is the state ${names}^{{\\mathsf{{T}}}}$ behind phase $k$, and"
        f" ${state}^{{(0)}}$ the start."
    )
    _, _, start = view.undecided
    section = equations.chain.section
    if start.dimension == section.dimension:
        cited = naming.cited("start")
        text = f"{intro} It lies on the section that the end of the last phase enforces{cited},"
    else:
        text = (
            f"{intro} The end of the last phase enforces a section of dimension"
            f" {number(section.dimension)}. The start is written in more coordinates, and what the"
            " section requires of them is among the equations,"
        )
    return [Paragraph(text), Formula((start_line(naming, start.state),))]


def _unknowns(view: View) -> list[Block]:
    """Paragraph that counts the unknowns and names the parameters."""
    naming, equations = view.naming, view.equations
    _, _, start = view.undecided
    dwell_times = [u for u in equations.unknowns if u in {link.dwell for link in view.links}]
    swapped = [u for u in equations.unknowns if u not in (*start.coordinates, *dwell_times)]
    text = f"with {count(start.dimension, 'coordinate')}, {naming.list(start.coordinates)}."
    if equations.vanishing:
        left = [q for q in start.coordinates if q not in equations.vanishing]
        zero = enumeration([f"${naming.notation.symbol(q)} = 0$" for q in equations.vanishing])
        text += (
            f" The closure will require {zero}, which leaves"
            f" {count(len(equations.unknowns), 'unknown')}, {naming.list(left)}"
        )
        text += f" and {naming.list(dwell_times)}." if dwell_times else "."
    elif dwell_times:
        text += f" With the dwell time{'' if len(dwell_times) == 1 else 's'}"
        text += f" {naming.list(dwell_times)}"
        text += f" and the parameter {naming.list(swapped)}" if swapped else ""
        text += f" this makes {count(len(equations.unknowns), 'unknown')}."
    text += f" The parameters of the equations are {naming.list(equations.parameters)}."
    if equations.open_parameters:
        one = len(equations.open_parameters) == 1
        text += f" {naming.list(equations.open_parameters)} "
        text += "does not enter them; it decides" if one else "do not enter them; they decide"
        text += " on admissibility alone."
    return [Paragraph(text)]
