"""Whether an orbit is a motion of its system.

No boundary is crossed before a phase ends, for all times; the one that ends it is reached from
inside; and the transition is the first whose conditions hold.
"""

import re
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, lower, vanishing
from nonsmooth.runtime.checker.orbits.stability import MULTIPLIERS, characteristic, passing
from nonsmooth.runtime.checker.stated.declared import StatedBoundary, StatedPhase, Way
from nonsmooth.runtime.checker.stated.exact import Entries, Numbers, Verdict, demand, exact, product
from nonsmooth.runtime.core.taylor_models import matrix, range_of

_DEEPEST = 60  # halvings of a window of time
_MOST = 10_000  # windows
_CLOSE = "{}: it comes closer to zero than the digits tell"
_SHARE = 3 / 4  # of its distance from zero, at least, that is looked for: any share gives a bound
_SMALL = 5  # halvings behind which the exponential of a field is that of a small matrix


Window = tuple[Any, Any] | None  # times between which a grazing is; None without one


class Border(NamedTuple):
    """An inequality of admissibility that ceases to hold at an event.

    Its number is negative where it holds and rises through zero where it ceases to hold.
    """

    kind: str
    phase: int
    boundary: str
    instant: str

    def number(self, orbit: CheckedOrbit, time: Any = None) -> Any:
        """Return the number that is negative where the inequality holds, in the orbit's numbers.

        A grazing needs its time. `Failure` is raised if the orbit has no such border.
        """
        place, step = self.phase, orbit.declared.itinerary[self.phase]
        if self.kind == "vanishing-phase":
            demand(self[2:] == ("+".join(step["boundaries"]), ""), "the phase ends otherwise")
            return -orbit.dwell[place]
        begin, end = orbit.now.starts[place], orbit.now.ends[place]
        if self.kind == "grazing":
            watched = self.watched(orbit)
            demand(self.instant == "inside" and not watched.still, "this is no such event")
            state = (orbit.chain.fields[place] * time).exp() * begin
            return (orbit.numbers([watched.row]) * state)[0, 0]
        state = begin if self.instant == "start" else end
        value = orbit.value(self.row(orbit), state.entries())
        falls = (self.kind, self.instant) == ("tangent", "end")
        if self.kind == "condition":
            falls = self.condition(orbit)[1]
        return -value if falls else value

    def row(self, orbit: CheckedOrbit) -> Any:
        """Return the row of the function that is zero at the border, where a phase begins or ends.

        `Failure` is raised if the orbit has no such border.
        """
        if self.kind == "condition":
            return self.condition(orbit)[0]
        watched = self.watched(orbit)
        means = {
            ("simultaneous", "end"): (not watched.ends_it, watched.end),
            ("tangent", "end"): (watched.ends_it, watched.speed),
            ("tangent", "start"): (watched.order > 0, watched.begins),
            ("entry", "start"): (watched.order == 0, watched.begins),
        }
        fits, row = means.get((self.kind, self.instant), (False, None))
        demand(fits and row is not None and any(row), "this is no such event")
        return row

    @property
    def listed(self) -> tuple[int, int]:
        """Places, from 0, of a condition's transition and of the condition in it."""
        fits = self.instant == "end" and re.fullmatch(r"[1-9]\d{0,3}\.[1-9]\d{0,3}", self.boundary)
        demand(fits, "there is no such condition")
        transition, place = self.boundary.split(".")
        return int(transition) - 1, int(place) - 1

    def condition(self, orbit: CheckedOrbit) -> tuple[Any, bool]:
        """Return a condition's row, and whether it is positive where the inequality holds.

        The row acts on the state behind the phase's end. `Failure` is raised if there is no
        such condition.
        """
        phase = orbit.declared.phases([])[self.phase]
        number, place = self.listed
        demand(len(phase.orders) == 1 and not phase.lawful, "this is no such event")
        demand(number < len(phase.orders[0]), "there is no such condition")
        way = phase.orders[0][number]
        demand(place < len(way.conditions), "there is no such condition")
        row, expected = way.conditions[place]
        demand(row is not None and any(row), "this is no such event")
        return row, expected == way.wanted

    def watched(self, orbit: CheckedOrbit) -> StatedBoundary:
        """Return the border's boundary in its phase; `Failure` if the phase has none."""
        phase = orbit.declared.phases([])[self.phase]
        found = next((w for w in phase.watched if w.name == self.boundary), None)
        demand(found is not None, "there is no such boundary")
        assert found is not None
        return found


