"""Periodic orbits by the kernels of their own equations: at one parameter point, or at many.

One is searched for: it starts from the reference point's guess, from the reference orbit followed
to its parameters, and from a grid. Many are compiled, vectorised and in threads; each starts from
a first-order prediction.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, reduce
from itertools import product
from typing import ClassVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.parallel import in_parallel
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.model.completion import (
    Batch,
    Point,
    complete,
    complete_arrays,
    complete_batch,
    complete_system,
    default_parameters,
)
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, compiled_for
from nonsmooth.runtime.model.parameters import constrained, in_domain, number_of
from nonsmooth.runtime.orbits.admissible import (
    NEITHER,
    NO_ORBIT,
    kernel_limits,
    kernels_allow,
)
from nonsmooth.runtime.orbits.equations import KernelEquations
from nonsmooth.runtime.orbits.kernel_problem import kernel_problem
from nonsmooth.runtime.orbits.orbit import TOO_SMALL, Orbit, Orbits, reshaped, restricted
from nonsmooth.runtime.orbits.table_solve import (
    CONTINUATION_STEPS,
    Guess,
    named_guess,
    phases_and_dwell,
    solve_itinerary,
    steps_between,
)
from nonsmooth.runtime.shooting.kernel_newton import (
    PointSolution,
    Solved,
    equations_at,
    error_bounds,
    frequency_spread,
    judged_solution,
    solve_full,
    solve_reduced,
)
from nonsmooth.runtime.shooting.multipliers import margins, pair_margins
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    NEGATIVE,
    OUTSIDE,
    SHORTEST,
    judged,
    sure_digits,
)

CHUNK = 1 << 15  # points that one thread takes at a time
NUMPY_SOLVED, NUMPY_JUDGED = 1e-5, 3e-4  # seconds a point without compiled kernels
STARTS_PER_UNKNOWN, STARTS_OF_ONE = 40, 400
SHORTEST_DWELL, LONGEST_DWELL = 1e-6, 12.6  # up to two periods of the unit frequency
_WIDE = 25.0  # ratio of the spectrum's parameters beyond which the digits of orbits are counted
_MOST_ERROR = 1e-6  # of unknowns in units of max(1, |x|), and of the trace
_SAME = 1e-6  # difference of one orbit found twice, in units of max(1, |x|)


def solve_kernels(
    kernels: OrbitKernels,
    parameters: Mapping[str, object] | None = None,
    guess: Guess = None,
    *,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    throw: bool = True,
    label: str = "",
) -> Orbit:
    """Find a periodic orbit by the kernels of its own equations, as `solve` does.

    Absent parameters take the reference point's values; without a guess, unknowns are
    searched for. `unknown` names parameters that are solved for, `given` has the unknowns
    that are given in their place. With `throw`, `NoConvergence` is raised if no orbit is
    found; `InputError` is raised for wrong names or values, or an exchange that does not
    fit. Messages call the orbit by `label`, if that is not empty.
    """
    swapped, fixed = tuple(unknown), dict(given or {})
    _check_exchange(kernels, swapped, fixed)
    point = complete(kernels, parameters or {}, without=swapped)
    start = _start(kernels, point, guess, swapped)
    if swapped:
        values = {name: number_of(name, value) for name, value in fixed.items()}
        found, tried = _exchanged(kernels, point, swapped, values, start)
    else:
        found, tried = _ordinary(kernels, point, start, searching=guess is None)
    if throw and not found.converged:
        searched = guess is None and not swapped and kernels.reduced
        reason = "no orbit was found at these parameters" if searched else found.message
        raise NoConvergence(f"{label or kernels.name}: {reason} (tried: {', '.join(tried)})")
    return found


def _check_exchange(
    kernels: OrbitKernels, swapped: tuple[str, ...], fixed: Mapping[str, object]
) -> None:
    for name in swapped:
        if name not in kernels.parameter_names:
            raise unknown_name("parameter to solve for", name, kernels.parameter_names)
    for name in fixed:
        if name not in kernels.unknowns:
            raise unknown_name("variable", name, kernels.unknowns)
    if len(set(swapped)) != len(swapped):
        raise InputError(f"a parameter is named twice among the unknown: {', '.join(swapped)}")
    if len(swapped) != len(fixed):
        raise InputError(
            f"to be solved for: {', '.join(swapped) or 'no parameter'}; given in place:"
            f" {', '.join(fixed) or 'no unknown'}: as many of one as of the other are needed"
        )


def _start(
    kernels: OrbitKernels, point: Point, guess: Guess, swapped: Sequence[str]
) -> dict[str, float]:
    """Return a start for every unknown, and for exchanged parameters if they are given."""
    unknowns, reference = kernels.unknowns, kernels.table["reference"]
    others = dict(zip(swapped, swapped, strict=True))
    named = named_guess(kernels, guess, unknowns, len(unknowns), others)
    if reference is None and not named and unknowns:
        raise InputError(f"{kernels.name} declares no reference point: give a guess")
    if all(name in named for name in unknowns):
        return named
    # coordinates of the start are those of the composed orbit that fits the dwell times
    known = complete(kernels, {}) if reference else point
    values = complete_system(kernels, {**known.values, **known.opened}).values
    orbit = solve_itinerary(kernels.system, values, *phases_and_dwell(kernels, named))
    states = zip(orbit.system.table["states"], orbit.states[0].tolist(), strict=True)
    return {f"{state}0": value for state, value in states} | named


def _ordinary(
    kernels: OrbitKernels, point: Point, start: dict[str, float], *, searching: bool
) -> tuple[Orbit, list[str]]:
    """Solve the reduced equations for all unknowns, and tell from where that was tried.

    Where it is searched for, a motion of the real system comes before what converges first.
    """
    parameters = np.array([float(v) for v in point.values.values()])
    guess = np.array([start[name] for name in kernels.reduced])
    every, orbits, tried = slice(len(kernels.unknowns)), [], []
    for words, begin in _search_starts(kernels, parameters, guess, searching):
        tried.append(words)
        if begin is None:
            continue
        solved = solve_reduced(kernels, parameters, begin)
        x = np.concatenate([solved.unknowns, parameters])
        reached = judged_solution(
            kernels, x, every, float(solved.residual), int(solved.iterations), int(solved.status)
        )
        orbit = _orbit(kernels, point, {}, kernels.unknowns, reached)
        at = parameters[None], x[None, every]
        if (
            not searching
            or not kernels.reduced
            or (orbit.converged and kernels_allow(kernels, *at, orbit.opened)[0])
        ):
            return orbit, tried
        orbits.append(orbit)
    return next((orbit for orbit in orbits if orbit.converged), orbit), tried


def _search_starts(
    kernels: OrbitKernels, parameters: np.ndarray, guess: np.ndarray, searching: bool
) -> Iterator[tuple[str, np.ndarray | None]]:
    """Yield starts (m,) of the reduced unknowns, and where they come from; None for none."""
    if not kernels.reduced:
        yield "the explicit solution", guess
    yield "the reference point's guess" if searching else "the guess", guess
    places = [kernels.unknowns.index(name) for name in kernels.reduced]
    reference = complete(kernels, {}).values
    for here in steps_between(np.array([*map(float, reference.values())]), parameters):
        guess = solve_reduced(kernels, here, guess).unknowns[places]
    yield f"continuation in {CONTINUATION_STEPS} steps", guess
    if len(places) == 1:
        each = np.geomspace(SHORTEST_DWELL, LONGEST_DWELL, STARTS_OF_ONE)
    else:
        each = np.linspace(0, LONGEST_DWELL, STARTS_PER_UNKNOWN + 1)[1:]
    grid = np.array([*product(each, repeat=len(places))])
    solved = solve_reduced(kernels, parameters, grid)
    roots = _distinct(solved.unknowns[solved.status == CONVERGED])
    limit, _ = kernel_limits(kernels, np.tile(parameters, (len(roots), 1)), roots)
    best = np.argsort(limit != NEITHER, kind="stable")[:1]
    yield f"{len(grid)} starts", roots[best[0], places] if len(best) else None


def _distinct(roots: np.ndarray) -> np.ndarray:
    """Return the first root of each cluster, in the order of the roots."""
    first = []
    while len(roots):
        first.append(roots[0].copy())  # a view would keep all of `roots`
        apart = np.abs(roots - roots[0]) > 1e-7 * (1 + np.abs(roots[0]))
        roots = roots[apart.any(axis=-1)]
    return np.array(first).reshape(-1, roots.shape[-1])


def _exchanged(
    kernels: OrbitKernels,
    point: Point,
    swapped: tuple[str, ...],
    fixed: dict[str, Value],
    start: dict[str, float],
) -> tuple[Orbit, list[str]]:
    """Solve the full equations with parameters in place of unknowns.

    It starts from the guess; if that fails, the given values are approached in steps from
    an orbit at the default values of what is now unknown.
    """
    names = (*kernels.unknowns, *kernels.parameter_names)
    values = {name: float(parse(text)) for name, text in default_parameters(kernels).items()}
    values |= {name: float(v) for name, v in point.values.items()} | start
    sought = [*(name for name in kernels.unknowns if name not in fixed), *swapped]
    held, places = ([names.index(name) for name in part] for part in (fixed, sought))
    x = np.array([values[name] for name in names])
    target = np.array([float(value) for value in fixed.values()])

    def solved(at: np.ndarray, held_at: np.ndarray) -> PointSolution:
        begin = at.copy()
        begin[held] = held_at
        return solve_full(kernels, begin, places)

    tried = ["the guess"]
    try:
        found, refusal = solved(x, target), None
    except InputError as error:
        found, refusal = None, error
    if found is None or found.status != CONVERGED:
        tried.append(f"{CONTINUATION_STEPS} steps to the given values")
        base = solve_full(kernels, x, [*range(len(kernels.unknowns))])
        try:
            if base.status == CONVERGED:
                approached, first = base, base.x[held]
                for fraction in np.linspace(0, 1, CONTINUATION_STEPS + 1)[1:]:
                    approached = solved(approached.x, first + fraction * (target - first))
                found = approached
        except InputError:
            pass
    if found is None:
        assert refusal is not None
        raise refusal
    return _orbit(kernels, point, fixed, sought, found), tried


def _orbit(
    kernels: OrbitKernels,
    point: Point,
    fixed: Mapping[str, Value],
    sought: Sequence[str],
    found: PointSolution,
) -> Orbit:
    """Return the record of a solution, in which parameters solved for lie in their domains."""
    names, status = (*kernels.unknowns, *kernels.parameter_names), found.status
    values = dict(zip(names, found.x.tolist(), strict=True))
    unknowns = {name: values[name] for name in sought}
    inside = (
        in_domain(kernels.tables[name], value)
        for name, value in unknowns.items()
        if name in kernels.tables
    )
    if status == CONVERGED and not all(inside):
        status = OUTSIDE
    return Orbit(
        kernel_problem(kernels),
        {**point.values, **fixed},
        unknowns,
        point.opened,
        found.residual,
        sure_digits(found.error),
        found.iterations,
        status,
    )


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
