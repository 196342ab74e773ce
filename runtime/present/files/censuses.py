"""A census in a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from nonsmooth.runtime.core.json_codec import BlankValue, Codec, Exact, decode
from nonsmooth.runtime.core.result_files import FileFormat, check_follows
from nonsmooth.runtime.model.saved_system import system_in
from nonsmooth.runtime.present.files.certificates import (
    CERTIFICATE,
    CertificateEntries,
    certificate_entries,
    certificate_of,
)
from nonsmooth.runtime.present.files.claim_entries import OrbitProofEntries, entries_of
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.counting.census import Census, Counted, Open

__all__ = ["CENSUS", "CensusEntries", "census_entries", "census_of", "load_census", "save_census"]

# the whole content of a certificate's file, with its checksum
_Certificate = Annotated[CertificateEntries, Codec(CERTIFICATE.content, CERTIFICATE.check)]


@dataclass(frozen=True, kw_only=True)
class CountedEntries:
    """Entries for one orbit, in the file of a census."""

    unique: Mapping[str, tuple[Exact, Exact]]
    certificate: _Certificate | None
    reason: str


@dataclass(frozen=True, kw_only=True)
class OpenEntries:
    """Entries for a box whose content is undecided, in the file of a census."""

    bounds: Mapping[str, tuple[Exact, Exact]]
    reason: str


@dataclass(frozen=True, kw_only=True)
class CensusEntries(OrbitProofEntries):
    """Entries of the file of a census."""

    given_period: BlankValue
    largest: Exact
    declaration: Mapping[str, Any]
    box: tuple[str, ...]
    conditions: tuple[str, ...]
    count: int
    admissible: int
    decided: bool
    statement: str
    orbits: tuple[CountedEntries, ...]
    undecided: tuple[OpenEntries, ...]
    bits: int
    looked: int
    trees: tuple[str, ...]


CENSUS = FileFormat(
    name="nonsmooth census", what="census", entries=CensusEntries, version=VERSION + 1
)


def census_entries(census: Census) -> CensusEntries:
    """Entries of the file of a census."""
    content = entries_of(census)
    content |= {"declaration": dict(census.declaration), "trees": list(census.trees)}
    for told, orbit in zip(content["orbits"], census.orbits, strict=True):
        if orbit.certificate is not None:
            told["certificate"] = CERTIFICATE.content(certificate_entries(orbit.certificate))
    return decode(CensusEntries, content)


def census_of(entries: CensusEntries) -> Census:
    """The census that a file's entries describe.

    `InputError` is raised if its counts and statements do not follow from its orbits.
    """
    system_in(entries.system, entries.tables)
    census = Census(
        orbit=entries.orbit,
        system=entries.system,
        parameters=entries.parameters,
        chosen=entries.chosen,
        itinerary=entries.itinerary,
        given_period=entries.given_period,
        largest=entries.largest,
        declaration=entries.declaration,
        box=entries.box,
        conditions=entries.conditions,
        orbits=tuple(map(_counted, entries.orbits)),
        undecided=tuple(Open(box.bounds, box.reason) for box in entries.undecided),
        bits=entries.bits,
        trees=entries.trees,
    )
    follows = ("count", "admissible", "decided", "statement", "looked")
    check_follows(entries, {name: getattr(census, name) for name in follows})
    return census


def _counted(entries: CountedEntries) -> Counted:
    found = entries.certificate
    return Counted(entries.unique, None if found is None else certificate_of(found), entries.reason)


save_census = CENSUS.writer(census_entries)
load_census = CENSUS.reader(census_of)