def borders_of(event: Entries) -> tuple[list[Border], Window]:
    """Return the borders that are met at an event of a file, and the window of a grazing.

    `Failure` is raised if a window is stated of no grazing, or none of one.
    """
    own = [event[name] for name in ("kind", "phase", "boundary", "instant")]
    told = [entry for entry in (own, *event["also"]) if entry[0] not in MULTIPLIERS]
    demand(all(isinstance(place, int) for _, place, *_ in told), "a border of no phase")
    borders = [Border(kind, place - 1, *rest) for kind, place, *rest in told]
    window = [arb(exact(time)) for time in event["window"]]
    grazes = any(border.kind == "grazing" for border in borders)
    demand(len(window) == 2 * grazes, "a window of no grazing")
    return borders, (window[0], window[1]) if window else None


def demand_no_phase(event: Entries) -> None:
    """Demand that an event of a file is in no phase: multipliers alone tell of it."""
    own = [event[name] for name in ("phase", "configuration", "boundary", "instant")]
    demand(own == [None, "", "", ""] and not event["also"] and not event["window"], "a phase")


def event_number(
    which: Border | str,
    orbit: CheckedOrbit,
    still: Callable[[], CheckedOrbit],
    window: Window,
) -> Any:
    """Return the number that is zero at an event, in an orbit's numbers.

    The event is a border, or the kind of one of the multipliers'. The time of a grazing, which
    needs its window, is that of the orbit without derivatives.
    """
    if isinstance(which, str):
        return passing(characteristic(orbit.section), which)
    time = time_of_touch(still(), which, window) if which.kind == "grazing" else None
    return which.number(orbit, time)


def time_of_touch(orbit: CheckedOrbit, border: Border, window: Window) -> Any:
    """Return an enclosure of the time of a grazing: the one maximum of its boundary function.

    It lies in the window (begin, end), from the start of the phase, in which the function
    is concave. `Failure` is raised if none is proved to be there.
    """
    demand(window is not None, "a grazing has no window")
    assert window is not None
    b, y = orbit.chain.fields[border.phase], orbit.now.starts[border.phase]
    n = orbit.numbers([border.watched(orbit).row]) * b

    def rates(time: Any) -> tuple[Any, Any]:
        state = (b * time).exp() * y
        return (n * state)[0, 0], (n * (b * state))[0, 0]

    time: Any = ((window[0] + window[1]) / 2).mid()
    for _ in range(8):
        rate, bend = rates(time)
        time = (time - rate / bend).mid()
    rate, bend = rates(time)
    radius = (2 * abs(range_of(rate / bend)) + arb(2) ** (10 - ctx.prec)).upper()
    demand(radius.is_finite(), "the time of a grazing is not known")
    _, bend = rates(time + arb(0, radius))
    moved = -rate / bend
    demand(bend < 0 and abs(moved) <= radius, "the time of a grazing is not known")
    found = time + moved
    demand(found > window[0] and found < window[1], "a grazing is outside of its window")
    behind = range_of(orbit.dwell[border.phase] - found)
    demand(found > 0 and behind > 0, "a grazing is outside of its phase")
    return found


class Margin(NamedTuple):
    """A lower bound that shows how clearly a phase respects a boundary.

    By quantity: the boundary function stays below minus a "distance"; its first nonzero derivative
    at the start is below minus a "departure"; the boundary is reached with at least a "speed".
    """

    phase: int  # counted from 0
    configuration: str
    boundary: str
    quantity: str
    least: Any


class _Told(NamedTuple):
    """What is known of something that has to hold."""

    sign: int | None  # -1, it does; 1, it does not; else it is not known
    false: str = ""  # what is said where it does not hold
    unknown: str = ""  # what is said where that is not known
    border: Border | None = None  # the inequality that says it, if it may be assumed


