"""The symmetric friction orbit (Sec. 3.2) and the border collision at ta = 0 (Sec. 3.3)."""

from __future__ import annotations

from functools import cache

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError, NoConvergence, refine, solve
from nonsmooth.runtime.model.kernels import load_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from tests.coulomb_friction import Friction
from tests.declared import Declared, random_points, single

SYMMETRIC, STICK = "dry-friction/symmetric", "dry-friction/global-stick"
BORDER = "dry-friction/solution-ii"
MULTIPLIERS = (-1.44546317, -0.12198051)


@cache
def symmetric_orbits() -> tuple[Orbit, ...]:
    points = random_points(SYMMETRIC, 81, 60)
    many = solve(SYMMETRIC, points)
    found = [solve(SYMMETRIC)]
    for i in np.flatnonzero(many.admissible)[:4]:
        found.append(single(many, i))
    assert len(found) == 5
    return tuple(found)


def multipliers(orbit: Orbit) -> np.ndarray:
    return np.array([complex(m.real, m.imaginary) for m in orbit.stability.multipliers])


# --- the symmetric orbit ----------------------------------------------------------------


def test_the_printed_times_hold_to_two_per_mille() -> None:
    orbit = solve(SYMMETRIC)
    for name, printed in (("tau", 2.65), ("tau1", 2.2407)):
        assert orbit.unknowns[name] == pytest.approx(printed, rel=2e-3)
        assert orbit.unknowns[name] != pytest.approx(printed, abs=4e-4)


def simulated(orbit: Orbit) -> tuple[Friction, np.ndarray]:
    """A simulator that knows Coulomb's law alone, and the physical start of the orbit."""
    us2 = max(r.greater_than for r in orbit.admissibility.requires if r.parameter == "us2") + 0.4
    friction = Friction(orbit.values | {"e1": 0.1}, 0.3, us2)
    start = np.append(orbit.states[0], 1.0)
    start[:2] += friction.centre()
    return friction, start


def turn(friction: Friction, start: np.ndarray) -> tuple[np.ndarray, list[float]]:
    """Both masses slip, then the second sticks until it breaks away."""
    times: list[float] = []
    state, slips = friction.advance(start, np.array([True, True]), times)
    assert slips.tolist() == [True, False]
    state, slips = friction.advance(state, slips, times)
    assert slips.tolist() == [True, True]
    return state, times


def test_coulombs_law_gives_the_symmetric_orbit() -> None:
    for orbit in symmetric_orbits():
        friction, start = simulated(orbit)
        end, times = turn(friction, start)
        assert_allclose(end, start, atol=1e-9)
        assert_allclose(times, orbit.dwell_times.tolist(), atol=1e-9)


def test_the_symmetric_orbit_is_unstable() -> None:
    orbit = solve(SYMMETRIC)
    assert orbit.stability.verdict == "unstable"
    assert_allclose(multipliers(orbit), MULTIPLIERS, atol=1e-8)


def test_forces_on_the_first_mass_decide_nothing() -> None:
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


def test_both_boundaries_are_met_at_one_instant() -> None:
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


def test_it_is_the_limit_of_global_stick_orbits() -> None:
    """Linearly in ta: e1, the trace, and everything else."""
    limit = solve(BORDER)
    times = np.array([1e-1, 1e-2, 1e-3, 1e-4, 1e-5])
    errors: dict[str, list[float]] = {}
    for time in times:
        near = solve(STICK, unknown=["e1"], given={"ta": float(time)})
        assert near.admissibility.verdict == "conditional"
        assert near.unknowns["e1"] > limit.unknowns["e1"]
        for name in limit.unknowns:
            errors.setdefault(name, []).append(abs(near.values[name] - limit.unknowns[name]))
        errors.setdefault("trace", []).append(abs(near.trace - limit.trace))
        errors.setdefault("period", []).append(abs(near.period - limit.period))
    for name, found in errors.items():
        assert found[-1] < 1e-4
        slope = np.polyfit(np.log(times[1:]), np.log(found[1:]), 1)[0]
        assert slope == pytest.approx(1, abs=0.02), name


def test_beyond_the_border_there_is_no_such_orbit() -> None:
    limit = solve(BORDER).unknowns["e1"]
    assert solve(STICK, {"e1": limit + 1e-3}).values["ta"] == pytest.approx(2e-3, abs=2e-3)
    guess = {n: x for n, x in solve(BORDER).unknowns.items() if n != "e1"} | {"ta": 1e-3}
    lost = solve(STICK, {"e1": limit - 1e-3}, guess, throw=False)
    assert not lost.converged
    assert "dwell time is not positive" in lost.message


def test_coulombs_law_gives_the_border_orbit() -> None:
    """With hardly more static friction the first mass holds until the second one is caught."""
    orbit = solve(BORDER)
    required = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
    friction = Friction(orbit.values, required["us1"] + 0.3, required["us2"] + 0.3)
    friction.sticking[0] += 1e-10
    start = np.append(orbit.states[0], 1.0)
    start[:2] += friction.centre()
    times: list[float] = []
    state, slips = start, np.array([True, False])
    for expected in ([True, True], [False, True], [False, False]):
        state, slips = friction.advance(state, slips, times)
        assert slips.tolist() == expected
    assert_allclose(state, start, atol=1e-9)
    assert_allclose(times, orbit.dwell_times.tolist()[1:], atol=1e-9)
    assert friction.forces(state)[0] == pytest.approx(friction.sticking[0], abs=1e-9)


def test_the_excess_is_solved_for_and_may_be_exchanged() -> None:
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


def test_scaling_velocity_and_forces_together_changes_no_trace() -> None:
    """The equations are homogeneous of degree one in V, e1, e2 and the positions."""
    for name in (SYMMETRIC, STICK, BORDER):
        plain = solve(name)
        for factor in (1e-3, 0.5, 40.0):
            scaled = {
                n: plain.values[n] * (factor if n in ("V", "e1", "e2") else 1)
                for n in plain.kernels.parameter_names
            }
            guess = {
                n: x * (1 if n in plain.kernels.dwell_times else factor)
                for n, x in plain.unknowns.items()
            }
            other = solve(name, scaled, guess)
            assert other.trace == pytest.approx(plain.trace, rel=1e-8)
            for unknown, value in guess.items():
                assert other.unknowns[unknown] == pytest.approx(value, rel=1e-8)
            assert other.admissibility.verdict == plain.admissibility.verdict


@pytest.mark.parametrize("side", [1, -1])
def test_a_dwell_time_within_its_error_is_none(side: int) -> None:
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
