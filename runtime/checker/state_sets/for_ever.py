"""Whether an affine function stays negative for ever, by the sizes of its exponentials.

Along a flow an affine function is a sum of terms c t^k e^(st) / k!. The exponents s are the
roots of its minimal polynomial, which is found exactly: so are their multiplicities, and
which of them lie on the imaginary axis.
"""

from collections.abc import Sequence
from math import comb, factorial
from typing import Any

from flint import acb, acb_mat, arb, fmpq_poly

from nonsmooth.runtime.checker.stated.exact import Elimination, product, reduced

Row = Any  # exact, over (y, 1)


def stays_negative(
    row: Row, field: Sequence[Row], lasting: Sequence[Row], state: Sequence[arb], time: arb
) -> bool:
    """Whether an affine function is proved to be negative from a time on, for ever.

    `row` and `field` are exact and act on (y, 1). `lasting` holds along the motion, `state`
    encloses it at time 0, and `time` is exact and not negative.
    """
    rows, minimal = _sequence(row, field, lasting)
    found = _coefficients(rows, _exponents(minimal), state)
    if found is None:
        return False
    total = arb(0)
    for exponent, coefficients in found:
        bound = (
            _drift([c.real for c in coefficients], time)
            if exponent == 0
            else _size(exponent.real, coefficients, time)
        )
        if bound is None:
            return False
        total += bound
    return bool(total < 0)


def _sequence(row: Row, field: Sequence[Row], lasting: Sequence[Row]) -> tuple[list[Row], Row]:
    """Return the rows of the independent derivatives, and the coefficients of the next one by them.

    These are the coefficients of the function's minimal polynomial.
    """
    rows = [reduced(row, lasting)]
    while not (kernel := Elimination().left_kernel(rows)):
        rows.append(reduced(product(rows[-1], field), lasting))
    return rows[:-1], kernel[0]


def _exponents(minimal: Row) -> list[tuple[acb, int]]:
    """Return a rational polynomial's roots with their multiplicities; real parts 0 are exact."""

    def roots(coefficients: Sequence[Any]) -> list[acb]:
        pairs: Any = fmpq_poly(list(coefficients)).complex_roots()
        return [acb(root) for root, _ in pairs]

    found = []
    for factor, multiplicity in fmpq_poly(list(minimal)).factor()[1]:
        coefficients = factor.coeffs()
        if len(coefficients) > 2 and not any(coefficients[1::2]):
            for square in roots(coefficients[::2]):
                below = square.imag.is_zero() and square.real < 0
                root = acb(0, (-square.real).sqrt()) if below else square.sqrt()
                found += [(root, multiplicity), (-root, multiplicity)]
        else:
            found += [(root, multiplicity) for root in roots(coefficients)]
    return found


def _coefficients(
    rows: Sequence[Row], exponents: Sequence[tuple[acb, int]], state: Sequence[arb]
) -> list[tuple[acb, list[acb]]] | None:
    """Return each exponent with the coefficients c of its terms, by the power of t.

    None is returned if the digits do not tell the exponents apart.
    """
    size = len(rows)
    columns = [
        [comb(j, k) * exponent ** (j - k) if j >= k else acb(0) for j in range(size)]
        for exponent, multiplicity in exponents
        for k in range(multiplicity)
    ]
    wronskian = acb_mat(size, size, [columns[i][j] for j in range(size) for i in range(size)])
    try:
        weights = wronskian.solve(acb_mat([[acb(entry) for entry in row] for row in rows]))
    except ZeroDivisionError:
        return None
    values = (weights * acb_mat([[acb(x)] for x in (*state, arb(1))])).entries()
    found, first = [], 0
    for exponent, multiplicity in exponents:
        found.append((exponent, values[first : first + multiplicity]))
        first += multiplicity
    return found


def _drift(coefficients: Sequence[arb], time: arb) -> arb | None:
    """Return the value of a polynomial at a time from which it does not rise, else None."""
    derivatives = [
        sum((c * time**j / factorial(j) for j, c in enumerate(coefficients[k:])), 0 * time)
        for k in range(len(coefficients))
    ]
    return derivatives[0] if all(d <= 0 for d in derivatives[1:]) else None


def _size(rate: arb, coefficients: Sequence[acb], time: arb) -> arb | None:
    """Return a bound, from a time on, of the terms with one exponent that is not zero, or None."""
    total = 0 * time
    for k, coefficient in enumerate(coefficients):
        if coefficient == 0:
            continue
        if rate.is_zero() and not k:
            total += abs(coefficient)
            continue
        if not rate < 0:
            return None
        # t^k e^(rate t) falls from its maximum on
        latest = time.max(-k / rate)
        total += abs(coefficient) * latest**k / factorial(k) * (rate * latest).exp()
    return total
