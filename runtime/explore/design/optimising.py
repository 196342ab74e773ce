"""SciPy's constrained optimisers along a branch of orbits.

Where a trial lies beyond the branch the optimiser begins again at the best orbit that was
visited, in a smaller box around it; where it ends at a side of such a box, in a larger one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.condition import Condition
from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, DesignPoints
from nonsmooth.runtime.explore.design.largest import peak_rows, radius_rows
from nonsmooth.runtime.explore.design.quantities import (
    MULTIPLIER,
    PEAK,
    RADIUS,
    multiplier_gap,
)

__all__ = ["Aim", "Ended", "MarginKey", "Rows", "optimise"]

Method = Literal["SLSQP", "trust-constr"]
_ROUNDS = 60
_LEAST_BOX, _SIDE = 1e-8, 1e-9  # of the bounds
_NEAR = 1e-2  # of the bounds: how far an interior method stays off its limits at most
_INSIDE = 1e-10  # of a margin: an orbit at the limit is a motion despite of rounding
_PENALTY = 1e3  # of what misses a condition, beside the aim
_PRECISION = {
    "SLSQP": {"ftol": 1e-15},
    "trust-constr": {"gtol": 1e-10, "xtol": 1e-12, "barrier_tol": 1e-12},
}


class MarginKey(NamedTuple):
    """A boundary that stays away along a phase, counted from 0."""

    phase: int
    boundary: str


class Rows(NamedTuple):
    """Scaled numbers and their derivatives by the variables of the optimiser.

    Attributes
    ----------
    values : array (m,)
    slopes : array (m, n)
    """

    values: np.ndarray
    slopes: np.ndarray


@dataclass(frozen=True)
class Aim:
    """What is made as small as it can be, and the conditions.

    The variables are the places of the parameters in their bounds and, for a spectral radius
    that is minimised, the level that no multiplier exceeds (the epigraph form).

    Attributes
    ----------
    quantity : str
    sign : int
        -1 where it is maximised.
    conditions : tuple of Condition
    scale : float
        Unit of the quantity.
    lengths : array (q,)
        Of the parameters' intervals.
    margins : tuple of MarginKey
        Boundaries that must not be crossed, each in its phase.
    """

    quantity: str
    sign: int
    conditions: tuple[Condition, ...]
    scale: float
    lengths: np.ndarray
    margins: tuple[MarginKey, ...] = ()

    @property
    def levelled(self) -> bool:
        """Whether there is a level among the variables."""
        largest = self.quantity == RADIUS or self.quantity.startswith(PEAK)
        return largest and self.sign > 0

    def variables(self, point: DesignPoint) -> np.ndarray:
        """The variables at an orbit.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        array (n,)
        """
        if not self.levelled:
            return point.place
        return np.append(point.place, point.measured.values[self.quantity] / self.scale)

    def value(self, point: DesignPoint) -> float:
        """What is made small, at an orbit.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        float
        """
        return self.sign * point.measured.values[self.quantity] / self.scale

    def slope(self, point: DesignPoint) -> np.ndarray:
        """Derivatives of what is made small by the variables.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        array (n,)
        """
        if self.levelled:
            return np.eye(len(self.lengths) + 1)[-1]
        return self.sign * point.measured.slopes[self.quantity] * self.lengths / self.scale

    def level_rows(self, point: DesignPoint, level: float) -> Rows:
        """The conditions that the quantity does not exceed the level.

        Parameters
        ----------
        point : DesignPoint
        level : float
            In units of `scale`.

        Returns
        -------
        Rows
            Not negative where they hold.
        """
        derivatives = point.measured.derivatives
        if self.quantity == RADIUS:
            found = radius_rows(derivatives, level * self.scale)
        else:
            found = peak_rows(derivatives, self.quantity, level * self.scale)
        by_level = found.by_level[:, None] * self.scale
        slopes = np.hstack([found.by_parameters * self.lengths, by_level])
        size = self.scale ** (2 if len(found.values) == 3 else 1)
        return Rows(found.values / size, slopes / size)

    def condition_rows(self, point: DesignPoint, condition: Condition) -> Rows:
        """One condition.

        Parameters
        ----------
        point : DesignPoint
        condition : Condition

        Returns
        -------
        Rows
            Not negative where it holds, zero where it is an equation.
        """
        measured, wanted = point.measured, float(condition.value)
        if condition.quantity == MULTIPLIER:
            gap = multiplier_gap(measured.derivatives, wanted)
            values, slopes = np.array([gap.value]), gap.slope[None]
        elif condition.quantity == RADIUS and condition.relation == "<=":
            rows = radius_rows(measured.derivatives, wanted)
            values, slopes = rows.values, rows.by_parameters
        else:
            sign = -1.0 if condition.relation == "<=" else 1.0
            values = np.array([sign * (measured.values[condition.quantity] - wanted)])
            slopes = sign * measured.slopes[condition.quantity][None]
        size = max(1.0, abs(wanted))
        slopes = slopes * self.lengths / size
        if self.levelled:
            slopes = np.hstack([slopes, np.zeros((len(slopes), 1))])
        return Rows(values / size, slopes)

    def relaxing(self, point: DesignPoint, condition: Condition) -> np.ndarray:
        """By how much each row of a condition grows for each unit of its value.

        Parameters
        ----------
        point : DesignPoint
        condition : Condition

        Returns
        -------
        array (m,)
            Positive where the condition is relaxed; of an equation minus that.
        """
        derivatives, wanted = point.measured.derivatives, float(condition.value)
        if condition.quantity == MULTIPLIER:
            found = np.array([-multiplier_gap(derivatives, wanted).by_wanted])
        elif condition.quantity == RADIUS and condition.relation == "<=":
            found = radius_rows(derivatives, wanted).by_level
        else:
            found = np.ones(1)
        return found / max(1.0, abs(wanted))

    def margin_rows(self, point: DesignPoint) -> Rows:
        """How far each boundary stays away; far where it has no maximum inside its phase.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        Rows
        """
        there = {MarginKey(m.phase, m.boundary): m for m in point.measured.derivatives.margins}
        count = len(self.lengths)
        values, slopes = np.ones(len(self.margins)), np.zeros((len(self.margins), count))
        for place, key in enumerate(self.margins):
            if key in there:
                values[place] = float(there[key].value) - _INSIDE
                slopes[place] = np.asarray(there[key].rates, dtype=float) * self.lengths
        if self.levelled:
            slopes = np.hstack([slopes, np.zeros((len(slopes), 1))])
        return Rows(values, slopes)

    def rows(self, point: DesignPoint, level: float, *, equal: bool) -> Rows:
        """All conditions that are equations, or all others.

        Parameters
        ----------
        point : DesignPoint
        level : float
            Value of the level's variable, where there is one.
        equal : bool
            Whether equations are wanted.

        Returns
        -------
        Rows
        """
        found = [
            self.condition_rows(point, each)
            for each in self.conditions
            if (each.relation == "=") == equal
        ]
        if self.margins and not equal:
            found.append(self.margin_rows(point))
        if self.levelled and not equal:
            found.append(self.level_rows(point, level))
        if not found:
            return Rows(np.zeros(0), np.zeros((0, len(self.lengths) + self.levelled)))
        return Rows(np.concatenate([f.values for f in found]), np.vstack([f.slopes for f in found]))

    def missed(self, point: DesignPoint) -> float:
        """By how much an orbit misses the conditions, in their units.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        float
            The largest of all.
        """
        level = self.variables(point)[-1]
        equal = np.abs(self.rows(point, level, equal=True).values)
        short = [self.condition_rows(point, c).values for c in self.conditions if c.relation != "="]
        if self.margins:
            short.append(self.margin_rows(point).values)
        return float(max(np.concatenate([[0.0], equal, *(-each for each in short)])))


class Ended(NamedTuple):
    """Where an optimiser ended.

    Attributes
    ----------
    point : DesignPoint
    history : list of DesignPoint
        The iterates.
    reason : str
        Why the branch leads no further; empty where that was no matter.
    """

    point: DesignPoint
    history: list[DesignPoint]
    reason: str


def optimise(points: DesignPoints, aim: Aim, method: Method, most: int) -> Ended:
    """Make the aim as small as it can be.

    Parameters
    ----------
    points : DesignPoints
    aim : Aim
    method : "SLSQP" or "trust-constr"
        As SciPy calls them.
    most : int
        Iterations of the optimiser in each of its rounds.

    Returns
    -------
    Ended
    """

    def merit(point: DesignPoint) -> float:
        return aim.value(point) + _PENALTY * aim.missed(point)

    best, box, reason = points.visited[0], 1.0, ""
    history = [best]
    for _ in range(_ROUNDS):
        lower, upper = np.maximum(best.place - box, 0.0), np.minimum(best.place + box, 1.0)
        try:
            place = _run(points, aim, method, best, (lower, upper), most, history)
            found = points.at(place)
        except Beyond as ended:
            reason = ended.reason
            best = min(points.visited, key=merit)
            away = max(ended.distance, float(np.abs(ended.near.place - best.place).max()))
            box = min(box / 2, max(away, box / 16))
            if box < _LEAST_BOX:
                break
            continue
        sides = (place - lower < _SIDE) & (lower > 0) | (upper - place < _SIDE) & (upper < 1)
        gained = merit(best) - merit(found)
        best = found if gained >= 0 or not sides.any() else best
        if not sides.any():
            reason = ""
            break
        if gained <= 0:
            break
        box = min(1.0, 2 * box)
    if method == "trust-constr":
        best = _sharpened(points, aim, best, most, history, merit)
    best = _snapped(points, best)
    if history[-1] is not best:
        history.append(best)
    return Ended(best, history, reason)


def _snapped(points: DesignPoints, best: DesignPoint) -> DesignPoint:
    """The orbit at the bounds that it is next to."""
    place = np.where(best.place < _SIDE, 0.0, np.where(best.place > 1 - _SIDE, 1.0, best.place))
    try:
        return points.at(place)
    except Beyond:
        return best


def _sharpened(
    points: DesignPoints,
    aim: Aim,
    best: DesignPoint,
    most: int,
    history: list[DesignPoint],
    merit: Callable[[DesignPoint], float],
) -> DesignPoint:
    """The end of an interior method, which stays off the limits, taken to them by SLSQP."""
    box = np.maximum(best.place - _NEAR, 0.0), np.minimum(best.place + _NEAR, 1.0)
    try:
        found = points.at(_run(points, aim, "SLSQP", best, box, most, history))
    except Beyond:
        return best
    return min((best, found), key=merit)


def _run(
    points: DesignPoints,
    aim: Aim,
    method: Method,
    begin: DesignPoint,
    box: tuple[np.ndarray, np.ndarray],
    most: int,
    history: list[DesignPoint],
) -> np.ndarray:
    """One round of the optimiser in a box; gives the place where it ended."""
    import warnings

    from scipy.optimize import Bounds, minimize

    count = len(aim.lengths)
    lower, upper = box
    if aim.levelled:
        lower, upper = np.append(lower, 0.0), np.append(upper, np.inf)

    def at(x: np.ndarray) -> DesignPoint:
        return points.at(np.clip(x[:count], box[0], box[1]))

    def note(x: np.ndarray, *_: Any) -> None:
        point = at(x)
        if history[-1] is not point:
            history.append(point)

    def fun(x: np.ndarray) -> float:
        return float(x[-1]) if aim.levelled else aim.value(at(x))

    def rows(x: np.ndarray, equal: bool) -> Rows:
        return aim.rows(at(x), x[-1], equal=equal)

    parts = [equal for equal in (True, False) if len(aim.rows(begin, 1.0, equal=equal).values)]
    make = _old_constraint if method == "SLSQP" else _new_constraint
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "delta_grad == 0.0")  # of what is linear
        found = minimize(
            fun,
            aim.variables(begin),
            jac=lambda x: aim.slope(at(x)),
            method=method,
            bounds=Bounds(lower, upper, keep_feasible=True),  # type: ignore[arg-type]
            constraints=[make(partial(rows, equal=equal), equal) for equal in parts],
            callback=note,
            options={"maxiter": most, **_PRECISION[method]},
        )
    return np.asarray(np.clip(found.x[:count], box[0], box[1]))


def _old_constraint(rows: Callable[[np.ndarray], Rows], equal: bool) -> Any:
    return {
        "type": "eq" if equal else "ineq",
        "fun": lambda x: rows(x).values,
        "jac": lambda x: rows(x).slopes,
    }


def _new_constraint(rows: Callable[[np.ndarray], Rows], equal: bool) -> Any:
    from scipy.optimize import BFGS, NonlinearConstraint

    return NonlinearConstraint(
        lambda x: rows(x).values,
        0.0,
        0.0 if equal else np.inf,
        jac=lambda x: rows(x).slopes,
        hess=BFGS(),
    )
