"""Several harmonics: their phases to each other belong to the system, and no start changes them."""

import math
from functools import cache

import numpy as np
import pytest
import sympy as sp
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Harmonic, RigidStop, oscillator
from nonsmooth.runtime.cli.program import app

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

START = {"x": "-0.5", "v": 0}


@cache
def two(phase=0, second=3, first=0):
    return oscillator(
        "two", ["x"], [[1]], [[1]], [[sp.Rational(1, 10)]],
        forcing=[
            Harmonic(sp.Rational(3, 2), cosine=[1], phase=first),
            Harmonic(second, cosine=[1], phase=phase),
        ],
        elements=[RigidStop("x", 0, sp.Rational(4, 5), name="stop")],
    )  # fmt: skip


def settled(phase):
    motion = ns.simulate(two(phase), {}, START, transitions=600)
    return motion, ns.solve(two(phase), {}, itinerary=ns.itinerary_of(motion))


@pytest.mark.parametrize("phase", [0, 1, 2.5])
def test_the_orbit_is_that_of_the_simulated_phase(phase):
    motion, orbit = settled(phase)
    assert orbit.converged
    np.testing.assert_allclose(orbit.states[0], motion.states[-1], atol=1e-10)
    other = ns.simulate(two(), {}, START, transitions=600)
    assert (abs(other.states[-1, 1] - motion.states[-1, 1]) > 1e-3) == (phase != 0)


@pytest.mark.slow
def test_a_certificate_is_of_the_phase():
    """Its cosine and sine are exact, rational or not, and never as if they were zero."""
    for phase in (sp.atan2(4, 3), 1):
        _, orbit = settled(phase)
        certificate = ns.certify(orbit)
        assert certificate.claims["existence"] == "proved"
        for name, value in orbit.unknowns.items():
            assert abs(float(certificate.enclosures[name].mid) - float(value)) < 1e-9


def test_a_start_that_contradicts_the_phases_is_refused():
    other = {**START, "c2": math.cos(1), "s2": math.sin(1)}
    for second in (3, sp.sqrt(5)):
        with pytest.raises(InputError, match=r"at no time as in the start.*phase="):
            ns.simulate(two(0, second), {}, other, transitions=5)
        motion = ns.simulate(two(0, second), {}, START, transitions=300)
        again = ns.simulate(two(0, second), {}, motion.states[-1], transitions=5)
        assert again.transitions == 5


def test_a_start_off_the_circle_is_refused(tmp_path):
    system = two()
    wrong = {**START, "c1": "0.5"}
    told = r"c1 = 0\.5, s1 = 0: c1\^2 \+ s1\^2 is 0\.25, not 1"
    with pytest.raises(InputError, match=told):
        ns.simulate(system, {}, wrong, transitions=5)
    with pytest.raises(InputError, match=told):
        ns.simulate(system, {}, [[-0.5, 0, 0.5, 0, 1, 0]], transitions=5)
    impact = "docs/gallery/impact_oscillator.py"
    values = ["sigma=0.2", "w=3.7", "r=0.8"]
    for command in (
        ["simulate", impact, *values, "--from", "x=0,v=1,c1=2,s1=0", "--transitions", "5"],
        ["sweep", impact, "sigma=0.1:0.2:3", *values[1:], "--from", "x=0,v=1,c1=2,s1=0",
         "--quantity", "v", "--at", "free"],
    ):  # fmt: skip
        found = CliRunner().invoke(app, command)
        assert found.exit_code == 2
        assert "c1^2 + s1^2 is 4, not 1" in " ".join(found.output.split())
