"""The motion along a periodic orbit: its state at any time, from the closed-form flows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.values import real_array
from nonsmooth.runtime.simulation.simulate import checked_count

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.orbits.problem import OrbitProblem

MOST_SAMPLES = 10_000_000


@dataclass(frozen=True)
class Samples:
    """Points of a motion, in the order of time.

    Attributes
    ----------
    times : array (count,)
        Each transition occurs twice, as the end of a phase and as the start of the next.
    states : array (count, N)
        Before a transition's reset at its first occurrence, behind it at the second.
    phases : array (count,) of int
        Counted from 0 in every period.
    """

    times: np.ndarray
    states: np.ndarray
    phases: np.ndarray


@dataclass(frozen=True, eq=False, repr=False)
class Motion(Shown):
    """The periodic motion of an orbit as a function of time, in double precision.

    Calling it gives the state at any times; every time is taken modulo the period. At a
    transition that is the state behind it. Everything is nondimensional, and in the
    coordinates of the orbit's equations.

    Attributes
    ----------
    problem : OrbitProblem
        Whose kernels or tables give the flows.
    parameters : array (p,)
        Of the equations.
    starts : array (phases, N)
        State at the start of each phase.
    breaks : array (phases + 1,)
        Start, transitions in between, and end of a period: 0 first, the period last.
    shift : array (N,)
        By which a period moves the states: zero, but along translations of the system.

    Examples
    --------
    >>> from nonsmooth.runtime.orbits.solve import solve
    >>> motion = solve("dry-friction/global-stick").motion()
    >>> motion.names
    ('z1', 'z2', 'v1', 'v2')
    >>> motion([[0, 1, 2], [3, 4, 5]]).shape
    (2, 3, 4)
    >>> motion.configuration(-0.1)
    'stick-slip'
    """

    problem: OrbitProblem
    parameters: np.ndarray
    starts: np.ndarray
    breaks: np.ndarray
    shift: np.ndarray

    @property
    def name(self) -> str:
        """Name of the orbit."""
        return self.problem.name

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the states: positions, then velocities."""
        return self.problem.state_names

    @property
    def configurations(self) -> tuple[str, ...]:
        """Configuration of each phase."""
        return tuple(configuration for configuration, _ in self.problem.itinerary)

    @property
    def period(self) -> float:
        """Sum of the dwell times."""
        return float(self.breaks[-1])

    def __call__(self, times: Any) -> np.ndarray:
        """Return the states (..., N) at times (...); `InputError` if a time is not finite."""
        within = self._within(times)
        phases = self._phase(within)
        states = np.empty((*within.shape, self.starts.shape[1]))
        for phase in np.unique(phases):
            here = phases == phase
            states[here] = self._flow(int(phase), within[here] - self.breaks[phase])
        if self.shift.any():
            turns = np.floor(np.asarray(times, dtype=float) / self.period)
            states += turns[..., None] * self.shift
        return states

    def phase(self, times: Any) -> Any:
        """Give the phase at each of the times.

        Parameters
        ----------
        times : float or array (m,)
            Times in the units of the system, of any period.

        Returns
        -------
        int or array (m,)
            Number of the phase, counted from 0.
        """
        return self._phase(self._within(times))[()]

    def configuration(self, times: Any) -> Any:
        """Give the configuration at each of the times.

        Parameters
        ----------
        times : float or array (m,)
            Times in the units of the system, of any period.

        Returns
        -------
        str or array (m,)
        """
        names = np.array(self.configurations)[self.phase(times)]
        return str(names) if names.ndim == 0 else names

    def sample(self, points_per_period: int = 500, periods: int = 1) -> Samples:
        """Give points for a drawing, evenly spaced inside each phase.

        Parameters
        ----------
        points_per_period : int
            About as many; every phase has at least its start and its end.
        periods : int

        Returns
        -------
        Samples
            Times, states and phases of the points.

        Raises
        ------
        InputError
            For counts that are not positive integers, or far too large.
        """
        for label, count in (("points_per_period", points_per_period), ("periods", periods)):
            checked_count(label, count, 1)
        if points_per_period * periods > MOST_SAMPLES:
            raise InputError(f"more than {MOST_SAMPLES} points")
        times, states, phases = [], [], []
        for phase, (begin, end) in enumerate(zip(self.breaks, self.breaks[1:], strict=False)):
            share = points_per_period * (end - begin) / self.period
            inside = np.linspace(begin, end, max(2, round(share) + 1))
            times.append(inside)
            states.append(self._flow(phase, inside - begin))
            phases.append(np.full(inside.size, phase))
        once = np.concatenate(times)
        # sums one by one, so that a period ends at the very time at which the next starts
        shifts = np.cumsum([0.0, *[self.period] * (periods - 1)])
        return Samples(
            (shifts[:, None] + once).ravel(),
            np.concatenate([np.concatenate(states) + k * self.shift for k in range(periods)]),
            np.tile(np.concatenate(phases), periods),
        )

    def _within(self, times: Any) -> np.ndarray:
        array = real_array("times", times)
        if not np.isfinite(array).all():
            raise InputError("a time is not finite")
        return np.asarray(np.mod(array, self.period))

    def _phase(self, within: np.ndarray) -> np.ndarray:
        return np.searchsorted(self.breaks[1:-1], within, side="right")

    def _flow(self, phase: int, since: np.ndarray) -> np.ndarray:
        return self.problem.flow(self.parameters, phase, since, self.starts[phase])


def orbit_motion(orbit: Orbit) -> Motion:
    """Return the motion along an orbit over one period, in double precision.

    `InputError` is raised if the orbit has not converged.
    """
    if not orbit.converged:
        raise InputError(f"{orbit.name} has no motion: {orbit.message}")
    return Motion(
        orbit.problem,
        np.array([float(x) for x in orbit.parameters.values()]),
        orbit.states.astype(float),
        np.concatenate([[0.0], np.cumsum(orbit.dwell_times.astype(float))]),
        np.array([float(by) for by in orbit.shift.values()]),
    )
