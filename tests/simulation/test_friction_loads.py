"""Friction whose normal load vanishes or whose force is exhausted: motions in closed form."""

import math

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, RigidStop, oscillator
from tests.one_mass import one_mass

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

MASS = np.array([[2, 0.5], [0.5, 1]])


def test_a_block_without_a_force_along_its_belt_lifts_and_lands_at_rest():
    """Both limits vanish at one instant, and it lands at the velocity of the belt."""
    c = sp.Symbol("c1")
    pads = [Friction(x, 0.3, 0.4, velocity=1, normal=1 + 2 * c, name=f"{x}-pad") for x in "xy"]
    zero = np.zeros((2, 2))
    system = oscillator("blocks", ["x", "y"], MASS, zero, forcing=[Harmonic(1)], elements=pads)
    motion = ns.simulate(system, {}, [0, 0, 1, 1, 1, 0], until=10.0)
    assert motion.configurations == tuple(["stick-stick", "lifted-lifted"] * 2)
    assert np.allclose(motion.times[1:], np.array([2, 4, 8]) * math.pi / 3, atol=1e-12)
    assert np.allclose(motion(10.0)[:4], [10, 10, 1, 1], atol=1e-12)


def test_a_plastic_impact_leaves_a_contact_at_rest():
    """On the ground, against a stop without rebound: the pad is at rest, then held."""
    pad = Friction("x", 0.3, 0.4, normal=1 + sp.Symbol("x"), falling=0.1, name="pad")
    stop = RigidStop("x", at=0.2, restitution=0, name="stop")
    system = one_mass("held", pad, stop, load=[2])
    motion = ns.simulate(system, {}, [0, 0], until=5.0)
    assert motion.configurations[-1].endswith("contact")
    assert np.allclose(motion(5.0), [0.2, 0], atol=1e-14)


def test_an_orbit_with_exhausted_friction_is_certified():
    """Self-excited: the slope is above the damping, until no friction is left."""
    belt = Friction("x", 1, 1.2, velocity=1, falling=0.6, name="belt")
    system = one_mass("falling", belt, damping=0.05)
    found = ns.itinerary_of(ns.simulate(system, {}, [0, 1], until=60.0))
    assert found.itinerary[:3] == (
        ("slip", "belt-exhausts"),
        ("exhausted-slip", "belt-recovers"),
        ("slip", "belt-reaches-belt"),
    )
    orbit = ns.solve(system, {}, [*found.dwell_times, *found.start], itinerary=found.itinerary)
    certificate = ns.certify(orbit)
    assert set(certificate.claims.values()) == {"proved"}
    # without friction: x'' + x'/20 + x = 0 from r = -5/3 to r = -5/3
    state, time = orbit.states[1], orbit.dwell_times[1]
    w = math.sqrt(1 - 0.025**2)
    turned = np.exp(-0.025 * time) * (
        np.cos(w * time) * state[1] - np.sin(w * time) / w * (state[0] + 0.025 * state[1])
    )
    assert state[1] == pytest.approx(1 - 5 / 3, abs=1e-12)
    assert turned == pytest.approx(1 - 5 / 3, abs=1e-12)
