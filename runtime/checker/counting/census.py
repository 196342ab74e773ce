"""The judge of a census: how many orbits an itinerary has in a box of dwell times, and its file.

All boxes of a tree are proved to hold no orbit, or exactly one, or are left open; they cover all
that is searched. An orbit's own certificate is proved as any other, and that it is that orbit.
"""

import math
import re
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from flint import arb, ctx

from nonsmooth.runtime.checker.counting.contraction import Sides, floats_around, inside, touching
from nonsmooth.runtime.checker.counting.covering import Root, Walk
from nonsmooth.runtime.checker.counting.dwell_equations import DwellEquations, Given, Setting
from nonsmooth.runtime.checker.orbits.points import check_stated
from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import Entries, ball, demand, exact, naming
from nonsmooth.runtime.checker.stated.parameters import independent, number_at, number_in, values_of
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file
from nonsmooth.runtime.core.rational_functions import RationalFunction

_BITS = 64  # doubles cut the boxes
_SIDE = re.compile(r"(?P<low>.+?) (?P<strict><=?) (?P<name>\w+)(?: <= (?P<high>.+))?")
_MOST_TURNS = 1000
_WINDOW = -0.0618  # of a forcing's period: where its times begin, away from where it is even
_LITTLE = 1e-12
_TURN = "forcing-phase"  # in place of a boundary
# of a census, and of the certificates of its orbits
_SHARED = ("system", "orbit", "itinerary", "bits", "parameters", "given_period", "declaration")


class Side(NamedTuple):
    """Bounds of one dwell time, as a text states them.

    They belong to the box, but a lower bound 0 does not: dwell times are positive.
    """

    name: str
    low: Any
    high: Any  # None: not bounded

    @staticmethod
    def stated(text: str) -> "Side":
        """Return the bounds that a text states as inequalities, at the working precision."""
        told = _SIDE.fullmatch(text)
        demand(told, f"{text[:60]!r} bounds no dwell time")
        assert told is not None
        low = number_in(told["low"])
        high = None if told["high"] is None else number_in(told["high"])
        demand((low == 0) == (told["strict"] == "<") and low >= 0, f"{text[:60]!r} is no bound")
        demand(high is None or low < high, f"{text[:60]!r}: the bounds are not in order")
        return Side(told["name"], low, high)

    @property
    def floats(self) -> tuple[float, float]:
        """Doubles around the bounds."""
        high = math.inf if self.high is None else _around(self.high)[1]
        return max(0.0, _around(self.low)[0]), high

    def holds(self, time: Any) -> bool | None:
        """Return whether a dwell time is inside; None if its ball has points on both sides."""
        low, high = arb(self.low), None if self.high is None else arb(self.high)
        if time <= 0 or time < low or (high is not None and time > high):
            return False
        return True if time > 0 and time >= low and (high is None or time <= high) else None


class CensusVerdict(NamedTuple):
    """What a covering proves of a box: its orbits, and the boxes of which nothing is known."""

    inside: list[tuple[DwellEquations, Root]]  # by their first dwell times
    left: list[tuple[DwellEquations, Sides]]  # boxes that were left open
    edges: list[tuple[DwellEquations, Root, str]]  # may be orbits of the box, and why


_EDGE = "a solution may lie on the edge of what is asked for"
_TWICE = "the orbit may be one of those that are counted, begun later"


