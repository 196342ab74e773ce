"""The worst along a branch made as small as it can be, over other parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.continuation.orbit_family import check_interval
from nonsmooth.runtime.explore.design.aim import Aim, Trial, watched_margins
from nonsmooth.runtime.explore.design.alarms import Watch
from nonsmooth.runtime.explore.design.branch_points import BranchPoint, BranchPoints
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoints
from nonsmooth.runtime.explore.design.largest import extreme_keys
from nonsmooth.runtime.explore.design.optimising import INTERRUPTED, Ended, Method, optimise
from nonsmooth.runtime.explore.design.scanning import scanned, worst_places
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["branch_interval", "optimise_worst", "spread"]

_LOOKS, _FINER = 33, 4  # values along the branch; so many times more in the last look
_ROUNDS = 30
_WORSE = 1e-11  # by which a place between the watched ones may be worse


def branch_interval(
    orbit: Orbit, worst_over: Mapping[str, tuple[float, float]] | None, varied: tuple[str, ...]
) -> tuple[str, tuple[float, float]] | None:
    """The parameter of the branch along which the worst value counts, and its interval, or None.

    Refused are several parameters, one that varies, and an interval that is empty or does not
    hold the orbit.
    """
    if worst_over is None:
        return None
    if not isinstance(worst_over, Mapping) or len(worst_over) != 1:
        raise InputError(
            'worst_over gives the interval of one parameter, such as {"w": (0.9, 1.1)}'
        )
    ((name, interval),) = worst_over.items()
    if name in varied:
        raise InputError(f"{name} varies: it cannot be the parameter of the branch too")
    return name, check_interval(orbit, name, interval)


def spread(points: DesignPoints, aim: Aim) -> tuple[Aim, BranchPoints]:
    """The aim for all orbits of a branch, and the first trial.

    `points` covers the parameters of the design and, as the last, that of the branch; `aim` is
    that of the orbit where the design begins. Raises `InputError` if the branch of the orbit
    does not cover its interval.
    """
    first = points.visited[0]
    place, begin = first.place[:-1], float(first.place[-1])
    try:
        scan = scanned(points, place, begin, _LOOKS)
        margins = dict(aim.margins)
        for member in scan.members if margins else ():
            for key, unit in watched_margins(member.quantities, aim.lengths).items():
                margins.setdefault(key, unit)
        size = max(abs(member.quantities.values[aim.quantity]) for member in scan.members)
        every = [member.quantities.derivatives for member in scan.members]
        whole = replace(
            aim,
            margins=margins,
            scale=max(size, aim.scale),
            extremes=extreme_keys(every, aim.quantity) if aim.extremes else (),
            spread=True,
        )
        worst = worst_places(points, whole, place, scan)
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
    method: Method,
    most: int,
    history: list[Trial],
) -> tuple[Ended, BranchPoints]:
    """The trial that minimises the worst value along a branch, with its watched places.

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
            ended = optimise(points, aim, method, most, history)
            if ended.reason == INTERRUPTED:
                break
            place = ended.point.place
            try:
                worst, worse = _looked(points, aim, ended.point)
            except Beyond as problem:  # the branch ends between the watched places
                watches = (*watches, Watch(float(problem.target[-1]), 0, 0.0))
                points = BranchPoints(inner, aim, good, watches)
                ended = Ended(points.visited[0], problem.reason)
                continue
            good = place
            if not worse:
                members = tuple(points.member(place, watch.part) for watch in worst)
                return Ended(BranchPoint(place, members, tuple(worst)), ended.reason), points
            watches = (*watches, *worse)
            points = BranchPoints(inner, aim, place, watches)
    except KeyboardInterrupt:
        ended = Ended(ended.point, INTERRUPTED)
    return ended, points


def _looked(points: BranchPoints, aim: Aim, point: Trial) -> tuple[list[Watch], list[Watch]]:
    """The worst places of a branch, and those that are worse than all watched ones.

    A coarse scan comes first, then a finer one if the first shows nothing worse.
    """
    inner, begin = points.points, float(points.visited[-1].watches[0].part)
    level, missed = aim.value(point), aim.missed(point)
    for count in (_LOOKS, _FINER * (_LOOKS - 1) + 1):
        worst = worst_places(inner, aim, point.place, scanned(inner, point.place, begin, count))
        worse = []
        for watch in worst:
            there = BranchPoint(point.place, (points.member(point.place, watch.part),), (watch,))
            if aim.value(there) > level + _WORSE or aim.missed(there) > missed + _WORSE:
                worse.append(watch)
        if worse:
            break
    return worst, worse
