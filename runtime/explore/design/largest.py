"""Largest of several from above: conditions that are smooth where these meet.

The spectral radius is the largest multiplier; a peak the largest of the local extremes of a
motion.

All roots of λ² - Tλ + D are in the disc of radius t where t² + D ≥ |T| t and t² ≥ D (E. I. Jury,
Theory and Application of the z-Transform Method, 1964). Trace and determinant have derivatives
also where the two roots meet, so that an optimum may be a corner. Several multipliers are taken
in pairs, each by the map on its invariant plane.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.multiplier_pairs import multiplier_groups
from nonsmooth.runtime.explore.design.quantities import RADIUS, is_extreme

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.motion_derivatives import LocalExtreme

__all__ = [
    "ExtremeKey",
    "LevelRows",
    "corner_of",
    "extreme_keys",
    "extreme_rows",
    "is_largest_of_several",
    "radius_rows",
]

_ZERO = "the multiplier passes through zero"
_MEET = "two multipliers meet"
_OPPOSITE = "two multipliers of opposite sign are equally large"
_TIED = "the largest and the smallest value are equally far from zero"
_EXTREMES = "several extremes are equally large"
_SEVERAL = "several multipliers are equally large"
_SAME_SLOPE = 1e-6  # of extremes that tie by a symmetry, or are one at the end of a phase


class LevelRows(NamedTuple):
    """Conditions of a level, each not negative where the largest number is at most the level."""

    values: np.ndarray  # (m,)
    by_parameters: np.ndarray  # derivatives (m, q)
    by_level: np.ndarray  # derivatives (m,)
    powers: np.ndarray  # (m,), power of the quantity's unit in which each is measured


class ExtremeKey(NamedTuple):
    """A number of local extremes in a phase (from 0): maxima, or minima if the sign is -1."""

    phase: int
    sign: int
    number: int


def is_largest_of_several(quantity: str, sign: int) -> bool:
    """Whether the objective is the largest of several numbers that have derivatives.

    `sign` is -1 where the quantity is maximised.
    """
    if quantity.startswith("minimum:"):
        return sign < 0
    return sign > 0 and (quantity == RADIUS or is_extreme(quantity))


def radius_rows(derivatives: OrbitDerivatives, level: float) -> LevelRows:
    """The conditions that all nontrivial multipliers are in a disc of radius `level`.

    There are two for a multiplier alone and three for a pair.
    """
    values, by_parameters, by_level, powers = [], [], [], []
    for group in multiplier_groups(derivatives):
        trace, product = group.trace, group.determinant
        trace_rates, rates = group.trace_rates, group.determinant_rates
        if group.size == 1:
            values += [level - trace, level + trace]
            by_parameters += [-trace_rates, trace_rates]
            by_level += [1.0, 1.0]
            powers += [1, 1]
            continue
        square = level**2
        values += [
            square + product - trace * level,
            square + product + trace * level,
            square - product,
        ]
        by_parameters += [rates - level * trace_rates, rates + level * trace_rates, -rates]
        by_level += [2 * level - trace, 2 * level + trace, 2 * level]
        powers += [2, 2, 2]
    return LevelRows(
        np.array(values), np.array(by_parameters), np.array(by_level), np.array(powers)
    )


def extreme_keys(every: Iterable[OrbitDerivatives], quantity: str) -> tuple[ExtremeKey, ...]:
    """Number of the local extremes of which a quantity is the largest, for each phase and sign.

    Of several orbits of one itinerary the largest number counts.
    """
    counts: dict[tuple[int, int], int] = {}
    for derivatives in every:
        own: dict[tuple[int, int], int] = {}
        for extreme in derivatives.local_extremes(quantity):
            place = extreme.phase, extreme.sign
            own[place] = own.get(place, 0) + 1
        counts = {key: max(counts.get(key, 0), own.get(key, 0)) for key in {**counts, **own}}
    return tuple(ExtremeKey(*place, count) for place, count in sorted(counts.items()))


def extreme_rows(
    derivatives: OrbitDerivatives,
    quantity: str,
    keys: Iterable[ExtremeKey],
    level: float,
    unit: float,
) -> LevelRows:
    """The conditions that no local extreme of a quantity exceeds a level.

    For each key they are those of the largest extremes; where an orbit has fewer of them, the
    remaining conditions hold by far. `unit` is that of the quantity.
    """
    found = derivatives.local_extremes(quantity)
    rows: list[LocalExtreme | None] = []
    for phase, sign, count in keys:
        own = [each for each in found if (each.phase, each.sign) == (phase, sign)]
        largest = sorted(sorted(own, key=_value)[-count:], key=_time)
        rows += [*largest]
        rows += [None] * (count - len(largest))
    far, nothing = max(unit, abs(level)), np.zeros(len(derivatives.by))
    return LevelRows(
        np.array([far if each is None else level - each.value for each in rows]),
        np.array([nothing if each is None else -each.rates for each in rows], dtype=float),
        np.array([each is not None for each in rows], dtype=float),
        np.ones(len(rows)),
    )


def _value(extreme: LocalExtreme) -> float:
    return extreme.value


def _time(extreme: LocalExtreme) -> float:
    return extreme.time


def corner_of(
    derivatives: OrbitDerivatives,
    quantity: str,
    active: np.ndarray,
    slopes: np.ndarray,
    units: np.ndarray,
) -> str:
    """What happens where several conditions of one orbit act; empty where the quantity is smooth.

    `active` (m,) marks the conditions that hold with equality, `slopes` (m, n) are their
    derivatives, and `units` (q,) are those of the quantity's derivatives.
    """
    acting = slopes[active]
    size = max(1.0, float(np.abs(acting).max(initial=0.0)))
    if len(acting) < 2 or float(np.ptp(acting, axis=0).max()) <= _SAME_SLOPE * size:
        return ""
    if quantity != RADIUS:
        ties = _largest(derivatives, quantity)
        for sign in {each.sign for each in ties}:
            rates = np.array([each.rates for each in ties if each.sign == sign], dtype=float)
            rates /= units
            if float(np.ptp(rates, axis=0).max()) > _SAME_SLOPE * size:
                return _EXTREMES
        return _TIED
    groups = list(multiplier_groups(derivatives))
    ends = np.cumsum([2 if group.size == 1 else 3 for group in groups])
    acting_in = {int(k) for k in np.searchsorted(ends, np.flatnonzero(active), side="right")}
    if len(acting_in) > 1:
        return _SEVERAL
    (place,) = acting_in
    if groups[place].size == 1:
        return _ZERO
    first = int(ends[place]) - 3
    return _OPPOSITE if active[first : first + 2].all() else _MEET


def _largest(derivatives: OrbitDerivatives, quantity: str) -> list[LocalExtreme]:
    found = derivatives.local_extremes(quantity)
    top = max(each.value for each in found)
    return [each for each in found if each.value >= top - _SAME_SLOPE * abs(top)]
