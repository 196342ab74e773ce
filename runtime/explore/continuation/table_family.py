"""Orbits by the tables of their system as a family to be followed.

Unknowns are the dwell times and the state at the start; the equations are the switching
conditions and closure. Flows are exponentials of the fields at a parameter with a tiny
imaginary part: the imaginary part of what comes out is the derivative by the parameter, to
full precision, since the kernels of fields, rows and resets are rational and nothing is
subtracted (Al-Mohy and Higham, Numer. Algorithms 53, 2010).
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.matrices import (
    eigenvalues,
    exponentials,
    sorted_by_size,
)
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.explore.continuation.phase_functions import conditions_of, phase_waves
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.orbits.table_motion import motion_along
from nonsmooth.runtime.orbits.table_problem import TableProblem, labelled
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.cycle_newton import sizes as sizes_along
from nonsmooth.runtime.shooting.section_map import mechanical_states, stroboscopic_maps
from nonsmooth.runtime.shooting.shooting_map import (
    Cycle,
    Numbers,
    numbers_in,
    phases_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import closing, closing_matrix
from nonsmooth.runtime.shooting.variational import COMPLEX_STEP, Shooting, shooting_map
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["PERIOD", "ComposedCurve"]

_IMAGINARY = 1e-30  # of the parameter, in units of max(1, |it|)


class ComposedCurve:
    """An orbit without kernels over one parameter, or over its period if that was given."""

    def __init__(self, orbit: Orbit, parameter: str, length: float) -> None:
        if len(orbit.tables.cycle.structure.forcing) > 1:
            raise InputError(f"{orbit.name} has several forcings: its branches are not followed")
        self.orbit, self.parameter = orbit, parameter
        self.order = 1 if orbit.symmetry is None else orbit.symmetry.order
        self._parameters = [p.name for p in orbit.system.parameters]
        self._base = np.array([float(orbit.parameters[name]) for name in self._parameters])
        closed, self._cycle = closing(orbit.tables.piecewise, orbit.tables.cycle, orbit.symmetry)
        count = len(self._cycle)
        dwell, start = orbit.dwell_times[:count].astype(float), orbit.states[0].astype(float)
        now = shoot(self._cycle, numbers_in(closed), dwell, start, np)
        self.dwell_names = orbit.dwell_time_names[:count]
        names = tuple(orbit.unknowns)
        self.names = (*self.dwell_names, *names[len(orbit.itinerary) :])
        self.phases = self._cycle.itinerary
        self._parts = _parts(self.phases)
        value = orbit.period if parameter == PERIOD else float(orbit.parameters[parameter])
        self.first = np.array([*dwell, *start, value])
        waits = np.full(count, dwell.sum())
        self.sizes = np.concatenate([waits, sizes_along(now, dwell), [length]])
        stability = orbit.stability if orbit.symmetry is None else orbit.part_stability
        shifts = len(orbit.tables.translations)
        self._rank, self._family = stability.rank - shifts, orbit.tables.family
        self._trivial = shifts + orbit.tables.family
        self._driven = mechanical_states(self._cycle)
        # a forcing, or no family, determines the period by itself
        self._timed = orbit.given_period is not None and orbit.tables.family
        if parameter == PERIOD and not self._timed:
            raise InputError(f"{orbit.name}: the period is determined by the other parameters")
        self._known: tuple[bytes, list[tuple[np.ndarray, Cycle, Numbers]]] = (b"", [])
        self._conditions = conditions_of(self._cycle, numbers_in(closed), now)

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Curve`."""
        cycle, count, size = self._cycle, len(self._cycle), len(self._cycle.structure.states)
        tiny = _IMAGINARY * max(1.0, abs(z[-1]))
        numbers = self._complex_numbers(z[-1], tiny)
        start = z[count:-1]
        generators = np.zeros((count, size + 1, size + 1), dtype=complex)
        generators[:, :size] = numbers.fields[list(cycle.configurations)]
        flows = exponentials(generators * z[:count, None, None])[:, :size]
        unit = np.eye(count + size)
        now = shooting_map(
            COMPLEX_STEP,
            phases_in(cycle, numbers),
            flows,
            start[:, None].astype(complex),
            unit[count:],
            list(unit[:count, None]),
        )
        state, linear = now.starts[-1][:, 0], now.variational
        closure, by_unknowns = state - start, linear.copy()
        by_unknowns[:, count:] -= np.eye(size)
        for c, s in cycle.structure.forcing:
            # its amplitude is 1; that it turns by whole turns is one equation, not two
            closure[c] = start[c] ** 2 + start[s] ** 2 - 1
            by_unknowns[c] = 0
            by_unknowns[c, [count + c, count + s]] = 2 * start[[c, s]]
            closure[s] = start[c] * state[s] - start[s] * state[c]
            by_unknowns[s] = start[c] * linear[s] - start[s] * linear[c]
            by_unknowns[s, [count + c, count + s]] += state.real[s], -state.real[c]
        values = np.concatenate([*(value[:, 0] for value in now.residual), closure])
        jacobian = np.concatenate([*now.slopes, by_unknowns])
        by_parameter = values.imag / tiny
        residual = values.real
        if self._timed:
            row = np.concatenate([np.ones(count), np.zeros(size)])
            jacobian = np.concatenate([jacobian, row[None]])
            wanted = z[-1] if self.parameter == PERIOD else self.orbit.period
            residual = np.append(residual, z[:count].sum() - wanted / self.order)
            rate = -1.0 / self.order if self.parameter == PERIOD else 0.0
            by_parameter = np.append(by_parameter, rate)
        return residual, np.concatenate([jacobian, by_parameter[:, None]], axis=1)

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        return z[:, : len(self._cycle)]

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """See `Curve`."""
        if not self._parts:
            return []
        ((_, cycle, numbers),) = self._groups(z[None])
        dwell, start = self._unknowns(z[None])
        now = _passed(cycle, numbers, dwell, start)
        sizes = self.sizes[len(self._cycle) : -1]
        return [np.asarray((now.starts[count, 0] - start[0]) / sizes) for count in self._parts]

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `Curve`."""
        found = []
        for places, cycle, numbers in self._groups(z):
            part = z[places]
            dwell, start = self._unknowns(part)
            now = _passed(cycle, numbers, dwell, start)
            phases = range(len(cycle))
            found.append((places, [phase_waves(cycle, numbers, now, dwell, k) for k in phases]))
        return found

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`: the lowest derivative along a flow that is not zero at the start."""
        found = np.empty((len(z), len(self._conditions.rows)))
        for places, cycle, numbers in self._groups(z):
            now = _passed(cycle, numbers, *self._unknowns(z[places]))
            for column, condition in enumerate(self._conditions.rows):
                found[places, column] = condition.value(numbers, now)
        return found

    @property
    def condition_places(self) -> Sequence[int]:
        """See `Curve`."""
        return [condition.place for condition in self._conditions.rows]

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        return self._conditions.taken(conditions)

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        size = len(self._cycle.structure.states)
        found = np.full((len(z), self._rank - self._family), np.nan, dtype=complex)
        for places, cycle, numbers in self._groups(z):
            dwell, start = self._unknowns(z[places])
            now = _passed(cycle, numbers, dwell, start)
            matrices = now.variational[..., :size]
            if self._driven is not None:
                field = numbers.fields[:, cycle.configurations[0]]
                matrices = stroboscopic_maps(cycle, field, start, matrices, self._driven)
            values = eigenvalues(matrices)
            if self._family:
                trivial = np.argmin(abs(values - 1), axis=-1)
                values[np.arange(len(values)), trivial] = 0
                values = sorted_by_size(values)
            found[places] = values[:, : found.shape[1]]
        return found

    def traces(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        powers = self.multipliers(z) ** self.order
        return np.asarray(powers.sum(axis=-1).real + self._trivial)

    @property
    def conservative(self) -> bool:
        """See `Curve`."""
        return self._family

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`."""
        return np.array([self._admissible(point) for point in z])

    def _admissible(self, z: np.ndarray) -> bool:
        if not (np.isfinite(z).all() and (self.dwell(z[None]) > 0).all()):
            return False
        system = piecewise_at(self.orbit.system, self._point(z[-1]))
        cycle = self.orbit.tables.cycle.at(system.structure)
        dwell, start = self._unknowns(z)
        times = np.tile(dwell, self.order)
        now = shoot(cycle, numbers_in(system), times, start, np)
        return bool(assess_cycle(cycle, system, now, times).verdict)

    def at(self, z: np.ndarray) -> Orbit:
        """See `Curve`."""
        orbit, symmetry = self.orbit, self.orbit.symmetry
        period = orbit.given_period
        values = dict(orbit.parameters)
        if self.parameter == PERIOD:
            period = as_value(float(z[-1]))
        else:
            values[self.parameter] = as_value(float(z[-1]))
        dwell, start = self._unknowns(z)
        found = solve_itinerary(
            orbit.system,
            values,
            self._cycle.itinerary,
            dwell.tolist(),
            start.tolist(),
            period=period,
            symmetry=None if symmetry is None else symmetry.matrix,
        )
        assert isinstance(orbit.problem, TableProblem)
        return labelled(found, orbit.problem.label, orbit.problem.names)

    def motion(self, z: np.ndarray) -> Trajectory:
        """The motion at a point: a phase that vanishes there takes no time."""
        system = piecewise_at(self.orbit.system, self._point(z[-1]))
        cycle = self.orbit.tables.cycle.at(system.structure)
        dwell, start = self._unknowns(z)
        times = np.tile(np.maximum(dwell, 0.0), self.order)
        now = shoot(cycle, numbers_in(system), times, start, np)
        shift = now.starts[-1] - start
        return motion_along(system, cycle, times, now.starts[:-1], now.ends, shift, 1)

    def moved(self, name: str, value: float) -> ComposedCurve:
        """See `Curve`."""
        other = copy(self)
        other.orbit = replace(self.orbit, given={**self.orbit.given, name: as_value(value)})
        other._base, other._known = self._base.copy(), (b"", [])
        other._base[self._parameters.index(name)] = value
        return other

    def _unknowns(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Dwell times and start."""
        count = len(self._cycle)
        return z[..., :count], z[..., count:-1]

    def _point(self, value: float) -> np.ndarray:
        point = self._base.copy()
        if self.parameter != PERIOD:
            point[self._parameters.index(self.parameter)] = value
        return point

    def _complex_numbers(self, value: float, tiny: float) -> Numbers:
        """Fields, rows and resets, the last reset that of the part's closure."""
        size = len(self._cycle.structure.states)
        point = self._point(value).astype(complex)
        if self.parameter != PERIOD:
            point[self._parameters.index(self.parameter)] += 1j * tiny
        fields, rows, resets = (
            np.array(self.orbit.system.source(name)(point, lib=FLOATS), dtype=complex)
            for name in ("fields", "rows", "resets")
        )
        resets = resets.reshape(-1, size, size + 1)
        fields, rows = fields.reshape(-1, size, size + 1), rows.reshape(-1, size + 1)
        if self._cycle.structure is not self.orbit.tables.cycle.structure:
            resets = self._closed_resets(fields, rows, resets)
        return Numbers(fields, rows, resets, (), ())

    def _closed_resets(self, fields: Any, rows: Any, resets: Any) -> np.ndarray:
        """The resets, and the one behind which the part closes."""
        orbit, cycle = self.orbit, self.orbit.tables.cycle
        matrix = closing_matrix(cycle.structure, fields, rows, resets, orbit.symmetry)
        last = resets[cycle.transitions[len(self._cycle) - 1].reset]
        found = last if matrix is None else matrix @ last
        return np.concatenate([resets, found[None]])

    def _groups(self, z: np.ndarray) -> list[tuple[np.ndarray, Cycle, Numbers]]:
        """Numbers of the system at many points, grouped by the modes that they have."""
        key = z[:, -1].tobytes()
        if self._known[0] != key:  # one point is asked for its multipliers, waves and conditions
            self._known = key, self._grouped(z[:, -1].tolist())
        return self._known[1]

    def _grouped(self, values: list[float]) -> list[tuple[np.ndarray, Cycle, Numbers]]:
        points = np.stack([self._point(value) for value in values])
        found = []
        for group in numbers_at(self.orbit.system, points):
            numbers = numbers_in(group.structure, group.flat)
            cycle = self._cycle
            if cycle.structure is not self.orbit.tables.cycle.structure:
                arrays = zip(numbers.fields, numbers.rows, numbers.resets, strict=True)
                resets = np.stack([self._closed_resets(*each) for each in arrays])
                numbers = numbers._replace(resets=resets)
            modes = group.structure.shapes
            here = cycle.at(cycle.structure.with_modes(modes))
            found.append((group.places, here, numbers))
        return found


def _passed(cycle: Cycle, numbers: Numbers, dwell: np.ndarray, start: np.ndarray) -> Shooting:
    """Passages of many points; derivatives are infinite where a boundary is touched."""
    with np.errstate(all="ignore"):
        return shoot(cycle, numbers, dwell, start, np)


def _parts(itinerary: tuple[tuple[str, str], ...]) -> list[int]:
    """Numbers of phases of the parts that an itinerary repeats."""
    count = len(itinerary)
    parts = (k for k in range(1, count) if count % k == 0)
    return [k for k in parts if itinerary[:k] * (count // k) == itinerary]
