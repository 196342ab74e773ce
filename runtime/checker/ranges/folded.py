"""The check of a fold's tile: on one side of a curve there are two orbits in a tube, or none.

One parameter p is exchanged for an unknown s. In the tube, over s and the other parameter q, there
is one root for each (s, q) by Krawczyk's theorem (1969), and on it p = P(s, q) with P_ss of one
sign. At both ends of s p is beyond the tile, and P_s has opposite signs. So a point (p, q) of the
tile has two orbits in the tube, one for each sign of P_s, where p is beyond the least value of P
for q, or none where it is not; P is there or less than P_s^2 / (2 min |P_ss|) away on s = c(q).
"""

from collections import defaultdict
from collections.abc import Sequence
from math import isfinite
from typing import Any, NamedTuple

from flint import arb, fmpq

from nonsmooth.runtime.checker.orbits.motion import admissibility, demand_no_phase
from nonsmooth.runtime.checker.orbits.orbit import Cut, followed, orbit_at
from nonsmooth.runtime.checker.orbits.stability import demand_alone, stability
from nonsmooth.runtime.checker.ranges.branch_curve import (
    KRAWCZYK,
    CheckedCurve,
    Family,
    inside_box,
    middle_and_half,
    with_entry,
    without_entry,
)
from nonsmooth.runtime.checker.ranges.divided import (
    VERDICTS,
    Band,
    Part,
    Steps,
    curve_at,
    fraction,
    monotone,
)
from nonsmooth.runtime.checker.stated.exact import Entries, Numbers, demand, demand_sign
from nonsmooth.runtime.checker.stated.parameters import number_at
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import (
    TaylorModel,
    middle_of,
    range_of,
    space_of,
)

SMALLEST = 60  # halvings of the box along an axis

_Side = list[tuple[int, int, int]]


def neighbours(places: Sequence[Steps]) -> list[list[int]]:
    """Return for each tile the numbers of those with which it shares more than a point.

    A place is a (step, level) along each of two axes: part `step` of 2^level. Tiles do not overlap.
    """
    ends = [
        [(step << SMALLEST - level, step + 1 << SMALLEST - level) for step, level in place]
        for place in places
    ]
    found: list[list[int]] = [[] for _ in places]
    for axis in (0, 1):
        sides: dict[int, tuple[_Side, _Side]] = defaultdict(lambda: ([], []))
        for number, place in enumerate(ends):
            (low, high), across = place[axis], place[1 - axis]
            sides[high][0].append((*across, number))
            sides[low][1].append((*across, number))
        for before, behind in sides.values():
            first, second = sorted(before), sorted(behind)
            while first and second:
                (low, high, one), (least, most, other) = first[-1], second[-1]
                if max(low, least) < min(high, most):
                    found[one].append(other)
                    found[other].append(one)
                if low >= least:
                    first.pop()
                if least >= low:
                    second.pop()
    return found


def common_part(one: Part, other: Part) -> list[tuple[Any, Any]]:
    """Return what two boxes have in common, as the ends along each axis."""
    return [(max(a, c), min(b, d)) for (a, b), (c, d) in zip(one, other, strict=True)]


BEYOND = "beyond a fold"
_ORDER = 8  # of the models
_TRIES = (2, 4, 16)  # times the distance of the polynomials from the orbits: sizes of the box
_NEAR = 0.0625  # how far from the stated numbers the orbits may be in the middle
_CLEAR = fmpq(3, 4)  # of the tube: there a sheet is clearly one of the two
_NEWTON, _HALVINGS = 3, 64


class Sheets(NamedTuple):
    """A curve on which two orbits are said to meet, and a tube around both.

    In the tube one unknown is within `half` of a polynomial of the parameter along the curve.
    """

    axis: int  # number of the parameter across; the curve is a graph over the other one
    centre: tuple[float, ...]  # coefficients of the curve's polynomial
    coordinate: str  # the unknown of the orbit's equations that distinguishes the orbits
    middle: tuple[float, ...]  # coefficients of its polynomial
    half: float
    sheet: str  # "below" or "above": the map's own orbit, by that unknown
    guess: Sequence[float]  # the other unknowns, and the parameter across, amid the tube


