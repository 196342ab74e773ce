"""A motion's phases and transitions, linearised once for all directions, and both passes.

In front of a transition the state moves by f-, behind it by f+; the boundary with the gradient
n is reached at the speed n f-. Where the boundary is reached later by dt, a perturbation that
the reset's matrix R carries over is changed by -(f+ - R f-) dt: the saltation (M. Aizerman and
F. Gantmakher, 1958). A transition without that jump of velocities is smooth.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.flows import extended
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.shooting_map import Numbers, stepped_tables
from nonsmooth.runtime.simulation.moved_phases import PhaseFlows
from nonsmooth.runtime.simulation.trajectory import Trajectory

_IMPACTS = 3  # in a row, each sooner than the one before: they accumulate
_ERROR = 64 * np.finfo(float).eps


class Transitions(NamedTuple):
    """The numbers that the derivatives of m transitions need."""

    rows: np.ndarray  # (m,) row of the boundary that is reached
    resets: np.ndarray  # (m,) indices
    before: np.ndarray  # (m, N + 1) state before the transition, and 1
    velocities: np.ndarray  # (m, N) velocity before the transition
    behind: np.ndarray  # (m, N) velocity behind it
    jumps: np.ndarray  # (m, N) velocity behind, minus the reset's image of that before
    speeds: np.ndarray  # (m,) at which the boundary is reached
    smooth: np.ndarray  # (m,) bool: no jump within rounding

    def late(self, together: Any = False) -> np.ndarray:
        """What a unit of the boundary function in front adds (m, N + 1) at a fixed time behind.

        The transition's own time comes last. It is none for those that are `together` with
        another one, bool (m,), and for boundaries that are touched.
        """
        rates = np.zeros(len(self.speeds))
        np.divide(-1.0, self.speeds, out=rates, where=(self.speeds != 0) & ~np.asarray(together))
        moved = np.where(self.smooth[:, None], 0.0, -self.jumps * rates[:, None])
        return np.concatenate([moved, rates[:, None]], axis=1)


def field_at(system: PiecewiseLinear, configuration: int, states: np.ndarray) -> np.ndarray:
    """Vector field (..., N) of a configuration at states (..., N)."""
    return np.asarray(extended(states) @ system.fields[configuration].T)


def transitions_behind(
    trajectory: Trajectory, first: int = 0, *, together: bool = False
) -> Transitions:
    """The transitions behind entry `first` of a motion, for their derivatives.

    A boundary that is reached tangentially raises `InputError`, unless nothing jumps there.
    So do boundaries that are reached at once, unless `together` is set: then the first
    stands for all.
    """
    system, run = trajectory.system, trajectory.run
    before, behind = run.before[first + 1 :], run.states[first + 1 :]
    sources, targets = run.configurations[first:-1], run.configurations[first + 1 :]
    rows, resets = np.zeros((2, len(before)), dtype=int)
    masks, numbers = np.unique(run.sets[first + 1 :], return_inverse=True)
    kinds, kind = np.unique(np.stack([sources, targets, numbers]), axis=1, return_inverse=True)
    for place, (source, target, number) in enumerate(kinds.T.tolist()):
        here = np.flatnonzero(kind.ravel() == place)
        reached = int(masks[number])
        if reached & (reached - 1) and not together:
            entry = int(here[0]) + first + 1
            raise InputError(
                f"{' and '.join(trajectory.boundaries[entry])} are reached together"
                f" at t = {float(run.times[entry])!r}: the motion has no derivative there"
            )
        rows[here] = system.structure.boundaries[source][min(members_of(reached))].row
        resets[here] = fitting_resets(system, source, target, reached, before[here], behind[here])
    sides = (sources, extended(before)), (targets, extended(behind))
    velocities, after = ((system.fields[c] @ state[..., None])[..., 0] for c, state in sides)
    jumps = after - (system.resets[resets][..., :-1] @ velocities[..., None])[..., 0]
    normals, sizes = system.rows[rows][:, :-1], np.abs(system.fields).sum(axis=1)
    speeds = (normals * velocities).sum(axis=1)
    error = _ERROR * sum((sizes[c] * np.abs(state)).sum(axis=1) for c, state in sides)
    smooth = np.abs(jumps).max(axis=1) <= error
    slow = np.abs(speeds) <= error * np.abs(normals).max(axis=1)
    found = Transitions(rows, resets, sides[0][1], velocities, after, jumps, speeds, smooth)
    tangential = ~smooth & slow & (np.diff(run.times[first:]) > 0)
    if tangential.any():
        entry = first + 1 + int(np.argmax(tangential))
        name, dwell = trajectory.boundaries[entry][0], np.diff(run.times[: entry + 1])
        told = f"{name} is reached tangentially"
        same = trajectory.boundaries[max(entry - _IMPACTS, 1) : entry + 1]
        if (
            set(same) == {(name,)}
            and len(same) > _IMPACTS
            and (np.diff(dwell[-_IMPACTS:]) < 0).all()
        ):
            told = f"impacts at {name} accumulate"
        time = float(run.times[entry])
        raise InputError(f"{told} at t = {time!r}: the motion has no derivative there")
    return found


def fitting_resets(
    system: PiecewiseLinear,
    source: int,
    target: int,
    reached: int,
    before: np.ndarray,
    behind: np.ndarray,
) -> np.ndarray:
    """Indices (n,) of the resets that transitions took: those that fit best.

    The transitions lead from states `before` (n, N) to states `behind` (n, N); `reached` is
    the mask of the boundaries that are reached together.
    """
    found = system.structure.transitions_to(source, members_of(reached), target)
    known = sorted({transition.reset for transition in found})
    images = np.einsum("rij,nj->rni", system.resets[known], extended(before))
    best = np.argmin(np.abs(images - behind).max(axis=2), axis=0)
    return np.asarray(np.array(known)[best])


class MotionChanges(NamedTuple):
    """Derivatives of a motion with n - 1 transitions by q numbers."""

    states: np.ndarray  # (m, N, q), at times that stay
    event_times: np.ndarray  # (n - 1, q), NaN without a derivative
    before: np.ndarray  # (n, N, q), in front of the transitions, which move; the start comes first
    behind: np.ndarray  # (n, N, q), behind them
    beginnings: np.ndarray  # (n, N, q), where phases begin, at fixed times


@dataclass(frozen=True, eq=False)
class MotionLinearisation:
    """A motion's phases, transitions and tables, linearised once for all directions."""

    trajectory: Trajectory
    by: tuple[str, ...]
    directions: np.ndarray  # (numbers, q), changes of the numbers `by` along which it moves
    times: np.ndarray  # (m,), held fixed, at which states are asked for
    # (n - 1,) bool: transitions that follow another one with no time between, but have a time of
    # their own in the moved motion
    apart: np.ndarray

    @cached_property
    def transitions(self) -> Transitions:
        """The transitions, of which the first stands for all that come at once."""
        return transitions_behind(self.trajectory, together=True)

    @cached_property
    def phases(self) -> np.ndarray:
        """Phases that are followed up to their transitions, then those of the times."""
        run = self.trajectory.run
        own = np.searchsorted(run.times, self.times, side="right") - 1
        return np.concatenate([np.arange(len(run.times) - 1), own])

    @cached_property
    def flows(self) -> PhaseFlows:
        """The flows along these phases."""
        run, phases = self.trajectory.run, self.phases
        durations = np.concatenate([run.times[1:], self.times]) - run.times[phases]
        configurations = run.configurations[phases].astype(int)
        return PhaseFlows(self.trajectory.system, configurations, durations, run.states[phases])

    @property
    def matrices(self) -> np.ndarray:
        """Linear parts of the flows, each (N, N)."""
        return self.flows.matrices

    @cached_property
    def moves(self) -> tuple[Numbers, np.ndarray]:
        """Changes of the tables (q, ...) and of the start (N, q) along the directions."""
        system, run = self.trajectory.system, self.trajectory.run
        kernels = system.structure.kernels
        assert kernels is not None
        rates = dict(zip(self.by, self.directions, strict=True))
        still = np.zeros(self.directions.shape[1])
        parameters, starts = (
            np.array([still, *(rates.get(name, still) for name in names)])[1:]
            for names in input_names(self.trajectory)
        )
        point = np.array([[float(value) for value in system.parameters.values()]])
        moved = stepped_tables(kernels, point, parameters.T, None)
        tables = moved.each(lambda part: imaginary_parts(part, None))
        configuration, start = int(run.configurations[0]), run.states[0]
        changes = _following_changes(system, configuration, start, tables.rows)
        return tables, changes + _allowed_changes(system, configuration, start) @ starts

    @cached_property
    def saltations(self) -> tuple[np.ndarray, np.ndarray]:
        """Derivatives of each transition by what comes before it, and by its boundary function.

        Their shapes are (n - 1, N + 1, N + 1) and (n - 1, N + 1); the state comes first, the
        transition's time last. A transition that follows another at once, because its boundary
        is already passed there, has the time of that one.
        """
        system, found = self.trajectory.system, self.transitions
        size = len(self.trajectory.names)
        linear = system.resets[found.resets][..., :-1]
        late = found.late(self.instants)
        steps = np.zeros((len(linear), size + 1, size + 1))
        steps[..., :size] = late[..., None] * system.rows[found.rows][:, None, :-1]
        steps[:, :size, :size] += linear
        steps[self.instants, :size, size] = -found.jumps[self.instants]
        steps[self.instants, size, size] = 1.0
        return steps, late

    @cached_property
    def instants(self) -> np.ndarray:
        """Mask (n - 1,) of the transitions at the very time of the one before, or of the start."""
        found, dwell = self.transitions, np.diff(self.trajectory.times)
        rows = self.trajectory.system.rows[found.rows]
        beyond = (rows * found.before).sum(axis=1) > _ERROR * np.abs(rows * found.before).sum(
            axis=1
        )
        beyond[1:] = True
        return np.asarray((dwell == 0) & beyond & ~self.apart)

    @cached_property
    def steps(self) -> np.ndarray:
        """Derivatives (n - 1, N + 1, N + 1) of what is behind a transition by that at the last one.

        The flows leave the last coordinate, the time of the transition before, as it is.
        """
        saltations, _ = self.saltations
        size = len(self.trajectory.names)
        found = saltations.copy()
        found[..., :size] = saltations[..., :size] @ self.matrices[: len(saltations)]
        return found

    @cached_property
    def changes(self) -> MotionChanges:
        """Derivatives of the motion along the directions."""
        (tables, starts), trajectory, found = self.moves, self.trajectory, self.transitions
        count, (size, q) = len(trajectory.times), starts.shape
        added = self.flows.changes(tables.fields)
        saltations, late = self.saltations
        inside = slice(0, count - 1)
        moved = _along(tables.rows, found.rows, found.before)
        offsets = saltations[..., :size] @ added[inside] + late[..., None] * moved[:, None]
        offsets[:, :size] += _along(tables.resets, found.resets, found.before)
        # at the fixed times of the transitions, and last the changes of these
        changes = np.zeros((count, size + 1, q))
        changes[0, :size] = starts
        for k, step in enumerate(self.steps):
            np.matmul(step, changes[k], out=changes[k + 1])
            changes[k + 1] += offsets[k]
        beginnings, events = changes[:, :size], changes[1:, size].copy()
        ends = self.matrices[inside] @ beginnings[:-1] + added[inside]
        events[found.smooth & (found.speeds == 0)] = np.nan
        before, after = beginnings.copy(), beginnings.copy()
        before[1:] = ends + found.velocities[..., None] * events[:, None]
        after[1:] += found.behind[..., None] * events[:, None]
        own = self.phases[count - 1 :]
        states = self.matrices[count - 1 :] @ beginnings[own] + added[count - 1 :]
        return MotionChanges(states, events, before, after, beginnings)

    def gradient(
        self, states: np.ndarray, event_times: np.ndarray, before: np.ndarray, behind: np.ndarray
    ) -> np.ndarray:
        """Derivatives (q,) along the directions of a combination of results, in reverse mode.

        The arguments are the factors of what `changes` has, without the axis of directions.
        """
        (tables, starts), trajectory, found = self.moves, self.trajectory, self.transitions
        system, count, size = trajectory.system, *trajectory.states.shape
        saltations, late = self.saltations
        # factors of the states at fixed times, and of the times
        factors = np.zeros((count, size + 1))
        factors[:, :size] = behind
        factors[0, :size] += before[0]
        factors[1:, size] = (
            event_times
            + (before[1:] * found.velocities).sum(axis=1)
            + (behind[1:] * found.behind).sum(axis=1)
        )
        factors[:-1, :size] += (before[1:, None] @ self.matrices[: count - 1])[:, 0]
        pulled = (states[:, None] @ self.matrices[count - 1 :])[:, 0]
        np.add.at(factors[:, :size], self.phases[count - 1 :], pulled)
        for k in range(count - 2, -1, -1):
            factors[k] += factors[k + 1] @ self.steps[k]
        ends = before[1:] + (factors[1:, None] @ saltations)[:, 0, :size]
        fields = self.flows.gradients(np.concatenate([ends, states]))
        rows, resets = np.zeros_like(system.rows), np.zeros_like(system.resets)
        rates = (factors[1:] * late).sum(axis=1)
        np.add.at(rows, found.rows, rates[:, None] * found.before)
        np.add.at(resets, found.resets, factors[1:, :size, None] * found.before[:, None])
        return np.asarray(
            np.tensordot(tables.fields, fields, axes=3)
            + np.tensordot(tables.rows, rows, axes=2)
            + np.tensordot(tables.resets, resets, axes=3)
            + factors[0, :size] @ starts
        )

    def condition(self) -> float:
        """See `MotionDerivatives.condition`."""
        trajectory, found = self.trajectory, self.transitions
        system = trajectory.system
        sizes = np.maximum(np.abs(trajectory.states), np.abs(trajectory.before)).max(axis=0)
        sizes = np.where(sizes > 0, sizes, 1.0)
        slopes = system.rows[found.rows][:, :-1]
        sources = trajectory.run.configurations[:-1]
        turning = np.abs((slopes[:, None] @ system.fields[sources][..., :-1])[:, 0]) @ sizes
        sudden = ~found.smooth & ~self.instants
        fragile = np.ones(len(turning))
        fragile[sudden] += turning[sudden] / np.abs(found.speeds[sudden])
        size = len(sizes)
        steps = self.steps[:, :size, :size] * sizes / sizes[:, None]
        errors, largest = np.eye(len(sizes)), 1.0
        for step, factor in zip(steps, fragile.tolist(), strict=True):
            errors = step @ errors @ step.T + np.eye(len(sizes))
            largest = max(largest, float(np.sqrt(np.trace(errors))) * factor)
        return largest


