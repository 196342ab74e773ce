"""Certified cascades in files."""

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
from nonsmooth.runtime.proof.branch.stating import STATED
from nonsmooth.runtime.proof.doubling.certified_cascade import (
    CertifiedCascade,
    CertifiedDoubling,
)

__all__ = [
    "CASCADE",
    "certified_cascade_entries",
    "certified_cascade_of",
    "load_certified_cascade",
    "save_cascade",
]


@dataclass(frozen=True, kw_only=True)
class DoublingEntries:
    """Entries for one doubling; tiles are counted from 1."""

    tile: int
    scaled: str
    amplitude: Fraction
    side: Literal["above", "below"]
    verdict: Literal["stable", "unstable", "undecided"]
    reason: str
    rate: Ball
    centre: tuple[tuple[float, ...], ...]
    radii: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class CascadeClaimEntries:
    """Entry with the claim about a cascade."""

    doublings: Literal["proved", "undecided"]


@dataclass(frozen=True, kw_only=True)
class CertifiedCascadeEntries:
    """Entries of the file of a certified cascade."""

    orbit: str
    claims: CascadeClaimEntries
    asked: int
    ended: Literal["complete", "unfinished", "no flip", "not covered", "not proved"]
    end: str
    doublings: tuple[DoublingEntries, ...]
    branches: tuple[CertifiedBranchEntries, ...]


CASCADE = FileFormat(
    name="nonsmooth certified cascade",
    what="certified cascade",
    entries=CertifiedCascadeEntries,
    version=1 + SAVED_VERSION,
)


def certified_cascade_entries(found: CertifiedCascade) -> CertifiedCascadeEntries:
    """Entries of the file of a certified cascade."""
    branches = tuple(map(certified_branch_entries, found.branches))
    return CertifiedCascadeEntries(
        orbit=_renamed(found, branches[0].system),
        claims=CascadeClaimEntries(
            doublings="proved" if found.claims["doublings"] == "proved" else "undecided"
        ),
        asked=found.asked,
        ended=found.ended,
        end=found.end,
        doublings=tuple(
            DoublingEntries(
                **{
                    **vars(doubling),
                    "tile": doubling.tile + 1,
                    "rate": Ball(mid=doubling.rate.texts[0], rad=doubling.rate.texts[1]),
                }
            )
            for doubling in found.doublings
        ),
        branches=branches,
    )


def _renamed(found: CertifiedCascade, system: str) -> str:
    """The orbit's name, with its system called as files call it."""
    own = found.orbit.removeprefix(found.system)
    return found.orbit if own == found.orbit else system + own


def certified_cascade_of(entries: CertifiedCascadeEntries) -> CertifiedCascade:
    """The certified cascade that a file's entries describe."""
    return CertifiedCascade(
        orbit=entries.orbit,
        asked=entries.asked,
        ended=entries.ended,
        end=entries.end,
        doublings=tuple(
            CertifiedDoubling(
                **{
                    **vars(doubling),
                    "tile": doubling.tile - 1,
                    "rate": doubling.rate.stated(STATED),
                }
            )
            for doubling in entries.doublings
        ),
        branches=tuple(map(certified_branch_of, entries.branches)),
    )


save_cascade = CASCADE.writer(certified_cascade_entries)
load_certified_cascade = CASCADE.reader(certified_cascade_of)
