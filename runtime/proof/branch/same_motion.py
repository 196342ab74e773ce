"""Whether the events of two itineraries are one motion: what one passes at once the other meets.

Where a phase lasts no time the transitions at its two ends happen at one state. If what vanishes
there makes zero, exactly, all that another itinerary asks of that state, and both lead it to the
same state, then the motion is an orbit of the other itinerary too, at its border. In the tile of
that there is only one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.model.structure import FORCING_PHASE
from nonsmooth.runtime.proof.admissibility import OpenInequality
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.branch.passage import CyclePassage
from nonsmooth.runtime.proof.branch.tube import BranchTube
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.exact_tables import numbers, rational_of
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product

if TYPE_CHECKING:
    from flint import arb

__all__ = ["MetBorder", "is_same_motion"]

_Map = Sequence[Sequence[Any]]
_TURNS = range(-2, 3)  # of the forcing, between the starts of two cycles


@dataclass(frozen=True, eq=False)
class MetBorder:
    """An event of a branch at which its orbit meets a border."""

    region: Region
    tube: BranchTube  # of the event's tile
    borders: tuple[OpenInequality, ...]  # the event, and what happens within the same bounds
    window: tuple[arb, ...]  # of a grazing
    point: list[arb]  # enclosures of the orbit's unknowns and the parameter

    @cached_property
    def passage(self) -> CyclePassage:
        """The passage through the orbit's cycle."""
        return CyclePassage(self.region, self.point)

    @property
    def count(self) -> int:
        """The number of phases."""
        return len(self.region.cycle.configurations)

    @property
    def free(self) -> bool:
        """Whether the orbit reaches no boundary."""
        return self.region.cycle.itinerary[0][1] == FORCING_PHASE

    @property
    def gone(self) -> set[int]:
        """The phases whose dwell time is zero."""
        return {border.phase for border in self.borders if border.kind == "vanishing-phase"}

    @property
    def lasting(self) -> list[int]:
        """The phases whose dwell time is not zero."""
        return [k for k in range(self.count) if k not in self.gone]

    def name(self, place: int) -> str:
        """The configuration of a phase."""
        return self.region.cycle.itinerary[place][0]

    def field(self, place: int) -> _Map:
        """The field of a phase."""
        return self.region.tables.fields[self.region.cycle.configurations[place]]

    def row(self, place: int) -> Row:
        """The boundary function that ends a phase."""
        return self.region.tables.rows[self.region.cycle.rows[place]]

    def reset(self, place: int) -> _Map:
        """The reset behind a phase."""
        return self.region.tables.resets[self.region.cycle.transitions[place].reset]

    def behind(self, place: int) -> list[int]:
        """A phase, and those directly behind it whose dwell time is zero."""
        count, found = self.count, [place]
        while (found[-1] + 1) % count in self.gone and len(found) < count:
            found.append((found[-1] + 1) % count)
        return found


class _Junction:
    """The state where a lasting phase ends, and the phases behind it that last no time."""

    def __init__(self, met: MetBorder, place: int) -> None:
        self.met, self.place, self.chain = met, place, met.behind(place)
        self.before: dict[int, _Map] = {}  # the state at the end of each, by that of the first
        self.rows: list[Row] = []
        self.map: _Map = _identity(len(met.field(place)))
        short = met.region.short
        for k in self.chain:
            self.before[k] = self.map
            self.rows.append(product(met.row(k), self.map))
            if short is not None and short.divided and short.place == k and k != place:
                self.rows.append(product(product(met.row(k), met.field(k)), self.map))
            self.map = _times(met.reset(k), self.map)

    def row_of(self, border: OpenInequality) -> Row | None:
        """The row on the junction's state that is zero at a border; None if that is elsewhere."""
        met, k = self.met, border.phase
        count = len(met.region.cycle.configurations)
        plan = met.region.plans[k]
        at = self.before.get(k)
        if border.instant == "start":
            ahead = (self.chain[-1] + 1) % count
            at = self.map if k == ahead else at if k != self.place else None
        if at is None or border.kind == "grazing":
            return None
        if border.kind == "condition":
            number, which = (int(part) - 1 for part in border.boundary.split("."))
            behind = plan.orders[0][number].conditions[which][0]
            return None if behind is None else product(behind.row, at)
        watched = next(w for w in plan.watched if w.name == border.boundary)
        if border.instant == "start":
            return None if watched.begins is None else product(watched.begins.row, at)
        return product(watched.ends if border.kind == "simultaneous" else watched.speed, at)

    def facts(self) -> Invariants | None:
        """Relations that hold exactly at the junction.

        None if the rows may be dependent at this parameter, or contradict each other.
        """
        met, rows = self.met, list(self.rows)
        known = met.region.invariants
        if known is not None:
            rows += known.ends[self.place].rows
        first = met.borders[0]
        if first.kind != "vanishing-phase":
            own = self.row_of(first)
            rows += [] if own is None else [own]
        free: list[Row] = []
        for row in rows:
            if any(Invariants.of(free).reduce(row)):
                free.append(row)
        found, number = Invariants.of(free), met.passage.number
        if not all(x.is_finite() for x in numbers(free, number).entries()):
            return None
        minor = numbers([[row[k] for k in found.pivots] for row in free], number)
        regular = minor.det()
        return found if found.consistent and (regular > 0 or regular < 0) else None

    def meets(self, facts: Invariants, borders: Sequence[OpenInequality]) -> bool:
        """Whether these borders are met exactly where the facts are true."""
        for border in borders:
            if border.kind == "vanishing-phase":
                continue
            if border.kind == "fold":
                if not self._turns(facts):
                    return False
                continue
            row = self.row_of(border)
            if row is None or any(facts.reduce(row)):
                return False
        return True

    def _turns(self, facts: Invariants) -> bool:
        """Whether the branch turns exactly where its one phase vanishes.

        The fields agree there: that it lasts longer, and those beside it less, changes nothing
        to first order.
        """
        if len(self.chain) != 2:
            return False
        met, (k, gone) = self.met, self.chain
        ahead = (gone + 1) % len(met.region.cycle.configurations)
        begins = self.before[gone]
        short = _times(met.field(gone), begins)
        alike = _alike(facts, short, _times(begins, met.field(k)))
        return alike and _alike(
            facts, _times(met.field(ahead), self.map), _times(met.reset(gone), short)
        )


