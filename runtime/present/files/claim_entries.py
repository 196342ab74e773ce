"""Entries that the files of all proofs share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, TypeVar

from nonsmooth.runtime.core.json_codec import Exact, decode
from nonsmooth.runtime.proof.certificate import Stated

__all__ = ["Ball", "ClaimEntries", "Enclosures", "Itinerary", "Verdict", "enclosed", "stated"]

Record = TypeVar("Record")
Verdict = Literal["proved", "refuted", "undecided"]
Itinerary = tuple[tuple[str, str], ...]


@dataclass(frozen=True, kw_only=True)
class Ball:
    """An enclosure: decimal texts, exactly."""

    mid: Exact
    rad: Exact

    def stated(self, bits: int) -> Stated:
        """The enclosure that the texts state."""
        return Stated.of(self.mid, self.rad, bits)


Enclosures = Mapping[str, Ball]


@dataclass(frozen=True, kw_only=True)
class ClaimEntries:
    """The three claims about an orbit."""

    existence: Verdict
    admissibility: Verdict
    stability: Verdict


def enclosed(enclosures: Enclosures, bits: int) -> dict[str, Stated]:
    """The enclosures that a file states, by name."""
    return {name: ball.stated(bits) for name, ball in enclosures.items()}


def stated(kind: type[Record], proof: Any) -> Record:
    """What a file of a proof states: its JSON, and the system as it was taken."""
    own = {"declaration": dict(proof.declaration), "closing": dict(proof.closing)}
    return decode(kind, {**proof.to_json(), **own})
