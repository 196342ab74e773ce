"""Modes of a configuration from its numbers, where its flow has no closed form.

With Y = (y, 1) the motion y' = A y + b is Y' = B Y, and

    exp(B t) = sum_c e^(mu_c t) sum_k t^k/k! (B - mu_c)^k P_c,

a sum over clusters of eigenvalues with centres mu_c and spectral projectors P_c. A cluster is a
single eigenvalue wherever its projector is small enough to be known well; eigenvalues that are
equal, or so near each other that their projectors cancel, are taken together. The powers of a
cluster end at its size where its eigenvalues are equal, and a little later where they are not.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.linalg import matrix_balance, schur, solve_sylvester

from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.simulation.run import LONGEST_WAIT
from nonsmooth.runtime.simulation.structure import ModeShape, mode_shapes
from nonsmooth.runtime.values import flint_precision

__all__ = ["NumericModes", "numeric_modes"]

_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, math.inf)  # of the largest modulus
_LARGE = 30.0  # norm of a projector: as much, squared, may be lost of the digits
_LARGEST = 1e9
_BITS = 320
_LONGEST_CHAIN = 24


class NumericModes(NamedTuple):
    """Modes of one configuration.

    Attributes
    ----------
    shapes : tuple of ModeShape
        First that of the exponent 0, which has the constants.
    exponents : array (modes, 2)
        Real and imaginary parts.
    flows : array (functions, N, N + 1)
        ``y(t) = sum_f phi_f(t) (B_f y(0) + beta_f)``: B_f, then beta_f.
    """

    shapes: tuple[ModeShape, ...]
    exponents: np.ndarray
    flows: np.ndarray


class _Cluster(NamedTuple):
    """Eigenvalues taken together: the terms ``t^k e^(mu t)`` with their matrices."""

    centre: complex
    norm: float  # of the projector
    terms: list[np.ndarray] | None  # None where the powers do not end


def numeric_modes(field: np.ndarray) -> NumericModes:
    """Modes of y' = A y + b.

    Parameters
    ----------
    field : array (N, N + 1)
        A, then b; finite.

    Raises
    ------
    InputError
        If eigenvalues are neither equal nor apart, so that double precision does not tell the
        motion.
    """
    array = np.ascontiguousarray(field, dtype=float)
    return _numeric_modes(array.tobytes(), len(array))


@lru_cache(maxsize=4096)  # configurations share fields, and so do points of a sweep
def _numeric_modes(content: bytes, size: int) -> NumericModes:
    field = np.frombuffer(content).reshape(size, size + 1)
    whole = np.vstack([field, np.zeros(size + 1)])
    # a change of units keeps powers of two exact
    with np.errstate(invalid="ignore"):  # of the permutation, which is none
        scaled, (units, _) = matrix_balance(whole, permute=False, separate=True)
    found = _decomposed(scaled)
    exponents, flows, shapes = [], [], []
    for cluster in found:
        assert cluster.terms is not None
        oscillates = cluster.centre.imag > 0
        for k, term in enumerate(cluster.terms):
            part = (units[:, None] * term / units)[:size] / math.factorial(k)
            flows += [2 * part.real, -2 * part.imag] if oscillates else [part.real]
        exponents.append((cluster.centre.real, cluster.centre.imag))
        shapes.append((len(cluster.terms), oscillates))
    for array in (exponents_ := np.array(exponents), flows_ := np.array(flows)):
        array.flags.writeable = False
    return NumericModes(mode_shapes(shapes), exponents_, flows_)


def _decomposed(matrix: np.ndarray) -> list[_Cluster]:
    """Clusters whose projectors are smallest, among those whose powers end."""
    values, right = np.linalg.eig(matrix)
    scale = float(np.abs(values).max())
    best = _apart(values, right, scale)
    if best is not None:
        return _sorted(best)
    groupings: list[list[list[complex]]] = []
    for nearness in _NEARNESS:
        groups = _groups(values.tolist(), nearness * scale if scale else math.inf)
        if groups in groupings:
            continue
        groupings.append(groups)
        found = list(_clusters(matrix, groups, scale))
        if all(cluster.terms is not None for cluster in found):
            if best is None or _worst(found) < 0.1 * _worst(best):
                best = found
            if _worst(best) <= _LARGE:
                break
    if best is None or _worst(best) > _LARGE:
        best = _precise(matrix, scale) or best
    if best is None or _worst(best) > _LARGEST:
        raise InputError(
            "eigenvalues of a vector field are neither equal nor apart: double precision does not"
            f" tell them from each other ({', '.join(f'{v:.6g}' for v in values)})"
        )
    return _sorted(best)


def _sorted(clusters: list[_Cluster]) -> list[_Cluster]:
    return sorted(clusters, key=lambda c: (c.centre != 0, c.centre.imag, c.centre.real))


def _apart(values: np.ndarray, right: np.ndarray, scale: float) -> list[_Cluster] | None:
    """A cluster for each eigenvalue, from eigenvectors; None where some are near each other."""
    gaps = np.abs(values[:, None] - values) + np.diag(np.full(len(values), np.inf))
    if gaps.min() <= _NEARNESS[0] * scale:
        return None
    left = np.linalg.inv(right)
    found = _singles(values, right, left, scale)
    return found if _worst(found) <= _LARGE else None


def _precise(matrix: np.ndarray, scale: float) -> list[_Cluster] | None:
    """The same in more digits, so that no more are lost than the projectors' sum cancels."""
    from flint import acb_mat

    with flint_precision(_BITS):
        try:
            values, left, right = acb_mat(matrix.tolist()).eig(left=True, right=True)
        except ValueError:  # eigenvalues that are equal, or nearly
            return None
    rows, columns = (np.array(m.tolist()).astype(complex) for m in (left, right))
    return _singles(np.array(values).astype(complex), columns, rows, scale)


