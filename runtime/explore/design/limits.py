"""Which conditions and bounds act at an optimum, and how strongly."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.design.design_points import DesignPoint
from nonsmooth.runtime.explore.design.largest import corner_of
from nonsmooth.runtime.explore.design.objective import Aim, Trial
from nonsmooth.runtime.explore.design.optimum import ActiveLimit

__all__ = ["Optimality", "bounds_met", "optimality"]

_ACTIVE, _ACTIVE_BOUND = 1e-6, 1e-7


class Optimality(NamedTuple):
    """The conditions of Karush, Kuhn and Tucker at an orbit."""

    active: tuple[ActiveLimit, ...]
    residual: float  # remainder of the gradient, in units of the quantity and of the bounds
    corner: str  # what happens where the quantity has no derivative, else empty
    worst_at: tuple[DesignPoint, ...] = ()  # orbits of a branch at which the quantity is worst


def optimality(
    aim: Aim,
    point: Trial,
    names: tuple[str, ...],
    bounds: np.ndarray,
    where: Callable[[DesignPoint], str] = lambda _: "",
) -> Optimality:
    """The multipliers that leave as little as possible of the gradient at a trial.

    They solve a linear least-squares problem with bounds, whatever optimiser was used. `bounds`
    (q, 2) are those of the parameters `names`; `where` puts an orbit's place on a branch into
    words.
    """
    from scipy.optimize import lsq_linear

    level = aim.variables(point)[-1]
    size = len(names) + aim.levelled
    texts, slopes, units, free = [], [], [], []
    for member, condition in product(point.members, aim.conditions):
        rows, grown = aim.condition_rows(member, condition), aim.relaxing(member, condition)
        for value, slope, unit in zip(*rows, grown.tolist(), strict=True):
            if condition.relation == "=" or abs(value) <= _ACTIVE:
                texts.append(condition.text + where(member))
                slopes.append(slope)
                units.append(unit)
                free.append(condition.relation == "=")
    for member in point.members if aim.margins else ():
        margins = aim.margin_rows(member)
        for (key, unit), value, slope in zip(aim.margins.items(), *margins, strict=True):
            if abs(value) <= _ACTIVE:
                away = f"{key.boundary} stays away in phase {key.phase + 1}"
                texts.append(away + where(member))
                slopes.append(slope)
                units.append(1 / unit)
                free.append(False)
    for place, sign, text in _sides(point, names, bounds):
        texts.append(text)
        slopes.append(sign * np.eye(size)[place])
        units.append(1 / float(aim.lengths[place]))
        free.append(False)
    told, corner = len(texts), ""
    worst_at: list[DesignPoint] = []
    for member in point.members if aim.levelled else ():
        levels = aim.level_rows(member, level)
        near = np.abs(levels.values) <= _ACTIVE
        if not near.any():
            continue
        worst_at.append(member)
        corner = corner or corner_of(
            member.quantities.derivatives,
            aim.quantity,
            near,
            levels.slopes,
            aim.scale / aim.lengths,
        )
        slopes.extend(levels.slopes[near])
        free.extend([False] * int(near.sum()))
    if len(worst_at) > 1:
        corner = "; ".join(
            [f"as bad at {len(worst_at)} places of the branch", *filter(None, [corner])]
        )
    gradient = aim.slope(point)
    if not slopes:
        return Optimality((), float(np.abs(gradient).max()), corner, tuple(worst_at))
    lower = np.where(free, -np.inf, 0.0)
    found = lsq_linear(np.array(slopes).T, gradient, (lower, np.full(len(slopes), np.inf)))
    left = float(np.abs(found.fun).max())
    factors: dict[str, float] = {}  # a conjugate pair meets one condition twice
    for text, factor, unit in zip(texts, found.x[:told], units, strict=True):
        factors[text] = factors.get(text, 0.0) + float(factor) * aim.scale * unit
    limits = tuple(ActiveLimit(text=text, multiplier=each) for text, each in factors.items())
    return Optimality(limits, left, corner, tuple(worst_at))


def bounds_met(point: Trial, names: Sequence[str], bounds: np.ndarray) -> tuple[ActiveLimit, ...]:
    """The bounds at which a trial lies, with zero multipliers, where nothing is optimised."""
    return tuple(
        ActiveLimit(text=text, multiplier=0.0) for *_, text in _sides(point, names, bounds)
    )


def _sides(
    point: Trial, names: Sequence[str], bounds: np.ndarray
) -> Iterator[tuple[int, float, str]]:
    """Parameters at a bound, with the direction inwards and the bound in words."""
    for place, name in enumerate(names):
        for side, (sign, relation) in enumerate(((1.0, ">="), (-1.0, "<="))):
            if abs(point.place[place] - side) <= _ACTIVE_BOUND:
                yield place, sign, f"{name}{relation}{float(bounds[place, side])!r}"
