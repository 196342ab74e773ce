"""The check of a branch: tiles that follow each other, each with one verdict or one event.

A tile states polynomials and radii: a tube in which, for each value of its coordinate, there is
exactly one root of the orbit's equations (Krawczyk, 1969). At an event a number that the event
makes zero has a derivative along the branch that is nowhere zero in the tile, by jets in Taylor
models, and opposite signs at two near points. What is stated of a tile is what is found here. Where
two tiles meet one orbit lies in both tubes.
"""

from collections.abc import Callable
from copy import copy
from itertools import pairwise
from typing import Any, NamedTuple

from flint import arb, ctx

from nonsmooth.runtime.checker.orbits.motion import (
    Border,
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
    judged_stability,
    outside_if_reached,
    paired,
)
from nonsmooth.runtime.checker.ranges.branch_curve import (
    CheckedCurve,
    Family,
    middle_and_half,
    prove_on_parts,
    with_entry,
    without_entry,
)
from nonsmooth.runtime.checker.ranges.divided import curve_at
from nonsmooth.runtime.checker.stated.exact import (
    Entries,
    Failure,
    Numbers,
    demand,
    demand_sign,
    exact,
    inside,
    naming,
)
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of

BITS, SHARP = 64, 192  # of tiles, and of points
ORDER = 5  # of the models and polynomials: what costs least, measured
OPEN, NO_MOTION = "undecided", "not admissible"
_DEEPEST = 5  # halvings of a tile whose claims take smaller ones
_SHARPENINGS = 8  # of the enclosures on a part, at most


class TileClaims(NamedTuple):
    """What is proved of the orbits of a tile."""

    before: str  # the verdict on them up to the event, if there is one
    after: str  # behind it
    enclosures: dict[str, Any]  # all coordinates at the event, by name; empty without one


def stated_tube(told: Entries, size: int) -> tuple[list[TaylorModel], list[Any]]:
    """Return polynomials and radii of a tube in so many coordinates, as a file states them."""
    rows, radii, space = told["centre"], [*map(arb, told["radii"])], space_of(1, ORDER)
    demand(len(radii) == len(rows) == size, "a tube of another size")
    demand(all(r > 0 and r.is_finite() for r in radii), "the tube is empty")
    demand(all(len(row) == ORDER + 1 for row in rows), "polynomials of another order")
    return [TaylorModel(space, tuple(map(arb, row))) for row in rows], radii


