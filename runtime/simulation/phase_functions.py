"""The phases of a motion, and affine functions of the state along them in closed form."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.flows import functions_of, parts_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Panels", "Phases", "fastest", "panels", "phases_of", "values_at"]

_CHUNK = 20_000  # panels whose functions are in memory at a time


@dataclass(frozen=True, eq=False)
class Phases:
    """Parts of a motion between its transitions.

    Attributes
    ----------
    begins, durations : array (P,)
    configurations : array (P,) of int
    starts, ends : array (P, N)
        State at the beginning of each, and at its end in front of the transition.
    """

    begins: np.ndarray
    durations: np.ndarray
    configurations: np.ndarray
    starts: np.ndarray
    ends: np.ndarray


def phases_of(trajectory: Trajectory, since: float = 0.0) -> Phases:
    """Phases of a motion from a time on, the first of them cut there.

    Parameters
    ----------
    trajectory : Trajectory
    since : float
        Time of the cut.

    Returns
    -------
    Phases
        Beginnings and durations (k,), configurations (k,), starts and ends (k, N).

    Raises
    ------
    InputError
        If the time is not between the start and the end of the motion, or the motion takes no
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


class Panels(NamedTuple):
    """Pieces of phases of one configuration, short against its fastest oscillation.

    Attributes
    ----------
    configuration : int
    phases : array (n,) of int
        The phase of each.
    left, right : array (n,)
        Its ends, as times since the beginning of the phase.
    weights : array (n, functions, K)
        Factors of the configuration's functions of time in each affine function.
    constants : array (K,)
        What is added to their sum.
    last : array (n,) of bool
        Whether it ends its phase.
    """

    configuration: int
    phases: np.ndarray
    left: np.ndarray
    right: np.ndarray
    weights: np.ndarray
    constants: np.ndarray
    last: np.ndarray


def panels(
    system: PiecewiseLinear, phases: Phases, rows: np.ndarray, angle: float
) -> Iterator[Panels]:
    """Cut phases into panels of at most an angle, in radians of the fastest oscillation.

    Parameters
    ----------
    system : PiecewiseLinear
    phases : Phases
    rows : array (configurations, K, N + 1)
        Affine functions ``n y + c``: n, then c.
    angle : float

    Yields
    ------
    Panels
        Not too many at a time.
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
    """Largest modulus of the exponents of a configuration.

    Returns
    -------
    float
        One over the unit of time; 0 without exponents.
    """
    exponents = system.exponents[configuration]
    return float(np.hypot(*exponents.T).max()) if len(exponents) else 0.0


def values_at(system: PiecewiseLinear, found: Panels, times: np.ndarray) -> np.ndarray:
    """Affine functions (n, q, K) at times (n, q) since the beginnings of the panels' phases.

    Parameters
    ----------
    system : PiecewiseLinear
    found : Panels
        Weights and constants of the functions on n panels.
    times : array (n, q)

    Returns
    -------
    array (n, q, K)
    """
    functions = functions_of(system, found.configuration, times.ravel())
    shaped = functions.reshape(*times.shape, -1)
    return np.asarray(shaped @ found.weights + found.constants)


def _weights(
    system: PiecewiseLinear, configuration: int, starts: np.ndarray, rows: np.ndarray
) -> np.ndarray:
    """Factors (P, functions, K) of the functions of time in affine functions of the state."""
    parts = parts_of(system, configuration, starts)
    return np.asarray(parts @ rows[configuration, :, :-1].T)
