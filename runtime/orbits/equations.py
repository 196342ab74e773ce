"""The equations of an orbit and of those near it over parameters: by its kernels, or by tables.

By tables, unknowns are the dwell times and the state at the start; the equations are the
switching conditions and closure. Flows are exponentials of the fields at a parameter with a tiny
imaginary part: the imaginary part of what comes out is the derivative by the parameter, to
full precision, since the kernels of fields, rows and resets are rational and nothing is
subtracted (Al-Mohy and Higham, Numer. Algorithms 53, 2010).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import eigenvalues
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at, tables_at
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.orbits.admissible import (
    NEITHER,
    kernels_allow,
    limits_at,
    trigonometric_rows,
)
from nonsmooth.runtime.orbits.kernel_problem import has_reciprocal_pair
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import labelled_as, motion_along
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

_SMALLEST = 0.05  # size of an unknown in units of what changes an equation by itself, at least
_ZERO = 1e-9  # relative size below which a derivative counts as zero
_LEAP = 1e-6  # of the difference of two parts before a step: what is left of it behind a leap
_EVEN = 1e-15  # what rounding leaves of such a difference


class OrbitEquations(ABC):
    """Orbits of one itinerary as the zeros z = (unknowns, parameters) of its equations.

    Arrays of many points are (k, n + q), nondimensional or in the units of the declaration. The
    q `parameters` are numbers that were given for `orbit`; `lengths`, those of their intervals,
    are their units of measure. An unknown may have been given, and a parameter solved for in its
    place.

    `unknowns` are the names (n,) of what the orbit was solved for, and `first` (n + q,) its point.
    `dwell_names` and `phases`, pairs of configuration and boundary, are those of the p phases
    that take time, of the part that a symmetry closes; `order` such parts make up one period.
    Orbits come in families that a first integral parametrises where they are `conservative`.
    Raises `InputError` for a period that the other parameters determine, or for several forcings.
    """

    unknowns: tuple[str, ...]
    dwell_names: tuple[str, ...]
    phases: tuple[tuple[str, ...], ...]
    conservative: bool
    order = 1

    def __init__(
        self,
        orbit: Orbit,
        names: Sequence[str],
        values: np.ndarray,
        parameters: Sequence[str],
        lengths: Any,
    ) -> None:
        # all numbers of the equations (v,), those of which a point consists among them
        for name in parameters:
            if name not in names:
                raise InputError(f"{orbit.name}: the {name} is determined by the other parameters")
        self.orbit, self.parameters = orbit, tuple(parameters)
        self._values = values
        self._places = [names.index(name) for name in (*self.unknowns, *parameters)]
        self.first = values[self._places]
        self._lengths = np.broadcast_to(lengths, len(parameters))

    @property
    def parameter(self) -> str:
        """The first of the parameters."""
        return self.parameters[0]

    @cached_property
    def sizes(self) -> np.ndarray:
        """Typical sizes (n + q,) of the numbers of a point, as units of measure."""
        return np.concatenate([self._sizes(), self._lengths])

    def equations(self, z: np.ndarray, by: int | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,), m >= n, at one point z (n + q,), and their Jacobian (m, n + q).

        Its columns are those of the unknowns and of all parameters, or of the first `by`.
        """
        full, places = self._full(z), self._places[len(self.unknowns) :][:by]
        found = [self._linearised(full, place) for place in places]
        residual, jacobian = found[0]
        more = [other[:, -1:] for _, other in found[1:]]
        return residual, np.concatenate([jacobian, *more], axis=1)

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """Whether parts that differ at z (n + q,) coincide at `following`, behind a step.

        The step has then met the branch that this one doubles.
        """
        parts = zip(self.unevenness(z), self.unevenness(following), strict=True)
        sizes = [tuple(float(np.abs(part).max()) for part in pair) for pair in parts]
        return any(after < _LEAP * before > _EVEN for before, after in sizes)

    @abstractmethod
    def dwell(self, z: np.ndarray) -> np.ndarray:
        """Dwell times (k, p) of the phases that take time, affine in z (k, n + q)."""

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """Differences (N,) of each repeated part of the itinerary from the first, at z (n + q,).

        They are in units of the states' sizes; the list is empty where no part is repeated. Where
        a difference is zero the branch meets that of the part, and comes back with the parts
        exchanged.
        """
        return []

    @abstractmethod
    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Boundary functions of all phases at points z (k, n + q), in groups of points.

        Each group is an integer array of the places of its points, and a list of their phases.
        """

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """Numbers (k, c) at z (k, n + q) that keep their sign while transitions lead where they do.

        Each is the lowest derivative along a flow that is not zero there. None are asked where a
        phase that begins where the one before it ends shows them.
        """
        return np.empty((len(z), 0))

    @property
    def condition_places(self) -> Sequence[int]:
        """Number of the phase at whose end each of these conditions is asked."""
        return ()

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Number of the transition that each phase takes (k, p), from its conditions (k, c).

        It is -1 where a phase takes none.
        """
        return np.zeros((len(conditions), len(self.phases)), dtype=int)

    @abstractmethod
    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """Multipliers (k, r), complex, over one part at z (k, n + q), without trivial ones.

        Those that are always zero are left out too.
        """

    @abstractmethod
    def traces(self, z: np.ndarray) -> np.ndarray:
        """Traces (k,) of the Poincare map of the whole period, at z (k, n + q)."""

    @abstractmethod
    def admissible(self, z: np.ndarray) -> np.ndarray:
        """Mask (k,) of the points z (k, n + q) that are motions of the real system."""

    @abstractmethod
    def at(self, z: np.ndarray) -> Orbit:
        """The orbit at one point z (n + q,), as a record."""

    @abstractmethod
    def motion(self, z: np.ndarray) -> Motion | Trajectory:
        """The motion at one point z (n + q,), where a phase that vanishes takes no time."""

    @abstractmethod
    def _sizes(self) -> np.ndarray:
        """Typical sizes (n,) of the unknowns."""

    @abstractmethod
    def _linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,) at all numbers (v,), and their Jacobian (m, n + 1).

        The columns are derivatives by the unknowns, then by the number at `place`.
        """

    def _full(self, z: np.ndarray) -> np.ndarray:
        """All numbers of the equations at a point (n + q,), or at many (k, n + q)."""
        full = np.empty((*z.shape[:-1], len(self._values)))
        full[...] = self._values
        full[..., self._places] = z
        return full

    def _given(self, z: np.ndarray) -> dict[str, Value]:
        """Parameters at a point, with the period where it is given."""
        values = zip(self.parameters, z[len(self.unknowns) :].tolist(), strict=True)
        return {**self.orbit.given, **{name: as_value(value) for name, value in values}}


class KernelEquations(OrbitEquations):
    """The equations of an orbit with kernels."""

    def __init__(self, orbit: Orbit, *parameters: str, lengths: Any = 1.0) -> None:
        self._kernels = kernels = orbit.kernels
        table, names = kernels.table, (*kernels.unknowns, *kernels.parameter_names)
        self.unknowns = tuple(orbit.unknowns)
        self._count = len(kernels.unknowns)
        self._sought = [names.index(name) for name in self.unknowns]
        self._timed = lasting_phases(kernels)
        self.dwell_names = tuple(kernels.dwell_times[k] for k in self._timed)
        self.phases = tuple(tuple(table["phases"][k][:2]) for k in self._timed)
        self.conservative = bool(table["conservative"])
        self._pair = has_reciprocal_pair(orbit)
        values = np.array([float(orbit.values[name]) for name in names])
        super().__init__(orbit, names, values, parameters, lengths)

    def _sizes(self) -> np.ndarray:
        """See `OrbitEquations`."""
        unknowns = abs(self._values[self._sought])
        waits = np.array([name in self._kernels.dwell_times for name in self.unknowns])
        jacobian = equations_at(self._kernels, self._values).jacobian
        own = natural_scales(jacobian, self._values)[1][self._sought]
        return np.where(waits, float(self.orbit.period), np.maximum(unknowns, _SMALLEST * own))

    def _linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """See `OrbitEquations`."""
        found = equations_at(self._kernels, x)
        return found.residual, found.jacobian[:, [*self._sought, place]]

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return dwell_times(self._kernels, self._full(z), self._timed)

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `OrbitEquations`."""
        # trigonometric sums
        kernels, opened, dwell = self._kernels, self.orbit.opened, self.dwell(z)
        found = kernels.evaluate("coefficients", "frequencies", at=self._arguments(z))
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
        return [(np.arange(len(z)), phases)]

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        table = self._kernels.table
        if table["rank"] == 1:
            return self.traces(z)[:, None].astype(complex)[:, int(table["conservative"]) :]
        if self._pair:
            half = (self.traces(z) - 1) / 2
            with np.errstate(all="ignore"):
                root = np.sqrt(half.astype(complex) ** 2 - 1)
                larger = np.where(half > 0, half + root, half - root)
                return np.stack([larger, 1 / larger], axis=-1)
        matrices = self._kernels.evaluate("poincare_jacobian", at=self._arguments(z))
        return nontrivial(eigenvalues(matrices), table["rank"], family=self.conservative)

    def traces(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return np.asarray(self._kernels.evaluate("trace", at=self._arguments(z)))

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        parameters, _, unknowns = self._arguments(z)
        allowed = kernels_allow(self._kernels, parameters, unknowns, self.orbit.opened)
        return allowed & (self.dwell(z) > 0).all(axis=-1)

    def at(self, z: np.ndarray) -> Orbit:
        """See `OrbitEquations`."""
        residual, error, status = judged_at(self._kernels, self._full(z), self._sought)
        return replace(
            self.orbit,
            given=self._given(z),
            unknowns=dict(zip(self.unknowns, z[: len(self.unknowns)].tolist(), strict=True)),
            residual=residual,
            digits=sure_digits(error),
            status=status,
        )

    def motion(self, z: np.ndarray) -> Motion:
        """See `OrbitEquations`."""
        return self.at(z).motion()

    def _arguments(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Parameters, spectrum and unknowns of points, in the kernels' order."""
        x = self._full(z)
        unknowns, parameters = x[:, : self._count], x[:, self._count :]
        return parameters, self._kernels.spectrum(parameters)[0], unknowns


class TableEquations(OrbitEquations):
    """The equations of an orbit without kernels.

    The period is one of the numbers where it was given and no other number determines it.
    """

    def __init__(self, orbit: Orbit, *parameters: str, lengths: Any = 1.0) -> None:
        self._tabled = tabled = orbit.problem.by_tables(orbit)
        tables, symmetry = tabled.tables, tabled.symmetry
        if len(tables.cycle.structure.forcing) > 1:
            raise InputError(f"{orbit.name} has several forcings: its branches are not followed")
        self.order = 1 if symmetry is None else symmetry.order
        system = tables.in_doubles  # branches are followed in double precision
        closed, self._cycle, _ = closing(system, tables.cycle.at(system.structure), symmetry)
        count = len(self._cycle)
        dwell, start = tabled.dwell_times[:count].astype(float), tabled.states[0].astype(float)
        self._numbers = numbers_in(closed)
        self._now = shoot(self._cycle, self._numbers, dwell, start, np)
        self.dwell_names = tabled.dwell_time_names[:count]
        self.phases = self._cycle.itinerary
        self.unknowns = (*self.dwell_names, *tuple(tabled.unknowns)[len(tabled.itinerary) :])
        stability = tabled.stability if symmetry is None else tabled.part_stability
        shifts = len(tables.translations)
        self._rank, self.conservative = stability.rank - shifts, tables.family
        self._trivial = shifts + tables.family
        self._driven = mechanical_states(self._cycle)
        # a forcing, or no family, determines the period by itself
        self._timed = tabled.given_period is not None and tables.family
        known = [p.name for p in tabled.system.parameters]
        self._numbered = slice(len(self.unknowns), len(self.unknowns) + len(known))
        self._repeated = _parts(self.phases)
        self._passed: tuple[bytes, ShootingDerivatives | None] = (b"", None)
        given = [float(tabled.parameters[name]) for name in known]
        period = {PERIOD: float(tabled.period)} if self._timed else {}
        values = np.array([*dwell, *start, *given, *period.values()])
        super().__init__(orbit, (*self.unknowns, *known, *period), values, parameters, lengths)

    def _sizes(self) -> np.ndarray:
        """See `OrbitEquations`."""
        count = len(self._cycle)
        dwell = self._values[:count]
        return np.concatenate([np.full(count, dwell.sum()), sizes_along(self._now, dwell)])

    def _linearised(self, x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
        """See `OrbitEquations`."""
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
        by_place = -1.0 / self.order if place == len(x) - 1 else 0.0
        row = np.concatenate([np.ones(count), np.zeros(size), [by_place]])
        residual = np.append(residual, dwell.sum() - x[-1] / self.order)
        return residual, np.concatenate([jacobian, row[None]])

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        return z[:, : len(self._cycle)]

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """See `OrbitEquations`."""
        if not self._repeated:
            return []
        start, sizes = self._unknowns(z)[1], self._unknowns(self.sizes)[1]
        starts = self._shot(self._full(z)[None]).starts[0]
        return [np.asarray((starts[count] - start) / sizes) for count in self._repeated]

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """See `OrbitEquations`."""
        found, x = [], self._full(z)
        starts, dwell = self._shot(x).starts, self.dwell(z)
        system, visited = self._tabled.system, self._cycle.configurations
        for group in numbers_at(system, x[:, self._numbered], visited):
            places, numbers = group.places, numbers_in(group.structure, group.flat)
            cycle = self._cycle.at(self._cycle.structure.with_modes(group.structure.shapes))
            phases = [
                phase_waves(cycle, numbers, starts[places, k], dwell[places], k)
                for k in range(len(cycle))
            ]
            found.append((places, phases))
        return found

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        x = self._full(z)
        now, numbers = self._shot(x), self._tables(x)
        values = [condition.value(numbers, now.ends) for condition in self._conditions.rows]
        return np.stack(values, axis=-1) if values else np.empty((len(x), 0))

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

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        x = self._full(z)
        matrices = dependent(self._shot(x)).variational[..., :-1]
        if self._driven is not None:
            field = self._tables(x).fields[:, self._cycle.configurations[0]]
            start = self._unknowns(x)[1]
            matrices = stroboscopic_maps(self._cycle, field, start, matrices, self._driven)
        return nontrivial(eigenvalues(matrices), self._rank, family=self.conservative)

    def traces(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        powers = self.multipliers(z) ** self.order
        return np.asarray(powers.sum(axis=-1).real + self._trivial)

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """See `OrbitEquations`."""
        found, x = np.full(len(z), False), self._full(z)
        told = np.flatnonzero(np.isfinite(x).all(axis=-1) & (self.dwell(z) > 0).all(axis=-1))
        if not len(told):
            return found
        system, cycle = self._tabled.system, self._tabled.tables.cycle
        dwell, start = self._unknowns(x[told])
        points, times = x[told][:, self._numbered], np.tile(dwell, self.order)
        numbers = Numbers(*tables_at(system, points))
        starts = shooting_derivatives(cycle, numbers, times, start).starts[:, :-1]
        found[told] = limits_at(system, cycle, points, times, starts) == NEITHER
        return found

    def at(self, z: np.ndarray) -> Orbit:
        """See `OrbitEquations`."""
        orbit, symmetry = self._tabled, self._tabled.symmetry
        x, given = self._full(z), self._given(z)
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

    def motion(self, z: np.ndarray) -> Trajectory:
        """See `OrbitEquations`."""
        x = self._full(z)
        system = piecewise_at(self._tabled.system, x[self._numbered])
        cycle = self._tabled.tables.cycle.at(system.structure)
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
        numbers = Numbers(*tables_at(self._tabled.system, x[:, self._numbered]))
        cycle = self._tabled.tables.cycle
        if self._cycle.structure is cycle.structure:
            return numbers
        return closed_cycle(cycle, numbers, self._tabled.symmetry)[1]

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


def equations_of(orbit: Orbit, *parameters: str, lengths: Any = 1.0) -> OrbitEquations:
    """Return the equations of an orbit: those of its kernels where they are the faster ones.

    Kernels of damped and forced motions are faster only where they are compiled: a
    compilation takes seconds, and the tables of a system follow a branch in less.
    """
    kernels = orbit.problem.kernels
    own = kernels is not None and kernels.trigonometric
    return (KernelEquations if own else TableEquations)(orbit, *parameters, lengths=lengths)
