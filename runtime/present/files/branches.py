"""Branches in files: JSON with every digit, refused when it is cut, edited or foreign.

Numbers are decimal strings that give back the very same doubles. The orbit that the branch
was followed from is in the file too, and is checked as a saved orbit is.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import KINDS, Event
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.files.orbits import orbit_content, orbit_in

__all__ = ["load_branch", "numbers_of", "orbit_entries", "save_branch", "texts_of"]

_FORM = Form(
    "nonsmooth branch",
    "saved branch",
    {
        "name": str,
        "parameter": str,
        "unknown_names": list,
        "columns": list,
        "stability": list,
        "admissible": list,
        "events": list,
        "ends": list,
        "start": int,
        "orbit": list,
    },
    version=2,
)
_COLUMNS = ("parameter_values", "unknowns", "period", "multipliers", "trace")


def save_branch(branch: Branch, path: str | os.PathLike[str]) -> None:
    """Write a branch to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    _FORM.write(
        path,
        {
            "name": branch.name,
            "parameter": branch.parameter,
            "unknown_names": list(branch.unknown_names),
            "columns": [texts_of(getattr(branch, name)) for name in _COLUMNS],
            "stability": list(branch.stability),
            "admissible": branch.admissible.tolist(),
            "events": [_entries(event) for event in branch.events],
            "ends": list(branch.ends),
            "start": branch.start,
            "orbit": [orbit_entries(branch.orbit)],
        },
    )


def load_branch(path: str | os.PathLike[str]) -> Branch:
    """Read a branch that `Branch.save` wrote.

    Raises
    ------
    InputError
        If the file cannot be read, is cut, edited or foreign, or the orbit in it is none of
        the system that is there. The message names the file.
    """
    with naming(path) as file:
        return _branch(_FORM.read(file), file.parent)


def _branch(content: dict[str, Any], folder: Path) -> Branch:
    (entries,) = content["orbit"]
    orbit = orbit_in(entries, folder)
    values, unknowns, period, multipliers, trace = map(numbers_of, content["columns"])
    names = tuple(content["unknown_names"])
    count = len(values)
    return Branch(
        orbit.name,
        content["parameter"],
        values.real,
        names,
        unknowns.real.reshape(count, len(names)),
        period.real,
        multipliers.reshape(count, -1),
        trace.real,
        tuple(content["stability"]),
        np.array(content["admissible"], dtype=bool),
        tuple(_event(entry) for entry in content["events"]),
        (content["ends"][0], content["ends"][1]),
        content["start"],
        orbit,
    )


def orbit_entries(orbit: Orbit) -> dict[str, Any]:
    """Entries of the file of an orbit of either kind."""
    return orbit_content(orbit)


def texts_of(array: np.ndarray) -> list[str]:
    """Numbers, row by row, as decimal texts of real and imaginary parts."""
    return [
        f"{float(x.real)!r} {float(x.imag)!r}" if x.imag else repr(float(x.real))
        for x in np.ravel(array).tolist()
    ]


def numbers_of(texts: Sequence[str]) -> np.ndarray:
    """The complex numbers of such texts."""
    parts = (tuple(map(float, text.split())) for text in texts)
    return np.array([complex(*pair) for pair in parts], dtype=complex)


def _entries(event: Event) -> dict[str, Any]:
    found = {field.name: getattr(event, field.name) for field in fields(event)}
    phase = None if event.phase is None else event.phase + 1
    return {**found, "unknowns": dict(event.unknowns), "phase": phase}


def _event(entry: Any) -> Event:
    if entry["kind"] not in KINDS:
        raise InputError(f"{entry['kind']!r} is no kind of event")
    phase = None if entry["phase"] is None else entry["phase"] - 1
    return Event(**{**entry, "phase": phase})
