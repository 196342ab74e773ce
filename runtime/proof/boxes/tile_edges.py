"""Edges that tiles of a box of two parameters have in common, and what is joined by them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.proof.boxes.tile_places import Interval, Place, Point

if TYPE_CHECKING:
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate

__all__ = ["Edge", "Groups", "edges_of", "joined_edges"]


class Edge(NamedTuple):
    """What two tiles have in common.

    Attributes
    ----------
    first, second : int
        Numbers of the tiles; along the axis the second one follows the first.
    ends : tuple of (Fraction, Fraction)
        Two points, in shares of the box from 0 to 1.
    """

    first: int
    second: int
    ends: tuple[Point, Point]


def edges_of(places: Sequence[Place]) -> list[Edge]:
    """What tiles of a box of two parameters have in common, where that is longer than a point.

    Parameters
    ----------
    places : sequence of Place

    Returns
    -------
    list of Edge
    """
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
    """Edges between tiles with verdicts: their orbits are the same there.

    Parameters
    ----------
    found : BoxCertificate
        Of two parameters.

    Returns
    -------
    iterator of Edge
    """
    decided = [tile.verdict != "undecided" for tile in found.tiles]
    edges = edges_of([tile.place for tile in found.tiles])
    return (edge for edge in edges if decided[edge.first] and decided[edge.second])


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
        """Put two things, and all that is with them, together.

        Parameters
        ----------
        one, other : hashable
        """
        self.parents[self._first(one)] = self._first(other)

    def all(self) -> list[list[Any]]:
        """All groups.

        Returns
        -------
        list of list
        """
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
