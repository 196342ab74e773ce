"""Tiles of a box of parameters: their places, halved again and again, and the events on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Annotated, NamedTuple

from nonsmooth.runtime.checker.ranges.divided import Band
from nonsmooth.runtime.checker.ranges.folded import BEYOND, common_part
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import FromOne, Ordinal, Several, one_of

Interval = tuple[Fraction, Fraction]
Point = tuple[Fraction, Fraction]  # of a plane


class Place(NamedTuple):
    """The place of a tile: along each axis, the k-th of 2^level equal parts of the box."""

    steps: tuple[tuple[int, int], ...]  # k and level of each axis

    def where(self, box: Sequence[Interval]) -> list[Interval]:
        """Lower and upper end of the tile along each axis; `box` has those of each parameter."""
        found = []
        for (step, level), (lower, upper) in zip(self.steps, box, strict=True):
            width = (upper - lower) / 2**level
            found.append((lower + step * width, lower + (step + 1) * width))
        return found

    @property
    def share(self) -> Fraction:
        """The tile's share of the box's area."""
        return Fraction(1, 2 ** sum(level for _, level in self.steps))

    @property
    def shares(self) -> tuple[Interval, ...]:
        """The tile's ends along each axis, in shares of the box from 0 to 1."""
        return tuple((Fraction(k, 2**level), Fraction(k + 1, 2**level)) for k, level in self.steps)

    def inside(self, point: Point) -> Point:
        """A point of a plane, given in shares of the box, counted from -1 to 1 over the tile."""
        sides = zip(point, self.shares, strict=True)
        x, y = ((2 * at - low - high) / (high - low) for at, (low, high) in sides)
        return x, y

    def middle(self, box: Sequence[Interval]) -> tuple[Fraction, ...]:
        """The value of each parameter in the middle of the tile; `box` has their ends."""
        return tuple((low + high) / 2 for low, high in self.where(box))

    def holds(self, point: Sequence[Fraction], box: Sequence[Interval]) -> bool:
        """Whether the tile, with its edges, contains a point given by a value of each parameter."""
        ends = zip(point, self.where(box), strict=True)
        return all(low <= x <= high for x, (low, high) in ends)

    def touches(self, other: Place) -> bool:
        """Whether two tiles of a box have a point in common, be it an edge or a corner."""
        for (step, level), (its_step, its_level) in zip(self.steps, other.steps, strict=True):
            finest = max(level, its_level)
            low, its_low = step << (finest - level), its_step << (finest - its_level)
            high, its_high = low + (1 << (finest - level)), its_low + (1 << (finest - its_level))
            if high < its_low or its_high < low:
                return False
        return True

    def shared(
        self, other: Place, box: Sequence[Interval], share: Fraction = Fraction(1, 2)
    ) -> tuple[Fraction, ...]:
        """A common point of two tiles that touch, as a value of each parameter.

        `share` is how far it is from the lower ends of what they share to the upper ones.
        """
        both = common_part(self.where(box), other.where(box))
        return tuple(low + share * (high - low) for low, high in both)

    def halves(self, axis: int) -> tuple[Place, Place]:
        """The lower and the upper half of the tile along an axis."""
        step, level = self.steps[axis]

        def half(number: int) -> Place:
            steps = list(self.steps)
            steps[axis] = (2 * step + number, level + 1)
            return Place(tuple(steps))

        return half(0), half(1)


_PLANE = 2  # parameters of a box with curves, and the fewest coefficients of one
_OTHERS = ("proved", "unstable", "not admissible")
Side = Annotated[str, one_of(("below", "above"))]
Instant = Annotated[str, one_of(("", "start", "inside", "end"))]
# kinds, phases, boundaries and instants of events
Events = tuple[tuple[str, Ordinal, str, Instant], ...]


@dataclass(frozen=True, kw_only=True)
class BandEntries:
    """Entries for a band about a curve: the parameter across by its number, from 1."""

    axis: Ordinal
    centre: tuple[float, ...]
    radius: float


def _band(found: BandEntries) -> Band:
    if found.axis not in (0, 1) or len(found.centre) < _PLANE:
        raise InputError("a curve crosses no parameter of the box")
    return Band(found.axis, found.centre, found.radius)


KeptBand = Annotated[Band, Several(BandEntries, lambda band: BandEntries(**band._asdict()), _band)]


@dataclass(frozen=True)
class Fold:
    """Two sheets of orbits that meet along a curve: a tube around both.

    In the tube one unknown is within `half` of a polynomial of the parameter along the curve.
    The other unknowns, and the parameter across, are near functions of these two.
    """

    coordinate: str  # the unknown of the orbit's equations that distinguishes the orbits
    # coefficients of the polynomial: where the orbits meet, approximately
    centre: tuple[float, ...]
    half: float  # half of the tube's width in that unknown
    sheet: Side  # the map's own sheet, by that unknown
    other: Annotated[str, one_of(_OTHERS)]  # verdict on the other sheet


@dataclass(frozen=True, eq=False)
class WhatHappens:
    """An event of an orbit, and where in its cycle it happens."""

    # "flip", "neimark-sacker", "fold", or a border: "grazing", "tangent", "entry", "simultaneous",
    # "vanishing-phase"
    kind: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Instant

    @staticmethod
    def of(event: WhatHappens) -> WhatHappens:
        """Only that, of an event of which more is known."""
        return WhatHappens(**{own.name: getattr(event, own.name) for own in fields(WhatHappens)})


@dataclass(frozen=True)
class TileEvent(WhatHappens):
    """A curve of one event that divides a tile.

    Verdicts are "proved", "unstable", "not admissible" or "beyond a fold". They hold for all
    parameters below the band and above it, along its axis.
    """

    # times in the phase of a grazing (perhaps in `also`) between which the boundary function is
    # concave
    window: tuple[Fraction, ...]
    # kind, phase, boundary and instant of further events in the same band
    also: Events
    band: KeptBand
    below: Annotated[str, one_of((*_OTHERS, BEYOND))]  # verdict below the band
    above: Annotated[str, one_of((*_OTHERS, BEYOND))]  # verdict above the band
    # the orbits that meet; on the side beyond the fold none is in their tube
    fold: Fold | None

    @property
    def name(self) -> tuple[str, int | None, str, str]:
        """Kind, phase, boundary and instant, which distinguish the orbit's events."""
        return self.kind, self.phase, self.boundary, self.instant