def _along(tables: np.ndarray, places: np.ndarray, states: np.ndarray) -> np.ndarray:
    """Changes (n, ..., q) of n affine functions, number ``places[i]`` of k at state i (N + 1,).

    `tables` (q, k, ..., N + 1) are the derivatives of k functions by q numbers.
    """
    found = np.empty((len(places), *tables.shape[2:-1], len(tables)))
    for place in np.unique(places):
        here = places == place
        found[here] = np.tensordot(states[here], tables[:, place].T, axes=1)
    return found


def input_names(trajectory: Trajectory) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the motion's parameters, and of its states at the start."""
    names = tuple(trajectory.parameters)
    return names, start_names(trajectory.names, names)


def _allowed_changes(system: PiecewiseLinear, configuration: int, start: np.ndarray) -> np.ndarray:
    """Orthogonal projection (N, N) of changes of a start (N,) onto those that are allowed.

    They keep the constraints of the configuration satisfied, and move all forcings along
    one time.
    """
    structure, size = system.structure, len(start)
    rows = [system.rows[row][:-1] for row in structure.constraints[configuration]]
    turns = []
    for cosine, sine in structure.forcing:
        radial, turn = np.zeros(size), np.zeros(size)
        radial[[cosine, sine]] = start[[cosine, sine]]
        speed = system.fields[configuration, sine, cosine]
        turn[[cosine, sine]] = -start[sine], start[cosine]
        rows.append(radial)
        turns.append(turn / speed)
    rows += [turn - turns[0] for turn in turns[1:]]
    if not rows:
        return np.eye(size)
    matrix = np.array(rows)
    return np.asarray(np.eye(size) - np.linalg.pinv(matrix) @ matrix)


def _following_changes(
    system: PiecewiseLinear, configuration: int, start: np.ndarray, rows: np.ndarray
) -> np.ndarray:
    """Changes (N, q) of a start (N,) that keep it on its constraints while q parameters change.

    They are the smallest ones in the system's units. `rows` (q, R, N + 1) are the
    derivatives of the rows by the parameters.
    """
    held = list(system.structure.constraints[configuration])
    if not held:
        return np.zeros((len(start), len(rows)))
    missed = rows[:, held] @ extended(start)
    return np.asarray(-np.linalg.pinv(system.rows[held][:, :-1]) @ missed.T)


def nearest_start(system: PiecewiseLinear, configuration: int, start: np.ndarray) -> np.ndarray:
    """The start (N,) nearest to a given one that satisfies the constraints of a configuration."""
    held = list(system.structure.constraints[configuration])
    found = start.copy()
    if held:
        found -= np.linalg.pinv(system.rows[held][:, :-1]) @ (system.rows[held] @ extended(start))
    for cosine, sine in system.structure.forcing:
        found[[cosine, sine]] /= np.hypot(found[cosine], found[sine])
    return found
