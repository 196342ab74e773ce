"""Simulated motions in files: every bit comes back, whatever is not such a file is refused."""

import csv
import hashlib
import io
import json
import os
import re
import zipfile
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import nonsmooth
from nonsmooth import InputError, simulate
from nonsmooth.runtime.present.files import motions as saved_trajectory
from tests.present.test_saved import put, refusal
from tests.two_masses import CHAIN, RUBBING
from tests.unpacking import unpacked_pieces

FRICTION = RUBBING | {"chi": "2/5", "V": 0.6773, "ur2": "sqrt(2)"}
STOP = CHAIN | {"r": "0.5"}
ENDINGS = [".csv", ".npz"]


@cache
def friction():
    return simulate("dry-friction", FRICTION, [0.1, -0.2, 0.3, 0.4], until=60)


@cache
def others():
    grazed = simulate("rigid-stop", STOP, [0, 0, 2, 0], until=30)
    wild, sets = grazed.states.copy(), friction().run.sets.copy()
    wild[-1] = [np.inf, -np.inf, np.nan, -0.0]
    over = simulate("rigid-stop", STOP, [-1e160, 0, 0, 0], transitions=3).status
    sets[1] = 3  # two boundaries at one instant, as a mask of two bits
    slow = dict(m1=1, m2=1, k1=2, k2=3, k3=1)
    found = {
        "no transition": simulate("rigid-stop", STOP, [0, 0, 0.1, 0], until=7.7),
        "impacts": grazed,
        "contact": simulate("rigid-stop", {**STOP, "r": 0}, [0.9, 3, 0, 0], transitions=5),
        "elastic": simulate("elastic-stop", CHAIN | {"k3": 3}, [0, 0, 2, 0], transitions=40),
        "grazings": simulate("elastic-stop", slow, [-1, "-0.5", 0, 0], until=9),
        "together": replace(friction(), run=replace(friction().run, sets=sets)),
        "overflow": replace(grazed, run=replace(grazed.run, states=wild, status=over)),
        "friction": friction(),
    }
    assert len(found["grazings"].grazings) == 1
    return found


@pytest.fixture(params=ENDINGS)
def path(request, tmp_path):
    return tmp_path / f"motion{request.param}"


def parts(path):
    """Header and arrays of a file of either kind, by a reader of its own."""
    if path.suffix == ".npz":
        with np.load(path, allow_pickle=False) as found:
            arrays = {name: found[name] for name in found.files}
        return json.loads(str(arrays.pop("header"))), arrays
    lines = path.read_text(encoding="utf-8").splitlines()
    header = {}
    for line in lines:
        if line.startswith("# "):
            name, text = line.removeprefix("# ").split(": ", 1)
            header[name] = json.loads(text)
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    states = header["states"]
    return header, {
        "times": np.array([float(row["time"]) for row in rows]),
        "configurations": np.array([row["configuration"] for row in rows]),
        "boundaries": np.array([row["boundaries"] for row in rows]),
        "states": np.array([[float(row[name]) for name in states] for row in rows]),
        "before": np.array([[float(row[f"{name}_before"]) for name in states] for row in rows]),
    }


def checksum(header, arrays):
    covered = {name: entry for name, entry in header.items() if name != "sha256"}
    found = hashlib.sha256(json.dumps(covered, sort_keys=True).encode())
    for name in ("times", "states", "before"):
        found.update(np.ascontiguousarray(arrays[name], "<f8").tobytes())
    for name in ("configurations", "boundaries"):
        found.update("\n".join(arrays[name].tolist()).encode())
    return found.hexdigest()


