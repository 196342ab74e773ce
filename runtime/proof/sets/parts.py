"""Parts of sets of states: what affine conditions leave of them, with fewer sides, in halves.

A part is contained in what is returned, which may be larger. Where a condition leaves but a thin
part, one side is given by the others and by the function of the condition, so that oblique cuts
stay thin (as constraints are used on zonotopes: J. Scott, D. Raimondo, G. Marseglia and R. Braatz,
Constrained zonotopes, Automatica 69, 2016).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import floor, prod
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet, affine_set

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["fewer_sides", "halves", "hull", "kept", "lifted", "united", "values_over", "within"]

_PLACES = 2.0**24  # of a side that are told apart where it is cut
_POINT = 1e-3  # of a scale: smaller boxes count as points when they are united
_UNITED = 1  # coordinates of sets that are united: boxes of more lose their directions
_APART = 0.3  # the sine of the angle between directions, at least
_THIN = 2.0  # times the longest half of a side: then a function takes its place


def values_over(rows: arb_mat, states: AffineSet) -> arb_mat:
    """Balls around linear functions of (y, t, 1).

    Parameters
    ----------
    rows : arb_mat (k, N + 2)
    states : AffineSet

    Returns
    -------
    arb_mat (k, 1)
    """
    return (rows * states.columns) * _unit(states.columns.ncols()) + rows * states.rest


def hull(states: AffineSet) -> arb_mat:
    """Balls around (y, t, 1).

    Parameters
    ----------
    states : AffineSet

    Returns
    -------
    arb_mat (N + 2, 1)
    """
    return states.columns * _unit(states.columns.ncols()) + states.rest


def kept(states: AffineSet, row: arb_mat, *, zero: bool = False) -> AffineSet | None:
    """What is left where a function is not negative, or zero.

    Parameters
    ----------
    states : AffineSet
    row : arb_mat (1, N + 2)
        Exact or not.
    zero : bool
        Whether the function is zero there.

    Returns
    -------
    AffineSet or None
        A set that contains it; None if there is nothing.
    """
    from flint import arb

    entries = (row * states.columns).entries()
    loose = (row * states.rest)[0, 0]
    share = entries[0] + loose
    low, high = share.lower(), share.upper()
    sizes = [x.abs_upper() for x in entries[1:]]
    total = sum(sizes, arb(0)).upper()
    low, high = (low - total).lower(), (high + total).upper()
    if high < 0 or (zero and low > 0):
        return None
    if low >= 0 and not zero:
        return states
    ends = []
    for entry in entries[1:]:
        least, most = -1.0, 1.0
        if entry > 0 or entry < 0:
            small = entry.abs_lower()
            # e = 1 - q leaves at most high - q |a|, which must not be negative
            least = _cut(high, small)
            most = -_cut(-low, small) if zero else 1.0
            if entry < 0:
                least, most = -most, -least
        if least > most:
            return None
        ends.append((least, most))
    if any(end != (-1.0, 1.0) for end in ends):
        states = _shortened(states, ends)
        entries = (row * states.columns).entries()
    if not sizes:
        return states
    pivot = max(range(len(sizes)), key=lambda k: float(entries[1 + k].abs_lower()))
    own = entries[1 + pivot].abs_lower()
    if not own > 0:
        return states
    if zero or high < _THIN * own:
        return _substituted(states, row, entries, pivot, arb(0) if zero else high)
    return states


def _cut(room: arb, size: arb) -> float:
    """The least e of 1 >= e >= -1 for which room - (1 - e) size may be not negative, or less."""
    first = float((1 - room / size).lower())
    if not first > -1:
        return -1.0
    return max(-1.0, min((floor(first * _PLACES) - 1) / _PLACES, 2.0))


def _shortened(states: AffineSet, ends: Sequence[tuple[float, float]]) -> AffineSet:
    """The part with each e between two numbers, exact in binary."""
    from flint import arb, arb_mat

    size = len(ends) + 1
    matrix = arb_mat(size, size)
    matrix[0, 0] = arb(1)
    for k, (least, most) in enumerate(ends, 1):
        matrix[k, 0] = arb((least + most) / 2)
        matrix[k, k] = arb((most - least) / 2)
    return affine_set(states.columns * matrix, states.rest)


def _substituted(
    states: AffineSet, row: arb_mat, entries: Sequence[arb], pivot: int, high: arb
) -> AffineSet:
    """The part where a function is from 0 to `high`, which takes the place of one side."""
    from flint import arb, arb_mat

    size, own = len(entries), entries[1 + pivot]
    matrix = arb_mat(size, size)
    for k in range(size):
        if k == 1 + pivot:
            matrix[k, k] = high / 2 / own
            continue
        matrix[k, k] = arb(1)
        matrix[1 + pivot, k] = -entries[k] / own
    matrix[1 + pivot, 0] += high / 2 / own
    columns = states.columns * matrix
    if high.is_zero():
        columns = _without(columns, 1 + pivot)
    side = arb_mat([[x[1 + pivot]] for x in states.columns.tolist()])
    shift = (row * states.rest)[0, 0] / own
    return affine_set(columns, states.rest - side * shift)


def fewer_sides(states: AffineSet, facts: Invariants, timed: bool, box: arb_mat) -> AffineSet:
    """A parallelepiped about a set, with as many sides as its states have free coordinates.

    It has the directions of the largest sides, or those of the coordinates if the set is smaller
    so; the facts give the other coordinates exactly.

    Parameters
    ----------
    states : AffineSet
    facts : Invariants
        What is exactly true of the states.
    timed : bool
        Whether the time counts; else it is set to 0.
    box : arb_mat (N + 2, 1)
        In which the states are too.

    Returns
    -------
    AffineSet
        That contains it.
    """
    from flint import arb, arb_mat

    size = states.columns.nrows() - 2
    free = [k for k in range(size) if k not in facts.pivots]
    places = [*free, size] if timed else free
    count = len(places)
    lift = _lift(facts, size, timed)
    if not count:
        return affine_set(lift, arb_mat(size + 2, 1))
    listed, rest = states.columns.tolist(), states.rest.entries()
    own = arb_mat([listed[k][1:] for k in places])
    boxed = arb_mat([[rest[k]] for k in places])
    frame = _frame([[float(x) for x in row] for row in own.tolist()])
    try:
        inward = frame.inv()
    except ZeroDivisionError:
        frame = inward = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
    sides = inward * own * arb_mat([[arb(0, 1)]] * own.ncols()) + inward * boxed
    sizes = [x.abs_upper() for x in sides.entries()]
    straight = [listed[k][0] for k in places]
    around, given = hull(states).entries(), box.entries()
    inside = [_common(around[k], given[k]) for k in places]
    if _volume([x.rad() for x in inside]) <= _volume(sizes) * abs(frame.det()).mid():
        frame = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
        straight = [x.mid() for x in inside]
        sizes = [(x - x.mid()).abs_upper() for x in inside]
    rows = [
        [middle, *(frame[i, j] * x for j, x in enumerate(sizes))]
        for i, middle in enumerate(straight)
    ]
    one = [arb(1), *(arb(0),) * count]
    return affine_set(lift * arb_mat([*rows, one]), arb_mat(size + 2, 1))


def lifted(box: Sequence[tuple[float, float]], facts: Invariants, size: int) -> AffineSet:
    """The states whose free coordinates are in a box, at the time 0.

    Parameters
    ----------
    box : sequence of (float, float)
        Bounds of the coordinates that the facts leave free, in order.
    facts : Invariants
    size : int
        How many states there are.

    Returns
    -------
    AffineSet
    """
    from flint import arb, arb_mat

    rows = []
    for k, (low, high) in enumerate(box):
        middle, half = (arb(high) + arb(low)) / 2, (arb(high) - arb(low)) / 2
        rows.append([middle, *(half if j == k else arb(0) for j in range(len(box)))])
    rows.append([arb(1), *(arb(0),) * len(box)])
    return affine_set(_lift(facts, size, False) * arb_mat(rows), arb_mat(size + 2, 1))


def united(
    one: AffineSet, other: AffineSet, facts: Invariants, timed: bool, scales: Sequence[float]
) -> AffineSet | None:
    """A box about two sets for which the facts hold, if it is no larger than both together.

    Parameters
    ----------
    one, other : AffineSet
        As `fewer_sides` gives them.
    facts : Invariants
    timed : bool
        Whether the time counts.
    scales : sequence of float, length N
        Of the states.

    Returns
    -------
    AffineSet or None
    """
    from flint import arb, arb_mat

    size = one.columns.nrows() - 2
    places = [k for k in range(size) if k not in facts.pivots]
    units = [scales[k] for k in places]
    if timed:
        places, units = [*places, size], [*units, 1.0]
    if len(places) > _UNITED:
        return None
    boxes = [(a, b) for a, b in zip(hull(one).entries(), hull(other).entries(), strict=True)]
    around = [boxes[k][0].union(boxes[k][1]) for k in places]
    total = prod(float(x.rad()) + _POINT * u for x, u in zip(around, units, strict=True))
    apart = 0.0
    for k in (0, 1):
        sizes = zip(places, units, strict=True)
        apart += prod(float(boxes[j][k].rad()) + _POINT * u for j, u in sizes)
    if total > apart:
        return None
    count = len(places)
    rows = [
        [x.mid(), *(x.rad() if j == i else arb(0) for j in range(count))]
        for i, x in enumerate(around)
    ]
    rows.append([arb(1), *(arb(0),) * count])
    return affine_set(_lift(facts, size, timed) * arb_mat(rows), arb_mat(size + 2, 1))


def within(box: arb_mat, row: Sequence[Any]) -> arb_mat:
    """A box about the states of a box for which a function is not positive.

    Parameters
    ----------
    box : arb_mat (N + 2, 1)
    row : Row, length N + 1
        Exact.

    Returns
    -------
    arb_mat (N + 2, 1)
        The same box where there are none.
    """
    from flint import arb, arb_mat

    found = box.entries()
    terms = [arb(x) * y for x, y in zip(row[:-1], found, strict=False)]
    least = sum((x.lower() for x in terms), arb(row[-1])).lower()
    for k, x in enumerate(row[:-1]):
        if x:
            bound = (found[k].lower() if x > 0 else found[k].upper()) - least / arb(x)
            other = found[k].lower() if x > 0 else found[k].upper()
            if (bound < found[k].upper()) if x > 0 else (bound > found[k].lower()):
                if (bound < other) if x > 0 else (bound > other):
                    return box
                found[k] = other.union(bound)
    return arb_mat([[x] for x in found])


def _common(one: arb, other: arb) -> arb:
    """What two balls that meet have in common, or one of them."""
    return one.intersection(other) if one.overlaps(other) else one


def _volume(sizes: Sequence[arb]) -> arb:
    from flint import arb

    return prod((x.mid() for x in sizes), start=arb(1))


def _frame(sides: list[list[float]]) -> arb_mat:
    """Directions, as columns, of the sides of a parallelepiped about others, exact."""
    from flint import arb_mat

    matrix = np.array(sides)
    spans = np.abs(matrix).sum(axis=1)
    unit = np.where(spans > 0, spans, 1.0)
    scaled = (matrix / unit[:, None]).T
    lengths = np.sqrt((scaled * scaled).sum(axis=1))
    order = np.argsort(-lengths, kind="stable")
    least = min(_APART, 0.5 / len(matrix) ** 0.5)  # some axis is always as far from the others
    found: list[np.ndarray] = []
    basis: list[np.ndarray] = []
    for column in [*scaled[order], *np.eye(len(matrix))]:
        if len(found) == len(matrix):
            break
        length = float(np.sqrt(column @ column))
        left = column
        for own in basis:
            left = left - (own @ left) * own
        apart = float(np.sqrt(left @ left))
        if apart > least * length:
            found.append(column / length)
            basis.append(left / apart)
    return arb_mat((unit[:, None] * np.array(found).T).tolist())


@lru_cache(maxsize=256)
def _lift(facts: Invariants, size: int, timed: bool) -> arb_mat:
    """(y, t, 1) from (free coordinates, t, 1) or, without time, (free coordinates, 1)."""
    from flint import arb, arb_mat

    free = [k for k in range(size) if k not in facts.pivots]
    given = dict(zip(facts.pivots, facts.rows, strict=True))
    count = len(free) + timed
    found = arb_mat(size + 2, count + 1)
    for k in range(size):
        if k in given:
            for i, j in enumerate(free):
                found[k, i] = arb(-given[k][j])
            found[k, count] = arb(-given[k][size])
        else:
            found[k, free.index(k)] = arb(1)
    if timed:
        found[size, len(free)] = arb(1)
    found[size + 1, count] = arb(1)
    return found


def halves(states: AffineSet, scales: Sequence[float]) -> tuple[AffineSet, AffineSet]:
    """Two halves, divided along the side that is longest in units of some scales.

    Parameters
    ----------
    states : AffineSet
        With a side at least.
    scales : sequence of float, length N
        Of the states.

    Returns
    -------
    tuple of AffineSet
    """
    listed = states.columns.tolist()
    lengths = [
        max(float(abs(listed[k][j])) / s for k, s in enumerate(scales))
        for j in range(1, states.columns.ncols())
    ]
    longest = max(range(len(lengths)), key=lengths.__getitem__)
    whole = [(-1.0, 1.0)] * len(lengths)
    below, above = list(whole), list(whole)
    below[longest], above[longest] = (-1.0, 0.0), (0.0, 1.0)
    return _shortened(states, below), _shortened(states, above)


def _without(columns: arb_mat, place: int) -> arb_mat:
    from flint import arb_mat

    return arb_mat([[x for j, x in enumerate(row) if j != place] for row in columns.tolist()])


@lru_cache(maxsize=128)
def _unit(count: int) -> arb_mat:
    from flint import arb, arb_mat

    return arb_mat([[arb(1)], *([arb(0, 1)] for _ in range(count - 1))])
