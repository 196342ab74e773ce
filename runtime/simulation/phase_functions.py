"""The phases of a motion, and affine functions of the state along them: values and extremes.

On a panel of width h a function lies within M h^4/384 of its cubic Hermite interpolant by values
and slopes at both ends, where |f''''| <= M, and that lies between the least and the largest of its
coefficients in Bernstein form. So the slope of a function has no zero on a panel where these have
one sign, and at most one where those of the curvature have; other panels are halved. An extreme
is at the end of a panel, or it is a local one on a panel whose bound exceeds all ends: no peak
hides.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import accumulate, repeat
from operator import matmul
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.events.crossings_and_maxima import falling_zeros
from nonsmooth.runtime.model.flows import flow_states, functions_of, parts_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import derivative_matrix, function_bounds

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.trajectory import Trajectory

_CHUNK = 100_000  # functions on panels that are in memory at a time
_ANGLE = 0.6  # radians of the fastest oscillation in a panel
_HALVINGS = 40  # then a slope that touches zero is none that crosses it
_ROUNDING = 2.0**-50
_ORDERS = 7  # derivatives from that of order 0


@dataclass(frozen=True, eq=False)
class Phases:
    """The P parts of a motion between its transitions."""

    begins: np.ndarray  # (P,) times
    durations: np.ndarray  # (P,)
    configurations: np.ndarray  # (P,) int
    starts: np.ndarray  # (P, N) states at the beginning
    ends: np.ndarray  # (P, N) states at the end, before the transition


def phases_of(trajectory: Trajectory, since: float = 0.0) -> Phases:
    """Phases of a motion from the time `since` on, at which the first one is cut.

    An `InputError` is raised if that time is outside the motion, or if the motion takes no
    time or is not finite.
    """
    end = trajectory.end
    try:
        begin = float(since)
    except (TypeError, ValueError):
        raise InputError(f"since = {since!r} is not a real number") from None
    if end == 0:
        raise InputError(
            f"the motion ends where it starts, as {trajectory.message}: follow it until a time"
        )
    if not 0 <= begin < end:
        raise InputError(f"since = {begin!r} is not between 0 and the end of the motion, {end!r}")
    if not (math.isfinite(end) and np.isfinite(trajectory.states).all()):
        raise InputError("the motion is not finite")
    times = trajectory.times
    first = int(np.searchsorted(times, begin, side="right")) - 1
    begins, starts = times[first:].copy(), trajectory.states[first:].copy()
    if begins[0] < begin:
        begins[0], starts[0] = begin, trajectory(begin)
    durations = np.diff(begins, append=end)
    ends = np.concatenate([trajectory.before[first + 1 :], trajectory(end)[None]])
    configurations = trajectory.run.configurations[first:].astype(int)
    return Phases(begins, durations, configurations, starts, ends)


def phase_states(
    system: PiecewiseLinear, configurations: np.ndarray, since: np.ndarray, starts: np.ndarray
) -> np.ndarray:
    """States (m, N) of phases in configurations (m,), at times (m,) since their starts (m, N)."""
    states = np.empty_like(starts)
    for configuration in np.unique(configurations).tolist():
        here = configurations == configuration
        states[here] = flow_states(system, configuration, since[here], starts[here])
    return states


class _Panels(NamedTuple):
    """Pieces of phases of one configuration, short against its fastest oscillation.

    K affine functions of the state are, on each, sums of functions of time.
    """

    configuration: int
    phases: np.ndarray  # (n,) index of each one's phase
    left: np.ndarray  # (n,) left ends, as times since the beginning of the phase
    right: np.ndarray  # (n,) right ends
    weights: np.ndarray  # (n, functions, K) factors of the functions of time
    constants: np.ndarray  # (K,) added to the sums
    last: np.ndarray  # (n,) bool: whether it ends its phase


def _panels(system: PiecewiseLinear, phases: Phases, rows: np.ndarray) -> Iterator[_Panels]:
    """Yield the phases cut into panels, not too many at a time.

    `rows` (configurations, K, N + 1) are affine functions ``n y + c``: n, then c.
    """
    most = max(1, _CHUNK // max(1, rows.shape[1]))
    for configuration in np.unique(phases.configurations).tolist():
        here = np.flatnonzero(phases.configurations == configuration)
        durations = phases.durations[here]
        counts = 1 + np.floor(fastest(system, configuration) * durations / _ANGLE).astype(int)
        ends = np.cumsum(counts)
        for low in range(0, int(ends[-1]), most):
            index = np.arange(low, min(low + most, int(ends[-1])))
            which = np.searchsorted(ends, index, side="right")
            used, place = np.unique(which, return_inverse=True)
            parts = parts_of(system, configuration, phases.starts[here[used]])
            part = index - (ends - counts)[which]
            width = durations[which] / counts[which]
            last = part + 1 == counts[which]
            yield _Panels(
                configuration,
                here[which],
                part * width,
                np.where(last, durations[which], (part + 1) * width),
                (parts @ rows[configuration, :, :-1].T)[place],
                rows[configuration, :, -1],
                last,
            )


def fastest(system: PiecewiseLinear, configuration: int) -> float:
    """Largest modulus of a configuration's exponents, per unit of time; 0 without exponents."""
    exponents = system.exponents[configuration]
    return float(np.hypot(*exponents.T).max()) if len(exponents) else 0.0


