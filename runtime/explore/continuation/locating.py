"""Events between neighbouring points of a branch, located on it to full precision.

Between two points the numbers that are watched are looked at along the branch's cubic
interpolation: a change of sign is an event, and so may be an extremum near zero. There the
branch itself decides: the extremum is beyond zero, which makes two events, or touches it, or
stays away.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from operator import attrgetter
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Chebyshev

from nonsmooth.runtime.explore.continuation.event import KINDS, Event, Monitor, Monitors
from nonsmooth.runtime.explore.continuation.stepping import correct, tangent_at
from nonsmooth.runtime.orbits.equations import OrbitEquations

_SAME = 1e-9  # of a chord: two names of one event
_TOUCHING = 1e-6  # of a chord: two crossings of one number that are one touch
_TOUCHED = 1e-11, 1e-13  # of an extremum's surroundings, of a usual value: zero but for rounding
# of a polynomial; of the values around a zero: what its terms of high degree may be
_NODES, _FIT = 8, 0.05
_APART, _JUMP = 1e-3, 0.5  # so near to a zero no value is as large as those around it
_MEETING = 1e-3  # of a chord: a branch that turns where it meets another one
_NOTHING = 1e-9  # of a number made of multipliers
_HALVINGS = 50
_FINEST = 1e-15  # of a chord
_ROUNDING = 1e-13  # of the values at the ends: there a number is zero
# what rounding leaves of zero, of a usual value, and at most of the values at the ends
_NOISE, _MOST_NOISE = 16 * float(np.finfo(float).eps), 1e-10
_POLE = 1e3  # of the values at the ends: so large is it between them beside a pole alone

_PARTS = 3  # of a step: looked at one by one
_TOGETHER = 500  # places whose flows are in memory at once
_LEAST_COSINE = 0.99  # between the tangent and that of the interpolation
_BESIDE = 1e-3  # of a chord: where the branch is still determined beside a singular point

_TOUCHES = ", touched and not passed"

# of several that fall together the first says most
_PRECEDENCE = ("simultaneous", "tangent", "grazing", "entry", "condition")


class Track:
    """The steps of a branch, and the values of the watched functions along them.

    Places count the steps of the branch; the rest is the part of the chord between two points.
    The attribute `places` (k,) has several of each step, and the last point of the branch.
    """

    def __init__(self, monitors: Monitors, points: np.ndarray, tangents: np.ndarray) -> None:
        self.monitors, self.curve = monitors, monitors.curve
        self._points, self._tangents = points, tangents
        self._known: dict[tuple[int, float], np.ndarray | None] = {}
        count = len(points) - 1
        steps = np.repeat(np.arange(count), _PARTS)
        found, part, ahead = self.interpolated(steps, np.tile(np.arange(_PARTS) / _PARTS, count))
        found[::_PARTS], ahead[::_PARTS] = points[:-1], tangents[:-1]
        self.places = np.append(steps + part, count)
        self._samples = np.vstack([found, points[-1:]]), np.vstack([ahead, tangents[-1:]])

    def samples(self) -> np.ndarray:
        """Values (k, m) of all functions at the places, on the cubic interpolation of the branch.

        Its error is of the fourth order in the step.
        """
        known, parts = self.monitors, -(-len(self.places) // _TOGETHER)
        split = (np.array_split(each, parts) for each in self._samples)
        with np.errstate(all="ignore"):  # infinite where a boundary is touched
            values = [
                np.hstack([known.smooth_values(z, ahead), known.border_values(z)[0]])
                for z, ahead in zip(*split, strict=True)
            ]
        return np.vstack(values)

    def interpolated(
        self, steps: np.ndarray, r: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Points, parts of the chord and tangents of the cubics of steps, at r from 0 to 1."""
        sizes, r = self.curve.sizes, r[:, None]
        first, last = self._points[steps] / sizes, self._points[steps + 1] / sizes
        chord = last - first
        length = np.linalg.norm(chord, axis=-1, keepdims=True)
        before, after = length * self._tangents[steps], length * self._tangents[steps + 1]
        bend = (1 - r) * before - r * after + (2 * r - 1) * chord
        along = r * chord + r * (1 - r) * bend
        change = chord + (1 - 2 * r) * bend + r * (1 - r) * (2 * chord - before - after)
        part = (along * chord).sum(axis=-1) / (length[:, 0] ** 2)
        ahead = change / np.linalg.norm(change, axis=-1, keepdims=True)
        return (first + along) * sizes, part, ahead

    def point(self, step: int, part: float) -> np.ndarray | None:
        """The point (n + 1,) of the branch across from a part (0 to 1) of a step's chord, or None.

        None stands for a failure of Newton's method.
        """
        if part in (0.0, 1.0):
            return np.asarray(self._points[step + int(part)])
        key = step, part
        if key not in self._known:
            found = self._across(step, part)
            if found is None:  # a branch point: between its neighbours
                sides = [self._across(step, part + side) for side in (-_BESIDE, _BESIDE)]
                if sides[0] is not None and sides[1] is not None:
                    found = (sides[0] + sides[1]) / 2
            self._known[key] = found
        return self._known[key]

    def _across(self, step: int, part: float) -> np.ndarray | None:
        first, last = self._points[step : step + 2] / self.curve.sizes
        chord = (last - first) / np.linalg.norm(last - first)
        guess, *_ = self.interpolated(np.array([step]), np.array([part]))
        offset = float(chord @ (first + part * (last - first)))
        found = correct(self.curve, guess[0], chord, offset)
        return None if found is None else found[0]

    def at(self, place: float) -> tuple[int, float]:
        """Number of the step and part of its chord of a place, counted in steps."""
        step = min(int(place), len(self._points) - 2)
        return step, place - step


