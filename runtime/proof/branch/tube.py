"""A tube around a piece of a branch, in which there is exactly one orbit for each coordinate."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.taylor_models import Space, TaylorModel, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import Krawczyk, contracted, followed, krawczyk, newton

if TYPE_CHECKING:
    from flint import arb

__all__ = ["ORDER", "BranchTube", "Piece", "orbit_at", "orbit_near", "proved_piece"]

ORDER = 5  # of the polynomials: what costs least, measured
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

    def value(self, space: Space) -> TaylorModel:
        """The coordinate over the tube as a model of one variable, at the working precision."""
        from flint import arb

        middle, half = (self.lower + self.upper) / 2, (self.upper - self.lower) / 2
        return space.variable(0, arb(rational_of(middle)), arb(rational_of(half)))

    def models(self, space: Space) -> list[TaylorModel]:
        """The polynomials as Taylor models, one for each other coordinate.

        The space has one variable and the polynomials' order.
        """
        from flint import arb

        return [TaylorModel(space, tuple(map(arb, row))) for row in self.centre]

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

    def slopes(self, end: float) -> list[float]:
        """Approximate derivatives of the polynomials by the coordinate, at e = `end`.

        -1 is the lower end, 1 the upper one.
        """
        half = float(self.upper - self.lower) / 2
        return [
            sum(k * c * end ** (k - 1) for k, c in enumerate(row) if k) / half
            for row in self.centre
        ]


@dataclass(frozen=True, eq=False)
class Piece:
    """A piece of a branch, proved to be in its tube."""

    tube: BranchTube
    point: list[Any]  # enclosures of all coordinates: Taylor models


def proved_piece(
    curve: OrbitCurve,
    coordinate: int,
    ends: tuple[Fraction, Fraction],
    guess: Sequence[arb],
    known: tuple[arb, Sequence[arb]] | None,
) -> Piece | str:
    """Prove that there is one orbit near polynomials for each value of a coordinate.

    `guess` has the other coordinates in the middle, approximately. `known` is a value of the
    coordinate with enclosures of the other ones there: the piece has to contain that orbit.
    A text says why nothing is proved.
    """
    space = space_of(1, ORDER)
    lower, upper = ends
    with flint_precision(curve.region.bits):
        tube = BranchTube(coordinate, lower, upper, (), ())
        value = tube.value(space)
        equations = curve.equations(coordinate, value)
        start = followed(equations, [x.mid() for x in guess], space)
        if start is None:
            return "Newton's method finds no orbit in the middle"
        centre = tuple(
            tuple(0.0 if part is None else float(part) for part in x.parts) for x in start
        )
        tube = BranchTube(coordinate, lower, upper, centre, ())
        found = contracted(Krawczyk(equations, tube.models(space)))
        if found is None:
            return "Krawczyk's test fails"
        # not above those that were tried, and the orbit is as near as they tell
        radii = tuple(math.nextafter(float(r), 0.0) for r in found.radii)
        tube = BranchTube(coordinate, lower, upper, centre, radii)
        away = zip(found.image, tube.models(space), radii, strict=True)
        if not all(abs(range_of(x - c)) < r for x, c, r in away):
            return "Krawczyk's test fails"
        point = curve.point(coordinate, value, found.image)
        if known is not None:
            at, others = known
            if not tube.holds(at, others):
                return "another orbit may have been found"
        return Piece(tube, point)


def orbit_at(curve: OrbitCurve, tube: BranchTube, value: arb, bits: int) -> list[arb] | None:
    """A sharp enclosure of the orbit of a tube at a value of its coordinate, in all coordinates.

    A ball as value stands for all its values. `bits` is the working precision. None if no orbit
    is proved to be in the tube.
    """
    found = orbit_near(curve, tube.coordinate, value, tube.at(value), bits)
    if found is None or not tube.holds(value, curve.others(tube.coordinate, found)):
        return None
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
