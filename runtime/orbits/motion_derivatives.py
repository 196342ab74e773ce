"""Derivatives of what is seen along an orbit: states, extremes, margins, dissipation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.orbits.directions import Directions
from nonsmooth.runtime.orbits.impact_losses import impact_losses
from nonsmooth.runtime.orbits.table_directions import numbers_along, relative_changes, working
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.simulation.extremes import boundary_rows, local_maxima
from nonsmooth.runtime.simulation.moved_phases import Differentiated, MovedPhases
from nonsmooth.runtime.simulation.observables import acceleration_rows, force_rows, observed_rows
from nonsmooth.runtime.simulation.phase_functions import Phases, phase_states

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = [
    "KINDS",
    "BoundaryMargin",
    "LocalExtreme",
    "OrbitMotionDerivatives",
    "Transversality",
]

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


class LocalExtreme(NamedTuple):
    """A local maximum of a function within a phase, or of minus the function."""

    phase: int  # counted from 0
    sign: int  # 1 for a maximum, -1 for a minimum
    value: float  # of the function times the sign
    rates: np.ndarray  # (q,), of that value
    time: float  # since the start of the orbit


class OrbitMotionDerivatives:
    """An orbit by tables as it moves in q directions: a closed chain of phases.

    Affine functions of the state are arrays (q, configurations, N + 1), with steps.
    """

    def __init__(self, orbit: Orbit, by: Sequence[str], directions: Directions) -> None:
        self.orbit, self.by = orbit, tuple(by)
        tables = orbit.tables
        self.cycle, self.lib = tables.cycle, working(orbit)
        self.structure = self.cycle.structure
        self.numbers = numbers_along(orbit, by, self.lib)
        starts, dwell = tables.states_up_to_shift, orbit.dwell_times
        system = tables.piecewise
        if self.lib is not None:
            lift = np.frompyfunc(self.lib.mp.mpf, 1, 1)
            starts, dwell = lift(starts), lift(dwell)
            system = piecewise(orbit.system, orbit.parameters)
        breaks = np.concatenate([[0 * dwell[0]], np.cumsum(dwell)])
        self.period = breaks[-1]
        configurations = np.array(self.cycle.configurations)
        floats = dwell.astype(float), starts.astype(float)
        ends = phase_states(system, configurations, *floats)
        phases = Phases(breaks[:-1], dwell, configurations, starts, ends)
        shifted = np.cumsum(directions.dwell, axis=1)
        rates = np.array([shifted - directions.dwell, shifted])
        fields = real_parts(self.numbers.fields[0])[configurations]
        velocities = (fields[..., :-1] @ starts[..., None])[..., 0] + fields[..., -1]
        changes = directions.starts - velocities * rates[0][..., None]
        self.moved = MovedPhases(
            system, self.numbers, phases, np.moveaxis(changes, 0, -1), rates, self.lib
        )

    def turned(self, by: Sequence[str], directions: np.ndarray) -> OrbitMotionDerivatives:
        """Return the orbit as it moves with numbers of which the present ones move by shares.

        `directions` (q, r) has the rates of the q present numbers by the r others.
        """
        found = copy(self)
        found.by, found.moved = tuple(by), self.moved.turned(directions)
        found.numbers = found.moved.numbers
        return found

    def states(self, times: Sequence[Any]) -> tuple[np.ndarray, np.ndarray]:
        """Return states (m, N) at times of the period, since the start, and derivatives (m, N, q).

        `InputError` is raised for a time outside of the period, and for an orbit that is periodic
        up to a shift, of which phases are known up to it.
        """
        if len(self.orbit.tables.translations):
            raise InputError(f"{self.orbit.name} is periodic up to a shift: ask its motion()")
        number = float if self.lib is None else self.lib.mp.mpf
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
        rates = np.moveaxis(imaginary_parts(found, self.lib), 0, -1)
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
        states = sizes(self.orbit.tables.shooting, self.orbit.dwell_times)
        by_numbers = relative_changes(self.numbers[:3], states, self.lib)
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
        kind, _, of = str(name).partition(":")
        if kind not in KINDS or not of:
            raise unknown_name("quantity with extremes", name, self.names)
        if self.lib is not None:
            raise InputError("local extremes are found in double precision only")
        row, wanted = self.row_of(kind, of), KINDS[kind]
        turns = [turn for turn in self._turns(real_parts(row[0])) if turn[2] in wanted]
        found = [
            LocalExtreme(phase, sign, sign * float(value), sign * rates, float(time))
            for (phase, _, sign), (value, rates, time) in zip(
                turns, self._differentiated(row, turns), strict=True
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
        for phase, configuration in enumerate(self.cycle.configurations):
            slope = slopes[configuration]
            for since, state, outward in (
                (0.0, phases.starts[phase], -1),
                (float(phases.durations[phase]), phases.ends[phase], 1),
            ):
                rate = outward * (slope[:-1] @ state + slope[-1])
                least = _ROUNDING * (abs(slope[:-1]) @ abs(state) + abs(slope[-1]))
                signs = [sign for sign in (1, -1) if sign * rate > -least]
                yield from ((phase, since, sign) for sign in signs or [-outward])

    def _differentiated(
        self, row: np.ndarray, turns: Sequence[tuple[int, float, int]]
    ) -> Iterator[Differentiated]:
        """Yield a function at its extremes: phases, times since their start, and signs."""
        places = np.array([turn[0] for turn in turns], dtype=int)
        since = np.array([turn[1] for turn in turns])
        own = row[:, self.moved.phases.configurations[places]]
        return self.moved.differentiated(own, places, since)

    def dissipation(self, name: str | None = None) -> Differentiated:
        """Return the energy lost over a period through one contact, or through all of them.

        It is lost by friction, by dampers of stops and by impacts; dampers of the oscillator
        do not count. `InputError` is raised for an unknown contact, with many digits, and
        where the tables do not tell what an impact takes.
        """
        if self.lib is not None:
            raise InputError("dissipation has derivatives in double precision only")
        every = self.structure.contacts
        places = range(len(every)) if name is None else [self._contact(name)]
        total = np.zeros(len(self.by), dtype=complex)
        if any(c in every[place].forces for place in places for c in self.cycle.configurations):
            size = len(self.structure.states)
            rows = observed_rows(self.structure, self.numbers.rows)[:, :, size:]
            moments = self.moved.moments(rows)
            for place in places:
                force, velocity, surface = range(3 * place, 3 * place + 3)
                total += moments[:, force, surface] - moments[:, force, velocity]
        for loss in impact_losses(self.cycle, self.moved):
            if loss.contact in [every[place] for place in places]:
                total += loss.energy
        return Differentiated(float(total[0].real), imaginary_parts(total, None), float("nan"))

    @cached_property
    def margins(self) -> tuple[BoundaryMargin, ...]:
        """How far each boundary stays away along each phase.

        For a boundary on which a phase begins or ends, it is the distance at the nearest
        maximum inside, if there is one: a grazing to come. The speed at the end is among
        `transversalities`.
        """
        places, since, rows, names = [], [], [], []
        for phase, boundary, time in self._nearest():
            shape = self.structure.boundaries[self.cycle.configurations[phase]][boundary]
            places.append(phase)
            since.append(time)
            rows.append(shape.row)
            names.append(shape.name)
        found = self.moved.differentiated(
            self.numbers.rows[:, np.array(rows, dtype=int)],
            np.array(places, dtype=int),
            np.array(since),
        )
        return tuple(
            BoundaryMargin(phase, self.cycle.itinerary[phase][0], name, -t.value, -t.rates, t.time)
            for phase, name, t in zip(places, names, map(self._told, found), strict=True)
        )

    def _nearest(self) -> Iterator[tuple[int, int, float]]:
        """Yield phases, places of boundaries, and times when a phase is nearest to one of them.

        They are inside if the boundary is touched at an end.
        """
        phases, system = self.moved.searched, self.moved.system
        rows = boundary_rows(system)
        inside: dict[tuple[int, int], tuple[float, float]] = {}
        for found in local_maxima(system, phases, rows):
            duration = phases.durations[found.phase]
            if _INSIDE * duration < found.since < (1 - _INSIDE) * duration:
                key, seen = (found.phase, found.function), (found.value, found.since)
                inside[key] = max(seen, inside.get(key, seen))
        for phase, configuration in enumerate(self.cycle.configurations):
            reach = np.maximum(abs(phases.starts[phase]), abs(phases.ends[phase]))
            for place in range(len(self.structure.boundaries[configuration])):
                row, best = rows[configuration, place], inside.get((phase, place))
                if place not in self.cycle.transitions[phase].boundaries:
                    ends = (
                        (phases.starts[phase], 0.0),
                        (phases.ends[phase], phases.durations[phase]),
                    )
                    every = [(float(row[:-1] @ y + row[-1]), float(t)) for y, t in ends]
                    top = max(every if best is None else [best, *every])
                    if abs(top[0]) > _TOUCH * (abs(row) @ np.append(reach, 1)):
                        best = top
                if best is not None:
                    yield phase, place, best[1]

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
        speeds = [self.moved.arrival(phase, row)[0] for phase, row in enumerate(self.cycle.rows)]
        values = self._rounded(real_parts(np.array(speeds)[:, 0]))
        rates = self._rounded(imaginary_parts(np.array(speeds), self.lib))
        return tuple(
            Transversality(k, self.cycle.itinerary[k][1], values[k], rates[k])
            for k in range(len(self.cycle))
        )

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
        if kind == "transversality" and not of:
            found = min(self.transversalities, key=lambda t: float(t.value))
            phases = self.moved.phases
            end = phases.begins[found.phase] + phases.durations[found.phase]
            return Differentiated(found.value, found.rates, end)
        raise unknown_name("quantity", name, self.names)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities that `quantity` knows."""
        states, contacts = self.structure.states, [c.name for c in self.structure.contacts]
        bounded = [state for state in states if state not in self._shifted]
        extremes_of = [f"{kind}:{s}" for kind in ("maximum", "minimum", "peak") for s in bounded]
        forces = [f"{kind}:{c}" for kind in ("peak_force", "dissipation") for c in contacts]
        rates = [f"peak_acceleration:{states[x]}" for x, _ in self.structure.coordinates]
        return (*extremes_of, *rates, *forces, "dissipation", "margin", "transversality")

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
        if self.lib is None:
            return values
        return np.asarray(np.frompyfunc(self.orbit.arithmetic.mp.mpf, 1, 1)(values))
