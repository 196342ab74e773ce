"""Faults in commands that write: nothing is lost, nothing is half, what is no file stays."""

import errno
import json
import os
import shlex
import stat
import subprocess
import sys
from pathlib import Path

import pytest

import nonsmooth as ns
from nonsmooth.runtime.present.paper import writing
from tests.cli.test_cli import COMMANDS, refused, run
from tests.places import CHECKOUT, GALLERY
from tests.user_systems import declare

ORBIT = "dry-friction/global-stick"
FRICTION = "dry-friction V=0.6773 chi=0.4 eta=4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
SWEPT = FRICTION.replace("V=0.6773", "V=0.6:0.7:2")
REST = "--from x1=0,x2=0,v1=0,v2=0"

CHAOS = (
    "certify chaos dry-friction chi=0.34 eta=2.88 V=1.23 us1=0.75 us2=1.19 ur1=2.04 ur2=1.83"
    " --from x1=1.93,x2=7.18,v1=1.18,v2=1.18"
)
BELT = f"{GALLERY / 'mass_on_belt.py'}:stick-slip"
# commands that ask for little, by the options that name a file or a folder to be written
OUT = {
    "equations": "equations mine.py --format markdown",
    "plot": "plot orbit.json --kind strip",
    "reproduce": "reproduce",
    "regenerate": "regenerate rigid-stop",
    "chart": f"chart {ORBIT} V=0.99:1.01:2",
    "generate": "generate mine.py",
}
PLOT = {
    "certify box": f"certify box {ORBIT} V=0.99:1.01 --tiles 1",
    "certify branch": f"certify branch {ORBIT} V=0.99:1.01 --tiles 1",
    "certify doubling": "certify doubling dry-friction/symmetric V=1.07:1.09 --seconds 1e-6",
    "certify basin": f"certify basin {BELT} x=0:2 v=-0.5:0.5 --side 1 --tiles 1",
    "certify chaos": CHAOS,
    "certify region": f"{CHAOS.replace('chaos', 'region')} x2=8:8.5 --boxes 8",
    "continue": f"continue {ORBIT} V=0.99:1.01",
    "simulate": f"simulate {FRICTION} {REST} --transitions 3",
    "design": "design dry-friction/symmetric V=2.6:2.8 --minimise spectral_radius",
    "fit": "fit rigid-stop impacts.csv m1=1 m2=2 k1=1 k2=5 r=0.7:1 --from x1=0,x2=0,v1=1.5,v2=0"
    " --sigma 0.01",
    "sweep": f"sweep {SWEPT} --quantity x1 --at slip-stick {REST}",
}
SAVE = PLOT | {
    "solve": f"solve {ORBIT}",
    "verify": f"verify {ORBIT} --digits 20",
    "certify orbit": f"certify {ORBIT} us1=1 us2=1",
    "certify event": f"certify event {ORBIT} V=0.99:1.01",
    "certify all": f"certify all {ORBIT} tau=1.99:2.01 tau1=1.56:1.57",
    "find": f"find {FRICTION} --starts 1 --transitions 30",
}
ENDINGS = {("plot", "--out"): ".png", ("simulate", "--save"): ".npz"}
WRITERS = {
    (name, option): f"{command} {option} TARGET{ENDINGS.get((name, option), ending)}"
    for option, ending, commands in (
        ("--out", "", OUT),
        ("--save", "", SAVE),
        ("--plot", ".png", PLOT),
    )
    for name, command in commands.items()
}
FOLDERS = ("reproduce", "regenerate", "chart", "generate")
# one of each way to write: a file, one that is kept on the way, a folder, a store
FAULTED = (
    *(("solve", "--save"), ("plot", "--out"), ("reproduce", "--out"), ("certify box", "--save")),
    *(("chart", "--out"), ("generate", "--out"), ("sweep", "--save")),
)


def marked(*proved):
    """Each writer, with marks of those that prove long where they are proved."""
    compiled = pytest.mark.compiled
    marks = {"certify basin": [compiled, *proved], "certify region": [compiled]}
    writers = [pytest.param(w, marks=marks.get(w[0], [])) for w in WRITERS]
    return pytest.mark.parametrize("writer", writers, ids="".join)


WATCHING = []  # of each test that watches: files that are opened to be written


def watch(event, arguments):
    """Note each file that this process opens to write it: Python tells of all."""
    if WATCHING and event == "open" and arguments[2] & (os.O_WRONLY | os.O_RDWR):
        path = arguments[0]
        if isinstance(path, str | bytes | os.PathLike):
            WATCHING[-1].add(os.path.realpath(os.fsdecode(path)))


sys.addaudithook(watch)


@pytest.fixture
def opened():
    """Files that are opened to be written while a test runs."""
    WATCHING.append(set())
    yield WATCHING[-1]
    WATCHING.pop()


@pytest.fixture
def place(tmp_path, monkeypatch, committed_derivation, given_chaos):
    """A folder with a declaration and an orbit."""
    pytest.importorskip("matplotlib")
    pytest.importorskip("zarr")
    monkeypatch.setattr(writing, "_contents", lambda *_, **__: {"report.html": b"report"})
    monkeypatch.setenv("NONSMOOTH_CACHE", "")
    folder = tmp_path / "place"
    folder.mkdir()
    monkeypatch.chdir(folder)
    declare(folder)
    ns.solve(ORBIT).save("orbit.json")
    data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.8"}
    times = ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=4).times[1:].tolist()
    Path("impacts.csv").write_text("\n".join(["first-reaches-stop", *map(repr, times)]))
    return folder


