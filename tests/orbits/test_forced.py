"""Forced systems: orbits at amplitude 1 of the forcing, with the stroboscopic map's multipliers."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Harmonic, Parameter, RigidStop, SoftStop, oscillator
from tests.one_mass import one_mass

ONE = [("free", "stop-reaches-stop")]
DATA = {"zeta": "0.05", "Omega": 2, "r": "0.8"}


@cache
def impact(second=0.0):
    """A damped mass in front of a stop, forced at Omega and, if asked for, at 2 Omega."""
    zeta = Parameter("zeta", "damping", lower=0, closed=True)
    speed = Parameter("Omega", "frequency")
    r = Parameter("r", "restitution", lower=0, upper=1, closed=True, upper_closed=True)
    forces = {speed.symbol: 1} | ({2 * speed.symbol: second} if second else {})
    stop = RigidStop("x", 0, r.symbol, name="stop")
    known = [zeta, speed, r]
    return one_mass("forced", stop, forces=forces, damping=2 * zeta.symbol, parameters=known)


def settled(system, data, transitions=800):
    return ns.simulate(system, data, {"x": "-0.5", "v": 0}, transitions=transitions)


def test_the_forcing_starts_at_its_maximum_where_nothing_is_said():
    def begin(system, start):
        motion = ns.simulate(system, DATA, start, until=1.0)
        return list(motion.states[0].tolist())

    assert begin(impact(0.5), {"x": -1, "v": 0}) == [-1, 0, 1, 0, 1, 0]
    assert begin(impact(), {"x": -1, "v": 0, "c1": 0, "s1": 1}) == [-1, 0, 0, 1]
    with pytest.raises(InputError, match="phases to each other belong to the declaration"):
        begin(impact(0.5), {"x": -1, "v": 0, "c2": 0, "s2": 1})
    with pytest.raises(InputError, match="needs a value for: v"):
        begin(impact(), {"x": -1})


@pytest.mark.parametrize("guided", [False, True])
def test_an_orbit_is_where_the_motion_settles(guided):
    motion = settled(impact(), DATA)
    period = np.diff(motion.times)[-1]
    guess = motion.states[-1] if guided else ()
    orbit = ns.solve(impact(), DATA, [period, *guess], itinerary=ONE)
    assert orbit.converged
    assert orbit.period == pytest.approx(np.pi, rel=1e-14)
    assert_allclose(orbit.states[0], motion.states[-1], atol=1e-12)
    assert np.hypot(*orbit.states[0, 2:]) == pytest.approx(1, abs=1e-15)
    assert orbit.admissibility.verdict is True
    assert not orbit.tables.family


def test_frequencies_keep_the_phase_they_began_with():
    """At 2 Omega the second forcing is at c = 1 whenever the first is."""
    system = impact(0.5)
    motion = settled(system, DATA)
    orbit = ns.solve(system, DATA, [np.diff(motion.times)[-1]], itinerary=ONE)
    assert_allclose(orbit.states[0], motion.states[-1], atol=1e-11)
    c, s, second, other = orbit.states[0, 2:]
    assert second == pytest.approx(c * c - s * s, abs=1e-13)
    assert other == pytest.approx(2 * c * s, abs=1e-13)
    assert len(orbit.multipliers) == 2
    precise = ns.solve(system, DATA, [np.diff(motion.times)[-1]], itinerary=ONE, digits=40)
    c, s, second, other = precise.states[0, 2:]
    assert abs(second - (c * c - s * s)) < 1e-38
    assert abs(precise.period - precise.arithmetic.mp.pi) < 1e-38


def test_the_start_of_an_orbit_is_one_of_a_motion():
    """At a stop at zero a position is 1e-29: it has no size of its own."""
    orbit = ns.solve(impact(), DATA, [3.14], itinerary=ONE)
    for position in (orbit.states[0, 0], 1e-25, -1e-25):
        start = [position, *orbit.states[0, 1:]]
        motion = ns.simulate(impact(), DATA, start, transitions=3)
        assert_allclose(np.diff(motion.times), np.pi, rtol=1e-12)
    with pytest.raises(InputError, match="beyond stop-reaches-stop"):
        ns.simulate(impact(), DATA, [1e-9, *orbit.states[0, 1:]], transitions=3)


@pytest.mark.parametrize("backend", ["", "numpy"])
def test_a_mass_that_nothing_moves_does_not_hide_the_orbit(monkeypatch, backend):
    """Its state goes to zero by itself: it has no size that a step could be compared with."""
    monkeypatch.setenv("NONSMOOTH_BACKEND", backend)

    def stop(coordinates):
        still = len(coordinates) - 1
        return oscillator(
            f"masses-{len(coordinates)}",
            coordinates,
            np.diag([1] * (1 + still)).tolist(),
            np.diag([1] + [5] * still).tolist(),
            np.diag([0.1] + [1] * still).tolist(),
            forcing=[Harmonic("1.3", cosine={coordinates[0]: "0.3"})],
            elements=[SoftStop(coordinates[0], at=1, stiffness=15, name="stop")],
        )

    begin = {"x1": -2, "v1": 2}
    alone = ns.simulate(stop(["x1"]), {}, begin, until=600)
    both = ns.simulate(stop(["x1", "x2"]), {}, begin | {"x2": 1, "v2": 0}, until=600)
    one = ns.solve(stop(["x1"]), {}, itinerary=ns.itinerary_of(alone))
    two = ns.solve(stop(["x1", "x2"]), {}, itinerary=ns.itinerary_of(both))
    assert_allclose(two.dwell_times, one.dwell_times, rtol=1e-12)
    assert_allclose(two.states[:, [1, 3]], 0, atol=1e-20)
    decay = np.exp(-two.period / 2)
    assert np.sort(np.abs(two.multipliers))[:2] == pytest.approx(decay, rel=1e-9)
    assert str(ns.refine(two, 40).period)[:12] == str(one.period)[:12]
