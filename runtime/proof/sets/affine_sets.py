"""Sets of states that are affine images of cubes, carried along a motion in balls.

A set is y = Z (1, e) + b, e in [-1, 1]^m and b in a small box: a centre, columns that are its
sides, and what roundings leave. An affine map moves it exactly. Where a boundary is reached at a
time that depends on the state, the mean value form with the saltation matrix over the whole set
is used,

    G(z) in G(z0) + DG(Z) (z - z0),    DG = (I - f n / (n f)) e^(B t),

and what DG varies by becomes further sides: only roundings are wrapped in boxes on the way (R.
Lohner, 1992; W. Kuehn, Rigorously computed orbits of dynamical systems without the wrapping
effect, Computing 61, 1998). States are followed by the time and by 1, so that the time that has
passed is known as a function of the state too.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.events.leading_derivative import Undecided

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["AffineSet", "affine_set", "with_time"]

_STEPS = 3  # of Newton's method for the time at which the centre arrives
_PASSES = 2  # of the mean value form
_LEAST = 2.0**-40  # of a time: the radius of its window at least


def with_time(rows: Sequence[Sequence[Any]], rate: int) -> arb_mat:
    """Return a matrix (N + 1, N + 1) on (y, 1) as one on (y, t, 1): (N + 2, N + 2).

    The time t runs at the rate 1 for a field and is kept by a reset, whose rate is 0.
    """
    from flint import arb_mat, fmpq_mat

    size = len(rows) - 1
    found = [[*row[:-1], 0, row[-1]] for row in rows]
    time = [0] * (size + 2)
    time[size + rate] = 1
    return arb_mat(fmpq_mat([*found[:-1], time, found[-1]]))


class AffineSet(NamedTuple):
    """The set of all y = Z (1, e) + b with the entries of e in [-1, 1] and b in a small box."""

    columns: arb_mat  # Z, (N + 2, 1 + m), exact: the centre, then the sides, of states, time and 1
    rest: arb_mat  # (N + 2, 1): balls around zero that contain b
    # derivatives of the map that led to this set, in some directions, at every state that it was
    # applied to; empty where they are not followed
    tangents: tuple[AffineSet, ...] = ()

    def mapped(self, matrix: arb_mat) -> AffineSet:
        """Return the image under a linear map (n, N + 2) of (y, t, 1), a set of n rows."""
        tangents = tuple(tangent.mapped(matrix) for tangent in self.tangents)
        return affine_set(matrix * self.columns, matrix * self.rest, tangents)

    @property
    def ranges(self) -> list[arb]:
        """The balls that contain all points, row by row."""
        rows = zip(self.columns.tolist(), self.rest.entries(), strict=True)
        return [row[0] + _around(_total(row[1:])) + b for row, b in rows]

    def reach(self, field: arb_mat, row: arb_mat, window: arb) -> AffineSet:
        """Return the set of states at which a function (1, N + 2) becomes zero along the field.

        Each state of the set gets there once in the ball `window` of times. An interval Newton step
        proves that of every state of the set, not only of those that also meet what is exactly
        known of the motion. `Undecided` is raised if the function's rate may be zero, or if the
        set is too large.
        """
        from flint import arb

        middle = window.mid()
        moved = self.mapped((field * middle).exp())
        hull = _matrix([[x] for x in moved.ranges])
        (level,) = moved.mapped(row).ranges
        late = _late(field, row, hull, level, arb(0, 2 * window.rad() + _LEAST * abs(middle)))
        shift = (field * late).exp()
        listed = moved.columns.tolist()
        centre = _arrived(field, row, _matrix([[entries[0]] for entries in listed]), late)
        there = shift * hull
        for _ in range(_PASSES):
            rates = field * there  # where the states are when they arrive
            change = _kept_zero(row, shift - (rates / (row * rates)[0, 0]) * (row * shift))
            found = _mean_value(moved, change, centre)
            there = _matrix([
                [x.intersection(y)] for x, y in zip(there.entries(), found.ranges, strict=True)
            ])  # fmt: skip
        tangents = tuple(_varied(change, tangent) for tangent in moved.tangents)
        return found._replace(tangents=tangents)


def affine_set(columns: arb_mat, rest: arb_mat, tangents: tuple[AffineSet, ...] = ()) -> AffineSet:
    """Return a set by columns (N + 2, 1 + m) in balls, whose radii are moved to the box."""
    middle = columns.mid()
    unsure = (columns - middle) * _ones(columns.ncols())
    return AffineSet(middle, rest + unsure, tangents)


def _mean_value(states: AffineSet, change: arb_mat, centre: arb_mat) -> AffineSet:
    """Return the image of a set under a map by the mean value form.

    `change` encloses the map's derivative over the set, and `centre` the image of its centre.
    """
    middles, listed = change.mid(), states.columns.tolist()
    spread = [
        [_around(_total(entries[1:])) + b]
        for entries, b in zip(listed, states.rest.entries(), strict=True)
    ]
    wide = ((change - middles) * _matrix(spread)).entries()
    carried = (middles * states.columns).tolist()
    arrived = [[c, *own[1:]] for c, own in zip(centre.entries(), carried, strict=True)]
    return affine_set(_with_sides(_matrix(arrived), wide), middles * states.rest)


def _kept_zero(row: arb_mat, matrix: arb_mat) -> arb_mat:
    """Return a matrix in balls with one row computed anew, so that it maps to a function's zeros.

    The matrix has to be known to map to where the function `row` is zero.
    """
    weights, rows = row.entries(), matrix.tolist()
    pivot = max(range(len(rows) - 1), key=lambda k: float(abs(weights[k])))
    others = [
        (x / weights[pivot], own)
        for k, (x, own) in enumerate(zip(weights, rows, strict=True))
        if k != pivot and not x.is_zero()
    ]
    rows[pivot] = [
        -sum((x * own[k] for x, own in others), 0 * rows[0][0].mid()) for k in range(len(rows))
    ]
    return _matrix(rows)


def _varied(matrix: arb_mat, vectors: AffineSet) -> AffineSet:
    """Return the images of vectors under all matrices in a ball of matrices.

    What they vary by becomes further sides.
    """
    middle = matrix.mid()
    wide = ((matrix - middle) * _matrix([[x] for x in vectors.ranges])).entries()
    return affine_set(_with_sides(middle * vectors.columns, wide), middle * vectors.rest)


def _with_sides(columns: arb_mat, wide: Sequence[arb]) -> arb_mat:
    """Return columns with one more side for each coordinate that varies by itself."""
    added = [k for k, x in enumerate(wide) if not x.is_zero()]
    zero = 0 * columns[0, 0].mid()
    return _matrix([
        [*own, *(wide[k].abs_upper() if i == k else zero for k in added)]
        for i, own in enumerate(columns.tolist())
    ])  # fmt: skip


def _late(field: arb_mat, row: arb_mat, hull: arb_mat, level: arb, late: arb) -> arb:
    """Return a ball of times at which each state of a hull reaches the function's zero, once.

    `Undecided` is raised if that is not proved of times inside the ball `late`.
    """
    from flint import arb

    first = late
    for _ in range(3):
        between = late.union(arb(0))  # the level is that at time 0
        slope = (row * (field * ((field * between).exp() * hull)))[0, 0]
        if not (slope > 0 or slope < 0):
            raise Undecided("the rate at which a boundary is reached is not known")
        newton = -level / slope
        if late is first and not first.contains_interior(newton):
            raise Undecided("the set reaches a boundary at times too far apart")
        late = late.intersection(newton)
    return late


def _arrived(field: arb_mat, row: arb_mat, centre: arb_mat, late: arb) -> arb_mat:
    """Return where the centre reaches the function's zero, at a time inside a ball."""
    for _ in range(_STEPS):
        middle = late.mid()
        there = (field * middle).exp() * centre
        rates = field * ((field * (late - middle)).exp() * there)
        late = late.intersection(middle - (row * there)[0, 0] / (row * rates)[0, 0])
    middle = late.mid()
    return (field * (late - middle)).exp() * ((field * middle).exp() * centre)


@lru_cache(maxsize=128)
def _ones(count: int) -> arb_mat:
    from flint import arb, arb_mat

    return arb_mat([[arb(0, 1)]] * count)


def _total(row: Sequence[arb]) -> arb:
    from flint import arb

    return sum((abs(x) for x in row), arb(0))


def _around(size: arb) -> arb:
    """Return the ball around zero with all numbers that are no larger in absolute value."""
    from flint import arb

    return arb(0, size.abs_upper())


def _matrix(rows: Sequence[Sequence[arb]]) -> arb_mat:
    from flint import arb_mat

    return arb_mat([list(row) for row in rows])
