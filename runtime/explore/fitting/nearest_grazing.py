"""How far a fitted motion stays from grazing, up to where its derivatives hold.

Two things lead to a grazing: a boundary function whose maximum inside a phase is nearly zero, and
a boundary that is reached so slowly that the function would turn soon behind it. The margin is how
far the maximum, found or continued, is from zero, in the unit of the boundary function; to first
order it moves with the unknowns as the function at a fixed time does. No maximum is missed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts
from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.simulation.moved_phases import MovedPhases
from nonsmooth.runtime.simulation.phase_functions import boundary_rows, local_maxima, phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives

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
    since: float  # time since the phase's beginning
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
    columns = unknowns.columns(number)

    def moved() -> MovedPhases | None:
        return motion.derivatives(columns).moved_phases() if columns else None

    return _nearest(motion, moved, [*columns.values()], covariance)


def nearest_grazing_of_response(
    orbit: OrbitDerivatives, columns: Sequence[int], covariance: np.ndarray
) -> NearestGrazing | None:
    """The place where a steady response is the fewest standard errors from grazing, or None.

    It is None if no boundary function has a maximum in a phase. `orbit` has the derivatives by
    free parameters, whose places among the unknowns are `columns`; `covariance` is (q, q).
    """

    def moved() -> MovedPhases:
        return orbit.along.moved

    return _nearest(orbit.orbit.trajectory(), moved, columns, covariance)


def nearest(found: Iterable[NearestGrazing | None]) -> NearestGrazing | None:
    """The grazing that is the fewest standard errors away."""

    def far(each: NearestGrazing) -> tuple[float, float]:
        distance = each.standard_errors
        return (np.inf if np.isnan(distance) else distance, each.margin)

    return min((each for each in found if each is not None), key=far, default=None)


def _nearest(
    motion: Trajectory,
    moved: Callable[[], MovedPhases | None],
    columns: Sequence[int],
    covariance: np.ndarray,
) -> NearestGrazing | None:
    """The place that is the fewest standard errors away; None if there is none.

    `moved` gives the phases as they move with the unknowns in `columns`; without derivatives the
    distance is NaN.
    """
    structure = motion.structure
    found = sorted(_approaches(motion), key=lambda each: each.margin)[:_KEPT]
    if not found:
        return None
    gradients = np.zeros((len(found), len(covariance)))
    try:
        phases = moved()
        if phases is not None:
            gradients[:, list(columns)] = _gradients(phases, found)
    except NonsmoothError:
        gradients[:] = np.nan

    def told(each: _Approach, gradient: np.ndarray) -> NearestGrazing:
        configuration = int(motion.run.configurations[each.phase])
        return NearestGrazing(
            kind=each.kind,
            boundary=structure.boundaries[configuration][each.boundary].name,
            configuration=structure.configurations[configuration],
            time=float(motion.times[each.phase]) + each.since,
            margin=each.margin,
            standard_errors=_distance(each.margin, gradient, covariance),
        )

    return nearest(map(told, found, gradients))


def _gradients(moved: MovedPhases, found: Sequence[_Approach]) -> np.ndarray:
    """Derivatives (n, q) of the margins."""
    places = np.array([each.phase for each in found])
    since = np.array([each.since for each in found])
    shapes = moved.system.structure.boundaries
    rows = [shapes[moved.phases.configurations[a.phase]][a.boundary].row for a in found]
    missed = np.array([each.kind == "missed" for each in found])
    gradients = np.empty((len(found), len(moved.numbers.rows)))
    normals = moved.numbers.rows[:, np.array(rows)[missed]]
    inside = moved.differentiated(normals, places[missed], since[missed])
    for place in range(len(found)):
        if missed[place]:
            gradients[place] = -next(inside).rates
        else:
            gradients[place] = imaginary_parts(
                _height(*moved.arrival(places[place], rows[place])), None
            )
    return gradients


def _height(speed: Any, bend: Any) -> Any:
    """What a boundary function that is reached would rise to behind it, with such derivatives."""
    return speed**2 / (-2 * bend)


def _distance(margin: float, gradient: np.ndarray, covariance: np.ndarray) -> float:
    moved = np.flatnonzero(gradient)
    variance = float(gradient[moved] @ covariance[np.ix_(moved, moved)] @ gradient[moved])
    if not variance >= 0:  # NaN: an unknown that nothing tells, or at its bound
        return float("nan")
    return margin / float(np.sqrt(variance)) if variance > 0 else float("inf")


def _approaches(motion: Trajectory) -> Iterator[_Approach]:
    """Maxima of boundary functions inside phases, and slow arrivals at their ends."""
    system, structure = motion.system, motion.structure
    if not any(structure.boundaries) or not motion.end > 0:
        return
    for phase, reached in enumerate(motion.boundaries[1:]):
        configuration = int(motion.run.configurations[phase])
        field = system.fields[configuration]
        rate = field @ np.append(motion.before[phase + 1], 1.0)
        for place, shape in enumerate(structure.boundaries[configuration]):
            if shape.name in reached:
                normal = system.rows[shape.row, :-1]
                speed, bend = float(normal @ rate), float(normal @ field[:, :-1] @ rate)
                if speed > 0 > bend:
                    since = float(motion.times[phase + 1] - motion.times[phase])
                    yield _Approach("slowly reached", phase, place, since, _height(speed, bend))
    for found in local_maxima(system, phases_of(motion), boundary_rows(system)):
        if found.value < 0:
            yield _Approach("missed", found.phase, found.function, found.since, -found.value)
