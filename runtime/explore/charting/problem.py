"""What the kinds of chart have in common: variables, and what tells one chart from another."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.explore.charting.grid import Block, Grid
from nonsmooth.runtime.model.kernels import ParameterTable
from nonsmooth.runtime.model.parameters import value_of

__all__ = [
    "MISSING",
    "ChartProblem",
    "Variable",
    "fixed_values",
    "table_hash",
]

MISSING = -128  # status of a point that is not computed yet


@dataclass(frozen=True)
class Variable:
    """A variable of a chart: one number for each point."""

    name: str
    dtype: str
    fill: float  # value where nothing is computed yet
    attributes: dict[str, Any] = field(default_factory=dict)  # of the stored array: its meaning


class ChartProblem(Protocol):
    """What a chart computes at each point, from the grid and the fixed parameters alone."""

    @property
    def points(self) -> int:
        """Usual number of points of a chunk."""

    @property
    def seconds(self) -> float:
        """Processor time for one point in seconds, as a lower bound."""

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on except the grid, as data for JSON."""

    def held(self) -> dict[str, Any]:
        """Further data that a store holds, to make the problem again without any other file."""

    def variables(self) -> tuple[Variable, ...]:
        """The variables of the chart."""

    def axis_attributes(self, name: str) -> dict[str, str]:
        """Unit of a swept name as an attribute; empty where the system states none."""

    def prepare(self, grid: Grid) -> np.ndarray:
        """An array with what all chunks need of the whole grid, for `compute`."""

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
