"""Admissibility of global-stick orbits: roundings, dwell times, and forces that are left open."""

from dataclasses import replace

import numpy as np
import pytest

from nonsmooth import InputError, solve
from nonsmooth.runtime.model.kernels import backend
from tests.declared import single

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
CONFIGURATIONS = ("stick-stick", "slip-stick", "slip-slip", "stick-slip")


def test_an_open_parameter_is_above_its_bound_to_the_last_bit():
    """At the bound an orbit is not admissible, at the next number above it is."""
    fast = dict(zip(PARAMETERS, (0.63, 0.66, 3.45, 3.16, 0.82), strict=True))
    many = solve(ORBIT, {name: [value] for name, value in fast.items()})
    bounds = {name: bound.item() for name, bound in many.bounds.items()}
    assert bounds["us1"] > 0.02
    near = [np.nextafter(bounds["us1"], side) for side in (-np.inf, bounds["us1"], np.inf)]
    found = solve(ORBIT, {**fast, "us1": near, "us2": bounds["us2"] + 1})
    assert list(found.admissible) == [False, False, True]
    assert {found.limits[number] for number in found.limit[:2]} == {"us1 is too small"}


def test_an_orbit_is_never_refused_for_rounding():
    """Every phase ends on a boundary: that contact is no violation."""
    count = 3000 if backend() == "c" else 200
    generator = np.random.default_rng(23)
    points = np.stack(
        [
            generator.uniform(0.1, 0.9, count),
            np.exp(generator.uniform(-1, 5.5, count)),
            np.exp(generator.uniform(-2, 1, count)),
            generator.uniform(0.5, 5, count),
            generator.uniform(0.05, 1.5, count),
        ]
    )
    many = solve(ORBIT, dict(zip(PARAMETERS, points, strict=True)))
    refused = np.flatnonzero(many.converged & ~many.admissible)
    assert len(refused) > count // 20
    for i in refused[:: max(1, len(refused) // 100)]:
        violations = single(many, i).admissibility.violations
        assert max(v.excess for v in violations) > 1e-9


def test_a_dwell_time_that_is_not_positive_is_a_violation():
    for name, time in (("ta", -0.25), ("tau2", 0.0)):
        orbit = solve(ORBIT)
        phase = orbit.dwell_time_names.index(name)
        wrong = replace(orbit, unknowns=dict(orbit.unknowns) | {name: time})
        (violation,) = wrong.admissibility.violations
        assert wrong.admissibility.verdict is False
        assert (violation.phase, violation.configuration) == (phase, CONFIGURATIONS[phase])
        assert violation.excess == -time
        told = wrong.to_json()
        assert told["admissible"] is False
        assert "requires" not in told
        (told,) = told["violations"]
        assert set(told) == {"phase", "configuration", "boundary", "time", "excess"}
        assert float(told["excess"]) == -time


def test_an_orbit_with_a_negative_dwell_time_is_found_and_refused():
    many = solve(ORBIT, {"e1": [0.5, 1.0, 3.0195]})
    assert list(many.admissible) == [False, False, True]
    orbit = solve(ORBIT, unknown=("e1",), given={"ta": -0.1}, throw=False)
    assert orbit.admissibility.verdict is False
    assert orbit.admissibility.violations[0].boundary == "first-breaks-forward"


# --- the friction forces that e1 and e2 leave open


def required(orbit):
    return {r.parameter: r.greater_than for r in orbit.admissibility.requires}


def with_forces(orbit, given):
    parameters = {n: orbit.values[n] for n in PARAMETERS} | given
    return solve(ORBIT, parameters, dict(orbit.unknowns))


@pytest.fixture(scope="module")
def binding():
    """Orbits on fast belts, the sliding force that a bound above zero holds, the other mass's."""
    fast = np.random.default_rng(24).uniform([0.4, 0.4, 2, 0.5, 0.3], [0.7, 1, 4, 4, 3], (1000, 5))
    many, found = solve(ORBIT, dict(zip(PARAMETERS, fast.T, strict=True))), []
    for us, other in (("us1", "us2"), ("us2", "us1")):
        places = np.flatnonzero(many.bounds[us] > 1e-3)[:4]
        found += [(single(many, place), us, other) for place in places]
    assert len(found) == 8
    return found


@pytest.mark.parametrize("shift", [-1e-6, 1e-6])
def test_given_forces_decide_the_static_as_the_sliding_ones(binding, shift):
    for orbit, us, other in binding:
        bounds = required(orbit)
        sliding = {us: bounds[us] + shift, other: bounds[other] + 0.1}
        static = {f"ur{m}": sliding[f"us{m}"] + orbit.values[f"e{m}"] for m in "12"}
        physical = {n: orbit.values[n] for n in ("chi", "eta", "V")} | sliding | static
        every = solve(ORBIT, physical, dict(orbit.unknowns))
        for found in (with_forces(orbit, sliding), with_forces(orbit, static), every):
            assert found.admissibility.verdict is (shift > 0)
            assert found.admissibility.requires == ()
            violations = found.admissibility.violations
            assert bool(violations) == (shift < 0)
            mass = "first" if us == "us1" else "second"
            for violation in violations:
                assert violation.boundary == f"{mass}-breaks-backward"
            if violations:
                assert max(v.excess for v in violations) == pytest.approx(2e-6, rel=1e-3)


def test_one_given_force_leaves_the_other_open(binding):
    for orbit, us, other in binding:
        complete = required(orbit)
        for given, left in ((us, other), (other, us)):
            found = with_forces(orbit, {given: complete[given] + 0.1}).admissibility
            assert found.verdict == "conditional"
            bounds = {r.parameter: r.greater_than for r in found.requires}
            assert set(bounds) == {left, left.replace("s", "r")}
            for name, bound in bounds.items():
                assert bound == pytest.approx(complete[name], abs=1e-12)
        broken = with_forces(orbit, {us: complete[us] - 1e-3}).admissibility
        assert broken.verdict is False
        assert broken.requires == ()


@pytest.mark.parametrize("given", [{"us1": 0.0}, {"us2": -1e-6}, {"ur1": 0.1}])
def test_a_force_must_be_positive(given):
    with pytest.raises(InputError, match=r"us[12] = .* outside its domain"):
        solve(ORBIT, given)
