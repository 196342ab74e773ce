"""Derivatives of motions against differences, forward against reverse, and what is refused."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth.derive import Friction, Parameter, RigidStop
from tests.differences import in_doubles
from tests.moved_motions import check_reverse, compared_at_random
from tests.one_mass import one_mass
from tests.tables import slow

DATA = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 0.5}
START = [0, 0, 1.5, 0.3]
ALL = ("m1", "m2", "k1", "k2", "r", "x10", "x20", "v10", "v20")


@pytest.mark.parametrize(
    ("asked", "atol"), [({"times": [1.0, 5.0, 9.9]}, 3e-9), ({"transitions": 6}, 1e-8)], ids=str
)
def test_states_and_times_follow_all_numbers_through_impacts(asked, atol):
    found = ns.motion_function("rigid-stop", DATA, START, by=ALL, **asked)
    assert_allclose(
        found.jacobian(found.reference), in_doubles(found, found.reference), rtol=1e-8, atol=atol
    )


@pytest.mark.parametrize("times", [None, [0.5, 7.0]])
def test_reverse_is_forward(times):
    motion = ns.simulate("rigid-stop", DATA, START, until=20)
    found = motion.derivatives(times=times)
    random = np.random.default_rng(1)
    check_reverse(found, random)
    direction = random.normal(size=len(found.by))
    for name, part in found.jvp(direction).items():
        assert_allclose(part, getattr(found, name) @ direction, atol=1e-12)


def test_what_is_unknown_is_named():
    motion = ns.simulate("rigid-stop", DATA, START, until=5)
    with pytest.raises(ns.InputError, match="parameter or start"):
        motion.derivatives(["m3"])


def _ball():
    """A mass that a load pushes onto a stop at 0."""
    load, restitution = Parameter("g", "load"), Parameter("r", "restitution")
    stop = RigidStop("x", 0, restitution.symbol, name="floor")
    parameters = [load, restitution]
    return one_mass("ball", stop, stiffness=0, load=[load.symbol], parameters=parameters)


def _grazing():
    """An oscillation that just touches a stop at 1."""
    clearance = Parameter("c", "clearance")
    stop = RigidStop("x", clearance.symbol, 0.5, name="wall")
    system = one_mass("touch", stop, parameters=[clearance])
    return ns.simulate(system, {"c": 1}, [0, 1], until=3)


def test_impacts_that_accumulate_are_named():
    motion = ns.simulate(_ball(), {"g": 1, "r": "0.5"}, [-1, 0], until=20)
    with pytest.raises(ns.InputError, match=r"floor-reaches-stop accumulate at t = 4\.2426"):
        motion.derivatives()


def test_a_grazing_has_a_derivative_on_the_side_of_no_impact():
    motion = _grazing()
    with pytest.raises(ns.InputError, match=r"wall-reaches-stop is reached tangentially .* by v0"):
        motion.derivatives(["v0"], times=[3.0])
    with pytest.raises(ns.InputError, match=r"on the side \+ by v0"):
        motion.derivatives(["v0"], times=[3.0], one_sided="+")
    found = motion.derivatives(["v0"], times=[3.0], one_sided="-").states[0, :, 0]
    assert_allclose(found, [np.sin(3), np.cos(3)], rtol=1e-13)
    assert_array_equal(
        motion.derivatives(["c"], times=[3.0], one_sided="+").states, np.zeros((1, 2, 1))
    )


def test_a_start_on_a_boundary_has_a_derivative_on_one_side():
    motion = ns.simulate(_ball(), {"g": 1, "r": "0.5"}, [0, -1], until=1)
    with pytest.raises(ns.InputError, match="the start lies on floor-reaches-stop at t = 0"):
        motion.derivatives(["x0"], times=[1.0])
    found = motion.derivatives(["x0", "v0"], times=[1.0], one_sided="-")
    assert_allclose(found.states[0], [[1, 1], [0, 1]])


def test_a_time_at_a_transition_is_refused():
    motion = ns.simulate(_ball(), {"g": 2, "r": "0.5"}, [-1, -1], transitions=2)
    with pytest.raises(ns.InputError, match="floor-reaches-stop is reached at t = "):
        motion.derivatives(times=[motion.end])
    side = motion.derivatives(["g"], times=[motion.end], one_sided="+")  # it comes sooner
    changes = side.behind[-1, :, 0] - side.event_times[-1, 0] * np.array([motion.states[-1, 1], 2])
    assert_allclose(side.states[0, :, 0], changes, rtol=1e-13)


def test_a_held_velocity_stays_and_follows_its_constraint():
    belt = Parameter("V", "belt")
    rub = Friction("x", 1, 2, velocity=belt.symbol, name="belt")
    system = one_mass("belt", rub, parameters=[belt])
    motion = ns.simulate(system, {"V": "0.5"}, [0, 0.5], "stick", until=1)
    found = motion.derivatives(["V", "x0", "v0"], times=[1.0]).states[0]
    assert_allclose(found, [[1, 1, 0], [1, 0, 0]], atol=1e-15)


def test_phases_of_forcings_move_on_their_circle():
    system = one_mass("forced", stiffness=4, forces={1: 1})
    motion = ns.simulate(system, {}, {"x": 0, "v": 0}, until=1)
    assert motion.derivatives().by == ("x0", "v0")
    found = motion.derivatives(["c10", "s10"], times=[1.0]).states[0]
    # x = (cos(t + a) - cos a cos 2t + sin a sin(2t) / 2) / 3 by the phase a at 0
    assert_allclose(found[:, 0], 0, atol=1e-15)
    assert_allclose(found[0, 1], (-np.sin(1) + np.sin(2) / 2) / 3, rtol=1e-13)


@pytest.mark.parametrize("seed", [2, *(slow(seed) for seed in (4, 5))])
def test_random_oscillators_agree_with_differences_in_fifty_digits(seed):
    found = compared_at_random(np.random.default_rng([7, seed]), f"random-{seed}", 30)
    assert found is None or found < 1e-11


def test_what_follows_an_impact_at_once_has_its_time():
    # an impact turns the velocity, so that the slider sticks at the same instant
    found = compared_at_random(np.random.default_rng([11, 25]), "long-25", 40)
    assert found < 1e-11
