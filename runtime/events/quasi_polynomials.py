"""Quasi-polynomials: values, errors and bounds of the functions of a linear system.

Inside a configuration a boundary function is

    g(t) = Re sum_m P_m(t) e^(lambda_m t),

P_m polynomials of low degree, beside chains of exponents that nearly meet. Its derivatives are
bounded in closed form over any interval, so a search (`crossings_and_maxima`) can tell that nothing
hides between two samples.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, count, islice, zip_longest
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.leading_derivative import UNIT, Row, dot, orders, rows_of
from nonsmooth.runtime.model.engine_run import ORDERS
from nonsmooth.runtime.model.factored_flows import FactoredFlows, Flows, matrices_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import ModeShape
from nonsmooth.runtime.model.time_functions import (
    chains,
    derivative_matrix,
    function_bounds,
    functions_at,
    wave,
)

TINY = 1e-300  # what underflow may take away
_SHORT = 0.5  # radians of the fastest exponent
_ABOVE = 1 + 2.0**-40  # of a bound: its own rounding

Jet = tuple[float, float, float, float]  # g, g', g'' and the error of g

# numbers beyond all end a motion
_quiet = np.errstate(over="ignore", invalid="ignore")
_values_at, _bounds_between = _quiet(functions_at), _quiet(function_bounds)


class _JoinedModes(NamedTuple):
    """A mode by itself, or a chain of modes."""

    first: int  # number of its first complex function
    end: int  # behind that of its last one
    exponent: complex  # of the first mode
    exponents: np.ndarray  # (modes, 2)
    shapes: tuple[ModeShape, ...]  # of a chain; none for a mode by itself
    fastest: float  # largest absolute value of the exponents


class ModeFunctions:
    """The functions of time of a configuration, those of an oscillation as one complex function.

    A mode by itself has the functions t^k e^(lambda t).
    """

    def __init__(self, shapes: Sequence[ModeShape], exponents: np.ndarray) -> None:
        pairs = [list(_places_of(shape)) for shape in shapes]
        ends = [0, *accumulate(map(len, pairs))]
        # for each function the places of its real and, if it has one, its imaginary part
        self.places = [places for each in pairs for places in each]
        numbers = [complex(*exponent) for exponent in exponents.tolist()]
        self.parts = [
            _JoinedModes(
                ends[first],
                ends[last],
                numbers[first],
                exponents[first:last],
                tuple(shapes[first:last]) if chain else (),
                max(map(abs, numbers[first:last])),
            )
            for first, last, chain in chains(shapes)
        ]
        self.fastest = max(part.fastest for part in self.parts)
        # what each function's value loses in a unit of time, in its own rounding
        self.losses = [
            max(abs(rate) for rate, _ in part.exponents.tolist()) / 8
            for part in self.parts
            for _ in range(part.first, part.end)
        ]
        # factor of each function in its own derivative; then numbers of a function, of another
        # one whose derivative contains it, and the factor there
        self._own: list[complex] = []
        self._others: list[tuple[int, int, complex]] = []
        for part in self.parts:
            if part.shapes:
                self._add_chain(part)
                continue
            self._own += [part.exponent] * (part.end - part.first)
            powers = range(part.first + 1, part.end)
            self._others += [(i - 1, i, complex(i - part.first)) for i in powers]

    def _add_chain(self, part: _JoinedModes) -> None:
        """Add what the functions of a chain have in their derivatives."""
        begin, places = self.places[part.first][0], self.places[part.first : part.end]
        matrix = derivative_matrix(part.shapes, part.exponents)
        heads = [head - begin for head, *_ in places]
        turned = matrix[heads][:, heads].astype(complex)
        for row, (_, *imaginary) in enumerate(places):
            for place in imaginary:
                turned[row] += 1j * matrix[place - begin, heads]
        self._own += np.diag(turned).tolist()
        np.fill_diagonal(turned, 0)
        self._others += [
            (part.first + int(j), part.first + int(i), complex(turned[i, j]))
            for i, j in np.argwhere(turned)
        ]

    def derived(self, factors: Sequence[complex]) -> tuple[complex, ...]:
        """Factors of the functions in the derivative of their sum with some factors."""
        found = [x * own for x, own in zip(factors, self._own, strict=True)]
        for place, other, factor in self._others:
            found[place] += factors[other] * factor
        return tuple(found)

    def derived_sizes(self, sizes: Sequence[float]) -> tuple[float, ...]:
        """The same of the sums of absolute values behind the factors."""
        found = [x * abs(own) for x, own in zip(sizes, self._own, strict=True)]
        for place, other, factor in self._others:
            found[place] += sizes[other] * abs(factor)
        return tuple(found)

    def at(
        self, t: float, parts: Sequence[_JoinedModes] | None = None, *, changes: bool = False
    ) -> Iterator[tuple[int, complex, float]]:
        """Yield each function's number, value at t >= 0 and a bound on its absolute value.

        In place of values there may be changes since 0, which keep their relative accuracy over
        a short time. Angles keep their rounding error.
        """
        for part in self.parts if parts is None else parts:
            rate, frequency = part.exponent.real, part.exponent.imag
            turn = wave(part.exponent, t) if part.exponent else 1 + 0j
            head, growth = turn, math.exp(rate * t)
            if changes:
                half = math.sin(frequency * t / 2)
                head = complex(
                    math.expm1(rate * t) * turn.real / growth - 2 * half * half, turn.imag
                )
            if part.shapes:
                values = _values_at(part.shapes, part.exponents, t)
                begin, bounds = self.places[part.first][0], self.bounds(part, t, t)
                yield part.first, head, bounds[0]
                for i, bound in enumerate(bounds[1:], part.first + 1):
                    yield i, complex(*(values[place - begin] for place in self.places[i])), bound
                continue
            power = 1.0
            for i in range(part.first, part.end):
                yield i, power * head, power * growth
                power, head = power * t, turn

    def bounds(self, part: _JoinedModes, begin: float, end: float) -> list[float]:
        """Bounds on the absolute values of a part's functions between two times >= 0."""
        if part.shapes:
            first = self.places[part.first][0]
            found = _bounds_between(part.shapes, part.exponents, begin, end)
            return [float(found[self.places[i][0] - first]) for i in range(part.first, part.end)]
        rate = part.exponent.real
        growth = math.exp(rate * (begin if rate < 0 else end)) if rate else 1.0
        return [growth * end**k for k in range(part.end - part.first)]


