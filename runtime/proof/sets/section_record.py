"""How records name a section of motions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.registry import Certified
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels, known_system
from nonsmooth.runtime.model.saved_system import KeptSystemName, check_same_system
from nonsmooth.runtime.proof.certificate import Declaration
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import MapSection, Way

__all__ = [
    "SectionRecord",
    "check_same_section",
    "named_way",
    "reached_text",
    "section_entries",
    "stated_section",
]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class SectionRecord(Certified):
    """A record of a section's map, at one parameter point.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All of the system, exactly.
    configuration : str
        In which states on the section are; empty where nothing is claimed.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    declaration : dict
        The system, as functions of its parameters, as in the file; empty where nothing is
        claimed.
    """

    system: KeptSystemName
    parameters: Mapping[str, Value]
    configuration: str
    phase: tuple[Exact, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    declaration: Declaration = field(repr=False)


def section_entries(record: SectionRecord, *more: str) -> dict[str, Any]:
    """Return the section of a record, and other attributes, as entries of a file.

    They are data that the checker and other processes take.
    """
    names = "configuration", "phase", "source", "boundary", "declaration", *more
    parameters = {name: value.text for name, value in record.parameters.items()}
    return {"parameters": parameters, **{name: getattr(record, name) for name in names}}


def check_same_section(
    kernels: SystemKernels,
    asked: SectionRecord,
    known: SectionRecord,
    what: str,
    **more: tuple[object, object],
) -> None:
    """Refuse a state of another question: of another system or section, or where `more` differs.

    `what` says in words what was kept. `more` has by its name what is asked for and what was kept.
    """
    # a file calls the system by its data, and holds it
    check_same_system(what, kernels, known_system(known.system))
    names = ("parameters", "configuration", "phase", "source", "boundary")
    pairs = {name: (getattr(asked, name), getattr(known, name)) for name in names} | more
    wanted, found = ({name: pair[k] for name, pair in pairs.items()} for k in (0, 1))
    check_same_question(what, wanted, found)


def stated_section(system: ExactSystem, section: MapSection) -> dict[str, Any]:
    """Return the attributes of `SectionRecord` for a section, but for the declaration."""
    structure, forced = system.structure, section.phase is not None
    names = structure.configurations
    return {
        "system": structure.name,
        "parameters": system.values,
        "configuration": names[section.configuration],
        "phase": tuple(map(str, section.phase or ())),
        "source": "" if forced else names[section.source],
        "boundary": reached_text(system, section.source, section.boundaries),
        "coordinates": tuple(structure.states[k] for k in section.free),
    }


def reached_text(system: ExactSystem, source: int, boundaries: Iterable[int]) -> str:
    """Return boundaries of a configuration by names, in order and joined by +."""
    shapes = system.structure.boundaries[source]
    return "+".join(sorted(shapes[b].name for b in boundaries))


def named_way(system: ExactSystem, way: Iterable[Way]) -> tuple[tuple[str, str, str], ...]:
    """Return transitions by names: source, boundaries and target of each."""
    names = system.structure.configurations
    return tuple(
        (
            names[source],
            reached_text(system, source, boundaries),
            names[target],
        )
        for source, boundaries, target in way
    )
