"""Observables of a simulated motion: peaks, averages, times in configurations, contact forces.

Peaks are guaranteed (`extremes`). Averages and works are integrals by Gauss and Legendre's
rule, whose error is far below rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arguments import checked_methods
from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.simulation.moved_phases import moments
from nonsmooth.runtime.simulation.phase_functions import Extreme, extremes, phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory


@dataclass(frozen=True)
class ContactObservables:
    """Force, work and loss of one contact: a stop or a belt.

    An impact is no force: it takes no time, and neither its impulse nor the energy that it
    takes is part of these numbers.
    """

    minimum: Extreme  # of the force on the oscillator, with its time
    maximum: Extreme  # of the same force
    mean: float  # force averaged over time
    work: float  # integral of force times the oscillator's velocity: what the oscillator gains
    dissipated: float  # integral of force times (surface's velocity - oscillator's velocity)

    @property
    def peak(self) -> float:
        """Largest absolute value of the force."""
        return max(abs(self.minimum.value), abs(self.maximum.value))


@checked_methods
@dataclass(frozen=True, eq=False)
class Observables:
    """Observables of a motion from a time on.

    Attributes
    ----------
    trajectory : Trajectory
    since, duration : float
    minima, maxima : dict of state to Extreme
        Values and times at which they are attained.
    means, rms : dict of state to float
        Averages over time, and square roots of those of the squares.
    fractions : dict of configuration to float
        Part of the time that is spent in each.
    sticking : dict of position to float
        Part of the time in configurations that hold it; only positions that some do.
    contacts : dict of str to ContactObservables

    Examples
    --------
    >>> from nonsmooth.runtime.simulation.simulate import simulate
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "k3": 1}
    >>> motion = simulate("elastic-stop", data, [0, 0, 2, 0], until=50)
    >>> found = observe(motion, since=10)
    >>> sorted(found.fractions) == ["contact", "free"]
    True
    >>> round(found.contacts["stop"].peak + 1 - found.maxima["x1"].value, 12)
    0.0
    """

    trajectory: Trajectory
    since: float
    duration: float
    minima: dict[str, Extreme]
    maxima: dict[str, Extreme]
    means: dict[str, float]
    rms: dict[str, float]
    fractions: dict[str, float]
    sticking: dict[str, float]
    contacts: dict[str, ContactObservables]

    def force(self, name: str, times: Any) -> np.ndarray:
        """Force of a contact on the oscillator at times (...) of the motion.

        Parameters
        ----------
        name : str
            Of the contact.
        times : array (...)

        Returns
        -------
        array (...)
            In the system's unit of force.

        Raises
        ------
        InputError
            For an unknown contact, or a time that is not one of the motion.
        """
        return self._contact(name, times)[0]

    def power(self, name: str, times: Any) -> np.ndarray:
        """Force times (oscillator's velocity - surface's velocity); what is lost is negative.

        Parameters
        ----------
        name : str
            Of the contact.
        times : array (...)

        Returns
        -------
        array (...)
            In the system's unit of force times that of velocity.

        Raises
        ------
        InputError
            As for `force`.
        """
        force, velocity, surface = self._contact(name, times)
        return np.asarray(force * (velocity - surface))

    def _contact(self, name: str, times: Any) -> tuple[np.ndarray, ...]:
        system, structure = self.trajectory.system, self.trajectory.structure
        names = [contact.name for contact in structure.contacts]
        if name not in names:
            raise unknown_name("contact", name, names)
        states = self.trajectory(times)
        phases = np.searchsorted(self.trajectory.times, np.asarray(times, float), side="right") - 1
        first = len(structure.states) + 3 * names.index(name)
        every = observed_rows(structure, system.rows)[:, first : first + 3]
        rows = every[self.trajectory.run.configurations[phases]]
        found = (rows[..., :-1] @ states[..., None])[..., 0] + rows[..., -1]
        return found[..., 0], found[..., 1], found[..., 2]


def observe(trajectory: Trajectory, since: float = 0.0) -> Observables:
    """Observe a motion from a time to its end.

    Parameters
    ----------
    trajectory : Trajectory
    since : float
        Where to begin: behind a transient.

    Returns
    -------
    Observables
        Extremes, means, impacts and the power of the contacts, in the units of the system.

    Raises
    ------
    InputError
        If `since` is not between the start and the end of the motion, or the motion is not
        finite.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> motion = ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=10)
    >>> ns.observe(motion).duration > 0
    True
    """
    system, structure = trajectory.system, trajectory.structure
    phases = phases_of(trajectory, since)
    duration = trajectory.end - float(since)
    size = len(structure.states)
    rows = observed_rows(structure, system.rows)
    forces = [size + 3 * i for i in range(len(structure.contacts))]
    minima, maxima = extremes(system, phases, rows[:, [*range(size), *forces]])
    found = moments(system, phases, rows)
    spent = np.bincount(
        phases.configurations, phases.durations, minlength=len(structure.configurations)
    )
    averages = (
        found[:, -1] / duration,
        np.sqrt(np.diag(found)[:size] / duration),
        spent / spent.sum(),
        found,
    )
    told = told_of(structure, ContactObservables, minima, maxima, *(x.tolist() for x in averages))
    return Observables(trajectory, float(since), duration, *told)


def told_of(
    structure: Structure,
    contact: Callable[..., Any],
    minima: Any,
    maxima: Any,
    means: Any,
    rms: Any,
    fractions: Any,
    works: Any,
) -> tuple[dict[str, Any], ...]:
    """What is told of a motion or of its derivatives, by name.

    It comes in the order of the fields of `Observables`. Minima and maxima are those of the states
    and of the contacts' forces; means and the integrals `works` of products are those of
    `observed_rows`. A fraction is that of the time in a configuration. `contact` makes a record.
    """
    states, size = structure.states, len(structure.states)
    held = sorted({position for positions in structure.held for position in positions})
    contacts = {}
    for place, (shape, force) in enumerate(
        zip(structure.contacts, range(size, len(means), 3), strict=True)
    ):
        work = works[force]
        contacts[shape.name] = contact(
            minima[size + place],
            maxima[size + place],
            means[force],
            work[force + 1],
            work[force + 2] - work[force + 1],
        )
    return (
        *(dict(zip(states, part, strict=False)) for part in (minima, maxima, means, rms)),
        dict(zip(structure.configurations, fractions, strict=True)),
        {
            states[position]: sum(
                part for part, own in zip(fractions, structure.held, strict=True) if position in own
            )
            for position in held
        },
        contacts,
    )


def force_rows(structure: Structure, rows: np.ndarray, contact: int) -> np.ndarray:
    """Force (..., configurations, N + 1) of a contact, from the rows (..., R, N + 1) of tables.

    It is zero in configurations that do not have it.
    """
    shape = (*rows.shape[:-2], len(structure.configurations), rows.shape[-1])
    found = np.zeros(shape, dtype=rows.dtype)
    for configuration, force in structure.contacts[contact].forces.items():
        found[..., configuration, :] = rows[..., force, :]
    return found


def acceleration_rows(structure: Structure, fields: np.ndarray, state: int) -> np.ndarray:
    """Rate (..., configurations, N + 1) of a velocity, which may be told by its position."""
    return np.asarray(fields[..., dict(structure.coordinates).get(state, state), :])


def observed_rows(structure: Structure, rows: np.ndarray) -> np.ndarray:
    """Affine functions (..., configurations, K, N + 1), from the rows (..., R, N + 1) of tables.

    They are the states, then force, velocity and surface of each contact, each ``n y + c``: n,
    then c.
    """
    size, count = len(structure.states), len(structure.configurations)
    width = size + 3 * len(structure.contacts)
    found = np.zeros((*rows.shape[:-2], count, width, size + 1), dtype=rows.dtype)
    found[..., :size, :] = np.eye(size, size + 1)
    for place, contact in enumerate(structure.contacts):
        at = size + 3 * place
        found[..., at, :] = force_rows(structure, rows, place)
        found[..., at + 1, :] = rows[..., None, contact.velocity, :]
        found[..., at + 2, :] = rows[..., None, contact.surface, :]
    return found
