"""Certified doublings in files."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.model.saved_system import SAVED_VERSION
from nonsmooth.runtime.present.files.certified_branches import (
    CertifiedBranchEntries,
    certified_branch_entries,
    certified_branch_of,
)
from nonsmooth.runtime.present.files.claim_entries import Ball
from nonsmooth.runtime.proof.branch.certified_branch import STATED
from nonsmooth.runtime.proof.doubling.certified_doubling import (
    CertifiedDoubling,
    DoubledOrbits,
)

__all__ = [
    "DOUBLING",
    "certified_doubling_of",
    "doubling_entries",
    "load_certified_doubling",
    "save_doubling",
]


@dataclass(frozen=True, kw_only=True)
class DoubledEntries:
    """Entries for the orbits beside the flip; tiles are counted from 1."""

    tile: int
    scaled: str
    amplitude: Fraction
    side: Literal["above", "below"]
    verdict: Literal["stable", "unstable", "undecided"]
    reason: str
    rate: Ball
    centre: tuple[tuple[float, ...], ...]
    radii: tuple[float, ...]
    branch: CertifiedBranchEntries


@dataclass(frozen=True, kw_only=True)
class DoublingClaimEntries:
    """Entry with the claim about a doubling."""

    doubling: Literal["proved", "undecided"]


@dataclass(frozen=True, kw_only=True)
class DoublingEntries:
    """Entries of the file of a certified doubling."""

    orbit: str
    claims: DoublingClaimEntries
    ended: Literal["complete", "unfinished", "no flip", "not covered", "not proved"]
    end: str
    branch: CertifiedBranchEntries
    doubled: DoubledEntries | None


DOUBLING = FileFormat(
    name="nonsmooth certified doubling",
    what="certified doubling",
    entries=DoublingEntries,
    version=SAVED_VERSION,
)


def doubling_entries(found: CertifiedDoubling) -> DoublingEntries:
    """Entries of the file of a certified doubling."""
    branch, doubled = certified_branch_entries(found.branch), found.doubled
    return DoublingEntries(
        orbit=_renamed(found, branch.system),
        claims=DoublingClaimEntries(
            doubling="proved" if found.claims["doubling"] == "proved" else "undecided"
        ),
        ended=found.ended,
        end=found.end,
        branch=branch,
        doubled=None
        if doubled is None
        else DoubledEntries(
            **{
                **vars(doubled),
                "tile": doubled.tile + 1,
                "rate": Ball(mid=doubled.rate.texts[0], rad=doubled.rate.texts[1]),
                "branch": certified_branch_entries(doubled.branch),
            }
        ),
    )


def _renamed(found: CertifiedDoubling, system: str) -> str:
    """The orbit's name, with its system called as files call it."""
    own = found.orbit.removeprefix(found.system)
    return found.orbit if own == found.orbit else system + own


def certified_doubling_of(entries: DoublingEntries) -> CertifiedDoubling:
    """The certified doubling that a file's entries describe."""
    doubled = entries.doubled
    return CertifiedDoubling(
        orbit=entries.orbit,
        ended=entries.ended,
        end=entries.end,
        branch=certified_branch_of(entries.branch),
        doubled=None
        if doubled is None
        else DoubledOrbits(
            **{
                **vars(doubled),
                "tile": doubled.tile - 1,
                "rate": doubled.rate.stated(STATED),
                "branch": certified_branch_of(doubled.branch),
            }
        ),
    )


save_doubling = DOUBLING.writer(doubling_entries)
load_certified_doubling = DOUBLING.reader(certified_doubling_of)