def _places_of(shape: ModeShape) -> Iterator[tuple[int, ...]]:
    if shape.oscillates and not shape.paired:
        return zip(shape.places[::2], shape.places[1::2], strict=True)
    return zip(shape.places, strict=True)


def plain_functions(exponents: Sequence[complex], lengths: Sequence[int]) -> ModeFunctions:
    """Functions of modes by themselves: t^k e^(lambda t) for k below the length of each."""
    shapes, begin = [], 0
    for exponent, length in zip(exponents, lengths, strict=True):
        end = begin + length * (1 + bool(exponent.imag))
        shapes.append(ModeShape(length, bool(exponent.imag), tuple(range(begin, end))))
        begin = end
    return ModeFunctions(shapes, np.array([(x.real, x.imag) for x in exponents]))


@dataclass(frozen=True, eq=False)
class QuasiPolynomial:
    """The real part of a sum of complex functions of time, the first of which is 1."""

    functions: ModeFunctions
    factors: tuple[complex, ...]
    # for each factor the sum of the absolute values it was added up from: its rounding error is
    # 16 eps times that
    sizes: tuple[float, ...]

    @classmethod
    def of(
        cls, functions: ModeFunctions, values: Sequence[float], sizes: Sequence[float]
    ) -> QuasiPolynomial:
        """The sum of the real functions of time with some factors, and the sizes of these."""
        factors = (
            complex(values[place], -sum(values[other] for other in others))
            for place, *others in functions.places
        )
        added = (sum(sizes[place] for place in places) for places in functions.places)
        return cls(functions, tuple(factors), tuple(added))

    def __call__(self, t: float) -> float:
        """Value at t."""
        return self.jet(t)[0]

    def derivative(self) -> QuasiPolynomial:
        """The function g', with the rounding errors of its own factors."""
        sizes = self.functions.derived_sizes(self.sizes)
        return QuasiPolynomial(self.functions, self._order(1), sizes)

    def raised(self, by: float) -> QuasiPolynomial:
        """The function g + by, whose derivatives are those of g."""
        head, *rest = self.factors
        found = QuasiPolynomial(self.functions, (head + by, *rest), self.sizes)
        found._orders.extend(self._orders[1:])
        return found

    @cached_property
    def parts(self) -> list[_JoinedModes]:
        """The modes and chains that are not left out."""
        held = self.factors, self.sizes
        return [
            part
            for part in self.functions.parts
            if any(any(numbers[part.first : part.end]) for numbers in held)
        ]

    @cached_property
    def fastest(self) -> float:
        """Largest |lambda_m|."""
        return max((part.fastest for part in self.parts), default=0.0)

    @cached_property
    def _orders(self) -> list[tuple[complex, ...]]:
        return [self.factors]

    def _order(self, order: int) -> tuple[complex, ...]:
        """Factors of a derivative."""
        known = self._orders
        while len(known) <= order:
            known.append(self.functions.derived(known[-1]))
        return known[order]

    @cached_property
    def _terms(self) -> list[tuple[complex, complex, complex, float, float]]:
        """For each function its factors in g, g' and g'', its size, and what it loses with time."""
        parts = (*map(self._order, range(3)), self.sizes, self.functions.losses)
        return list(zip(*parts, strict=True))

    def jet(self, t: float) -> Jet:
        """Values of g, g' and g'' at t, and the rounding error of g.

        t is at least 0, in the system's unit of time.
        """
        value = slope = curvature = error = 0.0
        terms = self._terms
        for i, function, bound in self.functions.at(t, self.parts):
            zeroth, first, second, size, loss = terms[i]
            value += (zeroth * function).real
            slope += (first * function).real
            curvature += (second * function).real
            error += size * bound * (1.0 + loss * t)
        return value, slope, curvature, UNIT * error + TINY

    def rounding(self, t: float) -> float:
        """Bound on the rounding error of the value at t, in the system's unit of time."""
        return self.jet(t)[3]

    def rises(self, noise: float) -> bool:
        """Whether it rises at 0 beyond the error of its slope, where it itself errs by noise."""
        _, (slope, error) = islice(self.taylor(), 2)
        return slope > error + self.fastest * noise

    @cached_property
    def uniform(self) -> tuple[float, ...] | None:
        """Bounds on |g''| and |g'''| at all times, or None where they depend on the interval."""
        bounds = []
        for order in (2, 3):
            factors = self._order(order)
            for part in self.parts:
                if part.shapes or part.exponent.real or any(factors[part.first + 1 : part.end]):
                    return None
            bounds.append(sum(abs(factors[part.first]) for part in self.parts) * _ABOVE)
        return tuple(bounds)

    def bound(self, order: int, t: float, length: float) -> float:
        """Bound on the absolute value of the derivative of some order over [t, t + length].

        Times are in the system's unit.
        """
        if order in (2, 3) and self.uniform is not None:
            return self.uniform[order - 2]
        return sum(self._bound(order, part, t, t + length) for part in self.parts) * _ABOVE

    def _bound(self, order: int, part: _JoinedModes, begin: float, end: float) -> float:
        """What a part adds to the bound between two times."""
        factors = self._order(order)[part.first : part.end]
        if not any(factors):
            return 0.0
        bounds = self.functions.bounds(part, begin, end)
        return sum(abs(x) * bound for x, bound in zip(factors, bounds, strict=True) if x)

    def taylor(self) -> Iterator[tuple[float, float]]:
        """Yield the derivatives of order 0, 1, ... at 0, each with its rounding error.

        At 0 the first function of each mode or chain is 1, and the others are 0.
        """
        sizes = self.sizes
        for order in count():
            factors = self._order(order)
            value = sum(factors[part.first].real for part in self.parts)
            yield value, UNIT * sum(sizes[part.first] for part in self.parts)
            sizes = self.functions.derived_sizes(sizes)

    def ceiling(self, t: float) -> float:
        """Upper bound on g over [t, infinity), inf if the amplitudes give none.

        t is in the system's unit of time.
        """
        total = 0.0
        for part in self.parts:
            rate, own = part.exponent.real, self.factors[part.first : part.end]
            head = own[0].real
            if part.shapes:
                total += self._bound(0, part, 0.0, math.inf)
                total -= 0.0 if part.exponent else abs(head) - head
                continue
            if not part.exponent and not any(own[2:]):
                drift = own[1].real if len(own) > 1 else 0.0
                if drift > 0:
                    return math.inf
                total += head + (drift * t if drift else 0.0)
                continue
            if rate > 0 or (rate == 0 and any(own[1:])):
                return math.inf
            for k, c in enumerate(own):
                if c == 0:
                    continue
                peak = max(t, -k / rate) if k else t
                total += abs(c) * peak**k * (math.exp(rate * peak) if rate else 1.0)
        return total

    def last_root(self) -> float:
        """Bound on the roots if g is a polynomial, else inf.

        The bound is that of Fujiwara (1916).
        """
        if any(part.shapes or part.exponent for part in self.parts):
            return math.inf
        powers = (self.factors[part.first : part.end] for part in self.parts)
        coefficients = [sum(c.real for c in each) for each in zip_longest(*powers, fillvalue=0j)]
        while coefficients and coefficients[-1] == 0:
            coefficients.pop()
        if len(coefficients) < 2:
            return 0.0
        lead, degree = abs(coefficients[-1]), len(coefficients) - 1
        return 2.0 * max(
            math.pow(abs(c) / lead, 1 / (degree - k)) for k, c in enumerate(coefficients[:-1])
        )


