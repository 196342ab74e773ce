"""Certify a periodic orbit for all parameters of a box, tile after tile."""

from __future__ import annotations

import heapq
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import count
from typing import TYPE_CHECKING

from nonsmooth.runtime.certification.boxes.place import Interval, Place
from nonsmooth.runtime.certification.boxes.record import BoxCertificate, Tile
from nonsmooth.runtime.certification.boxes.region import BITS, Region, checked_box, region_of
from nonsmooth.runtime.certification.boxes.tile import Follow, Proof, prove
from nonsmooth.runtime.certification.certificate import CLAIMS, Stated
from nonsmooth.runtime.certification.statement import closing_json, declaration_json
from nonsmooth.runtime.certification.subject import NotCovered, chosen_of
from nonsmooth.runtime.composition.record import ComposedOrbit
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.orbit import Orbit
from nonsmooth.runtime.values import flint_precision

if TYPE_CHECKING:
    from flint import arb

__all__ = ["MOST_TILES", "certify_box"]

MOST_TILES = 4000
_DEEPEST = 12  # halvings along each axis
_EVERY = 10.0  # seconds between states that are kept
_NOT_TRIED = "not looked at yet"


def certify_box(
    orbit: Orbit | ComposedOrbit,
    box: Mapping[str, tuple[object, object]],
    *,
    tiles: int = MOST_TILES,
    resume: BoxCertificate | None = None,
    progress: Callable[[float, int], object] = lambda decided, looked_at: None,
    keep: Callable[[BoxCertificate], object] | None = None,
) -> BoxCertificate:
    """Prove an orbit, its admissibility and its stability for all parameters of a box.

    The orbit is followed over the box in Taylor models of the parameters; a tile that is not
    decided is halved. What is proved of a tile is so for each of its parameters.

    Parameters
    ----------
    orbit : Orbit or ComposedOrbit
        A converged one, with its parameters in the box.
    box : mapping of str to (number or str, number or str)
        Lower and upper ends of parameters that were given for the orbit: rational numbers.
    tiles : int
        At most so many are looked at.
    resume : BoxCertificate, optional
        What was proved before of the same orbit and box.
    progress : function of a float and an int, optional
        Is told which share of the box is decided and how many tiles were looked at.
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

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/global-stick")
    >>> found = ns.certify_box(orbit, {"V": ("0.99", "1.01"), "eta": ("0.99", "1.01")})
    >>> found.proved, found.enclosures["trace"].upper < -0.9
    (True, True)
    """
    if isinstance(tiles, bool) or not isinstance(tiles, int) or tiles < 1:
        raise InputError(f"tiles = {tiles!r} is not a positive integer")
    ends = checked_box(orbit, box)
    undecided = dict.fromkeys(CLAIMS, "undecided")
    whole = Place(((0, 0),) * len(ends))
    try:
        region = region_of(orbit, ends)
    except NotCovered as reason:
        return _record(orbit, ends, None, [Tile(whole, undecided, str(reason), {}, (), True)])
    start = Tile(whole, undecided, _NOT_TRIED, {}, tuple(map(float, region.guess)), False)
    empty = _record(orbit, ends, region, [start])
    if resume is not None:
        _check_same(empty, resume)
    work = _Work(region, (resume or empty).tiles)
    kept = time.monotonic()
    for looked_at in range(1, tiles + 1):
        if not work.waiting:
            break
        work.look()
        progress(work.decided, looked_at)
        if keep is not None and time.monotonic() - kept > _EVERY:
            keep(_record(orbit, ends, region, work.tiles))
            kept = time.monotonic()
    return _record(orbit, ends, region, work.tiles)