def admissibility(
    orbit: CheckedOrbit,
    assumed: Sequence[Border] = (),
    window: Window = None,
    *,
    margins: bool = False,
) -> Verdict:
    """Return whether a located orbit is a motion of its system, with margins if they are asked for.

    Inequalities `assumed` are taken to hold; if one of them is a grazing, its function is concave
    between the times of `window`. Without margins an undecided verdict comes with the inequalities
    that are open; None stands for anything else that is.
    """
    undecided, kept, opened = "", list[Margin](), list[Border | None]()
    for place, phase in enumerate(orbit.declared.phases(vanishing(orbit))):
        name = f"phase {place + 1}, {orbit.declared.steps[place].name}"
        measured = list[Margin]() if margins else None
        found = _phase(orbit, place, phase, assumed, window, measured)
        declared = [watched.name for watched in phase.watched]
        kept += sorted(measured or (), key=lambda margin: declared.index(margin.boundary))
        for told in found:
            if told.sign == 1:
                return Verdict("refuted", f"{name}: {told.false}")
        left = [told for told in found if told.sign != -1]
        undecided = undecided or (f"{name}: {left[0].unknown}" if left else "")
        opened += [told.border for told in left]
    if undecided:
        return Verdict("undecided", undecided, () if margins else tuple(opened))
    return Verdict("proved", found=tuple(kept))


def _phase(
    orbit: CheckedOrbit,
    place: int,
    phase: StatedPhase,
    assumed: Sequence[Border],
    window: Window,
    margins: list[Margin] | None,
) -> list[_Told]:
    """Return what is known of all that has to hold in a phase; add to the margins, if any."""
    first, last = orbit.now.starts[place].entries(), orbit.now.ends[place].entries()

    def margin(name: str, quantity: str, least: Any) -> None:
        if margins is not None and least.lower() > 0:
            step = orbit.declared.steps[place]
            margins.append(Margin(place, step.name, name, quantity, least.lower()))

    ending = "+".join(orbit.declared.itinerary[place]["boundaries"])
    own = {(b.kind, b.boundary, b.instant) for b in assumed if b.phase == place}
    vanishes = any(kind == "vanishing-phase" for kind, *_ in own)
    lasts = _Told(
        -1 if vanishes else _sign(-orbit.dwell[place]),
        "its dwell time is negative",
        "its dwell time cannot be told from 0",
        Border("vanishing-phase", place, ending, ""),
    )
    if lasts.sign != -1:
        return [lasts]
    found = [lasts]
    for row in phase.held:
        found.append(
            _zero(orbit, row, first, "what it holds {} where it begins", ("holds", "does not hold"))
        )
    waves = []
    for watched in phase.watched:
        name, order, begins = watched.name, watched.order, watched.begins
        touched = ("tangent", name, "end") in own
        speed = orbit.value(watched.speed, last) if watched.ends_it else arb(1)
        leading = arb(-1) if begins is None else orbit.value(begins, first)
        clear = leading < 0 and speed > 0
        if not clear and _bends(orbit, place, watched):
            continue
        shape = _Shape(
            not order and vanishes and watched.ends_it,
            ("tangent" if order else "entry", name, "start") in own,
            ("simultaneous", name, "end") in own,
            touched or (watched.ends_it and bool(speed > 0)),
            order == 1 and bool(leading < 0),
            window if ("grazing", name, "inside") in own else None,
            apart=margins is not None and not order and not watched.ends_it,
        )
        if begins is not None and not shape.starts_open:
            found.append(
                _Told(
                    _sign(leading),
                    f"{name} is passed where it begins",
                    f"{name} where it begins: its derivative of order {order}"
                    " cannot be told from 0",
                    Border("tangent" if order else "entry", place, name, "start"),
                )
            )
            if order:
                margin(name, "departure", -range_of(leading))
        if watched.ends_it:
            found.append(
                _zero(orbit, watched.end, last, f"{name} {{}} where it ends",
                      ("is reached", "is not reached"))
            )  # fmt: skip
            if not touched:
                found.append(
                    _Told(
                        _sign(-speed),
                        f"{name} is reached from outside",
                        f"{name} may be reached tangentially",
                        Border("tangent", place, name, "end"),
                    )
                )
                margin(name, "speed", range_of(speed))
        if begins is None:
            continue  # it is zero all along
        if order or not watched.still:
            waves.append((watched, shape))
        elif shape.apart:
            margin(name, "distance", -range_of(leading))
    conditions = [border.listed for border in assumed
                  if border.kind == "condition" and border.phase == place]  # fmt: skip
    found += _follows(orbit, place, phase, last, conditions)
    if all(told.sign != 1 for told in found):
        below, heights = _below(orbit, place, waves)
        told_of = {told.border.boundary for told in found if told.sign != -1 and told.border}
        found += [t for t in below if t.border is None or t.border.boundary not in told_of]
        for (watched, shape), height in zip(waves, heights, strict=True):
            if shape.apart:
                margin(watched.name, "distance", -height)
    return found


