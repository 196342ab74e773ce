"""Whether an orbit by its system's tables is a motion of the real system, in double precision.

No boundary may be crossed inside a phase, and of the transitions that are declared for a
boundary the first whose conditions hold has to be the itinerary's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.first_crossing import first_crossing
from nonsmooth.runtime.events.leading_derivative import derivatives, leading, square
from nonsmooth.runtime.events.phase_numbers import ConfigurationTable
from nonsmooth.runtime.events.transition_choice import Decider, choose
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.orbits.admissible import MOST_MISSED, Admissibility, Violation
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, flow_at, numbers_in
from nonsmooth.runtime.shooting.translations import projection_along, translations_of
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["assess_cycle"]

_EPSILON = float(np.finfo(float).eps)
_SAMPLES, _MOST_SAMPLES = 16, 20_000  # a radian, and altogether
_SLOWEST = float(np.finfo(float).tiny)
_SIZES = 9  # instants of a phase at which the sizes of its states are taken


def assess_cycle(
    cycle: ItineraryShape, system: PiecewiseLinear, now: Shooting, dwell: np.ndarray
) -> Admissibility:
    """Check all boundaries along all phases of an orbit by tables, and all transitions.

    `now` is the cycle at the orbit, `dwell` (p,) is in the unit of time. A transition
    that the conditions refuse is a violation of its boundary at the end of its phase,
    with the excess 0. `InputError` is raised for a phase longer than the guarantee of the
    search reaches.
    """
    numbers = numbers_in(system)
    behind = projection_along(translations_of(system)) @ now.starts[-1]
    now = now._replace(starts=np.concatenate([now.starts[:-1], behind[None]]))
    begins = np.concatenate([[0.0], np.cumsum(dwell)])
    tables: dict[int, ConfigurationTable] = {}
    violations = []
    for place, duration in enumerate(dwell.tolist()):
        configuration = cycle.configurations[place]
        name = cycle.structure.configurations[configuration]
        if configuration not in tables:
            tables[configuration] = ConfigurationTable(system, configuration)
        table = tables[configuration]
        if not duration * table.fastest <= LONGEST_WAIT:
            raise InputError(
                f"{name} lasts {duration:.6g}, more than {LONGEST_WAIT:g} over its largest"
                " exponent: no guarantee reaches that far"
            )
        noise = _noise(cycle, numbers, now, place, duration)
        state = [*map(float, now.starts[place]), 1.0]
        shapes = cycle.structure.boundaries[configuration]
        for boundary, shape in zip(table.boundaries, shapes, strict=True):
            function = table.function(boundary, state, [abs(x) for x in state])
            rounding = max(function.rounding(0.0), function.rounding(duration))
            floor = rounding + float(noise[shape.row])
            crossing = first_crossing(function.raised(-floor), duration)
            if crossing.time is not None:
                time, excess = _maximum(function, crossing.time, duration)
                found = Violation(place, name, shape.name, float(begins[place]) + time, excess)
                violations.append(found)
        for reached in sorted(cycle.transitions[place].boundaries):
            shape = shapes[reached]  # of several that are reached together all have to be zero
            value = float(numbers.rows[shape.row] @ np.append(now.ends[place], 1.0))
            if value < -noise[shape.row]:
                time = float(begins[place + 1])
                violations.append(Violation(place, name, shape.name, time, value))
        if not _taken(cycle, numbers, now, place, noise):
            last = cycle.itinerary[place][1]
            violations.append(Violation(place, name, last, float(begins[place + 1]), 0.0))
    return Admissibility(not violations, tuple(violations), ())


def _maximum(function: QuasiPolynomial, first: float, last: float) -> tuple[float, float]:
    """Return where a function that has crossed zero is largest, and its value there."""
    from scipy.optimize import minimize_scalar

    angle = function.fastest * (last - first)
    times = np.linspace(first, last, int(min(64 + _SAMPLES * angle, _MOST_SAMPLES)))
    values = [function(time) for time in times.tolist()]
    best = int(np.argmax(values))
    low, high = times[max(best - 1, 0)], times[min(best + 1, len(times) - 1)]
    if low < high:
        found = minimize_scalar(
            lambda time: -function(time), bounds=(low, high), method="bounded",
            options={"xatol": 1e-12 * high},
        )  # fmt: skip
        if -found.fun > values[best]:
            return float(found.x), float(-found.fun)
    return float(times[best]), float(values[best])


def _noise(
    cycle: ItineraryShape, numbers: Numbers, now: Shooting, place: int, duration: float
) -> np.ndarray:
    """Return the rounding of every row along a phase, whose terms are differences of the data.

    By as much as the phase misses the boundary that ends it, all rows may be off, up to a
    limit; also by as much as they change in the time by which the phase before misses its
    boundary. What vanishes at both ends has the size that it takes between them.
    """
    start, times = now.starts[place], np.linspace(0, duration, _SIZES)
    flows = flow_at(cycle.structure, numbers, cycle.configurations[place], times, np)
    states = abs(flows[..., :-1] @ start + flows[..., -1]).max(axis=0)
    normals = numbers.rows[:, :-1]
    size = abs(normals) @ states + abs(numbers.rows[:, -1])
    closing = float(np.max(abs(now.starts[-1] - now.starts[0])))
    missed = abs(float(now.residual[place])) + closing
    reset = numbers.resets[cycle.transitions[place - 1].reset][:, :-1]
    speed = max(abs(float(now.speeds[place - 1])), _SLOWEST)
    early = abs(float(now.residual[place - 1])) / speed
    begun = abs(normals @ (reset @ now.velocities[place - 1])) * early
    return np.asarray(64 * _EPSILON * size + np.minimum(2 * (missed + begun), MOST_MISSED * size))


def _taken(
    cycle: ItineraryShape, numbers: Numbers, now: Shooting, place: int, noise: np.ndarray
) -> bool:
    """Return whether what follows the end of a phase is the itinerary's transition."""
    if cycle.boundaries[place] is None:  # the forcing's phase changes nothing
        return True
    structure, source = cycle.structure, cycle.configurations[place]
    wanted, judge = cycle.transitions[place], _AtEnd(cycle, numbers, now, place, noise)
    found = choose(structure, source, wanted.boundaries, judge).transition
    if found is None or found is wanted:
        return found is wanted
    if found.target != wanted.target:
        return False
    # on other conditions, by other steps of the law, or in another order, the same may follow
    several = wanted.path is not None or structure.orders(source, wanted.boundaries) != (0,)
    return found.reset == wanted.reset or (several and judge.agree((found.reset, wanted.reset)))


