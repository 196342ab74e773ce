"""Ctrl-C: a real signal to each long command, what it keeps, and the command that goes on."""

from __future__ import annotations

import os
import re
import select
import shlex
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth.runtime.cli.program import app
from tests.places import CHECKOUT

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

pty = pytest.importorskip("pty")  # progress is shown on terminals alone

FRICTION = "chi=0.4 eta=4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
REST = "--from x1=0,x2=0,v1=0,v2=0"


class Ended(NamedTuple):
    code: int
    said: str  # the last line on stderr
    goes_on: list[str]  # arguments of the command that it names


def interrupted(arguments: str, when: str, folder: Path) -> Ended:
    """A command that gets SIGINT as soon as its progress shows something."""
    terminal, its = pty.openpty()
    paths = [str(CHECKOUT), *filter(None, [os.environ.get("PYTHONPATH")])]
    process = subprocess.Popen(
        [sys.executable, "-m", "tests.cli.interrupting", when, *shlex.split(arguments)],
        stdout=subprocess.DEVNULL,
        stderr=its,
        cwd=folder,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join(paths),
            "TERM": "xterm",
            "COLUMNS": "300",
        },
    )
    os.close(its)
    text = ""
    try:
        while select.select([terminal], [], [], 120)[0]:
            text += os.read(terminal, 1 << 16).decode()
    except OSError:  # the other end is closed
        pass
    finally:
        os.close(terminal)
        process.wait(120)
    lines = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", text).strip().splitlines()
    said = lines[-1]
    assert sum("interrupted" in line for line in lines) == 1
    program, *goes_on = shlex.split(said.partition(" with: ")[2])
    assert program == "nonsmooth"
    return Ended(process.returncode, said, goes_on)


def run(*arguments: str, folder: Path) -> tuple[int, str]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        result = CliRunner().invoke(app, arguments)
    finally:
        os.chdir(before)
    return result.exit_code, result.output


@pytest.mark.parametrize(
    ("arguments", "when", "file", "told"),
    [
        pytest.param(
            "certify box dry-friction/symmetric V=0.6:1.3 --tiles 6 --save map.json --plot a.png",
            r"[1-9]\d* tiles",
            "map.json",
            "kept in map.json; go on with: ",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            f"sweep dry-friction V=0.5:1.2:500 {FRICTION} --quantity x1 --at slip-stick {REST}"
            " --transient 200 --save part.json --plot a.png",
            r"[1-9]\d*/500",
            "part.json",
            "of 500 values are done, kept in part.json; go on with: ",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "continue dry-friction/global-stick V=0.99:1.01 --step 1e-4 --points 1000000"
            " --save b.json --plot a.png",
            r"[1-9]\d+/2000000",  # one point is no branch
            "b.json",
            "points are done, kept in b.json; go on with: ",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "design dry-friction/symmetric V=0.6:3 eta=3:5 --minimise spectral_radius"
            " --subject period<=4.6 --save d.json",
            r"[3-9]/\?",
            "d.json",
            "iterates are done, kept in d.json; go on with: ",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            f"find dry-friction V=0.6773 {FRICTION} --starts 60 --save found.json",
            "looking for unstable",
            "found.json",
            "orbits and equilibria are found, kept in found.json; begin again with: ",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "certify event dry-friction/symmetric V=0.6:1.3 --digits 1500 --save events.json",
            r"[1-9]\d*/\d",
            "events.json",
            "1 of 2 events are done, kept in events.json; go on with: ",
            marks=pytest.mark.slow,
        ),
        (
            "certify all dry-friction/global-stick tau=0:20 tau1=0:20 --save census.json",
            "searching",
            "census.json",
            "orbits found, kept in census.json; begin again with: ",
        ),
        pytest.param(
            "chart dry-friction/global-stick V=0.8:1.3:200 eta=0.8:1.3:200 --chunk 400"
            " --out F.zarr",
            r"[1-9]\d*/\d+",
            "F.zarr",
            "chunks are kept in F.zarr; go on with: ",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_each_long_command_keeps_what_it_has(
    arguments: str, when: str, file: str, told: str, tmp_path: Path
) -> None:
    ended = interrupted(arguments, when, tmp_path)
    assert ended.code == 130
    assert ended.said.startswith("nonsmooth: interrupted: ")
    assert told in ended.said
    kept = ns.load(tmp_path / file)
    assert (tmp_path / "a.png").exists() == ("a.png" in arguments)
    if file == "found.json":
        assert not kept.complete
        assert run("plot", file, folder=tmp_path)[0] == 0
    if file == "events.json":
        assert [event.proved for event in kept] == [True]
    if file == "census.json":
        assert not kept.decided
    if file == "F.zarr":
        assert (kept.status.values != -128).any()


@pytest.mark.slow
def test_what_is_written_at_once_leaves_nothing(tmp_path: Path) -> None:
    ended = interrupted("reproduce --out new/paper", "orbit rigid", tmp_path)
    assert ended.code == 130
    assert "nothing is kept; begin again with: " in ended.said
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arguments",
    [
        "certify box dry-friction/global-stick V=0.99:1.01",
        "certify dry-friction/global-stick",
        "certify all dry-friction/global-stick tau=0:3 tau1=0:3",
        "continue dry-friction/global-stick V=0.99:1.01",
        f"find dry-friction V=0.6773 {FRICTION}",
        f"sweep dry-friction V=0.5:1.2:5 {FRICTION} --quantity x1 --at slip-stick {REST}",
        "design dry-friction/symmetric V=0.6:1.3 --minimise period",
    ],
)
def test_no_file_is_replaced_unasked(arguments: str, tmp_path: Path) -> None:
    ns.solve("dry-friction/global-stick").save(tmp_path / "file.json")
    before = (tmp_path / "file.json").read_bytes()
    asked = (*arguments.split(), "--save", "file.json")
    code, told = run(*asked, folder=tmp_path)
    assert code == 2
    assert "file.json is there already: " in told
    assert "--overwrite replaces it" in told
    assert (tmp_path / "file.json").read_bytes() == before
    resumes = "find" not in arguments and ":" in arguments and "certify all" not in arguments
    assert ("--resume file.json goes on with it" in told) == resumes
    if arguments.startswith("certify dry-friction"):
        assert run(*asked, "--overwrite", folder=tmp_path)[0] == 0
        assert type(ns.load(tmp_path / "file.json")).__name__ == "Certificate"
