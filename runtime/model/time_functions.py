"""Functions of time of a configuration's modes: values, derivatives and bounds.

A mode has the functions t^k e^(st) cos(wt) and t^k e^(st) sin(wt). Poles that nearly meet are a
chain of modes, each of which goes on from the one in front: its function is the divided
difference

    e[p_0, ..., p_k] = (e[p_0, ..., p_(k-1)] - e[p_1, ..., p_k]) / (p_0 - p_k),    e[p] = e^(pt),

of the poles up to its own, which is t^k/k! e^(pt) where all are equal. So the factors of the
functions are no larger than the motion, however near each other the poles are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from nonsmooth.runtime.model.structure import ModeShape

__all__ = ["chains", "derivative_matrix", "function_bounds", "functions_at"]

_TERMS = 22  # of an exponential series whose argument is at most 1

_Poles = tuple[complex, ...]


def chains(shapes: Sequence[ModeShape]) -> Iterator[tuple[int, int, bool]]:
    """First and last place of modes that go on from each other, and whether they are a chain.

    A mode by itself is none, unless it stands for a pair of poles.
    """
    starts = [place for place, shape in enumerate(shapes) if not shape.joined]
    for first, end in pairwise([*starts, len(shapes)]):
        yield first, end, end - first > 1 or shapes[first].paired


def functions_at(
    shapes: Sequence[ModeShape], exponents: np.ndarray, times: Any, lib: Any = np
) -> list[Any]:
    """Values of a configuration's functions of time.

    Parameters
    ----------
    shapes : sequence of ModeShape
    exponents : array (..., modes, 2)
    times : array (...)
    lib : arithmetic with `sin`, `cos` and `exp` of arrays
        Chains have values in double precision only.

    Returns
    -------
    list of arrays (...)
    """
    found: list[Any] = []
    for first, end, chain in chains(shapes):
        if chain:
            found += _chain_at(shapes[first:end], exponents[..., first:end, :], times)
            continue
        shape = shapes[first]
        rate, frequency = exponents[..., first, 0], exponents[..., first, 1]
        power = lib.exp(rate * times)
        for _ in range(shape.length):
            if shape.oscillates:
                found += [power * f(frequency * times) for f in (lib.cos, lib.sin)]
            else:
                found.append(power)
            power = power * times
    return found


def derivative_matrix(shapes: Sequence[ModeShape], exponents: np.ndarray) -> np.ndarray:
    """Matrix (functions, functions) that gives the derivatives of the functions of time."""
    size = sum(len(shape.places) for shape in shapes)
    start = shapes[0].places[0]
    matrix = np.zeros((size, size))
    for index, (shape, (rate, frequency)) in enumerate(zip(shapes, exponents, strict=True)):
        places = [place - start for place in shape.places]
        step = 2 if shape.oscillates else 1
        for count, place in enumerate(places):
            matrix[place, place] = rate
            if count >= step:
                matrix[place, places[count - step]] = count // step
        if shape.oscillates:
            for even, odd in zip(places[::2], places[1::2], strict=True):
                matrix[even, odd] = -(frequency**2) if shape.paired else -frequency
                matrix[odd, even] = 1.0 if shape.paired else frequency
        if shape.joined:
            before = [place - start for place in shapes[index - 1].places]
            if not shapes[index - 1].oscillates:
                matrix[places[0], before[-1]] = 1 / math.factorial(len(before) - 1)
            elif shapes[index - 1].paired:
                matrix[places[0], before[-1]] = 1.0
            else:
                matrix[places[0], before[-2]] = matrix[places[1], before[-1]] = 1.0
    return matrix


def function_bounds(
    shapes: Sequence[ModeShape], exponents: np.ndarray, begin: Any, end: Any
) -> list[Any]:
    """Bounds of the functions' absolute values between two times, which may be arrays."""
    found: list[Any] = []
    for first, last, chain in chains(shapes):
        rate = float(exponents[first:last, 0].max())
        growth = np.exp(rate * (begin if rate < 0 else end)) if rate else 1.0
        for shape, poles, both in _poles_of(shapes[first:last], exponents[first:last]):
            if chain and (shape.joined or shape.paired):
                bounds = [growth * _bound(p, end) for p in (poles, both)]
                found += bounds[: len(shape.places)]
            else:
                for k in range(shape.length):
                    found += [growth * end**k] * (2 if shape.oscillates else 1)
    return found


