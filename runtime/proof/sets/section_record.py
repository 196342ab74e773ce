"""How records name a section of motions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.registry import Certified
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.saved_system import KeptSystemName
from nonsmooth.runtime.proof.certificate import Declaration
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import MapSection

__all__ = ["SectionRecord", "named_way", "section_entries", "stated_section"]


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


def stated_section(system: ExactSystem, section: MapSection) -> dict[str, Any]:
    """Return the attributes of `SectionRecord` for a section, but for the declaration."""
    structure, forced = system.structure, section.phase is not None
    names = structure.configurations
    shapes = () if forced else structure.boundaries[section.source]
    return {
        "system": structure.name,
        "parameters": system.values,
        "configuration": names[section.configuration],
        "phase": tuple(map(str, section.phase or ())),
        "source": "" if forced else names[section.source],
        "boundary": "+".join(sorted(shapes[b].name for b in section.boundaries)),
        "coordinates": tuple(structure.states[k] for k in section.free),
    }


def named_way(
    system: ExactSystem, way: Iterable[tuple[int, int, int]]
) -> tuple[tuple[str, str, str], ...]:
    """Return transitions by names: source, boundaries and target of each.

    They are given by numbers, and by the mask of the boundaries.
    """
    structure = system.structure
    names = structure.configurations
    return tuple(
        (
            names[source],
            "+".join(sorted(structure.boundaries[source][b].name for b in members_of(mask))),
            names[target],
        )
        for source, mask, target in way
    )
