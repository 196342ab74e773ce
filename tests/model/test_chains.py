"""Modes that nearly meet: no digits cancel, however near they are, in flows, motions, orbits."""

import math

import mpmath
import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive import Harmonic, Parameter, RigidStop
from nonsmooth.derive import oscillator as declared
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.structure import mode_shapes
from nonsmooth.runtime.model.time_functions import (
    derivative_matrix,
    function_bounds,
    functions_at,
)
from tests.model.test_modes import exact, oscillator, soft, summed

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

TIMES = (0.01, 1.0, 1000.0)
SMALL = (*10.0 ** -np.arange(16, -0.1, -2), *10.0 ** np.random.default_rng(3).uniform(-16, 0, 3))


def missed(field: np.ndarray, t: float) -> float:
    wanted = exact(field, t)
    walls = np.hstack([np.eye(len(field)), -np.ones((len(field), 1))])  # each state is 1
    found = summed(numeric_modes(field, walls), t)
    return float(np.abs(found - wanted).max() / np.abs(wanted).max())


@pytest.mark.parametrize("damped", [False, True])
@pytest.mark.parametrize("small", SMALL)
def test_a_load_beside_a_small_stiffness(small: float, damped: bool) -> None:
    damping = math.sqrt(small) / 3 if damped else 0.0
    free = oscillator(1, damping, small, 1.0)
    for t in TIMES:
        assert missed(soft(small, damping, 1.0), t) < 1e-12
        assert missed(free, t) < 1e-12


@pytest.mark.parametrize("damped", [False, True])
@pytest.mark.parametrize("small", SMALL)
def test_forcing_near_resonance(small: float, damped: bool) -> None:
    for stiffness, load in ((1.0, 0.7), (0.3, 0.0)):
        damping = small * 0.3 if damped else 0.0
        frequency = math.sqrt(stiffness) * (1 + small)
        for t in TIMES:
            response = 5 / stiffness  # the forcing's, at rest: in units of it three digits are lost
            assert missed(soft(stiffness, damping, load, frequency), t) < 1e-12 * response


@pytest.mark.slow
def test_two_masses_with_small_and_nearly_equal_stiffness() -> None:
    random = np.random.default_rng(8)
    for _ in range(6):
        one, two, near = 10.0 ** random.uniform(-9, 0, 3)
        for stiffness in (np.diag([one, two]), np.diag([1.0, 1 + near]), np.diag([0, one])):
            field = oscillator(np.eye(2), 0 * stiffness, stiffness, random.normal(size=2))
            for t in TIMES[1:]:
                assert missed(field, t) < 1e-12


def chain_cases() -> list:
    """Chains of every kind: exponents from 1e-7 to 1 from each other."""
    random = np.random.default_rng(2)
    kinds = [
        [(1, False, False, False), (1, True, True, True)],
        [(2, False, False, False), (1, True, True, True)],
        [(1, False, False, False), (1, False, True, False), (1, True, True, True)],
        [(1, True, False, True), (1, True, True, True)],
        [(1, True, False, False), (1, True, True, False), (1, True, True, False)],
        [(1, False, False, False), (1, True, True, True), (1, True, True, True)],
        [(1, False, False, False), (1, True, False, True)],
    ]
    cases = []
    for kind in kinds:
        for distance in (1e-7, 1.0):
            numbers = distance * random.uniform(-1, 1, (len(kind), 2))
            exponents = np.array(
                [[-abs(a), 0.7 * distance + abs(b) if shape[1] else 0]
                 for shape, (a, b) in zip(kind, numbers, strict=True)]
            )  # fmt: skip
            if kind[0][1] and not kind[0][3]:
                exponents[:, 1] += 1
            cases.append((mode_shapes(kind), exponents))
    return cases


@pytest.mark.parametrize("place", range(14))
def test_the_functions_of_a_chain(place: int) -> None:
    """They solve their own linear system, and keep to their bounds."""
    shapes, exponents = chain_cases()[place]
    matrix = derivative_matrix(shapes, exponents)
    starts = [mode.places[0] for mode in shapes if not mode.joined]
    mp = mpmath.MPContext()
    mp.dps = 60
    for t in TIMES:
        start = mp.zeros(len(matrix), 1)
        for k in starts:
            start[k] = 1
        wanted = mp.expm(mp.matrix(matrix.tolist()) * mp.mpf(t)) * start
        found = np.array(functions_at(shapes, exponents, t))
        bounds = np.array(function_bounds(shapes, exponents, t, t))
        errors = np.array([float(abs(a - b)) for a, b in zip(wanted, found, strict=True)])
        assert (errors <= 1e-14 * (1 + t * np.abs(exponents).max()) * bounds).all()
        assert (np.abs(found) <= bounds * (1 + 1e-13)).all()
        earlier = np.array(function_bounds(shapes, exponents, t / 3, t))
        between = np.array([functions_at(shapes, exponents, s) for s in np.linspace(t / 3, t, 50)])
        assert (np.abs(between) <= earlier * (1 + 1e-13)).all()


