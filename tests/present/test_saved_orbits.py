"""Orbits in files, found or saved: every command takes them by name."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from tests.cli.test_cli import refused, run, told
from tests.places import GALLERY
from tests.present.test_saved import sealed

DATA = {"d": "1/2", "r": "0.8", "w": "1.5"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a declaration that names no orbit, and what was found of it."""
    folder = tmp_path_factory.mktemp("saved")
    text = (GALLERY / "two_stops.py").read_text()
    (folder / "gear.py").write_text(text[: text.index("RIGHT, LEFT")])
    found = ns.find_orbits(folder / "gear.py", DATA, 20, transitions=300, rng=1)
    assert len(found.orbits) > 1
    found.save(folder / "found.json")
    return folder


@pytest.fixture(autouse=True)
def there(folder, monkeypatch):
    monkeypatch.chdir(folder)


def test_each_found_orbit_is_solved_at_its_own_parameters():
    found = ns.load("found.json")
    for number, entry in enumerate(found.orbits, 1):
        orbit = ns.solve(f"found.json:{number}")
        assert {name: value.text for name, value in orbit.given.items()} == DATA
        np.testing.assert_allclose(orbit.dwell_times, entry.orbit.dwell_times, rtol=1e-12)
        np.testing.assert_allclose(orbit.states, entry.orbit.states, atol=1e-12)


def test_parameters_are_changed_by_name():
    orbit = ns.solve("found.json:2", {"d": "0.48"})
    composed = ns.solve(
        "gear.py",
        {**DATA, "d": "0.48"},
        [*orbit.dwell_times, *orbit.states[0]],
        itinerary=orbit.itinerary,
    )
    np.testing.assert_allclose(orbit.dwell_times, composed.dwell_times, rtol=1e-13)
    found = ns.load("found.json").orbits[1].orbit
    assert (orbit.dwell_times[0] > np.pi / 1.5) == (found.dwell_times[0] > np.pi / 1.5)
    with pytest.raises(ns.InputError, match="nonsense"):
        ns.solve("found.json:2", {"nonsense": 1})


def test_every_command_takes_one_of_the_orbits(folder):
    solved = told("solve", "found.json:2", "d=0.48", "--digits", "30", "--save", "one.json")
    assert solved["digits"] == 30
    again = told("solve", "one.json")
    assert float(again["parameters"]["d"]) == 0.48
    assert again["unknowns"]["tau1"][:14] == solved["unknowns"]["tau1"][:14]
    assert told("verify", "found.json:1")["stability"] == "stable"
    branch = told("continue", "found.json:2", "d=0.49:0.51", "--step", "0.1")
    assert branch["ends"] == ["end of the interval", "end of the interval"]
    claims = told("certify", "found.json:2", "--save", "proof.json")["claims"]
    assert set(claims.values()) == {"proved"}
    assert told("certify", "check", "proof.json")["same"]
    chart = told("chart", "found.json:2", "d=0.49:0.5:2", "w=1.5:1.51:2", "--out", "c.zarr")
    assert chart["points"]["stable"] == 4
    assert told("plot", "c.zarr")["chart"] == "two-stops"
    assert told("plot", "found.json:2", "--kind", "phase")["file"] == "found-2.png"
    assert (folder / "found-2.png").is_file()


def test_the_listing_of_a_file_tells_why_an_orbit_is_none():
    wanted = told("list", "found.json")["systems"]
    content = json.loads(Path("found.json").read_text())
    content["orbits"][0]["dwell_times"][0] = "1e-16"
    sealed(Path("bad.json"), content)
    (system,) = told("list", "bad.json")["systems"]
    bad, *others = system.pop("orbits")
    assert (bad["name"], set(bad)) == (str(Path("bad.json").resolve()) + ":1", {"name", "refused"})
    assert len(others) > 0
    for other, orbit in zip(others, wanted[0].pop("orbits")[1:], strict=True):
        renamed = {"name": orbit["name"].replace("found.json", "bad.json")}
        assert other == {**orbit, **renamed}
    assert system == wanted[0]
    _, shown, _ = run("list", "bad.json")
    (line,) = [line for line in shown.splitlines() if "refused" in line]
    for asking in ("list", "solve"):
        code, _, err = run(asking, "bad.json:1")
        assert code == 2
        assert "orbit 1, of period" in err
        assert err.strip() == f"nonsmooth: error: {bad['refused']}"
        assert line.strip() == f"refused: {bad['refused']}"
    assert run("list", "bad.json:2")[0] == 0


def test_a_saved_derived_orbit_is_the_reference():
    first = told("solve", "dry-friction/global-stick", "V=1.1", "us1=1", "--save", "gs.json")
    again = told("solve", "gs.json")
    assert {**first, "residual": ""} == {**again, "residual": "", "file": "gs.json"}
    moved = told("solve", "gs.json", "eta=1.01")
    wanted = told("solve", "dry-friction/global-stick", "V=1.1", "eta=1.01", "us1=1")
    assert moved["trace"][:14] == wanted["trace"][:14]
    assert moved["parameters"] == wanted["parameters"]
    exchange = ("--unknown", "e1,e2", "--given", "ta=1,tau=2", "--save", "ex.json")
    swapped = told("solve", "dry-friction/global-stick", *exchange)
    assert told("solve", "ex.json")["trace"][:13] == swapped["trace"][:13]


