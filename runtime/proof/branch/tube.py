"""A tube around a piece of a branch, in which there is exactly one orbit for each coordinate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import krawczyk, newton

if TYPE_CHECKING:
    from flint import arb

__all__ = ["BranchTube", "orbit_near"]

_SHARE = 0.6  # of the bits: half of the box around an orbit at a point


@dataclass(frozen=True, eq=False)
class BranchTube:
    """Polynomials of one coordinate of a branch, and how far the orbit is from them.

    For each value of the coordinate between its ends there is exactly one orbit whose other
    coordinates are within the radii of the polynomials.
    """

    coordinate: int  # its number
    lower: Fraction  # lower end of the coordinate
    upper: Fraction  # upper end of the coordinate
    # coefficients of each other coordinate in e, which runs from -1 to 1
    centre: tuple[tuple[float, ...], ...]
    radii: tuple[float, ...]

    def holds(self, value: arb, others: Sequence[arb]) -> bool:
        """Whether an orbit is proved to be the one of the tube, at the working precision.

        `value` is its coordinate, between the ends, and `others` enclose the other ones.
        """
        away = zip(others, self.at(value), self.radii, strict=True)
        return all(abs(x - middle) < radius for x, middle, radius in away)

    def at(self, value: arb) -> list[arb]:
        """The polynomials at a value of the coordinate between the ends, at the working precision.

        There is one ball for each other coordinate.
        """
        from flint import arb

        middle, half = (self.lower + self.upper) / 2, (self.upper - self.lower) / 2
        place = (value - arb(rational_of(middle))) / arb(rational_of(half))
        found = []
        for row in self.centre:
            total = arb(0)
            for coefficient in reversed(row):
                total = total * place + arb(coefficient)
            found.append(total)
        return found


def orbit_near(
    curve: OrbitCurve, coordinate: int, value: arb, guess: Sequence[arb], bits: int
) -> list[arb] | None:
    """Enclosures of all coordinates of an orbit where one coordinate has a value.

    It comes from Newton's method and Krawczyk's test. A ball as value stands for all its values.
    `guess` has the other coordinates, approximately; `bits` is the working precision. None if no
    orbit is proved to be there.
    """
    from flint import arb

    middle = value.mid()
    point = newton(lambda: curve.equations(coordinate, middle), [x.mid() for x in guess], bits - 16)
    if point is None:
        return None
    equations = curve.equations(coordinate, value)
    unit = arb(2) ** -int(bits * _SHARE) + 64 * value.rad()
    found = krawczyk(equations, point, [(unit * (1 + abs(x))).upper() for x in point])
    if not found.unique:
        return None
    return curve.point(coordinate, value, [range_of(x) for x in found.image])
