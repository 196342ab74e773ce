"""What the derivatives of a motion's transitions need: velocities, jumps, rows and resets.

In front of a transition the state moves by f-, behind it by f+; the boundary with the gradient
n is reached at the speed n f-. Where the boundary is reached later by dt, a perturbation that
the reset's matrix R carries over is changed by -(f+ - R f-) dt: the saltation (M. Aizerman and
F. Gantmakher, 1958). A transition without that jump of velocities is smooth.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Transitions", "extended", "field_at", "fitting_resets", "transitions_behind"]

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


def extended(states: np.ndarray) -> np.ndarray:
    """States (..., N) with a 1 appended: (..., N + 1)."""
    return np.concatenate([states, np.ones((*states.shape[:-1], 1))], axis=-1)


def transitions_behind(
    trajectory: Trajectory, first: int = 0, *, together: bool = False
) -> Transitions:
    """The transitions behind entry `first` of a motion, for their derivatives.

    A boundary that is reached tangentially raises `InputError`, unless nothing jumps there.
    So do boundaries that are reached at once, unless `together` is set: then the first
    stands for all.
    """
    system, run = trajectory.system, trajectory.run
    count, size = len(run.times) - first - 1, len(trajectory.names)
    before, behind = run.before[first + 1 :], run.states[first + 1 :]
    found = Transitions(
        np.zeros(count, dtype=int),
        np.zeros(count, dtype=int),
        extended(before),
        np.empty((count, size)),
        np.empty((count, size)),
        np.empty((count, size)),
        np.empty(count),
        np.zeros(count, dtype=bool),
    )
    tangential = np.zeros(count, dtype=bool)
    masks, numbers = np.unique(run.sets[first + 1 :], return_inverse=True)
    keys = np.stack([run.configurations[first:-1], run.configurations[first + 1 :], numbers])
    kinds, kind = np.unique(keys, axis=1, return_inverse=True)
    for place, (source, target, number) in enumerate(kinds.T.tolist()):
        here = np.flatnonzero(kind.ravel() == place)
        reached = int(masks[number])
        if reached & (reached - 1) and not together:
            entry = int(here[0]) + first + 1
            raise InputError(
                f"{' and '.join(trajectory.boundaries[entry])} are reached together"
                f" at t = {float(run.times[entry])!r}: the motion has no derivative there"
            )
        lowest = (reached & -reached).bit_length() - 1
        shape = system.structure.boundaries[source][lowest]
        row, now, then = system.rows[shape.row], before[here], behind[here]
        resets = fitting_resets(system, source, target, reached, now, then)
        velocities, after = field_at(system, source, now), field_at(system, target, then)
        jumps = after - np.einsum("nij,nj->ni", system.resets[resets][..., :-1], velocities)
        speeds = velocities @ row[:-1]
        error = _ERROR * (
            np.abs(system.fields[source]).sum(axis=0) @ extended(np.abs(now)).T
            + np.abs(system.fields[target]).sum(axis=0) @ extended(np.abs(then)).T
        )
        smooth = np.abs(jumps).max(axis=1) <= error
        slow = np.abs(speeds) <= error * np.abs(row[:-1]).max()
        tangential[here] = ~smooth & slow & (run.times[here + first + 1] > run.times[here + first])
        parts = (shape.row, resets, extended(now), velocities, after, jumps, speeds, smooth)
        for own, part in zip(found, parts, strict=True):
            own[here] = part
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
    boundaries = frozenset(b for b in range(reached.bit_length()) if reached >> b & 1)
    known = sorted({t.reset for t in system.structure.transitions_to(source, boundaries, target)})
    images = np.einsum("rij,nj->rni", system.resets[known], extended(before))
    best = np.argmin(np.abs(images - behind).max(axis=2), axis=0)
    return np.asarray(np.array(known)[best])
