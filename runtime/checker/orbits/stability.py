"""Whether the multipliers of an orbit lie inside the unit circle, or on it; pairs of them."""

from collections.abc import Iterator
from itertools import combinations, pairwise
from math import comb
from typing import Any

from flint import acb, acb_poly, arb, arb_poly, ctx

from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, trace_of
from nonsmooth.runtime.checker.stated.exact import Numbers, Verdict, demand, demand_sign
from nonsmooth.runtime.core.taylor_models import (
    TaylorModel,
    matrix,
    middle_of,
    range_of,
    unit_matrix,
)

MULTIPLIERS = {"flip": -1, "fold": 1, "neimark-sacker": 0}
_LEAST_SLOPE = 2.0**-72  # of a polynomial at its roots that are told apart
CORNER = "boundaries are reached together: the Poincare map has a corner"
TANGENTIAL = "a boundary may be reached tangentially"
_ON_CIRCLE = {
    "stable": "a multiplier cannot be told from the unit circle",
    "neutral": "a nontrivial pair of multipliers cannot be told from a double one",
}
_SQUARINGS = 12  # of roots, before nothing is said of them


def multipliers(orbit: CheckedOrbit) -> list[Any]:
    """Return the nontrivial multipliers that are clearly simple, the largest first, as balls.

    Real ones have no imaginary part. Newton's map leads into each ball. On a section with fewer
    coordinates than the orbit has, all further multipliers are zero. Those that are nearly zero,
    or nearly another one, are left out; all are if some cannot be told apart.
    """
    section, declared = orbit.section, orbit.declared
    polynomial = acb_poly([acb(c) for c in reversed(characteristic(section))])
    slope, neutral = polynomial.derivative(), declared.stability == "neutral"
    try:
        roots = [_sharper(polynomial, slope, root) for root in polynomial.roots()]
    except ValueError:
        return []
    if sum(1 for root in roots if root.contains(1)) > 1 and neutral:
        return []
    zeros = len(declared.free) - section.nrows()
    found: list[Any] = []
    for root in roots:
        clear = abs(slope(root) * root**zeros) > _LEAST_SLOPE
        if not clear or (neutral and root.contains(1)):
            continue
        others = [other for other in roots if other.overlaps(root.conjugate())]
        if len(others) == 1 and others[0] is root:  # its conjugate is a root, too
            found.append([acb(root.real)])
        elif root.imag > 0:
            found.append([root, root.conjugate()])
    found.sort(key=lambda pair: -float(abs(pair[0]).mid()))
    return [root for pair in found for root in pair]


def _sharper(polynomial: Any, slope: Any, root: Any) -> Any:
    """Return a smaller ball around the root of a polynomial that is alone in a ball."""
    for _ in range(ctx.prec.bit_length()):
        middle = root.mid()
        moved = middle - polynomial(middle) / slope(root)
        if not (moved.is_finite() and moved.rad() < root.rad()):
            break
        root = moved
    return root


def others_below(orbit: CheckedOrbit, known: Numbers) -> Any:
    """Return a bound on the absolute values of all nontrivial multipliers but the known ones.

    The characteristic polynomial divided by the known roots, and by the trivial one, has roots
    that are at most twice the largest k-th root of its k-th coefficient (M. Fujiwara, 1916).
    """
    coefficients = [*map(acb, characteristic(orbit.section))]
    for root in (*known, *[acb(1)] * (orbit.declared.stability == "neutral")):
        carried, kept = acb(0), coefficients[:-1]
        coefficients = []
        for coefficient in kept:
            carried = coefficient + root * carried
            coefficients.append(carried)
    sizes = (arb(abs(x).upper()).root(k) for k, x in enumerate(coefficients[1:], 1))
    return 2 * max((size.upper() for size in sizes), default=arb(0))


def judged_stability(orbit: CheckedOrbit) -> Verdict:
    """Return the verdict on an orbit's kind of stability, with the reason where it is not proved.

    `Failure` is raised if the Poincare map's derivative is not known.
    """
    demand(range_of(trace_of(orbit.section)).is_finite(), TANGENTIAL)
    demand(orbit.declared.alone, CORNER)
    claim = stability(orbit)
    told = {"refuted": "a multiplier lies outside the unit circle", "proved": ""}
    return Verdict(claim, told.get(claim, _ON_CIRCLE[orbit.declared.stability]))


