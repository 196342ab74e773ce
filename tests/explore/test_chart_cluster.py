"""Charts on a Dask cluster of real worker processes, one of which is killed."""

import os
import signal
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError, MissingExtra
from tests.explore.test_chart import contents
from tests.explore.test_chart_basins import DATA, STARTS, two_attractors

ORBIT = "dry-friction/global-stick"
SOON = {"timeout": "300ms"}
PLANE = {"V": np.linspace(0.8, 1.3, 50), "eta": np.linspace(0.8, 1.3, 50)}


@pytest.fixture(scope="module")
def cluster():
    """Two worker processes."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as found:
        yield found


@pytest.mark.slow
@pytest.mark.parametrize("basins", [False, True])
def test_killed_worker_costs_only_its_chunk(basins, cluster, tmp_path):
    killed = []

    def progress(done, total):
        if done >= total // 4 and not killed:
            killed.append(cluster.workers[0].pid)
            os.kill(killed[0], signal.SIGKILL)

    name, chunk, plane = ORBIT, 100, PLANE
    if basins:
        name, chunk, plane = str(tmp_path / "found.json"), 4, STARTS
        ns.find_orbits(two_attractors(), DATA, 40, transitions=200).save(name)
    store, address = tmp_path / "cluster.zarr", cluster.scheduler_address
    ns.chart(name, store=store, scheduler=address, chunk=chunk, progress=progress, **plane)
    assert killed
    ns.chart(name, store=tmp_path / "threads.zarr", chunk=chunk, **plane)
    assert contents(store) == contents(tmp_path / "threads.zarr")


@pytest.mark.slow
def test_workers_refuse_other_equations(cluster, tmp_path):
    from nonsmooth.runtime.model.kernels import load_orbit

    table = load_orbit(ORBIT).table
    table["unheard"] = "of"  # of this process, whose workers have the table without it
    try:
        with pytest.raises(InputError, match="another version of the equations"):
            ns.chart(ORBIT, chunk=400, store=tmp_path / "F.zarr",
                     scheduler=cluster.scheduler_address, **PLANE)  # fmt: skip
    finally:
        del table["unheard"]


@pytest.mark.slow
@pytest.mark.parametrize("moved", [False, True])
def test_workers_that_do_not_see_the_folder(moved, cluster, tmp_path, monkeypatch):
    """What they have written is elsewhere, or the folder is moved when the first chunk is done."""
    store, is_file = tmp_path / "F.zarr", Path.is_file

    def move(done, total):
        if moved and done == 1:
            store.rename(tmp_path / "elsewhere")

    if not moved:
        monkeypatch.setattr(Path, "is_file", lambda path: path.name != "0" and is_file(path))
    told = r"do not see .*F\.zarr" + r"|cannot write .*F\.zarr" * moved
    with pytest.raises(InputError, match=told):
        ns.chart(ORBIT, store=store, scheduler=cluster.scheduler_address,
                 chunk=400 if moved else 4000, progress=move, **PLANE)  # fmt: skip


def test_absent_scheduler(tmp_path, monkeypatch):
    distributed = pytest.importorskip("distributed")
    client = distributed.Client
    monkeypatch.setattr(  # who waits less
        distributed, "Client", lambda address, **options: client(address, **options | SOON)
    )
    with pytest.raises(InputError, match=r"no Dask scheduler answers at tcp://127\.0\.0\.1:9"):
        ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler="tcp://127.0.0.1:9", **PLANE)
    monkeypatch.setattr("distributed.Client", None)  # one that never began takes long to close
    for address in ("nowhere://x", "nonsense", "tcp://x:y", ""):
        with pytest.raises(InputError, match=f"no Dask scheduler answers at {address}: "):
            ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler=address, **PLANE)
    monkeypatch.setitem(__import__("sys").modules, "distributed", None)
    with pytest.raises(MissingExtra, match="dask"):
        ns.chart(ORBIT, store=tmp_path / "F.zarr", scheduler="tcp://127.0.0.1:9", **PLANE)
