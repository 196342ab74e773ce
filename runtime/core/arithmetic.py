"""The arithmetics that generated kernels run over: floats, mpmath, balls.

Each gives the functions that the kernels take as ``lib``: ``sin``, ``cos``, ``sqrt``,
``angle`` (in [0, 2 pi)), ``rational``, and the entire functions of nonsmooth.derive.flows.entire.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from typing import Any

import numpy as np

from nonsmooth.runtime.core.values import Value, flint_precision

__all__ = ["FLOATS", "Balls", "Floats", "Mpmath", "exact_ball", "middle"]

_Matrix = list[list[Any]]


class _Entire:
    """Entire functions c_k of a number's divided differences, in any arithmetic.

    A divided difference, and a coefficient modulo powers of a quadratic, are entries of c_k
    of a small matrix. That is computed from Taylor's series at a fraction of the time,
    which is then doubled: c_0 -> 2 c_0^2 - 1, c_1 -> 2 c_0 c_1, c_2 -> 2 c_1^2,
    c_3 -> 2 (c_3 + c_1 c_2). No step divides.
    """

    def entire_difference(self, k: int, t: Any, *nodes: Any) -> Any:
        """Divided difference c_k[nodes](t)."""
        size = len(nodes)
        matrix: _Matrix = [[0] * size for _ in range(size)]
        for i, node in enumerate(nodes):
            matrix[i][i] = node
            if i:
                matrix[i][i - 1] = 1
        return self._entire(matrix, k, t)[size - 1][0]

    def entire_pair(self, k: int, level: int, part: int, t: Any, m: Any, d: Any) -> Any:
        """Coefficient of (l - m)^part q^level in c_k(l, t), q = (l - m)^2 - d."""
        size = 2 * (level + 1)
        matrix: _Matrix = [[0] * size for _ in range(size)]
        for i in range(size):
            matrix[i][i] = m
            if i:
                matrix[i][i - 1] = 1
            if i % 2:
                matrix[i - 1][i] = d
        return self._entire(matrix, k, t)[2 * level + part][0]

    def _entire(self, matrix: _Matrix, k: int, t: Any) -> _Matrix:
        size = sum(self._size(entry) for row in matrix for entry in row)
        doublings = max(0, math.ceil(math.log2(max(math.sqrt(size) * self._size(t), 0.5)) + 1))
        step = t / 2**doublings
        unit = [[1 if i == j else 0 for j in range(len(matrix))] for i in range(len(matrix))]
        terms, error = self._length(size * self._size(step) ** 2)
        functions = []
        for order in range(4):
            total: _Matrix = [[0 * step for _ in row] for row in matrix]
            power, factor = unit, step**order / math.factorial(order)
            for j in range(terms):
                total = _combine(1, total, factor, power)
                power = _product(power, matrix)
                factor = -factor * step * step / ((order + 2 * j + 1) * (order + 2 * j + 2))
            functions.append([[self._widen(x, error) for x in row] for row in total])
        c0, c1, c2, c3 = functions
        for _ in range(doublings):
            product, mixed = _product(c0, c1), _product(c1, c2)
            square, rise = _product(c0, c0), _product(c1, c1)
            c3 = _combine(2, c3, 2, mixed)
            c0 = _combine(2, square, -1, unit)
            c1, c2 = _combine(2, product, 0, unit), _combine(2, rise, 0, unit)
        return (c0, c1, c2, c3)[k]

    def _size(self, number: Any) -> float:
        """Upper bound of the absolute value, over an array if it is one."""
        return float(abs(number))

    def _length(self, size: float) -> tuple[int, float]:
        """Number of Taylor terms for a matrix of that norm, and a bound on the rest."""
        raise TypeError("an arithmetic says how long its series are")

    def _widen(self, number: Any, error: float) -> Any:
        return number


def _combine(p: Any, left: _Matrix, q: Any, right: _Matrix) -> _Matrix:
    return [
        [p * x + q * y for x, y in zip(a, b, strict=True)] for a, b in zip(left, right, strict=True)
    ]


def _product(left: _Matrix, right: _Matrix) -> _Matrix:
    size = len(left)
    return [
        [sum(left[i][k] * right[k][j] for k in range(size)) for j in range(size)]
        for i in range(size)
    ]


def _series_length(size: float, bits: int) -> int:
    """Terms after which the remainder size^n/(2n)! of the series is below 2^-bits."""
    terms, log = 1, 0.0
    while log > -(bits + 2) or terms < 3:
        log += math.log2(max(size, 2.0**-60)) - math.log2(2 * terms * (2 * terms - 1))
        terms += 1
    return terms


class Floats(_Entire):
    """Double precision, elementwise over NumPy arrays."""

    sin, cos, sqrt = staticmethod(np.sin), staticmethod(np.cos), staticmethod(np.sqrt)

    @staticmethod
    def angle(sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point."""
        angle = np.arctan2(sine, cosine)
        return np.where(angle < 0, angle + 2 * np.pi, angle)

    @staticmethod
    def rational(numerator: int, denominator: int) -> float:
        """RationalFunction of two integers."""
        return numerator / denominator

    @staticmethod
    def eigenvalue(index: int, matrix: _Matrix) -> Any:
        """Eigenvalue of a matrix, counted by real, then imaginary part; complex if any is."""
        entries = np.broadcast_arrays(*(entry for row in matrix for entry in row))
        stacked = np.stack(entries, axis=-1).reshape(*entries[0].shape, len(matrix), len(matrix))
        values = np.sort_complex(np.linalg.eigvals(stacked.astype(float)))
        return (values.real if not values.imag.any() else values)[..., index]

    def _size(self, number: Any) -> float:
        largest = float(np.max(np.abs(number)))
        return largest if math.isfinite(largest) else 0.0

    def _length(self, size: float) -> tuple[int, float]:
        return _series_length(size, 56), 0.0


