"""Derivatives of what is seen along an orbit: states, extremes, margins, dissipation."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arguments import checked_methods
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.structure import BoundaryShape, ContactShape, Structure
from nonsmooth.runtime.orbits.directions import Directions, MovedCycles, relative_changes
from nonsmooth.runtime.shooting.shooting_map import Numbers
from nonsmooth.runtime.simulation.moved_phases import Differentiated, MovedPhases
from nonsmooth.runtime.simulation.observables import acceleration_rows, force_rows, observed_rows
from nonsmooth.runtime.simulation.phase_functions import (
    Phases,
    boundary_rows,
    local_maxima,
    phase_states,
)

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

# what has extremes, and the signs of those that count: 1 of maxima, -1 of minima
KINDS = {
    "maximum": (1,),
    "minimum": (-1,),
    "peak": (1, -1),
    "peak_acceleration": (1, -1),
    "peak_force": (1, -1),
}

_TOUCH = 1e-9  # relative size below which a boundary function is zero at a phase's end
_INSIDE = 1e-7  # of a dwell time: a maximum nearer to the ends is no interior one
_ROUNDING = 64 * np.finfo(float).eps
_TIED = 1e-9  # relative difference of extremes that are as large as each other
_SAME = 1e-6  # relative difference of rates that are the same but for rounding
_NEAR = 1e-9  # relative: within which two functions are proportional
_STILL = 1e-12  # relative change of a velocity that is none


class BoundaryMargin(NamedTuple):
    """The distance of a boundary along a phase: the least of minus its function."""

    phase: int  # counted from 0
    configuration: str
    boundary: str
    value: Any  # in the boundary's unit
    rates: np.ndarray  # (q,)
    time: Any  # since the start of the orbit


class LocalExtreme(NamedTuple):
    """A local maximum of a function within a phase, or of minus the function."""

    phase: int  # counted from 0
    sign: int  # 1 for a maximum, -1 for a minimum
    value: float  # of the function times the sign
    rates: np.ndarray  # (q,), of that value
    time: float  # since the start of the orbit


@checked_methods
class OrbitMotionDerivatives:
    """An orbit by tables as it moves in q directions: a closed chain of phases.

    Affine functions of the state are arrays (q, configurations, N + 1), with steps.
    """

    def __init__(self, orbit: Orbit, directions: Directions) -> None:
        assert directions.cycles is not None
        self.orbit, self.cycles = orbit, directions.cycles

    @property
    def structure(self) -> Structure:
        """The system apart from its parameters."""
        return self.cycles.cycle.structure

    @property
    def numbers(self) -> Numbers:
        """Fields, rows and resets (q, ...) of the system, with steps."""
        return self.cycles.numbers

    @cached_property
    def moved(self) -> MovedPhases:
        """The phases of one period."""
        cycles, lib, tables = self.cycles, self.cycles.lib, self.orbit.tables
        dwell, starts, system = self.orbit.dwell_times, tables.states_up_to_shift, tables.in_doubles
        configurations = np.array(cycles.cycle.configurations)
        ends = phase_states(system, configurations, dwell.astype(float), starts.astype(float))
        if lib is not None:
            dwell, starts = (np.frompyfunc(lib.mp.mpf, 1, 1)(part) for part in (dwell, starts))
        waits, moved = cycles.waits, imaginary_parts(cycles.passage.starts[:-1], lib)
        shifted = np.cumsum(waits, axis=1)
        rates = np.array([shifted - waits, shifted])
        fields = real_parts(self.numbers.fields[0])[configurations]
        velocities = (fields[..., :-1] @ starts[..., None])[..., 0] + fields[..., -1]
        changes = np.swapaxes(moved, 1, 2) - velocities[..., None] * rates[0].T[:, None]
        begins = np.concatenate([0 * dwell[:1], np.cumsum(dwell)[:-1]])
        phases = Phases(begins, dwell, configurations, starts, ends)
        return MovedPhases(system, self.numbers, phases, changes, rates, lib)

    @property
    def period(self) -> Any:
        """Sum of the dwell times."""
        return real_parts(self.cycles.dwell[0]).sum()

    def states(self, times: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
        """Return states (m, N) at times of the period, since the start, and derivatives (m, N, q).

        `InputError` is raised for a time outside of the period, and for an orbit that is periodic
        up to a shift, of which phases are known up to it.
        """
        if len(self.orbit.tables.translations):
            raise InputError(f"{self.orbit.name} is periodic up to a shift: ask its motion()")
        number = float if self.cycles.lib is None else self.cycles.lib.mp.mpf
        try:
            every = np.array([number(time) for time in times])
        except (TypeError, ValueError):
            raise InputError("times: no array of real numbers") from None
        for time in every:
            if not 0 <= time <= self.period:
                raise InputError(f"time = {float(time):g} is not within the period")
        begins = self.moved.phases.begins
        places = np.array([np.flatnonzero(begins <= time)[-1] for time in every], dtype=int)
        found = self.moved.at(places, every - begins[places])
        rates = np.moveaxis(imaginary_parts(found, self.cycles.lib), 0, -1)
        return self._rounded(real_parts(found[0])), self._rounded(rates)

    def extremes(self, row: np.ndarray) -> tuple[Differentiated, Differentiated]:
        """Return the maximum and the minimum of an affine function of the state over the period."""
        (low,), (high,) = self.moved.extremes(row[:, :, None])
        return self._told(high), self._told(low)

    def row_of(self, kind: str, of: str) -> np.ndarray:
        """Return the row of a quantity of one of the `KINDS`, of a state or a contact."""
        if kind == "peak_force":
            return force_rows(self.structure, self.numbers.rows, self._contact(of))
        if kind == "peak_acceleration":
            return acceleration_rows(self.structure, self.numbers.fields, self._place(of))
        if of in self._shifted:
            raise InputError(f"{of} is shifted by each period: it has no extremes")
        return observed_rows(self.structure, self.numbers.rows)[:, :, self._place(of)]

    def peak(self, row: np.ndarray, name: str) -> Differentiated:
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
        by_numbers = relative_changes(self.numbers[:3], self.cycles.sizes[0], self.cycles.lib)
        by_times = abs(self.moved.rates[1, :, -1].astype(float)) / float(self.period)
        usual = abs(float(one.value)) * np.maximum(by_numbers, by_times)
        size = np.maximum(np.maximum(abs(rates), abs(others)), usual)
        return bool((abs(rates - others) > _SAME * size).any())

    def local_extremes(self, name: str) -> tuple[LocalExtreme, ...]:
        """Return the local extremes of a quantity along each phase and at its ends.

        The quantity is ``maximum:STATE``, ``minimum:STATE``, ``peak:STATE``,
        ``peak_acceleration:STATE`` or ``peak_force:CONTACT``; it is the largest of these
        extremes. None inside a phase is missed. They come by phases, maxima first, each in the
        order of time. `InputError` is raised for another name, and for an orbit with many
        digits.
        """
        kind, _, of = name.partition(":")
        if kind not in KINDS or not of:
            raise unknown_name("quantity with extremes", name, self.names)
        if self.cycles.lib is not None:
            raise InputError("local extremes are found in double precision only")
        row, wanted = self.row_of(kind, of), KINDS[kind]
        turns = [turn for turn in self._turns(real_parts(row[0])) if turn[2] in wanted]
        phases, since, signs = map(np.array, zip(*turns, strict=True))
        own = row[:, self.moved.phases.configurations[phases]]
        found = [
            LocalExtreme(phase, sign, sign * float(value), sign * rates, float(time))
            for phase, sign, (value, rates, time) in zip(
                phases.tolist(),
                signs.tolist(),
                self.moved.differentiated(own, phases, since),
                strict=True,
            )
        ]
        return tuple(sorted(found, key=lambda each: (each.phase, -each.sign, each.time)))

    def _turns(self, row: np.ndarray) -> Iterator[tuple[int, float, int]]:
        """Yield phases, times since their start, and 1 for a maximum there, -1 for a minimum.

        The end of a phase is both where the slope is zero there but for rounding. Of a constant
        function it is a minimum, and the beginning a maximum.
        """
        phases, system = self.moved.phases, self.moved.system
        for found in local_maxima(system, phases, np.stack([row, -row], axis=1)):
            yield found.phase, found.since, 1 - 2 * found.function
        slopes = (row[:, None, :-1] @ system.fields)[:, 0]
        for phase, configuration in enumerate(self.cycles.cycle.configurations):
            slope = slopes[configuration]
            for since, state, outward in (
                (0.0, phases.starts[phase], -1),
                (float(phases.durations[phase]), phases.ends[phase], 1),
            ):
                rate = outward * (slope[:-1] @ state + slope[-1])
                least = _ROUNDING * (abs(slope[:-1]) @ abs(state) + abs(slope[-1]))
                signs = [sign for sign in (1, -1) if sign * rate > -least]
                yield from ((phase, since, sign) for sign in signs or [-outward])

    def dissipation(self, name: str | None = None) -> Differentiated:
        """Return the energy lost over a period through one contact, or through all of them.

        It is lost by friction, by dampers of stops and by impacts; dampers of the oscillator
        do not count. `InputError` is raised for an unknown contact, with many digits, and
        where the tables do not tell what an impact takes.
        """
        if self.cycles.lib is not None:
            raise InputError("dissipation has derivatives in double precision only")
        every = self.structure.contacts
        places = range(len(every)) if name is None else [self._contact(name)]
        total = np.zeros(len(self.numbers.rows), dtype=complex)
        if any(
            c in every[place].forces for place in places for c in self.cycles.cycle.configurations
        ):
            size = len(self.structure.states)
            rows = observed_rows(self.structure, self.numbers.rows)[:, :, size:]
            moments = self.moved.moments(rows)
            for place in places:
                force, velocity, surface = range(3 * place, 3 * place + 3)
                total += moments[:, force, surface] - moments[:, force, velocity]
        for contact, energy in _impact_losses(self.cycles):
            if contact in [every[place] for place in places]:
                total += energy
        return Differentiated(float(total[0].real), imaginary_parts(total, None), float("nan"))

    @cached_property
    def margins(self) -> tuple[BoundaryMargin, ...]:
        """How far each boundary stays away along each phase.

        For a boundary on which a phase begins or ends, it is the distance at the nearest
        maximum inside, if there is one: a grazing to come.
        """
        near = list(self._nearest())
        places = np.array([phase for phase, _, _ in near], dtype=int)
        rows = np.array([shape.row for _, shape, _ in near], dtype=int)
        since = np.array([time for _, _, time in near])
        found = self.moved.differentiated(self.numbers.rows[:, rows], places, since)
        names = [configuration for configuration, _ in self.cycles.cycle.itinerary]
        return tuple(
            BoundaryMargin(phase, names[phase], shape.name, -t.value, -t.rates, t.time)
            for (phase, shape, _), t in zip(near, map(self._told, found), strict=True)
        )

    def _nearest(self) -> Iterator[tuple[int, BoundaryShape, float]]:
        """Yield phases, boundaries, and times since the start when a phase is nearest to one.

        They are inside if the boundary is touched at an end.
        """
        phases, system = self.moved.searched, self.moved.system
        rows = boundary_rows(system)
        inside = defaultdict(list)
        for found in local_maxima(system, phases, rows):
            duration = phases.durations[found.phase]
            if _INSIDE * duration < found.since < (1 - _INSIDE) * duration:
                inside[found.phase, found.function].append((found.value, found.since))
        for phase, configuration in enumerate(self.cycles.cycle.configurations):
            ends = np.stack([phases.starts[phase], phases.ends[phase]])
            for place, shape in enumerate(self.structure.boundaries[configuration]):
                row, maxima = rows[configuration, place], inside[phase, place]
                if place not in self.cycles.cycle.transitions[phase].boundaries:
                    values = (ends @ row[:-1] + row[-1]).tolist()
                    times = (0.0, float(phases.durations[phase]))
                    every = [*maxima, *zip(values, times, strict=True)]
                    size = abs(row) @ np.append(abs(ends).max(axis=0), 1)
                    maxima = every if abs(max(every)[0]) > _TOUCH * size else maxima
                if maxima:
                    yield phase, shape, max(maxima)[1]

    def margin(self) -> Differentiated:
        """Return the least of all margins; `InputError` where no boundary could be reached."""
        if not self.margins:
            raise InputError(
                f"{self.orbit.name}: there is no boundary that stays away, and none comes near"
                " within a phase: no function of a boundary has a maximum there"
            )
        least = min(self.margins, key=lambda margin: float(margin.value))
        return Differentiated(least.value, least.rates, least.time)

    def quantity(self, name: str) -> Differentiated:
        """Return a quantity by its name, of `names`; see `OrbitDerivatives.quantity`.

        `InputError` is raised for an unknown name.
        """
        kind, _, of = str(name).partition(":")
        if kind in KINDS and of:
            row, signs = self.row_of(kind, of), KINDS[kind]
            return self.peak(row, name) if len(signs) > 1 else self.extremes(row)[signs[0] < 0]
        if kind == "dissipation":
            return self.dissipation(of or None)
        if kind == "margin" and not of:
            return self.margin()
        raise unknown_name("quantity", name, self.names)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities that `quantity` knows."""
        states, contacts = self.structure.states, [c.name for c in self.structure.contacts]
        bounded = [state for state in states if state not in self._shifted]
        extremes_of = [f"{kind}:{s}" for kind in ("maximum", "minimum", "peak") for s in bounded]
        forces = [f"{kind}:{c}" for kind in ("peak_force", "dissipation") for c in contacts]
        rates = [f"peak_acceleration:{states[x]}" for x, _ in self.structure.coordinates]
        return (*extremes_of, *rates, *forces, "dissipation", "margin")

    @property
    def _shifted(self) -> set[str]:
        """Return the states along translations of the system, of which the orbit is shifted."""
        moved = np.asarray(self.orbit.tables.translations, dtype=float)
        return {name for k, name in enumerate(self.structure.states) if moved[:, k].any()}

    def _place(self, name: str) -> int:
        if name not in self.structure.states:
            raise unknown_name("state", name, self.structure.states)
        return self.structure.states.index(name)

    def _contact(self, name: str) -> int:
        contacts = [contact.name for contact in self.structure.contacts]
        if name not in contacts:
            raise unknown_name("contact", name, contacts)
        return contacts.index(name)

    def _told(self, found: Differentiated) -> Differentiated:
        """Return what was found, in the orbit's precision."""
        (value,), rates = self._rounded(np.array([found.value])), self._rounded(found.rates)
        return Differentiated(value, rates, found.time)

    def _rounded(self, values: np.ndarray) -> np.ndarray:
        """Return numbers rounded to the orbit's precision."""
        if self.cycles.lib is None:
            return values
        return np.asarray(np.frompyfunc(self.orbit.arithmetic.mp.mpf, 1, 1)(values))


