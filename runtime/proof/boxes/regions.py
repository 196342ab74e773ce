"""Regions, curves and open boxes of a map of two parameters, from tiles that meet.

Where tiles with verdicts meet it is proved that their orbits are the same.
A region is made of tiles, and of sides of divided ones, that meet at a point which is clearly in
both; a curve is made of tiles which one event divides, and whose common edge it passes.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations, pairwise, product
from typing import TYPE_CHECKING, Annotated, NamedTuple, TypeVar

import numpy as np

from nonsmooth.runtime.checker.ranges.divided import Band
from nonsmooth.runtime.checker.ranges.folded import BEYOND, common_part, neighbours
from nonsmooth.runtime.core.json_codec import Several, by
from nonsmooth.runtime.proof.boxes.tile import (
    Fold,
    Interval,
    Place,
    Point,
    TileEvent,
    WhatHappens,
)

if TYPE_CHECKING:
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile

_PARTS = 64  # of a tile, for the area of a side
_DRAWN = 16  # points of a curve in each tile
_ON = 1e-9  # how near to an edge a curve ends there, in shares of the box
Cell = tuple[int, str]
_Thing = TypeVar("_Thing", bound=Hashable)


@dataclass(frozen=True, kw_only=True)
class ProvedRegion:
    """A connected part of a box with one verdict."""

    verdict: str  # "stable", "neutral", "unstable", "not admissible" or "beyond a fold"
    share: float  # of the box's area, approximate
    # numbers of its tiles, with the side "below" or "above" of divided ones
    cells: tuple[Cell, ...] = field(repr=False)


@dataclass(frozen=True, kw_only=True)
class EventCurve:
    """A curve of one event, as a chain of tiles."""

    # of its first tile
    event: Annotated[TileEvent, Several(WhatHappens, WhatHappens.of, vars)]
    tiles: tuple[int, ...]  # their numbers, in the order of the curve
    width: float  # of its widest band, as a share of the box
    # "border" of the box, "open" at undecided tiles or "corner"; none if closed
    ends: tuple[str, ...]
    # approximate values of the parameters along it
    points: tuple[tuple[float, float], ...] = field(repr=False)
    # of a fold the verdicts on the map's "own" orbit and on the "other" one, where both exist
    sheets: Mapping[str, str] | None


@dataclass(frozen=True, kw_only=True)
class OpenBox:
    """Undecided tiles that touch each other."""

    where: dict[str, Interval]  # the least box that holds them
    share: Annotated[Fraction, by(float, float)]  # of the box's area
    tiles: int  # their number
    events: tuple[str, ...]  # names of the events whose curves touch these tiles
    reason: str  # why its largest tile is undecided


class Edge(NamedTuple):
    """The common edge of two tiles."""

    first: int  # number of a tile
    second: int  # number of a tile
    ends: tuple[Point, Point]  # two points, in shares of the box from 0 to 1


def edges_of(places: Sequence[Place]) -> Iterator[Edge]:
    """The common edges of tiles of a box of two parameters, where they are longer than a point."""
    for first, others in enumerate(neighbours([place.steps for place in places])):
        for second in others:
            if first < second:
                (a, b), (c, d) = common_part(places[first].shares, places[second].shares)
                yield Edge(first, second, ((a, c), (b, d)))


def regions_of(found: BoxCertificate) -> tuple[ProvedRegion, ...]:
    """The regions of a map of two parameters, the largest first."""
    tiles = found.tiles
    verdicts: dict[Cell, str] = {
        (k, side): v
        for k, tile in enumerate(tiles)
        for side, v in _verdicts(tile, found.verdicts[k])
    }
    pairs: list[tuple[Cell, Cell]] = []
    for edge in _joined_edges(found):
        first, second = tiles[edge.first], tiles[edge.second]
        for point in _samples(edge):
            own, its = (edge.first, _side(first, point)), (edge.second, _side(second, point))
            if own in verdicts and its in verdicts:
                pairs.append((own, its))
    told = []
    for cells in _groups(verdicts, pairs):
        verdict = verdicts[cells[0]]
        share = sum((_share(tiles[number], side) for number, side in cells), 0.0)
        name = found.stability if verdict == "proved" else verdict
        told.append(ProvedRegion(verdict=name, share=share, cells=tuple(cells)))
    return tuple(sorted(told, key=lambda region: -region.share))


def curves_of(found: BoxCertificate) -> tuple[EventCurve, ...]:
    """The curves of events of a map of two parameters, the longest chain first."""
    events = {
        k: tile.event
        for k, tile in enumerate(found.tiles)
        if tile.event is not None and _passes(tile.event.band)
    }
    beside: dict[int, list[int]] = {k: [] for k in events}
    for edge in _joined_edges(found):
        pair = edge.first, edge.second
        if all(k in events for k in pair) and events[pair[0]].name == events[pair[1]].name:
            told = [[events[k].band.side_of(found.tiles[k].place.inside(end))
                     for end in edge.ends] for k in pair]  # fmt: skip
            passed = any(None not in sides and sides[0] != sides[1] for sides in told)
            if passed or any(a is None and b is None for a, b in zip(*told, strict=True)):
                beside[pair[0]].append(pair[1])
                beside[pair[1]].append(pair[0])
    pairs = ((k, other) for k, others in beside.items() for other in others)
    chains = [_walk(cells, beside) for cells in _groups(events, pairs)]
    return tuple(_curve(found, chain, beside) for chain in sorted(chains, key=len, reverse=True))


def open_boxes_of(found: BoxCertificate) -> tuple[OpenBox, ...]:
    """The undecided parts of a map of any number of parameters, the largest first."""
    undecided = [k for k, verdict in enumerate(found.verdicts) if verdict == "undecided"]
    places = [found.tiles[k].place for k in undecided]
    pairs = (
        (undecided[k], undecided[other])
        for k, other in combinations(range(len(places)), 2)
        if places[k].touches(places[other])
    )
    told = []
    for cells in _groups(undecided, pairs):
        own = [found.tiles[k] for k in cells]
        places = [tile.place for tile in own]
        ends = zip(*(place.where([*found.box.values()]) for place in places), strict=True)
        where = {
            name: (min(low for low, _ in sides), max(high for _, high in sides))
            for name, sides in zip(found.box, ends, strict=True)
        }
        kinds = {
            _event_text(tile.event)
            for tile in found.tiles
            if tile.event is not None
            and _passes(tile.event.band)
            and any(tile.place.touches(place) for place in places)
        }
        largest = max(own, key=lambda tile: tile.place.share)
        told.append(
            OpenBox(
                where=where,
                share=sum((place.share for place in places), Fraction(0)),
                tiles=len(own),
                events=tuple(sorted(kinds)),
                reason="; ".join(largest.reasons.values()),
            )
        )
    return tuple(sorted(told, key=lambda box: -box.share))


def _joined_edges(found: BoxCertificate) -> Iterator[Edge]:
    """Edges between tiles with verdicts, where their orbits are the same; of two parameters."""
    decided = [verdict != "undecided" for verdict in found.verdicts]
    edges = edges_of([tile.place for tile in found.tiles])
    return (edge for edge in edges if decided[edge.first] and decided[edge.second])


def _groups(
    things: Collection[_Thing], pairs: Iterable[tuple[_Thing, _Thing]]
) -> list[list[_Thing]]:
    """The groups of things that pairs connect, each in the order of the things."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    number = {thing: k for k, thing in enumerate(things)}
    joined = np.array([(number[one], number[other]) for one, other in pairs], dtype=int)
    one, other = joined.reshape(-1, 2).T
    links = coo_array((np.ones(len(one)), (one, other)), (len(number), len(number)))
    _, labels = connected_components(links, directed=False)
    found: dict[int, list[_Thing]] = defaultdict(list)
    for thing, label in zip(things, labels.tolist(), strict=True):
        found[label].append(thing)
    return list(found.values())


