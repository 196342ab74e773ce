"""Orbits as data, with their system: what a store of numbers holds of what they are of.

`held_text` writes an orbit or a system down, `kernels_held` makes its tables and kernels of that
again: nothing is executed, and no file but the store is needed.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import decode, encode
from nonsmooth.runtime.model.kernel_records import SavedTable
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    ParameterTable,
    SystemKernels,
    load_orbit,
)
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in

__all__ = ["held_text", "kernels_held"]


@dataclass(frozen=True, kw_only=True)
class ReferenceEntries:
    """Parameters of an orbit, and the start of its unknowns."""

    parameters: Mapping[str, str]
    guess: Mapping[str, str]


@dataclass(frozen=True, kw_only=True)
class ComposedEntries:
    """The table of an orbit that is composed from its phases."""

    derived: bool
    reason: str
    phases: tuple[tuple[str, str, str], ...]
    start: Mapping[str, str]
    period: ParameterTable | None
    symmetry: Mapping[str, str]
    reference: ReferenceEntries


@dataclass(frozen=True, kw_only=True)
class HeldOrbit:
    """An orbit of a system, or a system alone, as data."""

    system: str  # the name that `named` gives it
    tables: SavedSystem | None  # None for a built-in system
    orbit: str  # name among the orbits of the system; empty for none
    label: str  # name of an orbit of a file of results; empty for others
    # replaces that of a declared orbit, if a file of results does so
    reference: ReferenceEntries | None
    composed: ComposedEntries | None  # table of an orbit that the system does not declare


def held_text(system: SystemKernels, orbit: OrbitKernels | None = None) -> str:
    """A system, and an orbit of it, as JSON text."""
    own = "" if orbit is None else orbit.orbit
    name, _, tables = named(system, own)
    saved = None if orbit is None else orbit.saved
    reference = composed = None
    if saved is not None and own:
        reference = decode(ReferenceEntries, saved.entries["reference"])
    elif saved is not None:
        composed = decode(ComposedEntries, json.loads(json.dumps(saved.entries)))
    held = HeldOrbit(
        system=name,
        tables=tables,
        orbit=own,
        label="" if saved is None else saved.name,
        reference=reference,
        composed=composed,
    )
    return json.dumps(encode(held))


@lru_cache(maxsize=32)
def kernels_held(text: str) -> OrbitKernels:
    """The orbit that a text of `held_text` holds; without a name for a system alone.

    Raises `InputError` with a message of one line if the data are not consistent.
    """
    held = decode(HeldOrbit, json.loads(text))
    system = system_in(held.system, held.tables)
    known: dict[str, Any] = system.module.ORBITS
    if held.orbit and held.orbit not in known:
        raise unknown_name("orbit", held.orbit, known)
    if held.composed is not None:
        if held.orbit or held.composed.derived:
            raise InputError("'composed' is of an orbit that the system does not declare")
        phases = held.composed.phases
        if not phases or {c for c, _, _ in phases} - {*system.configurations}:
            raise InputError("'composed/phases' are not of the system's configurations")
        saved = SavedTable(held.label, held.label, encode(held.composed))
        return OrbitKernels(system, "", saved)
    if held.reference is not None and held.orbit:
        entries = {**known[held.orbit], "reference": encode(held.reference)}
        return OrbitKernels(system, held.orbit, SavedTable(held.label, held.label, entries))
    if not held.orbit:
        return OrbitKernels(system, "")
    return load_orbit(f"{system.name}{'/' if system.built_in else ':'}{held.orbit}")
