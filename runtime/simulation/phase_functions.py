"""The phases of a motion, and affine functions of the state along them in closed form."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.flows import flow_states, functions_of, parts_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Panels", "Phases", "fastest", "panels", "phase_states", "phases_of", "values_at"]

_CHUNK = 20_000  # panels whose functions are in memory at a time


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


class Panels(NamedTuple):
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

    def at(self, places: np.ndarray) -> Panels:
        """Those panels at some places (m,)."""
        phases, left, right = self.phases[places], self.left[places], self.right[places]
        weights, last = self.weights[places], self.last[places]
        return Panels(self.configuration, phases, left, right, weights, self.constants, last)


def panels(
    system: PiecewiseLinear, phases: Phases, rows: np.ndarray, angle: float
) -> Iterator[Panels]:
    """Yield the phases cut into panels, not too many at a time.

    Each spans at most `angle` radians of the fastest oscillation. `rows` (configurations,
    K, N + 1) are affine functions ``n y + c``: n, then c.
    """
    for configuration in np.unique(phases.configurations).tolist():
        here = np.flatnonzero(phases.configurations == configuration)
        durations = phases.durations[here]
        counts = 1 + np.floor(fastest(system, configuration) * durations / angle).astype(int)
        ends = np.cumsum(counts)
        for low in range(0, int(ends[-1]), _CHUNK):
            index = np.arange(low, min(low + _CHUNK, int(ends[-1])))
            which = np.searchsorted(ends, index, side="right")
            used, place = np.unique(which, return_inverse=True)
            weights = _weights(system, configuration, phases.starts[here[used]], rows)
            part = index - (ends - counts)[which]
            width = durations[which] / counts[which]
            last = part + 1 == counts[which]
            yield Panels(
                configuration,
                here[which],
                part * width,
                np.where(last, durations[which], (part + 1) * width),
                weights[place],
                rows[configuration, :, -1],
                last,
            )


def fastest(system: PiecewiseLinear, configuration: int) -> float:
    """Largest modulus of a configuration's exponents, per unit of time; 0 without exponents."""
    exponents = system.exponents[configuration]
    return float(np.hypot(*exponents.T).max()) if len(exponents) else 0.0


def values_at(system: PiecewiseLinear, found: Panels, times: np.ndarray) -> np.ndarray:
    """Values (n, q, K) of the functions on n panels, at times (n, q).

    The times count from the beginnings of the panels' phases.
    """
    functions = functions_of(system, found.configuration, times.ravel())
    shaped = functions.reshape(*times.shape, -1)
    return np.asarray(shaped @ found.weights + found.constants)


def _weights(
    system: PiecewiseLinear, configuration: int, starts: np.ndarray, rows: np.ndarray
) -> np.ndarray:
    """Factors (P, functions, K) of the functions of time in affine functions, along P phases."""
    parts = parts_of(system, configuration, starts)
    return np.asarray(parts @ rows[configuration, :, :-1].T)
