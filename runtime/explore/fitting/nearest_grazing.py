"""How far a fitted motion stays from grazing, up to where its derivatives hold.

Two things lead to a grazing: a boundary function whose maximum inside a phase is nearly zero, and
a boundary that is reached so slowly that the function would turn soon behind it. The margin is how
far the maximum, found or continued, is from zero, in the unit of the boundary function; to first
order it moves with the unknowns as the function at a fixed time does. No maximum is missed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Literal

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts
from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits
from nonsmooth.runtime.explore.fitting.table_changes import table_changes
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.table_derivatives import TableDerivatives
from nonsmooth.runtime.simulation.extremes import local_maxima
from nonsmooth.runtime.simulation.phase_functions import phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives

__all__ = ["NearestGrazing", "nearest", "nearest_grazing", "nearest_grazing_of_response"]

_KEPT = 50  # approaches whose derivatives are asked for


@dataclass(frozen=True, kw_only=True)
class NearestGrazing:
    """The place at which a fitted motion comes closest to grazing a boundary."""

    kind: Literal["missed", "slowly reached"]
    boundary: str
    configuration: str
    time: Digits  # of the motion, in the system's unit
    margin: Digits  # of the boundary function
    # the margin in its own standard errors, to first order: so far the unknowns may move; infinite
    # where none moves it, NaN where the uncertainty is not known
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
    motion: Trajectory,
    unknowns: Unknowns,
    number: int,
    covariance: np.ndarray,
) -> NearestGrazing | None:
    """The place where a motion is the fewest standard errors from grazing, or None.

    It is None if no boundary function has a maximum in a phase. `number` is that of the
    experiment, `covariance` (q, q) that of the unknowns.
    """
    found = sorted(_approaches(motion), key=lambda each: each.margin)[:_KEPT]
    if not found:
        return None
    gradients = _gradients(motion, unknowns, number, found)
    return _nearest(motion, found, gradients, covariance)


def nearest_grazing_of_response(
    orbit: OrbitDerivatives, columns: Sequence[int], covariance: np.ndarray
) -> NearestGrazing | None:
    """The place where a steady response is the fewest standard errors from grazing, or None.

    It is None if no boundary function has a maximum in a phase. `orbit` has the derivatives by
    free parameters, whose places among the unknowns are `columns`; `covariance` is (q, q).
    """
    motion = orbit.orbit.trajectory()
    found = sorted(_approaches(motion), key=lambda each: each.margin)[:_KEPT]
    if not found:
        return None
    along, _ = orbit.orbit.evaluation.along(orbit)
    gradients = np.zeros((len(found), len(covariance)))
    for place, each in enumerate(found):
        configuration = int(motion.run.configurations[each.phase])
        row = motion.structure.boundaries[configuration][each.boundary].row
        normal = along.numbers.rows[:, row]
        if each.kind == "missed":
            since = each.time - float(motion.times[each.phase])
            rates = -along.differentiated(partial(_same, normal), each.phase, since).rates
        else:
            rates = _of_end(along, each.phase, configuration, normal[:, :-1])
        gradients[place, list(columns)] = rates
    return _nearest(motion, found, gradients, covariance)


def nearest(found: Iterable[NearestGrazing | None]) -> NearestGrazing | None:
    """The grazing that is the fewest standard errors away."""

    def far(each: NearestGrazing) -> tuple[float, float]:
        distance = each.standard_errors
        return (np.inf if np.isnan(distance) else distance, each.margin)

    return min((each for each in found if each is not None), key=far, default=None)


def _nearest(
    motion: Trajectory,
    found: Sequence[_Approach],
    gradients: np.ndarray,
    covariance: np.ndarray,
) -> NearestGrazing | None:
    """The approach that is the fewest standard errors away."""
    structure = motion.structure

    def told(each: _Approach, gradient: np.ndarray) -> NearestGrazing:
        configuration = int(motion.run.configurations[each.phase])
        return NearestGrazing(
            kind=each.kind,
            boundary=structure.boundaries[configuration][each.boundary].name,
            configuration=structure.configurations[configuration],
            time=each.time,
            margin=each.margin,
            standard_errors=_distance(each.margin, gradient, covariance),
        )

    return nearest(map(told, found, gradients))


def _same(row: np.ndarray, _: int) -> np.ndarray:
    """A row that is the same in all configurations."""
    return row


def _of_end(
    along: OrbitMotionDerivatives, phase: int, configuration: int, normal: np.ndarray
) -> np.ndarray:
    """Derivatives of the height behind a boundary that ends a phase of a response."""
    state = along.state(phase, along.dwell[phase], along.waits[:, phase])
    field = along.numbers.fields[:, configuration]
    rate = np.einsum("qij,qj->qi", field[..., :-1], state) + field[..., -1]
    speed = np.einsum("qi,qi->q", normal, rate)
    bend = np.einsum("qi,qij,qj->q", normal, field[..., :-1], rate)
    return imaginary_parts(speed**2 / (-2 * bend), None)


def _distance(margin: float, gradient: np.ndarray, covariance: np.ndarray) -> float:
    moved = np.flatnonzero(gradient)
    variance = float(gradient[moved] @ covariance[np.ix_(moved, moved)] @ gradient[moved])
    if not variance >= 0:  # NaN: an unknown that nothing tells, or at its bound
        return float("nan")
    return margin / float(np.sqrt(variance)) if variance > 0 else float("inf")


def _approaches(motion: Trajectory) -> Iterator[_Approach]:
    """Maxima of boundary functions inside phases, and slow arrivals at their ends."""
    system, structure = motion.system, motion.structure
    most = max(map(len, structure.boundaries), default=0)
    size = len(structure.states)
    if not most or not motion.end > 0:
        return
    rows = np.zeros((len(structure.configurations), most, size + 1))
    for configuration, shapes in enumerate(structure.boundaries):
        rows[configuration, : len(shapes)] = system.rows[[shape.row for shape in shapes]]
    for phase, reached in enumerate(motion.boundaries[1:]):
        configuration = int(motion.run.configurations[phase])
        for place, shape in enumerate(structure.boundaries[configuration]):
            if shape.name in reached:
                row, state = system.rows[shape.row, :-1], motion.before[phase + 1]
                speed, bend = _arrival(row, system.fields[configuration], state)
                if speed > 0 > bend:
                    height = speed**2 / (-2 * bend)
                    time = float(motion.times[phase + 1])
                    yield _Approach("slowly reached", phase, place, time, height)
    phases = phases_of(motion)
    for found in local_maxima(system, phases, rows):
        if found.value < 0:
            time = float(phases.begins[found.phase]) + found.since
            yield _Approach("missed", found.phase, found.function, time, -found.value)


def _arrival(row: np.ndarray, field: np.ndarray, state: np.ndarray) -> tuple[float, float]:
    """First and second derivative by time of a boundary function at a state."""
    rate = field @ np.append(state, 1.0)
    return float(row @ rate), float(row @ field[:, :-1] @ rate)


def _gradients(
    motion: Trajectory,
    unknowns: Unknowns,
    number: int,
    found: list[_Approach],
) -> np.ndarray:
    """Derivatives (n, q) of the margins by the unknowns, zero by those of other experiments.

    They are NaN where the motion has no derivatives.
    """
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
    missed = [each for each in found if each.kind == "missed"]
    try:
        derivatives = motion.derivatives(by, times=np.array([each.time for each in missed]))
        states, before = derivatives.states, derivatives.before
    except NonsmoothError:
        return np.full_like(gradients, np.nan)
    tables = table_changes(motion, by)
    inside = iter(range(len(missed)))
    for place, each in enumerate(found):
        configuration = int(motion.run.configurations[each.phase])
        row = motion.structure.boundaries[configuration][each.boundary].row
        if each.kind == "missed":
            normal, at = motion.system.rows[row, :-1], np.append(motion(each.time), 1.0)
            gradients[place, columns] = -(normal @ states[next(inside)] + tables.rows[:, row] @ at)
        else:
            gradients[place, columns] = _of_arrival(
                motion, each.phase, row, tables, before[each.phase + 1]
            )
    return gradients


def _of_arrival(
    motion: Trajectory, phase: int, row: int, tables: TableDerivatives, before: np.ndarray
) -> np.ndarray:
    """Derivatives of the height speed^2 / (-2 bend) that a motion would reach behind a boundary.

    Derivatives `before` (N, q) are those of the state in front of the transition, which moves.
    """
    configuration = int(motion.run.configurations[phase])
    field, normal = motion.system.fields[configuration], motion.system.rows[row, :-1]
    matrix, at = field[:, :-1], np.append(motion.before[phase + 1], 1.0)
    rate = field @ at
    speed, bend = _arrival(normal, field, motion.before[phase + 1])
    fields, normals = tables.fields[:, configuration], tables.rows[:, row, :-1]
    rates = fields @ at + (matrix @ before).T
    speeds = normals @ rate + rates @ normal
    bends = normals @ matrix @ rate + fields[..., :-1] @ rate @ normal + rates @ matrix.T @ normal
    return np.asarray(speed * speeds / -bend + speed**2 * bends / (2 * bend**2))
