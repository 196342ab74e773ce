"""What a motion says of the measurements at a point of the unknowns, with exact derivatives.

The clock of the data shows `offset` when the motion starts. Outputs are taken at fixed times of
the clock. Events are matched by their order: the n-th recorded time of a boundary belongs to the
n-th time at which the motion reaches it, a blank standing for one that was not recorded. Where a
motion does not come that far, or has no derivative, as where it grazes a boundary, there is no
prediction: a search takes a shorter step.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.explore.fitting.measurements import Measured, MeasuredSeries
from nonsmooth.runtime.explore.fitting.outputs import Output, output_of
from nonsmooth.runtime.explore.fitting.unknowns import MotionSettings, Unknowns
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory

_LONGER = (1.0, 1.25, 2.0, 4.0)  # times as long as the record, while recorded events are missing
_PAST = 1e-9  # of its length, beyond the last time
_AT_ONCE = 1e-12  # of the motion: a sample that an event comes so near to is at the event
_JUMP = 1e-9  # of the values on both sides


@dataclass(frozen=True, eq=False)
class Prediction:
    """What one experiment is predicted to measure at one point of the unknowns."""

    values: tuple[np.ndarray, ...]  # (m,) for each series, on the clock of the data
    jacobians: tuple[np.ndarray, ...]  # (m, q) for each series, by all unknowns
    motion: Trajectory | None = None  # None for steady responses
    # of steady responses, one for each row, with derivatives by the free parameters
    orbits: tuple[OrbitDerivatives, ...] = ()


def predict(
    kernels: SystemKernels,
    experiment: Measured,
    unknowns: Unknowns,
    number: int,
    point: np.ndarray,
) -> Prediction:
    """The prediction for an experiment with a motion, at a point (q,) of the unknowns.

    The derivatives are exact. `number` is that of the experiment, from 0. Raises
    `NonsmoothError` if the motion does not exist, is too short, or has no derivative.
    """
    condition = unknowns.condition(point, number)
    motion = _motion_under(kernels, experiment, condition)
    outputs = {
        series.name: output_of(series.expression, motion.structure)
        for series in experiment.series
        if series.kind == "output"
    }
    sampled = [series for series in experiment.series if series.name in outputs]
    clocks = np.unique(np.concatenate([np.empty(0), *(series.times for series in sampled)]))
    times = np.minimum(clocks - condition.offset, motion.end)
    columns, clock = unknowns.columns(number), unknowns.clock(number)
    by, free = [*columns], [*columns.values()]
    for series in sampled:
        own = times[np.searchsorted(clocks, series.times)]
        _check_jumps(experiment, series, outputs[series.name], motion, own)
    states = motion(times)
    derivatives = motion.derivatives(by, times=times) if by else None
    if derivatives is not None:
        stepped_states = stepped(states, np.moveaxis(derivatives.states, -1, 0), None)
    phases = np.searchsorted(motion.times, times, side="right") - 1
    fields = motion.system.fields[motion.run.configurations[phases]]
    rates = np.einsum("mij,mj->mi", fields[..., :-1], states) + fields[..., -1]
    extended = np.concatenate([states, np.ones((len(times), 1))], axis=1)
    values, jacobians = [], []
    for series in experiment.series:
        jacobian = np.zeros((len(series.values), len(point)))
        if series.kind == "output":
            places = np.searchsorted(clocks, series.times)
            output = outputs[series.name]
            where = motion.run.configurations[phases[places]]
            rows = _rows(output, motion)[where]
            values.append(np.einsum("mn,mn->m", rows, extended[places]))
            if derivatives is not None:
                fields, moved, _ = derivatives.numbers[:3]
                own = output.in_configurations(motion.structure, fields, moved)[:, where]
                found = (own[..., :-1] * stepped_states[:, places]).sum(axis=-1) + own[..., -1]
                jacobian[:, free] = imaginary_parts(found, None).T
            if clock is not None:
                jacobian[:, clock] = -np.einsum("mn,mn->m", rows[:, :-1], rates[places])
        else:
            reached = times_of_events(motion, series.expression)[series.places]
            values.append(condition.offset + motion.times[reached])
            if derivatives is not None:
                jacobian[:, free] = derivatives.event_times[reached - 1]
            if clock is not None:
                jacobian[:, clock] = 1.0
        if not (np.isfinite(values[-1]).all() and np.isfinite(jacobian).all()):
            raise NoConvergence(f"{experiment.name}: the motion is not finite")
        jacobians.append(jacobian)
    return Prediction(tuple(values), tuple(jacobians), motion)


def _motion_under(
    kernels: SystemKernels, experiment: Measured, condition: MotionSettings
) -> Trajectory:
    """The motion of an experiment, as far as it was recorded.

    Raises `NonsmoothError` if the motion does not exist, ends before the data, or reaches a
    boundary less often.
    """
    length = experiment.last - condition.offset
    if not length > 0:
        raise InputError(f"{experiment.name}: all data are before the motion starts")
    if experiment.first < condition.offset:
        raise InputError(
            f"{experiment.name}: data at {experiment.first:.12g} are before the motion starts,"
            f" at {condition.offset:.12g}"
        )
    wanted: MeasuredSeries | None = None
    events = [series for series in experiment.series if series.kind == "event"]
    for factor in _LONGER if events else _LONGER[:1]:
        until = length * (factor + _PAST)
        motion = simulate_one(kernels, condition.parameters, condition.start, until=until)
        needed = length if len(events) < len(experiment.series) else 0.0
        if motion.end < needed:
            raise NoConvergence(
                f"{experiment.name}: the motion ends at {motion.end:.6g}, before the data do:"
                f" {motion.message}"
            )
        wanted = next((each for each in events if _lacks(motion, each)), None)
        if wanted is None:
            return motion
    assert wanted is not None
    count, found = int(wanted.places[-1]) + 1, len(times_of_events(motion, wanted.expression))
    raise NoConvergence(
        f"{experiment.name}: the motion comes to {wanted.expression} {found} times until"
        f" {motion.end:.6g}, where {count} are recorded"
    )


def times_of_events(motion: Trajectory, boundary: str) -> np.ndarray:
    """Places (n,) among a motion's times at which it reaches a boundary."""
    return np.array([i for i, names in enumerate(motion.boundaries) if boundary in names], int)


