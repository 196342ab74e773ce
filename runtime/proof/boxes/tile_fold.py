"""A fold curve on a tile of two parameters: two orbits meet there, and beyond it there are none.

Where two orbits meet the equations are singular by the parameters. One parameter p is exchanged
for an unknown s of the orbit: over s and the other parameter q the orbits are a graph, on which
p = P(s, q) with P_ss of one sign. So for each q there is one place at which P_s = 0. On one side
of the curve p = P there are two orbits in the tube, one for each sign of P_s, on the other none.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, Region
from nonsmooth.runtime.proof.boxes.tile_event import (
    BEYOND,
    Band,
    Fold,
    TileEvent,
    band_about,
)
from nonsmooth.runtime.proof.boxes.tile_places import Place
from nonsmooth.runtime.proof.branch.curve import (
    AlongUnknown,
    OrbitCurve,
    along_parameter,
    directions,
)
from nonsmooth.runtime.proof.branch.passage import CyclePassage, others_at_circle
from nonsmooth.runtime.proof.branch.tube import orbit_near
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import Krawczyk, contracted, followed, joined

if TYPE_CHECKING:
    from flint import arb

__all__ = ["FoldTube", "fold_on", "fold_tube"]

_ORDER = 8  # of the models
_NODES = 3  # places at which the fold is sought
_FARTHEST = 3.0  # of a fold from the middle of a tile; half of the tile is 1
_STEPS = 12
_SETTLED = 2.0**-24  # of the tile: how much a step before the last moves the fold
_WIDER = (1.08, 1.3)  # times the width at which a parabola leaves the tile
_CLEAR = 0.75  # of the tube's half: there a sheet is clearly one of the two


@dataclass(frozen=True, eq=False)
class FoldTube:
    """Two sheets of orbits over a tile, as a graph over one unknown and one parameter.

    Over the tube the unknown is counted by e, from -1 to 1, and the other parameter from -1 to 1
    over the tile.
    """

    region: Region
    place: Place
    axis: int  # number of the parameter that is a function of the unknown and the other parameter
    fold: Fold
    point: list[Any]  # Taylor models of all unknowns of the orbit's equations and of that parameter
    centre: Sequence[Any]  # polynomials for all of these but the unknown
    radii: Sequence[arb]  # within these distances of the polynomials there are no other orbits
    slope: Any  # Taylor model: first derivative of the parameter by the unknown
    bend: arb  # second derivative of the parameter by the unknown: of one sign

    def at(self, point: Sequence[Fraction]) -> list[arb] | None:
        """An enclosure of the map's own orbit at a point of the tile, by values of the parameters.

        None where no orbit is proved to be on the sheet.
        """
        with flint_precision(BITS):
            guess = self._near(point)
            if guess is None:
                return None
            region = self.region
            curve = OrbitCurve(region, self.axis, _beside(point, self.axis))
            value = _ball(point[self.axis])
            found = orbit_near(curve, curve.parameter, value, guess, BITS)
            own = None if found is None else found[:-1]
        return own if own is not None and self.holds(point, own) else None

    def holds(self, point: Sequence[Fraction], found: Sequence[arb]) -> bool:
        """Whether an orbit, enclosed by `found` at a point, is proved to be the map's own."""
        from flint import arb

        with flint_precision(BITS):
            own = [*found, _ball(point[self.axis])]
            other = self._other(point)
            away = (own[self.coordinate] - _polynomial(self.fold.centre, other)) / arb(
                self.fold.half
            )
            if not abs(away) < 1:
                return False
            inside = [away, other]
            rest = [*own[: self.coordinate], *own[self.coordinate + 1 :]]
            sides = zip(rest, self.centre, self.radii, strict=True)
            if not all(abs(x - c.at(inside)) < r for x, c, r in sides):
                return False
            meets = self.meeting
            return bool(away < -meets if self.fold.sheet == "below" else away > meets)

    @property
    def coordinate(self) -> int:
        """The index of the unknown over which the sheets are a graph."""
        return OrbitCurve(self.region, self.axis).names.index(self.fold.coordinate)

    @property
    def guess(self) -> tuple[float, ...]:
        """The other unknowns, and last the parameter across, in the middle of the tube."""
        return tuple(float(x.parts[0].mid()) for x in self.centre)

    @property
    def meeting(self) -> arb:
        """An upper bound of |e| where the two sheets meet: the slope is zero there."""
        missed = abs(range_of(_on_curve(self.slope)))
        found: arb = (missed / abs(self.bend) / self.fold.half).upper()
        return found

    def _other(self, point: Sequence[Fraction]) -> arb:
        """The other parameter at a point, from -1 to 1 over the tile."""
        other = 1 - self.axis
        low, high = self.place.interval(other, self.region.box)
        return _ball((2 * point[other] - low - high) / (high - low))

    def _near(self, point: Sequence[Fraction]) -> list[arb] | None:
        """Approximate unknowns of the map's own orbit at a point, by bisection in e."""
        from flint import arb

        other, sign = self._other(point), -1 if self.fold.sheet == "below" else 1
        wanted = float(point[self.axis])
        row = _row_of(self.point[-1], float(other.mid()))
        row[0] -= wanted
        low, high = 0.0, float(sign)
        values = [float(np.polynomial.polynomial.polyval(x, row)) for x in (low, high)]
        if not values[0] * values[1] < 0:
            return None
        for _ in range(60):
            middle = (low + high) / 2
            value = float(np.polynomial.polynomial.polyval(middle, row))
            low, high = (middle, high) if value * values[0] > 0 else (low, middle)
        return [x.at([arb(low), other]).mid() for x in self.point[:-1]]


