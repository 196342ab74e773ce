"""Motions as a user asks for them: one or many, from any start, evaluated at any time."""

import math
import sys

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError, MissingExtra, simulate
from tests.two_masses import CHAIN, STICKING

STOP, ELASTIC = CHAIN | {"r": "0.8"}, CHAIN | {"k3": 10}
CASES = {
    "dry-friction": (STICKING, [0.5, -0.3, 0.2, 0.1]),
    "rigid-stop": (STOP, [0.0, 0.5, 1.0, 0.0]),
    "elastic-stop": (ELASTIC, [0.0, 0.0, 2.0, 0.0]),
}


# --- one motion


def test_at_a_transition_the_state_is_the_one_behind_it():
    data, start = CASES["rigid-stop"]
    motion = simulate("rigid-stop", data, start, transitions=6)
    assert_allclose(motion(motion.times), motion.states, rtol=0, atol=1e-13)
    assert_allclose(motion.states[1:, 2], -0.8 * motion.before[1:, 2], rtol=1e-15)
    just = np.nextafter(motion.times[1:], 0)
    assert_allclose(motion(just), motion.before[1:], rtol=0, atol=1e-13)
    assert motion.configuration(0.0) == "free"
    assert motion(2.0).shape == (4,)
    assert motion([]).shape == (0, 4)
    times = np.linspace(0, motion.end, 12).reshape(3, 4)
    each = [motion(time) for time in times.flat]
    assert_allclose(motion(times).reshape(12, 4), each, rtol=0, atol=1e-14)
    where = motion.structure.configurations
    phases = np.searchsorted(motion.times, times, side="right") - 1
    assert_array_equal(
        motion.configuration(times), np.take(where, motion.run.configurations[phases])
    )
    assert (motion.status.name, motion.transitions) == ("TRANSITIONS", 6)
    assert motion.boundaries[0] == ()
    assert motion(motion.end).shape == (4,)


def test_a_motion_is_the_sum_of_its_parts():
    data, start = CASES["dry-friction"]
    whole = simulate("dry-friction", data, start, until=30)
    first = simulate("dry-friction", data, start, until=12)
    again = simulate("dry-friction", data, first(12.0), str(first.configuration(12.0)), until=18)
    assert_allclose(again(18.0), whole(30.0), rtol=0, atol=1e-11)
    assert first.configurations + again.configurations[1:] == whole.configurations


def test_the_order_of_the_names_does_not_matter():
    data, start = CASES["dry-friction"]
    named = dict(zip(("x1", "x2", "v1", "v2"), start, strict=True))
    turned = dict(reversed(named.items()))
    one, other = (simulate("dry-friction", data, s, transitions=9) for s in (start, turned))
    assert_array_equal(one.states, other.states)
    texts = {"x1": "1/2", "x2": "-0.3", "v1": "0.2", "v2": "sqrt(0.01)"}
    assert simulate("dry-friction", data, texts, transitions=9).boundaries == one.boundaries


def test_what_is_never_hit_is_told():
    quiet = simulate("rigid-stop", STOP, [0, 0, 0.1, 0], transitions=1)
    assert quiet.status.name == "QUIET"
    assert "no boundary" in quiet.message


def test_a_sample_has_every_transition_twice():
    data, start = CASES["rigid-stop"]
    motion = simulate("rigid-stop", data, start, until=15)
    times, states = motion.sample(300)
    assert (np.diff(times) >= 0).all()
    assert times[[0, -1]].tolist() == [0, 15]
    assert 250 < len(times) < 300 + 3 * motion.transitions + 5
    for time, before, after in zip(
        motion.times[1:], motion.before[1:], motion.states[1:], strict=True
    ):
        here = states[times == time]
        assert_array_equal(here[0], before)
        assert_allclose(here[-1], after, rtol=0, atol=1e-14)
    for wrong in (0, True, 2.5):
        with pytest.raises(InputError, match="points"):
            motion.sample(wrong)


