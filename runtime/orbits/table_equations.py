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

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import eigenvalues
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise, piecewise_at, tables_at
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import labelled_as, motion_along
from nonsmooth.runtime.orbits.table_admissible import limits_at
from nonsmooth.runtime.orbits.table_phase_functions import Conditions, conditions_of, phase_waves
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle, closing
from nonsmooth.runtime.shooting.multipliers import nontrivial
from nonsmooth.runtime.shooting.newton import NEGATIVE, SHORTEST
from nonsmooth.runtime.shooting.section_map import mechanical_states, stroboscopic_maps
from nonsmooth.runtime.shooting.shooting_map import (
    Numbers,
    ShootingDerivatives,
    dependent_variational,
    itinerary_shape,
    numbers_in,
    shoot,
    shooting_derivatives,
)
from nonsmooth.runtime.shooting.table_newton import sizes as sizes_along
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["TableEquations"]

_IMAGINARY = 1e-30  # of the parameter, in units of max(1, |it|)


class TableEquations:
    """The equations of an orbit without kernels, near it; see `KernelEquations`.

    The period is one of the numbers where it was given and no other number determines it.
    """

    def __init__(self, orbit: Orbit) -> None:
        tables, symmetry = orbit.tables, orbit.symmetry
        if len(tables.cycle.structure.forcing) > 1:
            raise InputError(f"{orbit.name} has several forcings: its branches are not followed")
        self.orbit = orbit
        self.order = 1 if symmetry is None else symmetry.order
        system, cycle = tables.piecewise, tables.cycle
        if orbit.precise:  # branches are followed in double precision
            system = piecewise(orbit.problem.system, orbit.parameters)
            cycle = itinerary_shape(system.structure, orbit.itinerary)
        closed, self._cycle, _ = closing(system, cycle, symmetry)
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
        self._passed: tuple[bytes, ShootingDerivatives | None] = (b"", None)

    @cached_property
    def sizes(self) -> np.ndarray:
        """See `KernelEquations`."""
        count = len(self._cycle)
        dwell = self.values[:count]
        return np.concatenate([np.full(count, dwell.sum()), sizes_along(self._now, dwell)])

    def linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """See `KernelEquations`."""
        cycle, count, size = self._cycle, len(self._cycle), len(self._cycle.structure.states)
        numbers, changes = self._changing(x, place)
        dwell, start = self._unknowns(x)
        now = shooting_derivatives(cycle, numbers, dwell[None], start[None], changes)
        state, linear, jacobian = now.starts[0, -1], now.variational[0], now.slopes[0]
        closure, by_unknowns = state - start, linear.copy()
        by_unknowns[:, count:-1] -= np.eye(size)
        for c, s in cycle.structure.forcing:
            # its amplitude is 1; that it turns by whole turns is one equation, not two
            closure[c] = start[c] ** 2 + start[s] ** 2 - 1
            by_unknowns[c] = 0
            by_unknowns[c, [count + c, count + s]] = 2 * start[[c, s]]
            closure[s] = start[c] * state[s] - start[s] * state[c]
            by_unknowns[s] = start[c] * linear[s] - start[s] * linear[c]
            by_unknowns[s, [count + c, count + s]] += state[s], -state[c]
        residual = np.concatenate([now.residual[0], closure])
        jacobian = np.concatenate([jacobian, by_unknowns])
        if not self._timed:
            return residual, jacobian
        by_place = -1.0 / self.order if place == len(self.names) - 1 else 0.0
        row = np.concatenate([np.ones(count), np.zeros(size), [by_place]])
        residual = np.append(residual, dwell.sum() - x[-1] / self.order)
        return residual, np.concatenate([jacobian, row[None]])

    def dwell(self, x: np.ndarray) -> np.ndarray:
        """See `KernelEquations`."""
        return x[:, : len(self._cycle)]

    def unevenness(self, x: np.ndarray) -> list[np.ndarray]:
        """See `KernelEquations`."""
        if not self._repeated:
            return []
        start = self._unknowns(x)[1]
        starts, sizes = self._shot(x[None]).starts[0], self.sizes[len(self._cycle) :]
        return [np.asarray((starts[count] - start) / sizes) for count in self._repeated]

    def waves(self, x: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `KernelEquations`."""
        found = []
        starts, dwell = self._shot(x).starts, self.dwell(x)
        system, visited = self.orbit.system, self._cycle.configurations
        for group in numbers_at(system, x[:, self._given], visited):
            places, numbers = group.places, numbers_in(group.structure, group.flat)
            cycle = self._cycle.at(self._cycle.structure.with_modes(group.structure.shapes))
            phases = [
                phase_waves(cycle, numbers, starts[places, k], dwell[places], k)
                for k in range(len(cycle))
            ]
            found.append((places, phases))
        return found

    def conditions(self, x: np.ndarray) -> np.ndarray:
        """Return numbers (k, c) that keep their sign while transitions lead where they do.

        Each is the lowest derivative along a flow that is not zero there.
        """
        now, numbers = self._shot(x), self._tables(x)
        values = [condition.value(numbers, now.ends) for condition in self._conditions.rows]
        return np.stack(values, axis=-1) if values else np.empty((len(x), 0))

    @cached_property
    def _conditions(self) -> Conditions:
        return conditions_of(self._cycle, self._numbers, self._now)

    @property
    def condition_places(self) -> Sequence[int]:
        """The phase at whose end each of these conditions is asked."""
        return [condition.place for condition in self._conditions.rows]

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """See `KernelEquations`."""
        return self._conditions.taken(conditions)

    def multipliers(self, x: np.ndarray) -> np.ndarray:
        """See `KernelEquations`."""
        matrices = dependent_variational(self._shot(x))
        if self._driven is not None:
            field = self._tables(x).fields[:, self._cycle.configurations[0]]
            start = self._unknowns(x)[1]
            matrices = stroboscopic_maps(self._cycle, field, start, matrices, self._driven)
        return nontrivial(eigenvalues(matrices), self._rank, family=self.conservative)

    def traces(self, x: np.ndarray) -> np.ndarray:
        """See `KernelEquations`."""
        powers = self.multipliers(x) ** self.order
        return np.asarray(powers.sum(axis=-1).real + self._trivial)

    def admissible(self, x: np.ndarray) -> np.ndarray:
        """See `KernelEquations`."""
        found = np.full(len(x), False)
        told = np.flatnonzero(np.isfinite(x).all(axis=-1) & (self.dwell(x) > 0).all(axis=-1))
        if not len(told):
            return found
        system, cycle = self.orbit.system, self.orbit.tables.cycle
        dwell, start = self._unknowns(x[told])
        points, times = x[told][:, self._given], np.tile(dwell, self.order)
        numbers = Numbers(*tables_at(system, points))
        starts = shooting_derivatives(cycle, numbers, times, start).starts[:, :-1]
        found[told] = limits_at(system, cycle, points, times, starts) == NEITHER
        return found

    def orbit_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Orbit:
        """See `KernelEquations`."""
        orbit, symmetry = self.orbit, self.orbit.symmetry
        dwell, start = self._unknowns(x)
        parameters = {name: given[name] for name in orbit.parameters}
        options: Any = {
            "period": given.get(PERIOD),
            "symmetry": None if symmetry is None else symmetry.matrix,
        }
        asked = orbit.system, parameters, self._cycle.itinerary
        found = None
        if dwell.min() < SHORTEST * dwell.sum():  # where it vanishes the equations are singular
            dwell = np.maximum(dwell, 0.0)
            now = self._shot(np.concatenate([dwell, x[len(dwell) :]])[None])
            left = max(np.abs(now.residual).max(), np.abs(now.starts[0, -1] - start).max())
            known = now.starts[0, :-1], float(left)
            found = solve_itinerary(*asked, dwell, known=known, **options)
        if found is None or found.status != NEGATIVE:
            found = solve_itinerary(*asked, dwell.tolist(), start.tolist(), **options)
        return labelled_as(found, orbit)

    def motion_at(self, x: np.ndarray, given: Mapping[str, Value]) -> Trajectory:
        """See `KernelEquations`."""
        system = piecewise_at(self.orbit.system, x[self._given])
        cycle = self.orbit.tables.cycle.at(system.structure)
        dwell, start = self._unknowns(x)
        times = np.tile(np.maximum(dwell, 0.0), self.order)
        now = shoot(cycle, numbers_in(system), times, start, np)
        shift = now.starts[-1] - start
        return motion_along(system, cycle, times, now.starts[:-1], now.ends, shift, 1)

    def _unknowns(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return dwell times and starts of points."""
        count = len(self._cycle)
        return x[..., :count], x[..., count : len(self.unknowns)]

    def _changing(self, x: np.ndarray, place: int) -> tuple[Numbers, Numbers]:
        """Return fields, rows and resets at one point, and their derivatives by one number."""
        tiny = _IMAGINARY * max(1.0, abs(x[place]))
        point = x.astype(complex)
        point[place] += 1j * tiny
        fields, rows, resets, *_ = self._tables(point[None])
        return (
            Numbers(fields.real, rows.real, resets.real),
            Numbers(fields.imag / tiny, rows.imag / tiny, resets.imag / tiny),
        )

    def _tables(self, x: np.ndarray) -> Numbers:
        """Return fields, rows and resets at many points, with that of the part's closure."""
        numbers = Numbers(*tables_at(self.orbit.system, x[:, self._given]))
        cycle = self.orbit.tables.cycle
        if self._cycle.structure is cycle.structure:
            return numbers
        return closed_cycle(cycle, numbers, self.orbit.symmetry)[1]

    def _shot(self, x: np.ndarray) -> ShootingDerivatives:
        """Return the passages of many points, with derivatives."""
        key, found = self._passed
        if found is None or key != x.tobytes():  # who asks for multipliers asks for conditions
            found = shooting_derivatives(self._cycle, self._tables(x), *self._unknowns(x))
            self._passed = x.tobytes(), found
        return found


def _parts(itinerary: tuple[tuple[str, str], ...]) -> list[int]:
    """Return how many phases each of the parts has that an itinerary repeats."""
    count = len(itinerary)
    parts = (k for k in range(1, count) if count % k == 0)
    return [k for k in parts if itinerary[:k] * (count // k) == itinerary]
