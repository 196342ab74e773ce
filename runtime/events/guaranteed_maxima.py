"""Maxima of functions of time over windows, guaranteed by a bound on the fourth derivative."""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import itemgetter
from typing import Any, NamedTuple, Protocol, Self

import numpy as np

__all__ = ["LONGEST_PHASE", "BoundaryCurve", "CurveSamples", "Maximum", "largest"]

LONGEST_PHASE = 1e5  # radians of the fastest motion; the compiled search's number


class Maximum(NamedTuple):
    """The maximum of a boundary function and the time at which it is attained."""

    value: float
    time: float


class CurveSamples(NamedTuple):
    """Values, times and slopes of a function, numbers or arrays."""

    value: Any
    time: Any
    slope: Any


class BoundaryCurve(Protocol):
    """A boundary function along a phase, which begins at the time 0."""

    @property
    def fastest(self) -> float:
        """Bound on its frequency."""

    def __call__(self, t: float) -> float:
        """Value at a time."""

    def raised(self, by: float) -> Self:
        """The function plus a constant."""

    def rounding(self, duration: float) -> float:
        """Rounding error of its values and maxima over [0, duration]."""

    def rises(self, noise: float) -> bool:
        """Whether it rises at 0 beyond the error of its slope, where it itself errs by noise."""

    def maximum(self, duration: float, floor: float = -math.inf) -> Maximum:
        """Guaranteed maximum over [0, duration], or the floor where it does not exceed that."""


def largest(
    grid: CurveSamples,
    excess: np.ndarray,
    jets: Callable[[int], Callable[[float], tuple[float, float, float]]],
    slack: float,
    floor: float,
) -> Maximum:
    """The maximum of a function over a window, or the floor where it does not exceed that.

    `grid` holds the k + 1 ends of k cells of equal width h; `excess` (k,) is M h^4/144 with M
    a bound on the fourth derivative inside the cell. `jets` gives, for a cell, the function
    from a time inside it to value, slope and curvature. Cells are split until a bound on the
    function over each is at most `slack` above the maximum; after far too many splits that
    bound, which is safe but not attained, becomes the maximum. The time is NaN where the
    floor is the value.
    """
    cells = len(grid.time) - 1
    best = max(
        Maximum(floor, math.nan),
        Maximum(*(float(part[np.argmax(grid.value)]) for part in grid[:2])),
        key=itemgetter(0),
    )
    upper = _upper(
        CurveSamples(*(part[:-1] for part in grid)),
        CurveSamples(*(part[1:] for part in grid)),
        excess,
    )
    splits = 0
    for cell in np.flatnonzero(upper > best.value + slack)[::-1].tolist():
        jet = jets(cell)
        left, right = (CurveSamples(*(float(part[i]) for part in grid)) for i in (cell, cell + 1))
        full, waiting = right.time - left.time, [(left, right, False)]
        while waiting:
            left, right, polished = waiting.pop()
            bend = float(excess[cell]) * ((right.time - left.time) / full) ** 4
            most = _upper(left, right, bend)
            if most <= best.value + slack:
                continue
            middle = 0.5 * (left.time + right.time)
            if splits == 8192 * cells:  # far more than any function needs
                best = Maximum(float(most), middle)  # not attained, but safe
                continue
            # At a maximum both halves go at once; every second split bisects, lest Newton fail.
            polished = not polished and left.slope > 0 > right.slope
            for _ in range(8 if polished else 0):
                _, slope, curvature = jet(middle)
                middle = min(max(middle - slope / (curvature or math.inf), left.time), right.time)
            value, slope, _ = jet(middle)
            split = CurveSamples(value, middle, slope)
            best = max(best, Maximum(value, middle), key=itemgetter(0))
            waiting += [(split, right, polished), (left, split, polished)]
            splits += 1
    return best


def _upper(left: CurveSamples, right: CurveSamples, excess: Any) -> Any:
    """Upper bounds of g on cells, by its cubic Hermite interpolant in Bernstein form.

    It errs by at most M4 h^4/24 u^2 (1-u)^2 where |g^(4)| <= M4: that is M4 h^4/144, the
    excess, times the middle Bernstein polynomial of degree 4.
    """
    width = right.time - left.time
    middle = 0.5 * (left.value + right.value) + width * (left.slope - right.slope) / 6 + excess
    first, last = left.value + 0.25 * width * left.slope, right.value - 0.25 * width * right.slope
    return np.maximum.reduce([left.value, first, middle, last, right.value])
