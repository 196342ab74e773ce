"""One event on a tile of two parameters: a curve that divides the tile into two sides.

A number g, which is zero at the event, is a Taylor model on the tile. Its derivative by one of
the parameters is nowhere zero, so for each value of the other one there is at most one event.
From g's polynomial follows a narrow band around a curve: beyond it g has one sign on each side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of
from nonsmooth.runtime.proof.admissibility import OpenInequality
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.branch.curve import along_parameter
from nonsmooth.runtime.proof.branch.passage import (
    CyclePassage,
    border,
    multiplier,
    passed_by,
    time_of_touch,
)
from nonsmooth.runtime.proof.multipliers import check_pair
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb

    Side = Literal["below", "above"]

__all__ = [
    "BEYOND",
    "Band",
    "Fold",
    "TileEvent",
    "band_about",
    "event_on",
]

BEYOND = "beyond a fold"

_FARTHEST = 3.0  # of a curve from the middle of its tile; half of the tile is 1
_NARROW = 1e-5  # the largest radius of a band, as a share of the box
_SPARE = 2  # times the radius of a band: the check finds its own
_FINEST = 2.0**-41  # the least radius that is stated, as a share of the box: all tiles round alike
_COMPOSED = 12  # order of what is composed along a curve
_STEPS = 12


@dataclass(frozen=True)
class Band:
    """A curve over one parameter of a tile, and how far from it the event may be.

    Both parameters are counted from -1 to 1 over the tile.
    """

    axis: int  # number of the parameter across; the curve is a graph over the other one
    centre: tuple[float, ...]  # coefficients of a polynomial of the other parameter
    radius: float

    def at(self, place: Fraction) -> Fraction:
        """The curve's exact value where the other parameter is `place`, from -1 to 1."""
        total = Fraction(0)
        for coefficient in reversed(self.centre):
            total = total * place + Fraction(coefficient)
        return total

    def side_of(self, point: Sequence[Fraction]) -> Side | None:
        """The side on which a point is; None in the band.

        The point has both parameters, from -1 to 1 over the tile.
        """
        away = point[self.axis] - self.at(point[1 - self.axis])
        if abs(away) <= Fraction(self.radius):
            return None
        return "above" if away > 0 else "below"

    def side_of_edge(self, one: Sequence[Fraction], other: Sequence[Fraction]) -> Side | None:
        """The side on which all points between two are; None if they may be in the band.

        Both points are given by both parameters from -1 to 1, of which one is equal for the two.
        """
        places = one[1 - self.axis], other[1 - self.axis]
        if self._monotonic or places[0] == places[1]:
            curve = [self.at(place) for place in places]
        else:
            middle, *rest = map(Fraction, self.centre)
            away = sum(map(abs, rest), Fraction(0))
            curve = [middle - away, middle + away]
        far = [point[self.axis] - at for point in (one, other) for at in curve]
        if min(far) > self.radius:
            return "above"
        return "below" if max(far) < -self.radius else None

    @property
    def _monotonic(self) -> bool:
        """Whether the curve surely rises, or surely falls."""
        slope, *bends = (k * abs(Fraction(c)) for k, c in enumerate(self.centre) if k)
        return slope > sum(bends, Fraction(0))

    @property
    def connected(self) -> bool:
        """Whether both sides are surely connected, or empty.

        They are where the curve rises or falls, and where each side is met by all lines along the
        axis or by none.
        """
        middle, *rest = map(Fraction, self.centre)
        if self._monotonic:
            return True
        away, radius = sum(map(abs, rest), Fraction(0)), Fraction(self.radius)
        return all(
            side + away + radius < 1 or side - away + radius >= 1 for side in (middle, -middle)
        )


@dataclass(frozen=True)
class Fold:
    """Two sheets of orbits that meet along a curve: a tube around both.

    In the tube one unknown is within `half` of a polynomial of the parameter along the curve.
    The other unknowns, and the parameter across, are near functions of these two.
    """

    coordinate: str  # the unknown of the orbit's equations that distinguishes the orbits
    # coefficients of the polynomial: where the orbits meet, approximately
    centre: tuple[float, ...]
    half: float  # half of the tube's width in that unknown
    sheet: str  # "below" or "above": the map's own sheet, by that unknown
    other: str  # verdict on the other sheet: "proved", "unstable" or "not admissible"


