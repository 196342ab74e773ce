"""Orbits at many parameter points by their kernels: compiled, vectorised, in threads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable
from nonsmooth.runtime.model.parameter_batches import complete_arrays
from nonsmooth.runtime.model.parameters import constrained, in_domains
from nonsmooth.runtime.orbits.admissible import admissible_points
from nonsmooth.runtime.orbits.kernel_problem import KernelProblem
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.shooting.newton import CONVERGED, NEGATIVE, OUTSIDE, Solved, solve_reduced

__all__ = ["CHUNK", "solve_from", "solve_kernels_many"]

CHUNK = 1 << 15  # points that one thread takes at a time
_SAME = 1e-6  # difference of one orbit found twice, in units of max(1, |x|)


def solve_kernels_many(
    kernels: OrbitKernels,
    parameters: Mapping[str, Any],
    *,
    admissibility: bool,
    threads: int | None,
    chunk: int,
) -> Orbits:
    """Find orbits at many points by the kernels of their own equations; as `solve_many`."""
    arrays = complete_arrays(kernels, parameters)
    try:
        shape = np.broadcast_shapes(*(a.shape for a in arrays.values()))
    except ValueError as error:
        raise InputError(f"the parameter arrays do not broadcast: {error}") from None
    opened = {n: arrays.pop(n) for n in [*arrays] if n not in kernels.parameter_names}
    found = _solve_arrays(kernels, arrays, shape, None, admissibility, threads, chunk)
    return found.restricted(opened)


def solve_from(
    kernels: OrbitKernels, parameters: Mapping[str, np.ndarray], start: np.ndarray | None
) -> Orbits:
    """Find orbits from one start each, in this thread, with admissibility decided.

    Parameters
    ----------
    kernels : OrbitKernels
        Of an orbit that is derived.
    parameters : mapping of str to array
        All parameters of the equations; they broadcast against each other.
    start : array (..., m) or None
        Reduced unknowns; None starts as `solve_many` does.
    """
    shape = np.broadcast_shapes(*(np.shape(a) for a in parameters.values()))
    return _solve_arrays(kernels, dict(parameters), shape, start, True, 1, CHUNK)


def _solve_arrays(
    kernels: OrbitKernels,
    arrays: dict[str, np.ndarray],
    shape: tuple[int, ...],
    start: np.ndarray | None,
    admissibility: bool,
    threads: int | None,
    chunk: int,
) -> Orbits:
    count = int(np.prod(shape, dtype=np.int64))
    results = _Results.empty(kernels, count, admissibility)
    broadcast = [np.broadcast_to(arrays[name], shape) for name in kernels.parameter_names]
    flat = None if start is None else start.reshape(count, len(kernels.reduced))

    def work(part: slice) -> None:
        points = np.stack([b.flat[part] for b in broadcast], axis=-1)
        _fill(kernels, points, None if flat is None else flat[part], results, part)

    if count > chunk and threads != 1:
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(work, _parts(count, chunk)))
    else:
        for part in _parts(count, chunk):
            work(part)
    return results.shaped(kernels, arrays, shape)


@dataclass(frozen=True)
class _Results:
    """Flat arrays that the threads fill."""

    unknowns: np.ndarray
    trace: np.ndarray
    residual: np.ndarray
    iterations: np.ndarray
    status: np.ndarray
    admissible: np.ndarray | None
    bounds: np.ndarray | None

    @classmethod
    def empty(cls, kernels: OrbitKernels, count: int, admissibility: bool) -> _Results:
        return cls(
            np.empty((count, len(kernels.unknowns))),
            np.empty(count),
            np.empty(count),
            np.empty(count, dtype=np.int32),
            np.empty(count, dtype=np.int32),
            np.empty(count, dtype=bool) if admissibility else None,
            np.empty((count, len(kernels.open_parameters))) if admissibility else None,
        )

    def shaped(
        self,
        kernels: OrbitKernels,
        parameters: dict[str, np.ndarray],
        shape: tuple[int, ...],
    ) -> Orbits:
        unknowns = _columns(self.unknowns, kernels.unknowns, shape)
        full = {n: np.broadcast_to(parameters[n], shape) for n in kernels.parameter_names}
        opened, bounds = [p.name for p in kernels.open_parameters], self.bounds
        status = self.status.reshape(shape)
        period = sum(kernels.durations({**full, **unknowns}).values())
        return Orbits(
            KernelProblem(kernels),
            parameters,
            unknowns,
            self.trace.reshape(shape),
            np.where(status == CONVERGED, period, np.nan)[()],
            self.residual.reshape(shape),
            self.iterations.reshape(shape),
            status,
            None if self.admissible is None else self.admissible.reshape(shape),
            None if bounds is None else _columns(bounds, opened, shape),
        )


def _columns(
    table: np.ndarray, names: Iterable[str], shape: tuple[int, ...]
) -> dict[str, np.ndarray]:
    return {name: table[:, i].reshape(shape) for i, name in enumerate(names)}


def _parts(count: int, chunk: int) -> Iterator[slice]:
    return (slice(begin, min(begin + chunk, count)) for begin in range(0, count, chunk))


def _fill(
    kernels: OrbitKernels,
    points: np.ndarray,
    start: np.ndarray | None,
    results: _Results,
    part: slice,
) -> None:
    starts = _starts(kernels, points) if start is None else [start]
    solved = _solve_points(kernels, points, starts)
    if results.admissible is not None and results.bounds is not None:
        allowed, bounds = _admissible_ones(kernels, points, starts, solved)
        results.admissible[part], results.bounds[part] = allowed, bounds
    lost = solved.status != CONVERGED
    for array, found in zip(
        (results.unknowns, results.trace, results.residual), solved[:3], strict=True
    ):
        array[part] = found
        array[part][lost] = np.nan
    results.iterations[part], results.status[part] = solved.iterations, solved.status


def _starts(kernels: OrbitKernels, points: np.ndarray) -> list[np.ndarray]:
    """Reduced unknowns (count, m) to start from: the prediction, then further ones."""
    if not kernels.reduced:
        return [np.empty((len(points), 0))]
    predictor = _predictor(kernels)
    # summed in a fixed order: a matrix product rounds differently for other numbers of points
    distances = (points - predictor.parameters).T
    columns = [
        sum((d * slope for d, slope in zip(distances, slopes, strict=True)), start)
        for slopes, start in zip(predictor.slopes.T, predictor.reduced, strict=True)
    ]
    guess = np.stack(columns, axis=-1)
    guess = np.clip(guess, *np.sort([0.25 * predictor.reduced, 4.0 * predictor.reduced], axis=0))
    further = [np.broadcast_to(start, guess.shape) for start in predictor.starts]
    return [guess, *further]


def _admissible_ones(
    kernels: OrbitKernels, points: np.ndarray, starts: Sequence[np.ndarray], solved: Solved
) -> tuple[np.ndarray, np.ndarray]:
    """Check the orbits, and put an admissible one, if a further start leads to it, in place."""
    allowed, bounds = admissible_points(kernels, points, solved.unknowns)
    allowed &= solved.status == CONVERGED
    bounds[~allowed] = np.nan
    for start in starts[1:]:
        rest = np.flatnonzero(~allowed & (solved.status == CONVERGED))
        if not len(rest):
            break
        again = solve_reduced(kernels, points[rest], start[rest])
        # the same orbit again is no motion either
        moved = np.abs(again.unknowns - solved.unknowns[rest])
        other = (moved > _SAME * np.maximum(1, np.abs(again.unknowns))).any(axis=-1)
        found = np.flatnonzero((again.status == CONVERGED) & other)
        fit, least = admissible_points(kernels, points[rest[found]], again.unknowns[found])
        fit &= _allowed(kernels.other_parameters, kernels.unknowns, again.unknowns[found])
        better = rest[found[fit]]
        for array, values in zip(solved, again, strict=True):
            array[better] = values[found[fit]]
        allowed[better], bounds[better] = True, least[fit]
    return allowed, bounds


def _solve_points(
    kernels: OrbitKernels, points: np.ndarray, starts: Sequence[np.ndarray]
) -> Solved:
    """Solve from the first start, and what is lost from each further one in turn."""
    valid = _inside(kernels, points)
    sound = np.where(valid[:, None], points, np.nan)
    solved = solve_reduced(kernels, sound, starts[0])
    if not kernels.reduced:
        return solved
    for start in starts[1:]:
        lost = np.flatnonzero(valid & (solved.status != CONVERGED))
        if not len(lost):
            break
        again = solve_reduced(kernels, points[lost], start[lost])
        # a root with a negative dwell time says more than none at all
        better = (again.status == CONVERGED) | (
            (again.status == NEGATIVE) & (solved.status[lost] != NEGATIVE)
        )
        for array, found in zip(solved, again, strict=True):
            array[lost[better]] = found[better]
    outside = ~_allowed(kernels.other_parameters, kernels.unknowns, solved.unknowns)
    solved.status[outside & (solved.status == CONVERGED)] = OUTSIDE
    return solved


def _inside(kernels: OrbitKernels, points: np.ndarray) -> np.ndarray:
    """Which points lie in the domains of all parameters, and keep the system's constraints."""
    allowed = _allowed(kernels.parameters, kernels.parameter_names, points)
    columns = dict(zip(kernels.parameter_names, points.T, strict=True))
    allowed &= constrained(kernels.system, columns)
    return np.asarray(np.isfinite(points).all(axis=-1) & allowed)