def _poles_of(
    shapes: Sequence[ModeShape], exponents: np.ndarray
) -> Iterator[tuple[ModeShape, _Poles, _Poles]]:
    """Of each mode of a chain the poles up to its own, and up to its conjugate in a pair."""
    poles: _Poles = ()
    for shape, (rate, frequency) in zip(shapes, exponents.tolist(), strict=True):
        pole = complex(rate, frequency)
        poles = (*poles, *[pole] * shape.length)
        both = (*poles, pole.conjugate()) if shape.paired else poles
        yield shape, poles, both
        poles = both


def _chain_at(shapes: Sequence[ModeShape], exponents: np.ndarray, times: Any) -> list[np.ndarray]:
    lead = np.broadcast_shapes(exponents.shape[:-2], np.shape(times))
    times = np.broadcast_to(np.asarray(times, dtype=float), lead)
    if exponents.ndim > 2:  # point by point
        points = np.broadcast_to(exponents, (*lead, *exponents.shape[-2:]))
        count = sum(len(shape.places) for shape in shapes)
        table = np.empty((count, *lead))
        for place in np.ndindex(lead):
            table[(slice(None), *place)] = _chain_at(shapes, points[place], times[place])
        return list(table)
    flat, found = times.ravel(), []
    known: dict[_Poles, np.ndarray] = {}
    for shape, poles, both in _poles_of(shapes, exponents):
        if not shape.joined and not shape.paired:
            pole = poles[0]
            value = _exponential(pole, flat)
            values = [value * flat**k for k in range(shape.length)]
        else:
            values = [_difference(poles, flat, known)]
        for value in values:
            found.append(value.real)
            if shape.paired:
                found.append(_difference(both, flat, known).real)
            elif shape.oscillates:
                found.append(value.imag)
    return [value.reshape(lead) for value in found]


def _exponential(pole: complex, times: np.ndarray) -> np.ndarray:
    return np.asarray(np.exp(pole.real * times) * np.exp(1j * pole.imag * times))


def _farthest(poles: _Poles) -> tuple[float, int, int]:
    """The largest distance of two poles, and their places."""
    return max((abs(poles[i] - poles[j]), i, j) for i, j in combinations(range(len(poles)), 2))


def _difference(poles: _Poles, times: np.ndarray, known: dict[_Poles, np.ndarray]) -> np.ndarray:
    """The divided difference: of the farthest poles, or by its series where none is far."""
    if poles in known:
        return known[poles]
    if len(poles) == 1:
        found = _exponential(poles[0], times)
    else:
        distance, i, j = _farthest(poles)
        far = distance * times > 1
        found = np.empty(times.shape, dtype=complex)
        if far.any():
            one, two = (
                _difference((*poles[:k], *poles[k + 1 :]), times, known)[far] for k in (j, i)
            )
            found[far] = (one - two) / (poles[i] - poles[j])
        if not far.all():
            found[~far] = _series(poles, times[~far])
    known[poles] = found
    return found


def _series(poles: _Poles, times: np.ndarray) -> np.ndarray:
    """The same by the exponential series about the middle of the poles."""
    middle = sum(poles) / len(poles)
    order = len(poles) - 1
    unit = max(abs(pole - middle) for pole in poles) or 1.0  # whose powers may overflow
    # complete homogeneous polynomials of the distances, degree by degree
    degrees = np.zeros(_TERMS, dtype=complex)
    degrees[0] = 1
    for pole in poles:
        for k in range(1, _TERMS):
            degrees[k] += (pole - middle) / unit * degrees[k - 1]
    total = np.zeros(times.shape, dtype=complex)
    for k in range(_TERMS - 1, -1, -1):
        total = total * (unit * times / (order + k + 1)) + degrees[k]
    return np.asarray(_exponential(middle, times) * total * times**order / math.factorial(order))


def _bound(poles: _Poles, times: Any) -> Any:
    """Bound on the divided difference's absolute value beside the growth of its fastest pole."""
    order = len(poles) - 1
    bound = times**order / math.factorial(order)
    if order:
        distance, i, j = _farthest(poles)
        if distance:
            both = (_bound((*poles[:k], *poles[k + 1 :]), times) for k in (i, j))
            bound = np.minimum(bound, sum(both) / distance)
    return bound
