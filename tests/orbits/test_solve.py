"""One orbit at one point: exchanges, searches and failures."""

from contextlib import suppress
from itertools import combinations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import InputError, NoConvergence, solve
from nonsmooth.runtime.model.kernels import backend
from tests.declared import Declared

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
UNKNOWNS = ("z10", "z20", "ta", "tau", "tau1", "tau2")
DWELL_TIMES = UNKNOWNS[2:]
PRINTED = {"z10": 1.1838, "z20": -2.6715, "ta": 1.0, "tau": 2.0, "tau1": 1.568, "tau2": 3.28}
WIDE = [0.15, 0.3, 0.3, 1.5, 0.1], [0.85, 3, 1.5, 5, 1.5]


def named(point):
    return dict(zip(PARAMETERS, map(float, point), strict=True))


@pytest.fixture(scope="module")
def reference():
    return solve(ORBIT)


def test_the_orbit_does_not_depend_on_the_guess(reference):
    generator = np.random.default_rng(2)
    expected = np.array([reference.unknowns[name] for name in UNKNOWNS])
    for factors in generator.uniform(0.9, 1.1, (30, 6)):
        guess = expected * factors
        by_order = solve(ORBIT, guess=guess)
        by_name = solve(ORBIT, guess=dict(zip(UNKNOWNS, map(float, guess), strict=True)))
        assert by_order.unknowns == by_name.unknowns
        assert_allclose([by_order.unknowns[n] for n in UNKNOWNS], expected, atol=1e-12)


# --- the paper's numbers (misprint 5)


def test_the_orbit_of_the_printed_dwell_times():
    orbit = solve(ORBIT, unknown=("e1", "e2"), given={"ta": 1, "tau": 2})
    assert set(orbit.given) == {"chi", "eta", "V", "ta", "tau"}
    assert (orbit.values["ta"], orbit.values["tau"]) == (1.0, 2.0)
    assert Declared(orbit).missed < 1e-13
    assert 1e-3 < abs(orbit.unknowns["e1"] / 3.0195 - 1) < 1e-2
    assert 1e-3 < abs(orbit.unknowns["e2"] / 0.4831 - 1) < 1e-2
    assert orbit.unknowns["tau2"] == pytest.approx(3.28, abs=1e-3)


# --- exchange of parameters and unknowns

EXCHANGES = [
    (swapped, fixed)
    for size in (1, 2)
    for swapped in combinations(PARAMETERS, size)
    for fixed in combinations(UNKNOWNS, size)
]
# F(z, times, V, e) is homogeneous of degree one in z, V, e1, e2: given the times alone, no
# more than their ratios follow.
SINGULAR = [(("V", "e1", "e2"), fixed) for fixed in combinations(DWELL_TIMES, 3)] + [
    ((p, "V", "e1", "e2"), DWELL_TIMES) for p in ("chi", "eta")
]
LARGER = [
    (swapped, fixed)
    for swapped in combinations(PARAMETERS, 3)
    for fixed in combinations(UNKNOWNS, 3)
]


def exchanged(orbit, swapped, fixed, factor=1.0):
    given = {name: orbit.unknowns[name] * factor for name in fixed}
    return solve(ORBIT, unknown=swapped, given=given)


@pytest.mark.parametrize("factor", [1.0, 1 + 1e-4])
def test_every_exchange_is_solved_but_where_the_equations_are_singular(reference, factor):
    refused, asked = {}, (EXCHANGES + LARGER + SINGULAR[4:])[:: 1 if factor == 1 else 3]
    for swapped, fixed in asked:
        try:
            orbit = exchanged(reference, swapped, fixed, factor)
        except InputError as error:
            refused[swapped, fixed] = str(error)
            continue
        except NoConvergence:
            # a badly conditioned choice may have no orbit that near
            assert factor != 1
            assert (swapped, fixed) not in EXCHANGES
            continue
        assert set(orbit.unknowns) == {*UNKNOWNS, *swapped} - {*fixed}
        assert set(orbit.given) == {*PARAMETERS, *fixed} - {*swapped}
        if (swapped, fixed) in EXCHANGES:
            assert Declared(orbit).missed < 1e-12
            data = {name: orbit.values[name] for name in PARAMETERS}
            ordinary = solve(ORBIT, data, guess=[orbit.values[name] for name in UNKNOWNS])
            found = [ordinary.values[n] for n in UNKNOWNS]
            assert_allclose(found, [orbit.values[n] for n in UNKNOWNS], atol=1e-9)
    assert set(refused) == {*SINGULAR} & {*asked} != set()
    for text in refused.values():
        assert "do not determine" in text
        assert float(text.partition("condition number ")[2]) > 1e12


