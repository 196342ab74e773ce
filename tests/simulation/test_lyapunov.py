"""Lyapunov exponents against the multipliers of periodic orbits."""

import math
from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth import InputError, lyapunov, simulate
from nonsmooth.derive import Friction, Harmonic, Parameter, RigidStop, oscillator
from nonsmooth.runtime.explore.finding.outcomes import stretching
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.lyapunov import lyapunov_spectrum
from tests.one_mass import one_mass
from tests.two_masses import CHAIN, RUBBING, STICKING

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

ELASTIC, RIGID = CHAIN | {"k3": 3}, CHAIN | {"r": 1}
IMPACT = "docs/gallery/impact_oscillator.py"


# --- exponents of periodic orbits


@cache
def forced(kind):
    """Damped masses under one to three harmonics, with a stop, with friction, or with both."""
    zeta, speed = Parameter("zeta", "damping"), Parameter("Omega", "frequency")
    forcing = [Harmonic(speed.symbol, cosine=[1])]
    if kind == "frequencies":
        forcing += [
            Harmonic(2 * speed.symbol, cosine=[0.4]),
            Harmonic(speed.symbol / 3, sine=[0.1]),
        ]
    elements = []
    if kind != "sticking":
        elements.append(RigidStop("x", 0, 0.7, name="stop"))
    if kind in ("sticking", "both"):
        elements.append(Friction("x", kinetic=0.35, static=0.45, name="ground"))
    return oscillator(
        f"forced-{kind}", ["x"], [[1]], [[1]], [[2 * zeta.symbol]],
        forcing=forcing, elements=elements, parameters=[zeta, speed],
    )  # fmt: skip


def comes_back(motion):
    try:
        ns.itinerary_of(motion)
    except InputError:
        return False
    return True


def law(system, motion):
    """Check exponents of a motion that settles against log|multiplier| / period; give these."""
    orbit = ns.solve(system, motion.parameters, itinerary=ns.itinerary_of(motion))
    assert orbit.converged
    moduli = np.abs(orbit.multipliers)
    wanted = np.full(len(moduli), -np.inf)
    np.log(moduli, out=wanted, where=moduli > 0)
    wanted = np.sort(wanted / float(orbit.period))[::-1]
    found = lyapunov_spectrum(motion, motion.end / 3)
    assert lyapunov(motion, motion.end / 3) == found[0]
    assert not found[0].positive
    for exponent, exact in zip(found, wanted, strict=False):
        if math.isinf(exact):
            assert exponent == (-math.inf, 0.0)
        else:
            assert exponent.error < 5e-3
            assert abs(exponent.value - exact) < exponent.error + 1e-12
            assert exponent.value == pytest.approx(exact, abs=1e-4)
    assert all(exponent == (-math.inf, 0.0) for exponent in found[len(wanted) :])
    return wanted.tolist()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["frequencies", "stop", "sticking", "both"])
def test_exponents_of_forced_orbits_are_those_of_their_multipliers(kind):
    generator = np.random.default_rng(5)
    settled = 0
    for _ in range(3):
        zeta, speed = generator.uniform([0.03, 1.8], [0.15, 2.3])
        data = {"zeta": zeta, "Omega": speed}
        begin = {"x": -0.5, "v": 0.2}
        motion = ns.simulate(forced(kind), data, begin, transitions=600)
        if not comes_back(motion):
            continue
        found = law(forced(kind), motion)
        settled += 1
        assert len(found) == 2  # neither phase nor amplitude of a forcing
        assert max(found) < -0.01
        if kind == "stop":
            # areas shrink by damping, and by r^2 at each of the impacts, one in a period
            assert sum(found) == pytest.approx(
                -2 * zeta + 2 * math.log(0.7) * speed / (2 * math.pi), abs=1e-9
            )
    assert settled >= 2


