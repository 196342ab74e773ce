"""Recurrent motions: the phases after which an entry of a motion comes back, as its last cycle.

An entry is what `simulate_many` keeps: the configuration behind a transition, the set of
boundaries that led there, the state and the time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.values import real_number
from nonsmooth.runtime.model.boundary_sets import names_of, numbered
from nonsmooth.runtime.model.flows import extended
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.trajectory import Trajectory

_EXAMPLES = 20  # of near returns by one cycle

_LEAST = 1e-5  # scale of a state in units of the largest of its kind: well above rounding
_ZERO = 1e-8  # size of a state, in the same units
_TOLERANCES = (1e-10, 1e-7, 1e-4, 1e-2)  # of a return: the tightest that finds one decides
_SETTLING = 1e-3  # of a part's miss: a whole that misses less is a cycle of its own
_EXACT = 1e-10  # of a part's miss: it is repeated
_NEAR = 0.05  # relative difference of a cycle's duration from the period that was asked for

Itinerary = tuple[tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class Candidate:
    """A cycle of p phases that a motion went through, as a guess of a periodic orbit."""

    itinerary: Itinerary  # rotated so that equal cycles are equal tuples
    dwell_times: np.ndarray  # (p,)
    state: np.ndarray  # (N,) at the start of the first phase
    miss: float  # how far the motion was from coming back, relative to its size


def canonical(itinerary: Itinerary) -> int:
    """Number of phases to rotate a cycle by so that it comes first in the alphabet."""
    return min(range(len(itinerary)), key=lambda i: itinerary[i:] + itinerary[:i])


def recurrent_lengths(motions: Trajectories, scales: np.ndarray, tolerance: float) -> np.ndarray:
    """Numbers (n,) of transitions after which n motions came back to their last entry, or 0.

    The whole last cycle repeats the configurations and boundaries of the one before. It
    lasts as long, within the relative `tolerance`, and each state comes back within that
    times its scale (n, N). Impacts that follow each other ever faster come back in all but
    the time, and are no cycle.
    """
    count, kept = motions.last_times.shape
    configurations, sets, states = (
        motions.last_configurations,
        motions.last_sets,
        motions.last_states,
    )
    found, times = np.zeros(count, dtype=int), motions.last_times
    for length in range(1, (kept - 1) // 2 + 1):
        back = slice(kept - 2 * length, kept - length)
        same = (configurations[:, -length:] == configurations[:, back]).all(axis=1)
        same &= (sets[:, -length:] == sets[:, back]).all(axis=1)
        same &= configurations[:, kept - 2 * length - 1] >= 0
        with np.errstate(invalid="ignore"):
            miss = (np.abs(states[:, -1] - states[:, -1 - length]) / scales).max(axis=1)
            last = times[:, -1] - times[:, -1 - length]
            before = times[:, -1 - length] - times[:, -1 - 2 * length]
            same &= np.abs(last - before) <= tolerance * last
        found[(found == 0) & same & (miss <= tolerance)] = length
    return np.asarray(found)


def candidate_at(
    motions: Trajectories, motion: int, end: int, length: int, scale: np.ndarray
) -> Candidate | None:
    """The cycle of `length` phases that entry `end` of a motion closes; None without such entries.

    `scale` (N,) is the size of each state.
    """
    first = end - length
    configurations = motions.last_configurations[motion, first:end].tolist()
    sets = motions.last_sets[motion, first + 1 : end + 1].tolist()
    phases = []
    for configuration, reached in zip(configurations, sets, strict=True):
        name = phase_name(motions.structure, configuration, reached)
        if name is None:
            return None
        phases.append(name)
    itinerary = tuple(phases)
    turn = canonical(itinerary)
    dwell = np.diff(motions.last_times[motion, first : end + 1])
    states = motions.last_states[motion]
    miss = float((np.abs(states[end] - states[first]) / scale).max())
    return Candidate(
        itinerary[turn:] + itinerary[:turn],
        np.roll(dwell, -turn),
        states[first + turn],
        miss,
    )


def near_returns(
    motions: Trajectories, scales: np.ndarray, longest: int, tolerance: float
) -> list[Candidate]:
    """Cycles of at most `longest` phases after which one of n motions nearly came back.

    The largest change of a state, in units of its scale (n, N), is at most `tolerance`. Of
    each itinerary there are a few, those that miss least.
    """
    kept = motions.last_times.shape[1]
    # a phase as a number: its configuration, and the boundaries by which it is left
    phases = motions.last_configurations[:, :-1].astype(np.int64) << 32
    phases |= numbered(motions.last_sets[:, 1:])
    integers = np.iinfo(np.int64)
    factors = np.random.default_rng(0).integers(integers.min, integers.max, (kept,))
    found = []
    for length in range(1, min(longest, kept - 1) + 1):
        ahead, back = slice(length, None), slice(None, kept - length)
        same = motions.last_configurations[:, ahead] == motions.last_configurations[:, back]
        same &= motions.last_sets[:, ahead] == motions.last_sets[:, back]
        same &= motions.last_configurations[:, back] >= 0
        with np.errstate(invalid="ignore"):
            moved = np.abs(motions.last_states[:, ahead] - motions.last_states[:, back])
            moved = moved / scales[:, None]
        miss = moved.max(axis=2)
        same &= miss <= tolerance
        places = np.argwhere(same)
        cycles = sliding_window_view(phases, length, axis=1)[*places.T]
        # equal cycles by a sum of products modulo 2^64: sorting whole rows takes most of the time
        _, groups = np.unique((cycles * factors[:length]).sum(axis=1), return_inverse=True)
        order = np.lexsort((miss[*places.T], groups))
        ranks = np.arange(order.size) - np.searchsorted(groups[order], groups[order])
        for motion, place in places[order[ranks < _EXAMPLES]].tolist():
            candidate = candidate_at(motions, motion, place + length, length, scales[motion])
            if candidate is not None and (candidate.dwell_times > 0).all():
                found.append(candidate)
    return found


def phase_name(structure: Structure, configuration: int, reached: int) -> tuple[str, str] | None:
    """Names of a configuration and of the boundaries that ended its phase, joined by ``+``.

    `reached` has the boundaries as bits. None stands for no configuration (a negative one)
    or no boundary.
    """
    if configuration < 0 or reached <= 0:
        return None
    names = names_of(structure, configuration, reached)
    return structure.configurations[configuration], "+".join(names)


def scales_of(system: PiecewiseLinear, motions: Trajectories) -> np.ndarray:
    """Scale (n, N) of each state of n motions, over the entries that were kept."""
    states, configurations = motions.last_states, motions.last_configurations
    waits = np.diff(motions.last_times, axis=1)[..., None]
    whole = extended(states)
    # by the velocities behind each entry and, in the phase before it, in front of it
    fields = system.fields[configurations[:, :-1]]
    moved = [
        np.einsum("nkij,nkj->nki", fields, whole[:, side]) * waits
        for side in (slice(None, -1), slice(1, None))
    ]
    return variation(motions.structure, states, np.concatenate(moved, axis=1))


def variation(structure: Structure, states: np.ndarray, moved: np.ndarray) -> np.ndarray:
    """Positive scale (..., N) of states (..., k, N), from their range and their changes `moved`.

    A state that is the same at all entries, as the velocity of a mass that only stops and
    goes, has the scale of its changes (..., m, N) between entries. No scale is so small,
    compared to the states of its kind (positions, or velocities), that rounding matters.
    States that are not finite are ignored.
    """
    known = np.isfinite(states)
    highest = np.where(known, states, -np.inf).max(axis=-2, initial=-np.inf)
    lowest = np.where(known, states, np.inf).min(axis=-2, initial=np.inf)
    changes = np.where(np.isfinite(moved), np.abs(moved), 0.0).max(axis=-2, initial=0.0)
    found = np.maximum(np.maximum(highest - lowest, 0.0), changes)
    sizes = np.maximum(found, np.where(known, np.abs(states), 0.0).max(axis=-2, initial=0.0))
    return _none_smaller(structure, found, _LEAST * sizes)


def sizes_of(structure: Structure, states: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Positive sizes (..., N) of states (..., k, N) at times (..., k), none below rounding.

    They are the largest absolute values. A position that is zero at all entries has a size
    that follows from its velocity, and the other way round. States that are not finite are
    ignored.
    """
    found = np.nan_to_num(np.abs(states)).max(axis=-2, initial=0.0)
    waits = np.nan_to_num(np.diff(times)).max(axis=-1, initial=0.0)
    waits = np.where(waits > 0, waits, 1.0)
    least = found.copy()
    for x, v in structure.coordinates:
        least[..., x] = np.maximum(found[..., x], found[..., v] * waits)
        least[..., v] = np.maximum(found[..., v], found[..., x] / waits)
    return _none_smaller(structure, found, _ZERO * least)


def _none_smaller(structure: Structure, sizes: np.ndarray, least: np.ndarray) -> np.ndarray:
    """Sizes (..., N), raised to the largest of `least` (..., N) among the states of their kind.

    The kinds are the positions, the velocities, each forcing, and all else.
    """
    kinds = [[x for x, _ in structure.coordinates], [v for _, v in structure.coordinates]]
    kinds += [list(pair) for pair in structure.forcing]
    known_kinds = {state for kind in kinds for state in kind}
    kinds.append([state for state in range(sizes.shape[-1]) if state not in known_kinds])
    found = sizes.copy()
    for kind in filter(None, kinds):
        largest = least[..., kind].max(axis=-1, keepdims=True)
        found[..., kind] = np.maximum(found[..., kind], np.where(largest > 0, largest, 1.0))
    return np.asarray(found)


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