def test_every_option_that_writes_is_here():
    """The list is made of what the commands declare."""
    found = {
        (name, option.opts[0])
        for name, command in COMMANDS.items()
        for option in command.params
        if option.opts[0] in ("--out", "--save", "--plot")
    }
    assert found == set(WRITERS)


@marked(pytest.mark.slow)
def test_folders_above_are_made_and_files_are_whole(writer, place, opened):
    """What stays was written under another name and moved: it is never there in part."""
    target = place / "new" / "folder" / "target"
    code, _, err = run(*shlex.split(WRITERS[writer].replace("TARGET", str(target))))
    assert code in (0, 1), err  # one tile proves little
    (made,) = target.parent.iterdir()
    assert made.stem == "target"
    assert made.is_dir() == (writer[0] in FOLDERS)
    assert any(path.startswith(str(place / "new")) for path in opened)
    in_part = {path for path in opened if Path(path).is_relative_to(place) and Path(path).exists()}
    assert {path for path in in_part if not path.endswith(".lock")} == set()


@marked()
def test_what_is_no_file_stays(writer, place):
    pipe = place / "pipe"
    suffix = WRITERS[writer].partition("TARGET")[2]
    os.mkfifo(f"{pipe}{suffix}")
    (place / f"null{suffix}").symlink_to("/dev/null")
    (place / f"folder{suffix}").mkdir()
    targets = ["pipe", "null"] if writer[0] in FOLDERS else ["pipe", "null", "folder"]
    before = sorted(os.listdir(place))
    for target in targets:
        command = WRITERS[writer].replace("TARGET", target)
        assert f"cannot write {target}{suffix}: it is a" in refused(*shlex.split(command))
    assert sorted(os.listdir(place)) == before
    assert stat.S_ISFIFO(os.stat(f"{pipe}{suffix}").st_mode)


@pytest.mark.parametrize("name", FOLDERS)
def test_a_folder_needs_a_name(name, place):
    before = sorted(os.listdir(place))
    command = WRITERS[name, "--out"].replace("TARGET", "''")
    assert "give the folder a name" in refused(*shlex.split(command))
    assert sorted(os.listdir(place)) == before


def test_a_lost_scheduler_leaves_nothing(place):
    pytest.importorskip("distributed")
    before = sorted(os.listdir(place))
    asked = f"chart {ORBIT} V=0.99:1.01:2 --out new/F.zarr --scheduler nowhere://x"
    assert "no Dask scheduler answers at nowhere" in refused(*asked.split())
    assert sorted(os.listdir(place)) == before


SAVING = ("solve", "continue", "simulate", "find", "fit", "sweep")
SAVING += tuple(f"certify {name}" for name in ("box", "orbit", "event", "all"))


@pytest.mark.parametrize(
    "writer",
    [*((name, "--save") for name in SAVING), *((n, "--out") for n in ("equations", "plot"))],
    ids="".join,
)
def test_a_full_disk_does_not_lose_the_answer(writer, place, monkeypatch):
    """The answer is shown, where there is one beside the file."""

    def fill(_):
        raise OSError(errno.ENOSPC, "No space left on device")

    asked = shlex.split(WRITERS[writer].replace("TARGET", "target"))
    saves = writer[1] == "--save"
    before = sorted(os.listdir(place))
    monkeypatch.setattr(os, "fsync", fill)
    code, out, err = run(*asked, "--json")
    assert code == 2
    assert json.loads(out).get("files", []) == []
    assert "file" not in json.loads(out)
    last = err.splitlines()[-1] if saves else f"nonsmooth: error: {json.loads(out)['error']}"
    assert last.startswith(f"nonsmooth: error: {'not saved: ' * saves}cannot write target"), err
    assert last.endswith("no space left on device")
    assert sorted(os.listdir(place)) == before
    code, out, err = run(*asked)
    assert code == 2
    assert bool(out.strip()) == saves
    assert "written" not in out
    assert "no space left on device" in err


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot fork here")
def test_a_fault_while_a_file_is_written(place):
    asked = []
    for name, option in FAULTED:
        command = WRITERS[name, option].replace("TARGET", f"target-{name}".replace(" ", "-"))
        if name not in FOLDERS:
            Path(shlex.split(command)[-1]).write_bytes(b"what was there before")
        asked.append(command + " --overwrite" * (option == "--save" and name != "solve"))
    paths = [str(CHECKOUT), *filter(None, [os.environ.get("PYTHONPATH")])]
    done = subprocess.run(
        [sys.executable, "-m", "tests.cli.faults", json.dumps(asked)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    outcomes = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    expected = [
        (command, fault)
        for command in asked
        for fault in ("kill", "twice")[: 2 - command.startswith("chart ")]
    ]
    assert [outcome["fault"] for outcome in outcomes] == [fault for _, fault in expected]
    left = []
    for (command, fault), outcome in zip(expected, outcomes, strict=True):
        told, changed = f"{command}: {outcome}", outcome["changed"]
        if fault == "kill":
            assert outcome["code"] == -9, told
            left = changed
            assert all(".partial" in name or name.endswith(".lock") for name in left), told
        else:
            assert outcome["code"] in (0, 1), told  # one tile proves little
            assert changed, told
            assert not {*changed} & {*left}, told  # of a process that was killed
            assert not any(".partial" in name for name in changed), told
