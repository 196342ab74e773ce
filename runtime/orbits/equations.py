"""The equations of an orbit at many points near it: by its kernels, or by tables.

By tables, unknowns are the dwell times and the state at the start; the equations are the
switching conditions and closure. Flows are exponentials of the fields at a parameter with a tiny
imaginary part: the imaginary part of what comes out is the derivative by the parameter, to
full precision, since the kernels of fields, rows and resets are rational and nothing is
subtracted (Al-Mohy and Higham, Numer. Algorithms 53, 2010).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import eigenvalues
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at, tables_at
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.orbits.admissible import NEITHER, kernel_limits, trigonometric_rows
from nonsmooth.runtime.orbits.kernel_problem import has_reciprocal_pair
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import labelled_as, motion_along
from nonsmooth.runtime.orbits.table_admissible import limits_at
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle, closing
from nonsmooth.runtime.shooting.kernel_newton import (
    dwell_times,
    equations_at,
    judged_at,
    lasting_phases,
    natural_scales,
)
from nonsmooth.runtime.shooting.multipliers import nontrivial
from nonsmooth.runtime.shooting.newton import NEGATIVE, SHORTEST, sure_digits
from nonsmooth.runtime.shooting.section_map import mechanical_states, stroboscopic_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    ShootingDerivatives,
    dependent,
    numbers_in,
    shoot,
    shooting_derivatives,
)
from nonsmooth.runtime.shooting.table_newton import sizes as sizes_along
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["KernelEquations", "OrbitEquations", "equations_of", "phase_waves"]

_SMALLEST = 0.05  # size of an unknown in units of what changes an equation by itself, at least
_ZERO = 1e-9  # relative size below which a derivative counts as zero


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
        return dwell_times(self._kernels, x, self._timed)

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
        # trigonometric sums
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
        phases = []
        for position, phase in enumerate(self._timed):
            boundaries, rows, frequencies = zip(
                *(each for each in every if each[0].phase == phase), strict=True
            )
            names = tuple(boundary.name for boundary in boundaries)
            leaving = names.index(kernels.table["phases"][phase][1])
            asked = position, names, leaving, np.stack(rows, 1), frequencies[0], dwell[:, position]
            phases.append(_phase_waves(*asked))
        return [(np.arange(len(x)), phases)]

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
        system = tables.in_doubles  # branches are followed in double precision
        closed, self._cycle, _ = closing(system, tables.cycle.at(system.structure), symmetry)
        count = len(self._cycle)
        dwell, start = orbit.dwell_times[:count].astype(float), orbit.states[0].astype(float)
        self._numbers = numbers_in(closed)
        self._now = shoot(self._cycle, self._numbers, dwell, start, np)
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
        matrices = dependent(self._shot(x)).variational[..., :-1]
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
        found = self._tables(stepped(x, np.eye(len(x))[place], None)[None])
        return found.each(real_parts), found.each(lambda part: imaginary_parts(part, None))

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


@dataclass(frozen=True)
class ConditionRow:
    """A condition of a transition: a derivative of a row along a configuration's flow."""

    place: int  # phase at whose end it is asked
    row: int  # number of the row
    along: int  # number of the configuration
    order: int  # of the derivative

    def value(self, numbers: Numbers, ends: np.ndarray) -> np.ndarray:
        """Return its values (k,) at k points, from their numbers and the states at the ends.

        `ends` (k, p, N) has the states at the ends of the phases.
        """
        end, field = ends[:, self.place], numbers.fields[:, self.along]
        *_, row = derivatives(numbers.rows[..., self.row, :], field, self.order + 1)
        return np.asarray((row[..., :-1] * end).sum(axis=-1) + row[..., -1])


