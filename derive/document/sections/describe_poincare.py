"""The section of a document on derivatives: Jacobian, Poincaré map, saltation, monodromy."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Heading, Line, Paragraph
from nonsmooth.derive.document.layout import LINE_WIDTH
from nonsmooth.derive.document.notation.wording import Naming, enumeration
from nonsmooth.derive.document.sections.describe_itinerary import transposed
from nonsmooth.derive.document.sections.wide_matrices import with_entries
from nonsmooth.derive.document.views.monodromy import saltations
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.chain import Link
from nonsmooth.derive.symbols import Symbol, derivative, parts_of_derivative

__all__ = ["derivative_section"]

_LARGEST = 3  # map of which the entries are written out


def derivative_section(view: View) -> list[Block]:
    """Blocks on the Jacobian, the local maps of the Poincaré map and saltation matrices."""
    return [
        Heading("The Jacobian of the equations", 2),
        *(_half_jacobian(view) if view.reversible else _chain_rule(view)),
        Heading("The Poincaré map", 2),
        *_local_maps(view),
        Heading("Saltation and monodromy matrices", 2),
        *_saltation(view),
    ]


def _half_jacobian(view: View) -> list[Block]:
    """Paragraph on the derivatives of conditions halfway through phases."""
    naming, equations = view.naming, view.equations
    coordinates = equations.chain.start.coordinates
    dwell_times = [u for u in equations.unknowns if u not in coordinates]
    text = (
        f"The equations are linear in {naming.list(coordinates)}, whose columns of the Jacobian"
        " hold the coefficients."
    )
    if not dwell_times:
        names = naming.list(coordinates)
        matrix = f"${naming.notation.letter('coefficient')}_{{ij}}$"
        return [
            Paragraph(
                f"The equations are linear in {names}: their Jacobian is the matrix of the"
                f" coefficients {matrix}."
            )
        ]
    text += (
        " The column of a dwell time holds half the derivative by time of what vanishes halfway"
        " through its phase."
    )
    rates = [
        rf"$\partial_{{{naming.notation.symbol(u)}}} {naming.notation.symbol(link.dwell)} ="
        rf" {naming.notation.latex(sp.diff(link.duration, u))}$"
        for link in view.links
        for u in dwell_times
        if link.dwell not in dwell_times and sp.diff(link.duration, u) != 0
    ]
    text += (
        f" The last phase enters it too, since the period is given: {enumeration(rates)}."
        if rates
        else ""
    )
    return [Paragraph(text)]


def _chain_rule(view: View) -> list[Block]:
    """Blocks on the derivatives of the chain of states by the unknowns."""
    naming, equations = view.naming, view.equations
    state, links = naming.state, view.links
    jump, delay = "R_{k-1} " if _resets(view) else "", r"f_{k} \varepsilon_{k}"
    swapped = [u for u in equations.unknowns if str(u) in equations.itinerary.solved_for]
    derived = any(link.duration != link.dwell for link in links)
    row = (
        r"$\varepsilon_{k}$ the row of the derivatives of its dwell time by the unknowns"
        if derived
        else r"$\varepsilon_{k}$ the unit row of its dwell time among the unknowns"
    )
    zeros = [str(k) for k, link in enumerate(links, start=1) if link.duration == 0]
    row += rf" ($\varepsilon_{{{zeros[0]}}} = 0$)" if len(zeros) == 1 else ""
    reset = ", and $R_{k}$ the matrix of the reset behind it" if _resets(view) else ""
    by_parameter = (
        f" A derivative by {naming.list(swapped)} is that of the boundary's function itself, since"
        " the flows do not contain it."
        if swapped
        else ""
    )
    by_forcing = (
        " Those of the conditions on the forcing are their derivatives as they stand."
        if equations.chain.forcing
        else ""
    )
    last = "" if _is_unit(links[-1]) else f"R_{{{len(links)}}} "
    unit = " and $R_{0}$ the unit matrix" if _resets(view) else ""
    return [
        Paragraph(
            f"Let $U_{{k}}$ be the derivatives of ${state}^{{(k)}}$ by the unknowns, $f_{{k}}$ the"
            " vector field at the end of phase $k$, $\\Phi^{(k)}$ its flow over its dwell time,"
            f" $n_{{k}}$ the gradient of the boundary on which it ends, {row}{reset}. The chain"
            " rule gives"
        ),
        Formula(
            (
                Line("U_{0}", "=", (r"\left(E \quad 0\right),",)),
                Line("U_{k}", "=", (rf"\Phi^{{(k)}} {jump}U_{{k-1}}", rf"+ {delay},")),
            )
        ),
        Paragraph(
            f"$E$ being the derivative of ${state}^{{(0)}}$ by the section's coordinates{unit}. The"
            " rows of the Jacobian of the equations are $n_{k} U_{k}$ for the switching conditions"
            f" and the section's rows of ${last}U_{{{len(links)}}} - U_{{0}}$ for the closure."
            f"{by_forcing}{by_parameter}"
        ),
    ]


def _local_maps(view: View) -> list[Block]:
    """Blocks on the Jacobian of the Poincaré map as a product of local maps."""
    naming, links, section = view.naming, view.links, view.equations.chain.section
    resets, period = _resets(view), view.equations.itinerary.period
    maps = "the product of the local maps" if len(links) > 1 else "that of the local map"
    maps += naming.cited("map")
    unit = ", $R_{k}$ being $I$ where it is not given," if any(map(_is_unit, links)) else ""
    text = "On the boundaries the dwell times follow the perturbation"
    text += (
        f", also where the period ${naming.notation.symbol(period.symbol)}$ is given for the"
        " orbit: a perturbed motion returns when it does. "
        if period
        else ". "
    )
    text += (
        "Each phase carries a perturbation along and projects it along the vector field onto its"
        " boundary"
    )
    if view.reversible:
        text += (
            r". With $\Phi^{(k)}$ the flow of phase $k$ over its dwell time, $f_{k}$ the vector"
            " field at its end"
            + (", " if resets else " and ")
            + "$n_{k}$ the gradient of the boundary on which it ends"
            + (" and $R_{k}$ the matrix of the reset behind it," if resets else ",")
            + f" the Jacobian of the Poincaré map is {maps},"
        )
    else:
        text += f", and the Jacobian of the Poincaré map is {maps},"
    k = _index(view)
    jump = f"R_{{{k}}} " if resets else ""
    local = (
        rf"{jump}\left(I - \frac{{f_{{{k}}} n_{{{k}}}}}{{n_{{{k}}} f_{{{k}}}}}\right)"
        rf" \Phi^{{({k})}}"
    )
    chain = view.equations.chain
    letter = "L" if chain.forcing else "E"
    product = rf"{letter}^{{+}} {local} {letter},"
    if len(links) > 1:
        product = rf"{letter}^{{+}} \left({_product(view)} {local}\right) {letter},"
    blocks: list[Block] = [Paragraph(text), Formula((Line("J", "=", (product,)),))]
    where = f"where $E^{{+}}$ takes the section's coordinates {naming.list(section.coordinates)}"
    where += " of a state, and"
    if chain.forcing:
        where = (
            f"for the coordinates {view.map_coordinates}, of which ${letter}$ holds the"
            f" derivatives of the start and ${letter}^{{+}}$ takes the changes: the amplitude of"
            " the forcing does not change, and its cosine and sine move with its phase alone,"
        )
        lines = [
            Line(letter, "=", (f"{naming.notation.latex(chain.directions)},",)),
            Line(rf"{letter}^{{+}}", "=", (naming.notation.latex(_returning(view)),)),
        ]
        blocks += [Paragraph(where), Formula(tuple(lines))]
        where = "and, at the ends of the phases"
        where += unit if resets else ""
    elif view.reversible:
        where += " $E$ is the derivative by them of a state on the section,"
        on_section = transposed(naming, section.state)
        line = Line(naming.state, "=", (f"{on_section}.",), None, sp.ImmutableMatrix(section.state))
        blocks += [Paragraph(where), Formula((line,))]
        where = "At the ends of the phases"
        where += unit if resets else ""
    elif resets:
        where += unit
    rates = [(link.normal * link.velocity)[0] for link in links]
    speeds = [Symbol("rate", k) for k in range(1, len(links) + 1)]
    pieces = [naming.notation.pieces(naming.notation.tidy(rate)) for rate in rates]
    return [
        *blocks,
        Paragraph(where),
        *_fields(naming, links),
        Paragraph(
            "A boundary is crossed transversally, and the local map is smooth there, only where"
            " its rate $n_{k} f_{k}$ does not vanish:"
        ),
        Formula(
            tuple(
                Line(f"{naming.notation.symbol(s)} = n_{{{k}}} f_{{{k}}}", "=", shown, s, rate)
                for k, (s, shown, rate) in enumerate(zip(speeds, pieces, rates, strict=True), 1)
            )
        ),
        *_entries(view),
    ]


def _entries(view: View) -> list[Block]:
    """Blocks with the entries of a small map, in the order in which they are computed."""
    equations, notation = view.equations, view.naming.notation
    names = equations.chain.coordinates
    if equations.chain.forcing or not 0 < len(names) <= _LARGEST:
        return []
    stages, matrix = equations.map_program
    entries = [
        Line(
            f"J_{{{i + 1}{j + 1}}}" if len(names) > 1 else "J",
            "=",
            notation.pieces(matrix[i, j]),
            None,
            matrix[i, j],
        )
        for i in range(len(names))
        for j in range(len(names))
    ]
    first, *others = names
    every = [a for stage in stages for a in stage.assignments]
    columns = {q: [a for a in every if parts_of_derivative(a[0])[1] == q] for q in names}
    shown = set(columns[first])
    blocks: list[Block] = [
        Paragraph(
            r"Written out, $|_{\Phi}$ marking what the flow carries along, and $|_{\Sigma}$ what"
            " arrives on the boundary and passes the transition, this is"
        ),
        Formula(tuple(entries)),
        Paragraph(f"with, phase by phase, the derivatives by ${notation.symbol(first)}$"),
        Formula(tuple(view.naming.equal(s, e) for s, e in columns[first])),
    ]
    for q in others:
        new = [
            (s, e)
            for s, e in columns[q]
            if (_turned(s, q, first), _turned(e, q, first)) not in shown
        ]
        text = f"Those by ${notation.symbol(q)}$ follow in the same way"
        blocks.append(Paragraph(f"{text}, but for" if new else f"{text}."))
        blocks += [Formula(tuple(view.naming.equal(s, e) for s, e in new))] if new else []
    return blocks


def _turned(expression: sp.Expr, coordinate: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    """The expression with derivatives by another coordinate in place of those by one."""
    known = {s: parts_of_derivative(s) for s in expression.free_symbols}
    return expression.xreplace(
        {s: derivative(inner, other) for s, (inner, by) in known.items() if by == coordinate}
    )


def _fields(naming: Naming, links: tuple[Link, ...]) -> list[Block]:
    """Blocks with the gradients, vector fields and resets at the ends of the phases."""
    lines: list[Line] = []
    entries: list[Line] = []
    resets: list[tuple[str, str]] = []
    for index, link in enumerate(links, start=1):
        n, f = f"n_{{{index}}}", f"f_{{{index}}}"
        row = link.velocity.T.applyfunc(naming.notation.tidy)
        shown, named = with_entries(naming, f, row, LINE_WIDTH - 8)
        normal = Line(
            n, "=", (naming.notation.latex(link.normal),), None, sp.ImmutableMatrix(link.normal)
        )
        field = Line(
            f, "=", (rf"{shown}^{{\mathsf{{T}}}}",), None, sp.ImmutableMatrix(link.velocity)
        )
        beside = (rf"{normal.pieces[0]},\qquad", field.latex)
        lines.append(Line(n, "=", beside, parts=(normal, field)))
        entries += named
        if not _is_unit(link):
            resets.append((f"R_{{{index}}}", _matrix(naming, link.reset)))
    if resets:
        (first, matrix), *others = resets
        pieces = [matrix, *(f"{name} = {shown}" for name, shown in others)]
        pieces = [*(rf"{piece},\qquad" for piece in pieces[:-1]), pieces[-1]]
        lines.append(Line(first, "=", tuple(pieces)))
    return [Formula(tuple(lines)), *_with(entries)]


def _with(entries: list[Line]) -> list[Block]:
    """Blocks with the entries of matrices that are written with names for entries."""
    return [Paragraph("with the entries"), Formula(tuple(entries))] if entries else []


def _saltation(view: View) -> list[Block]:
    """Blocks on saltation matrices, the monodromy matrix, and their relation to J."""
    resets = _resets(view)
    jump, carried = ("R_{k}", "R_{k} f_{k}") if resets else ("I", "f_{k}")
    k, factor = _index(view), r"\frac{n_{k}}{n_{k} f_{k}}"
    definition = (
        rf"{jump} + \left(f_{{k}}^{{+}} - {carried}\right) {factor}",
        rf"= {'R_{k} ' if resets else ''}"
        rf"\left(I - \frac{{f_{{k}} n_{{k}}}}{{n_{{k}} f_{{k}}}}\right)"
        rf" + f_{{k}}^{{+}}\, {factor},",
    )
    product = (
        rf"{_product(view)} S_{{{k}}} \Phi^{{({k})}},\qquad",
        r"\mathcal{M} f_{0}^{+} = f_{0}^{+},\qquad",
        rf"\operatorname{{tr}} \mathcal{{M}} = {_neutral(view)} + \operatorname{{tr}} J,",
    )
    jumps = any(m != link.reset for link, m in zip(view.links, saltations(view), strict=True))
    at_orbit = "At the orbit" if jumps else f"At the orbit $f_{{k}}^{{+}} = {carried}$, hence"
    return [
        Paragraph(
            "Compared at equal times, a perturbation passes a transition otherwise: the perturbed"
            " motion reaches the boundary earlier or later, and in between only one of the two"
            " has changed its vector field. To first order the perturbation behind the transition"
            " is that in front of it times the saltation matrix"
        ),
        Formula((Line("S_{k}", "=", definition),)),
        Paragraph(f"with the vector field $f_{{k}}^{{+}}$ behind the transition. {at_orbit}"),
        *_saltation_matrices(view),
        Paragraph(
            "The product over a period is the monodromy matrix"
            if len(view.links) > 1
            else "Over a period this makes the monodromy matrix"
        ),
        Formula((Line(r"\mathcal{M}", "=", product),)),
        Paragraph(
            "$f_{0}^{+}$ being the vector field at the start. By the second form of $S_{k}$,"
            r" $\mathcal{M}$ is the product of the local maps plus a matrix whose columns are"
            " multiples of $f_{0}^{+}$, a vector that the local maps take to zero. So beside the"
            r" multiplier 1 of $f_{0}^{+}$, and zeros, $\mathcal{M}$ has the multipliers of $J$"
            f"{_beside(view)}."
        ),
    ]


def _saltation_matrices(view: View) -> list[Block]:
    """Blocks with the saltation matrices at the orbit; mere resets share a line."""
    lines: list[Line] = []
    entries: list[Line] = []
    found = list(enumerate(zip(view.links, saltations(view), strict=True), start=1))
    for k, (link, matrix) in found:
        if matrix != link.reset:
            name = f"S_{{{k}}}"
            shown, named = with_entries(view.naming, name, matrix, LINE_WIDTH - 4)
            lines.append(Line("", "", (f"{name} = {shown},",), None, matrix))
            entries += named
    plain = [
        f"S_{{{k}}} = {'I' if _is_unit(link) else f'R_{{{k}}}'}"
        for k, (link, matrix) in found
        if matrix == link.reset
    ]
    if plain:
        lines.append(Line("", "", (*(rf"{t},\qquad" for t in plain[:-1]), f"{plain[-1]},")))
    if not entries:
        return [Formula((*lines[:-1], _ended(lines[-1], ".")))]
    listed = [_ended(entry, ",") for entry in entries[:-1]] + [_ended(entries[-1], ".")]
    return [Formula(tuple(lines)), *_with(listed)]


def _ended(line: Line, mark: str) -> Line:
    """The line with a mark at its end, in place of a comma there."""
    *others, last = line.pieces
    return replace(line, pieces=(*others, f"{last.removesuffix(',')}{mark}"))


def _returning(view: View) -> sp.Matrix:
    """Matrix from changes of the last state to changes of the Poincaré map's coordinates."""
    chain = view.equations.chain
    return chain.returning(sp.eye(chain.end.rows))


