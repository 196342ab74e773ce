"""Certified branches in files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Literal

from nonsmooth.runtime.core.json_codec import FromOne
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.model.saved_system import system_in
from nonsmooth.runtime.present.files.box_certificates import check_exponents
from nonsmooth.runtime.present.files.claim_entries import (
    Enclosures,
    OrbitProofEntries,
    enclosed,
    stated,
)
from nonsmooth.runtime.proof.branch.certified_branch import (
    STATED,
    BranchEvent,
    BranchTile,
    CertifiedBranch,
    OrbitBeyond,
)
from nonsmooth.runtime.proof.certificate import VERSION

__all__ = [
    "BRANCH",
    "branch_file_entries",
    "certified_branch_entries",
    "certified_branch_of",
    "load_certified_branch",
    "save_certified_branch",
]

Verdict = Literal["stable", "neutral", "unstable", "not admissible", "undecided"]


@dataclass(frozen=True, kw_only=True)
class BranchEventEntries:
    """Entries for one event of a certified branch."""

    kind: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Literal["", "start", "inside", "end"]
    lower: Fraction
    upper: Fraction
    window: tuple[Fraction, ...]
    also: tuple[tuple[str, int, str, str], ...]
    enclosures: Enclosures


@dataclass(frozen=True, kw_only=True)
class BranchTileEntries:
    """Entries for one tile of a certified branch."""

    coordinate: str
    lower: Fraction
    upper: Fraction
    forwards: bool
    before: Verdict
    after: Verdict
    reason: str
    centre: tuple[tuple[float, ...], ...]
    radii: tuple[float, ...]
    event: BranchEventEntries | None
    divided: FromOne | None


@dataclass(frozen=True, kw_only=True)
class BranchClaimEntries:
    """Entry with the claim about a branch."""

    branch: Literal["proved", "undecided"]


@dataclass(frozen=True, kw_only=True)
class CertifiedBranchEntries(OrbitProofEntries):
    """Entries of a certified branch, as files of other results hold it."""

    parameter: str
    interval: tuple[Fraction, Fraction]
    stability: str
    unknown_names: tuple[str, ...]
    claims: BranchClaimEntries
    start: int
    ends: tuple[str, str]
    tiles: tuple[BranchTileEntries, ...]
    declaration: Mapping[str, Any]
    closing: Mapping[str, Any]


@dataclass(frozen=True, kw_only=True)
class OrbitBeyondEntries:
    """Entries for orbits that begin at an event."""

    side: Literal["above", "below"]
    own: Literal["above", "below"]
    verdict: Literal["stable", "neutral", "unstable"]
    branch: CertifiedBranchEntries


@dataclass(frozen=True, kw_only=True)
class FileEventEntries(BranchEventEntries):
    """Entries for an event in the branch's own file, with the orbits that begin there."""

    beyond: tuple[OrbitBeyondEntries, ...] = ()


@dataclass(frozen=True, kw_only=True)
class FileTileEntries(BranchTileEntries):
    """Entries for a tile in the branch's own file."""

    event: FileEventEntries | None


@dataclass(frozen=True, kw_only=True)
class BranchFileEntries(CertifiedBranchEntries):
    """Entries of the file of a certified branch."""

    tiles: tuple[FileTileEntries, ...]


BRANCH = FileFormat(
    name="nonsmooth certified branch",
    what="certified branch",
    entries=BranchFileEntries,
    version=VERSION,
)


def certified_branch_entries(found: CertifiedBranch) -> CertifiedBranchEntries:
    """Entries of a certified branch, without the orbits that begin at its events."""
    return stated(CertifiedBranchEntries, _bare(found))


def branch_file_entries(found: CertifiedBranch) -> BranchFileEntries:
    """Entries of the file of a certified branch, with the orbits that begin at its events."""
    told = stated(BranchFileEntries, _bare(found))
    return replace(told, tiles=tuple(map(_with_beyond, told.tiles, found.tiles)))


def _bare(found: CertifiedBranch) -> CertifiedBranch:
    """A branch without the orbits that begin at its events."""
    tiles = (
        tile if tile.event is None else replace(tile, event=replace(tile.event, beyond=()))
        for tile in found.tiles
    )
    return replace(found, tiles=tuple(tiles))


def _with_beyond(told: FileTileEntries, tile: BranchTile) -> FileTileEntries:
    """A tile's entries, completed by the orbits that begin at its event."""
    if told.event is None or tile.event is None:
        return told
    beyond = tuple(
        OrbitBeyondEntries(**{**vars(each), "branch": certified_branch_entries(each.branch)})
        for each in tile.event.beyond
    )
    return replace(told, event=replace(told.event, beyond=beyond))


def certified_branch_of(entries: CertifiedBranchEntries) -> CertifiedBranch:
    """The certified branch that a file's entries describe."""
    system_in(entries.system, entries.tables)
    check_exponents(entries.declaration)
    own = {name: value for name, value in vars(entries).items() if name not in ("tables", "claims")}
    return CertifiedBranch(**{**own, "tiles": tuple(map(_tile, entries.tiles))})


def _tile(entries: BranchTileEntries) -> BranchTile:
    event = entries.event
    return BranchTile(**{**vars(entries), "event": None if event is None else _event(event)})


def _event(entries: BranchEventEntries) -> BranchEvent:
    also = tuple((kind, phase - 1, *rest) for kind, phase, *rest in entries.also)
    enclosures = enclosed(entries.enclosures, STATED)
    beyond = tuple(
        OrbitBeyond(**{**vars(each), "branch": certified_branch_of(each.branch)})
        for each in (entries.beyond if isinstance(entries, FileEventEntries) else ())
    )
    told = {**vars(entries), "also": also, "enclosures": enclosures, "beyond": beyond}
    return BranchEvent(**told)


save_certified_branch = BRANCH.writer(branch_file_entries)
load_certified_branch = BRANCH.reader(certified_branch_of)
