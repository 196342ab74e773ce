"""How far a fitted motion stays from grazing, up to where its derivatives hold.

Two things lead to a grazing: a boundary function whose maximum inside a phase is nearly zero, and
a boundary that is reached so slowly that the function would turn soon behind it. The margin is how
far the maximum, found or continued, is from zero, in the unit of the boundary function; to first
order it moves with the unknowns as the function at a fixed time does.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.simulation.phase_functions import fastest
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["NearestGrazing", "nearest_grazing"]

_POINTS = 24  # in a radian-sized piece of a phase, at least
_MOST = 20_000  # points of a phase
_NEWTON = 8
_STEP = 1e-6


@dataclass(frozen=True, kw_only=True)
class NearestGrazing:
    """Where a fitted motion comes closest to grazing a boundary.

    Attributes
    ----------
    kind : {"missed", "slowly reached"}
    boundary, configuration : str
    time : float
        Of the motion, in the system's unit.
    margin : float
        Of the boundary function.
    standard_errors : float
        How many of its own the margin is: so far the unknowns may move, to first order. Infinite
        where no unknown moves it; NaN where the uncertainty is not known.
    """

    kind: Literal["missed", "slowly reached"]
    boundary: str
    configuration: str
    time: Digits
    margin: Digits
    standard_errors: AnyDigits


@dataclass(frozen=True)
class _Approach:
    """A place where a boundary function nearly has the maximum zero."""

    kind: Literal["missed", "slowly reached"]
    phase: int
    boundary: int
    time: float
    margin: float


def nearest_grazing(
    kernels: SystemKernels,
    motion: Trajectory,
    unknowns: Unknowns,
    number: int,
    covariance: np.ndarray,
) -> NearestGrazing | None:
    """Find where a motion is the fewest standard errors from grazing.

    Parameters
    ----------
    kernels : SystemKernels
    motion : Trajectory
    unknowns : Unknowns
    number : int
        Of the experiment.
    covariance : array (q, q)

    Returns
    -------
    NearestGrazing or None
        None where no boundary function has a maximum in a phase.
    """
    found = sorted(_approaches(motion), key=lambda each: each.margin)[:_KEPT]
    if not found:
        return None
    gradients = _gradients(kernels, motion, unknowns, number, found)
    distances = [
        _distance(each.margin, gradient, covariance)
        for each, gradient in zip(found, gradients, strict=True)
    ]
    order = [np.inf if np.isnan(distance) else distance for distance in distances]
    place = int(np.lexsort(([each.margin for each in found], order))[0])
    best, structure = found[place], motion.structure
    configuration = int(motion.run.configurations[best.phase])
    return NearestGrazing(
        kind=best.kind,
        boundary=structure.boundaries[configuration][best.boundary].name,
        configuration=structure.configurations[configuration],
        time=best.time,
        margin=best.margin,
        standard_errors=distances[place],
    )


_KEPT = 50  # approaches whose derivatives are asked for


def _distance(margin: float, gradient: np.ndarray, covariance: np.ndarray) -> float:
    moved = np.flatnonzero(gradient)
    variance = float(gradient[moved] @ covariance[np.ix_(moved, moved)] @ gradient[moved])
    if not variance >= 0:  # NaN: an unknown that nothing tells, or at its bound
        return float("nan")
    return margin / float(np.sqrt(variance)) if variance > 0 else float("inf")


def _approaches(motion: Trajectory) -> Iterator[_Approach]:
    """Maxima of boundary functions inside phases, and slow arrivals at their ends."""
    system, run = motion.system, motion.run
    ends = [*motion.times[1:].tolist(), motion.end]
    for phase, (begin, end) in enumerate(zip(motion.times.tolist(), ends, strict=True)):
        configuration = int(run.configurations[phase])
        shapes = motion.structure.boundaries[configuration]
        if not shapes or not end > begin:
            continue
        rows = system.rows[[shape.row for shape in shapes]]
        field = system.fields[configuration]
        speeds = np.hstack([rows[:, :-1] @ field[:, :-1], (rows[:, :-1] @ field[:, -1])[:, None]])
        bends = np.hstack(
            [speeds[:, :-1] @ field[:, :-1], (speeds[:, :-1] @ field[:, -1])[:, None]]
        )
        start = motion.states[phase]

        def along(row: np.ndarray, since: np.ndarray) -> np.ndarray:
            states = flow_states(system, configuration, since, start)  # noqa: B023
            return np.asarray(states @ row[:-1] + row[-1])

        if phase + 1 < len(motion.before):
            last = motion.before[phase + 1]
            for place, shape in enumerate(shapes):
                if shape.name not in motion.boundaries[phase + 1]:
                    continue
                speed = float(speeds[place, :-1] @ last + speeds[place, -1])
                bend = float(bends[place, :-1] @ last + bends[place, -1])
                if speed > 0 > bend:
                    yield _Approach("slowly reached", phase, place, end, speed**2 / (-2 * bend))
        length = end - begin
        count = int(min(_POINTS * (1 + fastest(system, configuration) * length), _MOST))
        grid = np.linspace(0, length, count + 1)
        for place in range(len(shapes)):
            slopes = along(speeds[place], grid)
            for peak in np.flatnonzero((slopes[:-1] > 0) & (slopes[1:] <= 0)).tolist():
                low, high = grid[peak], grid[peak + 1]
                at = (low + high) / 2
                for _ in range(_NEWTON):
                    slope, bend = (
                        float(along(row[place], np.array([at]))[0]) for row in (speeds, bends)
                    )
                    at = float(np.clip(at - slope / bend, low, high)) if bend else at
                margin = -float(along(rows[place], np.array([at]))[0])
                if margin > 0:
                    yield _Approach("missed", phase, place, begin + at, margin)


def _gradients(
    kernels: SystemKernels,
    motion: Trajectory,
    unknowns: Unknowns,
    number: int,
    found: list[_Approach],
) -> np.ndarray:
    """Derivatives of the margins by the unknowns, (n, q): zero by other experiments' unknowns."""
    entries = [
        (column, entry)
        for column, entry in enumerate(unknowns.entries)
        if entry.concerns(number) and entry.kind != "offset"
    ]
    gradients = np.zeros((len(found), len(unknowns.entries)))
    if not entries:
        return gradients
    starts = dict(
        zip(motion.names, start_names(motion.names, list(motion.parameters)), strict=True)
    )
    by = [e.target if e.kind == "parameter" else starts[e.target] for _, e in entries]
    columns = [column for column, _ in entries]
    # in front of a transition the state is that of `before`: there the margin is a bound alone
    missed = [each for each in found if each.kind == "missed"]
    try:
        derivatives: Any = motion.derivatives(by, times=np.array([each.time for each in missed]))
    except NonsmoothError:
        return np.full_like(gradients, np.nan)
    moved = _moved_rows(kernels, motion, unknowns)
    inside = iter(range(len(missed)))
    for place, each in enumerate(found):
        configuration = int(motion.run.configurations[each.phase])
        row = motion.structure.boundaries[configuration][each.boundary].row
        if each.kind == "missed":
            state, turned = motion(each.time), derivatives.states[next(inside)]
            normal = motion.system.rows[row]
            slope = normal[:-1] @ turned
            for column, name in zip(columns, range(len(by)), strict=True):
                gradients[place, column] = -float(slope[name])
            for column, change in moved.items():
                gradients[place, column] -= float(change[row, :-1] @ state + change[row, -1])
        else:
            gradients[place, columns] = _of_arrival(motion, each, derivatives, moved, columns, row)
    return gradients


