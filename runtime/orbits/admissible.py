"""Admissibility: whether a solution of the equations is a motion of the real system.

Along every phase each boundary of its configuration has to stay uncrossed until the phase
ends. A boundary function is a trigonometric sum there, or an affine function along a damped or
forced motion; its maximum is found with a guarantee, so that no violation is too short to be
seen. Since a phase begins where the transition before it has ended, this also checks the
transitions' conditions.

Kernels give the functions, and test millions of points in C. By the tables of a system transitions
are to be chosen: of those that are declared for a boundary the first whose conditions hold has to
be the itinerary's. Of many orbits by tables each phase is followed by the compiled engine from its
own start to the first boundary that it reaches: where that is the itinerary's, at its time,
nothing was crossed before. Where the engine's rounding could decide, the guaranteed test of single
orbits does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyDigits, Ordinal
from nonsmooth.runtime.events.crossings_and_maxima import maximum
from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.events.quasi_polynomials import (
    ModeFunctions,
    QuasiPolynomial,
    functions_along,
    plain_functions,
)
from nonsmooth.runtime.events.transition_choice import Decider, choose
from nonsmooth.runtime.model.boundary_sets import lowest_of, mask_of
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, Status
from nonsmooth.runtime.model.kernels import Boundary, OrbitKernels, SystemKernels, compiled_engine
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, numbers_at, piecewise_at
from nonsmooth.runtime.shooting.kernel_newton import dwell_times, lasting_phases
from nonsmooth.runtime.shooting.newton import NEGATIVE
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

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

NEITHER, NO_ORBIT, UNTOLD = -1, -2, -3  # limits: none fails, there is no orbit, it is not told
MOST_MISSED = 2.0**-30  # in units of the data; the compiled test's number
_EPSILON = float(np.finfo(float).eps)
_SLOWEST = float(np.finfo(float).tiny)
_SIZES = 9  # instants of a phase at which the sizes of its states are taken
CHUNK = 1 << 11  # points whose numbers are in memory at once
_CLOSE = 1e-6  # of a dwell time: nearer to its ends rounding may decide
_EARLY = 1e-3  # the same for the boundary that ends the phase
_ZERO = 1e-9  # of the terms of a boundary function
_LONGER = 1.5  # than a dwell time nothing is looked for


@dataclass(frozen=True)
class Violation:
    """A boundary that is crossed inside a phase.

    Attributes
    ----------
    phase : int
        Counted from 0.
    configuration, boundary : str
    time : float
        Of the largest excess, since the start of the orbit; nondimensional.
    excess : float
        By which the boundary is crossed there; nondimensional.
    """

    phase: Ordinal
    configuration: str
    boundary: str
    time: AnyDigits
    excess: AnyDigits


@dataclass(frozen=True)
class Requirement:
    """The condition that an open parameter is greater than a bound."""

    parameter: str
    greater_than: AnyDigits


@dataclass(frozen=True)
class Coincidence:
    """Boundaries that are reached at one instant: a border collision."""

    phase: Ordinal  # the one that takes no time, from 0
    boundaries: tuple[str, ...]
    time: AnyDigits  # since the start of the orbit, nondimensional


@dataclass(frozen=True)
class Admissibility:
    """Verdict on a solution.

    Attributes
    ----------
    verdict : True, False or "conditional"
        Conditional: it depends on open parameters, as `requires` says.
    violations : tuple of Violation
    requires : tuple of Requirement
        Also for the parameters that combine with an open one (ur1 = us1 + e1).
    coincidences : tuple of Coincidence
        Where they are the orbit is a limit of motions: admissible, but not strictly.
    """

    verdict: bool | str
    violations: tuple[Violation, ...]
    requires: tuple[Requirement, ...]
    coincidences: tuple[Coincidence, ...] = ()


def assess_admissibility(orbit: Orbit) -> Admissibility:
    """Check all boundaries along all phases of a converged orbit of kernels, in double precision.

    `InputError` is raised for a phase longer than the search for maxima reaches.
    """
    kernels = orbit.kernels
    phases = kernels.table["phases"]
    dwell = orbit.dwell_times.astype(float).tolist()
    at_once = [name in kernels.table["vanishing"] for name in kernels.dwell_times]
    starts = np.concatenate([[0.0], np.cumsum(dwell)])
    violations: list[Violation] = []
    lasting = [wait for wait, now in zip(dwell, at_once, strict=True) if not now]
    none = max(0.0, min(lasting)) if orbit.status == NEGATIVE else 0.0  # within its error
    for phase, duration in enumerate(dwell):
        if not duration > none and not at_once[phase]:
            configuration, boundary, _ = phases[phase]
            excess = max(0.0, -duration)
            violations.append(
                Violation(phase, configuration, boundary, float(starts[phase]), excess)
            )
    if violations:
        return Admissibility(False, tuple(violations), ())
    least = dict.fromkeys(orbit.problem.left_open(orbit), 0.0)
    curves = list(boundary_curves(orbit))
    measures = [float(orbit.values[n]) for n in kernels.table["measures"]]
    for number, time, excess in _crossings(
        kernels, orbit.name, curves, measures, dwell, least, orbit.opened
    ):
        boundary = kernels.boundaries[number]
        begin, configuration = float(starts[boundary.phase]), phases[boundary.phase][0]
        violations.append(
            Violation(boundary.phase, configuration, boundary.name, begin + time, excess)
        )
    coincidences = tuple(
        Coincidence(phase, (phases[phase - 1][1], phases[phase][1]), float(starts[phase or -1]))
        for phase in np.flatnonzero(at_once).tolist()
    )
    if violations:
        return Admissibility(False, tuple(violations), (), coincidences)
    requires = [Requirement(name, bound) for name, bound in least.items()]
    known = {name: float(number) for name, number in orbit.values.items()} | least
    requires += [Requirement(name, bound) for name, bound in follow(kernels, known).items()]
    return Admissibility("conditional" if least else True, (), tuple(requires), coincidences)


def _crossings(
    kernels: OrbitKernels,
    name: str,
    curves: Sequence[tuple[Boundary, QuasiPolynomial]],
    measures: Sequence[float],
    dwell: Sequence[float],
    least: dict[str, float],
    opened: Mapping[str, Any],
) -> Iterator[tuple[int, float, float]]:
    """Yield each boundary that is crossed inside its phase: its number, when most, and how far.

    Times are since the phase's start. `curves` are those of `boundary_curves`. Open parameters
    have the values `opened`; those in `least` are as large as they have to be, and their bounds
    there are raised. `InputError` is raised for a phase longer than the search for maxima
    reaches.
    """
    noise = _noise(kernels, measures, curves, dwell)
    for number, (boundary, function) in enumerate(curves):
        duration = dwell[boundary.phase]
        configuration = kernels.table["phases"][boundary.phase][0]
        _check_length(name, configuration, function, duration)
        parameter = boundary.open_parameter
        if parameter in least:
            unit = -boundary.open_coefficient
            highest = maximum(function, duration, unit * least[parameter])
            # the maximum is at least its floor: only a rounding makes it the smaller one
            least[parameter] = max(least[parameter], highest.value / unit)
            continue
        if parameter is not None:
            function = function.raised(boundary.open_coefficient * float(opened[parameter]))
        floor = function.rounding(duration) + noise
        rises = boundary.begins and duration > 0 and function.rises(noise)
        highest = maximum(function, duration, -math.inf if rises else floor)
        above = highest.value > floor
        if rises or above:  # a phase may begin on a boundary and cross it there, however little
            yield number, highest.time if above else 0.0, max(highest.value, 0.0)


def _noise(
    kernels: OrbitKernels,
    measures: Sequence[float],
    curves: Sequence[tuple[Boundary, QuasiPolynomial]],
    dwell: Sequence[float],
) -> float:
    """Return the rounding of a phase's boundary functions.

    Their coefficients are differences of the data. By as much as the phase misses the
    boundary that ends it, all functions may be off, up to a limit beyond which nothing is
    known.
    """
    size = max(map(abs, measures))
    exits = [name for _, name, _ in kernels.table["phases"]]
    missed: float = max(abs(g(dwell[b.phase])) for b, g in curves if b.name == exits[b.phase])
    return 32 * _EPSILON * size + min(2 * missed, MOST_MISSED * size)


def _check_length(
    name: str, configuration: str, function: QuasiPolynomial, duration: float
) -> None:
    """Refuse a phase that is too long for a guaranteed search, by its name."""
    if not duration * function.fastest <= LONGEST_WAIT:
        raise InputError(
            f"{name}: whether it is admissible cannot be guaranteed: {configuration} lasts"
            f" {duration:.6g}, more than {LONGEST_WAIT:g} radians of its fastest oscillation"
        )


def boundary_curves(orbit: Orbit) -> Iterator[tuple[Boundary, QuasiPolynomial]]:
    """Yield each boundary of each phase with its function of the time since the phase's start.

    The boundaries come in the kernels' order. The contribution of an open parameter is
    left out of the functions.
    """
    (curves,) = _curves(orbit.kernels, *orbit.kernel_point)
    yield from curves()


def _curves(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray
) -> Iterator[Callable[[], Iterator[tuple[Boundary, QuasiPolynomial]]]]:
    """Yield for each of many points a function that makes its boundary functions when called."""
    spectrum, _ = kernels.spectrum(points)
    read: Callable[..., Iterator[tuple[Boundary, QuasiPolynomial]]] = _along_motions
    quantities: tuple[str, ...] = ("states", "fields", "boundaries")
    if kernels.trigonometric:
        read, quantities = _sums, ("coefficients", "frequencies")
    arrays = kernels.evaluate(*quantities, at=(points, spectrum, unknowns))
    for row in range(len(points)):
        yield partial(read, kernels, *(array[row] for array in arrays))


def _sums(
    kernels: OrbitKernels, coefficients: np.ndarray, frequencies: np.ndarray
) -> Iterator[tuple[Boundary, QuasiPolynomial]]:
    """Yield the boundaries and their sums at one point."""
    functions: dict[int, ModeFunctions] = {}
    for boundary, row, angular in trigonometric_rows(kernels, coefficients, frequencies):
        if boundary.phase not in functions:
            exponents = [0j, *(1j * angular).tolist()]
            functions[boundary.phase] = plain_functions(exponents, [2, *[1] * len(angular)])
        constant, slope, *waves = row.tolist()
        pairs = zip(waves[: len(angular)], waves[len(angular) :], strict=True)
        factors = (complex(constant), complex(slope), *(complex(c, -s) for c, s in pairs))
        yield (
            boundary,
            QuasiPolynomial(functions[boundary.phase], factors, tuple(map(abs, factors))),
        )


def trigonometric_rows(
    kernels: OrbitKernels, coefficients: np.ndarray, frequencies: np.ndarray
) -> Iterator[tuple[Boundary, np.ndarray, np.ndarray]]:
    """Yield each boundary with its coefficients (..., 2 + 2 w) and frequencies (..., w).

    The coefficients are constant, slope, cosines and sines. All of them are given one boundary
    after the other, the frequencies phase after phase.
    """
    terms, place = kernels.table["terms"], 0
    for boundary in kernels.boundaries:
        count, first = terms[boundary.phase], sum(terms[: boundary.phase])
        end = place + 2 + 2 * count
        yield boundary, coefficients[..., place:end], frequencies[..., first : first + count]
        place = end


def _along_motions(
    kernels: OrbitKernels, states: np.ndarray, fields: np.ndarray, rows: np.ndarray
) -> Iterator[tuple[Boundary, QuasiPolynomial]]:
    """Yield the boundaries and their functions along damped or forced motions at one point."""
    phases = np.array([boundary.phase for boundary in kernels.boundaries])
    found: dict[int, QuasiPolynomial] = {}
    for phase, field in enumerate(np.split(fields, len(states) - 1)):
        modes, places = numeric_modes(field), np.flatnonzero(phases == phase)
        functions = ModeFunctions(modes.shapes, modes.exponents)
        state = np.append(states[phase], 1.0)
        curves = functions_along(functions, modes.flows, rows[places], state, abs(state))
        found.update(zip(places.tolist(), curves, strict=True))
    yield from zip(kernels.boundaries, map(found.__getitem__, range(len(found))), strict=True)


def kernel_limits(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return which boundary is crossed first inside a phase, at many orbits, and bounds.

    `points` (count, p) are parameters of the equations, `unknowns` is (count, n). The ints
    (count,) are indices into `kernels.boundaries`; NEITHER where none is crossed for large
    enough open parameters, NO_ORBIT where a dwell time is not positive, UNTOLD where it cannot
    be told. What open parameters have to exceed is (count, open parameters), and NaN where no
    value makes an orbit admissible.
    """
    if kernels.admissible is None:
        limit, bounds = _admissible_numpy(kernels, points, unknowns)
    else:
        *bounded, limit, _, _ = kernels.admissible(points, unknowns)
        bounds = np.asarray(bounded[0]) if bounded else np.empty((len(points), 0))
    bounds[limit != NEITHER] = np.nan
    return np.asarray(limit), bounds


