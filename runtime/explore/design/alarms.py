"""What can be worst along a branch: the quantity, the conditions, the margins."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.aim import Aim
from nonsmooth.runtime.explore.design.design_points import DesignPoint

__all__ = ["Watch", "alarms_of"]


class Watch(NamedTuple):
    """A place along a branch where something is worst."""

    part: float  # position in the branch's interval, from 0 to 1
    row: int  # number of the alarm that has a minimum there
    bend: float  # its second derivative inside the interval, 0 where the place is fixed


def alarms_of(aim: Aim, member: DesignPoint, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Numbers (m,) that are smaller where an orbit is worse, and derivatives (m,).

    The derivatives are along the branch. The numbers belong to the objective, then to the
    conditions, then to the margins. The branch's parameter is the last of the member's, and
    `length` is that of its interval.
    """
    measured = member.quantities
    values = [-aim.sign * measured.values[aim.quantity] / aim.scale]
    slopes = [-aim.sign * float(measured.slopes[aim.quantity][-1]) * length / aim.scale]
    for condition in aim.conditions:
        sign = -1.0 if condition.relation == "<=" else 1.0
        size = aim.size(condition)
        values.append(sign * (measured.values[condition.quantity] - float(condition.value)) / size)
        slopes.append(sign * float(measured.slopes[condition.quantity][-1]) * length / size)
    margins = {(m.phase, m.boundary): m for m in measured.derivatives.margins}
    for key, unit in aim.margins.items():
        there = margins.get((key.phase, key.boundary))
        values.append(1.0 if there is None else float(there.value) / unit)
        slopes.append(0.0 if there is None else float(there.rates[-1]) * length / unit)
    return np.array(values), np.array(slopes)
