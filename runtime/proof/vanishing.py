"""Affine functions that vanish along one orbit, as x1 - x2 along one that is symmetric.

Functions u of the state which the phases and resets of a cycle map linearly into each other
are u = Q u where the orbit begins. If 1 is no eigenvalue of Q they are zero there. Unlike the
invariants of a system they need not vanish along motions nearby.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from nonsmooth.runtime.proof.exact_closure import projected
from nonsmooth.runtime.proof.exact_tables import Matrix, Tables, rational_of
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["vanishing_along"]

_SMALL = 1e-8  # of a guess
_LARGEST_DENOMINATOR = 1000


def vanishing_along(
    tables: Tables,
    cycle: ItineraryShape,
    translations: Sequence[Row],
    start: Sequence[Any],
    dwell: Sequence[Any],
) -> tuple[Row, ...]:
    """Return functions that are proved to vanish where an orbit begins and to last; often none.

    They are exact rows (N + 1). `tables` are exact, and the cycle closes up to `translations`.
    `start` and `dwell` enclose the orbit.
    """
    from flint import arb_mat, fmpq

    field = tables.fields[cycle.configurations[0]]
    invariants = _guessed(tables, field, [float(x.mid()) for x in start], float(dwell[0].mid()))
    invariants = invariants.lasting(field)
    images = _returned(tables, cycle, translations, invariants, dwell)
    if not images:
        return ()
    size = range(len(images))
    missed = arb_mat([[int(i == j) - images[i][j] for j in size] for i in size]).det()
    rational = all(isinstance(x, fmpq) for row in invariants.rows for x in row)
    return invariants.rows if rational and (missed > 0 or missed < 0) else ()


def _guessed(tables: Tables, field: Matrix, start: Sequence[float], dwell: float) -> Invariants:
    """Return rational functions that are nearly zero at instants of the first phase."""
    from scipy.linalg import expm

    rates = np.array([[tables.near(x) for x in row] for row in field])
    size = len(rates)
    state = np.append(start, 1.0)[:size]
    states = np.array([expm(rates * t) @ state for t in np.linspace(0, dwell, 4 * size)])
    *_, sizes, turned = np.linalg.svd(states)
    left = turned[sizes < _SMALL * sizes[0]]
    found: list[np.ndarray] = []
    for column in range(size):
        if not len(left):
            break
        place = int(np.argmax(abs(left[:, column])))
        if abs(left[place, column]) > _SMALL:
            taken = left[place] / left[place, column]
            left = np.delete(left, place, axis=0)
            left = left - left[:, column, None] * taken
            found = [*(row - row[column] * taken for row in found), taken]
    near = [[Fraction(x).limit_denominator(_LARGEST_DENOMINATOR) for x in row] for row in found]
    return Invariants.of([[rational_of(x) for x in row] for row in near])


def _returned(
    tables: Tables,
    cycle: ItineraryShape,
    translations: Sequence[Row],
    invariants: Invariants,
    dwell: Sequence[Any],
) -> list[list[Any]] | None:
    """Return the matrix that carries the functions' values over one period of the orbit.

    None is returned where the functions behind the period are no combinations of themselves alone.
    """
    from flint import arb, arb_mat

    number = tables.number_at()
    first, count = invariants, len(invariants.rows)
    images = [[arb(int(i == j)) for j in range(count)] for i in range(count)]

    def combined(factors: Sequence[Sequence[Any]]) -> list[list[Any]]:
        return [
            [
                sum((number(x) * image[k] for x, image in zip(row, images, strict=True)),
                    arb(0))
                for k in range(count)
            ]
            for row in factors
        ]  # fmt: skip

    resets = [tables.resets[t.reset] for t in cycle.transitions]
    resets[-1] = projected(resets[-1], translations)
    for place, (configuration, reset) in enumerate(zip(cycle.configurations, resets, strict=True)):
        field, leaves = tables.fields[configuration], tables.rows[cycle.rows[place]]
        lasting = invariants.lasting(field)
        images = combined([_factors(row, invariants) for row in lasting.rows])
        if lasting.rows:
            rates = [_factors(product(row, field), lasting) for row in lasting.rows]
            flow = (arb_mat([list(map(number, row)) for row in rates]) * dwell[place]).exp()
            images = (flow * arb_mat(images)).tolist()
        invariants = Invariants.of([*lasting.rows, leaves]).reset(reset)
        images = combined(
            [_at_exit(product(row, reset), leaves, lasting) for row in invariants.rows]
        )
    if any(any(invariants.reduce(row)) for row in first.rows):
        return None
    return combined([_factors(row, invariants) for row in first.rows])


def _factors(row: Row, invariants: Invariants) -> list[Any]:
    """Return the factors of a row that is a combination of invariants."""
    return [row[pivot] for pivot in invariants.pivots]


def _at_exit(row: Row, leaves: Row, lasting: Invariants) -> list[Any]:
    """Return the factors where a row is a combination of invariants and a function that is zero."""
    rest, zero = lasting.reduce(row), lasting.reduce(leaves)
    for x, y in zip(rest, zero, strict=True):
        if y:
            row = tuple(a - x / y * b for a, b in zip(row, leaves, strict=True))
            break
    return _factors(row, lasting)
