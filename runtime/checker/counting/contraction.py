"""What can be told of one box of unknowns: that no root is in it, or one, or where all of them are.

Equations are G(u) (q, 1) = 0 for unknowns u, in the box, and coordinates q. Preconditioners and
weights are guesses: what they are does not matter, since every statement is about their products
with balls, for the very numbers that were taken. The linear equations for q are not divided by, so
that there are no poles: where G(u) has full rank over a box there is no root in it.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from flint import arb, arb_mat

from nonsmooth.runtime.checker.stated.exact import Numbers, column
from nonsmooth.runtime.core.taylor_models import unit_matrix

Sides = tuple[tuple[float, float], ...]  # of a box: exactly these doubles

_INFLATED = 1.5  # of the radii of coordinates, so that their image may lie inside
_TINY = arb(2) ** -40
_ENOUGH = 1e-4  # of a row's size: radii that do not hinder
_LEAST = 1e-300  # of a radius that is divided by
_UNKNOWN = 1e12  # a radius that is not bounded


@dataclass(frozen=True, eq=False)
class Linear:
    """G over a box: in its middle, and an enclosure, with derivatives by the unknowns.

    All matrices are m x (d + 1), for d coordinates. For each point u of the box, with middle m,
    G(u) - G(m) is a sum of slopes in `slopes` times the offsets u - m (Hansen, 1968).
    """

    centre: Any
    slopes: tuple[Any, ...]
    over: Any
    offsets: Numbers  # balls with those of all points of the box
    # no coordinate of the roots that are asked for has a larger absolute value
    largest: Any
    # rows (d + 1) that are zero on (q, 1) for some numbers in their balls, at all that is asked for
    asked: Sequence[Sequence[Any]] = ()
    # the box may hold a root that is none of the problem's: that it has none can be proved, but not
    # that it has one
    trivial: bool = False

    @cached_property
    def weights(self) -> list[float]:
        """A weight of each row: the smaller its entries' radii are, the more it counts."""
        return _weights(self.over)

    @cached_property
    def coordinates(self) -> list[Any] | None:
        """Enclosures of the coordinates q of every root in the box: least squares in balls.

        None if they are all too large.
        """
        over, width = self.over, self.over.ncols() - 1
        if width == 0:
            return []
        allowed = [arb(0, self.largest)] * width
        centre = arb_mat([row[:width] for row in self.centre.mid().tolist()])
        guess = _inverse(centre, self.weights)
        if guess is None:
            return allowed
        product = (guess * over).tolist()
        left = arb_mat([row[:width] for row in product])
        right = arb_mat([[-row[width]] for row in product])
        try:
            found = left.solve(right).entries()
        except ZeroDivisionError:
            return allowed
        if not all(x.is_finite() for x in found):
            return allowed
        if not all(x.overlaps(y) for x, y in zip(found, allowed, strict=True)):
            return None
        return [x if x.rad() < y.rad() else y for x, y in zip(found, allowed, strict=True)]


class Image(NamedTuple):
    """Krawczyk's image of a box."""

    sides: Sides  # contains every root of the box
    coordinates: tuple[Any, ...]  # contain those of every root of the box
    unique: bool  # the image lies inside: there is a root in the box, and perhaps no other
    empty: bool  # image and box are apart: there is no root
    ratio: float  # largest radius of the image in units of the box's

    def within(self, sides: Sides) -> Sides:
        """Return the box that the image and a box have in common; a side may be turned around."""
        pairs = zip(self.sides, sides, strict=True)
        return tuple((max(a, c), min(b, d)) for (a, b), (c, d) in pairs)


def balls_of(sides: Sides) -> list[Any]:
    """Return balls that contain the sides of a box, one for each."""
    return [arb(low).union(arb(high)) for low, high in sides]


def middles_of(sides: Sides) -> list[Any]:
    """Return exact numbers near the middle of each side, and inside it."""
    return [arb(low + (high - low) / 2) for low, high in sides]


def floats_around(ball: Any) -> tuple[float, float]:
    """Return doubles below and above a ball."""
    low, high = float(ball.lower()), float(ball.upper())
    return math.nextafter(low, -math.inf), math.nextafter(high, math.inf)


def enclosed(boxes: Iterable[Sides]) -> Sides:
    """Return the smallest box around all boxes, of which there is at least one."""
    columns = zip(*boxes, strict=True)
    return tuple((min(a for a, _ in c), max(b for _, b in c)) for c in map(list, columns))


def inside(sides: Sides, other: Sides) -> bool:
    """Return whether a box is part of another one, or equal to it."""
    return all(a <= c and d <= b for (c, d), (a, b) in zip(sides, other, strict=True))


def touching(one: Sides, other: Sides) -> bool:
    """Return whether two boxes have a point in common, edges included."""
    return all(a <= d and c <= b for (a, b), (c, d) in zip(one, other, strict=True))


def share_of(part: Sides, whole: Sides) -> float:
    """Return the least share of a side that a part of a box keeps."""
    shares = [(d - c) / (b - a) for (c, d), (a, b) in zip(part, whole, strict=True) if b > a]
    return min(shares, default=1.0)


def excluding(linear: Linear) -> bool:
    """Return whether one equation has no solution in a box, whatever the coordinates are there.

    All coordinates that a root may have are tried in each equation.
    """
    coordinates = linear.coordinates
    if coordinates is None:
        return True
    point = column((*coordinates, arb(1)))
    values = linear.centre * point
    for slope, offset in zip(linear.slopes, linear.offsets, strict=True):
        values = values + slope * point * offset
    rows = arb_mat([*linear.over.tolist(), *linear.asked])
    return any(x > 0 or x < 0 for x in (*values.entries(), *(rows * point).entries()))