@dataclass(frozen=True)
class Conditions:
    """The conditions that decide where the transitions of a cycle lead."""

    # for each phase and each transition declared for its boundaries: the conditions, None where
    # all derivatives vanish, and whether they have to be positive
    choices: tuple[tuple[tuple[tuple[ConditionRow | None, bool], ...], ...], ...]

    @cached_property
    def rows(self) -> list[ConditionRow]:
        """All conditions that decide, each once."""
        every = (row for phase in self.choices for each in phase for row, _ in each)
        return [*dict.fromkeys(row for row in every if row is not None)]

    def taken(self, values: np.ndarray) -> np.ndarray:
        """Return which of its transitions each phase takes (k, p), from values (k, c); -1 for none.

        The first whose conditions hold, over the many points of a branch at once.
        """
        signs: dict[ConditionRow | None, Any] = dict(zip(self.rows, values.T > 0, strict=True))
        signs[None] = False
        found = np.full((len(values), len(self.choices)), -1)
        for place, transitions in enumerate(self.choices):
            for number, conditions in reversed([*enumerate(transitions)]):
                holds = np.full(len(values), True)
                for row, positive in conditions:
                    holds &= signs[row] == positive
                found[holds, place] = number
        return found


def conditions_of(cycle: ItineraryShape, numbers: Numbers, now: Shooting) -> Conditions:
    """Return the conditions of a cycle's transitions, by derivatives that decide at a point."""
    return Conditions(
        tuple(
            tuple(
                tuple(
                    (_deciding(numbers, now, place, row, along, cycle.rows[place]), positive)
                    for row, along, positive in transition.conditions
                )
                for transition in cycle.structure.listed(
                    cycle.configurations[place], wanted.boundaries
                )
            )
            for place, wanted in enumerate(cycle.transitions)
        )
    )


def _deciding(
    numbers: Numbers, now: Shooting, place: int, row: int, along: int, own: int
) -> ConditionRow | None:
    """Return the condition of the first derivative that is not zero; None if all are."""
    end = now.ends[place]

    def differs(_: int, function: np.ndarray) -> bool:
        value = float(function[:-1] @ end + function[-1])
        size = float(abs(function[:-1]) @ abs(end) + abs(function[-1]))
        return abs(value) > _ZERO * size

    functions = derivatives(numbers.rows[row], numbers.fields[along], len(end) + 1)
    found = leading(functions, differs, int(row == own))
    return None if found is None else ConditionRow(place, row, along, found.order)


def phase_waves(
    cycle: ItineraryShape, numbers: Numbers, start: np.ndarray, dwell: np.ndarray, place: int
) -> PhaseWaves:
    """Return the boundary functions along one phase at k points, by its configuration's modes.

    `start` (k, N) has the states at the start of the phase, `dwell` (k, p) is in the unit
    of time, and `place` is the number of the phase.
    """
    configuration = cycle.configurations[place]
    shapes = cycle.structure.boundaries[configuration]
    modes = cycle.structure.shapes[configuration]
    exponents = numbers.exponents[configuration]
    flow, field = numbers.flows[configuration], numbers.fields[:, configuration]
    if isinstance(flow, FactoredFlows):
        moved = flow.parts(np.concatenate([start, np.ones((len(start), 1))], axis=1))
    else:
        moved = np.einsum("kfij,kj->kfi", flow[..., :-1], start) + flow[..., -1]
    rows = numbers.rows[:, [shape.row for shape in shapes]]
    coefficients = []
    for _ in range(3):
        values = np.einsum("kbi,kfi->kbf", rows[..., :-1], moved)
        values[..., 0] += rows[..., -1]  # the first function is 1
        coefficients.append(values)
        rows = rows[..., :-1] @ field

    def basis(points: np.ndarray, times: np.ndarray) -> np.ndarray:
        return np.stack(functions_at(modes, exponents[points], times), axis=-1)

    return PhaseWaves(
        place,
        tuple(shape.name for shape in shapes),
        cycle.boundaries[place],
        dwell[:, place],
        float(np.max(np.hypot(exponents[..., 0], exponents[..., 1]), initial=0.0)),
        basis,
        np.stack(coefficients),
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
