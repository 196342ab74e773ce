"""An orbit at many points by its kernels: solved, judged, its limits named."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.model.parameter_batches import Batch, complete_batch
from nonsmooth.runtime.orbits.admissible import NEITHER, NO_ORBIT, UNTOLD, first_violations
from nonsmooth.runtime.orbits.kernel_equations import KernelEquations
from nonsmooth.runtime.orbits.kernel_many import solve_from
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit_arrays import Columns
from nonsmooth.runtime.shooting.multipliers import ROUNDING, family_margins, pair_margins
from nonsmooth.runtime.shooting.newton import CONVERGED

__all__ = ["KernelPoints"]


@dataclass(frozen=True, eq=False)
class KernelPoints:
    """An orbit with kernels at many points; see `OrbitPoints`."""

    kernels: OrbitKernels
    batch: Batch  # how its parameters are completed
    chunk: ClassVar[int] = 1 << 16

    @classmethod
    def of(cls, kernels: OrbitKernels, given: Sequence[str]) -> KernelPoints:
        """Return the orbit, where what is fixed or swept has these names.

        `InputError` is raised for a name that fixes nothing, or several that fix one
        parameter twice.
        """
        return cls(kernels, complete_batch(kernels, given))

    @property
    def parameters(self) -> list[ParameterTable]:
        """See `OrbitPoints`."""
        return [self.kernels.tables[name] for name in self.batch.known]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """See `OrbitPoints`."""
        return self.kernels.unknowns

    @property
    def bounded(self) -> tuple[str, ...]:
        """See `OrbitPoints`."""
        return tuple(table.name for table in self.kernels.open_parameters)

    @cached_property
    def limits(self) -> list[str]:
        """See `OrbitPoints`."""
        phases = self.kernels.table["phases"]
        found = [
            f"phase {b.phase + 1} {phases[b.phase][0]}: {b.name}" for b in self.kernels.boundaries
        ]
        return [*found, *(f"{name} is too small" for name in self.batch.opened)]

    def solve(self, values: Mapping[str, np.ndarray], start: np.ndarray | None) -> Columns:
        """See `OrbitPoints`."""
        kernels, full = self.kernels, self.batch.complete(values)
        points = {name: full[name] for name in kernels.parameter_names}
        opened = {name: full[name] for name in self.batch.opened}
        found = solve_from(kernels, points, start if kernels.reduced else None).restricted(opened)
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
        return columns

    def starts_of(self, columns: Columns) -> np.ndarray:
        """See `OrbitPoints`: reduced unknowns."""
        if not self.kernels.reduced:
            return np.empty((*columns["status"].shape, 0))
        return np.stack([columns[name] for name in self.kernels.reduced], axis=-1)

    @cached_property
    def usual(self) -> np.ndarray:
        """See `OrbitPoints`."""
        if not self.kernels.reduced:
            return np.empty(0)
        equations = KernelEquations(solve_kernels(self.kernels))
        known = dict(zip(equations.unknowns, equations.sizes.tolist(), strict=True))
        timed = self.kernels.timed
        return np.array([0.0 if n in timed else known[n] for n in self.kernels.reduced])

    def limits_of(self, values: Mapping[str, np.ndarray], columns: Columns) -> np.ndarray:
        """See `OrbitPoints`."""
        full, there = self.batch.complete(values), columns["status"] == CONVERGED
        limit = np.where(there, UNTOLD, NO_ORBIT)
        limit[columns["admissible"]] = NEITHER
        lost = there & ~columns["admissible"]
        points, unknowns, _ = self._at(full, columns, lost)
        crossed = first_violations(self.kernels, points, unknowns)
        for number, name in enumerate(self.batch.opened, len(self.kernels.boundaries)):
            small = ~(full[name] > columns[f"least_{name}"])[lost]
            crossed = np.where((crossed == NEITHER) & small, number, crossed)
        limit[lost] = crossed
        return limit

    def _at(
        self, full: Mapping[str, np.ndarray], columns: Columns, where: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return parameters of the equations, unknowns and traces at some points."""
        points = np.stack([full[name][where] for name in self.kernels.parameter_names], axis=-1)
        unknowns = np.stack([columns[name][where] for name in self.kernels.unknowns], axis=-1)
        return points, unknowns, columns["trace"][where]


def _margins(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, trace: np.ndarray
) -> np.ndarray:
    """Return 1 - the largest nontrivial |multiplier| of orbits (n,), as in `Orbit.stability`."""
    table = kernels.table
    if table["rank"] == 1:
        if table["conservative"]:  # the one is trivial, and any others are zero
            return np.full_like(trace, float(len(table["section"]) > 1))
        return np.asarray(1 - np.abs(trace))
    if table["reciprocal_pair"]:
        return pair_margins(trace)
    spectrum, _ = kernels.spectrum(points)
    matrices = kernels.evaluate("poincare_jacobian", at=(points, spectrum, unknowns))
    found = np.full(len(points), np.nan)
    sound = np.isfinite(matrices).all(axis=(-2, -1))
    if table["conservative"]:
        values = np.linalg.eigvals(matrices[sound])
        found[sound] = family_margins(values, trace[sound], table["rank"])
    else:
        found[sound] = 1 - _largest_sizes(matrices[sound])
    return np.where(np.abs(found) <= ROUNDING, 0.0, found)


def _largest_sizes(matrices: np.ndarray) -> np.ndarray:
    """Return the largest absolute eigenvalue of each of the matrices (n, k, k)."""
    if matrices.shape[-1] != 2:
        return np.asarray(np.abs(np.linalg.eigvals(matrices)).max(axis=-1, initial=0.0))
    # in closed form, far quicker: no difference of large numbers but in the discriminant
    (a, b), (c, d) = np.moveaxis(matrices, 0, -1)
    mean, discriminant = (a + d) / 2, ((a - d) / 2) ** 2 + b * c
    real = np.abs(mean) + np.sqrt(np.maximum(discriminant, 0))
    turning = np.sqrt(mean**2 + np.abs(discriminant))
    return np.asarray(np.where(discriminant < 0, turning, real))