def _event_text(event: TileEvent) -> str:
    if event.phase is None:
        return event.kind
    return f"{event.kind} of {event.boundary} in phase {event.phase + 1}"


def _samples(edge: Edge) -> list[Point]:
    (x, y), (its_x, its_y) = edge.ends
    shares = [Fraction(k, 4) for k in range(5)]
    return [(x + s * (its_x - x), y + s * (its_y - y)) for s in shares]


def _verdicts(tile: Tile, verdict: str) -> Iterator[tuple[str, str]]:
    """Pairs of a side of a tile that is not empty and its verdict; "" stands for the whole tile."""
    event = tile.event
    if event is None:
        if verdict != "undecided":
            yield "", verdict
        return
    ends = [event.band.at(Fraction(end)) for end in (-1, 1)]
    radius = Fraction(event.band.radius)
    if max(ends) - radius > -1:
        yield "below", event.below
    if min(ends) + radius < 1:
        yield "above", event.above


def _side(tile: Tile, point: Point) -> str:
    """The side of a tile that holds a point: "" if no curve divides it, "band" on the curve."""
    if tile.event is None:
        return ""
    return tile.event.band.side_of(tile.place.inside(point)) or "band"


def _passes(band: Band) -> bool:
    """Whether a band has points in its tile; otherwise the tile is all on one side of it."""
    ends = [Fraction(-1), Fraction(1)]
    along = [Fraction(k, 4) for k in range(-4, 5)]
    points = product(ends, along) if band.axis == 0 else product(along, ends)
    return {band.side_of(point) for point in points} not in ({"below"}, {"above"})


