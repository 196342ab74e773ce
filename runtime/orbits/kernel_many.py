"""Orbits at many parameter points by their kernels: compiled, vectorised, in threads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, reduce
from typing import ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.parallel import in_parallel
from nonsmooth.runtime.model.completion import Batch, complete_arrays, complete_batch
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, compiled_for
from nonsmooth.runtime.model.parameters import constrained, in_domain
from nonsmooth.runtime.orbits.admissible import (
    NEITHER,
    NO_ORBIT,
    kernel_limits,
)
from nonsmooth.runtime.orbits.equations import KernelEquations
from nonsmooth.runtime.orbits.kernel_problem import kernel_problem
from nonsmooth.runtime.orbits.one_point import solve_kernels
from nonsmooth.runtime.orbits.orbit import TOO_SMALL, Orbits, reshaped, restricted
from nonsmooth.runtime.shooting.kernel_newton import (
    Solved,
    equations_at,
    error_bounds,
    frequency_spread,
    solve_reduced,
)
from nonsmooth.runtime.shooting.multipliers import margins, pair_margins
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    NEGATIVE,
    OUTSIDE,
    SHORTEST,
    judged,
)

CHUNK = 1 << 15  # points that one thread takes at a time
NUMPY_SOLVED, NUMPY_JUDGED = 1e-5, 3e-4  # seconds a point without compiled kernels
_WIDE = 25.0  # ratio of the spectrum's parameters beyond which the digits of orbits are counted
_MOST_ERROR = 1e-6  # of unknowns in units of max(1, |x|), and of the trace
_SAME = 1e-6  # difference of one orbit found twice, in units of max(1, |x|)


@dataclass(frozen=True, eq=False)
class KernelPoints:
    """One orbit at many points (n,) by its kernels, solved for at each by itself."""

    kernels: OrbitKernels
    given: tuple[str, ...] = ()  # names of what is fixed or swept
    worth: bool = False  # whether kernels are compiled where the work is worth it
    chunk: ClassVar[int] = 1 << 16

    @cached_property
    def batch(self) -> Batch:
        """How parameters are completed.

        `InputError` is raised for a name that fixes nothing, or several that fix one
        parameter twice.
        """
        return complete_batch(self.kernels, self.given)

    @property
    def parameters(self) -> list[ParameterTable]:
        """Parameters that have to have a value."""
        return [self.kernels.tables[name] for name in self.batch.known]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns."""
        return self.kernels.unknowns

    @property
    def bounded(self) -> tuple[str, ...]:
        """Open parameters of which a lower bound is computed."""
        return tuple(table.name for table in self.kernels.open_parameters)

    @property
    def limits(self) -> tuple[str, ...]:
        """Meanings of the numbers of `Orbits.limit`, from 0."""
        return (*_boundaries(self.kernels), *map(TOO_SMALL.format, self.batch.opened))

    @property
    def start_names(self) -> tuple[str, ...]:
        """Unknowns that starts are made of."""
        return self.kernels.reduced

    def solve(
        self,
        values: Mapping[str, np.ndarray],
        start: np.ndarray | None = None,
        *,
        admissibility: bool = True,
        margins: bool = False,
        threads: int | None = 1,
        chunk: int = CHUNK,
    ) -> Orbits:
        """Return orbits from starts (n, m), or from the solver's usual ones.

        `values` are parameters as arrays that broadcast, which give the arrays of the result
        their shape; absent ones take the reference point's values. A start has the unknowns
        `start_names`. `chunk` points are solved at a time; `threads` None takes as many as
        processors. `InputError` is raised for arrays that do not broadcast.
        """
        kernels = self.kernels
        full = complete_arrays(kernels, values)
        try:
            shape = np.broadcast_shapes(*(array.shape for array in full.values()))
        except ValueError as error:
            raise InputError(f"the parameter arrays do not broadcast: {error}") from None
        opened = {n: full.pop(n) for n in [*full] if n not in kernels.parameter_names}
        count = int(np.prod(shape, dtype=np.int64))
        if self.worth:
            seconds = NUMPY_JUDGED if admissibility else NUMPY_SOLVED
            kernels = compiled_for(kernels, count * seconds)
        unknowns = np.empty((len(kernels.unknowns), count))
        found = Orbits(
            kernel_problem(kernels),
            full,
            dict(zip(kernels.unknowns, unknowns, strict=True)),
            trace=np.empty(count),
            period=np.empty(count),
            residual=np.empty(count),
            iterations=np.empty(count, dtype=np.int32),
            status=np.empty(count, dtype=np.int32),
            limit=np.empty(count, dtype=int) if admissibility else None,
            limits=tuple(_boundaries(kernels)) if admissibility else (),
            bounds={table.name: np.empty(count) for table in kernels.open_parameters}
            if admissibility
            else None,
            margin=np.full(count, np.nan) if margins else None,
        )
        every = [_flat(full[name], shape) for name in kernels.parameter_names]

        def work(part: slice) -> None:
            columns = [column if column.size == 1 else column[part] for column in every]
            near = start[part] if start is not None and kernels.reduced else None
            _fill(kernels, columns, near, found, unknowns, part)

        parts = [slice(begin, min(begin + chunk, count)) for begin in range(0, count, chunk)]
        in_parallel(work, parts, threads)
        return restricted(reshaped(found, shape), opened)

    @cached_property
    def usual(self) -> np.ndarray:
        """Sizes (m,) at the reference orbit of what starts are made of; 0 for dwell times."""
        if not self.kernels.reduced:
            return np.empty(0)
        equations = KernelEquations(solve_kernels(self.kernels))
        known = dict(zip(equations.unknowns, equations.sizes.tolist(), strict=True))
        timed = self.kernels.timed
        return np.array([0.0 if n in timed else known[n] for n in self.kernels.reduced])


