"""The arithmetics that generated kernels run over: floats, mpmath, balls.

Each gives the functions that the kernels take as ``lib``: ``sin``, ``cos``, ``sqrt``,
``angle`` (in [0, 2 pi)), ``rational``, ``constant`` (a number by its text), and the entire
functions of nonsmooth.derive.flows.entire.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from typing import Any

import numpy as np

from nonsmooth.runtime.core.exponentials.in_balls import (
    difference_in_balls,
    difference_in_models,
    difference_near,
)
from nonsmooth.runtime.core.exponentials.in_doubles import exponential_difference
from nonsmooth.runtime.core.taylor_models import TaylorModel
from nonsmooth.runtime.core.values import Value, flint_precision, parse


class Floats:
    """Double precision, elementwise over NumPy arrays."""

    sin, cos, sqrt = staticmethod(np.sin), staticmethod(np.cos), staticmethod(np.sqrt)
    pi = math.pi
    exponential_difference = staticmethod(exponential_difference)

    @staticmethod
    def angle(sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of the points with these coordinates, which broadcast."""
        angle = np.arctan2(sine, cosine)
        return np.where(angle < 0, angle + 2 * np.pi, angle)

    @staticmethod
    def rational(numerator: int, denominator: int) -> float:
        """Quotient of two integers."""
        return numerator / denominator

    @staticmethod
    def constant(text: str) -> float:
        """Double nearest to the number of a text in the grammar of `parse`."""
        return float(parse(text))


FLOATS = Floats()


class Mpmath:
    """mpmath at a working precision of `digits` decimals, kept in a context of its own."""

    def __init__(self, digits: int) -> None:
        from mpmath import MPContext

        self.digits = digits
        self.mp = MPContext()
        self.mp.dps = digits
        self.sin, self.cos, self.sqrt = self.mp.sin, self.mp.cos, self.mp.sqrt
        self.pi = self.mp.pi

    @contextmanager
    def working(self, digits: int) -> Iterator[None]:
        """Compute with that many decimals inside the block."""
        before, self.mp.dps = self.mp.dps, digits
        try:
            yield
        finally:
            self.mp.dps = before

    def number(self, value: Value) -> Any:
        """The value of a parameter as an mpf at the working precision."""
        return self.mp.mpf(value.mpf(self.mp.dps))

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of the point with these coordinates, as an mpf."""
        angle = self.mp.atan2(sine, cosine)
        return angle if angle >= 0 else angle + 2 * self.mp.pi

    def rational(self, numerator: int, denominator: int) -> Any:
        """Quotient of two integers as an mpf at the working precision."""
        return self.mp.mpf(numerator) / denominator

    def exponential_difference(self, k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """Derivative of order k of L^-1[1/prod chi_i](t) as an mpf.

        Each factor holds the coefficients of a monic polynomial chi_i, from the constant up.
        The result is NaN where an argument is not finite.
        """
        if not all(map(self.mp.isfinite, (t, *(c for factor in factors for c in factor)))):
            return self.mp.nan
        with flint_precision(self.mp.prec):
            exact = [[exact_ball(c) for c in factor] for factor in factors]
            return middle(self.mp, difference_near(k, exact_ball(t), exact))

    def constant(self, text: str) -> Any:
        """The number of a text in the grammar of `parse`, as an mpf at the working precision."""
        return self.number(parse(text))

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Solution (n,) of a linear system with the rows (n, n) and the right-hand side (n,).

        Raises ZeroDivisionError if the matrix is singular at the working precision.
        """
        return list(self.mp.lu_solve(self.mp.matrix(matrix), self.mp.matrix(right)))


class Balls:
    """Ball arithmetic: every result encloses the exact one."""

    def __init__(self) -> None:
        import flint

        self.flint = flint

    @property
    def pi(self) -> Any:
        """A ball around pi, at the working precision."""
        return self.flint.arb.pi()

    @staticmethod
    def working(bits: int) -> AbstractContextManager[None]:
        """Compute with that many bits inside the block; other threads wait."""
        return flint_precision(bits)

    def number(self, value: Value) -> Any:
        """A ball around the value of a parameter, at the working precision."""
        return value.ball(self.flint.ctx.prec)

    def sin(self, x: Any) -> Any:
        """Ball around the sine of a ball or of an integer."""
        return self.flint.arb(x).sin() if isinstance(x, int) else x.sin()

    def cos(self, x: Any) -> Any:
        """Ball around the cosine of a ball or of an integer."""
        return self.flint.arb(x).cos() if isinstance(x, int) else x.cos()

    @staticmethod
    def sqrt(x: Any) -> Any:
        """Ball around the square root of a ball."""
        return x.sqrt()

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Ball around the angle in [0, 2 pi) of a point; near angle 0 around both branches."""
        arb = self.flint.arb
        angle = arb.atan2(sine, cosine)
        if sine >= 0:
            return angle
        turned = angle + 2 * arb.pi()
        return turned if sine < 0 else angle.union(turned)

    def rational(self, numerator: int, denominator: int) -> Any:
        """Ball around the quotient of two integers."""
        return self.flint.arb(numerator) / denominator

    @staticmethod
    def exponential_difference(k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """Enclosure of the derivative of order k of L^-1[1/prod chi_i](t).

        Each factor holds the coefficients of a monic polynomial chi_i, from the constant up.
        The enclosure is a Taylor model where any argument is one, else a ball.
        """
        numbers = (t, *(c for factor in factors for c in factor))
        if any(isinstance(number, TaylorModel) for number in numbers):
            return difference_in_models(k, t, factors)
        return difference_in_balls(k, t, factors)

    def constant(self, text: str) -> Any:
        """Ball around the number of a text in the grammar of `parse`, at the working precision."""
        return self.number(parse(text))

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Enclosure (n,) of the solution of a linear system with the rows (n, n).

        Raises ZeroDivisionError if the matrix may be singular.
        """
        column = self.flint.arb_mat([[x] for x in right])
        return list(self.flint.arb_mat([list(row) for row in matrix]).solve(column).entries())


def exact_ball(number: Any) -> Any:
    """A ball of radius zero at an integer, a float or an mpmath number."""
    from flint import arb

    if isinstance(number, (int, float)):
        return arb(number)
    sign, mantissa, exponent, _ = number._mpf_
    return arb((int(-mantissa if sign else mantissa), int(exponent)))


def middle(mp: Any, ball: Any) -> Any:
    """The midpoint of a ball as a number of an mpmath context, at its precision."""
    mantissa, exponent = ball.mid().man_exp()
    return mp.ldexp(mp.mpf(int(mantissa)), int(exponent))
