"""What is to be proved: an orbit of any kind as a cycle of its system, in physical coordinates."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.exact_closure import (
    ClosureConditions,
    exact_translations,
    forcing_speeds,
)
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.proof.symplectic_form import symplectic_form
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape
from nonsmooth.runtime.shooting.translations import translations_of

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "NotCovered",
    "Subject",
    "closing_of",
    "guess_of",
    "subject_near",
    "system_of",
    "unknown_names",
]

_MOST_TURNS = 1000
_NEARLY = 1 - 1e-9  # of the largest: as large


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


def system_of(orbit: Orbit) -> str:
    """Return the name of the system that an orbit belongs to."""
    return orbit.system.name


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


def _translations_in(subject: Subject, tables: Tables) -> tuple[Row, ...]:
    """Return the exact directions along which the subject's system does not change.

    There are none if one of them cannot be shown by the tables.
    """
    near = translations_of(piecewise(subject.kernels, subject.values)).tolist()
    return exact_translations(tables, subject.cycle.structure, near)


def closing_of(
    subject: Subject,
    tables: Tables,
    centre: Any,
    at: Sequence[Any] = (),
) -> ClosureConditions:
    """Return how the subject's cycle closes: by the forcing, by the state, or by period and energy.

    `centre` (N) is about where the cycle starts: it chooses the coordinate whose closure follows
    from the energy. `at` holds the values at the orbit of what the tables are functions of.
    `NotCovered` is raised if the cycle closes in another way, or if its numbers are not rational
    where they have to be.
    """
    cycle, near = subject.cycle, partial(tables.near, values=at)
    shifts = _translations_in(subject, tables)
    if cycle.structure.forcing:
        if not tables.exact:
            raise NotCovered(
                "the parameters of a forced system have to be rational, and the cosines and sines"
                " of its phases"
            )
        speeds = forcing_speeds(tables, cycle)
        if isinstance(speeds, str):
            raise NotCovered(speeds)
        if not near(speeds[0]) > 0:
            raise NotCovered("the first forcing does not turn forwards")
        total = float(sum(float(t) for t in subject.dwell))
        turns = max(1, round(near(speeds[0]) * total / (2 * math.pi)))
        for speed in speeds[1:]:
            ratio = speed * turns / speeds[0]
            if ratio != round(near(ratio)):
                raise NotCovered("the forcings have no common period that is the orbit's")
        return ClosureConditions(
            "forcing",
            speeds=speeds,
            turns=turns,
            pairs=cycle.structure.forcing,
            translations=shifts,
        )
    if shifts and subject.period is not None:
        raise NotCovered("it is periodic up to a shift, and of a family that a period singles out")
    if subject.period is None:
        return ClosureConditions("state", translations=shifts)
    if not tables.exact:
        raise NotCovered("the parameters of a conservative system have to be rational")
    form = symplectic_form(tables, cycle)
    if form is None:
        raise NotCovered("no energy was found that the cycle keeps, so its period cannot be given")
    energy = form.energies[cycle.configurations[0]]
    size = len(centre)
    slopes = [
        sum(near(energy[i][j]) * centre[j] for j in range(size)) + near(energy[i][size])
        for i in range(size)
    ]
    if not all(map(math.isfinite, slopes)):
        raise NotCovered("the slopes of its energy are not finite where it starts")
    # the first of those that are as large but for rounding, in whatever arithmetic it is
    least = _NEARLY * max(abs(slope) for slope in slopes)
    largest = next(i for i, slope in enumerate(slopes) if abs(slope) >= least)
    return ClosureConditions(
        "period", period=subject.period, dropped=largest, form=form, translations=shifts
    )


def guess_of(
    subject: Subject, closing: ClosureConditions, near: Callable[[Any], float]
) -> list[arb]:
    """Return the unknowns of the equations, about: free states, the forcing's time, dwell times.

    `near` gives an exact entry as a float.
    """
    if closing.kind != "forcing":
        return [*subject.start, *subject.dwell]
    from flint import arb

    start = [float(x) for x in subject.start]
    speeds = [near(speed) for speed in closing.speeds]
    angles = [math.atan2(start[s], start[c]) for c, s in closing.pairs]

    def missed(time: float) -> float:
        return sum(
            1 - math.cos(speed * time - angle) for speed, angle in zip(speeds, angles, strict=True)
        )

    times = [(angles[0] + 2 * math.pi * k) / speeds[0] for k in range(_MOST_TURNS)]
    time = times[0] if len(speeds) == 1 else min(times, key=missed)
    free = [x for k, x in enumerate(subject.start) if k not in closing.forced]
    return [*free, arb(time), *subject.dwell]


def unknown_names(subject: Subject, closing: ClosureConditions) -> list[str]:
    """Return the unknowns' names: free states at the start, the forcing's time, dwell times."""
    free = [name for k, name in enumerate(subject.start_names) if k not in closing.forced]
    return [*free, *(["forcing time"] if closing.pairs else []), *subject.dwell_names]
