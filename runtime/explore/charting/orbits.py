"""What is charted of an orbit: existence, admissibility and its limits, stability."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS
from nonsmooth.runtime.explore.charting.anchors import (
    Columns,
    Solver,
    anchor_starts,
    solve_block,
)
from nonsmooth.runtime.explore.charting.grid import LATTICE, Block, Grid
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
from nonsmooth.runtime.model.completion import default_parameters
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    SystemKernels,
    compiled_for,
    key_of_many,
    load_orbit,
    uncompiled,
)
from nonsmooth.runtime.model.naming import units_of
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.orbits.admissible import NEITHER, NO_ORBIT, UNTOLD
from nonsmooth.runtime.orbits.kernel_solve import NUMPY_JUDGED
from nonsmooth.runtime.orbits.solve import (
    DeclaredPoints,
    OrbitPoints,
    declared_kernels,
    points_of,
)
from nonsmooth.runtime.shooting.newton import STATUS


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
        kernels = self.kernels
        found = {"of": held_text(kernels.system, kernels), "given": list(self.given)}
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
