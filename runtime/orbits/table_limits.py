"""Which limit of admissibility fails first, at many orbits without kernels.

Each phase is followed by the compiled engine from its own start to the first boundary that it
reaches: where that is the itinerary's, at its time, nothing was crossed before. Where the
engine's rounding could decide, the guaranteed test of single orbits does.
"""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.boundary_sets import lowest_of, mask_of
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at
from nonsmooth.runtime.orbits.admissible import NEITHER, UNTOLD
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, finite_at, numbers_in, shoot
from nonsmooth.runtime.simulation.engines import run_motions

__all__ = ["CHUNK", "first_limits", "limits_at"]

CHUNK = 1 << 11  # points whose numbers are in memory at once
_CLOSE = 1e-6  # of a dwell time: nearer to its ends rounding may decide
_EARLY = 1e-3  # the same for the boundary that ends the phase
_ZERO = 1e-9  # of the terms of a boundary function
_LONGER = 1.5  # than a dwell time nothing is looked for


def limits_at(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    dwell: np.ndarray,
    starts: np.ndarray,
) -> np.ndarray:
    """Return the limits (n,) of orbits of one itinerary at many finite parameter points.

    They are as for `first_limits`; `UNTOLD` also where double precision does not tell the
    flows. `points` is (n, parameters), `dwell` (n, p), and `starts` (n, p, N) where the
    phases begin.
    """
    limits = np.full(len(points), UNTOLD)
    for begin in range(0, len(points), CHUNK):
        for group in numbers_at(system, points[begin : begin + CHUNK], cycle.configurations):
            here = cycle.at(group.structure)
            sound = finite_at(here, group.flat)
            at = begin + group.places[sound]
            limits[at] = first_limits(
                system, here, points[at], group.flat[sound], dwell[at], starts[at]
            )
    return limits


def first_limits(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    numbers: np.ndarray,
    dwell: np.ndarray,
    starts: np.ndarray,
) -> np.ndarray:
    """Return which boundary each of n orbits of one itinerary crosses first, as an int (n,).

    It is the number among all boundaries, phase after phase; `NEITHER` where the orbit is
    a motion, `UNTOLD` where no guarantee reaches. `numbers` (n, size) are as `numbers_at`
    gives them, `points` is (n, parameters), `dwell` (n, p), and `starts` (n, p, N) where
    the phases begin.
    """
    limit = np.full(len(points), NEITHER)
    unsure = np.asarray((dwell <= 0).any(axis=-1))
    engine = compiled_engine()
    if engine is None:
        unsure[:] = True
    first, count = 0, len(cycle)
    for place, configuration in enumerate(cycle.configurations):
        rows = np.flatnonzero((limit == NEITHER) & ~unsure)
        if engine is not None and len(rows):
            times = dwell[rows, place]
            ends = run_motions(
                engine,
                cycle.structure,
                numbers,
                rows,
                starts[rows, place],
                np.full(len(rows), configuration),
                _LONGER * times,
                1,
                2,
            )
            reached, when = ends.kept_sets[:, 1], ends.kept_times[:, 1]
            own = mask_of(cycle.transitions[place].boundaries)
            moved = ends.status == Status.TRANSITIONS
            expected = moved & (reached == own) & (np.abs(when - times) <= _CLOSE * times)
            expected &= ends.kept_configurations[:, 1] == cycle.configurations[(place + 1) % count]
            if cycle.boundaries[place] is None:  # the forcing's phase begins anew: none is reached
                expected = np.isin(ends.status, (Status.UNTIL, Status.QUIET))
            close = np.where((reached & own) != 0, _EARLY, _CLOSE) * times
            lowest = lowest_of(np.where(moved, reached, 1))
            at_once = when <= _CLOSE * times
            rises = _rises(cycle, configuration, numbers[rows], starts[rows, place], lowest, times)
            crossed = moved & (when < times - close) & ((when > close) | (at_once & rises))
            limit[rows[crossed]] = first + lowest[crossed]
            unsure[rows[~(expected | crossed)]] = True
        first += len(cycle.structure.boundaries[configuration])
    for row in np.flatnonzero(unsure).tolist():
        limit[row] = _guaranteed(system, cycle, points[row], dwell[row], starts[row, 0])
    return limit


def _rises(
    cycle: ItineraryShape,
    configuration: int,
    numbers: np.ndarray,
    starts: np.ndarray,
    boundaries: np.ndarray,
    times: np.ndarray,
) -> np.ndarray:
    """Return where a boundary is crossed at the start of a phase, beyond all rounding."""
    here = numbers_in(cycle.structure, numbers)
    of_boundary = np.array([shape.row for shape in cycle.structure.boundaries[configuration]])
    row = np.take_along_axis(here.rows, of_boundary[boundaries][:, None, None], axis=1)[:, 0]
    field, normal = here.fields[:, configuration], row[:, :-1]
    terms, constants = field[:, :, :-1] * starts[:, None, :], field[:, :, -1]
    velocity = terms.sum(axis=-1) + constants
    # forces may cancel, as where a contact has just broken loose: their terms tell the rounding
    velocities = np.abs(terms).sum(axis=-1) + np.abs(constants)
    size = (np.abs(normal) * np.abs(starts)).sum(axis=-1) + np.abs(row[:, -1])
    size += (np.abs(normal) * velocities).sum(axis=-1) * times
    value = (normal * starts).sum(axis=-1) + row[:, -1]
    rate = (normal * velocity).sum(axis=-1)
    return np.asarray((np.abs(value) <= _ZERO * size) & (rate * times > _CLOSE * size))


def _guaranteed(
    system: SystemKernels,
    cycle: ItineraryShape,
    point: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray,
) -> int:
    """Return the limit of one orbit, by the guaranteed test of its boundary functions."""
    here = piecewise_at(system, point, cycle.configurations)
    cycle = cycle.at(here.structure)
    now = shoot(cycle, numbers_in(here), dwell, start, np)
    if not (dwell > 0).all():
        return UNTOLD
    try:
        verdict = assess_cycle(cycle, here, now, dwell)
    except InputError:
        return UNTOLD
    if not verdict.violations:
        return NEITHER
    first = verdict.violations[0]
    before = sum(len(cycle.structure.boundaries[c]) for c in cycle.configurations[: first.phase])
    names = [shape.name for shape in cycle.structure.boundaries[cycle.configurations[first.phase]]]
    return before + names.index(first.boundary.partition("+")[0])