def stability(orbit: CheckedOrbit) -> str:
    """Return the verdict "proved", "refuted" or "undecided" on an orbit's kind of stability.

    The kind is that of `StatedSystem.stability`: all multipliers are inside the unit
    circle, or all are on it but for zeros. `Failure` is raised if the maps are one-sided.
    """
    demand(orbit.declared.alone, "one-sided maps")
    if orbit.declared.stability == "stable":
        polynomial = characteristic(orbit.section)
        verdict = _inside(polynomial)
        return _throughout(polynomial) if verdict == "undecided" else verdict
    return _neutral(orbit.section, orbit.declared.size)


def outside_if_reached(orbit: CheckedOrbit, place: int) -> bool:
    """Return whether a multiplier is surely outside the unit circle if a phase ends with v > 0.

    The speed v is the boundary function's rate there, and the map divides by it. All
    roots of v p(z), with p its characteristic polynomial, are inside only if the
    coefficient of z^(n - 1) is at most n v in size. That coefficient is minus the trace
    of v times the map, which is regular where v is zero. `place` is the phase, counted
    from 0.
    """
    declared = orbit.declared
    if not declared.alone or declared.stability != "stable":
        return False
    square = orbit.map_on(*declared.section, slow=place)
    total, most = trace_of(square), square.nrows() * orbit.speed(place)
    signs = [total - most, total + most]
    return all(x > 0 for x in signs) or all(x < 0 for x in signs)


def _neutral(square: Any, size: int) -> str:
    """Return the verdict on multipliers on the unit circle, by sign changes of g(s), s = m + 1/m.

    The map is symplectic: beside 1 and zeros its multipliers are pairs m, 1/m. They are
    all on the circle if g changes its sign often enough in (-2, 2).
    """
    pairs: list[Any] = []
    for coefficient in characteristic(square)[: size - 1]:  # divided by m - 1
        pairs.append(coefficient + pairs[-1] if pairs else coefficient)
    half = len(pairs) // 2
    if half == 0:
        return "proved"
    powers = [arb_poly([2]), arb_poly([0, 1])]  # m^k + 1/m^k in s
    while len(powers) <= half:
        powers.append(powers[1] * powers[-1] - powers[-2])

    def g(s: Any) -> Any:
        terms = (pairs[half - k] * powers[k](s) for k in range(1, half + 1))
        return sum(terms, arb(0)) + pairs[half]

    middle = arb_poly([middle_of(pairs[half])])
    for k in range(1, half + 1):
        middle += powers[k] * middle_of(pairs[half - k])
    try:
        near = sorted((s.real.mid() for s in acb_poly(middle).roots()), key=float)
    except ValueError:
        return "undecided"
    between = [(a + b).mid() / 2 for a, b in pairwise(near)]
    signs = [(-1) ** (half - k) * g(s) for k, s in enumerate([arb(-2), *between, arb(2)])]
    if all(sign > 0 for sign in signs):
        return "proved"
    if signs[0] < 0 or signs[-1] < 0:
        return "refuted"
    for _ in range(50):  # a large trace means that one is outside
        if abs(trace_of(square)) > square.nrows():
            return "refuted"
        square = square * square
    return "undecided"


def characteristic(square: Any) -> list[Any]:
    """Return the coefficients (n + 1) of the characteristic polynomial, from the first, 1, on.

    By the algorithm of U. Le Verrier (1840), D. K. Faddeev and I. S. Sominsky (1949), for
    a matrix of balls or Taylor models.
    """
    size = square.nrows()
    unit = unit_matrix(size)
    found, power = [arb(1)], unit
    for k in range(1, size + 1):
        power = square * power
        found.append(-trace_of(power) / k)
        power = power + found[-1] * unit
    return found


def _inside(polynomial: list[Any]) -> str:
    """Return the verdict on all roots being inside the unit circle: Schur (1917), Cohn (1922).

    Of z^n + ... + k, with |k| < 1, p(z) - k z^n p(1/z) has as many roots outside. Where
    p(1) or (-1)^n p(-1) is negative, a real root is outside, as p is positive far out.
    Where the coefficients are too wide for this, the roots are squared instead, which
    drives them apart.
    """
    ahead = sum(polynomial, arb(0))
    behind = sum((c * (-1) ** k for k, c in enumerate(polynomial)), arb(0))
    if ahead < 0 or behind < 0:
        return "refuted"
    whole = polynomial
    while len(polynomial) > 1:
        last = polynomial[-1]
        if abs(last) > 1:
            return "refuted"
        if not abs(last) < 1:
            return "refuted" if _some_outside(whole) else "undecided"
        pairs = zip(polynomial, reversed(polynomial), strict=True)
        rest = [(x - last * y) / (1 - last * last) for x, y in pairs]
        polynomial = [arb(1), *rest[1:-1]]
    return "proved"


