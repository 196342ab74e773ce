"""Periodic orbits of any itinerary of a system, composed from its flows at run time.

No kernels are generated for the itinerary: the numbers of the system's configurations,
boundaries and transitions are enough. Coordinates are physical, positions before velocities.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.routes import with_routes, with_routes_at
from nonsmooth.runtime.orbits.table_problem import TableProblem, orbit_of
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.cycle_newton import (
    Found,
    sizes,
    solve_cycle,
)
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import (
    Cycle,
    cycle_of,
    guesses,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import (
    closing,
    part_of,
    symmetry_of,
    whole_cycle,
    whole_itinerary,
    whole_orbit,
)
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift

__all__ = ["Symmetries", "solve_itinerary"]

Symmetries = Mapping[str, str] | np.ndarray | Sequence[Sequence[int]] | None

_ROUNDING = 16 * float(np.finfo(float).eps)  # of one phase, in units of the states' sizes


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

    Parameters
    ----------
    system : SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters of the system.
    itinerary : sequence of (configuration, boundary)
    dwell_times : sequence (p,) of float
        Guess, for each phase of the itinerary.
    start : sequence (N,) of float, optional
        Guess of the state at the start; without it the one that fits the dwell times best.
    period : str, number or Value, optional
        What the dwell times have to sum up to.
    symmetry : mapping of state to text, or array (N, N), optional
        As for `nonsmooth.solve`.

    Returns
    -------
    Orbit
        Its `status` says whether it is one.

    Raises
    ------
    InputError
        For wrong names, values or numbers of guesses, an itinerary that the system does not
        allow, or what is no symmetry of the system at these parameters.
    """
    mirror, phases = None, itinerary
    if symmetry is not None:
        declared = piecewise(system, parameters)
        mirror = symmetry_of(declared, symmetry)
        phases = whole_itinerary(declared.structure, mirror, itinerary)
    kernels = with_routes(system, phases)
    point = piecewise(kernels, parameters)
    structure = point.structure
    if mirror is None:
        cycle = cycle_of(structure, itinerary)
    else:
        cycle = whole_cycle(point, mirror, itinerary)
    closed, part = closing(point, cycle, mirror)
    dwell = guesses("the guess of the dwell times", dwell_times, len(part), positive=True)
    begin, directions = None, translations_of(point)
    if start is not None:
        begin = guesses("the guess of the start", start, len(structure.states)).reshape(1, -1)
        begin = up_to_shift(begin, directions)
    wanted = None if period is None else as_value(period)
    length = np.nan if wanted is None else float(wanted)
    if wanted is not None and not 0 < length < np.inf:
        raise InputError(f"period = {wanted} is not positive and finite")
    if wanted is not None and mirror is not None:
        length = float(part_of(wanted, mirror.order))
    found = solve_cycle(
        part, numbers_of(closed)[None], dwell.reshape(1, -1), begin, np.array([length])
    )
    found.starts[0, 0] = up_to_shift(found.starts[0, 0], directions)
    part_of_it = found.dwell[0], found.starts[0]
    times, states = whole_orbit(point, cycle, mirror, *part_of_it, np)
    kernels = with_routes_at(kernels, point, cycle.itinerary, times, states)
    return orbit_of(
        TableProblem(kernels, cycle.itinerary, mirror),
        point.parameters,
        wanted,
        times,
        states,
        float(found.residual[0]),
        _digits(part, closed, found, length),
        int(found.iterations[0]),
        int(found.status[0]),
    )


def _digits(part: Cycle, system: PiecewiseLinear, found: Found, period: float) -> int:
    """Decimal digits of an orbit in double precision, by the inverse of its equations.

    What closure and switching miss, and rounding, move the start by as much as the smallest
    singular value lets them, and the dwell times with it.
    """
    if found.status[0] != CONVERGED:
        return 0
    dwell, start, numbers = found.dwell[0], found.starts[0, 0], numbers_in(system)
    now = shoot(part, numbers, dwell, start, np)
    directions = translations_of(system)  # how far it drifts is no size
    starts, ends, fields = (
        up_to_shift(part, directions) for part in (now.starts, now.ends, now.velocities)
    )
    size_of = sizes(now._replace(starts=starts, ends=ends, velocities=fields), dwell)
    matrix, right = linearised_closure(now, dwell, size_of, np.float64(period))
    matrix, right = with_forcing(part, numbers, now, size_of, matrix, right, FLOATS)
    least = float(np.linalg.svd(matrix, compute_uv=False)[-1])
    missed = float(np.abs(right).max()) + _ROUNDING * len(part)
    relative = missed / least if least else math.inf
    by_start = relative * (np.abs(now.rates[:, :-1]) @ size_of)
    by_gap = np.abs(now.residual / now.speeds) + _ROUNDING * dwell
    errors = [
        *(relative * size_of / np.maximum(1, np.abs(start))),
        *((by_start + by_gap) / np.maximum(1, dwell)),
    ]
    largest = max(errors)
    if not math.isfinite(largest):
        return 0
    return max(0, min(DOUBLE, math.floor(-math.log10(max(largest, 1e-300)))))
