"""The engine in Python: from transition to transition by closed flows and guaranteed crossings.

It is the reference of the compiled engine and takes its place on machines without a compiler.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from operator import mul
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.piecewise import PiecewiseLinear, TransitionShape
from nonsmooth.runtime.quasi import (
    ORDERS,
    UNIT,
    Crossing,
    QuasiPolynomial,
    Series,
    Start,
    first_crossing,
)
from nonsmooth.runtime.run import LONGEST_WAIT, Grazing, Run, Status

__all__ = ["run"]

MOST_AT_ONCE = 100  # transitions in a row without time between them
_SERIES_UP_TO = 0.5  # radians of the fastest exponent over which a state comes by its series

Row = tuple[float, ...]


def _dot(row: Sequence[float], vector: Sequence[float]) -> float:
    return sum(map(mul, row, vector))


def _rows(array: np.ndarray) -> list[Row]:
    return [tuple(map(float, row)) for row in array]


def _orders(row: np.ndarray, field: np.ndarray, count: int) -> tuple[list[Row], list[Row]]:
    """An affine function's derivatives along a field, order by order, and their sizes."""
    size = len(row)
    matrix = np.zeros((size, size))
    matrix[:-1] = field
    values, bounds = [np.asarray(row, dtype=float)], [abs(np.asarray(row, dtype=float))]
    for _ in range(count - 1):
        values.append(values[-1] @ matrix)
        bounds.append(bounds[-1] @ abs(matrix))
    return _rows(np.array(values)), _rows(np.array(bounds))


class _Boundary:
    """One boundary of a configuration: its row over the functions of time, and along the field."""

    def __init__(self, system: PiecewiseLinear, configuration: int, index: int) -> None:
        shape = system.structure.boundaries[configuration][index]
        row, flow = system.rows[shape.row], system.flows[configuration]
        values = np.einsum("i,fij->fj", row[:-1], flow)
        sizes = np.einsum("i,fij->fj", abs(row[:-1]), abs(flow))
        values[0, -1] += row[-1]  # the constant joins the first function, which is 1
        sizes[0, -1] += abs(row[-1])
        self.row, self.reached = shape.row, shape.reached
        self.values, self.sizes = _rows(values), _rows(sizes)
        self.orders, self.bounds = _orders(row, system.fields[configuration], ORDERS)


