"""Taylor models: functions of a few variables in [-1, 1] as polynomials with ball coefficients.

A model encloses a number or a matrix for all values of the variables: what is cut off at the
order goes into the radii of the constant term, so that sums, products, quotients and
exponentials keep what depends on the variables in common (Makino & Berz, 1996). Plain balls
lose that: their trace of a Poincare map over one percent of a parameter decides nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from math import prod
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flint import arb, arb_mat

_SMALL = 0.25  # norm to which an exponent is halved
_LARGEST = 2.0**40  # norm of an exponent about whose exponential anything is said
_BLOCK = 4  # powers that are kept for an exponential


@dataclass(frozen=True, eq=False)
class Space:
    """Polynomials of some variables up to an order."""

    variables: int
    order: int
    exponents: tuple[tuple[int, ...], ...]  # of the monomials, by degree; the constant is the first
    # for each monomial the pairs of monomials whose product it is
    products: tuple[tuple[tuple[int, int], ...], ...]
    even: tuple[bool, ...]  # whether a monomial is a square, which lies in [0, 1]

    def constant(self, value: Any) -> TaylorModel:
        """A number (arb) or a matrix (arb_mat) that does not depend on the variables."""
        return TaylorModel(self, (value, *(None,) * (len(self.exponents) - 1)))

    def variable(self, number: int, middle: arb, half: arb) -> TaylorModel:
        """The number middle + half * variable, for the variable with this number, from 0."""
        parts: list[Any] = [middle, *(None,) * (len(self.exponents) - 1)]
        wanted = tuple(int(k == number) for k in range(self.variables))
        parts[self.exponents.index(wanted)] = half
        return TaylorModel(self, tuple(parts))


@cache
def space_of(variables: int, order: int) -> Space:
    """The polynomials of so many variables, up to a positive order.

    The same numbers give the same record.
    """
    exponents = sorted(
        (e for e in product(range(order + 1), repeat=variables) if sum(e) <= order),
        key=lambda e: (sum(e), [-k for k in e]),
    )
    place = {e: k for k, e in enumerate(exponents)}
    pairs: list[list[tuple[int, int]]] = [[] for _ in exponents]
    for i, left in enumerate(exponents):
        for j, right in enumerate(exponents):
            total = tuple(a + b for a, b in zip(left, right, strict=True))
            if sum(total) <= order:
                pairs[place[total]].append((i, j))
    even = tuple(all(k % 2 == 0 for k in e) for e in exponents)
    return Space(variables, order, tuple(exponents), tuple(map(tuple, pairs)), even)


class TaylorModel:
    """A number (arb) or a matrix (arb_mat) for all values of a space's variables.

    Mixes with numbers and matrices of balls. Comparisons hold for all values of the variables;
    like those of balls they may be false together with their contraries.
    """

    __slots__ = ("parts", "space")

    depth = 0  # of what it is made of: a matrix takes the arithmetic of its deepest entry

    def __init__(self, space: Space, parts: tuple[Any, ...]) -> None:
        self.space, self.parts = space, parts

    def __add__(self, other: Any) -> TaylorModel:
        if not isinstance(other, TaylorModel):
            return type(self)(self.space, (added(self.parts[0], other), *self.parts[1:]))
        return type(self)(self.space, tuple(map(added, self.parts, other.parts)))

    __radd__ = __add__

    def __neg__(self) -> TaylorModel:
        return type(self)(self.space, tuple(None if p is None else -p for p in self.parts))

    def __sub__(self, other: Any) -> TaylorModel:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> TaylorModel:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> TaylorModel:
        if not isinstance(other, TaylorModel):
            return type(self)(
                self.space, tuple(None if p is None else p * other for p in self.parts)
            )
        left, right = self.parts, other.parts
        found = []
        for pairs in self.space.products:
            total = None
            for i, j in pairs:
                if left[i] is not None and right[j] is not None:
                    total = added(total, left[i] * right[j])
            found.append(total)
        found[0] = added(found[0], _cut(self, other))
        return type(self)(self.space, tuple(found))

    def __rmul__(self, other: Any) -> TaylorModel:
        return type(self)(self.space, tuple(None if p is None else other * p for p in self.parts))

    def __truediv__(self, other: Any) -> TaylorModel:
        if isinstance(other, TaylorModel):
            return self * other.reciprocal()
        return type(self)(self.space, tuple(None if p is None else p / other for p in self.parts))

    def __rtruediv__(self, other: Any) -> TaylorModel:
        return self.reciprocal().__mul__(other)

    def __pow__(self, exponent: int) -> TaylorModel:
        if exponent < 0:
            return self.reciprocal() ** -exponent
        power: Any = _one()
        for _ in range(exponent):
            power = self * power
        return power if exponent else self.space.constant(power)

    def __getitem__(self, place: tuple[int, int]) -> TaylorModel:
        return type(self)(self.space, tuple(None if p is None else p[place] for p in self.parts))

    def __abs__(self) -> Any:
        return abs(self.range())

    def __lt__(self, other: Any) -> bool:
        return bool(range_of(self - other) < 0)

    def __gt__(self, other: Any) -> bool:
        return bool(range_of(self - other) > 0)

    def nrows(self) -> int:
        """Number of rows of a matrix."""
        return int(self.parts[0].nrows())

    def ncols(self) -> int:
        """Number of columns of a matrix."""
        return int(self.parts[0].ncols())

    def entries(self) -> list[TaylorModel]:
        """Entries of a matrix, row by row."""
        return [self[i, j] for i in range(self.nrows()) for j in range(self.ncols())]

    def transpose(self) -> TaylorModel:
        """The transpose of a matrix."""
        return type(self)(
            self.space, tuple(None if p is None else p.transpose() for p in self.parts)
        )

    def stacked(self, rows: Sequence[Sequence[Any]]) -> TaylorModel:
        """A matrix of numbers of this arithmetic, and of those that it is made of.

        The latter are plain numbers, balls and Taylor models.
        """
        return TaylorModel(self.space, tuple(_stacked(self.space, rows)))

    def rad(self) -> Any:
        """Radius of a number's constant term: as a rule what is not known of the polynomial."""
        return self.parts[0].rad()

    def mid(self) -> TaylorModel:
        """The same polynomial, with the midpoints as exact coefficients."""
        return type(self)(self.space, tuple(None if p is None else p.mid() for p in self.parts))

    def cast(self, space: Space) -> TaylorModel:
        """The polynomial in a space of the same variables and another order.

        Terms of a higher degree are dropped without a bound.
        """
        count = len(space.exponents)
        return TaylorModel(space, (*self.parts[:count], *(None,) * (count - len(self.parts))))

    def at(self, point: Sequence[Any]) -> Any:
        """The value, a ball or a matrix of balls, at a point with coordinates in [-1, 1]."""
        total = self.parts[0]
        for part, exponents in zip(self.parts[1:], self.space.exponents[1:], strict=True):
            if part is not None:
                factor = _one()
                for value, exponent in zip(point, exponents, strict=True):
                    factor = factor * value**exponent
                total = total + part * factor
        return total

    def range(self) -> Any:
        """Ball, or matrix of balls, that contains all values."""
        from flint import arb

        total = self.parts[0]
        square, either = arb("0.5 +/- 0.5"), arb(0, 1)
        for part, even in zip(self.parts[1:], self.space.even[1:], strict=True):
            if part is not None:
                total = added(total, part * (square if even else either))
        return total

    def reciprocal(self) -> TaylorModel:
        """One over a number; balls without bounds where that may be zero."""
        guess = self.space.constant(1 / self.parts[0].mid())
        for _ in range(self.space.order.bit_length()):
            guess = (guess * (2 - self * guess)).mid()
        missed = 1 - self * guess
        # 1 / q = y / (1 - e) with e = 1 - q y, whatever y is
        return guess.__add__(guess * missed * (1 / (1 - range_of(missed))))

    def inv(self) -> TaylorModel:
        """An approximate inverse of a matrix, of which nothing is proved.

        Raises ZeroDivisionError if the constant term is singular.
        """
        found = self.space.constant(self.parts[0].mid().inv().mid())
        unit = unit_matrix(self.nrows())
        for _ in range(self.space.order.bit_length()):
            found = (found * (2 * unit - self * found)).mid()
        return found

    def sin_cos(self) -> tuple[TaylorModel, TaylorModel]:
        """Sine and cosine of a number."""
        turned = matrix([[0, -self], [self, 0]]).exp()
        return turned[1, 0], turned[0, 0]

    def exp(self) -> Any:
        """Exponential of a matrix: Taylor's polynomial of it halved often, then squared.

        It is NaN everywhere for a norm of 2^40 or more.
        """
        from flint import arb, ctx

        size = self.nrows()
        norm = _norm(self.range())
        if not norm < _LARGEST:
            return self.space.constant(_everywhere(size, arb("nan")))
        halvings = math.ceil(math.log2(float(norm) / _SMALL)) if norm > _SMALL else 0
        unit = arb(2) ** -halvings
        small, norm = self * unit, norm * unit
        degree, rest = 1, norm
        # the terms behind the degree are less than twice the first of them, the norm being < 1
        while not 2 * rest * norm / (degree + 1) < arb(2) ** -ctx.prec:
            degree += 1
            rest = rest * norm / degree
            if degree > ctx.prec:
                break
        tail = (2 * rest * norm / (degree + 1)).upper()
        powers = [self.space.constant(unit_matrix(size)), small]
        while len(powers) <= min(degree, _BLOCK):
            powers.append(powers[-1] * small)
        total: Any = None
        for begin in reversed(range(0, degree + 1, _BLOCK)):
            block: Any = None
            for k in range(begin, min(begin + _BLOCK, degree + 1)):
                block = added(block, powers[k - begin] * (1 / arb(math.factorial(k))))
            total = block if total is None else total * powers[_BLOCK] + block
        total = total + _everywhere(size, arb(0, tail))
        for _ in range(halvings):
            total = total * total
        return total


