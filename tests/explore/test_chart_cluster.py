"""Charts on a Dask cluster of real worker processes, one of which is killed."""

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError, MissingExtra
from nonsmooth.runtime.explore.charting import cluster as clusters
from nonsmooth.runtime.explore.charting.chart import chart_problem
from nonsmooth.runtime.explore.charting.grid import Grid
from nonsmooth.runtime.explore.charting.store import Store

ORBIT = "dry-friction/global-stick"
PLANE: dict[str, Any] = {"V": np.linspace(0.8, 1.3, 150), "eta": np.linspace(0.8, 1.3, 150)}


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """Two worker processes."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as found:
        yield found


def contents(store: Path) -> dict[str, bytes]:
    """All files of a store."""
    return {
        str(path.relative_to(store)): path.read_bytes()
        for path in store.rglob("*")
        if path.is_file()
    }


@pytest.mark.slow
def test_killed_worker_costs_only_its_chunk(cluster: Any, tmp_path: Path) -> None:
    killed: list[int] = []

    def progress(done: int, total: int) -> None:
        if done >= total // 4 and not killed:
            killed.append(cluster.workers[0].pid)
            os.kill(killed[0], signal.SIGKILL)

    store, address = tmp_path / "cluster.zarr", cluster.scheduler_address
    ns.chart(ORBIT, store=store, scheduler=address, chunk=400, progress=progress, **PLANE)
    assert killed
    ns.chart(ORBIT, store=tmp_path / "threads.zarr", chunk=400, **PLANE)
    assert contents(store) == contents(tmp_path / "threads.zarr")


@pytest.mark.slow
def test_workers_refuse_other_equations(
    cluster: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from nonsmooth.runtime.explore.charting import orbits

    monkeypatch.setattr(orbits, "table_hash", lambda table: "other")
    options = {"store": tmp_path / "F.zarr", "scheduler": cluster.scheduler_address}
    with pytest.raises(InputError, match="another version of the equations"):
        ns.chart(ORBIT, chunk=400, **options, **PLANE)


@pytest.mark.slow
def test_workers_that_see_another_folder(
    cluster: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Store, "holds", lambda store, number: False)
    options = {"store": tmp_path / "F.zarr", "scheduler": cluster.scheduler_address}
    with pytest.raises(InputError, match=r"do not see .*F\.zarr"):
        ns.chart(ORBIT, chunk=4000, **options, **PLANE)


def test_worker_that_sees_no_folder(tmp_path: Path) -> None:
    problem, axes = chart_problem(ORBIT, PLANE, False, None, 0)
    grid = Grid(axes, (10, 10))
    task = (problem, problem.identity(), grid.region(0), grid.block(0), problem.prepare(grid))
    with pytest.raises(InputError, match=r"do not see .*absent"):
        clusters._work(0, str(tmp_path / "absent"), *task)


def test_absent_scheduler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clusters, "_PATIENCE", "300ms")
    with pytest.raises(InputError, match=r"no Dask scheduler answers at tcp://127\.0\.0\.1:9"):
        ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler="tcp://127.0.0.1:9", **PLANE)
    monkeypatch.setattr("distributed.Client", None)  # one that never began takes long to close
    for address in ("nowhere://x", "nonsense", "tcp://x:y", ""):
        with pytest.raises(InputError, match=f"no Dask scheduler answers at {address}: "):
            ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler=address, **PLANE)
    monkeypatch.setitem(__import__("sys").modules, "distributed", None)
    with pytest.raises(MissingExtra, match="dask"):
        ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler="tcp://127.0.0.1:9", **PLANE)
