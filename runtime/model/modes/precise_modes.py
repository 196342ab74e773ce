"""Modes in many digits, rounded once, where double precision does not tell eigenvalues apart.

Clusters of eigenvalues, in larger and larger groups, have projectors in many digits. A cluster of
few eigenvalues is then Newton's interpolation of the exponential,

    sum_k e[p_0, ..., p_k] (B - p_0) ... (B - p_(k-1)) P,

a chain of modes that is exact at all times; one of more is the series of its centre. The sum is
compared with the exponential, and the first that misses no more than rounding is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, MOST_POLES
from nonsmooth.runtime.model.factored_flows import matrices_of
from nonsmooth.runtime.model.modes.projectors import chain, exponentials_at, newton, poles_of
from nonsmooth.runtime.model.modes.simple_modes import NumericModes, snapped
from nonsmooth.runtime.model.modes.subspace_modes import (
    LONGEST_CHAIN,
    groupings,
    is_real,
    largest_term,
    leads,
    real_parts_of,
)
from nonsmooth.runtime.model.structure import mode_shapes
from nonsmooth.runtime.model.time_functions import functions_at

__all__ = ["best_modes", "precise_candidates"]

_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, math.inf)  # of the largest modulus
_HUGE = 1e100  # entry of a term that belongs to no cluster
_CLOSE = 2e-14  # error of a sum, relative to the flow, that is rounding
_LARGEST = 1e-7
_MODERATE = 1e3  # term of the flow beside which no digits are lost that count
_ANGLES = (1 / 64, 1.0, 16.0)  # radians of the fastest at which sums are compared
_LONG = 1024.0  # the same where eigenvalues were taken for equal
_TURNED = 32.0  # radians in which an exponent's rounding grows to that of the sum
_GROWTH = 100.0  # exponent beyond which nothing is compared


class Cluster(NamedTuple):
    """Eigenvalues taken together: the terms ``t^k e^(mu t)`` with their matrices."""

    centre: complex
    terms: list[np.ndarray] | None  # None where the powers do not end
    poles: tuple[complex, ...] = ()  # of a chain: its terms are Newton's products


def best_modes(matrix: np.ndarray, depends: np.ndarray, known: NumericModes | None) -> NumericModes:
    """The first modes whose sum is the exponential to rounding, else the best of all.

    `matrix` and `depends` are those of `subspace_modes`, whose result is `known`. Raises
    `InputError` if all of them miss the exponential.
    """
    values = np.linalg.eigvals(matrix)
    scale = float(np.abs(values).max())

    def candidates() -> Iterator[NumericModes]:
        if known is not None:
            yield known
        for clusters in precise_candidates(matrix, values.tolist(), scale):
            shapes, exponents, terms = _modes_of(_sorted(clusters))
            yield NumericModes(
                shapes, exponents, np.where(depends, matrices_of(terms), 0.0)[:, :-1]
            )

    best, least = known, math.inf
    for candidate in candidates():
        missed = _missed(matrix, candidate, scale)
        if missed < least:
            best, least = candidate, missed
        if least <= _CLOSE:
            break
    if best is None or not least <= _LARGEST:
        raise InputError(
            "eigenvalues of a vector field are neither equal nor apart: double precision does not"
            f" tell them from each other ({', '.join(f'{v:.6g}' for v in values)})"
        )
    return best


def _missed(matrix: np.ndarray, modes: NumericModes, scale: float) -> float:
    """Largest error of the modes' sum, relative to the flow."""
    shapes, exponents, flows = modes
    terms = matrices_of(flows)
    largest = float(np.abs(terms).max())
    if not largest < _HUGE:
        return math.inf
    # where terms are large they cancel most while the motion is still small
    small = np.geomspace(1 / max(largest, _MODERATE), _ANGLES[0], 8).tolist()
    angles = (*_ANGLES, *small) if largest > _MODERATE else _ANGLES
    if any(shape.length > 1 for shape in shapes):
        angles = (*angles, _LONG)
    worst, growth = 0.0, max(exponents[:, 0].max(), 0.0)
    times = [(angle, 2.0 ** round(math.log2(angle / scale))) for angle in angles]
    times = [(angle, t) for angle, t in times if growth * t <= _GROWTH]
    exact = exponentials_at(matrix, {t for _, t in times}) if times else {}
    for angle, t in times:
        wanted = exact[t][:-1]
        with np.errstate(over="ignore", invalid="ignore"):  # of candidates that are far off
            total = np.tensordot(np.array(functions_at(shapes, exponents, t)), terms, axes=1)
            missed = float(np.abs(total - wanted).max())
        if not math.isfinite(missed):
            return math.inf
        allowed = max(1.0, np.abs(wanted).max()) * max(1.0, angle / _TURNED)
        worst = max(worst, float(missed / allowed))
    return worst


