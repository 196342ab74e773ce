"""Events between neighbouring points of a branch, located on it to full precision."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import brentq

from nonsmooth.runtime.continuation.curve import Curve
from nonsmooth.runtime.continuation.event import KINDS, Event
from nonsmooth.runtime.continuation.monitors import Monitor, Monitors
from nonsmooth.runtime.continuation.stepping import on_chord, tangent_at

__all__ = ["Found", "describe", "locate_all", "locate_limits"]

_SAME = 1e-9  # of a chord: two names of one event
_HALVINGS = 50
_FINEST = 1e-15  # of a chord

# of several that fall together the first says most
_PRECEDENCE = ("simultaneous", "tangent", "grazing", "entry", "condition")


class Found(NamedTuple):
    """An event with its point, and its place between the points of the branch."""

    place: float
    point: np.ndarray
    event: Event


def locate_all(monitors: Monitors, points: np.ndarray, tangents: np.ndarray) -> list[Found]:
    """All events between the points (k, n + 1) of a branch, in their order."""
    smooth = monitors.smooth_values(points, tangents)
    border, _ = monitors.border_values(points)
    found = [
        *_located(monitors, monitors.smooth, smooth, points, tangents, border=False),
        *_located(monitors, monitors.borders, border, points, tangents, border=True),
    ]
    found.sort(key=lambda each: each.place)
    return _distinct(found)


def _located(
    monitors: Monitors,
    watched: tuple[Monitor, ...],
    values: np.ndarray,
    points: np.ndarray,
    tangents: np.ndarray,
    *,
    border: bool,
) -> Iterator[Found]:
    signs, taken = _signs(values), None
    if border:
        taken = monitors.curve.taken(monitors.curve.conditions(points))
    rows, columns = np.nonzero(signs[:-1] * signs[1:] < 0)
    for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
        monitor = watched[column]
        if monitor.kind == "condition" and taken is not None:
            before, after = taken[row : row + 2, monitor.phase]
            if before == after:
                continue  # the others decide
        first, last = points[row], points[row + 1]
        value_at = _value_at(monitors, first, last, tangents[row], column, border=border)
        part = _root(value_at, values[row, column], values[row + 1, column])
        point = None if part is None else on_chord(monitors.curve, first, last, part)
        if part is None or point is None or not monitors.confirmed(monitor, point):
            continue
        time = None
        if border:
            time = float(monitors.border_values(point[None])[1][0, column])
        place = row + part
        yield Found(place, point, describe(monitors.curve, monitor, point, place, time))


def _signs(values: np.ndarray) -> np.ndarray:
    """Signs along a branch; a point where something is just zero has that of the one before."""
    signs = np.sign(values)
    for row in range(1, len(signs)):
        signs[row] = np.where(signs[row] == 0, signs[row - 1], signs[row])
    return np.asarray(signs)


def _value_at(
    monitors: Monitors,
    first: np.ndarray,
    last: np.ndarray,
    tangent: np.ndarray,
    column: int,
    *,
    border: bool,
) -> Callable[[float], float]:
    """One monitor's value across from a part of a chord; NaN where there is no point."""
    curve = monitors.curve

    def value(part: float) -> float:
        point = on_chord(curve, first, last, part)
        if point is None:
            return float("nan")
        if border:
            return float(monitors.border_values(point[None])[0][0, column])
        ahead = tangent_at(curve, point, tangent)
        return float(monitors.smooth_values(point[None], ahead[None])[0, column])

    return value


def _root(value_at: Callable[[float], float], first: float, last: float) -> float | None:
    """Where a function changes sign in 0 ... 1; None where it is not defined in between."""

    def value(part: float) -> float:
        if part in (0.0, 1.0):
            return first if part == 0.0 else last
        found = value_at(part)
        if not np.isfinite(found):
            raise ArithmeticError
        return found

    try:
        return float(brentq(value, 0.0, 1.0, xtol=_FINEST, rtol=4 * np.finfo(float).eps))
    except (ArithmeticError, RuntimeError):  # RuntimeError: no convergence at a jump
        return None


def _distinct(found: list[Found]) -> list[Found]:
    """Without further names of one border collision."""
    kept: list[Found] = []
    for each in found:
        others = [
            other
            for other in kept
            if abs(other.place - each.place) < _SAME
            and other.event.kind in _PRECEDENCE
            and each.event.kind in _PRECEDENCE
        ]
        if not others:
            kept.append(each)
        elif _PRECEDENCE.index(each.event.kind) < _PRECEDENCE.index(others[0].event.kind):
            kept[kept.index(others[0])] = each
    return kept


def locate_limits(
    curve: Curve, points: np.ndarray, admissible: np.ndarray, found: list[Found]
) -> list[Found]:
    """Where admissibility changes between points and no border collision says why."""
    limits = []
    for row in np.flatnonzero(admissible[1:] != admissible[:-1]).tolist():
        if any(row <= each.place <= row + 1 and each.event.border_collision for each in found):
            continue
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            point = on_chord(curve, points[row], points[row + 1], middle)
            if point is None:
                break
            same = bool(curve.admissible(point[None])[0]) == bool(admissible[row])
            low, high = (middle, high) if same else (low, middle)
        inside, outside = (low, high) if admissible[row] else (high, low)
        point = on_chord(curve, points[row], points[row + 1], inside)
        beyond = on_chord(curve, points[row], points[row + 1], outside)
        if point is None or beyond is None:
            continue
        violations = curve.at(beyond).admissibility.violations
        monitor, time = Monitor("admissibility"), None
        if violations:
            monitor = Monitor("admissibility", violations[0].phase, violations[0].boundary)
        limits.append(
            Found(row + inside, point, describe(curve, monitor, point, row + inside, time))
        )
    return limits


def describe(
    curve: Curve, monitor: Monitor, point: np.ndarray, place: float, time: float | None
) -> Event:
    """The event of a monitor at a point of the branch."""
    phase: Any = None
    configuration = where = ""
    if monitor.phase >= 0:
        phase = monitor.phase
        configuration = curve.phases[phase % len(curve.phases)][0]
        where = f": {monitor.boundary} in {configuration} (phase {phase + 1})"
    when = "" if time is None else f" at t = {time:.6g}"
    value = float(point[-1])
    return Event(
        monitor.kind,
        curve.parameter,
        value,
        dict(zip(curve.names, point[:-1].tolist(), strict=True)),
        phase,
        configuration,
        monitor.boundary,
        time,
        place,
        f"{curve.parameter} = {value:.10g}: {KINDS[monitor.kind]}{where}{when}",
    )