def _zero(orbit: CheckedOrbit, row: Any, state: Numbers, told: str, ways: tuple[str, str]) -> _Told:
    """Return what is known of a function being zero at a state, if it is not exactly zero."""
    sign = _sign(orbit.value(row, state)) if any(row) else 0
    known = {0: -1, None: None}.get(sign, 1)
    return _Told(known, told.format(ways[1]), f"whether {told.format(ways[0])}")


class _Shape(NamedTuple):
    """How a boundary's function may be zero, beside what is exact, at its ends or inside."""

    # its sign at the start is open, as it may rise from zero in a phase that may vanish
    rises: bool = False
    begins: bool = False  # it may be zero at the start
    ends: bool = False  # it may be zero at the end
    slows: bool = False  # its rate at the end is not negative
    falls: bool = False  # its rate at the start is negative
    touches: Window = None  # times between which it may touch zero
    apart: bool = False  # how far it stays from zero is asked for

    @property
    def starts_open(self) -> bool:
        """Whether the sign at the start is not asked for."""
        return self.rises or self.begins


def _bends(orbit: CheckedOrbit, place: int, watched: StatedBoundary) -> bool:
    """Return whether a function is convex in a phase at both ends of which it is exactly zero.

    If the phase lasts a positive time, the function is then negative inside, and left and
    reached with a speed.
    """
    if not (watched.ends_it and watched.order == 1 and watched.begins) or any(watched.end):
        return False
    field = orbit.declared.steps[place].field
    bend = tuple(-x for x in product(product(watched.row, field), field))
    if not orbit.value(bend, orbit.now.starts[place].entries()) < 0:
        return False
    falling = watched._replace(row=bend, ends_it=False, order=0)
    return all(told.sign == -1 for told in _below(orbit, place, [(falling, _Shape())])[0])


def _follows(
    orbit: CheckedOrbit,
    place: int,
    phase: StatedPhase,
    last: Any,
    assumed: Sequence[tuple[int, int]],
) -> list[_Told]:
    """Return whether in every order the itinerary's transition follows.

    The first transition whose conditions hold follows. Conditions `assumed` to be as the
    itinerary asks have to decide it: all other conditions of their transitions have to
    hold.
    """
    target = orbit.declared.steps[place].target
    unknown, orders = f"whether {target} follows", phase.orders
    if phase.lawful:
        unknown = f"by which steps of the contact law {target} follows"
    if len(orders) > 1:
        ending = " and ".join(orbit.declared.itinerary[place]["boundaries"])
        unknown = f"the orders in which {ending} act need not agree"
    if not phase.decided:
        return [_Told(None, unknown=unknown)]
    if assumed:
        if len(orders) > 1 or phase.lawful or sum(way.alike for way in orders[0]) > 1:
            return [_Told(None, unknown=unknown)]
        if len({number for number, _ in assumed}) < len(assumed):
            return [_Told(None, unknown=unknown)]
        ways = []
        taken = dict(assumed)
        for number, way in enumerate(orders[0]):
            if number in taken:
                others = [c for k, c in enumerate(way.conditions) if k != taken[number]]
                if not all(_holds(orbit, row, last, expected) for row, expected in others):
                    return [_Told(None, unknown=unknown)]
                if way.wanted:
                    ways.append(way._replace(conditions=[]))
                continue
            ways.append(way)
        orders = [ways]
    found = [_first(orbit, ways, last) for ways in orders]
    sign = None if None in found else -1
    if 1 in found:
        sign = None if phase.lawful else 1
    told = _Told(sign, f"{target} does not follow, or not by this transition", unknown)
    if sign is not None or assumed or phase.lawful or len(orders) > 1:
        return [told]
    opened = _open_conditions(orbit, place, orders[0], last)
    return [told._replace(border=border) for border in opened] or [told]


