"""Derivatives of a system's fields, rows and resets by all its parameters."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import tables_at

__all__ = ["TableDerivatives", "table_derivatives"]

_IMAGINARY = 1e-30  # of a parameter, in units of max(1, |it|)


class TableDerivatives(NamedTuple):
    """Derivatives of the tables by q parameters.

    Attributes
    ----------
    fields : array (q, configurations, N, N + 1)
    rows : array (q, R, N + 1)
    resets : array (q, S, N, N + 1)
    """

    fields: np.ndarray
    rows: np.ndarray
    resets: np.ndarray


def table_derivatives(kernels: SystemKernels, point: np.ndarray) -> TableDerivatives:
    """Differentiate fields, rows and resets by every parameter, to full precision.

    Each parameter gets a tiny imaginary part (Squire and Trapp, SIAM Review 40, 1998).

    Parameters
    ----------
    kernels : SystemKernels
    point : array (q,)
        In the order of the system's parameters.

    Returns
    -------
    TableDerivatives
        In the order of the system's parameters.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> found = table_derivatives(kernels, np.array([1.0, 2.0, 1.0, 5.0, 0.5]))
    >>> found.resets[4].min()  # by the coefficient of restitution: v1 = -r v1 in front
    -1.0
    """
    tiny = _IMAGINARY * np.maximum(1.0, np.abs(point))
    moved = np.vstack(
        [point, point + 1j * np.diag(tiny)]
    )  # some row, where there are no parameters
    return TableDerivatives(
        *(
            part[1:].imag / tiny.reshape(-1, *[1] * (part.ndim - 1))
            for part in tables_at(kernels, moved)
        )
    )
