"""What is proved of an event of a branch."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import Shown, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.proof.certificate import Stated, Unknown, balls_json, orbit_json

__all__ = ["EventCertificate", "events_claim"]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class EventCertificate(Shown):
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

    orbit: str
    system: str
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: tuple[tuple[str, str], ...]
    kind: str
    text: str
    parameter: str
    phase: int | None
    configuration: str
    boundary: str
    instant: str
    claim: str
    reason: str
    enclosures: Mapping[str, Stated]
    box: tuple[Unknown, ...]
    bits: int
    declaration: Mapping[str, Any] = field(repr=False)
    closing: Mapping[str, Any] = field(repr=False)

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

    def to_json(self) -> dict[str, Any]:
        """Give the certificate as JSON: numbers as decimal strings.

        Returns
        -------
        dict
            The certificate, ready for `json.dumps`.
        """
        return {
            **orbit_json(self),
            "chosen": list(self.chosen),
            "kind": self.kind,
            "text": self.text,
            "parameter": self.parameter,
            "phase": None if self.phase is None else self.phase + 1,
            "configuration": self.configuration,
            "boundary": self.boundary,
            "instant": self.instant,
            "claim": self.claim,
            "reason": self.reason,
            "bits": self.bits,
            "enclosures": balls_json(self.enclosures),
            "box": [asdict(x) for x in self.box],
        }

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the certificate to a file; `nonsmooth.load` reads it.

        Parameters
        ----------
        path : str or path
            File to write.

        Raises
        ------
        InputError
            If the file cannot be written.
        """
        registered("save_events")([self], path)


def events_claim(found: Sequence[EventCertificate]) -> dict[str, str]:
    """Return the claim of all events: "proved" if each of them is, else "undecided"."""
    proved = all(certificate.proved for certificate in found)
    return {"events": "proved" if proved else "undecided"}