def _open_conditions(orbit: CheckedOrbit, place: int, ways: list[Way], last: Any) -> list[Border]:
    """Return the open conditions on which alone it depends which transition follows.

    A transition has at most one: all its other conditions hold, so where it changes, another
    transition follows, or none.
    """
    found = []
    for number, way in enumerate(ways, 1):
        held = [_holds(orbit, row, last, expected) for row, expected in way.conditions]
        if False in held:
            continue
        left = [k for k, holds in enumerate(held, 1) if holds is None]
        if len(left) > 1 or not (left or way.wanted):
            return []
        found += [Border("condition", place, f"{number}.{k}", "end") for k in left]
    return found


def _first(orbit: CheckedOrbit, ways: list[Way], last: Any) -> int | None:
    """Return -1 if the first way whose conditions hold is wanted, 1 if not, None if unknown.

    It is not known where another transition leads as the wanted one does: the motion is the same.
    """
    for way in ways:
        held = [_holds(orbit, row, last, expected) for row, expected in way.conditions]
        if all(held):
            return -1 if way.wanted else None if way.alike else 1
        if False not in held:
            return None
    return 1


def _holds(orbit: CheckedOrbit, row: Any, last: Any, expected: bool) -> bool | None:
    sign = 0 if row is None else _sign(orbit.value(row, last))
    return None if sign is None else (sign > 0) == expected


