"""Documents of systems and orbits, made of the derivation's own objects.

`describe_system`, `describe_orbit` and `describe_itinerary` give a `Document`; the modules beside
this one write it as LaTeX, Markdown or HTML. Every formula of a derived orbit is printed from an
expression that the kernels compute, and keeps that expression beside its LaTeX.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from typing import Any

from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.unfolding import unfolded
from nonsmooth.derive.document.blocks import (
    Block,
    Document,
    Formula,
    Heading,
    Line,
    Paragraph,
    Table,
)
from nonsmooth.derive.document.notation.letters import letters_of
from nonsmooth.derive.document.notation.responses import is_response
from nonsmooth.derive.document.notation.symbols import Notation
from nonsmooth.derive.document.notation.wording import Naming, enumeration
from nonsmooth.derive.document.sections.describe_admissible import admissibility_section
from nonsmooth.derive.document.sections.describe_contacts import (
    constraint_paragraphs,
    contact_section,
)
from nonsmooth.derive.document.sections.describe_cycle import elimination_section, phase_section
from nonsmooth.derive.document.sections.describe_cycle import equation_section as cycle_equations
from nonsmooth.derive.document.sections.describe_energy import energy_section
from nonsmooth.derive.document.sections.describe_itinerary import itinerary_section
from nonsmooth.derive.document.sections.describe_law import law_section
from nonsmooth.derive.document.sections.describe_orbit import chain_section, equation_section
from nonsmooth.derive.document.sections.describe_passings import passing_section, stability_section
from nonsmooth.derive.document.sections.describe_period_map import TITLE as PERIOD_MAP
from nonsmooth.derive.document.sections.describe_period_map import period_map_section
from nonsmooth.derive.document.sections.describe_poincare import derivative_section
from nonsmooth.derive.document.sections.describe_reduction import reduction_section
from nonsmooth.derive.document.sections.describe_reference import reference_section
from nonsmooth.derive.document.sections.describe_solution import solution_section
from nonsmooth.derive.document.sections.describe_symmetry import symmetry_section
from nonsmooth.derive.document.sections.describe_system import (
    configuration_section,
    flow_section,
    modal_section,
    model_section,
    system_section,
)
from nonsmooth.derive.document.sections.describe_trace import trace_section
from nonsmooth.derive.document.sections.describe_transitions import transition_section
from nonsmooth.derive.document.views.centres import Centres, name_centres
from nonsmooth.derive.document.views.closed_forms import closed_flows
from nonsmooth.derive.document.views.cycle import Cycle
from nonsmooth.derive.document.views.view import View, view_of
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.reference import reference_orbit
from nonsmooth.derive.equations.section import start_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow, Spectrum

__all__ = [
    "Block",
    "Document",
    "Formula",
    "Heading",
    "Line",
    "Paragraph",
    "Table",
    "describe_itinerary",
    "describe_orbit",
    "describe_system",
]


def describe_system(system: System) -> Document:
    """The document of a system, with all its configurations, flows and transitions.

    For flows without a closed form in the parameters it says how they are computed.
    """
    names = [c.name for c in system.configurations]
    spectrum, flows = closed_flows(system, names)
    constants = tuple(p.symbol for p in system.parameters) + spectrum.symbols
    notation = Notation(system.states, constants).with_responses(flows.values())
    centres = name_centres(flows.values(), map(notation.symbol, (*constants, *system.states)))
    naming = Naming(notation.with_names(centres.names), system)
    complete = len(flows) == len(names) and not any(map(is_response, flows.values()))
    configurations = configuration_section(naming, names, {})
    if not complete:
        configurations += constraint_paragraphs(naming, names)
    sections: list[tuple[str, list[Block]]] = [
        ("The system", system_section(naming, None)),
        *([("The model", model_section(naming, system))] if system.model else []),
        ("Configurations", configurations),
        ("Modal analysis", flow_section(naming, spectrum, flows, names, centres)[0]),
    ]
    if system.transitions:
        sections.append(("Transitions", transition_section(naming)))
    if system.law is not None:
        sections.append(("Contact law", law_section(naming, system.law)))
    if system.contacts and not complete:
        sections.append(("Contacts", contact_section(naming)))
    return _document(f"The system {system.name}", sections)


def describe_orbit(orbit: EquationSystem | Itinerary) -> Document:
    """The document of a periodic orbit's whole derivation, from the declaration to the trace.

    An itinerary for which no equations are derived is described by `describe_itinerary`.
    """
    if isinstance(orbit, Itinerary):
        return describe_itinerary(orbit)
    equations, itinerary = orbit, orbit.itinerary
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
    chain = ("The chain of states", chain_section)
    derivatives = ("Derivatives and the Poincaré map", derivative_section)
    equation = ("The equations", equation_section)
    sections: list[tuple[str, Callable[[Any], list[Block]]]] = [
        ("The system", lambda _: system_section(naming, itinerary, equations.required)),
        *_model(naming, itinerary.system),
        ("Configurations", lambda _: configuration_section(naming, list(places), remarks)),
        ("Modal analysis", lambda _: modal),
        ("The itinerary", itinerary_section),
    ]
    if equations.itinerary.reversor:
        # conditions halfway need no chain
        symmetry, solution = ("The symmetry", symmetry_section), ("The reduction", solution_section)
        sections += [symmetry, equation, solution, chain, derivatives]
    else:
        sections += [chain, equation, derivatives, ("The reduction", reduction_section)]
    if equations.conservative:
        sections.append(("The energy", energy_section))
    sections.append(("The trace", trace_section))
    with suppress(DerivationError):  # an orbit may have no such map
        _ = equations.period_map
        sections.append((PERIOD_MAP, period_map_section))
    known = reference_orbit(equations)
    if known is not None:
        sections.append(("The reference orbit", lambda view: reference_section(view, known)))
    view = View(equations, naming, centres, numbers, _places(sections))
    title = f"The orbit {itinerary.name} of the system {itinerary.system.name}"
    return _document(title, [(heading, blocks_of(view)) for heading, blocks_of in sections])


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
    naming, centres = naming_of(itinerary, spectrum, flows)
    modal, numbers = flow_section(naming, spectrum, flows, names, centres)
    taken = (*naming.notation.constants, *naming.notation.states, *naming.notation.unknowns)
    configurations = configuration_section(naming, names, {})
    configurations += constraint_paragraphs(naming, names)
    sections: list[tuple[str, Callable[[Any], list[Block]]]] = [
        ("The system", lambda _: system_section(naming, itinerary)),
        *_model(naming, itinerary.system),
        ("Configurations", lambda _: configurations),
        ("Modal analysis", lambda _: modal),
        ("The itinerary", phase_section),
        ("The equations", cycle_equations),
        ("The reduction", elimination_section),
        ("The transitions", passing_section),
        ("Stability", stability_section),
        ("Admissibility", admissibility_section),
    ]
    cycle = Cycle(itinerary, naming, letters_of(naming, taken), numbers, _places(sections))
    title = f"The itinerary {itinerary.name} of the system {itinerary.system.name}"
    return _document(title, [(heading, blocks_of(cycle)) for heading, blocks_of in sections])


def _model(naming: Naming, system: System) -> list[tuple[str, Callable[[Any], list[Block]]]]:
    """The section on the model, if the system declares one."""
    return [("The model", lambda _: model_section(naming, system))] if system.model else []


def _places(sections: Iterable[tuple[str, object]]) -> dict[str, int]:
    """Number of each section by its title."""
    return {title: number for number, (title, _) in enumerate(sections, start=1)}


def _document(title: str, sections: Iterable[tuple[str, Iterable[Block]]]) -> Document:
    """A document of sections, numbered in their order."""
    blocks: list[Block] = []
    for number, (heading, found) in enumerate(sections, start=1):
        blocks += [Heading(heading, number=number), *found]
    return Document(title, tuple(blocks))


def naming_of(
    itinerary: Itinerary, spectrum: Spectrum, flows: Mapping[str, Flow]
) -> tuple[Naming, Centres]:
    """Notation of an itinerary's document, and the centres that have a letter in it."""
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
    ).with_responses(flows.values())
    taken = (*constants, *states, *notation.unknowns)
    centres = name_centres(flows.values(), map(notation.symbol, taken))
    return Naming(notation.with_names(centres.names), system, itinerary.source), centres
