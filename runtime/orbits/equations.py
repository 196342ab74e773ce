"""The equations of an orbit at many points near it: by its kernels, or by tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from nonsmooth.runtime.core.exponentials.matrices import eigenvalues
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.orbits.admissible import NEITHER, kernel_limits, trigonometric_rows
from nonsmooth.runtime.orbits.kernel_problem import has_reciprocal_pair
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_equations import TableEquations
from nonsmooth.runtime.shooting.kernel_newton import (
    equations_at,
    judged_at,
    lasting_phases,
    natural_scales,
)
from nonsmooth.runtime.shooting.multipliers import nontrivial
from nonsmooth.runtime.shooting.newton import sure_digits

__all__ = ["KernelEquations", "OrbitEquations", "equations_of"]

_SMALLEST = 0.05  # size of an unknown in units of what changes an equation by itself, at least


class KernelEquations:
    """The equations of an orbit with kernels, near it.

    A point x (v,) holds all unknowns and what may be given in their place, by `names`; an
    unknown may have been given, and a parameter solved for in its place. Arrays of points are
    (k, v). Numbers are nondimensional, or in the units of the declaration.

    `values` (v,) are the orbit's, `unknowns` the names (n,) of what it was solved for.
    `dwell_names` and `phases`, pairs of configuration and boundary, are those of the p phases
    that take time, of the part that a symmetry closes; `order` such parts make up one period.
    Orbits come in families that a first integral parametrises where they are `conservative`.
    """

    order = 1
    condition_places: tuple[int, ...] = ()  # the phase at whose end each condition is asked

    def __init__(self, orbit: Orbit) -> None:
        self.orbit, self._kernels = orbit, orbit.kernels
        kernels, table = self._kernels, self._kernels.table
        self.names = (*kernels.unknowns, *kernels.parameter_names)
        self.unknowns = tuple(orbit.unknowns)
        self.values = np.array([float(orbit.values[name]) for name in self.names])
        self._count = len(kernels.unknowns)
        self._places = [self.names.index(name) for name in self.unknowns]
        self._timed = lasting_phases(kernels)
        self._sums = [
            [(self.names.index(name), factor) for name, factor in table["durations"][k].items()]
            for k in self._timed
        ]
        self.dwell_names = tuple(kernels.dwell_times[k] for k in self._timed)
        self.phases = tuple(tuple(table["phases"][k][:2]) for k in self._timed)
        self.conservative = bool(table["conservative"])
        self._pair = has_reciprocal_pair(orbit)

    @property
    def sizes(self) -> np.ndarray:
        """Typical sizes (n,) of the unknowns, as units of measure."""
        unknowns = abs(self.values[self._places])
        waits = np.array([name in self._kernels.dwell_times for name in self.unknowns])
        jacobian = equations_at(self._kernels, self.values).jacobian
        own = natural_scales(jacobian, self.values)[1][self._places]
        return np.where(waits, float(self.orbit.period), np.maximum(unknowns, _SMALLEST * own))

    def linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Return left-hand sides (m,), m >= n, at a point, and their Jacobian (m, n + 1).

        The columns are derivatives by the unknowns, then by the number at `place` among
        `names`.
        """
        found = equations_at(self._kernels, x)
        return found.residual, found.jacobian[:, [*self._places, place]]

    def dwell(self, x: np.ndarray) -> np.ndarray:
        """Return the dwell times (k, p) at points (k, v): affine in them, in the unit of time."""
        found = np.zeros((len(x), len(self._sums)))
        for phase, terms in enumerate(self._sums):
            for place, factor in terms:
                found[:, phase] += factor * x[:, place]
        return found

    def unevenness(self, x: np.ndarray) -> list[np.ndarray]:
        """Return how far the state behind a part differs from the start (N,), at a point.

        There is one array for each of the parts that the itinerary repeats, in units of the
        states' sizes; the list is empty where no part is repeated. Where the difference is
        zero the branch meets that of the part, and comes back with the parts exchanged.
        """
        return []

    def waves(self, x: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Return groups of points with the boundary functions of each of their phases.

        A group is given by the places (int) of its points among the points (k, v).
        """
        return [(np.arange(len(x)), list(self._waves(x)))]

    def _waves(self, x: np.ndarray) -> Iterator[PhaseWaves]:
        """Yield the boundary functions of each phase, which are trigonometric sums."""
        kernels, opened, dwell = self._kernels, self.orbit.opened, self.dwell(x)
        found = kernels.evaluate("coefficients", "frequencies", at=self._arguments(x))
        every = [
            (boundary, row, frequencies)
            for boundary, row, frequencies in trigonometric_rows(kernels, *found)
            # what is open is as large as it has to be
            if boundary.open_parameter is None or boundary.open_parameter in opened
        ]
        for boundary, row, _ in every:
            if boundary.open_parameter is not None:
                row[:, 0] += boundary.open_coefficient * float(opened[boundary.open_parameter])
        for position, phase in enumerate(self._timed):
            boundaries, rows, frequencies = zip(
                *(each for each in every if each[0].phase == phase), strict=True
            )
            names = tuple(boundary.name for boundary in boundaries)
            yield _phase_waves(
                position,
                names,
                names.index(kernels.table["phases"][phase][1]),
                np.stack(rows, 1),
                frequencies[0],
                dwell[:, position],
            )

    def conditions(self, x: np.ndarray) -> np.ndarray:
        """Return no conditions: a phase that begins where the one before it ends shows them."""
        return np.empty((len(x), 0))

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Return the number (k, p) of the transition that each phase takes; -1 where it takes none.

        `conditions` (k, c) are those of the method of that name.
        """
        return np.zeros((len(conditions), len(self.phases)), dtype=int)

    def multipliers(self, x: np.ndarray) -> np.ndarray:
        """Return the complex multipliers (k, r) over one part that may differ from zero.

        Trivial ones are left out.
        """
        table = self._kernels.table
        if table["rank"] == 1:
            return self.traces(x)[:, None].astype(complex)[:, int(table["conservative"]) :]
        if self._pair:
            half = (self.traces(x) - 1) / 2
            with np.errstate(all="ignore"):
                root = np.sqrt(half.astype(complex) ** 2 - 1)
                larger = np.where(half > 0, half + root, half - root)
                return np.stack([larger, 1 / larger], axis=-1)
        with np.errstate(all="ignore"):  # infinite where a boundary is touched
            matrices = self._kernels.evaluate("poincare_jacobian", at=self._arguments(x))
        return nontrivial(eigenvalues(matrices), table["rank"], family=self.conservative)

    def traces(self, x: np.ndarray) -> np.ndarray:
        """Return traces (k,) of the Poincare map of the whole period."""
        with np.errstate(all="ignore"):
            return np.asarray(self._kernels.evaluate("trace", at=self._arguments(x)))

    def admissible(self, x: np.ndarray) -> np.ndarray:
        """Return whether each of the points (k, v) is a motion of the real system."""
        parameters, _, unknowns = self._arguments(x)
        limit, bounds = kernel_limits(self._kernels, parameters, unknowns)
        allowed = (limit == NEITHER) & (self.dwell(x) > 0).all(axis=-1)
        for column, table in enumerate(self._kernels.open_parameters):
            if table.name in self.orbit.opened:
                allowed &= float(self.orbit.opened[table.name]) > bounds[:, column]
        return np.asarray(allowed)

    def orbit_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Orbit:
        """Return the orbit at a point (v,) as a record.

        `given` has the parameters, and the period where it is given.
        """
        residual, error, status = judged_at(self._kernels, x, self._places)
        return replace(
            self.orbit,
            given=given,
            unknowns=dict(zip(self.unknowns, x[self._places].tolist(), strict=True)),
            residual=residual,
            digits=sure_digits(error),
            status=status,
        )

    def motion_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Motion:
        """Return the motion at a point (v,); a phase that vanishes there takes no time.

        It is a Trajectory where tables answer. `given` has the parameters, and the period if
        given.
        """
        return self.orbit_at(x, given).motion()

    def _arguments(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return parameters, spectrum and unknowns of points, in the kernels' order."""
        unknowns, parameters = x[:, : self._count], x[:, self._count :]
        return parameters, self._kernels.spectrum(parameters)[0], unknowns


def _phase_waves(
    phase: int,
    names: tuple[str, ...],
    leaving: int,
    rows: np.ndarray,
    frequencies: np.ndarray,
    durations: np.ndarray,
) -> PhaseWaves:
    """Return a phase's waves from rows (k, b, 2 + 2 w): constant, slope, cosines, sines.

    The frequencies are (k, w).
    """
    count = frequencies.shape[1]
    w = frequencies[:, None, :]

    def rate(row: np.ndarray) -> np.ndarray:
        cosine, sine = row[..., 2 : 2 + count], row[..., 2 + count :]
        parts = [row[..., 1:2], np.zeros_like(row[..., :1]), sine * w, -cosine * w]
        return np.concatenate(parts, axis=-1)

    def basis(points: np.ndarray, times: np.ndarray) -> np.ndarray:
        angles = frequencies[points] * times[:, None]
        ones = np.ones_like(times)[:, None]
        return np.concatenate([ones, times[:, None], np.cos(angles), np.sin(angles)], axis=-1)

    first = rate(rows)
    fastest = float(np.max(frequencies, initial=0.0))
    return PhaseWaves(
        phase, names, leaving, durations, fastest, basis, np.stack([rows, first, rate(first)])
    )


OrbitEquations = KernelEquations | TableEquations


def equations_of(orbit: Orbit) -> OrbitEquations:
    """Return the equations near an orbit: those of its kernels where they are the faster ones.

    Kernels of damped and forced motions are faster only where they are compiled: a
    compilation takes seconds, and the tables of a system follow a branch in less.
    """
    kernels = orbit.problem.kernels
    if kernels is None:
        return TableEquations(orbit)
    if not kernels.trigonometric:
        return TableEquations(orbit.problem.by_tables(orbit))
    return KernelEquations(orbit)
