"""Along one parameter: where an orbit is admissible, and where it is not determined."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.completion import complete
from nonsmooth.runtime.model.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.orbits.one_point import solve_kernels
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR, STATUS

__all__ = ["Interval", "admissible_intervals", "singular_values"]

_HALVINGS = 60  # more than a double has bits
_APART = 2.0**-40, 2.0**-32  # of a value: so far beyond an end it is looked why it is one


@dataclass(frozen=True)
class Interval:
    """Values of a parameter for which an orbit is admissible."""

    lower: float
    upper: float
    below: str  # what fails below the lower end, empty at an end of the searched range
    above: str  # what fails above the upper end, empty at an end of the searched range


def admissible_intervals(
    orbit: str,
    parameter: str,
    lower: float,
    upper: float,
    parameters: Mapping[str, object] | None = None,
    *,
    points: int = 4000,
) -> tuple[Interval, ...]:
    """Intervals of one parameter, in increasing order, in which an orbit exists and is admissible.

    They are detected on an even grid of `points`; the ends between neighbours that differ are
    bisected to the last bit, each with its reason. An interval between two points of the grid
    is not seen. Open parameters are taken as large as needed. `orbit` is ``system/orbit``;
    parameters that are not given take the values of the reference point. Refused are wrong
    names, an empty range, and too few points.

    Examples
    --------
    >>> (found,) = admissible_intervals("dry-friction/global-stick", "V", 0.8, 1.3, points=50)
    >>> round(found.lower, 6), round(found.upper, 6)
    (0.805, 1.200186)
    """
    kernels, others, grid = _line(orbit, parameter, lower, upper, parameters, points)

    def allowed(values: np.ndarray) -> np.ndarray:
        many: Any = solve(orbit, others | {parameter: values})
        return np.asarray(many.admissible)

    inside = allowed(grid)
    changes = np.flatnonzero(inside[1:] != inside[:-1])
    ends = _bisected(allowed, grid[changes], grid[changes + 1], inside[changes])
    starts = [grid[0]] if inside[0] else []
    stops = [grid[-1]] if inside[-1] else []
    for place, (below, above) in zip(changes, ends, strict=True):
        (stops if inside[place] else starts).append(below if inside[place] else above)
    reasons = {
        (below if inside[place] else above): _failure(
            kernels, others, parameter, *((below, above) if inside[place] else (above, below))
        )
        for place, (below, above) in zip(changes, ends, strict=True)
    }
    return tuple(
        Interval(float(a), float(b), reasons.get(a, ""), reasons.get(b, ""))
        for a, b in zip(sorted(starts), sorted(stops), strict=True)
    )


def singular_values(
    orbit: str,
    parameter: str,
    lower: float,
    upper: float,
    parameters: Mapping[str, object] | None = None,
    *,
    points: int = 4000,
) -> tuple[float, ...]:
    """Values of one parameter, in increasing order, at which an explicit orbit is not determined.

    They are the sign changes of the determinants of the linear equations that give it. The
    arguments are those of `admissible_intervals`; an orbit that is not explicit is refused too.
    """
    kernels, others, grid = _line(orbit, parameter, lower, upper, parameters, points)
    if kernels.reduced:
        raise InputError(f"{orbit} is not explicit: its unknowns {', '.join(kernels.reduced)} move")

    def determinants(values: np.ndarray) -> np.ndarray:
        named = others | {parameter: values}
        arrays = [np.broadcast_to(named[n], values.shape) for n in kernels.parameter_names]
        rows = np.stack(arrays, axis=-1)
        spectrum, _ = kernels.spectrum(rows)
        return np.asarray(kernels.expand(rows, spectrum, None)[1])

    found: list[float] = []
    for column in range(determinants(grid).shape[-1]):

        def positive(values: np.ndarray, column: int = column) -> np.ndarray:
            return np.asarray(determinants(values)[:, column] > 0)

        signs = positive(grid)
        changes = np.flatnonzero(signs[1:] != signs[:-1])
        ends = _bisected(positive, grid[changes], grid[changes + 1], signs[changes])
        found += [float((below + above) / 2) for below, above in ends]
    return tuple(sorted(found))


def _line(
    orbit: str,
    parameter: str,
    lower: float,
    upper: float,
    parameters: Mapping[str, object] | None,
    points: int,
) -> tuple[OrbitKernels, dict[str, Any], np.ndarray]:
    """Kernels, the other parameters as floats, and a grid inside the range."""
    kernels = load_orbit(orbit)
    if not kernels.derived:
        raise InputError(f"{kernels.name} is composed: intervals need equations that are derived")
    if parameter not in kernels.parameter_names:
        raise unknown_name("parameter", parameter, kernels.parameter_names)
    if not np.isfinite([lower, upper]).all() or not lower < upper:
        raise InputError(f"the range of {parameter}, {lower} to {upper}, is empty")
    if points < 2:
        raise InputError(f"points = {points}: a grid has two at least")
    point = complete(kernels, {**(parameters or {}), parameter: upper})
    others = {name: float(v) for name, v in point.values.items() if name != parameter}
    step = (upper - lower) / points
    return kernels, others, np.linspace(lower + step / 2, upper - step / 2, points)


def _bisected(
    decide: Callable[[np.ndarray], np.ndarray],
    below: np.ndarray,
    above: np.ndarray,
    at_below: np.ndarray,
) -> list[tuple[float, float]]:
    """Pairs of neighbouring floating-point numbers between which a decision changes."""
    for _ in range(_HALVINGS if len(below) else 0):
        middle = (below + above) / 2
        same = decide(middle) == at_below
        below, above = np.where(same, middle, below), np.where(same, above, middle)
    return list(zip(below.tolist(), above.tolist(), strict=True))


def _failure(
    kernels: OrbitKernels, others: Mapping[str, Any], parameter: str, inside: float, beyond: float
) -> str:
    """Text of what fails beyond an end: at the next number, or where it is more than rounding."""
    for apart in (0.0, *_APART):
        value = beyond + np.sign(beyond - inside) * apart * max(abs(beyond), abs(inside))
        try:
            reason = _failure_at(kernels, others, parameter, float(value))
        except InputError:  # beyond the domain
            break
        if reason:
            return reason
    return "the margin is within the rounding"


def _failure_at(
    kernels: OrbitKernels, others: Mapping[str, Any], parameter: str, value: float
) -> str:
    """Text of what fails at a point; empty where that is within the rounding."""
    orbit = solve_kernels(kernels, {**others, parameter: value}, throw=False)
    if orbit.status == SINGULAR:
        return "the equations are singular"
    if orbit.status != CONVERGED:
        return STATUS[orbit.status].partition(":")[0]
    violations = orbit.admissibility.violations
    if not violations:
        return ""
    first = violations[0]
    return f"{first.boundary} is crossed in {first.configuration} at t = {first.time:.6g}"
