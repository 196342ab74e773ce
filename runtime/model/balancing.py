"""Which states depend on which, and units in which a matrix's rows and columns are of like size."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

__all__ = ["balanced", "dependence"]

_SWEEPS = 40


def balanced(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Balance matrices (n, m, m): the scaled matrices and the units (n, m) of their coordinates.

    The units are powers of two, ``scaled = matrices * units[:, None] / units[:, :, None]``, and
    make rows and columns similar in size (Parlett and Reinsch, 1969), for all matrices at once.
    """
    scaled, units = matrices.copy(), np.ones(matrices.shape[:2])
    for _ in range(_SWEEPS):
        sizes = np.abs(scaled)
        if (_factors(sizes.max(axis=1), sizes.max(axis=2)) == 1).all():
            break
        for i in range(matrices.shape[-1]):
            column, row = np.abs(scaled[:, :, i]).max(axis=1), np.abs(scaled[:, i]).max(axis=1)
            factor = _factors(column, row)
            if (factor != 1).any():
                units[:, i] *= factor
                scaled[:, i] /= factor[:, None]
                scaled[:, :, i] *= factor[:, None]
    return scaled, units


def _factors(columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Powers of two by which a unit grows, from the largest entries of its columns and rows."""
    told = (columns > 0) & (rows > 0) & np.isfinite(columns) & np.isfinite(rows)
    # a factor f turns them into f column and row / f: of like size for f^2 = row / column
    exponents = np.frexp(np.where(told, rows / np.where(told, columns, 1.0), 1.0))[1]
    factors = np.where(told, np.ldexp(1.0, exponents // 2), 1.0)
    better = factors * columns + rows / factors < 0.95 * (columns + rows)
    return np.asarray(np.where(better, factors, 1.0))


def dependence(matrices: np.ndarray) -> np.ndarray:
    """A bool (n, m, m) for each entry: whether polynomials of the matrix may be nonzero there.

    Where it is False, one state does not depend on the other (a forcing on the structure, for
    example), and the entry is exactly zero, not only up to rounding.
    """
    patterns = matrices != 0
    if (patterns == patterns[:1]).all():
        return np.broadcast_to(_closure(patterns[0].tobytes(), len(patterns[0])), patterns.shape)
    return np.stack([_closure(pattern.tobytes(), len(pattern)) for pattern in patterns])


@lru_cache(maxsize=4096)
def _closure(content: bytes, size: int) -> np.ndarray:
    pattern = np.frombuffer(content, dtype=bool).reshape(size, size)
    reached = (pattern | np.eye(size, dtype=bool)).astype(np.float32)  # for the products' sake
    for _ in range(size.bit_length()):
        reached = (reached @ reached > 0).astype(np.float32)
    return np.asarray(reached > 0)