class CheckedTile:
    """One tile of a branch: a tube of orbits along one coordinate, with a verdict or an event."""

    deepest = _DEEPEST  # how often it is halved at most

    def __init__(self, curve: CheckedCurve, tile: Entries) -> None:
        self.curve, self.tile = curve.divided(tile["divided"]), tile
        self.place = curve.place(tile["coordinate"])
        self.low, self.high = exact(tile["lower"]), exact(tile["upper"])
        demand(self.low < self.high, "it is empty")
        self.forwards = tile["forwards"]
        self.tube, self.radii = stated_tube(tile, curve.last)
        self.event = tile["event"]
        self._ends: dict[Any, list[Any]] = {}

    def stating(self, **claims: Any) -> "CheckedTile":
        """Return the same tile with other claims; what is proved of its tube is kept."""
        found = copy(self)
        found.tile = {**self.tile, **claims}
        found.event = found.tile["event"]
        return found

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
        middle, half = middle_and_half(self.low, self.high)
        return [curve_at(row, (value - middle) / half) for row in self.tile["centre"]]

    def holds(self, value: Any, others: Numbers) -> bool:
        """Return whether the other coordinates lie in the tube at a value of the tile's."""
        sides = zip(others, self.centre(value), self.radii, strict=True)
        return all(abs(x - c) < r for x, c, r in sides)

    def at(self, value: Any) -> list[Any]:
        """Return sharp enclosures of all coordinates of the tile's orbit at a value."""
        found = self.curve.located(self.place, value, self.centre(value.mid()))
        demand(self.holds(value, without_entry(self.place, found)), "an orbit is not in its tube")
        return found

    @property
    def event_ends(self) -> tuple[Any, Any]:
        """Values of the tile's coordinate between which its event is."""
        return exact(self.event["lower"]), exact(self.event["upper"])

    def at_event(self) -> list[Any]:
        """Return sharp enclosures of all coordinates where the tile's event may be."""
        middle, half = middle_and_half(*self.event_ends)
        return self.at(middle + arb(0, half))

    def at_end(self, end: Any) -> list[Any]:
        """Return sharp enclosures of all coordinates at one end of the tile."""
        if end not in self._ends:
            with ctx.workprec(SHARP):
                self._ends[end] = self.at(arb(end))
        return self._ends[end]

    def check_sharply(self) -> None:
        """Prove the claims about the tile; retry with twice the bits, as a narrow tube may need."""
        try:
            self.check()
        except Failure:
            with ctx.workprec(2 * BITS):
                self.check()

    def check(self) -> None:
        """Prove that the tube holds one orbit for each value, and the claims about these orbits."""
        self.locate()
        if self.tile["before"] == OPEN:
            return
        found = self.claims()
        verdicts = self.tile["before"], self.tile["after"]
        told = f"other verdicts: up to its event it is {found.before}, behind it is {found.after}"
        demand(verdicts == found[:2], told)
        if self.event is not None:
            stated = self.event["enclosures"]
            demand(stated.keys() == found.enclosures.keys(), "not every unknown is enclosed")
            with ctx.workprec(SHARP):
                for name, ball in stated.items():
                    demand(inside(found.enclosures[name], ball), f"{name} is not in its enclosure")

    def locate(self) -> None:
        """Prove that the tube holds one orbit for each value, inside of the interval."""
        value = space_of(1, ORDER).variable(0, *middle_and_half(self.low, self.high))
        image = self.curve.krawczyk(self.place, value, self.tube, self.radii)
        self.point = with_entry(self.place, value, image)
        low, high = self.curve.interval
        if self.place == self.curve.last:
            demand(low <= self.low and self.high <= high, "it is outside of the interval")
        else:
            over = range_of(self.point[-1])
            demand(over > low and over < high, "it is outside of the interval")

    def claims(self) -> TileClaims:
        """Return the one verdict on the tile's orbits, or the verdicts beside the event it states.

        `Failure` is raised if they are not proved, or if there may be another event. The orbits
        are located.
        """
        if not self.turns:
            self.parts(self.goes_on)
        if self.event is not None:
            return _CheckedEvent(self).claims()
        verdicts: set[str] = set()
        self.parts(lambda point: verdicts.add(self._judge(point)))
        demand(len(verdicts) == 1, "the verdict changes without an event")
        (verdict,) = verdicts
        return TileClaims(verdict, verdict, {})

    def parts(self, prove: Callable[[Numbers], None]) -> None:
        """Call `prove` on the whole tile or, where that fails, on its halves again and again."""
        prove_on_parts(prove, self.point, self.deepest, self._sharper)

    def rises(self, rate: Callable[[Numbers], Any], otherwise: str) -> bool:
        """Return whether a rate at the tile's orbits is positive; `Failure` if it may be zero."""
        signs: set[bool] = set()

        def moves(point: Numbers) -> None:
            over = range_of(rate(point))
            demand_sign(over, otherwise)
            signs.add(bool(over > 0))

        self.parts(moves)
        demand(len(signs) == 1, otherwise)
        return signs == {True}

    def _sharper(self, point: Numbers) -> list[Any]:
        """Return narrower enclosures of the orbits on a part, by repeated Krawczyk steps."""
        found, value = without_entry(self.place, point), point[self.place]
        widths = list(map(_width, found))
        for _ in range(_SHARPENINGS):
            image = self.curve.image(self.place, value, [x.mid() for x in found], widths)[0]
            if image is None:
                break
            found = [min(pair, key=_width) for pair in zip(found, image, strict=True)]
            before, widths = widths, list(map(_width, found))
            if not any(2 * now < was for now, was in zip(widths, before, strict=True)):
                break
        return with_entry(self.place, value, found)

    def goes_on(self, point: Numbers) -> None:
        """Demand that the parameter is strictly monotone along a part of the tile."""
        if self.place != self.curve.last:
            slope = range_of(part_of(self.curve.jets(self.place, point, 1)[-1], 1))
            demand_sign(slope, "the branch may turn")

    def _judge(self, point: Numbers) -> str:
        """Return the verdict on the orbits of a part."""
        orbit = self.curve.closed(point)
        admissible = admissibility(orbit)
        if admissible.claim == "refuted":
            return NO_MOTION
        demand(admissible.claim == "proved", f"admissibility is undecided: {admissible.reason}")
        return _verdict(orbit)

    def number(
        self, which: Border | str, point: Numbers, order: int, window: Any = None
    ) -> tuple[Any, Any]:
        """Return the number that is zero at an event, and its derivative along the branch.

        The event is a border, whose `window` a grazing needs, or the kind of one of the
        multipliers'. The derivative is None for `order` 0.
        """
        curve, place = self.curve, self.place
        if which == "fold":
            slope = curve.jets(place, point, 1 + order)[-1]
            return part_of(slope, 1), 2 * part_of(slope, 2) if order else None
        orbit = curve.orbit(curve.jets(place, point, 1) if order else point)
        found = event_number(which, orbit, lambda: curve.orbit(point), window)
        return part_of(found, 0), part_of(found, 1) if order else None


