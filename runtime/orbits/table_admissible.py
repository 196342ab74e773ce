"""Whether an orbit by its system's tables is a motion of the real system, in double precision.

No boundary may be crossed inside a phase, and of the transitions that are declared for a
boundary the first whose conditions hold has to be the itinerary's.

Of many orbits each phase is followed by the compiled engine from its own start to the first
boundary that it reaches: where that is the itinerary's, at its time, nothing was crossed before.
Where the engine's rounding could decide, the guaranteed test of single orbits does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from types import ModuleType

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.crossings_and_maxima import maximum
from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.events.quasi_polynomials import ModeFunctions, functions_along
from nonsmooth.runtime.events.transition_choice import Decider, choose
from nonsmooth.runtime.model.boundary_sets import lowest_of, mask_of
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, Status
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, numbers_at, piecewise_at
from nonsmooth.runtime.orbits.admissible import (
    MOST_MISSED,
    NEITHER,
    UNTOLD,
    Admissibility,
    Violation,
)
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    finite_at,
    flow_at,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.translations import projection_along, translations_of
from nonsmooth.runtime.simulation.engines import run_motions

_EPSILON = float(np.finfo(float).eps)
_SLOWEST = float(np.finfo(float).tiny)
_SIZES = 9  # instants of a phase at which the sizes of its states are taken
CHUNK = 1 << 11  # points whose numbers are in memory at once
_CLOSE = 1e-6  # of a dwell time: nearer to its ends rounding may decide
_EARLY = 1e-3  # the same for the boundary that ends the phase
_ZERO = 1e-9  # of the terms of a boundary function
_LONGER = 1.5  # than a dwell time nothing is looked for


def assess_cycle(
    cycle: ItineraryShape, system: PiecewiseLinear, dwell: np.ndarray, start: np.ndarray
) -> Admissibility:
    """Check all boundaries along all phases of an orbit by tables, and all transitions.

    `dwell` (p,) is in the unit of time, `start` (N,) the state where the first phase begins. A
    transition that the conditions refuse is a violation of its boundary at the end of its phase,
    with the excess 0. `InputError` is raised for a phase longer than the guarantee of the
    search reaches.
    """
    cycle, numbers = cycle.at(system.structure), numbers_in(system)
    now = shoot(cycle, numbers, dwell, start, np)
    behind = projection_along(translations_of(system)) @ now.starts[-1]
    now = now._replace(starts=np.concatenate([now.starts[:-1], behind[None]]))
    begins = np.concatenate([[0.0], np.cumsum(dwell)])
    modes = {
        c: ModeFunctions(cycle.structure.shapes[c], system.exponents[c])
        for c in {*cycle.configurations}
    }
    violations = []
    for place, duration in enumerate(dwell.tolist()):
        configuration = cycle.configurations[place]
        name = cycle.structure.configurations[configuration]
        functions = modes[configuration]
        if not duration * functions.fastest <= LONGEST_WAIT:
            raise InputError(
                f"{name} lasts {duration:.6g}, more than {LONGEST_WAIT:g} over its largest"
                " exponent: no guarantee reaches that far"
            )
        noise = _noise(cycle, numbers, now, place, duration)
        shapes = cycle.structure.boundaries[configuration]
        along = functions, system.flows[configuration]
        rows = system.rows[[shape.row for shape in shapes]]
        state = np.append(now.starts[place], 1.0)
        curves = functions_along(*along, rows, state, abs(state))
        for function, shape in zip(curves, shapes, strict=True):
            rounding = max(function.rounding(0.0), function.rounding(duration))
            excess, time = maximum(function, duration, rounding + float(noise[shape.row]))
            if not math.isnan(time):
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

        rows = derivatives(function, self.numbers.fields[along], len(sizes))
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


def limits_at(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    dwell: np.ndarray,
    starts: np.ndarray,
) -> np.ndarray:
    """Return the limits (n,) of orbits of one itinerary at many finite parameter points.

    They are as for `first_limits`; `UNTOLD` also where double precision does not tell the
    flows. `points` is (n, parameters), `dwell` (n, p), and `starts` (n, p, N) where the
    phases begin.
    """
    limits = np.full(len(points), UNTOLD)
    for begin in range(0, len(points), CHUNK):
        for group in numbers_at(system, points[begin : begin + CHUNK], cycle.configurations):
            here = cycle.at(group.structure)
            sound = finite_at(here, group.flat)
            at = begin + group.places[sound]
            limits[at] = first_limits(
                system, here, points[at], group.flat[sound], dwell[at], starts[at]
            )
    return limits


def first_limits(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    numbers: np.ndarray,
    dwell: np.ndarray,
    starts: np.ndarray,
) -> np.ndarray:
    """Return which boundary each of n orbits of one itinerary crosses first, as an int (n,).

    It is the number among all boundaries, phase after phase; `NEITHER` where the orbit is
    a motion, `UNTOLD` where no guarantee reaches, or a dwell time is NaN. `numbers` (n, size)
    are as `numbers_at` gives them, `points` is (n, parameters), `dwell` (n, p), and `starts`
    (n, p, N) where the phases begin.
    """
    unsure = np.isfinite(dwell).all(axis=-1)
    limit = np.where(unsure, NEITHER, UNTOLD)
    engine, (sure,) = compiled_engine(), np.nonzero(unsure & (dwell > 0).all(axis=-1))
    if engine is not None and len(sure):
        at = numbers, sure, dwell[sure], starts[sure]
        limit[sure], unsure[sure] = _limits_by_engine(engine, cycle, *at)
    for row in np.flatnonzero(unsure).tolist():
        limit[row] = _guaranteed(system, cycle, points[row], dwell[row], starts[row, 0])
    return limit


def _limits_by_engine(
    engine: ModuleType,
    cycle: ItineraryShape,
    numbers: np.ndarray,
    points: np.ndarray,
    dwell: np.ndarray,
    starts: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the limits (n,) that the engine tells of orbits, and where its rounding may decide.

    `points` (n,) are rows of the numbers.
    """
    count, phases = dwell.shape
    limit, unsure = np.full(count, NEITHER), np.full(count, False)
    # the phases of a point one after the other: the engine prepares its numbers once
    ends = run_motions(
        engine,
        cycle.structure,
        numbers,
        np.repeat(points, phases),
        starts.reshape(count * phases, -1),
        np.tile(cycle.configurations, count),
        _LONGER * dwell.ravel(),
        1,
        2,
    ).reshaped(count, phases)
    first = 0
    for place, configuration in enumerate(cycle.configurations):
        rows = np.flatnonzero((limit == NEITHER) & ~unsure)
        found, times = ends.at((rows, place)), dwell[rows, place]
        reached, when = found.last_sets[:, 1], found.last_times[:, 1]
        own = mask_of(cycle.transitions[place].boundaries)
        moved = found.status == Status.TRANSITIONS
        expected = moved & (reached == own) & (np.abs(when - times) <= _CLOSE * times)
        expected &= found.last_configurations[:, 1] == cycle.configurations[(place + 1) % phases]
        if cycle.boundaries[place] is None:  # the forcing's phase begins anew: none is reached
            expected = np.isin(found.status, (Status.UNTIL, Status.QUIET))
        unsure[rows[~expected]] = True
        early = np.flatnonzero(moved & ~expected)
        if len(early):
            rows, reached, when, times = rows[early], reached[early], when[early], times[early]
            close = np.where((reached & own) != 0, _EARLY, _CLOSE) * times
            lowest, at_once = lowest_of(reached), when <= _CLOSE * times
            rises = _rises(
                cycle, configuration, numbers[points[rows]], starts[rows, place], lowest, times
            )
            crossed = (when < times - close) & ((when > close) | (at_once & rises))
            limit[rows[crossed]], unsure[rows[crossed]] = first + lowest[crossed], False
        first += len(cycle.structure.boundaries[configuration])
    return limit, unsure


