"""Divided differences of e^(lambda t): the functions of time of every linear motion, in doubles.

    G^(k)(t) = d^k/dt^k L^-1[1/(chi_1 ... chi_m)](t) = (lambda^k e^(lambda t))[all roots],

where chi_i = s^d + c_(d-1) s^(d-1) + ... + c_0 is given by (c_0, ..., c_(d-1)). Entire in t and in
all coefficients: roots may be equal, nearly equal, zero or complex. Roots far from each other are
separated by the recursion of divided differences (of the farthest pair, so that nothing cancels
but what is small already), roots near each other are summed by Taylor's series about their mean
(McCurdy, Ng and Parlett, 1984). `nonsmooth.runtime.core.exponentials.in_balls` does it rigorously.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np

from nonsmooth.runtime.core.exponentials.matrices import eigenvalues

_NEAR = 3.0  # distance times time up to which roots are taken together
_TERMS = 34  # of an exponential series whose argument is at most that


def exponential_difference(k: int, t: Any, *factors: Sequence[Any]) -> Any:
    """Time derivative of order k of L^-1[1/prod chi_i](t), in doubles.

    k is at least 0 and less than the degree of the product. Each factor holds the
    coefficients of a monic polynomial chi_i from the constant up, without the leading one.
    Arrays of coefficients broadcast, with the time too.

    Examples
    --------
    >>> float(exponential_difference(1, 0.0, (4.0, 0.0)))  # cos 2t
    1.0
    """
    degrees = [len(factor) for factor in factors]
    numbers = np.broadcast_arrays(*(np.asarray(c, float) for f in factors for c in f), t)
    lead, flat = numbers[0].shape, [np.ravel(number) for number in numbers]
    roots: list[np.ndarray] = []
    with np.errstate(all="ignore"):
        for place, degree in enumerate(degrees):
            begin = sum(degrees[:place])
            roots += _roots_of(flat[begin : begin + degree])
        return _derivative(k, np.stack(roots), flat[-1].astype(float)).reshape(lead)[()]


def _derivative(k: int, roots: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Divided differences (points,) of lambda^k e^(lambda t) over roots (degree, points).

    They follow by Leibniz' rule from those of e^(lambda t).
    """
    count = len(roots)
    # the slowest last: its powers multiply what is largest
    order = np.argsort(-np.abs(roots), axis=0, kind="stable")
    roots = np.take_along_axis(roots, order, axis=0)
    table = _Differences(roots, times)
    everywhere = np.arange(len(times))
    total = np.zeros(len(times), dtype=complex)
    for left in range(min(k, count - 1) + 1):  # roots that the exponential is without
        power = _complete(roots[count - left - 1 :], k - left)[-1]
        total += power * table.at((1 << (count - left)) - 1, everywhere)
    return np.asarray(total.real)


def _complete(roots: np.ndarray, degree: int) -> list[np.ndarray]:
    """Complete homogeneous symmetric polynomials of the roots, from degree 0 up."""
    found = [np.ones(roots.shape[1], dtype=complex)]
    found += [np.zeros(roots.shape[1], dtype=complex) for _ in range(degree)]
    for root in roots:
        for k in range(1, degree + 1):
            found[k] = found[k] + root * found[k - 1]
    return found


