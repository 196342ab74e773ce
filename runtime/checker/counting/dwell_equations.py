"""The equations of any cycle in its dwell times, in balls, from what a file declares.

Given the dwell times, closure and switching are linear in the start's coordinates q: together
they are G(u) (q, 1) = 0. The start is sought where what is exactly true of it leaves the
fewest coordinates. A boundary on which a phase exactly begins is met at time 0 whatever the
orbit; its condition is divided by the power of the time by which it vanishes there. A phase of
exactly constant velocity is one affine map up to its boundary, and its dwell time no unknown.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from flint import arb, arb_mat, fmpq

from nonsmooth.runtime.checker.counting.contraction import (
    Linear,
    Sides,
    balls_of,
    floats_around,
    middles_of,
)
from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import Numbers, ToNumber, column, leading, reduced
from nonsmooth.runtime.core.rational_functions import pivot

_TERMS = 48
_FLOW_TERMS = 16
_TINY = arb(2) ** -40
_WIDE = 0.25  # norm of field and width of a side: the flow over a wider one is that of its halves
_WIDEST = 64  # but not over one that is wider still, which would take many
_SERIES = 4  # norm of field and time up to which the divided flow is summed as a series
_KEPT = 40_000  # matrix exponentials
_STATES = 300  # behind phases


class Setting:
    """Where the start of a cycle is sought, and which conditions hold whatever the orbit is.

    `still` has of each phase of exactly constant velocity the affine map up to its boundary and
    the row of its dwell time, where the state at its start is known. Nothing is eliminated where
    the sum of the dwell times is given (`timed`).
    """

    def __init__(self, declared: StatedSystem, *, timed: bool) -> None:
        size, count = declared.size, len(declared.steps)
        facts = declared.known if declared.rational else [([], [], [])] * count
        starts = [{pivot(row): row for row in begins} for begins, _, _ in facts]
        forced = declared.forced
        # whether the exact conditions of an orbit do not contradict each other
        self.possible = not any(size in start for start in starts)
        known = [{k: row for k, row in start.items() if k not in forced} for start in starts]
        self.rotation = max(range(count), key=lambda k: (len(known[k]), -k))
        fixed = known[self.rotation]
        # states whose values at the start are the coordinates q
        self.places = [k for k in range(size) if k not in fixed and k not in forced]
        columns = [*self.places, *forced, size]
        # rows: the state at the start from (q, cosines and sines of the forcings, 1)
        self.embedding = [
            [-fixed[k][j] if k in fixed else fmpq(int(k == j)) for j in columns]
            for k in range(size)
        ]
        self.embedding.append([fmpq(int(j == size)) for j in columns])
        self.order = [*range(self.rotation, count), *range(self.rotation)]  # of the phases
        self.still: dict[int, tuple[Any, Any]] = {}
        if declared.rational and not timed:
            stills = {k: _still(declared, k, facts[k][1]) for k in range(count)}
            self.still = {k: found for k, found in stills.items() if found is not None}
            if len(self.still) == count:
                self.still = {}
        self.zeros = [
            leading(step.exit, step.field, begins, 0)[0] if declared.rational else 0
            for step, (begins, _, _) in zip(declared.steps, facts, strict=True)
        ]  # order of the zero at time 0 of each phase's boundary function

    @property
    def searched(self) -> list[int]:
        """The phases whose dwell times are unknowns, from the start on."""
        return [k for k in self.order if k not in self.still]


class Given(NamedTuple):
    """The conditions that close a cycle: forcings, and the sum of the dwell times."""

    pairs: Sequence[Sequence[int]] = ()  # states of the forcings, cos(w t) and sin(w t)
    speeds: Sequence[Any] = ()  # their w
    period: Any = None  # the sum of the dwell times
    unit: Any = None  # common period of the forcings: their times are sought in one of it


class _Flow(NamedTuple):
    """What a phase does over a time: the state behind it, and its condition, a row below.

    Matrices (N + 2, N + 2) take the state in front of it, whose last entry does not matter.
    """

    whole: Any
    by_rate: Any  # times the rate of the state in front: the derivative by the time
    by_state: Any  # of a condition that is divided: what is added, times that state; or None


class _Carried(NamedTuple):
    """The state in front of a phase, and the condition of the one before it, a row below.

    All matrices have N + 2 rows, and act on (q, 1).
    """

    centre: Any  # in the middle of the box
    over: Any  # over the box
    slopes: Any  # the derivatives by all unknowns, side by side


class DwellEquations:
    """Equations of a cycle in its dwell times, at the working precision.

    Unknowns are a forcing's time at the start, where there is one, and the dwell times that are
    searched, from the start on; the last of these is none where the sum is given, and `last` is its
    range. `domain` is the range of the unknowns. No coordinate of the start is larger than
    `largest` in the roots that come out. The setting has to be possible.
    """

    def __init__(
        self,
        declared: StatedSystem,
        setting: Setting,
        number: ToNumber,
        given: Given,
        bounds: Mapping[str, tuple[float, float]],
        window: Sequence[tuple[float, float]],
        largest: Any,
    ) -> None:
        self.setting, self.given, self.largest, self.declared = setting, given, largest, declared
        names = [declared.dwell[k] for k in setting.searched]
        timed = given.period is not None
        self.last = bounds[names[-1]] if timed else None
        self.first = len(window)
        self.names = [*["forcing time"] * self.first, *names[: len(names) - timed]]
        self.domain: Sides = (*window, *(bounds[name] for name in self.names[self.first :]))

        def numbers(rows: Sequence[Sequence[Any]]) -> Any:
            return arb_mat([list(map(number, row)) for row in rows])

        size = declared.size + 1
        self._fields = [numbers(step.field) for step in declared.steps]
        self._rows = [numbers([step.exit]) for step in declared.steps]
        self._resets = [numbers(step.reset) for step in declared.steps]
        self._speeds = [_framed(field, arb_mat(1, size)) for field in self._fields]
        self._still = {
            k: _framed(self._resets[k] * numbers(ends), numbers([time]))
            for k, (ends, time) in setting.still.items()
        }
        self._follow = [bounds[declared.dwell[k]] for k in setting.order if k in setting.still]
        self._embedding = numbers([*setting.embedding, [0] * len(setting.embedding[0])])
        self._width = width = len(setting.places) + 1
        count = len(self.domain)
        self._unmoved = arb_mat(size + 1, width * count)
        # a forcing's time, and the dwell times; the last is what the others leave of the period
        rates = [[int(own == j) for j in range(count)] for own in range(count)]
        rates += [[-int(j >= self.first) for j in range(count)]] if timed else []
        self._rates = [_times_unit(rate, width) for rate in rates]
        self._kept: dict[tuple[int, float, float, bool], _Flow] = {}
        self._known: dict[tuple[int, bool, Sides], _Carried] = {}
        self._norms = [_norm(field) for field in self._fields]
        self._powers = [_powers(*each) for each in zip(self._fields, self._rows, strict=True)]

    @property
    def surplus(self) -> bool:
        """Whether a period is given: the closure of one coordinate then follows from the energy."""
        return self.last is not None and not self.first

    def linear(self, sides: Sides, *, between: bool = False) -> Linear | None:
        """Return G over a box of unknowns; None where the last dwell time is out of its range.

        The slopes are those between the middle of the box and any other point of it, or, if it is
        so asked, `between` any two points of it.
        """
        balls, middles = balls_of(sides), middles_of(sides)
        times = self._times(balls)
        if self.last is not None and (times[-1] < self.last[0] or times[-1] > self.last[1]):
            return None
        carried = self._carried(sides, between=between)
        met: list[Any] = []
        followed: list[Any] = []
        for k, behind in zip(self.setting.order, carried[1:], strict=True):
            (followed if k in self._still else met).append(_rows(behind, self.declared.size + 1))
        change = _Carried(
            *(end - start for end, start in zip(carried[-1], carried[0], strict=True))
        )
        rows = [*met, *(_rows(change, k) for k in self.setting.places), *followed]
        width = self._width
        centre, natural = (arb_mat([row[kind] for row in rows]) for kind in (0, 1))
        slopes = [
            arb_mat([row[2][j * width : (j + 1) * width] for row in rows])
            for j in range(len(sides))
        ]
        offsets = [ball - middle for ball, middle in zip(balls, middles, strict=True)]
        mean = centre
        for slope, offset in zip(slopes, offsets, strict=True):
            mean = mean + slope * offset
        over = _sharper(mean, natural)
        trivial = any(
            self.setting.zeros[k] and not time > 0 and not self._divides(k, time)
            for k, time in zip(self.setting.searched, times, strict=True)
        )
        count = centre.nrows() - len(followed)
        longest = sum(times, arb(0)).upper()
        follow = zip(self._follow, over.tolist()[count:], strict=True)
        asked = [self._follows(*each, longest) for each in follow]
        if followed:
            centre, over, *slopes = (arb_mat(m.tolist()[:count]) for m in (centre, over, *slopes))
        return Linear(centre, tuple(slopes), over, offsets, self.largest, asked, trivial)

    def _follows(self, side: tuple[float, float], row: Numbers, scale: Any) -> list[Any]:
        """Return the row of a condition: that a dwell time, a row on (q, 1), is in its range.

        With s any number in [0, 1] it is a + (b - a) s, or, where there is no upper end b, the
        time a + T (1 - s) / s. Any T > 0 will do.
        """
        share, (low, high) = arb("0.5 +/- 0.5"), side
        if high < math.inf:
            return [*row[:-1], row[-1] - (low + (arb(high) - low) * share)]
        return [*(share * x for x in row[:-1]), share * (row[-1] - low + scale) - scale]

    def dwell(self, sides: Sides, coordinates: Numbers) -> dict[str, Any]:
        """Return all dwell times by name, over a box of unknowns and coordinates of the start."""
        searched = zip(self.setting.searched, self._times(balls_of(sides)), strict=True)
        found = {self.declared.dwell[k]: time for k, time in searched}
        if self._still:
            point = column((*coordinates, arb(1)))
            behind = zip(self.setting.order, self._carried(sides, between=False)[1:], strict=True)
            for k, own in behind:
                if k in self._still:
                    found[self.declared.dwell[k]] = (own.over * point).entries()[-1]
        return found

    def begun_later(self, sides: Sides, phases: int) -> Iterator[Sides]:
        """Yield boxes of unknowns of the same orbits, begun a number of phases later.

        The itinerary has to be the same from there. A forced cycle gives one box for each of the
        three nearest turns, which may be in the domain.
        """
        balls = balls_of(sides)
        times = self._times(balls)
        cut = sum(1 for k in self.setting.order[:phases] if k not in self.setting.still)
        turned = times[cut:] + times[:cut]
        rest = tuple(floats_around(t) for t in turned)[: len(sides) - self.first]
        if not self.first:
            yield rest
            return
        later = balls[0] + sum(times[:cut], arb(0))
        for time in self.turned(later):
            yield (floats_around(time), *rest)

    def turned(self, time: Any) -> Iterator[Any]:
        """Yield a time of the forcing whole turns earlier: the three nearest to the domain."""
        (begin, _), *_ = self.domain
        turns = round(float(((time - begin) / self.given.unit).mid()) - 0.5)
        for number in (turns - 1, turns, turns + 1):
            yield time - number * self.given.unit

    def starts(self, sides: Sides, coordinates: Numbers) -> dict[int, Any]:
        """Return the state (N + 1, 1) at the start of each phase, over a box of unknowns.

        `coordinates` are those that the dwell times leave open.
        """
        point = column((*coordinates, arb(1)))
        carried = zip(self.setting.order, self._carried(sides, between=False), strict=False)
        return {k: arb_mat((own.over * point).tolist()[:-1]) for k, own in carried}

    def carried(self, state: Numbers, dwell: Mapping[str, Any]) -> list[Any]:
        """Return the state (N) where the start is sought, from that where the cycle begins."""
        found = column((*state, arb(1)))
        for k in range(self.setting.rotation):
            flow = (self._fields[k] * dwell[self.declared.dwell[k]]).exp()
            found = self._resets[k] * (flow * found)
        return list(found.entries()[:-1])

    def _times(self, unknowns: Numbers) -> list[Any]:
        times = list(unknowns[self.first :])
        if self.given.period is not None:
            times.append(self.given.period - sum(times, arb(0)))
        return times

    def _divides(self, place: int, time: Any) -> bool:
        """Return whether a phase's switching condition is divided over a time."""
        order = self.setting.zeros[place]
        return bool(order and self._norms[place] * abs(time).upper() <= _SERIES)

    def _carried(self, sides: Sides, *, between: bool) -> list[_Carried]:
        """Return what is carried over a box of unknowns: to the start, and behind each phase.

        Boxes that differ in later unknowns share it.
        """
        found = [self._begins(sides)]
        met = self.first
        for place, k in enumerate(self.setting.order):
            met += k not in self._still
            key = place, between, sides[:met]
            if key not in self._known:
                if len(self._known) >= _STATES:
                    self._known.clear()
                self._known[key] = self._behind(k, met - 1, sides, found[-1], between=between)
            found.append(self._known[key])
        return found

    def _behind(
        self, place: int, own: int, sides: Sides, front: _Carried, *, between: bool
    ) -> _Carried:
        """Return what is carried through a phase, whose dwell time is an unknown if it moves.

        The state behind it is Phi(m) y + (t - m) Phi(T) B y, with B y from the state in front, so
        that what cancels there does not count. Slopes but those `between` any two points have all
        unknowns behind the own one in their middle.
        """
        if place in self._still:
            return _Carried(*(self._still[place] * matrix for matrix in front))
        time, middle = (
            self._times(x)[own - self.first] for x in (balls_of(sides), middles_of(sides))
        )
        divided = self._divides(place, time)
        if own < len(sides):
            flow = self._flow(place, time, sides[own], divided)
            at = self._flow(place, middle, (float(middle), float(middle)), divided)
        else:
            flow, at = (self._computed(place, t, divided) for t in (time, middle))
        moved = flow.by_rate * (self._speeds[place] * front.over)
        if flow.by_state is not None:
            moved += flow.by_state * front.over
        over = _sharper(at.whole * front.over + moved * (time - middle), flow.whole * front.over)
        through = flow if between or own == len(sides) else at
        slopes = through.whole * front.slopes + moved * self._rates[own]
        return _Carried(at.whole * front.centre, over, slopes)

    def _begins(self, sides: Sides) -> _Carried:
        """Return the start over a box of unknowns."""
        over, by = self._start(balls_of(sides))
        slopes = self._unmoved + by * self._rates[0] if self.first else self._unmoved
        return _Carried(self._start(middles_of(sides))[0] if self.first else over, over, slopes)

    def _start(self, unknowns: Numbers) -> tuple[Any, Any]:
        """Return the start as a matrix on (q, 1), and its derivative by the forcing's time."""
        count = len(self.setting.places)
        inner = arb_mat(count + 2 * len(self.given.pairs) + 1, count + 1)
        rate = arb_mat(inner.nrows(), count + 1)
        for k in range(count):
            inner[k, k] = 1
        for k, speed in enumerate(self.given.speeds):
            sine, cosine = (speed * unknowns[0]).sin_cos()
            place = count + 2 * k
            inner[place, count], inner[place + 1, count] = cosine, sine
            rate[place, count], rate[place + 1, count] = -speed * sine, speed * cosine
        inner[inner.nrows() - 1, count] = 1
        return self._embedding * inner, self._embedding * rate

    def _flow(self, place: int, time: Any, side: tuple[float, float], divided: bool) -> _Flow:
        key = (place, *side, divided)
        found = self._kept.get(key)
        if found is None:
            if len(self._kept) >= _KEPT:
                self._kept.clear()
            low, high = side
            middle = low + (high - low) / 2
            found = None
            if _WIDE < self._norms[place] * (high - low) < _WIDEST and low < middle < high:
                # the halves recur where boxes are cut, and the flow over a wide side is known badly
                halves = [
                    self._flow(place, arb(a).union(arb(b)), (a, b), divided)
                    for a, b in ((low, middle), (middle, high))
                ]
                whole = _hull(*(half.whole for half in halves))
                found = _Flow(whole, whole, None)
                if divided:
                    added = _hull(*(half.by_state for half in halves))
                    found = _Flow(whole, _hull(*(half.by_rate for half in halves)), added)
            found = self._kept[key] = found or self._computed(place, time, divided)
        return found

    def _computed(self, place: int, time: Any, divided: bool) -> _Flow:
        """Return flow and switching condition over a time that may be wide."""
        flow = _flow_over(self._fields[place], self._norms[place], time)
        behind = self._resets[place] * flow
        if not divided:
            whole = _framed(behind, self._rows[place] * flow)
            return _Flow(whole, whole, None)
        none = arb_mat(1, flow.ncols())
        row, rate = self._divided(place, time)
        by_state = _framed(arb_mat(flow.nrows(), flow.ncols()), rate)
        return _Flow(_framed(behind, row), _framed(behind, none), by_state)

    def _divided(self, place: int, time: Any) -> tuple[Any, Any]:
        """Return the row n exp(B t) / t^m without its first m terms, and its derivative.

        The first terms vanish. Those from k = K on, where s = |B| |t| <= S, add up to at most
        |n| |B|^m S^(K-m) / K! * 2, those of the derivative to |n| |B|^(m+1) S^(K-m-1) / (K-1)! * 2.
        """
        powers, order = self._powers[place], self.setting.zeros[place]
        width = powers[0].ncols()
        row, rate = arb_mat(1, width), arb_mat(1, width)
        for k in range(_TERMS - 1, order - 1, -1):
            row = row * time + powers[k]
        for k in range(_TERMS - 1, order, -1):
            rate = rate * time + powers[k] * (k - order)
        size = sum((abs(x).upper() for x in self._rows[place].entries()), arb(0))
        tail = size * (1 + self._norms[place]) ** (order + 1) * arb(_SERIES) ** (_TERMS - order)
        tail = 2 * tail / arb(_TERMS).gamma()
        wide = arb_mat([[arb(0, tail.upper())] * width])
        return row + wide, rate + wide