def regular(linear: Linear) -> bool:
    """Return whether no point of a box is a root, since G has full rank all over it.

    For any matrix C, a vector v with G v = 0 makes C G singular, too; C is about the inverse of G
    in the middle, in which rows count less the less is known of them. That q is not too large is
    one more row for each coordinate: q / largest = a number in [-1, 1]. Without these rows a curve
    on which the equations for q are singular could not be distinguished from roots that are far
    away.
    """
    width = linear.over.ncols() - 1
    if width == 0:
        return False
    share = 1 / linear.largest
    asked = [*linear.asked, *([*(share * int(i == j) for j in range(width)), arb(0, 1)]
                              for i in range(width))]  # fmt: skip
    over = arb_mat([*linear.over.tolist(), *asked])
    centre = arb_mat([*linear.centre.tolist(), *asked]).mid()
    guess = _inverse(centre, _weights(over))
    if guess is None:
        return False
    determinant = (guess * over).det()
    return bool(determinant > 0 or determinant < 0)


def contract(linear: Linear, coordinates: Numbers | None, sides: Sides) -> Image | None:
    """Return Krawczyk's image of a box, or None where the equations are singular over it.

    `coordinates` contain those of the roots that are meant; None means that there are none. With
    z = (q, u), F(z) = G(u) (q, 1) and any matrix Y, all roots of a box Z around z are in
    z - Y F(z) + (I - Y S) (Z - z), with slopes S from z to any point of Z; if that is inside Z,
    there is one, and if S are slopes between any two points, no other (Krawczyk, 1969). Of more
    equations than unknowns as many are taken as there are unknowns: there is one root at most.
    """
    if linear.trivial:
        return None
    if coordinates is None:
        return Image(sides, (), unique=False, empty=True, ratio=0.0)
    rows, width = linear.centre.nrows(), linear.centre.ncols()
    points = [q.mid() for q in coordinates]
    wide = [q + arb(0, (_INFLATED - 1) * q.rad() + _TINY * (1 + abs(q.mid()))) for q in coordinates]
    over, middle = (column((*qs, arb(1))) for qs in (wide, points))
    values = (linear.centre * middle).entries()
    jacobian = [[linear.over[i, j] for j in range(width - 1)] for i in range(rows)]
    for slope in linear.slopes:
        for row, entry in zip(jacobian, (slope * over).entries(), strict=True):
            row.append(entry)
    count = len(jacobian[0])
    kept = _rows(jacobian, count)
    matrix = arb_mat([jacobian[i] for i in kept])
    try:
        inverse = matrix.mid().inv().mid()
    except ZeroDivisionError:
        return None
    centres = [*points, *middles_of(sides)]
    box = [*wide, *balls_of(sides)]
    offsets = [b - c for b, c in zip(box, centres, strict=True)]
    moved = (
        (unit_matrix(count) - inverse * matrix) * column(offsets)
        - inverse * column(values[i] for i in kept)
    ).entries()
    if not all(x.is_finite() for x in moved):
        return None
    image = [c + m for c, m in zip(centres, moved, strict=True)]
    unique = all(b.contains_interior(k) for b, k in zip(box, image, strict=True))
    within = all(
        low < k and k < high for (low, high), k in zip(sides, image[width - 1 :], strict=True)
    )
    empty = any(not b.overlaps(k) for b, k in zip(box, image, strict=True))
    shares = [
        float(k.rad()) / max(float(b.rad()), _LEAST)
        for b, k in zip(box[width - 1 :], image[width - 1 :], strict=True)
    ]
    return Image(
        tuple(floats_around(k) for k in image[width - 1 :]),
        tuple(image[: width - 1]),
        unique and within,
        empty,
        max(shares, default=0.0),
    )


def _weights(over: Any) -> list[float]:
    """Return a weight of each row: the smaller its entries' radii are, the more it counts.

    Digits beyond a few count no more, so that weighted rows stay comparable.
    """
    found = []
    for row in over.tolist():
        radius = max([float(x.rad()) for x in row])
        size = max([abs(float(x)) for x in row])
        finite = radius < math.inf
        found.append(1 / (radius + _ENOUGH * size + _LEAST) if finite else 1 / _UNKNOWN)
    return found


def _rows(jacobian: list[list[Any]], count: int) -> list[int]:
    """Return the numbers of as many rows as there are unknowns, about as independent as can be."""
    if len(jacobian) == count:
        return list(range(count))
    left = [[float(x.mid()) for x in row] for row in jacobian]
    left = [[x if math.isfinite(x) else 0.0 for x in row] for row in left]
    chosen: list[int] = []
    for _ in range(count):
        sizes = [sum(x * x for x in row) if i not in chosen else -1.0 for i, row in enumerate(left)]
        best = max(range(len(left)), key=sizes.__getitem__)
        chosen.append(best)
        for row in left if sizes[best] > 0 else ():
            share = sum(x * y for x, y in zip(row, left[best], strict=True)) / sizes[best]
            if row is not left[best]:
                row[:] = [x - share * y for x, y in zip(row, left[best], strict=True)]
    return sorted(chosen)


def _inverse(middle: Any, weight: Sequence[float]) -> Any:
    """Return about a left inverse of a matrix with weighted rows; None if it is singular."""
    rows = zip(middle.tolist(), weight, strict=True)
    weighted = arb_mat([[x * w for x in row] for row, w in rows]).mid()
    transposed = weighted.transpose()
    try:
        found = ((transposed * weighted).mid().inv().mid() * transposed).tolist()
    except ZeroDivisionError:
        return None
    found = [[x * w for x, w in zip(row, weight, strict=True)] for row in found]
    finite = all(x.is_finite() for row in found for x in row)
    return arb_mat(found).mid() if finite else None
