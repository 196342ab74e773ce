"""Sets of states through the phases of a motion, for the check of coverings.

A set is c + G e + b: a centre, sides G with e in [-1, 1]^m, and a small box b; of the states, the
time and 1. When the centre reaches a boundary is guessed in double precision; then it is shown
that every state of the set does about then, and nothing else before.
"""

from collections.abc import Sequence
from functools import cached_property
from itertools import count
from math import ceil, frexp, ldexp
from typing import Any, NamedTuple

import numpy as np
from flint import arb, arb_mat, ctx, fmpq_mat

from nonsmooth.runtime.checker.stated.exact import Failure, Numbers

_ORDER = 7  # of Taylor's polynomials; more at a precision above 128 bits
_DEEPEST = 14  # halvings of a phase
_MOST_WINDOWS = 500_000  # of one phase
_WIDER = 1.5  # windows of times are so much wider than they have to be
_LEAST = 2.0**-44  # of a time: the width of its window at least
_CORRECTIONS = 3  # of the time at which a centre arrives
_SHARES = 64  # of a power of 2: radii of windows are rounded up to these
_GRID, _LONGEST = 0.1, 100_000  # steps of the guess, in radians of the fastest motion
_STEPS, _TERMS = 64, 20  # at once, and of Taylor's polynomial over a step


class TooWide(Exception):
    """Nothing is shown of a set, though perhaps of parts of it, or with more digits.

    It is raised where the radii of balls leave a sign open, a phase has too many windows, or a
    centre is not finite. `name` is the boundary of which it is not known whether it is reached, and
    `at` a ball of times, where these are known: since the phase's start, or since the motion's
    where `OneMotion` raises it, and then nothing else is reached before; `reason` says what is
    open.
    """

    def __init__(self, reason: str = "", name: str = "", at: Any = None) -> None:
        super().__init__(reason)
        self.reason, self.name, self.at = reason, name, at


def matrix_of(rows: Sequence[Sequence[Any]], runs: bool) -> Any:
    """Return a field or reset (N + 1, N + 1), over (states, 1), as a matrix over (states, time, 1).

    With `runs`, time has the rate 1, as for a field; else it stays, as for a reset.
    """
    size = len(rows) - 1
    found = arb_mat(size + 2, size + 2)
    for i, row in enumerate(rows):
        for j, x in enumerate(row):
            found[i + (i == size), j + (j == size)] = arb(x)
    if runs:
        found[size, size + 1] = arb(1)
    else:
        found[size, size] = arb(1)
    return found


def row_of(row: Numbers) -> Any:
    """Return an exact row (N + 1) over (states, 1) as a row (1, N + 2) over (states, time, 1)."""
    return arb_mat([[*map(arb, row[:-1]), arb(0), arb(row[-1])]])


class StateSet(NamedTuple):
    """A set of states: the centre, plus sides times numbers in [-1, 1], plus a box of roundings.

    It may carry derivatives of the map that led to it, along some directions, at all of
    its states.
    """

    centre: Any  # (n, 1), exact
    sides: Any  # (n, m), exact
    box: Any  # (n, 1), around zero
    tangents: "tuple[StateSet, ...]" = ()  # one set of derivatives for each direction

    @staticmethod
    def of(centre: Any, sides: Any, box: Any, tangents: "tuple[StateSet, ...]" = ()) -> "StateSet":
        """Return the set of matrices that need not be exact: their radii go into the box."""
        exact, straight = centre.mid(), sides.mid()
        ones = arb_mat(sides.ncols(), 1, [arb(0, 1)] * sides.ncols())
        unsure = box + (centre - exact) + (sides - straight) * ones
        return StateSet(exact, straight, unsure, tangents)

    @property
    def hull(self) -> Any:
        """A box (n, 1) around the set."""
        ones = arb_mat(self.sides.ncols(), 1, [arb(0, 1)] * self.sides.ncols())
        return self.centre + self.sides * ones + self.box

    @property
    def lengths(self) -> list[float]:
        """Approximate lengths of the sides, as sums of their entries."""
        return [
            sum(abs(float(x.mid())) for x in side)
            for side in zip(*self.sides.tolist(), strict=True)
        ]

    def through(self, matrix: Any) -> "StateSet":
        """Return the image of the set and its tangents under a matrix of balls."""
        tangents = tuple(own.through(matrix) for own in self.tangents)
        moved = matrix * self.centre, matrix * self.sides, matrix * self.box
        return StateSet.of(*moved, tangents)

    def hull_through(self, matrix: Any) -> Any:
        """Return a box (n, 1) around the image of the set under a matrix of balls."""
        return self._replace(tangents=()).through(matrix).hull

    def bent(self, matrix: Any, centre: Any, varies: Any) -> "StateSet":
        """Return the image under a map that is nearly linear, without tangents.

        The middle of `matrix` moves the sides, `centre` (n, 1) is the image of the centre,
        and the radii of `matrix` act on `varies` (n, 1).
        """
        straight = matrix.mid()
        sizes = [x.abs_upper() for x in ((matrix - straight) * varies).entries()]
        wide = [k for k, x in enumerate(sizes) if x > 0]
        columns = [
            [*own, *(arb(sizes[k]) if i == k else arb(0) for k in wide)]
            for i, own in enumerate((straight * self.sides).tolist())
        ]
        return StateSet.of(centre, arb_mat(columns), straight * self.box)


