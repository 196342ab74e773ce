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
    """One number for each point.

    Attributes
    ----------
    name : str
    dtype : str
    fill : float
        Where nothing is computed yet.
    attributes : dict
        What it means; of the stored array.
    """

    name: str
    dtype: str
    fill: float
    attributes: dict[str, Any] = field(default_factory=dict)


class ChartProblem(Protocol):
    """What is computed at each point, from nothing but the grid and the fixed parameters."""

    @property
    def points(self) -> int:
        """Points of a chunk, unless a user says otherwise."""

    @property
    def seconds(self) -> float:
        """Of one processor for one point, at least."""

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on but the grid, as JSON.

        Returns
        -------
        dict of str to number, text, list or dict
        """

    def held(self) -> dict[str, Any]:
        """What a store holds beside, from which the problem is made again without any file.

        Returns
        -------
        dict of str to number, text, list or dict
        """

    def variables(self) -> tuple[Variable, ...]:
        """What is computed."""

    def axis_attributes(self, name: str) -> dict[str, str]:
        """Unit of a parameter, where the system states it.

        Parameters
        ----------
        name : str
            Of the parameter.

        Returns
        -------
        dict of str to str
            Empty where no unit is stated.
        """

    def prepare(self, grid: Grid) -> np.ndarray:
        """What all chunks need to know of the whole grid.

        Returns
        -------
        array
            Handed to `compute`.
        """

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk.

        Parameters
        ----------
        block : Block
        prepared : array
            As `prepare` gives it.

        Returns
        -------
        dict of str to array
            In the shape of the chunk, by the variables' names.
        """


def fixed_values(
    tables: Sequence[ParameterTable],
    given: Mapping[str, object],
    swept: Sequence[str],
    defaults: Mapping[str, object],
    name: str,
) -> tuple[tuple[str, float], ...]:
    """All parameters but those that are swept, checked; defaults where they are not given.

    Parameters
    ----------
    tables : sequence of ParameterTable
        Of all parameters.
    given : mapping of str to number, text or Value
    swept : sequence of str
        Names that are left out.
    defaults : mapping of str to number, text or Value
    name : str
        What a message calls the system or orbit.

    Returns
    -------
    tuple of (str, float)
        Names and values in the order of the tables.

    Raises
    ------
    InputError
        For unknown or missing names, or values outside their domains.
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
    """A hash of a table of the kernels.

    Parameters
    ----------
    table : mapping
        As JSON takes it.

    Returns
    -------
    str
        16 hexadecimal digits.
    """
    text = json.dumps(table, sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]
