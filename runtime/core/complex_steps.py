"""Derivatives by complex steps: a tiny imaginary part comes out as a derivative.

Nothing is subtracted, so that they are exact up to rounding, in doubles and in any number of
digits (Squire and Trapp, SIAM Rev. 40, 1998).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import Floats, Mpmath

_TINY = 1e-30


def step_of(lib: Mpmath | None) -> Any:
    """The imaginary part that stands for a unit of change.

    `lib` is None in double precision; an `Mpmath` has to work with twice the digits that
    derivatives need.
    """
    return _TINY if lib is None else lib.mp.mpf(10) ** (-lib.mp.dps // 2)


def stepped(values: Any, rates: Any, lib: Mpmath | None) -> np.ndarray:
    """Complex values whose tiny imaginary parts stand for the rates of change.

    `values` and `rates` broadcast. `lib` is None in double precision; with an `Mpmath` the
    values are complex numbers of mpmath.
    """
    if lib is None:
        return np.asarray(values + 1j * _TINY * np.asarray(rates))
    return np.asarray(values + lib.mp.mpc(0, step_of(lib)) * np.asarray(rates, dtype=object))


def real_parts(values: Any) -> np.ndarray:
    """Real parts of an array of doubles, complex numbers or numbers of mpmath."""
    found = np.asarray(values)
    return np.asarray(_real(found) if found.dtype == object else found.real.copy())


def imaginary_parts(values: Any, lib: Mpmath | None) -> np.ndarray:
    """Rates of change, from the imaginary parts of what came out of a step.

    `lib` is None in double precision.
    """
    found = np.asarray(values)
    return np.asarray((found.imag if lib is None else _imaginary(found)) / step_of(lib))


_real = np.frompyfunc(lambda number: number.real, 1, 1)
_imaginary = np.frompyfunc(lambda number: number.imag, 1, 1)


class ComplexSteps:
    """An arithmetic whose functions carry tiny imaginary parts along; see `Floats`."""

    def __init__(self, lib: Floats | Mpmath) -> None:
        self._lib = lib
        self.sin, self.cos, self.sqrt, self.pi = lib.sin, lib.cos, lib.sqrt, lib.pi
        self.rational, self.constant = lib.rational, lib.constant

    def exponential_difference(self, k: int, t: Any, *factors: Sequence[Any]) -> Any:
        """A divided difference of exponentials and, to first order, its change.

        With G^(k) the change follows from dG^(k)/dc_j = -G^(k + j), taken with the factor of
        c_j once more, and from dG^(k)/dt = G^(k + 1). Each factor holds the coefficients of a
        monic polynomial, from the constant up.
        """
        of = self._lib.exponential_difference
        plain = [[_real_part(c) for c in factor] for factor in factors]
        time = _real_part(t)
        found = of(k, time, *plain)
        change: Any = 0
        for place, factor in enumerate(factors):
            for j, coefficient in enumerate(factor):
                if _moves(coefficient):
                    change = change - coefficient.imag * of(k + j, time, *plain, plain[place])
        if _moves(t):
            change = change + t.imag * self._rate(k, time, plain)
        if isinstance(change, int):
            return found
        unit = 1j if isinstance(self._lib, Floats) else self._lib.mp.j
        return found + unit * change

    def _rate(self, k: int, time: Any, factors: list[list[Any]]) -> Any:
        """G^(k + 1), by the differential equation of G where k + 1 is the order of that."""
        of = self._lib.exponential_difference
        product: list[Any] = [1]
        for factor in factors:
            monic = [*factor, 1]
            longer: list[Any] = [0] * (len(product) + len(factor))
            for i, a in enumerate(product):
                for j, b in enumerate(monic):
                    longer[i + j] = longer[i + j] + a * b
            product = longer
        degree = len(product) - 1
        if k + 1 < degree:
            return of(k + 1, time, *factors)
        return -sum(c * of(j, time, *factors) for j, c in enumerate(product[:-1]))


def _real_part(number: Any) -> Any:
    return number if isinstance(number, int) else number.real


def _moves(number: Any) -> bool:
    return not isinstance(number, int | float) and bool(np.any(number.imag != 0))
