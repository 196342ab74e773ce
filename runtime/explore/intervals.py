"""Along one parameter: where an orbit is admissible, and where it is not determined."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.completion import complete
from nonsmooth.runtime.model.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR, STATUS

_HALVINGS = 60  # more than a double has bits
_APART = 2.0**-40, 2.0**-32  # of a value: so far beyond an end it is looked why it is one


@dataclass(frozen=True)
class Interval:
    """Values of a parameter for which an orbit is admissible."""

    lower: float
    below: str  # what fails below the lower end, empty at an end of the searched range
    upper: float
    above: str  # what fails above the upper end, empty at an end of the searched range


def admissible_intervals(
    orbit: str, parameter: str, lower: float, upper: float, points: int = 4000
) -> tuple[Interval, ...]:
    """Intervals of one parameter, in increasing order, in which an orbit exists and is admissible.

    They are detected on an even grid of `points`; the ends between neighbours that differ are
    bisected to the last bit, each with its reason. An interval between two points of the grid
    is not seen. Open parameters are taken as large as needed. `orbit` is ``system/orbit``; its
    other parameters take the values of the reference point.

    Examples
    --------
    >>> (found,) = admissible_intervals("dry-friction/global-stick", "V", 0.8, 1.3, points=50)
    >>> round(found.lower, 6), round(found.upper, 6)
    (0.805, 1.200186)
    """
    kernels, others, grid = _line(orbit, parameter, lower, upper, points)

    def allowed(values: np.ndarray) -> np.ndarray:
        many: Any = solve(orbit, others | {parameter: values})
        return np.asarray(many.admissible)

    inside = allowed(grid)
    ends = [(float(grid[0]), "")] if inside[0] else []
    for below, above, at_below in _changes(allowed, grid, inside):
        end, beyond = (below, above) if at_below else (above, below)
        ends.append((end, _failure(kernels, others, parameter, end, beyond)))
    if inside[-1]:
        ends.append((float(grid[-1]), ""))
    return tuple(Interval(*low, *high) for low, high in zip(ends[::2], ends[1::2], strict=True))


def singular_values(
    orbit: str, parameter: str, lower: float, upper: float, points: int = 4000
) -> tuple[float, ...]:
    """Values of one parameter, in increasing order, at which an explicit orbit is not determined.

    They are the sign changes of the determinants of the linear equations that give it. The
    arguments are those of `admissible_intervals`.
    """
    kernels, others, grid = _line(orbit, parameter, lower, upper, points)

    def positive(values: np.ndarray, column: Any = slice(None)) -> np.ndarray:
        named = others | {parameter: values}
        arrays = [np.broadcast_to(named[n], values.shape) for n in kernels.parameter_names]
        rows = np.stack(arrays, axis=-1)
        spectrum, _ = kernels.spectrum(rows)
        return np.asarray(kernels.expand(rows, spectrum, None)[1][:, column] > 0)

    found: list[float] = []
    for column, signs in enumerate(positive(grid).T):
        changes = _changes(partial(positive, column=column), grid, signs)
        found += [(below + above) / 2 for below, above, _ in changes]
    return tuple(sorted(found))


def _line(
    orbit: str, parameter: str, lower: float, upper: float, points: int
) -> tuple[OrbitKernels, dict[str, Any], np.ndarray]:
    """Kernels, the other parameters as floats, and a grid inside the range."""
    kernels = load_orbit(orbit)
    point = complete(kernels, {parameter: upper})
    others = {name: float(v) for name, v in point.values.items() if name != parameter}
    step = (upper - lower) / points
    return kernels, others, np.linspace(lower + step / 2, upper - step / 2, points)


def _changes(
    decide: Callable[[np.ndarray], np.ndarray], grid: np.ndarray, decided: np.ndarray
) -> list[tuple[float, float, bool]]:
    """Neighbouring floating-point numbers between which a decision changes, and that at the lower.

    `decided` is the decision at the grid.
    """
    places = np.flatnonzero(decided[1:] != decided[:-1])
    below, above, at_below = grid[places], grid[places + 1], decided[places]
    for _ in range(_HALVINGS if len(places) else 0):
        middle = (below + above) / 2
        same = decide(middle) == at_below
        below, above = np.where(same, middle, below), np.where(same, above, middle)
    return list(zip(below.tolist(), above.tolist(), at_below.tolist(), strict=True))


def _failure(
    kernels: OrbitKernels, others: Mapping[str, Any], parameter: str, inside: float, beyond: float
) -> str:
    """Text of what fails beyond an end: at the next number, or where it is more than rounding."""
    for apart in (0.0, *_APART):
        value = beyond + np.sign(beyond - inside) * apart * max(abs(beyond), abs(inside))
        point = {**others, parameter: float(value)}
        try:
            orbit = solve_kernels(kernels, point, throw=False)
            if orbit.status == SINGULAR:
                return "the equations are singular"
            if orbit.status != CONVERGED:
                return STATUS[orbit.status].partition(":")[0]
            violations = orbit.admissibility.violations
        except InputError:  # beyond the domain, or too fast to be judged
            break
        for first in violations[:1]:
            return f"{first.boundary} is crossed in {first.configuration} at t = {first.time:.6g}"
    return "the margin is within the rounding"
