"""Modes of a configuration from its numbers, where its flow has no closed form.

With Y = (y, 1) the motion y' = A y + b is Y' = B Y, and

    exp(B t) = sum_c e^(mu_c t) sum_k t^k/k! (B - mu_c)^k P_c,

a sum over clusters of eigenvalues with centres mu_c and spectral projectors P_c. A cluster is a
single eigenvalue wherever its projector is small enough to be known well; eigenvalues that are
equal, or so near each other that their projectors cancel, are taken together. The powers of a
cluster end at its size where its eigenvalues are equal, and a little later where they are not.

The sum is compared with the exponential. Where it misses more than rounding (clusters of very
different sizes, eigenvalues neither equal nor apart) the clusters are found in many digits, and
rounded once. A cluster of few eigenvalues is then Newton's interpolation of the exponential,

    sum_k e[p_0, ..., p_k] (B - p_0) ... (B - p_(k-1)) P,

a chain of modes that is exact at all times; one of more is the series.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from itertools import islice
from typing import NamedTuple

import numpy as np
from scipy.linalg import matrix_balance, schur, solve_sylvester

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.projectors import chain, exponential_of, newton, poles_of
from nonsmooth.runtime.model.structure import ModeShape, mode_shapes
from nonsmooth.runtime.model.time_functions import functions_at

__all__ = ["NumericModes", "numeric_modes"]

_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, math.inf)  # of the largest modulus
_LARGE = 30.0  # norm of a projector: as much, squared, may be lost of the digits
_FAR = 0.05  # of the largest modulus: no digits are lost
_CLOSE = 2e-14  # error of a sum, relative to the flow, that is rounding
_LARGEST = 1e-7
_MODERATE = 1e3  # term of the flow beside which no digits are lost that count
_HUGE = 1e100  # entry of a power that belongs to no cluster
_ANGLES = (1 / 64, 1.0, 16.0)  # radians of the fastest at which sums are compared
_LONG = 1024.0  # the same where eigenvalues were taken for equal that turn
_TURNED = 32.0  # radians in which an exponent's rounding grows to that of the sum
_GROWTH = 100.0  # exponent beyond which nothing is compared
_BITS = 320
_LONGEST_CHAIN = 24
_LONGEST_NEWTON = 7


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
    poles: tuple[complex, ...] = ()  # of a chain: its terms are Newton's products


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
    shapes, exponents, terms = _modes_of(_decomposed(scaled, units))
    # zero exactly, and not but for rounding, where a state, as of a forcing, does not depend on
    # another one: modes are polynomials in the matrix
    depends = np.linalg.matrix_power((whole != 0) | np.eye(size + 1, dtype=bool), size)[:size]
    flows = np.where(depends, (units[:, None] * terms / units)[:, :size], 0.0)
    for array in (exponents, flows):
        array.flags.writeable = False
    return NumericModes(shapes, exponents, flows)


def _modes_of(clusters: list[_Cluster]) -> NumericModes:
    """Modes of clusters, with a square matrix for each function."""
    shapes: list[tuple[int, bool, bool, bool]] = []
    exponents, terms = [], []
    for cluster in clusters:
        assert cluster.terms is not None
        if cluster.poles:
            modes, factors = _chained(cluster.poles, cluster.terms)
            shapes += [shape for shape, _ in modes]
            exponents += [pole for _, pole in modes]
            terms += factors
            continue
        oscillates = cluster.centre.imag > 0
        for k, term in enumerate(cluster.terms):
            part = term / math.factorial(k)
            terms += [2 * part.real, -2 * part.imag] if oscillates else [part.real]
        exponents.append(cluster.centre)
        shapes.append((len(cluster.terms), oscillates, False, False))
    pairs = np.array([(pole.real, pole.imag) for pole in exponents])
    return NumericModes(mode_shapes(shapes), pairs, np.array(terms))


def _chained(
    poles: tuple[complex, ...], products: list[np.ndarray]
) -> tuple[list[tuple[tuple[int, bool, bool, bool], complex]], list[np.ndarray]]:
    """Modes of a chain, with their exponents, and a matrix for each function.

    Products go on pole by pole; a pair of conjugates is one mode.
    """
    real = any(pole.imag <= 0 for pole in poles)
    head = 1 if poles[0].imag else sum(pole == poles[0] for pole in poles)
    modes: list[tuple[tuple[int, bool, bool, bool], complex]] = []
    terms: list[np.ndarray] = []
    if head > 1 or not poles[0].imag:
        modes.append(((head, False, False, False), poles[0]))
        terms += [products[k].real / math.factorial(k) for k in range(head)]
    place = len(terms)
    while place < len(poles):
        pole, term = poles[place], products[place]
        paired = real and pole.imag > 0
        modes.append(((1, pole.imag > 0, bool(modes), paired), pole))
        if paired:  # (B - p) = (B - s) - iw, and the second pole leaves the real part
            terms += [term.real, products[place + 1].real]
            place += 2
            continue
        terms += [2 * term.real, -2 * term.imag] if pole.imag else [term.real]
        place += 1
    return modes, terms


def _decomposed(matrix: np.ndarray, units: np.ndarray) -> list[_Cluster]:
    """Clusters that sum up to the exponential of a matrix, given in units of its coordinates.

    Those in double precision if they do so to rounding, else the best of those in more digits.
    """
    values, right = np.linalg.eig(matrix)
    scale = float(np.abs(values).max())
    found = _apart(values, right, scale)
    largest = _largest_term(found, units) if found is not None else 0.0
    if found is not None and _gap(values) > _FAR * scale and largest <= _MODERATE:
        return _sorted(found)
    # where terms are large they cancel most while the motion is still small
    small = np.geomspace(1 / max(largest, _MODERATE), _ANGLES[0], 8).tolist()
    angles = (*_ANGLES, *small) if largest > _MODERATE else _ANGLES
    found = found or _together(matrix, values, scale)
    if not scale and found is not None:
        return _sorted(found)
    # eigenvalues taken for zero that are not have grown too little to be told from a rounding
    if any(cluster.centre != 0 and len(cluster.terms or ()) > 1 for cluster in found or ()):
        angles = (*angles, _LONG)
    if found is not None and _missed(matrix, units, found, scale, angles) <= _CLOSE:
        return _sorted(found)
    best, least = found, math.inf
    for candidate in (found, *_candidates(matrix, values.tolist(), scale)):
        if candidate is not None:
            missed = _missed(matrix, units, candidate, scale, angles)
            if missed < least:
                best, least = candidate, missed
            if least <= _CLOSE:
                break
    if best is None or not least <= _LARGEST:
        raise InputError(
            "eigenvalues of a vector field are neither equal nor apart: double precision does not"
            f" tell them from each other ({', '.join(f'{v:.6g}' for v in values)})"
        )
    return _sorted(best)


def _largest_term(clusters: list[_Cluster], units: np.ndarray) -> float:
    """Largest entry of the clusters' matrices in the coordinates' own units."""
    return max(
        float(np.abs(units[:, None] * term / units).max())
        for cluster in clusters
        for term in cluster.terms or ()
    )


def _missed(
    matrix: np.ndarray,
    units: np.ndarray,
    clusters: list[_Cluster],
    scale: float,
    angles: tuple[float, ...],
) -> float:
    """Largest error of the clusters' sum in the coordinates' own units, relative to the flow."""
    shapes, exponents, terms = _modes_of(_sorted(clusters))
    worst, growth = 0.0, max(exponents[:, 0].max(), 0.0)
    for angle in angles:
        t = 2.0 ** round(math.log2(angle / scale))  # products with it are exact
        if growth * t > _GROWTH:
            continue
        wanted = units[:, None] * exponential_of(matrix * t) / units
        with np.errstate(over="ignore", invalid="ignore"):  # of candidates that are far off
            total = np.tensordot(np.array(functions_at(shapes, exponents, t)), terms, axes=1)
            missed = float(np.abs(units[:, None] * total / units - wanted).max())
        if not math.isfinite(missed):
            return math.inf
        allowed = max(1.0, np.abs(wanted).max()) * max(1.0, angle / _TURNED)
        worst = max(worst, float(missed / allowed))
    return worst


def _candidates(
    matrix: np.ndarray, values: list[complex], scale: float
) -> Iterator[list[_Cluster]]:
    """Clusters in more digits, eigenvalue by eigenvalue, then further and further together."""
    single = _precise(matrix, scale)
    if single is not None:
        yield single
    yield from _chains(matrix, scale)
    known: list[list[list[complex]]] = []
    for nearness in _NEARNESS:
        groups = _groups(values, nearness * scale if scale else math.inf)
        if groups in known:
            continue
        known.append(groups)
        found = [_exact_cluster(matrix, group, groups, scale) for group in groups
                 if _leads(group)]  # fmt: skip
        if all(cluster.terms is not None for cluster in found):
            yield found


def _chains(matrix: np.ndarray, scale: float) -> Iterator[list[_Cluster]]:
    """Chains of the eigenvalues that are near each other, further and further."""
    tiny = _EPSILON * scale
    poles = [
        complex(p.real if abs(p.real) > tiny else 0.0, p.imag if abs(p.imag) > tiny else 0.0)
        for p in poles_of(matrix)
    ]
    known: list[list[list[complex]]] = []
    for nearness in _NEARNESS:
        groups = _groups(poles, nearness * scale if scale else math.inf)
        if groups in known or max(map(len, groups)) > _LONGEST_NEWTON:
            continue
        known.append(groups)
        try:
            yield [_newton_cluster(matrix, group, groups) for group in groups if _leads(group)]
        except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
            continue


def _newton_cluster(
    matrix: np.ndarray, group: list[complex], groups: list[list[complex]]
) -> _Cluster:
    others = [v for other in groups if other is not group for v in other]
    # zero first, then what is real, then pairs of conjugates
    poles = tuple(sorted(group, key=lambda v: (v.imag != 0, abs(v.imag), abs(v), -v.imag)))
    terms = newton(matrix, group, others, list(poles))
    return _Cluster(poles[0], float(np.abs(terms[0]).max()), terms, poles)


def _leads(group: list[complex]) -> bool:
    """Whether a group is not the conjugate of one that is taken."""
    return _is_real(group) or sum(group).imag > 0


def _is_real(group: list[complex]) -> bool:
    return {v.conjugate() for v in group} == set(group)


def _exact_cluster(
    matrix: np.ndarray, group: list[complex], groups: list[list[complex]], scale: float
) -> _Cluster:
    """A cluster of which all terms are rounded once."""
    others = [v for other in groups if other is not group for v in other]
    constant = min(map(abs, group)) <= 8 * len(matrix) * _EPSILON * scale
    longest = LONGEST_WAIT / scale if scale else math.inf
    terms: list[np.ndarray] = []
    silent, norm = 0, 0.0
    try:
        for k, (centre, term) in enumerate(
            islice(chain(matrix, group, others, _is_real(group), constant), _LONGEST_CHAIN)
        ):
            centre = _snapped(centre, len(matrix), scale)
            size = float(np.abs(term).max())
            if not size < _HUGE:
                break
            if k:
                # what the rounding of the matrix may make of zero is zero
                shifted = np.abs(matrix - centre * np.eye(len(matrix)))
                if (np.abs(term) <= 64 * _EPSILON * shifted @ np.abs(terms[-1])).all():
                    return _Cluster(centre, norm, terms)
            else:
                norm = size
            silent = (
                silent + 1 if size * _largest(k, centre.real, longest) <= _EPSILON * norm else 0
            )
            if silent == 2 and k >= len(group):
                return _Cluster(centre, norm, terms[:-1])
            terms.append(term)
    except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
        pass
    return _Cluster(0j, math.inf, None)


def _sorted(clusters: list[_Cluster]) -> list[_Cluster]:
    return sorted(clusters, key=lambda c: (c.centre != 0, c.centre.imag, c.centre.real))


def _gap(values: np.ndarray) -> float:
    """Smallest distance of two eigenvalues."""
    gaps = np.abs(values[:, None] - values) + np.diag(np.full(len(values), np.inf))
    return float(gaps.min())


def _together(matrix: np.ndarray, values: np.ndarray, scale: float) -> list[_Cluster] | None:
    """Clusters whose projectors are smallest, among those whose powers end."""
    best: list[_Cluster] | None = None
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
    return best


def _apart(values: np.ndarray, right: np.ndarray, scale: float) -> list[_Cluster] | None:
    """A cluster for each eigenvalue, from eigenvectors; None where some are near each other."""
    if _gap(values) <= _NEARNESS[0] * scale:
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
        if _leads(group):
            yield _cluster(matrix, group, _is_real(group), scale)


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
