"""Derivatives of a located orbit by its parameters, by jets of order 1.

The orbit is a regular root: by the implicit function theorem it moves with J x' = -F_p. What the
declaration says is read once more, as functions of the parameters that move: what makes the
cycle close has to hold for all of them.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from flint import acb, acb_poly, arb, arb_mat, fmpq

from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.stability import characteristic
from nonsmooth.runtime.checker.stated.exact import Failure, demand, exact
from nonsmooth.runtime.checker.stated.parameters import (
    independent,
    number_at,
    number_in,
    stated_system,
)
from nonsmooth.runtime.core.jets import jet, part_of


def rates_along(
    content: dict[str, Any],
    parameters: Mapping[str, str],
    name: str,
    orbit: CheckedOrbit,
    multipliers: Sequence[Any],
) -> dict[str, Any]:
    """Return the derivatives of all that is enclosed by a number that was given for an orbit.

    `content` states the system and how its parameters move with the number called `name`;
    `parameters` holds the values of all of them, the period among them where it is given. The orbit
    is located. `Failure` is raised if the derivatives are not known.
    """
    rates = {moved: exact(text) for moved, text in content["directions"][name].items()}
    demand(rates and all(rates.values()), f"{name} moves nothing")
    demand(name not in parameters or rates.get(name) == 1, f"{name} moves something else")
    demand(rates.keys() <= parameters.keys(), "what moves is no parameter")
    still = {other: text for other, text in parameters.items() if other not in rates}
    declared, known = stated_system(content, still, [*rates])
    exactly = declared.bound and declared.rational
    demand(exactly, "the declaration takes a root or a sine of its parameters")
    declared.closes()
    point = [arb(number_in(parameters[moved])) for moved in rates]
    numbers = [jet(x, arb(rate)) for x, rate in zip(point, rates.values(), strict=True)]
    found = _rates(CheckedOrbit(declared, number_at([*numbers, *known])), orbit, multipliers)
    independent(declared, known, [(middle, middle) for middle in map(_fraction, point)])
    demand(all(rate.is_finite() for rate in found.values()), "a derivative is not enclosed")
    return found


def sharper(orbit: CheckedOrbit) -> CheckedOrbit:
    """Return the orbit located in a smaller box around its enclosure, where that succeeds."""
    found = CheckedOrbit(orbit.declared, orbit.number)
    widest = max((x.rad() for x in orbit.root), key=float)
    radii = [2 * x.rad() + widest / 2**16 for x in orbit.root]  # no side is empty
    unique, _ = found.locate([x.mid() for x in orbit.root], radii)
    return found if unique else orbit


def _rates(moving: CheckedOrbit, orbit: CheckedOrbit, multipliers: Sequence[Any]) -> dict[str, Any]:
    """Return the derivatives of all quantities of the orbit along one direction.

    A real multiplier has no imaginary part that could move.
    """
    slopes = orbit.passage(orbit.chain, orbit.root, orbit.flows).slopes
    missed = moving.along(orbit.root)
    try:
        rates = slopes.solve(arb_mat([[-part_of(value, 1)] for value in missed])).entries()
    except ZeroDivisionError:
        raise Failure("the equations may be singular at the orbit") from None
    moving.along([jet(x, rate) for x, rate in zip(orbit.root, rates, strict=True)])
    # of the whole map: multipliers beside those on a section are zero at all parameters
    free, size = moving.declared.free, moving.declared.size
    basis = [[fmpq(int(i == k)) for k in free] for i in range(size + 1)]
    section = moving.map_on(0, free, basis)
    found = {name: part_of(x, 1) for name, x in moving.enclosures(section).items()}
    coefficients = characteristic(section)[::-1]
    polynomial = acb_poly([acb(part_of(c, 0)) for c in coefficients])
    change = acb_poly([acb(part_of(c, 1)) for c in coefficients])
    slope = polynomial.derivative()
    for number, disc in enumerate(multipliers, 1):
        root = disc.mid() - polynomial(disc.mid()) / slope(disc)  # it is in the disc, and sharper
        rate = -change(root) / slope(root)
        found[f"multiplier {number} re"] = rate.real
        if not disc.imag.is_zero():
            found[f"multiplier {number} im"] = rate.imag
    return found


def _fraction(ball: Any) -> Any:
    """Return the middle of a ball as an exact fraction."""
    mantissa, exponent = ball.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
