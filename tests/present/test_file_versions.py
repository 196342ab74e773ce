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
    "nonsmooth basin certificate": (6, "1c6132538e83"),
    "nonsmooth box certificate": (8, "36d5e1ed82fe"),
    "nonsmooth branch": (4, "b8aed0dfa463"),
    "nonsmooth census": (6, "fc35c9745b8c"),
    "nonsmooth certificate": (6, "b6867ccc646d"),
    "nonsmooth certified branch": (6, "3d0a27190011"),
    "nonsmooth certified doubling": (3, "cd5e8bad0d36"),
    "nonsmooth chaos certificate": (6, "5a710bd176cd"),
    "nonsmooth design": (2, "fdd029d0e2a2"),
    "nonsmooth event certificate": (6, "89c3683b9584"),
    "nonsmooth fit": (3, "06c6752de145"),
    "nonsmooth found orbits": (7, "5fd322d3dc16"),
    "nonsmooth region certificate": (6, "5999d5f4af94"),
    "nonsmooth locus": (3, "0e044381135f"),
    "nonsmooth orbit": (5, "1e25f945e98f"),
    "nonsmooth sweep": (4, "61d447ca3040"),
    "nonsmooth trajectory": (5, "88489b2dee45"),
}
CHART = ("nonsmooth chart 5", "553f0d81bd46")


def digest(record: type) -> str:
    """A hash of the names and types of all entries."""
    return sha256(json.dumps(json_schema(record), sort_keys=True).encode()).hexdigest()[:12]


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