class FoldedTile:
    """What is proved of a tile near a fold when it is made: two orbits meet, each with a verdict.

    `where` holds the tile's ends along each axis. `Failure` is raised if it is not proved.
    """

    def __init__(self, family: Family, where: Part, sheets: Sheets) -> None:
        declared = family.declared
        demand(sheets.coordinate in declared.unknowns, "there is no such unknown")
        self.place = declared.unknowns.index(sheets.coordinate)
        demand(all(isfinite(c) for c in sheets.middle), "a curve without bounds")
        self.half = fraction(sheets.half)
        demand(sheets.middle and self.half > 0, "a tube without width")
        self.family, self.sheets, self.axis, self.where = family, sheets, sheets.axis, where
        self.guess = [arb(float(x)) for x in sheets.guess]
        demand(len(self.guess) == len(declared.unknowns), "the guess is of another size")
        self.verdicts: dict[str, str] = {}  # of both orbits, by their sheet
        self.far: Any = None  # how far from the curve they may meet
        self.band: Band | None = None  # in which they do, once that is known
        self._prove()

    @staticmethod
    def stated(family: Family, where: Part, tile: Entries) -> "FoldedTile":
        """Prove all that a file states of a tile with a fold."""
        event = tile["event"]
        fold = event["fold"]
        demand(fold is not None, "a fold without its orbits")
        demand_no_phase(event)
        demand({*tile["claims"].values()} == {"undecided"}, "claims of another event")
        demand(not tile["enclosures"], "enclosures of no orbit")
        band = Band.stated(event, family.names, tile["place"])
        tube = fold["coordinate"], tuple(fold["centre"]), fold["half"], fold["sheet"]
        sheets = Sheets(band.axis, band.centre, *tube, tile["guess"])
        found = FoldedTile(family, where, sheets)
        found.band = band
        demand(found.far < arb(fraction(band.radius)), "they may meet beside the band")
        ahead, behind = ("above", "below") if found.sign > 0 else ("below", "above")
        demand(event[behind] == BEYOND, "a verdict on the side of no orbits")
        demand(event[ahead] != BEYOND, "no verdict on the side of both orbits")
        told = {"below": fold["other"], "above": fold["other"], sheets.sheet: event[ahead]}
        demand(found.verdicts == told, "other verdicts beside the fold")
        return found

    def _curve(self, change: Cut, beside: Any) -> CheckedCurve:
        return self.family.along(self.axis, [change(beside)])

    def _prove(self) -> None:
        """Prove all of it in Taylor models over the tube (e) and the tile (q)."""
        space = space_of(2, _ORDER)
        beside = space.variable(1, *middle_and_half(*self.where[1 - self.axis]))
        along = space.variable(1, arb(0), arb(1))
        value = curve_at(self.sheets.middle, along) + space.variable(0, arb(0), arb(self.half))
        self._locate(beside, value)
        curve = self._curve(lambda x: x, beside)
        point = with_entry(self.place, value, self.root)
        jets = curve.jets(self.place, point, 2)
        slope, bend = part_of(jets[-1], 1), range_of(2 * part_of(jets[-1], 2))
        demand_sign(bend, "the parameter may not be bent one way")
        self._leaves(slope, bend)
        self._meets(slope, bend)
        self._judge(curve, beside, point)

    def _locate(self, beside: Any, value: Any) -> None:
        """Prove one root for each place in the tube, next to polynomials of Newton's method."""

        def at(cut: Cut, others: Numbers, slopes: bool) -> tuple[Any, Any]:
            point = with_entry(self.place, cut(value), others)
            return self._curve(cut, beside).square(self.place, point)

        cuts = [*[middle_of] * _NEWTON, *map(_cut, (1, 3, _ORDER))]
        others, inverse = followed(at, self.guess, cuts)
        curve = self._curve(lambda x: x, beside)
        values, _ = curve.square(self.place, with_entry(self.place, value, others))
        missed = (inverse * values).entries()
        sizes = [abs(range_of(d)) + arb(2) ** -50 for d in missed]
        for times in _TRIES:
            self.radii = [(times * size).upper() for size in sizes]
            demand(all(r.is_finite() for r in self.radii), KRAWCZYK)
            image = curve.image(self.place, value, others, self.radii)
            if image[1]:
                break
        self.polynomials, self.root = others, inside_box(image)
        middle = [range_of(x.at([arb(0), arb(0)])) for x in self.root]
        pairs = zip(middle, self.guess, strict=True)
        near = all(abs(x - g) < _NEAR * (1 + abs(g)) for x, g in pairs)
        demand(near, "the orbits are not near the numbers that are stated")

    def _leaves(self, slope: Any, bend: Any) -> None:
        """Demand that at both ends of the tube the parameter is beyond the tile and moves away."""
        self.sign = 1 if bend > 0 else -1
        edge = arb(self.where[self.axis][1 if self.sign > 0 else 0])
        for end in (-1, 1):
            over, rate = (_along(x, end) for x in (self.root[-1], slope))
            demand((over - edge) * self.sign > 0, "the tube ends in the tile")
            demand(rate * end * self.sign > 0, "two orbits may not meet in the tube")

    def _meets(self, slope: Any, bend: Any) -> None:
        """Find how far from the curve, and from the middle of the tube, the orbits may meet."""
        middle, half = middle_and_half(*self.where[self.axis])
        along = space_of(1, _ORDER).variable(0, arb(0), arb(1))
        away = (self.root[-1].at([arb(0), along]) - middle) / half
        rate = abs(_along(slope, 0))
        least = rate * rate / (2 * abs(bend)) / half
        self.far = abs(range_of(away - curve_at(self.sheets.centre, along))) + least
        self.apart = (rate / abs(bend) / arb(self.half)).upper()
        demand(self.apart < arb(_CLEAR), "they may meet far from the middle of the tube")

    def _judge(self, curve: CheckedCurve, beside: Any, point: Numbers) -> None:
        """Find both orbits' verdicts; only on the curve is a multiplier on the unit circle."""
        orbit = curve.orbit(point)
        orbit.returns(self.family.energies)
        admissible = admissibility(orbit).claim
        if admissible == "refuted":
            self.verdicts = dict.fromkeys(("below", "above"), "not admissible")
            return
        demand(admissible == "proved", f"admissibility is {admissible}")
        demand_alone(orbit, "fold")
        for sheet, end in (("below", -_CLEAR), ("above", _CLEAR)):
            at = [x.at([arb(end), arb(0)]) for x in point]
            told = stability(self._curve(lambda x: x, beside.at([arb(end), arb(0)])).orbit(at))
            demand(told in VERDICTS, f"stability of an orbit beside the fold is {told}")
            self.verdicts[sheet] = VERDICTS[told]

    def claims_at(self, point: Numbers) -> bool:
        """Return whether a point, from -1 to 1 over the tile, clearly has orbits."""
        assert self.band is not None
        return self.band.side_of(point) == ("above" if self.sign > 0 else "below")

    def at(self, point: Numbers) -> list[Any]:
        """Return enclosed unknowns of the map's orbit at a point, from -1 to 1 over the tile.

        `Failure` is raised if this orbit is not proved.
        """
        values = [
            arb((low + high) / 2 + x * (high - low) / 2)
            for x, (low, high) in zip(point, self.where, strict=True)
        ]
        side, other = -1 if self.sheets.sheet == "below" else 1, arb(point[1 - self.axis])
        near, far = arb(0), arb(side)
        for _ in range(_HALVINGS):  # nothing is proved of it
            middle = ((near + far) / 2).mid()
            beyond = (self.root[-1].at([middle, other]) - values[self.axis]).mid() * self.sign > 0
            near, far = (near, middle) if beyond else (middle, far)
        rest = [x.at([near, other]).mid() for x in self.root[:-1]]
        start = curve_at(self.sheets.middle, other) + near * arb(self.half)
        number = number_at([*values, *self.family.constants])
        root = orbit_at(
            self.family.declared, number, with_entry(self.place, start.mid(), rest)
        ).root
        demand(self.holds(point, root), "an orbit at a point is not in the tube")
        return list(root)

    def holds(self, point: Numbers, found: Numbers) -> bool:
        """Return whether an orbit at a point, from -1 to 1 over the tile, is the map's.

        `found` holds the orbit's unknowns, as balls.
        """
        other = arb(point[1 - self.axis])
        low, high = self.where[self.axis]
        value = arb((low + high) / 2 + point[self.axis] * (high - low) / 2)
        away = (found[self.place] - curve_at(self.sheets.middle, other)) / arb(self.half)
        if not abs(away) < 1:
            return False
        rest = [*without_entry(self.place, found), value]
        sides = zip(rest, self.polynomials, self.radii, strict=True)
        if not all(abs(x - c.at([away, other])) < r for x, c, r in sides):
            return False
        return bool(away < -self.apart if self.sheets.sheet == "below" else away > self.apart)


