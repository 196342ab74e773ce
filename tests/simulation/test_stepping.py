"""Motions at the edge of what doubles tell apart, by both engines: one set, none, or a touch."""

import math
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm
from scipy.optimize import brentq

import nonsmooth as ns
from nonsmooth.derive import RigidStop, oscillator
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import TransitionShape, mode_shapes
from nonsmooth.runtime.simulation import stepping
from nonsmooth.runtime.simulation.simulate import follow
from tests.large_systems import by_tables
from tests.two_masses import CHAIN, RUBBING, STICKING

pytestmark = pytest.mark.usefixtures("backend")


def generator(data, configuration=0):
    """Of (y, 1)' = G (y, 1), for dry friction."""
    field = piecewise("dry-friction", data).fields[configuration]
    return np.vstack([field, np.zeros(field.shape[1])])


def rubbed(start, data=STICKING, configuration="slip-slip"):
    """A motion with dry friction until its first transition, and which boundaries end it."""
    motion = ns.simulate("dry-friction", data, start, configuration, transitions=1)
    assert motion.transitions == 1
    return motion, motion.run.sets[1]


def test_a_velocity_that_only_touches_the_belt_is_an_event():
    rates = generator(RUBBING)
    # at V with no acceleration, and its next derivative negative: the maximum is V
    V, chi, us1 = 0.6773, 0.4, 0.0127
    touch = np.array([us1 + chi * 1.0, 1.0, V, -0.5, 1.0])
    second = (rates @ rates @ touch)[2]
    touch[3] = (V + 0.3) / chi if second > 0 else touch[3]
    assert abs((rates @ touch)[2]) < 1e-15
    assert (rates @ rates @ touch)[2] < 0
    start = (expm(-0.5 * rates) @ touch)[:4]
    motion, reached = rubbed(start, RUBBING)
    assert reached == 1
    assert motion.times[1] == pytest.approx(0.5, abs=1e-7)
    motion, _ = rubbed(start - np.array([0, 0, 1e-9, 0]), RUBBING)
    assert motion.times[1] > 0.6


def test_a_force_that_only_touches_its_limit_is_passed_by_and_told():
    # f1 = x1 - chi x2 has its maximum where v2 = V/chi; the limit is set to it
    rates, where = generator(STICKING, 5), "stick-overshoot"
    row = np.array([1.0, -0.5, 0, 0, 0])
    state = np.array([0.0, -6.0, 1.0, 1.2, 1.0])
    slope = brentq(lambda t: row @ rates @ expm(rates * t) @ state, 0.1, 0.9, xtol=1e-15)
    limit = row @ expm(rates * slope) @ state
    motion, _ = rubbed(state[:4], STICKING | {"ur1": limit}, where)
    (grazing,) = motion.grazings
    assert (grazing.configuration, grazing.boundary) == (5, 0)
    assert grazing.time == pytest.approx(slope, abs=1e-6)
    assert abs(grazing.depth) < 1e-13
    assert motion.times[1] > slope + 0.01
    assert rubbed(state[:4], STICKING | {"ur1": limit - 1e-9}, where)[0].times[1] < slope


def test_elastic_impacts_keep_the_energy(backend):
    """Each impact errs by a few roundings, and they add up no faster than their number."""
    count = 100_000 if backend == "c" else 300
    motion = ns.simulate("rigid-stop", CHAIN | {"r": 1}, [0.2, -0.3, 1.5, 0.7], transitions=count)

    def energy(y):
        x1, x2, v1, v2 = y.T
        return (v1**2 + 2 * v2**2 + (x1 - x2) ** 2 + 5 * x2**2) / 2

    assert motion.status.name == "TRANSITIONS"
    after = energy(motion.states)
    assert (np.abs(after / after[0] - 1) <= 1e-15 + 5e-16 * np.arange(count + 1)).all()
    assert np.abs(after / energy(motion.before) - 1).max() <= 5e-16
    assert_allclose(motion.before[1:, 0], 1.0, rtol=0, atol=1e-14)
    assert (motion.before[1:, 2] > 0).all()
    assert (motion.states[1:, 2] == -motion.before[1:, 2]).all()


