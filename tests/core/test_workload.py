"""How large a work is: what is refused before it begins, and what is not."""

import re

import pytest

import nonsmooth as ns
from nonsmooth.runtime.core import workload
from tests.cli.test_cli import refused, run
from tests.two_masses import STICKING

FRICTION = {name: value for name, value in STICKING.items() if name != "V"}
DATA = " ".join(f"{name}={value}" for name, value in FRICTION.items())
REST = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
REST_ROW = [0, 0, 0, 0]
FROM = "--from x1=0,x2=0,v1=0,v2=0"
SWEEP = f"sweep dry-friction {DATA} {FROM} --quantity x1 --at slip-stick"


@pytest.mark.parametrize(
    "command",
    [
        "chart dry-friction/global-stick V=0.9:1.1:1000000000000 --out c.zarr",
        f"chart dry-friction V=0.2:1.2:100000 eta=1:5:100000 {DATA.replace('eta=1', '')}"
        f" {FROM} --out c.zarr",
        "certify all dry-friction/global-stick tau=0:1e300 tau1=0:1e300",
        "certify box dry-friction/global-stick V=0.9:1.1 --tiles 1000000000000",
        "continue dry-friction/global-stick V=0.9:1.1 --points 1000000000000",
        f"{SWEEP} V=0.9:1.1:10 --transient 99999999999999999999",
        f"{SWEEP} V=0.9:1.1:10 --samples 99999999999999999999",
        f"{SWEEP} V=0.2:1.2:99999999999",
        f"find dry-friction V=1 {DATA} --starts 99999999999999",
        f"find dry-friction V=1 {DATA} --transitions 99999999999999999999",
        f"simulate dry-friction V=1 {DATA} {FROM} --transitions 1000000000000000000",
        f"simulate dry-friction V=1 {DATA} {FROM} --until 1e300",
    ],
)
@pytest.mark.compiled
def test_endless_work_is_refused_before_it_begins(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    line = refused(*command.split())
    assert any(word in line for word in ("hours here", "GB of memory", "smaller bounds"))
    assert not list(tmp_path.iterdir())


def test_threads_without_number_are_refused(tmp_path, monkeypatch):
    pytest.importorskip("zarr")
    monkeypatch.chdir(tmp_path)
    command = "chart dry-friction/global-stick V=0.9:1.1:3 --out c.zarr --workers"
    assert "is more than 1024" in refused(*command.split(), "99999999999999999999")
    assert not list(tmp_path.iterdir())


def test_yes_begins_what_takes_long(monkeypatch):
    command = f"simulate dry-friction V=1 {DATA} {FROM} --transitions 10 --json".split()
    assert run(*command)[0] == 0
    monkeypatch.setitem(workload.SECONDS, "transition", 1e9)
    assert run(*command)[0] == 2
    assert run(*command, "--yes")[0] == 0


@pytest.mark.slow
def test_a_long_graph_says_how_long_before_it_begins(monkeypatch):
    start = "--from x1=5,x2=4,v1=0.5,v2=0.25 x2=2:14"
    command = f"certify region dry-friction V=1 {DATA} {start} --boxes 16".split()
    told = r"images of (\d+) boxes take at least"
    assert not re.search(told, run(*command)[2])
    monkeypatch.setitem(workload.SECONDS, "image", 1e3)
    code, _, err = run(*command)
    found = re.search(told + r" ([\d.]+) hours here", err)
    assert code == 0
    assert found
    assert int(found[1]) >= 16
    assert float(found[2]) == pytest.approx(int(found[1]) / 3.6, rel=1e-2)


@pytest.mark.compiled
def test_python_is_told_what_memory_does_not_hold():
    where = {"state": "x1", "configuration": "slip-stick"}
    with pytest.raises(ns.InputError, match="GB of memory"):
        ns.sweep("dry-friction", FRICTION, "V", [1.0], REST, samples=10**15, **where)
    with pytest.raises(ns.InputError, match="GB of memory"):
        ns.find_orbits("dry-friction", STICKING, 10**14)
    with pytest.raises(ns.InputError, match="GB of memory"):
        ns.simulate("dry-friction", STICKING, REST, transitions=10**18)
    with pytest.raises(ns.InputError, match="GB of memory"):
        ns.simulate("dry-friction", STICKING, [REST_ROW], transitions=1, keep=10**12)


def test_limits(monkeypatch):
    monkeypatch.setattr(workload, "memory_here", lambda: 1e9)
    workload.check_memory("1 thing", 1e9)
    for size in (1.1e9, float("inf"), float("nan")):
        with pytest.raises(workload.TooLarge, match="1 thing take at least"):
            workload.check_memory("1 thing", size)
    workload.check_hours("1 thing", 3600.0, yes=False)
    workload.check_hours("1 thing", 1e30, yes=True)
    with pytest.raises(workload.TooLarge, match="--yes"):
        workload.check_hours("1 thing", 1e30, yes=False)
    assert workload.memory_here() > 0
