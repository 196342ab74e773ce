"""Documents of systems and orbits, made of the derivation's own objects.

`describe_system`, `describe_orbit` and `describe_itinerary` give a `Document`; the modules beside
this one write it as LaTeX, Markdown or HTML. Every formula of a derived orbit is printed from an
expression that the kernels compute, and keeps that expression beside its LaTeX.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.symmetry import unfolded
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import Block, Document, Formula, Heading
from nonsmooth.derive.document.cycle import Cycle
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.sections.derivatives import derivative_section
from nonsmooth.derive.document.sections.equations import (
    chain_section,
    cycle_equations,
    equation_section,
    symmetry_section,
)
from nonsmooth.derive.document.sections.flows import flow_section
from nonsmooth.derive.document.sections.itinerary import itinerary_section, phase_section
from nonsmooth.derive.document.sections.motion import configuration_section
from nonsmooth.derive.document.sections.period_map import PERIOD_MAP, period_map_section
from nonsmooth.derive.document.sections.reduction import (
    elimination_section,
    reduction_section,
    solution_section,
)
from nonsmooth.derive.document.sections.system import (
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
from nonsmooth.derive.document.sections.transitions import (
    admissibility_section,
    passing_section,
    stability_section,
)
from nonsmooth.derive.document.symbols import is_response
from nonsmooth.derive.document.view import View, naming_of
from nonsmooth.derive.document.wording import Naming, enumeration, letters_of
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.reference import reference_orbit
from nonsmooth.derive.equations.section import start_of
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
    spectrum, flows = closed_flows(system, names)
    constants = tuple(p.symbol for p in system.parameters) + spectrum.symbols
    notation = Notation(system.states, constants, flows=tuple(flows.values()))
    naming = Naming(notation, system)
    complete = len(flows) == len(names) and not any(map(is_response, flows.values()))
    modal, _ = flow_section(naming, spectrum, flows, names)
    law = system.law
    return _document(
        f"The system {system.name}",
        {
            **_opening(naming, system),
            "Configurations": lambda _: configuration_section(
                naming, names, constrained=not complete
            ),
            "Modal analysis": lambda _: modal,
            "Transitions": transition_section if system.transitions else None,
            "Contact law": (lambda _: law_section(naming, law)) if law else None,
            "Contacts": contact_section if system.contacts and not complete else None,
        },
        lambda _: naming,
    )


def describe_orbit(orbit: EquationSystem | Itinerary) -> Document:
    """The document of a periodic orbit's whole derivation, from the declaration to the trace.

    An itinerary for which no equations are derived is described by `describe_itinerary`.
    """
    if isinstance(orbit, Itinerary):
        return describe_itinerary(orbit)
    equations, itinerary = orbit, orbit.itinerary
    naming = naming_of(equations)
    places: dict[str, list[str]] = {}
    for number, phase in enumerate(itinerary.phases, start=1):
        places.setdefault(phase.configuration, []).append(str(number))
    remarks = {
        name: f" (phase{'s' if len(found) > 1 else ''} {enumeration(found)})"
        for name, found in places.items()
    }
    names = list(places)
    modal, numbers = flow_section(naming, equations.spectrum, equations.flows, names)
    known = reference_orbit(equations)
    turn = None
    with suppress(DerivationError):  # an orbit may have no such map
        turn = equations.period_map
    chain: _Sections = {"The chain of states": chain_section}
    equation: _Sections = {"The equations": equation_section}
    derivatives: _Sections = {"Derivatives and the Poincaré map": derivative_section}
    # conditions halfway need no chain
    middle: _Sections = (
        {"The symmetry": symmetry_section}
        | equation
        | {"The reduction": solution_section}
        | chain
        | derivatives
        if itinerary.reversor
        else chain | equation | derivatives | {"The reduction": reduction_section}
    )
    return _document(
        f"The orbit {itinerary.name} of the system {itinerary.system.name}",
        {
            **_opening(naming, itinerary.system, itinerary, equations.required),
            "Configurations": lambda _: configuration_section(naming, names, remarks),
            "Modal analysis": lambda _: modal,
            "The itinerary": itinerary_section,
            **middle,
            "The energy": energy_section if equations.conservative else None,
            "The trace": trace_section,
            PERIOD_MAP: period_map_section if turn else None,
            "The reference orbit": (lambda view: reference_section(view, known)) if known else None,
        },
        lambda numbered: View(itinerary, naming, numbers, numbered, equations),
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
    names = list(dict.fromkeys(p.configuration for p in itinerary.phases))
    spectrum, flows = closed_flows(itinerary.presented_system, names)
    naming = itinerary_naming(itinerary, spectrum, flows)
    notation = naming.notation
    modal, numbers = flow_section(naming, spectrum, flows, names)
    letters = letters_of(naming, (*notation.constants, *notation.states, *notation.unknowns))
    return _document(
        f"The itinerary {itinerary.name} of the system {itinerary.system.name}",
        {
            **_opening(naming, itinerary.system, itinerary),
            "Configurations": lambda _: configuration_section(naming, names, constrained=True),
            "Modal analysis": lambda _: modal,
            "The itinerary": phase_section,
            "The equations": cycle_equations,
            "The reduction": elimination_section,
            "The transitions": passing_section,
            "Stability": stability_section,
            "Admissibility": admissibility_section,
        },
        lambda numbered: Cycle(itinerary, naming, numbers, numbered, letters),
    )


def _opening(
    naming: Naming,
    system: System,
    itinerary: Itinerary | None = None,
    required: Iterable[sp.Symbol] = (),
) -> _Sections:
    """The sections with which all documents begin."""
    return {
        "The system": lambda _: system_section(naming, itinerary, required),
        "The model": (lambda _: model_section(naming, system)) if system.model else None,
    }


def _document(
    title: str, sections: _Sections, shown_by: Callable[[dict[str, int]], object]
) -> Document:
    """A document of sections, numbered in their order.

    `shown_by` takes the number of each section by its title and gives what they show.
    """
    kept = {heading: blocks_of for heading, blocks_of in sections.items() if blocks_of}
    places = {heading: number for number, heading in enumerate(kept, start=1)}
    shown = shown_by(places)
    blocks: list[Block] = []
    for heading, blocks_of in kept.items():
        blocks += [Heading(heading, number=places[heading]), *blocks_of(shown)]
    return Document(title, tuple(blocks), shown)


def itinerary_naming(itinerary: Itinerary, spectrum: Spectrum, flows: Mapping[str, Flow]) -> Naming:
    """Notation of an itinerary's document."""
    system = itinerary.presented_system
    parameters = [p.symbol for p in (*system.parameters, *itinerary.system.parameters)]
    constants = (*dict.fromkeys(parameters), *spectrum.symbols)
    states = tuple(dict.fromkeys((*system.states, *itinerary.system.states)))
    section = start_of(itinerary)
    dwell_times = tuple(dwell_symbol(p.dwell_time) for p in itinerary.phases)
    notation = Notation(
        states,
        constants,
        unknowns=(*section.coordinates, *dwell_times),
        start=dict(zip(section.coordinates, section.places, strict=True)),
        flows=tuple(flows.values()),
    )
    return Naming(notation, system, itinerary.source)


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
    return naming_of(orbit).notation.latex(expression)
