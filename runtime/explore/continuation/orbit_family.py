"""The family of orbits over parameters, by their own equations or the tables of their system."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.orbits.equations import equations_of
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["OrbitFamily", "SystemAt", "check_interval", "composed_family"]

_LEAP = 1e-6  # of the difference of two parts before a step: what is left of it behind a leap
_EVEN = 1e-15  # what rounding leaves of such a difference
SystemAt = Callable[[float], tuple[dict[str, Value], Value | None]]


class OrbitFamily:
    """Orbits of one itinerary as the zeros z = (unknowns, parameters) of its equations.

    Arrays of many points are (k, n + q), nondimensional or in the units of the declaration.
    The branch begins at `orbit`; the q `parameters` are numbers that were given for it, and
    `lengths`, those of their intervals, are the parameters' units of measure. The attribute
    `names` has the names of the unknowns, `first` (n + q,) the point where the branch begins,
    and `sizes` (n + q,) the units of measure. What is not described is as in
    `KernelEquations`. Raises `InputError` for a period that the other parameters determine,
    or for several forcings.
    """

    def __init__(self, orbit: Orbit, *parameters: str, lengths: Any = 1.0) -> None:
        equations = equations_of(orbit)
        for name in parameters:
            if name not in equations.names:
                raise InputError(f"{orbit.name}: the {name} is determined by the other parameters")
        self.orbit, self.parameters = orbit, parameters
        self._equations, self._base = equations, equations.values
        self.names, self.order = equations.unknowns, equations.order
        self.dwell_names, self.phases = equations.dwell_names, equations.phases
        self.conservative = equations.conservative
        self._places = [equations.names.index(name) for name in (*self.names, *parameters)]
        self.first = self._base[self._places]
        units = np.broadcast_to(lengths, len(parameters))
        self.sizes = np.concatenate([equations.sizes, units])

    @property
    def parameter(self) -> str:
        """The first of the parameters."""
        return self.parameters[0]

    def equations(self, z: np.ndarray, by: int | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Left-hand sides (m,) at one point z (n + q,), and their Jacobian (m, n + q); m >= n.

        Its columns are those of the unknowns and of all parameters, or of the first `by`.
        """
        full, places = self._full(z), self._places[len(self.names) :][:by]
        found = [self._equations.linearised(full, place) for place in places]
        residual, jacobian = found[0]
        more = [other[:, -1:] for _, other in found[1:]]
        return residual, np.concatenate([jacobian, *more], axis=1)

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """Dwell times (k, p) of the phases that take time, affine in z (k, n + q)."""
        return self._equations.dwell(self._full(z))

    def unevenness(self, z: np.ndarray) -> list[np.ndarray]:
        """Differences (N,) of each repeated part of the itinerary from the first, at z (n + q,).

        They are in units of the states' sizes; the list is empty where no part is repeated.
        """
        return self._equations.unevenness(self._full(z))

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """Whether parts that differ at z (n + q,) coincide at `following`, behind a step.

        The step has then met the branch that this one doubles.
        """
        parts = zip(self.unevenness(z), self.unevenness(following), strict=True)
        sizes = [tuple(float(np.abs(part).max()) for part in pair) for pair in parts]
        return any(after < _LEAP * before > _EVEN for before, after in sizes)

    def waves(self, z: np.ndarray) -> list[tuple[np.ndarray, list[PhaseWaves]]]:
        """Boundary functions of all phases at points z (k, n + q), in groups of points.

        Each group is an integer array of the places of its points, and a list of their phases.
        """
        return self._equations.waves(self._full(z))

    def conditions(self, z: np.ndarray) -> np.ndarray:
        """Numbers (k, c) at z (k, n + q) whose signs decide which transitions are taken."""
        return self._equations.conditions(self._full(z))

    @property
    def condition_places(self) -> Sequence[int]:
        """Number of the phase whose end each of these conditions belongs to."""
        return self._equations.condition_places

    def taken(self, conditions: np.ndarray) -> np.ndarray:
        """Number of the transition that each phase takes (k, p), from its conditions (k, c)."""
        return self._equations.taken(conditions)

    def multipliers(self, z: np.ndarray) -> np.ndarray:
        """Multipliers (k, r), complex, over one part at z (k, n + q), without trivial ones.

        Those that are always zero are left out too.
        """
        return self._equations.multipliers(self._full(z))

    def traces(self, z: np.ndarray) -> np.ndarray:
        """Traces (k,) of the Poincare map of the whole period, at z (k, n + q)."""
        return self._equations.traces(self._full(z))

    def admissible(self, z: np.ndarray) -> np.ndarray:
        """Mask (k,) of the points z (k, n + q) that are motions of the real system."""
        return self._equations.admissible(self._full(z))

    def at(self, z: np.ndarray) -> Orbit:
        """The orbit at one point z (n + q,), as a record."""
        return self._equations.orbit_at(self._full(z), self._given(z))

    def motion(self, z: np.ndarray) -> Motion | Trajectory:
        """The motion at one point z (n + q,)."""
        return self._equations.motion_at(self._full(z), self._given(z))

    def _full(self, z: np.ndarray) -> np.ndarray:
        """All numbers of the equations at a point (n + q,), or at many (k, n + q)."""
        full = np.empty((*z.shape[:-1], len(self._base)))
        full[...] = self._base
        full[..., self._places] = z
        return full

    def _given(self, z: np.ndarray) -> dict[str, Value]:
        values = zip(self.parameters, z[len(self.names) :].tolist(), strict=True)
        return {**self.orbit.given, **{name: as_value(value) for name, value in values}}


def check_interval(orbit: Orbit, parameter: str, interval: Any) -> tuple[float, float]:
    """The lower and upper end of an interval of a number that was given for an orbit, checked.

    Refused are an unknown name, and an interval that is empty, leaves the domain or does not
    hold the orbit.
    """
    if not isinstance(parameter, str) or parameter not in orbit.given:
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


def composed_family(
    branch: Branch, place: int, beside: Mapping[str, Any] | None = None
) -> tuple[Orbit, SystemAt]:
    """The orbit at a point of a branch by the tables of its system, and a `SystemAt`.

    The `SystemAt` gives the physical parameters, and the period if it is given, at other values
    of the branch's parameter. Parameters that the orbit leaves open take the values in
    `beside`, or are chosen once for the whole branch. Raises `InputError` if the branch's
    parameter is none of the system's, or if the system does not take its values.
    """
    orbit, name = branch.orbit_at(place), branch.parameter
    problem = orbit.problem
    if name not in (PERIOD, *(table.name for table in problem.parameters)):
        raise InputError(f"{name} is no parameter of {problem.name}: follow one that is")
    orbit = replace(orbit, opened={**orbit.opened, **chosen_parameters(orbit, beside)})

    def system_at(value: float) -> tuple[dict[str, Value], Value | None]:
        moved = replace(orbit, given={**orbit.given, name: as_value(value)})
        return problem.physical(moved, beside).values, problem.period(moved)

    return problem.by_tables(orbit, beside), system_at