class _Work:
    """Tiles that are done, and those that wait to be looked at, the largest first."""

    def __init__(self, region: Region, tiles: Sequence[Tile]) -> None:
        self.region = region
        self.done: list[Tile] = []
        self.waiting: list[tuple[Fraction, int, Tile]] = []
        self.decided = 0.0
        self._order = count()
        for tile in tiles:
            if tile.verdict == "undecided" and not tile.looked_at:
                self._wait(tile)
            else:
                self._finish(tile, None)

    @property
    def tiles(self) -> list[Tile]:
        """All of them."""
        return [*self.done, *(tile for *_, tile in sorted(self.waiting, key=_by_order))]

    def look(self) -> None:
        """Look at the largest tile that waits."""
        *_, tile = heapq.heappop(self.waiting)
        rough = "undecided" not in (tile.claims["existence"], tile.claims["stability"])
        proof = prove(self.region, tile.place, _balls(tile.guess), rough=rough)
        known = proof.existence == "proved" or tile.claims["existence"] != "proved"
        # where an orbit is known from a larger tile, only a proof leads to the same one
        follow = proof.follow if known else None
        self._finish(_judged(tile, proof, follow), follow)

    def _finish(self, tile: Tile, follow: Follow | None) -> None:
        """Halve a tile that is not decided, if it is not too small."""
        levels = [level for _, level in tile.place.steps]
        axis = levels.index(min(levels))
        if tile.verdict != "undecided" or levels[axis] == _DEEPEST:
            self.done.append(tile)
            self.decided += float(tile.place.share) * (tile.verdict != "undecided")
            return
        for sign, place in zip((-1, 1), tile.place.halves(axis), strict=True):
            guess = tile.guess
            if follow is not None:
                point = [0.5 * sign * (k == axis) for k in range(len(levels))]
                guess = tuple(map(float, follow(point)))
            # what is proved for a tile is proved for its halves
            self._wait(replace(tile, place=place, guess=guess, looked_at=False))

    def _wait(self, tile: Tile) -> None:
        heapq.heappush(self.waiting, (-tile.place.share, next(self._order), tile))


def _by_order(entry: tuple[Fraction, int, Tile]) -> tuple[Fraction, int]:
    return entry[:2]


def _judged(tile: Tile, proof: Proof, follow: Follow | None) -> Tile:
    """A tile that was looked at, with what was proved of it before if that is more."""
    if proof.existence == "undecided" and tile.claims["existence"] == "proved":
        return replace(tile, looked_at=True)
    guess = tile.guess
    if follow is not None:
        guess = tuple(map(float, follow([0.0] * len(tile.place.steps))))
    claims = dict(zip(CLAIMS, (proof.existence, proof.admissibility, proof.stability), strict=True))
    with flint_precision(BITS):
        enclosures = {
            n: Stated.around(b, BITS) for n, b in proof.enclosures.items() if b.is_finite()
        }
    return Tile(tile.place, claims, proof.reason, enclosures, guess, True)


def _balls(guess: Sequence[float]) -> list[arb]:
    from flint import arb

    return [arb(x) for x in guess]


def _record(
    orbit: Orbit | ComposedOrbit,
    box: Mapping[str, Interval],
    region: Region | None,
    tiles: Sequence[Tile],
) -> BoxCertificate:
    chosen = chosen_of(orbit) if isinstance(orbit, Orbit) and region is not None else {}
    return BoxCertificate(
        orbit.name,
        orbit.kernels.system.name if isinstance(orbit, Orbit) else orbit.kernels.name,
        {**orbit.given, **orbit.opened, **chosen},
        tuple(chosen),
        () if region is None else region.cycle.itinerary,
        dict(box),
        "stable" if region is None or region.closing.form is None else "neutral",
        tuple(tiles),
        () if region is None else region.constants,
        {} if region is None else declaration_json(region.tables, region.cycle),
        {} if region is None else closing_json(region.closing, region.cycle, BITS),
    )


def _check_same(wanted: BoxCertificate, found: BoxCertificate) -> None:
    """What is resumed is of the same orbit and box, and its system is still the same."""

    def compare(names: Sequence[str]) -> None:
        for name in names:
            if getattr(wanted, name) != getattr(found, name):
                raise InputError(f"the state to resume has another {name}")

    compare(("orbit", "itinerary", "box", "chosen"))
    fixed = [name for name in wanted.parameters if name not in wanted.box]
    for name in fixed:
        if wanted.parameters[name] != found.parameters.get(name):
            raise InputError(f"the state to resume has another {name}")
    compare(("constants", "declaration", "closing"))
