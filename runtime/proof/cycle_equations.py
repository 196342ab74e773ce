"""The equations of a cycle in balls: closure and switching, their Jacobian, the Poincare map.

Unknowns are the start, or its states that are no forcing's and then the forcing's time, and
the dwell times. They may be points or boxes, and so may the numbers of the system: every
result encloses what it is for all points of them. Where parameters are not points, numbers
and matrices are Taylor models in place of balls. All matrices act on (y, 1).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, middle_of
from nonsmooth.runtime.proof.closure import Closing, projected
from nonsmooth.runtime.proof.exact_tables import Number, Tables, numbers
from nonsmooth.runtime.proof.motion.exact_rows import Row
from nonsmooth.runtime.shooting.shooting_map import Cycle
from nonsmooth.runtime.shooting.translations import gauges_of

__all__ = ["Chain", "Equations", "Flows", "Passage", "chain_of", "equations_in"]


class Chain(NamedTuple):
    """Phase by phase: field, row of the boundary that ends it, and reset behind that."""

    fields: tuple[Any, ...]
    rows: tuple[Any, ...]
    resets: tuple[Any, ...]


def chain_of(
    tables: Tables, cycle: Cycle, number: Number, translations: Sequence[Row] = ()
) -> Chain:
    """The chain of a cycle that closes up to translations, at the working precision."""
    resets = [tables.resets[t.reset] for t in cycle.transitions]
    resets[-1] = projected(resets[-1], translations)
    return Chain(
        tuple(numbers(tables.fields[c], number) for c in cycle.configurations),
        tuple(numbers([tables.rows[row]], number) for row in cycle.rows),
        tuple(numbers(reset, number) for reset in resets),
    )


class Flows:
    """Matrix exponentials of the phases over boxes of times near given ones."""

    def __init__(self, chain: Chain, times: Sequence[Any]) -> None:
        self.fields = chain.fields
        self.centres = [middle_of(time) for time in times]
        self.near = [(b * t).exp() for b, t in zip(self.fields, self.centres, strict=True)]

    def __call__(self, place: int, time: Any) -> Any:
        """Flow of a phase; over a box of times the wide factor has a small exponent."""
        rest = time - self.centres[place]
        if not isinstance(rest, TaylorModel) and rest.is_zero():
            return self.near[place]
        return (self.fields[place] * rest).exp() * self.near[place]


class Passage(NamedTuple):
    """One passage of the cycle.

    Attributes
    ----------
    values : matrix (n, 1)
        Left-hand sides of the equations.
    jacobian : matrix (n, n)
    flows : list of matrices
    starts, ends, speeds : list of matrices (N + 1, 1)
        State at the start of each phase, and behind the last one; at each end, and its rate.
    """

    values: Any
    jacobian: Any
    flows: list[Any]
    starts: list[Any]
    ends: list[Any]
    speeds: list[Any]


class Equations:
    """Equations of a cycle that closes in its way, at the working precision.

    Parameters
    ----------
    chain : Chain
    closing : Closing
    period : arb, TaylorModel or None
        What the dwell times sum up to, where the closing says so.
    speeds : sequence of arb or TaylorModel
        Of the closing's forcings, in the chain's numbers.
    directions : sequence of matrices (N + 1, 1)
        Those of the closing's translations.
    """

    def __init__(
        self,
        chain: Chain,
        closing: Closing,
        period: Any,
        speeds: Sequence[Any],
        directions: Sequence[Any] = (),
    ) -> None:
        from flint import arb_mat

        self.chain, self.closing, self.period, self.speeds = chain, closing, period, speeds
        self.directions = directions
        self.size = chain.fields[0].nrows() - 1
        self.free = [k for k in range(self.size) if k not in closing.forced]
        self.closed = [k for k in self.free if k != closing.dropped]
        self.first = len(self.free) + bool(closing.pairs)
        self.count = self.first + len(chain.fields)
        self._marks = []
        for place in range(self.first, self.count):
            mark = arb_mat(1, self.count)
            mark[0, place] = 1
            self._marks.append(mark)

    def dwell(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """The dwell times among the unknowns."""
        return unknowns[self.first :]

    def start(self, unknowns: Sequence[Any]) -> tuple[Any, Any]:
        """Start (N + 1, 1) of a cycle and its derivative (N + 1, n) by the unknowns."""
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

    def passage(self, unknowns: Sequence[Any], flows: Flows) -> Passage:
        """Pass once through the cycle, with derivatives by the unknowns."""
        start, slope = self.start(unknowns)
        state, linear = start, slope
        values: list[Any] = []
        rows: list[list[Any]] = []
        found: list[list[Any]] = [[], [start], [], []]
        for place, time in enumerate(self.dwell(unknowns)):
            flow = flows(place, time)
            end = flow * state
            speed = self.chain.fields[place] * end
            linear = flow * linear + speed * self._marks[place]
            row, reset = self.chain.rows[place], self.chain.resets[place]
            values.append((row * end)[0, 0])
            rows.append((row * linear).entries())
            state, linear = reset * end, reset * linear
            for kept, matrix_found in zip(found, (flow, state, end, speed), strict=True):
                kept.append(matrix_found)
        change, closure = state - start, linear - slope
        for k in self.closed:
            values.append(change[k, 0])
            rows.append([closure[k, j] for j in range(self.count)])
        if self.period is not None:
            total = sum(self.dwell(unknowns), 0 * self.period)
            values.append(total - self.period)
            rows.append([int(j >= self.first) for j in range(self.count)])
        flat, starts, ends, speeds = found
        return Passage(matrix([[v] for v in values]), matrix(rows), flat, starts, ends, speeds)

    def maps(self, now: Passage) -> list[Any]:
        """Derivative (N, N) of each phase's start by that before it, as the cycle closes."""
        return self.timed_maps(now) if self.closing.timed else self.section_maps(now)

    def section_maps(self, now: Passage) -> list[Any]:
        """Derivative (N, N) of each phase's start by that before it, on the sections."""
        found = []
        for place, (flow, speed) in enumerate(zip(now.flows, now.speeds, strict=True)):
            row, reset = self.chain.rows[place], self.chain.resets[place]
            ahead = row * flow
            rate = (row * speed)[0, 0]
            found.append(self._linear(reset * (flow - speed * ahead / rate)))
        return found

    def timed_maps(self, now: Passage) -> list[Any]:
        """Derivative (N, N) of each phase's start by that before it, at fixed times."""
        found, count = [], len(now.flows)
        for place, (flow, speed) in enumerate(zip(now.flows, now.speeds, strict=True)):
            row, reset = self.chain.rows[place], self.chain.resets[place]
            behind = self.chain.fields[(place + 1) % count] * now.starts[place + 1]
            if place == count - 1:
                behind = self._projected(behind)
            rate = (row * speed)[0, 0]
            jump = (behind - reset * speed) * (row * flow) / rate
            found.append(self._linear(reset * flow + jump))
        return found

    def _projected(self, rate: Any) -> Any:
        """A rate of the state (N + 1, 1) without the part along translations."""
        gauges = gauges_of(self.closing.translations)
        for direction, gauge in zip(self.directions, gauges, strict=True):
            rate = rate - direction * rate[gauge, 0]
        return rate

    def _linear(self, whole: Any) -> Any:
        """The part that acts on changes of the state."""
        size = self.size
        return matrix([[whole[i, j] for j in range(size)] for i in range(size)])


def equations_in(chain: Chain, closing: Closing, number: Number, period: Any) -> Equations:
    """The equations of a cycle in a chain's numbers.

    Parameters
    ----------
    chain : Chain
    closing : Closing
    number : function
        From the closing's exact entries to the chain's numbers.
    period : arb, TaylorModel or None
        What the dwell times sum up to, where it is given.
    """
    from flint import arb

    speeds = [number(speed) for speed in closing.speeds]
    if closing.timed:
        period = 2 * arb.pi() * closing.turns / speeds[0]
    directions = [numbers([[x] for x in (*d, 0 * d[0])], number) for d in closing.translations]
    return Equations(chain, closing, period, speeds, directions)
