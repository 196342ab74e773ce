"""The proof on one tile of a box of parameters, in Taylor models of them.

The orbit is followed over the tile by polynomials of the parameters, Krawczyk's test shows
that there is exactly one next to them, and everything else is computed along these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.taylor_models import Space, TaylorModel, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, Region
from nonsmooth.runtime.proof.boxes.tile_event import TileEvent, event_on
from nonsmooth.runtime.proof.boxes.tile_places import Interval, Place
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import Krawczyk, contracted, followed, joined
from nonsmooth.runtime.proof.orbit_claims import (
    NOT_CONSERVED,
    claim_of_map,
    conserved,
    judged,
    named_numbers,
)

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Anchor", "TileProof", "Tube", "prove"]

_ORDERS = {1: 5, 2: 3}  # by the number of parameters: what costs least, measured
_LOWEST, _SHARP = 2, 6
_SEEN = 30  # bits to which the check, whose tube is wider, tells the ends of an enclosure


class Anchor(NamedTuple):
    """A point of the box, and about the orbit there: whatever is found has to be that."""

    point: tuple[Fraction, ...]
    numbers: Sequence[arb]


@dataclass(frozen=True, eq=False)
class Tube:
    """The orbit over a tile, between polynomials of the parameters.

    Attributes
    ----------
    place : Place
    box : tuple of (Fraction, Fraction)
        Of all tiles.
    unknowns : sequence of TaylorModel
    centre : sequence of TaylorModel
        Polynomials.
    radii : sequence of arb
        As near to these there is no other orbit.
    """

    place: Place
    box: tuple[Interval, ...]
    unknowns: Sequence[TaylorModel]
    centre: Sequence[TaylorModel]
    radii: Sequence[arb]

    def at(self, point: Sequence[Fraction]) -> list[arb]:
        """Balls around the unknowns at a point of the tile.

        Parameters
        ----------
        point : sequence of Fraction
            Values of the box's parameters.

        Returns
        -------
        list of arb
            One ball for each unknown, in the system's units.
        """
        with flint_precision(BITS):
            inside = self._inside(point)
            return [x.at(inside) for x in self.unknowns]

    def holds(self, point: Sequence[Fraction], found: Sequence[arb]) -> bool:
        """Whether an orbit at a point of the tile is the tube's.

        Parameters
        ----------
        point : sequence of Fraction
            Values of the box's parameters.
        found : sequence of arb
            An enclosure of its unknowns.

        Returns
        -------
        bool
            True if that is proved.
        """
        with flint_precision(BITS):
            inside = self._inside(point)
            sides = zip(found, self.centre, self.radii, strict=True)
            return all(abs(x - c.at(inside)) < r for x, c, r in sides)

    def _inside(self, point: Sequence[Fraction]) -> list[arb]:
        """The parameters from -1 to 1 over the tile."""
        from flint import arb

        places = ((x, *self.place.interval(axis, self.box)) for axis, x in enumerate(point))
        return [arb(rational_of((2 * x - low - high) / (high - low))) for x, low, high in places]


@dataclass(frozen=True, eq=False)
class TileProof:
    """What is proved on a tile.

    Attributes
    ----------
    existence, admissibility, stability : {"proved", "refuted", "undecided"}
    reasons : dict of str to str
        Why a claim is not proved.
    enclosures : dict of str to arb
        Trace, period, dwell times and start, for all parameters of the tile.
    tube : Tube or None
        Where existence is proved.
    event : TileEvent or None
        A curve on the two sides of which verdicts are proved.
    """

    existence: str
    admissibility: str
    stability: str
    reasons: dict[str, str]
    enclosures: dict[str, arb]
    tube: Tube | None
    event: TileEvent | None = None

    @property
    def decided(self) -> bool:
        """Whether one verdict is proved of all of it."""
        if self.admissibility == "refuted":
            return True
        return self.admissibility == "proved" and self.stability != "undecided"


def prove(
    region: Region, place: Place, anchor: Anchor, *, rough: bool = False, sharp: bool = False
) -> TileProof:
    """Prove what can be proved on a tile.

    Parameters
    ----------
    region : Region
    place : Place
    anchor : Anchor
        In the tile.
    rough : bool, default False
        Whether a low order will do, since only admissibility is left to be decided.
    sharp : bool, default False
        Whether a high order is wanted, and the curve of one event if there is one; of two
        parameters.

    Returns
    -------
    TileProof
        What is proved on the tile, and why the rest is not.
    """
    count = len(region.names)
    order = _LOWEST if rough else _ORDERS.get(count, _LOWEST)
    with flint_precision(BITS):
        return _prove(region, place, anchor, space_of(count, _SHARP if sharp else order), sharp)


def _prove(region: Region, place: Place, anchor: Anchor, space: Space, sharp: bool) -> TileProof:
    parameters = _variables(region, place, space)
    number = region.tables.number_at(parameters)
    equations = region.equations(number)
    start = followed(equations, anchor.numbers, space)
    if start is None:
        return _undecided("Newton's method finds no orbit in the middle")
    test = Krawczyk(equations, start)
    found = contracted(test)
    if found is None:
        return _undecided("Krawczyk's test fails")
    tube = Tube(place, region.box, found.image, test.centre, found.radii)
    if not _joined(region, anchor, tube.at(anchor.point)):
        return _undecided("another orbit may have been found")
    now = equations.linearised(found.image, found.flows).shooting
    dwell = equations.dwell(found.image)
    if not conserved(region, number, now):
        return _undecided(NOT_CONSERVED)
    stability = claim_of_map(region, number, equations, now)
    judgement = judged(region, number, equations.phases, now, dwell)
    named = named_numbers(region, equations, now, dwell, stability.trace)
    enclosures = {name: _wider(number) for name, number in named.items()}
    reasons = {"admissibility": judgement.reason, "stability": stability.reason}
    reasons = {name: reason for name, reason in reasons.items() if reason}
    proof = TileProof("proved", judgement.verdict, stability.verdict, reasons, enclosures, tube)
    if sharp and not proof.decided:
        return replace(proof, event=event_on(region, place, found.image, parameters))
    return proof


def _joined(region: Region, anchor: Anchor, found: Sequence[arb]) -> bool:
    """Whether what was found is the anchor's orbit."""
    from flint import arb

    number = region.tables.number_at([arb(rational_of(x)) for x in anchor.point])
    return joined(region.equations(number), found, anchor.numbers)


def _wider(number: Any) -> arb:
    """All values, with twice what is not known of the polynomial: the check finds its own."""
    from flint import arb

    ball = range_of(number)
    found: arb = ball + arb(0, number.rad() + (1 + abs(ball)) * arb(2) ** -_SEEN)
    return found


def _undecided(reason: str) -> TileProof:
    return TileProof("undecided", "undecided", "undecided", {"existence": reason}, {}, None)


def _variables(region: Region, place: Place, space: Space) -> list[TaylorModel]:
    """The parameters on a tile."""
    from flint import arb

    found = []
    for axis in range(len(region.names)):
        lower, upper = (rational_of(end) for end in place.interval(axis, region.box))
        found.append(space.variable(axis, arb((lower + upper) / 2), arb((upper - lower) / 2)))
    return found
