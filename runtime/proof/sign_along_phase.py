"""Whether an affine function stays negative along a phase, for all its times.

Time is cut into segments about as long as half a radian. On each the function is its Taylor
polynomial, whose last coefficient is a ball: the derivative of that order over the segment,
bounded by the exponential of the field over it. Windows of time are halved until each is
decided: by value, slope and curvature; by rising towards the next window, which is decided
too, or towards the end where the function is zero; and where it is zero at the start by the
sign of its first derivative that is not.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.expansion import Expansion

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["Crossed", "EventFunctions", "ExactZeros"]

_ORDER = 12
_DEEPEST = 60  # halvings of a window
MOST_SEGMENTS = 20_000
_TOUCHING = 2  # halvings behind which a window may be one about a maximum
_CLOSE = "it comes closer to zero than the digits tell"


class Crossed(Exception):
    """A function is proved to be positive at a `time` inside the phase."""

    def __init__(self, time: arb) -> None:
        super().__init__()
        self.time = time


class ExactZeros(NamedTuple):
    """Where a function along a phase is exactly zero: at the start, at the end or at neither."""

    order: int  # at the start the derivatives of lower orders vanish; 0 if the function does not
    # at the end: 1 if it rises to zero, 2 if its rate is not negative there; 0 if it is not zero
    last: int
    falls: bool = False  # whether the derivative of that order is known to be negative at the start


class EventFunctions:
    """The affine functions along one phase, expanded segment by segment at the working precision.

    The field is (N + 1, N + 1) and the start (N + 1, 1), both for (y, 1); the dwell time is
    positive. `Undecided` is raised if there are too many segments.
    """

    def __init__(self, field: arb_mat, start: arb_mat, dwell: arb) -> None:
        from flint import arb

        self.dwell = dwell
        self.scales, norm = _scales_of(middle_of(field))
        self.field = _diagonal([1 / s for s in self.scales]) * field * _diagonal(self.scales)
        self.end = range_of(dwell).upper()
        half = arb(2) ** (-math.ceil(math.log2(norm)) - 1) if norm else self.end
        self.half = half
        count = float(self.end / (2 * half))
        if not count < MOST_SEGMENTS:
            raise Undecided(f"it lasts {count:.3g} radians, too many to look at", digits=False)
        self.count = max(1, math.floor(count))
        while not 2 * half * self.count >= self.end:
            self.count += 1
        over = (self.field * arb(0, half)).exp()
        first, step = (self.field * half).exp(), (self.field * (2 * half)).exp()
        state = first * (_diagonal([1 / s for s in self.scales]) * start)
        self.middles = [(state, over * state)]
        for _ in range(self.count - 1):
            state = step * state
            self.middles.append((state, over * state))

    def function(self, row: arb_mat) -> list[Expansion]:
        """Return the expansion on each segment of an affine function (1, N + 1) of (y, 1)."""
        from flint import arb_poly

        last = row * _diagonal(self.scales)
        unit, rows = self.field * self.half, [last.entries()]
        for k in range(1, _ORDER + 1):
            last = last * unit / k
            rows.append(last.entries())
        below = matrix(rows[:-1])
        return [
            Expansion(
                2 * self.half * number,
                self.half,
                arb_poly([*range_of(below * middle).entries(), range_of(last * over)[0, 0]]),
            )
            for number, (middle, over) in enumerate(self.middles)
        ]

    def crossed(self, function: list[Expansion]) -> arb | None:
        """Return a time inside the phase at which a function is proved to be positive, or None.

        Only some times are looked at, so None proves nothing.
        """
        found = (time for time, value in self._sampled(function) if value > 0)
        return next((time for time in found if time > 0 and time < self.dwell), None)

    def _sampled(self, function: list[Expansion]) -> Iterator[tuple[arb, arb]]:
        """Yield some times with the function's values there."""
        from flint import arb

        for number, expansion in enumerate(function):
            last = min(1.0, float(self._place(self.end, number)))
            for u in range(5):
                place = arb(u * (last + 1) / 4 - 1)
                yield expansion.time(place), expansion.at(0, place)

    def stays_negative(self, function: list[Expansion], zeros: ExactZeros) -> None:
        """Prove that a function is negative inside the phase.

        `Crossed` is raised if it is positive somewhere, `Undecided` if its sign cannot be decided.
        """
        self._decided(function, zeros, touching=False)

    def touched(self, function: list[Expansion], zeros: ExactZeros) -> tuple[int, arb, arb] | None:
        """Return the one window of time, about a maximum, outside of which a function is negative.

        The window is the number of a segment and two places in it. There the function is concave,
        rises at the beginning and falls at the end. If it is negative there too, it is negative
        inside the phase. None is returned if there is no such window. `Crossed` is raised if the
        function is positive outside of such windows, `Undecided` if its sign there is not decided.
        """
        left = [
            (number, begin, end)
            for number, begin, end in self._decided(function, zeros, touching=True)
            if not _stays_below(function[number], begin, end)
        ]
        if not left or len({number for number, *_ in left}) > 1:
            return None
        number, begin, end = left[0]
        for _, low, high in left[1:]:
            if low != end:
                return None
            end = high
        curve = function[number]
        if curve.at(1, begin) > 0 and curve.at(1, end) < 0:
            return number, begin, end
        return None

    def _decided(
        self, function: list[Expansion], zeros: ExactZeros, *, touching: bool
    ) -> list[tuple[int, arb, arb]]:
        """Return the windows about maxima that stay undecided, by segment and places.

        There are none unless `touching` allows them: all other windows have to be decided.
        """
        from flint import arb

        found = []
        for number, expansion in enumerate(function):
            final = number == self.count - 1
            last = self._place(self.end, number).upper() if final else arb(1)
            order = zeros.order if number == 0 else 0
            # where the last window may not rise: it has nothing negative or zero behind it
            falling = last if final and not zeros.last else None
            slow = last if final and zeros.last > 1 else None
            falls = zeros.falls and number == 0
            left = self._segment(expansion, last, order, falls, falling, slow, touching=touching)
            found += [(number, begin, end) for begin, end in left]
        return found

    def _place(self, time: arb, number: int) -> arb:
        """Return the place u of a time in a segment."""
        return time / self.half - (2 * number + 1)

    def _segment(
        self,
        function: Expansion,
        last: arb,
        order: int,
        falls: bool,
        falling: arb | None,
        slow: arb | None,
        *,
        touching: bool,
    ) -> list[tuple[arb, arb]]:
        from flint import arb

        left: list[tuple[arb, arb]] = []
        windows = [(arb(-1), last, 0)]
        while windows:
            begin, end, depth = windows.pop()
            places = begin.union(end)
            middle = places.mid()
            if order and begin == -1:
                done = bool(function.at(order, places) < 0)
                done = done or bool(falls and function.at(order + 1, places) < 0)
            else:
                window = function.over(places)
                rising = falling is None or end < falling
                done = bool((rising and window.rates > 0) or window.values < 0)
                # the rate falls to one that is not negative
                done = done or bool(slow is not None and end >= slow and window.curve < 0)
                if not done and touching and depth >= _TOUCHING and window.curve < 0:
                    left.append((begin, end))
                    continue
                if not done and window.value > 0:
                    time = function.time(middle)
                    if time < self.dwell:
                        raise Crossed(time)
            if done:
                continue
            if depth == _DEEPEST:
                raise Undecided(_CLOSE)
            windows += [(middle, end, depth + 1), (begin, middle, depth + 1)]
        return left