@pytest.mark.parametrize("r", ["0.8", "0.7"])
def test_the_impact_oscillator(r):
    data = {"sigma": "0.2", "w": "3.7", "r": r}
    found = law(IMPACT, ns.simulate(IMPACT, data, {"x": 0, "v": 1}, transitions=600))
    if r == "0.8":
        assert found == pytest.approx([-0.0657016] * 2, abs=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize(("system", "data", "start"), [
    ("docs/gallery/mass_on_belt.py", {"u": 1, "e": "0.3", "V": "0.5"}, {"x": 0, "v": 0}),
    ("dry-friction", RUBBING, [0.3, -0.2, 0.1, 0.4]),
])  # fmt: skip
def test_exponents_without_forcing(system, data, start):
    law(system, ns.simulate(system, data, start, transitions=1000))


def test_a_chaotic_motion_shrinks_areas_as_its_impacts_do():
    data = {"sigma": "0.1", "w": "7.57", "r": "0.62"}
    motion = ns.simulate(IMPACT, data, {"x": -0.5, "v": 1}, transitions=2000)
    found = lyapunov_spectrum(motion, motion.end / 5)
    assert found[0].positive
    assert found[0].value == pytest.approx(0.15, abs=3 * found[0].error)
    rate = (motion.times > motion.end / 5).sum() / (0.8 * motion.end)
    errors = found[0].error + found[1].error
    assert sum(e.value for e in found) == pytest.approx(2 * math.log(0.62) * rate, abs=errors)


@pytest.mark.compiled
@pytest.mark.parametrize(
    "data",
    [{"sigma": "0.1", "w": "7.57", "r": "0.62"}, {"sigma": "0.2", "w": "3.7", "r": "0.8"}],
)
def test_neighbours_part_as_perturbations_of_one_motion_grow(data):
    motion = ns.simulate(IMPACT, data, {"x": -0.5, "v": 1}, transitions=2000)
    one = lyapunov(motion, motion.end / 5)
    kernels = load_system(IMPACT)
    values = {name: float(value) for name, value in motion.system.parameters.items()}
    many = simulate(kernels, values, motion.states[-1:], transitions=200, keep=129)
    scales = np.array([[0.3, 2.0, 1.0, 1.0]])  # any: exponents have no units of states
    found = stretching(kernels, values, many, scales)
    if np.isnan(found.exponents[0]):  # a motion that repeats to the last bit has no neighbours
        assert one.value < 0
        assert len(np.unique(many.last_states[0, :-1], axis=0)) < 32
        return
    errors = 3 * (one.error + found.errors[0])
    assert found.exponents[0] == pytest.approx(one.value, abs=errors)
    assert errors < abs(one.value)


@pytest.mark.slow
@pytest.mark.parametrize("since", [0, 0.1, 0.5])
def test_regular_motions_that_keep_energy_are_not_called_chaotic(since):
    """Their perturbations grow like the time: at a rate that looks like an exponent."""
    generator = np.random.default_rng(7)
    for name, data in (("elastic-stop", ELASTIC), ("rigid-stop", RIGID)):
        for _ in range(2):
            start = generator.normal(size=4) * [0.1, 0.1, 0.2, 0.2] + [0, 0, 2, 0]
            motion = simulate(name, data, start, transitions=400)
            found = lyapunov_spectrum(motion, since * motion.end)
            assert not found[0].positive
            assert abs(found[0].value) < 0.05
            total = sum(e.value for e in found)
            assert abs(total) < 3 * sum(e.error for e in found)


def test_a_linear_motion_has_the_exponents_of_its_field():
    """Fast decay beside slow, over a time in which it underflows: it is annihilated by nothing."""
    rates = [0.01, 30.0]
    system = oscillator(
        "damped", ["x", "y"], [[1, 0], [0, 1]], [[1, 0], [0, 400]],
        [[2 * rates[0], 0], [0, 2 * rates[1]]],
        forcing=[Harmonic(0.7, cosine=[1, 1])], elements=[RigidStop("x", 50, 0.5, name="stop")],
    )  # fmt: skip
    motion = ns.simulate(system, {}, {"x": 0, "y": 0, "v": 0, "v_y": 0}, until=900)
    assert motion.transitions == 0
    found = lyapunov_spectrum(motion, 100)
    root = math.sqrt(rates[1] ** 2 - 400)
    wanted = [-0.01, -0.01, -rates[1] + root, -rates[1] - root]
    assert_allclose([e.value for e in found], wanted, rtol=1e-3)


@pytest.mark.parametrize("transitions", [3, 12, 20])
def test_nothing_is_told_of_a_short_motion(transitions):
    data = {"sigma": "0.2", "w": "3.7", "r": "0.8"}
    motion = ns.simulate(IMPACT, data, {"x": 0, "v": 1}, transitions=transitions)
    with pytest.raises(InputError, match="too short to tell its largest Lyapunov exponent"):
        lyapunov(motion)


def test_nothing_is_told_of_a_motion_at_rest():
    system = one_mass("resting", RigidStop("x", 0, 0, name="stop"), damping=1, load=[1])
    motion = ns.simulate(system, {}, {"x": -1, "v": 0}, until=500)
    with pytest.raises(InputError, match="at rest"):
        lyapunov(motion)


def meeting(system, data, time, state, until):
    """A motion that is in a state of its first configuration at a time, followed backwards."""
    (start,) = flow_states(piecewise(system, data), 0, np.array([-time]), np.array(state))
    return simulate(system, data, start, until=until)


def test_no_exponent_where_two_boundaries_are_reached_at_once():
    """Both masses reach the belt's velocity at one time."""
    trajectory = meeting("dry-friction", STICKING, 0.75, [1.0, 1.5, 1.0, 1.0], 400)
    assert set(trajectory.boundaries[1]) == {"first-reaches-belt", "second-reaches-belt"}
    with pytest.raises(InputError, match=r"are reached together at t = 0\.7"):
        lyapunov(trajectory, float(trajectory.times[1]) / 2)
    assert lyapunov(trajectory, 40).value < 0  # behind it there is one


def test_no_exponent_where_a_boundary_is_touched():
    """The first peak of a free motion is at the stop."""
    trajectory = meeting("rigid-stop", RIGID, 1.0, [1.0, 0.25, 0.0, 0.0], 40)
    (grazing,) = trajectory.grazings
    assert grazing.time < trajectory.times[1]
    with pytest.raises(InputError, match="is reached tangentially at t = "):
        lyapunov(trajectory)
    with pytest.raises(InputError, match="too short"):  # behind it nothing else is missing
        lyapunov(trajectory, grazing.time + 0.1)
