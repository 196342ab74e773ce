"""The engine in Python: from transition to transition by closed flows and guaranteed crossings.

It is the reference of the compiled engine and takes its place on machines without a compiler.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import islice
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.crossings_and_maxima import Series, Start, first_crossing
from nonsmooth.runtime.events.leading_derivative import Located, dot, leading, rows_of
from nonsmooth.runtime.events.quasi_polynomials import (
    BoundaryTable,
    ConfigurationTable,
    QuasiPolynomial,
)
from nonsmooth.runtime.events.transition_choice import Choice, Decider
from nonsmooth.runtime.model.boundary_sets import mask_of, mask_type
from nonsmooth.runtime.model.engine_run import (
    FARTHEST_END,
    GROWTH,
    LARGEST_STATE,
    LONGEST_QUIET,
    LONGEST_WAIT,
    MOST_AT_ONCE,
    Grazing,
    Run,
    Status,
)
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import TransitionShape

_RESOLUTION = 2.0**-104  # of a time that is the sum of two numbers


class _Clock:
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


class _WatchedFunction(NamedTuple):
    """A boundary function of a phase and how it starts."""

    place: int
    boundary: BoundaryTable
    function: QuasiPolynomial
    start: Start


class _Event(NamedTuple):
    """The end of a phase, with the boundaries that are reached, and the grazings before it."""

    time: float | None  # since the beginning of the phase, None if the phase has no end
    boundaries: frozenset[int]
    located: frozenset[int]  # those of the boundaries whose functions vanish there
    error: float  # of the time
    grazings: tuple[tuple[float, int, float], ...]
    never: bool  # no boundary is ever reached


class _Stepper:
    """The rules of stepping, with tables that are made when a configuration is first entered."""

    def __init__(self, system: PiecewiseLinear) -> None:
        self.system, self.structure = system, system.structure
        self.configurations: dict[int, ConfigurationTable] = {}
        self.resets = [rows_of(reset) for reset in system.resets]
        self.decider = Decider(system.structure, system.fields, system.rows, system.resets)

    def configuration(self, index: int) -> ConfigurationTable:
        if index not in self.configurations:
            self.configurations[index] = ConfigurationTable(self.system, index)
        return self.configurations[index]

    def watches(
        self,
        configuration: int,
        state: list[float],
        size: list[float],
        error: float,
        left_out: frozenset[int],
        zero: frozenset[int],
    ) -> list[_WatchedFunction]:
        """Boundary functions that are watched in a phase, with their judged starts.

        A function that stays zero is left out. `size` has, for each coordinate, the sum of the
        absolute values of its terms; `zero` has the rows that are exactly zero despite
        rounding.
        """
        table = self.configuration(configuration)
        found = []
        along = zip(table.boundaries, table.along(state, size), strict=True)
        for index, (boundary, function) in enumerate(along):
            if index in left_out:
                continue
            start = _start(boundary, function, state, size, error, boundary.row in zero)
            if start.sign:
                found.append(_WatchedFunction(index, boundary, function, start))
        return found

    def event(self, watches: list[_WatchedFunction], window: float) -> _Event:
        """First event of a phase within a window."""
        at_once = frozenset(w.place for w in watches if w.start.sign > 0)
        if at_once:
            beyond = {w.place for w in watches if w.start.beyond}
            return _Event(0.0, at_once, at_once - beyond, 0.0, (), False)
        best: tuple[float, float, _WatchedFunction] | None = None
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
            touched += [(time, watch.place, depth) for time, depth in crossing.touched]
            if crossing.time is not None and crossing.time < (best[0] if best else math.inf):
                best = crossing.time, crossing.error, watch
                end = min(window, crossing.time + 2 * crossing.error)
        if best is None:
            if overflow:
                raise OverflowError
            return _Event(None, frozenset(), frozenset(), 0.0, tuple(sorted(touched)), never)
        time, error, trigger = best
        together = {w.place for w in watches if w is trigger or _together(w, time, error)}
        passed = tuple(sorted(t for t in touched if t[0] <= time and t[1] not in together))
        return _Event(time, frozenset(together), frozenset(together), error, passed, False)

    def choice(self, configuration: int, event: _Event, at: Located) -> Choice:
        """The transition, or the lack of one, after the boundaries of an event are reached."""
        shapes = self.structure.boundaries[configuration]
        zero = frozenset(shapes[b].row for b in event.located)
        return self.decider.choice(configuration, event.boundaries, at, zero)

    def reset(self, transition: TransitionShape, state: list[float]) -> list[float]:
        return [*(dot(row, state) for row in self.resets[transition.reset]), 1.0]

    def kept(self, transition: TransitionShape, rows: Iterable[int]) -> frozenset[int]:
        """Those of the rows whose values a reset does not change."""
        found, reset = self.system.rows, self.system.resets[transition.reset]
        reset = np.vstack([reset, np.append(np.zeros(len(reset)), 1.0)])
        return frozenset(r for r in rows if np.array_equal(found[r] @ reset, found[r]))

    def reset_sizes(self, transition: TransitionShape, sizes: list[float]) -> list[float]:
        rows = self.resets[transition.reset]
        return [*(dot([abs(x) for x in row], sizes) for row in rows), 1.0]


def _start(
    boundary: BoundaryTable,
    function: QuasiPolynomial,
    state: list[float],
    size: list[float],
    error: float,
    zero: bool,
) -> Start:
    """Judge the start of a boundary function by its derivatives along the field.

    Their errors come from the rounding of the modes, and from the error of the time at
    which the state was computed.
    """
    modal = function.taylor()
    judged: list[tuple[float, float]] = []

    def sign(order: int, row: Sequence[float]) -> int:
        judged.extend(islice(modal, order + 1 - len(judged)))
        value = dot(row, state)
        drift = error * abs(dot(boundary.orders[order + 1], state))
        return 0 if not abs(value) > judged[order][1] + drift else 1 if value > 0 else -1

    found = leading(boundary.orders[:-1], sign, int(zero))
    if found is None or not found.order:
        return Start(0, None) if found is None else Start(found.sign, None, found.sign > 0)
    if found.sign > 0:
        return Start(1, None)
    if judged[found.order][0] < 0:  # one function of time behind the start and from there on
        return Start(-1, Series.of(function, found.order))
    values = [dot(row, state) for row in boundary.orders]
    sizes = [dot(row, size) for row in boundary.bounds]
    return Start(-1, Series(found.order, values, sizes, function.fastest))


def _together(watch: _WatchedFunction, time: float, error: float) -> bool:
    """Whether a boundary is reached at the time of another one's event."""
    series = watch.start.series
    early = series is not None and time <= series.radius
    value, slope, _, rounding = (series if series and early else watch.function).jet(time)
    if abs(value) > rounding + error * abs(slope):
        return False
    certain = watch.function.derivative().rounding(time)
    return slope > certain or (watch.boundary.reached and slope >= -certain)


