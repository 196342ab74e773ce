"""Branches in files.

The orbit that the branch was followed from is in the file too, and is checked as a saved orbit
is.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyComplex, AnyRow, Flags, Row
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.present.files.orbits import orbit_content, orbit_in

__all__ = ["load_branch", "save_branch"]


@dataclass(frozen=True, kw_only=True)
class BranchEntries:
    """Entries of the file of a branch.

    The arrays have one row for each point: the parameter's value, unknowns, period,
    multipliers and trace. The entry `orbit` is the content of one orbit's file.
    """

    name: str
    parameter: str
    unknown_names: tuple[str, ...]
    columns: tuple[Row, Row, Row, AnyComplex, AnyRow]
    stability: tuple[str, ...]
    admissible: Flags
    events: tuple[Event, ...]
    ends: tuple[str, str]
    start: int
    orbit: tuple[Any]


_BRANCH = FileFormat(name="nonsmooth branch", what="saved branch", entries=BranchEntries, version=3)

_VERDICTS = {"stable", "neutral", "unstable", "undecided"}


def save_branch(branch: Branch, path: str | os.PathLike[str]) -> None:
    """Write a branch to a file, which is replaced only when the new one is complete."""
    columns = (
        branch.parameter_values,
        branch.unknowns,
        branch.period,
        branch.multipliers,
        branch.trace,
    )
    entries = BranchEntries(
        name=named(branch.orbit.system, branch.name)[1],
        parameter=branch.parameter,
        unknown_names=branch.unknown_names,
        columns=columns,
        stability=branch.stability,
        admissible=branch.admissible,
        events=branch.events,
        ends=branch.ends,
        start=branch.start,
        orbit=(orbit_content(branch.orbit),),
    )
    _BRANCH.write(path, entries)


def load_branch(path: str | os.PathLike[str]) -> Branch:
    """Read a branch that `Branch.save` wrote.

    An `InputError` with the file's name is raised if the file cannot be read, is cut,
    edited or foreign, or if its orbit does not belong to the installed system.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/global-stick")
    >>> ns.continue_orbit(orbit, "V", (0.95, 1.05)).save("branch.json")
    >>> ns.load("branch.json").parameter
    'V'
    """
    with naming(path) as file:
        return _branch(_BRANCH.read(file))


def _branch(entries: BranchEntries) -> Branch:
    orbit = orbit_in(entries.orbit[0])
    values, unknowns, period, multipliers, trace = entries.columns
    count, names = len(values), entries.unknown_names
    rows = (period, trace, entries.stability, entries.admissible)
    if not 0 <= entries.start < count or any(len(row) != count for row in rows):
        raise InputError("its points do not belong together")
    if entries.parameter not in orbit.given:
        raise InputError(f"its orbit has no parameter {entries.parameter!r}")
    if names != tuple(OrbitFamily(orbit, entries.parameter).names):
        raise InputError("its unknowns are not those of its orbit")
    if not set(entries.stability) <= _VERDICTS:
        raise InputError("a verdict is none")
    for event in entries.events:
        if tuple(event.unknowns) != names or event.parameter != entries.parameter:
            raise InputError(f"the {event.kind} is not one of its orbit")
        if not 0 <= event.place <= count - 1:
            raise InputError(f"the {event.kind} is at no place of it")
    return Branch(
        name=orbit.name,
        parameter=entries.parameter,
        parameter_values=values,
        unknown_names=names,
        unknowns=unknowns.reshape(count, len(names)),
        period=period,
        multipliers=multipliers.reshape(count, -1),
        trace=trace,
        stability=entries.stability,
        admissible=entries.admissible,
        events=entries.events,
        ends=entries.ends,
        start=entries.start,
        orbit=orbit,
    )
