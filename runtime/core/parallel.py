"""Work in threads and in processes, which ends when its caller is interrupted.

Compiled loops in threads end too. A process is a new interpreter that is told by pickles what to
do, so that nothing of the caller's program is run again in it.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from typing import IO, Any, NamedTuple, TypeVar

from nonsmooth.runtime.core.errors import NoConvergence, check_integer

Part = TypeVar("Part")
Result = TypeVar("Result")

_here = threading.local()  # `ends`: events that call off the work of this thread


@contextmanager
def thread_pool(threads: int | None) -> Iterator[ThreadPoolExecutor]:
    """Give a pool of threads whose work is called off when an exception leaves the block.

    Work that is under way ends too: loops in C ask `check_called_off` every 30 ms. Python
    chooses the number of threads if it is None.
    """
    ends = threading.Event()
    all_ends = (*getattr(_here, "ends", ()), ends)  # those of the pools around this one too
    pool = ThreadPoolExecutor(threads, initializer=_begin, initargs=(all_ends,))
    try:
        yield pool
    except BaseException:
        ends.set()
        pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()


def in_parallel(
    work: Callable[[Part], Result], parts: Sequence[Part], threads: int | None
) -> list[Result]:
    """Return what `work` gives for each part, in their order; in threads where that pays.

    Python chooses the number of threads if it is None.
    """
    if threads == 1 or len(parts) < 2:
        return [work(part) for part in parts]
    with thread_pool(threads) as pool:
        return list(pool.map(work, parts))


def _begin(ends: tuple[threading.Event, ...]) -> None:
    _here.ends = ends


def check_called_off() -> None:
    """Raise KeyboardInterrupt if the work of this thread is called off."""
    if any(event.is_set() for event in getattr(_here, "ends", ())):
        raise KeyboardInterrupt


_CHILD = "from nonsmooth.runtime.core.parallel import serve; serve()"
_MOST = 1024
_AHEAD = 1  # batches beyond those that are worked on

Given = TypeVar("Given")
Batch = TypeVar("Batch")
Found = TypeVar("Found")


class _Raised(NamedTuple):
    """An exception that a process raised in place of an answer."""

    problem: Exception


def check_workers(workers: int) -> None:
    """Raise `InputError` unless the number of processes is an integer from 1 to 1024."""
    check_integer("workers", workers, 1, _MOST)


def in_processes(
    begin: Callable[[Given], Callable[[Batch], Found]],
    given: Given,
    batches: Iterable[Batch],
    workers: int,
) -> Generator[tuple[Batch, Found], None, None]:
    """Pairs of a batch and what the work makes of it, in the order of the batches.

    The work is done in `workers` processes, which end when the generator is closed; a
    single worker is this process. `begin`, a function of a module, makes of `given` the
    function that does one batch; it is called once in each process. Everything that goes
    to a process and back has to be picklable. The next batch is taken when a process is
    about to need it. Raises `NoConvergence` if a process ends before its work does, for
    want of memory perhaps.
    """
    if workers == 1:
        work = begin(given)
        for batch in batches:
            yield batch, work(batch)
        return
    waiting: deque[tuple[Batch, Future[Found]]] = deque()
    with _processes(begin, given, workers) as submit:
        for batch in batches:
            waiting.append((batch, submit(batch)))
            if len(waiting) == workers + _AHEAD:
                batch, future = waiting.popleft()
                yield batch, future.result()
        for batch, future in waiting:
            yield batch, future.result()


@contextmanager
def _processes(begin: Any, given: Any, workers: int) -> Iterator[Callable[[Any], Future[Any]]]:
    """Give a function that submits a batch to the next free process.

    The processes end with the block.
    """
    told, own = pickle.dumps((begin, given)), threading.local()
    started: list[subprocess.Popen[bytes]] = []

    def start() -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-P", "-c", _CHILD],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,  # an interrupt of the terminal is the caller's
        )
        started.append(process)
        own.process = process
        return process

    def ask(batch: Any) -> Any:
        process = getattr(own, "process", None)
        try:
            if process is None:
                process = start()
                _pipe(process.stdin).write(told)
            pickle.dump(batch, _pipe(process.stdin))
            _pipe(process.stdin).flush()
            found = pickle.load(_pipe(process.stdout))
        except (EOFError, OSError):
            raise NoConvergence(
                "a process that did a part of the work ended, for want of memory perhaps: take"
                " fewer workers, or go on from what was saved"
            ) from None
        if isinstance(found, _Raised):
            raise found.problem
        return found

    pool = ThreadPoolExecutor(workers)  # each of its threads has a process
    try:
        yield lambda batch: pool.submit(ask, batch)
    finally:
        for process in started:
            process.kill()
        pool.shutdown(cancel_futures=True)
        for process in started:
            process.wait()
            for pipe in (process.stdin, process.stdout):
                with suppress(OSError):  # what a process that was killed had not read
                    _pipe(pipe).close()


def _pipe(end: IO[bytes] | None) -> IO[bytes]:
    """The end of a pipe that was asked for."""
    assert end is not None
    return end


def serve() -> None:
    """Read batches from standard input and answer each: the work of such a process."""
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what is printed does not come between the answers
        begin, given = pickle.load(sys.stdin.buffer)
        work = None
        while True:
            try:
                batch = pickle.load(sys.stdin.buffer)
            except EOFError:
                return
            try:
                work = work or begin(given)
                found = work(batch)
            except Exception as problem:
                found = _Raised(problem)
            pickle.dump(found, answers)
            answers.flush()
