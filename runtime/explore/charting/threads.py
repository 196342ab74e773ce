"""Chunks in threads of this machine, or one after the other into memory."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from itertools import islice

from nonsmooth.runtime.core.parallel import thread_pool

__all__ = ["run_threads"]


def run_threads(
    work: Callable[[int], None],
    chunks: Iterable[int],
    threads: int | None,
    progress: Callable[[int], None],
) -> None:
    """Call `work` with the number of each chunk in threads; the first failure ends it.

    `threads` None takes all processors; `progress` gets the number of chunks that are done.
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
