"""Chunks in threads of this machine, or one after the other into memory."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from itertools import islice

from nonsmooth.runtime.core.threads import thread_pool

__all__ = ["run_threads"]


def run_threads(
    work: Callable[[int], None],
    chunks: Iterable[int],
    threads: int | None,
    progress: Callable[[int], None],
) -> None:
    """Do the work of all chunks; the first failure ends it.

    Parameters
    ----------
    work : callable
        Computes the chunk of this number and keeps it.
    chunks : iterable of int
    threads : int, optional
        As many as processors when omitted.
    progress : callable
        Told how many chunks are done.
    """
    workers, queue, done = threads or os.cpu_count() or 1, iter(chunks), 0
    with thread_pool(workers) as pool:
        running: set[Future[None]] = {pool.submit(work, n) for n in islice(queue, 2 * workers)}
        while running:
            ended, running = wait(running, return_when=FIRST_COMPLETED)
            for future in ended:
                future.result()
                done += 1
            running |= {pool.submit(work, n) for n in islice(queue, len(ended))}
            progress(done)
