"""Admissibility: whether a solution of the equations is a motion of the real system.

Along every phase each boundary of its configuration has to stay uncrossed until the phase
ends. A boundary function is a trigonometric sum there, or an affine function along a damped or
forced motion; its maximum is found with a guarantee, so that no violation is too short to be
seen. Since a phase begins where the transition before it has ended, this also checks the
transitions' conditions.

`table_admissible` does the same for orbits without kernels. Both stay: kernels give the
functions, and test millions of points in C, while tables have transitions that are to be chosen.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyDigits, Ordinal
from nonsmooth.runtime.events.crossings_and_maxima import maximum
from nonsmooth.runtime.events.quasi_polynomials import (
    ModeFunctions,
    QuasiPolynomial,
    functions_along,
    plain_functions,
)
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.kernels import Boundary, OrbitKernels
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.shooting.kernel_newton import dwell_times, lasting_phases
from nonsmooth.runtime.shooting.newton import NEGATIVE

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

NEITHER, NO_ORBIT, UNTOLD = -1, -2, -3  # limits: none fails, there is no orbit, it is not told
MOST_MISSED = 2.0**-30  # in units of the data; the compiled test's number


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
    return 32 * float(np.finfo(float).eps) * size + min(2 * missed, MOST_MISSED * size)


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
