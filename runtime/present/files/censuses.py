"""A census in a file."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.present.files.certificates import (
    certificate_content,
    certificate_of,
    check_certificate_entries,
)
from nonsmooth.runtime.present.files.orbit_numbers import given_value
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.counting.census import Bounds, Census, Counted, Open

__all__ = [
    "CENSUS",
    "census_entries",
    "census_of",
    "load_census",
    "save_census",
]

CENSUS = Form(
    "nonsmooth census",
    "census",
    {
        "orbit": str,
        "system": str,
        "parameters": dict,
        "itinerary": list,
        "box": list,
        "conditions": list,
        "count": int,
        "admissible": int,
        "decided": bool,
        "statement": str,
        "orbits": list,
        "beyond": int,
        "undecided": list,
        "looked": int,
        "bits": int,
    },
    VERSION,
)
_FOLLOW = ("count", "admissible", "decided", "statement")  # from the rest of the file


def save_census(census: Census, path: str | os.PathLike[str]) -> None:
    """Write a census to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    CENSUS.write(path, census_entries(census))


def census_entries(census: Census) -> dict[str, Any]:
    """What a census' file states."""
    content = census.to_json()
    for told, orbit in zip(content["orbits"], census.orbits, strict=True):
        if orbit.certificate is not None:
            told["certificate"] = certificate_content(orbit.certificate)
    return content


def load_census(path: str | os.PathLike[str]) -> Census:
    """Read a census that `Census.save` wrote; nothing is proved again.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    with naming(path) as file:
        return census_of(CENSUS.read(file))


def census_of(content: Mapping[str, Any]) -> Census:
    """The census that a file's entries describe.

    Raises
    ------
    InputError
        If what is counted does not follow from the orbits.
    """
    census = Census(
        content["orbit"],
        content["system"],
        {name: given_value(name, text) for name, text in content["parameters"].items()},
        tuple((str(c), str(b)) for c, b in content["itinerary"]),
        tuple(content["box"]),
        tuple(content["conditions"]),
        tuple(_counted(entry) for entry in content["orbits"]),
        content["beyond"],
        tuple(Open(_bounds(box["bounds"]), box["reason"]) for box in content["undecided"]),
        content["looked"],
        content["bits"],
    )
    told = census.to_json()
    for name in _FOLLOW:
        if content[name] != told[name]:
            raise InputError(f"{name!r} is not what the orbits give")
    return census


def _counted(entry: Any) -> Counted:
    found = entry["certificate"]
    if found is not None:
        check_certificate_entries(found)
    certificate = None if found is None else certificate_of(found)
    return Counted(_bounds(entry["unique"]), certificate, entry["reason"])


def _bounds(entry: Any) -> Bounds:
    return {str(name): (str(low), str(high)) for name, (low, high) in entry.items()}
