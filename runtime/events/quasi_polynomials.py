"""Quasi-polynomials: values, errors and bounds of the functions of a linear system.

Inside a configuration a boundary function is

    g(t) = Re sum_m P_m(t) e^(lambda_m t),

P_m polynomials of low degree, beside chains of exponents that nearly meet. Its derivatives are
bounded in closed form over any interval, so a search (`first_crossing`) can tell that nothing
hides between two samples.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nonsmooth.runtime.model.structure import ModeShape
from nonsmooth.runtime.model.time_functions import (
    derivative_matrix,
    function_bounds,
    functions_at,
    wave,
)

__all__ = ["TINY", "UNIT", "Chain", "Coefficients", "Jet", "QuasiPolynomial"]

UNIT = 2.0**-48  # 16 eps
TINY = 1e-300  # what underflow may take away

Jet = tuple[float, float, float, float]  # g, g', g'' and the error of g
Coefficients = tuple[complex, ...]


_QUIET = np.errstate(over="ignore", invalid="ignore")  # numbers beyond all end a motion


def _horner(coefficients: Sequence[complex], t: float) -> complex:
    value: complex = 0.0
    for coefficient in reversed(coefficients):
        value = value * t + coefficient
    return value


def _slope(coefficients: Coefficients, exponent: complex) -> Coefficients:
    """Coefficients of P' + lambda P."""
    raised = [exponent * c for c in coefficients]
    for k in range(1, len(coefficients)):
        raised[k - 1] += k * coefficients[k]
    return tuple(raised)


@dataclass(frozen=True, eq=False)
class Chain:
    """A part of a quasi-polynomial: a sum of the functions of a chain of modes."""

    shapes: tuple[ModeShape, ...]
    exponents: np.ndarray  # (modes, 2)
    coefficients: np.ndarray  # (functions,)
    sizes: np.ndarray  # (functions,), rounding errors of the coefficients in units of 16 eps

    @cached_property
    def _turned(self) -> np.ndarray:
        """Matrix from the coefficients of a function to those of its derivative."""
        return derivative_matrix(self.shapes, self.exponents).T

    @cached_property
    def fastest(self) -> float:
        """Largest absolute value of the exponents."""
        return float(np.hypot(*self.exponents.T).max())

    @cached_property
    def tower(self) -> list[np.ndarray]:
        """Coefficients of the derivatives of order 0, 1, 2."""
        first = self._turned @ self.coefficients
        return [self.coefficients, first, self._turned @ first]

    @_QUIET
    def derivative(self) -> Chain:
        """The derivative, with the rounding errors of its own coefficients."""
        sizes = abs(self._turned) @ self.sizes
        return replace(self, coefficients=self.tower[1], sizes=sizes)

    @_QUIET
    def jet(self, t: float) -> Jet:
        """Value, slope and curvature at t, and the value's rounding error in units of 16 eps.

        t is at least 0, in the system's unit of time.
        """
        values = np.array(functions_at(self.shapes, self.exponents, t))
        bounds = np.array(function_bounds(self.shapes, self.exponents, t, t))
        error = float(bounds @ self.sizes) * (1.0 + float(abs(self.exponents[:, 0]).max()) * t / 8)
        value, slope, curvature = (float(values @ part) for part in self.tower)
        return value, slope, curvature, error

    @_QUIET
    def bound(self, order: int, t: float, length: float) -> float:
        """Bound on the absolute value of the derivative of some order over [t, t + length].

        Times are in the system's unit.
        """
        part = self.coefficients
        for _ in range(order):
            part = self._turned @ part
        bounds = np.array(function_bounds(self.shapes, self.exponents, t, t + length))
        return float(abs(part[part != 0]) @ bounds[part != 0])

    @_QUIET
    def taylor(self, count: int) -> tuple[list[float], list[float]]:
        """Derivatives of order 0, ..., count - 1 at 0, with their errors in units of 16 eps.

        At 0 only the first function of a chain is not 0.
        """
        values, sizes = [], []
        part, size = self.coefficients, self.sizes
        for _ in range(count):
            values.append(float(part[0]))
            sizes.append(float(size[0]))
            part, size = self._turned @ part, abs(self._turned) @ size
        return values, sizes

    def ceiling(self) -> float:
        """Upper bound at all times, inf if there is none; a constant enters with its sign."""
        head = float(self.coefficients[0])
        return self.bound(0, 0.0, math.inf) - (0.0 if self.exponents[0].any() else abs(head) - head)


