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

from nonsmooth.runtime.core.exponentials.in_doubles import divided_differences
from nonsmooth.runtime.model.structure import ModeShape

_SPLIT = 2.0**27 + 1  # halves a double's digits

_Poles = tuple[complex, ...]


def chains(shapes: Sequence[ModeShape]) -> Iterator[tuple[int, int, bool]]:
    """Yield the first and the end place of modes that are joined, and whether they are a chain.

    A mode by itself is no chain, unless it stands for a pair of poles.
    """
    starts = [place for place, shape in enumerate(shapes) if not shape.joined]
    for first, end in pairwise([*starts, len(shapes)]):
        yield first, end, end - first > 1 or shapes[first].paired


def function_orders(shapes: Sequence[ModeShape]) -> list[int]:
    """The power of time that is each function's unit.

    It is k for t^k and for a divided difference of k + 1 poles.
    """
    found: list[int] = []
    for first, end, chain in chains(shapes):
        poles = 0
        for shape in shapes[first:end]:
            if shape.paired:
                found += [poles, poles + 1]
            elif chain and shape.joined:
                found += [poles] * len(shape.places)
            else:
                found += [k for k in range(shape.length) for _ in range(1 + shape.oscillates)]
            poles += shape.length + shape.paired
    return found


def functions_at(
    shapes: Sequence[ModeShape], exponents: np.ndarray, times: Any, lib: Any = np
) -> list[Any]:
    """Values (...) of a configuration's functions of time, one array for each.

    `exponents` are (..., modes, 2), `times` (...) in the system's unit. `lib` is an arithmetic
    with `sin`, `cos` and `exp` of arrays; chains have values in double precision only.
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
    """Matrix (functions, functions) that gives the derivatives of the functions of time.

    `exponents` (modes, 2) are rate and angular frequency of each mode.
    """
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
    """Bounds of the absolute value of each function of time between two times.

    `exponents` (modes, 2) are rate and angular frequency of each mode. Times may be arrays; they
    are at least 0 and in the system's unit.
    """
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


def wave(exponent: complex, t: float) -> complex:
    """The number e^(lambda t), whose error does not grow with the angle w t.

    The product w t is split into its rounded value and the rounding error (Dekker, 1971).
    """
    w = exponent.imag
    if w == 0:
        return complex(math.exp(exponent.real * t))
    angle = w * t
    a, b = _SPLIT * w, _SPLIT * t
    w_high, t_high = a - (a - w), b - (b - t)
    w_low, t_low = w - w_high, t - t_high
    rest = ((w_high * t_high - angle) + w_high * t_low + w_low * t_high) + w_low * t_low
    cosine, sine = math.cos(angle), math.sin(angle)
    found = complex(cosine - rest * sine, sine + rest * cosine)
    return math.exp(exponent.real * t) * found if exponent.real else found


def _poles_of(
    shapes: Sequence[ModeShape], exponents: np.ndarray
) -> Iterator[tuple[ModeShape, _Poles, _Poles]]:
    """Yield each mode of a chain with the poles up to it, and the same with its conjugate added.

    The two differ only for a pair of conjugate poles.
    """
    poles: _Poles = ()
    for shape, (rate, frequency) in zip(shapes, exponents.tolist(), strict=True):
        pole = complex(rate, frequency)
        poles = (*poles, *[pole] * shape.length)
        both = (*poles, pole.conjugate()) if shape.paired else poles
        yield shape, poles, both
        poles = both


def _chain_at(shapes: Sequence[ModeShape], exponents: np.ndarray, times: Any) -> list[np.ndarray]:
    lead = np.broadcast_shapes(exponents.shape[:-2], np.shape(times))
    flat = np.broadcast_to(np.asarray(times, dtype=float), lead).ravel()
    values = exponents[..., 0] + 1j * exponents[..., 1]
    values = np.broadcast_to(values, (*lead, len(shapes))).reshape(-1, len(shapes)).T
    poles: list[np.ndarray] = []
    ends: list[int] = []  # of each mode, without its conjugate
    for shape, value in zip(shapes, values, strict=True):
        poles += [value] * shape.length
        ends.append(len(poles) - 1)
        if shape.paired:
            poles.append(value.conj())
    differences = divided_differences(np.array(poles), flat)
    found = []
    for shape, end in zip(shapes, ends, strict=True):
        own = [differences[end]]
        if not shape.joined and not shape.paired:
            own = [differences[0] * flat**k for k in range(shape.length)]
        for value in own:
            found.append(value.real)
            if shape.paired:
                found.append(differences[end + 1].real)
            elif shape.oscillates:
                found.append(value.imag)
    return [value.reshape(lead) for value in found]


def _farthest(poles: _Poles) -> tuple[float, int, int]:
    """The largest distance between two poles, and their places."""
    return max((abs(poles[i] - poles[j]), i, j) for i, j in combinations(range(len(poles)), 2))


def _bound(poles: _Poles, times: Any) -> Any:
    """Bound on a divided difference's absolute value, relative to its fastest pole's growth."""
    order = len(poles) - 1
    bound = times**order / math.factorial(order)
    if order:
        distance, i, j = _farthest(poles)
        if distance:
            both = (_bound((*poles[:k], *poles[k + 1 :]), times) for k in (i, j))
            bound = np.minimum(bound, sum(both) / distance)
    return bound
