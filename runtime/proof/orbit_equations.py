"""The equations of a cycle in balls: closure and switching, their Jacobian, the Poincare map.

Unknowns are the start, or its states that are no forcing's and then the forcing's time, and
the dwell times. They may be points or boxes, and so may the numbers of the system: every
result encloses what it is for all points of them. Where parameters are not points, numbers
and matrices are Taylor models in place of balls. All matrices act on (y, 1).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.core.matrix_chains import framed_phases
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, middle_of
from nonsmooth.runtime.proof.exact_closure import ClosureConditions, projected, projection
from nonsmooth.runtime.proof.exact_tables import Number, Tables, numbers
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.variational import (
    MATRICES,
    Ahead,
    Phase,
    Shooting,
    section_map,
    section_map_times_speed,
    shooting_map,
)

__all__ = ["Equations", "Flows", "Linearised", "ShortPhase", "equations_in", "phases_of"]


def phases_of(
    tables: Tables, cycle: ItineraryShape, number: Number, translations: Sequence[Row] = ()
) -> tuple[Phase, ...]:
    """Return the phases of a cycle, with matrices (N + 1, N + 1) and rows (1, N + 1) of numbers.

    The cycle closes up to `translations`, directions along which the system does not change:
    behind the last reset the state is projected along them.
    """
    resets = [tables.resets[t.reset] for t in cycle.transitions]
    resets[-1] = projected(resets[-1], translations)
    return tuple(
        Phase(
            numbers(tables.fields[configuration], number),
            numbers([tables.rows[row]], number),
            numbers(reset, number),
        )
        for configuration, row, reset in zip(cycle.configurations, cycle.rows, resets, strict=True)
    )


class Flows:
    """The matrix exponentials of all phases, for times near given ones."""

    def __init__(self, phases: Sequence[Phase], times: Sequence[Any]) -> None:
        self.fields = [phase.field for phase in phases]
        self.centres = [middle_of(time) for time in times]
        self.near = [(b * t).exp() for b, t in zip(self.fields, self.centres, strict=True)]

    def __call__(self, place: int, time: Any) -> Any:
        """Return the flow of a phase over a time or a box of times.

        Over a box the factor whose entries are wide has a small exponent.
        """
        rest = time - self.centres[place]
        if not isinstance(rest, TaylorModel) and rest.is_zero():
            return self.near[place]
        return (self.fields[place] * rest).exp() * self.near[place]


class Linearised(NamedTuple):
    """The left-hand sides of the equations and their Jacobian, with the passage they come from."""

    residual: Any  # (n, 1)
    jacobian: Any  # (n, n)
    shooting: Shooting  # flows (N + 1, N + 1) and columns (N + 1, 1)


class ShortPhase(NamedTuple):
    """A phase whose dwell time may be zero.

    If it begins and ends on one boundary, its switching condition is divided by its dwell time:
    the quotient is regular where the dwell time is zero, and elsewhere it has the same solutions.
    """

    place: int  # counted from 0
    # for each phase a column (N + 1, 1), the jump of the velocity at its end over the rate of the
    # boundary function, where that is known though both may be zero; else None
    saltations: tuple[Any, ...]
    divided: bool  # whether its switching condition is divided

    def at(self, number: Number) -> ShortPhase:
        """Return the phase with `number` applied to its exact entries."""
        columns = [
            None if column is None else numbers([[entry] for entry in column], number)
            for column in self.saltations
        ]
        return ShortPhase(self.place, tuple(columns), self.divided)


class Equations:
    """The n equations of a cycle in balls or Taylor models: switching conditions, closure, period.

    The period is what the dwell times sum up to, where the closing says so, and the speeds are the
    angular frequencies of the closing's forcings. The projection (N + 1, N + 1) is that along the
    closing's translations, if it has any. `short` is the phase that may vanish.
    """

    def __init__(
        self,
        phases: Sequence[Phase],
        closing: ClosureConditions,
        period: Any,
        speeds: Sequence[Any],
        projection: Any = None,
        short: ShortPhase | None = None,
    ) -> None:
        from flint import arb_mat

        self.phases, self.closing, self.period, self.speeds = phases, closing, period, speeds
        self.projection, self.short = projection, short
        self.size = phases[0].field.nrows() - 1
        self.free = [k for k in range(self.size) if k not in closing.forced]
        self.closed = [k for k in self.free if k != closing.dropped]
        self.first = len(self.free) + bool(closing.pairs)
        self.count = self.first + len(phases)
        self._marks = []
        for place in range(self.first, self.count):
            mark = arb_mat(1, self.count)
            mark[0, place] = 1
            self._marks.append(mark)

    def near(self, point: Sequence[Any]) -> Flows:
        """Return the flows that `linearised` needs for dwell times near those of a point."""
        return Flows(self.phases, self.dwell(point))

    def mapped(self, change: Callable[[Any], Any]) -> Equations:
        """Return the same equations with all numbers and matrices changed."""
        period = self.period
        return Equations(
            [Phase(*map(change, phase)) for phase in self.phases],
            self.closing,
            None if period is None else change(period),
            list(map(change, self.speeds)),
            short=self.short,
        )

    def dwell(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Return the dwell times among the unknowns, one for each phase."""
        return unknowns[self.first :]

    def start(self, unknowns: Sequence[Any]) -> tuple[Any, Any]:
        """Return the start (N + 1, 1) of a cycle and its derivative (N + 1, n) by the unknowns.

        The last entry of the start is 1.
        """
        state: list[list[Any]] = [[0] for _ in range(self.size)] + [[1]]
        slope: list[list[Any]] = [[0] * self.count for _ in state]
        for place, k in enumerate(self.free):
            state[k][0] = unknowns[place]
            slope[k][place] = 1
        for (cosine, sine), speed in zip(self.closing.pairs, self.speeds, strict=True):
            s, c = (speed * unknowns[self.first - 1]).sin_cos()
            state[cosine][0], state[sine][0] = c, s
            slope[cosine][self.first - 1], slope[sine][self.first - 1] = -speed * s, speed * c
        return matrix(state), matrix(slope)

    def linearised(self, unknowns: Sequence[Any], flows: Callable[[int, Any], Any]) -> Linearised:
        """Pass once through the cycle and return residual (n, 1), Jacobian (n, n) and the passage.

        `flows` gives the flow of a phase, by its number, over a time.
        """
        start, slope = self.start(unknowns)
        passed = [flows(place, time) for place, time in enumerate(self.dwell(unknowns))]
        if self.short is None:
            now = self._from_frames(passed, start, slope)
        else:
            ahead = self._divided(unknowns)
            now = shooting_map(MATRICES, self.phases, passed, start, slope, self._marks, ahead)
        values = [value[0, 0] for value in now.residual]
        rows = [slope.entries() for slope in now.slopes]
        change, closure = now.starts[-1] - start, now.variational - slope
        for k in self.closed:
            values.append(change[k, 0])
            rows.append([closure[k, j] for j in range(self.count)])
        if self.period is not None:
            total = sum(self.dwell(unknowns), 0 * self.period)
            values.append(total - self.period)
            rows.append([int(j >= self.first) for j in range(self.count)])
        return Linearised(matrix([[v] for v in values]), matrix(rows), now)

    def _from_frames(self, flows: Sequence[Any], start: Any, slope: Any) -> Shooting:
        """Return the passage, computed in frames that turn with the states of a long cycle."""
        fields, rows, resets = (list(x) for x in zip(*self.phases, strict=True))
        seen = framed_phases(fields, rows, resets, list(flows))
        phases = [Phase(*parts) for parts in zip(*seen[:3], strict=True)]
        now = shooting_map(MATRICES, phases, seen.flows, start, slope, self._marks)
        starts, ends, velocities = (
            [frame * column for frame, column in zip(frames, columns, strict=True)]
            for frames, columns in (
                (seen.starts, now.starts), (seen.ends, now.ends), (seen.ends, now.velocities),
            )
        )  # fmt: skip
        return now._replace(flows=flows, starts=starts, ends=ends, velocities=velocities)

    def _divided(self, unknowns: Sequence[Any]) -> list[Ahead | None] | None:
        """Return the short phase's condition divided by its dwell time t, and its rate, as rows.

        The rows act on the phase's start. With its field B and boundary n they are n phi1(B t) B
        and n (phi1 - phi2)(B t) B B, where phi1(z) = (e^z - 1) / z and phi2(z) = (phi1(z) - 1) / z
        (N. Higham, Functions of Matrices, 2008, 10.7.4).
        """
        if self.short is None or not self.short.divided:
            return None
        place, size = self.short.place, self.size + 1
        phase, time = self.phases[place], self.dwell(unknowns)[place]
        inner, last = phase.field * time, phase.row.entries()
        rows: list[list[Any]] = [[0] * (size + 2) for _ in range(size + 2)]
        rows[0][1] = 1
        rows[1][2:] = last
        for i in range(size):
            rows[i + 2][2:] = [inner[i, j] for j in range(size)]
        found = matrix(rows).exp()
        second, first = (matrix([[found[k, j + 2] for j in range(size)]]) for k in (0, 1))
        by_start = first * phase.field
        ahead: list[Ahead | None] = [None] * len(self.phases)
        ahead[place] = Ahead(by_start, (by_start - second * phase.field) * phase.field)
        return ahead

    @property
    def closure_rows(self) -> list[tuple[int, int]]:
        """The equations that compare the cycle's end with its start, each with its unknown.

        Each of them subtracts its unknown, a state or the forcing's time at the start, from what it
        is at the cycle's end.
        """
        count = len(self.phases)
        found = [(count + row, self.free.index(k)) for row, k in enumerate(self.closed)]
        if self.closing.pairs:
            found.append((count + len(self.closed), self.first - 1))
        return found

    def maps(self, now: Shooting, slow: int | None = None) -> list[Any]:
        """Return the derivative (N, N) of each phase's start by the start of the phase before it.

        It is taken at fixed times for an orbit that is a function of time, else on the sections.
        The map of phase `slow`, counted from 0, is multiplied by the speed at which its boundary is
        reached: the product is regular where that speed is zero.
        """
        return self.timed_maps(now, slow) if self.closing.timed else self.section_maps(now, slow)

    def section_maps(self, now: Shooting, slow: int | None = None) -> list[Any]:
        """Return the derivatives that `maps` gives, (N, N) for each phase, on the sections.

        The map of phase `slow` is multiplied by its speed.
        """
        return self._maps(now, [None] * len(self.phases), slow)

    def timed_maps(self, now: Shooting, slow: int | None = None) -> list[Any]:
        """Return the derivatives that `maps` gives, (N, N) for each phase, at fixed times.

        The map of phase `slow` is multiplied by its speed.
        """
        fields = [phase.field for phase in (*self.phases[1:], self.phases[0])]
        behind = [field * start for field, start in zip(fields, now.starts[1:], strict=True)]
        behind[-1] = behind[-1] if self.projection is None else self.projection * behind[-1]
        return self._maps(now, behind, slow)

    def speed(self, now: Shooting, place: int) -> Any:
        """Return the speed at which a phase, counted from 0, reaches its boundary."""
        return (self.phases[place].row * now.velocities[place])[0, 0]

    def _maps(self, now: Shooting, behind: Sequence[Any], slow: int | None) -> list[Any]:
        parts = zip(self.phases, now.flows, now.velocities, behind, strict=True)
        known = [None] * len(self.phases) if self.short is None else self.short.saltations
        found = []
        for place, (part, column) in enumerate(zip(parts, known, strict=True)):
            if place == slow:
                whole = section_map_times_speed(MATRICES, *part)
            elif column is None:
                whole = section_map(MATRICES, *part)
            else:
                whole = _salted(*part[:2], column)
            found.append(self._linear(whole))
        return found

    def _linear(self, whole: Any) -> Any:
        """Return the block (N, N) of a matrix that acts on changes of the state."""
        size = self.size
        return matrix([[whole[i, j] for j in range(size)] for i in range(size)])


def _salted(phase: Phase, flow: Any, jump: Any) -> Any:
    """Return the map at fixed times of a phase whose jump over the boundary's rate is known."""
    return phase.reset * flow + jump * (phase.row * flow)


def equations_in(
    phases: Sequence[Phase],
    closing: ClosureConditions,
    number: Number,
    period: Any,
    short: ShortPhase | None = None,
) -> Equations:
    """Return the equations of a cycle in the numbers of its phases.

    `number` maps the closing's exact entries to these numbers. A given period is replaced by that
    of the forcing where the cycle has one.
    """
    from flint import arb

    speeds = [number(speed) for speed in closing.speeds]
    if closing.timed:
        period = 2 * arb.pi() * closing.turns / speeds[0]
    along = None
    if closing.translations:
        along = numbers(projection(closing.translations, phases[0].field.nrows() - 1), number)
    return Equations(phases, closing, period, speeds, along, short)
