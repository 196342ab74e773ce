"""Modes in many digits, rounded once, where double precision does not tell eigenvalues apart.

Clusters of eigenvalues, in larger and larger groups, have projectors in many digits. With a
circle of centre m and radius r between the cluster and all other eigenvalues,

    P = (1 + ((B - m)/r)^n)^-1

is its projector in the limit of n = 2, 4, 8, ...: no eigenvalue or eigenvector is used, so that
they may be equal, defective, or anything between. The cluster is then Newton's interpolation of the
exponential,

    sum_k e[p_0, ..., p_k] (B - p_0) ... (B - p_(k-1)) P,

a chain of modes that is exact at all times. The sum is compared with the exponential, and the
first that misses no more than rounding is taken.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Any, NamedTuple

import numpy as np
from flint import acb, acb_mat, arb_mat, fmpq, fmpq_mat

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.engine_run import MOST_POLES
from nonsmooth.runtime.model.factored_flows import matrices_of
from nonsmooth.runtime.model.modes.simple_modes import NumericModes, snapped
from nonsmooth.runtime.model.modes.subspace_modes import groupings, leads
from nonsmooth.runtime.model.structure import mode_shapes
from nonsmooth.runtime.model.time_functions import functions_at

_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, math.inf)  # of the largest modulus
_HUGE = 1e100  # entry of a term that belongs to no cluster
_CLOSE = 2e-14  # error of a sum, relative to the flow, that is rounding
_LARGEST = 1e-7
_MODERATE = 1e3  # term of the flow beside which no digits are lost that count
_ANGLES = (1 / 64, 1.0, 16.0)  # radians of the fastest at which sums are compared
_LONG = 1024.0  # the same where eigenvalues were taken for equal
_SLOWEST = 2.0**-500  # rate whose radians take a time that is no infinity
_TURNED = 32.0  # radians in which an exponent's rounding grows to that of the sum
_GROWTH = 100.0  # exponent beyond which nothing is compared
_BITS = 600  # to which a projector is known: its last power may be tiny
_FEW_BITS = 256  # an exponential that loses no more than two thirds of them is known
_DOUBLE = 80  # and is rounded to 53
_MOST_BITS = 120_000
_TINY = 1e-6  # radius of a circle around equal eigenvalues, relative to the nearest other one


class Cluster(NamedTuple):
    """Eigenvalues taken together as a chain of poles, each with one of Newton's products."""

    poles: tuple[complex, ...]
    terms: list[np.ndarray]


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
        for clusters in precise_candidates(matrix, scale):
            shapes, exponents, terms = _modes_of(clusters)
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
    rate = max(scale, _SLOWEST)
    times = [(angle, 2.0 ** round(math.log2(angle / rate))) for angle in angles]
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


def precise_candidates(matrix: np.ndarray, scale: float) -> Iterator[list[Cluster]]:
    """Sets of clusters of nearby eigenvalues of a matrix (N, N), in larger and larger groups.

    `scale` is the largest modulus of an eigenvalue, the unit of distances.
    """
    poles: list[complex] = snapped(np.array(_poles_of(matrix)), _EPSILON * scale).tolist()
    for groups in groupings(poles, _NEARNESS, scale):
        if max(map(len, groups)) > MOST_POLES:
            continue
        try:
            yield [_cluster(matrix, group, groups) for group in groups if leads(group)]
        except (ValueError, ZeroDivisionError):  # no circle, or one that cuts an eigenvalue
            continue


def _cluster(matrix: np.ndarray, group: list[complex], groups: list[list[complex]]) -> Cluster:
    """Poles p of a group, with (B - p_0) ... (B - p_(k-1)) P (N, N), complex, for each of them.

    `matrix` is B, exact. Raises `ValueError` if no circle of some width has the group alone inside.
    """
    projector, bits = _projector(matrix, group, [v for g in groups if g is not group for v in g])
    # zero first, then what is real, then pairs of conjugates
    poles = tuple(sorted(group, key=lambda v: (v.imag != 0, abs(v.imag), abs(v), v.real, -v.imag)))
    terms = []
    with flint_precision(bits):
        exact, unit = acb_mat(matrix.tolist()), _unit(len(matrix))
        for pole in poles:
            terms.append(np.array(projector.tolist()).astype(complex))
            projector = ((exact - unit * acb(pole)) * projector).mid()
    return Cluster(poles, terms)


