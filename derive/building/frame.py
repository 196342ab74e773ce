"""Coordinates, states and parameters of an oscillator: what names in a declaration stand for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from nonsmooth.derive.building.elements import Direction, RigidStop
from nonsmooth.derive.building.matrices import is_array, square, values_of_doubles
from nonsmooth.derive.declaration.algebra import (
    affine_terms,
    along,
    cancel,
    frozen,
    inverse,
    is_affine,
    remembered,
)
from nonsmooth.derive.declaration.fields import exact, made
from nonsmooth.derive.declaration.parameter import Parameter, sign_of
from nonsmooth.derive.declaration.system import TIME
from nonsmooth.derive.errors import DeclarationError

_LISTED = 12


@dataclass(frozen=True, eq=False)
class Frame:
    """States, parameters and mass matrix of an oscillator."""

    positions: tuple[sp.Symbol, ...]  # n symbols
    velocities: tuple[sp.Symbol, ...]  # n symbols
    others: tuple[sp.Symbol, ...]  # cosines and sines of the forcing, positions of sliders
    parameters: tuple[Parameter, ...]
    mass: sp.Matrix  # n x n

    @cached_property
    def states(self) -> tuple[sp.Symbol, ...]:
        """All states: positions, velocities, others."""
        return (*self.positions, *self.velocities, *self.others)

    @cached_property
    def _known(self) -> frozenset[sp.Symbol]:
        return frozenset(self.states)

    @cached_property
    def inverse(self) -> sp.Matrix:
        """Inverse of the mass matrix."""
        return frozen(inverse(self.mass))

    @cached_property
    def _symbols(self) -> dict[str, sp.Symbol]:
        known = {p.name: p.symbol for p in self.parameters}
        return known | {str(s): s for s in self.states}

    def expression(self, given: Any) -> Any:
        """An exact expression, its symbols replaced by the frame's symbols of the same name."""
        found = exact(given)
        return found.xreplace(
            {s: self._symbols[s.name] for s in found.free_symbols if s.name in self._symbols}
        )

    def column(self, given: Sequence[Any] | Mapping[str, Any] | None, what: str) -> sp.Matrix:
        """Column (n x 1) of values given in order or by coordinate; zero where none is given."""
        names = [str(s) for s in self.positions]
        if isinstance(given, Mapping):
            for name in given:
                if name not in names:
                    listed = ", ".join(names[:_LISTED]) + ", ..." * (len(names) > _LISTED)
                    raise DeclarationError(f"{what}: unknown coordinate {name!r} (known: {listed})")
            given = [given.get(name, 0) for name in names]
        if is_array(given):
            given = values_of_doubles(given, what)
        given = made(tuple[Any, ...], () if given is None else given, what)
        if not given:
            return sp.zeros(len(names), 1)
        if len(given) != len(names):
            raise DeclarationError(f"{what} has {len(given)} values for {len(names)} coordinates")
        return self._constant(sp.Matrix([self.expression(value) for value in given]), what)

    def matrix(self, given: Any, what: str) -> sp.Matrix:
        """An n x n matrix; zero when not given."""
        size = len(self.positions)
        if given is None:
            return sp.zeros(size, size)
        return self._constant(square(given, what, size, self.expression), what)

    def _constant(self, matrix: sp.Matrix, what: str) -> sp.Matrix:
        """The matrix itself; refused if it depends on the time or the state."""
        names = {symbol.name for symbol in matrix.free_symbols}
        if str(TIME) in names:
            raise DeclarationError(
                f"{what} depends on the time, which is not supported: coefficients are constant,"
                ' and a force F cos(w t) on x is forcing=[Harmonic(w, cosine={"x": F})]'
            )
        if changing := sorted(names & {str(state) for state in self.states}):
            raise DeclarationError(
                f"{what} depends on the state {changing[0]}, which is not supported: forces are"
                " linear piece by piece, by SoftStop, Slider, Friction or Regions in elements"
            )
        return matrix

    def row(self, direction: Direction, where: str) -> sp.Matrix:
        """Row of weights (1 x n) of a direction; a zero direction is refused."""
        if isinstance(direction, str):
            direction = {direction: 1}
        row = self.column(direction, where).T
        if row.is_zero_matrix:
            raise DeclarationError(f"{where}: its direction is zero")
        return sp.ImmutableMatrix(row)

    def position(self, row: sp.Matrix) -> sp.Expr:
        """Position along a row of weights."""
        return along(row, self.positions)

    def velocity(self, row: sp.Matrix) -> sp.Expr:
        """Velocity along a row of weights."""
        return along(row, self.velocities)

    def affine(self, function: Any, where: str) -> sp.Expr:
        """An affine function of the state; DeclarationError refuses another one."""
        function = self.expression(function)
        if not is_affine(function, self._known):
            raise DeclarationError(f"{where}: {function} is not affine in the state")
        return function

    @remembered
    def tidy(self, function: sp.Expr) -> sp.Expr:
        """An affine function of the state with its coefficients in lowest terms."""
        slopes, constant = self.terms(sp.expand(function))
        return sp.Add(cancel(constant), *(cancel(slope) * s for s, slope in slopes.items()))

    def terms(self, function: sp.Expr) -> tuple[dict[sp.Symbol, sp.Expr], sp.Expr]:
        """Coefficients of the states in an affine function, and its constant."""
        return affine_terms(function, self._known)

    def matrix_of(self, functions: Iterable[sp.Expr], states: Sequence[sp.Symbol]) -> sp.Matrix:
        """Matrix of the coefficients of given states, one row for each affine function."""
        columns = {s: j for j, s in enumerate(states)}
        rows = [self.terms(function)[0] for function in functions]
        entries = {
            (i, columns[s]): sp.expand(slope)
            for i, row in enumerate(rows)
            for s, slope in row.items()
            if s in columns
        }
        return sp.Matrix.from_dok(len(rows), len(states), entries)

    @remembered
    def sign(self, expression: sp.Expr) -> int | None:
        """Sign of an expression of parameters on their whole domain; None if none is shown."""
        return sign_of(sp.cancel(expression), self.parameters)


