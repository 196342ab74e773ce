"""The equations of an orbit by the tables of its system, at many points.

Unknowns are the dwell times and the state at the start; the equations are the switching
conditions and closure. Flows are exponentials of the fields at a parameter with a tiny
imaginary part: the imaginary part of what comes out is the derivative by the parameter, to
full precision, since the kernels of fields, rows and resets are rational and nothing is
subtracted (Al-Mohy and Higham, Numer. Algorithms 53, 2010).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.matrices import (
    eigenvalues,
    exponentials,
    sorted_by_size,
)
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.orbits.table_motion import motion_along
from nonsmooth.runtime.orbits.table_phase_functions import Conditions, conditions_of, phase_waves
from nonsmooth.runtime.orbits.table_problem import TableProblem, labelled
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.section_map import mechanical_states, stroboscopic_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    numbers_in,
    phases_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetric_orbit import closing, closing_matrix
from nonsmooth.runtime.shooting.table_newton import sizes as sizes_along
from nonsmooth.runtime.shooting.variational import COMPLEX_STEP, Shooting, shooting_map
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["TableEquations"]

_IMAGINARY = 1e-30  # of the parameter, in units of max(1, |it|)


class TableEquations:
    """The equations of an orbit without kernels, near it; see `OrbitEquations`.

    The period is one of the numbers where it was given and no other number determines it.
    """

    def __init__(self, orbit: Orbit) -> None:
        tables, symmetry = orbit.tables, orbit.symmetry
        if len(tables.cycle.structure.forcing) > 1:
            raise InputError(f"{orbit.name} has several forcings: its branches are not followed")
        self.orbit = orbit
        self.order = 1 if symmetry is None else symmetry.order
        closed, self._cycle = closing(tables.piecewise, tables.cycle, symmetry)
        count = len(self._cycle)
        dwell, start = orbit.dwell_times[:count].astype(float), orbit.states[0].astype(float)
        self._now = shoot(self._cycle, numbers_in(closed), dwell, start, np)
        self._numbers = numbers_in(closed)
        self.dwell_names = orbit.dwell_time_names[:count]
        self.phases = self._cycle.itinerary
        self.unknowns = (*self.dwell_names, *tuple(orbit.unknowns)[len(orbit.itinerary) :])
        stability = orbit.stability if symmetry is None else orbit.part_stability
        shifts = len(tables.translations)
        self._rank, self.conservative = stability.rank - shifts, tables.family
        self._trivial = shifts + tables.family
        self._driven = mechanical_states(self._cycle)
        # a forcing, or no family, determines the period by itself
        self._timed = orbit.given_period is not None and tables.family
        parameters = [p.name for p in orbit.system.parameters]
        self.names = (*self.unknowns, *parameters, *([PERIOD] if self._timed else []))
        given = [float(orbit.parameters[name]) for name in parameters]
        self.values = np.array([*dwell, *start, *given, *([orbit.period] if self._timed else [])])
        self._given = slice(len(self.unknowns), len(self.unknowns) + len(parameters))
        self._repeated = _parts(self.phases)
        self._known: tuple[bytes, list[tuple[np.ndarray, ItineraryShape, Numbers]]] = (b"", [])

    @cached_property
    def sizes(self) -> np.ndarray:
        """See `OrbitEquations`."""
        count = len(self._cycle)
        dwell = self.values[:count]
        return np.concatenate([np.full(count, dwell.sum()), sizes_along(self._now, dwell)])

    def linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """See `OrbitEquations`."""
        cycle, count, size = self._cycle, len(self._cycle), len(self._cycle.structure.states)
        tiny = _IMAGINARY * max(1.0, abs(x[place]))
        numbers = self._complex_numbers(x, place, tiny)
        dwell, start = self._unknowns(x)
        generators = np.zeros((count, size + 1, size + 1), dtype=complex)
        generators[:, :size] = numbers.fields[list(cycle.configurations)]
        flows = exponentials(generators * dwell[:, None, None])[:, :size]
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
        by_place = values.imag / tiny
        residual = values.real
        if self._timed:
            row = np.concatenate([np.ones(count), np.zeros(size)])
            jacobian = np.concatenate([jacobian, row[None]])
            residual = np.append(residual, dwell.sum() - x[-1] / self.order)
            is_period = place == len(self.names) - 1
            by_place = np.append(by_place, -1.0 / self.order if is_period else 0.0)
        return residual, np.concatenate([jacobian, by_place[:, None]], axis=1)

    def dwell(self, x: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return x[:, : len(self._cycle)]

    def unevenness(self, x: np.ndarray) -> list[np.ndarray]:
        """See `OrbitEquations`."""
        if not self._repeated:
            return []
        ((_, cycle, numbers),) = self._groups(x[None])
        dwell, start = self._unknowns(x[None])
        now = _passed(cycle, numbers, dwell, start)
        sizes = self.sizes[len(self._cycle) :]
        return [np.asarray((now.starts[count, 0] - start[0]) / sizes) for count in self._repeated]

    def waves(self, x: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `OrbitEquations`."""
        found = []
        for places, cycle, numbers in self._groups(x):
            part = x[places]
            dwell, start = self._unknowns(part)
            now = _passed(cycle, numbers, dwell, start)
            phases = range(len(cycle))
            found.append((places, [phase_waves(cycle, numbers, now, dwell, k) for k in phases]))
        return found

    def conditions(self, x: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`: the lowest derivative along a flow that is not zero there."""
        found = np.empty((len(x), len(self._conditions.rows)))
        for places, cycle, numbers in self._groups(x):
            now = _passed(cycle, numbers, *self._unknowns(x[places]))
            for column, condition in enumerate(self._conditions.rows):
                found[places, column] = condition.value(numbers, now)
        return found

    @cached_property
    def _conditions(self) -> Conditions:
        return conditions_of(self._cycle, self._numbers, self._now)

    @property
    def condition_places(self) -> Sequence[int]:
        """See `OrbitEquations`."""
        return [condition.place for condition in self._conditions.rows]

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return self._conditions.taken(conditions)

    def multipliers(self, x: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        size = len(self._cycle.structure.states)
        found = np.full((len(x), self._rank - self.conservative), np.nan, dtype=complex)
        for places, cycle, numbers in self._groups(x):
            dwell, start = self._unknowns(x[places])
            now = _passed(cycle, numbers, dwell, start)
            matrices = now.variational[..., :size]
            if self._driven is not None:
                field = numbers.fields[:, cycle.configurations[0]]
                matrices = stroboscopic_maps(cycle, field, start, matrices, self._driven)
            values = eigenvalues(matrices)
            if self.conservative:
                trivial = np.argmin(abs(values - 1), axis=-1)
                values[np.arange(len(values)), trivial] = 0
                values = sorted_by_size(values)
            found[places] = values[:, : found.shape[1]]
        return found

    def traces(self, x: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        powers = self.multipliers(x) ** self.order
        return np.asarray(powers.sum(axis=-1).real + self._trivial)

    def admissible(self, x: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return np.array([self._admissible(point) for point in x])

    def _admissible(self, x: np.ndarray) -> bool:
        if not (np.isfinite(x).all() and (self.dwell(x[None]) > 0).all()):
            return False
        cycle = self.orbit.tables.cycle
        system = piecewise_at(self.orbit.system, x[self._given], cycle.configurations)
        cycle = cycle.at(system.structure)
        dwell, start = self._unknowns(x)
        times = np.tile(dwell, self.order)
        now = shoot(cycle, numbers_in(system), times, start, np)
        return bool(assess_cycle(cycle, system, now, times).verdict)

    def orbit_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Orbit:
        """See `OrbitEquations`."""
        orbit, symmetry = self.orbit, self.orbit.symmetry
        dwell, start = self._unknowns(x)
        found = solve_itinerary(
            orbit.system,
            {name: given[name] for name in orbit.parameters},
            self._cycle.itinerary,
            dwell.tolist(),
            start.tolist(),
            period=given.get(PERIOD),
            symmetry=None if symmetry is None else symmetry.matrix,
        )
        assert isinstance(orbit.problem, TableProblem)
        return labelled(found, orbit.problem.label, orbit.problem.names)

    def motion_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Trajectory:
        """See `OrbitEquations`."""
        system = piecewise_at(self.orbit.system, x[self._given])
        cycle = self.orbit.tables.cycle.at(system.structure)
        dwell, start = self._unknowns(x)
        times = np.tile(np.maximum(dwell, 0.0), self.order)
        now = shoot(cycle, numbers_in(system), times, start, np)
        shift = now.starts[-1] - start
        return motion_along(system, cycle, times, now.starts[:-1], now.ends, shift, 1)

    def _unknowns(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Dwell times and start."""
        count = len(self._cycle)
        return x[..., :count], x[..., count : len(self.unknowns)]

    def _complex_numbers(self, x: np.ndarray, place: int, tiny: float) -> Numbers:
        """Fields, rows and resets, the last reset that of the part's closure."""
        size = len(self._cycle.structure.states)
        numbers = x.astype(complex)
        numbers[place] += 1j * tiny
        point = numbers[self._given]
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

    def _groups(self, x: np.ndarray) -> list[tuple[np.ndarray, ItineraryShape, Numbers]]:
        """Numbers of the system at many points, grouped by the modes that they have."""
        points = x[:, self._given]
        key = points.tobytes()
        if self._known[0] != key:  # one point is asked for its multipliers, waves and conditions
            self._known = key, self._grouped(points)
        return self._known[1]

    def _grouped(self, points: np.ndarray) -> list[tuple[np.ndarray, ItineraryShape, Numbers]]:
        found = []
        for group in numbers_at(self.orbit.system, points, self._cycle.configurations):
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


def _passed(
    cycle: ItineraryShape, numbers: Numbers, dwell: np.ndarray, start: np.ndarray
) -> Shooting:
    """Passages of many points; derivatives are infinite where a boundary is touched."""
    with np.errstate(all="ignore"):
        return shoot(cycle, numbers, dwell, start, np)


def _parts(itinerary: tuple[tuple[str, str], ...]) -> list[int]:
    """Numbers of phases of the parts that an itinerary repeats."""
    count = len(itinerary)
    parts = (k for k in range(1, count) if count % k == 0)
    return [k for k in parts if itinerary[:k] * (count // k) == itinerary]
