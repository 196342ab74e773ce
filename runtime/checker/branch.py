"""The check of a branch: tiles that follow each other, each with one verdict or one event.

A tile states polynomials and radii: a tube in which, for each value of its coordinate, there is
exactly one root of the orbit's equations (Krawczyk, 1969). Where two tiles meet one orbit lies in
both tubes. At an event a number that the event makes zero has a derivative along the branch that
is nowhere zero in the tile, by jets in Taylor models, and opposite signs at two near points.
"""

from collections.abc import Callable, Sequence
from copy import copy
from itertools import pairwise
from typing import Any

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.declared import StatedSystem
from nonsmooth.runtime.checker.exact import Failure, check_sum, demand, exact, inside
from nonsmooth.runtime.checker.motion import Border, admissibility, time_of_touch
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.parameters import independent, number_at, values_of
from nonsmooth.runtime.checker.shape import BRANCH, check_shape
from nonsmooth.runtime.checker.short import Short, short_phase
from nonsmooth.runtime.checker.stability import (
    MULTIPLIERS,
    characteristic,
    demand_alone,
    paired,
    passing,
    stability,
)
from nonsmooth.runtime.core.jets import Jet, jet, part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of

__all__ = ["CheckedCurve", "CheckedTile", "check_branch", "checked_tiles", "solution"]

_BITS, _SHARP = 64, 192
_ORDER = 5  # of the models: that of the polynomials
_STEPS = 8  # of Newton's method
_DEEPEST = 5  # halvings of a tile whose claims take smaller ones
_FINISHED, _VANISHED = "end of the interval", "a phase vanishes"
_OPEN = "undecided"


def check_branch(content: dict[str, Any]) -> None:
    """Prove every claim of a branch; Failure says which one cannot be.

    Parameters
    ----------
    content : dict
        The file, read as JSON.

    Raises
    ------
    Failure
        If a claim is not proved.
    Malformed
        If the file has another shape.
    """
    check_shape(content, BRANCH)
    check_sum(content)
    checked_tiles(content)


def checked_tiles(content: dict[str, Any]) -> list["CheckedTile"]:
    """Prove every claim of a branch whose entries have their shape.

    Parameters
    ----------
    content : dict
        Entries of a branch.

    Returns
    -------
    list of CheckedTile
        Its tiles, proved.

    Raises
    ------
    Failure
        If a claim is not proved.
    """
    tiles = content["tiles"]
    _claimed(content)
    if not tiles:
        return []
    demand(content["declaration"], "claims about no declaration")
    with ctx.workprec(_BITS):
        told = content["declaration"].get("constants", [])
        name = content["parameter"]
        values, stated, constants = values_of(content["parameters"], [name], told)
        declared = StatedSystem(content, values, stated)
        demand(declared.bound and declared.rational, "the declaration is not exact")
        demand(content["stability"] == declared.stability, "stability of another kind")
        demand(content["unknown_names"] == declared.unknowns, "other unknowns")
        curve = CheckedCurve(declared, declared.closes(), constants, content)
        found = [CheckedTile(curve, tile) for tile in tiles]
        for number, tile in enumerate(found, 1):
            try:
                tile.check_sharply()
            except Failure as failure:
                raise Failure(f"in tile {number} of the branch: {failure}") from None
        for number, (tile, other) in enumerate(pairwise(found), 1):
            try:
                _joined(tile, other)
            except Failure as failure:
                raise Failure(f"tiles {number} and {number + 1}: {failure}") from None
        _ends(found, content)
        independent(declared, constants, [tuple(map(exact, content["interval"]))])
    return found


def _claimed(content: dict[str, Any]) -> None:
    """What is said of the whole branch follows from its tiles."""
    tiles = content["tiles"]
    demand(0 <= content["start"] <= len(tiles), "it starts in none of its tiles")
    low, high = map(exact, content["interval"])
    demand(low < high, "the interval is empty")
    every = all(_OPEN not in (tile["before"], tile["after"]) for tile in tiles)
    whole = bool(tiles) and every and {*content["ends"]} <= {_FINISHED, _VANISHED}
    demand((content["claims"]["branch"] == "proved") == whole, "the claim is not that of the tiles")
    for tile in tiles:
        left = tile["before"] == _OPEN
        demand(left == bool(tile["reason"]), "reasons of other tiles")
        demand(left == (tile["after"] == _OPEN), "a tile that is half decided")
        demand(tile["event"] is None or not left, "an event of an undecided tile")
        same = tile["before"] == tile["after"]
        demand(same or tile["event"], "the verdict changes without an event")


