"""What is proposed and proved on one tile of a box of parameters, in Taylor models of them.

The search finds the orbit in the middle of the tile; the checker follows it over the tile, and
judges it. What it finds has to be the orbit that was handed on to the tile.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from nonsmooth.runtime.checker.ranges.tiles import MapTile
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.box_certificate import BITS
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.boxes.refusals import BoxRefusals
from nonsmooth.runtime.proof.boxes.tile_event import TileEvent, event_on
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import asking

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["Anchor", "TileProof", "is_same", "prove"]

_LOWEST, _SHARP = 2, 6


class Anchor(NamedTuple):
    """A point of the box and the approximate orbit there, which the proof on a tile has to meet."""

    point: tuple[Fraction, ...]
    numbers: Sequence[arb]


@dataclass(frozen=True, eq=False)
class TileProof:
    """What is proved on a tile."""

    reason: str = ""  # why no orbit is proved to exist there
    found: MapTile | None = None  # verdicts and enclosures, None unless existence is proved
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
        middle = _exactly(place.middle(region.box))
        try:
            with asking():
                point = judge.box.near(middle, anchor.numbers)
                found, orbit = judge.box.judged(place.steps, [float(x) for x in point], order)
        except NotCovered as reason:
            return TileProof(str(reason))
        if not is_same(judge, found, anchor):
            return TileProof("another orbit may have been found")
        proof = TileProof("", found, rough=rough)
        if sharp and not proof.decided:
            return replace(proof, event=event_on(judge, found, orbit))
        return proof


def is_same(judge: BoxRefusals, found: MapTile, anchor: Anchor) -> bool:
    """Whether a tile has the orbit that is known at a point of it, about.

    `NotCovered` if Newton's method finds no orbit there.
    """
    point = _exactly(anchor.point)
    with asking():
        return found.holds(found.inside(point), judge.box.near(point, anchor.numbers))


def _exactly(point: Sequence[Fraction]) -> list[fmpq]:
    return [rational_of(x) for x in point]