@dataclass(frozen=True)
class QuasiPolynomial:
    """The function g(t) = Re sum_m P_m(t) e^(lambda_m t), plus chains."""

    exponents: tuple[complex, ...]  # lambda_m; none twice
    polynomials: tuple[Coefficients, ...]  # coefficients of each P_m, the constant first
    # for each coefficient the sum of the absolute values it was added up from: its rounding error
    # is 16 eps times that; by default its own absolute value
    sizes: tuple[tuple[float, ...], ...] = ()
    chains: tuple[Chain, ...] = ()  # added to the sum

    def __post_init__(self) -> None:
        if not self.sizes:
            sizes = tuple(tuple(map(abs, p)) for p in self.polynomials)
            object.__setattr__(self, "sizes", sizes)

    def __call__(self, t: float) -> float:
        """Value at t."""
        return self.jet(t)[0]

    def derivative(self) -> QuasiPolynomial:
        """The function g', with the rounding errors of its own coefficients."""
        return QuasiPolynomial(
            self.exponents,
            tuple(_slope(p, x) for p, x in zip(self.polynomials, self.exponents, strict=True)),
            tuple(
                tuple(map(abs, _slope(s, abs(x))))
                for s, x in zip(self.sizes, self.exponents, strict=True)
            ),
            tuple(chain.derivative() for chain in self.chains),
        )

    def raised(self, by: float) -> QuasiPolynomial:
        """The function g + by."""
        if 0 not in self.exponents:
            polynomials = ((by + 0j,), *self.polynomials)
            sizes = ((0.0,), *self.sizes)
            return QuasiPolynomial((0j, *self.exponents), polynomials, sizes, self.chains)
        place = self.exponents.index(0)
        head, *rest = self.polynomials[place]
        before, after = self.polynomials[:place], self.polynomials[place + 1 :]
        return replace(self, polynomials=(*before, (head + by, *rest), *after))

    @cached_property
    def fastest(self) -> float:
        """Largest |lambda_m|."""
        speeds = [*map(abs, self.exponents), *(chain.fastest for chain in self.chains)]
        return max(speeds, default=0.0)

    @cached_property
    def _parts(self) -> tuple[list[tuple[complex, ...]], list[tuple[complex, list[Coefficients]]]]:
        """Pure exponentials with their derivatives' factors, and the terms with powers of t."""
        plain: list[tuple[complex, ...]] = []
        powers = []
        for exponent, p, s in zip(self.exponents, self.polynomials, self.sizes, strict=True):
            if len(p) == 1:
                first = exponent * p[0]
                plain.append(
                    (exponent, p[0], first, exponent * first, s[0], abs(exponent.real) / 8)
                )
            else:
                first_, size = _slope(p, exponent), tuple(map(complex, s))
                powers.append((exponent, [p, first_, _slope(first_, exponent), size]))
        return plain, powers

    def jet(self, t: float) -> Jet:
        """Values of g, g' and g'' at t, and the rounding error of g.

        t is at least 0, in the system's unit of time.
        """
        plain, powers = self._parts
        value = slope = curvature = error = 0.0
        for exponent, c, first, second, size, speed in plain:
            if exponent:
                turn = wave(exponent, t)
                value += (c * turn).real
                slope += (first * turn).real
                curvature += (second * turn).real
                growth = abs(turn) if exponent.real else 1.0
                error += size.real * growth * (1.0 + speed.real * t)
            else:
                value += c.real
                error += size.real
        for exponent, (p, first_, second_, sizes) in powers:
            turn = wave(exponent, t)
            value += (_horner(p, t) * turn).real
            slope += (_horner(first_, t) * turn).real
            curvature += (_horner(second_, t) * turn).real
            error += abs(_horner(sizes, t) * turn) * (1.0 + abs(exponent.real) * t / 8)
        for chain in self.chains:
            parts = chain.jet(t)
            value, slope, curvature = value + parts[0], slope + parts[1], curvature + parts[2]
            error += parts[3]
        return value, slope, curvature, UNIT * error + TINY

    def rounding(self, t: float) -> float:
        """Bound on the rounding error of the value at t, in the system's unit of time."""
        return self.jet(t)[3]

    @cached_property
    def _amplitudes(self) -> list[tuple[float, tuple[tuple[float, ...], ...]]]:
        """Growth rate of each term and |coefficients| of its first derivatives' polynomials."""
        found = []
        for exponent, p in zip(self.exponents, self.polynomials, strict=True):
            tower = []
            for _ in range(4):
                tower.append(tuple(map(abs, p)))
                p = _slope(p, exponent)
            found.append((exponent.real, tuple(tower)))
        return found

    @cached_property
    def uniform(self) -> tuple[float, ...] | None:
        """Bounds on |g''| and |g'''| at all times, or None where they depend on the interval."""
        if self.chains:
            return None
        bounds = [0.0, 0.0]
        for rate, tower in self._amplitudes:
            for i in (0, 1):
                head, *rest = tower[2 + i]
                if rate != 0 or any(rest):
                    return None
                bounds[i] += head
        return tuple(b * (1 + 2.0**-40) for b in bounds)

    def bound(self, order: int, t: float, length: float) -> float:
        """Bound on the absolute value of the derivative of some order over [t, t + length].

        Times are in the system's unit.
        """
        if order in (2, 3) and self.uniform is not None:
            return self.uniform[order - 2]
        end = t + length
        total = sum(chain.bound(order, t, length) for chain in self.chains)
        for index, (rate, tower) in enumerate(self._amplitudes):
            if order < 4:
                coefficients = tower[order]
            else:
                exponent, p = self.exponents[index], self.polynomials[index]
                for _ in range(order):
                    p = _slope(p, exponent)
                coefficients = tuple(map(abs, p))
            if not any(coefficients):
                continue
            size = coefficients[0] if len(coefficients) == 1 else 0.0
            if len(coefficients) > 1:
                size = _horner(coefficients, end).real if any(coefficients[1:]) else coefficients[0]
            total += size * math.exp(rate * (t if rate < 0 else end)) if rate else size
        return total * (1 + 2.0**-40)

    def taylor(self, count: int) -> tuple[list[float], list[float]]:
        """Derivatives of order 0, ..., count - 1 at 0, and the rounding error of each."""
        values, errors = [0.0] * count, [0.0] * count
        for exponent, p, s in zip(self.exponents, self.polynomials, self.sizes, strict=True):
            speed = abs(exponent)
            size: Coefficients = s
            for k in range(count):
                values[k] += p[0].real
                errors[k] += UNIT * abs(size[0])
                p, size = _slope(p, exponent), _slope(size, speed)
        for chain in self.chains:
            for k, (own, rounds) in enumerate(zip(*chain.taylor(count), strict=True)):
                values[k] += own
                errors[k] += UNIT * rounds
        return values, errors

    def ceiling(self, t: float) -> float:
        """Upper bound on g over [t, infinity), inf if the amplitudes give none.

        t is in the system's unit of time.
        """
        total = sum(chain.ceiling() for chain in self.chains)
        for exponent, p in zip(self.exponents, self.polynomials, strict=True):
            rate = exponent.real
            if exponent == 0 and not any(p[2:]):
                drift = p[1].real if len(p) > 1 else 0.0
                if drift > 0:
                    return math.inf
                total += p[0].real + (drift * t if drift else 0.0)
                continue
            if rate > 0 or (rate == 0 and any(p[1:])):
                return math.inf
            for k, c in enumerate(p):
                if c == 0:
                    continue
                peak = max(t, -k / rate) if k else t
                total += abs(c) * peak**k * (math.exp(rate * peak) if rate else 1.0)
        return total

    def last_root(self) -> float:
        """Bound on the roots if g is a polynomial, else inf.

        The bound is that of Fujiwara (1916).
        """
        if any(self.exponents) or self.chains:
            return math.inf
        longest = max(map(len, self.polynomials), default=0)
        coefficients = [
            sum(p[k].real for p in self.polynomials if k < len(p)) for k in range(longest)
        ]
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        if len(coefficients) < 2:
            return 0.0
        lead, degree = abs(coefficients[-1]), len(coefficients) - 1
        return 2.0 * max(
            math.pow(abs(c) / lead, 1 / (degree - k)) for k, c in enumerate(coefficients[:-1])
        )
