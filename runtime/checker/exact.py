"""Exact arithmetic: numbers as a file states them, and rows of them.

A text is an exact fraction, {mid, rad} any number of a ball, {above, below} a rational function
of the parameters that the file names: lists of [coefficient, exponents].
"""

import hashlib
import json
import re
from collections.abc import Sequence
from typing import Any

from flint import arb, fmpq, fmpz

from nonsmooth.runtime.core.rational_functions import RationalFunction

__all__ = [
    "NUMBER",
    "Elimination",
    "Failure",
    "agreed_claims",
    "ball",
    "check_sum",
    "demand",
    "exact",
    "inside",
    "is_integer",
    "leading",
    "number_of",
    "product",
    "reduced",
]


NUMBER = re.compile(
    r"[+-]?\d+/\d+|[+-]?(?=\.?\d)\d*(\.\d*)?(e[+-]?\d{1,6})?", re.ASCII
)  # a fraction, or a decimal with an exponent
_HIGHEST = 10_000  # power of a parameter


class Failure(Exception):
    """Something that is claimed could not be proved."""


def demand(condition: object, otherwise: str) -> None:
    """Fail unless a condition holds.

    Parameters
    ----------
    condition : object
        What has to be true.
    otherwise : str
        The message if it is not.

    Raises
    ------
    Failure
        If the condition is false.
    """
    if not condition:
        raise Failure(otherwise)


def check_sum(content: dict[str, Any]) -> None:
    """The content is as it was written.

    Parameters
    ----------
    content : dict
        The file, read as JSON.

    Raises
    ------
    Failure
        If the checksum differs.
    """
    covered = {key: value for key, value in content.items() if key != "sha256"}
    digest = hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()
    demand(content["sha256"] == digest, "edited or damaged: the checksum differs")


def agreed_claims(claims: dict[str, str], reasons: dict[str, str]) -> tuple[str, str, str]:
    """Verdicts on existence, admissibility and stability that may go together.

    There is a reason for each that is not proved, and for no other; where no orbit is proved that
    reason may stand for all.

    Parameters
    ----------
    claims : dict of str to str
        Verdict on each claim.
    reasons : dict of str to str
        Why claims are not proved.

    Returns
    -------
    tuple of (str, str, str)
        The three verdicts.

    Raises
    ------
    Failure
        If they do not go together.
    """
    exists, *others = (claims[name] for name in ("existence", "admissibility", "stability"))
    if exists != "proved":
        demand({*others} == {"undecided"}, "a claim about no orbit")
    missed = {name for name, verdict in claims.items() if verdict != "proved"}
    alone = exists != "proved" and reasons.keys() == {"existence"}
    demand(alone or reasons.keys() == missed, "there are reasons for other claims")
    return exists, others[0], others[1]


def exact(text: str) -> Any:
    """A fraction, or a decimal with an exponent, without rounding.

    Parameters
    ----------
    text : str
        As in "1.25e-3" or "5/4".

    Returns
    -------
    fmpq
        The number itself.

    Raises
    ------
    Failure
        If the text is no number.
    """
    demand(NUMBER.fullmatch(text), f"{text[:60]!r} is no number")
    digits, _, exponent = text.partition("e")
    whole, _, decimals = digits.partition(".")
    numerator, _, denominator = (whole + decimals).partition("/")
    below = fmpz(denominator or "1")
    demand(below != 0, f"{text[:60]!r} is no number")
    power = fmpq(10) ** (int(exponent or 0) - len(decimals))
    return fmpq(fmpz(numerator.removeprefix("+")), below) * power


def ball(stated: dict[str, str]) -> Any:
    """The ball of a middle and a radius.

    Parameters
    ----------
    stated : dict of str to str
        "mid" and "rad", as decimal texts.

    Returns
    -------
    arb
        It contains all that is stated.

    Raises
    ------
    Failure
        If a text is no number.
    """
    return arb(exact(stated["mid"])) + arb(0, arb(exact(stated["rad"])))


def inside(found: Any, stated: dict[str, str]) -> Any:
    """Whether a number lies inside a ball that is stated.

    Parameters
    ----------
    found : arb or TaylorModel
        The number.
    stated : dict of str to str
        "mid" and "rad", as decimal texts.

    Returns
    -------
    bool
        True if that is certain.

    Raises
    ------
    Failure
        If a text is no number.
    """
    return abs(found - arb(exact(stated["mid"]))) < arb(exact(stated["rad"]))


