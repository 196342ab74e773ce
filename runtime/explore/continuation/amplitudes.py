"""How far a state swings along a periodic orbit."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.observables import observe
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["amplitude_of"]

_POINTS = 4000  # in a period of a derived orbit: an error of 1e-6 of the amplitude


def amplitude_of(orbit: Orbit | Trajectory, state: str) -> float:
    """Half of the difference between the largest and the smallest value of a state.

    Parameters
    ----------
    orbit : Orbit, or Trajectory of one period
        Of the latter the extremes are guaranteed, of the former they are sampled.
    state : str
        In the coordinates of the orbit.

    Raises
    ------
    InputError
        For an unknown state.
    """
    if isinstance(orbit, Orbit):
        motion = orbit.motion()
        names, samples = motion.names, motion.sample(_POINTS).states
        if state not in names:
            raise unknown_name("state", state, names)
        return float(np.ptp(samples[:, names.index(state)])) / 2
    found = observe(orbit)
    if state not in found.maxima:
        raise unknown_name("state", state, found.maxima)
    return (found.maxima[state].value - found.minima[state].value) / 2
