"""What is to be proved: an orbit of any kind as a cycle of its system, in physical coordinates."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import complete_system
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.physical_parameters import physical_parameters
from nonsmooth.runtime.proof.closure import (
    Closing,
    exact_translations,
    forcing_speeds,
    symplectic_form,
)
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.shooting.cycle_newton import fitting_start
from nonsmooth.runtime.shooting.shooting_map import Cycle, cycle_of
from nonsmooth.runtime.shooting.translations import translations_of

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "NotCovered",
    "Subject",
    "check_converged",
    "closing_of",
    "guess_of",
    "period_name",
    "period_of",
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
    cycle : Cycle
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
    cycle: Cycle
    period: Value | None
    start: list[arb]
    dwell: list[arb]
    start_names: tuple[str, ...]
    dwell_names: tuple[str, ...]


def subject_of(orbit: Orbit) -> Subject:
    """The subject of a proof about an orbit.

    Raises
    ------
    InputError
        If it has not converged.
    NotCovered
        If a parameter is an unknown of it.
    """
    check_converged(orbit)
    return subject_near(orbit)


def system_of(orbit: Orbit) -> str:
    """Name of the system that it is an orbit of."""
    return orbit.system.name


def check_converged(orbit: Orbit) -> None:
    """Refuse what is no orbit."""
    if not orbit.converged:
        raise InputError(f"{orbit.name} cannot be certified: {orbit.message}")


def subject_near(orbit: Orbit) -> Subject:
    """As `subject_of`, where the orbit's equations may be singular too."""
    return _composed(orbit) if orbit.problem.kernels is None else _derived(orbit)


def _composed(orbit: Orbit) -> Subject:
    names = tuple(orbit.unknowns)
    count = len(orbit.dwell_times)
    return Subject(
        orbit.name,
        orbit.system,
        orbit.parameters,
        (),
        cycle_of(structure_of(orbit.system), orbit.itinerary),
        orbit.given_period,
        [exact_ball(x) for x in orbit.states[0].tolist()],
        [exact_ball(x) for x in orbit.dwell_times.tolist()],
        names[count:],
        names[:count],
    )


def _derived(orbit: Orbit) -> Subject:
    kernels = orbit.kernels
    if kernels.table["vanishing"]:
        raise NotCovered(
            f"{orbit.name} is a border collision: {', '.join(kernels.solved_for)} has no exact"
            " value at it"
        )
    exchanged = [name for name in orbit.unknowns if name not in kernels.unknowns]
    if exchanged:
        raise NotCovered(f"{', '.join(exchanged)} was solved for and has no exact value")
    try:
        point = physical_parameters(orbit)
    except InputError as problem:
        raise NotCovered(str(problem)) from None
    values = point.values
    structure = structure_of(kernels.system)
    cycle = cycle_of(structure, [(c, b) for c, b, _ in kernels.table["phases"]])
    dwell = orbit.dwell_times.tolist()
    # closure and switching are linear in the start: these numbers are guesses, as all here
    flat = numbers_of(piecewise(kernels.system, values))[None]
    with np.errstate(all="ignore"):
        start = fitting_start(cycle, flat, np.array([[float(t) for t in dwell]]))[0]
    names = kernels.dwell_times
    return Subject(
        orbit.name,
        kernels.system,
        values,
        point.chosen,
        cycle,
        period_of(kernels, orbit.given),
        [exact_ball(x) for x in start.tolist()],
        [exact_ball(x) for x in dwell],
        start_names(structure.states, {*names, *values}),
        names,
    )


def period_name(kernels: OrbitKernels) -> str | None:
    """The parameter that the dwell times sum up to, of a conservative orbit."""
    total: dict[str, int] = {}
    for terms in kernels.table["durations"]:
        for name, factor in terms.items():
            total[name] = total.get(name, 0) + factor
    left = [name for name, factor in total.items() if factor]
    return left[0] if len(left) == 1 and total[left[0]] == 1 else None


def period_of(kernels: OrbitKernels, given: Mapping[str, Value]) -> Value | None:
    """What the dwell times of a conservative orbit sum up to, if it is given."""
    name = period_name(kernels)
    return None if name is None else given.get(name)


def physical_values(kernels: OrbitKernels, given: Mapping[str, Value]) -> dict[str, Value]:
    """All parameters of the system from those of an orbit and the ones that it leaves open.

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
    """Directions along which the subject's system does not change, as the tables show."""
    near = translations_of(piecewise(subject.kernels, subject.values)).tolist()
    return exact_translations(tables, subject.cycle.structure, near)


def closing_of(
    subject: Subject,
    tables: Tables,
    centre: Any,
    at: Sequence[Any] = (),
) -> Closing:
    """How the subject's cycle closes.

    Parameters
    ----------
    centre : floats (N)
        About where it starts: the coordinate whose closure the energy gives is chosen by it.
    at : sequence of arb
        Values at the orbit of what the tables are functions of.

    Raises
    ------
    NotCovered
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
        return Closing(
            "forcing",
            speeds=speeds,
            turns=turns,
            pairs=cycle.structure.forcing,
            translations=shifts,
        )
    if shifts and subject.period is not None:
        raise NotCovered("it is periodic up to a shift, and of a family that a period singles out")
    if subject.period is None:
        return Closing("state", translations=shifts)
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
    return Closing("period", period=subject.period, dropped=largest, form=form, translations=shifts)


def guess_of(subject: Subject, closing: Closing, near: Callable[[Any], float]) -> list[arb]:
    """Unknowns of the equations, about."""
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