k, b, c, w, s = sp.symbols("k b c w s")


def in_front_of_a_stop(forced: bool):
    return declared(
        "soft-forced" if forced else "soft",
        ["x"],
        mass=[[1]],
        stiffness=[[k]],
        damping=[[c]],
        load=[b],
        forcing=[Harmonic(w, cosine=[5])] if forced else [],
        elements=[RigidStop("x", at=s, restitution=sp.Rational(1, 2), name="wall")],
        parameters=[
            Parameter("k", "stiffness", lower=-1),
            Parameter("b", "load", lower=-sp.oo),
            Parameter("c", "damping", lower=-1),
            *([Parameter("w", "frequency")] if forced else []),
            Parameter("s", "position of the stop"),
        ],
        description="a mass on a soft spring in front of a stop",
    )


FREE, FORCED = in_front_of_a_stop(False), in_front_of_a_stop(True)


def first_impact(motion) -> tuple[float, list[float]]:
    """The same impact by Newton's method in many digits."""
    mp = mpmath.MPContext()
    mp.dps = 40
    field = motion.system.fields[motion.run.configurations[0]]
    stop = mp.mpf(float(motion.system.parameters["s"]))
    size = len(field)
    whole = mp.zeros(size + 1)
    for place in np.ndindex(size, size + 1):
        whole[place] = mp.mpf(float(field[place]))
    start = mp.matrix([*map(float, motion.states[0]), 1])
    time = mp.mpf(float(motion.times[1]))
    for _ in range(4):
        end = mp.expm(whole * time) * start
        time -= (end[0] - stop) / end[1]
    return float(time), [float(x) for x in list(end)[:size]]


@pytest.mark.usefixtures("backend")
@pytest.mark.parametrize("small", SMALL[::2])
def test_an_impact(small: float) -> None:
    x = {"x": 0, "v": 0.5}
    for system, parameters, start in (
        (FORCED, {"k": small, "b": 0, "c": 0, "w": 1.7, "s": 1}, {**x, "c1": 1, "s1": 0}),
        (FORCED, {"k": small, "b": 1, "c": 0, "w": 1.7, "s": 1}, {**x, "c1": 1, "s1": 0}),
        (FORCED, {"k": small, "b": 1, "c": small, "w": 1.7, "s": 1}, {**x, "c1": 1, "s1": 0}),
        (FORCED, {"k": 1, "b": 0, "c": 0, "w": 1 + small, "s": 9}, {**x, "c1": 1, "s1": 0}),
        (FREE, {"k": small, "b": 1, "c": 0, "s": 1}, x),
        (FREE, {"k": small, "b": 0.1, "c": math.sqrt(small), "s": 1}, x),
    ):  # fmt: skip
        motion = ns.simulate(system, parameters, start, transitions=1)
        if len(motion.times) < 2:
            continue
        time, end = first_impact(motion)
        assert motion.times[1] == pytest.approx(time, rel=1e-13)
        assert_allclose(motion.before[1], end, rtol=0, atol=1e-13 * max(map(abs, end)))


@pytest.mark.usefixtures("backend")
@pytest.mark.parametrize("small", [1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-2])
def test_a_long_motion(small: float) -> None:
    """Up to 1000 without an impact: the search gets on, and the end is that of the flow."""
    start = {"x": 0, "v": 0.5, "c1": 1, "s1": 0}
    for stiffness, frequency in ((small, 1.7), (1.0, 1 + small)):
        parameters = {"k": stiffness, "b": 1, "c": 0, "w": frequency, "s": 1e9}
        motion = ns.simulate(FORCED, parameters, start, until=1000.0)
        wanted = exact(motion.system.fields[0], 1000.0) @ [*motion.states[0], 1]
        assert_allclose(motion(1000.0), wanted, rtol=0, atol=1e-12 * max(1, np.abs(wanted).max()))


@pytest.mark.usefixtures("backend")
@pytest.mark.parametrize("small", [1e-6, 1e-5, 1e-4])
def test_a_composed_orbit(small: float) -> None:
    """The response of a soft spring about its equilibrium, whose closing is worth 1/k digits."""
    parameters = {"k": small, "b": 1, "c": 0, "w": 1.7, "s": 1e9}
    wanted = np.array([1 / small + 5 / (small - 1.7**2), 0, 1, 0])
    period = 2 * math.pi / 1.7
    phases = [("free", "forcing-phase")]
    found = ns.solve(FORCED, parameters, [period, *wanted], itinerary=phases)
    assert found.dwell_times[0] == pytest.approx(period, rel=1e-14)
    assert_allclose(found.states[0], wanted, rtol=0, atol=1e-13 / small**2)
