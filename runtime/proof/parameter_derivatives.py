"""How a proved orbit moves with its parameters: the implicit function theorem, in balls.

Krawczyk's test shows that the Jacobian J of the equations F(x, p) = 0 is regular over the box, so
that the orbit x(p) is unique there and analytic near its parameters, and J x' = -F_p. All numbers
are computed over the orbit's own enclosure, as jets of order 1: F_p at a fixed x, and then, from
x and x' together, what is stated of the orbit.

The equations have to be those of the orbit at neighbouring parameters too. So fields, rows,
resets and what makes the cycle close are rational functions of the parameters that move.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import matrix
from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.model.completion import followers
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.enclosure import IsolatedOrbit
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.exact_tables import (
    NotRational,
    constants_over,
    irrational_texts,
    rational_of,
    tables_over,
)
from nonsmooth.runtime.proof.krawczyk import Krawczyk
from nonsmooth.runtime.proof.multipliers import CORNER, product_of, trace_of
from nonsmooth.runtime.proof.orbit_claims import named_numbers
from nonsmooth.runtime.proof.orbit_equations import Equations, Flows, Linearised
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered, Subject, closing_of
from nonsmooth.runtime.proof.parametric_declaration import PERIOD
from nonsmooth.runtime.shooting.variational import Shooting

if TYPE_CHECKING:
    from flint import acb, arb, arb_mat

__all__ = ["Direction", "ProvedDerivatives", "asked_parameters", "derivatives_along", "directions"]

Direction = Mapping[str, Fraction]  # how parameters of the system, or the period, move
_SHARE = 24  # bits
_MORE = 48  # bits for what is lost through the phases: the check has sixteen beyond them
_GRAZING = "a boundary may be reached tangentially: there no derivative is claimed"


@dataclass(frozen=True, eq=False)
class ProvedDerivatives:
    """The enclosed derivatives of an orbit by some of the numbers that were given for it."""

    # of each quantity by each given number
    rates: Mapping[str, Mapping[str, arb]] = field(default_factory=dict)
    # how the system's parameters move with each number by which there are derivatives
    directions: Mapping[str, Direction] = field(default_factory=dict)
    missing: Mapping[str, str] = field(default_factory=dict)  # why there are none by the others
    # how the cycle closes, as functions of the moving parameters
    closing: ClosureConditions | None = None
    # parameters of the system that move, in the order of the closing's variables
    moving: tuple[str, ...] = ()
    # irrational numbers: the variables of the closing behind the moving ones
    constants: tuple[str, ...] = ()

    def size(self, name: str) -> arb:
        """Return a small share of the largest derivative by a given number.

        Derivatives that are zero are computed from numbers of such a size.
        """
        from flint import arb

        largest = max((abs(rates[name]).mid() for rates in self.rates.values()), key=float)
        return largest * arb(2) ** -_SHARE


def asked_parameters(orbit: Orbit, by: Sequence[str] | str | bool | None) -> tuple[str, ...]:
    """Return the names of the given numbers by which derivatives are asked for, each once.

    True stands for all that was given, None and False for nothing. What was not given is refused.
    """
    if by is None or isinstance(by, bool):
        return tuple(orbit.given) if by else ()
    names = (by,) if isinstance(by, str) else tuple(by)
    for name in names:
        if name not in orbit.given:
            raise unknown_name("given parameter", str(name), orbit.given)
    if not names:
        raise InputError("derivatives: no parameter is named")
    return tuple(dict.fromkeys(names))


def directions(orbit: Orbit, chosen: Iterable[str], by: Iterable[str]) -> dict[str, Direction]:
    """Return how the system's parameters, and the period, move with each given number in `by`.

    The other given numbers, and the parameters in `chosen`, which the orbit leaves open, stay.
    """
    problem = orbit.problem
    known = {*orbit.given, *orbit.opened, *chosen, *problem.required}
    sums = {} if problem.kernels is None else followers(problem.kernels, known)
    found: dict[str, Direction] = {}
    for name in by:
        if name == problem.period_name:
            found[name] = {PERIOD: Fraction(1)}
            continue
        rates = {
            table.name: Fraction(table.name == name)
            if table.name in known
            else sums[table.name].get(name, Fraction(0))
            for table in orbit.system.parameters
        }
        found[name] = {parameter: rate for parameter, rate in rates.items() if rate}
    return found


def derivatives_along(
    region: Region,
    root: IsolatedOrbit,
    multipliers: Sequence[acb],
    along: Mapping[str, Direction],
) -> ProvedDerivatives:
    """Enclose the derivatives of a proved orbit along directions, at the working precision.

    The region is one parameter point. The multipliers have to be simple, each apart from the
    others. Where there are no derivatives along a direction, the result says why.
    """
    reason = _without(region, root)
    if reason:
        return ProvedDerivatives(missing=dict.fromkeys(along, reason))
    missing: dict[str, str] = {}
    for name, direction in along.items():
        try:
            _moving_region(region, tuple(direction))
        except NotCovered as problem:
            missing[name] = str(problem)
    left = {name: direction for name, direction in along.items() if name not in missing}
    if not left:
        return ProvedDerivatives(missing=missing)
    names = tuple(dict.fromkeys(name for direction in left.values() for name in direction))
    try:
        with flint_precision(_bits() + _MORE):
            moving = _moving_region(region, names)
            sharp = _sharper(region, root)
            found = {
                name: _rates(moving, names, sharp, multipliers, direction)
                for name, direction in left.items()
            }
    except (NotCovered, ZeroDivisionError) as problem:
        return ProvedDerivatives(missing=missing | dict.fromkeys(left, str(problem)))
    quantities = next(iter(found.values()))
    return ProvedDerivatives(
        {q: {name: rates[q] for name, rates in found.items()} for q in quantities},
        left,
        missing,
        moving.closing,
        names,
        tuple(value.text for value in moving.tables.constants),
    )


def _without(region: Region, root: IsolatedOrbit) -> str:
    """Return why an orbit has no derivatives at all, or an empty text if it may have some."""
    if region.cycle.one_sided:
        return CORNER
    maps = root.equations.maps(root.linearised.shooting)
    finite = all(x.is_finite() for found in maps for x in found.entries())
    return "" if finite else _GRAZING


def _moving_region(region: Region, names: Sequence[str]) -> Region:
    """Return the region with tables and closing as functions of the named parameters.

    `NotCovered` is raised if they are no such functions, or if the cycle closes in another way.
    """
    subject = region.subject
    kernels, values = subject.kernels, subject.values
    still = [value for name, value in values.items() if name not in names]
    try:
        known = constants_over(names, irrational_texts(kernels, still))
        variables = dict(zip(names, known.variables, strict=True))

        def entry(name: str, value: Value) -> Any:
            if name in variables:
                return variables[name]
            return known.numbers[value.text] if value.exact is None else rational_of(value.exact)

        tables = tables_over(kernels, [entry(*pair) for pair in values.items()], known)
        at = [value.ball(_bits()) for value in _values(subject, names)]
        closing = closing_of(subject, tables, [float(x) for x in subject.start], at)
    except (NotRational, ArithmeticError) as problem:
        raise NotCovered(str(problem)) from None
    own = region.closing
    for kind in ("kind", "dropped", "turns", "pairs", "translations"):
        if getattr(own, kind) != getattr(closing, kind):
            raise NotCovered("the cycle closes in another way at other values")
    if PERIOD in names:
        closing = replace(closing, period=variables[PERIOD])
    return Region(subject, (), (), tables, closing, (), region.guess)


def _bits() -> int:
    from flint import ctx

    return int(ctx.prec)


def _sharper(region: Region, root: IsolatedOrbit) -> IsolatedOrbit:
    """Return the same orbit at the working precision, which is higher now.

    That is sound because Krawczyk's image of a box contains all its roots.
    """
    equations = region.equations(region.tables.number_at())
    image = root.contraction.image
    test = Krawczyk(equations, [x.mid() for x in image])
    found = test.sharpened(test([x.rad() for x in image]))
    linearised = equations.linearised(found.image, found.flows)
    return IsolatedOrbit(equations, found, linearised, root.box)


def _values(subject: Subject, names: Iterable[str]) -> list[Any]:
    """Return the values of named parameters; `PERIOD` is the name of the orbit's period."""
    return [subject.period if name == PERIOD else subject.values[name] for name in names]


