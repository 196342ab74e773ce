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
from nonsmooth.derive.document.centres import name_centres
from nonsmooth.derive.document.describe_energy import energy_section
from nonsmooth.derive.document.describe_itinerary import itinerary_section
from nonsmooth.derive.document.describe_orbit import chain_section, equation_section
from nonsmooth.derive.document.describe_poincare import derivative_section
from nonsmooth.derive.document.describe_reduction import reduction_section
from nonsmooth.derive.document.describe_solution import solution_section
from nonsmooth.derive.document.describe_symmetry import symmetry_section
from nonsmooth.derive.document.describe_system import (
    configuration_section,
    modal_section,
    system_section,
)
from nonsmooth.derive.document.describe_trace import trace_section
from nonsmooth.derive.document.describe_transitions import transition_section
from nonsmooth.derive.document.symbols import Notation
from nonsmooth.derive.document.view import View, view_of
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
    notation = Notation(system.states, constants)
    centres = name_centres(flows.values(), map(notation.symbol, (*constants, *system.states)))
    naming = Naming(notation.with_names(centres.names), system)
    names = [c.name for c in system.configurations]
    # letters for the coordinates of one centre; of many the columns are shown
    shown = centres if len(centres.columns) == 1 else None
    modal, _ = modal_section(naming, spectrum, flows, names, shown)
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
    itinerary = equations.itinerary
    naming, centres = view_of(equations)
    places: dict[str, list[str]] = {}
    for number, phase in enumerate(itinerary.phases, start=1):
        places.setdefault(phase.configuration, []).append(str(number))
    remarks = {
        name: f" (phase{'s' if len(found) > 1 else ''} {enumeration(found)})"
        for name, found in places.items()
    }
    modal, numbers = modal_section(
        naming, equations.spectrum, equations.flows, list(places), centres
    )
    view = View(equations, naming, centres, numbers)
    sections: list[tuple[str, list[Block]]] = [
        ("The system", system_section(naming, itinerary, equations.required)),
        ("Configurations", configuration_section(naming, list(places), remarks)),
        ("Modal analysis", modal),
        ("The itinerary", itinerary_section(view)),
    ]
    chain = ("The chain of states", chain_section(view))
    derivatives = ("Derivatives and the Poincaré map", derivative_section(view))
    equation = ("The equations", equation_section(view))
    if view.reversible:
        # conditions halfway need no chain
        sections += [
            ("The symmetry", symmetry_section(view)),
            equation,
            ("The reduction", solution_section(view)),
            chain,
            derivatives,
        ]
    else:
        sections += [chain, equation, derivatives, ("The reduction", reduction_section(view))]
    if equations.conservative:
        sections.append(("The energy", energy_section(view)))
    sections.append(("The trace", trace_section(view)))
    blocks = [b for title, found in sections for b in (Heading(title), *found)]
    title = f"The orbit {itinerary.name} of the system {itinerary.system.name}"
    return Document(title, tuple(blocks))
