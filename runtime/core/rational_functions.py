"""Exact arithmetic of rational functions of parameters: what is zero for all their values.

They take the place of rational numbers where parameters are not points: a velocity that a
reset sets to the belt's is then the belt's whatever the belt's velocity is. Irrational numbers are
variables too, the last ones, and what is known of these is an `Extension`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flint import arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx


def pivot(row: Iterable[Any]) -> Any:
    """Return the place of the first entry that is not zero; None if all are."""
    return next((k for k, x in enumerate(row) if x), None)


@dataclass(frozen=True)
class Extension:
    """Irrational numbers, which are the last variables of rational functions.

    They do not vary. Nothing is divided by what may be zero at them for all values of the
    parameters.
    """

    values: tuple[arb, ...] = ()  # balls around the numbers, in their order
    # polynomials of the numbers that are zero, in the order of their first variables; each is monic
    # in that one
    relations: tuple[fmpq_mpoly, ...] = ()

    def reduced(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """The same number, with no higher powers than the relations leave."""
        for relation in self.relations:
            polynomial = polynomial % relation
        return polynomial

    def check(self) -> None:
        """Raise ArithmeticError if a relation is not zero at the values."""
        for relation in self.relations:
            groups = {e[len(e) - len(self.values) :]: c for e, c in _terms(relation).items()}
            if not _horner(groups, self.values).contains(0):
                raise ArithmeticError(f"{relation} is not zero")


_NONE = Extension()


def symbols(names: Sequence[str], extension: Extension = _NONE) -> list[RationalFunction]:
    """The parameters as rational functions of themselves, in the order of the names.

    The names of the parameters are followed by those of the numbers of the extension.
    """
    from flint import Ordering, fmpq_mpoly_ctx

    context = fmpq_mpoly_ctx.get(tuple(names), Ordering.lex)
    one = context.constant(1)
    return [RationalFunction(variable, one, extension) for variable in context.gens()]


class RationalFunction:
    """A quotient of polynomials without common factor; the denominator's first coefficient is 1."""

    __slots__ = ("above", "below", "extension")

    def __init__(self, above: fmpq_mpoly, below: fmpq_mpoly, extension: Extension = _NONE) -> None:
        self.above, self.below, self.extension = above, below, extension

    @property
    def context(self) -> fmpq_mpoly_ctx:
        """The context of the polynomials, which holds the names of the variables."""
        return self.above.context()

    @property
    def rational(self) -> fmpq | None:
        """The fraction that it is for all parameters; None where it is not known to be one."""
        if not (self.above.is_constant() and self.below.is_one()):
            return None
        from flint import fmpq

        return fmpq(0) if self.above.is_zero() else self.above.leading_coefficient()

    def __bool__(self) -> bool:
        return not self.above.is_zero()

    def __hash__(self) -> int:
        return hash((str(self.above), str(self.below)))

    def __eq__(self, other: object) -> bool:
        other = self._like(other)
        apart = self.above * other.below - other.above * self.below
        return bool(self.extension.reduced(apart).is_zero())

    def __neg__(self) -> RationalFunction:
        return RationalFunction(-self.above, self.below, self.extension)

    def __add__(self, other: Any) -> RationalFunction:
        other = self._like(other)
        if self.below == other.below:
            return self._of(self.above + other.above, self.below)
        above = self.above * other.below + other.above * self.below
        return self._of(above, self.below * other.below)

    __radd__ = __add__

    def __sub__(self, other: Any) -> RationalFunction:
        return self + -self._like(other)

    def __rsub__(self, other: Any) -> RationalFunction:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> RationalFunction:
        other = self._like(other)
        return self._of(self.above * other.above, self.below * other.below)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> RationalFunction:
        other = self._like(other)
        if self.extension.values and not _somewhere(other.above, self.extension.values):
            raise ZeroDivisionError("a divisor may be zero at the irrational parameters")
        return self._of(self.above * other.below, self.below * other.above)

    def __rtruediv__(self, other: Any) -> RationalFunction:
        return self._like(other).__truediv__(self)

    def __pow__(self, exponent: int) -> RationalFunction:
        if exponent < 0:
            return self._like(1) / self**-exponent
        return self._of(self.above**exponent, self.below**exponent)

    def __str__(self) -> str:
        return str(self.above) if self.below.is_one() else f"({self.above})/({self.below})"

    def __call__(self, values: Sequence[Any]) -> Any:
        """The value at numbers of any arithmetic, the parameters in their order."""
        above = _evaluated(self.above, values)
        return above if self.below.is_one() else above / _evaluated(self.below, values)

    def _like(self, other: Any) -> RationalFunction:
        if isinstance(other, RationalFunction):
            return other
        from flint import fmpq

        context = self.context
        return RationalFunction(context.constant(fmpq(other)), context.constant(1), self.extension)

    def _of(self, above: fmpq_mpoly, below: fmpq_mpoly) -> RationalFunction:
        above, below = self.extension.reduced(above), self.extension.reduced(below)
        if below.is_zero():
            raise ZeroDivisionError("a denominator is zero for all values of the parameters")
        common = above.gcd(below)
        if not common.is_one():
            above, below = above / common, below / common
        leading = below.leading_coefficient()
        return RationalFunction(above / leading, below / leading, self.extension)


def _somewhere(polynomial: fmpq_mpoly, constants: Sequence[arb]) -> bool:
    """Whether a polynomial at the constants is certainly not zero for some other values."""
    groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
    for exponents, coefficient in _terms(polynomial).items():
        free = len(exponents) - len(constants)
        groups.setdefault(exponents[:free], {})[exponents[free:]] = coefficient
    return any(_horner(group, constants) != 0 for group in groups.values())


def _evaluated(polynomial: fmpq_mpoly, values: Sequence[Any]) -> Any:
    """The value of a polynomial, by Horner's scheme in one variable after the other."""
    return _horner(_terms(polynomial), values)


def _terms(polynomial: fmpq_mpoly) -> dict[tuple[int, ...], fmpq]:
    terms: dict[tuple[int, ...], fmpq] = polynomial.to_dict()
    return {tuple(map(int, e)): c for e, c in terms.items()}


def _horner(terms: dict[tuple[int, ...], fmpq], values: Sequence[Any]) -> Any:
    from flint import arb

    if not terms:
        return arb(0)
    if not values:
        return arb(terms[()])
    by_power: dict[int, dict[tuple[int, ...], fmpq]] = {}
    for (power, *rest), coefficient in terms.items():
        by_power.setdefault(power, {})[tuple(rest)] = coefficient
    total: Any = None
    highest = max(by_power)
    for power in range(highest, -1, -1):
        part = _horner(by_power[power], values[1:]) if power in by_power else None
        if total is None:
            total = part
            continue
        total = total * values[0]
        if part is not None:
            total = total + part
    return total