class CheckedCurve:
    """The equations of the orbits: their unknowns, and last the parameter, on one footing."""

    def __init__(
        self, declared: StatedSystem, energies: Any, constants: Any, content: dict[str, Any]
    ) -> None:
        self.declared, self.energies, self.constants = declared, energies, constants
        self.names = [*declared.unknowns, content["parameter"]]
        self.last = len(self.names) - 1
        self.interval = tuple(map(exact, content["interval"]))
        self.short: Short | None = None

    def divided(self, place: int | None) -> "CheckedCurve":
        """The same orbits by equations with one phase's condition divided by its dwell time."""
        if place is None:
            return self
        found = copy(self)
        found.short = short_phase(self.declared, place - 1)
        return found

    def undivided(self) -> "CheckedCurve":
        """The same orbits by the equations of all phases."""
        found = copy(self)
        found.short = None
        return found

    def place(self, name: str) -> int:
        """The coordinate of a name: of the parameter, if an unknown has its name too."""
        demand(name in self.names, "there is no such coordinate")
        return self.last if name == self.names[self.last] else self.names.index(name)

    def _with(self, parameter: Any) -> CheckedOrbit:
        """An orbit of which only the parameter is known."""
        return CheckedOrbit(self.declared, number_at([parameter, *self.constants]), self.short)

    def orbit(self, point: Sequence[Any]) -> CheckedOrbit:
        """What passes with these numbers for unknowns and parameter."""
        orbit = self._with(point[-1])
        orbit.along(point[:-1])
        return orbit

    def slopes(
        self, point: Sequence[Any], middle: Sequence[Any] | None = None
    ) -> tuple[list[Any], list[list[Any]]]:
        """Values of the equations (n), and their derivatives (n, n + 1) by all coordinates.

        Flows over a box are those of its middle, times short ones.
        """
        parameter = jet(point[-1], arb(1))
        orbit = self._with(parameter)
        times = point[orbit.first : -1]
        known = times if middle is None else middle[orbit.first : -1]
        flows = [(b * t).exp() for b, t in zip(orbit.chain.fields, known, strict=True)]
        if middle is not None:
            away = [t - c for t, c in zip(times, known, strict=True)]
            short = zip(orbit.chain.fields, away, flows, strict=True)
            flows = [(b * d).exp() * flow for b, d, flow in short]
        now = orbit.passage(orbit.chain, point[:-1], flows)
        own, along = part_of(now.slopes, 0), part_of(now.values, 1)
        rows = [[*(own[i, j] for j in range(self.last)), along[i, 0]] for i in range(self.last)]
        return part_of(now.values, 0).entries(), rows

    def krawczyk(
        self, place: int, value: Any, centre: Sequence[Any], radii: Sequence[Any]
    ) -> list[Any] | None:
        """The image of a box of the other coordinates, where it lies inside: one root is there."""
        box = [x + arb(0, r) for x, r in zip(centre, radii, strict=True)]
        values, slopes = self.slopes(_with(place, value, centre))
        try:
            y = matrix([_without(place, row) for row in slopes]).mid().inv().mid()
        except ZeroDivisionError:
            return None
        _, over = self.slopes(_with(place, value, box), _with(place, value, centre))
        size = self.last
        unit = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
        rest = unit - y * matrix([_without(place, row) for row in over])
        moved = rest * arb_mat([[arb(0, r)] for r in radii]) - y * matrix([[v] for v in values])
        found = moved.entries()
        if not all(abs(d) < r for d, r in zip(found, radii, strict=True)):
            return None
        return [x + d for x, d in zip(centre, found, strict=True)]

    def jets(self, place: int, point: Sequence[Any], order: int) -> list[Any]:
        """The coordinates with their derivatives by one of them, at enclosed roots."""
        none = [None] * (order - 1)
        found: list[Any] = [jet(x, None, *none) for x in point]
        found[place] = jet(point[place], arb(1), *none)
        _, slopes = self.slopes(point)
        square = matrix([_without(place, row) for row in slopes])
        try:
            y = square.mid().inv().mid()
        except ZeroDivisionError:
            raise Failure("the derivative along the branch is not known") from None
        for k in range(1, order + 1):
            orbit = self._with(found[-1])
            missed = part_of(matrix([[v] for v in orbit.along(found[:-1])]), k)
            step = solution(square, y, -missed)
            others = _without(place, found)
            moved = [
                Jet(x.space, tuple(d if i == k else part for i, part in enumerate(x.parts)))
                for x, d in zip(others, step, strict=True)
            ]
            found = _with(place, found[place], moved)
        return found


