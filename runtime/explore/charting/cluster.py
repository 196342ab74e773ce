"""Chunks on a Dask cluster: each worker computes chunks and writes them into the store."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import CancelledError
from contextlib import contextmanager
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError, missing_extra
from nonsmooth.runtime.explore.charting.grid import Block
from nonsmooth.runtime.explore.charting.problem import ChartProblem
from nonsmooth.runtime.explore.charting.store import Store, open_arrays, write_chunk

__all__ = ["connected", "run_cluster"]

_PATIENCE = "15s"  # for a scheduler that does not answer
_UNSEEN = "the workers do not see {}: it has to be in a folder that all of them share"
_AHEAD = 3  # chunks in the queue for each thread of the workers


@contextmanager
def connected(address: str | None) -> Iterator[Any]:
    """A context with a client of a Dask scheduler, or with None if there is no address.

    Raises `InputError` if no scheduler answers at the address (``tcp://host:port``), and
    `MissingExtra` if Dask is not installed.
    """
    if address is None:
        yield None
        return
    distributed = _distributed()
    try:  # first: a client that never began to connect takes 30 s to be closed
        distributed.comm.get_address_host_port(address)
        client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError) as problem:
        raise InputError(f"no Dask scheduler answers at {address}: {problem}") from None
    with client:
        yield client


def run_cluster(
    client: Any,
    store: Store,
    chunks: Iterable[int],
    prepared: np.ndarray,
    progress: Callable[[int], None],
) -> None:
    """Compute chunks on the workers of a scheduler; the chunks of lost workers go to others.

    The workers have to see the store under the same path. `prepared` holds what all chunks
    need of the whole grid; `progress` gets the number of chunks that are done. Raises
    `InputError` if the workers have another version of the equations, cannot write the store
    or see another one, and `NoConvergence` if workers die again and again at one chunk or the
    scheduler is lost.
    """
    queue, told, address = iter(chunks), store.problem.identity(), client.scheduler.address

    def submit(number: int) -> Any:
        grid = store.grid
        place = (str(store.path), store.problem, told, grid.region(number))
        return client.submit(_work, number, *place, grid.block(number), prepared, pure=False)

    workers = max(1, sum(client.nthreads().values()))
    running = _distributed().as_completed(
        [submit(n) for n in islice(queue, _AHEAD * workers)], loop=client.loop
    )
    for done, future in enumerate(running, 1):
        number = _result(future, address)
        if not store.holds(number):
            raise InputError(_UNSEEN.format(store.path))
        progress(done)
        for following in islice(queue, 1):
            running.add(submit(following))


def _work(
    number: int,
    path: str,
    problem: ChartProblem,
    told: Mapping[str, Any],
    region: tuple[slice, ...],
    block: Block,
    prepared: np.ndarray,
) -> int:
    """Compute and write one chunk in a worker, and return its number."""
    if problem.identity() != told:
        raise InputError("a worker has another version of the equations or of their kernels")
    folder = Path(path)
    try:
        arrays = open_arrays(folder, problem)
    except OSError:
        raise InputError(_UNSEEN.format(folder)) from None
    write_chunk(folder, arrays, region, problem.compute(block, prepared))
    return number


def _result(future: Any, address: str) -> int:
    distributed = _distributed()
    try:
        return int(future.result())
    except NonsmoothError:
        raise
    except distributed.KilledWorker:
        raise NoConvergence(
            "workers died again and again at one chunk, for want of memory perhaps: take smaller"
            " chunks, or start again to go on with what is missing"
        ) from None
    except (CancelledError, OSError):
        raise NoConvergence(
            f"the scheduler at {address} is lost: start again to go on with what is missing"
        ) from None


def _distributed() -> Any:
    """The `distributed` package of Dask, whose functions are untyped."""
    try:
        return import_module("distributed")
    except ImportError:
        raise missing_extra("chart", "dask[distributed]") from None