def _some_outside(polynomial: list[Any]) -> bool:
    """Return whether a root is surely outside the unit circle, by powers of the roots.

    If all n roots were inside, no coefficient would be larger than the binomial one. The
    roots of (-1)^n p(z) p(-z), as a polynomial in z^2, are the squares of p's (G.
    Dandelin, 1826, and K. Graeffe, 1837).
    """
    size = len(polynomial) - 1
    for _ in range(_SQUARINGS):
        if any(abs(range_of(c)) > comb(size, k) for k, c in enumerate(polynomial)):
            return True
        squared = []
        for k, own in enumerate(polynomial):
            total = own * own
            for j in range(1, min(k, size - k) + 1):
                total = total + 2 * (-1) ** j * polynomial[k - j] * polynomial[k + j]
            squared.append((-1) ** k * total)
        polynomial = squared
    return False


def _throughout(polynomial: Numbers) -> str:
    """Return the verdict at the middle of the parameters, if no root passes the circle between.

    The roots depend continuously on the parameters; those that pass are 1, or -1, or a
    pair with the product 1.
    """
    models = [c for c in polynomial if isinstance(c, TaylorModel)]
    if not models:
        return "undecided"
    if not all(value > 0 or value < 0 for _, value in passings(polynomial)):
        return "undecided"
    middle = [arb(0)] * models[0].space.variables
    return _inside([c.at(middle) if isinstance(c, TaylorModel) else c for c in polynomial])


def products_less_one(polynomial: Numbers) -> Any:
    """Return the product of all 1 - x y of two roots, as a determinant of Jury's.

    Coefficients go from the highest power on; the first is 1.
    """
    size = len(polynomial) - 2

    def entry(k: int) -> Any:
        return polynomial[k] if 0 <= k <= size + 1 else arb(0)

    rows = [[entry(j - i) - entry(2 * size - i - j) for j in range(size)] for i in range(size)]
    return (-1) ** size * characteristic(matrix(rows))[-1]


def paired(polynomial: Numbers) -> bool:
    """Return whether all pairs of roots whose product may be 1 are surely conjugate, not real.

    Coefficients go from the highest power on.
    """
    try:
        roots = acb_poly([acb(range_of(c)) for c in reversed(polynomial)]).roots()
    except ValueError:
        return False
    for first, second in combinations(roots, 2):
        if (first * second).contains(1):
            # the conjugate is a root, and in no other ball it is the second
            like = [x for x in roots if first.conjugate().overlaps(x)]
            if first.imag.contains(0) or len(like) != 1 or like[0] is not second:
                return False
    return True


def passing(polynomial: Numbers, kind: str) -> Any:
    """Return a number that is zero where a multiplier is -1 or 1, or two have the product 1.

    `kind` is "flip", "fold" or "neimark-sacker"; coefficients of the characteristic
    polynomial go from the highest power on.
    """
    if kind == "neimark-sacker":
        return products_less_one(polynomial)
    total: Any = arb(0)
    for coefficient in polynomial:
        total = total * MULTIPLIERS[kind] + coefficient
    return total


def passings(polynomial: Numbers, but: str = "") -> Iterator[tuple[str, Any]]:
    """Yield ways in which multipliers may pass the unit circle, with ranges of their numbers."""
    for kind in MULTIPLIERS:
        if kind != but and (kind != "neimark-sacker" or len(polynomial) > 2):
            yield kind, range_of(passing(polynomial, kind))


def demand_alone(orbit: CheckedOrbit, kind: str) -> None:
    """Demand that multipliers can pass the unit circle in no other way than `kind`.

    `kind` is "flip", "fold" or "neimark-sacker".
    """
    demand(orbit.declared.alone, "one-sided maps")
    if orbit.declared.stability == "neutral":
        demand(kind == "flip" and orbit.declared.size == 4, "more than one pair")
        total = range_of(trace_of(orbit.section)) - 1  # m + 1/m of the pair
        demand(total > 2 or total < 2, "the pair may meet at 1")
        return
    for other, value in passings(characteristic(orbit.section), kind):
        demand_sign(value, f"there may be another event: {other}")
