"""What is to be proved: an orbit of any kind as a cycle of its system, in physical coordinates."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import complete_system
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
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
    "physical_values",
    "subject_near",
    "subject_of",
    "system_of",
    "translations_in",
]

_MOST_TURNS = 1000


class NotCovered(Exception):
    """What this proof cannot be about; the message is the reason."""


@dataclass(frozen=True, eq=False)
class Subject:
    """An orbit of a system, and about where it is.

    Attributes
    ----------
    label : str
    kernels : SystemKernels
    values : dict of str to Value
        All parameters of the system.
    chosen : tuple of str
        Parameters that the orbit leaves open and that were chosen.
    cycle : ItineraryShape
    period : Value or None
        Where it was given.
    start, dwell : list of arb
        Exact; nothing is proved of them.
    start_names, dwell_names : tuple of str
    """

    label: str
    kernels: SystemKernels
    values: dict[str, Value]
    chosen: tuple[str, ...]
    cycle: ItineraryShape
    period: Value | None
    start: list[arb]
    dwell: list[arb]
    start_names: tuple[str, ...]
    dwell_names: tuple[str, ...]


def subject_of(orbit: Orbit) -> Subject:
    """The subject of a proof about an orbit.

    Parameters
    ----------
    orbit : Orbit
        The orbit in floating point.

    Returns
    -------
    Subject
        With its system's parameters, and balls around start and dwell times.

    Raises
    ------
    InputError
        If it has not converged.
    NotCovered
        If a parameter is an unknown of it.
    """
    check_converged(orbit, "certified")
    return subject_near(orbit)


def system_of(orbit: Orbit) -> str:
    """Name of the system that it is an orbit of.

    Parameters
    ----------
    orbit : Orbit
        The orbit in floating point.

    Returns
    -------
    str
        As the system is declared.
    """
    return orbit.system.name


def subject_near(orbit: Orbit) -> Subject:
    """As `subject_of`, where the orbit's equations may be singular too.

    Parameters
    ----------
    orbit : Orbit
        The orbit in floating point.

    Returns
    -------
    Subject
        With its system's parameters, and balls around start and dwell times.

    Raises
    ------
    NotCovered
        If a parameter was solved for, or the physical parameters do not follow.
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


def physical_values(kernels: OrbitKernels, given: Mapping[str, Value]) -> dict[str, Value]:
    """All parameters of the system from those of an orbit and the ones that it leaves open.

    Parameters
    ----------
    kernels : OrbitKernels
        The orbit's generated functions.
    given : dict of str to Value
        Parameters of the orbit, and those that it leaves open.

    Returns
    -------
    dict of str to Value
        By name.

    Raises
    ------
    NotCovered
        If they are not values that the system takes.
    """
    try:
        return complete_system(kernels, given).values
    except InputError as problem:
        raise NotCovered(str(problem)) from None


def translations_in(subject: Subject, tables: Tables) -> tuple[Row, ...]:
    """Directions along which the subject's system does not change, as the tables show.

    Parameters
    ----------
    subject : Subject
        The orbit that is to be proved.
    tables : Tables
        Of the system.

    Returns
    -------
    tuple of Row
        Exact; empty if one of them cannot be shown.
    """
    near = translations_of(piecewise(subject.kernels, subject.values)).tolist()
    return exact_translations(tables, subject.cycle.structure, near)


def closing_of(
    subject: Subject,
    tables: Tables,
    centre: Any,
    at: Sequence[Any] = (),
) -> ClosureConditions:
    """How the subject's cycle closes.

    Parameters
    ----------
    subject : Subject
        The orbit that is to be proved.
    tables : Tables
        Of the system.
    centre : floats (N)
        About where it starts: the coordinate whose closure the energy gives is chosen by it.
    at : sequence of arb
        Values at the orbit of what the tables are functions of.

    Returns
    -------
    ClosureConditions
        By the forcing, by the state, or by a period and an energy.

    Raises
    ------
    NotCovered
        If it closes in another way, or its numbers are not rational where they have to be.
    """
    cycle, near = subject.cycle, partial(tables.near, values=at)
    shifts = translations_in(subject, tables)
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
    largest = max(range(size), key=lambda i: abs(slopes[i]))
    return ClosureConditions(
        "period", period=subject.period, dropped=largest, form=form, translations=shifts
    )


def guess_of(
    subject: Subject, closing: ClosureConditions, near: Callable[[Any], float]
) -> list[arb]:
    """Unknowns of the equations, about.

    Parameters
    ----------
    subject : Subject
        The orbit that is to be proved.
    closing : ClosureConditions
        How the cycle closes.
    near : callable
        Gives an exact entry as a float.

    Returns
    -------
    list of arb
        Free states, the forcing's time, dwell times; in the system's units.
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
