"""Linear motions inside a configuration: second order with held coordinates, or first order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import Any

import numpy as np
import sympy as sp

from nonsmooth.derive.declaration.algebra import (
    cancel,
    frozen,
    inverse,
    is_surely_positive_definite,
    symbols_of,
)
from nonsmooth.derive.declaration.fields import declared, made, rows_of, set_fields
from nonsmooth.derive.declaration.parameter import check_finite
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.symbols import Values


@declared
class SecondOrder:
    """Linear motion ``mass x'' + damping x' + stiffness x = load``, some coordinates held.

    Parameters
    ----------
    mass, stiffness, damping : n x n matrices
        `damping` is zero when omitted. Units are the user's own, consistent.
    load : n values
        Constant forces; zero when omitted.
    held : mapping of position symbol to velocity
        Coordinates that keep a constant velocity (stick); their rows of the equation give
        the reaction and are not integrated.
    """

    mass: sp.Matrix
    stiffness: sp.Matrix
    load: Any = ()
    damping: Any = None
    held: Values = field(default_factory=dict)

    def __post_init__(self) -> None:
        mass = _square(self.mass, "mass")
        size = mass.rows
        damping = sp.zeros(size, size) if self.damping is None else self.damping
        set_fields(
            self,
            mass=mass,
            stiffness=_square(self.stiffness, "stiffness", size),
            damping=_square(damping, "damping", size),
            load=_column(self.load, "load", size, "mass"),
        )
        if not is_surely_positive_definite(mass) and mass.det() == 0:
            raise DeclarationError("mass is singular")
        for symbol, velocity in self.held.items():
            check_finite(velocity, f"held velocity of {symbol}")

    def held_at(self, states: Sequence[sp.Symbol]) -> dict[int, sp.Expr]:
        """Find which coordinates are held.

        Parameters
        ----------
        states : sequence of symbols (N,)
            States of the system: positions, then velocities.

        Returns
        -------
        dict of int to expression
            Index of each held coordinate, and its velocity.
        """
        return {list(states).index(symbol): velocity for symbol, velocity in self.held.items()}

    def field(self, states: Sequence[sp.Symbol]) -> tuple[sp.Matrix, sp.Matrix]:
        """Give the matrix A and the offset b of the first-order form ``y' = A y + b``.

        Held coordinates keep the velocity that the state carries: x' = v, v' = 0.

        Parameters
        ----------
        states : sequence of symbols (N,)
            States of the system: positions, then velocities.

        Returns
        -------
        tuple of matrix (N, N) and column (N,)
            A and b.
        """
        size = self.mass.rows
        held = self.held_at(states)
        free = [i for i in range(size) if i not in held]
        matrix = {(i, size + i): sp.S.One for i in range(size)}
        offset: dict[tuple[int, int], sp.Expr] = {}
        if free:
            spread = inverse(self.mass.extract(free, free))
            columns = list(range(size))
            for given, first in ((self.stiffness, 0), (self.damping, size)):
                product = spread * given.extract(free, columns)
                matrix |= {
                    (size + free[k], first + j): -entry for (k, j), entry in product.todok().items()
                }
            load = spread * self.load.extract(free, [0])
            offset = {(size + free[k], 0): entry for (k, _), entry in load.todok().items()}
        whole = 2 * size
        return (
            frozen(sp.Matrix.from_dok(whole, whole, matrix)),
            frozen(sp.Matrix.from_dok(whole, 1, offset)),
        )

    def substituted(self, values: Values, origin: sp.Matrix) -> SecondOrder:
        """Write the same motion with symbols replaced, in coordinates ``z = x - origin``.

        Parameters
        ----------
        values : mapping of symbol to expression
            What is put in place of each symbol.
        origin : column (n,)
            In the old coordinates, with the symbols replaced.

        Returns
        -------
        SecondOrder
        """
        stiffness = self.stiffness.subs(values)
        load = (self.load.subs(values) - stiffness * origin).applyfunc(cancel)
        held = {s.subs(values): v.subs(values) for s, v in self.held.items()}
        damping = self.damping.subs(values)
        return SecondOrder(self.mass.subs(values), stiffness, tuple(load), damping, held)

    def free_symbols(self) -> set[sp.Symbol]:
        """Give the symbols of the matrices, the load and the held velocities.

        Returns
        -------
        set of symbols
        """
        matrices = (self.mass, self.stiffness, self.damping, self.load)
        held = (velocity.free_symbols for velocity in self.held.values())
        return set().union(*map(symbols_of, matrices), *held)


@declared
class FirstOrder:
    """Affine motion ``y' = matrix y + offset``.

    Parameters
    ----------
    matrix : N x N matrix
        Numbers or expressions of the parameters.
    offset : N values, optional
        Zero when omitted.

    Raises
    ------
    DeclarationError
        For another shape.
    """

    matrix: sp.Matrix
    offset: Any = ()

    def __post_init__(self) -> None:
        matrix = _square(self.matrix, "matrix")
        offset = _column(self.offset, "offset", matrix.rows, "matrix")
        set_fields(self, matrix=matrix, offset=offset)

    def field(self, states: Sequence[sp.Symbol]) -> tuple[sp.Matrix, sp.Matrix]:
        """Give the matrix A and the offset b of ``y' = A y + b``.

        Parameters
        ----------
        states : sequence of symbols (N,)
            States of the system: positions, then velocities.

        Returns
        -------
        tuple of matrix (N, N) and column (N,)
            A and b.
        """
        return self.matrix, self.offset

    def free_symbols(self) -> set[sp.Symbol]:
        """Give the symbols of the matrix and the offset.

        Returns
        -------
        set of symbols
        """
        return symbols_of(self.matrix) | symbols_of(self.offset)


Dynamics = SecondOrder | FirstOrder


def _square(matrix: Any, what: str, size: int | None = None) -> sp.ImmutableMatrix:
    matrix = _finite(rows_of(matrix, what), what)
    if matrix.rows != matrix.cols or (size is not None and matrix.rows != size):
        expected = "square" if size is None else f"{size} x {size}"
        raise DeclarationError(f"{what} is {matrix.rows} x {matrix.cols}, not {expected}")
    return matrix


def _column(values: Any, what: str, size: int, matrix: str) -> sp.ImmutableMatrix:
    """Column (size x 1) of the values beside a matrix; zeros if there are none."""
    values = made(tuple[Any, ...], values, what)
    rows = [each if isinstance(each, list | tuple | np.ndarray) else [each] for each in values]
    column = _finite(rows_of(rows, what) if rows else sp.zeros(size, 1), what)
    if column.shape != (size, 1):
        raise DeclarationError(f"{what} has {column.rows} values where {matrix} is {size} x {size}")
    return column


def _finite(matrix: sp.Matrix, what: str) -> sp.ImmutableMatrix:
    """The matrix, immutable; refused if an entry is not finite or not real."""
    for entry in matrix.todok().values():
        if not entry.is_Rational:
            check_finite(entry, what)
    return frozen(matrix)
