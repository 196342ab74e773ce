"""A system at one parameter point, for proofs: exact rows, fields and resets, flows in balls.

A state is known in two ways at once: by balls around its coordinates, and by `Facts`, affine
functions of it that are zero exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.events.leading_derivative import (
    Leading,
    Undecided,
    derivatives,
    leading,
)
from nonsmooth.runtime.model.completion import system_parameters
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.structure import Structure, structure_of
from nonsmooth.runtime.proof.motion.ball_flow import AffineFlow
from nonsmooth.runtime.proof.motion.exact_rows import Facts, Row, evaluate, product

if TYPE_CHECKING:
    from flint import arb

__all__ = ["EnclosedSystem", "enclosed_system"]


class _Rationals:
    """Exact arithmetic: rows, fields and resets of the systems are rational."""

    @staticmethod
    def rational(numerator: int, denominator: int) -> Any:
        from flint import fmpq

        return fmpq(numerator, denominator)

    def __getattr__(self, name: str) -> Any:
        raise InputError(f"a proof needs rational rows, fields and resets, and {name} is not")


@dataclass(frozen=True, eq=False)
class _Exact:
    """Fields, rows and resets as rationals; matrices act on (y, 1)."""

    fields: tuple[tuple[Row, ...], ...]
    rows: tuple[Row, ...]
    resets: tuple[tuple[Row, ...], ...]


@dataclass(frozen=True, eq=False)
class EnclosedSystem:
    """A system at one parameter point: exact rows, and flows in balls of one precision.

    Attributes
    ----------
    structure : Structure
    values : dict of str to Value
    bits : int
    exact : fields, rows and resets as rationals
    flows : tuple of AffineFlow
        One for each configuration.
    """

    structure: Structure
    values: dict[str, Value]
    bits: int
    exact: _Exact
    flows: tuple[AffineFlow, ...]

    def value(self, row: Row, facts: Facts, state: Sequence[arb]) -> Any:
        """An affine function of a state: exact if the facts give it, else a ball."""
        reduced = facts.reduce(row)
        return evaluate(reduced, state) if any(reduced[:-1]) else reduced[-1]

    def leading(
        self, row: Row, configuration: int, facts: Facts, state: Sequence[arb]
    ) -> Leading[Row] | None:
        """Find the first derivative of a row along a field that is not zero; None for none.

        Raises
        ------
        Undecided
            If a ball contains zero.
        """

        def sign(order: int, derivative: Row) -> int:
            value = self.value(derivative, facts, state)
            if value > 0 or value < 0:
                return 1 if value > 0 else -1
            certain = value == 0  # of balls, neither this nor its contrary need hold
            if not certain:
                raise Undecided(f"its derivative of order {order} is {_shown(value)}")
            return 0

        field = self.exact.fields[configuration]
        return leading(derivatives(row, field, len(row), product), sign)


def _shown(ball: arb) -> str:
    middle, radius = float(ball.mid()), float(ball.rad())
    return f"{middle:.3g} within {radius:.1g}"


@lru_cache(maxsize=64)
def _exact(kernels: SystemKernels, values: tuple[Value, ...], _: tuple[Any, ...]) -> _Exact:
    from flint import fmpq

    fractions = [value.exact for value in values if value.exact is not None]  # all are
    point = [fmpq(fraction.numerator, fraction.denominator) for fraction in fractions]
    lib, size = _Rationals(), len(kernels.table["states"])
    fields, rows, resets = (
        [tuple(fmpq(0) + entry for entry in row) for row in kernels.source(kernel)(point, lib=lib)]
        for kernel in ("fields", "rows", "resets")
    )

    def cut(stacked: list[Row], last: int) -> tuple[tuple[Row, ...], ...]:
        below = (*(fmpq(0),) * size, fmpq(last))
        return tuple((*stacked[i : i + size], below) for i in range(0, len(stacked), size))

    return _Exact(cut(fields, 0), tuple(rows), cut(resets, 1))


@lru_cache(maxsize=16)  # each keeps exponentials
def _enclosed(
    kernels: SystemKernels,
    named: tuple[tuple[str, Value], ...],
    exactly: tuple[Any, ...],
    bits: int,
) -> EnclosedSystem:
    exact = _exact(kernels, tuple(value for _, value in named), exactly)
    with flint_precision(bits):
        flows = tuple(AffineFlow(field, exact.rows, bits) for field in exact.fields)
    return EnclosedSystem(structure_of(kernels), dict(named), bits, exact, flows)


def enclosed_system(
    system: str | SystemKernels | DeclaredSystem, parameters: Any
) -> Callable[[int], EnclosedSystem]:
    """A system at one parameter point, by bits of precision.

    Raises
    ------
    InputError
        As `piecewise_in`, and for a parameter that is not rational.
    """
    kernels = kernels_of(system)
    structure_of(kernels)
    values = system_parameters(kernels, parameters)
    for name, value in values.items():
        if value.exact is None:
            raise InputError(f"a proof needs rational parameters, and {name} = {value} is not")
    named = tuple(values.items())
    exactly = tuple(value.exact for value in values.values())
    return lambda bits: _enclosed(kernels, named, exactly, bits)
