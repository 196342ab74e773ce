"""The periodic orbits that live in a system: attractors by simulation, others by Newton.

Random starts are followed until their transients are gone; the itineraries that recur are
solved as periodic orbits. Unstable orbits are not reached that way: cycles after which a
motion nearly came back, and short cycles of the transitions that were seen, are tried too.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from nonsmooth.runtime.composition.composed import ComposedOrbit, compose, compose_many
from nonsmooth.runtime.composition.translations import translations_of, up_to_shift
from nonsmooth.runtime.errors import InputError, unknown_name
from nonsmooth.runtime.finding.neighbours import short_cycles
from nonsmooth.runtime.finding.recurrence import (
    Candidate,
    Itinerary,
    candidate_at,
    near_returns,
    recurrent_lengths,
    scale_of,
    sizes_of,
)
from nonsmooth.runtime.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.loading.declared import DeclaredSystem
from nonsmooth.runtime.simulation.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.simulation.run import Status
from nonsmooth.runtime.simulation.simulate import Trajectories, checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import on_circles
from nonsmooth.runtime.values import Value

__all__ = [
    "ILLEGAL",
    "RESTING",
    "UNCLASSIFIED",
    "Found",
    "FoundOrbit",
    "find_orbits",
    "label_names",
    "labels_of",
    "start_box",
]

UNCLASSIFIED, RESTING, ILLEGAL = -1, -2, -3

_TOLERANCES = (1e-10, 1e-7, 1e-4, 1e-2)  # of a return: the tightest that finds one decides
_KEPT = 129  # entries: cycles of at most 64 phases
_NEAR, _LONGEST = 0.3, 12  # a near return, and the longest cycle that is tried for one
_ARRIVED = 1e-3  # how near to an attractor a motion has to end, relative to its size
_SAME = 1e-7  # relative difference of two orbits' dwell times


@dataclass(frozen=True, eq=False)
class FoundOrbit:
    """A periodic orbit and how many of the starts led to it.

    Attributes
    ----------
    orbit : ComposedOrbit
    starts : int
    share : float
        Of all starts; 0 for an orbit that no start led to.
    """

    orbit: ComposedOrbit
    starts: int
    share: float

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Phases: configuration, and boundary by which it is left."""
        return self.orbit.itinerary

    @property
    def period(self) -> float:
        """Sum of the dwell times."""
        return float(self.orbit.period)

    @property
    def verdict(self) -> str:
        """Stable, unstable, neutral or undecided."""
        return str(self.orbit.stability.verdict)


