"""What is made as small as it can be, and the conditions, in the variables of an optimiser."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.condition import DesignCondition
from nonsmooth.runtime.explore.design.design_points import DesignPoint
from nonsmooth.runtime.explore.design.largest import peak_rows, radius_rows
from nonsmooth.runtime.explore.design.quantities import (
    MULTIPLIER,
    PEAK,
    RADIUS,
    multiplier_gap,
)

__all__ = ["Aim", "MarginKey", "Rows"]

_INSIDE = 1e-10  # of a margin: an orbit at the limit is a motion despite of rounding


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
    conditions : tuple of DesignCondition
    scale : float
        Unit of the quantity.
    lengths : array (q,)
        Of the parameters' intervals.
    margins : tuple of MarginKey
        Boundaries that must not be crossed, each in its phase.
    """

    quantity: str
    sign: int
    conditions: tuple[DesignCondition, ...]
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
        return np.append(point.place, point.quantities.values[self.quantity] / self.scale)

    def value(self, point: DesignPoint) -> float:
        """What is made small, at an orbit.

        Parameters
        ----------
        point : DesignPoint

        Returns
        -------
        float
        """
        return self.sign * point.quantities.values[self.quantity] / self.scale

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
            return np.asarray(np.eye(len(self.lengths) + 1)[-1])
        slope = point.quantities.slopes[self.quantity]
        return np.asarray(self.sign * slope * self.lengths / self.scale)

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
        derivatives = point.quantities.derivatives
        if self.quantity == RADIUS:
            found = radius_rows(derivatives, level * self.scale)
        else:
            found = peak_rows(derivatives, self.quantity, level * self.scale)
        by_level = found.by_level[:, None] * self.scale
        slopes = np.hstack([found.by_parameters * self.lengths, by_level])
        size = self.scale ** (2 if len(found.values) == 3 else 1)
        return Rows(found.values / size, slopes / size)

    def condition_rows(self, point: DesignPoint, condition: DesignCondition) -> Rows:
        """One condition.

        Parameters
        ----------
        point : DesignPoint
        condition : DesignCondition

        Returns
        -------
        Rows
            Not negative where it holds, zero where it is an equation.
        """
        measured, wanted = point.quantities, float(condition.value)
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

    def relaxing(self, point: DesignPoint, condition: DesignCondition) -> np.ndarray:
        """By how much each row of a condition grows for each unit of its value.

        Parameters
        ----------
        point : DesignPoint
        condition : DesignCondition

        Returns
        -------
        array (m,)
            Positive where the condition is relaxed; of an equation minus that.
        """
        derivatives, wanted = point.quantities.derivatives, float(condition.value)
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
        there = {MarginKey(m.phase, m.boundary): m for m in point.quantities.derivatives.margins}
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