def test_a_symmetric_orbit_is_saved_with_its_symmetry():
    turned = {"x": "-x", "v": "-v", "c1": "-c1", "s1": "-s1"}
    half = [("free-free", "right-reaches-stop")]
    orbit = ns.solve("gear.py", {**DATA, "d": "0.6"}, [2.1], itinerary=half, symmetry=turned)
    orbit.save("half.json")
    again = ns.solve("half.json", {"d": "0.61"})
    assert again.symmetry is not None
    assert again.dwell_times[0] == again.dwell_times[1]


def test_a_timed_orbit_keeps_its_period():
    data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    phases = [("free", "first-reaches-stop")]
    ns.solve("rigid-stop", data, [3.7], itinerary=phases, given={"period": "3.7"}).save(
        "timed.json"
    )
    assert ns.solve("timed.json").period == pytest.approx(3.7, abs=1e-13)
    assert ns.solve("timed.json", {"period": "3.8"}).period == pytest.approx(3.8, abs=1e-13)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("found.json", "orbits: say which, found.json:1 ... found.json:"),
        ("found.json:0", "holds no orbit 0"),
        ("found.json:99", "holds no orbit 99; there is found.json:1 ... found.json:"),
        ("found.json:two", "'two' is no number of an orbit"),
        ("none.json:1", "there is no file none.json"),
        ("gear.py", "nonsmooth find gear.py"),
        ("broken.json:1", "not a saved orbit"),
    ],
)
def test_what_is_no_orbit_is_told_in_one_line(folder, name, message):
    (folder / "broken.json").write_text("{}")
    assert message in refused("solve", name)


def test_a_file_lists_its_orbits_with_the_parameters_of_its_system(folder):
    (declared,) = told("list", "gear.py")["systems"]
    (found,) = told("list", "found.json")["systems"]
    count = len(ns.load("found.json").orbits)
    assert count > 1
    assert [each["name"] for each in found["orbits"]] == [
        str(folder / f"found.json:{number + 1}") for number in range(count)
    ]
    assert found["configurations"] == declared["configurations"]
    assert found["parameters"] == declared["parameters"]
    (third,) = told("list", "found.json:2")["systems"]
    assert third["orbits"] == found["orbits"][1:2]
    assert {p["name"]: p["default"] for p in third["orbits"][0]["parameters"]} == DATA


BUMP = """
import sympy as sp
from nonsmooth.derive import Harmonic, SoftStop, oscillator

rubber = SoftStop("x", at=1, stiffness=19, name="rubber")
system = oscillator("bump", ["x"], mass=[[1]], damping=[["0.16"]], stiffness=[[1]],
                    forcing=[Harmonic(sp.Symbol("w"), cosine=[1])], elements=[rubber])
"""


def test_orbits_that_reach_no_boundary_are_not_appended(folder):
    """At w = 1.45 the linear response stays before the stop, and another orbit strikes it."""
    file = folder / "bump.py"
    file.write_text(BUMP)
    options = ("--starts", "10", "--transitions", "100", "--write", "bump.py")
    answer = told("find", "bump.py", "w=1.45", *options)
    reach = [all(phase["boundary"] != "forcing-phase" for phase in orbit["itinerary"])
             for orbit in answer["orbits"]]  # fmt: skip
    assert set(reach) == {False, True}
    assert answer["itineraries"] == [f"found-{k + 1}" for k in range(sum(reach))]
    striking = answer["orbits"][reach.index(True)]
    assert ns.solve("bump.py:found-1").period == pytest.approx(float(striking["period"]))
    count = len(answer["itineraries"])
    known = [f"found-1{k + 1}" for k in range(count)]
    file.write_text(file.read_text().replace("found-", "found-1"))
    again = told("find", "bump.py", "w=1.45", *options)["itineraries"]
    assert again == [f"found-{10 + count + k + 1}" for k in range(count)]
    names = [orbit["name"] for orbit in told("list", "bump.py")["systems"][0]["orbits"]]
    assert [name.rpartition(":")[2] for name in names] == [*known, *again]
    text = file.read_text()
    code, out, err = run("find", "bump.py", "w=3", *options)
    assert (code, file.read_text()) == (2, text)
    assert "error: not saved: no orbit that reaches a boundary was found" in err
    assert "1 periodic orbit from 10 starts" in out


def test_what_was_found_is_shown_though_it_cannot_be_appended(folder):
    """To a declaration that would not import, which stays as it is."""
    file = folder / "closed.py"
    before = f"{BUMP}\nassert __file__.endswith('closed.py')\n"
    file.write_text(before)
    options = ("--starts", "4", "--transitions", "100", "--write", "closed.py")
    code, out, err = run("find", "closed.py", "w=1.2", *options, "--json")
    assert code == 2
    assert "error: not saved" in err
    assert json.loads(out)["orbits"]
    assert file.read_text() == before


def test_nothing_is_appended_to_another_file(folder):
    shutil.copy(folder / "gear.py", folder / "other.py")
    for target in ("other.py", "missing.py", "found.json"):
        code, _, err = run("find", "gear.py", "d=0.5", "r=0.8", "w=1.5", "--write", target)
        assert code == 2
        assert "not the" in err
    code, _, err = run("find", "rigid-stop", "m1=1", "--write", "other.py")
    assert code == 2
