"""The first boundary that a phase reaches, proved in balls.

A boundary function is negative inside its configuration. From where it is known to be
negative a window is opened and decided by its second derivative over the window: it stays
negative, or it rises and ends positive, then it is crossed exactly once in it. Else the
window is halved. A window as short as the digits allow is a contact that they cannot tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.validation.enclosures import EnclosedSystem, Facts, Undecided, product

if TYPE_CHECKING:
    from flint import arb

__all__ = ["LONGEST_SEARCH", "first_crossing"]

LONGEST_SEARCH = 2e4  # radians of the fastest oscillation in one phase

_Function = tuple[Any, list[Any]]  # constant, and coefficients of the functions of time


class _Search:
    """One boundary, and for how long it is proved not to be reached."""

    def __init__(
        self,
        system: EnclosedSystem,
        configuration: int,
        boundary: int,
        state: Sequence[arb],
        order: int,
    ) -> None:
        from flint import arb

        self.system, self.configuration, self.boundary = system, configuration, boundary
        self.name = system.structure.boundaries[configuration][boundary].name
        constant, value = system.along(configuration, boundary, state)
        self.value: _Function = (constant, value)
        self.slope: _Function = (0, system.derivative(configuration, value))
        self.curve: _Function = (0, system.derivative(configuration, self.slope[1]))
        fastest = max(
            (abs(float(part.mid())) for pair in system.modes[configuration] for part in pair),
            default=0.0,
        )
        self.unit = arb(1)  # about a radian, a power of 2 so that times stay exact
        while self.unit * fastest > 1:
            self.unit /= 2
        while fastest and self.unit * 2 * fastest < 1:
            self.unit *= 2
        self.longest = self.unit * LONGEST_SEARCH
        self.shortest = self.unit * arb(2) ** (-(system.bits // 2))
        self.time, self.step = arb(0), self.unit
        self.windows = 0
        if order:
            self._leave(order)

    def sum(self, function: _Function, time: arb, functions: list[Any] | None = None) -> Any:
        """A sum of the functions of time at a time, or over a ball of times."""
        constant, coefficients = function
        if functions is None:
            functions = self.system.functions(self.configuration, time)
        total = 0 * time + constant
        for c, phi in zip(coefficients, functions, strict=True):
            total += c * phi
        return total

    def _leave(self, order: int) -> None:
        """Go on to where a boundary is left for sure that is zero at the start.

        Its derivatives below `order` are zero there and that one is negative.
        """
        from flint import arb

        function = self.value
        for _ in range(order):
            function = (0, self.system.derivative(self.configuration, function[1]))
        while not self.sum(function, arb(self.step / 2, self.step / 2)) < 0:
            self._halve("is left so slowly that digits are missing")
        self.time = self.step

    def _halve(self, why: str) -> None:
        self.step /= 2
        if self.step < self.shortest:
            raise Undecided(f"{self.name} {why}", self._contact())

    def _contact(self) -> arb:
        """About where the function is largest, by Newton's method on its slope, if close."""
        time = self.time
        for _ in range(60):
            curve = self.sum(self.curve, time).mid()
            if curve == 0:
                break
            time = (time - self.sum(self.slope, time).mid() / curve).mid()
            if not abs(time - self.time) < self.unit:
                break
        else:
            if time >= self.time:
                return self.time.union(2 * time - self.time)
        return self.time.union(self.time + self.step)

    def window(self) -> arb | None:
        """Decide one window; the time of the crossing if it is in it."""
        from flint import arb

        self.windows += 1
        start, step = self.time, self.step
        radius = step / 2
        middle, end = start + radius, start + step
        functions = self.system.functions(self.configuration, middle)
        curve = self.sum(self.curve, arb(middle, radius))
        rate = self.sum(self.slope, middle, functions)
        slope = rate + curve * arb(0, radius)
        if not slope < 0:
            half = radius * radius / 4
            whole = self.sum(self.value, middle, functions) + rate * arb(0, radius)
            if not whole + curve * arb(half, half) < 0:
                last = self.sum(self.value, end) if slope > 0 else None
                if last is not None and last > 0:
                    return self._newton(arb(middle, radius), slope)
                if last is None or not last < 0:
                    self._halve("is reached tangentially, or comes closer than the digits tell")
                    return None
        self.time, self.step = end, 2 * step
        return None

    def _newton(self, times: arb, slope: arb) -> arb:
        """The one crossing in a ball of times over which the slope is positive."""
        while True:
            middle = times.mid()
            value = self.sum(self.value, middle)
            better = times.intersection(middle - value / slope)
            if 2 * better.rad() >= times.rad():
                return better
            times = better
            near = self.sum(self.slope, times.mid()) + self.sum(self.curve, times) * (
                times - times.mid()
            )
            if near > 0:
                slope = near

    def never(self) -> bool:
        """Whether the function stays negative for ever, by the sizes of its terms.

        Only drift and oscillations that do not grow are judged.
        """
        system, (total, coefficients) = self.system, self.value
        total = total + 0 * self.time
        shapes = system.structure.shapes[self.configuration]
        for shape, (rate, frequency) in zip(shapes, system.modes[self.configuration], strict=True):
            pair = [coefficients[place] for place in shape.places]
            width = 2 if shape.oscillates else 1
            constant = rate.is_zero() and (not shape.oscillates or frequency.is_zero())
            kept = 2 if constant and not shape.oscillates else 1
            if any(not c.is_zero() for c in pair[kept * width :]):
                return False
            if constant and not shape.oscillates:
                total += pair[0]
                if shape.length > 1:
                    if not pair[1] <= 0:
                        return False
                    total += pair[1] * self.time
                continue
            if not rate <= 0:
                return False
            size = sum(c * c for c in pair[:width]).sqrt()
            total += size * (rate * self.time).exp()
        return bool(total < 0)


