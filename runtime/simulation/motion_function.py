"""A simulated motion as a function of parameters and start, with its exact derivatives."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, chosen_names, unknown_name
from nonsmooth.runtime.core.values import real_array
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.motion_linearisation import input_names, nearest_start
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory


def motion_function(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    start: Mapping[str, object] | Sequence[object],
    configuration: str | None = None,
    *,
    by: Sequence[str],
    times: Any = None,
    outputs: Sequence[str] | Mapping[str, Mapping[str, float]] | None = None,
    until: float = math.inf,
    transitions: int | None = None,
) -> DifferentiableFunction:
    """Give what a motion does as a function of some of its parameters and of its start.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters.
    start : mapping of str to number, or sequence (N,)
        Positions, then velocities.
    configuration : str, optional
        Where it starts; found when omitted. A start on its constraints stays on them.
    by : sequence of str
        The numbers: parameters, and states at the start (``x10`` is that of ``x1``).
    times : array (m,), optional
        When the outputs are read; without them the outputs are the times of transitions.
    outputs : sequence of str, or mapping of str to mapping, optional
        States, or affine functions of them by name: ``{"gap": {"x1": 1, "x2": -1, "1": 0.5}}``
        is x1 - x2 + 0.5. All states when omitted.
    until : float
        Time until which transitions are looked for; not needed with `times`.
    transitions : int, optional
        How many transitions are followed, where their times are the outputs.

    Returns
    -------
    DifferentiableFunction
        Outputs are named ``x1@0.5``, time after time, or ``event1``, ``event2``, ...
        NaN where there is no such motion; derivatives alone where it has none.

    Raises
    ------
    InputError
        For wrong names, numbers or times, or a motion that cannot be followed so far.

    Examples
    --------
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> found = motion_function("rigid-stop", data, [0, 0, 1.5, 0], by=["r"], transitions=2)
    >>> found.outputs, found.jacobian([0.5]).shape
    (('event1', 'event2'), (2, 1))
    """
    wanted = None if times is None else np.atleast_1d(real_array("times", times))
    if wanted is None:
        end, most = until, transitions
    else:
        if not (wanted.size and np.isfinite(wanted).all() and (wanted >= 0).all()):
            raise InputError("the times are no numbers from 0 on")
        end, most = float(wanted.max()), None

    def follow(values: Mapping[str, object], state: Any) -> Trajectory:
        return simulate_one(system, values, state, configuration, until=end, transitions=most)

    nominal = follow(parameters, start)
    names, starts = input_names(nominal)
    inputs = chosen_names("parameter or start", by, (*names, *starts))
    given = {name: float(value) for name, value in nominal.parameters.items()}
    given |= dict(zip(starts, nominal.states[0].tolist(), strict=True))
    first = int(nominal.run.configurations[0])
    bound = bool(nominal.structure.constraints[first])
    entry = nominal.configurations[0] if bound else configuration
    turned = any(starts[place] in inputs for place in nominal.structure.forced)
    if wanted is None:
        count = nominal.transitions
        if not count:
            raise InputError("the motion has no transition whose time could be an output")
        labels = tuple(f"event{k + 1}" for k in range(count))
        rows = np.empty((0, len(starts) + 1))
    else:
        if nominal.end < end:
            raise InputError(f"the motion ends at t = {nominal.end!r}: {nominal.message}")
        named, rows = _affine(nominal.names, outputs)
        labels = tuple(f"{name}@{time:g}" for time in wanted.tolist() for name in named)

    def motion(x: np.ndarray) -> Trajectory:
        values = given | dict(zip(inputs, x.tolist(), strict=True))
        own = {name: values[name] if name in inputs else parameters[name] for name in names}
        state = np.array([values[name] for name in starts])
        if bound or turned:
            state = nearest_start(piecewise(system, own), first, state)
        return simulate_one(system, own, state.tolist(), entry, until=end, transitions=most)

    def read(found: Trajectory) -> np.ndarray:
        if wanted is None:
            if found.transitions < len(labels):
                raise InputError("the motion has too few transitions")
            return found.times[1 : len(labels) + 1]
        if found.end < end:
            raise InputError(f"the motion ends at t = {found.end!r}: {found.message}")
        return np.asarray(found(wanted) @ rows[:, :-1].T + rows[:, -1]).ravel()

    def evaluate(points: np.ndarray) -> np.ndarray:
        values = np.full((len(points), len(labels)), np.nan)
        for place, point in enumerate(points):
            with suppress(InputError):
                values[place] = read(motion(point))
        return values

    def differentiate(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = np.full((len(points), len(labels)), np.nan)
        jacobians = np.full((len(points), len(labels), len(inputs)), np.nan)
        for place, point in enumerate(points):
            with suppress(InputError):
                found = motion(point)
                values[place] = read(found)
                changes = found.derivatives(inputs, times=wanted)
                if wanted is None:
                    jacobians[place] = changes.event_times[: len(labels)]
                else:
                    jacobians[place] = (rows[:, :-1] @ changes.states).reshape(-1, len(inputs))
        return values, jacobians

    def pull(points: np.ndarray, cotangents: np.ndarray) -> np.ndarray:
        gradients = np.full(points.shape, np.nan)
        for place, (point, factors) in enumerate(zip(points, cotangents, strict=True)):
            with suppress(InputError):
                found = motion(point)
                read(found)
                changes = found.derivatives(inputs, times=wanted)
                if wanted is None:
                    padded = np.zeros(found.transitions)
                    padded[: len(factors)] = factors
                    gradients[place] = changes.vjp(event_times=padded)
                else:
                    states = factors.reshape(len(wanted), -1) @ rows[:, :-1]
                    gradients[place] = changes.vjp(states=states)
        return gradients

    reference = np.array([given[name] for name in inputs])
    return DifferentiableFunction(inputs, labels, reference, evaluate, differentiate, pull)


def _affine(
    states: tuple[str, ...], outputs: Sequence[str] | Mapping[str, Mapping[str, float]] | None
) -> tuple[tuple[str, ...], np.ndarray]:
    """Names of the outputs, and their rows (K, N + 1) as affine functions of the state."""
    if outputs is None:
        outputs = states
    if isinstance(outputs, str):
        outputs = (outputs,)
    if not isinstance(outputs, Mapping):
        outputs = {name: {name: 1.0} for name in outputs}
    rows = np.zeros((len(outputs), len(states) + 1))
    for row, weights in zip(rows, outputs.values(), strict=True):
        for name, factor in weights.items():
            if name != "1" and name not in states:
                raise unknown_name("state", str(name), states)
            row[len(states) if name == "1" else states.index(name)] = factor
    return tuple(outputs), rows
