"""The worst along a branch made as small as it can be, over other parameters.

What has to hold all along the branch is asked for at a few values of that parameter, where it is
worst; they are looked for along the whole branch, and added to, until nothing is worse between
them: the exchange method of semi-infinite programming (R. Hettich and K. Kortanek, SIAM Review
35, 1993). At an interior maximum the derivative along the branch is zero, so that the maximum
changes by the parameters as the quantity does at a fixed value (J. Danskin, 1967).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.design.design_points import (
    Beyond,
    DesignPoint,
    DesignPoints,
    Trial,
    WorstPlace,
)
from nonsmooth.runtime.explore.design.optimising import (
    INTERRUPTED,
    Aim,
    Ended,
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


@dataclass(frozen=True, eq=False)
class Trials:
    """The trials of a design: of one orbit each, or of those of a branch that are worst.

    `points` covers the parameters of the design and, if there is one, that of a branch. A place
    inside the branch's interval moves with the parameters, so that it stays worst.
    """

    points: DesignPoints
    aim: Aim
    most: int  # iterations in each round of an optimiser
    history: list[Trial]  # the iterates
    visited: list[Trial] = field(default_factory=list)  # all trials, in their order

    def begun(self, place: np.ndarray, watches: Sequence[WorstPlace] = ()) -> Trials:
        """The same design with one trial alone, at a place (q,), and these places watched."""
        return replace(self, visited=[self._found(place, watches)])

    def at(self, place: np.ndarray) -> Trial:
        """The trial at a place (q,) in units of the bounds; raises `Beyond` without an orbit."""
        for known in reversed(self.visited):
            if np.array_equal(known.place, place):
                return known
        gaps = [float(np.abs(known.place - place).max()) for known in self.visited]
        near = self.visited[int(np.argmin(gaps))]
        try:
            found = self._found(place.copy(), near.watches)
        except Beyond as ended:
            if not near.watches:
                raise
            raise Beyond(near.place, place, min(gaps) / 2, ended.reason) from None
        self.visited.append(found)
        return found

    def _found(self, place: np.ndarray, watches: Sequence[WorstPlace]) -> Trial:
        if not watches:
            member = self.points.at(place)
            return Trial(member.place, (member,))
        members, places = zip(*(self._moved(place, watch) for watch in watches), strict=True)
        return Trial(place, members, places)

    def _moved(self, place: np.ndarray, watch: WorstPlace) -> tuple[DesignPoint, WorstPlace]:
        """The orbit at a watched place that moves with the parameters, and the place.

        It is the zero of the slope along the branch, by Newton's method.
        """
        part, row, bend = watch
        member = self.member_at(place, part)
        for _ in range(_STEPS if bend > 0 else 0):
            slope = self._alarms(member)[1][row]
            step = float(np.clip(-slope / bend, -_LONGEST, _LONGEST))
            following = float(np.clip(part + step, 0.0, 1.0))
            if not abs(following - part) > _STILL:  # also where there is no derivative
                break
            try:
                other = self.member_at(place, following)
            except Beyond:
                break
            found = (self._alarms(other)[1][row] - slope) / (following - part)
            bend = found if found > _FLATTER * bend else bend
            member, part = other, following
        return member, WorstPlace(part, row, bend)

    def _alarms(self, member: DesignPoint) -> tuple[list[float], list[float]]:
        """Numbers (m,) that are smaller where an orbit is worse, and derivatives (m,).

        The derivatives are along the branch. The numbers belong to the objective, then to the
        conditions, then to the margins.
        """
        aim, length = self.aim, self.points.lengths[-1]
        margins = aim.distances(member)
        asked = [(aim.quantity, "<=" if aim.sign > 0 else ">=", 0.0, aim.scale)]
        asked += [(*condition.asked, aim.size(condition)) for condition in aim.conditions]
        values, slopes = [], []
        for quantity, relation, wanted, size in asked:
            value, slope = aim.distance(member, quantity, relation, wanted)
            values.append(value / size)
            slopes.append(float(slope[-1]) / size)
        return (
            np.concatenate([values, margins[0]]).tolist(),
            (np.concatenate([slopes, margins[1][:, -1]]) * length).tolist(),
        )

    def member_at(self, place: np.ndarray, part: float) -> DesignPoint:
        """The orbit at parameters `place` (q,) and at a part (0 to 1) of the branch's interval.

        Raises `Beyond` if it does not exist; the reason names the value of the branch's parameter.
        """
        points = self.points
        try:
            return points.at(np.append(place, part))
        except Beyond as ended:
            value = points.bounds[-1, 0] + part * points.lengths[-1]
            told = f"{ended.reason} at {points.names[-1]} = {value:.6g}"
            raise Beyond(ended.near, ended.target, ended.distance, told) from None

    def scanned(self, place: np.ndarray, begin: float, count: int) -> list[DesignPoint]:
        """`count` orbits evenly along a branch, each reached from a neighbour.

        An orbit is known at the part `begin`. Raises `Beyond` if the branch does not cover its
        interval; the reason names the value where it ends.
        """
        parts = np.linspace(0.0, 1.0, count)
        order = np.argsort(np.abs(parts - begin), kind="stable")
        found = {k: self.member_at(place, float(parts[k])) for k in order.tolist()}
        return [found[k] for k in range(count)]

    def worst_places(self, place: np.ndarray, scan: Sequence[DesignPoint]) -> list[WorstPlace]:
        """Places along a branch where something is worst, in order.

        For the quantity that is minimised they are all local maxima; for each condition and each
        margin they are the place where it is nearest to a violation. `scan` is that of the branch
        at the parameters `place` (q,). Raises `Beyond` if the branch does not lead to one of them.
        """
        parts = np.linspace(0.0, 1.0, len(scan))
        alarms = np.array([self._alarms(member) for member in scan])
        found: list[WorstPlace] = []
        for row in range(alarms.shape[2]):

            def at(part: float, row: int = row) -> tuple[float, float]:
                value, slope = self._alarms(self.member_at(place, part))
                return value[row], slope[row]

            values, slopes = alarms[:, :, row].T
            least = _least(parts, values, slopes, at, every=row == 0)
            found += [WorstPlace(part, row, bend) for part, bend in least]
        found.sort()
        return [w for k, w in enumerate(found) if k == 0 or w.part - found[k - 1].part > _APART]

    def looked(self, point: Trial) -> tuple[list[WorstPlace], list[WorstPlace]]:
        """The worst places of a branch, and those that are worse than all watched ones.

        A coarse scan comes first, then a finer one if the first shows nothing worse.
        """
        aim, place, begin = self.aim, point.place, self.visited[-1].watches[0].part
        level, missed = aim.value(point), aim.missed(point)
        for count in (_LOOKS, _FINER * (_LOOKS - 1) + 1):
            worst = self.worst_places(place, self.scanned(place, begin, count))
            worse = []
            for watch in worst:
                there = Trial(place, (self.member_at(place, watch.part),))
                if aim.value(there) > level + _WORSE or aim.missed(there) > missed + _WORSE:
                    worse.append(watch)
            if worse:
                break
        return worst, worse


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


def spread(trials: Trials) -> Trials:
    """The same design for all orbits of a branch, with its first trial.

    Raises `InputError` if the branch of the orbit does not cover its interval.
    """
    points, aim = trials.points, trials.aim
    first = points.visited[0]
    place, begin = first.place[:-1], float(first.place[-1])
    try:
        scan = trials.scanned(place, begin, _LOOKS)
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
        trials = replace(trials, aim=whole)
        return trials.begun(place, trials.worst_places(place, scan))
    except Beyond as ended:
        low, high = points.bounds[-1]
        raise InputError(
            f"{first.orbit.name} is not there for all {points.names[-1]} = {low:g} to {high:g}:"
            f" {ended.reason}"
        ) from None


def optimise_worst(trials: Trials) -> Ended:
    """The trial that minimises the worst value along a branch.

    The optimiser works with the orbits at the watched places. After each of its rounds the
    whole branch is scanned, in the end four times as finely, and places that are worse are
    watched too. The trial that results holds the orbits at the worst places of its branch.
    """
    ended = Ended(trials.visited[0], "")
    good, watches = ended.point.place, ended.point.watches
    try:
        for _ in range(_ROUNDS):
            ended = optimise(trials)
            if ended.reason == INTERRUPTED:
                break
            try:
                worst, worse = trials.looked(ended.point)
            except Beyond as problem:  # the branch ends between the watched places
                watches = (*watches, WorstPlace(float(problem.target[-1]), 0, 0.0))
                trials = trials.begun(good, watches)
                ended = Ended(trials.visited[0], problem.reason)
                continue
            good = ended.point.place
            if not worse:
                members = tuple(trials.member_at(good, watch.part) for watch in worst)
                return Ended(Trial(good, members), ended.reason)
            watches = (*watches, *worse)
            trials = trials.begun(good, watches)
    except KeyboardInterrupt:
        ended = Ended(ended.point, INTERRUPTED)
    return ended
