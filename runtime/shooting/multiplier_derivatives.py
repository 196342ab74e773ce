"""Derivatives of the multipliers of a section map, and of what they make up."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.core.matrices import inverses

__all__ = [
    "MapDerivatives",
    "MultiplierDerivatives",
    "many_multiplier_derivatives",
    "multiplier_derivatives",
]

_COLLISION = 1e-6  # of the largest multiplier: distance below which two are not told apart


class MapDerivatives(NamedTuple):
    """A section map and its derivatives by q numbers."""

    matrix: np.ndarray  # (k, k)
    rates: np.ndarray  # (q, k, k)
    rank: int  # number of multipliers that may differ from zero
    trivial: int  # how many of these are 1 because a first integral is kept


class MultiplierDerivatives(NamedTuple):
    """What a section map's multipliers are, and their derivatives by q numbers.

    Attributes
    ----------
    trace, determinant : number
        Sum and product of the r multipliers that may differ from zero.
    trace_rates, determinant_rates : array (q,)
    multipliers : array (s,)
        Complex: those of the r that are not trivial, by decreasing absolute value.
    multiplier_rates : array (s, q)
        NaN for those that collide.
    spectral_radius : number
    spectral_radius_rates : array (q,)
        NaN where the largest multiplier collides with another.
    """

    trace: Any
    trace_rates: np.ndarray
    determinant: Any
    determinant_rates: np.ndarray
    multipliers: np.ndarray
    multiplier_rates: np.ndarray
    spectral_radius: Any
    spectral_radius_rates: np.ndarray


def multiplier_derivatives(found: MapDerivatives, lib: Mpmath | None) -> MultiplierDerivatives:
    """Derivatives of multipliers, from their left and right eigenvectors, if they are distinct.

    See P. Lancaster, Numer. Math. 6, 1964. Where two multipliers collide, trace and determinant
    still have derivatives. `lib` is None in double precision.
    """
    one = found._replace(matrix=found.matrix[None], rates=found.rates[None])
    parts = _derivatives(one, lib)
    return MultiplierDerivatives(*(p.tolist()[0] if p.ndim == 1 else p[0] for p in parts))


def many_multiplier_derivatives(found: MapDerivatives) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives (k, q) of determinant and of spectral radius of k maps, in double precision.

    The matrices are (k, m, m), the rates (k, q, m, m). The results are those of
    `multiplier_derivatives`, and NaN where a map is not finite.
    """
    determinant, radius = (np.full(found.rates.shape[:2], np.nan) for _ in range(2))
    sound = np.isfinite(found.matrix).all(axis=(1, 2))
    places = np.flatnonzero(sound & np.isfinite(found.rates).all(axis=(1, 2, 3)))
    if len(places):
        own = found._replace(matrix=found.matrix[places], rates=found.rates[places])
        with np.errstate(all="ignore"):
            told = _derivatives(own, None)
        determinant[places] = told.determinant_rates
        radius[places] = told.spectral_radius_rates
    return determinant, radius


def _derivatives(found: MapDerivatives, lib: Mpmath | None) -> MultiplierDerivatives:
    """Derivatives of the multipliers of k maps (k, m, m) with rates (k, q, m, m)."""
    matrix, rates, rank, trivial = found
    number, kind, complex_kind = (
        (float, float, complex) if lib is None else (lib.mp.mpf, object, object)
    )
    count = len(matrix)
    trace, trace_rates = (np.trace(part, axis1=-2, axis2=-1) for part in (matrix, rates))
    radius = np.full(count, number(0), dtype=kind)
    radius_rates = np.full(trace_rates.shape, number(0), dtype=kind)
    if not rank:
        none = np.empty((count, 0, rates.shape[1]), dtype=complex_kind)
        one = np.full(count, number(1), dtype=kind)
        return MultiplierDerivatives(
            trace, trace_rates, one, radius_rates, none.sum(axis=2), none, radius, radius_rates
        )
    reduced, moved = _reduced(matrix, rates, rank, lib)
    adjugates = _adjugates(reduced, lib)[:, None]
    values, right, left = _eigen(reduced, lib)
    slopes = np.diagonal(left[:, None] @ moved @ right[:, None], axis1=2, axis2=3)
    sizes, every = abs(values).astype(float), np.arange(count)
    most = _COLLISION * sizes.max(axis=1, keepdims=True)
    distances = abs(values[:, :, None] - values[:, None]).astype(float)
    apart = (distances > most[:, None]).sum(axis=2) == rank - 1
    for _ in range(min(trivial, rank)):
        near = np.where(sizes < 0, np.inf, abs(values - 1).astype(float))
        sizes[every, np.argmin(near, axis=1)] = -1.0
    order = np.argsort(-sizes, axis=1, kind="stable")[:, : rank - min(trivial, rank)]
    multipliers, apart, sizes = (
        np.take_along_axis(part, order, axis=1) for part in (values, apart, sizes)
    )
    turned = np.take_along_axis(np.swapaxes(slopes, 1, 2), order[..., None], axis=1)
    nan = complex("nan") if lib is None else lib.mp.nan
    turned = np.where(apart[..., None], turned, nan)
    if order.shape[1]:
        first = multipliers[:, 0].conj()[:, None]
        radius = abs(multipliers[:, 0])
        radius_rates = real_parts(first * turned[:, 0]) / radius[:, None]
        tied = (abs(sizes - sizes[:, :1]) <= _COLLISION * sizes[:, :1]) & (
            abs(multipliers - first).astype(float) > most
        )
        tied[:, 0] = False
        radius_rates = np.where(tied.any(axis=1)[:, None], number("nan"), radius_rates)
    return MultiplierDerivatives(
        trace,
        trace_rates,
        _determinants(reduced, lib),
        np.trace(adjugates @ moved, axis1=2, axis2=3),
        multipliers,
        turned,
        radius,
        radius_rates,
    )


