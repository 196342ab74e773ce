"""Orbits whose equations have kernels, as a family to be followed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from copy import copy
from dataclasses import replace

import numpy as np

from nonsmooth.runtime.core.matrices import eigenvalues
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.orbits.admissible import admissible_points
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.shooting.newton import equations_at, error_bound

__all__ = ["DerivedCurve"]

_SMALLEST = 0.05  # size of an unknown in units of the largest one, at least


class DerivedCurve:
    """An orbit with kernels over one of the numbers that were given for it; see `Curve`."""

    order = 1
    condition_places: tuple[int, ...] = ()

    def __init__(self, orbit: Orbit, parameter: str, length: float) -> None:
        kernels = orbit.kernels
        names = (*kernels.unknowns, *kernels.parameter_names)
        self.orbit, self.parameter = orbit, parameter
        self.names = tuple(orbit.unknowns)
        self._kernels = kernels
        self._base = np.array([float(orbit.values[name]) for name in names])
        self._places = [names.index(name) for name in (*self.names, parameter)]
        self.first = self._base[self._places]
        self._timed = [
            k
            for k, name in enumerate(kernels.dwell_times)
            if name not in kernels.table["vanishing"]
        ]
        self.dwell_names = tuple(kernels.dwell_times[k] for k in self._timed)
        self.phases = tuple(tuple(kernels.table["phases"][k][:2]) for k in self._timed)
        period = float(orbit.period)
        unknowns = self.first[:-1]
        waits = np.array([name in kernels.dwell_times for name in self.names])
        largest = max((abs(x) for x, w in zip(unknowns, waits, strict=True) if not w), default=1.0)
        sizes = np.where(waits, period, np.maximum(abs(unknowns), _SMALLEST * largest))
        self.sizes = np.append(np.where(sizes > 0, sizes, 1.0), length)

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Curve`."""
        x = self._base.copy()
        x[self._places] = z
        found = equations_at(self._kernels, x)
        return found.residual, found.jacobian[:, self._places]

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        found = list(self._durations(self._full(z)).values())
        return np.stack([np.broadcast_to(found[k], len(z)) for k in self._timed], axis=-1)

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """See `Curve`: an orbit with kernels repeats no part."""
        return []

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `Curve`."""
        kernels, table = self._kernels, self._kernels.table
        parameters, spectrum, unknowns = self._arguments(z)
        rows, frequencies = kernels.evaluate("boundary_functions", parameters, spectrum, unknowns)
        dwell, found = self.dwell(z), []
        ends = np.cumsum([0, *table["terms"]])
        place = 0
        columns: dict[int, list[tuple[str, np.ndarray]]] = {}
        for boundary in kernels.boundaries:
            width = 2 + 2 * table["terms"][boundary.phase]
            row = rows[:, place : place + width].copy()
            place += width
            if boundary.open_parameter is not None:
                opened = self.orbit.opened.get(boundary.open_parameter)
                if opened is None:
                    continue  # as large as it has to be
                row[:, 0] += boundary.open_coefficient * float(opened)
            columns.setdefault(boundary.phase, []).append((boundary.name, row))
        for position, phase in enumerate(self._timed):
            watched = columns[phase]
            names = tuple(name for name, _ in watched)
            found.append(
                _phase_waves(
                    position,
                    names,
                    names.index(table["phases"][phase][1]),
                    np.stack([row for _, row in watched], axis=1),
                    frequencies[:, ends[phase] : ends[phase + 1]],
                    dwell[:, position],
                )
            )
        return [(np.arange(len(z)), found)]

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """None: a phase that begins where the one before it has ended shows them."""
        return np.empty((len(z), 0))

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        return np.zeros((len(conditions), len(self.phases)), dtype=int)

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        table = self._kernels.table
        if table["rank"] == 1:
            return self.traces(z)[:, None].astype(complex)
        if table["conservative"] and len(table["section"]) == 3:
            half = (self.traces(z) - 1) / 2
            with np.errstate(all="ignore"):
                root = np.sqrt(half.astype(complex) ** 2 - 1)
                larger = np.where(half > 0, half + root, half - root)
                return np.stack([larger, 1 / larger], axis=-1)
        with np.errstate(all="ignore"):  # infinite where a boundary is touched
            matrices = self._kernels.evaluate("poincare_jacobian", *self._arguments(z))
        return eigenvalues(matrices)[:, : table["rank"]]

    def traces(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        with np.errstate(all="ignore"):
            return np.asarray(self._kernels.evaluate("trace", *self._arguments(z)))

    @property
    def conservative(self) -> bool:
        """See `Curve`."""
        return bool(self._kernels.table["conservative"])

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        parameters, _, unknowns = self._arguments(z)
        allowed, bounds = admissible_points(self._kernels, parameters, unknowns)
        allowed = allowed & (self.dwell(z) > 0).all(axis=-1)
        for column, table in enumerate(self._kernels.open_parameters):
            if table.name in self.orbit.opened:
                allowed &= float(self.orbit.opened[table.name]) > bounds[:, column]
        return np.asarray(allowed)

    def at(self, z: np.ndarray) -> Orbit:
        """See `Curve`."""
        x = self._base.copy()
        x[self._places] = z
        equations = equations_at(self._kernels, x)
        error = error_bound(self._kernels, x, self._places[:-1], equations)
        digits = math.floor(-math.log10(max(error, 1e-300))) if math.isfinite(error) else 0
        return replace(
            self.orbit,
            given={**self.orbit.given, self.parameter: as_value(float(z[-1]))},
            unknowns=dict(zip(self.names, z[:-1].tolist(), strict=True)),
            residual=float(abs(equations[0]).max()),
            digits=max(0, min(DOUBLE, digits)),
        )

    def moved(self, name: str, value: float) -> DerivedCurve:
        """See `Curve`."""
        other = copy(self)
        names = (*self._kernels.unknowns, *self._kernels.parameter_names)
        other._base = self._base.copy()
        other._base[names.index(name)] = value
        other.orbit = replace(self.orbit, given={**self.orbit.given, name: as_value(value)})
        return other

    def _full(self, z: np.ndarray) -> np.ndarray:
        full = np.repeat(self._base[None], len(z), axis=0)
        full[:, self._places] = z
        return full

    def _durations(self, full: np.ndarray) -> Mapping[str, np.ndarray]:
        names = (*self._kernels.unknowns, *self._kernels.parameter_names)
        return self._kernels.durations(dict(zip(names, full.T, strict=True)))

    def _arguments(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Parameters, spectrum and unknowns in the kernels' order."""
        full, count = self._full(z), len(self._kernels.unknowns)
        spectrum, _ = self._kernels.spectrum(full[:, count:])
        return full[:, count:], spectrum, full[:, :count]


def _phase_waves(
    phase: int,
    names: tuple[str, ...],
    leaving: int,
    rows: np.ndarray,
    frequencies: np.ndarray,
    durations: np.ndarray,
) -> PhaseWaves:
    """Rows (k, b, 2 + 2 w): constant, slope, cosines, sines; frequencies (k, w)."""
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
