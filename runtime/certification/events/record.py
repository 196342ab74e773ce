"""What is proved of an event of a branch."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from nonsmooth.runtime.certification.certificate import Stated, Unknown

__all__ = ["EventCertificate"]


@dataclass(frozen=True, eq=False)
class EventCertificate:
    """An event of a branch, enclosed by ball arithmetic.

    Attributes
    ----------
    orbit : str
    kind, text : str
        Of the event, as in `Event`.
    parameter : str
    phase : int or None
    configuration, boundary : str
    claim : {"proved", "undecided"}
        The box contains at least one such event, and all that it contains lie in the
        enclosures.
    reason : str
        Why it is undecided.
    enclosures : dict of str to Stated
        The parameter, and the unknowns of the orbit's equations: physical start and dwell times.
    box : tuple of Unknown
    bits : int
    """

    orbit: str
    kind: str
    text: str
    parameter: str
    phase: int | None
    configuration: str
    boundary: str
    claim: str
    reason: str
    enclosures: Mapping[str, Stated]
    box: tuple[Unknown, ...]
    bits: int

    @property
    def proved(self) -> bool:
        """Whether there is such an event."""
        return self.claim == "proved"

    @property
    def value(self) -> Stated:
        """Enclosure of the parameter."""
        return self.enclosures[self.parameter]

    def to_json(self) -> dict[str, Any]:
        """All of it as JSON: numbers as decimal strings."""
        return {
            "orbit": self.orbit,
            "kind": self.kind,
            "text": self.text,
            "parameter": self.parameter,
            "phase": self.phase,
            "configuration": self.configuration,
            "boundary": self.boundary,
            "claim": self.claim,
            "reason": self.reason,
            "bits": self.bits,
            "enclosures": {n: {"mid": x.mid, "rad": x.rad} for n, x in self.enclosures.items()},
            "box": [{"name": x.name, "mid": x.mid, "rad": x.rad} for x in self.box],
        }
