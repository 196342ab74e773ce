"""What can be told of one box: that it has no root, or where its roots are, or that it has one.

Floats guess preconditioners, weights and where to cut; what they are does not matter, since
every statement is about their products with balls, for the very floats that were taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = [
    "Image",
    "Linear",
    "Sides",
    "balls_of",
    "contract",
    "enclosed",
    "excluding",
    "floats_around",
    "middles_of",
    "smears",
]

Sides = tuple[tuple[float, float], ...]  # of a box: exactly these doubles

_INFLATED = 1.5  # of the radii of coordinates, so that their image may lie inside
_TINY = 1e-12
_UNKNOWN = 1e12  # a radius that is not bounded


class Linear(NamedTuple):
    """G over a box: at its middle, its derivatives by the unknowns over it, and its enclosure.

    All matrices are m x (d + 1), for d coordinates.
    """

    centre: arb_mat
    slopes: tuple[arb_mat, ...]
    over: arb_mat  # enclosure by the mean value theorem
    # the box may hold a root that is none of the problem's: that it has none can be proved, but not
    # that it has one
    trivial: bool = False
    # no coordinate of the roots that are asked for has a larger absolute value
    largest: float = 0.0

    @staticmethod
    def of(centre: arb_mat, slopes: Sequence[arb_mat], sides: Sides) -> Linear:
        """G over a box from its middle and its derivatives by each unknown over the box."""
        over = centre
        for slope, ball, middle in zip(slopes, balls_of(sides), middles_of(sides), strict=True):
            over = over + slope * (ball - middle)
        return Linear(centre, tuple(slopes), over)


class Image(NamedTuple):
    """Krawczyk's image of a box."""

    sides: Sides  # contains every root of the box
    coordinates: tuple[arb, ...]  # contain those of every root of the box
    unique: bool  # the image lies inside: there is one root in the box, and no other
    empty: bool  # image and box are apart: there is no root
    ratio: float  # largest radius of the image in units of the box's

    def within(self, sides: Sides) -> Sides:
        """The box that the image and a box have in common."""
        return tuple(
            (max(a, c), min(b, d)) for (a, b), (c, d) in zip(self.sides, sides, strict=True)
        )


def balls_of(sides: Sides) -> list[arb]:
    """Balls that contain the sides of a box, one for each."""
    from flint import arb

    return [arb(low).union(arb(high)) for low, high in sides]


def middles_of(sides: Sides) -> list[arb]:
    """Exact numbers near the middle of each side, and inside it."""
    from flint import arb

    return [arb(low + (high - low) / 2) for low, high in sides]


def floats_around(ball: arb) -> tuple[float, float]:
    """Doubles below and above a ball."""
    low, high = float(ball.lower()), float(ball.upper())
    return math.nextafter(low, -math.inf), math.nextafter(high, math.inf)


def enclosed(boxes: Iterable[Sides]) -> Sides:
    """The smallest box around all boxes, of which there is at least one."""
    columns = zip(*boxes, strict=True)
    return tuple((min(a for a, _ in c), max(b for _, b in c)) for c in map(list, columns))


def excluding(linear: Linear) -> bool:
    """Whether no point of a box is proved to be a root with coordinates that are not too large.

    For any matrix C, a vector v with G v = 0 makes C G singular; C is about the inverse of G
    in the middle, in which rows count less the less is known of them. That q is not too large
    is one more row for each coordinate: q / largest = a number in [-1, 1]. Without these rows
    a curve on which the equations for q are singular could not be distinguished from roots that
    are far away.
    """
    from flint import arb, arb_mat

    over = linear.over
    width = over.ncols() - 1
    if width == 0 and any(x > 0 or x < 0 for x in over.entries()):
        return True
    weights = _weights(over)
    centre = _floats(linear.centre)
    if width:
        share = 1 / arb(linear.largest)
        bounds = [[share * int(i == j) for j in range(width)] for i in range(width)]
        over = arb_mat([*over.tolist(), *([*row, arb(0, 1)] for row in bounds)])
        more = np.eye(width, width + 1) / linear.largest
        centre, weights = np.vstack([centre, more]), np.append(weights, np.ones(width))
    guess = _inverse(centre, weights)
    if guess is None:
        return False
    product = arb_mat(guess.tolist()) * over
    determinant = product.det()
    return bool(determinant > 0 or determinant < 0)


