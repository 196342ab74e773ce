"""Admissibility: whether a solution of the equations is a motion of the real system.

Along every phase each boundary of its configuration has to stay uncrossed until the phase
ends. A boundary function is a trigonometric sum there; its maximum is found with a
guarantee, so that no violation is too short to be seen. Since a phase begins where the
transition before it has ended, this also checks the transitions' conditions.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.trigonometric_sums import LONGEST_PHASE, TrigonometricSum, maximum
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.kernels import Boundary, OrbitKernels
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = [
    "Admissibility",
    "Coincidence",
    "Requirement",
    "Violation",
    "admissible_points",
    "assess_admissibility",
    "boundary_sums",
    "first_violations",
    "sums_of",
]


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

    phase: int
    configuration: str
    boundary: str
    time: float
    excess: float


@dataclass(frozen=True)
class Requirement:
    """An open parameter has to be greater than a bound."""

    parameter: str
    greater_than: float


@dataclass(frozen=True)
class Coincidence:
    """Boundaries that are reached at one instant: a border collision.

    Attributes
    ----------
    phase : int
        The phase that takes no time; counted from 0.
    boundaries : tuple of str
    time : float
        Since the start of the orbit; nondimensional.
    """

    phase: int
    boundaries: tuple[str, ...]
    time: float


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
    """Check all boundaries along all phases of an orbit, in double precision."""
    kernels = orbit.kernels
    phases = kernels.table["phases"]
    dwell = orbit.dwell_times.astype(float).tolist()
    at_once = [name in kernels.table["vanishing"] for name in kernels.dwell_times]
    starts = np.concatenate([[0.0], np.cumsum(dwell)])
    violations: list[Violation] = []
    for phase, duration in enumerate(dwell):
        if not duration > 0 and not at_once[phase]:
            configuration, boundary, _ = phases[phase]
            violations.append(
                Violation(phase, configuration, boundary, float(starts[phase]), -duration)
            )
    if violations:
        return Admissibility(False, tuple(violations), ())
    least = {p.name: 0.0 for p in kernels.open_parameters if p.name not in orbit.opened}
    sums = list(boundary_sums(kernels, orbit))
    measures = [float(orbit.values[n]) for n in kernels.table["measures"]]
    noise = _noise(kernels, measures, sums, dwell)
    for boundary, function in sums:
        duration = dwell[boundary.phase]
        _check_length(orbit.name, phases[boundary.phase][0], function, duration)
        opened = boundary.open_parameter
        if opened in least:
            floor = -boundary.open_coefficient * least[opened]
            found = maximum(function, duration, floor)
            least[opened] = max(least[opened], found.value / -boundary.open_coefficient)
            continue
        if opened is not None:
            shift = boundary.open_coefficient * float(orbit.opened[opened])
            function = replace(function, constant=function.constant + shift)
        floor = function.rounding(duration) + noise
        rises = _rises(boundary, function, duration, noise)
        found = maximum(function, duration, -math.inf if rises else floor)
        if rises or found.value > floor:
            time = found.time if found.value > floor else 0.0
            violations.append(
                Violation(
                    boundary.phase,
                    phases[boundary.phase][0],
                    boundary.name,
                    float(starts[boundary.phase]) + time,
                    max(found.value, 0.0),
                )
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


def _noise(
    kernels: OrbitKernels,
    measures: Sequence[float],
    sums: Sequence[tuple[Boundary, TrigonometricSum]],
    dwell: Sequence[float],
) -> float:
    """Rounding of the coefficients themselves, which are differences of the data.

    By as much as a phase misses the boundary that ends it, all may be off: up to a limit,
    beyond which nothing is known.
    """
    size = max(map(abs, measures))
    exits = [name for _, name, _ in kernels.table["phases"]]
    missed = max(abs(g(dwell[b.phase])) for b, g in sums if b.name == exits[b.phase])
    return 32 * float(np.finfo(float).eps) * size + min(2 * missed, MOST_MISSED * size)


def _check_length(
    name: str, configuration: str, function: TrigonometricSum, duration: float
) -> None:
    """Say which phase is too long for a guaranteed search."""
    if not duration * max(function.frequency, default=0.0) <= LONGEST_PHASE:
        raise InputError(
            f"{name}: whether it is admissible cannot be guaranteed: {configuration} lasts"
            f" {duration:.6g}, more than {LONGEST_PHASE:g} radians of its fastest oscillation"
        )


def _rises(boundary: Boundary, function: TrigonometricSum, duration: float, noise: float) -> bool:
    """Whether a phase begins on a boundary and rises: it crosses it, however little."""
    return boundary.begins and duration > 0 and function.rises(noise)


def boundary_sums(
    kernels: OrbitKernels, orbit: Orbit
) -> Iterator[tuple[Boundary, TrigonometricSum]]:
    """Each boundary of each phase with its function of the time since the phase's start.

    An open parameter's contribution is left out of the function.
    """
    parameters = [float(orbit.values[name]) for name in kernels.parameter_names]
    unknowns = [float(orbit.values[name]) for name in kernels.unknowns]
    spectrum, _ = kernels.spectrum(parameters)
    coefficients, frequencies = kernels.evaluate(
        "boundary_functions", parameters, spectrum, unknowns
    )
    yield from sums_of(kernels, coefficients, frequencies)


def sums_of(
    kernels: OrbitKernels, coefficients: Any, frequencies: Any
) -> Iterator[tuple[Boundary, TrigonometricSum]]:
    """Rows of the `boundary_functions` kernel of one point as functions of time."""
    terms = kernels.table["terms"]
    first_frequency = np.concatenate([[0], np.cumsum(terms)])
    place = 0
    for boundary in kernels.boundaries:
        count = terms[boundary.phase]
        begin = first_frequency[boundary.phase]
        row = [float(c) for c in coefficients[place : place + 2 + 2 * count]]
        place += 2 + 2 * count
        yield (
            boundary,
            TrigonometricSum(
                row[0],
                row[1],
                tuple(row[2 : 2 + count]),
                tuple(row[2 + count :]),
                tuple(float(w) for w in frequencies[begin : begin + count]),
            ),
        )


def admissible_points(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Check many orbits: for large enough open parameters, and how large that is.

    Parameters
    ----------
    kernels : OrbitKernels
    points : array (count, p)
        Parameters of the equations.
    unknowns : array (count, n)

    Returns
    -------
    allowed : array (count,) of bool
    bounds : array (count, open parameters)
        What each open parameter has to exceed; NaN where nothing is allowed.
    """
    if kernels.admissible is None:
        boundary, bounds = _admissible_numpy(kernels, points, unknowns)
    else:
        with np.errstate(all="ignore"):  # points without an orbit are NaN
            *bounded, boundary, _, _ = kernels.admissible(points, unknowns)
        bounds = np.asarray(bounded[0]) if bounded else np.empty((len(points), 0))
    allowed = np.asarray(boundary == -1)
    bounds[~allowed] = np.nan
    return allowed, bounds


