"""Derivatives of what is seen along an orbit: states, extremes, margins, dissipation.

An extreme is found by the guaranteed search; its derivative is that of the function at the
place where it is attained (J. Danskin, 1967, the envelope theorem).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.events.boundary_functions import PhaseWaves, interior_maxima
from nonsmooth.runtime.model.flows import composite_rule
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise
from nonsmooth.runtime.orbits.directions import Directions
from nonsmooth.runtime.orbits.impact_losses import impact_losses
from nonsmooth.runtime.orbits.local_extremes import KINDS
from nonsmooth.runtime.orbits.table_directions import (
    numbers_along,
    passed,
    relative_changes,
    working,
)
from nonsmooth.runtime.orbits.table_phase_functions import phase_waves
from nonsmooth.runtime.shooting.derivatives import flows_over
from nonsmooth.runtime.shooting.shooting_map import numbers_in
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.simulation.extremes import extremes
from nonsmooth.runtime.simulation.phase_functions import Phases, fastest

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["BoundaryMargin", "Differentiated", "OrbitMotionDerivatives", "Transversality"]

_TOUCH = 1e-9  # relative size below which a boundary function is zero at a phase's end
_TIED = 1e-9  # relative difference of extremes that are as large as each other
_SAME = 1e-6  # relative difference of rates that are the same but for rounding
_EDGE = 1e-9  # of a phase: an extreme nearer to its end is taken at the end
_NODES = 12  # of an integral, in a piece
_ANGLE = 2.0  # radians in a piece

Row = Callable[[int], np.ndarray]  # of a configuration: (q, N + 1) with steps


class Differentiated(NamedTuple):
    """A number, its derivatives (q,), and the time since the start at which it is attained."""

    value: Any
    rates: np.ndarray
    time: Any


class BoundaryMargin(NamedTuple):
    """The distance of a boundary along a phase: the least of minus its function."""

    phase: int  # counted from 0
    configuration: str
    boundary: str
    value: Any  # in the boundary's unit
    rates: np.ndarray  # (q,)
    time: Any  # since the start of the orbit


class Transversality(NamedTuple):
    """Speed with which a boundary is reached at the end of a phase, and its derivatives (q,)."""

    phase: int
    boundary: str
    value: Any
    rates: np.ndarray


class OrbitMotionDerivatives:
    """An orbit by tables as it moves in q directions, with derivatives as complex steps."""

    def __init__(self, orbit: Orbit, by: Sequence[str], directions: Directions) -> None:
        self.orbit, self.by = orbit, tuple(by)
        tables = orbit.tables
        self.cycle, self.lib = tables.cycle, working(orbit)
        self.structure = self.cycle.structure
        self.numbers = numbers_along(orbit, by, self.lib)
        starts, dwell = tables.states_up_to_shift, orbit.dwell_times
        if self.lib is not None:
            lift = np.frompyfunc(self.lib.mp.mpf, 1, 1)
            starts, dwell = lift(starts), lift(dwell)
        self.dwell, self.waits = dwell, directions.dwell
        self.starts = stepped(starts[None], directions.starts, self.lib)
        self.begins = np.concatenate([[0 * dwell[0]], np.cumsum(dwell)])
        self.shifted = np.concatenate(
            [np.zeros((len(self.by), 1), dtype=int), np.cumsum(directions.dwell, axis=1)], axis=1
        )

    def state(self, phase: int, since: Any, rate: Any) -> np.ndarray:
        """Return the state (q, N), with its steps, at a time since the start of a phase.

        `rate` (q,) is the rate of that time.
        """
        field = self.numbers.fields[:, self.cycle.configurations[phase]]
        times = stepped(since, rate, self.lib)
        flow = flows_over(field, times, self.lib)
        return np.asarray((flow[..., :-1] @ self.starts[:, phase, :, None])[..., 0] + flow[..., -1])

    def states(self, times: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
        """Return states (m, N) at times of the period, since the start, and derivatives (m, N, q).

        `InputError` is raised for a time outside of the period.
        """
        found = []
        for time in times:
            at = float(time) if self.lib is None else self.lib.mp.mpf(time)
            if not 0 <= at <= self.begins[-1]:
                raise InputError(f"time = {float(at):g} is not within the period")
            places = [k for k, begin in enumerate(self.begins[:-1]) if begin <= at]
            last = places[-1]
            since = at - self.begins[last]
            found.append(self.state(last, since, -self.shifted[:, last]))
        size = len(self.structure.states)
        every = np.array(found).reshape(len(found), len(self.by), size)
        values, rates = real_parts(every[:, 0]), imaginary_parts(every, self.lib)
        return self._rounded(values), self._rounded(np.moveaxis(rates, 1, -1))

    @cached_property
    def _phases(self) -> Phases:
        """The phases in double precision."""
        tables = self.orbit.tables
        return Phases(
            self.begins[:-1].astype(float),
            self.dwell.astype(float),
            np.array(self.cycle.configurations),
            tables.states_up_to_shift.astype(float),
            tables.shooting.ends.astype(float),
        )

    @cached_property
    def _system(self) -> Any:
        """The system in double precision, with modes."""
        return piecewise(self.orbit.system, self.orbit.parameters)

    def largest(self, row: Row, sign: int) -> Differentiated:
        """Return the maximum, for sign 1, or minimum of an affine function over the period.

        `row` gives for a configuration the function's rows (q, N + 1) with their steps.
        """
        return self.extremes(row)[0 if sign > 0 else 1]

    def extremes(self, row: Row) -> tuple[Differentiated, Differentiated]:
        """Return the maximum and the minimum of an affine function of the state over the period.

        `row` gives for a configuration the function's rows (q, N + 1) with their steps.
        """
        minima, maxima = extremes(self._system, self._phases, self._rows(row))
        high, low = (self._at(row, found[0].time, found[0].value) for found in (maxima, minima))
        return high, low

    def _rows(self, row: Row) -> np.ndarray:
        count = len(self.structure.configurations)
        return np.array([[real_parts(row(c))[0].astype(float)] for c in range(count)])

    def _at(self, row: Row, time: float, value: float) -> Differentiated:
        """Return the function where its extreme is, in the phase that attains it there."""
        phases = self._phases
        ends = phases.begins + phases.durations
        slack = 1e-9 * float(self.begins[-1])
        near = np.flatnonzero((phases.begins - slack <= time) & (time <= ends + slack))
        best: tuple[float, int] | None = None
        for phase in near.tolist():
            since = min(max(time - phases.begins[phase], 0.0), phases.durations[phase])
            at = since if self.lib is None else self.lib.mp.mpf(since)
            state = real_parts(self.state(phase, at, 0 * self.shifted[:, 0]))[0].astype(float)
            own = real_parts(row(self.cycle.configurations[phase]))[0].astype(float)
            missed = abs(float(own[:-1] @ state + own[-1]) - value)
            if best is None or missed < best[0]:
                best = missed, phase
        assert best is not None
        return self.differentiated(row, best[1], time - float(phases.begins[best[1]]))

    def differentiated(self, row: Row, phase: int, since: float) -> Differentiated:
        """Return an affine function at an extreme of it in a phase: inside it, or at an end.

        `row` gives the function's rows (q, N + 1) with their steps. The time `since` the
        phase's start is approximate, and polished where the extreme is inside.
        """
        duration = float(self.dwell[phase])
        rows = row(self.cycle.configurations[phase])
        still = 0 * self.shifted[:, 0]
        if since <= _EDGE * duration:
            at, rate = 0 * self.dwell[phase], still
        elif since >= (1 - _EDGE) * duration:
            at, rate = self.dwell[phase], self.waits[:, phase]
        else:
            at, rate = self._polished(rows, phase, since), still
        state = self.state(phase, at, rate)
        values = (rows[:, :-1] * state).sum(axis=-1) + rows[:, -1]
        time = self.begins[phase] + at
        return Differentiated(
            self._rounded(real_parts(values))[0],
            self._rounded(imaginary_parts(values, self.lib)),
            time if self.lib is not None else float(time),
        )

    def _polished(self, rows: np.ndarray, phase: int, since: float) -> Any:
        """Return the zero of the function's slope near a time, by Newton's method."""
        field = real_parts(self.numbers.fields[0, self.cycle.configurations[phase]])
        slope = real_parts(rows[0])[:-1] @ field
        bend = slope[:-1] @ field
        at: Any = since if self.lib is None else self.lib.mp.mpf(since)
        for _ in range(3 if self.lib is None else 8):
            state = real_parts(self.state(phase, at, 0 * self.shifted[:, 0]))[0]
            curvature = bend[:-1] @ state + bend[-1]
            if not curvature:
                break
            step = (slope[:-1] @ state + slope[-1]) / curvature
            if abs(float(step)) > 0.1 * float(self.dwell[phase]):
                break  # flat, or an end: the place that the search has found stays
            at = at - step
        return at

    def row_of(self, kind: str, of: str) -> Row:
        """Return the row of a quantity of one of the `KINDS`, of a state or a contact."""
        if kind == "peak_acceleration":
            return self._acceleration_row(of)
        return self._force_row(of) if kind == "peak_force" else self._state_row(of)

    def _state_row(self, name: str) -> Row:
        """Return the row of a state."""
        place, size = self._place(name), len(self.structure.states)
        unit = np.zeros((len(self.by), size + 1), dtype=self.numbers.fields.dtype)
        unit[:, place] = 1
        return lambda _: unit

    def _acceleration_row(self, name: str) -> Row:
        """Return the row of the rate of a velocity, which is named by itself or by its position."""
        place = dict(self.structure.coordinates).get(self._place(name), self._place(name))
        return lambda configuration: self.numbers.fields[:, configuration, place]

    def _force_row(self, name: str) -> Row:
        """Return the row of the force of a contact on the oscillator."""
        contact = self._contact(name)
        nothing = np.zeros_like(self.numbers.rows[:, 0])
        return lambda c: self.numbers.rows[:, contact.forces[c]] if c in contact.forces else nothing

    def peak(self, row: Row, name: str) -> Differentiated:
        """Return the largest absolute value of an affine function over the period.

        `InputError` is raised where the largest and the smallest value tie and change
        differently; its message says what `name` is.
        """
        high, low = self.extremes(row)
        low = Differentiated(-low.value, -low.rates, low.time)
        top, other = (high, low) if high.value >= low.value else (low, high)
        tied = float(top.value - other.value) <= _TIED * abs(float(top.value))
        if tied and self._differ(top, other):
            raise InputError(f"{name}: two extremes are equally large and change differently")
        return top

    def _differ(self, one: Differentiated, other: Differentiated) -> bool:
        """Return whether two numbers of one size change differently, by more than rounding."""
        rates, others = one.rates.astype(float), other.rates.astype(float)
        states = sizes(self.orbit.tables.shooting, self.orbit.dwell_times)
        by_numbers = relative_changes(self.numbers[:3], states, self.lib)
        by_times = abs(self.shifted[:, -1].astype(float)) / float(self.begins[-1])
        usual = abs(float(one.value)) * np.maximum(by_numbers, by_times)
        size = np.maximum(np.maximum(abs(rates), abs(others)), usual)
        return bool((abs(rates - others) > _SAME * size).any())

    def quadrature(self, phase: int) -> tuple[np.ndarray, np.ndarray]:
        """Return states (q, n, N + 1) at nodes of an integral over a phase, and weights (q, n).

        The states have a 1 behind them; the weights' sum is the dwell time; both are in
        double precision and have steps. The nodes move with the dwell time, so that
        derivatives are exact.
        """
        configuration = self.cycle.configurations[phase]
        angle = fastest(self._system, configuration) * float(self.dwell[phase])
        nodes, weights = composite_rule(_NODES, max(1, int(np.ceil(angle / _ANGLE))))
        wait = stepped(self.dwell[phase], self.waits[:, phase, None], None)
        times = wait * nodes
        field = self.numbers.fields[:, None, configuration]
        flow = flows_over(np.broadcast_to(field, (*times.shape, *field.shape[2:])), times)
        states = flow[..., :-1] @ self.starts[:, None, phase, :, None] + flow[..., -1:]
        ones = np.ones((*times.shape, 1))
        return np.concatenate([states[..., 0], ones], axis=-1), wait * weights

    def dissipation(self, name: str | None = None) -> Differentiated:
        """Return the energy lost over a period through one contact, or through all of them.

        It is lost by friction, by dampers of stops and by impacts; dampers of the oscillator
        do not count. `InputError` is raised for an unknown contact, with many digits, and
        where the tables do not tell what an impact takes.
        """
        if self.lib is not None:
            raise InputError("dissipation has derivatives in double precision only")
        contacts = self.structure.contacts if name is None else (self._contact(name),)
        total = np.zeros(len(self.by), dtype=complex)
        for phase, configuration in enumerate(self.cycle.configurations):
            acting = [c for c in contacts if configuration in c.forces]
            if not acting:
                continue
            states, weights = self.quadrature(phase)
            for contact in acting:
                force, velocity, surface = (
                    np.einsum("qi,qni->qn", self.numbers.rows[:, place], states)
                    for place in (contact.forces[configuration], contact.velocity, contact.surface)
                )
                total += (force * (surface - velocity) * weights).sum(axis=1)
        for loss in impact_losses(self):
            if loss.contact in contacts:
                total += loss.energy
        return Differentiated(float(total[0].real), imaginary_parts(total, None), float("nan"))

    @cached_property
    def margins(self) -> tuple[BoundaryMargin, ...]:
        """How far each boundary stays away along each phase.

        For a boundary on which a phase begins or ends, it is the distance at the nearest
        maximum inside, if there is one: a grazing to come. The speed at the end is among
        `transversalities`.
        """
        found = []
        for phase, configuration in enumerate(self.cycle.configurations):
            for place, boundary in enumerate(self.structure.boundaries[configuration]):

                def row(_: int, at: int = boundary.row) -> np.ndarray:
                    return self.numbers.rows[:, at]

                time = self._nearest(row, phase, configuration, place)
                if time is None:
                    continue
                there = self.differentiated(row, phase, time)
                found.append(
                    BoundaryMargin(
                        phase,
                        self.structure.configurations[configuration],
                        boundary.name,
                        -there.value,
                        -there.rates,
                        there.time,
                    )
                )
        return tuple(found)

    def _nearest(self, row: Row, phase: int, configuration: int, place: int) -> float | None:
        """Return when a phase is nearest to a boundary, inside if it touches it at an end.

        None is returned where there is no such time.
        """
        phases, boundary = self._phases, self.structure.boundaries[configuration][place]
        if place not in self.cycle.transitions[phase].boundaries:
            parts = (phases.begins * 0, phases.durations, phases.configurations)
            own = Phases(
                *(part[phase : phase + 1] for part in (*parts, phases.starts, phases.ends))
            )
            _, maxima = extremes(self._system, own, self._rows(row))
            normal = abs(real_parts(self.numbers.rows[0, boundary.row]).astype(float))
            reach = np.maximum(abs(own.starts[0]), abs(own.ends[0]))
            if abs(maxima[0].value) > _TOUCH * (normal @ np.append(reach, 1)):
                return maxima[0].time
        waves = self._waves[phase]
        if boundary.name not in waves.names:
            return None
        time = float(interior_maxima(waves)[1][0, waves.names.index(boundary.name)])
        return None if np.isnan(time) else time

    @cached_property
    def _waves(self) -> list[PhaseWaves]:
        """Boundary functions along the phases, in double precision."""
        point = np.array([[float(x) for x in self.orbit.parameters.values()]])
        (group,) = numbers_at(self.orbit.system, point, self.cycle.configurations)
        cycle = self.cycle.at(self.cycle.structure.with_modes(group.structure.shapes))
        numbers, phases = numbers_in(group.structure, group.flat), self._phases
        return [
            phase_waves(cycle, numbers, phases.starts[None, k], phases.durations[None], k)
            for k in range(len(cycle))
        ]

    def margin(self) -> Differentiated:
        """Return the least of all margins; `InputError` where no boundary could be reached."""
        if not self.margins:
            raise InputError(
                f"{self.orbit.name}: there is no boundary that stays away, and none comes near"
                " within a phase: no function of a boundary has a maximum there"
            )
        least = min(self.margins, key=lambda margin: float(margin.value))
        return Differentiated(least.value, least.rates, least.time)

    @cached_property
    def transversalities(self) -> tuple[Transversality, ...]:
        """The speed with which each phase reaches the boundary that ends it."""
        moved = stepped(self.dwell, self.waits, self.lib)
        now = passed(self.cycle, self.numbers, moved, self.starts[:, 0], self.lib)
        values = self._rounded(real_parts(now.speeds[:, 0]))
        rates = self._rounded(imaginary_parts(now.speeds, self.lib))
        return tuple(
            Transversality(k, self.cycle.itinerary[k][1], values[k], rates[k])
            for k in range(len(self.cycle))
        )

    def quantity(self, name: str) -> Differentiated:
        """Return a quantity by its name, of `names`; see `OrbitDerivatives.quantity`.

        `InputError` is raised for an unknown name.
        """
        kind, _, of = name.partition(":")
        if kind in KINDS and of:
            row, signs = self.row_of(kind, of), KINDS[kind]
            return self.largest(row, *signs) if len(signs) == 1 else self.peak(row, name)
        if kind == "dissipation":
            return self.dissipation(of or None)
        if kind == "margin" and not of:
            return self.margin()
        if kind == "transversality" and not of:
            found = min(self.transversalities, key=lambda t: float(t.value))
            return Differentiated(found.value, found.rates, self.begins[found.phase + 1])
        raise unknown_name("quantity", name, self.names)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities that `quantity` knows."""
        states, contacts = self.structure.states, [c.name for c in self.structure.contacts]
        extremes_of = [f"{kind}:{s}" for kind in ("maximum", "minimum", "peak") for s in states]
        forces = [f"{kind}:{c}" for kind in ("peak_force", "dissipation") for c in contacts]
        rates = [f"peak_acceleration:{states[x]}" for x, _ in self.structure.coordinates]
        return (*extremes_of, *rates, *forces, "dissipation", "margin", "transversality")

    def _place(self, name: str) -> int:
        if name not in self.structure.states:
            raise unknown_name("state", name, self.structure.states)
        return self.structure.states.index(name)

    def _contact(self, name: str) -> Any:
        contacts = {contact.name: contact for contact in self.structure.contacts}
        if name not in contacts:
            raise unknown_name("contact", name, contacts)
        return contacts[name]

    def _rounded(self, values: np.ndarray) -> np.ndarray:
        """Return numbers rounded to the orbit's precision."""
        if self.lib is None:
            return values
        return np.asarray(np.frompyfunc(self.orbit.arithmetic.mp.mpf, 1, 1)(values))
