"""What the checker refuses of a map: it is asked before anything is stated."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

from nonsmooth.runtime.checker.divided import DividingCurve, Division
from nonsmooth.runtime.checker.folded import Sheets
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.tiles import CheckedBox, MapTile, check_whole
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.certificate import CLAIMS, file_json
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import as_read, refusal

__all__ = ["BoxRefusals", "unproved", "whole_map"]

_T = TypeVar("_T")


class BoxRefusals:
    """The reasons why the checker does not prove what is stated of tiles; "" where it does."""

    box: CheckedBox

    def __init__(self, empty: BoxCertificate) -> None:
        content = as_read(file_json(empty))

        def begin() -> None:
            self.box = CheckedBox(content)

        reason = refusal(begin)
        if reason:
            raise NotCovered(reason)
        self._checked: dict[Place, tuple[Tile, MapTile]] = {}

    def judged(
        self, place: Place, guess: Sequence[float], order: int = 0
    ) -> tuple[MapTile, CheckedOrbit]:
        """What the checker proves of the orbit near a guess in the middle of a tile, and the orbit.

        `order` is that of the Taylor models, by default what costs least. `NotCovered` if there may
        be no orbit.
        """
        return self._answer(lambda: self.box.judged(place.steps, list(guess), order))

    def divided(self, tile: MapTile, orbit: CheckedOrbit, curve: DividingCurve) -> Division:
        """What the checker proves of a judged tile if one event happens on a curve.

        `NotCovered` if it may be otherwise.
        """
        return self._answer(lambda: tile.divide(orbit, curve))

    def folded(self, place: Place, sheets: Sheets) -> MapTile:
        """What the checker proves of a tile with a fold; `NotCovered` if there may be none."""
        return self._answer(lambda: self.box.folded(place.steps, sheets))

    def stated(self, tile: Tile) -> MapTile:
        """A tile as far as the checker proves what is stated of it; `NotCovered` if it does not."""
        return self._answer(lambda: self._proved(tile))

    def _answer(self, ask: Callable[[], _T]) -> _T:
        """What the checker answers, at constants on which its divisors do not vanish."""
        found: list[_T] = []

        def judge() -> None:
            found.append(ask())
            self.box.check_divisors()

        if reason := refusal(judge):
            raise NotCovered(reason)
        return found[0]

    def take(self, tile: Tile, found: MapTile) -> None:
        """Keep a tile of which nothing is stated but what the checker found of it."""
        self._checked[tile.place] = tile, found

    def has_proved(self, tile: Tile) -> bool:
        """Whether the checker was asked about a tile and proved what is stated of it."""
        return tile.place in self._checked and self._checked[tile.place][0] is tile

    def of_tile(self, tile: Tile) -> str:
        """Why a tile by itself is refused; "" if it is proved."""
        return refusal(lambda: self._proved(tile))

    def of_joint(self, tile: Tile, other: Tile) -> str:
        """Why the common edge of two tiles over two parameters is refused; "" if it is proved."""
        return refusal(lambda: self.box.check_joint(self._proved(tile), self._proved(other)))

    def _proved(self, tile: Tile) -> MapTile:
        if not self.has_proved(tile):
            told = as_read(encode(tile))
            found = self.box.proved(told)
            self.box.check_divisors()
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