def _singles(
    values: np.ndarray, right: np.ndarray, left: np.ndarray, scale: float
) -> list[_Cluster]:
    """A cluster for each eigenvalue, from right eigenvectors (columns) and left ones (rows)."""
    norms = np.linalg.norm(left, axis=1) * np.linalg.norm(right, axis=0)
    found = []
    for k, value in enumerate(values.tolist()):
        centre = _snapped(complex(value), len(values), scale)
        if centre.imag >= 0:
            term = np.outer(right[:, k], left[k]).astype(complex)
            found.append(_Cluster(centre, float(norms[k]), [term]))
    return found


def _snapped(centre: complex, size: int, scale: float) -> complex:
    """An exponent without what rounding makes of a part that is zero."""
    tiny = 8 * size * _EPSILON * scale
    return complex(
        0.0 if abs(centre.real) <= tiny else centre.real,
        0.0 if abs(centre.imag) <= tiny else centre.imag,
    )


def _worst(clusters: list[_Cluster]) -> float:
    return max(cluster.norm for cluster in clusters)


def _groups(values: list[complex], distance: float) -> list[list[complex]]:
    """Eigenvalues linked by distances; conjugates are in one group, or in two conjugate ones."""
    groups: list[list[complex]] = []
    for value in values:
        near = [g for g in groups if any(abs(value - other) <= distance for other in g)]
        groups = [g for g in groups if g not in near]
        groups.append([value, *(v for group in near for v in group)])
    return [sorted(g, key=lambda v: (v.real, v.imag)) for g in groups]


def _clusters(matrix: np.ndarray, groups: list[list[complex]], scale: float) -> Iterator[_Cluster]:
    """Each cluster of which the conjugate is not another one."""
    for group in groups:
        real = {v.conjugate() for v in group} == set(group)
        if real or sum(group).imag > 0:
            yield _cluster(matrix, group, real, scale)


def _cluster(matrix: np.ndarray, group: list[complex], real: bool, scale: float) -> _Cluster:
    """Projector and powers of one cluster, from an ordered Schur decomposition."""
    size, count = len(matrix), len(group)
    others = [complex(v) for v in np.linalg.eigvals(matrix)]
    for value in group:
        others.remove(min(others, key=lambda v: abs(v - value)))

    def belongs(value: complex) -> bool:
        inside = min(abs(value - v) for v in group)
        return inside <= min((abs(value - v) for v in others), default=math.inf)

    if count == size:
        block, right, left = matrix.astype(complex), np.eye(size), np.eye(size)
    else:
        triangle, basis, chosen = schur(matrix.astype(complex), output="complex", sort=belongs)
        if chosen != count:
            return _Cluster(0j, math.inf, None)
        block, rest = triangle[:count, :count], triangle[count:, count:]
        solution = solve_sylvester(block, -rest, -triangle[:count, count:])
        right = basis[:, :count]
        left = np.hstack([np.eye(count), -solution]) @ basis.conj().T
    centre = complex(np.trace(block)) / count
    if min(map(abs, group)) <= 8 * size * _EPSILON * scale:
        centre = 0j  # the eigenvalue of the constants is among them
    centre = _snapped(complex(centre.real) if real else centre, size, scale)
    norm = float(np.linalg.norm(left, 2))
    error = 64 * _EPSILON * float(np.linalg.norm(matrix, 2))
    longest = LONGEST_WAIT / scale if scale else math.inf
    return _Cluster(centre, norm, _terms(block, right, left, centre, error, longest))


def _terms(
    block: np.ndarray,
    right: np.ndarray,
    left: np.ndarray,
    centre: complex,
    error: float,
    longest: float,
) -> list[np.ndarray] | None:
    """Matrices (B - mu)^k P until the rest counts no more over the longest wait.

    The block of B errs by `error`: what that may make of zero is zero.
    """
    shifted = block - centre * np.eye(len(block))
    before = 1.0
    power, silent = np.eye(len(block), dtype=complex), 0
    terms: list[np.ndarray] = []
    for k in range(_LONGEST_CHAIN):
        size = float(np.linalg.norm(power, 2))
        if k and size <= error * before:
            return terms
        before = size
        silent = silent + 1 if size * _largest(k, centre.real, longest) <= _EPSILON else 0
        if silent == 2 and k >= len(block):
            return terms[:-1]
        terms.append(right @ power @ left)
        power = power @ shifted
    return None


def _largest(k: int, rate: float, longest: float) -> float:
    """Largest value of t^k/k! e^(rate t) over t < longest; relative to a growing e^(rate t)."""
    peak = min(longest, k / -rate) if rate < 0 and k else longest
    if k == 0 or peak == 0:
        return 1.0
    if peak == math.inf:
        return math.inf
    return math.exp(k * math.log(peak) - math.lgamma(k + 1) + min(rate, 0.0) * peak)
