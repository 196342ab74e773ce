"""Orbits that are declared by their phases: solved, reported, saved and drawn as all others."""

import json
import pickle
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import nonsmooth
from nonsmooth import InputError, NoConvergence
from nonsmooth.runtime.model.kernels import load_orbit
from tests.certified import edited
from tests.handmade import DATA, MIRROR, declared, two_stops

NAME = declared().name  # two-stops and left-right
STIFF = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "k3": 1}


@pytest.fixture(autouse=True)
def installed(monkeypatch):
    """The hand-made system and its orbit under names that are loaded."""
    install(monkeypatch, declared())


def install(monkeypatch, kernels):
    def orbit(name):
        return kernels if name == NAME else load_orbit(name)

    monkeypatch.setattr("nonsmooth.runtime.orbits.solve.load_orbit", orbit)


@cache
def orbit(digits=15):
    found = nonsmooth.solve(NAME)
    return replace(found if digits == 15 else nonsmooth.refine(found, digits))


# --- solve


def test_solve_composes():
    found = orbit()
    assert list(found.unknowns) == ["ta", "tb", "x0", "v0", "c0", "s0"]
    assert found.unknowns["ta"] == pytest.approx(np.pi / 1.7, abs=1e-13)
    assert found.unknowns["x0"] == pytest.approx(-0.5, abs=1e-13)
    assert found.stability.verdict == "stable"
    assert {name: value.text for name, value in found.given.items()} == DATA


def test_another_point_is_followed_from_the_reference():
    # from the guess of the dwell times alone Newton's method finds an unstable orbit here
    found = nonsmooth.solve(NAME, {"Omega": "1.75"})
    assert found.stability.verdict == "stable"
    assert found.period == pytest.approx(2 * np.pi / 1.75, rel=1e-13)
    other = nonsmooth.solve(NAME, {"Omega": "1.75"}, {"ta": 1.8, "tb": 1.8})
    assert other.stability.verdict == "unstable"
    assert other.admissibility.verdict is True


def test_guesses_by_name_and_in_order():
    values = orbit().unknowns
    for guess in (
        dict(values),
        {"ta": 1.8, "x": values["x0"], "v": values["v0"]},
        list(values.values()),
        [1.85, 1.85],
    ):
        found = nonsmooth.solve(NAME, {}, guess)
        assert found.period == pytest.approx(orbit().period, rel=1e-13)


def test_a_period_may_be_given(monkeypatch):
    found = nonsmooth.solve(NAME, given={"period": "2*pi/1.7"})
    assert found.converged
    assert found.given["period"].text == "2*pi/1.7"
    with pytest.raises(NoConvergence, match="period"):
        nonsmooth.solve(NAME, given={"period": 3})
    period = {"name": "T", "description": "", "lower": "0", "upper": None, "closed": False}
    reference = {"parameters": {**DATA, "T": "2*pi/1.7"}, "guess": {"ta": "1.8"}}
    install(monkeypatch, declared(period=period, reference=reference, start={"v": "u"}))
    found = nonsmooth.solve(NAME)
    assert list(found.unknowns) == ["ta", "tb", "x0", "u", "c0", "s0"]
    assert found.given["period"].text == "2*pi/1.7"
    assert found.dwell_times == pytest.approx(np.pi / 1.7)


@pytest.mark.parametrize(
    ("arguments", "match"),
    [
        ({"parameters": {"Omga": 1}}, "did you mean 'Omega'"),
        ({"parameters": {"r": 2}}, "outside its domain"),
        ({"guess": {"tc": 1}}, "unknown variable 'tc'"),
        ({"guess": {"ta": -1}}, "positive"),
        ({"guess": {"ta": "soon"}}, "ta"),
        ({"guess": [1, 2, 3]}, "3 values"),
        ({"unknown": ["Omega"], "given": {"ta": 1}}, "Omega, ta cannot be exchanged"),
        ({"given": {"ta": 1}}, "ta cannot be exchanged"),
        ({"given": {"period": -1}}, "positive"),
    ],
)
def test_bad_input(arguments, match):
    with pytest.raises(InputError, match=match):
        nonsmooth.solve(NAME, **arguments)


def test_without_a_guess(monkeypatch):
    install(monkeypatch, declared(reference=None))
    with pytest.raises(InputError, match="declares no guess of ta, tb: give one"):
        nonsmooth.solve(NAME)
    with pytest.raises(InputError, match="declares no guess of tb"):
        nonsmooth.solve(NAME, DATA, {"ta": 1})
    assert nonsmooth.solve(NAME, DATA, {"ta": 1.8, "tb": 1.8}).converged
    with pytest.raises(InputError, match="needs a value for"):
        nonsmooth.solve(NAME, {"d": 1}, {"ta": 1.8, "tb": 1.8})


def test_no_orbit():
    with pytest.raises(NoConvergence, match=NAME):
        nonsmooth.solve(NAME, {"F": "1e-3"})
    assert not nonsmooth.solve(NAME, {"F": "1e-3"}, throw=False).converged