def _impact_losses(cycles: MovedCycles) -> Iterator[tuple[ContactShape, np.ndarray]]:
    """Yield the contact of each impact of an orbit and the energy (q,) that it takes, in doubles.

    Each of q directions has a step.

    An impulse J at a contact changes its relative velocity from w- to w+ = w- + J / m and takes
    the energy m (w-^2 - w+^2) / 2. A system's tables know accelerations, not masses: the
    effective mass m is minus the reaction that holds the contact in lasting contact, by the
    acceleration w' without it. Both are affine functions of the state, and proportional to each
    other. `InputError` is raised for impacts at several stops at once, and where the tables do
    not tell the mass.
    """
    cycle, numbers, passage = cycles.cycle, cycles.numbers, cycles.passage
    structure, rows = cycle.structure, numbers.rows
    velocities = [velocity for _, velocity in structure.coordinates]
    for phase, configuration in enumerate(cycle.configurations):
        front, behind = passage.ends[phase], passage.starts[phase + 1]
        jump = np.abs((behind - front)[0, velocities].real)
        if not (jump > _STILL * np.abs(front[0].real).max()).any():
            continue
        field = numbers.fields[:, configuration]
        shapes = structure.boundaries[configuration]
        reached = [shapes[place] for place in sorted(cycle.transitions[phase].boundaries)]
        struck = []
        for boundary in reached:
            row, now = rows[0, boundary.row].real, rows[0].real
            rate = row[:-1] @ field[0].real
            struck += [
                contact
                for contact in structure.contacts
                if _proportional(rate, now[contact.velocity] - now[contact.surface])
                and any(
                    _proportional(row, now[held])
                    for lasting in contact.forces
                    for held in structure.constraints[lasting]
                )
            ]
        names = " and ".join(boundary.name for boundary in reached)
        if not struck:
            raise InputError(f"what is lost at {names} is not told: no contact is declared there")
        if len(struck) > 1:
            raise InputError(f"{names}: what each of several impacts at once takes is not told")
        (contact,) = struck
        relative = rows[:, contact.velocity] - rows[:, contact.surface]
        mass = _mass(numbers, contact, configuration, relative)
        if mass is None:
            raise InputError(
                f"what is lost at {names} is not told: {contact.name} has no lasting contact that"
                " tells the mass which it stops"
            )
        speeds = [
            np.einsum("qi,qi->q", relative[:, :-1], state) + relative[:, -1]
            for state in (front, behind)
        ]
        yield contact, mass * (speeds[0] ** 2 - speeds[1] ** 2) / 2


def _proportional(row: np.ndarray, other: np.ndarray) -> bool:
    """Return whether one affine function is a nonzero multiple of another."""
    size = float(other @ other)
    factor = float(row @ other) / size if size else 0.0
    missed = np.abs(row - factor * other).max()
    return bool(factor and missed <= _NEAR * np.abs(row).max())


def _mass(
    numbers: Numbers, contact: ContactShape, source: int, relative: np.ndarray
) -> np.ndarray | None:
    """Return the effective mass (q,) at a contact, by its reaction in lasting contact.

    It is None where no lasting contact tells it.
    """
    field = numbers.fields[:, source]
    acceleration = np.einsum("qi,qij->qj", relative[:, :-1], field)
    for force in contact.forces.values():
        reaction = numbers.rows[:, force]
        size = (acceleration * acceleration).sum(axis=1)
        mass = -(reaction * acceleration).sum(axis=1) / size
        missed = np.abs(reaction + mass[:, None] * acceleration)[0].max()
        if mass[0].real > 0 and missed <= _NEAR * np.abs(reaction[0]).max():
            return np.asarray(mass)
    return None
