"""Certify a periodic orbit for all parameters of a box, tile after tile."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import count
from operator import itemgetter
from typing import NamedTuple

from flint import arb, fmpq

from nonsmooth.runtime.checker.ranges.folded import BEYOND, neighbours
from nonsmooth.runtime.checker.ranges.tiles import (
    SHARES,
    CheckedBox,
    MapTile,
    check_whole,
    verdict_of,
)
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.errors import check_integer
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.asking import (
    Progress,
    Steps,
    as_read,
    asking,
    proved_by_steps,
    refusal,
)
from nonsmooth.runtime.proof.boxes.box_certificate import BITS, DIGITS, BoxCertificate, Tile
from nonsmooth.runtime.proof.boxes.tile import Fold, Place, TileEvent
from nonsmooth.runtime.proof.boxes.tile_search import FoldSearch, event_on
from nonsmooth.runtime.proof.certificate import CLAIMS, Stated, check_same_orbits, file_json
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    Region,
    checked_box,
    region_of,
    stated_orbits,
    with_open_ones,
)
from nonsmooth.runtime.proof.statement import rational_of


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
        verdicts = {} if self.found is None else self.found.verdicts
        claims = {name: verdict.claim for name, verdict in verdicts.items()}
        return bool(claims) and verdict_of(claims) != "undecided"


def prove(
    judge: BoxRefusals, region: Region, place: Place, anchor: Anchor, order: int = 0
) -> TileProof:
    """Prove what can be proved on a tile; the result names the reasons for the rest.

    The anchor has to be in the tile. The order of the models is what costs least, or `_LOWEST`,
    enough where only admissibility is left to be decided, or `_SHARP`, with which the curve of one
    event is looked for; this needs two parameters.
    """
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
        proof = TileProof("", found, rough=order == _LOWEST)
        if order == _SHARP and not proof.decided:
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


MOST_TILES = 4000
_PLANE = 2  # parameters of a box in which events are curves
_DEEPEST = 12  # halvings along each axis
_SEEN = 30  # bits to which the ends of an enclosure are stated
_NOT_TRIED = "not looked at yet"
_MEET = "two orbits meet there"


def certify_box(
    orbit: Orbit,
    box: Mapping[str, tuple[object, object]],
    *,
    tiles: int = MOST_TILES,
    resume: BoxCertificate | None = None,
    progress: Progress = lambda decided, looked_at: None,
    keep: Callable[[BoxCertificate], object] | None = None,
) -> BoxCertificate:
    """Prove an orbit, its admissibility and its stability for all parameters of a box.

    The orbit is followed over the box in Taylor models of the parameters; a tile that is not
    decided is halved. What is proved of a tile is so for each of its parameters.

    Parameters
    ----------
    orbit : Orbit
        A converged one, with its parameters in the box.
    box : mapping of str to (number or str, number or str)
        Lower and upper ends of parameters that were given for the orbit: rational numbers.
    tiles : int
        At most so many are looked at, those of `resume` among them.
    resume : BoxCertificate, optional
        What was proved before of the same orbit and box.
    progress : function of a float and an int, optional
        Is told which share of the box is decided and how many tiles were looked at so far.
    keep : function of a BoxCertificate, optional
        Is given the state every ten seconds.

    Returns
    -------
    BoxCertificate

    Raises
    ------
    InputError
        For an orbit that has not converged, a box that is none or does not hold it, or a
        state that belongs to something else.
    Interrupted
        By Ctrl-C; its `partial` is the state, which `resume` takes.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/global-stick")
    >>> found = ns.certify.box(orbit, {"V": ("0.99", "1.01"), "eta": ("0.99", "1.01")})
    >>> found.proved, found.enclosures["trace"].upper < -0.9
    (True, True)
    """
    check_integer("tiles", tiles, 1)
    ends = checked_box(orbit, box)
    whole = Place(((0, 0),) * len(ends))

    def record(region: Region | None, tiles: Sequence[Tile]) -> BoxCertificate:
        return BoxCertificate(
            **stated_orbits(orbit, ends, chosen, region),
            box=ends,
            stability="stable" if region is None else region.closing.stability,
            tiles=tuple(tiles),
        )

    chosen: tuple[str, ...] = ()
    try:
        orbit, chosen = with_open_ones(orbit, ends)
        region = region_of(orbit, ends)
        empty = record(region, [unproved(whole, _NOT_TRIED, looked_at=False)])
        refusals = BoxRefusals(empty)
    except NotCovered as reason:
        nothing = record(None, [unproved(whole, str(reason), looked_at=True)])
        if resume is not None:
            check_same_orbits(nothing, resume, "box")
        return nothing
    if resume is not None:
        check_same_orbits(empty, resume, "box")
    work = _Work(region, resume or empty, refusals)
    return proved_by_steps(
        work.steps(tiles), lambda: whole_map(record(region, work.stated())), progress, keep
    )


class _Work:
    """The tiles that are done and those that wait to be looked at, the largest first.

    The orbit is handed on from tile to tile: from the point at which it is known to the tile
    that holds it, from a tile to its halves, and to tiles that touch it.
    """

    def __init__(self, region: Region, state: BoxCertificate, refusals: BoxRefusals) -> None:
        self.region, self.state, self.refusals = region, state, refusals
        # tiles with verdicts whose orbits are known to be the same where they meet
        self.known = {tile.place for tile in state.tiles if tile.verdict != "undecided"}
        self.same: set[frozenset[Place]] = set()
        self.done: list[Tile] = []
        self.waiting: list[tuple[Fraction, int, Tile]] = []
        self.stranded: list[Tile] = []  # no orbit has reached them
        self.reached: dict[Place, Tile] = {}  # the orbit is proved there
        self.tubes: dict[Place, MapTile] = {}
        self.decided = 0.0
        self._order = count()
        for tile in state.tiles:
            if tile.verdict == "undecided" and not tile.looked_at:
                if tile.claims["existence"] == "proved":  # on a tile that was halved
                    self.reached[tile.place] = tile
                self._wait(tile)
            else:
                self._finish(tile)
        self.tiles = self._all()  # they fill the box, also while a tile is being looked at

    def stated(self) -> list[Tile]:
        """The tiles that fill the box, each with the claims that the checker proves.

        The checker is asked about every tile with claims that it has not seen; one that waits to
        be looked at gets no claim instead. Over two parameters tiles with verdicts have the same
        orbit where they meet; where that is not proved the second one is undecided.
        """
        tiles = [*map(self._stated, self.tiles)]
        if len(self.region.names) != _PLANE:
            return tiles
        for number, others in enumerate(neighbours([tile.place.steps for tile in tiles])):
            for other in filter(number.__gt__, others):
                tile, before = tiles[number], tiles[other]
                pair = frozenset((tile.place, before.place))
                if "undecided" in (tile.verdict, before.verdict) or pair in self.same:
                    continue
                reason = "" if pair <= self.known else self.refusals.of_joint(tile, before)
                if reason:
                    tiles[number] = unproved(tile.place, reason, looked_at=True)
                else:
                    self.same.add(pair)
        return tiles

    def _stated(self, tile: Tile, *, waits: bool = True) -> Tile:
        """A tile with the claims that the checker proves; none if it `waits` to be looked at."""
        nothing = "proved" not in tile.claims.values() and tile.event is None
        if nothing or tile.place in self.known or self.refusals.has_proved(tile):
            return tile
        if waits and not tile.looked_at:
            return replace(unproved(tile.place, _NOT_TRIED, looked_at=False), guess=tile.guess)
        reason = self.refusals.of_tile(tile)
        return unproved(tile.place, reason, looked_at=tile.looked_at) if reason else tile

    def steps(self, most: int) -> Steps:
        """Look at the largest waiting tile that the orbit has reached, until there is none.

        At most so many are looked at; the share that is decided and their number are yielded.
        """
        for looked_at in range(_looked_at(self.state) + 1, most + 1):
            found = self._look()
            self.tiles = self._all()  # an interruption leaves the old ones, or the new ones
            if not found:
                break
            yield self.decided, looked_at
        # no further tile is looked at; an interruption leaves those that wait as they are
        self.tiles = [self._stated(tile, waits=False) for tile in self.tiles]

    def _all(self) -> list[Tile]:
        waiting = sorted(self.waiting, key=itemgetter(0, 1))
        return [*self.done, *(tile for *_, tile in waiting), *self.stranded]

    def _look(self) -> bool:
        while self.waiting:
            *_, tile = heapq.heappop(self.waiting)
            anchor = self._anchor(tile)
            if anchor is None:
                self.stranded.append(tile)
                continue
            proof = self._proved(tile, anchor)
            if proof.found is not None:
                self.tubes[tile.place] = proof.found
            elif len(self.region.names) == _PLANE:
                folded = self._folded(tile.place, anchor)
                if folded is not None:
                    self._finish(folded)
                    return True
            self._take(self._judged(tile, proof))
            return True
        return False

    def _take(self, tile: Tile) -> None:
        """Store a tile as far as the checker proves it, or go on with its halves."""
        final = tile.verdict != "undecided" or min(_levels(tile)) == _DEEPEST
        reason = self.refusals.of_tile(tile) if final else ""
        self._finish(unproved(tile.place, reason, looked_at=True) if reason else tile)

    def _proved(self, tile: Tile, anchor: Anchor) -> TileProof:
        """What is proved on a tile, at a high order where a low one decides nothing."""
        region, place = self.region, tile.place
        rough = "undecided" not in (tile.claims["existence"], tile.claims["stability"])
        proof = prove(self.refusals, region, place, anchor, _LOWEST if rough else 0)
        if proof.found is None and rough:
            proof = prove(self.refusals, region, place, anchor)
        if len(region.names) != _PLANE or proof.found is None or proof.decided:
            return proof
        if self._judged(tile, proof).verdict != "undecided":
            return proof
        sharp = prove(self.refusals, region, place, anchor, _SHARP)
        return proof if sharp.found is None else sharp

    def _judged(self, tile: Tile, proof: TileProof) -> Tile:
        """A tile after its proof; a claim that was decided before stays so if it is not now."""
        if proof.found is None:
            reached = tile.claims["existence"] == "proved"
            reasons = tile.reasons if reached else {"existence": proof.reason}
            return replace(tile, looked_at=True, reasons=reasons)
        verdicts = {name: proof.found.verdicts[name] for name in CLAIMS}
        claims = {
            name: tile.claims[name] if verdict.claim == "undecided" else verdict.claim
            for name, verdict in verdicts.items()
        }
        known = {**tile.reasons, **{name: v.reason for name, v in verdicts.items() if v.reason}}
        left = {name for name, claim in claims.items() if claim != "proved"}
        with flint_precision(BITS):
            enclosures = {
                name: Stated.around(_wider(ball), BITS, DIGITS)
                for name, ball in proof.found.enclosures.items()
                if ball.is_finite()
            }
        same = claims == {name: verdict.claim for name, verdict in verdicts.items()}
        found = Tile(
            place=tile.place,
            claims=claims,
            reasons={name: known[name] for name in CLAIMS if name in left and name in known},
            enclosures=enclosures,
            guess=tuple(proof.found.tile["guess"]),
            looked_at=True,
            event=proof.event if same else None,
        )
        if same and not proof.rough:
            self.refusals.take(found, proof.found)
        return found

    def _folded(self, place: Place, anchor: Anchor) -> Tile | None:
        """A tile in which or near which the map's own orbit meets another one; None for none."""
        point = [rational_of(x) for x in anchor.point]
        search = FoldSearch(self.refusals.box, place.steps, point, anchor.numbers)
        with flint_precision(BITS), suppress(Failure, NotCovered):
            sheets = search.proposal()
            with asking():
                found = self.refusals.box.folded(place.steps, sheets)
            if is_same(self.refusals, found, anchor):
                tile = _tile_with(found, place)
                self.tubes[place] = found
                self.refusals.take(tile, found)
                return tile
        return None

    def _anchor(self, tile: Tile) -> Anchor | None:
        """A point of a tile with the approximate orbit there; None if no orbit has reached it."""
        region, place = self.region, tile.place
        if tile.guess:
            return Anchor(place.middle(region.box), [*map(arb, tile.guess)])
        if place.holds(region.at, region.box):
            return Anchor(region.at, region.guess)
        beside = [other for other in self.reached if other.touches(place)]
        for other in sorted(beside, key=lambda other: (-other.share, other.steps)):
            tube = self._tube(self.reached[other])
            found = None if tube is None else self._handed_on(tube, other, place)
            if found is not None:
                return found
        return None

    def _handed_on(self, tube: MapTile, own: Place, place: Place) -> Anchor | None:
        """A point that two tiles share, with the orbit that a tube has clearly there."""
        for share in SHARES:
            point = own.shared(place, self.region.box, Fraction(int(share.p), int(share.q)))
            inside = tube.inside([rational_of(x) for x in point])
            with flint_precision(BITS), suppress(Failure):
                if tube.claims_at(inside):
                    return Anchor(point, tube.at(inside))
        return None

    def _tube(self, tile: Tile) -> MapTile | None:
        """The orbit over a tile, proved again if it is not in memory; None if that fails."""
        if tile.place not in self.tubes:
            if not tile.guess:
                return None
            try:
                with asking():
                    self.tubes[tile.place] = self.refusals.proved(tile)
            except NotCovered:
                return None
        return self.tubes[tile.place]

    def _finish(self, tile: Tile) -> None:
        """Store a tile, or halve it along its longest axis if it is undecided and not too small.

        Stranded tiles that touch it wait again if it has an orbit.
        """
        place = tile.place
        if tile.claims["existence"] == "proved" or tile.event is not None:
            self.reached[place] = tile
            freed = [other for other in self.stranded if other.place.touches(place)]
            self.stranded = [other for other in self.stranded if other not in freed]
            for other in freed:
                self._wait(other)
        levels = _levels(tile)
        axis = levels.index(min(levels))
        if tile.verdict != "undecided" or levels[axis] == _DEEPEST:
            self.done.append(tile)
            self.decided += float(place.share) * (tile.verdict != "undecided")
            return
        tube = self.tubes.get(place)
        for half in place.halves(axis):
            guess: tuple[float, ...] = ()
            if tube is not None:
                self.tubes[half] = tube  # until it has one of its own
                middle = tube.inside([rational_of(x) for x in half.middle(self.region.box)])
                with flint_precision(BITS):
                    guess = tuple(float(x.mid()) for x in tube.at(middle))
            # what is proved for a tile is proved for its halves
            self._wait(replace(tile, place=half, guess=guess, looked_at=False))

    def _wait(self, tile: Tile) -> None:
        heapq.heappush(self.waiting, (-tile.place.share, next(self._order), tile))


