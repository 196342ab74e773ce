"""What is proved of an event of a branch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import FromOne
from nonsmooth.runtime.proof.boxes.tile_event import Instant
from nonsmooth.runtime.proof.certificate import (
    Decided,
    Enclosures,
    Stated,
    StatedOrbits,
    Unknown,
    precise,
)


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class EventCertificate(StatedOrbits):
    """An event of a branch, enclosed by ball arithmetic.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All that was given for an orbit near it, beside the branch's parameter.
    chosen : tuple of str
        Parameters that the orbit leaves open and that were chosen.
    itinerary : tuple of (configuration, boundary)
        Empty where the equations were not set up.
    kind, text : str
        Of the event, as in `Event`.
    parameter : str
    phase : int or None
        Counted from 0; in JSON from 1.
    configuration, boundary : str
    instant : {"", "start", "inside", "end"}
        Of that phase, where it happens at one.
    claim : {"proved", "undecided"}
        The box contains at least one such event, and all that it contains lie in the
        enclosures.
    reason : str
        Why it is undecided.
    enclosures : dict of str to Stated
        The parameter, and the unknowns of the orbit's equations: physical start and dwell times.
    box : tuple of Unknown
        The unknowns of the orbit's equations, the parameter, and for a grazing its time.
    bits : int
    declaration, closing : dict
        As in a `BoxCertificate`, over the parameter and those that were given.
    """

    kind: str
    text: str
    parameter: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Instant
    claim: Decided
    reason: str
    enclosures: Enclosures
    box: tuple[Unknown, ...]
    bits: int

    def __post_init__(self) -> None:
        object.__setattr__(self, "enclosures", precise(self.enclosures, self.bits))

    @property
    def proved(self) -> bool:
        """Whether there is such an event."""
        return self.claim == "proved"

    @property
    def value(self) -> Stated:
        """Enclosure of the parameter.

        Raises
        ------
        InputError
            If the event is undecided.
        """
        if not self.proved:
            raise InputError(f"the {self.kind} is undecided and has no value: {self.reason}")
        return self.enclosures[self.parameter]


@dataclass(frozen=True, kw_only=True)
class EventCertificates:
    """The certificates of one file, in its order."""

    events: tuple[EventCertificate, ...]


def events_claim(found: Sequence[EventCertificate]) -> dict[str, str]:
    """Return the claim of all events: "proved" if each of them is, else "undecided"."""
    proved = all(certificate.proved for certificate in found)
    return {"events": "proved" if proved else "undecided"}