def _stays_below(function: Expansion, begin: arb, end: arb) -> bool:
    """Whether value and slope at an end show that a function, concave in a window, is negative."""
    if function.at(0, begin) < 0 and function.at(1, begin) < 0:
        return True
    return bool(function.at(0, end) < 0 and function.at(1, end) > 0)


def _diagonal(entries: Sequence[float]) -> arb_mat:
    from flint import arb_mat

    found = arb_mat(len(entries), len(entries))
    for k, entry in enumerate(entries):
        found[k, k] = entry
    return found


def _scales_of(field: arb_mat) -> tuple[list[float], float]:
    """Return units of the states, powers of two, that make the field small, and its norm in them.

    The field is (N + 1, N + 1) on (y, 1), the units are N + 1, and the norm is per unit of time.
    They are computed in floating point and only choose how time is cut: the matrix is balanced
    (Parlett & Reinsch, 1969).
    """
    size = field.nrows()
    entries = [[abs(float(field[i, j].mid())) for j in range(size)] for i in range(size)]
    scales = [1.0] * size
    for _ in range(3 * size):
        for k in range(size):
            down = sum(entries[i][k] * scales[k] / scales[i] for i in range(size) if i != k)
            across = sum(entries[k][j] * scales[j] / scales[k] for j in range(size) if j != k)
            if down > 0 and across > 0:
                scales[k] *= 2.0 ** round(math.log2(across / down) / 2)
    norm = max(sum(entries[i][j] * scales[j] / scales[i] for j in range(size)) for i in range(size))
    return scales, norm
