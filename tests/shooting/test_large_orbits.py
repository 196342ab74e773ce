"""Orbits of more than 16 states: compiled as in Python."""

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive import Harmonic, RigidStop, oscillator
from tests.engines import with_both

COUNT, DATA = 8, {"A": 1.0}


@pytest.mark.slow
@pytest.mark.compiled
def test_an_orbit_of_many_states_is_found_and_judged_as_in_python():
    """Masses in a chain between walls, the last of which strikes a stop."""
    stiffness = 2 * np.eye(COUNT, dtype=int) - np.eye(COUNT, k=1, dtype=int)
    stiffness -= np.eye(COUNT, k=-1, dtype=int)
    damping = (stiffness + np.eye(COUNT, dtype=int)) * sp.Rational(1, 50)
    system = oscillator(
        "long-chain", [f"x{k + 1}" for k in range(COUNT)], sp.eye(COUNT), stiffness.tolist(),
        damping.tolist(), forcing=[Harmonic("4/5", cosine={"x1": sp.Symbol("A")})],
        elements=[RigidStop(f"x{COUNT}", at="3/10", restitution="4/5", name="stop")],
    )  # fmt: skip
    start = [*np.zeros(COUNT), *np.random.default_rng(0).normal(size=COUNT), 1, 0]
    motion = ns.simulate(system, DATA, start, transitions=3000)
    phases, dwell = motion.configurations[-3:-1], np.diff(motion.times)[-2:]
    itinerary = [(phase, "stop-reaches-stop") for phase in phases]
    guess = [*dwell * 1.001, *motion.states[-3] + 1e-3]
    orbit = ns.solve(system, DATA, guess, itinerary=itinerary)
    assert_allclose(orbit.dwell_times, dwell, rtol=0, atol=1e-5)  # the motion has come to it
    assert orbit.period == pytest.approx(2 * np.pi / 0.8, rel=1e-12)
    assert orbit.admissibility.verdict is True
    assert orbit.digits >= 8
    found, known = with_both(
        ns.solve, system, DATA, [guess], itinerary=itinerary, multipliers=True, derivatives="A"
    )
    assert found.status.tolist() == known.status.tolist() == [0]
    assert found.iterations.tolist() == known.iterations.tolist()
    assert found.admissible.tolist() == known.admissible.tolist() == [True]
    for name in ("dwell_times", "starts", "trace", "margin"):
        assert_allclose(getattr(found, name), getattr(known, name), rtol=0, atol=1e-11)
    for name, rates in known.derivatives.items():
        assert_allclose(found.derivatives[name]["A"], rates["A"], rtol=1e-8, atol=1e-8)
    precise = [float(x) for x in ns.refine(orbit, 30).unknowns.values()]
    assert_allclose([*orbit.unknowns.values()], precise, rtol=0, atol=10.0**-orbit.digits)
    # a motion that strikes nothing grazes where the response of the chain is as large as the gap
    turning = stiffness + 0.8j * np.array(damping, float) - 0.64 * np.eye(COUNT)
    gain = abs(np.linalg.solve(turning, np.eye(COUNT)[0])[-1])
    free = ns.solve(
        system, {"A": 0.2 / gain}, [orbit.period], itinerary=[("free", "forcing-phase")]
    )
    branch = ns.continue_orbit(free, "A", (0.1 / gain, 0.4 / gain))
    assert [event.kind for event in branch.events] == ["grazing"]
    assert branch.events[0].value == pytest.approx(0.3 / gain, rel=1e-8)