def _verdict(orbit: CheckedOrbit) -> str:
    """Return the verdict on an admissible orbit, its kind of stability or "unstable".

    `Failure` is raised with the reason if it is undecided.
    """
    found = judged_stability(orbit)
    demand(found.claim != OPEN, found.reason)
    return orbit.declared.stability if found.claim == "proved" else "unstable"


class _CheckedEvent:
    """The event of a tile."""

    def __init__(self, tile: CheckedTile) -> None:
        self.tile, self.curve, self.event = tile, tile.curve, tile.event
        self.borders, self.window = borders_of(self.event)
        self.low, self.high = tile.event_ends

    def claims(self) -> TileClaims:
        """Prove that there is this event in the tile, and no other."""
        tile, event = self.tile, self.event
        demand(tile.low < self.low < self.high < tile.high, "its event is outside")
        if event["kind"] in MULTIPLIERS:
            demand_no_phase(event)
            below, above = self._multiplier(event["kind"])
        else:
            beside = [entry for entry in event["also"] if entry[0] in MULTIPLIERS]
            if beside:  # the branch turns where a phase vanishes, and no multiplier is 1
                short = self.curve.short
                gone = short is not None and short.place == event["phase"] - 1
                vanishes = gone and event["kind"] == "vanishing-phase"
                turns = [["fold", event["phase"], "", ""]]
                demand(vanishes and [*map(list, beside)] == turns, "a multiplier beside a border")
                self._passes("fold")
            below, above = self._border()
        enclosures: dict[str, Any] = {}
        with ctx.workprec(SHARP):
            found = tile.at_event()
            for name, x in zip(self.curve.names, found, strict=True):
                enclosures[name] = x.union(enclosures.get(name, x))  # two may have one name
            if event["kind"] == "neimark-sacker":
                polynomial = characteristic(self.curve.orbit(found).section)
                demand(paired(polynomial), "it may be a neutral saddle, where two are real")
        verdicts = (below, above) if tile.forwards else (above, below)
        return TileClaims(*verdicts, enclosures)

    def _multiplier(self, kind: str) -> tuple[str, str]:
        """Return the verdicts below and above an event of the multipliers.

        For orbits that are no motions these do not matter, and only folds are events.
        """
        claims: set[str] = set()

        def no_other(point: Numbers) -> None:
            orbit = self.curve.closed(point)
            claim = admissibility(orbit).claim
            demand(claim == "proved" or (claim, kind) == ("refuted", "fold"), "it may be no motion")
            if claim == "proved":
                demand_alone(orbit, kind)
            claims.add(claim)

        self.tile.parts(no_other)
        demand(len(claims) == 1, "it may be no motion")
        self._passes(kind)
        if claims == {"refuted"}:
            return NO_MOTION, NO_MOTION
        with ctx.workprec(SHARP):  # on each side of the event there is only one
            below, above = (
                _verdict(self.curve.orbit(self.tile.at_end(end)))
                for end in (self.tile.low, self.tile.high)
            )
        return below, above

    def _border(self) -> tuple[str, str]:
        """Return the verdicts below and above the first border that is crossed.

        Where no border is crossed there are motions, with one verdict, and none beyond the first.
        """
        event, steps = self.event, self.curve.declared.steps
        demand(len({*self.borders}) == len(self.borders), "a border twice")
        demand(all(0 <= border.phase < len(steps) for border in self.borders), "no such phase")
        first = self.borders[0]
        demand(event["configuration"] == steps[first.phase].name, "another configuration")
        verdicts: set[str] = set()

        def but_for_it(point: Numbers) -> None:
            orbit = self.curve.closed(point)
            told = admissibility(orbit, self.borders, self.window).claim
            demand(told == "proved", f"but for the event admissibility is {told}")
            verdicts.add(self._verdict_beside(orbit))

        self.tile.parts(but_for_it)
        demand(len(verdicts) == 1, "the verdict changes without an event")
        (verdict,) = verdicts
        rises = {self._passes(border) for border in self.borders}
        demand(len(rises) == 1, "borders are crossed in both directions")
        return (verdict, NO_MOTION) if rises == {True} else (NO_MOTION, verdict)

    def _verdict_beside(self, orbit: CheckedOrbit) -> str:
        """Return the verdict on an orbit on the side where no border is crossed."""
        slow = [b.phase for b in self.borders if (b.kind, b.instant) == ("tangent", "end")]
        if len(slow) == 1 and outside_if_reached(orbit, slow[0]):
            return "unstable"
        return _verdict(orbit)

    def _passes(self, which: Border | str) -> bool:
        """Return whether the event's number rises through zero, once; `Failure` if it may not."""
        tile = self.tile
        rises = tile.rises(
            lambda point: tile.number(which, point, 1, self.window)[1],
            "an event may happen twice, or be touched only",
        )
        with ctx.workprec(SHARP):
            low, high = (
                tile.number(which, tile.at(arb(end)), 0, self.window)[0]
                for end in (self.low, self.high)
            )
        opposite = (low < 0 < high) if rises else (high < 0 < low)
        demand(opposite, "there may be no event between its bounds")
        return rises


