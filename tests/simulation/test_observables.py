"""Observables and Lyapunov exponents of simulated motions, by laws and by other routes."""

import math
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from numpy.polynomial import Polynomial
from numpy.testing import assert_allclose
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from nonsmooth import InputError, lyapunov, observe, simulate
from nonsmooth.derive import Configuration, FirstOrder, System
from tests.two_masses import CHAIN, RUBBING, STICKING

ELASTIC, RIGID = CHAIN | {"k3": 3}, CHAIN | {"r": 1}


@cache
def friction(name="B"):
    data = STICKING if name == "A" else RUBBING
    return simulate("dry-friction", data, [0.3, -0.2, 0.1, 0.4], until=200)


@cache
def motion(name):
    if name == "elastic-stop":
        return simulate("elastic-stop", ELASTIC, [0, 0.4, 2, -1], until=120)
    if name == "rigid-stop":
        return simulate("rigid-stop", {**RIGID, "r": "0.1"}, [0.5, 3.0, 0, 0], until=60)
    return friction(name)


NAMES = ["A", "B", "elastic-stop", "rigid-stop"]


def stop_energy(states, stop=0.0):
    x1, x2, v1, v2 = states.T
    chain = v1**2 / 2 + v2**2 + (x1 - x2) ** 2 / 2 + 5 * x2**2 / 2
    return chain + stop * np.maximum(x1 - 1, 0) ** 2 / 2


def integral(found, function):
    """Of a function of time, phase by phase, by adaptive quadrature."""
    trajectory = found.trajectory
    inner = trajectory.times[trajectory.times > found.since]
    breaks = [found.since, *inner.tolist(), trajectory.end]
    total = 0.0
    for begin, end in pairwise(breaks):
        if end > begin:
            inside = math.nextafter(end, begin)
            total += quad(function, begin, inside, epsabs=1e-12, epsrel=1e-12, limit=400)[0]
    return total


# --- extremes


@pytest.mark.parametrize("since", [0.0, 17.3])
@pytest.mark.parametrize("name", NAMES)
def test_extremes_are_those_of_dense_samples_polished(name, since):
    trajectory = motion(name)
    found = observe(trajectory, since)
    times = np.linspace(since, trajectory.end, 200_001)
    states = trajectory(times)
    width = times[1] - times[0]
    for index, state in enumerate(trajectory.names):
        for extreme, sign in ((found.minima[state], -1), (found.maxima[state], 1)):
            best = sign * states[:, index]
            middle = times[np.argmax(best)]
            bounds = (max(since, middle - width), min(trajectory.end, middle + width))
            polished = minimize_scalar(
                lambda t, i=index, s=sign: -s * trajectory(t)[i],
                bounds=bounds,
                method="bounded",
                options={"xatol": 1e-12},
            )
            value = sign * extreme.value
            assert value >= best.max() - 1e-13
            assert value >= -polished.fun - 1e-13
            assert value <= max(best.max(), -polished.fun) + 5e-2 * width
            assert since <= extreme.time <= trajectory.end
            near = np.array([max(since, extreme.time - 1e-10), extreme.time])
            assert np.abs(trajectory(near)[:, index] - extreme.value).min() < 1e-8


def test_extremes_of_polynomials_are_those_at_the_zeros_of_their_rates():
    """Phases without an oscillation: one panel each, with any number of peaks inside."""
    states = sp.symbols("a:f", real=True)
    moving = Configuration("moving", FirstOrder(np.eye(6, k=1, dtype=int).tolist(), [0] * 6), ())
    system = System("powers", "each is the rate of the one before", states, (), (moving,), ())
    rng = np.random.default_rng(3)
    for _ in range(40):
        since, end = np.sort(rng.uniform(0, 4, 2))
        first = Polynomial.fromroots(rng.uniform(0, 4, 4)).integ()
        rates = [first.deriv(k) for k in range(6)]
        found = observe(simulate(system, {}, [rate(0.0) for rate in rates], until=end), since)
        for state, rate in zip("abcdef", rates, strict=True):
            places = rate.deriv().roots().real
            inside = places[(since < places) & (places < end)]
            values = rate(np.array([since, end, *inside]))
            extremes = found.minima[state].value, found.maxima[state].value
            assert_allclose(extremes, (values.min(), values.max()), rtol=1e-11, atol=1e-11)


def test_a_boundary_is_the_extreme_of_what_it_bounds():
    found = observe(motion("rigid-stop"))
    assert_allclose(found.maxima["x1"].value, 1, rtol=0, atol=1e-15)
    held = observe(friction("A"), since=100)
    for mass, static in (("first", 4.0195), ("second", 1.4831)):
        assert_allclose(held.contacts[f"{mass}-friction"].maximum.value, static, rtol=1e-13)
        assert held.contacts[f"{mass}-friction"].peak == pytest.approx(static)
    for velocity in ("v1", "v2"):
        assert_allclose(held.maxima[velocity].value, 1, rtol=0, atol=1e-14)


# --- averages


