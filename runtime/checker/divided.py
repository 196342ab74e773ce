"""The check of a divided tile: one event on a curve, with a verdict on each side of it.

A number g is zero at the event. Its derivative by one parameter has one sign on the tile, by
jets in Taylor models. With g = P + rho, |rho| < R, on a part of the tile, g has one sign where p
is farther from a curve c(q) than (R + |P(c(q), q)|) / min |dP/dp|: P is a polynomial there.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.checker.branch_curve import solution
from nonsmooth.runtime.checker.exact import demand, exact
from nonsmooth.runtime.checker.motion import Border, admissibility, time_of_touch
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.parameters import number_at
from nonsmooth.runtime.checker.stability import (
    MULTIPLIERS,
    characteristic,
    demand_alone,
    paired,
    passing,
    stability,
)
from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of

__all__ = ["Division", "Part", "checked_band", "fraction"]

Part = Sequence[tuple[Any, Any]]
_PARAMETERS = 2
_ORDER = 12  # of what is composed along a curve
_NARROW = fmpq(1, 100_000)  # the largest radius of a band, as a share of the box
_VERDICTS = {"proved": "proved", "refuted": "unstable"}


def checked_band(
    event: dict[str, Any], names: Sequence[str], place: Sequence[tuple[int, int]]
) -> tuple[int, list[Any], Any]:
    """Return the band of a tile's event: the axis across it, its curve's coefficients, its radius.

    The band runs over the tile's coordinates from -1 to 1; `place` has the tile's step
    and level along each axis. `Failure` is raised if the band is too wide, or if one of
    its sides in the tile may consist of several parts.
    """
    demand(len(names) == _PARAMETERS and event["across"] in names, "a curve in no plane")
    axis, centre = names.index(event["across"]), [fraction(c) for c in event["centre"]]
    radius = fraction(event["radius"])
    demand(len(centre) > 1 and radius > 0, "a curve without width")
    share = radius / 2 ** (place[axis][1] + 1)
    demand(share < _NARROW, "a band is too wide: a part of the tile has no verdict")
    bends = sum((k * abs(c) for k, c in enumerate(centre) if k > 1), fmpq(0))
    over = sum((abs(c) for c in centre[1:]), fmpq(0))
    whole = all(  # each side is on all lines along the axis, or on none
        side * centre[0] + over + radius < 1 or side * centre[0] - over + radius >= 1
        for side in (-1, 1)
    )
    demand(whole or abs(centre[1]) > bends, "a side may consist of several parts")
    return axis, centre, radius


class Division:
    """The claims about a tile that a curve divides, with one event on the curve.

    `claims` are the verdicts on existence, admissibility and stability of the whole tile;
    `place` is its step and level along each axis.
    """

    def __init__(
        self, event: dict[str, Any], claims: tuple[str, str, str], names: Sequence[str],
        place: Sequence[tuple[int, int]],
    ) -> None:  # fmt: skip
        demand(event["kind"] != "fold" and event["fold"] is None, "at a fold the orbit ends")
        self.event = event
        self.axis, self.centre, self.radius = checked_band(event, names, place)
        own = [event[name] for name in ("kind", "phase", "boundary", "instant")]
        self.borders: list[Border] = []
        self.window: tuple[Any, Any] | None = None
        _, admissible, stable = claims
        window = [arb(exact(x)) for x in event["window"]]
        if event["kind"] in MULTIPLIERS:
            named = [own[1], event["configuration"], *own[2:]]
            demand(named == [None, "", "", ""] and not event["also"] and not window, "a phase")
            demand((admissible, stable) == ("proved", "undecided"), "claims of another event")
            demand("not admissible" not in (event["below"], event["above"]), "other verdicts")
        else:
            told = admissible == "undecided" and stable in _VERDICTS
            demand(told, "claims of another event")
            rows = [own, *event["also"]]
            demand(all(isinstance(place, int) for _, place, *_ in rows), "a border of no phase")
            self.borders = [Border(kind, place - 1, *rest) for kind, place, *rest in rows]
            demand(not {b.kind for b in self.borders} & {*MULTIPLIERS}, "a multiplier at a border")
            demand(len({*self.borders}) == len(self.borders), "a border twice")
            grazes = [b for b in self.borders if b.kind == "grazing"]
            demand(len(grazes) == len(window) / 2 <= 1, "a window of no grazing")
            self.window = (window[0], window[1]) if window else None
            self.beside = {_VERDICTS[stable], "not admissible"}
            demand({event["below"], event["above"]} == self.beside, "other verdicts")
        self.signs: set[bool] = set()

    def phases(self, orbit: CheckedOrbit) -> None:
        """Demand that the phases of the event's borders are those of the orbit."""
        steps = orbit.declared.steps
        demand(all(0 <= border.phase < len(steps) for border in self.borders), "no such phase")
        if self.borders:
            name = steps[self.borders[0].phase].name
            demand(self.event["configuration"] == name, "another configuration")

    def prove(
        self, orbit: CheckedOrbit, energies: Any, parameters: Sequence[Any], constants: Any,
        part: Part,
    ) -> None:  # fmt: skip
        """Prove on a part of the tile what the division needs.

        The orbit is located, in Taylor models of the parameters on the part; `energies` are
        those of `StatedSystem.closes`, and the part is in the tile's coordinates from -1 to
        1.
        """
        orbit.returns(energies)
        kind = self.event["kind"]
        moving = _moving(orbit, parameters, constants, self.axis)
        if self.borders:
            told = admissibility(orbit, self.borders, self.window).claim
            beside = {-1: self.event["below"], 1: self.event["above"]}
            if told == "refuted" and beside.get(self._over(part)[0]) == "not admissible":
                told = "proved" if admissibility(orbit).claim == "refuted" else told
            demand(told == "proved", f"but for the event admissibility is {told}")
        else:
            demand_alone(orbit, kind)
            if kind == "neimark-sacker":
                demand(paired(characteristic(orbit.section)), "two multipliers may be real")
        borders: Sequence[Border | None] = self.borders or [None]
        for border in borders:
            number, slope = _number(orbit, moving, kind, border, self.window)
            rate = range_of(slope)
            demand(rate > 0 or rate < 0, "an event may happen twice, or be touched only")
            self._beyond(number, part, 1 if rate > 0 else -1)
            self.signs.add(bool(rate > 0))

    def _beyond(self, number: TaylorModel, part: Part, sign: int) -> None:
        """Demand that a number has one sign on each side of the band, on a part.

        Its derivative by the parameter across the band has the given sign on the part.
        """
        axis = self.axis
        side, along, other = self._over(part)
        if side:
            value = range_of(number) * sign
            demand(value * side > 0, "there may be an event beside its band")
            return
        radius, over = arb(2 * self.radius / (part[axis][1] - part[axis][0])), range_of(along)
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
        demand(missed < radius * abs(slope), "there may be an event beside its band")

    def _over(self, part: Part) -> tuple[int, Any, Any]:
        """Return -1 or 1 if a part is below or above the band, else 0; the curve; its variable."""
        middles = [(low + high) / 2 for low, high in part]
        halves = [(high - low) / 2 for low, high in part]
        space, axis = space_of(1, _ORDER), self.axis
        other = space.variable(0, arb(0), arb(1))
        place = other * arb(halves[1 - axis]) + arb(middles[1 - axis])
        along: Any = space.constant(arb(0))
        for coefficient in reversed(self.centre):
            along = along * place + arb(coefficient)
        along = (along - arb(middles[axis])) / arb(halves[axis])
        over, radius = range_of(along), arb(self.radius / halves[axis])
        side = -1 if over - radius > 1 else 1 if over + radius < -1 else 0
        return side, along, other

    def verdicts(self, at: Callable[[Sequence[Any]], CheckedOrbit]) -> None:
        """Demand the verdicts on both sides, when all parts are proved.

        `at` gives the orbit at a point of the tile, in its coordinates from -1 to 1.
        """
        demand(self.borders or len(self.signs) == 1, "an event may happen twice")
        below, above = self.event["below"], self.event["above"]
        if self.borders:
            demand(len(self.signs) == 1, "borders are crossed in both directions")
            beyond = above if self.signs == {True} else below
            demand(beyond == "not admissible", "other verdicts beside the event")
            return
        points = [(fmpq(i, 4), fmpq(j, 4)) for i, j in product(range(-4, 5), repeat=2)]
        clear = 0
        for side, verdict in ((-1, below), (1, above)):
            away = [side * self._away(point) for point in points]
            best = max(range(len(points)), key=away.__getitem__)
            if away[best] > self.radius:
                clear += 1
                told = stability(at([arb(x) for x in points[best]]))
                demand(_VERDICTS.get(told) == verdict, f"beside the event stability is {told}")
            else:  # no corner is there: the side is empty
                demand(below == above, "a verdict on an empty side")
        demand(clear, "the tile is thinner than its band")

    def _away(self, point: Sequence[Any]) -> Any:
        total = fmpq(0)
        for coefficient in reversed(self.centre):
            total = total * point[1 - self.axis] + coefficient
        return point[self.axis] - total