def locate_all(track: Track) -> list[Event]:
    """All events between the points of a branch, in their order."""
    found: list[Event] = []
    watched = (*track.monitors.smooth, *track.monitors.borders)
    for monitor, values in zip(watched, track.samples().T, strict=True):
        usual = float(np.nanmedian(abs(values))) if np.isfinite(values).any() else 0.0
        events = _located(_Watch(track, monitor, usual), values)
        found += _touches_merged(sorted(events, key=attrgetter("place")))
    found.sort(key=attrgetter("place"))
    return _distinct(_at_meetings(found))


class _Watch(NamedTuple):
    """One of the watched functions along a branch."""

    track: Track
    monitor: Monitor
    usual: float  # size of its values

    def value(self, step: int, part: float) -> float:
        """Exact value at a part (0 to 1) of a step's chord; NaN without a point of the branch."""
        track, point = self.track, self.track.point(step, part)
        if point is None:
            return float("nan")
        _, _, (near,) = track.interpolated(np.array([step]), np.array([part]))
        ahead = near if self.monitor.source else tangent_at(track.curve, point, near)
        if ahead @ near < _LEAST_COSINE:  # a branch point, which has two tangents
            ahead = near
        return track.monitors.value(self.monitor, point, ahead)

    def at(self, place: float) -> float:
        """Exact value at a place; the samples themselves lie on the interpolation."""
        return self.value(*self.track.at(place))


def _located(watch: _Watch, values: np.ndarray) -> Iterator[Event]:
    """Events of one function, from its values at the samples."""
    signs, last = _signs(values), len(values) - 1
    if watch.usual < _NOTHING and not watch.monitor.source:
        return  # a multiplier that is 1 or -1 all along
    changes = np.flatnonzero(signs[:-1] * signs[1:] < 0).tolist()
    crossed: set[int] = set()
    for number in changes:
        window = range(max(0, number - 1), min(last, number + 2) + 1)
        crossed |= _crossed(watch, window)
    for number in _extrema(values, signs):
        if crossed & {number - 1, number}:
            continue
        window = range(number - 1, number + 2)
        if inside := _crossed(watch, window):
            crossed |= inside
            continue
        yield from _around_extremum(watch, window, float(signs[number]))
    places = watch.track.places.tolist()
    for number in sorted(crossed):
        yield from _crossings(watch, places[number], places[number + 1])


def _crossed(watch: _Watch, window: range) -> set[int]:
    """Numbers of the samples in a window behind which the exact values change sign."""
    signs = _signs(
        np.array([watch.at(place) for place in watch.track.places[list(window)].tolist()])
    )
    return {k for k, (s, t) in zip(window, pairwise(signs), strict=False) if s * t < 0}


def _extrema(values: np.ndarray, signs: np.ndarray) -> list[int]:
    """Numbers of the samples at which a function is near zero compared with its change around."""
    size = abs(values)
    before, here, after = size[:-2], size[1:-1], size[2:]
    same = (signs[:-2] == signs[1:-1]) & (signs[1:-1] == signs[2:])
    with np.errstate(invalid="ignore"):
        change = np.maximum(before, after) - here
        near = same & (here <= before) & (here <= after) & (change > 0) & (here <= change)
    return [int(k) + 1 for k in np.flatnonzero(near)]


