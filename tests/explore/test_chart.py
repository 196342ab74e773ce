"""Charts: what is in them, and that they survive kills, damage and other processes."""

import json
import os
import shutil
import signal
import subprocess
import sys
from hashlib import sha256
from pathlib import Path
from threading import Event, Thread
from typing import NamedTuple

import google_crc32c
import numpy as np
import pytest
import xarray

import nonsmooth as ns
from nonsmooth import InputError, MissingExtra
from nonsmooth.runtime.core.result_files import checksum_of
from tests.cli.test_cli import run, told
from tests.explore.test_chart_numbers import MOTIONS
from tests.pictures import figure_in

ORBIT = "dry-friction/global-stick"
PLANE = {"V": np.linspace(0.8, 1.3, 40), "eta": np.linspace(0.8, 1.3, 33)}
RANGES = ("V=0.8:1.3:40", "eta=0.8:1.3:33")


class Work(NamedTuple):
    """How much of a chart a command computed."""

    chunks: int
    computed: int
    damaged: int
    leftovers: int


def contents(store):
    """All files of a store."""
    return {
        str(path.relative_to(store)): path.read_bytes()
        for path in store.rglob("*")
        if path.is_file()
    }


def work(store, *options, ranges=RANGES):
    """Compute what is missing, by the command, and count it."""
    found = told("chart", ORBIT, *ranges, "--out", str(store), "--workers", "2", *options)
    return Work(*(found[name] for name in Work._fields))


def go_on(store):
    """Compute what is missing, in Python."""
    return ns.chart(ORBIT, store=store, **PLANE)


def seal(store):
    """Write the checksums of all metadata anew, as who forges them would."""
    document = json.loads((store / "zarr.json").read_text())
    attributes = document["attributes"]["nonsmooth"]
    files = sorted(store.glob("*/zarr.json"))
    attributes["arrays"] = {f.parent.name: sha256(f.read_bytes()).hexdigest() for f in files}
    del attributes["sha256"]
    attributes["sha256"] = checksum_of(document)
    (store / "zarr.json").write_text(json.dumps(document))


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """An uninterrupted chart in 9 chunks."""
    store = tmp_path_factory.mktemp("finished") / "F.zarr"
    assert work(store, "--chunk", "225").chunks == 9
    return store


@pytest.fixture
def store(finished, tmp_path):
    """A copy of it."""
    return Path(shutil.copytree(finished, tmp_path / "F.zarr"))


@pytest.mark.slow
def test_killed_chart_goes_on(finished, tmp_path):
    store = tmp_path / "F.zarr"
    code = (
        "import numpy as np, nonsmooth as ns, os, signal, sys\n"
        "def progress(done, total):\n"
        "    if 2 * done >= total:\n"
        "        os.kill(os.getpid(), signal.SIGKILL)\n"
        f"ns.chart({ORBIT!r}, V=np.linspace(0.8, 1.3, 40), eta=np.linspace(0.8, 1.3, 33),"
        " store=sys.argv[1], chunk=225, threads=1, progress=progress)\n"
    )
    killed = subprocess.run([sys.executable, "-c", code, str(store)], check=False)
    assert killed.returncode == -signal.SIGKILL
    left = store / "trace" / "c" / "0" / ".1234.partial"
    left.write_bytes(b"cut")
    done = work(store)
    assert 1 <= done.computed < done.chunks
    assert done.leftovers >= 1
    assert contents(store) == contents(finished)
    assert work(store) == Work(9, 0, 0, 0)


CHUNK = "tau1/c/1/2"


def changed(where, *, cut=False):
    def change(file):
        content = bytearray(file.read_bytes())
        content[where] ^= 4
        file.write_bytes(content[:where] if cut else content)

    return change


def forged(change):
    """With its CRC renewed."""

    def forge(file):
        content = change(file.read_bytes()[:-4])
        file.write_bytes(content + google_crc32c.value(content).to_bytes(4, "little"))

    return forge


def piped(file):
    file.unlink()
    os.mkfifo(file)


LARGE = f"{CHUNK} claims to be larger than a chunk"


