"""What the benchmark's sections share: rows of a table, and timing."""

from __future__ import annotations

import multiprocessing
import os
import platform
import re
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

PACKAGES = ("nonsmooth", "numpy", "scipy", "sympy", "python-flint", "casadi", "heyoka", "diffrax")


@dataclass(frozen=True)
class Row:
    """One measured quantity: seconds per unit of work in several runs.

    `must` is the limit that it has to meet; a peer names in `against` the row with which it
    is compared; `found` says what was computed, and how far off it is.
    """

    what: str
    seconds: list[float]
    must: float | None = None
    against: str | None = None
    found: str = ""

    @property
    def median(self) -> float:
        """Median of the runs."""
        return statistics.median(self.seconds)


def told(text: str) -> None:
    """Print a line of progress."""
    print(f"  {text}", file=sys.stderr, flush=True)


def timed(work: Callable[[], object], units: float = 1, runs: int = 7) -> list[float]:
    """Seconds per unit of several runs, after one that is not counted."""
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
    """Seconds per unit of several works by name, one run of each after the other."""
    found: dict[str, list[float]] = {name: [] for name in works}
    for work, _ in works.values():
        work()
    for _ in range(runs):
        for name, (work, units) in works.items():
            begin = time.perf_counter()
            work()
            found[name].append((time.perf_counter() - begin) / units)
    return found


def machine() -> dict[str, object]:
    """What the figures depend on: processor, system, compiler, versions and other load."""
    return {
        "processor": processor(),
        "cores": os.cpu_count(),
        "load": round(os.getloadavg()[0], 1),
        "system": f"{platform.system()} {platform.machine()}",
        "compiler": compiler(),
        "python": platform.python_version(),
        "versions": {name: found for name in PACKAGES if (found := installed(name))},
    }


def processor() -> str:
    """Name of the processor, as far as the system tells it."""
    try:
        told = Path("/proc/cpuinfo").read_text("utf-8")
    except OSError:
        return platform.processor()
    found = re.search(r"model name\s*: (.*)", told)
    return found[1] if found else platform.processor()


def compiler() -> str:
    """First line of the C compiler's version text."""
    told = subprocess.run(["cc", "--version"], capture_output=True, text=True, check=False).stdout
    return told.partition("\n")[0]


def installed(name: str) -> str | None:
    """Version of a package, if it is there."""
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def apart(work: Callable[..., Any], *arguments: object, limit: float = 600.0) -> Any:
    """Result of a work in a process of its own with one thread; None after the time limit."""
    os.environ |= {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}  # what children inherit
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_send, args=(sender, work, arguments))
    process.start()
    sender.close()
    try:
        return receiver.recv() if receiver.poll(limit) else None
    finally:
        process.terminate()
        process.join()


def _send(sender: Connection, work: Callable[..., Any], arguments: tuple[object, ...]) -> None:
    sender.send(work(*arguments))