def _of_arrival(
    motion: Trajectory,
    each: _Approach,
    derivatives: Any,
    moved: dict[int, np.ndarray],
    columns: list[int],
    row: int,
) -> np.ndarray:
    """Derivatives of the height above a boundary that the motion would reach behind it.

    The height is that of the function at its maximum, a time s = -speed / bend behind the
    arrival: it moves as the function does there, which the flow continues.
    """
    system, phase = motion.system, each.phase
    configuration = int(motion.run.configurations[phase])
    field, normal = system.fields[configuration], system.rows[row]
    last = motion.before[phase + 1]
    rate = field[:, :-1] @ last + field[:, -1]
    speed = float(normal[:-1] @ rate)
    # the moving state in front of the arrival, and its speed through the boundary
    arriving = np.asarray(derivatives.before[phase + 1])
    bend = float(normal[:-1] @ field[:, :-1] @ rate)
    turned = normal[:-1] @ field[:, :-1] @ arriving
    for place, column in enumerate(columns):
        if column in moved:
            turned[place] += float(moved[column][row, :-1] @ rate)
    return np.asarray(turned * speed / -bend)


def _moved_rows(
    kernels: SystemKernels, motion: Trajectory, unknowns: Unknowns
) -> dict[int, np.ndarray]:
    """Derivatives of the rows (R, N + 1) by fitted parameters, by central differences."""
    names = [table.name for table in kernels.parameters]
    point = np.array([float(motion.parameters[name]) for name in names])
    found = {}
    for column, entry in enumerate(unknowns.entries):
        if entry.kind != "parameter":
            continue
        place = names.index(entry.target)
        step = _STEP * (abs(point[place]) or 1.0)
        ends = np.array([point, point])
        ends[:, place] += [-step, step]
        _, rows, _ = tables_at(kernels, ends)
        found[column] = (rows[1] - rows[0]) / (2 * step)
    return found