class _Configuration:
    """What a phase needs, as lists of Python numbers."""

    def __init__(self, system: PiecewiseLinear, index: int) -> None:
        shape, flow = system.structure, system.flows[index]
        self.modes = [
            (complex(*map(float, exponent)), mode)
            for exponent, mode in zip(system.exponents[index], shape.modes[index], strict=True)
        ]
        self.fastest = max(abs(exponent) for exponent, _ in self.modes)
        self.bounded = all(x.real == 0 and mode.length == 1 for x, mode in self.modes)
        self.boundaries = [_Boundary(system, index, b) for b in range(len(shape.boundaries[index]))]
        self.flow = [_rows(part) for part in flow]
        self.sizes = [_rows(abs(part)) for part in flow]
        self.total = _rows(abs(flow).sum(axis=0))
        self.field = _rows(system.fields[index])

    def function(
        self, boundary: _Boundary, state: list[float], size: list[float]
    ) -> QuasiPolynomial:
        """A boundary function in time, from an extended state and its absolute values."""
        values = [_dot(row, state) for row in boundary.values]
        sizes = [_dot(row, size) for row in boundary.sizes]
        exponents, polynomials, weights = [], [], []
        for exponent, mode in self.modes:
            places = mode.places
            if mode.oscillates:
                pairs = list(zip(places[::2], places[1::2], strict=True))
                polynomial = [complex(values[a], -values[b]) for a, b in pairs]
                weight = [sizes[a] + sizes[b] for a, b in pairs]
            else:
                polynomial = [complex(values[a]) for a in places]
                weight = [sizes[a] for a in places]
            while weight and weight[-1] == 0:
                weight.pop()
                polynomial.pop()
            if weight:
                exponents.append(exponent)
                polynomials.append(tuple(polynomial))
                weights.append(tuple(weight))
        return QuasiPolynomial(tuple(exponents), tuple(polynomials), tuple(weights))

    def after(self, state: list[float], t: float) -> list[float]:
        """The extended state a time t later."""
        if t == 0:
            return state
        if t * self.fastest <= _SERIES_UP_TO:
            return self._series(state, t)
        result = [0.0] * (len(state) - 1)
        for factor, _, place in self._factors(t):
            for i, row in enumerate(self.flow[place]):
                result[i] += factor * _dot(row, state)
        return [*result, 1.0]

    def _series(self, state: list[float], t: float) -> list[float]:
        """By the Taylor series: what changes little keeps its relative accuracy."""
        result, term, last = state[:], state, 0.0
        for k in range(1, 60):
            term = [t / k * _dot(row, term) for row in self.field] + [last]
            if not any(term):
                break
            grown = [a + b for a, b in zip(result, term, strict=True)]
            if k > len(state) and grown == result:
                break
            result = grown
        return result

    def magnitudes(self, size: list[float], t: float) -> list[float]:
        """Sums of absolute values that make up the extended state a time t later."""
        if self.bounded:
            return [*(_dot(row, size) for row in self.total), 1.0]
        result = [0.0] * (len(size) - 1)
        for _, weight, place in self._factors(t):
            for i, row in enumerate(self.sizes[place]):
                result[i] += weight * _dot(row, size)
        return [*result, 1.0]

    def _factors(self, t: float) -> list[tuple[float, float, int]]:
        """Values and weights of the functions of time, with their places."""
        found = []
        for exponent, mode in self.modes:
            wave, growth, power = cmath.exp(exponent * t), math.exp(exponent.real * t), 1.0
            step = 2 if mode.oscillates else 1
            for place in mode.places[::step]:
                found.append((power * wave.real, power * growth, place))
                if mode.oscillates:
                    found.append((power * wave.imag, power * growth, place + 1))
                power *= t
        return found


class _Watch(NamedTuple):
    """A boundary function of a phase and how it starts."""

    index: int
    boundary: _Boundary
    function: QuasiPolynomial
    start: Start


class _Event(NamedTuple):
    """The end of a phase: time (None: none), reached boundaries, error of the time."""

    time: float | None
    boundaries: frozenset[int]
    error: float
    grazings: tuple[tuple[float, int, float], ...]
    never: bool