@pytest.mark.parametrize("factor", [2, 100])
def test_an_exchange_far_off_is_solved_or_refused(reference, factor):
    """Some end beside numbers that no system has, at which nothing is finite."""
    for swapped, fixed in EXCHANGES[:12]:
        with suppress(InputError, NoConvergence):
            exchanged(reference, swapped, fixed, factor)


def test_the_guess_serves_an_exchange_too(reference):
    orbit = solve(
        ORBIT,
        {"eta": 1.1},
        guess=[reference.unknowns[name] for name in UNKNOWNS],
        unknown=["V"],
        given={"tau1": "157/100"},
    )
    assert orbit.values["tau1"] == 1.57
    assert Declared(orbit).missed < 1e-12


def test_far_given_values_are_approached_in_steps(reference):
    for time in (0.05, 3.0, 10.0):
        orbit = solve(ORBIT, unknown=("e1",), given={"ta": time})
        assert orbit.values["ta"] == time
        assert Declared(orbit).missed < 1e-11


def test_a_parameter_found_outside_its_domain_is_no_orbit():
    # the only solutions there have e2 < 0
    for swapped, given in ((("e2",), {"tau": 1}), (("e1", "e2"), {"ta": 0.3, "tau": 0.5})):
        orbit = solve(ORBIT, unknown=swapped, given=given, throw=False)
        assert orbit.unknowns["e2"] < 0
        assert not orbit.converged
        assert "outside its domain" in orbit.message
        with pytest.raises(NoConvergence, match="outside its domain"):
            solve(ORBIT, unknown=swapped, given=given)


def test_a_parameter_is_said_to_be_outside_its_domain_only_by_a_solution():
    """On the way of Newton's method, which may end nowhere, it says nothing."""
    for start in np.linspace(1, 1.5, 26):
        guess = [start] * 6
        orbit = solve("dry-friction/solution-ii", {"eta": "1.02"}, guess, throw=False)
        assert orbit.residual < 1e-9 or "outside its domain" not in orbit.message


def test_a_given_dwell_time_that_is_not_positive_is_no_orbit():
    for time in (0, -1):
        orbit = solve(ORBIT, unknown=("e1",), given={"ta": time}, throw=False)
        assert not orbit.converged
        assert "dwell time is not positive" in orbit.message


def is_motion(orbit):
    return orbit.converged and orbit.admissibility.verdict is not False


@pytest.mark.slow
def test_an_admissible_orbit_is_found_where_the_first_attempt_leads_elsewhere():
    points = np.random.default_rng(6).uniform(*WIDE, (1000, 5))
    many = solve(ORBIT, dict(zip(PARAMETERS, points.T, strict=True)))
    possible = [named(point) for point in points[many.admissible]]
    hard = [p for p in possible if not is_motion(solve(ORBIT, p, PRINTED, throw=False))][:40]
    assert len(hard) > 20
    found = [is_motion(solve(ORBIT, point, throw=False)) for point in hard]
    assert sum(found) >= 0.9 * len(found)


# --- failures


def test_a_failure_says_what_was_tried():
    with pytest.raises(NoConvergence) as searched:
        solve(ORBIT, {"e2": 1e4})
    for trial in ("reference point's guess", "continuation in", "starts"):
        assert trial in str(searched.value)
    with pytest.raises(NoConvergence) as guessed:
        solve(ORBIT, {"e2": 1e4}, guess=[1, 1, 1, 1, 1, 1])
    assert "the guess" in str(guessed.value)
    assert "starts" not in str(guessed.value)
    assert ORBIT in str(guessed.value)


def test_without_throw_the_status_says_it():
    for parameters, guess in (({"e2": 1e4}, None), ({"e2": 1e4}, [1] * 6), ({}, [0] * 6)):
        orbit = solve(ORBIT, parameters, guess, throw=False)
        assert not orbit.converged
        assert orbit.digits == 0
        assert orbit.status > 0
        assert orbit.message == solve(ORBIT, {"V": [1.0]}).message(orbit.status)


def test_each_status_suggests_a_remedy():
    found = solve(ORBIT, {"V": [1.0]})
    assert found.message(0) == "converged"
    for status in range(1, 7):
        text = found.message(status)
        assert "\n" not in text
        assert any(word in text for word in ("give", "change", "domain"))
    with pytest.raises(InputError, match="7 is no status"):
        found.message(7)


def test_extreme_parameters_end_in_a_status_not_in_an_exception():
    extremes = (1e300, 1e16, 1e8, 1e-8, 1e-300, 5e-324, 0.999999999)
    for name in PARAMETERS:
        for value in extremes if backend() == "c" else extremes[1:2]:
            if name != "chi" or value < 1:
                orbit = solve(ORBIT, {name: value}, throw=False)
                assert orbit.message
                if orbit.converged:
                    assert orbit.stability.verdict in ("stable", "unstable", "undecided")
