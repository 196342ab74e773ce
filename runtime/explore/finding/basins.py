"""Basins of attraction: where the starts of a plane lead."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.explore.finding.found import Found
from nonsmooth.runtime.explore.finding.outcomes import Attractors, Outcome, attractors_of
from nonsmooth.runtime.model.kernels import SystemKernels, load_system
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import start_state

__all__ = [
    "Basins",
    "attractors_found",
    "basins",
    "labels_of_starts",
    "other_states",
    "plane_of_starts",
]

_FIRST_LOOK = 60  # transitions, about
_KEPT = 65  # entries at the end of a motion that is classified
_LARGEST_PLANE = 4_000_000  # starts


@dataclass(frozen=True, eq=False)
class Basins:
    """Where the starts of a plane lead.

    Attributes
    ----------
    found : Found
        The attractors.
    x, y : str
        States along the axes; the others are those of `start`.
    x_values : array (n,)
    y_values : array (m,)
    labels : array (m, n) of int
        As `Found.labels`; `Outcome.ILLEGAL` where a start belongs to no configuration.
    start : array (N,)
    """

    found: Found
    x: str
    y: str
    x_values: np.ndarray
    y_values: np.ndarray
    labels: np.ndarray
    start: np.ndarray


def basins(
    found: Found,
    x: tuple[str, float, float, int],
    y: tuple[str, float, float, int],
    start: Mapping[str, object] | None = None,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] = lambda done: None,
) -> Basins:
    """Label a plane of starts by the attractor they lead to.

    Parameters
    ----------
    found : Found
    x, y : (state, lower, upper, count)
    start : mapping of state to number, optional
        The other states; 0 for those that are not named, the phase 0 of a forcing.
    threads : int, optional
        As many as processors when omitted.
    progress : callable
        Told how many rows of y are done.

    Returns
    -------
    Basins
        Labels of rows of y and columns of x.

    Raises
    ------
    InputError
        For wrong names or numbers.
    Interrupted
        By Ctrl-C; the rest of its `partial` is not classified.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> found = ns.find_orbits("dry-friction", data, n=20, transitions=200)
    >>> basins(found, ("x1", -1, 1, 3), ("x2", -1, 1, 2)).labels.tolist()
    [[0, 0, 0], [0, 0, 0]]
    """
    kernels = load_system(found.system)
    axes, base = plane_of_starts(kernels, x, y, start)
    attractors = attractors_found(found, kernels)
    labels = np.full((axes[1].size, axes[0].size), int(Outcome.UNCLASSIFIED))
    plane = Basins(found, x[0], y[0], axes[0], axes[1], labels, base)
    rows = max(1, 20_000 // axes[0].size)
    try:
        for low_row in range(0, axes[1].size, rows):
            here = slice(low_row, low_row + rows)
            starts = np.broadcast_to(base, (len(axes[1][here]), axes[0].size, base.size)).copy()
            starts[..., found.names.index(x[0])] = axes[0]
            starts[..., found.names.index(y[0])] = axes[1][here, None]
            flat = starts.reshape(-1, base.size)
            arrived = labels_of_starts(kernels, found, attractors, flat, threads)
            labels[here] = arrived.reshape(-1, axes[0].size)
            progress(min(low_row + rows, axes[1].size))
    except KeyboardInterrupt:
        raise Interrupted(plane) from None
    return plane


def plane_of_starts(
    kernels: SystemKernels,
    x: tuple[str, float, float, int],
    y: tuple[str, float, float, int],
    start: Mapping[str, object] | None = None,
) -> tuple[list[np.ndarray], np.ndarray]:
    """Both axes of a plane of starts, and the state that holds its other coordinates.

    Parameters
    ----------
    kernels : SystemKernels
    x : (state, lower, upper, count)
    y : (state, lower, upper, count)
    start : mapping of str to number, optional
        The other states; 0 for those that are not named, the phase 0 of a forcing.

    Returns
    -------
    tuple of list of array, array (N,)

    Raises
    ------
    InputError
        For wrong names or numbers.
    """
    structure, axes = structure_of(kernels), []
    structure.check_listed("a picture of basins")
    for name, low, high, count in (x, y):
        if name not in structure.states:
            raise unknown_name("state", name, structure.states)
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"{name}: {low!r} to {high!r} is no interval")
        axes.append(np.linspace(low, high, checked_count(f"count of {name}", count, 2)))
    if x[0] == y[0]:
        raise InputError(f"both axes are {x[0]}")
    if axes[0].size * axes[1].size > _LARGEST_PLANE:
        raise InputError(f"more than {_LARGEST_PLANE} starts")
    return axes, other_states(kernels, start)


def other_states(
    kernels: SystemKernels, start: Mapping[str, object] | Sequence[object] | None
) -> np.ndarray:
    """The state that holds what a plane of starts does not sweep.

    Parameters
    ----------
    kernels : SystemKernels
    start : mapping of str to number, or sequence, or None
        0 for states that are not named, the phase 0 of a forcing.

    Returns
    -------
    array (N,)

    Raises
    ------
    InputError
        For wrong names or numbers.
    """
    structure = structure_of(kernels)
    if start is not None and not isinstance(start, Mapping):
        return start_state(structure, start)
    turning = {place for pair in structure.forcing for place in pair}
    zero = {name: 0 for k, name in enumerate(structure.states) if k not in turning}
    return start_state(structure, zero | dict(start or {}))


def attractors_found(found: Found, kernels: SystemKernels) -> Attractors:
    """What was found, in the order of its labels.

    Parameters
    ----------
    found : Found
    kernels : SystemKernels
        Of its system.
    """
    point = piecewise(kernels, found.parameters)
    orbits = tuple(entry.orbit for entry in found.orbits)
    equilibria = tuple(entry.equilibrium for entry in found.equilibria)
    return replace(attractors_of(kernels, point, ()), orbits=orbits, equilibria=equilibria)


def labels_of_starts(
    kernels: SystemKernels,
    found: Found,
    attractors: Attractors,
    starts: np.ndarray,
    threads: int | None = None,
) -> np.ndarray:
    """Labels of starts: followed four times longer as long as they are not classified.

    Parameters
    ----------
    kernels : SystemKernels
        Of the system.
    found : Found
    attractors : Attractors
        As `attractors_found` gives them.
    starts : array (n, N)
    threads : int, optional
        As many as processors when omitted.

    Returns
    -------
    array (n,) of int
        As `Found.labels`.
    """
    values = {name: float(value) for name, value in found.parameters.items()}
    labels = np.full(len(starts), int(Outcome.UNCLASSIFIED))
    length = found.transitions
    lengths = [length]
    while length > 2 * _FIRST_LOOK:
        length //= 4
        lengths.insert(0, length)
    for length in lengths:
        open_ = np.flatnonzero(labels == Outcome.UNCLASSIFIED)
        if not open_.size:
            break
        motions = simulate_many(
            kernels, values, starts[open_], transitions=length, keep=_KEPT, threads=threads
        )
        labels[open_] = attractors.labels(motions)
        if length == found.transitions:
            labels[open_] = attractors.measured(motions, labels[open_], threads)
    return labels