def run(
    system: PiecewiseLinear,
    state: Sequence[float] | np.ndarray,
    configuration: int,
    until: float = math.inf,
    transitions: int | None = None,
) -> Run:
    """Follow the motion from a state (N,), transition by transition.

    The system is in double precision, and the state is physical: positions, then
    velocities. The motion ends at the time `until`, or after a number of `transitions`, or
    earlier.
    """
    stepper, clock = _Stepper(system), _Clock()
    extended = [*map(float, state), 1.0]
    sizes, zero = [abs(x) for x in extended], frozenset[int]()
    entries = [(0.0, configuration, extended, extended, 0)]
    grazings: list[Grazing] = []
    error, immediate, left_out = 0.0, 0, frozenset[int]()
    waited = 0.0  # since the last transition

    def ended(
        status: Status,
        end: float,
        options: tuple[int, ...] = (),
        open_at: int = 0,
        missing: int = 0,
    ) -> Run:
        times, configurations, before, states, sets = zip(*entries, strict=True)
        return Run(
            np.array(times),
            np.array(configurations, dtype=np.int32),
            np.array(before)[:, :-1],
            np.array(states)[:, :-1],
            np.array(sets, dtype=mask_type(system.structure)),
            tuple(grazings),
            status,
            end,
            options,
            open_at,
            missing,
        )

    while True:
        if not all(abs(x) < LARGEST_STATE for x in extended):
            return ended(Status.OVERFLOW, clock.time)
        if transitions is not None and len(entries) > transitions:
            return ended(Status.TRANSITIONS, clock.time)
        if immediate > MOST_AT_ONCE:
            return ended(Status.IMMEDIATE, clock.time)
        remaining = clock.before(until)
        if remaining < 0:
            return ended(Status.UNTIL, until)
        table = stepper.configuration(configuration)
        if not math.isfinite(table.fastest):
            return ended(Status.OVERFLOW, clock.time)
        horizon = LONGEST_WAIT / table.fastest if table.fastest else math.inf
        if table.growth * horizon > GROWTH:
            horizon = GROWTH / table.growth
        window = min(horizon, remaining)
        endless = until == math.inf or remaining * table.fastest > FARTHEST_END
        try:
            watches = stepper.watches(configuration, extended, sizes, error, left_out, zero)
            event = stepper.event(watches, window)
            dwell = window if event.time is None else event.time
            for time, boundary, depth in event.grazings:
                grazings.append(Grazing(clock.time + time, configuration, boundary, depth))
            if event.time is None:
                if window == remaining and until < math.inf:
                    return ended(Status.UNTIL, until)
                waited += dwell
                over = waited * table.slowest >= LONGEST_WAIT * (1 - 1e-9)
                tired = not waited * table.fastest < LONGEST_QUIET
                if endless and tired and watches and waited * table.slowest < math.tau:
                    return ended(Status.OVERFLOW, clock.time)  # what is slow has hardly begun
                over = over or tired
                if endless and (event.never or window == math.inf or over):
                    return ended(Status.QUIET, entries[-1][0])
                if event.never:
                    return ended(Status.UNTIL, until)
                # the same phase from here on, within reach of the guarantee again
                watched = {w.place for w in watches}
                left_out = frozenset(range(len(table.boundaries))) - watched
                sizes, zero = table.magnitudes([abs(x) for x in extended], dwell), frozenset()
                extended, error = table.after(extended, dwell), 4 * math.ulp(dwell)
                clock.advance(dwell)
                continue
            if dwell > 0:
                error = event.error
                sizes = table.magnitudes([abs(x) for x in extended], dwell)
            # a flight too short for the clock is none
            error = max(error, _RESOLUTION * (clock.time + dwell))
            before = table.after(extended, dwell)
        except OverflowError:
            return ended(Status.OVERFLOW, clock.time)
        clock.advance(dwell)
        moved = [*(error * dot(row, before) for row in table.field), 0.0]
        choice = stepper.choice(configuration, event, Located(before, sizes, moved, error))
        mask, transition = mask_of(event.boundaries), choice.transition
        if transition is None:
            if choice.verdict == "ambiguous":
                return ended(Status.AMBIGUOUS, clock.time, choice.options, mask)
            return ended(Status.UNDECLARED, clock.time, missing=mask)
        shapes = system.structure.boundaries[configuration]
        located = {shapes[b].row for b in event.located} | (zero if dwell == 0 else frozenset())
        zero = stepper.kept(transition, located)
        extended = stepper.reset(transition, before)
        sizes = stepper.reset_sizes(transition, sizes)
        configuration, left_out = transition.target, frozenset()
        immediate = 0 if dwell > 0 else immediate + 1
        waited = 0.0
        entries.append((clock.time, configuration, before, extended, mask))
