"""The shooting map of a chain of phases and its variational, in arrays.

A chain of phases carries a start through a flow, up to a boundary, and through a reset, phase
after phase. Its variational carries changes of the start and of the dwell times: behind a flow
a change of the dwell time moves the state by its velocity. A dwell time may be an unknown of its
own, or follow the start such that its switching condition stays solved; then the variational
is the derivative of the map between sections.

Arrays hold floats, complex or mpmath numbers over many points: maps (..., m, N + 1), states
(..., N, 1) and changes (..., N, n). How a flow is evaluated is not known here: flows are given.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

__all__ = ["Phase", "Shooting", "applied", "section_map", "shooting_map"]


class Phase(NamedTuple):
    """Affine maps of one phase."""

    field: Any  # (..., N, N + 1), the rate of the state
    row: Any  # (..., 1, N + 1), the boundary function that is zero where the phase ends
    reset: Any  # (..., N, N + 1), the state behind the boundary


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


def applied(affine: Any, state: Any) -> Any:
    """Value (..., m, 1) of an affine map at a state (..., N, 1)."""
    return affine[..., :-1] @ state + affine[..., -1:]


def shooting_map(
    phases: Sequence[Phase],
    flows: Iterable[Any],
    start: Any,
    changes: Any,
    rates: Sequence[Any] | None = None,
) -> Shooting:
    """Carry a start, and its changes by each unknown, through a chain of phases.

    `flows` are those of the phases over their dwell times; `start` is a column in the system's
    units, and `changes` has one column for each unknown. `rates` has a row for each phase, the
    change of its dwell time by each unknown. Without them a dwell time changes such that its
    linearised switching condition is solved; the last unknown then stands for the 1 that
    multiplies constants.
    """
    state, starts = start, [start]
    found: list[tuple[Any, ...]] = []
    slopes, speeds = [], []
    for place, (phase, flow) in enumerate(zip(phases, flows, strict=True)):
        end, moved = applied(flow, state), flow[..., :-1] @ changes
        velocity, value = applied(phase.field, end), applied(phase.row, end)
        normal = phase.row[..., :-1]
        if rates is None:
            speeds.append(normal @ velocity)
            missed = normal @ moved
            missed[..., -1:] += value
            rate = -missed / speeds[-1]
        else:
            rate = rates[place]
        moved = moved + velocity * rate
        if rates is not None:
            slopes.append(normal @ moved)
        found.append((flow, end, velocity, value, rate))
        state, changes = applied(phase.reset, end), phase.reset[..., :-1] @ moved
        starts.append(state)
    parts = [list(part) for part in zip(*found, strict=True)]
    passed, ends, velocities, residual, taken = parts
    return Shooting(passed, starts, ends, velocities, residual, speeds, taken, slopes, changes)


def section_map(phase: Phase, flow: Any, velocity: Any, behind: Any = None) -> Any:
    """Derivative (..., N, N) of the state behind a phase's reset by that at its start.

    With the flow's matrix Phi, the reset's R, the gradient n of the boundary, and the
    velocities f- in front and f+ behind it is R (Phi - f- n Phi / n f-) between sections, and
    R Phi + (f+ - R f-) n Phi / n f- at fixed times: the saltation matrix times Phi (M. Aizerman
    and F. Gantmakher, 1958). `velocity` is f-, and `behind` is f+; without it the map is that
    between sections.
    """
    linear, normal, reset = (part[..., :-1] for part in (flow, phase.row, phase.reset))
    later = normal @ linear / (normal @ velocity)
    if behind is None:
        return reset @ (linear - velocity * later)
    return reset @ linear + (behind - reset @ velocity) * later
