"""The equations of a cycle in balls: closure and switching, and their Jacobian.

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
from nonsmooth.runtime.proof.exact_closure import ClosureConditions, projected
from nonsmooth.runtime.proof.exact_tables import Number, Tables, numbers
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.variational import (
    MATRICES,
    Phase,
    Shooting,
    shooting_map,
)

__all__ = ["Equations", "Flows", "Linearised", "equations_in", "phases_of"]


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


class Equations:
    """The n equations of a cycle in balls or Taylor models: switching conditions, closure, period.

    The period is what the dwell times sum up to, where the closing says so, and the speeds are the
    angular frequencies of the closing's forcings.
    """

    def __init__(
        self,
        phases: Sequence[Phase],
        closing: ClosureConditions,
        period: Any,
        speeds: Sequence[Any],
    ) -> None:
        from flint import arb_mat

        self.phases, self.closing, self.period, self.speeds = phases, closing, period, speeds
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
        now = self._from_frames(passed, start, slope)
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


def equations_in(
    phases: Sequence[Phase],
    closing: ClosureConditions,
    number: Number,
    period: Any,
) -> Equations:
    """Return the equations of a cycle in the numbers of its phases.

    `number` maps the closing's exact entries to these numbers. A given period is replaced by that
    of the forcing where the cycle has one.
    """
    from flint import arb

    speeds = [number(speed) for speed in closing.speeds]
    if closing.timed:
        period = 2 * arb.pi() * closing.turns / speeds[0]
    return Equations(phases, closing, period, speeds)