def _share(tile: Tile, side: str) -> float:
    """The approximate area of a side of a tile, as a share of the box."""
    whole = float(tile.place.share)
    if tile.event is None:
        return whole
    below = 0.0
    for k in range(_PARTS):
        at = float(tile.event.band.at(Fraction(2 * k + 1 - _PARTS, _PARTS)))
        below += min(max((at + 1) / 2, 0.0), 1.0) / _PARTS
    return whole * (below if side == "below" else 1 - below)


def _walk(cells: list[int], beside: dict[int, list[int]]) -> list[int]:
    """Tiles in the order of the curve, from one of its ends if it has ends."""
    chain = [min(cells, key=lambda k: (len(beside[k]), k))]
    left = {*cells} - {*chain}
    while left:
        near = [k for k in beside[chain[-1]] if k in left]
        chain.append(near[0] if near else min(left))
        left.discard(chain[-1])
    return chain


def _curve(found: BoxCertificate, chain: list[int], beside: dict[int, list[int]]) -> EventCurve:
    pieces = [_drawn(found.tiles[k]) for k in chain]
    for k, (before, piece) in enumerate(pairwise(pieces)):
        ways = product((0, 1), repeat=2)
        near = min(
            ways, key=lambda w: _distance(before[-1 if w[0] else 0], piece[-1 if w[1] else 0])
        )
        if k == 0 and not near[0]:
            before.reverse()
        if near[1] and (
            k == 0 or _distance(before[-1], piece[0]) > _distance(before[-1], piece[-1])
        ):
            piece.reverse()
    shares = [point for piece in pieces for point in piece]
    closed = len(chain) > 2 and chain[-1] in beside[chain[0]]
    (a, b), (c, d) = ([float(end) for end in ends] for ends in found.box.values())
    first = found.tiles[chain[0]].event
    assert first is not None
    return EventCurve(
        event=first,
        tiles=tuple(chain),
        width=max(_width(found.tiles[k]) for k in chain),
        ends=() if closed or not shares else tuple(_end(found, shares[k]) for k in (0, -1)),
        points=tuple((a + x * (b - a), c + y * (d - c)) for x, y in shares),
        sheets=None if first.fold is None else _sheets(found, first, first.fold),
    )


def _sheets(found: BoxCertificate, event: TileEvent, fold: Fold) -> dict[str, str]:
    """The verdicts on the map's own orbit and on the other orbit that meets it in a fold."""
    own = event.below if event.above == BEYOND else event.above
    told = {"own": own, "other": fold.other}
    return {name: found.stability if v == "proved" else v for name, v in told.items()}


def _distance(one: tuple[float, float], other: tuple[float, float]) -> float:
    return (one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2


def _width(tile: Tile) -> float:
    assert tile.event is not None
    band = tile.event.band
    return band.radius / float(2 ** tile.place.steps[band.axis][1])


def _drawn(tile: Tile) -> list[tuple[float, float]]:
    """Points of a curve in its tile, in shares of the box."""
    assert tile.event is not None
    band, unit = tile.event.band, tile.place.shares
    spots: list[tuple[float, float]] = []
    for k in range(_DRAWN + 1):
        along = 2 * k / _DRAWN - 1
        spots.append((along, float(band.at(Fraction(along)))))
    ends = [
        _clipped(one, other)
        for one, other in pairwise(spots)
        if min(one[1], other[1]) <= 1 and max(one[1], other[1]) >= -1
    ]
    inside = [end for pair in ends for end in pair] or [
        (along, min(max(at, -1.0), 1.0)) for along, at in (min(spots, key=lambda s: abs(s[1])),)
    ]
    found = []
    for along, at in dict.fromkeys(inside):
        point = (at, along) if band.axis == 0 else (along, at)
        x, y = (
            float(low) + (e + 1) / 2 * float(high - low)
            for e, (low, high) in zip(point, unit, strict=True)
        )
        found.append((x, y))
    return found


def _clipped(one: tuple[float, float], other: tuple[float, float]) -> list[tuple[float, float]]:
    """The part of a short piece of a curve that is in its tile."""
    (u, x), (v, y) = one, other

    def at(level: float) -> tuple[float, float]:
        return u + (level - x) / (y - x) * (v - u), level

    return [at(-1.0) if here[1] < -1 else at(1.0) if here[1] > 1 else here for here in (one, other)]


def _end(found: BoxCertificate, point: tuple[float, float]) -> str:
    """What a curve ends at: "border" of the box, "open" at undecided tiles, else "corner"."""
    if any(abs(x - end) < _ON for x in point for end in (0, 1)):
        return "border"
    for tile, verdict in zip(found.tiles, found.verdicts, strict=True):
        if verdict == "undecided":
            sides = zip(point, tile.place.shares, strict=True)
            if all(float(low) - _ON <= x <= float(high) + _ON for x, (low, high) in sides):
                return "open"
    return "corner"