class _Match(NamedTuple):
    """Pairs of phases of two itineraries that last as long as each other."""

    # a phase of the shorter itinerary, and one or two of the longer one
    pairs: tuple[tuple[int, tuple[int, ...]], ...]


def is_same_motion(longer: MetBorder, shorter: MetBorder) -> bool:
    """Whether two events are proved to be one motion, at the working precision.

    `longer` has more phases, or reaches a boundary where the other one reaches none. Both are of
    one system, over the same parameter.
    """
    if max(len(longer.gone), len(shorter.gone)) > 1 or not (longer.lasting and shorter.lasting):
        return False
    if longer.free or not _closes_alike(longer.region.closing, shorter.region.closing):
        return False
    if shorter.free:
        return _grazes_freely(longer, shorter)
    matches = [*_rotated(longer, shorter), *_split(longer, shorter)]
    return any(_holds(longer, shorter, match) for match in matches)


def _rotated(longer: MetBorder, shorter: MetBorder) -> Iterator[_Match]:
    """Matches in which both itineraries have the same lasting phases, from any phase on."""
    xs, ys = longer.lasting, shorter.lasting
    if len(xs) != len(ys) or shorter.borders[0].kind == "grazing":
        return
    for turn in range(len(xs)):
        yield _Match(tuple((y, (xs[(k + turn) % len(xs)],)) for k, y in enumerate(ys)))


def _split(longer: MetBorder, shorter: MetBorder) -> Iterator[_Match]:
    """Matches in which a phase that grazes is two phases of the longer itinerary.

    Between the two there is one phase whose dwell time is zero.
    """
    xs, ys, border = longer.lasting, shorter.lasting, shorter.borders[0]
    if len(xs) != len(ys) + 1 or border.kind != "grazing" or len(shorter.borders) > 1:
        return
    for turn in range(len(xs)):
        turned = [*xs[turn:], *xs[:turn]]
        at = ys.index(border.phase)
        parts: list[tuple[int, ...]] = [(x,) for x in turned]
        parts[at : at + 2] = [(turned[at], turned[at + 1])]
        yield _Match(tuple(zip(ys, parts, strict=True)))


def _holds(longer: MetBorder, shorter: MetBorder, match: _Match) -> bool:
    """Whether the longer one's motion is the orbit of the shorter one at its event."""
    exact = _exactly(longer, shorter, match)
    if not exact:
        return False
    return any(_in_tile(shorter, point) for point in _points(longer, shorter, match))


def _exactly(longer: MetBorder, shorter: MetBorder, match: _Match) -> bool:
    """Whether the motion solves the shorter one's equations exactly, at its border.

    All borders of both events are met there.
    """
    special = []
    for y, parts in match.pairs:
        for x in parts:
            same = longer.name(x) == shorter.name(y)
            if not same or not _equal(longer.field(x), shorter.field(y)):
                return False
        if len(parts) == 2:
            special.append((y, parts[0], True))
        x = parts[-1]
        plain = len(longer.behind(x)) == len(shorter.behind(y)) == 1
        alike = _equal([longer.row(x)], [shorter.row(y)])
        if not (plain and alike and _equal(longer.reset(x), shorter.reset(y))):
            special.append((y, x, False))
    if len(special) != 1:
        return False
    ((y, x, split),) = special
    own = _Junction(longer, x)
    facts = own.facts()
    if facts is None or not own.meets(facts, longer.borders):
        return False
    if split:
        return _touches(longer, shorter, own, facts)
    other = _Junction(shorter, y)
    rows = all(not any(facts.reduce(row)) for row in other.rows)
    return rows and _alike(facts, own.map, other.map) and other.meets(facts, shorter.borders)


def _touches(longer: MetBorder, shorter: MetBorder, own: _Junction, facts: Invariants) -> bool:
    """Whether the shorter one's boundary is touched, in its window, and nothing else happens."""
    time = longer.passage.dwell[own.place]
    inside = time > shorter.window[0] and time < shorter.window[1]
    return bool(inside) and _is_touched(shorter, own, facts)


