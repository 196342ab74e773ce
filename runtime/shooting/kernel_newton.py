"""Newton's method on the equations of an orbit's kernels: reduced and batched, or full.

Full equations take any choice of unknowns at one point; reduced ones have few unknowns and are
solved at many points by the compiled solver, or as it does on NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import inverses
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    DETERMINED,
    GOING,
    INVALID,
    NEGATIVE,
    SINGULAR,
    STALLED,
    TOLERANCE,
    damping,
    iterate,
    judged,
)

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


def solve_reduced(
    kernels: OrbitKernels, parameters: Any, guess: Any, out: np.ndarray | None = None
) -> Solved:
    """Solve the reduced equations by Newton's method, elementwise over leading axes.

    Parameters are (..., p), the guess of the reduced unknowns (..., m); m is 0 if all unknowns
    are explicit. The unknowns are written to `out` (..., n) if it is given. `status` means what
    it means in the compiled solver.
    """
    if kernels.solver is not None:
        given = (parameters, guess) if kernels.reduced else (parameters,)
        return Solved(*kernels.solver(*given, out=(out, None, None, None, None)))
    parameters, guess = np.asarray(parameters, float), np.asarray(guess, float)
    lead = np.broadcast_shapes(parameters.shape[:-1], guess.shape[:-1])
    count = math.prod(lead)
    flat, x = (
        np.broadcast_to(a, (*lead, a.shape[-1])).reshape(count, a.shape[-1])
        for a in (parameters, guess)
    )
    with np.errstate(all="ignore"):
        solved = _solve_flat(kernels, flat, x.copy())
    unknowns = solved.unknowns.reshape(*lead, -1)
    if out is not None:
        out[...] = unknowns
        unknowns = out
    return Solved(unknowns, *(array.reshape(lead)[()] for array in solved[1:]))


def _solve_flat(kernels: OrbitKernels, parameters: np.ndarray, x: np.ndarray) -> Solved:
    """The compiled solver's algorithm on NumPy; converged points are left alone."""
    spectrum, _ = kernels.spectrum(parameters)
    timed = np.array([name in kernels.dwell_times for name in kernels.reduced])

    def advance(running: np.ndarray) -> np.ndarray:
        here = x[running]
        residual, jacobian = kernels.evaluate(
            "reduced_residual",
            "reduced_jacobian",
            at=(parameters[running], spectrum[running], here),
        )
        step = _steps(jacobian, residual)
        wanted = here - step
        limited = np.where(wanted < 0.25 * here, 0.25 * here, wanted)
        limited = np.where(limited > 4.0 * here, 4.0 * here, limited)
        x[running] = following = np.where(timed, limited, wanted)
        size = np.maximum(np.abs(following), 1.0)
        done = (np.abs(wanted - here) <= TOLERANCE * size).all(axis=-1)
        return np.where(done, CONVERGED, GOING)

    if kernels.reduced:
        taken, status = iterate(len(x), advance)
    else:
        taken, status = np.zeros((2, len(x)), dtype=np.int32)
    residual = np.zeros((len(x), 1))
    if kernels.reduced:
        residual = kernels.evaluate("reduced_residual", at=(parameters, spectrum, x))
    unknowns, determinants = kernels.expand(parameters, spectrum, x)
    trace = kernels.evaluate("trace", at=(parameters, spectrum, unknowns))
    at = np.concatenate([unknowns, parameters], axis=-1)
    negative = (dwell_times(kernels, at, lasting_phases(kernels)) <= 0).any(axis=-1)
    status[negative & (status == CONVERGED)] = NEGATIVE
    status[~(np.isfinite(unknowns).all(axis=-1) & np.isfinite(trace))] = INVALID
    status[(np.abs(determinants) <= LEAST_DETERMINANT).any(axis=-1)] = SINGULAR
    return Solved(unknowns, trace, np.abs(residual).max(axis=-1), taken, status)


def _steps(jacobian: np.ndarray, residual: np.ndarray) -> np.ndarray:
    """Newton steps; NaN where a Jacobian is singular, so that only this point is lost."""
    sound = np.isfinite(jacobian).all(axis=(-2, -1)) & (np.linalg.det(jacobian) != 0)
    steps = np.full_like(residual, np.nan)
    if sound.any():
        steps[sound] = np.linalg.solve(jacobian[sound], residual[sound][..., None])[..., 0]
    return steps


class PointSolution(NamedTuple):
    """All numbers x (n + p,) of one point, unknowns, then parameters, and how they were found."""

    x: np.ndarray
    residual: float
    iterations: int
    status: int
    error: float  # in units of max(1, |x|); inf where nothing has converged


