"""A system's numbers: rational or rational functions where the parameters are, else balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.rational_functions import RationalFunction, symbols
from nonsmooth.runtime.core.taylor_models import matrix, middle_of
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.proof.motion.exact_rows import Row

if TYPE_CHECKING:
    from flint import fmpq

__all__ = [
    "Matrix",
    "NotRational",
    "Number",
    "Tables",
    "constant_symbols",
    "exact_tables",
    "numbers",
    "rational_of",
    "rational_tables",
    "tables_of",
    "tables_over",
]

_SHARP = 256  # bits that tell what irrational numbers make zero

Matrix = tuple[Row, ...]  # acts on (y, 1)
Number = Callable[[Any], Any]  # from an exact entry to a ball or a model


class NotRational(Exception):
    """A declaration takes a root or a sine of its parameters.

    Attributes
    ----------
    function : str
    """

    def __init__(self, function: str) -> None:
        super().__init__(f"the declaration takes {function} of its parameters")
        self.function = function


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
        The irrational parameters that do not vary: the last of which entries are functions.
    """

    fields: tuple[Matrix, ...]
    rows: tuple[Row, ...]
    resets: tuple[Matrix, ...]
    exact: bool
    constants: tuple[Value, ...] = ()

    def number_at(self, values: Sequence[Any] = ()) -> Number:
        """The map from entries to numbers, at values of the parameters that vary.

        Numbers are balls of the working precision, or Taylor models where values are.
        """
        from flint import arb, ctx

        point = [*values, *(value.ball(ctx.prec) for value in self.constants)]
        found: dict[RationalFunction, Any] = {}

        def number(entry: Any) -> Any:
            if isinstance(entry, Value):
                return entry.ball(ctx.prec)
            if not isinstance(entry, RationalFunction):
                return arb(entry)
            if entry not in found:
                found[entry] = entry(point)
            return found[entry]

        return number

    def near(self, entry: Any, values: Sequence[Any] = ()) -> float:
        """An entry, about."""
        return float(middle_of(self.number_at(values)(entry)))


class _Rationals:
    """What rational kernels ask of an arithmetic."""

    @staticmethod
    def rational(numerator: int, denominator: int) -> Any:
        from flint import fmpq

        return fmpq(numerator, denominator)

    def __getattr__(self, name: str) -> Any:
        raise NotRational(name)


def tables_of(kernels: SystemKernels, values: Sequence[Value], bits: int) -> Tables:
    """Tables of a system at the values of all its parameters, in their order.

    Exact where all values are rational and the declaration takes no roots; else balls of
    the working precision, of so many bits.
    """
    exactly = tuple(value.exact for value in values)
    if None not in exactly:
        with suppress(NotRational):
            return rational_tables(kernels, exactly)
    return _tables(kernels, [value.ball(bits) for value in values], Balls(), exact=False)


def exact_tables(kernels: SystemKernels, values: Sequence[Value], bits: int) -> Tables:
    """As `tables_of`, but exact in irrational parameters too: entries are functions of them."""
    constants = tuple(dict.fromkeys(value for value in values if value.exact is None))
    if constants:
        with suppress(NotRational):
            return _symbolic(kernels, tuple(values), constants)
    return tables_of(kernels, values, bits)


@lru_cache(maxsize=64)
def _symbolic(
    kernels: SystemKernels, values: tuple[Value, ...], constants: tuple[Value, ...]
) -> Tables:
    found = constant_symbols((), constants)
    place = dict(zip(constants, found, strict=True))
    point = [rational_of(v.exact) if v.exact is not None else place[v] for v in values]
    return tables_over(kernels, point, constants)


def constant_symbols(names: Sequence[str], constants: Sequence[Value]) -> list[RationalFunction]:
    """Parameters that vary, and irrational ones that do not."""
    own = [f"constant{k}" for k in range(len(constants))]
    return symbols([*names, *own], [value.ball(_SHARP) for value in constants])


def tables_over(
    kernels: SystemKernels,
    values: Sequence[fmpq | RationalFunction],
    constants: tuple[Value, ...] = (),
) -> Tables:
    """Tables of a system where some of its parameters stand for all their values.

    Parameters
    ----------
    kernels : SystemKernels
    values : sequence of fmpq or RationalFunction
        Of all its parameters, in their order.
    constants : tuple of Value
        Those of the last parameters of the functions, which are irrational and do not vary.

    Raises
    ------
    NotRational
    """
    return replace(_tables(kernels, values, _Rationals(), exact=True), constants=constants)


@lru_cache(maxsize=64)
def rational_tables(kernels: SystemKernels, fractions: tuple[Any, ...]) -> Tables:
    """Tables of a system whose parameters have rational values, in their order.

    Raises
    ------
    NotRational
    """
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
