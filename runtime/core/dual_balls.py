"""Dual numbers over balls: a number or matrix, and its derivative along one direction, enclosed.

a + b e with e^2 = 0 (W. K. Clifford, 1873). Whatever is computed of such numbers encloses the value
and its derivative; nothing is cut off. The radius of a Taylor model holds what is beyond its order,
of whose derivative nothing is known: that is why a model of the first order is not enough.
"""

from __future__ import annotations

from typing import Any

__all__ = ["DualBall", "rate_of", "value_of"]


class DualBall:
    """A number (arb) or a matrix (arb_mat), and its derivative along a direction.

    Mixes with numbers and matrices of balls, whose derivatives are zero.

    Parameters
    ----------
    value, rate : arb or arb_mat
        Of the same shape.
    """

    __slots__ = ("rate", "value")

    def __init__(self, value: Any, rate: Any) -> None:
        self.value, self.rate = value, rate

    def __add__(self, other: Any) -> DualBall:
        if isinstance(other, DualBall):
            return DualBall(self.value + other.value, self.rate + other.rate)
        return DualBall(self.value + other, self.rate)

    __radd__ = __add__

    def __neg__(self) -> DualBall:
        return DualBall(-self.value, -self.rate)

    def __sub__(self, other: Any) -> DualBall:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> DualBall:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> DualBall:
        if isinstance(other, DualBall):
            rate = self.rate * other.value + self.value * other.rate
            return DualBall(self.value * other.value, rate)
        return DualBall(self.value * other, self.rate * other)

    def __rmul__(self, other: Any) -> DualBall:
        return DualBall(other * self.value, other * self.rate)

    def __truediv__(self, other: Any) -> DualBall:
        if isinstance(other, DualBall):
            return self * other.reciprocal()
        return DualBall(self.value / other, self.rate / other)

    def __rtruediv__(self, other: Any) -> DualBall:
        return self.reciprocal().__rmul__(other)

    def __getitem__(self, place: tuple[int, int]) -> DualBall:
        return DualBall(self.value[place], self.rate[place])

    def nrows(self) -> int:
        """Rows of a matrix.

        Returns
        -------
        int
        """
        return int(self.value.nrows())

    def ncols(self) -> int:
        """Columns of a matrix.

        Returns
        -------
        int
        """
        return int(self.value.ncols())

    def entries(self) -> list[DualBall]:
        """Entries of a matrix, row by row.

        Returns
        -------
        list of DualBall
        """
        pairs = zip(self.value.entries(), self.rate.entries(), strict=True)
        return [DualBall(value, rate) for value, rate in pairs]

    def is_zero(self) -> bool:
        """Whether value and derivative of a number are exactly zero.

        Returns
        -------
        bool
        """
        return bool(self.value.is_zero() and self.rate.is_zero())

    def reciprocal(self) -> DualBall:
        """One over a number; balls without bounds where that may be zero.

        Returns
        -------
        DualBall
        """
        inverse = 1 / self.value
        return DualBall(inverse, -self.rate * inverse * inverse)

    def sin_cos(self) -> tuple[DualBall, DualBall]:
        """Sine and cosine of a number.

        Returns
        -------
        sine, cosine : DualBall
        """
        sine, cosine = self.value.sin_cos()
        return DualBall(sine, self.rate * cosine), DualBall(cosine, -self.rate * sine)

    def exp(self) -> DualBall:
        """Exponential of a matrix A, with the derivative B of A.

        The exponential of [[A, B], [0, A]] has it, and its derivative beside it (C. F. Van Loan,
        IEEE Trans. Automat. Contr. 23, 1978).

        Returns
        -------
        DualBall
        """
        from flint import arb_mat

        size = self.nrows()
        both = arb_mat(2 * size, 2 * size)
        for i in range(size):
            for j in range(size):
                both[i, j] = both[size + i, size + j] = self.value[i, j]
                both[i, size + j] = self.rate[i, j]
        flow = both.exp()
        value, rate = (
            arb_mat([[flow[i, shift + j] for j in range(size)] for i in range(size)])
            for shift in (0, size)
        )
        return DualBall(value, rate)


def value_of(number: Any) -> Any:
    """The value of a dual number, or a ball as it is.

    Parameters
    ----------
    number : DualBall, arb or arb_mat

    Returns
    -------
    arb or arb_mat
    """
    return number.value if isinstance(number, DualBall) else number


def rate_of(number: Any) -> Any:
    """The derivative of a dual number; zero of a ball.

    Parameters
    ----------
    number : DualBall, arb or arb_mat

    Returns
    -------
    arb or arb_mat
    """
    return number.rate if isinstance(number, DualBall) else 0 * number
