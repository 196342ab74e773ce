"""The motion along an orbit, against exponentials of the phases' vector fields."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth
from nonsmooth import InputError
from nonsmooth.runtime.model.kernels import orbit_names
from tests.declared import Declared

ORBIT = "dry-friction/global-stick"
POINTS = [
    *((name, {}) for name in orbit_names()),
    (ORBIT, {"chi": "0.6", "eta": "1.2", "V": "0.9"}),
    (ORBIT, {"eta": "0.8", "e1": "2.5"}),
    ("elastic-stop/one-contact", {"k3": "1e6"}),
    ("rigid-stop/one-impact", {"T": "5"}),
]


@cache
def orbit(name=ORBIT, point=None):
    return nonsmooth.solve(name, {} if point is None else POINTS[point][1])


@pytest.fixture
def motion():
    return orbit().motion()


@pytest.fixture(params=orbit_names())
def each(request):
    """The motion along every orbit."""
    return orbit(request.param).motion()


@pytest.mark.parametrize("point", range(len(POINTS)))
def test_motion_solves_the_equations_of_each_phase(point, backend):
    found = orbit(POINTS[point][0], point)
    motion, sharp = found.motion(), nonsmooth.refine(found, 40).motion()
    assert sharp.starts.dtype == float
    for index, piece in enumerate(Declared(found).pieces):
        assert motion.configurations[index] == piece.configuration
        begin, end = motion.breaks[index : index + 2]
        times = np.linspace(begin, end, 40, endpoint=False)
        start = np.append(motion.starts[index], 1)
        exact = np.array([piece.flow(t - begin) @ start for t in times])[:, :-1]
        assert_allclose(motion(times), exact, atol=1e-12 * max(1, np.abs(exact).max()))
        assert_allclose(sharp(times), exact, atol=1e-10 * max(1, np.abs(exact).max()))


def test_motion_passes_transitions_by_their_resets(each):
    pieces = Declared(orbit(each.name)).pieces
    for index, time in enumerate(each.breaks):
        left, here, right = each([np.nextafter(time, -np.inf), time, np.nextafter(time, np.inf)])
        assert_allclose(right, here, atol=1e-13)
        jump = pieces[index - 1].jump @ np.append(left, 1)
        assert_allclose(here, jump[:-1], atol=1e-13)
        if each.name != "rigid-stop/one-impact":
            assert_allclose(left, here, atol=1e-13)
    assert_allclose(each(each.breaks[:-1]), each.starts, atol=1e-13)
    samples = each.sample(100, 2)
    twice = np.flatnonzero(np.diff(samples.times) == 0)
    for before, phase, behind in zip(*(samples.states[twice], samples.phases[twice],
                                       samples.states[twice + 1]), strict=True):  # fmt: skip
        assert_allclose(behind, (pieces[phase].jump @ np.append(before, 1))[:-1], atol=1e-13)


def test_motion_is_periodic(each):
    # not at an impact, where a rounded time may be on either side
    motion, times = each, np.linspace(1e-3, each.period - 1e-3, 101)
    for shift in (-3, -1, 1, 2, 1000):
        assert_allclose(motion(times + shift * motion.period), motion(times), atol=1e-11)
    assert_array_equal(motion(motion.period), motion(0))
    assert_array_equal(motion(-motion.period), motion(0))


def test_motion_broadcasts(motion):
    times = np.random.default_rng(1).uniform(-20, 20, (3, 5, 2))
    states = motion(times)
    assert states.shape == (3, 5, 2, 4)
    for index in np.ndindex(times.shape):
        assert_array_equal(states[index], motion(times[index]))
    assert motion(1).shape == (4,)
    assert motion([]).shape == (0, 4)
    assert motion([1, 2]).dtype == float


def test_a_phase_that_takes_no_time_is_passed_over():
    motion = orbit("dry-friction/solution-ii").motion()
    assert motion.breaks[:2].tolist() == [0, 0]
    assert motion.configurations[:2] == ("stick-stick", "slip-stick")
    assert motion.configuration(0) == "slip-stick"
    assert_array_equal(motion.starts[0], motion.starts[1])
    times = np.linspace(0, motion.period, 200)
    assert "stick-stick" not in motion.configuration(times)
    samples = motion.sample(100, 2)
    assert np.isfinite(samples.states).all()
    assert_allclose(samples.states, motion(samples.times), atol=1e-11)


def test_phases_and_configurations(motion):
    assert motion.names == ("z1", "z2", "v1", "v2")
    assert motion.configurations == ("stick-stick", "slip-stick", "slip-slip", "stick-slip")
    assert_allclose(np.diff(motion.breaks), orbit().dwell_times.tolist(), atol=1e-15)
    assert motion.breaks[0] == 0
    assert motion.period == motion.breaks[-1] == pytest.approx(orbit().period)
    # at a transition the phase that begins is meant
    assert_array_equal(motion.phase(motion.breaks), [0, 1, 2, 3, 0])
    assert motion.phase(np.nextafter(motion.breaks[1], 0)) == 0
    assert motion.phase(-1e-17) == 3
    assert motion.configuration(0.5) == "stick-stick"
    assert isinstance(motion.configuration(0.5), str)
    names = motion.configuration([[0.5, 2], [-0.1, 4]])
    assert names.tolist() == [["stick-stick", "slip-stick"], ["stick-slip", "slip-slip"]]


@pytest.mark.parametrize("periods", [1, 2, 7])
def test_samples_have_each_transition_twice(motion, periods):
    samples = motion.sample(200, periods)
    assert samples.times.shape == samples.phases.shape == samples.states.shape[:1]
    assert samples.times[0] == 0
    assert samples.times[-1] == pytest.approx(periods * motion.period)
    steps = np.diff(samples.times)
    assert (steps >= 0).all()
    assert steps.max() < 1.1 * motion.period / 200
    twice = np.flatnonzero(steps == 0)
    assert len(twice) == 4 * periods - 1
    assert_array_equal(samples.phases[twice + 1], (samples.phases[twice] + 1) % 4)
    assert_array_equal(np.setdiff1d(motion.breaks, samples.times), [])
    assert_allclose(samples.states, motion(samples.times), atol=1e-11)
    few = motion.sample(1)
    assert_array_equal(few.times, np.repeat(motion.breaks, [1, 2, 2, 2, 1]))
    assert_array_equal(few.states[::2], motion.starts)


@pytest.mark.parametrize("time", [np.nan, np.inf, [0, -np.inf], "later", [1, None], 1j])
def test_wrong_times(motion, time):
    for ask in (motion, motion.phase, motion.configuration):
        with pytest.raises(InputError, match="time"):
            ask(time)


@pytest.mark.parametrize("counts", [(0,), (-3,), (100, 0), (10**9,)])
def test_wrong_counts(motion, counts):
    with pytest.raises(InputError, match=r"not an integer from 1|more than \d+ points"):
        motion.sample(*counts)


def test_no_motion_without_an_orbit():
    lost = nonsmooth.solve(ORBIT, {"eta": "1e300"}, throw=False)
    with pytest.raises(InputError, match="has no motion: "):
        lost.motion()