def _is_touched(shorter: MetBorder, own: _Junction, facts: Invariants) -> bool:
    """Whether the shorter one's boundary is touched at a state that stays as it is."""
    border = shorter.borders[0]
    plan = shorter.region.plans[border.phase]
    row = next(w.row for w in plan.watched if w.name == border.boundary)
    rate = product(row, shorter.field(border.phase))
    touched = not any(facts.reduce(row)) and not any(facts.reduce(rate))
    return touched and _alike(facts, own.map, _identity(len(row)))


def _grazes_freely(longer: MetBorder, shorter: MetBorder) -> bool:
    """Whether the shorter one is a motion that reaches no boundary, and grazes one.

    Its cycle begins where the sine of the first forcing is zero, the longer one's at the boundary:
    from there it is followed to such a time.
    """
    from flint import arb

    border = shorter.borders[0]
    if len(longer.lasting) != 1 or border.kind != "grazing" or len(shorter.borders) > 1:
        return False
    (x,) = longer.lasting
    same = longer.name(x) == shorter.name(0) and _equal(longer.field(x), shorter.field(0))
    own = _Junction(longer, x)
    facts = own.facts() if same else None
    if facts is None or not own.meets(facts, longer.borders):
        return False
    if not _is_touched(shorter, own, facts):
        return False
    now, equations = longer.passage, shorter.passage.equations
    turn = equations.period / equations.closing.turns
    begins = shorter.point[equations.first - 1]
    begins = turn / 2 * round(float(begins.mid()) / float(turn.mid()) * 2)
    away = longer.point[now.equations.first - 1] + sum(now.dwell[: x + 1], -begins)
    turns = math.ceil(float(away.mid()) / float(turn.mid()))
    flow = (equations.phases[0].field * (turns * turn - away)).exp()
    state = flow * now.shooting.ends[x]
    free = [state[k, 0] for k in equations.free]
    point = [*free, begins, sum(now.dwell, arb(0)), longer.point[-1]]
    low, high = shorter.window
    times = [away + k * turn for k in range(-turns, equations.closing.turns + 1)]
    return any(time > low and time < high for time in times) and _in_tile(shorter, point)


def _points(longer: MetBorder, shorter: MetBorder, match: _Match) -> Iterator[list[arb]]:
    """The longer one's motion as unknowns of the shorter one, for each shift of the forcing."""
    from flint import arb

    now, pairs = longer.passage, dict(match.pairs)
    times: list[Any] = [arb(0)] * len(shorter.region.cycle.configurations)
    for y, parts in match.pairs:
        times[y] = sum((now.dwell[x] for x in parts), arb(0))
    first = 0 if 0 in pairs else len(times) - 1
    x = pairs[first][0 if first == 0 else -1]
    state, passed = now.shooting.starts[x], sum(now.dwell[:x], arb(0))
    if first:
        reset = shorter.passage.equations.phases[first].reset
        state, passed = reset * now.shooting.ends[x], passed + now.dwell[x]
    equations = shorter.passage.equations
    free = [state[k, 0] for k in equations.free]
    if not equations.closing.pairs:
        yield [*free, *times, longer.point[-1]]
        return
    begins = longer.point[now.equations.first - 1] + passed
    turn = equations.period / equations.closing.turns
    for turns in _TURNS:
        yield [*free, begins + turns * turn, *times, longer.point[-1]]


def _in_tile(met: MetBorder, point: list[arb]) -> bool:
    """Whether an orbit is proved to be the one of a tile."""
    from flint import arb

    tube = met.tube
    value = point[tube.coordinate]
    inside = value > arb(rational_of(tube.lower)) and value < arb(rational_of(tube.upper))
    others = [*point[: tube.coordinate], *point[tube.coordinate + 1 :]]
    return bool(inside) and tube.holds(value, others)


def _closes_alike(one: ClosureConditions, other: ClosureConditions) -> bool:
    """Whether two cycles close by the same conditions, of which none is dropped."""
    single = len(one.pairs) <= 1  # times a turn apart are the same
    told = [(each.kind, each.turns, each.pairs, each.dropped) for each in (one, other)]
    covered = one.kind in ("state", "forcing") and one.form is None and other.form is None
    whole = not (one.translations or other.translations) and one.dropped < 0
    return (
        single and told[0] == told[1] and covered and whole and _equal([one.speeds], [other.speeds])
    )


def _identity(size: int) -> _Map:
    from flint import fmpq

    return [tuple(fmpq(int(i == j)) for j in range(size)) for i in range(size)]


def _times(left: _Map, right: _Map) -> _Map:
    return [product(row, right) for row in left]


def _equal(left: _Map, right: _Map) -> bool:
    pairs = zip(left, right, strict=True)
    return not any(x - y for a, b in pairs for x, y in zip(a, b, strict=True))


def _alike(facts: Invariants, left: _Map, right: _Map) -> bool:
    """Whether two maps agree where the facts are true."""
    return facts.agree(left, right)
