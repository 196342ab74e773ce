"""Starts of motions: the box in which they are drawn, and where they lead."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import by_name
from nonsmooth.runtime.explore.finding.found import Found
from nonsmooth.runtime.explore.finding.outcomes import Attractors, Outcome, attractors_of
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.simulation.simulate import simulate_many
from nonsmooth.runtime.simulation.starting import start_state

__all__ = [
    "attractors_found",
    "labels_of_starts",
    "other_states",
    "start_box",
]

_FIRST_LOOK = 60  # transitions, about
_KEPT = 65  # entries at the end of a motion that is classified


def start_box(
    system: PiecewiseLinear, given: Mapping[str, tuple[float, float]] | None = None
) -> np.ndarray:
    """Bounds (N, 2) between which starts are drawn, the same in all units.

    For each state they are twice the largest size at which a boundary or a constraint lies, on
    both sides. For a state without one, they are twice the size at which the equations of
    motion balance it with the others, the loads and the forcings, at the rate of the system.
    `given` replaces the bounds of some states; unknown names and empty intervals are refused.
    """
    structure = system.structure
    used = {b.row for boundaries in structure.boundaries for b in boundaries}
    used |= {row for rows in structure.constraints for row in rows}
    rows = system.rows[sorted(used)]
    with np.errstate(divide="ignore", invalid="ignore"):
        sizes = np.abs(rows[:, -1:] / rows[:, :-1])
    sizes[~np.isfinite(sizes)] = 0.0
    largest = sizes.max(axis=0, initial=0.0)
    forced = list(structure.forced)
    largest[forced] = 1.0
    largest = _balanced(np.abs(system.fields), largest)
    limits = np.stack([-2 * largest, 2 * largest], axis=1)
    limits[forced] = -1.0, 1.0  # of starts on a circle
    for name, bounds in by_name("box", given).items():
        if name not in structure.states:
            raise unknown_name("state", str(name), structure.states)
        try:
            low, high = map(float, bounds)
        except (TypeError, ValueError):
            raise InputError(f"box of {name}: {bounds!r} is no pair of numbers") from None
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"box of {name}: {low!r} to {high!r} is no interval")
        limits[structure.states.index(name)] = low, high
    return limits


def _balanced(fields: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Sizes (N,) of states: the known ones, and sizes that balance these for states of size 0.

    In a time 1 / rate a state moves by no less than its own size under those that are known,
    and moves those by no less than theirs. Fields (configurations, N, N + 1) are absolute.
    """
    couplings = fields.max(axis=0)
    sizes = np.append(known, 1.0)  # the last one is the constant's
    rate = _rate(fields, sizes)
    coupled = couplings[:, :-1] > 0
    while rate > 0:
        moving = np.zeros(coupled.shape)
        with np.errstate(over="ignore", invalid="ignore"):
            moved = couplings @ sizes / rate
            np.divide(rate * sizes[:-1, None], couplings[:, :-1], out=moving, where=coupled)
            found = np.maximum(moved, moving.max(axis=0))
        found[(sizes[:-1] > 0) | ~np.isfinite(found)] = 0.0
        if not found.any():
            break
        sizes[:-1] += found
    return np.where(sizes[:-1] > 0, sizes[:-1], 1.0)


def _rate(fields: np.ndarray, sizes: np.ndarray) -> float:
    """The geometric mean over the configurations of the rate of the fastest motion in each.

    That is an eigenvalue, or the fall under a load through the size of a state.
    """
    rates = []
    for field in fields:
        with np.errstate(over="ignore", invalid="ignore"):
            fall = field[:, :-1] @ field[:, -1] / np.where(sizes[:-1] > 0, sizes[:-1], np.inf)
        around = np.abs(np.linalg.eigvals(field[:, :-1])).max()
        rates.append(max(float(around), float(fall.max()) ** 0.5))
    moving = [rate for rate in rates if 0 < rate < np.inf]
    return float(np.exp(np.mean(np.log(moving)))) if moving else 0.0


def other_states(
    kernels: SystemKernels, start: Mapping[str, object] | Sequence[object] | None
) -> np.ndarray:
    """The state (N,) that starts of a chart take their other coordinates from.

    States that `start` does not name are 0, and a forcing has the phase 0. Wrong names or
    numbers are refused.
    """
    structure = structure_of(kernels)
    if start is not None and not isinstance(start, Mapping):
        return start_state(structure, start)
    turning = {place for pair in structure.forcing for place in pair}
    zero = {name: 0 for k, name in enumerate(structure.states) if k not in turning}
    return start_state(structure, zero | dict(start or {}))


def attractors_found(found: Found, kernels: SystemKernels) -> Attractors:
    """The orbits and equilibria of a search as `Attractors`, in the order of its labels."""
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
    """Labels (n,) of starts (n, N), as in `Found.labels`.

    The starts are followed four times longer as long as they are not classified.
    `attractors` are those of `attractors_found`; `threads` None takes all processors.
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
