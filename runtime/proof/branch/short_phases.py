"""Phases that may vanish: contacts with a soft stop, and times for which a contact sticks.

A contact with a soft stop begins and ends on one boundary.
Where the dwell time t of such a phase is zero its switching condition holds for any speed: the
orbit's equations are singular there, and have another branch, of t = 0. Divided by t they are
regular. The saltation matrix at its ends is regular too, if the velocity jumps by a multiple of
the boundary function's rate: the map is differentiable there.

Where sticking begins at a speed that may be zero the equations are regular by the dwell time as
they are, and the velocity jumps by a multiple of the speed too. At that one end the derivative is
taken at a fixed time; the section behind the short phase removes what differs, along the flow.

Grazings without a jump are in M. di Bernardo, C. Budd, A. Champneys and P. Kowalczyk,
Piecewise-smooth Dynamical Systems (2008).
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
    """The same orbit by equations that are regular where one of its phases vanishes.

    They are given by the number of that phase, from 0; empty where no phase allows it.
    """
    closing = region.closing
    if not region.tables.exact or closing.translations:
        return {}
    columns = tuple(_saltations(region))
    if closing.timed:
        short = {place: ShortPhase(place, columns, divided=True) for place in _places(region)}
    else:
        short = dict(_sticking(region, columns) if closing.kind == "state" else ())
    return {place: replace(region, short=found) for place, found in short.items()}


def _sticking(region: Region, columns: Sequence[Row | None]) -> Iterator[tuple[int, ShortPhase]]:
    """Phases in which all relations known at their start persist, behind a jump with a column."""
    known = region.invariants
    if known is None or len(columns) < 2:
        return
    for place in range(len(columns)):
        before = (place - 1) % len(columns)
        lasts = known.starts[place].rows == known.lasting[place].rows
        if lasts and known.starts[place].rows and columns[before] is not None:
            alone = tuple(c if k == before else None for k, c in enumerate(columns))
            yield place, ShortPhase(place, alone, divided=False)


def _places(region: Region) -> Iterator[int]:
    """Phases that begin where the boundary function that ends them is zero."""
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
