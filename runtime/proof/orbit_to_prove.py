"""What is to be proved: an orbit of any kind as a cycle of its system, in physical coordinates."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape

__all__ = [
    "NotCovered",
    "Subject",
    "guess_of",
    "subject_near",
]

_MOST_TURNS = 1000


class NotCovered(Exception):
    """The method cannot be applied; the message is the reason."""


@dataclass(frozen=True, eq=False)
class Subject:
    """An orbit that is to be proved: its system, parameters and cycle, and about where it is."""

    label: str
    kernels: SystemKernels
    values: dict[str, Value]  # all parameters of the system
    chosen: tuple[str, ...]  # parameters that the orbit leaves open and that were chosen
    cycle: ItineraryShape
    period: Value | None  # where it was given
    start: list[arb]  # exact numbers of which nothing is proved
    dwell: list[arb]  # exact numbers of which nothing is proved
    start_names: tuple[str, ...]
    dwell_names: tuple[str, ...]

    @property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the equations' unknowns: free states, the forcing's time, dwell times."""
        forced = self.cycle.structure.forced
        free = [name for k, name in enumerate(self.start_names) if k not in forced]
        return (*free, *(["forcing time"] if forced else []), *self.dwell_names)


def subject_near(orbit: Orbit) -> Subject:
    """Return the subject of a proof about an orbit.

    `NotCovered` is raised if a parameter is an unknown of the orbit, or if the system's parameters
    do not follow from it.
    """
    problem = orbit.problem
    solved_for = ", ".join(name for name in orbit.unknowns if name in problem.all_parameters)
    if solved_for and not orbit.dwell_times.all():
        raise NotCovered(
            f"{orbit.name} is a border collision: {solved_for} has no exact value at it"
        )
    if solved_for:
        raise NotCovered(f"{solved_for} was solved for and has no exact value")
    try:
        point = problem.physical(orbit)
    except InputError as reason:
        raise NotCovered(str(reason)) from None
    return Subject(
        orbit.name,
        orbit.system,
        point.values,
        point.chosen,
        itinerary_shape(structure_of(orbit.system), orbit.itinerary),
        problem.period(orbit),
        [exact_ball(x) for x in problem.system_start(orbit, point.values)],
        [exact_ball(x) for x in orbit.dwell_times.tolist()],
        problem.start_names,
        problem.dwell_time_names,
    )


def guess_of(subject: Subject, tables: Tables, at: Sequence[Any] = ()) -> list[arb]:
    """Return the unknowns of the equations, about: free states, the forcing's time, dwell times.

    `at` holds the values at the orbit of what the tables are functions of.
    """
    structure = subject.cycle.structure
    pairs = structure.forcing
    if not pairs:
        return [*subject.start, *subject.dwell]
    start = [float(x) for x in subject.start]
    field = tables.fields[subject.cycle.configurations[0]]
    speeds = [tables.near(field[s][c], at) for c, s in pairs]
    angles = [math.atan2(start[s], start[c]) for c, s in pairs]

    def missed(time: float) -> float:
        return sum(
            1 - math.cos(speed * time - angle) for speed, angle in zip(speeds, angles, strict=True)
        )

    times = [(angles[0] + 2 * math.pi * k) / speeds[0] for k in range(_MOST_TURNS)]
    time = times[0] if len(speeds) == 1 else min(times, key=missed)
    free = [x for k, x in enumerate(subject.start) if k not in structure.forced]
    return [*free, arb(time), *subject.dwell]