def test_as_a_dataset():
    pytest.importorskip("xarray")
    data, start = CASES["dry-friction"]
    motion = simulate("dry-friction", data, start, transitions=8)
    dataset = motion.to_xarray()
    assert dict(dataset.sizes) == {"transition": 9, "state": 4}
    assert_array_equal(dataset["after"].sel(state="v2"), motion.states[:, 3])
    assert_array_equal(dataset["time"], motion.times)
    assert tuple(dataset["configuration"].values) == motion.configurations
    assert dataset["boundaries"].values[1] == "+".join(motion.boundaries[1])
    assert dataset.attrs["status"] == "transitions"
    assert dataset.attrs["parameters"]["ur1"] == "4.0195"


def test_without_xarray_the_extra_is_named(monkeypatch):
    motion = simulate("dry-friction", *CASES["dry-friction"], transitions=1)
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(MissingExtra, match=r"nonsmooth\[chart\]"):
        motion.to_xarray()


@pytest.mark.parametrize("wrong", [-1e-9, 20.5, math.nan, math.inf, [0, math.nan]])
def test_no_state_beyond_the_ends(wrong):
    motion = simulate("dry-friction", *CASES["dry-friction"], until=20)
    for ask in (motion, motion.configuration):
        with pytest.raises(InputError, match="between 0 and the end"):
            ask(wrong)


@pytest.mark.parametrize("wrong", ["soon", None, 1j, [[1], [2, 3]]])
def test_times_are_real_numbers(wrong):
    motion = simulate("dry-friction", *CASES["dry-friction"], until=20)
    with pytest.raises(InputError, match=r"^times: .*(real number|is not a number)"):
        motion(wrong)


# --- where it starts


@pytest.mark.parametrize(
    ("state", "name"),
    [
        ([0, 0, 0, 0], "slip-slip"),
        ([0, 0, 2, 2], "overshoot-overshoot"),
        ([0, 0, 1, 1], "stick-stick"),
        ([0, 0, 1, 0], "stick-slip"),
        ([0, 0, 0, 1], "slip-stick"),
        ([5, 0, 1, 0], "slip-slip"),  # f1 = 5 > ur1 = 4.0195
        ([-5, 0, 1, 0], "overshoot-slip"),
        ([0, 4, 1, 1], "stick-slip"),  # f2 = 2 > ur2 = 1.4831
        ([0, -4, 1, 1], "stick-overshoot"),
        ([2, -1, 1, 1], "stick-overshoot"),  # f2 = -1.5
    ],
)
def test_friction_at_the_belts_velocity_follows_the_rules(state, name):
    """Below the static limit it sticks; beyond, the force's sign says which way it slips."""
    assert simulate("dry-friction", STICKING, state, transitions=1).configurations[0] == name


def test_a_wanted_configuration_is_checked():
    motion = simulate("dry-friction", STICKING, [0, 0, 1, 1], "stick-stick", transitions=1)
    assert motion.configurations[0] == "stick-stick"
    with pytest.raises(InputError, match="does not belong to stick-stick: v1 - 1 is -1 there"):
        simulate("dry-friction", STICKING, [0, 0, 0, 1], "stick-stick", transitions=1)
    with pytest.raises(InputError, match="beyond second-breaks-forward"):
        simulate("dry-friction", STICKING, [0, 4, 1, 1], "stick-stick", transitions=1)
    with pytest.raises(InputError, match=r"belongs to no configuration .*first-reaches-stop"):
        simulate("rigid-stop", STOP, [1.5, 0, 0, 0], transitions=1)


def test_a_mass_that_leans_on_the_stop_is_in_contact():
    leaning = simulate("rigid-stop", STOP, [1, 2, 0, 0], until=3)
    assert leaning.configurations[0] == "contact"
    pulled = simulate("rigid-stop", STOP, [1, 0, 0, 0], until=3)
    assert pulled.configurations[0] == "free"
    assert pulled.transitions == 0 or pulled.times[1] > 0.1
    arriving = simulate("rigid-stop", STOP, [1, 0, 1, 0], transitions=1)
    assert arriving.times[1] == 0
    assert arriving.states[1][2] == pytest.approx(-0.8)


