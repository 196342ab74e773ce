"""A format of files whose content changes has another version."""

from __future__ import annotations

import json
from hashlib import sha256
from typing import Any

import pytest

from nonsmooth.runtime.core.json_codec import json_schema
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.explore.charting.problem import HeldOrbit
from nonsmooth.runtime.explore.charting.store import FORMAT
from nonsmooth.runtime.orbits.orbit_file import ORBIT
from nonsmooth.runtime.present.files.found import FOUND
from nonsmooth.runtime.present.files.kept import KINDS, format_named
from nonsmooth.runtime.present.files.motions import MOTION

# by format: the version, and a hash of the names and types of all entries. A test that fails
# here asks for a higher version of the format, or of what all files hold of a system
KNOWN = {
    "nonsmooth basin certificate": (6, "9ba0044c909d"),
    "nonsmooth box certificate": (8, "40c1e1c780af"),
    "nonsmooth branch": (4, "7b15a71a1111"),
    "nonsmooth census": (6, "a8b6b138fbb8"),
    "nonsmooth certificate": (6, "dc472e9a0497"),
    "nonsmooth certified branch": (6, "70dd986b9e16"),
    "nonsmooth certified doubling": (3, "f9ffaf6af930"),
    "nonsmooth chaos certificate": (6, "54dfa7e8d7db"),
    "nonsmooth design": (2, "d033c77ba4e1"),
    "nonsmooth event certificate": (6, "1d32e51b8c01"),
    "nonsmooth fit": (3, "1951f1e33ffd"),
    "nonsmooth found orbits": (7, "25a4d6167507"),
    "nonsmooth region certificate": (6, "73018302bf92"),
    "nonsmooth locus": (3, "7b5986b03154"),
    "nonsmooth orbit": (5, "b1eafab06be8"),
    "nonsmooth sweep": (4, "f22b34cb7ed3"),
    "nonsmooth trajectory": (5, "e72e037a1615"),
}
CHART = ("nonsmooth chart 5", "b40f284c1037")


def unordered(entry: Any) -> Any:
    """A schema whose names of required entries are sorted, as the order of entries says nothing."""
    if isinstance(entry, list):
        return [unordered(part) for part in entry]
    if not isinstance(entry, dict):
        return entry
    found = {name: unordered(part) for name, part in entry.items()}
    return found | {n: sorted(part) for n, part in found.items() if n == "required" and part}


def digest(record: type) -> str:
    """A hash of the names and types of all entries."""
    schema = unordered(json_schema(record))
    return sha256(json.dumps(schema, sort_keys=True).encode()).hexdigest()[:12]


def formats() -> dict[str, FileFormat[Any]]:
    """Formats of all kinds of files, by their names."""
    found = [*map(format_named, KINDS), ORBIT, FOUND, MOTION]
    return {entry.name: entry for entry in found}


def test_every_format_is_known() -> None:
    assert formats().keys() == KNOWN.keys()


@pytest.mark.parametrize("name", KNOWN)
def test_a_format_of_other_entries_has_another_version(name: str) -> None:
    found = formats()[name]
    assert (found.version, digest(found.entries)) == KNOWN[name], json_schema(found.entries)


def test_charts_hold_orbits_of_their_version() -> None:
    assert (FORMAT, digest(HeldOrbit)) == CHART, json_schema(HeldOrbit)
