"""Checked matrices of a linear structure, dense or sparse, and its lowest modes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from nonsmooth.derive.errors import DeclarationError

Array = npt.NDArray[np.float64]

# up to here LAPACK is faster than a factor of the shifted matrix and Lanczos' iterations
_DENSE = 400
_SYMMETRIC = 1e-10


class Structure(NamedTuple):
    """Mass, stiffness and damping as sparse matrices (CSC), symmetric to the last bit."""

    mass: Any
    stiffness: Any
    damping: Any


def checked_structure(mass: Any, stiffness: Any, damping: Any) -> Structure:
    """Mass, stiffness and damping, checked; a damping that is not given is zero.

    DeclarationError names the matrix that is not square, finite, symmetric or of the size
    of mass, or a mass that is not positive definite.
    """
    from scipy.sparse import csc_array

    checked = _checked(mass, "mass", None)
    size = checked.shape[0]
    if not Factor(checked).positive_definite:
        raise DeclarationError("mass is not positive definite")
    return Structure(
        checked,
        _checked(stiffness, "stiffness", size),
        csc_array((size, size)) if damping is None else _checked(damping, "damping", size),
    )


def _checked(given: Any, what: str, size: int | None) -> Any:
    from scipy.sparse import csc_array, issparse

    try:
        if np.ma.is_masked(given):
            raise DeclarationError(f"{what} has masked values")
        values = given if issparse(given) else np.asarray(given)
        if len(values.shape) != 2 or values.shape[0] != values.shape[1]:
            raise DeclarationError(f"{what} is not square: its shape is {values.shape}")
        if values.dtype.kind == "c":
            raise DeclarationError(f"{what} is complex")
        matrix = csc_array(values, dtype=float)
    except (TypeError, ValueError) as problem:
        if isinstance(problem, DeclarationError):
            raise
        raise DeclarationError(f"{what} is no matrix of real numbers") from None
    shape = matrix.shape
    if shape[0] == 0:
        raise DeclarationError(f"{what} is empty")
    if size is not None and shape[0] != size:
        raise DeclarationError(f"{what} is {shape[0]} x {shape[0]}, where mass is {size} x {size}")
    if not np.isfinite(matrix.data).all():
        raise DeclarationError(f"{what} holds an entry that is not finite")
    if abs(matrix - matrix.T).max() > _SYMMETRIC * abs(matrix).max():
        raise DeclarationError(f"{what} is not symmetric")
    return csc_array((matrix + matrix.T) / 2)


class Factor:
    """The factors of a symmetric sparse matrix, which also show whether it is positive definite."""

    def __init__(self, matrix: Any) -> None:
        from scipy.sparse import csc_array
        from scipy.sparse.linalg import splu

        self.positive_definite = False
        try:
            # without exchange of rows the pivots are those of L D L': their signs are its inertia
            self._factor = splu(
                csc_array(matrix),
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # exactly singular
            return
        pivots = self._factor.U.diagonal()
        largest = abs(matrix.diagonal())[np.argsort(self._factor.perm_c)]
        in_place = bool((self._factor.perm_r == self._factor.perm_c).all())
        rounding = 16 * np.finfo(float).eps * largest
        self.positive_definite = in_place and bool((pivots > rounding).all())

    def __call__(self, right: Array) -> Array:
        """Solutions (n, k) of the linear equations with k right-hand sides."""
        return np.asarray(self._factor.solve(np.ascontiguousarray(right)))


def lowest_modes(stiffness: Any, mass: Any, count: int) -> tuple[Array, Array]:
    """Squared frequencies (count,) of the lowest modes, and their shapes (n, count).

    Frequencies are angular and modes have unit mass. The largest component of a mode is
    positive, so that the same matrices give the same modes.
    """
    from scipy.linalg import eigh
    from scipy.sparse.linalg import LinearOperator, eigsh

    size = mass.shape[0]
    if count == 0:
        return np.zeros(0), np.zeros((size, 0))
    if size <= _DENSE or 2 * count >= size:
        squares, modes = eigh(
            stiffness.toarray(), mass.toarray(), subset_by_index=[0, min(count, size) - 1]
        )
    else:
        # below zero, so that a structure that moves as a rigid body can be solved as well
        shift = -1e-6 * stiffness.diagonal().sum() / mass.diagonal().sum()
        factor = Factor(stiffness - shift * mass)
        squares, modes = eigsh(
            stiffness,
            k=count,
            M=mass,
            sigma=shift,
            which="LM",
            v0=np.random.default_rng(count).standard_normal(size),
            OPinv=LinearOperator((size, size), matvec=factor, dtype=float),
        )
    order = np.argsort(squares)
    squares, modes = squares[order], modes[:, order]
    largest = modes[np.argmax(abs(modes), axis=0), np.arange(modes.shape[1])]
    return squares, modes * np.sign(largest)
