"""Charts by following motions: where those from one start settle, or where starts lead."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.core.workload import SECONDS
from nonsmooth.runtime.explore.charting.grid import Block
from nonsmooth.runtime.explore.charting.problem import (
    MISSING,
    ChartProblem,
    Variable,
    fixed_values,
    held_text,
    kernels_held,
    labelled,
    number,
    table_hash,
)
from nonsmooth.runtime.explore.finding.find import Found, label_names
from nonsmooth.runtime.explore.finding.outcomes import (
    Attractors,
    Outcome,
    attractors_of,
    settled,
    settled_texts,
)
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine, load_system
from nonsmooth.runtime.model.naming import units_of
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import start_state

_LONGEST = 32  # phases of a cycle that is looked for
_FOUND = "nonsmooth found orbits"
_FIRST_LOOK = 60  # transitions, about, after which most motions of basins have settled
_KEPT = 65  # entries at the end of such a motion


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
        return {"of": held_text(self.system)}

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
        kernels, found, attractors = _known(self.data)
        values = np.broadcast_arrays(*block.values.values())
        starts = np.tile(self.start, (values[0].size, 1))
        for name, column in zip(block.names, values, strict=True):
            starts[:, found.names.index(name)] = column.ravel()
        labels = _labels_of_starts(kernels, found, attractors, starts)
        attractor = _numbered(labels).reshape(values[0].shape).astype("<i2")
        return {"status": np.zeros(values[0].shape, "i1"), "attractor": attractor}


def _numbered(labels: Any) -> Any:
    """Labels with the attractors counted from 1, as files count them; outcomes stay the same."""
    return labels + (labels >= 0)


@lru_cache(maxsize=8)
def _known(data: str) -> tuple[SystemKernels, Found, Attractors]:
    kernels, found = registered("found_held")(data)
    return kernels, found, _attractors_of(found, kernels)


def _attractors_of(found: Found, kernels: SystemKernels) -> Attractors:
    """The orbits and equilibria of a search as `Attractors`, in the order of its labels."""
    point = piecewise(kernels, found.parameters)
    orbits = tuple(entry.orbit for entry in found.orbits)
    equilibria = tuple(entry.equilibrium for entry in found.equilibria)
    return replace(attractors_of(kernels, point, ()), orbits=orbits, equilibria=equilibria)


def _labels_of_starts(
    kernels: SystemKernels,
    found: Found,
    attractors: Attractors,
    starts: np.ndarray,
) -> np.ndarray:
    """Labels (n,) of starts (n, N), as in `Found.labels`.

    The starts are followed four times longer as long as they are not classified.
    `attractors` are those of `_attractors_of`.
    """
    values = {name: float(value) for name, value in found.parameters.items()}
    labels = np.full(len(starts), int(Outcome.UNCLASSIFIED))
    length = found.transitions
    lengths = [length]
    while length > 2 * _FIRST_LOOK:
        length //= 4
        lengths.insert(0, length)
    for length in lengths:
        open_ = np.flatnonzero(labels == Outcome.UNCLASSIFIED)
        if not open_.size:
            break
        motions = simulate_many(
            kernels, values, starts[open_], transitions=length, keep=_KEPT, threads=1
        )
        labels[open_] = attractors.labels(motions)
        if length == found.transitions:
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
    are 0. `given` has to be empty, because the parameters are those of the file. A file
    without orbit or equilibrium is refused.
    """
    data = registered("held_found")(file)
    kernels, found, _ = _known(data)
    states = structure_of(kernels).states
    for name in swept:
        if name not in states:
            known = unknown_name("state", name, states)
            raise InputError(
                f"{known}: the basins of {file} are charted over states; {file}:1 is its first"
                " orbit"
            )
    for name in given:
        raise InputError(
            f"{name} has one value: the parameters are those of {file}, and --from gives the"
            " other states"
        )
    if not found.orbits and not found.equilibria:
        raise InputError(f"{file} holds no orbit or equilibrium that starts could lead to")
    return BasinProblem(data, tuple(_other_states(kernels, start).tolist()))


def _other_states(
    kernels: SystemKernels, start: Mapping[str, object] | Sequence[object] | None
) -> np.ndarray:
    """The state (N,) that starts of basins take their other coordinates from.

    States that `start` does not name are 0, and a forcing has the phase 0. Wrong names or
    numbers are refused.
    """
    structure = structure_of(kernels)
    if start is not None and not isinstance(start, Mapping):
        return start_state(structure, start)
    free = [name for k, name in enumerate(structure.states) if k not in structure.forced]
    zero = dict.fromkeys(free, 0)
    return start_state(structure, zero | dict(start or {}))


def held_basin_problem(identity: Mapping[str, Any], held: Mapping[str, Any]) -> BasinProblem:
    """The chart problem of a store, from its identity (with the dimensions) and its held data.

    Raises `InputError` if these are not in order.
    """
    return BasinProblem(held["of"], tuple(map(float, identity["start"])))
