"""Pseudo-arclength continuation: tangent predictor, Newton corrector, step control.

The method is H. Keller's (Numerical solution of bifurcation and nonlinear eigenvalue problems, in
Applications of Bifurcation Theory, 1977). Lengths are measured in the curve's own units: unknowns
in those of their size, the parameter in that of its interval.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import count
from typing import NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.core.errors import InputError, check_integer

STEP = 0.01  # the largest one, in the curve's units
MOST_ITERATIONS = 8
TOLERANCE = 1e-9  # of the last step, which Newton's method squares
LEAST_STEP = 1e-3  # in units of the largest one
LEAST_COSINE = 0.97  # between the tangents at both ends of a step
FAR = 0.3  # of a step: how far the corrector may go
_APPROACHES, _LEAST_APPROACH = 60, 1e-2  # to a singular end; of the rest of the way
_SAME_POINT = 1e-12  # a branch that begins at an end of its interval has no step to it
_SINGULAR = (
    1e-9  # smallest singular value, relative to the largest, of equations with many solutions
)
_NO_ROW = 1e-10  # relative size of a row that says nothing
MOST_GROWTH = 100.0  # of an unknown, in units of its size at first
GROWN = "the orbit grows a hundredfold: a resonance"
CLOSED = "the branch is closed"
INTERRUPTED = "interrupted"
_MOST = " points"
LOST = "the branch is lost: no smaller step leads on"


class Curve(Protocol):
    """Points z = (unknowns, parameter) that solve n equations or more; see `OrbitEquations`."""

    dwell_names: tuple[str, ...]
    first: np.ndarray

    @property
    def sizes(self) -> np.ndarray:
        """Typical sizes (n + 1,) of the numbers of a point."""

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,) at one point z (n + 1,), and their Jacobian (m, n + 1)."""

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """Dwell times (k, p), affine in z (k, n + 1): the curve ends where one goes to zero."""

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """Whether a step has gone over to another branch; then a shorter one is tried."""


class Path(NamedTuple):
    """Points (k, n + 1) of a branch in order, and their tangents, all in one direction.

    `ends` says why it ends on either side; `start` is the point from which it was followed.
    """

    points: np.ndarray
    tangents: np.ndarray
    ends: tuple[str, str]
    start: int


def tangent_at(curve: Curve, z: np.ndarray, like: np.ndarray) -> np.ndarray:
    """Unit tangent (n + 1,) at z (n + 1,) in the curve's units, at no obtuse angle with `like`."""
    _, jacobian = curve.equations(z)
    scaled = scaled_rows(jacobian * curve.sizes)[0]
    direction = np.linalg.svd(scaled)[2][-1]
    if direction @ like < 0:
        direction = -direction
    return np.asarray(direction)


def correct(
    curve: Curve, guess: np.ndarray, normal: np.ndarray, offset: float | None = None
) -> tuple[np.ndarray, int] | None:
    """The point of the branch on a plane and the number of Newton's iterations; None if they fail.

    The plane is ``normal @ (z / sizes) == offset``, with `normal` (n + 1,) in the curve's
    units; without an offset it contains `guess` (n + 1,). Over q parameters there are as many
    planes: `normal` is (q, n + q).
    """
    w = guess / curve.sizes
    level = normal @ w if offset is None else offset
    with np.errstate(all="ignore"):
        for iteration in range(1, MOST_ITERATIONS + 1):
            residual, jacobian = curve.equations(w * curve.sizes)
            if not (np.isfinite(residual).all() and np.isfinite(jacobian).all()):
                return None
            rows, units = scaled_rows(jacobian * curve.sizes)
            matrix = np.concatenate([rows, normal.reshape(-1, len(w))])
            right = np.append(-residual / units, level - normal @ w)
            try:
                step = (
                    np.linalg.solve(matrix, right)
                    if len(matrix) == len(w)
                    else np.linalg.lstsq(matrix, right, rcond=None)[0]
                )
            except np.linalg.LinAlgError:
                return None
            w = w + step
            if not np.isfinite(w).all():
                return None
            if float(np.abs(step).max()) <= TOLERANCE:
                return w * curve.sizes, iteration
    return None


