"""What a motion's start may do: on constraints, and at the phases of the forcings."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.transition_derivatives import extended

__all__ = ["allowed_changes", "following_changes", "nearest_start"]


def allowed_changes(system: PiecewiseLinear, configuration: int, start: np.ndarray) -> np.ndarray:
    """Orthogonal projection (N, N) of changes of a start onto those that are its own.

    The constraints of the configuration stay solved, and all forcings move along one time.

    Parameters
    ----------
    system : PiecewiseLinear
    configuration : int
    start : array (N,)

    Returns
    -------
    array (N, N)
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
    """Changes (N, q) of a start that keep it on its constraints while parameters change.

    The smallest, in the system's units.

    Parameters
    ----------
    system : PiecewiseLinear
    configuration : int
    start : array (N,)
    rows : array (q, R, N + 1)
        Derivatives of the rows by the parameters.

    Returns
    -------
    array (N, q)
    """
    held = list(system.structure.constraints[configuration])
    if not held:
        return np.zeros((len(start), len(rows)))
    missed = rows[:, held] @ extended(start)
    return np.asarray(-np.linalg.pinv(system.rows[held][:, :-1]) @ missed.T)


def nearest_start(system: PiecewiseLinear, configuration: int, start: np.ndarray) -> np.ndarray:
    """The start (N,) nearest to a given one that solves a configuration's constraints.

    Parameters
    ----------
    system : PiecewiseLinear
    configuration : int
    start : array (N,)

    Returns
    -------
    array (N,)
    """
    held = list(system.structure.constraints[configuration])
    found = start.copy()
    if held:
        found -= np.linalg.pinv(system.rows[held][:, :-1]) @ (system.rows[held] @ extended(start))
    for cosine, sine in system.structure.forcing:
        found[[cosine, sine]] /= np.hypot(found[cosine], found[sine])
    return found
