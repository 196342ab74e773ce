"""Derivatives of the multipliers of a section map, and of what they make up."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
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
    matrix, rates, rank, trivial = found
    number = float if lib is None else lib.mp.mpf
    kind = float if lib is None else object
    trace = number(sum(np.diagonal(matrix).tolist()))
    trace_rates = np.array(
        [sum(np.diagonal(rate).tolist(), number(0)) for rate in rates], dtype=kind
    )
    if not rank:
        nothing = np.zeros(len(rates), dtype=kind) * number(0)
        none = np.empty((0, len(rates)), dtype=complex if lib is None else object)
        one, zero = number(1), number(0)
        return MultiplierDerivatives(
            trace, trace_rates, one, nothing, none[:, 0:0].ravel(), none, zero, nothing
        )
    reduced, moved = _reduced(matrix, rates, rank, lib)
    values, right, left = _eigen(reduced, lib)
    order = sorted(range(rank), key=lambda k: -float(abs(values[k])))
    for _ in range(trivial):
        order.remove(min(order, key=lambda k: float(abs(values[k] - 1))))
    determinant = _determinant(reduced, lib)
    cofactors = _adjugate(reduced, lib)
    determinant_rates = np.array([np.trace(cofactors @ rate) for rate in moved], dtype=kind)
    largest = max(float(abs(value)) for value in values)
    apart = {
        k: all(
            float(abs(values[k] - values[j])) > _COLLISION * largest for j in range(rank) if j != k
        )
        for k in order
    }
    nan = complex("nan") if lib is None else lib.mp.nan
    slopes = np.array(
        [
            [(left[k] @ rate @ right[:, k]) / (left[k] @ right[:, k]) for rate in moved]
            if apart[k]
            else [nan] * len(moved)
            for k in order
        ],
        dtype=complex if lib is None else object,
    ).reshape(len(order), len(moved))
    multipliers = np.array([values[k] for k in order], dtype=slopes.dtype)
    radius: Any = number(0)
    radius_rates = np.zeros(len(moved), dtype=kind) * number(0)
    if len(order):
        radius = number(abs(multipliers[0]))
        turned = [multipliers[0].conjugate() * slope for slope in slopes[0]]
        radius_rates = np.array([t.real / radius for t in turned], dtype=kind)
        tied = [
            k
            for k in range(1, len(order))
            if abs(float(abs(multipliers[k])) - float(radius)) <= _COLLISION * float(radius)
            and float(abs(multipliers[k] - multipliers[0].conjugate())) > _COLLISION * largest
        ]
        if tied:
            radius_rates = np.full(len(moved), number("nan"), dtype=kind)
    return MultiplierDerivatives(
        trace,
        trace_rates,
        determinant,
        determinant_rates,
        multipliers,
        slopes,
        radius,
        radius_rates,
    )


def many_multiplier_derivatives(found: MapDerivatives) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives (k, q) of determinant and of spectral radius of k maps, in double precision.

    The matrices are (k, m, m), the rates (k, q, m, m). The results are those of
    `multiplier_derivatives`, and NaN where a map is not finite.
    """
    shape = found.rates.shape[:2]
    determinant, radius = np.full(shape, np.nan), np.full(shape, np.nan)
    sound = np.isfinite(found.matrix).all(axis=(1, 2)) & np.isfinite(found.rates).all(
        axis=(1, 2, 3)
    )
    places = np.flatnonzero(sound)
    if not found.rank:
        determinant[places] = radius[places] = 0.0
    if not found.rank or not len(places):
        return determinant, radius
    own = found._replace(matrix=found.matrix[places], rates=found.rates[places])
    with np.errstate(all="ignore"):
        reduced, moved = _reduced_of_many(own)
        determinant[places] = np.einsum("kij,kqji->kq", _adjugates(reduced), moved)
        radius[places] = _radius_rates(reduced, moved, found.trivial)
    return determinant, radius


def _reduced_of_many(found: MapDerivatives) -> tuple[np.ndarray, np.ndarray]:
    """The maps on their ranges and their derivatives, as `_reduced` gives them for one map."""
    matrix, rates, rank, _ = found
    if rank == matrix.shape[1]:
        return matrix, rates
    basis = np.linalg.svd(matrix)[0]
    back = np.swapaxes(basis, 1, 2)
    turned = back @ matrix @ basis
    inside, beside = turned[:, :rank, :rank], turned[:, :rank, rank:]
    changed = back[:, None] @ rates @ basis[:, None]
    across = changed[:, :, rank:, :rank] @ inverses(inside)[:, None]
    return inside, changed[:, :, :rank, :rank] + beside[:, None] @ across


