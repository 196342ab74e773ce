"""Whether motions escape that go on from boundary to boundary: followed until it is decided.

Far out, in units of the size that boundaries, loads and forcing give a system, only its
homogeneous part counts: what escapes there grows in proportion to time, or exponentially. A
motion that leaves an unstable orbit or equilibrium grows to that size and no further, and one
that builds up to a response grows less and less.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.simulate import simulate_many

__all__ = ["Pursued", "natural_size", "numbers_of", "pursue"]

_ENDURING = 4096  # transitions for which every motion is followed on, at least
_BLOCKS = 5  # in which a motion that grows is followed on, each as long as all before
_STEADY = 3  # of them, one after the other, in which what escapes grows steadily
_PROPORTIONAL = 0.975  # growth by that in proportion to time
_FAR = 100.0  # natural sizes
_GROWTH = 1.05  # by the largest size so far: no more is none
_SINGULAR = 1e-10  # relative singular value of a field that has no equilibrium


class Pursued(NamedTuple):
    """Motions (n,) after a longer simulation, with masks (n,) of escaping and undecided ones.

    A motion is undecided if it still grows, but not as one that escapes.
    """

    motions: Trajectories
    escapes: np.ndarray
    undecided: np.ndarray


def pursue(
    kernels: SystemKernels,
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None = None,
) -> Pursued:
    """Motions (n,) of as many systems, followed for at least as many transitions again.

    They are followed further as long as they grow. They have to have ended after a number of
    transitions that is the same for all. `threads` None takes all processors.
    """
    count, kept = motions.last_times.shape
    values, far = (
        numbers_of(systems).items(),
        _FAR * np.array([natural_size(each) for each in systems]),
    )
    largest, steady = _sizes(systems, motions), np.zeros(count, dtype=int)
    escapes, going = np.zeros(count, dtype=bool), np.arange(count)
    total, length = int(motions.transitions.max(initial=0)), _ENDURING
    for _ in range(_BLOCKS):
        length = max(length, total)
        later = simulate_many(
            kernels,
            {n: np.asarray(value)[going] if np.ndim(value) else value for n, value in values},
            motions.last_states[going, -1],
            motions.last_configurations[going, -1],
            transitions=length,
            keep=kept,
            threads=threads,
        )
        motions = _replaced(motions, going, later)
        sizes = _sizes([systems[place] for place in going.tolist()], later)
        goes_on = later.status == Status.TRANSITIONS
        ratios = sizes / np.where(largest[going] > 0, largest[going], 1.0)
        in_proportion = ratios * total >= _PROPORTIONAL * (total + length)
        steady[going] = np.where(in_proportion, steady[going] + 1, 0)
        escapes[going] = goes_on & (steady[going] >= _STEADY) & (sizes >= far[going])
        largest[going] = np.maximum(largest[going], sizes)
        going = going[goes_on & (ratios > _GROWTH) & ~escapes[going]]
        total += length
        if not going.size:
            break
    undecided = np.zeros(count, dtype=bool)
    undecided[going] = True
    return Pursued(motions, escapes, undecided)


def numbers_of(systems: Sequence[PiecewiseLinear]) -> dict[str, float | np.ndarray]:
    """Parameters of systems (n,) as arrays (n,), or as numbers where all are the same system."""
    first = systems[0]
    if all(system is first for system in systems):
        return {name: float(value) for name, value in first.parameters.items()}
    return {
        name: np.array([float(system.parameters[name]) for system in systems])
        for name in first.parameters
    }


def natural_size(system: PiecewiseLinear) -> float:
    """Distance that a system's boundaries, its equilibria and its responses to the forcing reach.

    All configurations count, admissible or not; a homogeneous system has the distance zero.
    It is in the unit of velocities; positions count times the fastest exponent.
    """
    structure, weights = system.structure, _weights(system)
    own = np.flatnonzero(weights)
    used = {b.row for boundaries in structure.boundaries for b in boundaries}
    used |= {row for rows in structure.constraints for row in rows}
    rows = np.abs(system.rows[sorted(used)])
    across = (rows[:, own] / weights[own]).sum(axis=1)
    other = np.delete(rows, own, axis=1).sum(axis=1)
    found = float((other[across > 0] / across[across > 0]).max(initial=0.0))
    for field in system.fields:
        matrix, size = field[np.ix_(own, own)], np.zeros(len(own))
        loads = [(0.0, field[own, -1])]
        for cosine, sine in structure.forcing:
            loads.append((float(field[sine, cosine]), field[own, cosine] - 1j * field[own, sine]))
        for speed, load in loads:
            dynamic = 1j * speed * np.eye(len(own)) - matrix
            size += np.abs(np.linalg.lstsq(dynamic, load, rcond=_SINGULAR)[0])
        found = max(found, float((weights[own] * size).max(initial=0.0)))
    return found


def _weights(system: PiecewiseLinear) -> np.ndarray:
    """Weights (N,) that make states comparable.

    They are the fastest exponent for positions, 0 for the states of a forcing, and 1 for others.
    """
    structure = system.structure
    rates = [np.hypot(*exponents.T) for exponents in system.exponents]
    fastest = float(np.concatenate(rates).max(initial=0.0))
    found = np.ones(len(structure.states))
    found[[position for position, _ in structure.coordinates]] = fastest or 1.0
    found[[state for pair in structure.forcing for state in pair]] = 0.0
    return found


def _sizes(systems: Sequence[PiecewiseLinear], motions: Trajectories) -> np.ndarray:
    """Largest sizes (n,) of motions over the entries that are kept, up to translations."""
    ends = np.concatenate([motions.last_states, motions.states[:, None]], axis=1)
    known = np.where(np.isnan(ends), 0.0, ends)
    found = np.empty(len(systems))
    for place, system in enumerate(systems):
        states = up_to_shift(known[place], translations_of(system))
        found[place] = (np.abs(states) * _weights(system)).max()
    return found


def _replaced(motions: Trajectories, places: np.ndarray, others: Trajectories) -> Trajectories:
    """The motions, with others in some of the places."""
    changed = {}
    for name in (field.name for field in fields(motions) if field.name != "structure"):
        changed[name] = getattr(motions, name).copy()
        changed[name][places] = getattr(others, name)
    return replace(motions, **changed)
