"""Periodic orbits followed over one parameter, and events of their branches over two.

To follow an event the orbit's equations are joined by one that holds at it: for a fold and a
branch point that their Jacobian is singular (the last entry of the solution of a bordered system:
A. Griewank and G. Reddien, SIAM J. Numer. Anal. 21, 1984), else that the event's monitor is zero.
Its gradient and the derivatives by the second parameter are central differences, which slow
Newton's method down but do not limit what it converges to.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import attrgetter, itemgetter
from typing import Any, overload

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.explore.continuation.branch import Branch, Locus, StabilityOfPoint
from nonsmooth.runtime.explore.continuation.event import (
    Event,
    Monitor,
    Monitors,
    monitors_of,
    point_of,
)
from nonsmooth.runtime.explore.continuation.locating import (
    Track,
    describe,
    locate_all,
    locate_limits,
)
from nonsmooth.runtime.explore.continuation.stepping import (
    INTERRUPTED,
    STEP,
    Path,
    check_steps,
    tangent_at,
    trace_both_ways,
)
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.model.saved_system import check_same_system
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.shooting.newton import SHORTEST

MOST_POINTS, MOST_EVENTS = 2000, 500  # of a branch, of a curve of events
_DIFFERENCE = 1e-5  # in units of the sizes
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
        if not isinstance(orbit, Branch):
            raise InputError("an event is followed on its branch: give that in the orbit's place")
        if admissible or resume is not None:
            raise InputError("admissible and resume: of orbits only, not of an event")
        return _events(
            orbit,
            event,
            parameter,
            interval,
            2 * STEP if step is None else step,
            MOST_EVENTS if points is None else points,
            progress,
        )
    step = STEP if step is None else step
    points = MOST_POINTS if points is None else points
    if isinstance(orbit, Branch):
        raise InputError("orbit is a Branch: give its .orbit, or one of its events as event=")
    check_converged(orbit, "followed")
    limits = check_interval(orbit, parameter, interval)
    check_steps(step, points)
    if resume is not None:
        _check_same(orbit, parameter, limits, resume)
        orbit = resume.orbit
    curve = equations_of(orbit, parameter, lengths=limits[1] - limits[0])
    known = None if resume is None else _path_of(curve, resume)

    def ended(before: np.ndarray, z: np.ndarray) -> str | None:
        parts = zip(curve.unevenness(before), curve.unevenness(z), strict=True)
        if any(first @ second < 0 for first, second in parts):
            return MET
        if admissible and not curve.admissible(z[None])[0]:
            return "the orbit is no motion of the real system beyond"
        return None

    path = trace_both_ways(curve, limits, step, points, known=known, ended=ended, progress=progress)
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


def check_interval(orbit: Orbit, parameter: str, interval: Any) -> tuple[float, float]:
    """The lower and upper end of an interval of a number that was given for an orbit, checked.

    Refused are an unknown name, and an interval that is empty, leaves the domain or does not
    hold the orbit.
    """
    if not isinstance(parameter, str) or parameter not in orbit.given:
        raise unknown_name("given parameter", parameter, orbit.given)
    try:
        lower, upper = (float(end) for end in interval)
    except (TypeError, ValueError):
        raise InputError(f"the interval of {parameter} is not two numbers") from None
    value = float(orbit.given[parameter])
    if not (math.isfinite(lower) and math.isfinite(upper) and lower < upper):
        raise InputError(f"the interval of {parameter}, {lower:g} to {upper:g}, is empty")
    if not lower <= value <= upper:
        raise InputError(f"{parameter} = {value:g} of the orbit is not in {lower:g} to {upper:g}")
    for table in orbit.problem.parameters:
        if table.name == parameter:
            for end in (lower, upper):
                if not in_domain(table, end):
                    raise InputError(f"{parameter} = {end:g} is outside its domain")
    if parameter == orbit.problem.period_name and lower <= 0:
        raise InputError(f"{parameter} = {lower:g} is not positive")
    return lower, upper


def _path_of(curve: OrbitEquations, branch: Branch) -> Path:
    """The path that a branch was made from."""
    points = np.column_stack([branch.unknowns, branch.parameter_values])
    chords = np.gradient(points / curve.sizes, axis=0)
    tangents = [tangent_at(curve, z, chord) for z, chord in zip(points, chords, strict=True)]
    return Path(points, np.array(tangents), branch.ends, branch.start)


def _branch(curve: OrbitEquations, path: Path) -> Branch:
    """The branch of a path, with its events."""
    points, ends = path.points, path.ends
    track = Track(monitors_of(curve, points), points, path.tangents)
    found = _with_meetings(curve, locate_all(track), path)
    allowed = curve.admissible(points)
    vanished = _vanished(curve, points, ends)
    short = [end.phase for end in vanished]

    def restates(event: Event) -> bool:
        """Whether a phase of an end is so short that an event only restates its vanishing."""
        if not short or not (event.border_collision or event.kind == "fold"):
            return False
        dwell = curve.dwell(point_of(event)[None])[0]
        return bool((dwell[short] < SHORTEST * dwell.sum()).any())

    found = [each for each in found if not restates(each)] + vanished
    found += locate_limits(track, allowed, found)
    found.sort(key=attrgetter("place"))
    multipliers = curve.multipliers(points)
    return Branch(
        parameter=curve.parameter,
        parameter_values=points[:, -1],
        unknown_names=curve.unknowns,
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


def _with_meetings(curve: OrbitEquations, found: list[Event], path: Path) -> list[Event]:
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


def _vanished(curve: OrbitEquations, points: np.ndarray, ends: tuple[str, str]) -> list[Event]:
    """Events at the ends where a dwell time has gone to zero."""
    found = []
    for place, reason in zip((0, len(points) - 1), ends, strict=True):
        if reason.endswith("goes to zero"):
            phase = curve.dwell_names.index(reason.removesuffix(" goes to zero"))
            monitor = Monitor("vanishing-phase", phase, curve.phases[phase][1])
            found.append(describe(curve, monitor, points[place], float(place)))
    return found


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


class _EventCurve:
    """The points z = (unknowns, first parameter, second parameter) at which an event happens."""

    def __init__(self, monitors: Monitors, event: Event) -> None:
        self._monitors, self._curve = monitors, monitors.curve
        self.dwell_names, self.sizes = self._curve.dwell_names, self._curve.sizes
        self.first = np.append(point_of(event), self._curve.first[-1])
        several = _monitors_of(monitors, event)
        self._monitor, self._unit = several[0], 1.0
        self._vanishing = event.phase if event.kind == "vanishing-phase" else None
        left, _, right = np.linalg.svd(self._scaled(self.first))
        self._left, self._right = left[:, -1], right[-1]
        told = [(monitor, *self._told(monitor)) for monitor in several]
        self._monitor, _, self._unit = min(told, key=itemgetter(1))

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Curve`."""
        residual, jacobian = self._curve.equations(z)
        return np.append(residual, self._value(z)), np.vstack([jacobian, self._slopes(z)])

    def _told(self, monitor: Monitor) -> tuple[float, float]:
        """Distance of a monitor from zero in units of its change nearby, and this unit."""
        self._monitor = monitor
        unit = float(np.abs(self._slopes(self.first) * self.sizes)[:-1].max()) or 1.0
        return abs(self._value(self.first)) / unit, unit

    def _slopes(self, z: np.ndarray) -> np.ndarray:
        """Derivatives (n + 2,) of the event's function."""
        step = _DIFFERENCE * self.sizes
        rises = [self._value(z + s) - self._value(z - s) for s in np.diag(step)]
        return np.array(rises) / (2 * step)

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """False: no other branch is watched for (see `Curve`)."""
        return False

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`; the dwell time that vanishes along the whole locus is replaced by 1."""
        found = np.array(self._curve.dwell(z))
        if self._vanishing is not None:
            found[:, self._vanishing] = 1.0
        return found

    def _scaled(self, z: np.ndarray) -> np.ndarray:
        jacobian = self._curve.equations(z, by=1)[1] * self.sizes[:-1]
        units = np.abs(jacobian).max(axis=1, keepdims=True)
        return np.asarray(jacobian[:, :-1] / units)

    def _value(self, z: np.ndarray) -> float:
        """Value of the function that is zero at the event, in units of its change nearby."""
        if self._vanishing is not None:
            wait = self._curve.dwell(z[None])[0, self._vanishing]
            return float(wait / self.sizes[self._vanishing])
        if self._monitor.kind in ("fold", "branch-point"):
            jacobian = self._scaled(z)
            bordered = np.block(
                [[jacobian, self._left[:, None]], [self._right[None], np.zeros((1, 1))]]
            )
            right = np.zeros(len(bordered))
            right[-1] = 1
            return float(np.linalg.solve(bordered, right)[-1])
        return self._monitors.value(self._monitor, z, np.zeros(len(z))) / self._unit


def _events(
    branch: Branch,
    event: Event,
    parameter: str,
    interval: tuple[float, float],
    step: float,
    points: int,
    progress: Callable[[int], object] | None,
) -> Locus:
    """The curve of a branch's event in the plane of two parameters."""
    if event.kind == "admissibility":
        raise InputError("an event that no boundary explains cannot be followed")
    if parameter == branch.parameter:
        raise unknown_name(
            "second parameter", parameter, [n for n in branch.orbit.given if n != parameter]
        )
    limits = check_interval(branch.orbit, parameter, interval)
    check_steps(step, points)
    lengths = np.ptp(branch.parameter_values) or 1.0, limits[1] - limits[0]
    curve = equations_of(branch.orbit, branch.parameter, parameter, lengths=lengths)
    if len(curve.equations(curve.first)[0]) != len(curve.unknowns):
        raise InputError(f"{branch.name} is one of a family: its events are not followed")
    second = np.full(len(branch), curve.first[-1])
    known = np.column_stack([branch.unknowns, branch.parameter_values, second])
    locus = _EventCurve(monitors_of(curve, known), event)
    path = trace_both_ways(locus, limits, step, points, progress=progress)
    found = Locus(
        kind=event.kind,
        boundary=event.boundary,
        parameters=(branch.parameter, parameter),
        values=path.points[:, -2:],
        unknown_names=branch.unknown_names,
        unknowns=path.points[:, :-2],
        ends=path.ends,
        start=path.start,
        orbit=branch.orbit,
    )
    if INTERRUPTED in path.ends:
        raise Interrupted(found)
    return found


def _monitors_of(monitors: Monitors, event: Event) -> list[Monitor]:
    """Monitors that may have a zero at an event: a transition may have several conditions."""
    if event.kind == "vanishing-phase":
        return [Monitor(event.kind)]
    place = event.kind, -1 if event.phase is None else event.phase, event.boundary
    found = [
        monitor
        for monitor in (*monitors.smooth, *monitors.borders)
        if (monitor.kind, monitor.phase, monitor.boundary) == place
    ]
    if not found:
        raise InputError(f"the branch does not watch this event: {event.text}")
    return found
