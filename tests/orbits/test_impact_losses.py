"""What impacts take along an orbit: against the work balance over a period, and differences."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, Parameter, RigidStop, oscillator
from tests.differences import in_doubles
from tests.places import GALLERY
from tests.tables import slow

DATA = {"m": 2.0, "F": 1.0, "w": 1.3, "g": 0.1, "r": 0.6, "d": 0.3}
BETWEEN = {"x2": 1, "x1": -1}
COUPLED = sp.Rational(1, 4)


def two_masses(place, *more, coupled):
    """A forced pair; a stop at a mass, or between both; the mass matrix couples them or not."""
    found = [Parameter(name, name) for name in DATA]
    m, force, w, gap, r, d = (parameter.symbol for parameter in found)
    other = COUPLED if coupled else 0
    return oscillator(
        "pair",
        ["x1", "x2"],
        mass=[[m, other], [other, 1]],
        stiffness=[[3, -1], [-1, 2]],
        damping=[[d, -d / 2], [-d / 2, d]],
        forcing=[Harmonic(w, cosine={"x1": force})],
        elements=[RigidStop(place, gap, r, name="hard"), *more],
        parameters=found,
    )


def settled(system):
    """The orbit on which a motion from rest settles."""
    start = dict.fromkeys(("x1", "x2", "v1", "v2"), 0.0)
    motion = ns.simulate(system, DATA, start, until=400)
    return ns.solve(system, DATA, itinerary=ns.itinerary_of(motion))


def lost(orbit):
    """What the forcing brings over a period, without what the dampers take."""
    motion, total = orbit.trajectory(), 0.0
    nodes, weights = np.polynomial.legendre.leggauss(40)
    ends = [*motion.times.tolist(), motion.end]
    for begin, end in pairwise(ends):
        half = (end - begin) / 2
        if half <= 0:
            continue
        states = motion(begin + half * (1 + nodes))
        v1, v2, cosine = states[:, 2], states[:, 3], states[:, 4]
        damped = DATA["d"] * (v1**2 - v1 * v2 + v2**2)
        total += half * float(weights @ (DATA["F"] * cosine * v1 - damped))
    return total


@pytest.mark.parametrize(
    ("place", "coupled"),
    [("x2", False), (BETWEEN, False), slow(BETWEEN, True)],
    ids=["wall", "between", "coupled"],
)
def test_friction_and_impacts_add_up(place, coupled):
    """To what the work balance over a period tells."""
    rub = Friction("x1", sp.Rational(1, 10), sp.Rational(1, 10), name="rub")
    orbit = settled(two_masses(place, rub, coupled=coupled))
    found = orbit.derivatives()
    parts = [found.quantity(name)[0] for name in found.names if name.startswith("dissipation:")]
    assert len(parts) == 2
    assert min(parts) > 1e-3
    assert found.quantity("dissipation")[0] == pytest.approx(sum(parts), rel=1e-14)
    assert sum(parts) == pytest.approx(lost(orbit), rel=1e-10)


@pytest.mark.slow
def test_losses_have_derivatives():
    orbit = settled(two_masses(BETWEEN, coupled=True))
    function = ns.orbit_function(orbit, by=tuple(DATA), of="dissipation")
    point = function.reference
    expected = in_doubles(function, point, 1e-5)
    np.testing.assert_allclose(function.jacobian(point), expected, rtol=1e-6, atol=1e-8)


def test_elastic_impacts_take_nothing():
    orbit = ns.solve("rigid-stop/one-impact", {"r": 1})
    assert orbit.derivatives().quantity("dissipation")[0] == pytest.approx(0, abs=1e-13)


def test_each_of_two_stops_of_a_mass_has_its_own():
    found = ns.solve(f"{GALLERY}/two_stops.py:broken").derivatives()
    left, right = (found.quantity(f"dissipation:{side}-stop")[0] for side in ("left", "right"))
    assert min(left, right) > 1e-3
    assert found.quantity("dissipation")[0] == pytest.approx(left + right, rel=1e-14)
    assert abs(left - right) > 1e-6
