"""Numbers of orbits as texts in files: they give back the very same doubles or mpmath numbers."""

from __future__ import annotations

import math
from decimal import Decimal, InvalidOperation
from typing import Any, Protocol

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.orbits.orbit import DOUBLE
from nonsmooth.runtime.orbits.refine import MOST_DIGITS
from nonsmooth.runtime.shooting.newton import CONVERGED

__all__ = ["OrbitCounts", "bits_of", "check_counts", "number_text", "read_number"]

_DOUBLE_BITS = 53
_MOST_BITS = 8 * MOST_DIGITS
_LARGEST_EXPONENT, _LEAST_EXPONENT = 308, -10 * MOST_DIGITS  # decimal


class OrbitCounts(Protocol):
    """The entries of an orbit's file that say how the orbit was solved."""

    @property
    def arithmetic(self) -> str:
        """The arithmetic of the orbit's numbers."""


def bits_of(number: Any) -> int:
    """Precision in bits of a number: of a double, or of the mpmath context that made it."""
    if isinstance(number, float):
        return _DOUBLE_BITS
    return max(int(number.man_exp[0]).bit_length(), int(number.context.prec))


def number_text(number: Any, bits: int) -> str:
    """Decimal text that determines a number with a precision of `bits`."""
    if isinstance(number, float):
        return float.__repr__(number)
    return decimal_string(number, math.ceil(bits * math.log10(2)))


def check_counts(entries: OrbitCounts) -> None:
    """Raise `InputError` for counts of bits, digits and iterations that no orbit has."""
    double = entries.arithmetic == "double"
    allowed = {
        "bits": (_DOUBLE_BITS, _DOUBLE_BITS if double else _MOST_BITS),
        "digits": (0, DOUBLE if double else MOST_DIGITS),
        "iterations": (0, math.inf),
        "status": (CONVERGED, CONVERGED),
    }
    for name, (least, most) in allowed.items():
        count = getattr(entries, name)
        if not least <= count <= most:
            raise InputError(f"{name} is {count}, which no saved orbit has")


def read_number(name: str, text: str, bits: int | None) -> Any:
    """The double, or the mpmath number of so many bits, nearest to a decimal text.

    It is a double if `bits` is None. `name` is for the message of the `InputError`, which
    is raised if the text is no finite decimal of a usual size.
    """
    try:
        decimal = Decimal(text)
    except InvalidOperation:
        raise InputError(f"{name} is not a decimal number") from None
    if not decimal.is_finite():
        raise InputError(f"{name} is {text}, not a finite number")
    if decimal and not _LEAST_EXPONENT <= decimal.adjusted() < _LARGEST_EXPONENT:
        raise InputError(f"{name} is too large or too small")
    if bits is None:
        return float(text)
    from mpmath import MPContext, libmp

    context = MPContext()
    context.prec = bits
    return context.make_mpf(libmp.from_rational(*decimal.as_integer_ratio(), bits, "n"))