def _still(declared: StatedSystem, place: int, kept: Any) -> tuple[Any, Any] | None:
    """Return the map to its boundary, and the row of its dwell time, of a phase that moves evenly.

    With f the constant velocity the time is t = -n y / n f, and the end is y + f t. None is
    returned where the velocity is not constant by what is known all along the phase, or along the
    boundary.
    """
    step, size = declared.steps[place], declared.size
    rates = [reduced(row, kept) for row in step.field]
    if any(any(row[:-1]) for row in rates):
        return None
    velocity = [row[-1] for row in rates]
    speed = sum((n * f for n, f in zip(step.exit, velocity, strict=True) if n and f), fmpq(0))
    if not speed:
        return None
    declared.exactly.divisors.append(speed)
    time = [-n / speed for n in step.exit]
    ends = [[f * time[j] + int(i == j) for j in range(size + 1)] for i, f in enumerate(velocity)]
    return ends, time


def _rows(carried: _Carried, place: int) -> list[list[Any]]:
    """Return one row of each matrix."""
    return [[matrix[place, j] for j in range(matrix.ncols())] for matrix in carried]


def _framed(square: Any, row: Any) -> Any:
    """Return a matrix with a row below it, and a column of zeros."""
    return arb_mat([[*line, 0] for line in (*square.tolist(), *row.tolist())])