def write(path, header, arrays):
    """Write what was changed, with the checksum that belongs to it."""
    header = {**header, "sha256": checksum(header, arrays)}
    if path.suffix == ".npz":
        np.savez(path, header=np.array(json.dumps(header)), **arrays)
        return
    text = io.StringIO()
    for name, entry in header.items():
        text.write(f"# {name}: {json.dumps(entry)}\n")
    names = header["states"] if isinstance(header["states"], list) else ["x"]
    columns = ["time", "configuration", "boundaries", *names, *(f"{n}_before" for n in names)]
    text.write(",".join(map(str, columns)) + "\n")
    for row in zip(*arrays.values(), strict=True):
        cells = [x for cell in row for x in np.ravel(cell).tolist()]
        text.write(",".join(x if isinstance(x, str) else repr(x) for x in cells) + "\n")
    path.write_text(text.getvalue(), encoding="utf-8")


# --- round trips


@pytest.mark.parametrize("name", list(others()))
def test_every_bit_comes_back(name, path):
    before = others()[name]
    before.save(path)
    after = nonsmooth.load(path)
    for field in ("times", "configurations", "before", "states", "sets"):
        first, second = getattr(before.run, field), getattr(after.run, field)
        assert first.dtype == second.dtype
        assert first.shape == second.shape
        assert first.tobytes() == second.tobytes() or np.isnan(first).any()
        assert np.array_equal(first, second, equal_nan=first.dtype.kind == "f")
    assert after.grazings == before.grazings
    assert (after.status, after.end, after.options) == (before.status, before.end, before.options)
    assert after.name == before.name
    assert after.parameters == before.parameters
    assert [v.exact for v in after.parameters.values()] == [
        v.exact for v in before.parameters.values()
    ]
    assert after.boundaries == before.boundaries
    assert np.array_equal(after.system.rows, before.system.rows)
    written = path.read_bytes()
    after.save(path)
    assert path.read_bytes() == written
    assert os.listdir(path.parent) == [path.name]


def test_the_file_tells_where_it_is_from(path):
    friction().save(path)
    header, arrays = parts(path)
    told = {
        "format": "nonsmooth trajectory", "version": 5, "package": nonsmooth.__version__,
        "system": "dry-friction", "status": "until", "end": "60.0",
        "sha256": checksum(header, arrays),
    }  # fmt: skip
    assert header | told == header
    assert (header["parameters"]["chi"], header["parameters"]["ur2"]) == ("2/5", "sqrt(2)")
    assert np.array_equal(arrays["times"], friction().times)
    assert tuple(arrays["configurations"]) == friction().configurations


def test_pandas_reads_the_table(tmp_path):
    pandas = pytest.importorskip("pandas")
    path = tmp_path / "motion.csv"
    friction().save(path)
    table = pandas.read_csv(path, comment="#")
    assert list(table.columns[:4]) == ["time", "configuration", "boundaries", "x1"]
    np.testing.assert_allclose(table["time"], friction().times, rtol=1e-14)
    np.testing.assert_allclose(table["v2_before"], friction().before[:, 3], rtol=1e-14)
    assert tuple(table["configuration"]) == friction().configurations


# --- files that are refused


def test_a_cut_file_is_refused(path):
    friction().save(path)
    whole = path.read_bytes()
    for length in range(0, len(whole) - 1, 97):
        path.write_bytes(whole[:length])
        refusal(path)


@pytest.mark.slow
def test_a_changed_character_is_refused_or_changes_nothing(path):
    friction().save(path)
    whole = path.read_bytes()
    refused, places = 0, range(3, len(whole), 97)
    for place in places:
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
        try:  # nothing hangs on a date in an archive, or the last of the digits of a number
            found = nonsmooth.load(path)
        except InputError:
            refusal(path)
            refused += 1
            continue
        assert found.configurations == friction().configurations
        assert found.boundaries == friction().boundaries
        for name in ("times", "states", "before"):
            assert np.array_equal(getattr(found.run, name), getattr(friction().run, name))
    assert refused > 0.8 * len(places)


@pytest.mark.parametrize(
    "content", [b"", b"t,x\n0,1\n", b"\xff\xfe\x00\x01", b"PK\x05\x06" + b"\0" * 18]
)
def test_foreign_files_are_refused(content, path):
    path.write_bytes(content)
    assert "saved motion" in refusal(path) or "not an .npz file" in refusal(path)


