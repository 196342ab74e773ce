"""The orbits of twice the period next to a flip, proved in a tube over their amplitude."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.doubling.doubled_equations import DoubledEquations
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.krawczyk import Krawczyk, contracted, followed, krawczyk, newton

if TYPE_CHECKING:
    from flint import arb

__all__ = ["FLIP", "ORDER", "DoublingTube", "ProvedTube", "flip_near", "proved_tube"]

ORDER = 5  # of the polynomials
FLIP = 192  # bits of the numbers at the flip
_STEPS = 2  # of Newton's method, at the full order
_SHARE = 0.6  # of the bits: half of the box around a flip


@dataclass(frozen=True, eq=False)
class DoublingTube:
    """A tube around polynomials of the amplitude that holds the doubled orbits.

    For each amplitude a between minus and plus its largest there is exactly one solution of the
    doubled equations whose unknowns are within the radii of the polynomials.
    """

    scaled: int  # the unknown in which the two copies are 2 a apart
    amplitude: Fraction  # the largest a
    # coefficients in e = a / amplitude of the middle, of the direction without its entry 1, and of
    # the parameter
    centre: tuple[tuple[float, ...], ...]
    radii: tuple[float, ...]

    def equations(self, region: Region) -> DoubledEquations:
        """Return the doubled equations for all amplitudes of the tube, at the working precision."""
        from flint import arb

        space = space_of(1, ORDER)
        a = space.variable(0, arb(0), arb(rational_of(self.amplitude)))
        return DoubledEquations(region, self.scaled, a)

    def models(self) -> list[TaylorModel]:
        """Return the polynomials as Taylor models."""
        from flint import arb

        space = space_of(1, ORDER)
        return [TaylorModel(space, tuple(map(arb, row))) for row in self.centre]

    def holds(self, amplitude: arb, solution: Sequence[arb]) -> bool:
        """Whether a solution at an amplitude is proved to be the one of the tube.

        `solution` encloses the unknowns of the doubled equations.
        """
        from flint import arb

        place = amplitude / arb(rational_of(self.amplitude))
        if not abs(place) < 1:
            return False
        middles = [x.at([place]) for x in self.models()]
        away = zip(solution, middles, self.radii, strict=True)
        return all(abs(x - middle) < radius for x, middle, radius in away)


@dataclass(frozen=True, eq=False)
class ProvedTube:
    """A tube that is proved, with its enclosures."""

    tube: DoublingTube
    point: list[Any]  # unknowns of the doubled cycle's equations, and the parameter
    flip: list[arb]  # solution at the amplitude zero
    # derivative of the parameter by the square of the amplitude, at the flip; its sign is the same
    # all along the tube
    rate: arb


def flip_near(region: Region, scaled: int, guess: Sequence[arb]) -> list[arb] | None:
    """Return an enclosed flip with its direction, or None if none is proved to be there.

    It is the solution of the doubled equations at the amplitude zero: the unknowns, the direction
    without its entry 1, whose number is `scaled`, and the parameter, as in `guess`.
    """
    from flint import arb

    equations = DoubledEquations(region, scaled, arb(0))
    point = newton(lambda: equations, guess, FLIP - 16)
    if point is None:
        return None
    unit = arb(2) ** -int(FLIP * _SHARE)
    found = krawczyk(equations, point, [(unit * (1 + abs(x))).upper() for x in point])
    return [range_of(x) for x in found.image] if found.unique else None


def proved_tube(
    region: Region, scaled: int, amplitude: Fraction, flip: Sequence[arb]
) -> ProvedTube | str:
    """Prove that there is one doubled orbit for each amplitude, and on which side of the flip.

    `amplitude` is the largest one, and `flip` the solution at the amplitude zero. A text says why
    nothing is proved.
    """
    with flint_precision(region.bits):
        equations = DoublingTube(scaled, amplitude, (), ()).equations(region)
        start = followed(equations, [x.mid() for x in flip], space_of(1, ORDER))
        if start is None:
            return "Newton's method finds no doubled orbit"
        for _ in range(_STEPS):
            missed = Krawczyk(equations, start).missed
            if not missed or not all(range_of(d).is_finite() for d in missed):
                return "Newton's method finds no doubled orbit"
            start = [(x + d).mid() for x, d in zip(start, missed, strict=True)]
        centre = tuple(
            tuple(0.0 if part is None else float(part) for part in x.parts) for x in start
        )
        tube = DoublingTube(scaled, amplitude, centre, ())
        found = contracted(Krawczyk(equations, tube.models()))
        if found is None:
            return "Krawczyk's test fails"
        radii = tuple(math.nextafter(float(r), 0.0) for r in found.radii)
        tube = DoublingTube(scaled, amplitude, centre, radii)
        away = zip(found.image, tube.models(), radii, strict=True)
        if not all(abs(range_of(x - c)) < r for x, c, r in away):
            return "Krawczyk's test fails"
        if not tube.holds(0 * flip[0], flip):
            return "another flip may have been found"
        rates = equations.rates(found.image)
        if rates is None:
            return "the derivative by the amplitude is not known"
        every = range_of(rates[-1])
        if not (every > 0 or every < 0):
            return "on which side of the flip the doubled orbits are is not known"
        point = equations.doubled(found.image)
    with flint_precision(FLIP):
        rates = DoubledEquations(region, scaled, 0 * flip[0].mid()).rates(flip)
        if rates is None or not (rates[-1] > 0 if every > 0 else rates[-1] < 0):
            return "the derivative by the amplitude is not known at the flip"
        return ProvedTube(tube, point, list(flip), rates[-1])
