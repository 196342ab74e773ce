"""A census in a file."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from nonsmooth.runtime.certification.counting.census import Bounds, Census, Counted, Open
from nonsmooth.runtime.certification.saved import certificate_content, certificate_of
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import read_file, write_file
from nonsmooth.runtime.saved import checksum_of, given_value

__all__ = ["FORMAT", "load_census", "save_census"]

FORMAT, VERSION = "nonsmooth census", 1
_LARGEST_FILE = 200_000_000  # bytes
_FOLLOW = ("count", "admissible", "decided", "statement")  # from the rest of the file


def save_census(census: Census, path: str | os.PathLike[str]) -> None:
    """Write a census to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    content: dict[str, Any] = {"format": FORMAT, "version": VERSION, **census.to_json()}
    for told, orbit in zip(content["orbits"], census.orbits, strict=True):
        if orbit.certificate is not None:
            told["certificate"] = certificate_content(orbit.certificate)
    content["sha256"] = checksum_of(content)
    write_file(Path(path), (json.dumps(content, indent=1, allow_nan=False) + "\n").encode())


def load_census(path: str | os.PathLike[str]) -> Census:
    """Read a census that `Census.save` wrote; nothing is proved again.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    try:
        try:
            content = json.loads(read_file(Path(path), _LARGEST_FILE, "census").decode("utf-8"))
        except (UnicodeDecodeError, json.JSONDecodeError, RecursionError):
            raise InputError("cut, or not JSON") from None
        return _census(content)
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as problem:
        raise InputError(f"{os.fspath(path)}: not in order: {problem}") from None


def _census(content: Any) -> Census:
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise InputError("not a census, such as --save writes")
    if content.get("version") != VERSION:
        raise InputError(f"version {content.get('version')!r} of the format is not known")
    if content["sha256"] != checksum_of(content):
        raise InputError("edited or damaged: the checksum differs")
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
    certificate = None if found is None else certificate_of(found)
    return Counted(_bounds(entry["unique"]), certificate, entry["reason"])


def _bounds(entry: Any) -> Bounds:
    return {str(name): (str(low), str(high)) for name, (low, high) in entry.items()}