def functions_along(
    functions: ModeFunctions, flow: Flows, rows: np.ndarray, state: np.ndarray, size: np.ndarray
) -> list[QuasiPolynomial]:
    """The affine functions with rows (b, N + 1) along a flow, as functions of time.

    `functions` are those that the flow has parts of. The flow starts from an extended state
    (N + 1,), whose numbers were added up from the absolute values `size`.
    """
    if isinstance(flow, FactoredFlows):
        moved, sizes = flow.parts(state), flow.sizes(size)
    else:
        moved, sizes = flow @ state, abs(flow) @ size
    parts = []
    for factors, of_rows in ((moved, rows), (sizes, abs(rows))):
        found = of_rows[:, :-1] @ factors.T
        found[:, 0] += of_rows[:, -1]  # the constant joins the first function, which is 1
        parts.append(found.tolist())
    return [QuasiPolynomial.of(functions, *each) for each in zip(*parts, strict=True)]


class BoundaryTable:
    """One boundary of a configuration, with its derivatives along the field."""

    def __init__(self, system: PiecewiseLinear, configuration: int, index: int) -> None:
        shape = system.structure.boundaries[configuration][index]
        self.row, self.reached = shape.row, shape.reached
        row, field = system.rows[shape.row], system.fields[configuration]
        self.orders, self.bounds = orders(row, field, ORDERS)