@pytest.mark.parametrize(("r", "fewest", "most"), [(0.5, 40, 60), (0, 2, 2)])
def test_impacts_that_accumulate_end_in_contact_which_releases(r, fewest, most):
    motion = ns.simulate("rigid-stop", CHAIN | {"k2": "0.1", "r": r}, [0.9, 3, 0, 0], until=8.0)
    first = motion.configurations.index("contact")
    assert fewest <= first <= most
    assert (motion.states[first, [0, 2]] == (1.0, 0.0)).all()
    assert (np.diff(motion.times[: first + 1]) >= 0).all()
    # it leaves where the spring between the masses begins to pull
    assert motion.configurations[first + 1] == "free"
    assert motion.before[first + 1, 1] == pytest.approx(1.0, abs=1e-14)
    assert motion.times[first + 1] > motion.times[first] + 0.5


@pytest.mark.parametrize("r", [0.25, 0.5, 0.9])
def test_a_bouncing_ball_comes_to_rest_after_a_geometric_sum(r):
    data = {"gravity": 1, "r": r}
    motion = ns.simulate("docs/gallery/bouncing_ball.py", data, [0.5, 0], transitions=10_000)
    assert motion.status.name == "QUIET"
    assert motion.configurations[-1] == "contact"
    # flights that a time in two doubles cannot tell from none are not made
    assert len(motion.times) <= 30 + 104 * math.log(2) / -math.log(r)
    # 1 to the ground, where the velocity is 1, then 2 r + 2 r^2 + ...
    assert motion.times[-1] == pytest.approx(1 + 2 * r / (1 - r), rel=1e-15)
    assert_allclose(motion.before[1:40, 1], -(r ** np.arange(39.0)), rtol=1e-12)
    assert motion.end == motion.times[-1]
    assert (motion.states[-1] == 0).all()


def test_what_was_located_is_zero_behind_the_event_unless_a_reset_moves_it(monkeypatch):
    told, watches = [], stepping._Stepper.watches

    def watched(self, *known):
        told.append(known[-1])
        return watches(self, *known)

    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    monkeypatch.setattr(stepping._Stepper, "watches", watched)
    for name, data, start, seen in (
        ("rigid-stop", CHAIN | {"r": 1}, [0, 0, 1, 0], {False}),  # an impact moves no place
        # the velocity that reaches the belt's is set to it
        ("dry-friction", STICKING, [0.5, -0.3, 0.2, 0.1], {False, True}),
    ):
        told.clear()
        motion = ns.simulate(name, data, start, transitions=12)
        moved = set()
        assert told[0] == frozenset()
        for i, zero in enumerate(told[1:]):
            shapes = motion.structure.boundaries[int(motion.run.configurations[i])]
            located = [b for b in shapes if b.name in motion.boundaries[i + 1]]
            kept = {b.row for b in located if not b.name.endswith("belt")}
            assert zero == kept
            moved.add(len(located) > len(kept))
        assert moved == seen


IDENTITY = np.eye(2, 3)


def straight(speeds, level, *transitions, reset=IDENTITY):
    """x' = a and y' = b, with a boundary where x reaches a level, and one where y does."""
    field = np.array([[0, 0, speeds[0]], [0, 0, speeds[1]]])
    return by_tables(
        "straight", field[None], np.array([[1.0, 0, -level], [0, 1, -level]]),
        np.stack([IDENTITY, reset]), [[("right", 0, False), ("up", 1, False)]], [[*transitions]],
        [(mode_shapes([(2, False)]), np.zeros((1, 2)), np.stack([IDENTITY, field]))],
    )  # fmt: skip


