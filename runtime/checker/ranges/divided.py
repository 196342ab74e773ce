"""The check of a divided tile: one event on a curve, with a verdict on each side of it.

A number g is zero at the event. Its derivative by one parameter has one sign on the tile, by
jets in Taylor models. With g = P + rho, |rho| < R, on a part of the tile, g has one sign where p
is farther from a curve c(q) than (R + |P(c(q), q)|) / min |dP/dp|: P is a polynomial there.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import product
from typing import Any, NamedTuple

from flint import arb, fmpq

from nonsmooth.runtime.checker.orbits.motion import (
    Border,
    Window,
    admissibility,
    borders_of,
    demand_no_phase,
    event_number,
)
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.stability import (
    MULTIPLIERS,
    characteristic,
    demand_alone,
    paired,
    stability,
)
from nonsmooth.runtime.checker.ranges.branch_curve import Family
from nonsmooth.runtime.checker.stated.exact import Entries, Numbers, demand, demand_sign
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of

Part = Sequence[tuple[Any, Any]]
Steps = Sequence[tuple[int, int]]  # of a tile: along each axis, part k of 2^level
_WHOLE = ((fmpq(-1), fmpq(1)),) * 2
_ORDER = 12  # of what is composed along a curve
_NARROW = fmpq(1, 100_000)  # the largest radius of a band, as a share of the box
_SPARE = 2  # times the radius that a band needs: another version of the arithmetic rounds otherwise
_FINEST = 2.0**-41  # the least radius that is found, as a share of the box: all tiles round alike
VERDICTS = {"proved": "proved", "refuted": "unstable"}  # of admissible orbits, by stability


class Band(NamedTuple):
    """A curve over one parameter of a tile, and how far from it the event may be.

    Both parameters are counted from -1 to 1 over the tile.
    """

    axis: int  # number of the parameter across; the curve is a graph over the other one
    centre: tuple[float, ...]  # coefficients of a polynomial of the other parameter
    radius: float

    @staticmethod
    def stated(event: Entries, names: Sequence[str], place: Steps) -> "Band":
        """Return the band that a file states of an event; `Failure` as from `about`.

        `place` has the tile's step and level along each axis.
        """
        demand(len(names) == len(_WHOLE) and event["axis"] in (1, 2), "a curve in no plane")
        band = Band(event["axis"] - 1, tuple(event["centre"]), event["radius"])
        return band._checked(place)

    @staticmethod
    def about(axis: int, centre: Sequence[float], away: Any, place: Steps) -> "Band":
        """Return a band about a curve from which an event is proved to be at most so far away.

        `Failure` is raised if it is too wide, or if a side of it in the tile may consist of
        several parts.
        """
        parts = 2.0 ** (place[axis][1] + 1)  # halves of the tile are in the box
        radius = _SPARE * float(away.upper()) + _FINEST * parts
        return Band(axis, tuple(centre), radius)._checked(place)

    def _checked(self, place: Steps) -> "Band":
        centre, radius = [fraction(c) for c in self.centre], fraction(self.radius)
        demand(len(centre) > 1 and radius > 0, "a curve without width")
        share = radius / 2 ** (place[self.axis][1] + 1)
        demand(share < _NARROW, "a band is too wide: a part of the tile has no verdict")
        one_way, over = monotone(centre)
        whole = all(  # each side is on all lines along the axis, or on none
            side * centre[0] + over + radius < 1 or side * centre[0] - over + radius >= 1
            for side in (-1, 1)
        )
        demand(whole or one_way, "a side may consist of several parts")
        return self

    def at(self, place: Any) -> Any:
        """Return the curve's value where the other parameter is `place`, from -1 to 1."""
        return curve_at(self.centre, place)

    def side_of(self, point: Numbers) -> str | None:
        """Return the side, "below" or "above", on which a point surely is; None in the band.

        The point has both parameters, as fractions from -1 to 1 over the tile.
        """
        away = self.away(point)
        if abs(away) <= Fraction(self.radius):
            return None
        return "above" if away > 0 else "below"

    def away(self, point: Numbers) -> Fraction:
        """Return how far a point is above the curve, along the axis."""
        place = [Fraction(int(x.numerator), int(x.denominator)) for x in point]
        found: Fraction = place[self.axis] - self.at(place[1 - self.axis])
        return found


class DividingCurve(NamedTuple):
    """A curve across a tile of two parameters on which one event is said to happen."""

    kind: str
    borders: tuple[Border, ...]  # all that happen on it; none where multipliers tell
    window: Window  # times in the phase of a grazing, between which it is
    axis: int  # as of a band
    centre: tuple[float, ...]


