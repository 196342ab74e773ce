"""Divided differences of e^(lambda t) in balls and Taylor models: rigorous, without roots.

1/(chi_1 ... chi_m) is the transfer function of a chain of oscillators, each of which drives the
next: its impulse response is an entry of the exponential of one matrix, which is polynomial in the
coefficients. Over balls the mean value form keeps what that entry loses: at their middles in as
many digits as it needs, and derivatives over the whole ball, which are functions of the same kind,

    dG/dc_j of chi_i = -G^(j) with chi_i once more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from nonsmooth.runtime.core.taylor_models import matrix, middle_of
from nonsmooth.runtime.core.values import flint_precision

_SLOPE_BITS = 40  # of derivatives that are multiplied by radii
_GUARD = 30
_WIDE = 6  # bits of an enclosure that is worth another
_FAR = 10_000  # exponent of a number that no one has
_Factors = Sequence[Sequence[Any]]


def difference_in_models(k: int, t: Any, factors: _Factors) -> Any:
    """Derivative of order k of L^-1[1/prod chi_i](t) in Taylor models.

    Each factor holds the coefficients of a monic polynomial chi_i, from the constant up:
    integers, balls or models. Where nothing is a model, the result is the ball of plain
    ball arithmetic.
    """
    return _entries([k], t, factors)[0]


def difference_in_balls(k: int, t: Any, factors: _Factors) -> Any:
    """Enclosure of the derivative of order k of L^-1[1/prod chi_i](t), a ball.

    Each factor holds the coefficients of a monic polynomial chi_i, from the constant up:
    integers or balls. The mean value form is intersected with plain ball arithmetic, and
    where the result is wide also with partial fractions.
    """
    from flint import arb

    balls = {id(c): arb(c) for c in (t, *(c for factor in factors for c in factor))}
    time, middle = balls[id(t)], {name: ball.mid() for name, ball in balls.items()}
    centre = difference_near(k, middle[id(t)], [[middle[id(c)] for c in f] for f in factors])
    if all(ball.is_exact() for ball in balls.values()):
        return centre
    with flint_precision(_SLOPE_BITS):
        whole, slope = _entries([k, k + 1], time, factors)
        change = slope * (time - middle[id(t)])
        for factor in factors:
            inexact = [j for j, c in enumerate(factor) if not balls[id(c)].is_exact()]
            slopes = _entries([k + j for j in inexact], time, [*factors, factor])
            for j, found in zip(inexact, slopes, strict=True):
                change -= found * (balls[id(factor[j])] - middle[id(factor[j])])
    found = _both(centre + change, whole)
    if found.rel_accuracy_bits() < _WIDE:
        wide = [[balls[id(c)] for c in factor] for factor in factors]
        found = _both(found, _partial_fractions(k, time, wide))
    return found


def difference_near(k: int, t: Any, factors: _Factors) -> Any:
    """Enclosure of the derivative of order k of L^-1[1/prod chi_i](t) at exact numbers.

    It is sharp to the working precision, relative to the value or, where that is nearly zero,
    to the terms that cancel in it.
    """
    from flint import arb, ctx

    wanted = ctx.prec
    found: Any = arb("nan")
    for bits in (wanted + _GUARD, 2 * wanted + 2 * _GUARD, 4 * wanted + 4 * _GUARD):
        with flint_precision(bits):
            (found,) = _entries([k], t, factors)
        if found.rel_accuracy_bits() >= wanted + 4:
            break
    return +found


def _both(one: Any, two: Any) -> Any:
    """Intersection of two enclosures of a number; where only one is finite, that one."""
    if one.is_finite() and two.is_finite():
        return one.intersection(two)
    return one if one.is_finite() else two


def _partial_fractions(k: int, t: Any, factors: _Factors) -> Any:
    """The same derivative by partial fractions over the roots, where these are all apart.

    Wide balls are not blown up by the squaring in a matrix exponential. The result is NaN
    where roots may be equal, or a factor has a degree above 2.
    """
    from flint import acb, arb

    roots = []
    for factor in factors:
        if len(factor) == 1:
            roots.append(acb(-factor[0]))
            continue
        mean = -factor[1] / 2
        square = mean * mean - factor[0]
        if len(factor) > 2 or square.contains(0):
            return arb("nan")
        root = acb(square.sqrt()) if square > 0 else acb(0, (-square).sqrt())
        roots += [mean + root, mean - root]
    total = acb(0)
    for place, root in enumerate(roots):
        term = root**k * (root * t).exp()
        for other in roots[:place] + roots[place + 1 :]:
            term /= root - other
        total += term
    return total.real


def _entries(orders: Sequence[int], t: Any, factors: _Factors) -> list[Any]:
    """Derivatives of L^-1[1/prod chi_i](t) of some orders, from one matrix exponential."""
    if not orders:
        return []
    factors = sorted(factors, key=len)
    rows, scale = _chain(factors)
    size = len(rows)
    flow = matrix([[row[j] * t if j in row else 0 for j in range(size)] for row in rows]).exp()
    driven = len(factors[0]) - 1
    output: dict[int, Any] = {size - len(factors[-1]): 1}
    found = []
    for order in range(max(orders) + 1):
        if order:
            output = _times(output, rows)
        terms = [x * flow[place, driven] for place, x in output.items()]
        found.append(sum(terms[1:], terms[0]) * scale)
    return [found[order] for order in orders]


def _times(row: dict[int, Any], rows: Sequence[dict[int, Any]]) -> dict[int, Any]:
    """Product of a row and a matrix, both as places and entries without the zeros."""
    found: dict[int, Any] = {}
    for place, x in row.items():
        for column, y in rows[place].items():
            found[column] = found[column] + x * y if column in found else x * y
    return found


def _chain(factors: _Factors) -> tuple[list[dict[int, Any]], Any]:
    """Rows of the matrix of the chain, and the factor that scales its response.

    Each factor drives the next. States are scaled by powers of two so that no entry is much
    larger than the roots.
    """
    from flint import arb

    sizes = [_exponent(factor) for factor in factors]
    coupling = max(sizes)
    rows: list[dict[int, Any]] = []
    before = factors[0]
    for factor, size in zip(factors, sizes, strict=True):
        begin, unit = len(rows), arb((1, size))
        last = begin + len(factor) - 1
        if len(factor) == 2:
            mean = factor[1] * arb((-1, -1))
            rows.append({begin: mean, last: unit})
            rows.append({begin: (mean * mean - factor[0]) / unit, last: mean})
        else:
            rows += [{place + 1: unit} for place in range(begin, last)]
            lowest = len(factor) - 1
            rows.append({begin + j: -c * unit ** (j - lowest) for j, c in enumerate(factor)})
        if begin:
            rows[last][begin - len(before)] = arb((1, coupling))
        before = factor
    scale = -sum((len(f) - 1) * s for f, s in zip(factors, sizes, strict=True))
    return rows, arb((1, scale - (len(factors) - 1) * coupling))


def _exponent(factor: Sequence[Any]) -> int:
    """Exponent of a power of two near the modulus of the largest root."""
    largest = float(-_FAR)
    for j, c in enumerate(factor):
        size = abs(float(c if isinstance(c, int) else middle_of(c)))
        if 0 < size < math.inf:
            largest = max(largest, math.frexp(size)[1] / (len(factor) - j))
    return round(largest) if largest > -_FAR else 0