def _hull(first: Any, second: Any) -> Any:
    """Return a matrix of balls around those of two matrices."""
    pairs = zip(first.entries(), second.entries(), strict=True)
    return arb_mat(first.nrows(), first.ncols(), [x.union(y) for x, y in pairs])


def _sharper(first: Any, second: Any) -> Any:
    """Return what two matrices of balls around one have in common, entry by entry.

    Where one of the balls is unbounded it is the other one.
    """
    entries = [
        (x.intersection(y) if y.is_finite() else x) if x.is_finite() else y
        for x, y in zip(first.entries(), second.entries(), strict=True)
    ]
    return arb_mat(first.nrows(), first.ncols(), entries)


def _flow_over(field: Any, norm: Any, time: Any) -> Any:
    """Return exp (B t) over a time that may be wide: a Taylor polynomial around its middle m.

    With s = |B| |t - m| the terms from K >= 2 s on add up to at most 2 s^K / K! times the flow over
    the time m.
    """
    middle = time.mid()
    flow = (field * middle).exp()
    width = abs(time - middle).upper()
    if width.is_zero():
        return flow
    reach = (norm * width).upper()
    if not 2 * reach <= _FLOW_TERMS:
        return (field * arb(0, width)).exp() * flow
    term, power, total, left, k = flow, arb(1), flow, arb(2), 0
    while k < 2 * reach or left > _TINY:
        k += 1
        left, power = (left * reach / k).upper(), (power * width).upper()
        term = field * term / k
        # even powers of a number around zero are not negative
        total = total + term * (arb(0, power) if k % 2 else arb(0).union(power))
    size, tail = flow.nrows(), arb(0, (left * _norm(flow)).upper())
    return total + arb_mat(size, size, [tail] * size**2)


def _times_unit(rate: Sequence[int], width: int) -> Any:
    """Return unit matrices side by side, each times a number: one change in each column."""
    return arb_mat([[x * int(i == k) for x in rate for k in range(width)] for i in range(width)])


def _norm(field: Any) -> Any:
    """Return the largest absolute column sum of a matrix, rounded up."""
    size = field.nrows()
    sums = [sum((abs(field[i, j]).upper() for i in range(size)), arb(0)) for j in range(size)]
    largest = arb(0)
    for total in sums:
        largest = largest.max(total.upper())
    return largest.upper()


def _powers(field: Any, row: Any) -> list[Any]:
    """Return the rows n B^k / k! for each k."""
    found = [row]
    for k in range(1, _TERMS):
        found.append(found[-1] * field / k)
    return found
