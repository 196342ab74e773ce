"""Derivatives of a motion by its start, and Lyapunov exponents.

Along a phase a perturbation is carried by the flow's matrix Phi; through a transition by

    S = R + (f+ - R f-) n / (n f-),

with the reset's matrix R, the gradient n of the boundary, and the vector fields f- in front
and f+ behind. Both map the motion's own direction f to itself, so that they act on what is
transverse to it: on the quotient by f, whose norm is the distance from the span of f. The
exponents are those of this quotient; the zero that belongs to f is none of them.

A transition that sets a velocity (a mass that begins to stick) annihilates a direction. It
is gone for ever, and its exponent is minus infinity.
"""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.observing.phases import phases_of
from nonsmooth.runtime.simulation.flows import functions_of
from nonsmooth.runtime.simulation.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["lyapunov", "lyapunov_spectrum", "tangent_map"]

_ERROR = 64 * np.finfo(float).eps
_LOST = 1e-13  # of the norm of a step: a direction that a step annihilates
_SEED = 1


def lyapunov(trajectory: Trajectory, since: float = 0.0) -> float:
    """Largest Lyapunov exponent transverse to the motion.

    On a stable periodic orbit, over whole periods, it is log|largest multiplier| / period.

    Parameters
    ----------
    trajectory : Trajectory
    since : float
        Where to begin to count, behind a transient; the perturbations are carried from the
        start of the motion on, so that they have turned to their directions by then.

    Raises
    ------
    InputError
        If `since` is not between the start and the end of the motion, or the motion has no
        derivative there: two boundaries are reached at once, or one tangentially.
    """
    return float(lyapunov_spectrum(trajectory, since)[0])


def lyapunov_spectrum(trajectory: Trajectory, since: float = 0.0) -> np.ndarray:
    """All Lyapunov exponents transverse to the motion (N - 1,), the largest first.

    Minus infinity for directions that transitions annihilate, or that the constraints of
    the configuration do not leave in which the motion starts. Parameters and errors as for
    `lyapunov`.
    """
    since = _checked(trajectory, since)
    first = _first_entry(trajectory, since)
    segments = _segments(trajectory, first, since)
    size = len(trajectory.names)
    frame = np.random.default_rng(_SEED).normal(size=(size, size - 1))
    frame = _allowed(trajectory, first) @ frame
    logs = np.zeros(size - 1)
    alive = np.arange(size - 1)
    field = _field(
        trajectory.system, trajectory.run.configurations[first], trajectory.states[first]
    )
    frame, alive, _ = _orthonormal(frame, alive, field)
    for begin, matrix, field in zip(*segments, strict=True):
        frame, alive, growth = _orthonormal(matrix @ frame, alive, field)
        if begin >= since:
            logs[alive] += growth
    logs[np.setdiff1d(np.arange(size - 1), alive)] = -np.inf
    return np.sort(logs / (trajectory.end - since))[::-1]


def tangent_map(trajectory: Trajectory, since: float = 0.0) -> np.ndarray:
    """Derivative (N, N) of the state at the end by the state at `since`.

    Only perturbations that the configuration at `since` allows are perturbations of the
    motion. Parameters and errors as for `lyapunov`.
    """
    since = _checked(trajectory, since)
    first = int(np.searchsorted(trajectory.times, since, side="right")) - 1
    found = np.eye(len(trajectory.names))
    begins, matrices, _ = _segments(trajectory, first, since)
    for begin, matrix in zip(begins, matrices, strict=True):
        if begin >= since:
            found = matrix @ found
    return found


def _checked(trajectory: Trajectory, since: float) -> float:
    phases_of(trajectory, since)
    return float(since)


def _first_entry(trajectory: Trajectory, since: float) -> int:
    """Entry at which perturbations start: behind what has no derivative before `since`."""
    times = [
        0.0,
        *(g.time for g in trajectory.grazings),
        *trajectory.times[_together(trajectory)].tolist(),
    ]
    before = max(time for time in times if time <= since)
    return min(int(np.searchsorted(trajectory.times, before)), _latest(trajectory, since))


def _latest(trajectory: Trajectory, since: float) -> int:
    return int(np.searchsorted(trajectory.times, since, side="right")) - 1


def _together(trajectory: Trajectory) -> np.ndarray:
    """Entries (n,) at which several boundaries were reached at once."""
    sets = trajectory.run.sets
    return np.asarray((sets & (sets - 1)) != 0)


def _segments(
    trajectory: Trajectory, first: int, since: float
) -> tuple[list[float], np.ndarray, np.ndarray]:
    """Parts of the motion from an entry on, cut at `since`.

    Returns
    -------
    begins : list of float
    matrices : array (segments, N, N)
        Through each and the transition at its end.
    fields : array (segments, N)
        Vector field behind each.
    """
    system, run = trajectory.system, trajectory.run
    for grazing in run.grazings:
        if grazing.time > since:
            raise InputError(f"a boundary is reached tangentially at t = {grazing.time!r}")
    breaks = run.times[first:].tolist()
    phases = list(range(first, len(run.times)))
    switches = [*range(first + 1, len(run.times)), 0]
    place = int(np.searchsorted(breaks, since, side="right"))
    if breaks[place - 1] < since:
        breaks.insert(place, since)
        phases.insert(place, phases[place - 1])
        switches.insert(place - 1, 0)
    ends = [*breaks[1:], trajectory.end]
    matrices = _flow_matrices(system, run.configurations[phases], np.subtract(ends, breaks))
    fields = np.empty((len(breaks), matrices.shape[1]))
    saltations = _saltation_matrices(trajectory, first, since)
    for segment, switch in enumerate(switches):
        if switch:
            matrices[segment] = saltations[switch - first - 1] @ matrices[segment]
            fields[segment] = _field(system, run.configurations[switch], run.states[switch])
        else:
            state = trajectory(ends[segment])
            fields[segment] = _field(system, run.configurations[phases[segment]], state)
    return breaks, matrices, fields


