"""The check of what begins at a border: orbits of another itinerary, and on which side.

Both branches have a tile with an event, proved as any other. That both events are one motion is
shown in two steps. What is zero at the one, where a phase may last no time, makes zero all that
the other itinerary asks of that state, and both lead it to one state: by linear algebra over the
declared numbers, with no divisor that is zero at this parameter. So it is an orbit of the other
itinerary at its border, and it lies in the tube of the other tile, where there is only one.
"""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from flint import arb, ctx

from nonsmooth.runtime.checker.orbits.motion import Border, borders_of
from nonsmooth.runtime.checker.orbits.stability import MULTIPLIERS
from nonsmooth.runtime.checker.ranges.branch import (
    BITS,
    NO_MOTION,
    SHARP,
    CheckedTile,
    checked_tiles,
)
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    Failure,
    Numbers,
    agree,
    demand,
    demand_sign,
    naming,
    product,
    products,
    reduced,
    unit_rows,
)
from nonsmooth.runtime.checker.stated.parameters import number_at
from nonsmooth.runtime.checker.stated.shape import check_file
from nonsmooth.runtime.core.jets import part_of

_FORCING_PHASE = "forcing-phase"
_ALIKE = ("system", "parameter", "interval", "stability")

_Parts = list[tuple[int, tuple[int, ...]]]