class Extreme(NamedTuple):
    """An extreme value and a time at which it is attained."""

    value: float
    time: float


class LocalMaximum(NamedTuple):
    """A local maximum inside a phase."""

    phase: int
    function: int  # number of the function
    since: float  # time since the beginning of the phase
    value: float


def local_maxima(system: PiecewiseLinear, phases: Phases, rows: np.ndarray) -> list[LocalMaximum]:
    """All local maxima inside phases of K affine functions of the state.

    `rows` (configurations, K, N + 1) are the functions ``n y + c``: n, then c.
    """
    found: list[LocalMaximum] = []
    for panels in _panels(system, phases, rows):
        every = np.ones((len(panels.phases), rows.shape[1]), dtype=bool)
        places, *parts = _maxima_on(system, panels, every)
        columns = (part.tolist() for part in (panels.phases[places], *parts))
        found += map(LocalMaximum, *columns)
    return found


def boundary_rows(system: PiecewiseLinear) -> np.ndarray:
    """Boundary functions (configurations, K, N + 1); zero behind those of a configuration."""
    boundaries = system.structure.boundaries
    width = max(map(len, boundaries), default=0)
    found = np.zeros((len(boundaries), width, system.rows.shape[1]))
    for configuration, shapes in enumerate(boundaries):
        found[configuration, : len(shapes)] = system.rows[[shape.row for shape in shapes]]
    return found


def extremes(
    system: PiecewiseLinear, phases: Phases, rows: np.ndarray
) -> tuple[list[Extreme], list[Extreme]]:
    """Minima and maxima (K,) of affine functions over all phases.

    The functions `rows` (configurations, K, N + 1) are ``n y + c``: n, then c. The values
    are attained, and no other one exceeds them by more than rounding.
    """
    count = rows.shape[1]
    signed = np.concatenate([-rows, rows], axis=1)
    best = np.full(2 * count, -np.inf)
    times = np.full(2 * count, np.nan)

    def raise_to(values: np.ndarray, at: np.ndarray) -> None:
        np.copyto(times, at, where=values > best)
        np.maximum(best, values, out=best)

    for panels in _panels(system, phases, signed):
        row, begins = signed[panels.configuration], phases.begins[panels.phases]
        tower = _tower(system, panels.configuration, panels.weights.swapaxes(1, 2), 5)
        sides = (panels.left, panels.right)
        left, right = (
            np.einsum("nf,onkf->onk", functions_of(system, panels.configuration, t), tower[:2])
            for t in sides
        )
        sizes = _sizes(system, panels)
        size, fourth = np.einsum("nf,onkf->onk", sizes, abs(tower[::4]))
        slack = _ROUNDING * (size + abs(panels.constants))
        left[0] += panels.constants
        right[0] += panels.constants
        # times are sums: the state in front of a transition is known better than its time
        ends = phases.ends[panels.phases[panels.last]]
        right[0][panels.last] = ends @ row[:, :-1].T + row[:, -1]
        _, upper = _range(left, right, (panels.right - panels.left)[:, None], fourth)
        for values, at in zip((left[0], right[0]), sides, strict=True):
            top = values.argmax(axis=0)
            raise_to(values[top, np.arange(len(best))], (begins + at)[top])
        places, functions, since, values = _maxima_on(system, panels, upper > best + slack)
        order = np.argsort(values)  # of each function the largest one is written last
        highest, when = np.full_like(best, -np.inf), np.full_like(times, np.nan)
        highest[functions[order]] = values[order]
        when[functions[order]] = (begins[places] + since)[order]
        raise_to(highest, when)
    every = [
        Extreme(value, time) for value, time in zip(best.tolist(), times.tolist(), strict=True)
    ]
    return [Extreme(0.0 - value, time) for value, time in every[:count]], every[count:]


