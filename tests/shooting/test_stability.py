"""Stability against the simulated Poincare map, which knows Coulomb's law and no itinerary."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import poincare_map, refine, simulate, solve
from tests.declared import single

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
LOWER, UPPER = np.array([0.15, 0.3, 0.3, 1.5, 0.1]), np.array([0.85, 3.0, 1.5, 5.0, 1.5])


def simulated(orbit, margin=0.3):
    """Data whose forces of friction allow the orbit, and where it starts.

    Simulation goes by Coulomb's law alone, in physical coordinates.
    """
    bounds = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
    data = {name: orbit.values[name] for name in ("chi", "eta", "V")}
    data |= {name: bounds[name] + margin for name in ("us1", "us2")}
    data |= {f"ur{k}": data[f"us{k}"] + orbit.values[f"e{k}"] for k in (1, 2)}
    # the paper's shift d = x - z
    first = (data["us1"] + data["us2"]) / (1 - data["chi"])
    centre = np.array([first, first + data["us2"] / data["chi"], 0, 0])
    start = [orbit.values["z10"], orbit.values["z20"], data["V"], data["V"]]
    return data, start + centre


def simulated_map(orbit):
    """From where both masses begin to stick to where they next do, and where the orbit starts."""
    data, start = simulated(orbit)
    section = ("stick-slip", "second-reaches-belt", "stick-stick")
    return poincare_map("dry-friction", data, section), start


@cache
def at_random_points():
    """Orbits at random points."""
    points = LOWER + (UPPER - LOWER) * np.random.default_rng(11).random((1500, 5))
    return solve(ORBIT, dict(zip(PARAMETERS, points.T, strict=True)))


def orbits_where(select, count):
    """Admissible orbits of random points whose trace is selected."""
    many = at_random_points()
    chosen = np.flatnonzero(many.admissible & (many.trace != 0) & select(many))[:count]
    assert len(chosen) == count
    return [single(many, i) for i in chosen]


@pytest.fixture(scope="module")
def orbits():
    return [solve(ORBIT), *orbits_where(lambda many: np.abs(many.trace) > 0, 5)]


@pytest.fixture(scope="module")
def unstable():
    return orbits_where(lambda many: np.abs(many.trace) > 1.03, 3)


def test_the_simulated_motion_is_the_orbit(orbits, unstable):
    for orbit in (*orbits, *unstable):
        motion = simulate("dry-friction", *simulated(orbit), "stick-stick", transitions=4)
        assert_allclose(motion.states[-1], motion.states[0], atol=1e-10)
        assert motion.configurations[-1] == "stick-stick"
        assert_allclose(np.diff(motion.times), orbit.dwell_times, atol=1e-10)


def test_the_jacobian_is_that_of_the_simulated_map(orbits, unstable):
    for orbit in (*orbits, *unstable):
        mapped, start = simulated_map(orbit)
        basis = mapped.basis[:2]  # velocities are the belt's
        found = basis @ mapped.jacobian(start) @ basis.T
        jacobian = orbit.evaluate("poincare_jacobian")
        scale = np.abs(jacobian).max()
        assert_allclose(jacobian, found, atol=1e-6 * scale)
        assert np.trace(found) == pytest.approx(orbit.trace, abs=1e-6 * scale)
        assert abs(np.linalg.det(jacobian)) < 1e-11 * scale**2
        assert abs(np.linalg.det(found)) < 1e-6 * scale**2


def test_a_margin_within_its_error_is_undecided_until_there_are_digits():
    # a trace of -1 along chi, located with Newton's method at 700 digits
    chi = np.linspace(0.6, 0.7, 100)
    many = solve(ORBIT, {"chi": chi})
    margin = 1 - np.abs(many.trace)
    sound = many.admissible[:-1] & many.admissible[1:]
    place = np.flatnonzero(sound & (margin[:-1] * margin[1:] < 0))[0]
    guess = {n: float(a[place]) for n, a in many.unknowns.items()}
    text = repr(float(chi[place]))
    for _ in range(9):
        found = refine(solve(ORBIT, {"chi": text}, guess), 700)
        step = (found.trace + 1) / found.derivatives("chi").trace[0]
        text = found.arithmetic.mp.nstr(found.values["chi"] - step, 690)
    for shift, few, enough in (("1e-30", 16, 40), ("1e-462", 450, 550)):
        verdicts = []
        for sign in ("+", "-"):
            orbit = solve(ORBIT, {"chi": f"{text} {sign} {shift}"}, guess)
            assert orbit.stability.verdict == "undecided"
            assert refine(orbit, few).stability.verdict == "undecided"
            verdicts.append(refine(orbit, enough).stability.verdict)
        assert set(verdicts) == {"stable", "unstable"}


@pytest.mark.parametrize(
    "name",
    [
        "rigid-stop/one-impact",
        "elastic-stop/one-contact",
        "dry-friction/symmetric",
        "dry-friction/global-stick",
    ],
)
@pytest.mark.parametrize("digits", [None, 30])
def test_multipliers_come_by_decreasing_size(name, digits):
    """The first is as large as the spectral radius; zeros, and a 1 that is trivial, come last."""
    orbit = solve(name)
    jacobian = np.array(orbit.evaluate("poincare_jacobian"), dtype=float)
    found = (orbit if digits is None else refine(orbit, digits)).stability
    values = np.array([complex(float(m.real), float(m.imaginary)) for m in found.multipliers])
    sizes = np.abs(values)
    assert (np.diff(sizes) <= 1e-9).all()
    assert_allclose(sizes[0], np.abs(np.linalg.eigvals(jacobian)).max(), rtol=1e-7)
    assert (sizes[found.rank :] == 0).all()
    assert (sizes[: found.rank] > 0).all()
    assert [m.trivial for m in found.multipliers] == sorted(m.trivial for m in found.multipliers)
