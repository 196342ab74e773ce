"""The oscillator in front of a stop (Sec. 2): resonances, grazing, and ever stiffer stops."""

import numpy as np
import pytest

from nonsmooth import NoConvergence, solve

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
RATIONAL = {"m1": 1, "m2": 2, "k1": 2, "k2": 4}  # frequencies 1 and 2
STIFFNESSES = np.geomspace(1e2, 1e8, 7)


@pytest.mark.parametrize("turns", ["2", "4", "6", "10", "100"])
def test_at_a_resonance_it_says_so(turns, backend):
    """With frequencies 1 and 2 both masses are back after 2 pi: y is free, or nothing fits."""
    with pytest.raises(NoConvergence, match=r"singular: .*resonance.*change a parameter"):
        solve(RIGID, {**RATIONAL, "T": f"{turns}*pi"})
    period = float(turns) * np.pi
    many = solve(RIGID, {**RATIONAL, "T": [period, period * (1 + 1e-6)]})
    assert many.status.tolist() == [5, 0]
    assert "resonance" in many.message(5)
    assert np.isnan(many.unknowns["y"]).tolist() == [True, False]
    assert not many.admissible[0]


@pytest.mark.parametrize("turns", [1, 3, 5])
def test_a_grazing_orbit_is_undecided(turns):
    """After an odd number of half turns only u = 0 fits: the stop is touched, not struck."""
    orbit = solve(RIGID, {**RATIONAL, "T": f"{turns}*pi"})
    assert orbit.unknowns["u"] == pytest.approx(0, abs=1e-13)
    assert orbit.stability.verdict == "undecided"
    moved = solve(RIGID, {**RATIONAL, "T": f"{turns}*pi + 1e-3"})
    assert moved.stability.verdict != "undecided"


def test_grazing_found_by_exchange_is_undecided():
    orbit = solve(RIGID, unknown=["T"], given={"u": 0})
    assert orbit.values["T"] == pytest.approx(7.136044414108058, rel=1e-12)
    assert orbit.stability.verdict == "undecided"


def test_the_elastic_orbit_tends_to_the_rigid_one():
    """O(k3^-1/2) at fixed T, found without a guess; it starts before the contact, not behind."""
    rigid, many = solve(RIGID), solve(ELASTIC, {"k3": STIFFNESSES})
    assert many.admissible.all()
    errors = {
        "y": abs(many.unknowns["y"] - rigid.unknowns["y"]),
        "u": abs(many.unknowns["u"] + rigid.unknowns["u"]),
        "w": abs(many.unknowns["w"]),
        "tau": many.unknowns["tau"],
        "trace": abs(many.trace - rigid.trace),
    }
    for name, found in errors.items():
        rate, _ = np.polyfit(np.log(STIFFNESSES[3:]), np.log(found[3:]), 1)
        assert rate == pytest.approx(-0.5, abs=0.02), name
        assert found[-1] < 1e-3
    half_swings = many.unknowns["tau"] * np.sqrt(STIFFNESSES) / np.pi
    assert half_swings[-1] == pytest.approx(1, abs=1e-3)