def trace_both_ways(
    curve: Curve,
    limits: tuple[float, float],
    step: float,
    most: int,
    *,
    known: Path | None = None,
    ended: Callable[[np.ndarray, np.ndarray], str | None] = lambda before, z: None,
    progress: Callable[[int], object] | None = None,
) -> Path:
    """The path of a branch, followed from its first point in both directions.

    The parameter increases at first. Neighbouring points differ. Ctrl-C ends the path where it
    is: such an end is INTERRUPTED. A `known` path goes on at these ends, and where it had as
    many points as were asked for. `limits` are those of the parameter, `step` is the largest
    step in the curve's units, and `most` the largest number of steps on either side, including
    those of `known`. `ended` maps two neighbouring points to the reason why the path ends
    behind them, or to None; `progress` gets the number of points that were added.
    """
    if known is None:
        direction = tangent_at(curve, curve.first, np.eye(len(curve.first))[-1])
        known = Path(curve.first[None], direction[None], (INTERRUPTED, INTERRUPTED), 0)
    points, tangents, ends, start = known.points, known.tangents, list(known.ends), known.start
    added = count(1)

    def go_on(before: np.ndarray, z: np.ndarray) -> str | None:
        if progress is not None:
            progress(next(added))
        return ended(before, z)

    for side, sign in enumerate((-1, 1)):
        if ends[side] != INTERRUPTED and not ends[side].endswith(_MOST):
            continue
        way = [*zip(points[::sign], sign * tangents[::sign], strict=True)]
        left = most - (start if side == 0 else len(points) - 1 - start)
        try:
            reason = _extend(way, curve, limits, step, left, go_on) or f"{most}{_MOST}"
        except KeyboardInterrupt:
            reason = INTERRUPTED
        start += (len(way) - len(points)) * (side == 0)
        points, tangents = (np.array(row)[::sign] for row in zip(*way, strict=True))
        tangents *= sign
        ends[side] = reason
        if reason == CLOSED:
            ends = [CLOSED, CLOSED]
        if reason == INTERRUPTED:
            break
    apart = np.append(True, _lengths(curve, points) > _SAME_POINT)
    start = int(np.count_nonzero(apart[: start + 1])) - 1
    return Path(points[apart], tangents[apart], (ends[0], ends[1]), start)


def _lengths(curve: Curve, points: np.ndarray) -> np.ndarray:
    """Lengths (k - 1,) of the chords between points (k, n + 1), in the curve's units."""
    return np.asarray(np.linalg.norm(np.diff(points / curve.sizes, axis=0), axis=1))


def _extend(
    way: list[tuple[np.ndarray, np.ndarray]],
    curve: Curve,
    limits: tuple[float, float],
    step: float,
    most: int,
    go_on: Callable[[np.ndarray, np.ndarray], str | None],
) -> str:
    """Add steps behind the last one of a way; gives why it ends, "" after `most` of them.

    The way has points and tangents, which point along it. `go_on` gives the reason why it ends
    behind two points, or None; the other arguments are as in `trace_both_ways`.
    """
    (first, direction), (z, tangent) = way[0], way[-1]
    length, whole = step / 4, float(_lengths(curve, np.array([z for z, _ in way])).sum())
    if whole > 4 * step:  # the other end may be before this one
        length = min(length, float(np.linalg.norm((z - first) / curve.sizes)))
    for _ in range(most):
        while True:
            found = _step(curve, z, tangent, length)
            if found is not None and not curve.leaps(z, found[0]):
                break
            length /= 2
            if length < LEAST_STEP * step:
                return LOST
        following, ahead, easy = found
        ended = _ended(curve, z, following, limits)
        if ended is not None:
            point, reason = ended
            way.append((point, tangent_at(curve, point, ahead)))
            return reason
        whole += length
        gap = float(np.linalg.norm((following - first) / curve.sizes))
        if whole > 4 * step and gap < 0.75 * length and ahead @ direction > LEAST_COSINE:
            way.append((first, direction))
            return CLOSED
        before, z, tangent = z, following, ahead
        unknowns = float(np.abs(z[:-1] / curve.sizes[:-1]).max())
        reason = go_on(before, z) or ("" if unknowns < MOST_GROWTH else GROWN)
        way.append((z, tangent))
        if reason:
            return reason
        if easy:
            length = min(1.5 * length, step * max(1.0, unknowns))
    return ""


