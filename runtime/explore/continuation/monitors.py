"""Numbers whose sign changes where something happens along a branch, at its points and between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.boundary_functions import PhaseWaves, ends_of, interior_maxima
from nonsmooth.runtime.explore.continuation.event import KINDS, OrbitKind
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily
from nonsmooth.runtime.explore.continuation.stepping import correct, tangent_at

__all__ = ["BranchSamples", "Monitor", "Monitors", "Track", "monitors_of"]

_ZERO = 1e-9  # relative size below which a boundary function counts as zero at an end
_SAMPLES = 7  # points at which is looked for what is zero all along
_PARTS = 3  # of a step: looked at one by one
_LEAST_COSINE = 0.99  # between the tangent and that of the interpolation
_BESIDE = 1e-3  # of a chord: where the branch is still determined beside a singular point


@dataclass(frozen=True)
class Monitor:
    """A watched function: its event's kind, phase and boundary, and where its values are."""

    kind: str
    phase: int = -1
    boundary: str = ""
    source: str = ""
    column: int = 0


@dataclass(frozen=True)
class Monitors:
    """All functions that are watched along a branch."""

    curve: OrbitFamily
    smooth: tuple[Monitor, ...]  # functions of the multipliers and the tangent
    borders: tuple[Monitor, ...]  # functions of boundaries and conditions

    def smooth_values(self, z: np.ndarray, tangents: np.ndarray) -> np.ndarray:
        """Values (k, m) of the smooth functions at points (k, n + 1).

        The unit tangents (k, n + 1) are in the curve's units.
        """
        multipliers, slopes = self.curve.multipliers(z), tangents[:, -1]
        here = _orbit_kind(self.curve, multipliers)
        tests = [KINDS[monitor.kind].test for monitor in self.smooth]
        with np.errstate(all="ignore"):  # a slope may be zero
            values = [test(multipliers, slopes, here) for test in tests if test is not None]
        return np.stack(values, axis=-1)

    def border_values(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Values and times since the start of the phase, both (k, m), at points (k, n + 1).

        They are NaN where the function does not exist.
        """
        values = np.full((len(z), len(self.borders)), np.nan)
        times = np.full((len(z), len(self.borders)), np.nan)
        conditions = self.curve.conditions(z)
        for places, phases in self.curve.waves(z):
            known = {waves.phase: _border(waves) for waves in phases}
            for column, monitor in enumerate(self.borders):
                found = known[monitor.phase]
                if monitor.source == "condition":
                    values[places, column] = conditions[places, monitor.column]
                    times[places, column] = found["leaving"][1][:, 0]
                    continue
                numbers, when = found[monitor.source]
                values[places, column] = numbers[:, monitor.column]
                times[places, column] = when[:, monitor.column]
        return values, times

    def confirmed(self, monitor: Monitor, z: np.ndarray) -> bool:
        """Whether a zero at z (n + 1,) is the event, and not a pole or a neutral saddle."""
        kind = KINDS[monitor.kind]
        return kind.test is None or kind.holds(self.curve.multipliers(z[None])[0])


def _orbit_kind(curve: OrbitFamily, multipliers: np.ndarray) -> OrbitKind:
    return OrbitKind(multipliers.shape[-1], curve.order == 2, curve.conservative)


def _border(waves: PhaseWaves) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Values and times (k, b) by source."""
    ends, (highest, when) = ends_of(waves), interior_maxima(waves)
    begun = np.zeros_like(highest)
    over = np.broadcast_to(waves.durations[:, None], highest.shape)
    return {
        "highest": (highest, when),
        "start": (ends.starts[0], begun),
        "beginning": (ends.starts[1], begun),
        "stop": (ends.stops[0], over),
        "leaving": (ends.stops[1], over),
    }


def monitors_of(curve: OrbitFamily, points: np.ndarray) -> Monitors:
    """The functions to watch along a branch with points (k, n + 1).

    A boundary function that vanishes at an end of a phase along the whole branch is the
    boundary with which the phase begins or ends: its rate is watched instead.
    """
    some = points[np.unique(np.linspace(0, len(points) - 1, _SAMPLES).astype(int))]
    here = _orbit_kind(curve, curve.multipliers(some))
    smooth = tuple(
        Monitor(name)
        for name, kind in KINDS.items()
        if kind.test is not None and kind.watched(here)
    )
    groups = [phases for _, phases in curve.waves(some)]
    borders: list[Monitor] = []
    for number, waves in enumerate(groups[0]):
        ends = [ends_of(phases[number]) for phases in groups]
        begun = _always_zero([(end.starts, end.sizes) for end in ends])
        over = _always_zero([(end.stops, end.sizes) for end in ends])
        for place, name in enumerate(waves.names):
            watched = waves.phase, name
            borders.append(Monitor("grazing", *watched, "highest", place))
            if waves.leaving is None:
                continue  # the motion goes on: no end is one of its own
            if not begun[0, place]:
                borders.append(Monitor("entry", *watched, "start", place))
            elif not begun[1, place]:
                borders.append(Monitor("tangent", *watched, "beginning", place))
            if place == waves.leaving:
                borders.append(Monitor("tangent", *watched, "leaving", place))
            elif not over[0, place]:
                borders.append(Monitor("simultaneous", *watched, "stop", place))
    for column, phase in enumerate(curve.condition_places):
        watched = phase, curve.phases[phase][1]
        borders.append(Monitor("condition", *watched, "condition", column))
    return Monitors(curve, smooth, tuple(borders))


def _always_zero(groups: list[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Mask (2, b) of the functions and rates that are zero at all points, by their sizes."""
    zero = [abs(values) <= _ZERO * sizes for values, sizes in groups]
    return np.asarray(np.concatenate(zero, axis=1).all(axis=1))


class BranchSamples(NamedTuple):
    """Points along a branch: places (k,), points (k, n + 1) and unit tangents (k, n + 1).

    The integer part of a place counts the steps of the branch; the rest is the part of the
    chord between two points.
    """

    places: np.ndarray
    points: np.ndarray
    tangents: np.ndarray


class Track:
    """The steps of a branch, and the values of the watched functions along them."""

    def __init__(self, monitors: Monitors, points: np.ndarray, tangents: np.ndarray) -> None:
        self.monitors = monitors
        self._points, self._tangents = points, tangents
        self._known: dict[tuple[int, float], np.ndarray | None] = {}

    @property
    def curve(self) -> OrbitFamily:
        """The family of orbits."""
        return self.monitors.curve

    def samples(self) -> BranchSamples:
        """Several samples of each step, and the last point of the branch.

        Between two points they lie on the cubic interpolation of the branch, whose error is of the
        fourth order in the step.
        """
        count = len(self._points) - 1
        steps = np.repeat(np.arange(count), _PARTS)
        found, part, ahead = self._interpolated(steps, np.tile(np.arange(_PARTS) / _PARTS, count))
        found[::_PARTS], ahead[::_PARTS] = self._points[:-1], self._tangents[:-1]
        return BranchSamples(
            np.append(steps + part, count),
            np.concatenate([found, self._points[-1:]]),
            np.concatenate([ahead, self._tangents[-1:]]),
        )

    def _interpolated(
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
        guess, *_ = self._interpolated(np.array([step]), np.array([part]))
        offset = float(chord @ (first + part * (last - first)))
        found = correct(self.curve, guess[0], chord, offset)
        return None if found is None else found[0]

    def at(self, place: float) -> tuple[int, float]:
        """Number of the step and part of its chord of a place, as `BranchSamples` counts it."""
        step = min(int(place), len(self._points) - 2)
        return step, place - step

    def value(self, column: int, step: int, part: float, *, border: bool) -> float:
        """Value of one watched function at a part (0 to 1) of a step's chord; NaN without a point.

        `column` counts the smooth functions, or with `border` those of boundaries and conditions.
        """
        point = self.point(step, part)
        if point is None:
            return float("nan")
        if border:
            return float(self.monitors.border_values(point[None])[0][0, column])
        _, _, (near,) = self._interpolated(np.array([step]), np.array([part]))
        ahead = tangent_at(self.curve, point, near)
        if ahead @ near < _LEAST_COSINE:  # a branch point, which has two tangents
            ahead = near
        return float(self.monitors.smooth_values(point[None], ahead[None])[0, column])
