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
    """What is proved on a tile; each claim is "proved", "refuted" or "undecided"."""

    existence: str
    admissibility: str
    stability: str
    reasons: dict[str, str]  # why a claim is not proved
    # trace, period, dwell times and start, for all parameters of the tile
    enclosures: dict[str, arb]
    tube: Tube | None  # None unless existence is proved
    event: TileEvent | None = None  # a curve on the two sides of which verdicts are proved

    @property
    def decided(self) -> bool:
        """Whether one verdict is proved for the whole tile."""
        if self.admissibility == "refuted":
            return True
        return self.admissibility == "proved" and self.stability != "undecided"


def prove(
    region: Region, place: Place, anchor: Anchor, *, rough: bool = False, sharp: bool = False
) -> TileProof:
    """Prove what can be proved on a tile; the result names the reasons for the rest.

    The anchor has to be in the tile. `rough` takes a low order, enough where only admissibility
    is left to be decided. `sharp` takes a high order and looks for the curve of one event; it
    needs two parameters.
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
    """Whether the tube's orbit, enclosed at the anchor's point, is the anchor's orbit."""
    from flint import arb

    number = region.tables.number_at([arb(rational_of(x)) for x in anchor.point])
    return joined(region.equations(number), found, anchor.numbers)


def _wider(number: Any) -> arb:
    """A ball around all values, a little wider: the check's own enclosures may be wider too."""
    from flint import arb

    ball = range_of(number)
    found: arb = ball + arb(0, number.rad() + (1 + abs(ball)) * arb(2) ** -_SEEN)
    return found


def _undecided(reason: str) -> TileProof:
    return TileProof("undecided", "undecided", "undecided", {"existence": reason}, {}, None)


def _variables(region: Region, place: Place, space: Space) -> list[TaylorModel]:
    """The parameters on a tile as Taylor models."""
    from flint import arb

    found = []
    for axis in range(len(region.names)):
        lower, upper = (rational_of(end) for end in place.interval(axis, region.box))
        found.append(space.variable(axis, arb((lower + upper) / 2), arb((upper - lower) / 2)))
    return found