class _FoldPoint(NamedTuple):
    """A point at which two orbits meet, in numbers that are not proved."""

    point: list[Any]
    bend: float


def fold_on(
    region: Region, place: Place, point: Sequence[Fraction], numbers: Sequence[arb]
) -> tuple[FoldTube, TileEvent] | None:
    """Prove that a fold curve divides a tile, or passes near it, and the verdicts beside it.

    The tile is of two parameters; `numbers` are the map's own orbit at a point of it. None where
    it is not proved.
    """
    with flint_precision(BITS):
        start = [x.mid() for x in numbers]
        chosen = _coordinates(region, place, point, start)
        if chosen is None:
            return None
        axis, coordinate = chosen
        near = [*start, _ball(point[axis])]
        first = _meeting(region, place, axis, coordinate, point[1 - axis], near)
        if first is None:
            return None
        coordinate = _straightest(region, axis, coordinate, point[1 - axis], first)
        meetings = _meetings(region, place, axis, coordinate, first)
        if meetings is None:
            return None
        for wider in _WIDER:
            fold = _tried(place, region, axis, coordinate, meetings, wider)
            if fold is None:
                return None
            middle = meetings[len(meetings) // 2].point
            guess = [*middle[:coordinate], *middle[coordinate + 1 :]]
            tube = fold_tube(region, place, axis, fold, guess)
            if tube is None:
                return None
            if not _leaves(tube):
                continue
            for sheet in ("below", "above"):
                own = _with_sheet(tube, sheet)
                known = own.at(point)
                if known is None or not _same(region, point, known, numbers):
                    continue
                event = _judged(own)
                if event is None or event.fold is None:
                    return None
                return replace(own, fold=event.fold), event
    return None


def fold_tube(
    region: Region, place: Place, axis: int, fold: Fold, guess: Sequence[arb]
) -> FoldTube | None:
    """Prove that orbits are a graph over an unknown and a parameter, bent in one direction.

    The tile is of two parameters, and `axis` is the number of the one across. `guess` has the
    other unknowns and last the parameter across, approximately, in the middle of the tube. None
    where it is not proved.
    """
    from flint import arb

    with flint_precision(BITS):
        space = space_of(2, _ORDER)
        low, high = (rational_of(x) for x in place.interval(1 - axis, region.box))
        beside = space.variable(1, arb((low + high) / 2), arb((high - low) / 2))
        along = space.variable(1, arb(0), arb(1))
        value = _polynomial(fold.centre, along) + space.variable(0, arb(0), arb(fold.half))
        curve = OrbitCurve(region, axis, (beside,))
        coordinate = curve.names.index(fold.coordinate)
        equations = curve.equations(coordinate, value)
        start = followed(equations, [x.mid() for x in guess], space, (1, 3))
        if start is None:
            return None
        test = Krawczyk(equations, start)
        found = contracted(test)
        if found is None:
            return None
        whole = curve.point(coordinate, value, found.image)
        jets = directions(curve, coordinate, whole, 2)
        if jets is None:
            return None
        slope, bend = part_of(jets[-1], 1), range_of(2 * part_of(jets[-1], 2))
        if not (bend > 0 or bend < 0):
            return None
        return FoldTube(region, place, axis, fold, whole, test.centre, found.radii, slope, bend)


def _coordinates(
    region: Region, place: Place, point: Sequence[Fraction], start: Sequence[arb]
) -> tuple[int, int] | None:
    """The parameter that changes orbits most over the tile, and the unknown that changes most."""
    sizes = [abs(float(x)) for x in start]
    sizes = [max(x, max(sizes) / 20) for x in sizes]
    best: tuple[float, int, int] | None = None
    for axis in (0, 1):
        jets = along_parameter(region, [*start, *map(_ball, point)], axis)
        if jets is None:
            return None
        low, high = place.interval(axis, region.box)
        rates = [
            abs(float(_rate(x))) / size for x, size in zip(jets[: len(start)], sizes, strict=True)
        ]
        largest = max(range(len(rates)), key=rates.__getitem__)
        found = rates[largest] * float(high - low), axis, largest
        if best is None or found > best:
            best = found
    return None if best is None else best[1:]


def _rate(number: Any) -> Any:
    """The approximate derivative in a jet."""
    return range_of(part_of(number, 1)).mid()


def _straightest(
    region: Region, axis: int, coordinate: int, other: Fraction, at: _FoldPoint
) -> int:
    """The unknown in which the parameter is most nearly a parabola: its cubic term is least.

    With p = c2 e^2 + c3 e^3 and an unknown a1 e + a2 e^2, that is c3 - 2 c2 a2 / a1 in its units.
    """
    curve = OrbitCurve(region, axis, (_ball(other),))
    jets = directions(curve, coordinate, at.point, 3)
    if jets is None:
        return coordinate
    _, _, square, cube = (float(range_of(part_of(jets[-1], k)).mid()) for k in range(4))

    def cubic(k: int) -> float:
        first, second = (float(range_of(part_of(jets[k], order)).mid()) for order in (1, 2))
        return abs(cube - 2 * square * second / first) if first else math.inf

    return min(range(len(jets) - 1), key=cubic)


def _meetings(
    region: Region, place: Place, axis: int, coordinate: int, first: _FoldPoint
) -> list[_FoldPoint] | None:
    """Points where orbits meet, at the other parameter's Chebyshev nodes over the tile."""
    low, high = place.interval(1 - axis, region.box)
    nodes = [Fraction(x) for x in _nodes(_NODES)]
    middle = len(nodes) // 2
    found: dict[int, _FoldPoint] = {}
    for order in (range(middle, -1, -1), range(middle + 1, len(nodes))):
        before = first if not found else found[middle]
        for k in order:
            other = (low + high) / 2 + nodes[k] * (high - low) / 2
            meeting = _meeting(region, place, axis, coordinate, other, before.point)
            if meeting is None:
                return None
            found[k] = before = meeting
    return [found[k] for k in range(len(nodes))]


def _meeting(
    region: Region, place: Place, axis: int, coordinate: int, other: Fraction, near: Sequence[arb]
) -> _FoldPoint | None:
    """A point where P_s is zero, by Newton's method in s; nothing is proved of it."""
    curve = OrbitCurve(region, axis, (_ball(other),))
    low, high = (float(x) for x in place.interval(axis, region.box))
    point = [x.mid() for x in near]
    for _ in range(_STEPS):
        value, others = point[coordinate], curve.others(coordinate, point)
        jets = directions(curve, coordinate, point, 2)
        now = AlongUnknown(curve, coordinate, value).linearised(others)
        try:
            change = now.jacobian.mid().solve(now.residual.mid()).entries()
        except ZeroDivisionError:
            return None
        if jets is None or not all(x.is_finite() for x in change):
            return None
        slope, half = (part_of(jets[-1], k).mid() for k in (1, 2))
        if float(half) == 0:
            return None
        step = (slope / (2 * half)).mid()
        moved = abs(float(slope * step / 2)) + abs(float(change[-1]))
        rates = curve.others(coordinate, [_rate(x) for x in jets])
        others = [(x - d - r * step).mid() for x, d, r in zip(others, change, rates, strict=True)]
        point = curve.point(coordinate, (value - step).mid(), others)
        if not abs(2 * float(point[-1]) - low - high) <= _FARTHEST * (high - low):
            return None
        if moved <= _SETTLED * (high - low):
            return _FoldPoint(point, 2 * float(half))
    return None


def _tried(
    place: Place,
    region: Region,
    axis: int,
    coordinate: int,
    meetings: list[_FoldPoint],
    wider: float,
) -> Fold | None:
    """A tube that should be just wide enough for both sheets to leave the tile in it."""
    low, high = (float(x) for x in place.interval(axis, region.box))
    turned = meetings[0].bend > 0
    widths = []
    for meeting in meetings:
        at = float(meeting.point[-1].mid())
        rise = high - at if turned else at - low
        if (meeting.bend > 0) != turned:
            return None
        widths.append(math.sqrt(max(2 * rise / abs(meeting.bend), 0.0)))
    half = wider * max(widths)
    if half == 0:
        return None
    centre = _fitted([float(meeting.point[coordinate].mid()) for meeting in meetings])
    name = OrbitCurve(region, axis).names[coordinate]
    return Fold(name, centre, half, "below", "")


def _nodes(count: int) -> list[float]:
    """Chebyshev nodes between -1 and 1."""
    return [float(x) for x in np.cos(np.pi * (np.arange(count) + 0.5) / count)]


def _fitted(values: Sequence[float]) -> tuple[float, ...]:
    """Coefficients of the polynomial through values at as many Chebyshev nodes."""
    powers = np.vander(_nodes(len(values)), len(values), increasing=True)
    return tuple(float(x) for x in np.linalg.solve(powers, values))


def _leaves(tube: FoldTube) -> bool:
    """Whether both sheets leave the tile, on the side that has orbits, before the tube ends."""
    from flint import arb

    sign = 1 if tube.bend > 0 else -1
    low, high = (_ball(x) for x in tube.place.interval(tube.axis, tube.region.box))
    edge = high if sign > 0 else low
    along = space_of(1, _ORDER).variable(0, arb(0), arb(1))
    for end in (-1, 1):
        over, slope = (range_of(x.at([arb(end), along])) for x in (tube.point[-1], tube.slope))
        if not ((over - edge) * sign > 0 and slope * sign * end > 0):
            return False
    return True


def _judged(tube: FoldTube) -> TileEvent | None:
    """The fold as an event, with its band and the verdicts on both sheets; None if undecided."""
    band = _band(tube)
    if band is None:
        return None
    region = tube.region
    passage = CyclePassage(region, _arranged(tube, tube.point))
    if not passage.conserved:
        return None
    judgement = passage.judged()
    if judgement.verdict == "undecided":
        return None
    verdicts = {"below": "not admissible", "above": "not admissible"}
    if judgement.verdict == "proved":
        if region.closing.form is not None or region.cycle.one_sided or passage.section is None:
            return None
        if others_at_circle(passage, "fold"):
            return None
        for sheet, end in (("below", -_CLEAR), ("above", _CLEAR)):
            verdict = _verdict_at(tube, end)
            if verdict is None:
                return None
            verdicts[sheet] = verdict
    own, other = (
        verdicts[s] for s in (tube.fold.sheet, "above" if tube.fold.sheet == "below" else "below")
    )
    below, above = (BEYOND, own) if tube.bend > 0 else (own, BEYOND)
    fold = replace(tube.fold, other=other)
    return TileEvent("fold", None, "", "", "", (), (), band, below, above, fold)


def _verdict_at(tube: FoldTube, end: float) -> str | None:
    """The verdict on multipliers of one sheet, from a point that is clearly on it."""
    from flint import arb

    if not abs(end) > tube.meeting:
        return None
    orbit = _arranged(tube, [x.at([arb(end), arb(0)]) for x in tube.point])
    verdict = CyclePassage(tube.region, orbit).stability.verdict
    return {"proved": "proved", "refuted": "unstable"}.get(verdict)


def _arranged(tube: FoldTube, point: Sequence[Any]) -> list[Any]:
    """The unknowns and both parameters, in the order of the region's axes."""
    other = 1 - tube.axis
    low, high = (rational_of(x) for x in tube.place.interval(other, tube.region.box))
    from flint import arb

    if isinstance(point[-1], TaylorModel):
        beside: Any = point[-1].space.variable(1, arb((low + high) / 2), arb((high - low) / 2))
    else:
        beside = arb((low + high) / 2)
    return [*point[:-1], *((point[-1], beside) if tube.axis == 0 else (beside, point[-1]))]


def _band(tube: FoldTube) -> Band | None:
    """A band that holds the curve: P on e = 0 exceeds its minimum by at most P_s^2/(2 P_ss)."""
    from flint import arb

    low, high = (rational_of(x) for x in tube.place.interval(tube.axis, tube.region.box))
    middle, half = arb((low + high) / 2), arb((high - low) / 2)
    places = _nodes(_ORDER + 1)
    values = [_least(tube, x) for x in places]
    centre = _fitted([(x - float(middle)) / float(half) for x in values])
    along = space_of(1, _ORDER).variable(0, arb(0), arb(1))
    missed = abs(range_of((_on_curve(tube.point[-1]) - middle) / half - _polynomial(centre, along)))
    slope = abs(range_of(_on_curve(tube.slope)))
    least = slope * slope / (2 * abs(tube.bend)) / half
    return band_about(tube.place, tube.axis, centre, float((missed + least).upper()))


def _least(tube: FoldTube, other: float) -> float:
    """The approximate value of the parameter across at which orbits meet."""
    row = np.polynomial.Polynomial(_row_of(tube.point[-1], other))
    slopes, bends, place = row.deriv(), row.deriv(2), 0.0
    for _ in range(_STEPS):
        place = float(place - slopes(place) / bends(place))
    return float(row(place))


def _same(
    region: Region, point: Sequence[Fraction], found: Sequence[arb], numbers: Sequence[arb]
) -> bool:
    return joined(
        region.equations(region.tables.number_at(list(map(_ball, point)))), found, numbers
    )


def _with_sheet(tube: FoldTube, sheet: str) -> FoldTube:
    return replace(tube, fold=replace(tube.fold, sheet=sheet))


def _on_curve(model: Any) -> Any:
    """A model restricted to e = 0, as a model of the other parameter."""
    from flint import arb

    return model.at([arb(0), space_of(1, _ORDER).variable(0, arb(0), arb(1))])


def _row_of(model: TaylorModel, other: float) -> Any:
    """Approximate coefficients of a model in e, at a value of the other parameter."""
    row = np.zeros(model.space.order + 1)
    for part, (power, beside) in zip(model.parts, model.space.exponents, strict=True):
        if part is not None:
            row[power] += float(part.mid()) * other**beside
    return row


def _polynomial(centre: Sequence[float], place: Any) -> Any:
    from flint import arb

    total: Any = arb(0) * place
    for coefficient in reversed(centre):
        total = total * place + arb(coefficient)
    return total


def _beside(point: Sequence[Fraction], axis: int) -> tuple[arb, ...]:
    return (_ball(point[1 - axis]),)


def _ball(number: Fraction) -> arb:
    from flint import arb

    return arb(rational_of(number))
