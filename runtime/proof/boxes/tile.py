"""What is proposed and proved on one tile of a box of parameters, in Taylor models of them.

The search finds the orbit in the middle of the tile; the checker follows it over the tile, and
judges it. What it finds has to be the orbit that was handed on to the tile.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from nonsmooth.runtime.checker.ranges.tiles import CheckedBox, MapTile, check_whole
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.box_certificate import BITS, BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.boxes.tile_event import TileEvent, event_on
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.certificate import CLAIMS, file_json
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import as_read, asking, refusal

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["Anchor", "BoxRefusals", "TileProof", "is_same", "prove", "unproved", "whole_map"]


class BoxRefusals:
    """The reasons why the checker does not prove what is stated of tiles; "" where it does.

    `NotCovered` if it does not know their declaration.
    """

    def __init__(self, empty: BoxCertificate) -> None:
        with asking():
            self.box = CheckedBox(as_read(file_json(empty)))
        self._checked: dict[Place, tuple[Tile, MapTile]] = {}

    def take(self, tile: Tile, found: MapTile) -> None:
        """Keep a tile of which nothing is stated but what the checker found of it."""
        self._checked[tile.place] = tile, found

    def has_proved(self, tile: Tile) -> bool:
        """Whether the checker was asked about a tile and proved what is stated of it."""
        return tile.place in self._checked and self._checked[tile.place][0] is tile

    def of_tile(self, tile: Tile) -> str:
        """Why a tile by itself is refused; "" if it is proved."""
        return refusal(lambda: self.proved(tile))

    def of_joint(self, tile: Tile, other: Tile) -> str:
        """Why the common edge of two tiles over two parameters is refused; "" if it is proved."""
        return refusal(lambda: self.box.check_joint(self.proved(tile), self.proved(other)))

    def proved(self, tile: Tile) -> MapTile:
        """A tile as far as the checker proves what is stated of it; it raises why it does not."""
        if not self.has_proved(tile):
            told = as_read(encode(tile))
            found = self.box.proved(told)
            self._checked[tile.place] = tile, found
        return self._checked[tile.place][1]


def whole_map(found: BoxCertificate) -> BoxCertificate:
    """A map of proved tiles, if everything stated about the whole follows from them.

    Otherwise it becomes one undecided tile with the checker's reason.
    """
    reason = refusal(lambda: check_whole(as_read(file_json(found))))
    if not reason:
        return found
    whole = Place(((0, 0),) * len(found.box))
    return replace(found, tiles=(unproved(whole, reason, looked_at=True),))


def unproved(place: Place, reason: str, *, looked_at: bool) -> Tile:
    """A tile of which nothing is proved."""
    return Tile(
        place=place,
        claims=dict.fromkeys(CLAIMS, "undecided"),
        reasons={"existence": reason},
        enclosures={},
        guess=(),
        looked_at=looked_at,
        event=None,
    )


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
