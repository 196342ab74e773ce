"""Sections of a motion: where to look for chaos, and one that suits a proof of a basin."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.model.engine_run import Run
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import (
    MapSection,
    angle_of,
    forcing_section,
    phases,
    sections_behind,
    ways_of,
)
from nonsmooth.runtime.simulation.simulate import follow
from nonsmooth.runtime.simulation.trajectory import Trajectory


class MetSection(NamedTuple):
    """A section, coordinates (d,) of a point of the orbit on it, and returns in one period."""

    section: MapSection
    point: Floats
    iterates: int


def section_of(system: ExactSystem, motion: Trajectory, period: float) -> MetSection:
    """The section with the fewest coordinates, or the forcing's phase far from boundaries.

    The motion is of the orbit, over one period at least.
    """
    if system.structure.forcing:
        return _met_at_a_phase(system, motion, period)
    found = [*_met_behind(system, motion)]
    if not found:
        raise InputError("the orbit passes no listed transition behind which a state is free")
    return min(found, key=lambda met: (len(met.point), met.iterates))


def _met_at_a_phase(system: ExactSystem, motion: Trajectory, period: float) -> MetSection:
    (c, s), structure = system.structure.forcing[0], system.structure
    speed = float(motion.system.fields[0, s, c])
    turn = 2 * np.pi / abs(speed)
    first = np.arctan2(motion.states[0, s], motion.states[0, c])
    found = []
    for phase in phases(_PHASES):
        # by rounding a turn may be longer than the motion
        time = np.array([min(((angle_of(phase) - first) / speed) % turn, motion.end)])
        state, name = motion(time)[0], str(motion.configuration(time)[0])
        configuration = structure.configuration(name)
        rows = motion.system.rows[[b.row for b in structure.boundaries[configuration]]]
        near = (rows[:, :-1] @ state + rows[:, -1]).max(initial=-np.inf)
        found.append((near, phase, configuration, state))
    _, phase, configuration, state = min(found, key=lambda entry: entry[0])
    section = forcing_section(system, configuration, phase)
    return MetSection(section, state[list(section.free)], max(1, round(period / turn)))


def _met_behind(system: ExactSystem, motion: Trajectory) -> Iterator[MetSection]:
    ways = ways_of(motion.run.configurations, motion.run.sets)
    sections = sections_behind(system, ways)
    for k, way in enumerate(ways):
        if section := sections.get(way):
            yield MetSection(section, motion.states[k + 1][list(section.free)], ways.count(way))


_PHASES = 16
_PERIODS, _TRANSIENT = 7000, 150
_TRANSITIONS = 6000
_FEWEST = 60  # points on a section
_TRIED = 4  # sections


class Sampled(NamedTuple):
    """A section, points (n, d) of a motion on it, and ranges (d,) of its coordinates on the way."""

    section: MapSection
    points: np.ndarray
    ranges: np.ndarray


def sampled_sections(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    """Yield sections that a long motion visits, the most promising ones first.

    With a forcing these are phases at which the motion is mostly in one configuration and far
    from boundaries, else transitions with few coordinates that are often passed. `motion` gives
    the start, and the system in double precision.
    """
    if system.structure.forcing:
        yield from _forced(system, motion)
    else:
        yield from _passed(system, motion)


def _forced(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    numbers, structure = motion.system, system.structure
    c, s = structure.forcing[0]
    speed = float(numbers.fields[0, s, c])
    period = 2 * np.pi / abs(speed)
    end = (_PERIODS + 1) * period
    run = follow(numbers, motion.states[0], int(motion.run.configurations[0]), end)
    long = Trajectory(numbers, run)
    if not long.end >= end * (1 - 1e-9):
        return
    start = np.arctan2(motion.states[0, s], motion.states[0, c])
    found = []
    for phase in phases(_PHASES):
        first = ((angle_of(phase) - start) / speed) % period
        times = first + period * np.arange(_TRANSIENT, _PERIODS)
        states, where = long(times), np.array(long.configuration(times))
        names, counts = np.unique(where, return_counts=True)
        name = str(names[np.argmax(counts)])
        configuration = structure.configuration(name)
        states = states[where == name]
        section = forcing_section(system, configuration, phase)
        if len(states) < _FEWEST or not section.free:  # at rest at a stop it is one point
            continue
        rows = numbers.rows[[b.row for b in structure.boundaries[configuration]]]
        values = states @ rows[:, :-1].T + rows[:, -1]
        spread = values.std(axis=0)
        near = (values.max(axis=0)[spread > 0] / spread[spread > 0]).max(initial=-np.inf)
        found.append((-counts.max() / counts.sum(), near, _sampled(section, states, run)))
    found.sort(key=lambda entry: entry[:2])
    yield from (sampled for *_, sampled in found[:_TRIED])


def _passed(system: ExactSystem, motion: Trajectory) -> Iterator[Sampled]:
    start, first = motion.states[0], int(motion.run.configurations[0])
    run = follow(motion.system, start, first, transitions=_TRANSITIONS)
    half = len(run.times) // 2
    ways = ways_of(run.configurations[half - 1 :], run.sets[half - 1 :])
    counts = {way: count for way, count in Counter(ways).items() if count >= _FEWEST}
    sections = sections_behind(system, [*counts])
    found = sorted(
        sections,
        key=lambda way: (len(sections[way].free), -counts[way], way[0], way[2], min(way[1])),
    )
    for way in found[:_TRIED]:
        places = [e for e, other in enumerate(ways, half) if other == way]
        yield _sampled(sections[way], run.states[places], run)


def _sampled(section: MapSection, states: np.ndarray, run: Run) -> Sampled:
    """The free coordinates of states (n, N) on a section, with their ranges along the motion."""
    free = list(section.free)
    on_the_way = np.concatenate([states, run.states])[:, free]
    return Sampled(section, states[:, free], np.ptp(on_the_way, axis=0))
