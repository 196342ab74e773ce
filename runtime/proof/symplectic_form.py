"""The form and the energies that a conservative cycle keeps, by exact arithmetic.

There is a nondegenerate skew form Omega and an energy E_c of each configuration with
Omega f_c = grad E_c, each transition keeps the energy on its boundary and Omega on the tangents
of its boundary. Hence the monodromy matrix is symplectic: the saltation maps the field in front
to that behind.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from nonsmooth.runtime.checker.stated.exact import Elimination, product
from nonsmooth.runtime.proof.exact_tables import Matrix, Row, Tables
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["SymplecticForm", "symplectic_form"]


@dataclass(frozen=True, eq=False)
class SymplecticForm:
    """A skew form Omega (N, N) and the energies E_c = (y, 1) H_c (y, 1) / 2 of configurations."""

    omega: Matrix
    constants: dict[int, Any]  # last diagonal entry of H_c, by visited configuration
    energies: dict[int, Matrix]  # H_c, by configuration


def symplectic_form(tables: Tables, cycle: ItineraryShape) -> SymplecticForm | None:
    """Return a nondegenerate form and energies that a cycle keeps exactly, or None."""
    from flint import fmpq

    size = len(tables.fields[0]) - 1
    visited = sorted(set(cycle.configurations))
    pairs = [(i, j) for i in range(size) for j in range(i)]
    count = len(pairs) + len(visited)
    columns = []
    for place in range(count):
        values = [fmpq(int(k == place)) for k in range(count)]
        columns.append(_missed(tables, cycle, _form(tables, visited, pairs, values)))
    kernel = Elimination().left_kernel(columns)
    values = [
        sum((fmpq(k + 1) * row[j] for k, row in enumerate(kernel)), fmpq(0)) for j in range(count)
    ]
    form = _form(tables, visited, pairs, values)
    return None if Elimination().left_kernel(form.omega) else form


def _form(
    tables: Tables, visited: Sequence[int], pairs: Sequence[tuple[int, int]], values: Sequence[Any]
) -> SymplecticForm:
    """Return the form of given entries, with the matrices of the energies that follow from it."""
    from flint import fmpq

    size = len(tables.fields[0]) - 1
    entries: list[list[Any]] = [[fmpq(0)] * size for _ in range(size)]
    for (i, j), value in zip(pairs, values, strict=False):
        entries[i][j], entries[j][i] = value, -value
    omega: Matrix = tuple(map(tuple, entries))
    constants = dict(zip(visited, values[len(pairs) :], strict=True))
    energies: dict[int, Matrix] = {}
    for configuration in visited:
        upper = _times(omega, tables.fields[configuration][:-1])
        below = (*(row[-1] for row in upper), constants[configuration])
        energies[configuration] = (*upper, below)
    return SymplecticForm(omega, constants, energies)


def _missed(tables: Tables, cycle: ItineraryShape, form: SymplecticForm) -> list[Any]:
    """Return what a form misses of being kept, linear in its entries: zero if it is kept."""
    missed: list[Any] = []
    for energy in form.energies.values():
        missed += _difference(energy, _transposed(energy))
    count = len(cycle)
    for place, transition in enumerate(cycle.transitions):
        before = cycle.configurations[place]
        after = cycle.configurations[(place + 1) % count]
        row = tables.rows[cycle.rows[place]]
        reset = tables.resets[transition.reset]
        on = Elimination().left_kernel([[entry] for entry in row])
        missed += _difference(
            _seen(_seen(form.energies[after], _transposed(reset)), on),
            _seen(form.energies[before], on),
        )
        linear = tuple(r[:-1] for r in reset[:-1])
        along = Elimination().left_kernel([[entry] for entry in row[:-1]])
        missed += _difference(
            _seen(_seen(form.omega, _transposed(linear)), along), _seen(form.omega, along)
        )
    return missed


def _seen(form: Sequence[Row], rows: Sequence[Row]) -> Matrix:
    """Return the matrix of a bilinear form between vectors that are given as rows."""
    return _times(_times(rows, form), _transposed(rows))


def _times(left: Sequence[Row], right: Sequence[Row]) -> Matrix:
    return tuple(product(row, right) for row in left)


def _transposed(rows: Sequence[Row]) -> Matrix:
    return tuple(zip(*rows, strict=True))


def _difference(left: Sequence[Row], right: Sequence[Row]) -> list[Any]:
    return [x - y for a, b in zip(left, right, strict=True) for x, y in zip(a, b, strict=True)]
