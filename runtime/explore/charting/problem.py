"""What the kinds of chart have in common: variables, what tells charts apart, orbits as data.

`held_text` writes down the orbit or the system that a store's numbers are of, `kernels_held` makes
its tables and kernels of that again: nothing is executed, and no file but the store is needed.
"""

from __future__ import annotations

import hashlib
import json
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import decode, encode
from nonsmooth.runtime.explore.charting.grid import Block, Grid
from nonsmooth.runtime.model.kernel_records import SavedTable
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    ParameterTable,
    SystemKernels,
    load_orbit,
)
from nonsmooth.runtime.model.naming import units_of
from nonsmooth.runtime.model.parameters import value_of
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in

MISSING = -128  # status of a point that is not computed yet
_POINTS = 1 << 11  # of a chunk whose points are motions: about a second


@dataclass(frozen=True)
class Variable:
    """A variable of a chart: one number for each point."""

    name: str
    dtype: str
    fill: float  # value where nothing is computed yet
    attributes: dict[str, Any] = field(default_factory=dict)  # of the stored array: its meaning


def number(name: str, meaning: str, **attributes: str) -> Variable:
    """A variable that is a real number, NaN where nothing is computed yet."""
    return Variable(name, "<f8", float("nan"), {"long_name": meaning, **attributes})


def labelled(
    name: str, meaning: str, fill: int, meanings: Mapping[int, str], dtype: str = "|i1"
) -> Variable:
    """A variable whose numbers have meanings, as flags by the CF conventions too."""
    texts = {str(value): text for value, text in meanings.items()}
    flags = " ".join(text.partition(":")[0].replace(" ", "_") for text in texts.values())
    told = {"flag_values": list(meanings), "flag_meanings": flags, "meanings": texts}
    return Variable(name, dtype, fill, {"long_name": meaning, **told})


class ChartProblem(ABC):
    """What a chart computes at each point, from the grid and the fixed parameters alone."""

    @property
    @abstractmethod
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""

    @property
    def points(self) -> int:
        """Usual number of points of a chunk."""
        return _POINTS

    @property
    @abstractmethod
    def seconds(self) -> float:
        """Processor time for one point in seconds, as a lower bound."""

    @abstractmethod
    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on except the grid, as data for JSON."""

    @abstractmethod
    def held(self) -> dict[str, Any]:
        """Further data that a store holds, to make the problem again without any other file."""

    @abstractmethod
    def variables(self) -> tuple[Variable, ...]:
        """The variables of the chart."""

    def axis_attributes(self, name: str) -> dict[str, str]:
        """Unit of a swept name as an attribute; empty where the system states none."""
        return units_of(self.system).attributes(name)

    def prepare(self, grid: Grid) -> np.ndarray:
        """An array with what all chunks need of the whole grid, for `compute`."""
        return np.empty(0)

    @abstractmethod
    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk, by name and in the chunk's shape.

        `prepared` is the result of `prepare`.
        """


def fixed_values(
    tables: Sequence[ParameterTable],
    given: Mapping[str, object],
    swept: Sequence[str],
    defaults: Mapping[str, object],
    name: str,
) -> tuple[tuple[str, float], ...]:
    """Names and checked values of all parameters that are not swept, in the order of the tables.

    A parameter that is not given takes its default. `name` is what messages call the system
    or the orbit. Unknown or missing names and values outside their domains are refused.
    """
    known = {table.name: table for table in tables}
    for parameter in (*swept, *given):
        if parameter not in known:
            raise unknown_name("parameter", parameter, list(known))
    found, missing = [], []
    for parameter, table in known.items():
        if parameter in swept:
            continue
        value = given.get(parameter, defaults.get(parameter))
        if value is None:
            missing.append(parameter)
        else:
            found.append((parameter, float(value_of(table, value))))
    if missing:
        raise InputError(f"{name} needs a value for: {', '.join(missing)}")
    return tuple(found)


def table_hash(table: Mapping[str, Any]) -> str:
    """A hash of a table of the kernels (as data for JSON): 16 hexadecimal digits."""
    text = json.dumps(table, sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


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
