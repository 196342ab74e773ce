"""Translations that leave a system as it is: directions of the state that nothing depends on.

A rotor's angle, or the positions of all bodies of a free chain together, enter neither a field
nor a boundary, and every reset carries them along. An orbit then need not come back: it is
periodic where it does so up to a shift. The closure is taken behind a projection along these
directions, onto the states that are zero in one coordinate of each; the multipliers 1 that the
translations give are zeros of the projected map.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.core.rational_functions import pivot
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure

_SAME = 1e-12  # of the largest entry of a row: numbers that are zero but for rounding
_APART = 1e-9  # relative singular value above which rows annihilate no vector


def translations_of(system: PiecewiseLinear) -> np.ndarray:
    """Directions (m, N) along which a system does not change, in its arithmetic.

    See `directions_of`.
    """
    return directions_of(system.structure, system.fields, system.rows, system.resets)


def directions_of(structure: Structure, fields: Any, rows: Any, resets: Any) -> np.ndarray:
    """Directions (m, N) along which a system's numbers do not change, in reduced echelon form.

    Fields, boundaries, constraints and conditions do not change along them, and resets carry
    them along: y + s d is a motion if y is. Most systems have none, m = 0. Fields are
    (c, N, N + 1), rows (R, N + 1) and resets (r, N, N + 1).
    """
    used, taken = deciding_rows(structure), taken_resets(structure)
    size = len(structure.states)
    unit = np.eye(size, dtype=int)
    parts = [
        fields[..., :size].reshape(-1, size),
        rows[[*used], :size],
        (resets[[*taken]][..., :size] - unit).reshape(-1, size),
    ]
    return _null_space(np.concatenate(parts))


@lru_cache(maxsize=1024)
def deciding_rows(structure: Structure) -> tuple[int, ...]:
    """Rows that decide about motions, increasing.

    They are those of boundaries, constraints, conditions and a contact law.
    """
    used = {*structure.watched}
    every = (t for each in structure.transitions for t in each)
    used |= {row for t in every for row, _, _ in t.conditions}
    if structure.law is not None:
        used |= {row for contact in structure.law.contacts for row in contact.rows}
        used |= {row for rows in structure.law.free.values() for row in rows}
    return tuple(sorted(used))


@lru_cache(maxsize=1024)
def taken_resets(structure: Structure) -> tuple[int, ...]:
    """Resets of all transitions and of a contact law, increasing."""
    found = {t.reset for each in structure.transitions for t in each}
    if structure.law is not None:
        found |= {reset for resets in structure.law.resets.values() for reset in resets.values()}
    return tuple(sorted(found))


def projection_along(directions: np.ndarray) -> np.ndarray:
    """Matrix (N, N) that moves a state along directions to where their first coordinates are zero.

    The directions (m, N) are in reduced echelon form.
    """
    found = np.eye(directions.shape[1], dtype=directions.dtype)
    for direction, place in zip(directions, gauges_of(directions), strict=True):
        found[:, place] -= direction
    return found


def up_to_shift(states: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """States (..., N), each moved along directions to where their first coordinates are zero.

    The directions (m, N) are in reduced echelon form.
    """
    return states @ projection_along(directions).T if len(directions) else states


def gauges_of(directions: Sequence[Any] | np.ndarray) -> list[int]:
    """First coordinate of each direction (m, N): it is one there, and zero in the others."""
    return [pivot(direction) for direction in directions]


def _null_space(rows: np.ndarray) -> np.ndarray:
    """Vectors that all rows annihilate, in reduced echelon form, by Gauss-Jordan elimination.

    There are none where a row is not finite.
    """
    largest = abs(rows).max(axis=1)
    if not np.isfinite(largest.astype(float)).all():
        return rows[:0]
    left = rows[largest > 0] / largest[largest > 0, None]
    width = rows.shape[1]
    values = np.linalg.svd(_floats(left), compute_uv=False)
    if len(values) == width and values[-1] > _APART * values[0]:
        return rows[:0]
    pivots: list[int] = []
    for column in reversed(range(width)):
        count = len(pivots)
        sizes = abs(left[count:, column])
        best = count + int(np.argmax(sizes)) if len(sizes) else 0
        if not (len(sizes) and abs(left[best, column]) > _SAME):
            continue
        left[[count, best]] = left[[best, count]]
        left[count] = left[count] / left[count, column]
        for part in (slice(0, count), slice(count + 1, None)):
            left[part] = left[part] - left[part, column, None] * left[count]
        pivots.append(column)
    free = [k for k in range(width) if k not in pivots]
    found = np.zeros((len(free), width), dtype=left.dtype)
    for place, k in enumerate(free):
        found[place, k] = 1
        entries = left[: len(pivots), k]
        found[place, pivots] = np.where(abs(entries) > _SAME, -entries, 0 * entries)
    return found


def _floats(rows: np.ndarray) -> np.ndarray:
    return real_parts(rows).astype(float)
