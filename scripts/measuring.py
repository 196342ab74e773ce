"""What the benchmark's sections share: rows of a table, and timing."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Row", "interleaved", "timed"]


@dataclass(frozen=True)
class Row:
    """One measured thing: seconds per unit of work, of several runs.

    `must` is the limit it has to meet; a peer names in `against` the row it is compared with.
    """

    what: str
    seconds: list[float]
    must: float | None = None
    against: str | None = None

    @property
    def median(self) -> float:
        """Median of the runs."""
        return statistics.median(self.seconds)


def timed(work: Callable[[], object], units: float = 1, runs: int = 7) -> list[float]:
    """Seconds per unit of several runs, after one that does not count."""
    work()
    found = []
    for _ in range(runs):
        begin = time.perf_counter()
        work()
        found.append((time.perf_counter() - begin) / units)
    return found


def interleaved(
    works: dict[str, tuple[Callable[[], object], float]], runs: int
) -> dict[str, list[float]]:
    """Seconds per unit of several works, one run of each after the other."""
    found: dict[str, list[float]] = {name: [] for name in works}
    for work, _ in works.values():
        work()
    for _ in range(runs):
        for name, (work, units) in works.items():
            begin = time.perf_counter()
            work()
            found[name].append((time.perf_counter() - begin) / units)
    return found
