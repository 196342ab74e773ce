"""Orbits of a chart from those near by: on the lattice of anchors, then between the anchors.

Anchors tell each other what they have found until none has anything better to tell. That
depends on the grid alone, and so does the start of each point between them. What a point has
found is then compared with what those next to it have found on their own. So nothing depends on
chunks.

Of several orbits a stable or neutral motion is better than another motion, a motion than an
orbit that is none, and that than nothing: their ranks are 3, 2, 1, 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import prod

import numpy as np

from nonsmooth.runtime.explore.charting.grid import Block, Grid
from nonsmooth.runtime.shooting.newton import CONVERGED

_SAME = 1e-6  # relative difference of one orbit found twice
_NEAR = 0.05  # relative difference of orbits of one branch at points next to each other
_BRANCH = 0.3  # relative range of an unknown over the corners of a cell on one branch
_SHARE = 0.3  # of the longest dwell time, and of usual sizes: what is smaller is measured by it
_BEST = 3
_STEPS = 8  # from one anchor to the next
_ROUNDS = 2  # in which anchors give way to most of their neighbours


Columns = dict[str, np.ndarray]  # what is known of some points, by the name of the variable


@dataclass(frozen=True)
class Solver:
    """A solver for the orbits at points (n,) of a grid."""

    # values of the axes (n,) and starts (n, m), None for the solver's own starts, to columns with
    # "status", "admissible" and "margin" among them
    solve: Callable[[Mapping[str, np.ndarray], np.ndarray | None], Columns]
    start_names: Sequence[str]  # columns (n,) that make up starts, NaN without an orbit
    # sizes (m,) of the entries of a start at the reference orbit, 0 for dwell times
    usual: np.ndarray

    def starts_of(self, columns: Columns) -> np.ndarray:
        """Starts (n, m) that lead to the same orbits again."""
        starts = np.empty((len(columns["status"]), len(self.start_names)))
        for place, name in enumerate(self.start_names):
            starts[:, place] = columns[name]
        return starts


@dataclass(frozen=True, eq=False)
class _Field:
    """The orbits at all points of a lattice; the arrays are flat and are improved in place."""

    solver: Solver
    shape: tuple[int, ...]
    values: Mapping[str, np.ndarray]
    columns: Columns
    starts: np.ndarray
    ranks: np.ndarray

    def improve(self, places: np.ndarray, starts: np.ndarray | None) -> np.ndarray:
        """Solve again at some places, keep the better orbits and return the places of these."""
        if starts is not None:
            there = np.isfinite(starts).all(axis=-1)
            places, starts = places[there], starts[there]
        if not len(places):
            return places
        columns = self.solver.solve(_at(self.values, places), starts)
        better = _ranks(columns) > self.ranks[places]
        if starts is None:  # why nothing was found is best told by the whole search
            better |= (self.ranks[places] == 0) & (columns["status"] != CONVERGED)
        self.put(places[better], _at(columns, better))
        return np.asarray(places[better])

    def put(self, places: np.ndarray, columns: Columns) -> None:
        """Store the columns of some places, with their starts and ranks."""
        for name, column in columns.items():
            self.columns[name][places] = column
        self.starts[places] = self.solver.starts_of(columns)
        self.ranks[places] = _ranks(columns)


def anchor_starts(grid: Grid, solver: Solver) -> np.ndarray:
    """Starts (..., m) at all anchors of a grid; NaN where there is no orbit.

    The leading axes are those of the lattice of anchors; m is 0 for explicit equations.
    """
    field = _field(grid.anchor_values, solver, None)
    if field.starts.shape[-1] == 0:
        return field.starts.reshape(*field.shape, 0)
    told = np.ones(len(field.ranks), dtype=bool)
    while told.any():
        while told.any():
            told = _told(field, told, 1)
        # what a neighbour has may be too far away: go there step by step
        told = _told(field, np.ones_like(told), _STEPS)
    for _ in range(_ROUNDS):
        _reconsider(field, np.arange(len(field.ranks)))
    return field.starts.reshape(*field.shape, -1)


def solve_block(block: Block, anchors: np.ndarray, solver: Solver) -> Columns:
    """All columns at the points of a chunk, by name and in the chunk's shape.

    `anchors` (..., m) are the starts at the anchors of the whole grid (`anchor_starts`).
    """
    if anchors.shape[-1] == 0:  # explicit equations, which start from nothing
        found = _field(block.values, solver, None)
        return {name: column.reshape(found.shape) for name, column in found.columns.items()}
    (first, *others), mixed = _starts_between(block, anchors, solver.usual)
    field = _field(block.wide_values, solver, first)
    for start in others:
        places = np.flatnonzero(field.ranks < _BEST)
        field.improve(places, start[places])
    # within one branch the anchors' own searches, the longest of all, have said enough
    wanted = (field.ranks == 0) | ((field.ranks == 1) & mixed)
    field.improve(np.flatnonzero(wanted), None)
    inside = np.arange(len(field.ranks)).reshape(field.shape)[block.inner]
    _reconsider(field, inside.ravel())
    return _at(field.columns, inside)


def _at(columns: Mapping[str, np.ndarray], places: np.ndarray) -> Columns:
    """The part of some columns at some places."""
    return {name: column[places] for name, column in columns.items()}


def _field(values: Mapping[str, np.ndarray], solver: Solver, start: np.ndarray | None) -> _Field:
    """Solve at all points of a lattice from given starts (n, m), or from the solver's own."""
    shape = np.broadcast_shapes(*(row.shape for row in values.values()))
    flat = {name: np.broadcast_to(row, shape).ravel() for name, row in values.items()}
    columns = solver.solve(flat, start)
    return _Field(solver, shape, flat, columns, solver.starts_of(columns), _ranks(columns))