def _flow_matrices(
    system: PiecewiseLinear, configurations: np.ndarray, durations: np.ndarray
) -> np.ndarray:
    """Derivatives (n, N, N) of the states after durations by those at their beginnings."""
    size = len(system.structure.states)
    found = np.empty((len(durations), size, size))
    for configuration in np.unique(configurations).tolist():
        here = configurations == configuration
        functions = functions_of(system, configuration, durations[here])
        flows = system.flows[configuration][:, :, :-1]
        found[here] = np.tensordot(functions, flows, axes=1)
    return found


def _saltation_matrices(trajectory: Trajectory, first: int, since: float) -> np.ndarray:
    """Saltation matrices (n, N, N) of the transitions behind an entry."""
    system, run = trajectory.system, trajectory.run
    size = len(trajectory.names)
    found = np.empty((len(run.times) - first - 1, size, size))
    keys = np.stack(
        [run.configurations[first:-1], run.configurations[first + 1 :], run.sets[first + 1 :]]
    )
    for source, target, reached in np.unique(keys, axis=1).T.tolist():
        here = np.flatnonzero(np.equal(keys.T, (source, target, reached)).all(axis=1))
        entries = here + first + 1
        if reached & (reached - 1):
            raise InputError(
                f"boundaries are reached together at t = {float(run.times[entries[0]])!r}:"
                " the motion has no derivative there"
            )
        row = system.rows[system.structure.boundaries[source][reached.bit_length() - 1].row]
        before, behind = run.before[entries], run.states[entries]
        resets = _resets(system, source, target, reached, before, behind)
        fields = _field(system, source, before), _field(system, target, behind)
        jumps = fields[1] - np.einsum("nij,nj->ni", resets, fields[0])
        error = _ERROR * (
            np.abs(system.fields[source]).sum(axis=0) @ _extended(np.abs(before)).T
            + np.abs(system.fields[target]).sum(axis=0) @ _extended(np.abs(behind)).T
        )
        smooth = np.abs(jumps).max(axis=1) <= error
        rates = fields[0] @ row[:-1]
        tangential = ~smooth & (np.abs(rates) <= error * np.abs(row[:-1]).max())
        if tangential.any():
            time = float(run.times[entries[np.argmax(tangential)]])
            raise InputError(
                f"a boundary is reached tangentially at t = {time!r}:"
                " the motion has no derivative there"
            )
        factors = np.where(smooth[:, None], 0.0, jumps) / np.where(smooth, 1.0, rates)[:, None]
        found[here] = resets + factors[:, :, None] * row[:-1]
    return found


def _resets(
    system: PiecewiseLinear,
    source: int,
    target: int,
    reached: int,
    before: np.ndarray,
    behind: np.ndarray,
) -> np.ndarray:
    """Linear parts (n, N, N) of the resets that the transitions took: those that fit best."""
    boundaries = frozenset(b for b in range(reached.bit_length()) if reached >> b & 1)
    known = sorted({t.reset for t in system.structure.leading(source, boundaries, target)})
    matrices = system.resets[known]
    images = np.einsum("rij,nj->rni", matrices, _extended(before))
    best = np.argmin(np.abs(images - behind).max(axis=2), axis=0)
    return np.asarray(matrices[best, :, :-1])


def _field(system: PiecewiseLinear, configuration: int, states: np.ndarray) -> np.ndarray:
    """Vector field (..., N) at states (..., N)."""
    return np.asarray(_extended(states) @ system.fields[configuration].T)


def _extended(states: np.ndarray) -> np.ndarray:
    return np.concatenate([states, np.ones((*states.shape[:-1], 1))], axis=-1)


def _allowed(trajectory: Trajectory, entry: int) -> np.ndarray:
    """Projection (N, N) onto what the constraints of a configuration allow."""
    system = trajectory.system
    configuration = int(trajectory.run.configurations[entry])
    normals = system.rows[list(system.structure.constraints[configuration]), :-1]
    return np.asarray(np.eye(len(trajectory.names)) - np.linalg.pinv(normals) @ normals)


def _orthonormal(
    frame: np.ndarray, alive: np.ndarray, field: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Orthonormal frame transverse to the field, which columns it is, and logs of their growth.

    Columns that are annihilated are left out.
    """
    square = float(field @ field)
    if square == 0:
        raise InputError("the motion is at rest: nothing is transverse to it")
    lost = _LOST * float(np.abs(frame).max(initial=0.0))
    frame = frame - np.outer(field, field @ frame / square)
    while frame.shape[1]:
        turned, upper = np.linalg.qr(frame)
        growth = np.abs(np.diag(upper))
        dead = np.flatnonzero(growth <= lost)
        if not dead.size:
            return turned, alive, np.log(growth)
        # those behind it were made orthogonal to rounding errors
        frame, alive = np.delete(frame, dead[0], axis=1), np.delete(alive, dead[0])
    return frame, alive, np.empty(0)
