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
    "COMPLEX_STEP",
    "MATRICES",
    "Ahead",
    "Arithmetic",
    "Phase",
    "Shooting",
    "section_map",
    "section_map_times_speed",
    "shooting_map",
]


class Phase(NamedTuple):
    """Affine maps of one phase, in the form of their arithmetic.

    Attributes
    ----------
    field : affine map
        The rate of the state.
    row : affine map to one number
        The boundary function that is zero where the phase ends.
    reset : affine map
        The state behind the boundary.
    """

    field: Any
    row: Any
    reset: Any


class Ahead(NamedTuple):
    """A boundary function at a phase's end, by the state at its start.

    Attributes
    ----------
    row : affine map to one number
    rate : affine map to one number
        Its derivative by the dwell time.
    """

    row: Any
    rate: Any


class Arithmetic(Protocol):
    """How affine maps act; a column times a row is their outer product."""

    def apply(self, affine: Any, state: Any) -> Any:
        """Apply a map to a state.

        Parameters
        ----------
        affine : affine map
        state : column
            In the system's units.

        Returns
        -------
        column
        """

    def carry(self, affine: Any, changes: Any) -> Any:
        """Apply a map's linear part to changes of a state, one in each column.

        Parameters
        ----------
        affine : affine map
        changes : columns

        Returns
        -------
        columns
        """

    def linear(self, affine: Any) -> Any:
        """Return a map's linear part, as changes.

        Parameters
        ----------
        affine : affine map

        Returns
        -------
        columns
        """

    def number(self, entry: Any) -> Any:
        """Return the number in what has one row and one column.

        Parameters
        ----------
        entry : row of one column

        Returns
        -------
        number
        """

    def turned(self, changes: Any, velocity: Any, rate: Any) -> Any:
        """Add what a row of changes of a time adds to changes of the state.

        Parameters
        ----------
        changes : columns
            Of the state.
        velocity : column
            Of the state.
        rate : row
            Of changes of the time.

        Returns
        -------
        columns
        """

    def beside(self, row: Any, value: Any) -> Any:
        """Add a value to the last entry of a row that nothing else has.

        Parameters
        ----------
        row : row
        value : number

        Returns
        -------
        row
        """


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


class _ComplexStep(_Arrays):
    """Complex maps and states with a tiny imaginary part; changes are real."""

    def carry(self, affine: Any, changes: Any) -> Any:
        return affine[..., :-1].real @ changes

    def turned(self, changes: Any, velocity: Any, rate: Any) -> Any:
        return changes + velocity.real * rate


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
COMPLEX_STEP: Arithmetic = _ComplexStep()
MATRICES: Arithmetic = _Matrices()


class Shooting(NamedTuple):
    """The shooting map of p phases at a start, and its variational.

    `shooting_map` gives sequences of columns; `nonsmooth.runtime.shooting.shooting_map.shoot`
    gives arrays of the shapes that follow.

    Attributes
    ----------
    flows : array (p, ..., N, N + 1)
    starts : array (p + 1, ..., N)
        State at each phase's start; last what the first would be after the chain.
    ends, velocities : array (p, ..., N)
        State at each phase's end, and its velocity there.
    residual : array (p, ...)
        Boundary function at each phase's end.
    speeds : array (p, ...)
        Its rate; empty where dwell times are unknowns.
    rates : array (p, ..., n)
        Change of each dwell time by the unknowns; where it follows, by the start, and where the
        start stays.
    slopes : array (p, ..., n)
        Change of each boundary function at its phase's end; empty where dwell times follow.
    variational : array (..., N, n)
        Change of the state after the chain.
    """

    flows: Any
    starts: Any
    ends: Any
    velocities: Any
    residual: Any
    speeds: Any
    rates: Any
    slopes: Any
    variational: Any


def shooting_map(
    arithmetic: Arithmetic,
    phases: Sequence[Phase],
    flows: Iterable[Any],
    start: Any,
    changes: Any,
    rates: Sequence[Any] | None = None,
    ahead: Sequence[Ahead | None] | None = None,
) -> Shooting:
    """Carry a start, and changes of it, through a chain of phases.

    Parameters
    ----------
    arithmetic : Arithmetic
    phases : sequence of Phase
    flows : iterable of affine maps
        Of each phase, over its dwell time.
    start : column
        In the system's units.
    changes : columns
        Of the start, by each unknown.
    rates : sequence of rows, optional
        Change of each dwell time by each unknown. Without them a dwell time changes such that
        its switching condition, linearised, is solved; the last unknown stands for the 1 that
        multiplies constants.
    ahead : sequence of (Ahead or None), optional
        Boundary functions by the starts of their phases, where these are sharper than those
        at the ends.
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
    """Derivative of the state behind a phase's reset by that at its start.

    With the flow's matrix Phi, the reset's R, the gradient n of the boundary, and the
    velocities f- in front and f+ behind it is R (Phi - f- n Phi / n f-) between sections, and
    R Phi + (f+ - R f-) n Phi / n f- at fixed times: the saltation matrix times Phi (M. Aizerman
    and F. Gantmakher, 1958).

    Parameters
    ----------
    arithmetic : Arithmetic
    phase : Phase
    flow : affine map
        Of the phase, over its dwell time.
    velocity : column
        f-, at the phase's end.
    behind : column, optional
        f+; without it the map is that between sections.

    Returns
    -------
    columns
    """
    linear = arithmetic.linear(flow)
    ahead = arithmetic.carry(phase.row, linear)
    speed = arithmetic.number(arithmetic.carry(phase.row, velocity))
    if behind is None:
        return arithmetic.carry(phase.reset, linear - velocity * ahead / speed)
    jump = behind - arithmetic.carry(phase.reset, velocity)
    return arithmetic.carry(phase.reset, linear) + jump * ahead / speed


def section_map_times_speed(
    arithmetic: Arithmetic, phase: Phase, flow: Any, velocity: Any, behind: Any = None
) -> Any:
    """Multiply `section_map` by the speed n f- at which the boundary is reached.

    The product is regular where the speed is zero: there it has rank one.

    Parameters
    ----------
    arithmetic : Arithmetic
    phase : Phase
    flow : affine map
        Of the phase, over its dwell time.
    velocity : column
        f-, at the phase's end.
    behind : column, optional
        f+; without it the map is that between sections.

    Returns
    -------
    columns
    """
    linear = arithmetic.linear(flow)
    jump = -arithmetic.carry(phase.reset, velocity)
    if behind is not None:
        jump = behind + jump
    speed = arithmetic.number(arithmetic.carry(phase.row, velocity))
    moved = arithmetic.carry(phase.reset, linear) * speed
    return moved + jump * arithmetic.carry(phase.row, linear)
