"""The other branch where two of them meet: twice the period, a lost symmetry, a crossing.

At such a point the equations of the other family leave two directions open. One is the tangent
of the branch that is known; the other one leads, at first order, to the other branch.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value, parse
from nonsmooth.runtime.explore.continuation.event import Event, point_of
from nonsmooth.runtime.explore.continuation.orbit_family import (
    OrbitFamily,
    SystemAt,
    composed_family,
)
from nonsmooth.runtime.explore.continuation.stepping import correct, scaled_rows
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["other_branch"]

_LENGTHS = (0.02, 0.005, 0.05, 0.1, 0.001)  # of the step from one branch to the other
_FAR = 10.0  # of that step: how far the corrector may go
_APART = 0.5  # of that step: how far from the meeting point an orbit has to be
_OPEN = 1e-3  # largest singular value, relative, of a direction that is open


def other_branch(
    branch: Branch, event: Event, parameters: Mapping[str, Any] | None = None
) -> Orbit:
    """An orbit near an event on the branch that meets this one there, admissible if possible.

    At a flip it has twice the itinerary, and nearly twice the period; at a symmetry breaking it
    is solved for without the symmetry; at a branch point it has the same itinerary. It may exist
    on either side of the event, and be no motion of the real system (`admissibility` says).
    `parameters` are those that the orbit leaves open; absent ones are chosen. Raises
    `InputError` for another kind of event or a parameter that is none of the system's, and
    `NoConvergence` if no such orbit is found.
    """
    if not event.switches:
        raise InputError(f"no other branch meets this one at a {event.kind}: {event.text}")
    base, system_at = composed_family(branch, _away(event), parameters)
    parameter = branch.parameter if branch.parameter in base.parameters else PERIOD
    if parameter == PERIOD and base.given_period is None:
        raise InputError(
            f"{branch.parameter} is no parameter of {base.system.name}: follow one that is"
        )
    curve = OrbitFamily(base, parameter, lengths=np.ptp(branch.parameter_values) or 1.0)
    meeting = _meeting(branch, event, curve, system_at)
    if event.kind == "branch-point":
        other, copies = curve, 1
    else:
        copies = curve.order * (2 if event.kind == "flip" else 1)
        unfolded = _unfolded(base, copies // curve.order)
        other = OrbitFamily(unfolded, parameter, lengths=curve.sizes[-1])
    times = copies // curve.order if parameter == PERIOD else 1
    start = _repeated(curve, meeting, copies, times)
    along = _repeated(curve, curve.first - meeting, copies, times)
    direction = _open_direction(other, start, along / other.sizes)
    signs = (1, -1) if event.kind == "branch-point" else (1,)
    tried = [(sign * direction, length) for length in _LENGTHS for sign in signs]
    found = [orbit for each in tried if (orbit := _beside(other, start, *each)) is not None]
    if not found:
        raise NoConvergence(f"no orbit was found on the other branch: {event.text}")
    if not any(orbit.converged for orbit in found):
        raise NoConvergence(
            f"the other branch has one value of {parameter} only, which does not tell its orbits"
            f" apart: {event.text}"
        )
    found.sort(key=lambda orbit: not orbit.converged or orbit.admissibility.verdict is not True)
    return found[0]


def _away(event: Event) -> int:
    """Number of the branch point beside the event that is not too near to it."""
    before = math.floor(event.place)
    if event.place == before:
        return before - 1 if before else 1
    return before if event.place - before > 0.5 else before + 1


def _meeting(branch: Branch, event: Event, curve: OrbitFamily, system_at: SystemAt) -> np.ndarray:
    """The meeting point of the branches, as a point of the family over all physical parameters."""
    if branch.unknown_names == curve.names:
        return point_of(event)
    base, orbit = curve.orbit, branch.orbit_at(event)
    parameters, period = system_at(event.value)
    dwell = [float(time) for time in orbit.dwell_times if time > 0]
    found = solve_itinerary(base.system, parameters, base.itinerary, dwell, period=period)
    if not found.converged:
        raise InputError(f"{base.name} at {event.parameter} = {event.value:.10g}: {found.message}")
    value = float(found.period) if branch.parameter not in parameters else event.value
    return np.array([*found.dwell_times, *found.states[0], value])


def _unfolded(base: Orbit, periods: int) -> Orbit:
    """The same orbit without its symmetry, over `periods` periods."""
    period = base.given_period
    return solve_itinerary(
        base.system,
        base.parameters,
        base.itinerary * periods,
        np.tile(base.dwell_times.astype(float), periods).tolist(),
        base.states[0].astype(float).tolist(),
        period=None if period is None else _times(period, periods),
    )


def _times(period: Value, count: int) -> Value:
    """A multiple of a period, exactly."""
    if period.exact is not None:
        return as_value(period.exact * count)
    return parse(f"{count}*({period.text})")


def _repeated(curve: OrbitFamily, z: np.ndarray, copies: int, times: int) -> np.ndarray:
    """The point for `copies` repetitions of a part, with the parameter multiplied by `times`."""
    count = len(curve.dwell_names)
    return np.concatenate([np.tile(z[:count], copies), z[count:-1], times * z[-1:]])


def _open_direction(curve: OrbitFamily, z: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Unit vector, in the curve's units, of the open direction across the known branch."""
    rows, _ = scaled_rows(curve.equations(z)[1] * curve.sizes)
    _, values, right = np.linalg.svd(rows)
    values = np.pad(values, (0, len(right) - len(values)))
    if values[-2] > _OPEN * values[0]:
        raise NoConvergence("the equations leave no direction open: no other branch meets here")
    first, second = right[-2:] @ along
    across = second * right[-2] - first * right[-1]
    return np.asarray(across / np.linalg.norm(across))


def _beside(
    curve: OrbitFamily, start: np.ndarray, direction: np.ndarray, length: float
) -> Orbit | None:
    """An orbit at a distance from the meeting point along a direction, or None."""
    guess = start + length * direction * curve.sizes
    found = correct(curve, guess, direction)
    if found is None or not (curve.dwell(found[0][None]) > 0).all():
        return None
    if np.linalg.norm((found[0] - guess) / curve.sizes) > _FAR * length:
        return None
    orbit = curve.at(found[0])
    if orbit.status not in (CONVERGED, SINGULAR):
        return None
    dwell = orbit.dwell_times[: len(curve.dwell_names)]
    reached = np.concatenate([dwell, orbit.states[0]]).astype(float) - start[:-1]
    return orbit if np.linalg.norm(reached / curve.sizes[:-1]) > _APART * length else None