class Counting:
    """The question how many orbits an itinerary has in a box, at one parameter point.

    `asked` has the entries of a census that state system, itinerary, parameters, given period,
    the box and the largest size of a coordinate; nothing else of it is read. `Failure` is raised if
    they do not go together.
    """

    def __init__(self, asked: Entries) -> None:
        self.asked = asked
        period = {"period": asked["given_period"]} if asked["given_period"] else {}
        demand(not period.keys() & asked["parameters"].keys(), "two periods are given")
        with ctx.workprec(_BITS):
            told = asked["declaration"].get("constants", [])
            parameters = {**asked["parameters"], **period}
            values, stated, constants = values_of(parameters, (), told)
            closing: Entries = {"kind": "forcing", "turns": 1}
            if not asked["declaration"]["forcing"]:
                closing = {"kind": "state"}
            demand(closing["kind"] == "state" or not period, "a period beside a forcing's")
            content = {**asked, "closing": closing}
            self.declared = declared = StatedSystem(content, values, stated)
            for phase in asked["declaration"]["phases"]:
                demand(len(phase["boundaries"]) == 1, "several boundaries end a phase at once")
                demand(phase["boundaries"] != [_TURN], "a phase ends with the forcing's period")
            if declared.forcing:
                closing["turns"] = _common_turns(declared)
                declared.closes()
            self.setting = Setting(declared, timed=bool(period or declared.forcing))
            independent(declared, constants)
            number = number_at(constants)
            demand(all(number(x).is_finite() for x in declared.poles), "a number has a pole")
            self.follow = [declared.dwell[k] for k in self.setting.still]
            self.period = number(values["period"]) if period else None
            self.number, self.turns = number, closing.get("turns", 0)

    def within(self, box: Sequence[str]) -> "CountedBox":
        """Return the question in a box, whose sides are stated as inequalities."""
        with ctx.workprec(_BITS):
            return CountedBox(self, [Side.stated(text) for text in box])

    @property
    def conditions(self) -> list[str]:
        """What orbits are asked for beside their dwell times, in words."""
        declared, found = self.declared, []
        if self.setting.places:
            states = self.asked["declaration"]["states"]
            sizes = ", ".join(f"|{states[k]}|" for k in self.setting.places)
            phase = declared.steps[self.setting.rotation].name
            found.append(f"{sizes} <= {self.asked['largest']} at the start of {phase}")
        if self.asked["given_period"]:
            found.append(f"the period is {self.asked['given_period']}")
        if self.part < len(declared.steps):
            found.append("without those that repeat themselves earlier")
        return found

    @property
    def part(self) -> int:
        """Number of phases after which the itinerary repeats itself: all of them, as a rule."""
        ways = ("configuration", "boundaries", "transition")
        phases = [[phase[name] for name in ways] for phase in self.asked["declaration"]["phases"]]
        return next(k for k in range(1, len(phases) + 1) if phases == phases[k:] + phases[:k])


