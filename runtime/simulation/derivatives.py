"""Derivatives of a simulated motion by parameters and by its start.

Phase by phase a perturbation at a fixed time is carried by the flow, and grows by what the
field's change adds (`flow_derivatives`). The boundary's condition, linearised, gives the change
of the transition's time; the reset, its own change and the jump of velocities give the
perturbation behind it (I. A. Hiskens and M. A. Pai, IEEE Trans. Circuits Syst. I 47, 2000). The
reverse pass carries one combination of the results backwards; its cost does not depend on the
number of parameters.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.table_derivatives import TableDerivatives, table_derivatives
from nonsmooth.runtime.simulation.flow_derivatives import ConfigurationFlows, configuration_flows
from nonsmooth.runtime.simulation.start_derivatives import allowed_changes, following_changes
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.simulation.transition_derivatives import Transitions, transitions_behind

__all__ = ["MotionDerivatives", "input_names", "motion_derivatives"]


@dataclass(frozen=True, eq=False)
class MotionDerivatives:
    """Derivatives of a motion by q numbers: parameters, and states at the start.

    By a state at the start that constraints or a forcing's phase bind, the derivative is that
    along the nearest direction in which the configuration lets the start move: zero for a
    velocity that a contact holds. While a parameter moves a constraint, the start stays on it.

    Attributes
    ----------
    trajectory : Trajectory
    by : tuple of str
    times : array (m,)
    linearisation : MotionLinearisation
        What forward and reverse pass share.

    Examples
    --------
    >>> from nonsmooth.runtime.simulation.simulate import simulate
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> motion = simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=3)
    >>> found = motion.derivatives(["k1", "r"])
    >>> found.event_times.shape, found.behind.shape
    ((3, 2), (4, 4, 2))
    >>> found.event_times[0, 1] == 0  # restitution acts from the first impact on
    True
    """

    trajectory: Trajectory
    by: tuple[str, ...]
    times: np.ndarray
    linearisation: MotionLinearisation

    @cached_property
    def _forward(self) -> tuple[np.ndarray, ...]:
        return self.linearisation.forward(*self._directions)

    @cached_property
    def _directions(self) -> tuple[TableDerivatives, np.ndarray]:
        return self.linearisation.directions(self.by)

    @property
    def states(self) -> np.ndarray:
        """Derivatives (m, N, q) of the states at the times, which stay."""
        return self._forward[0]

    @property
    def event_times(self) -> np.ndarray:
        """Derivatives (n - 1, q) of the transitions' times.

        NaN where a boundary behind which nothing changes is reached tangentially.
        """
        return self._forward[1]

    @property
    def before(self) -> np.ndarray:
        """Derivatives (n, N, q) of the states in front of the transitions, which move."""
        return self._forward[2]

    @property
    def behind(self) -> np.ndarray:
        """Derivatives (n, N, q) of the states behind the transitions, which move."""
        return self._forward[3]

    @property
    def end(self) -> np.ndarray:
        """Derivative (q,) of the time at which the simulation ended."""
        if self.trajectory.status == Status.UNTIL or not len(self.event_times):
            return np.zeros(len(self.by))
        return np.asarray(self.event_times[-1])

    def jvp(self, direction: Mapping[str, float] | Any) -> dict[str, np.ndarray]:
        """Differentiate along one direction (forward mode).

        Parameters
        ----------
        direction : mapping of str to float, or array (q,)
            Change of each of the numbers; of those that a mapping leaves out none.

        Returns
        -------
        dict of str to array
            ``states`` (m, N), ``event_times`` (n - 1,), ``before`` and ``behind`` (n, N).

        Raises
        ------
        InputError
            For an unknown name, or another count of numbers.
        """
        if isinstance(direction, Mapping):
            for name in direction:
                if name not in self.by:
                    raise unknown_name("number", str(name), self.by)
            direction = [direction.get(name, 0.0) for name in self.by]
        factors = np.asarray(direction, dtype=float)
        if factors.shape != (len(self.by),):
            raise InputError(f"the direction has not {len(self.by)} entries: {', '.join(self.by)}")
        tables, starts = self._directions
        along = TableDerivatives(*(np.tensordot(factors, part, axes=1)[None] for part in tables))
        found = self.linearisation.forward(along, (starts @ factors)[:, None])
        return {
            name: part[..., 0]
            for name, part in zip(("states", "event_times", "before", "behind"), found, strict=True)
        }

    def vjp(
        self, *, states: Any = None, event_times: Any = None, before: Any = None, behind: Any = None
    ) -> np.ndarray:
        """Differentiate one combination of the results by all numbers (reverse mode).

        Parameters
        ----------
        states : array (m, N), optional
            Factors of the states at the times.
        event_times : array (n - 1,), optional
            Factors of the transitions' times.
        before, behind : array (n, N), optional
            Factors of the states in front of the transitions and behind them.

        Returns
        -------
        array (q,)

        Raises
        ------
        InputError
            For factors of another shape.
        """
        count, size = self.trajectory.states.shape
        shapes = {
            "states": (len(self.times), size),
            "event_times": (count - 1,),
            "before": (count, size),
            "behind": (count, size),
        }
        factors = []
        for (name, shape), given in zip(
            shapes.items(), (states, event_times, before, behind), strict=True
        ):
            found = np.zeros(shape) if given is None else np.asarray(given, dtype=float)
            if found.shape != shape:
                raise InputError(f"factors of {name} have the shape {found.shape}, not {shape}")
            factors.append(found)
        fields, rows, resets, start = self.linearisation.reverse(*factors)
        tables, starts = self._directions
        return np.asarray(
            np.tensordot(tables.fields, fields, axes=3)
            + np.tensordot(tables.rows, rows, axes=2)
            + np.tensordot(tables.resets, resets, axes=3)
            + start @ starts
        )

    @cached_property
    def condition(self) -> float:
        """How much roundings at all events grow along the motion, and what depends on them.

        Each state errs at each event by one unit, independently, in terms of its largest value
        along the motion; the flows and transitions carry the errors on. Their largest size,
        times what the slowest speed at which a boundary is reached makes of it.
        """
        return self.linearisation.condition()


class MotionLinearisation:
    """A motion's phases, transitions and tables, linearised once for all directions."""

    def __init__(self, trajectory: Trajectory, times: np.ndarray) -> None:
        self.trajectory, self.times = trajectory, times
        run, count = trajectory.run, len(trajectory.times)
        for grazing in run.grazings:
            raise InputError(
                f"a boundary is reached tangentially at t = {grazing.time!r}:"
                " the motion has no derivative there"
            )
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

    def forward(self, tables: TableDerivatives, starts: np.ndarray) -> tuple[np.ndarray, ...]:
        """Derivatives of states, times of transitions, and states on both sides of these."""
        trajectory, found = self.trajectory, self.transitions
        system, count = trajectory.system, len(trajectory.times)
        size, q = starts.shape
        added = np.empty((len(self.phases), size, q))
        for configuration, places, flows in self.groups:
            added[places] = flows.changes(tables.fields[:, configuration])
        slopes = system.rows[found.rows][:, :-1]
        moved = np.einsum("qni,ni->nq", tables.rows[:, found.rows], found.before)
        reset = np.einsum("qnij,nj->niq", tables.resets[:, found.resets], found.before)
        linear = system.resets[found.resets][..., :-1]
        beginnings = np.empty((count, size, q))  # at the fixed times of the transitions
        ends = np.empty((count - 1, size, q))
        rates = np.zeros((count - 1, q))
        beginnings[0] = starts
        for k in range(count - 1):
            end = self.matrices[k] @ beginnings[k] + added[k]
            behind = linear[k] @ end + reset[k]
            if not found.smooth[k]:
                rates[k] = (slopes[k] @ end + moved[k]) / -found.speeds[k]
                behind = behind - found.jumps[k][:, None] * rates[k]
            ends[k], beginnings[k + 1] = end, behind
        with np.errstate(divide="ignore", invalid="ignore"):
            events = (np.einsum("ni,niq->nq", slopes, ends) + moved) / -found.speeds[:, None]
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
        linear = system.resets[found.resets][..., :-1]
        # factors of the perturbations in front of and behind each transition, at its own time
        pulled = np.concatenate([before[1:], states])
        beginnings = behind.copy()
        beginnings[0] += before[0]
        np.add.at(
            beginnings,
            self.phases[count - 1 :],
            np.einsum("nij,ni->nj", self.matrices[count - 1 :], states),
        )
        direct = (
            event_times
            + np.einsum("ni,ni->n", before[1:], found.velocities)
            + np.einsum("ni,ni->n", behind[1:], found.behind)
        )
        rates = np.zeros(count - 1)
        for k in range(count - 2, -1, -1):
            behind_it, rate = beginnings[k + 1], direct[k]
            pulled[k] += behind_it @ linear[k]
            if not found.smooth[k]:
                rate = rate - found.jumps[k] @ behind_it
            if rate:
                rates[k] = rate / -found.speeds[k]
                pulled[k] += rates[k] * slopes[k]
            beginnings[k] += pulled[k] @ self.matrices[k]
        fields = np.zeros_like(system.fields)
        for configuration, places, flows in self.groups:
            fields[configuration] += flows.gradients(pulled[places])
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
        linear = system.resets[found.resets][..., :-1]
        slopes = system.rows[found.rows][:, :-1]
        sources = trajectory.run.configurations[:-1]
        turning = np.einsum("ni,nij->nj", slopes, system.fields[sources][..., :-1])
        # relative to the size of the states
        errors, largest = np.eye(len(sizes)), 1.0
        for k in range(len(linear)):
            matrix, fragile = self.matrices[k], 1.0
            step = linear[k] @ matrix
            if not found.smooth[k]:
                ahead = slopes[k] @ matrix
                step = step + np.outer(found.jumps[k], ahead) / found.speeds[k]
                fragile += float(np.abs(turning[k]) @ sizes / abs(found.speeds[k]))
            scaled = step * sizes / sizes[:, None]
            errors = scaled @ errors @ scaled.T + np.eye(len(sizes))
            largest = max(largest, float(np.sqrt(np.trace(errors))) * fragile)
        return largest


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