@pytest.mark.parametrize("speeds", [(1.0, 2.0), (2.0, 1.0), (4.0, 0.5), (-1.0, 0.25), (3.0, 3.0)])
def test_of_two_straight_flights_the_shorter_one_ends_first(speeds):
    motion = follow(straight(speeds, 1), np.zeros(2), 0)
    assert motion.status.name == "UNDECLARED"
    assert motion.end == 1 / max(speeds)


def test_times_are_sums_without_rounding_errors_that_grow():
    """Each flight takes the double 0.1; a sum of doubles would err by 1e-12."""
    again = TransitionShape(frozenset({0}), (), 1, 0)
    system = straight((1.0, 0.0), 0.1, again, reset=np.array([[0, 0, 0], [0, 1.0, 0]]))
    motion = follow(system, np.zeros(2), 0, transitions=3000)
    assert motion.times.tolist() == [float(k * Fraction(0.1)) for k in range(3001)]
    motion = follow(system, np.zeros(2), 0, until=0.25, transitions=9)
    assert (motion.status.name, motion.end, len(motion.times)) == ("UNTIL", 0.25, 3)


def test_transitions_without_time_between_them_end():
    stay = TransitionShape(frozenset({0}), (), 0, 0)
    motion = follow(straight((1.0, 0.0), 0.1, stay), np.zeros(2), 0, transitions=10_000)
    assert motion.status.name == "IMMEDIATE"
    assert 100 <= len(motion.times) - 1 <= 105


def test_a_swing_keeps_its_digits_over_thousands_of_radians():
    """Its angle is a product of doubles, whose rounding is taken in: x'' = -w^2 x, y' = s."""
    w, speed, high = math.sqrt(1.5), 2.0**-11, mp.MPContext()
    high.dps = 40
    still, drift, cosine, sine = flows = np.zeros((4, 3, 4))
    still[2, 2], drift[2, 3] = 1, speed
    cosine[0, 0] = cosine[1, 1] = 1
    sine[0, 1], sine[1, 0] = 1 / w, -w
    field = np.array([[0, 1, 0, 0], [-w * w, 0, 0, 0], [0, 0, 0, speed]])
    modes = mode_shapes([(2, False), (1, True)]), np.array([(0, 0), (0, w)]), flows
    for level in (3, 5, 7, 11):  # it is there at a time without rounding
        system = by_tables(
            "swing", field[None], np.array([[0.0, 0, 1, -level]]), np.eye(3, 4)[None],
            [[("there", 0, False)]], [[TransitionShape(frozenset({0}), (), 0, 0)]], [modes],
        )  # fmt: skip
        motion = follow(system, np.array([1.0, 0.0, 0.0]), 0, transitions=1)
        angle = high.mpf(w) * high.mpf(float(motion.times[1]))
        assert motion.times[1] == level / speed
        expected = [float(high.cos(angle)), float(-w * high.sin(angle))]
        assert_allclose(motion.before[1][:2], expected, rtol=0, atol=1e-14)


def test_a_slow_coordinate_is_waited_for_beside_a_fast_one():
    """Both turn undisturbed; the slow one, at 1/100 of the speed, grows to its boundary."""
    speed = 100.0
    system = oscillator(
        "two-speeds", ["x", "y"], np.eye(2), [[speed**2, 0], [0, 1e-4]], [[0, 0], [0, -1.6e-4]],
        elements=[RigidStop("y", 1.1, 0.5, name="far")],
    )  # fmt: skip
    start = [1.0, 1.0, 0, 0]
    motion = ns.simulate(system, {}, start, transitions=1)
    assert motion.transitions == 1
    assert motion.end > 1e5 / speed
    field = motion.system.fields[0]
    arrived = expm(np.vstack([field, np.zeros(5)]) * motion.end) @ [*start, 1.0]
    assert arrived[1] == pytest.approx(1.1, abs=1e-9)
    early = 0.9 * motion.end
    waiting = ns.simulate(system, {}, start, until=early)
    assert (waiting.status.name, waiting.transitions, waiting.end) == ("UNTIL", 0, early)
