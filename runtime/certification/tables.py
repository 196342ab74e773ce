"""A system's numbers at one parameter point: rational where the parameters are, else balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.arithmetic import Balls
from nonsmooth.runtime.certification.models import matrix
from nonsmooth.runtime.certification.quotients import Quotient
from nonsmooth.runtime.kernels import SystemKernels
from nonsmooth.runtime.validation.facts import Row
from nonsmooth.runtime.values import Value

if TYPE_CHECKING:
    from flint import fmpq

__all__ = ["Matrix", "Number", "Tables", "numbers", "tables_of", "tables_over"]

Matrix = tuple[Row, ...]  # acts on (y, 1)
Number = Callable[[Any], Any]  # from an exact entry to a ball or a model


@dataclass(frozen=True, eq=False)
class Tables:
    """Fields, rows and resets; fields and resets act on (y, 1).

    Attributes
    ----------
    fields, resets : tuple of Matrix
    rows : tuple of Row
    exact : bool
        Whether the entries are rational numbers or functions; else they are balls.
    """

    fields: tuple[Matrix, ...]
    rows: tuple[Row, ...]
    resets: tuple[Matrix, ...]
    exact: bool


class _Rationals:
    """What rational kernels ask of an arithmetic."""

    @staticmethod
    def rational(numerator: int, denominator: int) -> Any:
        from flint import fmpq

        return fmpq(numerator, denominator)


def tables_of(kernels: SystemKernels, values: Sequence[Value], bits: int) -> Tables:
    """Tables of a system at the values of all its parameters, in their order.

    Exact where all values are rational and the declaration takes no roots; else balls of
    the working precision, of so many bits.
    """
    exactly = tuple(value.exact for value in values)
    if None not in exactly:
        try:
            return _exact(kernels, exactly)
        except AttributeError:  # the declaration has a root or a sine
            pass
    return _tables(kernels, [value.ball(bits) for value in values], Balls(), exact=False)


def tables_over(kernels: SystemKernels, values: Sequence[fmpq | Quotient]) -> Tables:
    """Tables of a system where some of its parameters stand for all their values.

    Raises
    ------
    AttributeError
        If the declaration has a root or a sine.
    """
    return _tables(kernels, values, _Rationals(), exact=True)


@lru_cache(maxsize=64)
def _exact(kernels: SystemKernels, fractions: tuple[Any, ...]) -> Tables:
    from flint import fmpq

    point = [fmpq(f.numerator, f.denominator) for f in fractions]
    return _tables(kernels, point, _Rationals(), exact=True)


def _tables(kernels: SystemKernels, point: Sequence[Any], lib: Any, *, exact: bool) -> Tables:
    from flint import arb, fmpq

    number: Any = fmpq if exact else arb
    size = len(kernels.table["states"])
    fields, rows, resets = (
        [
            tuple(number(0) + entry for entry in row)
            for row in kernels.source(kernel)(point, lib=lib)
        ]
        for kernel in ("fields", "rows", "resets")
    )

    def cut(stacked: list[Row], last: int) -> tuple[Matrix, ...]:
        below = (*(number(0),) * size, number(last))
        return tuple((*stacked[i : i + size], below) for i in range(0, len(stacked), size))

    return Tables(cut(fields, 0), tuple(rows), cut(resets, 1), exact)


def numbers(rows: Sequence[Sequence[Any]], number: Number | None = None) -> Any:
    """A matrix of balls, or of models where numbers are, at the working precision."""
    from flint import arb

    return matrix([list(map(number or arb, row)) for row in rows])
