"""Periodic orbits that were found, as JSON, in files, and read again."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Digits, FromOne, Integers, Row, Table, decode, encode
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.explore.finding.solved import Equilibrium, equilibria, same_state
from nonsmooth.runtime.model.kernels import SystemKernels, known_system
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, KeptSystem
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_file import check_solves
from nonsmooth.runtime.orbits.table_solve import solve_itinerary


@dataclass(frozen=True, kw_only=True)
class FoundOrbitEntries:
    """Entries for an orbit; `mirror` is the number, from 1, of the orbit that it mirrors."""

    itinerary: tuple[tuple[str, str], ...]
    dwell_times: Row
    states: Table  # where the phases begin
    residual: Digits
    mirror: FromOne


@dataclass(frozen=True, kw_only=True)
class FoundEquilibriumEntries:
    """Entries for an equilibrium; `mirror` counts equilibria alone."""

    configuration: str
    state: Mapping[str, Digits]
    mirror: FromOne


@dataclass(frozen=True, kw_only=True)
class FoundEntries:
    """Entries of the file of found orbits: with every start, and the label that says all shares."""

    system: KeptSystem
    parameters: Mapping[str, Value]
    orbits: tuple[FoundOrbitEntries, ...]
    equilibria: tuple[FoundEquilibriumEntries, ...]
    starts: Table
    labels: Integers
    box: Mapping[str, tuple[Digits, Digits]]  # by the names of the states
    transitions: int
    complete: bool


FOUND = FileFormat(
    name="nonsmooth found orbits",
    what="file of found orbits",
    entries=FoundEntries,
    version=5 + SAVED_VERSION,
    most=200_000_000,
)


def save_found(found: Found, path: str | os.PathLike[str]) -> None:
    """Write the orbits found from many starts to a JSON file, with every start and its label."""
    FOUND.write(path, _entries(found))


def load_found(path: str | os.PathLike[str]) -> Found:
    """Read a result that `Found.save` wrote, with the same numbers.

    Each orbit and equilibrium is checked against the installed system. One that fails is
    replaced by the reason, which is raised when it is asked for; the others stay. An
    `InputError` with the file's name is raised if the file cannot be read, or is cut,
    edited or foreign.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> ns.find_orbits("dry-friction", data, n=20, transitions=200).save("found.json")
    >>> len(ns.load("found.json").orbits)
    1
    """
    with naming(path) as file:
        return _found(file, FOUND.read(file))


def found_orbit(path: str | os.PathLike[str], number: int | None = None) -> Orbit:
    """Read one orbit of a file that `Found.save` wrote, whatever the others are.

    The number counts from 1, and is optional if there is one orbit. `InputError` is raised
    if there is no such orbit, or as by `load_found`.
    """
    with naming(path) as file:
        entries = FOUND.read(file)
        count, name = len(entries.orbits), file.name
        known = f"{name}:1" if count == 1 else f"{name}:1 ... {name}:{count}"
        if not count:
            raise InputError("holds no orbit: none was found")
        if number is None and count > 1:
            raise InputError(f"holds {count} orbits: say which, {known}")
        place = 1 if number is None else number
        if not 1 <= place <= count:
            raise InputError(f"holds no orbit {place}; there is {known}")
        return _orbit(entries, place - 1, system_parameters(entries.system, entries.parameters))


def found_system(path: str | os.PathLike[str]) -> tuple[SystemKernels, int]:
    """Read the system of a file that `Found.save` wrote, and the number of its orbits.

    `InputError` is raised as by `load_found`.
    """
    entries = FOUND.load(path)
    return entries.system, len(entries.orbits)


def held_found(path: str | os.PathLike[str]) -> str:
    """The attractors of a file of found orbits, as JSON text that a store holds.

    Of the starts the first that led to each of them is kept. `InputError` is raised as by
    `load_found`.
    """
    found = load_found(path)
    _, first = np.unique(found.labels, return_index=True)
    first.sort()
    few = replace(found, starts=found.starts[first], labels=found.labels[first])
    return json.dumps(encode(_entries(few)))


def found_held(text: str) -> tuple[SystemKernels, Found]:
    """The system and its found orbits, from a text of `held_found`.

    `InputError` is raised, with a message of one line, if the data are not in order.
    """
    entries = decode(FoundEntries, json.loads(text))
    return entries.system, _found("attractors", entries)


def _entries(found: Found) -> FoundEntries:
    orbits = [entry.orbit for entry in found.orbits]
    return FoundEntries(
        system=orbits[0].system if orbits else known_system(found.system),
        parameters=found.parameters,
        orbits=tuple(
            FoundOrbitEntries(
                itinerary=orbit.itinerary,
                dwell_times=orbit.dwell_times,
                states=orbit.states,
                residual=orbit.residual,
                mirror=entry.mirror,
            )
            for entry, orbit in zip(found.orbits, orbits, strict=True)
        ),
        equilibria=tuple(
            FoundEquilibriumEntries(
                configuration=entry.equilibrium.configuration,
                state=dict(zip(found.names, entry.equilibrium.state.tolist(), strict=True)),
                mirror=entry.mirror,
            )
            for entry in found.equilibria
        ),
        starts=found.starts,
        labels=found.labels,
        box=dict(zip(found.names, found.box.tolist(), strict=True)),
        transitions=found.transitions,
        complete=found.complete,
    )


def _found(where: str | Path, entries: FoundEntries) -> Found:
    """The result that entries describe, with a reason for each orbit that the system lacks."""
    kernels, labels = entries.system, entries.labels
    parameters = system_parameters(kernels, entries.parameters)
    names = tuple(kernels.table["states"])
    count = len(entries.orbits) + len(entries.equilibria)
    if (
        entries.starts.shape != (len(labels), len(names))
        or not ((labels < count) & (labels >= min(Outcome))).all()
    ):
        raise InputError("its starts and labels do not belong together")
    if tuple(entries.box) != names:
        raise InputError("'box' is not of the system's states")

    def read(
        kind: Callable[..., Any], parts: Sequence[Any], make: Callable[[int], Any], before: int
    ) -> tuple[Any, ...]:
        found = []
        for place, part in enumerate(parts):
            starts, mirror = int((labels == before + place).sum()), part.mirror
            solved: Any
            try:
                with naming(where):
                    solved = make(place)
            except InputError as problem:
                solved, mirror = str(problem), None
            found.append(kind(solved, starts, starts / len(labels), mirror))
        return tuple(found)

    known = {e.configuration: e for e in equilibria(piecewise(kernels, parameters))}
    return Found(
        kernels.name,
        parameters,
        names,
        read(FoundOrbit, entries.orbits, lambda k: _orbit(entries, k, parameters), 0),
        read(
            FoundEquilibrium,
            entries.equilibria,
            lambda k: _equilibrium(entries, k, known),
            len(entries.orbits),
        ),
        entries.starts,
        labels,
        np.array(list(entries.box.values())),
        entries.transitions,
        entries.complete,
    )


def _orbit(entries: FoundEntries, place: int, parameters: dict[str, Value]) -> Orbit:
    """The orbit at a place, with the file's numbers; `InputError` if the system has none such."""
    entry, kernels = entries.orbits[place], entries.system
    count = len(entry.itinerary)
    try:
        if not count or entry.states.shape != (count, len(kernels.table["states"])):
            raise InputError(f"none of the states of {kernels.name}")
        if len(entry.dwell_times) != count:
            raise InputError("its phases and dwell times do not belong together")
        orbit = solve_itinerary(
            kernels,
            parameters,
            entry.itinerary,
            entry.dwell_times,
            known=(entry.states, entry.residual),
        )
        check_solves(orbit)
        if not orbit.converged:
            raise InputError(orbit.message)
        _check_mirror(entry.mirror, place)
    except InputError as problem:
        period = float(entry.dwell_times.sum())
        raise InputError(f"orbit {place + 1}, of period {period!r}: {problem}") from None
    return orbit


def _equilibrium(
    entries: FoundEntries, place: int, known: Mapping[str, Equilibrium]
) -> Equilibrium:
    """The equilibrium at a place, among those `known` by configuration."""
    entry = entries.equilibria[place]
    equilibrium = known.get(entry.configuration)
    try:
        if (
            equilibrium is None
            or tuple(entry.state) != equilibrium.names
            or not same_state(equilibrium.state, np.array([*entry.state.values()]))
        ):
            raise InputError("there is no such equilibrium")
        _check_mirror(entry.mirror, place)
    except InputError as problem:
        number = len(entries.orbits) + place + 1
        raise InputError(f"equilibrium {number}, in {entry.configuration!r}: {problem}") from None
    return equilibrium


def _check_mirror(mirror: int | None, place: int) -> None:
    """Refuse a mirror image of what is not before the entry at a place, or itself."""
    if mirror is not None and not 0 <= mirror <= place:
        raise InputError("a mirror image is of no entry before it")