class _Stepper:
    """The rules, over tables that are made when a configuration is first entered."""

    def __init__(self, system: PiecewiseLinear) -> None:
        self.system, self.structure = system, system.structure
        self.configurations: dict[int, _Configuration] = {}
        self.pairs: dict[tuple[int, int], tuple[list[Row], list[Row]]] = {}
        self.resets = [_rows(reset) for reset in system.resets]

    def configuration(self, index: int) -> _Configuration:
        if index not in self.configurations:
            self.configurations[index] = _Configuration(self.system, index)
        return self.configurations[index]

    def watches(
        self, configuration: int, state: list[float], error: float, left_out: frozenset[int]
    ) -> list[_Watch]:
        """Boundary functions of a phase, each start judged; what slides along is left out."""
        table, size = self.configuration(configuration), [abs(x) for x in state]
        found = []
        for index, boundary in enumerate(table.boundaries):
            if index in left_out:
                continue
            function = table.function(boundary, state, size)
            start = _start(boundary, function, state, size, error)
            if start.sign:
                found.append(_Watch(index, boundary, function, start))
        return found

    def event(self, watches: list[_Watch], window: float) -> _Event:
        """First event of a phase within a window."""
        at_once = frozenset(w.index for w in watches if w.start.sign > 0)
        if at_once:
            return _Event(0.0, at_once, 0.0, (), False)
        best: tuple[Crossing, _Watch] | None = None
        touched: list[tuple[float, int, float]] = []
        never, overflow, end = True, False, window
        for watch in watches:
            # no longer than what is left of LONGEST_WAIT, lest the sum of both pass it
            fastest = watch.function.fastest
            limit = min(end, LONGEST_WAIT / fastest) if fastest else end
            try:
                crossing = first_crossing(
                    watch.function, limit, reached=watch.boundary.reached, start=watch.start
                )
            except OverflowError:
                overflow = True
                continue
            never = never and crossing.never
            touched += [(time, watch.index, depth) for time, depth in crossing.touched]
            if crossing.time is not None and (best is None or crossing.time < best[0].time):
                best = crossing, watch
                end = min(window, crossing.time + 2 * crossing.error)
        if best is None:
            if overflow:
                raise OverflowError
            return _Event(None, frozenset(), 0.0, tuple(sorted(touched)), never)
        crossing, trigger = best
        time, error = crossing.time or 0.0, crossing.error
        together = {w.index for w in watches if w is trigger or _together(w, time, error)}
        passed = tuple(sorted(t for t in touched if t[0] <= time and t[1] not in together))
        return _Event(time, frozenset(together), error, passed, False)

    def transition(
        self,
        configuration: int,
        event: frozenset[int],
        state: list[float],
        sizes: list[float],
        error: float,
    ) -> TransitionShape | None:
        """The first transition declared for a set of boundaries whose conditions hold."""
        shapes = self.structure.boundaries[configuration]
        rows = {shapes[b].row for b in event}
        for transition in self.structure.transitions[configuration]:
            if transition.boundaries == event and all(
                self._positive(row, along, state, sizes, error, row in rows) is holds
                for row, along, holds in transition.conditions
            ):
                return transition
        return None

    def _positive(
        self,
        row: int,
        along: int,
        state: list[float],
        sizes: list[float],
        error: float,
        is_zero: bool,
    ) -> bool:
        """Whether the first nonzero derivative of a row along a configuration is positive."""
        if (row, along) not in self.pairs:
            count = len(state) + 1
            found = _orders(self.system.rows[row], self.system.fields[along], count)
            self.pairs[row, along] = found
        values, bounds = self.pairs[row, along]
        following = _dot(values[0], state)
        for order in range(len(values) - 1):
            value, following = following, _dot(values[order + 1], state)
            if order == 0 and is_zero:
                continue
            if abs(value) > UNIT * _dot(bounds[order], sizes) + error * abs(following):
                return value > 0
        return False

    def reset(self, transition: TransitionShape, state: list[float]) -> list[float]:
        return [*(_dot(row, state) for row in self.resets[transition.reset]), 1.0]


def _start(
    boundary: _Boundary,
    function: QuasiPolynomial,
    state: list[float],
    size: list[float],
    error: float,
) -> Start:
    """Judge the start of a boundary function by its derivatives along the field.

    They err by the rounding of the modes, and by the error of the time at which the state was
    found.
    """
    value, following = _dot(boundary.orders[0], state), _dot(boundary.orders[1], state)
    rounding = UNIT * sum(s[0] for s in function.sizes)
    if abs(value) > rounding + error * abs(following):
        return Start(1 if value > 0 else -1, None)
    count = len(boundary.values)
    _, errors = function.taylor(count)
    for order in range(1, count):
        value, following = following, _dot(boundary.orders[order + 1], state)
        if abs(value) > errors[order] + error * abs(following):
            if value > 0:
                return Start(1, None)
            values = [_dot(row, state) for row in boundary.orders]
            sizes = [_dot(row, size) for row in boundary.bounds]
            return Start(-1, Series(order, values, sizes, function.fastest))
    return Start(0, None)


def _together(watch: _Watch, time: float, error: float) -> bool:
    """Whether a boundary is reached at the time of another one's event."""
    series = watch.start.series
    early = series is not None and time <= series.radius
    value, slope, _, rounding = (series if series and early else watch.function).jet(time)
    if abs(value) > rounding + error * abs(slope):
        return False
    certain = watch.function.derivative().rounding(time)
    return slope > certain or (watch.boundary.reached and slope >= -certain)


