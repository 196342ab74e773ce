"""What a chart is of: an orbit, where motions settle, or where starts lead.

`held_text` writes down the orbit or the system that a store's numbers are of, `kernels_held` makes
its tables and kernels of that again: nothing is executed, and no file but the store is needed.
"""

from __future__ import annotations

import hashlib
import json
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import decode, encode
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.core.workload import SECONDS
from nonsmooth.runtime.explore.charting.anchors import (
    Columns,
    Solver,
    anchor_starts,
    solve_block,
)
from nonsmooth.runtime.explore.charting.grid import LATTICE, Block, Grid
from nonsmooth.runtime.explore.finding.find import Found, label_names
from nonsmooth.runtime.explore.finding.outcomes import (
    Attractors,
    Outcome,
    attractors_of,
    numbers_of,
    settled,
    settled_texts,
)
from nonsmooth.runtime.model.completion import default_parameters
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernel_records import SavedTable
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    ParameterTable,
    SystemKernels,
    compiled_engine,
    compiled_for,
    key_of_many,
    load_orbit,
    load_system,
    uncompiled,
)
from nonsmooth.runtime.model.naming import units_of
from nonsmooth.runtime.model.parameters import value_of
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.admissible import NEITHER, NO_ORBIT, UNTOLD
from nonsmooth.runtime.orbits.kernel_solve import NUMPY_JUDGED
from nonsmooth.runtime.orbits.solve import (
    DeclaredPoints,
    OrbitPoints,
    declared_kernels,
    points_of,
)
from nonsmooth.runtime.shooting.newton import STATUS
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import start_state

MISSING = -128  # status of a point that is not computed yet
_POINTS = 1 << 11  # of a chunk whose points are motions: about a second
_LONGEST = 32  # phases of a cycle that is looked for
_FOUND = "nonsmooth found orbits"
_FIRST_LOOK = 60  # transitions, about, after which most motions of basins have settled
_KEPT = 65  # entries at the end of such a motion


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


def held_text(orbit: OrbitKernels) -> str:
    """An orbit of a system, or without a name the system alone, as JSON text."""
    own, saved = orbit.orbit, orbit.saved
    name, _, tables = named(orbit.system, own)
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


