"""SciPy's constrained optimiser SLSQP along a branch of orbits, or its least squares.

Where a trial lies beyond the branch the search begins again at the best orbit that was
visited, in a smaller box around it; where it ends at a side of such a box, in a larger one. The
optimiser also begins again where it ends, or at a better orbit that it has tried, until nothing
is gained: where multipliers meet, what it has learned of the curvature can stop it early.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.explore.design.design_points import Beyond
from nonsmooth.runtime.explore.design.objective import Aim, Rows, Trial

__all__ = ["INTERRUPTED", "Ended", "Trials", "optimise"]

INTERRUPTED = "interrupted"
_ROUNDS = 60
_LEAST_BOX, _SIDE = 1e-9, 1e-9  # of the bounds
_SETTLED = 1e-9  # of the aim: what is gained by beginning again at an optimum
_MISSED = 1e-6  # of a condition: then it is approached first
_PENALTY = 1e3  # of what misses a condition, beside the aim
_PRECISION = 1e-15  # of the aim
_LAST, _TINY = 5, 1e-15  # Newton's steps behind the least squares


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


Box = tuple[np.ndarray, np.ndarray]  # lower and upper ends (q,) of places


def optimise(points: Trials, aim: Aim, most: int, history: list[Trial]) -> Ended:
    """The trial that minimises the aim, or where all conditions hold if they are all it asks.

    Conditions are then equations, as many as parameters, and missed by the least squares if
    they cannot hold. `most` limits the iterations in each round; the iterates are appended to
    `history`. Ctrl-C ends it at the best trial until then, with the reason INTERRUPTED.
    """

    def merit(point: Trial) -> float:
        if aim.quantity:
            return aim.value(point) + _PENALTY * aim.missed(point)
        return float(np.linalg.norm(aim.rows(point, 0.0, equal=True).values))

    try:
        return _searched(points, aim, most, history, merit)
    except KeyboardInterrupt:
        return Ended(min(points.visited, key=merit), INTERRUPTED)


def _searched(
    points: Trials, aim: Aim, most: int, history: list[Trial], merit: Callable[[Trial], float]
) -> Ended:
    best, box, reason = points.visited[0], 1.0, ""
    run, finish = (_minimised, _snapped) if aim.quantity else (_solved, _sharpened)
    history.append(best)
    for _ in range(_ROUNDS):
        lower, upper = np.maximum(best.place - box, 0.0), np.minimum(best.place + box, 1.0)
        try:
            found = run(points, aim, best, (lower, upper), most, history)
        except Beyond as ended:
            reason = ended.reason
            best = min(points.visited, key=merit)
            away = max(ended.distance, float(np.abs(ended.near - best.place).max()))
            box = min(box / 2, max(away, box / 16))
            if box < _LEAST_BOX:
                break
            continue
        place = found.place
        sides = (place - lower < _SIDE) & (lower > 0) | (upper - place < _SIDE) & (upper < 1)
        gained = merit(best) - merit(found)
        best = found if gained >= 0 else best
        if sides.any():
            if gained <= 0:
                break
            box = min(1.0, 2 * box)
            continue
        reason = ""
        if not aim.quantity:
            break
        if gained <= _SETTLED:
            tried = min(points.visited, key=merit)
            if merit(best) - merit(tried) <= _SETTLED:
                break
            best = tried
    best = finish(points, aim, best)
    if history[-1] is not best:
        history.append(best)
    return Ended(best, reason)


def _solved(
    points: Trials, aim: Aim, begin: Trial, box: Box, most: int, history: list[Trial]
) -> Trial:
    """The trial where one round of least squares in a box ends."""
    from scipy.optimize import least_squares

    lower, upper = box
    margin = 1e-3 * (upper - lower)
    found = least_squares(
        lambda x: aim.rows(points.at(x), 0.0, equal=True).values,
        np.clip(begin.place, lower + margin, upper - margin),
        jac=lambda x: aim.rows(points.at(x), 0.0, equal=True).slopes,
        bounds=box,
        xtol=_PRECISION,
        ftol=_PRECISION,
        gtol=_PRECISION,
        max_nfev=most,
    )
    history.append(points.at(np.asarray(found.x)))
    return history[-1]


def _sharpened(points: Trials, aim: Aim, begin: Trial) -> Trial:
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


def _snapped(points: Trials, aim: Aim, best: Trial) -> Trial:
    """The orbit on the bounds that a trial almost touches, or the trial itself."""
    place = np.where(best.place < _SIDE, 0.0, np.where(best.place > 1 - _SIDE, 1.0, best.place))
    try:
        return points.at(place)
    except Beyond:
        return best


def _minimised(
    points: Trials, aim: Aim, begin: Trial, box: Box, most: int, history: list[Trial]
) -> Trial:
    """The trial where one round of the optimiser in a box ends."""
    count = len(aim.lengths)
    lower, upper = box
    if aim.levelled:
        lower, upper = np.append(lower, aim.least_level), np.append(upper, np.inf)

    def at(x: np.ndarray) -> Trial:
        return points.at(np.clip(x[:count], *box))

    def note(x: np.ndarray, *_: Any) -> None:
        point = at(x)
        if history[-1] is not point:
            history.append(point)

    def fun(x: np.ndarray) -> float:
        return float(x[-1]) if aim.levelled else aim.value(at(x))

    def rows(x: np.ndarray, equal: bool) -> Rows:
        return aim.rows(at(x), x[-1], equal=equal)

    constraints = {
        kind: partial(rows, equal=equal)
        for kind, equal in (("eq", True), ("ineq", False))
        if len(aim.rows(begin, 1.0, equal=equal).values)
    }
    if aim.missed(begin) > _MISSED:
        begin = _nearer(points, aim, begin, box, most)
    return at(
        _slsqp(
            fun,
            lambda x: aim.slope(at(x)),
            aim.variables(begin),
            (lower, upper),
            constraints,
            most,
            note,
        )
    )


def _nearer(points: Trials, aim: Aim, begin: Trial, box: Box, most: int) -> Trial:
    """The trial in a box at which the largest violation of all conditions is the smallest.

    Where conditions are violated their linear forms may contradict each other; with one slack
    variable for all of them they do not.
    """
    count = len(aim.lengths)

    def rows(x: np.ndarray) -> Rows:
        point = points.at(np.clip(x[:count], *box))
        level = aim.variables(point)[-1]
        equal, others = (aim.rows(point, level, equal=each) for each in (True, False))
        values = np.concatenate([equal.values, -equal.values, others.values])
        slopes = np.vstack([equal.slopes, -equal.slopes, others.slopes])[:, :count]
        return Rows(values + x[-1], np.hstack([slopes, np.ones((len(slopes), 1))]))

    slack = np.eye(count + 1)[-1]
    first = np.append(begin.place, aim.missed(begin))
    wide = np.append(box[0], 0.0), np.append(box[1], np.inf)
    found = _slsqp(lambda x: float(x[-1]), lambda _: slack, first, wide, {"ineq": rows}, most)
    return points.at(np.clip(found[:count], *box))


def _slsqp(
    fun: Callable[[np.ndarray], float],
    slope: Callable[[np.ndarray], np.ndarray],
    first: np.ndarray,
    box: Box,
    constraints: Mapping[str, Callable[[np.ndarray], Rows]],
    most: int,
    note: Callable[..., None] | None = None,
) -> np.ndarray:
    """The variables (n,) that minimise a function under constraints, by their kinds."""
    from scipy.optimize import Bounds, minimize

    found = minimize(
        fun,
        first,
        jac=slope,
        method="SLSQP",
        bounds=Bounds(*box, keep_feasible=True),
        constraints=[
            {
                "type": kind,
                "fun": lambda x, rows=rows: rows(x).values,
                "jac": lambda x, rows=rows: rows(x).slopes,
            }
            for kind, rows in constraints.items()
        ],
        callback=note,
        options={"maxiter": most, "ftol": _PRECISION},
    )
    return np.asarray(found.x)