def _width(number: Any) -> Any:
    """Return a bound of how far the enclosed function may be from the model's polynomial."""
    return abs(range_of(number - number.mid())).upper()


FINISHED, VANISHED = "end of the interval", "a phase vanishes"


def checked_tiles(content: Entries) -> list[CheckedTile]:
    """Prove every claim of a branch whose entries have their shape; return its tiles."""
    tiles = content["tiles"]
    _claimed(content)
    if not tiles:
        return []
    curve = curve_of(content)
    with ctx.workprec(BITS):
        found = [CheckedTile(curve, tile) for tile in tiles]
        reached = ending(found[0], last=False), ending(found[-1], last=True)
        for why, proved in zip(content["ends"], reached, strict=True):
            demand(why == proved or why not in (FINISHED, VANISHED), f"it goes on: not {why!r}")
        for number, tile in enumerate(found, 1):
            with naming(f"in tile {number} of the branch"):
                tile.check_sharply()
        for number, (tile, other) in enumerate(pairwise(found), 1):
            with naming(f"tiles {number} and {number + 1}"):
                check_joint(tile, other)
        curve.check_divisors()
    return found


def curve_of(content: Entries) -> CheckedCurve:
    """Return the equations of a branch, of which nothing is proved yet.

    `Failure` is raised if the declaration is not exact, or if the unknowns or the kind of
    stability are not those of the declaration.
    """
    demand(content["declaration"], "claims about no declaration")
    with ctx.workprec(BITS):
        name = content["parameter"]
        declared, energies, constants, _ = Family.stated(content, [name])
        demand(content["unknown_names"] == declared.unknowns, "other unknowns")
        interval = [exact(end) for end in content["interval"]]
        return CheckedCurve(declared, energies, constants, name, interval)


