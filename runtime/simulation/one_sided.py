"""Where a motion has one-sided derivatives alone, and on which side it is differentiated.

At a grazing, at a start on a boundary and at a time that is that of a transition the motion goes
on smoothly on one side: where the touched boundary function falls, or the transition comes
earlier. What a number does not move has a derivative all the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.coming_apart import DirectedMotion, told_direction
from nonsmooth.runtime.simulation.motion_linearisation import turned
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.simulation.transition_derivatives import extended, field_at

__all__ = ["CUT", "check_sides", "check_times"]

CUT = (Status.UNDECLARED, Status.IMMEDIATE, Status.OVERFLOW, Status.AMBIGUOUS)
_ERROR = 64 * np.finfo(float).eps


class _Touch(NamedTuple):
    """A boundary that is touched, and when: with its row, or with the transition's index."""

    told: str
    time: float
    row: int | None
    transition: int = 0


def check_times(trajectory: Trajectory, times: np.ndarray, one_sided: str | None) -> None:
    """Raise `InputError` for an unknown side, or for a time at which the motion breaks off.

    The times (m,) are held fixed.
    """
    if one_sided not in (None, "+", "-"):
        raise InputError(f"one_sided is {one_sided!r}, neither '+' nor '-'")
    last = np.abs(times - trajectory.end) <= 8 * np.spacing(times)
    if trajectory.status in CUT and last.any():
        raise InputError(
            f"the motion ends at t = {trajectory.end!r}: {trajectory.message};"
            " it has no derivative there"
        )


def check_sides(
    motion: DirectedMotion,
    by: tuple[str, ...],
    directions: np.ndarray,
    times: np.ndarray,
    one_sided: str | None,
) -> None:
    """Raise `InputError` unless a motion has the derivatives that are asked for.

    The motion holds for its columns of `directions` (numbers, q); the times (m,) are held
    fixed. The message names what is touched, when, and by which number it is passed.
    """
    trajectory = motion.trajectory
    touches = [*_grazings(trajectory), *_beginnings(trajectory), *_coincidences(trajectory, times)]
    if not touches:
        return
    own = directions[:, motion.columns]
    at = np.array([touch.time for touch in touches])
    linearisation = motion.linearisation(at)
    tables, starts = turned(*linearisation.directions(by), own)
    changes = linearisation.forward(tables, starts)
    sign = {None: 0.0, "+": 1.0, "-": -1.0}[one_sided]
    smooth = linearisation.transitions.smooth
    for touch, change, state in zip(touches, changes.states, trajectory(at), strict=True):
        if touch.row is None:
            rises = changes.event_times[touch.transition]
            rises = np.where(smooth[touch.transition], 0.0, rises)
        else:
            row = trajectory.system.rows[touch.row]
            rises = row[:-1] @ change + tables.rows[:, touch.row] @ extended(state)
        wrong = np.flatnonzero(rises if one_sided is None else sign * rises > 0)
        if wrong.size:
            label, what = told_direction(by, own[:, wrong[0]]), "derivative"
            if one_sided is not None:
                what = f"derivative on the side {one_sided}"
            raise InputError(
                f"{touch.told} at t = {touch.time!r}: the motion has no {what} by {label} there"
            )


def _grazings(trajectory: Trajectory) -> Iterator[_Touch]:
    for grazing in trajectory.grazings:
        state = trajectory(grazing.time)
        if not _smooth(trajectory.system, grazing.configuration, grazing.boundary, state):
            shape = trajectory.structure.boundaries[grazing.configuration][grazing.boundary]
            yield _Touch(f"{shape.name} is reached tangentially", grazing.time, shape.row)


def _beginnings(trajectory: Trajectory) -> Iterator[_Touch]:
    configuration, state = int(trajectory.run.configurations[0]), trajectory.states[0]
    for place, shape in enumerate(trajectory.structure.boundaries[configuration]):
        row = trajectory.system.rows[shape.row]
        error = _ERROR * (np.abs(row) @ extended(np.abs(state)))
        here = abs(row @ extended(state)) <= error
        if here and not _smooth(trajectory.system, configuration, place, state):
            yield _Touch(f"the start lies on {shape.name}", 0.0, shape.row)


def _coincidences(trajectory: Trajectory, times: np.ndarray) -> Iterator[_Touch]:
    events, near = trajectory.times[1:], 8 * np.spacing(times)
    first = np.searchsorted(events, times - near)
    behind = np.searchsorted(events, times + near, side="right")
    for which in np.flatnonzero(first < behind).tolist():
        for place in range(int(first[which]), int(behind[which])):
            told = f"{' and '.join(trajectory.boundaries[place + 1])} is reached"
            yield _Touch(told, float(times[which]), None, place)


def _smooth(system: PiecewiseLinear, configuration: int, boundary: int, state: np.ndarray) -> bool:
    """Whether the field is continuous across a boundary, and no reset moves the state."""
    found = system.structure.listed(configuration, frozenset({boundary}))
    velocity = field_at(system, configuration, state)
    size = np.abs(system.fields[configuration]) @ extended(np.abs(state))
    for transition in found:
        after = system.resets[transition.reset] @ extended(state)
        jump = field_at(system, transition.target, after) - velocity
        bound = size + np.abs(system.fields[transition.target]) @ extended(np.abs(after))
        if (np.abs(jump) > _ERROR * bound).any():
            return False
        if (np.abs(after - state) > _ERROR * np.abs(state)).any():
            return False
    return bool(found)