@dataclass(frozen=True)
class TileEvent:
    """A curve of one event that divides a tile.

    Verdicts are "proved", "unstable", "not admissible" or "beyond a fold". They hold for all
    parameters below the band and above it, along its axis.
    """

    # "flip", "neimark-sacker", "fold", or a border: "grazing", "tangent", "entry", "simultaneous",
    # "vanishing-phase"
    kind: str
    phase: int | None  # counted from 0, in files from 1
    configuration: str
    boundary: str
    instant: str  # "", "start", "inside" or "end"
    # times in the phase of a grazing (perhaps in `also`) between which the boundary function is
    # concave
    window: tuple[Fraction, ...]
    # kind, phase, boundary and instant of further events in the same band
    also: tuple[tuple[str, int, str, str], ...]
    band: Band
    below: str  # verdict below the band
    above: str  # verdict above the band
    # the orbits that meet; on the side beyond the fold none is in their tube
    fold: Fold | None = None

    @property
    def name(self) -> tuple[str, int | None, str, str]:
        """Kind, phase, boundary and instant, which distinguish the orbit's events."""
        return self.kind, self.phase, self.boundary, self.instant


def event_on(
    region: Region, place: Place, unknowns: Sequence[Any], parameters: Sequence[Any]
) -> TileEvent | None:
    """Prove that one event divides a tile of two parameters, and the verdicts on both sides.

    `unknowns` and `parameters` are Taylor models of the orbit over the tile. None where it is
    not proved.
    """
    point = [*unknowns, *parameters]
    passage = CyclePassage(region, point)
    judgement = passage.judged()
    stability = passage.stability.verdict
    if judgement.verdict == "proved" and stability == "undecided":
        kind = passed_by(passage)
        return _multiplier_event(region, place, point, passage, kind) if kind else None
    if judgement.verdict == "undecided" and stability != "undecided":
        opens = [which for which in judgement.open if which is not None]
        if len(opens) == len(judgement.open):
            return _border_event(region, place, point, passage, opens, stability)
    return None


def _multiplier_event(
    region: Region, place: Place, point: Sequence[Any], passage: CyclePassage, kind: str
) -> TileEvent | None:
    band = _band(place, [multiplier(passage, kind)])
    if band is None:
        return None
    if kind == "neimark-sacker":
        try:
            check_pair(range_of(passage.section))
        except NotCovered:
            return None
    jets = along_parameter(region, point, band.axis)
    if jets is None or not _rises(multiplier(CyclePassage(region, jets), kind)):
        return None
    below, above = (_verdict_beside(region, point, band, side) for side in ("below", "above"))
    if below is None or above is None or not (below or above):
        return None
    # of an empty side anything is true
    return TileEvent(kind, None, "", "", "", (), (), band, below or above, above or below)


def _border_event(
    region: Region,
    place: Place,
    point: Sequence[Any],
    passage: CyclePassage,
    opens: list[OpenInequality],
    stability: str,
) -> TileEvent | None:
    told = passage.judged(opens)
    if told.verdict != "proved":
        return None
    # a phase that vanishes ends where the one before it does
    opens.sort(key=lambda which: which.kind != "vanishing-phase")
    times: list[Any] = []
    for which in opens:
        time, window = None, told.touching.get(which)
        if which.kind == "grazing":
            time = None if window is None else time_of_touch(passage, which, window)
            if time is None:
                return None
        times.append(time)
    own = list(zip(opens, times, strict=True))
    band = _band(place, [border(passage, which, time) for which, time in own])
    if band is None:
        return None
    jets = along_parameter(region, point, band.axis)
    if jets is None:
        return None
    moving = CyclePassage(region, jets)
    signs = {_rises(border(moving, which, time)) for which, time in own}
    if signs not in ({1}, {-1}):
        return None
    beside = ["proved" if stability == "proved" else "unstable", "not admissible"]
    below, above = beside if signs == {1} else beside[::-1]
    first = opens[0]
    windows = [told.touching[which] for which in opens if which.kind == "grazing"]
    if len(windows) > 1:
        return None
    return TileEvent(
        kind=first.kind,
        phase=first.phase,
        configuration=region.cycle.itinerary[first.phase][0],
        boundary=first.boundary,
        instant=first.instant,
        window=tuple(_fraction(x) for ends in windows for x in ends),
        also=tuple((o.kind, o.phase, o.boundary, o.instant) for o in opens[1:]),
        band=band,
        below=below,
        above=above,
    )


def _rises(number: Any) -> int:
    """1 or -1 where the derivative of a jet has this sign everywhere, else 0."""
    slope = range_of(part_of(number, 1))
    return 1 if slope > 0 else -1 if slope < 0 else 0


def _band(place: Place, numbers: Sequence[TaylorModel]) -> Band | None:
    """A band on each side of which every number has one sign; None if there is no narrow one."""
    first = numbers[0]
    rates = [abs(_coefficient(first, axis)) for axis in (0, 1)]
    axis = int(rates[1] > rates[0])
    centre = _curve(first, axis)
    if centre is None:
        return None
    away = [_away(number, axis, centre) for number in numbers]
    if any(x is None for x in away):
        return None
    return band_about(place, axis, centre, max(float(x.upper()) for x in away if x is not None))