def _claimed(content: Entries) -> None:
    """Demand that the claim about the whole branch follows from its tiles."""
    tiles = content["tiles"]
    demand(0 <= content["start"] <= len(tiles), "it starts in none of its tiles")
    low, high = map(exact, content["interval"])
    demand(low < high, "the interval is empty")
    every = all(OPEN not in (tile["before"], tile["after"]) for tile in tiles)
    whole = bool(tiles) and every and {*content["ends"]} <= {FINISHED, VANISHED}
    demand((content["claims"]["branch"] == "proved") == whole, "the claim is not that of the tiles")
    for tile in tiles:
        left = tile["before"] == OPEN
        demand(left == bool(tile["reason"]), "reasons of other tiles")
        demand(left == (tile["after"] == OPEN), "a tile that is half decided")
        demand(tile["event"] is None or not left, "an event of an undecided tile")
        same = tile["before"] == tile["after"]
        demand(same or tile["event"], "the verdict changes without an event")


def check_joint(tile: CheckedTile, other: CheckedTile) -> None:
    """Prove that one tile ends with the orbit with which the next begins, and leads its way.

    The two tiles are in the order of the branch.
    """
    curve = tile.curve
    with ctx.workprec(SHARP):
        _same_equations(tile, other)
        if tile.place == other.place:
            demand(tile.end == other.begin and tile.forwards == other.forwards, "they are apart")
            point = tile.at_end(tile.end)
            demand(other.holds(arb(tile.end), without_entry(other.place, point)), "two orbits")
            return
        try:
            point = tile.at_end(tile.end)
            _meets(other, point, entering=True)
        except Failure:
            point = other.at_end(other.begin)
            _meets(tile, point, entering=False)
        slope = part_of(curve.jets(tile.place, point, 1)[other.place], 1)
        same = tile.forwards == other.forwards
        demand(slope > 0 if same else slope < 0, "they do not lead the same way")


def _same_equations(tile: CheckedTile, other: CheckedTile) -> None:
    """Demand that no dwell time divided by is zero at a joint of tiles with other divisions."""
    if tile.tile["divided"] == other.tile["divided"]:
        return
    names = tile.curve.declared.dwell
    first = tile.curve.last - len(names)
    for own, point in ((tile, tile.at_end(tile.end)), (other, other.at_end(other.begin))):
        for divided in (tile.curve.short, other.curve.short):
            if divided is not None:
                time = point[first + divided.place]
                demand_sign(time, f"{own.tile['coordinate']}: a phase vanishes there")


def _meets(tile: CheckedTile, point: Numbers, *, entering: bool) -> None:
    """Demand that an orbit lies in a tile: before its event if `entering`, else behind it."""
    value = point[tile.place]
    demand(value > tile.low and value < tile.high, "they are apart")
    demand(tile.holds(value, without_entry(tile.place, point)), "two orbits")
    if tile.event is not None:
        low, high = tile.event_ends
        below = entering == tile.forwards
        demand(value < low if below else value > high, "an event is left out")


def ending(tile: CheckedTile, *, last: bool) -> str:
    """Return how a branch is proved to end with its last tile, or to begin with its first one.

    It is at an end of the interval, or turns where a phase vanishes and no motions are beyond;
    "" is returned where it goes on. What the tile states is proved elsewhere.
    """
    reached, beyond = (tile.end, "after") if last else (tile.begin, "before")
    if tile.place == tile.curve.last and reached in tile.curve.interval:
        return FINISHED
    vanishes = tile.turns and tile.event["kind"] == "vanishing-phase"
    return VANISHED if vanishes and tile.tile[beyond] == NO_MOTION else ""