class CarryingPhase:
    """One configuration along which sets are carried.

    `field` is exact, (N + 1, N + 1); `rows` holds the boundaries, whose functions are
    negative inside.
    """

    def __init__(self, field: Any, rows: dict[str, Any]) -> None:
        self.exact, self.rows = field, rows
        self.matrix = matrix_of(field, runs=True)
        self.near = _near(self.matrix)
        self.size = len(field) + 1
        self._taylor: dict[Any, Any] = {}
        self._flows: dict[float, Any] = {}
        self._rows: dict[str, tuple[Any, Any]] = {}

    def flow(self, time: Any) -> Any:
        """Return the flow over a time, as a matrix over (states, time, 1)."""
        return (self.matrix * time).exp()

    @np.errstate(all="ignore")
    def guess(self, centre: Any, name: str) -> float:
        """Return about the time at which a boundary's function of the centre first rises to zero.

        It has to be negative before. `TooWide` is raised if the centre is not finite,
        `Failure` if the function does not rise: then it does not on parts of the set either.
        """
        step, powers = self._ahead
        state, time = np.array([float(x.mid()) for x in centre.entries()]), 0.0
        if not np.isfinite(state).all():
            raise TooWide
        seen, slopes = self._seen(name)
        for _ in range(_LONGEST // _STEPS):
            values = _times(seen, state)
            before, behind = values[:-1], values[1:]
            below = before < 0
            below[1 if not time else 0 :] |= before[1 if not time else 0 :] == 0
            rises = np.flatnonzero(below & (behind > 0))
            if len(rises):
                k = int(rises[0])
                part = step * before[k] / (before[k] - behind[k])
                terms = _times(slopes, _times(powers[k], state)).tolist()
                return float(time + k * step + _root(terms, part))
            if not np.isfinite(values).all():
                break
            state, time = _times(powers[-1], state), time + _STEPS * step
        raise Failure("a state of a set does not come to the boundary that is stated")

    @cached_property
    def fastest(self) -> float:
        """About the largest size of an eigenvalue; 0 where all of them are."""
        if not any(fmpq_mat(self.exact).charpoly().coeffs()[:-1]):
            return 0.0
        rates = arb_mat(self.near).eig(algorithm="approx")
        return max(float(abs(x).mid()) for x in rates)

    @cached_property
    def step(self) -> float:
        """A time that is short for the fastest motion of the phase."""
        size = max(sum(map(abs, row)) for row in self.near)
        return _GRID / max(self.fastest, 0.05 * size, 1e-6)

    @cached_property
    def _ahead(self) -> tuple[float, Any]:
        """A step of time, and the flows over no, one and more steps in double precision."""
        step, powers = self.step, [self.flow(arb(0))]
        flow = self.flow(arb(step))
        for _ in range(_STEPS):
            powers.append(flow * powers[-1])
        return step, np.array([_near(power) for power in powers])

    def _seen(self, name: str) -> tuple[Any, Any]:
        """A boundary's function after no, one and more steps, and Taylor's coefficients of it."""
        if name not in self._rows:
            slopes = [row_of(self.rows[name])]
            for k in range(1, _TERMS):
                slopes.append(slopes[-1] * self.matrix / k)
            near = np.array([_near(row)[0] for row in slopes])
            across = self._ahead[1].transpose(0, 2, 1)
            self._rows[name] = _times(across, near[0]), near
        return self._rows[name]

    def clear(
        self,
        states: StateSet,
        until: Any,
        watched: dict[str, int],
        ends: str | None = None,
        deepest: int = _DEEPEST,
    ) -> None:
        """Show that no boundary is reached up to a time; `TooWide` if that is not shown.

        `watched` has the boundaries, with the order of the first derivative that is not zero at the
        start; `ends` is the one that is known to be negative at the end. A window in which a
        function rises, and whose end does not tell its sign, is left to the next one, or to the end
        where it is known to be negative; one in which it falls is left to the one before it, or to
        the start, where it is not positive: both cannot meet. The times that are told begin where
        such a function begins to rise, so that all are negative before. The phase is halved
        `deepest` times at most, and so many windows are looked at as `_MOST_WINDOWS`.
        """
        windows, rising = [(arb(0), until, 0, sorted(watched))], dict[str, Any]()
        for number in count(1):
            if not windows:
                return
            begin, end, depth, names = windows.pop()
            middle = ((begin + end) / 2).mid()
            radius, near = self._around((begin - middle).union(end - middle))
            moved = states.hull_through(self.flow(middle))
            over = near * moved
            left = []
            for name in names:
                first = watched[name] if begin == 0 else 0
                if self._over(name, first, moved, over, radius) < 0:
                    rising.pop(name, None)
                    continue
                slope = self._over(name, 1, moved, over, radius)
                if slope < 0:
                    continue
                height = self._over(name, 0, moved, over, end - middle)
                if slope > 0 and height < 0:
                    rising.pop(name, None)
                elif slope > 0 and not height > 0 and (name == ends or end < until):
                    rising.setdefault(name, begin)
                else:
                    left.append(name)
            if left and (depth == deepest or number >= _MOST_WINDOWS):
                at = middle + radius
                for since in rising.values():
                    at = at.union(since)
                raise TooWide("", left[0], at)
            if left:
                windows.append((middle, end, depth + 1, left))
                windows.append((begin, middle, depth + 1, left))

    def _around(self, radius: Any) -> tuple[Any, Any]:
        """Return a ball around zero that holds another one, and the flow over it."""
        size, power = frexp(float(radius.abs_upper()))
        rounded = ldexp(ceil(size * _SHARES + 2.0**-20) / _SHARES, power)
        if rounded not in self._flows:
            self._flows[rounded] = self.flow(arb(0, rounded))
        return arb(0, rounded), self._flows[rounded]

    def _over(self, name: str, first: int, moved: Any, over: Any, radius: Any) -> Any:
        """Enclose a derivative over a window by Taylor's polynomial and a remainder."""
        rows, last = self._derivatives(name, first)
        found = (last * over)[0, 0]
        for value in reversed((rows * moved).entries()):
            found = found * radius + value
        return found

    def _derivatives(self, name: str, first: int) -> tuple[Any, Any]:
        """Return Taylor's coefficients from a derivative on, and the remainder's."""
        if (name, first) not in self._taylor:
            row = row_of(self.rows[name])
            for _ in range(first):
                row = row * self.matrix
            found = []
            for k in range(max(_ORDER, ctx.prec // 18)):
                found.append(row.entries())
                row = row * self.matrix / (k + 1)
            self._taylor[name, first] = arb_mat(found), row
        rows, last = self._taylor[name, first]
        return rows, last

    def arrive(
        self, states: StateSet, row: Any, about: Any, least: float = _LEAST
    ) -> tuple[StateSet, Any, Any]:
        """Return the states where a function is zero, and times between which each gets there once.

        The arrival is near the time `about`; the share `least` of it is the width of the window of
        times at least. `TooWide` is raised if it is not shown.
        """
        time = arb(about)
        moved = states.through(self.flow(time))
        hull = moved.hull
        level = moved.hull_through(row)[0, 0]
        rate = (row * (self.matrix * hull))[0, 0]
        if not rate > 0:
            raise TooWide
        size = (level / rate).abs_upper() * arb(_WIDER) + time * arb(least)
        late = arb(0, size.upper())
        shift = self.flow(late)
        there = shift * hull
        rates = self.matrix * there
        slope = (row * rates)[0, 0]
        before, after = time - size.upper(), time + size.upper()
        if not slope > 0 or not before > 0:
            raise TooWide
        # the function rises by more than its level on each side of the window
        if not (level / slope).abs_upper() < late.abs_upper():
            raise TooWide
        # by the mean value theorem, with what the time of arrival changes by; then once more,
        # for the rates at which the states that arrive are known to move
        centre = self._centre(moved.centre, row, late)
        for _ in range(2):
            change = shift - rates * (row * shift) / (row * rates)[0, 0]
            found = moved.bent(change, centre, hull - moved.centre)
            both = zip(there.entries(), found.hull.entries(), strict=True)
            rates = self.matrix * arb_mat([[x.intersection(y)] for x, y in both])
        tangents = tuple(
            own.bent(change, change.mid() * own.centre, own.hull) for own in moved.tangents
        )
        return found._replace(tangents=tangents), before, after

    def _centre(self, centre: Any, row: Any, late: Any) -> Any:
        """Return where one state is when the function is zero, for a time in a given ball."""
        for _ in range(_CORRECTIONS):
            at = late.mid()
            there = self.flow(at) * centre
            over = self.flow(late - at) * there
            found = at - (row * there)[0, 0] / (row * (self.matrix * over))[0, 0]
            if not late.overlaps(found):
                raise TooWide
            late = late.intersection(found)
        return self.flow(late) * centre


def _near(matrix: Any) -> list[list[float]]:
    """Return a matrix in double precision."""
    return [[float(x.mid()) for x in row] for row in matrix.tolist()]


def _times(rows: Any, numbers: Any) -> Any:
    """Return rows (..., n) times n numbers, summed in one order on every machine."""
    total = rows[..., 0] * numbers[0]
    for k in range(1, len(numbers)):
        total = total + rows[..., k] * numbers[k]
    return total


def _root(terms: list[float], part: float) -> float:
    """Return where a polynomial is zero, by Newton's method from about there."""
    for _ in range(4):
        value = slope = 0.0
        for term in reversed(terms):
            value, slope = value * part + term, slope * part + value
        if not slope:
            break
        part -= value / slope
    return part
