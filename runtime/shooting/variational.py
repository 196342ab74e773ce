"""The shooting map of a chain of phases and its variational, in any arithmetic.

A chain of phases carries a start through a flow, up to a boundary, and through a reset, phase
after phase. Its variational carries changes of the start and of the dwell times: behind a flow
a change of the dwell time moves the state by its velocity. A dwell time may be an unknown of its
own, or follow the start such that its switching condition stays solved; then the variational
is the derivative of the map between sections.

The same code serves arrays of floats, complex or mpmath numbers over many points, and matrices
of balls and of Taylor models; what an arithmetic has to know is `Arithmetic`. How a flow is
evaluated is not known here: flows are given.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, Protocol

from nonsmooth.runtime.core.taylor_models import matrix

__all__ = [
    "ARRAYS",
    "MATRICES",
    "Ahead",
    "Arithmetic",
    "Phase",
    "Shooting",
    "section_map",
    "shooting_map",
]


class Phase(NamedTuple):
    """Affine maps of one phase, in the form of their arithmetic."""

    field: Any  # the rate of the state
    row: Any  # to one number, the boundary function that is zero where the phase ends
    reset: Any  # the state behind the boundary


class Ahead(NamedTuple):
    """A boundary function at a phase's end, as a function of the state at its start."""

    row: Any  # affine map to one number
    rate: Any  # affine map to one number, its derivative by the dwell time


class Arithmetic(Protocol):
    """How affine maps act on states and their changes; a column times a row is an outer product."""

    def apply(self, affine: Any, state: Any) -> Any:
        """Apply an affine map to a state, a column, which gives a column."""

    def carry(self, affine: Any, changes: Any) -> Any:
        """Apply a map's linear part to changes of a state, one in each column."""

    def linear(self, affine: Any) -> Any:
        """Return a map's linear part, as columns of changes."""

    def number(self, entry: Any) -> Any:
        """Return the number in a row that has only one column."""

    def turned(self, changes: Any, velocity: Any, rate: Any) -> Any:
        """Add to columns of changes of the state what changes of the time add, velocity times rate.

        `velocity` is a column; `rate` is a row of changes of the time.
        """

    def beside(self, row: Any, value: Any) -> Any:
        """Add a value to the last entry of a row; the row may be changed in place."""


class _Arrays:
    """Arrays: maps (..., m, N + 1), states (..., N, 1) and changes (..., N, n)."""

    def apply(self, affine: Any, state: Any) -> Any:
        return affine[..., :-1] @ state + affine[..., -1:]

    def carry(self, affine: Any, changes: Any) -> Any:
        return affine[..., :-1] @ changes

    def linear(self, affine: Any) -> Any:
        return affine[..., :-1]

    def number(self, entry: Any) -> Any:
        return entry

    def turned(self, changes: Any, velocity: Any, rate: Any) -> Any:
        return changes + velocity * rate

    def beside(self, row: Any, value: Any) -> Any:
        row[..., -1:] += value
        return row


class _Matrices:
    """Matrices of balls or Taylor models that act on (y, 1): maps (N + 1, N + 1).

    The last entry of a change is zero. A state may have several columns: those of a matrix
    that gives it from coordinates.
    """

    def apply(self, affine: Any, state: Any) -> Any:
        return affine * state

    def carry(self, affine: Any, changes: Any) -> Any:
        return affine * changes

    def linear(self, affine: Any) -> Any:
        return affine

    def number(self, entry: Any) -> Any:
        return entry[0, 0]

    def turned(self, changes: Any, velocity: Any, rate: Any) -> Any:
        return changes + velocity * rate

    def beside(self, row: Any, value: Any) -> Any:
        entries = row.entries()
        return matrix([[*entries[:-1], entries[-1] + value[0, 0]]])


ARRAYS: Arithmetic = _Arrays()
MATRICES: Arithmetic = _Matrices()


