"""Charts: what is in them, and that they survive kills, damage and other processes."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import InputError, MissingExtra
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.explore.charting import problem as problems
from nonsmooth.runtime.explore.charting.chart import Work, chart_problem, work_on
from nonsmooth.runtime.explore.charting.classes import counts_of, parts_of
from nonsmooth.runtime.explore.charting.grid import Grid, axis_of, chunk_shape, linear_axis
from nonsmooth.runtime.explore.charting.lock import locked
from nonsmooth.runtime.explore.charting.store import _seal
from nonsmooth.runtime.model.kernels import load_orbit
from nonsmooth.runtime.present.pictures.charts import chart_figure
from tests.user_systems import DAMPED, declare

ORBIT = "dry-friction/global-stick"
PLANE: dict[str, Any] = {"V": np.linspace(0.8, 1.3, 40), "eta": np.linspace(0.8, 1.3, 33)}
MOTIONS = {"chi": 0.4, "us1": 0.0127, "ur1": 0.0255, "us2": 0.5, "ur2": 1}
REST = {"x1": 0, "x2": 0, "v1": 0, "v2": 0}


def contents(store: Path) -> dict[str, bytes]:
    """All files of a store."""
    return {
        str(path.relative_to(store)): path.read_bytes()
        for path in store.rglob("*")
        if path.is_file()
    }


def work(store: Path, chunk: int | None = None, **plane: Any) -> Work:
    """Compute what is missing, and count it."""
    problem, axes = chart_problem(ORBIT, plane or PLANE, False, None, 0)
    return work_on(store, problem, axes, None, chunk, 2)


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An uninterrupted chart in 9 chunks."""
    store = tmp_path_factory.mktemp("finished") / "F.zarr"
    assert work(store, 225).chunks == 9
    return store


@pytest.fixture
def store(finished: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(finished, tmp_path / "F.zarr"))


@pytest.mark.slow
def test_chart_says_what_one_orbit_says(finished: Path) -> None:
    plane = ns.load(finished)
    assert list(plane.sizes.items()) == [("V", 40), ("eta", 33)]
    names = load_orbit(ORBIT).unknowns
    seen = set()
    for i, j in np.random.default_rng(7).integers(0, (40, 33), (40, 2)):
        point = plane.isel(V=int(i), eta=int(j))
        orbit = ns.solve(ORBIT, {"V": float(point.V), "eta": float(point.eta)}, throw=False)
        if int(point.status) != 0:
            assert not bool(point.admissible)
            assert int(point.limit) == -2
            continue
        if abs(float(orbit.unknowns["tau"]) - float(point.tau)) > 1e-6:
            continue  # another orbit of the same itinerary
        for name in names:
            assert float(point[name]) == pytest.approx(float(orbit.unknowns[name]), abs=1e-10)
        assert float(point.trace) == pytest.approx(orbit.stability.trace, abs=1e-10)
        assert float(point.margin) == pytest.approx(orbit.stability.margin, abs=1e-10)
        assert float(point.period) == pytest.approx(orbit.period, abs=1e-10)
        verdict = orbit.admissibility
        assert bool(point.admissible) == (verdict.verdict is not False)
        if not point.admissible:
            first = verdict.violations[0]
            told = plane.limit.attrs["meanings"][str(int(point.limit))]
            assert told == f"phase {first.phase + 1} {first.configuration}: {first.boundary}"
        seen.add(bool(point.admissible))
    assert seen == {True, False}


def test_chart_has_what_solve_many_has(finished: Path) -> None:
    plane = ns.load(finished)
    found = ns.solve_many(ORBIT, V=PLANE["V"][:, None], eta=PLANE["eta"])
    assert found.admissible is not None
    assert found.bounds is not None
    assert (plane.status.values[found.converged] == 0).all()
    np.testing.assert_array_equal(plane.admissible.values, found.admissible)
    where = found.admissible
    np.testing.assert_allclose(plane.trace.values[where], found.trace[where], atol=1e-9)
    np.testing.assert_allclose(
        plane.least_us2.values[where], found.bounds["us2"][where], rtol=1e-9, atol=1e-9
    )