class CheckedTile:
    """One tile of a branch."""

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
        """Whether the branch turns at its event."""
        if self.event is None:
            return False
        return "fold" in (self.event["kind"], *(kind for kind, *_ in self.event["also"]))

    @property
    def begin(self) -> Any:
        """Where it begins along the branch."""
        return self.low if self.forwards else self.high

    @property
    def end(self) -> Any:
        """Where it ends."""
        return self.high if self.forwards else self.low

    def centre(self, value: Any) -> list[Any]:
        """The polynomials where the coordinate has a value."""
        e = (value - arb((self.low + self.high) / 2)) / arb((self.high - self.low) / 2)
        found = []
        for row in self.tile["centre"]:
            total = arb(0)
            for coefficient in reversed(row):
                total = total * e + arb(coefficient)
            found.append(total)
        return found

    def holds(self, value: Any, others: Sequence[Any]) -> bool:
        """Whether coordinates are in the tube where its own has a value."""
        sides = zip(others, self.centre(value), self.radii, strict=True)
        return all(abs(x - c) < r for x, c, r in sides)

    def at(self, value: Any) -> list[Any]:
        """All coordinates of its orbit at a value, sharply."""
        curve, place, middle = self.curve, self.place, value.mid()
        point = [x.mid() for x in self.centre(middle)]
        for _ in range(_STEPS):
            values, slopes = curve.slopes(_with(place, middle, point))
            try:
                square = matrix([_without(place, row) for row in slopes]).mid()
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
        return _with(place, value, found)

    def check_sharply(self) -> None:
        """Prove what is claimed of it; with more bits if need be, as in a narrow tube."""
        try:
            self.check()
        except Failure:
            with ctx.workprec(2 * _BITS):
                self.check()

    def check(self) -> None:
        """Prove that there is one orbit in the tube, and what is claimed of it."""
        curve, place = self.curve, self.place
        half = arb((self.high - self.low) / 2)
        value = self.space.variable(0, arb((self.low + self.high) / 2), half)
        centre = [
            TaylorModel(self.space, tuple(arb(c) for c in row)) for row in self.tile["centre"]
        ]
        image = curve.krawczyk(place, value, centre, self.radii)
        demand(image is not None, "existence is not proved: Krawczyk's test fails")
        assert image is not None
        self.point = _with(place, value, image)
        low, high = curve.interval
        if place == curve.last:
            demand(low <= self.low and self.high <= high, "it is outside of the interval")
        else:
            over = range_of(self.point[-1])
            demand(over > low and over < high, "it is outside of the interval")
        if self.tile["before"] == _OPEN:
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
        """Prove something of all of it, on smaller parts if need be."""
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
        """Enclosures of its orbits on a part, from boxes around them that are smaller there."""
        found, value = _without(self.place, point), point[self.place]
        for _ in range(2):
            centre = [x.mid() for x in found]
            away = [abs(range_of(x - c)) for x, c in zip(found, centre, strict=True)]
            radii = [(2 * d + (1 + abs(x)) * arb(2) ** -55).upper() for d, x in
                     zip(away, found, strict=True)]  # fmt: skip
            image = self.curve.krawczyk(self.place, value, centre, radii)
            if image is None:
                break
            found = image
        return _with(self.place, value, found)

    def _goes_on(self, point: Sequence[Any]) -> None:
        """The parameter changes all along it."""
        if self.place != self.curve.last:
            slope = range_of(part_of(self.curve.jets(self.place, point, 1)[-1], 1))
            demand(slope > 0 or slope < 0, "the branch may turn")

    def _judge(self, point: Sequence[Any]) -> None:
        orbit = self.curve.orbit(point)
        orbit.returns(self.curve.energies)
        admissible = admissibility(orbit, [])
        if self.tile["before"] == "not admissible":
            demand(admissible == "refuted", f"admissibility is {admissible}")
            return
        demand(admissible == "proved", f"admissibility is {admissible}")
        demand(_verdict(orbit) == self.tile["before"], f"it is {_verdict(orbit)}")