def _boundaries(kernels: OrbitKernels) -> list[str]:
    """Return the boundaries of an orbit's phases, for people."""
    phases = kernels.table["phases"]
    return [f"phase {b.phase + 1} {phases[b.phase][0]}: {b.name}" for b in kernels.boundaries]


def _margins(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, trace: np.ndarray
) -> np.ndarray:
    """Return 1 - the largest nontrivial |multiplier| of orbits (n,), as in `Orbit.stability`."""
    table = kernels.table
    if table["reciprocal_pair"]:
        return pair_margins(trace)
    family, rank = bool(table["conservative"]), table["rank"]
    if rank == 1 and not family:
        return np.asarray(1 - np.abs(trace))
    spectrum, _ = kernels.spectrum(points)
    maps = kernels.evaluate("poincare_jacobian", at=(points, spectrum, unknowns))
    return margins(maps, trace, rank, family=family)


def _flat(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Return one parameter of all points, flat, or (1,) where they share it."""
    return array.reshape(1) if array.size == 1 else np.broadcast_to(array, shape).reshape(-1)


def _fill(
    kernels: OrbitKernels,
    columns: Sequence[np.ndarray],
    start: np.ndarray | None,
    found: Orbits,
    unknowns: np.ndarray,
    part: slice,
) -> None:
    """Solve a part of the points, whose parameters are columns (k,), or (1,) where shared.

    The unknowns (n, count) of all points are those of the orbits `found`.
    """
    count = found.trace[part].size
    points = np.empty((len(columns), count)).T
    for place, column in enumerate(columns):
        points[:, place] = column
    valid = _inside(kernels, columns)
    starts = _starts(kernels, columns, count) if start is None else [start]
    unknowns = unknowns[:, part]
    solved = _solve_points(kernels, points, np.broadcast_to(valid, count), starts, unknowns.T)
    if found.limit is not None and found.bounds is not None:
        limit, bounds = _limits(kernels, points, starts, solved)
    values = dict(zip(kernels.parameter_names, columns, strict=True))
    values |= dict(zip(kernels.unknowns, unknowns, strict=True))
    waits, period = kernels.durations(values), found.period[part]
    period[:] = reduce(np.add, waits.values())
    lasting = [wait for name, wait in waits.items() if name not in kernels.table["vanishing"]]
    short = reduce(np.minimum, lasting) < SHORTEST * period
    _count_digits(kernels, _far_apart(kernels, columns) | short, points, solved)
    lost = np.flatnonzero(solved.status != CONVERGED)
    for array in (*solved[:3], period):
        array[lost] = np.nan
    found.trace[part], found.residual[part] = solved.trace, solved.residual
    found.iterations[part], found.status[part] = solved.iterations, solved.status
    if found.limit is not None and found.bounds is not None:
        limit[lost], bounds[lost] = NO_ORBIT, np.nan
        found.limit[part] = limit
        for row, least in zip(found.bounds.values(), bounds.T, strict=True):
            row[part] = least
    if found.margin is not None:
        there = np.flatnonzero(solved.status == CONVERGED)
        at = points[there], solved.unknowns[there], solved.trace[there]
        found.margin[part][there] = _margins(kernels, *at)


def _count_digits(
    kernels: OrbitKernels, looked: np.ndarray, points: np.ndarray, solved: Solved
) -> None:
    """Mark the converged points of too few sure digits in the status, among those looked at."""
    if not looked.any():
        return
    places = np.flatnonzero((solved.status == CONVERGED) & looked)
    if not len(places):
        return
    x = np.concatenate([solved.unknowns[places], points[places]], axis=-1)
    with np.errstate(all="ignore"):
        equations = equations_at(kernels, x)
    spread = frequency_spread(kernels, equations.spectrum)
    lost = np.finfo(float).eps * np.minimum(spread, 1e9) ** 2
    errors = error_bounds(kernels, x, slice(len(kernels.unknowns)), equations)
    largest = np.maximum(errors.largest, lost)
    solved.status[places] = judged(errors.dwell, errors.of_dwell, largest, _MOST_ERROR)


def _far_apart(kernels: OrbitKernels, columns: Sequence[np.ndarray]) -> np.ndarray:
    """Return where the spectrum's parameters, or distances to ends of domains, differ widely."""
    distances = []
    for place in kernels.spectrum_places:
        values = columns[place]
        lower, upper = kernels.tables[kernels.parameter_names[place]].ends
        if np.isfinite(upper):
            distances.append(upper - values)
        distances.append(values - lower if np.isfinite(lower) and lower else np.abs(values))
    if not distances:
        return np.zeros(1, dtype=bool)
    largest, least = reduce(np.maximum, distances), reduce(np.minimum, distances)
    return np.asarray(~(largest < _WIDE * least))


def _starts(kernels: OrbitKernels, columns: Sequence[np.ndarray], count: int) -> list[np.ndarray]:
    """Return starts of the reduced unknowns: the prediction (count, m), then further ones (m,)."""
    if not kernels.reduced:
        return [np.empty((count, 0))]
    predictor = _predictor(kernels)
    # summed in a fixed order: a matrix product rounds differently for other numbers of points
    distances = [c - start for c, start in zip(columns, predictor.parameters, strict=True)]
    moved = [i for i, d in enumerate(distances) if d.size > 1 or d[0] != 0]
    guess = np.empty((len(predictor.reduced), count))
    for row, slopes, start in zip(guess, predictor.slopes.T, predictor.reduced, strict=True):
        total = sum((distances[i] * slopes[i] for i in moved), start)
        np.clip(total, *sorted((0.25 * start, 4.0 * start)), out=row)
    return [guess.T, *predictor.starts]


def _limits(
    kernels: OrbitKernels, points: np.ndarray, starts: Sequence[np.ndarray], solved: Solved
) -> tuple[np.ndarray, np.ndarray]:
    """Return the limits of orbits, and bounds of open parameters.

    An inadmissible orbit is replaced by an admissible one if a further start leads to
    one.
    """
    limit, bounds = kernel_limits(kernels, points, solved.unknowns)
    for start in starts[1:]:
        rest = np.flatnonzero((limit != NEITHER) & (solved.status == CONVERGED))
        if not len(rest):
            break
        again = solve_reduced(kernels, points[rest], start)
        # the same orbit again is no motion either
        moved = np.abs(again.unknowns - solved.unknowns[rest])
        other = (moved > _SAME * np.maximum(1, np.abs(again.unknowns))).any(axis=-1)
        found = np.flatnonzero((again.status == CONVERGED) & other)
        further, least = kernel_limits(kernels, points[rest[found]], again.unknowns[found])
        fit = (further == NEITHER) & _allowed(kernels, again.unknowns[found])
        better = rest[found[fit]]
        for array, values in zip(solved, again, strict=True):
            array[better] = values[found[fit]]
        limit[better], bounds[better] = NEITHER, least[fit]
    return limit, bounds


def _solve_points(
    kernels: OrbitKernels,
    points: np.ndarray,
    valid: np.ndarray,
    starts: Sequence[np.ndarray],
    unknowns: np.ndarray,
) -> Solved:
    """Solve from the first start, and what is lost from each further one in turn.

    The solutions (k, n) are written into `unknowns`.
    """
    sound = points if valid.all() else np.where(valid[:, None], points, np.nan)
    solved = solve_reduced(kernels, sound, starts[0], unknowns)
    if not kernels.reduced:
        return solved
    for start in starts[1:]:
        lost = np.flatnonzero(valid & (solved.status != CONVERGED))
        if not len(lost):
            break
        again = solve_reduced(kernels, points[lost], start)
        # a root with a negative dwell time says more than none at all
        better = (again.status == CONVERGED) | (
            (again.status == NEGATIVE) & (solved.status[lost] != NEGATIVE)
        )
        for array, found in zip(solved, again, strict=True):
            array[lost[better]] = found[better]
    if kernels.solved_for:
        outside = ~_allowed(kernels, solved.unknowns)
        solved.status[outside & (solved.status == CONVERGED)] = OUTSIDE
    return solved


def _inside(kernels: OrbitKernels, columns: Sequence[np.ndarray]) -> np.ndarray:
    """Return which points lie in all parameters' domains and keep the system's constraints."""
    named = dict(zip(kernels.parameter_names, columns, strict=True))
    told = [in_domain(kernels.tables[name], column) for name, column in named.items()]
    told.append(constrained(kernels.system, named))
    return reduce(np.logical_and, sorted(told, key=np.size))  # what is shared is told first


def _allowed(kernels: OrbitKernels, unknowns: np.ndarray) -> np.ndarray:
    """Return where the parameters among the unknowns (count, n) lie in their domains."""
    inside = np.full(len(unknowns), True)
    for name in kernels.solved_for:
        inside &= in_domain(kernels.tables[name], unknowns[:, kernels.unknowns.index(name)])
    return inside


@dataclass(frozen=True)
class _Predictor:
    """The reference orbit, its first-order dependence on the parameters, and further starts."""

    parameters: np.ndarray
    reduced: np.ndarray
    slopes: np.ndarray
    starts: tuple[np.ndarray, ...]


@cache
def _predictor(kernels: OrbitKernels) -> _Predictor:
    reference = solve_kernels(kernels)
    names = kernels.parameter_names
    rates = [reference.derivatives(name, one_sided=True).unknowns for name in names]
    reduced = np.array([reference.unknowns[name] for name in kernels.reduced])
    slopes = np.array([[rate[name][0] for name in kernels.reduced] for rate in rates])
    factors = np.array([1.0, 0.6, 1.5, 0.3, 2.2])
    if len(reduced) == 1 and kernels.reduced[0] in kernels.timed:
        # a stiff stop is touched for ever shorter times
        factors = np.append(factors, np.geomspace(0.2, 1e-5, 25))
    elif len(reduced) == 1:
        # beside a resonance a stop is struck many times as hard: from beyond all roots Newton's
        # method comes to the larger one of a quadratic, from near zero to the smaller one
        factors = np.append(factors, [0.03, 1e-3, 5.0, 30.0, 200.0])
    grids = np.meshgrid(*[factors] * len(reduced), indexing="ij")
    starts = np.stack([g.ravel() for g in grids], axis=-1) * reduced
    nearest = np.argsort(np.abs(np.log(starts / reduced)).sum(axis=-1), kind="stable")
    parameters = np.array([reference.values[name] for name in names])
    return _Predictor(parameters, reduced, slopes, tuple(starts[i] for i in nearest))
