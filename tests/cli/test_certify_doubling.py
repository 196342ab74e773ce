"""`certify doubling`: the answer, its file, its picture, and going on with it."""

from pathlib import Path

import pytest

from tests.cli.test_cli import run

pytestmark = pytest.mark.compiled  # much slower without it

ASKED = ("certify", "doubling", "dry-friction/symmetric", "V=1.07:1.09", "--tiles", "1")


@pytest.mark.slow
def test_a_flip_is_gone_beyond_saved_drawn_and_checked(tmp_path: Path) -> None:
    file, picture = tmp_path / "doubling.json", tmp_path / "doubling.svg"
    found = run(*ASKED, "--save", str(file), "--plot", str(picture), "--require", "proved")
    assert found.code == 0
    assert "certified doubling of dry-friction/symmetric along V" in found.out
    assert "subcritical" in found.out
    assert "unstable above the flip" in found.out
    assert picture.stat().st_size > 1000
    check = run("certify", "check", str(file), "--require", "proved")
    assert check.code == 0
    assert "proved again from the file" in check.out
    assert run("plot", str(file), "--out", str(tmp_path / "again.svg")).code == 0


def test_a_time_ends_it_and_says_so(tmp_path: Path) -> None:
    file = tmp_path / "short.json"
    found = run(*ASKED, "--seconds", "1e-6", "--save", str(file))
    assert found.code == 1
    assert "ended: unfinished" in found.out
    assert "1e-06 s that were given are over" in found.out
    assert run("certify", "check", str(file)).code == 0
