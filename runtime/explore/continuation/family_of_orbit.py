"""The family of orbits that an orbit belongs to, and the interval over which it is followed."""

from __future__ import annotations

import math
from typing import Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.explore.continuation.kernel_family import DerivedCurve
from nonsmooth.runtime.explore.continuation.orbit_family import Curve
from nonsmooth.runtime.explore.continuation.table_family import PERIOD, ComposedCurve
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["check_interval", "curve_of"]


def curve_of(orbit: Orbit, parameter: str, length: float) -> Curve:
    """An orbit as a family over one of the numbers that were given for it."""
    if orbit.problem.kernels is None:
        return ComposedCurve(orbit, parameter, length)
    return DerivedCurve(orbit, parameter, length)


def check_interval(orbit: Orbit, parameter: str, interval: Any) -> tuple[float, float]:
    """Ends of an interval of a number that was given for an orbit; InputError for a wrong one."""
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
    if parameter == PERIOD and orbit.problem.kernels is None and lower <= 0:
        raise InputError(f"period = {lower:g} is not positive")
    return lower, upper
