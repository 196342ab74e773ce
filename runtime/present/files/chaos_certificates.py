"""Certificates of chaos in files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from nonsmooth.runtime.core.json_codec import Exact, decode, encode
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.chaos.cone_conditions import ConeCondition
from nonsmooth.runtime.proof.chaos.h_sets import HSet

__all__ = ["CHAOS", "chaos_entries", "chaos_of", "load_chaos_certificate", "save_chaos"]


@dataclass(frozen=True, kw_only=True)
class HSetEntries:
    """Entries for one h-set."""

    name: str
    centre: tuple[Exact, ...]
    sides: tuple[tuple[Exact, ...], ...]


@dataclass(frozen=True, kw_only=True)
class ChaosEntries:
    """Entries of the file of a certificate of chaos."""

    system: str
    tables: SavedSystem | None
    parameters: Mapping[str, Value]
    claim: Literal["proved", "undecided"]
    reason: str
    configuration: str
    phase: tuple[Exact, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    iterates: int
    h_sets: tuple[HSetEntries, ...]
    coverings: tuple[tuple[str, str], ...]
    itineraries: Mapping[str, tuple[tuple[str, str, str], ...]]
    growth: Exact
    entropy: Exact
    cones: ConeCondition | None = None
    parts: int
    tried: tuple[str, ...]
    bits: int
    declaration: Mapping[str, Any]


CHAOS = FileFormat(
    name="nonsmooth chaos certificate",
    what="certificate of chaos",
    entries=ChaosEntries,
    version=VERSION,
)


def save_chaos(found: ChaosCertificate, path: str | os.PathLike[str]) -> None:
    """Write a certificate of chaos to a file, which is replaced only when the new one is complete.

    `InputError` is raised if the file cannot be written.
    """
    CHAOS.write(path, chaos_entries(found))


def chaos_entries(found: ChaosCertificate) -> ChaosEntries:
    """Entries of the file of a certificate of chaos."""
    name, _, saved = named(known_system(found.system, None))
    told = replace(found, system=name).to_json()
    tables = None if saved is None else encode(saved)
    return decode(ChaosEntries, {**told, "tables": tables, "declaration": dict(found.declaration)})


def chaos_of(entries: ChaosEntries) -> ChaosCertificate:
    """The certificate of chaos that a file's entries describe."""
    own = {**vars(entries)}
    system_in(entries.system, own.pop("tables"))
    sets = tuple(HSet(h.name, h.centre, h.sides) for h in entries.h_sets)
    return ChaosCertificate(**{**own, "h_sets": sets, "images": {}})


load_chaos_certificate = CHAOS.reader(chaos_of)
