"""Periodic orbits of any itinerary of a system, composed from its flows at run time.

No kernels are generated for the itinerary: the numbers of the system's configurations,
boundaries and transitions are enough. Coordinates are physical, positions before velocities.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.routes import with_routes, with_routes_at
from nonsmooth.runtime.orbits.table_digits import digits_of
from nonsmooth.runtime.orbits.table_problem import TableProblem, orbit_of
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    guesses,
    itinerary_shape,
)
from nonsmooth.runtime.shooting.symmetric_orbit import (
    closing,
    part_of,
    whole_itinerary,
    whole_orbit,
    whole_shape,
)
from nonsmooth.runtime.shooting.symmetry import Symmetry, symmetry_of
from nonsmooth.runtime.shooting.table_newton import TableSolution, solve_shape
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift

__all__ = ["CONTINUATION_STEPS", "Symmetries", "known_orbit", "solve_itinerary", "steps_between"]

CONTINUATION_STEPS = 24  # from a reference orbit to other parameters

Symmetries = Mapping[str, str] | np.ndarray | Sequence[Sequence[int]] | None


def solve_itinerary(
    system: SystemKernels,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    dwell_times: Sequence[float],
    start: Sequence[float] | None = None,
    *,
    period: object = None,
    symmetry: Symmetries = None,
) -> Orbit:
    """Find the periodic orbit of an itinerary near a guess, in double precision.

    All physical parameters are given. There are guesses of the dwell times (p,) and of
    the state at the start (N,); without that the one is taken that fits the dwell times
    best. The period, if given, is what the dwell times have to sum up to; the symmetry is
    as for `nonsmooth.solve`. The result's `status` says whether it is an orbit.
    `InputError` is raised for wrong names, values or numbers of guesses, an itinerary
    that the system does not allow, or what is no symmetry of the system at these
    parameters.
    """
    stated = _stated(system, parameters, itinerary, period, symmetry)
    structure = stated.point.structure
    dwell = guesses("the guess of the dwell times", dwell_times, len(stated.part), positive=True)
    begin, directions = None, translations_of(stated.point)
    if start is not None:
        begin = guesses("the guess of the start", start, len(structure.states)).reshape(1, -1)
        begin = up_to_shift(begin, directions)
    found = solve_shape(stated.part, stated.flat, dwell.reshape(1, -1), begin, stated.length)
    found.starts[0, 0] = up_to_shift(found.starts[0, 0], directions)
    return _orbit(stated, found)


def known_orbit(
    system: SystemKernels,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    dwell_times: np.ndarray,
    states: np.ndarray,
    residual: float,
    *,
    period: object = None,
    symmetry: Symmetries = None,
) -> Orbit:
    """Return the orbit of numbers that were solved for before; its digits are counted anew.

    The dwell times (p,), the states (p, N) where phases begin and the residual stay as
    they are. Other arguments, and `InputError`, are as for `solve_itinerary`. The
    result's `status` says whether a dwell time, or all of it, is lost in rounding.
    """
    stated = _stated(system, parameters, itinerary, period, symmetry)
    found = TableSolution(
        dwell_times[None],
        states[None],
        np.full((1, *2 * states.shape[1:]), np.nan),
        np.array([residual]),
        np.zeros(1, dtype=np.int32),
        np.full(1, CONVERGED, dtype=np.int32),
    )
    return _orbit(stated, found)


class _Stated(NamedTuple):
    """The equations of an orbit at one point; `part` is what a symmetry or translations close."""

    kernels: SystemKernels
    point: PiecewiseLinear
    cycle: ItineraryShape
    mirror: Symmetry | None
    part: ItineraryShape
    flat: np.ndarray
    period: Value | None
    length: np.ndarray


def _stated(
    system: SystemKernels,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    period: object,
    symmetry: Symmetries,
) -> _Stated:
    """Return the equations; `length` (1,) is the sum of the part's dwell times, NaN where free."""
    mirror, phases = None, itinerary
    if symmetry is not None:
        declared = piecewise(system, parameters)
        mirror = symmetry_of(declared, symmetry)
        phases = whole_itinerary(declared.structure, mirror, itinerary)
    kernels = with_routes(system, phases)
    point = piecewise(kernels, parameters)
    if mirror is None:
        cycle = itinerary_shape(point.structure, itinerary)
    else:
        cycle = whole_shape(point, mirror, itinerary)
    closed, part = closing(point, cycle, mirror)
    wanted = None if period is None else as_value(period)
    length = np.nan if wanted is None else float(wanted)
    if wanted is not None and not 0 < length < np.inf:
        raise InputError(f"period = {wanted} is not positive and finite")
    if wanted is not None and mirror is not None:
        length = float(part_of(wanted, mirror.order))
    flat = numbers_of(closed)[None]
    return _Stated(kernels, point, cycle, mirror, part, flat, wanted, np.array([length]))


def _orbit(stated: _Stated, found: TableSolution) -> Orbit:
    """Return the record of a solution, with its digits and the routes that it takes."""
    digits, status = digits_of(stated.part, stated.flat, found, stated.length)
    point, cycle, mirror = stated.point, stated.cycle, stated.mirror
    times, states = whole_orbit(point, cycle, mirror, found.dwell[0], found.starts[0], np)
    kernels = with_routes_at(stated.kernels, point, cycle.itinerary, times, states)
    return orbit_of(
        TableProblem(kernels, cycle.itinerary, mirror),
        point.parameters,
        stated.period,
        times,
        states,
        float(found.residual[0]),
        int(digits[0]),
        int(found.iterations[0]),
        int(status[0]),
    )


def steps_between(begin: np.ndarray, end: np.ndarray) -> Iterator[np.ndarray]:
    """Yield points (p,) from begin to end: even in the logarithms of what is positive at both."""
    positive = (begin > 0) & (end > 0)
    ratio = np.where(positive, end, 1.0) / np.where(positive, begin, 1.0)
    for fraction in np.linspace(0, 1, CONTINUATION_STEPS + 1):
        yield np.where(positive, begin * ratio**fraction, begin + fraction * (end - begin))