FLOATS = Floats()


class Mpmath(_Entire):
    """mpmath at a working precision of `digits` decimals, kept in a context of its own."""

    def __init__(self, digits: int) -> None:
        from mpmath import MPContext

        self.digits = digits
        self.mp = MPContext()
        self.mp.dps = digits
        self.sin, self.cos, self.sqrt = self.mp.sin, self.mp.cos, self.mp.sqrt

    @contextmanager
    def working(self, digits: int) -> Iterator[None]:
        """Compute with that many decimals inside the block."""
        before, self.mp.dps = self.mp.dps, digits
        try:
            yield
        finally:
            self.mp.dps = before

    def number(self, value: Value) -> Any:
        """A parameter at the working precision."""
        return self.mp.mpf(value.mpf(self.mp.dps))

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point."""
        angle = self.mp.atan2(sine, cosine)
        return angle if angle >= 0 else angle + 2 * self.mp.pi

    def rational(self, numerator: int, denominator: int) -> Any:
        """RationalFunction of two integers."""
        return self.mp.mpf(numerator) / denominator

    def eigenvalue(self, index: int, matrix: _Matrix) -> Any:
        """Eigenvalue of a matrix, counted by real, then imaginary part."""
        values = self.mp.eig(self.mp.matrix(matrix), left=False, right=False)
        value = sorted(values, key=lambda v: (self.mp.re(v), self.mp.im(v)))[index]
        return value if self.mp.im(value) else self.mp.re(value)

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Solution of a square linear system."""
        return list(self.mp.lu_solve(self.mp.matrix(matrix), self.mp.matrix(right)))

    def _length(self, size: float) -> tuple[int, float]:
        return _series_length(size, self.mp.prec), 0.0


class Balls(_Entire):
    """Ball arithmetic: every result encloses the exact one."""

    def __init__(self) -> None:
        import flint

        self.flint = flint

    @staticmethod
    def working(bits: int) -> AbstractContextManager[None]:
        """Compute with that many bits inside the block; other threads wait."""
        return flint_precision(bits)

    def number(self, value: Value) -> Any:
        """A ball around a parameter, at the working precision."""
        return value.ball(self.flint.ctx.prec)

    def sin(self, x: Any) -> Any:
        """Sine."""
        return self.flint.arb(x).sin() if isinstance(x, int) else x.sin()

    def cos(self, x: Any) -> Any:
        """Cosine."""
        return self.flint.arb(x).cos() if isinstance(x, int) else x.cos()

    @staticmethod
    def sqrt(x: Any) -> Any:
        """Square root."""
        return x.sqrt()

    def angle(self, sine: Any, cosine: Any) -> Any:
        """Angle in [0, 2 pi) of a point; the union of both branches near angle 0."""
        arb = self.flint.arb
        angle = arb.atan2(sine, cosine)
        if sine >= 0:
            return angle
        turned = angle + 2 * arb.pi()
        return turned if sine < 0 else angle.union(turned)

    def rational(self, numerator: int, denominator: int) -> Any:
        """RationalFunction of two integers."""
        return self.flint.arb(numerator) / denominator

    def eigenvalue(self, index: int, matrix: _Matrix) -> Any:
        """Enclosure of a simple eigenvalue, counted by real, then imaginary part.

        Raises
        ------
        ValueError
            If eigenvalues cannot be told apart at the working precision.
        """
        values = self.flint.acb_mat([list(row) for row in matrix]).eig()
        value = sorted(values, key=lambda v: (float(v.real), float(v.imag)))[index]
        # the conjugate is an eigenvalue too: where the balls are apart, it is this one
        return value.real if value.imag.contains(0) else value

    def solve(self, matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
        """Enclosure of the solution of a square linear system."""
        column = self.flint.arb_mat([[x] for x in right])
        return list(self.flint.arb_mat([list(row) for row in matrix]).solve(column).entries())

    def _size(self, number: Any) -> float:
        return float(abs(self.flint.arb(number)).upper()) * (1 + 1e-12)

    def _length(self, size: float) -> tuple[int, float]:
        terms = _series_length(size, self.flint.ctx.prec)
        return terms, 2.0**-(self.flint.ctx.prec)

    def _widen(self, number: Any, error: float) -> Any:
        return number + self.flint.arb(0, error)


def exact_ball(number: Any) -> Any:
    """A ball of no radius at a float or an mpmath number."""
    from flint import arb

    if isinstance(number, float):
        return arb(number)
    sign, mantissa, exponent, _ = number._mpf_
    return arb((int(-mantissa if sign else mantissa), int(exponent)))


def middle(mp: Any, ball: Any) -> Any:
    """The midpoint of a ball as an mpmath number of a context's precision."""
    mantissa, exponent = ball.mid().man_exp()
    return mp.ldexp(mp.mpf(int(mantissa)), int(exponent))
