"""Branches in files, pictures, tables and on the command line."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import nonsmooth
from tests.cli.test_cli import run
from tests.core.test_result_files import file_of
from tests.pictures import figure_in

STICK = "dry-friction/global-stick"


@cache
def branch():
    return nonsmooth.load(file_of("nonsmooth branch"))


def test_no_other_file_is_gone_on_with(tmp_path):
    locus = str(file_of("nonsmooth locus"))
    code, _, err = run("continue", STICK, "V=0.9:1.1", "--resume", locus)
    assert (code, f"{locus}: not a saved branch" in err) == (2, True)


def test_as_dataset():
    pytest.importorskip("xarray")
    found = branch().to_xarray()
    np.testing.assert_array_equal(found["V"], branch().parameter_values)
    np.testing.assert_array_equal(found["ta"], branch().quantity("ta"))
    assert found["multiplier"].shape == branch().multipliers.shape


def test_picture(tmp_path):
    pytest.importorskip("matplotlib")
    orbit = nonsmooth.solve("dry-friction/symmetric")
    found = nonsmooth.continue_orbit(orbit, "V", (0.5, 1.3), step=0.05)
    (axes,) = found.plot("tau").axes
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert sorted(labels) == ["flip", "grazing", "not admissible", "stable", "unstable"]
    lines = {line.get_label(): line for line in axes.lines}
    assert lines["unstable"].get_linestyle() == "--"
    assert lines["stable"].get_linestyle() == "-"
    assert max(lines["not admissible"].get_xdata()) <= min(lines["unstable"].get_xdata()) + 1e-12
    flip = next(e for e in found.events if e.kind == "flip")
    assert lines["flip"].get_xdata()[0] == flip.value
    for kind in ("stable", "unstable"):  # one begins where the other ends
        assert flip.value in lines[kind].get_xdata()[[0, -1]]
    assert lines["flip"].get_ydata()[0] == flip.unknowns["tau"]
    assert found.plot("trace", axes) is axes
    assert [text.get_text() for text in axes.get_legend().get_texts()] == labels  # each once
    with pytest.raises(nonsmooth.InputError, match="unknown quantity"):
        found.plot("nothing")
    with pytest.raises(nonsmooth.InputError, match="no quantity is named"):
        found.plot([])


def test_a_saved_branch_is_drawn_as_asked(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    branch().save("branch.json")
    nonsmooth.solve(STICK).save("orbit.json")
    figure = figure_in(
        Path("branch.json"), quantity=("ta", "frequency"), over="trace", frequency="cycles"
    )
    upper, lower = figure.axes
    shown = {tuple(line.get_ydata()) for line in lower.lines}
    cycles = 1 / branch().period
    near = [
        np.isclose(np.array(values)[:, None], cycles, rtol=1e-14).any(axis=1) for values in shown
    ]
    assert any(each.all() for each in near if len(each))
    assert "trace" in lower.get_xlabel()
    assert "t_{a}" in upper.get_ylabel()
    wanted = ("--quantity", "ta,frequency", "--over", "trace")
    assert run("plot", "branch.json", *wanted, "--out", "asked.svg")[0] == 0
    assert Path("asked.svg").read_text() != ""
    for command, told in (
        ("branch.json --kind phase", "a branch has one kind of picture"),
        ("branch.json --quantity nonsense", "unknown quantity 'nonsense'"),
        ("branch.json --over nonsense", "unknown quantity 'nonsense'"),
        ("orbit.json --quantity ta", "quantities are drawn of branches, and orbit.json is none"),
        ("absent.json --quantity ta", "there is no file absent.json"),
        ("absent.json:2 --over ta", "quantities are drawn of branches"),
    ):
        code, _, err = run("plot", *command.split(), "--out", "never.png")
        assert (code, told in err) == (2, True), err
        assert not Path("never.png").exists()


def test_a_picture_that_fails_loses_nothing(tmp_path):
    pytest.importorskip("matplotlib")
    kept, picture = tmp_path / "kept.json", tmp_path / "branch.png"
    asked = f"continue {STICK} V=0.9:1.1 --points 5 --json --quantity energy --save {kept}"
    code, out, err = run(*asked.split(), "--plot", str(picture))
    assert code == 2
    assert len(json.loads(out)["values"]) == len(nonsmooth.load(kept)) > 3
    assert json.loads(out)["files"] == [str(kept)]
    assert "no picture: " in err