def _allowed(
    tables: Iterable[ParameterTable], names: Sequence[str], points: np.ndarray
) -> np.ndarray:
    """At which points those of the parameters that are among the names lie in their domains."""
    inside = np.full(len(points), True)
    for table in tables:
        if table.name in names:
            inside &= in_domains(table, points[:, names.index(table.name)])
    return inside


@dataclass(frozen=True)
class _Predictor:
    """Reference orbit, its first-order dependence on the parameters, and further starts."""

    parameters: np.ndarray
    reduced: np.ndarray
    slopes: np.ndarray
    starts: tuple[np.ndarray, ...]


@cache
def _predictor(kernels: OrbitKernels) -> _Predictor:
    reference = solve_kernels(kernels)
    sensitivities = [reference.sensitivity(name).unknowns for name in kernels.parameter_names]
    reduced = np.array([reference.unknowns[name] for name in kernels.reduced])
    slopes = np.array([[s[name] for name in kernels.reduced] for s in sensitivities])
    factors = np.array([1.0, 0.6, 1.5, 0.3, 2.2])
    if len(reduced) == 1:  # a stiff stop is touched for ever shorter times
        factors = np.append(factors, np.geomspace(0.2, 1e-5, 25))
    grids = np.meshgrid(*[factors] * len(reduced), indexing="ij")
    starts = np.stack([g.ravel() for g in grids], axis=-1) * reduced
    nearest = np.argsort(np.abs(np.log(starts / reduced)).sum(axis=-1), kind="stable")
    parameters = np.array([reference.values[name] for name in kernels.parameter_names])
    return _Predictor(parameters, reduced, slopes, tuple(starts[i] for i in nearest))