def _below(
    orbit: CheckedOrbit, place: int, waves: list[tuple[StatedBoundary, _Shape]]
) -> tuple[list[_Told], list[Any]]:
    """Return what is not known of functions being negative inside a phase, and what they are below.

    Time runs from 0 to 1: the field b is the phase's times its dwell time. In a window of
    times c - r ... c + r the motion stays within r exp(r |b|) |b Y(c)| of Y(c), by
    Gronwall's lemma, so its rate b Y stays within b Y(c) + b times that. This bound
    depends on b Y(c) as a whole, so what does not move stays, however large it is. And g
    stays below g(c) + [-r, r] g'(c) + [0, r r / 2] n b b Y. A window in which g rises is
    left to the one behind it, or to the end where g is zero; one in which it falls is
    left to the one before it, or to the start, where g is not positive: both cannot meet.
    Where more derivatives vanish at the start, the first that does not decides. Where a
    function may touch zero it is concave in all of a window, which is left to its one
    maximum there. Where zero may be reached without speed the function is concave at the
    end. Where the distance of a function is asked for, bounds in its windows are not far
    above its values; the heights are bounds of these functions alone. Of a function of which
    neither the value nor the rate can be told from zero no smaller windows tell more.
    """
    length = orbit.dwell[place]
    lasts = bool(length > 0)
    if not lasts:  # it may vanish: at most so long
        length = range_of(length).upper()
    b = lower(orbit.chain.fields[place] * length)
    wide = range_of(b)
    size = matrix([[abs(x) for x in row] for row in wide.tolist()])
    rows = [lower(orbit.numbers([watched.row])) for watched, _ in waves]
    start, dwell = lower(orbit.now.starts[place]), range_of(length)
    heights = [range_of((n * start)[0, 0]).upper() for n in rows]

    @cache
    def ahead(level: int) -> Any:
        """Return the flow over the time 2^-level."""
        if level >= _SMALL:
            return (b * arb(2) ** -level).exp()
        return ahead(level + 1) * ahead(level + 1)

    @cache
    def reach(level: int) -> Any:
        """Return a bound of how far rates carry a motion within 2^-level, to both sides."""
        r = arb(2) ** -level
        return (size * r).exp() * arb(0, r)

    windows = [(start, 0, list(range(len(waves))), True, True, fmpq(0))]
    count, unknown = 0, set[int]()
    while windows:
        begin, depth, left, first, last, since = windows.pop()
        r, middle = arb(2) ** -(depth + 1), since + fmpq(1, 2 ** (depth + 1))
        around, rest = arb(0, r), []
        y = ahead(depth + 1) * begin
        rate = b * y
        fast = range_of(rate)
        rates = fast + wide * (reach(depth + 1) * matrix([[abs(x)] for x in fast.entries()]))
        bent = wide * rates
        for i in left:
            if i in unknown:
                continue
            (watched, shape), n = waves[i], rows[i]
            value, slope = range_of((n * y)[0, 0]), range_of((n * rate)[0, 0])
            curve = (range_of(n) * bent)[0, 0]
            if shape.touches is not None:
                begins, ends = since * dwell, (since + fmpq(1, 2**depth)) * dwell
                beside = ends < shape.touches[0] or begins > shape.touches[1]
                if not (beside or curve < 0):
                    rest.append(i)
                    continue
                if begins > shape.touches[0] and ends < shape.touches[1]:
                    continue
            if value > 0:
                time = (middle * dwell).str(6, radius=False)
                told = f"{watched.name} is crossed before it ends, {time} after its start"
                if lasts:
                    return [_Told(1, told)], heights
                unknown.add(i)  # the phase may end before
                continue
            change = slope + curve * around
            top = value + slope * around + curve * arb(0).union(r * r / 2)
            rising = watched.ends_it or shape.ends or not last
            done = (change < 0 and not (first and shape.rises)) or (change > 0 and rising)
            done = done or (last and shape.slows and curve < 0)
            done = done or (first and shape.falls and curve < 0)
            near = depth < _DEEPEST and not top < _SHARE * value
            if not done and top < 0 and not (shape.apart and near):
                done, heights[i] = True, heights[i].max(top.upper())
            order = watched.follows if shape.begins else watched.order
            if first and order > 1:
                done = _turns_down(n, b, wide, rate, rates, order, around)
            if not done:
                near_zero = not (value < 0 or slope < 0 or slope > 0)
                (unknown.add if near_zero else rest.append)(i)
        count += 1
        if depth == _DEEPEST or count > _MOST:
            unknown.update(rest)
        elif rest:
            windows.append((y, depth + 1, rest, False, last, middle))
            windows.append((begin, depth + 1, rest, first, False, since))
    return [_not_below(orbit, place, *waves[i]) for i in sorted(unknown)], heights


def _not_below(orbit: CheckedOrbit, place: int, watched: StatedBoundary, shape: _Shape) -> _Told:
    """Return what is said of a function that may not be negative inside a phase."""
    last = orbit.value(watched.end, orbit.now.ends[place].entries())
    at_end = not (watched.ends_it or shape.ends or last < 0 or last > 0)
    kind = (
        ("simultaneous", place, watched.name, "end")
        if at_end
        else ("grazing", place, watched.name, "inside")
    )
    return _Told(None, unknown=_CLOSE.format(watched.name), border=Border(*kind))


def _turns_down(n: Any, b: Any, wide: Any, rate: Any, fast: Any, order: int, around: Any) -> bool:
    """Return whether a derivative is negative in a window.

    `rate` and `fast` are the first derivatives in its middle and in all of it.
    """
    for _ in range(1, order):
        rate, fast = b * rate, wide * fast
    change = (range_of(n) * (wide * fast))[0, 0] * around
    return bool(range_of((n * rate)[0, 0]) + change < 0)


def _sign(x: Any) -> int | None:
    """Return 1, -1 or 0 for a number of this sign; None for a ball that does not tell."""
    return 1 if x > 0 else -1 if x < 0 else 0 if x == 0 else None
