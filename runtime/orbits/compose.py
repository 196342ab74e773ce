"""Periodic orbits of any itinerary of a system, composed from its flows at run time.

No kernels are generated for the itinerary: the numbers of the system's configurations,
boundaries and transitions are enough. Coordinates are physical, positions before velocities.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.compose_many import ComposedOrbits, compose_many
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.orbits.orbit import DOUBLE
from nonsmooth.runtime.orbits.refine import MOST_DIGITS
from nonsmooth.runtime.orbits.routes import with_routes, with_routes_at
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

__all__ = ["ComposedOrbit", "ComposedOrbits", "compose", "compose_many"]

_ROUNDING = 16 * float(np.finfo(float).eps)  # of one phase, in units of the states' sizes


def compose(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    guess_dwell_times: Sequence[float],
    guess_state: Sequence[float] | None = None,
    digits: int = DOUBLE,
    period: object = None,
    symmetry: Mapping[str, str] | Any = None,
) -> ComposedOrbit:
    """Find the periodic orbit of an itinerary near a guess.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters of the system.
    itinerary : sequence of (configuration, boundary)
        Cyclic: the last phase leads back to the first. Boundaries that are reached together
        are ``"a+b"`` or a sequence of names: the first one's switching condition is solved,
        and admissibility asks for the others'.
    guess_dwell_times : sequence of float
        One for each phase of the itinerary.
    guess_state : sequence of float, optional
        At the start of the first phase; without it the one that fits the dwell times best.
    digits : int
        True decimal digits; above 15 with mpmath.
    period : str, number or Value, optional
        What the dwell times have to sum up to: it singles out one of a family of orbits, as
        there is where energy is kept.
    symmetry : mapping of state to text, or array (N, N), optional
        A signed permutation of the states that maps motions to motions, such as
        ``{"x": "-x", "v": "-v"}``. The itinerary is then that of the first part of the orbit,
        half of it where the symmetry is its own inverse: the symmetry maps the state behind
        its last transition to the start. The orbit that is returned is the whole one.

    Returns
    -------
    ComposedOrbit
        Its `status` says whether it is one.

    Raises
    ------
    InputError
        For wrong names, values or numbers of guesses, an itinerary that the system does not
        allow, or what is no symmetry of the system at these parameters.
    NoConvergence
        If the orbit in double precision cannot be refined.

    Examples
    --------
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> phases = [
    ...     ("stick-stick", "first-breaks-forward"),
    ...     ("slip-stick", "second-breaks-forward"),
    ...     ("slip-slip", "first-reaches-belt"),
    ...     ("stick-slip", "second-reaches-belt"),
    ... ]
    >>> orbit = compose("dry-friction", data, phases, [1, 2, 1.5, 3.3])
    >>> orbit.stability.verdict, orbit.admissibility.verdict
    ('stable', True)
    """
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MOST_DIGITS:
        raise InputError(f"digits = {digits} is not an integer from 1 to {MOST_DIGITS}")
    kernels, mirror = kernels_of(system), None
    phases = itinerary
    if symmetry is not None:
        declared = piecewise(kernels, parameters)
        mirror = symmetry_of(declared, symmetry)
        phases = whole_itinerary(declared.structure, mirror, itinerary)
    kernels = with_routes(kernels, phases)
    point = piecewise(kernels, parameters)
    structure = point.structure
    if mirror is None:
        cycle = cycle_of(structure, itinerary)
    else:
        cycle = whole_cycle(point, mirror, itinerary)
    closed, part = closing(point, cycle, mirror)
    dwell = guesses("guess_dwell_times", guess_dwell_times, len(part), positive=True)
    start, directions = None, translations_of(point)
    if guess_state is not None:
        start = guesses("guess_state", guess_state, len(structure.states)).reshape(1, -1)
        start = up_to_shift(start, directions)
    wanted = None if period is None else as_value(period)
    length = np.nan if wanted is None else float(wanted)
    if wanted is not None and not 0 < length < np.inf:
        raise InputError(f"period = {wanted} is not positive and finite")
    if wanted is not None and mirror is not None:
        length = float(part_of(wanted, mirror.order))
    found = solve_cycle(
        part, numbers_of(closed)[None], dwell.reshape(1, -1), start, np.array([length])
    )
    found.starts[0, 0] = up_to_shift(found.starts[0, 0], directions)
    part_of_it = found.dwell[0], found.starts[0]
    times, states = whole_orbit(point, cycle, mirror, *part_of_it, np)
    kernels = with_routes_at(kernels, point, cycle.itinerary, times, states)
    orbit = ComposedOrbit(
        kernels.name,
        cycle.itinerary,
        point.parameters,
        times,
        states,
        wanted,
        float(found.residual[0]),
        _digits(part, closed, found, length),
        int(found.iterations[0]),
        int(found.status[0]),
        kernels,
        mirror,
    )
    if digits <= DOUBLE or not orbit.converged:
        return orbit
    return orbit.refined(digits)


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
