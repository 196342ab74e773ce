"""The command that designs: what it answers, keeps, draws and refuses."""

import pytest

import nonsmooth as ns
from tests.cli.test_cli import answered, refused, run, told
from tests.places import GALLERY

ORBIT = "dry-friction/symmetric"
STABLEST = ("design", ORBIT, "V=0.3:3", "--minimise", "spectral_radius")


@pytest.mark.slow
def test_numbers_are_those_of_python(tmp_path):
    file, picture = tmp_path / "design.json", tmp_path / "design.png"
    options = ("--save", str(file), "--plot", str(picture), "--require", "stable")
    answer = told(*STABLEST, *options)
    found = ns.design(ns.solve(ORBIT), minimise="spectral_radius", over={"V": (0.3, 3)})
    assert answer["files"] == [str(file), str(picture)]
    assert answer["after"] == {name: repr(value) for name, value in found.after.items()}
    assert answer["orbit"]["stability"] == "stable"
    assert ns.load(file).after == found.after
    assert picture.stat().st_size > 5000
    assert "--overwrite" in refused(*STABLEST, "--save", str(file))
    answered("plot", str(file), "--out", str(tmp_path / "again.png"))


@pytest.mark.slow
def test_people_see_where_it_begins_and_ends():
    out = answered(
        "design", ORBIT, "V=0.6:3", "eta=3:5", "--minimise", "spectral_radius",
        "--subject", "period<=4.6",
    )  # fmt: skip
    assert "an optimum within V<=3.0; two multipliers meet" in out
    assert "active: V<=3.0, multiplier 0.00039" in out
    assert "0.647139" in out


def test_wanted_values_that_are_not_reached():
    ended = run("design", ORBIT, "V=0.6:1.3", "--solve", "period=2")
    assert (ended.code, ended.err) == (1, "nonsmooth: period=2 not reached: within V<=1.3\n")


@pytest.mark.slow
def test_the_worst_along_a_branch(tmp_path):
    damper = f"{GALLERY / 'impact_damper.py'}:struck-twice"
    question = (
        "design", damper, "r=0.3", "zeta=0.05", "d=7:8.5", "--minimise", "peak:x",
        "--worst-over", "w=0.98:1.02",
    )  # fmt: skip
    out = answered(*question)
    assert "worst at: w = 0.98" in out
    assert "active: d<=8.5" in out
    answer = told(*question, "--save", str(tmp_path / "d.json"))
    assert answer["worst_over"] == {"w": ["0.98", "1.02"]}
    assert answer["worst_at"] == ["0.98"]
    answered(*question, "--resume", str(tmp_path / "d.json"))
    error = refused(*question[:-1], "w=0.8:1.05")
    assert "is not there for all w = 0.8 to 1.05" in error


def test_what_is_required_and_not_met():
    options = ("design", ORBIT, "V=0.6:0.7", "--minimise", "period")
    code, _, error = run(*options, "--require", "stable")
    assert (code, error) == (3, "nonsmooth: required: stable; found: unstable\n")
