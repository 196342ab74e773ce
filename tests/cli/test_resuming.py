"""`COMMAND --resume FILE`: the file holds the question, and the answer is that of the whole."""

import json
import shlex
import shutil
import signal
from dataclasses import replace
from importlib import util
from pathlib import Path
from typing import NamedTuple

import pytest
from rich.progress import Progress

import nonsmooth as ns
from tests.cli.terminal import on_terminal
from tests.cli.test_cli import COMMANDS, run
from tests.places import GALLERY
from tests.present.test_saved import sealed
from tests.tables import slow

pytestmark = pytest.mark.compiled  # much slower without it

STICK, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"
FRICTION = "dry-friction V=0.6773 chi=0.4 eta=4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"


class Question(NamedTuple):
    """A command, what its progress is called, how often that is told before Ctrl-C, what is done.

    What is said beside the file, and what declares the system.
    """

    words: str
    progress: str
    told: int
    done: str = ""
    anew: str = ""
    source: str = ""


QUESTIONS = {
    "continue": Question(
        "continue two_stops.py:symmetric w=0.37:0.43 --step 0.05",
        "following w",
        3,
        "points are done",
        source="two_stops.py",
    ),
    "box": Question(f"certify box {SYMMETRIC} V=1:1.1 --tiles 3", "proving", 2, "2 tiles"),
    "doubling": Question(
        f"certify doubling {SYMMETRIC} V=1.07:1.09 --tiles 1", "", 0, anew="--tiles 2"
    ),
    "branch": Question(f"certify branch {SYMMETRIC} V=1:1.1 --tiles 3", "proving", 2, "tiles"),
    "events": Question(
        f"certify event {SYMMETRIC} V=0.6:1.3 --digits 20", "enclosing", 2, "1 of 2 events are done"
    ),
    "basin": Question(
        "certify basin mass_on_belt.py:stick-slip x=0:2 v=-0.5:0.5 --side 0.25 --tiles 6",
        "",
        0,
        anew="--tiles 32",  # all there are: they are the same whatever their order
        source="mass_on_belt.py",
    ),
    "graph": Question(
        "certify region impact_oscillator.py r=0.65 sigma=0 w=2.3 --from x=-0.7,v=0.1"
        " x=-2:0 v=-2:2 --boxes 8 --levels 1",
        "enclosing",
        2,
        "kept in",
        source="impact_oscillator.py",
    ),
    "sweep": Question(
        "sweep two_stops.py w=1.4:1.5:6 d=0.6 r=0.8 --quantity v --at forcing-phase=pi/6"
        " --from x=0,v=0 --transient 0 --samples 9",
        "sweeping",
        4,
        "3 of 6 values are done",
        source="two_stops.py",
    ),
    "design": Question(f"design {SYMMETRIC} V=0.6:1.3 --minimise period", "designing", 4, "done"),
}
PICTURED = ("continue", "box", "sweep")  # whose picture is drawn of what is done