def motion_derivatives(
    trajectory: Trajectory,
    by: Iterable[str] | None = None,
    times: Any = None,
    one_sided: str | None = None,
) -> MotionDerivatives:
    """Differentiate a motion; see `Trajectory.derivatives`.

    Parameters
    ----------
    trajectory : Trajectory
    by : iterable of str, optional
    times : array (m,), optional
    one_sided : {"+", "-"}, optional

    Returns
    -------
    MotionDerivatives

    Raises
    ------
    InputError
        For an unknown name or time, or where the motion has no derivative.
    """
    names, starts = input_names(trajectory)
    if by is None:
        forced = {place for pair in trajectory.structure.forcing for place in pair}
        free = (name for place, name in enumerate(starts) if place not in forced)
        chosen = (*names, *free)
    else:
        chosen = (by,) if isinstance(by, str) else tuple(by)
        for name in chosen:
            if name not in names and name not in starts:
                raise unknown_name("parameter or start", str(name), (*names, *starts))
    if one_sided is not None:
        raise InputError("one-sided derivatives of a motion are not there yet")
    array = np.atleast_1d(np.asarray([] if times is None else times, dtype=float))
    if not ((array >= 0) & (array <= trajectory.end)).all():
        raise InputError(f"a time is not between 0 and the end of the motion, {trajectory.end!r}")
    return MotionDerivatives(trajectory, chosen, array, MotionLinearisation(trajectory, array))
