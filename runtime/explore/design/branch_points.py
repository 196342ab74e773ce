"""Orbits along a branch in one more parameter, at each trial of a design.

What has to hold all along the branch is asked for at a few values of that parameter, where it is
worst; they are looked for along the whole branch, and added to, until nothing is worse between
them: the exchange method of semi-infinite programming (R. Hettich and K. Kortanek, SIAM Review
35, 1993). At an interior maximum the derivative along the branch is zero, so that the maximum
changes by the parameters as the quantity does at a fixed value (J. Danskin, 1967).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.explore.design.aim import Aim
from nonsmooth.runtime.explore.design.alarms import Watch, alarms_of
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.scanning import member_at

__all__ = ["BranchPoint", "BranchPoints"]

_STEPS = 8  # of Newton's method
_STILL, _LONGEST = 1e-7, 0.03  # of the interval: of its steps
_FLATTER = 0.1  # of a second derivative: where it falls by more it is kept


@dataclass(frozen=True, eq=False)
class BranchPoint:
    """Orbits of one branch at parameters that were tried."""

    place: np.ndarray  # (q,), of the parameters in their bounds
    members: tuple[DesignPoint, ...]  # orbits at the watched places of the branch's parameter
    watches: tuple[Watch, ...]  # these places


class BranchPoints:
    """The orbits of a branch where something is worst, for each trial of a design.

    A place inside the branch's interval moves with the parameters, so that it stays worst.
    `points` covers the parameters of the design and, as the last, that of the branch; `begin`
    (q,) is the place of the first trial, and raises `Beyond` if there is no orbit. The
    attribute `visited` lists all trials.
    """

    def __init__(
        self, points: DesignPoints, aim: Aim, begin: np.ndarray, watches: Iterable[Watch]
    ) -> None:
        self.points, self._aim = points, aim
        self.visited: list[BranchPoint] = [self._found(begin, tuple(watches))]

    @property
    def name(self) -> str:
        """Name of the branch's parameter."""
        return self.points.names[-1]

    def at(self, place: np.ndarray) -> BranchPoint:
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

    def _found(self, place: np.ndarray, watches: tuple[Watch, ...]) -> BranchPoint:
        moved = [self._moved(place, watch) for watch in watches]
        members, places = zip(*moved, strict=True)
        return BranchPoint(place, members, places)

    def _moved(self, place: np.ndarray, watch: Watch) -> tuple[DesignPoint, Watch]:
        """The orbit at a watched place that moves with the parameters, and the place.

        It is the zero of the slope along the branch, by Newton's method.
        """
        part, row, bend = watch
        member = self.member(place, part)
        for _ in range(_STEPS if bend > 0 else 0):
            slope = self._slope(member, row)
            step = float(np.clip(-slope / bend, -_LONGEST, _LONGEST))
            following = float(np.clip(part + step, 0.0, 1.0))
            if not abs(following - part) > _STILL:  # also where there is no derivative
                break
            try:
                other = self.member(place, following)
            except Beyond:
                break
            found = (self._slope(other, row) - slope) / (following - part)
            bend = found if found > _FLATTER * bend else bend
            member, part = other, following
        return member, Watch(part, row, bend)

    def _slope(self, member: DesignPoint, row: int) -> float:
        return float(alarms_of(self._aim, member, self.points.lengths[-1])[1][row])

    def member(self, place: np.ndarray, part: float) -> DesignPoint:
        """The orbit at parameters `place` (q,) and at a part (0 to 1) of the branch's interval.

        Raises `Beyond` if it does not exist.
        """
        return member_at(self.points, place, part)

    def where(self, member: DesignPoint) -> str:
        """Position of an orbit on the branch, in words."""
        return f" at {self.name} = {float(member.orbit.given[self.name]):.6g}"
