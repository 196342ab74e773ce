"""A system at one parameter point, for proofs: exact rows, fields and resets, flows in balls.

A state is known in two ways at once: by balls around its coordinates, and by `Invariants`, affine
functions of it that are zero exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.checker.stated.exact import product
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.events.leading_derivative import (
    Leading,
    Undecided,
    derivatives,
    leading,
)
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.structure import Structure, structure_of
from nonsmooth.runtime.proof.exact_tables import NotRational, Tables, rational_tables
from nonsmooth.runtime.proof.motion.ball_flow import AffineFlow
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, evaluate

if TYPE_CHECKING:
    from flint import arb

__all__ = ["EnclosedSystem", "enclosed_system"]


@dataclass(frozen=True, eq=False)
class EnclosedSystem:
    """A system at one parameter point: exact rows, and flows in balls of one precision."""

    structure: Structure
    values: dict[str, Value]
    bits: int
    exact: Tables  # fields, rows and resets as rationals
    flows: tuple[AffineFlow, ...]  # one for each configuration

    def value(self, row: Row, invariants: Invariants, state: Sequence[arb]) -> Any:
        """Return an affine function of a state: exact if the invariants give it, else a ball."""
        reduced = invariants.reduce(row)
        return evaluate(reduced, state) if any(reduced[:-1]) else reduced[-1]

    def leading(
        self, row: Row, configuration: int, invariants: Invariants, state: Sequence[arb]
    ) -> Leading[Row] | None:
        """Return the first nonzero derivative of a row along a configuration's field, or None.

        The state (N) is known by its enclosure and by invariants that hold exactly. `Undecided` is
        raised if the ball of a derivative contains zero.
        """

        def sign(order: int, derivative: Row) -> int:
            value = self.value(derivative, invariants, state)
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


@lru_cache(maxsize=16)  # each keeps exponentials
def _enclosed(
    kernels: SystemKernels,
    named: tuple[tuple[str, Value], ...],
    exactly: tuple[Any, ...],
    bits: int,
) -> EnclosedSystem:
    try:
        exact = rational_tables(kernels, exactly)
    except NotRational as problem:
        raise InputError(
            f"a proof needs rational rows, fields and resets, and {problem.function} is not"
        ) from None
    with flint_precision(bits):
        flows = tuple(AffineFlow(field, exact.rows, bits) for field in exact.fields)
    return EnclosedSystem(structure_of(kernels), dict(named), bits, exact, flows)


def enclosed_system(
    system: str | SystemKernels | DeclaredSystem, parameters: Any
) -> Callable[[int], EnclosedSystem]:
    """Return a function from bits of precision to the system at one parameter point.

    All physical parameters are given, and all have to be rational.
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
