"""Functions of time of every linear motion, entire in the coefficients they depend on."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp


@lru_cache(maxsize=256)  # the derivatives of one function are one column
def _column(
    t: sp.Float, factors: tuple[tuple[sp.Float, ...], ...], dps: int
) -> tuple[mpmath.mpf, ...]:
    """Solution and derivatives at t of prod chi(d/dt) y = 0 that starts from (0, ..., 0, 1)."""
    product = [mpmath.mpf(1)]
    for factor in factors:
        polynomial = [*map(mpmath.mpf, factor), mpmath.mpf(1)]
        longer = [mpmath.mpf(0)] * (len(product) + len(factor))
        for i, a in enumerate(product):
            for j, b in enumerate(polynomial):
                longer[i + j] += a * b
        product = longer
    size = len(product) - 1
    companion = mpmath.zeros(size)
    for i in range(size):
        if i + 1 < size:
            companion[i, i + 1] = 1
        companion[size - 1, i] = -product[i]
    whole = mpmath.expm(companion * mpmath.mpf(t))
    return tuple(whole[i, size - 1] for i in range(size))


class ExponentialDifference(sp.Function):
    """Derivatives by the time of L^-1[1/prod_i chi_i](t), written (k, t, chi_1, ..., chi_j).

    Each factor chi is a monic polynomial in s, given by the Tuple of its coefficients from the
    constant up, without the leading one: (-r,) is s - r, (w^2, 2 b) is s^2 + 2 b s + w^2, (0,)
    is s. The function is the k-th derivative of the divided difference of exp(s t) over all
    roots of all factors. It is entire in the time and in all coefficients, equal roots or not.
    """

    @classmethod
    def eval(cls, k: Any, t: Any, *factors: Any) -> Any:
        """The function in normal form, with its factors in order.

        A power of time is written as such, and a derivative by lower ones where that is
        possible: with a factor s, or from the degree of the product on.
        """
        zero = sp.Tuple(sp.Integer(0))
        degree = sum(len(factor) for factor in factors)
        if all(factor == zero for factor in factors):
            return t ** (degree - 1 - k) / sp.factorial(degree - 1 - k) if k < degree else 0
        if k > 0 and zero in factors:
            kept = list(factors)
            kept.remove(zero)
            return cls(k - 1, t, *kept)
        if k >= degree:
            # prod chi (d/dt) annihilates it
            s = sp.Dummy("s")
            polynomials = [s ** len(f) + sum(c * s**i for i, c in enumerate(f)) for f in factors]
            _, *rest = sp.Poly(sp.expand(sp.Mul(*polynomials)), s).all_coeffs()
            lower = reversed(rest)
            return sp.Add(*(-c * cls(k - degree + i, t, *factors) for i, c in enumerate(lower)))
        ordered = sorted(factors, key=sp.default_sort_key)
        return None if list(factors) == ordered else cls(k, t, *ordered)

    def _eval_evalf(self, prec: int) -> sp.Expr | None:
        """Value with a precision of so many bits; None unless all arguments are numbers."""
        k, t, *factors = self.args
        if self.free_symbols:
            return None
        dps = mpmath.libmp.prec_to_dps(prec) + 5
        coefficients = tuple(tuple(c.evalf(dps) for c in factor) for factor in factors)
        with mpmath.workdps(dps):
            return sp.Float(_column(t.evalf(dps), coefficients, dps)[int(k)], precision=prec)

    def _eval_derivative(self, symbol: sp.Symbol) -> sp.Expr:
        """Derivative by a symbol that the time or a coefficient contains."""
        k, t, *factors = self.args
        total = sp.diff(t, symbol) * ExponentialDifference(k + 1, t, *factors)
        for factor in factors:
            for power, coefficient in enumerate(factor):
                rate = sp.diff(coefficient, symbol)
                if rate != 0:
                    total -= rate * ExponentialDifference(k + power, t, *factors, factor)
        return total
