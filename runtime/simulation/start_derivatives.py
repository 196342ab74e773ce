"""What a motion's start may do: on constraints, and at the phases of the forcings."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.transition_derivatives import extended

__all__ = ["allowed_changes", "following_changes", "nearest_start"]


def allowed_changes(system: PiecewiseLinear, configuration: int, start: np.ndarray) -> np.ndarray:
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


def following_changes(
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
