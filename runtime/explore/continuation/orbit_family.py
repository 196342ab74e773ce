"""The family of orbits over one parameter, and the interval over which it is followed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.orbits.equations import equations_of
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["OrbitFamily", "check_interval"]

_LEAP = 1e-6  # of the difference of two parts before a step: what is left of it behind a leap
_EVEN = 1e-15  # what rounding leaves of such a difference


class OrbitFamily:
    """Orbits of one itinerary as the zeros z = (unknowns, parameter) of its equations.

    Arrays of many points are (k, n + 1). Nondimensional, or in the units of the declaration.
    What is not described here is as `OrbitEquations` has it.

    Parameters
    ----------
    orbit : Orbit
        Where the branch begins.
    parameter : str
        One of the numbers that were given for it.
    length : float
        Unit of measure of the parameter: the length of its interval.

    Attributes
    ----------
    names : tuple of str
        Of the unknowns.
    first : array (n + 1,)
        The orbit where the branch begins.
    sizes : array (n + 1,)
        Units of measure.

    Raises
    ------
    InputError
        For a period that the other parameters determine, or a system with several forcings.
    """

    def __init__(self, orbit: Orbit, parameter: str, length: float = 1.0) -> None:
        equations = equations_of(orbit)
        if parameter not in equations.names:
            raise InputError(f"{orbit.name}: the {parameter} is determined by the other parameters")
        self.orbit, self.parameter = orbit, parameter
        self._equations, self._base = equations, equations.values
        self.names, self.order = equations.unknowns, equations.order
        self.dwell_names, self.phases = equations.dwell_names, equations.phases
        self.conservative = equations.conservative
        self._places = [equations.names.index(name) for name in (*self.names, parameter)]
        self.first = self._base[self._places]
        self.sizes = np.append(equations.sizes, length)

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,) at one point, and their Jacobian (m, n + 1); m >= n.

        Parameters
        ----------
        z : array (n + 1,)

        Returns
        -------
        tuple of array (m,), array (m, n + 1)
        """
        return self._equations.linearised(self._full(z), self._places[-1])

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """Dwell times (k, p) of the phases that take time: affine in z.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        array (k, p)
            In the unit of time.
        """
        return self._equations.dwell(self._full(z))

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """By how much each part that the itinerary repeats misses being the first one.

        Parameters
        ----------
        z : array (n + 1,)

        Returns
        -------
        list of array (N,)
            In units of the states' sizes; empty where no part is repeated.
        """
        return self._equations.unevenness(self._full(z))

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """Whether parts that differ are the same behind a step: it has met the branch it doubles.

        Parameters
        ----------
        z, following : array (n + 1,)
        """
        parts = zip(self.unevenness(z), self.unevenness(following), strict=True)
        sizes = [tuple(float(np.abs(part).max()) for part in pair) for pair in parts]
        return any(after < _LEAP * before > _EVEN for before, after in sizes)

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Boundary functions of each phase, for groups of points whose places are given.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        list of (array of int, list of PhaseWaves)
            Places of the points of a group, and their phases.
        """
        return self._equations.waves(self._full(z))

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """Numbers (k, c) that keep their sign while transitions lead where they do.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        array (k, c)
        """
        return self._equations.conditions(self._full(z))

    @property
    def condition_places(self) -> Sequence[int]:
        """Phase whose end each of these conditions belongs to."""
        return self._equations.condition_places

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Which of its transitions each phase (k, p) takes, from these numbers.

        Parameters
        ----------
        conditions : array (k, c)
            As `conditions` gives them.

        Returns
        -------
        array (k, p) of int
        """
        return self._equations.taken(conditions)

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """Multipliers (k, r) over one part that may differ from zero, without trivial ones.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        array (k, r) of complex
        """
        return self._equations.multipliers(self._full(z))

    def traces(self, z: np.ndarray) -> np.ndarray:
        """Traces (k,) of the Poincare map of the whole period.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        array (k,)
        """
        return self._equations.traces(self._full(z))

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """Whether the points (k,) are motions of the real system.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        array (k,) of bool
        """
        return self._equations.admissible(self._full(z))

    def at(self, z: np.ndarray) -> Orbit:
        """The orbit at one point as a record.

        Parameters
        ----------
        z : array (n + 1,)
        """
        return self._equations.orbit_at(self._full(z), self._given(z))

    def motion(self, z: np.ndarray) -> Motion | Trajectory:
        """The motion at one point.

        Parameters
        ----------
        z : array (n + 1,)
        """
        return self._equations.motion_at(self._full(z), self._given(z))

    def moved(self, name: str, value: float) -> OrbitFamily:
        """The same family with another of the numbers that were given changed.

        Parameters
        ----------
        name : str
            Of a number that was given.
        value : float
            In its unit.

        Returns
        -------
        OrbitFamily
            A copy.
        """
        other = copy(self)
        other._base = self._base.copy()
        other._base[self._equations.names.index(name)] = value
        other.orbit = replace(self.orbit, given={**self.orbit.given, name: as_value(value)})
        return other

    def _full(self, z: np.ndarray) -> np.ndarray:
        """All numbers of the equations at a point, or at many."""
        full = np.empty((*z.shape[:-1], len(self._base)))
        full[...] = self._base
        full[..., self._places] = z
        return full

    def _given(self, z: np.ndarray) -> dict[str, Value]:
        return {**self.orbit.given, self.parameter: as_value(float(z[-1]))}


def check_interval(orbit: Orbit, parameter: str, interval: Any) -> tuple[float, float]:
    """Ends of an interval of a number that was given for an orbit.

    Parameters
    ----------
    orbit : Orbit
    parameter : str
        Name of the number.
    interval : (float, float)
        Lower and upper end.

    Returns
    -------
    (float, float)

    Raises
    ------
    InputError
        For an unknown name, or an interval that is empty, outside the domain or without the orbit.
    """
    if parameter not in orbit.given:
        raise unknown_name("given parameter", parameter, orbit.given)
    try:
        lower, upper = (float(end) for end in interval)
    except (TypeError, ValueError):
        raise InputError(f"the interval of {parameter} is not two numbers") from None
    value = float(orbit.given[parameter])
    if not (math.isfinite(lower) and math.isfinite(upper) and lower < upper):
        raise InputError(f"the interval of {parameter}, {lower:g} to {upper:g}, is empty")
    if not lower <= value <= upper:
        raise InputError(f"{parameter} = {value:g} of the orbit is not in {lower:g} to {upper:g}")
    for table in orbit.problem.parameters:
        if table.name == parameter:
            for end in (lower, upper):
                if not in_domain(table, end):
                    raise InputError(f"{parameter} = {end:g} is outside its domain")
    if parameter == orbit.problem.period_name and lower <= 0:
        raise InputError(f"{parameter} = {lower:g} is not positive")
    return lower, upper