def check_branch(content: Entries) -> None:
    """Prove every claim of a branch again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth certified branch")
    tiles = checked_tiles(content)
    for number, tile in enumerate(tiles, 1):
        told = [] if tile.event is None else tile.event.get("beyond", [])
        for beyond in told:
            with naming(f"beyond the event of tile {number}"):
                _check(content, tile, beyond)
        ways = [_rotations(beyond["branch"]["itinerary"]) for beyond in told]
        apart = all(not one & other for k, one in enumerate(ways) for other in ways[:k])
        demand(apart, f"beyond the event of tile {number}: an itinerary twice")


def _rotations(itinerary: Sequence[Sequence[str]]) -> set[tuple[tuple[str, ...], ...]]:
    phases = tuple(map(tuple, itinerary))
    return {phases[k:] + phases[:k] for k in range(len(phases))}


class FoundBeyond(NamedTuple):
    """What is proved of orbits of another itinerary that begin at an event."""

    side: str  # of the event's parameter on which they are: "above" or "below"
    own: str  # on which the orbits of the event's branch are
    verdict: str  # on all of them


def found_beyond(
    content: Entries, tile: CheckedTile, branch: Entries, other: CheckedTile
) -> FoundBeyond:
    """Return what is proved of the orbits of another itinerary that begin at an event.

    `content` holds the entries of the event's branch, `branch` those of the other one; `tile` and
    `other` are their tiles with the event, already proved. `Failure` is raised if no orbits are
    proved to begin there.
    """
    with ctx.workprec(BITS):
        _demand_alike(content, branch)
        demand(other.event is not None, "no border is met in its tile")
        border = other.event["kind"] not in MULTIPLIERS and tile.event["kind"] not in MULTIPLIERS
        demand(border, "one of the events is no border")
        _one_system(tile, other)
        own, side = _side(tile), _side(other)
        (verdict,) = {other.tile["before"], other.tile["after"]} - {NO_MOTION}
        with ctx.workprec(SHARP):
            pair = [_Met(tile), _Met(other)]
            pair.sort(key=lambda met: (met.free, -len(met.steps)))
            _demand_one_motion(*pair)
    return FoundBeyond(side, own, verdict)


def _check(content: Entries, tile: CheckedTile, beyond: Entries) -> None:
    """Demand that what is stated of orbits that begin at the event of a proved tile is found."""
    _demand_alike(content, beyond["branch"])
    tiles = checked_tiles(beyond["branch"])
    demand(len(tiles) == 1, "what begins there is proved in one tile")
    nested = tiles[0].event is not None and tiles[0].event.get("beyond", [])
    demand(not nested, "what begins there has a beyond of its own")
    found = found_beyond(content, tile, beyond["branch"], tiles[0])
    demand(beyond["own"] == found.own, "the branch is on another side of its event")
    demand(beyond["side"] == found.side, "it begins on another side of the event")
    demand(beyond["verdict"] == found.verdict, "it has another verdict")


def _demand_alike(content: Entries, branch: Entries) -> None:
    """Demand that two branches are said to be of one system, over the same parameter."""
    demand(all(content[name] == branch[name] for name in _ALIKE), "another system's branch")
    given, others = content["parameters"], branch["parameters"]
    common = given.keys() & others.keys()
    demand(all(given[name] == others[name] for name in common), "other parameters")


def _one_system(tile: CheckedTile, other: CheckedTile) -> None:
    """Demand that both declarations state the same system, as functions of the parameter."""
    one, two = tile.curve.declared, other.curve.declared
    constants = [str(x) for x in tile.curve.constants], [str(x) for x in other.curve.constants]
    demand(constants[0] == constants[1], "other irrational numbers")
    demand(one.states == two.states and one.forcing == two.forcing, "states of another system")
    for name in one.configurations.keys() & two.configurations.keys():
        demand(_same(one.fields[name], two.fields[name]), "another field")
        (bounds, held), (others, holds) = one.configurations[name], two.configurations[name]
        demand(bounds.keys() == others.keys(), "other boundaries")
        same = all(_same([row], [others[boundary]]) for boundary, row in bounds.items())
        demand(same and _same(held, holds), "other boundaries")
    for begins in {t.begins for t in one.transitions} & {t.begins for t in two.transitions}:
        own, told = ([t for t in d.transitions if t.begins == begins] for d in (one, two))
        demand(len(own) == len(told), "other transitions")
        for first, second in zip(own, told, strict=True):
            alike = first.target == second.target and first.order == second.order
            alike = alike and _same(first.reset, second.reset)
            signs = [[each[1:] for each in t.conditions] for t in (first, second)]
            rows = [[each[0] for each in t.conditions] for t in (first, second)]
            demand(alike and signs[0] == signs[1] and _same(*rows), "other transitions")


def _side(tile: CheckedTile) -> str:
    """Return the side of the event's parameter on which the tile's orbits are motions."""
    before, after = tile.tile["before"], tile.tile["after"]
    demand((before == NO_MOTION) != (after == NO_MOTION), "no orbits begin at the event")
    sign = 1 if (before == NO_MOTION) == tile.forwards else -1
    if tile.place != tile.curve.last:
        order = 2 if tile.turns else 1
        rises = tile.rises(
            lambda point: part_of(tile.curve.jets(tile.place, point, order)[-1], order),
            "the parameter may turn",
        )
        sign = (1 if tile.turns else sign) * (1 if rises else -1)
    return "above" if sign > 0 else "below"


class _Met:
    """A branch at the event of one of its tiles, where it meets a border."""

    def __init__(self, tile: CheckedTile) -> None:
        self.tile, self.curve, self.event = tile, tile.curve, tile.event
        self.steps, self.short = self.curve.declared.steps, self.curve.short
        self.turns = tile.turns
        self.borders, self.window = borders_of(self.event)
        self.gone = {b.phase for b in self.borders if b.kind == "vanishing-phase"}
        self.lasting = [k for k in range(len(self.steps)) if k not in self.gone]
        demand(self.lasting and len(self.gone) <= 1, "several phases vanish at once")
        closing, declared = self.curve.declared.closing, self.curve.declared
        covered = closing["kind"] in ("state", "forcing") and declared.dropped < 0
        demand(covered and not declared.translations, "cycles of another closing")
        demand(len(declared.forcing) <= 1, "several forcings: times a turn apart differ")

    @property
    def free(self) -> bool:
        """Whether the itinerary reaches no boundary."""
        return _FORCING_PHASE in self.steps[0].taken.begins

    @cached_property
    def point(self) -> list[Any]:
        """All coordinates at the event, enclosed: the unknowns, then the parameter."""
        return self.tile.at_event()

    @cached_property
    def orbit(self) -> Any:
        """The orbit at the event."""
        return self.curve.orbit(self.point)

    def touched_at(self, time: Any) -> bool:
        """Return whether a time is in the window of the grazing."""
        assert self.window is not None
        return bool(time > self.window[0] and time < self.window[1])

    def chain(self, place: int) -> list[int]:
        """Return a phase and, if it vanishes at the event, the phase behind it."""
        ahead = (place + 1) % len(self.steps)
        return [place, ahead] if ahead in self.gone else [place]

    def row(self, border: Border, before: dict[int, Any], behind: tuple[int, Any]) -> Any:
        """Return the function that is zero at a border, as a row over the state at a junction.

        `before` maps phases to the state at their end, `behind` is the next phase with the state at
        its start; both states are linear maps of the state at the junction.
        """
        at = before.get(border.phase)
        if border.instant == "start":  # the first phase begins long before
            starts = {**dict([*before.items()][1:]), behind[0]: behind[1]}
            at = starts.get(border.phase)
        demand(at is not None and border.kind != "grazing", "a border is met elsewhere")
        return product(border.row(self.orbit), at)


class _CheckedState:
    """The state at which a phase ends, with all that happens there in no time."""

    def __init__(self, met: _Met, place: int) -> None:
        self.met, self.place, self.chain = met, place, met.chain(place)
        size = met.curve.declared.size + 1
        self.map: Any = unit_rows(size)
        self.before: dict[int, Any] = {}
        self.rows: list[Any] = []
        for k in self.chain:
            step = met.steps[k]
            self.before[k] = self.map
            self.rows.append(product(step.exit, self.map))
            if k != place and met.short is not None and met.short[::2] == (k, True):
                self.rows.append(product(product(step.exit, step.field), self.map))
            self.map = products(step.reset, self.map)
        self.behind = (self.chain[-1] + 1) % len(met.steps), self.map

    def facts(self) -> list[Any]:
        """Return reduced rows of all functions that are zero at this state.

        No divisor of the elimination is zero at this parameter, which is demanded.
        """
        met = self.met
        rows = [*met.curve.declared.known[self.place][2], *self.rows]
        first = met.borders[0]
        if first.kind != "vanishing-phase":
            rows.append(met.row(first, self.before, self.behind))
        exactly = Elimination()
        found = exactly.echelon(rows)
        number = number_at([met.point[-1], *met.curve.constants])
        finite = all(number(entry).is_finite() for row in rows for entry in row)
        demand(finite, "what is zero has a pole at this parameter")
        for divisor in map(number, exactly.divisors):
            demand_sign(divisor, "what is zero may depend at this parameter")
        contradicts = any(not any(row[:-1]) for row in found)
        demand(not contradicts, "what is zero contradicts itself")
        return found

    def demand_met(self, facts: list[Any]) -> None:
        """Demand that all borders of the branch are met exactly where the facts are true."""
        met = self.met
        for border in met.borders:
            if border.kind != "vanishing-phase":
                row = met.row(border, self.before, self.behind)
                demand(not any(reduced(row, facts)), "a border may be met beside the event")
        if met.turns:
            self._demand_turn(facts)

    def _demand_turn(self, facts: list[Any]) -> None:
        """Demand that the branch turns where the phase vanishes: the fields agree there."""
        met = self.met
        demand(len(self.chain) == 2, "the branch turns elsewhere")
        first, gone = (met.steps[k] for k in self.chain)
        begins = self.before[self.chain[1]]
        short = products(gone.field, begins)
        ahead = met.steps[self.behind[0]].field
        demand(agree(short, products(begins, first.field), facts), "the branch may turn beside it")
        left, right = products(ahead, self.map), products(gone.reset, short)
        demand(agree(left, right, facts), "the branch may turn beside it")


def _demand_one_motion(longer: _Met, shorter: _Met) -> None:
    """Demand that the motion of the longer itinerary is the shorter one's orbit at its event."""
    one, two = longer.curve.declared.closing, shorter.curve.declared.closing
    demand(one["kind"] == two["kind"] and one.get("turns") == two.get("turns"), "other closings")
    demand(not longer.free, "both reach no boundary")
    if shorter.free:
        _demand_free(longer, shorter)
        return
    reason = "no phases of one itinerary are those of the other"
    for parts in _matches(longer, shorter):
        try:
            _demand_exactly(longer, shorter, parts)
            points = _points(longer, shorter, parts)
            demand(any(_holds(shorter.tile, point) for point in points), "two orbits")
            return
        except Failure as failure:
            reason = str(failure)
    raise Failure(f"the events may be two motions: {reason}")


