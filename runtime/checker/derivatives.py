"""Derivatives of a located orbit by its parameters, proved again by jets of order 1.

The orbit is a regular root: by the implicit function theorem it moves with J x' = -F_p. What the
declaration says is read once more, as functions of the parameters that move: what makes the
cycle close has to hold for all of them.
"""

from collections.abc import Mapping
from typing import Any

from flint import acb, acb_poly, arb, arb_mat, fmpq

from nonsmooth.runtime.checker.declared import StatedSystem
from nonsmooth.runtime.checker.exact import Failure, ball, demand, exact, inside
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.parameters import independent, number_at, number_in, values_of
from nonsmooth.runtime.checker.stability import characteristic
from nonsmooth.runtime.core.jets import jet, part_of

__all__ = ["check_derivatives"]

_PARTS = ("re", "im")


def check_derivatives(
    content: dict[str, Any], parameters: Mapping[str, str], orbit: CheckedOrbit
) -> None:
    """Prove all derivatives that a certificate states; `Failure` names one that is not proved.

    `parameters` holds the values of all parameters, the period among them where it is
    given; `orbit` is already located.
    """
    stated, along = content.get("derivatives", {}), content.get("directions", {})
    demand(bool(stated) == bool(along), "derivatives by nothing")
    if not stated:
        return
    demand(orbit.declared.alone, "one-sided maps have no derivatives")
    multipliers = [acb(ball(m["re"]), ball(m["im"])) for m in content["multipliers"]]
    beside = {f"multiplier {k} {part}" for k in range(1, len(multipliers) + 1) for part in _PARTS}
    whole = content["enclosures"].keys()
    demand(whole <= stated.keys() <= whole | beside, "derivatives of other quantities")
    demand(all(rates.keys() == along.keys() for rates in stated.values()),
           "derivatives by other parameters")  # fmt: skip
    moving = list(dict.fromkeys(name for direction in along.values() for name in direction))
    demand({*moving} <= parameters.keys(), "what moves is no parameter")
    still = {name: text for name, text in parameters.items() if name not in moving}
    values, told, constants = values_of(still, moving, content["declaration"].get("constants", []))
    declared = StatedSystem(content, values, told)
    demand(declared.bound and declared.rational, "the declaration is no function of parameters")
    declared.closes()
    point = [arb(number_in(parameters[name])) for name in moving]
    orbit = _sharper(orbit)
    slopes = orbit.passage(orbit.chain, orbit.root, orbit.flows).slopes
    for name, direction in along.items():
        rates = {parameter: exact(text) for parameter, text in direction.items()}
        demand(rates and all(rates.values()), f"{name} moves nothing")
        demand(name not in parameters or rates.get(name) == 1, f"{name} moves something else")
        numbers = [
            jet(value, arb(rates[parameter])) if parameter in rates else value
            for parameter, value in zip(moving, point, strict=True)
        ]
        moved = CheckedOrbit(declared, number_at([*numbers, *constants]))
        found = _rates(moved, orbit, slopes, multipliers)
        for quantity, by in stated.items():
            proved = inside(found[quantity], by[name])
            demand(proved, f"the derivative of {quantity} by {name} is not in its enclosure")
    middles = [_fraction(value) for value in point]
    independent(declared, constants, [(x, x) for x in middles])


def _sharper(orbit: CheckedOrbit) -> CheckedOrbit:
    """Return the orbit located in a smaller box around its enclosure, where that succeeds."""
    found = CheckedOrbit(orbit.declared, orbit.number)
    widest = max((x.rad() for x in orbit.root), key=float)
    radii = [2 * x.rad() + widest / 2**16 for x in orbit.root]  # no side is empty
    unique, _ = found.locate([x.mid() for x in orbit.root], radii)
    return found if unique else orbit


def _rates(
    moving: CheckedOrbit, orbit: CheckedOrbit, slopes: Any, multipliers: list[Any]
) -> dict[str, Any]:
    """Return the derivatives of all stated quantities of the orbit along one direction."""
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
        found |= dict(zip((f"multiplier {number} {part}" for part in _PARTS),
                          (rate.real, rate.imag), strict=True))  # fmt: skip
    return found


def _fraction(ball: Any) -> Any:
    """Return the middle of a ball as an exact fraction."""
    mantissa, exponent = ball.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
