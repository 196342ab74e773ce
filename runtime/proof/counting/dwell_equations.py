"""The equations of any cycle in its dwell times, in balls, from the declared numbers.

Given the dwell times, closure and switching are linear in the start's coordinates q: together
they are G(u) (q, 1) = 0. The start is sought where what is exactly true of it leaves the
fewest coordinates. A boundary on which a phase exactly begins is met at time 0 whatever the
orbit; its condition is divided by the power of the time by which it vanishes there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.proof.counting.contraction import (
    Linear,
    Sides,
    balls_of,
    floats_around,
    middles_of,
)
from nonsmooth.runtime.proof.exact_tables import Tables
from nonsmooth.runtime.proof.invariants import invariants_of
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, product
from nonsmooth.runtime.proof.orbit_equations import phases_of
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.variational import MATRICES, Ahead, shooting_map

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["DwellProblem", "Given", "Setting", "setting_of"]

_TERMS = 48
_SERIES = 4  # norm of field and time up to which the divided flow is summed as a series
_KEPT = 40_000  # matrix exponentials


class Setting(NamedTuple):
    """The place of the start in the cycle, and which conditions hold at time 0 already."""

    rotation: int  # the phase at which the start is
    places: tuple[int, ...]  # states whose values there are the coordinates q
    # rows: the state at the start from (q, cosines and sines of the forcings, 1)
    embedding: tuple[tuple[Any, ...], ...]
    # order of the zero at time 0 of each phase's boundary function, phases counted from the start
    orders: tuple[int, ...]
    possible: bool  # the exact conditions of an orbit do not contradict each other


class Given(NamedTuple):
    """The conditions that close a cycle: forcings, and the sum of the dwell times."""

    pairs: tuple[tuple[int, int], ...] = ()  # states of the forcings, cos(w t) and sin(w t)
    speeds: tuple[Any, ...] = ()  # their w
    period: arb | None = None  # the sum of the dwell times
    unit: arb | None = None  # common period of the forcings: their times are sought in one of it


def setting_of(tables: Tables, cycle: ItineraryShape) -> Setting:
    """The setting with the fewest coordinates; all states, where the numbers are not exact."""
    size, count = len(tables.fields[0]) - 1, len(cycle)
    forced = [state for pair in cycle.structure.forcing for state in pair]
    starts: Sequence[Invariants] = [Invariants((), ())] * count
    if tables.exact:
        starts = invariants_of(tables, cycle).starts
    if not all(invariants.consistent for invariants in starts):
        return Setting(0, (), (), (0,) * count, False)

    def solved(invariants: Invariants) -> dict[int, Sequence[Any]]:
        pairs = zip(invariants.pivots, invariants.rows, strict=True)
        return {pivot: row for pivot, row in pairs if pivot not in forced}

    rotation = max(range(count), key=lambda k: (len(solved(starts[k])), -k))
    known = solved(starts[rotation])
    places = tuple(k for k in range(size) if k not in known and k not in forced)
    columns = [*places, *forced, size]
    embedding = [
        tuple(-known[k][j] if k in known else int(k == j) for j in columns) for k in range(size)
    ]
    embedding.append(tuple(int(j == size) for j in columns))
    orders = []
    for k in range(count):
        place = (rotation + k) % count
        row, field = tables.rows[cycle.rows[place]], tables.fields[cycle.configurations[place]]
        functions = map(starts[place].reduce, derivatives(row, field, size + 1, product))
        found = leading(functions, lambda _, reduced: any(reduced)) if tables.exact else None
        orders.append(0 if found is None else found.order)
    return Setting(rotation, places, tuple(embedding), tuple(orders), True)


class _Flow(NamedTuple):
    """The flow over a time, and the switching condition by the state in front of it."""

    flow: arb_mat
    ahead: Ahead


class DwellProblem:
    """Equations of a cycle in its dwell times, at the working precision.

    Unknowns are a forcing's time at the start, where there is one, and the dwell times from
    the setting's phase on; the last of these is none where their sum is given, and `last` is its
    range. `domain` is the range of the unknowns. The setting has to be possible. No coordinate
    of the start is larger than `largest` in the roots that come out.
    """

    def __init__(
        self,
        tables: Tables,
        cycle: ItineraryShape,
        setting: Setting,
        given: Given,
        domain: Sequence[tuple[float, float]],
        largest: float,
        last: tuple[float, float] | None = None,
    ) -> None:
        from flint import arb, arb_mat

        self.domain, self.setting, self.given = tuple(domain), setting, given
        self.largest, self.last = largest, last
        number = tables.number_at()
        self.phases = phases_of(tables, cycle.rotated(setting.rotation), number)
        self.embedding = arb_mat([list(map(number, row)) for row in setting.embedding])
        self.speeds = [arb(speed) for speed in given.speeds]
        self.first = int(bool(given.pairs))
        self._width = len(setting.places) + 1
        count = self.first + len(self.phases) - (given.period is not None)
        self._still = arb_mat(self.embedding.nrows(), self._width * count)
        # a forcing's time, and the dwell times; the last is what the others leave of the period
        left = [-int(j >= self.first) for j in range(count)]
        rates = [[int(own == j) for j in range(count)] for own in range(count)]
        rates += [left] if given.period is not None else []
        self._rates = [_times_unit(rate, self._width) for rate in rates]
        self._kept: dict[tuple[int, float, float, bool], _Flow] = {}
        self._norms = [_norm(phase.field) for phase in self.phases]
        self._powers = [_powers(phase.field, phase.row) for phase in self.phases]

    @property
    def unit(self) -> arb | None:
        """The period of the forcing's time, where that is an unknown."""
        return self.given.unit

    def linear(self, sides: Sides) -> Linear | None:
        """G over a box of unknowns; None where the last dwell time is outside of its range."""
        balls, middles = balls_of(sides), middles_of(sides)
        times = self._dwell(balls)
        if self.last is not None and (times[-1] < self.last[0] or times[-1] > self.last[1]):
            return None
        divided = [self._divides(place, time) for place, time in enumerate(times)]
        points = tuple((float(x), float(x)) for x in middles)
        centre, _, _ = self._passage(middles, points, divided, slopes=False)
        _, slopes, _ = self._passage(balls, sides, divided, slopes=True)
        trivial = any(
            order and not (time > 0) and not cut
            for order, time, cut in zip(self.setting.orders, times, divided, strict=True)
        )
        return Linear.of(centre, slopes, sides)._replace(trivial=trivial, largest=self.largest)

    def dwell(self, sides: Sides) -> list[arb]:
        """Dwell times over a box of unknowns, in the cycle's own order."""
        return self._own_order(self._dwell(balls_of(sides)))

    def begun_later(self, sides: Sides, phases: int) -> Iterator[Sides]:
        """Yield boxes of unknowns of the same orbits, begun a number of phases later.

        The itinerary has to be the same from there. A forced cycle gives one box for each of the
        three nearest turns, which may be in the domain.
        """
        from flint import arb

        balls = balls_of(sides)
        times = self._dwell(balls)
        turned = times[phases:] + times[:phases]
        rest = tuple(floats_around(t) for t in turned)[: len(sides) - self.first]
        if self.unit is None:
            yield rest
            return
        later = balls[0] + sum(times[:phases], arb(0))
        (begin, _), *_ = self.domain
        turns = round(float(((later - begin) / self.unit).mid()) - 0.5)
        for number in (turns - 1, turns, turns + 1):
            yield (floats_around(later - number * self.unit), *rest)

    def starts(self, sides: Sides, coordinates: Sequence[arb]) -> list[list[arb]]:
        """State, of length N, at the start of each phase in the cycle's own order, over a box.

        `coordinates` are those that the dwell times leave open.
        """
        from flint import arb, arb_mat

        whole = [False] * len(self.setting.orders)
        _, _, states = self._passage(balls_of(sides), sides, whole, slopes=False)
        column = arb_mat([[x] for x in (*coordinates, arb(1))])
        return self._own_order([(state * column).entries()[:-1] for state in states])

    def _own_order(self, found: list[Any]) -> list[Any]:
        cut = len(found) - self.setting.rotation
        return found[cut:] + found[:cut]

    def _dwell(self, unknowns: Sequence[arb]) -> list[arb]:
        times = list(unknowns[self.first :])
        if self.given.period is not None:
            times.append(self.given.period - sum(times, 0 * self.given.period))
        return times

    def _divides(self, place: int, time: arb) -> bool:
        """Whether a phase's switching condition is divided over a time."""
        order = self.setting.orders[place]
        return bool(order and self._norms[place] * abs(time).upper() <= _SERIES)

    def _passage(
        self, unknowns: Sequence[arb], sides: Sides, divided: Sequence[bool], *, slopes: bool
    ) -> tuple[arb_mat, list[arb_mat], list[arb_mat]]:
        """G, its derivatives if they are asked for, and the states at the starts of phases."""
        from flint import arb_mat

        start, begun = self._start(unknowns)
        width, count = self._width, len(unknowns) if slopes else 0
        changes = self._still if slopes else arb_mat(start.nrows(), 0)
        if self.first and slopes:
            changes = changes + begun * self._rates[0]
        passed = [
            self._flow(place, time, sides[own] if own < len(sides) else None, divided[place])
            for place, (own, time) in enumerate(enumerate(self._dwell(unknowns), self.first))
        ]
        rates = self._rates[self.first :] if slopes else [arb_mat(width, 0)] * len(passed)
        now = shooting_map(
            MATRICES,
            self.phases,
            [flow.flow for flow in passed],
            start,
            changes,
            rates,
            [flow.ahead for flow in passed],
        )
        change, moved = now.starts[-1] - start, now.variational - changes
        rows = [value.entries() for value in now.residual]
        rows += [[change[k, i] for i in range(width)] for k in self.setting.places]
        slope_rows = [slope.entries() for slope in now.slopes]
        slope_rows += [[moved[k, i] for i in range(width * count)] for k in self.setting.places]
        by = [
            arb_mat([row[j * width : (j + 1) * width] for row in slope_rows]) for j in range(count)
        ]
        return arb_mat(rows), by, now.starts[:-1]

    def _start(self, unknowns: Sequence[arb]) -> tuple[arb_mat, arb_mat]:
        """State at the start as a matrix on (q, 1), and its derivative by the forcing's time."""
        from flint import arb_mat

        count = len(self.setting.places)
        inner = arb_mat(count + 2 * len(self.given.pairs) + 1, count + 1)
        rate = arb_mat(inner.nrows(), count + 1)
        for k in range(count):
            inner[k, k] = 1
        for k, speed in enumerate(self.speeds):
            sine, cosine = (speed * unknowns[0]).sin_cos()
            place = count + 2 * k
            inner[place, count], inner[place + 1, count] = cosine, sine
            rate[place, count], rate[place + 1, count] = -speed * sine, speed * cosine
        inner[inner.nrows() - 1, count] = 1
        return self.embedding * inner, self.embedding * rate

    def _flow(
        self, place: int, time: arb, side: tuple[float, float] | None, divided: bool
    ) -> _Flow:
        if side is None:
            return self._computed(place, time, divided)
        key = (place, *side, divided)
        found = self._kept.get(key)
        if found is None:
            if len(self._kept) >= _KEPT:
                self._kept.clear()
            found = self._kept[key] = self._computed(place, time, divided)
        return found

    def _computed(self, place: int, time: arb, divided: bool) -> _Flow:
        """Flow and switching condition; over a box the wide factor has a small exponent."""
        field, row = self.phases[place].field, self.phases[place].row
        middle = time.mid()
        flow = (field * middle).exp()
        rest = time - middle
        if not rest.is_zero():
            flow = (field * rest).exp() * flow
        if divided:
            return _Flow(flow, self._divided(place, time))
        ahead = row * flow
        return _Flow(flow, Ahead(ahead, ahead * field))

    def _divided(self, place: int, time: arb) -> Ahead:
        """The row n exp(B t) / t^m without its first m terms, which vanish, and its derivative.

        The terms from k = K on, where s = |B| |t| <= S, add up to at most
        |n| |B|^m S^(K-m) / K! * 2, those of the derivative to |n| |B|^(m+1) S^(K-m-1) / (K-1)! * 2.
        """
        from flint import arb, arb_mat

        powers, order = self._powers[place], self.setting.orders[place]
        width = powers[0].ncols()
        row, rate = arb_mat(1, width), arb_mat(1, width)
        for k in range(_TERMS - 1, order - 1, -1):
            row = row * time + powers[k]
        for k in range(_TERMS - 1, order, -1):
            rate = rate * time + powers[k] * (k - order)
        size = sum((abs(x).upper() for x in self.phases[place].row.entries()), arb(0))
        tail = size * (1 + self._norms[place]) ** (order + 1) * arb(_SERIES) ** (_TERMS - order)
        tail = 2 * tail / arb(_TERMS).gamma()
        wide = arb_mat([[arb(0, tail.upper())] * width])
        return Ahead(row + wide, rate + wide)


def _times_unit(rate: Sequence[int], width: int) -> arb_mat:
    """Unit matrices side by side, each times a number: one change in each of their columns."""
    from flint import arb_mat

    return arb_mat([[x * int(i == k) for x in rate for k in range(width)] for i in range(width)])


def _norm(field: arb_mat) -> arb:
    """Largest absolute column sum of a matrix, rounded up."""
    from flint import arb

    size = field.nrows()
    sums = [
        sum((abs(field[i, j]).upper() for i in range(size)), arb(0)).upper() for j in range(size)
    ]
    return max(sums, key=float)


def _powers(field: arb_mat, row: arb_mat) -> list[arb_mat]:
    """Rows n B^k / k! for each k."""
    found = [row]
    for k in range(1, _TERMS):
        found.append(found[-1] * field / k)
    return found
