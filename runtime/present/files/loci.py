"""Curves of events in files, as branches are kept."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.explore.continuation.event import KINDS
from nonsmooth.runtime.explore.continuation.locus import Locus
from nonsmooth.runtime.present.files.branches import numbers_of, orbit_entries, texts_of
from nonsmooth.runtime.present.files.orbits import orbit_in

__all__ = ["load_locus", "save_locus"]

_FORM = Form(
    "nonsmooth locus",
    "saved curve of events",
    {
        "name": str,
        "kind": str,
        "boundary": str,
        "parameters": list,
        "unknown_names": list,
        "values": list,
        "unknowns": list,
        "ends": list,
        "start": int,
        "orbit": list,
    },
)


def save_locus(locus: Locus, path: str | os.PathLike[str]) -> None:
    """Write a curve of events to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    _FORM.write(
        path,
        {
            "name": locus.name,
            "kind": locus.kind,
            "boundary": locus.boundary,
            "parameters": list(locus.parameters),
            "unknown_names": list(locus.unknown_names),
            "values": texts_of(locus.values),
            "unknowns": texts_of(locus.unknowns),
            "ends": list(locus.ends),
            "start": locus.start,
            "orbit": [orbit_entries(locus.orbit)],
        },
    )


def load_locus(path: str | os.PathLike[str]) -> Locus:
    """Read a curve of events that `Locus.save` wrote.

    Raises
    ------
    InputError
        If the file cannot be read, is cut, edited or foreign, or the orbit in it is none of
        the system that is there. The message names the file.
    """
    with naming(path) as file:
        return _locus(_FORM.read(file), file.parent)


def _locus(content: dict[str, Any], folder: Path) -> Locus:
    (entries,) = content["orbit"]
    orbit = orbit_in(entries, folder)
    if content["kind"] not in KINDS:
        raise InputError(f"{content['kind']!r} is no kind of event")
    values, names = numbers_of(content["values"]), tuple(content["unknown_names"])
    first, second = content["parameters"]
    before, behind = content["ends"]
    return Locus(
        orbit.name,
        content["kind"],
        content["boundary"],
        (first, second),
        values.real.reshape(-1, 2),
        names,
        numbers_of(content["unknowns"]).real.reshape(-1, len(names)),
        (before, behind),
        content["start"],
        orbit,
    )
