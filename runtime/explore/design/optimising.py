"""What a design makes as small as it can be under conditions, and SciPy's optimisers that do it.

All is in the variables of an optimiser: SLSQP along a branch of orbits, or least squares. Where a
trial lies beyond the branch the search begins again at the best orbit that was visited, in a
smaller box around it; where it ends at a side of such a box, in a larger one. The optimiser also
begins again where it ends, or at a better orbit that it has tried, until nothing is gained: where
multipliers meet, what it has learned of the curvature can stop it early.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoint, Trial
from nonsmooth.runtime.explore.design.optimum import ActiveLimit, DesignCondition
from nonsmooth.runtime.explore.design.quantities import (
    MULTIPLIER,
    RADIUS,
    ExtremeKey,
    LevelRows,
    QuantityValues,
    corner_of,
    extreme_rows,
    is_largest_of_several,
    multiplier_rows,
    radius_rows,
    unit_of,
)

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.design.worst_over import Trials

_INSIDE = 1e-10  # of a margin's unit: an orbit at the limit is a motion despite of rounding
_ACTIVE, _ACTIVE_BOUND = 1e-6, 1e-7
INTERRUPTED = "interrupted"
_ROUNDS = 60
_LEAST_BOX, _SIDE = 1e-9, 1e-9  # of the bounds
_SETTLED = 1e-9  # of the aim: what is gained by beginning again at an optimum
_MISSED = 1e-6  # of a condition: then it is approached first
_PENALTY = 1e3  # of what misses a condition, beside the aim
_PRECISION = 1e-15  # of the aim
_LAST, _TINY = 5, 1e-15  # Newton's steps behind the least squares


class MarginKey(NamedTuple):
    """A boundary that must not be crossed during a phase, which is counted from 0."""

    phase: int
    boundary: str


def watched_margins(measured: QuantityValues, lengths: np.ndarray) -> dict[MarginKey, float]:
    """Units of the functions of the boundaries that an orbit does not reach, by their keys.

    `lengths` (q,) are those of the parameters' intervals.
    """
    found = {}
    for margin in measured.derivatives.margins:
        changes = np.asarray(margin.rates[: len(lengths)], dtype=float) * lengths
        found[MarginKey(margin.phase, margin.boundary)] = unit_of(float(margin.value), changes)
    return found


class Rows(NamedTuple):
    """Scaled functions (m,) and their derivatives (m, n) by the variables of the optimiser."""

    values: np.ndarray
    slopes: np.ndarray


class Limit(NamedTuple):
    """A condition at one orbit: functions (m,) that are not negative, of an equation zero."""

    text: str
    member: DesignPoint
    values: np.ndarray  # (m,)
    slopes: np.ndarray  # derivatives (m, n) by the variables of the optimiser
    # (m,), growth per unit by which the limit is relaxed; of an equation minus that of its value
    relaxed: np.ndarray
    equation: bool = False

    @property
    def missed(self) -> float:
        """Largest violation."""
        short = np.abs(self.values) if self.equation else -self.values
        return float(short.max(initial=0.0))


@dataclass(frozen=True)
class Aim:
    """The objective that is minimised, and the conditions.

    The variables are the places of the parameters in their bounds. If the objective is the
    largest of several numbers, such as a spectral radius that is minimised, the level that none
    of them exceeds is a further variable (the epigraph form). All conditions hold for all
    orbits of a trial.
    """

    quantity: str
    sign: int  # -1 where the quantity is maximised, else 1
    conditions: tuple[DesignCondition, ...]
    scale: float  # unit of the quantity
    lengths: np.ndarray  # (q,), of the parameters' intervals
    # of all quantities in the conditions that are not pure numbers
    units: Mapping[str, float]
    # boundaries that must not be crossed in a phase, with the units of their functions
    margins: Mapping[MarginKey, float]
    # local extremes of a peak, each of which has to be below the level
    extremes: tuple[ExtremeKey, ...]
    spread: bool = False  # whether the worst along a branch is minimised

    @property
    def levelled(self) -> bool:
        """Whether the level is one of the variables."""
        several = is_largest_of_several(self.quantity, self.sign)
        return bool(self.quantity) and (self.spread or several)

    def variables(self, point: Trial) -> np.ndarray:
        """The variables (n,) at a trial."""
        return np.append(point.place, self.value(point)) if self.levelled else point.place

    def worst(self, point: Trial) -> DesignPoint:
        """The orbit of a trial at which the quantity is worst."""
        return max(point.members, key=self._value)

    def value(self, point: Trial) -> float:
        """Value of the objective at a trial, in units of `scale`."""
        return self._value(self.worst(point))

    def _value(self, member: DesignPoint) -> float:
        return self.sign * member.quantities.values[self.quantity] / self.scale

    def slope(self, point: Trial) -> np.ndarray:
        """Derivatives (n,) of the objective by the variables."""
        if self.levelled:
            return np.asarray(np.eye(len(self.lengths) + 1)[-1])
        slope = self.worst(point).quantities.slopes[self.quantity]
        return np.asarray(self.sign * self._by_variables(slope[None])[0] / self.scale)

    def _by_variables(self, slopes: np.ndarray) -> np.ndarray:
        """Derivatives (m, n) by the variables from those (m, q) by parameters; 0 by the level."""
        found = slopes[:, : len(self.lengths)] * self.lengths
        return np.hstack([found, np.zeros((len(found), 1))]) if self.levelled else found

    def level_rows(self, member: DesignPoint, level: float) -> Rows:
        """The conditions that the quantity of an orbit does not exceed the level.

        The level is in units of `scale`. The rows are not negative where the conditions hold.
        """
        measured, wanted = member.quantities, level * self.scale
        if self.extremes:
            found = extreme_rows(
                measured.derivatives, self.quantity, self.extremes, wanted, self.scale
            )
        else:
            relation = "<=" if self.sign > 0 else ">="
            found = self._limit(member, self.quantity, relation, self.sign * wanted)
            found = found._replace(by_level=self.sign * found.by_level)
        slopes = self._by_variables(found.by_parameters)
        slopes[:, -1] = found.by_level * self.scale
        sizes = self.scale**found.powers
        return Rows(found.values / sizes, slopes / sizes[:, None])

    def _limit(self, member: DesignPoint, quantity: str, relation: str, wanted: float) -> LevelRows:
        """The rows of a condition on a quantity: at most, at least or just a wanted value."""
        if quantity == MULTIPLIER:
            return multiplier_rows(member.quantities.derivatives, wanted)
        if quantity == RADIUS and relation == "<=":
            return radius_rows(member.quantities.derivatives, wanted)
        value, slope = self.distance(member, quantity, relation, wanted)
        by_level = np.array([1.0 if relation == "<=" else -1.0])
        return LevelRows(np.array([value]), slope[None], by_level, np.ones(1))

    def size(self, condition: DesignCondition) -> float:
        """Unit in which the violation of a condition is measured."""
        return max(self.units.get(condition.quantity, 1.0), abs(float(condition.value)))

    def distance(
        self, member: DesignPoint, quantity: str, relation: str, wanted: float
    ) -> tuple[float, np.ndarray]:
        """How far a quantity is inside of a condition, and the derivatives by all parameters."""
        measured, sign = member.quantities, -1.0 if relation == "<=" else 1.0
        return sign * (measured.values[quantity] - wanted), sign * measured.slopes[quantity]

    def distances(self, member: DesignPoint) -> tuple[np.ndarray, np.ndarray]:
        """Scaled distances (m,) from the boundaries, and their derivatives by all parameters.

        A distance is 1 where there is no maximum inside the phase.
        """
        derivatives = member.quantities.derivatives
        known = derivatives.margins if self.margins else ()
        there = {MarginKey(m.phase, m.boundary): m for m in known}
        values = np.ones(len(self.margins))
        slopes = np.zeros((len(self.margins), len(derivatives.by)))
        for place, (key, unit) in enumerate(self.margins.items()):
            if key in there:
                values[place] = float(there[key].value) / unit
                slopes[place] = np.asarray(there[key].rates, dtype=float) / unit
        return values, slopes

    def limits(self, point: Trial, *, equal: bool | None = None) -> Iterator[Limit]:
        """All conditions at the orbits of a trial, those that no boundary is crossed among them.

        With `equal` the equations alone, or all but these.
        """
        asked = [each for each in self.conditions if equal in (None, each.relation == "=")]
        for member in point.members:
            for each in asked:
                found, size = self._limit(member, *each.asked), self.size(each)
                slopes = self._by_variables(found.by_parameters / size)
                relaxed = found.by_level / size * (1.0 if each.relation == "<=" else -1.0)
                equation = each.relation == "="
                yield Limit(each.text, member, found.values / size, slopes, relaxed, equation)
            if equal:
                continue
            values, slopes = self.distances(member)
            inside, slopes = (values - _INSIDE)[:, None], self._by_variables(slopes)[:, None]
            for place, (key, unit) in enumerate(self.margins.items()):
                text = f"{key.boundary} stays away in phase {key.phase + 1}"
                yield Limit(text, member, inside[place], slopes[place], np.array([1 / unit]))

    def rows(self, point: Trial, level: float, *, equal: bool) -> Rows:
        """The rows of all equations (`equal`), or of all other conditions, of a trial.

        Among the others is that nothing exceeds the level.
        """
        found: list[Limit | Rows] = [*self.limits(point, equal=equal)]
        if self.levelled and not equal:
            found += [self.level_rows(member, level) for member in point.members]
        none = np.zeros((0, len(self.lengths) + self.levelled))
        return Rows(
            np.concatenate([none[:, 0], *(each.values for each in found)]),
            np.vstack([none, *(each.slopes for each in found)]),
        )

    def missed(self, point: Trial) -> float:
        """Largest violation of all conditions at a trial, in their units."""
        return max((each.missed for each in self.limits(point)), default=0.0)


class Optimality(NamedTuple):
    """The conditions of Karush, Kuhn and Tucker at an orbit."""

    active: tuple[ActiveLimit, ...]
    residual: float  # remainder of the gradient, in units of the quantity and of the bounds
    corner: str  # what happens where the quantity has no derivative, else empty
    worst_at: tuple[DesignPoint, ...] = ()  # orbits of a branch at which the quantity is worst


def optimality(
    aim: Aim,
    point: Trial,
    names: tuple[str, ...],
    bounds: np.ndarray,
    where: Callable[[DesignPoint], str],
) -> Optimality:
    """The multipliers that leave as little as possible of the gradient at a trial.

    Where nothing is optimised they are zero, and conditions that are missed are what is left.

    They solve a linear least-squares problem with bounds, whatever optimiser was used. `bounds`
    (q, 2) are those of the parameters `names`; `where` puts an orbit's place on a branch into
    words.
    """
    from scipy.optimize import lsq_linear

    if not aim.quantity:
        met = [ActiveLimit(text=text, multiplier=0.0) for *_, text in _sides(point, names, bounds)]
        return Optimality(tuple(met), aim.missed(point), "")
    level, corner = aim.variables(point)[-1], ""
    # conditions and bounds that hold with equality, each with its growth per unit of its limit
    acting = [
        (each.text + where(each.member), slope, unit, each.equation)
        for each in aim.limits(point)
        for value, slope, unit in zip(each.values, each.slopes, each.relaxed.tolist(), strict=True)
        if each.equation or abs(value) <= _ACTIVE
    ]
    units = np.eye(len(names) + aim.levelled)
    acting += [
        (text, sign * units[place], 1 / float(aim.lengths[place]), False)
        for place, sign, text in _sides(point, names, bounds)
    ]
    slopes = [slope for _, slope, *_ in acting]
    worst_at: list[DesignPoint] = []
    for member in point.members if aim.levelled else ():
        levels = aim.level_rows(member, level)
        near = np.abs(levels.values) <= _ACTIVE
        if not near.any():
            continue
        worst_at.append(member)
        corner = corner or corner_of(
            member.quantities.derivatives,
            aim.quantity,
            near,
            levels.slopes,
            aim.scale / aim.lengths,
        )
        slopes.extend(levels.slopes[near])
    if len(worst_at) > 1:
        corner = "; ".join(
            [f"as bad at {len(worst_at)} places of the branch", *filter(None, [corner])]
        )
    gradient = aim.slope(point)
    if not slopes:
        return Optimality((), float(np.abs(gradient).max()), corner, tuple(worst_at))
    lower = np.zeros(len(slopes))
    lower[: len(acting)][[equation for *_, equation in acting]] = -np.inf
    found = lsq_linear(np.array(slopes).T, gradient, (lower, np.full(len(slopes), np.inf)))
    left = float(np.abs(found.fun).max())
    factors: dict[str, float] = {}  # a conjugate pair meets one condition twice
    for (text, _, unit, _), factor in zip(acting, found.x.tolist(), strict=False):
        factors[text] = factors.get(text, 0.0) + factor * aim.scale * unit
    limits = tuple(ActiveLimit(text=text, multiplier=each) for text, each in factors.items())
    return Optimality(limits, left, corner, tuple(worst_at))


def _sides(
    point: Trial, names: Sequence[str], bounds: np.ndarray
) -> Iterator[tuple[int, float, str]]:
    """Parameters at a bound, with the direction inwards and the bound in words."""
    for place, name in enumerate(names):
        for side, (sign, relation) in enumerate(((1.0, ">="), (-1.0, "<="))):
            if abs(point.place[place] - side) <= _ACTIVE_BOUND:
                yield place, sign, f"{name}{relation}{float(bounds[place, side])!r}"


class Ended(NamedTuple):
    """The trial at which an optimiser ended."""

    point: Trial
    reason: str  # why the branch leads no further, empty where that did not matter


Box = tuple[np.ndarray, np.ndarray]  # lower and upper ends (q,) of places


def optimise(trials: Trials) -> Ended:
    """The trial that minimises the aim, or where all conditions hold if they are all it asks.

    Conditions are then equations, as many as parameters, and missed by the least squares if
    they cannot hold. Ctrl-C ends it at the best trial until then, with the reason INTERRUPTED.
    """
    aim = trials.aim

    @cache
    def merit(point: Trial) -> float:
        if aim.quantity:
            return aim.value(point) + _PENALTY * aim.missed(point)
        return float(np.linalg.norm(aim.rows(point, 0.0, equal=True).values))

    try:
        return _searched(trials, merit)
    except KeyboardInterrupt:
        if not aim.spread:  # the orbit that progress was told last may be in no trial yet
            trials.at(trials.points.visited[-1].place)
        return Ended(min(trials.visited, key=merit), INTERRUPTED)


def _searched(trials: Trials, merit: Callable[[Trial], float]) -> Ended:
    best, box, reason, history = trials.visited[0], 1.0, "", trials.history
    wanted = not trials.aim.quantity
    run, finish = (_solved, _sharpened) if wanted else (_minimised, _snapped)
    history.append(best)
    for _ in range(_ROUNDS):
        lower, upper = np.maximum(best.place - box, 0.0), np.minimum(best.place + box, 1.0)
        try:
            found = run(trials, best, (lower, upper))
        except Beyond as ended:
            reason = ended.reason
            best = min(trials.visited, key=merit)
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
        if wanted:
            break
        if gained <= _SETTLED:
            tried = min(trials.visited, key=merit)
            if merit(best) - merit(tried) <= _SETTLED:
                break
            best = tried
    best = finish(trials, best)
    if history[-1] is not best:
        history.append(best)
    return Ended(best, reason)


def _solved(trials: Trials, begin: Trial, box: Box) -> Trial:
    """The trial where one round of least squares in a box ends."""
    from scipy.optimize import least_squares

    lower, upper = box
    margin = 1e-3 * (upper - lower)

    def rows(x: np.ndarray) -> Rows:
        return trials.aim.rows(trials.at(x), 0.0, equal=True)

    found = least_squares(
        lambda x: rows(x).values,
        np.clip(begin.place, lower + margin, upper - margin),
        jac=lambda x: rows(x).slopes,
        bounds=box,
        xtol=_PRECISION,
        ftol=_PRECISION,
        gtol=_PRECISION,
        max_nfev=trials.most,
    )
    trials.history.append(trials.at(np.asarray(found.x)))
    return trials.history[-1]


def _sharpened(trials: Trials, begin: Trial) -> Trial:
    """The orbit after a few of Newton's steps, up to the bounds, while these reduce the residual.

    Least squares stay inside of the bounds.
    """
    best, (values, slopes) = begin, trials.aim.rows(begin, 0.0, equal=True)
    for _ in range(_LAST):
        step = np.linalg.lstsq(slopes, -values, rcond=None)[0]
        if np.abs(step).max() <= _TINY:
            break
        try:
            found = trials.at(np.clip(best.place + step, 0.0, 1.0))
        except Beyond:
            break
        then = trials.aim.rows(found, 0.0, equal=True)
        if not np.linalg.norm(then.values) < np.linalg.norm(values):
            break
        best, (values, slopes) = found, then
    return best


def _snapped(trials: Trials, best: Trial) -> Trial:
    """The orbit on the bounds that a trial almost touches, or the trial itself."""
    place = np.where(best.place < _SIDE, 0.0, np.where(best.place > 1 - _SIDE, 1.0, best.place))
    try:
        return trials.at(place)
    except Beyond:
        return best


def _minimised(trials: Trials, begin: Trial, box: Box) -> Trial:
    """The trial where one round of the optimiser in a box ends."""
    aim, history, (lower, upper) = trials.aim, trials.history, box
    count = len(aim.lengths)
    if aim.levelled:
        least = 0.0 if aim.quantity == RADIUS and aim.sign > 0 else -np.inf
        lower, upper = np.append(lower, least), np.append(upper, np.inf)

    def at(x: np.ndarray) -> Trial:
        return trials.at(np.clip(x[:count], *box))

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
        begin = _nearer(trials, begin, box)
    return at(
        _slsqp(
            fun,
            lambda x: aim.slope(at(x)),
            aim.variables(begin),
            (lower, upper),
            constraints,
            trials.most,
            note,
        )
    )


def _nearer(trials: Trials, begin: Trial, box: Box) -> Trial:
    """The trial in a box at which the largest violation of all conditions is the smallest.

    Where conditions are violated their linear forms may contradict each other; with one slack
    variable for all of them they do not.
    """
    aim, count = trials.aim, len(trials.aim.lengths)

    def rows(x: np.ndarray) -> Rows:
        point = trials.at(np.clip(x[:count], *box))
        level = aim.variables(point)[-1]
        equal, others = (aim.rows(point, level, equal=each) for each in (True, False))
        values = np.concatenate([equal.values, -equal.values, others.values])
        slopes = np.vstack([equal.slopes, -equal.slopes, others.slopes])[:, :count]
        return Rows(values + x[-1], np.hstack([slopes, np.ones((len(slopes), 1))]))

    slack = np.eye(count + 1)[-1]
    first = np.append(begin.place, aim.missed(begin))
    wide = np.append(box[0], 0.0), np.append(box[1], np.inf)
    found = _slsqp(
        lambda x: float(x[-1]), lambda _: slack, first, wide, {"ineq": rows}, trials.most
    )
    return trials.at(np.clip(found[:count], *box))


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
