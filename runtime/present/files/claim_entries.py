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
    """An enclosure: decimal texts, exactly."""

    mid: Exact
    rad: Exact

    def stated(self, bits: int) -> Stated:
        """The enclosure that the texts state.

        Parameters
        ----------
        bits : int
            Precision of the enclosure.

        Returns
        -------
        Stated
            With the same texts.
        """
        return Stated.of(self.mid, self.rad, bits)


Enclosures = Mapping[str, Ball]


@dataclass(frozen=True, kw_only=True)
class OrbitProofEntries:
    """Which orbit a file proves something of, at which parameters."""

    orbit: str
    system: str
    tables: SavedSystem | None
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: Itinerary


@dataclass(frozen=True, kw_only=True)
class ClaimEntries:
    """The three claims about an orbit."""

    existence: Verdict
    admissibility: Verdict
    stability: Verdict


def enclosed(enclosures: Enclosures, bits: int) -> dict[str, Stated]:
    """The enclosures that a file states, by name.

    Parameters
    ----------
    enclosures : dict of str to Ball
        As they were read.
    bits : int
        Precision of the enclosures.

    Returns
    -------
    dict of str to Stated
        With the same texts.
    """
    return {name: ball.stated(bits) for name, ball in enclosures.items()}


def stated(kind: type[Record], proof: Any) -> Record:
    """What a file of a proof states: its JSON, and the system as it was taken.

    Parameters
    ----------
    kind : type
        The record that the file has.
    proof : Certificate, BoxCertificate or EventCertificate
        What is proved.

    Returns
    -------
    Record
        Of that kind, ready to be written.
    """
    own = {"declaration": dict(proof.declaration), "closing": dict(proof.closing)}
    return decode(kind, {**entries_of(proof), **own})


def entries_of(proof: Any) -> dict[str, Any]:
    """The JSON of a proof by the names that a file gives system and orbit, with their data.

    Parameters
    ----------
    proof : Certificate, BoxCertificate, EventCertificate or Census
        What is proved.

    Returns
    -------
    dict
        Ready to be decoded.
    """
    name, orbit, saved = named(system_of(proof), proof.orbit)
    entries: dict[str, Any] = replace(proof, system=name, orbit=orbit).to_json()
    return {**entries, "tables": None if saved is None else encode(saved)}


def system_of(proof: Any) -> SystemKernels:
    """The system of a proof of an orbit, as it was loaded for that orbit.

    Parameters
    ----------
    proof : Certificate, BoxCertificate, EventCertificate, Census or BasinCertificate
        What is proved.

    Returns
    -------
    SystemKernels
        That of a declared orbit may be derived with its symmetry, unlike the system alone.
    """
    label = proof.orbit.removeprefix(f"{proof.system}:")
    return known_system(proof.system, None if label == proof.orbit else label)
