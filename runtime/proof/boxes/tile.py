"""What is proposed and proved on one tile of a box of parameters, in Taylor models of them.

The search finds the orbit in the middle of the tile; the checker follows it over the tile, and
judges it. What it finds has to be the orbit that was handed on to the tile.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from nonsmooth.runtime.checker.tiles import MapTile
from nonsmooth.runtime.core.taylor_models import TaylorModel
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, Region
from nonsmooth.runtime.proof.boxes.refusals import BoxRefusals
from nonsmooth.runtime.proof.boxes.tile_event import TileEvent, event_on
from nonsmooth.runtime.proof.boxes.tile_places import Interval, Place
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import joined, newton
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Anchor", "TileProof", "Tube", "prove"]

_LOWEST, _SHARP = 2, 6
_ROUGH = 50  # bits of the orbit in the middle of a tile


class Anchor(NamedTuple):
    """A point of the box and the approximate orbit there, which the proof on a tile has to meet."""

    point: tuple[Fraction, ...]
    numbers: Sequence[arb]


@dataclass(frozen=True, eq=False)
class Tube:
    """The orbit over a tile, between polynomials of the parameters."""

    place: Place
    box: tuple[Interval, ...]  # ends of each parameter over the whole box
    unknowns: Sequence[TaylorModel]
    centre: Sequence[TaylorModel]  # polynomials, one for each unknown
    radii: Sequence[arb]  # within these distances of the polynomials there is no other orbit

    def at(self, point: Sequence[Fraction]) -> list[arb]:
        """Balls around the unknowns at a point, given by the values of the box's parameters."""
        with flint_precision(BITS):
            inside = self._inside(point)
            return [x.at(inside) for x in self.unknowns]

    def holds(self, point: Sequence[Fraction], found: Sequence[arb]) -> bool:
        """Whether an orbit, enclosed by `found` at a point, is proved to be the tube's."""
        with flint_precision(BITS):
            inside = self._inside(point)
            sides = zip(found, self.centre, self.radii, strict=True)
            return all(abs(x - c.at(inside)) < r for x, c, r in sides)

    def _inside(self, point: Sequence[Fraction]) -> list[arb]:
        """The parameters at a point, scaled to run from -1 to 1 over the tile."""
        from flint import arb

        places = ((x, *self.place.interval(axis, self.box)) for axis, x in enumerate(point))
        return [arb(rational_of((2 * x - low - high) / (high - low))) for x, low, high in places]


@dataclass(frozen=True, eq=False)
class TileProof:
    """What is proved on a tile."""

    reason: str = ""  # why no orbit is proved to exist there
    found: MapTile | None = None  # verdicts and enclosures, None unless existence is proved
    tube: Tube | None = None  # likewise
    event: TileEvent | None = None  # a curve on the two sides of which verdicts are proved
    rough: bool = False  # whether that was in an order that a file is not checked in

    @property
    def decided(self) -> bool:
        """Whether one verdict is proved for the whole tile."""
        if self.found is None:
            return False
        admissible, stable = (
            self.found.verdicts[name].claim for name in ("admissibility", "stability")
        )
        return admissible == "refuted" or (admissible == "proved" and stable != "undecided")


def prove(
    judge: BoxRefusals,
    region: Region,
    place: Place,
    anchor: Anchor,
    *,
    rough: bool = False,
    sharp: bool = False,
) -> TileProof:
    """Prove what can be proved on a tile; the result names the reasons for the rest.

    The anchor has to be in the tile. `rough` takes a low order, enough where only admissibility
    is left to be decided. `sharp` takes a high order and looks for the curve of one event; it
    needs two parameters.
    """
    order = _LOWEST if rough else _SHARP if sharp else 0
    with flint_precision(BITS):
        middle = region.equations(region.tables.number_at(_balls(place.middle(region.box))))
        point = newton(lambda: middle, anchor.numbers, _ROUGH)
        if point is None:
            return TileProof("Newton's method finds no orbit in the middle")
        try:
            found = judge.judged(place, [float(x) for x in point], order)
        except NotCovered as reason:
            return TileProof(str(reason))
        unknowns, centre = (
            [x if isinstance(x, TaylorModel) else found.space.constant(x) for x in numbers]
            for numbers in (found.root, found.centre)
        )
        tube = Tube(place, region.box, unknowns, centre, found.radii)
        number = region.tables.number_at(_balls(anchor.point))
        if not joined(region.equations(number), tube.at(anchor.point), anchor.numbers):
            return TileProof("another orbit may have been found")
        proof = TileProof("", found, tube, rough=rough)
        if sharp and not proof.decided:
            return replace(proof, event=event_on(region, place, unknowns, found.parameters))
        return proof


def _balls(point: Sequence[Fraction]) -> list[arb]:
    from flint import arb

    return [arb(rational_of(x)) for x in point]