def _ranks(columns: Columns) -> np.ndarray:
    there, motion = columns["status"] == CONVERGED, columns["admissible"]
    with np.errstate(invalid="ignore"):
        return np.asarray(there.astype(int) + motion + (motion & (columns["margin"] >= 0)))


def _told(field: _Field, tell: np.ndarray, steps: int) -> np.ndarray:
    """Offer each point the better orbits of its neighbours; returns a mask of the improved points.

    Only points in `tell` pass on their orbit. It is continued to the neighbour in `steps` steps.
    """
    improved, solver = np.zeros_like(tell), field.solver
    for here, there in _pairs(field.shape):
        asks = tell[there] & (field.ranks[there] > field.ranks[here])
        to, of = here[asks], there[asks]
        starts = field.starts[of]
        for step in range(1, steps if len(to) else 1):
            part = step / steps
            between = {n: row[of] + part * (row[to] - row[of]) for n, row in field.values.items()}
            starts = solver.starts_of(solver.solve(between, starts))
        improved[field.improve(to, starts)] = True
    return improved


def _pairs(shape: tuple[int, ...]) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Flat places of all pairs of neighbours, in both orders, for one axis after the other."""
    places = np.arange(int(np.prod(shape))).reshape(shape)
    for axis in range(len(shape)):
        lower, upper = (np.delete(places, end, axis=axis).ravel() for end in (-1, 0))
        yield upper, lower
        yield lower, upper


def _reconsider(field: _Field, among: np.ndarray) -> None:
    """Try the orbits of the neighbours where a point disagrees with them.

    A point disagrees if it has no orbit though most of its neighbours have one, if a
    neighbour has a better rank, or if most neighbours are on another branch. Among the orbits
    of the best rank the one that most starts lead to is kept. All points try the orbits that
    were known before this round.
    """
    count, solver = len(field.ranks), field.solver
    beside, there, near = (np.zeros(count, int) for _ in range(3))
    better = np.zeros(count, dtype=bool)
    sizes = np.abs(field.starts)
    for here, other in _pairs(field.shape):
        size = _sizes(np.maximum(sizes[here], sizes[other]), solver.usual)
        beside[here] += 1
        there[here] += field.ranks[other] > 0
        near[here] += (np.abs(field.starts[other] - field.starts[here]) <= _NEAR * size).all(
            axis=-1
        )
        better[here] |= field.ranks[other] > field.ranks[here]
    lost = (field.ranks == 0) & (2 * there > beside)
    better &= field.ranks > 0
    wanted = lost | better | ((field.ranks > 0) & (2 * near < there))
    places = among[wanted[among]]
    if not len(places):
        return
    values, found = _at(field.values, places), [_at(field.columns, places)]
    for here, other in _pairs(field.shape):
        starts = np.full_like(field.starts, np.nan)
        starts[here] = field.starts[other]
        found.append(solver.solve(values, starts[places]))
    best = _agreed(np.stack([solver.starts_of(one) for one in found]), found, solver.usual)
    chosen = {n: np.choose(best, [one[n] for one in found]) for n in found[0]}
    field.put(places, chosen)


def _agreed(starts: np.ndarray, found: list[Columns], usual: np.ndarray) -> np.ndarray:
    """Number of the orbit at each point with the best rank and, among these, the most agreement."""
    size = _sizes(np.abs(starts), usual)
    votes = [
        (np.abs(starts - one) <= _SAME * size).all(axis=-1).sum(axis=0) for one in starts
    ]  # what is NaN agrees with nothing
    ranks = np.stack([_ranks(one) for one in found])
    return np.asarray(np.argmax(np.stack(votes) + ranks * (len(found) + 1), axis=0))


def _sizes(starts: np.ndarray, usual: np.ndarray) -> np.ndarray:
    """Scales of starts (..., m): a short dwell time is measured by a share of the longest one."""
    longest = np.zeros(starts.shape[:-1])
    for k in np.flatnonzero(usual == 0).tolist():  # far quicker than a reduction of a short axis
        longest = np.maximum(longest, starts[..., k])
    least = np.where(usual == 0, longest[..., None], usual)
    return np.asarray(np.maximum(starts, _SHARE * least))


def _starts_between(
    block: Block, anchors: np.ndarray, usual: np.ndarray
) -> tuple[list[np.ndarray], np.ndarray]:
    """Starts (n, m) in the order in which they are tried, and a mask (n,) of mixed cells.

    A cell is mixed if its corners are not all on one branch. The first start is interpolated
    between the corners, or is that of the nearest corner in a mixed cell. The other starts are
    those of the remaining corners. NaN stands for a start that does not exist.
    """
    sides = [
        (cell, np.minimum(cell + 1, count - 1))
        for cell, count in zip(block.cells, anchors.shape[:-1], strict=True)
    ]
    corners = np.stack([anchors[np.ix_(*corner)] for corner in product(*sides)])
    lower, upper = corners.min(axis=0), corners.max(axis=0)
    size = _sizes(np.maximum(np.abs(lower), np.abs(upper)), usual)
    branch = (upper - lower <= _BRANCH * size).all(axis=-1)
    between, distances = np.zeros(corners.shape[1:]), np.full(corners.shape[:-1], np.inf)
    shares = product(*((1 - fraction, fraction) for fraction in block.fractions))
    for number, share in enumerate(shares):
        weights = np.ix_(*share)
        between = between + np.asarray(prod(weights))[..., None] * corners[number]
        there = np.isfinite(corners[number]).all(axis=-1)
        distances[number][there] = np.asarray(sum((1 - weight) ** 2 for weight in weights))[there]
    if branch.all():
        return [between.reshape(-1, corners.shape[-1])], ~branch.ravel()
    order = np.argsort(distances, axis=0, kind="stable")[..., None]
    nearest = np.take_along_axis(corners, order, axis=0)
    first = np.where(branch[..., None], between, nearest[0])
    rest = np.where(branch[..., None], np.nan, nearest[1:])
    return [start.reshape(-1, start.shape[-1]) for start in (first, *rest)], ~branch.ravel()