class CountedBox:
    """The equations whose roots are the orbits in a box, and what their coverings prove.

    There is one system of equations for each number of turns of the forcing that fits into the box.
    """

    def __init__(self, counting: Counting, sides: Sequence[Side]) -> None:
        self.counting, self.sides, self.setting = counting, sides, counting.setting
        declared = counting.declared
        bounds = {side.name: side.floats for side in sides}
        named = len(bounds) == len(sides) and bounds.keys() == {*declared.dwell}
        demand(named, "the box has not one side for each dwell time")
        self.largest = arb(exact(counting.asked["largest"]))
        demand(self.largest > 0, "the largest size of a coordinate is not positive")
        searched = [declared.dwell[k] for k in self.setting.searched]
        demand(all(bounds[name][1] < math.inf for name in searched), "a side has no upper bound")
        given = Given(period=counting.period), ()
        closings: list[Any] = [given] if self.setting.possible else []
        if self.setting.possible and declared.forcing:
            closings = list(self._forced([bounds[name] for name in searched]))
        self.equations = [
            DwellEquations(
                declared, self.setting, counting.number, given, bounds, window, self.largest
            )
            for given, window in closings
        ]

    def _forced(self, bounds: Sequence[tuple[float, float]]) -> Iterator[Any]:
        """Yield what is given for each whole number of the forcings' common period in the box."""
        declared, number = self.counting.declared, self.counting.number
        field = declared.steps[0].field
        speeds = [number(field[s][c]) for c, s in declared.forcing]
        demand(all(speed > 0 or speed < 0 for speed in speeds), "a forcing does not turn")
        unit = 2 * arb.pi() * self.counting.turns / abs(speeds[0])
        first = float(unit.upper())
        window = (_WINDOW * first, (1 + _WINDOW) * first * (1 + _LITTLE))
        least, most = (sum(bound[k] for bound in bounds) for k in (0, 1))
        demand(most < _MOST_TURNS * first, f"the box holds more than {_MOST_TURNS} forcing periods")
        for turns in range(1, _MOST_TURNS + 1):
            period = unit * turns
            if period > most * (1 + _LITTLE):
                break
            if not period < least * (1 - _LITTLE):
                yield Given(declared.forcing, speeds, period, unit), (window,)

    def judged(self, walks: Sequence[Walk]) -> CensusVerdict:
        """Return what coverings of all equations prove: which roots are orbits in the box."""
        found: list[tuple[DwellEquations, Root, dict[str, Any]]] = []
        edges: list[tuple[DwellEquations, Root, str]] = []
        with ctx.workprec(_BITS):
            for walk in walks:
                for root in walk.roots:
                    dwell = walk.equations.dwell(root.sides, root.coordinates)
                    asks = [self._small(walk.equations, root)]
                    asks += [side.holds(dwell[side.name]) for side in self.sides]
                    if False in asks:
                        continue
                    if None in asks:
                        edges.append((walk.equations, root, _EDGE))
                    elif (again := self._again(walk.equations, root, found)) is None:
                        edges.append((walk.equations, root, _TWICE))
                    elif not again:
                        found.append((walk.equations, root, dwell))
        first = self.sides[0].name
        found.sort(key=lambda each: float(each[2][first].mid()))
        left = [(walk.equations, sides) for walk in walks for sides in walk.undecided]
        return CensusVerdict([each[:2] for each in found], left, edges)

    def _small(self, equations: DwellEquations, root: Root) -> bool | None:
        """Return whether no coordinate is too large, and a forcing's time in its period.

        None if that is undecided.
        """
        sizes = [abs(q) for q in root.coordinates]
        if any(size > self.largest for size in sizes):
            return False
        certain = all(size <= self.largest for size in sizes)
        if equations.first:
            (begin, _), *_ = equations.domain
            (low, high), *_ = root.sides
            end = begin + equations.given.unit
            if high < begin or arb(low) > end:
                return False
            certain = certain and low >= begin and arb(high) < end
        return True if certain else None

    def _again(
        self, equations: DwellEquations, root: Root, counted: Sequence[tuple[Any, Root, Any]]
    ) -> bool | None:
        """Return whether an orbit is counted already, begun at another phase; None if undecided.

        The same is asked of an orbit that repeats itself before its itinerary ends.
        """
        others = [root, *(other for its, other, _ in counted if its is equations)]
        verdicts = [self._begun(equations, root, other) for other in others]
        return True if True in verdicts else None if None in verdicts else False

    def _begun(self, equations: DwellEquations, root: Root, other: Root) -> bool | None:
        """Return whether a root is another one, or itself, begun some parts later."""
        undecided, part = False, self.counting.part
        count = len(self.counting.declared.steps)
        for phases in range(part, count, part):
            # only among roots that are not too large the other one is unique
            begun = (self.setting.rotation + phases) % count
            state = equations.starts(root.sides, root.coordinates)[begun]
            small = all(abs(state[k, 0]) <= self.largest for k in self.setting.places)
            for sides in equations.begun_later(root.sides, phases):
                if small and inside(sides, other.unique):
                    return True
                undecided = undecided or touching(sides, other.sides)
        return None if undecided else False

    def check_orbit(self, told: Entries, equations: DwellEquations, root: Root) -> None:
        """Demand that a certificate, if it holds, is of the orbit that a root is.

        Its orbit has the dwell times of the box in which the root is alone, no coordinate that is
        too large, and the root's time of the forcing.
        """
        demand(told["claims"]["existence"] == "proved", "it is not proved to exist")
        for name in _SHARED:
            demand(told[name] == self.counting.asked[name], f"{name}: it is of something else")
        with ctx.workprec(_BITS):
            own = {name: ball(each) for name, each in told["enclosures"].items()}
            for name, bounds in zip(equations.names, root.unique, strict=True):
                inside = name not in own or _within(own[name], *bounds)
                demand(inside, f"{name} is not where it was counted")
            for side in self.sides:
                demand(side.holds(own[side.name]), f"{side.name} is not in the box")
            if (unit := equations.given.unit) is not None:
                missed = abs(own["period"] - equations.given.period)
                demand(missed < unit / 2, "the forcing turns another number of times")
            declared = self.counting.declared
            state = equations.carried([own[name] for name in declared.start], own)
            small = all(abs(state[k]) <= self.largest for k in self.setting.places)
            demand(small, "a coordinate is too large")
            if equations.first:
                time = next(ball(x) for x in told["box"] if x["name"] == "forcing time")
                time += sum((own[n] for n in declared.dwell[: self.setting.rotation]), arb(0))
                near = any(_within(t, *root.unique[0]) for t in equations.turned(time))
                demand(near, "it is at another time of the forcing")


