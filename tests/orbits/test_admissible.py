"""Admissibility of global-stick orbits: open forces, violations that sampling would miss."""

from dataclasses import replace

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import InputError, refine, solve
from nonsmooth.runtime.model.kernels import backend
from tests.declared import Declared, single

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
LOWER, UPPER = np.array([0.3, 0.6, 0.7, 2.3, 0.3]), np.array([0.7, 1.6, 1.3, 3.8, 0.9])
CONFIGURATIONS = ("stick-stick", "slip-stick", "slip-slip", "stick-slip")


def random_points(seed, count):
    return LOWER + (UPPER - LOWER) * np.random.default_rng(seed).random((count, 5))


@pytest.fixture(scope="module")
def admissible():
    """Admissible orbits, the first of them on a fast belt with a positive bound on us1."""
    fast = np.random.default_rng(24).uniform([0.4, 0.4, 2, 0.5, 0.3], [0.7, 1, 4, 4, 3], (1000, 5))
    points = np.concatenate([fast, random_points(22, 12)])
    many = solve(ORBIT, dict(zip(PARAMETERS, points.T, strict=True)))
    bounds = many.bounds["us1"]
    positive, ordinary = (np.flatnonzero(b) for b in (bounds > 1e-3, bounds[1000:] == 0))
    return [single(many, i) for i in [*positive[:4], *(1000 + ordinary)]]


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
def binding(admissible):
    """Orbits, the sliding force that a bound above zero holds, and the other mass's."""
    pairs = [("us1", "us2"), ("us2", "us1")]
    found = [(o, us, other) for o in admissible for us, other in pairs if required(o)[us] > 1e-3]
    assert {us for _, us, _ in found} == {"us1", "us2"}
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


def test_a_force_must_be_positive(admissible):
    for given in ({"us1": 0.0}, {"us2": -1e-6}, {"ur1": 0.1}):
        with pytest.raises(InputError, match=r"us[12] = .* outside its domain"):
            with_forces(admissible[-1], given)


def test_refined_orbits_have_the_same_verdict(admissible):
    for orbit in admissible[:3]:
        again = refine(orbit, 40).admissibility
        assert again.verdict == "conditional"
        assert_allclose(
            [r.greater_than for r in again.requires],
            [r.greater_than for r in orbit.admissibility.requires],
            atol=1e-10,
        )


# --- a violation that sampling misses

GRAZING = {"chi": "0.35", "V": "0.24", "e1": "4.2", "e2": "0.08"}
KEY = (2, "second-reaches-belt")


def grazing_orbit():
    """An orbit just beyond the eta at which mass 2 grazes the belt's velocity in phase 2.

    Scanned with `solve`, bisected on admissibility; then so far beyond that the
    violation lasts somewhat less than 1e-6.
    """
    grid = np.linspace(124, 127, 61)
    many = solve(ORBIT, {"eta": grid, **GRAZING})
    near = np.abs(np.diff(many.unknowns["tau1"])) < 0.1
    change = (many.admissible[:-1] != many.admissible[1:]) & near
    place = int(np.flatnonzero(change)[0])
    ends = [place, place + 1] if many.admissible[place] else [place + 1, place]
    good, bad = (float(grid[i]) for i in ends)
    guess = {n: float(a[ends[0]]) for n, a in many.unknowns.items()}

    def at(eta):
        return solve(ORBIT, GRAZING | {"eta": eta}, guess)

    for _ in range(60):
        middle = 0.5 * (good + bad)
        if at(middle).admissibility.verdict is False:
            bad = middle
        else:
            good = middle
    step = np.sign(bad - good) * 1e-13 * bad
    while (orbit := at(bad + step)).admissibility.verdict is not False or (
        orbit.admissibility.violations[0].excess < 4e-12
    ):
        step *= 1.3
    return at(good), orbit


@pytest.fixture(scope="module")
def grazing():
    return grazing_orbit()


def test_the_violation_is_real_and_shorter_than_1e_6(grazing):
    """By mpmath's matrix exponentials, at times around the violation."""
    orbit = refine(grazing[1], 40)
    (violation,) = orbit.admissibility.violations
    time = violation.time - float(orbit.values["ta"] + orbit.values["tau"])
    assert 0.1 < time < float(orbit.values["tau1"]) - 0.1
    offsets = np.linspace(-1e-6, 1e-6, 41)
    piece, start, _ = Declared(orbit, precise=True).steps[KEY[0]]
    row = piece.boundaries[KEY[1]]
    excess = [(row @ (piece.flow(mpmath.mpf(time) + t) @ start))[0] for t in offsets]
    assert max(excess) > 0
    lasting = offsets[[i for i, e in enumerate(excess) if e > 0]]
    assert lasting.max() - lasting.min() < 9e-7
    assert excess[0] < 0 > excess[-1]


def test_the_guaranteed_search_and_the_batch_find_it_and_name_it(grazing):
    before, (violation,) = grazing[0].admissibility, grazing[1].admissibility.violations
    assert before.verdict == "conditional"
    assert (violation.phase, violation.boundary) == KEY
    assert 0 < violation.excess < 2e-11
    many = solve(ORBIT, {n: [o.values[n] for o in grazing] for n in PARAMETERS})
    assert_allclose(many.unknowns["tau1"], [o.unknowns["tau1"] for o in grazing], rtol=1e-9)
    # the last digits of a solution decide on the side without a violation
    assert not many.admissible[1]
    assert many.limits[many.limit[1]] == f"phase {KEY[0] + 1} {CONFIGURATIONS[KEY[0]]}: {KEY[1]}"
