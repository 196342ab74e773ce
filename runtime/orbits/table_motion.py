"""The motion along an orbit by its system's tables, as a trajectory."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.model.boundary_sets import mask_of, mask_type
from nonsmooth.runtime.model.engine_run import Run, Status
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["motion_along"]


def motion_along(
    system: PiecewiseLinear,
    cycle: ItineraryShape,
    dwell: np.ndarray,
    starts: np.ndarray,
    ends: np.ndarray,
    shift: np.ndarray,
    periods: int,
) -> Trajectory:
    """Return the motion through phases one after the other, from time 0 on, some periods long.

    All is in double precision: `dwell` (p,), states `starts` and `ends` (p, N) of the
    phases, and the shift (N,) by which a period moves the state. One phase without a
    transition is not cut.
    """
    if cycle.uninterrupted:
        run = Run(
            np.zeros(1),
            np.array(cycle.configurations[:1], dtype=np.int32),
            starts[:1],
            starts[:1],
            np.zeros(1, dtype=mask_type(cycle.structure)),
            (),
            Status.UNTIL,
            float(periods * dwell.sum()),
        )
        return Trajectory(system, run)
    masks = [mask_of(t.boundaries) for t in cycle.transitions]
    moved = np.repeat(np.arange(periods), len(dwell))[:, None] * shift
    behind = np.tile(np.concatenate([starts[1:], starts[:1] + shift]), (periods, 1)) + moved
    times = np.cumsum(np.tile(dwell, periods))
    following = np.tile(np.roll(cycle.configurations, -1), periods)
    run = Run(
        np.concatenate([[0.0], times]),
        np.concatenate([cycle.configurations[:1], following]).astype(np.int32),
        np.concatenate([starts[:1], np.tile(ends, (periods, 1)) + moved]),
        np.concatenate([starts[:1], behind]),
        np.array([0, *masks * periods], dtype=mask_type(cycle.structure)),
        (),
        Status.TRANSITIONS,
        float(times[-1]),
    )
    return Trajectory(system, run)