def check_census(content: Entries) -> None:
    """Prove a census: that its tree covers the box, and what is in it; and each certificate.

    `Failure` names a claim that is not proved; `Malformed` is raised if the file, read as JSON, has
    another shape.
    """
    check_file(content, "nonsmooth census")
    check_bits(content)
    counting = Counting(content)
    counted = counting.within(content["box"])
    demand(content["conditions"] == counting.conditions, "other orbits are asked for")
    demand(len(content["trees"]) == len(counted.equations), "there are too many trees, or too few")
    walks = []
    with ctx.workprec(_BITS):
        for equations, tree in zip(counted.equations, content["trees"], strict=True):
            letters = iter(tree)
            walks.append(walk := Walk(equations))
            walk.follow(lambda _: next(letters, ""))  # noqa: B023 - it is followed at once
            demand(next(letters, "") == "", "the tree has boxes beside the box")
    _check_listed(content, counted, counted.judged(walks))
    for number, orbit in enumerate(content["orbits"], 1):
        if orbit["certificate"] is not None:
            with naming(f"orbit {number}"):
                check_stated(orbit["certificate"])


def texts_of(equations: DwellEquations, sides: Sides) -> dict[str, list[str]]:
    """Return the sides of a box of unknowns by their names, as texts that state them exactly."""
    pairs = zip(equations.names, sides, strict=True)
    return {name: [repr(low), repr(high)] for name, (low, high) in pairs}


def _check_listed(content: Entries, counted: CountedBox, found: CensusVerdict) -> None:
    """Demand that orbits and open boxes are those that are found, and certificates of these."""
    listed = iter(enumerate(content["orbits"], 1))
    number, orbit = next(listed, (0, None))
    left = [texts_of(*each) for each in found.left]
    left += [texts_of(equations, root.sides) for equations, root, _ in found.edges]
    for equations, root in found.inside:
        if orbit is None or orbit["unique"] != texts_of(equations, root.unique):
            # of more equations than unknowns there is one root at most
            demand(equations.surplus, "an orbit of the box is not listed")
            left.append(texts_of(equations, root.sides))
            continue
        told = orbit["certificate"]
        demand(bool(orbit["reason"]) == (told is None), "a reason for another orbit")
        with naming(f"orbit {number}"):
            demand(told is not None or not equations.surplus, "it is not proved to exist")
            if told is not None:
                counted.check_orbit(told, equations, root)
        number, orbit = next(listed, (0, None))
    demand(orbit is None, "an orbit that is listed is not found")
    demand([box["bounds"] for box in content["undecided"]] == left, "other boxes are undecided")
    demand(content["count"] == len(content["orbits"]), "the count is not that of the orbits")
    demand(content["decided"] == (not left), "undecided boxes of a decided census")
    certified = [orbit["certificate"] for orbit in content["orbits"] if orbit["certificate"]]
    verdicts = [told["claims"]["admissibility"] for told in certified]
    demand(content["admissible"] == verdicts.count("proved"), "another number is admissible")


def _common_turns(declared: StatedSystem) -> int:
    """Return after how many turns of the first forcing all have turned wholly."""
    field = declared.steps[0].field
    speeds = [field[s][c] for c, s in declared.forcing]
    demand(all(speeds), "a forcing does not turn")
    ratios = [speed / speeds[0] for speed in speeds]
    ratios = [x.rational if isinstance(x, RationalFunction) else x for x in ratios]
    demand(all(x is not None for x in ratios), "the forcings have no common period")
    return math.lcm(*(int(x.q) for x in ratios))


def _around(bound: Any) -> tuple[float, float]:
    number = arb(bound)
    near = float(number.mid())
    return (near, near) if arb(near) == number else floats_around(number)


def _within(number: Any, low: float, high: float) -> bool:
    return bool(number > arb(low) and number < arb(high))