def range_of(number: Any) -> Any:
    """Ball, or matrix of balls, around all values of a model; balls stay what they are."""
    return number.range() if isinstance(number, TaylorModel) else number


def middle_of(number: Any) -> Any:
    """Midpoint of a number or a matrix; that of a model is at the origin of its variables."""
    while isinstance(number, TaylorModel):
        number = number.parts[0]
    return number.mid()


def matrix(rows: Sequence[Sequence[Any]]) -> Any:
    """A matrix of numbers, balls and models: a model if any entry is one, else an arb_mat."""
    from flint import arb_mat

    models = [x for row in rows for x in row if isinstance(x, TaylorModel)]
    if models:
        return max(models, key=lambda x: x.depth).stacked(rows)
    return arb_mat([list(row) for row in rows])


def _stacked(space: Space, rows: Sequence[Sequence[Any]]) -> Iterator[arb_mat | None]:
    from flint import arb_mat

    for k in range(len(space.exponents)):
        part = [
            [
                (x.parts[k] if isinstance(x, TaylorModel) else x if k == 0 else None) or 0
                for x in row
            ]
            for row in rows
        ]
        empty = k > 0 and not any(
            isinstance(x, TaylorModel) and x.parts[k] is not None for row in rows for x in row
        )
        yield None if empty else arb_mat(part)


