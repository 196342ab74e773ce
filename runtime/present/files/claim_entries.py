"""Entries that the files of all proofs share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeVar

from nonsmooth.runtime.core.json_codec import Exact, decode, encode
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels, known_system
from nonsmooth.runtime.model.saved_system import SavedSystem, named
from nonsmooth.runtime.proof.certificate import Stated

__all__ = [
    "Ball",
    "ClaimEntries",
    "Enclosures",
    "Itinerary",
    "OrbitProofEntries",
    "Verdict",
    "enclosed",
    "entries_of",
    "stated",
    "system_of",
]

Record = TypeVar("Record")
Verdict = Literal["proved", "refuted", "undecided"]
Itinerary = tuple[tuple[str, str], ...]


@dataclass(frozen=True, kw_only=True)
class Ball:
    """An enclosure as decimal texts, which state it exactly."""

    mid: Exact
    rad: Exact

    def stated(self, bits: int) -> Stated:
        """The enclosure that the texts state, with a precision of `bits`, and the texts."""
        return Stated.of(self.mid, self.rad, bits)


Enclosures = Mapping[str, Ball]


@dataclass(frozen=True, kw_only=True)
class OrbitProofEntries:
    """Entries that say of which orbit, at which parameters, a file proves something."""

    orbit: str
    system: str
    tables: SavedSystem | None
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: Itinerary


@dataclass(frozen=True, kw_only=True)
class ClaimEntries:
    """Entries with the three claims about an orbit."""

    existence: Verdict
    admissibility: Verdict
    stability: Verdict


def enclosed(enclosures: Enclosures, bits: int) -> dict[str, Stated]:
    """The enclosures that a file states, by name, with a precision of `bits`, and their texts."""
    return {name: ball.stated(bits) for name, ball in enclosures.items()}


def stated(kind: type[Record], proof: Any) -> Record:
    """Record of type `kind` with a proof's entries, its declaration, and what closes its orbit.

    The proof is a certificate of an orbit, a box or an event.
    """
    own = {"declaration": dict(proof.declaration), "closing": dict(proof.closing)}
    return decode(kind, {**entries_of(proof), **own})


def entries_of(proof: Any) -> dict[str, Any]:
    """A proof as JSON, with the names that a file gives its system and orbit, and their data.

    The proof is a certificate of an orbit, a box or an event, or a census.
    """
    name, orbit, saved = named(system_of(proof), proof.orbit)
    entries: dict[str, Any] = replace(proof, system=name, orbit=orbit).to_json()
    return {**entries, "tables": None if saved is None else encode(saved)}


def system_of(proof: Any) -> SystemKernels:
    """The system of a proof, as it was loaded for the proof's orbit.

    For a declared orbit it may be derived with the orbit's symmetry, unlike the system
    alone.
    """
    label = proof.orbit.removeprefix(f"{proof.system}:")
    return known_system(proof.system, None if label == proof.orbit else label)