@dataclass(frozen=True, eq=False)
class Found:
    """The periodic orbits that were found, those with the largest basins first.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
    names : tuple of str
        Of the states.
    orbits : tuple of FoundOrbit
    starts : array (n, N)
    labels : array (n,) of int
        Where each start led: an index of `orbits`, RESTING where no boundary is reached any
        more, UNCLASSIFIED where the motion was not recognised.
    box : array (N, 2)
        From where the starts were drawn.
    transitions : int
        How many each start was followed.
    """

    system: str
    parameters: dict[str, Value]
    names: tuple[str, ...]
    orbits: tuple[FoundOrbit, ...]
    starts: np.ndarray
    labels: np.ndarray
    box: np.ndarray
    transitions: int

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write everything as JSON that `nonsmooth.runtime.finding.saved.load_found` reads."""
        from nonsmooth.runtime.finding.saved import save_found

        save_found(self, path)

    @property
    def unclassified(self) -> float:
        """Share of the starts whose motion was not recognised."""
        return float(np.mean(self.labels == UNCLASSIFIED)) if self.labels.size else 0.0

    @property
    def resting(self) -> float:
        """Share of the starts that came to where no boundary is reached any more."""
        return float(np.mean(self.labels == RESTING)) if self.labels.size else 0.0


def find_orbits(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    n: int = 400,
    *,
    transitions: int = 2000,
    box: Mapping[str, tuple[float, float]] | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[str], None] = lambda step: None,
) -> Found:
    """Find periodic orbits, stable and unstable, with their basins.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters.
    n : int
        Random starts.
    transitions : int
        After which transients count as gone.
    box : mapping of state to (lower, upper), optional
        Where the starts are drawn; states that are not named take what `start_box` gives.
    seed : int
        Equal seeds give equal starts.
    threads : int, optional
    progress : callable
        Told the name of each step when it begins.

    Raises
    ------
    InputError
        For wrong names, values or counts.
    """
    kernels = kernels_of(system)
    point = piecewise(kernels, parameters)
    count = checked_count("n", n, 1)
    length = checked_count("transitions", transitions, 2)
    limits = start_box(point, box)
    checked_count("seed", seed, 0)
    values = {name: float(value) for name, value in point.parameters.items()}

    directions = translations_of(point)

    def follow(starts: np.ndarray, number: int, keep: int) -> Trajectories:
        motions = simulate_many(
            kernels, values, starts, transitions=number, keep=keep, threads=threads
        )
        return replace(motions, last_states=up_to_shift(motions.last_states, directions))

    progress(f"following {count} starts")
    starts, motions = _legal_starts(follow, point, limits, count, seed, length)
    attractors: list[ComposedOrbit] = []
    progress("solving the motions that recur")
    for candidate in _recurrent(motions):
        orbit = _solved(kernels, point, candidate)
        if orbit is not None:
            _add(attractors, orbit)
    labels = labels_of(motions, attractors)

    progress("looking for unstable orbits")
    early = follow(starts[: min(count, 200)], _KEPT, _KEPT)
    everything = list(attractors)
    for candidate in _converging(kernels, point, _tried(kernels, motions, early)):
        if not any(_same(known, candidate) for known in everything):
            orbit = _solved(kernels, point, candidate)
            if orbit is not None:
                _add(everything, orbit)
    totals = [int((labels == i).sum()) for i in range(len(attractors))]
    totals += [0] * (len(everything) - len(attractors))
    order = sorted(range(len(everything)), key=lambda i: (-totals[i], float(everything[i].period)))
    places = np.argsort(order)
    return Found(
        kernels.name,
        point.parameters,
        point.structure.states,
        tuple(FoundOrbit(everything[i], totals[i], totals[i] / len(starts)) for i in order),
        starts,
        np.where(labels >= 0, places[np.maximum(labels, 0)] if len(order) else labels, labels),
        limits,
        length,
    )


def start_box(
    system: PiecewiseLinear, given: Mapping[str, tuple[float, float]] | None = None
) -> np.ndarray:
    """Bounds (N, 2) between which starts are drawn.

    For each state twice the largest size at which a boundary or a constraint lies, on both
    sides; the mean of the others' for a state in which none does.

    Raises
    ------
    InputError
        For an unknown state, or bounds that are no interval.
    """
    structure = system.structure
    used = {b.row for boundaries in structure.boundaries for b in boundaries}
    used |= {row for rows in structure.constraints for row in rows}
    rows = system.rows[sorted(used)]
    with np.errstate(divide="ignore", invalid="ignore"):
        sizes = np.abs(rows[:, -1:] / rows[:, :-1])
    sizes[~np.isfinite(sizes)] = 0.0
    largest = sizes.max(axis=0, initial=0.0)
    known = largest[largest > 0]
    largest[largest == 0] = known.mean() if known.size else 1.0
    limits = np.stack([-2 * largest, 2 * largest], axis=1)
    forced = [state for pair in structure.forcing for state in pair]
    limits[forced] = -1.0, 1.0  # of starts on a circle
    for name, bounds in (given or {}).items():
        if name not in structure.states:
            raise unknown_name("state", str(name), structure.states)
        try:
            low, high = map(float, bounds)
        except (TypeError, ValueError):
            raise InputError(f"box of {name}: {bounds!r} is no pair of numbers") from None
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"box of {name}: {low!r} to {high!r} is no interval")
        limits[structure.states.index(name)] = low, high
    return limits


def _legal_starts(
    follow: Callable[[np.ndarray, int, int], Trajectories],
    point: PiecewiseLinear,
    limits: np.ndarray,
    count: int,
    seed: int,
    transitions: int,
) -> tuple[np.ndarray, Trajectories]:
    """Random starts that belong to a configuration, and their motions."""
    rng = np.random.default_rng(seed)
    legal = np.empty((0, len(limits)))
    for _ in range(20):
        drawn = rng.uniform(limits[:, 0], limits[:, 1], (count, len(limits)))
        if point.structure.forcing:
            drawn = on_circles(point, drawn, rng.uniform(0, 2 * np.pi, count))
        legal = np.concatenate([legal, drawn[follow(drawn, 1, 0).status >= 0]])
        if len(legal) >= count:
            break
    if not len(legal):
        raise InputError("no start in the box belongs to a configuration: give another box")
    starts = legal[:count]
    return starts, follow(starts, transitions, _KEPT)


def _recurrent(motions: Trajectories) -> Iterator[Candidate]:
    """The best example of each recurrent itinerary, and of each of its motions."""
    lengths = np.zeros(len(motions.times), dtype=int)
    for tolerance in _TOLERANCES:
        found = recurrent_lengths(motions, tolerance)
        lengths = np.where(lengths > 0, lengths, found)
    scale = scale_of(motions)
    candidates = []
    last = motions.last_times.shape[1] - 1
    for motion in np.flatnonzero(lengths).tolist():
        found_cycle = candidate_at(motions, motion, last, int(lengths[motion]), scale)
        if found_cycle is not None:
            candidates.append(found_cycle)
    seen: list[Candidate] = []
    for candidate in sorted(candidates, key=lambda c: c.miss):
        twin = any(
            candidate.itinerary == other.itinerary
            and np.allclose(candidate.dwell_times, other.dwell_times, rtol=0.01, atol=1e-3)
            for other in seen
        )
        if not twin:
            seen.append(candidate)
            yield candidate


def _tried(
    kernels: SystemKernels, motions: Trajectories, early: Trajectories
) -> Iterator[Candidate]:
    """Guesses for orbits that no transient ends at."""
    yield from near_returns(early, _LONGEST, _NEAR)
    yield from near_returns(motions, _LONGEST, _NEAR)
    yield from short_cycles(kernels, early)


def _converging(
    kernels: SystemKernels, point: PiecewiseLinear, candidates: Iterable[Candidate]
) -> Iterator[Candidate]:
    """Candidates from which Newton's method converges, moved to where it does, each once."""
    groups: dict[Itinerary, list[Candidate]] = defaultdict(list)
    for candidate in candidates:
        if (candidate.dwell_times > 0).all():
            groups[candidate.itinerary].append(candidate)
    for itinerary, group in groups.items():
        values = {name: np.full(len(group), float(v)) for name, v in point.parameters.items()}
        found = compose_many(
            kernels,
            itinerary,
            values,
            np.array([c.dwell_times for c in group]),
            np.array([c.state for c in group]),
            threads=1,
        )
        good = found.converged & (found.dwell_times > 0).all(axis=1)
        kept: list[np.ndarray] = []
        for i in np.flatnonzero(good).tolist():
            dwell = found.dwell_times[i]
            cycle = np.concatenate([dwell, found.states[i, 0]])
            if not any(np.allclose(cycle, known, rtol=_SAME, atol=_SAME) for known in kept):
                kept.append(cycle)
                yield Candidate(itinerary, dwell, found.states[i, 0], 0.0)


