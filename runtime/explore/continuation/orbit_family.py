"""What a family of orbits has to tell to be followed over one parameter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["Curve"]


class Curve(Protocol):
    """Orbits of one itinerary as the zeros z = (unknowns, parameter) of its equations.

    Arrays of many points are (k, n + 1). Nondimensional, or in the units of the declaration.

    Attributes
    ----------
    orbit : Orbit
        Where the branch begins.
    names : tuple of str
        Of the unknowns.
    parameter : str
    first : array (n + 1,)
        The orbit where the branch begins.
    sizes : array (n + 1,)
        Units of measure; that of the parameter is the length of its interval.
    dwell_names : tuple of str
        Of the phases that take time.
    phases : tuple of (configuration, boundary)
        Those phases.
    order : int
        As many parts, images of each other by a symmetry, make up one period.
    """

    orbit: Any
    names: tuple[str, ...]
    parameter: str
    first: np.ndarray
    sizes: np.ndarray
    dwell_names: tuple[str, ...]
    phases: tuple[tuple[str, str], ...]
    order: int

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,) at one point, and their Jacobian (m, n + 1); m >= n."""

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """Dwell times (k, p) of the phases that take time: affine in z."""

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """By how much the state behind a part differs from the start.

        For each of the parts that the itinerary repeats. Where it is zero the branch meets that
        of the part, and comes back with the parts exchanged.
        """

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Boundary functions of each phase, for groups of points whose places are given."""

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """Numbers (k, c) that keep their sign while transitions lead where they do."""

    @property
    def condition_places(self) -> Sequence[int]:
        """Phase whose end each of these conditions belongs to."""

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Which of its transitions each phase (k, p) takes, from these numbers."""

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """Multipliers (k, r) over one part that may differ from zero, without trivial ones."""

    def traces(self, z: np.ndarray) -> np.ndarray:
        """Traces (k,) of the Poincare map of the whole period."""

    @property
    def conservative(self) -> bool:
        """Whether orbits come in families that a first integral parametrises."""

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """Whether the points (k,) are motions of the real system."""

    def at(self, z: np.ndarray) -> Orbit | Any:
        """The orbit at one point as a record."""

    def moved(self, name: str, value: float) -> Curve:
        """The same family with another of the numbers that were given changed."""
