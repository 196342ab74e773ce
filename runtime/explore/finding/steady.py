"""Motions that stay in one configuration: equilibria, and what a forcing makes of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import FORCING_PHASE
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.simulation.starting import configurations_of, on_circles

_DEPENDENT = 1e-10  # relative singular value below which equations are dependent
_ROUNDING = 4 * np.finfo(float).eps  # of a root: what is smaller than its error is zero
_SAME = 1e-9  # of each number of a state: how near two roots of it are
_NEUTRAL = 1e-9  # real part, in units of the largest eigenvalue
_MOST_TURNS = 24  # of the first forcing, until all meet again
_WHOLE = 1e-9  # of a turn


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A state in which a system without forcing stays, isolated from other equilibria."""

    system: str
    parameters: dict[str, Value]
    configuration: str
    names: tuple[str, ...]  # of the states
    state: np.ndarray  # (N,)
    # (k,), of the motions nearby in its configuration, the slowest decay first
    eigenvalues: np.ndarray

    @property
    def verdict(self) -> str:
        """Stable, unstable, or neutral where motions next to it neither decay nor grow."""
        if not self.eigenvalues.size:
            return "stable"
        error = _NEUTRAL * float(np.abs(self.eigenvalues).max())
        largest = float(self.eigenvalues.real.max())
        if abs(largest) <= error:
            return "neutral"
        return "stable" if largest < 0 else "unstable"


def equilibria(system: PiecewiseLinear) -> list[Equilibrium]:
    """Isolated equilibria that are motions of a system, each once; none for a system with forcing.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    >>> motion = ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], until=1)
    >>> [found.configuration for found in equilibria(motion.system)]
    ['free']
    """
    structure = system.structure
    if structure.forcing:
        return []
    found: list[Equilibrium] = []
    for configuration in structure.visited:
        name = structure.configurations[configuration]
        field = system.fields[configuration]
        constraints = system.rows[list(structure.constraints[configuration])]
        state = _root(np.concatenate([field, constraints]))
        if state is None or any(same_state(state, known.state) for known in found):
            continue
        (where,) = configurations_of(
            structure, system.fields[None], system.rows[None], state[None], name
        )
        if where != configuration:
            continue
        values = _eigenvalues(field[:, :-1], constraints[:, :-1])
        found.append(
            Equilibrium(structure.name, system.parameters, name, structure.states, state, values)
        )
    return found


def same_state(state: np.ndarray, other: np.ndarray) -> bool:
    """Whether two equilibria (N,) are one; zeros of one have to be zeros of the other."""
    return bool((np.abs(state - other) <= _SAME * np.abs(state)).all())


def forcing_turns(system: PiecewiseLinear) -> tuple[int, ...] | None:
    """Number of turns of each forcing in their common period, or None if there is none.

    It is empty without a forcing.
    """
    speeds = np.abs(system.forcing_speeds)
    if not speeds.size:
        return ()
    for first in range(1, _MOST_TURNS + 1):
        turns = first * speeds / speeds[0]
        if (np.abs(turns - np.round(turns)) <= _WHOLE).all() and (turns > _WHOLE).all():
            return tuple(int(turn) for turn in np.round(turns))
    return None


def forcing_period(system: PiecewiseLinear) -> float | None:
    """Common period of all forcings, or None without one."""
    turns = forcing_turns(system)
    if not turns:
        return None
    return 2 * np.pi * turns[0] / abs(float(system.forcing_speeds[0]))


def responses(kernels: SystemKernels, system: PiecewiseLinear) -> list[Orbit | None]:
    """Response of each configuration to the forcing, as an orbit that may not be admissible.

    None stands for a configuration that was not visited; all are None without a forcing, or
    where the forcings have no common period.
    """
    structure, period = system.structure, forcing_period(system)
    if period is None:
        return [None] * len(structure.configurations)
    start = on_circles(system, np.zeros((1, len(structure.states))), np.zeros(1))[0]
    return [
        None
        if place in structure.unvisited
        else solve_itinerary(
            kernels, system.parameters, [(name, FORCING_PHASE)], [period], start.tolist()
        )
        for place, name in enumerate(structure.configurations)
    ]


def _root(affine: np.ndarray) -> np.ndarray | None:
    """The common zero (N,) of affine functions (m, N + 1); None if there is none, or several."""
    rows = np.abs(affine).max(axis=1)
    affine = affine[rows > 0] / rows[rows > 0, None]
    columns = np.abs(affine[:, :-1]).max(axis=0, initial=0.0)
    if not columns.all() or len(affine) < len(columns):
        return None
    matrix = affine[:, :-1] / columns
    left, values, right = np.linalg.svd(matrix, full_matrices=False)
    if values[-1] <= _DEPENDENT * values[0]:
        return None
    state = right.T @ (left.T @ -affine[:, -1] / values)
    missed = np.abs(matrix @ state + affine[:, -1])
    size = (np.abs(matrix) @ np.abs(state) + np.abs(affine[:, -1])).max()
    if not (missed <= _DEPENDENT * size).all():
        return None
    rounding = _ROUNDING * len(state) * np.linalg.norm(affine[:, -1]) / values[-1]
    return np.where(np.abs(state) <= rounding, 0.0, state / columns)


def _eigenvalues(matrix: np.ndarray, normals: np.ndarray) -> Any:
    """Eigenvalues of a field on the subspace that the constraints leave."""
    _, values, rest = np.linalg.svd(np.concatenate([normals, np.zeros_like(matrix)]))
    free = rest[values <= _DEPENDENT * max(values[0], np.finfo(float).tiny)].T
    found = np.linalg.eigvals(free.T @ matrix @ free).astype(complex)
    return found[np.lexsort((found.imag, -found.real.round(12)))]