# --- many motions


def test_many_are_the_single_ones(backend):
    starts = np.random.default_rng(5).uniform(-2, 2, (3, 1, 4))
    velocities = np.array([0.9, 1.1])
    many = simulate(
        "dry-friction", STICKING | {"V": velocities}, starts, transitions=12, keep=5, threads=2
    )
    assert many.states.shape == (3, 2, 4)
    assert many.last_states.shape == (3, 2, 5, 4)
    named = dict(zip(("x1", "x2", "v1", "v2"), np.moveaxis(starts, -1, 0), strict=True))
    again = simulate("dry-friction", STICKING | {"V": velocities}, named, transitions=12)
    assert_array_equal(again.states, many.states)
    for i, j in np.ndindex(3, 2):
        one = simulate(
            "dry-friction", STICKING | {"V": velocities[j]}, starts[i, 0], transitions=12
        )
        assert many.status[i, j] == one.status
        assert many.transitions[i, j] == 12
        assert many.times[i, j] == pytest.approx(one.end, abs=1e-11)
        assert_allclose(many.states[i, j], one.states[-1], rtol=0, atol=1e-10)
        assert_allclose(many.last_times[i, j], one.times[-5:], rtol=0, atol=1e-10)
        assert_allclose(many.last_states[i, j], one.states[-5:], rtol=0, atol=1e-10)
        assert_array_equal(many.last_configurations[i, j], one.run.configurations[-5:])
        assert_array_equal(many.last_sets[i, j], one.run.sets[-5:])


@pytest.mark.parametrize("keep", [0, 1, 3, 40])
def test_kept_entries_are_the_last_ones_in_their_order(keep):
    start = CASES["dry-friction"][1]
    many = simulate("dry-friction", STICKING, [start], transitions=10, keep=keep).at(0)
    one = simulate("dry-friction", STICKING, start, transitions=10)
    assert many.last_times.shape == (keep,)
    kept = min(keep, 11)
    assert_array_equal(many.last_times[keep - kept :], one.times[11 - kept :])
    assert np.isnan(many.last_times[: keep - kept]).all()
    assert (many.last_configurations[: keep - kept] == -1).all()


def test_each_motion_has_its_own_end():
    start = CASES["dry-friction"][1]
    until = np.array([1.0, 7.5, 20.0])
    many = simulate("dry-friction", STICKING, start, until=until)
    whole = simulate("dry-friction", STICKING, start, until=20)
    assert many.status.tolist() == [whole.status] * 3
    assert_array_equal(many.times, until)
    assert_allclose(many.states, whole(until), rtol=0, atol=1e-12)


def test_what_belongs_nowhere_has_a_status_of_its_own():
    starts = [[0, 0, 1, 0], [2, 0, 0, 0], [0, math.nan, 0, 0]]
    many = simulate("rigid-stop", STOP, starts, transitions=3, keep=2)
    over = simulate("rigid-stop", STOP, starts[0], transitions=3).status
    assert many.status.tolist() == [over, -1, -1]
    assert np.isnan(many.states[1:]).all()
    assert (many.configurations[1:] == -1).all()
    lost = simulate("dry-friction", STICKING | {"V": [-1, 1]}, [0] * 4, transitions=3)
    assert lost.status.tolist() == [-1, over]
    stuck = simulate(
        "dry-friction", STICKING, [[0, 0, 1, 1], [0, 0, 0, 1]], "stick-stick", transitions=1
    )
    assert stuck.status.tolist() == [over, -1]
    none = simulate("dry-friction", STICKING, np.zeros((0, 4)), transitions=3, keep=2)
    assert none.last_states.shape == (0, 2, 4)


@pytest.mark.compiled
def test_threads_change_nothing():
    starts = np.random.default_rng(8).uniform(-3, 3, (300, 4))
    wanted = simulate("dry-friction", STICKING, starts, transitions=20)
    for threads in (1, 3):
        found = simulate("dry-friction", STICKING, starts, transitions=20, threads=threads)
        assert_array_equal(found.states, wanted.states)
        assert_array_equal(found.times, wanted.times)


