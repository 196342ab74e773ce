"""Sets with a direction that is stretched: parallelepipeds on a section.

An h-set is N = {c + A x, |x_i| <= 1} (P. Zgliczynski and M. Gidea, Covering relations for
multidimensional dynamical systems, J. Differential Equations 202, 2004), here with the first
of its coordinates unstable and the others stable.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.checker.exact import exact
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet, affine_set
from nonsmooth.runtime.proof.sets.sections import MapSection

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["Box", "HSet", "apart", "decimal_set", "piece"]

Box = tuple[tuple[float, float], ...]  # of coordinates of an h-set, within -1 and 1


@dataclass(frozen=True)
class HSet:
    """A parallelepiped on a section: decimal texts or fractions, exactly."""

    name: str
    centre: tuple[str, ...]  # in the coordinates of the section
    # each in the coordinates of the section: the first one is stretched
    sides: tuple[tuple[str, ...], ...]

    @cached_property
    def near(self) -> tuple[np.ndarray, np.ndarray]:
        """Approximate centre (d,) and sides as columns (d, d)."""
        sides = [[float(Fraction(x)) for x in side] for side in self.sides]
        return np.array([float(Fraction(x)) for x in self.centre]), np.array(sides).T

    @property
    def corners(self) -> np.ndarray:
        """Approximate corners (2^d, d), those of two coordinates around their parallelogram."""
        centre, sides = self.near
        signs = np.array(np.meshgrid(*[[-1.0, 1.0]] * len(centre), indexing="ij"))
        signs = signs.reshape(len(centre), -1).T
        if len(centre) == 2:
            signs = signs[[0, 1, 3, 2]]
        return np.asarray(centre + signs @ sides.T)

    def exactly(self) -> tuple[list[Any], list[list[Any]]]:
        """Centre and sides as rational numbers (fmpq).

        `InputError` if they are no numbers, or not as many sides as coordinates.
        """
        size = len(self.centre)
        if not size or len(self.sides) != size or any(len(side) != size for side in self.sides):
            raise InputError("an h-set has a centre and as many sides as coordinates")
        try:
            return [*map(exact, self.centre)], [[*map(exact, side)] for side in self.sides]
        except (ValueError, ZeroDivisionError):
            raise InputError("the centre and the sides of an h-set are decimal texts") from None

    def seen(self, coordinates: AffineSet) -> list[arb]:
        """Balls (d,) around the coordinates, in this set, of a set of points of the section.

        The set has d + 1 rows: the section's coordinates and 1.
        """
        return coordinates.mapped(self.inward).ranges

    @cached_property
    def inward(self) -> arb_mat:
        """The matrix (d, d + 1) from the section's coordinates and 1 to those of the set."""
        from flint import arb_mat, fmpq_mat

        centre, sides = self.exactly()
        matrix = fmpq_mat(sides).transpose()
        try:
            inverse = matrix.inv()
        except ZeroDivisionError:
            raise InputError("the sides of an h-set are not independent") from None
        shift = inverse * fmpq_mat([[-x] for x in centre])
        rows = zip(inverse.tolist(), shift.tolist(), strict=True)
        return arb_mat(fmpq_mat([[*row, *last] for row, last in rows]))


def piece(h_set: HSet, section: MapSection, box: Box, *, sloped: bool = False) -> AffineSet:
    """States of a part of an h-set, with the time 0; the part is a box of coordinates, exactly.

    With `sloped` their derivatives by the coordinates of the h-set are followed.
    """
    from flint import arb, arb_mat, fmpq, fmpq_mat

    centre, sides = h_set.exactly()
    low, high = ([fmpq(*float(x[k]).as_integer_ratio()) for x in box] for k in (0, 1))
    middles = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    halves = [(b - a) / 2 for a, b in zip(low, high, strict=True)]
    rows = []
    for k, x in enumerate(centre):
        shares = [side[k] for side in sides]
        middle = x + sum((m * y for m, y in zip(middles, shares, strict=True)), fmpq(0))
        rows.append([middle, *(h * y for h, y in zip(halves, shares, strict=True))])
    rows.append([fmpq(1), *(fmpq(0) for _ in sides)])
    lift = fmpq_mat([list(row) for row in section.lift])
    found = [*(lift * fmpq_mat(rows)).tolist(), [fmpq(0)] * len(rows[-1]), rows[-1]]
    none, tangents = arb_mat(len(found), 1), []
    for side in sides if sloped else ():
        along = arb_mat(lift * fmpq_mat([*([x] for x in side), [0]]))
        tangents.append(affine_set(arb_mat([*along.tolist(), [arb(0)], [arb(0)]]), none))
    return affine_set(arb_mat(fmpq_mat(found)), none, tuple(tangents))


def apart(one: HSet, other: HSet) -> bool:
    """Whether two h-sets are proved to have no point in common."""
    return any(
        bool(x > 1 or x < -1)
        for first, second in ((one, other), (other, one))
        for x in first.seen(_coordinates(second))
    )


def _coordinates(h_set: HSet) -> AffineSet:
    from flint import arb_mat, fmpq_mat

    centre, sides = h_set.exactly()
    rows = [[x, *column] for x, column in zip(centre, zip(*sides, strict=True), strict=True)]
    rows.append([1, *(0 for _ in sides)])
    return affine_set(arb_mat(fmpq_mat(rows)), arb_mat(len(rows), 1))


def decimal_set(name: str, centre: Sequence[float], sides: np.ndarray, digits: int = 7) -> HSet:
    """An h-set with decimal numbers near one in double precision.

    `centre` is (d,), `sides` (d, d) as columns. Each side has so many digits relative to its
    length, the centre relative to the shortest side. Lengths are measured in units of the
    coordinates' extents.
    """
    extents = np.abs(sides).max(axis=1)
    lengths = np.linalg.norm(sides / extents[:, None], axis=0)
    return HSet(
        name,
        tuple(
            _text(x, lengths.min() * unit, digits) for x, unit in zip(centre, extents, strict=True)
        ),
        tuple(
            tuple(_text(x, length * unit, digits) for x, unit in zip(side, extents, strict=True))
            for side, length in zip(sides.T, lengths, strict=True)
        ),
    )


def _text(x: float, unit: float, digits: int) -> str:
    """A decimal text that is right to so many digits of a unit."""
    places = digits - 1 - int(np.floor(np.log10(unit)))
    return f"{x:.{max(places, 0)}f}"
