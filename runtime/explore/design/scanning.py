"""Where along a branch what is asked for is worst: all local extremes that a scan shows."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.aim import Aim
from nonsmooth.runtime.explore.design.alarms import Watch, alarms_of
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints

__all__ = ["Scan", "member_at", "scanned", "worst_places"]

_FINE = 1e-12  # of the interval: place of an extreme
_BESIDE = 1e-4  # of the interval: for the second derivative at an extreme
_APART = 1e-7  # of the interval: nearer ones are one


class Scan(NamedTuple):
    """Orbits along a branch."""

    parts: np.ndarray  # (k,), position of the branch's parameter in its interval, from 0 to 1
    members: tuple[DesignPoint, ...]


def member_at(points: DesignPoints, place: np.ndarray, part: float) -> DesignPoint:
    """The orbit at parameters `place` (q,) and at a part (0 to 1) of the branch's interval.

    `points` covers the parameters of the design and, as the last, that of the branch. Raises
    `Beyond` if the orbit does not exist; the reason names the value of the branch's parameter.
    """
    try:
        return points.at(np.append(place, part))
    except Beyond as ended:
        value = points.bounds[-1, 0] + part * points.lengths[-1]
        told = f"{ended.reason} at {points.names[-1]} = {value:.6g}"
        raise Beyond(ended.near, ended.target, ended.distance, told) from None


def scanned(points: DesignPoints, place: np.ndarray, begin: float, count: int) -> Scan:
    """`count` orbits along a branch, each reached from a neighbour.

    `points` covers the parameters of the design, at `place` (q,), and, as the last, that of the
    branch, where an orbit is known at the part `begin`. Raises `Beyond` if the branch does not
    cover its interval; the reason names the value where it ends.
    """
    parts = np.linspace(0.0, 1.0, count)
    order = np.argsort(np.abs(parts - begin), kind="stable")
    found: dict[int, DesignPoint] = {}
    for k in order.tolist():
        found[k] = member_at(points, place, float(parts[k]))
    return Scan(parts, tuple(found[k] for k in range(count)))


def worst_places(points: DesignPoints, aim: Aim, place: np.ndarray, scan: Scan) -> list[Watch]:
    """Places along a branch where something is worst, in order.

    For the quantity that is minimised they are all local maxima; for each condition and each
    margin they are the place where it is nearest to a violation. `scan` is that of the branch
    at the parameters `place` (q,). Raises `Beyond` if the branch does not lead to one of them.
    """
    alarms = np.array([alarms_of(aim, member, points.lengths[-1]) for member in scan.members])
    found: list[Watch] = []
    for row in range(alarms.shape[2]):
        values, slopes = alarms[:, 0, row], alarms[:, 1, row]

        def at(part: float, which: int, row: int = row) -> float:
            member = member_at(points, place, part)
            return float(alarms_of(aim, member, points.lengths[-1])[which][row])

        value, slope = partial(at, which=0), partial(at, which=1)
        least = _least(scan.parts, values, slopes, value, slope, every=row == 0)
        found += [Watch(part, row, bend) for part, bend in least]
    found.sort()
    return [w for k, w in enumerate(found) if k == 0 or w.part - found[k - 1].part > _APART]


def _least(
    parts: np.ndarray,
    values: np.ndarray,
    slopes: np.ndarray,
    value: Callable[[float], float],
    slope: Callable[[float], float],
    *,
    every: bool,
) -> list[tuple[float, float]]:
    """Places of the local minima of a function, with its second derivatives inside, else 0.

    Unless `every` is set, only minima that may be the least one are kept.
    """
    from scipy.optimize import minimize_scalar

    last = len(parts) - 1
    places: list[tuple[float, float]] = []  # values and places
    for k in range(last + 1):
        before = values[k - 1] if k > 0 else np.inf
        after = values[k + 1] if k < last else np.inf
        if values[k] <= before and values[k] < after:
            places.append((float(values[k]), float(parts[k])))
    for k in range(last):
        if slopes[k] < 0 < slopes[k + 1]:
            near = min(float(values[k]), float(values[k + 1]))
            places.append((near, -1.0 - k))  # to be looked for
    if not every:
        least = min(values)
        width = float(np.ptp(values)) / max(last, 1)
        places = [each for each in places if each[0] <= least + width]
    found = []
    for _, part in places:
        if part >= 0:
            k = round(part * last)
            sides = slopes[max(k - 1, 0) : k + 2]
            if 0 < k < last and np.isnan(sides).any():
                low, high = parts[k - 1], parts[k + 1]
                inside = minimize_scalar(value, bounds=(low, high), options={"xatol": 1e-9})
                found.append((float(inside.x), 0.0))
            elif k in (0, last) or not _turns(slopes, k):
                found.append((part, 0.0))
        else:
            k = int(-part - 1)
            inside = _zero(slope, float(parts[k]), float(parts[k + 1]))
            beside = inside + (_BESIDE if inside < 0.5 else -_BESIDE)
            bend = (slope(beside) - slope(inside)) / (beside - inside)
            found.append((inside, max(float(np.nan_to_num(bend)), 0.0)))
    return found


def _turns(slopes: np.ndarray, k: int) -> bool:
    """Whether a sign change of the slope next to a place already gives this minimum."""
    return bool(slopes[k - 1] < 0 < slopes[k] or slopes[k] < 0 < slopes[k + 1])


def _zero(slope: Callable[[float], float], low: float, high: float) -> float:
    """Place where a slope turns positive; a place where the slope is NaN counts as that."""
    from scipy.optimize import brentq

    return float(brentq(lambda part: np.nan_to_num(slope(part)), low, high, xtol=_FINE))
