"""A question about the sets of a section as data, from which any process takes it up."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, Protocol, TypeVar

from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem, enclosed_system
from nonsmooth.runtime.proof.sets.sections import (
    MapSection,
    forcing_section,
    transition_section,
)

__all__ = ["SectionRecord", "ToldQuestion"]


class SectionRecord(Protocol):
    """A record that names a section, as basins and graphs do."""

    @property
    def parameters(self) -> Mapping[str, Value]:
        """All parameters of the system."""

    @property
    def configuration(self) -> str:
        """The configuration of the states on the section."""

    @property
    def phase(self) -> tuple[str, ...]:
        """Cosine and sine of the forcing on the section, or nothing."""

    @property
    def source(self) -> str:
        """The configuration that the section's transition leaves."""

    @property
    def boundary(self) -> str:
        """The boundaries that the section's transition follows, joined by +."""


Known = TypeVar("Known", bound=SectionRecord)


@dataclass(frozen=True)
class ToldQuestion(Generic[Known]):
    """A system by its name and a section by its record: data that other processes can be given."""

    system: str
    saved: SavedSystem | None  # as files hold the system
    known: Known

    @staticmethod
    def of(kernels: SystemKernels, known: Known) -> ToldQuestion[Known]:
        """Return the question for a system and a record, which has to be picklable."""
        name, _, saved = named(kernels)
        return ToldQuestion(name, saved, known)

    def taken_up(self, bits: int) -> tuple[EnclosedSystem, MapSection]:
        """Return the system and the section, with flows of so many bits."""
        kernels = system_in(self.system, self.saved)
        with flint_precision(bits):
            system = enclosed_system(kernels, dict(self.known.parameters))(bits)
        return system, _section(system, self.known)


def _section(system: EnclosedSystem, known: SectionRecord) -> MapSection:
    names = list(system.structure.configurations)
    configuration = names.index(known.configuration)
    if known.phase:
        cosine, sine = (rational_of(Fraction(x)) for x in known.phase)
        return forcing_section(system, configuration, (cosine, sine))
    source, reached = names.index(known.source), known.boundary.split("+")
    shapes = system.structure.boundaries[source]
    boundaries = frozenset(b for b, shape in enumerate(shapes) if shape.name in reached)
    return transition_section(system, source, boundaries, configuration)
