"""What is proved about one phase: signs of affine functions, and the first crossing, in balls.

A state is known in two ways at once: by balls around its coordinates, and by `Facts`, affine
functions of it that are zero exactly. A velocity set to the belt's by a reset, a boundary that
was just reached and a coordinate at rest on a stop are facts; balls alone could never tell
them from nearly so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.arithmetic import Balls
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import SystemKernels, load_system
from nonsmooth.runtime.simulation.piecewise import piecewise_in, system_parameters
from nonsmooth.runtime.simulation.structure import Structure, structure_of
from nonsmooth.runtime.values import Value

if TYPE_CHECKING:
    from flint import arb, fmpq

__all__ = ["EnclosedSystem", "Facts", "Undecided", "enclosed_system", "evaluate", "product"]

Row = tuple["fmpq", ...]  # n y + c: n, then c


class Undecided(Exception):
    """The balls are too wide to tell.

    Attributes
    ----------
    reason : str
    at : arb or None
        When in the phase; None at its start.
    digits : bool
        More digits may help.
    """

    def __init__(self, reason: str, at: arb | None = None, *, digits: bool = True) -> None:
        super().__init__(reason)
        self.reason, self.at, self.digits = reason, at, digits


@dataclass(frozen=True)
class Facts:
    """Affine functions of a state that are exactly zero: independent rows, reduced.

    Attributes
    ----------
    rows : tuple of Row
        In reduced echelon form.
    pivots : tuple of int
        The coordinate that each row gives in terms of the others.
    """

    rows: tuple[Row, ...]
    pivots: tuple[int, ...]

    @staticmethod
    def of(rows: Sequence[Sequence[Any]]) -> Facts:
        """Facts from rows that need not be independent."""
        if not rows:
            return Facts((), ())
        reduced = [row for row in _echelon(rows) if any(row)]
        return Facts(
            tuple(reduced),
            tuple(next(j for j, entry in enumerate(row) if entry) for row in reduced),
        )

    @property
    def consistent(self) -> bool:
        """Whether any state meets them."""
        return not self.rows or self.pivots[-1] < len(self.rows[-1]) - 1

    def reduce(self, row: Sequence[Any]) -> Row:
        """The same function of the state without the coordinates that are known by others."""
        found = list(row)
        for fact, pivot in zip(self.rows, self.pivots, strict=True):
            if factor := found[pivot]:
                found = [x - factor * y for x, y in zip(found, fact, strict=True)]
        return tuple(found)

    def lasting(self, field: Sequence[Row]) -> Facts:
        """Those that stay true along a field: the largest part that it maps into itself."""
        facts = self
        while facts.rows:
            rates = [facts.reduce(product(row, field)) for row in facts.rows]
            kept = [product(c, facts.rows) for c in _left_kernel(rates)]
            if len(kept) == len(facts.rows):
                break
            facts = Facts.of(kept)
        return facts

    def reset(self, reset: Sequence[Row]) -> Facts:
        """What is true behind a reset of a state for which these are."""
        return Facts.of(_left_kernel([self.reduce(row) for row in reset]))

    def tighten(self, state: Sequence[arb]) -> list[arb]:
        """Balls around the coordinates, smaller where a fact gives one by the others."""
        found = list(state)
        for row, pivot in zip(self.rows, self.pivots, strict=True):
            given = evaluate(tuple(-x if j != pivot else 0 * x for j, x in enumerate(row)), state)
            if given.rad() <= found[pivot].rad():
                found[pivot] = given
        return found


def _echelon(rows: Sequence[Sequence[Any]]) -> list[Row]:
    from flint import fmpq_mat

    flat = [entry for row in rows for entry in row]
    reduced, rank = fmpq_mat(len(rows), len(rows[0]), flat).rref()
    return [tuple(row) for row in reduced.tolist()[:rank]]


def _left_kernel(matrix: Sequence[Sequence[Any]]) -> list[Row]:
    """Rows c with c M = 0."""
    size, width = len(matrix), len(matrix[0])
    joined = [[*row, *(int(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    return [row[width:] for row in _echelon(joined) if not any(row[:width])]


def product(row: Sequence[Any], matrix: Sequence[Sequence[Any]]) -> Row:
    """A row times a matrix: with a field, the row of the derivative."""
    columns: Iterable[tuple[Any, ...]] = zip(*matrix, strict=True)
    return tuple(
        sum((x * y for x, y in zip(row, column, strict=True) if x and y), 0 * column[0])
        for column in columns
    )


def evaluate(row: Sequence[Any], state: Sequence[arb]) -> arb:
    """An affine function of a state."""
    from flint import arb

    total = arb(row[-1])
    for x, y in zip(row, state, strict=False):
        if x:
            total += y * x
    return total


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
    modes : for each configuration its exponents, real and imaginary parts as balls
    flows : for each configuration, function by function, rows of balls
    weights : for each configuration and boundary, function by function, a row of balls
        They give the coefficients of the boundary's function of time from (y(0), 1).
    """

    structure: Structure
    values: dict[str, Value]
    bits: int
    exact: _Exact
    modes: tuple[tuple[tuple[arb, arb], ...], ...]
    flows: tuple[list[list[list[Any]]], ...]
    weights: tuple[list[list[list[Any]]], ...]

    def value(self, row: Row, facts: Facts, state: Sequence[arb]) -> Any:
        """An affine function of a state: exact if the facts give it, else a ball."""
        reduced = facts.reduce(row)
        return evaluate(reduced, state) if any(reduced[:-1]) else reduced[-1]

    def leading(
        self, row: Row, configuration: int, facts: Facts, state: Sequence[arb], order: int = 0
    ) -> tuple[int, int]:
        """Order and sign of the first nonzero derivative of a row along a field.

        Orders below `order` are passed over; sign 0 if all derivatives are zero.

        Raises
        ------
        Undecided
            If a ball contains zero.
        """
        field = self.exact.fields[configuration]
        for k in range(len(row) + 1):
            if k >= order:
                value = self.value(row, facts, state)
                if value > 0 or value < 0:
                    return k, 1 if value > 0 else -1
                certain = value == 0  # of balls, neither this nor its contrary need hold
                if not certain:
                    raise Undecided(f"its derivative of order {k} is {_shown(value)}")
            row = product(row, field)
        return 0, 0

    def advance(self, configuration: int, state: Sequence[arb], time: arb) -> list[arb]:
        """State after a time in one configuration."""
        functions = self.functions(configuration, time)
        found = []
        for i in range(len(state)):
            total = 0 * time
            for phi, matrix in zip(functions, self.flows[configuration], strict=True):
                total += phi * _affine(matrix[i], state)
            found.append(total)
        return found

    def functions(self, configuration: int, time: arb) -> list[Any]:
        """Functions t^k e^(st) cos(wt) and their sines, in the order of the places."""
        found: list[Any] = []
        for shape, (rate, frequency) in zip(
            self.structure.shapes[configuration], self.modes[configuration], strict=True
        ):
            parts: list[Any] = [1 + 0 * time]
            if shape.oscillates:
                sine, cosine = (frequency * time).sin_cos()
                parts = [cosine, sine]
            if not rate.is_zero():
                growth = (rate * time).exp()
                parts = [growth * part for part in parts]
            for _ in range(shape.length):
                found += parts
                parts = [time * part for part in parts]
        return found

    def derivative(self, configuration: int, coefficients: Sequence[Any]) -> list[Any]:
        """Coefficients of the derivative of a sum of the functions."""
        found = list(coefficients)
        for shape, (rate, frequency) in zip(
            self.structure.shapes[configuration], self.modes[configuration], strict=True
        ):
            step = 2 if shape.oscillates else 1
            for k in range(shape.length):
                at = shape.places[k * step]
                for part in range(step):
                    total = rate * coefficients[at + part]
                    if k + 1 < shape.length:
                        total += (k + 1) * coefficients[at + part + step]
                    if shape.oscillates:
                        turned = frequency * coefficients[at + 1 - part]
                        total = total - turned if part else total + turned
                    found[at + part] = total
        return found

    def along(
        self, configuration: int, boundary: int, state: Sequence[arb]
    ) -> tuple[Any, list[Any]]:
        """A boundary as a function of time: its constant, and coefficients of the functions."""
        row = self.exact.rows[self.structure.boundaries[configuration][boundary].row]
        weights = self.weights[configuration][boundary]
        return row[-1], [_affine(weight, state) for weight in weights]


