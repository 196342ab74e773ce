"""Energy that impacts take along an orbit, with its complex steps.

An impulse J at a contact changes its relative velocity from w- to w+ = w- + J / m and takes the
energy m (w-^2 - w+^2) / 2. A system's tables know accelerations, not masses: the effective mass
m is minus the reaction that holds the contact in lasting contact, by the acceleration w' without
it. Both are affine functions of the state, and proportional to each other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.structure import ContactShape
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers
from nonsmooth.runtime.simulation.moved_phases import MovedPhases

__all__ = ["ImpactLoss", "impact_losses"]

_NEAR = 1e-9  # relative: within which two functions are proportional
_STILL = 1e-12  # relative change of a velocity that is none


class ImpactLoss(NamedTuple):
    """The energy that one impact takes."""

    phase: int  # the one that the impact ends
    contact: ContactShape
    energy: np.ndarray  # (q,), with a step in each of q directions


def impact_losses(cycle: ItineraryShape, moved: MovedPhases) -> Iterator[ImpactLoss]:
    """Yield the energy that each impact of an orbit takes from it, in double precision.

    `InputError` is raised for impacts at several stops at once, and where the tables do
    not tell the mass.
    """
    structure, rows = cycle.structure, moved.numbers.rows
    velocities = [velocity for _, velocity in structure.coordinates]
    for phase, configuration in enumerate(cycle.configurations):
        front, behind = moved.ends[:, phase], moved.starts[:, (phase + 1) % len(cycle)]
        jump = np.abs((behind - front)[0, velocities].real)
        if not (jump > _STILL * np.abs(front[0].real).max()).any():
            continue
        field = moved.numbers.fields[:, configuration]
        shapes = structure.boundaries[configuration]
        reached = [shapes[place] for place in sorted(cycle.transitions[phase].boundaries)]
        struck = []
        for boundary in reached:
            row, now = rows[0, boundary.row].real, rows[0].real
            rate = row[:-1] @ field[0].real
            struck += [
                contact
                for contact in structure.contacts
                if _proportional(rate, now[contact.velocity] - now[contact.surface])
                and any(
                    _proportional(row, now[held])
                    for lasting in contact.forces
                    for held in structure.constraints[lasting]
                )
            ]
        names = " and ".join(boundary.name for boundary in reached)
        if not struck:
            raise InputError(f"what is lost at {names} is not told: no contact is declared there")
        if len(struck) > 1:
            raise InputError(f"{names}: what each of several impacts at once takes is not told")
        (contact,) = struck
        relative = rows[:, contact.velocity] - rows[:, contact.surface]
        mass = _mass(moved.numbers, contact, configuration, relative)
        if mass is None:
            raise InputError(
                f"what is lost at {names} is not told: {contact.name} has no lasting contact that"
                " tells the mass which it stops"
            )
        speeds = [
            np.einsum("qi,qi->q", relative[:, :-1], state) + relative[:, -1]
            for state in (front, behind)
        ]
        yield ImpactLoss(phase, contact, mass * (speeds[0] ** 2 - speeds[1] ** 2) / 2)


def _proportional(row: np.ndarray, other: np.ndarray) -> bool:
    """Return whether one affine function is a nonzero multiple of another."""
    size = float(other @ other)
    factor = float(row @ other) / size if size else 0.0
    missed = np.abs(row - factor * other).max()
    return bool(factor and missed <= _NEAR * np.abs(row).max())


def _mass(
    numbers: Numbers, contact: ContactShape, source: int, relative: np.ndarray
) -> np.ndarray | None:
    """Return the effective mass (q,) at a contact, by its reaction in lasting contact.

    It is None where no lasting contact tells it.
    """
    field = numbers.fields[:, source]
    acceleration = np.einsum("qi,qij->qj", relative[:, :-1], field)
    for force in contact.forces.values():
        reaction = numbers.rows[:, force]
        size = (acceleration * acceleration).sum(axis=1)
        mass = -(reaction * acceleration).sum(axis=1) / size
        missed = np.abs(reaction + mass[:, None] * acceleration)[0].max()
        if mass[0].real > 0 and missed <= _NEAR * np.abs(reaction[0]).max():
            return np.asarray(mass)
    return None