@pytest.mark.parametrize(
    ("damage", "told"),
    [
        *((changed(where), "checksum") for where in (0, 13, -1)),
        *((changed(where, cut=True), "") for where in (0, 13, -1)),
        # a small one that claims gigabytes, and one that is large itself
        (forged(lambda content: content[:4] + b"\xff\xff\xff\x7f" + content[8:]), LARGE),
        (forged(lambda content: content + bytes(1 << 20)), LARGE),
        pytest.param(
            piped,
            f"{CHUNK} is no file",
            marks=pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes"),
        ),
    ],
)
def test_a_damaged_chunk_is_told_and_computed_anew(finished, store, damage, told):
    damage(store / CHUNK)
    with pytest.raises(ValueError, match=told or None):
        ns.load(store)["tau1"].load()
    code, _, err = run("plot", str(store))
    assert (code, "is damaged: " in err) == (2, True), err
    if told != LARGE:  # whose CRC is right
        assert work(store) == Work(9, 1, 1, 0)
        assert contents(store) == contents(finished)


def test_a_chunk_of_fill_values_is_done_too(tmp_path):
    """None is admissible, as in a chunk that was not computed; that it was is known."""
    plane = ("V=2.9:3:4", "eta=2.9:3:4")
    assert work(tmp_path / "F.zarr", "--chunk", "4", ranges=plane).computed == 4
    assert not ns.load(tmp_path / "F.zarr").admissible.values.any()
    assert work(tmp_path / "F.zarr", "--chunk", "4", ranges=plane) == Work(4, 0, 0, 0)


def test_lost_objects_and_coordinates_come_back(finished, store):
    (store / "status" / "c" / "0" / "0").unlink()
    (store / "limit" / "c" / "2" / "2").unlink()
    (store / "V" / "c" / "0").write_bytes(b"")
    assert work(store) == Work(9, 2, 0, 0)
    assert contents(store) == contents(finished)


