"""The cycle at the end of a simulated motion, as a guess of a periodic orbit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.values import real_number
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.recurrence import recurrent_lengths, scales_of
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Recurrence", "itinerary_of"]

_TOLERANCES = (1e-10, 1e-7, 1e-4, 1e-2)  # of a return: the tightest that finds one decides
_SETTLING = 1e-3  # of a part's miss: a whole that misses less is a cycle of its own
_EXACT = 1e-10  # of a part's miss: it is repeated
_NEAR = 0.05  # relative difference of a cycle's duration from the period that was asked for


class Recurrence(NamedTuple):
    """A cycle that a motion went through: ``solve(system, parameters, itinerary=recurrence)``.

    Attributes
    ----------
    itinerary : tuple of (configuration, boundary)
        Boundaries that were reached together are joined, ``"a+b"``.
    dwell_times : array (p,)
    start : array (N,)
        State at the start of the first phase.
    """

    itinerary: tuple[tuple[str, str], ...]
    dwell_times: np.ndarray
    start: np.ndarray

    def __repr__(self) -> str:
        text: str = registered("result_text")(self)
        return text

    def _repr_html_(self) -> str:
        text: str = registered("result_html")(self)
        return text


def itinerary_of(
    trajectory: Trajectory, since: float = 0.0, period: float | None = None
) -> Recurrence:
    """Find the shortest cycle that a motion repeats at its end.

    The last cycle goes through the same configurations and boundaries as the one before it,
    and its end comes back to its start; without a period within a hundredth of the motion's
    size.

    Parameters
    ----------
    trajectory : Trajectory
    since : float
        What the motion did before is not looked at.
    period : float, optional
        About how long the cycle lasts: the cycle of nearly this duration that comes back best
        is taken, though it may not have been repeated.

    Returns
    -------
    Recurrence
        Itinerary, dwell times, state and period of the cycle; `compose` takes its entries.

    Raises
    ------
    InputError
        If the motion does not come back, comes back through a phase that takes no time, or
        for a time or period that is none.

    Examples
    --------
    >>> from nonsmooth.runtime.orbits.solve import solve
    >>> from nonsmooth.runtime.simulation.simulate import simulate
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> motion = simulate("dry-friction", data, [0, 0, 0, 0], transitions=400)
    >>> recurrence = itinerary_of(motion)
    >>> solve("dry-friction", data, itinerary=recurrence).converged
    True
    """
    since = real_number("since", since)
    period = None if period is None else real_number("period", period)
    if not 0 <= since <= trajectory.end:
        raise InputError(
            f"since = {since!r} is not between 0 and the end of the motion, {trajectory.end!r}"
        )
    if period is not None and not 0 < period < np.inf:
        raise InputError(f"period = {period!r} is not positive and finite")
    trajectory = _up_to_shift(trajectory)
    first = int(np.searchsorted(trajectory.times, since))
    length = _repeated(trajectory, first) if period is None else _near(trajectory, first, period)
    part = _prime(trajectory, length) if period is None and length else length
    if length == 0:
        told = "" if period is None else f" after about {period:.6g}"
        raise InputError(
            f"{trajectory.name}: from time {since:.6g} on, within"
            f" {trajectory.transitions - first + 1} transitions, the motion does not come"
            f" back{told}: follow it longer, or say about after which period it comes back"
        )
    return _cycle(trajectory, length, part)


def _up_to_shift(trajectory: Trajectory) -> Trajectory:
    """The motion without its part along the translations that leave its system unchanged."""
    states = up_to_shift(trajectory.run.states, translations_of(trajectory.system))
    return replace(trajectory, run=replace(trajectory.run, states=states))


def _repeated(trajectory: Trajectory, first: int) -> int:
    """Number of phases of the shortest cycle at the end; 0 if there is none."""
    motions = _since(trajectory, first)
    if motions.last_times.shape[1] < 3:
        return 0
    scales = scales_of(trajectory.system, motions)
    for tolerance in _TOLERANCES:
        length = int(recurrent_lengths(motions, scales, tolerance)[0])
        if length:
            return length
    return 0


def _since(trajectory: Trajectory, first: int) -> Trajectories:
    """The end of a motion from entry `first` on, as the only motion of a `Trajectories`."""
    run = trajectory.run
    return Trajectories(
        trajectory.structure,
        run.times[-1:],
        run.states[-1:],
        run.configurations[-1:],
        np.array([len(run.times) - 1]),
        np.array([0]),
        np.array([int(run.status)]),
        run.times[None, first:],
        run.configurations[None, first:],
        run.sets[None, first:],
        run.states[None, first:],
    )


def _prime(trajectory: Trajectory, length: int) -> int:
    """Number of phases of the shorter cycle that the last `length` phases repeat, if there is one.

    It is `length` unless the motion settles on the shorter cycle. Near a multiplier of -1 a
    motion comes back closer after two turns than after one. It settles on one turn if two
    turns miss not far less than one does.
    """
    run = trajectory.run
    (scale,) = scales_of(trajectory.system, _since(trajectory, len(run.times) - 1 - 2 * length))

    def missed(back: int) -> float:
        return float((np.abs(run.states[-1] - run.states[-1 - back]) / scale).max())

    phases = np.stack([run.configurations[:-1], run.sets[1:]])[:, -length:]
    for part in range(1, length // 2 + 1):
        if length % part or (phases != np.roll(phases, part, axis=1)).any():
            continue
        if missed(part) <= _EXACT or missed(length) > _SETTLING * missed(part):
            return part
    return length


def _near(trajectory: Trajectory, first: int, period: float) -> int:
    """Number of phases of the cycle at the end that lasts about `period` and misses least."""
    run = trajectory.run
    durations = run.times[-1] - run.times[first:]
    (scale,) = scales_of(trajectory.system, _since(trajectory, first))
    miss = (np.abs(run.states[first:] - run.states[-1]) / scale).max(axis=1)
    # the same configuration, entered by the same boundaries, which the start of a motion lacks
    fits = (run.configurations[first:] == run.configurations[-1]) & (
        run.sets[first:] == run.sets[-1]
    )
    fits &= np.abs(durations - period) <= _NEAR * period
    if not fits.any():
        return 0
    place = int(np.argmin(np.where(fits, miss, np.inf)))
    return len(run.times) - 1 - (first + place)


def _cycle(trajectory: Trajectory, length: int, part: int) -> Recurrence:
    """The last `length` phases as a cycle; if they repeat `part` phases, the mean of the turns."""
    begin = len(trajectory.times) - 1 - length
    names = zip(
        trajectory.configurations[begin:-1], trajectory.boundaries[begin + 1 :], strict=True
    )
    itinerary = tuple((name, "+".join(reached)) for name, reached in names)
    dwell = np.diff(trajectory.times[begin:])
    for place, time in enumerate(dwell.tolist()):
        if not time > 0:
            raise InputError(f"{trajectory.name}: {_timeless(itinerary, place)}")
    starts = trajectory.states[begin:-1:part]
    return Recurrence(
        itinerary[:part], dwell.reshape(-1, part).mean(axis=0), np.asarray(starts.mean(axis=0))
    )


def _timeless(itinerary: Sequence[tuple[str, str]], place: int) -> str:
    """Explain in words why the phase at `place` of a cycle takes no time."""
    phase, after = itinerary[place], itinerary[(place + 1) % len(itinerary)]
    before = itinerary[place - 1]
    if before == phase:
        return (
            f"the motion chatters: in {phase[0]} it crosses {phase[1]} infinitely often in a"
            " finite time, and an orbit has finitely many phases; observe or sweep it"
        )
    if before[0] == after[0]:
        return (
            f"the motion slides: {phase[0]} and {after[0]} send it back to each other at one"
            f" instant, by {phase[1]} and {after[1]}; a motion held on a surface is declared with"
            " Friction"
        )
    return (
        f"the motion leaves {phase[0]} by {phase[1]} as soon as it enters: no periodic orbit is"
        " composed with a phase that takes no time"
    )
