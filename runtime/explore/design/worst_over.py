"""The worst along a branch made as small as it can be, over other parameters.

What has to hold all along the branch is asked for at a few values of that parameter, where it is
worst; they are looked for along the whole branch, and added to, until nothing is worse between
them: the exchange method of semi-infinite programming (R. Hettich and K. Kortanek, SIAM Review
35, 1993). At an interior maximum the derivative along the branch is zero, so that the maximum
changes by the parameters as the quantity does at a fixed value (J. Danskin, 1967).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.optimising import (
    INTERRUPTED,
    Aim,
    Ended,
    Trial,
    optimise,
    watched_margins,
)
from nonsmooth.runtime.explore.design.quantities import extreme_keys

_FINE = 1e-12  # of the interval: place of an extreme
_BESIDE = 1e-4  # of the interval: for the second derivative at an extreme
_APART = 1e-7  # of the interval: nearer ones are one
_STEPS = 8  # of Newton's method
_STILL, _LONGEST = 1e-7, 0.03  # of the interval: of its steps
_FLATTER = 0.1  # of a second derivative: where it falls by more it is kept
_LOOKS, _FINER = 33, 4  # values along the branch; so many times more in the last look
_ROUNDS = 30
_WORSE = 1e-11  # by which a place between the watched ones may be worse


class _Place(NamedTuple):
    """A place along a branch where something is worst."""

    part: float  # position in the branch's interval, from 0 to 1
    row: int  # number of the alarm that has a minimum there
    bend: float  # its second derivative inside the interval, 0 where the place is fixed


def _alarms(aim: Aim, member: DesignPoint, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Numbers (m,) that are smaller where an orbit is worse, and derivatives (m,).

    The derivatives are along the branch. The numbers belong to the objective, then to the
    conditions, then to the margins. The branch's parameter is the last of the member's, and
    `length` is that of its interval.
    """
    margins = aim.distances(member)
    asked = [(aim.quantity, "<=" if aim.sign > 0 else ">=", 0.0, aim.scale)]
    asked += [(*condition.asked, aim.size(condition)) for condition in aim.conditions]
    values, slopes = [], []
    for quantity, relation, wanted, size in asked:
        value, slope = aim.distance(member, quantity, relation, wanted)
        values.append(value / size)
        slopes.append(float(slope[-1]) / size)
    return (
        np.concatenate([values, margins[0]]),
        np.concatenate([slopes, margins[1][:, -1]]) * length,
    )


def _member_at(points: DesignPoints, place: np.ndarray, part: float) -> DesignPoint:
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


def _scanned(
    points: DesignPoints, place: np.ndarray, begin: float, count: int
) -> list[DesignPoint]:
    """`count` orbits evenly along a branch, each reached from a neighbour.

    `points` covers the parameters of the design, at `place` (q,), and, as the last, that of the
    branch, where an orbit is known at the part `begin`. Raises `Beyond` if the branch does not
    cover its interval; the reason names the value where it ends.
    """
    parts = np.linspace(0.0, 1.0, count)
    order = np.argsort(np.abs(parts - begin), kind="stable")
    found = {k: _member_at(points, place, float(parts[k])) for k in order.tolist()}
    return [found[k] for k in range(count)]


def _worst_places(
    points: DesignPoints, aim: Aim, place: np.ndarray, scan: Sequence[DesignPoint]
) -> list[_Place]:
    """Places along a branch where something is worst, in order.

    For the quantity that is minimised they are all local maxima; for each condition and each
    margin they are the place where it is nearest to a violation. `scan` is that of the branch
    at the parameters `place` (q,). Raises `Beyond` if the branch does not lead to one of them.
    """
    parts = np.linspace(0.0, 1.0, len(scan))
    alarms = np.array([_alarms(aim, member, points.lengths[-1]) for member in scan])
    found: list[_Place] = []
    for row in range(alarms.shape[2]):

        def at(part: float, row: int = row) -> tuple[float, float]:
            member = _member_at(points, place, part)
            value, slope = _alarms(aim, member, points.lengths[-1])
            return float(value[row]), float(slope[row])

        values, slopes = alarms[:, :, row].T
        least = _least(parts, values, slopes, at, every=row == 0)
        found += [_Place(part, row, bend) for part, bend in least]
    found.sort()
    return [w for k, w in enumerate(found) if k == 0 or w.part - found[k - 1].part > _APART]


