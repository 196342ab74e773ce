"""Newton's method on an orbit's equations: reduced and batched, or full and exchanged."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.linalg.lapack import dgetrf, dgetri

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels

__all__ = [
    "CONVERGED",
    "INVALID",
    "NEGATIVE",
    "OUTSIDE",
    "SINGULAR",
    "STALLED",
    "Solved",
    "solve_full",
    "solve_reduced",
]

# the compiled solver's numbers
CONVERGED, STALLED, INVALID, NEGATIVE = 0, 1, 2, 3
OUTSIDE = 4  # only of exchanged equations
SINGULAR = 5
TOLERANCE = 1e-9  # of the last step, which Newton's method squares
MOST_ITERATIONS = 32
DETERMINED = 0.1  # error of an unknown x, in units of max(1, |x|), beyond which nothing is known
MOST_CONDITION = 1e12  # condition number beyond which a choice of unknowns is refused
LEAST_DETERMINANT = 1e-12  # in units of its bound; the compiled solver's number
_EPSILON = float(np.finfo(float).eps)


class Solved(NamedTuple):
    """Result of a solver: unknowns (..., n), then arrays (...)."""

    unknowns: Any
    trace: Any
    residual: Any
    iterations: Any
    status: Any


def solve_reduced(kernels: OrbitKernels, parameters: Any, guess: Any) -> Solved:
    """Newton's method on the reduced equations, elementwise over leading axes.

    Parameters
    ----------
    kernels : OrbitKernels
    parameters : array (..., p)
    guess : array (..., m)
        Start of the reduced unknowns; of none where all is explicit.

    Returns
    -------
    Solved
        With the compiled solver's meaning of `status`.
    """
    if kernels.solver is not None:
        with np.errstate(all="ignore"):
            return Solved(*kernels.solver(parameters, *([guess] if kernels.reduced else [])))
    parameters, guess = np.asarray(parameters, float), np.asarray(guess, float)
    lead = np.broadcast_shapes(parameters.shape[:-1], guess.shape[:-1])
    count = math.prod(lead)
    flat, x = (
        np.broadcast_to(a, (*lead, a.shape[-1])).reshape(count, a.shape[-1])
        for a in (parameters, guess)
    )
    with np.errstate(all="ignore"):
        solved = _solve_flat(kernels, flat, x.copy())
    return Solved(
        solved.unknowns.reshape(*lead, -1), *(array.reshape(lead)[()] for array in solved[1:])
    )


def _solve_flat(kernels: OrbitKernels, parameters: np.ndarray, x: np.ndarray) -> Solved:
    """The compiled solver's algorithm on NumPy; converged points are left alone."""
    spectrum, _ = kernels.spectrum(parameters)
    timed = np.array([name in kernels.dwell_times for name in kernels.reduced])
    taken = np.zeros(len(x), dtype=np.int32)
    running = np.arange(len(x) if kernels.reduced else 0)
    for _ in range(MOST_ITERATIONS):
        if not len(running):
            break
        here = x[running]
        residual, jacobian = kernels.evaluate(
            "reduced", parameters[running], spectrum[running], here
        )
        step = _steps(jacobian, residual)
        wanted = here - step
        limited = np.where(wanted < 0.25 * here, 0.25 * here, wanted)
        limited = np.where(limited > 4.0 * here, 4.0 * here, limited)
        following = np.where(timed, limited, wanted)
        x[running] = following
        taken[running] += 1
        size = np.maximum(np.abs(following), 1.0)
        running = running[~(np.abs(wanted - here) <= TOLERANCE * size).all(axis=-1)]
    residual = np.zeros((len(x), 1))
    if kernels.reduced:
        residual, _ = kernels.evaluate("reduced", parameters, spectrum, x)
    unknowns, determinants = kernels.expand(parameters, spectrum, x)
    trace = kernels.evaluate("trace", parameters, spectrum, unknowns)
    status = np.full(len(x), CONVERGED, dtype=np.int32)
    values = dict(zip(kernels.parameter_names, parameters.T, strict=True))
    durations = kernels.durations(values | dict(zip(kernels.unknowns, unknowns.T, strict=True)))
    for name, duration in durations.items():
        if name not in kernels.table["vanishing"]:
            status[duration <= 0] = NEGATIVE
    status[running] = STALLED
    status[~(np.isfinite(unknowns).all(axis=-1) & np.isfinite(trace))] = INVALID
    status[(np.abs(determinants) <= LEAST_DETERMINANT).any(axis=-1)] = SINGULAR
    return Solved(unknowns, trace, np.abs(residual).max(axis=-1), taken, status)


def _steps(jacobian: np.ndarray, residual: np.ndarray) -> np.ndarray:
    """Newton steps; NaN where a Jacobian is singular, so that its point alone is lost."""
    sound = np.isfinite(jacobian).all(axis=(-2, -1)) & (np.linalg.det(jacobian) != 0)
    steps = np.full_like(residual, np.nan)
    if sound.any():
        steps[sound] = np.linalg.solve(jacobian[sound], residual[sound][..., None])[..., 0]
    return steps


class Full(NamedTuple):
    """Values of all parameters and unknowns, and how the full equations were solved."""

    values: dict[str, float]
    residual: float
    iterations: int
    status: int
    error: float