@dataclass(frozen=True)
class _AtEnd:
    """A judge of signs at the end of a phase, which the orbit meets but for its residual."""

    cycle: ItineraryShape
    numbers: Numbers
    now: Shooting
    place: int
    noise: np.ndarray

    @cached_property
    def state(self) -> np.ndarray:
        return np.append(self.now.ends[self.place].astype(float), 1.0)

    def sign(self, row: int, along: int) -> int:
        function, sizes = self.numbers.rows[row], abs(self.state)
        noise = float(self.noise[row])
        relative = noise / max(float(abs(function[:-1]) @ sizes[:-1]), 1e-300)
        rounding = max(64 * _EPSILON, min(relative, MOST_MISSED))

        def sign(order: int, derivative: np.ndarray) -> int:
            value = float(derivative @ self.state)
            error = rounding * float(abs(derivative) @ sizes) if order else noise
            return 0 if not abs(value) > error else 1 if value > 0 else -1

        rows = derivatives(function, square(self.numbers.fields[along]), len(sizes))
        # the boundary that has just been reached is zero itself
        found = leading(rows, sign, int(row == self.cycle.rows[self.place]))
        return 0 if found is None else found.sign

    def agree(self, resets: Sequence[int]) -> bool:
        first, *others = (self.numbers.resets[reset] for reset in resets)

        def alike(other: np.ndarray) -> bool:
            sizes = (abs(first) + abs(other)) @ abs(self.state)
            return bool((abs((first - other) @ self.state) <= MOST_MISSED * sizes).all())

        return all(map(alike, others))

    def targets(self, event: ContactEvent) -> tuple[int, ...]:
        numbers, source = self.numbers, self.cycle.configurations[self.place]
        decider = Decider(self.cycle.structure, numbers.fields, numbers.rows, numbers.resets)
        missed = self.now.residual[self.place] / self.now.speeds[self.place]
        at = decider.located(source, self.state, 2 * abs(float(missed)))
        return decider.outcome(event, at).targets
