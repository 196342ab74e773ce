"""Short cycles of the transitions that motions go through, as guesses of periodic orbits."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np

from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.simulation.recurrence import Candidate, Itinerary, canonical, phase_name
from nonsmooth.runtime.simulation.simulate import Trajectories

__all__ = ["short_cycles"]

_LONGEST = 6
_MOST = 200


def short_cycles(kernels: SystemKernels, motions: Trajectories) -> Iterator[Candidate]:
    """Guesses from cycles of phases that follow each other, and from the system's known orbits.

    Dwell times are medians of those that were seen; the start is the mean of the states at
    which the first phase was entered. Shorter cycles come first.
    """
    follows, durations, starts = _seen(motions)
    tried: set[Itinerary] = set()

    def guess(itinerary: Itinerary) -> Candidate | None:
        turn = canonical(itinerary)
        itinerary = itinerary[turn:] + itinerary[:turn]
        if itinerary in tried or not all(phase in durations for phase in itinerary):
            return None
        tried.add(itinerary)
        dwell = np.array([np.median(durations[phase]) for phase in itinerary])
        return Candidate(itinerary, dwell, np.mean(starts[itinerary[0]], axis=0), np.inf)

    for table in kernels.module.ORBITS.values():
        found = guess(tuple((configuration, name) for configuration, name, _ in table["phases"]))
        if found is not None:
            yield found
    for count, itinerary in enumerate(_cycles(follows)):
        if count == _MOST:
            return
        found = guess(itinerary)
        if found is not None:
            yield found


def _seen(
    motions: Trajectories,
) -> tuple[
    dict[tuple[str, str], set[tuple[str, str]]],
    dict[tuple[str, str], list[float]],
    dict[tuple[str, str], list[np.ndarray]],
]:
    """The successors of each phase, how long each lasted, and where it began."""
    follows = defaultdict(set)
    durations, starts = defaultdict(list), defaultdict(list)
    for motion in range(len(motions.times)):
        previous = None
        configurations = motions.last_configurations[motion]
        sets, times = motions.last_sets[motion], motions.last_times[motion]
        for i in range(len(times) - 1):
            name = None
            if configurations[i] >= 0:
                name = phase_name(motions.structure, int(configurations[i]), int(sets[i + 1]))
            if name is not None:
                durations[name].append(float(times[i + 1] - times[i]))
                starts[name].append(motions.last_states[motion, i])
                if previous is not None:
                    follows[previous].add(name)
            previous = name
    return follows, durations, starts


def _cycles(follows: dict[tuple[str, str], set[tuple[str, str]]]) -> Iterator[Itinerary]:
    """Cycles without a repeated phase, the shorter ones first."""
    for length in range(2, _LONGEST + 1):
        for first in sorted(follows):
            paths: list[Itinerary] = [(first,)]
            for _ in range(length - 1):
                paths = [
                    (*path, phase)
                    for path in paths
                    for phase in sorted(follows.get(path[-1], ()))
                    if phase > first and phase not in path
                ]
            yield from (path for path in paths if first in follows.get(path[-1], ()))
