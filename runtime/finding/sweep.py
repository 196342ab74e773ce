"""Attractors by brute force: over one parameter, or over a plane of starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from nonsmooth.runtime.errors import InputError, unknown_name
from nonsmooth.runtime.finding.find import Found
from nonsmooth.runtime.finding.outcomes import Attractors, Outcome, attractors_of
from nonsmooth.runtime.finding.settled import settled
from nonsmooth.runtime.kernels import SystemKernels, kernels_of, load_system
from nonsmooth.runtime.loading.declared import DeclaredSystem
from nonsmooth.runtime.simulation.piecewise import piecewise
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import start_state
from nonsmooth.runtime.simulation.structure import structure_of

__all__ = ["Basins", "Sweep", "basins", "sweep"]

_CHUNK = 64  # values of the parameter between two reports of progress
_FIRST_LOOK = 60  # transitions, about
_KEPT = 65  # entries at the end of a motion that is classified
_LARGEST_PLANE = 4_000_000  # starts


@dataclass(frozen=True, eq=False)
class Sweep:
    """Returns to one configuration over a parameter, after transients: a bifurcation diagram.

    Attributes
    ----------
    system, parameter, state, configuration : str
        At each entry of the configuration the state was taken.
    values : array (n,)
    samples : array (n, m)
        NaN where a motion entered the configuration less often, or ended.
    outcomes : array (n,) of int
        What the motions settle on: numbers of `nonsmooth.runtime.finding.settled`.
    """

    system: str
    parameter: str
    state: str
    configuration: str
    values: np.ndarray
    samples: np.ndarray
    outcomes: np.ndarray


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


def sweep(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    name: str,
    values: Any,
    start: Mapping[str, object],
    *,
    state: str,
    configuration: str,
    transient: int = 1000,
    samples: int = 60,
    follow: bool = True,
    threads: int | None = None,
    progress: Callable[[int], None] = lambda done: None,
) -> Sweep:
    """Follow motions over one parameter and take a state at each entry of a configuration.

    Parameters
    ----------
    parameters : mapping
        All others than `name`.
    values : array (n,)
    start : mapping of state to number
        Where every motion starts.
    transient : int
        Transitions before the first sample.
    samples : int
        Transitions among which the samples are taken.
    follow : bool
        Whether each chunk of values starts where the motion at the value before it ended, if
        that is possible; else all start at `start`.
    progress : callable
        Told how many values are done.

    Raises
    ------
    InputError
        For wrong names or numbers.
    """
    kernels = kernels_of(system)
    structure = structure_of(kernels)
    if state not in structure.states:
        raise unknown_name("state", state, structure.states)
    where = structure.configuration(configuration)
    try:
        grid = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        grid = np.empty(0)
    if grid.ndim != 1 or not grid.size or not np.isfinite(grid).all():
        raise InputError(f"the values of {name} are no row of finite numbers")
    if name in parameters:
        raise InputError(f"parameter {name} is both given and swept")
    skipped = checked_count("transient", transient, 0)
    taken = checked_count("samples", samples, 1)
    first = start_state(structure, start)
    place = structure.states.index(state)
    found, outcomes = np.full((grid.size, taken), np.nan), np.empty(grid.size, dtype=int)
    begin, followed = first, 0
    for low in range(0, grid.size, _CHUNK):
        here = slice(low, low + _CHUNK)
        point = {**parameters, name: grid[here]}
        motions = simulate_many(
            kernels,
            point,
            begin,
            transitions=skipped + taken,
            keep=max(taken, _KEPT),
            threads=threads,
        )
        outcomes[here] = settled(kernels, point, motions, threads).outcomes
        followed += int((motions.status >= 0).sum())
        # a motion that ended early has kept entries of its transient too
        places = motions.transitions[:, None] - np.arange(taken)[::-1]
        entered = (motions.last_configurations[:, -taken:] == where) & (places > skipped)
        states = motions.last_states[:, -taken:, place]
        found[here] = np.where(entered, states, np.nan)
        last = motions.states[-1]
        begin = last if follow and np.isfinite(last).all() else first
        progress(min(low + _CHUNK, grid.size))
    if not followed:
        raise InputError(f"for no value of {name} are the parameters and the start possible")
    return Sweep(kernels.name, name, state, configuration, grid, found, outcomes)


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
        The other states; 0 for those that are not named.
    progress : callable
        Told how many rows of y are done.

    Raises
    ------
    InputError
        For wrong names or numbers.
    """
    axes = []
    for name, low, high, count in (x, y):
        if name not in found.names:
            raise unknown_name("state", name, found.names)
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"{name}: {low!r} to {high!r} is no interval")
        axes.append(np.linspace(low, high, checked_count(f"count of {name}", count, 2)))
    if x[0] == y[0]:
        raise InputError(f"both axes are {x[0]}")
    if axes[0].size * axes[1].size > _LARGEST_PLANE:
        raise InputError(f"more than {_LARGEST_PLANE} starts")
    kernels = load_system(found.system)
    others: dict[str, object] = {name: 0 for name in found.names} | dict(start or {})
    base = start_state(structure_of(kernels), others)
    attractors = _attractors(found, kernels)
    labels = np.empty((axes[1].size, axes[0].size), dtype=int)
    rows = max(1, 20_000 // axes[0].size)
    for low_row in range(0, axes[1].size, rows):
        here = slice(low_row, low_row + rows)
        starts = np.broadcast_to(base, (len(axes[1][here]), axes[0].size, base.size)).copy()
        starts[..., found.names.index(x[0])] = axes[0]
        starts[..., found.names.index(y[0])] = axes[1][here, None]
        flat = _arrivals(found, attractors, starts.reshape(-1, base.size), threads)
        labels[here] = flat.reshape(-1, axes[0].size)
        progress(min(low_row + rows, axes[1].size))
    return Basins(found, x[0], y[0], axes[0], axes[1], labels, base)


def _attractors(found: Found, kernels: SystemKernels) -> Attractors:
    """What was found, in the order of its labels."""
    point = piecewise(kernels, found.parameters)
    orbits = tuple(entry.orbit for entry in found.orbits)
    equilibria = tuple(entry.equilibrium for entry in found.equilibria)
    return replace(attractors_of(kernels, point, ()), orbits=orbits, equilibria=equilibria)


def _arrivals(
    found: Found, attractors: Attractors, starts: np.ndarray, threads: int | None
) -> np.ndarray:
    """Labels of starts: followed four times longer as long as they are not classified."""
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
            found.system, values, starts[open_], transitions=length, keep=_KEPT, threads=threads
        )
        labels[open_] = attractors.labels(motions)
        if length == found.transitions:
            labels[open_] = attractors.measured(motions, labels[open_], threads)
    return labels
