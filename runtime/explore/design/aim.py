"""What is made as small as it can be, and the conditions, in the variables of an optimiser."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.explore.design.condition import DesignCondition
from nonsmooth.runtime.explore.design.design_points import DesignPoint
from nonsmooth.runtime.explore.design.largest import (
    ExtremeKey,
    LevelRows,
    extreme_rows,
    is_largest_of_several,
    radius_rows,
)
from nonsmooth.runtime.explore.design.quantities import (
    MULTIPLIER,
    RADIUS,
    QuantityValues,
    multiplier_gap,
    unit_of,
)

__all__ = ["Aim", "MarginKey", "Rows", "Trial", "watched_margins"]

_INSIDE = 1e-10  # of a margin's unit: an orbit at the limit is a motion despite of rounding


class MarginKey(NamedTuple):
    """A boundary that stays away along a phase, counted from 0."""

    phase: int
    boundary: str


def watched_margins(measured: QuantityValues, lengths: np.ndarray) -> dict[MarginKey, float]:
    """The boundaries that stay away along an orbit, and the units of their functions.

    Parameters
    ----------
    measured : QuantityValues
    lengths : array (q,)
        Of the parameters' intervals.
    """
    found = {}
    for margin in measured.derivatives.margins:
        changes = np.asarray(margin.rates[: len(lengths)], dtype=float) * lengths
        found[MarginKey(margin.phase, margin.boundary)] = unit_of(float(margin.value), changes)
    return found


class Rows(NamedTuple):
    """Scaled numbers and their derivatives by the variables of the optimiser.

    Attributes
    ----------
    values : array (m,)
    slopes : array (m, n)
    """

    values: np.ndarray
    slopes: np.ndarray


class Trial(Protocol):
    """Parameters that were tried, and the orbits there.

    Attributes
    ----------
    place : array (q,)
        Of the parameters in their bounds.
    members : tuple of DesignPoint
        The orbit; or, of a design of the worst along a branch, several orbits of that branch.
    """

    @property
    def place(self) -> np.ndarray:
        """Of the parameters."""

    @property
    def members(self) -> tuple[DesignPoint, ...]:
        """The orbits."""


@dataclass(frozen=True)
class Aim:
    """What is made as small as it can be, and the conditions.

    The variables are the places of the parameters in their bounds and, for what is the largest
    of several, such as a spectral radius that is minimised, the level that none of them exceeds
    (the epigraph form). All conditions hold for all orbits of a trial.

    Attributes
    ----------
    quantity : str
    sign : int
        -1 where it is maximised.
    conditions : tuple of DesignCondition
    scale : float
        Unit of the quantity.
    units : mapping of str to float
        Of all quantities that conditions ask for, but of pure numbers.
    lengths : array (q,)
        Of the parameters' intervals.
    margins : mapping of MarginKey to float
        Boundaries that must not be crossed, each in its phase, and the units of their functions.
    extremes : tuple of ExtremeKey
        Local extremes of a peak, each below the level.
    spread : bool
        Whether the worst along a branch is made as small as it can be.
    """

    quantity: str
    sign: int
    conditions: tuple[DesignCondition, ...]
    scale: float
    lengths: np.ndarray
    units: Mapping[str, float] = field(default_factory=dict)
    margins: Mapping[MarginKey, float] = field(default_factory=dict)
    extremes: tuple[ExtremeKey, ...] = ()
    spread: bool = False

    @property
    def levelled(self) -> bool:
        """Whether there is a level among the variables."""
        several = is_largest_of_several(self.quantity, self.sign)
        return bool(self.quantity) and (self.spread or several)

    @property
    def least_level(self) -> float:
        """Lower bound of the level."""
        return 0.0 if self.quantity == RADIUS and self.sign > 0 else -np.inf

    def variables(self, point: Trial) -> np.ndarray:
        """The variables at a trial.

        Returns
        -------
        array (n,)
        """
        return np.append(point.place, self.value(point)) if self.levelled else point.place

    def worst(self, point: Trial) -> DesignPoint:
        """The orbit of a trial at which the quantity is worst."""
        return max(point.members, key=self._value)

    def value(self, point: Trial) -> float:
        """What is made small, at a trial."""
        return self._value(self.worst(point))

    def _value(self, member: DesignPoint) -> float:
        return self.sign * member.quantities.values[self.quantity] / self.scale

    def slope(self, point: Trial) -> np.ndarray:
        """Derivatives of what is made small by the variables.

        Returns
        -------
        array (n,)
        """
        if self.levelled:
            return np.asarray(np.eye(len(self.lengths) + 1)[-1])
        slope = self.worst(point).quantities.slopes[self.quantity]
        return np.asarray(self.sign * self._by_places(slope) / self.scale)

    def _by_places(self, slopes: np.ndarray) -> np.ndarray:
        """Derivatives by the places of the parameters; of those along a branch there are more."""
        count = len(self.lengths)
        return np.asarray(slopes[..., :count] * self.lengths)

    def level_rows(self, member: DesignPoint, level: float) -> Rows:
        """The conditions that the quantity of an orbit does not exceed the level.

        Parameters
        ----------
        member : DesignPoint
        level : float
            In units of `scale`.

        Returns
        -------
        Rows
            Not negative where they hold.
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
        """Unit in which a condition is missed."""
        return max(self.units.get(condition.quantity, 1.0), abs(float(condition.value)))

    def condition_rows(self, member: DesignPoint, condition: DesignCondition) -> Rows:
        """One condition of one orbit.

        Returns
        -------
        Rows
            Not negative where it holds, zero where it is an equation.
        """
        measured, wanted = member.quantities, float(condition.value)
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
        size = self.size(condition)
        return Rows(values / size, self._with_level(self._by_places(slopes) / size))

    def _with_level(self, slopes: np.ndarray) -> np.ndarray:
        """Derivatives of what does not depend on the level."""
        return np.hstack([slopes, np.zeros((len(slopes), 1))]) if self.levelled else slopes

    def relaxing(self, member: DesignPoint, condition: DesignCondition) -> np.ndarray:
        """By how much each row of a condition grows for each unit of its value.

        Returns
        -------
        array (m,)
            Positive where the condition is relaxed; of an equation minus that.
        """
        derivatives, wanted = member.quantities.derivatives, float(condition.value)
        if condition.quantity == MULTIPLIER:
            found = np.array([-multiplier_gap(derivatives, wanted).by_wanted])
        elif condition.quantity == RADIUS and condition.relation == "<=":
            found = radius_rows(derivatives, wanted).by_level
        else:
            found = np.ones(1)
        return found / self.size(condition)

    def margin_rows(self, member: DesignPoint) -> Rows:
        """How far each boundary stays away; far where it has no maximum inside its phase."""
        margins = member.quantities.derivatives.margins
        there = {MarginKey(m.phase, m.boundary): m for m in margins}
        count = len(self.lengths)
        values, slopes = np.ones(len(self.margins)), np.zeros((len(self.margins), count))
        for place, (key, unit) in enumerate(self.margins.items()):
            if key in there:
                values[place] = float(there[key].value) / unit - _INSIDE
                slopes[place] = self._by_places(np.asarray(there[key].rates, dtype=float)) / unit
        return Rows(values, self._with_level(slopes))

    def rows(self, point: Trial, level: float, *, equal: bool) -> Rows:
        """All conditions that are equations, or all others.

        Parameters
        ----------
        point : Trial
        level : float
            Value of the level's variable, where there is one.
        equal : bool
            Whether equations are wanted.
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
        """By how much a trial misses the conditions, in their units.

        Returns
        -------
        float
            The largest of all.
        """
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
