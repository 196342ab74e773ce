"""SciPy's constrained optimiser SLSQP along a branch of orbits.

Where a trial lies beyond the branch the optimiser begins again at the best orbit that was
visited, in a smaller box around it; where it ends at a side of such a box, in a larger one. It
also begins again where it ends, or at a better orbit that it has tried, until nothing is gained:
where multipliers meet, what it has learned of the curvature can stop it early.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.explore.design.design_points import Beyond
from nonsmooth.runtime.explore.design.objective import Aim, Rows, Trial

__all__ = ["INTERRUPTED", "Ended", "Trials", "optimise"]

INTERRUPTED = "interrupted"
_ROUNDS = 60
_LEAST_BOX, _SIDE = 1e-8, 1e-9  # of the bounds
_SETTLED = 1e-9  # of the aim: what is gained by beginning again at an optimum
_MISSED = 1e-6  # of a condition: then it is approached first
_PENALTY = 1e3  # of what misses a condition, beside the aim
_PRECISION = 1e-15  # of the aim


class Trials(Protocol):
    """Supplier of the trials of an optimiser: `DesignPoints` or `BranchPoints`."""

    @property
    def visited(self) -> Sequence[Trial]:
        """All trials in their order, the first being where the optimiser begins."""

    def at(self, place: np.ndarray) -> Trial:
        """The trial at a place (q,)."""


class Ended(NamedTuple):
    """The trial at which an optimiser ended."""

    point: Trial
    reason: str  # why the branch leads no further, empty where that did not matter


def optimise(points: Trials, aim: Aim, most: int, history: list[Trial]) -> Ended:
    """The trial that minimises the aim.

    `most` limits the iterations in each round of the optimiser; the iterates are appended to
    `history`. Ctrl-C ends it at the best trial until then, with the reason INTERRUPTED.
    """
    try:
        return _optimised(points, aim, most, history)
    except KeyboardInterrupt:
        best = min(points.visited, key=lambda point: _merit(aim, point))
        return Ended(best, INTERRUPTED)


def _merit(aim: Aim, point: Trial) -> float:
    return aim.value(point) + _PENALTY * aim.missed(point)


def _optimised(points: Trials, aim: Aim, most: int, history: list[Trial]) -> Ended:
    def merit(point: Trial) -> float:
        return _merit(aim, point)

    best, box, reason = points.visited[0], 1.0, ""
    history.append(best)
    for _ in range(_ROUNDS):
        lower, upper = np.maximum(best.place - box, 0.0), np.minimum(best.place + box, 1.0)
        try:
            place = _run(points, aim, best, (lower, upper), most, history)
            found = points.at(place)
        except Beyond as ended:
            reason = ended.reason
            best = min(points.visited, key=merit)
            away = max(ended.distance, float(np.abs(ended.near - best.place).max()))
            box = min(box / 2, max(away, box / 16))
            if box < _LEAST_BOX:
                break
            continue
        sides = (place - lower < _SIDE) & (lower > 0) | (upper - place < _SIDE) & (upper < 1)
        gained = merit(best) - merit(found)
        best = found if gained >= 0 else best
        if sides.any():
            if gained <= 0:
                break
            box = min(1.0, 2 * box)
            continue
        reason = ""
        if gained <= _SETTLED:
            tried = min(points.visited, key=merit)
            if merit(best) - merit(tried) <= _SETTLED:
                break
            best = tried
    best = _snapped(points, best)
    if history[-1] is not best:
        history.append(best)
    return Ended(best, reason)


def _snapped(points: Trials, best: Trial) -> Trial:
    """The orbit on the bounds that a trial almost touches, or the trial itself."""
    place = np.where(best.place < _SIDE, 0.0, np.where(best.place > 1 - _SIDE, 1.0, best.place))
    try:
        return points.at(place)
    except Beyond:
        return best


def _run(
    points: Trials,
    aim: Aim,
    begin: Trial,
    box: tuple[np.ndarray, np.ndarray],
    most: int,
    history: list[Trial],
) -> np.ndarray:
    """The place where one round of the optimiser in a box ends."""
    from scipy.optimize import Bounds, minimize

    count = len(aim.lengths)
    lower, upper = box
    if aim.levelled:
        lower, upper = np.append(lower, aim.least_level), np.append(upper, np.inf)

    def at(x: np.ndarray) -> Trial:
        return points.at(np.clip(x[:count], box[0], box[1]))

    def note(x: np.ndarray, *_: Any) -> None:
        point = at(x)
        if history[-1] is not point:
            history.append(point)

    def fun(x: np.ndarray) -> float:
        return float(x[-1]) if aim.levelled else aim.value(at(x))

    def rows(x: np.ndarray, equal: bool) -> Rows:
        return aim.rows(at(x), x[-1], equal=equal)

    first = aim.variables(begin)
    if aim.missed(begin) > _MISSED:
        first = aim.variables(points.at(_nearer(points, aim, begin, box, most)))
    parts = [equal for equal in (True, False) if len(aim.rows(begin, 1.0, equal=equal).values)]
    found = minimize(
        fun,
        first,
        jac=lambda x: aim.slope(at(x)),
        method="SLSQP",
        bounds=Bounds(lower, upper, keep_feasible=True),
        constraints=[_constraint(partial(rows, equal=equal), equal) for equal in parts],
        callback=note,
        options={"maxiter": most, "ftol": _PRECISION},
    )
    return np.asarray(np.clip(found.x[:count], box[0], box[1]))


def _nearer(
    points: Trials,
    aim: Aim,
    begin: Trial,
    box: tuple[np.ndarray, np.ndarray],
    most: int,
) -> np.ndarray:
    """A place in a box at which the largest violation of all conditions is as small as possible.

    Where conditions are violated their linear forms may contradict each other; with one slack
    variable for all of them they do not.
    """
    from scipy.optimize import Bounds, minimize

    count = len(aim.lengths)

    def rows(x: np.ndarray) -> Rows:
        point = points.at(np.clip(x[:count], *box))
        level = aim.variables(point)[-1]
        equal, others = (aim.rows(point, level, equal=each) for each in (True, False))
        values = np.concatenate([equal.values, -equal.values, others.values])
        slopes = np.vstack([equal.slopes, -equal.slopes, others.slopes])[:, :count]
        return Rows(values + x[-1], np.hstack([slopes, np.ones((len(slopes), 1))]))

    slack = np.eye(count + 1)[-1]
    found = minimize(
        lambda x: float(x[-1]),
        np.append(begin.place, aim.missed(begin)),
        jac=lambda _: slack,
        method="SLSQP",
        bounds=Bounds(np.append(box[0], 0.0), np.append(box[1], np.inf)),
        constraints=[_constraint(rows, equal=False)],
        options={"maxiter": most, "ftol": _PRECISION},
    )
    return np.asarray(np.clip(found.x[:count], *box))


def _constraint(rows: Callable[[np.ndarray], Rows], equal: bool) -> Any:
    return {
        "type": "eq" if equal else "ineq",
        "fun": lambda x: rows(x).values,
        "jac": lambda x: rows(x).slopes,
    }