def first_crossing(
    system: EnclosedSystem,
    configuration: int,
    facts: Facts,
    lasting: Facts,
    state: Sequence[arb],
) -> tuple[arb, tuple[int, ...]] | None:
    """When a phase ends, and which boundaries are reached then; None if it never does.

    Time 0 is for boundaries that the start is beyond, or on and about to pass.

    Parameters
    ----------
    system : EnclosedSystem
    configuration : int
    facts, lasting : Facts
        Of the start, and those that stay true along the phase.
    state : sequence of arb
        The start.

    Raises
    ------
    Undecided
        If the balls cannot tell.
    """
    from flint import arb

    exact, structure = system.exact, system.structure
    field = exact.fields[configuration]
    crossed, orders = [], {}
    for b, boundary in enumerate(structure.boundaries[configuration]):
        try:
            order, sign = system.leading(exact.rows[boundary.row], configuration, facts, state)
        except Undecided as unknown:
            raise Undecided(
                f"whether {boundary.name} is passed at the start of the phase: {unknown.reason}"
            ) from None
        if sign > 0:
            crossed.append(b)
        elif sign < 0:
            orders[b] = order
    if crossed:
        return arb(0), tuple(crossed)
    together: dict[Any, list[int]] = {}
    for b in orders:
        row = exact.rows[structure.boundaries[configuration][b].row]
        if any(lasting.reduce(product(row, field))):
            together.setdefault(_direction(lasting.reduce(row)), []).append(b)
    searches = [
        _Search(system, configuration, group[0], state, orders[group[0]])
        for group in together.values()
    ]
    found = _earliest([search for search in searches if not search.never()])
    if found is None:
        return None
    time, search = found
    return time, next(tuple(g) for g in together.values() if g[0] == search.boundary)


def _earliest(searches: list[_Search]) -> tuple[arb, _Search] | None:
    best: tuple[arb, _Search] | None = None
    while searches:
        search = min(searches, key=lambda s: s.time)
        if best is not None and search.time > best[0]:
            break
        if not search.time < search.longest:
            raise Undecided(
                f"no boundary is reached, and {search.name} still could be",
                search.time,
                digits=False,
            )
        time = search.window()
        if time is not None:
            searches.remove(search)
            if best is None or time < best[0]:
                best = (time, search)
            elif not time > best[0]:
                raise Undecided(
                    f"{best[1].name} and {search.name} are reached at one instant, or closer "
                    "together than the digits tell",
                    time.union(best[0]),
                )
        elif search.windows % 64 == 0 and search.never():
            searches.remove(search)
    return best


def _direction(row: Sequence[Any]) -> tuple[Any, ...]:
    """A row up to a positive factor: what is zero at the same instants."""
    leading = next(entry for entry in row if entry)
    size = leading if leading > 0 else -leading
    return tuple((entry / size) for entry in row)
