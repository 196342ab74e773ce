"""Declared orbits without kernels at many parameter points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.piecewise import parameter_points, piecewise_at
from nonsmooth.runtime.orbits.compose_many import ComposedOrbits, compose_many
from nonsmooth.runtime.orbits.composed_admissible import assess_cycle
from nonsmooth.runtime.orbits.many import Orbits
from nonsmooth.runtime.orbits.named import solve_declared, unknowns_of
from nonsmooth.runtime.shooting.shooting_map import cycle_of, numbers_in, shoot

__all__ = ["solve_declared_many"]


def solve_declared_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool = True,
    threads: int | None = None,
) -> Orbits:
    """Compose an orbit at many points, each from the reference orbit.

    Parameters
    ----------
    kernels : OrbitKernels
        Of an orbit that is not `derived`.
    parameters : mapping of str to array
        Absent ones take the reference point's values.
    admissibility : bool
        Decided point by point in Python, about a millisecond for each.
    threads : int, optional

    Raises
    ------
    InputError
        For wrong names or shapes, an orbit that declares no reference, or one that is
        declared by a part and a symmetry.
    """
    reference = kernels.table["reference"]
    if reference is None:
        raise InputError(f"{kernels.name} declares no reference: use nonsmooth.compose_many")
    if kernels.table.get("symmetry"):
        raise InputError(
            f"{kernels.name} is declared by a part and a symmetry, which one point at a time knows"
        )
    known = solve_declared(kernels, {})
    values = {**reference["parameters"], **parameters}
    phases = [(configuration, boundary) for configuration, boundary, _ in kernels.table["phases"]]
    found = compose_many(
        kernels.system,
        phases,
        values,
        known.dwell_times,
        known.states[0],
        threads=threads,
    )
    columns = [*np.moveaxis(found.dwell_times, -1, 0), *np.moveaxis(found.start, -1, 0)]
    return Orbits(
        kernels.name,
        {name: np.asarray(value, dtype=float) for name, value in parameters.items()},
        dict(zip(unknowns_of(kernels), columns, strict=True)),
        found.trace,
        found.period,
        found.residual,
        found.iterations,
        found.status,
        _admissible(kernels, values, phases, found) if admissibility else None,
        {} if admissibility else None,
    )


def _admissible(
    kernels: OrbitKernels,
    values: Mapping[str, Any],
    phases: list[tuple[str, str]],
    found: ComposedOrbits,
) -> np.ndarray:
    """Where the orbits that were found are motions of the system."""
    points, shape = parameter_points(kernels.system, values)
    dwell = found.dwell_times.reshape(len(points), -1)
    starts = found.start.reshape(len(points), -1)
    allowed = np.zeros(len(points), dtype=bool)
    for place in np.flatnonzero(found.converged.ravel()).tolist():
        system = piecewise_at(kernels.system, points[place])
        cycle = cycle_of(system.structure, phases)
        now = shoot(cycle, numbers_in(system), dwell[place], starts[place], np)
        positive = bool((dwell[place] > 0).all())
        allowed[place] = positive and assess_cycle(cycle, system, now, dwell[place]).verdict is True
    return allowed.reshape(shape)