@pytest.mark.slow
def test_an_archive_whose_directory_lies(tmp_path, monkeypatch):
    """No more of it is unpacked than its directory tells, but for one piece."""
    path = tmp_path / "motion.npz"
    friction().save(path)
    size, told = 200_000_000, 200
    content = io.BytesIO()
    with zipfile.ZipFile(path) as good, zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as bad:
        for name in good.namelist():
            bad.writestr(name, bytes(size) if name == "states.npy" else good.read(name))
    lies = content.getvalue().replace(size.to_bytes(4, "little"), told.to_bytes(4, "little"))
    path.write_bytes(lies)
    unpacked = unpacked_pieces(monkeypatch)
    assert refusal(path) == "cut, damaged, or not an .npz file"
    assert sum(unpacked) < 5_000_000


def test_an_array_whose_header_lies(tmp_path):
    path = tmp_path / "motion.npz"
    friction().save(path)
    with zipfile.ZipFile(path) as good:
        content = {name: good.read(name) for name in good.namelist()}
    old = re.search(rb"\(\d+,\), } *", content["times.npy"])
    lie = b"(10000000,), }".ljust(len(old[0]))
    content["times.npy"] = content["times.npy"].replace(old[0], lie)
    with zipfile.ZipFile(path, "w") as bad:
        for name, part in content.items():
            bad.writestr(name, part)
    assert refusal(path) == "'times.npy' is not as long as its header says"


@pytest.mark.parametrize("name", ["header", "times", "configurations", "boundaries", "states"])
def test_little_of_a_small_archive_is_unpacked(name, tmp_path, monkeypatch):
    """Whichever part of it unpacks to a thousandfold."""
    path = tmp_path / "motion.npz"
    friction().save(path)
    header, arrays = parts(path)
    if name == "header":
        arrays["header"] = np.array(json.dumps(header) + " " * 3_000_000)
    else:
        arrays["header"] = np.array(json.dumps(header))
        shape, kind = arrays[name].shape, arrays[name].dtype.kind
        blown = ((5_000_000, *shape[1:]), "f8") if kind == "f" else (shape, "U1000000")
        arrays[name] = np.zeros(*blown)
    np.savez_compressed(path, **arrays)
    unpacked = unpacked_pieces(monkeypatch)
    assert "'" in refusal(path)
    assert sum(unpacked) < 10 * path.stat().st_size


def test_a_cell_without_end(tmp_path):
    path = tmp_path / "motion.csv"
    friction().save(path)
    path.write_text(path.read_text() + "1" * 200_000 + "\n")
    assert "field larger than field limit" in refusal(path)


def test_cells_may_be_quoted(tmp_path):
    """As other programs write them."""
    path = tmp_path / "motion.csv"
    friction().save(path)
    *above, last = path.read_text().splitlines()
    quoted = ",".join(f'"{entry}"' for entry in last.split(","))
    path.write_text("\n".join([*above, quoted, ""]))
    assert nonsmooth.load(path).times[-1] == friction().times[-1]


def test_files_that_are_too_large(path, monkeypatch):
    friction().save(path)
    content = path.read_bytes()
    monkeypatch.setattr(saved_trajectory, "MOTION", replace(saved_trajectory.MOTION, most=1000))
    assert refusal(path) == "too large for a saved motion"
    with pytest.raises(InputError, match=f"{path.name}: {friction().transitions} transitions are"):
        friction().save(path)
    assert path.read_bytes() == content
    if path.suffix == ".npz":  # small, and unpacks to too much
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr("times.npy", bytes(20_000))
        assert path.stat().st_size < 1000
        assert refusal(path) == "too large for a saved motion"


def cell(name, place, entry):
    def change(content):
        arrays = content["arrays"]
        arrays[name] = arrays[name].astype("U40" if isinstance(entry, str) else float)
        arrays[name][place] = entry

    return change


