"""Modes of configurations with many states: eigenvectors as factors, clusters apart.

A simple eigenvalue, or a pair of them, keeps its eigenvectors. Eigenvalues that are equal, or
nearly, have a basis of their invariant subspace instead, by inverse iteration on a block of
vectors; the matrices of their powers are the only ones that are made. So memory goes with the
square of the number of states, and time with its cube.

That the modes add up to the motion is seen from their sum and its derivative at the start.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.eigenvalue_clusters import (
    cluster_terms,
    groupings,
    is_real,
    leads,
    real_parts_of,
    snapped,
)
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.simple_modes import NumericModes
from nonsmooth.runtime.model.structure import mode_shapes

__all__ = ["LARGE", "large_modes"]

LARGE = 20  # states from which on factors are faster than matrices
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-4)  # of the largest modulus: what is taken together
_ASIDE = 0.1  # shift of an inverse iteration, in units of the distance to what is not meant
_ITERATIONS = 20
_NORM, _LARGEST = 2.0, 1e5  # of a projector: by states; and at most
_CLOSE = 1e-11  # error of the sum and of its derivative over a radian, relative to these
_EPSILON = float(np.finfo(float).eps)


class _Subspace(NamedTuple):
    """A group of eigenvalues, with a basis of their invariant subspace."""

    values: list[complex]
    basis: np.ndarray  # (N + 1, m)


class _ModeParts(NamedTuple):
    """The powers of time with one exponent: as columns and rows of factors, or as matrices."""

    centre: complex
    left: np.ndarray  # (k, N)
    right: np.ndarray  # (k, N + 1)
    matrices: list[np.ndarray]


def large_modes(matrix: np.ndarray, units: np.ndarray, depends: np.ndarray) -> NumericModes | None:
    """Modes in which all simple eigenvalues have factors, for a matrix with few multiple ones.

    `matrix` (N + 1, N + 1) is the field above a row of zeros, in the units (N + 1,) of its
    coordinates, powers of two; `depends` is its `dependence`. The result is None if the modes do
    not add up to the motion.
    """
    values, vectors = np.linalg.eig(matrix)
    scale = float(np.abs(values).max())
    if not 0 < scale < math.inf:
        return None
    tiny = 8 * len(matrix) * _EPSILON * scale
    snug = [complex(v) if abs(v) > tiny else 0j for v in values.tolist()]
    # modes that nearly cancel each other are taken only where no grouping leaves none of them
    for norm in (_NORM * len(matrix), _LARGEST):
        for groups in groupings(snug, _NEARNESS, scale):
            try:
                bases = [
                    _Subspace(group, _basis(matrix, snug, vectors, group))
                    for group in groups
                    if leads(group)
                ]
                modes = _modes_of(matrix, units, depends, bases, scale, norm)
            except np.linalg.LinAlgError:  # vectors that do not span the space
                continue
            if modes is not None:
                return _record(modes, len(matrix) - 1)
    return None


def _basis(
    matrix: np.ndarray, values: list[complex], vectors: np.ndarray, group: list[complex]
) -> np.ndarray:
    """The eigenvector of one eigenvalue, or an orthonormal basis for several."""
    if len(group) == 1:
        return vectors[:, [values.index(group[0])]]
    middle = sum(group) / len(group)
    outside = min((abs(v - middle) for v in values if v not in group), default=1.0)
    is_real = abs(middle.imag) <= _EPSILON * abs(middle)
    aside = middle + _ASIDE * outside * (1 if is_real else 1j)
    shifted = matrix - (aside.real if is_real else aside) * np.eye(len(matrix))
    inverse = np.linalg.inv(shifted)
    basis = np.random.default_rng(0).normal(size=(len(matrix), len(group)))
    for _ in range(_ITERATIONS):
        basis = np.linalg.qr(inverse @ basis)[0]
    return basis


def _modes_of(
    matrix: np.ndarray,
    units: np.ndarray,
    depends: np.ndarray,
    groups: Sequence[_Subspace],
    scale: float,
    norm: float,
) -> list[_ModeParts] | None:
    """Modes of all groups; None if a projector's norm is too large or they miss the motion."""
    size = len(matrix)
    parts = [
        part
        for values, basis in groups
        for part in ((basis,) if is_real(values) else (basis, basis.conj()))
    ]
    right = np.hstack(parts)
    if right.shape[1] != size:
        return None
    left = np.linalg.inv(right)
    left = left @ (2 * np.eye(size) - right @ left)
    moved = left @ matrix @ right
    modes, place, blocks = [], 0, np.zeros((size, size), dtype=complex)
    largest = _NORM * size
    for values, basis in groups:
        count, twice = basis.shape[1], 1 if is_real(values) else 2
        for first in range(place, place + twice * count, count):
            inside = slice(first, first + count), slice(first, first + count)
            blocks[inside] = moved[inside]
        here = slice(place, place + count)
        rows, block = left[here], blocks[here, here]
        place += twice * count
        centre = complex(np.trace(block)) / count if min(map(abs, values)) else 0j
        centre = snapped(complex(centre.real) if twice == 1 else centre, size, scale)
        largest = max(largest, float(np.linalg.norm(rows, 2) * np.linalg.norm(basis, 2)))
        if count == 1:
            modes.append(_factors(centre, basis[:, 0], rows[0], units, depends))
            continue
        error = 64 * _EPSILON * float(np.linalg.norm(matrix, 2))
        terms = cluster_terms(block, basis, rows, centre, error, LONGEST_WAIT / scale)
        if terms is None:
            return None
        modes.append(_powers(centre, terms, units, depends))
    sums = right @ left - np.eye(size), (right @ blocks @ left - matrix) / scale
    missed, own = (
        max(float(np.abs(units[:, None] * part / units).max()) for part in parts)
        for parts in (sums, (np.eye(size), matrix / scale))
    )
    balanced = max(float(np.abs(part).max()) for part in sums)
    lost = largest / (_NORM * size)  # digits that a large projector costs
    sound = largest <= norm and missed <= _CLOSE * own and balanced <= _CLOSE * lost
    return modes if sound else None


