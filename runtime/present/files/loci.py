"""Curves of events in files, as branches are kept."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Annotated, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Row, one_of
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.explore.continuation.continue_event import Locus
from nonsmooth.runtime.explore.continuation.event import KINDS
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.present.files.orbits import orbit_content, orbit_in

__all__ = ["load_locus", "save_locus"]


@dataclass(frozen=True, kw_only=True)
class LocusEntries:
    """Entries of the file of a curve of events.

    The values of both parameters and of the unknowns have one row for each point. The entry
    `orbit` is the content of one orbit's file.
    """

    name: str
    kind: Annotated[str, one_of(tuple(KINDS))]
    boundary: str
    parameters: tuple[str, str]
    unknown_names: tuple[str, ...]
    values: Row
    unknowns: Row
    ends: tuple[str, str]
    start: int
    orbit: tuple[Any]


_LOCUS = FileFormat(
    name="nonsmooth locus", what="saved curve of events", entries=LocusEntries, version=2
)


def save_locus(locus: Locus, path: str | os.PathLike[str]) -> None:
    """Write a curve of events to a file, which is replaced only when the new one is complete."""
    own = {name: getattr(locus, name) for name in LocusEntries.__dataclass_fields__}
    name = named(locus.orbit.system, locus.name)[1]
    kept = {"name": name, "orbit": (orbit_content(locus.orbit),)}
    _LOCUS.write(path, LocusEntries(**{**own, **kept}))


def load_locus(path: str | os.PathLike[str]) -> Locus:
    """Read a curve of events that `Locus.save` wrote.

    An `InputError` with the file's name is raised if the file cannot be read, is cut,
    edited or foreign, or if its orbit does not belong to the installed system.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    >>> (flip,) = [event for event in branch.events if event.kind == "flip"]
    >>> ns.continue_event(branch, flip, "eta", (3.95, 4.05)).save("flips.json")
    >>> ns.load("flips.json").parameters
    ('V', 'eta')
    """
    with naming(path) as file:
        return _locus(_LOCUS.read(file))


def _locus(entries: LocusEntries) -> Locus:
    orbit = orbit_in(entries.orbit[0])
    values = entries.values.reshape(-1, 2)
    unknowns = entries.unknowns.reshape(-1, len(entries.unknown_names))
    if len(unknowns) != len(values) or not 0 <= entries.start < len(values):
        raise InputError("its points do not belong together")
    own = {"name": orbit.name, "values": values, "unknowns": unknowns, "orbit": orbit}
    return Locus(**{**vars(entries), **own})
