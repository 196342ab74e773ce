"""Declared orbits that are composed, at many points by compiled kernels of their own equations.

One orbit is composed from its system's tables. At many points these kernels take its place,
where they can be compiled: from the same reference orbit they find the same, under the same
names.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from nonsmooth.runtime.model.completion import check_names
from nonsmooth.runtime.model.kernel_records import OrbitKernels, SavedTable
from nonsmooth.runtime.model.kernels import kernels_of_many
from nonsmooth.runtime.model.parameter_batches import parameter_array, parameter_points
from nonsmooth.runtime.orbits.declared_solve import solve_declared, unknowns_of
from nonsmooth.runtime.orbits.kernel_many import solve_kernels_many
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_arrays import Columns, Orbits, changed, reshaped

__all__ = ["DeclaredKernels", "declared_kernels"]

_SAME = 1e-7  # difference of one orbit by kernels and by tables, in units of max(1, |x|)


@dataclass(frozen=True, eq=False)
class DeclaredKernels:
    """The kernels that find a composed orbit at many points in place of its tables."""

    composed: OrbitKernels  # the orbit as it is composed
    kernels: OrbitKernels  # of its own equations, with the composed orbit's reference
    reference: Orbit  # the composed orbit at its reference point

    @property
    def alone(self) -> bool:
        """Whether the kernels alone decide: they search for nothing but the start of the orbit.

        Where dwell times are searched for, too, Newton's method may end at a root that is no
        motion, such as one without a phase; there the tables look for another one.
        """
        return not {*self.kernels.reduced} & {*self.kernels.timed}

    def solve(
        self,
        parameters: Mapping[str, Any],
        *,
        admissibility: bool,
        threads: int | None,
        chunk: int,
    ) -> Orbits:
        """Find orbits at many points, as the tables of the system would.

        All parameters of the system are given as arrays that broadcast; the problem of the
        result is the composed orbit's. `InputError` is raised for wrong names or arrays.
        """
        check_names(self.composed.system, parameters)
        own = self.kernels.tables.keys() - {p.name for p in self.kernels.other_parameters}
        taken = {name: value for name, value in parameters.items() if name in own}
        if len(taken) < len(parameters):  # the others only have domains
            points, shape = parameter_points(self.composed.system, parameters)
            sound = np.isfinite(points).all(axis=1)
            first = self.kernels.parameter_names[0]
            place = [p.name for p in self.composed.system.parameters].index(first)
            taken[first] = np.where(sound, points[:, place], np.nan).reshape(shape)
        found = solve_kernels_many(
            self.kernels, taken, admissibility=admissibility, threads=threads, chunk=chunk
        )
        shape = found.status.shape
        flat = changed(np.ravel, found)
        values = {n: np.broadcast_to(found.parameters[n], shape).ravel()
                  for n in self.kernels.parameter_names}  # fmt: skip
        named = self.unknowns(values, flat.unknowns)
        orbits = replace(
            flat,
            problem=self.reference.problem,
            parameters={name: parameter_array(name, value) for name, value in parameters.items()},
            unknowns=named,
            bounds={} if admissibility else None,
            starts=self._starts(values, flat.unknowns, named),
        )
        return reshaped(orbits, shape)

    def unknowns(self, parameters: Columns, unknowns: Columns) -> Columns:
        """Return dwell times and start (n,) of orbits, by the names and in the order of `solve`.

        Parameters and unknowns (n,) are those of the kernels' equations, NaN where there is
        no orbit.
        """
        kernels, names = self.kernels, unknowns_of(self.composed)
        times = kernels.durations({**parameters, **unknowns})
        start = names[len(times) :]
        known = {**unknowns, **times}
        if not known.keys() >= {*start}:
            states = self._evaluated("states", parameters, unknowns)[:, 0]
            known = {**dict(zip(start, states.T, strict=True)), **known}
        return {name: known[name] for name in names}

    def _starts(self, parameters: Columns, unknowns: Columns, named: Columns) -> np.ndarray:
        """Return the state (n, p, N) at the start of each phase."""
        count = len(self.kernels.dwell_times)
        if count > 1:
            return self._evaluated("states", parameters, unknowns)[:, :count]
        return np.stack([*named.values()][count:], axis=-1)[:, None]

    def _evaluated(self, quantity: str, parameters: Columns, unknowns: Columns) -> np.ndarray:
        """Return a quantity at orbits (n,); NaN where there is none."""
        kernels = self.kernels
        points = np.stack([parameters[name] for name in kernels.parameter_names], axis=-1)
        solved = np.stack([unknowns[name] for name in kernels.unknowns], axis=-1)
        spectrum, _ = kernels.spectrum(points)
        with np.errstate(all="ignore"):  # of points without an orbit
            found = np.asarray(kernels.evaluate(quantity, at=(points, spectrum, solved)))
        found[np.isnan(solved).any(axis=-1)] = np.nan
        return found


def declared_kernels(orbit: OrbitKernels, key: str | None = None) -> DeclaredKernels | None:
    """Return the kernels that find a composed orbit at many points; None where tables have to.

    The first call waits until they are derived and compiled. None is returned where there
    is no compiler, where formulas are long, and where the kernels find another orbit at
    the reference point. `key` is that of `kernels_of_many`. `NoConvergence` is raised if
    there is no orbit at the reference point.
    """
    own = kernels_of_many(orbit, key)
    return None if own is None else _from_reference(orbit, own)


@cache
def _from_reference(orbit: OrbitKernels, own: OrbitKernels) -> DeclaredKernels | None:
    """Return kernels that begin where the composed orbit begins; None if they do not find it."""
    known = solve_declared(orbit, {})
    guess = {name: repr(float(known.unknowns[name])) for name in own.unknowns}
    reference = {**own.table["reference"], "guess": guess}
    table = SavedTable(own.name, own.address, {**own.table, "reference": reference})
    kernels = replace(own, saved=table)
    found = solve_kernels(kernels, throw=False)
    same = all(
        abs(found.unknowns[name] - value) <= _SAME * max(1, abs(value))
        for name, value in known.unknowns.items()
        if name in own.unknowns
    )
    return DeclaredKernels(orbit, kernels, known) if same else None
