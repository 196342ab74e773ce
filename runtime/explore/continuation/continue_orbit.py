"""Periodic orbits followed over one parameter."""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.explore.continuation.branch import Branch, StabilityOfPoint
from nonsmooth.runtime.explore.continuation.event import Event, point_of
from nonsmooth.runtime.explore.continuation.locating import describe, locate_all, locate_limits
from nonsmooth.runtime.explore.continuation.monitors import Monitor, monitors_of
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily, check_interval
from nonsmooth.runtime.explore.continuation.stepping import (
    INTERRUPTED,
    STEP,
    Path,
    check_steps,
    tangent_at,
    trace_both_ways,
)
from nonsmooth.runtime.model.saved_system import check_same_system
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.shooting.newton import SHORTEST

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.continue_event import Locus

__all__ = ["continue_orbit"]

MOST_POINTS = 2000
MET = "it meets the branch that it doubles"
_NEUTRAL = 1e-10  # distance of a multiplier from the unit circle that is not decided


@overload
def continue_orbit(
    orbit: Orbit,
    parameter: str,
    interval: tuple[float, float],
    *,
    step: float | None = None,
    points: int | None = None,
    admissible: bool = False,
    resume: Branch | None = None,
    progress: Callable[[int], object] | None = None,
) -> Branch: ...
@overload
def continue_orbit(
    orbit: Branch,
    parameter: str,
    interval: tuple[float, float],
    *,
    event: Event,
    step: float | None = None,
    points: int | None = None,
    progress: Callable[[int], object] | None = None,
) -> Locus: ...


def continue_orbit(
    orbit: Orbit | Branch,
    parameter: str,
    interval: tuple[float, float],
    *,
    event: Event | None = None,
    step: float | None = None,
    points: int | None = None,
    admissible: bool = False,
    resume: Branch | None = None,
    progress: Callable[[int], object] | None = None,
) -> Branch | Locus:
    """Follow a periodic orbit over one parameter, or an event of its branch over a second one.

    An orbit is followed through folds, in both directions, to the ends of the interval, or to
    where a dwell time goes to zero; one whose phases repeat also to where the repetitions become
    the same.

    Parameters
    ----------
    orbit : Orbit or Branch
        A converged orbit; a branch, if one of its events is followed.
    parameter : str
        One of the numbers that were given for the orbit: a parameter, an unknown that was
        exchanged for one, or ``"period"`` where that was given. For an event a second one beside
        that of the branch.
    interval : (float, float)
        Around the orbit's own value.
    event : Event, optional
        One of the branch's events, but for limits of admissibility that no boundary explains.
    step : float, optional
        The largest one, of arclength, 0.01 when omitted: the parameter in units of the
        interval's length, unknowns in units of their size. For an event 0.02; the branch's
        parameter in units of the branch's range.
    points : int, optional
        At most so many in each direction; 2000 when omitted, for an event 500.
    admissible : bool, default False
        End also where the orbit ceases to be a motion of the real system.
    resume : Branch, optional
        An interrupted one of the same family: it goes on where it was left.
    progress : callable, optional
        Told how many points there are, as they come.

    Returns
    -------
    Branch or Locus
        The branch of an orbit, with all events on it: folds, flips, Neimark-Sacker and branch
        points, and what ends an itinerary, each on the branch to full precision. For an event
        its curve in the plane of both parameters.

    Raises
    ------
    InputError
        For an orbit that has not converged, a name that was not given, an interval that is
        empty, does not hold the orbit or leaves the parameter's domain, options that are
        none, or another family's branch to resume; for an event that cannot be followed, or
        without its branch, and for what only orbits have.
    Interrupted
        By Ctrl-C; its `partial` is the Branch, with its events, or the Locus until then.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    >>> [event.kind for event in branch.events], branch.ends[0]
    (['grazing', 'flip'], 'end of the interval')
    >>> flip = branch.events[1]
    >>> locus = ns.continue_orbit(branch, "eta", (3.9, 4.1), event=flip)
    >>> locus.parameters, locus.ends
    (('V', 'eta'), ('end of the interval', 'end of the interval'))
    """
    if event is not None:
        from nonsmooth.runtime.explore.continuation.continue_event import continue_event

        if not isinstance(orbit, Branch):
            raise InputError("an event is followed on its branch: give that in the orbit's place")
        if admissible or resume is not None:
            raise InputError("admissible and resume: of orbits only, not of an event")
        given: dict[str, Any] = {"step": step, "points": points}
        options = {name: value for name, value in given.items() if value is not None}
        return continue_event(orbit, event, parameter, interval, progress=progress, **options)
    step = STEP if step is None else step
    points = MOST_POINTS if points is None else points
    if isinstance(orbit, Branch):
        raise InputError("orbit is a Branch: give its .orbit, or one of its events as event=")
    limits = _checked(orbit, parameter, interval, step, points)
    if resume is not None:
        _check_same(orbit, parameter, limits, resume)
        orbit = resume.orbit
    curve = OrbitFamily(orbit, parameter, lengths=limits[1] - limits[0])
    known = None if resume is None else _path_of(curve, resume)
    told = 0

    def go_on(before: np.ndarray, z: np.ndarray) -> str | None:
        nonlocal told
        told += 1
        if progress is not None:
            progress(told)
        parts = zip(curve.unevenness(before), curve.unevenness(z), strict=True)
        if any(first @ second < 0 for first, second in parts):
            return MET
        if admissible and not curve.admissible(z[None])[0]:
            return "the orbit is no motion of the real system beyond"
        return None

    path = trace_both_ways(curve, limits, step, points, go_on, known)
    stopped = INTERRUPTED in path.ends
    if stopped and len(path.points) < 2:
        raise KeyboardInterrupt
    try:
        branch = _branch(curve, path)
    except KeyboardInterrupt:  # the points are there: what is known of them is found nevertheless
        stopped, branch = True, _branch(curve, path)
    if stopped:
        raise Interrupted(branch)
    return branch


