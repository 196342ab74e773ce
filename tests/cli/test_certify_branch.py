"""`certify branch`: the answer, its file, its picture, and going on with it."""

import json
from pathlib import Path

import pytest

from tests.cli.test_cli import run

pytestmark = pytest.mark.compiled  # much slower without it

ASKED = ("certify", "branch", "dry-friction/symmetric", "V=0.9:1.2")


@pytest.mark.slow
def test_a_branch_is_proved_saved_drawn_and_checked(tmp_path: Path) -> None:
    file, picture = tmp_path / "branch.json", tmp_path / "branch.svg"
    found = run(*ASKED, "--save", str(file), "--plot", str(picture), "--require", "proved")
    assert found.code == 0
    assert "consists of exactly these intervals and events" in found.out
    assert "flip" in found.out
    assert picture.stat().st_size > 1000
    check = run("certify", "check", str(file), "--require", "proved")
    assert check.code == 0
    assert "proved again from the file" in check.out
    drawn = run("plot", str(file), "--out", str(tmp_path / "again.svg"))
    assert drawn.code == 0


@pytest.mark.slow
def test_it_goes_on_with_what_was_kept(tmp_path: Path) -> None:
    file = tmp_path / "branch.json"
    part = run(*ASKED, "--tiles", "1", "--save", str(file))
    assert part.code == 1
    assert "not followed further" in part.out
    late = run(*ASKED, "--seconds", "1e-6", "--json")
    assert late.code == 1
    assert json.loads(late.out)["tiles"] == json.loads(file.read_text())["tiles"]
    required = run(*ASKED, "--tiles", "1", "--require", "proved")
    assert required.code == 3
    whole = run("certify", "branch", "--resume", str(file), "--tiles", "2000", "--json")
    assert whole.code == 0
    told = json.loads(whole.out)
    assert told["claims"] == {"branch": "proved"}
    assert [part["verdict"] for part in told["intervals"]] == ["unstable", "stable"]
    assert told["events"][0]["enclosures"]["V"]["mid"].startswith("1.0805880741771120197670640759")
    assert len(told["tiles"]) == len(json.loads(file.read_text())["tiles"])