def first_violations(kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray) -> np.ndarray:
    """Which boundary is crossed inside a phase, at many orbits.

    Parameters
    ----------
    kernels : OrbitKernels
    points : array (count, p)
        Parameters of the equations.
    unknowns : array (count, n)

    Returns
    -------
    array (count,) of int
        Row of the first of `kernels.boundaries` that is crossed; -1 where none is, -2 where a
        dwell time is not positive, -3 where it cannot be told.
    """
    if kernels.admissible is None:
        return _admissible_numpy(kernels, points, unknowns)[0]
    with np.errstate(all="ignore"):
        *_, boundary, _, _ = kernels.admissible(points, unknowns)
    return np.asarray(boundary)


def _admissible_numpy(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The compiled test's algorithm, point by point: its codes, and the bounds."""
    crossed = np.full(len(points), -3)
    opened = [p.name for p in kernels.open_parameters]
    bounds = np.zeros((len(points), len(opened)))
    values = dict(zip(kernels.parameter_names, points.T, strict=True))
    durations = kernels.durations(values | dict(zip(kernels.unknowns, unknowns.T, strict=True)))
    dwell = np.stack([np.broadcast_to(d, len(points)) for d in durations.values()], axis=-1)
    timed = [name not in kernels.table["vanishing"] for name in durations]
    crossed[(dwell[:, timed] <= 0).any(axis=-1)] = -2
    sound = np.flatnonzero(np.isfinite(unknowns).all(axis=-1) & (dwell[:, timed] > 0).all(axis=-1))
    spectrum, _ = kernels.spectrum(points[sound])
    coefficients, frequencies = kernels.evaluate(
        "boundary_functions", points[sound], spectrum, unknowns[sound]
    )
    names = [*kernels.parameter_names, *kernels.unknowns]
    places = [names.index(name) for name in kernels.table["measures"]]
    for row, point in enumerate(sound):
        try:
            sums = list(sums_of(kernels, coefficients[row], frequencies[row]))
            measures = np.concatenate([points[point], unknowns[point]])[places].tolist()
            noise = _noise(kernels, measures, sums, dwell[point].tolist())
            for number, (boundary, function) in enumerate(sums):
                duration = float(dwell[point, boundary.phase])
                if boundary.open_parameter is None:
                    floor = function.rounding(duration) + noise
                    if (
                        _rises(boundary, function, duration, noise)
                        or maximum(function, duration, floor).value > floor
                    ):
                        crossed[point] = number
                        break
                else:
                    place = opened.index(boundary.open_parameter)
                    unit = -boundary.open_coefficient
                    found = maximum(function, duration, unit * bounds[point, place])
                    bounds[point, place] = found.value / unit
            else:
                crossed[point] = -1
        except InputError:  # overflow, or a phase too long for any guarantee
            continue
    return crossed, bounds
