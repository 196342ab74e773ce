"""A branch of periodic orbits over one parameter: followed, and what can be asked of it."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from nonsmooth.runtime.composition.record import ComposedOrbit
from nonsmooth.runtime.continuation.amplitudes import amplitude_of
from nonsmooth.runtime.continuation.composed import PERIOD, ComposedCurve
from nonsmooth.runtime.continuation.curve import Curve
from nonsmooth.runtime.continuation.derived import DerivedCurve
from nonsmooth.runtime.continuation.event import Event
from nonsmooth.runtime.continuation.locating import Found, describe, locate_all, locate_limits
from nonsmooth.runtime.continuation.monitors import Monitor, monitors_of
from nonsmooth.runtime.continuation.stepping import tangent_at, trace_path
from nonsmooth.runtime.errors import InputError, missing_extra, unknown_name
from nonsmooth.runtime.newton import CONVERGED
from nonsmooth.runtime.orbit import Orbit
from nonsmooth.runtime.parameters import in_domain

__all__ = ["Branch", "check_interval", "continue_orbit", "curve_of"]

STEP, MOST_POINTS = 0.01, 2000
SAME_END = 1e-6  # of a chord: other names of a dwell time that goes to zero
_NEUTRAL = 1e-10  # distance of a multiplier from the unit circle that is not decided


@dataclass(frozen=True, eq=False)
class Branch:
    """Orbits of one itinerary along one parameter, in the order in which they follow.

    Attributes
    ----------
    name : str
        Of the orbit.
    parameter : str
    parameter_values : array (k,)
        They turn at folds.
    unknown_names : tuple of str
    unknowns : array (k, n)
    period : array (k,)
    multipliers : array (k, r), complex
        Those that may differ from zero, without the 1 that a first integral enforces.
    trace : array (k,)
        Of the Poincare map.
    stability : tuple of str
        "stable", "neutral", "unstable" or "undecided" of each point.
    admissible : array (k,) of bool
        Whether it is a motion of the real system.
    events : tuple of Event
        In their order; `Event.place` says between which points.
    ends : tuple of str
        Why the branch ends, at its beginning and at its end.
    start : int
        Which of the points it was followed from.
    orbit : Orbit or ComposedOrbit
        That point.
    """

    name: str
    parameter: str
    parameter_values: np.ndarray
    unknown_names: tuple[str, ...]
    unknowns: np.ndarray
    period: np.ndarray
    multipliers: np.ndarray
    trace: np.ndarray
    stability: tuple[str, ...]
    admissible: np.ndarray
    events: tuple[Event, ...]
    ends: tuple[str, str]
    start: int
    orbit: Any = field(repr=False)

    def __len__(self) -> int:
        return len(self.parameter_values)

    def orbit_at(self, place: int | Event) -> Orbit | ComposedOrbit:
        """The orbit at a point of the branch, by its number, or at an event.

        Raises
        ------
        InputError
            If the branch has no such point.
        """
        if isinstance(place, Event):
            z = np.array([*place.unknowns.values(), place.value])
        elif -len(self) <= place < len(self):
            z = np.append(self.unknowns[place], self.parameter_values[place])
        else:
            raise InputError(f"the branch has {len(self)} points, no point {place}")
        orbit: Orbit | ComposedOrbit = curve_of(self.orbit, self.parameter, 1.0).at(z)
        return orbit

    def next_itineraries(self, event: Event) -> tuple[ComposedOrbit, ...]:
        """Admissible orbits of other itineraries just beyond a border collision.

        Raises
        ------
        InputError
            If the event is no border collision.
        """
        from nonsmooth.runtime.continuation.beyond import next_itineraries

        return next_itineraries(self, event)

    def quantity(self, name: str) -> np.ndarray:
        """Values (k,) of something over the branch.

        Parameters
        ----------
        name : str
            "period", "frequency" (2 pi over the period), "trace", an unknown, the parameter, or
            "amplitude_x" of a state x: half of what it sweeps in a period. Over the frequency of
            a forcing that is the frequency response; of a conservative family over its period,
            beside "frequency", the backbone.

        Raises
        ------
        InputError
            For another name.
        """
        if name == self.parameter:
            return self.parameter_values
        if name == "frequency":
            return np.asarray(2 * np.pi / self.period)
        if name.startswith("amplitude_"):
            state = name.removeprefix("amplitude_")
            return np.array([amplitude_of(self.orbit_at(k), state) for k in range(len(self))])
        if name in ("period", "trace"):
            found: np.ndarray = getattr(self, name)
            return found
        if name not in self.unknown_names:
            known = ("period", "frequency", "trace", self.parameter, *self.unknown_names)
            raise unknown_name("quantity", name, known)
        return np.asarray(self.unknowns[:, self.unknown_names.index(name)])

    def to_xarray(self) -> Any:
        """The branch as an xarray Dataset over its points.

        Raises
        ------
        MissingExtra
            If xarray is not installed.
        """
        try:
            import xarray
        except ImportError:
            raise missing_extra("chart", "xarray") from None
        columns = {name: ("point", self.quantity(name)) for name in self.unknown_names}
        return xarray.Dataset(
            {
                **columns,
                "period": ("point", self.period),
                "trace": ("point", self.trace),
                "multiplier": (("point", "which"), self.multipliers),
                "stability": ("point", np.array(self.stability)),
                "admissible": ("point", self.admissible),
            },
            coords={self.parameter: ("point", self.parameter_values)},
            attrs={"orbit": self.name, "events": [event.text for event in self.events]},
        )

    def plot(self, quantity: str = "period", axes: Any = None) -> Any:
        """Draw a quantity over the parameter; see `drawing.draw_branch`."""
        from nonsmooth.runtime.continuation.drawing import draw_branch

        return draw_branch(self, quantity, axes)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the branch to a file; `nonsmooth.load_branch` reads it."""
        from nonsmooth.runtime.continuation.saved import save_branch

        save_branch(self, path)


