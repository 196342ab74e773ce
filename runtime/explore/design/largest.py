"""Largest of several from above: conditions that are smooth where these meet.

The spectral radius is the largest multiplier; the peak of a state its maximum or minus its
minimum.

All roots of λ² - Tλ + D are in the disc of radius t where t² + D ≥ |T| t and t² ≥ D (E. I. Jury,
Theory and Application of the z-Transform Method, 1964). Trace and determinant have derivatives
everywhere, so that an optimum may be a corner, where two multipliers meet or are equally large.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.quantities import PEAK, sides_of

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives

__all__ = ["LevelRows", "corner_of", "is_smooth_from_above", "peak_rows", "radius_rows"]

_ZERO = "the multiplier passes through zero"
_MEET = "two multipliers meet"
_OPPOSITE = "two multipliers of opposite sign are equally large"
_TIED = "the largest and the smallest value are equally far from zero"
_SEVERAL = "several multipliers are equally large"
_SAME_SLOPE = 1e-6  # of extremes that tie by a symmetry
_SAME = 1e-9  # of two derivatives: those of a conjugate pair


class LevelRows(NamedTuple):
    """Conditions of a level, each not negative where the spectral radius is below it.

    Attributes
    ----------
    values : array (m,)
    by_parameters : array (m, q)
    by_level : array (m,)
    """

    values: np.ndarray
    by_parameters: np.ndarray
    by_level: np.ndarray


def is_smooth_from_above(derivatives: OrbitDerivatives) -> bool:
    """Whether the conditions have derivatives everywhere: up to two multipliers.

    Parameters
    ----------
    derivatives : OrbitDerivatives

    Returns
    -------
    bool
    """
    section = derivatives.directions.section
    return section.rank - section.trivial <= 2


def radius_rows(derivatives: OrbitDerivatives, level: float) -> LevelRows:
    """The conditions that all nontrivial multipliers are in a disc.

    Parameters
    ----------
    derivatives : OrbitDerivatives
    level : float
        Radius of the disc.

    Returns
    -------
    LevelRows
    """
    found, section = derivatives.section, derivatives.directions.section
    count = section.rank - section.trivial
    # a trivial multiplier is 1: it adds to the trace and not to the product
    trace = float(found.trace) - section.trivial
    trace_rates = np.asarray(found.trace_rates, dtype=float)
    if count == 1:
        return LevelRows(
            np.array([level - trace, level + trace]),
            np.stack([-trace_rates, trace_rates]),
            np.ones(2),
        )
    if count == 2:
        product = float(found.determinant)
        rates = np.asarray(found.determinant_rates, dtype=float)
        square = level**2
        return LevelRows(
            square + np.array([product - trace * level, product + trace * level, -product]),
            np.stack([rates - level * trace_rates, rates + level * trace_rates, -rates]),
            np.array([2 * level - trace, 2 * level + trace, 2 * level]),
        )
    multipliers = found.multipliers.astype(complex)
    sizes = np.abs(multipliers)
    rates = np.asarray(found.multiplier_rates, dtype=complex)
    moved = (np.conj(multipliers)[:, None] * rates).real / np.maximum(sizes, 1e-300)[:, None]
    return LevelRows(level - sizes, -moved, np.ones(len(sizes)))


def peak_rows(derivatives: OrbitDerivatives, peak: str, level: float) -> LevelRows:
    """The conditions that a state stays between a level and minus that.

    Parameters
    ----------
    derivatives : OrbitDerivatives
    peak : str
        ``peak:STATE``.
    level : float

    Returns
    -------
    LevelRows
    """
    (high, up), (low, down) = (derivatives.quantity(side) for side in sides_of(peak))
    return LevelRows(
        np.array([level - float(high), level + float(low)]),
        np.stack([-np.asarray(up, dtype=float), np.asarray(down, dtype=float)]),
        np.ones(2),
    )


def corner_of(derivatives: OrbitDerivatives, quantity: str, active: np.ndarray) -> str:
    """What happens where several conditions act at once.

    Parameters
    ----------
    derivatives : OrbitDerivatives
    quantity : str
        Of which the conditions are.
    active : array (m,) of bool
        Which of the conditions hold with equality.

    Returns
    -------
    str
        Empty where the quantity is smooth.
    """
    section = derivatives.directions.section
    count = section.rank - section.trivial
    if active.sum() < 2:
        return ""
    if quantity.startswith(PEAK):
        up, down = (derivatives.quantity(side)[1] for side in sides_of(quantity))
        size = max(1.0, float(np.abs(up).max()))
        return _TIED if float(np.abs(up + down).max()) > _SAME_SLOPE * size else ""
    if count == 1:
        return _ZERO
    if count == 2:
        return _OPPOSITE if active[:2].all() else _MEET
    largest = np.asarray(derivatives.section.multipliers)[active].astype(complex)
    apart = np.abs(largest[:, None] - largest) > _SAME
    mirrored = np.abs(largest[:, None] - largest.conj()) > _SAME
    return _SEVERAL if (apart & mirrored).any() else ""
