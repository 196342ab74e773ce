"""Periodic orbits that were found, as JSON, in files, and read again."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits, Integers, Table, decode, encode
from nonsmooth.runtime.core.result_files import FileFormat, check_follows, naming
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.finding.found import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.explore.finding.steady import Equilibrium, equilibria, same_state
from nonsmooth.runtime.model.completion import system_parameters
from nonsmooth.runtime.model.kernels import SystemKernels, known_system
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, system_in
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.present.files.table_orbits import check_solves

__all__ = [
    "FOUND",
    "found_held",
    "found_json",
    "found_orbit",
    "found_system",
    "held_found",
    "load_found",
    "save_found",
]


@dataclass(frozen=True, kw_only=True)
class FoundPhaseEntries:
    """Entries for a phase of an orbit: its configuration, start, dwell time and boundary."""

    configuration: str
    boundary: str
    dwell_time: Digits
    start: Mapping[str, Digits]


@dataclass(frozen=True, kw_only=True)
class MultiplierEntries:
    """Entries for a multiplier of the Poincaré map."""

    re: AnyDigits
    im: AnyDigits
    trivial: bool


@dataclass(frozen=True, kw_only=True)
class EigenvalueEntries:
    """Entries for an eigenvalue of an equilibrium."""

    re: Digits
    im: Digits


@dataclass(frozen=True, kw_only=True)
class FoundOrbitEntries:
    """Entries for an orbit; `mirror_of` is the number, from 1, of the entry that it mirrors."""

    period: Digits
    forcing_periods: tuple[int, ...]
    stability: str
    starts: int
    share: Digits
    itinerary: tuple[FoundPhaseEntries, ...]
    multipliers: tuple[MultiplierEntries, ...]
    trace: AnyDigits
    residual: Digits
    admissible: Any
    mirror_of: int | None
    symmetric: bool


@dataclass(frozen=True, kw_only=True)
class FoundEquilibriumEntries:
    """Entries for an equilibrium; in the numbers of `mirror_of` the orbits come first."""

    configuration: str
    stability: str
    starts: int
    share: Digits
    state: Mapping[str, Digits]
    eigenvalues: tuple[EigenvalueEntries, ...]
    mirror_of: int | None
    symmetric: bool


@dataclass(frozen=True, kw_only=True)
class FoundSummary:
    """Entries for the orbits, their basins, and the shares of all outcomes."""

    system: str
    parameters: Mapping[str, Value]
    starts: int
    transitions: int
    complete: bool
    box: Mapping[str, tuple[Digits, Digits]]
    orbits: tuple[FoundOrbitEntries, ...]
    equilibria: tuple[FoundEquilibriumEntries, ...]
    outcomes: Mapping[str, Digits]
    resting: Digits
    unclassified: Digits


@dataclass(frozen=True, kw_only=True)
class FoundEntries(FoundSummary):
    """Entries of the file of found orbits: the summary, with every start and its label."""

    tables: SavedSystem | None
    start_states: Table
    labels: Integers


FOUND = FileFormat(
    name="nonsmooth found orbits",
    what="file of found orbits",
    entries=FoundEntries,
    version=4 + SAVED_VERSION,
    most=200_000_000,
)


def found_json(found: Found) -> dict[str, Any]:
    """Orbits, basins and shares as JSON; numbers are decimal strings of the exact doubles."""
    return encode(_summary(found))


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
        entries = FOUND.read(file)
        return _found(file, entries, system_in(entries.system, entries.tables))


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
        kernels = system_in(entries.system, entries.tables)
        parameters = system_parameters(kernels, entries.parameters)
        return _orbit(entries, place - 1, kernels, parameters).orbit


def found_system(path: str | os.PathLike[str]) -> tuple[SystemKernels, int]:
    """Read the system of a file that `Found.save` wrote, and the number of its orbits.

    `InputError` is raised as by `load_found`.
    """
    with naming(path) as file:
        entries = FOUND.read(file)
        return system_in(entries.system, entries.tables), len(entries.orbits)


def held_found(path: str | os.PathLike[str]) -> str:
    """The attractors of a file of found orbits, as JSON text that a store holds.

    Only the first of the starts is kept. `InputError` is raised as by `load_found`.
    """
    with naming(path) as file:
        entries = FOUND.read(file)
        found = _found(file, entries, system_in(entries.system, entries.tables))
        first = replace(found, starts=found.starts[:1], labels=found.labels[:1])
        return json.dumps(encode(_entries(first)))


def found_held(text: str) -> tuple[SystemKernels, Found]:
    """The system and its found orbits, from a text of `held_found`.

    `InputError` is raised, with a message of one line, if the data are not in order.
    """
    entries = decode(FoundEntries, json.loads(text))
    kernels = system_in(entries.system, entries.tables)
    return kernels, _found("attractors", entries, kernels)


def _summary(found: Found) -> FoundSummary:
    return FoundSummary(
        system=found.system,
        parameters=found.parameters,
        transitions=found.transitions,
        complete=found.complete,
        box=dict(zip(found.names, found.box.tolist(), strict=True)),
        orbits=tuple(_orbit_entries(found, place) for place in range(len(found.orbits))),
        equilibria=tuple(
            _equilibrium_entries(found, place) for place in range(len(found.equilibria))
        ),
        **_shares(found),
    )


def _shares(found: Found) -> dict[str, Any]:
    """The counts and shares that follow from the labels of the starts."""
    return {
        "starts": len(found.starts),
        "outcomes": {o.name.lower(): found.share(o) for o in found.outcomes},
        "resting": found.resting,
        "unclassified": found.unclassified,
    }


def _entries(found: Found) -> FoundEntries:
    orbits = [entry.orbit for entry in found.orbits]
    kernels = orbits[0].system if orbits else known_system(found.system)
    system, _, saved = named(kernels)
    return FoundEntries(
        **{**vars(_summary(found)), "system": system},
        tables=saved,
        start_states=found.starts,
        labels=found.labels,
    )


def _orbit_entries(found: Found, place: int) -> FoundOrbitEntries:
    entry = found.orbits[place]
    orbit = entry.orbit
    phases = zip(entry.itinerary, orbit.dwell_times.tolist(), orbit.states.tolist(), strict=True)
    return FoundOrbitEntries(
        period=entry.period,
        forcing_periods=entry.forcing_periods,
        stability=entry.verdict,
        starts=entry.starts,
        share=entry.share,
        itinerary=tuple(
            FoundPhaseEntries(
                configuration=configuration,
                boundary=boundary,
                dwell_time=duration,
                start=dict(zip(found.names, start, strict=True)),
            )
            for (configuration, boundary), duration, start in phases
        ),
        multipliers=tuple(
            MultiplierEntries(re=float(m.real), im=float(m.imaginary), trivial=m.trivial)
            for m in orbit.stability.multipliers
        ),
        trace=float(orbit.stability.trace),
        residual=float(orbit.residual),
        admissible=orbit.admissibility.verdict,
        mirror_of=_mirror_of(entry.mirror, place, 0),
        symmetric=entry.mirror == place,
    )


def _equilibrium_entries(found: Found, place: int) -> FoundEquilibriumEntries:
    entry = found.equilibria[place]
    equilibrium = entry.equilibrium
    return FoundEquilibriumEntries(
        configuration=equilibrium.configuration,
        stability=equilibrium.verdict,
        starts=entry.starts,
        share=entry.share,
        state=dict(zip(found.names, equilibrium.state.tolist(), strict=True)),
        eigenvalues=tuple(
            EigenvalueEntries(re=value.real, im=value.imag)
            for value in equilibrium.eigenvalues.tolist()
        ),
        mirror_of=_mirror_of(entry.mirror, place, len(found.orbits)),
        symmetric=entry.mirror == place,
    )


def _mirror_of(mirror: int | None, place: int, before: int) -> int | None:
    """Number, from 1, of the entry that this one mirrors; None for none or itself."""
    return None if mirror in (None, place) else mirror + before + 1


def _found(where: str | Path, entries: FoundEntries, kernels: SystemKernels) -> Found:
    """The result that entries describe, with a reason for each orbit that the system lacks."""
    parameters = system_parameters(kernels, entries.parameters)
    orbits: list[FoundOrbit] = []
    for place, orbit in enumerate(entries.orbits):
        try:
            with naming(where):
                orbits.append(_orbit(entries, place, kernels, parameters))
        except InputError as problem:
            orbits.append(FoundOrbit(str(problem), orbit.starts, orbit.share))
    known = {e.configuration: e for e in equilibria(piecewise(kernels, parameters))}
    steady: list[FoundEquilibrium] = []
    for place, entry in enumerate(entries.equilibria):
        try:
            with naming(where):
                steady.append(_equilibrium(entries, place, known))
        except InputError as problem:
            steady.append(FoundEquilibrium(str(problem), entry.starts, entry.share))
    names = tuple(kernels.table["states"])
    starts, labels = entries.start_states, entries.labels
    if (
        starts.shape != (len(labels), len(names))
        or (labels >= len(orbits) + len(steady)).any()
        or (labels < min(Outcome)).any()
    ):
        raise InputError("its starts and labels do not belong together")
    if tuple(entries.box) != names:
        raise InputError("'box' is not of the system's states")
    found = Found(
        kernels.name,
        parameters,
        names,
        tuple(orbits),
        tuple(steady),
        starts,
        labels,
        np.array(list(entries.box.values())),
        entries.transitions,
        entries.complete,
    )
    check_follows(entries, _shares(found))
    return found


def _orbit(
    entries: FoundEntries, place: int, kernels: SystemKernels, parameters: dict[str, Value]
) -> FoundOrbit:
    """The orbit at a place, with the file's numbers; `InputError` if the system has none such."""
    entry = entries.orbits[place]
    names = tuple(kernels.table["states"])
    itinerary = tuple((phase.configuration, phase.boundary) for phase in entry.itinerary)
    dwell = np.array([phase.dwell_time for phase in entry.itinerary])
    try:
        if not itinerary or any(tuple(phase.start) != names for phase in entry.itinerary):
            raise InputError(f"none of the states of {kernels.name}")
        states = np.array([list(phase.start.values()) for phase in entry.itinerary])
        known = states, entry.residual
        orbit = solve_itinerary(kernels, parameters, itinerary, dwell, known=known)
        check_solves(orbit)
        if not orbit.converged:
            raise InputError(orbit.message)
        mirror = _mirror(entry, place, 0)
    except InputError as problem:
        raise InputError(f"orbit {place + 1}, of period {entry.period!r}: {problem}") from None
    return FoundOrbit(orbit, entry.starts, entry.share, mirror)


