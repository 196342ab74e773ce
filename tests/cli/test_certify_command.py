"""nonsmooth certify: claims, JSON, exit codes, files."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest

import nonsmooth as ns
from tests.cli.test_cli import Ended, run
from tests.user_systems import declare

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

STICK = "dry-friction/global-stick"


def certify(*arguments: str) -> Ended:
    return run("certify", *arguments)


def test_people_see_claims_reasons_and_margins() -> None:
    code, out, _ = certify("dry-friction/symmetric")
    assert code == 0
    assert "stability refuted: a multiplier lies outside the unit circle" in out
    assert "left open: chosen for this proof" in out
    assert "first-reaches-belt" in out


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (["dry-friction/symmetric", "--require", "proved"], 3, "stability refuted"),
        (["dry-friction/solution-ii"], 1, ""),
        (["dry-friction/solution-ii", "--require", "proved"], 3, "existence undecided"),
        ([STICK, "--require", "proved"], 0, ""),
        (["box", STICK, "V=0.99:1.01", "--require", "proved"], 0, ""),
        (["box", "dry-friction/symmetric", "V=0.7:0.71", "--require", "proved"], 3, "stability"),
        (["box", STICK, "V=30:50"], 1, "no "),
        (["event", "rigid-stop/one-impact", "T=5.5:7.5"], 1, ""),
    ],
)
def test_exit_codes(arguments: list[str], code: int, told: str) -> None:
    found, _, err = certify(*arguments)
    assert found == code
    assert told in err
    assert len(err.splitlines()) == bool(told)


def test_an_orbit_is_certified_with_and_without_the_subcommand() -> None:
    short, long = (certify(*words, STICK, "--json") for words in ((), ("orbit",)))
    assert short == long
    assert short.code == 0


def test_without_an_orbit_the_help_is_shown() -> None:
    code, out, _ = certify()
    assert code == 2
    assert "doubling" in out


def test_derivatives_are_told_saved_and_proved_again(tmp_path: Path) -> None:
    path = tmp_path / "proof.json"
    by = ("--derivatives", "eta,e1")
    code, out, err = certify(STICK, *by, "--json", "--save", str(path))
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["directions"] == {"eta": {"eta": "1"}, "e1": {"ur1": "1"}}
    sharp = ns.refine(ns.solve(STICK), 60).derivatives(["eta", "e1"])
    for quantity in ("tau", "trace", "period"):
        for name, rate in zip(sharp.by, sharp.quantity(quantity)[1], strict=True):
            found = told["derivatives"][quantity][name]
            assert abs(rate - type(rate)(found["mid"])) < float(found["rad"]) < 1e-36
    code, shown, _ = certify(STICK, *by)
    assert code == 0
    assert "derivative" in shown
    assert "with e1 by 1 moves: ur1 by 1" in shown
    code, again, _ = certify("check", str(path))
    assert code == 0
    rows = [line.split() for line in shown.splitlines() if line.strip().startswith("tau1 ")]
    assert rows
    for row in rows:
        if row[1] in ("eta", "e1"):
            assert " ".join(row[2:]) in " ".join(again.split())


def test_people_see_why_there_is_no_derivative() -> None:
    code, out, _ = certify("dry-friction/solution-ii", "--derivatives", "V")
    assert code == 1
    assert "no derivatives: by V: no orbit is proved to exist" in out


def test_a_users_orbit_is_certified_saved_and_checked(tmp_path: Path) -> None:
    declare(tmp_path)
    path = tmp_path / "certificate.json"
    code, out, _ = certify(f"{tmp_path}/mine.py:loop", "k=9/4", "--save", str(path))
    assert code == 0
    assert f"{path} written" in out
    code, out, err = certify("check", str(path))
    assert (code, err) == (0, "")
    assert "every claim holds" in out
    code, out, _ = certify("check", str(path), "--json", "--require", "proved")
    assert code == 0
    assert json.loads(out)["same"] is True


def test_a_check_that_differs_is_told(tmp_path: Path) -> None:
    path = tmp_path / "certificate.json"
    ns.certify(ns.solve(STICK)).save(path)
    path.write_text(path.read_text().replace('"bits": 128', '"bits": 129', 1))
    code, out, err = certify("check", str(path))
    assert (code, out) == (1, "")
    assert "the checksum differs" in err
    code, out, _ = certify("check", str(path), "--json")
    assert code == 1
    assert json.loads(out)["same"] is False


@pytest.mark.slow
def test_a_box_is_proved_saved_resumed_and_drawn(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    path, picture = tmp_path / "map.json", tmp_path / "map.png"
    box = ("box", "dry-friction/symmetric", "V=0.6:1.3")
    code, out, err = certify(*box, "--tiles", "5", "--save", str(path), "--json")
    assert (code, err) == (1, "")  # more than one percent is undecided
    told = json.loads(out)
    assert told["box"] == {"V": ["3/5", "13/10"]}
    assert told["files"] == [str(path)]
    assert told["shares"]["undecided"] > 0.01
    widths = [Fraction(high) - Fraction(low) for (low, high) in (x["V"] for x in told["undecided"])]
    assert float(sum(widths)) == pytest.approx(0.7 * told["shares"]["undecided"])
    assert float(told["enclosures"]["trace"]["rad"]) > 0
    code, out, err = certify(
        "box", "--resume", str(path), "--tiles", "4000", "--plot", str(picture)
    )
    assert (code, err) == (0, "")
    assert "unstable" in out
    assert "not admissible" in out
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert ns.load(path).decided > told["shares"]["proved"]
    again = tmp_path / "again.svg"
    assert run("plot", str(path), "--out", str(again)).code == 0
    assert "svg" in again.read_text()[:300]