def _factors(
    centre: complex, column: np.ndarray, row: np.ndarray, units: np.ndarray, depends: np.ndarray
) -> _ModeParts:
    """Factors of a simple mode, exactly zero in states that its mode does not concern."""
    column, row, own = units * column, row / units, int(np.abs(column * row).argmax())
    column, row = np.where(depends[:, own], column, 0)[:-1], np.where(depends[own], row, 0)
    if not centre.imag:
        return _ModeParts(centre, column.real[None], row.real[None], [])
    left, right = np.stack([2 * column.real, -2 * column.imag]), np.stack([row.real, row.imag])
    return _ModeParts(centre, left, right, [])


def _powers(
    centre: complex, terms: list[np.ndarray], units: np.ndarray, depends: np.ndarray
) -> _ModeParts:
    """Matrices of the powers of time of a group of eigenvalues."""
    size = len(units) - 1
    found = real_parts_of(
        [units[:, None] * term / units for term in terms], oscillates=centre.imag != 0
    )
    matrices = [np.where(depends, array, 0.0)[:size] for array in found]
    return _ModeParts(centre, np.empty((0, size)), np.empty((0, size + 1)), matrices)


def _record(modes: list[_ModeParts], size: int) -> NumericModes:
    modes = sorted(modes, key=lambda m: (m.centre != 0, m.centre.imag, m.centre.real))
    parts = []
    for mode in modes:
        oscillates, factored = mode.centre.imag > 0, not mode.matrices
        length = len(mode.matrices) // (2 if oscillates else 1) or 1
        parts.append((length, oscillates, False, False, factored))
    shapes = mode_shapes(parts)
    matrices = [matrix for mode in modes for matrix in mode.matrices]
    exponents = np.array([(mode.centre.real, mode.centre.imag) for mode in modes])
    flows = FactoredFlows(
        shapes,
        np.array(matrices).reshape(-1, size, size + 1),
        np.vstack([mode.left for mode in modes]),
        np.vstack([mode.right for mode in modes]),
    )
    return NumericModes(shapes, exponents, flows)