def _reduced(
    matrix: np.ndarray, rates: np.ndarray, rank: int, lib: Mpmath | None
) -> tuple[np.ndarray, np.ndarray]:
    """The maps on their ranges, whose rank is taken to be constant, and derivatives there.

    In a basis of the range and its complement a map is [[A, B], [0, 0]], its change
    [[a, b], [c, d]]; the range turns by c A^-1, and what is left changes by a + B c A^-1.
    """
    if rank == matrix.shape[1]:
        return matrix, rates
    if lib is None:
        basis = np.linalg.svd(matrix)[0]
    else:
        basis = np.array([_orthonormal_range(each, rank, lib) for each in matrix])
    back = np.swapaxes(basis, 1, 2)
    turned = back @ matrix @ basis
    inside, beside = turned[:, :rank, :rank], turned[:, :rank, rank:]
    changed = back[:, None] @ rates @ basis[:, None]
    if lib is None:
        inverse = inverses(inside)
    else:
        inverse = np.array([(lib.mp.matrix(m.tolist()) ** -1).tolist() for m in inside])
    across = changed[:, :, rank:, :rank] @ inverse[:, None]
    return inside, changed[:, :, :rank, :rank] + beside[:, None] @ across


def _orthonormal_range(matrix: np.ndarray, rank: int, lib: Mpmath) -> np.ndarray:
    """Orthonormal basis (k, k) whose first columns span the range, by Gram and Schmidt."""
    size, root = len(matrix), lib.mp.sqrt
    basis: list[Any] = []
    unit = np.array([[lib.mp.mpf(int(i == j)) for j in range(size)] for i in range(size)])
    for candidates, wanted in ((matrix, rank), (unit, size)):
        while len(basis) < wanted:
            left = [candidates[:, k] - sum((b * (b @ candidates[:, k]) for b in basis), 0)
                    for k in range(size)]  # fmt: skip
            best = max(left, key=lambda v: v @ v)
            best = best - sum((b * (b @ best) for b in basis), 0)
            basis.append(best / root(best @ best))
    return np.stack(basis, axis=-1)


def _eigen(matrix: np.ndarray, lib: Mpmath | None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Eigenvalues (k, r), right eigenvectors as columns, left ones as rows; products are 1."""
    if lib is None and len(matrix) > 1:
        values, right = np.linalg.eig(matrix)
        return values.astype(complex), right, inverses(right)
    found = []
    for each in matrix:  # where vectors are nearly parallel their inverse would lose digits
        if lib is None:
            import scipy.linalg

            values, left, right = scipy.linalg.eig(each, left=True, right=True)
            found.append((values, right, left.conj().T))
        else:
            values, left, right = lib.mp.eig(lib.mp.matrix(each.tolist()), left=True, right=True)
            found.append(([lib.mp.mpc(v) for v in values], right.tolist(), left.tolist()))
    kind = complex if lib is None else object
    values, right, left = (np.array(part, dtype=kind) for part in zip(*found, strict=True))
    return values, right, left / np.diagonal(left @ right, axis1=1, axis2=2)[..., None]


def _determinants(matrix: np.ndarray, lib: Mpmath | None) -> np.ndarray:
    if lib is None:
        return np.asarray(np.linalg.det(matrix))
    return np.array([lib.mp.det(lib.mp.matrix(m.tolist())) for m in matrix], dtype=object)


def _adjugates(matrix: np.ndarray, lib: Mpmath | None) -> np.ndarray:
    """The adjugates: derivatives of the determinants, also where these are zero."""
    size = matrix.shape[1]
    found = np.ones_like(matrix)
    for i, j in np.ndindex(size, size) if size > 1 else ():
        minor = np.delete(np.delete(matrix, i, axis=1), j, axis=2)
        found[:, j, i] = (-1) ** (i + j) * _determinants(minor, lib)
    return found