def _power(bound: Any, power: int) -> Any:
    """Return an enclosure of a power of all numbers from -bound to bound; even ones are >= 0."""
    if power == 0:
        return arb(1)
    return arb(0, bound**power) if power % 2 else arb(0).union(bound**power)


def fraction(number: float) -> Any:
    """Return the exact value of a file's float; `Failure` if it is not finite."""
    demand(abs(number) < float("inf"), "a curve without bounds")
    return fmpq(*Fraction(number).as_integer_ratio())


def _moving(
    orbit: CheckedOrbit, parameters: Sequence[Any], constants: Any, axis: int
) -> CheckedOrbit:
    """Return the orbit with derivatives by one parameter, by implicit differentiation."""
    moved = [jet(x, arb(1)) if k == axis else x for k, x in enumerate(parameters)]
    number = number_at([*moved, *constants])
    first = CheckedOrbit(orbit.declared, number)
    flows = [(b * t).exp() for b, t in zip(first.chain.fields, orbit.dwell, strict=True)]
    now = first.passage(first.chain, orbit.root, flows)
    square = part_of(now.slopes, 0)
    try:
        about = square.mid().inv().mid()
    except ZeroDivisionError:
        about = matrix([[arb("nan")] * square.ncols()] * square.nrows())
    step = solution(square, about, -part_of(now.values, 1))
    found = CheckedOrbit(orbit.declared, number)
    found.along([jet(x, d) for x, d in zip(orbit.root, step, strict=True)])
    return found


def _number(
    orbit: CheckedOrbit, moving: CheckedOrbit, kind: str, border: Border | None,
    window: tuple[Any, Any] | None,
) -> tuple[Any, Any]:  # fmt: skip
    """Return the number that is zero at the event, and its derivative by the parameter."""
    if border is None:
        found = passing(characteristic(moving.section), kind)
    else:
        time = time_of_touch(orbit, border, window) if border.kind == "grazing" else None
        found = border.number(moving, time)
    return part_of(found, 0), part_of(found, 1)
