"""Edges that tiles of a box of two parameters have in common, and what is joined by them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.proof.boxes.tile_event import BEYOND
from nonsmooth.runtime.proof.boxes.tile_places import Interval, Place, Point

if TYPE_CHECKING:
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile

__all__ = ["Edge", "Groups", "beyond_folds", "edges_of", "joined_edges", "meeting_point"]

_SHARES = tuple(Fraction(k, 32) for k in (16, 8, 24, 4, 28, 1, 31, 0, 32))  # of an edge


class Edge(NamedTuple):
    """The common edge of two tiles; along its axis the second tile follows the first."""

    first: int  # number of a tile
    second: int  # number of a tile
    ends: tuple[Point, Point]  # two points, in shares of the box from 0 to 1


def edges_of(places: Sequence[Place]) -> list[Edge]:
    """The common edges of tiles of a box of two parameters, where they are longer than a point."""
    found = []
    for axis in (0, 1):
        sides: dict[Fraction, tuple[list[Any], list[Any]]] = defaultdict(lambda: ([], []))
        for number, place in enumerate(places):
            (low, high), across = place.shares[axis], place.shares[1 - axis]
            sides[high][0].append((across, number))
            sides[low][1].append((across, number))
        for at, (before, behind) in sides.items():
            for (low, high), first, second in _overlaps(sorted(before), sorted(behind)):
                ends = ((at, low), (at, high)) if axis == 0 else ((low, at), (high, at))
                found.append(Edge(first, second, ends))
    return found


def joined_edges(found: BoxCertificate) -> Iterator[Edge]:
    """Edges between tiles with verdicts, where their orbits are the same; of two parameters."""
    decided = [verdict != "undecided" for verdict in found.verdicts]
    edges = edges_of([tile.place for tile in found.tiles])
    return (edge for edge in edges if decided[edge.first] and decided[edge.second])


def meeting_point(one: Tile, other: Tile, box: Sequence[Interval]) -> tuple[Fraction, ...] | None:
    """A common point of two tiles that touch, at which orbits of both are claimed.

    It is the middle of what they share, unless a fold of a tile is not clearly beside it: then
    another point, or None if there is none. `box` has the ends of each parameter.
    """
    for share in _SHARES:
        point = one.place.shared(other.place, box, share)
        if all(_has_orbits(tile, point, box) for tile in (one, other)):
            return point
    return None


def _has_orbits(tile: Tile, point: Sequence[Fraction], box: Sequence[Interval]) -> bool:
    event = tile.event
    if event is None or event.fold is None:
        return True
    ends = [tile.place.interval(axis, box) for axis in range(len(box))]
    sides = zip(point, ends, strict=True)
    side = event.band.side_of([(2 * x - low - high) / (high - low) for x, (low, high) in sides])
    return side is not None and getattr(event, side) != BEYOND


def beyond_folds(tiles: Sequence[Tile]) -> frozenset[int]:
    """Numbers of the undecided tiles that no orbit of the map can reach, because of folds.

    The tiles fill a box of two parameters. A group of such tiles, joined by edges, has other
    edges only with tiles on whose side beyond a fold the whole edge lies.
    """
    undecided = {k for k, tile in enumerate(tiles) if tile.verdict == "undecided"}
    groups = Groups(undecided)
    closed: set[int] = set()
    left: set[int] = set()
    for edge in edges_of([tile.place for tile in tiles]):
        own = [k for k in edge[:2] if k in undecided]
        if len(own) == 2:
            groups.unite(*own)
        elif own:
            (beside,) = {*edge[:2]} - {*own}
            (closed if _all_beyond(tiles[beside], edge) else left).add(own[0])
    found = [group for group in groups.all() if closed & {*group} and not left & {*group}]
    return frozenset(k for group in found for k in group)


def _all_beyond(tile: Tile, edge: Edge) -> bool:
    """Whether an edge of a tile is entirely on its side beyond a fold."""
    event = tile.event
    if event is None or event.fold is None:
        return False
    side = event.band.side_of_edge(*map(tile.place.inside, edge.ends))
    return side is not None and getattr(event, side) == BEYOND


class Groups:
    """Things that are united step by step: a disjoint-set forest (B. Galler, M. Fisher, 1964)."""

    def __init__(self, things: Iterable[Any]) -> None:
        self.parents: dict[Any, Any] = {thing: thing for thing in things}

    def _first(self, thing: Hashable) -> Any:
        while self.parents[thing] != thing:
            self.parents[thing] = self.parents[self.parents[thing]]
            thing = self.parents[thing]
        return thing

    def unite(self, one: Hashable, other: Hashable) -> None:
        """Unite the groups of two things."""
        self.parents[self._first(one)] = self._first(other)

    def all(self) -> list[list[Any]]:
        """All groups, each as a list of its things."""
        found: dict[Any, list[Any]] = defaultdict(list)
        for thing in self.parents:
            found[self._first(thing)].append(thing)
        return list(found.values())


def _overlaps(first: list[Any], second: list[Any]) -> Iterator[tuple[Interval, int, int]]:
    """Pairs of intervals with more than a point in common; both lists are sorted and disjoint."""
    i = j = 0
    while i < len(first) and j < len(second):
        (low, high), one = first[i]
        (its_low, its_high), other = second[j]
        both = max(low, its_low), min(high, its_high)
        if both[0] < both[1]:
            yield both, one, other
        if high <= its_high:
            i += 1
        if its_high <= high:
            j += 1