def beyond_folds(
    tiles: Sequence[Entries],
    verdicts: Sequence[str],
    beside: Sequence[Sequence[int]],
) -> list[bool]:
    """Return which undecided tiles border on nothing but each other and what is beyond folds.

    `tiles` have two parameters, `verdicts` has one of each tile by itself, and `beside`
    has for each tile those with which it shares an edge. The answer has one bool for each
    tile.
    """
    where = [
        [(fmpq(step, 2**level), fmpq(step + 1, 2**level)) for step, level in tile["place"]]
        for tile in tiles
    ]
    open_ones = [k for k, verdict in enumerate(verdicts) if verdict == "undecided"]
    parts: dict[int, list[int]] = {k: [] for k in open_ones}
    behind, left = dict.fromkeys(open_ones, False), dict.fromkeys(open_ones, False)
    for k in open_ones:
        for other in beside[k]:
            both = common_part(where[k], where[other])
            if other in parts:
                parts[k].append(other)
            elif _is_beyond(tiles[other], where[other], both):
                behind[k] = True
            else:
                left[k] = True
    found, seen = [False] * len(tiles), set()
    for first in open_ones:
        if first in seen:
            continue
        group, waiting = {first}, [first]
        while waiting:
            for other in parts[waiting.pop()]:
                if other not in group:
                    group.add(other)
                    waiting.append(other)
        seen |= group
        if any(behind[k] for k in group) and not any(left[k] for k in group):
            for k in group:
                found[k] = True
    return found


