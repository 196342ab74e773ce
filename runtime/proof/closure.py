"""How a cycle closes, which makes its equations square and nonsingular.

An autonomous dissipative cycle closes by its state. Of a conservative one the period is
given, and one coordinate's closure is dropped: it follows from the energy. A forced one is a
function of time: the forcing's states are cos(w t) and sin(w t) at an unknown time, and a
whole number of the forcing's periods passes.

Where nothing depends on some direction, a rotor's angle, a cycle closes up to a shift along it:
behind the last reset the state is projected onto those that are zero in one coordinate.

A conservative cycle is proved to be one by exact arithmetic: there is a nondegenerate
skew form Omega and an energy E_c of each configuration with Omega f_c = grad E_c, each
transition keeps the energy on its boundary and Omega on the tangents of its boundary. Hence
the monodromy matrix is symplectic: the saltation maps the field in front to that behind.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.proof.exact_tables import Matrix, Tables, rational_of
from nonsmooth.runtime.proof.motion.exact_rows import Row, left_kernel, product
from nonsmooth.runtime.shooting.shooting_map import Cycle
from nonsmooth.runtime.shooting.translations import deciding_rows, gauges_of, taken_resets

__all__ = [
    "Closing",
    "SymplecticForm",
    "exact_translations",
    "forcing_speeds",
    "projected",
    "symplectic_form",
]


_LARGEST_DENOMINATOR = 10**6  # of a direction


@dataclass(frozen=True, eq=False)
class SymplecticForm:
    """Omega (N, N) and the energies: E_c = (y, 1) H_c (y, 1) / 2, of the visited configurations."""

    omega: Matrix
    constants: dict[int, Any]
    energies: dict[int, Matrix]


@dataclass(frozen=True)
class Closing:
    """How a cycle closes.

    Attributes
    ----------
    kind : {"state", "period", "forcing"}
    period : Value, fmpq, RationalFunction or None
        What the dwell times sum up to, for "period": over a box of parameters exactly.
    dropped : int
        The coordinate whose closure follows from the energy; -1 for none.
    form : SymplecticForm or None
    speeds : tuple of fmpq or RationalFunction
        Angular frequencies of the forcings.
    turns : int
        How often the first forcing turns in one period.
    pairs : tuple of (int, int)
        States of the forcings.
    translations : tuple of Row
        Directions along which nothing changes, in echelon form; the cycle closes up to these.
    vanishing : tuple of Row
        Functions that are zero where the orbit begins, because it closes.
    """

    kind: str
    period: Any = None
    dropped: int = -1
    form: SymplecticForm | None = None
    speeds: tuple[Any, ...] = ()
    turns: int = 0
    pairs: tuple[tuple[int, int], ...] = field(default=())
    translations: tuple[Row, ...] = ()
    vanishing: tuple[Row, ...] = ()

    @property
    def timed(self) -> bool:
        """Whether the orbit is a function of time: the map is that at fixed times."""
        return self.kind == "forcing"

    @property
    def forced(self) -> tuple[int, ...]:
        """The states of all forcings."""
        return tuple(state for pair in self.pairs for state in pair)

    @property
    def stability(self) -> str:
        """What is claimed of the multipliers: "stable", or "neutral" of a conservative one."""
        return "stable" if self.form is None else "neutral"


def exact_translations(
    tables: Tables, structure: Structure, near: Sequence[Sequence[float]]
) -> tuple[Row, ...]:
    """Directions along which a system does not change, exactly: none, unless all of them are.

    Parameters
    ----------
    near : sequence of sequences of float
        What `translations_of` gives in double precision.
    """
    if not len(near) or not tables.exact:
        return ()
    fractions = [[Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in d] for d in near]
    found = tuple(tuple(map(rational_of, direction)) for direction in fractions)
    rows = [row[:-1] for field in tables.fields for row in field[:-1]]
    rows += [tables.rows[k][:-1] for k in deciding_rows(structure)]
    for k in taken_resets(structure):
        for i, row in enumerate(tables.resets[k][:-1]):
            rows.append(tuple(x - int(i == j) for j, x in enumerate(row[:-1])))
    columns = _transposed(found)
    return () if any(any(product(row, columns)) for row in rows) else found


def projected(reset: Matrix, translations: Sequence[Row]) -> Matrix:
    """A reset, and then the projection along translations: their first coordinates are zero."""
    found: list[list[Any]] = [list(row) for row in reset]
    for direction, gauge in zip(translations, gauges_of(translations), strict=True):
        first = found[gauge]
        along: list[Any] = [*direction, 0]
        found = [
            [x - d * y if d and y else x for x, y in zip(row, first, strict=True)]
            for row, d in zip(found, along, strict=True)
        ]
    return tuple(map(tuple, found))


def forcing_speeds(tables: Tables, cycle: Cycle) -> tuple[Any, ...] | str:
    """Frequencies of the forcings, exactly the same in every phase; or why there are none."""
    found: list[Any] = []
    for cosine, sine in cycle.structure.forcing:
        speed = tables.fields[cycle.configurations[0]][sine][cosine]
        for configuration in cycle.configurations:
            rows = tables.fields[configuration]
            for state, other, rate in ((cosine, sine, -speed), (sine, cosine, speed)):
                wanted = [rate if k == other else 0 for k in range(len(rows))]
                if list(rows[state]) != wanted:
                    return "a forcing does not turn evenly"
        for transition in cycle.transitions:
            reset = tables.resets[transition.reset]
            for state in (cosine, sine):
                if list(reset[state]) != [int(k == state) for k in range(len(reset))]:
                    return "a transition resets a forcing"
        found.append(speed)
    return tuple(found)


def symplectic_form(tables: Tables, cycle: Cycle) -> SymplecticForm | None:
    """A nondegenerate form and energies that the cycle keeps exactly, if there are such."""
    from flint import fmpq

    size = len(tables.fields[0]) - 1
    visited = sorted(set(cycle.configurations))
    pairs = [(i, j) for i in range(size) for j in range(i)]
    count = len(pairs) + len(visited)
    columns = []
    for place in range(count):
        values = [fmpq(int(k == place)) for k in range(count)]
        columns.append(_missed(tables, cycle, _form(tables, visited, pairs, values)))
    kernel = left_kernel(columns)
    values = [
        sum((fmpq(k + 1) * row[j] for k, row in enumerate(kernel)), fmpq(0)) for j in range(count)
    ]
    form = _form(tables, visited, pairs, values)
    return None if left_kernel(form.omega) else form


def _form(
    tables: Tables, visited: Sequence[int], pairs: Sequence[tuple[int, int]], values: Sequence[Any]
) -> SymplecticForm:
    """The form of given entries, and half of each energy's matrix: the lower rows follow."""
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