def _step(
    curve: Curve, z: np.ndarray, tangent: np.ndarray, length: float
) -> tuple[np.ndarray, np.ndarray, bool] | None:
    """One step: point, tangent, and whether a longer step may be tried; None if it fails."""
    guess = z + length * tangent * curve.sizes
    found = correct(curve, guess, tangent)
    if found is None:
        return None
    point, iterations = found
    if np.linalg.norm((point - guess) / curve.sizes) > FAR * length:
        return None
    ahead = tangent_at(curve, point, tangent)
    cosine = float(ahead @ tangent)
    if cosine < LEAST_COSINE:
        return None
    return point, ahead, iterations <= 4 and cosine > 1 - (1 - LEAST_COSINE) / 3


def _ended(
    curve: Curve, z: np.ndarray, following: np.ndarray, limits: tuple[float, float]
) -> tuple[np.ndarray, str] | None:
    """The point at which a step passes an end of the interval or a dwell time vanishes, or None."""
    size, phases = len(z), len(curve.dwell_names)
    constants, *waits = curve.dwell(np.eye(size + 1, size, -1))
    axis = np.eye(size)[-1]
    normals = np.vstack([(np.array(waits) - constants).T * curve.sizes, axis, -axis])
    offsets = np.append(-constants, np.array(limits) / curve.sizes[-1] * (1, -1))
    before, after = (normals @ (point / curve.sizes) - offsets for point in (z, following))
    passed = np.flatnonzero(after <= 0).tolist()
    if not passed:
        return None
    part, place = min((before[k] / (before[k] - after[k]), k) for k in passed)
    normal, offset = normals[place], float(offsets[place])
    dwell = place < phases
    reason = f"{curve.dwell_names[place]} goes to zero" if dwell else "end of the interval"
    found = correct(curve, z + part * (following - z), normal, offset)
    if found is None or not _determined(curve, found[0], normal):
        return _before(curve, z, following, normal, offset), reason
    point = found[0]
    if not dwell:
        point[-1] = limits[place - phases]
    return point, reason


def _determined(curve: Curve, z: np.ndarray, normal: np.ndarray) -> bool:
    """Whether a point on a plane is the only one near it that solves the equations.

    A phase that takes no time has the same conditions as the phase before; orbits without it
    then solve the equations as well.
    """
    rows, _ = scaled_rows(curve.equations(z)[1] * curve.sizes)
    values = np.linalg.svd(np.concatenate([rows, normal[None]]), compute_uv=False)
    return bool(values[-1] > _SINGULAR * values[0])


def _before(
    curve: Curve, z: np.ndarray, following: np.ndarray, normal: np.ndarray, offset: float
) -> np.ndarray:
    """A point of a step as near as possible to the plane of an end, where that is singular.

    The nearer a point is to the end, the less the equations determine it. So each is
    extrapolated from the two before it, with an error of the second order in the distance.
    """
    before, inside, part = following, z, 0.5
    for _ in range(_APPROACHES):
        level, height = (float(normal @ (point / curve.sizes)) for point in (inside, before))
        target = level + part * (offset - level)
        guess = inside + (target - level) / (height - level) * (before - inside)
        found = correct(curve, guess, normal, target)
        if found is not None:
            before, inside, part = inside, found[0], 0.5
        elif part > _LEAST_APPROACH:
            part /= 2
        else:
            break
    return inside


def scaled_rows(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A matrix (m, n) with rows divided by their largest entry, and these divisors (m,).

    Rows that consist of rounding errors stay small.
    """
    units = np.abs(matrix).max(axis=1)
    largest = float(units.max(initial=0.0))
    units = np.maximum(units, _NO_ROW * largest) if largest > 0 else np.ones_like(units)
    return matrix / units[:, None], units


def check_steps(step: float, points: int) -> None:
    """Refuse a largest step (in the curve's units) or a number of points that is not positive."""
    if not (math.isfinite(step) and step > 0):
        raise InputError(f"step = {step} is not positive")
    check_integer("points", points, 1)
