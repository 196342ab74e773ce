"""Exact arithmetic: numbers as a file states them, and rows of them.

A text is an exact fraction, {mid, rad} any number of a ball, {above, below} a rational function
of the parameters of a box and of irrational constants: lists of [coefficient, exponents].
"""

import hashlib
import json
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.certification.quotients import Quotient

__all__ = [
    "Elimination",
    "Failure",
    "agreed_claims",
    "check_sum",
    "demand",
    "exact",
    "is_integer",
    "leading",
    "number_of",
    "product",
    "reduced",
]


class Failure(Exception):
    """Something that is claimed could not be proved."""


def demand(condition: object, otherwise: str) -> None:
    """Fail unless a condition holds."""
    if not condition:
        raise Failure(otherwise)


def check_sum(content: dict[str, Any]) -> None:
    """The content is as it was written."""
    covered = {key: value for key, value in content.items() if key != "sha256"}
    digest = hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()
    demand(content["sha256"] == digest, "edited or damaged: the checksum differs")


def agreed_claims(claims: dict[str, str]) -> tuple[str, str, str]:
    """Verdicts on existence, admissibility and stability that may go together."""
    exists, *others = (claims[name] for name in ("existence", "admissibility", "stability"))
    demand({exists, *others} <= {"proved", "refuted", "undecided"}, "unknown claims")
    if exists != "proved":
        demand({*others} == {"undecided"}, "a claim about no orbit")
    return exists, others[0], others[1]


def exact(text: str) -> Any:
    """A fraction, or a decimal with an exponent, without rounding."""
    digits, _, exponent = text.partition("e")
    whole, _, decimals = digits.partition(".")
    numerator, _, denominator = (whole + decimals).partition("/")
    power = fmpq(10) ** (int(exponent or 0) - len(decimals))
    return fmpq(int(numerator), int(denominator or 1)) * power


def number_of(entry: Any, variables: Any) -> Any:
    """A fraction, a ball, or a rational function of the variables."""
    if isinstance(entry, str):
        return exact(entry)
    if "mid" in entry:
        return arb(exact(entry["mid"])) + arb(0, arb(exact(entry["rad"])))
    context, parts = variables[0].context, []
    for part in (entry["above"], entry["below"]):
        terms = {tuple(exponents): exact(coefficient) for coefficient, exponents in part}
        parts.append(Quotient(context.from_dict(terms), context.constant(1)))
    return parts[0] / parts[1]


def is_integer(number: Any) -> bool:
    """Whether a fraction or a function is one and the same integer."""
    if isinstance(number, Quotient):
        if not (number.above.is_constant() and number.below.is_one()):
            return False
        number = number.above.leading_coefficient()
    return bool(number.q == 1)


def product(row: Any, rows: Any) -> tuple[Any, ...]:
    """A row times a matrix: with a field, the row of the derivative."""
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), fmpq(0))
        for column in zip(*rows, strict=True)
    )


def reduced(row: Any, facts: Any) -> Any:
    """The same function of a state for which the facts hold."""
    for fact in facts:
        if factor := row[next(j for j, x in enumerate(fact) if x)]:
            row = tuple(x - factor * y if y else x for x, y in zip(row, fact, strict=True))
    return row


def leading(row: Any, field: Any, facts: Any, order: int) -> tuple[int, Any]:
    """Order and row of the first derivative that is not known to be zero; None if none is."""
    for k in range(len(row) + 1):
        if k >= order and any(found := reduced(row, facts)):
            return k, found
        row = product(row, field)
    return 0, None


class Elimination:
    """Gauss and Jordan's; remembers by what was divided.

    Facts are rows that vanish along an orbit. Where numbers are rational functions a fact may
    be false at parameters at which a divisor is zero; these are nowhere dense, the orbit is
    continuous, and so it holds at all parameters at which its entries are finite.
    """

    def __init__(self) -> None:
        self.divisors: list[Any] = []

    def echelon(self, rows: Any) -> list[Any]:
        """Independent rows of a span, reduced."""
        left, found = [list(row) for row in rows], list[list[Any]]()
        for column in range(len(left[0]) if left else 0):
            place = next((k for k, row in enumerate(left) if row[column]), None)
            if place is None:
                continue
            taken = left.pop(place)
            pivot = taken[column]
            self.divisors.append(pivot)
            taken = [x / pivot if x else x for x in taken]
            for row in (*left, *found):
                if factor := row[column]:
                    row[:] = [x - factor * y if y else x for x, y in zip(row, taken, strict=True)]
            found.append(taken)
        return [tuple(row) for row in found]

    def left_kernel(self, matrix: Any) -> list[Any]:
        """Rows c with c M = 0."""
        size, width = len(matrix), len(matrix[0])
        unit = [[fmpq(int(i == j)) for j in range(size)] for i in range(size)]
        joined = [[*row, *more] for row, more in zip(matrix, unit, strict=True)]
        return [row[width:] for row in self.echelon(joined) if not any(row[:width])]

    def lasting(self, facts: Any, field: Any) -> Any:
        """The facts that stay true along a field: the largest part that it maps into itself."""
        while facts:
            rates = [reduced(product(row, field), facts) for row in facts]
            kept = [product(c, facts) for c in self.left_kernel(rates)]
            if len(kept) == len(facts):
                break
            facts = self.echelon(kept)
        return facts