def added(left: Any, right: Any) -> Any:
    """Sum of two coefficients, of which None is zero."""
    return right if left is None else left if right is None else left + right


def _cut(left: TaylorModel, right: TaylorModel) -> Any:
    """Enclosure of the terms of a product beyond the order."""
    from flint import arb

    space, either = left.space, arb(0, 1)
    sums: list[list[Any]] = []
    for model in (left, right):
        by_degree: list[Any] = [None] * (space.order + 1)
        for part, exponents in zip(model.parts[1:], space.exponents[1:], strict=True):
            if part is not None:
                degree = sum(exponents)
                by_degree[degree] = added(by_degree[degree], part * either)
        sums.append(by_degree)
    total = above = None
    for degree in range(1, space.order + 1):
        above = added(above, sums[1][space.order + 1 - degree])
        if above is not None and sums[0][degree] is not None:
            total = added(total, sums[0][degree] * above)
    return total


def _one() -> arb:
    from flint import arb

    return arb(1)


def unit_matrix(size: int) -> arb_mat:
    """The unit matrix of a size."""
    from flint import arb_mat

    return arb_mat([[int(i == j) for j in range(size)] for i in range(size)])


def _everywhere(size: int, value: arb) -> arb_mat:
    from flint import arb_mat

    return arb_mat(size, size, [value] * size**2)


def _norm(balls: arb_mat) -> arb:
    """Upper bound of the largest row sum of absolute values."""
    from flint import arb

    width = balls.ncols()
    entries = [abs(x).upper() for x in balls.entries()]
    largest = arb(0)
    for i in range(0, len(entries), width):
        largest = largest.max(sum(entries[i : i + width], arb(0)))
    return largest.upper()


Weight = tuple[int, ...]  # the average of abs(s)**p is one over the product of p + these
AT_BOTH_ENDS: Weight = ()  # of the values at s = 1 and s = -1
MEAN: Weight = (1,)  # over s in [-1, 1]
BENT_MEAN: Weight = (1, 3)  # of the function times (1 - s^2) / 2


def lifted(number: Any, space: Space) -> Any:
    """A model of e, or a matrix, as one of e and f that does not depend on f.

    The space has two variables and the same order. Balls stay what they are.
    """
    if not isinstance(number, TaylorModel):
        return number
    parts: list[Any] = [None] * len(space.exponents)
    for power, part in enumerate(number.parts):
        parts[space.exponents.index((power, 0))] = part
    return TaylorModel(space, tuple(parts))


def averaged(number: Any, weight: Weight) -> Any:
    """The weighted average of a model of e and f over f = s e, a model of e alone.

    The model may be a matrix; a ball depends on no variable. The weight is one of those of
    this module.
    """
    from flint import arb

    def share(power: int) -> arb:
        return arb(1) / prod(power + term for term in weight)

    if not isinstance(number, TaylorModel):
        return number * share(0)
    space = space_of(1, number.space.order)
    parts: list[Any] = [None] * len(space.exponents)
    for part, (own, power) in zip(number.parts, number.space.exponents, strict=True):
        if part is None:
            continue
        term = (part - part.mid() if power % 2 else part) * share(power)
        place = own + power
        parts[place] = term if parts[place] is None else parts[place] + term
    return TaylorModel(space, tuple(parts))