class Division:
    """What is proved of a tile that a curve divides, with one event on the curve.

    `claims` are the verdicts on existence, admissibility and stability of the whole tile. Of a
    file, `band` and `beside` are what it states: the band, and the verdicts below and above it.
    """

    def __init__(
        self, curve: DividingCurve, claims: Sequence[str], band: Band | None = None,
        beside: tuple[str, str] = ("", ""),
    ) -> None:  # fmt: skip
        _, admissible, self.stable = claims
        self.curve, self.band, self.beside = curve, band, beside
        self.borders, self.window = curve.borders, curve.window
        if self.borders:
            told = admissible == "undecided" and self.stable in VERDICTS
            demand(self.borders[0].kind == curve.kind, "a border of another kind")
            demand(len({*self.borders}) == len(self.borders), "a border twice")
        else:
            told = (admissible, self.stable) == ("proved", "undecided")
            demand(curve.kind in MULTIPLIERS and curve.kind != "fold", "at a fold the orbit ends")
        demand(told, "claims of another event")
        grazes = sum(border.kind == "grazing" for border in self.borders)
        demand(grazes == (self.window is not None), "a window of no grazing")
        self.signs: set[bool] = set()
        self.far = arb(0)  # how far the event may be from the curve

    @staticmethod
    def stated(
        event: Entries, claims: Sequence[str], names: Sequence[str],
        place: Steps,
    ) -> "Division":  # fmt: skip
        """Return what a file states of a tile, whose step and level along each axis are `place`."""
        demand(event["kind"] != "fold" and event["fold"] is None, "at a fold the orbit ends")
        band = Band.stated(event, names, place)
        if event["kind"] in MULTIPLIERS:
            demand_no_phase(event)
        own = [event["kind"], *(kind for kind, *_ in event["also"])]
        demand(len(own) == 1 or not {*own} & {*MULTIPLIERS}, "a multiplier at a border")
        borders, times = borders_of(event)
        curve = DividingCurve(event["kind"], tuple(borders), times, band.axis, band.centre)
        return Division(curve, claims, band, (event["below"], event["above"]))

    def judge(
        self, orbit: CheckedOrbit, family: Family, parameters: Numbers,
        at: Callable[[Numbers], CheckedOrbit], place: Steps,
    ) -> None:  # fmt: skip
        """Find the band and the verdicts on both sides, on a whole tile; as `prove`, `verdicts`."""
        self.phases(orbit)
        self.prove(orbit, family, parameters, _WHOLE)
        self.band = Band.about(self.curve.axis, self.curve.centre, self.far, place)
        self.beside = self.verdicts(at)

    def phases(self, orbit: CheckedOrbit) -> str:
        """Return the configuration of the event's first border, if its phases are the orbit's."""
        steps = orbit.declared.steps
        demand(all(0 <= border.phase < len(steps) for border in self.borders), "no such phase")
        return steps[self.borders[0].phase].name if self.borders else ""

    def prove(self, orbit: CheckedOrbit, family: Family, parameters: Numbers, part: Part) -> None:
        """Prove on a part of the tile what the division needs.

        The orbit is located, in Taylor models of the parameters on the part, which is in the tile's
        coordinates from -1 to 1.
        """
        orbit.returns(family.energies)
        kind = self.curve.kind
        moving = _moving(orbit, family, parameters, self.curve.axis)
        if self.borders:
            told = admissibility(orbit, self.borders, self.window).claim
            beside = dict(zip((-1, 1), self.beside, strict=True))
            if told == "refuted" and beside.get(self._over(part)[0]) == "not admissible":
                told = "proved" if admissibility(orbit).claim == "refuted" else told
            demand(told == "proved", f"but for the event admissibility is {told}")
        else:
            demand_alone(orbit, kind)
            if kind == "neimark-sacker":
                demand(paired(characteristic(orbit.section)), "two multipliers may be real")
        for which in self.borders or [kind]:
            found = event_number(which, moving, lambda: orbit, self.window)
            number, rate = part_of(found, 0), range_of(part_of(found, 1))
            demand_sign(rate, "an event may happen twice, or be touched only")
            self._beyond(number, part, 1 if rate > 0 else -1)
            self.signs.add(bool(rate > 0))

    def _beyond(self, number: TaylorModel, part: Part, sign: int) -> None:
        """Find how far from the curve a number may be zero, on a part; that is in the band, if any.

        Its derivative by the parameter across the curve has the given sign on the part.
        """
        axis = self.curve.axis
        side, along, other = self._over(part)
        if side:
            value = range_of(number) * sign
            demand(value * side > 0, "there may be an event beside its band")
            return
        over = range_of(along)
        polynomial = number.mid()
        rest = sum((p.rad() for p in number.parts if p is not None), arb(0))
        point: list[Any] = [along, along]
        point[1 - axis] = other
        missed = abs(range_of(polynomial.at(point))) + rest
        slope, reach = arb(0), abs(over).max(arb(1)).upper()
        for p, exponents in zip(polynomial.parts, number.space.exponents, strict=True):
            if p is not None and exponents[axis]:
                power = exponents[axis] - 1
                others = _power(arb(1), exponents[1 - axis])
                slope += (power + 1) * p * _power(reach, power) * others
        demand(slope * sign > 0, "there may be an event beside its band")
        far = missed / abs(slope) * arb((part[axis][1] - part[axis][0]) / 2)
        held = self.band is None or far < arb(fraction(self.band.radius))
        demand(held and far.is_finite(), "there may be an event beside its band")
        self.far = self.far.max(far)

    def _over(self, part: Part) -> tuple[int, Any, Any]:
        """Return -1 or 1 if a part is below or above the band, else 0; the curve; its variable."""
        middles = [(low + high) / 2 for low, high in part]
        halves = [(high - low) / 2 for low, high in part]
        space, axis = space_of(1, _ORDER), self.curve.axis
        other = space.variable(0, arb(0), arb(1))
        place = other * arb(halves[1 - axis]) + arb(middles[1 - axis])
        along = (curve_at(self.curve.centre, place) - arb(middles[axis])) / arb(halves[axis])
        if self.band is None:
            return 0, along, other
        over, radius = range_of(along), arb(fraction(self.band.radius) / halves[axis])
        side = -1 if over - radius > 1 else 1 if over + radius < -1 else 0
        return side, along, other

    def verdicts(self, at: Callable[[Numbers], CheckedOrbit]) -> tuple[str, str]:
        """Return the verdicts below and above the band, when all parts are proved.

        `at` gives the orbit at a point of the tile, in its coordinates from -1 to 1. Of an empty
        side the verdict is that of the other one.
        """
        demand(len(self.signs) == 1, "an event may happen twice, or in both directions")
        if self.borders:
            beside = VERDICTS[self.stable], "not admissible"
            return beside if self.signs == {True} else beside[::-1]
        band = self.band
        assert band is not None
        grid = [(Fraction(i, 4), Fraction(j, 4)) for i, j in product(range(-4, 5), repeat=2)]
        found = []
        for side in ("below", "above"):
            points = [point for point in grid if band.side_of(point) == side]
            if not points:  # no corner is there: the side is empty
                continue
            clearest = max(points, key=lambda point: abs(band.away(point)))
            told = stability(at([arb(fmpq(*x.as_integer_ratio())) for x in clearest]))
            demand(told in VERDICTS, f"beside the event stability is {told}")
            found.append(VERDICTS[told])
        demand(found, "the tile is thinner than its band")
        return found[0], found[-1]