def inferred_parameters(
    given: Iterable[Parameter], states: Iterable[str], elements: Sequence[Any], *sources: Any
) -> tuple[Parameter, ...]:
    """The given parameters, and one for every other symbol of sources and elements.

    A symbol's assumptions give its domain: positive, nonnegative, negative or real. One
    without them is positive, and a coefficient of restitution lies in [0, 1].
    """
    found: dict[str, Parameter | None] = {**dict.fromkeys(states), **{p.name: p for p in given}}
    restitutions = {
        exact(element.restitution) for element in elements if isinstance(element, RigidStop)
    }
    try:
        symbols = list(_symbols([*sources, *elements]))
    except RecursionError:
        raise DeclarationError("a matrix, a load or an element is nested too deeply") from None
    for symbol in symbols:
        if symbol.name not in found:
            found[symbol.name] = _inferred(symbol, symbol.name in map(str, restitutions))
    return tuple(p for p in found.values() if p is not None)


def _inferred(symbol: sp.Symbol, restitution: bool) -> Parameter:
    name = symbol.name
    if restitution:
        text = "coefficient of restitution, nondimensional"
        return Parameter(name, text, upper=1, closed=True, upper_closed=True)
    if symbol.is_negative:
        return Parameter(name, "negative, in the user's consistent units", -sp.oo, 0)
    if symbol.is_positive is None and symbol.is_nonnegative:
        return Parameter(name, "not negative, in the user's consistent units", closed=True)
    if symbol.is_positive is None and symbol.is_real:
        return Parameter(name, "real, in the user's consistent units", -sp.oo)
    return Parameter(name, "positive, in the user's consistent units")


def _symbols(value: Any) -> Iterator[sp.Symbol]:
    """Symbols of all expressions in a nested value, in order of appearance."""
    if is_array(value):
        return
    if isinstance(value, sp.MatrixBase):
        yield from _symbols([entry for _, entry in sorted(value.todok().items())])
    elif isinstance(value, sp.Basic):
        yield from sorted(value.free_symbols, key=str)
    elif isinstance(value, Mapping):
        yield from _symbols(list(value.values()))
    elif isinstance(value, list | tuple):
        for entry in value:
            yield from _symbols(entry)
    elif is_dataclass(value):
        for part in fields(value):
            yield from _symbols(getattr(value, part.name))
    elif hasattr(value, "tolist"):
        yield from _symbols(value.tolist())
