"""The section of benchmark.py on charts: threads, Dask workers, resuming, memory."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from benchmarking.measuring import Row

NAME = "dry-friction/global-stick"
MOST_CHUNKS = 100  # that are computed of the largest grid

# computes chunks of a plane with so many points along each axis; says its peak of memory, in KiB
_MEASURED = """
import re, sys, time
from pathlib import Path

import numpy as np
from nonsmooth.runtime.explore.charting.chart import chart_problem, work_on

class Enough(Exception):
    pass

def progress(done, total):
    if done >= int(sys.argv[3]):
        raise Enough

count = int(sys.argv[2])
axes = {name: np.linspace(0.8, 1.3, count) for name in ("V", "eta")}
begin = time.perf_counter()
problem, axes = chart_problem(sys.argv[4], axes, False, None, 0)
try:
    work_on(Path(sys.argv[1]), problem, axes, None, None, 2, progress)
except Enough:
    pass
seconds, used = time.perf_counter() - begin, time.process_time()
# of this program alone: what getrusage says includes the process that started it
peak = re.search(r"VmHWM:\\s*(\\d+)", Path("/proc/self/status").read_text())[1]
print(seconds, used, peak)
"""


def chart(quick: bool) -> Iterator[Row]:
    """Charts of the global-stick orbit with admissibility, in a store."""
    count = 300 if quick else 1000
    points = f"{count**2:,} points"
    with tempfile.TemporaryDirectory() as folder:
        yield from _computed(Path(folder) / "F.zarr", count, points, 3 if quick else 5)
        yield from _found(count, points)
        yield from _composed(40 if quick else 200)
        sizes = {count: 10**9, (1000 if quick else 3162): 10**9, 31623: MOST_CHUNKS}
        for side, most in sizes.items():
            store = Path(folder) / f"{side}.zarr"
            command = [sys.executable, "-c", _MEASURED, str(store), str(side), str(most), NAME]
            told = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            seconds, used, peak = told.split()
            part = f"{most} chunks of " if most < 10**9 else ""
            size = sum(f.stat().st_size for f in store.rglob("*") if f.is_file())
            label = f"{part}{side**2:,} points: peak {int(peak) / 1024:.0f} MiB"
            label += f", {float(used):.3g} s of processors, store {size / 2**20:.0f} MiB"
            yield Row(label, [float(seconds)])
            shutil.rmtree(store)


def _found(count: int, points: str) -> Iterator[Row]:
    """Rows on the orbits that a chart finds from anchors, and those found point by point."""
    import nonsmooth as ns

    planes: dict[str, dict[str, tuple[float, float]]] = {
        "near": {"V": (0.8, 1.3), "eta": (0.8, 1.3)},
        "wide": {"V": (0.3, 2), "eta": (0.3, 3)},
    }
    for name, plane in planes.items():
        (first, rows), (second, columns) = (
            (label, np.linspace(*ends, count)) for label, ends in plane.items()
        )
        begin = time.perf_counter()
        chart = ns.chart(NAME, threads=2, **{first: rows, second: columns})
        middle = time.perf_counter()
        alone = ns.solve(NAME, {first: rows[:, None], second: columns}, threads=2)
        end = time.perf_counter()
        for way, seconds, status, period in (
            ("by anchors", middle - begin, chart.status.values, chart.period.values),
            ("point by point", end - middle, alone.status, alone.period),
        ):
            label = f"{points}, {name}, {way}: {np.sum(status != 0):,} not found"
            yield Row(f"{label}, {_speckles(period):,} speckles", [seconds])


def _speckles(period: np.ndarray) -> int:
    """Number of points whose period is 5 % off all four neighbours, which agree."""
    inner = period[1:-1, 1:-1]
    beside = np.stack([period[:-2, 1:-1], period[2:, 1:-1], period[1:-1, :-2], period[1:-1, 2:]])
    mean = beside.mean(axis=0)
    agree = (np.abs(beside - mean) < 0.05 * mean).all(axis=0)
    return int((agree & (np.abs(inner - beside) > 0.05 * mean).all(axis=0)).sum())


def _composed(count: int) -> Iterator[Row]:
    """Rows for orbits without equations of their own: closed-form flows, and eigenvalues."""
    import nonsmooth as ns

    folder = Path(__file__).resolve().parents[2] / "docs" / "gallery"
    for orbit, plane in (
        ("impact_oscillator.py:one-period", {"sigma": (-0.6, 0.6), "w": (1.6, 3.2)}),
        ("piecewise_stiffness.py:subharmonic", {"w": (2, 4), "gap": (-0.2, 0.6)}),
    ):
        axes = {name: np.linspace(*ends, count) for name, ends in plane.items()}
        begin = time.perf_counter()
        ns.chart(str(folder / orbit), threads=1, **axes)
        seconds = time.perf_counter() - begin
        yield Row(f"composed, {count**2:,} points of {orbit}, one thread", [seconds])


def _computed(store: Path, count: int, points: str, runs: int) -> Iterator[Row]:
    """Rows with times of threads, workers and resumed runs, each measured several times."""
    import nonsmooth as ns

    try:
        from distributed import LocalCluster
    except ImportError:
        return
    plane = {name: np.linspace(0.8, 1.3, count) for name in ("V", "eta")}
    small = {name: values[:64] for name, values in plane.items()}
    found: dict[str, list[float]] = {"threads": [], "workers": [], "missing": [], "nothing": []}
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as cluster:
        address = cluster.scheduler_address
        # both workers load the kernels before anything counts
        ns.chart(NAME, store=store, scheduler=address, chunk=64, **small)
        for _ in range(runs):
            for way in ("threads", "workers"):
                shutil.rmtree(store)
                begin = time.perf_counter()
                ns.chart(
                    NAME,
                    store=store,
                    threads=2,
                    scheduler=address if way == "workers" else None,
                    **plane,
                )
                found[way].append(time.perf_counter() - begin)
            objects = sorted((store / "trace" / "c").glob("*/*"))
            for file in objects[:: max(1, len(objects) // 4)]:
                file.unlink()
            for way in ("missing", "nothing"):
                begin = time.perf_counter()
                ns.chart(NAME, store=store, threads=2, **plane)
                found[way].append(time.perf_counter() - begin)
    whole = float(np.median(found["threads"]))
    share = len(objects[:: max(1, len(objects) // 4)]) / len(objects)
    first = f"{points}, two threads"
    yield Row(first, found["threads"], 10.0)
    yield Row("the same, two Dask workers", found["workers"], 1.25 * whole, first)
    yield Row(f"resumed, {share:.0%} of it missing", found["missing"], share * whole + 2, first)
    yield Row("resumed, nothing missing", found["nothing"], 2.0, first)