def number_of(entry: Any, variables: Sequence[Any]) -> Any:
    """A fraction, a ball, or the value of a rational function of the variables.

    Parameters
    ----------
    entry : str or dict
        A text, "mid" and "rad", or "above" and "below" of a fraction.
    variables : sequence of RationalFunction
        What functions are functions of.

    Returns
    -------
    fmpq, arb or RationalFunction
        The number itself.

    Raises
    ------
    Failure
        If a divisor is zero, or a text is no number.
    """
    if isinstance(entry, str):
        return exact(entry)
    if "mid" in entry:
        return ball(entry)
    above, below = (_polynomial(entry[part], variables) for part in ("above", "below"))
    demand(below, "a number of the declaration has a pole")
    return above / below


def _polynomial(terms: list[Any], variables: Sequence[Any]) -> Any:
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
    """Whether a fraction or a function is one and the same integer.

    Parameters
    ----------
    number : fmpq or RationalFunction
        Exact.

    Returns
    -------
    bool
        False for functions that are not constant.
    """
    if isinstance(number, RationalFunction):
        number = number.rational
    return number is not None and bool(number.q == 1)


def product(row: Any, rows: Any) -> tuple[Any, ...]:
    """A row times a matrix: with a field, the row of the derivative.

    Parameters
    ----------
    row : sequence, length n
        Exact entries.
    rows : sequence of rows, (n, m)
        Exact entries.

    Returns
    -------
    tuple, length m
        Exactly.
    """
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), fmpq(0))
        for column in zip(*rows, strict=True)
    )


def reduced(row: Any, facts: Any) -> Any:
    """The same function of a state for which the facts hold.

    Parameters
    ----------
    row : sequence, length N + 1
        Exact entries of an affine function, acting on (y, 1).
    facts : list of rows, each of length N + 1
        Functions that are zero, reduced.

    Returns
    -------
    sequence, length N + 1
        Zero where the facts make the function zero.
    """
    for fact in facts:
        if factor := row[next(j for j, x in enumerate(fact) if x)]:
            row = tuple(x - factor * y if y else x for x, y in zip(row, fact, strict=True))
    return row


def leading(row: Any, field: Any, facts: Any, order: int) -> tuple[int, Any]:
    """Order and row of the first derivative that is not known to be zero; None if none is.

    Parameters
    ----------
    row : sequence, length N + 1
        Exact entries of an affine function, acting on (y, 1).
    field : rows (N + 1, N + 1)
        Exact entries, acting on (y, 1).
    facts : list of rows, each of length N + 1
        Functions that are zero, reduced.
    order : int
        Lower derivatives are passed over.

    Returns
    -------
    tuple of (int, row or None)
        The row has length N + 1.
    """
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
        """Independent rows of a span, reduced.

        Parameters
        ----------
        rows : sequence of rows
            Exact entries.

        Returns
        -------
        list of tuple
            A basis of their span; its divisors are kept in `divisors`.
        """
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
        """Rows c with c M = 0.

        Parameters
        ----------
        matrix : sequence of rows
            Exact entries, at least one row.

        Returns
        -------
        list of row
            A basis.
        """
        size, width = len(matrix), len(matrix[0])
        unit = [[fmpq(int(i == j)) for j in range(size)] for i in range(size)]
        joined = [[*row, *more] for row, more in zip(matrix, unit, strict=True)]
        return [row[width:] for row in self.echelon(joined) if not any(row[:width])]

    def lasting(self, facts: Any, field: Any) -> Any:
        """The facts that stay true along a field: the largest part that it maps into itself.

        Parameters
        ----------
        facts : list of rows, each of length N + 1
            Functions that are zero, reduced.
        field : rows (N + 1, N + 1)
            Exact entries, acting on (y, 1).

        Returns
        -------
        list of rows
            Reduced.
        """
        while facts:
            rates = [reduced(product(row, field), facts) for row in facts]
            kept = [product(c, facts) for c in self.left_kernel(rates)]
            if len(kept) == len(facts):
                break
            facts = self.echelon(kept)
        return facts
