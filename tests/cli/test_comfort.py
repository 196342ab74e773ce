"""What makes the command line pleasant: completion, doctor, `python -m`, and whole lists."""

import importlib
import os
import shutil
import subprocess
import sys
from importlib import metadata, util
from pathlib import Path
from types import ModuleType

import pytest

from tests.cli.test_cli import run, told
from tests.places import GALLERY
from tests.tables import slow
from tests.user_systems import declare

COMMAND = Path(sys.executable).with_name("nonsmooth")
BASH = shutil.which("bash")
COMPILED = ("nonsmooth.generated._kernels", "nonsmooth.runtime._engine")


def diagnoses():
    """What the doctor says, by names."""
    return {entry["name"]: entry for entry in told("doctor")["diagnoses"]}


def in_bash(script, home, **environment):
    """What a script of a shell prints whose home folder is empty."""
    done = subprocess.run(
        [str(BASH), "--norc", "-c", script],
        cwd=home,
        env=os.environ
        | {"HOME": str(home), "PATH": f"{COMMAND.parent}{os.pathsep}{os.environ['PATH']}"}
        | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    """A home folder in which the completion is installed."""
    folder = tmp_path_factory.mktemp("home")
    in_bash("nonsmooth --install-completion; true", folder)
    declare(folder)
    (folder / "kept.json").touch()
    (folder / "kept.txt").touch()
    return folder


@pytest.mark.skipif(BASH is None, reason="there is no bash")
@pytest.mark.parametrize(
    ("words", "completed"),
    [
        slow("nonsmooth doc", {"doctor"}),
        ("nonsmooth solve dry-friction/g", {"dry-friction/global-stick"}),
        ("nonsmooth solve --unkn", {"--unknown"}),
        ("nonsmooth solve nowhere", set()),
        ("nonsmooth certify dry-friction/g", {"dry-friction/global-stick"}),
        ("nonsmooth certify dou", {"doubling"}),
        ("nonsmooth certify check kep", {"kept.json"}),
        ("nonsmooth solve dry-friction/global-stick us", {"us1=", "us2="}),
        ("nonsmooth certify dry-friction/global-stick us1 = 1 us", {"us2="}),
        slow("nonsmooth sweep rigid-stop k", {"k1=", "k2="}),
        ("nonsmooth solve mi", {"mine.py"}),
        ("nonsmooth solve mine.py : lo", {"loop"}),  # as bash breaks it
    ],
)
def test_bash_completes_after_the_installation(words, completed, home):
    assert "nonsmooth.sh" in (home / ".bashrc").read_text(encoding="utf-8")
    count = len(words.split()) - 1
    told = in_bash(
        f"source .bashrc; COMP_WORDS=({words}); COMP_CWORD={count};"
        " $(complete -p nonsmooth | sed 's/.*-F \\([^ ]*\\) .*/\\1/') nonsmooth;"
        ' printf "%s\\n" "${COMPREPLY[@]}"',
        home,
    )
    assert set(told.split()) == completed


def test_doctor_names_every_requirement_and_extra():
    found = diagnoses()
    assert found["nonsmooth"]["found"] == metadata.version("nonsmooth")
    for package in ("mpmath", "numpy", "python-flint", "rich", "scipy", "sympy", "typer"):
        assert found[package]["found"] == metadata.version(package)
        assert found[package]["good"]
    extras = {name.split()[1].rstrip(":") for name in found if name.startswith("extra ")}
    assert extras == {"plot", "html", "chart", "speed", "jax", "torch"}
    assert set(found["Python"]) == {"name", "good", "found", "remedy"}


def test_doctor_says_what_to_do(monkeypatch, tmp_path):
    def absent(name):
        raise metadata.PackageNotFoundError(name)

    find = util.find_spec
    monkeypatch.setattr(
        metadata, "version", lambda name: "0" if name == "nonsmooth" else absent(name)
    )
    monkeypatch.setattr(
        util, "find_spec", lambda name, *rest: None if name in COMPILED else find(name, *rest)
    )
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("CC", "cc")
    monkeypatch.setenv("NONSMOOTH_BACKEND", "fortran")
    found = diagnoses()
    assert found["numpy"]["remedy"] == 'pip install "numpy>=2.0"'
    assert "compiler" in found["compiled kernels"]["remedy"]
    assert "'fortran'" in found["what computes"]["found"]
    assert found["extra plot: pictures"]["remedy"] == 'pip install "nonsmooth[plot]"'
    assert not found["LaTeX"]["good"]
    assert not found["kernels of your own systems"]["good"]
    assert all(each["remedy"] for each in found.values() if not each["good"])


@pytest.mark.compiled
def test_doctor_notices_kernels_of_another_derivation(monkeypatch):
    compiled = importlib.import_module(COMPILED[0])
    older = ModuleType(COMPILED[0])
    vars(older).update(vars(compiled) | {"derivation_dry_friction": "0" * 16})
    assert diagnoses()["compiled kernels"]["good"]
    monkeypatch.setitem(sys.modules, COMPILED[0], older)
    found = diagnoses()["compiled kernels"]
    assert not found["good"]
    assert "dry-friction" in found["found"]
    assert "elastic-stop" not in found["found"]
    assert "install the package again" in found["remedy"]


@pytest.mark.parametrize(("version", "good"), [("1.2.9", False), ("1.3", True), ("1.10.0", True)])
def test_doctor_compares_versions_as_numbers(version, good, monkeypatch):
    monkeypatch.setattr(metadata, "version", lambda name: version)
    assert diagnoses()["mpmath"]["good"] is good


def test_list_shows_the_whole_system():
    _, shown, _ = run("list", str(GALLERY / "impact_oscillator.py"))
    for words in ("states: x v c1 s1", "0 < w", "0 <= r <= 1", "wall-reaches-stop", "exceeded"):
        assert words in shown
    assert "free or contact" in shown