def _matches(longer: _Met, shorter: _Met) -> Iterator[_Parts]:
    """Yield ways to compose each phase of the shorter itinerary of phases of the longer one."""
    xs, ys = longer.lasting, shorter.lasting
    first = shorter.borders[0]
    grazes = first.kind == "grazing" and len(shorter.borders) == 1
    demand(first.phase in ys or not grazes, "a phase that vanishes is grazed")
    for turn in range(len(xs)):
        turned = xs[turn:] + xs[:turn]
        parts: list[tuple[int, ...]] = [(x,) for x in turned]
        if len(xs) == len(ys) + 1 and grazes:
            at = ys.index(first.phase)
            parts[at : at + 2] = [(turned[at], turned[at + 1])]
        elif len(xs) != len(ys) or first.kind == "grazing":
            return
        yield list(zip(ys, parts, strict=True))


def _demand_exactly(longer: _Met, shorter: _Met, parts: _Parts) -> None:
    """Demand that the longer motion is an orbit of the shorter one's equations.

    Both meet all their borders at one and the same state.
    """
    special: list[tuple[int, int, bool]] = []
    for y, own in parts:
        step = shorter.steps[y]
        for x in own:
            other = longer.steps[x]
            same = step.name == other.name and _same(step.field, other.field)
            demand(same, "other configurations")
        if len(own) == 2:
            special.append((y, own[0], True))
        other = longer.steps[own[-1]]
        plain = len(longer.chain(own[-1])) == len(shorter.chain(y)) == 1
        plain = plain and _same([step.exit], [other.exit])
        if not plain or not _same(step.reset, other.reset):
            special.append((y, own[-1], False))
    demand(len(special) == 1, "the itineraries differ at several states")
    ((y, x, split),) = special
    junction = _CheckedState(longer, x)
    facts = junction.facts()
    junction.demand_met(facts)
    if split:
        demand(shorter.borders[0].phase == y, "another phase is grazed")
        _demand_touch(shorter, junction, facts)
        demand(shorter.touched_at(longer.orbit.dwell[x]), "it is touched at another time")
        return
    ends = _CheckedState(shorter, y)
    asked = all(not any(reduced(row, facts)) for row in ends.rows)
    demand(asked, "the other itinerary asks for more")
    demand(agree(junction.map, ends.map, facts), "the itineraries lead to two states")
    ends.demand_met(facts)


