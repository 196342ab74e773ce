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
from nonsmooth.runtime.orbits.orbit_arrays import Columns, Orbits

__all__ = ["DeclaredKernels", "declared_kernels"]

_SAME = 1e-7  # difference of one orbit by kernels and by tables, in units of max(1, |x|)


@dataclass(frozen=True, eq=False)
class DeclaredKernels:
    """The kernels that stand in for an orbit's tables.

    Attributes
    ----------
    composed : OrbitKernels
        The orbit as it is composed.
    kernels : OrbitKernels
        Those of its own equations; their reference is the composed orbit's.
    reference : Orbit
        The composed orbit at its reference point.
    """

    composed: OrbitKernels
    kernels: OrbitKernels
    reference: Orbit

    @property
    def alone(self) -> bool:
        """Whether nothing but the kernels is asked: only the start of the orbit is searched for.

        Where dwell times are, too, Newton's method may end at a root that is no motion, such as
        one without a phase; there the tables look for another one.
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

        Parameters
        ----------
        parameters : mapping of str to array
            All parameters of the system; they broadcast against each other.
        admissibility : bool
        threads : int or None
        chunk : int

        Returns
        -------
        Orbits
            Its problem is the composed orbit's.

        Raises
        ------
        InputError
            For wrong names or arrays.
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
        values = {n: np.broadcast_to(found.parameters[n], shape).ravel()
                  for n in self.kernels.parameter_names}  # fmt: skip
        flat = {name: row.ravel() for name, row in found.unknowns.items()}
        named = self.unknowns(values, flat)
        starts = self._starts(values, flat, named)
        return replace(
            found,
            problem=self.reference.problem,
            parameters={name: parameter_array(name, value) for name, value in parameters.items()},
            unknowns={name: row.reshape(shape) for name, row in named.items()},
            bounds={} if admissibility else None,
            starts=starts.reshape(*shape, *starts.shape[1:]),
        )

    def unknowns(self, parameters: Columns, unknowns: Columns) -> Columns:
        """Dwell times and start (n,) of orbits, by the names and in the order of `solve`.

        Parameters
        ----------
        parameters : dict of str to array (n,)
            Those of the equations, by name.
        unknowns : dict of str to array (n,)
            Those of the equations; NaN where there is no orbit.

        Returns
        -------
        dict of str to array (n,)
        """
        kernels, names = self.kernels, unknowns_of(self.composed)
        times = kernels.durations({**parameters, **unknowns})
        start = names[len(times) :]
        known = {**unknowns, **times}
        if not known.keys() >= {*start}:
            states = self._evaluated("start", parameters, unknowns)
            known = {**dict(zip(start, states.T, strict=True)), **known}
        return {name: known[name] for name in names}

    def _starts(self, parameters: Columns, unknowns: Columns, named: Columns) -> np.ndarray:
        """State (n, p, N) at the start of each phase."""
        count = len(self.kernels.dwell_times)
        if count > 1:
            return self._evaluated("states", parameters, unknowns)[:, :count]
        return np.stack([*named.values()][count:], axis=-1)[:, None]

    def _evaluated(self, kernel: str, parameters: Columns, unknowns: Columns) -> np.ndarray:
        """A kernel at orbits (n,); NaN where there is none."""
        kernels = self.kernels
        points = np.stack([parameters[name] for name in kernels.parameter_names], axis=-1)
        solved = np.stack([unknowns[name] for name in kernels.unknowns], axis=-1)
        spectrum, _ = kernels.spectrum(points)
        with np.errstate(all="ignore"):  # of points without an orbit
            found = np.asarray(kernels.evaluate(kernel, points, spectrum, solved))
        found[np.isnan(solved).any(axis=-1)] = np.nan
        return found


def declared_kernels(orbit: OrbitKernels, key: str | None = None) -> DeclaredKernels | None:
    """The kernels that find a composed orbit at many points.

    The first time it waits until they are derived and compiled.

    Parameters
    ----------
    orbit : OrbitKernels
        Of an orbit that is composed, with a reference.
    key : str, optional
        As for `kernels_of_many`.

    Returns
    -------
    DeclaredKernels or None
        None where the orbit is composed at many points too: where there is no compiler, its
        formulas are long, or the kernels find another orbit at the reference point.

    Raises
    ------
    NoConvergence
        If there is no orbit at the reference point.
    """
    own = kernels_of_many(orbit, key)
    return None if own is None else _from_reference(orbit, own)


@cache
def _from_reference(orbit: OrbitKernels, own: OrbitKernels) -> DeclaredKernels | None:
    """Let kernels begin where the composed orbit begins, if they find it there."""
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
