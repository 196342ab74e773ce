"""Whether an orbit is a motion of its system.

No boundary is crossed before a phase ends, for all times; the one that ends it is reached from
inside; and the transition is the first whose conditions hold.
"""

from functools import cache
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.checker.declared import StatedBoundary, StatedPhase, Way
from nonsmooth.runtime.checker.exact import demand, exact
from nonsmooth.runtime.checker.orbit import CheckedOrbit, lower
from nonsmooth.runtime.checker.vanishing import vanishing
from nonsmooth.runtime.core.taylor_models import matrix, range_of

__all__ = ["admissibility"]

_DEEPEST = 60  # halvings of a window of time
_MOST = 10_000  # windows
_SMALL = 5  # halvings behind which the exponential of a field is that of a small matrix


def admissibility(orbit: CheckedOrbit, margins: list[Any]) -> str:
    """The verdict, and that every margin is kept that is stated.

    Parameters
    ----------
    orbit : CheckedOrbit
        The orbit, located.
    margins : list of dict
        As the file states them.

    Returns
    -------
    {"proved", "refuted", "undecided"}
        What is found here.

    Raises
    ------
    Failure
        If a margin is not kept.
    """
    stated = {(m["phase"] - 1, m["boundary"], m["quantity"]): exact(m["least"]) for m in margins}
    demand(len(stated) == len(margins), "a margin is stated twice")
    for margin in margins:
        place = margin["phase"] - 1
        there = 0 <= place < len(orbit.declared.steps)
        there = there and margin["configuration"] == orbit.declared.steps[place].name
        demand(there, "a margin is stated of another phase")
    demand(all(m > 0 for m in stated.values()), "a margin is not positive")
    phases = enumerate(orbit.declared.phases(vanishing(orbit)))
    found = [sign for place, phase in phases for sign in _phase(orbit, place, phase, stated)]
    if 1 in found:
        return "refuted"
    demand(not stated, "a margin is stated of nothing")
    return "proved" if {*found} == {-1} else "undecided"


def _phase(
    orbit: CheckedOrbit, place: int, phase: StatedPhase, stated: dict[Any, Any]
) -> list[int | None]:
    """Of all that has to hold in a phase -1 if it does, 1 if it does not, None if unknown.

    Margins that are kept are taken from `stated`.
    """
    first, last = orbit.now.starts[place].entries(), orbit.now.ends[place].entries()

    def clear(name: str, quantity: str, size: Any) -> int | None:
        least = stated.pop((place, name, quantity), fmpq(0))
        return -1 if size > arb(least) else None

    zeros = [orbit.value(row, first) if any(row) else fmpq(0) for row in phase.held]
    found = [_sign(-orbit.dwell[place])]
    waves = []
    for watched in phase.watched:
        name, order = watched.name, watched.order
        if watched.ends_it:
            zeros.append(orbit.value(watched.end, last) if any(watched.end) else fmpq(0))
            speed = orbit.value(watched.speed, last)
            found += [_sign(-speed), clear(name, "speed", speed)]
        if watched.begins is None:
            continue  # it is zero all along
        leading = orbit.value(watched.begins, first)
        found.append(_sign(leading))
        least = stated.pop((place, name, "distance"), fmpq(0))
        if least:  # of a function that is zero somewhere there is none
            found.append(None if order or watched.ends_it else -1)
        if order:
            found.append(clear(name, "departure", -leading))
        else:
            found.append(-1 if leading + arb(least) < 0 else None)
        if order or not watched.still:
            waves.append((watched, arb(least)))
    found += [{0: -1, None: None}.get(_sign(x), 1) for x in zeros]
    found.append(_follows(orbit, phase, last))
    return found if 1 in found else [*found, _below(orbit, place, waves)]


def _follows(orbit: CheckedOrbit, phase: StatedPhase, last: Any) -> int | None:
    """Whether in every order the first transition whose conditions hold is the itinerary's."""
    if not phase.decided:
        return None
    found = [_first(orbit, ways, last) for ways in phase.orders]
    if 1 in found:
        return None if phase.lawful else 1
    return None if None in found else -1


