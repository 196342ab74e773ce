"""Certified cascades in files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.present.files.certified_branches import (
    CertifiedBranchEntries,
    certified_branch_entries,
    certified_branch_of,
)
from nonsmooth.runtime.present.files.claim_entries import Ball
from nonsmooth.runtime.proof.branch.certify_branch import STATED
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
    """What a file states of one doubling; tiles are counted from 1."""

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
    """The claim about a cascade."""

    doublings: Literal["proved", "undecided"]


@dataclass(frozen=True, kw_only=True)
class CertifiedCascadeEntries:
    """What a certified cascade's file states."""

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
)


def save_cascade(found: CertifiedCascade, path: str | os.PathLike[str]) -> None:
    """Write a cascade to a file; what was there stays until the new content is complete.

    Parameters
    ----------
    found : CertifiedCascade
    path : str or path
        The file.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    CASCADE.write(path, certified_cascade_entries(found))


def certified_cascade_entries(found: CertifiedCascade) -> CertifiedCascadeEntries:
    """What a certified cascade's file states.

    Parameters
    ----------
    found : CertifiedCascade

    Returns
    -------
    CertifiedCascadeEntries
        Ready to be written.
    """
    return CertifiedCascadeEntries(
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
        branches=tuple(map(certified_branch_entries, found.branches)),
    )


def load_certified_cascade(path: str | os.PathLike[str]) -> CertifiedCascade:
    """Read a cascade that `CertifiedCascade.save` wrote; nothing is proved again.

    Parameters
    ----------
    path : str or path
        File to read.

    Returns
    -------
    CertifiedCascade

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/symmetric", {"V": "1.05"})
    >>> branch = ns.continue_orbit(orbit, "V", (1, 1.2))
    >>> ns.certify_cascade(branch, tiles=2).save("cascade.json")
    >>> ns.load("cascade.json").doublings[0].side
    'above'
    """
    with naming(path) as file:
        return certified_cascade_of(CASCADE.read(file))


def certified_cascade_of(entries: CertifiedCascadeEntries) -> CertifiedCascade:
    """The cascade that a file's entries describe.

    Parameters
    ----------
    entries : CertifiedCascadeEntries
        As they were read.

    Returns
    -------
    CertifiedCascade
    """
    return CertifiedCascade(
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