def _lacks(motion: Trajectory, series: MeasuredSeries) -> bool:
    return len(times_of_events(motion, series.expression)) <= int(series.places[-1])


def _rows(output: Output, motion: Trajectory) -> np.ndarray:
    """An output in each configuration, (configurations, N + 1)."""
    system = motion.system
    return output.in_configurations(motion.structure, system.fields, system.rows)


def _check_jumps(
    experiment: Measured,
    series: MeasuredSeries,
    output: Output,
    motion: Trajectory,
    times: np.ndarray,
) -> None:
    """Refuse a sample at exactly the time of an event at which the output jumps."""
    rows, run = _rows(output, motion), motion.run
    near = _AT_ONCE * motion.end
    firsts = np.searchsorted(motion.times[1:], times - near) + 1
    for entry, time, clock in zip(
        firsts.tolist(), (times + near).tolist(), series.times.tolist(), strict=True
    ):
        if entry >= len(motion.times) or motion.times[entry] > time:
            continue
        sides = [
            rows[int(run.configurations[place])] @ np.append(state, 1.0)
            for place, state in ((entry - 1, run.before[entry]), (entry, run.states[entry]))
        ]
        if abs(sides[1] - sides[0]) > _JUMP * max(map(abs, sides)):
            raise NoConvergence(
                f"{experiment.name}: {series.name} jumps at {clock:.12g}, at"
                f" {' and '.join(motion.boundaries[entry])}: leave out what was measured there"
            )