def _rates(
    region: Region,
    names: Sequence[str],
    root: IsolatedOrbit,
    multipliers: Sequence[acb],
    direction: Direction,
) -> dict[str, arb]:
    """Return the derivatives along one direction of all quantities that are enclosed."""
    from flint import arb

    balls = [value.ball(_bits()) for value in _values(region.subject, names)]
    point = [
        jet(ball, arb(rational_of(direction[name]))) if name in direction else ball
        for name, ball in zip(names, balls, strict=True)
    ]
    equations = region.equations(region.tables.number_at(point))
    image = root.contraction.image
    missed = _linearised(equations, image).residual
    moved = root.linearised.jacobian.solve(-part_of(missed, 1)).entries()
    orbit = [jet(x, rate) for x, rate in zip(image, moved, strict=True)]
    now = _linearised(equations, orbit).shooting
    section = _section(equations, now)
    named = named_numbers(region, equations, now, equations.dwell(orbit), trace_of(section))
    return {name: part_of(number, 1) for name, number in named.items()} | _of_multipliers(
        part_of(section, 0), part_of(section, 1), multipliers
    )


def _linearised(equations: Equations, unknowns: Sequence[Any]) -> Linearised:
    """Pass once through the cycle, with flows near the unknowns' own dwell times."""
    flows = Flows(equations.phases, equations.dwell(unknowns))
    return equations.linearised(unknowns, flows)


def _section(equations: Equations, now: Shooting) -> Any:
    """Return the whole Poincare map on the states that are not forcings.

    Forcings do not change from period to period. What the smallest section leaves out has
    multipliers that are zero at all parameters.
    """
    whole = product_of(equations.maps(now))
    return matrix([[whole[i, j] for j in equations.free] for i in equations.free])


def _of_multipliers(
    section: arb_mat, change: arb_mat, multipliers: Sequence[acb]
) -> dict[str, arb]:
    """Return the derivatives tr(A M') / tr(A) of simple multipliers m of a map M.

    A is the adjugate of m - M. The formula is by C. G. J. Jacobi (1841). The imaginary part of a
    real multiplier is left out.
    """
    from flint import acb, acb_poly, arb_mat

    size = section.nrows()
    unit = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
    coefficients, part = section.charpoly().coeffs(), unit
    traces: list[tuple[Any, Any]] = []  # of the adjugate's coefficients, the highest power first
    for k in reversed(range(size)):
        traces.append((trace_of(part * change), trace_of(part)))
        part = section * part + coefficients[k] * unit
    found: dict[str, arb] = {}
    polynomial = acb_poly(coefficients)
    slope = polynomial.derivative()
    for number, given in enumerate(multipliers, 1):
        multiplier = given.mid() - polynomial(given.mid()) / slope(given)  # the same, sharper
        above, below = acb(0), acb(0)
        for moved, own in traces:
            above, below = above * multiplier + moved, below * multiplier + own
        rate = above / below
        found[f"multiplier {number} re"] = rate.real
        if not multiplier.imag.contains(0):
            found[f"multiplier {number} im"] = rate.imag
    return found