def _first(orbit: CheckedOrbit, ways: list[Way], last: Any) -> int | None:
    """-1 if the first way whose conditions hold is wanted, 1 if it is not, None if unknown."""
    for way in ways:
        held = [_holds(orbit, row, last, expected) for row, expected in way.conditions]
        if all(held):
            return -1 if way.wanted else 1
        if False not in held:
            return None
    return 1


def _holds(orbit: CheckedOrbit, row: Any, last: Any, expected: bool) -> bool | None:
    sign = 0 if row is None else _sign(orbit.value(row, last))
    return None if sign is None else (sign > 0) == expected


def _below(orbit: CheckedOrbit, place: int, waves: list[tuple[StatedBoundary, Any]]) -> int | None:
    """-1 if the functions are negative inside the phase, 1 if one is positive there.

    Time runs from 0 to 1: the field b is the phase's times its dwell time. In a window of times
    c - r ... c + r the motion stays within r exp(r |b|) |b Y(c)| of Y(c), by Gronwall, so its
    rate b Y within b Y(c) + b times that. That depends on b Y(c) as a whole: what does not move
    stays, whatever it is. And g stays below g(c) + [-r, r] g'(c) + [0, r r / 2] n b b Y. A
    window in which g
    rises is left to the one behind it, or to the end where g is zero; one in which it falls to
    the one before it, or to the start, where g is not positive: both cannot meet. Where more
    derivatives vanish at the start the first that does not decides.
    """
    b = lower(orbit.chain.fields[place] * orbit.dwell[place])
    wide = range_of(b)
    size = matrix([[abs(x) for x in row] for row in wide.tolist()])
    rows = [lower(orbit.numbers([watched.row])) for watched, _ in waves]

    @cache
    def ahead(level: int) -> Any:
        """The flow over 2^-level."""
        if level >= _SMALL:
            return (b * arb(2) ** -level).exp()
        return ahead(level + 1) * ahead(level + 1)

    @cache
    def reach(level: int) -> Any:
        """How far rates carry a motion to both sides in 2^-level."""
        r = arb(2) ** -level
        return (size * r).exp() * arb(0, r)

    windows = [(lower(orbit.now.starts[place]), 0, list(range(len(waves))), True, True)]
    count = 0
    while windows:
        begin, depth, left, first, last = windows.pop()
        r = arb(2) ** -(depth + 1)
        around, rest = arb(0, r), []
        y = ahead(depth + 1) * begin
        rate = b * y
        fast = range_of(rate)
        rates = fast + wide * (reach(depth + 1) * matrix([[abs(x)] for x in fast.entries()]))
        bent = wide * rates
        for i in left:
            (watched, least), n = waves[i], rows[i]
            value, slope = range_of((n * y)[0, 0]), range_of((n * rate)[0, 0])
            if value > 0:
                return 1
            curve = (range_of(n) * bent)[0, 0]
            change = slope + curve * around
            top = value + least + slope * around + curve * arb(0).union(r * r / 2)
            done = top < 0 or change < 0 or (change > 0 and (watched.ends_it or not last))
            if first and watched.order > 1:
                done = _turns_down(n, b, wide, rate, rates, watched.order, around)
            if not done:
                rest.append(i)
        count += 1
        if rest and (depth == _DEEPEST or count > _MOST):
            return None
        if rest:
            windows.append((y, depth + 1, rest, False, last))
            windows.append((begin, depth + 1, rest, first, False))
    return -1


def _turns_down(n: Any, b: Any, wide: Any, rate: Any, fast: Any, order: int, around: Any) -> bool:
    """Whether a derivative is negative in a window; rate and fast are the first ones there."""
    for _ in range(1, order):
        rate, fast = b * rate, wide * fast
    change = (range_of(n) * (wide * fast))[0, 0] * around
    return bool(range_of((n * rate)[0, 0]) + change < 0)


def _sign(x: Any) -> int | None:
    """1, -1, 0 where a number is exactly so, None where a ball does not tell."""
    return 1 if x > 0 else -1 if x < 0 else 0 if x == 0 else None
