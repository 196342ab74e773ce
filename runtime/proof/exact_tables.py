"""A system's numbers at one parameter point: rational where the parameters are, else balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.rational_functions import RationalFunction, symbols
from nonsmooth.runtime.core.taylor_models import matrix
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.proof.motion.exact_rows import Row

if TYPE_CHECKING:
    from flint import fmpq

__all__ = [
    "Matrix",
    "Number",
    "Tables",
    "constant_symbols",
    "exact_tables",
    "numbers",
    "rational_of",
    "tables_of",
    "tables_over",
]

_SHARP = 256  # bits that tell what irrational numbers make zero

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
    constants : tuple of Value
        The irrational parameters, of which entries are functions.
    """

    fields: tuple[Matrix, ...]
    rows: tuple[Row, ...]
    resets: tuple[Matrix, ...]
    exact: bool
    constants: tuple[Value, ...] = ()

    def number(self, entry: Any) -> Any:
        """A ball around an entry, at the working precision."""
        from flint import arb, ctx

        if isinstance(entry, RationalFunction):
            return entry([value.ball(ctx.prec) for value in self.constants])
        return arb(entry)

    def near(self, entry: Any) -> float:
        """An entry, about."""
        return float(self.number(entry).mid())


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


def exact_tables(kernels: SystemKernels, values: Sequence[Value], bits: int) -> Tables:
    """As `tables_of`, but exact in irrational parameters too: entries are functions of them."""
    constants = tuple(dict.fromkeys(value for value in values if value.exact is None))
    if constants:
        with suppress(AttributeError):  # the declaration has a root or a sine
            return _symbolic(kernels, tuple(values), constants)
    return tables_of(kernels, values, bits)


@lru_cache(maxsize=64)
def _symbolic(
    kernels: SystemKernels, values: tuple[Value, ...], constants: tuple[Value, ...]
) -> Tables:
    found = constant_symbols((), constants)
    place = dict(zip(constants, found, strict=True))
    point = [rational_of(v.exact) if v.exact is not None else place[v] for v in values]
    return replace(tables_over(kernels, point), constants=constants)


def constant_symbols(names: Sequence[str], constants: Sequence[Value]) -> list[RationalFunction]:
    """Parameters that vary, and irrational ones that do not."""
    own = [f"constant{k}" for k in range(len(constants))]
    return symbols([*names, *own], [value.ball(_SHARP) for value in constants])


def tables_over(kernels: SystemKernels, values: Sequence[fmpq | RationalFunction]) -> Tables:
    """Tables of a system where some of its parameters stand for all their values.

    Raises
    ------
    AttributeError
        If the declaration has a root or a sine.
    """
    return _tables(kernels, values, _Rationals(), exact=True)


@lru_cache(maxsize=64)
def _exact(kernels: SystemKernels, fractions: tuple[Any, ...]) -> Tables:
    return _tables(kernels, list(map(rational_of, fractions)), _Rationals(), exact=True)


def rational_of(value: Fraction) -> fmpq:
    """The same number for FLINT."""
    from flint import fmpq

    return fmpq(value.numerator, value.denominator)


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


def numbers(rows: Sequence[Sequence[Any]], number: Number) -> Any:
    """A matrix of balls, or of models where numbers are, at the working precision."""
    return matrix([list(map(number, row)) for row in rows])
