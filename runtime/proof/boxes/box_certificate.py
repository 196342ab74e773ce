"""What is proved for all parameters of a box, tile by tile."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Annotated, Any

from flint import arb

from nonsmooth.runtime.checker.ranges.folded import BEYOND, beyond_folds, neighbours
from nonsmooth.runtime.checker.ranges.tiles import verdict_of
from nonsmooth.runtime.checker.stated.exact import exact
from nonsmooth.runtime.core.errors import InputError, one_line
from nonsmooth.runtime.core.json_codec import Follows, Told, by, encode
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.values import as_value, by_name, flint_precision
from nonsmooth.runtime.proof.boxes.regions import (
    EventCurve,
    OpenBox,
    ProvedRegion,
    curves_of,
    open_boxes_of,
    regions_of,
)
from nonsmooth.runtime.proof.boxes.tile import Interval, Place, TileEvent
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    NO_ORBIT,
    Claims,
    Stability,
    Stated,
    StatedOrbits,
    ball_of,
)

BITS = 64  # working precision on tiles: their size is what makes the balls wide
KeptBall = Annotated[Stated, ball_of(BITS)]

_PLANE = 2  # parameters of a box that has regions and curves
DIGITS = 6  # of the radii that are stated: they are as wide as the box
VERDICTS = ("proved", "unstable", "not admissible", "divided", BEYOND, "undecided")


def _floats(shares: Mapping[str, Fraction]) -> dict[str, float]:
    return {name: float(share) for name, share in shares.items()}


@dataclass(frozen=True, eq=False, kw_only=True)
class Tile:
    """What is proved for all parameters of one tile.

    Attributes
    ----------
    place : Place
    claims : dict of str to {"proved", "refuted", "undecided"}
        As in a `Certificate`.
    reasons : dict of str to str
        Why a claim is not proved.
    enclosures : dict of str to Stated
        Trace, period, dwell times and start; empty where no orbit is proved to exist.
    guess : tuple of float
        Unknowns of the equations in its middle, about; empty where no orbit is proved.
    looked_at : bool
        Whether it was tried; else its claims are those of a larger tile.
    event : TileEvent or None
        A curve of an event that divides it, and the verdicts on both sides.
    """

    place: Annotated[Place, by(tuple[tuple[int, int], ...], lambda place: place.steps, Place)]
    claims: Claims
    reasons: Mapping[str, str]
    enclosures: Mapping[str, KeptBall]
    guess: tuple[float, ...] = field(repr=False)
    looked_at: bool
    event: TileEvent | None

    @property
    def verdict(self) -> str:
        """What it comes to by itself, one of `VERDICTS`; "divided" by the curve of an event."""
        return "divided" if self.event is not None else verdict_of(self.claims)


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class BoxCertificate(StatedOrbits):
    """What ball arithmetic proves of an orbit for all parameters of a box.

    The box is the union of its tiles. On each the claims hold for every parameter: there is
    exactly one orbit next to a curve or surface of unknowns that was followed over the tile,
    it is a motion of the system, and it is stable; or a claim is refuted for every parameter.
    Of two parameters a tile may have two verdicts, with a curve of one event in between, and
    where tiles with verdicts meet their orbits are proved to be the same. At a fold curve two
    orbits meet: on one side of it both are in a tube, on the other none, and parts of the box
    that are behind it alone are "beyond a fold".

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All that was given for the orbit, beside the box's.
    chosen : tuple of str
        Parameters that the orbit leaves open and that were chosen.
    itinerary : tuple of (configuration, boundary)
    box : dict of str to (Fraction, Fraction)
    stability : {"stable", "neutral"}
        What is claimed, as in a `Certificate`.
    tiles : tuple of Tile
    declaration, closing : dict
        As in a `Certificate`, over the box's parameters and those that were given.
    """

    box: Mapping[str, Interval]
    stability: Stability
    tiles: tuple[Tile, ...] = field(repr=False)

    @Follows
    def claims(self) -> Claims:
        """For the whole box: proved where all tiles are, refuted where a tile is."""
        found = {}
        for name in CLAIMS:
            told = {tile.claims[name] for tile in self.tiles}
            verdict = "undecided" if "undecided" in told else "proved"
            found[name] = "refuted" if "refuted" in told else verdict
        return found

    @property
    def proved(self) -> bool:
        """Whether all claims are proved for all parameters of the box."""
        return set(self.claims.values()) == {"proved"}

    @cached_property
    def verdicts(self) -> tuple[str, ...]:
        """What each tile comes to, one of `VERDICTS`."""
        told = [tile.verdict for tile in self.tiles]
        if len(self.box) == _PLANE:
            beside = neighbours([tile.place.steps for tile in self.tiles])
            entries = [encode(tile) for tile in self.tiles]
            beyond = beyond_folds(entries, told, beside)
            told = [BEYOND if own else one for own, one in zip(beyond, told, strict=True)]
        return tuple(told)

    @Follows
    def shares(self) -> Annotated[dict[str, Fraction], by(Mapping[str, float], _floats)]:
        """How much of the box has which of `VERDICTS`, exactly."""
        found = dict.fromkeys(VERDICTS, Fraction(0))
        for tile, verdict in zip(self.tiles, self.verdicts, strict=True):
            found[verdict] += tile.place.share
        return found

    @property
    def decided(self) -> Fraction:
        """How much of the box is not undecided."""
        return 1 - self.shares["undecided"]

    @Told
    def undecided(self) -> tuple[dict[str, Interval], ...]:
        """The boxes of parameters that are not decided."""
        told = zip(self.tiles, self.verdicts, strict=True)
        return tuple(self.where(tile) for tile, verdict in told if verdict == "undecided")

    @Told
    def regions(self) -> tuple[ProvedRegion, ...]:
        """Connected parts with one verdict, the largest first; of two parameters."""
        return regions_of(self) if len(self.box) == _PLANE else ()

    @Told
    def curves(self) -> tuple[EventCurve, ...]:
        """Curves of events, as chains of tiles; of two parameters."""
        return curves_of(self) if len(self.box) == _PLANE else ()

    @Told
    def open(self) -> tuple[OpenBox, ...]:
        """Where nothing is decided, as boxes around tiles that touch each other."""
        return open_boxes_of(self)

    @Told
    def statement(self) -> str:
        """What is proved of a box of two parameters, in one sentence; else empty."""
        if len(self.box) != _PLANE:
            return ""
        over = ", ".join(
            f"{n} in [{float(low):.10g}, {float(high):.10g}]" for n, (low, high) in self.box.items()
        )
        parts = [f"{r.verdict} ({100 * r.share:.4g} %)" for r in self.regions]
        told = f"over {over}: {_many(len(parts), 'region')}"
        told += f", {', '.join(parts)}" if parts else ""
        if self.curves:
            kinds = ", ".join(sorted({self._told(curve) for curve in self.curves}))
            told += f"; {_many(len(self.curves), 'curve')} of events ({kinds})"
        share = float(100 * self.shares["undecided"])
        return told + (f"; undecided: {share:.3g} % of the box" if share else "; no box is open")

    def _told(self, curve: EventCurve) -> str:
        """The kind of a curve's event; of a fold the orbits that meet there."""
        if curve.event.fold is None:
            return curve.event.kind
        own = {curve.event.below, curve.event.above} - {BEYOND}
        met = sorted(self.stability if v == "proved" else v for v in (*own, curve.event.fold.other))
        return f"fold: two orbits meet, {' and '.join(met)}, and there is none beyond"

    @Follows
    def reasons(self) -> dict[str, str]:
        """Why a claim is not proved, from the largest tile on which it is not."""
        found = {}
        for name, verdict in self.claims.items():
            if verdict != "proved":
                tiles = [tile for tile in self.tiles if tile.claims[name] == verdict]
                largest = max(tiles, key=lambda tile: tile.place.share)
                share = float(100 * sum(tile.place.share for tile in tiles))
                told = largest.reasons.get(name, largest.reasons.get("existence", NO_ORBIT))
                found[name] = f"on {share:.3g} % of the box: {told}"
        return found

    @Follows
    def enclosures(self) -> Mapping[str, KeptBall]:
        """Trace, period, dwell times and start over all tiles on which the orbit is proved.

        Without a trace that is unbounded on some tile.
        """
        stated = [t.enclosures for t in self.tiles if t.claims["existence"] == "proved"]
        names = [n for n in stated[0] if all(n in other for other in stated)] if stated else []
        return {name: _hull([other[name] for other in stated]) for name in names}

    def where(self, tile: Tile) -> dict[str, Interval]:
        """Give the parameters of a tile.

        Parameters
        ----------
        tile : Tile
            One of `tiles`.

        Returns
        -------
        dict of str to Interval
            Exact ends of each parameter of the box over the tile.

        Raises
        ------
        InputError
            For what is no tile.
        """
        if not isinstance(tile, Tile):
            raise InputError(f"{one_line(repr(tile), 60)} is no tile: the map has them as .tiles")
        return dict(zip(self.box, tile.place.where([*self.box.values()]), strict=True))

    def tile_at(self, point: Mapping[str, object]) -> Tile:
        """Find the first tile that holds a point of the box.

        Parameters
        ----------
        point : mapping of str to number or text
            A value of each parameter of the box; a float means its shortest decimal.

        Returns
        -------
        Tile

        Raises
        ------
        KeyError
            If a parameter of the box is missing, or the point is outside.
        InputError
            For what gives no real numbers by names.
        """
        values = by_name("point", point)
        exact = {name: as_value(values[name]).exact for name in self.box}
        for tile in self.tiles:
            where = self.where(tile)
            if all(x is not None and where[n][0] <= x <= where[n][1] for n, x in exact.items()):
                return tile
        raise KeyError(f"{dict(point)} is not in the box")

    def plot(self, axes: Any = None) -> Any:
        """Draw the box of one or two parameters.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own by default.

        Returns
        -------
        matplotlib Figure or Axes
            The figure, or the Axes that were given.

        Raises
        ------
        InputError
            If the box has more than two parameters.
        MissingExtra
            Without matplotlib: ``pip install "nonsmooth[plot]"``.
        """
        return registered("draw_box")(self, axes)


def _many(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"


def _hull(found: Sequence[Stated]) -> Stated:
    """The least ball that contains all balls, rounded outward once and not with each ball."""
    ends = [(exact(x.texts[0]), exact(x.texts[1])) for x in found]
    low, high = min(mid - rad for mid, rad in ends), max(mid + rad for mid, rad in ends)
    with flint_precision(2 * BITS):
        middle, radius = (arb(x) for x in ((low + high) / 2, (high - low) / 2))
        return Stated.around(middle + arb(0, radius), BITS, DIGITS)