class Shooting(NamedTuple):
    """The shooting map of p phases at a start, and its derivatives by n unknowns.

    `shooting_map` gives sequences of columns; `nonsmooth.runtime.shooting.shooting_map.shoot`
    gives arrays of the shapes below. Dwell times are unknowns or follow the start.
    """

    flows: Any  # (p, ..., N, N + 1)
    starts: Any  # (p + 1, ..., N), state at each phase's start; last the state after the chain
    ends: Any  # (p, ..., N), state at each phase's end
    velocities: Any  # (p, ..., N), velocity at each phase's end
    residual: Any  # (p, ...), boundary function at each phase's end
    speeds: Any  # (p, ...), rate of the boundary function; empty if dwell times are unknowns
    # (p, ..., n), derivative of each dwell time by the unknowns; if dwell times follow, by the
    # start, and last their change at a fixed start
    rates: Any
    slopes: Any  # (p, ..., n), derivative of the boundary functions; empty if dwell times follow
    variational: Any  # (..., N, n), derivative of the state after the chain


def shooting_map(
    arithmetic: Arithmetic,
    phases: Sequence[Phase],
    flows: Iterable[Any],
    start: Any,
    changes: Any,
    rates: Sequence[Any] | None = None,
    ahead: Sequence[Ahead | None] | None = None,
) -> Shooting:
    """Carry a start, and its changes by each unknown, through a chain of phases.

    `flows` are those of the phases over their dwell times; `start` is a column in the system's
    units, and `changes` has one column for each unknown. `rates` has a row for each phase, the
    change of its dwell time by each unknown. Without them a dwell time changes such that its
    linearised switching condition is solved; the last unknown then stands for the 1 that
    multiplies constants. `ahead` gives boundary functions as functions of the phases' starts,
    where these are sharper than those at the ends.
    """
    apply, carry = arithmetic.apply, arithmetic.carry
    state, starts = start, [start]
    found: list[tuple[Any, ...]] = []
    slopes, speeds = [], []
    for place, (phase, flow) in enumerate(zip(phases, flows, strict=True)):
        end, moved = apply(flow, state), carry(flow, changes)
        velocity = apply(phase.field, end)
        seen = None if ahead is None else ahead[place]
        value = apply(phase.row, end) if seen is None else apply(seen.row, state)
        if rates is None:
            speed = carry(phase.row, velocity)
            speeds.append(speed)
            missed = arithmetic.beside(carry(phase.row, moved), value)
            rate = -missed / arithmetic.number(speed)
            moved = arithmetic.turned(moved, velocity, rate)
        else:
            rate = rates[place]
            moved = arithmetic.turned(moved, velocity, rate)
            if seen is None:
                slopes.append(carry(phase.row, moved))
            else:
                slope = carry(seen.row, changes)
                slopes.append(arithmetic.turned(slope, apply(seen.rate, state), rate))
        found.append((flow, end, velocity, value, rate))
        state, changes = apply(phase.reset, end), carry(phase.reset, moved)
        starts.append(state)
    parts = [list(part) for part in zip(*found, strict=True)]
    passed, ends, velocities, residual, taken = parts
    return Shooting(passed, starts, ends, velocities, residual, speeds, taken, slopes, changes)


def section_map(
    arithmetic: Arithmetic, phase: Phase, flow: Any, velocity: Any, behind: Any = None
) -> Any:
    """Derivative of the state behind a phase's reset by that at its start, as columns.

    With the flow's matrix Phi, the reset's R, the gradient n of the boundary, and the
    velocities f- in front and f+ behind it is R (Phi - f- n Phi / n f-) between sections, and
    R Phi + (f+ - R f-) n Phi / n f- at fixed times: the saltation matrix times Phi (M. Aizerman
    and F. Gantmakher, 1958). `velocity` is f-, and `behind` is f+; without it the map is that
    between sections.
    """
    linear = arithmetic.linear(flow)
    ahead = arithmetic.carry(phase.row, linear)
    speed = arithmetic.number(arithmetic.carry(phase.row, velocity))
    if behind is None:
        return arithmetic.carry(phase.reset, linear - velocity * ahead / speed)
    jump = behind - arithmetic.carry(phase.reset, velocity)
    return arithmetic.carry(phase.reset, linear) + jump * ahead / speed