def contract(linear: Linear, sides: Sides) -> Image | None:
    """Krawczyk's image of a box, or None where the equations are singular over it.

    With z = (q, u), F(z) = G(u) (q, 1) and any matrix Y, all roots of a box Z around z are in
    z - Y F(z) + (I - Y F'(Z)) (Z - z); if that is inside Z, there is one (Krawczyk, 1969).
    """
    from flint import arb, arb_mat

    if linear.trivial:
        return None
    rows, width = linear.centre.nrows(), linear.centre.ncols()
    coordinates = _coordinates(linear)
    if coordinates is None:
        return Image(sides, (), unique=False, empty=True, ratio=0.0)
    points = [q.mid() for q in coordinates]
    column, middle = (arb_mat([[x] for x in (*qs, arb(1))]) for qs in (coordinates, points))
    values = (linear.centre * middle).entries()
    jacobian = [[linear.over[i, j] for j in range(width - 1)] for i in range(rows)]
    for slope in linear.slopes:
        for row, entry in zip(jacobian, (slope * column).entries(), strict=True):
            row.append(entry)
    count = len(jacobian[0])
    kept = _rows(jacobian, count)
    matrix = arb_mat([jacobian[i] for i in kept])
    try:
        inverse = matrix.mid().inv().mid()
    except ZeroDivisionError:
        return None
    centres = [*points, *middles_of(sides)]
    wide = [q + arb(0, (_INFLATED - 1) * q.rad() + _TINY * (1 + abs(q.mid()))) for q in coordinates]
    box = [*wide, *balls_of(sides)]
    if width > 1:  # the column is wider now, and the derivatives with it
        column = arb_mat([[x] for x in (*wide, arb(1))])
        entries = [(slope * column).entries() for slope in linear.slopes]
        for place, i in enumerate(kept):
            for j, by in enumerate(entries):
                matrix[place, width - 1 + j] = by[i]
    unit = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
    offsets = [b - c for b, c in zip(box, centres, strict=True)]
    moved = (
        (unit - inverse * matrix) * arb_mat([[d] for d in offsets])
        - inverse * arb_mat([[values[i]] for i in kept])
    ).entries()
    if not all(x.is_finite() for x in moved):
        return None
    image = [c + m for c, m in zip(centres, moved, strict=True)]
    unique = all(b.contains_interior(k) for b, k in zip(box, image, strict=True))
    inside = all(
        low < k and k < high for (low, high), k in zip(sides, image[width - 1 :], strict=True)
    )
    empty = any(not b.overlaps(k) for b, k in zip(box, image, strict=True))
    shares = [
        float(k.rad()) / max(float(b.rad()), 1e-300)
        for b, k in zip(box[width - 1 :], image[width - 1 :], strict=True)
    ]
    return Image(
        tuple(floats_around(k) for k in image[width - 1 :]),
        tuple(image[: width - 1]),
        unique and inside,
        empty,
        max(shares, default=0.0),
    )


def smears(linear: Linear, sides: Sides) -> np.ndarray:
    """A guess of how much each unknown's side spreads G, as an array: cut at the largest."""
    weights = _weights(linear.over)
    found = []
    for slope, (low, high) in zip(linear.slopes, sides, strict=True):
        sizes = np.array([float(abs(x).upper()) for x in slope.entries()])
        sizes = sizes.reshape(len(weights), -1).max(axis=1)
        score = float(weights @ sizes) * (high - low)
        # where the derivative is not bounded, nothing but the size of the side is known
        found.append(score if math.isfinite(score) else _UNKNOWN * (high - low))
    return np.array(found)


def _coordinates(linear: Linear) -> list[arb] | None:
    """Enclosures of the coordinates q of every root in a box: least squares in balls.

    None if they are all too large.
    """
    from flint import arb, arb_mat

    over, width = linear.over, linear.over.ncols() - 1
    if width == 0:
        return []
    allowed = [arb(0, linear.largest)] * width
    guess = _inverse(_floats(linear.centre)[:, :width], _weights(over))
    if guess is None:
        return allowed
    product = arb_mat(guess.tolist()) * over
    left = arb_mat([[product[i, j] for j in range(width)] for i in range(width)])
    right = arb_mat([[-product[i, width]] for i in range(width)])
    try:
        found = left.solve(right).entries()
    except ZeroDivisionError:
        return allowed
    if not all(x.is_finite() for x in found):
        return allowed
    if not all(x.overlaps(y) for x, y in zip(found, allowed, strict=True)):
        return None
    return [x if x.rad() < y.rad() else y for x, y in zip(found, allowed, strict=True)]


def _rows(jacobian: list[list[arb]], count: int) -> list[int]:
    """Numbers of as many rows as there are unknowns, chosen to be as independent as possible."""
    rows = list(range(len(jacobian)))
    if len(rows) == count:
        return rows
    left = np.array([[float(x.mid()) for x in row] for row in jacobian])
    chosen: list[int] = []
    for _ in range(count):
        sizes = np.linalg.norm(np.where(np.isfinite(left), left, 0), axis=1)
        best = int(sizes.argmax())
        chosen.append(best)
        if sizes[best] > 0:
            unit = left[best] / sizes[best]
            left = left - np.outer(left @ unit, unit)
        left[best] = 0
    return sorted(set(chosen)) if len(set(chosen)) == count else rows[:count]


def _weights(over: arb_mat) -> np.ndarray:
    """A weight of each row: the smaller its entries' radii are, the more it counts."""
    radii = np.array([float(x.rad()) for x in over.entries()])
    radii = radii.reshape(over.nrows(), over.ncols()).max(axis=1)
    radii = np.where(np.isfinite(radii), radii, _UNKNOWN)
    weights: np.ndarray = 1 / (radii + 1e-9 * radii.max() + np.finfo(float).tiny)
    return weights


def _inverse(matrix: np.ndarray, weights: np.ndarray) -> np.ndarray | None:
    """An approximate left inverse of a matrix with weighted rows; None if it is singular."""
    weighted = matrix * weights[:, None]
    transposed = weighted.T
    try:
        inverse: np.ndarray = np.linalg.solve(transposed @ weighted, transposed) * weights
    except np.linalg.LinAlgError:
        return None
    return inverse if np.isfinite(inverse).all() else None


def _floats(matrix: arb_mat) -> np.ndarray:
    numbers = np.array([float(x.mid()) for x in matrix.entries()])
    return numbers.reshape(matrix.nrows(), matrix.ncols())
