"""What is charted of an orbit: existence, admissibility and its limits, stability."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from nonsmooth.runtime.explore.charting.anchors import Columns, Solver, anchor_starts, solve_block
from nonsmooth.runtime.explore.charting.grid import LATTICE, Block, Grid
from nonsmooth.runtime.explore.charting.kernel_orbits import DerivedPoints, derived_orbits
from nonsmooth.runtime.explore.charting.problem import (
    MISSING,
    NEITHER,
    NO_ORBIT,
    UNTOLD,
    Variable,
    fixed_values,
    table_hash,
)
from nonsmooth.runtime.explore.charting.table_orbits import ComposedPoints, composed_orbits
from nonsmooth.runtime.model.completion import default_parameters
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, load_orbit
from nonsmooth.runtime.model.units import units_of
from nonsmooth.runtime.orbits.kernel_problem import STATUS

__all__ = ["OrbitProblem", "orbit_problem"]

_DERIVED, _COMPOSED = 1 << 16, 1 << 11  # points of a chunk: tenths of a second each


@dataclass(frozen=True)
class OrbitProblem:
    """An orbit over a grid of parameters.

    Attributes
    ----------
    orbit : str
        As `solve_many` takes it.
    fixed : tuple of (name, value)
        All parameters that are not swept.
    given : tuple of str
        Names of those that were fixed or swept by the user.
    """

    orbit: str
    fixed: tuple[tuple[str, float], ...]
    given: tuple[str, ...]

    @property
    def kernels(self) -> OrbitKernels:
        """Tables and kernels of the orbit."""
        return load_orbit(self.orbit)

    @property
    def orbits(self) -> DerivedPoints | ComposedPoints:
        """How they are solved."""
        return _orbits(self.kernels, self.given)[0]

    @property
    def points(self) -> int:
        """Points of a chunk, unless a user says otherwise."""
        return _DERIVED if self.kernels.derived else _COMPOSED

    def identity(self) -> dict[str, Any]:
        """All that the numbers depend on but the grid."""
        kernels = self.kernels
        return {
            "kind": "orbit",
            "orbit": "/".join(filter(None, (kernels.system.table["name"], kernels.orbit))),
            "derivation": str(kernels.system.module.DERIVATION),
            "table": table_hash(kernels.table),
            "kernels": "numpy" if kernels.system.compiled is None else "c",
            "anchors": LATTICE,
            "parameters": {name: repr(value) for name, value in self.fixed},
        }

    def variables(self) -> tuple[Variable, ...]:
        """What is computed."""
        orbits, units = self.orbits, units_of(self.kernels.system)
        told = "" if not set(orbits.bounded) - set(self.given) else ", for large enough open ones"
        limits = {NEITHER: "none fails", NO_ORBIT: "none found", UNTOLD: "not told"}
        return (
            _flags("status", MISSING, {MISSING: "not computed", **STATUS}),
            Variable(
                "admissible", "|b1", False, {"long_name": f"a motion of the real system{told}"}
            ),
            _flags("limit", NO_ORBIT, {**limits, **dict(enumerate(orbits.limits))}, "<i2"),
            _number("trace", "trace of the Poincare map"),
            _number(
                "margin",
                "1 - the largest nontrivial multiplier's size; 0 where neutral or undecided",
            ),
            _number("period", "period", **units.attributes()),
            *(_number(n, f"unknown {n}", **units.attributes()) for n in orbits.unknowns),
            *(_number(f"least_{n}", f"what {n} has to exceed") for n in orbits.bounded),
        )

    def axis_attributes(self, name: str) -> dict[str, str]:
        """Unit of a parameter, where the system states it."""
        return units_of(self.kernels.system).attributes(name)

    def prepare(self, grid: Grid) -> np.ndarray:
        """Starts (..., m) at the anchors of a grid."""
        return anchor_starts(grid, self._solver)

    def compute(self, block: Block, prepared: np.ndarray) -> dict[str, np.ndarray]:
        """All variables at the points of a chunk."""
        found = solve_block(block, prepared, self._solver)
        shape = found["status"].shape
        flat = {name: column.ravel() for name, column in found.items()}
        swept = {n: np.broadcast_to(row, shape).ravel() for n, row in block.values.items()}
        flat["limit"] = self.orbits.limits_of(self._completed(swept), flat)
        return {v.name: flat[v.name].astype(v.dtype).reshape(shape) for v in self.variables()}

    @property
    def _solver(self) -> Solver:
        orbits = self.orbits

        def solve(values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
            return orbits.solve(self._completed(values), start)

        return Solver(solve, orbits.starts_of)

    def _completed(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Values of all parameters at points (n,) from those that are swept."""
        shape = next(iter(values.values())).shape
        return {name: np.broadcast_to(value, shape) for name, value in self.fixed} | dict(values)


def orbit_problem(orbit: str, given: Mapping[str, object], swept: Sequence[str]) -> OrbitProblem:
    """Check names and values; parameters that are not given take the reference point's.

    Raises
    ------
    InputError
        For an unknown orbit, names or values that are wrong, or an orbit that many points
        at once cannot be found of.
    """
    kernels = load_orbit(orbit)
    names = (*given, *swept)
    _, tables = _orbits(kernels, names)
    fixed = fixed_values(tables, given, swept, default_parameters(kernels), kernels.name)
    return OrbitProblem(kernels.address, fixed, names)


@cache
def _orbits(
    kernels: OrbitKernels, given: tuple[str, ...]
) -> tuple[DerivedPoints | ComposedPoints, list[ParameterTable]]:
    if kernels.derived:
        return derived_orbits(kernels, given)
    return composed_orbits(kernels)


def _number(name: str, meaning: str, **attributes: str) -> Variable:
    return Variable(name, "<f8", float("nan"), {"long_name": meaning, **attributes})


def _flags(name: str, fill: int, meanings: Mapping[int, str], dtype: str = "|i1") -> Variable:
    return Variable(
        name,
        dtype,
        fill,
        {
            "flag_values": list(meanings),
            "flag_meanings": " ".join(
                text.partition(":")[0].replace(" ", "_") for text in meanings.values()
            ),
            "meanings": {str(value): text for value, text in meanings.items()},
        },
    )
