"""Proven maps in files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.checker.divided import Band
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import decode
from nonsmooth.runtime.core.result_files import FileFormat, check_follows, naming
from nonsmooth.runtime.core.values import LARGEST_EXPONENT
from nonsmooth.runtime.model.saved_system import system_in
from nonsmooth.runtime.present.files.claim_entries import (
    Ball,
    ClaimEntries,
    Enclosures,
    OrbitProofEntries,
    enclosed,
    stated,
)
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS
from nonsmooth.runtime.proof.boxes.tile_event import Fold, TileEvent
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.certificate import VERSION

__all__ = [
    "BOX",
    "box_entries",
    "box_of",
    "check_exponents",
    "load_box_certificate",
    "save_box",
]


@dataclass(frozen=True, kw_only=True)
class FoldEntries:
    """Entries for two sheets of orbits that meet along a curve, in the file of a map."""

    coordinate: str
    centre: tuple[float, ...]
    half: float
    sheet: str
    other: str


@dataclass(frozen=True, kw_only=True)
class CurveEntries:
    """Entries for the curve of an event that divides a tile, in the file of a map."""

    kind: str
    phase: int | None
    configuration: str
    boundary: str
    instant: str
    window: tuple[Fraction, ...]
    also: tuple[tuple[str, int, str, str], ...]
    across: str
    centre: tuple[float, ...]
    radius: float
    below: str
    above: str
    fold: FoldEntries | None


@dataclass(frozen=True, kw_only=True)
class TileEntries:
    """Entries for one tile, in the file of a map."""

    place: tuple[tuple[int, int], ...]
    claims: ClaimEntries
    reasons: Mapping[str, str]
    enclosures: Enclosures
    guess: tuple[float, ...]
    looked_at: bool
    event: CurveEntries | None


@dataclass(frozen=True, kw_only=True)
class BoxEntries(OrbitProofEntries):
    """Entries of the file of a proven map."""

    box: Mapping[str, tuple[Fraction, Fraction]]
    claims: ClaimEntries
    stability: str
    reasons: Mapping[str, str]
    shares: Mapping[str, float]
    enclosures: Enclosures
    tiles: tuple[TileEntries, ...]
    declaration: Mapping[str, Any]
    closing: Mapping[str, Any]


_VERSION = VERSION + 2  # of maps: curves divide tiles, and orbits meet in folds
_PLANE = 2  # parameters of a box with curves

BOX = FileFormat(
    name="nonsmooth box certificate",
    what="proven map",
    entries=BoxEntries,
    version=_VERSION,
)


def save_box(found: BoxCertificate, path: str | os.PathLike[str]) -> None:
    """Write a map to a file, which is replaced only when the new one is complete."""
    BOX.write(path, box_entries(found))


def box_entries(found: BoxCertificate) -> BoxEntries:
    """Entries of the file of a proven map."""
    return stated(BoxEntries, found)


def load_box_certificate(path: str | os.PathLike[str]) -> BoxCertificate:
    """Read a map that `BoxCertificate.save` wrote; nothing is proved again.

    An `InputError` with the file's name is raised if the file cannot be read, or is cut,
    edited or foreign.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/global-stick")
    >>> ns.certify.box(orbit, {"V": ("0.999", "1.001")}).save("box.json")
    >>> ns.load("box.json").proved
    True
    """
    with naming(path) as file:
        entries = BOX.read(file)
        found = box_of(entries)
        check_follows(
            entries,
            {
                "claims": decode(ClaimEntries, found.claims),
                "reasons": found.reasons,
                "shares": {name: float(share) for name, share in found.shares.items()},
                "enclosures": {
                    name: Ball(mid=x.mid, rad=x.rad) for name, x in found.enclosures.items()
                },
            },
        )
        return found


def box_of(entries: BoxEntries) -> BoxCertificate:
    """The map that a file's entries describe; `InputError` if its tiles do not fill the box."""
    system_in(entries.system, entries.tables)
    check_exponents(entries.declaration)
    found = BoxCertificate(
        orbit=entries.orbit,
        system=entries.system,
        parameters=entries.parameters,
        chosen=entries.chosen,
        itinerary=entries.itinerary,
        box=entries.box,
        stability=entries.stability,
        tiles=tuple(_tile(tile, tuple(entries.box)) for tile in entries.tiles),
        declaration=entries.declaration,
        closing=entries.closing,
    )
    total = sum(tile.place.share for tile in found.tiles)
    if total != 1:
        raise InputError("its tiles do not fill the box")
    return found


def check_exponents(declaration: Any) -> None:
    """Raise `InputError` for a declaration (as read) with exponents too large to compute with."""
    if not all(abs(number) <= LARGEST_EXPONENT for number in _integers(declaration)):
        raise InputError(f"its declaration holds an exponent beyond {LARGEST_EXPONENT}")


def _integers(entry: Any) -> Iterator[int]:
    """Yield all integers of a declaration: exponents and places; other numbers are texts."""
    parts = entry.values() if isinstance(entry, Mapping) else entry
    for part in parts if isinstance(entry, Mapping | list) else ():
        yield from _integers(part)
    if isinstance(entry, int):
        yield entry


def _tile(entries: TileEntries, axes: tuple[str, ...]) -> Tile:
    return Tile(
        place=Place(entries.place),
        claims=vars(entries.claims),
        reasons=entries.reasons,
        enclosures=enclosed(entries.enclosures, BITS),
        guess=entries.guess,
        looked_at=entries.looked_at,
        event=None if entries.event is None else _event(entries.event, axes),
    )


def _event(entries: CurveEntries, axes: tuple[str, ...]) -> TileEvent:
    if entries.across not in axes or len(axes) != _PLANE or len(entries.centre) < _PLANE:
        raise InputError("a curve crosses no parameter of the box")
    return TileEvent(
        kind=entries.kind,
        phase=None if entries.phase is None else entries.phase - 1,
        configuration=entries.configuration,
        boundary=entries.boundary,
        instant=entries.instant,
        window=entries.window,
        also=tuple((kind, phase - 1, name, when) for kind, phase, name, when in entries.also),
        band=Band(axes.index(entries.across), entries.centre, entries.radius),
        below=entries.below,
        above=entries.above,
        fold=None if entries.fold is None else Fold(**vars(entries.fold)),
    )