def _least(
    parts: np.ndarray,
    values: np.ndarray,
    slopes: np.ndarray,
    at: Callable[[float], tuple[float, float]],
    *,
    every: bool,
) -> list[tuple[float, float]]:
    """Places of the local minima of a function, with its second derivatives inside, else 0.

    `at` gives its value and slope at a place; where the slope is NaN it counts as zero. Unless
    `every` is set, only minima that may be the least one are kept.
    """
    from scipy.optimize import brentq, minimize_scalar

    last = len(parts) - 1
    most = np.inf if every else values.min() + np.ptp(values) / max(last, 1)
    turning = [k for k in range(last) if slopes[k] < 0 < slopes[k + 1]]
    found = []

    def slope(part: float) -> float:
        return float(np.nan_to_num(at(part)[1]))

    for k in turning:
        if min(values[k : k + 2]) <= most:
            inside = float(brentq(slope, parts[k], parts[k + 1], xtol=_FINE))
            beside = inside + (_BESIDE if inside < 0.5 else -_BESIDE)
            bend = (at(beside)[1] - at(inside)[1]) / (beside - inside)
            found.append((inside, max(float(np.nan_to_num(bend)), 0.0)))
    around = np.concatenate([[np.inf], values, [np.inf]])
    lowest = (values <= around[:-2]) & (values < around[2:]) & (values <= most)
    for k in np.flatnonzero(lowest).tolist():
        inner = 0 < k < last
        if inner and np.isnan(slopes[k - 1 : k + 2]).any():
            bounds = parts[k - 1], parts[k + 1]
            corner = minimize_scalar(lambda x: at(x)[0], bounds=bounds, options={"xatol": 1e-9})
            found.append((float(corner.x), 0.0))
        elif not inner or not {k - 1, k} & {*turning}:
            found.append((float(parts[k]), 0.0))
    return found


@dataclass(frozen=True, eq=False)
class _BranchPoint:
    """Orbits of one branch at parameters that were tried."""

    place: np.ndarray  # (q,), of the parameters in their bounds
    members: tuple[DesignPoint, ...]  # orbits at the watched places of the branch's parameter
    watches: tuple[_Place, ...]  # these places


class BranchPoints:
    """The orbits of a branch where something is worst, for each trial of a design.

    A place inside the branch's interval moves with the parameters, so that it stays worst.
    `points` covers the parameters of the design and, as the last, that of the branch; `begin`
    (q,) is the place of the first trial, and raises `Beyond` if there is no orbit. The
    attribute `visited` lists all trials.
    """

    def __init__(
        self, points: DesignPoints, aim: Aim, begin: np.ndarray, watches: Iterable[_Place]
    ) -> None:
        self.points, self._aim = points, aim
        self.visited: list[_BranchPoint] = [self._found(begin, tuple(watches))]

    def at(self, place: np.ndarray) -> _BranchPoint:
        """The orbits at a place (q,) in units of the bounds; raises `Beyond` without one."""
        for known in reversed(self.visited):
            if np.array_equal(known.place, place):
                return known
        gaps = [float(np.abs(known.place - place).max()) for known in self.visited]
        near = self.visited[int(np.argmin(gaps))]
        try:
            found = self._found(place.copy(), near.watches)
        except Beyond as ended:
            raise Beyond(near.place, place, min(gaps) / 2, ended.reason) from None
        self.visited.append(found)
        return found

    def _found(self, place: np.ndarray, watches: tuple[_Place, ...]) -> _BranchPoint:
        moved = [self._moved(place, watch) for watch in watches]
        members, places = zip(*moved, strict=True)
        return _BranchPoint(place, members, places)

    def _moved(self, place: np.ndarray, watch: _Place) -> tuple[DesignPoint, _Place]:
        """The orbit at a watched place that moves with the parameters, and the place.

        It is the zero of the slope along the branch, by Newton's method.
        """
        part, row, bend = watch
        member = _member_at(self.points, place, part)
        for _ in range(_STEPS if bend > 0 else 0):
            slope = self._slope(member, row)
            step = float(np.clip(-slope / bend, -_LONGEST, _LONGEST))
            following = float(np.clip(part + step, 0.0, 1.0))
            if not abs(following - part) > _STILL:  # also where there is no derivative
                break
            try:
                other = _member_at(self.points, place, following)
            except Beyond:
                break
            found = (self._slope(other, row) - slope) / (following - part)
            bend = found if found > _FLATTER * bend else bend
            member, part = other, following
        return member, _Place(part, row, bend)

    def _slope(self, member: DesignPoint, row: int) -> float:
        return float(_alarms(self._aim, member, self.points.lengths[-1])[1][row])