@dataclass(frozen=True)
class OrbitChart(ChartProblem):
    """The chart problem of an orbit over a grid of parameters."""

    orbit: str  # as `solve` takes it, or the name that a store gives it
    fixed: tuple[tuple[str, float], ...]  # all parameters that are not swept
    given: tuple[str, ...]  # names that the user fixed or swept
    compiled: bool  # whether there were compiled kernels when the chart began
    data: str | None = None  # the orbit as `held_text` writes it, if a store holds it
    # key of the compiled kernels that replace tables, if there were any when the chart began
    many: str | None = None

    @property
    def kernels(self) -> OrbitKernels:
        """Tables and kernels of the orbit, the same ones from the first chunk to the last."""
        found = load_orbit(self.orbit) if self.data is None else kernels_held(self.data)
        return found if self.compiled else uncompiled(found)

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return self.kernels.system

    @property
    def own(self) -> DeclaredPoints | None:
        """Compiled kernels that replace the tables of a composed orbit, or None.

        Raises `InputError` if the kernels that the chart began with no longer exist.
        """
        if self.many is None:
            return None
        found = declared_kernels(self.kernels, self.many)
        if found is None:
            raise InputError(f"the compiled kernels of {self.orbit} are not there any more")
        return found

    @property
    def orbits(self) -> OrbitPoints:
        """The solver of the orbit at many points."""
        return self.own or points_of(self.kernels, self.given)

    @property
    def points(self) -> int:
        """Usual number of points of a chunk."""
        return self.orbits.chunk

    @property
    def seconds(self) -> float:
        """Processor time for one point in seconds, as a lower bound."""
        by_kernels = self.kernels.derived or self.many is not None
        return SECONDS["orbit" if by_kernels else "composed orbit"]

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on except the grid, as data for JSON."""
        kernels, own = self.kernels, self.own
        solving = kernels if own is None else own.derived
        return {
            "kind": "orbit",
            "orbit": "/".join(filter(None, (kernels.system.table["name"], kernels.orbit))),
            "system": named(kernels.system, kernels.orbit)[0],
            "derivation": str(solving.system.module.DERIVATION),
            "table": table_hash(solving.table),
            "kernels": "numpy" if solving.system.compiled is None else "c",
            "anchors": LATTICE,
            "parameters": {name: repr(value) for name, value in self.fixed},
        }

    def held(self) -> dict[str, Any]:
        """Further data that a store holds: the orbit as text, and names of given parameters."""
        found = {"of": held_text(self.kernels), "given": list(self.given)}
        return found if self.many is None else {**found, "many": self.many}

    def variables(self) -> tuple[Variable, ...]:
        """The variables of the chart."""
        orbits, units = self.orbits, units_of(self.kernels.system)
        told = "" if not set(orbits.bounded) - set(self.given) else ", for large enough open ones"
        limits = {NEITHER: "none fails", NO_ORBIT: "none found", UNTOLD: "not told"}
        return (
            labelled(
                "status",
                "whether an orbit is found",
                MISSING,
                {MISSING: "not computed", **STATUS},
            ),
            Variable(
                "admissible", "|b1", False, {"long_name": f"a motion of the real system{told}"}
            ),
            labelled(
                "limit",
                "what fails first",
                NO_ORBIT,
                {**limits, **dict(enumerate(orbits.limits))},
                "<i2",
            ),
            number("trace", "trace of the Poincare map"),
            number(
                "margin",
                "1 - the largest nontrivial multiplier's size; 0 where neutral or undecided",
            ),
            number("period", "period", **units.attributes()),
            *(number(n, f"unknown {n}", **units.attributes()) for n in orbits.unknowns),
            *(number(f"least_{n}", f"what {n} has to exceed") for n in orbits.bounded),
        )

    def prepare(self, grid: Grid) -> np.ndarray:
        """Starts (..., m) at the anchors of a grid."""
        return anchor_starts(grid, self._solver)

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk, by name and in the chunk's shape.

        `prepared` (..., m) are the starts at the anchors (`prepare`).
        """
        found = solve_block(block, prepared, self._solver)
        return {v.name: found[v.name].astype(v.dtype) for v in self.variables()}

    @property
    def _solver(self) -> Solver:
        orbits = self.orbits

        def solve(values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
            found = orbits.solve(self._completed(values), start, margins=True)
            names = "status", "admissible", "limit", "trace", "margin", "period"
            least = {f"least_{name}": bound for name, bound in (found.bounds or {}).items()}
            return {name: getattr(found, name) for name in names} | found.unknowns | least

        return Solver(solve, orbits.start_names, orbits.usual)

    def _completed(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Values of all parameters at points (n,), from those of the swept ones."""
        shape = next(iter(values.values())).shape
        return {name: np.broadcast_to(value, shape) for name, value in self.fixed} | dict(values)


def orbit_chart(
    orbit: str, given: Mapping[str, object], swept: Sequence[str], points: int
) -> OrbitChart:
    """A chart of an orbit over the parameters `swept`, with all names and values checked.

    `orbit` is ``system/orbit`` or a file with a declaration. Parameters that are neither given
    nor swept take the values of the reference point. `points` is the number of points of the
    whole grid. An orbit that cannot be solved at many points at once is refused.
    """
    kernels = load_orbit(orbit)
    names = (*given, *swept)
    tables = points_of(kernels, names).parameters
    fixed = fixed_values(tables, given, swept, default_parameters(kernels), kernels.name)
    kernels = compiled_for(kernels, points * NUMPY_JUDGED, at_once=True)
    compiled, own = kernels.system.compiled is not None, declared_kernels(kernels)
    many = None if own is None else key_of_many(kernels)
    return OrbitChart(kernels.address, fixed, names, compiled, many=many)


def held_orbit_chart(identity: Mapping[str, Any], held: Mapping[str, Any]) -> OrbitChart:
    """The chart problem of a store, from its identity (with the dimensions) and its held data.

    Raises `InputError` if these are not in order.
    """
    kernels, names = kernels_held(held["of"]), tuple(held["given"])
    swept, tables = identity["dimensions"], points_of(kernels, names).parameters
    fixed = fixed_values(tables, identity["parameters"], swept, {}, kernels.name)
    compiled, many = kernels.system.compiled is not None, held.get("many")
    if many is not None and declared_kernels(kernels, many) is None:
        many = None  # they were made elsewhere: the store says so
    return OrbitChart(kernels.address, fixed, names, compiled, held["of"], many)


def _identity(
    kind: str,
    method: int,
    kernels: SystemKernels,
    parameters: Mapping[str, str],
    start: Iterable[float],
) -> dict[str, Any]:
    """The system and the kernels by which its motions are followed, as data for JSON."""
    compiled = kernels.compiled is not None and compiled_engine() is not None
    return {
        "kind": kind,
        "method": method,
        "system": named(kernels)[0],  # of a user's own the hash of its table, too
        "derivation": str(kernels.module.DERIVATION),
        "table": table_hash(kernels.table) if kernels.built_in else "",
        "kernels": "c" if compiled else "numpy",
        "parameters": parameters,
        "start": [repr(value) for value in start],
    }


@dataclass(frozen=True)
class AttractorProblem(ChartProblem):
    """The chart problem of the motions from one start over a grid of parameters."""

    name: str  # of the system
    fixed: tuple[tuple[str, float], ...]
    start: tuple[float, ...]
    transitions: int  # number of transitions before the motions are examined
    data: str | None = None  # the system as `held_text` writes it, if a store holds it

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return load_system(self.name) if self.data is None else kernels_held(self.data).system

    @property
    def seconds(self) -> float:
        """Processor time for one point in seconds, as a lower bound."""
        return self.transitions * SECONDS["transition"]

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on except the grid, as data for JSON."""
        fixed = {name: repr(value) for name, value in self.fixed}
        found = _identity("attractors", 3, self.system, fixed, self.start)
        return {**found, "transitions": self.transitions}

    def held(self) -> dict[str, Any]:
        """Further data that a store holds: the system as text."""
        return {"of": held_text(OrbitKernels(self.system, ""))}

    def variables(self) -> tuple[Variable, ...]:
        """The variables of the chart."""
        statuses = {status.value: status.message for status in Status}
        names = enumerate(structure_of(self.system).configurations)
        length = "transitions in a period; 0 where the motion is not periodic"
        return (
            labelled(
                "status",
                "why the simulation ended",
                MISSING,
                {MISSING: "not computed", -1: "no configuration", **statuses},
            ),
            Variable("transitions", "<i2", -1, {"long_name": length}),
            number("period", "period", **units_of(self.system).attributes()),
            labelled(
                "configuration",
                "configuration at the end",
                -1,
                {-1: "none", **dict(names)},
                "<i2",
            ),
            labelled("outcome", "what the motion settles on", MISSING, settled_texts()),
        )

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk, by name and in the chunk's shape.

        `prepared` is ignored.
        """
        parameters = {**dict(self.fixed), **block.values}
        motions = simulate_many(
            self.system,
            parameters,
            np.array(self.start),
            transitions=self.transitions,
            keep=2 * _LONGEST + 1,
            threads=1,
        )
        found = settled(self.system, parameters, motions, threads=1)
        return {
            "status": motions.status.astype("i1"),
            "transitions": found.lengths.astype("<i2"),
            "period": found.periods,
            "configuration": motions.configurations.astype("<i2"),
            "outcome": found.outcomes.astype("i1"),
        }


def attractor_problem(
    system: str,
    given: Mapping[str, object],
    swept: Sequence[str],
    start: Mapping[str, object] | Sequence[object],
    transitions: int,
) -> AttractorProblem:
    """A chart of motions over the parameters `swept`, with all names and values checked.

    `system` is a name or a file with a declaration; the start is in the units of the states.
    Refused are unknown names, values that are wrong or missing, and fewer transitions than two
    of the longest cycles have.
    """
    kernels = load_system(system)
    most = checked_count("transitions", transitions, 1)
    if most <= 2 * _LONGEST:
        raise InputError(
            f"transitions = {most}: cycles of up to {_LONGEST} are looked for, which takes more"
            f" than {2 * _LONGEST}"
        )
    fixed = fixed_values(kernels.parameters, given, swept, {}, kernels.name)
    begin = start_state(structure_of(kernels), start)
    structure_of(kernels).check_listed("a chart of motions")
    return AttractorProblem(kernels.name, fixed, tuple(begin.tolist()), most)


def held_attractor_problem(
    identity: Mapping[str, Any], held: Mapping[str, Any]
) -> AttractorProblem:
    """The chart problem of a store, from its identity (with the dimensions) and its held data.

    Raises `InputError` if these are not in order.
    """
    kernels, swept = kernels_held(held["of"]).system, identity["dimensions"]
    fixed = fixed_values(kernels.parameters, identity["parameters"], swept, {}, kernels.name)
    start = tuple(map(float, identity["start"]))
    return AttractorProblem(kernels.name, fixed, start, int(identity["transitions"]), held["of"])


@dataclass(frozen=True)
class BasinProblem(ChartProblem):
    """The chart problem of starts over a grid of states and the attractors that they lead to."""

    data: str  # the attractors, as `held_found` writes them
    start: tuple[float, ...]  # values of all states; the grid replaces those that are swept

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return _known(self.data)[0]

    @property
    def found(self) -> Found:
        """The attractors, without the starts that led to them."""
        return _known(self.data)[1]

    @property
    def seconds(self) -> float:
        """Processor time for one point in seconds, as a lower bound.

        Most motions settle long before the last transition.
        """
        return self.found.transitions / 16 * SECONDS["transition"]

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on except the grid, as data for JSON."""
        given = {name: str(value) for name, value in self.found.parameters.items()}
        return {
            **_identity("basins", 1, self.system, given, self.start),
            "attractors": table_hash({"found": self.data}),
            "transitions": self.found.transitions,
        }

    def held(self) -> dict[str, Any]:
        """Further data that a store holds: the system and its attractors as text."""
        return {"of": self.data}

    def variables(self) -> tuple[Variable, ...]:
        """The variables of the chart."""
        names = label_names(self.found)
        meaning = "attractor that the start leads to, counted from 1, or how it ends"
        meanings = {_numbered(label): names[label] for label in sorted(names)}
        computed = {MISSING: "not computed", 0: "computed"}
        return (
            labelled("status", "whether it is computed", MISSING, computed),
            labelled("attractor", meaning, 0, meanings, "<i2"),
        )

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk, by name and in the chunk's shape.

        `prepared` is ignored.
        """
        _, found, attractors = _known(self.data)
        values = np.broadcast_arrays(*block.values.values())
        starts = np.tile(self.start, (values[0].size, 1))
        for name, column in zip(block.names, values, strict=True):
            starts[:, found.names.index(name)] = column.ravel()
        labels = _labels_of_starts(attractors, starts, found.transitions)
        attractor = _numbered(labels).reshape(values[0].shape).astype("<i2")
        return {"status": np.zeros(values[0].shape, "i1"), "attractor": attractor}


def _numbered(labels: Any) -> Any:
    """Labels with the attractors counted from 1, as files count them; outcomes stay the same."""
    return labels + (labels >= 0)


@lru_cache(maxsize=8)
def _known(data: str) -> tuple[SystemKernels, Found, Attractors]:
    kernels, found = registered("found_held")(data)
    # orbits and equilibria in the order of the labels
    attractors = replace(
        attractors_of(piecewise(kernels, found.parameters), ()),
        orbits=tuple(entry.orbit for entry in found.orbits),
        equilibria=tuple(entry.equilibrium for entry in found.equilibria),
    )
    return kernels, found, attractors


def _labels_of_starts(attractors: Attractors, starts: np.ndarray, transitions: int) -> np.ndarray:
    """Labels (n,) of starts (n, N), as in `Found.labels`, after that many transitions.

    The starts are followed four times longer as long as they are not classified.
    """
    system = attractors.system
    labels = np.full(len(starts), int(Outcome.UNCLASSIFIED))
    length = transitions
    lengths = [length]
    while length > 2 * _FIRST_LOOK:
        length //= 4
        lengths.insert(0, length)
    for length in lengths:
        open_ = np.flatnonzero(labels == Outcome.UNCLASSIFIED)
        if not open_.size:
            break
        motions = simulate_many(
            system.kernels,
            numbers_of([system]),
            starts[open_],
            transitions=length,
            keep=_KEPT,
            threads=1,
        )
        labels[open_] = attractors.labels(motions)
        if length == transitions:
            labels[open_] = attractors.measured(motions, labels[open_], threads=1)
    return labels


def is_found(name: str) -> bool:
    """Whether a name is that of a whole file of found orbits (without the number of an orbit)."""
    return name.endswith(".json") and format_in(Path(name)) == _FOUND


def basin_problem(
    file: str,
    given: Mapping[str, object],
    swept: Sequence[str],
    start: Mapping[str, object] | Sequence[object] | None,
) -> BasinProblem:
    """A chart of basins over the states `swept`, with all names and values checked.

    `file` holds found orbits. `start` gives the other states; those that it does not name
    are 0. As a sequence it has all states, of which the charted ones are not read. `given` has to
    be empty, because the parameters are those of the file. A file without orbit or equilibrium is
    refused.
    """
    data = registered("held_found")(file)
    kernels, found, _ = _known(data)
    structure = structure_of(kernels)
    for name in swept:
        if name not in structure.states:
            known = unknown_name("state", name, structure.states)
            raise InputError(
                f"{known}: the basins of {file} are charted over states; {file}:1 is its first"
                " orbit"
            )
        if isinstance(start, Mapping) and name in start:
            raise InputError(f"{name} is charted: the start gives the other states")
    for name in given:
        raise InputError(
            f"{name} has one value: the parameters are those of {file}, and the start gives the"
            " other states"
        )
    if not found.orbits and not found.equilibria:
        raise InputError(f"{file} holds no orbit or equilibrium that starts could lead to")
    begin: Any = start
    if start is None or isinstance(start, Mapping):
        free = [name for k, name in enumerate(structure.states) if k not in structure.forced]
        begin = dict.fromkeys(free, 0) | dict(start or {})
    state = start_state(structure, begin)
    state[[structure.states.index(name) for name in swept]] = 0.0  # each point has its own
    return BasinProblem(data, tuple(state.tolist()))


def held_basin_problem(identity: Mapping[str, Any], held: Mapping[str, Any]) -> BasinProblem:
    """The chart problem of a store, from its identity (with the dimensions) and its held data.

    Raises `InputError` if these are not in order.
    """
    return BasinProblem(held["of"], tuple(map(float, identity["start"])))
