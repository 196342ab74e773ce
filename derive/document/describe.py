"""Documents of systems and orbits, made of the derivation's own objects.

`describe_system` and `describe_orbit` give a `Document`; the modules beside this one write it
as LaTeX, Markdown or HTML. Every formula of an orbit is printed from an expression that the
kernels compute, and keeps that expression beside its LaTeX.
"""

from __future__ import annotations

from nonsmooth.derive.document.blocks import (
    Block,
    Document,
    Formula,
    Heading,
    Line,
    Paragraph,
    Table,
)
from nonsmooth.derive.document.describe_orbit import (
    chain_section,
    derivative_section,
    equation_section,
    functions_of,
    itinerary_section,
    symmetry_section,
)
from nonsmooth.derive.document.describe_reduction import reduction_section, trace_section
from nonsmooth.derive.document.describe_system import (
    configuration_section,
    modal_section,
    system_section,
)
from nonsmooth.derive.document.describe_transitions import transition_section
from nonsmooth.derive.document.symbols import Notation
from nonsmooth.derive.document.wording import Naming, enumeration
from nonsmooth.derive.equations import EquationSystem
from nonsmooth.derive.modal import derive_flows
from nonsmooth.derive.system import System

__all__ = [
    "Block",
    "Document",
    "Formula",
    "Heading",
    "Line",
    "Paragraph",
    "Table",
    "describe_orbit",
    "describe_system",
]


def describe_system(system: System) -> Document:
    """Describe a system with all its configurations, flows and transitions."""
    spectrum, flows = derive_flows(system)
    constants = tuple(p.symbol for p in system.parameters) + spectrum.symbols
    naming = Naming(Notation(system.states, constants), system)
    names = [c.name for c in system.configurations]
    modal, _ = modal_section(naming, spectrum, flows, names)
    blocks: list[Block] = [
        Heading("The system"),
        *system_section(naming, None),
        Heading("Configurations"),
        *configuration_section(naming, names, {}),
        Heading("Modal analysis"),
        *modal,
    ]
    if system.transitions:
        blocks += [Heading("Transitions"), *transition_section(naming)]
    return Document(f"The system {system.name}", tuple(blocks))


def describe_orbit(equations: EquationSystem) -> Document:
    """Describe the whole derivation of a periodic orbit, from the declaration to the trace."""
    itinerary, system = equations.itinerary, equations.system
    presentation = itinerary.presentation
    states = presentation.states if presentation else ()
    known = (*itinerary.system.parameters, *(presentation.parameters if presentation else ()))
    constants = tuple(p.symbol for p in known) + equations.spectrum.symbols
    notation = Notation(
        (*system.states, *(s for s in itinerary.system.states if s not in states)),
        constants,
        functions_of(equations),
        equations.unknowns,
    )
    naming = Naming(notation, system)
    places: dict[str, list[str]] = {}
    for number, phase in enumerate(itinerary.phases, start=1):
        places.setdefault(phase.configuration, []).append(str(number))
    remarks = {
        name: f" (phase{'s' if len(found) > 1 else ''} {enumeration(found)})"
        for name, found in places.items()
    }
    modal, numbers = modal_section(naming, equations.spectrum, equations.flows, list(places))
    blocks: list[Block] = [
        Heading("The system"),
        *system_section(naming, itinerary),
        Heading("Configurations"),
        *configuration_section(naming, list(places), remarks),
        Heading("Modal analysis"),
        *modal,
        Heading("The itinerary"),
        *itinerary_section(naming, equations, numbers),
        Heading("The chain of states"),
        *chain_section(naming, equations, numbers),
        Heading("The equations"),
        *equation_section(naming, equations),
        Heading("Derivatives and the Poincaré map"),
        *derivative_section(naming, equations, numbers),
        Heading("The reduction"),
        *reduction_section(naming, equations),
        Heading("The trace"),
        *trace_section(naming, equations),
    ]
    if itinerary.reversor:
        place = blocks.index(Heading("The chain of states"))
        blocks[place:place] = [Heading("The symmetry"), *symmetry_section(naming, equations)]
    title = f"The orbit {itinerary.name} of the system {itinerary.system.name}"
    return Document(title, tuple(blocks))
