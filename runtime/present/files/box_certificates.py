"""Proven maps in files: JSON, refused when it is cut, edited or foreign."""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.present.files.orbit_numbers import given_value
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.certificate import VERSION, Stated

__all__ = ["BOX", "box_entries", "box_of", "load_box_certificate", "save_box"]

BOX = Form(
    "nonsmooth box certificate",
    "proven map",
    {
        "orbit": str,
        "system": str,
        "parameters": dict,
        "chosen": list,
        "itinerary": list,
        "box": dict,
        "claims": dict,
        "stability": str,
        "reasons": dict,
        "shares": dict,
        "enclosures": dict,
        "tiles": list,
        "declaration": dict,
        "closing": dict,
    },
    VERSION,
)


def save_box(found: BoxCertificate, path: str | os.PathLike[str]) -> None:
    """Write a map to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    BOX.write(path, box_entries(found))


def box_entries(found: BoxCertificate) -> dict[str, Any]:
    """What a map's file states."""
    return {
        **found.to_json(),
        "declaration": dict(found.declaration),
        "closing": dict(found.closing),
    }


def load_box_certificate(path: str | os.PathLike[str]) -> BoxCertificate:
    """Read a map that `BoxCertificate.save` wrote; nothing is proved again.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    with naming(path) as file:
        return box_of(BOX.read(file))


def box_of(content: Mapping[str, Any]) -> BoxCertificate:
    """The map that a file's entries describe.

    Raises
    ------
    InputError
    """
    found = BoxCertificate(
        content["orbit"],
        content["system"],
        {name: given_value(name, text) for name, text in content["parameters"].items()},
        tuple(content["chosen"]),
        tuple((str(c), str(b)) for c, b in content["itinerary"]),
        {name: (Fraction(low), Fraction(high)) for name, (low, high) in content["box"].items()},
        content["stability"],
        tuple(map(_tile, content["tiles"])),
        content["declaration"],
        content["closing"],
    )
    total = sum(tile.place.share for tile in found.tiles)
    if total != 1:
        raise InputError("its tiles do not fill the box")
    return found


def _tile(entry: Mapping[str, Any]) -> Tile:
    return Tile(
        Place(tuple((int(step), int(level)) for step, level in entry["place"])),
        dict(entry["claims"]),
        dict(entry["reasons"]),
        {name: Stated.of(x["mid"], x["rad"], BITS) for name, x in entry["enclosures"].items()},
        tuple(map(float, entry["guess"])),
        bool(entry["looked_at"]),
    )
