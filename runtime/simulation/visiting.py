"""Configurations that motions visit, of systems in which they are made when they are visited.

A motion that enters a configuration of which nothing is known ends there, as one that reaches
boundaries together for which nothing is listed. Both are made, and the motion is followed again
from its start: its digits are those that it has where all configurations are listed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

import numpy as np

from nonsmooth.runtime.events.leading_derivative import leading_signs
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.flows import extended
from nonsmooth.runtime.model.kernels import SystemKernels, grown
from nonsmooth.runtime.model.loading.growing import Growth, Visit, growth_of
from nonsmooth.runtime.model.piecewise import piecewise_at
from nonsmooth.runtime.model.structure import Structure, structure_of
from nonsmooth.runtime.simulation.starting import orders_along

__all__ = ["visits_behind", "with_starts"]

_MOST_AT_REST = 64  # configurations that one start is tried in


def visits_behind(
    structure: Structure, configurations: Iterable[int], missing: Iterable[tuple[int, int]] = ()
) -> list[Visit]:
    """Visits that a system needs so that motions can go on that ended because nothing is declared.

    The motions ended in `configurations`. The pairs `missing` are a configuration and the
    mask of boundaries that are reached together in it. The list is empty if the system is
    listed whole.
    """
    names = structure.configurations
    found: list[Visit] = [
        (names[c], ()) for c in dict.fromkeys(configurations) if c in structure.unvisited
    ]
    for source, mask in dict.fromkeys(missing):
        reached = members_of(mask)
        if structure.unvisited - {source} and len(reached) > 1:
            boundaries = sorted(structure.boundaries[source][b].name for b in reached)
            found.append((names[source], tuple(boundaries)))
    return found


def with_starts(
    kernels: SystemKernels, points: np.ndarray, which: np.ndarray, states: np.ndarray
) -> SystemKernels:
    """The system, grown by the configurations that starts may belong to.

    `which` (n,) is the parameter point, of points (p, parameters), of each start (n, N). A
    system that is listed whole is returned unchanged.
    """
    growth = growth_of(kernels.module)
    if growth is None:
        return kernels
    kernels = grown(kernels)
    for place, point in enumerate(points):
        own = states[which == place]
        if len(own):
            kernels = _with_starts(kernels, growth, point, own[np.isfinite(own).all(axis=1)])
    return kernels


def _with_starts(
    kernels: SystemKernels, growth: Growth, point: np.ndarray, states: np.ndarray
) -> SystemKernels:
    system = piecewise_at(kernels, point, ())
    whole = extended(states)
    fields, rows = system.fields, system.rows
    signs: dict[int, np.ndarray] = {}

    def sign(row: int) -> np.ndarray:
        if row not in signs:
            value, error = next(orders_along(fields[:1], rows[row][None], whole))
            signs[row] = np.where(np.abs(value) <= error, 0, np.sign(value))
        return signs[row]

    fits = [
        {
            regime: np.logical_and.reduce(
                [np.ones(len(states), dtype=bool)]
                + [sign(row) <= 0 for row in bounds]
                + [sign(row) == 0 for row in vanishing]
            )
            for regime, (bounds, vanishing) in part.items()
        }
        for part in growth.starts
    ]
    # what holds comes first: a configuration with more constraints takes the state
    order = [_holding_first(part) for part in growth.starts]
    options = {
        tuple(
            tuple(r for r in regimes if found[r][k])
            for regimes, found in zip(order, fits, strict=True)
        ): k
        for k in range(len(states))
    }
    first = {growth.first_of(regimes): k for regimes, k in options.items()}
    kernels = grown(kernels, [(name, ()) for name in first if name is not None])
    for regimes, k in options.items():
        if any(len(each) > 1 for each in regimes):
            kernels = _at_rest(kernels, growth, point, whole[k], regimes)
    return kernels


def _holding_first(part: dict[str, tuple[list[int], list[int]]]) -> list[str]:
    return sorted(part, key=lambda regime: -len(part[regime][1]))


def _at_rest(
    kernels: SystemKernels,
    growth: Growth,
    point: np.ndarray,
    whole: np.ndarray,
    regimes: Sequence[Sequence[str]],
) -> SystemKernels:
    """The system, grown by the configurations of a start at rest.

    They are made one after the other, as their boundaries lead, until the start stays in
    one.
    """
    first = growth.first_of(regimes)
    level = [] if first is None else [first]
    tried: set[str] = set()
    while level and len(tried) < _MOST_AT_REST:
        kernels = grown(kernels, [(name, ()) for name in level])
        system, structure = piecewise_at(kernels, point, ()), structure_of(kernels)
        tried |= {*level}
        following, stays = dict[str, None](), False
        for name in level:
            c = structure.configuration(name)
            left = []
            for index, boundary in enumerate(structure.boundaries[c]):
                row = system.rows[boundary.row][None]
                found = orders_along(system.fields[c][None], row, whole[None])
                value, error = start = next(found)
                if value[0] > error[0] or leading_signs(chain([start], found))[0] > 0:
                    left.append(index)
            stays = stays or not left
            for transition in structure.transitions[c]:
                if transition.boundaries <= {*left}:
                    following[structure.configurations[transition.target]] = None
        if stays:
            break
        level = [name for name in following if name not in tried]
    return kernels
