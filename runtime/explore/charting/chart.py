"""Charts of the parameter plane: what is missing is computed, then the chart is opened."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import check_folder
from nonsmooth.runtime.explore.charting.attractors import attractor_problem
from nonsmooth.runtime.explore.charting.cluster import check_scheduler, run_cluster
from nonsmooth.runtime.explore.charting.grid import Axis, Grid, axis_of, chunk_shape
from nonsmooth.runtime.explore.charting.lock import locked
from nonsmooth.runtime.explore.charting.orbits import orbit_problem
from nonsmooth.runtime.explore.charting.problem import Problem
from nonsmooth.runtime.explore.charting.store import (
    ATTRIBUTE,
    FORMAT,
    check_zarr,
    open_arrays,
    open_store,
    read_identity,
    write_chunk,
)
from nonsmooth.runtime.explore.charting.threads import run_threads

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Progress", "Work", "chart", "chart_problem", "load_chart", "work_on"]

TRANSITIONS = 2000
LARGEST_IN_MEMORY = 1 << 24  # points

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Work:
    """What was done.

    Attributes
    ----------
    chunks : int
        Of the whole chart.
    computed : int
        Of them, now.
    damaged : int
        Of those, because they were damaged.
    leftovers : int
        Files that a killed writer had left.
    """

    chunks: int
    computed: int
    damaged: int
    leftovers: int


def chart(
    orbit: str,
    *,
    store: str | Path | None = None,
    simulate: bool = False,
    start: Mapping[str, object] | Sequence[object] | None = None,
    transitions: int = TRANSITIONS,
    scheduler: str | None = None,
    chunk: int | None = None,
    threads: int | None = None,
    progress: Progress = lambda done, total: None,
    **parameters: Any,
) -> Dataset:
    """Chart an orbit over its parameters: existence, admissibility, stability, period.

    A chart in a store may be stopped at any instant, also by a kill: started again, it
    computes what is missing or damaged, and the result is the same to the last bit, whatever
    `chunk`, `threads` or `scheduler`.

    Orbits are found from those near by: on a coarse lattice in the whole grid first, then
    between. Where an itinerary has several orbits a stable or neutral motion comes before
    another motion, and a motion before an orbit that is none.

    Parameters
    ----------
    orbit : str
        As for `solve_many`; with `simulate` the name of a system.
    store : path, optional
        A folder F.zarr, begun or gone on with; memory does not grow with the number of
        points. None keeps the chart in memory.
    simulate : bool
        Where motions settle instead: how many transitions and what time the periodic motion
        takes that is reached from `start`.
    start : mapping of state to number, or sequence
        Of these motions.
    transitions : int
        After which they are looked at.
    scheduler : str, optional
        Address of a Dask scheduler, whose workers share the folder of the store; without one
        threads of this machine compute.
    chunk : int, optional
        About how many points are computed and stored at a time.
    threads : int, optional
        As many as processors when omitted.
    progress : callable
        Told how many chunks are done, and of how many.
    **parameters : array_like or number
        Rows of values become the dimensions, in their order; numbers are fixed; absent ones
        take the reference point's values. Parameters that the orbit leaves open (us1) may be
        given too: admissibility is then judged for them.

    Returns
    -------
    xarray.Dataset
        `status`, `admissible`, `limit` (what fails first), `trace`, `margin` (positive:
        stable), `period`, the unknowns, and what open parameters have to exceed; their
        attributes say what numbers mean. Read when it is used, if there is a store.

    Raises
    ------
    InputError
        For wrong names or values, a store of another chart, one that another process works
        on, or one that cannot be written.
    MissingExtra
        If Zarr, xarray or Dask are not installed.
    NoConvergence
        If the workers or the scheduler are lost.

    Examples
    --------
    >>> import numpy as np
    >>> plane = chart("dry-friction/global-stick", V=np.linspace(0.9, 1.1, 3), eta=[0.95, 1.0])
    >>> dict(plane.sizes), bool(plane.admissible.all())
    ({'V': 3, 'eta': 2}, True)
    """
    check_zarr()
    problem, axes = chart_problem(orbit, parameters, simulate, start, transitions)
    if store is not None:
        work_on(Path(store), problem, axes, scheduler, chunk, threads, progress)
        return load_chart(store)
    if scheduler is not None:
        raise InputError("a chart on a cluster needs a store")
    return _in_memory(problem, Grid(axes, _usual(problem, axes, chunk)), threads, progress)


def load_chart(path: str | Path) -> Dataset:
    """Open a chart, complete or not; its numbers are read when they are used.

    Where nothing is computed yet, `status` is -128.

    Parameters
    ----------
    path : str or path
        Folder of the chart.

    Returns
    -------
    xarray.Dataset
        With the parameters as dimensions.

    Raises
    ------
    InputError
        If there is no chart.
    MissingExtra
        If Zarr or xarray are not installed.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> made = ns.chart("dry-friction/global-stick", V=[0.9, 1.0], store="plane.zarr")
    >>> dict(ns.load_chart("plane.zarr").sizes)
    {'V': 2}
    """
    check_zarr()
    import xarray

    folder = Path(path)
    read_identity(folder)
    try:
        # chunks=None: no Dask; mask_and_scale would read the flags as floats
        found: Dataset = xarray.open_zarr(
            str(folder), consolidated=False, chunks=None, mask_and_scale=False
        )
    except (OSError, ValueError, KeyError) as problem:
        raise InputError(f"{folder} cannot be read: {problem}") from None
    return found[sorted(map(str, found.data_vars))]  # a folder lists its files in no order


def chart_problem(
    name: str,
    parameters: Mapping[str, Any],
    simulate: bool,
    start: Mapping[str, object] | Sequence[object] | None,
    transitions: int,
) -> tuple[Problem, tuple[Axis, ...]]:
    """What is to be computed, checked at one corner of the grid.

    Raises
    ------
    InputError
        As for `chart`.
    """
    swept = {n: v for n, v in parameters.items() if isinstance(v, Axis) or np.ndim(v)}
    if not swept:
        raise InputError("no parameter is given as a row of values: there is nothing to chart")
    axes = tuple(axis_of(n, v) for n, v in swept.items())
    fixed = {n: v for n, v in parameters.items() if n not in swept}
    problem: Problem
    if simulate:
        if start is None:
            raise InputError("the start of the motions is missing")
        problem = attractor_problem(name, fixed, list(swept), start, transitions)
    elif start is not None:
        raise InputError("a start is for motions that are simulated")
    else:
        problem = orbit_problem(name, fixed, list(swept))
    for variable in problem.variables():
        if variable.name in swept:
            raise InputError(f"{variable.name} is computed: it cannot be swept")
    corner = Grid(axes, (1,) * len(axes)).corner()
    problem.compute(corner.block(0), problem.prepare(corner))
    return problem, axes


def work_on(
    path: Path,
    problem: Problem,
    axes: tuple[Axis, ...],
    scheduler: str | None,
    chunk: int | None,
    threads: int | None,
    progress: Progress = lambda done, total: None,
) -> Work:
    """Compute what is missing in a store; errors as for `chart`."""
    usual = _usual(problem, axes, chunk)
    _check_threads(threads)
    if scheduler is not None:
        check_scheduler()
    folder = path.absolute()
    check_folder(folder)
    with locked(folder):
        store = open_store(folder, problem, axes, None if chunk is None else usual, usual)
        leftovers = store.purge()
        store.repair_axes()
        missing, damaged = store.missing()
        grid, before = store.grid, store.grid.chunks - len(missing)
        progress(before, grid.chunks)

        def told(done: int) -> None:
            progress(before + done, grid.chunks)

        arrays = open_arrays(folder, problem)

        prepared = problem.prepare(grid) if missing else np.empty(0)

        def work(number: int) -> None:
            values = problem.compute(grid.block(number), prepared)
            write_chunk(folder, arrays, grid.region(number), values)

        if not missing:
            pass
        elif scheduler is not None:
            run_cluster(scheduler, store, missing, prepared, told)
            leftovers += store.purge()  # what lost workers had begun
        else:
            run_threads(work, missing, threads, told)
    return Work(grid.chunks, len(missing), damaged, leftovers)


def _in_memory(problem: Problem, grid: Grid, threads: int | None, progress: Progress) -> Dataset:
    from xarray import Dataset

    _check_threads(threads)
    if grid.points > LARGEST_IN_MEMORY:
        raise InputError(f"{grid.points} points are for a store, not for memory")
    arrays = {v.name: np.full(grid.shape, v.fill, v.dtype) for v in problem.variables()}

    prepared = problem.prepare(grid)

    def work(number: int) -> None:
        region = grid.region(number)
        for name, part in problem.compute(grid.block(number), prepared).items():
            arrays[name][region] = part

    run_threads(work, range(grid.chunks), threads, lambda done: progress(done, grid.chunks))
    return Dataset(
        {v.name: (grid.names, arrays[v.name], v.attributes) for v in problem.variables()},
        {
            a.name: (a.name, a.part(0, a.count), problem.axis_attributes(a.name)) for a in grid.axes
        },
        {ATTRIBUTE: {"format": FORMAT, **problem.identity()}},
    )  # fmt: skip


def _usual(problem: Problem, axes: tuple[Axis, ...], chunk: int | None) -> tuple[int, ...]:
    if chunk is not None and not _positive(chunk):
        raise InputError(f"chunk = {chunk} is not a positive integer")
    return chunk_shape([axis.count for axis in axes], chunk or problem.points)


def _check_threads(threads: int | None) -> None:
    if threads is not None and not _positive(threads):
        raise InputError(f"threads = {threads} is not a positive integer")


def _positive(number: object) -> bool:
    return not isinstance(number, bool) and isinstance(number, Integral) and int(number) > 0