def _neutral(view: View) -> int:
    """Number of multipliers 1 of every orbit: of time, and of a forcing's invariants."""
    forcing = view.equations.chain.forcing
    return 2 * len(forcing.places) if forcing else 1


def _beside(view: View) -> str:
    """Text on the multipliers 1 of a forcing's invariants."""
    if view.equations.chain.forcing is None:
        return ""
    return ", and the multiplier 1 of what no motion changes: the amplitudes of the forcing" + (
        " and the differences of phase" if _neutral(view) > 2 else ""
    )


def _index(view: View) -> str:
    """Index of the factors in a product over the phases: k, or 1 if there is only one phase."""
    return "k" if len(view.links) > 1 else "1"


def _product(view: View) -> str:
    """LaTeX of the sign of such a product, the first phase on the right."""
    return rf"\prod_{{k={len(view.links)}}}^{{1}}" if len(view.links) > 1 else ""


def _is_unit(link: Link) -> bool:
    return bool(link.reset == sp.eye(link.reset.rows))


def _resets(view: View) -> bool:
    return not all(map(_is_unit, view.links))


def _matrix(naming: Naming, matrix: sp.Matrix) -> str:
    if matrix.is_diagonal():
        entries = ", ".join(naming.notation.latex(e) for e in matrix.diagonal())
        return rf"\operatorname{{diag}}({entries})"
    return naming.notation.latex(matrix)
