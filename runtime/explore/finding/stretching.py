"""How fast neighbouring motions part, for many motions at once: their largest exponents.

Two motions that begin next to each other are followed transition by transition; what parts them
is scaled back again and again (Benettin et al., Meccanica 15, 1980). States behind the same
transition lie on one section, so that the direction of the motion does not count.

`nonsmooth.runtime.simulation.lyapunov` carries derivatives along a single motion instead: exact,
with the whole spectrum, thirty times slower, and only where there are derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.simulate import simulate_many

__all__ = ["Stretching", "stretching"]

_APART = 1e-10  # in units of the scales
_BLOCK, _BLOCKS = 16, 52  # transitions from one scaling to the next, and how many there are
_TURNING = _BLOCKS // 4  # blocks in which what parts the motions turns to its direction
_LOST = 1e-15  # of the scales: below, nothing is left that parts them
_PARTS = 8  # of a motion that settles, from each to the next
_ROUNDING = 1e-9


class Stretching(NamedTuple):
    """Largest exponents (n,) of motions, and their standard errors, in units of one over time.

    The exponent is NaN where a motion ends or still settles, or its neighbour goes another way.
    An error is at least that of a single stretching by e.
    """

    exponents: np.ndarray
    errors: np.ndarray


def stretching(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    motions: Trajectories,
    scales: np.ndarray,
    threads: int | None = None,
) -> Stretching:
    """Largest exponents of motions (n,), each of which is followed beside a neighbour.

    At least the last three entries of the motions have to be kept. `parameters` are numbers or
    arrays (n,), `scales` (n, N) are those of the states; `threads` None takes all processors.
    """
    count = len(motions.times)
    growths, lengths = np.full((_BLOCKS, count), np.nan), np.zeros((_BLOCKS, count))
    highest, lowest = np.zeros((2, _BLOCKS, *scales.shape))

    def follow(states: np.ndarray, configurations: np.ndarray, **ends: Any) -> Trajectories:
        here = {n: value[going] if np.ndim(value) else value for n, value in parameters.items()}
        return simulate_many(kernels, here, states, configurations, threads=threads, **ends)

    # inside the last phase but one, where any small change that its constraints allow is one
    configurations = motions.last_configurations[:, -2]
    halves = np.diff(motions.last_times[:, -2:], axis=1)[:, 0] / 2
    change = _changes(motions, scales)
    usable = (motions.status == Status.TRANSITIONS) & (halves > 0)
    going = np.flatnonzero(usable & np.isfinite(change).all(axis=1))
    entries = motions.last_states[going, -2]
    middle = follow(entries, configurations[going], until=halves[going]).states
    now = np.stack([middle, middle + _APART * change[going]])
    where = np.stack([configurations[going]] * 2)
    for block in range(_BLOCKS):
        ends = follow(now, where, transitions=_BLOCK, keep=_BLOCK)
        apart = (ends.states[1] - ends.states[0]) / scales[going]
        distance = np.abs(apart).max(axis=1)
        together = (ends.status == Status.TRANSITIONS).all(axis=0) & np.isfinite(distance)
        together &= ends.configurations[0] == ends.configurations[1]
        together &= ends.last_sets[0, :, -1] == ends.last_sets[1, :, -1]
        growths[block, going] = np.log(np.maximum(distance, _LOST) / _APART)
        lengths[block, going] = ends.times[0]
        highest[block, going] = ends.last_states[0].max(axis=1)
        lowest[block, going] = ends.last_states[0].min(axis=1)
        growths[block:, going[~together]] = np.nan
        back = np.where(distance > _LOST, _APART / np.maximum(distance, _LOST), 1.0)
        nearer = ends.states[0] + apart * back[:, None] * scales[going]
        _as_strong(nearer, ends.states[0], motions.structure.forcing)
        now = np.stack([ends.states[0], nearer])[:, together]
        going, where = going[together], ends.configurations[:, together]
        if not going.size:
            break
    return _measured(growths[_TURNING:], lengths[_TURNING:], (highest - lowest) / scales)


def _as_strong(states: np.ndarray, others: np.ndarray, forcing: Sequence[tuple[int, int]]) -> None:
    """Give each forcing in states (n, N) the amplitude that it has in `others`.

    A rounding error of it would neither grow nor decay, and outlast what decays.
    """
    for pair in map(list, forcing):
        sizes = np.hypot(*others[:, pair].T) / np.hypot(*states[:, pair].T)
        states[:, pair] *= sizes[:, None]


def _measured(growths: np.ndarray, lengths: np.ndarray, ranges: np.ndarray) -> Stretching:
    """Exponents from growths and lengths (blocks, n); NaN where ranges (blocks, n, N) shrink.

    Ranges are in units of the scales; below the distance of neighbours they are rounding.
    """
    whole, blocks = lengths.sum(axis=0), len(growths)
    whole = np.where(whole > 0, whole, np.nan)
    spread = growths.std(axis=0, ddof=1) * np.sqrt(blocks)
    parts = np.stack([part.max(axis=0) for part in np.array_split(ranges, _PARTS)])
    shrinks = (np.diff(parts, axis=0) < 0).all(axis=0)
    shrinks &= (parts[-1] < (1 - _ROUNDING) * parts[0]) & (parts[0] > _APART)
    exponents = np.where(shrinks.any(axis=1), np.nan, growths.sum(axis=0) / whole)
    return Stretching(exponents, np.maximum(spread, 1.0) / whole)


def _changes(motions: Trajectories, scales: np.ndarray) -> np.ndarray:
    """Directions (n, N) of length 1 that the constraints of the last phase but one allow.

    They lead from one state to another at which the same configuration is entered; the forcing
    stays. They are NaN without another such state.
    """
    configurations, states = motions.last_configurations, motions.last_states
    other = np.argmax(configurations[:, :-2] == configurations[:, [-2]], axis=1)
    found = states[np.arange(len(states)), other] - states[:, -2]
    found[:, [state for pair in motions.structure.forcing for state in pair]] = 0.0
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(found / np.abs(found / scales).max(axis=1, keepdims=True))