class ConfigurationTable:
    """The numbers of a configuration that a phase needs, as lists of Python numbers."""

    def __init__(self, system: PiecewiseLinear, index: int) -> None:
        shape, self._flows = system.structure, system.flows[index]
        self.functions = ModeFunctions(shape.shapes[index], system.exponents[index])
        rates, speeds = system.exponents[index][:, 0], np.hypot(*system.exponents[index].T)
        self.fastest = self.functions.fastest
        self.slowest = min(filter(None, speeds.tolist()), default=0.0)
        self.growth = max(0.0, float(rates.max()))
        self.bounded = not rates.any() and all(
            part.end - part.first == 1 and not part.shapes for part in self.functions.parts
        )
        self.boundaries = [
            BoundaryTable(system, index, b) for b in range(len(shape.boundaries[index]))
        ]
        self._rows = system.rows[[boundary.row for boundary in self.boundaries]]
        self.field = rows_of(system.fields[index])

    @cached_property
    def flow(self) -> list[list[Row]]:
        """Rows of the matrix that belongs to each function of time."""
        return [rows_of(part) for part in matrices_of(self._flows)]

    @cached_property
    def sizes(self) -> list[list[Row]]:
        """Absolute values of `flow`."""
        return [rows_of(abs(part)) for part in matrices_of(self._flows)]

    @cached_property
    def total(self) -> list[Row]:
        """Sum of `sizes` over the functions of time."""
        return rows_of(abs(matrices_of(self._flows)).sum(axis=0))

    def along(self, state: list[float], size: list[float]) -> list[QuasiPolynomial]:
        """The boundary functions in time, from an extended state and its absolute values.

        The state has N + 1 numbers, in the system's units; `size` are absolute values of as many.
        """
        at = np.array(state), np.array(size)
        return functions_along(self.functions, self._flows, self._rows, *at)

    def after(self, state: list[float], t: float) -> list[float]:
        """The extended state, N + 1 numbers, a time t later; all is in the system's units."""
        if t == 0:
            return state
        # over a short time by what changes, which keeps its relative accuracy
        short = t * self.fastest <= _SHORT
        result = state[:-1] if short else [0.0] * (len(state) - 1)
        for number, value, _ in self.functions.at(t, changes=short):
            places = self.functions.places[number]
            for place, factor in zip(places, (value.real, value.imag), strict=False):
                for i, row in enumerate(self.flow[place]):
                    result[i] += factor * dot(row, state)
        return [*result, 1.0]

    def magnitudes(self, size: list[float], t: float) -> list[float]:
        """Sums of absolute values that make up the extended state a time t later.

        `size` are the absolute values of its N + 1 numbers now; t is in the system's unit of time.
        """
        if self.bounded:
            return [*(dot(row, size) for row in self.total), 1.0]
        result = [0.0] * (len(size) - 1)
        for number, _, bound in self.functions.at(t):
            for place in self.functions.places[number]:
                for i, row in enumerate(self.sizes[place]):
                    result[i] += bound * dot(row, size)
        return [*result, 1.0]