class _Clock:
    """A time as an unevaluated sum of two numbers."""

    def __init__(self) -> None:
        self.time, self.rest = 0.0, 0.0

    def advance(self, step: float) -> None:
        total = self.time + step
        part = total - self.time
        lost = (self.time - (total - part)) + (step - part)
        rest = self.rest + lost
        self.time = total + rest
        self.rest = rest - (self.time - total)

    def before(self, until: float) -> float:
        """What is left until a time."""
        return (until - self.time) - self.rest


def run(
    system: PiecewiseLinear,
    state: Sequence[float] | np.ndarray,
    configuration: int,
    until: float = math.inf,
    transitions: int | None = None,
) -> Run:
    """The motion from a state, transition by transition.

    Parameters
    ----------
    system : PiecewiseLinear
        In double precision.
    state : array (N,)
        Physical: positions, then velocities.
    configuration : int
    until : float
        Time at which it ends, at the latest; inf for no such time.
    transitions : int, optional
        Number of transitions after which it ends.

    Returns
    -------
    Run
    """
    stepper, clock = _Stepper(system), _Clock()
    extended = [*map(float, state), 1.0]
    entries = [(0.0, configuration, extended, extended, 0)]
    grazings: list[Grazing] = []
    error, immediate, left_out = 0.0, 0, frozenset[int]()

    def ended(status: Status, end: float) -> Run:
        times, configurations, before, states, sets = zip(*entries, strict=True)
        return Run(
            np.array(times),
            np.array(configurations, dtype=np.int32),
            np.array(before)[:, :-1],
            np.array(states)[:, :-1],
            np.array(sets, dtype=np.int32),
            tuple(grazings),
            status,
            end,
        )

    while True:
        if not all(map(math.isfinite, extended)):
            return ended(Status.OVERFLOW, clock.time)
        if transitions is not None and len(entries) > transitions:
            return ended(Status.TRANSITIONS, clock.time)
        if immediate > MOST_AT_ONCE:
            return ended(Status.IMMEDIATE, clock.time)
        remaining = clock.before(until)
        if remaining < 0:
            return ended(Status.UNTIL, until)
        table = stepper.configuration(configuration)
        horizon = LONGEST_WAIT / table.fastest if table.fastest else math.inf
        window = min(horizon, remaining)
        try:
            watches = stepper.watches(configuration, extended, error, left_out)
            event = stepper.event(watches, window)
            dwell = window if event.time is None else event.time
            for time, boundary, depth in event.grazings:
                grazings.append(Grazing(clock.time + time, configuration, boundary, depth))
            if event.time is None:
                if window == remaining and until < math.inf:
                    return ended(Status.UNTIL, until)
                if until == math.inf:
                    wait = 0.0 if event.never else dwell
                    return ended(Status.QUIET, clock.time + wait)
                if event.never:
                    return ended(Status.UNTIL, until)
                # the same phase from here on, within reach of the guarantee again
                watched = {w.index for w in watches}
                left_out = frozenset(range(len(table.boundaries))) - watched
                extended, error = table.after(extended, dwell), 4 * math.ulp(dwell)
                clock.advance(dwell)
                continue
            if dwell > 0:
                error = event.error
            sizes = table.magnitudes([abs(x) for x in extended], dwell)
            before = table.after(extended, dwell)
        except OverflowError:
            return ended(Status.OVERFLOW, clock.time)
        clock.advance(dwell)
        transition = stepper.transition(configuration, event.boundaries, before, sizes, error)
        if transition is None:
            return ended(Status.UNDECLARED, clock.time)
        extended = stepper.reset(transition, before)
        configuration, left_out = transition.target, frozenset()
        immediate = 0 if dwell > 0 else immediate + 1
        mask = sum(1 << b for b in event.boundaries)
        entries.append((clock.time, configuration, before, extended, mask))