def solve_full(kernels: OrbitKernels, x: np.ndarray, places: Sequence[int]) -> PointSolution:
    """Solve the full equations by damped Newton's method, for any choice of unknowns.

    Of all unknowns and parameters x (n + p,) those at the places, as many as equations, are a
    guess; the rest stay. Raises `InputError` if the equations do not determine these: if
    the Jacobian's condition number is beyond 1e12, or no digit of a solution is certain (as
    where the only solution is zero).
    """
    names, x = (*kernels.unknowns, *kernels.parameter_names), np.array(x, dtype=float)
    sought = [names[place] for place in places]
    timed = np.array([name in kernels.dwell_times for name in sought])
    count = len(kernels.unknowns)
    residual, jacobian = np.full(count, np.nan), np.full((count, count), np.nan)

    def advance(_: np.ndarray) -> list[int]:
        nonlocal residual, jacobian
        equations = equations_at(kernels, x)
        residual, jacobian = equations.residual, equations.jacobian[:, places]
        if not (np.isfinite(residual).all() and np.isfinite(jacobian).all()):
            return [INVALID]
        if np.linalg.det(jacobian) == 0:
            return [STALLED]
        step = np.linalg.solve(jacobian, residual)
        here = x[places]
        falling = timed & (here > 0) & (step > 0.5 * here)  # near what damping allows
        fraction = damping(here[falling], -step[falling]) if np.count_nonzero(falling) else 1.0
        x[places] = here - fraction * step
        small = (abs(step) <= TOLERANCE * np.maximum(abs(here), 1)).all()
        return [CONVERGED if fraction == 1 and small else GOING]

    with np.errstate(all="ignore"):
        (iterations,), (status,) = (ended.tolist() for ended in iterate(1, advance))
        if status != INVALID and (condition := _condition_number(jacobian)) > MOST_CONDITION:
            raise _undetermined(sought, condition)
        missed = float(np.abs(residual).max())
        found = judged_solution(kernels, x, places, missed, iterations, status)
        if status == CONVERGED and not found.error < DETERMINED:
            jacobian = equations_at(kernels, x).jacobian[:, places]
            size = np.maximum(np.abs(x[places]), 1)
            raise _undetermined(sought, _condition_in_norm(jacobian * size))
    return found


def _undetermined(sought: Sequence[str], condition: float) -> InputError:
    return InputError(
        f"the equations do not determine {', '.join(sought)} here: condition number {condition:.1e}"
    )


def judged_solution(
    kernels: OrbitKernels,
    x: np.ndarray,
    places: Sequence[int] | slice,
    residual: float,
    iterations: int,
    status: int,
) -> PointSolution:
    """What a solver reached: the residual of the full equations and the error if it converged."""
    error = math.inf
    if status == CONVERGED:
        residual, error, status = judged_at(kernels, x, places)
    return PointSolution(x, residual, iterations, status, error)


class LinearisedEquations(NamedTuple):
    """Residual (..., n), Jacobian (..., n, n + p) by unknowns and parameters, and spectrum."""

    residual: np.ndarray
    jacobian: np.ndarray
    spectrum: np.ndarray


def equations_at(kernels: OrbitKernels, x: np.ndarray) -> LinearisedEquations:
    """The full equations at points x (..., n + p) of unknowns, then parameters."""
    unknowns, parameters = _halves(kernels, x)
    spectrum, derivatives = kernels.spectrum(parameters)
    residual, *by = kernels.evaluate(
        "residual",
        "jacobian",
        "parameter_jacobian",
        at=(parameters, spectrum, unknowns, derivatives),
    )
    return LinearisedEquations(residual, np.concatenate(by, axis=-1), spectrum)


