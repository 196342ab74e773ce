"""Modes that nearly meet: no digits cancel, however near they are, in motions and orbits."""

import math

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive import Parameter, RigidStop
from tests.declared_motion import DeclaredMotion
from tests.model.test_modes import SMALL
from tests.one_mass import one_mass

pytestmark = [
    pytest.mark.compiled,  # much slower, or nothing to compare, without it
    pytest.mark.usefixtures("backend"),
]
k, b, c, w, s = sp.symbols("k b c w s")


def in_front_of_a_stop(forced):
    lowest = {k: -1, b: -sp.oo, c: -1, **({w: 0} if forced else {}), s: 0}
    return one_mass(
        "soft-forced" if forced else "soft",
        RigidStop("x", at=s, restitution=sp.Rational(1, 2), name="wall"),
        stiffness=k, damping=c, load=[b], forces={w: 5} if forced else {},
        parameters=[Parameter(str(x), str(x), lower=lower) for x, lower in lowest.items()],
    )  # fmt: skip


FREE, FORCED = in_front_of_a_stop(False), in_front_of_a_stop(True)


@pytest.mark.parametrize("small", SMALL[1::2])
def test_an_impact(small):
    for system, parameters in (
        (FORCED, {"k": small, "b": 0, "c": 0, "w": 1.7, "s": 1}),
        (FORCED, {"k": small, "b": 1, "c": 0, "w": 1.7, "s": 1}),
        (FORCED, {"k": small, "b": 1, "c": small, "w": 1.7, "s": 1}),
        (FORCED, {"k": 1, "b": 0, "c": 0, "w": 1 + small, "s": 9}),
        (FREE, {"k": small, "b": 1, "c": 0, "s": 1}),
        (FREE, {"k": small, "b": 0.1, "c": math.sqrt(small), "s": 1}),
    ):
        start = [0, 0.5, *((1, 0) if system is FORCED else ())]
        motion = ns.simulate(system, parameters, start, transitions=1)
        if motion.transitions:
            values = {name: repr(float(value)) for name, value in parameters.items()}
            _, _, instants, states = DeclaredMotion(system, values).run("free", start, 1)
            assert motion.end == pytest.approx(float(instants[1]), rel=1e-13)
            wanted = [float(x) for x in [*states[1]][:-1]]
            assert_allclose(motion.states[1], wanted, rtol=0, atol=1e-13 * max(map(abs, wanted)))


@pytest.mark.parametrize("small", [1e-6, 1e-5, 1e-4])
def test_a_composed_orbit(small):
    """The response of a soft spring about its equilibrium, whose closing is worth 1/k digits."""
    parameters = {"k": small, "b": 1, "c": 0, "w": 1.7, "s": 1e9}
    wanted = np.array([1 / small + 5 / (small - 1.7**2), 0, 1, 0])
    period = 2 * math.pi / 1.7
    phases = [("free", "forcing-phase")]
    found = ns.solve(FORCED, parameters, [period, *wanted], itinerary=phases)
    assert found.dwell_times[0] == pytest.approx(period, rel=1e-14)
    assert_allclose(found.states[0], wanted, rtol=0, atol=1e-13 / small**2)
