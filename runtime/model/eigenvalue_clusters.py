"""Clusters of a matrix's eigenvalues with their projectors, whose sum is its exponential.

In double precision: from eigenvectors where eigenvalues are apart, else from an ordered Schur
decomposition. In many digits, rounded once: the same, Newton's interpolation of few eigenvalues
that nearly meet, or the series of more. `nonsmooth.runtime.model.modes` chooses among them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.projectors import chain, newton, poles_of

__all__ = [
    "Cluster",
    "cluster_terms",
    "eigenvectors_apart",
    "groupings",
    "is_real",
    "leads",
    "precise_candidates",
    "real_parts_of",
    "smallest_distances",
    "smallest_projectors",
    "snapped",
]

_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, math.inf)  # of the largest modulus
_LARGE = 30.0  # norm of a projector: as much, squared, may be lost of the digits
_HUGE = 1e100  # entry of a power that belongs to no cluster
_BITS = 320
_LONGEST_CHAIN = 24
_LONGEST_NEWTON = 7


class Cluster(NamedTuple):
    """Eigenvalues taken together: the terms ``t^k e^(mu t)`` with their matrices."""

    centre: complex
    norm: float  # of the projector
    terms: list[np.ndarray] | None  # None where the powers do not end
    poles: tuple[complex, ...] = ()  # of a chain: its terms are Newton's products


def eigenvectors_apart(values: np.ndarray, right: np.ndarray, scale: float) -> list[Cluster] | None:
    """One cluster for each eigenvalue (N,), from the eigenvectors, the columns of an (N, N) array.

    `scale`, the largest modulus of an eigenvalue, is the unit of their distances. None if some
    eigenvalues are close to each other or a projector is large.
    """
    if smallest_distances(values[None])[0] <= _NEARNESS[0] * scale:
        return None
    left = np.linalg.inv(right)
    found = _singles(values, right, left, scale)
    return found if _worst(found) <= _LARGE else None


def smallest_projectors(
    matrix: np.ndarray, values: np.ndarray, scale: float
) -> list[Cluster] | None:
    """The clusters with the smallest projectors, among groupings whose powers end.

    `values` (N,) are the eigenvalues of the matrix (N, N), and `scale` their largest modulus,
    the unit of distances. None if the powers end for no grouping.
    """
    best: list[Cluster] | None = None
    for groups in groupings(values.tolist(), _NEARNESS, scale):
        found = list(_clusters(matrix, groups, scale))
        if all(cluster.terms is not None for cluster in found):
            if best is None or _worst(found) < 0.1 * _worst(best):
                best = found
            if _worst(best) <= _LARGE:
                break
    return best


def precise_candidates(
    matrix: np.ndarray, values: list[complex], scale: float
) -> Iterator[list[Cluster]]:
    """Sets of clusters in more digits: single eigenvalues first, then larger and larger groups.

    `values` are the eigenvalues of the matrix (N, N), and `scale` their largest modulus, the
    unit of distances.
    """
    single = _precise(matrix, scale)
    if single is not None:
        yield single
    yield from _chains(matrix, scale)
    for groups in groupings(values, _NEARNESS, scale):
        found = [_exact_cluster(matrix, group, groups, scale) for group in groups
                 if leads(group)]  # fmt: skip
        if all(cluster.terms is not None for cluster in found):
            yield found


def _precise(matrix: np.ndarray, scale: float) -> list[Cluster] | None:
    """Clusters of single eigenvalues from eigenvectors in more digits; None if some are equal.

    So many digits are used that those lost to cancellation in the projectors' sum do not count.
    """
    from flint import acb_mat

    with flint_precision(_BITS):
        try:
            values, left, right = acb_mat(matrix.tolist()).eig(left=True, right=True)
        except ValueError:  # eigenvalues that are equal, or nearly
            return None
    rows, columns = (np.array(m.tolist()).astype(complex) for m in (left, right))
    return _singles(np.array(values).astype(complex), columns, rows, scale)


def _chains(matrix: np.ndarray, scale: float) -> Iterator[list[Cluster]]:
    """Sets of clusters that are chains of nearby eigenvalues, at larger and larger distances."""
    tiny = _EPSILON * scale
    poles = [
        complex(p.real if abs(p.real) > tiny else 0.0, p.imag if abs(p.imag) > tiny else 0.0)
        for p in poles_of(matrix)
    ]
    for groups in groupings(poles, _NEARNESS, scale):
        if max(map(len, groups)) > _LONGEST_NEWTON:
            continue
        try:
            yield [_newton_cluster(matrix, group, groups) for group in groups if leads(group)]
        except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
            continue


def _newton_cluster(
    matrix: np.ndarray, group: list[complex], groups: list[list[complex]]
) -> Cluster:
    others = [v for other in groups if other is not group for v in other]
    # zero first, then what is real, then pairs of conjugates
    poles = tuple(sorted(group, key=lambda v: (v.imag != 0, abs(v.imag), abs(v), -v.imag)))
    terms = newton(matrix, group, others, list(poles))
    return Cluster(poles[0], float(np.abs(terms[0]).max()), terms, poles)


def _exact_cluster(
    matrix: np.ndarray, group: list[complex], groups: list[list[complex]], scale: float
) -> Cluster:
    """A cluster whose terms are exact up to one rounding each."""
    others = [v for other in groups if other is not group for v in other]
    constant = min(map(abs, group)) <= 8 * len(matrix) * _EPSILON * scale
    longest = LONGEST_WAIT / scale if scale else math.inf
    terms: list[np.ndarray] = []
    silent, norm = 0, 0.0
    try:
        for k, (centre, term) in enumerate(
            islice(chain(matrix, group, others, is_real(group), constant), _LONGEST_CHAIN)
        ):
            centre = snapped(centre, len(matrix), scale)
            size = float(np.abs(term).max())
            if not size < _HUGE:
                break
            if k:
                # what the rounding of the matrix may make of zero is zero
                shifted = np.abs(matrix - centre * np.eye(len(matrix)))
                if (np.abs(term) <= 64 * _EPSILON * shifted @ np.abs(terms[-1])).all():
                    return Cluster(centre, norm, terms)
            else:
                norm = size
            silent = (
                silent + 1 if size * _largest(k, centre.real, longest) <= _EPSILON * norm else 0
            )
            if silent == 2 and k >= len(group):
                return Cluster(centre, norm, terms[:-1])
            terms.append(term)
    except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
        pass
    return Cluster(0j, math.inf, None)


def _singles(
    values: np.ndarray, right: np.ndarray, left: np.ndarray, scale: float
) -> list[Cluster]:
    """A cluster for each eigenvalue, from right eigenvectors (columns) and left ones (rows)."""
    norms = np.linalg.norm(left, axis=1) * np.linalg.norm(right, axis=0)
    found = []
    for k, value in enumerate(values.tolist()):
        centre = snapped(complex(value), len(values), scale)
        if centre.imag >= 0:
            term = np.outer(right[:, k], left[k]).astype(complex)
            found.append(Cluster(centre, float(norms[k]), [term]))
    return found


def snapped(centre: complex, size: int, scale: float) -> complex:
    """The exponent with a real or imaginary part set to zero if it is only a rounding error.

    `size` is that of the matrix, and `scale` the largest modulus of an eigenvalue.
    """
    tiny = 8 * size * _EPSILON * scale
    return complex(
        0.0 if abs(centre.real) <= tiny else centre.real,
        0.0 if abs(centre.imag) <= tiny else centre.imag,
    )


def _worst(clusters: list[Cluster]) -> float:
    return max(cluster.norm for cluster in clusters)


def smallest_distances(values: np.ndarray) -> np.ndarray:
    """Smallest distances (n,) between two of the eigenvalues (n, N); inf for a single one."""
    gaps = np.abs(values[:, :, None] - values[:, None, :])
    gaps[:, range(values.shape[1]), range(values.shape[1])] = np.inf
    return np.asarray(gaps.min(axis=(-2, -1)))


def groupings(
    values: list[complex], nearness: Iterable[float], scale: float
) -> Iterator[list[list[complex]]]:
    """Distinct ways to take eigenvalues together that are linked by steps of some nearness.

    Steps are in units of `scale`, the largest modulus of an eigenvalue; where that is 0, all of
    them are together.
    """
    known: list[list[list[complex]]] = []
    for step in nearness:
        groups = _linked_groups(values, step * scale if scale else math.inf)
        if groups not in known:
            known.append(groups)
            yield groups


def _linked_groups(values: list[complex], distance: float) -> list[list[complex]]:
    """Groups of eigenvalues that are linked by steps of at most `distance`.

    Conjugate eigenvalues are in one group, or in two groups that are conjugate to each other.
    """
    groups: list[list[complex]] = []
    for value in values:
        near = [g for g in groups if any(abs(value - other) <= distance for other in g)]
        groups = [g for g in groups if g not in near]
        groups.append([value, *(v for group in near for v in group)])
    return [sorted(g, key=lambda v: (v.real, v.imag)) for g in groups]


def leads(group: list[complex]) -> bool:
    """Whether a group is real or is, of two conjugate groups, the one that is kept."""
    return is_real(group) or sum(group).imag > 0


def is_real(group: list[complex]) -> bool:
    """Whether a group has the conjugate of each of its eigenvalues."""
    return {v.conjugate() for v in group} == set(group)


def _clusters(matrix: np.ndarray, groups: list[list[complex]], scale: float) -> Iterator[Cluster]:
    """The clusters of the groups, one for each pair of conjugate groups."""
    for group in groups:
        if leads(group):
            yield _cluster(matrix, group, is_real(group), scale)


def _cluster(matrix: np.ndarray, group: list[complex], real: bool, scale: float) -> Cluster:
    """Projector and powers of one cluster, from an ordered Schur decomposition."""
    from scipy.linalg import schur, solve_sylvester

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
            return Cluster(0j, math.inf, None)
        block, rest = triangle[:count, :count], triangle[count:, count:]
        solution = solve_sylvester(block, -rest, -triangle[:count, count:])
        right = basis[:, :count]
        left = np.hstack([np.eye(count), -solution]) @ basis.conj().T
    centre = complex(np.trace(block)) / count
    if min(map(abs, group)) <= 8 * size * _EPSILON * scale:
        centre = 0j  # the eigenvalue of the constants is among them
    centre = snapped(complex(centre.real) if real else centre, size, scale)
    norm = float(np.linalg.norm(left, 2))
    error = 64 * _EPSILON * float(np.linalg.norm(matrix, 2))
    longest = LONGEST_WAIT / scale if scale else math.inf
    return Cluster(centre, norm, cluster_terms(block, right, left, centre, error, longest))


def cluster_terms(
    block: np.ndarray,
    right: np.ndarray,
    left: np.ndarray,
    centre: complex,
    error: float,
    longest: float,
) -> list[np.ndarray] | None:
    """Matrices (B - mu)^k P (N, N) for k = 0, 1, ..., until the rest is negligible.

    `block` (m, m) is B in an invariant subspace with the bases `right` (N, m) and `left` (m, N),
    whose product is the projector P; `centre` is mu. A power within `error`, the error of the
    block, counts as zero, and a term is negligible if it does not count over the time
    `longest`. None if the powers do not end.
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
    """Largest value of t^k/k! e^(rate t) over t < longest; relative to e^(rate t) if that grows."""
    peak = min(longest, k / -rate) if rate < 0 and k else longest
    if k == 0 or peak == 0:
        return 1.0
    if peak == math.inf:
        return math.inf
    return math.exp(k * math.log(peak) - math.lgamma(k + 1) + min(rate, 0.0) * peak)


def real_parts_of(terms: list[np.ndarray], *, oscillates: bool) -> list[np.ndarray]:
    """The real matrices of the functions t^k e^(st) of a cluster, or of their cosines and sines."""
    found = []
    for k, term in enumerate(terms):
        part = term / math.factorial(k)
        found += [2 * part.real, -2 * part.imag] if oscillates else [part.real]
    return found
