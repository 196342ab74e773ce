"""Exponentials and eigenvalues of many small matrices at once.

The exponentials serve derivatives of flows by parameters, where flows have no closed form.
"""

from __future__ import annotations

import numpy as np

_LARGEST = 1e6  # norm of an exponent
_NORM, _DEGREE = 0.5, 15  # the series' rest is below 0.5^16 / 16! = 7e-19


def exponentials(matrices: np.ndarray) -> np.ndarray:
    """Exponentials (k, n, n) of real or complex matrices (k, n, n), nondimensional.

    Scaling, Taylor's series and squaring take plain products alone: a tiny imaginary part
    comes out as a derivative, to full precision (Al-Mohy and Higham, 2010). The result is
    NaN for a matrix that is not finite, or has a column sum of absolute values above 10^6.

    Examples
    --------
    >>> exponentials(np.array([[[0.0, 1.0], [0.0, 0.0]]])).tolist()
    [[[1.0, 1.0], [0.0, 1.0]]]
    """
    size = matrices.shape[-1]
    norms = np.abs(matrices).sum(axis=-2).max(axis=-1, initial=0.0)
    moderate = norms <= _LARGEST
    largest = float(np.max(norms, initial=0.0, where=moderate))
    halvings = max(0, int(np.ceil(np.log2(max(largest, _NORM) / _NORM))))
    scaled = np.where(moderate[:, None, None], matrices, 0.0) / 2.0**halvings
    unit = np.eye(size, dtype=scaled.dtype)
    found = unit + scaled / _DEGREE
    for order in range(_DEGREE - 1, 0, -1):
        found = scaled @ found
        found /= order
        found += unit
    for _ in range(halvings):
        found = found @ found
    found[~moderate] = np.nan
    return np.asarray(found)


def eigenvalues(matrices: np.ndarray) -> np.ndarray:
    """Complex eigenvalues (k, n) of matrices (k, n, n), by decreasing absolute value.

    They are NaN for a matrix that is not finite.
    """
    found = np.full(matrices.shape[:-1], np.nan, dtype=complex)
    sound = np.isfinite(matrices).all(axis=(-2, -1))
    found[sound] = np.linalg.eigvals(matrices[sound])
    return sorted_by_size(found)


def inverses(matrices: np.ndarray) -> np.ndarray:
    """Inverses (k, n, n) of real or complex matrices; NaN where one is singular to the last bit."""
    try:
        return np.asarray(np.linalg.inv(matrices))
    except np.linalg.LinAlgError:
        sound = np.abs(np.linalg.det(matrices)) > 0
        found = np.full_like(matrices, np.nan)
        found[sound] = np.linalg.inv(matrices[sound])
        return found


def sorted_by_size(values: np.ndarray) -> np.ndarray:
    """Rows (..., n) of real or complex numbers by decreasing absolute value.

    Examples
    --------
    >>> sorted_by_size(np.array([0.5, -2.0, 1.0]))
    array([-2. ,  1. ,  0.5])
    """
    order = np.argsort(-np.abs(values), axis=-1, kind="stable")
    return np.take_along_axis(values, order, axis=-1)
