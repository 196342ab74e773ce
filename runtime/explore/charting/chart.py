"""Charts of the parameter plane: what is missing is computed, then the chart is opened."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NonsmoothError
from nonsmooth.runtime.core.files import check_folder, folder_made
from nonsmooth.runtime.core.workload import BYTES, check_memory
from nonsmooth.runtime.explore.charting.grid import Axes, Grid, axis_of, chunk_shape
from nonsmooth.runtime.explore.charting.problem import (
    ChartProblem,
    attractor_problem,
    basin_problem,
    held_attractor_problem,
    held_basin_problem,
    held_orbit_chart,
    is_found,
    orbit_chart,
)
from nonsmooth.runtime.explore.charting.store import (
    ATTRIBUTE,
    FORMAT,
    check_zarr,
    open_arrays,
    open_store,
    read_axes,
    read_identity,
    reader,
    write_chunk,
)
from nonsmooth.runtime.explore.charting.workers import connected, locked, run_cluster, run_threads
from nonsmooth.runtime.simulation.simulate import checked_count

if TYPE_CHECKING:
    from xarray import Dataset

TRANSITIONS = 2000
MOST_THREADS = 1024
LARGEST_IN_MEMORY = 1 << 24  # points

Progress = Callable[[int, int], None]
_HELD: dict[str, Callable[..., ChartProblem]] = {
    "orbit": held_orbit_chart,
    "attractors": held_attractor_problem,
    "basins": held_basin_problem,
}


@dataclass(frozen=True)
class Work:
    """How much of a chart was computed."""

    chunks: int  # of the whole chart
    computed: int  # chunks computed this time
    damaged: int  # of the computed chunks those that were damaged before
    leftovers: int  # files that a killed writer had left


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
        As for `solve`; with `simulate` the name of a system. A file of found orbits,
        ``found.json``: their basins over states. The folder F.zarr of a chart that is begun,
        alone, goes on with it: it holds its orbit, and no other file is read.
    store : path, optional
        A folder F.zarr, begun or gone on with; memory does not grow with the number of
        points. None keeps the chart in memory.
    simulate : bool
        Where motions settle instead: how many transitions and what time the periodic motion
        takes that is reached from `start`.
    start : mapping of state to number, or sequence
        Of these motions; of basins the states that are not swept, 0 and the phase 0 of a
        forcing where they are not named. A sequence has all states: of basins, what it says of
        swept ones is not read.
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
        given too: admissibility is then judged for them. Rows of states for basins.

    Returns
    -------
    xarray.Dataset
        `status`, `admissible`, `limit` (what fails first), `trace`, `margin` (positive:
        stable), `period`, the unknowns, and what open parameters have to exceed; their
        attributes say what numbers mean. Of basins the `attractor`, counted from 1. Read when
        it is used, if there is a store.

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
    if isinstance(orbit, str | Path) and is_begun(str(orbit)):
        if parameters or simulate or start is not None or store is not None:
            raise InputError(f"{orbit} is a chart that is begun: it holds all that it is of")
        work_on(Path(orbit), *begun_problem(Path(orbit)), scheduler, chunk, threads, progress)
        return load_chart(orbit)
    problem, axes = chart_problem(orbit, parameters, simulate, start, transitions)
    if store is not None:
        work_on(Path(store), problem, axes, scheduler, chunk, threads, progress)
        return load_chart(store)
    if scheduler is not None:
        raise InputError("a chart on a cluster needs a store")
    return _in_memory(problem, axes, chunk, threads, progress)


def load_chart(path: str | Path) -> Dataset:
    """A chart from its folder, complete or not, with the parameters as dimensions.

    Its numbers are read when they are used. Where nothing is computed yet, `status` is -128.
    Raises `InputError` if there is no chart, or if its metadata is damaged or edited, and
    `MissingExtra` if Zarr or xarray are not installed.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> made = ns.chart("dry-friction/global-stick", V=[0.9, 1.0], store="plane.zarr")
    >>> dict(ns.load("plane.zarr").sizes)
    {'V': 2}
    """
    check_zarr()
    import xarray

    folder = Path(path)
    store = reader(folder)
    try:
        # chunks=None: no Dask; mask_and_scale would read the flags as floats
        found: Dataset = xarray.open_zarr(
            store, consolidated=False, chunks=None, mask_and_scale=False, zarr_format=3
        )
    except Exception as problem:  # what a store raises that is no chart is not one kind
        raise InputError(f"{folder} cannot be read: {problem}") from None
    found.attrs[ATTRIBUTE] = {n: x for n, x in found.attrs[ATTRIBUTE].items() if n != "held"}
    return found[sorted(map(str, found.data_vars))]  # a folder lists its files in no order


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """A context in which errors from damaged numbers of a chart become `InputError`.

    Messages name `path`.
    """
    try:
        yield
    except NonsmoothError:
        raise
    except (ArithmeticError, LookupError, OSError, TypeError, ValueError) as problem:
        raise InputError(
            f"{path} is damaged: {problem}: `nonsmooth chart` computes it again"
        ) from problem


def chart_problem(
    name: str,
    parameters: Mapping[str, Any],
    simulate: bool,
    start: Mapping[str, object] | Sequence[object] | None,
    transitions: int,
) -> tuple[ChartProblem, Axes]:
    """The problem and the axes of a chart, with all names checked.

    `name` is that of an orbit, of a system if motions are simulated, or of a file of found
    orbits. Parameters that are arrays are swept. `start` and `transitions` belong
    to the simulated motions. Raises `InputError` as `chart` does.
    """
    swept = {n: v for n, v in parameters.items() if np.ndim(v)}
    if not swept:
        raise InputError("no parameter is given as a row of values: there is nothing to chart")
    axes = {n: axis_of(n, v) for n, v in swept.items()}
    fixed = {n: v for n, v in parameters.items() if n not in swept}
    problem: ChartProblem
    if is_found(name):
        if simulate:
            raise InputError(f"basins are simulated anyway: {name} is charted without simulate")
        problem = basin_problem(name, fixed, list(swept), start)
    elif simulate:
        if start is None:
            raise InputError("the start of the motions is missing")
        problem = attractor_problem(name, fixed, list(swept), start, transitions)
    elif start is not None:
        raise InputError("a start is for motions that are simulated")
    else:
        problem = orbit_chart(name, fixed, list(swept), math.prod(map(len, axes.values())))
    for variable in problem.variables():
        if variable.name in swept:
            raise InputError(f"{variable.name} is computed: it cannot be swept")
    return problem, axes


def begun_problem(path: Path) -> tuple[ChartProblem, Axes]:
    """The problem and the axes of a chart in a store, from the store alone.

    Raises `InputError` if it is no chart, if it is damaged or edited, or if its kernels were
    compiled elsewhere.
    """
    identity, held = read_identity(path)
    problem: ChartProblem
    try:
        problem = _HELD[identity["kind"]](identity, held)
        here = problem.identity()["kernels"]
    except InputError as failure:
        raise InputError(f"{path}: {failure}") from None
    except (ArithmeticError, LookupError, TypeError, ValueError) as failure:
        raise InputError(f"{path} does not hold what it is of: {failure}") from None
    if identity.get("kernels") != here:
        raise InputError(
            f"{path} was computed by kernels in {identity.get('kernels')}, here they are in {here}:"
            " name its orbit as it was named first"
        )
    return problem, read_axes(path)


def is_begun(name: str) -> bool:
    """Whether a name is that of a folder with a chart that has been begun."""
    return Path(name, "zarr.json").is_file()


def work_on(
    path: Path,
    problem: ChartProblem,
    axes: Axes,
    scheduler: str | None,
    chunk: int | None,
    threads: int | None,
    progress: Progress = lambda done, total: None,
) -> Work:
    """Compute the missing chunks of a chart in a store, and return how much was computed.

    `scheduler` is the address of a Dask scheduler; None computes in this process. `chunk` is
    roughly the number of points of a chunk; None takes the store's chunks, or the usual ones.
    `threads` None takes all processors. `progress` gets the number of chunks that are done and
    of all. Raises `InputError` as `chart` does, and `MissingExtra` if Dask is needed and not
    installed.
    """
    usual = _checked(problem, axes, chunk, threads)
    check_folder(path)
    folder = path.absolute()
    with connected(scheduler) as client, folder_made(folder.parent), locked(folder):
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
        elif client is not None:
            run_cluster(client, store, missing, prepared, told)
            leftovers += store.purge()  # what lost workers had begun
        else:
            run_threads(work, missing, threads, told)
    return Work(grid.chunks, len(missing), damaged, leftovers)


def _in_memory(
    problem: ChartProblem, axes: Axes, chunk: int | None, threads: int | None, progress: Progress
) -> Dataset:
    from xarray import Dataset

    points = math.prod(map(len, axes.values()))
    if points > LARGEST_IN_MEMORY:
        raise InputError(f"{points} points are for a store, not for memory")
    grid = Grid(axes, _checked(problem, axes, chunk, threads))
    arrays = {v.name: np.full(grid.shape, v.fill, v.dtype) for v in problem.variables()}

    prepared = problem.prepare(grid)

    def work(number: int) -> None:
        region = grid.region(number)
        for name, part in problem.compute(grid.block(number), prepared).items():
            arrays[name][region] = part

    run_threads(work, range(grid.chunks), threads, lambda done: progress(done, grid.chunks))
    return Dataset(
        {v.name: (grid.names, arrays[v.name], v.attributes) for v in problem.variables()},
        {name: (name, row, problem.axis_attributes(name)) for name, row in grid.axes.items()},
        {ATTRIBUTE: {"format": FORMAT, **problem.identity()}},
    )


def _checked(
    problem: ChartProblem, axes: Axes, chunk: int | None, threads: int | None
) -> tuple[int, ...]:
    """The usual shape of a chunk, after a check of all that can be wrong with a chart."""
    if threads is not None:
        checked_count("threads", threads, 1, MOST_THREADS)
    points = problem.points if chunk is None else checked_count("chunk", chunk, 1)
    found = chunk_shape([len(row) for row in axes.values()], points)
    chunks = Grid(axes, found).chunks
    check_memory(f"the numbers of {chunks} chunks", 5 * BYTES * chunks)
    # an error that is the same everywhere shows at one corner already
    corner = Grid({name: row[:1] for name, row in axes.items()}, (1,) * len(axes))
    problem.compute(corner.block(0), problem.prepare(corner))
    return found