def _check_same(orbit: Orbit, parameter: str, limits: tuple[float, float], known: Branch) -> None:
    """Refuse to go on with a branch of another orbit, parameter or value."""
    own, other = (x.name.removeprefix(x.system.name) for x in (orbit, known.orbit))
    if (other, known.parameter) != (own, parameter):
        raise InputError(f"the branch to resume is of {known.name} over {known.parameter}")
    check_same_system("branch", orbit.system, known.orbit.system)
    asked = {name: value for name, value in orbit.given.items() if name != parameter}
    check_same_question("branch", asked, known.orbit.given)
    values = known.parameter_values
    if not (limits[0] <= values.min() and values.max() <= limits[1]):
        raise InputError("the branch to resume leaves the interval")


def _path_of(curve: OrbitFamily, branch: Branch) -> Path:
    """The path that a branch was made from."""
    points = np.column_stack([branch.unknowns, branch.parameter_values])
    chords = np.gradient(points / curve.sizes, axis=0)
    tangents = [tangent_at(curve, z, chord) for z, chord in zip(points, chords, strict=True)]
    return Path(points, np.array(tangents), branch.ends, branch.start)


def _branch(curve: OrbitFamily, path: Path) -> Branch:
    """The branch of a path, with its events."""
    points, ends = path.points, path.ends
    found = locate_all(monitors_of(curve, points), points, path.tangents)
    found = _with_meetings(curve, found, path)
    allowed = curve.admissible(points)
    vanished = _vanished(curve, points, ends)
    found = [
        each
        for each in found
        if not (
            (each.border_collision or each.kind == "fold")
            and any(_vanishes(curve, each, end) for end in vanished)
        )
    ]
    found += vanished
    found += locate_limits(curve, points, allowed, found)
    found.sort(key=attrgetter("place"))
    multipliers = curve.multipliers(points)
    return Branch(
        parameter=curve.parameter,
        parameter_values=points[:, -1],
        unknown_names=curve.names,
        unknowns=points[:, :-1],
        period=curve.order * curve.dwell(points).sum(axis=-1),
        multipliers=multipliers**curve.order,
        trace=curve.traces(points),
        stability=tuple(_verdict(row, curve.conservative) for row in multipliers),
        admissible=allowed,
        events=tuple(found),
        ends=ends,
        start=path.start,
        orbit=curve.orbit,
    )


def _with_meetings(curve: OrbitFamily, found: list[Event], path: Path) -> list[Event]:
    """The events with one branch point where the branch turns back with its parts exchanged."""
    for step, reason in zip((0, len(path.points) - 2), path.ends, strict=True):
        names = [
            each
            for each in found
            if step <= each.place <= step + 1 and each.kind in ("fold", "branch-point")
        ]
        if reason != MET or not names:
            continue
        turn = next((each for each in names if each.kind == "fold"), names[0])
        event = describe(curve, Monitor("branch-point"), point_of(turn), turn.place)
        found = [each for each in found if each not in names] + [event]
    return found


def _vanished(curve: OrbitFamily, points: np.ndarray, ends: tuple[str, str]) -> list[Event]:
    """Events at the ends where a dwell time has gone to zero."""
    found = []
    for place, reason in zip((0, len(points) - 1), ends, strict=True):
        if reason.endswith("goes to zero"):
            phase = curve.dwell_names.index(reason.removesuffix(" goes to zero"))
            monitor = Monitor("vanishing-phase", phase, curve.phases[phase][1])
            found.append(describe(curve, monitor, points[place], float(place)))
    return found


def _vanishes(curve: OrbitFamily, event: Event, end: Event) -> bool:
    """Whether the phase of an end is so short that an event only restates its vanishing."""
    dwell = curve.dwell(point_of(event)[None])[0]
    return bool(dwell[end.phase] < SHORTEST * dwell.sum())


def _verdict(multipliers: np.ndarray, conservative: bool) -> StabilityOfPoint:
    """Stability of one point, from its multipliers over one part."""
    largest = float(abs(multipliers).max(initial=0.0))
    if not math.isfinite(largest):
        return "undecided"
    if conservative:
        if largest - 1 > math.sqrt(_NEUTRAL):
            return "unstable"
        if len(multipliers) and largest < 1 - math.sqrt(_NEUTRAL):
            return "stable"
        real = (abs(multipliers.imag) < math.sqrt(_NEUTRAL)).any()
        return "undecided" if real and len(multipliers) else "neutral"
    if abs(largest - 1) < _NEUTRAL:
        return "undecided"
    return "stable" if largest < 1 else "unstable"


def _checked(
    orbit: Orbit, parameter: str, interval: Any, step: float, points: int
) -> tuple[float, float]:
    check_converged(orbit, "followed")
    limits = check_interval(orbit, parameter, interval)
    check_steps(step, points)
    return limits