class _BeyondZero(Exception):
    """Raised when an extremum is beyond zero, with its place."""

    def __init__(self, place: float) -> None:
        self.place = place


def _around_extremum(watch: _Watch, window: range, sign: float) -> Iterator[Event]:
    """Events around an extremum near zero: two crossings, one touch, or none."""
    from scipy.optimize import minimize_scalar

    if watch.monitor.kind == "condition":
        return  # what is touched and not crossed leads where it did
    low, middle, high = places = watch.track.places[list(window)].tolist()
    around = max(abs(watch.at(place)) for place in places)
    error = _TOUCHED[0] * around + _TOUCHED[1] * watch.usual

    def height(place: float) -> float:
        found = sign * watch.at(place)
        if found < -error:
            raise _BeyondZero(place)
        return found if np.isfinite(found) else np.inf

    try:
        least = minimize_scalar(height, (low, middle, high), method="brent", tol=1e-9)
    except ValueError:  # no minimum between them: the exact values fall to one side
        return
    except _BeyondZero as extremum:
        yield from _crossings(watch, low, extremum.place)
        yield from _crossings(watch, extremum.place, high)
        return
    if abs(least.fun) <= error:
        step, part = watch.track.at(float(least.x))
        yield from _event(watch, step, part)


def _crossings(watch: _Watch, first: float, last: float) -> Iterator[Event]:
    """Events where the function changes its sign between two places, step by step."""
    nodes = [float(k) for k in range(math.floor(first) + 1, math.ceil(last))]
    for begin, end in pairwise([first, *nodes, last]):
        step, low = watch.track.at(begin)
        high = end - step
        before, after = watch.value(step, low), watch.value(step, high)
        if not (before * after < 0 or before == 0):
            continue
        value = partial(watch.value, step)
        largest = max(abs(before), abs(after))
        noise = min(_NOISE * watch.usual, _MOST_NOISE * largest)
        part = _root(value, low, high, before, after, max(noise, _ROUNDING * largest))
        apart = _APART * (high - low)
        beside = () if part is None else (max(part - apart, low), min(part + apart, high))
        # values beside a zero are small, as they are at no pole and at no jump
        if part is None or not max(abs(value(side)) for side in beside) <= _JUMP * largest:
            if watch.monitor.kind not in ("fold", "branch-point"):
                continue  # a pole, or another maximum has become the highest
            part = _fitted(value, low, high, largest)
            if part is None:
                continue
        yield from _event(watch, step, part, (low, high))


def _event(
    watch: _Watch, step: int, part: float, around: tuple[float, float] | None = None
) -> Iterator[Event]:
    """The event at a place, if it is one; if `around` is None the function only touches zero."""
    track, monitor = watch.track, watch.monitor
    curve, point = track.curve, track.point(step, part)
    if point is None or not track.monitors.confirmed(monitor, point):
        return
    if monitor.kind == "condition" and around is not None:
        sides = [track.point(step, side) for side in around]
        before, after = curve.taken(curve.conditions(np.array(sides)))[:, monitor.phase]
        if before == after:
            return  # the others decide
    time = track.monitors.at_border(monitor, point)[1] if monitor.source else None
    yield _touching(describe(curve, monitor, point, step + part, time), around is None)


def _touching(event: Event, touching: bool = True) -> Event:
    text = event.text.removesuffix(_TOUCHES) + _TOUCHES * touching
    return replace(event, touching=touching, text=text)


def _touches_merged(found: list[Event]) -> list[Event]:
    """Events with one touch in place of two crossings that cannot be distinguished."""
    kept: list[Event] = []
    for each in found:
        if kept and each.place - kept[-1].place < _TOUCHING:
            kept[-1] = _touching(kept[-1])
        else:
            kept.append(each)
    return kept


def _signs(values: np.ndarray) -> np.ndarray:
    """Signs along a branch; an exact zero has the sign of the point before."""
    signs = np.sign(values)
    for place in range(1, len(signs)):
        if signs[place] == 0:
            signs[place] = signs[place - 1]
    return np.asarray(signs)