def _missed(tables: Tables, cycle: Cycle, form: SymplecticForm) -> list[Any]:
    """What a form misses of being kept: linear in its entries."""
    missed: list[Any] = []
    for energy in form.energies.values():
        missed += _difference(energy, _transposed(energy))
    count = len(cycle)
    for place, transition in enumerate(cycle.transitions):
        before = cycle.configurations[place]
        after = cycle.configurations[(place + 1) % count]
        row = tables.rows[cycle.rows[place]]
        reset = tables.resets[transition.reset]
        on = left_kernel([[entry] for entry in row])
        missed += _difference(
            _seen(_seen(form.energies[after], _transposed(reset)), on),
            _seen(form.energies[before], on),
        )
        linear = tuple(r[:-1] for r in reset[:-1])
        along = left_kernel([[entry] for entry in row[:-1]])
        missed += _difference(
            _seen(_seen(form.omega, _transposed(linear)), along), _seen(form.omega, along)
        )
    return missed


def _seen(form: Sequence[Row], rows: Sequence[Row]) -> Matrix:
    """A bilinear form between vectors that are given as rows."""
    return _times(_times(rows, form), _transposed(rows))


def _times(left: Sequence[Row], right: Sequence[Row]) -> Matrix:
    return tuple(product(row, right) for row in left)


def _transposed(rows: Sequence[Row]) -> Matrix:
    return tuple(zip(*rows, strict=True))


def _difference(left: Sequence[Row], right: Sequence[Row]) -> list[Any]:
    return [x - y for a, b in zip(left, right, strict=True) for x, y in zip(a, b, strict=True)]