def _verdict(orbit: CheckedOrbit) -> str:
    """What an orbit is that is a motion of its system."""
    words = {"proved": orbit.declared.stability, "refuted": "unstable"}
    return words.get(stability(orbit), _OPEN)


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
        with ctx.workprec(_SHARP):
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
        """Whether the orbits are motions of the system, beside which multipliers do not matter."""
        return not (self.event["kind"] == "fold" and self.below == self.above == "not admissible")

    def _no_other(self, point: Sequence[Any]) -> None:
        """All other ways past the unit circle are closed."""
        kind, orbit = self.event["kind"], self.curve.orbit(point)
        orbit.returns(self.curve.energies)
        admissible = admissibility(orbit, [])
        demand(admissible == ("proved" if self._moves else "refuted"), "it may be no motion")
        if not self._moves:
            return
        demand_alone(orbit, kind)

    def _verdicts(self) -> None:
        """Verdicts at both ends of the tile: on each side there is one."""
        for verdict, end in ((self.below, self.tile.low), (self.above, self.tile.high)):
            if self._moves:
                with ctx.workprec(_SHARP):
                    found = _verdict(self.curve.orbit(self.tile.at(arb(end))))
                demand(found == verdict != _OPEN, f"at an end it is {found}")

    def _border(self) -> None:
        """If the borders are not crossed it is a motion; beyond the first it is none."""
        event, steps = self.event, self.curve.declared.steps
        demand(len({*self.borders}) == len(self.borders), "a border twice")
        demand(all(0 <= border.phase < len(steps) for border in self.borders), "no such phase")
        first = self.borders[0]
        demand(event["configuration"] == steps[first.phase].name, "another configuration")
        verdict = self.below if self.above == "not admissible" else self.above
        demand(verdict not in (_OPEN, "not admissible"), "no verdict beside the event")

        def but_for_it(point: Sequence[Any]) -> None:
            orbit = self.curve.orbit(point)
            orbit.returns(self.curve.energies)
            told = admissibility(orbit, [], self.borders, self.window)
            demand(told == "proved", f"but for the event admissibility is {told}")
            demand(_verdict(orbit) == verdict, f"it is {_verdict(orbit)}")

        self.tile.parts(but_for_it)
        rises = {self._passes(border, border) for border in self.borders}
        demand(len(rises) == 1, "borders are crossed in both directions")
        verdicts = [verdict, "not admissible"]
        if rises == {False}:
            verdicts.reverse()
        demand(verdicts == [self.below, self.above], "other verdicts beside the event")

    def _passes(self, which: Any, border: Border | None) -> bool:
        """Whether its number rises through zero, once; Failure if it does not pass."""
        tile = self.tile
        signs: set[bool] = set()

        def moves(point: Sequence[Any]) -> None:
            rate = range_of(self._number(which, border, point, 1)[1])
            demand(rate > 0 or rate < 0, "an event may happen twice, or be touched only")
            signs.add(bool(rate > 0))

        tile.parts(moves)
        demand(len(signs) == 1, "an event may happen twice")
        with ctx.workprec(_SHARP):
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
        """What is zero at the event, and its derivative along the branch."""
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


def _joined(tile: CheckedTile, other: CheckedTile) -> None:
    """The end of one tile and the beginning of the next are one orbit, and lead the same way."""
    curve = tile.curve
    with ctx.workprec(_SHARP):
        _same_equations(tile, other)
        if tile.place == other.place:
            demand(tile.end == other.begin and tile.forwards == other.forwards, "they are apart")
            point = tile.at(arb(tile.end))
            demand(other.holds(arb(tile.end), _without(other.place, point)), "two orbits")
            return
        try:
            _enters(tile, other, tile.at(arb(tile.end)))
        except Failure:
            _leaves(tile, other, other.at(arb(other.begin)))
            point = other.at(arb(other.begin))
        else:
            point = tile.at(arb(tile.end))
        slope = part_of(curve.jets(tile.place, point, 1)[other.place], 1)
        same = tile.forwards == other.forwards
        demand(slope > 0 if same else slope < 0, "they do not lead the same way")