def command_of(words):
    """The words that name a command."""
    first, second, *_ = words.split()
    return f"{first} {second}" if first == "certify" else first


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A folder in which a command heeds Ctrl-C as in a process of its own."""
    monkeypatch.chdir(tmp_path)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def begun(words, progress, told):
    """A command on a terminal that gets Ctrl-C when its progress of that name is told so often."""
    add, update, left = Progress.add_task, Progress.update, told

    def tell(description):
        nonlocal left
        left -= description.startswith(progress)
        if left == 0 and description.startswith(progress):
            signal.raise_signal(signal.SIGINT)

    def adding(shown, description, **options):
        tell(description)
        return add(shown, description, **options)

    def updating(shown, task, **options):
        tell(shown.tasks[task].description)
        update(shown, task, **options)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.argv", ["nonsmooth", *shlex.split(words)])
        if told:
            patch.setattr(Progress, "add_task", adding)
            patch.setattr(Progress, "update", updating)
        return on_terminal(*shlex.split(words))


def answer(file):
    """What a file answers, without what was asked for it and how it came about."""
    content = json.loads(Path(file).read_text())
    for name in ("request", "sha256", "history", "start"):
        content.pop(name, None)
    return content


def marked(*dear):
    """Each kind of question, with a mark of those that are slow."""
    return [slow(k, when=k in dear) for k in QUESTIONS]


SLOW = "basin", "branch", "doubling"


@pytest.mark.parametrize("kind", marked("graph", *SLOW))
def test_what_is_interrupted_goes_on_by_its_file_alone_to_the_whole(
    kind,
):
    asked = QUESTIONS[kind]
    words, anew = shlex.split(asked.words), asked.anew.split()
    if asked.source:
        shutil.copy(GALLERY / asked.source, asked.source)
    drawn = " --plot part.svg" if kind in PICTURED and util.find_spec("matplotlib") else ""
    code, out, err = begun(
        f"{asked.words} --save part.json --json{drawn}", asked.progress, asked.told
    )
    command = command_of(asked.words)
    goes_on = (
        f"kept in part.json; go on with: nonsmooth {command} --resume part.json --json{drawn}\n"
    )
    assert (code == 130, err.endswith(goes_on)) == (asked.told > 0,) * 2
    assert asked.done in err.splitlines()[-1]
    assert Path("part.svg").exists() == bool(drawn)
    if kind != "events":  # several, which are no file's record
        ns.load("part.json").save("part.json")  # with its question
    if kind == "sweep":  # no outcome of the values that it has not looked at
        assert [told is None for told in json.loads(out)["outcomes"]] == [False] * 3 + [True] * 3
    assert run(*words, *anew, "--save", "whole.json")[0] in (0, 1)
    assert answer("part.json") != answer("whole.json")
    if asked.source:
        Path(asked.source).unlink()
    code, _, err = run(*command.split(), "--resume", "part.json", *anew)
    assert (code in (0, 1), err) == (True, "")
    if kind == "continue":
        part, whole = ns.load("part.json"), ns.load("whole.json")
        assert part.ends == whole.ends
        assert [e.kind for e in part.events] == [e.kind for e in whole.events]
    elif kind == "doubling":  # what is done first divides its tiles in another order
        part, whole = ns.load("part.json"), ns.load("whole.json")
        assert (part.kind, part.ended) == (whole.kind, whole.ended) == ("subcritical", "complete")
        assert part.claims == whole.claims == {"doubling": "proved"}
        assert len(part.doubled.branch.tiles) == len(whole.doubled.branch.tiles) == 2
    elif kind == "design":
        part, whole = ns.load("part.json"), ns.load("whole.json")
        assert (part.method, part.converged) == (whole.method, True)
        assert part.after["V"] == pytest.approx(whole.after["V"], abs=1e-6)
    else:
        assert answer("part.json") == answer("whole.json")


# a doubling is asked as a branch is
OTHERS = "doubling", "graph", "sweep"
OF_ORBITS = [k for k in marked("events", *SLOW) if k.values[0] not in OTHERS]


@pytest.mark.parametrize("kind", OF_ORBITS)
def test_an_orbit_of_another_file_is_held_wherever_it_goes_on(kind, tmp_path, monkeypatch):
    asked = QUESTIONS[kind]
    command = command_of(asked.words).split()
    name = asked.words.split()[len(command)]
    first, elsewhere = tmp_path / "first", tmp_path / "elsewhere"
    for folder in (first, elsewhere):
        folder.mkdir()
    monkeypatch.chdir(first)
    if asked.source:
        shutil.copy(GALLERY / asked.source, asked.source)
    orbit = ns.solve(name)
    if asked.source:  # one that the declaration does not name
        dwell, (start, *_) = orbit.dwell_times, orbit.states
        orbit = ns.solve(
            asked.source, orbit.parameters, [*dwell, *start], itinerary=orbit.itinerary
        )
    orbit.save("orbit.json")
    of_file = asked.words.replace(name, "orbit.json")
    ended = begun(f"{of_file} --save part.json", asked.progress, asked.told)
    assert (ended.code == 130) == (asked.told > 0), ended.err
    shutil.move("part.json", elsewhere)
    monkeypatch.chdir(elsewhere)
    shutil.rmtree(first)
    ns.solve(STICK).save("orbit.json")  # another orbit of that name
    before = answer("part.json")
    for _ in range(2):
        code, _, err = run(*command, "--resume", "part.json", *asked.anew.split())
        assert (code in (0, 1), err) == (True, "")
    assert answer("part.json") != before
    assert run(*command, "orbit.json", "--resume", "part.json")[0] == 2
    content = json.loads(Path("part.json").read_text())
    del content["request"]["orbit"]
    sealed(Path("part.json"), content)
    code, _, err = run(*command, "--resume", "part.json")
    assert (code, "does not hold orbit.json: name that too" in err) == (2, True)


@pytest.mark.slow
def test_events_go_on_though_none_is_enclosed_yet(monkeypatch):
    shutil.copy(GALLERY / "two_stops.py", "two_stops.py")

    def stopped(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr("nonsmooth.runtime.proof.branch.certify_event.certify_event", stopped)
        code, _, err = run(
            *["certify", "event", "two_stops.py:symmetric", "d=0.5:0.6", "--save", "part.json"]
        )
    assert (code, "0 of 1 events are done, kept in part.json" in err) == (130, True)
    Path("two_stops.py").unlink()
    assert run("certify", "event", "--resume", "part.json")[0] == 1
    (event,) = ns.load("part.json")
    assert event.kind == "branch-point"


def test_a_chart_goes_on_as_it_was_begun():
    question = f"chart {STICK} V=0.99:1:6 eta=0.99:1:6 --chunk 9 --workers 1"
    code, _, err = begun(f"{question} --out F.zarr --yes --json", "charting", 3)
    assert (code, "of 4 chunks are kept in F.zarr; go on with: nonsmooth" in err) == (130, True)
    assert (ns.load("F.zarr").status.values != -128).any()
    goes_on = shlex.split(err.partition(" with: nonsmooth ")[2])
    assert "--yes" in goes_on
    code, out, err = run(*goes_on)
    assert (code, err) == (0, "")
    assert json.loads(out)["points"] == {"stable": 36}


@pytest.mark.parametrize(
    ("words", "progress", "done"),
    [
        (f"find {FRICTION} --starts 30 --save part.json", "looking for unstable", "orbits and eq"),
        (f"certify all {STICK} tau=0:20 tau1=0:20 --save part.json", "searching", "orbits found"),
        ("reproduce --out new/paper", "orbit rigid", ""),
    ],
)
def test_what_does_not_go_on_keeps_what_it_has_or_nothing(words, progress, done):
    code, _, err = begun(words, progress, 1)
    kept = f"{done}, kept in part.json" if done else "interrupted: nothing is kept"
    assert code == 130
    assert err.count("interrupted: ") == 1
    assert kept.partition(", ")[2] in err
    assert kept.partition(", ")[0] in err
    assert "; begin again with: nonsmooth " in err
    assert err.rstrip().endswith(" --overwrite") == bool(done)
    assert [path.name for path in Path().iterdir()] == (["part.json"] if done else [])
    if done:
        found = ns.load("part.json")
        assert not (found.complete if words.startswith("find") else found.decided)


@pytest.mark.parametrize(
    "words",
    [
        *(QUESTIONS[kind].words for kind in ("box", "events", "design")),
        f"certify {STICK}",
        f"certify all {STICK} tau=0:3 tau1=0:3",
        f"continue {STICK} V=0.99:1.01",
        f"find {FRICTION}",
    ],
)
def test_no_file_is_replaced_unasked(words):
    file = Path("file.json")
    ns.solve(STICK).save(file)
    before = file.read_bytes()
    code, _, err = run(*shlex.split(words), "--save", "file.json")
    assert code == 2
    assert "file.json is there already: " in err
    assert "--overwrite replaces it" in err
    assert file.read_bytes() == before
    resumes = not words.startswith(("find", "certify all", f"certify {STICK}"))
    assert ("--resume file.json goes on with it" in err) == resumes
    if words == f"certify {STICK}":
        assert run(*words.split(), "--save", "file.json", "--overwrite")[0] == 0
        assert ns.load(file).proved


def test_every_command_that_resumes_is_asked_here():
    resumes = {
        name
        for name, command in COMMANDS.items()
        if any("--resume" in option.opts for option in command.params)
    }
    assert {command_of(asked.words) for asked in QUESTIONS.values()} == resumes


@pytest.mark.parametrize(
    ("beside", "told"),
    [
        ("V=1:1.1 eta=1", "asked without eta=1"),
        ("V=1:1.2", "asked with V=1:1.1, not V=1:1.2"),
        (f"{SYMMETRIC} V=1:1.2", "asked with V=1:1.1, not V=1:1.2"),
        (STICK, f"asked with {SYMMETRIC}, not {STICK}"),
        ("--guess tau=1", "asked without --guess tau=1"),
        ("--tiles 0", "tiles = 0 is not an integer from 1"),
        (f"{SYMMETRIC} V=1:11/10", ""),
        ("--tiles 2 --save more.json", ""),
    ],
)
def test_what_is_said_beside_the_file_has_to_be_the_same(beside, told):
    run("certify", "box", SYMMETRIC, "V=1:1.1", "--tiles", "1", "--save", "part.json")
    before = Path("part.json").read_bytes()
    code, _, err = run("certify", "box", "--resume", "part.json", *beside.split())
    assert code == (2 if told else 1), err
    assert told in err
    if told:
        assert err.count("\n") == 1
        assert Path("part.json").read_bytes() == before
    elif "more.json" in beside:
        request = json.loads(Path("more.json").read_text())["request"]
        asked = {"orbit": SYMMETRIC, "parameters": ["V=1:1.1"], "tiles": 2}
        assert request == {"command": "certify box", "options": asked}
        assert run("certify", "check", "more.json")[0] == 0


def test_no_file_makes_a_command_run_a_declaration_or_do_something_else():
    Path("trap.py").write_text("raise SystemExit('run')")
    run("certify", "box", SYMMETRIC, "V=1:1.1", "--tiles", "1", "--save", "part.json")
    sound = json.loads(Path("part.json").read_text())

    def refused(content=None, held=None, **options):
        request = {**sound["request"], "options": {**sound["request"]["options"], **options}}
        request |= {} if held is None else {"orbit": held}
        sealed(Path("forged.json"), {**sound, **(content or {}), "request": request})
        code, _, err = run("certify", "box", "--resume", "forged.json")
        assert code == 2
        assert err.startswith("nonsmooth: error: forged.json: ")
        return str(err)

    assert "does not hold trap.py:loop" in refused(orbit="trap.py:loop")
    named = {"system": "trap.py", "tables": {"a": 1}}
    assert "does not hold trap.py:loop" in refused(named, orbit="trap.py:loop")
    for held in (3, [], {}, {"system": "trap.py"}):
        assert "not a saved orbit" in refused(held=held, orbit="trap.json:1")
    assert "not in order: 'save'" in refused(save="other.json")
    assert "'tiles' is of the wrong type" in refused(tiles=[3])
    assert "'parameters' is of the wrong type" in refused(parameters=[3])
    assert "`nonsmooth certify box` wrote it" in run("certify", "basin", "--resume", "part.json")[2]
    ns.solve(SYMMETRIC).save("orbit.json")
    assert "does not hold its question" in run("certify", "box", "--resume", "orbit.json")[2]
    replace(ns.load("part.json")).save("python.json")  # as Python makes one
    assert "does not hold its question" in run("certify", "box", "--resume", "python.json")[2]
    words = ("certify", "box", SYMMETRIC, "V=1:1.1", "--tiles", "2", "--resume", "python.json")
    assert run(*words)[0] == 1
    assert sum(tile.looked_at for tile in ns.load("python.json").tiles) == 1
