"""Values of quantities at an orbit, and their exact derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.orbits.motion_derivatives import KINDS

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = [
    "MULTIPLIER",
    "RADIUS",
    "Gap",
    "QuantityValues",
    "is_extreme",
    "is_pure",
    "measure",
    "multiplier_gap",
    "unit_of",
]

RADIUS, MULTIPLIER = "spectral_radius", "multiplier"
_PURE = (RADIUS, MULTIPLIER, "trace", "determinant")
_LEAST_UNIT = 1e-3  # of what the bounds change: the unit of a quantity that begins near zero


class QuantityValues(NamedTuple):
    """Quantities at one orbit, and their derivatives by q parameters."""

    values: Mapping[str, float]
    slopes: Mapping[str, np.ndarray]  # (q,) each, NaN where there is no derivative
    derivatives: OrbitDerivatives  # of all other quantities of the orbit

    def quantity(self, name: str, wanted: float | None = None) -> float:
        """Value of a quantity; for a multiplier that which is nearest to `wanted`."""
        if name != MULTIPLIER:
            return self.values[name]
        found = np.asarray(self.derivatives.section.multipliers).astype(complex)
        return float(found[np.abs(found - wanted).argmin()].real)


def measure(orbit: Orbit, by: Sequence[str], of: Sequence[str]) -> QuantityValues:
    """The quantities named in `of` at an orbit, with derivatives by the given parameters `by`.

    The names are those of `OrbitDerivatives.quantity`. A quantity that is unknown or does not
    exist is refused, and so is an orbit without derivatives.
    """
    found = orbit.derivatives(list(by))
    values, slopes = {}, {}
    for name in of:
        if is_extreme(name):  # also where several extremes tie
            largest = max(found.local_extremes(name), key=lambda extreme: extreme.value)
            sign = -1.0 if name.startswith("minimum") else 1.0
            values[name] = sign * largest.value
            slopes[name] = sign * np.asarray(largest.rates, dtype=float)
            continue
        value, slope = found.quantity(name)
        values[name], slopes[name] = float(value), np.asarray(slope, dtype=float)
    return QuantityValues(values, slopes, found)


def is_extreme(quantity: str) -> bool:
    """Whether a quantity is the largest of several local extremes of the motion."""
    kind, _, of = quantity.partition(":")
    return kind in KINDS and bool(of)


def is_pure(quantity: str) -> bool:
    """Whether a quantity is dimensionless."""
    return quantity in _PURE


def unit_of(value: float, changes: np.ndarray) -> float:
    """Positive unit of a quantity: its size, or a share of its change over the bounds.

    `value` is taken where the design begins, and `changes` (q,) are its derivatives by the
    places of the parameters, NaN where there is none. The unit of zero without change is 1.
    """
    size = max(abs(value), _LEAST_UNIT * float(np.nan_to_num(np.abs(changes)).max(initial=0.0)))
    return size or 1.0


class Gap(NamedTuple):
    """The characteristic polynomial at a wanted multiplier."""

    value: float  # product of the differences between the wanted multiplier and each multiplier
    slope: np.ndarray  # derivatives (q,) by parameters, also where multipliers collide
    by_wanted: float  # derivative by the wanted multiplier


def multiplier_gap(derivatives: OrbitDerivatives, wanted: float) -> Gap:
    """The characteristic polynomial at a wanted multiplier, zero where the orbit has it.

    Refused are the multiplier zero, and a family of orbits, which has the multiplier 1
    everywhere.
    """
    matrix, rates, rank, trivial = derivatives.directions.section
    if trivial or not wanted:
        told = "1 belongs to a whole family" if trivial else "0 belongs to no orbit"
        raise InputError(f"no multiplier can be wanted here: {told}")
    matrix, rates = matrix.astype(float), rates.astype(float)
    beside, unit = len(matrix) - rank, np.eye(len(matrix))
    scale, shifted = wanted**beside, wanted * unit - matrix
    value = float(np.linalg.det(shifted)) / scale
    moving = np.concatenate([-rates, unit[None]])
    *moved, by_wanted = imaginary_parts(np.linalg.det(stepped(shifted, moving, None)), None) / scale
    return Gap(value, np.array(moved), float(by_wanted) - beside * value / wanted)
