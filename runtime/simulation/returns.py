"""The Poincaré map by simulation: an independent check of every Jacobian that is derived."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.values import real_array
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.modes.natural_units import fall_rates, natural_units
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.simulation.simulate import follow

_FIRST, _MOST = 64, 65_536  # transitions that a return may take
_STEP = 1e-6  # of a finite difference, relative to the states, in their natural units


class Return(NamedTuple):
    """A return to the section: the state there, how long it took, and through which phases.

    Attributes
    ----------
    state : array (N,)
    time : float
    configurations : tuple of str
    """

    state: np.ndarray
    time: float
    configurations: tuple[str, ...]


@dataclass(frozen=True, eq=False, repr=False)
class PoincareMap(Shown):
    """From one passage of a transition to the next: states behind it, in physical coordinates.

    Attributes
    ----------
    system : PiecewiseLinear
    source, boundary, target : int
        The transition: leaving `source` by its `boundary` for `target`.
    transition : TransitionShape

    Examples
    --------
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    >>> impact = poincare_map("rigid-stop", data, ("free", "first-reaches-stop", "free"))
    >>> impact.basis.shape
    (4, 3)
    """

    system: PiecewiseLinear
    source: int
    boundary: int
    target: int
    transition: TransitionShape

    def __call__(self, state: Any) -> np.ndarray:
        """State (N,) at the next passage."""
        return self.next_return(state).state

    def next_return(self, state: Any) -> Return:
        """Find the next passage of a motion that starts behind the transition.

        Parameters
        ----------
        state : array (N,)
            State behind the transition, in the units of the system.

        Returns
        -------
        Return
            State and time of that passage.

        Raises
        ------
        InputError
            For a state of the wrong size or not finite.
        NoConvergence
            If the motion does not pass the transition again.
        """
        start = self._checked(state)
        names = self.system.structure.configurations
        most = _FIRST
        while most <= _MOST:
            run = follow(self.system, start, self.target, transitions=most)
            passed = (
                (run.configurations[1:] == self.target)
                & (run.configurations[:-1] == self.source)
                & (run.sets[1:] == 1 << self.boundary)
            )
            if passed.any():
                entry = 1 + int(np.argmax(passed))
                through = tuple(names[c] for c in run.configurations[:entry])
                return Return(run.states[entry], float(run.times[entry]), through)
            if len(run.times) <= most:
                break
            most *= 4
        raise NoConvergence(f"the motion does not come back within {most} transitions")

    def _checked(self, state: Any) -> np.ndarray:
        start = real_array("state", state)
        if start.shape != (len(self.system.structure.states),) or not np.isfinite(start).all():
            raise InputError("the state is no row of as many finite numbers as the system has")
        return start

    @cached_property
    def basis(self) -> np.ndarray:
        """Orthonormal directions (N, d) in which a state behind the transition can move."""
        return np.linalg.qr(self._directions)[0]

    @cached_property
    def _units(self) -> np.ndarray:
        """Natural units (N,) of the states before the transition."""
        fields = self.system.fields[None, self.source]
        return natural_units(fields, fall_rates(fields, self.system.rows[None])).states[0, :-1]

    @cached_property
    def _directions(self) -> np.ndarray:
        """Directions (N, d) that span the same space as `basis`, orthonormal in natural units."""
        from scipy.linalg import null_space, orth

        structure, units = self.system.structure, self._units
        located = structure.boundaries[self.source][self.boundary].row
        fixed = self.system.rows[[*structure.constraints[self.source], located], :-1] * units
        before = null_space(fixed / np.abs(fixed).max(axis=1, keepdims=True))
        reset = self.system.resets[self.transition.reset][:, :-1] * units / units[:, None]
        return np.asarray(orth(reset @ before) * units[:, None])

    def jacobian(self, state: Any, step: float = _STEP) -> np.ndarray:
        """Differentiate the map in the coordinates of `basis` by central differences.

        The map is affine in the state but for the times of the transitions, so the error is
        of the order step^2.

        Parameters
        ----------
        state : array (N,)
            State behind the transition, in the units of the system.
        step : float
            Half the distance of the two points of a difference, in units of the states.

        Returns
        -------
        array (d, d)
            With an error of the order step^2.
        """
        start = self._checked(state)
        largest = float(np.abs(np.stack([start, self(start)]) / self._units).max())
        size = step * (largest or 1.0)
        columns = [
            (self(start + size * direction) - self(start - size * direction)) / (2 * size)
            for direction in self._directions.T
        ]
        basis, turned = np.linalg.qr(self._directions)
        return np.asarray(basis.T @ np.array(columns).T @ np.linalg.inv(turned))


def poincare_map(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    section: tuple[str, str, str],
) -> PoincareMap:
    """Give the map from one passage of a transition to the next, by simulation.

    Parameters
    ----------
    system : str or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters.
    section : (configuration, boundary, configuration)
        The transition: leaving the first by the boundary for the second.

    Returns
    -------
    PoincareMap

    Raises
    ------
    InputError
        For wrong names or values, or a transition that the system does not have.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    >>> impact = ns.poincare_map("rigid-stop", data, ("free", "first-reaches-stop", "free"))
    >>> impact.basis.shape
    (4, 3)
    """
    point = piecewise(system, parameters)
    structure = point.structure
    structure.check_listed("a Poincaré map")
    source, target = structure.configuration(section[0]), structure.configuration(section[2])
    boundary = structure.boundary(source, section[1])
    for transition in structure.transitions_to(source, frozenset({boundary}), target):
        return PoincareMap(point, source, boundary, target, transition)
    raise InputError(f"no transition leads from {section[0]} by {section[1]} to {section[2]}")