def _halves(kernels: OrbitKernels, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    count = len(kernels.unknowns)
    return x[..., :count], x[..., count:]


class Errors(NamedTuple):
    """Bounds on the errors of a solution, and the dwell times of its phases that take time."""

    largest: Any  # (...), of all numbers in units of max(1, |x|), NaN where nothing is known
    dwell: np.ndarray  # (..., p)
    of_dwell: np.ndarray  # (..., p), bounds on the errors of the dwell times


@np.errstate(all="ignore")
def error_bounds(
    kernels: OrbitKernels,
    x: np.ndarray,
    places: Sequence[int] | slice,
    equations: LinearisedEquations,
) -> Errors:
    """Bounds on the errors of the numbers at some places of points x (..., n + p).

    J^-1 is applied to the residual and to the rounding errors of all that enters the equations:
    parameters and unknowns, and the states along the orbit, whose differences the equations are.
    `equations` are those at x. The bounds are NaN where J is singular, that on all numbers also
    where the Poincare map is not finite.
    """
    residual, jacobian, spectrum = equations
    unknowns, parameters = _halves(kernels, x)
    at = (parameters, spectrum, unknowns)
    states = np.abs(kernels.evaluate("states", at=at))
    sizes = np.abs(x)[..., None] * np.ones(2)
    sizes[..., places, 0] = np.maximum(sizes[..., places, 0], 1.0)
    largest = states.reshape(*x.shape[:-1], -1).max(axis=-1)
    rounding = np.abs(jacobian) @ sizes + largest[..., None, None]
    noise = np.abs(residual)[..., None] + 4 * _EPSILON * rounding
    errors = np.zeros((*x.shape, 2))
    errors[..., places, :] = np.abs(inverses(jacobian[..., places])) @ noise
    largest = (errors[..., places, 0] / sizes[..., places, 0]).max(axis=-1)
    # nothing is added, or NaN
    largest = largest + (0 * kernels.evaluate("poincare_jacobian", at=at)).sum(axis=(-2, -1))
    waits = _waits(kernels, x, errors[..., 1])
    return Errors(largest, *waits)


def judged_at(
    kernels: OrbitKernels, x: np.ndarray, places: Sequence[int] | slice
) -> tuple[float, float, int]:
    """Largest residual, error and status of a solution x (n + p,), solved for at some places.

    The error is that of all numbers in units of max(1, |x|), and of frequencies far apart.
    """
    equations = equations_at(kernels, x)
    errors = error_bounds(kernels, x, places, equations)
    error = max(errors.largest, 4 * _EPSILON * float(frequency_spread(kernels, equations.spectrum)))
    status = judged(errors.dwell, errors.of_dwell, error, DETERMINED)
    return float(np.abs(equations.residual).max()), error, int(status)


def _waits(
    kernels: OrbitKernels, x: np.ndarray, errors: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Dwell times (p,) or (k, p) of the phases that take time, and their errors."""
    names, places = (*kernels.unknowns, *kernels.parameter_names), lasting_phases(kernels)
    own = dict(zip(names, errors.T, strict=True))
    sums = [kernels.table["durations"][place].items() for place in places]
    of_dwell = [sum(abs(factor) * own[term] for term, factor in terms) for terms in sums]
    return dwell_times(kernels, x, places), np.array(of_dwell).T


def dwell_times(kernels: OrbitKernels, x: np.ndarray, places: Sequence[int]) -> np.ndarray:
    """Dwell times (p,) or (k, p) of phases, from unknowns, then parameters: x (m,) or (k, m)."""
    names = (*kernels.unknowns, *kernels.parameter_names)
    found = [*kernels.durations(dict(zip(names, x.T, strict=True))).values()]
    dwell = np.empty((*x.shape[:-1], len(places)))
    for column, place in enumerate(places):
        dwell[..., column] = found[place]
    return dwell


def lasting_phases(kernels: OrbitKernels) -> list[int]:
    """Places of the phases that take time."""
    vanishing = kernels.table["vanishing"]
    return [k for k, name in enumerate(kernels.dwell_times) if name not in vanishing]


def frequency_spread(kernels: OrbitKernels, spectrum: np.ndarray) -> np.ndarray | float:
    """Ratio (...) of the largest to the smallest frequency of a spectrum (..., k).

    The equations' rounding errors grow with the ratio, those of the Poincare map with its
    square. It is 1 for fewer than two frequencies, and inf where it is not finite.
    """
    places = kernels.frequency_places
    if len(places) < 2:
        return np.ones(np.shape(spectrum)[:-1])
    frequencies = np.abs(spectrum[..., places])
    if frequencies.ndim == 1:  # of few numbers Python finds the ends sooner
        sizes = sorted(frequencies.tolist())
        known = sizes[0] > 0 and math.isfinite(sum(sizes))
        return float(sizes[-1] / sizes[0]) if known else math.inf
    with np.errstate(all="ignore"):
        ratio = frequencies.max(axis=-1) / frequencies.min(axis=-1)
    return np.where(np.isfinite(ratio), ratio, np.inf)


def natural_scales(jacobian: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sizes (n,) of equations and sizes (m,) of the numbers x (m,) that enter them.

    An equation's size is the sum of its terms' absolute values; the Jacobian (n, m) is by all
    numbers. A number's size is the least change that by itself is as large as all terms of an
    equation, so it is positive where the number is zero too. Both are rounded to powers of two,
    so that scaling rounds nothing.
    """
    entries = np.abs(jacobian.astype(float))
    rows = entries @ np.abs(x.astype(float))
    rows = np.exp2(np.rint(np.log2(np.where(rows > 0, rows, 1.0))))
    most = (entries / rows[:, None]).max(axis=0)
    return rows, np.exp2(-np.rint(np.log2(np.where(most > 0, most, 1.0))))


def _condition_number(jacobian: np.ndarray) -> float:
    """Condition number of a Jacobian (n, m) after scaling rows, then columns, to unit size."""
    rows = np.abs(jacobian).max(axis=1, keepdims=True)
    scaled = jacobian / np.where(rows > 0, rows, 1)
    columns = np.abs(scaled).max(axis=0, keepdims=True)
    scaled = scaled / np.where(columns > 0, columns, 1)
    return _condition_in_norm(scaled)


def _condition_in_norm(matrix: np.ndarray) -> float:
    """Condition number of a matrix (n, m) in the 2-norm, inf if an entry is not finite."""
    return float(np.linalg.cond(matrix)) if np.isfinite(matrix).all() else np.inf
