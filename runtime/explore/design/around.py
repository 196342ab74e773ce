"""Quantities along one parameter around the end of a design."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.explore.design.design_points import Beyond, DesignPoints
from nonsmooth.runtime.explore.design.optimum import Design
from nonsmooth.runtime.explore.design.quantities import MULTIPLIER
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["along", "along_branch"]


def along(design: Design, parameter: str, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Values (count,) of a parameter over its bounds, and the quantities (count, m) there.

    The parameter is one that varied; the others are as where the design ended. The quantities
    are NaN where the branch does not lead.
    """
    bounds = design.bounds[design.parameters.index(parameter)]
    return _around(design, design.orbit, parameter, bounds, count)


def along_branch(design: Design, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Values (count,) of the branch's parameter, and quantities (count, m) before and after.

    The design needs `worst_over`; the orbits are those where it began and where it ended.
    """
    ((parameter, interval),) = design.worst_over.items()
    values, before = _around(design, design.start, parameter, np.array(interval), count)
    return values, before, _around(design, design.orbit, parameter, np.array(interval), count)[1]


def _around(
    design: Design, orbit: Orbit, parameter: str, interval: np.ndarray, count: int
) -> tuple[np.ndarray, np.ndarray]:
    wanted = [name for name in design.quantities if name != MULTIPLIER]
    bounds = interval[None]
    points = DesignPoints(orbit, (parameter,), bounds, wanted, rough=wanted, admissible=False)
    begin = points.visited[0].place[0]
    parts = np.linspace(0.0, 1.0, count)
    found = np.full((count, len(design.quantities)), np.nan)
    sides = np.flatnonzero(parts >= begin), np.flatnonzero(parts < begin)[::-1]
    goals = [(c.quantity, float(c.value)) for c in design.conditions]
    for side in sides:
        for each in side:
            try:
                point = points.at(parts[each : each + 1])
            except Beyond:
                break
            found[each] = [
                point.quantities.quantity(name, dict(goals).get(name)) for name in design.quantities
            ]
    return bounds[0, 0] + parts * points.lengths[0], found