def _power(bound: Any, power: int) -> Any:
    """Return an enclosure of a power of all numbers from -bound to bound; even ones are >= 0."""
    if power == 0:
        return arb(1)
    return arb(0, bound**power) if power % 2 else arb(0).union(bound**power)


def monotone(centre: Numbers) -> tuple[bool, Any]:
    """Return whether a polynomial surely only rises or falls from -1 to 1, by its terms' sizes.

    With it comes a bound of how far it is there from its constant term.
    """
    bends = sum((k * abs(c) for k, c in enumerate(centre) if k > 1), fmpq(0))
    return abs(centre[1]) > bends, sum((abs(c) for c in centre[1:]), fmpq(0))


def fraction(number: float) -> Any:
    """Return the exact value of a file's float; `Failure` if it is not finite."""
    demand(abs(number) < float("inf"), "a curve without bounds")
    return fmpq(*Fraction(number).as_integer_ratio())


def curve_at(centre: Sequence[float], place: Any) -> Any:
    """Return the value of a polynomial, as a number of the same kind as the place."""
    kind: Any = {fmpq: fraction, Fraction: Fraction}.get(type(place), arb)
    total = place * 0
    for coefficient in reversed(centre):
        total = total * place + kind(coefficient)
    return total


def _moving(orbit: CheckedOrbit, family: Family, parameters: Numbers, axis: int) -> CheckedOrbit:
    """Return the orbit with derivatives by one parameter, by implicit differentiation."""
    beside = [x for k, x in enumerate(parameters) if k != axis]
    curve = family.along(axis, beside)
    return curve.orbit(curve.jets(curve.last, [*orbit.root, parameters[axis]], 1))