@pytest.mark.parametrize(
    ("change", "part"),
    [
        (put("format", "nonsmooth orbit"), "not a saved motion, such as --save or save() writes"),
        (put("version", 3), "version 3 of the format, where 5 is known"),
        (put("version", "1"), "version '1' of the format"),
        (put("more", 1), "'more' is unknown"),
        (put("end", 60.0), "'end' is of the wrong type"),
        (put("end", "sixty"), "'end' is 'sixty', not a number"),
        (put("end", "nan"), "its times do not increase from 0 to its end"),
        (put("end", "5.0"), "its times do not increase from 0 to its end"),
        (put("status", "tired"), "'status' is 'tired', none of "),
        (put("system", "wet-friction"), "unknown system 'wet-friction'; did you mean 'dry-fric"),
        (put("system", "rigid-stop"), "unknown parameter 'chi'"),
        (put("derivation", "0" * 16), "not a motion of dry-friction as it is installed (its deriv"),
        (put("states", ["x1", "x2", "v1", "w2"]), "its states are ['x1', 'x2', 'v1', 'w2'], not"),
        (put("grazings", [["1.0", "slip-slip"]]), "'grazings/1' is no list of 4"),
        (put("grazings", [["1.0", "slip-slip", "x", "0.0"]]), "unknown boundary of slip-slip 'x'"),
        (put("grazings", [["1.0", "slip", "x", "0.0"]]), "unknown configuration 'slip'"),
        (put("grazings", [["1.0", 1, "x", "0.0"]]), "'grazings/1/2' is of the wrong type"),
        (put("parameters/chi", 0.4), "'parameters/chi' is of the wrong type"),
        (put("parameters/chi", "1.5"), "chi"),
        (put("parameters/chi", "1/0"), "'parameters/chi': "),
        (put("parameters/kappa", "1"), "unknown parameter 'kappa'"),
        (cell("configurations", 1, "slide"), "unknown configuration 'slide'"),
        (cell("boundaries", 0, "first-reaches-belt"), "its first row is no start"),
        (cell("boundaries", 2, "x"), "'x'"),
        (cell("boundaries", 2, ""), "unknown boundary"),
        (cell("times", 0, 1.0), "its times do not increase from 0"),
        (cell("times", 3, 0.5), "its times do not increase from 0"),
        (cell("times", 3, np.nan), "its times do not increase from 0"),
    ],
)
def test_wrong_content_is_refused(change, part, path):
    friction().save(path)
    header, arrays = parts(path)
    header["arrays"] = arrays
    change(header)
    del header["arrays"]
    write(path, header, arrays)
    assert part in refusal(path)


def test_missing_entries_are_refused(path):
    friction().save(path)
    header, arrays = parts(path)
    for name in header:
        fewer = {n: entry for n, entry in header.items() if n != name}
        if name in ("sha256", "states", "format", "version"):
            continue
        write(path, fewer, arrays)
        assert refusal(path) == f"{name!r} is missing"


def test_arrays_that_do_not_fit(tmp_path):
    path = tmp_path / "motion.npz"
    friction().save(path)
    header, arrays = parts(path)
    without = {name: array for name, array in arrays.items() if name != "before"}
    for changed, told in (
        (arrays | {"before": arrays["before"][:, :3]}, "'before' is not an array"),
        (arrays | {"states": arrays["states"].astype(str)}, "'states' is not an array"),
        # pickles are not read
        (arrays | {"times": np.array([{"a": 1}], dtype=object)}, "'times' is not an array"),
        (without, "not a saved motion"),
        (arrays | {"after": arrays["before"]}, "not a saved motion"),
    ):
        np.savez(path, header=np.array(json.dumps(header)), **changed)
        assert told in refusal(path)


# --- writing


def test_wrong_targets(tmp_path):
    with pytest.raises(InputError, match=r"motion\.txt does not end in \.npz or \.csv"):
        friction().save(tmp_path / "motion.txt")
    (tmp_path / "file").write_text("mine")
    with pytest.raises(InputError, match=r"cannot write .*file is not a folder"):
        friction().save(tmp_path / "file" / "motion.csv")
    with pytest.raises(InputError, match=r"motion\.npz: cannot be read: no such file"):
        nonsmooth.load(tmp_path / "motion.npz")
