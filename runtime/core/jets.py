"""Jets: numbers and matrices with their derivatives along one direction.

A jet is a0 + a1 e + ... + ak e^k with e^(k+1) = 0: what it stands for is a function of a
parameter near one of its values, and its coefficients are that function's derivatives by the
parameter, divided by factorials. They are balls or Taylor models, and where these enclose
values and derivatives of what is computed with, the result encloses its own: nothing is cut off
(automatic differentiation; R. Moore, Methods and Applications of Interval Analysis, 1979). With
k = 1 they are the dual numbers of W. K. Clifford (1873). A Taylor model alone does not enclose a
derivative: its radius holds what is beyond its order, of whose derivative nothing is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from nonsmooth.runtime.core.taylor_models import TaylorModel, added, matrix, range_of, space_of


class Jet(TaylorModel):
    """A number or a matrix with its derivatives; comparisons are of the values.

    `parts` are the coefficients, numbers of another arithmetic; None is zero.
    """

    __slots__ = ()

    depth = 1

    def __add__(self, other: Any) -> Jet:
        if isinstance(other, Jet):
            return Jet(self.space, tuple(map(added, self.parts, other.parts)))
        return Jet(self.space, (added(self.parts[0], other), *self.parts[1:]))

    __radd__ = __add__

    def __mul__(self, other: Any) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.space, tuple(None if p is None else p * other for p in self.parts))
        found: list[Any] = [None] * len(self.parts)
        for i, left in enumerate(self.parts):
            for j, right in enumerate(other.parts[: len(found) - i]):
                if left is not None and right is not None:
                    found[i + j] = added(found[i + j], left * right)
        return Jet(self.space, tuple(found))

    # of a model and a jet these have to come before those of the model
    def __rmul__(self, other: Any) -> Jet:
        return Jet(self.space, tuple(None if p is None else other * p for p in self.parts))

    def __rsub__(self, other: Any) -> Jet:
        negative = Jet(self.space, tuple(None if p is None else -p for p in self.parts))
        return negative.__add__(other)

    def __rtruediv__(self, other: Any) -> Jet:
        return self.reciprocal().__rmul__(other)

    def __truediv__(self, other: Any) -> Jet:
        if isinstance(other, Jet):
            return self * other.reciprocal()
        return Jet(self.space, tuple(None if p is None else p / other for p in self.parts))

    def range(self) -> Any:
        """Ball, or matrix of balls, that contains all values, but not the derivatives."""
        return range_of(self.parts[0])

    def reciprocal(self) -> Jet:
        """One over a number; balls without bounds where that may be zero."""
        first = 1 / self.parts[0]
        found: list[Any] = [first]
        for k in range(1, len(self.parts)):
            total = None
            for _, term in self._terms(found, k):
                total = added(total, term)
            found.append(None if total is None else -(first * total))
        return Jet(self.space, tuple(found))

    def sin_cos(self) -> tuple[Jet, Jet]:
        """Sine and cosine of a number a, whose derivatives are a' cos a and -a' sin a."""
        sines, cosines = ([part] for part in self.parts[0].sin_cos())
        for k in range(1, len(self.parts)):
            sine = cosine = None
            for i, term in self._terms(cosines, k):
                sine = added(sine, term * i / k)
            for i, term in self._terms(sines, k):
                cosine = added(cosine, term * -i / k)
            sines.append(sine)
            cosines.append(cosine)
        return Jet(self.space, tuple(sines)), Jet(self.space, tuple(cosines))

    def _terms(self, others: Sequence[Any], k: int) -> Iterator[tuple[int, Any]]:
        """The terms a_i b_(k - i), i >= 1, of coefficient k of a product with another jet.

        Each comes behind its i; what is zero is left out.
        """
        for i in range(1, k + 1):
            if self.parts[i] is not None and others[k - i] is not None:
                yield i, self.parts[i] * others[k - i]

    def stacked(self, rows: Sequence[Sequence[Any]]) -> Jet:
        """A matrix of jets and of numbers that do not depend on the parameter.

        The latter may be balls and Taylor models.
        """

        def parts(k: int) -> Any:
            found = [
                [x.parts[k] if isinstance(x, Jet) else None if k else x for x in row]
                for row in rows
            ]
            if k and all(x is None for row in found for x in row):
                return None
            return matrix([[0 if x is None else x for x in row] for row in found])

        return Jet(self.space, tuple(map(parts, range(len(self.parts)))))

    def exp(self) -> Jet:
        """Exponential of a matrix, from that of the block triangular matrix of its coefficients."""
        size, count = self.nrows(), len(self.parts)
        if all(part is None for part in self.parts[1:]):
            return Jet(self.space, (self.parts[0].exp(), *self.parts[1:]))
        blocks = [None if part is None else _rows(part) for part in self.parts]

        def entry(i: int, j: int) -> Any:
            block = blocks[j // size - i // size] if j // size >= i // size else None
            return 0 if block is None else block[i % size][j % size]

        wide = range(count * size)
        found = _rows(matrix([[entry(i, j) for j in wide] for i in wide]).exp())
        parts = [
            matrix([row[k * size : (k + 1) * size] for row in found[:size]]) for k in range(count)
        ]
        return Jet(self.space, tuple(parts))


def jet(*parts: Any) -> Jet:
    """A number by its coefficients: the value, the derivative, half of the second one.

    There are at least two; None is zero, but the value may not be None.
    """
    return Jet(space_of(1, len(parts) - 1), parts)


def part_of(number: Any, k: int) -> Any:
    """Coefficient k of a jet; a number that depends on no parameter has zeros for k > 0.

    The number may also be a matrix.
    """
    if not isinstance(number, Jet):
        return 0 * number if k else number
    part = number.parts[k]
    return 0 * number.parts[0] if part is None else part


def _rows(square: Any) -> list[list[Any]]:
    return [[square[i, j] for j in range(square.ncols())] for i in range(square.nrows())]
