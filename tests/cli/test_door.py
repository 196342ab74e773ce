"""One door for errors: whatever goes wrong is one line that names it, with an exit code."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import nonsmooth as ns
from tests.cli.test_cli import PROGRAM, refused, run
from tests.places import CHECKOUT
from tests.present.test_saved import sealed
from tests.tables import slow
from tests.user_systems import KICKED, declare

ORBIT = "dry-friction/global-stick"
BRANCH = f"continue {ORBIT} V=0.99:1.01"

_SECRETIVE = "class M(type):\n    @property\n    def __name__(self): raise SystemExit\n"
_SYSTEM = "from nonsmooth.derive import System\n"
_LEAVING = "class S(System):\n    def __getattribute__(self, name): raise SystemExit(0)\n"


class Silent(Exception):
    """One that cannot be shown."""

    def __str__(self):
        raise ValueError


@pytest.mark.parametrize(
    ("problem", "code", "said"),
    [
        (ZeroDivisionError("no\nway"), 1, "internal error: ZeroDivisionError: no way; run again"),
        (OSError(28, "No space left", "a\nb"), 2, "error: a b: no space left"),
        (SystemExit(0), 1, "internal error: SystemExit: 0"),
        (MemoryError(), 1, "the memory is not enough for this"),
        (RecursionError("deep"), 1, "internal error: RecursionError: deep"),
        (ns.InputError("it is \x1b[31mred"), 2, r"error: it is \x1b[31mred"),
        (ns.NoConvergence("no orbit\r\n\n\u2028here"), 1, "no orbit here"),
        (Silent(), 1, "internal error: Silent; run again"),
    ],
)
def test_whatever_goes_wrong_is_one_line(problem, code, said, monkeypatch):
    def fail(*arguments, **options):
        raise problem

    monkeypatch.setattr("nonsmooth.runtime.orbits.solve.solve", fail)
    assert refused("solve", ORBIT, code=code).startswith(f"nonsmooth: {said}")
    traced = run("solve", ORBIT, "--debug")
    assert traced.code == code
    assert "Traceback (most recent call last)" in traced.err
    assert f"nonsmooth: {said}" in traced.err.splitlines()[-1]


@pytest.mark.parametrize("command", ["solve", "list", "equations", "plot", "certify check"])
@pytest.mark.parametrize(
    "name", ["x" * 300, "x" * 5000 + ".py", "a\nb", "a\u2028b", "a\x1b[0m", "\udc80", "/"]
)
def test_hostile_names_are_refused_in_one_line(command, name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    refused(*command.split(), name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("raise SystemExit('a\\nb')", "line 1: SystemExit: a b"),
        ("raise BaseException('no')", "line 1: BaseException: no"),
        ("raise GeneratorExit", "line 1: GeneratorExit"),
        (
            "class E(Exception):\n    def __str__(self): raise SystemExit\nraise E",
            "cannot be shown",
        ),
        (f"{_SECRETIVE}class Y(metaclass=M): pass\nsystem = Y()", "line 3: SystemExit"),
        (
            f"{_SYSTEM}system = object.__new__(System)",
            "of type System is not made by calling",
        ),
        (f"{_SYSTEM}{_LEAVING}system = object.__new__(S)", "line 3: SystemExit: 0"),
        ("class E(Exception):\n    def __str__(self): return 3\nraise E", "cannot be shown"),
        ("class E(BaseException):\n    def __str__(self): 1/0\nraise E", "cannot be shown"),
        ("from unittest.mock import MagicMock\nsystem = MagicMock()", "not a System"),
        (
            "class Y:\n    def __getattr__(self, n): return self\nsystem = Y()",
            "type Y, not a System",
        ),
        ("import os\nsystem = os", "of type module, not a System"),
    ],
)
def test_declarations_that_fail_are_named(text, said, tmp_path):
    file = tmp_path / "bad.py"
    file.write_text(text)
    line = refused("list", str(file))
    assert str(file) in line
    assert said in line


def test_a_full_disk_where_latex_works_names_the_document(tmp_path, monkeypatch):
    def full(text):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("nonsmooth.derive.document.latex.compile_pdf", full)
    out = tmp_path / "out.pdf"
    line = refused("equations", "rigid-stop", "--format", "pdf", "--out", str(out))
    assert line == f"nonsmooth: error: cannot write {out}: no space left on device"


def test_what_a_declaration_prints_is_on_stderr(tmp_path):
    file = declare(tmp_path, f"print('hello')\n{KICKED}")
    code, out, err = run("list", str(file), "--json")
    assert (code, err) == (0, "hello\n")
    assert json.loads(out)["systems"][0]["name"]


def test_a_name_that_is_none_is_wrong_input_of_a_check(tmp_path):
    ns.certify(ns.solve(ORBIT)).save(tmp_path / "c.json")
    assert "'zz'" in refused("certify", "check", str(tmp_path / "c.json"), "zz")


@pytest.mark.slow
@pytest.mark.compiled
def test_hostile_commands_are_refused_or_answered(tmp_path):
    pytest.importorskip("resource")
    done = subprocess.run(
        [sys.executable, str(CHECKOUT / "scripts" / "development" / "hostile.py"), "--count", "20"],
        env=os.environ | {"CFLAGS": "-O0"},  # to optimise takes most of the time
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


def test_branches_that_were_forged_are_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    orbit = ns.solve(ORBIT)
    ns.continue_orbit(orbit, "V", (0.99, 1.01), points=3).save("branch.json")
    whole = json.loads(Path("branch.json").read_text())
    for name, entry in (
        ("parameter", "speed"),
        ("unknown_names", list("abcdef")),
        ("stability", ["fine"] * len(whole["stability"])),
        ("start", 99),
    ):
        sealed(Path("forged.json"), {**whole, name: entry})
        for command in ("plot forged.json", f"{BRANCH} --resume forged.json --points 3"):
            assert "forged.json: " in refused(*command.split())


@pytest.mark.parametrize("words", ["list", slow("list --json"), "--help"])
def test_a_closed_pipe_is_quiet(words):
    """The reader is gone before the first line: the exit code is that of a closed pipe."""
    reading, writing = os.pipe()
    os.close(reading)
    try:
        ended = subprocess.run(
            [*PROGRAM, *words.split()], stdout=writing, stderr=subprocess.PIPE, check=False
        )
    finally:
        os.close(writing)
    assert (ended.returncode, ended.stderr) == (141, b"")


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="closed by a shell")
@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_a_closed_stream_is_one_that_nobody_reads(closed, tmp_path):
    """Exit codes, files and the other streams are what they are."""
    file = tmp_path / "o.json"
    wrong = closed.startswith("<")
    words = ["list", "no"] if wrong else ["solve", ORBIT, "--save", str(file)]
    command = ["sh", "-c", f'exec "$@" {closed}', "sh", *PROGRAM, *words]
    ended = subprocess.run(command, capture_output=True, check=False)
    assert ended.returncode == (2 if wrong else 0)
    assert bool(ended.stdout) == (closed == "2>&-")
    assert not ended.stderr
    assert wrong or ns.load(file).name == ORBIT


@pytest.mark.slow
def test_pictures_do_not_depend_on_the_users_windows(tmp_path):
    pytest.importorskip("matplotlib")
    ns.solve(ORBIT).save(tmp_path / "o.json")
    subprocess.run(
        [*PROGRAM, "plot", str(tmp_path / "o.json")],
        env=os.environ | {"MPLBACKEND": "nope"},
        check=True,
    )
    assert (tmp_path / "o.png").is_file()
