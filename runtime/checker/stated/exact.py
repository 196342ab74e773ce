"""Exact arithmetic: numbers as a file states them, and rows of them.

A text is an exact fraction, {mid, rad} any number of a ball, {above, below} a rational function
of the parameters that the file names: lists of [coefficient, exponents].
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from typing import Any, NamedTuple

from flint import arb, arb_mat, fmpq, fmpq_mat, fmpz

from nonsmooth.runtime.core.rational_functions import RationalFunction, pivot

NUMBER = re.compile(
    r"[+-]?\d+/\d+|[+-]?(?=\.?\d)\d*(\.\d*)?(e[+-]?\d{1,6})?", re.ASCII
)  # a fraction, or a decimal with an exponent
_HIGHEST = 10_000  # power of a parameter
_SHORT = 24  # characters of a number


Numbers = Sequence[Any]  # fractions, balls, Taylor models or jets
ToNumber = Callable[[Any], Any]  # from exact entries
Entries = dict[str, Any]  # of a file, or of a part of it, as they are read from JSON


class Failure(Exception):
    """A claim that could not be proved."""


class Verdict(NamedTuple):
    """The verdict on a claim."""

    claim: str  # "proved", "refuted" or "undecided"
    reason: str = ""  # why it is not proved
    found: Any = ()  # numbers that come with it


def demand(condition: object, otherwise: str) -> None:
    """Raise `Failure` with the message `otherwise` unless a condition holds."""
    if not condition:
        raise Failure(otherwise)


def demand_sign(number: Any, otherwise: str) -> None:
    """Raise `Failure` unless a number is surely positive, or surely negative."""
    demand(number > 0 or number < 0, otherwise)


@contextmanager
def naming(where: str) -> Iterator[None]:
    """Say where it is in the message of a `Failure` that is raised within the context."""
    try:
        yield
    except Failure as failure:
        failure.args = (f"{where}: {failure}",)
        raise


def agreed_claims(claims: dict[str, str], reasons: dict[str, str]) -> tuple[str, str, str]:
    """Return the verdicts on existence, admissibility and stability, if they go together.

    A reason has to be given for each claim that is not proved, and for no other; where no orbit is
    proved that reason may stand for all. Otherwise `Failure` is raised.
    """
    exists, *others = (claims[name] for name in ("existence", "admissibility", "stability"))
    if exists != "proved":
        demand({*others} == {"undecided"}, "a claim about no orbit")
    missed = {name for name, verdict in claims.items() if verdict != "proved"}
    alone = exists != "proved" and reasons.keys() == {"existence"}
    demand(alone or reasons.keys() == missed, "there are reasons for other claims")
    return exists, others[0], others[1]


def exact(text: str) -> Any:
    """Return the exact fraction of a text such as "1.25e-3" or "5/4"; `Failure` if it is none."""
    return _short(text) if len(text) <= _SHORT else _parsed(text)


def _parsed(text: str) -> Any:
    demand(NUMBER.fullmatch(text), f"{text[:60]!r} is no number")
    digits, _, exponent = text.partition("e")
    whole, _, decimals = digits.partition(".")
    numerator, _, denominator = (whole + decimals).partition("/")
    below = fmpz(denominator or "1")
    demand(below != 0, f"{text[:60]!r} is no number")
    power = fmpq(10) ** (int(exponent or 0) - len(decimals))
    return fmpq(fmpz(numerator.removeprefix("+")), below) * power


_short = lru_cache(maxsize=1024)(_parsed)  # most numbers of a declaration are 0 or 1


def ball(stated: dict[str, str]) -> Any:
    """Return a ball that contains all that a stated "mid" and "rad", decimal texts, allow."""
    return arb(exact(stated["mid"])) + arb(0, arb(exact(stated["rad"])))


def stated_box(box: Sequence[Entries], names: Sequence[str]) -> tuple[list[Any], list[Any]]:
    """Return middles and radii of a stated box of unknowns, which have these names."""
    demand([side["name"] for side in box] == names, "the box is not that of the unknowns")
    middles, radii = ([arb(exact(side[k])) for side in box] for k in ("mid", "rad"))
    return middles, radii


def inside(found: Any, stated: dict[str, str]) -> Any:
    """Return whether a ball or Taylor model lies inside a stated ball, with certainty."""
    return abs(found - arb(exact(stated["mid"]))) < arb(exact(stated["rad"]))


def column(numbers: Iterable[Any]) -> Any:
    """Return numbers as a column of balls."""
    return arb_mat([[x] for x in numbers])


def number_of(entry: Any, variables: Numbers) -> Any:
    """Return a file's entry as a fraction, a ball, or a rational function of the variables.

    The entry is a text, a "mid" and "rad", or an "above" and "below" of a rational function.
    `Failure` is raised if a divisor is zero or a text is no number.
    """
    if isinstance(entry, str):
        return exact(entry)
    if "mid" in entry:
        return ball(entry)
    above, below = (_polynomial(entry[part], variables) for part in ("above", "below"))
    demand(below, "a number of the declaration has a pole")
    return above / below


def _polynomial(terms: list[Any], variables: Numbers) -> Any:
    total: Any = fmpq(0)
    for coefficient, exponents in terms:
        demand(len(exponents) == len(variables), "a function of other parameters")
        demand(all(0 <= k <= _HIGHEST for k in exponents), "a power too high")
        term: Any = exact(coefficient)
        for variable, exponent in zip(variables, exponents, strict=True):
            if exponent:
                term = term * variable**exponent
        total = total + term
    return total


def is_integer(number: Any) -> bool:
    """Return whether a fraction or function is one constant integer."""
    if isinstance(number, RationalFunction):
        number = number.rational
    return number is not None and bool(number.q == 1)


def product(row: Any, rows: Any) -> tuple[Any, ...]:
    """Return a row (n) times a matrix (n, m), exactly; times a field, the row of the derivative."""
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), fmpq(0))
        for column in zip(*rows, strict=True)
    )


def products(rows: Any, matrix: Any) -> list[Any]:
    """Return the product of two exact matrices."""
    return [product(row, matrix) for row in rows]


def form_between(form: Any, rows: Any) -> list[Any]:
    """Return the matrix of a bilinear form between vectors that are given as rows."""
    return products(products(rows, form), list(zip(*rows, strict=True)))


def unit_rows(size: int) -> list[Any]:
    """Return the exact unit matrix of a size."""
    return [tuple(fmpq(int(i == j)) for j in range(size)) for i in range(size)]


def reduced(row: Any, facts: Any) -> Any:
    """Return the same affine function of a state for which the facts hold, with pivots removed.

    Rows and facts have length N + 1 and act on (y, 1); facts are reduced rows that are zero. The
    result is zero if the facts make the function zero.
    """
    for fact in facts:
        if factor := row[pivot(fact)]:
            row = tuple(x - factor * y if y else x for x, y in zip(row, fact, strict=True))
    return row


def fixed(size: int, values: Iterable[tuple[int, Any]]) -> list[Any]:
    """Return rows (size + 1) over (y, 1) that are zero where some coordinates have these values."""
    unit = unit_rows(size)
    return [(*unit[k], -x) for k, x in values]


def agree(left: Any, right: Any, facts: Any = ()) -> bool:
    """Return whether two matrices over (y, 1) have the same rows wherever the facts are true."""
    pairs = zip(left, right, strict=True)
    apart = (tuple(x - y for x, y in zip(*rows, strict=True)) for rows in pairs)
    return not any(any(reduced(row, facts)) for row in apart)


def free_places(facts: Any, size: int) -> list[int]:
    """Return the places of the coordinates that reduced facts over (y, 1) leave free."""
    pivots = {*map(pivot, facts)}
    return [k for k in range(size) if k not in pivots]


def spanned(facts: Any, size: int) -> list[Any]:
    """Return rows (size, d + 1): all coordinates by the d that reduced facts leave free, and 1."""
    given, unit = {pivot(row): row for row in facts}, unit_rows(size + 1)
    return [
        tuple(-given[k][j] if k in given else unit[k][j] for j in (*free_places(facts, size), size))
        for k in range(size)
    ]


def leading(row: Any, field: Any, facts: Any, order: int) -> tuple[int, Any]:
    """Return order and row of the first derivative along a field that the facts leave nonzero.

    Derivatives of an order below `order` are skipped. The row is None if no derivative is nonzero.
    Rows have length N + 1 and act on (y, 1).
    """
    for k in range(len(row) + 1):
        if k >= order and any(found := reduced(row, facts)):
            return k, found
        row = product(row, field)
    return 0, None


class Elimination:
    """Gauss-Jordan elimination in exact numbers that remembers what it divided by.

    Facts are rows that vanish along an orbit. Where numbers are rational functions a fact may be
    false at parameters at which a divisor is zero. These parameters are nowhere dense and the orbit
    is continuous, so the fact holds at all parameters at which its entries are finite.
    """

    def __init__(self) -> None:
        self.divisors: list[Any] = []

    def echelon(self, rows: Any) -> list[Any]:
        """Return reduced independent rows that span what the rows span.

        Divisors that are functions are appended to `divisors`.
        """
        left, found = [list(row) for row in rows], list[list[Any]]()
        if left and all(isinstance(x, fmpq | int) for row in left for x in row):
            whole, rank = fmpq_mat(left).rref()
            return [tuple(row) for row in whole.tolist()[:rank]]
        for column in range(len(left[0]) if left else 0):
            place = next((k for k, row in enumerate(left) if row[column]), None)
            if place is None:
                continue
            taken = left.pop(place)
            divisor = taken[column]
            self.divisors.append(divisor)
            taken = [x / divisor if x else x for x in taken]
            for row in (*left, *found):
                if factor := row[column]:
                    row[:] = [x - factor * y if y else x for x, y in zip(row, taken, strict=True)]
            found.append(taken)
        return [tuple(row) for row in found]

    def left_kernel(self, matrix: Any) -> list[Any]:
        """Return a basis of the rows c with c M = 0, for a matrix of at least one row."""
        size, width = len(matrix), len(matrix[0])
        joined = [[*row, *more] for row, more in zip(matrix, unit_rows(size), strict=True)]
        return [row[width:] for row in self.echelon(joined) if not any(row[:width])]

    def behind(self, facts: Any, reset: Any) -> list[Any]:
        """Return the reduced facts behind a reset, from those before it."""
        return self.echelon(self.left_kernel([reduced(row, facts) for row in reset]))

    def lasting(self, facts: Any, field: Any) -> Any:
        """Return the facts that stay true along a field: the largest part mapped into itself."""
        while facts:
            rates = [reduced(product(row, field), facts) for row in facts]
            kept = [product(c, facts) for c in self.left_kernel(rates)]
            if len(kept) == len(facts):
                break
            facts = self.echelon(kept)
        return facts
