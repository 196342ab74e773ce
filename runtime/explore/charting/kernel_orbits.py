"""Orbits of a chart whose equations are derived: solved, judged, their limits named."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.explore.charting.anchors import Columns
from nonsmooth.runtime.explore.charting.problem import NEITHER, NO_ORBIT, UNTOLD
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.orbits.admissible import first_violations
from nonsmooth.runtime.orbits.kernel_many import solve_from
from nonsmooth.runtime.shooting.newton import CONVERGED

__all__ = ["DerivedPoints", "derived_orbits"]


@dataclass(frozen=True, eq=False)
class DerivedPoints:
    """An orbit whose equations are derived.

    Attributes
    ----------
    kernels : OrbitKernels
    opened : tuple of str
        Parameters that only admissibility depends on and that are given.
    completed : tuple of (name, terms)
        Parameters that follow from those that are given: sums of multiples.
    """

    kernels: OrbitKernels
    opened: tuple[str, ...]
    completed: tuple[tuple[str, tuple[tuple[str, int], ...]], ...]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns."""
        return self.kernels.unknowns

    @property
    def bounded(self) -> tuple[str, ...]:
        """Open parameters, of which it is told what they have to exceed."""
        return tuple(table.name for table in self.kernels.open_parameters)

    @cached_property
    def limits(self) -> list[str]:
        """What the numbers of `limit` stand for."""
        phases = self.kernels.table["phases"]
        found = [
            f"phase {b.phase + 1} {phases[b.phase][0]}: {b.name}" for b in self.kernels.boundaries
        ]
        return [*found, *(f"{name} is too small" for name in self.opened)]

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """Find orbits at points (n,), from starts (n, m) or from the solver's own."""
        kernels, full = self.kernels, self._full(values)
        points = {name: full[name] for name in kernels.parameter_names}
        found = solve_from(kernels, points, start if kernels.reduced else None)
        there, bounds = found.status == CONVERGED, found.bounds or {}
        columns = {
            "status": found.status,
            "admissible": np.asarray(found.admissible),
            "trace": np.where(there, found.trace, np.nan),
            "margin": np.full(found.status.shape, np.nan),
            "period": found.period,
            **found.unknowns,
            **{f"least_{name}": bounds[name] for name in self.bounded},
        }
        columns["margin"][there] = _margins(kernels, *self._at(full, columns, there))
        with np.errstate(invalid="ignore"):
            for name in self.opened:
                columns["admissible"] &= full[name] > columns[f"least_{name}"]
        return columns

    def starts_of(self, columns: Columns) -> np.ndarray:
        """Reduced unknowns (n, m), from which the same orbits are found again."""
        if not self.kernels.reduced:
            return np.empty((*columns["status"].shape, 0))
        return np.stack([columns[name] for name in self.kernels.reduced], axis=-1)

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """Which limit fails first, at points (n,)."""
        full, there = self._full(values), columns["status"] == CONVERGED
        limit = np.where(there, UNTOLD, NO_ORBIT)
        limit[columns["admissible"]] = NEITHER
        lost = there & ~columns["admissible"]
        points, unknowns, _ = self._at(full, columns, lost)
        crossed = first_violations(self.kernels, points, unknowns)
        for number, name in enumerate(self.opened, len(self.kernels.boundaries)):
            small = ~(full[name] > columns[f"least_{name}"])[lost]
            crossed = np.where((crossed == NEITHER) & small, number, crossed)
        limit[lost] = crossed
        return limit

    def _at(
        self, full: Mapping[str, np.ndarray], columns: Columns, where: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Parameters of the equations, unknowns and traces at some points."""
        points = np.stack([full[name][where] for name in self.kernels.parameter_names], axis=-1)
        unknowns = np.stack([columns[name][where] for name in self.kernels.unknowns], axis=-1)
        return points, unknowns, columns["trace"][where]

    def _full(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        found = dict(values)
        for name, terms in self.completed:
            found[name] = np.asarray(sum(factor * found[term] for term, factor in terms))
        return found


def derived_orbits(
    kernels: OrbitKernels, given: Sequence[str], defaults: Mapping[str, object]
) -> tuple[DerivedPoints, list[ParameterTable]]:
    """Which parameters are given, follow, or stay open.

    Parameters
    ----------
    kernels : OrbitKernels
    given : sequence of str
        Names of what is fixed or swept.
    defaults : mapping of str to number
        Of the reference point.

    Returns
    -------
    orbits : DerivedPoints
    tables : list of ParameterTable
        Of the parameters that have to have a value.

    Raises
    ------
    InputError
        For a name that fixes nothing, or several that fix one parameter twice.
    """
    own = {table.name: table for table in (*kernels.parameters, *kernels.open_parameters)}
    others = {table.name: table for table in kernels.other_parameters}
    opened = [table.name for table in kernels.open_parameters]
    completed: dict[str, tuple[tuple[str, int], ...]] = {}
    used: set[str] = set()
    for name, terms in kernels.combined.items():
        named = [term for term in terms if term in given]
        absent = [term for term in terms if term not in given]
        if name not in kernels.parameter_names or not named:
            continue
        if not absent and name in given:
            raise InputError(f"{name} follows from {' and '.join(terms)}: leave one of them out")
        used.update(named)
        if not absent:
            completed[name] = tuple(terms.items())
        elif len(absent) == 1 and absent[0] in opened and (name in given or name in defaults):
            unit = terms[absent[0]]  # +1 or -1
            rest = tuple((term, -unit * f) for term, f in terms.items() if term != absent[0])
            completed[absent[0]] = ((name, unit), *rest)
    for name in given:
        if name not in own and name not in others:
            raise unknown_name("parameter", name, [*own, *_terms(kernels)])
        if name in others and name not in used:
            raise InputError(f"{name} decides nothing about {kernels.name}: leave it out")
    told = [name for name in opened if name in given or name in completed]
    known = [n for n in kernels.parameter_names if n not in completed]
    known += [n for n in given if n not in kernels.parameter_names]
    tables = [{**own, **others}[name] for name in known]
    return DerivedPoints(kernels, tuple(told), tuple(completed.items())), tables


def _terms(kernels: OrbitKernels) -> list[str]:
    """Parameters of which those of the equations are sums, and that are not open."""
    opened = {table.name for table in kernels.open_parameters}
    combined = kernels.combined.items()
    every = [t for name, terms in combined if name in kernels.parameter_names for t in terms]
    return [term for term in every if term not in opened]


def _margins(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, trace: np.ndarray
) -> np.ndarray:
    """1 - the largest nontrivial |multiplier| of orbits (n,): as `Orbit.stability` has it."""
    table = kernels.table
    if table["rank"] == 1:
        return np.asarray(1 - np.abs(trace))
    if table["conservative"] and len(table["section"]) == 3:
        half = np.abs(trace - 1) / 2
        root = np.sqrt(np.maximum((half - 1) * (half + 1), 0))
        return np.where(half <= 1, 0.0, 1 - (half + root))
    spectrum, _ = kernels.spectrum(points)
    matrices = kernels.evaluate("poincare_jacobian", points, spectrum, unknowns)
    found = np.full(len(points), np.nan)
    sound = np.isfinite(matrices).all(axis=(-2, -1))
    sizes = np.abs(np.linalg.eigvals(matrices[sound]))
    found[sound] = 1 - sizes.max(axis=-1, initial=0.0)
    return found