def test_margins_are_those_of_single_orbits() -> None:
    for name, swept in (("rigid-stop/one-impact", "T"), ("dry-friction/symmetric", "V")):
        known = ns.solve(name)
        values = float(known.values[swept]) * np.array([0.99, 1.0, 1.01])
        line = ns.chart(name, **{swept: values})
        for place, value in enumerate(values):
            orbit = ns.solve(name, {swept: float(value)})
            assert float(line.margin[place]) == pytest.approx(orbit.stability.margin, abs=1e-9)


def test_limits_without_compiled_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    small = {"V": PLANE["V"][20::6], "eta": PLANE["eta"][::8]}
    compiled = ns.chart(ORBIT, **small)
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    plain = ns.chart(ORBIT, **small)
    assert (compiled.limit.values >= 0).any()
    np.testing.assert_array_equal(compiled.limit.values, plain.limit.values)


@pytest.mark.parametrize("chunk", [7, 128, 5000])
def test_bits_do_not_depend_on_chunks_and_threads(finished: Path, chunk: int) -> None:
    plane, other = ns.load(finished), ns.chart(ORBIT, chunk=chunk, threads=3, **PLANE)
    assert set(plane) == set(other)
    for name in plane:
        assert plane[name].values.tobytes() == other[name].values.tobytes(), name


@pytest.mark.slow
@pytest.mark.parametrize("simulated", [False, True])
def test_other_charts_do_not_depend_on_chunks(tmp_path: Path, simulated: bool) -> None:
    if simulated:
        plane = {"V": np.linspace(0.3, 1.1, 5), "eta": [1.0, 4.0]}
        arguments: dict[str, Any] = {"simulate": True, "start": REST, "transitions": 300}
        name, found = "dry-friction", plane | arguments | MOTIONS
    else:
        name = f"{declare(tmp_path, DAMPED)}:loop"
        found = {"r": np.linspace(0.2, 0.4, 4), "k": [0.9, 1.0]}
    whole = ns.chart(name, **found)
    for chunk in (1, 3):
        other = ns.chart(name, chunk=chunk, **found)
        for variable in whole:
            assert whole[variable].values.tobytes() == other[variable].values.tobytes(), variable
    assert (whole.status.values == 0).any()


