"""As many parameters as conditions, by SciPy's least squares on exact Jacobians."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.objective import Aim, Trial
from nonsmooth.runtime.explore.design.optimising import INTERRUPTED, Ended

__all__ = ["solve_conditions"]

_ROUNDS, _LEAST_BOX, _SIDE = 60, 1e-9, 1e-9
_LAST, _TINY = 5, 1e-15  # Newton's steps behind the least squares
_PRECISION = 1e-15


def solve_conditions(points: DesignPoints, aim: Aim, most: int, history: list[Trial]) -> Ended:
    """The parameters at which all conditions hold, or miss them by the least squares.

    The conditions are equations, as many as parameters. `most` limits the evaluations in each
    round; the iterates are appended to `history`. Ctrl-C ends it at the best trial until then,
    with the reason INTERRUPTED.
    """

    def cost(point: DesignPoint) -> float:
        return float(np.linalg.norm(aim.rows(point, 0.0, equal=True).values))

    try:
        return _solved(points, aim, most, history, cost)
    except KeyboardInterrupt:
        return Ended(min(points.visited, key=cost), INTERRUPTED)


def _solved(
    points: DesignPoints,
    aim: Aim,
    most: int,
    history: list[Trial],
    cost: Callable[[DesignPoint], float],
) -> Ended:
    best, box, reason = points.visited[0], 1.0, ""
    history.append(best)
    for _ in range(_ROUNDS):
        lower, upper = np.maximum(best.place - box, 0.0), np.minimum(best.place + box, 1.0)
        try:
            found = _run(points, aim, best, (lower, upper), most)
        except Beyond as ended:
            reason = ended.reason
            best = min(points.visited, key=cost)
            history.append(best)
            box = min(box / 2, max(ended.distance, box / 16))
            if box < _LEAST_BOX:
                break
            continue
        place = found.place
        sides = (place - lower < _SIDE) & (lower > 0) | (upper - place < _SIDE) & (upper < 1)
        gained = cost(best) - cost(found)
        best = found if gained >= 0 else best
        history.append(best)
        if not sides.any():
            reason = ""
            break
        if gained <= 0:
            break
        box = min(1.0, 2 * box)
    best = _sharpened(points, aim, best)
    history.append(best)
    return Ended(best, reason)


def _run(
    points: DesignPoints,
    aim: Aim,
    begin: DesignPoint,
    box: tuple[np.ndarray, np.ndarray],
    most: int,
) -> DesignPoint:
    from scipy.optimize import least_squares

    lower, upper = box
    inside = np.clip(begin.place, lower + 1e-3 * (upper - lower), upper - 1e-3 * (upper - lower))
    found = least_squares(
        lambda x: aim.rows(points.at(x), 0.0, equal=True).values,
        inside,
        jac=lambda x: aim.rows(points.at(x), 0.0, equal=True).slopes,
        bounds=(lower, upper),
        xtol=_PRECISION,
        ftol=_PRECISION,
        gtol=_PRECISION,
        max_nfev=most,
    )
    return points.at(np.asarray(found.x))


def _sharpened(points: DesignPoints, aim: Aim, begin: DesignPoint) -> DesignPoint:
    """The orbit after a few of Newton's steps, as long as these reduce the residual."""
    best, (values, slopes) = begin, aim.rows(begin, 0.0, equal=True)
    for _ in range(_LAST):
        step = np.linalg.lstsq(slopes, -values, rcond=None)[0]
        if np.abs(step).max() <= _TINY:
            break
        try:
            found = points.at(np.clip(best.place + step, 0.0, 1.0))
        except Beyond:
            break
        then = aim.rows(found, 0.0, equal=True)
        if not np.linalg.norm(then.values) < np.linalg.norm(values):
            break
        best, (values, slopes) = found, then
    return best
