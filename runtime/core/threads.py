"""Work in threads that ends, compiled loops included, when its caller is interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TypeVar

__all__ = ["check_called_off", "in_parallel", "thread_pool"]

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
