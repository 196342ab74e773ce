"""What an orbit leaves open is completed alike by all commands."""

import math
from fractions import Fraction

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.continuation.next_orbits import composed_family

STICK, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"
SYSTEM = ("chi", "eta", "V", "us1", "ur1", "us2", "ur2")


def beyond(bound):
    """1, or a tenth more than a bound that is near it or larger, in tenths."""
    return 1 if bound < 0.9 else Fraction(math.ceil(11 * bound), 10)


def test_solve_chart_continue_and_certify_agree():
    random = np.random.default_rng(34)
    for k in range(6):
        values = {
            n: float(x) for n, x in zip(("eta", "V"), random.uniform(0.9, 1.1, 2), strict=True)
        }
        given = ({}, {"us1": 2}, {"ur2": "1.5"})[k % 3]
        orbit = ns.solve(STICK, {**values, **given})
        whole = ns.certify(orbit)
        branch = ns.continue_orbit(orbit, "V", (values["V"] - 0.01, values["V"] + 0.01), step=0.5)
        place = int(np.argmin(abs(branch.parameter_values - values["V"])))
        composed, _ = composed_family(branch, place)
        many = ns.solve(STICK, {**values, "V": [values["V"]]})
        bounds = {n: b.item() for n, b in (many.bounds or {}).items()}
        assert whole.chosen
        for name in whole.chosen:
            assert composed.parameters[name] == whole.parameters[name]
            if name in bounds:
                assert whole.parameters[name].exact == beyond(bounds[name])
        told = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
        for name in set(told) & set(bounds):
            assert told[name] == pytest.approx(bounds[name], abs=1e-9)
        for name in SYSTEM:
            if name != "V":  # the branch's own point
                assert composed.parameters[name].exact == whole.parameters[name].exact
        assert whole.claims["admissibility"] == "proved"


def test_what_plays_no_part_is_kept_where_it_is_given():
    orbit = ns.solve(SYMMETRIC, {"us1": "0.0127", "ur1": "0.0255"})
    point = orbit.problem.physical(orbit)
    assert point.chosen == ("us2",)
    assert (point.values["us1"].text, point.values["ur1"].text) == ("0.0127", "0.0255")
    assert ns.certify(orbit).parameters == point.values


def test_a_batch_takes_physical_parameters_as_a_point_does():
    us1, ur1, us2 = np.array([0.5, 1.0, 2.0, -1.0]), np.array([3.6, 4.0, 5.2, 2.0]), [[0.6], [0.8]]
    many = ns.solve(STICK, {"us1": us1, "ur1": ur1, "us2": us2})
    assert many.status.shape == (2, 4)
    for i, j in np.ndindex(2, 3):
        one = ns.solve(STICK, {"us1": us1[j], "ur1": ur1[j], "us2": us2[i][0]}, throw=False)
        assert one.converged == bool(many.converged[i, j])
        assert one.trace == pytest.approx(float(many.trace[i, j]), abs=1e-9)
        assert bool(many.admissible[i, j]) == (one.admissibility.verdict is True)
    assert not many.converged[:, 3].any()  # us1 is outside its domain