def precise_candidates(
    matrix: np.ndarray, values: list[complex], scale: float
) -> Iterator[list[Cluster]]:
    """Sets of clusters in more digits: chains of few eigenvalues, then larger and larger groups.

    `values` are the eigenvalues of the matrix (N, N), and `scale` their largest modulus, the
    unit of distances.
    """
    yield from _chains(matrix, scale)
    for groups in groupings(values, _NEARNESS, scale):
        found = [_exact_cluster(matrix, group, groups, scale) for group in groups if leads(group)]
        if all(cluster.terms is not None for cluster in found):
            yield found


def _chains(matrix: np.ndarray, scale: float) -> Iterator[list[Cluster]]:
    """Sets of clusters that are chains of nearby eigenvalues, at larger and larger distances."""
    poles: list[complex] = snapped(np.array(poles_of(matrix)), _EPSILON * scale).tolist()
    for groups in groupings(poles, _NEARNESS, scale):
        if max(map(len, groups)) > MOST_POLES:
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
    return Cluster(poles[0], terms, poles)


def _exact_cluster(
    matrix: np.ndarray, group: list[complex], groups: list[list[complex]], scale: float
) -> Cluster:
    """A cluster whose terms are exact up to one rounding each."""
    others = [v for other in groups if other is not group for v in other]
    tiny = 8 * len(matrix) * _EPSILON * scale
    constant = min(map(abs, group)) <= tiny
    longest = LONGEST_WAIT / scale if scale else math.inf
    terms: list[np.ndarray] = []
    silent, norm = 0, 0.0
    try:
        for k, (centre, term) in enumerate(
            islice(chain(matrix, group, others, is_real(group), constant), LONGEST_CHAIN)
        ):
            centre = complex(snapped(np.array(centre), tiny))
            size = float(np.abs(term).max())
            if not size < _HUGE:
                break
            if k:
                # what the rounding of the matrix may make of zero is zero
                shifted = np.abs(matrix - centre * np.eye(len(matrix)))
                if (np.abs(term) <= 64 * _EPSILON * shifted @ np.abs(terms[-1])).all():
                    return Cluster(centre, terms)
            else:
                norm = size
            silent = (
                silent + 1 if size * largest_term(k, centre.real, longest) <= _EPSILON * norm else 0
            )
            if silent == 2 and k >= len(group):
                return Cluster(centre, terms[:-1])
            terms.append(term)
    except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
        pass
    return Cluster(0j, None)


def _modes_of(clusters: list[Cluster]) -> NumericModes:
    """Modes of clusters, with a square matrix for each function of time."""
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
        terms += real_parts_of(cluster.terms, oscillates=oscillates)
        exponents.append(cluster.centre)
        shapes.append((len(cluster.terms), oscillates, False, False))
    pairs = np.array([(pole.real, pole.imag) for pole in exponents])
    return NumericModes(mode_shapes(shapes), pairs, np.array(terms))


def _chained(
    poles: tuple[complex, ...], products: list[np.ndarray]
) -> tuple[list[tuple[tuple[int, bool, bool, bool], complex]], list[np.ndarray]]:
    """Modes of a chain of poles with their exponents, and a matrix for each function of time.

    Newton's products go on pole by pole; a pair of conjugate poles is one mode.
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


def _sorted(clusters: list[Cluster]) -> list[Cluster]:
    return sorted(clusters, key=lambda c: (c.centre != 0, c.centre.imag, c.centre.real))
