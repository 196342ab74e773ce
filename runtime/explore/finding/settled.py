"""What motions settle on, one at each of many parameter points, for charts and sweeps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import compress
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.escape import pursue
from nonsmooth.runtime.explore.finding.outcomes import (
    Outcome,
    attractors_of,
    labels_of_ends,
    pursued_outcomes,
)
from nonsmooth.runtime.explore.finding.stroboscope import stroboscopic_returns
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.parameter_batches import parameter_points
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    piecewise_at,
)
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.recurrence import recurrent_lengths, sizes_of

__all__ = ["EQUILIBRIUM", "PERIODIC", "UNINTERRUPTED", "Settled", "settled", "settled_texts"]

PERIODIC, UNINTERRUPTED, EQUILIBRIUM = 0, 1, 2  # beside the numbers of an Outcome
_RETURN = 1e-6  # in units of the largest size of a state on the cycle


class Settled(NamedTuple):
    """What motions (...) settle on."""

    # PERIODIC, UNINTERRUPTED (periodic without a transition), EQUILIBRIUM, or an `Outcome`
    outcomes: np.ndarray
    lengths: np.ndarray  # transitions in a period, 0 where there are none
    periods: np.ndarray  # NaN where the motion is not periodic


def settled(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    motions: Trajectories,
    threads: int | None = None,
) -> Settled:
    """What motions (...) settle on, at parameters that broadcast to their shape.

    The result at a point depends on the motion there alone. Cycles of up to half of the entries
    that are kept are recognised. `threads` None takes all processors.
    """
    shape, count = motions.status.shape, motions.status.size
    points, given = parameter_points(kernels, parameters)
    places = np.broadcast_to(np.arange(len(points)).reshape(given), shape).ravel()
    flat = motions.reshaped(count)
    found = _returned(flat, flat.last_states)
    rest = np.flatnonzero(
        (found.outcomes == Outcome.UNCLASSIFIED)
        & ((flat.status == Status.TRANSITIONS) | (flat.status == Status.QUIET))
    )
    systems = [piecewise_at(kernels, points[place]) for place in places[rest]]
    first = _arrived(kernels, systems, flat.at(rest))
    _put(found, rest, first)
    goes_on = (first.outcomes == Outcome.UNCLASSIFIED) & (flat.status[rest] == Status.TRANSITIONS)
    going = rest[goes_on]
    if going.size:
        here = list(compress(systems, goes_on))
        pursued = pursue(kernels, here, flat.at(going), threads)
        later = _arrived(kernels, here, pursued.motions)
        returns = stroboscopic_returns(kernels, here, pursued.motions, threads)
        back = (later.outcomes == Outcome.UNCLASSIFIED) & (returns.lengths > 0)
        later.outcomes[back] = PERIODIC
        later.lengths[back], later.periods[back] = returns.lengths[back], returns.periods[back]
        told = pursued_outcomes(kernels, here, pursued, later.outcomes, threads)
        _put(found, going, later._replace(outcomes=told))
    return Settled(*(array.reshape(shape) for array in found))


def settled_texts() -> dict[int, str]:
    """The outcomes in words, by their numbers."""
    return {
        PERIODIC: "periodic",
        UNINTERRUPTED: "periodic without a transition",
        EQUILIBRIUM: "at an equilibrium",
        **{int(outcome): outcome.text for outcome in Outcome},
    }


def _put(found: Settled, places: np.ndarray, others: Settled) -> None:
    for array, other in zip(found, others, strict=True):
        array[places] = other


def _arrived(
    kernels: SystemKernels, systems: Sequence[PiecewiseLinear], motions: Trajectories
) -> Settled:
    """What motions (n,) of as many systems have settled on, up to translations."""
    states = motions.last_states.copy()
    for place, system in enumerate(systems):
        states[place] = up_to_shift(states[place], translations_of(system))
    found = _returned(motions, states)
    for place in np.flatnonzero(motions.status == Status.QUIET).tolist():
        attractors = attractors_of(kernels, systems[place], ())
        label = int(attractors.labels(motions.at([place]))[0])
        if label >= len(attractors.orbits):
            found.outcomes[place] = EQUILIBRIUM
        elif label >= 0:
            found.outcomes[place] = UNINTERRUPTED
            found.periods[place] = attractors.orbits[label].period
        else:
            found.outcomes[place] = label
    return found


def _returned(motions: Trajectories, states: np.ndarray) -> Settled:
    """The motions (n,) that came back, according to their states (n, k, N) at the entries."""
    seen = replace(motions, last_states=states)
    lengths = recurrent_lengths(
        seen, sizes_of(motions.structure, states, motions.last_times), _RETURN
    )
    lengths[motions.status != Status.TRANSITIONS] = 0
    times = motions.last_times
    before = np.take_along_axis(times, (times.shape[-1] - 1 - lengths)[:, None], axis=1)[:, 0]
    outcomes = labels_of_ends(motions)
    outcomes[lengths > 0] = PERIODIC
    return Settled(outcomes, lengths, np.where(lengths > 0, times[:, -1] - before, np.nan))