def _modes_of(clusters: list[Cluster]) -> NumericModes:
    """Modes of clusters, with a square matrix for each function of time."""
    shapes: list[tuple[int, bool, bool, bool]] = []
    exponents, terms = [], []
    for poles, products in sorted(
        clusters, key=lambda c: (c.poles[0] != 0, c.poles[0].imag, c.poles[0].real)
    ):
        modes, factors = _chained(poles, products)
        shapes += [shape for shape, _ in modes]
        exponents += [pole for _, pole in modes]
        terms += factors
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


def _poles_of(matrix: np.ndarray) -> list[complex]:
    """The eigenvalues of an exact matrix B (N, N), each to its last digit.

    They come with their conjugates and multiplicities.
    """
    with flint_precision(_BITS):
        rational = fmpq_mat([[_rational(x) for x in row] for row in matrix.tolist()])
        found: list[complex] = []
        roots: Any = rational.charpoly().numer().complex_roots()
        for root, count in roots:
            pole = complex(root)
            if pole.imag > 0:
                found += [pole, pole.conjugate()] * count
            elif pole.imag == 0:
                found += [pole] * count
    return found


def _rational(number: float) -> fmpq:
    return fmpq(*number.as_integer_ratio())


def _projector(
    matrix: np.ndarray, group: list[complex], others: list[complex]
) -> tuple[acb_mat, int]:
    """The projector of a cluster, and the bits it is computed with; ValueError without a circle."""
    middle = sum(group) / len(group)
    inside = max(abs(v - middle) for v in group)
    outside = min((abs(v - middle) for v in others), default=math.inf)
    if outside < 1.2 * inside:
        raise ValueError("no circle has the cluster alone inside")
    size, farthest = len(matrix), max((abs(v - middle) for v in others), default=0.0)
    radius = math.sqrt(max(inside, _TINY * outside) * outside) if others else 1.0
    steps = math.ceil(math.log2(_BITS / math.log2(outside / radius))) if others else 0
    bits = math.ceil(2**steps * math.log2(max(farthest / radius, 2.0))) + 2 * _BITS
    if bits > _MOST_BITS:
        raise ValueError("the circle is too narrow")
    if not others:
        return _unit(size), bits
    with flint_precision(bits):
        exact, unit = acb_mat(matrix.tolist()), _unit(size)
        power = (exact - unit * acb(middle)) * (1 / acb(radius))
        for _ in range(steps):
            power = (power * power).mid()
        # balls would widen by all that eigenvalues far apart differ
        return (unit + power).solve(unit, algorithm="approx").mid(), bits


def exponentials_at(matrix: np.ndarray, times: Collection[float]) -> dict[float, np.ndarray]:
    """The matrices e^(B t) by time, each entry to its last digit; B (N, N) is exact and real.

    Times are powers of two, as each exponential is one of half the time, squared.
    """
    for bits in (_FEW_BITS, _BITS):
        found, now = {}, min(times)
        least = math.inf
        with flint_precision(bits):
            power = arb_mat((matrix * now).tolist()).exp()
            for time in sorted(times):
                while now < time:
                    power, now = power * power, 2 * now
                entries = power.entries()
                least = min(least, *(ball.rel_accuracy_bits() for ball in entries))
                found[time] = np.array([float(ball) for ball in entries]).reshape(matrix.shape)
        if least > _DOUBLE:
            break
    return found


def _unit(size: int) -> acb_mat:
    return acb_mat(np.eye(size, dtype=int).tolist())
