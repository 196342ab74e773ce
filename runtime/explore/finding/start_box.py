"""The box in which the starts of motions are drawn."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import by_name
from nonsmooth.runtime.model.piecewise import PiecewiseLinear

__all__ = ["start_box"]


def start_box(
    system: PiecewiseLinear, given: Mapping[str, tuple[float, float]] | None = None
) -> np.ndarray:
    """Bounds (N, 2) between which starts are drawn, the same in all units.

    For each state they are twice the largest size at which a boundary or a constraint lies, on
    both sides. For a state without one, they are twice the size at which the equations of
    motion balance it with the others, the loads and the forcings, at the rate of the system.
    `given` replaces the bounds of some states; unknown names and empty intervals are refused.
    """
    structure = system.structure
    rows = system.rows[list(structure.watched)]
    with np.errstate(divide="ignore", invalid="ignore"):
        sizes = np.abs(rows[:, -1:] / rows[:, :-1])
    sizes[~np.isfinite(sizes)] = 0.0
    largest = sizes.max(axis=0, initial=0.0)
    forced = list(structure.forced)
    largest[forced] = 1.0
    largest = _balanced(np.abs(system.fields), largest)
    limits = np.stack([-2 * largest, 2 * largest], axis=1)
    limits[forced] = -1.0, 1.0  # of starts on a circle
    for name, bounds in by_name("box", given).items():
        if name not in structure.states:
            raise unknown_name("state", str(name), structure.states)
        try:
            low, high = map(float, bounds)
        except (TypeError, ValueError):
            raise InputError(f"box of {name}: {bounds!r} is no pair of numbers") from None
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"box of {name}: {low!r} to {high!r} is no interval")
        limits[structure.states.index(name)] = low, high
    return limits


def _balanced(fields: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Sizes (N,) of states: the known ones, and sizes that balance these for states of size 0.

    In a time 1 / rate a state moves by no less than its own size under those that are known,
    and moves those by no less than theirs. Fields (configurations, N, N + 1) are absolute.
    """
    couplings = fields.max(axis=0)
    sizes = np.append(known, 1.0)  # the last one is the constant's
    rate = _rate(fields, sizes)
    coupled = couplings[:, :-1] > 0
    while rate > 0:
        moving = np.zeros(coupled.shape)
        with np.errstate(over="ignore", invalid="ignore"):
            moved = couplings @ sizes / rate
            np.divide(rate * sizes[:-1, None], couplings[:, :-1], out=moving, where=coupled)
            found = np.maximum(moved, moving.max(axis=0))
        found[(sizes[:-1] > 0) | ~np.isfinite(found)] = 0.0
        if not found.any():
            break
        sizes[:-1] += found
    return np.where(sizes[:-1] > 0, sizes[:-1], 1.0)


def _rate(fields: np.ndarray, sizes: np.ndarray) -> float:
    """The geometric mean over the configurations of the rate of the fastest motion in each.

    That is an eigenvalue, or the fall under a load through the size of a state.
    """
    rates = []
    for field in fields:
        with np.errstate(over="ignore", invalid="ignore"):
            fall = field[:, :-1] @ field[:, -1] / np.where(sizes[:-1] > 0, sizes[:-1], np.inf)
        around = np.abs(np.linalg.eigvals(field[:, :-1])).max()
        rates.append(max(float(around), float(fall.max()) ** 0.5))
    moving = [rate for rate in rates if 0 < rate < np.inf]
    return float(np.exp(np.mean(np.log(moving)))) if moving else 0.0
