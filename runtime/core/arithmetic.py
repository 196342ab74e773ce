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

from nonsmooth.runtime.core.exponential_balls import (
    difference_in_balls,
    difference_in_models,
    difference_near,
)
from nonsmooth.runtime.core.exponential_differences import exponential_difference
from nonsmooth.runtime.core.taylor_models import TaylorModel
from nonsmooth.runtime.core.values import Value, flint_precision, parse

__all__ = ["FLOATS", "Balls", "Floats", "Mpmath", "exact_ball", "middle"]


class Floats:
    """Double precision, elementwise over NumPy arrays."""

    sin, cos, sqrt = staticmethod(np.sin), staticmethod(np.cos), staticmethod(np.sqrt)
    pi = math.pi

    @staticmethod
    def angle(sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point.

        Parameters
        ----------
        sine, cosine : float or ndarray
            Coordinates of the point; arrays broadcast.

        Returns
        -------
        ndarray
            In radians.
        """
        angle = np.arctan2(sine, cosine)
        return np.where(angle < 0, angle + 2 * np.pi, angle)

    @staticmethod
    def rational(numerator: int, denominator: int) -> float:
        """Quotient of two integers."""
        return numerator / denominator

    @staticmethod
    def exponential_difference(k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """Derivative of order k of L^-1[1/prod chi_i](t): see exponential_differences.

        Parameters
        ----------
        k : int
        t : float or ndarray
        *factors : tuple of float or ndarray
            Coefficients of each monic polynomial, from the constant up.

        Returns
        -------
        float or ndarray
        """
        return exponential_difference(k, t, *factors)

    @staticmethod
    def constant(text: str) -> float:
        """Double nearest to a number.

        Parameters
        ----------
        text : str
            As `nonsmooth.runtime.core.values.parse` takes it.
        """
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
        """Compute with that many decimals inside the block.

        Parameters
        ----------
        digits : int
            Decimals.
        """
        before, self.mp.dps = self.mp.dps, digits
        try:
            yield
        finally:
            self.mp.dps = before

    def number(self, value: Value) -> Any:
        """A parameter at the working precision.

        Returns
        -------
        mpf
        """
        return self.mp.mpf(value.mpf(self.mp.dps))

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point.

        Parameters
        ----------
        sine, cosine : mpf
            Coordinates of the point.

        Returns
        -------
        mpf
            In radians.
        """
        angle = self.mp.atan2(sine, cosine)
        return angle if angle >= 0 else angle + 2 * self.mp.pi

    def rational(self, numerator: int, denominator: int) -> Any:
        """Quotient of two integers.

        Returns
        -------
        mpf
        """
        return self.mp.mpf(numerator) / denominator

    def exponential_difference(self, k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """Derivative of order k of L^-1[1/prod chi_i](t): see exponential_differences.

        Parameters
        ----------
        k : int
        t : mpf or int
        *factors : tuple of mpf or int
            Coefficients of each monic polynomial, from the constant up.

        Returns
        -------
        mpf
        """
        if not all(map(self.mp.isfinite, (t, *(c for factor in factors for c in factor)))):
            return self.mp.nan
        with flint_precision(self.mp.prec):
            exact = [[exact_ball(c) for c in factor] for factor in factors]
            return middle(self.mp, difference_near(k, exact_ball(t), exact))

    def constant(self, text: str) -> Any:
        """A number at the working precision.

        Parameters
        ----------
        text : str
            As `nonsmooth.runtime.core.values.parse` takes it.

        Returns
        -------
        mpf
        """
        return self.number(parse(text))

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Solution of a square linear system.

        Parameters
        ----------
        matrix : sequence of sequence of mpf
            Rows of a square matrix (n, n).
        right : sequence of mpf
            Right-hand side (n,).

        Returns
        -------
        list of mpf
            Of length n.

        Raises
        ------
        ZeroDivisionError
            If the matrix is singular at the working precision.
        """
        return list(self.mp.lu_solve(self.mp.matrix(matrix), self.mp.matrix(right)))


class Balls:
    """Ball arithmetic: every result encloses the exact one."""

    def __init__(self) -> None:
        import flint

        self.flint = flint

    @property
    def pi(self) -> Any:
        """The circle's number, at the working precision."""
        return self.flint.arb.pi()

    @staticmethod
    def working(bits: int) -> AbstractContextManager[None]:
        """Compute with that many bits inside the block; other threads wait."""
        return flint_precision(bits)

    def number(self, value: Value) -> Any:
        """A ball around a parameter, at the working precision.

        Returns
        -------
        arb
        """
        return value.ball(self.flint.ctx.prec)

    def sin(self, x: Any) -> Any:
        """Sine.

        Parameters
        ----------
        x : arb or int
            In radians.

        Returns
        -------
        arb
        """
        return self.flint.arb(x).sin() if isinstance(x, int) else x.sin()

    def cos(self, x: Any) -> Any:
        """Cosine.

        Parameters
        ----------
        x : arb or int
            In radians.

        Returns
        -------
        arb
        """
        return self.flint.arb(x).cos() if isinstance(x, int) else x.cos()

    @staticmethod
    def sqrt(x: Any) -> Any:
        """Square root.

        Parameters
        ----------
        x : arb

        Returns
        -------
        arb
        """
        return x.sqrt()

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point; the union of both branches near angle 0.

        Parameters
        ----------
        sine, cosine : arb
            Coordinates of the point.

        Returns
        -------
        arb
            In radians.
        """
        arb = self.flint.arb
        angle = arb.atan2(sine, cosine)
        if sine >= 0:
            return angle
        turned = angle + 2 * arb.pi()
        return turned if sine < 0 else angle.union(turned)

    def rational(self, numerator: int, denominator: int) -> Any:
        """Ball around the quotient of two integers.

        Returns
        -------
        arb
        """
        return self.flint.arb(numerator) / denominator

    @staticmethod
    def exponential_difference(k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """Enclosure of the derivative of order k of L^-1[1/prod chi_i](t).

        Parameters
        ----------
        k : int
        t : arb, TaylorModel or int
        *factors : tuple of arb, TaylorModel or int
            Coefficients of each monic polynomial, from the constant up.

        Returns
        -------
        arb, or TaylorModel where any argument is one
        """
        numbers = (t, *(c for factor in factors for c in factor))
        if any(isinstance(number, TaylorModel) for number in numbers):
            return difference_in_models(k, t, factors)
        return difference_in_balls(k, t, factors)

    def constant(self, text: str) -> Any:
        """Ball around a number, at the working precision.

        Parameters
        ----------
        text : str
            As `nonsmooth.runtime.core.values.parse` takes it.

        Returns
        -------
        arb
        """
        return self.number(parse(text))

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Enclosure of the solution of a square linear system.

        Parameters
        ----------
        matrix : sequence of sequence of arb
            Rows of a square matrix (n, n).
        right : sequence of arb
            Right-hand side (n,).

        Returns
        -------
        list of arb
            Of length n.

        Raises
        ------
        ZeroDivisionError
            If the matrix may be singular.
        """
        column = self.flint.arb_mat([[x] for x in right])
        return list(self.flint.arb_mat([list(row) for row in matrix]).solve(column).entries())


def exact_ball(number: Any) -> Any:
    """A ball of no radius at an integer, a float or an mpmath number.

    Parameters
    ----------
    number : int, float or mpf

    Returns
    -------
    arb
    """
    from flint import arb

    if isinstance(number, (int, float)):
        return arb(number)
    sign, mantissa, exponent, _ = number._mpf_
    return arb((int(-mantissa if sign else mantissa), int(exponent)))


def middle(mp: Any, ball: Any) -> Any:
    """The midpoint of a ball as an mpmath number of a context's precision.

    Parameters
    ----------
    mp : MPContext
        The context.
    ball : arb

    Returns
    -------
    mpf
    """
    mantissa, exponent = ball.mid().man_exp()
    return mp.ldexp(mp.mpf(int(mantissa)), int(exponent))