def _looked_at(state: BoxCertificate) -> int:
    """How many tiles were looked at: those that were halved, and those of the rest."""
    return len(state.tiles) - 1 + sum(tile.looked_at for tile in state.tiles)


def _levels(tile: Tile) -> list[int]:
    """How often the box was halved along each axis."""
    return [level for _, level in tile.place.steps]


def _tile_with(found: MapTile, place: Place) -> Tile:
    """What is stated of a tile with a fold: two orbits meet in it or near it."""
    fold = found.fold
    assert fold is not None
    assert fold.band is not None
    sheets = fold.sheets
    own, other = (fold.verdicts[s] for s in sorted(fold.verdicts, key=lambda s: s != sheets.sheet))
    below, above = (BEYOND, own) if fold.sign > 0 else (own, BEYOND)
    kept = Fold(sheets.coordinate, sheets.middle, sheets.half, sheets.sheet, other)
    return replace(
        unproved(place, _MEET, looked_at=True),
        guess=tuple(sheets.guess),
        event=TileEvent("fold", None, "", "", "", (), (), fold.band, below, above, kept),
    )


def _wider(ball: arb) -> arb:
    """A ball a little wider: another version of the arithmetic may round otherwise."""
    found: arb = ball + arb(0, (1 + abs(ball)) * arb(2) ** -_SEEN)
    return found
