"""A system's numbers: rational or rational functions where the parameters are, else balls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.stated.parameters import number_at
from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.irrational_numbers import irrationals
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.saved_system import saved_of
from nonsmooth.runtime.model.structure import Structure, structure_of

_SHARP = 256  # bits that tell what irrational numbers make zero

Row = tuple["fmpq", ...]  # n y + c: n, then c
Matrix = tuple[Row, ...]  # acts on (y, 1)


class NotRational(Exception):
    """The declaration takes `function`, a root or a sine say, of its parameters."""

    def __init__(self, function: str) -> None:
        super().__init__(f"the declaration takes {function} of its parameters")
        self.function = function


@dataclass(frozen=True, eq=False)
class Tables:
    """The numbers of a system: fields and resets (N + 1, N + 1) on (y, 1), and rows (N + 1)."""

    fields: tuple[Matrix, ...]
    rows: tuple[Row, ...]
    resets: tuple[Matrix, ...]
    exact: bool  # entries are rational numbers or functions; else they are balls
    # irrational numbers that do not vary: the last variables of the entries' functions
    constants: tuple[Value, ...] = ()

    def near(self, entry: Any, values: Sequence[Any] = ()) -> float:
        """Return the middle of an entry's ball, at values of the parameters that vary."""
        known = [value.ball(ctx.prec) for value in self.constants]
        return float(number_at([*values, *known])(entry).mid())


class _Exactly:
    """The arithmetic that exact kernels need: rationals, and irrational numbers that are known.

    Any other function that a kernel asks for raises `NotRational`.
    """

    def __init__(self, numbers: Mapping[str, Any]) -> None:
        self._numbers = numbers

    @staticmethod
    def rational(numerator: int, denominator: int) -> Any:
        return fmpq(numerator, denominator)

    def constant(self, text: str) -> Any:
        return self._numbers[text]

    def __getattr__(self, name: str) -> Any:
        raise NotRational(name)


def exact_tables(kernels: SystemKernels, values: Mapping[str, Value], bits: int) -> Tables:
    """Return the tables of a system at the values of all its parameters, in their order.

    They are exact: rational, or functions of irrational numbers. Where the declaration takes a root
    or a sine of its parameters, the entries are balls of `bits`.
    """
    with suppress(NotRational, ArithmeticError):
        return tables_over(kernels, (), values)
    return _tables(kernels, [value.ball(bits) for value in values.values()], Balls(), exact=False)


@lru_cache(maxsize=64)
def declared_constants(kernels: SystemKernels) -> tuple[str, ...]:
    """Return the texts of the irrational numbers in a declaration, as `parse` takes them."""
    saved = saved_of(kernels)
    functions = [] if saved is None else [saved.functions[k] for k in ("fields", "rows", "resets")]
    return tuple(dict.fromkeys(text for function in functions for text in function.constants))


def tables_over(
    kernels: SystemKernels,
    names: Iterable[str],
    fixed: Mapping[str, Value] | None = None,
    *,
    beside: Iterable[Value] = (),
    orbit: OrbitKernels | None = None,
) -> Tables:
    """Return exact tables of a system some of whose parameters vary: rational functions of these.

    `names` are the parameters that vary, `fixed` has the values of others. `orbit` holds an orbit's
    functions where these are its parameters, from which the system's follow. The irrational ones of
    `fixed`, of values `beside` and of the declaration are the last variables. `NotRational` is
    raised if the declaration takes a root or a sine of its parameters, `ArithmeticError` if a
    number divides by what may be zero, or a literal is enormous.
    """
    given = {} if fixed is None else fixed
    told = (value.text for value in (*given.values(), *beside) if value.exact is None)
    texts = (*told, *declared_constants(kernels))
    return _tables_over(kernels, tuple(names), tuple(given.items()), texts, orbit)


@lru_cache(maxsize=128)
def _tables_over(
    kernels: SystemKernels,
    names: tuple[str, ...],
    fixed: tuple[tuple[str, Value], ...],
    texts: tuple[str, ...],
    orbit: OrbitKernels | None,
) -> Tables:
    required = {} if orbit is None else {n: parse(text) for n, text in orbit.required.items()}
    own = [value.text for value in required.values() if value.exact is None]
    known = irrationals(names, [*texts, *own], lambda text: parse(text).ball(_SHARP))
    found: dict[str, Any] = {
        name: known.numbers[v.text] if v.exact is None else rational_of(v.exact)
        for name, v in (*required.items(), *fixed)
    }
    found |= zip(names, known.variables, strict=True)
    if orbit is not None:
        found |= follow(orbit, found, rational_of)
        if missing := [table.name for table in kernels.parameters if table.name not in found]:
            raise InputError(f"{orbit.name}: {', '.join(missing)} left open")
    point = [found[table.name] for table in kernels.parameters]
    tables = _tables(kernels, point, _Exactly(known.numbers), exact=True)
    return replace(tables, constants=tuple(map(parse, known.generators)))


class ExactSystem(NamedTuple):
    """A system at one parameter point, with rational numbers."""

    structure: Structure
    values: dict[str, Value]
    exact: Tables


def exact_system(
    system: str | SystemKernels | DeclaredSystem, parameters: Mapping[str, object]
) -> ExactSystem:
    """Return a system at one parameter point; all of its parameters have to be given and rational.

    A declaration that takes a root or a sine of them is refused.
    """
    kernels = kernels_of(system)
    structure, values = structure_of(kernels), system_parameters(kernels, parameters)
    for name, value in values.items():
        if value.exact is None:
            raise InputError(f"a proof needs rational parameters, and {name} = {value} is not")
    try:
        if declared_constants(kernels):
            raise NotRational("an irrational number")
        return ExactSystem(structure, values, tables_over(kernels, (), values))
    except NotRational as problem:
        raise InputError(
            f"a proof needs rational rows, fields and resets, and {problem.function} is not"
        ) from None


def rational_of(value: Fraction) -> fmpq:
    """Return a fraction as FLINT's rational number."""
    return fmpq(value.numerator, value.denominator)


def _tables(kernels: SystemKernels, point: Sequence[Any], lib: Any, *, exact: bool) -> Tables:
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
