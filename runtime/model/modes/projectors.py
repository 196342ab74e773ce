"""Spectral projectors of clusters of eigenvalues, in as many digits as they need.

With a circle of centre m and radius r between the cluster and all other eigenvalues,

    P = (1 + ((B - m)/r)^n)^-1

is its projector in the limit of n = 2, 4, 8, ...: no eigenvalue or eigenvector is used, so that
they may be equal, defective, or anything between.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Any

import numpy as np
from flint import acb, acb_mat, arb_mat, fmpq, fmpq_mat

from nonsmooth.runtime.core.values import flint_precision

__all__ = ["chain", "exponentials_at", "newton", "poles_of"]

_BITS = 600  # to which a projector is known: its last power may be tiny
_FEW_BITS = 256  # an exponential that loses no more than two thirds of them is known
_DOUBLE = 80  # and is rounded to 53
_MOST_BITS = 120_000
_TINY = 1e-6  # radius of a circle around equal eigenvalues, relative to the nearest other one


def chain(
    matrix: np.ndarray, group: list[complex], others: list[complex], real: bool, constant: bool
) -> Iterator[tuple[complex, np.ndarray]]:
    """Yield the centre mu of a cluster of eigenvalues of B with (B - mu)^k P for k = 0, 1, ....

    `matrix` (N, N) is B, exact, and `group` and `others` are its approximate eigenvalues. `real`
    says that the cluster has each eigenvalue's conjugate, and `constant` that mu is zero. The
    terms are complex. Raises `ValueError` if no circle of some width has only the cluster inside.
    """
    projector, bits = _projector(matrix, group, others)
    with flint_precision(bits):
        exact, unit = acb_mat(matrix.tolist()), _unit(len(matrix))
        centre = (exact * projector).trace() / len(group)
        centre = acb(0) if constant else acb(centre.real.mid(), 0 if real else centre.imag.mid())
        shifted, term = exact - unit * centre, projector
    while True:
        yield complex(centre), np.array(term.tolist()).astype(complex)
        with flint_precision(bits):
            term = (shifted * term).mid()


def newton(
    matrix: np.ndarray, group: list[complex], others: list[complex], poles: list[complex]
) -> list[np.ndarray]:
    """The products (B - p_0) ... (B - p_(k-1)) P (N, N), complex, one for each of the poles p.

    k is 0, 1, ..., and the poles are the nodes of Newton's interpolation. `matrix` is B, exact,
    and `group` and `others` are its approximate eigenvalues. Raises `ValueError` as `chain` does.
    """
    projector, bits = _projector(matrix, group, others)
    terms = []
    with flint_precision(bits):
        exact, unit = acb_mat(matrix.tolist()), _unit(len(matrix))
        for pole in poles:
            terms.append(np.array(projector.tolist()).astype(complex))
            projector = ((exact - unit * acb(pole)) * projector).mid()
    return terms


def poles_of(matrix: np.ndarray) -> list[complex]:
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
        return (unit + power).inv().mid(), bits


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