def curve_of(orbit: Orbit | ComposedOrbit, parameter: str, length: float) -> Curve:
    """An orbit as a family over one of the numbers that were given for it."""
    if isinstance(orbit, ComposedOrbit):
        return ComposedCurve(orbit, parameter, length)
    return DerivedCurve(orbit, parameter, length)


def continue_orbit(
    orbit: Orbit | ComposedOrbit,
    parameter: str,
    interval: tuple[float, float],
    *,
    step: float = STEP,
    points: int = MOST_POINTS,
    stop: str | None = None,
    progress: Callable[[int], object] | None = None,
) -> Branch:
    """Follow a periodic orbit over one parameter, through folds, in both directions.

    It ends at the ends of the interval, or where a dwell time goes to zero.

    Parameters
    ----------
    orbit : Orbit or ComposedOrbit
        A converged one.
    parameter : str
        One of the numbers that were given for it: a parameter, an unknown that was exchanged
        for one, or ``"period"`` where that was given.
    interval : (float, float)
        Around the orbit's own value.
    step : float
        The largest one, of arclength: the parameter in units of the interval's length,
        unknowns in units of their size.
    points : int
        At most so many in each direction.
    stop : "admissible", optional
        End also where the orbit ceases to be a motion of the real system.
    progress : callable, optional
        Told how many points there are, as they come.

    Returns
    -------
    Branch
        With all events on it: folds, flips, Neimark-Sacker and branch points, and what ends
        an itinerary, each on the branch to full precision.

    Raises
    ------
    InputError
        For an orbit that has not converged, a name that was not given, an interval that is
        empty, does not hold the orbit or leaves the parameter's domain, or options that are
        none.

    Examples
    --------
    >>> import nonsmooth
    >>> orbit = nonsmooth.solve("dry-friction/global-stick")
    >>> branch = nonsmooth.continue_orbit(orbit, "V", (0.8, 1.3))
    >>> branch.ends
    ('end of the interval', 'ta goes to zero')
    """
    limits = _checked(orbit, parameter, interval, step, points, stop)
    curve = curve_of(orbit, parameter, limits[1] - limits[0])
    direction = tangent_at(curve, curve.first, np.eye(len(curve.first))[-1])
    told = 0
    paths = []

    def go_on(z: np.ndarray) -> str | None:
        nonlocal told
        told += 1
        if progress is not None:
            progress(told)
        if stop is not None and not curve.admissible(z[None])[0]:
            return "the orbit is no motion of the real system beyond"
        return None

    for sign in (-1, 1):
        path = list(trace_path(curve, sign * direction, limits, step, points, go_on))
        paths.append(path)
        if path[-1][2].endswith("closed"):
            paths = [path, []] if sign < 0 else paths
            break
    return _branch(curve, direction, paths)


_Path = list[tuple[np.ndarray, np.ndarray, str]]


