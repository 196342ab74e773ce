"""What motions settle on, one at each of many parameter points, for charts and sweeps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.outcomes import (
    Outcome,
    attractors_of,
    stretched_outcomes,
)
from nonsmooth.runtime.explore.finding.steady import forcing_turns
from nonsmooth.runtime.explore.finding.stretching import stretching
from nonsmooth.runtime.model.completion import parameter_points
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise_at
from nonsmooth.runtime.simulation.simulate import Trajectories

__all__ = ["EQUILIBRIUM", "PERIODIC", "UNINTERRUPTED", "Settled", "settled", "settled_texts"]

PERIODIC, UNINTERRUPTED, EQUILIBRIUM = 0, 1, 2  # beside the numbers of an Outcome
_RETURN = 1e-6  # in units of the largest size of a state on the cycle
_LEAST = 1e-8  # size of a state in units of the largest


class Settled(NamedTuple):
    """How motions (...) go on.

    Attributes
    ----------
    outcomes : array of int
        PERIODIC, UNINTERRUPTED where that is without a transition, EQUILIBRIUM, or an Outcome.
    lengths : array of int
        Transitions in a period; 0 where there are none.
    periods : array
        NaN where the motion is not periodic.
    """

    outcomes: np.ndarray
    lengths: np.ndarray
    periods: np.ndarray


def settled(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    motions: Trajectories,
    threads: int | None = None,
) -> Settled:
    """What motions (...) settle on at parameters that broadcast to their shape.

    Nothing depends on other motions than the one at a point. Cycles of half of the entries that
    are kept are looked for.
    """
    shape, count = motions.status.shape, motions.status.size
    points, given = parameter_points(kernels, parameters)
    places = np.broadcast_to(np.arange(len(points)).reshape(given), shape).ravel()
    flat = motions.reshaped(count)
    scales = _scales(flat.last_states)
    lengths = _lengths(flat, scales)
    times = flat.last_times
    before = np.take_along_axis(times, (times.shape[-1] - 1 - lengths)[:, None], axis=1)[:, 0]
    periods = np.where(lengths > 0, times[:, -1] - before, np.nan)
    outcomes = np.full(count, int(Outcome.UNCLASSIFIED))
    outcomes[flat.status < 0] = Outcome.ILLEGAL
    outcomes[flat.status == Status.OVERFLOW] = Outcome.DIVERGENT
    outcomes[lengths > 0] = PERIODIC
    for place in np.flatnonzero(flat.status == Status.QUIET).tolist():
        here = flat.at([place])
        outcomes[place], periods[place] = _quiet(kernels, points[places[place]], here)
    going = np.flatnonzero((outcomes == Outcome.UNCLASSIFIED) & (flat.status == Status.TRANSITIONS))
    if going.size:
        values = {
            table.name: points[places[going], column]
            for column, table in enumerate(kernels.parameters)
        }
        common = np.ones(going.size, dtype=bool)
        if len(motions.structure.forcing) > 1:
            systems = (piecewise_at(kernels, points[place]) for place in places[going])
            common = np.array([forcing_turns(system) is not None for system in systems])
        measured = stretching(kernels, values, flat.at(going), scales[going], threads)
        outcomes[going] = stretched_outcomes(measured, common)
    return Settled(*(array.reshape(shape) for array in (outcomes, lengths, periods)))


def settled_texts() -> dict[int, str]:
    """The outcomes in words, by their numbers."""
    return {
        PERIODIC: "periodic",
        UNINTERRUPTED: "periodic without a transition",
        EQUILIBRIUM: "at an equilibrium",
        **{int(outcome): outcome.text for outcome in Outcome},
    }


def _quiet(kernels: SystemKernels, point: np.ndarray, motion: Trajectories) -> tuple[int, float]:
    """Outcome and period of a motion that leaves its configuration no more."""
    attractors = attractors_of(kernels, piecewise_at(kernels, point), ())
    label = int(attractors.labels(motion)[0])
    if label < 0:
        return label, np.nan
    if label < len(attractors.orbits):
        return UNINTERRUPTED, float(attractors.orbits[label].period)
    return EQUILIBRIUM, np.nan


def _scales(states: np.ndarray) -> np.ndarray:
    """Largest sizes (n, N) of states (n, k, N), none less than rounding makes of a zero."""
    largest = np.nan_to_num(np.abs(states)).max(axis=1, initial=0.0)
    found = np.maximum(largest, _LEAST * largest.max(axis=1, keepdims=True))
    return np.where(found > 0, found, 1.0)


def _lengths(motions: Trajectories, scales: np.ndarray) -> np.ndarray:
    """After how many transitions the end of each motion came back; 0 where it did not.

    The last cycle repeats the configurations and boundaries of the one before.
    """
    configurations, sets = motions.last_configurations, motions.last_sets
    states, kept = motions.last_states, motions.last_times.shape[1]
    found = np.zeros(len(motions.status), dtype=int)
    for length in range(1, (kept - 1) // 2 + 1):
        last, before = slice(kept - length, kept), slice(kept - 2 * length, kept - length)
        same = (configurations[:, last] == configurations[:, before]).all(axis=1)
        same &= (sets[:, last] == sets[:, before]).all(axis=1)
        same &= configurations[:, kept - 2 * length - 1] >= 0
        with np.errstate(invalid="ignore"):
            miss = np.abs(states[:, -1] - states[:, -1 - length]) / scales
        same &= (miss <= _RETURN).all(axis=1) & (found == 0)
        found[same & (motions.status == Status.TRANSITIONS)] = length
    return found
