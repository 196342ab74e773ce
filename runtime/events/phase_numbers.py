"""The numbers of one phase as Python lists, and the clock: what the Python engine steps with."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from nonsmooth.runtime.events.leading_derivative import derivatives, dot, square
from nonsmooth.runtime.events.quasi_polynomials import ModeFunctions, QuasiPolynomial
from nonsmooth.runtime.model.engine_run import ORDERS
from nonsmooth.runtime.model.factored_flows import FactoredFlows, matrices_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear

__all__ = ["BoundaryTable", "Clock", "ConfigurationTable", "Row", "orders", "rows_of"]

_SHORT = 0.5  # radians of the fastest exponent

Row = tuple[float, ...]


def rows_of(array: np.ndarray) -> list[Row]:
    """Rows of an array (n, m) as tuples of Python numbers."""
    return [tuple(row) for row in array.tolist()]


def orders(row: np.ndarray, field: np.ndarray, count: int) -> tuple[list[Row], list[Row]]:
    """Derivatives of an affine function along a field, order by order, and their sizes.

    The row is (N + 1,), the field (N, N + 1). Both results are `count` rows of N + 1 numbers,
    those of the function first; sizes are sums of absolute values.
    """
    matrix = square(field)
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite judges no start
        values = list(derivatives(row, matrix, count))
        bounds = list(derivatives(abs(row), abs(matrix), count))
    return rows_of(np.array(values)), rows_of(np.array(bounds))


class BoundaryTable:
    """One boundary of a configuration: coefficients by functions of time, and derivatives."""

    def __init__(self, system: PiecewiseLinear, configuration: int, index: int) -> None:
        shape = system.structure.boundaries[configuration][index]
        row, flow = system.rows[shape.row], system.flows[configuration]
        if isinstance(flow, FactoredFlows):
            values, sizes = flow.rows(row[:-1])
        else:
            values = np.einsum("i,fij->fj", row[:-1], flow)
            sizes = np.einsum("i,fij->fj", abs(row[:-1]), abs(flow))
        values[0, -1] += row[-1]  # the constant joins the first function, which is 1
        sizes[0, -1] += abs(row[-1])
        self.row, self.reached = shape.row, shape.reached
        self.values, self.sizes = rows_of(values), rows_of(sizes)
        self.orders, self.bounds = orders(row, system.fields[configuration], ORDERS)


class ConfigurationTable:
    """The numbers of a configuration that a phase needs, as lists of Python numbers."""

    def __init__(self, system: PiecewiseLinear, index: int) -> None:
        shape, self._flows = system.structure, system.flows[index]
        self.functions = ModeFunctions(shape.shapes[index], system.exponents[index])
        rates, speeds = system.exponents[index][:, 0], np.hypot(*system.exponents[index].T)
        self.fastest = float(speeds.max())
        self.slowest = min(filter(None, speeds.tolist()), default=0.0)
        self.growth = max(0.0, float(rates.max()))
        self.bounded = not rates.any() and all(
            part.end - part.first == 1 and not part.shapes for part in self.functions.parts
        )
        self.boundaries = [
            BoundaryTable(system, index, b) for b in range(len(shape.boundaries[index]))
        ]
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

    def function(
        self, boundary: BoundaryTable, state: list[float], size: list[float]
    ) -> QuasiPolynomial:
        """A boundary function in time, from an extended state and its absolute values.

        The state has N + 1 numbers, in the system's units; `size` are absolute values of as many.
        """
        values = [dot(row, state) for row in boundary.values]
        sizes = [dot(row, size) for row in boundary.sizes]
        return QuasiPolynomial.of(self.functions, values, sizes)

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


class Clock:
    """A time as an unevaluated sum of two numbers."""

    def __init__(self) -> None:
        self.time, self.rest = 0.0, 0.0

    def advance(self, step: float) -> None:
        """Let a time pass, in the system's unit.

        What a sum loses to rounding is kept (Knuth, 1969).
        """
        total = self.time + step
        part = total - self.time
        lost = (self.time - (total - part)) + (step - part)
        rest = self.rest + lost
        self.time = total + rest
        self.rest = rest - (self.time - total)

    def before(self, until: float) -> float:
        """The time that is left until another one, in the system's unit."""
        return (until - self.time) - self.rest