@pytest.mark.slow
def test_killed_chart_goes_on(finished: Path, tmp_path: Path) -> None:
    store = tmp_path / "F.zarr"
    code = (
        "import numpy as np, nonsmooth as ns, sys\n"
        f"ns.chart({ORBIT!r}, V=np.linspace(0.8, 1.3, 40), eta=np.linspace(0.8, 1.3, 33),"
        " store=sys.argv[1], chunk=225, threads=1)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code, str(store)])
    late = time.monotonic() + 60
    while len(list(store.glob("trace/c/*/*"))) < 4:
        assert time.monotonic() < late
        assert process.poll() is None
        time.sleep(0.002)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    left = store / "trace" / "c" / "0" / ".1234.partial"
    left.write_bytes(b"cut")
    done = work(store)
    assert 1 <= done.computed < done.chunks
    assert done.leftovers >= 1
    assert contents(store) == contents(finished)
    assert work(store) == Work(9, 0, 0, 0)


@pytest.mark.parametrize("where", [0, 13, -1])
@pytest.mark.parametrize("truncated", [False, True])
def test_damaged_chunk_is_computed_anew(
    finished: Path, store: Path, where: int, truncated: bool
) -> None:
    file = store / "tau1" / "c" / "1" / "2"
    content = bytearray(file.read_bytes())
    content[where] ^= 4
    file.write_bytes(content[:where] if truncated else content)
    assert work(store) == Work(9, 1, 1, 0)
    assert contents(store) == contents(finished)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes")
def test_a_pipe_in_place_of_a_chunk_is_damage(finished: Path, store: Path) -> None:
    file = store / "tau1" / "c" / "1" / "2"
    file.unlink()
    os.mkfifo(file)
    with pytest.raises(ValueError, match=r"tau1/c/1/2 is no file"):
        ns.load(store)["tau1"].load()
    assert work(store) == Work(9, 1, 1, 0)
    assert contents(store) == contents(finished)


def test_a_chunk_of_fill_values_is_done_too(tmp_path: Path) -> None:
    """None is admissible, as in a chunk that was not computed; that it was is known."""
    plane = {"V": np.linspace(2.9, 3, 4), "eta": np.linspace(2.9, 3, 4)}
    assert work(tmp_path / "F.zarr", 4, **plane).computed == 4
    assert not ns.load(tmp_path / "F.zarr").admissible.values.any()
    assert work(tmp_path / "F.zarr", 4, **plane) == Work(4, 0, 0, 0)


def test_lost_objects_and_coordinates_come_back(finished: Path, store: Path) -> None:
    (store / "status" / "c" / "0" / "0").unlink()
    (store / "limit" / "c" / "2" / "2").unlink()
    (store / "V" / "c" / "0").write_bytes(b"")
    assert work(store) == Work(9, 2, 0, 0)
    assert contents(store) == contents(finished)


def test_flipped_byte_is_not_read_silently(store: Path) -> None:
    file = store / "trace" / "c" / "0" / "0"
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    with pytest.raises(ValueError, match="checksum"):
        ns.load(store).trace.values.sum()


def test_a_forged_chunk_is_not_unpacked(store: Path) -> None:
    """A small object that claims gigabytes, its CRC renewed, and one that is large itself."""
    from google_crc32c import value

    file = store / "trace" / "c" / "0" / "0"
    right = file.read_bytes()
    header = right[:4] + (2**31 - 1).to_bytes(4, "little") + right[8:-4]
    for forged in (header, right[:-4] + bytes(1 << 20)):
        file.write_bytes(forged + value(forged).to_bytes(4, "little"))
        with pytest.raises(ValueError, match="trace/c/0/0 claims to be larger than a chunk"):
            ns.load(store).trace.values.sum()
        found = CliRunner().invoke(app, ["plot", str(store)])
        assert found.exit_code == 2
        assert "is damaged: trace/c/0/0 claims to be larger" in found.stderr


def test_forged_chunks_larger_than_the_memory_are_refused(store: Path) -> None:
    file = store / "trace" / "zarr.json"
    record = json.loads(file.read_text())
    for change in (
        {"chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [10**6, 10**9]}}},
        {"codecs": [{"name": "bytes"}, {"name": "gzip", "configuration": {"level": 1}}]},
    ):
        file.write_text(json.dumps({**record, **change}))
        _seal(store)
        with pytest.raises(InputError, match=r"trace/zarr\.json (the chunks|is no metadata)"):
            ns.load(store)


def test_a_chart_goes_on_alone(finished: Path, store: Path) -> None:
    (store / "trace" / "c" / "0" / "0").unlink()
    assert ns.chart(str(store)).sizes == {"V": 40, "eta": 33}
    assert contents(store) == contents(finished)
    with pytest.raises(InputError, match="is a chart that is begun"):
        ns.chart(str(store), V=[1.0, 2.0])
    (store / "V" / "c" / "0").write_bytes(b"")
    with pytest.raises(InputError, match="values of V are damaged"):
        ns.chart(str(store))


def test_a_simulated_chart_goes_on(tmp_path: Path) -> None:
    place = tmp_path / "S.zarr"
    given = {**MOTIONS, "V": [0.6, 0.7], "eta": 4}
    ns.chart("dry-friction", store=place, simulate=True, start=REST, transitions=100, **given)
    before = contents(place)
    (place / "period" / "c" / "0").unlink()
    ns.chart("dry-friction", store=place, simulate=True, start=REST, transitions=100, **given)
    assert contents(place) == before
    (place / "period" / "c" / "0").unlink()
    ns.chart(str(place))
    assert contents(place) == before


@pytest.mark.parametrize(
    ("orbit", "changed", "told"),
    [
        (ORBIT, {"V": np.linspace(0.8, 1.4, 40)}, "other values of V"),
        (ORBIT, {"chi": 0.4}, "chi = 0.5 there, 0.4 here"),
        ("dry-friction/solution-ii", {}, "orbit dry-friction/global-stick there"),
    ],
)
def test_store_of_another_chart_is_refused(
    store: Path, orbit: str, changed: dict[str, Any], told: str
) -> None:
    with pytest.raises(InputError, match=told):
        ns.chart(orbit, store=store, **(PLANE | changed))


def test_store_of_another_derivation_is_refused(store: Path) -> None:
    record = json.loads((store / "zarr.json").read_text())
    record["attributes"]["nonsmooth"]["derivation"] = "0123"
    (store / "zarr.json").write_text(json.dumps(record))
    with pytest.raises(InputError, match=r"zarr\.json is damaged or edited"):
        work(store)
    _seal(store)
    with pytest.raises(InputError, match="derivation 0123 there"):
        work(store)


def test_store_of_other_chunks_is_refused(store: Path) -> None:
    with pytest.raises(InputError, match="has chunks of 15 x 15 points, not 2 x 2"):
        work(store, 4)
    assert work(store, 225).computed == 0


def test_what_is_no_chart_is_refused(tmp_path: Path, store: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes").write_text("mine")
    with pytest.raises(InputError, match="no chart"):
        work(tmp_path / "other")
    with pytest.raises(InputError, match="no such file or directory"):
        ns.load(tmp_path / "absent")
    with pytest.raises(InputError, match="it is a file"):
        work(tmp_path / "other" / "notes")
    with pytest.raises(InputError, match="is not a folder"):
        work(tmp_path / "other" / "notes" / "F.zarr")
    with pytest.raises(InputError, match="give the folder a name"):
        work(Path(""))


def test_metadata_that_is_gone_or_foreign_is_named(store: Path) -> None:
    shutil.copytree(store / "trace", store / "more")
    for opened in (work, ns.load):
        with pytest.raises(InputError, match=r"F\.zarr: more is no array of this chart"):
            opened(store)
    shutil.rmtree(store / "more")
    (store / "trace" / "zarr.json").unlink()
    for opened in (work, ns.load):
        with pytest.raises(InputError, match=r"trace/zarr\.json cannot be read: no such file"):
            opened(store)


def test_no_flipped_byte_of_metadata_is_read_silently(store: Path) -> None:
    """Each is told of, or changes nothing."""
    right = ns.load(store).load()
    random = np.random.default_rng(11)
    files = sorted(store.rglob("zarr.json"))
    told = []
    for _ in range(100):
        file = files[random.integers(len(files))]
        content = file.read_bytes()
        flipped = bytearray(content)
        flipped[random.integers(len(flipped))] ^= 1 << random.integers(8)
        file.write_bytes(flipped)
        try:
            xarray.testing.assert_identical(ns.load(store).load(), right)
        except InputError as problem:
            told.append(str(problem))
        finally:
            file.write_bytes(content)
    assert len(told) > 80
    assert all(line.startswith(f"{store}") and "\n" not in line for line in told)


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [("trace", '"separator": "/"', '"separator": "."'), ("V", "40", "41"), ("limit", "-2", "-3")],
)
def test_damaged_metadata_is_named(store: Path, name: str, old: str, new: str) -> None:
    file = store / name / "zarr.json"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    for opened in (work, ns.load):
        with pytest.raises(InputError, match=rf"{name}/zarr\.json is damaged or edited"):
            opened(store)
    code = CliRunner().invoke(app, ["plot", str(store)]).exit_code
    assert code == 2


def test_a_chart_of_another_release_is_refused(store: Path) -> None:
    record = json.loads((store / "zarr.json").read_text())
    record["attributes"]["nonsmooth"]["format"] = "nonsmooth chart 1"
    (store / "zarr.json").write_text(json.dumps(record))
    with pytest.raises(InputError, match="'nonsmooth chart 1', where 'nonsmooth chart 5' is known"):
        ns.load(store)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({}, "nothing to chart"),
        ({"V": [1.0, 1.0]}, "do not increase"),
        ({"V": [1.0, np.nan]}, "finite"),
        ({"V": ["a"]}, "no row of numbers"),
        ({"W": [1.0, 2.0]}, "unknown parameter 'W'"),
        ({"V": [1.0, 2.0], "eta": -1}, "eta = -1 is outside its domain"),
        ({"V": [1.0, 2.0], "chunk": 0}, "chunk = 0"),
        ({"V": [1.0, 2.0], "threads": -1}, "threads = -1"),
        ({"V": [1.0, 2.0], "scheduler": "tcp://x"}, "needs a store"),
        ({"V": [1.0, 2.0], "start": REST}, "a start is for motions"),
        ({"V": [1.0, 2.0], "simulate": True}, "the start of the motions is missing"),
        ({"V": np.linspace(1, 2, 10_000), "eta": np.linspace(1, 2, 10_000)}, "for a store"),
    ],
)
def test_wrong_input(given: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        ns.chart("dry-friction" if given.get("simulate") else ORBIT, **given)


def test_missing_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(MissingExtra, match=r'zarr is not installed: .*"nonsmooth\[chart\]"'):
        ns.chart(ORBIT, **PLANE)


def test_two_processes_on_one_store(store: Path, tmp_path: Path) -> None:
    code = (
        "import sys, pathlib\n"
        "from nonsmooth.runtime.explore.charting.lock import locked\n"
        "with locked(pathlib.Path(sys.argv[1])):\n"
        "    print('held', flush=True)\n"
        "    sys.stdin.read()\n"
    )
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen([sys.executable, "-c", code, str(store)], **pipes) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "held\n"
        with pytest.raises(InputError, match=f"is being computed by process {process.pid} on "):
            work(store)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
    assert store.with_name("F.zarr.lock").exists()
    assert work(store).computed == 0
    assert not store.with_name("F.zarr.lock").exists()


def test_a_lost_lock_is_left_to_who_took_it_over(tmp_path: Path) -> None:
    store, lock = tmp_path / "F.zarr", tmp_path / "F.zarr.lock"
    with locked(store):
        lock.unlink()
        with locked(store):
            assert lock.exists()
    assert not lock.exists()
    first = locked(store)
    first.__enter__()
    lock.unlink()
    with locked(store):
        first.__exit__(None, None, None)
        assert lock.exists()
        with pytest.raises(InputError, match="is being computed"), locked(store):
            pass
    assert not lock.exists()


@pytest.mark.slow
def test_full_disk(finished: Path, store: Path) -> None:
    for name in ("trace", "tau"):
        (store / name / "c" / "0" / "0").unlink()
    code = (
        "import resource, signal, sys\n"
        "import numpy as np, nonsmooth as ns\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200))\n"
        "try:\n"
        "    ns.chart(sys.argv[2], V=np.linspace(0.8, 1.3, 40), eta=np.linspace(0.8, 1.3, 33),"
        " store=sys.argv[1])\n"
        "except ns.InputError as problem:\n"
        "    print(problem)\n"
    )
    options: dict[str, Any] = {"capture_output": True, "text": True, "check": True}
    told = subprocess.run([sys.executable, "-c", code, str(store), ORBIT], **options).stdout
    assert told.strip() == f"cannot write {store}: file too large"
    done = work(store)
    assert (done.computed, done.damaged) == (1, 0)
    assert contents(store) == contents(finished)


@pytest.mark.skipif(getattr(os, "geteuid", int)() == 0, reason="root may write everything")
def test_unwritable_store(store: Path) -> None:
    store.parent.chmod(0o500)
    try:
        with pytest.raises(InputError, match="permission denied"):
            work(store)
    finally:
        store.parent.chmod(0o700)


def test_axes() -> None:
    axis = linear_axis("V", 0.8, 1.3, 200_001)
    whole = np.linspace(0.8, 1.3, 200_001)
    assert np.concatenate([part for _, part in axis.blocks()]).tobytes() == whole.tobytes()
    assert axis.fingerprint() == axis_of("V", whole).fingerprint()
    assert axis.fingerprint() != axis_of("V", np.nextafter(whole, 9)).fingerprint()
    for shape, points in (((10**5, 10**4), 1 << 16), ((3, 1000), 100), ((7,), 100), ((2, 3, 4), 1)):
        chunk = chunk_shape(shape, points)
        assert np.prod(chunk) <= points
        assert np.prod(np.minimum(chunk, shape)) >= min(points, np.prod(shape)) / 4
    assert chunk_shape((1000, 1000), 1 << 16) == (256, 256)
    for wrong in ((1.0, 1.0, 5), (2.0, 1.0, 5), (1.0, np.inf, 5), (1.0, 2.0, 0)):
        with pytest.raises(InputError):
            linear_axis("V", *wrong)
    with pytest.raises(InputError, match="not distinct"):
        linear_axis("V", 1.0, 1.0 + 1e-15, 100)


def test_simulated_chart_agrees_with_the_orbits() -> None:
    values = {"chi": 0.4, "eta": 4, "us1": 0.0127, "ur1": 0.0255, "us2": 0.5, "ur2": 1}
    line = ns.chart("dry-friction", simulate=True, start=REST, V=[0.55, 0.6773, 0.7], **values)
    periodic = np.flatnonzero(line.transitions.values)
    assert periodic.size
    for place in periodic:
        motion = ns.simulate(
            "dry-friction", {**values, "V": float(line.V[place])}, REST, transitions=2000
        )
        recurrence = ns.itinerary_of(motion)
        assert len(recurrence.itinerary) == int(line.transitions[place])
        assert float(np.sum(recurrence.dwell_times)) == pytest.approx(
            float(line.period[place]), rel=1e-5
        )


def test_parts_cover_the_plane(finished: Path, store: Path) -> None:
    plane = ns.load(finished)
    parts = parts_of(plane)
    assert (sum(part.where.astype(int) for part in parts) == 1).all()
    counts = counts_of(plane)
    assert sum(counts.values()) == 40 * 33
    assert counts["stable"] == int((plane.admissible & (abs(plane.trace) < 1)).sum())
    assert counts["missing"] == 0
    (store / "status" / "c" / "0" / "0").unlink()
    assert counts_of(ns.load(store))["missing"] == 225
    with pytest.raises(InputError, match="no chart"):
        parts_of(plane.drop_vars("status"))


def test_pictures(finished: Path, tmp_path: Path) -> None:
    plane = ns.load(finished)
    figure = chart_figure(plane)
    _, labels = figure.axes[0].get_legend_handles_labels()
    assert any(label.startswith("stable") for label in labels)
    assert any(label.startswith("not admissible: phase 3 slip-slip") for label in labels)
    figure.savefig(tmp_path / "plane.svg")
    chart_figure(plane.isel(eta=0)).savefig(tmp_path / "line.png")
    with pytest.raises(InputError, match="one plane at a time"):
        chart_figure(plane.expand_dims(chi=[0.4, 0.5]))


def test_commands(finished: Path, tmp_path: Path) -> None:
    runner, store = CliRunner(), tmp_path / "F.zarr"
    command = ["chart", ORBIT, "V=0.8:1.3:40", "eta=0.8:1.3:33", "--out", str(store), "--json"]
    command += ["--chunk", "225"]
    first = runner.invoke(app, command)
    assert first.exit_code == 0, first.output
    told = json.loads(first.stdout)
    assert told["dimensions"] == {"V": 40, "eta": 33}
    assert (told["computed"], told["chunks"]) == (9, 9)
    assert sum(told["points"].values()) == 40 * 33
    assert contents(store) == contents(finished)
    again = runner.invoke(app, command[:-3])
    assert "0 of 9 chunks computed" in again.stdout
    drawn = runner.invoke(app, ["plot", str(store), "--json"])
    assert json.loads(drawn.stdout)["chart"] == ORBIT
    assert (tmp_path / "F.png").stat().st_size > 1000
    for wrong in (["chi=0.4"], ["V=1"], ["W=1:2:3"], ["eta=1:2"]):
        refused = runner.invoke(app, [*command, *wrong])
        assert refused.exit_code == 2
        assert "error" in json.loads(refused.stdout)
    assert runner.invoke(app, ["chart", ORBIT, "V=1:2:3"]).exit_code == 2


@pytest.mark.parametrize("count", [2**33, 2**32, 3 * 2**31])
def test_points_and_chunks_are_counted_without_a_limit(count: int) -> None:
    grid = Grid((linear_axis("V", 0, 1, count), linear_axis("eta", 0, 1, count)), (1, 2))
    assert (grid.points, grid.chunks) == (count**2, count**2 // 2)


def test_no_status_is_taken_twice() -> None:
    assert problems.MISSING not in range(-10, 20)
