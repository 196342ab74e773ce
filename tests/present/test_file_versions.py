"""A format of files whose content changes has another version."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, is_dataclass
from hashlib import sha256
from importlib import import_module
from pkgutil import iter_modules
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

import pytest

from nonsmooth.runtime.core.json_codec import Several
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.charting.problem import HeldOrbit
from nonsmooth.runtime.explore.charting.store import FORMAT
from nonsmooth.runtime.orbits import orbit_file
from nonsmooth.runtime.orbits.orbit import Orbit

# by format: the version, and a hash of the names and types of all entries. A test that fails
# here asks for a higher version of the format, or of what all files hold of a system
KNOWN = {
    "nonsmooth basin certificate": (5, "94d2816c0887"),
    "nonsmooth box certificate": (7, "9a29ce8ea32e"),
    "nonsmooth branch": (4, "66c3a2dfb4e2"),
    "nonsmooth census": (6, "e96ec67f86ec"),
    "nonsmooth certificate": (5, "e8f68e264464"),
    "nonsmooth certified branch": (5, "e710bf3ffbf5"),
    "nonsmooth certified doubling": (2, "14b7c3e7c0aa"),
    "nonsmooth chaos certificate": (5, "da5ba7744476"),
    "nonsmooth design": (2, "c8b1c1f8a88e"),
    "nonsmooth event certificate": (5, "17039143ba04"),
    "nonsmooth fit": (3, "f19d4d995297"),
    "nonsmooth found orbits": (7, "85aeb5e23e88"),
    "nonsmooth graph certificate": (5, "38c80f667b84"),
    "nonsmooth locus": (3, "cfb5b0d98246"),
    "nonsmooth orbit": (5, "70ec938e5df6"),
    "nonsmooth sweep": (4, "054f7f1f285f"),
    "nonsmooth trajectory": (5, "66b47a0db14b"),
}
CHART = ("nonsmooth chart 5", "2815ae59b2b9")


def entries_of(kind: Any) -> str:
    """Names and types of all entries of a record, of those in it too, as one text."""
    if isinstance(kind, type) and is_dataclass(kind) and kind is not Value:
        hints = get_type_hints(kind, localns={"Callable": Callable}, include_extras=True)
        known = {field.name for field in fields(kind)}
        return f"{{{', '.join(f'{n}: {entries_of(h)}' for n, h in hints.items() if n in known)}}}"
    arguments = get_args(kind)
    if get_origin(kind) is Annotated:
        several = [note.entries for note in arguments[1:] if isinstance(note, Several)]
        own_file = arguments[0] is Orbit  # of a version of its own
        return name_of(Orbit) if own_file else entries_of((*several, arguments[0])[0])
    if get_origin(kind) in (Union, UnionType):
        return " | ".join(map(entries_of, arguments))
    if arguments:
        return f"{name_of(get_origin(kind))}[{', '.join(map(entries_of, arguments))}]"
    return name_of(kind)


def digest(record: type) -> str:
    return sha256(entries_of(record).encode()).hexdigest()[:12]


def name_of(kind: Any) -> str:
    return kind.__name__ if isinstance(kind, type) else str(kind).rpartition(".")[2]


def formats() -> dict[str, FileFormat[Any]]:
    """Formats by their names, of all modules that write files."""
    files = "nonsmooth.runtime.present.files"
    names = [f"{files}.{module.name}" for module in iter_modules(import_module(files).__path__)]
    found = [
        entry
        for name in [*names, orbit_file.__name__]
        for entry in vars(import_module(name)).values()
        if isinstance(entry, FileFormat)
    ]
    return {entry.name: entry for entry in found}


def test_every_format_is_known() -> None:
    assert formats().keys() == KNOWN.keys()


@pytest.mark.parametrize("name", KNOWN)
def test_a_format_of_other_entries_has_another_version(name: str) -> None:
    found = formats()[name]
    assert (found.version, digest(found.entries)) == KNOWN[name], entries_of(found.entries)


def test_charts_hold_orbits_of_their_version() -> None:
    assert (FORMAT, digest(HeldOrbit)) == CHART, entries_of(HeldOrbit)