def _tower(
    system: PiecewiseLinear, configuration: int, weights: np.ndarray, count: int
) -> np.ndarray:
    """Factors (count, ..., functions) of the derivatives of functions from order 0 on."""
    structure, exponents = system.structure, system.exponents[configuration]
    derivative = derivative_matrix(structure.shapes[configuration], exponents)
    return np.array(list(accumulate(repeat(derivative, count - 1), matmul, initial=weights)))


def _sizes(system: PiecewiseLinear, found: _Panels) -> np.ndarray:
    """Bounds (n, functions) of the absolute values of the functions of time on panels."""
    shapes = system.structure.shapes[found.configuration]
    exponents = system.exponents[found.configuration]
    bounds = function_bounds(shapes, exponents, found.left, found.right)
    return np.stack(np.broadcast_arrays(*bounds), axis=-1)


def _maxima_on(
    system: PiecewiseLinear, panels: _Panels, wanted: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Local maxima on panels of the functions that are wanted there, bool (n, K).

    They are told by panels, functions, times since the beginnings of the phases, and values.
    """
    configuration = panels.configuration
    places, functions = np.nonzero(wanted)
    factors = _tower(system, configuration, panels.weights[places, :, functions], _ORDERS)
    sizes = np.einsum("nf,onf->on", _sizes(system, panels)[places], abs(factors))
    left, right = panels.left[places], panels.right[places]
    at, begins, ends = _brackets(system, configuration, factors, sizes, left, right)
    kept = factors[1:3, at]

    def rates(times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        slope, curvature = np.einsum("nf,onf->on", functions_of(system, configuration, times), kept)
        return slope, curvature

    times = falling_zeros(rates, begins, ends)
    values = (functions_of(system, configuration, times) * factors[0, at]).sum(axis=1)
    return places[at], functions[at], times, values + panels.constants[functions[at]]


def _brackets(
    system: PiecewiseLinear,
    configuration: int,
    factors: np.ndarray,
    sizes: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Functions on panels whose slope falls through zero once, and intervals around the zero.

    `factors` (7, n, functions) are those of their derivatives, `sizes` (7, n) bounds on these.
    """
    # where a function is constant or has one slope, rounding alone gives it maxima
    places = np.flatnonzero(sizes[1] > 0)
    left, right = low[places], high[places]
    kept: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for turn in range(_HALVINGS + 1):
        if not places.size:
            break
        width, size = right - left, sizes[:, places]
        ends = [
            np.einsum("nf,onf->on", functions_of(system, configuration, t), factors[1:4, places])
            for t in (left, right)
        ]
        least, most = _range(ends[0][:2], ends[1][:2], width, size[5])
        slack = _ROUNDING * size[1]
        flat = (most <= slack) & (least >= -slack)
        crossing = ~flat & (least <= slack) & (most >= -slack)
        bent = _range(ends[0][1:], ends[1][1:], width, size[6])
        slack = _ROUNDING * size[2]
        single = (bent[1] < -slack) | (bent[0] > slack) | (turn == _HALVINGS)
        falls = crossing & single & (ends[0][0] > 0) & (ends[1][0] <= 0)
        kept.append((places[falls], left[falls], right[falls]))
        rest = crossing & ~single
        places, left, right = places[rest], left[rest], right[rest]
        middle = (left + right) / 2
        places = np.concatenate([places, places])
        left, right = np.concatenate([left, middle]), np.concatenate([middle, right])
    if not kept:
        return places, left, right
    first, second, third = (np.concatenate(part) for part in zip(*kept, strict=True))
    return first, second, third


def _range(
    left: np.ndarray, right: np.ndarray, width: np.ndarray, fourth: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Bounds (n, ...) of functions on panels, from values and slopes (2, n, ...) at their ends."""
    (f, slope), (g, slope_end) = left, right
    controls = np.array([f, f + width * slope / 3, g - width * slope_end / 3, g])
    missed = fourth * width**4 / 384
    return controls.min(axis=0) - missed, controls.max(axis=0) + missed