@pytest.mark.slow
@pytest.mark.parametrize(("name", "last"), [*zip(NAMES, (28.3, 28.3, 28.3, 60), strict=True)])
def test_averages_are_those_of_adaptive_quadrature(name, last):
    trajectory = motion(name)
    found = observe(trajectory, trajectory.end - last)
    for index, state in enumerate(trajectory.names):
        mean = integral(found, lambda t, i=index: trajectory(t)[i]) / found.duration
        square = integral(found, lambda t, i=index: trajectory(t)[i] ** 2) / found.duration
        assert_allclose(found.means[state], mean, rtol=1e-11, atol=1e-11)
        assert_allclose(found.rms[state], math.sqrt(square), rtol=1e-11)


@pytest.mark.parametrize("name", NAMES)
def test_fractions_of_time(name):
    trajectory = motion(name)
    found = observe(trajectory, 12.5)
    assert math.fsum(found.fractions.values()) == pytest.approx(1, abs=1e-14)
    times = 12.5 + (np.arange(100_000) + 0.5) * (found.duration / 100_000)
    names = trajectory.configuration(times)
    for configuration, part in found.fractions.items():
        assert part == pytest.approx((names == configuration).mean(), abs=2e-3)
    if name in "AB":
        stuck = [n.startswith("stick") for n in names], [n.endswith("stick") for n in names]
        assert list(found.sticking) == ["x1", "x2"]
        assert_allclose(list(found.sticking.values()), np.mean(stuck, axis=1), atol=2e-3)
    else:
        held = {"rigid-stop": {"x1": found.fractions["contact"]}, "elastic-stop": {}}
        assert found.sticking == held[name]


# --- contacts


@pytest.mark.parametrize("name", NAMES)
def test_works_are_integrals_of_the_histories(name):
    trajectory = motion(name)
    found = observe(trajectory, trajectory.end - 31.7)
    for index, (label, contact) in enumerate(found.contacts.items()):
        dissipated = -integral(found, lambda t, c=label: float(found.power(c, t)))
        work = integral(
            found, lambda t, c=label, i=index: float(found.force(c, t)) * trajectory(t)[2 + i]
        )
        mean = integral(found, lambda t, c=label: float(found.force(c, t))) / found.duration
        assert_allclose(contact.dissipated, dissipated, rtol=1e-10, atol=1e-11)
        assert_allclose(contact.work, work, rtol=1e-10, atol=1e-11)
        assert_allclose(contact.mean, mean, rtol=1e-10, atol=1e-11)


def test_friction_forces_by_their_law():
    trajectory = friction("A")
    found = observe(trajectory)
    times = np.linspace(0, trajectory.end, 3000).reshape(-1, 3)
    forces = found.force("first-friction", times)
    assert forces.shape == times.shape
    states = trajectory(times)
    stuck = np.char.startswith(trajectory.configuration(times), "stick")
    balanced = states[..., 0] - 0.5 * states[..., 1]
    assert_allclose(forces, np.where(stuck, balanced, 1.0), rtol=0, atol=1e-13)
    assert_allclose(
        found.power("first-friction", times), forces * (states[..., 2] - 1), rtol=0, atol=1e-12
    )
    assert_allclose(found.power("first-friction", times)[stuck], 0, atol=1e-12)


def test_the_elastic_stop_conserves_and_pushes_back():
    trajectory = motion("elastic-stop")
    found = observe(trajectory)
    energies = stop_energy(trajectory(np.linspace(0, trajectory.end, 5001)), stop=3.0)
    assert np.ptp(energies) <= 1e-13 * energies[0]
    stop = found.contacts["stop"]
    assert_allclose(stop.maximum.value, 0, atol=1e-13)
    assert_allclose(stop.minimum.value, 3 * (1 - found.maxima["x1"].value), rtol=1e-13)
    assert stop.minimum.time == pytest.approx(found.maxima["x1"].time, abs=1e-6)
    assert_allclose(stop.dissipated, -stop.work, rtol=1e-14)


def test_the_stop_holds_a_resting_mass():
    """After the impacts have accumulated the stop carries the spring's force."""
    trajectory = simulate("rigid-stop", {**RIGID, "r": 0}, [0.9, 3.0, 0, 0], until=1)
    found = observe(trajectory)
    assert trajectory.configurations == ("free", "free", "contact", "free")
    middle = float(trajectory.times[2:4].mean())
    x1, x2, _, _ = trajectory(middle)
    assert x1 == 1
    assert found.force("stop", middle) == pytest.approx(-(x2 - x1))
    assert found.force("stop", [0.0])[0] == 0
    assert found.contacts["stop"].work == 0
    assert 0 < found.sticking["x1"] == found.fractions["contact"] < 1


@pytest.mark.parametrize("since", [-1, 200.0, 1e9, math.nan])
def test_a_wrong_beginning(since):
    for function in (observe, lyapunov):
        with pytest.raises(InputError, match="since "):
            function(friction(), since)


def test_a_motion_that_never_reaches_a_boundary_is_followed_until_a_time():
    data = CHAIN | {"k3": 1}
    with pytest.raises(InputError, match="no boundary is reached any more: follow it until a time"):
        observe(simulate("elastic-stop", data, [0.1, 0, 0, 0], transitions=10))
    found = observe(simulate("elastic-stop", data, [0.1, 0, 0, 0], until=50))
    assert found.fractions["free"] == 1


def test_unknown_contacts_and_times():
    found = observe(friction())
    with pytest.raises(InputError, match=r"unknown contact 'first'; .*first-friction"):
        found.force("first", 1)
    with pytest.raises(InputError, match="a time is not between 0 and the end"):
        found.power("first-friction", 201)