def solve_full(kernels: OrbitKernels, values: dict[str, float], solved_for: Sequence[str]) -> Full:
    """Damped Newton's method on the full equations, for any choice of what is unknown.

    Parameters
    ----------
    kernels : OrbitKernels
    values : dict of str to float
        All parameters and unknowns: those in `solved_for` are a guess, the rest stay.
    solved_for : sequence of str
        As many names as there are equations.

    Raises
    ------
    InputError
        If the equations do not determine these names: the Jacobian's condition number is
        beyond 1e12, or no digit of a solution is sure (as where the only one is zero).
    """
    names = (*kernels.unknowns, *kernels.parameter_names)
    places = [names.index(name) for name in solved_for]
    timed = np.array([name in kernels.dwell_times for name in solved_for])
    count = len(kernels.unknowns)
    x = np.array([values[name] for name in names], dtype=float)
    status, iterations, residual = STALLED, 0, np.full(count, np.nan)
    jacobian = np.full((count, count), np.nan)
    with np.errstate(all="ignore"):
        while iterations < MOST_ITERATIONS:
            iterations += 1
            equations = equations_at(kernels, x)
            residual, jacobian = equations.residual, equations.jacobian[:, places]
            if not (np.isfinite(residual).all() and np.isfinite(jacobian).all()):
                status = INVALID
                break
            if np.linalg.det(jacobian) == 0:
                break
            step = np.linalg.solve(jacobian, residual)
            here = x[places]
            fraction = _fraction(here, step, timed)
            x[places] = here - fraction * step
            if fraction == 1 and (abs(step) <= TOLERANCE * np.maximum(abs(here), 1)).all():
                status = CONVERGED
                break
    if status != INVALID and (condition := condition_number(jacobian)) > MOST_CONDITION:
        raise _undetermined(solved_for, condition)
    error = np.inf
    if status == CONVERGED:
        equations = equations_at(kernels, x)
        residual, jacobian = equations.residual, equations.jacobian
        error = error_bound(kernels, x, places, equations)
        if not error < DETERMINED:
            size = np.maximum(np.abs(x[places]), 1)
            raise _undetermined(solved_for, float(np.linalg.cond(jacobian[:, places] * size)))
        durations = kernels.durations(dict(zip(names, x, strict=True)))
        if any(durations[n] <= 0 for n in durations if n not in kernels.table["vanishing"]):
            status = NEGATIVE
    found = {name: float(value) for name, value in zip(names, x, strict=True)}
    return Full(found, float(np.abs(residual).max()), iterations, status, error)


def _undetermined(solved_for: Sequence[str], condition: float) -> InputError:
    return InputError(
        f"the equations do not determine {', '.join(solved_for)} here:"
        f" condition number {condition:.1e}"
    )


class Equations(NamedTuple):
    """Residual (n), Jacobian (n, n + p) by unknowns, then parameters, and the spectrum."""

    residual: np.ndarray
    jacobian: np.ndarray
    spectrum: np.ndarray


def equations_at(kernels: OrbitKernels, x: np.ndarray) -> Equations:
    """Evaluate the full equations at unknowns, then parameters (n + p,)."""
    unknowns, parameters = x[: len(kernels.unknowns)], x[len(kernels.unknowns) :]
    spectrum, derivatives = kernels.spectrum(parameters)
    residual, by_unknowns = kernels.evaluate(
        "residual_and_jacobian", parameters, spectrum, unknowns
    )
    by_parameters = kernels.evaluate(
        "parameter_jacobian", parameters, spectrum, derivatives, unknowns
    )
    jacobian = np.concatenate([by_unknowns, by_parameters], axis=1)
    return Equations(residual, jacobian, spectrum)


def error_bound(
    kernels: OrbitKernels,
    x: np.ndarray,
    places: Sequence[int],
    equations: Equations,
) -> float:
    """Bound on the error of the numbers at some places of x, in units of max(1, |x|).

    By J^-1, from the residual and the rounding of all that enters the equations: parameters
    and unknowns, and the states along the orbit, of which they are differences.

    Parameters
    ----------
    kernels : OrbitKernels
    x : array (n + p,)
    places : sequence of int
    equations : Equations
        Those at x.
    """
    residual, jacobian, spectrum = equations
    unknowns, parameters = x[: len(kernels.unknowns)], x[len(kernels.unknowns) :]
    states = kernels.evaluate("states", parameters, spectrum, unknowns)
    scale, size = np.maximum(np.abs(x[places]), 1), np.abs(x)
    size[places] = scale
    rounding = np.abs(jacobian) @ size + np.abs(states).max()
    noise = np.abs(residual) + 4 * _EPSILON * rounding
    with np.errstate(all="ignore"):
        factors, pivots, singular = dgetrf(jacobian[:, places])
        if singular:
            return math.inf
        inverse, _ = dgetri(factors, pivots)
        error = np.abs(inverse) @ noise / scale
    worst = float(error.max())
    return worst if math.isfinite(worst) else math.inf


def condition_number(jacobian: np.ndarray) -> float:
    """Condition number after scaling the rows, and then the columns, to unit size."""
    rows = np.abs(jacobian).max(axis=1, keepdims=True)
    scaled = jacobian / np.where(rows > 0, rows, 1)
    columns = np.abs(scaled).max(axis=0, keepdims=True)
    scaled = scaled / np.where(columns > 0, columns, 1)
    if not np.isfinite(scaled).all():
        return np.inf
    return float(np.linalg.cond(scaled))


def _fraction(here: np.ndarray, step: np.ndarray, timed: np.ndarray) -> float:
    """Largest part of a step after which no dwell time has lost three quarters of itself."""
    falling = timed & (here > 0) & (step > 0.75 * here)
    return float(np.min(0.75 * here[falling] / step[falling], initial=1.0))
