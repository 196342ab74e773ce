"""A section of an orbit that suits a proof of its basin, and where the orbit meets it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import (
    MapSection,
    angle_of,
    forcing_section,
    phases,
    sections_behind,
    ways_of,
)
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["MetSection", "section_of"]

_PHASES = 16


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
        return _forced(system, motion, period)
    found = [*_passed(system, motion)]
    if not found:
        raise InputError("the orbit passes no listed transition behind which a state is free")
    return min(found, key=lambda met: (len(met.point), met.iterates))


def _forced(system: ExactSystem, motion: Trajectory, period: float) -> MetSection:
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


def _passed(system: ExactSystem, motion: Trajectory) -> Iterator[MetSection]:
    ways = ways_of(motion.run.configurations, motion.run.sets)
    sections = sections_behind(system, ways)
    for k, way in enumerate(ways):
        if section := sections.get(way):
            yield MetSection(section, motion.states[k + 1][list(section.free)], ways.count(way))
