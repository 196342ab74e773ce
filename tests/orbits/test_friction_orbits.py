"""The symmetric friction orbit (Sec. 3.2) and the border collision at ta = 0 (Sec. 3.3)."""

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError, NoConvergence, refine, solve
from nonsmooth.runtime.model.kernels import load_orbit
from tests.declared import Declared

SYMMETRIC, STICK = "dry-friction/symmetric", "dry-friction/global-stick"
BORDER = "dry-friction/solution-ii"
MULTIPLIERS = (-1.44546317, -0.12198051)


def test_the_symmetric_orbit_is_unstable():
    orbit = solve(SYMMETRIC)
    assert orbit.stability.verdict == "unstable"
    found = [complex(m.real, m.imaginary) for m in orbit.stability.multipliers]
    assert_allclose(found, MULTIPLIERS, atol=1e-8)


def test_forces_on_the_first_mass_decide_nothing():
    plain = solve(SYMMETRIC)
    paper = {"us1": "0.0127", "ur1": "0.0255", "us2": "0.5", "ur2": "1"}
    assert solve(SYMMETRIC, paper).admissibility.verdict is True
    assert solve(SYMMETRIC, paper).unknowns == plain.unknowns
    for given in ({"us1": 5}, {"ur1": "1/3"}, {"us1": "0.1", "ur1": "0.1"}, {"e1": 2}):
        orbit = solve(SYMMETRIC, given)
        assert orbit.unknowns == plain.unknowns
        assert orbit.given == plain.given
        assert orbit.admissibility == plain.admissibility
    with pytest.raises(InputError, match="us1 = -1 is outside its domain"):
        solve(SYMMETRIC, {"us1": -1})
    with pytest.raises(InputError, match="e1 decides nothing about dry-friction/symmetric"):
        solve(SYMMETRIC, {"e1": [1.0]})


# --- the border collision ---------------------------------------------------------------


def test_both_boundaries_are_met_at_one_instant():
    for parameters in ({}, {"eta": "1.2", "V": "0.9"}, {"chi": "0.4", "e2": "0.6"}):
        orbit = solve(BORDER, parameters)
        values = orbit.values
        z1, z2, v1, v2 = Declared(orbit).end[:4, 0]
        assert v2 == pytest.approx(values["V"], abs=1e-12)  # the second mass reaches the belt
        assert v1 == pytest.approx(values["V"], abs=1e-12)
        assert z1 - values["chi"] * z2 == pytest.approx(values["e1"], abs=1e-12)
        (meeting,) = orbit.admissibility.coincidences
        assert meeting.phase == 0
        assert meeting.boundaries == ("second-reaches-belt", "first-breaks-forward")
        assert meeting.time == pytest.approx(orbit.period, rel=1e-15)
        assert orbit.dwell_times[orbit.dwell_time_names.index("ta")] == 0
        assert orbit.stability.one_sided == "ta > 0"
    assert solve(STICK).admissibility.coincidences == ()
    assert solve(STICK).stability.one_sided == ""


def test_the_excess_is_solved_for_and_may_be_exchanged():
    kernels = load_orbit(BORDER)
    assert kernels.solved_for == ("e1",)
    plain = solve(BORDER)
    with pytest.raises(InputError, match=r"e1 is an unknown of .*--unknown NAME --given e1=3"):
        solve(BORDER, {"e1": 3})
    for name in ("V", "e2", "chi", "eta"):
        found = solve(BORDER, unknown=[name], given={"e1": 2.5})
        assert found.values["e1"] == 2.5
        assert set(found.unknowns) == {*plain.unknowns, name} - {"e1"}
        again = solve(BORDER, {p: found.values[p] for p in kernels.parameter_names})
        assert again.unknowns["e1"] == pytest.approx(2.5, rel=1e-10)
        assert again.trace == pytest.approx(found.trace, rel=1e-9)
    back = solve(BORDER, unknown=["V"], given={"e1": plain.unknowns["e1"]})
    assert back.unknowns["V"] == pytest.approx(1, rel=1e-12)
    with pytest.raises(NoConvergence, match="outside its domain"):
        solve(BORDER, unknown=["V"], given={"e1": -1})


@pytest.mark.parametrize("side", [1, -1])
def test_a_dwell_time_within_its_error_is_none(side):
    """Beside the border an orbit is told where its short phase is longer than its own error."""
    border = refine(solve(BORDER), 40).unknowns
    near = {name: float(x) for name, x in border.items() if name != "e1"} | {"ta": 1e-3}
    beside = solve(STICK, {"e1": float(border["e1"]) + 1e-5}, near)
    slope = beside.derivatives("e1").unknowns["ta"][0]
    offsets = side * np.logspace(-16, -8, 33)
    with mpmath.workdps(40):
        limits = [mpmath.nstr(border["e1"] + mpmath.mpf(offset), 40) for offset in offsets]
    orbits = [solve(STICK, {"e1": limit}, near, throw=False) for limit in limits]
    many = solve(STICK, {"e1": np.array(limits, dtype=float)})
    told = np.array([orbit.converged for orbit in orbits])
    assert_array_equal(told, many.converged & many.admissible)
    assert_array_equal(told, [orbit.admissibility.verdict == "conditional" for orbit in orbits])
    assert (told == (offsets > 0))[abs(offsets) > 1e-12].all()
    times = np.array([orbit.unknowns["ta"] for orbit in orbits])
    assert (abs(times - slope * offsets) < times)[told].all()