def _solved(
    kernels: SystemKernels, point: PiecewiseLinear, candidate: Candidate
) -> ComposedOrbit | None:
    """The admissible orbit near a candidate, over its prime period; None if there is none."""
    if not (candidate.dwell_times > 0).all():
        return None
    orbit = compose(
        kernels,
        point.parameters,
        candidate.itinerary,
        candidate.dwell_times.tolist(),
        candidate.state.tolist(),
    )
    if not orbit.converged or not (orbit.dwell_times > 0).all():
        return None
    for length in range(1, len(orbit.itinerary) // 2 + 1):
        turns, rest = divmod(len(orbit.itinerary), length)
        if rest or orbit.itinerary != orbit.itinerary[:length] * turns:
            continue
        cycles = orbit.dwell_times.reshape(turns, length)
        states = orbit.states_up_to_shift.reshape(turns, length, -1)
        states = states / sizes_of(orbit.states_up_to_shift)
        if np.allclose(cycles, cycles[0], rtol=1e-6, atol=1e-9) and np.allclose(
            states, states[0], rtol=0, atol=1e-6
        ):
            part = replace(
                candidate,
                itinerary=orbit.itinerary[:length],
                dwell_times=cycles[0],
                state=orbit.states[0],
            )
            return _solved(kernels, point, part)
    return orbit if orbit.admissibility.verdict is True else None


def _same(orbit: ComposedOrbit, other: Candidate | ComposedOrbit) -> bool:
    """Whether two cycles are the same; a doubled one begins at either of its turns."""
    start = other.state if isinstance(other, Candidate) else other.states[0]
    states = orbit.states_up_to_shift
    return any(
        orbit.itinerary == other.itinerary[turn:] + other.itinerary[:turn]
        and np.allclose(
            orbit.dwell_times, np.roll(other.dwell_times, -turn), rtol=_SAME, atol=_SAME
        )
        and (np.abs(states[-turn] - start) <= 10 * _SAME * sizes_of(states)).all()
        for turn in range(len(other.itinerary))
    )


def _add(orbits: list[ComposedOrbit], orbit: ComposedOrbit) -> None:
    """Add an orbit that is not there yet."""
    if not any(_same(known, orbit) for known in orbits):
        orbits.append(orbit)


def labels_of(motions: Trajectories, orbits: Sequence[ComposedOrbit]) -> np.ndarray:
    """Where each motion ended: index of a stable orbit, RESTING, UNCLASSIFIED or ILLEGAL.

    The last two entries of the motions have to be kept.
    """
    structure = motions.structure
    labels = np.full(len(motions.times), UNCLASSIFIED)
    labels[motions.status == Status.QUIET] = RESTING
    labels[motions.status < 0] = ILLEGAL
    nearest = np.full(len(labels), _ARRIVED)
    for index, orbit in enumerate(orbits):
        if orbit.stability.verdict != "stable":
            continue
        states = orbit.states_up_to_shift
        scale, ends = sizes_of(states), up_to_shift(motions.last_states[:, -1], orbit.translations)
        for phase, (name, _) in enumerate(orbit.itinerary):
            where = structure.configuration(name)
            before = orbit.cycle.configurations[phase - 1]
            mask = 1 << orbit.cycle.boundaries[phase - 1]
            here = (
                (motions.last_configurations[:, -1] == where)
                & (motions.last_configurations[:, -2] == before)
                & (motions.last_sets[:, -1] == mask)
                & (motions.status == Status.TRANSITIONS)
            )
            with np.errstate(invalid="ignore"):
                distance = np.abs(ends - states[phase])
                miss = (distance / scale).max(axis=1)
            better = here & (miss < nearest)
            labels[better], nearest[better] = index, miss[better]
    return labels


def label_names(found: Found) -> dict[int, str]:
    """What the labels stand for, for pictures: the orbits that attract, and the rest."""
    names = {
        i: f"orbit {i + 1}, period {o.period:.6g}" for i, o in enumerate(found.orbits) if o.starts
    }
    return {**names, RESTING: "rest", UNCLASSIFIED: "unclassified", ILLEGAL: "no configuration"}
