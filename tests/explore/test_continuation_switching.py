"""The other branch at flips, broken symmetries and branch points, against simulated motions."""

import math
from functools import cache

import numpy as np
import pytest

import nonsmooth
from tests.explore.test_continuation_forced import R, W, branch, broken, stops, system
from tests.explore.test_continuation_pairs import pair
from tests.places import GALLERY

SYMMETRIC = "dry-friction/symmetric"
PAGE = GALLERY / "impact_oscillator.py"


@cache
def doubled():
    flip = [event for event in branch().events if event.kind == "flip"][-1]
    orbit = branch().switch(flip)
    return nonsmooth.continue_orbit(orbit, "sigma", (-0.1, -0.02), step=0.05)


def dwell_times_of_motions(system, orbit):
    """Of the orbit to which motions from nearby come, in order."""
    start = orbit.states[0].astype(float) * np.array([1, 1.001, 1, 1])
    motion = nonsmooth.simulate(system, orbit.parameters, start, transitions=800)
    phases, dwell, begin = nonsmooth.itinerary_of(motion)
    again = nonsmooth.solve(system, orbit.parameters, [*dwell, *begin], itinerary=phases)
    return np.sort(again.dwell_times)


def check_closed(system, orbit):
    """The motion is back after the transitions of a period."""
    start, (configuration, _) = orbit.states[0].astype(float), orbit.itinerary[0]
    motion = nonsmooth.simulate(
        system, orbit.parameters, start, configuration, transitions=len(orbit.itinerary)
    )
    assert motion.configurations[-1] == configuration
    np.testing.assert_allclose(motion.states[-1], start, atol=1e-9)


def flip_of_doubled():
    (event,) = (event for event in doubled().events if event.kind == "flip")
    return event


