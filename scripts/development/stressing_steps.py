"""Whether each step of a motion follows from the one before, within the rounding of that step."""

from __future__ import annotations

import math

import numpy as np
from stressing import EPS, Ball, Sums, first_excess, undecided

from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.engine_run import Run
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.piecewise import PiecewiseLinear

_ALLOWED = 64 * EPS


def broken_step(system: PiecewiseLinear, run: Run, drift: float) -> str:
    """First step of a run that does not follow from the state before it; empty if all do.

    The system's doubles count as exact. Errors may grow by the factor `drift` of the radians
    that passed; 0 allows none.
    """
    for k in range(1, len(run.times) + 1):
        last = k == len(run.times)
        end = run.end if last else run.times[k]
        fault = _crossed(system, run, k, float(end), drift, last)
        if not fault and not last:
            fault = _followed(system, run, k, drift)
        if fault:
            return f"step {k}: {fault}"
    return ""


def _sums(system: PiecewiseLinear, c: int, state: np.ndarray) -> tuple[Sums, np.ndarray]:
    """Boundary functions of a configuration from a state, and the sizes of their terms."""
    structure, flow = system.structure, system.flows[c]
    extended = np.append(state, 1.0)
    rows = system.rows[[b.row for b in structure.boundaries[c]]]
    parts = rows[:, None, :-1, None] * flow[None] * extended
    values, sizes = parts.sum(axis=(2, 3)), np.abs(parts).sum(axis=(1, 2, 3))
    values[:, 0] += rows[:, -1]
    shape = tuple((mode.length, mode.oscillates) for mode in structure.modes[c])
    exponents = np.broadcast_to(system.exponents[c], (len(rows), len(shape), 2))
    return Sums(shape, np.array(exponents, dtype=float), values), sizes + np.abs(rows[:, -1])


def _errors(sums: Sums, sizes: np.ndarray, time: float, drift: float) -> np.ndarray:
    every = np.full(len(sizes), time)
    radians = sums.fastest * time
    return _ALLOWED * (1 + drift * radians / 64) * (sizes + sums.bound(every, every))


def _crossed(
    system: PiecewiseLinear, run: Run, k: int, end: float, drift: float, last: bool
) -> str:
    """What is wrong with the boundaries of a step: crossed unseen, or not reached; else empty."""
    c, state = int(run.configurations[k - 1]), run.states[k - 1]
    sums, sizes = _sums(system, c, state)
    dwell, names = end - run.times[k - 1], system.structure.boundaries[c]
    if not len(sizes):
        return ""
    ends = np.full(len(sizes), dwell)
    allowed = _errors(sums, sizes, dwell, drift)
    rates = np.abs(sums.derivative().at(ends))
    allowed_at_end = allowed + 8 * EPS * end * rates
    samples = 40 + math.ceil(4 * float(sums.fastest.max()) * dwell)
    for index, low, high in undecided(sums, ends, allowed_at_end, samples):
        b = int(index)
        ball = Ball(sums.shape, sums.exponents[b], sums.values[b])
        try:
            where = first_excess(ball, float(low), float(high), float(allowed_at_end[b]))
        except RuntimeError:
            continue
        if where is not None:
            return f"{names[b].name} exceeded by {sums.at(ends * 0 + where)[b]:.1e} at {where!r}"
    if last:
        return ""
    for b in range(len(names)):
        if not run.sets[k] >> b & 1:
            continue
        from flint import arb

        value = abs(float(Ball(sums.shape, sums.exponents[b], sums.values[b]).at(arb(dwell)).mid()))
        if value > 4 * allowed_at_end[b]:
            return f"{names[b].name} not reached, {value:.1e} off"
    return ""


def _followed(system: PiecewiseLinear, run: Run, k: int, drift: float) -> str:
    """What is wrong with the state and configuration behind a step; else empty."""
    structure, c = system.structure, int(run.configurations[k - 1])
    reached, target = int(run.sets[k]), int(run.configurations[k])
    dwell = run.times[k] - run.times[k - 1]
    before = flow_states(system, c, np.array([dwell]), run.states[k - 1])[0]
    scale = np.abs(run.states[k - 1]).max() + np.abs(before).max() + 1
    radians = 1 + float(np.hypot(*system.exponents[c].T).max()) * float(run.times[k])
    if np.abs(before - run.before[k]).max() > 1e-12 * scale * radians:
        return f"the state is off by {np.abs(before - run.before[k]).max():.1e}"
    extended = np.append(run.before[k], 1.0)
    error = _time_error(system, run, k, dwell, drift)
    rows = {structure.boundaries[c][b].row for b in members_of(reached)}
    possible = []
    for transition in structure.transitions[c]:
        if sum(1 << b for b in transition.boundaries) != reached:
            continue
        met = [
            holds in _signs(system, row, along, extended, error, row in rows)
            for row, along, holds in transition.conditions
        ]
        if not all(met):
            continue
        possible.append(transition)
        if all(
            len(_signs(system, row, along, extended, error, row in rows)) == 1
            for row, along, _ in transition.conditions
        ):
            break
    for transition in possible:
        matrix = system.resets[transition.reset]
        after = matrix @ extended
        if transition.target == target and np.allclose(after, run.states[k], 1e-12, 1e-14 * scale):
            return ""
    return f"{structure.configurations[target]} does not follow by {reached}"


def _time_error(system: PiecewiseLinear, run: Run, k: int, dwell: float, drift: float) -> float:
    """Error of an event's time that the rounding of its boundary function allows."""
    sums, sizes = _sums(system, int(run.configurations[k - 1]), run.states[k - 1])
    at = np.full(len(sizes), dwell)
    slope = sums.derivative()
    rates, curves = np.abs(slope.at(at)), slope.derivative().bound(at, at)
    allowed = 4 * _errors(sums, sizes, dwell, drift)
    with np.errstate(divide="ignore"):
        errors = np.minimum(allowed / rates, np.sqrt(4 * allowed / curves))
    inside = [b for b in range(len(sizes)) if run.sets[k] >> b & 1]
    return float(errors[inside].max()) + 8 * EPS * float(run.times[k])


def _signs(
    system: PiecewiseLinear,
    row: int,
    along: int,
    extended: np.ndarray,
    time_error: float,
    located: bool,
) -> set[bool]:
    """Possible verdicts on whether the first nonzero derivative is positive."""
    n = len(extended) - 1
    matrix = np.vstack([system.fields[along], np.zeros(n + 1)])
    function, bound, size = system.rows[row], np.abs(system.rows[row]), np.abs(extended)
    found: set[bool] = set()
    for order in range(n + 1):
        value, rounding = float(function @ extended), _ALLOWED * float(bound @ size)
        function, bound = function @ matrix, bound @ np.abs(matrix)
        if order == 0 and located:
            continue
        if abs(value) > rounding + time_error * abs(float(function @ extended)):
            return {*found, value > 0}
        # it may be zero, or of either sign
        if value != 0:
            found |= {True, False}
    return {*found, False}
