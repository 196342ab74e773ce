"""Phases that begin and end on one boundary, as the contact with a soft stop, and may vanish.

Where the dwell time t of such a phase is zero its switching condition holds for any speed: the
orbit's equations are singular there, and have another branch, of t = 0. Divided by t they are
regular. The saltation matrix at its ends is regular too, if the velocity jumps by a multiple of
the boundary function's rate: the map is differentiable there. Grazings without a jump are in
M. di Bernardo, C. Budd, A. Champneys and P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.exact_tables import Matrix
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.proof.orbit_equations import ShortPhase

__all__ = ["divided_regions"]


def divided_regions(region: Region) -> dict[int, Region]:
    """The same orbit by equations in which one phase's condition is divided by its dwell time.

    Parameters
    ----------
    region : Region

    Returns
    -------
    dict of int to Region
        By the place of the phase, counted from 0; empty where no phase allows it.
    """
    if not region.tables.exact or not region.closing.timed or region.closing.translations:
        return {}
    columns = tuple(_saltations(region))
    return {place: replace(region, short=ShortPhase(place, columns)) for place in _places(region)}


def _places(region: Region) -> Iterator[int]:
    """Phases that begin where the boundary function is zero that ends them."""
    cycle, tables = region.cycle, region.tables
    rows = [tables.rows[row] for row in cycle.rows]
    resets = [tables.resets[taken.reset] for taken in cycle.transitions]
    for place in range(len(rows) if len(rows) > 1 else 0):
        before = product(rows[place], resets[place - 1])
        if not any(Invariants.of([rows[place - 1]]).reduce(before)):
            yield place


def _saltations(region: Region) -> Iterator[Row | None]:
    """For each phase the jump of the velocity over the rate of the boundary function."""
    cycle, tables = region.cycle, region.tables
    fields = [tables.fields[configuration] for configuration in cycle.configurations]
    for place, (row, taken) in enumerate(zip(cycle.rows, cycle.transitions, strict=True)):
        behind = fields[(place + 1) % len(fields)]
        yield _multiple(tables.rows[row], fields[place], behind, tables.resets[taken.reset])


def _multiple(row: Row, before: Matrix, behind: Matrix, reset: Matrix) -> Row | None:
    """The column c with F+ R - R F- = c (n F-) where n y = 0; None where there is none."""
    reached = Invariants.of([row])
    rate = reached.reduce(product(row, before))
    pivot = next((k for k, entry in enumerate(rate) if entry), None)
    if pivot is None:
        return None
    column: list[Any] = []
    for jumps in _differences(behind, reset, before):
        left = reached.reduce(jumps)
        share = left[pivot] / rate[pivot]
        if any(x - share * y for x, y in zip(left, rate, strict=True)):
            return None
        column.append(share)
    return tuple(column)


def _differences(behind: Matrix, reset: Matrix, before: Matrix) -> Iterator[Row]:
    """Rows of F+ R - R F-."""
    for ahead, own in zip(behind, reset, strict=True):
        first: Sequence[Any] = product(ahead, reset)
        second: Sequence[Any] = product(own, before)
        yield tuple(x - y for x, y in zip(first, second, strict=True))
