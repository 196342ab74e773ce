"""What the checker refuses of a map: it is asked before anything is stated."""

from __future__ import annotations

from dataclasses import replace

from nonsmooth.runtime.checker.ranges.tiles import CheckedBox, MapTile, check_whole
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.certificate import CLAIMS, file_json
from nonsmooth.runtime.proof.refusals import as_read, asking, refusal

__all__ = ["BoxRefusals", "unproved", "whole_map"]


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
