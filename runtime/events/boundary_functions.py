"""Boundary functions along the phases of many points at once: values, ends, interior maxima.

Along a phase a boundary function is a sum of functions of time, the same for all boundaries
of a configuration, times coefficients. Maxima are looked for between samples, dense compared
with the fastest oscillation: this locates events. Whether an
orbit is admissible is decided by the guaranteed search.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.events.crossings_and_maxima import falling_zeros

_LEAST_CELLS, _CELLS_PER_RADIAN, _MOST_CELLS = 16, 3, 600
_EDGE = 1e-7  # of a dwell time: a maximum nearer to the ends is no interior one


@dataclass(frozen=True)
class PhaseWaves:
    """Boundary functions along one phase at k points, as sums of functions of time."""

    phase: int
    names: tuple[str, ...]  # of the b boundaries
    # place among them of the boundary that ends the phase; None where none does
    leaving: int | None
    durations: np.ndarray  # (k,)
    fastest: float  # largest absolute value of an exponent
    # functions of time (l, f) from places of points (l,) and times (l,)
    basis: Callable[[np.ndarray, np.ndarray], np.ndarray]
    # (3, k, b, f), of the boundary functions, their rates and the rates of these
    coefficients: np.ndarray


@dataclass(frozen=True)
class Ends:
    """Boundary functions and their rates at both ends of a phase, arrays (2, k, b).

    `sizes` are the sums of the absolute values that they are made of along the phase.
    """

    starts: np.ndarray
    stops: np.ndarray
    sizes: np.ndarray


def ends_of(waves: PhaseWaves) -> Ends:
    """Boundary functions and their rates at both ends of a phase."""
    points, coefficients = np.arange(len(waves.durations)), waves.coefficients[:2]
    functions = [waves.basis(points, part * waves.durations) for part in (0.0, 0.3, 0.6, 1.0)]
    # what is zero at an end would be small there: its size is what it is elsewhere
    largest = np.abs(functions).max(axis=0)
    starts, stops, sizes = (
        np.einsum("jkbf,kf->jkb", factors, values)
        for factors, values in (
            (coefficients, functions[0]),
            (coefficients, functions[-1]),
            (abs(coefficients), largest),
        )
    )
    return Ends(starts, stops, sizes)


def interior_maxima(waves: PhaseWaves) -> tuple[np.ndarray, np.ndarray]:
    """Largest local maximum inside the phase, and its time; arrays (k, b), NaN for none.

    Times are in the system's unit.
    """
    count, boundaries = waves.coefficients.shape[1:3]
    angle = waves.fastest * float(np.max(waves.durations, initial=0.0))
    cells = int(min(_LEAST_CELLS + _CELLS_PER_RADIAN * angle, _MOST_CELLS))
    parts = np.linspace(0.0, 1.0, cells + 1)
    times = waves.durations[:, None] * parts
    points = np.repeat(np.arange(count), cells + 1)
    functions = waves.basis(points, times.ravel()).reshape(count, cells + 1, -1)
    slopes = np.einsum("kbf,kmf->kbm", waves.coefficients[1], functions)
    point, boundary, cell = np.nonzero((slopes[..., :-1] > 0) & (slopes[..., 1:] <= 0))
    value, slope, curvature = waves.coefficients[:, point, boundary]

    def rates(times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        functions = waves.basis(point, times)
        return (slope * functions).sum(axis=-1), (curvature * functions).sum(axis=-1)

    time = falling_zeros(rates, times[point, cell], times[point, cell + 1])
    found = (value * waves.basis(point, time)).sum(axis=-1)
    length = waves.durations[point]
    kept = (time > _EDGE * length) & (time < (1 - _EDGE) * length)
    best = np.full((count, boundaries), -np.inf)
    np.maximum.at(best, (point[kept], boundary[kept]), found[kept])
    when = np.full((count, boundaries), np.nan)
    top = kept & (found == best[point, boundary])
    when[point[top], boundary[top]] = time[top]
    return np.where(np.isfinite(best), best, np.nan), when
