"""A branch between its points: interpolated for a first look, exact where it is asked for."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.continuation.monitors import Monitors
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily
from nonsmooth.runtime.explore.continuation.stepping import correct, tangent_at

__all__ = ["BranchSamples", "Track"]

_PARTS = 3  # of a step: looked at one by one
_LEAST_COSINE = 0.99  # between the tangent and that of the interpolation
_BESIDE = 1e-3  # of a chord: where the branch is still determined beside a singular point


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