def _equilibrium(
    entries: FoundEntries, place: int, known: Mapping[str, Equilibrium]
) -> FoundEquilibrium:
    """The equilibrium at a place, among those `known` by configuration."""
    entry, before = entries.equilibria[place], len(entries.orbits)
    equilibrium = known.get(entry.configuration)
    try:
        if equilibrium is None or not _same_state(equilibrium, entry.state):
            raise InputError("there is no such equilibrium")
        mirror = _mirror(entry, place, before)
    except InputError as problem:
        named = f"equilibrium {before + place + 1}, in {entry.configuration!r}"
        raise InputError(f"{named}: {problem}") from None
    return FoundEquilibrium(equilibrium, entry.starts, entry.share, mirror)


def _same_state(equilibrium: Equilibrium, state: Mapping[str, float]) -> bool:
    """Whether a state is that of an equilibrium."""
    return tuple(state) == equilibrium.names and same_state(
        equilibrium.state, np.array([*state.values()])
    )


def _mirror(
    entry: FoundOrbitEntries | FoundEquilibriumEntries, place: int, before: int
) -> int | None:
    """Place of the earlier entry that this one mirrors, or its own if it is symmetric."""
    if entry.symmetric:
        return place
    if entry.mirror_of is None:
        return None
    mirror = entry.mirror_of - before - 1
    if not 0 <= mirror < place:
        raise InputError("a mirror image is of no entry before it")
    return mirror