# --- commands


def test_notebooks_and_names():
    text = orbit()._repr_html_()
    assert "two-stops/left-right" in text
    assert "ta = 1.8479956" in text
    assert r"t_{a} &=" in orbit()._repr_latex_()
    bare = nonsmooth.solve(
        two_stops(), DATA, [*orbit().dwell_times, *orbit().states[0]], itinerary=orbit().itinerary
    )
    assert bare.name == "two-stops, 2 phases"
    assert list(bare.unknowns)[:3] == ["tau1", "tau2", "x0"]
    assert bare.to_json()["unknowns"]["tau1"].startswith("1.84799567858")


# --- files


def symmetric():
    return nonsmooth.solve(
        two_stops(), DATA, [1.85], itinerary=[("free", "reaches-right")], symmetry=MIRROR, digits=25
    )


def timed():
    phases = [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")]
    return nonsmooth.solve(
        "elastic-stop", STIFF, [2.1, 4.2], itinerary=phases, given={"period": "2*pi"}
    )


def shown(name):
    """A name without the hash of the data."""
    return re.sub("@[0-9a-f]{16}", "", name).replace(":", "/")


@pytest.mark.parametrize("make", [orbit, lambda: orbit(40), symmetric, timed])
def test_every_digit_comes_back(make, tmp_path):
    path, given = tmp_path / "orbit.json", make()
    given.save(path)
    found = nonsmooth.load(path)
    assert list(found.unknowns) == list(given.unknowns)
    assert found.dwell_times.tolist() == given.dwell_times.tolist()
    assert found.states.tolist() == given.states.tolist()
    assert found.residual == given.residual
    # of a system that is not built in the name gets the hash of its data
    assert shown(found.name) in (given.name, shown(given.name))
    for name in ("itinerary", "digits", "iterations", "precise", "period"):
        assert getattr(found, name) == getattr(given, name)
    assert {n: v.text for n, v in found.given.items()} == {
        n: v.text for n, v in given.given.items()
    }
    assert (found.symmetry is None) == (given.symmetry is None)
    assert found.stability.verdict == given.stability.verdict
    again = pickle.loads(pickle.dumps(given))
    assert again.to_json() == found.to_json()
    second = tmp_path / "second.json"
    found.save(second)
    assert second.read_bytes() == path.read_bytes()


@pytest.fixture
def path(tmp_path):
    target = tmp_path / "orbit.json"
    orbit().save(target)
    return target


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda c: c["unknowns"].update({c["names"][0]: "1.84799567"}), "not a solution"),
        (lambda c: c["starts"][0].__setitem__(1, "0.6819909"), "not a solution"),
        (lambda c: c["itinerary"][0].__setitem__(1, "reaches-left"), "not a solution"),
        (lambda c: c["given"].update(d="0.51"), "not a solution"),
        (lambda c: c.update(residual="1.0"), "not a solution"),
        (lambda c: c["unknowns"].update({c["names"][0]: "-1.8"}), "not positive"),
        (lambda c: c["unknowns"].pop(c["names"][0]), "4 states"),
        (lambda c: c["unknowns"].update(another="1.0"), "4 states"),
        (lambda c: c["itinerary"][0].__setitem__(1, "nowhere"), "unknown boundary"),
        (lambda c: c["starts"][0].pop(), "starts"),
        (lambda c: c["starts"].pop(), "starts"),
        (lambda c: c["starts"].__setitem__(0, [1, 2, 3, 4]), "starts"),
        (lambda c: c.update(itinerary=[]), "empty"),
        (lambda c: c["opened"].update(d="1"), "no orbit by tables has"),
        (lambda c: c.update(orbit="nothing"), "unknown orbit 'nothing'"),
        (lambda c: c["names"].pop(), "4 states"),
        (lambda c: c["names"].__setitem__(0, c["names"][1]), "4 states"),
        (lambda c: c["given"].pop("d"), "needs a value"),
        (lambda c: c.update(system="two-stop", tables=None), "unknown system"),
        (lambda c: c.update(digits=16), "digits"),
        (lambda c: c.update(status=1), "status"),
        (lambda c: c.update(arithmetic="decimal"), "arithmetic"),
        (lambda c: c.update(symmetry=[[1, 0, 0, 0]]), "symmetry"),
        (lambda c: c["given"].update(period="two"), "period"),
    ],
)
def test_what_is_no_orbit_is_refused(path, change, match):
    path.write_text(json.dumps(edited(path, change)))
    with pytest.raises(InputError, match=match) as caught:
        nonsmooth.load(path)
    assert "\n" not in str(caught.value)


def test_what_has_not_converged_is_not_saved(tmp_path):
    lost = nonsmooth.solve(NAME, {"F": "1e-3"}, throw=False)
    with pytest.raises(InputError, match="not saved"):
        lost.save(tmp_path / "orbit.json")


# --- pictures
