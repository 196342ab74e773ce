"""What is made as small as it can be under conditions, and which of these act at an optimum.

All is in the variables of an optimiser.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.explore.design.design_points import DesignPoint
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
    multiplier_gap,
    radius_rows,
    unit_of,
)

__all__ = [
    "Aim",
    "MarginKey",
    "Optimality",
    "Rows",
    "Trial",
    "optimality",
    "watched_margins",
]

_INSIDE = 1e-10  # of a margin's unit: an orbit at the limit is a motion despite of rounding
_ACTIVE, _ACTIVE_BOUND = 1e-6, 1e-7


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


class Trial(Protocol):
    """Parameters that were tried, and the orbits there."""

    @property
    def place(self) -> np.ndarray:
        """Position (q,) of the parameters in their bounds: 0 is the lower one, 1 the upper."""

    @property
    def members(self) -> tuple[DesignPoint, ...]:
        """The orbit at these parameters, or several orbits of its branch (for `worst_over`)."""


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
    units: Mapping[str, float] = field(default_factory=dict)
    # boundaries that must not be crossed in a phase, with the units of their functions
    margins: Mapping[MarginKey, float] = field(default_factory=dict)
    # local extremes of a peak, each of which has to be below the level
    extremes: tuple[ExtremeKey, ...] = ()
    spread: bool = False  # whether the worst along a branch is minimised

    @property
    def levelled(self) -> bool:
        """Whether the level is one of the variables."""
        several = is_largest_of_several(self.quantity, self.sign)
        return bool(self.quantity) and (self.spread or several)

    @property
    def least_level(self) -> float:
        """Lower bound of the level."""
        return 0.0 if self.quantity == RADIUS and self.sign > 0 else -np.inf

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
        return np.asarray(self.sign * self._by_places(slope) / self.scale)

    def _by_places(self, slopes: np.ndarray) -> np.ndarray:
        """Derivatives by the places of the parameters, without those along a branch."""
        count = len(self.lengths)
        return np.asarray(slopes[..., :count] * self.lengths)

    def level_rows(self, member: DesignPoint, level: float) -> Rows:
        """The conditions that the quantity of an orbit does not exceed the level.

        The level is in units of `scale`. The rows are not negative where the conditions hold.
        """
        measured, wanted = member.quantities, level * self.scale
        if self.extremes:
            found = extreme_rows(
                measured.derivatives, self.quantity, self.extremes, wanted, self.scale
            )
        elif self.quantity == RADIUS and self.sign > 0:
            found = radius_rows(measured.derivatives, wanted)
        else:
            value, slope = measured.values[self.quantity], measured.slopes[self.quantity]
            found = LevelRows(
                np.array([wanted - self.sign * value]),
                -self.sign * slope[None],
                np.ones(1),
                np.ones(1),
            )
        by_level = found.by_level[:, None] * self.scale
        slopes = np.hstack([self._by_places(found.by_parameters), by_level])
        sizes = self.scale**found.powers
        return Rows(found.values / sizes, slopes / sizes[:, None])

    def size(self, condition: DesignCondition) -> float:
        """Unit in which the violation of a condition is measured."""
        return max(self.units.get(condition.quantity, 1.0), abs(float(condition.value)))

    def condition_rows(self, member: DesignPoint, condition: DesignCondition) -> Rows:
        """One condition at one orbit: rows that are not negative, or zero for an equation."""
        measured, wanted = member.quantities, float(condition.value)
        if condition.quantity == MULTIPLIER:
            gap = multiplier_gap(measured.derivatives, wanted)
            values, slopes = np.array([gap.value]), gap.slope[None]
        elif condition.quantity == RADIUS and condition.relation == "<=":
            rows = radius_rows(measured.derivatives, wanted)
            values, slopes = rows.values, rows.by_parameters
        else:
            value, slope = self.distance(member, condition)
            values, slopes = np.array([value]), slope[None]
        size = self.size(condition)
        return Rows(values / size, self._with_level(self._by_places(slopes) / size))

    def distance(self, member: DesignPoint, condition: DesignCondition) -> tuple[float, np.ndarray]:
        """How far a quantity is inside of a condition, and the derivatives by all parameters."""
        measured, sign = member.quantities, -1.0 if condition.relation == "<=" else 1.0
        value = measured.values[condition.quantity] - float(condition.value)
        return sign * value, sign * measured.slopes[condition.quantity]

    def _with_level(self, slopes: np.ndarray) -> np.ndarray:
        """Derivatives extended by that by the level, which is zero."""
        return np.hstack([slopes, np.zeros((len(slopes), 1))]) if self.levelled else slopes

    def relaxing(self, member: DesignPoint, condition: DesignCondition) -> np.ndarray:
        """Growth (m,) of each row of a condition per unit of its value.

        It is positive where the condition is relaxed, and minus that for an equation.
        """
        derivatives, wanted = member.quantities.derivatives, float(condition.value)
        if condition.quantity == MULTIPLIER:
            found = np.array([-multiplier_gap(derivatives, wanted).by_wanted])
        elif condition.quantity == RADIUS and condition.relation == "<=":
            found = radius_rows(derivatives, wanted).by_level
        else:
            found = np.ones(1)
        return found / self.size(condition)

    def distances(self, member: DesignPoint) -> tuple[np.ndarray, np.ndarray]:
        """Scaled distances (m,) from the boundaries, and their derivatives by all parameters.

        A distance is 1 where there is no maximum inside the phase.
        """
        derivatives = member.quantities.derivatives
        there = {MarginKey(m.phase, m.boundary): m for m in derivatives.margins}
        values = np.ones(len(self.margins))
        slopes = np.zeros((len(self.margins), len(derivatives.by)))
        for place, (key, unit) in enumerate(self.margins.items()):
            if key in there:
                values[place] = float(there[key].value) / unit
                slopes[place] = np.asarray(there[key].rates, dtype=float) / unit
        return values, slopes

    def margin_rows(self, member: DesignPoint) -> Rows:
        """The conditions that an orbit crosses none of the boundaries."""
        values, slopes = self.distances(member)
        return Rows(values - _INSIDE, self._with_level(self._by_places(slopes)))

    def rows(self, point: Trial, level: float, *, equal: bool) -> Rows:
        """The rows of all equations (`equal`), or of all other conditions, of a trial.

        `level` is the value of the level, where there is one.
        """
        found = [
            self.condition_rows(member, each)
            for member in point.members
            for each in self.conditions
            if (each.relation == "=") == equal
        ]
        if self.margins and not equal:
            found.extend(self.margin_rows(member) for member in point.members)
        if self.levelled and not equal:
            found.extend(self.level_rows(member, level) for member in point.members)
        if not found:
            return Rows(np.zeros(0), np.zeros((0, len(self.lengths) + self.levelled)))
        return Rows(np.concatenate([f.values for f in found]), np.vstack([f.slopes for f in found]))

    def missed(self, point: Trial) -> float:
        """Largest violation of all conditions at a trial, in their units."""
        equal = np.abs(self.rows(point, 0.0, equal=True).values)
        short = [
            self.condition_rows(member, c).values
            for member in point.members
            for c in self.conditions
            if c.relation != "="
        ]
        if self.margins:
            short.extend(self.margin_rows(member).values for member in point.members)
        return float(max(np.concatenate([[0.0], equal, *(-each for each in short)])))


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
    acting = [*_acting(aim, point, names, bounds, where)]
    slopes = [each.slope for each in acting]
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
    lower[: len(acting)][[each.equation for each in acting]] = -np.inf
    found = lsq_linear(np.array(slopes).T, gradient, (lower, np.full(len(slopes), np.inf)))
    left = float(np.abs(found.fun).max())
    factors: dict[str, float] = {}  # a conjugate pair meets one condition twice
    for (text, _, unit, _), factor in zip(acting, found.x.tolist(), strict=False):
        factors[text] = factors.get(text, 0.0) + factor * aim.scale * unit
    limits = tuple(ActiveLimit(text=text, multiplier=each) for text, each in factors.items())
    return Optimality(limits, left, corner, tuple(worst_at))


class _Acting(NamedTuple):
    """A condition or a bound that holds with equality."""

    text: str
    slope: np.ndarray  # (n,)
    unit: float  # by how much it grows per unit of its limit
    equation: bool = False


def _acting(
    aim: Aim,
    point: Trial,
    names: Sequence[str],
    bounds: np.ndarray,
    where: Callable[[DesignPoint], str],
) -> Iterator[_Acting]:
    for member, condition in product(point.members, aim.conditions):
        equation = condition.relation == "="
        rows, grown = aim.condition_rows(member, condition), aim.relaxing(member, condition)
        for value, slope, unit in zip(*rows, grown.tolist(), strict=True):
            if equation or abs(value) <= _ACTIVE:
                yield _Acting(condition.text + where(member), slope, unit, equation)
    for member in point.members if aim.margins else ():
        margins = aim.margin_rows(member)
        for (key, unit), value, slope in zip(aim.margins.items(), *margins, strict=True):
            if abs(value) <= _ACTIVE:
                away = f"{key.boundary} stays away in phase {key.phase + 1}"
                yield _Acting(away + where(member), slope, 1 / unit)
    units = np.eye(len(names) + aim.levelled)
    for place, sign, text in _sides(point, names, bounds):
        yield _Acting(text, sign * units[place], 1 / float(aim.lengths[place]))


def _sides(
    point: Trial, names: Sequence[str], bounds: np.ndarray
) -> Iterator[tuple[int, float, str]]:
    """Parameters at a bound, with the direction inwards and the bound in words."""
    for place, name in enumerate(names):
        for side, (sign, relation) in enumerate(((1.0, ">="), (-1.0, "<="))):
            if abs(point.place[place] - side) <= _ACTIVE_BOUND:
                yield place, sign, f"{name}{relation}{float(bounds[place, side])!r}"