def test_forged_chunks_larger_than_the_memory_are_refused(store):
    file = store / "trace" / "zarr.json"
    record = json.loads(file.read_text())
    for change in (
        {"chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [10**6, 10**9]}}},
        {"codecs": [{"name": "bytes"}, {"name": "gzip", "configuration": {"level": 1}}]},
    ):
        file.write_text(json.dumps({**record, **change}))
        seal(store)
        with pytest.raises(InputError, match=r"trace/zarr\.json (the chunks|is no metadata)"):
            ns.load(store)


def test_a_chart_goes_on_alone(finished, store):
    (store / "trace" / "c" / "0" / "0").unlink()
    assert ns.chart(str(store)).sizes == {"V": 40, "eta": 33}
    assert contents(store) == contents(finished)
    with pytest.raises(InputError, match="is a chart that is begun"):
        ns.chart(str(store), V=[1.0, 2.0])
    (store / "V" / "c" / "0").write_bytes(b"")
    with pytest.raises(InputError, match="values of V are damaged"):
        ns.chart(str(store))


@pytest.mark.parametrize(
    ("orbit", "changed", "told"),
    [
        (ORBIT, {"V": np.linspace(0.8, 1.4, 40)}, "other values of V"),
        (ORBIT, {"chi": 0.4}, "chi = 0.5 there, 0.4 here"),
        (ORBIT, {"chunk": 4}, "has chunks of 15 x 15 points, not 2 x 2"),
        ("dry-friction/solution-ii", {}, "orbit dry-friction/global-stick there"),
    ],
)
def test_store_of_another_chart_is_refused(store, orbit, changed, told):
    with pytest.raises(InputError, match=told):
        ns.chart(orbit, store=store, **(PLANE | changed))
    assert work(store, "--chunk", "225") == Work(9, 0, 0, 0)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("derivation", "0123", "derivation 0123 there"),
        ("format", "nonsmooth chart 1", "'nonsmooth chart 1', where 'nonsmooth chart 5' is known"),
    ],
)
def test_store_of_another_derivation_or_release_is_refused(store, name, text, told):
    record = json.loads((store / "zarr.json").read_text())
    record["attributes"]["nonsmooth"][name] = text
    (store / "zarr.json").write_text(json.dumps(record))
    if name == "derivation":
        with pytest.raises(InputError, match=r"zarr\.json is damaged or edited"):
            go_on(store)
        seal(store)
    with pytest.raises(InputError, match=told):
        go_on(store)


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ("other", "no chart"),
        ("other/notes", "it is a file"),
        ("other/notes/F.zarr", "is not a folder"),
        ("", "give the folder a name"),
    ],
)
def test_what_is_no_chart_is_refused(place, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("other").mkdir()
    Path("other", "notes").write_text("mine")
    with pytest.raises(InputError, match=message):
        go_on(Path(place))


def test_metadata_that_is_gone_or_foreign_is_named(store):
    shutil.copytree(store / "trace", store / "more")
    for opened in (go_on, ns.load):
        with pytest.raises(InputError, match=r"F\.zarr: more is no array of this chart"):
            opened(store)
    shutil.rmtree(store / "more")
    (store / "trace" / "zarr.json").unlink()
    for opened in (go_on, ns.load):
        with pytest.raises(InputError, match=r"trace/zarr\.json cannot be read: no such file"):
            opened(store)


def test_no_flipped_byte_of_metadata_is_read_silently(store):
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


def test_missing_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(MissingExtra, match=r'zarr is not installed: .*"nonsmooth\[chart\]"'):
        ns.chart(ORBIT, **PLANE)


def test_two_processes_on_one_store(store, tmp_path):
    code = (
        "import sys, nonsmooth as ns\n"
        "def hold(*_):\n"
        "    print('held', flush=True)\n"
        "    sys.stdin.read()\n"
        "ns.chart(sys.argv[1], progress=hold)\n"
    )
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen([sys.executable, "-c", code, str(store)], **pipes) as process:
        assert process.stdout.readline() == "held\n"
        with pytest.raises(InputError, match=f"is being computed by process {process.pid} on "):
            go_on(store)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
    assert store.with_name("F.zarr.lock").exists()
    assert work(store).computed == 0
    assert not store.with_name("F.zarr.lock").exists()


def test_a_lost_lock_is_left_to_who_took_it_over(store):
    lock, begun, ends = store.with_name("F.zarr.lock"), Event(), Event()

    def wait(*_):
        begun.set()
        ends.wait(60)

    first = Thread(target=lambda: ns.chart(str(store), progress=wait))

    def later(*_):
        ends.set()
        first.join()
        assert lock.exists()
        with pytest.raises(InputError, match="is being computed"):
            ns.chart(str(store))

    first.start()
    begun.wait(60)
    lock.unlink()
    ns.chart(str(store), progress=later)
    assert not lock.exists()


@pytest.mark.skipif(getattr(os, "geteuid", int)() == 0, reason="root may write everything")
def test_unwritable_store(store):
    store.parent.chmod(0o500)
    try:
        with pytest.raises(InputError, match="permission denied"):
            work(store)
    finally:
        store.parent.chmod(0o700)


def test_values_of_a_range_are_evenly_spaced_to_the_last_bit(tmp_path):
    """Though they are in several files."""
    path = tmp_path / "T.zarr"
    told("chart", "rigid-stop/one-impact", "T=4.1:6.3:70000", "--out", str(path))
    values = np.linspace(4.1, 6.3, 70_000)
    assert ns.load(path)["T"].values.tobytes() == values.tobytes()
    ns.chart("rigid-stop/one-impact", T=values, store=path)  # the same chart


@pytest.mark.parametrize(
    ("shape", "points", "chunk"),
    [
        ((40, 3), 100, (33, 3)),
        ((3, 40), 100, (3, 33)),
        ((7,), 100, (7,)),
        ((2, 3, 4), 1, (1, 1, 1)),
    ],
)
def test_chunks_are_as_even_as_the_grid_allows(shape, points, chunk, tmp_path):
    rows = {name: 1 + np.arange(n) / 50 for name, n in zip(("k1", "k2", "m1"), shape, strict=False)}
    ns.chart("rigid-stop/one-impact", store=tmp_path / "F.zarr", chunk=points, **rows)
    record = json.loads((tmp_path / "F.zarr" / "trace" / "zarr.json").read_text())
    assert tuple(record["chunk_grid"]["configuration"]["chunk_shape"]) == chunk


@pytest.mark.parametrize(
    ("counts", "large"),
    [((2**16,) * 4, f"{2**64} points"), ((10**17, 1, 1, 1), f"{10**17} values of V")],
)
def test_more_points_than_can_be_computed(counts, large, tmp_path):
    """They are counted without a limit, as are the values of an axis."""
    names = ("V", "eta", "e1", "e2")
    ranges = (f"{name}=0.5:1:{count}" for name, count in zip(names, counts, strict=True))
    code, _, err = run("chart", ORBIT, *ranges, "--out", str(tmp_path / "F.zarr"))
    assert (code, large in err) == (2, True), err


def test_parts_cover_the_plane(finished, store):
    plane, points = ns.load(finished), told("chart", str(store))["points"]
    assert sum(points.values()) == 40 * 33
    assert points["stable"] == int((plane.admissible & (abs(plane.trace) < 1)).sum())
    assert "missing" not in points
    (store / "status" / "c" / "0" / "0").unlink()
    axes = figure_in(store).axes[0]
    shares = dict(text.get_text().removesuffix(" %)").rsplit(" (", 1)
                  for text in axes.get_legend().get_texts())  # fmt: skip
    assert shares["not computed yet"] == f"{100 * 225 / (40 * 33):.1f}"
    assert sum(map(float, shares.values())) == pytest.approx(100, abs=0.5)


def test_pictures(finished, tmp_path):
    axes = figure_in(finished).axes[0]
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert any(label.startswith("stable") for label in labels)
    assert any(label.startswith("not admissible: phase 3 slip-slip") for label in labels)
    ns.chart(ORBIT, V=[0.9, 1.0], eta=[0.9, 1.0], chi=[0.4, 0.5], store=tmp_path / "F.zarr")
    with pytest.raises(InputError, match="one plane at a time"):
        figure_in(tmp_path / "F.zarr")


def test_outlines_go_along_the_cells(finished):
    """Each is a side between two cells of other colours, and there are as many as such sides."""
    axes = figure_in(finished).axes[0]
    (mesh,) = (each for each in axes.collections if hasattr(each, "get_coordinates"))
    (outlines,) = (each for each in axes.collections if hasattr(each, "get_segments"))
    labels = mesh.get_array().reshape(33, 40)
    changes = (labels[1:] != labels[:-1]).sum() + (labels[:, 1:] != labels[:, :-1]).sum()
    lines = np.array(outlines.get_segments())
    assert len(lines) == changes > 50
    corners = mesh.get_coordinates()
    across, up = corners[0, :, 0], corners[:, 0, 1]

    def label(point):
        return labels[np.searchsorted(up, point[1]) - 1, np.searchsorted(across, point[0]) - 1]

    for first, last in lines:
        middle, beside = (first + last) / 2, 1e-6 * (last - first)[::-1]
        assert label(middle + beside) != label(middle - beside)


def test_commands(store):
    assert told("chart", str(store))["dimensions"] == {"V": 40, "eta": 33}
    assert "0 of 9 chunks computed" in run("chart", str(store))[1]
    assert told("plot", str(store))["chart"] == ORBIT
    assert store.with_suffix(".png").stat().st_size > 1000


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("chi=0.4", "chi = 0.5 there, 0.4 here"),
        ("V=1", "parameter V is given twice"),
        ("chi=1:2", "is not NAME=A:B:N"),
        ("chi=0.5:0.4:5", "the values of chi do not increase strictly"),
        ("chi=0.4:inf:5", "'inf'"),
        ("chi=0.4:0.5:0", "the values of chi are no row of finite numbers"),
        ("chi=0.4:0.400000000000001:100", "the values of chi do not increase strictly"),
    ],
)
def test_wrong_commands(words, message, store):
    refused = told("chart", ORBIT, *RANGES, words, "--out", str(store), code=2)
    assert message in refused["error"]


def test_no_folder_is_named():
    assert "--out F.zarr is missing" in told("chart", ORBIT, "V=1:2:3", code=2)["error"]


def test_a_simulated_chart_goes_on_from_its_own_start(tmp_path):
    place, period = tmp_path / "S.zarr", tmp_path / "S.zarr" / "period" / "c" / "0"
    start = {"x1": 0, "x2": 0.1, "v1": 0.2, "v2": 0.3}
    ns.chart(
        "dry-friction", store=place, simulate=True, start=start, transitions=100, V=[0.6, 0.7],
        eta=4, **MOTIONS,
    )  # fmt: skip
    before = contents(place)
    period.unlink()
    ns.chart(str(place))
    assert contents(place) == before
