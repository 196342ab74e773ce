"""What a branch is drawn as unless something else is asked for: a frequency response, ...."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

__all__ = ["forcing_frequencies", "system_of", "usual_quantities"]


def _is_forced(branch: Branch) -> bool:
    """Whether the system of a branch is under harmonic forcing."""
    return bool(structure_of(system_of(branch.orbit)).forcing)


def system_of(orbit: Orbit) -> SystemKernels:
    """Tables and kernels of an orbit's system."""
    return orbit.system


def forcing_frequencies(branch: Branch) -> np.ndarray | None:
    """Angular frequency (k,) of the first forcing, in radians over the unit of time, or None.

    It is None unless the frequency is proportional to the branch's parameter.
    """
    if not _is_forced(branch):
        return None
    orbit, name = branch.orbit, branch.parameter
    kernels = system_of(orbit)
    values = branch.parameter_values
    speeds = []
    for value in (values.min(), values.max()):
        try:
            system = piecewise(kernels, {**orbit.parameters, name: float(value)})
        except InputError:  # an orbit that leaves parameters of its system open
            return None
        (cosine, sine), *_ = system.structure.forcing
        speeds.append(float(system.fields[0, sine, cosine]))
    low, high = values.min(), values.max()
    if low == high or low == 0 or not math.isclose(speeds[0] / low, speeds[1] / high):
        return None
    return np.asarray(values * (speeds[1] / high))


def usual_quantities(branch: Branch) -> tuple[str, ...]:
    """Names of the quantities that a picture of the branch draws by default.

    They are the amplitudes of all coordinates of a forced system, which over the frequency of
    the forcing are the frequency response, and the period of any other system.
    """
    if not _is_forced(branch):
        return ("period",)
    structure = structure_of(system_of(branch.orbit))
    return tuple(f"amplitude_{structure.states[place]}" for place, _ in structure.coordinates)