def test_a_doubled_orbit_is_that_of_a_simulation():
    flip = branch().events[-1]
    stable = [
        k
        for k in range(len(doubled()))
        if doubled().stability[k] == "stable" and doubled().admissible[k]
    ]
    assert len(stable) >= 5
    for place in stable[1 :: max(1, len(stable) // 3)]:
        orbit = doubled().orbit_at(place)
        assert len(orbit.itinerary) == 2
        assert orbit.period == pytest.approx(2 * branch().period[0], rel=1e-12)
        dwell = dwell_times_of_motions(system(), orbit)
        np.testing.assert_allclose(dwell, np.sort(orbit.dwell_times), atol=1e-9)
        # the flip is supercritical: a multiplier of the single orbit is below -1 here
        assert float(orbit.parameters["sigma"]) > flip.value


def test_halves_differ_by_the_root_of_the_distance():
    flip = branch().events[-1]
    assert doubled().ends[0] == "it meets the branch that it doubles"
    meeting = doubled().events[0]
    assert meeting.kind == "branch-point"
    assert meeting.value == pytest.approx(flip.value, abs=1e-8)
    distance = doubled().parameter_values - flip.value
    halves = doubled().quantity("tau1") - doubled().quantity("tau2")
    near = (distance > 1e-5) & (distance < 1e-3)
    assert np.count_nonzero(near) >= 2
    np.testing.assert_allclose(
        halves[near] ** 2 / distance[near], (halves**2 / distance)[near][0], rtol=0.05
    )


@pytest.mark.slow
def test_a_cascade():
    orbit = doubled().switch(flip_of_doubled())
    assert len(orbit.itinerary) == 4
    assert orbit.period == pytest.approx(4 * branch().period[0], rel=1e-9)
    dwell = orbit.dwell_times
    assert min(abs(dwell[:2] - dwell[2:])) > 1e-5
    for step in (0.05, 0.1):  # a long one leads over to the branch that is doubled
        four = nonsmooth.continue_orbit(orbit, "sigma", (-0.04, -0.02), step=step)
        meeting = next(event for event in four.events if event.kind == "branch-point")
        assert meeting.value == pytest.approx(flip_of_doubled().value, abs=1e-8)


def test_a_crossing_branch_has_the_other_root():
    """Impact speeds of both orbits solve one quadratic equation."""
    known = pair("fold", 0, 0.02)
    (crossing,) = known.events
    other = known.switch(crossing)
    q = float(other.parameters["q"])
    place = float(other.parameters["place"]) + q * q
    cotangent, gain = 1 / math.tan(math.pi / W), 1 / (1 - W * W)
    linear, quadratic = (1 + R) * cotangent / 2, (1 - R) / (2 * W)
    speeds = np.roots([linear**2 + quadratic**2, 2 * place * linear, place**2 - gain**2])
    mine = float(np.interp(q, known.parameter_values, -known.quantity("v0") / R))
    its = -float(other.states[0][1]) / R
    nearest = speeds[np.argsort(abs(speeds - mine))]
    assert abs(nearest[0] - mine) < abs(nearest[1] - mine) / 10
    assert its == pytest.approx(nearest[1].real, abs=1e-9)


def test_a_lost_symmetry_is_that_of_a_simulation():
    found, events = broken()
    checked = 0
    for event in events:
        orbit = found.switch(event)
        assert orbit.symmetry is None
        first, second = orbit.dwell_times
        assert abs(first - second) > 1e-4
        if orbit.stability.verdict != "stable" or orbit.admissibility.verdict is not True:
            continue
        dwell = dwell_times_of_motions(stops(), orbit)
        np.testing.assert_allclose(dwell, np.sort([first, second]), atol=1e-9)
        checked += 1
    assert checked


def test_an_orbit_with_kernels():
    orbit = nonsmooth.solve(SYMMETRIC, {"us2": "0.5", "ur2": 1})
    found = nonsmooth.continue_orbit(orbit, "V", (0.6, 1.3))
    flip = found.events[-1]
    assert found.switch(flip).parameters["ur1"].text == "1"
    with pytest.raises(nonsmooth.InputError, match="unknown parameter 'u'"):
        found.switch(flip, {"u": 1})
    twice = found.switch(flip, {"us1": "0.0127", "ur1": "0.0255"})
    assert len(twice.itinerary) == 4
    assert abs(twice.dwell_times[0] - twice.dwell_times[2]) > 1e-4
    check_closed("dry-friction", twice)


def test_a_conservative_orbit():
    found = nonsmooth.continue_orbit(nonsmooth.solve("rigid-stop/one-impact"), "T", (5, 6.5))
    first, second = found.events
    twice = found.switch(first)
    assert twice.period == pytest.approx(2 * first.value, abs=1e-3)
    assert abs(twice.dwell_times[0] - twice.dwell_times[1]) > 1e-3
    check_closed("rigid-stop", twice)
    # at the other one all doubled orbits have the same period
    with pytest.raises(nonsmooth.NoConvergence, match="one value of period only"):
        found.switch(second)


@pytest.mark.slow
def test_a_doubled_orbit_ends_where_another_one_grazes():
    """Its shortest phase vanishes as the root of the distance: a singular end."""
    page = PAGE.with_name("piecewise_stiffness.py")
    single = nonsmooth.continue_orbit(nonsmooth.solve(f"{page}:one-contact"), "w", (2.2, 2.5))
    (flip,) = single.events
    twice = nonsmooth.continue_orbit(single.switch(flip), "w", (2.2, 2.75), step=0.03)
    assert twice.ends[0] == "it meets the branch that it doubles"
    assert twice.ends[1].endswith("goes to zero")
    known = nonsmooth.solve(f"{page}:doubled")
    w = float(known.given["w"])
    dwell = twice.unknowns[:, :4]
    near = [np.interp(w, twice.parameter_values, column) for column in dwell.T]
    again = nonsmooth.solve(known.system, known.parameters, near, itinerary=twice.orbit.itinerary)
    np.testing.assert_allclose(
        np.sort(again.dwell_times), np.sort(list(known.dwell_times)), atol=1e-9
    )
    other = nonsmooth.continue_orbit(
        nonsmooth.solve(f"{page}:subharmonic"), "w", (2.5, 3.01), step=0.03
    )
    (grazing,) = (event for event in other.events if event.kind == "grazing")
    end = twice.events[-1]
    assert (end.kind, end.value) == ("vanishing-phase", pytest.approx(grazing.value, abs=1e-9))


def test_wrong_input():
    grazing = next(event for event in branch().events if event.kind == "grazing")
    with pytest.raises(nonsmooth.InputError, match="no other branch meets this one at a grazing"):
        branch().switch(grazing)
    touched = pair("flip", 0)
    with pytest.raises(nonsmooth.InputError, match="touched and not passed"):
        touched.switch(touched.events[0])
