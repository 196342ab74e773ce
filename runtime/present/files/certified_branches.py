"""Certified branches in files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
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
    BranchEvent,
    BranchTile,
    CertifiedBranch,
)
from nonsmooth.runtime.proof.branch.certify_branch import STATED
from nonsmooth.runtime.proof.certificate import VERSION

__all__ = [
    "BRANCH",
    "certified_branch_entries",
    "certified_branch_of",
    "load_certified_branch",
    "save_certified_branch",
]

Verdict = Literal["stable", "neutral", "unstable", "not admissible", "undecided"]


@dataclass(frozen=True, kw_only=True)
class BranchEventEntries:
    """What a file states of one event of a branch."""

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
    """What a file states of one tile of a branch."""

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
    """The claim about a branch."""

    branch: Literal["proved", "undecided"]


@dataclass(frozen=True, kw_only=True)
class CertifiedBranchEntries(OrbitProofEntries):
    """What a certified branch's file states."""

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


BRANCH = FileFormat(
    name="nonsmooth certified branch",
    what="certified branch",
    entries=CertifiedBranchEntries,
    version=VERSION,
)


def certified_branch_entries(found: CertifiedBranch) -> CertifiedBranchEntries:
    """What a certified branch's file states.

    Parameters
    ----------
    found : CertifiedBranch

    Returns
    -------
    CertifiedBranchEntries
        Ready to be written.
    """
    return stated(CertifiedBranchEntries, found)


def certified_branch_of(entries: CertifiedBranchEntries) -> CertifiedBranch:
    """The branch that a file's entries describe.

    Parameters
    ----------
    entries : CertifiedBranchEntries
        As they were read.

    Returns
    -------
    CertifiedBranch
    """
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
    return BranchEvent(**{**vars(entries), "also": also, "enclosures": enclosures})


save_certified_branch = BRANCH.writer(certified_branch_entries)
load_certified_branch = BRANCH.reader(certified_branch_of)
