"""Sets that cover each other, looked for in double precision along a chaotic motion.

Many small parallelepipeds stand about points of the motion, each with its long side in the
direction that is stretched. Their images under powers of the map lie along the motion too: where
one crosses another set from end to end, and between its other sides, there is an edge of a
graph. A closed walk is looked for with a second way from one of its vertices to one, as short as
there are any. Nothing here is a proof.

What is found must not depend on the last digits of a start, which a chaotic motion makes large:
so the sets are many, about different points, and walks choose among all of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.proof.chaos.h_sets import HSet, decimal_set, grid_in_cube, growth
from nonsmooth.runtime.proof.sets.section_choice import FloatSection

_SEED = 3
_POINT = 1e-9  # of the range along a motion: points of a section that are one
_ORBITS, _LENGTH = 600, 10  # each begins behind the end of the one before
_TURNING = 8  # iterates in which directions turn to the one that is stretched
_RADII = (0.12, 0.06, 0.03)  # half the long sides, in units of the motion's range
_WIDTHS = (0.5, 1.5)  # the other sides, in units of the long one
_LINE, _ACROSS = 17, 2  # samples of a set
_FINE = (401, 5)  # of one that may be proved
_EDGE = 1.1  # where the images of the ends are to lie
_INSIDE = 0.85  # of a set's width that images may have
_UNEVEN = 6.0  # how much more than in the mean images may be stretched
_SPARE = 3  # times as many points as sets: about some no set can stand
_GAP = 1.02  # between sets
_ASLANT = 0.05  # cosine between the long side and what is stretched
_LONGEST = 10  # sets on a closed walk
_KEPT = 6  # pairs of walks for each size of the sets


class StretchedOrbits(NamedTuple):
    """Motions on a section: coordinates, derivatives, and directions that are stretched."""

    points: np.ndarray  # (m, orbits, d), in units of `sizes`
    directions: np.ndarray  # (m, orbits, d), of length 1 in these units
    sizes: np.ndarray  # (d,): half the ranges of the coordinates
    middle: np.ndarray  # (d,)
    growth: float  # mean logarithm of the largest stretching in one iterate


class Horseshoe(NamedTuple):
    """Sets that seem to cover each other under a power of the map."""

    iterates: int
    h_sets: tuple[HSet, ...]
    edges: tuple[tuple[int, int], ...]

    @property
    def entropy(self) -> float:
        """The entropy of one iterate of the map, if the coverings are proved."""
        return math.log(max(float(growth(len(self.h_sets), self.edges)[0]), 1.0)) / self.iterates


def orbits_on(
    section: FloatSection, points: np.ndarray, ranges: np.ndarray
) -> StretchedOrbits | None:
    """Some motions on a section, with the direction that is stretched most.

    `points` (n, d) are of a long motion, `ranges` (d,) those of the coordinates along it. None
    where the motions do not stay on the section, or the section is one point.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    sizes, middle = (high - low) / 2, (high + low) / 2
    if not (sizes > _POINT * ranges).all():
        return None
    now = points[np.linspace(0, len(points) - 1, _ORBITS).astype(int)]
    random = np.random.default_rng(_SEED)
    vectors = random.normal(size=now.shape)
    rates, found, directions = [], [], []
    for step in range(_TURNING + _LENGTH):
        mapped, slopes = section.jacobians(now, sizes)
        slopes = slopes * sizes / sizes[:, None]
        vectors = np.einsum("nij,nj->ni", slopes, vectors)
        lengths = np.linalg.norm(vectors, axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            vectors = vectors / lengths[:, None]
            if step >= _TURNING:
                rates.append(np.log(lengths))
        now = mapped.points
        lost = ~np.isfinite(vectors).all(axis=1)
        vectors[lost] = random.normal(size=(lost.sum(), now.shape[1]))
        if step >= _TURNING:
            found.append((now - middle) / sizes)
            directions.append(np.where(lost[:, None], np.nan, vectors))
    rated = np.array(rates)
    rated = rated[np.isfinite(rated)]
    if rated.size < _LENGTH:
        return None
    return StretchedOrbits(
        np.array(found), np.array(directions), sizes, middle, float(rated.mean())
    )


def candidates(
    section: FloatSection, orbits: StretchedOrbits, most_iterates: int, bases: int
) -> Iterator[Horseshoe]:
    """Yield sets that seem to cover each other along two closed walks, the cheapest to prove first.

    Sets stand about at most `bases` points of the motion, for each power of the map in turn.
    """
    size = orbits.points.shape[-1]
    points, directions = (x.reshape(-1, size) for x in (orbits.points, orbits.directions))
    good = np.isfinite(points).all(axis=1) & np.isfinite(directions).all(axis=1)
    chosen = np.random.default_rng(_SEED).permutation(np.flatnonzero(good))[: _SPARE * bases]
    scaled = _ScaledMap(section, orbits)
    for iterates in range(1, most_iterates + 1):
        across = scaled.contracted(points[chosen], directions[chosen], iterates)
        sound = np.flatnonzero(np.isfinite(across).all(axis=(1, 2)))[:bases]
        centres, along = points[chosen][sound], directions[chosen][sound]
        found = []
        for radius, width in product(_RADII, _WIDTHS if size > 1 else _WIDTHS[:1]):
            frames = radius * np.concatenate([along[:, :, None], width * across[sound]], axis=2)
            covers, uneven = _covers(scaled, centres, frames, iterates, _LINE, _ACROSS)
            for kept in map(np.array, _walks(covers, centres, frames)):
                found.append((float(uneven[kept].sum()), centres[kept], frames[kept]))
        for _, centres, frames in sorted(found, key=lambda walk: walk[0]):
            covers, _ = _covers(scaled, centres, frames, iterates, *_FINE)
            candidate = _candidate(scaled, centres, frames, covers, iterates)
            if candidate is not None:
                yield candidate


def _candidate(
    scaled: _ScaledMap,
    centres: np.ndarray,
    frames: np.ndarray,
    covers: np.ndarray,
    iterates: int,
) -> Horseshoe | None:
    """The sets of a graph with a spectral radius above 1, in the section's own units; else None."""
    edges = [(int(i), int(j)) for i, j in np.argwhere(covers)]
    bound, kept = growth(len(centres), edges)
    if bound <= 1:
        return None
    sets = tuple(
        decimal_set(
            f"N{place}",
            centres[k] * scaled.sizes + scaled.middle,
            frames[k] * scaled.sizes[:, None],
        )
        for place, k in enumerate(kept, 1)
    )
    number = {k: place for place, k in enumerate(kept)}
    inner = tuple((number[i], number[j]) for i, j in edges if i in number and j in number)
    return Horseshoe(iterates, sets, inner)


class _ScaledMap:
    """The map in units of the motion's ranges."""

    def __init__(self, section: FloatSection, orbits: StretchedOrbits) -> None:
        self.section, self.middle, self.sizes = section, orbits.middle, orbits.sizes

    def map(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Images of points (n, d), and their ways."""
        mapped = self.section.map(points * self.sizes + self.middle)
        return (mapped.points - self.middle) / self.sizes, mapped.ways

    def contracted(self, points: np.ndarray, along: np.ndarray, iterates: int) -> np.ndarray:
        """Directions (n, d, d - 1) that are contracted most; NaN where `along` is one of them."""
        count, size = points.shape
        now = points * self.sizes + self.middle
        total = np.broadcast_to(np.eye(size), (count, size, size))
        for _ in range(iterates if size > 1 else 0):
            mapped, slopes = self.section.jacobians(now, self.sizes)
            total = (slopes * self.sizes / self.sizes[:, None]) @ total
            now = mapped.points
        sound = np.asarray(np.isfinite(total).all(axis=(1, 2)))
        _, _, right = np.linalg.svd(np.where(sound[:, None, None], total, 0.0))
        cosines = np.abs(np.asarray(np.einsum("nd,nd->n", right[:, 0], along)))
        found = right[:, 1:].transpose(0, 2, 1)
        usable = sound & (cosines > _ASLANT) if size > 1 else sound
        return np.where(usable[:, None, None], found, np.nan)


def _covers(
    scaled: _ScaledMap,
    centres: np.ndarray,
    frames: np.ndarray,
    iterates: int,
    line: int,
    across: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Which sets seem to cover which (n, n) by samples, and how unevenly each stretches (n,)."""
    count, size = centres.shape
    grid = grid_in_cube(size, line, across)
    images, inverses = centres[:, None] + grid @ frames.transpose(0, 2, 1), np.linalg.inv(frames)
    whole = np.ones(count, dtype=bool)
    for _ in range(iterates):  # of sets that have gone one way so far
        now, ways = scaled.map(images[whole].reshape(-1, size))
        images[whole], ways = now.reshape(-1, len(grid), size), ways.reshape(-1, len(grid))
        whole[whole] = (ways == ways[:, :1]).all(axis=1) & (ways[:, 0] >= 0)
    # next to where the map is not smooth the image of a set is stretched unevenly
    steps = np.linalg.norm(np.diff(images.reshape(count, line, -1, size), axis=1), axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        uneven = (steps.max(axis=1) / steps.mean(axis=1)).max(axis=1)
        whole &= np.less_equal(uneven, _UNEVEN)
    found = np.zeros((count, count), dtype=bool)
    side = len(grid) // line  # samples of one end
    unstable, about = inverses[:, 0].T, inverses @ centres[:, :, None]
    for i in np.flatnonzero(whole):
        ends = images[i, :side], images[i, -side:]
        first, last = (end @ unstable - about[:, 0, 0] for end in ends)
        crosses = (first < -_EDGE).all(axis=0) & (last > _EDGE).all(axis=0)
        crosses |= (first > _EDGE).all(axis=0) & (last < -_EDGE).all(axis=0)
        crossed = np.flatnonzero(crosses)
        seen = np.abs(np.tensordot(inverses[crossed], images[i], (2, 1)) - about[crossed])
        away = (seen[:, :1] > _EDGE) | (seen[:, 1:] < _INSIDE)
        found[i, crossed] = away.all(axis=(1, 2))
    return found, uneven


def _walks(covers: np.ndarray, centres: np.ndarray, frames: np.ndarray) -> list[list[int]]:
    """The vertices of each shortest closed walk that has a second way between two of its vertices.

    Sets on them are disjoint. The walks choose among all sets, also those that meet: which are
    taken is decided on the way.
    """
    covered, meeting = (
        [set(np.flatnonzero(row).tolist()) for row in graph]
        for graph in (covers, _meets(centres, frames))
    )
    best: list[tuple[int, tuple[int, ...]]] = []
    for start in _recurrent(covers).tolist():
        most = best[-1][0] if len(best) == _KEPT else 2 * _LONGEST  # longer ones are not kept
        closed = _way(covered, meeting, [start], set(), most)
        if closed:
            edges = set(zip(closed, [*closed[1:], start], strict=True))
            second = _way(covered, meeting, closed, edges, most + 1 - len(closed))
            if second:
                members = tuple(sorted({*closed, *second}))
                best = sorted({*best, (len(members), members)})[:_KEPT]
    return [list(members) for _, members in best]


def _recurrent(covers: np.ndarray) -> np.ndarray:
    """Vertices that have edges both from and to vertices of this kind, perhaps themselves."""
    left = np.ones(len(covers), dtype=bool)
    while True:
        fewer = left & covers[:, left].any(axis=1) & covers[left].any(axis=0)
        if (fewer == left).all():
            return np.flatnonzero(left)
        left = fewer


def _way(
    covered: list[set[int]],
    meeting: list[set[int]],
    ends: list[int],
    gone: set[tuple[int, int]],
    most: int,
) -> list[int]:
    """At most `most` vertices of a short way from one of `ends` to one, without edges in `gone`.

    None of the sets on it meets another one or one of the ends. Empty where there is none.
    """
    taken = set().union(*(meeting[end] for end in ends))
    queue = [[vertex] for vertex in ends]
    for way in queue:
        last = way[-1]
        if any((last, end) not in gone for end in covered[last].intersection(ends)):
            return way
        if len(way) >= min(most, _LONGEST):
            continue
        free = (covered[last] - taken).difference(*(meeting[vertex] for vertex in way))
        taken |= free
        queue += [[*way, other] for other in sorted(free)]
    return []


def _meets(centres: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Which sets meet, or nearly so (n, n): no side's direction separates them."""
    inverses = np.linalg.inv(frames)
    places = np.tensordot(inverses, centres, (2, 1))  # of set j in coordinates a of i: (i, a, j)
    between = places - np.diagonal(places, axis1=0, axis2=2).T[:, :, None]
    reach = np.abs(np.tensordot(inverses, frames, (2, 1))).sum(axis=-1)
    apart = (np.abs(between) - reach > _GAP).any(axis=1)
    return np.asarray(~(apart | apart.T))