def _same_equations(tile: CheckedTile, other: CheckedTile) -> None:
    """Where two tiles divide other conditions none is divided by zero at their joint."""
    if tile.tile["divided"] == other.tile["divided"]:
        return
    names = tile.curve.declared.dwell
    first = tile.curve.last - len(names)
    for own, point in ((tile, tile.at(arb(tile.end))), (other, other.at(arb(other.begin)))):
        for divided in (tile.curve.short, other.curve.short):
            if divided is not None:
                time = point[first + divided.place]
                demand(time > 0 or time < 0, f"{own.tile['coordinate']}: a phase vanishes there")


def _enters(tile: CheckedTile, other: CheckedTile, point: Sequence[Any]) -> None:
    """The end of a tile lies in the next one, and in front of its event."""
    value = point[other.place]
    demand(value > other.low and value < other.high, "they are apart")
    demand(other.holds(value, _without(other.place, point)), "two orbits")
    if other.event is not None:
        bounds = exact(other.event["lower"]), exact(other.event["upper"])
        demand(value < bounds[0] if other.forwards else value > bounds[1], "an event is left out")


def _leaves(tile: CheckedTile, other: CheckedTile, point: Sequence[Any]) -> None:
    """The beginning of a tile lies in the one before it, and behind its event."""
    value = point[tile.place]
    demand(value > tile.low and value < tile.high, "they are apart")
    demand(tile.holds(value, _without(tile.place, point)), "two orbits")
    if tile.event is not None:
        bounds = exact(tile.event["lower"]), exact(tile.event["upper"])
        demand(value > bounds[1] if tile.forwards else value < bounds[0], "an event is left out")


def _ends(tiles: Sequence[CheckedTile], content: dict[str, Any]) -> None:
    """Where it is said to reach an end of the interval it does."""
    curve = tiles[0].curve
    reached = (tiles[0].begin, tiles[0].place), (tiles[-1].end, tiles[-1].place)
    outside = (tiles[0], tiles[0].tile["before"]), (tiles[-1], tiles[-1].tile["after"])
    for why, (value, place), (tile, verdict) in zip(content["ends"], reached, outside, strict=True):
        if why == _VANISHED:
            vanishes = tile.event is not None and tile.event["kind"] == "vanishing-phase"
            demand(vanishes and verdict == "not admissible", "no phase vanishes at its end")
            demand(tile.turns, "it goes on where a phase vanishes at its end")
        if why == _FINISHED:
            there = place == curve.last and value in curve.interval
            demand(there, "it does not reach the end of the interval")


def solution(square: Any, y: Any, right: Any) -> list[Any]:
    """Enclosures of the solution of a linear system, from about the inverse.

    Parameters
    ----------
    square : matrix (n, n)
        Of balls or Taylor models.
    y : matrix (n, n)
        About its inverse, exact.
    right : matrix (n, 1)

    Returns
    -------
    list of arb or TaylorModel
        They hold for all values of the variables.

    Raises
    ------
    Failure
        If the matrix may be singular.
    """
    size = square.nrows()
    unit = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
    guess = (y * right).mid()
    missed, rest = range_of(y * (right - square * guess)), range_of(unit - y * square)
    scales = [abs(range_of(x)).upper() for x in guess.entries()]
    least = max(scales, key=float) / 64 + arb(2) ** -40
    scales = [(s + least).upper() for s in scales]
    sums = [
        sum((abs(rest[i, j]) * scales[j] for j in range(size)), arb(0)) / scales[i]
        for i in range(size)
    ]
    norm = _largest(sums)
    demand(norm < 1, "the derivative along the branch is not known")
    errors = [abs(missed[i, 0]) / scales[i] for i in range(size)]
    worst = _largest(errors) / (1 - norm)
    pairs = zip(guess.entries(), scales, strict=True)
    return [x + arb(0, (s * worst).upper()) for x, s in pairs]


def _largest(numbers: Sequence[Any]) -> Any:
    """A bound of all numbers; no number if one of them is none."""
    found = numbers[0]
    for number in numbers[1:]:
        found = found.max(number)
    return found.upper()


def _with(place: int, value: Any, others: Sequence[Any]) -> list[Any]:
    return [*others[:place], value, *others[place:]]


def _without(place: int, point: Sequence[Any]) -> list[Any]:
    return [*point[:place], *point[place + 1 :]]