def band_about(place: Place, axis: int, centre: tuple[float, ...], away: float) -> Band | None:
    """A band about a curve, wide enough for the checker, which computes its own enclosures.

    `axis` is the number of the parameter across, `centre` the curve's polynomial in the other
    one, and `away` how far the event may be from it; all run from -1 to 1 over the tile. None if
    the band is too wide, or if a side of it may not be connected.
    """
    parts = 2.0 ** (place.steps[axis][1] + 1)  # halves of the tile are in the box
    band = Band(axis, centre, _SPARE * away + _FINEST * parts)
    return band if band.radius / parts < _NARROW and band.connected else None


def _coefficient(number: TaylorModel, axis: int) -> float:
    place = number.space.exponents.index(tuple(int(k == axis) for k in range(2)))
    part = number.parts[place]
    return 0.0 if part is None else float(part.mid())


def _curve(number: TaylorModel, axis: int) -> tuple[float, ...] | None:
    """Approximate zeros of a number, as a polynomial of the other parameter; None if far away."""
    order = number.space.order
    table = np.zeros((order + 1, order + 1))  # by powers along the axis, and of the other
    for part, exponents in zip(number.parts, number.space.exponents, strict=True):
        if part is not None:
            table[exponents[axis], exponents[1 - axis]] = float(part.mid())
    slopes = np.arange(1, order + 1)[:, None] * table[1:]
    nodes = np.cos(np.pi * (np.arange(order + 1) + 0.5) / (order + 1))
    found = np.zeros_like(nodes)
    for _ in range(_STEPS):
        with np.errstate(all="ignore"):
            value = np.polynomial.polynomial.polyval2d(found, nodes, table)
            found = found - value / np.polynomial.polynomial.polyval2d(found, nodes, slopes)
        if not (np.isfinite(found).all() and abs(found).max() < _FARTHEST):
            return None
    powers = np.vander(nodes, order + 1, increasing=True)
    return tuple(float(x) for x in np.linalg.solve(powers, found))


def _away(number: TaylorModel, axis: int, centre: Sequence[float]) -> arb | None:
    """How far zeros of a number are at most from a curve; beyond that its sign is that side's.

    The number is P + rho with a polynomial P and a bound R of |rho|. Where p is farther from
    c(q) than (R + |P(c(q), q)|) / min |dP/dp|, |P(p, q)| > R.
    """
    from flint import arb

    space = space_of(1, max(_COMPOSED, number.space.order))
    other = space.variable(0, arb(0), arb(1))
    along: Any = space.constant(arb(0))
    for coefficient in reversed(centre):
        along = along * other + arb(coefficient)
    point: list[Any] = [along, along]
    point[1 - axis] = other
    polynomial = number.mid()
    rest = sum((part.rad() for part in number.parts if part is not None), arb(0))
    missed = range_of(polynomial.at(point)) + arb(0, rest)
    reach = abs(range_of(along)).max(arb(1)).upper()
    slope: Any = arb(0)
    for part, exponents in zip(polynomial.parts, number.space.exponents, strict=True):
        power = exponents[axis]
        if part is not None and power:
            bound = reach ** (power - 1)
            even = power % 2 == 1 and exponents[1 - axis] % 2 == 0
            values = arb(0).union(bound) if even else arb(0, bound)
            constant = power == 1 and exponents[1 - axis] == 0
            slope = slope + power * part * (arb(1) if constant else values)
    if not (slope > 0 or slope < 0):
        return None
    found = (abs(missed) / abs(slope)).upper()
    return found if found.is_finite() else None


def _verdict_beside(region: Region, point: Sequence[Any], band: Band, side: str) -> str | None:
    """The verdict on multipliers on one side of a band, from a point that is clearly there.

    It is "" if no point of a 5 x 5 grid on the tile, its corners included, is on that side: as
    the curve rises or falls, or stays inside, that side is then empty. None where nothing is
    known.
    """
    places = [Fraction(k, 2) for k in range(-2, 3)]
    beside = [at for at in product(places, repeat=2) if band.side_of(at) == side]
    if not beside:
        return ""

    def distance(at: Sequence[Fraction]) -> Fraction:
        return abs(at[band.axis] - band.at(at[1 - band.axis]))

    from flint import arb

    at = [arb(x.numerator) / x.denominator for x in max(beside, key=distance)]
    claim = CyclePassage(region, [x.at(at) for x in point]).stability.verdict
    return {"proved": "proved", "refuted": "unstable"}.get(claim)


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = (int(x) for x in number.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent
