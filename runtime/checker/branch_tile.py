"""One tile of a branch: its tube, and one verdict on all of it or one event in it.

A tile states polynomials and radii: a tube in which, for each value of its coordinate, there is
exactly one root of the orbit's equations (Krawczyk, 1969). At an event a number that the event
makes zero has a derivative along the branch that is nowhere zero in the tile, by jets in Taylor
models, and opposite signs at two near points.
"""

from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, ctx

from nonsmooth.runtime.checker.branch_curve import CheckedCurve, with_entry, without_entry
from nonsmooth.runtime.checker.exact import Failure, demand, exact, inside
from nonsmooth.runtime.checker.motion import Border, admissibility, time_of_touch
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.stability import (
    MULTIPLIERS,
    characteristic,
    demand_alone,
    outside_if_reached,
    paired,
    passing,
    stability,
)
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of

__all__ = ["BITS", "OPEN", "SHARP", "CheckedTile"]

BITS, SHARP = 64, 192  # of tiles, and of points
OPEN = "undecided"
_ORDER = 5  # of the models: that of the polynomials
_STEPS = 8  # of Newton's method
_DEEPEST = 5  # halvings of a tile whose claims take smaller ones
_SHARPENINGS = 8  # of the enclosures on a part, at most


class CheckedTile:
    """One tile of a branch: a tube of orbits along one coordinate, with a verdict or an event."""

    def __init__(self, curve: CheckedCurve, tile: dict[str, Any]) -> None:
        self.curve, self.tile = curve.divided(tile["divided"]), tile
        self.place = curve.place(tile["coordinate"])
        self.low, self.high = exact(tile["lower"]), exact(tile["upper"])
        demand(self.low < self.high, "it is empty")
        self.forwards = tile["forwards"]
        self.radii = [arb(r) for r in tile["radii"]]
        demand(len(self.radii) == len(tile["centre"]) == curve.last, "a tube of another size")
        demand(all(r > 0 and r.is_finite() for r in self.radii), "the tube is empty")
        demand(
            all(len(row) == _ORDER + 1 for row in tile["centre"]), "polynomials of another order"
        )
        self.space = space_of(1, _ORDER)
        self.event = tile["event"]

    @property
    def turns(self) -> bool:
        """Whether the branch turns at the tile's event: the parameter has an extreme there."""
        if self.event is None:
            return False
        return "fold" in (self.event["kind"], *(kind for kind, *_ in self.event["also"]))

    @property
    def begin(self) -> Any:
        """Value of the tile's coordinate where the branch enters it."""
        return self.low if self.forwards else self.high

    @property
    def end(self) -> Any:
        """Value of the tile's coordinate where the branch leaves it."""
        return self.high if self.forwards else self.low

    def centre(self, value: Any) -> list[Any]:
        """Return the tube's middle, the stated polynomials, at a value of the tile's coordinate."""
        e = (value - arb((self.low + self.high) / 2)) / arb((self.high - self.low) / 2)
        found = []
        for row in self.tile["centre"]:
            total = arb(0)
            for coefficient in reversed(row):
                total = total * e + arb(coefficient)
            found.append(total)
        return found

    def holds(self, value: Any, others: Sequence[Any]) -> bool:
        """Return whether the other coordinates lie in the tube at a value of the tile's."""
        sides = zip(others, self.centre(value), self.radii, strict=True)
        return all(abs(x - c) < r for x, c, r in sides)

    def at(self, value: Any) -> list[Any]:
        """Return sharp enclosures of all coordinates of the tile's orbit at a value."""
        curve, place, middle = self.curve, self.place, value.mid()
        point = [x.mid() for x in self.centre(middle)]
        for _ in range(_STEPS):
            values, slopes = curve.slopes(with_entry(place, middle, point))
            try:
                square = matrix([without_entry(place, row) for row in slopes]).mid()
                step = square.solve(matrix([[v] for v in values]).mid())
            except ZeroDivisionError:
                raise Failure("the equations are singular at a point of it") from None
            point = [(x - d).mid() for x, d in zip(point, step.entries(), strict=True)]
        unit = arb(2) ** -int(0.6 * ctx.prec) + 64 * value.rad()
        radii = [(unit * (1 + abs(x))).upper() for x in point]
        found = curve.krawczyk(place, value, point, radii)
        demand(found is not None, "the orbit at a point of it is not proved")
        assert found is not None
        demand(self.holds(value, found), "an orbit is not in its tube")
        return with_entry(place, value, found)

    def check_sharply(self) -> None:
        """Prove the claims about the tile; retry with twice the bits, as a narrow tube may need."""
        try:
            self.check()
        except Failure:
            with ctx.workprec(2 * BITS):
                self.check()

    def check(self) -> None:
        """Prove that the tube holds one orbit for each value, and the claims about these orbits."""
        curve, place = self.curve, self.place
        half = arb((self.high - self.low) / 2)
        value = self.space.variable(0, arb((self.low + self.high) / 2), half)
        centre = [
            TaylorModel(self.space, tuple(arb(c) for c in row)) for row in self.tile["centre"]
        ]
        image = curve.krawczyk(place, value, centre, self.radii)
        demand(image is not None, "existence is not proved: Krawczyk's test fails")
        assert image is not None
        self.point = with_entry(place, value, image)
        low, high = curve.interval
        if place == curve.last:
            demand(low <= self.low and self.high <= high, "it is outside of the interval")
        else:
            over = range_of(self.point[-1])
            demand(over > low and over < high, "it is outside of the interval")
        if self.tile["before"] == OPEN:
            return
        if not self.turns:
            self.parts(self._goes_on)
        if self.event is None:
            self.parts(self._judge)
        else:
            _CheckedEvent(self).check()

    def parts(
        self, prove: Callable[[Sequence[Any]], None], point: Any = None, depth: int = 0
    ) -> None:
        """Call `prove` on the whole tile or, where that fails, on its halves again and again."""
        point = self.point if point is None else point
        try:
            prove(point)
            return
        except Failure:
            if depth == _DEEPEST:
                raise
        for side in (-1, 1):
            e = self.space.variable(0, arb(side) / 2, arb(1) / 2)
            self.parts(prove, self._sharper([x.at([e]) for x in point]), depth + 1)

    def _sharper(self, point: Sequence[Any]) -> list[Any]:
        """Return narrower enclosures of the orbits on a part, by repeated Krawczyk steps."""
        found, value = without_entry(self.place, point), point[self.place]
        widths = list(map(_width, found))
        for _ in range(_SHARPENINGS):
            image = self.curve.nearer(self.place, value, [x.mid() for x in found], widths)
            if image is None:
                break
            found = [min(pair, key=_width) for pair in zip(found, image, strict=True)]
            before, widths = widths, list(map(_width, found))
            if not any(2 * now < was for now, was in zip(widths, before, strict=True)):
                break
        return with_entry(self.place, value, found)

    def _goes_on(self, point: Sequence[Any]) -> None:
        """Demand that the parameter is strictly monotone along a part of the tile."""
        if self.place != self.curve.last:
            slope = range_of(part_of(self.curve.jets(self.place, point, 1)[-1], 1))
            demand(slope > 0 or slope < 0, "the branch may turn")

    def _judge(self, point: Sequence[Any]) -> None:
        orbit = self.curve.orbit(point)
        orbit.returns(self.curve.energies)
        admissible = admissibility(orbit).claim
        if self.tile["before"] == "not admissible":
            demand(admissible == "refuted", f"admissibility is {admissible}")
            return
        demand(admissible == "proved", f"admissibility is {admissible}")
        demand(_verdict(orbit) == self.tile["before"], f"it is {_verdict(orbit)}")


