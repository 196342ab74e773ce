"""The batch solver by tables: orbits of one itinerary at many parameter points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import numbers_at
from nonsmooth.runtime.orbits.admissible import NO_ORBIT
from nonsmooth.runtime.orbits.table_digits import without_digits
from nonsmooth.runtime.orbits.table_limits import first_limits
from nonsmooth.runtime.shooting.newton import CONVERGED, INVALID
from nonsmooth.runtime.shooting.section_map import mechanical_states, stroboscopic_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetric_orbit import closed_shape
from nonsmooth.runtime.shooting.table_newton import solve_shape
from nonsmooth.runtime.shooting.translations import (
    directions_of,
    gauges_of,
    projection_along,
)

__all__ = ["Composed", "TableBatch"]


class Composed(NamedTuple):
    """Orbits at n points; NaN where Newton's method had nothing to start from."""

    dwell: np.ndarray  # (n, p)
    starts: np.ndarray  # (n, p, N), state at the start of each phase
    maps: np.ndarray  # (n, m, m), of the section at `first`, or stroboscopic
    residual: np.ndarray  # (n,)
    iterations: np.ndarray  # (n,) of int32
    status: np.ndarray  # (n,) of int32
    limit: np.ndarray  # (n,) of int, as `first_limits` gives it; NO_ORBIT where not asked for

    @property
    def converged(self) -> np.ndarray:
        """Where an orbit was found."""
        return np.asarray(self.status == CONVERGED)


@dataclass(frozen=True, eq=False)
class TableBatch:
    """An itinerary of a system, to be solved at many points."""

    system: SystemKernels
    cycle: ItineraryShape
    first: int = 0  # the phase from which orbits are composed
    translates: bool = False  # whether orbits close up to translations of the system

    def solve(
        self,
        points: np.ndarray,
        dwell: np.ndarray,
        start: np.ndarray | None,
        period: np.ndarray,
        *,
        limits: bool,
    ) -> Composed:
        """Return the orbits at n points from one guess each.

        `points` is (n, parameters), guesses are `dwell` (n, p) and `start` (n, N), or None for
        the start that fits the dwell times best; `period` (n,) is NaN where it is free. With
        `limits` the limit of admissibility that fails first is told.
        """
        cycle, (count, phases) = self.cycle, dwell.shape
        size, driven = len(cycle.structure.states), mechanical_states(cycle)
        width = size if driven is None else len(driven)
        found = Composed(
            np.full((count, phases), np.nan),
            np.full((count, phases, size), np.nan),
            np.full((count, width, width), np.nan),
            np.full(count, np.nan),
            np.zeros(count, dtype=np.int32),
            np.full(count, INVALID, dtype=np.int32),
            np.full(count, NO_ORBIT, dtype=int),
        )
        sound = np.isfinite(np.concatenate([points, dwell], axis=1)).all(axis=1)
        if start is not None:
            sound &= np.isfinite(start).all(axis=1)
        for group in numbers_at(self.system, points, cycle.configurations) if count else ():
            here = cycle.at(group.structure)
            rows, flat, kept = group.places, group.flat, sound[group.places]
            if not kept.all():
                rows, flat = rows[kept], flat[kept]
            if len(rows):
                guess = dwell[rows], None if start is None else start[rows]
                self._fill(found, rows, here, flat, *guess, period[rows])
            if limits:
                there = np.flatnonzero(found.status[rows] == CONVERGED)
                at = rows[there]
                found.limit[at] = first_limits(
                    self.system, here, points[at], flat[there], found.dwell[at], found.starts[at]
                )
        return found

    def _fill(
        self,
        found: Composed,
        rows: np.ndarray,
        cycle: ItineraryShape,
        flat: np.ndarray,
        dwell: np.ndarray,
        start: np.ndarray | None,
        period: np.ndarray,
    ) -> None:
        """Solve the points at some rows, whose numbers `flat` have the same modes."""
        closed, directions = cycle, np.empty((len(flat), 0, len(cycle.structure.states)))
        if self.translates:
            closed, flat, directions = _up_to_translations(cycle, flat)
        turned, first = closed.rotated(self.first), self.first
        if start is not None and first:
            with np.errstate(all="ignore"):
                numbers = numbers_in(closed.structure, flat)
                start = shoot(closed, numbers, dwell, start, np).starts[first]
        solved = solve_shape(turned, flat, np.roll(dwell, -first, axis=1), start, period)
        found.dwell[rows] = np.roll(solved.dwell, first, axis=1)
        found.starts[rows] = np.roll(solved.starts, first, axis=1)
        found.residual[rows], found.iterations[rows] = solved.residual, solved.iterations
        found.status[rows] = without_digits(turned, flat, solved, period)
        maps, driven = solved.maps, mechanical_states(cycle)
        if driven is not None:
            field = numbers_in(closed.structure, flat).fields[:, cycle.configurations[0]]
            maps = stroboscopic_maps(closed, field, solved.starts[:, 0], maps, driven)
            directions = directions[..., driven]
        found.maps[rows] = _with_translations(maps, directions) if self.translates else maps


def _up_to_translations(
    cycle: ItineraryShape, flat: np.ndarray
) -> tuple[ItineraryShape, np.ndarray, np.ndarray]:
    """Return a cycle that closes up to translations, its numbers, and their directions.

    Its last reset is that of the closure.
    """
    structure, count = cycle.structure, len(flat)
    numbers = numbers_in(structure, flat)
    arrays = zip(numbers.fields, numbers.rows, numbers.resets, strict=True)
    directions = np.array([directions_of(structure, *each) for each in arrays])
    last = numbers.resets[:, cycle.transitions[-1].reset]
    added = np.stack([projection_along(d) @ r for d, r in zip(directions, last, strict=True)])
    place = sum(part[0].size for part in numbers[:3])
    parts = [flat[:, :place], added.reshape(count, -1), flat[:, place:]]
    return closed_shape(cycle, len(cycle)), np.concatenate(parts, axis=1), directions


def _with_translations(maps: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return maps (n, k, k) up to translations with the multipliers 1 that these have."""
    found = maps.copy()
    for map_, along in zip(found, directions, strict=True):
        if len(along):
            map_[:] = projection_along(along) @ map_
            map_[:, gauges_of(along)] += along.T
    return found
