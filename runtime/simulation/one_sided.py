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
from nonsmooth.runtime.simulation.motion_linearisation import MotionLinearisation
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.simulation.transition_derivatives import extended, field_at

__all__ = ["CUT", "check_sides"]

CUT = (Status.UNDECLARED, Status.IMMEDIATE, Status.OVERFLOW, Status.AMBIGUOUS)
_TOGETHER = 1e-9  # by which linearised boundary functions may differ that vanish together
_ERROR = 64 * np.finfo(float).eps


class _Touch(NamedTuple):
    """What is touched, and when; of a boundary function its row, of a transition its number."""

    told: str
    time: float
    row: int | None
    transition: int = 0


def check_sides(
    trajectory: Trajectory, by: tuple[str, ...], times: np.ndarray, one_sided: str | None
) -> None:
    """Raise InputError unless a motion has the derivatives that are asked for.

    Parameters
    ----------
    trajectory : Trajectory
    by : tuple of str
    times : array (m,)
        Held fixed.
    one_sided : {"+", "-"} or None

    Raises
    ------
    InputError
        Names what is touched, when, and by which number it is passed.
    """
    if one_sided not in (None, "+", "-"):
        raise InputError(f"one_sided is {one_sided!r}, neither '+' nor '-'")
    for time in times.tolist():
        if trajectory.status in CUT and abs(time - trajectory.end) <= 8 * np.spacing(time):
            raise InputError(
                f"the motion ends at t = {trajectory.end!r}: {trajectory.message};"
                " it has no derivative there"
            )
    touches = [*_grazings(trajectory), *_beginnings(trajectory), *_coincidences(trajectory, times)]
    sets = trajectory.run.sets
    if not touches and not (sets & (sets - 1)).any():
        return
    at = np.array([touch.time for touch in touches])
    linearisation = MotionLinearisation(trajectory, at)
    tables, starts = linearisation.directions(by)
    states, events, before, _ = linearisation.forward(tables, starts)
    sign = {None: 0.0, "+": 1.0, "-": -1.0}[one_sided]
    smooth = linearisation.transitions.smooth
    _check_together(linearisation, by, tables.rows, events, before)
    for touch, change, state in zip(touches, states, trajectory(at), strict=True):
        if touch.row is None:
            rises = np.where(smooth[touch.transition], 0.0, events[touch.transition])
        else:
            row = trajectory.system.rows[touch.row]
            rises = row[:-1] @ change + tables.rows[:, touch.row] @ extended(state)
        wrong = np.flatnonzero(rises if one_sided is None else sign * rises > 0)
        if wrong.size:
            name, what = by[wrong[0]], "derivative"
            if one_sided is not None:
                what = f"derivative on the side {one_sided}"
            raise InputError(
                f"{touch.told} at t = {touch.time!r}: the motion has no {what} by {name} there"
            )


def _check_together(
    linearisation: MotionLinearisation,
    by: tuple[str, ...],
    rows: np.ndarray,
    events: np.ndarray,
    before: np.ndarray,
) -> None:
    """Refuse boundaries that are reached together unless they stay together."""
    trajectory = linearisation.trajectory
    system, run = trajectory.system, trajectory.run
    for entry in np.flatnonzero(run.sets & (run.sets - 1)).tolist():
        shapes = system.structure.boundaries[int(run.configurations[entry - 1])]
        state = extended(run.before[entry])
        for place, shape in enumerate(shapes):
            if not int(run.sets[entry]) >> place & 1:
                continue
            row = system.rows[shape.row]
            parts = row[:-1, None] * before[entry], rows[:, shape.row].T * state[:, None]
            size = sum(np.abs(part).sum(axis=0) for part in parts)
            size = size + np.abs(row[:-1]) @ np.abs(linearisation.transitions.velocities[entry - 1])
            left = np.abs(sum(part.sum(axis=0) for part in parts))
            apart = np.flatnonzero(left > _TOGETHER * size * max(1.0, np.abs(events).max()))
            if apart.size:
                raise InputError(
                    f"{' and '.join(trajectory.boundaries[entry])} are reached together"
                    f" at t = {float(run.times[entry])!r}: the motion has no derivative by"
                    f" {by[apart[0]]} there"
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
    events = trajectory.times[1:]
    for time in times.tolist():
        for place in np.flatnonzero(np.abs(events - time) <= 8 * np.spacing(time)).tolist():
            told = f"{' and '.join(trajectory.boundaries[place + 1])} is reached"
            yield _Touch(told, time, None, place)


def _smooth(system: PiecewiseLinear, configuration: int, boundary: int, state: np.ndarray) -> bool:
    """Whether the field goes on continuously behind a boundary, and no reset moves the state."""
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