def _branch(curve: Curve, direction: np.ndarray, paths: list[_Path]) -> Branch:
    """Both directions as one branch, with its events."""
    backward, forward = paths
    steps = [
        *((z, -tangent) for z, tangent, _ in reversed(backward)),
        (curve.first, direction),
        *((z, tangent) for z, tangent, _ in forward),
    ]
    points, tangents = (np.array(part) for part in zip(*steps, strict=True))
    apart = np.append(True, (points[1:] != points[:-1]).any(axis=-1))
    start = int(np.count_nonzero(apart[: len(backward) + 1])) - 1
    points, tangents = points[apart], tangents[apart]
    closed = "the branch is closed"
    ends = (backward[-1][2] if backward else closed, forward[-1][2] if forward else closed)
    found = locate_all(monitors_of(curve, points), points, tangents)
    allowed = curve.admissible(points)
    vanished = _vanished(curve, points, ends)
    found = [
        each
        for each in found
        if not (
            each.event.border_collision
            and any(abs(each.place - end.place) < SAME_END for end in vanished)
        )
    ]
    found += vanished
    found += locate_limits(curve, points, allowed, found)
    found.sort(key=lambda each: each.place)
    multipliers = curve.multipliers(points)
    return Branch(
        curve.orbit.name,
        curve.parameter,
        points[:, -1],
        curve.names,
        points[:, :-1],
        curve.order * _period(curve, points),
        multipliers**curve.order,
        curve.traces(points),
        tuple(_verdict(row, curve.conservative) for row in multipliers),
        allowed,
        tuple(replace(each.event, place=each.place) for each in found),
        ends,
        start,
        curve.orbit,
    )


def _period(curve: Curve, points: np.ndarray) -> np.ndarray:
    return np.asarray(curve.dwell(points).sum(axis=-1))


def _vanished(curve: Curve, points: np.ndarray, ends: tuple[str, str]) -> list[Found]:
    """Events at the ends where a dwell time has gone to zero."""
    found = []
    for place, reason in zip((0, len(points) - 1), ends, strict=True):
        if reason.endswith("goes to zero"):
            phase = curve.dwell_names.index(reason.removesuffix(" goes to zero"))
            monitor = Monitor("vanishing-phase", phase, curve.phases[phase][1])
            event = describe(curve, monitor, points[place], float(place), None)
            found.append(Found(float(place), points[place], event))
    return found


def _verdict(multipliers: np.ndarray, conservative: bool) -> str:
    """Of one point, from its multipliers over one part."""
    largest = float(abs(multipliers).max(initial=0.0))
    if not math.isfinite(largest):
        return "undecided"
    if conservative:
        if largest - 1 > math.sqrt(_NEUTRAL):
            return "unstable"
        real = (abs(multipliers.imag) < math.sqrt(_NEUTRAL)).any()
        return "undecided" if real and len(multipliers) else "neutral"
    if abs(largest - 1) < _NEUTRAL:
        return "undecided"
    return "stable" if largest < 1 else "unstable"


def _checked(
    orbit: Any, parameter: str, interval: Any, step: float, points: int, stop: str | None
) -> tuple[float, float]:
    if not isinstance(orbit, Orbit | ComposedOrbit):
        raise InputError(f"{type(orbit).__name__} is no orbit, such as nonsmooth.solve gives")
    if orbit.status != CONVERGED:
        raise InputError(f"{orbit.name} cannot be followed: {orbit.message}")
    limits = check_interval(orbit, parameter, interval)
    if not (math.isfinite(step) and step > 0):
        raise InputError(f"step = {step} is not positive")
    if isinstance(points, bool) or not isinstance(points, int) or points < 1:
        raise InputError(f"points = {points} is not a positive integer")
    if stop not in (None, "admissible"):
        raise InputError(f"stop = {stop!r} is neither 'admissible' nor None")
    return limits


def check_interval(
    orbit: Orbit | ComposedOrbit, parameter: str, interval: Any
) -> tuple[float, float]:
    """Ends of an interval of a number that was given for an orbit; InputError for a wrong one."""
    if parameter not in orbit.given:
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
    for table in orbit.kernels.parameters:
        if table.name == parameter:
            for end in (lower, upper):
                if not in_domain(table, end):
                    raise InputError(f"{parameter} = {end:g} is outside its domain")
    if parameter == PERIOD and isinstance(orbit, ComposedOrbit) and lower <= 0:
        raise InputError(f"period = {lower:g} is not positive")
    return lower, upper
