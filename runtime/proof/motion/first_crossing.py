"""The first boundary that a phase reaches, proved in balls.

A boundary function is negative inside its configuration. From where it is known to be
negative a window is opened and decided by its second derivative over the window: it stays
negative, or it rises and ends positive, then it is crossed exactly once in it. Else the
window is halved. A window as short as the digits allow is a contact that they cannot tell.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.checker.stated.exact import product
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.motion.asymptotics import stays_negative
from nonsmooth.runtime.proof.motion.ball_flow import Expansion
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants

if TYPE_CHECKING:
    from flint import arb

__all__ = ["PhaseEnd", "first_crossing"]

_LONGEST_SEARCH = 20_000  # segments of time in one phase
_LOOKS = frozenset(8 * 2**k for k in range(12))  # segments after which for ever is judged


class PhaseEnd(NamedTuple):
    """The end of a phase."""

    time: arb  # since the phase's start
    boundaries: tuple[int, ...]  # numbers of those that are reached
    state: list[arb]  # in front of the transition


class _WatchedBoundary:
    """One boundary with the time up to which it is proved not to be reached.

    The present window is part `index` of 2^`depth` equal parts of a segment of time.
    """

    def __init__(
        self,
        system: EnclosedSystem,
        configuration: int,
        boundary: int,
        state: Sequence[arb],
        order: int,
    ) -> None:
        shape = system.structure.boundaries[configuration][boundary]
        self.name, self.boundary = shape.name, boundary
        self.row, self.flow = shape.row, system.flows[configuration]
        self.state = state
        self.deepest = system.bits // 2
        self.segment = self.index = self.depth = 0
        self.function = self.flow.expansion(self.row, 0, state)
        self.time = self.function.start  # up to then the boundary is not reached
        if order:
            self._leave(order)

    def _place(self, part: int) -> arb:
        """Return the start, middle or end of the window in [-1, 1], for `part` 0, 1 or 2."""
        from flint import arb

        return arb(2 * self.index + part) * arb(2) ** -self.depth - 1

    def _window(self) -> tuple[arb, arb]:
        """Return the middle of the window and half of its length, exact."""
        from flint import arb

        return self._place(1), arb(2) ** -self.depth

    def _leave(self, order: int) -> None:
        """Go on to where a boundary that is zero at the start is proved to be left.

        The derivatives below `order` are zero there, and that one is negative.
        """
        from flint import arb

        while not self.function.at(order, arb(*self._window())) < 0:
            self._halve("is left so slowly that digits are missing")
        self._pass()

    def _halve(self, why: str) -> None:
        if self.depth == self.deepest:
            raise Undecided(f"{self.name} {why}", self._contact())
        self.index, self.depth = 2 * self.index, self.depth + 1

    def _pass(self) -> None:
        """Go on to the next window, the longest that the binary digits of its place allow."""
        self.index += 1
        while self.depth and self.index % 2 == 0:
            self.index, self.depth = self.index // 2, self.depth - 1
        if self.index == 1 and not self.depth:
            self.segment, self.index = self.segment + 1, 0
            self.function = self.flow.expansion(self.row, self.segment, self.state)
            self.time = self.function.start
        else:
            self.time = self.function.time(self._place(0))

    def _contact(self) -> arb:
        """Return a ball of times about the function's maximum, or the window if none is close.

        The maximum is approximated by Newton's method on the slope.
        """
        start, end = self._place(0), self._place(2)
        place = start
        for _ in range(60):
            curve = self.function.at(2, place).mid()
            if curve == 0:
                break
            place = (place - self.function.at(1, place).mid() / curve).mid()
            if not abs(place - start) < 1:
                break
        else:
            if place >= start:
                end = 2 * place - start
        return self.function.time(start).union(self.function.time(end))

    def window(self) -> tuple[arb, list[arb]] | None:
        """Decide one window and return time and state of the crossing in it, or None."""
        from flint import arb

        places = arb(*self._window())
        window = self.function.over(places)
        slope = window.rates
        if not (slope < 0 or window.values < 0):
            last = self.function.at(0, self._place(2)) if slope > 0 else None
            if last is not None and last > 0:
                return self._newton(places, slope)
            if last is not None and not last < 0:
                found = self._about_end(slope)
                if found is not None:
                    return found
            if last is None or not last < 0:
                self._halve("is reached tangentially, or comes closer than the digits tell")
                return None
        self._pass()
        return None

    def _about_end(self, slope: arb) -> tuple[arb, list[arb]] | None:
        """Return the one crossing in this window or the next one, as long, or None.

        The function has to rise over both. Of many states some cross in the one and some in the
        other, however short the windows are.
        """
        from flint import arb

        width = arb(2) ** (1 - self.depth)
        begin, end = self._place(0), self._place(2)
        function = self.function
        if end == 1:
            function, end = self.flow.expansion(self.row, self.segment + 1, self.state), arb(-1)
        beyond = end + width
        rates = function.over(end.union(beyond)).rates
        if not (rates > 0 and function.at(0, beyond) > 0):
            return None
        times = self.function.time(begin).union(function.time(beyond))
        rate = (slope / self.function.half).union(rates / function.half)
        return self._crossing(times, rate, self.function, function)

    def _crossing(self, times: arb, rate: arb, *functions: Expansion) -> tuple[arb, list[arb]]:
        """Return time and state of the one crossing in a ball of times that the functions cover."""
        while True:
            time, reached = self.flow.crossing(self.row, self.state, times, rate)
            if 2 * time.rad() >= times.rad():
                return time, reached
            times, rate = time, self._rate_over(time, functions)
            if not rate > 0:
                return time, reached

    def _rate_over(self, times: arb, functions: Sequence[Expansion]) -> arb:
        """Enclose the function's derivative by time over a ball, on all segments that it meets."""
        from flint import arb

        rates = []
        for function in functions:
            places = (times - function.start) / function.half - 1
            if places.overlaps(arb(0, 1)):
                rates.append(function.over(places.intersection(arb(0, 1))).rates / function.half)
        return reduce(arb.union, rates)

    def _newton(self, places: arb, slope: arb) -> tuple[arb, list[arb]]:
        """Return the one crossing in a ball of places over which the slope is positive."""
        function = self.function
        while True:
            middle = places.mid()
            value = function.at(0, middle)
            better = places.intersection(middle - value / slope)
            if 2 * better.rad() >= places.rad():
                # a slope that is not known well leaves the halves, told by the sign
                if not (value < 0 or value > 0):
                    return self._crossing(function.time(better), slope / function.half, function)
                end = places.upper() if value < 0 else places.lower()
                better = better.intersection(middle.union(end))
            places = better
            near = function.at(1, places.mid())
            near += function.at(2, places) * (places - places.mid())
            if near > 0:
                slope = near