REFUSED = [
    ({"system": "dry-frictoin"}, "did you mean 'dry-friction'"),
    ({"parameters": {}}, "needs a value for: chi"),
    ({"parameters": STICKING | {"mu": 1}}, "unknown parameter 'mu'"),
    ({"transitions": 0}, "transitions = 0"),
    ({"transitions": None}, "nothing ends the motion"),
    ({"until": math.nan}, "until = nan"),
    ({"until": "soon"}, "until"),
    ({"configuration": "stick"}, "unknown configuration 'stick'"),
]
OF_ONE = [
    ({"parameters": STICKING | {"us1": 5}}, "does not hold"),
    ({"parameters": STICKING | {"eta": -1}}, "eta = -1"),
    ({"parameters": STICKING | {"eta": math.nan}}, "eta"),
    ({"state": [0, 0, 0]}, "3 values"),
    ({"state": {"x1": 0}}, "needs a value for: x2, v1, v2"),
    ({"state": {"z1": 0}}, "unknown state 'z1'"),
    ({"state": [0, 0, 0, math.nan]}, "v2"),
    ({"state": [0, 0, 0, np.float64("inf")]}, "v2 is inf"),
    ({"state": [0, 0, 0, 1j]}, "v2"),
    ({"configuration": 3}, "unknown configuration '3'"),
    ({"until": 0}, "until = 0.0 is not a positive time"),
    ({"until": -1}, "until = -1.0"),
    ({"until": None}, "until"),
    ({"keep": 1}, "keep and threads: of many motions only"),
    ({"threads": 1}, "keep and threads: of many motions only"),
]
OF_MANY = [
    ({"state": {"x1": [0, 1]}}, "needs a value for: x2, v1, v2"),
    ({"state": dict(x1=[0, 1], x2=[1, 2, 3], v1=0, v2=0)}, "broadcast"),
    ({"state": [[0, 0, 0, 0], [1, 2]]}, "state"),
    ({"state": np.zeros((2, 4), complex)}, "state"),
    ({"state": np.zeros((2, 3))}, "not 4 long"),
    ({"state": np.zeros((2, 1, 5))}, "not 4 long"),
    ({"until": [1, -1]}, "until = -1.0"),
    ({"until": [1, math.nan]}, "until = nan"),
    ({"until": [1, 2, 3]}, "broadcast"),
    # one of the two would never end
    ({"transitions": None, "until": [1, math.inf]}, "nothing ends the motion"),
    ({"keep": -1}, "keep = -1"),
    ({"threads": 0}, "threads = 0"),
    ({"parameters": STICKING | {"V": "fast"}}, "V"),
    ({"parameters": STICKING | {"V": [1, 2, 3]}}, "broadcast"),
]


@pytest.mark.parametrize(
    ("start", "changes", "match"),
    [([0] * 4, *case) for case in REFUSED + OF_ONE]
    + [(np.zeros((2, 4)), *case) for case in REFUSED + OF_MANY],
)
def test_bad_input(start, changes, match):
    usual = {"system": "dry-friction", "parameters": STICKING, "state": start, "transitions": 3}
    with pytest.raises(InputError, match=match):
        simulate(**(usual | changes))


def test_the_largest_count_is_no_limit_and_larger_ones_are_refused():
    start = CASES["dry-friction"][1]
    many = simulate("dry-friction", STICKING, [start], until=5, transitions=2**62).at(0)
    one = simulate("dry-friction", STICKING, start, until=5, transitions=2**62)
    assert_allclose(many.states, one(5.0), rtol=0, atol=1e-13)
    with pytest.raises(InputError, match="transitions is more than"):
        simulate("dry-friction", STICKING, start, until=5, transitions=10**30)


def test_a_state_too_large_to_compute_with_ends_the_motion(backend):
    motion = simulate("rigid-stop", CHAIN | {"r": 1}, [-1e160, 0, 0, 0], transitions=3)
    assert (motion.status.name, motion.transitions) == ("OVERFLOW", 0)
