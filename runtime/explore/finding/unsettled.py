"""What becomes of motions that settle on nothing that is known: they are followed further.

Motions escape that grow far out, in units of the size that boundaries, loads and forcing give a
system: there only its homogeneous part counts, and what escapes grows in proportion to time, or
exponentially. A motion that leaves an unstable orbit or equilibrium grows to that size and no
further, and one that builds up to a response grows less and less.

A motion may come back with the forcing, as a stroboscope sees it, by however many transitions:
where impacts follow each other ever faster, until a mass rests at its stop, no cycle of transitions
is short, nor the same in every period.

Else it counts how fast neighbours part. Two motions that begin next to each other are followed
transition by transition; what parts them is scaled back again and again (Benettin et al., Meccanica
15, 1980). States behind the same transition lie on one section, so that the direction of the motion
does not count. `nonsmooth.runtime.simulation.lyapunov` carries derivatives along a single motion
instead: exact, with the whole spectrum, thirty times slower, and only where there are derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.steady import forcing_period
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.recurrence import sizes_of
from nonsmooth.runtime.simulation.simulate import simulate_many

_ENDURING = 4096  # transitions for which every motion is followed on, at least
_FOLLOWED = 5  # in which a motion that grows is followed on, each as long as all before
_STEADY = 3  # of them, one after the other, in which what escapes grows steadily
_PROPORTIONAL = 0.975  # growth by that in proportion to time
_FAR = 100.0  # natural sizes
_GROWTH = 1.05  # by the largest size so far: no more is none
_SINGULAR = 1e-10  # relative singular value of a field that has no equilibrium
_APART = 1e-10  # in units of the scales
_BLOCK, _BLOCKS = 16, 52  # transitions from one scaling to the next, and how many there are
_TURNING = _BLOCKS // 4  # blocks in which what parts the motions turns to its direction
_LOST = 1e-15  # of the scales: below, nothing is left that parts them
_PARTS = 8  # of a motion that settles, from each to the next
_ROUNDING = 1e-9
_FLASHES = 12  # the longest motion that comes back, in common periods of the forcings
_MOST = 2048  # transitions from one flash to the next
_ASIDE = 0.3819660112501051  # of a period, from the last transition to the first flash
_RETURN = 1e-6  # in units of the largest size of a state


class Returns(NamedTuple):
    """Transitions (n,) in a period, and periods; 0 and NaN where a motion does not come back."""

    lengths: np.ndarray
    periods: np.ndarray


class Pursued(NamedTuple):
    """Motions (n,) after a longer simulation, with masks (n,) of escaping and undecided ones.

    A motion is undecided if it still grows, but not as one that escapes.
    """

    motions: Trajectories
    escapes: np.ndarray
    undecided: np.ndarray
    returns: Returns  # after some periods of the forcing


def pursue(
    kernels: SystemKernels,
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None = None,
) -> Pursued:
    """Motions (n,) of as many systems, followed for at least as many transitions again.

    They are followed further as long as they grow. They have to have ended after a number of
    transitions that is the same for all. `threads` None takes all processors.
    """
    count, kept = motions.last_times.shape
    values = numbers_of(systems)
    far = _FAR * np.array([natural_size(each) for each in systems])
    largest, steady = _sizes(systems, motions), np.zeros(count, dtype=int)
    escapes, going = np.zeros(count, dtype=bool), np.arange(count)
    total, length = int(motions.transitions.max(initial=0)), _ENDURING
    for _ in range(_FOLLOWED):
        length = max(length, total)
        later = simulate_many(
            kernels,
            _numbers_at(values, going),
            motions.last_states[going, -1],
            motions.last_configurations[going, -1],
            transitions=length,
            keep=kept,
            threads=threads,
        )
        motions = _replaced(motions, going, later)
        sizes = _sizes([systems[place] for place in going.tolist()], later)
        goes_on = later.status == Status.TRANSITIONS
        ratios = sizes / np.where(largest[going] > 0, largest[going], 1.0)
        in_proportion = ratios * total >= _PROPORTIONAL * (total + length)
        steady[going] = np.where(in_proportion, steady[going] + 1, 0)
        escapes[going] = goes_on & (steady[going] >= _STEADY) & (sizes >= far[going])
        largest[going] = np.maximum(largest[going], sizes)
        going = going[goes_on & (ratios > _GROWTH) & ~escapes[going]]
        total += length
        if not going.size:
            break
    undecided = np.zeros(count, dtype=bool)
    undecided[going] = True
    returns = _stroboscopic_returns(kernels, systems, motions, threads)
    return Pursued(motions, escapes, undecided, returns)


def numbers_of(systems: Sequence[PiecewiseLinear]) -> dict[str, float | np.ndarray]:
    """Parameters of systems (n,) as arrays (n,), or as numbers where all are the same system."""
    first = systems[0]
    if all(system is first for system in systems):
        return {name: float(value) for name, value in first.parameters.items()}
    return {
        name: np.array([float(system.parameters[name]) for system in systems])
        for name in first.parameters
    }


def _numbers_at(values: Mapping[str, Any], places: np.ndarray) -> dict[str, Any]:
    """Parameters, numbers or arrays (n,), of the systems at some places."""
    return {name: value[places] if np.ndim(value) else value for name, value in values.items()}


def natural_size(system: PiecewiseLinear) -> float:
    """Distance that a system's boundaries, its equilibria and its responses to the forcing reach.

    All configurations count, admissible or not; a homogeneous system has the distance zero.
    It is in the unit of velocities; positions count times the fastest exponent.
    """
    structure, weights = system.structure, _weights(system)
    own = np.flatnonzero(weights)
    rows = np.abs(system.rows[list(structure.watched)])
    across = (rows[:, own] / weights[own]).sum(axis=1)
    other = np.delete(rows, own, axis=1).sum(axis=1)
    found = float((other[across > 0] / across[across > 0]).max(initial=0.0))
    for field in system.fields:
        matrix, size = field[np.ix_(own, own)], np.zeros(len(own))
        loads = [(0.0, field[own, -1])]
        for cosine, sine in structure.forcing:
            loads.append((float(field[sine, cosine]), field[own, cosine] - 1j * field[own, sine]))
        for speed, load in loads:
            dynamic = 1j * speed * np.eye(len(own)) - matrix
            size += np.abs(np.linalg.lstsq(dynamic, load, rcond=_SINGULAR)[0])
        found = max(found, float((weights[own] * size).max(initial=0.0)))
    return found


def _weights(system: PiecewiseLinear) -> np.ndarray:
    """Weights (N,) that make states comparable.

    They are the fastest exponent for positions, 0 for the states of a forcing, and 1 for others.
    """
    structure = system.structure
    rates = [np.hypot(*exponents.T) for exponents in system.exponents]
    fastest = float(np.concatenate(rates).max(initial=0.0))
    found = np.ones(len(structure.states))
    found[[position for position, _ in structure.coordinates]] = fastest or 1.0
    found[list(structure.forced)] = 0.0
    return found


def _sizes(systems: Sequence[PiecewiseLinear], motions: Trajectories) -> np.ndarray:
    """Largest sizes (n,) of motions over the entries that are kept, up to translations."""
    ends = np.concatenate([motions.last_states, motions.states[:, None]], axis=1)
    known = np.where(np.isnan(ends), 0.0, ends)
    found = np.empty(len(systems))
    for place, system in enumerate(systems):
        states = up_to_shift(known[place], translations_of(system))
        found[place] = (np.abs(states) * _weights(system)).max()
    return found


def _replaced(motions: Trajectories, places: np.ndarray, others: Trajectories) -> Trajectories:
    """The motions, with others in some of the places."""
    changed = {}
    for name in (field.name for field in fields(motions) if field.name != "structure"):
        changed[name] = getattr(motions, name).copy()
        changed[name][places] = getattr(others, name)
    return replace(motions, **changed)


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
        here = _numbers_at(parameters, going)
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
    found[:, list(motions.structure.forced)] = 0.0
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(found / np.abs(found / scales).max(axis=1, keepdims=True))


def _stroboscopic_returns(
    kernels: SystemKernels,
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None = None,
) -> Returns:
    """Returns of motions (n,) of as many systems after some periods of the forcing.

    The last entries of the motions have to be kept. `threads` None takes all processors.
    """
    values = numbers_of(systems)
    periods = np.array([forcing_period(system) or np.nan for system in systems])
    directions = [translations_of(system) for system in systems]
    sizes = sizes_of(motions.structure, motions.last_states, motions.last_times)
    found = Returns(np.zeros(len(systems), dtype=int), np.full(len(systems), np.nan))
    going = np.flatnonzero((motions.status == Status.TRANSITIONS) & np.isfinite(periods))
    states = motions.last_states[going, -1]
    configurations = motions.last_configurations[going, -1]
    passed = np.zeros(len(systems), dtype=int)
    first: Trajectories | None = None
    for flash in range(_FLASHES + 1):
        if not going.size:
            break
        now = simulate_many(
            kernels,
            _numbers_at(values, going),
            states,
            configurations,
            until=periods[going] * (1.0 if flash else _ASIDE),
            transitions=_MOST,
            threads=threads,
        )
        stays = now.status == Status.UNTIL
        if first is None:
            first = now
        else:
            passed[going] += now.transitions
            moved = now.states - first.states
            moved = np.array([up_to_shift(moved[k], directions[p]) for k, p in enumerate(going)])
            back = (np.abs(moved) <= _RETURN * sizes[going]).all(axis=1)
            back &= stays & (now.configurations == first.configurations)
            found.periods[going[back]] = flash * periods[going[back]]
            found.lengths[going[back]] = passed[going[back]]
            stays &= ~back
        going, first = going[stays], first.at(stays)
        states, configurations = now.states[stays], now.configurations[stays]
    return found