def kernels_allow(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, opened: Mapping[str, Any]
) -> np.ndarray:
    """Return which orbits (count,) are motions of the real system, as `kernel_limits` takes them.

    The values of open parameters, as far as they are given, have to exceed their bounds.
    """
    limit, bounds = kernel_limits(kernels, points, unknowns)
    allowed = limit == NEITHER
    for column, table in enumerate(kernels.open_parameters):
        if table.name in opened:
            allowed &= float(opened[table.name]) > bounds[:, column]
    return np.asarray(allowed)


def _admissible_numpy(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the compiled test's codes and bounds, by the same algorithm point by point."""
    crossed = np.full(len(points), UNTOLD)
    opened = [p.name for p in kernels.open_parameters]
    bounds = np.zeros((len(points), len(opened)))
    x, timed = np.concatenate([unknowns, points], axis=-1), lasting_phases(kernels)
    dwell = dwell_times(kernels, x, range(len(kernels.dwell_times)))
    crossed[(dwell[:, timed] <= 0).any(axis=-1)] = NO_ORBIT
    sound = np.flatnonzero(np.isfinite(unknowns).all(axis=-1) & (dwell[:, timed] > 0).all(axis=-1))
    names = [*kernels.unknowns, *kernels.parameter_names]
    places = [names.index(name) for name in kernels.table["measures"]]
    found = _curves(kernels, points[sound], unknowns[sound])
    for point, curves_of in zip(sound.tolist(), found, strict=True):
        try:
            curves, least = list(curves_of()), dict.fromkeys(opened, 0.0)
            measures, times = x[point, places].tolist(), dwell[point].tolist()
            crossings = _crossings(kernels, kernels.name, curves, measures, times, least, {})
            crossed[point], _, _ = next(crossings, (NEITHER, 0.0, 0.0))
            bounds[point] = [*least.values()]
        except InputError:  # overflow, or a phase too long for any guarantee
            continue
    return crossed, bounds


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
        noise = _noise_of_phase(cycle, numbers, now, place, duration)
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


def _noise_of_phase(
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
