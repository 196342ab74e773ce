"""How far a state swings along a periodic orbit."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.simulation.observables import observe
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["amplitude_of"]

_POINTS = 4000  # in a period of a Motion: an error of 1e-6 of the amplitude


def amplitude_of(motion: Motion | Trajectory, state: str) -> float:
    """Half of the difference between the largest and the smallest value of a state, in its unit.

    The extremes of a `Trajectory` (of one period) are guaranteed, those of a `Motion` are
    sampled. `state` names a coordinate of the orbit; an unknown one is refused.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> motion = ns.solve("dry-friction/global-stick").motion()
    >>> round(amplitude_of(motion, "z1"), 4)
    2.3313
    """
    if isinstance(motion, Motion):
        names, samples = motion.names, motion.sample(_POINTS).states
        if state not in names:
            raise unknown_name("state", state, names)
        return float(np.ptp(samples[:, names.index(state)])) / 2
    found = observe(motion)
    if state not in found.maxima:
        raise unknown_name("state", state, found.maxima)
    return (found.maxima[state].value - found.minima[state].value) / 2
