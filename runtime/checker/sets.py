"""Sets of states through the phases of a motion, for the check of coverings.

A set is c + G e + b: a centre, sides G with e in [-1, 1]^m, and a small box b; of the states, the
time and 1. When the centre reaches a boundary is guessed in double precision; then it is shown
that every state of the set does about then, and nothing else before.
"""

from collections.abc import Sequence
from functools import cached_property
from math import hypot, isfinite
from typing import Any, NamedTuple

from flint import arb, arb_mat

from nonsmooth.runtime.checker.exact import Failure

__all__ = ["CarryingPhase", "StateSet", "TooWide", "matrix_of"]

_ORDER = 7  # of Taylor's polynomials
_DEEPEST = 14  # halvings of a phase
_WIDER = 1.25  # windows of times are so much wider than they have to be
_LEAST = 2.0**-44  # of a time: the width of its window at least
_GRID, _LONGEST = 0.1, 100_000  # steps of the guess, in radians of the fastest motion


class TooWide(Exception):
    """Nothing is shown of a set, though perhaps of parts of it."""


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

    def through(self, matrix: Any) -> "StateSet":
        """Return the image of the set and its tangents under a matrix of balls."""
        tangents = tuple(own.through(matrix) for own in self.tangents)
        moved = matrix * self.centre, matrix * self.sides, matrix * self.box
        return StateSet.of(*moved, tangents)

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

    def flow(self, time: Any) -> Any:
        """Return the flow over a time, as a matrix over (states, time, 1)."""
        return (self.matrix * time).exp()

    def timed(self, row: Any) -> Any:
        """Return a row (N + 1) as a row (1, N + 2) over (states, time, 1)."""
        return arb_mat([[*(arb(x) for x in row[:-1]), arb(0), arb(row[-1])]])

    def guess(self, centre: Any, row: Any) -> float:
        """Return about the time at which a function of the centre first rises through zero.

        It has to be negative before. `TooWide` is raised if the centre is not finite,
        `Failure` if the function does not rise: then it does not on parts of the set either.
        """
        step, ahead = self._ahead
        state = [float(x.mid()) for x in centre.entries()]
        normal = [float(x.mid()) for x in row.entries()]
        if not all(map(isfinite, state)):
            raise TooWide
        value, time = _product(normal, state), 0.0
        for _ in range(_LONGEST):
            behind = _moved(ahead, state)
            after = _product(normal, behind)
            if value < 0 < after or (time > 0 and value == 0 < after):
                return time + self._root(state, normal, step * value / (value - after))
            state, value, time = behind, after, time + step
        raise Failure("a state of a set does not come to the boundary that is stated")

    @cached_property
    def _ahead(self) -> tuple[float, list[list[float]]]:
        """A step of time, and the flow over it in double precision."""
        rates = arb_mat(self.near).eig(algorithm="approx")
        fastest = max(hypot(float(x.real.mid()), float(x.imag.mid())) for x in rates)
        fast = max(fastest, 0.05 * max(sum(map(abs, row)) for row in self.near), 1e-6)
        return _GRID / fast, _near(self.flow(arb(_GRID / fast)))

    def _root(self, state: list[float], normal: list[float], part: float) -> float:
        """Return the time at which a function is zero, by Newton's method from about then."""
        for _ in range(4):
            there = _moved(_near(self.flow(arb(part))), state)
            slope = _product(normal, _moved(self.near, there))
            if not slope:
                break
            part -= _product(normal, there) / slope
        return part

    def clear(
        self, states: StateSet, until: Any, watched: dict[str, int], ends: str | None = None
    ) -> None:
        """Show that no boundary is reached up to a time; `TooWide` if that is not shown.

        `watched` has the boundaries, with the order of the first derivative that is not zero
        at the start; `ends` is the one that is known to be negative at the end. A window in
        which a function rises is left to the next one, or to the end where it is known to be
        negative.
        """
        windows = [(arb(0), until, 0, sorted(watched))]
        while windows:
            begin, end, depth, names = windows.pop()
            middle = ((begin + end) / 2).mid()
            radius = (begin - middle).union(end - middle)  # the middle is rounded
            moved = states.through(self.flow(middle)).hull
            over = self.flow(radius) * moved
            left = []
            for name in names:
                first = watched[name] if begin == 0 else 0
                if self._over(name, first, moved, over, radius) < 0:
                    continue
                rises = name == ends or end < until
                if not (rises and self._over(name, 1, moved, over, radius) > 0):
                    left.append(name)
            if left and depth == _DEEPEST:
                raise TooWide
            if left:
                windows.append((middle, end, depth + 1, left))
                windows.append((begin, middle, depth + 1, left))

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
            row = self.timed(self.rows[name])
            for _ in range(first):
                row = row * self.matrix
            found = []
            for k in range(_ORDER):
                found.append(row.entries())
                row = row * self.matrix / (k + 1)
            self._taylor[name, first] = arb_mat(found), row
        rows, last = self._taylor[name, first]
        return rows, last

    def arrive(self, states: StateSet, row: Any, about: float) -> tuple[StateSet, Any, Any]:
        """Return the states where a function is zero, and times between which each gets there once.

        The arrival is near the time `about`. `TooWide` is raised if it is not shown.
        """
        time = arb(about)
        moved = states.through(self.flow(time))
        hull = moved.hull
        level = moved.through(row).hull[0, 0]
        rate = (row * (self.matrix * hull))[0, 0]
        if not rate > 0:
            raise TooWide
        size = (level / rate).abs_upper() * arb(_WIDER) + time * arb(_LEAST)
        late = arb(0, size.upper())
        shift = self.flow(late)
        there = shift * hull
        rates = self.matrix * there
        slope = (row * rates)[0, 0]
        before, after = time - size.upper(), time + size.upper()
        if not slope > 0 or not before > 0:
            raise TooWide
        first, last = (states.through(row * self.flow(t)).hull[0, 0] for t in (before, after))
        if not (first < 0 and last > 0):
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
        for _ in range(4):
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


def _product(one: Sequence[float], other: Sequence[float]) -> float:
    return sum(a * b for a, b in zip(one, other, strict=True))


def _moved(matrix: list[list[float]], state: list[float]) -> list[float]:
    return [_product(row, state) for row in matrix]