def _fitted(
    value: Callable[[float], float], low: float, high: float, largest: float
) -> float | None:
    """The zero of a polynomial fit, where the values themselves are mere rounding errors.

    Where branches meet the equations do not determine the tangent.
    """
    fit = Chebyshev.interpolate(np.vectorize(value), _NODES - 1, domain=[low, high])
    if not np.abs(fit.coef[_NODES // 2 :]).sum() <= _FIT * largest:
        return None  # a pole, or a value that is not determined
    roots = [
        root.real
        for root in np.asarray(fit.roots(), dtype=complex).tolist()
        if abs(root.imag) < _APART and low < root.real < high
    ]
    return roots[0] if len(roots) == 1 else None


def _root(
    value_at: Callable[[float], float],
    low: float,
    high: float,
    before: float,
    after: float,
    rounding: float,
) -> float | None:
    """Place where a function changes sign; None if it has a pole or is undefined in between.

    Values as small as `rounding` are zero.
    """
    from scipy.optimize import brentq

    largest = max(abs(before), abs(after))

    def value(part: float) -> float:
        if part in (low, high):
            return before if part == low else after
        found = value_at(part)
        if not abs(found) <= _POLE * largest:
            raise ArithmeticError
        return found if abs(found) > rounding else 0.0

    try:
        return float(brentq(value, low, high, xtol=_FINEST, rtol=4 * np.finfo(float).eps))
    except (ArithmeticError, RuntimeError):  # RuntimeError: no convergence at a jump
        return None


def _at_meetings(found: list[Event]) -> list[Event]:
    """The events with one branch point where branches meet, even if the branch turns there."""
    folds = [each for each in found if each.kind == "fold"]
    meetings: list[Event] = []
    for each in found:
        if each.kind == "branch-point" and not _near(each, meetings):
            turns = _near(each, folds)
            meetings.append(_touching(each, each.touching and not turns))
    met = [each for each in folds if _near(each, meetings)]
    others = [each for each in found if each.kind != "branch-point" and each not in met]
    return sorted([*others, *meetings], key=attrgetter("place"))


def _near(event: Event, found: Sequence[Event], within: float = _MEETING) -> bool:
    return any(abs(event.place - other.place) < within for other in found)


def _distinct(found: list[Event]) -> list[Event]:
    """The events with each border collision once, under the kind that says most."""
    others = [each for each in found if each.kind not in _PRECEDENCE]
    distinct: list[Event] = []
    for kind in _PRECEDENCE:
        for each in found:
            if each.kind == kind and not _near(each, distinct, _SAME):
                distinct.append(each)
    return sorted([*others, *distinct], key=attrgetter("place"))


def locate_limits(track: Track, admissible: np.ndarray, found: list[Event]) -> list[Event]:
    """New events where admissibility changes between points and no border collision explains it.

    `admissible` (k,) is that of the points; `found` are the events that are known already.
    """
    limits, curve = [], track.curve
    for row in np.flatnonzero(admissible[1:] != admissible[:-1]).tolist():
        if any(row <= each.place <= row + 1 and each.border_collision for each in found):
            continue
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            point = track.point(row, middle)
            if point is None:
                break
            same = bool(curve.admissible(point[None])[0]) == bool(admissible[row])
            low, high = (middle, high) if same else (low, middle)
        inside, outside = (low, high) if admissible[row] else (high, low)
        point, beyond = track.point(row, inside), track.point(row, outside)
        if point is None or beyond is None:
            continue
        monitor = Monitor("admissibility")
        for first in curve.at(beyond).admissibility.violations[:1]:
            monitor = Monitor("admissibility", first.phase, first.boundary)
        limits.append(describe(curve, monitor, point, row + inside))
    return limits


def describe(
    curve: OrbitEquations,
    monitor: Monitor,
    point: np.ndarray,
    place: float,
    time: float | None = None,
) -> Event:
    """The event of a monitor at a point (n + 1,) of the branch.

    `place` is as `Track` counts it; `time` since the start of the phase, or None.
    """
    phase: int | None = None
    configuration = where = ""
    if monitor.phase >= 0:
        phase = monitor.phase
        configuration = curve.phases[phase % len(curve.phases)][0]
        where = f": {monitor.boundary} in {configuration} (phase {phase + 1})"
    when = "" if time is None else f" at t = {time:.6g}"
    value = float(point[-1])
    return Event(
        kind=monitor.kind,
        parameter=curve.parameter,
        value=value,
        unknowns=dict(zip(curve.unknowns, point[:-1].tolist(), strict=True)),
        phase=phase,
        configuration=configuration,
        boundary=monitor.boundary,
        time=time,
        place=place,
        text=f"{curve.parameter} = {value:.10g}: {KINDS[monitor.kind].text}{where}{when}",
    )
