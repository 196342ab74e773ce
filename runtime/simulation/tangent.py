"""Derivatives of a motion by its start.

Along a phase a perturbation is carried by the flow's matrix, through a transition by the
saltation matrix. Both map the motion's own direction to itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.flows import functions_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.simulation.transition_derivatives import transitions_behind

__all__ = [
    "TangentPhase",
    "earliest_entry",
    "flow_matrix",
    "tangent_phases",
]


class TangentPhase(NamedTuple):
    """One phase of a motion, with the saltation matrix (N, N) at its end if there is one."""

    begin: float
    duration: float
    configuration: int
    start: np.ndarray
    saltation: np.ndarray | None


def tangent_phases(trajectory: Trajectory, first: int, since: float) -> Iterator[TangentPhase]:
    """Yield the phases of a motion from entry `first` on, with their saltation matrices.

    Grazings up to the time `since` do not matter. An `InputError` is raised if the motion
    has no derivative: behind the entry two boundaries are reached at once, or one is
    touched behind `since`.
    """
    run = trajectory.run
    for grazing in run.grazings:
        if grazing.time > since:
            raise InputError(f"a boundary is reached tangentially at t = {grazing.time!r}")
    saltations = _saltation_matrices(trajectory, first)
    durations = np.diff(run.times[first:], append=trajectory.end)
    for place, duration in enumerate(durations.tolist()):
        entry = first + place
        yield TangentPhase(
            float(run.times[entry]),
            duration,
            int(run.configurations[entry]),
            run.states[entry],
            saltations[place] if place < len(saltations) else None,
        )


def earliest_entry(trajectory: Trajectory, since: float) -> int:
    """Index of the earliest entry from which on the motion has a derivative up to time `since`."""
    sets = trajectory.run.sets
    times = [
        0.0,
        *(g.time for g in trajectory.grazings),
        *trajectory.times[(sets & (sets - 1)) != 0].tolist(),
    ]
    before = max(time for time in times if time <= since)
    return min(int(np.searchsorted(trajectory.times, before)), _latest_entry(trajectory, since))


def _latest_entry(trajectory: Trajectory, since: float) -> int:
    return int(np.searchsorted(trajectory.times, since, side="right")) - 1


def flow_matrix(system: PiecewiseLinear, configuration: int, duration: float) -> np.ndarray:
    """Derivative (N, N) of the state after a duration by the state at its beginning."""
    functions = functions_of(system, configuration, np.array([duration]))[0]
    flows = system.flows[configuration]
    if isinstance(flows, FactoredFlows):
        return flows.at(functions)[:, :-1]
    return np.asarray(np.tensordot(functions, flows[:, :, :-1], axes=1))


def _saltation_matrices(trajectory: Trajectory, first: int) -> np.ndarray:
    """Saltation matrices (n, N, N) of the transitions behind entry `first`."""
    system, found = trajectory.system, transitions_behind(trajectory, first)
    linear = system.resets[found.resets][..., :-1]
    with np.errstate(divide="ignore", invalid="ignore"):  # of what is smooth
        rates = system.rows[found.rows][..., :-1] / found.speeds[:, None]
        sudden = linear + found.jumps[..., None] * rates[:, None]
    return np.asarray(np.where(found.smooth[:, None, None], linear, sudden))
