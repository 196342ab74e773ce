"""A motion's phases and transitions, linearised once for all directions, and both passes."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.table_derivatives import TableDerivatives, table_derivatives
from nonsmooth.runtime.simulation.flow_derivatives import ConfigurationFlows, configuration_flows
from nonsmooth.runtime.simulation.start_derivatives import allowed_changes, following_changes
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.simulation.transition_derivatives import Transitions, transitions_behind

__all__ = ["MotionLinearisation", "input_names"]


class MotionLinearisation:
    """A motion's phases, transitions and tables, linearised once for all directions."""

    def __init__(self, trajectory: Trajectory, times: np.ndarray) -> None:
        self.trajectory, self.times = trajectory, times
        run, count = trajectory.run, len(trajectory.times)
        self.transitions: Transitions = transitions_behind(trajectory)
        phases = np.searchsorted(run.times, times, side="right") - 1
        # phases up to their transitions, then those of the times
        self.phases = np.concatenate([np.arange(count - 1), phases])
        durations = np.concatenate([np.diff(run.times), times - run.times[phases]])
        self.groups: list[tuple[int, np.ndarray, ConfigurationFlows]] = list(
            configuration_flows(
                trajectory.system,
                run.configurations[self.phases].astype(int),
                durations,
                run.states[self.phases],
            )
        )
        size = len(trajectory.names)
        self.matrices = np.empty((len(self.phases), size, size))
        for _, places, flows in self.groups:
            self.matrices[places] = flows.matrices

    @property
    def kernels(self) -> SystemKernels:
        """Kernels of the motion's system."""
        found = self.trajectory.structure.kernels
        assert found is not None
        return found

    def directions(self, by: tuple[str, ...]) -> tuple[TableDerivatives, np.ndarray]:
        """Changes of the tables (q, ...) and of the start (N, q) by numbers."""
        system, run = self.trajectory.system, self.trajectory.run
        point = np.array([float(value) for value in system.parameters.values()])
        names, starts = input_names(self.trajectory)
        tables = table_derivatives(self.kernels, point)
        configuration, start = int(run.configurations[0]), run.states[0]
        moved = following_changes(system, configuration, start, tables.rows)
        allowed = allowed_changes(system, configuration, start)
        columns = dict(zip((*names, *starts), np.hstack([moved, allowed]).T, strict=True))
        places = [names.index(name) if name in names else len(names) for name in by]
        padded = TableDerivatives(
            *(np.concatenate([part, np.zeros_like(part[:1])])[places] for part in tables)
        )
        return padded, np.array([columns[name] for name in by]).reshape(len(by), -1).T

    @cached_property
    def saltations(self) -> tuple[np.ndarray, np.ndarray]:
        """Derivatives of transitions by what is in front: (n - 1, N, N), and (n - 1, N) by rows.

        The second is what a change of the boundary function adds.
        """
        system, found = self.trajectory.system, self.transitions
        sudden = ~found.smooth
        late = np.zeros_like(found.jumps)
        late[sudden] = found.jumps[sudden] / found.speeds[sudden, None]
        slopes = system.rows[found.rows][:, None, :-1]
        return system.resets[found.resets][..., :-1] + late[..., None] * slopes, late

    def forward(self, tables: TableDerivatives, starts: np.ndarray) -> tuple[np.ndarray, ...]:
        """Derivatives of states, times of transitions, and states on both sides of these."""
        trajectory, found = self.trajectory, self.transitions
        count, (size, q) = len(trajectory.times), starts.shape
        added = np.empty((len(self.phases), size, q))
        for configuration, places, flows in self.groups:
            added[places] = flows.changes(tables.fields[:, configuration])
        moved = _along(tables.rows, found.rows, found.before)
        reset = _along(tables.resets, found.resets, found.before)
        saltations, late = self.saltations
        inside = slice(0, count - 1)
        steps = saltations @ self.matrices[inside]
        offsets = saltations @ added[inside] + reset + late[..., None] * moved[:, None]
        # at the fixed times of the transitions
        beginnings = np.empty((count, size, q))
        beginnings[0] = starts
        for k in range(count - 1):
            np.matmul(steps[k], beginnings[k], out=beginnings[k + 1])
            beginnings[k + 1] += offsets[k]
        ends = self.matrices[inside] @ beginnings[:-1] + added[inside]
        slopes = trajectory.system.rows[found.rows][:, None, :-1]
        with np.errstate(divide="ignore", invalid="ignore"):
            events = ((slopes @ ends)[:, 0] + moved) / -found.speeds[:, None]
        events[found.smooth & (found.speeds == 0)] = np.nan
        before, after = beginnings.copy(), beginnings.copy()
        before[1:] = ends + found.velocities[..., None] * events[:, None]
        after[1:] += found.behind[..., None] * events[:, None]
        own = self.phases[count - 1 :]
        states = self.matrices[count - 1 :] @ beginnings[own] + added[count - 1 :]
        return states, events, before, after

    def reverse(
        self, states: np.ndarray, event_times: np.ndarray, before: np.ndarray, behind: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Gradients of a combination by fields, rows, resets and the start."""
        trajectory, found = self.trajectory, self.transitions
        system, count = trajectory.system, len(trajectory.times)
        slopes = system.rows[found.rows][:, :-1]
        saltations, late = self.saltations
        matrices = self.matrices[: count - 1]
        # factors of the transitions' times, then of the states at these, which are fixed
        direct = (
            event_times
            + (before[1:] * found.velocities).sum(axis=1)
            + (behind[1:] * found.behind).sum(axis=1)
        )
        rates = np.zeros(count - 1)
        np.divide(-direct, found.speeds, out=rates, where=direct != 0)
        own = before[1:] + rates[:, None] * slopes
        beginnings = behind.copy()
        beginnings[0] += before[0]
        beginnings[:-1] += (own[:, None] @ matrices)[:, 0]
        pulled = (states[:, None] @ self.matrices[count - 1 :])[:, 0]
        np.add.at(beginnings, self.phases[count - 1 :], pulled)
        steps = (saltations @ matrices).swapaxes(1, 2)
        for k in range(count - 2, -1, -1):
            beginnings[k] += steps[k] @ beginnings[k + 1]
        factors = np.concatenate([own + (beginnings[1:, None] @ saltations)[:, 0], states])
        rates += (beginnings[1:] * late).sum(axis=1)
        fields = np.zeros_like(system.fields)
        for configuration, places, flows in self.groups:
            fields[configuration] += flows.gradients(factors[places])
        rows, resets = np.zeros_like(system.rows), np.zeros_like(system.resets)
        np.add.at(rows, found.rows, rates[:, None] * found.before)
        np.add.at(resets, found.resets, beginnings[1:, :, None] * found.before[:, None])
        return fields, rows, resets, beginnings[0]

    def condition(self) -> float:
        """See `MotionDerivatives.condition`."""
        trajectory, found = self.trajectory, self.transitions
        system = trajectory.system
        sizes = np.maximum(np.abs(trajectory.states), np.abs(trajectory.before)).max(axis=0)
        sizes = np.where(sizes > 0, sizes, 1.0)
        slopes = system.rows[found.rows][:, :-1]
        sources = trajectory.run.configurations[:-1]
        turning = np.abs((slopes[:, None] @ system.fields[sources][..., :-1])[:, 0]) @ sizes
        sudden = ~found.smooth
        fragile = np.ones(len(turning))
        fragile[sudden] += turning[sudden] / np.abs(found.speeds[sudden])
        steps = self.saltations[0] @ self.matrices[: len(turning)] * sizes / sizes[:, None]
        errors, largest = np.eye(len(sizes)), 1.0
        for step, factor in zip(steps, fragile.tolist(), strict=True):
            errors = step @ errors @ step.T + np.eye(len(sizes))
            largest = max(largest, float(np.sqrt(np.trace(errors))) * factor)
        return largest


def _along(tables: np.ndarray, places: np.ndarray, states: np.ndarray) -> np.ndarray:
    """Changes (n, ..., q) by tables (q, k, ..., N + 1) of what each of them makes of its state."""
    found = np.empty((len(places), *tables.shape[2:-1], len(tables)))
    for place in np.unique(places):
        here = places == place
        found[here] = np.tensordot(states[here], tables[:, place].T, axes=1)
    return found


def input_names(trajectory: Trajectory) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the parameters of a motion, and of its states at the start.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    tuple of tuple of str
    """
    names = tuple(trajectory.parameters)
    return names, start_names(trajectory.names, names)
