"""The equations of a cycle in balls: closure and switching, their Jacobian, the Poincare map.

Unknowns are the start, or its states that are no forcing's and then the forcing's time, and
the dwell times. They may be points or boxes, and so may the numbers of the system: every
result encloses what it is for all points of them. All matrices act on (y, 1).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.certification.closing import Closing
from nonsmooth.runtime.certification.tables import Tables, balls
from nonsmooth.runtime.composition.passage import Cycle

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["Chain", "Equations", "Flows", "Passage", "chain_of"]


class Chain(NamedTuple):
    """Phase by phase: field, row of the boundary that ends it, and reset behind that."""

    fields: tuple[arb_mat, ...]
    rows: tuple[arb_mat, ...]
    resets: tuple[arb_mat, ...]


def chain_of(tables: Tables, cycle: Cycle) -> Chain:
    """The chain of a cycle, at the working precision."""
    return Chain(
        tuple(balls(tables.fields[c]) for c in cycle.configurations),
        tuple(balls([tables.rows[row]]) for row in cycle.rows),
        tuple(balls(tables.resets[t.reset]) for t in cycle.transitions),
    )


class Flows:
    """Matrix exponentials of the phases over boxes of times near given ones."""

    def __init__(self, chain: Chain, times: Sequence[arb]) -> None:
        self.fields = chain.fields
        self.centres = [time.mid() for time in times]
        self.near = [(b * t).exp() for b, t in zip(self.fields, self.centres, strict=True)]

    def __call__(self, place: int, time: arb) -> arb_mat:
        """Flow of a phase; over a box of times the wide factor has a small exponent."""
        rest = time - self.centres[place]
        if rest.is_zero():
            return self.near[place]
        return (self.fields[place] * rest).exp() * self.near[place]


class Passage(NamedTuple):
    """One passage of the cycle.

    Attributes
    ----------
    values : arb_mat (n, 1)
        Left-hand sides of the equations.
    jacobian : arb_mat (n, n)
    flows : list of arb_mat
    starts, ends, speeds : list of arb_mat (N + 1, 1)
        State at the start of each phase, and behind the last one; at each end, and its rate.
    """

    values: arb_mat
    jacobian: arb_mat
    flows: list[arb_mat]
    starts: list[arb_mat]
    ends: list[arb_mat]
    speeds: list[arb_mat]


class Equations:
    """Equations of a cycle that closes in its way, at the working precision.

    Parameters
    ----------
    chain : Chain
    closing : Closing
    period : arb or None
        What the dwell times sum up to, where the closing says so.
    """

    def __init__(self, chain: Chain, closing: Closing, period: arb | None) -> None:
        from flint import arb

        self.chain, self.closing, self.period = chain, closing, period
        self.size = chain.fields[0].nrows() - 1
        forced = {state for pair in closing.pairs for state in pair}
        self.free = [k for k in range(self.size) if k not in forced]
        self.closed = [k for k in self.free if k != closing.dropped]
        self.first = len(self.free) + bool(closing.pairs)
        self.count = self.first + len(chain.fields)
        self.speeds = [arb(speed) for speed in closing.speeds]

    def dwell(self, unknowns: Sequence[arb]) -> Sequence[arb]:
        """The dwell times among the unknowns."""
        return unknowns[self.first :]

    def start(self, unknowns: Sequence[arb]) -> tuple[arb_mat, arb_mat]:
        """Start (N + 1, 1) of a cycle and its derivative (N + 1, n) by the unknowns."""
        from flint import arb_mat

        state, slope = arb_mat(self.size + 1, 1), arb_mat(self.size + 1, self.count)
        state[self.size, 0] = 1
        for place, k in enumerate(self.free):
            state[k, 0] = unknowns[place]
            slope[k, place] = 1
        for (cosine, sine), speed in zip(self.closing.pairs, self.speeds, strict=True):
            s, c = (speed * unknowns[self.first - 1]).sin_cos()
            state[cosine, 0], state[sine, 0] = c, s
            slope[cosine, self.first - 1], slope[sine, self.first - 1] = -speed * s, speed * c
        return state, slope

    def passage(self, unknowns: Sequence[arb], flows: Flows) -> Passage:
        """Pass once through the cycle, with derivatives by the unknowns."""
        from flint import arb_mat

        start, slope = self.start(unknowns)
        state, linear = start, slope
        values: list[Any] = []
        rows: list[list[Any]] = []
        found: list[list[arb_mat]] = [[], [start], [], []]
        for place, time in enumerate(self.dwell(unknowns)):
            flow = flows(place, time)
            end, linear = flow * state, flow * linear
            speed = self.chain.fields[place] * end
            for i in range(self.size):
                linear[i, self.first + place] += speed[i, 0]
            row, reset = self.chain.rows[place], self.chain.resets[place]
            values.append((row * end)[0, 0])
            rows.append((row * linear).entries())
            state, linear = reset * end, reset * linear
            for kept, matrix in zip(found, (flow, state, end, speed), strict=True):
                kept.append(matrix)
        change, closure = state - start, linear - slope
        for k in self.closed:
            values.append(change[k, 0])
            rows.append([closure[k, j] for j in range(self.count)])
        if self.period is not None:
            total = sum(self.dwell(unknowns), 0 * self.period)
            values.append(total - self.period)
            rows.append([int(j >= self.first) for j in range(self.count)])
        flat, starts, ends, speeds = found
        return Passage(arb_mat([[v] for v in values]), arb_mat(rows), flat, starts, ends, speeds)

    def section_maps(self, now: Passage) -> list[arb_mat]:
        """Derivative (N, N) of each phase's start by that before it, on the sections."""
        found = []
        for place, (flow, speed) in enumerate(zip(now.flows, now.speeds, strict=True)):
            row, reset = self.chain.rows[place], self.chain.resets[place]
            ahead = row * flow
            rate = (row * speed)[0, 0]
            found.append(self._linear(reset * (flow - speed * ahead / rate)))
        return found

    def timed_maps(self, now: Passage) -> list[arb_mat]:
        """Derivative (N, N) of each phase's start by that before it, at fixed times."""
        found, count = [], len(now.flows)
        for place, (flow, speed) in enumerate(zip(now.flows, now.speeds, strict=True)):
            row, reset = self.chain.rows[place], self.chain.resets[place]
            behind = self.chain.fields[(place + 1) % count] * now.starts[place + 1]
            rate = (row * speed)[0, 0]
            jump = (behind - reset * speed) * (row * flow) / rate
            found.append(self._linear(reset * flow + jump))
        return found

    def _linear(self, matrix: arb_mat) -> arb_mat:
        """The part that acts on changes of the state."""
        from flint import arb_mat

        size = self.size
        return arb_mat([[matrix[i, j] for j in range(size)] for i in range(size)])
