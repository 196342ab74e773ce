"""Modes of a configuration computed numerically, where its flow has no closed form.

With Y = (y, 1) the motion y' = A y + b is Y' = B Y, and

    exp(B t) = sum_c e^(mu_c t) sum_k t^k/k! (B - mu_c)^k P_c,

a sum over clusters of eigenvalues with centres mu_c and spectral projectors P_c. Inside a
cluster the powers end at its size, or a little later where its eigenvalues differ.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from scipy.linalg import schur, solve_sylvester

from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.run import LONGEST_WAIT

__all__ = ["Modes", "numeric_modes"]

# length, whether it oscillates, exponent, and matrices (functions, N, N + 1)
Modes = list[tuple[int, bool, complex, np.ndarray]]

_APART = 1e-5  # eigenvalues nearer than this, relative to the largest, are one cluster
_EPSILON = float(np.finfo(float).eps)
_LONGEST_CHAIN = 24


def numeric_modes(field: np.ndarray) -> Modes:
    """Modes of y' = A y + b; the first is that of the exponent 0 and has the constants.

    Parameters
    ----------
    field : array (N, N + 1)
        A, then b.

    Raises
    ------
    InputError
        For a field that is not finite, or a cluster whose powers do not end: eigenvalues that
        are neither equal nor apart.
    """
    if not np.isfinite(field).all():
        raise InputError("a vector field is not finite")
    size = field.shape[0]
    whole = np.vstack([field, np.zeros(size + 1)])
    scale = max(float(np.abs(np.linalg.eigvals(whole)).max()), 1e-300)
    found: Modes = []
    for centre, cluster, projector in _clusters(whole, scale):
        if centre.imag < 0:
            continue  # the conjugate of one that is there
        oscillates = centre.imag > 0
        spread = max((abs(value - centre) for value in cluster), default=0.0)
        matrices: list[np.ndarray] = []
        power, factor = projector, 1.0
        for k in range(_LONGEST_CHAIN):
            part = power[:size] * factor
            matrices += [2 * part.real, -2 * part.imag] if oscillates else [part.real]
            power = (whole - centre * np.eye(size + 1)) @ power
            factor /= k + 1
            # the rest over the longest wait, where there is a spread at all
            reach = spread * LONGEST_WAIT / scale
            if k + 1 >= len(cluster) and reach ** (k + 1) / math.factorial(k + 1) < _EPSILON:
                break
        else:
            raise InputError(
                f"eigenvalues near {centre:.6g} are neither equal nor apart (by {spread:.1e})"
            )
        length = len(matrices) // (2 if oscillates else 1)
        found.append((length, oscillates, centre, np.array(matrices)))
    found.sort(key=lambda mode: (mode[2] != 0, mode[2].imag, mode[2].real))
    return found


def _clusters(
    matrix: np.ndarray, scale: float
) -> Iterator[tuple[complex, list[complex], np.ndarray]]:
    """Centre, eigenvalues and spectral projector of each cluster of eigenvalues."""
    values = [complex(v) for v in np.linalg.eigvals(matrix)]
    groups: list[list[complex]] = []
    for value in values:
        near = [g for g in groups if any(abs(value - other) <= _APART * scale for other in g)]
        for group in near:
            groups.remove(group)
        groups.append([value, *(v for group in near for v in group)])
    for group in groups:
        centre = sum(group) / len(group)
        if abs(centre) <= _APART * scale:
            centre = 0j  # one of them is: that of the constants
        if abs(centre.imag) <= _APART * scale:
            centre = complex(centre.real)
        if abs(centre.real) <= 8 * len(values) * _EPSILON * scale:
            centre = complex(0.0, centre.imag)
        yield centre, group, _projector(matrix, group, scale)


def _projector(matrix: np.ndarray, group: list[complex], scale: float) -> np.ndarray:
    """Projector onto the invariant subspace of some eigenvalues along that of the others."""
    size, count = len(matrix), len(group)
    if count == size:
        return np.eye(size, dtype=complex)

    def belongs(value: complex) -> bool:
        return min(abs(value - other) for other in group) <= _APART * scale

    triangle, basis, chosen = schur(matrix.astype(complex), output="complex", sort=belongs)
    if chosen != count:
        raise InputError(f"eigenvalues near {group[0]:.6g} cannot be told from the others")
    first, coupling, rest = (
        triangle[:count, :count],
        triangle[:count, count:],
        triangle[count:, count:],
    )
    solution = solve_sylvester(first, -rest, -coupling)
    inner = np.zeros((size, size), dtype=complex)
    inner[:count, :count] = np.eye(count)
    inner[:count, count:] = -solution
    return np.asarray(basis @ inner @ basis.conj().T)
