"""Who computes the chunks of a chart: threads, or a cluster's workers, for one process at a time.

Each worker of a Dask cluster computes chunks and writes them into the store. The system lets go of
the lock of a store when the process that holds it dies.
"""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from contextlib import contextmanager, suppress
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, missing_extra
from nonsmooth.runtime.core.files import unwritable
from nonsmooth.runtime.core.parallel import thread_pool
from nonsmooth.runtime.explore.charting.grid import Block
from nonsmooth.runtime.explore.charting.problem import ChartProblem
from nonsmooth.runtime.explore.charting.store import Store, open_arrays, write_chunk

Result = TypeVar("Result")

_TRIES = 20
_FAR = 1 << 20  # a byte behind the text: what is locked cannot be read on some systems
_PATIENCE = "15s"  # for a scheduler that does not answer
_UNSEEN = "the workers do not see {}: it has to be in a folder that all of them share"
_AHEAD = 3  # chunks in the queue for each thread of the workers


def run_threads(
    work: Callable[[int], None],
    chunks: Iterable[int],
    threads: int | None,
    progress: Callable[[int], None],
) -> None:
    """Call `work` with the number of each chunk in threads; the first failure ends it.

    `threads` None takes all processors; `progress` gets the number of chunks that are done.
    """
    workers = threads or os.cpu_count() or 1
    with thread_pool(workers) as pool:
        ended = _ended(lambda number: pool.submit(work, number), chunks, 2 * workers)
        for done, _ in enumerate(ended, 1):
            progress(done)


def _ended(
    submit: Callable[[int], Future[Result]], chunks: Iterable[int], ahead: int
) -> Iterator[Result]:
    """What each chunk gives, as soon as it is done; so many chunks are in the queue."""
    queue = iter(chunks)
    running = {submit(number) for number in islice(queue, ahead)}
    while running:
        ended, running = wait(running, return_when=FIRST_COMPLETED)
        for future in ended:
            yield future.result()
        running |= {submit(number) for number in islice(queue, len(ended))}


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """A context that holds the lock file PATH.lock beside a store.

    The lock of a killed process is taken over. Raises `InputError` if another process holds
    it (with its number and host) or if the file cannot be written.
    """
    file = path.with_name(f"{path.name}.lock")
    try:
        descriptor = _acquire(file)
    except OSError as problem:
        raise unwritable(file, problem) from None
    if descriptor is None:
        raise InputError(f"{path} is being computed by {_holder(file)}: wait, or end that first")
    try:
        os.ftruncate(descriptor, 0)
        os.lseek(descriptor, 0, os.SEEK_SET)
        os.write(descriptor, f"process {os.getpid()} on {socket.gethostname()}".encode())
        yield
    finally:
        with suppress(OSError):  # some systems keep files that are open
            if os.path.samestat(os.fstat(descriptor), os.stat(file)):  # it may be lost
                file.unlink()
        os.close(descriptor)


def _acquire(file: Path) -> int | None:
    """Open and lock the file; None if another process holds it."""
    for _ in range(_TRIES):
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o644)
        if not _lock(descriptor):
            os.close(descriptor)
            return None
        try:
            if os.path.samestat(os.fstat(descriptor), os.stat(file)):
                return descriptor
        except FileNotFoundError:
            pass
        os.close(descriptor)  # who held it has removed it in the meantime
    return None


def _lock(descriptor: int) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            os.lseek(descriptor, _FAR, os.SEEK_SET)
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    return True


def _holder(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8") or "another process"
    except OSError:
        return "another process"


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
    distributed, told, grid = _distributed(), store.problem.identity(), store.grid
    executor, address = client.get_executor(pure=False), client.scheduler.address

    def submit(number: int) -> Any:
        place = (str(store.path), store.problem, told, grid.region(number))
        return executor.submit(_work, number, *place, grid.block(number), prepared)

    ahead = _AHEAD * max(1, sum(client.nthreads().values()))
    try:
        for done, number in enumerate(_ended(submit, chunks, ahead), 1):
            if not store.holds(number):
                raise InputError(_UNSEEN.format(store.path))
            progress(done)
    except distributed.KilledWorker:
        raise NoConvergence(
            "workers died again and again at one chunk, for want of memory perhaps: take smaller"
            " chunks, or start again to go on with what is missing"
        ) from None
    except (CancelledError, OSError):
        raise NoConvergence(
            f"the scheduler at {address} is lost: start again to go on with what is missing"
        ) from None


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


def _distributed() -> Any:
    """The `distributed` package of Dask, whose functions are untyped."""
    try:
        return import_module("distributed")
    except ImportError:
        raise missing_extra("chart", "dask[distributed]") from None