def first_crossing(
    system: EnclosedSystem,
    configuration: int,
    invariants: Invariants,
    lasting: Invariants,
    state: Sequence[arb],
    until: arb | None = None,
) -> PhaseEnd | None:
    """Return the end of a phase with the boundaries that are reached, or None if it never ends.

    Time 0 stands for boundaries that the start is beyond, or on and about to pass. `invariants`
    hold at the start, `lasting` all along the phase. Behind the exact time `until` nothing is
    looked for: None is returned if nothing is reached up to it. `Undecided` is raised if balls
    cannot tell.
    """
    from flint import arb

    exact, structure = system.exact, system.structure
    field = exact.fields[configuration]
    crossed, orders = [], {}
    for b, boundary in enumerate(structure.boundaries[configuration]):
        try:
            begins = system.leading(exact.rows[boundary.row], configuration, invariants, state)
        except Undecided as unknown:
            raise Undecided(
                f"whether {boundary.name} is passed at the start of the phase: {unknown.reason}"
            ) from None
        if begins is None:
            continue
        if begins.sign > 0:
            crossed.append(b)
        else:
            orders[b] = begins.order
    if crossed:
        return PhaseEnd(arb(0), tuple(crossed), list(state))
    together: dict[Any, list[int]] = {}
    for b in orders:
        row = exact.rows[structure.boundaries[configuration][b].row]
        if any(lasting.reduce(product(row, field))):
            together.setdefault(_direction(lasting.reduce(row)), []).append(b)
    searches = [
        _WatchedBoundary(system, configuration, group[0], state, orders[group[0]])
        for group in together.values()
    ]

    def never(search: _WatchedBoundary) -> bool:
        return stays_negative(exact.rows[search.row], field, lasting, state, search.time)

    found = _earliest(searches, never, until)
    if found is None:
        return None
    time, behind, search = found
    reached = next(tuple(g) for g in together.values() if g[0] == search.boundary)
    return PhaseEnd(time, reached, behind)


def _earliest(
    searches: list[_WatchedBoundary],
    never: Callable[[_WatchedBoundary], bool],
    until: arb | None = None,
) -> tuple[arb, list[arb], _WatchedBoundary] | None:
    best: tuple[arb, list[arb], _WatchedBoundary] | None = None
    while searches:
        search = min(searches, key=lambda s: s.time)
        if best is not None and search.time > best[0]:
            break
        if until is not None and search.time > until:
            break
        if search.segment >= _LONGEST_SEARCH:
            raise Undecided(
                f"no boundary is reached, and {search.name} still could be",
                search.time,
                digits=False,
            )
        before = search.segment
        found = search.window()
        if found is not None:
            time, state = found
            searches.remove(search)
            if best is None or time < best[0]:
                best = (time, state, search)
            elif not time > best[0]:
                raise Undecided(
                    f"{best[2].name} and {search.name} are reached at one instant, or closer "
                    "together than the digits tell",
                    time.union(best[0]),
                )
        elif before < search.segment in _LOOKS and never(search):
            searches.remove(search)
    return best


def _direction(row: Sequence[Any]) -> tuple[Any, ...]:
    """Return a row divided by a positive factor, the same for all multiples by positive numbers."""
    leading = next(entry for entry in row if entry)
    size = leading if leading > 0 else -leading
    return tuple((entry / size) for entry in row)