def _is_beyond(tile: Entries, place: Sequence[Any], edge: Sequence[Any]) -> bool:
    """Return whether an edge lies on the side beyond a tile's fold, where there are no orbits.

    Nothing is assumed about what is beside the edge. Along the curve's parameter, the
    polynomial is at most the sum of its terms' sizes; if it is monotone, its values at
    the ends bound it.
    """
    event = tile["event"]
    if event is None or event["kind"] != "fold":
        return False
    axis = event["axis"] - 1
    centre, radius = [fraction(c) for c in event["centre"]], fraction(event["radius"])
    sign = 1 if event["above"] == BEYOND else -1
    sides = [
        [(2 * x - low - high) / (high - low) for x in ends]
        for ends, (low, high) in zip(edge, place, strict=True)
    ]
    one_way, over = monotone(centre)
    if one_way:
        curve = [curve_at(event["centre"], other) for other in sides[1 - axis]]
    else:
        curve = [centre[0] - over, centre[0] + over]
    return all((at - c) * sign > radius for at in sides[axis] for c in curve)


def _along(model: Any, end: int) -> Any:
    """Return the range of a model where e has a given value."""
    other = space_of(1, _ORDER).variable(0, arb(0), arb(1))
    return range_of(model.at([arb(end), other]))


def _cut(order: int) -> Cut:
    """Return a function that cuts numbers to polynomials of an order."""
    space = space_of(2, order)

    def cut(number: Any) -> Any:
        middle = number.mid()
        return middle.cast(space) if isinstance(number, TaylorModel) else space.constant(middle)

    return cut