def _rises(
    cycle: ItineraryShape,
    configuration: int,
    numbers: np.ndarray,
    starts: np.ndarray,
    boundaries: np.ndarray,
    times: np.ndarray,
) -> np.ndarray:
    """Return where a boundary is crossed at the start of a phase, beyond all rounding."""
    here = numbers_in(cycle.structure, numbers)
    of_boundary = np.array([shape.row for shape in cycle.structure.boundaries[configuration]])
    row = np.take_along_axis(here.rows, of_boundary[boundaries][:, None, None], axis=1)[:, 0]
    field, normal = here.fields[:, configuration], row[:, :-1]
    terms, constants = field[:, :, :-1] * starts[:, None, :], field[:, :, -1]
    velocity = terms.sum(axis=-1) + constants
    # forces may cancel, as where a contact has just broken loose: their terms tell the rounding
    velocities = np.abs(terms).sum(axis=-1) + np.abs(constants)
    size = (np.abs(normal) * np.abs(starts)).sum(axis=-1) + np.abs(row[:, -1])
    size += (np.abs(normal) * velocities).sum(axis=-1) * times
    value = (normal * starts).sum(axis=-1) + row[:, -1]
    rate = (normal * velocity).sum(axis=-1)
    return np.asarray((np.abs(value) <= _ZERO * size) & (rate * times > _CLOSE * size))


def _guaranteed(
    system: SystemKernels,
    cycle: ItineraryShape,
    point: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray,
) -> int:
    """Return the limit of one orbit, by the guaranteed test of its boundary functions."""
    if not (dwell > 0).all():
        return UNTOLD
    here = piecewise_at(system, point, cycle.configurations)
    try:
        verdict = assess_cycle(cycle, here, dwell, start)
    except InputError:
        return UNTOLD
    if not verdict.violations:
        return NEITHER
    first = verdict.violations[0]
    before = sum(len(cycle.structure.boundaries[c]) for c in cycle.configurations[: first.phase])
    names = [shape.name for shape in cycle.structure.boundaries[cycle.configurations[first.phase]]]
    return before + names.index(first.boundary.partition("+")[0])