def spread(points: DesignPoints, aim: Aim) -> tuple[Aim, BranchPoints]:
    """The aim for all orbits of a branch, and the first trial.

    `points` covers the parameters of the design and, as the last, that of the branch; `aim` is
    that of the orbit where the design begins. Raises `InputError` if the branch of the orbit
    does not cover its interval.
    """
    first = points.visited[0]
    place, begin = first.place[:-1], float(first.place[-1])
    try:
        scan = _scanned(points, place, begin, _LOOKS)
        margins = dict(aim.margins)
        for member in scan if margins else ():
            for key, unit in watched_margins(member.quantities, aim.lengths).items():
                margins.setdefault(key, unit)
        size = max(abs(member.quantities.values[aim.quantity]) for member in scan)
        every = [member.quantities.derivatives for member in scan]
        whole = replace(
            aim,
            margins=margins,
            scale=max(size, aim.scale),
            extremes=extreme_keys(every, aim.quantity) if aim.extremes else (),
            spread=True,
        )
        worst = _worst_places(points, whole, place, scan)
        return whole, BranchPoints(points, whole, place, worst)
    except Beyond as ended:
        low, high = points.bounds[-1]
        raise InputError(
            f"{first.orbit.name} is not there for all {points.names[-1]} = {low:g} to {high:g}:"
            f" {ended.reason}"
        ) from None


def optimise_worst(
    points: BranchPoints,
    aim: Aim,
    most: int,
    history: list[Trial],
) -> Ended:
    """The trial that minimises the worst value along a branch.

    The optimiser works with the orbits at the watched places. After each of its rounds the
    whole branch is scanned, in the end four times as finely, and places that are worse are
    watched too. The point that results holds the orbits at the worst places of its branch.
    `most` limits the iterations in each round; the iterates are appended to `history`.
    """
    inner, watches = points.points, points.visited[0].watches
    good = points.visited[0].place
    ended = Ended(points.visited[0], "")
    try:
        for _ in range(_ROUNDS):
            ended = optimise(points, aim, most, history)
            if ended.reason == INTERRUPTED:
                break
            place = ended.point.place
            try:
                worst, worse = _looked(points, aim, ended.point)
            except Beyond as problem:  # the branch ends between the watched places
                watches = (*watches, _Place(float(problem.target[-1]), 0, 0.0))
                points = BranchPoints(inner, aim, good, watches)
                ended = Ended(points.visited[0], problem.reason)
                continue
            good = place
            if not worse:
                members = tuple(_member_at(inner, place, watch.part) for watch in worst)
                return Ended(_BranchPoint(place, members, tuple(worst)), ended.reason)
            watches = (*watches, *worse)
            points = BranchPoints(inner, aim, place, watches)
    except KeyboardInterrupt:
        ended = Ended(ended.point, INTERRUPTED)
    return ended


def _looked(points: BranchPoints, aim: Aim, point: Trial) -> tuple[list[_Place], list[_Place]]:
    """The worst places of a branch, and those that are worse than all watched ones.

    A coarse scan comes first, then a finer one if the first shows nothing worse.
    """
    inner, begin = points.points, float(points.visited[-1].watches[0].part)
    level, missed = aim.value(point), aim.missed(point)
    for count in (_LOOKS, _FINER * (_LOOKS - 1) + 1):
        worst = _worst_places(inner, aim, point.place, _scanned(inner, point.place, begin, count))
        worse = []
        for watch in worst:
            there = _BranchPoint(
                point.place, (_member_at(inner, point.place, watch.part),), (watch,)
            )
            if aim.value(there) > level + _WORSE or aim.missed(there) > missed + _WORSE:
                worse.append(watch)
        if worse:
            break
    return worst, worse