def _demand_touch(shorter: _Met, junction: _CheckedState, facts: list[Any]) -> None:
    """Demand that the shorter orbit's boundary is touched at a state that does not jump."""
    border = shorter.borders[0]
    row = border.watched(shorter.orbit).row
    rate = product(row, shorter.steps[border.phase].field)
    touched = not any(reduced(row, facts)) and not any(reduced(rate, facts))
    demand(touched, "the boundary may not be touched")
    demand(agree(junction.map, unit_rows(len(row)), facts), "the state jumps")


def _demand_free(longer: _Met, shorter: _Met) -> None:
    """Demand that a longer orbit is the motion without a boundary that grazes one at its event.

    The shorter orbit begins where the sine of the first forcing is zero, so the longer motion is
    followed to that time.
    """
    single = len(longer.lasting) == 1 and len(shorter.borders) == 1
    demand(single and shorter.borders[0].kind == "grazing", "no motion without a boundary grazes")
    (x,) = longer.lasting
    own, step = longer.steps[x], shorter.steps[0]
    demand(own.name == step.name and _same(own.field, step.field), "other configurations")
    junction = _CheckedState(longer, x)
    facts = junction.facts()
    junction.demand_met(facts)
    _demand_touch(shorter, junction, facts)
    orbit, other = longer.orbit, shorter.orbit
    turn = other.chain.period / shorter.curve.declared.closing["turns"]
    half = turn / 2
    begins = half * round(float((shorter.point[other.first - 1] / half).mid()))
    away = longer.point[orbit.first - 1] + sum(orbit.dwell[: x + 1], arb(0)) - begins
    passed = away - turn * int((away / turn).mid().floor().unique_fmpz())
    state = (other.chain.fields[0] * (turn - passed)).exp() * orbit.now.ends[x]
    free = [state[k, 0] for k in shorter.curve.declared.free]
    point = [*free, begins, sum(orbit.dwell, arb(0)), longer.point[-1]]
    demand(_holds(shorter.tile, point), "two orbits")
    times = [passed + turn * k for k in range(shorter.curve.declared.closing["turns"])]
    demand(any(map(shorter.touched_at, times)), "it is touched at another time")


def _points(longer: _Met, shorter: _Met, parts: _Parts) -> Iterator[list[Any]]:
    """Yield the longer orbit in the coordinates of the shorter itinerary's equations.

    With a forcing, the time at the start is tried with a few whole turns added.
    """
    orbit, others, pairs = longer.orbit, shorter.orbit, dict(parts)
    times: list[Any] = [arb(0)] * len(shorter.steps)
    for y, own in parts:
        times[y] = sum((orbit.dwell[x] for x in own), arb(0))
    if 0 in pairs:
        x = pairs[0][0]
        state, passed = orbit.now.starts[x], sum(orbit.dwell[:x], arb(0))
    else:  # it begins with the phase that lasts no time
        x = pairs[len(times) - 1][-1]
        state = others.chain.resets[-1] * orbit.now.ends[x]
        passed = sum(orbit.dwell[: x + 1], arb(0))
    free = [state[k, 0] for k in shorter.curve.declared.free]
    if not shorter.curve.declared.forcing:
        yield [*free, *times, longer.point[-1]]
        return
    begins = longer.point[orbit.first - 1] + passed
    turn = others.chain.period / shorter.curve.declared.closing["turns"]
    for turns in range(-2, 3):
        yield [*free, begins + turns * turn, *times, longer.point[-1]]


def _holds(tile: CheckedTile, point: Numbers) -> bool:
    """Return whether an orbit lies in the tube of a tile."""
    value = point[tile.place]
    others = [*point[: tile.place], *point[tile.place + 1 :]]
    inside = value > arb(tile.low) and value < arb(tile.high)
    return bool(inside) and tile.holds(value, others)


def _same(left: Any, right: Any) -> bool:
    return len(left) == len(right) and agree(left, right)
