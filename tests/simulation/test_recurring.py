"""Itineraries of simulated motions, polished to periodic orbits."""

from functools import cache

import numpy as np
import pytest

import nonsmooth
from nonsmooth import InputError, NoConvergence
from nonsmooth.derive import Regions, RigidStop, Terms, oscillator
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.recurrence import sizes_of
from tests.handmade import DATA, pair, two_stops
from tests.one_mass import one_mass
from tests.two_masses import STICKING

LONG = {**DATA, "Omega": "1.272"}  # an attractor of many impacts


@cache
def motion():
    start = {"x": 0, "v": 0.3, "c": 1, "s": 0}
    return nonsmooth.simulate(two_stops(), LONG, start, transitions=3000)


def test_the_stick_orbit_from_a_motion():
    found = nonsmooth.itinerary_of(
        nonsmooth.simulate("dry-friction", STICKING, [0, 0, 0, 0], transitions=100)
    )
    orbit = nonsmooth.solve("dry-friction", STICKING, itinerary=found)
    known = nonsmooth.solve("dry-friction/global-stick")
    assert orbit.converged
    assert orbit.period == pytest.approx(known.period, abs=1e-12)
    assert sorted(found.itinerary) == sorted(
        (configuration, boundary) for configuration, boundary, _ in known.kernels.table["phases"]
    )


def test_what_takes_no_time_is_named():
    """Impacts that accumulate are chatter; what two regions send back to each other slides."""
    stop = RigidStop("x", at=1, restitution="3/10", name="stop")
    push = Regions("v", above=Terms(load=[-5]), below=Terms(load=[5]), name="push")
    for element, said in ((stop, "chatters: in free.*infinitely"), (push, "slides: .*Friction")):
        system = one_mass("timeless", element, forces={"1/2": 3})
        motion = nonsmooth.simulate(system, {}, {"x": 0, "v": 0.5}, transitions=400)
        with pytest.raises(InputError, match=said):
            nonsmooth.itinerary_of(motion)


@cache
def long_orbit():
    found = nonsmooth.itinerary_of(motion(), since=0.8 * motion().end)
    return nonsmooth.solve(two_stops(), LONG, itinerary=found)


@pytest.mark.compiled
def test_more_than_twenty_impacts():
    orbit = long_orbit()
    count = len(orbit.itinerary)
    assert count >= 20
    assert orbit.converged
    assert orbit.admissibility.verdict is True
    assert orbit.stability.verdict == "stable"
    turns = orbit.period * 1.272 / (2 * np.pi)
    assert turns == pytest.approx(round(turns), abs=1e-10)
    # an impact multiplies areas by r^2, damping by exp(-2 zeta t)
    area = 0.8 ** (2 * count) * np.exp(-0.1 * orbit.period)
    precise = nonsmooth.refine(orbit, 30)
    product = np.prod(precise.multipliers)
    assert abs(product.real / area - 1) < 1e-10
    assert abs(product.imag / area) < 1e-10
    for rough, exact in zip(orbit.unknowns.values(), precise.unknowns.values(), strict=True):
        assert abs(rough - exact) <= 10.0**-orbit.digits * max(1, abs(exact))


@pytest.mark.compiled
def test_about_a_period():
    # a motion that never settles passes near unstable orbits
    data = {**DATA, "Omega": "1.26"}
    chaos = nonsmooth.simulate(two_stops(), data, [0, 0.3, 1, 0], transitions=2000)
    turn = 2 * np.pi / 1.26
    converged = 0
    for turns in range(1, 8):
        try:
            found = nonsmooth.itinerary_of(chaos, period=turns * turn)
        except InputError:
            continue
        assert sum(found.dwell_times) == pytest.approx(turns * turn, rel=0.05)
        try:  # a return that is near is no more than a guess
            orbit = nonsmooth.solve(two_stops(), data, itinerary=found)
        except NoConvergence:
            continue
        converged += orbit.converged and abs(orbit.period - turns * turn) < 1e-9
    assert converged


def test_boundaries_that_are_reached_together():
    both = nonsmooth.simulate(pair(), DATA, [0.1, 0.1, 0.3, 0.3, 1, 0], transitions=200)
    found = nonsmooth.itinerary_of(both)
    assert sorted(found.itinerary) == [("free", "left+down"), ("free", "right+up")]
    orbit = nonsmooth.solve(pair(), DATA, itinerary=found)
    assert orbit.converged
    assert orbit.period == pytest.approx(2 * np.pi / 1.7, rel=1e-13)


@pytest.mark.compiled
def test_a_doubled_orbit_is_no_single_one():
    data = {**DATA, "Omega": "1.274"}
    doubled = nonsmooth.simulate(two_stops(), data, [0, 0.3, 1, 0], transitions=3000)
    found = nonsmooth.itinerary_of(doubled, since=0.9 * doubled.end)
    orbit = nonsmooth.solve(two_stops(), data, itinerary=found)
    count = len(found.itinerary) // 2
    assert found.itinerary[:count] == found.itinerary[count:]
    assert not np.allclose(orbit.dwell_times[:count], orbit.dwell_times[count:], atol=1e-3)
    assert orbit.stability.verdict == "stable"
    single = nonsmooth.solve(
        two_stops(),
        data,
        [*found.dwell_times[:count], *found.start],
        itinerary=found.itinerary[:count],
    )
    assert single.stability.verdict == "unstable"
    assert min(single.multipliers.real) < -1


def test_a_motion_that_does_not_come_back():
    short = nonsmooth.simulate(two_stops(), DATA, [0, 0.3, 1, 0], transitions=6)
    alone = nonsmooth.simulate(two_stops(), DATA, [0, 0.3, 1, 0], until=0.01)
    for motion in (short, alone):
        with pytest.raises(InputError, match="does not come back"):
            nonsmooth.itinerary_of(motion)
    with pytest.raises(InputError, match=r"does not come back after about 1e\+06"):
        nonsmooth.itinerary_of(short, period=1e6)
    with pytest.raises(InputError, match="since"):
        nonsmooth.itinerary_of(short, since=-1)
    with pytest.raises(InputError, match="period"):
        nonsmooth.itinerary_of(short, period=float("nan"))


@pytest.mark.parametrize(("length", "rate"), [(1e-12, 1e3), (1e6, 1e-9)])
def test_sizes_of_states_have_their_units(length, rate):
    """Two masses, one at a stop at 0 whenever something happens, the other one at rest."""
    names = ["x1", "x2"]
    system = oscillator("two", names, [[1, 0], [0, 1]], [[1, 0], [0, 1]],
                        elements=[RigidStop("x1", at=0, restitution=1, name="stop")])  # fmt: skip
    structure = piecewise(system, {}).structure
    states = np.array([[1e-17, 0.0, 2.0, 1e-18], [-1e-17, 1e-18, -1.0, 0.0]])
    times = np.array([0.0, 3.0])
    wanted = sizes_of(structure, states, times)
    assert wanted[2] == 2.0
    assert (wanted[[0, 1, 3]] > 1e-9).all()
    units = length * np.array([1, 1, rate, rate])
    found = sizes_of(structure, states * units, times / rate)
    np.testing.assert_allclose(found, wanted * units, rtol=1e-14)
