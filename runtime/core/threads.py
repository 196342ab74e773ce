"""Work in threads that ends, compiled loops included, when its caller is interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

__all__ = ["check_called_off", "in_parallel", "thread_pool"]

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


def in_parallel(work: Callable[[int], object], parts: Sequence[int], threads: int | None) -> None:
    """Call `work` for each part, in threads where that pays.

    It stores its results itself. Python chooses the number of threads if it is None.
    """
    if threads == 1 or len(parts) < 2:
        for part in parts:
            work(part)
        return
    with thread_pool(threads) as pool:
        list(pool.map(work, parts))


def _begin(ends: tuple[threading.Event, ...]) -> None:
    _here.ends = ends


def check_called_off() -> None:
    """Raise KeyboardInterrupt if the work of this thread is called off."""
    if any(event.is_set() for event in getattr(_here, "ends", ())):
        raise KeyboardInterrupt