def _roots_of(factor: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Complex roots of a monic polynomial at each point, one array (points,) a root.

    The factor holds the coefficients (points,) from the constant up, without the leading
    one.
    """
    if len(factor) == 1:
        return [-factor[0] + 0j]
    if len(factor) == 2:
        return _quadratic_roots(*factor)
    if len(factor) % 2 == 0 and not any(np.any(odd) for odd in factor[1::2]):
        # undamped: roots of the squares, which stay real where they are
        found = [np.sqrt(square + 0j) for square in _roots_of(factor[::2])]
        return [*found, *(-root for root in found)]
    return list(_companion_roots(np.stack(factor)))


def _quadratic_roots(constant: np.ndarray, linear: np.ndarray) -> list[np.ndarray]:
    half = -linear / 2
    square = half * half - constant
    root = np.sqrt(np.abs(square))
    # the larger of real roots, and of the smaller one what the product leaves
    large = np.where(half < 0, half - root, half + root)
    small = np.divide(constant, large, out=np.zeros_like(large), where=large != 0)
    apart = square > 0
    return [
        np.where(apart, large, half + 1j * root),
        np.where(apart, small, half - 1j * root),
    ]


def _companion_roots(factor: np.ndarray) -> np.ndarray:
    """Roots (degree, points), from companion matrices that are scaled to norms of about 1."""
    degree, points = factor.shape
    powers = degree - np.arange(degree)[:, None]
    size = (np.abs(factor) ** (1 / powers)).max(axis=0)
    unit = np.where((size > 0) & np.isfinite(size), size, 1.0)
    matrices = np.zeros((points, degree, degree))
    # large roots first: so the QR method keeps the digits of small ones
    matrices[:, range(1, degree), range(degree - 1)] = 1.0
    matrices[:, 0, :] = (-factor / unit**powers)[::-1].T
    return np.asarray(unit * eigenvalues(matrices).T)


def divided_differences(poles: np.ndarray, times: np.ndarray) -> list[np.ndarray]:
    """Divided differences of e^(pt) over the first pole, the first two, and so on.

    The poles are complex, (count, points); times and each of the results are (points,).
    """
    table = _Differences(poles, times)
    everywhere = np.arange(len(times))
    return [table.at((2 << place) - 1, everywhere) for place in range(len(poles))]


def _farthest_pair(poles: Any) -> tuple[Any, Any, Any]:
    """The largest distance of two poles, and the places of the two, arrays (points,).

    The poles are complex numbers, or arrays (points,) of them.
    """
    largest = np.full(np.shape(poles[0]), -1.0)
    first, second = np.zeros(largest.shape, dtype=int), np.zeros(largest.shape, dtype=int)
    for i, j in combinations(range(len(poles)), 2):
        distance = np.abs(poles[i] - poles[j])
        farther = distance >= largest
        largest = np.where(farther, distance, largest)
        first, second = np.where(farther, i, first), np.where(farther, j, second)
    return largest, first, second


class _Differences:
    """Divided differences over sets of poles, each computed once at each point.

    A set is a bit mask of the places of its poles.
    """

    def __init__(self, poles: np.ndarray, times: np.ndarray) -> None:
        self.poles, self.times = poles, times
        self._known: dict[int, tuple[np.ndarray, np.ndarray]] = {}

    def at(self, mask: int, points: np.ndarray) -> np.ndarray:
        """Divided differences over one set of poles, at some points."""
        if mask not in self._known:
            count = len(self.times)
            self._known[mask] = np.zeros(count, dtype=bool), np.empty(count, dtype=complex)
        known, values = self._known[mask]
        missing = points[~known[points]]
        if len(missing):
            values[missing] = self._difference(mask, missing)
            known[missing] = True
        return np.asarray(values[points])

    def _difference(self, mask: int, points: np.ndarray) -> np.ndarray:
        """Divided differences by the recursion at the two farthest poles, or by the series.

        The series serves where no two poles are far from each other.
        """
        places = [place for place in range(len(self.poles)) if mask >> place & 1]
        poles, times = self.poles[:, points][places], self.times[points]
        if len(places) == 1:
            return _exponential(poles[0], times)
        distance, first, second = _farthest_pair(poles)
        far = distance * np.abs(times) > _NEAR
        found = np.empty(times.shape, dtype=complex)
        for i, j in combinations(range(len(places)), 2):
            here = far & (first == i) & (second == j)
            if here.any():
                one, two = (self.at(mask & ~(1 << places[place]), points[here]) for place in (j, i))
                found[here] = (one - two) / (poles[i, here] - poles[j, here])
        if not far.all():
            found[~far] = _series(poles[:, ~far], times[~far])
        return found


def _exponential(pole: Any, times: np.ndarray) -> np.ndarray:
    return np.asarray(np.exp(pole.real * times) * np.exp(1j * pole.imag * times))


def _series(poles: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Divided differences of e^(lambda t), by the exponential series about the mean pole."""
    middle = sum(poles) / len(poles)
    order = len(poles) - 1
    unit = np.abs(poles - middle).max(axis=0)  # whose powers may overflow
    unit = np.where(unit > 0, unit, 1.0)
    degrees = _complete((poles - middle) / unit, _TERMS - 1)
    total = np.zeros(times.shape, dtype=complex)
    for k in range(_TERMS - 1, -1, -1):
        total = total * (unit * times / (order + k + 1)) + degrees[k]
    return np.asarray(_exponential(middle, times) * total * times**order / math.factorial(order))