def _affine(row: Sequence[Any], state: Sequence[arb]) -> Any:
    total = row[-1]
    for x, y in zip(row, state, strict=False):
        if x is not None:
            total = total + x * y
    return total


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


@lru_cache(maxsize=64)
def _enclosed(
    kernels: SystemKernels,
    named: tuple[tuple[str, Value], ...],
    exactly: tuple[Any, ...],
    bits: int,
) -> EnclosedSystem:
    from flint import arb

    exact = _exact(kernels, tuple(value for _, value in named), exactly)
    lib = Balls()
    with lib.working(bits):
        found = piecewise_in(kernels, dict(named), lib)
        structure = found.structure
        flows = tuple(
            [[_sparse(row) for row in matrix] for matrix in flow.tolist()] for flow in found.flows
        )
        weights = tuple(
            [
                [_sparse(_combined(exact.rows[b.row], matrix)) for matrix in flow.tolist()]
                for b in boundaries
            ]
            for flow, boundaries in zip(found.flows, structure.boundaries, strict=True)
        )
        modes = tuple(
            tuple((arb(rate), arb(frequency)) for rate, frequency in exponents)
            for exponents in found.exponents
        )
    return EnclosedSystem(structure, dict(named), bits, exact, modes, flows, weights)


def _combined(row: Row, matrix: list[list[Any]]) -> list[Any]:
    from flint import arb

    return [
        sum((arb(x) * line[j] for x, line in zip(row, matrix, strict=False) if x), arb(0))
        for j in range(len(matrix[0]))
    ]


def _sparse(row: Sequence[Any]) -> list[Any]:
    """Balls, with None for zeros among the gradient."""
    from flint import arb

    balls = [arb(entry) for entry in row]
    return [None if ball.is_zero() else ball for ball in balls[:-1]] + balls[-1:]


def enclosed_system(
    system: str | SystemKernels, parameters: Any
) -> Callable[[int], EnclosedSystem]:
    """A system at one parameter point, by bits of precision.

    Raises
    ------
    InputError
        As `piecewise_in`, and for a parameter that is not rational.
    """
    kernels = load_system(system) if isinstance(system, str) else system
    structure_of(kernels)
    values = system_parameters(kernels, parameters)
    for name, value in values.items():
        if value.exact is None:
            raise InputError(f"a proof needs rational parameters, and {name} = {value} is not")
    named = tuple(values.items())
    exactly = tuple(value.exact for value in values.values())
    return lambda bits: _enclosed(kernels, named, exactly, bits)
