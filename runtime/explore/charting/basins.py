"""Basins of attraction as a chart: where the starts of a plane of states lead."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.core.workload import SECONDS
from nonsmooth.runtime.explore.charting.grid import Block, Grid
from nonsmooth.runtime.explore.charting.problem import MISSING, Variable, table_hash
from nonsmooth.runtime.explore.finding.basins import (
    attractors_found,
    labels_of_starts,
    other_states,
)
from nonsmooth.runtime.explore.finding.found import Found, label_names
from nonsmooth.runtime.explore.finding.outcomes import Attractors
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.model.units import units_of

__all__ = ["BasinProblem", "basin_problem", "held_basin_problem", "is_found"]

_POINTS = 1 << 11  # of a chunk: seconds of work
_FOUND = "nonsmooth found orbits"


@dataclass(frozen=True)
class BasinProblem:
    """Starts over a grid of states, and the attractors that they may lead to.

    Attributes
    ----------
    data : str
        What was found, as `held_found` writes it.
    start : tuple of float
        All states; those that are swept take the grid's values.
    """

    data: str
    start: tuple[float, ...]

    @property
    def kernels(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return _known(self.data)[0]

    @property
    def found(self) -> Found:
        """The attractors, without the starts that found them."""
        return _known(self.data)[1]

    @property
    def points(self) -> int:
        """Points of a chunk, unless a user says otherwise."""
        return _POINTS

    @property
    def seconds(self) -> float:
        """Of one processor for one point, at least: most settle long before the end."""
        return self.found.transitions / 16 * SECONDS["transition"]

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on but the grid.

        Returns
        -------
        dict of str to number, text, list or dict
            As JSON takes it.
        """
        kernels = self.kernels
        compiled = kernels.compiled is not None and compiled_engine() is not None
        return {
            "kind": "basins",
            "method": 1,
            "system": named(kernels)[0],
            "derivation": str(kernels.module.DERIVATION),
            "table": table_hash(kernels.table) if kernels.built_in else "",
            "kernels": "c" if compiled else "numpy",
            "parameters": {name: str(value) for name, value in self.found.parameters.items()},
            "attractors": table_hash({"found": self.data}),
            "start": [repr(value) for value in self.start],
            "transitions": self.found.transitions,
        }

    def held(self) -> dict[str, Any]:
        """What a store holds beside: the system and its attractors as data."""
        return {"of": self.data}

    def variables(self) -> tuple[Variable, ...]:
        """What is computed."""
        status = {
            "long_name": "whether it is computed",
            "meanings": {str(MISSING): "not computed", "0": "computed"},
        }
        found = self.found
        names = {k: f"orbit {k + 1}" for k in range(len(found.orbits))}
        names |= {
            len(names) + k: f"equilibrium {len(names) + k + 1}"
            for k in range(len(found.equilibria))
        }
        names |= label_names(found)
        meanings = {str(_numbered(label)): names[label] for label in sorted(names)}
        attractor = {
            "long_name": "attractor that the start leads to, counted from 1, or how it ends",
            "meanings": meanings,
        }
        return (
            Variable("status", "|i1", MISSING, status),
            Variable("attractor", "<i2", 0, attractor),
        )

    def axis_attributes(self, name: str) -> dict[str, str]:
        """Unit of a state, where the system states it.

        Parameters
        ----------
        name : str
            Of the state.

        Returns
        -------
        dict of str to str
            Empty where no unit is stated.
        """
        return units_of(self.kernels).attributes(name)

    def prepare(self, grid: Grid) -> np.ndarray:
        """Nothing: each start is on its own.

        Parameters
        ----------
        grid : Grid
            Not looked at.

        Returns
        -------
        array (0,)
        """
        return np.empty(0)

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk.

        Parameters
        ----------
        block : Block
        prepared : array
            Not looked at.

        Returns
        -------
        dict of str to array
            In the shape of the chunk, by the variables' names.
        """
        kernels, found, attractors = _known(self.data)
        values = np.broadcast_arrays(*block.values.values())
        starts = np.tile(self.start, (values[0].size, 1))
        for name, column in zip(block.names, values, strict=True):
            starts[:, found.names.index(name)] = column.ravel()
        labels = labels_of_starts(kernels, found, attractors, starts, threads=1)
        attractor = _numbered(labels).reshape(values[0].shape).astype("<i2")
        return {"status": np.zeros(values[0].shape, "i1"), "attractor": attractor}


def _numbered(labels: Any) -> Any:
    """Numbers of attractors as people and files count them, from 1; outcomes as they are."""
    return labels + (labels >= 0)


@lru_cache(maxsize=8)
def _known(data: str) -> tuple[SystemKernels, Found, Attractors]:
    kernels, found = registered("found_held")(data)
    return kernels, found, attractors_found(found, kernels)


def is_found(name: str) -> bool:
    """Whether a name is that of a file of found orbits, all of it."""
    return name.endswith(".json") and format_in(Path(name)) == _FOUND


def basin_problem(
    file: str,
    given: Mapping[str, object],
    swept: Sequence[str],
    start: Mapping[str, object] | Sequence[object] | None,
) -> BasinProblem:
    """Check names and values.

    Parameters
    ----------
    file : str
        Of found orbits.
    given : mapping of str to object
        Has to be empty: parameters are those of the file.
    swept : sequence of str
        States.
    start : mapping of state to number, or sequence, or None
        The other states; 0 for those that are not named.

    Raises
    ------
    InputError
        For a file that cannot be read, names or values that are wrong, or a file in which
        nothing was found.
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
    return BasinProblem(data, tuple(other_states(kernels, start).tolist()))


def held_basin_problem(identity: Mapping[str, Any], held: Mapping[str, Any]) -> BasinProblem:
    """The problem of a store, from what it holds.

    Parameters
    ----------
    identity : mapping of str to object
        As `BasinProblem.identity` gave it, with the dimensions.
    held : mapping of str to object
        As `BasinProblem.held` gave it.

    Raises
    ------
    InputError
        If they are not in order.
    """
    return BasinProblem(held["of"], tuple(map(float, identity["start"])))
