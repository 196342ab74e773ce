"""Many affine sets of states at once, in double precision with bounds of all roundings.

A set is c + S e + b: a centre, sides S with e in [-1, 1]^m, and a box b around zero. An affine
map moves it but for roundings, which the box takes up: the product of two matrices of doubles is
off by at most n u |A| |B|, in whatever order it is summed (S. M. Rump, Verification methods:
rigorous results using floating-point arithmetic, Acta Numerica 19, 2010). It is summed in one
order, so that each processor finds the same sets: libraries of linear algebra have an order for
each. States end with 1, so that affine maps are matrices.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from flint import arb_mat

Floats = NDArray[np.float64]

LONGEST = 256  # terms of one sum for which the bounds hold
ROUNDING = 2.0**-42  # of the sum of absolute values: more than a few such sums are off by
_UNDERFLOW = 2.0**-900
_APART = 0.3  # the sine of the angle between directions that are kept, at least
_SURE = 0.1  # of a side's share of a function: the rest may be no larger where it takes its place
_WIDER = 1.0  # on average: then it does not take its place
_THIN = 2.0  # times the largest share of a side: then a function takes its place


def upward(sizes: Any) -> Any:
    """Upper bounds of the exact results of a few operations with numbers >= 0.

    `sizes` are the results in doubles.
    """
    return sizes * (1 + ROUNDING) + _UNDERFLOW


def product(left: Floats, right: Floats) -> Floats:
    """Products (..., k, m) of matrices (..., k, n) and (..., n, m), summed term by term."""
    if not left.shape[-1]:
        return left @ right  # zeros
    found: Floats = left[..., :, 0, None] * right[..., 0, None, :]
    each = np.empty_like(found)
    for term in range(1, left.shape[-1]):
        found += np.multiply(left[..., :, term, None], right[..., term, None, :], out=each)
    return found


class Rounded(NamedTuple):
    """Matrices (..., k, n) whose entries are between middle - radius and middle + radius."""

    middle: Floats
    radius: Floats

    @staticmethod
    def of(matrix: arb_mat) -> Rounded:
        """Middles and radii in doubles that enclose a matrix (k, n) of balls."""
        from flint import arb

        listed = matrix.tolist()
        middle = np.array([[float(x.mid()) for x in row] for row in listed])
        loose = [
            [float((x - arb(m)).abs_upper()) for x, m in zip(row, own, strict=True)]
            for row, own in zip(listed, middle.tolist(), strict=True)
        ]
        exact = np.array(loose)
        return Rounded(middle, np.where(exact > 0, upward(exact), 0.0))

    def __matmul__(self, other: Rounded) -> Rounded:
        size, further = np.abs(self.middle), np.abs(other.middle)
        radius = product(size, other.radius) + product(self.radius, further + other.radius)
        rounded = ROUNDING * product(size, further)
        return Rounded(product(self.middle, other.middle), upward(radius + rounded))

    def rows(self, chosen: Any) -> Rounded:
        """The rows that an index chooses."""
        return Rounded(self.middle[..., chosen, :], self.radius[..., chosen, :])


@dataclass(frozen=True)
class ManySets:
    """B sets of states in R^n, each c + S e + b with e in [-1, 1]^m and b in a box around 0."""

    centre: Floats  # c, (B, n)
    sides: Floats  # S, (B, n, m)
    box: Floats  # bounds of abs(b), (B, n)

    @staticmethod
    def of_boxes(low: Floats, high: Floats) -> ManySets:
        """Boxes from `low` to `high`, (B, d) each, as sets in R^(d + 1).

        The last coordinate of their states is 1.
        """
        middle = (low + high) / 2
        half = upward(np.maximum(high - middle, middle - low))
        count, size = middle.shape
        sides = np.zeros((count, size + 1, size))
        sides[:, range(size), range(size)] = half
        centre = np.concatenate([middle, np.ones((count, 1))], axis=1)
        return ManySets(centre, sides, np.zeros_like(centre))

    def __len__(self) -> int:
        return len(self.centre)

    def __getitem__(self, chosen: Any) -> ManySets:
        """Some of the sets, by a mask or indices."""
        return ManySets(self.centre[chosen], self.sides[chosen], self.box[chosen])

    @property
    def spread(self) -> Floats:
        """Bounds (B, n) of the distances of the states from the centre, by coordinate."""
        found: Floats = upward(np.abs(self.sides).sum(axis=2) + self.box)
        return found

    @property
    def hull(self) -> tuple[Floats, Floats]:
        """Least and largest coordinates of the states, (B, n) each."""
        off = self.spread + ROUNDING * np.abs(self.centre)
        return self.centre - upward(off), self.centre + upward(off)

    def mapped(self, matrix: Rounded) -> ManySets:
        """Images in R^k under a matrix (k, n), or under one for each set, (B, k, n)."""
        size = np.abs(matrix.middle)
        unsure = matrix.radius + ROUNDING * size
        reach = np.abs(self.centre) + self.spread
        box = _times(size, self.box) + _times(unsure, reach)
        centre, sides = _times(matrix.middle, self.centre), product(matrix.middle, self.sides)
        return ManySets(centre, sides, upward(box))

    def shares(self, rows: Rounded) -> tuple[Floats, Floats, Floats]:
        """Linear functions of the states as a + w e + r: a, w and a bound of |r|.

        For rows (k, n) or (B, k, n) these are (B, k), (B, k, m) and (B, k).
        """
        size = np.abs(rows.middle)
        unsure = rows.radius + ROUNDING * size
        reach = np.abs(self.centre) + self.spread
        loose = _times(size, self.box) + _times(unsure, reach)
        weights = product(rows.middle, self.sides)
        return _times(rows.middle, self.centre), weights, upward(loose)

    def ranges(self, rows: Rounded) -> tuple[Floats, Floats]:
        """Least and largest values (B, k) of linear functions, of rows (k, n) or (B, k, n)."""
        middle, weights, loose = self.shares(rows)
        off = upward(np.abs(weights).sum(axis=2) + loose)
        return middle - off, middle + off

    def cut(self, row: Rounded, zero: bool = False) -> tuple[ManySets, NDArray[np.bool_]]:
        """Sets around the states where a function is not negative, and flags (B,).

        The function has the row (1, n) or (B, 1, n). If `zero`, the sets are around the states
        where it is zero. A flag says whether there may be any such state.
        """
        middle, weights, loose = (x[:, 0] for x in self.shares(row))
        size = np.abs(weights)
        total = upward(size.sum(axis=1))
        top, bottom = _above(middle + loose + total), _below(middle - loose - total)
        alive: NDArray[np.bool_] = ~(top < 0)
        if zero:
            alive &= ~(bottom > 0)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            least = _below(1 - top[:, None] / size)
            most = _above(-1 - bottom[:, None] / size) if zero else np.ones_like(size)
        least = np.where(least > -1, np.minimum(least, 2.0), -1.0)
        most = np.where(most < 1, np.maximum(most, -2.0), 1.0)
        alive &= ~np.any(least > most, axis=1)
        turned = weights < 0
        least, most = np.where(turned, -most, least), np.where(turned, -least, most)
        sets, moved, half = self._shortened(least, most, alive)
        middle = middle + (weights * moved).sum(axis=1)
        loose = upward(loose + ROUNDING * (np.abs(middle) + total))
        weights = weights * half
        high = np.zeros_like(top) if zero else np.maximum(top, 0.0)
        return sets._substituted(middle, weights, loose, high, bottom, zero), alive

    def _shortened(
        self, least: Floats, most: Floats, alive: NDArray[np.bool_]
    ) -> tuple[ManySets, Floats, Floats]:
        """Parts of the sets with each e in an interval, and the middles and halves of these.

        Sets that are not alive are not cut.
        """
        cut = alive[:, None] & ((least > -1) | (most < 1))
        middle = np.where(cut, (least + most) / 2, 0.0)
        half = np.where(cut, upward(np.maximum(most - middle, middle - least)), 1.0)
        touched: NDArray[np.bool_] = np.any(cut, axis=1, keepdims=True)
        centre = self.centre + _times(self.sides, middle)
        sides = self.sides * half[:, None, :]
        loose = ROUNDING * (np.abs(self.centre) + np.abs(self.sides).sum(axis=2))
        box = np.where(touched, upward(self.box + loose), self.box)
        return ManySets(np.where(touched, centre, self.centre), sides, box), middle, half

    def _substituted(
        self,
        middle: Floats,
        weights: Floats,
        loose: Floats,
        high: Floats,
        bottom: Floats,
        zero: bool,
    ) -> ManySets:
        """The sets with a function from 0 to `high` in the place of one side, where that helps.

        The function is middle + weights e + r. It takes the place of the side that it depends
        on most, where it is zero or the part is thin, and the set does not become wider.
        """
        if not weights.shape[1]:
            return self
        each = np.arange(len(self))
        pivot = np.argmax(np.abs(weights), axis=1)
        own = weights[each, pivot]
        size = np.abs(own)
        thin = loose < _SURE * size
        if not zero:
            thin &= (high < _THIN * size) & (bottom < 0)
        if not thin.any():
            return self
        own, size = np.where(thin, own, 1.0), np.where(thin, size, 1.0)
        side = self.sides[each, :, pivot]
        share = weights / own[:, None]
        share[each, pivot] = 0.0
        half = high / 2
        sides = self.sides - side[:, :, None] * share[:, None, :]
        sides[each, :, pivot] = side * (half / own)[:, None]
        centre = self.centre + side * ((half - middle) / own)[:, None]
        far = (np.abs(middle) + high) / size + np.abs(share).sum(axis=1)
        reach = np.abs(side) * upward(far + 1)[:, None] + np.abs(self.sides).sum(axis=2)
        rounded = ROUNDING * (np.abs(self.centre) + reach)
        box = upward(self.box + np.abs(side) * upward(loose / size)[:, None] + rounded)
        before, after = np.abs(self.sides).sum(axis=2), np.abs(sides).sum(axis=2)
        wider = np.where(before > 0, after / np.where(before > 0, before, 1.0), 0.0)
        taken = (thin & (wider.mean(axis=1) <= _WIDER))[:, None]
        return ManySets(
            np.where(taken, centre, self.centre),
            np.where(taken[:, :, None], sides, self.sides),
            np.where(taken, box, self.box),
        )

    def fewer_sides(
        self, free: Any, lift: Rounded, within: tuple[Floats, Floats] | None = None
    ) -> ManySets:
        """Parallelepipeds with d sides around the sets, for states with d free coordinates.

        The coordinates in `free` determine the others for all states: `lift` (n, d + 1) gives
        all coordinates by the free ones and 1. The new sides have the directions of the largest
        old ones, or are those of boxes if these are smaller. `within` holds least and largest
        coordinates (B, n) that are known from elsewhere.
        """
        places, each = list(free), np.arange(len(self))
        count = len(places)
        one = np.ones((len(self), 1))
        if not count:
            empty = np.zeros((len(self), 1, 0))
            return ManySets(one, empty, np.zeros_like(one)).mapped(lift)
        own, boxed = self.sides[:, places, :], self.box[:, places]
        frame = _frame(own)
        inward, volume = _inverse(frame)
        reach = upward(np.abs(own).sum(axis=2) + boxed)
        turned = np.abs(inward)
        sizes = np.abs(product(inward, own)).sum(axis=2) + _times(turned, boxed)
        sizes = upward(sizes + ROUNDING * _times(turned, reach))
        low, high = (x[:, places] for x in self.hull)
        if within is not None:
            low = np.maximum(low, within[0][:, places])
            high = np.maximum(low, np.minimum(high, within[1][:, places]))
        middle = (low + high) / 2
        straight = upward(np.maximum(high - middle, middle - low))
        direct = np.prod(straight, axis=1) <= np.prod(sizes, axis=1) * volume
        identity = np.eye(count)
        wrong = np.abs(identity - product(frame, inward))
        wrong = wrong + ROUNDING * product(np.abs(frame), turned)
        rest = upward(_times(wrong, reach) + ROUNDING * _times(np.abs(frame), sizes))
        sides = np.where(
            direct[:, None, None], identity * straight[:, None, :], frame * sizes[:, None, :]
        )
        rest = np.where(direct[:, None], 0.0, rest)
        zero = np.zeros((len(self), 1))
        reduced = ManySets(
            np.concatenate(
                [np.where(direct[:, None], middle, self.centre[:, places]), one], axis=1
            ),
            np.concatenate([sides, np.zeros((len(each), 1, count))], axis=1),
            np.concatenate([rest, zero], axis=1),
        )
        return reduced.mapped(lift)

    def halves(self, side: NDArray[np.int_]) -> ManySets:
        """The 2 B halves of the sets, first all lower and then all upper ones.

        `side` (B,) says which side of each is divided.
        """
        each = np.arange(len(self))
        step = self.sides[each, :, side] / 2
        sides = self.sides.copy()
        sides[each, :, side] = step
        box = upward(self.box + ROUNDING * (np.abs(self.centre) + np.abs(step)))
        return joined_sets(
            [ManySets(self.centre - step, sides, box), ManySets(self.centre + step, sides, box)]
        )


def within(box: tuple[Floats, Floats], row: Rounded) -> tuple[Floats, Floats]:
    """Boxes (B, n) around the states of boxes for which a function is not positive.

    A box is given by its least and largest coordinates, the function by its row (1, n).
    Where there is no such state, the box stays the same.
    """
    low, high = box
    weight, size = row.middle[0], np.abs(row.middle[0])
    far = np.maximum(np.abs(low), np.abs(high))
    loose = upward((far * (row.radius[0] + ROUNDING * size)).sum(axis=1))[:, None]
    least = np.minimum(weight * low, weight * high)
    room = least - least.sum(axis=1, keepdims=True) + loose  # for what is a coordinate's own
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        bound = np.where(weight == 0, 0.0, room / weight)
    spare = ROUNDING * (1 + np.abs(bound))
    highest = np.where((weight > 0) & (bound + spare > low), bound + spare, high)
    lowest = np.where((weight < 0) & (bound - spare < high), bound - spare, low)
    return np.maximum(low, lowest), np.minimum(high, highest)


def joined_sets(parts: list[ManySets]) -> ManySets:
    """Sets of several lists in one; those with fewer sides get sides of length zero."""
    most = max(part.sides.shape[2] for part in parts)
    sides = [
        np.pad(part.sides, ((0, 0), (0, 0), (0, most - part.sides.shape[2]))) for part in parts
    ]
    return ManySets(
        np.concatenate([part.centre for part in parts]),
        np.concatenate(sides),
        np.concatenate([part.box for part in parts]),
    )


def _times(matrix: Floats, vectors: Floats) -> Floats:
    """Products (B, k) of one matrix, or of one for each set, and vectors (B, n)."""
    return product(matrix, vectors[:, :, None])[:, :, 0]


def _above(values: Floats) -> Floats:
    return values + (ROUNDING * (1 + np.abs(values)))


def _below(values: Floats) -> Floats:
    return values - (ROUNDING * (1 + np.abs(values)))


def _inverse(matrices: Floats) -> tuple[Floats, Floats]:
    """Approximate inverses (B, d, d) of matrices, and the sizes (B,) of their determinants."""
    count, size, _ = matrices.shape
    each, volume = np.arange(count), np.ones(count)
    axes = np.broadcast_to(np.eye(size), matrices.shape)
    rows = np.concatenate([matrices, axes], axis=2)
    for k in range(size):
        largest = k + np.argmax(np.abs(rows[:, k:, k]), axis=1)
        chosen = rows[each, largest]
        rows[each, largest] = rows[:, k]
        pivot = chosen[:, k]
        volume = volume * np.abs(pivot)
        chosen = chosen / pivot[:, None]
        rows = rows - rows[:, :, k, None] * chosen[:, None, :]
        rows[:, k] = chosen
    return rows[:, :, size:], volume


def _frame(sides: Floats) -> Floats:
    """Directions (B, d, d), as columns, of the largest sides (B, d, m) at clear angles."""
    count, size, _ = sides.shape
    spans = np.abs(sides).sum(axis=2)
    unit = np.where(spans > 0, spans, 1.0)
    axes = np.broadcast_to(np.eye(size), (count, size, size))
    columns = np.concatenate([sides / unit[:, :, None], axes], axis=2)
    lengths = np.sqrt((columns * columns).sum(axis=1))
    lengths[:, sides.shape[2] :] *= 1e-9  # axes come last
    safe = np.where(lengths > 0, np.sqrt((columns * columns).sum(axis=1)), 1.0)
    columns = columns / safe[:, None, :]
    left = columns.copy()
    least, each = min(_APART, 0.5 / size**0.5), np.arange(count)
    found = np.empty((count, size, size))
    for k in range(size):
        apart = np.sqrt((left * left).sum(axis=1))
        chosen = np.argmax(np.where(apart > least, lengths, -1.0), axis=1)
        found[:, :, k] = columns[each, :, chosen]
        basis = left[each, :, chosen] / apart[each, chosen][:, None]
        left = left - basis[:, :, None] * (basis[:, :, None] * left).sum(axis=1)[:, None, :]
    return unit[:, :, None] * found