def _verdict(orbit: CheckedOrbit) -> str:
    """Return the verdict on an admissible orbit: its kind of stability, unstable or undecided."""
    words = {"proved": orbit.declared.stability, "refuted": "unstable"}
    return words.get(stability(orbit), OPEN)


class _CheckedEvent:
    """The event of a tile."""

    def __init__(self, tile: CheckedTile) -> None:
        self.tile, self.curve, self.event = tile, tile.curve, tile.event
        own = [self.event[name] for name in ("kind", "phase", "boundary", "instant")]
        self.borders = [
            Border(kind, place - 1, boundary, instant)
            for kind, place, boundary, instant in (own, *self.event["also"])
            if kind not in MULTIPLIERS
        ]
        self.below, self.above = tile.tile["before"], tile.tile["after"]
        if not tile.forwards:
            self.below, self.above = self.above, self.below
        self.low, self.high = exact(self.event["lower"]), exact(self.event["upper"])

    def check(self) -> None:
        """Prove that there is this event in the tile, and no other."""
        tile, curve, event = self.tile, self.curve, self.event
        demand(tile.low < self.low < self.high < tile.high, "its event is outside")
        window = [arb(exact(x)) for x in event["window"]]
        self.window = (window[0], window[1]) if len(window) == 2 else None
        if event["kind"] in MULTIPLIERS:
            own = [event[name] for name in ("phase", "configuration", "boundary", "instant")]
            demand(own == [None, "", "", ""] and not event["also"] and not window, "a phase")
            tile.parts(self._no_other)
            self._verdicts()
            self._passes(event["kind"], None)
        else:
            beside = [entry for entry in event["also"] if entry[0] in MULTIPLIERS]
            if beside:  # the branch turns where a phase vanishes, and no multiplier is 1
                short = (
                    tile.curve.short is not None and tile.curve.short.place == event["phase"] - 1
                )
                vanishes = short and event["kind"] == "vanishing-phase"
                turns = [["fold", event["phase"], "", ""]]
                demand(vanishes and [*map(list, beside)] == turns, "a multiplier beside a border")
                self._passes("fold", None)
            self._border()
        with ctx.workprec(SHARP):
            middle, half = (self.low + self.high) / 2, (self.high - self.low) / 2
            found = tile.at(arb(middle) + arb(0, arb(half)))
            if event["kind"] == "neimark-sacker":
                polynomial = characteristic(curve.orbit(found).section)
                demand(paired(polynomial), "it may be a neutral saddle, where two are real")
            demand(event["enclosures"].keys() == {*curve.names}, "not every unknown is enclosed")
            told = dict(zip(curve.names, found, strict=True))
            for name, stated in event["enclosures"].items():
                demand(inside(told[name], stated), f"{name} is not in its enclosure")

    @property
    def _moves(self) -> bool:
        """Whether the orbits are admissible; multipliers do not matter for those that are not."""
        return not (self.event["kind"] == "fold" and self.below == self.above == "not admissible")

    def _no_other(self, point: Sequence[Any]) -> None:
        """Demand that no multiplier passes the unit circle in any other way on a part."""
        kind, orbit = self.event["kind"], self.curve.orbit(point)
        orbit.returns(self.curve.energies)
        admissible = admissibility(orbit).claim
        demand(admissible == ("proved" if self._moves else "refuted"), "it may be no motion")
        if not self._moves:
            return
        demand_alone(orbit, kind)

    def _verdicts(self) -> None:
        """Demand the stated verdicts at both ends: on each side of the event there is only one."""
        for verdict, end in ((self.below, self.tile.low), (self.above, self.tile.high)):
            if self._moves:
                with ctx.workprec(SHARP):
                    found = _verdict(self.curve.orbit(self.tile.at(arb(end))))
                demand(found == verdict != OPEN, f"at an end it is {found}")

    def _border(self) -> None:
        """Demand motions where no border is crossed, and none beyond the first border."""
        event, steps = self.event, self.curve.declared.steps
        demand(len({*self.borders}) == len(self.borders), "a border twice")
        demand(all(0 <= border.phase < len(steps) for border in self.borders), "no such phase")
        first = self.borders[0]
        demand(event["configuration"] == steps[first.phase].name, "another configuration")
        verdict = self.below if self.above == "not admissible" else self.above
        demand(verdict not in (OPEN, "not admissible"), "no verdict beside the event")

        def but_for_it(point: Sequence[Any]) -> None:
            orbit = self.curve.orbit(point)
            orbit.returns(self.curve.energies)
            told = admissibility(orbit, self.borders, self.window).claim
            demand(told == "proved", f"but for the event admissibility is {told}")
            found = self._verdict_beside(orbit)
            demand(found == verdict, f"it is {found}")

        self.tile.parts(but_for_it)
        rises = {self._passes(border, border) for border in self.borders}
        demand(len(rises) == 1, "borders are crossed in both directions")
        verdicts = [verdict, "not admissible"]
        if rises == {False}:
            verdicts.reverse()
        demand(verdicts == [self.below, self.above], "other verdicts beside the event")

    def _verdict_beside(self, orbit: CheckedOrbit) -> str:
        """Return the verdict on an orbit on the side where no border is crossed."""
        verdict = _verdict(orbit)
        slow = [b.phase for b in self.borders if (b.kind, b.instant) == ("tangent", "end")]
        if verdict == OPEN and len(slow) == 1 and outside_if_reached(orbit, slow[0]):
            return "unstable"
        return verdict

    def _passes(self, which: Any, border: Border | None) -> bool:
        """Return whether the event's number rises through zero, once; `Failure` if it may not."""
        tile = self.tile
        signs: set[bool] = set()

        def moves(point: Sequence[Any]) -> None:
            rate = range_of(self._number(which, border, point, 1)[1])
            demand(rate > 0 or rate < 0, "an event may happen twice, or be touched only")
            signs.add(bool(rate > 0))

        tile.parts(moves)
        demand(len(signs) == 1, "an event may happen twice")
        with ctx.workprec(SHARP):
            low, high = (
                self._number(which, border, tile.at(arb(end)), 0)[0]
                for end in (self.low, self.high)
            )
        rises = signs == {True}
        opposite = (low < 0 < high) if rises else (high < 0 < low)
        demand(opposite, "there may be no event between its bounds")
        return rises

    def _number(
        self, which: Any, border: Border | None, point: Sequence[Any], order: int
    ) -> tuple[Any, Any]:
        """Return the number that is zero at the event, and its derivative along the branch.

        The derivative is None for `order` 0.
        """
        curve, place = self.curve, self.tile.place
        if which == "fold":
            slope = curve.jets(place, point, 1 + order)[-1]
            return part_of(slope, 1), 2 * part_of(slope, 2) if order else None
        jets = curve.jets(place, point, 1) if order else point
        orbit = curve.orbit(jets)
        if border is None:
            found = passing(characteristic(orbit.section), which)
        else:
            time = None
            if border.kind == "grazing":
                time = time_of_touch(curve.orbit(point), border, self.window)
            found = border.number(orbit, time)
        return part_of(found, 0), part_of(found, 1) if order else None


def _width(number: Any) -> Any:
    """Return a bound of how far the enclosed function may be from the model's polynomial."""
    return abs(range_of(number - number.mid())).upper()