def _radius_rates(matrix: np.ndarray, rates: np.ndarray, trivial: int) -> np.ndarray:
    """Derivatives (k, q) of the largest absolute value of an eigenvalue that is not trivial."""
    values, right = np.linalg.eig(matrix)
    values = values.astype(complex)
    slopes = np.einsum("kij,kqjl,kli->kqi", inverses(right), rates, right)
    every = np.arange(len(values))
    size = abs(values)
    largest = size.max(axis=1)
    for _ in range(min(trivial, values.shape[1])):
        size[every, np.argmin(np.where(size < 0, np.inf, abs(values - 1)), axis=1)] = -1.0
    first = np.argmax(size, axis=1)
    value, radius = values[every, first], size[every, first]
    apart = abs(values - value[:, None]) > _COLLISION * largest[:, None]
    apart[every, first] = True
    alike = (size >= radius[:, None] * (1 - _COLLISION)) & (
        abs(values - value.conj()[:, None]) > _COLLISION * largest[:, None]
    )
    alike[every, first] = False
    turned = (value.conj()[:, None] * slopes[every, :, first]).real / radius[:, None]
    lost = ~apart.all(axis=1) | alike.any(axis=1)
    none = radius < 0  # there are trivial ones alone
    return np.where(none[:, None], 0.0, np.where(lost[:, None], np.nan, turned))


def _adjugates(matrix: np.ndarray) -> np.ndarray:
    """The adjugates of many matrices, as `_adjugate` gives them for one."""
    size = matrix.shape[1]
    found = np.ones_like(matrix)
    for i in range(size):
        for j in range(size):
            minor = np.delete(np.delete(matrix, i, axis=1), j, axis=2)
            found[:, j, i] = (-1) ** (i + j) * np.linalg.det(minor)
    return found


def _reduced(
    matrix: np.ndarray, rates: np.ndarray, rank: int, lib: Mpmath | None
) -> tuple[np.ndarray, np.ndarray]:
    """The map on its range, whose rank is taken to be constant, and its derivatives there.

    In a basis of the range and its complement the map is [[A, B], [0, 0]], its change
    [[a, b], [c, d]]; the range turns by c A^-1, and what is left changes by a + B c A^-1.
    """
    size = len(matrix)
    if rank == size:
        return matrix, rates
    basis, _, _ = np.linalg.svd(matrix.astype(float))
    if lib is not None:
        basis = _orthonormal_range(matrix, rank, lib)
    turned = basis.T @ matrix @ basis
    inside, beside = turned[:rank, :rank], turned[:rank, rank:]
    changed = np.array([basis.T @ rate @ basis for rate in rates]).reshape(-1, size, size)
    across = [
        np.array(_solved(inside.T, rate[rank:, :rank].T, lib)).T for rate in changed
    ]  # c A^-1
    moved = [rate[:rank, :rank] + beside @ turn for rate, turn in zip(changed, across, strict=True)]
    return inside, np.array(moved).reshape(len(rates), rank, rank)


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


def _solved(matrix: np.ndarray, right: np.ndarray, lib: Mpmath | None) -> Any:
    if lib is None:
        return np.linalg.solve(matrix, right)
    columns = [lib.solve(matrix.tolist(), right[:, k].tolist()) for k in range(right.shape[1])]
    return np.array(columns, dtype=object).reshape(right.shape[1], len(matrix)).T


def _eigen(matrix: np.ndarray, lib: Mpmath | None) -> tuple[Any, np.ndarray, np.ndarray]:
    """Eigenvalues, right eigenvectors as columns, left ones as rows."""
    if lib is None:
        import scipy.linalg

        values, left, right = scipy.linalg.eig(matrix, left=True, right=True)
        return values.tolist(), right, left.conj().T
    values, left, right = lib.mp.eig(lib.mp.matrix(matrix.tolist()), left=True, right=True)
    columns, rows = (np.array(part.tolist(), dtype=object) for part in (right, left))
    return [lib.mp.mpc(value) for value in values], columns, rows


def _determinant(matrix: np.ndarray, lib: Mpmath | None) -> Any:
    if lib is None:
        return float(np.linalg.det(matrix))
    return lib.mp.det(lib.mp.matrix(matrix.tolist()))


def _adjugate(matrix: np.ndarray, lib: Mpmath | None) -> np.ndarray:
    """The adjugate: derivative of the determinant, also where that is zero."""
    size = len(matrix)
    found = np.empty_like(matrix)
    for i in range(size):
        for j in range(size):
            minor = np.delete(np.delete(matrix, i, axis=0), j, axis=1)
            found[j, i] = (-1) ** (i + j) * (_determinant(minor, lib) if size > 1 else 1)
    return found
