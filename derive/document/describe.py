"""Documents of systems and orbits, made of the derivation's own objects.

`describe_system`, `describe_orbit` and `describe_itinerary` give a `Document`; the modules beside
this one write it as LaTeX, Markdown or HTML. Every formula of a derived orbit is printed from an
expression that the kernels compute, and keeps that expression beside its LaTeX.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.symmetry import unfolded
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import Block, Document, Formula, Heading
from nonsmooth.derive.document.sections.derivatives import (
    admissibility_section,
    derivative_section,
    passing_section,
    stability_section,
)
from nonsmooth.derive.document.sections.equations import (
    chain_section,
    cycle_equations,
    equation_section,
    itinerary_section,
    phase_section,
    symmetry_section,
)
from nonsmooth.derive.document.sections.flows import flow_section
from nonsmooth.derive.document.sections.reduction import (
    PERIOD_MAP,
    elimination_section,
    period_map_section,
    reduction_section,
    solution_section,
)
from nonsmooth.derive.document.sections.system import (
    configuration_section,
    contact_section,
    law_section,
    model_section,
    system_section,
    transition_section,
)
from nonsmooth.derive.document.sections.trace import (
    energy_section,
    reference_section,
    trace_section,
)
from nonsmooth.derive.document.view import (
    Cycle,
    Described,
    View,
    itinerary_notation,
    notation_of,
    system_notation,
)
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.reference import reference_orbit
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow, Spectrum, derive_flows

__all__ = [
    "Document",
    "describe_itinerary",
    "describe_orbit",
    "describe_system",
    "equation_latex",
    "equation_lines",
    "expression_latex",
]

# by title: what gives the blocks of a section on what the document shows; None for no section
_Sections = dict[str, Callable[[Any], list[Block]] | None]


def describe_system(system: System) -> Document:
    """The document of a system, with all its configurations, flows and transitions.

    For flows without a closed form in the parameters it says how they are computed.
    """
    names = [c.name for c in system.configurations]
    notation = system_notation(system, names, *closed_flows(system, names))
    return _document(
        f"The system {system.name}",
        Described(notation, {}, None),
        {
            "Transitions": transition_section if system.transitions else None,
            "Contact law": law_section if system.law else None,
            "Contacts": contact_section if system.contacts and notation.open else None,
        },
    )


def describe_orbit(orbit: EquationSystem | Itinerary) -> Document:
    """The document of a periodic orbit's whole derivation, from the declaration to the trace.

    An itinerary for which no equations are derived is described by `describe_itinerary`.
    """
    if isinstance(orbit, Itinerary):
        return describe_itinerary(orbit)
    equations, itinerary = orbit, orbit.itinerary
    notation, known = notation_of(equations), reference_orbit(equations)
    turn = None
    with suppress(DerivationError):  # an orbit may have no such map
        turn = equations.period_map
    middle: _Sections = {
        "The chain of states": chain_section,
        "The equations": equation_section,
        "Derivatives and the Poincaré map": derivative_section,
        "The reduction": reduction_section,
    }
    if itinerary.reversor:  # conditions halfway need no chain
        middle = {
            "The symmetry": symmetry_section,
            "The equations": equation_section,
            "The reduction": solution_section,
            "The chain of states": chain_section,
            "Derivatives and the Poincaré map": derivative_section,
        }
    return _document(
        f"The orbit {itinerary.name} of the system {itinerary.system.name}",
        View(notation, {}, itinerary, equations),
        {
            "The itinerary": itinerary_section,
            **middle,
            "The energy": energy_section if equations.conservative else None,
            "The trace": trace_section,
            PERIOD_MAP: period_map_section if turn else None,
            "The reference orbit": (lambda view: reference_section(view, known)) if known else None,
        },
    )


def describe_itinerary(itinerary: Itinerary) -> Document:
    """The document of an orbit for which no equations are derived.

    The equations are a chain of flows and resets, which hold for any flow; what depends on
    the declaration alone (boundaries, vector fields, resets, saltation matrices) is written
    out. Equal transitions are described once. An orbit that is declared by a part and a
    symmetry is described whole. DerivationError says that no state satisfies what the end
    of the last phase enforces.
    """
    itinerary = unfolded(itinerary)
    names = dict.fromkeys(p.configuration for p in itinerary.phases)
    notation = itinerary_notation(itinerary, *closed_flows(itinerary.presented_system, names))
    return _document(
        f"The itinerary {itinerary.name} of the system {itinerary.system.name}",
        Cycle(notation, {}, itinerary),
        {
            "The itinerary": phase_section,
            "The equations": cycle_equations,
            "The reduction": elimination_section,
            "The transitions": passing_section,
            "Stability": stability_section,
            "Admissibility": admissibility_section,
        },
    )


def _document(title: str, shown: Described, sections: _Sections) -> Document:
    """A document of the sections with which all begin and of further ones, numbered in order."""
    opening: _Sections = {
        "The system": system_section,
        "The model": model_section if shown.declared.model else None,
        "Configurations": configuration_section,
        "Modal analysis": flow_section,
    }
    every = (opening | sections).items()
    kept = {heading: blocks_of for heading, blocks_of in every if blocks_of}
    places = {heading: number for number, heading in enumerate(kept, start=1)}
    shown = replace(shown, places=places)
    blocks: list[Block] = []
    for heading, blocks_of in kept.items():
        blocks += [Heading(heading, number=places[heading]), *blocks_of(shown)]
    return Document(title, tuple(blocks), shown)


def closed_flows(system: System, names: Iterable[str]) -> tuple[Spectrum, dict[str, Flow]]:
    """Spectrum and flows by name of those named configurations that have a closed form."""
    motions = [Configuration(n, system.configuration(n).dynamics, ()) for n in names]
    whole = _flows(system, motions)
    if whole is not None:
        return whole
    closed = [motion for motion in motions if _flows(system, [motion])]
    return (closed and _flows(system, closed)) or (Spectrum(), {})


def _flows(
    system: System, motions: Iterable[Configuration]
) -> tuple[Spectrum, dict[str, Flow]] | None:
    """Spectrum and flows of a system of some motions alone; None if one has no closed form."""
    alone = replace(system, configurations=tuple(motions), transitions=(), contacts=())
    try:
        return derive_flows(alone)
    except DerivationError:
        return None


def equation_lines(orbit: EquationSystem) -> list[tuple[str, str]]:
    """LaTeX and meaning of each equation, as the orbit's document has them."""
    blocks = describe_orbit(orbit).section("The equations")
    return [(b.lines[0].latex, b.note or "") for b in blocks if isinstance(b, Formula)]


def equation_latex(lines: Sequence[tuple[str, str]]) -> str:
    """LaTeX of equations, aligned at their signs, each with its meaning beside it."""
    rows = [f"& {latex} && \\text{{{note.replace('*', '')}}}" for latex, note in lines]
    body = " \\\\\n".join(rows)
    return f"$$\\begin{{aligned}}\n{body}\n\\end{{aligned}}$$"


def expression_latex(orbit: EquationSystem, expression: Any) -> str:
    """LaTeX of an expression or a matrix in the orbit's symbols, as its document writes it."""
    return notation_of(orbit).latex(expression)
